//! One statement: `input`, `unknown`, `let`, `output`, `order`, `with`, one of the picture, or an equation.

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser, Result};
use syn::{Attribute, Token, token};

use crate::mistakes::{Extent, nearest};
use crate::syntax::elsewhere::{instead_of_statement, is_link};
use crate::syntax::formula::{self, Context};
use crate::syntax::name::{self, STATEMENT_WORDS};
use crate::syntax::{
    Dimension, EquationStatement, FormulaKind, FrameStatement, LetStatement, OutputStatement, QuantityItem,
    RangeClause, RangeKind, Relation, Request, Statement, UnknownItem, frames, head, order, picture, request,
};

/// Reads a statement without its `;`. An empty statement is not a mistake.
pub(crate) fn parse(tokens: TokenStream) -> Result<Option<Statement>> {
    statement.parse2(tokens)
}

fn statement(input: ParseStream<'_>) -> Result<Option<Statement>> {
    let attributes = documentation(input)?;
    if input.is_empty() {
        return match attributes.last() {
            Some(attribute) => Err(syn::Error::new_spanned(
                attribute,
                "this documents nothing: write it before the statement that it describes",
            )),
            None => Ok(None),
        };
    }
    let start = input.span();
    match leading_word(input)?.as_deref() {
        Some("input") => {
            Ident::parse_any(input)?;
            list(input, attributes, start, "input", input_item).map(Statement::Inputs)
        }
        Some("unknown") => {
            Ident::parse_any(input)?;
            list(input, attributes, start, "unknown", unknown_item).map(Statement::Unknowns)
        }
        Some("let") => {
            Ident::parse_any(input)?;
            abbreviation(input, start)
        }
        Some("output") => {
            Ident::parse_any(input)?;
            output(input, attributes, start).map(Statement::Output)
        }
        Some("order") => {
            Ident::parse_any(input)?;
            order::parse(input, start).map(Statement::Order)
        }
        Some(request::WORD) => {
            Ident::parse_any(input)?;
            request::parse(input, start).map(Statement::Requests)
        }
        Some(picture::BODY) => {
            Ident::parse_any(input)?;
            picture::body(input, start).map(Statement::Body)
        }
        Some(picture::GROUND) => {
            Ident::parse_any(input)?;
            picture::ground(input, start).map(Statement::Ground)
        }
        Some(picture::SLIDE) => {
            Ident::parse_any(input)?;
            picture::slide(input, start).map(Statement::Slide)
        }
        _ => equation(input).map(Statement::Equation),
    }
    .map(Some)
}

/// Reads doc comments. No other attribute has a meaning on a statement.
fn documentation(input: ParseStream<'_>) -> Result<Vec<Attribute>> {
    let attributes = input.call(Attribute::parse_outer)?;
    match attributes.iter().find(|attribute| !attribute.path().is_ident("doc")) {
        Some(other) => Err(syn::Error::new_spanned(
            other,
            "only doc comments may stand before a statement; write other attributes on the struct or its fields",
        )),
        None => Ok(attributes),
    }
}

/// The word that names the kind of a statement, `None` for an equation.
fn leading_word(input: ParseStream<'_>) -> Result<Option<String>> {
    let ahead = input.fork();
    if !ahead.peek(Ident::peek_any) {
        return Ok(None);
    }
    let first = Ident::parse_any(&ahead)?;
    let word = first.to_string();
    let declares = ahead.peek(Ident::peek_any);
    if word == "pub" {
        return Err(syn::Error::new(
            first.span(),
            "a statement has no visibility, its results are as public as the struct: remove `pub`",
        ));
    }
    if STATEMENT_WORDS.contains(&word.as_str()) && (word == "let" || !ahead.peek(Token![==])) {
        return Ok(Some(word));
    }
    if word == "order" && order::follows(&ahead) {
        return Ok(Some(word));
    }
    if word == request::WORD && request::follows(&ahead) {
        return Ok(Some(word));
    }
    if picture::follows(&word, &ahead) {
        return Ok(Some(word));
    }
    if word == "struct" {
        return Err(syn::Error::new(
            first.span(),
            "a declaration has one struct: write another `mechanism!` for another mechanism",
        ));
    }
    if !declares || name::keyword(&word) && word != "const" && word != "static" {
        return Ok(None);
    }
    let second = Ident::parse_any(&ahead)?;
    let alone = ahead.is_empty() || ahead.peek(Token![,]);
    if alone && request::is_meant(&word, &second.to_string()) {
        return Err(syn::Error::new(
            first.span(),
            format!("`{word}` does not begin a statement; did you mean `{}`?", request::WORD),
        ));
    }
    if let Some(message) = instead_of_statement(&word, &second.to_string()) {
        return Err(syn::Error::new(first.span(), message));
    }
    if ahead.peek(Token![=]) && !ahead.peek(Token![==]) && !name::keyword(&word) {
        return Err(syn::Error::new(
            first.span(),
            format!("`{word}` does not begin a statement: write `let {second} = …` for an abbreviation"),
        ));
    }
    if !ahead.peek(Token![:]) || ahead.peek(Token![::]) {
        return Ok(None);
    }
    if is_link(&word) {
        return Err(syn::Error::new(
            first.span(),
            format!("`{word}` does not begin a statement: write `body {second}: …` with the points of the body"),
        ));
    }
    let likely = match word.as_str() {
        "const" | "static" => Some("let"),
        "param" | "parameter" => {
            return Err(syn::Error::new(
                first.span(),
                "parameters are the fields of the struct: declare it there",
            ));
        }
        _ => nearest(&word, STATEMENT_WORDS),
    };
    let likely = likely
        .map(|near| format!("; did you mean `{near}`?"))
        .unwrap_or_default();
    Err(syn::Error::new(
        first.span(),
        format!("`{word}` does not begin a statement: write `input`, `unknown`, `let` or `output`{likely}"),
    ))
}

/// Reads items between commas, with their doc comments. The doc comments of the statement belong to the first item.
fn list<Item>(
    input: ParseStream<'_>,
    leading: Vec<Attribute>,
    start: Span,
    what: &str,
    item: fn(ParseStream<'_>, Vec<Attribute>, Span) -> Result<Item>,
) -> Result<Vec<Item>> {
    let mut items = Vec::new();
    let mut attributes = leading;
    loop {
        attributes.append(&mut documentation(input)?);
        items.push(item(input, std::mem::take(&mut attributes), start)?);
        if input.is_empty() {
            return Ok(items);
        }
        if !input.peek(Token![,]) {
            return Err(input.error(format!(
                "unexpected in a declaration of an {what}: write `,` before another one, or `;` at the end"
            )));
        }
        input.parse::<Token![,]>()?;
        if input.is_empty() {
            return Ok(items);
        }
    }
}

/// Reads `theta2: Angle`. `what` names the kind of quantity in messages: `an input` or `an unknown`.
fn quantity(input: ParseStream<'_>, documentation: Vec<Attribute>, what: &str, start: Span) -> Result<QuantityItem> {
    let name = name::parse(input, what, start)?;
    head::dimension_of(input, &name, what)?;
    let at = input.span();
    let dimension = if what == "unknown" {
        Dimension::parse(input)?
    } else {
        Dimension::parse_of(input, what, &name)?
    };
    let parts = dimension.shape().part_names(&name.to_string(), "_");
    if let [first @ .., last] = parts.as_slice()
        && !first.is_empty()
    {
        let (count, function) = if parts.len() == 2 {
            ("two", "vec2")
        } else {
            ("three", "vec3")
        };
        return Err(syn::Error::new(
            at,
            format!(
                "an {what} is a single number: declare {count} lengths, `{}` and `{last}`, and write `{function}({})`",
                first.join("`, `"),
                parts.join(", "),
            ),
        ));
    }
    Ok(QuantityItem {
        documentation,
        name,
        dimension,
    })
}

fn input_item(input: ParseStream<'_>, documentation: Vec<Attribute>, start: Span) -> Result<QuantityItem> {
    let item = quantity(input, documentation, "input", start)?;
    if input.peek(Token![where]) || input.peek(Token![in]) {
        return Err(input.error("an input has no range: its value is given, so there is no branch to choose"));
    }
    if input.peek(Token![=]) {
        return Err(input.error("an input has no value here: pass its value to the solver"));
    }
    Ok(item)
}

fn unknown_item(input: ParseStream<'_>, documentation: Vec<Attribute>, start: Span) -> Result<UnknownItem> {
    let quantity = quantity(input, documentation, "unknown", start)?;
    if input.peek(Token![=]) && !input.peek(Token![==]) {
        return Err(input.error(format!(
            "an unknown has no value: end the statement here, and write its equation as another statement, `{} == …;`",
            quantity.name
        )));
    }
    if input.peek(Token![<]) || input.peek(Token![<=]) || input.peek(Token![>]) || input.peek(Token![>=]) {
        return Err(input.error(format!(
            "a range begins with `where`: write `where {} > 0`",
            quantity.name
        )));
    }
    let clause = input.span();
    let kind = if input.peek(Token![where]) {
        input.parse::<Token![where]>()?;
        comparison(input, &quantity.name, clause)?
    } else if input.peek(Token![in]) {
        input.parse::<Token![in]>()?;
        between(input, &quantity.name, clause)?
    } else {
        return Ok(UnknownItem { quantity, range: None });
    };
    let end = match &kind {
        RangeKind::Comparison { bound, .. } => bound.extent,
        RangeKind::Between { high, .. } => high.extent,
    };
    Ok(UnknownItem {
        quantity,
        range: Some(RangeClause {
            kind,
            extent: Extent::at(clause).to(end),
        }),
    })
}

/// Reads `e > 0` after `where`.
fn comparison(input: ParseStream<'_>, unknown: &Ident, start: Span) -> Result<RangeKind> {
    if input.is_empty() {
        return Err(syn::Error::new(
            start,
            format!("the range is missing: write `where {unknown} > 0`"),
        ));
    }
    if !input.peek(Ident::peek_any) {
        return Err(input.error(format!(
            "the unknown comes first in its range: write `where {unknown} > 0`, or `in 0..=1` for a range with two ends"
        )));
    }
    let name = Ident::parse_any(input)?;
    if input.peek(token::Paren) {
        return Err(syn::Error::new(
            name.span(),
            format!("a range is one of the unknown itself: write `where {unknown} > 0`"),
        ));
    }
    let comparison = if input.peek(Token![<=]) {
        input.parse::<Token![<=]>()?;
        Relation::LessOrEqual
    } else if input.peek(Token![>=]) {
        input.parse::<Token![>=]>()?;
        Relation::GreaterOrEqual
    } else if input.peek(Token![<]) {
        input.parse::<Token![<]>()?;
        Relation::Less
    } else if input.peek(Token![>]) {
        input.parse::<Token![>]>()?;
        Relation::Greater
    } else {
        let message = format!("a range needs `<`, `<=`, `>` or `>=`: write `where {unknown} > 0`");
        return Err(if input.is_empty() {
            syn::Error::new(name.span(), message)
        } else {
            input.error(message)
        });
    };
    if input.is_empty() {
        return Err(syn::Error::new(
            name.span(),
            format!("the end of the range of `{unknown}` is missing: write `where {unknown} > 0`"),
        ));
    }
    let bound = formula::parse(input, Context::RangeEnd)?;
    Ok(RangeKind::Comparison {
        name,
        comparison,
        bound,
    })
}

/// Reads `0..=PI` after `in`.
fn between(input: ParseStream<'_>, unknown: &Ident, start: Span) -> Result<RangeKind> {
    let open = |at: Extent| {
        syn::Error::new_spanned(
            at,
            format!("a range has two ends, `0..=PI`: write `where {unknown} > …` for a range with a single end"),
        )
    };
    if input.is_empty() {
        return Err(open(Extent::at(start)));
    }
    if input.peek(Token![..]) {
        return Err(open(Extent::at(input.span())));
    }
    if let Some(message) = ends_in_brackets(input) {
        return Err(input.error(message));
    }
    let low = formula::parse(input, Context::RangeStart)?;
    let dots = Extent::at(input.span());
    let closed = input.peek(Token![..=]);
    if closed {
        input.parse::<Token![..=]>()?;
    } else if input.peek(Token![..]) {
        input.parse::<Token![..]>()?;
    } else {
        return Err(open(low.extent));
    }
    if input.is_empty() || input.peek(Token![,]) {
        return Err(open(low.extent.to(dots)));
    }
    let high = formula::parse(input, Context::RangeEnd)?;
    Ok(RangeKind::Between { low, high, closed })
}

/// The message about a range that is written `[0, PI]` or `(0, PI)`.
fn ends_in_brackets(input: ParseStream<'_>) -> Option<String> {
    let Ok(TokenTree::Group(group)) = input.fork().parse() else {
        return None;
    };
    let dots = if group.delimiter() == Delimiter::Bracket {
        "..="
    } else {
        ".."
    };
    let ends = |content: ParseStream<'_>| {
        let low = formula::parse(content, Context::Argument)?;
        content.parse::<Token![,]>()?;
        Ok((low, formula::parse(content, Context::Argument)?))
    };
    let (low, high) = ends.parse2(group.stream()).ok()?;
    Some(format!(
        "a range has dots between its ends and no brackets: write `in {low}{dots}{high}`"
    ))
}

/// Reads `half = r3 / 2` or `platform = frame(center, rotation)` after `let`.
fn abbreviation(input: ParseStream<'_>, start: Span) -> Result<Statement> {
    if input.peek(Token![mut]) {
        return Err(input.error("a `let` is an abbreviation and never changes: write it without `mut`"));
    }
    let name = name::parse(input, "`let`", start)?;
    if input.peek(Token![:]) {
        return Err(syn::Error::new_spanned(
            head::rest(input).unwrap_or(Extent::at(name.span())),
            format!("the dimension of a `let` follows from its expression: write `let {name} = …`"),
        ));
    }
    if let Some((origin, rotation)) = frames::parse(input)? {
        return Ok(Statement::Frame(FrameStatement { name, origin, rotation }));
    }
    let value = definition(input, &name, &format!("let {name} = …"))?;
    Ok(Statement::Let(LetStatement { name, value }))
}

/// Reads `midpoint: Point = …` after `output`.
fn output(input: ParseStream<'_>, documentation: Vec<Attribute>, start: Span) -> Result<OutputStatement> {
    let name = name::parse(input, "output", start)?;
    head::dimension_of(input, &name, "output")?;
    let dimension = Dimension::parse_of(input, "output", &name)?;
    let value = definition(input, &name, &format!("output {name}: {} = …", dimension.word()))?;
    Ok(OutputStatement {
        documentation,
        name,
        dimension,
        value,
    })
}

/// Reads `= formula` up to the end.
fn definition(input: ParseStream<'_>, name: &Ident, form: &str) -> Result<crate::syntax::TypedFormula> {
    if input.is_empty() {
        return Err(syn::Error::new(
            name.span(),
            format!("`{name}` has no value: write `{form}`"),
        ));
    }
    if input.peek(Token![==]) || !input.peek(Token![=]) {
        return Err(input.error(format!("expected `=` here: write `{form}`")));
    }
    let equals = input.parse::<Token![=]>()?;
    if input.is_empty() {
        return Err(syn::Error::new(
            equals.span,
            format!("the value of `{name}` is missing: write `{form}`"),
        ));
    }
    formula::parse(input, Context::Value)
}

/// Reads `left == right`.
fn equation(input: ParseStream<'_>) -> Result<EquationStatement> {
    let tokens: TokenStream = input.fork().parse()?;
    if input.peek(Token![==]) {
        return Err(input.error("the left side of this equation is missing"));
    }
    let left = formula::parse(input, Context::LeftSide)?;
    if let (true, FormulaKind::Name(name)) = (input.is_empty(), &left.kind)
        && let Some(request) = Request::ALL.into_iter().find(|request| name == request.name())
    {
        return Err(syn::Error::new_spanned(
            left.extent,
            format!("a request begins with `with`: write `with {};`", request.name()),
        ));
    }
    if input.is_empty() {
        return Err(syn::Error::new_spanned(
            left.extent,
            "this is neither an equation nor a declaration: write `left == right`",
        ));
    }
    let operator = input.parse::<Token![==]>()?;
    let operator = Extent {
        first: operator.spans[0],
        last: operator.spans[1],
    };
    if input.is_empty() {
        return Err(syn::Error::new_spanned(
            operator,
            "the right side of this equation is missing",
        ));
    }
    let right = formula::parse(input, Context::RightSide)?;
    Ok(EquationStatement {
        left,
        right,
        operator,
        tokens,
        is_copy: false,
    })
}
