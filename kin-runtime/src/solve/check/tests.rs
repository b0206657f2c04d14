//! A number that records the decisions about it, and tests of those decisions.

use core::cell::RefCell;
use core::f64::consts::TAU;
use core::ops::{Add, Div, Mul, Neg, Sub};
use std::vec::Vec;

use proptest::prelude::*;

use super::{Check, Choose};
use crate::assembly::Assembly;
use crate::batch::lanes::Lanes;
use crate::failure::Failure;
use crate::geometry::Plane;
use crate::number::Number;
use crate::solve::check::SolutionInRange;
use crate::solve::check::regular::Regular;
use crate::solve::{self, Scalar};

/// A double-precision number that records the names and margins of all checks.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Recorded(f64);

std::thread_local! {
    static NOTES: RefCell<Vec<(&'static str, f64)>> = const { RefCell::new(Vec::new()) };
}

/// The records made while `work` runs, and its result.
fn notes_of<R>(work: impl FnOnce() -> R) -> (R, Vec<(&'static str, f64)>) {
    NOTES.take();
    let result = work();
    (result, NOTES.take())
}

fn note(name: &'static str, margin: Recorded) {
    NOTES.with_borrow_mut(|notes| notes.push((name, margin.0)));
}

macro_rules! operators {
    ($($trait:ident $method:ident,)+) => {
        $(
            impl $trait for Recorded {
                type Output = Self;

                fn $method(self, other: Self) -> Self {
                    Self(self.0.$method(other.0))
                }
            }
        )+
    };
}

operators! { Add add, Sub sub, Mul mul, Div div, }

impl Neg for Recorded {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! functions {
    ($($method:ident)+) => {
        $(
            fn $method(self) -> Self {
                Self(Number::$method(self.0))
            }
        )+
    };
}

impl Number for Recorded {
    const EPSILON: f64 = f64::EPSILON;

    fn constant(value: f64) -> Self {
        Self(value)
    }

    fn real(self) -> f64 {
        self.0
    }

    fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    functions! { sqrt asin acos atan sinh cosh tanh asinh acosh atanh exp ln }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = Number::sin_cos(self.0);
        (Self(sine), Self(cosine))
    }

    fn atan2(self, x: Self) -> Self {
        Self(Number::atan2(self.0, x.0))
    }
}

impl Scalar for Recorded {
    fn provided<const N: usize, const K: usize>(self, check: impl Check<Self, N, K>) -> Option<Self> {
        note(check.name(), check.margin());
        let holds = check.holds(check.operands().map(Self::real));
        holds.iter().all(|holds| *holds).then_some(self)
    }

    fn chosen<const N: usize>(choice: impl Choose<Self, N>) -> Result<Assembly, Failure> {
        note(choice.name().text().unwrap(), choice.margin());
        choice.choose(choice.operands().map(Self::real))
    }
}

fn vector([x, y]: [f64; 2]) -> Plane<Recorded> {
    Plane::new(Recorded(x), Recorded(y))
}

/// A result, and the checks made for it with their margins.
type Noted = (Result<(), Failure>, Vec<(&'static str, f64)>);

/// Where a closed form is out of reach, its check has the name and the margin of the failure.
#[test]
fn checks_know_the_margins_of_the_failures() {
    let (r, assembly) = (Recorded, Assembly::Open);
    let cases: [(&str, Noted); 11] = [
        (
            "reach of two circles",
            notes_of(|| solve::circle_circle(r(3.0), r(4.0), vector([6.0, 5.0]), assembly).map(drop)),
        ),
        (
            "reach of two circles",
            notes_of(|| solve::circle_circle(r(9.0), r(4.0), vector([1.0, 1.5]), assembly).map(drop)),
        ),
        (
            "reach of two circles",
            notes_of(|| solve::circle_circle_squared(r(9.0), r(16.0), vector([6.0, 5.0]), assembly).map(drop)),
        ),
        (
            "reach of a circle and a line",
            notes_of(|| solve::circle_line(r(4.0), vector([3.0, 1.0]), vector([-1.0, 7.0]), assembly).map(drop)),
        ),
        (
            "reach of a circle and an axis",
            notes_of(|| solve::circle_line_y(r(4.0), vector([-3.0, 7.0]), assembly).map(drop)),
        ),
        (
            "reach of a cosine and a sine",
            notes_of(|| solve::cosine_sine(r(1.0), r(-2.0), r(3.0), 3.0, assembly).map(drop)),
        ),
        (
            "reach of a link",
            notes_of(|| solve::inverse_sine(r(-3.0), r(2.0), assembly).map(drop)),
        ),
        (
            "reach of an offset slide",
            notes_of(|| solve::polar_offset(vector([1.0, -4.0]), vector([2.0, 3.0]), assembly).map(drop)),
        ),
        (
            "reach of a parabola",
            notes_of(|| solve::quadratic(r(-2.0), r(1.0), r(-3.0), assembly).map(drop)),
        ),
        (
            "positive square",
            notes_of(|| solve::square_root(r(-2.0), assembly).map(drop)),
        ),
        ("asin", notes_of(|| solve::arc_sine(r(1.5)).map(drop))),
    ];
    for (name, (result, notes)) in cases {
        let margin = match result.unwrap_err() {
            Failure::OutOfReach { margin } => margin,
            Failure::OutsideDomain { argument, .. } => 1.0 - argument,
            failure => panic!("{name}: {failure:?}"),
        };
        let [(noted, recorded)] = notes[..] else {
            panic!("{name}: {notes:?}");
        };
        assert_eq!(noted, name);
        assert!(
            (recorded - margin).abs() <= 16.0 * f64::EPSILON * 10.0,
            "{name}: {recorded} {margin}"
        );
    }
}

/// All checks of a solvable problem hold with a positive margin.
#[test]
fn margins_are_positive_where_checks_hold() {
    let (solved, notes) = notes_of(|| {
        let (first, _) = solve::circle_circle(Recorded(3.0), Recorded(4.0), vector([5.0, 0.0]), Assembly::Open)?;
        let chosen = solve::choose([SolutionInRange::angle("theta", [first.x, first.y], 1.0, 2.0)])?;
        solve::regular(first.y)?;
        Ok::<_, Failure>(chosen)
    });
    assert_eq!(solved, Ok(Assembly::Open));
    let expected = [
        ("reach of two circles", 2.0),
        ("theta", 0.2),
        ("regular determinant", 2.4),
    ];
    assert_eq!(notes.len(), expected.len());
    for ((name, margin), (expected_name, expected)) in notes.into_iter().zip(expected) {
        assert_eq!(name, expected_name);
        assert!((margin - expected).abs() <= 16.0 * f64::EPSILON, "{name}: {margin}");
    }
}

/// Each of several poses has a separate margin.
#[test]
fn lanes_have_margins() {
    let determinants = Lanes::<4, 128>([0.5, -2.0, 0.0, f64::NAN]);
    let margins = Regular(determinants).margin();
    assert_eq!(margins.0[..3], [0.5, 2.0, 0.0]);
    assert!(margins.0[3].is_nan());
}

/// Numbers in a range and outside of it, at its ends up to rounding, and numbers that are not finite.
fn about(low: f64, high: f64) -> impl Strategy<Value = f64> {
    let end = prop_oneof![Just(low), Just(high), Just(low.midpoint(high))];
    let beside = (end, -40..=40_i32, -2..=2_i32)
        .prop_map(|(end, units, revolutions)| end + f64::from(units) * f64::EPSILON + f64::from(revolutions) * TAU);
    prop_oneof![8 => -20.0..20.0, 8 => beside, 1 => Just(f64::NAN), 1 => Just(f64::INFINITY)]
}

fn range_and_solutions() -> impl Strategy<Value = (f64, f64, [f64; 2])> {
    let range = prop_oneof![
        (-7.0..7.0, 0.0..8.0).prop_map(|(low, width)| (low, low + width)),
        (-7.0..7.0).prop_map(|high| (f64::NEG_INFINITY, high)),
        (-7.0..7.0).prop_map(|low| (low, f64::INFINITY)),
        // a range of rounding alone
        (-7.0..7.0).prop_map(|low| (low, low + 4.0 * f64::EPSILON)),
    ];
    range.prop_flat_map(|(low, high)| {
        let finite = |end: f64| if end.is_finite() { end } else { 0.0 };
        let number = about(finite(low), finite(high));
        let solutions = (number, -40..=40_i32, about(finite(low), finite(high)), any::<bool>());
        solutions.prop_map(move |(first, units, second, is_near)| {
            let near = first + f64::from(units) * f64::EPSILON;
            (low, high, [first, if is_near { near } else { second }])
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    /// What a record of a choice compares chooses what one pose chooses, and fails with the same numbers.
    #[test]
    fn validity_is_the_choice((low, high, solutions) in range_and_solutions(), is_angle in any::<bool>()) {
        let choice = if is_angle {
            SolutionInRange::angle("x", solutions, low, high)
        } else {
            SolutionInRange::value("x", solutions, low, high)
        };
        let validity = choice.validity(solutions);
        let inside = |value: f64| (value - low).min(high - value);
        match choice.choose(solutions) {
            Err(Failure::NotFinite { .. }) => prop_assert!(!validity.are_finite),
            Err(Failure::OutOfRange { value, .. }) => {
                prop_assert!(validity.are_finite && !validity.has_one);
                prop_assert_eq!(validity.margin_of_one.to_bits(), inside(value).to_bits());
                prop_assert!(validity.margin_of_one < 0.0);
            }
            Err(Failure::Ambiguous { first, second, .. }) => {
                prop_assert!(validity.are_finite && validity.has_one && validity.has_two);
                prop_assert_eq!(validity.margin_of_two, -inside(first).min(inside(second)));
            }
            Ok(assembly) => {
                prop_assert!(validity.are_finite && validity.has_one && !validity.has_two);
                prop_assert_eq!(validity.is_first, assembly == Assembly::Open);
            }
            Err(other) => prop_assert!(false, "{:?}", other),
        }
    }
}
