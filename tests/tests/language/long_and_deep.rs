//! Declarations that are long and deep, through the compiler.
#![allow(missing_docs)]

use kin_core::prelude::*;

/// The tokens given ten times, handed on to the next of the macros named.
macro_rules! tenfold {
    ([$next:ident $($later:ident)*] $($tokens:tt)*) => {
        $next! { [$($later)*]
            $($tokens)* $($tokens)* $($tokens)* $($tokens)* $($tokens)*
            $($tokens)* $($tokens)* $($tokens)* $($tokens)* $($tokens)*
        }
    };
}

macro_rules! sum {
    ([] $($terms:tt)*) => {
        mechanism! {
            struct Sum { a: Length, b: Length }
            input t: Scalar;
            unknown x: Length;
            x == b $($terms)* $($terms)* $($terms)* $($terms)* $($terms)*;
        }
    };
}

tenfold! { [tenfold tenfold sum] + a * t }

#[test]
fn a_sum_of_5000_terms_is_solved() {
    let sum: Sum = Sum { a: 0.5, b: 3.0 };
    let pose = sum.solve(Motion::from([2.0, 1.0, 0.0, 0.0, 0.0])).expect("it closes");
    assert_eq!(pose.x.position(), 5003.0);
    assert_eq!(pose.x.velocity(), 2500.0);
    assert_eq!(sum.closure(2.0, [5003.0]), [0.0]);
}

macro_rules! nested {
    ([] $($functions:tt)*) => {
        mechanism! {
            struct Nested { a: Scalar }
            input t: Angle;
            unknown x: Scalar;
            order = 1;
            x == a * t $($functions)* $($functions)*;
        }
    };
}

tenfold! { [tenfold nested] .sin() }

#[test]
fn functions_200_deep_are_solved() {
    let nested: Nested = Nested { a: 2.0 };
    let pose = nested.solve(Motion::from([0.7, 3.0])).expect("it closes");
    let (mut value, mut rate) = (0.7_f64, 3.0);
    for _ in 0..200 {
        (value, rate) = (value.sin(), value.cos() * rate);
    }
    // each of 200 roundings of the angle is made smaller by the sines after it
    assert!((pose.x.position() - 2.0 * value).abs() <= 200.0 * f64::EPSILON * value);
    assert!((pose.x.velocity() - 2.0 * rate).abs() <= 400.0 * f64::EPSILON * rate);
    assert!(nested.closure(0.7, [pose.x.position()])[0].abs() <= 200.0 * f64::EPSILON * value);
}

macro_rules! nested_twice {
    ([] $($functions:tt)*) => {
        mechanism! {
            struct NestedTwice { a: Scalar }
            input t: Scalar;
            unknown x: Scalar, y: Scalar;
            order = 1;
            x == a * t $($functions)* $($functions)*;
            y == a * (t + 1) $($functions)* $($functions)*;
        }
    };
}

tenfold! { [tenfold nested_twice] .sin() }

/// A position keeps 400 cosines for the velocity. A derived comparison of some thousand would end the compiler.
#[test]
fn poses_of_many_values_are_compared() {
    let nested: NestedTwice = NestedTwice { a: 2.0 };
    let [one, same, other] = [0.7, 0.7, 0.8].map(|t| nested.position(t).expect("it closes"));
    assert_eq!(one, same);
    assert_ne!(one, other);
}

macro_rules! signs {
    ([] $($signs:tt)*) => {
        mechanism! {
            struct Signs { a: Scalar }
            input t: Angle;
            unknown x: Scalar;
            x == a * $($signs)* $($signs)* - t;
        }
    };
}

tenfold! { [tenfold signs] - }

#[test]
fn signs_201_deep_are_solved() {
    let signs: Signs = Signs { a: 2.0 };
    let pose = signs.position(0.5).expect("it closes");
    assert_eq!(pose.x.position(), -1.0);
    assert_eq!(signs.closure(0.5, [-1.0]), [0.0]);
}

mechanism! {
    struct Powers { a: Scalar }
    input t: Scalar;
    unknown x: Scalar;
    order = 1;
    x == a * powi(powi(t, 32), 32);
}

#[test]
fn the_highest_power_is_solved() {
    let powers: Powers = Powers { a: 3.0 };
    let base = 1.0 + 1.0 / 1024.0;
    let pose = powers.solve(Motion::from([base, 1.0])).expect("it closes");
    let expected = 3.0 * f64::powi(base, 1024);
    // a product of 1024 factors, and another one to compare it with
    assert!((pose.x.position() - expected).abs() <= 2048.0 * f64::EPSILON * expected);
    assert!((pose.x.velocity() * base / 1024.0 - expected).abs() <= 2048.0 * f64::EPSILON * expected);
}
