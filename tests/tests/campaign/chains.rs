//! Chains and rings of equations that give one unknown from the others, so that a solver may be tempted to go through
//! them from one end: the closure of every position that is found.
//!
//! The terms of the equations are written once more by hand. A residual is compared with the sum of their sizes, times
//! the condition of the whole block.

use kin_core::batch::{Column, Outcome};
use kin_core::prelude::*;
use kin_core::tape::{self, Options};
use kin_core::verify;
use kin_tests::random::Random;
use kin_tests::samples;

/// The largest residual, in units of ε, of the sum of the terms' sizes, and of the condition.
const ALLOWED: f64 = 64.0;

/// The draws of the large campaign, over all mechanisms. Those of the rings are many times as many, because few of them
/// converge.
const LARGE: usize = 10_000;

/// One equation of a chain: a x₁ - x₀ - x₂ + b sin x₁ = k.
macro_rules! chain {
    ($name:ident: $($unknown:ident)+; $first:ident $second:ident, $last_but_one:ident $last:ident;
        $($before:ident $own:ident $after:ident;)*) => {
        mechanism! {
            struct $name { a: Scalar, b: Scalar, k: Scalar }
            input t: Scalar;
            unknown $($unknown: Scalar),+;
            order = 1;
            a * $first - $second + b * sin($first) == t;
            $(a * $own - $before - $after + b * sin($own) == k;)*
            a * $last - $last_but_one + b * sin($last) == k;
        }
    };
}

chain!(Chain4: x0 x1 x2 x3; x0 x1, x2 x3;
    x0 x1 x2; x1 x2 x3;);
chain!(Chain6: x0 x1 x2 x3 x4 x5; x0 x1, x4 x5;
    x0 x1 x2; x1 x2 x3; x2 x3 x4; x3 x4 x5;);
chain!(Chain8: x0 x1 x2 x3 x4 x5 x6 x7; x0 x1, x6 x7;
    x0 x1 x2; x1 x2 x3; x2 x3 x4; x3 x4 x5; x4 x5 x6; x5 x6 x7;);
chain!(Chain10: x0 x1 x2 x3 x4 x5 x6 x7 x8 x9; x0 x1, x8 x9;
    x0 x1 x2; x1 x2 x3; x2 x3 x4; x3 x4 x5; x4 x5 x6; x5 x6 x7; x6 x7 x8; x7 x8 x9;);
chain!(Chain12: x0 x1 x2 x3 x4 x5 x6 x7 x8 x9 x10 x11; x0 x1, x10 x11;
    x0 x1 x2; x1 x2 x3; x2 x3 x4; x3 x4 x5; x4 x5 x6; x5 x6 x7; x6 x7 x8; x7 x8 x9; x8 x9 x10; x9 x10 x11;);

/// A chain with numbers, and without the sines: a x₁ - x₀ - x₂ = k.
macro_rules! linear_chain {
    ($name:ident: $a:literal; $($unknown:ident)+; $first:ident $second:ident, $last_but_one:ident $last:ident;
        $($before:ident $own:ident $after:ident;)*) => {
        mechanism! {
            struct $name { k: Scalar }
            input t: Scalar;
            unknown $($unknown: Scalar),+;
            order = 1;
            $a * $first - $second == t;
            $($a * $own - $before - $after == k;)*
            $a * $last - $last_but_one == k;
        }
    };
}

linear_chain!(Linear4: 20; x0 x1 x2 x3; x0 x1, x2 x3;
    x0 x1 x2; x1 x2 x3;);
linear_chain!(Linear10: 20; x0 x1 x2 x3 x4 x5 x6 x7 x8 x9; x0 x1, x8 x9;
    x0 x1 x2; x1 x2 x3; x2 x3 x4; x3 x4 x5; x4 x5 x6; x5 x6 x7; x6 x7 x8; x7 x8 x9;);

/// A ring: x₀ + k sin x₁ · x₂ = t, 1 or 2.
macro_rules! ring {
    ($name:ident: $($unknown:ident)+; $($own:ident $next:ident $second:ident $right:expr;)+) => {
        mechanism! {
            struct $name { k: Scalar }
            input t: Scalar;
            unknown $($unknown: Scalar),+;
            order = 1;
            $($own + k * sin($next) * $second == $right;)+
        }
    };
}

ring!(Ring4: x0 x1 x2 x3; x0 x1 x2 t; x1 x2 x3 1; x2 x3 x0 2; x3 x0 x1 t;);
ring!(Ring5: x0 x1 x2 x3 x4; x0 x1 x2 t; x1 x2 x3 1; x2 x3 x4 2; x3 x4 x0 t; x4 x0 x1 1;);
ring!(Ring6: x0 x1 x2 x3 x4 x5; x0 x1 x2 t; x1 x2 x3 1; x2 x3 x4 2; x3 x4 x5 t; x4 x5 x0 1; x5 x0 x1 2;);
ring!(Ring8: x0 x1 x2 x3 x4 x5 x6 x7;
    x0 x1 x2 t; x1 x2 x3 1; x2 x3 x4 2; x3 x4 x5 t; x4 x5 x6 1; x5 x6 x7 2; x6 x7 x0 t; x7 x0 x1 1;);
ring!(Ring12: x0 x1 x2 x3 x4 x5 x6 x7 x8 x9 x10 x11;
    x0 x1 x2 t; x1 x2 x3 1; x2 x3 x4 2; x3 x4 x5 t; x4 x5 x6 1; x5 x6 x7 2; x6 x7 x8 t; x7 x8 x9 1; x8 x9 x10 2;
    x9 x10 x11 t; x10 x11 x0 1; x11 x0 x1 2;);

/// The terms of the equations of a chain.
fn chain_terms<const N: usize>([a, b, k]: [f64; 3], t: f64, x: [f64; N]) -> Vec<Vec<f64>> {
    let at = |index: Option<usize>| index.and_then(|index| x.get(index)).copied().unwrap_or(0.0);
    let right = |index: usize| if index == 0 { t } else { k };
    (0..N)
        .map(|own| {
            let neighbours = [own.checked_sub(1), Some(own + 1)].map(|index| -at(index));
            vec![a * x[own], neighbours[0], neighbours[1], b * x[own].sin(), -right(own)]
        })
        .collect()
}

/// The terms of the equations of a ring.
fn ring_terms<const N: usize>(k: f64, t: f64, x: [f64; N]) -> Vec<Vec<f64>> {
    (0..N)
        .map(|own| {
            vec![
                x[own],
                k * x[(own + 1) % N].sin() * x[(own + 2) % N],
                -[t, 1.0, 2.0][own % 3],
            ]
        })
        .collect()
}

/// What was found by one mechanism.
#[derive(Default)]
struct Found {
    closed: usize,
    refused: usize,
    /// The largest residual, in units of ε, of the sum of the terms' sizes, and of the condition.
    worst: f64,
}

impl Found {
    /// Counts a position with its condition, or an error.
    fn count(&mut self, position: Option<f64>, terms: impl FnOnce() -> Vec<Vec<f64>>, draw: &str) {
        let Some(condition) = position else {
            self.refused += 1;
            return;
        };
        self.closed += 1;
        for terms in terms() {
            let (residual, size) = terms
                .iter()
                .fold((0.0, 0.0), |(sum, size), term| (sum + term, size + term.abs()));
            let units = f64::abs(residual) / (f64::EPSILON * size * condition.max(1.0));
            assert!(units <= ALLOWED, "{draw}: {units:.1} units");
            self.worst = self.worst.max(units);
        }
    }

    fn report(&self, name: &str) {
        println!(
            "{name:10} {:6} closed {:6} refused {:8.2} units at worst",
            self.closed, self.refused, self.worst
        );
    }
}

fn chains_and_rings(draws: usize, seed: u64) -> usize {
    let mut random = Random::new(seed);
    let mut closed = 0;
    macro_rules! chains {
        ($($name:ident $count:literal),+) => {$(
            let mut found = Found::default();
            for _ in 0..draws {
                let sign = random.between(-1.0, 1.0).signum();
                let a = sign * 10_f64.powf(random.between(0.3, 1.7));
                let [b, k, t] = [1.0, 3.0, 3.0].map(|most| random.between(-most, most));
                let near: [f64; $count] = std::array::from_fn(|_| random.between(-0.5, 0.5));
                let chain = $name { a, b, k };
                let position = chain.position(t, Near(near)).ok();
                let condition = position.map(|position| chain.condition(&position));
                let terms = || chain_terms([a, b, k], t, position.map_or([f64::NAN; $count], |found| found.unknowns()));
                found.count(condition, terms, &format!("{chain:?} {t:?} {near:?}"));
            }
            found.report(stringify!($name));
            // most diagonals dominate, so that there is one position, which any guess finds
            assert!(found.closed * 10 > found.refused * 9);
            closed += found.closed;
        )+};
    }
    macro_rules! linear_chains {
        ($($name:ident $count:literal),+) => {$(
            let mut found = Found::default();
            for _ in 0..draws.div_ceil(10) {
                let [k, t] = [3.0, 3.0].map(|most| random.between(-most, most));
                let chain = $name { k };
                let position = chain.position(t).ok();
                let condition = position.map(|position| chain.condition(&position));
                let unknowns = position.map_or([f64::NAN; $count], |found| found.unknowns());
                let terms = || chain_terms([20.0, 0.0, k], t, unknowns);
                found.count(condition, terms, &format!("{chain:?} {t:?}"));
            }
            found.report(stringify!($name));
            assert_eq!(found.refused, 0);
            closed += found.closed;
        )+};
    }
    macro_rules! rings {
        ($($name:ident $count:literal),+) => {$(
            let mut found = Found::default();
            for _ in 0..3 * draws {
                let [k, t] = [(0.1, 3.0), (1.0, 2.0)].map(|(low, high)| random.between(low, high));
                let near: [f64; $count] = std::array::from_fn(|_| random.between(-4.0, 4.0));
                let ring = $name { k };
                let position = ring.position(t, Near(near)).ok();
                let condition = position.map(|position| ring.condition(&position));
                let terms = || ring_terms(k, t, position.map_or([f64::NAN; $count], |found| found.unknowns()));
                found.count(condition, terms, &format!("{ring:?} {t:?} {near:?}"));
            }
            found.report(stringify!($name));
            assert!(found.closed * 10 > found.refused);
            closed += found.closed;
        )+};
    }
    chains!(Chain4 4, Chain6 6, Chain8 8, Chain10 10, Chain12 12);
    linear_chains!(Linear4 4, Linear10 10);
    rings!(Ring4 4, Ring5 5, Ring6 6, Ring8 8, Ring12 12);
    closed
}

#[test]
fn chains_and_rings_close_to_rounding() {
    chains_and_rings(samples::of(500), 1);
}

#[test]
#[ignore = "takes minutes"]
fn large_chains_and_rings_close_to_rounding() {
    let closed = chains_and_rings(LARGE / 5, super::given("KIN_CAMPAIGN_SEED").unwrap_or(2));
    assert!(closed >= LARGE, "{closed} positions say too little");
}

/// The chain that had been shot through: its condition is about 1, and each of its unknowns is right to the last
/// digits.
#[test]
fn a_chain_of_ten_is_right_to_the_last_digits() {
    let chain = Chain10 {
        a: 20.0,
        b: 1.0,
        k: 1.0,
    };
    let found = chain.position(1.5, Near([0.05; 10])).expect("it is well conditioned");
    assert!(chain.condition(&found) < 1.0);
    // the tridiagonal Newton iteration by hand, which converges to rounding as the diagonal dominates
    let mut x = [0.05; 10];
    for _ in 0..50 {
        for own in 0..10_usize {
            let neighbours = [own.checked_sub(1), Some(own + 1)];
            let around: f64 = neighbours.iter().flatten().filter_map(|&index| x.get(index)).sum();
            let right = if own == 0 { 1.5 } else { 1.0 };
            let residual = 20.0 * x[own] + f64::sin(x[own]) - around - right;
            x[own] -= residual / (20.0 + f64::cos(x[own]));
        }
    }
    for (found, expected) in found.unknowns().iter().zip(x) {
        assert!(
            (found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(),
            "{found} {expected}"
        );
    }
}

/// The ring whose relations, one put into the other, had found a position that does not close.
#[test]
fn a_ring_of_six_closes_or_is_refused() {
    let ring = Ring6 {
        k: 2.748_755_048_240_081_3,
    };
    let near = [
        -0.586_688_662_700_410_6,
        3.997_561_736_782_65,
        -1.484_362_179_513_842,
        1.347_700_468_888_650_2,
        3.651_363_926_706_756,
        -0.659_621_023_782_737_1,
    ];
    let mut found = Found::default();
    let t = 1.653_508_300_873_589_6;
    let position = ring.position(t, Near(near)).ok();
    let condition = position.map(|position| ring.condition(&position));
    let terms = || ring_terms(ring.k, t, position.map_or([f64::NAN; 6], |found| found.unknowns()));
    found.count(condition, terms, "the ring of six");
    assert_eq!(found.closed + found.refused, 1);
}

/// Linear equations are one system for every kind of number: for a recorded solver, for lanes, for bounds, and for
/// series, through which `verify` differentiates.
#[test]
fn a_linear_chain_is_one_system_in_every_number() {
    assert_eq!(Linear10::<f64>::DESCRIPTION.blocks[0].solution, "10 linear equations");
    let chain = Linear10 { k: 1.25 };
    verify::of(&chain, [(-3.0, 3.0)]).assert();
    let near_zero = Linear4 { k: 0.0 };
    verify::of(&near_zero, [(-1e-3, 1e-3)]).assert();

    let tape = tape::record::<Linear10>(&Options::new()).expect("it is recorded");
    let inputs: Vec<f64> = (0..100).map(|index| -3.0 + 0.06 * f64::from(index)).collect();
    let mut table = Linear10Batch::filled(|| vec![0.0; inputs.len()]);
    let mut outcomes = vec![Outcome::Unsolved; inputs.len()];
    let motion = Motion::from([Column::Each(&inputs), Column::Same(1.0)]);
    chain
        .batch(motion)
        .solve(&mut table, &mut outcomes)
        .expect("the columns are of one length");
    for (index, &t) in inputs.iter().enumerate() {
        let pose = chain.solve(Motion::from([t, 1.0])).expect("it is regular");
        let motions: Vec<f64> = pose.unknown_motions().iter().flat_map(Motion::derivatives).collect();
        let recorded = tape.run(&[chain.k, t, 1.0]).expect("it is regular");
        assert_eq!(recorded, motions);
        assert!(matches!(outcomes[index], Outcome::Solved));
        for (own, alone) in [(&table.x0, pose.x0), (&table.x9, pose.x9)] {
            let difference = own[0][index] - alone.position();
            assert!(difference.abs() <= 4.0 * f64::EPSILON, "{difference:e}");
        }
    }
    let cycle = chain.cycle_over(-1.0..=1.0).expect("every input closes");
    assert!(cycle.is_complete());
}

/// Chains and rings are right to the oracles, too, wherever they close.
#[test]
fn chains_and_rings_are_verified() {
    verify::of(
        &Chain4 {
            a: 20.0,
            b: 1.0,
            k: 1.0,
        },
        [(-3.0, 3.0)],
    )
    .assert();
    verify::of(
        &Chain12 {
            a: 20.0,
            b: 1.0,
            k: 1.0,
        },
        [(-3.0, 3.0)],
    )
    .assert();
    verify::of(&Ring6 { k: 0.7 }, [(1.0, 2.0)]).assert();
    verify::of(&Ring12 { k: 0.7 }, [(1.0, 2.0)]).assert();
}
