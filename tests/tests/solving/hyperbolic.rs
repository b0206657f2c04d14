//! The hyperbolic functions and their inverses: in numbers, in mechanisms of every closed form, and by Newton's method.
//!
//! The worst errors are printed: `cargo test -p kin-tests --test solving hyperbolic -- --nocapture`.

use kin_core::TrackError;
use kin_core::batch::Outcome;
use kin_core::prelude::*;
use kin_precise::Number;
use kin_tests::batches::{Poses, vectors};
use kin_tests::mechanisms::cases::{Case, ThroughSnap, Visitor};
use kin_tests::mechanisms::hyperbolic::{self, *};
use kin_tests::mechanisms::sensitive::{self, SensitiveThroughSnap};
use kin_tests::oracles::{Reported, Worst};
use kin_tests::random::Random;
use kin_tests::reference::{Errors, Given};
use kin_tests::{samples, sensitivities};

/// As many units of error are allowed against the reference, at every order: those of `docs/accuracy.md`.
const ALLOWED: f64 = 8.0;

/// A function in both kinds of numbers, and in 77 digits.
struct Function {
    name: &'static str,
    double: fn(f64) -> f64,
    single: fn(f32) -> f32,
    precise: fn(&Number) -> Number,
    /// From where to where the size of the argument goes, beyond an offset.
    sizes: (f64, f64),
    offset: f64,
    is_symmetric: bool,
}

/// From 10⁻³⁰ to the ends of the domains, and near them.
const FUNCTIONS: [Function; 8] = [
    Function {
        name: "sinh",
        double: kin_core::Number::sinh,
        single: kin_core::Number::sinh,
        precise: |x| x.sinh_cosh().0,
        sizes: (1e-30, 80.0),
        offset: 0.0,
        is_symmetric: true,
    },
    Function {
        name: "cosh",
        double: kin_core::Number::cosh,
        single: kin_core::Number::cosh,
        precise: |x| x.sinh_cosh().1,
        sizes: (1e-30, 80.0),
        offset: 0.0,
        is_symmetric: true,
    },
    Function {
        name: "tanh",
        double: kin_core::Number::tanh,
        single: kin_core::Number::tanh,
        precise: Number::tanh,
        sizes: (1e-30, 80.0),
        offset: 0.0,
        is_symmetric: true,
    },
    Function {
        name: "asinh",
        double: kin_core::Number::asinh,
        single: kin_core::Number::asinh,
        precise: Number::asinh,
        sizes: (1e-30, 1e30),
        offset: 0.0,
        is_symmetric: true,
    },
    Function {
        name: "acosh near 1",
        double: kin_core::Number::acosh,
        single: kin_core::Number::acosh,
        precise: Number::acosh,
        sizes: (1e-15, 1.0),
        offset: 1.0,
        is_symmetric: false,
    },
    Function {
        name: "acosh",
        double: kin_core::Number::acosh,
        single: kin_core::Number::acosh,
        precise: Number::acosh,
        sizes: (1.0, 1e30),
        offset: 0.0,
        is_symmetric: false,
    },
    Function {
        name: "atanh",
        double: kin_core::Number::atanh,
        single: kin_core::Number::atanh,
        precise: Number::atanh,
        sizes: (1e-30, 0.999),
        offset: 0.0,
        is_symmetric: true,
    },
    Function {
        name: "atanh near 1",
        double: kin_core::Number::atanh,
        single: kin_core::Number::atanh,
        precise: Number::atanh,
        sizes: (-1e-3, -1e-15),
        offset: 1.0,
        is_symmetric: true,
    },
];

/// No digit is lost, near zero and near the ends of the domains: the errors are within units of the last places.
#[test]
fn functions_are_exact_to_the_last_digits() {
    let mut random = Random::new(7);
    for function in &FUNCTIONS {
        let mut worst = [0.0_f64; 2];
        for _ in 0..samples::of(2000) {
            let (low, high) = function.sizes;
            let logarithm = random.between(low.abs().ln(), high.abs().ln());
            let x = function.offset + logarithm.exp().copysign(low);
            let x = if function.is_symmetric && random.between(0.0, 1.0) < 0.5 {
                -x
            } else {
                x
            };
            let expected = (function.precise)(&Number::exactly(x));
            let error = (&Number::exactly((function.double)(x)) - &expected).nearest();
            // the last places are counted from the expected value, which is not zero
            let of = |expected: &Number| expected.nearest().abs();
            if !expected.is_zero() {
                worst[0] = worst[0].max(error.abs() / (f64::EPSILON * of(&expected)));
            }
            #[expect(
                clippy::cast_possible_truncation,
                reason = "the nearest single-precision number is meant"
            )]
            let single = x as f32;
            let value = f64::from((function.single)(single));
            // the number nearest to one near an end may lie on the end
            if f64::from(single).abs() == 1.0 && function.offset == 1.0 {
                continue;
            }
            let expected = (function.precise)(&Number::exactly(f64::from(single)));
            let error = (&Number::exactly(value) - &expected).nearest();
            if !expected.is_zero() {
                worst[1] = worst[1].max(error.abs() / (f64::from(f32::EPSILON) * of(&expected)));
            }
        }
        println!(
            "{:14} {:.2} ε in double precision, {:.2} ε in single",
            function.name, worst[0], worst[1]
        );
        assert!(worst.iter().all(|worst| *worst <= 2.0), "{}: {worst:?}", function.name);
    }
}

/// A grid of inputs with random rates; dimensions vary.
fn grid<M: ThroughSnap>(sizes: usize, case: Case, mut look: impl FnMut(&M, M::Inputs<Motion<f64, 5>>, M::Assembly)) {
    let mut random = Random::new(M::DESCRIPTION.name.bytes().map(u64::from).sum());
    for _ in 0..sizes {
        let mechanism: M = case.varied(&mut random);
        for step in 0..16 {
            let fraction = (f64::from(step) + random.between(0.0, 1.0)) / 16.0;
            let inputs = case.inputs::<M>(fraction, &mut random);
            for assembly in M::assemblies() {
                look(&mechanism, inputs, assembly);
            }
        }
    }
}

/// Closure, series and hyper-dual numbers, through snap.
#[test]
fn oracles_of_every_form() {
    struct Prove;
    impl Visitor for Prove {
        fn visit<M: ThroughSnap>(&mut self, case: Case) {
            let mut worst = Worst::default();
            grid(8, case, |mechanism: &M, inputs, assembly| {
                worst.check(mechanism, inputs, assembly);
            });
            worst.report(M::DESCRIPTION.name);
        }
    }
    hyperbolic::all(&mut Prove);
}

#[test]
fn oracles_of_sensitivities() {
    struct Prove;
    impl sensitive::Visitor for Prove {
        fn visit<M: SensitiveThroughSnap>(&mut self, case: Case) {
            let mut worst = sensitivities::Worst::default();
            grid(8, case, |mechanism: &M, inputs, assembly| {
                worst.check(mechanism, inputs, assembly, |pose| {
                    sensitivities::generated(mechanism, pose)
                });
            });
            worst.report(M::DESCRIPTION.name);
        }
    }
    hyperbolic::with_sensitivities(&mut Prove);
}

/// Of so many poses, one is compared with the reference. No number of assemblies is a multiple of it.
const SAMPLE: usize = if cfg!(feature = "every-case") { 1 } else { 5 };

/// The reference of 50 digits, in double and single precision.
#[test]
fn the_reference_agrees() {
    struct Hold;
    impl Visitor for Hold {
        fn visit<M: ThroughSnap>(&mut self, case: Case) {
            type Single<M> = <M as Mechanism>::With<f32>;
            #[expect(
                clippy::cast_possible_truncation,
                reason = "the nearest single-precision number is meant"
            )]
            let nearest = |value: f64| value as f32;
            let mut errors = [Errors::new::<M>(), Errors::new::<M>()];
            let mut poses: usize = 0;
            grid(2, case, |mechanism: &M, inputs, assembly| {
                poses += 1;
                if !poses.is_multiple_of(SAMPLE) {
                    return;
                }
                let place = format!("{assembly:?}");
                if let Ok(pose) = mechanism.solve(inputs, assembly) {
                    let given = Given {
                        parameters: mechanism.parameters().as_ref().to_vec(),
                        inputs: inputs.as_ref().iter().map(|motion| motion.as_ref().to_vec()).collect(),
                    };
                    let motions: Vec<Vec<f64>> = pose
                        .unknown_motions()
                        .as_ref()
                        .iter()
                        .map(|motion| motion.as_ref().to_vec())
                        .collect();
                    let held = errors[0].hold::<M>(&given, &motions, f64::EPSILON, &place);
                    assert_eq!(held, Ok(()), "{given:?}");
                }
                let single: Single<M> = mechanism.convert(nearest);
                let inputs: <Single<M> as Mechanism>::Inputs<_> = Row::from_fn(|index| {
                    let motion: M::Motion<f32> = Row::from_fn(|order| nearest(inputs[index][order]));
                    motion
                });
                if let Ok(pose) = single.solve(inputs, assembly) {
                    let widened = |motion: &M::Motion<f32>| -> Vec<f64> {
                        motion.as_ref().iter().map(|value| f64::from(*value)).collect()
                    };
                    let given = Given {
                        parameters: single
                            .parameters()
                            .as_ref()
                            .iter()
                            .map(|value| f64::from(*value))
                            .collect(),
                        inputs: inputs.as_ref().iter().map(widened).collect(),
                    };
                    let motions: Vec<Vec<f64>> = pose.unknown_motions().as_ref().iter().map(widened).collect();
                    let held = errors[1].hold::<M>(&given, &motions, f32::EPSILON.into(), &place);
                    assert_eq!(held, Ok(()), "{given:?}");
                }
            });
            for errors in errors {
                println!("{} {} poses", errors.row(), errors.poses);
                assert!(errors.poses > 20 / SAMPLE, "{errors}");
                assert!(errors.worst.iter().all(|worst| *worst <= ALLOWED), "{errors}");
            }
        }
    }
    hyperbolic::all(&mut Hold);
}

/// In lanes every pose has the outcome, and the value, that it has alone; some of them do not close.
#[test]
fn batches_agree_with_single_poses() {
    struct Compare {
        failed: usize,
    }
    impl Visitor for Compare {
        fn visit<M: ThroughSnap>(&mut self, case: Case) {
            let mut random = Random::new(11);
            let mechanisms: Vec<M> = (0..101).map(|_| case.varied(&mut random)).collect();
            let (low, high) = case.inputs[0];
            let (low, high) = (low - (high - low) / 2.0, high + (high - low) / 4.0);
            let inputs = (0..101)
                .map(|index| {
                    let value = low + (high - low) * f64::from(index) / 100.0;
                    M::Inputs::from_fn(|_| Motion::new(random.motion(value)))
                })
                .collect();
            let poses = Poses {
                mechanisms,
                inputs,
                near: Vec::new(),
            };
            for assembly in M::assemblies() {
                for vectors in vectors() {
                    let (table, outcomes, _) = poses.solve(Some(assembly), vectors);
                    for (index, outcome) in outcomes.iter().enumerate() {
                        let name = M::DESCRIPTION.name;
                        let pose = match poses.solve_one(index, Some(assembly)) {
                            Ok(pose) => pose,
                            Err(error) => {
                                self.failed += 1;
                                assert_eq!(*outcome, Outcome::from(&error), "{name}, pose {index}: {error}");
                                continue;
                            }
                        };
                        assert_eq!(*outcome, Outcome::Solved, "{name}, pose {index}");
                        let gauge = kin_tests::oracles::Gauge::new(
                            &poses.mechanisms[index],
                            &poses.inputs[index],
                            &pose.unknown_motions(),
                        );
                        for (place, motion) in pose.unknown_motions().as_ref().iter().enumerate() {
                            for (order, allowed) in kin_tests::oracles::ALLOWED.into_iter().enumerate() {
                                let error = (table.unknowns[place][order][index] - motion[order]).abs();
                                let unit = gauge.unknown(place, order);
                                assert!(error <= allowed * unit, "{name}, pose {index}, order {order}: {error}");
                            }
                        }
                    }
                }
            }
        }
    }
    let mut compare = Compare { failed: 0 };
    hyperbolic::all(&mut compare);
    assert!(compare.failed > 100, "{}", compare.failed);
}

fn catenary() -> CatenaryForm {
    CatenaryForm::from_parameters([2.0, 0.5])
}

/// The value of the only unknown, or what is the matter.
fn value<M: ThroughSnap>(parameters: &[f64], input: f64, assembly: M::Assembly) -> Result<f64, Failure> {
    let mechanism = M::from_parameters(M::Parameters::from_fn(|index| parameters[index]));
    mechanism
        .position(M::Inputs::from_fn(|_| input), assembly)
        .map(|unknowns| unknowns[0])
        .map_err(|error| error.failure)
}

#[track_caller]
fn assert_near(found: Result<f64, Failure>, expected: f64) {
    let found = found.expect("there is a solution");
    assert!(
        (found - expected).abs() <= 8.0 * f64::EPSILON * expected.abs().max(1.0),
        "{found} instead of {expected}"
    );
}

/// The open assembly is the solution with the larger unknown, whatever the signs in the argument are.
#[test]
fn a_hyperbolic_cosine_has_two_solutions() {
    let height = 2.0 * 0.75_f64.cosh();
    assert_near(value::<CatenaryForm>(&[2.0, 0.5], height, Assembly::Open), 2.0);
    assert_near(value::<CatenaryForm>(&[2.0, 0.5], height, Assembly::Crossed), -1.0);
    assert_near(value::<CatenaryWhere>(&[2.0], height, ()), 1.5);
    assert_near(value::<CatenaryRanged>(&[2.0, 0.5], height, ()), -1.0);
    let root = 0.75_f64.cosh().sqrt();
    for (p, open, crossed) in [(0.5, 0.5, -2.5), (-0.5, 2.5, -0.5)] {
        assert_near(value::<CoefficientInCosine>(&[p], root, Assembly::Open), open);
        assert_near(value::<CoefficientInCosine>(&[p], root, Assembly::Crossed), crossed);
    }
    // a guess is told by the same sign
    for (x, assembly) in [(0.7, Assembly::Open), (0.3, Assembly::Crossed)] {
        assert_eq!(catenary().assembly_at(height, [x]), assembly);
    }
    assert_eq!(
        CoefficientInCosine::from_parameters([-0.5]).assembly_at(0.0, [1.1]),
        Assembly::Open
    );
    assert_eq!(
        CoefficientInCosine::from_parameters([-0.5]).assembly_at(0.0, [0.9]),
        Assembly::Crossed
    );
    // both lie in the range, or none does
    let ranged = |height: f64| value::<CatenaryRanged>(&[2.0, -1.0], height, ());
    assert!(
        matches!(ranged(2.0 * 0.25_f64.cosh()), Err(Failure::Ambiguous { .. })),
        "{:?}",
        ranged(2.0)
    );
    assert!(matches!(ranged(2.0 * 2.0_f64.cosh()), Err(Failure::OutOfRange { .. })));
}

/// At the lowest point both solutions are one, and below it there is none.
#[test]
fn the_lowest_point_is_a_limit() {
    for assembly in Assembly::BOTH {
        let lowest = value::<CatenaryForm>(&[2.0, 0.5], 2.0, assembly);
        assert!(matches!(lowest, Err(Failure::Singular { .. })), "{lowest:?}");
        let below = value::<CatenaryForm>(&[2.0, 0.5], 1.0, assembly);
        assert_eq!(below, Err(Failure::OutOfReach { margin: -0.5 }));
        let start = catenary().position(5.0, assembly).expect("it closes");
        match catenary().track(&start, 1.0) {
            Err(TrackError::TurningPoint(limit)) => {
                assert!((limit.inputs[0] - 2.0).abs() <= 8.0 * f64::EPSILON, "{limit:?}");
                // the height is flat there
                assert!((limit.unknowns[0] - 0.5).abs() <= 1e-7, "{limit:?}");
            }
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn values_outside_of_a_domain_are_refused() {
    let refused = |found: Result<f64, Failure>, function: &'static str, argument: f64| {
        assert_eq!(found, Err(Failure::OutsideDomain { function, argument }));
    };
    refused(value::<HyperbolicTangentForm>(&[2.0], 2.0, ()), "atanh", 1.0);
    refused(value::<HyperbolicTangentForm>(&[2.0], -3.0, ()), "atanh", -1.5);
    refused(value::<AreaCosineForm>(&[2.0], -1.0, ()), "the inverse of acosh", -0.5);
    // the slope of acosh is infinite at the end of its domain
    let end = value::<AreaCosineForm>(&[2.0], 0.0, ());
    assert!(matches!(end, Err(Failure::NotFinite { .. })), "{end:?}");
    assert_near(value::<HyperbolicTangentForm>(&[2.0], 1.0, ()), 3.0_f64.ln());
}

/// e sinh h - h = m, from everywhere to everywhere.
#[test]
fn keplers_equation_of_a_hyperbola() {
    let mut random = Random::new(3);
    let mut worst = Worst::default();
    for _ in 0..200 {
        let orbit = HyperbolicKepler {
            e: random.between(1.1, 4.0),
        };
        let h = random.between(-3.0, 3.0);
        let m = orbit.e * h.sinh() - h;
        let pose = orbit.solve_near(Motion::new(random.motion(m)), [h + random.between(-0.2, 0.2)]);
        let pose = pose.expect("it closes");
        assert!(
            (pose.h.value() - h).abs() <= 16.0 * f64::EPSILON * (1.0 + h.abs()) * orbit.e * h.cosh(),
            "{h}"
        );
        worst.check(&orbit, [Motion::new(random.motion(m))], Near([h]));
    }
    worst.report("hyperbolic Kepler");
}
