//! Trees of links: each hangs on points of those before it, in every way that links are joined.
#![allow(missing_docs, reason = "the names are numbered")]

use kin_core::mechanism;

mechanism! {
    /// Three dyads on a crank: the first on the ground, the second between the links of the first, the third between
    /// the second and the ground.
    pub struct TreeOfDyads {
        pub crank: Length,
        pub a1: Length, pub b1: Length, pub pivot1: Point,
        /// The point of the first link that carries the second dyad, in the link's frame; likewise below.
        pub v1: Vector, pub w1: Vector,
        pub a2: Length, pub b2: Length,
        pub v2: Vector,
        pub a3: Length, pub b3: Length, pub pivot3: Point,
    }
    input theta: Angle;
    unknown p1: Angle, q1: Angle, p2: Angle, q2: Angle, p3: Angle, q3: Angle;

    let pin = crank * cis(theta);
    pin + a1 * cis(p1) == pivot1 + b1 * cis(q1);
    let carried = pin + v1 * cis(p1);
    carried + a2 * cis(p2) == pivot1 + w1 * cis(q1) + b2 * cis(q2);
    carried + v2 * cis(p2) + a3 * cis(p3) == pivot3 + b3 * cis(q3);

    output joint: Point = carried + a2 * cis(p2);
}

mechanism! {
    /// A gear beside the crank, a dyad between them, a slider and an oscillating lever on the dyad, and a spatial loop
    /// that the lever drives.
    pub struct TreeOfAllKinds {
        pub crank: Length,
        pub ratio: Scalar, pub phase: Angle, pub pivot: Point, pub arm: Length,
        pub a: Length, pub b: Length,
        pub v: Vector, pub rod: Length, pub base: Point, pub beta: Angle,
        pub w: Vector, pub hinge: Point,
        pub throw: Length, pub stand: Point3, pub axis: Vector3, pub swing: Vector3, pub link: Length,
    }
    input theta: Angle;
    unknown
        gear: Angle, p: Angle, q: Angle, r: Angle, s: Length,
        t: Length, u: Angle, phi: Angle;

    gear == ratio * theta + phase;
    let pin = crank * cis(theta);
    let other = pivot + arm * cis(gear);
    pin + a * cis(p) == other + b * cis(q);
    pin + v * cis(p) + rod * cis(r) == base + s * cis(beta);
    hinge + t * cis(u) == other + w * cis(q);
    let coupler = stand + rot(axis, phi) * swing - rot_z(u) * vec3(throw, 0, 0);
    dot(coupler, coupler) == link.powi(2);

    output slide: Point = base + s * cis(beta);
}
