//! The test mechanisms, of every closed form and in every assembly, held against both oracles.
//!
//! The worst errors per order are printed: `cargo test -p kin-tests --test oracles_of_every_form -- --nocapture`.

use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::cases::{self, Case, Visitor};
use kin_tests::oracles::{Reported, Worst};
use kin_tests::random::Random;

/// A grid of inputs with random rates; dimensions vary.
struct Prove;

impl Visitor for Prove {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let mut random = Random::new(M::DESCRIPTION.name.bytes().map(u64::from).sum());
        let mut worst = Worst::default();
        for _ in 0..8 {
            let mechanism: M = case.varied(&mut random);
            for step in 0..16 {
                let fraction = (f64::from(step) + random.between(0.0, 1.0)) / 16.0;
                let inputs = case.inputs::<M>(fraction, &mut random);
                for assembly in M::assemblies() {
                    worst.check(&mechanism, inputs, assembly);
                }
            }
        }
        worst.report(M::DESCRIPTION.name);
    }
}

macro_rules! groups {
    ($($group:ident)+) => {
        $(
            #[test]
            fn $group() {
                cases::$group(&mut Prove);
            }
        )+
    };
}

groups! { four_bars slider_cranks inverted_slider_cranks loops chains scalars ranges in_space with_outputs as_directions library }
