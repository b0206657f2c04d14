//! The compiler of kin, from the declaration of a mechanism to its solvers.
//!
//! The macro `kin_core::mechanism!` is a shell around this library. A program that holds a declaration as text compiles
//! it by [`Declaration::parse`], without rustc (feature `text`).
//!
//! `docs/grammar.md` in the repository has the grammar, and `docs/macro.md` shows how the passes below follow each
//! other.

mod algebra;
mod assemble;
#[cfg(feature = "text")]
mod budget;
mod bug;
mod derive;
mod describe;
mod editor;
mod emit;
mod expand;
mod fallback;
mod formulas;
mod lower;
mod mistakes;
mod model;
mod passes;
mod plan;
mod precedence;
mod program;
mod refuse;
mod room;
mod schedule;
mod structure;
mod syntax;
#[cfg(test)]
mod testing;
#[cfg(feature = "text")]
mod text;
mod translate;
mod work;

#[doc(hidden)]
pub use algebra::Function;
#[doc(hidden)]
pub use bug::expand_or_tell;
#[doc(hidden)]
pub use formulas::{Formula, Formulas};
/// Programs as data, for kin-live.
#[doc(hidden)]
pub mod lowered {
    pub use crate::algebra::Symbol;
    pub use crate::describe::{DescribedBlock, DescribedQuantity, Description};
    pub use crate::lower::{
        Argument, Closure, ClosureTerm, Decisive, EveryPosition, Form, Label, Mechanism, Range, Routine, Selection,
        Statement, UnitVector, Value,
    };
    pub use crate::program::{Component, Returns};
    pub use crate::structure::{BlockKind, PolynomialTerm, SystemForm};
}
#[cfg(feature = "text")]
pub use budget::{Budget, Refusal, Resource, TooLarge};
pub use syntax::Dimension;
#[doc(hidden)]
pub use syntax::{Axis, ValueShape};
#[cfg(feature = "text")]
pub use text::{Declaration, Mistake, Position, Quantity, fault_and_advice, function_names, name_mistake};
#[doc(hidden)]
pub use translate::tree;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
