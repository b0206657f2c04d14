//! The class III triad, which cannot be divided into dyads.

crate::mechanism! {
    /// Class III triad, the smallest of Assur's groups that cannot be divided into dyads: a ternary link on three legs.
    /// The lengths of the legs are the inputs, so it is also the plane platform on three cylinders.
    ///
    /// The legs start at the origin, at `base_b` and at `base_c`, and end at the corners of the platform, which turns
    /// by `phi`. Three lengths allow up to six positions (K. H. Hunt, "Structural kinematics of in-parallel-actuated
    /// robot-arms", Journal of Mechanisms, Transmissions, and Automation in Design 105, 1983). They have no closed
    /// form: Newton's method finds the position from nearby values.
    ///
    /// If base and platform are equilateral, with corners at the distances R and ρ from their centres, and all legs
    /// have the length l, the platform can turn about the common centre: l² = R² + ρ² - 2 R ρ cos phi.
    ///
    /// ```
    /// use kin_core::library::ClassThreeTriad;
    /// use kin_core::prelude::*;
    ///
    /// let root = 3.0_f64.sqrt();
    /// let triad = ClassThreeTriad {
    ///     base_b: Plane::new(2.0 * root, 0.0), base_c: Plane::new(root, 3.0),
    ///     platform_b: Plane::new(root, 0.0), platform_c: Plane::new(root / 2.0, 1.5),
    /// };
    /// // R = 2, ρ = 1: the platform has turned by a right angle when the legs are as long as the square root of 5
    /// let leg = Motion::from((5.0_f64.sqrt(), 0.1, 0.0, 0.0, 0.0));
    /// let pose = triad.solve(leg, leg, leg, Near([0.1, 2.2, -2.0, 1.6]))?;
    /// assert!((pose.phi.position() - core::f64::consts::FRAC_PI_2).abs() < 1e-14);
    /// // l l' = R ρ sin(phi) phi'
    /// assert!((pose.phi.velocity() - 5.0_f64.sqrt() * 0.1 / 2.0).abs() < 1e-14);
    /// let centre = pose.centre.position();
    /// assert!((centre.x - root).abs() < 1e-14 && (centre.y - 1.0).abs() < 1e-14);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct ClassThreeTriad {
        /// The start of the second leg.
        pub base_b: Point,
        /// The start of the third leg.
        pub base_c: Point,
        /// The vector from the platform's joint with the first leg to its joint with the second, in the platform's
        /// frame.
        pub platform_b: Vector,
        /// The vector from the platform's joint with the first leg to its joint with the third, in the platform's
        /// frame.
        pub platform_c: Vector,
    }
    input
        /// The first leg.
        a: Length,
        /// The second leg.
        b: Length,
        /// The third leg.
        c: Length;
    unknown
        /// The first leg's angle.
        alpha: Angle,
        /// The second leg's angle.
        beta: Angle,
        /// The third leg's angle.
        gamma: Angle,
        /// The platform's angle.
        phi: Angle;

    a * cis(alpha) + platform_b * cis(phi) == base_b + b * cis(beta);
    a * cis(alpha) + platform_c * cis(phi) == base_c + c * cis(gamma);

    /// The centroid of the platform's three joints.
    output centre: Point = a * cis(alpha) + (platform_b + platform_c) / 3 * cis(phi);
}
