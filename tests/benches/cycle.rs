//! The time of the full cycle, as a multiple of the time of one solution through snap.
//!
//! `cargo bench -p kin-tests --bench cycle` prints lines `ratio NAME VALUE`, from times taken in one run. Nothing is
//! asserted.
#![allow(missing_docs, reason = "a program")]

use core::hint::black_box;
use std::time::{Duration, Instant};

use kin_core::library::{FourBar, JansenLeg, StephensonIIIByDyad};
use kin_core::prelude::*;

/// The shortest time of some repetitions, each of `count` calls, for one call.
fn time<R>(repetitions: u32, count: u32, mut call: impl FnMut() -> R) -> Duration {
    let once = |call: &mut dyn FnMut() -> R| {
        let start = Instant::now();
        for _ in 0..count {
            black_box(call());
        }
        start.elapsed() / count
    };
    (0..repetitions).map(|_| once(&mut call)).min().unwrap_or_default()
}

/// Prints the ratio of the cycle of a mechanism to its solution, which closes at an input.
fn print<M: Mechanism<Scalar = f64, Inputs<f64> = [f64; 1]>>(name: &str, mechanism: M, input: f64, count: u32) {
    let mut position = None;
    let search = mechanism.positions_at([input], |_, unknowns| position = Some(unknowns));
    assert!(search.is_ok(), "{name}");
    let near = position.expect("the mechanism closes there");
    let motions: M::Inputs<M::Motion<f64>> =
        Row::from_fn(|_| Row::from_fn(|order| if order == 0 { input } else { 1.0 }));
    let solution = time(8, 1000, || black_box(mechanism).solve_near(black_box(motions), near));
    let cycle = time(8, count, || black_box(mechanism).cycle());
    let ratio = cycle.as_secs_f64() / solution.as_secs_f64();
    println!("{name}: cycle {cycle:?}, solution {solution:?}");
    println!("ratio cycle_{name} {ratio:.0}");
}

fn main() {
    print(
        "four_bar",
        FourBar {
            r1: 90.0,
            r2: 30.0,
            r3: 60.0,
            r4: 45.0,
        },
        0.5,
        200,
    );
    print(
        "crank_rocker",
        FourBar {
            r1: 90.0,
            r2: 30.0,
            r3: 70.0,
            r4: 60.0,
        },
        0.5,
        200,
    );
    print("jansen_leg", JansenLeg::HOLY_NUMBERS, 0.5, 10);
    let (p, pivot) = (Plane::new(1.5, 1.0), Plane::new(5.0, 3.0));
    let triad = StephensonIIIByDyad {
        r1: 4.0,
        r2: 1.0,
        r3: 3.0,
        r4: 2.5,
        p,
        r5: 3.0,
        pivot,
        r6: 2.5,
    };
    print("crank_driven_triad", triad, -2.0, 1);
}
