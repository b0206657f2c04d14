//! The choice among angles that differ by whole revolutions.

use core::f64::consts::TAU;

use crate::failure::Failure;
use crate::quantity::Name;
use crate::solve::Scalar;
use crate::solve::check::doubt::SumOfSizes;
use crate::solve::check::{Check, Measure, Real, Zero};

/// The largest useful spacing of numbers, about a degree. Angles with a larger spacing define no direction.
const COARSEST: f64 = 1.0 / 64.0;

/// The angle closest to `guess` that differs from `angle` by whole revolutions.
///
/// ```
/// use core::f64::consts::TAU;
/// use kin_core::solve;
///
/// assert_eq!(solve::unwrap_near(0.5, 13.0), 0.5 + 2.0 * TAU);
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn unwrap_near<T: Scalar>(angle: T, guess: T) -> T {
    plus_revolutions(angle, T::measured(NearestRevolutions { angle, guess }))
}

/// [`unwrap_near`] to the guess with the given index. Without guesses, or without a guess of that index, the angle
/// stays unchanged.
///
/// ```
/// use core::f64::consts::TAU;
/// use kin_core::solve;
///
/// assert_eq!(solve::unwrap_to_guess(0.5, Some([3.0, 13.0]), 1), 0.5 + 2.0 * TAU);
/// assert_eq!(solve::unwrap_to_guess(0.5, None::<[f64; 2]>, 1), 0.5);
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn unwrap_to_guess<T: Scalar, const N: usize>(angle: T, near: Option<[T; N]>, index: usize) -> T {
    match near.as_ref().and_then(|guesses| guesses.get(index)) {
        Some(guess) => unwrap_near(angle, *guess),
        None => angle,
    }
}

/// The values of unknowns near a position, unless an angle among them is so large that neighbouring numbers are more
/// than a degree apart: no angle of that size is a solution. `angles` are the names and indices of the angles. A value
/// that is not finite is not a guess, and it passes.
///
/// # Errors
/// [`Failure::TooManyRevolutions`].
///
/// ```
/// use kin_core::{Failure, solve};
///
/// let crank = [("theta", 0)];
/// assert_eq!(solve::check_guesses([1e9, 1e20], crank), Ok([1e9, 1e20]));
/// let failure = solve::check_guesses([1e15, 0.0], crank).unwrap_err();
/// assert_eq!(failure, Failure::TooManyRevolutions { unknown: "theta".into(), guess: 1e15, spacing: 0.125 });
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn check_guesses<T: Scalar, const N: usize, const K: usize>(
    near: [T; N],
    angles: [(&'static str, usize); K],
) -> Result<[T; N], Failure> {
    let mut kept = near;
    check_guesses_in(&mut kept, &angles)?;
    Ok(kept)
}

/// [`check_guesses`] of any number of unknowns. The values stay where they are.
///
/// # Errors
/// [`Failure::TooManyRevolutions`].
#[doc(hidden)]
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn check_guesses_in<T: Scalar>(near: &mut [T], angles: &[(impl Into<Name> + Copy, usize)]) -> Result<(), Failure> {
    let limit = COARSEST / T::EPSILON;
    let size = T::measured_over(SumOfSizes, angles.len(), |index| {
        near.get(angles[index].1).copied().unwrap_or_else(|| T::constant(0.0))
    });
    for index in 0..near.len() {
        match near[index].provided(DefinesDirection { size, limit }) {
            Some(guess) => near[index] = guess,
            // the check is the same for each value, so none has changed
            None => return each_within(near, angles, limit),
        }
    }
    Ok(())
}

#[cold]
#[inline(never)]
fn each_within<T: Scalar>(near: &[T], angles: &[(impl Into<Name> + Copy, usize)], limit: f64) -> Result<(), Failure> {
    for (unknown, index) in angles {
        let guess = near.get(*index).map_or(0.0, |value| value.real());
        if guess.is_finite() && guess.abs() > limit {
            let spacing = guess.abs().next_up() - guess.abs();
            return Err(Failure::TooManyRevolutions {
                unknown: (*unknown).into(),
                guess,
                spacing: spacing * (T::EPSILON / f64::EPSILON),
            });
        }
    }
    Ok(())
}

/// The values of unknowns near a position, checked by the orientations that identify the assembly there. If a number
/// holds several poses, each pose becomes NaN whose assembly differs from that of the first pose, or which has a NaN
/// orientation. Any other number is returned unchanged.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn agreeing<T: Scalar, const N: usize, const K: usize>(near: [T; N], orientations: [T; K]) -> [T; N] {
    let mut kept = near;
    agreeing_in(&mut kept, &orientations);
    kept
}

/// [`agreeing`] of any number of unknowns, which stay where they are.
#[doc(hidden)]
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn agreeing_in<T: Scalar>(near: &mut [T], orientations: &[T]) {
    T::agree(near, orientations);
}

/// An angle plus whole revolutions, given in radians.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn plus_revolutions<T: Scalar>(angle: T, revolutions: T) -> T {
    // Adding zero would remove the sign of a negative zero.
    T::either(Zero(revolutions), || angle, || angle + revolutions)
}

/// The revolutions that bring an angle closest to a guess, in radians.
#[derive(Clone, Copy)]
struct NearestRevolutions<T> {
    angle: T,
    guess: T,
}

impl<T: Scalar> Measure<T, 2> for NearestRevolutions<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 2] {
        [self.angle, self.guess]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measure<R: Real>(&self, [angle, guess]: [R; 2]) -> R {
        let revolutions = ((guess - angle) / R::of(TAU)).rounded();
        // A guess that is not finite does not move the angle.
        let revolutions = R::choose(revolutions.is_finite(), || revolutions, || R::of(0.0));
        revolutions * R::of(TAU)
    }
}

/// Whether angles of this size are spaced closely enough to define a direction. NaN passes.
#[derive(Clone, Copy)]
struct DefinesDirection<T> {
    /// The sum of the magnitudes of the angles.
    size: T,
    limit: f64,
}

impl<T: Scalar> Check<T, 1, 1> for DefinesDirection<T> {
    fn name(&self) -> &'static str {
        "angle that defines a direction"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.size]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [size]: [R; 1]) -> [R::Truth; 1] {
        // NaN does not equal itself.
        [R::either(size.is_at_most(R::of(self.limit)), || {
            R::not(size.equals(size))
        })]
    }

    fn margin(&self) -> T {
        T::constant(self.limit) - self.size
    }
}

/// Whether an orientation of a pose is certain and equals that of the leading pose.
#[derive(Clone, Copy)]
pub(in crate::solve) struct SameSide<T> {
    pub(in crate::solve) orientation: T,
    /// Whether the orientation of the leading pose is positive or zero.
    pub(in crate::solve) leading: bool,
}

impl<T: Scalar> Check<T, 1, 2> for SameSide<T> {
    fn name(&self) -> &'static str {
        "assembly of the values nearby"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.orientation]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [orientation]: [R; 1]) -> [R::Truth; 2] {
        let side = orientation.is_at_least(R::of(0.0));
        // NaN does not equal itself.
        [
            orientation.equals(orientation),
            if self.leading { side } else { R::not(side) },
        ]
    }

    fn margin(&self) -> T {
        if self.leading {
            self.orientation
        } else {
            -self.orientation
        }
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{PI, TAU};

    use proptest::prelude::*;

    use super::{agreeing, check_guesses, check_guesses_in, unwrap_near, unwrap_to_guess};
    use crate::batch::lanes::Lanes;
    use crate::failure::Failure;
    use crate::quantity::{Name, NameKind};

    proptest! {
        #[test]
        fn the_unwrapped_angle_is_within_half_a_revolution(angle in -100.0..100.0, guess in -100.0..100.0) {
            let nearest = unwrap_near::<f64>(angle, guess);
            prop_assert!((nearest - guess).abs() <= PI + 1e-12);
        }
    }

    #[test]
    fn an_angle_near_enough_is_left_alone() {
        assert_eq!(unwrap_near(1.0, f64::NAN), 1.0);
        assert_eq!(unwrap_near(1.0, 2.0), 1.0);
    }

    #[test]
    fn a_guess_that_is_not_there_changes_nothing() {
        assert_eq!(unwrap_to_guess(1.0, Some([7.0]), 0), 1.0 + TAU);
        assert_eq!(unwrap_to_guess(1.0, Some([7.0]), 1), 1.0);
        assert_eq!(unwrap_to_guess(1.0, Some([]), 0), 1.0);
        assert_eq!(unwrap_to_guess::<f64, 1>(1.0, None, 0), 1.0);
    }

    #[test]
    fn of_several_poses_those_whose_orientation_is_uncertain_are_left_to_others() {
        let orientations = [Lanes::<4, 128>([-1.0, f64::NAN, -2.0, 3.0]), Lanes([1.0; 4])];
        let [Lanes(kept)] = agreeing([Lanes([0.1, 0.2, 0.3, 0.4])], orientations);
        assert_eq!([kept[0], kept[2]], [0.1, 0.3]);
        assert!(kept[1].is_nan() && kept[3].is_nan(), "{kept:?}");
        assert_eq!(agreeing([0.2], [f64::NAN]), [0.2]);
    }

    /// Only angles are tested, and the first one that is too large is reported. A value that is not finite is not a
    /// guess.
    #[test]
    fn a_guess_where_numbers_are_a_degree_apart_is_refused() {
        let angles = [("first", 2), ("second", 0)];
        let near = [1e9, 1e200, -1e13];
        assert_eq!(check_guesses(near, angles), Ok(near));
        let refused = |unknown, guess, spacing| Failure::TooManyRevolutions {
            unknown,
            guess,
            spacing,
        };
        assert_eq!(
            check_guesses([1e15, 0.0, 1.0], angles),
            Err(refused("second".into(), 1e15, 0.125))
        );
        assert_eq!(
            check_guesses([1.0, 0.0, -1e16], angles),
            Err(refused("first".into(), -1e16, 2.0))
        );
        assert_eq!(
            check_guesses([1e15, 0.0, 1e16], angles),
            Err(refused("first".into(), 1e16, 2.0))
        );
        let third = Name::by_index(NameKind::Unknown, 2);
        let mut near = [1.0, 0.0, -1e16];
        assert_eq!(
            check_guesses_in(&mut near, &[(third, 2)]),
            Err(refused(third, -1e16, 2.0))
        );
        assert_eq!(check_guesses_in(&mut near, &[(third, 0)]), Ok(()));
        let [kept, ..] = check_guesses([1.0, 0.0, f64::NAN], angles).unwrap();
        assert_eq!(kept, 1.0);
        // Numbers in single precision reach this spacing much earlier.
        let spacing = f64::from(1e6_f32.next_up() - 1e6);
        assert_eq!(
            check_guesses([1e6_f32], [("x", 0)]),
            Err(refused("x".into(), 1e6, spacing))
        );
    }

    /// Only poses in the assembly of the first one continue.
    #[test]
    fn poses_of_another_assembly_are_left() {
        let near = [Lanes::<4, 128>([1.0, 2.0, 3.0, 4.0])];
        let first = Lanes([1.0, 0.0, -2.0, 3.0]);
        let second = Lanes([-1.0, -2.0, -3.0, 4.0]);
        let [Lanes(kept)] = agreeing(near, [first, second]);
        assert_eq!(kept[..2], [1.0, 2.0]);
        assert!(kept[2].is_nan() && kept[3].is_nan(), "{kept:?}");
        assert_eq!(agreeing([5.0, 6.0], [-1.0, 1.0]), [5.0, 6.0]);
    }
}
