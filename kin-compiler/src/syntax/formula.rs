//! Formulas, read by precedence climbing.
//!
//! `syn::Expr` could read them too, but it accepts far more. Here every construct outside the language gets a
//! message at the token.

use proc_macro2::{Ident, Span, TokenTree};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Lifetime, Lit, Token, parenthesized, token};

use crate::algebra::Misfit;
use crate::mistakes::Extent;
use crate::syntax::elsewhere::{
    about_suffix, differentiates, form_in_small_letters, instead_of_function, is_derivative, is_unit,
};
use crate::syntax::{
    ArithmeticOperator, Axis, Callee, FormulaKind, Operand, TypedFormula, callee, form, frames, function_names,
    is_function, nesting,
};

/// The largest exponent of `powi`: far larger than any mechanism needs, and small enough to multiply out.
const LARGEST_EXPONENT: u32 = 64;

/// The letters behind an angle in degrees.
const DEGREES: &str = "deg";

/// The context of a formula, which decides what may follow it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Context {
    /// Before the `==` of an equation, or a whole statement that lacks one.
    LeftSide,
    /// After the `==`.
    RightSide,
    /// After the `=` of a `let` or an output.
    Value,
    /// Alone between parentheses.
    Parenthesis,
    /// Between parentheses, with other arguments.
    Argument,
    /// Before the `..` of a range.
    RangeStart,
    /// After the `..` of a range, or after a comparison. Further unknowns may follow.
    RangeEnd,
    /// In a statement of the picture, where a comma or a word may follow.
    Point,
}

impl TypedFormula {
    /// A formula, unless it is nested too deep.
    pub(super) fn new(kind: FormulaKind, extent: Extent) -> Result<Self> {
        let depth = match &kind {
            FormulaKind::Number { .. } | FormulaKind::Degrees { .. } | FormulaKind::Pi | FormulaKind::Name(_) => 0,
            FormulaKind::Negate(of)
            | FormulaKind::Parenthesis(of)
            | FormulaKind::Part { of, .. }
            | FormulaKind::Power { base: of, .. } => 1 + of.depth,
            FormulaKind::Sum { first, rest } | FormulaKind::Product { first, rest } => {
                1 + deepest(rest.iter().map(|operation| &operation.formula)).max(first.depth)
            }
            FormulaKind::Call { arguments, .. } => 1 + deepest(arguments),
        };
        if depth > nesting::DEEPEST {
            // the sign or the method that is one too many
            let at = match kind {
                FormulaKind::Negate(_) => Extent::at(extent.first),
                FormulaKind::Part { .. }
                | FormulaKind::Call { method: true, .. }
                | FormulaKind::Power { method: true, .. } => Extent::at(extent.last),
                _ => extent,
            };
            return Err(syn::Error::new_spanned(at, nesting::message()));
        }
        Ok(Self { kind, extent, depth })
    }

    /// Calls `visit` on every name in the formula, in source order.
    pub(crate) fn visit_names<'a>(&'a self, visit: &mut dyn FnMut(&'a Ident)) {
        match &self.kind {
            FormulaKind::Name(name) => visit(name),
            FormulaKind::Number { .. } | FormulaKind::Degrees { .. } | FormulaKind::Pi => {}
            FormulaKind::Negate(of)
            | FormulaKind::Parenthesis(of)
            | FormulaKind::Part { of, .. }
            | FormulaKind::Power { base: of, .. } => of.visit_names(visit),
            FormulaKind::Sum { first, rest } | FormulaKind::Product { first, rest } => {
                first.visit_names(visit);
                for operation in rest {
                    operation.formula.visit_names(visit);
                }
            }
            FormulaKind::Call { arguments, .. } => {
                for argument in arguments {
                    argument.visit_names(visit);
                }
            }
        }
    }
}

/// Reads a formula up to the end of its context.
pub(crate) fn parse(input: ParseStream<'_>, context: Context) -> Result<TypedFormula> {
    let formula = sum(input)?;
    let ended = input.is_empty()
        || match context {
            Context::LeftSide => input.peek(Token![==]),
            Context::Argument | Context::RangeEnd => input.peek(Token![,]),
            Context::RangeStart => input.peek(Token![..]),
            Context::Point => input.peek(Token![,]) || input.peek(Ident::peek_any),
            Context::RightSide | Context::Value | Context::Parenthesis => false,
        };
    if ended { Ok(formula) } else { Err(stray(input, context)) }
}

fn deepest<'a>(formulas: impl IntoIterator<Item = &'a TypedFormula>) -> usize {
    formulas.into_iter().map(|formula| formula.depth).max().unwrap_or(0)
}

fn sum(input: ParseStream<'_>) -> Result<TypedFormula> {
    let first = product(input)?;
    let mut rest = Vec::new();
    loop {
        let operator = if input.peek(Token![+]) && !input.peek(Token![+=]) {
            ArithmeticOperator::Add
        } else if input.peek(Token![-]) && !input.peek(Token![-=]) && !input.peek(Token![->]) {
            ArithmeticOperator::Subtract
        } else {
            return chain(first, rest, |first, rest| FormulaKind::Sum { first, rest });
        };
        rest.push(operation(input, operator, product)?);
    }
}

fn product(input: ParseStream<'_>) -> Result<TypedFormula> {
    let first = unary(input)?;
    let mut rest = Vec::new();
    loop {
        let operator = if input.peek(Token![*]) && !input.peek(Token![*=]) {
            ArithmeticOperator::Multiply
        } else if input.peek(Token![/]) && !input.peek(Token![/=]) {
            ArithmeticOperator::Divide
        } else {
            return chain(first, rest, |first, rest| FormulaKind::Product { first, rest });
        };
        if operator == ArithmeticOperator::Multiply && input.peek2(Token![*]) {
            return Err(input.error("there is no operator `**`: write `powi(x, 2)` for a power"));
        }
        rest.push(operation(input, operator, unary)?);
    }
}

/// Reads an operator and the operand after it.
fn operation(
    input: ParseStream<'_>,
    operator: ArithmeticOperator,
    operand: fn(ParseStream<'_>) -> Result<TypedFormula>,
) -> Result<Operand> {
    let span = input.parse::<TokenTree>()?.span();
    expect_operand(input, span, operator.symbol())?;
    let operand = operand(input)?;
    Ok(Operand {
        operator,
        span,
        formula: operand,
    })
}

/// A sum or a product. A single operand is returned as it is.
pub(super) fn chain(
    first: TypedFormula,
    rest: Vec<Operand>,
    kind: fn(Box<TypedFormula>, Vec<Operand>) -> FormulaKind,
) -> Result<TypedFormula> {
    let Some(last) = rest.last() else {
        return Ok(first);
    };
    let extent = first.extent.to(last.formula.extent);
    TypedFormula::new(kind(Box::new(first), rest), extent)
}

/// Reads any number of signs and their operand.
fn unary(input: ParseStream<'_>) -> Result<TypedFormula> {
    let mut signs = Vec::new();
    while input.peek(Token![-]) && !input.peek(Token![-=]) && !input.peek(Token![->]) {
        let span = input.parse::<Token![-]>()?.span;
        expect_operand(input, span, "-")?;
        signs.push(span);
    }
    let operand = postfix(input)?;
    signs.into_iter().rev().try_fold(operand, |of, span| {
        let extent = Extent::at(span).to(of.extent);
        TypedFormula::new(FormulaKind::Negate(Box::new(of)), extent)
    })
}

/// Reports a missing operand at its operator, because the end of the source has no position.
fn expect_operand(input: ParseStream<'_>, span: Span, symbol: &str) -> Result<()> {
    let ended = input.is_empty() || input.peek(Token![,]) || input.peek(Token![==]);
    if ended {
        return Err(syn::Error::new(
            span,
            format!("nothing follows this `{symbol}`: complete the expression"),
        ));
    }
    Ok(())
}

/// Reads an operand with the methods and parts after it.
fn postfix(input: ParseStream<'_>) -> Result<TypedFormula> {
    let mut of = operand(input)?;
    loop {
        if input.peek(Token![.]) && !input.peek(Token![..]) {
            let dot = input.parse::<Token![.]>()?.span;
            of = member(input, dot, of)?;
        } else if input.peek(token::Bracket) {
            return Err(input.error("a formula has no indices: give every quantity its own name"));
        } else if input.peek(token::Paren) {
            return Err(input.error("only a function can be called: write `*` for a product"));
        } else if input.peek(Token![?]) {
            return Err(input.error("`?` has no meaning here: a formula cannot fail, the solver can"));
        } else {
            return Ok(of);
        }
    }
}

/// Reads the method or part after a `.`.
fn member(input: ParseStream<'_>, dot: Span, of: TypedFormula) -> Result<TypedFormula> {
    if !input.peek(Ident::peek_any) {
        let at = if input.is_empty() { dot } else { input.span() };
        return Err(syn::Error::new(
            at,
            "expected a function after the `.`, or `x`, `y` or `z`, the parts of a vector",
        ));
    }
    let member = Ident::parse_any(input)?;
    let word = member.to_string();
    if input.peek(Token![::]) {
        return Err(input.error("a function takes no types here: write only its arguments"));
    }
    if input.peek(token::Paren) {
        if !is_function(&word) {
            return Err(unknown_function(&member, true));
        }
        let mut arguments = vec![of];
        let close = self::arguments(input, &mut arguments)?;
        return call(&member, arguments, true, close);
    }
    let axis = match word.as_str() {
        "x" => Axis::X,
        "y" => Axis::Y,
        "z" => Axis::Z,
        "await" => {
            return Err(syn::Error::new(
                member.span(),
                "`await` has no meaning here: write only formulas",
            ));
        }
        "pi" | "PI" => {
            return Err(syn::Error::new_spanned(
                of.extent.to(Extent::at(member.span())),
                "`PI` stands alone here: write `PI`",
            ));
        }
        "re" | "real" | "im" | "imag" => {
            let axis = if word.starts_with('r') { "x" } else { "y" };
            return Err(syn::Error::new(
                member.span(),
                format!("there is no part `{word}`: write `.{axis}`, the part of a plane vector"),
            ));
        }
        _ if is_function(&word) => {
            return Err(syn::Error::new(
                member.span(),
                format!("`{word}` is a function: write `.{word}()`"),
            ));
        }
        _ if is_derivative(&word) => return Err(syn::Error::new(member.span(), about_derivative(&word))),
        _ => {
            return Err(syn::Error::new(
                member.span(),
                format!(
                    "there is no part `{word}`: a plane vector has the parts `x` and `y`, a space vector `x`, `y` and \
                     `z`"
                ),
            ));
        }
    };
    let extent = of.extent.to(Extent::at(member.span()));
    TypedFormula::new(FormulaKind::Part { of: Box::new(of), axis }, extent)
}

fn operand(input: ParseStream<'_>) -> Result<TypedFormula> {
    if input.peek(token::Paren) {
        return parenthesis(input);
    }
    if input.peek(Lit) && !input.peek(Token![_]) {
        return literal(input);
    }
    if input.peek(Ident::peek_any) {
        return word(input);
    }
    Err(input.error(no_operand(input)))
}

/// The message for a token that cannot begin an operand.
fn no_operand(input: ParseStream<'_>) -> &'static str {
    if input.peek(token::Bracket) {
        "there are no arrays here: write `vec2(x, y)` for a plane vector, `vec3(x, y, z)` for a space vector"
    } else if input.peek(token::Brace) {
        "a formula has no blocks: write `( … )` to group, and `let` statements of their own for abbreviations"
    } else if input.peek(Token![&]) {
        "a formula takes no references: write the name alone"
    } else if input.peek(Token![|]) {
        "there are no bars and closures here: write the formula itself, and `norm(v)` for the length of a vector"
    } else if input.peek(Token![!]) {
        "there are no conditions here: an equation always holds"
    } else if input.peek(Token![..]) {
        "a range belongs to an unknown: write `unknown x: Angle in 0..=PI`"
    } else if input.peek(Lifetime) {
        "there are no loops or labels here: write only formulas"
    } else if input.peek(Token![+]) {
        "a number has no `+` in front of it: write the number alone"
    } else if input.peek(Token![%]) {
        "comments begin with `//`"
    } else if input.peek(Token![=]) {
        "an equation is written with two equals signs: remove this `=`"
    } else if input.peek(Token![*]) {
        "an operand is missing before this `*`; a power is written `powi(x, 2)`"
    } else if input.peek(Token![#]) {
        "an attribute has no meaning within a formula: write it before a statement"
    } else if input.peek(Token![<]) || input.peek(Token![::]) {
        "there are no paths here: write the function or quantity by its name"
    } else {
        "expected a name, a number, a function or `(` here"
    }
}

fn parenthesis(input: ParseStream<'_>) -> Result<TypedFormula> {
    let content;
    let parentheses = parenthesized!(content in input);
    let extent = Extent {
        first: parentheses.span.open(),
        last: parentheses.span.close(),
    };
    if content.is_empty() {
        return Err(syn::Error::new_spanned(
            extent,
            "there is nothing between these parentheses: write an expression",
        ));
    }
    let inner = parse(&content, Context::Parenthesis)?;
    TypedFormula::new(FormulaKind::Parenthesis(Box::new(inner)), extent)
}

fn literal(input: ParseStream<'_>) -> Result<TypedFormula> {
    let literal: Lit = input.parse()?;
    let span = literal.span();
    let (digits, suffix) = match &literal {
        Lit::Int(number) => (number.base10_digits().to_owned(), number.suffix()),
        Lit::Float(number) => (number.base10_digits().to_owned(), number.suffix()),
        Lit::Bool(_) => {
            return Err(syn::Error::new(
                span,
                "there are no conditions here: an equation always holds",
            ));
        }
        _ => {
            return Err(syn::Error::new(
                span,
                "a formula contains no text: write numbers and names",
            ));
        }
    };
    if !matches!(suffix, "" | "f64" | DEGREES) {
        return Err(syn::Error::new(span, about_suffix(&digits, suffix)));
    }
    if suffix.is_empty() && input.peek(syn::Ident) {
        let unit = Ident::parse_any(&input.fork())?;
        if is_unit(&unit.to_string()) {
            return Err(syn::Error::new_spanned(
                Extent::at(span).to(Extent::at(unit.span())),
                about_suffix(&digits, &unit.to_string()),
            ));
        }
    }
    let Ok(value) = digits.parse::<f64>() else {
        return Err(syn::Error::new(
            span,
            "this number cannot be read: write it in decimal digits",
        ));
    };
    let is_zero = digits
        .split(['e', 'E'])
        .next()
        .is_some_and(|mantissa| mantissa.chars().all(|digit| matches!(digit, '0' | '.')));
    match Misfit::of(value, is_zero) {
        None => {
            let text = literal.to_token_stream().to_string();
            let kind = if suffix == DEGREES {
                FormulaKind::Degrees { value, text }
            } else {
                FormulaKind::Number { value, text }
            };
            TypedFormula::new(kind, Extent::at(span))
        }
        Some(misfit) => Err(syn::Error::new(
            span,
            format!("this number is {misfit}: choose a unit in which it is closer to 1"),
        )),
    }
}

/// Reads a name, a call, or a word that has a meaning in Rust but not here.
fn word(input: ParseStream<'_>) -> Result<TypedFormula> {
    let word = Ident::parse_any(input)?;
    let text = word.to_string();
    let at = |message: String| Err(syn::Error::new(word.span(), message));
    if let Some(message) = foreign(&text) {
        return at(message.to_owned());
    }
    if input.peek(Token![::]) {
        return Err(path(input, &word));
    }
    if input.peek(Token![!]) && !input.peek(Token![!=]) {
        return at(format!(
            "macros cannot be used in a formula: write what `{text}!` stands for"
        ));
    }
    if text == "self" {
        return at("parameters are written without `self`: write their names alone".to_owned());
    }
    if input.peek(token::Paren) {
        if frames::is_frame(&text) {
            return at(frames::ALONE.to_owned());
        }
        if !is_function(&text) {
            return Err(unknown_function(&word, false));
        }
        let mut arguments = Vec::new();
        let close = self::arguments(input, &mut arguments)?;
        return call(&word, arguments, false, close);
    }
    if input.peek(token::Bracket)
        && let Some(form) = form_in_small_letters(&text)
    {
        return at(format!("a function takes its arguments in parentheses: write `{form}`"));
    }
    if text.starts_with("r#") {
        return at(format!("`{text}` is a raw identifier; choose a plain name"));
    }
    if is_function(&text) && (input.peek(syn::Ident) || input.peek(Lit)) {
        return Err(without_parentheses(input, &word));
    }
    let kind = if text == "PI" {
        FormulaKind::Pi
    } else {
        FormulaKind::Name(word.clone())
    };
    TypedFormula::new(kind, Extent::at(word.span()))
}

/// The replacement for a construct of Rust. Keywords that could be names are looked up as names, and so are functions
/// without arguments: their declaration may be the mistake.
fn foreign(word: &str) -> Option<&'static str> {
    Some(match word {
        "if" | "else" | "match" => {
            "a formula has no cases: write equations that always hold, and `where` or `in` after an unknown to choose \
             its branch"
        }
        "for" | "while" | "loop" | "break" | "continue" => {
            "there are no loops within a formula: a `for` is a statement of its own, as in `for (a, b) in [(a1, b1), \
             (a2, b2)] { a == b; }`"
        }
        "move" | "async" => "there are no closures here: write the formula itself",
        "unsafe" => "a formula has no blocks: write `( … )` to group",
        "return" | "yield" => "nothing is returned here: write `output name: Length = …;` for a result",
        "let" => "a `let` is a statement of its own: write it before the formula that uses it",
        "true" | "false" => "there are no conditions here: an equation always holds",
        "fn" | "impl" | "trait" | "enum" | "use" | "mod" | "static" | "const" | "pub" | "struct" | "extern"
        | "macro" => "items cannot be declared here: write them outside of `mechanism!`",
        "_" => "a formula has no placeholders: write a name or a number",
        _ => return None,
    })
}

/// Reports an argument that follows a function without parentheses: `cis t`.
fn without_parentheses(input: ParseStream<'_>, function: &Ident) -> syn::Error {
    let mut extent = Extent::at(function.span());
    let mut instead = form(&function.to_string()).unwrap_or_default().to_owned();
    if let Ok(argument) = input.parse::<TokenTree>() {
        extent = extent.to(Extent::at(argument.span()));
        let alone = input.is_empty() || !input.peek(token::Paren) && !input.peek(Token![.]);
        if alone && Callee::from_name(&function.to_string()).is_some_and(|callee| callee.arity() == 1) {
            instead = format!("{function}({argument})");
        }
    }
    syn::Error::new_spanned(
        extent,
        format!("a function takes its arguments in parentheses: write `{instead}`"),
    )
}

/// Reports a path `a::b`. It was probably meant as PI or as a function.
fn path(input: ParseStream<'_>, first: &Ident) -> syn::Error {
    let mut last = first.clone();
    while input.peek(Token![::]) && input.peek3(Ident::peek_any) {
        let (Ok(_), Ok(next)) = (input.parse::<Token![::]>(), Ident::parse_any(input)) else {
            break;
        };
        last = next;
    }
    let word = last.to_string();
    let extent = Extent::at(first.span()).to(Extent::at(last.span()));
    let instead = if word == "PI" {
        "write `PI`".to_owned()
    } else if word == "TAU" {
        "write `2 * PI`".to_owned()
    } else if let Some(form) = form(&word) {
        format!("write `{form}`")
    } else {
        "write a parameter for a value from outside".to_owned()
    };
    syn::Error::new_spanned(extent, format!("there are no paths here: {instead}"))
}

fn unknown_function(name: &Ident, method: bool) -> syn::Error {
    let word = name.to_string();
    if is_derivative(&word) {
        return syn::Error::new(name.span(), about_derivative(&word));
    }
    if differentiates(&word) {
        return syn::Error::new(name.span(), about_derivative("velocity"));
    }
    let instead = instead_of_function(&word, method);
    syn::Error::new(
        name.span(),
        format!(
            "`{word}` is not a function of the declaration language, which has {}{instead}",
            function_names().collect::<Vec<_>>().join(", ")
        ),
    )
}

fn about_derivative(word: &str) -> String {
    format!("a formula contains no derivatives, they are in every result: read `.{word}()` of an unknown or an output")
}

/// Reads `( … )` and returns the place of the closing parenthesis.
fn arguments(input: ParseStream<'_>, arguments: &mut Vec<TypedFormula>) -> Result<Span> {
    let content;
    let parentheses = parenthesized!(content in input);
    while !content.is_empty() {
        if content.peek(Token![,]) {
            return Err(content.error("an argument is missing before this `,`"));
        }
        arguments.push(parse(&content, Context::Argument)?);
        if content.peek(Token![,]) {
            content.parse::<Token![,]>()?;
        }
    }
    Ok(parentheses.span.close())
}

fn call(name: &Ident, arguments: Vec<TypedFormula>, method: bool, close: Span) -> Result<TypedFormula> {
    let word = name.to_string();
    let callee = match word.as_str() {
        callee::POWER => None,
        _ => match Callee::from_name(&word) {
            Some(callee) => Some(callee),
            None => return Err(unknown_function(name, method)),
        },
    };
    let (arity, form) = callee.map_or((2, callee::FORM_OF_POWER), |callee| (callee.arity(), callee.form()));
    let extent = match arguments.first() {
        Some(receiver) if method => receiver.extent.to(Extent::at(close)),
        _ => Extent::at(name.span()).to(Extent::at(close)),
    };
    if arguments.len() != arity {
        if let ([receiver, rest @ ..], true) = (arguments.as_slice(), method && arguments.len() == arity + 1)
            && let FormulaKind::Name(before) = &receiver.kind
        {
            let rest: Vec<String> = rest.iter().map(TypedFormula::to_string).collect();
            let alone = format!("{word}({})", rest.join(", "));
            return Err(syn::Error::new_spanned(
                Extent::at(name.span()).to(Extent::at(close)),
                format!(
                    "`{before}` before the `.` is an argument of `{word}` here: write `{alone}` for the function \
                     alone, `{before} * {alone}` for a product"
                ),
            ));
        }
        let count = |n| {
            if n == 1 {
                "1 argument".to_owned()
            } else {
                format!("{n} arguments")
            }
        };
        let given = arguments.len();
        let counted = if method {
            ", counting the one before the `.`"
        } else {
            ""
        };
        let is_rotation = matches!(callee, Some(Callee::RotX | Callee::RotY | Callee::RotZ | Callee::Rot));
        let form = if is_rotation && given == arity + 1 {
            format!("{form} * v")
        } else {
            form.to_owned()
        };
        return Err(syn::Error::new_spanned(
            Extent::at(name.span()).to(Extent::at(close)),
            format!(
                "`{word}` takes {}, but is given {given}{counted}: write `{form}`",
                count(arity),
            ),
        ));
    }
    let kind = match (callee, arguments.as_slice()) {
        (None, [base, exponent]) => FormulaKind::Power {
            base: Box::new(base.clone()),
            exponent: self::exponent(exponent)?,
            method,
        },
        (None, _) => return Err(unknown_function(name, method)),
        (Some(callee), _) => FormulaKind::Call {
            callee,
            arguments,
            method,
        },
    };
    TypedFormula::new(kind, extent)
}

/// The exponent of `powi`. It must be an integer literal, because the form of the formula depends on it.
fn exponent(argument: &TypedFormula) -> Result<i32> {
    fn literal(formula: &TypedFormula, text: &mut String) -> bool {
        match &formula.kind {
            FormulaKind::Number { text: digits, .. } => {
                text.push_str(digits);
                true
            }
            FormulaKind::Negate(of) => {
                text.push('-');
                literal(of, text)
            }
            FormulaKind::Parenthesis(inner) => literal(inner, text),
            _ => false,
        }
    }
    let mut text = String::new();
    let wrong = |message: String| Err(syn::Error::new_spanned(argument.extent, message));
    if !literal(argument, &mut text) {
        return wrong(
            "the exponent of `powi` must be a whole number written out: write `powi(x, 2)`, and `exp` and `ln` for \
             others"
                .to_owned(),
        );
    }
    match text.replace('_', "").parse::<i32>() {
        Ok(exponent) if exponent.unsigned_abs() <= LARGEST_EXPONENT => Ok(exponent),
        Ok(_) => wrong(format!(
            "an exponent goes from -{LARGEST_EXPONENT} to {LARGEST_EXPONENT}"
        )),
        Err(_) if text.trim_start_matches('-') == "0.5" => {
            wrong("the exponent of `powi` must be a whole number: write `sqrt(x)` for a square root".to_owned())
        }
        Err(_) => wrong(format!(
            "the exponent of `powi` must be a whole number, and `{text}` is not written as one: write `powi(x, 2)`"
        )),
    }
}

/// The error for a token that follows a complete formula.
fn stray(input: ParseStream<'_>, context: Context) -> syn::Error {
    if input.peek(Token![==]) {
        return input.error(match context {
            Context::RightSide => "an equation has one `==`: write the second one as another equation",
            Context::Value => "a definition is not an equation: write the equation as a statement of its own",
            _ => "an equation is a statement: write it alone, not within a formula",
        });
    }
    if input.peek(Token![=]) && !input.peek(Token![=>]) {
        return input.error(if context == Context::LeftSide {
            "a formula has no assignments: write `==` for an equation, or `let x = …;` for an abbreviation"
        } else {
            "unexpected `=` within a formula: write an equation or a `let` as a statement of its own"
        });
    }
    let message = if input.peek(Token![+=])
        || input.peek(Token![-=])
        || input.peek(Token![*=])
        || input.peek(Token![/=])
    {
        "a quantity cannot be assigned, because it does not change: write `==` for an equation"
    } else if input.peek(Token![^]) {
        "there is no operator `^`: write `powi(x, 2)` for a power"
    } else if input.peek(Token![%]) {
        "there is no remainder here: it has no derivative, and angles need none"
    } else if input.peek(Token![<<]) || input.peek(Token![>>]) {
        "there are no bit operations here: write `* powi(2, n)`"
    } else if input.peek(Token![!=]) || input.peek(Token![<]) || input.peek(Token![>]) {
        if context == Context::RangeEnd {
            "a range has one comparison: write `in 0..=PI` for a range with two ends"
        } else {
            "there are no comparisons here: write `==` for an equation, and `where` after an unknown to choose its \
             branch"
        }
    } else if input.peek(Token![&&]) || input.peek(Token![||]) {
        if context == Context::RangeEnd {
            "a range has one comparison: write `in 0..=PI` for a range with two ends"
        } else {
            "there are no conditions here: write each equation as a statement of its own"
        }
    } else if input.peek(Token![&]) || input.peek(Token![|]) {
        "there are no bit operations here: write only `+`, `-`, `*` and `/`"
    } else if input.peek(Token![..]) {
        "a range belongs to an unknown: write `unknown x: Angle in 0..=PI`"
    } else if input.peek(Token![as]) {
        "numbers are not converted here: write the name alone, all quantities have one numeric type"
    } else if input.peek(Token![->]) || input.peek(Token![=>]) {
        "an arrow has no meaning in a formula: write only `+`, `-`, `*` and `/`"
    } else if input.peek(Token![,]) {
        if context == Context::Parenthesis {
            "there are no tuples here: write `vec2(x, y)` for a plane vector, `vec3(x, y, z)` for a space vector"
        } else {
            "an expression ends before this `,`: write `;` before a further statement, and a point in a number, as in \
             `0.5`"
        }
    } else if context == Context::RangeStart {
        "a range has dots between its ends: write `in 0..=PI`"
    } else if input.peek(Token![:]) {
        "a formula takes no types: write `input`, `unknown` or `output` before a name to declare it"
    } else if input.peek(token::Brace) {
        "a formula has no blocks: write `( … )` to group"
    } else if input.peek(Token![!]) {
        "there are no macros or conditions here: write only formulas"
    } else if input.peek(Ident::peek_any) || input.peek(Lit) {
        if matches!(context, Context::Parenthesis | Context::Argument) {
            "an operator is missing before this: write `*` for a product"
        } else {
            "an operator or a `;` is missing: write `;` before this if it begins a statement, `*` if a product is meant"
        }
    } else {
        "unexpected in a formula: write `+`, `-`, `*` or `/`, or `;` to end the statement"
    };
    input.error(message)
}
