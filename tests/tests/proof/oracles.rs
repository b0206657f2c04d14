//! Every mechanism of the library and of the tests, every closed form, every order and every assembly, against both
//! oracles.
//!
//! The worst errors per order are printed: `cargo test -p kin-tests --test proof oracles -- --nocapture`.

use kin_core::library::{
    Bennett, FourBar, FreudensteinFourBar, GeometricFourBar, InvertedSliderCrank, OffsetSliderCrank, Rssp, Rssr,
    SliderCrank, SliderCrankFirstApproximation, SliderCrankHigherApproximation, SphericalFourBar, StewartGoughLeg,
    UniversalJoint,
};
use kin_core::prelude::*;
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};
use kin_tests::oracles::{Reported, Worst};
use kin_tests::random::Random;
use kin_tests::samples;

/// Holds a mechanism against both oracles, on a grid of inputs with random rates; the dimensions vary by up to a tenth.
struct Prove;

impl Visitor for Prove {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let mut random = Random::new(M::DESCRIPTION.name.bytes().map(u64::from).sum());
        let mut worst = Worst::default();
        for _ in 0..samples::of(8) {
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

groups! {
    four_bars slider_cranks inverted_slider_cranks loops chains scalars ranges in_space with_outputs as_directions
    library
}

/// Holds a mechanism of the library with random dimensions against both oracles, on a grid of crank angles with random
/// motions.
fn prove_with<M: ThroughSnap>(name: &str, mut dimension: impl FnMut(&mut Random, usize) -> f64) {
    let mut random = Random::new(M::DESCRIPTION.name.len() as u64);
    let mut worst = Worst::default();
    for linkage in (0..40).take(samples::of(40)) {
        let mechanism = M::from_parameters(M::Parameters::from_fn(|index| dimension(&mut random, index)));
        for step in 0..12 {
            let angle = f64::from(30 * step + linkage % 7).to_radians();
            let inputs = M::Inputs::from_fn(|_| Motion::new(random.motion(angle)));
            for assembly in M::assemblies() {
                worst.check(&mechanism, inputs, assembly);
            }
        }
    }
    worst.report(name);
}

fn any_length(random: &mut Random, _: usize) -> f64 {
    random.between(0.5, 5.0)
}

/// A crank shorter than the rod, so that the series converge.
fn crank_and_rod(random: &mut Random, index: usize) -> f64 {
    if index == 0 {
        random.between(0.5, 1.0)
    } else {
        random.between(1.5, 5.0)
    }
}

#[test]
fn four_bars_of_any_dimensions() {
    prove_with::<FourBar>("four-bar, vector loop", any_length);
    prove_with::<GeometricFourBar>("four-bar, geometric method", any_length);
    prove_with::<FreudensteinFourBar>("four-bar, Freudenstein", any_length);
}

#[test]
fn slider_cranks_of_any_dimensions() {
    prove_with::<SliderCrank>("slider-crank", any_length);
    prove_with::<OffsetSliderCrank>("slider-crank with offset", any_length);
    prove_with::<InvertedSliderCrank>("inverted slider-crank", any_length);
    prove_with::<SliderCrankFirstApproximation>("slider-crank, first approximation", crank_and_rod);
    prove_with::<SliderCrankHigherApproximation>("slider-crank, (R/L)^5", crank_and_rod);
}

#[test]
fn mechanisms_of_space_of_any_dimensions() {
    // vectors in all directions, and a rod that bridges them more often than not
    let linkage = |rod: usize| {
        move |random: &mut Random, index: usize| match index {
            0 => random.between(0.5, 2.0),
            _ if index == rod => random.between(2.0, 5.0),
            _ => random.between(-2.0, 2.0),
        }
    };
    prove_with::<Rssr>("RSSR", linkage(10));
    prove_with::<Rssp>("RSSP", linkage(7));
    prove_with::<UniversalJoint>("universal joint", |random, _| random.between(-1.4, 1.4));
    prove_with::<SphericalFourBar>("spherical four-bar", |random, _| random.between(0.3, 1.5));
    prove_with::<StewartGoughLeg>("Stewart-Gough leg", any_length);
    // length, then twists that differ
    prove_with::<Bennett>("Bennett's linkage", |random, index| match index {
        0 => random.between(0.5, 5.0),
        1 => random.between(0.3, 1.2),
        _ => random.between(1.3, 2.8),
    });
}
