//! Section 3: the slider-crank, exactly.

use kin_tests::notes::slider_crank::{Dimensions, Rod, position, position_offset, solve, solve_offset};

use super::{around, assert_consistent, cos, polynomial, sin};

const DIMENSIONS: Dimensions = Dimensions { r: 0.4, l: 1.1 };
const OFFSET: f64 = 0.15;

#[test]
fn no_offset_is_an_offset_of_nought() {
    for rod in [Rod::Forward, Rod::Backward] {
        for theta in around() {
            assert_eq!(
                position(DIMENSIONS, theta, rod),
                position_offset(DIMENSIONS, 0.0, theta, rod),
            );
        }
    }
}

#[test]
fn the_rod_has_its_length_and_points_its_way() {
    let Dimensions { r, l } = DIMENSIONS;
    for rod in [Rod::Forward, Rod::Backward] {
        for theta in around() {
            let at = position_offset(DIMENSIONS, OFFSET, theta, rod);
            let (x, y) = (at.s - r * cos(theta), OFFSET - r * sin(theta));
            assert!((x.hypot(y) - l).abs() < 1e-14, "{rod:?} at {theta}");
            assert_eq!(x > 0.0, rod == Rod::Forward, "{rod:?} at {theta}");
            assert!((y + l * sin(at.phi)).abs() < 1e-14, "{rod:?} at {theta}");
        }
    }
}

#[test]
fn derivatives_follow_from_one_another() {
    for rod in [Rod::Forward, Rod::Backward] {
        for theta in around() {
            let motion = [theta, -1.2, 0.4, -0.5, 0.3];
            let name = |quantity: &str| format!("{quantity} {rod:?} at {theta}");

            let at = |t| solve(DIMENSIONS, polynomial(motion, t), rod);
            assert_consistent(&name("phi"), 1.0, |t| at(t).phi);
            assert_consistent(&name("s"), 1.0, |t| at(t).s);

            let at = |t| solve_offset(DIMENSIONS, OFFSET, polynomial(motion, t), rod);
            assert_consistent(&name("offset phi"), 1.0, |t| at(t).phi);
            assert_consistent(&name("offset s"), 1.0, |t| at(t).s);
        }
    }
}
