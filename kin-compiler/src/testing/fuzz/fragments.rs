//! Groups without delimiters, which fragments of other macros leave.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use kin_declarations::Random;

/// The same tokens, with some runs of them in groups without delimiters, which may begin and end anywhere.
pub(super) fn with_fragments(random: &mut Random, tokens: TokenStream) -> TokenStream {
    let mut tokens = tokens.into_iter().peekable();
    let mut grouped = TokenStream::new();
    while let Some(token) = tokens.next() {
        let token = within(random, token);
        if random.below(12) > 0 || is_separator(&token) {
            grouped.extend([token]);
            continue;
        }
        let mut run = TokenStream::from(token);
        for _ in 0..random.below(6) {
            match tokens.next_if(|token| !is_separator(token)) {
                Some(token) => run.extend([within(random, token)]),
                None => break,
            }
        }
        grouped.extend([TokenTree::Group(Group::new(Delimiter::None, run))]);
    }
    grouped
}

fn within(random: &mut Random, token: TokenTree) -> TokenTree {
    match token {
        TokenTree::Group(group) => {
            let inner = with_fragments(random, group.stream());
            TokenTree::Group(Group::new(group.delimiter(), inner))
        }
        token => token,
    }
}

/// The same tokens, with some of the numbers and parenthesised formulas in groups without delimiters, like literals and
/// expressions from other macros. The meaning of the declaration stays the same.
pub(super) fn with_operands_as_fragments(random: &mut Random, tokens: TokenStream) -> TokenStream {
    let mut grouped = TokenStream::new();
    let mut is_called = false;
    for token in tokens {
        let is_operand = match &token {
            TokenTree::Literal(number) => number.to_string().starts_with(|first: char| first.is_ascii_digit()),
            TokenTree::Group(group) => group.delimiter() == Delimiter::Parenthesis && !is_called,
            _ => false,
        };
        is_called = matches!(token, TokenTree::Ident(_));
        let token = match token {
            // an attribute does not belong to the declaration language
            TokenTree::Group(group) if group.delimiter() != Delimiter::Bracket => {
                let inner = with_operands_as_fragments(random, group.stream());
                TokenTree::Group(Group::new(group.delimiter(), inner))
            }
            token => token,
        };
        grouped.extend([if is_operand && random.below(3) == 0 {
            TokenTree::Group(Group::new(Delimiter::None, token.into()))
        } else {
            token
        }]);
    }
    grouped
}

fn is_separator(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Punct(sign) if matches!(sign.as_char(), ';' | ','))
}

#[test]
fn fragments_are_not_seen() {
    let text = "struct M { a : Length } input t : Angle ; unknown u : Length ; 2 * u == (a - u) * cos (t) ;";
    let tokens: TokenStream = text.parse().expect("these are tokens");
    for groups in [with_fragments, with_operands_as_fragments] {
        let mut has_groups = false;
        for seed in 0..50 {
            let grouped = groups(&mut Random::new(seed), tokens.clone());
            has_groups |= grouped
                .clone()
                .into_iter()
                .any(|token| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::None));
            let words = |tokens: &TokenStream| tokens.to_string().split_whitespace().collect::<String>();
            assert_eq!(words(&grouped), words(&tokens));
        }
        assert!(has_groups);
    }
}
