//! Section 4: the slider-crank, by series in `R/L`.

use kin_tests::notes::slider_crank::{self, Rod};
use kin_tests::notes::slider_crank_approximate::{Dimensions, first, higher_order};

use super::{around, assert_consistent};

const RATE: f64 = -1.3;

#[test]
fn derivatives_follow_from_one_another() {
    let dimensions = Dimensions { r: 0.4, l: 1.1 };
    for theta in around() {
        let name = |quantity: &str| format!("{quantity} at {theta}");
        assert_consistent(&name("first"), 1.0, |t| first(dimensions, theta + RATE * t, RATE));
        assert_consistent(&name("higher order"), 1.0, |t| {
            higher_order(dimensions, theta + RATE * t, RATE)
        });
    }
}

/// The largest difference in `s` from the exact solution, of the two
/// approximations, order by order.
fn errors(dimensions: Dimensions) -> [[f64; 5]; 2] {
    let mut largest = [[0.0; 5]; 2];
    for theta in around() {
        let motion = [theta, RATE, 0.0, 0.0, 0.0];
        let exact = slider_crank::solve(dimensions, motion, Rod::Forward).s;
        for (largest, approximate) in largest
            .iter_mut()
            .zip([first(dimensions, theta, RATE), higher_order(dimensions, theta, RATE)])
        {
            for order in 0..5 {
                largest[order] = f64::max(largest[order], (approximate[order] - exact[order]).abs());
            }
        }
    }
    largest
}

#[test]
fn the_first_neglected_term_is_the_next_power() {
    // Doubling L divides the neglected terms, in 1/L^3 and 1/L^7, by 2^3 and 2^7.
    let [first, higher_order] = errors(Dimensions { r: 2.0, l: 20.0 });
    let [first_half, higher_order_half] = errors(Dimensions { r: 2.0, l: 40.0 });
    for order in 0..5 {
        let power = (first[order] / first_half[order]).log2();
        assert!((power - 3.0).abs() < 0.1, "order {order}: {power}");
        let power = (higher_order[order] / higher_order_half[order]).log2();
        assert!((power - 7.0).abs() < 0.1, "order {order}: {power}");
    }
}
