//! The equations themselves, to be put to the proof.
//!
//! They are translated from the syntax tree, operator by operator, and not from the graph from which everything else is derived:
//! what is left of them at a solution is an independent check of the algebra.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};

use crate::function::Function;
use crate::model::{Dimension, Model};
use crate::syntax::{Axis, Callee, Declaration, EquationStatement, Expression, ExpressionKind, Operator, Statement};

/// How tightly a translated formula holds together, to set parentheses where they are needed and nowhere else.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

/// A formula in Rust.
#[derive(Clone)]
pub(super) struct Translated {
    pub(super) plane: bool,
    pub(super) binding: Binding,
    pub(super) tokens: TokenStream,
}

impl Translated {
    pub(super) fn scalar(tokens: TokenStream) -> Self {
        Self {
            plane: false,
            binding: Binding::Atom,
            tokens,
        }
    }

    fn plane(tokens: TokenStream) -> Self {
        Self {
            plane: true,
            binding: Binding::Atom,
            tokens,
        }
    }

    /// In parentheses if it holds together less tightly than its place requires.
    pub(super) fn within(&self, place: Binding) -> TokenStream {
        let tokens = &self.tokens;
        if self.binding < place {
            quote_spanned!(Span::mixed_site()=> (#tokens))
        } else {
            tokens.clone()
        }
    }
}

/// The method `closure`.
pub(crate) fn tokens(declaration: &Declaration, model: &Model, runtime: &TokenStream) -> TokenStream {
    let equations: Vec<&EquationStatement> = declaration
        .statements
        .iter()
        .filter_map(|statement| match statement {
            Statement::Equation(equation) => Some(equation),
            _ => None,
        })
        .collect();
    let formulas = equations.iter().flat_map(|equation| [&equation.left, &equation.right]);
    let used = used_names(declaration, formulas);
    let mut names = names(model);

    let site = Span::mixed_site();
    let unknowns = Ident::new("unknowns", site);
    let mut body = TokenStream::new();
    for input in &model.inputs {
        let name = &input.name;
        if !used.contains(&name.to_string()) {
            body.extend(quote_spanned!(site=> let _ = #name;));
        }
    }
    body.extend(bindings(declaration, model, runtime, &used, &mut names));
    let translation = Translation { names: &names, runtime };
    let mut residuals: Vec<TokenStream> = Vec::new();
    let mut lines: Vec<String> = Vec::new();
    for (number, equation) in equations.iter().enumerate() {
        let left = translation.expression(&equation.left);
        let right = translation.expression(&equation.right);
        let residual = translation.sum(Operator::Subtract, &left, &right);
        let index = residuals.len();
        let tokens = residual.tokens;
        if residual.plane {
            let local = format_ident!("equation_{number}", span = site);
            body.extend(quote_spanned!(site=> let #local = #tokens;));
            residuals.push(quote_spanned!(site=> #local.x));
            residuals.push(quote_spanned!(site=> #local.y));
            lines.push(format!("- `[{index}]` and `[{}]`: x and y of `{equation}`", index + 1));
        } else {
            residuals.push(tokens);
            lines.push(format!("- `[{index}]`: `{equation}`"));
        }
    }

    let inputs = model.inputs.iter().map(|input| &input.name);
    let unknown_count = Literal::usize_unsuffixed(model.unknowns.len());
    let residual_count = Literal::usize_unsuffixed(residuals.len());
    let order: Vec<String> = model.unknowns.iter().map(|unknown| unknown.name.to_string()).collect();
    let summary = format!(
        "What is left of the equations, left side less right, where the unknowns are `[{}]`: zero at a position of the mechanism.",
        order.join(", ")
    );
    // the lines follow the summary in one paragraph each, as a doc comment would have them
    let documentation = [summary, String::new()]
        .into_iter()
        .chain(lines)
        .map(|line| format!(" {line}"));
    quote_spanned! {site=>
        #(#[doc = #documentation])*
        #[must_use]
        #[allow(
            non_snake_case,
            clippy::many_single_char_names,
            clippy::similar_names,
            clippy::too_many_arguments,
            clippy::too_many_lines,
            clippy::unused_self
        )]
        pub fn closure(&self, #(#inputs: T,)* #unknowns: [T; #unknown_count]) -> [T; #residual_count] {
            #body
            [#(#residuals),*]
        }
    }
}

/// Binds the unknowns and the abbreviations that are used to local names, and adds the abbreviations to the names. The values of
/// the unknowns are called `unknowns`.
pub(super) fn bindings(
    declaration: &Declaration,
    model: &Model,
    runtime: &TokenStream,
    used: &BTreeSet<String>,
    names: &mut BTreeMap<String, Translated>,
) -> TokenStream {
    let site = Span::mixed_site();
    let unknowns = Ident::new("unknowns", site);
    let mut body = TokenStream::new();
    for (index, unknown) in model.unknowns.iter().enumerate() {
        if used.contains(&unknown.name.to_string()) {
            let index = Literal::usize_unsuffixed(index);
            let local = local("unknown", &unknown.name);
            body.extend(quote_spanned!(site=> let #local = #unknowns[#index];));
        }
    }
    for statement in &declaration.statements {
        if let Statement::Let(statement) = statement
            && used.contains(&statement.name.to_string())
        {
            let value = Translation { names, runtime }.expression(&statement.value);
            let local = local("let", &statement.name);
            let tokens = &value.tokens;
            body.extend(quote_spanned!(site=> let #local = #tokens;));
            names.insert(
                statement.name.to_string(),
                Translated {
                    plane: value.plane,
                    binding: Binding::Atom,
                    tokens: quote!(#local),
                },
            );
        }
    }
    body
}

/// Local names bear a prefix: a constant of the user's that is called like a parameter must not become a pattern.
pub(super) fn local(prefix: &str, name: &Ident) -> Ident {
    format_ident!("{prefix}_{name}", span = Span::mixed_site())
}

/// What the declared names are called in the method. Abbreviations are added as they are bound.
pub(super) fn names(model: &Model) -> BTreeMap<String, Translated> {
    let site = Span::mixed_site();
    let mut names = BTreeMap::new();
    for parameter in &model.parameters {
        let name = &parameter.name;
        let tokens = quote_spanned!(site=> self.#name);
        let translated = match parameter.dimension {
            Dimension::Point | Dimension::Vector => Translated::plane(tokens),
            Dimension::Length | Dimension::Angle | Dimension::Scalar => Translated::scalar(tokens),
        };
        names.insert(name.to_string(), translated);
    }
    for input in &model.inputs {
        let name = &input.name;
        names.insert(name.to_string(), Translated::scalar(quote!(#name)));
    }
    for unknown in &model.unknowns {
        let local = local("unknown", &unknown.name);
        names.insert(unknown.name.to_string(), Translated::scalar(quote!(#local)));
    }
    names
}

/// The names that formulas use, directly or by way of abbreviations.
pub(super) fn used_names<'a>(
    declaration: &'a Declaration,
    formulas: impl Iterator<Item = &'a Expression>,
) -> BTreeSet<String> {
    let mut used = BTreeSet::new();
    for formula in formulas {
        formula.visit_names(&mut |name| {
            used.insert(name.to_string());
        });
    }
    // an abbreviation stands after those that it uses
    for statement in declaration.statements.iter().rev() {
        if let Statement::Let(statement) = statement
            && used.contains(&statement.name.to_string())
        {
            statement.value.visit_names(&mut |name| {
                used.insert(name.to_string());
            });
        }
    }
    used
}

pub(super) struct Translation<'a> {
    pub(super) names: &'a BTreeMap<String, Translated>,
    pub(super) runtime: &'a TokenStream,
}

impl Translation<'_> {
    pub(super) fn expression(&self, expression: &Expression) -> Translated {
        let runtime = self.runtime;
        let site = Span::mixed_site();
        match &expression.kind {
            ExpressionKind::Number { value, .. } => Translated::scalar(self.constant(*value)),
            ExpressionKind::Pi => {
                Translated::scalar(quote_spanned!(site=> <T as #runtime::Scalar>::constant(::core::f64::consts::PI)))
            }
            // a name that is not there is a mistake that the model has reported
            ExpressionKind::Name(name) => self
                .names
                .get(&name.to_string())
                .cloned()
                .unwrap_or_else(|| Translated::scalar(quote!(#name))),
            ExpressionKind::Parenthesis(inner) => self.expression(inner),
            ExpressionKind::Negate(of) => {
                let of = self.expression(of);
                let operand = of.within(Binding::Atom);
                Translated {
                    plane: of.plane,
                    binding: Binding::Sign,
                    tokens: quote_spanned!(site=> -#operand),
                }
            }
            ExpressionKind::Binary {
                operator, left, right, ..
            } => {
                let (left, right) = (self.expression(left), self.expression(right));
                match operator {
                    Operator::Add | Operator::Subtract => self.sum(*operator, &left, &right),
                    Operator::Multiply => self.product(&left, &right),
                    Operator::Divide => self.quotient(&left, &right),
                }
            }
            ExpressionKind::Call { callee, arguments, .. } => self.call(*callee, arguments),
            ExpressionKind::Power { base, exponent, .. } => self.power(&self.expression(base), *exponent),
            ExpressionKind::Part { of, axis } => {
                let of = self.expression(of).within(Binding::Atom);
                Translated::scalar(match axis {
                    Axis::X => quote_spanned!(site=> #of.x),
                    Axis::Y => quote_spanned!(site=> #of.y),
                })
            }
        }
    }

    pub(super) fn constant(&self, value: f64) -> TokenStream {
        let runtime = self.runtime;
        let value = Literal::f64_unsuffixed(value);
        quote_spanned!(Span::mixed_site()=> <T as #runtime::Scalar>::constant(#value))
    }

    /// As a vector; a scalar lies along x.
    pub(super) fn on_plane(&self, of: &Translated) -> Translated {
        if of.plane {
            return of.clone();
        }
        let (runtime, x, zero) = (self.runtime, &of.tokens, self.constant(0.0));
        Translated::plane(quote_spanned!(Span::mixed_site()=> #runtime::Plane::new(#x, #zero)))
    }

    pub(super) fn sum(&self, operator: Operator, left: &Translated, right: &Translated) -> Translated {
        let plane = left.plane || right.plane;
        let (left, right) = if plane {
            (self.on_plane(left), self.on_plane(right))
        } else {
            (left.clone(), right.clone())
        };
        let (left, right) = (left.within(Binding::Sum), right.within(Binding::Product));
        let site = Span::mixed_site();
        Translated {
            plane,
            binding: Binding::Sum,
            tokens: if operator == Operator::Subtract {
                quote_spanned!(site=> #left - #right)
            } else {
                quote_spanned!(site=> #left + #right)
            },
        }
    }

    fn product(&self, left: &Translated, right: &Translated) -> Translated {
        let runtime = self.runtime;
        let site = Span::mixed_site();
        let (a, b) = (&left.tokens, &right.tokens);
        match (left.plane, right.plane) {
            (false, false) => {
                let (a, b) = (left.within(Binding::Product), right.within(Binding::Sign));
                Translated {
                    plane: false,
                    binding: Binding::Product,
                    tokens: quote_spanned!(site=> #a * #b),
                }
            }
            (true, false) => Translated::plane(quote_spanned!(site=> #runtime::Plane::scale(#a, #b))),
            (false, true) => Translated::plane(quote_spanned!(site=> #runtime::Plane::scale(#b, #a))),
            (true, true) => Translated::plane(quote_spanned!(site=> #runtime::Plane::times(#a, #b))),
        }
    }

    fn quotient(&self, left: &Translated, right: &Translated) -> Translated {
        let site = Span::mixed_site();
        let divisor = right.within(Binding::Sign);
        if left.plane {
            let (runtime, plane, one) = (self.runtime, &left.tokens, self.constant(1.0));
            return Translated::plane(quote_spanned!(site=> #runtime::Plane::scale(#plane, #one / #divisor)));
        }
        let dividend = left.within(Binding::Product);
        Translated {
            plane: false,
            binding: Binding::Product,
            tokens: quote_spanned!(site=> #dividend / #divisor),
        }
    }

    fn call(&self, callee: Callee, arguments: &[Expression]) -> Translated {
        let runtime = self.runtime;
        let site = Span::mixed_site();
        let arguments: Vec<TokenStream> = arguments
            .iter()
            .map(|argument| self.expression(argument).tokens)
            .collect();
        let turned = |angle: &TokenStream| {
            quote_spanned! {site=> {
                let (sine, cosine) = #runtime::Scalar::sin_cos(#angle);
                #runtime::Plane::new(cosine, sine)
            }}
        };
        match (callee, arguments.as_slice()) {
            (Callee::Cis, [angle]) => Translated::plane(turned(angle)),
            (Callee::Polar, [length, angle]) => {
                let turned = turned(angle);
                Translated::plane(quote_spanned!(site=> #runtime::Plane::scale(#turned, #length)))
            }
            (Callee::Elementary(Function::Sin), [x]) => {
                Translated::scalar(quote_spanned!(site=> #runtime::Scalar::sin_cos(#x).0))
            }
            (Callee::Elementary(Function::Cos), [x]) => {
                Translated::scalar(quote_spanned!(site=> #runtime::Scalar::sin_cos(#x).1))
            }
            (Callee::Elementary(Function::Tan), [x]) => Translated::scalar(quote_spanned! {site=> {
                let (sine, cosine) = #runtime::Scalar::sin_cos(#x);
                sine / cosine
            }}),
            (Callee::Elementary(function), arguments) => {
                let method = Ident::new(function.name(), site);
                Translated::scalar(quote_spanned!(site=> #runtime::Scalar::#method(#(#arguments),*)))
            }
            (_, arguments) => Translated::plane(quote_spanned!(site=> #runtime::Plane::new(#(#arguments),*))),
        }
    }

    /// By repeated squaring, written out.
    fn power(&self, base: &Translated, exponent: i32) -> Translated {
        let site = Span::mixed_site();
        let base = &base.tokens;
        let size = exponent.unsigned_abs();
        if size == 0 {
            return Translated::scalar(self.constant(1.0));
        }
        let power = |n: u32| format_ident!("power_{n}", span = site);
        let mut squares = TokenStream::new();
        let mut factors = vec![];
        let mut reached = 1;
        loop {
            let name = power(reached);
            if size & reached != 0 {
                factors.push(quote!(#name));
            }
            if reached > size / 2 {
                break;
            }
            reached *= 2;
            let square = power(reached);
            squares.extend(quote_spanned!(site=> let #square = #name * #name;));
        }
        let first = power(1);
        let (leading, further) = (&factors[..1], &factors[1..]);
        let product = quote_spanned!(site=> #(#leading)* #(* #further)*);
        let result = if exponent < 0 {
            let one = self.constant(1.0);
            let divisor = if factors.len() > 1 {
                quote_spanned!(site=> (#product))
            } else {
                product
            };
            quote_spanned!(site=> #one / #divisor)
        } else {
            product
        };
        Translated::scalar(quote_spanned! {site=> {
            let #first = #base;
            #squares
            #result
        }})
    }
}

#[cfg(test)]
#[allow(clippy::needless_pass_by_value, reason = "formulas are quoted where they are passed")]
mod tests {
    use super::*;
    use crate::model;
    use crate::report::Report;
    use crate::syntax;

    fn body(statements: TokenStream) -> String {
        let mut report = Report::new();
        let tokens = quote! {
            struct M { a: Length, b: Length, k: Scalar, p: Point }
            #statements
            output all: Vector = k * (p + a + b);
        };
        let declaration = syntax::parse(tokens, &mut report);
        let model = declaration
            .as_ref()
            .and_then(|declaration| model::build(declaration, &mut report));
        let (Some(declaration), Some(model)) = (declaration, model) else {
            panic!("{:?}", report.into_messages());
        };
        let method = super::tokens(&declaration, &model, &quote!(rt));
        let start = method.to_string().find("-> [").unwrap_or_default();
        method.to_string()[start..].replace("< T as rt :: Scalar > :: ", "")
    }

    #[test]
    fn powers_are_multiplied_out() {
        let powers = |n: TokenStream| body(quote!(input t: Angle; unknown e: Scalar; powi(e, #n) == t;));
        assert_eq!(
            powers(quote!(1)),
            "-> [T ; 1] { let unknown_e = unknowns [0] ; [{ let power_1 = unknown_e ; power_1 } - t] }"
        );
        assert_eq!(
            powers(quote!(5)),
            "-> [T ; 1] { let unknown_e = unknowns [0] ; [{ let power_1 = unknown_e ; let power_2 = power_1 * power_1 ; \
             let power_4 = power_2 * power_2 ; power_1 * power_4 } - t] }"
        );
        assert_eq!(
            powers(quote!(-6)),
            "-> [T ; 1] { let unknown_e = unknowns [0] ; [{ let power_1 = unknown_e ; let power_2 = power_1 * power_1 ; \
             let power_4 = power_2 * power_2 ; constant (1.0) / (power_2 * power_4) } - t] }"
        );
    }

    #[test]
    fn parentheses_stand_where_they_are_needed() {
        assert_eq!(
            body(quote!(input t: Angle; unknown e: Length; ((a)) - (b - e) * -(t) == -(-(a)) / (k * k);)),
            "-> [T ; 1] { let unknown_e = unknowns [0] ; \
             [self . a - (self . b - unknown_e) * - t - - (- self . a) / (self . k * self . k)] }"
        );
    }

    #[test]
    fn scalars_beside_vectors_lie_along_x() {
        assert_eq!(
            body(quote! {
                input t: Angle; unknown e: Angle; unknown l: Length;
                let wheel = b * cis(e) / 2;
                let idle = p.x * t;
                p * cis(t) - a == wheel + l;
                output q: Length = idle;
            }),
            "-> [T ; 2] { let unknown_e = unknowns [0] ; let unknown_l = unknowns [1] ; \
             let let_wheel = rt :: Plane :: scale (rt :: Plane :: scale ({ \
             let (sine , cosine) = rt :: Scalar :: sin_cos (unknown_e) ; rt :: Plane :: new (cosine , sine) } , self . b) , \
             constant (1.0) / constant (2.0)) ; \
             let equation_0 = rt :: Plane :: times (self . p , { \
             let (sine , cosine) = rt :: Scalar :: sin_cos (t) ; rt :: Plane :: new (cosine , sine) }) \
             - rt :: Plane :: new (self . a , constant (0.0)) \
             - (let_wheel + rt :: Plane :: new (unknown_l , constant (0.0))) ; [equation_0 . x , equation_0 . y] }"
        );
    }

    #[test]
    fn inputs_of_outputs_alone_leave_no_warning() {
        let body = body(quote!(input t: Angle, u: Length; unknown e: Angle; e == t; output v: Length = 2 * u;));
        assert_eq!(
            body,
            "-> [T ; 1] { let _ = u ; let unknown_e = unknowns [0] ; [unknown_e - t] }"
        );
    }
}
