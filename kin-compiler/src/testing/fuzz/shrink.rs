//! Smaller declarations with the same defect.

use proc_macro2::{Group, TokenStream, TokenTree};

/// The number of smaller declarations that are tried.
const TRIALS: usize = 400;

/// A smaller declaration with the same defect. First statements and then tokens are left out, until none can be left
/// out or the trials are used up.
pub(super) fn shrink(declaration: &str, has_defect: impl Fn(&str) -> bool) -> String {
    let Ok(tokens) = declaration.parse::<TokenStream>() else {
        return declaration.to_owned();
    };
    let mut trials = 0;
    let mut least = tokens;
    for candidates in [without_a_statement, without_a_token] {
        let mut index = 0;
        // start again, because an earlier token may be superfluous after a later one is left out
        let mut has_shrunk = false;
        loop {
            let smaller = candidates(&least, index);
            match smaller {
                Some(smaller) if trials < TRIALS => {
                    trials += 1;
                    if has_defect(&smaller.to_string()) {
                        least = smaller;
                        has_shrunk = true;
                    } else {
                        index += 1;
                    }
                }
                None if has_shrunk && trials < TRIALS => (index, has_shrunk) = (0, false),
                _ => break,
            }
        }
    }
    least.to_string()
}

/// The declaration without its n-th statement, counted by semicolons.
fn without_a_statement(tokens: &TokenStream, n: usize) -> Option<TokenStream> {
    let is_end = |token: &TokenTree| match token {
        TokenTree::Punct(sign) => sign.as_char() == ';',
        TokenTree::Group(group) => group.delimiter() == proc_macro2::Delimiter::Brace,
        _ => false,
    };
    let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
    let statements: Vec<&[TokenTree]> = tokens.split_inclusive(is_end).collect();
    if n >= statements.len() {
        return None;
    }
    let kept = statements.iter().enumerate().filter(|&(index, _)| index != n);
    Some(kept.flat_map(|(_, statement)| statement.iter().cloned()).collect())
}

/// The declaration without its n-th token or whole group. Further indices replace a group by its contents.
fn without_a_token(tokens: &TokenStream, n: usize) -> Option<TokenStream> {
    let mut countdown = n;
    changed(tokens, &mut countdown, &|_| Some(TokenStream::new())).or_else(|| {
        changed(tokens, &mut countdown, &|token| match token {
            TokenTree::Group(group) => Some(group.stream()),
            _ => None,
        })
    })
}

/// The declaration with one token replaced, chosen by counting down those that have a replacement.
fn changed(
    tokens: &TokenStream,
    countdown: &mut usize,
    replacement: &dyn Fn(&TokenTree) -> Option<TokenStream>,
) -> Option<TokenStream> {
    let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
    for (index, token) in tokens.iter().enumerate() {
        let other = replacement(token);
        let instead = if other.is_some() && *countdown == 0 {
            other
        } else {
            *countdown -= usize::from(other.is_some());
            match token {
                TokenTree::Group(group) => changed(&group.stream(), countdown, replacement)
                    .map(|inner| TokenTree::Group(Group::new(group.delimiter(), inner)).into()),
                _ => None,
            }
        };
        if let Some(instead) = instead {
            let mut all: TokenStream = tokens[..index].iter().cloned().collect();
            all.extend(instead);
            all.extend(tokens[index + 1..].iter().cloned());
            return Some(all);
        }
    }
    None
}

#[test]
fn what_is_not_needed_is_left_out() {
    let text =
        "struct M { a: Length, b: Length } input t: Angle; let l = a * (b + sin((t))); unknown u: Length; u == l;";
    let shrunk = shrink(text, |text| text.contains("sin") && text.contains("struct"));
    assert_eq!(shrunk, "struct sin");
}
