//! `with transmission_angles, sensitivities`: items to generate besides the solvers.

use proc_macro2::{Ident, Span};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Token, token};

use crate::mistakes::nearest;

/// The word that begins a request. It is not reserved: a quantity may have this name too.
pub(super) const WORD: &str = "with";

const FORM: &str = "write the names of what is to be generated, as in `with transmission_angles;`";

/// The items that can be requested by `with`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Request {
    /// The transmission angle of every dyad.
    TransmissionAngles,
    /// Derivatives with respect to the parameters.
    Sensitivities,
    /// A test that verifies the mechanism.
    Test,
}

impl Request {
    pub(crate) const ALL: [Self; 3] = [Self::TransmissionAngles, Self::Sensitivities, Self::Test];

    /// The name, as it is typed.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::TransmissionAngles => "transmission_angles",
            Self::Sensitivities => "sensitivities",
            Self::Test => "test",
        }
    }
}

/// Whether the word just read begins a request. It does if a name follows, which no formula allows, if nothing
/// follows, or if it looks like a function.
pub(super) fn follows(ahead: ParseStream<'_>) -> bool {
    ahead.is_empty() || ahead.peek(Token![,]) || ahead.peek(Ident::peek_any) || ahead.peek(token::Paren)
}

/// Whether two words alone are probably a misspelt request.
pub(super) fn is_meant(word: &str, name: &str) -> bool {
    nearest(word, [WORD]).is_some() && nearest(name, Request::ALL.map(Request::name)).is_some()
}

/// Reads the names after `with`, without checking them.
pub(super) fn parse(input: ParseStream<'_>, start: Span) -> Result<Vec<Ident>> {
    let mut names = Vec::new();
    loop {
        if input.is_empty() {
            return if names.is_empty() {
                Err(syn::Error::new(
                    start,
                    format!("nothing is requested after this: {FORM}"),
                ))
            } else {
                Ok(names)
            };
        }
        if input.peek(token::Paren) {
            return Err(input.error(format!("the names of a request stand without parentheses: {FORM}")));
        }
        if !input.peek(Ident::peek_any) {
            return Err(input.error(format!("expected a name here: {FORM}")));
        }
        let name = Ident::parse_any(input)?;
        if name == "order" && !input.is_empty() && !input.peek(Token![,]) {
            return Err(syn::Error::new(
                start,
                "the order is a statement of its own, without `with`: write `order = 6;`",
            ));
        }
        if input.peek(Token![=]) || input.peek(Token![:]) || input.peek(token::Paren) {
            return Err(input.error(format!("a request has no value: write `with {name};`")));
        }
        names.push(name);
        if input.is_empty() {
            return Ok(names);
        }
        if !input.peek(Token![,]) {
            return Err(input.error("unexpected in a request: write `,` before a further name, `;` at the end"));
        }
        input.parse::<Token![,]>()?;
    }
}
