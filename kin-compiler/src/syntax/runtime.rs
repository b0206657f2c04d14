//! The path that stands before a declaration.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::quote;

/// The path to the items that generated code calls, and the declaration after it. `mechanism!` passes its crate by
/// the name under which the user knows it.
pub(crate) fn runtime(tokens: TokenStream) -> (TokenStream, TokenStream) {
    let mut tokens = tokens.into_iter().peekable();
    let is_path = |token: &TokenTree| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis => names_an_item(group.stream()),
        _ => false,
    };
    let runtime = if let Some(TokenTree::Group(path)) = tokens.next_if(is_path) {
        let path = path.stream();
        quote!(#path::__private)
    } else {
        quote!(::kin_core::__private)
    };
    (runtime, tokens.collect())
}

/// Whether tokens may be a path: names, colons, and the `$` of the name of a crate.
fn names_an_item(tokens: TokenStream) -> bool {
    !tokens.is_empty()
        && tokens.into_iter().all(|token| match token {
            TokenTree::Ident(_) => true,
            TokenTree::Punct(punct) => matches!(punct.as_char(), ':' | '$'),
            TokenTree::Group(group) => group.delimiter() == Delimiter::None && names_an_item(group.stream()),
            TokenTree::Literal(_) => false,
        })
}
