//! Formulas to graph nodes: names looked up, dimensions checked, plane vectors taken apart.

use proc_macro2::Span;

use crate::expr::{Graph, Node};
use crate::function::Function;
use crate::model::Value;
use crate::model::dimension::{Exponent, Measure, common, product};
use crate::model::scope::Scope;
use crate::report::{Extent, Report};
use crate::syntax::{Axis, Callee, EquationStatement, Expression, ExpressionKind, Operator};

/// A formula's value and what it measures.
#[derive(Clone, Copy, Debug)]
pub(super) struct Typed {
    pub(super) value: Value,
    pub(super) exponent: Option<Exponent>,
}

impl Typed {
    pub(super) fn scalar(node: Node, exponent: Exponent) -> Self {
        Self {
            value: Value::Scalar(node),
            exponent: Some(exponent),
        }
    }

    pub(super) fn plane(x: Node, y: Node, exponent: Exponent) -> Self {
        Self {
            value: Value::Plane(x, y),
            exponent: Some(exponent),
        }
    }

    pub(super) fn measure(&self) -> Measure {
        Measure {
            plane: matches!(self.value, Value::Plane(..)),
            exponent: self.exponent,
        }
    }
}

/// What formulas are lowered with. Every method returns `None` after a mistake, which has been reported then.
pub(super) struct Lowering<'a, 'b> {
    pub(super) graph: &'a mut Graph,
    pub(super) scope: &'a mut Scope<'b>,
    pub(super) report: &'a mut Report,
}

impl Lowering<'_, '_> {
    /// The difference of the two sides.
    pub(super) fn residual(&mut self, equation: &EquationStatement) -> Option<Value> {
        let left = self.expression(&equation.left);
        let right = self.expression(&equation.right);
        let (left, right) = (left?, right?);
        let (left_measure, right_measure) = (left.measure(), right.measure());
        let mixed = left_measure.plane != right_measure.plane && !left_measure.is_zero() && !right_measure.is_zero();
        if mixed {
            let sides = if left_measure.plane {
                "the left side is a plane vector, the right side a scalar"
            } else {
                "the left side is a scalar, the right side a plane vector"
            };
            self.report.error(
                equation.operator,
                format!("{sides}: write `vec2(s, 0)` to place a scalar s along x, or compare `.x` and `.y` one by one"),
            );
            return None;
        }
        if common(left_measure, right_measure).is_none() {
            self.report.error(
                equation.operator,
                format!(
                    "the left side is {left_measure}, the right side {right_measure}: both sides of an equation must have the same dimension"
                ),
            );
            return None;
        }
        Some(self.combine(Operator::Subtract, left.value, right.value))
    }

    pub(super) fn expression(&mut self, expression: &Expression) -> Option<Typed> {
        let typed = match &expression.kind {
            ExpressionKind::Number { value, .. } => Typed {
                value: Value::Scalar(self.graph.number(*value)),
                exponent: (*value != 0.0).then_some(Exponent::NUMBER),
            },
            ExpressionKind::Pi => Typed::scalar(self.graph.pi(), Exponent::NUMBER),
            ExpressionKind::Name(name) => self.scope.resolve(name, self.report)?,
            ExpressionKind::Parenthesis(inner) => self.expression(inner)?,
            ExpressionKind::Negate(of) => {
                let of = self.expression(of)?;
                Typed {
                    value: match of.value {
                        Value::Scalar(node) => Value::Scalar(self.graph.negate(node)),
                        Value::Plane(x, y) => Value::Plane(self.graph.negate(x), self.graph.negate(y)),
                    },
                    exponent: of.exponent,
                }
            }
            ExpressionKind::Binary {
                operator,
                span,
                left,
                right,
            } => {
                let left_typed = self.expression(left);
                let right_typed = self.expression(right);
                let (left, right_typed) = (left_typed?, right_typed?);
                match operator {
                    Operator::Add | Operator::Subtract => self.sum(*operator, *span, left, right_typed)?,
                    Operator::Multiply => self.product(left, right_typed),
                    Operator::Divide => self.quotient(left, right_typed, right.extent)?,
                }
            }
            ExpressionKind::Call { callee, arguments, .. } => {
                let typed: Vec<Option<Typed>> = arguments.iter().map(|argument| self.expression(argument)).collect();
                let typed: Vec<Typed> = typed.into_iter().collect::<Option<_>>()?;
                self.call(*callee, arguments, &typed)?
            }
            ExpressionKind::Power { base, exponent, .. } => {
                let typed = self.expression(base)?;
                let node = self.scalar_argument("powi", base, &typed)?;
                if *exponent < 0 && self.graph.constant_value(node) == Some(0.0) {
                    self.report.error(
                        base.extent,
                        "this is zero, and zero has no power with a negative exponent",
                    );
                    return None;
                }
                Typed {
                    value: Value::Scalar(self.graph.power(node, *exponent)),
                    exponent: match typed.exponent {
                        Some(of_base) => Some(of_base.times(*exponent)),
                        None => (*exponent == 0).then_some(Exponent::NUMBER),
                    },
                }
            }
            ExpressionKind::Part { of, axis } => {
                let typed = self.expression(of)?;
                let Value::Plane(x, y) = typed.value else {
                    self.report.error(
                        expression.extent,
                        format!(
                            "only a plane vector has a part `{axis}`, but `{of}` is {}: write it alone",
                            typed.measure()
                        ),
                    );
                    return None;
                };
                Typed {
                    value: Value::Scalar(match axis {
                        Axis::X => x,
                        Axis::Y => y,
                    }),
                    exponent: typed.exponent,
                }
            }
        };
        self.finite(expression, typed)
    }

    /// Constants are computed here and now, and one may grow out of the numbers' range.
    fn finite(&mut self, expression: &Expression, typed: Typed) -> Option<Typed> {
        let infinite = typed
            .value
            .nodes()
            .into_iter()
            .any(|node| self.graph.constant_value(node).is_some_and(|value| !value.is_finite()));
        if infinite {
            self.report.error(
                expression.extent,
                "this constant is not a finite number: it is too large, or outside of a function's domain",
            );
            return None;
        }
        Some(typed)
    }

    fn sum(&mut self, operator: Operator, span: Span, left: Typed, right: Typed) -> Option<Typed> {
        let Some(measure) = common(left.measure(), right.measure()) else {
            let complaint = if operator == Operator::Add {
                format!("cannot add {} and {}", left.measure(), right.measure())
            } else {
                format!("cannot subtract {} from {}", right.measure(), left.measure())
            };
            let remedy = match (left.exponent, right.exponent) {
                (Some(Exponent::LENGTH), Some(Exponent::NUMBER)) | (Some(Exponent::NUMBER), Some(Exponent::LENGTH)) => {
                    "multiply the number by a length, or divide the length by one"
                }
                _ => "bring both to the same dimension",
            };
            self.report.error_at(span, format!("{complaint}: {remedy}"));
            return None;
        };
        Some(Typed {
            value: self.combine(operator, left.value, right.value),
            exponent: measure.exponent,
        })
    }

    /// Sum or difference; a scalar beside a vector lies along x.
    fn combine(&mut self, operator: Operator, left: Value, right: Value) -> Value {
        let zero = self.graph.number(0.0);
        let mut join = |a, b| {
            if operator == Operator::Subtract {
                self.graph.subtract(a, b)
            } else {
                self.graph.add(a, b)
            }
        };
        if let (Value::Scalar(a), Value::Scalar(b)) = (left, right) {
            return Value::Scalar(join(a, b));
        }
        let (a, b) = (left.on_plane(zero), right.on_plane(zero));
        Value::Plane(join(a.0, b.0), join(a.1, b.1))
    }

    /// A product; of two vectors, that of complex numbers.
    fn product(&mut self, left: Typed, right: Typed) -> Typed {
        let graph = &mut *self.graph;
        let value = match (left.value, right.value) {
            (Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(graph.multiply(a, b)),
            (Value::Scalar(s), Value::Plane(x, y)) | (Value::Plane(x, y), Value::Scalar(s)) => {
                Value::Plane(graph.multiply(s, x), graph.multiply(s, y))
            }
            (Value::Plane(a, b), Value::Plane(c, d)) => {
                let (ac, bd) = (graph.multiply(a, c), graph.multiply(b, d));
                let (ad, bc) = (graph.multiply(a, d), graph.multiply(b, c));
                Value::Plane(graph.subtract(ac, bd), graph.add(ad, bc))
            }
        };
        Typed {
            value,
            exponent: product(left.exponent, right.exponent),
        }
    }

    fn quotient(&mut self, left: Typed, right: Typed, divisor: Extent) -> Option<Typed> {
        let Value::Scalar(by) = right.value else {
            self.report.error(
                divisor,
                "nothing can be divided by a plane vector: multiply by `cis(-angle)` to turn back by an angle",
            );
            return None;
        };
        if self.graph.constant_value(by) == Some(0.0) {
            self.report
                .error(divisor, "this divisor is zero: divide by something else");
            return None;
        }
        Some(Typed {
            value: match left.value {
                Value::Scalar(node) => Value::Scalar(self.graph.divide(node, by)),
                Value::Plane(x, y) => Value::Plane(self.graph.divide(x, by), self.graph.divide(y, by)),
            },
            exponent: product(left.exponent, right.exponent.map(Exponent::negated)),
        })
    }

    fn call(&mut self, callee: Callee, arguments: &[Expression], typed: &[Typed]) -> Option<Typed> {
        let name = callee.name();
        let nodes: Vec<Option<Node>> = arguments
            .iter()
            .zip(typed)
            .map(|(argument, typed)| self.scalar_argument(name, argument, typed))
            .collect();
        let nodes: Vec<Node> = nodes.into_iter().collect::<Option<_>>()?;
        match (callee, nodes.as_slice()) {
            (Callee::Cis, &[angle]) => {
                self.expect_number(name, &arguments[0], &typed[0])?;
                Some(Typed {
                    value: self.turned(None, angle),
                    exponent: Some(Exponent::NUMBER),
                })
            }
            (Callee::Polar, &[length, angle]) => {
                self.expect_number(name, &arguments[1], &typed[1])?;
                Some(Typed {
                    value: self.turned(Some(length), angle),
                    exponent: typed[0].exponent,
                })
            }
            (Callee::Vec2, &[x, y]) => Some(Typed {
                value: Value::Plane(x, y),
                exponent: self.same_dimension(name, arguments, typed)?.exponent,
            }),
            (Callee::Elementary(function), nodes) => self.elementary(function, arguments, typed, nodes),
            (Callee::Cis | Callee::Polar | Callee::Vec2, _) => None,
        }
    }

    /// `length * (cos, sin)`
    fn turned(&mut self, length: Option<Node>, angle: Node) -> Value {
        let cosine = self.graph.call(Function::Cos, &[angle]);
        let sine = self.graph.call(Function::Sin, &[angle]);
        match length {
            None => Value::Plane(cosine, sine),
            Some(length) => Value::Plane(self.graph.multiply(length, cosine), self.graph.multiply(length, sine)),
        }
    }

    fn elementary(
        &mut self,
        function: Function,
        arguments: &[Expression],
        typed: &[Typed],
        nodes: &[Node],
    ) -> Option<Typed> {
        let name = function.name();
        let exponent = match function {
            Function::Atan2 => {
                self.same_dimension(name, arguments, typed)?;
                Some(Exponent::NUMBER)
            }
            Function::Sqrt => typed[0].exponent.map(Exponent::half),
            _ => {
                self.expect_number(name, &arguments[0], &typed[0])?;
                Some(Exponent::NUMBER)
            }
        };
        let constants: Option<Vec<f64>> = nodes.iter().map(|&node| self.graph.constant_value(node)).collect();
        if let Some(constants) = constants
            && let Some(domain) = outside_of_domain(function, &constants)
        {
            let extent = arguments[0].extent.to(arguments[arguments.len() - 1].extent);
            self.report.error(
                extent,
                format!("this is outside of the domain of `{name}`, which {domain}"),
            );
            return None;
        }
        Some(Typed {
            value: Value::Scalar(self.graph.call(function, nodes)),
            exponent,
        })
    }

    /// Functions work on scalars; only the operators know vectors.
    fn scalar_argument(&mut self, name: &str, argument: &Expression, typed: &Typed) -> Option<Node> {
        match typed.value {
            Value::Scalar(node) => Some(node),
            Value::Plane(..) => {
                self.report.error(
                    argument.extent,
                    format!(
                        "`{name}` takes scalars, but this is {}: write its part `.x` or `.y`",
                        typed.measure()
                    ),
                );
                None
            }
        }
    }

    fn expect_number(&mut self, name: &str, argument: &Expression, typed: &Typed) -> Option<()> {
        let measure = typed.measure();
        if measure.is_number() {
            return Some(());
        }
        let wanted = match name {
            "asin" | "acos" | "atan" => "a ratio",
            "exp" | "ln" => "a plain number",
            "cis" => "an angle",
            "polar" => "an angle as its second argument",
            _ => "an angle or a ratio",
        };
        let remedy = match (name, measure.exponent) {
            ("polar", _) => "write `polar(length, angle)`",
            ("atan", Some(Exponent::LENGTH)) => "divide it by a length, or write `atan2(y, x)`",
            (_, Some(Exponent::LENGTH)) => "divide it by a length",
            _ => "divide it by something of the same dimension",
        };
        self.report.error(
            argument.extent,
            format!("`{name}` takes {wanted}, but this is {measure}: {remedy}"),
        );
        None
    }

    fn same_dimension(&mut self, name: &str, arguments: &[Expression], typed: &[Typed]) -> Option<Measure> {
        let shared = common(typed[0].measure(), typed[1].measure());
        if shared.is_none() {
            self.report.error(
                arguments[0].extent.to(arguments[1].extent),
                format!(
                    "both arguments of `{name}` must have the same dimension, but they are {} and {}",
                    typed[0].measure(),
                    typed[1].measure()
                ),
            );
        }
        shared
    }
}

/// What the domain is, if the constants lie outside of it.
fn outside_of_domain(function: Function, constants: &[f64]) -> Option<&'static str> {
    match (function, constants) {
        (Function::Sqrt, &[x]) if x < 0.0 => Some("begins at 0"),
        (Function::Asin | Function::Acos, &[x]) if x.abs() > 1.0 => Some("goes from -1 to 1"),
        (Function::Ln, &[x]) if x <= 0.0 => Some("begins above 0"),
        (Function::Atan2, &[y, x]) if y == 0.0 && x == 0.0 => Some("leaves out the point (0, 0)"),
        _ => None,
    }
}
