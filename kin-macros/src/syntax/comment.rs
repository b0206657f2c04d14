//! Comments of other languages, which begin with `#`. Their words are prose, and every further mistake would only follow
//! from them.

use proc_macro2::{Delimiter, Group, Span, TokenStream, TokenTree};

/// The place of the first `#` that begins no attribute, and the tokens without such marks. `None` if there is none.
pub(super) fn without_mark(tokens: &TokenStream) -> Option<(Span, TokenStream)> {
    let mut first = None;
    let rest = strip(tokens.clone(), &mut first);
    first.map(|mark| (mark, rest))
}

fn strip(tokens: TokenStream, first: &mut Option<Span>) -> TokenStream {
    let mut tokens = tokens.into_iter().peekable();
    let mut kept = Vec::new();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(mark) if mark.as_char() == '#' && !tokens.peek().is_some_and(continues_attribute) => {
                first.get_or_insert(mark.span());
            }
            TokenTree::Group(group) => {
                let mut inner = Group::new(group.delimiter(), strip(group.stream(), first));
                inner.set_span(group.span());
                kept.push(TokenTree::Group(inner));
            }
            token => kept.push(token),
        }
    }
    kept.into_iter().collect()
}

/// Whether a token may follow the `#` of an attribute.
fn continues_attribute(token: &TokenTree) -> bool {
    match token {
        TokenTree::Group(group) => group.delimiter() == Delimiter::Bracket,
        TokenTree::Punct(punct) => punct.as_char() == '!',
        TokenTree::Ident(_) | TokenTree::Literal(_) => false,
    }
}
