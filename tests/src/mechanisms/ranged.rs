//! Unknowns with a range that picks their branch.

use kin_core::mechanism;

mechanism! {
    /// A four-bar linkage of which the coupler points upwards: told at run time.
    pub struct RangedCoupler {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle in 0.0..=PI, theta4: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

mechanism! {
    /// A four-bar linkage with its rocker in the upper half of the plane, on the third turn.
    pub struct RangedRocker {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle in 4 * PI..=5 * PI;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

mechanism! {
    /// The angle between two sides of a triangle: the range picks the branch when this is compiled.
    pub struct RangedAngle {
        a: Length,
        b: Length,
    }
    input c: Length;
    unknown gamma: Angle in 0.0..=PI;

    c.powi(2) == a.powi(2) + b.powi(2) - 2 * a * b * cos(gamma);
}

mechanism! {
    /// The same on the other side.
    pub struct RangedAngleBelow {
        a: Length,
        b: Length,
    }
    input c: Length;
    unknown gamma: Angle in -PI..=0;

    c.powi(2) == a.powi(2) + b.powi(2) - 2 * a * b * cos(gamma);
}

mechanism! {
    /// An acute angle by its sine.
    pub struct RangedSine {
        a: Length,
    }
    input t: Length;
    unknown x: Angle in -PI / 2..=PI / 2;

    a * sin(x) == t;
}

mechanism! {
    /// An obtuse angle by its sine.
    pub struct RangedSineObtuse {
        a: Length,
    }
    input t: Length;
    unknown x: Angle in PI / 2..=3 * PI / 2;

    a * sin(x) == t;
}

mechanism! {
    /// A slider-crank with its slider on the near side.
    pub struct RangedSlider {
        r: Length,
        l: Length,
        h: Length,
    }
    input theta: Angle;
    unknown phi: Angle, s: Length where s < 0;

    r * cis(theta) + l * cis(phi) == vec2(s, h);
}

mechanism! {
    /// An inverted slider-crank with the lever's length negative.
    pub struct RangedLever {
        r1: Length,
        r2: Length,
    }
    input theta2: Angle;
    unknown r4: Length where r4 < 0, theta4: Angle;

    r1 + r2 * cis(theta2) == r4 * cis(theta4);
}

mechanism! {
    /// One root of a circular equation, told at run time.
    pub struct RangedCircular {
        a: Length,
        b: Length,
    }
    input t: Length;
    unknown x: Angle in 0.0..=2;

    a * cos(x) + b * sin(x) == t;
}

mechanism! {
    /// A length that must not leave its range, though there is no choice.
    pub struct RangedLinear {
        a: Length,
    }
    input t: Scalar;
    unknown x: Length in 0..=10;

    x == a * t;
}

mechanism! {
    /// A four-bar linkage with its coupler on the right: where both couplers are, the rocker's range decides.
    pub struct RangedTwice {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle in -PI / 2..=PI / 2, theta4: Angle in 0.0..=PI;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

mechanism! {
    /// A slider-crank on an inclined slide, with its slider on the near side: the rod's range decides where both are.
    pub struct RangedIncline {
        r: Length,
        l: Length,
        incline: Angle,
    }
    input theta: Angle;
    unknown s: Length in -10..=0, phi: Angle in PI..=2 * PI;

    r * cis(theta) + l * cis(phi) == s * cis(incline);
}

mechanism! {
    /// A ranged dyad between two that the caller chooses.
    pub struct RangedBetween {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
        r5: Length,
        r6: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle, theta5: Angle in 0.0..=PI, theta6: Angle, theta7: Angle, theta8: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    r4 * cis(theta4) + r5 * cis(theta5) == r1 + r6 * cis(theta6);
    r6 * cis(theta6) + r3 * cis(theta7) == r1 + r4 * cis(theta8);
}
