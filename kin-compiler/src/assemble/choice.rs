//! The choice between two solutions, by the caller or by a declared range, and the sign that distinguishes them.

use std::collections::BTreeMap;

use crate::algebra::{Graph, Node, Symbol};
use crate::program::{DeclaredRange, Mode};
use crate::structure::{ClosedForm, Method, Part};

/// The mode in which a part's solution is chosen. `assemblies` counts the choices left to the caller.
pub(super) fn mode(
    graph: &Graph,
    part: &Part,
    ranges: &BTreeMap<usize, DeclaredRange>,
    assemblies: &mut usize,
) -> Mode {
    let form = match &part.method {
        Method::Closed(form) if form.has_assemblies() => form,
        _ => return Mode::Only,
    };
    let ranged: Vec<(usize, DeclaredRange)> = part
        .unknowns
        .iter()
        .filter_map(|&unknown| Some((unknown, *ranges.get(&unknown)?)))
        .collect();
    if ranged.is_empty() {
        *assemblies += 1;
        return Mode::Assembly(*assemblies - 1);
    }
    ranged
        .into_iter()
        .find_map(|(unknown, limits)| fixed_by_range(graph, form, unknown, limits))
        .map_or(Mode::Ranged, |is_open| Mode::Fixed { is_open })
}

/// An expression that is positive in the open assembly.
pub(super) fn orientation(graph: &mut Graph, part: &Part) -> Option<Node> {
    match &part.method {
        Method::Closed(form) => orientation_of(graph, form),
        Method::Newton { .. } => None,
    }
}

fn orientation_of(graph: &mut Graph, form: &ClosedForm) -> Option<Node> {
    Some(match form {
        ClosedForm::Linear { .. }
        | ClosedForm::LinearPair { .. }
        | ClosedForm::LinearSystem { .. }
        | ClosedForm::Direction { .. } => return None,
        ClosedForm::Inverse { then, .. } => return orientation_of(graph, then),
        ClosedForm::SquareRoot { unknown, .. } => graph.symbol(Symbol::Unknown(*unknown)),
        ClosedForm::EvenInverse {
            unknown,
            coefficient,
            middle,
            ..
        } => {
            // the distance of the unknown from the middle, times the square of the coefficient
            let x = graph.symbol(Symbol::Unknown(*unknown));
            let product = graph.multiply(*coefficient, x);
            let distance = graph.subtract(product, *middle);
            graph.multiply(*coefficient, distance)
        }
        ClosedForm::Quadratic { unknown, a, b, .. } => {
            let x = graph.symbol(Symbol::Unknown(*unknown));
            let double = graph.product(&[(*a, 1), (x, 1)]);
            let slope = graph.linear(0.0, &[(double, 2.0), (*b, 1.0)]);
            graph.multiply(*a, slope)
        }
        ClosedForm::InverseCosine { unknown, .. } => {
            let x = graph.symbol(Symbol::Unknown(*unknown));
            graph.sine(x)
        }
        ClosedForm::InverseSine { unknown, .. } => {
            let x = graph.symbol(Symbol::Unknown(*unknown));
            graph.cosine(x)
        }
        ClosedForm::CosineSine { unknown, a, b, .. } => {
            let x = graph.symbol(Symbol::Unknown(*unknown));
            let (cosine, sine) = (graph.cosine(x), graph.sine(x));
            let (first, second) = (graph.multiply(*a, sine), graph.multiply(*b, cosine));
            graph.subtract(first, second)
        }
        ClosedForm::TwoAngles {
            arms: [first, second], ..
        } => {
            // -(v₁ × v₂) with v = factor · cis(± angle)
            let (ratio, rotation) = first.turn_to(graph, second);
            let (along, across) = (
                graph.multiply(ratio.re, rotation.im),
                graph.multiply(ratio.im, rotation.re),
            );
            let cross = graph.add(along, across);
            graph.negate(cross)
        }
        ClosedForm::AngleLength { arm, direction, .. } => {
            // -(v · direction)
            let vector = arm.vector(graph);
            let (x, y) = (
                graph.multiply(vector.re, direction.re),
                graph.multiply(vector.im, direction.im),
            );
            let dot = graph.add(x, y);
            graph.negate(dot)
        }
        ClosedForm::Polar { length, offset, .. } => {
            let length = graph.symbol(Symbol::Unknown(*length));
            graph.add(length, offset.re)
        }
    })
}

/// Whether a range chooses the open solution, `None` if the range does not decide for all dimensions.
fn fixed_by_range(graph: &Graph, form: &ClosedForm, unknown: usize, limits: DeclaredRange) -> Option<bool> {
    use std::f64::consts::{FRAC_PI_2, PI};
    const SLACK: f64 = 1e-12;
    let within = |low: f64, high: f64| limits.low >= low - SLACK && limits.high <= high + SLACK;
    match form {
        ClosedForm::SquareRoot { .. } => by_sign(limits),
        ClosedForm::EvenInverse { middle, .. } if graph.is_zero(*middle) => by_sign(limits),
        ClosedForm::Polar { length, offset, .. } if *length == unknown && graph.is_zero(offset.re) => by_sign(limits),
        ClosedForm::InverseCosine { .. } if within(0.0, PI) => Some(true),
        ClosedForm::InverseCosine { .. } if within(-PI, 0.0) || within(PI, 2.0 * PI) => Some(false),
        ClosedForm::InverseSine { .. } if within(-FRAC_PI_2, FRAC_PI_2) => Some(true),
        ClosedForm::InverseSine { .. } if within(FRAC_PI_2, 3.0 * FRAC_PI_2) => Some(false),
        ClosedForm::Inverse { then, .. } => fixed_by_range(graph, then, unknown, limits),
        _ => None,
    }
}

fn by_sign(limits: DeclaredRange) -> Option<bool> {
    if limits.low >= 0.0 {
        Some(true)
    } else if limits.high <= 0.0 {
        Some(false)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use super::*;
    use crate::algebra::{Function, Inverse};

    /// A range decides for all dimensions if it contains only one of the two solutions.
    #[test]
    fn ranges_within_half_a_turn_decide() {
        let mut graph = Graph::new();
        let one = graph.one();
        let cosine = ClosedForm::InverseCosine {
            unknown: 0,
            radius: one,
            width: one,
        };
        let sine = ClosedForm::InverseSine {
            unknown: 0,
            radius: one,
            height: one,
        };
        let root = ClosedForm::SquareRoot {
            unknown: 0,
            square: one,
        };
        let Inverse::Even(inverse) = Function::Cosh.inverse() else {
            panic!("cosh is even");
        };
        let (zero, result) = (graph.zero(), graph.new_step());
        let around = |middle: Node| ClosedForm::EvenInverse {
            function: Function::Cosh,
            inverse,
            unknown: 0,
            value: one,
            result: result.0,
            growth: one,
            coefficient: one,
            right: result.1,
            middle,
        };
        let (even, beside) = (around(zero), around(one));
        for (form, low, high, expected) in [
            (&cosine, 0.0, PI, Some(true)),
            (&cosine, 0.5, 1.0, Some(true)),
            (&cosine, -PI, 0.0, Some(false)),
            (&cosine, PI, 2.0 * PI, Some(false)),
            (&cosine, -1.0, 1.0, None),
            (&cosine, 1.0, 4.0, None),
            (&cosine, -4.0, -1.0, None),
            (&sine, -FRAC_PI_2, FRAC_PI_2, Some(true)),
            (&sine, FRAC_PI_2, 3.0 * FRAC_PI_2, Some(false)),
            (&sine, FRAC_PI_2, 3.0 * FRAC_PI_2 + 0.01, None),
            (&sine, 2.0, 4.7, Some(false)),
            (&sine, -2.0, 1.0, None),
            (&sine, 1.0, 2.0, None),
            (&even, 0.0, f64::INFINITY, Some(true)),
            (&even, -3.0, 0.0, Some(false)),
            (&even, -1.0, 2.0, None),
            (&beside, 0.0, 5.0, None),
            (&root, 0.0, 1.0, Some(true)),
            (&root, -1.0, 0.0, Some(false)),
            (&root, -1.0, 1.0, None),
        ] {
            let limits = DeclaredRange { low, high };
            assert_eq!(
                fixed_by_range(&graph, form, 0, limits),
                expected,
                "{form:?} {low} {high}"
            );
        }
    }
}
