//! Tokens to syntax tree. Spans are kept. Only mistakes that a single statement shows by itself are checked here.
//!
//! The body is first cut at its semicolons, and each statement is parsed alone. So a mistake in one statement hides no
//! mistake in another.

mod callee;
mod chain;
mod comment;
mod dimension;
mod elsewhere;
mod formula;
mod frame;
mod frames;
mod fresh;
mod head;
mod name;
mod nesting;
mod order;
mod picture;
mod print;
mod repetition;
mod request;
mod rewrite;
mod runtime;
mod shape;
mod split;
mod statement;

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use syn::{Attribute, Visibility};

use crate::algebra::Function;
use crate::mistakes::{Extent, Mistakes};

pub(crate) use callee::{form, function_names, is_function};
pub use dimension::{Dimension, ValueShape};
pub(crate) use elsewhere::instead_of_request;
pub(crate) use frames::is_frame;
use fresh::FreshNames;
pub(crate) use name::keyword as is_keyword;
#[cfg(feature = "text")]
pub(crate) use name::parse as parse_name;
pub(crate) use request::Request;
pub(crate) use runtime::runtime;
pub(crate) use shape::shape;

/// The contents of the braces of `mechanism! { … }`.
#[expect(clippy::struct_excessive_bools, reason = "each is another fact about the text")]
pub(crate) struct Declaration {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) visibility: Visibility,
    pub(crate) name: Ident,
    pub(crate) parameters: Vec<ParameterField>,
    /// The fields of the struct as typed.
    pub(crate) fields: Vec<TokenStream>,
    /// The statements as typed, readable or not.
    pub(crate) source: Vec<TokenStream>,
    pub(crate) statements: Vec<Statement>,
    /// Names whose declarations could not be read. Their uses are not mistakes.
    pub(crate) broken: BTreeSet<String>,
    /// Names that occur in unreadable statements. They may be in use.
    pub(crate) mentioned: BTreeSet<String>,
    /// The names that the copies of a `for` and frames have instead of written ones.
    pub(crate) fresh: FreshNames,
    /// Whether the fields of the struct could be separated. If not, any name may be one of them.
    pub(crate) has_fields: bool,
    /// Whether every statement and field could be read.
    pub(crate) complete: bool,
    /// Whether a formula ends too early. The names that it would have used are unknown.
    pub(crate) breaks_off: bool,
    /// Whether prose stands among the statements, so that further mistakes would only follow from it.
    pub(crate) holds_prose: bool,
}

/// A field of the struct.
pub(crate) struct ParameterField {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) visibility: Visibility,
    pub(crate) name: Ident,
    /// `None` where a mistake has been reported.
    pub(crate) dimension: Option<Dimension>,
}

/// One statement of the body.
#[derive(Clone)]
pub(crate) enum Statement {
    Inputs(Vec<QuantityItem>),
    Unknowns(Vec<UnknownItem>),
    Let(LetStatement),
    /// Only while it is read: `frames.rs` writes it out.
    Frame(FrameStatement),
    Equation(EquationStatement),
    Output(OutputStatement),
    Order(OrderStatement),
    /// `with transmission_angles`: the names as typed.
    Requests(Vec<Ident>),
    Body(BodyStatement),
    Ground(GroundStatement),
    Slide(SlideStatement),
    /// Before the copies that a `for` stands for: what each of its names that occur in formulas stands for.
    Repeats(Vec<Vec<TypedFormula>>),
    /// Behind these copies.
    Repeated,
}

/// `let platform = frame(center, rotation)`
#[derive(Clone)]
pub(crate) struct FrameStatement {
    name: Ident,
    origin: TypedFormula,
    rotation: TypedFormula,
}

/// `body rod: pin, piston`
#[derive(Clone)]
pub(crate) struct BodyStatement {
    pub(crate) name: Ident,
    pub(crate) points: Vec<TypedFormula>,
}

/// `ground 0, pivot`
#[derive(Clone)]
pub(crate) struct GroundStatement {
    pub(crate) word: Span,
    pub(crate) points: Vec<TypedFormula>,
}

/// `slide piston along vec2(1, 0)`, and `on lever` if a body carries the line
#[derive(Clone)]
pub(crate) struct SlideStatement {
    pub(crate) point: TypedFormula,
    pub(crate) direction: TypedFormula,
    pub(crate) guide: Option<Ident>,
}

/// `theta2: Angle`
#[derive(Clone)]
pub(crate) struct QuantityItem {
    pub(crate) documentation: Vec<Attribute>,
    pub(crate) name: Ident,
    pub(crate) dimension: Dimension,
}

/// `e: Length where e > 0`
#[derive(Clone)]
pub(crate) struct UnknownItem {
    pub(crate) quantity: QuantityItem,
    pub(crate) range: Option<RangeClause>,
}

/// The range that picks the branch of an unknown.
#[derive(Clone)]
pub(crate) struct RangeClause {
    pub(crate) kind: RangeKind,
    pub(crate) extent: Extent,
}

#[derive(Clone)]
pub(crate) enum RangeKind {
    /// `where e > 0`
    Comparison {
        name: Ident,
        comparison: Relation,
        bound: TypedFormula,
    },
    /// `in 0..=PI`
    Between {
        low: TypedFormula,
        high: TypedFormula,
        closed: bool,
    },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Relation {
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
}

/// `let half = r3 / 2`
#[derive(Clone)]
pub(crate) struct LetStatement {
    pub(crate) name: Ident,
    pub(crate) value: TypedFormula,
}

/// `left == right`
#[derive(Clone)]
pub(crate) struct EquationStatement {
    pub(crate) left: TypedFormula,
    pub(crate) right: TypedFormula,
    /// The position of the `==`.
    pub(crate) operator: Extent,
    pub(crate) tokens: TokenStream,
    /// Whether it is one of the copies that a `for` stands for.
    pub(crate) is_copy: bool,
}

/// `output midpoint: Point = …`
#[derive(Clone)]
pub(crate) struct OutputStatement {
    pub(crate) documentation: Vec<Attribute>,
    pub(crate) name: Ident,
    pub(crate) dimension: Dimension,
    pub(crate) value: TypedFormula,
}

/// `order = 6`
#[derive(Clone)]
pub(crate) struct OrderStatement {
    pub(crate) order: usize,
    pub(crate) extent: Extent,
}

/// A formula with its position in the source.
#[derive(Clone)]
pub(crate) struct TypedFormula {
    pub(crate) kind: FormulaKind,
    pub(crate) extent: Extent,
    /// The depth of nested formulas below this one.
    depth: usize,
}

#[derive(Clone)]
pub(crate) enum FormulaKind {
    /// A literal as it was typed.
    Number {
        value: f64,
        text: String,
    },
    /// An angle in degrees, `30deg`.
    Degrees {
        value: f64,
        text: String,
    },
    Pi,
    Name(Ident),
    Negate(Box<TypedFormula>),
    /// Any number of operands between `+` and `-`. So a long sum is not a deep one.
    Sum {
        first: Box<TypedFormula>,
        rest: Vec<Operand>,
    },
    /// Any number of operands between `*` and `/`.
    Product {
        first: Box<TypedFormula>,
        rest: Vec<Operand>,
    },
    Call {
        callee: Callee,
        arguments: Vec<TypedFormula>,
        /// Whether it was typed `x.f()` and not `f(x)`.
        method: bool,
    },
    /// `powi(x, 2)`. The exponent is part of the form, not a value in the formula.
    Power {
        base: Box<TypedFormula>,
        exponent: i32,
        method: bool,
    },
    /// `p.x`, `p.y` or `p.z`
    Part {
        of: Box<TypedFormula>,
        axis: Axis,
    },
    Parenthesis(Box<TypedFormula>),
}

/// An operator with the operand behind it.
#[derive(Clone)]
pub(crate) struct Operand {
    pub(crate) operator: ArithmeticOperator,
    /// The position of the operator.
    pub(crate) span: Span,
    pub(crate) formula: TypedFormula,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ArithmeticOperator {
    Add,
    Subtract,
    Multiply,
    Divide,
}

/// An axis along which a vector has a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third, which only vectors of space have.
    Z,
}

/// A function other than `powi`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Callee {
    Elementary(Function),
    Cis,
    Polar,
    Vec2,
    Vec3,
    RotX,
    RotY,
    RotZ,
    Rot,
    Dot,
    Cross,
    Norm,
}

/// Reads a declaration. Mistakes are added to `mistakes`. The readable part is returned even then; the result is `None`
/// only if there is no struct.
pub(crate) fn parse(tokens: TokenStream, mistakes: &mut Mistakes) -> Option<Declaration> {
    let tokens = nesting::cut(tokens, mistakes);
    let Some((mark, tokens)) = comment::without_mark(&tokens) else {
        return read(tokens, mistakes);
    };
    let mut following = Mistakes::new();
    let declaration = read(tokens, &mut following);
    following.forget();
    mistakes.error_at(mark, "comments begin with `//`");
    declaration.map(|declaration| Declaration {
        complete: false,
        holds_prose: true,
        ..declaration
    })
}

/// Reads a declaration without comments of other languages.
fn read(tokens: TokenStream, mistakes: &mut Mistakes) -> Option<Declaration> {
    let (mut declaration, body) = head::parse(tokens, mistakes)?;
    declaration.fresh.take(&body);
    for field in &declaration.fields {
        declaration.fresh.take(field);
    }
    let mut repetitions = Vec::new();
    for chunk in split::statements(body, mistakes) {
        declaration.source.push(chunk.tokens.clone());
        if nesting::is_cut(&chunk.tokens) {
            declaration.poison(&chunk.tokens);
            declaration.breaks_off = true;
            continue;
        }
        if chunk.is_repetition() {
            repetitions.extend(repetition::read(&chunk.tokens, &mut declaration, mistakes));
            continue;
        }
        let statement = declaration.statement(&chunk, mistakes);
        declaration.statements.extend(statement);
    }
    repetition::check_names(&repetitions, &mut declaration, mistakes);
    frames::write_out(&mut declaration, mistakes);
    Some(declaration)
}

/// The names of an equation, readable or not.
pub(crate) struct Mentions {
    pub(crate) names: BTreeSet<String>,
    /// The name that is the whole left side.
    pub(crate) alone: Option<String>,
}

impl Declaration {
    /// The statements that are equations, or might become equations.
    pub(crate) fn equations(&self) -> Vec<Mentions> {
        let is_equation = |tokens: &&TokenStream| {
            let mut tokens = (*tokens).clone().into_iter();
            let (first, second) = (tokens.next(), tokens.next());
            if matches!(&first, Some(TokenTree::Ident(word)) if word == "for") {
                return true;
            }
            !matches!(
                (first, second),
                (Some(TokenTree::Ident(_)), Some(TokenTree::Ident(_))) | (None, _)
            )
        };
        let equations = self.source.iter().filter(is_equation);
        equations
            .map(|tokens| {
                let mut names = BTreeSet::new();
                split::mentioned_names(tokens, &mut names);
                let start: Vec<TokenTree> = tokens.clone().into_iter().take(2).collect();
                let alone = match start.as_slice() {
                    [TokenTree::Ident(name), TokenTree::Punct(equals)] if equals.as_char() == '=' => {
                        Some(name.to_string())
                    }
                    _ => None,
                };
                Mentions { names, alone }
            })
            .collect()
    }

    /// The names of all quantities.
    fn quantity_names(&self) -> BTreeSet<String> {
        let mut names: BTreeSet<String> = self.parameters.iter().map(|field| field.name.to_string()).collect();
        for statement in &self.statements {
            match statement {
                Statement::Inputs(items) => names.extend(items.iter().map(|item| item.name.to_string())),
                Statement::Unknowns(items) => names.extend(items.iter().map(|item| item.quantity.name.to_string())),
                Statement::Let(statement) => drop(names.insert(statement.name.to_string())),
                Statement::Output(output) => drop(names.insert(output.name.to_string())),
                _ => {}
            }
        }
        names
    }

    /// The shapes of all quantities but abbreviations and outputs.
    fn shapes(&self) -> BTreeMap<String, ValueShape> {
        let parameters = self.parameters.iter();
        let mut shapes: BTreeMap<String, ValueShape> = parameters
            .filter_map(|field| Some((field.name.to_string(), field.dimension?.shape())))
            .collect();
        for statement in &self.statements {
            match statement {
                Statement::Inputs(items) => {
                    shapes.extend(items.iter().map(|item| (item.name.to_string(), item.dimension.shape())));
                }
                Statement::Unknowns(items) => {
                    let quantities = items.iter().map(|item| &item.quantity);
                    shapes.extend(quantities.map(|item| (item.name.to_string(), item.dimension.shape())));
                }
                _ => {}
            }
        }
        shapes
    }

    /// Reads a statement other than a `for`.
    fn statement(&mut self, chunk: &split::Chunk, mistakes: &mut Mistakes) -> Option<Statement> {
        match statement::parse(chunk.tokens.clone()) {
            Ok(statement) => {
                if statement.is_some() && !chunk.terminated {
                    let last = last_span(&chunk.tokens);
                    mistakes.error_at(last, "a `;` is missing after this: every statement ends with `;`");
                }
                statement
            }
            Err(error) => {
                mistakes.push(error);
                self.poison(&chunk.tokens);
                None
            }
        }
    }

    /// Remembers the names in an unreadable stretch of source, so that they cause no further errors.
    fn poison(&mut self, tokens: &TokenStream) {
        self.complete = false;
        self.breaks_off |= matches!(tokens.clone().into_iter().last(), Some(TokenTree::Punct(_)));
        split::mentioned_names(tokens, &mut self.mentioned);
        split::declared_names(tokens, &mut self.broken);
    }
}

fn last_span(tokens: &TokenStream) -> Span {
    match tokens.clone().into_iter().last() {
        Some(TokenTree::Group(group)) => group.span_close(),
        Some(token) => token.span(),
        None => Span::call_site(),
    }
}

#[cfg(test)]
#[allow(clippy::needless_pass_by_value, reason = "formulas are quoted where they are passed")]
mod tests {
    use quote::quote;

    use super::*;

    /// The printed statements, or the mistakes.
    fn read(body: TokenStream) -> Result<Vec<String>, Vec<String>> {
        let mut mistakes = Mistakes::new();
        let declaration = parse(quote!(struct M { a: Length } #body), &mut mistakes);
        if !mistakes.is_empty() {
            return Err(mistakes.into_messages());
        }
        let statements = declaration.map(|declaration| declaration.statements);
        Ok(statements.iter().flatten().map(print).collect())
    }

    fn print(statement: &Statement) -> String {
        match statement {
            Statement::Inputs(items) => format!("{} inputs", items.len()),
            Statement::Unknowns(items) => items
                .iter()
                .map(|item| match &item.range {
                    None => item.quantity.name.to_string(),
                    Some(range) => range.text(&item.quantity.name.to_string()),
                })
                .collect::<Vec<_>>()
                .join(", "),
            Statement::Let(statement) => format!("let {} = {}", statement.name, statement.value),
            Statement::Equation(equation) => equation.to_string(),
            Statement::Output(output) => {
                format!("output {}: {} = {}", output.name, output.dimension.word(), output.value)
            }
            Statement::Order(statement) => format!("order = {}", statement.order),
            Statement::Requests(names) => {
                let names: Vec<String> = names.iter().map(Ident::to_string).collect();
                format!("with {}", names.join(", "))
            }
            Statement::Body(body) => format!("body {}: {}", body.name, list(&body.points)),
            Statement::Ground(ground) => format!("ground {}", list(&ground.points)),
            Statement::Slide(slide) => {
                let guide = slide
                    .guide
                    .as_ref()
                    .map_or(String::new(), |guide| format!(" on {guide}"));
                format!("slide {} along {}{guide}", slide.point, slide.direction)
            }
            Statement::Frame(_) => unreachable!("frames are written out"),
            Statement::Repeats(columns) => format!("{} names", columns.len()),
            Statement::Repeated => "end".to_owned(),
        }
    }

    fn list(points: &[TypedFormula]) -> String {
        let points: Vec<String> = points.iter().map(TypedFormula::to_string).collect();
        points.join(", ")
    }

    /// The formula with parentheses around every operation.
    fn grouping(formula: &TypedFormula) -> String {
        match &formula.kind {
            FormulaKind::Negate(of) => format!("(-{})", grouping(of)),
            FormulaKind::Sum { first, rest } | FormulaKind::Product { first, rest } => {
                rest.iter().fold(grouping(first), |left, operation| {
                    format!(
                        "({left} {} {})",
                        operation.operator.symbol(),
                        grouping(&operation.formula)
                    )
                })
            }
            FormulaKind::Parenthesis(inner) => grouping(inner),
            _ => formula.to_string(),
        }
    }

    fn grouped(formula: TokenStream) -> String {
        let mut mistakes = Mistakes::new();
        let declaration = parse(quote!(struct M { a: Length } let v = #formula;), &mut mistakes);
        assert!(mistakes.is_empty(), "{:?}", mistakes.into_messages());
        match declaration
            .as_ref()
            .map(|declaration| declaration.statements.as_slice())
        {
            Some([Statement::Let(statement)]) => grouping(&statement.value),
            _ => String::new(),
        }
    }

    fn mistakes(body: TokenStream) -> Vec<String> {
        read(body).err().unwrap_or_default()
    }

    #[test]
    fn statements_print_as_they_were_written() {
        let body = quote! {
            input t: Angle, u: Scalar,;
            unknown e: Length where e>0, g: Angle in 0.0..=PI;
            /// A doc comment.
            unknown h: Angle in -PI/2..PI;
            let half=a/2;
            a*cis(t)+-polar(2.5f64*e,g).times==0;
        };
        assert_eq!(mistakes(body).len(), 1);
        let body = quote! {
            input t: Angle, u: Scalar,;
            unknown e: Length where e>0, g: Angle in 0.0..=PI;
            /// A doc comment.
            unknown h: Angle in -PI/2..PI;
            let half=a/2;
            a*cis(t)+-polar(2.5f64*e,g)==(vec2(half,0)*t.cis()).x-e.powi(-2);
            output p: Point = h.sin()*y.atan2(x)*1e-3;
            order=6;
        };
        assert_eq!(
            read(body).unwrap_or_default(),
            [
                "2 inputs",
                "e > 0, g in 0.0..=PI",
                "h in -PI / 2..PI",
                "let half = a / 2",
                "a * cis(t) + -polar(2.5f64 * e, g) == (vec2(half, 0) * t.cis()).x - e.powi(-2)",
                "output p: Point = h.sin() * y.atan2(x) * 1e-3",
                "order = 6",
            ]
        );
    }

    #[test]
    fn order_is_a_name_where_it_is_no_statement() {
        let body = quote! {
            input order: Angle;
            order == x;
            order * x == y;
            order.sin() == order;
            let order = half / 2;
            let half = order / 2;
        };
        assert_eq!(
            read(body).unwrap_or_default(),
            [
                "1 inputs",
                "order == x",
                "order * x == y",
                "order.sin() == order",
                "let order = half / 2",
                "let half = order / 2"
            ]
        );
    }

    #[test]
    fn an_order_is_a_small_whole_number() {
        assert_eq!(
            read(quote!(order = 1; order = 1_2;)).unwrap_or_default(),
            ["order = 1", "order = 12"]
        );
        for (body, expected) in [
            (quote!(order = 0;), "`order = 1`"),
            (quote!(order = -1;), "never negative"),
            (quote!(order = 13;), "the highest order is 12"),
            (quote!(order = 99999999999999999999;), "the highest order is 12"),
            (quote!(order = 6.0;), "a whole number from 1 to 12"),
            (quote!(order = 6usize;), "write `order = 6`"),
            (quote!(order = x;), "a whole number from 1 to 12"),
            (quote!(order = 3 + 3;), "a whole number from 1 to 12"),
            (quote!(order = ;), "the order is missing"),
            (quote!(order 6;), "write `order = 6`"),
            (quote!(order: 6;), "write `order = 6`"),
        ] {
            let messages = mistakes(body.clone());
            assert_eq!(messages.len(), 1, "{body}: {messages:#?}");
            assert!(messages[0].contains(expected), "{body}: {messages:#?}");
        }
    }

    #[test]
    fn requests_begin_with_a_word_that_is_not_reserved() {
        let read = |body: TokenStream| read(body).unwrap_or_default();
        assert_eq!(read(quote!(with test, sensitivities,;)), ["with test, sensitivities"]);
        assert_eq!(
            read(quote!(let with = a; with == 2 * with; with.sin() + a == with;)),
            ["let with = a", "with == 2 * with", "with.sin() + a == with"]
        );
        for (wrong, expected) in [
            (quote!(with;), "nothing is requested after this"),
            (quote!(with, test;), "expected a name"),
            (quote!(with test sensitivities;), "unexpected in a request"),
            (quote!(with test, 2;), "expected a name"),
            (quote!(wiht test;), "did you mean `with`?"),
            (quote!(a == a with test;), "write `;` before this `with`"),
        ] {
            let messages = mistakes(wrong.clone());
            assert_eq!(messages.len(), 1, "{wrong}: {messages:#?}");
            assert!(messages[0].contains(expected), "{wrong}: {messages:#?}");
        }
    }

    #[test]
    fn every_function_can_be_called() {
        for function in Function::ALL {
            assert!(function_names().any(|name| name == function.name()));
        }
        for name in function_names() {
            // `powi` alone is not a function: its exponent is part of its form
            let callee = Callee::from_name(name);
            assert_eq!(callee.map(Callee::name), (name != "powi").then_some(name));
            let form = form(name).expect("it can be called");
            assert_eq!(callee.map_or(2, Callee::arity), form.matches(',').count() + 1, "{name}");
            assert!(form.starts_with(&format!("{name}(")));
        }
    }

    #[test]
    fn operators_bind_as_in_rust() {
        assert_eq!(grouped(quote!(a - b - c * d / e)), "((a - b) - ((c * d) / e))");
        assert_eq!(grouped(quote!(-a * b)), "((-a) * b)");
        assert_eq!(grouped(quote!(-a.sin())), "(-a.sin())");
        assert_eq!(grouped(quote!(a / (b - c) * d)), "((a / (b - c)) * d)");
        assert_eq!(grouped(quote!(a - -b)), "(a - (-b))");
    }

    #[test]
    fn every_statement_tells_its_own_mistake() {
        let messages = mistakes(quote! {
            input type: Angle;
            unknown b;
            a = b;
            a == b == c;
            a[0] == b;
            let x == 3;
            unknown c: Point;
        });
        assert_eq!(messages.len(), 7, "{messages:#?}");
    }

    #[test]
    fn a_missing_semicolon_is_reported_once() {
        let messages = mistakes(quote!(a == b unknown c: Angle; let d = c output e: Angle = d;));
        assert_eq!(
            messages,
            [
                "a `;` is missing: write `;` before this `unknown`",
                "a `;` is missing: write `;` before this `output`"
            ]
        );
        assert_eq!(
            mistakes(quote!(a == b)),
            ["a `;` is missing after this: every statement ends with `;`"]
        );
        assert_eq!(mistakes(quote!(a == b c == d;)).len(), 1);
        assert_eq!(
            mistakes(quote!(a == b order = 6; order == a * order;)),
            ["a `;` is missing: write `;` before this `order`"]
        );
    }

    #[test]
    fn unfinished_formulas_are_reported() {
        for body in [
            quote!(a == ;),
            quote!(== a;),
            quote!(a * == b;),
            quote!(a == b - ;),
            quote!(a == -;),
            quote!(a == (b * );),
            quote!(a == sin(,);),
            quote!(a == sin();),
            quote!(a == ();),
            quote!(a == b.;),
            quote!(a == b.sin;),
            quote!(a;),
            quote!(let;),
            quote!(let b;),
            quote!(let b = ;),
            quote!(input;),
            quote!(input b:;),
            quote!(unknown b: Angle in;),
            quote!(unknown b: Angle in 0..;),
            quote!(unknown b: Angle in ..1;),
            quote!(unknown b: Angle where;),
            quote!(unknown b: Angle where b;),
            quote!(unknown b: Angle where b >;),
            quote!(unknown b: Angle where 0 < b;),
            quote!(output b: Angle;),
            quote!(output b = a;),
        ] {
            let messages = mistakes(body.clone());
            assert_eq!(messages.len(), 1, "{body}: {messages:#?}");
            assert!(
                !messages[0].starts_with("unexpected end") && !messages[0].starts_with("unexpected token"),
                "{body}: {messages:#?}"
            );
        }
    }

    #[test]
    fn fragments_of_other_macros_keep_their_unity() {
        let sum = proc_macro2::Group::new(proc_macro2::Delimiter::None, quote!(a + b));
        let name = proc_macro2::Group::new(proc_macro2::Delimiter::None, quote!(c));
        assert_eq!(grouped(quote!(2 * #sum * #name)), "((2 * (a + b)) * c)");
    }

    #[test]
    fn the_struct_is_checked_too() {
        let read = |tokens: TokenStream| {
            let mut mistakes = Mistakes::new();
            let declaration = parse(tokens, &mut mistakes);
            (declaration.is_some(), mistakes.into_messages().len())
        };
        assert_eq!(read(quote!()), (false, 1));
        assert_eq!(read(quote!(input a: Angle;)), (false, 1));
        assert_eq!(read(quote!(struct;)), (false, 1));
        assert_eq!(read(quote!(struct M)), (true, 1));
        assert_eq!(
            read(quote!(
                struct M;
            )),
            (true, 1)
        );
        assert_eq!(
            read(quote!(
                struct M(Length);
            )),
            (true, 1)
        );
        assert_eq!(
            read(quote!(
                struct M {}
            )),
            (true, 1)
        );
        assert_eq!(
            read(quote!(
                struct M<T>
                where
                    T: Copy,
                {
                    a: T,
                }
            )),
            (true, 2)
        );
        assert_eq!(
            read(quote!(struct M { a: Length, b: f64, c: Vec<f64, g>, d, pub })),
            (true, 4)
        );
        assert_eq!(read(quote!(pub struct M { pub a: Length pub b: Length })), (true, 1));
    }
}
