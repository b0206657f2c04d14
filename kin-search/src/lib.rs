//! Searches of mechanisms by their dimensions.
//!
//! | Room | Holds |
//! |---|---|
//! | `candidates` | dimensions from an id, by a low-discrepancy sequence |
//! | `function` | kin's solvers as functions of SQL |
//! | `session` | a session of queries: its functions, its memory, its files, its end |
//! | `cluster` | the same queries on several machines |
//! | `pages` | pages of refined candidates, and of the rows of a query |
//! | `program` | what is typed in a terminal |
//! | `say` | messages on the standard error stream |

#[cfg(feature = "sql")]
pub mod candidates;
#[cfg(feature = "cluster")]
pub mod cluster;
#[cfg(feature = "sql")]
mod digest;
#[cfg(feature = "sql")]
pub mod function;
#[cfg(feature = "refine")]
pub mod pages;
#[cfg(feature = "sql")]
mod say;
#[cfg(feature = "sql")]
pub mod session;

#[cfg(feature = "sql")]
pub use function::{DeclarationError, Functions, Owner, functions, register};
#[cfg(feature = "sql")]
pub use say::say;
#[cfg(feature = "sql")]
pub use session::{Options, session};
