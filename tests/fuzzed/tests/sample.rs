//! The sample, held against both oracles: `KIN_COUNT=200 cargo test -p kin-fuzzed -- --nocapture` compiles and solves
//! two hundred.
#![allow(dead_code, missing_docs, reason = "nobody has written them")]

use std::fmt::Write;

use kin_core::any::{AnyMechanism, Of};
use kin_core::verify::{Report, Sampling};
use kin_declarations::Sample;

/// What is found of a mechanism.
struct Found {
    functions: &'static dyn AnyMechanism,
    verify: fn() -> Report,
}

/// How it is found.
type Find = fn() -> Found;

macro_rules! of {
    ($mechanism:ident) => {
        super::Found {
            functions: super::Of::<$mechanism>::FUNCTIONS,
            verify: || super::SAMPLING.mechanism::<$mechanism>(),
        }
    };
}

include!(concat!(env!("OUT_DIR"), "/sample.rs"));

const SAMPLING: Sampling = Sampling {
    poses: 40,
    draws: 4_000,
    seed: 1,
};

/// Every pose that is found agrees with both oracles, and nine of ten mechanisms are found to close often enough.
#[test]
fn samples_agree_with_both_oracles() {
    let (mut wrong, mut verified) = (String::new(), 0);
    for (find, seed) in SAMPLE {
        let report = (find().verify)();
        println!(
            "{}: {} poses, closed at {} of {} draws",
            report.name, report.worst.poses, report.closed, report.tried
        );
        if report.worst.is_allowed() {
            verified += usize::from(report.passed());
        } else {
            writeln!(wrong, "{report}\n{}", Sample::new(*seed)).expect("a string can be written");
        }
    }
    println!("{verified} of {} verified", SAMPLE.len());
    assert!(wrong.is_empty(), "{wrong}");
    assert!(verified * 10 >= SAMPLE.len() * 9, "only {verified} of {}", SAMPLE.len());
}

/// The closure, which is an oracle of the solvers, is the declaration: its residuals are those of the formulas from
/// which the text was written, at poses and beside them.
#[test]
fn closures_are_those_of_the_text() {
    /// Roundings of residuals, relative to what a change of each number by a thousandth makes of them.
    const ROUNDINGS: f64 = 1e-9;
    let mut compared = 0;
    for (find, seed) in SAMPLE {
        let (sample, functions) = (Sample::new(*seed), find().functions);
        let names = |quantities: &[kin_core::Quantity]| quantities.iter().map(|own| own.name.to_owned()).collect();
        let declared =
            |quantities: Vec<kin_declarations::Quantity>| quantities.into_iter().map(|own| own.name).collect();
        let description = functions.description();
        let own: [Vec<String>; 3] = [description.parameters, description.inputs, description.unknowns].map(names);
        let expected: [Vec<String>; 3] = [sample.parameters(), sample.inputs(), sample.unknowns()].map(declared);
        assert_eq!(own, expected, "{sample}");
        for pose in (0..8).filter_map(|seed| sample.pose(seed)) {
            let mut numbers = [pose.parameters, pose.inputs, pose.unknowns];
            let residuals = |[parameters, inputs, unknowns]: &[Vec<f64>; 3]| {
                let mut found = vec![0.0; unknowns.len()];
                functions.closure(parameters, inputs, unknowns, &mut found);
                (found, sample.residuals(parameters, inputs, unknowns))
            };
            let (_, closed) = residuals(&numbers);
            for number in numbers.iter_mut().flatten() {
                *number *= 1.001;
            }
            let (found, expected) = residuals(&numbers);
            compared += 1;
            for ((found, expected), closed) in found.into_iter().zip(expected).zip(closed) {
                assert!(
                    (found - expected).abs() <= ROUNDINGS * (expected - closed).abs().max(1e-6),
                    "{found} for {expected} at {numbers:?}\n{sample}"
                );
            }
        }
    }
    assert!(compared >= 4 * SAMPLE.len(), "only {compared} poses");
}

/// A pose of the declaration is found from nearby, unless it lies out of the range of an unknown or is singular.
#[test]
fn poses_of_the_text_are_found() {
    let (mut found, mut refused) = (0, 0);
    for (find, seed) in SAMPLE {
        let (sample, functions) = (Sample::new(*seed), find().functions);
        for pose in (0..8).filter_map(|seed| sample.pose(seed)) {
            let mut unknowns = vec![0.0; pose.unknowns.len()];
            let near = functions.position_near(&pose.parameters, &pose.inputs, &pose.unknowns, &mut unknowns);
            if near.is_err() {
                refused += 1;
                continue;
            }
            found += 1;
            let left = sample.residuals(&pose.parameters, &pose.inputs, &unknowns);
            let rest = left.iter().fold(0.0, |most: f64, left| most.max(left.abs()));
            let largest = unknowns
                .iter()
                .chain(&pose.parameters)
                .fold(1.0, |most: f64, own| most.max(own.abs()));
            assert!(
                rest <= 1e-9 * largest * largest,
                "{rest:e} at {pose:?}: {unknowns:?}\n{sample}"
            );
        }
    }
    println!("{found} are found, {refused} are not");
    assert!(refused * 4 <= found, "{refused} are refused, {found} are found");
}
