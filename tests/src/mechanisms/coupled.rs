//! Mechanisms with blocks that no closed form fits.

use kin_core::prelude::*;

mechanism! {
    /// Kepler's equation: one unknown, inside and outside of a sine.
    #[allow(missing_docs)]
    pub struct Kepler {
        /// Numerical eccentricity of the orbit.
        pub eccentricity: Scalar,
    }
    input mean: Angle;
    unknown eccentric: Angle;
    eccentric - eccentricity * sin(eccentric) == mean;
    output height: Scalar = sin(eccentric);
}

mechanism! {
    /// A four-bar driven by a motor between crank and coupler.
    #[allow(missing_docs)]
    pub struct RelativeDrive { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
    input drive: Angle;
    unknown theta2: Angle, theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    theta3 - theta2 == drive;
}

mechanism! {
    /// A class III triad whose first pivot moves on a crank: three legs and a ternary link.
    #[allow(missing_docs)]
    pub struct Triad {
        pub crank: Length,
        pub a: Length,
        pub b: Length,
        pub c: Length,
        /// From the first leg's joint of the ternary link to the second's.
        pub p: Length,
        /// From the first leg's joint to the third's.
        pub q: Length,
        /// The angle between these two.
        pub delta: Angle,
        pub pivot_b: Point,
        pub pivot_c: Point,
    }
    input theta: Angle;
    unknown alpha: Angle, beta: Angle, gamma: Angle, phi: Angle;
    let joint = crank * cis(theta) + a * cis(alpha);
    joint + p * cis(phi) == pivot_b + b * cis(beta);
    joint + q * cis(phi + delta) == pivot_c + c * cis(gamma);
    output centre: Point = joint + p * cis(phi) / 3 + q * cis(phi + delta) / 3;
}

mechanism! {
    /// A Stephenson III six-bar driven at the far dyad.
    #[allow(missing_docs)]
    pub struct StephensonThree {
        pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length,
        /// Of the coupler point in the coupler's own frame.
        pub coupler_point: Vector,
        pub pivot: Point, pub r5: Length, pub r6: Length,
    }
    input theta6: Angle;
    unknown theta2: Angle, theta3: Angle, theta4: Angle, theta5: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    r2 * cis(theta2) + coupler_point * cis(theta3) + r5 * cis(theta5) == pivot + r6 * cis(theta6);
}

mechanism! {
    /// Two cranks geared together by a ratio that is a parameter, and a dyad between them.
    #[allow(missing_docs)]
    pub struct GearedPair {
        pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length, pub ratio: Scalar, pub phase: Angle,
    }
    input theta3: Angle;
    unknown theta2: Angle, theta4: Angle, s: Length;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + s + r4 * cis(theta4);
    theta4 == ratio * theta2 + phase;
}

mechanism! {
    /// Six unknown angles in one block: a ring of three ternary links, each on a leg of its own.
    #[allow(missing_docs)]
    pub struct SixCoupled {
        pub side: Length,
        pub leg: Length,
        pub tie: Length,
        pub radius: Length,
    }
    input theta: Angle;
    unknown a: Angle, b: Angle, c: Angle, d: Angle, e: Angle, f: Angle;
    let first = polar(radius, 0) + leg * cis(a);
    let second = polar(radius, 2 * PI / 3) + leg * cis(b);
    let third = polar(radius, 4 * PI / 3) + leg * cis(c);
    first + side * cis(d) + tie * cis(e) == second;
    second + side * cis(e) + tie * cis(f) == third;
    third + side * cis(f) + tie * cis(d + theta) == first;
}
