//! kin in a browser: one function that answers questions about the text of a `.kin` file.
//!
//! Questions and answers are JSON. The page sends them to a worker, which runs this crate as WebAssembly.
//!
//! ```
//! let text = r"kin 1\nstruct A{r:Length} input x:Length;unknown y:Length; y==r+x;";
//! let question = format!(r#"{{ "ask": "format", "text": "{text}" }}"#);
//! assert!(kin_web::answer(&question).contains("struct A { r: Length }"));
//! ```

mod border;
mod examples;
mod question;

pub use question::{Answer, Question, answer};
