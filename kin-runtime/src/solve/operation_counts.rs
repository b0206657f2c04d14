//! The published operation counts of the closed forms, measured by running them.

#![cfg(feature = "std")]

use std::format;
use std::string::String;

use crate::assembly::Assembly;
use crate::geometry::Plane;
use crate::number::count::{self, Counted};
use crate::solve;

fn number(value: f64) -> Counted {
    Counted::new(value)
}

fn vector(x: f64, y: f64) -> Plane<Counted> {
    Plane::new(number(x), number(y))
}

/// The counts of additions, multiplications, divisions, negations and square roots, in this order. The function asserts
/// that there are no other operations.
fn counted<R, E: core::fmt::Debug>(solve: impl Fn(Assembly) -> Result<R, E>) -> [String; 2] {
    Assembly::BOTH.map(|assembly| {
        let tally = count::of(|| solve(assembly).map(drop).unwrap());
        assert_eq!(
            tally.sine_cosines + tally.arc_tangents + tally.others,
            0,
            "a closed form needs no transcendental function"
        );
        format!(
            "{}a {}m {}d {}n {}r",
            tally.additions, tally.multiplications, tally.divisions, tally.negations, tally.square_roots
        )
    })
}

macro_rules! counts {
    ($($name:ident: |$assembly:pat_param| $solution:expr => $open:literal, $crossed:literal;)+) => {
        $(
            #[test]
            fn $name() {
                assert_eq!(counted(|$assembly| $solution), [$open, $crossed]);
            }
        )+
    };
}

counts! {
    circle_circle: |assembly| solve::circle_circle(number(3.0), number(4.0), vector(4.0, 3.0), assembly)
        => "8a 12m 1d 0n 1r", "8a 12m 1d 1n 1r";
    circle_circle_squared: |assembly|
        solve::circle_circle_squared(number(9.0), number(16.0), vector(4.0, 3.0), assembly)
        => "6a 11m 1d 0n 1r", "6a 11m 1d 1n 1r";
    circle_line: |assembly| solve::circle_line(number(9.0), vector(0.8, 0.6), vector(4.0, 3.0), assembly)
        => "7a 10m 1d 0n 1r", "7a 10m 1d 0n 1r";
    circle_line_x: |assembly| solve::circle_line_x(number(9.0), vector(4.0, 2.0), assembly)
        => "2a 1m 0d 1n 1r", "2a 1m 0d 0n 1r";
    circle_line_y: |assembly| solve::circle_line_y(number(9.0), vector(2.0, 4.0), assembly)
        => "2a 1m 0d 1n 1r", "2a 1m 0d 0n 1r";
    polar: |assembly| solve::polar(vector(4.0, 3.0), assembly)
        => "1a 2m 0d 0n 1r", "1a 2m 0d 1n 1r";
    polar_offset: |assembly| solve::polar_offset(vector(1.0, 2.0), vector(4.0, 3.0), assembly)
        => "5a 9m 1d 0n 1r", "5a 9m 1d 1n 1r";
    cosine_sine: |assembly| solve::cosine_sine(number(3.0), number(4.0), number(2.0), 7.0, assembly)
        => "4a 9m 1d 0n 1r", "4a 9m 1d 1n 1r";
    inverse_cosine: |assembly| solve::inverse_cosine(number(0.6), number(1.0), assembly)
        => "2a 1m 0d 0n 1r", "2a 1m 0d 1n 1r";
    inverse_sine: |assembly| solve::inverse_sine(number(0.6), number(1.0), assembly)
        => "2a 1m 0d 0n 1r", "2a 1m 0d 1n 1r";
    linear: |_| solve::linear(number(0.6), number(3.0))
        => "0a 0m 1d 0n 0r", "0a 0m 1d 0n 0r";
    linear_pair: |_|
        solve::linear_pair([[number(1.0), number(2.0)], [number(3.0), number(5.0)]], [number(3.0), number(1.0)])
        => "3a 8m 1d 0n 0r", "3a 8m 1d 0n 0r";
    quadratic: |assembly| solve::quadratic(number(1.0), number(-3.0), number(1.0), assembly)
        => "2a 3m 1d 0n 1r", "2a 3m 1d 0n 1r";
    quadratic_downwards: |assembly| solve::quadratic(number(-1.0), number(-3.0), number(1.0), assembly)
        => "2a 3m 1d 0n 1r", "2a 3m 1d 0n 1r";
    square_root: |assembly| solve::square_root(number(2.0), assembly)
        => "0a 0m 0d 0n 1r", "0a 0m 0d 1n 1r";
}
