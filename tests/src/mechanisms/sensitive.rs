//! Mechanisms of every closed form that know the partial derivatives of their motion by their parameters.
//!
//! Declared here are those that have no twin elsewhere, and those whose twin is solved in fewer operations: what the
//! partial derivatives need as well is kept where a solver alone would not keep it.

use kin_core::mechanism;
use kin_core::prelude::*;

use super::cases::{Case, ThroughSnap};
use super::coupled::RelativeDrive;
use super::directions::{DirectedDrive, DirectedSensitive};
use super::dyads::FiveBar;
use super::inverted_slider_crank_typings::InvertedOffset;
use super::multi_loop::{GearedYoke, Whitworth};
use super::scalar_forms::QuadraticForm;

/// A mechanism in double precision, through snap, that knows its sensitivities.
pub trait SensitiveThroughSnap: ThroughSnap + Sensitive {}

impl<M: ThroughSnap + Sensitive> SensitiveThroughSnap for M {}

/// Something that is to be done with each of them.
pub trait Visitor {
    /// Does it with one of them.
    fn visit<M: SensitiveThroughSnap>(&mut self, case: Case);
}

macro_rules! all {
    ($($mechanism:ident [$($parameter:expr),*] at $([$low:expr, $high:expr])+;)+) => {
        /// All of them.
        pub fn all(visitor: &mut impl Visitor) {
            $(visitor.visit::<$mechanism>(Case {
                parameters: &[$($parameter),*],
                inputs: &[$(($low, $high)),+],
            });)+
        }
    };
}

all! {
    SensitiveFourBar [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
    SensitiveFourBarDivided [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
    SensitiveFreudenstein [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
    SensitiveGeometric [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
    SensitiveRanged [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
    SensitiveSeries [0.8, 2.5] at [-3.1, 3.1];
    SensitiveOutputs [90.0, 30.0, 60.0, 45.0, 25.0, 15.0] at [-1.9, 1.9];
    SensitiveTernary [80.0, 20.0, 30.0, 55.0, 25.0, 40.0, 30.0] at [-3.1, 3.1];
    SensitiveSlider [1.0, 3.0, 0.4, 0.7] at [-3.1, 3.1];
    SensitivePump [1.0, 3.0, 0.4] at [1.9, 4.1];
    InvertedOffset [2.0, 0.8, 0.5] at [-3.1, 3.1];
    SensitiveSlides [1.3, 0.4, 2.2] at [-3.1, 3.1];
    FiveBar [2.0, 1.0, 2.0, 1.8, 1.1] at [0.2, 2.9] [0.3, 3.0];
    SensitiveWatt [4.0, 1.0, 3.0, 2.5, 2.0, 1.0, 7.0, 0.5, 3.0, 2.5] at [-3.1, 3.1];
    GearedYoke [4.0, 1.0, 3.0, 2.5, 2.5, 0.7] at [-3.1, 3.1];
    Whitworth [0.5, 1.2, 1.5, 5.0, 0.3] at [-3.1, 3.1];
    QuadraticForm [1.5, 2.0, 0.5] at [-3.0, 3.0];
    SensitiveLogarithm [0.8] at [-2.0, 2.0];
    SensitiveFunctions [3.0, 1.0] at [-3.1, 3.1];
    // axis and rail, the lengths of which do not matter, are of the mechanism's size, by which parameters are measured
    SensitiveRssr [1.0, 3.0, 0.5, 0.8, 0.6, 2.7, 0.9, 0.4, -0.3, 1.9, 3.3] at [-3.1, 3.1];
    SensitiveRssp [1.0, 1.5, 0.4, 0.3, 0.6, -0.8, 2.4, 3.0] at [-3.1, 3.1];
    RelativeDrive [90.0, 30.0, 60.0, 45.0] at [-3.1, 3.1];
    DirectedSensitive [90.0, 30.0, 60.0, 45.0, 10.0] at [-1.9, 1.9];
    DirectedDrive [90.0, 30.0, 60.0, 45.0] at [-3.1, 3.1];
}

mechanism! {
    /// The same with a quotient in the closure.
    pub struct SensitiveFourBarDivided {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    (r2 * cis(theta2) + r3 * cis(theta3) - r1) / (r4 * r1) == cis(theta4) / r1;
    with sensitivities;
}

mechanism! {
    /// The same by Freudenstein's equations: a block for each angle.
    pub struct SensitiveFreudenstein {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    let k1 = r1 / r2;
    let k3 = (r2.powi(2) - r3.powi(2) + r4.powi(2) + r1.powi(2)) / (2 * r2 * r4);
    let k5 = (r4.powi(2) - r1.powi(2) - r2.powi(2) - r3.powi(2)) / (2 * r2 * r3);
    k1 * cos(theta4) - r1 / r4 * cos(theta2) + k3 == cos(theta2 - theta4);
    k1 * cos(theta3) + r1 / r3 * cos(theta2) + k5 == cos(theta2 - theta3);
    with sensitivities;
}

mechanism! {
    /// The same as a chain of scalar equations with ranges.
    pub struct SensitiveGeometric {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
    }
    input theta2: Angle;
    unknown e: Length where e > 0, alpha: Angle, gamma: Angle in 0.0..=PI, beta: Angle, theta4: Angle, theta3: Angle;
    e.powi(2) == r1.powi(2) + r2.powi(2) - 2 * r1 * r2 * cos(theta2);
    sin(alpha) == r2 * sin(theta2) / e;
    cos(gamma) == (r3.powi(2) + r4.powi(2) - e.powi(2)) / (2 * r3 * r4);
    sin(beta) == r3 * sin(gamma) / e;
    alpha + beta + theta4 == PI;
    theta3 == theta4 - gamma;
    with sensitivities;
}

mechanism! {
    /// A slider-crank's series, high powers of its parameters.
    pub struct SensitiveSeries {
        r: Length,
        l: Length,
    }
    input theta: Angle;
    unknown s: Length;
    let c0 = l - r.powi(2) / (4 * l) - 3 * r.powi(4) / (64 * l.powi(3)) - 5 * r.powi(6) / (256 * l.powi(5));
    let c2 = r.powi(2) / (4 * l) + r.powi(4) / (16 * l.powi(3)) + 15 * r.powi(6) / (512 * l.powi(5));
    let c4 = r.powi(4) / (64 * l.powi(3)) + 3 * r.powi(6) / (256 * l.powi(5));
    let c6 = r.powi(6) / (512 * l.powi(5));
    s == r * cos(theta) + c0 + c2 * cos(2 * theta) - c4 * cos(4 * theta) + c6 * cos(6 * theta);
    with sensitivities;
}

mechanism! {
    /// A four-bar linkage with everything one may want to know of it.
    pub struct SensitiveOutputs {
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
    output transmission: Angle = theta4 - theta3;
    output diagonal: Length = sqrt(r1.powi(2) + r2.powi(2) - 2 * r1 * r2 * cos(theta2));
    output bearing: Angle = atan2(pin.y + trace.x * sin(theta3), pin.x - r1);
    output decay: Scalar = exp(-theta3.powi(2) / 2) * ln(1 + theta4.powi(2)) * r2 / r1;
    output longest: Length = r1;
    output still: Scalar = 2;
    with sensitivities;
}

mechanism! {
    /// A four-bar linkage of ternary links about a point.
    pub struct SensitiveTernary {
        pivot: Point,
        r2: Length,
        p: Length,
        q: Length,
        rocker: Vector,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + vec2(p, q) * cis(theta3) == pivot + rocker * cis(theta4);
    output pin: Point = pivot + rocker * cis(theta4);
    with sensitivities;
}

mechanism! {
    /// Two shafts in space, a rod with ball joints between their arms, and the end of the rod.
    pub struct SensitiveRssr {
        crank: Length,
        pivot: Point3,
        axis: Vector3,
        arm: Vector3,
        rod: Length,
    }
    input theta: Angle;
    unknown phi: Angle;
    let ball = pivot + rot(axis, phi) * arm;
    let rod_vector = ball - rot_z(theta) * vec3(crank, 0, 0);
    dot(rod_vector, rod_vector) == rod.powi(2);
    output end: Point3 = ball;
    with sensitivities;
}

mechanism! {
    /// A slider on a rail in space, with its coordinates as unknowns.
    pub struct SensitiveRssp {
        crank: Length,
        start: Point3,
        rail: Vector3,
        rod: Length,
    }
    input theta: Angle;
    unknown x: Length, y: Length, z: Length, s: Length;
    let pin = rot_z(theta) * vec3(crank, 0, 0);
    norm(start + s * rail / norm(rail) - pin) == rod;
    vec3(x, y, z) == start + s * (rail / norm(rail));
    output rod_vector: Vector3 = vec3(x, y, z) - pin;
    output slope: Scalar = (z - pin.z) / rod;
    with sensitivities;
}

mechanism! {
    /// A four-bar linkage as a vector loop.
    pub struct SensitiveFourBar {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    with sensitivities;
}

mechanism! {
    /// The same with its coupler in the upper half of the plane, which is told at run time.
    pub struct SensitiveRanged {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle in 0.0..=PI, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    with sensitivities;
}

mechanism! {
    /// A slider-crank on an inclined slide with an offset.
    pub struct SensitiveSlider {
        crank: Length,
        rod: Length,
        offset: Length,
        beta: Angle,
    }
    input theta: Angle;
    unknown phi: Angle, s: Length;
    crank * cis(theta) + rod * cis(phi) == vec2(s, offset) * cis(beta);
    with sensitivities;
}

mechanism! {
    /// A slider-crank that its slider drives.
    pub struct SensitivePump {
        crank: Length,
        rod: Length,
        offset: Length,
    }
    input s: Length;
    unknown theta: Angle, phi: Angle;
    crank * cis(theta) + rod * cis(phi) == vec2(s, offset);
    with sensitivities;
}

mechanism! {
    /// Two slides: a linear block.
    pub struct SensitiveSlides {
        crank: Length,
        alpha: Angle,
        beta: Angle,
    }
    input theta: Angle;
    unknown s: Length, t: Length;
    s * cis(alpha) + t * cis(beta) == crank * cis(theta);
    with sensitivities;
}

mechanism! {
    /// Watt's six-bar linkage, two blocks.
    pub struct SensitiveWatt {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
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
    with sensitivities;
}

mechanism! {
    /// The inverse of a logarithm, then a quadratic equation.
    pub struct SensitiveLogarithm {
        a: Scalar,
    }
    input t: Scalar;
    unknown x: Scalar;
    ln(x * (x + a)) == t;
    with sensitivities;
}

mechanism! {
    /// Explicit formulas with every function.
    pub struct SensitiveFunctions {
        a: Length,
        b: Length,
    }
    input t: Angle;
    unknown u: Length, v: Angle, w: Scalar, z: Angle;
    u == sqrt(a.powi(2) + b.powi(2) - 2 * a * b * cos(t));
    v == atan2(b * sin(t), a - b * cos(t));
    w == exp(sin(t)) / ln(2 + u / a) + tan(t / 3);
    z == asin(b * sin(t) / (2 * u)) - acos(cos(t) / 2) + atan(w);
    with sensitivities;
}
