//! Five-bar linkages, with two driven cranks or with geared cranks.

crate::mechanism! {
    /// Five-bar linkage with two driven cranks, a plane robot arm with both motors on the ground.
    ///
    /// The left crank turns about the origin, the right crank about (`ground`, 0). In the open assembly the hand is
    /// above.
    ///
    /// ```
    /// use core::f64::consts::PI;
    /// use kin_core::library::FiveBar;
    /// use kin_core::prelude::*;
    ///
    /// let robot = FiveBar { ground: 2.0, left: 1.5, left_rod: 2.0, right_rod: 2.0, right: 1.5 };
    /// // mirror-symmetric cranks move the hand straight up, and both rods are the sides of an isosceles triangle
    /// let left = Motion::from((2.0, 0.4, 0.3, -0.2, 0.1));
    /// let right = Motion::constant(PI) - left;
    /// let hand = robot.solve(left, right, Assembly::Open)?.hand;
    /// let across: f64 = 1.0 - 1.5 * 2.0_f64.cos();
    /// assert!((hand.y().position() - (1.5 * 2.0_f64.sin() + (4.0 - across * across).sqrt())).abs() < 1e-14);
    /// assert!(hand.x().derivatives().into_iter().skip(1).all(|rate| rate.abs() < 1e-13));
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct FiveBar {
        /// Ground link, from the left crank's pivot to the right one's.
        pub ground: Length,
        /// Left crank.
        pub left: Length,
        /// Rod from the left crank to the hand.
        pub left_rod: Length,
        /// Rod from the right crank to the hand.
        pub right_rod: Length,
        /// Right crank.
        pub right: Length,
    }
    input
        /// The left crank's angle.
        alpha: Angle,
        /// The right crank's angle.
        beta: Angle;
    unknown
        /// The left rod's angle.
        phi: Angle,
        /// The right rod's angle.
        psi: Angle;

    left * cis(alpha) + left_rod * cis(phi) == ground + right * cis(beta) + right_rod * cis(psi);

    /// The joint of the two rods.
    output hand: Point = left * cis(alpha) + left_rod * cis(phi);
}

crate::mechanism! {
    /// Geared five-bar linkage: the second crank rotates `ratio` times as fast as the first, and leads by `phase`.
    ///
    /// Cranks 2 and 5 turn about the origin and about (`r1`, 0). Gears in mesh turn in opposite directions, so `ratio`
    /// is negative; with an idler or a belt it is positive.
    ///
    /// - With `ratio` -1, `phase` π and equal cranks and rods, the mechanism is always symmetric, and the tool moves
    ///   along an exact straight line: Cartwright's straight-line mechanism of about 1800.
    /// - With `ratio` 1, `phase` 0 and equal cranks, the distance between the ends of the rods always equals the
    ///   distance between the pivots, so the rods do not turn at all.
    ///
    /// ```
    /// use core::f64::consts::PI;
    /// use kin_core::library::GearedFiveBar;
    /// use kin_core::prelude::*;
    ///
    /// let engine = GearedFiveBar { r1: 2.0, r2: 0.5, r3: 2.5, r4: 2.5, r5: 0.5, ratio: -1.0, phase: PI };
    /// let crank = Motion::from((0.8_f64, 3.0, 1.0, -2.0, 0.5));
    /// let tool = engine.solve(crank, Assembly::Open)?.tool;
    /// assert!((tool.x().position() - 1.0).abs() < 1e-14);
    /// assert!(tool.x().derivatives().into_iter().skip(1).all(|rate| rate.abs() < 1e-12));
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct GearedFiveBar {
        /// Ground link, from the first crank's pivot to the second one's.
        pub r1: Length,
        /// First crank.
        pub r2: Length,
        /// Rod on the first crank.
        pub r3: Length,
        /// Rod on the second crank.
        pub r4: Length,
        /// Second crank.
        pub r5: Length,
        /// Revolutions of the second crank for each revolution of the first.
        pub ratio: Scalar,
        /// The second crank's angle when the first crank's angle is zero.
        pub phase: Angle,
    }
    input
        /// The first crank's angle.
        theta2: Angle;
    unknown
        /// The angle of the rod on the first crank.
        theta3: Angle,
        /// The angle of the rod on the second crank.
        theta4: Angle,
        /// The second crank's angle.
        theta5: Angle;

    theta5 == ratio * theta2 + phase;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r5 * cis(theta5) + r4 * cis(theta4);

    /// The joint of the two rods.
    output tool: Point = r2 * cis(theta2) + r3 * cis(theta3);
}
