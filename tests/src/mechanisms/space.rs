//! Mechanisms of space, from joints and links as they stand: those of the library, and the same in other typings.

use kin_core::mechanism;

pub use kin_core::library::{Bennett, Rssp, Rssr, SphericalFourBar, StewartGoughLeg, UniversalJoint};

mechanism! {
    /// The length of the rod instead of its square.
    pub struct RssrByLength {
        crank: Length,
        pivot: Point3,
        axis: Vector3,
        arm: Vector3,
        rod: Length,
    }
    input theta: Angle;
    unknown phi: Angle;

    norm(rot_z(theta) * vec3(crank, 0, 0) - pivot - rot(axis, phi) * arm) == rod;
}

mechanism! {
    /// The equation multiplied by a length, and the ball on the rocker as unknown coordinates that follow from the
    /// angle.
    pub struct RssrWithBall {
        crank: Length,
        pivot: Point3,
        axis: Vector3,
        arm: Vector3,
        rod: Length,
    }
    input theta: Angle;
    unknown phi: Angle, x: Length, y: Length, z: Length;

    let rod_vector = pivot + rot(axis, phi) * arm - rot_z(theta) * vec3(crank, 0, 0);
    rod * rod_vector.dot(rod_vector) == rod.powi(3);
    vec3(x, y, z) - pivot == rot(axis, phi) * arm;
}

mechanism! {
    /// Driven at its rocker.
    pub struct RssrDrivenAtRocker {
        crank: Length,
        pivot: Point3,
        axis: Vector3,
        arm: Vector3,
        rod: Length,
    }
    input phi: Angle;
    unknown theta: Angle;

    let rod_vector = rot(axis, phi) * arm + pivot - crank * (rot_z(theta) * vec3(1, 0, 0));
    rod * rod == rod_vector.x * rod_vector.x + rod_vector.y * rod_vector.y + rod_vector.z * rod_vector.z;
}

mechanism! {
    /// The length of the rod instead of its square.
    pub struct RsspByLength {
        crank: Length,
        start: Point3,
        rail: Vector3,
        rod: Length,
    }
    input theta: Angle;
    unknown s: Length;

    rod == norm(start + s * rail / rail.norm() - crank * (rot_z(theta) * vec3(1, 0, 0)));
}

mechanism! {
    /// With a range, and the ball as unknown coordinates that follow from the slider.
    pub struct RsspWithBall {
        crank: Length,
        start: Point3,
        rail: Vector3,
        rod: Length,
    }
    input theta: Angle;
    unknown x: Length, y: Length, z: Length, s: Length where s > 0;

    let rod_vector = start + s * rail / norm(rail) - rot_z(theta) * vec3(crank, 0, 0);
    0 == dot(rod_vector, rod_vector) - rod.powi(2);
    vec3(x, y, z) == start + s * (rail / norm(rail));
}

mechanism! {
    /// The vector along the driven arm as a product of vectors: it is normal to the driven shaft and the driving arm.
    pub struct UniversalJointByNormal {
        beta: Angle,
    }
    input driving: Angle;
    unknown driven: Angle;

    let shaft = rot_x(beta) * vec3(0, 0, 1);
    let driving_arm = rot(vec3(0, 0, 3), driving) * vec3(0, 1, 0);
    let zero_arm = vec3(1, 0, 0);
    dot(cross(shaft, driving_arm), rot(shaft, driven + PI / 2) * zero_arm) == 0;
}

mechanism! {
    /// The rocker turns about the ground's end itself.
    pub struct SphericalFourBarAboutAxis {
        ground: Angle,
        crank: Angle,
        coupler: Angle,
        rocker: Angle,
    }
    input theta2: Angle;
    unknown theta4: Angle;

    let end = vec3(sin(ground), 0, cos(ground));
    let rocker_hinge = rot(end, theta4) * vec3(sin(ground + rocker), 0, cos(ground + rocker));
    let crank_hinge = rot_z(theta2) * vec3(sin(crank), 0, cos(crank));
    cos(coupler) == rocker_hinge.dot(crank_hinge);
}

mechanism! {
    /// The length itself, not its square.
    pub struct StewartGoughLegByLength {
        base: Point3,
        joint: Vector3,
    }
    input x: Length, y: Length, z: Length, roll: Angle, pitch: Angle, yaw: Angle;
    unknown leg: Length;

    leg == norm(vec3(x, y, z) + rot_z(yaw) * rot_y(pitch) * rot_x(roll) * joint - base);
}

mechanism! {
    /// Two legs, repeated, of a tilting table on a lift: a frame on another.
    pub struct LegsOfFrames {
        base1: Point3,
        base2: Point3,
        joint1: Vector3,
        joint2: Vector3,
        height: Length,
    }
    input lift: Length, yaw: Angle, tilt: Angle;
    unknown leg1: Length where leg1 > 0, leg2: Length where leg2 > 0;

    let slide = frame(vec3(0, 0, lift), rot_z(yaw));
    let hinge = frame(vec3(0, 0, height), rot_x(tilt));
    let table = slide * hinge;
    for (base, joint, leg, head) in [(base1, joint1, leg1, head1), (base2, joint2, leg2, head2)] {
        let top = table * joint;
        norm(top - base) == leg;
        output head: Point3 = top;
    }
}

mechanism! {
    /// Links 2 and 3 lie in one plane with the second axis and the diagonal: an equation with a second solution, half a
    /// turn away, in which the loop does not close.
    pub struct BennettByTripleProduct {
        a: Length,
        alpha: Angle,
        beta: Angle,
    }
    input theta1: Angle;
    unknown theta2: Angle, theta3: Angle, theta4: Angle;

    let b = a * sin(beta) / sin(alpha);
    let hinge = rot_z(theta1) * rot_x(alpha);
    let over = hinge * rot_z(theta2) * (vec3(b, 0, 0) + rot_x(beta) * rot_z(theta3) * vec3(a, 0, 0));
    let back = -(rot_z(theta1) * vec3(a, 0, 0)) - vec3(b, 0, 0);
    dot(cross(over, back), hinge * vec3(0, 0, 1)) == 0;
    theta1 + theta3 == 0;
    theta2 + theta4 == 0;
}

mechanism! {
    /// The products of plane vectors: a slider-crank, and the sum of both products of two of its sides.
    pub struct PlaneProducts {
        crank: Length,
        rod: Length,
    }
    input theta: Angle;
    unknown x: Length where x > 0, area: Length;

    let pin = crank * cis(theta);
    norm(vec2(x, 0) - pin) == rod;
    area * rod == cross(pin, vec2(x, 0)) + pin.dot(vec2(x, 0));
}
