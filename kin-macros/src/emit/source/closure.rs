//! The equations themselves, to be put to the proof.
//!
//! They are translated from the syntax tree, operator by operator, and not from the graph from which everything else is derived:
//! what is left of them at a solution is an independent check of the algebra.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};

use crate::algebra::{Calculation, Function};
use crate::emit::declaration::vector_type;
use crate::model::{Model, Shape};
use crate::precedence::Precedence;
use crate::syntax::{Callee, Declaration, EquationStatement, Formula, FormulaKind, Operand, Operator, Statement};

/// So many operands stand in a row, each of which nests the formula deeper, before what they come to gets a name.
const LONGEST: usize = 256;

/// A formula in Rust.
#[derive(Clone)]
pub(super) struct Translated {
    pub(super) shape: Shape,
    pub(super) precedence: Precedence,
    pub(super) tokens: TokenStream,
    /// The angle of a unit vector that was typed as `cis(angle)`.
    angle: Option<TokenStream>,
}

impl Translated {
    pub(super) fn new(shape: Shape, tokens: TokenStream) -> Self {
        Self {
            shape,
            precedence: Precedence::Atom,
            tokens,
            angle: None,
        }
    }

    pub(super) fn scalar(tokens: TokenStream) -> Self {
        Self::new(Shape::Scalar, tokens)
    }

    fn plane(tokens: TokenStream) -> Self {
        Self::new(Shape::Plane, tokens)
    }

    /// In parentheses if it holds together less tightly than its place requires.
    pub(super) fn within(self, place: Precedence) -> TokenStream {
        let tokens = self.tokens;
        if self.precedence.needs_parentheses(place) {
            quote_spanned!(Span::mixed_site()=> (#tokens))
        } else {
            tokens
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
    let unknowns = pattern(model.unknowns.iter().map(|unknown| &unknown.name), &used);
    let mut body = TokenStream::new();
    for input in &model.inputs {
        let name = &input.name;
        if !used.contains(&name.to_string()) {
            body.extend(quote_spanned!(site=> let _ = #name;));
        }
    }
    body.extend(bindings(declaration, runtime, &used, &mut names));
    let translation = Translation { names: &names, runtime };
    let mut residuals: Vec<TokenStream> = Vec::new();
    let mut lines: Vec<String> = Vec::new();
    for (number, equation) in equations.iter().enumerate() {
        let left = translation.formula(&equation.left);
        let right = translation.formula(&equation.right);
        let residual = translation.sum(Operator::Subtract, left, right);
        let index = residuals.len();
        let tokens = residual.tokens;
        let axes = residual.shape.axes();
        if axes.is_empty() {
            residuals.push(tokens);
            lines.push(format!("- `[{index}]`: `{equation}`"));
            continue;
        }
        let local = format_ident!("equation_{number}", span = site);
        body.extend(quote_spanned!(site=> let #local = #tokens;));
        for axis in axes {
            let part = Ident::new(&axis.to_string(), site);
            residuals.push(quote_spanned!(site=> #local.#part));
        }
        lines.push(match residual.shape {
            Shape::Space => format!(
                "- `[{index}]`, `[{}]` and `[{}]`: x, y and z of `{equation}`",
                index + 1,
                index + 2
            ),
            _ => format!("- `[{index}]` and `[{}]`: x and y of `{equation}`", index + 1),
        });
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
        pub fn closure(&self, #(#inputs: T,)* #unknowns: [T; #unknown_count]) -> [T; #residual_count] {
            #body
            [#(#residuals),*]
        }
    }
}

/// Binds the abbreviations that are used to local names, and adds them to the names.
pub(super) fn bindings(
    declaration: &Declaration,
    runtime: &TokenStream,
    used: &BTreeSet<String>,
    names: &mut BTreeMap<String, Translated>,
) -> TokenStream {
    let site = Span::mixed_site();
    let mut body = TokenStream::new();
    for statement in &declaration.statements {
        if let Statement::Let(statement) = statement
            && used.contains(&statement.name.to_string())
        {
            let value = Translation { names, runtime }.formula(&statement.value);
            let (name, tokens) = (&statement.name, &value.tokens);
            body.extend(quote_spanned!(site=> let #name = #tokens;));
            names.insert(statement.name.to_string(), Translated::new(value.shape, quote!(#name)));
        }
    }
    body
}

/// A pattern of names; a name that nothing uses is left out.
pub(super) fn pattern<'a>(names: impl Iterator<Item = &'a Ident>, used: &BTreeSet<String>) -> TokenStream {
    let names = names.map(|name| {
        if used.contains(&name.to_string()) {
            quote!(#name)
        } else {
            quote!(_)
        }
    });
    quote_spanned!(Span::mixed_site()=> [#(#names),*])
}

/// What the declared names are called in the method. Abbreviations are added as they are bound.
pub(super) fn names(model: &Model) -> BTreeMap<String, Translated> {
    let site = Span::mixed_site();
    let mut names = BTreeMap::new();
    for parameter in &model.parameters {
        let name = &parameter.name;
        let tokens = quote_spanned!(site=> self.#name);
        names.insert(name.to_string(), Translated::new(parameter.dimension.shape(), tokens));
    }
    for input in &model.inputs {
        let name = &input.name;
        names.insert(name.to_string(), Translated::scalar(quote!(#name)));
    }
    for unknown in &model.unknowns {
        let name = &unknown.name;
        names.insert(unknown.name.to_string(), Translated::scalar(quote!(#name)));
    }
    names
}

/// The names that formulas use, directly or by way of abbreviations.
pub(super) fn used_names<'a>(
    declaration: &'a Declaration,
    formulas: impl Iterator<Item = &'a Formula>,
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
    pub(super) fn formula(&self, formula: &Formula) -> Translated {
        let site = Span::mixed_site();
        match &formula.kind {
            FormulaKind::Number { value, .. } => Translated::scalar(constant(*value)),
            FormulaKind::Pi => Translated::scalar(quote_spanned!(site=> T::constant(::core::f64::consts::PI))),
            // a name that is not there is a mistake that the model has reported
            FormulaKind::Name(name) => self
                .names
                .get(&name.to_string())
                .cloned()
                .unwrap_or_else(|| Translated::scalar(quote!(#name))),
            FormulaKind::Parenthesis(inner) => self.formula(inner),
            FormulaKind::Negate(of) => {
                let of = self.formula(of);
                let shape = of.shape;
                let operand = of.within(Precedence::Atom);
                Translated {
                    shape,
                    precedence: Precedence::Sign,
                    tokens: quote_spanned!(site=> -#operand),
                    angle: None,
                }
            }
            FormulaKind::Sum { first, rest } | FormulaKind::Product { first, rest } => {
                let mut result = self.formula(first);
                let mut before = TokenStream::new();
                for (place, Operand { operator, operand, .. }) in rest.iter().enumerate() {
                    if place > 0 && place % LONGEST == 0 {
                        let (value, tokens) = (Ident::new("value", site), result.tokens);
                        before.extend(quote_spanned!(site=> let #value = #tokens;));
                        result = Translated::new(result.shape, quote!(#value));
                    }
                    let right = self.formula(operand);
                    result = match operator {
                        Operator::Add | Operator::Subtract => self.sum(*operator, result, right),
                        Operator::Multiply => self.product(result, right),
                        Operator::Divide => self.quotient(result, right),
                    };
                }
                if before.is_empty() {
                    return result;
                }
                let tokens = result.tokens;
                Translated::new(result.shape, quote_spanned!(site=> { #before #tokens }))
            }
            FormulaKind::Call { callee, arguments, .. } => self.call(*callee, arguments),
            FormulaKind::Power { base, exponent, .. } => {
                let base = self.formula(base).within(Precedence::Atom);
                let exponent = Literal::i32_unsuffixed(*exponent);
                Translated::scalar(quote_spanned!(site=> #base.powi(#exponent)))
            }
            FormulaKind::Part { of, axis } => {
                let of = self.formula(of).within(Precedence::Atom);
                let part = Ident::new(&axis.to_string(), site);
                Translated::scalar(quote_spanned!(site=> #of.#part))
            }
        }
    }

    /// As a vector; a scalar lies along x.
    pub(super) fn lifted(&self, of: Translated, shape: Shape) -> Translated {
        if of.shape != Shape::Scalar {
            return of;
        }
        let Some(vector) = vector_type(shape) else {
            return of;
        };
        let (runtime, x, zero) = (self.runtime, of.tokens, constant(0.0));
        let zeros = shape.axes().iter().skip(1).map(|_| &zero);
        Translated::new(
            shape,
            quote_spanned!(Span::mixed_site()=> #runtime::#vector::new(#x #(, #zeros)*)),
        )
    }

    pub(super) fn sum(&self, operator: Operator, left: Translated, right: Translated) -> Translated {
        let (left_shape, right_shape) = (left.shape, right.shape);
        let (left, right) = (self.lifted(left, right_shape), self.lifted(right, left_shape));
        let shape = left.shape;
        let (mut tokens, right) = (left.within(Precedence::Sum), right.within(Precedence::Product));
        let site = Span::mixed_site();
        // the left side is not copied: it may be long
        tokens.extend(if operator == Operator::Subtract {
            quote_spanned!(site=> - #right)
        } else {
            quote_spanned!(site=> + #right)
        });
        Translated {
            shape,
            precedence: Precedence::Sum,
            tokens,
            angle: None,
        }
    }

    fn product(&self, left: Translated, right: Translated) -> Translated {
        let runtime = self.runtime;
        let site = Span::mixed_site();
        let shapes = (left.shape, right.shape);
        if shapes == (Shape::Scalar, Shape::Scalar) {
            let (mut tokens, factor) = (left.within(Precedence::Product), right.within(Precedence::Sign));
            tokens.extend(quote_spanned!(site=> * #factor));
            return Translated {
                shape: Shape::Scalar,
                precedence: Precedence::Product,
                tokens,
                angle: None,
            };
        }
        let scaled = |shape: Shape, vector: &TokenStream, factor: &TokenStream| {
            let kind = vector_type(shape);
            Translated::new(shape, quote_spanned!(site=> #runtime::#kind::scale(#vector, #factor)))
        };
        // r cis(theta) is the vector that a person draws
        match (&left, &right) {
            (vector, length) | (length, vector) if length.shape == Shape::Scalar => {
                if let Some(angle) = &vector.angle {
                    let length = &length.tokens;
                    return Translated::plane(quote_spanned!(site=> #runtime::Plane::polar(#length, #angle)));
                }
            }
            _ => {}
        }
        let (a, b) = (&left.tokens, &right.tokens);
        match shapes {
            (shape, Shape::Scalar) => scaled(shape, a, b),
            (Shape::Scalar, shape) => scaled(shape, b, a),
            (Shape::Rotation, Shape::Rotation) => Translated::new(
                Shape::Rotation,
                quote_spanned!(site=> #runtime::Rotation::times(#a, #b)),
            ),
            (Shape::Rotation, shape) => Translated::new(shape, quote_spanned!(site=> #runtime::Rotation::turn(#a, #b))),
            (_, _) => Translated::plane(quote_spanned!(site=> #runtime::Plane::times(#a, #b))),
        }
    }

    fn quotient(&self, left: Translated, right: Translated) -> Translated {
        let site = Span::mixed_site();
        let divisor = right.within(Precedence::Sign);
        if let Some(vector) = vector_type(left.shape) {
            let (runtime, dividend, one) = (self.runtime, left.tokens, constant(1.0));
            return Translated::new(
                left.shape,
                quote_spanned!(site=> #runtime::#vector::scale(#dividend, #one / #divisor)),
            );
        }
        let mut tokens = left.within(Precedence::Product);
        tokens.extend(quote_spanned!(site=> / #divisor));
        Translated {
            shape: Shape::Scalar,
            precedence: Precedence::Product,
            tokens,
            angle: None,
        }
    }

    fn call(&self, callee: Callee, arguments: &[Formula]) -> Translated {
        let runtime = self.runtime;
        let site = Span::mixed_site();
        let translated: Vec<Translated> = arguments.iter().map(|argument| self.formula(argument)).collect();
        let shape = translated.first().map_or(Shape::Scalar, |first| first.shape);
        let arguments: Vec<TokenStream> = translated.into_iter().map(|argument| argument.tokens).collect();
        let rotation = |function: &str| {
            let function = Ident::new(function, site);
            Translated::new(
                Shape::Rotation,
                quote_spanned!(site=> #runtime::Rotation::#function(#(#arguments),*)),
            )
        };
        let method = |result: Shape, function: &str| {
            let (vector, function) = (vector_type(shape), Ident::new(function, site));
            Translated::new(
                result,
                quote_spanned!(site=> #runtime::#vector::#function(#(#arguments),*)),
            )
        };
        match (callee, arguments.as_slice()) {
            (Callee::Cis, [angle]) => Translated {
                angle: Some(angle.clone()),
                ..Translated::plane(quote_spanned!(site=> #runtime::Plane::cis(#angle)))
            },
            (Callee::Polar, [length, angle]) => {
                Translated::plane(quote_spanned!(site=> #runtime::Plane::polar(#length, #angle)))
            }
            (Callee::Elementary(function), arguments) => elementary(function, arguments),
            (Callee::RotX, _) => rotation("about_x"),
            (Callee::RotY, _) => rotation("about_y"),
            (Callee::RotZ, _) => rotation("about_z"),
            (Callee::Rot, _) => rotation("about"),
            (Callee::Dot, _) => method(Shape::Scalar, "dot"),
            (Callee::Cross, _) if shape == Shape::Space => method(Shape::Space, "cross"),
            (Callee::Cross, _) => method(Shape::Scalar, "cross"),
            (Callee::Norm, _) => method(Shape::Scalar, "norm"),
            (Callee::Vec3, arguments) => Translated::new(
                Shape::Space,
                quote_spanned!(site=> #runtime::Space::new(#(#arguments),*)),
            ),
            (_, arguments) => Translated::plane(quote_spanned!(site=> #runtime::Plane::new(#(#arguments),*))),
        }
    }
}

/// A call of an elementary function.
fn elementary(function: Function, arguments: &[TokenStream]) -> Translated {
    let site = Span::mixed_site();
    Translated::scalar(match function.calculation() {
        Calculation::Sine => quote_spanned!(site=> T::sin_cos(#(#arguments),*).0),
        Calculation::Cosine => quote_spanned!(site=> T::sin_cos(#(#arguments),*).1),
        Calculation::Tangent => quote_spanned! {site=> {
            let (sine, cosine) = T::sin_cos(#(#arguments),*);
            sine / cosine
        }},
        Calculation::Method => {
            let method = Ident::new(function.name(), site);
            quote_spanned!(site=> T::#method(#(#arguments),*))
        }
    })
}

/// A number of the type `T`.
pub(super) fn constant(value: f64) -> TokenStream {
    let value = Literal::f64_unsuffixed(value);
    quote_spanned!(Span::mixed_site()=> T::constant(#value))
}

#[cfg(test)]
#[allow(clippy::needless_pass_by_value, reason = "formulas are quoted where they are passed")]
mod tests {
    use super::*;
    use crate::mistakes::Mistakes;
    use crate::model;
    use crate::syntax;

    /// The method behind its arguments.
    fn body(statements: TokenStream) -> String {
        let method = method(statements);
        method[method.find("-> [").unwrap_or_default()..].to_owned()
    }

    fn method(statements: TokenStream) -> String {
        let mut mistakes = Mistakes::new();
        let tokens = quote! {
            struct M { a: Length, b: Length, k: Scalar, p: Point }
            #statements
            output all: Vector = k * (p + a + b);
        };
        let declaration = syntax::parse(tokens, &mut mistakes);
        let model = declaration
            .as_ref()
            .and_then(|declaration| model::build(declaration, &mut mistakes));
        let (Some(declaration), Some(model)) = (declaration, model) else {
            panic!("{:?}", mistakes.into_messages());
        };
        super::tokens(&declaration, &model, &quote!(rt)).to_string()
    }

    #[test]
    fn powers_are_those_of_the_number_type() {
        let powers = |n: TokenStream| body(quote!(input t: Angle; unknown e: Scalar; powi(e - 1, #n) == t;));
        assert_eq!(
            powers(quote!(5)),
            "-> [T ; 1] { [(e - T :: constant (1.0)) . powi (5) - t] }"
        );
        assert_eq!(
            powers(quote!(-6)),
            "-> [T ; 1] { [(e - T :: constant (1.0)) . powi (- 6) - t] }"
        );
    }

    #[test]
    fn parentheses_stand_where_they_are_needed() {
        assert_eq!(
            body(quote!(input t: Angle; unknown e: Length; ((a)) - (b - e) * -(t) == -(-(a)) / (k * k);)),
            "-> [T ; 1] { [self . a - (self . b - e) * - t - - (- self . a) / (self . k * self . k)] }"
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
            "-> [T ; 2] { let wheel = rt :: Plane :: scale (rt :: Plane :: polar (self . b , e) , \
             T :: constant (1.0) / T :: constant (2.0)) ; \
             let equation_0 = rt :: Plane :: times (self . p , rt :: Plane :: cis (t)) \
             - rt :: Plane :: new (self . a , T :: constant (0.0)) \
             - (wheel + rt :: Plane :: new (l , T :: constant (0.0))) ; [equation_0 . x , equation_0 . y] }"
        );
    }

    #[test]
    fn vectors_of_space_have_three_parts() {
        assert_eq!(
            body(quote! {
                input t: Angle; unknown e: Length; unknown l: Length; unknown m: Length;
                let axis = vec3(a, b, e) / 2;
                rot(axis, t) * (rot_x(t) * rot_y(t) * axis) == -vec3(l, m, norm(p)) + cross(axis, axis) / e;
            }),
            "-> [T ; 3] { let axis = rt :: Space :: scale (rt :: Space :: new (self . a , self . b , e) , \
             T :: constant (1.0) / T :: constant (2.0)) ; \
             let equation_0 = rt :: Rotation :: turn (rt :: Rotation :: about (axis , t) , \
             rt :: Rotation :: turn (rt :: Rotation :: times (rt :: Rotation :: about_x (t) , rt :: Rotation :: about_y (t)) , axis)) \
             - (- rt :: Space :: new (l , m , rt :: Plane :: norm (self . p)) \
             + rt :: Space :: scale (rt :: Space :: cross (axis , axis) , T :: constant (1.0) / e)) ; \
             [equation_0 . x , equation_0 . y , equation_0 . z] }"
        );
    }

    #[test]
    fn names_of_outputs_alone_leave_no_warning() {
        let method = method(quote! {
            input t: Angle, u: Length; unknown e: Angle, l: Length; e == t; l * l == a * a; output v: Length = 2 * u;
        });
        assert!(method.contains("[e , l] : [T ; 2]"), "{method}");
        assert!(method.contains("{ let _ = u ; [e - t ,"), "{method}");
    }
}
