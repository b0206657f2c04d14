//! Several loops, solved one after the other.

use kin_core::mechanism;

mechanism! {
    /// Two four-bar linkages in series: the first one's rocker is the second one's crank.
    pub struct FourBarsInSeries {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
        s1: Length,
        s3: Length,
        s4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle, phi3: Angle, phi4: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    r4 * cis(theta4) + s3 * cis(phi3) == s1 + s4 * cis(phi4);
}

mechanism! {
    /// The same with the second loop declared first, its links turned round, and the unknowns shuffled.
    pub struct FourBarsInSeriesShuffled {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
        s1: Length,
        s3: Length,
        s4: Length,
    }
    input theta2: Angle;
    unknown phi3: Angle, theta3: Angle, phi4: Angle, theta4: Angle;

    s1 + s4 * cis(phi4) - s3 * cis(phi3) == r4 * cis(theta4);
    r1 + r4 * cis(theta4) == r3 * cis(theta3) + r2 * cis(theta2);
}

mechanism! {
    /// Watt's six-bar linkage: the second loop hangs on a ternary rocker.
    pub struct WattSixBar {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
        /// The rocker's other arm, in the frame of the rocker.
        arm: Vector,
        pivot: Point,
        r5: Length,
        r6: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle, theta5: Angle, theta6: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    let tip = r1 + arm * cis(theta4);
    tip + r5 * cis(theta5) == pivot + r6 * cis(theta6);

    output middle: Point = tip + r5 / 2 * cis(theta5);
}

mechanism! {
    /// Stephenson's six-bar linkage of the third kind: the second loop hangs on a point of the coupler.
    pub struct StephensonSixBar {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
        p: Length,
        q: Length,
        pivot: Point,
        r5: Length,
        r6: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle, theta5: Angle, theta6: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    let tip = r2 * cis(theta2) + vec2(p, q) * cis(theta3);
    tip + r5 * cis(theta5) == pivot + r6 * cis(theta6);

    output tip_position: Point = tip;
}

mechanism! {
    /// Whitworth's quick-return: a slotted lever that goes all the way round drives a ram.
    pub struct Whitworth {
        ground: Length,
        crank: Length,
        arm: Length,
        rod: Length,
        height: Length,
    }
    input theta: Angle;
    unknown slide: Length where slide > 0, phi: Angle, psi: Angle, ram: Length;

    vec2(0, ground) + crank * cis(theta) == slide * cis(phi);
    arm * cis(phi) + rod * cis(psi) == vec2(ram, height);
    with sensitivities;
}

mechanism! {
    /// A crank, a dyad on it, and a slider on a point of the dyad, on an inclined slide.
    pub struct ToggleOnCoupler {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
        rod: Length,
        beta: Angle,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle, psi: Angle, s: Length;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    r2 * cis(theta2) + r3 / 2 * cis(theta3) + rod * cis(psi) == s * cis(beta);
}

mechanism! {
    /// A gear train between a four-bar linkage's rocker and a scotch yoke, with scalar relations.
    pub struct GearedYoke {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
        ratio: Scalar,
        throw: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle, shaft: Angle, yoke: Length, area: Scalar;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    shaft == ratio * (theta4 - theta2);
    yoke == throw * sin(shaft);
    area * r1 == yoke;
    with sensitivities;
}

mechanism! {
    /// Two dyads, the second on the rod of the first, to the velocity alone.
    pub struct TwoDyads {
        a: Length,
        b: Length,
        g: Point,
        c: Length,
        w: Vector,
        d: Length,
        h: Point,
        e: Length,
    }
    input q: Angle;
    unknown u: Angle, v: Angle, x: Angle, y: Angle;
    order = 1;

    a * cis(q) + b * cis(u) == g + c * cis(v);
    a * cis(q) + w * cis(u) + d * cis(x) == h + e * cis(y);
}
