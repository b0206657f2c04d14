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

#[test]
fn five_thousand_declarations() {
    let campaign = Campaign {
        first: 0,
        count: 5_000,
        scale: Scale::Small,
        threads: 1,
    };
    println!("{}", campaign.run());
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
        threads: thread::available_parallelism().map_or(1, usize::from),
    };
    println!("{}", campaign.run());
}
