//! Tracking of blocks that no closed form fits, where nothing but the determinant tells the assemblies apart.

use core::f64::consts::{PI, TAU};

use kin_core::prelude::*;
use kin_core::{TrackError, track};
use kin_tests::mechanisms::coupled::{Built, Kepler, RelativeDrive, StephensonThree, Triad};
use kin_tests::random::Random;
use kin_tests::samples;

/// Kepler's equation turns back where cos E = 1 / e, if e > 1: one root of three is left there.
#[test]
fn kepler_turns_back() {
    let mut random = Random::new(21);
    for _ in 0..samples::of(200) {
        let eccentricity = random.between(1.01, 6.0);
        let mechanism = Kepler { eccentricity };
        let fold = (1.0 / eccentricity).acos();
        let expected = fold - eccentricity * fold.sin();
        // from the branch through π down to its end
        let Err(TrackError::TurningPoint(limit)) = track(&mechanism, [PI], [PI], [-20.0]) else {
            panic!("{mechanism:?}");
        };
        let tolerance = 8.0 * f64::EPSILON * (1.0 + eccentricity);
        assert!(
            (limit.inputs[0] - expected).abs() <= tolerance,
            "{mechanism:?} {limit:?} {expected}"
        );
        assert_eq!(limit.block, "eccentric");
        assert!((limit.unknowns[0] - fold).abs() <= 1e-12, "{limit:?} {fold}");
        // and the inner branch, from the root at zero, to either side
        for side in [1.0, -1.0] {
            let Err(TrackError::TurningPoint(limit)) = track(&mechanism, [0.0], [0.0], [side * 20.0]) else {
                panic!("{mechanism:?}");
            };
            assert!(
                (limit.inputs[0] + side * expected).abs() <= tolerance,
                "{mechanism:?} {limit:?}"
            );
        }
    }
    // below 1 there is one branch, and many orbits
    let mechanism = Kepler { eccentricity: 0.99 };
    let [end] = track(&mechanism, [0.0], [0.0], [50.0 * TAU]).unwrap();
    assert!((end - 50.0 * TAU).abs() <= 64.0 * f64::EPSILON * 50.0 * TAU / (1.0 - 0.99));
}

/// The motor between crank and coupler turns until ground and rocker are in line:
/// (r1 ± r4)² = r2² + r3² + 2 r2 r3 cos(drive).
#[test]
fn a_relative_drive_stops_where_ground_and_rocker_are_in_line() {
    let mut random = Random::new(22);
    let mut found = 0;
    for round in 0..samples::of(300) {
        let scale = [1e-6, 1.0, 1e6][round % 3];
        let [r1, r2, r3, r4] = [(); 4].map(|()| scale * random.between(0.3, 1.0));
        let mechanism = RelativeDrive { r1, r2, r3, r4 };
        let cosine = |diagonal: f64| (diagonal * diagonal - r2 * r2 - r3 * r3) / (2.0 * r2 * r3);
        let (near, far) = (cosine(r1 + r4).min(1.0), cosine(r1 - r4).max(-1.0));
        if near <= far {
            continue;
        }
        let (low, high) = (near.acos(), far.acos());
        let from = 0.5 * (low + high);
        for assembly in RelativeDrive::<f64>::assemblies() {
            let Ok(start) = Mechanism::position(&mechanism, [from], assembly) else {
                panic!("{mechanism:?}");
            };
            for (end, to) in [(low, -PI), (high, PI + 1.0)] {
                if end < 1e-3 || PI - end < 1e-3 {
                    continue;
                }
                let result = track(&mechanism, [from], start, [to]);
                let Err(TrackError::TurningPoint(limit)) = result else {
                    panic!("{mechanism:?} {assembly:?} {from} {to}: {result:?}");
                };
                let condition = 1.0 + (r1 + r4).powi(2).max(r2 * r2 + r3 * r3) / (2.0 * r2 * r3) / end.sin();
                let tolerance = 16.0 * f64::EPSILON * condition;
                assert!(
                    (limit.inputs[0] - end).abs() <= tolerance,
                    "{mechanism:?} {limit:?} {end}"
                );
                found += 1;
            }
        }
    }
    assert!(found > samples::of(200), "{found}");
}

/// In small steps, as anybody would do it: each position is the guess for the next, halved until rates and steps agree.
fn walk<M: Mechanism<Scalar = f64, Motion<f64> = Motion<f64, 5>>>(
    mechanism: &M,
    from: f64,
    start: M::Unknowns<f64>,
    to: f64,
    steps: u32,
) -> Option<M::Unknowns<f64>> {
    let step = (to - from) / f64::from(steps);
    let mut unknowns = start;
    for number in 0..steps {
        let value = |number: u32| from + step * f64::from(number);
        let motions = M::Inputs::from_fn(|_| Motion::at_constant_speed(value(number), 1.0));
        let rates = mechanism.solve_near(motions, unknowns).ok()?.unknown_motions();
        let guess = M::Unknowns::from_fn(|index| unknowns[index] + rates[index].velocity() * step);
        let next = mechanism
            .position_near(M::Inputs::from_fn(|_| value(number + 1)), guess)
            .ok()?;
        let is_far = (0..guess.as_ref().len()).any(|index| {
            let moved = (guess[index] - unknowns[index]).abs();
            (next[index] - guess[index]).abs() > 0.1 * moved + 10.0 * step.abs()
        });
        if is_far {
            return None;
        }
        unknowns = next;
    }
    Some(unknowns)
}

/// By how much relative changes of the parameters and of the input change the input at which a limit is reached.
fn condition<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    from: f64,
    start: M::Unknowns<f64>,
    to: f64,
    limit: f64,
) -> f64 {
    let inputs = |value: f64| M::Inputs::from_fn(|_| value);
    let parameters = mechanism.parameters();
    let mut condition = limit.abs();
    for changed in 0..parameters.as_ref().len() {
        let change = 1e-7;
        let other = M::from_parameters(M::Parameters::from_fn(|index| {
            parameters[index] * if index == changed { 1.0 + change } else { 1.0 }
        }));
        let Err(TrackError::TurningPoint(there)) = track(&other, inputs(from), start, inputs(to)) else {
            // hardly to be reached
            return f64::INFINITY;
        };
        condition += (there.inputs[0] - limit).abs() / change;
    }
    condition
}

/// Compares tracking with small steps and with the way back.
fn compare<M>(mechanism: &M, from: f64, known: M::Unknowns<f64>, to: f64) -> &'static str
where
    M: Mechanism<Scalar = f64, Motion<f64> = Motion<f64, 5>>,
{
    let inputs = |value: f64| M::Inputs::from_fn(|_| value);
    let Ok(start) = mechanism.position_near(inputs(from), known) else {
        return "no start";
    };
    match track(mechanism, inputs(from), start, inputs(to)) {
        Ok(end) => {
            let back = track(mechanism, inputs(to), end, inputs(from)).unwrap();
            for (one, other) in back.as_ref().iter().zip(start.as_ref()) {
                assert!((one - other).abs() <= 1e-9, "{mechanism:?}: {one} {other}");
            }
            if let Some(walked) = walk(mechanism, from, start, to, 1500) {
                for (one, other) in end.as_ref().iter().zip(walked.as_ref()) {
                    assert!((one - other).abs() <= 1e-9, "{mechanism:?}: {one} {other}");
                }
                "there, and walked"
            } else {
                "there"
            }
        }
        Err(TrackError::TurningPoint(limit)) => {
            let input = limit.inputs[0];
            let unknowns = limit.unknowns;
            for residual in mechanism.closure(limit.inputs, unknowns).as_ref() {
                assert!(residual.abs() <= 64.0 * f64::EPSILON, "{mechanism:?}: {residual}");
            }
            // Short of it the mechanism moves, by the root of what is missing.
            let missing = 1e-8 * (from - to).signum();
            let short = track(mechanism, inputs(from), start, inputs(input + missing)).unwrap();
            let distance = (0..short.as_ref().len())
                .map(|index| (short[index] - unknowns[index]).abs())
                .fold(0.0, f64::max);
            assert!(distance > 1e-7 && distance < 0.1, "{mechanism:?}: {distance}");
            // The other assembly is as far on the other side, and comes to the same end.
            let other = M::Unknowns::from_fn(|index| 2.0 * unknowns[index] - short[index]);
            let other = mechanism.position_near(inputs(input + missing), other).unwrap();
            let apart = (0..short.as_ref().len())
                .map(|index| (short[index] - other[index]).abs())
                .fold(0.0, f64::max);
            assert!(
                (apart / distance - 2.0).abs() < 0.1,
                "{mechanism:?}: {apart} {distance}"
            );
            let Err(TrackError::TurningPoint(again)) = track(mechanism, inputs(input + missing), other, inputs(to))
            else {
                panic!("{mechanism:?}");
            };
            let tolerance = 16.0 * f64::EPSILON * condition(mechanism, from, start, to, input);
            assert!(
                (again.inputs[0] - input).abs() <= tolerance,
                "{mechanism:?} {again:?} {limit:?} {tolerance:e}"
            );
            "limit"
        }
        Err(error) => panic!("{mechanism:?} from {from} to {to}: {error:?}"),
    }
}

#[test]
fn triads() {
    let mut random = Random::new(23);
    let mut tally = std::collections::BTreeMap::new();
    for round in 0..samples::of(50) {
        let [theta, alpha, beta, gamma, phi] = [(); 5].map(|()| random.between(-3.0, 3.0));
        let [a, b, c, p, q] = [(); 5].map(|()| random.between(0.5, 2.0));
        // small cranks often go all the way round
        let crank = if round % 2 == 0 {
            random.between(0.02, 0.2)
        } else {
            random.between(0.5, 2.0)
        };
        let delta = random.between(0.5, 2.0);
        let mechanism = Triad::around([theta, alpha, beta, gamma, phi], [crank, a, b, c, p, q], delta);
        let end = theta + if round % 3 == 0 { -TAU } else { TAU };
        *tally
            .entry(compare(&mechanism, theta, [alpha, beta, gamma, phi], end))
            .or_insert(0) += 1;
    }
    let few = samples::of(50) / 20;
    assert!(tally["there, and walked"] > few && tally["limit"] > few, "{tally:?}");
}

#[test]
fn six_bars_driven_at_the_far_dyad() {
    let mut random = Random::new(24);
    let mut tally = std::collections::BTreeMap::new();
    for round in 0..samples::of(50) {
        let [theta2, theta3, theta5, theta6] = [(); 4].map(|()| random.between(-3.0, 3.0));
        let [r2, r3, r5, x, y, r1] = [(); 6].map(|()| random.between(0.5, 2.0));
        let r6 = if round % 2 == 0 {
            random.between(0.02, 0.2)
        } else {
            random.between(0.5, 2.0)
        };
        let Built {
            mechanism, unknowns, ..
        } = StephensonThree::around([theta2, theta3, theta5, theta6], [r1, r2, r3, r5, r6], Plane::new(x, y));
        *tally
            .entry(compare(&mechanism, theta6, unknowns, theta6 + TAU))
            .or_insert(0) += 1;
    }
    let few = samples::of(50) / 20;
    assert!(tally["there, and walked"] > few && tally["limit"] > few, "{tally:?}");
}
