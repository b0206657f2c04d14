//! Bennett's linkage: four hinges in space that should be rigid, but can move.

crate::mechanism! {
    /// Bennett's linkage: a closed loop of four hinges whose axes are neither parallel nor meet in a point.
    ///
    /// Opposite links are equal. The first and the third have the length `a` and the twist `alpha`, which is the angle
    /// from the axis at their start to the axis at their end. The second and the fourth have the twist `beta` and the
    /// length b = a sin(beta) / sin(alpha); with any other length the loop would be rigid (G. T. Bennett, "A new
    /// mechanism", Engineering 76, 1903). The fourth link is the ground. It lies on the x axis and ends at the origin,
    /// where the first hinge has its axis along z. Each angle is measured about the axis of a hinge, from the link
    /// before it to the link after it. `alpha` and `beta` must differ, and neither may be a multiple of 180 degrees.
    ///
    /// The loop closes in space, so there are six scalar equations for three unknown angles, and three of the equations
    /// follow from the others. The declared equations are: opposite hinges rotate by opposite angles, and the second
    /// hinge rotates the chain of links 2 and 3 to the position of the fourth hinge, seen along the axis. The other
    /// equations then hold too, and so does Bennett's relation tan(theta1 / 2) tan(theta2 / 2) = sin((beta + alpha) /
    /// 2) / sin((beta - alpha) / 2).
    ///
    /// ```
    /// use kin_core::library::Bennett;
    /// use kin_core::prelude::*;
    ///
    /// let (alpha, beta) = (30_f64.to_radians(), 70_f64.to_radians());
    /// let linkage = Bennett { a: 2.0, alpha, beta };
    /// let pose = linkage.solve(Motion::at_constant_speed(1.2, 1.0))?;
    /// let product = (pose.theta1.position() / 2.0).tan() * (pose.theta2.position() / 2.0).tan();
    /// let ratio = ((beta + alpha) / 2.0).sin() / ((beta - alpha) / 2.0).sin();
    /// assert!((product - ratio).abs() < 1e-14);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct Bennett {
        /// Length of the first and third link.
        pub a: Length,
        /// Twist of the first and third link.
        pub alpha: Angle,
        /// Twist of the second link and of the ground.
        pub beta: Angle,
    }
    input
        /// The first hinge's angle, from the ground to the first link.
        theta1: Angle;
    unknown
        /// The second hinge's angle.
        theta2: Angle,
        /// The third hinge's angle.
        theta3: Angle,
        /// The fourth hinge's angle.
        theta4: Angle,
        /// The distance of the fourth hinge from the axis of the second.
        reach: Length where reach > 0;

    let b = a * sin(beta) / sin(alpha);
    // The vectors from the second hinge to the fourth: over links 2 and 3, and over link 1 and the ground.
    let over = vec3(b, 0, 0) + rot_x(beta) * rot_z(theta3) * vec3(a, 0, 0);
    let back = rot_x(-alpha) * (vec3(-a, 0, 0) - rot_z(-theta1) * vec3(b, 0, 0));
    let from = vec2(over.x, over.y);
    let to = vec2(back.x, back.y);

    theta3 == -theta1;
    reach * cis(theta2) == vec2(dot(from, to), cross(from, to)) / norm(from);
    theta4 == -theta2;

    /// The second hinge.
    output second: Point3 = rot_z(theta1) * vec3(a, 0, 0);
    /// The third hinge.
    output third: Point3 = rot_z(theta1) * (vec3(a, 0, 0) + rot_x(alpha) * rot_z(theta2) * vec3(b, 0, 0));

    let fourth = vec3(-b, 0, 0);
    ground 0, fourth;
    body link1: 0, second;
    body link2: second, third;
    body link3: third, fourth;
}
