//! Loads without a result are typed errors.

use std::string::ToString;

use super::{ARM, Arm, FOUR_BAR, FourBar, SPATIAL, Spatial, solid};
use crate::assembly::Assembly;
use crate::geometry::{Plane, Space};
use crate::load::{LoadError, Loaded, Loads};
use crate::motion::Motion;

#[test]
fn ends_that_coincide_have_no_direction() {
    let at = |loads: Loads<FourBar, _>| {
        FOUR_BAR
            .balance(&loads, [Motion::constant(0.5)], Assembly::Open)
            .map(|_| ())
    };
    let damped = Loads::<FourBar>::new()
        .mass(1.0, |pose| pose.pin)
        .damper(3.0, |pose| pose.pin, |pose| pose.pin);
    assert_eq!(at(damped), Err(LoadError::NoDirection { load: 2 }));
}

#[test]
fn a_spring_without_a_length_at_rest_may_have_the_length_zero() {
    let crank = [Motion::constant(0.5)];
    let loads = Loads::<FourBar>::new();
    let free = loads.spring(3.0, 0.0, |pose| pose.pin, |pose| pose.pin);
    let [torque] = FOUR_BAR
        .balance(&free, crank, Assembly::Open)
        .expect("it closes")
        .efforts();
    assert_eq!(torque.value(), 0.0);
    let stretched = loads.spring(3.0, 0.1, |pose| pose.pin, |pose| pose.pin);
    let error = FOUR_BAR
        .balance(&stretched, crank, Assembly::Open)
        .expect_err("no direction");
    assert_eq!(error, LoadError::NoDirection { load: 1 });
}

#[test]
fn points_of_several_links_or_of_a_line_are_no_body() {
    let theta = [Motion::constant(0.5)];
    let loose = Loads::<Spatial>::new().body(solid(), |pose| [pose.root, pose.ball, pose.pin]);
    let error = SPATIAL.balance(&loose, theta, Assembly::Open).expect_err("not rigid");
    assert!(matches!(error, LoadError::NotRigid { load: 1, .. }), "{error}");
    assert!(
        error
            .to_string()
            .starts_with("load 1: the points do not belong to one rigid body")
    );
    let thin = Loads::<Spatial>::new().body(solid(), |pose| [pose.pin, pose.middle, pose.ball]);
    assert_eq!(
        SPATIAL.balance(&thin, theta, Assembly::Open).expect_err("a line"),
        LoadError::Collinear { load: 1 }
    );
}

#[test]
fn an_input_without_inertia_has_no_acceleration() {
    let loads = Loads::<Arm>::new().inertia(0.3, |pose| pose.alpha);
    let found = ARM.accelerations(&loads, [2.0, 1.1], [0.0; 2], [1.0; 2], Assembly::Open);
    assert_eq!(found, Err(LoadError::NoInertia { input: 1 }));
}

#[test]
fn efforts_that_are_not_finite_have_no_accelerations() {
    let loads = Loads::<FourBar>::new().inertia(0.3, |pose| pose.theta2);
    let under = |effort: f64| FOUR_BAR.accelerations(&loads, [0.5], [1.0], [effort], Assembly::Open);
    assert!(under(1.0).is_ok());
    for effort in [f64::NAN, f64::INFINITY] {
        assert_eq!(under(effort), Err(LoadError::NotFinite));
    }
}

#[test]
fn numbers_that_are_not_finite_and_poses_that_do_not_close() {
    let loads = Loads::<FourBar>::new().force(Plane::new(f64::NAN, 0.0), |pose| pose.pin);
    let at = |theta2: f64| {
        FOUR_BAR
            .balance(&loads, [Motion::constant(theta2)], Assembly::Open)
            .expect_err("no result")
    };
    assert_eq!(at(0.5), LoadError::NotFinite);
    assert!(matches!(at(3.0), LoadError::Solve(_)));
    let loads = Loads::<FourBar>::new()
        .gravity(Space::new(0.0, f64::INFINITY, 0.0))
        .mass(1.0, |pose| pose.pin);
    let found = FOUR_BAR.balance(&loads, [Motion::constant(0.5)], Assembly::Open);
    assert_eq!(found.expect_err("no result"), LoadError::NotFinite);
}

/// A mass below zero resists no motion: it drives it. A load is named by its place in the list.
#[test]
fn masses_are_not_negative() {
    let crank = [Motion::constant(0.5)];
    let error = |loads: &dyn Fn() -> Result<(), LoadError>| loads().expect_err("it is refused");
    let loads = Loads::<FourBar>::new().mass(2.0, |pose| pose.pin);
    let masses = error(&|| {
        FOUR_BAR
            .balance(&loads.mass(-2.0, |pose| pose.pin), crank, Assembly::Open)
            .map(|_| ())
    });
    let quantity = "mass";
    assert_eq!(
        masses,
        LoadError::Negative {
            load: 2,
            quantity,
            value: -2.0
        }
    );
    assert!(std::format!("{masses:?}").starts_with("load 2: the mass is -2: give one that is not negative"));
    let inertias = loads.inertia(-0.1, |pose| pose.theta3);
    let refused = error(&|| {
        FOUR_BAR
            .accelerations(&inertias, [0.5], [0.0], [1.0], Assembly::Open)
            .map(|_| ())
    });
    assert!(
        matches!(
            refused,
            LoadError::Negative {
                load: 2,
                value: -0.1,
                ..
            }
        ),
        "{refused}"
    );
    // nothing and not a number are told apart
    assert!(
        FOUR_BAR
            .balance(&loads.mass(-0.0, |pose| pose.pin), crank, Assembly::Open)
            .is_ok()
    );
    let unknown = error(&|| {
        FOUR_BAR
            .balance(&loads.mass(f64::NAN, |pose| pose.pin), crank, Assembly::Open)
            .map(|_| ())
    });
    assert_eq!(unknown, LoadError::NotFinite);
    for wrong in [0, 1, 2, 3] {
        let mut solid = solid();
        match wrong {
            3 => solid.mass = -solid.mass,
            axis => solid.inertia[axis][axis] = -1.0,
        }
        let body = Loads::<Spatial>::new().body(solid, |pose| [pose.root, pose.ball, pose.lug]);
        let refused = SPATIAL.balance(&body, crank, Assembly::Open).map(|_| ());
        assert!(
            matches!(refused, Err(LoadError::Negative { load: 1, .. })),
            "{wrong}: {refused:?}"
        );
    }
}
