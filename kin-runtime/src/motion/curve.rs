//! The path of a moving point: speed, tangent and curvature.

use crate::geometry::Plane;
use crate::motion::Motion;
use crate::solve::{self, Scalar};

/// Properties of the path of a point.
///
/// They belong to the curve and not to the motion along it: the curvature of a coupler curve is the same at any speed
/// of the crank. With velocity **v**, acceleration **a** and jerk **j**, and **e** = **v** / |**v**|,
///
/// - curvature κ = (**v** × **a**) / |**v**|³ = (**e** × **a**) / |**v**|²,
/// - its rate over the arc length s, dκ/ds = ((**e** × **j**) / |**v**| - 3 κ **e** · **a**) / |**v**|²,
///
/// both positive where the path bends to the left of the direction of travel, that is counter-clockwise. See M. P. do
/// Carmo, *Differential Geometry of Curves and Surfaces*, Prentice-Hall 1976, section 1-5, and for mechanisms R. S.
/// Hartenberg and J. Denavit, *Kinematic Synthesis of Linkages*, McGraw-Hill 1964.
///
/// Where the point rests, its path may have a cusp, so there is no direction and no curvature. The result is then
/// `None`, and also if a number is not finite, or too large or too small to be squared. Close to a rest, the curvature
/// is as uncertain as the velocity.
impl<T: Scalar, const N: usize> Motion<Plane<T>, N> {
    /// The speed along the path, in units of length per time; `None` where the point rests.
    ///
    /// The speed has a kink at a rest, and no derivative there. The velocity itself shows that a point rests.
    ///
    /// ```
    /// use kin_core::{Motion, Plane};
    ///
    /// let point = Motion::from([Plane::new(1.0, 1.0), Plane::new(3.0, 4.0)]);
    /// assert_eq!(point.speed(), Some(5.0));
    /// assert_eq!(Motion::<Plane, 2>::from([Plane::new(1.0, 1.0), Plane::new(0.0, 0.0)]).speed(), None);
    /// ```
    #[must_use]
    pub fn speed(&self) -> Option<T> {
        let velocity = self.rate::<1>();
        let square = velocity.norm_squared();
        solve::regular(square).ok()?;
        finite(square.sqrt())
    }

    /// The unit vector in the direction of travel; `None` where the point rests.
    ///
    /// ```
    /// use kin_core::{Motion, Plane};
    ///
    /// let point = Motion::from([Plane::new(1.0, 1.0), Plane::new(0.0, -2.0)]);
    /// assert_eq!(point.tangent(), Some(Plane::new(0.0, -1.0)));
    /// ```
    #[must_use]
    pub fn tangent(&self) -> Option<Plane<T>> {
        Some(self.direction()?.0)
    }

    /// The curvature of the path, in the reciprocal unit of length, positive to the left of the direction of travel;
    /// `None` where the point rests. It needs the acceleration.
    ///
    /// ```
    /// use kin_core::{Motion, Plane};
    ///
    /// // a pin at the radius 0.5, whatever its angular velocity and acceleration
    /// let (sine, cosine) = Motion::from([0.7_f64, -3.0, 20.0]).sin_cos();
    /// let pin = Motion::from_coordinates(cosine.scale(0.5), sine.scale(0.5));
    /// assert!((pin.curvature().unwrap() - -2.0).abs() < 1e-14); // clockwise
    /// assert!((pin.radius_of_curvature().unwrap() - -0.5).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn curvature(&self) -> Option<T> {
        let (tangent, speed) = self.direction()?;
        finite(tangent.cross(self.rate::<2>()) / (speed * speed))
    }

    /// The radius of curvature, which is the reciprocal of the [curvature](Self::curvature), with its sign; `None`
    /// where the point rests or the path is straight.
    #[must_use]
    pub fn radius_of_curvature(&self) -> Option<T> {
        let curvature = self.curvature()?;
        solve::regular(curvature).ok()?;
        finite(T::constant(1.0) / curvature)
    }

    /// The centre of curvature, which is the point about which the path bends; `None` where the point rests or the path
    /// is straight. The evolute of the path is the curve of its centres.
    ///
    /// ```
    /// use kin_core::{Motion, Plane};
    ///
    /// // the parabola y = x², at its apex: the radius is 1/2
    /// let point = Motion::from([Plane::new(0.0, 0.0), Plane::new(3.0, 0.0), Plane::new(0.0, 18.0)]);
    /// assert_eq!(point.centre_of_curvature(), Some(Plane::new(0.0, 0.5)));
    /// ```
    #[must_use]
    pub fn centre_of_curvature(&self) -> Option<Plane<T>> {
        let tangent = self.tangent()?;
        let radius = self.radius_of_curvature()?;
        finite_vector(self.rate::<0>() + normal(tangent).scale(radius))
    }

    /// The rate of change of the curvature along the path, dκ/ds, in the reciprocal square of the unit of length;
    /// `None` where the point rests. It needs the jerk.
    ///
    /// The rate is zero at a vertex of the path. A stretch of path where both this rate and the deviation from a wanted
    /// curvature are zero approximates a circle well; dwell mechanisms use such stretches.
    ///
    /// ```
    /// use kin_core::{Motion, Plane};
    ///
    /// // the parabola y = x² at constant x': κ = 2 (1 + 4 x²)^(-3/2)
    /// let x = Motion::<f64, 4>::polynomial(&[0.0, 2.0], 0.25);
    /// let parabola = Motion::from_coordinates(x, x * x);
    /// let slope = 1.0 + 4.0 * 0.5_f64 * 0.5;
    /// let expected = -24.0 * 0.5 / slope.powi(3);
    /// assert!((parabola.curvature_rate().unwrap() - expected).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn curvature_rate(&self) -> Option<T> {
        let (tangent, speed) = self.direction()?;
        let curvature = self.curvature()?;
        let bending = tangent.cross(self.rate::<3>()) / speed;
        let stretching = T::constant(3.0) * curvature * tangent.dot(self.rate::<2>());
        finite((bending - stretching) / (speed * speed))
    }

    /// The tangent and the speed.
    fn direction(&self) -> Option<(Plane<T>, T)> {
        let speed = self.speed()?;
        let tangent = self.rate::<1>().scale(T::constant(1.0) / speed);
        Some((finite_vector(tangent)?, speed))
    }

    /// The derivative of a given order. The code does not compile if the motion has no such derivative.
    pub(crate) fn rate<const ORDER: usize>(&self) -> Plane<T> {
        const {
            assert!(
                ORDER < N,
                "the motion does not go to the order of derivative that this needs"
            );
        };
        self.as_slice()[ORDER]
    }
}

/// The vector, rotated by a right angle to its left.
pub(crate) fn normal<T: Scalar>(vector: Plane<T>) -> Plane<T> {
    Plane::new(-vector.y, vector.x)
}

pub(crate) fn finite<T: Scalar>(value: T) -> Option<T> {
    value.is_finite().then_some(value)
}

pub(crate) fn finite_vector<T: Scalar>(vector: Plane<T>) -> Option<Plane<T>> {
    (vector.x.is_finite() && vector.y.is_finite()).then_some(vector)
}

#[cfg(test)]
mod tests {
    use crate::geometry::Plane;
    use crate::motion::Motion;
    use crate::number::Number;

    const EPSILON: f64 = f64::EPSILON;

    /// A point on the rim of a wheel that rolls to the right on the x axis: a cycloid.
    fn cycloid<const N: usize>(radius: f64, roll: Motion<f64, N>) -> Motion<Plane, N> {
        let (sine, cosine) = roll.sin_cos();
        let one = Motion::constant(1.0);
        Motion::from_coordinates((roll - sine).scale(radius), (one - cosine).scale(radius))
    }

    /// The change of the curvature per relative rounding of velocity and acceleration.
    fn sensitivity<const N: usize>(point: Motion<Plane, N>) -> f64 {
        let square = point.rate::<1>().norm_squared();
        Number::sqrt(point.rate::<2>().norm_squared()) / square
    }

    /// The change of the curvature rate per relative rounding of velocity, acceleration and jerk.
    fn rate_sensitivity<const N: usize>(point: Motion<Plane, N>) -> f64 {
        let [square, acceleration, jerk] =
            [point.rate::<1>(), point.rate::<2>(), point.rate::<3>()].map(Plane::norm_squared);
        Number::sqrt(jerk) / (square * Number::sqrt(square)) + 3.0 * acceleration / (square * square)
    }

    #[test]
    fn a_cycloid_bends_as_known() {
        // The radius of curvature is 4 R sin(φ/2); with the arc length s from the apex, ρ² + s² = (4 R)².
        let radius = 0.3;
        for degrees in [5.0_f64, 60.0, 130.0, 180.0, 250.0, 350.0] {
            let roll = Motion::from([degrees.to_radians(), 2.0, -7.0, 5.0]);
            let point = cycloid(radius, roll);
            let (half_sine, half_cosine) = Number::sin_cos(roll.value() / 2.0);
            // The velocity loses digits towards the cusp, as 1 - cos φ does.
            let lost = 1.0 / (half_sine * half_sine);
            let curvature = -1.0 / (4.0 * radius * half_sine);
            let error = (point.curvature().unwrap() - curvature).abs();
            assert!(error <= 4.0 * EPSILON * lost * sensitivity(point), "{degrees}: {error}");

            // κ = -1/ρ and dρ/ds = -s/ρ
            let arc = -4.0 * radius * half_cosine;
            let rate = arc * curvature.powi(3);
            let error = (point.curvature_rate().unwrap() - rate).abs();
            assert!(
                error <= 8.0 * EPSILON * lost * rate_sensitivity(point),
                "{degrees}: {error}"
            );
        }
    }

    #[test]
    fn a_cusp_has_no_direction() {
        let cusp = cycloid(0.3, Motion::from([0.0, 2.0, 1.0, 1.0]));
        assert_eq!(cusp.speed(), None);
        assert_eq!(cusp.tangent(), None);
        assert_eq!(cusp.curvature(), None);
        assert_eq!(cusp.radius_of_curvature(), None);
        assert_eq!(cusp.centre_of_curvature(), None);
        assert_eq!(cusp.curvature_rate(), None);
    }

    #[test]
    fn what_is_not_finite_has_no_curvature() {
        let origin = Plane::new(0.0, 0.0);
        let fast = Motion::from([origin, Plane::new(1e200, 0.0), origin]);
        assert_eq!(fast.speed(), None);
        let unknown = Motion::from([origin, Plane::new(1.0, 0.0), Plane::new(0.0, f64::NAN)]);
        assert_eq!(unknown.speed(), Some(1.0));
        assert_eq!(unknown.curvature(), None);
    }

    #[test]
    fn a_straight_path_has_a_curvature_and_no_centre() {
        let line = Motion::from([Plane::new(1.0, 2.0), Plane::new(3.0, 4.0), Plane::new(6.0, 8.0)]);
        assert_eq!(line.curvature(), Some(0.0));
        assert_eq!(line.radius_of_curvature(), None);
        assert_eq!(line.centre_of_curvature(), None);
    }

    #[test]
    fn an_ellipse_does_not_depend_on_how_it_is_run_through() {
        let (a, b) = (3.0_f64, 2.0_f64);
        for speed in [-40.0, -1.0, 0.01, 2.5] {
            let angle = Motion::from([0.8, speed, 11.0 * speed * speed, -7.0 * speed * speed * speed]);
            let (sine, cosine) = angle.sin_cos();
            let point = Motion::from_coordinates(cosine.scale(a), sine.scale(b));
            let (s, c) = (sine.value(), cosine.value());
            let square = (a * s).powi(2) + (b * c).powi(2);
            let sense = speed.signum();
            let curvature = sense * a * b / (square * Number::sqrt(square));
            let error = (point.curvature().unwrap() - curvature).abs();
            assert!(error <= 4.0 * EPSILON * sensitivity(point), "{speed}: {error}");
            // dκ/ds = dκ/dφ / |dr/dφ|, and the sense of travel counts twice.
            let rate = -3.0 * a * b * (a * a - b * b) * s * c / square.powi(3);
            let error = (point.curvature_rate().unwrap() - rate).abs();
            assert!(error <= 8.0 * EPSILON * rate_sensitivity(point), "{speed}: {error}");
            // The evolute is ((a² - b²)/a cos³, (b² - a²)/b sin³).
            let centre = point.centre_of_curvature().unwrap();
            let evolute = Plane::new((a * a - b * b) / a * c.powi(3), (b * b - a * a) / b * s.powi(3));
            let allowed = 8.0 * EPSILON * (a + sensitivity(point) / curvature.powi(2));
            assert!((centre - evolute).norm_squared() <= allowed * allowed, "{speed}");
        }
    }
}
