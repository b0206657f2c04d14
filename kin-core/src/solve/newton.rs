//! Newton's method, for unknowns without a closed form.

use super::factor::{Factors, factor, factor_to};
use crate::failure::Failure;
use crate::number::Number;
use crate::solve::Scalar;
use crate::solve::check::{Measure, Real};

const QUANTITY: &str = "guess, size of an unknown, or residual or Jacobian there";
const SOLUTION: &str = "solution of a block without closed form, or its derivatives";

/// The number of steps after which the solver gives up. A good guess takes about five.
pub(crate) const ITERATIONS: u32 = 64;
/// The limit of the first step, in the sizes of the unknowns: half a radian for an angle.
pub(crate) const FIRST_STEP: f64 = 0.5;
/// The square of a step over which the equations are linear, in units of ε.
pub(crate) const LINEAR_STEP: f64 = 4096.0;
/// The number of times a step is shortened, to half or less each time, before the solver gives up.
pub(crate) const TRIALS: u32 = 20;
/// The smallest part of a correction that a forecast may ask for.
pub(crate) const SMALLEST_PART: f64 = 1e-5;

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
#[inline]
pub fn newton<T: Scalar, const N: usize>(
    guess: [T; N],
    sizes: [T; N],
    evaluate: impl FnMut([T; N]) -> ([T; N], [[T; N]; N]),
) -> Result<[T; N], Failure> {
    T::root(guess, sizes, evaluate)
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
    T::measured(LargestLength(lengths))
}

/// [`newton`] for a number that holds one pose.
pub(crate) fn damped_root<T: Scalar, const N: usize>(
    guess: [T; N],
    sizes: [T; N],
    mut evaluate: impl FnMut([T; N]) -> ([T; N], [[T; N]; N]),
) -> Result<[T; N], Failure> {
    let mut solution = real_root(guess, sizes.map(T::real), &mut evaluate)?;
    // The loop runs ⌈log₂(order + 1)⌉ times, computed in integers.
    for _ in 0..usize::BITS - T::ORDER.leading_zeros() {
        let (residuals, jacobian) = evaluate(solution);
        let correction = factor(jacobian)?.solve(residuals);
        for (entry, change) in solution.iter_mut().zip(correction) {
            *entry = *entry - change;
        }
    }
    if solution.iter().all(|entry| entry.is_finite()) {
        Ok(solution)
    } else {
        Err(Failure::not_finite(SOLUTION))
    }
}

/// A point on the way, with everything needed to continue from it. All numbers are in sizes of the unknowns.
#[derive(Clone, Copy)]
struct Iterate<T, const N: usize> {
    unknowns: [T; N],
    residuals: [f64; N],
    jacobian: [[f64; N]; N],
}

impl<T: Scalar, const N: usize> Iterate<T, N> {
    /// The point at these unknowns, or `None` if residuals or Jacobian are not finite.
    fn new(
        unknowns: [T; N],
        sizes: &[f64; N],
        evaluate: &mut impl FnMut([T; N]) -> ([T; N], [[T; N]; N]),
    ) -> Option<Self> {
        let (residuals, jacobian) = evaluate(unknowns);
        let residuals = residuals.map(Number::real);
        let jacobian = jacobian.map(|row| core::array::from_fn(|column| row[column].real() * sizes[column]));
        let mut all = residuals.iter().chain(jacobian.iter().flatten());
        all.all(|entry| entry.is_finite()).then_some(Self {
            unknowns,
            residuals,
            jacobian,
        })
    }

    fn not_converged(&self, iterations: u32, factors: &Factors<f64, N>) -> Failure {
        Failure::NotConverged {
            residual: greatest(&self.residuals),
            iterations,
            condition: factors.condition(),
        }
    }
}

fn real_root<T: Scalar, const N: usize>(
    guess: [T; N],
    sizes: [f64; N],
    evaluate: &mut impl FnMut([T; N]) -> ([T; N], [[T; N]; N]),
) -> Result<[T; N], Failure> {
    let nothing = Failure::not_finite(QUANTITY);
    if !sizes.iter().all(|size| *size > 0.0 && size.is_finite()) {
        return Err(nothing);
    }
    let start = guess.map(|entry| T::constant(entry.real()));
    let mut point = Iterate::new(start, &sizes, evaluate).ok_or(nothing)?;
    let mut factors = factor_to(point.jacobian, T::EPSILON)?;
    let mut limit = FIRST_STEP;
    // The previous step: its length, its damping, the correction expected after it, and the factors it was taken with.
    let mut before: Option<(f64, f64, [f64; N], Factors<f64, N>)> = None;

    for iteration in 0..ITERATIONS {
        let correction = factors.solve(point.residuals).map(|entry| -entry);
        let length = greatest(&correction);
        if !length.is_finite() {
            return Err(point.not_converged(iteration, &factors));
        }
        let end = moved(&point.unknowns, &correction, 1.0, &sizes);
        let is_lost = |index: usize| {
            let size = point.unknowns[index].real().abs() / sizes[index];
            correction[index].abs() <= T::EPSILON * size.max(1.0)
        };
        let lost = (0..N).all(is_lost);
        let stalled = before.is_some_and(|(previous, part, ..)| part == 1.0 && length >= 0.5 * previous)
            && is_rounding(length, &point, &sizes, &factors);
        if lost || stalled {
            let previous = before.map(|(.., factors)| factors);
            return distinct(if lost { end } else { point.unknowns }, previous.as_ref(), &factors);
        }

        let foreseen = before.map_or(1.0, |(previous, part, expected, _)| {
            part * previous * greatest(&expected) / (distance(&expected, &correction) * length)
        });
        // A quotient of zero by zero means a perfect forecast.
        let foreseen = if foreseen < 1.0 {
            foreseen.max(SMALLEST_PART)
        } else {
            1.0
        };
        let mut part = foreseen.min(limit / length);
        let mut accepted = None;
        for _ in 0..TRIALS {
            let trial = moved(&point.unknowns, &correction, part, &sizes);
            let mut advice = 0.5 * part;
            if let Some(next) = Iterate::new(trial, &sizes, evaluate) {
                let expected = factors.solve(next.residuals).map(|entry| -entry);
                let fall = greatest(&expected) / length;
                if fall < 1.0 - 0.25 * part {
                    accepted = Some((next, expected));
                    break;
                }
                if is_rounding(length, &point, &sizes, &factors) {
                    let there = factor_to(next.jacobian, T::EPSILON)?;
                    let root = if fall < 1.0 { trial } else { point.unknowns };
                    return distinct(root, Some(&factors), &there);
                }
                let undamped = correction.map(|entry| (1.0 - part) * entry);
                let estimate = 0.5 * length * part * part / distance(&expected, &undamped);
                // Shorten to a tenth at most: the estimate is rough if the step was much too long.
                if estimate < advice {
                    advice = estimate.max(0.1 * part);
                }
            }
            part = advice;
        }
        let Some((next, expected)) = accepted else {
            return Err(point.not_converged(iteration, &factors));
        };
        // If the equations are nearly linear over a step, the next step may be longer.
        let undamped = correction.map(|entry| (1.0 - part) * entry);
        if distance(&expected, &undamped) <= 0.25 * part * length {
            limit *= 2.0;
        }
        before = Some((length, part, expected, factors));
        point = next;
        factors = factor_to(point.jacobian, T::EPSILON)?;
    }
    Err(point.not_converged(ITERATIONS, &factors))
}

/// Whether rounding may explain a correction that does not fall.
///
/// The residuals have errors of a few ε of the contribution of each unknown, and the condition magnifies these errors.
/// Large terms without unknowns do not appear in the Jacobian. Below a few √ε, however, the equations are linear over
/// the step, which [`distinct`] ensures, so a correction that does not fall at once can only be due to rounding.
fn is_rounding<T: Scalar, const N: usize>(
    length: f64,
    point: &Iterate<T, N>,
    sizes: &[f64; N],
    factors: &Factors<f64, N>,
) -> bool {
    if length * length <= LINEAR_STEP * T::EPSILON {
        return true;
    }
    let unknowns = point.unknowns.iter().zip(sizes);
    let size = unknowns.fold(1.0, |size: f64, (entry, unit)| size.max(entry.real().abs() / unit));
    length <= 16.0 * T::EPSILON * size * factors.amplification(&point.jacobian)
}

/// The root, unless a change of the size of rounding errors alters the determinant by a quarter of itself. In that case
/// a double root, where the determinant is zero, is too close to be ruled out.
fn distinct<T, const N: usize>(
    root: [T; N],
    previous: Option<&Factors<f64, N>>,
    factors: &Factors<f64, N>,
) -> Result<[T; N], Failure> {
    let ratio = previous.map_or(1.0, |previous| factors.determinant_relative_to(previous));
    if (0.75..=1.25).contains(&ratio) {
        return Ok(root);
    }
    let determinant = factors.determinant();
    Err(if determinant.is_finite() {
        Failure::Singular { determinant }
    } else {
        Failure::not_finite(SOLUTION)
    })
}

fn moved<T: Scalar, const N: usize>(from: &[T; N], correction: &[f64; N], part: f64, sizes: &[f64; N]) -> [T; N] {
    core::array::from_fn(|index| T::constant(from[index].real() + part * correction[index] * sizes[index]))
}

/// The largest magnitude, or NaN if an entry is NaN.
fn greatest<const N: usize>(vector: &[f64; N]) -> f64 {
    vector.iter().fold(0.0, |largest, entry| {
        let size = entry.abs();
        if size <= largest || largest.is_nan() {
            largest
        } else {
            size
        }
    })
}

fn distance<const N: usize>(one: &[f64; N], other: &[f64; N]) -> f64 {
    let difference: [f64; N] = core::array::from_fn(|index| one[index] - other[index]);
    greatest(&difference)
}

/// The largest magnitude of some lengths, or 1 if all of them are zero.
#[derive(Clone, Copy)]
struct LargestLength<T, const N: usize>([T; N]);

impl<T: Scalar, const N: usize> Measure<T, N> for LargestLength<T, N> {
    fn name(&self) -> &'static str {
        "largest length"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; N] {
        self.0
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measure<R: Real>(&self, lengths: [R; N]) -> R {
        let zero = R::of(0.0);
        let mut largest = zero;
        for length in lengths {
            let size = length.magnitude();
            largest = R::choose(size.exceeds(largest), || size, || largest);
        }
        R::choose(largest.exceeds(zero), || largest, || R::of(1.0))
    }
}

#[cfg(test)]
mod tests {
    use core::cell::Cell;
    use core::f64::consts::{PI, TAU};
    use std::vec::Vec;

    use proptest::prelude::*;

    use super::newton;
    use crate::assembly::Assembly;
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
    fn from_a_near_guess_five_evaluations() {
        let expected = closed_form(GRASHOF, 1.0, Assembly::Open).unwrap();
        let calls = Cell::new(0);
        let mut system = four_bar(GRASHOF, 1.0);
        newton(expected.map(|angle| angle + 0.05), [1.0; 2], |unknowns| {
            calls.set(calls.get() + 1);
            system(unknowns)
        })
        .unwrap();
        assert!(calls.get() <= 6, "{}", calls.get());
    }

    #[test]
    fn angles_stay_on_the_turn_of_the_guess() {
        let expected = closed_form(GRASHOF, 1.0, Assembly::Open).unwrap();
        for turns in [-1000.0, -1.0, 3.0, 1e6] {
            let guess = expected.map(|angle| angle + 0.1 + turns * TAU);
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
            // The guess has derivatives of its own, which must not matter.
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
    fn near_a_double_root_the_two_are_told_apart() {
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
