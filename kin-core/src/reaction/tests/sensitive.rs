//! How the peaks of forces depend on the dimensions.

use std::f64::consts::TAU;
use std::vec::Vec;

use super::{FOUR_BAR, FourBar, pin, rubbed};
use crate::any::AssemblyChoice;
use crate::assembly::Assembly;
use crate::extremes::PeakSensitivities;
use crate::linkage::AnyLinkage;
use crate::load::{Load, Loads, NamedLoads};
use crate::mechanism::Mechanism as _;
use crate::reaction::ReactionPart;
use crate::solve::Scalar;
use crate::sweep::{Local, Swept as _};

fn loads(linkage: &AnyLinkage<'_>) -> NamedLoads {
    let loads = linkage.loads().mass_of("coupler", 1.4, "coupler_centre", 0.05);
    let loads = loads.and_then(|loads| loads.mass_of("rocker", 1.1, "rocker_centre", 0.03));
    loads
        .and_then(|loads| loads.torque(-12.0, "theta4"))
        .expect("all names are there")
}

fn typed<T: Scalar>() -> Loads<FourBar<T>, impl Load<FourBar<T>>> {
    Loads::<FourBar<T>>::new()
        .mass(1.4, |pose| pose.coupler_centre)
        .inertia(0.05, |pose| pose.theta3)
        .mass(1.1, |pose| pose.rocker_centre)
        .inertia(0.03, |pose| pose.theta4)
        .torque(-12.0, |pose| pose.theta4)
}

/// Virtual work knows the same of the torque of the drive, from dual numbers.
#[test]
fn virtual_work_gives_the_same_sensitivities() {
    let linkage = AnyLinkage::of(&FOUR_BAR);
    let reactions = linkage.reactions(&loads(&linkage)).expect("its bodies are declared");
    let turn = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.0], &[TAU], 25)
        .speed(9.0);
    let found = turn
        .of_effort_with_friction(&reactions, 0, 0)
        .peak_sensitivities()
        .expect("it is smooth");
    let masses = typed::<Local>();
    let own = FOUR_BAR.sweep(Assembly::Open).over(0.0..=TAU, 25).speed(9.0);
    let own = own
        .of_expression(|at| at.effort(&masses, 0))
        .peak_sensitivities()
        .expect("it is smooth");
    assert!((found.peak.at - own.peak.at).abs() < 1e-9);
    for (found, own) in found.by.iter().zip(&own.by) {
        assert!(
            (found.value - own.value).abs() < 1e-9 * (1.0 + own.value.abs()),
            "{found:?} {own:?}"
        );
        assert!((found.at - own.at).abs() < 1e-8, "{found:?} {own:?}");
    }
}

/// The peaks of other designs differ by as much, with friction too.
#[test]
fn peaks_of_other_designs_differ_by_their_sensitivities() {
    let sensitivities = |dimensions: [f64; 4], name: &str| -> PeakSensitivities {
        let linkage = FourBar::from_parameters(dimensions);
        let linkage = AnyLinkage::of(&linkage);
        let reactions = linkage.reactions(&loads(&linkage)).expect("its bodies are declared");
        let all = ["base", "pin", "knee", "pivot"].map(|name| (name, pin(0.1, 0.01)));
        let reactions = rubbed(reactions, &all);
        let turn = linkage
            .sweep(AssemblyChoice::Index(0))
            .between(&[0.0], &[TAU], 25)
            .speed(9.0);
        let force = turn.of_reaction(&reactions, name, ReactionPart::Force, 0);
        force.peak_sensitivities().expect("it is smooth")
    };
    let dimensions = FOUR_BAR.parameters();
    for (name, changed) in [("knee", [1, 3]), ("base", [0, 2])] {
        let found = sensitivities(dimensions, name);
        for index in changed {
            let by = found.by[index];
            const STEP: f64 = 1e-5;
            let others: Vec<PeakSensitivities> = [STEP, -STEP]
                .into_iter()
                .map(|step| {
                    let mut changed = dimensions;
                    changed[index] += step;
                    sensitivities(changed, name)
                })
                .collect();
            let difference = |of: fn(&PeakSensitivities) -> f64| (of(&others[0]) - of(&others[1])) / (2.0 * STEP);
            let (value, at) = (difference(|own| own.peak.value), difference(|own| own.peak.at));
            assert!(
                (by.value - value).abs() < 1e-6 * (1.0 + value.abs()),
                "{name} {index}: {by:?} {value}"
            );
            assert!(
                (by.at - at).abs() < 1e-5 * (1.0 + at.abs()),
                "{name} {index}: {by:?} {at}"
            );
        }
    }
}
