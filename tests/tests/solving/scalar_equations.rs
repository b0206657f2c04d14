//! One equation for one unknown: every solution that there is, under the name that the documentation gives it.
//!
//! That the derivatives are right is the oracles' matter. Here are values that are known beforehand.

use core::f64::consts::{FRAC_PI_2, PI};

use kin_core::prelude::*;
use kin_tests::compare::turned_back;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::scalar_forms::*;

/// The value of the only unknown, or what is the matter.
fn value<M: ThroughSnap>(parameters: &[f64], input: f64, assembly: M::Assembly) -> Result<f64, Failure> {
    let mechanism = M::from_parameters(M::Parameters::from_fn(|index| parameters[index]));
    mechanism
        .position(M::Inputs::from_fn(|_| input), assembly)
        .map(|unknowns| unknowns[0])
        .map_err(|error| error.failure)
}

/// Both solutions, open first.
fn both<M: ThroughSnap<Assembly = Assembly>>(parameters: &[f64], input: f64) -> [Result<f64, Failure>; 2] {
    Assembly::BOTH.map(|assembly| value::<M>(parameters, input, assembly))
}

#[track_caller]
fn assert_near(found: Result<f64, Failure>, expected: f64) {
    let found = found.expect("there is a solution");
    assert!(
        (found - expected).abs() <= 8.0 * f64::EPSILON * expected.abs().max(1.0),
        "{found} instead of {expected}"
    );
}

#[track_caller]
fn assert_out_of_reach(found: Result<f64, Failure>) {
    assert!(
        matches!(found, Err(Failure::OutOfReach { margin }) if margin < 0.0),
        "{found:?}"
    );
}

#[track_caller]
fn assert_singular(found: Result<f64, Failure>) {
    assert!(matches!(found, Err(Failure::Singular { .. })), "{found:?}");
}

#[track_caller]
fn assert_outside_domain(found: Result<f64, Failure>) {
    assert!(matches!(found, Err(Failure::OutsideDomain { .. })), "{found:?}");
}

#[test]
fn linear() {
    // (3.5 - t²) x = b (1/2 - a t)
    assert_near(value::<LinearForm>(&[0.7, 1.3], 0.0, ()), 1.3 / 7.0);
    assert_near(value::<LinearForm>(&[0.7, 1.3], 1.5, ()), 1.3 * (0.5 - 1.05) / 1.25);
    // the coefficient of x is 3.5 - t², which vanishes up to rounding
    assert_singular(value::<LinearForm>(&[0.7, 1.3], f64::sqrt(3.5), ()));
}

#[test]
fn quadratic_with_both_roots() {
    // (a x + t)(x - b) = -c t, with c = 0: the roots are b and -t/a
    for (a, b, t) in [(1.0, 2.0, 3.0), (-0.5, 1.5, -4.0), (2.0, -3.0, -1.0), (1e-3, 7.0, 0.25)] {
        let mut roots = [b, -t / a];
        roots.sort_by(f64::total_cmp);
        let [open, crossed] = both::<QuadraticForm>(&[a, b, 0.0], t);
        assert_near(open, roots[1]);
        assert_near(crossed, roots[0]);
    }
    // (x + 1)(x - 1) = -c: no root for c > 1, one double root for c = 1
    assert_near(both::<QuadraticForm>(&[1.0, 1.0, 0.75], 1.0)[0], 0.5);
    assert_singular(both::<QuadraticForm>(&[1.0, 1.0, 1.0], 1.0)[0]);
    for root in both::<QuadraticForm>(&[1.0, 1.0, 1.25], 1.0) {
        assert_out_of_reach(root);
    }
    // one root a millionth of a millionth of the other: no digit of it may cancel
    let [open, crossed] = both::<QuadraticForm>(&[1.0, 1e-12, 0.0], 1.0);
    assert_near(open.map(|root| root * 1e12), 1.0);
    assert_near(crossed, -1.0);
}

#[test]
fn quadratic_with_a_range() {
    // x² - (t + b) x + b c = 0 with x > 2: the roots' product is b c = 2
    for t in [-0.5, 0.0, 1.0, 3.0] {
        let half = f64::midpoint(t, 4.0);
        let larger = half + (half * half - 2.0).sqrt();
        assert_near(value::<QuadraticWhere>(&[4.0, 0.5], t, ()), larger);
    }
    // both roots are less than 2
    let below = value::<QuadraticWhere>(&[4.0, 0.5], -1.1, ());
    assert!(
        matches!(below, Err(Failure::OutOfRange { unknown, low: 2.0, value, .. }) if unknown == "x" && value < 2.0),
        "{below:?}"
    );
    // both are more
    let above = value::<QuadraticWhere>(&[4.0, 2.0], 2.0, ());
    assert!(
        matches!(above, Err(Failure::Ambiguous { unknown, .. }) if unknown == "x"),
        "{above:?}"
    );
}

#[test]
fn squares() {
    // x² = t (t + a)
    let [open, crossed] = both::<SquareForm>(&[3.0], 1.0);
    assert_near(open, 2.0);
    assert_near(crossed, -2.0);
    assert_near(value::<SquareWhere>(&[3.0], 1.0, ()), 2.0);
    assert_near(value::<SquareWhereNegative>(&[3.0], 1.0, ()), -2.0);
    for root in both::<SquareForm>(&[3.0], -1.0) {
        assert_out_of_reach(root);
    }
    assert_singular(both::<SquareForm>(&[3.0], -3.0)[0]);
    assert_singular(value::<SquareWhere>(&[3.0], 0.0, ()));
}

/// The sum is a single cosine: r cos(x - φ) = t.
#[test]
fn cosine_and_sine() {
    let (a, b) = (1.2, -0.8);
    let (r, phase) = (f64::hypot(a, b), f64::atan2(b, a));
    for t in [-1.4, -0.5, 0.0, 0.3, 1.4] {
        let [open, crossed] = both::<CircularForm>(&[a, b], t);
        let half = f64::acos(t / r);
        for (found, expected) in [(open, phase + half), (crossed, phase - half)] {
            let found = found.expect("there is a solution");
            // the arc cosine is steep near its ends
            let allowed = 16.0 * f64::EPSILON / half.sin();
            assert!(
                turned_back(found - expected).abs() <= allowed,
                "{found} instead of {expected}"
            );
        }
    }
    for root in both::<CircularForm>(&[a, b], 1.5) {
        let Err(Failure::OutOfReach { margin }) = root else {
            panic!("{root:?}");
        };
        assert!((margin - (r - 1.5)).abs() < 1e-14, "{margin}");
    }
    assert_singular(both::<CircularForm>(&[3.0, 4.0], 5.0)[0]);
    assert_singular(both::<CircularForm>(&[3.0, 4.0], -5.0)[1]);
}

#[test]
fn cosine_sine_and_tangent_alone() {
    let [open, crossed] = both::<CosineForm>(&[2.0], 1.0);
    assert_near(open, PI / 3.0);
    assert_near(crossed, -PI / 3.0);
    let [open, crossed] = both::<SineForm>(&[2.0], 1.0);
    assert_near(open, PI / 6.0);
    assert_near(crossed, 5.0 * PI / 6.0);
    assert_singular(both::<CosineForm>(&[2.0], 2.0)[0]);
    assert_singular(both::<SineForm>(&[2.0], -2.0)[0]);
    assert_out_of_reach(both::<CosineForm>(&[2.0], 2.1)[0]);
    assert_out_of_reach(both::<SineForm>(&[2.0], -2.1)[1]);
    // a tangent has two angles in a turn
    let [open, crossed] = both::<TangentForm>(&[2.0], 2.0);
    assert_near(open, PI / 4.0);
    assert_near(crossed, -3.0 * PI / 4.0);
    assert_near(both::<TangentForm>(&[2.0], 0.0)[0], 0.0);
    // it may be as large as it likes
    assert_near(both::<TangentForm>(&[1.0], 1e12)[0], FRAC_PI_2 - 1e-12);
}

#[test]
fn inverses_of_functions() {
    assert_near(value::<RootForm>(&[2.0], 4.0, ()), 9.0);
    assert_outside_domain(value::<RootForm>(&[2.0], -2.5, ()));

    let [open, crossed] = both::<DistanceForm>(&[3.0], 5.0);
    assert_near(open, 4.0);
    assert_near(crossed, -4.0);
    assert_out_of_reach(both::<DistanceForm>(&[3.0], 2.0)[0]);
    assert_outside_domain(both::<DistanceForm>(&[3.0], -5.0)[0]);
    assert_singular(both::<DistanceForm>(&[3.0], 3.0)[0]);

    assert_near(value::<ArcSineForm>(&[2.0], PI / 6.0, ()), 1.0);
    assert_near(value::<ArcSineForm>(&[2.0], -PI / 6.0, ()), -1.0);
    assert_outside_domain(value::<ArcSineForm>(&[2.0], 2.0, ()));

    assert_near(value::<ArcCosineForm>(&[2.0], 2.0 * PI / 3.0, ()), 1.0);
    assert_near(value::<ArcCosineForm>(&[2.0], PI, ()), 0.0);
    assert_outside_domain(value::<ArcCosineForm>(&[2.0], -0.5, ()));
    assert_outside_domain(value::<ArcCosineForm>(&[2.0], 6.5, ()));

    assert_near(value::<ArcTangentForm>(&[2.0], PI / 4.0, ()), 2.0);
    assert_outside_domain(value::<ArcTangentForm>(&[2.0], 1.6, ()));

    assert_near(value::<ExponentialForm>(&[2.0], 2.0 * f64::exp(3.0), ()), 1.5);
    assert_outside_domain(value::<ExponentialForm>(&[2.0], -1.0, ()));
    assert_outside_domain(value::<ExponentialForm>(&[2.0], 0.0, ()));

    // x (x + a) = exp t
    let [open, crossed] = both::<LogarithmForm>(&[1.0], f64::ln(6.0));
    assert_near(open, 2.0);
    assert_near(crossed, -3.0);
}
