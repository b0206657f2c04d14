//! Formulas of the declaration as Rust, operator by operator.

use std::collections::BTreeMap;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{quote, quote_spanned};

use super::vector_type;
use crate::algebra::{Calculation, Function};
use crate::model::ValueShape;
use crate::precedence::Precedence;
use crate::syntax::{ArithmeticOperator, Callee, FormulaKind, Operand, TypedFormula};

/// The number of operands in a row after which the result gets a name. Each operand nests the formula one level deeper.
const LONGEST: usize = 256;

/// A formula in Rust.
#[derive(Clone)]
pub(super) struct Translated {
    pub(super) shape: ValueShape,
    pub(super) precedence: Precedence,
    pub(super) tokens: TokenStream,
    /// The angle of a unit vector that was typed as `cis(angle)`.
    angle: Option<TokenStream>,
}

impl Translated {
    pub(super) fn new(shape: ValueShape, tokens: TokenStream) -> Self {
        Self {
            shape,
            precedence: Precedence::Atom,
            tokens,
            angle: None,
        }
    }

    pub(super) fn scalar(tokens: TokenStream) -> Self {
        Self::new(ValueShape::Scalar, tokens)
    }

    fn plane(tokens: TokenStream) -> Self {
        Self::new(ValueShape::Plane, tokens)
    }

    /// The formula, in parentheses if its operator binds less tightly than its place requires.
    pub(super) fn within(self, place: Precedence) -> TokenStream {
        let tokens = self.tokens;
        if self.precedence.needs_parentheses(place) {
            quote_spanned!(Span::mixed_site()=> (#tokens))
        } else {
            tokens
        }
    }
}

pub(super) struct Translation<'a> {
    pub(super) names: &'a BTreeMap<String, Translated>,
    pub(super) runtime: &'a TokenStream,
}

impl Translation<'_> {
    pub(super) fn formula(&self, formula: &TypedFormula) -> Translated {
        let site = Span::mixed_site();
        match &formula.kind {
            FormulaKind::Number { value, .. } => Translated::scalar(constant(*value)),
            FormulaKind::Degrees { value, .. } => Translated::scalar(constant(value / 180.0 * std::f64::consts::PI)),
            FormulaKind::Pi => Translated::scalar(quote_spanned!(site=> T::constant(::core::f64::consts::PI))),
            // the model has reported a name that does not exist
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
                for (
                    place,
                    Operand {
                        operator,
                        formula: operand,
                        ..
                    },
                ) in rest.iter().enumerate()
                {
                    if place > 0 && place % LONGEST == 0 {
                        let (value, tokens) = (Ident::new("value", site), result.tokens);
                        before.extend(quote_spanned!(site=> let #value = #tokens;));
                        result = Translated::new(result.shape, quote!(#value));
                    }
                    let right = self.formula(operand);
                    result = match operator {
                        ArithmeticOperator::Add | ArithmeticOperator::Subtract => self.sum(*operator, result, right),
                        ArithmeticOperator::Multiply => self.product(result, right),
                        ArithmeticOperator::Divide => self.quotient(result, right),
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

    /// The formula as a vector; a scalar lies along x.
    pub(super) fn lifted(&self, of: Translated, shape: ValueShape) -> Translated {
        if of.shape != ValueShape::Scalar {
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

    pub(super) fn sum(&self, operator: ArithmeticOperator, left: Translated, right: Translated) -> Translated {
        let (left_shape, right_shape) = (left.shape, right.shape);
        let (left, right) = (self.lifted(left, right_shape), self.lifted(right, left_shape));
        let shape = left.shape;
        let (mut tokens, right) = (left.within(Precedence::Sum), right.within(Precedence::Product));
        let site = Span::mixed_site();
        // the left side is not copied, because it may be long
        tokens.extend(if operator == ArithmeticOperator::Subtract {
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
        if shapes == (ValueShape::Scalar, ValueShape::Scalar) {
            let (mut tokens, factor) = (left.within(Precedence::Product), right.within(Precedence::Sign));
            tokens.extend(quote_spanned!(site=> * #factor));
            return Translated {
                shape: ValueShape::Scalar,
                precedence: Precedence::Product,
                tokens,
                angle: None,
            };
        }
        let scaled = |shape: ValueShape, vector: &TokenStream, factor: &TokenStream| {
            let kind = vector_type(shape);
            Translated::new(shape, quote_spanned!(site=> #runtime::#kind::scale(#vector, #factor)))
        };
        // r cis(theta) is the vector that a person draws
        match (&left, &right) {
            (vector, length) | (length, vector) if length.shape == ValueShape::Scalar => {
                if let Some(angle) = &vector.angle {
                    let length = &length.tokens;
                    return Translated::plane(quote_spanned!(site=> #runtime::Plane::polar(#length, #angle)));
                }
            }
            _ => {}
        }
        let (a, b) = (&left.tokens, &right.tokens);
        match shapes {
            (shape, ValueShape::Scalar) => scaled(shape, a, b),
            (ValueShape::Scalar, shape) => scaled(shape, b, a),
            (ValueShape::Rotation, ValueShape::Rotation) => Translated::new(
                ValueShape::Rotation,
                quote_spanned!(site=> #runtime::Rotation::times(#a, #b)),
            ),
            (ValueShape::Rotation, shape) => {
                Translated::new(shape, quote_spanned!(site=> #runtime::Rotation::turn(#a, #b)))
            }
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
            shape: ValueShape::Scalar,
            precedence: Precedence::Product,
            tokens,
            angle: None,
        }
    }

    fn call(&self, callee: Callee, arguments: &[TypedFormula]) -> Translated {
        let runtime = self.runtime;
        let site = Span::mixed_site();
        let translated: Vec<Translated> = arguments.iter().map(|argument| self.formula(argument)).collect();
        let shape = translated.first().map_or(ValueShape::Scalar, |first| first.shape);
        let arguments: Vec<TokenStream> = translated.into_iter().map(|argument| argument.tokens).collect();
        let rotation = |function: &str| {
            let function = Ident::new(function, site);
            Translated::new(
                ValueShape::Rotation,
                quote_spanned!(site=> #runtime::Rotation::#function(#(#arguments),*)),
            )
        };
        let method = |result: ValueShape, function: &str| {
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
            (Callee::Dot, _) => method(ValueShape::Scalar, "dot"),
            (Callee::Cross, _) if shape == ValueShape::Space => method(ValueShape::Space, "cross"),
            (Callee::Cross, _) => method(ValueShape::Scalar, "cross"),
            (Callee::Norm, _) => method(ValueShape::Scalar, "norm"),
            (Callee::Vec3, arguments) => Translated::new(
                ValueShape::Space,
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
