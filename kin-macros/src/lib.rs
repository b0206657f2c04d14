//! The `mechanism!` macro of kin: loop closures in, motion out.
//!
//! Use it through `kin_core::mechanism!`, which is documented there with examples. The macro's machinery is the library
//! `kin-compiler`.

/// Expands a declaration of `mechanism!`, after the path of `kin_core` in parentheses.
#[doc(hidden)]
#[proc_macro]
pub fn mechanism_in(tokens: proc_macro::TokenStream) -> proc_macro::TokenStream {
    kin_compiler::expand_or_tell(tokens.into()).into()
}
