//! The output of kin for people: pages on which mechanisms move, drawings, files of tables, and the figures of the
//! book.
//!
//! [`report()`] makes a page of any mechanism. [`drawing`] draws its skeleton. [`library`] leads through all mechanisms
//! of the library, each with dimensions. [`tables`] writes the table of a sweep as CSV or JSON. [`figures`] are the
//! pictures that stand in the book; one command draws them again:
//!
//! ```sh
//! cargo run -p kin-studio --features gallery --example figures
//! ```

#[cfg(feature = "case")]
#[cfg_attr(
    not(feature = "program"),
    allow(dead_code, unused_imports, reason = "the program asks more of a case")
)]
pub mod case;
pub mod drawing;
#[cfg(feature = "gallery")]
pub mod figures;
#[cfg(feature = "file")]
pub mod file;
mod forces;
#[cfg(any(feature = "gallery", feature = "file"))]
pub mod library;
mod names;
#[cfg(feature = "program")]
pub mod program;
pub mod report;
pub mod tables;

#[cfg(feature = "program")]
pub use program::main;
pub use report::report;
