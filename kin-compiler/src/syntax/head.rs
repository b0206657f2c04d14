//! The struct that opens a declaration: its fields are the parameters.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser, Result};
use syn::{Attribute, Token, Visibility, braced};

use crate::mistakes::{Extent, Mistakes};
use crate::syntax::{Declaration, Dimension, FreshNames, ParameterField, name, split};

const EXAMPLE: &str = "write `struct Name { … }` with the parameters as fields first";

/// The declaration up to the first statement.
struct Head {
    attributes: Vec<Attribute>,
    visibility: Visibility,
    name: Ident,
    fields: TokenStream,
    /// A mistake after which the rest is still readable.
    mistake: Option<syn::Error>,
    body: TokenStream,
}

/// Reads the struct and returns the tokens after it unread.
pub(crate) fn parse(tokens: TokenStream, mistakes: &mut Mistakes) -> Option<(Declaration, TokenStream)> {
    if tokens.is_empty() {
        mistakes.error_at(
            Span::call_site(),
            format!("an empty declaration describes no mechanism: {EXAMPLE}"),
        );
        return None;
    }
    let head = match head.parse2(tokens) {
        Ok(head) => head,
        Err(error) => {
            mistakes.push(error);
            return None;
        }
    };
    let mut declaration = Declaration {
        attributes: head.attributes,
        visibility: head.visibility,
        name: head.name,
        parameters: Vec::new(),
        fields: split::fields(head.fields.clone()),
        source: Vec::new(),
        statements: Vec::new(),
        broken: BTreeSet::new(),
        mentioned: BTreeSet::new(),
        fresh: FreshNames::default(),
        has_fields: !head.fields.is_empty(),
        complete: head.mistake.is_none(),
        breaks_off: false,
        holds_prose: false,
    };
    let readable = head.mistake.is_none();
    if let Some(mistake) = head.mistake {
        mistakes.push(mistake);
    }
    if readable && head.fields.is_empty() {
        mistakes.error(
            &declaration.name,
            format!(
                "`{}` has no parameters: declare the lengths of its links as fields, as in `pub r1: Length`",
                declaration.name
            ),
        );
    }
    for attribute in take_conditions(&mut declaration.attributes) {
        mistakes.error(
            attribute,
            "a condition here would remove the struct and leave its solvers: write it before `mechanism!`",
        );
    }
    for field in declaration.fields.clone() {
        match parameter.parse2(field.clone()) {
            Ok((mut parameter, None)) => {
                for attribute in take_conditions(&mut parameter.attributes) {
                    mistakes.error(
                        attribute,
                        "a condition cannot remove a parameter from the equations: write a `mechanism!` for each case, \
                         with the condition before it",
                    );
                }
                declaration.parameters.push(parameter);
            }
            Ok((mut parameter, Some(mistake))) => {
                if let Some(name) = split::name_before_colon(&field) {
                    parameter.name = name;
                }
                mistakes.push(mistake);
                declaration.poison(&field);
                declaration.parameters.push(parameter);
            }
            Err(error) => {
                mistakes.push(error);
                declaration.poison(&field);
            }
        }
    }
    Some((declaration, head.body))
}

/// Takes out the attributes that may remove their item. Other attributes may depend on a condition.
fn take_conditions(attributes: &mut Vec<Attribute>) -> Vec<Attribute> {
    let (conditions, others) = attributes.drain(..).partition(|attribute| {
        attribute.path().is_ident("cfg")
            || attribute.path().is_ident("cfg_attr")
                && attribute.meta.require_list().is_ok_and(|list| {
                    // the first argument is the condition
                    split::fields(list.tokens.clone())
                        .into_iter()
                        .skip(1)
                        .any(|field| matches!(field.into_iter().next(), Some(TokenTree::Ident(word)) if word == "cfg"))
                })
    });
    *attributes = others;
    conditions
}

fn head(input: ParseStream<'_>) -> Result<Head> {
    let start = input.span();
    let attributes = input.call(Attribute::parse_outer)?;
    let visibility: Visibility = input.parse()?;
    if !input.peek(Token![struct]) {
        let at = if input.is_empty() { start } else { input.span() };
        return Err(syn::Error::new(
            at,
            format!("a declaration begins with a struct: {EXAMPLE}"),
        ));
    }
    let keyword: Token![struct] = input.parse()?;
    if !input.peek(Ident::peek_any) {
        return Err(syn::Error::new(
            keyword.span,
            format!("the name of the struct is missing: {EXAMPLE}"),
        ));
    }
    let name = name::parse(input, "mechanism", keyword.span)?;
    if name == "T" {
        return Err(syn::Error::new(
            name.span(),
            "`T` is what the number type of every mechanism is called; choose another name",
        ));
    }
    let mut head = Head {
        attributes,
        visibility,
        name,
        fields: TokenStream::new(),
        mistake: None,
        body: TokenStream::new(),
    };
    if input.peek(Token![<]) || input.peek(Token![where]) {
        head.mistake = Some(input.error(format!(
            "the struct takes no generics, its numeric type is added to it: write `struct {} {{ … }}`",
            head.name
        )));
        while !input.is_empty() && !input.peek(syn::token::Brace) {
            input.parse::<TokenTree>()?;
        }
    }
    if input.peek(syn::token::Brace) {
        let fields;
        braced!(fields in input);
        head.fields = fields.parse()?;
    } else if head.mistake.is_none() {
        let message = format!(
            "the parameters need names: write `struct {} {{ r1: Length, … }}`",
            head.name
        );
        head.mistake = Some(if input.is_empty() {
            syn::Error::new(head.name.span(), message)
        } else {
            input.error(message)
        });
        if input.peek(syn::token::Paren) {
            input.parse::<TokenTree>()?;
        }
    }
    head.body = input.parse()?;
    Ok(head)
}

/// Reads a field, with the mistake in its dimension if there is one. The name remains valid for the struct that editors
/// see.
fn parameter(input: ParseStream<'_>) -> Result<(ParameterField, Option<syn::Error>)> {
    let start = input.span();
    let attributes = input.call(Attribute::parse_outer)?;
    let visibility: Visibility = input.parse()?;
    let name = name::parse(input, "parameter", start)?;
    let mut parameter = ParameterField {
        attributes,
        visibility,
        name,
        dimension: None,
    };
    let mistake = match parameter_dimension(input, &parameter.name) {
        Ok(dimension) => {
            parameter.dimension = Some(dimension);
            None
        }
        Err(error) => Some(error),
    };
    while !input.is_empty() {
        input.parse::<TokenTree>()?;
    }
    Ok((parameter, mistake))
}

fn parameter_dimension(input: ParseStream<'_>, name: &Ident) -> Result<Dimension> {
    dimension_of(input, name, "parameter")?;
    let dimension = Dimension::parse_of(input, "parameter", name)?;
    if input.peek(Token![=]) {
        return Err(input.error("a parameter takes no value here: it is given when the mechanism is made"));
    }
    if !input.is_empty() {
        return Err(input.error("unexpected after the dimension: write `,` before the next parameter"));
    }
    Ok(dimension)
}

/// Reads the `:` before a dimension.
pub(super) fn dimension_of(input: ParseStream<'_>, name: &Ident, what: &str) -> Result<()> {
    let example = match what {
        "input" | "unknown" => "Angle",
        _ => "Length",
    };
    if input.peek(Token![:]) && !input.peek(Token![::]) {
        input.parse::<Token![:]>()?;
        if input.is_empty() {
            return Err(syn::Error::new(
                name.span(),
                format!("the dimension of {what} `{name}` is missing: write `{name}: {example}`, or another dimension"),
            ));
        }
        return Ok(());
    }
    if Dimension::is_word(&name.to_string()) && input.peek(Ident::peek_any) {
        let meant = Ident::parse_any(&input.fork())?;
        return Err(syn::Error::new_spanned(
            Extent::at(name.span()).to(Extent::at(meant.span())),
            format!("the name of the {what} comes before its dimension: write `{meant}: {name}`"),
        ));
    }
    Err(syn::Error::new(
        name.span(),
        format!("{what} `{name}` has no dimension: write `{name}: {example}`, or another dimension"),
    ))
}

/// The extent of a type or a pattern in a wrong position.
pub(super) fn rest(input: ParseStream<'_>) -> Option<Extent> {
    let tokens: TokenStream = input.fork().parse().ok()?;
    let mut tokens = tokens.into_iter();
    let first = tokens.next()?.span();
    Some(Extent {
        first,
        last: tokens.last().map_or(first, |token| token.span()),
    })
}
