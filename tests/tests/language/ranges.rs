//! Ranges that pick the branch: when the declaration is compiled where that can be known, and at run time elsewhere.

use core::f64::consts::{FRAC_PI_2, PI};

use kin_core::library::FourBar;
use kin_core::prelude::*;
use kin_tests::compare::turned_back;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::cases::{self, Case, Visitor};
use kin_tests::mechanisms::ranged::*;
use kin_tests::random::Random;

const SAMPLE: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};
const PARAMETERS: [f64; 4] = [90.0, 30.0, 60.0, 45.0];

/// Whatever comes out lies in the declared range, on the declared turn, and it is the same motion as without a range.
#[test]
fn a_coupler_that_points_upwards() {
    let ranged = RangedCoupler::<f64>::from_parameters(PARAMETERS);
    let mut random = Random::new(41);
    let (mut found, mut refused, mut ambiguous) = (0, 0, 0);
    for step in 0..380 {
        let crank = Motion::new(random.motion(-1.9 + 0.01 * f64::from(step)));
        let candidates: Vec<_> = Assembly::BOTH
            .into_iter()
            .filter_map(|assembly| SAMPLE.solve(crank, assembly).ok())
            .collect();
        let inside: Vec<_> = candidates.iter().filter(|pose| pose.theta3.value() >= 0.0).collect();
        match (ranged.solve(crank), inside.as_slice()) {
            (Ok(own), [only]) => {
                assert_eq!(own.unknown_motions(), only.unknown_motions());
                found += 1;
            }
            (Err(error), []) => {
                let Failure::OutOfRange {
                    unknown,
                    value,
                    low,
                    high,
                    is_angle: true,
                } = error.failure
                else {
                    panic!("{error}");
                };
                assert_eq!((unknown, low, high), ("theta3".into(), 0.0, PI));
                // on whichever turn it is nearest to the range
                assert!(!(low..=high).contains(&value));
                let is_solution = |angle: f64| turned_back(angle - value).abs() < 1e-15 * 8.0;
                assert!(candidates.iter().any(|pose| is_solution(pose.theta3.value())));
                refused += 1;
            }
            (Err(error), [first, second]) => {
                let expected = Failure::Ambiguous {
                    unknown: "theta3".into(),
                    first: first.theta3.value(),
                    second: second.theta3.value(),
                    is_angle: true,
                };
                assert_eq!(error.failure, expected);
                ambiguous += 1;
            }
            (own, inside) => panic!("{own:?} of {} inside at {crank:?}", inside.len()),
        }
    }
    assert!(found > 100 && refused + ambiguous > 20, "{found} {refused} {ambiguous}");
}

/// The range is 4π ..= 5π: the upper half of the plane, on the third turn.
#[test]
fn a_rocker_on_the_third_turn() {
    let ranged = RangedRocker::<f64>::from_parameters(PARAMETERS);
    let mut found = 0;
    for step in 0..380 {
        let crank = Motion::at_constant_speed(-1.9 + 0.01 * f64::from(step), 2.0);
        let Ok(own) = ranged.solve(crank) else {
            continue;
        };
        assert!((4.0 * PI..=5.0 * PI).contains(&own.theta4.value()));
        let same = Assembly::BOTH
            .into_iter()
            .filter_map(|assembly| SAMPLE.solve(crank, assembly).ok())
            .any(|pose| {
                turned_back(pose.theta4.value() - own.theta4.value()).abs() < 1e-14
                    && pose.theta4.derivatives()[1..] == own.theta4.derivatives()[1..]
                    && pose.theta3 == own.theta3
            });
        assert!(same);
        found += 1;
    }
    assert!(found > 200, "{found}");
}

/// An angle of a triangle by the law of cosines, and an angle by its sine: no assembly is left to be asked for.
#[test]
fn branches_that_are_picked_when_compiled() {
    let above = RangedAngle::<f64>::from_parameters([2.0, 3.0]);
    let below = RangedAngleBelow::<f64>::from_parameters([2.0, 3.0]);
    let acute = RangedSine::<f64>::from_parameters([1.5]);
    let obtuse = RangedSineObtuse::<f64>::from_parameters([1.5]);
    for step in 1..40 {
        let c = Motion::at_constant_speed(1.0 + 0.1 * f64::from(step), 1.0);
        let (own, other) = (above.solve(c).expect("a triangle"), below.solve(c).expect("a triangle"));
        assert!((0.0..=PI).contains(&own.gamma.value()));
        assert_eq!(own.gamma, -other.gamma);
        let t = Motion::at_constant_speed(-1.5 + 0.075 * f64::from(step), 1.0);
        let (own, other) = (acute.solve(t).expect("a sine"), obtuse.solve(t).expect("a sine"));
        assert!((-FRAC_PI_2..=FRAC_PI_2).contains(&own.x.value()));
        assert!((FRAC_PI_2..=3.0 * FRAC_PI_2).contains(&other.x.value()));
        assert!((own.x.value() + other.x.value() - PI).abs() < 1e-15 * 4.0);
    }
    let error = above.position(5.5).expect_err("no triangle");
    assert!(matches!(error.failure, Failure::OutOfReach { .. }), "{error}");
}

#[test]
fn lengths_of_either_sign() {
    let ranged = RangedLever::<f64>::from_parameters([2.0, 0.8]);
    let pose = ranged.position(1.0).expect("the lever reaches the pin");
    assert!(pose.r4.value() < 0.0);
    let checked = RangedLinear::<f64>::from_parameters([1.5]);
    assert_eq!(checked.position(2.0).map(|pose| pose.x.value()), Ok(3.0));
    let error = checked.position(7.0).expect_err("beyond the end");
    assert_eq!(
        error.failure,
        Failure::OutOfRange {
            unknown: "x".into(),
            value: 10.5,
            low: 0.0,
            high: 10.0,
            is_angle: false
        }
    );
}

/// With the slide along an axis, the rod's angle is sought before the slider: the range of the slider cannot pick its
/// branch, but it is kept.
#[test]
fn a_range_of_a_later_block_is_kept() {
    let ranged = RangedSlider::<f64>::from_parameters([1.0, 3.0, 0.4]);
    assert!(
        ranged
            .position(0.3, Assembly::Crossed)
            .is_ok_and(|pose| pose.s.value() < 0.0)
    );
    let error = ranged.position(0.3, Assembly::Open).expect_err("on the far side");
    assert!(
        matches!(error.failure, Failure::OutOfRange { unknown, value, high: 0.0, .. } if unknown == "s" && value > 0.0),
        "{error}"
    );
}

/// Ranges that hold for every test mechanism hold for what comes out of it.
#[test]
fn no_range_is_ever_left() {
    struct Check(usize);
    impl Visitor for Check {
        fn visit<M: ThroughSnap>(&mut self, case: Case) {
            let mut random = Random::new(42);
            for step in 0..60 {
                let mechanism: M = case.varied(&mut random);
                let inputs = case.inputs::<M>(f64::from(step) / 60.0, &mut random);
                for assembly in M::assemblies() {
                    match mechanism.solve(inputs, assembly) {
                        Ok(pose) => assert!(pose.unknown_motions().as_ref().iter().all(Motion::<f64, 5>::is_finite)),
                        Err(error) => assert!(!error.to_string().is_empty()),
                    }
                    self.0 += 1;
                }
            }
        }
    }
    let mut check = Check(0);
    cases::ranges(&mut check);
    assert!(check.0 >= 400, "{}", check.0);
}
