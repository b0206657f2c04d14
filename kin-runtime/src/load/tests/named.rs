//! Loads by names beside the same loads by closures.

use std::string::ToString;
use std::vec::Vec;

use super::{ARM, Arm, SPATIAL, Spatial};
use crate::any::AssemblyChoice;
use crate::assembly::Assembly;
use crate::extremes::ExtremesError;
use crate::geometry::{Plane, Space};
use crate::law::{Law as _, Piecewise, Rise, Shape};
use crate::linkage::AnyLinkage;
use crate::load::{LoadError, Loaded, Loads, NamedLoads};
use crate::motion::Motion;

/// The largest difference between efforts by names and by closures, as a part of the largest effort: the series of the
/// one and the rates of the other differ by rounding.
const CLOSE: f64 = 1e-12;

fn compare<const K: usize>(by_names: &[Vec<f64>], by_closures: &[[[f64; 3]; K]]) {
    for (column, values) in by_names.iter().enumerate() {
        let (input, order) = (column / 3, column % 3);
        let all = by_closures.iter().map(|row| row[input][order]);
        let size = all.clone().fold(0.0, |size: f64, value| size.max(value.abs()));
        assert!(size > 0.0 && values.len() == by_closures.len());
        for (one, other) in values.iter().zip(all) {
            assert!((one - other).abs() <= CLOSE * size, "{column}: {one} {other}");
        }
    }
}

#[test]
fn two_drives_under_laws() {
    let left = Rise::new(Shape::Polynomial56789, 2.0, 1.4, 0.5).expect("a law");
    let right = Rise::new(Shape::Cycloidal, 1.0, 1.3, 0.5).expect("a law");
    let laws: [&dyn Piecewise<f64>; 2] = [&left, &right];
    let gravity = Plane::new(0.3, -9.81);
    let typed = Loads::<Arm>::new()
        .gravity(gravity)
        .mass(2.0, |pose| pose.hand)
        .inertia(0.3, |pose| pose.phi)
        .force(Plane::new(-4.0, 7.0), |pose| pose.hand)
        .torque(1.5, |pose| pose.psi)
        .spring(40.0, 0.7, |pose| pose.elbow, |pose| pose.middle)
        .damper(3.0, |pose| pose.hand, |_| Plane::new(0.5, -0.2))
        .torsion_spring(8.0, 0.4, |pose| pose.phi)
        .torsion_damper(0.6, |pose| pose.psi);
    let linkage = AnyLinkage::of(&ARM);
    let named = || -> Result<_, crate::load::NoSuchName> {
        NamedLoads::new(linkage.description())
            .gravity(gravity)
            .mass(2.0, "hand")?
            .inertia(0.3, "phi")?
            .force(Plane::new(-4.0, 7.0), "hand")?
            .torque(1.5, "psi")?
            .spring(40.0, 0.7, "elbow", "middle")?
            .damper(3.0, "hand", Plane::new(0.5, -0.2))?
            .torsion_spring(8.0, 0.4, "phi")?
            .torsion_damper(0.6, "psi")
    };
    let named = named().expect("all names are there");
    let sweep = linkage
        .sweep(AssemblyChoice::Index(0))
        .under_laws(&laws, 0.05..=0.45, 9);
    let columns: Vec<Vec<f64>> = (0..6)
        .map(|column| {
            sweep
                .of_effort(&named, column / 3, column % 3)
                .column()
                .expect("it closes")
        })
        .collect();
    let efforts: Vec<[[f64; 3]; 2]> = (0..9)
        .map(|row| {
            let inputs = [left.at(sweep.at(row)), right.at(sweep.at(row))];
            let balance = ARM.balance(&typed, inputs, Assembly::Open).expect("it closes");
            balance
                .efforts()
                .map(|effort| [effort.value(), effort.rate(), effort.second_rate()])
        })
        .collect();
    compare(&columns, &efforts);
}

#[test]
fn points_in_space_and_parameters() {
    let typed = Loads::<Spatial>::new()
        .gravity(Space::new(0.0, 0.0, -9.81))
        .mass(1.2, |pose| pose.middle)
        .spring(9.0, 0.5, |pose| pose.ball, |_| SPATIAL.pivot);
    let linkage = AnyLinkage::of(&SPATIAL);
    let named = NamedLoads::new(linkage.description())
        .gravity(Space::new(0.0, 0.0, -9.81))
        .mass(1.2, "middle")
        .and_then(|loads| loads.spring(9.0, 0.5, "ball", "pivot"))
        .expect("all names are there");
    let sweep = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.0], &[1.0], 5)
        .speed(3.0);
    let columns: Vec<Vec<f64>> = (0..3)
        .map(|order| sweep.of_effort(&named, 0, order).column().expect("it closes"))
        .collect();
    let efforts: Vec<[[f64; 3]; 1]> = (0..5)
        .map(|row| {
            let theta = Motion::at_constant_speed(sweep.at(row), 3.0);
            let balance = SPATIAL.balance(&typed, [theta], Assembly::Open).expect("it closes");
            balance
                .efforts()
                .map(|effort| [effort.value(), effort.rate(), effort.second_rate()])
        })
        .collect();
    compare(&columns, &efforts);
}

#[test]
fn names_and_numbers_are_checked() {
    let linkage = AnyLinkage::of(&ARM);
    let loads = || NamedLoads::new(linkage.description());
    let missing = loads().mass(1.0, "foot").expect_err("no such point");
    assert_eq!(
        missing.to_string(),
        "there is no point `foot`; there is `hand`, `elbow`, `middle`"
    );
    let missing = loads().torque(1.0, "hand").expect_err("no angle");
    assert_eq!(
        missing.to_string(),
        "there is no angle or distance `hand`; there is `alpha`, `beta`, `phi`, `psi`"
    );
    let heavy = loads().mass(-1.0, "hand").expect("a name");
    let sweep = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[2.0, 1.0], &[1.8, 1.2], 5);
    let error = |input, order| sweep.of_effort(&heavy, input, order).peak().expect_err("a mistake");
    let ExtremesError::Load { error: negative, .. } = error(0, 0) else {
        panic!("{}", error(0, 0))
    };
    assert!(matches!(*negative, LoadError::Negative { load: 1, .. }), "{negative}");
    for (input, order) in [(2, 0), (0, 3)] {
        let ExtremesError::Load { error: none, .. } = error(input, order) else {
            panic!("{}", error(input, order))
        };
        assert_eq!(*none, LoadError::NoEffort { input });
    }
}
