//! Watt's six-bar linkages, with two ternary links that share a joint.
//!
//! In the first kind the ground link is binary, in the second kind it is one of the ternary links. Source of the kinds
//! and their names: A. G. Erdman and G. N. Sandor, Mechanism Design: Analysis and Synthesis, volume 1, Prentice-Hall
//! 1984.

crate::mechanism! {
    /// Watt's six-bar linkage of the first kind, driven at the crank: a four-bar linkage with a dyad between its crank
    /// and its coupler.
    ///
    /// The crank 2 and the coupler 3 are the ternary links. The crank turns about the origin, the rocker 4 about
    /// (`r1`, 0). Link 5 starts from the crank's point `p`, link 6 from the coupler's point `q`; they meet in `tool`.
    ///
    /// If links 5 and 6 complete a parallelogram with the sides of the two ternary links, and `p` lies on the crank's
    /// line, the linkage is a four-bar linkage with a pantograph: the tool draws the path of the coupler point `q` / k,
    /// magnified k times, with k = p / r2 (A. B. Kempe, How to Draw a Straight Line, Macmillan 1877). This example
    /// doubles the path of [`HoekenLinkage`](super::HoekenLinkage):
    ///
    /// ```
    /// use kin_core::library::{HoekenLinkage, WattI, WattIAssembly};
    /// use kin_core::prelude::*;
    ///
    /// let original = HoekenLinkage::PUBLISHED;
    /// let linkage = WattI {
    ///     r1: 2.0, r2: 1.0, r3: 2.5, r4: 2.5,
    ///     p: Plane::new(2.0, 0.0), q: Plane::new(10.0, 0.0),
    ///     r5: 10.0, r6: 1.0,
    /// };
    /// let crank = Motion::from((2.8, 1.0, 0.5, -0.2, 0.1));
    /// let path = original.solve(crank, Assembly::Open)?.tracer;
    /// // links 5 and 6 stay parallel to the coupler and the crank in one of the dyad's assemblies
    /// let assembly = WattIAssembly { theta3_theta4: Assembly::Open, theta5_theta6: Assembly::Open };
    /// let tool = linkage.solve(crank, assembly)?.tool;
    /// for (whole, half) in tool.derivatives().into_iter().zip(path.derivatives()) {
    ///     assert!((whole.x - 2.0 * half.x).abs() < 1e-12 && (whole.y - 2.0 * half.y).abs() < 1e-12);
    /// }
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct WattI {
        /// Ground link, from the crank's pivot to the rocker's.
        pub r1: Length,
        /// The crank's side from its pivot to the coupler.
        pub r2: Length,
        /// The coupler's side from the crank to the rocker.
        pub r3: Length,
        /// Rocker.
        pub r4: Length,
        /// The crank's joint with link 5, in the crank's frame: from its pivot, x along `r2`.
        pub p: Vector,
        /// The coupler's joint with link 6, in the coupler's frame: from its joint with the crank, x along `r3`.
        pub q: Vector,
        /// Link 5, from the crank.
        pub r5: Length,
        /// Link 6, from the coupler.
        pub r6: Length,
    }
    input
        /// The crank's angle.
        theta2: Angle;
    unknown
        /// The coupler's angle.
        theta3: Angle,
        /// The rocker's angle.
        theta4: Angle,
        /// The angle of link 5.
        theta5: Angle,
        /// The angle of link 6.
        theta6: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    p * cis(theta2) + r5 * cis(theta5) == r2 * cis(theta2) + q * cis(theta3) + r6 * cis(theta6);

    /// The joint of links 5 and 6.
    output tool: Point = p * cis(theta2) + r5 * cis(theta5);
}

crate::mechanism! {
    /// Watt's six-bar linkage of the second kind, driven at the crank: two four-bar linkages in series.
    ///
    /// The ground link and the rocker 4 are the ternary links. The crank 2 turns about the origin, the rocker about
    /// (`r1`, 0), and link 6 about `pivot`. Whichever link is driven, the loop that contains it is closed first.
    ///
    /// The speeds of crank and link 6 are those of two four-bar linkages, one after the other:
    ///
    /// ```
    /// use kin_core::library::{FourBar, WattII};
    /// use kin_core::prelude::*;
    ///
    /// let linkage = WattII {
    ///     r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5,
    ///     arm: Plane::new(2.0, 0.0), pivot: Plane::new(7.0, 0.0),
    ///     r5: 3.0, r6: 2.5,
    /// };
    /// let first = FourBar { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5 };
    /// let second = FourBar { r1: 3.0, r2: 2.0, r3: 3.0, r4: 2.5 };
    ///
    /// let crank = Motion::from((1.0_f64, 2.0, 0.5, -0.2, 0.1));
    /// let rocker = first.solve(crank, Assembly::Open)?.theta4;
    /// let expected = second.solve(rocker, Assembly::Open)?.theta4;
    /// let found = linkage.solve(crank, WattII::ASSEMBLIES[0])?.theta6;
    /// assert!((found.velocity() - expected.velocity()).abs() < 1e-13);
    /// assert!((found.snap() - expected.snap()).abs() < 1e-11);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct WattII {
        /// The ground link's side from the crank's pivot to the rocker's.
        pub r1: Length,
        /// Crank.
        pub r2: Length,
        /// Link 3, from the crank to the rocker.
        pub r3: Length,
        /// The rocker's side from its pivot to link 3.
        pub r4: Length,
        /// The rocker's joint with link 5, in the rocker's frame: from its pivot, x along `r4`.
        pub arm: Vector,
        /// The pivot of link 6.
        pub pivot: Point,
        /// Link 5, from the rocker to link 6.
        pub r5: Length,
        /// Link 6.
        pub r6: Length,
    }
    input
        /// The crank's angle.
        theta2: Angle;
    unknown
        /// The angle of link 3.
        theta3: Angle,
        /// The rocker's angle.
        theta4: Angle,
        /// The angle of link 5.
        theta5: Angle,
        /// The angle of link 6.
        theta6: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    r1 + arm * cis(theta4) + r5 * cis(theta5) == pivot + r6 * cis(theta6);
}

crate::mechanism! {
    /// Watt's six-bar linkage of the first kind, driven at link 5 of its dyad.
    ///
    /// It is the same linkage as [`WattI`], but the angle of link 5 is given and the crank's angle is unknown. Neither
    /// loop can be closed by itself, so Newton's method finds the position from nearby values.
    ///
    /// ```
    /// use kin_core::library::{WattI, WattIByDyad};
    /// use kin_core::prelude::*;
    ///
    /// let (p, q) = (Plane::new(1.5, 0.8), Plane::new(2.0, 1.5));
    /// let by_crank = WattI { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, q, r5: 2.5, r6: 2.0 };
    /// let by_dyad = WattIByDyad { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, q, r5: 2.5, r6: 2.0 };
    ///
    /// let crank = Motion::from((1.0_f64, 2.0, 0.5, -0.2, 0.1));
    /// let pose = by_crank.solve(crank, WattI::ASSEMBLIES[0])?;
    /// let near = [pose.theta2, pose.theta3, pose.theta4, pose.theta6].map(|angle| angle.position() + 0.02);
    /// // the motion of link 5 that the crank's gives is driven in return
    /// let back = by_dyad.solve(pose.theta5, Near(near))?;
    /// assert!((back.theta2.position() - 1.0).abs() < 1e-13);
    /// assert!((back.theta2.snap() - 0.1).abs() < 1e-8);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct WattIByDyad {
        /// Ground link, from the crank's pivot to the rocker's.
        pub r1: Length,
        /// The crank's side from its pivot to the coupler.
        pub r2: Length,
        /// The coupler's side from the crank to the rocker.
        pub r3: Length,
        /// Rocker.
        pub r4: Length,
        /// The crank's joint with link 5, in the crank's frame: from its pivot, x along `r2`.
        pub p: Vector,
        /// The coupler's joint with link 6, in the coupler's frame: from its joint with the crank, x along `r3`.
        pub q: Vector,
        /// Link 5, from the crank.
        pub r5: Length,
        /// Link 6, from the coupler.
        pub r6: Length,
    }
    input
        /// The angle of link 5.
        theta5: Angle;
    unknown
        /// The crank's angle.
        theta2: Angle,
        /// The coupler's angle.
        theta3: Angle,
        /// The rocker's angle.
        theta4: Angle,
        /// The angle of link 6.
        theta6: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    p * cis(theta2) + r5 * cis(theta5) == r2 * cis(theta2) + q * cis(theta3) + r6 * cis(theta6);

    /// The joint of links 5 and 6.
    output tool: Point = p * cis(theta2) + r5 * cis(theta5);
}

crate::mechanism! {
    /// Watt's six-bar linkage of the second kind, driven between its two couplers.
    ///
    /// It is the same linkage as [`WattII`], but the angle from link 3 to link 5 is given. With a drive at any other
    /// joint, or of any single link, one four-bar linkage can be closed by itself. Only a drive that spans both
    /// linkages couples them.
    ///
    /// ```
    /// use kin_core::library::{WattII, WattIIByCouplers};
    /// use kin_core::prelude::*;
    ///
    /// let (arm, pivot) = (Plane::new(2.0, 1.0), Plane::new(7.0, 0.5));
    /// let by_crank = WattII { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, arm, pivot, r5: 3.0, r6: 2.5 };
    /// let by_couplers = WattIIByCouplers { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, arm, pivot, r5: 3.0, r6: 2.5 };
    ///
    /// let crank = Motion::from((1.0_f64, 2.0, 0.5, -0.2, 0.1));
    /// let pose = by_crank.solve(crank, WattII::ASSEMBLIES[0])?;
    /// let drive = pose.theta5 - pose.theta3;
    /// let near = [pose.theta2, pose.theta3, pose.theta4, pose.theta6].map(|angle| angle.position() + 0.02);
    /// let back = by_couplers.solve(drive, Near(near))?;
    /// assert!((back.theta2.position() - 1.0).abs() < 1e-13);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct WattIIByCouplers {
        /// The ground link's side from the crank's pivot to the rocker's.
        pub r1: Length,
        /// Crank.
        pub r2: Length,
        /// Link 3, from the crank to the rocker.
        pub r3: Length,
        /// The rocker's side from its pivot to link 3.
        pub r4: Length,
        /// The rocker's joint with link 5, in the rocker's frame: from its pivot, x along `r4`.
        pub arm: Vector,
        /// The pivot of link 6.
        pub pivot: Point,
        /// Link 5, from the rocker to link 6.
        pub r5: Length,
        /// Link 6.
        pub r6: Length,
    }
    input
        /// The angle from link 3 to link 5.
        drive: Angle;
    unknown
        /// The crank's angle.
        theta2: Angle,
        /// The angle of link 3.
        theta3: Angle,
        /// The rocker's angle.
        theta4: Angle,
        /// The angle of link 6.
        theta6: Angle;

    let theta5 = theta3 + drive;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    r1 + arm * cis(theta4) + r5 * cis(theta5) == pivot + r6 * cis(theta6);
}
