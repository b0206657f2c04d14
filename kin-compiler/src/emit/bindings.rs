//! Local names, kept apart from the items around a declaration.
//!
//! A name in a pattern is a new variable, unless a constant, a static or a variant of an enumeration with this name is
//! in scope where the macro is used. Then the name means that item, whatever hygiene says. A function of the same name
//! does no harm, and the nearest item counts. So every local name is first imported as a function, within the scope of
//! the expansion.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use quote::quote;

use super::local;
use crate::syntax::is_keyword;

/// The import that makes every name in the patterns of `items` a new variable.
pub(super) fn imports(items: TokenStream, runtime: &TokenStream) -> TokenStream {
    let mut names = BTreeSet::new();
    collect(items, Delimiter::None, &mut names);
    let names = names.iter().map(|name| local(name));
    quote! {
        #runtime::locals! { #(#names),* }
    }
}

/// Adds the names that a pattern may bind. Arguments and fields of expressions look the same; adding them does no harm.
fn collect(tokens: TokenStream, around: Delimiter, names: &mut BTreeSet<String>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let in_braces = around == Delimiter::Brace;
    for (index, token) in tokens.iter().enumerate() {
        let before = index.checked_sub(1).map(|index| &tokens[index]);
        let after = tokens.get(index + 1);
        match token {
            // attributes bind nothing
            TokenTree::Group(_) if is_one_of(before, "#") => {}
            TokenTree::Group(group) => collect(group.stream(), group.delimiter(), names),
            TokenTree::Ident(word) => {
                let is_marked = matches!(before, Some(TokenTree::Ident(word)) if word == "let" || word == "mut");
                let is_in_path = is_one_of(before, ":") && is_joint(index.checked_sub(2).map(|index| &tokens[index]))
                    || is_one_of(after, ":") && is_joint(after);
                // a name before a colon is a field within braces, and a name after a colon elsewhere is a type
                let begins = is_marked || before.is_none() || is_one_of(before, if in_braces { ",|:&" } else { ",|&" });
                let is_typed = is_marked || !in_braces || is_one_of(before, "|");
                let ends = after.is_none() || is_one_of(after, if is_typed { ",=|:" } else { ",=|" });
                if begins && ends && !is_in_path && word != "_" && !is_keyword(&word.to_string()) {
                    names.insert(word.to_string());
                }
            }
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}

/// Whether a token is one of these characters.
fn is_one_of(token: Option<&TokenTree>, characters: &str) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if characters.contains(punct.as_char()))
}

/// Whether a token is the first half of an operator such as `::`.
fn is_joint(token: Option<&TokenTree>) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.spacing() == Spacing::Joint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_in_patterns_are_found() {
        let items = quote! {
            #[inline(always)]
            impl<T: kin::Scalar> Lever<T> {
                fn solve(&self, theta: T, mut near: [T; 2]) -> Result<Total<T>, kin::Error> {
                    let x = 3;
                    let (sine, _) = theta.sin_cos();
                    let [first, second] = near.map(|angle| angle + x);
                    let kin::Plane { x: along, y: kin::Root { value, .. } } =
                        kin::plane(|[one, other]: [T; 2]| self.both(one));
                    match choice {
                        kin::Open => first,
                        decided => decided,
                    }
                }
            }
        };
        let mut names = BTreeSet::new();
        collect(items, Delimiter::None, &mut names);
        for name in [
            "theta", "near", "x", "sine", "first", "second", "angle", "along", "value", "one", "other", "decided",
        ] {
            assert!(names.contains(name), "{name} in {names:?}");
        }
        for name in ["self", "kin", "always", "Plane", "Lever", "solve", "_", "y"] {
            assert!(!names.contains(name), "{name} in {names:?}");
        }
    }
}
