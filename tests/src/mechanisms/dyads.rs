//! Single loops of other kinds: two lengths, ternary links, an arm with two links, two inputs.

use kin_core::mechanism;

mechanism! {
    /// Two slides at a fixed angle meet in a pin that is carried round by a crank: both travels are unknown.
    pub struct TwoSlides {
        r: Length,
        alpha: Angle,
        beta: Angle,
    }
    input theta: Angle;
    unknown a: Length, b: Length;

    a * cis(alpha) + b * cis(beta) == r * cis(theta);
}

mechanism! {
    /// Oldham's coupling as a linkage: the slides turn, their pivots are fixed.
    pub struct SwingingSlides {
        distance: Length,
        gamma: Angle,
    }
    input theta: Angle;
    unknown a: Length, b: Length;

    a * cis(theta) == distance + b * cis(theta + gamma);
}

mechanism! {
    /// An arm with two links, from the hand to the joints; the second angle is that of the elbow.
    pub struct TwoLinkArm {
        upper: Length,
        lower: Length,
    }
    input x: Length, y: Length;
    unknown q1: Angle, q2: Angle;

    upper * cis(q1) + lower * cis(q1 + q2) == vec2(x, y);
}

mechanism! {
    /// The same arm, its hand given in polar coordinates and as a sum of products of angles.
    pub struct TwoLinkArmPolar {
        upper: Length,
        lower: Length,
    }
    input radius: Length, azimuth: Angle;
    unknown q1: Angle, q2: Angle;

    cis(q1) * (upper + lower * cis(q2)) == polar(radius, azimuth);
}

mechanism! {
    /// A four-bar linkage of ternary links: the loop turns the corner at a rigid angle.
    pub struct OffsetAngles {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
        gamma: Angle,
        delta: Angle,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;

    r2 * cis(theta2) + r3 * cis(theta3 + gamma) == r1 + r4 * cis(theta4 - delta);
}

mechanism! {
    /// A four-bar linkage of ternary links: the links are complex constants, the pivot is a point.
    pub struct ComplexLinks {
        pivot: Point,
        r2: Length,
        p: Length,
        q: Length,
        rocker: Vector,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;

    r2 * cis(theta2) + vec2(p, q) * cis(theta3) == pivot + rocker * cis(theta4);
}

mechanism! {
    /// A ternary rod with a slider on an inclined slide.
    pub struct ComplexRod {
        r: Length,
        p: Length,
        q: Length,
        beta: Angle,
    }
    input theta: Angle;
    unknown phi: Angle, s: Length;

    r * cis(theta) + vec2(p, q) * cis(phi) == s * cis(beta);
}

mechanism! {
    /// Five bars, two of them driven.
    pub struct FiveBar {
        ground: Length,
        left: Length,
        left_rod: Length,
        right_rod: Length,
        right: Length,
    }
    input alpha: Angle, beta: Angle;
    unknown phi: Angle, psi: Angle;

    left * cis(alpha) + left_rod * cis(phi) == ground + right * cis(beta) + right_rod * cis(psi);

    output hand: Point = left * cis(alpha) + left_rod * cis(phi);
    with sensitivities;
}

mechanism! {
    /// A four-bar linkage of any proportions, its ground link a vector.
    pub struct FourBarOnGround {
        /// Crank.
        pub a: Length,
        /// Coupler.
        pub b: Length,
        /// Rocker.
        pub c: Length,
        /// From the crank's pivot to the rocker's.
        pub ground: Point,
    }
    input q: Angle;
    unknown u: Angle, v: Angle;

    a * cis(q) + b * cis(u) == ground + c * cis(v);
}
