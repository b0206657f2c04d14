//! Laws that do not exist.

use super::Scca;
use crate::law::{
    ConstantSpeed, Dwell, Fourier, LawError, Limits, Piecewise, Polynomial, Rise, SCurve, Sequence, Shape,
};
use crate::motion::Motion;
use std::string::ToString;

#[test]
fn numbers_that_are_not_positive_or_finite_are_refused() {
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let is_refused = |error: Option<LawError>| matches!(error, Some(LawError::NotPositive { .. }));
        assert!(is_refused(Dwell::new(0.0, wrong).err()));
        assert!(is_refused(ConstantSpeed::new(0.0, 1.0, wrong).err()));
        assert!(is_refused(Rise::new(Shape::Cycloidal, 0.0, 1.0, wrong).err()));
        assert!(is_refused(Fourier::new(0.0, [[1.0, 0.0]], wrong).err()));
        let still = Motion::from([0.0]);
        assert!(is_refused(Polynomial::<f64, 2>::between(still, still, wrong).err()));
        for index in 0..4 {
            let mut numbers = [1.0; 4];
            numbers[index] = wrong;
            let [velocity, acceleration, jerk, snap] = numbers;
            let limits = Limits {
                velocity,
                acceleration,
                jerk,
                snap: Some(snap),
            };
            assert!(is_refused(SCurve::new(0.0, 1.0, limits).err()));
        }
    }
    for wrong in [f64::NAN, f64::NEG_INFINITY] {
        let is_refused = |error: Option<LawError>| matches!(error, Some(LawError::NotFinite { .. }));
        assert!(is_refused(Dwell::new(wrong, 1.0).err()));
        assert!(is_refused(ConstantSpeed::new(0.0, wrong, 1.0).err()));
        assert!(is_refused(Rise::new(Shape::Cycloidal, 0.0, wrong, 1.0).err()));
        assert!(is_refused(Fourier::new(0.0, [[1.0, wrong]], 1.0).err()));
        let (still, state) = (Motion::from([0.0]), Motion::from([0.0, wrong]));
        assert!(is_refused(Polynomial::<f64, 3>::between(state, still, 1.0).err()));
        assert!(is_refused(Polynomial::<f64, 3>::between(still, state, 1.0).err()));
        assert!(is_refused(Scca::new(wrong, 0.0, 0.0).err()));
    }
}

#[test]
fn messages_have_numbers() {
    let limits = Limits {
        velocity: 1.0,
        acceleration: 1.0,
        jerk: 1.0,
        snap: None,
    };
    let message = |error: Option<LawError>| error.expect("it is refused").to_string();
    assert_eq!(
        message(SCurve::new(2.0, 2.0, limits).err()),
        "the S-curve starts and ends at 2, and no move takes no time: leave it out, or hold the value by a `Dwell`"
    );
    assert_eq!(
        message(Scca::new(0.5, 0.5, 0.25).err()),
        "the least share of the duration is 0.25 and the sum of the shares is 1.25; no share may be negative, and the \
         sum may be 1 at most"
    );
    assert_eq!(
        Scca::new(-0.5, 0.5, 0.25).err(),
        Some(LawError::Shares { least: -0.5, sum: 0.25 })
    );
    assert_eq!(
        message(Sequence::<[&dyn Piecewise<f64>; 0]>::new([]).err()),
        "the sequence is empty; it needs one law at least"
    );
    let state = Motion::from([0.0, 1e300]);
    assert!(matches!(
        Polynomial::<f64, 3>::between(state, Motion::from([0.0]), 1e300).err(),
        Some(LawError::OutOfRange { .. })
    ));
}
