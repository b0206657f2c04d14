//! What a user calls: the chain of orders, guesses, assemblies, metadata, number types and errors.

use kin_core::library::{
    FourBar, FreudensteinFourBar, GeometricFourBar, GeometricFourBarAssembly, InvertedSliderCrank,
};
use kin_core::prelude::*;
use kin_core::{Dimension, InputValues};
use num_dual::Dual64;

const SAMPLE: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};
const CRANK: [f64; 5] = [1.1, -10.0, 2.0, -0.5, 0.3];

/// Each step takes the input's derivative of its order alone, and the last pose is the one that `solve` gives, bit by bit.
#[test]
fn the_chain_is_the_whole() {
    for assembly in FourBar::ASSEMBLIES {
        let [angle, velocity, acceleration, jerk, snap] = CRANK;
        let position = SAMPLE.position(angle, assembly).expect("it closes");
        let moving = position.velocity(velocity);
        let steps = moving.acceleration(acceleration).jerk(jerk).snap(snap);
        let whole = SAMPLE.solve(Motion::new(CRANK), assembly).expect("it closes");
        assert_eq!(steps, whole);
        // lower orders stay what they were
        assert_eq!(whole.theta3.position(), position.theta3.position());
        assert_eq!(whole.theta4.velocity(), moving.theta4.velocity());
        assert_eq!(whole.theta2, Motion::new(CRANK));
        assert_eq!(
            position.unknowns(),
            [position.theta3.position(), position.theta4.position()]
        );
    }
}

#[test]
fn a_guess_finds_its_assembly_and_turn() {
    use core::f64::consts::TAU;
    for assembly in FourBar::ASSEMBLIES {
        let [theta3, theta4] = SAMPLE.position(1.1, assembly).expect("it closes").unknowns();
        let guess = [theta3 + 0.1, theta4 - 0.1 + 3.0 * TAU];
        assert_eq!(SAMPLE.assembly_at(1.1, guess), assembly);
        let near = SAMPLE.position_near(1.1, guess).expect("it closes").unknowns();
        assert_eq!(near[0], theta3);
        assert!((near[1] - theta4 - 3.0 * TAU).abs() < 1e-14);
        let moving = SAMPLE.solve_near(Motion::new(CRANK), guess).expect("it closes");
        let plain = SAMPLE.solve(Motion::new(CRANK), assembly).expect("it closes");
        assert_eq!(moving.theta4.snap(), plain.theta4.snap());
    }
}

#[test]
fn assemblies_of_several_blocks() {
    let all = GeometricFourBar::ASSEMBLIES;
    assert_eq!(all.len(), 8);
    assert_eq!(<GeometricFourBar as Mechanism>::assemblies().collect::<Vec<_>>(), all);
    let geometric = GeometricFourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    for assembly in all {
        let pose = geometric.position(1.1, assembly).expect("the triangles close");
        assert_eq!(geometric.assembly_at(1.1, pose.unknowns()), assembly);
    }
    let own = geometric.assembly(1.1, Assembly::Crossed);
    assert_eq!(
        own,
        GeometricFourBarAssembly {
            alpha: Assembly::Open,
            gamma: Assembly::Crossed,
            beta: Assembly::Open
        }
    );
    assert_eq!(FreudensteinFourBar::ASSEMBLIES.len(), 4);
    // a range leaves nothing to choose
    assert_eq!(InvertedSliderCrank::ASSEMBLIES, [()]);
}

#[test]
fn a_mechanism_describes_itself() {
    let description = <FourBar as Mechanism>::DESCRIPTION;
    assert_eq!(description.name, "FourBar");
    assert_eq!(
        description.equations,
        ["r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4)"]
    );
    assert_eq!(description.order, 4);
    let names: Vec<&str> = description.parameters.iter().map(|quantity| quantity.name).collect();
    assert_eq!(names, ["r1", "r2", "r3", "r4"]);
    assert!(
        description
            .parameters
            .iter()
            .all(|quantity| quantity.dimension == Dimension::Length)
    );
    assert!(
        description
            .unknowns
            .iter()
            .all(|quantity| quantity.dimension == Dimension::Angle)
    );
    assert_eq!(description.inputs[0].description, "The crank's angle.");
    assert_eq!(description.blocks[0].unknowns, "theta3, theta4");
    assert_eq!(description.operations, FourBar::OPERATIONS);
    assert_eq!(FourBar::from_parameters([90.0, 30.0, 60.0, 45.0]), SAMPLE);
    assert_eq!(SAMPLE.parameters(), [90.0, 30.0, 60.0, 45.0]);
}

/// Single precision, and dual numbers: the sensitivity of a rate to a length.
#[test]
fn other_number_types() {
    let single = SAMPLE.convert(|value| {
        #[expect(clippy::cast_possible_truncation, reason = "single precision is wanted")]
        let value = value as f32;
        value
    });
    let pose = single.position(1.1_f32, Assembly::Open).expect("it closes");
    let double = SAMPLE.position(1.1, Assembly::Open).expect("it closes");
    assert!((f64::from(pose.theta4.position()) - double.theta4.position()).abs() < 1e-5);

    let speed = |r3: f64| {
        let linkage = FourBar { r3, ..SAMPLE };
        linkage
            .position(1.1, Assembly::Open)
            .expect("it closes")
            .velocity(-10.0)
            .theta4
            .velocity()
    };
    let mut dual = SAMPLE.convert(Dual64::from);
    dual.r3 = dual.r3.derivative();
    let rate = dual
        .position(Dual64::from(1.1), Assembly::Open)
        .expect("it closes")
        .velocity(Dual64::from(-10.0));
    let step = 1e-4;
    let difference = (speed(60.0 + step) - speed(60.0 - step)) / (2.0 * step);
    assert!((rate.theta4.velocity().eps - difference).abs() < 1e-8);
}

#[test]
fn errors_say_where_and_by_how_much() {
    let error = SAMPLE.position(2.0, Assembly::Open).expect_err("out of reach");
    assert_eq!(error.block, "theta3, theta4");
    assert_eq!(error.inputs, InputValues::new(&["theta2"], &[2.0]));
    let missing = 105.0 - (90.0_f64.powi(2) + 30.0_f64.powi(2) - 2.0 * 90.0 * 30.0 * 2.0_f64.cos()).sqrt();
    assert!((error.margin().expect("it has a margin") - missing).abs() < 1e-12);
    let message = error.to_string();
    assert!(
        message.starts_with("theta3, theta4 cannot be found at theta2 = 2: out of reach by "),
        "{message}"
    );
}
