//! Section 2: the four-bar linkage by Freudenstein's equations.

use kin_tests::notes::freudenstein::{Dimensions, Position, position, residuals, solve};
use kin_tests::notes::{Assembly, four_bar_geometric, sample};

use super::{around, assert_consistent, cos, polynomial, sin};

/// The crank goes all the way round.
const CRANK_ROCKER: Dimensions = Dimensions {
    r1: 90.0,
    r2: 30.0,
    r3: 70.0,
    r4: 65.0,
};

fn gap(dimensions: Dimensions, theta2: f64, at: Position) -> f64 {
    let Dimensions { r1, r2, r3, r4 } = dimensions;
    let x = r2 * cos(theta2) + r3 * cos(at.theta3) - r1 - r4 * cos(at.theta4);
    let y = r2 * sin(theta2) + r3 * sin(at.theta3) - r4 * sin(at.theta4);
    x.hypot(y)
}

#[test]
fn sample_table_to_every_printed_digit() {
    let found = solve(sample::DIMENSIONS, sample::THETA2, Assembly::Open);
    sample::THETA4.assert_agrees(found.theta4);
    sample::THETA3.assert_agrees(found.theta3);
}

#[test]
fn both_equations_and_the_loop_close() {
    for assembly in [Assembly::Open, Assembly::Crossed] {
        for theta2 in around() {
            let at = position(CRANK_ROCKER, theta2, assembly);
            let [first, second] = residuals(CRANK_ROCKER, theta2, at);
            assert!(first.abs() < 1e-12, "{assembly:?} at {theta2}: {first}");
            assert!(second.abs() < 1e-12, "{assembly:?} at {theta2}: {second}");
            let gap = gap(CRANK_ROCKER, theta2, at);
            assert!(gap < 1e-10, "{assembly:?} at {theta2}: {gap}");
        }
    }
}

#[test]
fn agrees_with_the_geometric_method() {
    for assembly in [Assembly::Open, Assembly::Crossed] {
        for theta2 in around() {
            let motion = [theta2, -1.2, 0.4, -0.5, 0.3];
            let ours = solve(CRANK_ROCKER, motion, assembly);
            let other = four_bar_geometric::solve(CRANK_ROCKER, motion, assembly);
            for (ours, other) in [(ours.theta3, other.theta3), (ours.theta4, other.theta4)] {
                let turn = sin((ours[0] - other[0]) / 2.0);
                assert!(turn.abs() < 1e-11, "{assembly:?} at {theta2}: {turn}");
                for order in 1..3 {
                    let error = ours[order] - other[order];
                    assert!(error.abs() < 1e-9, "{assembly:?} at {theta2}: {error}");
                }
            }
        }
    }
}

#[test]
fn half_angle_tangent_fails_at_180_degrees() {
    // Crossed, theta4 is 180 degrees here: the other root is lost with it.
    let linkage = Dimensions {
        r1: 8.0,
        r2: 3.0,
        r3: 5.0,
        r4: 4.0,
    };
    let right_angle = 90f64.to_radians();
    let gap = gap(linkage, right_angle, position(linkage, right_angle, Assembly::Open));
    assert!(gap.is_nan() || gap > 1e-3, "{gap}");
}

#[test]
fn derivatives_follow_from_one_another() {
    for assembly in [Assembly::Open, Assembly::Crossed] {
        for theta2 in around() {
            let motion = [theta2, -1.2, 0.4, -0.5, 0.3];
            let at = |t| solve(CRANK_ROCKER, polynomial(motion, t), assembly);
            let name = |quantity: &str| format!("{quantity} {assembly:?} at {theta2}");
            assert_consistent(&name("theta3"), 1.0, |t| at(t).theta3);
            assert_consistent(&name("theta4"), 1.0, |t| at(t).theta4);
        }
    }
}
