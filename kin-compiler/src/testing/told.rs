//! What an expansion tells the user.

use proc_macro2::{Span, TokenStream, TokenTree};

use crate::expand::expand;

/// A message of the macro.
pub(crate) struct Told {
    pub(crate) message: String,
    /// From the first to the last token at fault, as the compiler joins them, if both come from one text.
    pub(crate) place: Span,
}

/// The mistakes that the expansion of a declaration reports.
pub(crate) fn told(declaration: TokenStream) -> Vec<Told> {
    let mut found = Vec::new();
    let mut open = vec![expand(declaration).into_iter()];
    let mut first = None;
    while let Some(innermost) = open.last_mut() {
        match innermost.next() {
            None => drop(open.pop()),
            Some(TokenTree::Group(group)) => open.push(group.stream().into_iter()),
            // the first mistake is repeated in a type
            Some(TokenTree::Ident(word)) if word == "unexpanded" => drop(innermost.nth(1)),
            Some(TokenTree::Ident(word)) => first = (word == "compile_error").then(|| word.span()),
            Some(TokenTree::Literal(text)) => {
                if let Some(first) = first.take() {
                    let place = first.join(text.span()).unwrap_or(first);
                    let text: syn::LitStr = syn::parse2(TokenTree::from(text).into()).expect("messages are text");
                    found.push(Told {
                        message: text.value(),
                        place,
                    });
                }
            }
            Some(TokenTree::Punct(_)) => {}
        }
    }
    found
}
