//! Newton's method in lanes: the ordinary method as long as it need not shorten its steps.
//!
//! A lane becomes NaN if its first step is too long, or if its corrections do not fall as fast as full steps need; the
//! ordinary method, with its tests and its damping, decides about it. So a lane that converges has taken the steps of
//! the ordinary method and reaches the same root.

use super::{Element, Lanes, verdicts};
use crate::failure::Failure;
use crate::number::Number;
use crate::solve::{
    CONVERGING, Determinant, Equations, FIRST_STEP, LINEAR_STEP, NEGLIGIBLE, NewtonMemory, QUADRATIC, Real, Scaling,
    corrected, factor_to,
};

/// The limit of steps. Full steps from a good guess double the digits; a problem that needs more steps should be
/// damped.
const ITERATIONS: u32 = 12;

/// The largest change of the determinant over a correction that is rounding, as a part of itself.
const LARGEST_CHANGE: f64 = 0.03;

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn root<const W: usize, const BITS: usize, E: Element>(
    point: &mut [Lanes<W, BITS, E>],
    sizes: &[Lanes<W, BITS, E>],
    memory: NewtonMemory<'_, Lanes<W, BITS, E>>,
    mut equations: impl Equations<Lanes<W, BITS, E>>,
) -> Result<(), Failure> {
    let [residuals, correction, root] = memory.vectors;
    let [jacobian, factors] = memory.matrices;
    let rows = memory.rows;
    root.fill(Lanes([E::nan(); W]));
    let (always, never) = (Lanes::certainly(true), Lanes::certainly(false));
    // the lanes that have not ended
    let mut pending = always;
    // the length of the step before, and the determinant where it began
    let mut previous: Option<(Lanes<W, BITS, E>, Determinant<Lanes<W, BITS, E>>)> = None;
    let mut is_last = false;
    for _ in 0..ITERATIONS {
        // Called at one site only: with two calls it would not be inlined into this function, and so not compiled for
        // the machine's vectors.
        equations.evaluate(point, residuals, jacobian);
        if let (true, Some((before, _))) = (is_last, previous) {
            corrected(factors, rows, residuals, correction);
            let arrives = pending & largest(correction).is_at_most(before * Lanes::constant(QUADRATIC));
            pending = pending & !arrives;
            for index in 0..point.len() {
                let end = point[index] + correction[index] * sizes[index];
                root[index] = arrives.chosen(end, root[index]);
            }
            if !pending.is_any() {
                break;
            }
        }
        let count = sizes.len().max(1);
        for (factors, jacobian) in factors.chunks_exact_mut(count).zip(jacobian.chunks_exact(count)) {
            for ((factor, entry), size) in factors.iter_mut().zip(jacobian).zip(sizes) {
                *factor = *entry * *size;
            }
        }
        // no step is longer than half a radian, or half the size of a length
        let scaling = if previous.is_some() {
            Scaling::Kept
        } else {
            Scaling::New
        };
        let elimination = factor_to(factors, rows, E::EPSILON, scaling)?;
        let determinant = Determinant::of(factors, rows, elimination.is_odd);
        corrected(factors, rows, residuals, correction);
        let length = largest(correction);
        let mut is_lost = always;
        for index in 0..point.len() {
            let change = correction[index] * sizes[index];
            correction[index] = change;
            let size = sizes[index].or_larger(point[index].magnitude());
            is_lost = is_lost & change.magnitude().is_at_most(size * Lanes::constant(E::EPSILON));
        }
        // where the next correction may be a simplified one, and is the last
        let mut ends = never;
        let (is_root, is_full) = if let Some((before, last_determinant)) = previous {
            let contraction = length / before;
            let next = contraction * contraction * length;
            let is_foretold = next.is_at_most(Lanes::constant(NEGLIGIBLE * E::EPSILON));
            let is_quadratic = contraction.is_at_most(Lanes::constant(QUADRATIC));
            let is_full = contraction.is_at_most(Lanes::constant(CONVERGING));
            let mut is_root = is_quadratic & (is_lost | is_foretold);
            // A small correction that does not fall is rounding, and the last point is the root if the determinant
            // hardly changes over it. The ordinary method allows a change of a quarter.
            let is_rounding = (before * before).is_at_most(Lanes::constant(LINEAR_STEP * E::EPSILON)) & !is_full;
            if (pending & is_rounding).is_any() {
                let change = determinant.relative_to(last_determinant) - Lanes::constant(1.0);
                let is_distinct = change.magnitude().is_at_most(Lanes::constant(LARGEST_CHANGE));
                is_root = is_root | is_rounding & is_distinct;
            }
            let error = Lanes::constant(2.0) * contraction * contraction * next;
            ends = is_quadratic & error.is_at_most(Lanes::constant(NEGLIGIBLE * E::EPSILON));
            (is_root, is_full)
        } else {
            (is_lost, length.is_at_most(Lanes::constant(FIRST_STEP)))
        };
        let arrives = pending & is_root;
        pending = pending & is_full & !is_root;
        // Lanes that have ended keep their values.
        for index in 0..point.len() {
            let end = point[index] + correction[index];
            root[index] = arrives.chosen(end, root[index]);
            point[index] = pending.chosen(end, point[index]);
        }
        if !pending.is_any() {
            break;
        }
        previous = Some((length, determinant));
        is_last = !(pending & !ends).is_any();
    }
    point.copy_from_slice(root);
    let missing = root
        .iter()
        .fold(Lanes::constant(0.0), |sum, entry| sum + *entry * Lanes::constant(0.0));
    verdicts::record(missing);
    Ok(())
}

/// The largest magnitude in each lane. NaN does not count: the lane that has it ends as NaN anyway.
#[cfg_attr(not(debug_assertions), inline(always))]
fn largest<const W: usize, const BITS: usize, E: Element>(vector: &[Lanes<W, BITS, E>]) -> Lanes<W, BITS, E> {
    let sizes = vector.iter().map(|entry| entry.magnitude());
    sizes.fold(Lanes::constant(0.0), Lanes::or_larger)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::newton;

    type Four = Lanes<4, 128>;

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
        for shift in [0.0, 4e-16, 1e-12, 1e-6, 1e-3, 0.01] {
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
}
