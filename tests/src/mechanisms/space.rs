//! Mechanisms of space, each from joints and links as they stand, without a transformation by hand.

use kin_core::mechanism;

mechanism! {
    /// Two skew shafts, crank and rocker, and a rod between two ball joints.
    pub struct Rssr {
        crank: Length,
        pivot: Point3,
        axis: Vector3,
        arm: Vector3,
        rod: Length,
    }
    input t: Angle;
    unknown x: Angle;

    let rod_vector = pivot + rot(axis, x) * arm - rot_z(t) * vec3(crank, 0, 0);
    dot(rod_vector, rod_vector) == rod.powi(2);

    output ball: Point3 = pivot + rot(axis, x) * arm;
}

mechanism! {
    /// The same linkage by the length of the rod instead of its square.
    pub struct RssrByLength {
        crank: Length,
        pivot: Point3,
        axis: Vector3,
        arm: Vector3,
        rod: Length,
    }
    input t: Angle;
    unknown x: Angle;

    norm(rot_z(t) * vec3(crank, 0, 0) - pivot - rot(axis, x) * arm) == rod;
}

mechanism! {
    /// The same linkage, its equation multiplied by a length, with the ball on the rocker as unknown coordinates that follow
    /// from the angle.
    pub struct RssrWithBall {
        crank: Length,
        pivot: Point3,
        axis: Vector3,
        arm: Vector3,
        rod: Length,
    }
    input t: Angle;
    unknown x: Angle, u: Length, v: Length, w: Length;

    let rod_vector = pivot + rot(axis, x) * arm - rot_z(t) * vec3(crank, 0, 0);
    rod * rod_vector.dot(rod_vector) == rod.powi(3);
    vec3(u, v, w) - pivot == rot(axis, x) * arm;
}

mechanism! {
    /// A crank that drives a slider on a skew line by a rod between two ball joints.
    pub struct Rssp {
        crank: Length,
        start: Point3,
        rail: Vector3,
        rod: Length,
    }
    input t: Angle;
    unknown s: Length;

    let slider = start + s * rail / norm(rail);
    let rod_vector = slider - rot_z(t) * vec3(crank, 0, 0);
    dot(rod_vector, rod_vector) == rod * rod;

    output block: Point3 = slider;
}

mechanism! {
    /// The same, by the length of the rod.
    pub struct RsspByLength {
        crank: Length,
        start: Point3,
        rail: Vector3,
        rod: Length,
    }
    input t: Angle;
    unknown s: Length;

    rod == norm(start + s * (rail / rail.norm()) - crank * (rot_z(t) * vec3(1, 0, 0)));
}

mechanism! {
    /// Cardan's joint: the arms of the cross stay at right angles.
    pub struct Cardan {
        beta: Angle,
    }
    input t: Angle;
    unknown x: Angle;

    dot(rot_z(t) * vec3(0, 1, 0), rot_x(beta) * rot_z(x) * vec3(1, 0, 0)) == 0;
}

mechanism! {
    /// Four arcs of great circles; the pins are unit vectors.
    pub struct SphericalFourBar {
        ground: Angle,
        crank: Angle,
        coupler: Angle,
        rocker: Angle,
    }
    input t: Angle;
    unknown x: Angle;

    let pole = vec3(0, 0, 1);
    let first = rot_z(t) * rot_y(crank) * pole;
    let second = rot_y(ground) * rot_z(x) * rot_y(rocker) * pole;
    dot(first, second) == cos(coupler);
}

mechanism! {
    /// A leg of a Stewart-Gough platform, its length from the platform's pose.
    pub struct Leg {
        base: Point3,
        joint: Vector3,
    }
    input x: Length, y: Length, z: Length, roll: Angle, pitch: Angle, yaw: Angle;
    unknown leg: Length where leg > 0;

    let end = vec3(x, y, z) + rot_z(yaw) * rot_y(pitch) * rot_x(roll) * joint;
    dot(end - base, end - base) == leg.powi(2);

    output top: Point3 = end;
}

mechanism! {
    /// The same, by the length itself.
    pub struct LegByLength {
        base: Point3,
        joint: Vector3,
    }
    input x: Length, y: Length, z: Length, roll: Angle, pitch: Angle, yaw: Angle;
    unknown leg: Length;

    leg == norm(vec3(x, y, z) + rot_z(yaw) * rot_y(pitch) * rot_x(roll) * joint - base);
}

mechanism! {
    /// Bennett's linkage: opposite joints turn by opposite angles, and the second joint by what leads the links 2 and 3 to
    /// where the fourth joint is.
    pub struct Bennett {
        a: Length,
        alpha: Angle,
        beta: Angle,
    }
    input theta1: Angle;
    unknown theta2: Angle, theta3: Angle, theta4: Angle;

    let b = a * sin(beta) / sin(alpha);
    let links = vec3(b, 0, 0) + rot_x(beta) * rot_z(theta3) * vec3(a, 0, 0);
    let straight = rot_x(-alpha) * -(vec3(a, 0, 0) + rot_z(-theta1) * vec3(b, 0, 0));
    theta2 == atan2(cross(vec2(links.x, links.y), vec2(straight.x, straight.y)), dot(vec2(links.x, links.y), vec2(straight.x, straight.y)));
    theta3 == -theta1;
    theta4 == -theta2;
}

mechanism! {
    /// A slider-crank in the plane of a space, and its turned rod by a product of plane vectors.
    pub struct PlaneProducts {
        crank: Length,
        rod: Length,
    }
    input t: Angle;
    unknown x: Length where x > 0, area: Length;

    let pin = crank * cis(t);
    norm(vec2(x, 0) - pin) == rod;
    area * rod == cross(pin, vec2(x, 0)) + pin.dot(vec2(x, 0));
}
