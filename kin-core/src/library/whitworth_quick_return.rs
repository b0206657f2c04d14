//! Whitworth's quick-return mechanism.

crate::mechanism! {
    /// Whitworth's quick-return mechanism: the crank's pin slides in a lever that makes full turns and drives a ram.
    ///
    /// The lever turns about the origin, which lies inside the circle of the crank about (0, `ground`). The ram moves
    /// along the x axis. It reverses when the crank's pin is level with the lever's pivot. At constant speed, the times
    /// of the two strokes are therefore in the ratio (π + 2 δ) : (π - 2 δ) with sin δ = ground / crank, for any arm and
    /// rod (R. L. Norton, Design of Machinery, McGraw-Hill, chapter 3, "Quick-return mechanisms").
    ///
    /// ```
    /// use core::f64::consts::PI;
    /// use kin_core::library::WhitworthQuickReturn;
    /// use kin_core::prelude::*;
    ///
    /// // δ = 30 degrees: the slow stroke takes twice as long as the fast one
    /// let press = WhitworthQuickReturn { ground: 0.05, crank: 0.1, arm: 0.15, rod: 0.5 };
    /// let at = |crank: f64| press.solve(Motion::at_constant_speed(crank, 1.0), Assembly::Open);
    /// for reversal in [-PI / 6.0, 7.0 * PI / 6.0] {
    ///     assert!(at(reversal)?.ram.velocity().abs() < 1e-16);
    /// }
    /// // 240 degrees one way, 120 the other
    /// assert!(at(PI / 2.0)?.ram.velocity() < 0.0 && at(3.0 * PI / 2.0)?.ram.velocity() > 0.0);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct WhitworthQuickReturn {
        /// Distance between the two pivots; the lever makes full revolutions if it is less than `crank`.
        pub ground: Length,
        /// Crank.
        pub crank: Length,
        /// The lever's arm on the ram's side.
        pub arm: Length,
        /// Connecting rod.
        pub rod: Length,
    }
    input
        /// The crank's angle.
        theta: Angle;
    unknown
        /// The distance of the crank's pin from the lever's pivot.
        slide: Length where slide > 0,
        /// The lever's angle.
        phi: Angle,
        /// The connecting rod's angle.
        psi: Angle,
        /// The ram's position.
        ram: Length;

    vec2(0, ground) + crank * cis(theta) == slide * cis(phi);
    arm * cis(phi) + rod * cis(psi) == vec2(ram, 0);
}
