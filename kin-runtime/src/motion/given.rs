//! The forms in which a program gives the motion of an input.

use super::Motion;
use crate::number::Number;

/// The motion of an input: what `solve` takes for each of them.
///
/// | given | means |
/// |---|---|
/// | `1.0` | the value 1, at rest |
/// | `[1.0, 2.0, 0.0, 0.0, 0.0]` | the value and its derivatives through the mechanism's order |
/// | `(1.0, 2.0, 0.0, 0.0, 0.0)` | the same |
/// | [`Motion`] | itself |
///
/// A mechanism to the order n takes exactly n + 1 entries: five through snap.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let moving = linkage.solve([1.0, -10.0, 0.0, 0.0, 0.0], Assembly::Open)?;
/// assert_eq!(moving, linkage.solve(Motion::at_constant_speed(1.0, -10.0), Assembly::Open)?);
/// let at_rest = linkage.solve(1.0, Assembly::Open)?;
/// assert_eq!(at_rest.theta4.velocity(), 0.0);
/// # Ok::<(), SolveError>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not the motion of this input, which has {N} entries of the type `{T}`",
    label = "give {N} entries from the position upwards, as in `[1.0, 2.0, ..]`, or one number for an input at rest",
    note = "`Motion::at_constant_speed(position, speed)` and `Motion::constant(position)` fill the other entries with \
            zeros",
    note = "`position` takes the value alone, without rates",
    note = "every input has its own argument, in the order of their declaration, and the assembly comes last",
    note = "numbers have a decimal point: write `1.0` instead of `1`"
)]
pub trait IntoMotion<T, const N: usize> {
    /// The value and its derivatives.
    fn into_motion(self) -> Motion<T, N>;
}

impl<T, const N: usize> IntoMotion<T, N> for Motion<T, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn into_motion(self) -> Self {
        self
    }
}

impl<T, const N: usize> IntoMotion<T, N> for [T; N] {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn into_motion(self) -> Motion<T, N> {
        Motion::new(self)
    }
}

/// A value at rest.
impl<T: Number, const N: usize> IntoMotion<T, N> for T {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn into_motion(self) -> Motion<T, N> {
        Motion::constant(self)
    }
}

/// A value at rest.
impl<T: Number, const N: usize> From<T> for Motion<T, N> {
    #[inline]
    fn from(value: T) -> Self {
        Self::constant(value)
    }
}

macro_rules! tuple {
    ($length:literal: $($entry:ident),+) => {
        impl<T> From<($(tuple!(@type $entry T),)+)> for Motion<T, $length> {
            #[inline]
            fn from(($($entry,)+): ($(tuple!(@type $entry T),)+)) -> Self {
                Self::new([$($entry),+])
            }
        }

        impl<T> IntoMotion<T, $length> for ($(tuple!(@type $entry T),)+) {
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn into_motion(self) -> Motion<T, $length> {
                self.into()
            }
        }
    };
    (@type $entry:ident $type:ident) => { $type };
}

tuple!(1: value);
tuple!(2: value, velocity);
tuple!(3: value, velocity, acceleration);
tuple!(4: value, velocity, acceleration, jerk);
tuple!(5: value, velocity, acceleration, jerk, snap);
tuple!(6: value, velocity, acceleration, jerk, snap, crackle);
tuple!(7: value, velocity, acceleration, jerk, snap, crackle, pop);

#[cfg(test)]
mod tests {
    use super::IntoMotion;
    use crate::motion::Motion;

    fn five<T>(motion: impl IntoMotion<T, 5>) -> Motion<T, 5> {
        motion.into_motion()
    }

    #[test]
    fn every_form_gives_the_same_motion() {
        let expected = Motion::new([1.0, 2.0, 0.0, 0.0, 0.0]);
        assert_eq!(five(expected), expected);
        assert_eq!(five([1.0, 2.0, 0.0, 0.0, 0.0]), expected);
        assert_eq!(five((1.0, 2.0, 0.0, 0.0, 0.0)), expected);
        assert_eq!(five(Motion::at_constant_speed(1.0, 2.0)), expected);
    }

    #[test]
    fn a_number_is_a_value_at_rest() {
        assert_eq!(five(1.5), Motion::constant(1.5));
        assert_eq!(five::<f32>(1.5).derivatives(), [1.5_f32, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(five(Motion::from(1.5)), Motion::new([1.5, 0.0, 0.0, 0.0, 0.0]));
    }
}
