//! Comments of other languages, which begin with `#`. Their words are prose, and every further mistake would only
//! follow from them.

use proc_macro2::{Delimiter, Group, Span, TokenStream, TokenTree};

/// The position of the first `#` that begins no attribute, and the tokens without such marks. `None` if there is none.
pub(super) fn without_mark(tokens: &TokenStream) -> Option<(Span, TokenStream)> {
    first_mark(tokens).map(|mark| (mark, strip(tokens)))
}

fn first_mark(tokens: &TokenStream) -> Option<Span> {
    let mut tokens = tokens.clone().into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Group(group) => {
                let inner = first_mark(&group.stream());
                if inner.is_some() {
                    return inner;
                }
            }
            token if is_mark(&token, tokens.peek()) => return Some(token.span()),
            _ => {}
        }
    }
    None
}

fn strip(tokens: &TokenStream) -> TokenStream {
    let mut tokens = tokens.clone().into_iter().peekable();
    let mut kept = Vec::new();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Group(group) => {
                let mut inner = Group::new(group.delimiter(), strip(&group.stream()));
                inner.set_span(group.span());
                kept.push(TokenTree::Group(inner));
            }
            token if is_mark(&token, tokens.peek()) => {}
            token => kept.push(token),
        }
    }
    kept.into_iter().collect()
}

fn is_mark(token: &TokenTree, next: Option<&TokenTree>) -> bool {
    matches!(token, TokenTree::Punct(mark) if mark.as_char() == '#') && !next.is_some_and(continues_attribute)
}

/// Whether a token may follow the `#` of an attribute.
fn continues_attribute(token: &TokenTree) -> bool {
    match token {
        TokenTree::Group(group) => group.delimiter() == Delimiter::Bracket,
        TokenTree::Punct(punct) => punct.as_char() == '!',
        TokenTree::Ident(_) | TokenTree::Literal(_) => false,
    }
}
