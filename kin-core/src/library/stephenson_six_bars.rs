//! Stephenson's six-bar linkages, with two ternary links that share no joint.
//!
//! Three chains connect the two ternary links. Two of them are one binary link long, and form a four-bar loop; the
//! third is two links long. In the first kind the ground link is one of the two single links, in the second kind it
//! belongs to the pair, and in the third kind it is a ternary link. Source of the kinds and their names: A. G. Erdman
//! and G. N. Sandor, Mechanism Design: Analysis and Synthesis, volume 1, Prentice-Hall 1984.

crate::mechanism! {
    /// Stephenson's six-bar linkage of the first kind, driven at the crank: a four-bar linkage with a dyad between its
    /// crank and its rocker.
    ///
    /// The crank 2 and the rocker 4 are the ternary links. The crank turns about the origin, the rocker about
    /// (`r1`, 0). Link 5 starts from the crank's point `p`, link 6 from the rocker's point `q`; they meet in `tool`.
    ///
    /// On a parallelogram with equal points on crank and rocker, the dyad moves without turning, like parallel rulers:
    ///
    /// ```
    /// use kin_core::library::{StephensonI, StephensonIAssembly};
    /// use kin_core::prelude::*;
    ///
    /// let arm = Plane::new(-0.6, 0.8);
    /// let ruler = StephensonI { r1: 3.0, r2: 1.0, r3: 3.0, r4: 1.0, p: arm, q: arm, r5: 2.0, r6: 2.5 };
    /// let crank = Motion::from((1.0_f64, 2.0, 0.5, -0.2, 0.1));
    /// let assembly = StephensonIAssembly { theta3_theta4: Assembly::Open, theta5_theta6: Assembly::Open };
    /// let pose = ruler.solve(crank, assembly)?;
    /// for (link5, link6) in pose.theta5.derivatives().into_iter().zip(pose.theta6.derivatives()).skip(1) {
    ///     assert!(link5.abs() < 1e-12 && link6.abs() < 1e-12);
    /// }
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct StephensonI {
        /// Ground link, from the crank's pivot to the rocker's.
        pub r1: Length,
        /// The crank's side from its pivot to the coupler.
        pub r2: Length,
        /// Coupler.
        pub r3: Length,
        /// The rocker's side from its pivot to the coupler.
        pub r4: Length,
        /// The crank's joint with link 5, in the crank's frame: from its pivot, x along `r2`.
        pub p: Vector,
        /// The rocker's joint with link 6, in the rocker's frame: from its pivot, x along `r4`.
        pub q: Vector,
        /// Link 5, from the crank.
        pub r5: Length,
        /// Link 6, from the rocker.
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
    p * cis(theta2) + r5 * cis(theta5) == r1 + q * cis(theta4) + r6 * cis(theta6);

    /// The joint of links 5 and 6.
    output tool: Point = p * cis(theta2) + r5 * cis(theta5);
}

crate::mechanism! {
    /// Stephenson's six-bar linkage of the second kind, driven at the joint between links 2 and 3.
    ///
    /// The ternary links are link 2, which turns about the origin, and link 4, which floats. Links 3 and 5 connect
    /// them, so 2, 3, 4 and 5 form a four-bar linkage that turns as a whole. Link 6 holds the point `q` of link 4 and
    /// turns about (`r1`, 0). The drive lies inside the four-bar linkage, so its loop is closed first, in the frame of
    /// link 2: `psi`, `alpha` and `beta` are angles in that frame. The second loop then gives the angle of link 2.
    ///
    /// If the four-bar linkage is a parallelogram, link 4 stays parallel to link 2, and the angle of link 2 follows
    /// from the sides of one triangle:
    ///
    /// ```
    /// use kin_core::library::{StephensonIIByElbow, StephensonIIByElbowAssembly};
    /// use kin_core::prelude::*;
    ///
    /// let linkage = StephensonIIByElbow {
    ///     r1: 4.0, r2: 2.0, r3: 1.5, r4: 1.0, p: Plane::new(3.0, 0.0), q: Plane::new(1.0, 0.0), r5: 1.5, r6: 3.0,
    /// };
    /// let drive = Motion::from((1.2_f64, 1.0, 0.0, 0.0, 0.0));
    /// let assembly = StephensonIIByElbowAssembly { alpha_beta: Assembly::Open, theta2_theta6: Assembly::Open };
    /// let pose = linkage.solve(drive, assembly)?;
    /// assert!(pose.alpha.derivatives().into_iter().all(|rate| rate.abs() < 1e-12));
    /// // the distance of the joint with link 6 from the origin, by the cosine rule in both triangles over it
    /// let square = 9.0 + 2.25 + 2.0 * 3.0 * 1.5 * 1.2_f64.cos();
    /// let joint = pose.tool.position();
    /// assert!((joint.norm_squared() - square).abs() < 1e-13);
    /// assert!((square + 16.0 - 2.0 * 4.0 * joint.x - 9.0).abs() < 1e-13);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct StephensonIIByElbow {
        /// Ground link, from the pivot of link 2 to the pivot of link 6.
        pub r1: Length,
        /// Link 2 from its pivot to link 3.
        pub r2: Length,
        /// Link 3.
        pub r3: Length,
        /// Link 4 from link 3 to link 5.
        pub r4: Length,
        /// The joint of link 2 with link 5, in the frame of link 2: from its pivot, x along `r2`.
        pub p: Vector,
        /// The joint of link 4 with link 6, in the frame of link 4: from its joint with link 3, x along `r4`.
        pub q: Vector,
        /// Link 5.
        pub r5: Length,
        /// Link 6.
        pub r6: Length,
    }
    input
        /// The angle of link 3 from link 2.
        psi: Angle;
    unknown
        /// The angle of link 4 from link 2.
        alpha: Angle,
        /// The angle of link 5 from link 2.
        beta: Angle,
        /// The angle of link 2.
        theta2: Angle,
        /// The angle of link 6.
        theta6: Angle;

    // This equation is in the frame of link 2.
    r2 + r3 * cis(psi) + r4 * cis(alpha) == p + r5 * cis(beta);

    let joint = r2 + r3 * cis(psi) + q * cis(alpha);
    joint * cis(theta2) == r1 + r6 * cis(theta6);

    /// The joint of links 4 and 6.
    output tool: Point = r1 + r6 * cis(theta6);

    // the first equation is not in the frame of the ground
    let elbow = (r2 + r3 * cis(psi)) * cis(theta2);
    let wrist = (p + r5 * cis(beta)) * cis(theta2);
    ground 0, vec2(r1, 0);
    body r2: 0, r2 * cis(theta2), p * cis(theta2);
    body r3: r2 * cis(theta2), elbow;
    body r4: elbow, wrist, tool;
    body r5: p * cis(theta2), wrist;
    body r6: vec2(r1, 0), tool;
}

crate::mechanism! {
    /// Stephenson's six-bar linkage of the third kind, driven at the crank: a four-bar linkage with a dyad from a point
    /// of its coupler to the ground.
    ///
    /// The coupler 3 and the ground link are the ternary links. The crank 2 turns about the origin, the rocker 4 about
    /// (`r1`, 0), and link 6 about `pivot`. Link 5 connects it to the coupler's point `p`.
    ///
    /// As long as that point moves along a circle with the radius `r5`, and link 6 ends at its centre, link 6 stands
    /// still (R. L. Norton, Design of Machinery, McGraw-Hill, chapter 3, "Dwell mechanisms"). On a parallelogram every
    /// coupler point moves on such a circle for the whole revolution:
    ///
    /// ```
    /// use kin_core::library::{StephensonIII, StephensonIIIAssembly};
    /// use kin_core::prelude::*;
    ///
    /// let linkage = StephensonIII {
    ///     r1: 4.0, r2: 1.5, r3: 4.0, r4: 1.5, p: Plane::new(2.0, 1.0), r5: 1.5, pivot: Plane::new(5.0, 5.0), r6: 5.0,
    /// };
    /// let crank = Motion::from((2.5_f64, 2.0, 0.5, -0.2, 0.1));
    /// let assembly = StephensonIIIAssembly { theta3_theta4: Assembly::Open, theta5_theta6: Assembly::Crossed };
    /// let link6 = linkage.solve(crank, assembly)?.theta6;
    /// // from the pivot (5, 5) to the centre (2, 1)
    /// assert!((link6.position() - (-4.0_f64).atan2(-3.0)).abs() < 1e-14);
    /// assert!(link6.derivatives().into_iter().skip(1).all(|rate| rate.abs() < 1e-12));
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct StephensonIII {
        /// The ground link's side from the crank's pivot to the rocker's.
        pub r1: Length,
        /// Crank.
        pub r2: Length,
        /// The coupler's side from the crank to the rocker.
        pub r3: Length,
        /// Rocker.
        pub r4: Length,
        /// The coupler's joint with link 5, in the coupler's frame: from its joint with the crank, x along `r3`.
        pub p: Vector,
        /// Link 5, from the coupler.
        pub r5: Length,
        /// The pivot of link 6.
        pub pivot: Point,
        /// Link 6.
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
    r2 * cis(theta2) + p * cis(theta3) + r5 * cis(theta5) == pivot + r6 * cis(theta6);

    /// The joint of the coupler with link 5.
    output coupler_point: Point = r2 * cis(theta2) + p * cis(theta3);
}

crate::mechanism! {
    /// Stephenson's six-bar linkage of the first kind, driven at link 5 of its dyad.
    ///
    /// It is the same linkage as [`StephensonI`], but the angle of link 5 is given and the crank's angle is unknown.
    /// Neither loop can be closed by itself, so Newton's method finds the position from nearby values.
    ///
    /// ```
    /// use kin_core::library::{StephensonI, StephensonIByDyad};
    /// use kin_core::prelude::*;
    ///
    /// let (p, q) = (Plane::new(0.5, 1.0), Plane::new(1.5, 1.0));
    /// let by_crank = StephensonI { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, q, r5: 2.5, r6: 2.0 };
    /// let by_dyad = StephensonIByDyad { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, q, r5: 2.5, r6: 2.0 };
    ///
    /// let crank = Motion::from((1.0_f64, 2.0, 0.5, -0.2, 0.1));
    /// let pose = by_crank.solve(crank, StephensonI::ASSEMBLIES[0])?;
    /// let near = [pose.theta2, pose.theta3, pose.theta4, pose.theta6].map(|angle| angle.position() + 0.02);
    /// let back = by_dyad.solve(pose.theta5, Near(near))?;
    /// assert!((back.theta2.position() - 1.0).abs() < 1e-13);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct StephensonIByDyad {
        /// Ground link, from the crank's pivot to the rocker's.
        pub r1: Length,
        /// The crank's side from its pivot to the coupler.
        pub r2: Length,
        /// Coupler.
        pub r3: Length,
        /// The rocker's side from its pivot to the coupler.
        pub r4: Length,
        /// The crank's joint with link 5, in the crank's frame: from its pivot, x along `r2`.
        pub p: Vector,
        /// The rocker's joint with link 6, in the rocker's frame: from its pivot, x along `r4`.
        pub q: Vector,
        /// Link 5, from the crank.
        pub r5: Length,
        /// Link 6, from the rocker.
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
    p * cis(theta2) + r5 * cis(theta5) == r1 + q * cis(theta4) + r6 * cis(theta6);

    /// The joint of links 5 and 6.
    output tool: Point = p * cis(theta2) + r5 * cis(theta5);
}

crate::mechanism! {
    /// Stephenson's six-bar linkage of the second kind, driven at the crank.
    ///
    /// It is the same linkage as [`StephensonIIByElbow`], with all angles measured from the ground link. Without the
    /// crank 2, the rest is a class III triad, so Newton's method finds the position from nearby values.
    ///
    /// ```
    /// use kin_core::library::{StephensonII, StephensonIIByElbow};
    /// use kin_core::prelude::*;
    ///
    /// let (p, q) = (Plane::new(3.0, 0.3), Plane::new(1.0, 0.5));
    /// let by_elbow = StephensonIIByElbow { r1: 4.0, r2: 2.0, r3: 1.5, r4: 1.2, p, q, r5: 1.6, r6: 3.0 };
    /// let by_crank = StephensonII { r1: 4.0, r2: 2.0, r3: 1.5, r4: 1.2, p, q, r5: 1.6, r6: 3.0 };
    ///
    /// let elbow = Motion::from((1.2_f64, 2.0, 0.5, -0.2, 0.1));
    /// let pose = by_elbow.solve(elbow, StephensonIIByElbow::ASSEMBLIES[0])?;
    /// let [link3, link4, link5] = [elbow, pose.alpha, pose.beta].map(|relative| pose.theta2 + relative);
    /// let near = [link3, link4, link5, pose.theta6].map(|angle| angle.position() + 0.02);
    /// let back = by_crank.solve(pose.theta2, Near(near))?;
    /// assert!((back.theta3.position() - pose.theta2.position() - 1.2).abs() < 1e-13);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct StephensonII {
        /// Ground link, from the crank's pivot to the pivot of link 6.
        pub r1: Length,
        /// The crank's side from its pivot to link 3.
        pub r2: Length,
        /// Link 3.
        pub r3: Length,
        /// Link 4 from link 3 to link 5.
        pub r4: Length,
        /// The crank's joint with link 5, in the crank's frame: from its pivot, x along `r2`.
        pub p: Vector,
        /// The joint of link 4 with link 6, in the frame of link 4: from its joint with link 3, x along `r4`.
        pub q: Vector,
        /// Link 5.
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
        /// The angle of link 4.
        theta4: Angle,
        /// The angle of link 5.
        theta5: Angle,
        /// The angle of link 6.
        theta6: Angle;

    let joint3 = r2 * cis(theta2) + r3 * cis(theta3);
    joint3 + r4 * cis(theta4) == p * cis(theta2) + r5 * cis(theta5);
    joint3 + q * cis(theta4) == r1 + r6 * cis(theta6);

    /// The joint of links 4 and 6.
    output tool: Point = r1 + r6 * cis(theta6);
}

crate::mechanism! {
    /// Stephenson's six-bar linkage of the third kind, driven at link 6, the far end of its dyad.
    ///
    /// It is the same linkage as [`StephensonIII`], but the angle of link 6 is given and the crank's angle is unknown.
    /// Without link 6, the rest is a class III triad, so Newton's method finds the position from nearby values.
    ///
    /// ```
    /// use kin_core::library::{StephensonIII, StephensonIIIByDyad};
    /// use kin_core::prelude::*;
    ///
    /// let (p, pivot) = (Plane::new(1.5, 1.0), Plane::new(5.0, 3.0));
    /// let by_crank = StephensonIII { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, r5: 3.0, pivot, r6: 2.5 };
    /// let by_dyad = StephensonIIIByDyad { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, r5: 3.0, pivot, r6: 2.5 };
    ///
    /// let crank = Motion::from((2.5_f64, 2.0, 0.5, -0.2, 0.1));
    /// let pose = by_crank.solve(crank, StephensonIII::ASSEMBLIES[0])?;
    /// let near = [pose.theta2, pose.theta3, pose.theta4, pose.theta5].map(|angle| angle.position() + 0.02);
    /// let back = by_dyad.solve(pose.theta6, Near(near))?;
    /// assert!((back.theta2.position() - 2.5).abs() < 1e-13);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct StephensonIIIByDyad {
        /// The ground link's side from the crank's pivot to the rocker's.
        pub r1: Length,
        /// Crank.
        pub r2: Length,
        /// The coupler's side from the crank to the rocker.
        pub r3: Length,
        /// Rocker.
        pub r4: Length,
        /// The coupler's joint with link 5, in the coupler's frame: from its joint with the crank, x along `r3`.
        pub p: Vector,
        /// Link 5, from the coupler.
        pub r5: Length,
        /// The pivot of link 6.
        pub pivot: Point,
        /// Link 6.
        pub r6: Length,
    }
    input
        /// The angle of link 6.
        theta6: Angle;
    unknown
        /// The crank's angle.
        theta2: Angle,
        /// The coupler's angle.
        theta3: Angle,
        /// The rocker's angle.
        theta4: Angle,
        /// The angle of link 5.
        theta5: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    r2 * cis(theta2) + p * cis(theta3) + r5 * cis(theta5) == pivot + r6 * cis(theta6);

    /// The joint of the coupler with link 5.
    output coupler_point: Point = r2 * cis(theta2) + p * cis(theta3);
}
