//! Numbers that are too close to zero for several poses at once to decide by their sign.

use crate::geometry::Plane;
use crate::solve::Scalar;
use crate::solve::check::{Check, Negative, Real, RowMeasure};

/// A number whose sign decides, checked against the terms of which it is the sum. If the number holds several poses,
/// each pose that is smaller than [a part](Scalar::DOUBT) of its terms becomes NaN. Any other number is returned
/// unchanged, and the terms are not computed.
///
/// ```
/// use kin_core::solve;
///
/// assert_eq!(solve::decisive(1e-17, || [1.0, -1.0]), 1e-17);
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn decisive<T: Scalar, const N: usize>(number: T, terms: impl FnOnce() -> [T; N]) -> T {
    if T::DOUBT == 0.0 {
        return number;
    }
    decisive_in(number, &terms())
}

/// [`decisive`] with terms that are known. Nobody needs them if the [doubt](Scalar::DOUBT) is zero.
#[doc(hidden)]
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn decisive_in<T: Scalar>(number: T, terms: &[T]) -> T {
    if T::DOUBT == 0.0 {
        return number;
    }
    kept(number, number, sum_of_sizes(terms))
}

/// [`decisive`] for a vector that decides by being different from zero.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn decisive_vector<T: Scalar, const N: usize>(vector: Plane<T>, terms: impl FnOnce() -> [T; N]) -> Plane<T> {
    if T::DOUBT == 0.0 {
        return vector;
    }
    decisive_vector_in(vector, &terms())
}

/// [`decisive_vector`] with terms that are known.
#[doc(hidden)]
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn decisive_vector_in<T: Scalar>(vector: Plane<T>, terms: &[T]) -> Plane<T> {
    if T::DOUBT == 0.0 {
        return vector;
    }
    let (size, length) = (sum_of_sizes(terms), sum_of_sizes(&[vector.x, vector.y]));
    Plane::new(kept(vector.x, length, size), kept(vector.y, length, size))
}

/// The smallest positive number that decides, if it is a sum of terms of the given size. For one pose this is [the
/// smallest](Number::SMALLEST_DIVISOR) divisor.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::solve) fn least<T: Scalar>(size: impl FnOnce() -> T) -> T {
    least_from(T::SMALLEST_DIVISOR, size)
}

/// The smallest number above `smallest` that decides, if it is a sum of terms of the given size.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::solve) fn least_from<T: Scalar>(smallest: f64, size: impl FnOnce() -> T) -> T {
    let smallest = T::constant(smallest);
    if T::DOUBT == 0.0 {
        return smallest;
    }
    smallest.plus_product(T::constant(T::DOUBT), size())
}

/// Whether a number differs clearly from one end of its range, where `size` is the size of the rounded numbers.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::solve) fn is_distinct_from<T: Scalar, R: Real>(end: f64, number: R, size: R) -> R::Truth {
    if T::DOUBT == 0.0 || end.is_infinite() {
        return R::certainly(true);
    }
    (number - R::of(end)).magnitude().is_at_least(R::of(T::DOUBT) * size)
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn kept<T: Scalar>(number: T, judge: T, size: T) -> T {
    number.provided(BeyondDoubt { number: judge, size }).unwrap_or(number)
}

/// A number that is at least the [smallest](Number::SMALLEST_DIVISOR) divisor, otherwise NaN.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::solve) fn divisor<T: Scalar>(number: T) -> T {
    let short = Negative(number - T::constant(T::SMALLEST_DIVISOR));
    T::either(short, || T::constant(f64::NAN), || number)
}

/// The magnitude of a number.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::solve) fn size<T: Scalar>(number: T) -> T {
    number.times_sign_of(number)
}

/// The smaller of two numbers.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::solve) fn smaller<T: Scalar>(one: T, other: T) -> T {
    T::either(Negative(other - one), || other, || one)
}

/// Whether a sum is larger than [a part](Scalar::DOUBT) of its terms.
#[derive(Clone, Copy)]
struct BeyondDoubt<T> {
    number: T,
    /// The sum of the magnitudes of the terms.
    size: T,
}

impl<T: Scalar> Check<T, 2, 1> for BeyondDoubt<T> {
    fn name(&self) -> &'static str {
        "sum beyond doubt"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 2] {
        [self.number, self.size]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [number, size]: [R; 2]) -> [R::Truth; 1] {
        [number.magnitude().is_at_least(R::of(T::DOUBT) * size)]
    }

    fn margin(&self) -> T {
        size(self.number) - self.size * T::constant(T::DOUBT)
    }
}

/// The sum of the magnitudes of some terms.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::solve) fn sum_of_sizes<T: Scalar>(terms: &[T]) -> T {
    T::measured_over(SumOfSizes, terms.len(), |index| terms[index])
}

/// The sum of the magnitudes of some terms.
#[derive(Clone, Copy)]
pub(in crate::solve) struct SumOfSizes;

impl RowMeasure for SumOfSizes {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn start<R: Real>() -> R {
        R::of(0.0)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with<R: Real>(sum: R, term: R) -> R {
        sum + term.magnitude()
    }
}

#[cfg(test)]
mod tests {
    use super::{decisive, decisive_vector};
    use crate::assembly::Assembly;
    use crate::batch::lanes::Lanes;
    use crate::geometry::Plane;
    use crate::number::Number;
    use crate::solve::Scalar;
    use crate::solve::{
        arc_sine, area_hyperbolic_cosine, area_hyperbolic_tangent, check_angle, check_value, circle_circle,
        circle_circle_squared, circle_line, circle_line_x, cosine_sine, factor, inverse_hyperbolic_cosine,
        inverse_sine, linear_pair, polar_offset, quadratic, sine_of_arc,
    };
    use core::f64::consts::{FRAC_PI_2, PI};

    type Four = Lanes<4, 128>;

    #[test]
    fn one_pose_decides_by_itself() {
        let never = || -> [f64; 2] { panic!("nobody asks for the terms") };
        assert_eq!(decisive(0.0, never), 0.0);
        let vector = Plane::new(1e-30, 0.0);
        assert_eq!(decisive_vector(vector, never), vector);
    }

    #[test]
    fn several_poses_keep_what_is_larger_than_rounding() {
        let numbers = Lanes::<4, 128>([0.0, 1e-13, -1e-11, 1.0]);
        let one = Lanes::constant(1.0);
        let kept = decisive(numbers, || [one, -one]).0;
        assert!(kept[0].is_nan() && kept[1].is_nan());
        assert_eq!(kept[2..], [-1e-11, 1.0]);
        let vector = Plane::new(numbers, Lanes([0.0, 0.0, 0.0, 0.0]));
        let Plane { x, y } = decisive_vector(vector, || [one, one, one]);
        assert!(x.0[1].is_nan() && y.0[1].is_nan());
        assert_eq!((x.0[3], y.0[3]), (1.0, 0.0));
    }

    /// Runs a form on four numbers: well inside its range, inside by a relative margin of 10⁻¹⁴, inside by 10⁻⁹, and
    /// halfway to the end. Only the second is left to the solver for one pose.
    fn leaves_the_second<R>(inside: f64, limit: f64, form: impl Fn(Four) -> R, result: impl Fn(R) -> Four) {
        let towards = |part: f64| limit + (inside - limit) * part;
        let Lanes(found) = result(form(Lanes([inside, towards(1e-14), towards(1e-9), towards(0.5)])));
        let finite = found.map(f64::is_finite);
        assert_eq!(finite, [true, false, true, true], "{inside} {limit}: {found:?}");
    }

    /// The unit of length makes no difference.
    #[test]
    fn every_form_leaves_to_others_what_rounding_decides() {
        for unit in [1.0, 1.0 / 1_073_741_824.0, 1_073_741_824.0] {
            every_form_of_lengths(unit);
        }
        let is = |value: f64| Four::constant(value);
        let pair = |c: Four| linear_pair([[is(2.0), is(3.0)], [c, is(6.0)]], [is(1.0), is(1.0)]).unwrap();
        leaves_the_second(1.0, 4.0, pair, |(x, _)| x);
        let system = |c: Four| {
            factor([[is(2.0), is(3.0)], [c, is(6.0)]])
                .unwrap()
                .solve([is(1.0), is(1.0)])
        };
        leaves_the_second(1.0, 4.0, system, |[x, _]| x);
        leaves_the_second(0.5, 1.0, |x| arc_sine(x).unwrap(), |x| x);
        leaves_the_second(3.0, 1.0, |x| area_hyperbolic_cosine(x).unwrap(), |x| x);
        leaves_the_second(0.5, -1.0, |x| area_hyperbolic_tangent(x).unwrap(), |x| x);
        let by_cosine = |v| inverse_hyperbolic_cosine(v, is(1.0), Assembly::Open).unwrap();
        leaves_the_second(3.0, 1.0, by_cosine, |x| x);
        leaves_the_second(0.5, -FRAC_PI_2, |x| sine_of_arc(x).unwrap(), |x| x);
        leaves_the_second(
            -4.0,
            3.0 - 2.0 * PI,
            |x| check_angle("x", x, 1.0, 3.0).unwrap_or(x),
            |x| x,
        );
    }

    /// Coefficients that are next to what rounding leaves of zeros.
    #[test]
    fn coefficients_that_may_be_zeros_are_left_to_others() {
        let coefficients = Lanes([1.0, 1e-16, 1e-9, 1.79e-15]);
        let zero = Four::constant(0.0);
        let (Plane { x, .. }, _) = cosine_sine(coefficients, zero, zero, 1.0, Assembly::Open).unwrap();
        // the last one is clearly larger than 8 ε
        assert_eq!(x.0.map(f64::is_finite), [true, false, true, true]);
        for coefficient in coefficients.0 {
            let one = cosine_sine(coefficient, 0.0, 0.0, 1.0, Assembly::Open);
            assert_eq!(one.is_ok(), coefficient > 8.0 * f64::EPSILON, "{coefficient}");
        }
    }

    fn every_form_of_lengths(unit: f64) {
        let is = |value: f64| Four::constant(value);
        let long = |length: f64| is(length * unit);
        let square = |area: f64| is(area * unit * unit);
        let at = |x: Four, y: f64| Plane::new(x, long(y));
        let open = Assembly::Open;
        leaves_the_second(
            5.0 * unit,
            7.0 * unit,
            |d| circle_circle(long(3.0), long(4.0), at(d, 0.0), open).unwrap(),
            |r| r.0.y,
        );
        leaves_the_second(
            2.0 * unit,
            1.0 * unit,
            |d| circle_circle(long(3.0), long(-4.0), at(d, 0.0), open).unwrap(),
            |r| r.0.y,
        );
        leaves_the_second(
            5.0 * unit,
            7.0 * unit,
            |d| circle_circle_squared(square(9.0), square(16.0), at(d, 0.0), open).unwrap(),
            |r| r.y,
        );
        let along = Plane::new(is(0.6), is(0.8));
        let slide = |y: Four| circle_line(square(25.0), along, Plane::new(long(1.0), y), open).unwrap();
        leaves_the_second(0.0, unit * (5.0 + 0.8) / 0.6, slide, |(link, _)| link.x);
        let slide = |y: Four| circle_line_x(square(25.0), Plane::new(long(1.0), y), open).unwrap();
        leaves_the_second(0.0, 5.0 * unit, slide, |(_, travel)| travel);
        leaves_the_second(
            9.0 * unit,
            2.0 * unit,
            |d| polar_offset(at(long(1.0), 2.0), at(d, 0.0), open).unwrap(),
            |r| r.0,
        );
        leaves_the_second(
            1.0 * unit,
            5.0 * unit,
            |c| cosine_sine(long(3.0), long(4.0), c, 7.0 * unit, open).unwrap(),
            |r| r.0.x,
        );
        leaves_the_second(
            1.0 * unit,
            5.0 * unit,
            |height| inverse_sine(height, long(-5.0), open).unwrap(),
            |r| r.value,
        );
        let area = unit * unit;
        leaves_the_second(
            1.0 * area,
            4.0 * area,
            |c| quadratic(is(1.0), long(-4.0), c, open).unwrap(),
            |x| x,
        );
        leaves_the_second(
            1.5 * unit,
            1.0 * unit,
            |x| check_value("x", x, unit, 3.0 * unit).unwrap(),
            |x| x,
        );
    }

    /// A number close to an end of a range, relative to the size of the range, is left to the solver for one pose;
    /// other numbers are not.
    #[test]
    fn an_end_of_a_range_is_distinct_beyond_a_part_of_its_size() {
        let nearer = |part: f64| 1.0 + part * 3.0 * Four::DOUBT;
        let values = Lanes([2.0, nearer(0.9), nearer(1.1), nearer(20.0)]);
        let Lanes(found) = check_value::<Four>("x", values, 1.0, 3.0).unwrap();
        assert_eq!(found.map(f64::is_finite), [true, false, true, true]);
    }
}
