//! The condition of a position, as a pose tells it: compared with that of the reference, and as a bound on the error of
//! positions of any proportions.

use core::f64::consts::{PI, TAU};

use kin_core::Number as _;
use kin_core::batch::{Column, Outcome};
use kin_core::library::{ClassThreeTriad, ClassThreeTriadBatch, FourBar};
use kin_core::prelude::*;
use kin_core::series::Series;
use kin_precise::Number;
use kin_tests::mechanisms::multi_loop::TwoDyads;
use kin_tests::random::Random;
use kin_tests::reference::{Given, solution};
use kin_tests::samples;

mod chains {
    use kin_core::prelude::*;

    mechanism! {
        /// A slide, and a lever through its pin.
        pub struct Slides { a: Length, b: Length, g: Point, beta: Angle, h: Point }
        input q: Angle;
        unknown u: Angle, s: Length, t: Length, p: Angle;
        order = 1;
        a * cis(q) + b * cis(u) == g + s * cis(beta);
        g + s * cis(beta) == h + t * cis(p);
    }

    mechanism! {
        /// A platform on three legs, by Newton's method.
        pub struct Platform { a: Length, b: Length, c: Length, pivot_b: Point, pivot_c: Point, p: Vector, q: Vector }
        input theta: Angle;
        unknown alpha: Angle, beta: Angle, gamma: Angle, phi: Angle;
        order = 1;
        a * cis(alpha) + p * cis(phi) == pivot_b + b * cis(beta);
        a * cis(alpha) + q * cis(phi) == pivot_c + c * cis(gamma + theta);
    }
}

use chains::{Platform, Slides};

/// A mechanism that closes where its unknowns have given values, up to rounding of its parameters.
struct Closing {
    parameters: Vec<f64>,
    input: f64,
    near: Vec<f64>,
}

fn at(length: f64, angle: f64) -> Plane {
    let (sine, cosine) = angle.sin_cos();
    Plane::new(length * cosine, length * sine)
}

fn two_dyads(random: &mut Random, length: &dyn Fn(&mut Random) -> f64) -> Closing {
    let [a, b, c, d, e] = [0; 5].map(|_| length(random));
    let w = Plane::new(length(random), length(random));
    let [q, u, v, x, y] = [0; 5].map(|_| random.between(-PI, PI));
    let g = at(a, q) + at(b, u) - at(c, v);
    let h = at(a, q) + w.times(at(1.0, u)) + at(d, x) - at(e, y);
    Closing {
        parameters: vec![a, b, g.x, g.y, c, w.x, w.y, d, h.x, h.y, e],
        input: q,
        near: vec![u, v, x, y],
    }
}

fn slides(random: &mut Random, length: &dyn Fn(&mut Random) -> f64) -> Closing {
    let [a, b, s, t] = [0; 4].map(|_| length(random));
    let [q, u, beta, p] = [0; 4].map(|_| random.between(-PI, PI));
    let g = at(a, q) + at(b, u) - at(s, beta);
    let h = g + at(s, beta) - at(t, p);
    Closing {
        parameters: vec![a, b, g.x, g.y, beta, h.x, h.y],
        input: q,
        near: vec![u, s, t, p],
    }
}

fn platform(random: &mut Random, length: &dyn Fn(&mut Random) -> f64) -> Closing {
    let [a, b, c] = [0; 3].map(|_| length(random));
    let [p, q] = [0; 2].map(|_| Plane::new(length(random), length(random)));
    let [alpha, beta, gamma, phi, theta] = [0; 5].map(|_| random.between(-PI, PI));
    let pivot_b = at(a, alpha) + p.times(at(1.0, phi)) - at(b, beta);
    let pivot_c = at(a, alpha) + q.times(at(1.0, phi)) - at(c, gamma + theta);
    Closing {
        parameters: vec![a, b, c, pivot_b.x, pivot_b.y, pivot_c.x, pivot_c.y, p.x, p.y, q.x, q.y],
        input: theta,
        near: vec![alpha, beta, gamma, phi],
    }
}

/// How far positions are off.
#[derive(Debug, Default)]
struct Worst {
    poses: usize,
    /// The largest error of any unknown, in units of ε times its condition.
    error: f64,
    /// The largest residual of any equation, in units of ε times its change if the unknowns change by their conditions.
    closure: f64,
    /// The largest condition.
    condition: f64,
}

/// Units of ε times the condition by which positions may be off, as their differences in batches may.
const ALLOWED: f64 = 4.0;

/// The same where links of one dyad differ by any factor. Rounding of the long vectors then makes the vector of a short
/// link as far off in its length as in its direction, and the condition counts the direction alone. The worst of 9000
/// such positions is off by 54 units.
const ALLOWED_OF_EXTREMES: f64 = 64.0;

/// Mechanisms whose lengths are spread over so many powers of ten to either side of 1.
fn survey<M: Mechanism<Scalar = f64>>(
    powers: f64,
    closing: impl Fn(&mut Random, &dyn Fn(&mut Random) -> f64) -> Closing,
) -> Worst
where
    M::Pose: PoseOf<M>,
{
    let mut random = Random::new(5);
    let length = |random: &mut Random| 10_f64.powf(random.between(-powers, powers));
    let mut worst = Worst::default();
    for _ in 0..samples::of(240) {
        let Closing {
            parameters,
            input,
            near,
        } = closing(&mut random, &length);
        let mechanism = M::from_parameters(Row::from_fn(|place| parameters[place]));
        let inputs = M::Inputs::from_fn(|_| M::Motion::from_fn(|order| if order == 0 { input } else { 1.0 }));
        // Rounding of the parameters alone may put the last links out of reach.
        let Ok(pose) = mechanism.solve_near(inputs, Row::from_fn(|place| near[place])) else {
            continue;
        };
        let conditions = mechanism.conditions(&pose);
        let position = pose.unknowns();
        let given = Given {
            parameters,
            inputs: vec![vec![input, 1.0]],
        };
        let Ok(reference) = solution::<M>(&given, position.as_ref()) else {
            continue;
        };
        worst.poses += 1;
        let condition = mechanism.condition(&pose);
        worst.condition = worst.condition.max(condition);
        for (place, own) in conditions.as_ref().iter().enumerate() {
            let expected = reference.conditions[place][0];
            // It is calculated from a matrix that has this condition itself.
            let exact = 1.0 + 64.0 * f64::EPSILON * condition;
            assert!(
                (1.0 / exact..=exact).contains(&(own / expected)) || condition > 1e14,
                "{}, {given:?}: condition {own:e} for {expected:e}",
                M::DESCRIPTION.name
            );
            let error = &Number::exactly(position[place]) - &reference.motions[place][0];
            worst.error = worst.error.max(error.nearest().abs() / (f64::EPSILON * own));
        }
        for (left, unit) in closure(&mechanism, input, position.as_ref(), conditions.as_ref()) {
            worst.closure = worst.closure.max(left.abs() / (f64::EPSILON * unit));
        }
    }
    println!("{}, 1e±{powers}: {worst:.2?}", M::DESCRIPTION.name);
    worst
}

/// The residual of each equation, and the change of it if the unknowns change by their conditions.
fn closure<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    input: f64,
    position: &[f64],
    conditions: &[f64],
) -> Vec<(f64, f64)> {
    let left = |changed: Option<usize>| -> Vec<[f64; 2]> {
        let residuals = mechanism.convert(Series::<2>::constant).closure(
            Row::from_fn(|_| Series::constant(input)),
            Row::from_fn(|place| {
                let rate = if changed == Some(place) { 1.0 } else { 0.0 };
                Series::from_coefficients([position[place], rate])
            }),
        );
        residuals.as_ref().iter().map(Series::coefficients).collect()
    };
    let mut both: Vec<(f64, f64)> = left(None).iter().map(|[left, _]| (*left, 0.0)).collect();
    for (place, condition) in conditions.iter().enumerate() {
        for ((_, unit), [_, entry]) in both.iter_mut().zip(left(Some(place))) {
            *unit += entry.abs() * condition;
        }
    }
    both
}

#[test]
fn positions_are_known_to_their_condition() {
    for worst in [
        survey::<TwoDyads<f64>>(1.0, two_dyads),
        survey::<Slides<f64>>(1.0, slides),
        survey::<Platform<f64>>(1.0, platform),
    ] {
        assert!(6 * worst.poses >= 5 * samples::of(240), "{worst:?}");
        assert!(worst.error <= ALLOWED && worst.closure <= ALLOWED, "{worst:?}");
    }
}

#[test]
fn positions_of_extreme_proportions_are_known_to_their_condition() {
    for worst in [
        survey::<TwoDyads<f64>>(8.0, two_dyads),
        survey::<Slides<f64>>(8.0, slides),
        survey::<Platform<f64>>(8.0, platform),
    ] {
        assert!(
            3 * worst.poses >= 2 * samples::of(240) && worst.condition > 1e14,
            "{worst:?}"
        );
        assert!(
            worst.error <= ALLOWED_OF_EXTREMES && worst.closure <= ALLOWED_OF_EXTREMES,
            "{worst:?}"
        );
    }
}

const LINKAGE: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};

fn single() -> FourBar<f32> {
    FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    }
}

/// The condition grows as the angle between the links shrinks, and a position in single precision has the same.
#[test]
fn conditions_next_to_a_limit() -> Result<(), SolveError> {
    let limit = LINKAGE.crank_range().expect("it has one").high;
    for exponent in 1..=12 {
        let crank = limit - 10_f64.powi(-exponent);
        let position = LINKAGE.position(crank, Assembly::Open)?;
        let condition = LINKAGE.condition(&position);
        let [theta3, theta4] = position.unknowns();
        let expected = 1.0 / (theta3 - theta4).sin().abs();
        assert!((1.0..20.0).contains(&(condition / expected)), "{condition} {expected}");
        // A pose of any order has the condition of its position.
        let velocity = position.velocity(2.0);
        assert_eq!(LINKAGE.conditions(&velocity), LINKAGE.conditions(&position));
    }
    let single = single();
    let [theta3, theta4] = single.conditions(&single.position(1.0, Assembly::Open)?);
    let [expected3, expected4] = LINKAGE.conditions(&LINKAGE.position(1.0, Assembly::Open)?);
    assert!((theta3 / expected3 - 1.0).abs() < 1e-5 && (theta4 / expected4 - 1.0).abs() < 1e-5);
    Ok(())
}

#[test]
fn turns_on_which_angles_tell_no_direction() {
    let near = LINKAGE.position(1.0, Assembly::Open).expect("it closes").unknowns();
    // Each turn costs digits, as the condition says; the closure holds as far as an angle of this size can make it.
    for turns in [0.0, 1e3, 1e6, 1e9, 1e12] {
        let far = near.map(|angle| angle + turns * TAU);
        let position = LINKAGE.position_near(1.0, far).expect("angles still tell a direction");
        assert!((position.theta4.position() - far[1]).abs() < 0.01);
        let [_, theta4] = LINKAGE.conditions(&position);
        assert!(theta4 >= far[1].abs());
        let unit = f64::EPSILON * LINKAGE.condition(&position) * 90.0;
        for left in LINKAGE.closure(1.0, position.unknowns()) {
            assert!(left.abs() <= unit, "{turns}: {left:e} of {unit:e}");
        }
    }
    for (turns, spacing) in [(2e13, 0.015_625), (1e15, 1.0), (1e18, 1024.0)] {
        let far = [near[0], near[1] - turns * TAU];
        let error = LINKAGE.position_near(1.0, far).expect_err("no angle is a solution");
        let expected = Failure::TooManyRevolutions {
            unknown: "theta4".into(),
            guess: far[1],
            spacing,
        };
        assert_eq!((error.failure, error.block), (expected, "theta3, theta4".into()));
        assert_eq!(LINKAGE.solve_near(Motion::at_constant_speed(1.0, 2.0), far), Err(error));
    }
    // NaN is no guess, and guesses in single precision are lost sooner.
    assert!(LINKAGE.position_near(1.0, [f64::NAN, near[1]]).is_ok());
    let single = single();
    assert!(single.position_near(1.0, [1e5, 0.0]).is_ok());
    let error = single
        .position_near(1.0, [2e5, 0.0])
        .expect_err("no angle is a solution");
    let expected = Failure::TooManyRevolutions {
        unknown: "theta3".into(),
        guess: 2e5,
        spacing: 0.015_625,
    };
    assert_eq!(error.failure, expected);
}

/// Newton's method would call any such angle a root: no step is larger than the distance of the numbers there.
#[test]
fn turns_on_which_newtons_method_finds_nothing() {
    let root = 3.0_f64.sqrt();
    let triad = ClassThreeTriad {
        base_b: Plane::new(2.0 * root, 0.0),
        base_c: Plane::new(root, 3.0),
        platform_b: Plane::new(root, 0.0),
        platform_c: Plane::new(root / 2.0, 1.5),
    };
    let leg = 5.0_f64.sqrt();
    let near = [0.1, 2.2, -2.0, 1.6];
    let position = triad.position(leg, leg, leg, Near(near)).expect("it closes");
    let name = ClassThreeTriad::<f64>::DESCRIPTION.unknowns[2].name;
    let far = [near[0], near[1], near[2] + 1e15 * TAU, near[3]];
    let error = triad
        .position(leg, leg, leg, Near(far))
        .expect_err("no angle is a solution");
    assert!(
        matches!(error.failure, Failure::TooManyRevolutions { unknown, .. } if unknown == name),
        "{error}"
    );

    // In a batch, beside others.
    let guesses: Vec<f64> = (0..32)
        .map(|pose| if pose % 5 == 3 { far[2] } else { near[2] })
        .collect();
    let mut poses = ClassThreeTriadBatch::filled(|| vec![0.0; 32]);
    let mut outcomes = [Outcome::Unsolved; 32];
    let legs = [0; 3].map(|_| Motion::at_constant_speed(leg, 0.0).map(Column::Same));
    let mut columns = near.map(Column::Same);
    columns[2] = Column::Each(&guesses);
    let summary = triad
        .batch(legs[0], legs[1], legs[2], columns)
        .solve(&mut poses, &mut outcomes)
        .expect("the columns are of one length");
    assert_eq!(summary.failed, 6);
    assert_eq!(summary.first_failure, Some((3, error)));
    let expected = position.unknowns()[0];
    for (pose, outcome) in outcomes.iter().enumerate() {
        if pose % 5 == 3 {
            assert_eq!(*outcome, Outcome::Failed);
        } else {
            assert_eq!(*outcome, Outcome::Solved);
            assert!((poses.alpha[0][pose] - expected).abs() < 1e-14);
        }
    }
}
