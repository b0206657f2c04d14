//! Mechanisms with blocks that no closed form fits.

use kin_core::prelude::*;

use crate::random::Random;

/// A mechanism built around a position that was chosen at random.
#[derive(Clone, Copy, Debug)]
pub struct Built<M, const UNKNOWNS: usize> {
    /// Its dimensions.
    pub mechanism: M,
    /// The value of its input.
    pub input: f64,
    /// The values of its unknowns.
    pub unknowns: [f64; UNKNOWNS],
}

fn at(length: f64, angle: f64) -> Plane {
    Plane::new(length * angle.cos(), length * angle.sin())
}

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
    with sensitivities;
}

mechanism! {
    /// A four-bar driven by a motor between crank and coupler.
    #[allow(missing_docs)]
    pub struct RelativeDrive { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
    input drive: Angle;
    unknown theta2: Angle, theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    theta3 - theta2 == drive;
    with sensitivities;
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
    with sensitivities;
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
    with sensitivities;
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
    with sensitivities;
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
    with sensitivities;
}

mechanism! {
    /// The same six, turned by a gear, with a yoke that moves with one of them.
    #[allow(missing_docs)]
    pub struct SixInChain {
        pub ratio: Scalar,
        pub side: Length,
        pub leg: Length,
        pub tie: Length,
        pub radius: Length,
        pub throw: Length,
    }
    input drive: Angle;
    unknown theta: Angle, a: Angle, b: Angle, c: Angle, d: Angle, e: Angle, f: Angle, yoke: Length;
    theta == ratio * drive;
    let first = polar(radius, 0) + leg * cis(a);
    let second = polar(radius, 2 * PI / 3) + leg * cis(b);
    let third = polar(radius, 4 * PI / 3) + leg * cis(c);
    first + side * cis(d) + tie * cis(e) == second;
    second + side * cis(e) + tie * cis(f) == third;
    third + side * cis(f) + tie * cis(d + theta) == first;
    yoke == throw * sin(b + d);
    output middle: Point = second + side / 2 * cis(e);
    with sensitivities;
}

impl Kepler {
    /// Any position.
    pub fn built(random: &mut Random) -> Built<Self, 1> {
        let eccentricity = random.between(0.0, 0.95);
        let eccentric = random.between(-10.0, 10.0);
        Built {
            mechanism: Self { eccentricity },
            input: eccentric - eccentricity * eccentric.sin(),
            unknowns: [eccentric],
        }
    }
}

impl Triad {
    /// Any position.
    pub fn built(random: &mut Random) -> Built<Self, 4> {
        let [theta, alpha, beta, gamma, phi] = [(); 5].map(|()| random.between(-3.0, 3.0));
        let [crank, a, b, c, p, q] = [(); 6].map(|()| random.between(0.5, 2.0));
        let delta = random.between(0.5, 2.0);
        Built {
            mechanism: Self::around([theta, alpha, beta, gamma, phi], [crank, a, b, c, p, q], delta),
            input: theta,
            unknowns: [alpha, beta, gamma, phi],
        }
    }

    /// The triad of given links that closes at given angles.
    #[must_use]
    pub fn around([theta, alpha, beta, gamma, phi]: [f64; 5], [crank, a, b, c, p, q]: [f64; 6], delta: f64) -> Self {
        let joint = at(crank, theta) + at(a, alpha);
        Self {
            crank,
            a,
            b,
            c,
            p,
            q,
            delta,
            pivot_b: joint + at(p, phi) - at(b, beta),
            pivot_c: joint + at(q, phi + delta) - at(c, gamma),
        }
    }
}

impl StephensonThree {
    /// Any position.
    pub fn built(random: &mut Random) -> Built<Self, 4> {
        let [theta2, theta3, theta5, theta6] = [(); 4].map(|()| random.between(-3.0, 3.0));
        let [r2, r3, r5, r6, x, y] = [(); 6].map(|()| random.between(0.5, 2.0));
        let r1 = random.between(0.5, 2.0);
        Self::around([theta2, theta3, theta5, theta6], [r1, r2, r3, r5, r6], Plane::new(x, y))
    }

    /// The linkage of given links that closes at given angles, with the rocker that it needs for that.
    #[must_use]
    pub fn around(
        [theta2, theta3, theta5, theta6]: [f64; 4],
        [r1, r2, r3, r5, r6]: [f64; 5],
        coupler_point: Plane,
    ) -> Built<Self, 4> {
        let rocker = at(r2, theta2) + at(r3, theta3) - Plane::new(r1, 0.0);
        Built {
            mechanism: Self {
                r1,
                r2,
                r3,
                r4: rocker.x.hypot(rocker.y),
                coupler_point,
                r5,
                r6,
                pivot: at(r2, theta2) + coupler_point.times(at(1.0, theta3)) + at(r5, theta5) - at(r6, theta6),
            },
            input: theta6,
            unknowns: [theta2, theta3, rocker.y.atan2(rocker.x), theta5],
        }
    }
}

impl GearedPair {
    /// Any position.
    pub fn built(random: &mut Random) -> Built<Self, 3> {
        let [theta2, theta3] = [(); 2].map(|()| random.between(-3.0, 3.0));
        let [r1, r3, r4, ratio] = [(); 4].map(|()| random.between(0.5, 2.0));
        let phase = 0.3;
        let theta4 = ratio * theta2 + phase;
        // the crank's length from the y part
        let r2 = (r4 * theta4.sin() - r3 * theta3.sin()) / theta2.sin();
        let s = r2 * theta2.cos() + r3 * theta3.cos() - r1 - r4 * theta4.cos();
        Built {
            mechanism: Self {
                r1,
                r2,
                r3,
                r4,
                ratio,
                phase,
            },
            input: theta3,
            unknowns: [theta2, theta4, s],
        }
    }
}

impl SixCoupled {
    /// A position near the one that looks the same from all three sides, which it has where the input is zero: side and
    /// tie close there as two sides of a triangle do, and two more such triangles are this one turned by a third.
    pub fn built(random: &mut Random) -> Built<Self, 6> {
        let third = 2.0 * std::f64::consts::FRAC_PI_3;
        let [radius, leg, ratio] = [(); 3].map(|()| random.between(0.5, 2.0));
        let a = random.between(-3.0, 3.0);
        let first = Plane::new(radius, 0.0) + at(leg, a);
        let span = first.times(at(1.0, third)) - first;
        let links = Plane::new(1.0, 0.0) + at(ratio, third);
        let side = (span.norm_squared() / links.norm_squared()).sqrt();
        let d = span.y.atan2(span.x) - links.y.atan2(links.x);
        let symmetric = [a, a + third, a + 2.0 * third, d, d + third, d + 2.0 * third];
        let mechanism = Self {
            side,
            leg,
            tie: side * ratio,
            radius,
        };
        let input = random.between(-0.1, 0.1);
        let unknowns = mechanism
            .position_near(input, symmetric)
            .map_or(symmetric, |position| position.unknowns());
        Built {
            mechanism,
            input,
            unknowns,
        }
    }
}

impl SixInChain {
    /// A random mechanism around a block of six.
    pub fn built(random: &mut Random) -> Built<Self, 8> {
        let six = SixCoupled::built(random);
        let SixCoupled { side, leg, tie, radius } = six.mechanism;
        let [ratio, throw] = [(); 2].map(|()| random.between(0.5, 2.0));
        let [a, b, c, d, e, f] = six.unknowns;
        Built {
            mechanism: Self {
                ratio,
                side,
                leg,
                tie,
                radius,
                throw,
            },
            input: six.input / ratio,
            unknowns: [six.input, a, b, c, d, e, f, throw * (b + d).sin()],
        }
    }
}
