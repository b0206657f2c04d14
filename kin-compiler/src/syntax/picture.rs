//! `body rod: pin, piston`, `ground pivot`, `slide piston along vec2(1, 0)`: the picture, where the equations do not
//! determine it.

use proc_macro2::{Ident, Span};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Token, token};

use crate::syntax::formula::{self, Context};
use crate::syntax::{BodyStatement, GroundStatement, SlideStatement, TypedFormula, head};

/// The words that begin such statements. They are no reserved words: quantities may be called so as well.
pub(super) const BODY: &str = "body";
pub(super) const GROUND: &str = "ground";
pub(super) const SLIDE: &str = "slide";

const FORM_OF_BODY: &str = "write its name and its points, as in `body rod: pin, piston;`";
const FORM_OF_GROUND: &str = "write the points that stand still, as in `ground 0, pivot;`";
const FORM_OF_SLIDE: &str = "write the point and the direction of its line, as in `slide piston along vec2(1, 0);`";

/// Whether the word just read begins a statement of the picture: what follows it follows no name in a formula.
pub(super) fn follows(word: &str, ahead: ParseStream<'_>) -> bool {
    let is_named = ahead.peek(Ident::peek_any);
    let colon_follows = ahead.peek2(Token![:]) && !ahead.peek2(Token![::]);
    let alone_colon = ahead.peek(Token![:]) && !ahead.peek(Token![::]);
    match word {
        BODY => is_named || ahead.peek(syn::Lit) || alone_colon,
        GROUND | SLIDE => ahead.is_empty() || alone_colon || is_named && !colon_follows || ahead.peek(syn::Lit),
        _ => false,
    }
}

/// `rod: pin, piston` after `body`.
pub(super) fn body(input: ParseStream<'_>, start: Span) -> Result<BodyStatement> {
    if input.peek(Token![:]) {
        return Err(syn::Error::new(start, format!("this body has no name: {FORM_OF_BODY}")));
    }
    if input.peek(syn::Lit) {
        return Err(input.error(format!("the name of a body begins with a letter: {FORM_OF_BODY}")));
    }
    // bodies share no names with quantities
    let name = Ident::parse_any(input)?;
    if !input.peek(Token![:]) {
        let message = format!("a body's name is followed by a colon: {FORM_OF_BODY}");
        return Err(if input.is_empty() {
            syn::Error::new(name.span(), message)
        } else {
            input.error(message)
        });
    }
    let colon = input.parse::<Token![:]>()?;
    let points = points(input, colon.span, FORM_OF_BODY)?;
    Ok(BodyStatement { name, points })
}

/// `0, pivot` after `ground`.
pub(super) fn ground(input: ParseStream<'_>, start: Span) -> Result<GroundStatement> {
    Ok(GroundStatement {
        word: start,
        points: points(input, start, FORM_OF_GROUND)?,
    })
}

/// `piston along vec2(1, 0) on lever` after `slide`.
pub(super) fn slide(input: ParseStream<'_>, start: Span) -> Result<SlideStatement> {
    if input.is_empty() {
        return Err(syn::Error::new(start, format!("nothing slides here: {FORM_OF_SLIDE}")));
    }
    let point = formula::parse(input, Context::Point)?;
    expect_word(input, "along", start)?;
    let Some(_) = head::rest(input) else {
        return Err(syn::Error::new(
            start,
            format!("the direction of this slide is missing: {FORM_OF_SLIDE}"),
        ));
    };
    let direction = formula::parse(input, Context::Point)?;
    if input.is_empty() {
        return Ok(SlideStatement {
            point,
            direction,
            guide: None,
        });
    }
    expect_word(input, "on", start)?;
    if !input.peek(Ident::peek_any) {
        return Err(syn::Error::new(
            start,
            "the body that carries this slide's line is missing: write its name, as in `on lever`, or leave out `on`",
        ));
    }
    let guide = Ident::parse_any(input)?;
    if !input.is_empty() {
        return Err(input.error("unexpected in a slide: write `;` after the body that carries its line"));
    }
    Ok(SlideStatement {
        point,
        direction,
        guide: Some(guide),
    })
}

fn expect_word(input: ParseStream<'_>, word: &str, start: Span) -> Result<()> {
    let message = format!("expected `{word}` in this slide: {FORM_OF_SLIDE}");
    if input.is_empty() {
        return Err(syn::Error::new(start, message));
    }
    if !input.peek(Ident::peek_any) {
        return Err(input.error(message));
    }
    let found = Ident::parse_any(input)?;
    if found == word {
        Ok(())
    } else {
        Err(syn::Error::new(found.span(), message))
    }
}

/// Points between commas.
fn points(input: ParseStream<'_>, before: Span, form: &str) -> Result<Vec<TypedFormula>> {
    let mut points = Vec::new();
    if input.peek(Token![:]) {
        return Err(input.error(format!("no colon stands before these points: {form}")));
    }
    if input.peek(token::Bracket) {
        return Err(input.error(format!("points stand between commas, without brackets: {form}")));
    }
    while !input.is_empty() {
        points.push(formula::parse(input, Context::Point)?);
        if input.is_empty() {
            break;
        }
        if !input.peek(Token![,]) {
            return Err(input.error("unexpected in a list of points: write `,` before a further point, `;` at the end"));
        }
        input.parse::<Token![,]>()?;
    }
    if points.is_empty() {
        return Err(syn::Error::new(before, format!("no point follows this: {form}")));
    }
    Ok(points)
}
