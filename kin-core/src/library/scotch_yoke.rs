//! The Scotch yoke.

crate::mechanism! {
    /// Scotch yoke: the crank's pin slides in the straight slot of a yoke that moves along the x axis.
    ///
    /// With an upright slot, `gamma` = π/2, the motion of the yoke is exactly harmonic: at constant speed ω its snap is
    /// ω⁴ times its distance from the middle. A slot inclined by `gamma` from the x axis gives x = crank · sin(gamma -
    /// theta) / sin(gamma), which is also harmonic, but larger and shifted.
    ///
    /// ```
    /// use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, SQRT_2};
    /// use kin_core::library::ScotchYoke;
    /// use kin_core::prelude::*;
    ///
    /// let crank = Motion::at_constant_speed(0.7_f64, 3.0);
    /// let yoke = ScotchYoke { crank: 2.0, gamma: FRAC_PI_2 }.solve(crank)?.x;
    /// assert!((yoke.acceleration() + 9.0 * yoke.position()).abs() < 1e-14);
    /// assert!((yoke.snap() - 81.0 * yoke.position()).abs() < 1e-13);
    ///
    /// let inclined = ScotchYoke { crank: 2.0, gamma: FRAC_PI_4 }.solve(crank)?.x;
    /// assert!((inclined.position() - 2.0 * SQRT_2 * (FRAC_PI_4 - 0.7).sin()).abs() < 1e-14);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct ScotchYoke {
        /// Crank.
        pub crank: Length,
        /// The slot's direction, measured from the direction in which the yoke moves.
        pub gamma: Angle,
    }
    input
        /// The crank's angle.
        theta: Angle;
    unknown
        /// The yoke's position, which is the point where its slot crosses the x axis.
        x: Length,
        /// The pin's position in the slot, measured from the x axis.
        slide: Length;

    crank * cis(theta) == x + slide * cis(gamma);
}
