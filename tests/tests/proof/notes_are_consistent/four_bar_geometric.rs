//! Section 1: the four-bar linkage by the geometric method.

use kin_tests::notes::four_bar_geometric::{Branch, Dimensions, position, solve};
use kin_tests::notes::{Assembly, sample};

use super::{around, assert_consistent, cos, polynomial, sin};

/// A drag link: the crank goes all the way round, and `alpha` and `beta`
/// are acute and obtuse by turns.
const DRAG_LINK: Dimensions = Dimensions {
    r1: 30.0,
    r2: 60.0,
    r3: 55.0,
    r4: 40.0,
};

#[test]
fn sample_table_to_every_printed_digit() {
    let found = solve(sample::DIMENSIONS, sample::THETA2, Assembly::Open);
    for (row, values) in [
        (sample::E, found.e),
        (sample::ALPHA, found.alpha),
        (sample::GAMMA, found.gamma),
        (sample::BETA, found.beta),
        (sample::THETA4, found.theta4),
        (sample::THETA3, found.theta3),
    ] {
        row.assert_agrees(values);
    }
}

#[test]
fn sample_branch_is_the_drawn_one() {
    let branch = Branch::closing(sample::DIMENSIONS, sample::THETA2[0], Assembly::Open);
    assert!(!branch.alpha_obtuse && !branch.beta_obtuse);
}

#[test]
fn positions_close_on_every_branch() {
    let Dimensions { r1, r2, r3, r4 } = DRAG_LINK;
    let mut seen = [false; 4];
    for assembly in [Assembly::Open, Assembly::Crossed] {
        for theta2 in around() {
            let branch = Branch::closing(DRAG_LINK, theta2, assembly);
            seen[usize::from(branch.alpha_obtuse) + 2 * usize::from(branch.beta_obtuse)] = true;
            let at = position(DRAG_LINK, theta2, branch);
            let x = r2 * cos(theta2) + r3 * cos(at.theta3) - r1 - r4 * cos(at.theta4);
            let y = r2 * sin(theta2) + r3 * sin(at.theta3) - r4 * sin(at.theta4);
            assert!(x.hypot(y) < 1e-11, "{branch:?} at {theta2}: {x}, {y}");
        }
    }
    // Both obtuse; alpha alone; neither. (Beta alone cannot be here.)
    assert!(seen[0] && seen[1] && seen[3], "{seen:?}");
}

#[test]
fn derivatives_follow_from_one_another() {
    for assembly in [Assembly::Open, Assembly::Crossed] {
        for (dimensions, theta2) in [
            (sample::DIMENSIONS, sample::THETA2[0]),
            (sample::DIMENSIONS, -1.2),
            (DRAG_LINK, 0.4),   // both obtuse
            (DRAG_LINK, -0.85), // alpha obtuse
            (DRAG_LINK, 2.6),   // neither
        ] {
            let motion = [theta2, -1.2, 0.4, -0.5, 0.3];
            let at = |t| solve(dimensions, polynomial(motion, t), assembly);
            let name = |quantity: &str| format!("{quantity} {assembly:?} at {theta2}");
            assert_consistent(&name("e"), 100.0, |t| at(t).e);
            assert_consistent(&name("alpha"), 1.0, |t| at(t).alpha);
            assert_consistent(&name("gamma"), 1.0, |t| at(t).gamma);
            assert_consistent(&name("beta"), 1.0, |t| at(t).beta);
            assert_consistent(&name("theta4"), 1.0, |t| at(t).theta4);
            assert_consistent(&name("theta3"), 1.0, |t| at(t).theta3);
        }
    }
}
