//! The units of error of `verify`: right mechanisms near double roots, poles and branch cuts pass, and a derivative
//! that is wrong in its seventh digit does not.
#![allow(missing_docs)]

use std::f64::consts::PI;

use kin_core::prelude::*;
use kin_core::verify::{self, Gauge, Random, Sampling, allowed};
use kin_core::{Dimension, Quantity};

/// Declares mechanisms of one equation, and a test that they are verified, whatever the seed.
macro_rules! one_equation {
    ($test:ident: $(
        $name:ident($($length:ident)*) $input:ident -> $unknown:ident, |$t:ident, $x:ident| $left:expr, $right:expr;
    )*) => {
        $(
            mechanism! {
                pub struct $name { $($length: Length,)* }
                input $t: $input;
                unknown $x: $unknown;
                $left == $right;
            }
        )*

        #[test]
        fn $test() {
            for seed in 1..=4 {
                let sampling = Sampling { seed, ..Sampling::default() };
                $(sampling.mechanism::<$name>().assert();)*
            }
        }
    };
}

// The closed form finds a root of the polynomial that is multiplied out, whose discriminant is small where two roots
// are near.
one_equation! { near_a_double_root:
    TwoLengths(a b) Scalar -> Length, |t, x| (x - a * t) * (x - b), 0;
    TwoAngles(a b) Angle -> Angle, |t, x| (x - t) * (x - a / b), 0;
    TwoNumbers(a b) Scalar -> Scalar, |t, x| (x - t) * (x - a / b), 0;
    ThreeLengths(a b c) Scalar -> Length, |t, x| (x - a * t) * (x - b) * (x - c), 0;
    FourLengths(a b c) Scalar -> Length, |t, x| (x - a * t) * (x - b) * (x - c) * (x + a), 0;
    Squares(a b) Scalar -> Length, |t, x| (x * x - a * a * t * t) * (x - b), 0;
    Sines(a b) Angle -> Angle, |t, x| (sin(x) - sin(t)) * (sin(x) - a / (a + b)), 0;
}

// Differentiation begins with an unknown that stands still, and the power of the moving rest is steep.
one_equation! { high_powers:
    Third(a v) Angle -> Angle, |t, x| powi(norm(v * cis(x) - a * cis(t)), 3), powi(a, 3);
    Sixth(a v) Angle -> Angle, |t, x| powi(norm(v * cis(x) - a * cis(t)), 6), powi(a, 6);
    Eighth(a v) Angle -> Angle, |t, x| powi(norm(v * cis(x) - a * cis(t)), 8), powi(a, 8);
    EighthOfAnother(a b v) Angle -> Angle, |t, x| powi(norm(v * cis(x) - a * cis(t)), 8), powi(b, 8);
    Twelfth(a v) Angle -> Angle, |t, x| powi(norm(v * cis(x) - a * cis(t)), 12), powi(a, 12);
    Fourth(a v) Angle -> Angle, |t, x| powi(norm(v * cis(x) - a * cis(t)), -4), powi(a, -4);
}

// The derivatives divide by what vanishes at the end of a domain, at a pole, or where a vector has no angle.
one_equation! { near_the_end_of_a_domain:
    HalfTheAngle(a) Angle -> Angle, |t, x| atan2(a * sin(x), a + a * cos(x)), t;
    PartOfTheAngle(a b) Angle -> Angle, |t, x| atan2(a * sin(x), b + a * cos(x)), t;
    Eccentric(a b) Angle -> Angle, |t, x| atan2(a * sin(x) + b * sin(2 * x), a * cos(x) + b), t;
    ArcSine(a b) Scalar -> Scalar, |t, x| asin(x * a / b), t;
    ArcCosine(a b) Scalar -> Scalar, |t, x| acos(x * a / b), t;
    AreaCosine(a b) Scalar -> Scalar, |t, x| acosh(1 + x * x), t * a / b;
    Logarithm(a b) Scalar -> Scalar, |t, x| ln(x * a / b), t;
    Root(a) Scalar -> Length, |t, x| sqrt(x * x + a * a) - a, a * powi(t, 2);
    Quotient(a b) Scalar -> Length, |t, x| (x + a) / (x - b), t;
    Reciprocal(a b) Scalar -> Length, |t, x| a * a / x + x, b * t;
}

mechanism! {
    pub struct Linkage { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == vec2(r1, 0) + r4 * cis(theta4);
}

mechanism! {
    pub struct Crank { r: Length, l: Length }
    input theta: Angle;
    unknown phi: Angle, s: Length;
    r * cis(theta) + l * cis(phi) == vec2(s, 0);
}

mechanism! {
    pub struct Inverted { r1: Length, r2: Length }
    input theta: Angle;
    unknown s: Length, phi: Angle;
    vec2(r1, 0) + r2 * cis(theta) == s * cis(phi);
}

mechanism! {
    pub struct Rod { r: Length, l: Length, b: Length }
    input theta: Angle;
    unknown phi: Angle;
    norm(vec2(l, 0) + b * cis(phi) - r * cis(theta)) == l;
}

mechanism! {
    pub struct Freudenstein { k1: Scalar, k2: Scalar, k3: Scalar }
    input t: Angle;
    unknown p: Angle;
    k1 * cos(p) - k2 * cos(t) + k3 == cos(t - p);
}

mechanism! {
    pub struct Kepler { e: Scalar }
    input m: Angle;
    unknown x: Angle;
    x + e / 20 * sin(x) == m;
}

mechanism! {
    pub struct Hyperbolas { a: Length, b: Length }
    input t: Scalar;
    unknown x: Length, y: Length;
    x / y == t;
    x * y == a * b;
}

mechanism! {
    pub struct Cubic { a: Length }
    input t: Length;
    unknown x: Length;
    powi(x, 3) + powi(a, 2) * x == powi(t, 3);
}

const POSES: usize = 200;
/// The change of a derivative: in its seventh digit.
const CHANGE: f64 = 1e-7;

/// Derivatives of unknowns that are wrong in the seventh digit, and what the oracles find of them.
#[derive(Default)]
struct Mutants {
    /// At any pose: how many there are, and how many differentiation and the closure find.
    all: usize,
    found: [usize; 2],
    /// The smallest share of poses at which an oracle finds those of a mechanism, by mechanism.
    shares: Vec<(&'static str, f64)>,
}

impl Mutants {
    fn count<M: Mechanism<Scalar = f64, Motion<f64> = Motion<f64, 5>>>(&mut self) {
        let unknowns = M::DESCRIPTION.unknowns.len();
        let poses = poses::<M>();
        assert_eq!(poses.len(), POSES, "{}", M::DESCRIPTION.name);
        let mut hits = [0; 2];
        for index in 0..unknowns {
            for order in 0..5 {
                let mut caught = [0; 2];
                for (mechanism, inputs, right) in &poses {
                    let gauge = Gauge::new(mechanism, inputs, right);
                    let wrong = M::Unknowns::from_fn(|other| {
                        let motion: Motion<f64, 5> = right[other];
                        let mut derivatives = motion.derivatives();
                        if other == index {
                            derivatives[order] *= 1.0 + CHANGE;
                        }
                        Motion::new(derivatives)
                    });
                    let motion: Motion<f64, 5> = right[index];
                    let error = motion.derivatives()[order].abs() * CHANGE;
                    let residuals = verify::closure(mechanism, inputs, &wrong);
                    let has_rest = residuals.iter().enumerate().any(|(equation, orders)| {
                        orders
                            .iter()
                            .enumerate()
                            .any(|(order, left)| left.abs() > allowed(order) * gauge.equation(equation, order))
                    });
                    caught[0] += usize::from(error > allowed(order) * gauge.unknown(index, order));
                    caught[1] += usize::from(has_rest);
                }
                self.all += 1;
                for ((found, hits), caught) in self.found.iter_mut().zip(&mut hits).zip(caught) {
                    *found += usize::from(caught > 0);
                    *hits += caught;
                }
            }
        }
        let tried = f64::from(u32::try_from(poses.len() * unknowns * 5).expect("there are few"));
        let share = hits.map(|hits| f64::from(u32::try_from(hits).expect("there are few")) / tried);
        self.shares.push((M::DESCRIPTION.name, share[0].min(share[1])));
    }
}

/// A number from the decade around 1.
fn size(random: &mut Random) -> f64 {
    10_f64.powf(random.between(-0.5, 0.5))
}

fn any(random: &mut Random, quantity: &Quantity) -> f64 {
    match quantity.dimension {
        Dimension::Angle => random.between(-PI, PI),
        Dimension::Length | Dimension::Scalar => size(random) * random.between(-1.0, 1.0).signum(),
    }
}

type Drawn<M> = (M, verify::Inputs<M>, verify::Unknowns<M>);

/// Poses of random mechanisms in random motions, in every assembly or near a random guess.
fn poses<M: Mechanism<Scalar = f64, Motion<f64> = Motion<f64, 5>>>() -> Vec<Drawn<M>> {
    let description = M::DESCRIPTION;
    let mut random = Random::new(5);
    let mut poses = Vec::new();
    for _ in 0..20 * POSES {
        let mechanism = M::from_parameters(M::Parameters::from_fn(|index| {
            let quantity = &description.parameters[index];
            let value = any(&mut random, quantity);
            if quantity.dimension == Dimension::Length {
                value.abs()
            } else {
                value
            }
        }));
        let values = M::Inputs::from_fn(|index| any(&mut random, &description.inputs[index]));
        let inputs = M::Inputs::from_fn(|index| {
            let rate = size(&mut random);
            let mut derivatives = [values[index]; 5];
            let mut power = 1.0;
            for derivative in &mut derivatives[1..] {
                power *= rate;
                *derivative = power * random.between(-1.0, 1.0);
            }
            Motion::new(derivatives)
        });
        let mut assemblies: Vec<M::Assembly> = M::assemblies().collect();
        if M::ASSEMBLY_COUNT == 0 {
            let guess = M::Unknowns::from_fn(|index| any(&mut random, &description.unknowns[index]));
            let found = mechanism.position_near(values, guess);
            assemblies.extend(found.map(|found| mechanism.assembly_at(values, found)));
        }
        for assembly in assemblies {
            if let Ok(pose) = mechanism.solve(inputs, assembly) {
                poses.push((mechanism, inputs, pose.unknown_motions()));
            }
        }
    }
    poses.truncate(POSES);
    poses
}

/// Where nothing is singular, nearly every pose shows it.
#[test]
fn every_wrong_derivative_is_found_by_both_oracles() {
    let mut regular = Mutants::default();
    regular.count::<Linkage>();
    regular.count::<Crank>();
    regular.count::<Inverted>();
    regular.count::<Rod>();
    regular.count::<Freudenstein>();
    regular.count::<Kepler>();
    regular.count::<Hyperbolas>();
    regular.count::<Cubic>();
    for (name, share) in &regular.shares {
        assert!(*share >= 0.99, "{name}: found at {share} of the poses");
    }
    let mut singular = Mutants::default();
    singular.count::<TwoLengths>();
    singular.count::<Eighth>();
    singular.count::<HalfTheAngle>();
    singular.count::<PartOfTheAngle>();
    singular.count::<Eccentric>();
    singular.count::<Twelfth>();
    singular.count::<ArcSine>();
    singular.count::<Quotient>();
    // One of two roots stands still, where a derivative of zero cannot be wrong.
    for (name, share) in singular.shares.iter().filter(|(name, _)| *name != "TwoLengths") {
        assert!(*share >= 0.97, "{name}: found at {share} of the poses");
    }
    for mutants in [regular, singular] {
        println!("{:?} of {} are found: {:?}", mutants.found, mutants.all, mutants.shares);
        assert_eq!(mutants.found, [mutants.all; 2], "{:?}", mutants.shares);
    }
}
