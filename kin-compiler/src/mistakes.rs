//! The mistakes of one declaration, collected so that all of them are reported at once.
//!
//! Every message begins in lower case with the mistake and ends with the remedy.

use std::collections::BTreeSet;
use std::fmt::Display;

use proc_macro2::{Punct, Spacing, Span, TokenStream, TokenTree};
use quote::{ToTokens, TokenStreamExt};

use crate::work;

/// Collected mistakes, each with its position in the source.
///
/// Mistakes must not be dropped before they are reported, because a wrong declaration would then compile.
#[derive(Default)]
pub(crate) struct Mistakes {
    errors: Vec<syn::Error>,
    /// Statements that are read several times.
    repeated: Vec<TokenStream>,
}

impl Mistakes {
    pub(crate) fn new() -> Self {
        Self::default()
    }

    /// Adds a mistake that is underlined from the first to the last token of `at`.
    pub(crate) fn error(&mut self, at: impl ToTokens, message: impl Display) {
        self.push(syn::Error::new_spanned(at, message));
    }

    /// Adds a mistake at one position.
    pub(crate) fn error_at(&mut self, span: Span, message: impl Display) {
        self.push(syn::Error::new(span, message));
    }

    pub(crate) fn push(&mut self, error: syn::Error) {
        self.errors.push(error);
    }

    /// Reports one mistake at each position within statements that are read several times.
    pub(crate) fn tell_once_within(&mut self, tokens: &TokenStream) {
        self.repeated.push(tokens.clone());
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// Drops the mistakes, because a reported one explains them.
    pub(crate) fn forget(mut self) {
        self.errors.clear();
    }

    /// One `compile_error!` for each mistake, in the order in which they were found.
    pub(crate) fn into_compile_errors(self) -> TokenStream {
        self.into_each_compile_error().into_iter().collect()
    }

    /// The same errors, one by one.
    pub(crate) fn into_each_compile_error(self) -> Vec<TokenStream> {
        self.into_errors().map(|error| error.to_compile_error()).collect()
    }

    /// The mistakes, one by one.
    pub(crate) fn into_errors(mut self) -> impl Iterator<Item = syn::Error> {
        let mut repeated = BTreeSet::new();
        for tokens in &self.repeated {
            add_positions(tokens, &mut repeated);
        }
        let mut reported = BTreeSet::new();
        let errors = std::mem::take(&mut self.errors).into_iter().flatten();
        errors.filter(move |error| {
            if repeated.is_empty() {
                return true;
            }
            let mut marked = error.to_compile_error().into_iter();
            let first = marked.next().map(|token| position(token.span()));
            let last = marked.last().map(|token| position(token.span()));
            let is_repeated = first.as_ref().is_some_and(|first| repeated.contains(first));
            !is_repeated || reported.insert((first, last))
        })
    }

    /// The messages alone, for tests.
    #[cfg(test)]
    pub(crate) fn into_messages(self) -> Vec<String> {
        self.into_errors().map(|error| error.to_string()).collect()
    }
}

/// A position in the source. The compiler gives lines and columns to no macro of stable Rust, but positions can be
/// compared.
fn position(span: Span) -> String {
    format!("{span:?}")
}

/// Adds the positions of all tokens.
fn add_positions(tokens: &TokenStream, all: &mut BTreeSet<String>) {
    for token in tokens.clone() {
        if let TokenTree::Group(group) = &token {
            all.extend([group.span_open(), group.span_close()].map(position));
            add_positions(&group.stream(), all);
        }
        all.insert(position(token.span()));
    }
}

impl Drop for Mistakes {
    fn drop(&mut self) {
        debug_assert!(
            self.errors.is_empty() || std::thread::panicking(),
            "mistakes were collected but never shown"
        );
    }
}

/// The stretch of source from one token to another, to underline.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    pub(crate) first: Span,
    pub(crate) last: Span,
}

impl Extent {
    pub(crate) fn at(span: Span) -> Self {
        Self {
            first: span,
            last: span,
        }
    }

    pub(crate) fn to(self, end: Self) -> Self {
        Self {
            first: self.first,
            last: end.last,
        }
    }
}

impl ToTokens for Extent {
    /// Two tokens that exist only for their positions. Stable Rust cannot join spans, but an error spans from its first
    /// token to its last.
    fn to_tokens(&self, tokens: &mut TokenStream) {
        for span in [self.first, self.last] {
            let mut mark = Punct::new('.', Spacing::Alone);
            mark.set_span(span);
            tokens.append(mark);
        }
    }
}

/// The candidate that was probably meant by `word`: it differs in case only, or in one or two letters.
pub(crate) fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = word.chars().count();
    let allowed = if length < 4 { 1 } else { 2 };
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        let other = candidate.chars().count();
        if other.abs_diff(length) > allowed || work::is_spent() {
            continue;
        }
        work::iterations(length * other);
        let distance = if word.eq_ignore_ascii_case(candidate) {
            0
        } else {
            // a letter inserted, removed, replaced, or swapped with its neighbour is one mistake
            strsim::osa_distance(word, candidate)
        };
        if distance <= allowed && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// `; did you mean …?`, or nothing.
pub(crate) fn suggestion<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> String {
    nearest(word, candidates)
        .map(|near| format!("; did you mean `{near}`?"))
        .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_near_name_is_found_and_a_far_one_is_not() {
        let names = ["theta3", "theta4", "r1", "PI"];
        assert_eq!(nearest("thetta3", names), Some("theta3"));
        assert_eq!(nearest("htea4", names), Some("theta4"));
        assert_eq!(nearest("pi", names), Some("PI"));
        // letters that are swapped are one mistake
        assert_eq!(nearest("1r", names), Some("r1"));
        assert_eq!(nearest("r7", names), Some("r1"));
        assert_eq!(nearest("q7", names), None);
        assert_eq!(nearest("coupler", names), None);
    }

    #[test]
    fn every_mistake_becomes_an_error() {
        let mut mistakes = Mistakes::new();
        assert!(mistakes.is_empty());
        mistakes.error_at(Span::call_site(), "one");
        mistakes.error(Extent::at(Span::call_site()), "two");
        let errors = mistakes.into_compile_errors().to_string();
        assert_eq!(errors.matches("compile_error").count(), 2);
    }

    #[test]
    #[cfg(debug_assertions)]
    #[should_panic(expected = "never shown")]
    fn mistakes_are_not_dropped_unread() {
        Mistakes::new().error_at(Span::call_site(), "unseen");
    }
}
