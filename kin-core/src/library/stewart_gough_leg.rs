//! One leg of a Stewart-Gough platform.

crate::mechanism! {
    /// A leg of a Stewart-Gough platform: the length of the leg for a pose of the platform. One such leg after another
    /// gives the inverse kinematics of the platform.
    ///
    /// The platform's origin is at (`x`, `y`, `z`). The platform turns by `roll` about x first, by `pitch` about y next
    /// and by `yaw` about z last, all about fixed axes. The leg runs from `base`, in the fixed frame, to `joint`, in
    /// the platform's frame. Six legs form the platform of V. E. Gough (1947) and D. Stewart ("A platform with six
    /// degrees of freedom", Proceedings of the Institution of Mechanical Engineers 180, 1965).
    ///
    /// ```
    /// use kin_core::library::StewartGoughLeg;
    /// use kin_core::prelude::*;
    ///
    /// let leg = StewartGoughLeg { base: Space::new(1.0, 0.0, 0.0), joint: Space::new(1.0, 0.0, 0.0) };
    /// let still = Motion::constant(0.0);
    /// let rising = Motion::at_constant_speed(2.0, 0.5);
    /// let pose = leg.solve(still, still, rising, still, still, still)?;
    /// assert_eq!((pose.leg.position(), pose.leg.velocity()), (2.0, 0.5));
    ///
    /// // pitching by 90 degrees takes the joint below the platform's origin
    /// let pitched = Motion::constant(90_f64.to_radians());
    /// let pose = leg.solve(still, still, rising, still, pitched, still)?;
    /// assert!((pose.leg.position() - 2_f64.sqrt()).abs() < 1e-15);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct StewartGoughLeg {
        /// The leg's foot, in the fixed frame.
        pub base: Point3,
        /// The leg's head, in the platform's frame.
        pub joint: Vector3,
    }
    input
        /// The platform's position along x.
        x: Length,
        /// The platform's position along y.
        y: Length,
        /// The platform's position along z.
        z: Length,
        /// The first rotation, about x.
        roll: Angle,
        /// The second rotation, about y.
        pitch: Angle,
        /// The last rotation, about z.
        yaw: Angle;
    unknown
        /// The leg's length.
        leg: Length where leg > 0;

    let top = vec3(x, y, z) + rot_z(yaw) * rot_y(pitch) * rot_x(roll) * joint;
    dot(top - base, top - base) == leg.powi(2);

    /// The leg's head, in the fixed frame.
    output head: Point3 = top;

    ground base;
    body platform: vec3(x, y, z), head;
    body leg: base;
    slide head along top - base on leg;
}
