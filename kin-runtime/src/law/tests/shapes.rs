//! The shapes of rises: their peaks, ends and symmetry.

use core::f64::consts::PI;

use super::{Scca, Shape, peaks, shapes};
use crate::law::{Law as _, Piecewise as _, Rise};

fn assert_near(name: &str, found: f64, expected: f64) {
    // the peaks are points where the next derivative vanishes, so that only rounding remains
    assert!(
        (found - expected).abs() <= 1e-12 * expected.abs(),
        "{name}: {found}, not {expected}"
    );
}

/// The peak factors, as formulas. Those of polynomials follow from s' as a power of w = u (1 - u).
#[test]
fn peak_factors_are_those_of_the_books() {
    let square_root = f64::sqrt;
    // s'' = 2520 w³ √(1 - 4w) and s'''' = 15120 w (1 - 7w) √(1 - 4w) of the polynomial 5-6-7-8-9
    let w = (20.0 + square_root(120.0)) / 140.0;
    let ca_sine = 4.0 * PI * PI / ((PI * PI - 8.0) * -0.5 - PI * (PI - 2.0) / 2.0 + PI * PI);
    let ca_trapezoid = 4.0 * PI * PI / (-PI * (PI - 2.0) / 2.0 + PI * PI);
    for (name, shape, expected) in [
        ("constant speed", Shape::ConstantSpeed, [1.0, 0.0, 0.0, 0.0]),
        (
            "simple harmonic",
            Shape::SimpleHarmonic,
            [1, 2, 3, 4].map(|order| 0.5 * PI.powi(order)),
        ),
        (
            "cycloidal",
            Shape::Cycloidal,
            [2.0, 2.0 * PI, 4.0 * PI * PI, 8.0 * PI.powi(3)],
        ),
        (
            "3-4-5",
            Shape::Polynomial345,
            [1.875, 10.0 / square_root(3.0), 60.0, 360.0],
        ),
        (
            "4-5-6-7",
            Shape::Polynomial4567,
            [35.0 / 16.0, 84.0 * square_root(5.0) / 25.0, 52.5, 840.0],
        ),
        (
            "5-6-7-8-9",
            Shape::Polynomial56789,
            [
                315.0 / 128.0,
                2520.0 * 27.0 / 2744.0 / square_root(7.0),
                78.75,
                15120.0 * w * (7.0 * w - 1.0) * square_root(1.0 - 4.0 * w),
            ],
        ),
        (
            "modified sine",
            Shape::ModifiedSine,
            [ca_sine / PI, ca_sine, ca_sine * 4.0 * PI, ca_sine * 16.0 * PI * PI],
        ),
        (
            "modified trapezoid",
            Shape::ModifiedTrapezoid,
            [
                ca_trapezoid * (0.5 / PI + 0.25),
                ca_trapezoid,
                ca_trapezoid * 4.0 * PI,
                ca_trapezoid * 16.0 * PI * PI,
            ],
        ),
    ] {
        let rise = Rise::new(shape, 0.0, 1.0, 1.0).expect("it is a rise");
        for (found, expected) in peaks(&rise).into_iter().zip(expected) {
            assert_near(name, found, expected);
        }
    }
    // as the books print them
    let printed = |shape| peaks(&Rise::new(shape, 0.0, 1.0, 1.0).expect("it is a rise"));
    for (shape, book) in [
        (Shape::ModifiedSine, [1.7596, 5.5280, 69.466]),
        (Shape::ModifiedTrapezoid, [2.0, 4.8881, 61.426]),
        (Shape::Polynomial345, [1.875, 5.7735, 60.0]),
        (Shape::Polynomial4567, [2.1875, 7.5132, 52.5]),
    ] {
        for (found, book) in printed(shape).into_iter().zip(book) {
            assert!((found - book).abs() < 6e-5 * book, "{shape:?}: {found}, printed {book}");
        }
    }
}

/// A rise by h within T has the peaks Cv h/T, Ca h/T² and so on.
#[test]
fn peaks_follow_lift_and_duration() {
    for shape in shapes() {
        let one = peaks(&Rise::new(shape, 0.0, 1.0, 1.0).expect("it is a rise"));
        let other = peaks(&Rise::new(shape, 7.0, -3.0, 0.25).expect("it is a rise"));
        for (order, (one, other)) in (1..).zip(one.into_iter().zip(other)) {
            assert_near("scaled", other, one * 10.0 * 4_f64.powi(order));
        }
    }
}

#[test]
fn the_family_holds_the_other_laws() {
    let member = |shares: [f64; 3]| Shape::Scca(Scca::new(shares[0], shares[1], shares[2]).expect("they fit"));
    for (shares, shape, orders) in [
        ([0.5, 0.0, 0.5], Shape::Cycloidal, 5),
        ([0.0, 0.0, 1.0], Shape::SimpleHarmonic, 5),
        ([0.25, 0.0, 0.75], Shape::ModifiedSine, 5),
        ([0.25, 0.5, 0.25], Shape::ModifiedTrapezoid, 5),
        ([0.0, 0.0, 0.0], Shape::ConstantSpeed, 5),
    ] {
        let one = Rise::new(member(shares), 0.0, 1.0, 1.0).expect("it is a rise");
        let other = Rise::new(shape, 0.0, 1.0, 1.0).expect("it is a rise");
        for step in 0..=97 {
            let time = f64::from(step) / 97.0;
            let (one, other) = (one.at::<5>(time), other.at::<5>(time));
            for order in 0..orders {
                // a dozen roundings of a sine's derivative
                let size = (4.0 * PI).powi(i32::try_from(order).expect("it is small"));
                assert!(
                    (one[order] - other[order]).abs() <= 16.0 * f64::EPSILON * size,
                    "{shape:?}"
                );
            }
        }
    }
    let parabola = Rise::new(member([0.0, 1.0, 0.0]), 0.0, 1.0, 1.0).expect("it is a rise");
    assert_eq!(parabola.at::<4>(0.25).derivatives(), [0.125, 1.0, 4.0, 0.0]);
    assert_eq!(parabola.at::<4>(0.75).derivatives(), [0.875, 1.0, -4.0, 0.0]);
}

/// Rest to rest, exactly, and the second half is the first one rotated about the middle.
#[test]
fn rises_are_exact_at_their_ends_and_symmetrical() {
    for shape in shapes() {
        let (from, to, duration) = (0.1, 0.7, 0.3);
        let rise = Rise::new(shape, from, to, duration).expect("it is a rise");
        assert_eq!(rise.at::<1>(0.0).value(), from, "{shape:?}");
        assert_eq!(rise.at::<1>(duration).value(), to, "{shape:?}");
        let size = peaks(&rise);
        for step in 1..50 {
            let time = duration * f64::from(step) / 101.0;
            let (one, other) = (rise.at::<5>(time), rise.at::<5>(duration - time));
            assert!(
                (one[0] + other[0] - (from + to)).abs() <= 8.0 * f64::EPSILON,
                "{shape:?}"
            );
            for order in 1..5 {
                let sign = if order % 2 == 1 { 1.0 } else { -1.0 };
                // the times differ by a rounding of the duration
                let rounding = 16.0 * f64::EPSILON * (size[order - 1] + size[3.min(order)] * duration);
                assert!(
                    (one[order] - sign * other[order]).abs() <= rounding,
                    "{shape:?} {order}"
                );
            }
        }
    }
}

#[test]
fn outside_a_law_rests() {
    let rise = Rise::new(Shape::ConstantSpeed, 1.0, 3.0, 2.0).expect("it is a rise");
    assert_eq!(rise.at::<3>(-0.1).derivatives(), [1.0, 0.0, 0.0]);
    assert_eq!(rise.at::<3>(0.0).derivatives(), [1.0, 1.0, 0.0]);
    assert_eq!(rise.at::<3>(2.0).derivatives(), [3.0, 1.0, 0.0]);
    assert_eq!(rise.at::<3>(2.1).derivatives(), [3.0, 0.0, 0.0]);
}

#[test]
fn single_precision_follows_double() {
    for shape in shapes() {
        let single = Rise::new(shape, 0.0_f32, 1.0, 1.0).expect("it is a rise");
        let double = Rise::new(shape, 0.0, 1.0, 1.0).expect("it is a rise");
        let size = peaks(&double);
        for step in 0..=32_u8 {
            // in binary, so that it is the same time
            let part = f32::from(step) / 32.0;
            let (single, double) = (single.at::<4>(part), double.at::<4>(f64::from(part)));
            for order in 0..4 {
                let size = if order == 0 { 1.0 } else { size[order - 1] };
                let difference = f64::from(single[order]) - double[order];
                assert!(
                    difference.abs() <= 32.0 * f64::from(f32::EPSILON) * size,
                    "{shape:?} {order}"
                );
            }
        }
        assert_eq!(single.duration(), 1.0);
    }
}
