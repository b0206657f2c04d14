//! Quantities that are carried along: points, angles, lengths, and functions of them.

use kin_core::mechanism;

mechanism! {
    /// A four-bar linkage with everything one may want to know of it.
    pub struct FourBarOutputs {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
        /// A point of the coupler, in its frame.
        trace: Vector,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);

    let pin = r2 * cis(theta2);
    output coupler_point: Point = pin + trace * cis(theta3);
    output midpoint: Point = (pin + r1 + r4 * cis(theta4)) / 2;
    output transmission: Angle = theta4 - theta3;
    output diagonal: Length = sqrt(r1.powi(2) + r2.powi(2) - 2 * r1 * r2 * cos(theta2));
    output bearing: Angle = atan2(pin.y + trace.x * sin(theta3), pin.x - r1);
    output slope: Scalar = (pin.y + r3 / 2 * sin(theta3)) / (pin.x + r3 / 2 * cos(theta3));
    output advantage: Scalar = sin(theta3 - theta4) / sin(theta3 - theta2);
    output decay: Scalar = exp(-theta3.powi(2) / 2) * ln(1 + theta4.powi(2)) + atan(theta2) / tan(theta3 + 2);
    output turned: Vector = pin * cis(theta4);
}

mechanism! {
    /// An output that is not defined everywhere.
    pub struct OutputOutsideDomain {
        a: Length,
    }
    input t: Length;
    unknown x: Length;

    x == t - a;
    output root: Length = sqrt(x * a);
}

mechanism! {
    /// A closure with a square root that is not defined everywhere.
    pub struct ClosureOutsideDomain {
        a: Length,
    }
    input t: Length;
    unknown x: Length;

    x == sqrt(t * a) + a * ln(t / a) / 8;
}

mechanism! {
    /// A four-bar whose coupler is a frame on that of the crank, with the picture of two of its points.
    #[allow(missing_docs)]
    pub struct OutputsOfFrames {
        pub r1: Length,
        pub r2: Length,
        pub r3: Length,
        pub r4: Length,
        pub p: Vector,
        pub q: Vector,
    }
    input theta2: Angle;
    unknown bend: Angle, theta4: Angle;
    let crank = frame(0, theta2);
    let rod = frame(r2, bend);
    let coupler = crank * rod;
    coupler * r3 == r1 + r4 * cis(theta4);
    ground 0, vec2(r1, 0);
    for (trace, tip, plate) in [(p, near, upper), (q, far, lower)] {
        output tip: Point = coupler * trace;
        body plate: coupler * 0, coupler * r3, tip;
    }
}

mechanism! {
    /// A press whose second loop begins at an output of the first, with outputs of outputs and their picture.
    #[allow(missing_docs)]
    pub struct OutputsInFormulas {
        pub crank: Length,
        pub rod: Length,
        pub arm: Length,
        pub link: Length,
        pub guide: Length,
    }
    input theta: Angle;
    unknown phi: Angle, s: Length, psi: Angle, lift: Length;
    output pin: Point = crank * cis(theta);
    pin + rod * cis(phi) == vec2(s, 0);
    output knee: Point = pin + polar(arm, phi);
    knee + link * cis(psi) == vec2(guide, lift);
    output bend: Angle = psi - phi;
    output twice: Angle = 2 * bend;
    output middle: Point = (pin + knee) / 2;
    ground 0;
    body crank: 0, pin;
    body rod: pin, knee, vec2(s, 0), middle;
    body link: knee, vec2(guide, lift);
}
