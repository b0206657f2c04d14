//! Formulas to graph nodes: names are looked up, dimensions checked, and vectors split into scalars.

use std::iter;

use proc_macro2::Span;

use crate::algebra::{Function, Gives, Graph, Node, Takes};
use crate::mistakes::{Extent, Mistakes};
use crate::model::FormulaValue;
use crate::model::dimension::{Exponent, FormulaType, common, product};
use crate::model::scope::Scope;
use crate::model::value::Typed;
use crate::syntax::{
    ArithmeticOperator, Axis, Callee, EquationStatement, FormulaKind, Operand, TypedFormula, ValueShape,
};

/// The state of lowering. Every method reports mistakes and returns `None` after one.
pub(super) struct Lowering<'a, 'b> {
    pub(super) graph: &'a mut Graph,
    pub(super) scope: &'a mut Scope<'b>,
    pub(super) mistakes: &'a mut Mistakes,
    /// The constant farthest from 1, as its distance and its position in the source.
    pub(super) extreme: &'a mut Option<(f64, Extent)>,
}

/// The largest exponent of a power after the folding of powers of powers.
const LARGEST_POWER: u32 = 1024;

impl Lowering<'_, '_> {
    /// The difference of the two sides.
    pub(super) fn residual(&mut self, equation: &EquationStatement) -> Option<FormulaValue> {
        let left = self.formula(&equation.left);
        let right = self.formula(&equation.right);
        let (left, right) = (left?, right?);
        let (left_measure, right_measure) = (left.measure(), right.measure());
        if left_measure.shape != right_measure.shape || left_measure.shape == ValueShape::Rotation {
            let remedy = match clash(left_measure, right_measure) {
                Some(remedy) => Some(remedy),
                None if left_measure.is_zero() || right_measure.is_zero() => None,
                None => Some("write `vec2(s, 0)` to place a scalar s along x, or compare `.x` and `.y` one by one"),
            };
            if let Some(remedy) = remedy {
                let kind = |measure: FormulaType| match measure.shape {
                    ValueShape::Scalar => "a scalar",
                    ValueShape::Plane => "a plane vector",
                    ValueShape::Space => "a space vector",
                    ValueShape::Rotation => "a rotation",
                };
                self.mistakes.error(
                    equation.operator,
                    format!(
                        "the left side is {}, the right side {}: {remedy}",
                        kind(left_measure),
                        kind(right_measure)
                    ),
                );
                return None;
            }
        }
        if common(left_measure, right_measure).is_none() {
            self.mistakes.error(
                equation.operator,
                format!(
                    "the left side is {left_measure}, the right side {right_measure}: both sides of an equation must \
                     have the same dimension"
                ),
            );
            return None;
        }
        let left = left.value.lifted(self.graph, right_measure.shape);
        let right = right.value.lifted(self.graph, left_measure.shape);
        let residual = left.zip(&right, |a, b| self.graph.subtract(a, b));
        self.fitting(equation.operator, residual)
    }

    pub(super) fn formula(&mut self, formula: &TypedFormula) -> Option<Typed> {
        let typed = match &formula.kind {
            FormulaKind::Number { value, .. } => Typed {
                value: FormulaValue::scalar(self.graph.number(*value)),
                exponent: (*value != 0.0).then_some(Exponent::NUMBER),
            },
            FormulaKind::Degrees { value, .. } => {
                let pi = self.graph.pi();
                Typed::scalar(self.graph.scale(*value / 180.0, pi), Exponent::NUMBER)
            }
            FormulaKind::Pi => Typed::scalar(self.graph.pi(), Exponent::NUMBER),
            FormulaKind::Name(name) => self.scope.resolve(name, self.mistakes)?,
            FormulaKind::Parenthesis(inner) => self.formula(inner)?,
            FormulaKind::Negate(of) => {
                let of = self.formula(of)?;
                if of.value.shape() == ValueShape::Rotation {
                    self.mistakes.error_at(
                        formula.extent.first,
                        "a rotation cannot be negated: write `-(rotation * vector)`, or turn by the opposite angle",
                    );
                    return None;
                }
                Typed {
                    value: of.value.map(|node| self.graph.negate(node)),
                    exponent: of.exponent,
                }
            }
            FormulaKind::Sum { first, rest } => self.sum(first, rest)?,
            FormulaKind::Product { first, rest } => {
                let mut product = self.formula(first);
                for operation in rest {
                    let factor = self.formula(&operation.formula);
                    product = self.times(first.extent, product, operation, factor);
                }
                product?
            }
            FormulaKind::Call { callee, arguments, .. } => {
                if let (Callee::Elementary(function), [argument]) = (callee, arguments.as_slice())
                    && function.name() == "exp"
                {
                    self.expect_real(formula, argument)?;
                }
                let typed: Vec<Option<Typed>> = arguments.iter().map(|argument| self.formula(argument)).collect();
                let typed: Vec<Typed> = typed.into_iter().collect::<Option<_>>()?;
                self.call(*callee, arguments, &typed)?
            }
            FormulaKind::Power { base, exponent, .. } => {
                let typed = self.formula(base)?;
                let node = self.scalar_argument("powi", base, &typed)?;
                if *exponent < 0 && self.graph.constant_value(node) == Some(0.0) {
                    self.mistakes.error(
                        base.extent,
                        "this is zero, and zero has no power with a negative exponent",
                    );
                    return None;
                }
                Typed {
                    value: FormulaValue::scalar(self.graph.power(node, *exponent)),
                    exponent: match typed.exponent {
                        Some(of_base) => Some(of_base.times(*exponent)),
                        None => (*exponent == 0).then_some(Exponent::NUMBER),
                    },
                }
            }
            FormulaKind::Part { of, axis } => {
                let typed = self.formula(of)?;
                let axes = typed.value.shape().axes();
                let Some(part) = axes.iter().position(|known| known == axis) else {
                    let measure = typed.measure();
                    let complaint = match measure.shape {
                        ValueShape::Scalar => {
                            format!("only a vector has a part `{axis}`, but `{of}` is {measure}: write it alone")
                        }
                        ValueShape::Plane | ValueShape::Space => format!(
                            "`{of}` is {measure} and has no part `{axis}`: write `vec3(v.x, v.y, 0)` to place a plane \
                             vector v in space"
                        ),
                        ValueShape::Rotation => format!(
                            "only a vector has a part `{axis}`, but `{of}` is {measure}: write a vector that it turns, \
                             as in `({of} * v).{axis}`"
                        ),
                    };
                    self.mistakes.error(formula.extent, complaint);
                    return None;
                };
                Typed {
                    value: FormulaValue::scalar(typed.value.nodes()[part]),
                    exponent: typed.exponent,
                }
            }
        };
        let value = self.fitting(formula.extent, typed.value)?;
        Some(Typed { value, ..typed })
    }

    /// Refuses `exp(i * angle)`, which is written `cis(angle)`.
    fn expect_real(&mut self, exponential: &TypedFormula, exponent: &TypedFormula) -> Option<()> {
        let FormulaKind::Product { first, rest } = &exponent.kind else {
            return Some(());
        };
        let factors = || iter::once(&**first).chain(rest.iter().map(|operation| &operation.formula));
        let is_imaginary = |factor: &&TypedFormula| {
            let FormulaKind::Name(name) = &factor.kind else {
                return false;
            };
            let word = name.to_string();
            (word == "i" || word == "j") && self.scope.is_free(&word)
        };
        if rest
            .iter()
            .any(|operation| operation.operator == ArithmeticOperator::Divide)
            || !factors().any(|it| is_imaginary(&it))
        {
            return Some(());
        }
        let angle: Vec<String> = factors()
            .filter(|it| !is_imaginary(it))
            .map(TypedFormula::to_string)
            .collect();
        self.scope.mean_all(exponent);
        self.mistakes.error(
            exponential.extent,
            format!(
                "the exponential of an imaginary number is a unit vector: write `cis({})`",
                angle.join(" * ")
            ),
        );
        None
    }

    /// A new value, if its constants and powers are within the limits. Its operands have been checked before.
    fn fitting(&mut self, extent: Extent, value: FormulaValue) -> Option<FormulaValue> {
        if let Some(misfit) = self.graph.take_misfit() {
            self.mistakes.error(
                extent,
                format!("a constant in this formula is {misfit}: choose a unit in which the numbers are closer to 1"),
            );
            return None;
        }
        for node in value.nodes() {
            if let Some(exponent) = self
                .graph
                .largest_exponent(node)
                .filter(|exponent| *exponent > LARGEST_POWER)
            {
                self.mistakes.error(
                    extent,
                    format!(
                        "this is a power with the exponent {exponent}, and {LARGEST_POWER} is the largest: declare a \
                         lower power as an unknown with an equation of its own"
                    ),
                );
                return None;
            }
            let size = self.graph.extremity(node);
            if size > self.extreme.map_or(0.0, |(largest, _)| largest) {
                *self.extreme = Some((size, extent));
            }
        }
        Some(value)
    }

    /// A sum. A scalar beside a vector lies along x.
    fn sum(&mut self, first: &TypedFormula, rest: &[Operand]) -> Option<Typed> {
        let first = self.formula(first);
        let mut measure = first.as_ref().map(Typed::measure);
        let mut terms: Vec<(FormulaValue, f64)> = first.into_iter().map(|first| (first.value, 1.0)).collect();
        for operation in rest {
            let term = self.formula(&operation.formula);
            measure = self.measure_of_sum(measure, operation, term.as_ref().map(Typed::measure));
            let sign = if operation.operator == ArithmeticOperator::Subtract {
                -1.0
            } else {
                1.0
            };
            terms.extend(term.map(|term| (term.value, sign)));
        }
        let FormulaType { shape, exponent } = measure?;
        let parts = (0..shape.axes().len().max(1)).map(|part| {
            let terms: Vec<(Node, f64)> = terms
                .iter()
                .filter_map(|(value, sign)| Some((*value.nodes().get(part)?, *sign)))
                .collect();
            self.graph.linear(0.0, &terms)
        });
        Some(Typed {
            value: FormulaValue::of(shape, parts.collect()),
            exponent,
        })
    }

    /// The measure of a sum with one more term, `None` after a mistake.
    fn measure_of_sum(
        &mut self,
        left: Option<FormulaType>,
        operation: &Operand,
        right: Option<FormulaType>,
    ) -> Option<FormulaType> {
        let (left, right) = (left?, right?);
        let remedy = clash(left, right);
        let measure = common(left, right).filter(|_| remedy.is_none());
        if measure.is_none() {
            let complaint = if operation.operator == ArithmeticOperator::Add {
                format!("cannot add {left} and {right}")
            } else {
                format!("cannot subtract {right} from {left}")
            };
            let remedy = remedy.unwrap_or(match (left.exponent, right.exponent) {
                (Some(Exponent::LENGTH), Some(Exponent::NUMBER)) | (Some(Exponent::NUMBER), Some(Exponent::LENGTH)) => {
                    "multiply the number by a length, or divide the length by one"
                }
                _ => "bring both to the same dimension",
            });
            self.mistakes.error_at(operation.span, format!("{complaint}: {remedy}"));
        }
        measure
    }

    /// A product with one more factor or divisor, which begins at `start`.
    fn times(
        &mut self,
        start: Extent,
        product: Option<Typed>,
        operation: &Operand,
        factor: Option<Typed>,
    ) -> Option<Typed> {
        let (left, right) = (product?, factor?);
        let (span, extent) = (operation.span, operation.formula.extent);
        let typed = if operation.operator == ArithmeticOperator::Divide {
            self.quotient(span, &left, &right, extent)?
        } else {
            self.product(span, &left, &right)?
        };
        let value = self.fitting(start.to(extent), typed.value)?;
        Some(Typed { value, ..typed })
    }

    /// A product. Two plane vectors multiply as complex numbers, and a rotation turns a vector or another rotation.
    fn product(&mut self, span: Span, left: &Typed, right: &Typed) -> Option<Typed> {
        let graph = &mut *self.graph;
        let (a, b) = (left.value.nodes(), right.value.nodes());
        let value = match (left.value.shape(), right.value.shape()) {
            (ValueShape::Scalar, ValueShape::Scalar | ValueShape::Plane | ValueShape::Space) => {
                right.value.map(|part| graph.multiply(a[0], part))
            }
            (ValueShape::Plane | ValueShape::Space, ValueShape::Scalar) => {
                left.value.map(|part| graph.multiply(b[0], part))
            }
            (ValueShape::Plane, ValueShape::Plane) => {
                let (ac, bd) = (graph.multiply(a[0], b[0]), graph.multiply(a[1], b[1]));
                let (ad, bc) = (graph.multiply(a[0], b[1]), graph.multiply(a[1], b[0]));
                FormulaValue::plane(graph.subtract(ac, bd), graph.add(ad, bc))
            }
            (ValueShape::Rotation, ValueShape::Space) => {
                let rows = left.value.rows();
                FormulaValue::space([0, 1, 2].map(|row| inner(graph, rows[row], &b)))
            }
            (ValueShape::Rotation, ValueShape::Rotation) => {
                let (rows, factor) = (left.value.rows(), right.value.rows());
                FormulaValue::rotation([0, 1, 2].map(|row| {
                    [0, 1, 2].map(|column| {
                        let column = [factor[0][column], factor[1][column], factor[2][column]];
                        inner(graph, rows[row], &column)
                    })
                }))
            }
            (left_shape, right_shape) => {
                let remedy = match (left_shape, right_shape) {
                    (ValueShape::Space, ValueShape::Space) => {
                        "write `dot(a, b)` or `cross(a, b)` for a product of space vectors"
                    }
                    (ValueShape::Rotation, ValueShape::Plane) | (ValueShape::Plane, ValueShape::Rotation) => {
                        "write `vec3(v.x, v.y, 0)` for the vector, or `v * cis(angle)` to turn it in the plane"
                    }
                    (ValueShape::Space, ValueShape::Rotation) => "write `rotation * vector`, the rotation first",
                    (ValueShape::Plane | ValueShape::Space, _) => {
                        "write `vec3(v.x, v.y, 0)` for the plane vector, and `dot(a, b)` or `cross(a, b)` for the \
                         product"
                    }
                    _ => "write `s * (rotation * vector)` for a scalar s",
                };
                self.mistakes.error_at(
                    span,
                    format!("cannot multiply {} and {}: {remedy}", left.measure(), right.measure()),
                );
                return None;
            }
        };
        Some(Typed {
            value,
            exponent: product(left.exponent, right.exponent),
        })
    }

    fn quotient(&mut self, span: Span, left: &Typed, right: &Typed, divisor: Extent) -> Option<Typed> {
        let Some(by) = right.value.as_scalar() else {
            self.mistakes.error(
                divisor,
                match right.value.shape() {
                    ValueShape::Space => "nothing can be divided by a space vector: divide by its length, `norm(v)`",
                    ValueShape::Rotation => {
                        "nothing can be divided by a rotation: turn by the opposite angle, as in `rot_z(-angle) * v`"
                    }
                    ValueShape::Scalar | ValueShape::Plane => {
                        "nothing can be divided by a plane vector: multiply by `cis(-angle)` to turn by the opposite \
                         angle"
                    }
                },
            );
            return None;
        };
        if left.value.shape() == ValueShape::Rotation {
            self.mistakes
                .error_at(span, "a rotation cannot be divided: write `rotation * vector / s`");
            return None;
        }
        if self.graph.constant_value(by) == Some(0.0) {
            self.mistakes
                .error(divisor, "this divisor is zero: divide by something else");
            return None;
        }
        Some(Typed {
            value: left.value.map(|part| self.graph.divide(part, by)),
            exponent: product(left.exponent, right.exponent.map(Exponent::negated)),
        })
    }

    fn call(&mut self, callee: Callee, arguments: &[TypedFormula], typed: &[Typed]) -> Option<Typed> {
        match callee {
            Callee::Rot | Callee::Dot | Callee::Cross | Callee::Norm => self.call_of_vectors(callee, arguments, typed),
            _ => self.call_of_scalars(callee, arguments, typed),
        }
    }

    fn call_of_scalars(&mut self, callee: Callee, arguments: &[TypedFormula], typed: &[Typed]) -> Option<Typed> {
        let name = callee.name();
        let nodes: Vec<Option<Node>> = arguments
            .iter()
            .zip(typed)
            .map(|(argument, typed)| self.scalar_argument(name, argument, typed))
            .collect();
        let nodes: Vec<Node> = nodes.into_iter().collect::<Option<_>>()?;
        match (callee, nodes.as_slice()) {
            (Callee::Cis, &[angle]) => {
                self.expect_angle(name, &arguments[0], &typed[0])?;
                Some(Typed::number(self.along_angle(None, angle)))
            }
            (Callee::Polar, &[length, angle]) => {
                self.expect_second_angle(name, callee.form(), &arguments[1], &typed[1])?;
                Some(Typed {
                    value: self.along_angle(Some(length), angle),
                    exponent: typed[0].exponent,
                })
            }
            (Callee::Vec2, &[x, y]) => Some(Typed {
                value: FormulaValue::plane(x, y),
                exponent: self.same_dimension(name, arguments, typed)?.exponent,
            }),
            (Callee::Vec3, &[x, y, z]) => Some(Typed {
                value: FormulaValue::space([x, y, z]),
                exponent: self.same_dimension(name, arguments, typed)?.exponent,
            }),
            (Callee::RotX, &[angle]) => self.rotation_about(Axis::X, name, &arguments[0], &typed[0], angle),
            (Callee::RotY, &[angle]) => self.rotation_about(Axis::Y, name, &arguments[0], &typed[0], angle),
            (Callee::RotZ, &[angle]) => self.rotation_about(Axis::Z, name, &arguments[0], &typed[0], angle),
            (Callee::Elementary(function), nodes) => self.elementary(function, arguments, typed, nodes),
            _ => None,
        }
    }

    fn call_of_vectors(&mut self, callee: Callee, arguments: &[TypedFormula], typed: &[Typed]) -> Option<Typed> {
        let name = callee.name();
        match (callee, typed) {
            (Callee::Rot, [axis, angle]) => {
                let direction = self.vector_argument(name, &arguments[0], axis);
                self.expect_second_angle(name, callee.form(), &arguments[1], angle)?;
                direction?;
                self.rotation(&arguments[0], axis, angle.value.as_scalar()?)
            }
            (Callee::Norm, [vector]) => {
                self.vector_argument(name, &arguments[0], vector)?;
                Some(Typed {
                    value: FormulaValue::scalar(self.norm(&vector.value)),
                    exponent: vector.exponent,
                })
            }
            (_, [left, right]) => {
                let first = self.vector_argument(name, &arguments[0], left);
                self.vector_argument(name, &arguments[1], right)?;
                first?;
                if let Some(remedy) = clash(left.measure(), right.measure()) {
                    self.mistakes.error(
                        arguments[0].extent.to(arguments[1].extent),
                        format!(
                            "`{name}` takes two plane vectors or two space vectors, but these are {} and {}: {remedy}",
                            left.measure(),
                            right.measure()
                        ),
                    );
                    return None;
                }
                let (a, b) = (left.value.nodes(), right.value.nodes());
                let graph = &mut *self.graph;
                let mut minor = |i: usize, j: usize| {
                    let (first, second) = (graph.multiply(a[i], b[j]), graph.multiply(a[j], b[i]));
                    graph.subtract(first, second)
                };
                let value = match (callee, a.len()) {
                    (Callee::Cross, 2) => FormulaValue::scalar(minor(0, 1)),
                    (Callee::Cross, _) => FormulaValue::space([minor(1, 2), minor(2, 0), minor(0, 1)]),
                    _ => FormulaValue::scalar(inner(graph, &a, &b)),
                };
                Some(Typed {
                    value,
                    exponent: product(left.exponent, right.exponent),
                })
            }
            _ => None,
        }
    }

    fn norm(&mut self, vector: &FormulaValue) -> Node {
        let parts = vector.nodes();
        let square = inner(self.graph, &parts, &parts);
        self.graph.call(Function::Sqrt, &[square])
    }

    fn rotation_about(
        &mut self,
        axis: Axis,
        name: &str,
        argument: &TypedFormula,
        typed: &Typed,
        angle: Node,
    ) -> Option<Typed> {
        self.expect_angle(name, argument, typed)?;
        let (zero, one) = (self.graph.zero(), self.graph.one());
        let parts = [Axis::X, Axis::Y, Axis::Z].map(|known| if known == axis { one } else { zero });
        Some(Typed::number(self.rodrigues(parts, angle)))
    }

    /// A rotation about an axis of any nonzero length.
    fn rotation(&mut self, argument: &TypedFormula, axis: &Typed, angle: Node) -> Option<Typed> {
        if axis.value.shape() == ValueShape::Plane {
            self.mistakes.error(
                argument.extent,
                "the axis of a rotation is a space vector, but this is a plane vector: write `vec3(v.x, v.y, 0)` for \
                 an axis in                  the plane, `rot_z(angle)` to turn the plane itself",
            );
            return None;
        }
        let length = self.norm(&axis.value);
        if self.graph.constant_value(length) == Some(0.0) {
            self.mistakes.error(
                argument.extent,
                "this axis is zero and has no direction: write a nonzero vector",
            );
            return None;
        }
        let [x, y, z] = axis.value.nodes()[..] else {
            return None;
        };
        let unit = [x, y, z].map(|part| self.graph.divide(part, length));
        Some(Typed::number(self.rodrigues(unit, angle)))
    }

    /// The rotation about a unit vector u: u uᵀ + cos θ (1 - u uᵀ) + sin θ u×.
    fn rodrigues(&mut self, unit: [Node; 3], angle: Node) -> FormulaValue {
        let graph = &mut *self.graph;
        let cosine = graph.call(Function::Cos, &[angle]);
        let sine = graph.call(Function::Sin, &[angle]);
        let rows = [0, 1, 2].map(|row: usize| {
            [0, 1, 2].map(|column: usize| {
                let along = graph.multiply(unit[row], unit[column]);
                let identity = graph.number(if row == column { 1.0 } else { 0.0 });
                let across = graph.subtract(identity, along);
                let across = graph.multiply(cosine, across);
                // the entry of u× is the third part of u, negative if the column follows the row
                let rotated = if row == column {
                    graph.zero()
                } else {
                    let third = graph.multiply(sine, unit[3 - row - column]);
                    if (row + 1) % 3 == column {
                        graph.negate(third)
                    } else {
                        third
                    }
                };
                graph.sum(&[along, across, rotated])
            })
        });
        FormulaValue::rotation(rows)
    }

    /// `length * (cos, sin)`
    fn along_angle(&mut self, length: Option<Node>, angle: Node) -> FormulaValue {
        let cosine = self.graph.call(Function::Cos, &[angle]);
        let sine = self.graph.call(Function::Sin, &[angle]);
        match length {
            None => FormulaValue::plane(cosine, sine),
            Some(length) => FormulaValue::plane(self.graph.multiply(length, cosine), self.graph.multiply(length, sine)),
        }
    }

    fn elementary(
        &mut self,
        function: Function,
        arguments: &[TypedFormula],
        typed: &[Typed],
        nodes: &[Node],
    ) -> Option<Typed> {
        let name = function.name();
        match function.takes() {
            Takes::Anything => {}
            Takes::Alike => {
                self.same_dimension(name, arguments, typed)?;
            }
            Takes::Angle => {
                let remedy = Remedy::Divide {
                    instead_of_length: "divide it by a length",
                };
                self.expect_number(name, "an angle or a ratio", remedy, &arguments[0], &typed[0])?;
            }
            Takes::Number {
                wanted,
                instead_of_length,
            } => {
                for (argument, typed) in arguments.iter().zip(typed) {
                    let remedy = Remedy::Divide { instead_of_length };
                    self.expect_number(name, wanted, remedy, argument, typed)?;
                }
            }
        }
        let exponent = match function.gives() {
            Gives::Number | Gives::Angle => Some(Exponent::NUMBER),
            Gives::Root => typed[0].exponent.map(Exponent::half),
        };
        if let Some(domain) = function.left_domain(self.graph, nodes) {
            let extent = arguments[0].extent.to(arguments[arguments.len() - 1].extent);
            self.mistakes.error(
                extent,
                format!("this is outside the domain of `{name}`, which {domain}"),
            );
            return None;
        }
        Some(Typed {
            value: FormulaValue::scalar(self.graph.call(function, nodes)),
            exponent,
        })
    }

    /// The argument of a function of scalars.
    fn scalar_argument(&mut self, name: &str, argument: &TypedFormula, typed: &Typed) -> Option<Node> {
        let measure = typed.measure();
        let remedy = match measure.shape {
            ValueShape::Scalar => return typed.value.as_scalar(),
            ValueShape::Plane => "write its part `.x` or `.y`",
            ValueShape::Space => "write its part `.x`, `.y` or `.z`",
            ValueShape::Rotation => "write the angle itself",
        };
        self.mistakes.error(
            argument.extent,
            format!("`{name}` takes scalars, but this is {measure}: {remedy}"),
        );
        None
    }

    fn vector_argument(&mut self, name: &str, argument: &TypedFormula, typed: &Typed) -> Option<()> {
        let measure = typed.measure();
        let remedy = match measure.shape {
            ValueShape::Plane | ValueShape::Space => return Some(()),
            ValueShape::Scalar => "write `vec3(x, y, z)`, or `vec2(x, y)` in the plane",
            ValueShape::Rotation => "write a vector that it turns, `rotation * v`",
        };
        self.mistakes.error(
            argument.extent,
            format!("`{name}` takes a vector here, but this is {measure}: {remedy}"),
        );
        None
    }

    fn expect_angle(&mut self, name: &str, argument: &TypedFormula, typed: &Typed) -> Option<()> {
        let remedy = Remedy::Divide {
            instead_of_length: "divide it by a length",
        };
        self.expect_number(name, "an angle", remedy, argument, typed)
    }

    fn expect_second_angle(
        &mut self,
        name: &str,
        form: &'static str,
        argument: &TypedFormula,
        typed: &Typed,
    ) -> Option<()> {
        self.expect_number(
            name,
            "an angle as its second argument",
            Remedy::Write(form),
            argument,
            typed,
        )
    }

    fn expect_number(
        &mut self,
        name: &str,
        wanted: &str,
        remedy: Remedy,
        argument: &TypedFormula,
        typed: &Typed,
    ) -> Option<()> {
        let measure = typed.measure();
        if measure.is_number() {
            return Some(());
        }
        let remedy = match remedy {
            Remedy::Write(form) => format!("write `{form}`"),
            Remedy::Divide { instead_of_length } if measure.exponent == Some(Exponent::LENGTH) => {
                instead_of_length.to_owned()
            }
            Remedy::Divide { .. } => "divide it by something of the same dimension".to_owned(),
        };
        self.mistakes.error(
            argument.extent,
            format!("`{name}` takes {wanted}, but this is {measure}: {remedy}"),
        );
        None
    }

    fn same_dimension(&mut self, name: &str, arguments: &[TypedFormula], typed: &[Typed]) -> Option<FormulaType> {
        let measures: Vec<FormulaType> = typed.iter().map(Typed::measure).collect();
        let shared = measures[1..]
            .iter()
            .try_fold(measures[0], |shared, &measure| common(shared, measure));
        if shared.is_none() {
            let quantity = if measures.len() == 2 { "both" } else { "all" };
            let (last, first) = measures.split_last()?;
            let first: Vec<String> = first.iter().map(FormulaType::to_string).collect();
            let remedy = if name == Callee::Vec2.name() {
                "; a vector of a length and an angle is written `polar(length, angle)`"
            } else {
                ""
            };
            self.mistakes.error(
                arguments[0].extent.to(arguments[arguments.len() - 1].extent),
                format!(
                    "{quantity} arguments of `{name}` must have the same dimension, but they are {} and {last}{remedy}",
                    first.join(", "),
                ),
            );
        }
        shared
    }
}

/// The replacement for an argument that has a dimension.
#[derive(Clone, Copy)]
enum Remedy {
    /// The call as it should be written.
    Write(&'static str),
    /// A quotient without dimension.
    Divide { instead_of_length: &'static str },
}

/// The inner product: the sum of the products of the parts.
fn inner(graph: &mut Graph, a: &[Node], b: &[Node]) -> Node {
    let products: Vec<Node> = a.iter().zip(b).map(|(&a, &b)| graph.multiply(a, b)).collect();
    graph.sum(&products)
}

/// The advice for two values of these shapes that are added or compared, `None` if this is allowed. Beside plane
/// vectors a scalar lies along x, as a real number does beside complex numbers. In space no direction is preferred.
fn clash(left: FormulaType, right: FormulaType) -> Option<&'static str> {
    match (left.shape, right.shape) {
        (ValueShape::Rotation, _) | (_, ValueShape::Rotation) => {
            Some("write `rotation * vector` on both sides, or `a * b` for one rotation after another")
        }
        (ValueShape::Plane, ValueShape::Space) | (ValueShape::Space, ValueShape::Plane) => {
            Some("write `vec3(v.x, v.y, 0)` to place a plane vector v in space")
        }
        (ValueShape::Scalar, ValueShape::Space) if !left.is_zero() => {
            Some("write `vec3(s, 0, 0)` to place a scalar s along x")
        }
        (ValueShape::Space, ValueShape::Scalar) if !right.is_zero() => {
            Some("write `vec3(s, 0, 0)` to place a scalar s along x")
        }
        _ => None,
    }
}
