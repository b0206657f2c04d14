//! The largest depth of nesting in a declaration.
//!
//! Formulas are read, checked and written by recursion on the compiler's stack, so their depth has to be limited. The
//! depth of groups of tokens is checked first, because even reading tokens descends into every group.

use proc_macro2::{Group, Span, TokenStream, TokenTree};

use crate::mistakes::Mistakes;

/// The largest depth of nested parentheses, functions and signs.
pub(super) const DEEPEST: usize = 256;

/// The message for formulas that are nested deeper.
pub(super) fn message() -> String {
    format!("this is nested more than {DEEPEST} deep: name an inner part of it by a `let`")
}

/// Empties every group that is too deep, and reports the first one in each statement.
pub(super) fn cut(tokens: TokenStream, mistakes: &mut Mistakes) -> TokenStream {
    let too_deep = too_deep(&tokens);
    if too_deep.is_empty() {
        return tokens;
    }
    for span in too_deep {
        mistakes.error_at(span, message());
    }
    emptied(tokens, 0)
}

/// Whether a group among the tokens of a statement has been emptied.
pub(super) fn is_cut(tokens: &TokenStream) -> bool {
    !too_deep(tokens).is_empty()
}

/// The groups that are too deep, the first in each statement.
fn too_deep(tokens: &TokenStream) -> Vec<Span> {
    let mut found = Vec::new();
    let mut is_found = false;
    let mut unfinished = vec![tokens.clone().into_iter()];
    while let Some(innermost) = unfinished.last_mut() {
        match innermost.next() {
            None => drop(unfinished.pop()),
            Some(TokenTree::Group(group)) if unfinished.len() <= DEEPEST => unfinished.push(group.stream().into_iter()),
            Some(TokenTree::Group(group)) => {
                if !is_found {
                    found.push(group.span_open());
                }
                is_found = true;
            }
            Some(TokenTree::Punct(end)) if end.as_char() == ';' && unfinished.len() == 1 => is_found = false,
            Some(_) => {}
        }
    }
    found
}

/// The same tokens without the contents of groups that are too deep.
fn emptied(tokens: TokenStream, depth: usize) -> TokenStream {
    tokens
        .into_iter()
        .map(|token| match token {
            TokenTree::Group(group) => {
                let inner = if depth < DEEPEST {
                    emptied(group.stream(), depth + 1)
                } else {
                    TokenStream::new()
                };
                let mut shallow = Group::new(group.delimiter(), inner);
                shallow.set_span(group.span());
                TokenTree::Group(shallow)
            }
            token => token,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use proc_macro2::Delimiter;
    use quote::quote;

    use super::*;
    use crate::syntax;

    /// The messages about a formula in a declaration.
    fn mistakes(formula: &TokenStream) -> Vec<String> {
        let mut mistakes = Mistakes::new();
        syntax::parse(
            quote! {
                struct M { a: Length }
                let v = #formula;
                a = 1;
            },
            &mut mistakes,
        );
        let mut messages = mistakes.into_messages();
        assert!(messages.pop().is_some_and(|last| last.contains("no assignments")));
        messages
    }

    fn parenthesised(depth: usize) -> TokenStream {
        (0..depth).fold(quote!(a), |inner, _| {
            TokenTree::Group(Group::new(Delimiter::Parenthesis, inner)).into()
        })
    }

    #[test]
    fn the_depth_has_an_end_that_is_reported_once() {
        let signs = |count: usize| {
            let signs = vec![quote!(-); count];
            quote!(#(#signs)* a)
        };
        let methods = |count: usize| {
            let methods = vec![quote!(.sin()); count];
            quote!(a #(#methods)*)
        };
        for formula in [parenthesised, signs, methods] {
            assert_eq!(mistakes(&formula(DEEPEST)), Vec::<String>::new());
            assert_eq!(mistakes(&formula(DEEPEST + 1)), [message()]);
            assert_eq!(mistakes(&formula(100 * DEEPEST)), [message()]);
        }
        let (left, right) = (parenthesised(DEEPEST), parenthesised(DEEPEST));
        assert_eq!(mistakes(&quote!((#left) + (#right))), [message()]);
    }

    /// A long formula is not a deep one.
    #[test]
    fn sums_and_products_are_as_long_as_they_like() {
        for operator in [quote!(+), quote!(*)] {
            let rest = vec![quote!(#operator a); 100 * DEEPEST];
            assert_eq!(mistakes(&quote!(a #(#rest)*)), Vec::<String>::new());
        }
    }
}
