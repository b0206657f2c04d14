//! Every mechanism of the library, every order, every assembly, against both oracles.

use kin_core::library::{
    Bennett, FourBar, FreudensteinFourBar, GeometricFourBar, InvertedSliderCrank, OffsetSliderCrank, Rssp, Rssr,
    SliderCrank, SliderCrankFirstApproximation, SliderCrankHigherApproximation, SphericalFourBar, StewartGoughLeg,
    UniversalJoint,
};
use kin_core::prelude::*;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::oracles::{Reported, Worst};
use kin_tests::random::Random;

/// A grid of crank angles with random motions and dimensions.
fn prove<M: ThroughSnap>(name: &str, mut dimension: impl FnMut(&mut Random, usize) -> f64) {
    let mut random = Random::new(M::DESCRIPTION.name.len() as u64);
    let mut worst = Worst::default();
    for linkage in 0..40 {
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
fn four_bars() {
    prove::<FourBar>("four-bar, vector loop", any_length);
    prove::<GeometricFourBar>("four-bar, geometric method", any_length);
    prove::<FreudensteinFourBar>("four-bar, Freudenstein", any_length);
}

#[test]
fn slider_cranks() {
    prove::<SliderCrank>("slider-crank", any_length);
    prove::<OffsetSliderCrank>("slider-crank with offset", any_length);
    prove::<InvertedSliderCrank>("inverted slider-crank", any_length);
    prove::<SliderCrankFirstApproximation>("slider-crank, first approximation", crank_and_rod);
    prove::<SliderCrankHigherApproximation>("slider-crank, (R/L)^5", crank_and_rod);
}

#[test]
fn mechanisms_of_space() {
    // vectors in all directions, and a rod that bridges them more often than not
    let linkage = |rod: usize| {
        move |random: &mut Random, index: usize| match index {
            0 => random.between(0.5, 2.0),
            _ if index == rod => random.between(2.0, 5.0),
            _ => random.between(-2.0, 2.0),
        }
    };
    prove::<Rssr>("RSSR", linkage(10));
    prove::<Rssp>("RSSP", linkage(7));
    prove::<UniversalJoint>("universal joint", |random, _| random.between(-1.4, 1.4));
    prove::<SphericalFourBar>("spherical four-bar", |random, _| random.between(0.3, 1.5));
    prove::<StewartGoughLeg>("Stewart-Gough leg", any_length);
    // length, then twists that differ
    prove::<Bennett>("Bennett's linkage", |random, index| match index {
        0 => random.between(0.5, 5.0),
        1 => random.between(0.3, 1.2),
        _ => random.between(1.3, 2.8),
    });
}
