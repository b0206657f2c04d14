//! The universal joint of Cardan and Hooke.

crate::mechanism! {
    /// Universal joint: two shafts whose axes meet, and a cross that connects their yokes.
    ///
    /// The driving shaft lies along z; the driven shaft is inclined by `beta` about the x axis. At angle 0 the driving
    /// yoke holds the arm of the cross along y, and the driven yoke holds the arm along x, so tan(driven) =
    /// tan(driving) / cos(beta).
    ///
    /// The only equation says that the arms of the cross are at right angles. In the open assembly both angles are
    /// equal wherever they are multiples of 90 degrees. In the crossed assembly the driven yoke is mounted half a
    /// revolution further.
    ///
    /// ```
    /// use kin_core::library::UniversalJoint;
    /// use kin_core::prelude::*;
    ///
    /// let joint = UniversalJoint { beta: 60_f64.to_radians() };
    /// // the driven shaft at its fastest, 1 / cos(beta) times the speed, and at its slowest
    /// let fast = joint.solve(Motion::at_constant_speed(0.0, 10.0), Assembly::Open)?;
    /// assert!((fast.driven.velocity() - 20.0).abs() < 1e-13);
    /// let slow = joint.solve(Motion::at_constant_speed(90_f64.to_radians(), 10.0), Assembly::Open)?;
    /// assert!((slow.driven.velocity() - 5.0).abs() < 1e-14);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct UniversalJoint {
        /// The angle between the shafts.
        pub beta: Angle,
    }
    input
        /// The driving shaft's angle.
        driving: Angle;
    unknown
        /// The driven shaft's angle.
        driven: Angle;

    let driving_arm = rot_z(driving) * vec3(0, 1, 0);
    let driven_arm = rot_x(beta) * rot_z(driven) * vec3(1, 0, 0);
    dot(driving_arm, driven_arm) == 0;

    // two bearings on each shaft, at multiples of the arms' length
    let inner = vec3(0, 0, -2);
    let outer = vec3(0, 0, -3);
    let driven_inner = rot_x(beta) * -inner;
    let driven_outer = rot_x(beta) * -outer;
    ground inner, outer, driven_inner, driven_outer;
    body driving: outer, inner, driving_arm, -driving_arm;
    body cross: driving_arm, -driving_arm, driven_arm, -driven_arm;
    body driven: driven_outer, driven_inner, driven_arm, -driven_arm;
}
