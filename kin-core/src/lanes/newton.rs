//! Newton's method in lanes: the steps that the ordinary method takes where it has no need to shorten them.
//!
//! A lane whose first step is too long, or whose corrections do not fall as they must for a full step, becomes NaN; the ordinary
//! method, with its damping, decides about it. So a lane that arrives has come by the steps of the ordinary method, and at the same root.

use super::Lanes;
use crate::solve::{FIRST_STEP, LINEAR_STEP, factor};
use crate::{Failure, Scalar};

/// Full steps from a good guess double the digits; who needs more than this is better damped.
const ITERATIONS: u32 = 12;

#[inline(always)]
pub(super) fn root<const W: usize, const FUSED: bool, const N: usize>(
    guess: [Lanes<W, FUSED>; N],
    sizes: [Lanes<W, FUSED>; N],
    mut evaluate: impl FnMut([Lanes<W, FUSED>; N]) -> ([Lanes<W, FUSED>; N], [[Lanes<W, FUSED>; N]; N]),
) -> Result<[Lanes<W, FUSED>; N], Failure> {
    let mut evaluate = |unknowns: [Lanes<W, FUSED>; N]| {
        let (residuals, mut jacobian) = evaluate(unknowns);
        for row in &mut jacobian {
            for (entry, size) in row.iter_mut().zip(sizes) {
                *entry = *entry * size;
            }
        }
        (residuals, jacobian)
    };
    let mut point = guess;
    let mut root = [Lanes([f64::NAN; W]); N];
    let mut pending = [true; W];
    let (mut residuals, jacobian) = evaluate(point);
    let mut factors = factor(jacobian)?;
    // Of the step before: its length, the correction foreseen after it, and by what the determinant has changed.
    let mut before: Option<(Lanes<W, FUSED>, [Lanes<W, FUSED>; N])> = None;
    let mut ratio = Lanes::constant(1.0);
    for _ in 0..ITERATIONS {
        let correction = negated(factors.solve(residuals));
        let length = largest(&correction);
        let mut end = point;
        for (index, entry) in end.iter_mut().enumerate() {
            *entry = *entry + correction[index] * sizes[index];
        }
        let (previous, foreseen) = match before {
            Some((previous, expected)) => {
                let difference: [_; N] = core::array::from_fn(|index| expected[index] - correction[index]);
                let forecast = (previous * largest(&expected), largest(&difference) * length);
                (previous, forecast)
            }
            None => (
                Lanes::constant(f64::INFINITY),
                (Lanes::constant(1.0), Lanes::constant(0.0)),
            ),
        };
        for lane in 0..W {
            let lost = (0..N).all(|index| {
                let size = point[index].0[lane].abs() / sizes[index].0[lane];
                correction[index].0[lane].abs() <= f64::EPSILON * size.max(1.0)
            });
            let (length, previous) = (length.0[lane], previous.0[lane]);
            let stalled = length >= 0.5 * previous && length * length <= LINEAR_STEP * f64::EPSILON;
            let distinct = (0.75..=1.25).contains(&ratio.0[lane]);
            if pending[lane] && (lost || stalled) {
                pending[lane] = false;
                if distinct {
                    let place = if lost { &end } else { &point };
                    for (root, place) in root.iter_mut().zip(place) {
                        root.0[lane] = place.0[lane];
                    }
                }
            }
            let full = if before.is_some() {
                foreseen.0.0[lane] >= foreseen.1.0[lane]
            } else {
                length <= FIRST_STEP
            };
            pending[lane] &= full;
        }
        if !pending.contains(&true) {
            break;
        }
        // Lanes that have ended stay where they are.
        let here = point;
        for (entry, end) in point.iter_mut().zip(end) {
            for lane in 0..W {
                if pending[lane] {
                    entry.0[lane] = end.0[lane];
                }
            }
        }
        let (next, jacobian) = evaluate(point);
        let expected = negated(factors.solve(next));
        residuals = next;
        let there = factor(jacobian)?;
        ratio = there.determinant_relative_to(&factors);
        factors = there;
        let fall = largest(&expected);
        for lane in 0..W {
            let (length, fall) = (length.0[lane], fall.0[lane]);
            let falls = fall < 0.75 * length;
            // What does not fall and is small is rounding.
            let ends = !falls && length * length <= LINEAR_STEP * f64::EPSILON;
            if pending[lane] && ends && (0.75..=1.25).contains(&ratio.0[lane]) {
                let place = if fall < length { &point } else { &here };
                for (root, place) in root.iter_mut().zip(place) {
                    root.0[lane] = place.0[lane];
                }
            }
            pending[lane] &= falls;
        }
        before = Some((length, expected));
    }
    Ok(root)
}

#[inline(always)]
fn negated<const W: usize, const FUSED: bool, const N: usize>(vector: [Lanes<W, FUSED>; N]) -> [Lanes<W, FUSED>; N] {
    let mut negated = vector;
    for entry in &mut negated {
        *entry = -*entry;
    }
    negated
}

/// The largest magnitude; NaN if there is a NaN.
#[inline(always)]
fn largest<const W: usize, const FUSED: bool, const N: usize>(vector: &[Lanes<W, FUSED>; N]) -> Lanes<W, FUSED> {
    let mut largest = Lanes::constant(0.0);
    for entry in vector {
        largest = largest.with(*entry, |largest, entry| {
            let size = entry.abs();
            if size <= largest || largest.is_nan() {
                largest
            } else {
                size
            }
        });
    }
    largest
}
