//! The sample, held against both oracles: `KIN_COUNT=200 cargo test -p kin-fuzzed -- --nocapture` compiles and solves two hundred.
#![allow(dead_code, missing_docs, reason = "nobody has written them")]

use std::fmt::Write;

use kin_core::verify::{Report, Sampling};

/// What is found of a mechanism.
type Found = Report;
/// How it is found.
type Find = fn() -> Found;

macro_rules! of {
    ($mechanism:ident) => {
        super::SAMPLING.mechanism::<$mechanism>()
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
fn random_mechanisms_agree_with_both_oracles() {
    let (mut wrong, mut verified) = (String::new(), 0);
    for (report, declaration) in SAMPLE {
        let report = report();
        println!(
            "{}: {} poses, closed at {} of {} draws",
            report.name, report.worst.poses, report.closed, report.tried
        );
        if report.worst.is_allowed() {
            verified += usize::from(report.passed());
        } else {
            writeln!(wrong, "{report}\n{declaration}").expect("a string can be written");
        }
    }
    println!("{verified} of {} verified", SAMPLE.len());
    assert!(wrong.is_empty(), "{wrong}");
    assert!(verified * 10 >= SAMPLE.len() * 9, "only {verified} of {}", SAMPLE.len());
}
