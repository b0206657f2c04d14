//! The `mechanism!` macro of kin: loop closures in, motion out.
//!
//! This crate is the macro's machinery. Use it through `kin_core::mechanism!`, which is documented there with examples.
//!
//! `docs/grammar.md` in the repository has the grammar, and `docs/macro.md` shows how the passes below follow each other.

mod algebra;
mod assemble;
mod bug;
mod derive;
mod editor;
mod emit;
mod expand;
mod fallback;
mod formulas;
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
mod translate;
mod work;

/// Expands a declaration of `mechanism!`, after the path of `kin_core` in parentheses.
#[doc(hidden)]
#[proc_macro]
pub fn mechanism_in(tokens: proc_macro::TokenStream) -> proc_macro::TokenStream {
    bug::expand_or_tell(tokens.into()).into()
}
