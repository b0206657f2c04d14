//! The expansion of random declarations, sound and unsound. The work of the macro is bounded, it does not panic, its
//! output is a list of items, and each value of a solver is computed before its use.

mod campaign;
mod cases;
mod fragments;
mod shrink;
mod verdict;

use std::thread;

use kin_declarations::Scale;

use campaign::Campaign;

fn small_declarations(count: u64, threads: usize) {
    let campaign = Campaign {
        first: 0,
        count,
        scale: Scale::Small,
        threads,
    };
    println!("{}", campaign.run());
}

#[test]
fn fifty_declarations() {
    small_declarations(50, 1);
}

/// `.ci/run samples` runs it.
#[test]
#[ignore = "takes a minute"]
fn five_thousand_declarations() {
    small_declarations(5_000, processors());
}

fn processors() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// `.ci/fuzz` runs it optimised. The environment may set another first seed, `KIN_SEED`, and another number,
/// `KIN_COUNT`.
#[test]
#[ignore = "takes long"]
fn a_hundred_thousand_declarations() {
    let number = |name: &str, usual| std::env::var(name).map_or(usual, |value| value.parse().expect("a number"));
    let campaign = Campaign {
        first: number("KIN_SEED", 1_000_000),
        count: number("KIN_COUNT", 100_000),
        scale: Scale::Full,
        threads: processors(),
    };
    println!("{}", campaign.run());
}
