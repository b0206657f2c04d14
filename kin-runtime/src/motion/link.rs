//! The plane motion of a link: instant centre, acceleration pole and inflection circle.

use crate::geometry::Plane;
use crate::motion::Motion;
use crate::motion::curve::{finite, finite_vector, normal};
use crate::solve::{self, Scalar};

/// The motion of a link, given by the motion of one of its points and of its angle.
///
/// Any point of the link and any line in it will do. In complex numbers, let A be the point, **v** its velocity, **a**
/// its acceleration, and ω and α the angular velocity and acceleration of the link. A point X of the link then has the
/// velocity **v** + i ω (X - A) and the acceleration **a** + (i α - ω²) (X - A). Everything else follows from these
/// two; see R. S. Hartenberg and J. Denavit, *Kinematic Synthesis of Linkages*, McGraw-Hill 1964, and K. H. Hunt,
/// *Kinematic Geometry of Mechanisms*, Oxford 1978.
///
/// Lengths share any one unit; angles are in radians.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
/// use kin_core::LinkMotion;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let crank = Motion::from([65_f64.to_radians(), -10.0, 2.0, -0.5, 0.3]);
/// let pose = linkage.solve(crank, Assembly::Open)?;
///
/// // the coupler, by the crank's pin
/// let (sine, cosine) = crank.sin_cos();
/// let pin = Motion::from_coordinates(cosine.scale(linkage.r2), sine.scale(linkage.r2));
/// let coupler = LinkMotion::new(pin, pose.theta3);
///
/// // its instant centre lies where the lines of crank and rocker cross
/// let centre = coupler.instant_centre().unwrap();
/// assert!((centre.y / centre.x - crank.value().tan()).abs() < 1e-13);
/// assert!((centre.y / (centre.x - linkage.r1) - pose.theta4.position().tan()).abs() < 1e-13);
///
/// // how the middle of the coupler moves, and how its path bends
/// let middle = coupler.carried(pin.value() + Plane::new(30.0, 0.0).times(Plane::new(
///     pose.theta3.position().cos(),
///     pose.theta3.position().sin(),
/// )));
/// println!("{:?} {:?}", middle.velocity(), middle.radius_of_curvature());
/// # Ok::<(), SolveError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkMotion<T = f64, const N: usize = 5> {
    /// A point of the link.
    pub point: Motion<Plane<T>, N>,
    /// The angle of a line in the link.
    pub angle: Motion<T, N>,
}

impl<T: Scalar, const N: usize> LinkMotion<T, N> {
    /// The motion of a link, from a point and an angle.
    #[inline]
    #[must_use]
    pub const fn new(point: Motion<Plane<T>, N>, angle: Motion<T, N>) -> Self {
        Self { point, angle }
    }

    /// The motion of the point of the link that is now at the given position.
    ///
    /// The motion is A + (X - A) cis(θ - θ now), differentiated to every order.
    ///
    /// ```
    /// use kin_core::{LinkMotion, Motion, Plane};
    ///
    /// // a wheel of radius 2 that rolls on the x axis: the point of contact rests, the top is twice as fast as the hub
    /// let hub = Motion::from([Plane::new(0.0, 2.0), Plane::new(6.0, 0.0)]);
    /// let wheel = LinkMotion::new(hub, Motion::from([0.0, -3.0]));
    /// assert_eq!(wheel.carried(Plane::new(0.0, 0.0)).velocity(), Plane::new(0.0, 0.0));
    /// assert_eq!(wheel.carried(Plane::new(0.0, 4.0)).velocity(), Plane::new(12.0, 0.0));
    /// ```
    #[must_use]
    pub fn carried(&self, point: Plane<T>) -> Motion<Plane<T>, N> {
        let arm = point - self.point.value();
        let (sine, cosine) = (self.angle - Motion::constant(self.angle.value())).sin_cos();
        self.point
            + Motion::from_coordinates(
                cosine.scale(arm.x) - sine.scale(arm.y),
                sine.scale(arm.x) + cosine.scale(arm.y),
            )
    }

    /// The instant centre, or velocity pole: the point of the link's plane that is at rest, A + i **v** / ω. Every
    /// point moves at right angles to its line to the instant centre, at a speed proportional to its distance.
    ///
    /// The result is `None` where the link does not rotate: then there is no centre, or all points rest. It needs the
    /// velocity.
    ///
    /// ```
    /// use kin_core::{LinkMotion, Motion, Plane};
    ///
    /// // a ladder of length 5 slides down a wall: the normals of wall and floor cross at (3, 4)
    /// let foot = Motion::from([Plane::new(3.0, 0.0), Plane::new(1.0, 0.0)]);
    /// let angle = Motion::from([(-4.0_f64).atan2(3.0), 0.25]);
    /// let ladder = LinkMotion::new(foot, angle);
    /// assert_eq!(ladder.instant_centre(), Some(Plane::new(3.0, 4.0)));
    /// ```
    #[must_use]
    pub fn instant_centre(&self) -> Option<Plane<T>> {
        let rate_of_rotation = self.rate_of_rotation::<1>();
        solve::regular(rate_of_rotation).ok()?;
        let arm = normal(self.point.rate::<1>()).scale(T::constant(1.0) / rate_of_rotation);
        finite_vector(self.point.value() + arm)
    }

    /// The acceleration pole: the point of the link's plane without acceleration, A + **a** / (ω² - i α).
    ///
    /// The result is `None` where the link has neither angular velocity nor angular acceleration. It needs the
    /// acceleration.
    ///
    /// ```
    /// use kin_core::{LinkMotion, Motion, Plane};
    ///
    /// // a wheel that rolls at constant speed: its hub
    /// let rim = Motion::from([Plane::new(0.0, 0.0), Plane::new(0.0, 0.0), Plane::new(0.0, 18.0)]);
    /// let wheel = LinkMotion::new(rim, Motion::from([0.0, -3.0, 0.0]));
    /// assert_eq!(wheel.acceleration_pole(), Some(Plane::new(0.0, 2.0)));
    /// ```
    #[must_use]
    pub fn acceleration_pole(&self) -> Option<Plane<T>> {
        let (speed, acceleration) = (self.rate_of_rotation::<1>(), self.rate_of_rotation::<2>());
        let square = speed * speed;
        let size = square * square + acceleration * acceleration;
        solve::regular(size).ok()?;
        let arm = self
            .point
            .rate::<2>()
            .times(Plane::new(square, acceleration))
            .scale(T::constant(1.0) / size);
        finite_vector(self.point.value() + arm)
    }

    /// The inflection pole, which lies opposite the instant centre on the [inflection
    /// circle](Self::inflection_diameter).
    ///
    /// The pole is P + **a**ₚ / ω², where **a**ₚ is the acceleration of the point of the link that is now at the
    /// instant centre P. The result is `None` where the link does not rotate. It needs the acceleration.
    ///
    /// ```
    /// use kin_core::{LinkMotion, Motion, Plane};
    ///
    /// // a rolling wheel, however it is accelerated: its hub, which moves on a straight line
    /// let hub = Motion::from([Plane::new(1.0, 2.0), Plane::new(6.0, 0.0), Plane::new(8.0, 0.0)]);
    /// let wheel = LinkMotion::new(hub, Motion::from([0.0, -3.0, -4.0]));
    /// assert_eq!(wheel.instant_centre(), Some(Plane::new(1.0, 0.0)));
    /// assert_eq!(wheel.inflection_pole(), Some(Plane::new(1.0, 2.0)));
    /// assert_eq!(wheel.inflection_diameter(), Some(2.0));
    /// ```
    #[must_use]
    pub fn inflection_pole(&self) -> Option<Plane<T>> {
        finite_vector(self.instant_centre()? + self.inflection_arm()?)
    }

    /// The diameter of the inflection circle, which consists of all points of the link's plane whose paths are now
    /// straight to second order.
    ///
    /// The diameter is |**a**ₚ| / ω², which is the speed at which the instant centre shifts, divided by ω. By the
    /// equation of Euler and Savary, it gives the centre of curvature of every other path: if a point has the distance
    /// r from the instant centre, and the inflection circle has the distance w on the same ray, the radius of curvature
    /// is r² / |r - w|. The diameter is zero where **a**ₚ is zero. All paths then have the instant centre as their
    /// centre of curvature, as for a link that rotates about a fixed point.
    ///
    /// The result is `None` where the link does not rotate. It needs the acceleration.
    #[must_use]
    pub fn inflection_diameter(&self) -> Option<T> {
        let square = self.inflection_arm()?.norm_squared();
        if square.real() == 0.0 {
            // The square root has no derivative here.
            return Some(T::constant(0.0));
        }
        solve::regular(square).ok()?;
        finite(square.sqrt())
    }

    /// The vector from the instant centre to the inflection pole.
    fn inflection_arm(&self) -> Option<Plane<T>> {
        let arm = self.instant_centre()? - self.point.value();
        let (speed, acceleration) = (self.rate_of_rotation::<1>(), self.rate_of_rotation::<2>());
        let square = speed * speed;
        solve::regular(square).ok()?;
        let resting = self.point.rate::<2>() + arm.times(Plane::new(-square, acceleration));
        Some(resting.scale(T::constant(1.0) / square))
    }

    /// The derivative of the angle of a given order. The code does not compile if the motion has no such derivative.
    fn rate_of_rotation<const ORDER: usize>(&self) -> T {
        const {
            assert!(
                ORDER < N,
                "the motion does not go to the order of derivative that this needs"
            );
        };
        self.angle.as_slice()[ORDER]
    }
}

#[cfg(test)]
mod tests {
    use super::LinkMotion;
    use crate::geometry::Plane;
    use crate::motion::Motion;
    use crate::number::Number;

    const EPSILON: f64 = f64::EPSILON;

    fn size(vector: Plane) -> f64 {
        Number::sqrt(vector.norm_squared())
    }

    /// A link without special properties.
    fn link() -> LinkMotion<f64, 4> {
        LinkMotion::new(
            Motion::from([
                Plane::new(1.0, -2.0),
                Plane::new(3.0, 0.5),
                Plane::new(-4.0, 7.0),
                Plane::new(9.0, 2.0),
            ]),
            Motion::from([0.4, 1.7, -2.2, 3.1]),
        )
    }

    #[test]
    fn the_instant_centre_rests() {
        let link = link();
        let centre = link.carried(link.instant_centre().unwrap());
        assert!(size(centre.velocity()) <= 4.0 * EPSILON * size(link.point.velocity()));
        // Another point and another line of the same link give the same results.
        let other = LinkMotion::new(link.carried(Plane::new(5.0, 5.0)), link.angle + Motion::constant(1.0));
        let distance = size(other.instant_centre().unwrap() - centre.value());
        assert!(distance <= 16.0 * EPSILON * size(centre.value() - Plane::new(5.0, 5.0)));
    }

    #[test]
    fn the_acceleration_pole_is_not_accelerated() {
        let link = link();
        let pole = link.carried(link.acceleration_pole().unwrap());
        assert!(size(pole.acceleration()) <= 8.0 * EPSILON * size(link.point.acceleration()));
    }

    #[test]
    fn points_of_the_inflection_circle_go_straight() {
        let link = link();
        let (centre, pole) = (link.instant_centre().unwrap(), link.inflection_pole().unwrap());
        let diameter = link.inflection_diameter().unwrap();
        assert!((size(pole - centre) - diameter).abs() <= 4.0 * EPSILON * diameter);
        let middle = (centre + pole).scale(0.5);
        for angle in [0.3_f64, 1.2, 2.0, 4.4] {
            let (sine, cosine) = Number::sin_cos(angle);
            let point = link.carried(middle + (pole - middle).times(Plane::new(cosine, sine)));
            let bound = size(point.acceleration()) / point.velocity().norm_squared();
            assert!(point.curvature().unwrap().abs() <= 32.0 * EPSILON * bound, "{angle}");
        }
    }

    #[test]
    fn euler_and_savary_agree_with_the_curvature() {
        let link = link();
        let (centre, pole) = (link.instant_centre().unwrap(), link.inflection_pole().unwrap());
        for point in [Plane::new(0.0, 0.0), Plane::new(-4.0, 1.0), Plane::new(2.0, 9.0)] {
            let arm = point - centre;
            let distance = size(arm);
            let inflection = (pole - centre).dot(arm) / distance;
            let expected = distance * distance / (distance - inflection).abs();
            let found = link.carried(point).radius_of_curvature().unwrap().abs();
            let condition = (distance + inflection.abs()) / (distance - inflection).abs();
            assert!((found - expected).abs() <= 16.0 * EPSILON * condition * expected);
        }
    }

    #[test]
    fn a_link_about_a_fixed_pivot_has_no_inflection_circle() {
        let (sine, cosine) = Motion::from([0.0, 2.0, 5.0]).sin_cos();
        let pin = Motion::from_coordinates(cosine, sine);
        let crank = LinkMotion::new(pin, Motion::from([0.0, 2.0, 5.0]));
        assert_eq!(crank.instant_centre(), Some(Plane::new(0.0, 0.0)));
        assert_eq!(crank.acceleration_pole(), Some(Plane::new(0.0, 0.0)));
        assert_eq!(crank.inflection_diameter(), Some(0.0));
    }

    #[test]
    fn a_link_that_does_not_turn_has_no_centre() {
        let point = Motion::from([Plane::new(1.0, 2.0), Plane::new(3.0, 4.0), Plane::new(5.0, 6.0)]);
        let still = LinkMotion::new(point, Motion::from([1.0, 0.0, 0.0]));
        assert_eq!(still.instant_centre(), None);
        assert_eq!(still.acceleration_pole(), None);
        assert_eq!(still.inflection_pole(), None);
        assert_eq!(still.inflection_diameter(), None);
        let beginning = LinkMotion::new(point, Motion::from([1.0, 0.0, 2.0]));
        assert_eq!(beginning.instant_centre(), None);
        assert!(beginning.acceleration_pole().is_some());
    }

    #[test]
    fn derivatives_pass_through() {
        use crate::number::{Number, series::Series};

        // The instant centre of the ladder runs on a circle about the corner; a truncated series gives its shift.
        let angle = Motion::<f64, 4>::from([-0.9, 0.6, 0.0, 0.0]);
        let carry = |order: usize, motion: Motion<f64, 4>| -> Series<2> {
            let entries = motion.derivatives();
            Series::from_coefficients([entries[order], entries[order + 1]])
        };
        let (_, cosine) = angle.sin_cos();
        let foot = cosine.scale(5.0);
        let zero = Series::from_coefficients([0.0, 0.0]);
        let ladder = LinkMotion::new(
            Motion::from([Plane::new(carry(0, foot), zero), Plane::new(carry(1, foot), zero)]),
            Motion::from([carry(0, angle), carry(1, angle)]),
        );
        let centre = ladder.instant_centre().unwrap();
        let (sine, cosine) = Number::sin_cos(-0.9_f64);
        let shift = [-5.0 * sine * 0.6, -5.0 * cosine * 0.6];
        for (found, expected) in [centre.x, centre.y].into_iter().zip(shift) {
            assert!((found.coefficients()[1] - expected).abs() <= 16.0 * EPSILON * 3.0);
        }
    }
}
