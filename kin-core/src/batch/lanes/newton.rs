//! Newton's method in lanes: the ordinary method as long as it need not shorten its steps.
//!
//! A lane becomes NaN if its first step is too long, or if its corrections do not fall as fast as full steps need; the
//! ordinary method, with its tests and its damping, decides about it. So a lane that converges has taken the steps of
//! the ordinary method and reaches the same root.

#![expect(clippy::needless_range_loop, reason = "lanes are an index into several arrays")]

use num_traits::Float;

use super::{Element, Lanes, verdicts};
use crate::failure::Failure;
use crate::number::Number;
use crate::solve::{
    CONVERGING, Equations, FIRST_STEP, FactorRow, NEGLIGIBLE, NewtonMemory, QUADRATIC, Scalar, factor_in, substitute_in,
};

/// The limit of steps. Full steps from a good guess double the digits; a problem that needs more steps should be
/// damped.
const ITERATIONS: u32 = 12;

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn root<const W: usize, const FUSED: bool, E: Element>(
    point: &mut [Lanes<W, FUSED, E>],
    sizes: &[Lanes<W, FUSED, E>],
    memory: NewtonMemory<'_, Lanes<W, FUSED, E>>,
    mut equations: impl Equations<Lanes<W, FUSED, E>>,
) -> Result<(), Failure> {
    let [residuals, correction, end, root] = memory.vectors;
    let (factors, rows) = (memory.matrix, memory.rows);
    root.fill(Lanes([E::nan(); W]));
    let mut pending = [true; W];
    let mut previous: Option<Lanes<W, FUSED, E>> = None;
    for _ in 0..ITERATIONS {
        // Called at one site only: with two calls it would not be inlined into this function, and so not compiled for
        // the machine's vectors.
        equations.evaluate(point, residuals, factors);
        for row in factors.chunks_exact_mut(sizes.len().max(1)) {
            for (entry, size) in row.iter_mut().zip(sizes) {
                *entry = *entry * *size;
            }
        }
        factor_in(factors, rows)?;
        corrected(factors, rows, residuals, correction);
        let length = largest(correction);
        for index in 0..point.len() {
            end[index] = point[index] + correction[index] * sizes[index];
        }
        for lane in 0..W {
            let is_lost = (0..point.len()).all(|index| {
                let size = point[index].0[lane].size() / sizes[index].0[lane];
                correction[index].0[lane].size() <= E::of(E::EPSILON) * Float::max(size, E::one())
            });
            let length = length.0[lane];
            let (is_root, is_full) = if let Some(previous) = &previous {
                let contraction = length / previous.0[lane];
                let next = contraction * contraction * length;
                (
                    contraction <= E::of(QUADRATIC) && (is_lost || next <= E::of(NEGLIGIBLE * E::EPSILON)),
                    contraction <= E::of(CONVERGING),
                )
            } else {
                (is_lost, length <= E::of(FIRST_STEP))
            };
            if pending[lane] && is_root {
                for (root, end) in root.iter_mut().zip(&*end) {
                    root.0[lane] = end.0[lane];
                }
            }
            pending[lane] &= is_full && !is_root;
        }
        if !pending.contains(&true) {
            break;
        }
        // Lanes that have finished keep their values.
        for (entry, end) in point.iter_mut().zip(&*end) {
            for lane in 0..W {
                if pending[lane] {
                    entry.0[lane] = end.0[lane];
                }
            }
        }
        previous = Some(length);
    }
    point.copy_from_slice(root);
    let missing = root
        .iter()
        .fold(Lanes::constant(0.0), |sum, entry| sum + *entry * Lanes::constant(0.0));
    verdicts::record(missing);
    Ok(())
}

/// The correction that removes the residuals.
#[cfg_attr(not(debug_assertions), inline(always))]
fn corrected<T: Scalar>(factors: &[T], rows: &[FactorRow], residuals: &[T], correction: &mut [T]) {
    substitute_in(factors, rows, residuals, correction);
    for entry in correction {
        *entry = -*entry;
    }
}

/// The largest magnitude, or NaN if an entry is NaN.
#[cfg_attr(not(debug_assertions), inline(always))]
fn largest<const W: usize, const FUSED: bool, E: Element>(vector: &[Lanes<W, FUSED, E>]) -> Lanes<W, FUSED, E> {
    let mut largest = Lanes::constant(0.0);
    for entry in vector {
        largest = largest.with(*entry, |largest, entry| {
            let size = entry.size();
            if size <= largest || Float::is_nan(largest) {
                largest
            } else {
                size
            }
        });
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::newton;

    type Four = Lanes<4, false>;

    /// The system x² + y = p, x y³ = q, with its Jacobian.
    fn system<T: crate::solve::Scalar>(p: T, q: T) -> impl Fn([T; 2]) -> ([T; 2], [[T; 2]; 2]) {
        move |[x, y]| {
            let (two, three) = (T::constant(2.0), T::constant(3.0));
            let residuals = [x * x + y - p, x * y * y * y - q];
            (residuals, [[two * x, T::constant(1.0)], [y * y * y, three * x * y * y]])
        }
    }

    /// A lane that converges reaches the root of the ordinary method in few steps from a good guess. A lane with a bad
    /// guess does not converge.
    #[test]
    fn lanes_arrive_where_the_ordinary_method_does() {
        let roots = [[1.0, 2.0], [0.8, 1.2], [2.0, -1.0], [-1.0, 0.8]];
        let given = roots.map(|[x, y]: [f64; 2]| [x * x + y, x * y * y * y]);
        let sizes = [3.0, 0.25];
        for shift in [1e-12, 1e-6, 1e-3, 0.01] {
            let guesses = roots.map(|[x, y]| [x + shift, y - 0.5 * shift]);
            let lanes = |of: &dyn Fn(usize) -> f64| Four::from_fn(of);
            let evaluate = system(lanes(&|lane| given[lane][0]), lanes(&|lane| given[lane][1]));
            let guess = [lanes(&|lane| guesses[lane][0]), lanes(&|lane| guesses[lane][1])];
            let found = newton(guess, sizes.map(Four::constant), &evaluate).unwrap();
            for lane in 0..4 {
                let expected = newton(guesses[lane], sizes, system(given[lane][0], given[lane][1])).unwrap();
                for (found, expected) in found.iter().zip(expected) {
                    // The system is well-conditioned, so both methods stop within a few ε.
                    assert!(
                        (found.0[lane] - expected).abs() <= 1e-13,
                        "{shift} {lane}: {found:?} {expected}"
                    );
                }
            }
        }
        // A step as long as the unknown itself is too long.
        let evaluate = system(Four::constant(3.0), Four::constant(8.0));
        let guess = [Lanes([1.001, 40.0, f64::NAN, 1.001]), Lanes([2.001, -3.0, 2.0, 1.999])];
        let [x, _] = newton(guess, [1.0, 2.0].map(Four::constant), &evaluate).unwrap();
        assert_eq!(x.0.map(f64::is_finite), [true, false, false, true], "{x:?}");
    }

    #[test]
    fn the_largest_magnitude_is_that_of_each_lane() {
        let row = [Lanes([1.0, -5.0, f64::NAN, 0.0]), Lanes([-2.0, 3.0, 1.0, f64::NAN])];
        let Lanes(found) = largest::<4, false, f64>(&row);
        assert_eq!(found[..2], [2.0, 5.0]);
        assert!(found[2].is_nan() && found[3].is_nan(), "{found:?}");
    }
}
