//! `order = 6`: the highest time derivative for which a mechanism is solved.

use proc_macro2::{Span, TokenStream};
use syn::parse::{ParseStream, Result};
use syn::{Lit, LitInt, Token};

use crate::mistakes::Extent;
use crate::syntax::{OrderStatement, head};

/// The highest order. A motion has no names for higher derivatives.
const HIGHEST: usize = 12;

/// Whether the tokens after the word `order` make it a statement. Otherwise it is an ordinary name.
pub(super) fn follows(input: ParseStream<'_>) -> bool {
    let assigns = input.peek(Token![=]) && !input.peek(Token![==]) && !input.peek(Token![=>]);
    assigns || input.peek(Lit) || input.peek(Token![:]) && input.peek2(Lit)
}

/// Reads `= 6` after `order`.
pub(super) fn parse(input: ParseStream<'_>, word: Span) -> Result<OrderStatement> {
    if !input.peek(Token![=]) {
        return Err(input.error("the order is given by `=`: write `order = 6`"));
    }
    let equals = input.parse::<Token![=]>()?;
    let Some(extent) = head::rest(input) else {
        return Err(syn::Error::new(
            equals.span,
            "the order is missing after this: write `order = 6` for derivatives to the sixth",
        ));
    };
    let value: TokenStream = input.parse()?;
    match order(&value) {
        Ok(order) => Ok(OrderStatement {
            order,
            extent: Extent::at(word).to(extent),
        }),
        Err(message) => Err(syn::Error::new_spanned(extent, message)),
    }
}

/// The number, or the message if it is not valid.
fn order(value: &TokenStream) -> std::result::Result<usize, String> {
    let Ok(literal) = syn::parse2::<LitInt>(value.clone()) else {
        return Err(format!(
            "the order is a whole number from 1 to {HIGHEST}, written out: write `order = 6`, or `==` if this is an \
             equation"
        ));
    };
    if literal.base10_digits().starts_with('-') {
        return Err(format!(
            "the order counts time derivatives, so it is never negative: write a number from 1 to {HIGHEST}"
        ));
    }
    if !literal.suffix().is_empty() {
        return Err(format!(
            "the order takes no type: write `order = {}`",
            literal.base10_digits()
        ));
    }
    match literal.base10_parse::<usize>() {
        Ok(0) => Err(
            "an order of 0 leaves no derivative to solve for: write `order = 1` for position and velocity".to_owned(),
        ),
        Ok(order) if order <= HIGHEST => Ok(order),
        _ => Err(format!(
            "the highest order is {HIGHEST}: write a number from 1 to {HIGHEST}"
        )),
    }
}
