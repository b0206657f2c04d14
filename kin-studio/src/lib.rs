//! What kin shows to people: drawings of mechanisms, files of tables, and the figures of the book.
//!
//! [`drawing`] draws the skeleton of any mechanism. [`tables`] writes the table of a sweep as CSV or JSON. [`figures`] are the pictures that stand in the book; one command draws them again:
//!
//! ```sh
//! cargo run -p kin-studio --example figures
//! ```

pub mod drawing;
pub mod figures;
pub mod tables;
