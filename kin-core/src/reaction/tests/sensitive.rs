//! How the peaks of forces depend on the dimensions.

use std::f64::consts::TAU;

use super::{FOUR_BAR, FourBar, pin, rubbed};
use crate::any::AssemblyChoice;
use crate::assembly::Assembly;
use crate::extremes::{ByReaction, QuantityAlong};
use crate::linkage::{AnyLinkage, AnySweep};
use crate::load::{Load, Loads, NamedLoads};
use crate::mechanism::Mechanism as _;
use crate::number::samples;
use crate::reaction::ReactionPart;
use crate::solve::Scalar;
use crate::sweep::{Local, StraightLine, Swept as _};

/// So much dimensions differ.
const STEP: f64 = 1e-5;

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

/// The force in a joint with friction in all of them, of a linkage with these dimensions.
fn with_force<R>(
    dimensions: [f64; 4],
    name: &str,
    ask: impl Fn(QuantityAlong<'_, AnySweep<'_, StraightLine>, ByReaction<'_>>) -> R,
) -> R {
    let linkage = FourBar::from_parameters(dimensions);
    let linkage = AnyLinkage::of(&linkage);
    let reactions = linkage.reactions(&loads(&linkage)).expect("its bodies are declared");
    let all = ["base", "pin", "knee", "pivot"].map(|name| (name, pin(0.1, 0.01)));
    let reactions = rubbed(reactions, &all);
    let turn = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.0], &[TAU], 25)
        .speed(9.0);
    ask(turn.of_reaction(&reactions, name, ReactionPart::Force, 0))
}

/// The peaks of other designs differ by as much, with friction too. The rocker, on which a torque acts, turns back.
#[test]
fn peaks_of_other_designs_differ_by_their_sensitivities() {
    let dimensions = FOUR_BAR.parameters();
    let joints = if samples::are_all() {
        &["knee", "base"][..]
    } else {
        &["base"]
    };
    for name in joints {
        let found = with_force(dimensions, name, |force| {
            force.peak_sensitivities().expect("it is smooth")
        });
        for (index, by) in found.by.into_iter().enumerate() {
            let peak = |step: f64| {
                let mut changed = dimensions;
                changed[index] += step;
                with_force(changed, name, |force| force.peak().expect("it moves"))
            };
            let (more, less) = (peak(STEP), peak(-STEP));
            let [value, at] = [more.value - less.value, more.at - less.at].map(|change| change / (2.0 * STEP));
            assert!((by.value - value).abs() < 1e-6 * (1.0 + value.abs()), "{by:?} {value}");
            assert!((by.at - at).abs() < 1e-5 * (1.0 + at.abs()), "{by:?} {at}");
        }
    }
}
