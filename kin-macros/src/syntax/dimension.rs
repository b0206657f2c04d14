//! The five words that say what a quantity is.

use proc_macro2::{Ident, TokenTree};
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};

use crate::report::suggestion;

/// What a quantity was declared to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dimension {
    Length,
    Angle,
    Scalar,
    Point,
    Vector,
}

impl Dimension {
    const ALL: [Self; 5] = [Self::Length, Self::Angle, Self::Scalar, Self::Point, Self::Vector];

    /// As it is written.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Length => "Length",
            Self::Angle => "Angle",
            Self::Scalar => "Scalar",
            Self::Point => "Point",
            Self::Vector => "Vector",
        }
    }

    /// Whether it has an x and a y.
    pub(crate) fn is_plane(self) -> bool {
        matches!(self, Self::Point | Self::Vector)
    }

    /// Reads a dimension, an error at the first token of anything else.
    pub(crate) fn parse(input: ParseStream<'_>) -> Result<Self> {
        let wrong = |at: &TokenTree, word: &str, near: &str| {
            syn::Error::new(
                at.span(),
                format!("{word} is not a dimension: write `Length`, `Angle`, `Scalar`, `Point` or `Vector`{near}"),
            )
        };
        if !input.peek(Ident::peek_any) {
            let token: TokenTree = input.parse()?;
            return Err(wrong(&token, "this", ""));
        }
        let word = Ident::parse_any(input)?;
        let text = word.to_string();
        let known = Self::ALL.into_iter().find(|dimension| dimension.word() == text);
        match known {
            Some(dimension) if !input.peek(Token![::]) && !input.peek(Token![<]) => Ok(dimension),
            _ => {
                let near = match known {
                    Some(_) => String::new(),
                    None => suggestion(&text, Self::ALL.map(Self::word)),
                };
                Err(wrong(&TokenTree::Ident(word), &format!("`{text}`"), &near))
            }
        }
    }
}
