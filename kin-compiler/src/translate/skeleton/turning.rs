//! How a term moves: what it rotates with, and whether its length changes.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::model::ValueShape;
use crate::syntax::{ArithmeticOperator, Axis, Callee, FormulaKind, TypedFormula};
use crate::translate::formula::product;
use crate::translate::tree::{Operation, Tree};

use super::{SkeletonNames, in_picture};

/// The angles that a term rotates with, without constants: equal for terms that keep their angle to each other, empty
/// for those that do not rotate.
pub(super) type TurningAngles = String;

/// How a term moves.
pub(super) enum Manner {
    /// Its length is constant.
    Rigid(TurningAngles),
    /// Its length is not. The direction has any length but zero.
    Sliding {
        turning: TurningAngles,
        direction: SlideDirection,
    },
    /// Nothing is known of it.
    Free,
}

/// The direction of a slide.
#[derive(Clone)]
pub(super) struct SlideDirection {
    pub(super) tree: Tree,
    /// As a declaration writes it.
    pub(super) text: String,
}

/// How a term moves in a picture of the given shape.
pub(super) fn manner(formula: &TypedFormula, shape: ValueShape, names: &SkeletonNames<'_>) -> Manner {
    let Some(factor) = factor(formula, names) else {
        return Manner::Free;
    };
    // a constant rotation behind the last one that varies belongs to the vector
    let varying = factor.rotations.iter().rposition(|(_, varies)| *varies);
    let rotations = factor.rotations.iter().take(varying.map_or(0, |last| last + 1));
    let mut turning: String = rotations.map(|(rotation, _)| rotation.as_str()).collect();
    for (angle, times) in &factor.angles {
        if *times != 0.0 {
            // a String never refuses what is written to it
            let _ = write!(turning, "{times}*{angle} ");
        }
    }
    if !factor.slides {
        return Manner::Rigid(turning);
    }
    let direction = match factor.direction {
        None => axis(Axis::X, shape),
        Some(direction) => SlideDirection {
            tree: in_picture(direction.tree, shape),
            ..direction
        },
    };
    Manner::Sliding { turning, direction }
}

/// A factor of a term.
#[derive(Default)]
struct Factor {
    /// The angles in a plane that it rotates with, and how many times.
    angles: BTreeMap<String, f64>,
    /// The rotations of space in it, and whether they vary.
    rotations: Vec<(String, bool)>,
    /// Whether a scalar in it varies.
    slides: bool,
    /// The vector in it, without such scalars; none if it is a scalar.
    direction: Option<SlideDirection>,
}

/// `None` if it varies in another way than by rotating or by a scalar factor.
fn factor(formula: &TypedFormula, names: &SkeletonNames<'_>) -> Option<Factor> {
    let vector = names.tree(formula);
    let shape = vector.shape;
    if shape == ValueShape::Scalar {
        return Some(Factor {
            slides: names.varies(formula),
            ..Factor::default()
        });
    }
    if !names.varies(formula) {
        let rotation = (shape == ValueShape::Rotation).then(|| (formula.to_string(), false));
        return Some(Factor {
            rotations: rotation.into_iter().collect(),
            direction: Some(SlideDirection {
                tree: vector,
                text: format!("({formula})"),
            }),
            ..Factor::default()
        });
    }
    match &formula.kind {
        FormulaKind::Parenthesis(inner) | FormulaKind::Negate(inner) => factor(inner, names),
        FormulaKind::Name(name) => factor(names.behind(name)?, names),
        FormulaKind::Product { first, rest } => {
            let mut product = factor(first, names)?;
            for operand in rest {
                product.times(factor(&operand.formula, names)?);
            }
            Some(product)
        }
        FormulaKind::Call { callee, arguments, .. } => {
            let text = formula.to_string();
            call(*callee, arguments, SlideDirection { tree: vector, text }, names)
        }
        _ => None,
    }
}

fn call(
    callee: Callee,
    arguments: &[TypedFormula],
    vector: SlideDirection,
    names: &SkeletonNames<'_>,
) -> Option<Factor> {
    let mut factor = Factor::default();
    match (callee, arguments) {
        (Callee::Cis, [angle]) => {
            add_angle(angle, 1.0, names, &mut factor.angles);
            factor.direction = Some(vector);
        }
        (Callee::Polar, [length, angle]) => {
            add_angle(angle, 1.0, names, &mut factor.angles);
            factor.slides = names.varies(length);
            factor.direction = Some(SlideDirection {
                tree: Tree::call(ValueShape::Plane, Operation::Cis, vec![names.tree(angle)]),
                text: format!("cis({angle})"),
            });
        }
        (Callee::RotX | Callee::RotY | Callee::RotZ, [angle]) => {
            let mut angles = BTreeMap::new();
            add_angle(angle, 1.0, names, &mut angles);
            factor.rotations.push((format!("{} {angles:?} ", callee.name()), true));
            factor.direction = Some(vector);
        }
        (Callee::Rot, [axis, angle]) if !names.varies(axis) => {
            let mut angles = BTreeMap::new();
            add_angle(angle, 1.0, names, &mut angles);
            factor.rotations.push((format!("{axis} {angles:?} "), true));
            factor.direction = Some(vector);
        }
        (Callee::Vec2 | Callee::Vec3, coordinates) => {
            let axes = [Axis::X, Axis::Y, Axis::Z];
            let mut varying = coordinates.iter().zip(axes).filter(|(value, _)| names.varies(value));
            let (_, along) = varying.next()?;
            if varying.next().is_some() {
                return None;
            }
            let shape = if callee == Callee::Vec2 {
                ValueShape::Plane
            } else {
                ValueShape::Space
            };
            factor.slides = true;
            factor.direction = Some(axis(along, shape));
        }
        _ => return None,
    }
    Some(factor)
}

impl Factor {
    fn times(&mut self, other: Self) {
        for (angle, times) in other.angles {
            *self.angles.entry(angle).or_insert(0.0) += times;
        }
        self.rotations.extend(other.rotations);
        self.slides |= other.slides;
        self.direction = match (self.direction.take(), other.direction) {
            (Some(left), Some(right)) => Some(SlideDirection {
                tree: product(left.tree, right.tree),
                text: format!("{} * {}", left.text, right.text),
            }),
            (left, right) => left.or(right),
        };
    }
}

/// The unit vector along an axis.
fn axis(along: Axis, shape: ValueShape) -> SlideDirection {
    let parts = || shape.axes().iter().map(|known| if *known == along { 1.0 } else { 0.0 });
    let texts: Vec<String> = parts().map(|part: f64| part.to_string()).collect();
    SlideDirection {
        tree: Tree::call(shape, Operation::Vector, parts().map(Tree::number).collect()),
        text: format!("vec{}({})", texts.len(), texts.join(", ")),
    }
}

/// An angle as a sum of what varies in it, each so many times.
fn add_angle(formula: &TypedFormula, times: f64, names: &SkeletonNames<'_>, sum: &mut BTreeMap<String, f64>) {
    if !names.varies(formula) {
        return;
    }
    match &formula.kind {
        FormulaKind::Parenthesis(inner) => return add_angle(inner, times, names, sum),
        FormulaKind::Negate(inner) => return add_angle(inner, -times, names, sum),
        FormulaKind::Name(name) => {
            if let Some(value) = names.behind(name) {
                return add_angle(value, times, names, sum);
            }
        }
        FormulaKind::Sum { first, rest } => {
            add_angle(first, times, names, sum);
            for operand in rest {
                let sign = if operand.operator == ArithmeticOperator::Subtract {
                    -1.0
                } else {
                    1.0
                };
                add_angle(&operand.formula, sign * times, names, sum);
            }
            return;
        }
        FormulaKind::Product { first, rest } => {
            if let (FormulaKind::Number { value, .. }, [operand]) = (&first.kind, rest.as_slice())
                && operand.operator == ArithmeticOperator::Multiply
            {
                return add_angle(&operand.formula, value * times, names, sum);
            }
        }
        _ => {}
    }
    *sum.entry(formula.to_string()).or_insert(0.0) += times;
}
