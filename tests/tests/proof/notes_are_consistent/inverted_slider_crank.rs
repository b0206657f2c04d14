//! Section 5: the inverted slider-crank.

use kin_tests::notes::inverted_slider_crank::{Branch, Dimensions, position, solve};

use super::{around, assert_consistent, cos, polynomial, sin};

/// The lever swings to and fro, always acute.
const SWINGING: Dimensions = Dimensions { r1: 2.0, r2: 0.9 };
/// The lever goes all the way round.
const ROTATING: Dimensions = Dimensions { r1: 0.9, r2: 2.0 };

#[test]
fn positions_close_on_every_branch() {
    let mut obtuse_seen = false;
    for dimensions in [SWINGING, ROTATING] {
        for r4_negative in [false, true] {
            for theta2 in around() {
                let Dimensions { r1, r2 } = dimensions;
                let branch = Branch::closing(dimensions, theta2, r4_negative);
                obtuse_seen |= branch.theta4_obtuse && !r4_negative;
                let at = position(dimensions, theta2, branch);
                assert_eq!(at.r4 < 0.0, r4_negative);
                let x = r1 + r2 * cos(theta2) - at.r4 * cos(at.theta4);
                let y = r2 * sin(theta2) - at.r4 * sin(at.theta4);
                assert!(x.hypot(y) < 1e-13, "{branch:?} at {theta2}: {x}, {y}");
            }
        }
    }
    assert!(obtuse_seen);
}

#[test]
fn derivatives_follow_from_one_another() {
    for (dimensions, theta2) in [
        (SWINGING, 0.8),
        (SWINGING, 2.4),
        (SWINGING, -1.1),
        (ROTATING, 0.8),
        (ROTATING, 2.6),  // obtuse
        (ROTATING, -2.7), // obtuse
    ] {
        for r4_negative in [false, true] {
            let motion = [theta2, -1.2, 0.4, -0.5, 0.3];
            let at = |t| solve(dimensions, polynomial(motion, t), r4_negative);
            let name = |quantity: &str| format!("{quantity}, {dimensions:?} at {theta2}");
            assert_consistent(&name("r4"), 1.0, |t| at(t).r4);
            assert_consistent(&name("theta4"), 1.0, |t| at(t).theta4);
        }
    }
}
