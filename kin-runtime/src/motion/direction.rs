//! An angle as a unit vector, with its time derivatives.

use core::array;

use crate::geometry::Plane;
use crate::motion::Motion;
use crate::solve::{self, Scalar};

/// The direction of a link as a unit vector, which holds the cosine and sine of its angle, and the first `N` time
/// derivatives of the angle.
///
/// An unknown declared as a `Direction` has this type. The closed forms give the cosine and sine; the angle would cost
/// an arctangent. If you only need the cosine and sine, as for all vectors of the link, that saves the arctangent;
/// [`angle`](Direction::angle) calculates it on request. In the declaration, the name still denotes the angle.
///
/// The vector has length 1 up to rounding. The derivatives are in radians per power of the unit of time, not divided by
/// factorials. A position has no derivatives, and a pose up to snap has four.
///
/// ```
/// use kin_core::prelude::*;
///
/// mechanism! {
///     /// Planar four-bar linkage: ground 1, crank 2, coupler 3, rocker 4.
///     pub struct Linkage { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
///     input theta2: Angle;
///     unknown theta3: Direction, theta4: Direction;
///     r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
/// }
///
/// let linkage: Linkage = Linkage { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let pose = linkage.solve(Motion::at_constant_speed(1.1, 10.0), Assembly::Open)?;
///
/// // the coupler's pin by the rocker, and how fast it moves along x
/// let pin = pose.theta4.unit().scale(linkage.r4);
/// let speed = -linkage.r4 * pose.theta4.sine() * pose.theta4.velocity();
/// println!("{pin:?} {speed} {}", pose.theta4.snap());
///
/// // an arctangent, here and now
/// assert!((pose.theta4.angle().cos() - pose.theta4.cosine()).abs() < 1e-15);
///
/// // what it costs: none has been paid before
/// assert!(Linkage::OPERATIONS.iter().all(|order| order.arc_tangents == 0));
/// # Ok::<(), SolveError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction<T = f64, const N: usize = 4> {
    unit: Plane<T>,
    pub(super) rates: [T; N],
}

impl<T, const N: usize> Direction<T, N> {
    /// The highest order of derivative.
    pub const ORDER: usize = N;

    /// The direction with the given unit vector (cosine and sine) and the time derivatives of its angle in ascending
    /// order, from the first on.
    #[inline]
    #[must_use]
    pub const fn new(unit: Plane<T>, rates: [T; N]) -> Self {
        Self { unit, rates }
    }

    /// The parts of the direction: the unit vector, and the derivatives from the first on.
    ///
    /// In a batch these are the columns.
    #[inline]
    #[must_use]
    pub const fn parts(&self) -> (&Plane<T>, &[T; N]) {
        (&self.unit, &self.rates)
    }

    /// The parts of the direction as mutable references, for example to choose the columns of a batch.
    ///
    /// ```
    /// use kin_core::{Direction, Plane};
    ///
    /// let unit = Plane::new(Some([0.0; 8]), Some([0.0; 8]));
    /// let mut columns: Direction<Option<[f64; 8]>> = Direction::new(unit, [None; 4]);
    /// let (unit, rates) = columns.parts_mut();
    /// unit.y = None;
    /// rates[0] = Some([0.0; 8]);
    /// ```
    #[inline]
    #[must_use]
    pub const fn parts_mut(&mut self) -> (&mut Plane<T>, &mut [T; N]) {
        (&mut self.unit, &mut self.rates)
    }
}

impl<T: Copy, const N: usize> Direction<T, N> {
    /// The unit vector.
    #[inline]
    #[must_use]
    pub const fn unit(&self) -> Plane<T> {
        self.unit
    }

    /// The cosine of the angle.
    #[inline]
    #[must_use]
    pub const fn cosine(&self) -> T {
        self.unit.x
    }

    /// The sine of the angle.
    #[inline]
    #[must_use]
    pub const fn sine(&self) -> T {
        self.unit.y
    }

    /// The time derivatives of the angle in ascending order, from the first on.
    #[inline]
    #[must_use]
    pub const fn rates(&self) -> [T; N] {
        self.rates
    }

    /// This direction with the first `M` derivatives only. Asking for more than it has is an error at compile time.
    ///
    /// ```
    /// use kin_core::{Direction, Plane};
    ///
    /// let upright = Direction::new(Plane::new(0.0, 1.0), [-10.0, 2.0]);
    /// assert_eq!(upright.truncate::<1>(), Direction::new(Plane::new(0.0, 1.0), [-10.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn truncate<const M: usize>(self) -> Direction<T, M> {
        const { assert!(M <= N, "a direction can be cut short, but not extended") };
        Direction::new(self.unit, array::from_fn(|order| self.rates[order]))
    }
}

impl<T: Scalar, const N: usize> Direction<T, N> {
    /// The angle in radians, in -π ..= π. Each call calculates an arctangent.
    ///
    /// ```
    /// use core::f64::consts::FRAC_PI_2;
    /// use kin_core::{Direction, Plane};
    ///
    /// assert_eq!(Direction::new(Plane::new(0.0, 1.0), []).angle(), FRAC_PI_2);
    /// ```
    #[inline]
    #[must_use]
    pub fn angle(&self) -> T {
        self.unit.y.atan2(self.unit.x)
    }

    /// The angle closest to a given one in radians, unwrapped. Each call calculates an arctangent.
    ///
    /// ```
    /// use core::f64::consts::PI;
    /// use kin_core::{Direction, Plane};
    ///
    /// assert_eq!(Direction::new(Plane::new(-1.0, 0.0), []).angle_near(9.0), 3.0 * PI);
    /// ```
    #[inline]
    #[must_use]
    pub fn angle_near(&self, near: T) -> T {
        solve::unwrap_near(self.angle(), near)
    }

    /// The time derivative of the angle of the given order, if there is one. Order 0 is the [`angle`](Self::angle).
    #[inline]
    #[must_use]
    pub fn derivative(&self, order: usize) -> Option<T> {
        match order.checked_sub(1) {
            None => Some(self.angle()),
            Some(index) => self.rates.get(index).copied(),
        }
    }

    /// Whether cosine, sine and every derivative are finite, that is neither NaN nor infinite.
    ///
    /// ```
    /// use kin_core::{Direction, Plane};
    ///
    /// assert!(Direction::new(Plane::new(0.0, 1.0), [-10.0]).is_finite());
    /// assert!(!Direction::new(Plane::new(0.0, f64::NAN), [-10.0]).is_finite());
    /// assert!(!Direction::new(Plane::new(0.0, 1.0), [f64::INFINITY]).is_finite());
    /// ```
    #[inline]
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.unit.x.is_finite() && self.unit.y.is_finite() && self.rates.iter().all(|rate| rate.is_finite())
    }
}

/// Defines the methods that change the number of derivatives, or include the angle among them.
macro_rules! lengths {
    ($($length:literal -> $longer:literal: $($entry:ident)*;)+) => {
        $(
            impl<T> Direction<T, $length> {
                /// This direction with the next derivative of its angle appended.
                #[inline]
                #[must_use]
                pub fn and(self, next: T) -> Direction<T, $longer> {
                    let [$($entry),*] = self.rates;
                    Direction::new(self.unit, [$($entry,)* next])
                }
            }
        )+
    };
    (motions $($length:literal -> $longer:literal: $($entry:ident)*;)+) => {
        $(
            impl<T: Copy> Direction<T, $length> {
                /// The motion of the angle with a known value, on any revolution.
                #[cfg_attr(not(debug_assertions), inline(always))]
                #[must_use]
                pub fn motion_from(&self, angle: T) -> Motion<T, $longer> {
                    let [$($entry),*] = self.rates;
                    Motion::new([angle, $($entry),*])
                }
            }

            impl<T: Scalar> Direction<T, $length> {
                /// The motion of the angle, with its value in -π ..= π. Each call calculates an arctangent.
                #[inline]
                #[must_use]
                pub fn motion(&self) -> Motion<T, $longer> {
                    self.motion_from(self.angle())
                }
            }
        )+
    };
}

lengths! {
    0 -> 1: ;
    1 -> 2: a;
    2 -> 3: a b;
    3 -> 4: a b c;
    4 -> 5: a b c d;
    5 -> 6: a b c d e;
    6 -> 7: a b c d e f;
    7 -> 8: a b c d e f g;
    8 -> 9: a b c d e f g h;
    9 -> 10: a b c d e f g h i;
    10 -> 11: a b c d e f g h i j;
    11 -> 12: a b c d e f g h i j k;
}

lengths! {
    motions
    0 -> 1: ;
    1 -> 2: a;
    2 -> 3: a b;
    3 -> 4: a b c;
    4 -> 5: a b c d;
    5 -> 6: a b c d e;
    6 -> 7: a b c d e f;
    7 -> 8: a b c d e f g;
    8 -> 9: a b c d e f g h;
    9 -> 10: a b c d e f g h i;
    10 -> 11: a b c d e f g h i j;
    11 -> 12: a b c d e f g h i j k;
    12 -> 13: a b c d e f g h i j k l;
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI, TAU};

    use super::Direction;
    use crate::geometry::Plane;
    use crate::motion::Motion;

    const UPRIGHT: Plane = Plane::new(0.0, 1.0);

    #[test]
    fn derivatives_are_those_of_the_angle() {
        let direction = Direction::new(UPRIGHT, []).and(1.0).and(2.0).and(3.0).and(4.0);
        assert_eq!(direction, Direction::new(UPRIGHT, [1.0, 2.0, 3.0, 4.0]));
        let named = [
            direction.velocity(),
            direction.acceleration(),
            direction.jerk(),
            direction.snap(),
        ];
        assert_eq!(named, direction.rates());
        let motion = direction.motion();
        assert_eq!(motion, Motion::from([FRAC_PI_2, 1.0, 2.0, 3.0, 4.0]));
        for order in 0..7 {
            assert_eq!(direction.derivative(order), motion.derivative(order));
        }
        assert_eq!(direction.motion_from(7.0), Motion::from([7.0, 1.0, 2.0, 3.0, 4.0]));
    }

    #[test]
    fn to_the_twelfth_derivative() {
        let direction = Direction::new(UPRIGHT, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0]).and(12.0);
        let named = [
            direction.crackle(),
            direction.pop(),
            direction.derivative_7(),
            direction.derivative_8(),
            direction.derivative_9(),
            direction.derivative_10(),
            direction.derivative_11(),
            direction.derivative_12(),
        ];
        assert_eq!(named[..], direction.rates()[4..]);
        assert_eq!(direction.motion().derivatives()[1..], direction.rates());
        assert_eq!(direction.truncate::<4>().motion().snap(), 4.0);
    }

    #[test]
    fn the_angle_is_found_on_any_revolution() {
        let back = Direction::new(Plane::new(-1.0, 0.0), [2.0]);
        assert_eq!(back.angle(), PI);
        assert_eq!(back.angle_near(-2.0), -PI);
        assert_eq!(back.motion_from(back.angle_near(9.0)), Motion::from([PI + TAU, 2.0]));
        // NaN is not a guess.
        assert_eq!(back.angle_near(f64::NAN), PI);
    }

    #[test]
    fn columns_can_be_left_out() {
        let mut columns = Direction::new(Plane::new(Some(1.0), Some(2.0)), [None; 2]);
        let (unit, rates) = columns.parts_mut();
        (unit.y, rates[1]) = (None, Some(3.0));
        assert_eq!(columns.parts(), (&Plane::new(Some(1.0), None), &[None, Some(3.0)]));
    }
}
