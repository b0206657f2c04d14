//! The visible side of kin: drawings of mechanisms, and the figures of the book.
//!
//! [`drawing`] draws the skeleton of any mechanism. [`figures`] are the pictures that stand in the book; one command draws them again:
//!
//! ```sh
//! cargo run -p kin-studio --example figures
//! ```

pub mod drawing;
pub mod figures;
