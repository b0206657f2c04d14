//! Tests of tapes of a few mechanisms. Those of the whole library stand in `tests`.

use std::vec::Vec;

use super::{Options, RecordError, ResultOf, Role, record, record_with_sensitivities};
use crate::assembly::Assembly;
use crate::library::FourBar;
use crate::motion::Motion;

/// One tape serves both assemblies, and finds what `solve` finds to the last bit.
#[test]
fn a_tape_of_a_four_bar_is_its_solver() {
    let tape = record::<FourBar>(&Options::new()).unwrap();
    let [r1, r2, r3, r4] = [90.0, 30.0, 60.0, 45.0];
    let linkage = FourBar { r1, r2, r3, r4 };
    let rates = [-10.0, 2.0, -0.5, 0.3];
    for step in -10..=10 {
        let crank = 0.31 * f64::from(step);
        for (assembly, sign) in [(Assembly::Open, 1.0), (Assembly::Crossed, -1.0)] {
            let [velocity, acceleration, jerk, snap] = rates;
            let motion = Motion::from((crank, velocity, acceleration, jerk, snap));
            let arguments = [r1, r2, r3, r4, crank, velocity, acceleration, jerk, snap, sign];
            match (linkage.solve(motion, assembly), tape.run(&arguments)) {
                (Ok(pose), Ok(found)) => {
                    let expected = [pose.theta3, pose.theta4].map(|motion| motion.derivatives()).concat();
                    let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
                    assert_eq!(bits(&found), bits(&expected), "{crank} {assembly}");
                }
                (Err(error), Err(stop)) => {
                    assert_eq!(stop.block, error.block);
                    let margin = error.margin().unwrap();
                    assert!(
                        (stop.margin - margin).abs() <= 8.0 * f64::EPSILON * 200.0,
                        "{stop} {margin}"
                    );
                }
                (expected, found) => panic!("{crank} {assembly}: {expected:?} {found:?}"),
            }
        }
    }
}

/// The bits of numbers, so that zero and minus zero differ.
fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|number| number.to_bits()).collect()
}

const NUMBERS: [f64; 10] = [90.0, 30.0, 60.0, 45.0, 1.0, -10.0, 2.0, -0.5, 0.3, 1.0];

/// Dimensions that are constants are no arguments, and change no bit.
#[test]
fn dimensions_are_folded_in() {
    let whole = record::<FourBar>(&Options::new()).unwrap();
    let folded = record::<FourBar>(&Options::new().with_dimensions(&NUMBERS[..4])).unwrap();
    assert!(
        folded
            .arguments
            .iter()
            .all(|argument| !matches!(argument.role, Role::Parameter(_)))
    );
    assert!(folded.steps.len() < whole.steps.len());
    assert_eq!(
        bits(&folded.run(&NUMBERS[4..]).unwrap()),
        bits(&whole.run(&NUMBERS).unwrap())
    );
    let error = record::<FourBar>(&Options::new().with_dimensions(&[1.0])).unwrap_err();
    assert_eq!(error, RecordError::WrongDimensions { given: 1, wanted: 4 });
}

/// A tape up to an order has the numbers of the whole one, and fewer steps.
#[test]
fn orders_above_the_wanted_one_are_left_out() {
    let whole = record::<FourBar>(&Options::new()).unwrap();
    let all = whole.run(&NUMBERS).unwrap();
    let mut before = 0;
    for order in 0..=4 {
        let tape = record::<FourBar>(&Options::new().up_to(order)).unwrap();
        let found = tape.run(&NUMBERS).unwrap();
        assert_eq!(bits(&found[..=order]), bits(&all[..=order]));
        assert_eq!(bits(&found[order + 1..]), bits(&all[5..=5 + order]));
        assert!(tape.steps.len() > before);
        before = tape.steps.len();
    }
    assert_eq!(record::<FourBar>(&Options::new().up_to(9)).unwrap(), whole);
}

/// A tape in single precision is the solver in single precision.
#[test]
fn tapes_have_their_number_type() {
    let tape = record::<FourBar<f32>>(&Options::new()).unwrap();
    let linkage = FourBar {
        r1: 90.0_f32,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let crank = Motion::from((1.0_f32, -10.0, 2.0, -0.5, 0.3));
    let pose = linkage.solve(crank, Assembly::Open).unwrap();
    let expected = [pose.theta3, pose.theta4]
        .map(|motion| motion.derivatives().map(f64::from))
        .concat();
    assert_eq!(bits(&tape.run(&NUMBERS).unwrap()), bits(&expected));
    // Its smallest divisor is that of the type.
    let smallest = 2.0 * f64::from(f32::MIN_POSITIVE);
    let is_there = |wanted: f64| {
        tape.nodes
            .iter()
            .any(|node| matches!(node, super::TapeNode::Constant(constant) if constant.value() == wanted))
    };
    assert!(is_there(smallest) && !is_there(2.0 * f64::MIN_POSITIVE));
}

mod sensitive {
    crate::mechanism! {
        pub struct Rocker { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
        input theta2: Angle;
        unknown theta3: Angle, theta4: Angle;
        r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
        with sensitivities;
    }
}

/// The partial derivatives are those of the solver.
#[test]
fn sensitivities_are_recorded() {
    use crate::mechanism::Partials as _;
    use sensitive::Rocker;

    let tape = record_with_sensitivities::<Rocker>(&Options::new()).unwrap();
    let found = tape.run(&NUMBERS).unwrap();
    let linkage = Rocker {
        r1: 90.0_f64,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let pose = linkage
        .solve(Motion::from((1.0_f64, -10.0, 2.0, -0.5, 0.3)), Assembly::Open)
        .unwrap();
    let by = linkage.sensitivities(&pose);
    let partials = [by.r1, by.r2, by.r3, by.r4];
    let mut compared = 0;
    for (result, number) in tape.results.iter().zip(found) {
        if let ResultOf::UnknownPartial { unknown, parameter } = result.quantity {
            let expected = partials[parameter].unknown_partials()[unknown].derivatives()[result.order];
            assert_eq!(number.to_bits(), expected.to_bits(), "{}", result.name);
            compared += 1;
        }
    }
    assert_eq!(compared, 4 * 2 * 5);
}

/// Nothing is left that no result and no check needs, no operation is there twice, and operands stand in front.
#[test]
fn a_tape_is_in_order() {
    let tape = record::<FourBar>(&Options::new().with_skeleton()).unwrap();
    let mut used: Vec<bool> = tape.nodes.iter().map(|_| false).collect();
    for (index, node) in tape.nodes.iter().enumerate() {
        assert!(!tape.nodes[..index].contains(node), "{node:?}");
        node.operands(|operand| {
            assert!(operand.index() < index);
            used[operand.index()] = true;
        });
    }
    for result in &tape.results {
        used[result.value.index()] = true;
    }
    for check in &tape.checks {
        if let super::Condition::Holds(truth) = check.condition {
            used[truth.index()] = true;
        }
        if let Some(margin) = check.margin {
            used[margin.index()] = true;
        }
    }
    assert!(used.into_iter().all(|used| used));
}

mod coupled_and_named {
    crate::mechanism! {
        pub struct Delayed { pub r: Length, pub l: Length, pub k: Scalar }
        input theta: Angle;
        unknown phi: Angle, s: Length, e: Angle;
        r * sin(theta) == l * sin(phi);
        s == r * cos(theta) + l * cos(phi);
        e - k * sin(e) == phi + theta;
    }
}

/// A mechanism with both a coupled block and an assembly is recorded. Its assembly follows from the values nearby.
#[test]
fn assemblies_beside_coupled_blocks_are_recorded() {
    use coupled_and_named::Delayed;

    let tape = record::<Delayed>(&Options::new()).unwrap();
    assert!(
        tape.searches.len() == 1
            && tape
                .arguments
                .iter()
                .all(|argument| !matches!(argument.role, Role::Assembly(_)))
    );
    let mechanism = Delayed { r: 0.4, l: 1.1, k: 0.3 };
    let rates = [0.7, 2.0, -0.5, 0.3, 1.0];
    for near in [[0.2, 1.3, 1.0], [3.0, -0.8, 4.0]] {
        let pose = mechanism.solve_near(Motion::from(rates), near).unwrap();
        let expected = [pose.phi.derivatives(), pose.s.derivatives(), pose.e.derivatives()].concat();
        let given = [&[0.4, 1.1, 0.3][..], &rates, &near].concat();
        assert_eq!(bits(&tape.run(&given).unwrap()), bits(&expected));
    }
}
