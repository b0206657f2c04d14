//! Unknowns that are found as unit vectors: in every closed form, beside angles, and where the angle is asked for all
//! the same.

use kin_core::mechanism;

use super::coupled::{Built, Triad};
use crate::random::Random;

mechanism! {
    /// The four-bar linkage, without an arctangent.
    pub struct DirectedFourBar { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Direction, theta4: Direction;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

mechanism! {
    /// The same with an angle for the coupler.
    pub struct DirectedRocker { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Direction;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

mechanism! {
    /// The same with the rocker clockwise and seen from the coupler, links divided by the ground.
    pub struct DirectedRelative { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Direction, gamma: Direction;
    (r2 * cis(theta2) + r3 * cis(theta3)) / r1 == 1 + r4 * cis(theta3 - gamma) / r1;
}

mechanism! {
    /// The same by Freudenstein's equations.
    pub struct DirectedFreudenstein { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Direction, theta4: Direction;
    let k1 = r1 / r2;
    let k3 = (r2.powi(2) - r3.powi(2) + r4.powi(2) + r1.powi(2)) / (2 * r2 * r4);
    let k5 = (r4.powi(2) - r1.powi(2) - r2.powi(2) - r3.powi(2)) / (2 * r2 * r3);
    k1 * cos(theta4) - r1 / r4 * cos(theta2) + k3 == cos(theta2 - theta4);
    k1 * cos(theta3) + r1 / r3 * cos(theta2) + k5 == cos(theta2 - theta3);
}

mechanism! {
    /// The same triangle by triangle: inverse sines, an inverse cosine with a range, and sums of angles.
    pub struct DirectedTriangles { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown
        e: Length where e > 0, alpha: Direction, gamma: Direction in 0.0..=PI, beta: Direction,
        theta4: Direction, theta3: Direction;
    e.powi(2) == r1.powi(2) + r2.powi(2) - 2 * r1 * r2 * cos(theta2);
    sin(alpha) == r2 * sin(theta2) / e;
    cos(gamma) == (r3.powi(2) + r4.powi(2) - e.powi(2)) / (2 * r3 * r4);
    sin(beta) == r3 * sin(gamma) / e;
    alpha + beta + theta4 == PI;
    theta3 == theta4 - gamma;
}

mechanism! {
    /// The four-bar linkage where the rocker's angle chooses, on whatever turn.
    pub struct DirectedWithinRange { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Direction, theta4: Direction in 0.0..=PI;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

mechanism! {
    /// Equations that need the angle of the rocker itself: a rack, a cam that rises with its square, and outputs.
    pub struct DirectedRack { r1: Length, r2: Length, r3: Length, r4: Length, pinion: Length }
    input theta2: Angle;
    unknown theta3: Direction, theta4: Direction, rack: Length, cam: Length;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    rack == pinion * theta4;
    cam == pinion * theta4.powi(2);
    output between: Angle = theta4 - theta3;
    output tip: Point = r1 + r4 * cis(theta4);
}

mechanism! {
    /// An offset slider-crank.
    pub struct DirectedSliderCrank { r: Length, l: Length, h: Length }
    input theta: Angle;
    unknown phi: Direction, s: Length;
    r * cis(theta) - l * cis(-phi) == vec2(-s, h);
    output rod: Point = r * cis(theta) + l / 3 * cis(phi);
}

mechanism! {
    /// The slider-crank by an inverse sine.
    pub struct DirectedByInverseSine { r: Length, l: Length, h: Length }
    input theta: Angle;
    unknown phi: Direction, s: Length;
    sin(phi) == (r * sin(theta) - h) / l;
    s == r * cos(theta) + l * cos(phi);
}

mechanism! {
    /// The slider-crank driven at its slider: one of two angles a direction.
    pub struct DirectedAtSlider { r: Length, l: Length, h: Length }
    input s: Length;
    unknown theta: Direction, phi: Angle;
    r * cis(theta) + l * cis(phi) == vec2(s, h);
}

mechanism! {
    /// An inverted slider-crank in either assembly.
    pub struct DirectedLever { r1: Length, r2: Length }
    input theta2: Angle;
    unknown r4: Length, theta4: Direction;
    r1 + r2 * cis(theta2) == polar(r4, theta4);
}

mechanism! {
    /// The same with a slide that passes by the joint.
    pub struct DirectedOffsetLever { r1: Length, r2: Length, offset: Length }
    input theta2: Angle;
    unknown r4: Length, theta4: Direction;
    r1 + r2 * cis(theta2) == vec2(r4, offset) * cis(theta4);
}

mechanism! {
    /// An arm with two links, the second angle that of the elbow.
    pub struct DirectedArm { upper: Length, lower: Length }
    input x: Length, y: Length;
    unknown q1: Direction, q2: Direction;
    upper * cis(q1) + lower * cis(q1 + q2) == vec2(x, y);
}

mechanism! {
    /// Four-bar linkages in series: what is a direction here is read off there.
    pub struct DirectedSeries { r1: Length, r2: Length, r3: Length, r4: Length, r5: Length, r6: Length, r7: Length }
    input theta2: Angle;
    unknown theta3: Direction, theta4: Direction, theta6: Direction, theta7: Direction;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    r4 * cis(theta4) + r6 * cis(theta6) == r5 + r7 * cis(theta7);
}

mechanism! {
    /// A gear whose angle is a quotient, and one that is a multiple.
    pub struct DirectedGears { ratio: Scalar, radius: Length }
    input theta: Angle;
    unknown driven: Direction, twice: Direction, height: Length;
    ratio * driven == theta;
    twice == 2 * driven;
    height == radius * sin(driven + twice);
}

mechanism! {
    /// Hooke's joint.
    pub struct DirectedJoint { inclination: Angle }
    input theta: Angle;
    unknown phi: Direction;
    cos(theta) * sin(phi) * cos(inclination) == sin(theta) * cos(phi);
}

mechanism! {
    /// The four-bar linkage with sensitivities and a rate of the twelfth order.
    pub struct DirectedFarther { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Direction, theta4: Direction;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    order = 12;
}

mechanism! {
    /// The rack once more, through snap and with sensitivities.
    pub struct DirectedSensitive { r1: Length, r2: Length, r3: Length, r4: Length, pinion: Length }
    input theta2: Angle;
    unknown theta3: Direction, theta4: Direction, cam: Length;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    cam == pinion * theta4.powi(2);
    output middle: Point = r2 * cis(theta2) + r3 / 2 * cis(theta3);
    with sensitivities, transmission_angles;
}

mechanism! {
    /// A four-bar linkage driven by a motor between crank and coupler: a block of three, with assemblies.
    pub struct DirectedDrive { r1: Length, r2: Length, r3: Length, r4: Length }
    input drive: Angle;
    unknown theta2: Direction, theta3: Direction, theta4: Direction;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    theta3 - theta2 == drive;
    with sensitivities;
}

mechanism! {
    /// Kepler's equation: an angle that Newton's method finds as a number.
    #[allow(missing_docs)]
    pub struct DirectedKepler { pub eccentricity: Scalar }
    input mean: Angle;
    unknown eccentric: Direction;
    eccentric - eccentricity * sin(eccentric) == mean;
    output height: Scalar = sin(eccentric);
}

mechanism! {
    /// A class III triad, the platform an angle, the legs directions.
    #[allow(missing_docs)]
    pub struct DirectedTriad {
        pub crank: Length,
        pub a: Length,
        pub b: Length,
        pub c: Length,
        pub p: Length,
        pub q: Length,
        pub delta: Angle,
        pub pivot_b: Point,
        pub pivot_c: Point,
    }
    input theta: Angle;
    unknown alpha: Direction, beta: Direction, gamma: Direction, phi: Angle;
    let joint = crank * cis(theta) + a * cis(alpha);
    joint + p * cis(phi) == pivot_b + b * cis(beta);
    joint + q * cis(phi + delta) == pivot_c + c * cis(gamma);
    output centre: Point = joint + p * cis(phi) / 3 + q * cis(phi + delta) / 3;
    with sensitivities;
}

impl DirectedKepler {
    /// Any position.
    pub fn built(random: &mut Random) -> Built<Self, 1> {
        let Built {
            mechanism,
            input,
            unknowns,
        } = super::coupled::Kepler::built(random);
        Built {
            mechanism: Self {
                eccentricity: mechanism.eccentricity,
            },
            input,
            unknowns,
        }
    }
}

impl DirectedTriad {
    /// Any position: that of the triad of angles.
    pub fn built(random: &mut Random) -> Built<Self, 4> {
        let Built {
            mechanism,
            input,
            unknowns,
        } = Triad::built(random);
        Built {
            mechanism: Self::from_angles(&mechanism),
            input,
            unknowns,
        }
    }

    /// The same triad.
    #[must_use]
    pub fn from_angles(triad: &Triad) -> Self {
        let Triad {
            crank,
            a,
            b,
            c,
            p,
            q,
            delta,
            pivot_b,
            pivot_c,
        } = *triad;
        Self {
            crank,
            a,
            b,
            c,
            p,
            q,
            delta,
            pivot_b,
            pivot_c,
        }
    }
}
