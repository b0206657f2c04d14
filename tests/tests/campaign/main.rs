//! A campaign: mechanisms of many kinds, random dimensions, inputs and rates at all scales and at special places, and
//! everything that must hold whatever the numbers are.
//!
//! What is found of each [topology](topologies) is put into its closure, in series that know their [errors](bounded). A
//! [draw](draw) gives dimensions and inputs, most often such that a position is known beforehand. The [checks](checks)
//! then solve it in every assembly and in every way there is.
//!
//! The tests run a small campaign. `cargo test -p kin-tests --test campaign -- --ignored --nocapture` runs a large one
//! and prints its tables. The environment may give it another number of draws, `KIN_CAMPAIGN_DRAWS`, and other numbers,
//! `KIN_CAMPAIGN_SEED`.

mod bounded;
mod chains;
mod checks;
mod draw;
mod linear;
mod tally;
mod topologies;
mod topology;
mod trees;
mod unit;
mod units;

use checks::{Size, run};
use kin_tests::samples;
use tally::Report;

fn campaign(size: Size) {
    let mut report = Report::default();
    for topology in topologies::all() {
        run(topology, size, &mut report);
    }
    println!("{report}");
    report.assert();
}

#[test]
fn small() {
    campaign(Size {
        draws: samples::of(20),
        tracked: samples::of(20),
        edges: samples::of(20),
        parallel: samples::of(2000),
        seed: 1,
    });
}

/// A number given in the environment.
fn given(name: &str) -> Option<u64> {
    std::env::var(name).ok().and_then(|text| text.parse().ok())
}

#[test]
#[ignore = "takes minutes"]
fn large() {
    let draws = given("KIN_CAMPAIGN_DRAWS").unwrap_or(2000);
    campaign(Size {
        draws: usize::try_from(draws).expect("there is memory for so many draws"),
        tracked: 10,
        edges: 20,
        parallel: 5000,
        seed: given("KIN_CAMPAIGN_SEED").unwrap_or(2),
    });
}
