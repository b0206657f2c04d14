//! Newton's method, for unknowns without a closed form.

use core::array;

use super::factor::{
    Determinant, FactorRow, Scaling, Scratch, amplification, condition, factor_in, factor_to, larger, substitute_in,
};
use crate::failure::Failure;
use crate::number::Number as _;
use crate::solve::Scalar;
use crate::solve::check::{Real, RowMeasure};

const QUANTITY: &str = "guess, size of an unknown, or residual or Jacobian there";
const SOLUTION: &str = "solution of a block without closed form, or its derivatives";

/// The number of steps after which the solver gives up. A good guess takes three or four.
pub(crate) const ITERATIONS: u32 = 64;
/// The limit of the first step, in the sizes of the unknowns: half a radian for an angle.
pub(crate) const FIRST_STEP: f64 = 0.5;
/// The square of a step over which the equations are linear, in units of ε.
pub(crate) const LINEAR_STEP: f64 = 4096.0;
/// The number of times a step is shortened, to half or less each time, before the solver gives up.
pub(crate) const TRIALS: u32 = 20;
/// The smallest part of a correction that a forecast may ask for.
pub(crate) const SMALLEST_PART: f64 = 1e-5;
/// The largest part of the correction before that a correction may be for the next step to be a full one. The measure
/// of P. Deuflhard, h, is then at most 1.
pub(crate) const CONVERGING: f64 = 0.5;
/// The largest part of the correction before from which the next correction is foretold: they fall quadratically, and
/// the determinant changes by less than a thirtieth over the last one.
pub(crate) const QUADRATIC: f64 = 0.125;
/// The correction, in units of ε, that is foretold where an iteration ends, and the error of a simplified correction
/// with which it ends.
pub(crate) const NEGLIGIBLE: f64 = 0.0625;

/// The root of as many equations as unknowns near a guess, found by Newton's method.
///
/// `sizes` gives the natural size of each unknown: 1 for an angle, a characteristic length for a length. `evaluate`
/// gives the residuals of the equations and their Jacobian, one row of partial derivatives for each equation.
///
/// A step is shortened until the next correction, computed with the same Jacobian, is smaller. So the residual must
/// fall, measured in the unknowns and not in the units of the equations. This is the natural monotonicity test with the
/// damping strategy of P. Deuflhard, *Newton Methods for Nonlinear Problems*, Springer 2004, section 3.3.3, algorithm
/// NLEQ-ERR. The first step is limited to half a radian or half the size of a length. The iteration ends when the
/// correction disappears in rounding: it is below ε times the unknown or its size, or it no longer falls and rounding,
/// magnified by the condition of the Jacobian, explains it. The method takes at most 64 steps, and shortens each at
/// most 20 times.
///
/// After a correction of at most half of the one before, the next step is a full one without this test: the measure h
/// of the same section is then at most 1. Once corrections fall to an eighth, each is about a constant times the square
/// of the one before. So the iteration ends with the correction after which the next one would disappear. The last
/// correction is a simplified one, by the factors of the Jacobian before, where these are as good: a step changes the
/// Jacobian by a part of about h.
///
/// The rows and columns of a Jacobian are scaled anew after a step that may have changed it much. After another step
/// they keep their scales.
///
/// All decisions and calculations so far use real parts. If the number carries derivatives up to order n, log₂(n + 1)
/// plain steps then add them: each step doubles the number of correct orders.
///
/// # Errors
/// [`Failure::NotConverged`] if the guess leads to no root, [`Failure::Singular`] if the Jacobian becomes singular or
/// the root is too close to a second one for rounding to separate them, [`Failure::NotFinite`].
///
/// ```
/// use kin_core::solve;
///
/// // where the circle x² + y² = 25 meets the hyperbola x y = 12
/// let [x, y] = solve::newton([2.5, 5.0], [1.0, 1.0], |[x, y]: [f64; 2]| {
///     ([x * x + y * y - 25.0, x * y - 12.0], [[2.0 * x, 2.0 * y], [y, x]])
/// })?;
/// assert!((x - 3.0).abs() < 1e-14 && (y - 4.0).abs() < 1e-14);
/// # Ok::<(), kin_core::Failure>(())
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn newton<T: Scalar, const N: usize>(
    guess: [T; N],
    sizes: [T; N],
    evaluate: impl FnMut([T; N]) -> ([T; N], [[T; N]; N]),
) -> Result<[T; N], Failure> {
    if const { T::DOUBT > 0.0 } {
        // for several poses at once it is compiled for the vectors of the processor, as its caller is
        newton_of(guess, sizes, evaluate)
    } else {
        newton_alone(guess, sizes, evaluate)
    }
}

/// Not inlined: the registers of its caller are then free, which saves a tenth of the instructions.
#[inline(never)]
fn newton_alone<T: Scalar, const N: usize>(
    guess: [T; N],
    sizes: [T; N],
    evaluate: impl FnMut([T; N]) -> ([T; N], [[T; N]; N]),
) -> Result<[T; N], Failure> {
    newton_of(guess, sizes, evaluate)
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn newton_of<T: Scalar, const N: usize>(
    guess: [T; N],
    sizes: [T; N],
    mut evaluate: impl FnMut([T; N]) -> ([T; N], [[T; N]; N]),
) -> Result<[T; N], Failure> {
    let mut solution = guess;
    // any number will do, and a constant of a number that records would be recorded
    let any = guess.first().copied().unwrap_or_else(|| T::constant(0.0));
    // an array for each, so that a compiler can keep it in registers
    let (mut first, mut second) = ([[any; N]; N], [[any; N]; N]);
    let (mut third, mut fourth, mut fifth) = ([[0.0; N]; N], [[0.0; N]; N], [[0.0; N]; N]);
    let memory = NewtonMemory {
        vectors: [&mut [any; N], &mut [any; N], &mut [any; N]],
        matrices: [first.as_flattened_mut(), second.as_flattened_mut()],
        real_vectors: [
            &mut [0.0; N],
            &mut [0.0; N],
            &mut [0.0; N],
            &mut [0.0; N],
            &mut [0.0; N],
            &mut [0.0; N],
            &mut [0.0; N],
            &mut [0.0; N],
            &mut [0.0; N],
        ],
        real_matrices: [
            third.as_flattened_mut(),
            fourth.as_flattened_mut(),
            fifth.as_flattened_mut(),
        ],
        rows: &mut [FactorRow::default(); N],
    };
    let evaluate = |unknowns: &[T], residuals: &mut [T], jacobian: &mut [T]| {
        let mut values = guess;
        values.copy_from_slice(unknowns);
        let (typed_residuals, typed_jacobian) = evaluate(values);
        residuals.copy_from_slice(&typed_residuals);
        jacobian.copy_from_slice(typed_jacobian.as_flattened());
    };
    newton_in(&mut solution, &sizes, memory, evaluate)?;
    Ok(solution)
}

/// [`newton`] for any number of unknowns. `solution` is the guess, and then the root, or nothing of use after an error.
///
/// # Errors
/// As for [`newton`].
#[doc(hidden)]
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn newton_in<T: Scalar>(
    solution: &mut [T],
    sizes: &[T],
    memory: NewtonMemory<'_, T>,
    equations: impl Equations<T>,
) -> Result<(), Failure> {
    T::root(solution, sizes, memory, equations)
}

/// The equations of [`newton_in`]: a closure, or a type whose method is inlined wherever it is called. A closure is
/// not where it is long, and is then compiled for the narrowest vectors.
#[doc(hidden)]
pub trait Equations<T> {
    /// Takes the unknowns, and writes the residuals and their Jacobian, row by row.
    fn evaluate(&mut self, unknowns: &[T], residuals: &mut [T], jacobian: &mut [T]);
}

impl<T, F: FnMut(&[T], &mut [T], &mut [T])> Equations<T> for F {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn evaluate(&mut self, unknowns: &[T], residuals: &mut [T], jacobian: &mut [T]) {
        self(unknowns, residuals, jacobian);
    }
}

/// Memory that a caller lends to [`newton_in`].
#[doc(hidden)]
#[derive(Debug)]
pub struct NewtonMemory<'m, T> {
    pub(crate) vectors: [&'m mut [T]; 3],
    pub(crate) matrices: [&'m mut [T]; 2],
    real_vectors: [&'m mut [f64]; 9],
    real_matrices: [&'m mut [f64]; 3],
    pub(crate) rows: &'m mut [FactorRow],
}

impl<'m, T> NewtonMemory<'m, T> {
    /// How many numbers, real numbers and rows some unknowns take.
    #[must_use]
    pub const fn lengths(unknowns: usize) -> [usize; 3] {
        let (vector, matrix) = (unknowns, unknowns * unknowns);
        [3 * vector + 2 * matrix, 9 * vector + 3 * matrix, vector]
    }

    /// Memory of these [lengths](Self::lengths) or more, with any content; `None` if it is less.
    #[must_use]
    pub fn new(unknowns: usize, numbers: &'m mut [T], reals: &'m mut [f64], rows: &'m mut [FactorRow]) -> Option<Self> {
        let lengths = Self::lengths(unknowns);
        if numbers.len() < lengths[0] || reals.len() < lengths[1] || rows.len() < lengths[2] {
            return None;
        }
        let (vector, matrix) = (unknowns, unknowns * unknowns);
        let (vectors, numbers) = numbers.split_at_mut(3 * vector);
        let (real_vectors, real_matrices) = reals.split_at_mut(9 * vector);
        Some(Self {
            vectors: parts(vectors, vector),
            matrices: parts(numbers, matrix),
            real_vectors: parts(real_vectors, vector),
            real_matrices: parts(real_matrices, matrix),
            rows: &mut rows[..vector],
        })
    }
}

/// The first parts of some memory, each of the same length.
fn parts<E, const K: usize>(mut memory: &mut [E], length: usize) -> [&mut [E]; K] {
    array::from_fn(|_| memory.split_off_mut(..length).unwrap_or_default())
}

/// The largest magnitude of some lengths, or 1 if all of them are zero. Lengths of the mechanism are compared with it.
///
/// ```
/// use kin_core::solve;
///
/// assert_eq!(solve::largest([3.0, -5.0]), 5.0);
/// assert_eq!(solve::largest::<f64, 0>([]), 1.0);
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
#[must_use]
pub fn largest<T: Scalar, const N: usize>(lengths: [T; N]) -> T {
    largest_in(&lengths)
}

/// [`largest`] of any number of lengths.
#[doc(hidden)]
#[cfg_attr(not(debug_assertions), inline(always))]
#[must_use]
pub fn largest_in<T: Scalar>(lengths: &[T]) -> T {
    T::measured_over(LargestLength, lengths.len(), |index| lengths[index])
}

/// [`newton_in`] for a number that holds one pose.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn damped_root<T: Scalar>(
    solution: &mut [T],
    sizes: &[T],
    memory: NewtonMemory<'_, T>,
    mut equations: impl Equations<T>,
) -> Result<(), Failure> {
    let [residuals, other, ..] = memory.vectors;
    let [jacobian, _] = memory.matrices;
    let rows = memory.rows;
    let real = RealMemory {
        vectors: memory.real_vectors,
        matrices: memory.real_matrices,
        rows: &mut *rows,
    };
    real_root(
        solution,
        sizes,
        [&mut *residuals, jacobian, other],
        real,
        &mut equations,
    )?;
    // The loop runs ⌈log₂(order + 1)⌉ times, computed in integers.
    for _ in 0..usize::BITS - T::ORDER.leading_zeros() {
        equations.evaluate(solution, residuals, jacobian);
        factor_in(jacobian, rows)?;
        substitute_in(jacobian, rows, residuals, other);
        for (entry, change) in solution.iter_mut().zip(&*other) {
            *entry = *entry - *change;
        }
    }
    if solution.iter().all(|entry| entry.is_finite()) {
        Ok(())
    } else {
        Err(Failure::not_finite(SOLUTION))
    }
}

/// The memory of a root in real numbers.
struct RealMemory<'m> {
    vectors: [&'m mut [f64]; 9],
    matrices: [&'m mut [f64]; 3],
    rows: &'m mut [FactorRow],
}

/// A step to a trial: the length of the correction, the part of it that is taken, the determinant where it began,
/// whether the trial is tested, and whether a simplified correction there is the last one.
#[derive(Clone, Copy)]
struct Step {
    length: f64,
    part: f64,
    determinant: Determinant<f64>,
    is_tested: bool,
    is_last: bool,
}

/// What follows from a trial.
enum Verdict {
    Accepted,
    /// The step is rounding, and the trial is the root, or the point before it.
    Ended {
        is_at_trial: bool,
    },
    /// This part of the correction is tried.
    Shortened(f64),
}

/// The root in real numbers. Residuals, Jacobian and corrections are in sizes of the unknowns.
#[cfg_attr(not(debug_assertions), inline(always))]
fn real_root<T: Scalar>(
    unknowns: &mut [T],
    sizes: &[T],
    [typed_residuals, typed_jacobian, trial]: [&mut [T]; 3],
    memory: RealMemory<'_>,
    equations: &mut impl Equations<T>,
) -> Result<(), Failure> {
    let RealMemory {
        vectors,
        matrices,
        rows,
    } = memory;
    let [
        units,
        residuals,
        next_residuals,
        correction,
        expected,
        before_expected,
        one,
        two,
        three,
    ] = vectors;
    let [jacobian, next_jacobian, factors] = matrices;
    for (unit, size) in units.iter_mut().zip(sizes) {
        *unit = size.real();
    }
    if !units.iter().all(|size| *size > 0.0 && size.is_finite()) {
        return Err(Failure::not_finite(QUANTITY));
    }
    for (entry, guess) in trial.iter_mut().zip(&*unknowns) {
        *entry = T::constant(guess.real());
    }
    let mut limit = FIRST_STEP;
    let (mut iterations, mut trials) = (0, 0);
    // the step to the trial, unless that is the guess
    let mut step: Option<Step> = None;
    loop {
        // Equations are evaluated, and factors are found, at one place each, as there is much to inline.
        equations.evaluate(trial, typed_residuals, typed_jacobian);
        let is_finite = are_real([typed_residuals, typed_jacobian], units, next_residuals, next_jacobian);
        if let Some(step) = step
            && step.is_last
            && is_finite
        {
            corrected(factors, rows, next_residuals, expected);
            if greatest(expected) <= QUADRATIC * step.length {
                moved(trial, expected, 1.0, units, unknowns);
                return Ok(());
            }
        }
        let mut scaling = Scaling::New;
        let verdict = match step {
            None if !is_finite => return Err(Failure::not_finite(QUANTITY)),
            Some(step) if !is_finite => Verdict::Shortened(0.5 * step.part),
            Some(step) if step.is_tested => {
                let Step { length, part, .. } = step;
                corrected(factors, rows, next_residuals, expected);
                let fall = greatest(expected) / length;
                let undamped = correction.iter().map(|entry| (1.0 - part) * entry);
                if fall < 1.0 - 0.25 * part {
                    if fall <= CONVERGING {
                        scaling = Scaling::Kept;
                    }
                    // If the equations are nearly linear over a step, the next step may be longer.
                    if distance(undamped, expected) <= 0.25 * part * length {
                        limit *= 2.0;
                    }
                    before_expected.copy_from_slice(expected);
                    Verdict::Accepted
                } else if is_rounding::<T>(length, unknowns, units, rows, [factors, jacobian], [one, two, three]) {
                    Verdict::Ended {
                        is_at_trial: fall < 1.0,
                    }
                } else {
                    let estimate = 0.5 * length * part * part / distance(undamped, expected);
                    // Shorten to a tenth at most: the estimate is rough if the step was much too long.
                    Verdict::Shortened(if estimate < 0.5 * part {
                        estimate.max(0.1 * part)
                    } else {
                        0.5 * part
                    })
                }
            }
            Some(_) => {
                scaling = Scaling::Kept;
                Verdict::Accepted
            }
            None => Verdict::Accepted,
        };
        let mut ended = None;
        match (verdict, &mut step) {
            (Verdict::Shortened(part), Some(step)) => {
                trials += 1;
                if trials == TRIALS {
                    break;
                }
                (step.part, step.is_tested, step.is_last) = (part, true, false);
                moved(unknowns, correction, part, units, trial);
                continue;
            }
            (Verdict::Ended { is_at_trial }, Some(step)) => {
                if is_at_trial {
                    unknowns.copy_from_slice(trial);
                }
                ended = Some(step.determinant);
            }
            _ => {
                iterations += u32::from(step.is_some());
                unknowns.copy_from_slice(trial);
                residuals.copy_from_slice(next_residuals);
            }
        }
        // in one loop, so that a compiler keeps the entries in registers
        for ((entry, factor), next) in jacobian.iter_mut().zip(&mut *factors).zip(&*next_jacobian) {
            (*entry, *factor) = (*next, *next);
        }
        let elimination = factor_to(factors, rows, T::EPSILON, scaling)?;
        let determinant = Determinant::of(factors, rows, elimination.is_odd);
        if ended.is_some() {
            return distinct(ended, determinant);
        }
        corrected(factors, rows, residuals, correction);
        let length = greatest(correction);
        if iterations == ITERATIONS || !length.is_finite() {
            break;
        }
        // how the correction compares with the one before, if that was taken in full
        let contraction = match step {
            Some(step) if step.part == 1.0 => length / step.length,
            _ => f64::INFINITY,
        };
        let is_quadratic = contraction <= QUADRATIC;
        let next_length = contraction * contraction * length;
        let is_foretold = is_quadratic && next_length <= NEGLIGIBLE * T::EPSILON;
        let is_lost = is_lost::<T>(correction, unknowns, units);
        if is_lost || is_foretold {
            moved(unknowns, correction, 1.0, units, trial);
            unknowns.copy_from_slice(trial);
        }
        if is_foretold {
            return Ok(());
        }
        let is_stalled = (0.5..f64::INFINITY).contains(&contraction)
            && is_rounding::<T>(length, unknowns, units, rows, [factors, jacobian], [one, two, three]);
        if is_lost || is_stalled {
            return distinct(step.map(|step| step.determinant), determinant);
        }

        let is_converging = contraction <= CONVERGING;
        let part = match step {
            // the step before was within the limit
            _ if is_converging => 1.0,
            Some(step) if step.is_tested => {
                let fall = distance(before_expected.iter().copied(), correction);
                let foreseen = step.part * step.length * greatest(before_expected) / (fall * length);
                // A quotient of zero by zero means a perfect forecast.
                let foreseen = if foreseen < 1.0 {
                    foreseen.max(SMALLEST_PART)
                } else {
                    1.0
                };
                foreseen.min(limit / length)
            }
            _ => (limit / length).min(1.0),
        };
        moved(unknowns, correction, part, units, trial);
        trials = 0;
        step = Some(Step {
            length,
            part,
            determinant,
            is_tested: !is_converging,
            // twice the square of the contraction is the measure h of this step
            is_last: is_quadratic && 2.0 * contraction * contraction * next_length <= NEGLIGIBLE * T::EPSILON,
        });
    }
    Err(Failure::NotConverged {
        residual: greatest(residuals),
        iterations,
        condition: condition(factors, rows, jacobian, [one, two, three]),
    })
}

/// Whether a correction disappears in every unknown.
#[cfg_attr(not(debug_assertions), inline(always))]
fn is_lost<T: Scalar>(correction: &[f64], unknowns: &[T], units: &[f64]) -> bool {
    (0..units.len()).all(|index| {
        let size = larger(units[index], unknowns[index].real().abs());
        correction[index].abs() * units[index] <= T::EPSILON * size
    })
}

/// Whether the rounding of residuals explains a correction of this length.
#[cfg_attr(not(debug_assertions), inline(always))]
fn is_rounding<T: Scalar>(
    length: f64,
    unknowns: &[T],
    units: &[f64],
    rows: &[FactorRow],
    [factors, jacobian]: [&[f64]; 2],
    scratch: Scratch<'_>,
) -> bool {
    if length * length <= LINEAR_STEP * T::EPSILON {
        return true;
    }
    let sizes = unknowns.iter().zip(units);
    let size = sizes.fold(1.0, |size: f64, (entry, unit)| size.max(entry.real().abs() / unit));
    length <= 16.0 * T::EPSILON * size * amplification(factors, rows, jacobian, scratch)
}

/// Writes the real parts of residuals and Jacobian, the latter in the units of the unknowns, and returns whether all
/// are finite.
#[cfg_attr(not(debug_assertions), inline(always))]
fn are_real<T: Scalar>(typed: [&[T]; 2], units: &[f64], residuals: &mut [f64], jacobian: &mut [f64]) -> bool {
    for (entry, typed) in residuals.iter_mut().zip(typed[0]) {
        *entry = typed.real();
    }
    let rows = jacobian.chunks_exact_mut(units.len().max(1));
    for (row, typed) in rows.zip(typed[1].chunks_exact(units.len().max(1))) {
        for ((entry, typed), unit) in row.iter_mut().zip(typed).zip(units) {
            *entry = typed.real() * unit;
        }
    }
    f64::are_finite(jacobian) && f64::are_finite(residuals)
}

/// The correction that removes the residuals.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn corrected<T: Scalar>(factors: &[T], rows: &[FactorRow], residuals: &[T], correction: &mut [T]) {
    substitute_in(factors, rows, residuals, correction);
    for entry in correction {
        *entry = -*entry;
    }
}

/// Succeeds unless a change of the size of rounding errors alters the determinant by a quarter of itself. In that case
/// a double root, where the determinant is zero, is too close to be ruled out.
fn distinct(previous: Option<Determinant<f64>>, determinant: Determinant<f64>) -> Result<(), Failure> {
    let ratio = previous.map_or(1.0, |previous| determinant.relative_to(previous));
    if (0.75..=1.25).contains(&ratio) {
        return Ok(());
    }
    let determinant = determinant.value();
    Err(if determinant.is_finite() {
        Failure::Singular { determinant }
    } else {
        Failure::not_finite(SOLUTION)
    })
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn moved<T: Scalar>(from: &[T], correction: &[f64], part: f64, units: &[f64], to: &mut [T]) {
    for (index, entry) in to.iter_mut().enumerate() {
        *entry = T::constant(from[index].real() + part * correction[index] * units[index]);
    }
}

/// The largest magnitude, or NaN if an entry is NaN.
#[cfg_attr(not(debug_assertions), inline(always))]
fn greatest(vector: &[f64]) -> f64 {
    greatest_of(vector.iter().copied())
}

/// The largest difference, or NaN if an entry is NaN.
#[cfg_attr(not(debug_assertions), inline(always))]
fn distance(one: impl Iterator<Item = f64>, other: &[f64]) -> f64 {
    greatest_of(one.zip(other).map(|(one, other)| one - other))
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn greatest_of(numbers: impl Iterator<Item = f64>) -> f64 {
    let (largest, sum) = numbers.fold((0.0, 0.0), |(largest, sum), entry| {
        let size = entry.abs();
        (larger(largest, size), sum + size)
    });
    // a sum of magnitudes is NaN if and only if one of them is
    if sum.is_nan() { sum } else { largest }
}

/// The largest magnitude of some lengths, or 1 if all of them are zero.
#[derive(Clone, Copy)]
struct LargestLength;

impl RowMeasure for LargestLength {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn start<R: Real>() -> R {
        R::of(0.0)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with<R: Real>(largest: R, length: R) -> R {
        let size = length.magnitude();
        R::choose(size.exceeds(largest), || size, || largest)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn end<R: Real>(largest: R) -> R {
        R::choose(largest.exceeds(R::of(0.0)), || largest, || R::of(1.0))
    }
}

#[cfg(test)]
mod tests {
    use core::cell::Cell;
    use core::f64::consts::{PI, TAU};
    use std::vec::Vec;

    use proptest::prelude::*;

    use super::{FactorRow, NewtonMemory, newton, newton_in};
    use crate::assembly::Assembly;
    use crate::batch::lanes::Lanes;
    use crate::failure::Failure;
    use crate::geometry::Plane;
    use crate::number::{Number, series::Series};
    use crate::solve::{
        self, Scalar,
        strategies::{angle, dimension},
    };

    /// The loop of a four-bar linkage for its coupler and rocker angles. A closed form exists for comparison.
    fn four_bar<T: Scalar>(links: [f64; 4], crank: T) -> impl FnMut([T; 2]) -> ([T; 2], [[T; 2]; 2]) {
        let [r1, r2, r3, r4] = links.map(T::constant);
        let (s2, c2) = crank.sin_cos();
        move |[coupler, rocker]| {
            let ((s3, c3), (s4, c4)) = (coupler.sin_cos(), rocker.sin_cos());
            (
                [r2 * c2 + r3 * c3 - r1 - r4 * c4, r2 * s2 + r3 * s3 - r4 * s4],
                [[-(r3 * s3), r4 * s4], [r3 * c3, -(r4 * c4)]],
            )
        }
    }

    fn closed_form<T: Scalar>(links: [f64; 4], crank: T, assembly: Assembly) -> Result<[T; 2], Failure> {
        let [r1, r2, r3, r4] = links.map(T::constant);
        let (s2, c2) = crank.sin_cos();
        let diagonal = Plane::new(r1 - r2 * c2, -(r2 * s2));
        let (coupler, _) = solve::circle_circle(r3, r4, diagonal, assembly)?;
        let rocker = coupler - diagonal;
        Ok([coupler.y.atan2(coupler.x), rocker.y.atan2(rocker.x)])
    }

    /// The size of rounding errors in the angles of the four-bar: the reciprocal of sin(coupler - rocker), times the
    /// longest link over the shorter of the two.
    fn condition(links: [f64; 4], [coupler, rocker]: [f64; 2]) -> f64 {
        let longest = links.into_iter().fold(0.0, f64::max);
        longest / links[2].min(links[3]) / (coupler - rocker).sin().abs()
    }

    const GRASHOF: [f64; 4] = [90.0, 30.0, 70.0, 60.0];

    proptest! {
        #[test]
        fn the_loop_of_a_four_bar(
            crank in angle(), scale in dimension(), off in (-0.2..0.2, -0.2..0.2), crossed in proptest::bool::ANY,
        ) {
            let links = GRASHOF.map(|link| link * scale);
            let assembly = if crossed { Assembly::Crossed } else { Assembly::Open };
            let expected = closed_form(links, crank, assembly).unwrap();
            let guess = [expected[0] + off.0, expected[1] + off.1];
            let root = newton(guess, [1.0; 2], four_bar(links, crank)).unwrap();
            let tolerance = 16.0 * f64::EPSILON * condition(links, expected);
            for (actual, expected) in root.into_iter().zip(expected) {
                prop_assert!((actual - expected).abs() <= tolerance, "{actual} {expected} {tolerance}");
            }
        }

        #[test]
        fn from_any_guess_a_root_or_an_error(
            crank in angle(), guess in (-10.0..10.0, -10.0..10.0), r in (0.1..1.0, 0.1..1.0, 0.1..1.0, 0.1..1.0),
        ) {
            let links = [r.0, r.1, r.2, r.3];
            let guess: [f64; 2] = guess.into();
            match newton(guess, [1.0; 2], four_bar(links, crank)) {
                Ok(root) => {
                    let (residuals, _) = four_bar(links, crank)(root);
                    // The angles themselves are rounded, so the tolerance grows with their size.
                    let size = root.into_iter().fold(1.0, |size: f64, angle| size.max(angle.abs()));
                    for residual in residuals {
                        prop_assert!(residual.abs() <= 16.0 * f64::EPSILON * size * condition(links, root).max(1.0));
                    }
                }
                Err(Failure::NotConverged { residual, condition, .. }) => {
                    prop_assert!(residual > 0.0 && residual.is_finite() && condition >= 1.0);
                }
                Err(Failure::Singular { determinant }) => prop_assert!(determinant.is_finite()),
                Err(other) => prop_assert!(false, "{other}"),
            }
        }

        #[test]
        fn linear_systems_take_one_step(a in angle(), b in angle(), x in angle(), y in angle(), unit in dimension()) {
            let ((s, c), (t, d)) = (a.sin_cos(), b.sin_cos());
            let determinant = s * d - c * t;
            prop_assume!(determinant.abs() > 1e-6);
            let (x, y) = (x * unit, y * unit);
            let calls = Cell::new(0);
            let [u, v] = newton([0.0, 0.0], [unit; 2], |[u, v]: [f64; 2]| {
                calls.set(calls.get() + 1);
                ([s * (u - x) + c * (v - y), t * (u - x) + d * (v - y)], [[s, c], [t, d]])
            })
            .unwrap();
            let tolerance = 16.0 * f64::EPSILON * (x.abs() + y.abs() + unit) / determinant.abs();
            prop_assert!((u - x).abs() <= tolerance && (v - y).abs() <= tolerance);
            // The first steps are limited, which costs a few calls.
            prop_assert!(calls.get() <= 8, "{}", calls.get());
        }
    }

    #[test]
    fn from_a_near_guess_four_evaluations() {
        let expected = closed_form(GRASHOF, 1.0, Assembly::Open).unwrap();
        let calls = Cell::new(0);
        let mut system = four_bar(GRASHOF, 1.0);
        newton(expected.map(|angle| angle + 0.05), [1.0; 2], |unknowns| {
            calls.set(calls.get() + 1);
            system(unknowns)
        })
        .unwrap();
        assert!(calls.get() <= 4, "{}", calls.get());
    }

    /// The last correction does without the Jacobian there.
    #[test]
    fn the_last_correction_is_a_simplified_one() {
        let expected = closed_form(GRASHOF, 1.0, Assembly::Open).unwrap();
        let calls = Cell::new(0);
        let mut system = four_bar(GRASHOF, 1.0);
        let root = newton(expected.map(|angle| angle + 0.05), [1.0; 2], |unknowns| {
            calls.set(calls.get() + 1);
            let (residuals, jacobian) = system(unknowns);
            (residuals, if calls.get() == 4 { [[0.0_f64; 2]; 2] } else { jacobian })
        })
        .unwrap();
        assert_eq!(calls.get(), 4);
        for (actual, expected) in root.into_iter().zip(expected) {
            assert!((actual - expected).abs() <= 8.0 * f64::EPSILON, "{actual} {expected}");
        }
    }

    /// An equation that is not what its first corrections foretell: the simplified correction is not small enough.
    #[test]
    fn a_correction_that_is_not_as_foretold_is_not_the_last() {
        let calls = Cell::new(0);
        let root = newton([1.02], [1.0], |[x]: [f64; 1]| {
            calls.set(calls.get() + 1);
            // a step near the root of x² = 1, which the first three corrections do not meet
            let step = if calls.get() > 3 { 1e-4 } else { 0.0 };
            ([x * x - 1.0 - step], [[2.0 * x]])
        })
        .unwrap();
        assert!(calls.get() > 4, "{}", calls.get());
        assert!((root[0] - 1.0001_f64.sqrt()).abs() <= 2.0 * f64::EPSILON, "{root:?}");
    }

    #[test]
    fn angles_stay_on_the_turn_of_the_guess() {
        let expected = closed_form(GRASHOF, 1.0, Assembly::Open).unwrap();
        for revolutions in [-1000.0, -1.0, 3.0, 1e6] {
            let guess = expected.map(|angle| angle + 0.1 + revolutions * TAU);
            let root = newton(guess, [1.0; 2], four_bar(GRASHOF, 1.0)).unwrap();
            for (actual, guess) in root.into_iter().zip(guess) {
                assert!((actual - guess + 0.1).abs() <= 8.0 * f64::EPSILON * guess.abs());
            }
        }
    }

    #[test]
    fn lengths_of_any_unit() {
        // A ladder of length 5 leans against a wall over a box: x² + y² = 25, x y = 12.
        for unit in [1e-150, 1e-6, 1.0, 1e6, 1e150] {
            let root = newton([2.0 * unit, 5.0 * unit], [unit; 2], |[x, y]: [f64; 2]| {
                (
                    [x * x + y * y - 25.0 * unit * unit, x * y - 12.0 * unit * unit],
                    [[2.0 * x, 2.0 * y], [y, x]],
                )
            })
            .unwrap();
            for (actual, expected) in root.into_iter().zip([3.0 * unit, 4.0 * unit]) {
                assert!((actual - expected).abs() <= 16.0 * f64::EPSILON * expected, "{actual}");
            }
        }
    }

    #[test]
    fn rounding_of_large_constant_terms_is_not_a_failure() {
        // The difference of two inputs near 10⁶ is known only to 10⁻¹⁰, and this error does not appear in the Jacobian.
        let large = 1e6 + 0.1;
        let root = newton([0.3], [1.0], |[x]: [f64; 1]| {
            let (s, c) = x.sin_cos();
            ([(large + s) - (1e6 + 0.6)], [[c]])
        })
        .unwrap();
        assert!((root[0] - 0.5_f64.asin()).abs() <= 4.0 * f64::EPSILON * 1e6);
    }

    #[test]
    fn single_precision() {
        let links = GRASHOF;
        let expected = closed_form(links, 1.0, Assembly::Open).unwrap();
        let root = newton(
            expected.map(|angle| f32::constant(angle + 0.2)),
            [1.0; 2],
            four_bar(links, 1.0_f32),
        )
        .unwrap();
        for (actual, expected) in root.into_iter().zip(expected) {
            let tolerance = 16.0 * f64::from(f32::EPSILON) * condition(links, [root[0].real(), root[1].real()]);
            assert!((actual.real() - expected).abs() <= tolerance);
        }
    }

    #[test]
    fn series_get_the_derivatives_of_the_implicit_function() {
        fn through<const N: usize>() {
            let mut motion = [0.0; N];
            for (entry, value) in motion.iter_mut().zip([1.0, -0.7, 0.4, 0.9, -0.3, 0.2, 0.1, 0.5, -0.2]) {
                *entry = value;
            }
            let crank = Series::from_coefficients(motion);
            let expected = closed_form(GRASHOF, crank, Assembly::Open).unwrap();
            // The guess has derivatives, which must not matter.
            let guess = expected.map(|angle| Series::from_coefficients([angle.real() + 0.3; N]));
            let root = newton(guess, [Number::constant(1.0); 2], four_bar(GRASHOF, crank)).unwrap();
            for (actual, expected) in root.into_iter().zip(expected) {
                let pairs = actual.coefficients().into_iter().zip(expected.coefficients());
                for (order, (actual, expected)) in pairs.enumerate() {
                    let digits = 64.0 * f64::EPSILON * 4.0_f64.powi(i32::try_from(order).unwrap());
                    assert!(
                        (actual - expected).abs() <= digits * (1.0 + expected.abs()),
                        "{N} {order}: {actual} {expected}"
                    );
                }
            }
        }
        through::<1>();
        through::<2>();
        through::<3>();
        through::<4>();
        through::<5>();
        through::<9>();
    }

    /// Slices in memory of any content find the bits that arrays do, for every number of poses and orders.
    #[test]
    fn slices_find_the_same_root() {
        fn in_slices<T: Scalar>(guess: [f64; 2]) -> [T; 2] {
            let [numbers, reals, rows] = NewtonMemory::<T>::lengths(2);
            let mut numbers = std::vec![T::constant(f64::NAN); numbers];
            let mut reals = std::vec![f64::NAN; reals];
            let mut rows = std::vec![FactorRow::default(); rows];
            assert!(NewtonMemory::new(2, &mut numbers, &mut reals[1..], &mut rows).is_none());
            let memory = NewtonMemory::new(2, &mut numbers, &mut reals, &mut rows).unwrap();
            let mut linkage = four_bar(GRASHOF, T::constant(1.0));
            let mut found = guess.map(T::constant);
            newton_in(
                &mut found,
                &[T::constant(1.0); 2],
                memory,
                |at: &[T], residuals: &mut [T], jacobian: &mut [T]| {
                    let (typed_residuals, typed_jacobian) = linkage([at[0], at[1]]);
                    residuals.copy_from_slice(&typed_residuals);
                    jacobian.copy_from_slice(typed_jacobian.as_flattened());
                },
            )
            .unwrap();
            found
        }
        fn in_arrays<T: Scalar>(guess: [f64; 2]) -> [T; 2] {
            let (guess, sizes) = (guess.map(T::constant), [T::constant(1.0); 2]);
            newton(guess, sizes, four_bar(GRASHOF, T::constant(1.0))).unwrap()
        }
        for assembly in Assembly::BOTH {
            let [coupler, rocker] = closed_form(GRASHOF, 1.0, assembly).unwrap();
            let guess = [coupler + 0.02, rocker - 0.03];
            assert_eq!(in_slices::<f64>(guess), in_arrays::<f64>(guess));
            assert_eq!(in_slices::<f32>(guess), in_arrays::<f32>(guess));
            assert_eq!(in_slices::<Series<4>>(guess), in_arrays::<Series<4>>(guess));
            let lanes = |[x, y]: [Lanes<4, 128>; 2]| [x.0, y.0];
            let found = lanes(in_slices(guess));
            assert_eq!(found, lanes(in_arrays(guess)));
            assert!((found[0][3] - coupler).abs() < 1e-12, "{found:?}");
        }
    }

    /// Rounding splits a double root whose terms have the given size into two roots; their distance is the root of the
    /// rounding error.
    fn is_double<const N: usize>(result: Result<[f64; N], Failure>, root: [f64; N], size: f64) -> bool {
        let distance = (8.0 * f64::EPSILON * size).sqrt();
        match result {
            Ok(found) => (0..N).all(|index| (found[index] - root[index]).abs() <= distance),
            Err(failure) => matches!(failure, Failure::Singular { .. }),
        }
    }

    #[test]
    fn a_double_root_is_singular_up_to_rounding() {
        for guess in [1.0, 0.3, -2.0, 1e-5, 0.0] {
            for root in [0.0, 0.7, 1.0 / 3.0, 100.1] {
                let result = newton([root + guess], [1.0], |[x]: [f64; 1]| {
                    ([x * x - 2.0 * root * x + root * root], [[2.0 * (x - root)]])
                });
                assert!(is_double(result, [root], root * root), "{guess} {root} {result:?}");
            }
            // Without rounding, the root is exactly double.
            let result = newton([guess], [1.0], |[x]: [f64; 1]| ([x * x], [[2.0 * x]]));
            assert!(matches!(result, Err(Failure::Singular { .. })), "{guess} {result:?}");
        }
        // The stretched four-bar: crank, coupler and rocker lie on one line with the ground.
        let links = [4.0, 1.0, 2.0, 1.0];
        for off in [0.1, 0.01, 1e-4, 1e-6, 0.0] {
            let result = newton([off, PI + 1.5 * off], [1.0; 2], four_bar(links, 0.0));
            assert!(is_double(result, [0.0, PI], 4.0), "{off} {result:?}");
        }
    }

    #[test]
    fn near_a_double_root_the_two_are_distinguished() {
        for gap in [1e-2, 1e-4, 1e-6] {
            for side in [1.0, -1.0] {
                let root = newton([side], [1.0], |[x]: [f64; 1]| ([x * x - gap * gap], [[2.0 * x]])).unwrap();
                assert!((root[0] - side * gap).abs() <= 8.0 * f64::EPSILON);
            }
        }
    }

    #[test]
    fn out_of_reach_is_not_converged() {
        for guess in [-3.0, -0.5, 0.2, 1.0, 40.0] {
            let result = newton([guess], [1.0], |[x]: [f64; 1]| ([x * x + 1.0], [[2.0 * x]]));
            assert!(
                matches!(result, Err(Failure::NotConverged { residual, .. }) if residual >= 1.0)
                    || matches!(result, Err(Failure::Singular { .. })),
                "{result:?}"
            );
        }
        let links = [10.0, 1.0, 2.0, 3.0];
        let result = newton([0.5, -1.0], [1.0; 2], four_bar(links, 1.0));
        assert!(
            matches!(result, Err(Failure::NotConverged { .. } | Failure::Singular { .. })),
            "{result:?}"
        );
    }

    #[test]
    fn a_far_guess_on_a_steep_function_converges() {
        // The plain method diverges from guesses beyond 1.39.
        for guess in [2.0, 10.0, -50.0] {
            let root = newton([guess], [1.0], |[x]: [f64; 1]| ([x.atan()], [[1.0 / (1.0 + x * x)]])).unwrap();
            assert!(root[0].abs() <= f64::EPSILON);
        }
    }

    #[test]
    fn nothing_that_is_not_finite_comes_out() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(matches!(
                newton([value, 1.0], [1.0; 2], four_bar(GRASHOF, 1.0)),
                Err(Failure::NotFinite { .. })
            ));
            for sizes in [[value, 1.0], [0.0, 1.0], [1.0, -1.0]] {
                assert!(matches!(
                    newton([1.0, 1.0], sizes, four_bar(GRASHOF, 1.0)),
                    Err(Failure::NotFinite { .. })
                ));
            }
            // A function that is undefined from the middle of the path on.
            let results: Vec<_> = [0.9, 0.5, 0.1]
                .into_iter()
                .map(|end| {
                    newton([1.0], [1.0], |[x]: [f64; 1]| {
                        ([if x < end { value } else { x }], [[1.0]])
                    })
                })
                .collect();
            assert!(
                results
                    .iter()
                    .all(|result| matches!(result, Err(Failure::NotConverged { .. }))),
                "{results:?}"
            );
        }
        // A derivative that overflows.
        let steep = Series::from_coefficients([1.0, 1e300]);
        let slope = Series::constant(1e-10);
        let result = newton(
            [Series::constant(0.5)],
            [Series::constant(1.0)],
            |[x]: [Series<2>; 1]| ([x * slope - steep * slope], [[slope * slope]]),
        );
        assert!(
            matches!(result, Err(Failure::NotFinite { .. } | Failure::NotConverged { .. })),
            "{result:?}"
        );
    }
}
