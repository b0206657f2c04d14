//! S-curves in random cases.

use super::{Random, of_piece, peaks, pieces};
use crate::law::{Law as _, Limits, Piecewise as _, SCurve};
use crate::number::samples;

/// What is allowed beyond a limit, as a part of it.
const EXCESS: f64 = 1e-12;

fn case(random: &mut Random, with_snap: bool) -> ([f64; 2], [f64; 4], SCurve) {
    let from = random.signed(10.0);
    let distance = random.size(1e-3, 1e3);
    let to = if random.part() < 0.5 {
        from + distance
    } else {
        from - distance
    };
    let [velocity, acceleration, jerk, snap] = [0.0; 4].map(|_: f64| random.size(1e-3, 1e3));
    let limits = Limits {
        velocity,
        acceleration,
        jerk,
        snap: with_snap.then_some(snap),
    };
    let law = SCurve::new(from, to, limits).expect("limits and distance are positive");
    let snap = if with_snap { snap } else { f64::INFINITY };
    ([from, to], [velocity, acceleration, jerk, snap], law)
}

/// Up to ten thousand cases of either kind: within the limits, over the distance, and always at one of the limits.
#[test]
fn limits_hold_and_one_is_always_reached() {
    let mut random = Random(1);
    let mut phases = [0_u32; 16];
    for number in 0..samples::of(20_000) {
        let with_snap = number % 2 == 0;
        let ([from, to], limits, law) = case(&mut random, with_snap);
        let duration = law.duration();
        let at_rest = |time: f64| law.at::<3>(time).derivatives();
        assert_eq!(at_rest(0.0), [from, 0.0, 0.0]);
        assert_eq!(at_rest(duration), [to, 0.0, 0.0]);

        let orders = if with_snap { 4 } else { 3 };
        let found = pieces(&law);
        phases[found.len()] += 1;
        for &(piece, start, end) in &found {
            for sample in 0..=6_u8 {
                let time = start + (end - start) * f64::from(sample) / 6.0;
                let motion: [f64; 5] = of_piece(&law, piece, time);
                let parts: std::vec::Vec<f64> = (1..=orders)
                    .map(|order| motion[order].abs() / limits[order - 1])
                    .collect();
                assert!(parts.iter().all(|&part| part <= 1.0 + EXCESS), "{law:?}: {parts:?}");
                assert!(parts.iter().any(|&part| part >= 1.0 - EXCESS), "{law:?}: {parts:?}");
            }
        }

        // the two halves, each computed from another end, meet: distance and velocity are exact to rounding, that of
        // theirs and that of time
        let mut sizes = [0.0; 5];
        sizes[0] = (to - from).abs() + from.abs();
        sizes[1..].copy_from_slice(&limits);
        for meeting in found.windows(2) {
            let [left, right]: [[f64; 5]; 2] = [
                of_piece(&law, meeting[0].0, meeting[0].2),
                of_piece(&law, meeting[1].0, meeting[1].1),
            ];
            for order in 0..orders {
                let rounding = f64::EPSILON * (16.0 * sizes[order] + 4.0 * duration * sizes[order + 1]);
                let jump = right[order] - left[order];
                assert!(jump.abs() <= rounding, "{law:?}: order {order} jumps by {jump}");
            }
        }
        if number % 16 < 2 {
            let mut joints = law.joints::<5>();
            assert!(
                joints.all(|joint| joint.first_jump().is_none_or(|order| order >= orders)),
                "{law:?}"
            );
        }
    }
    // the whole forms and the shortest ones occur
    assert!(
        phases[15] > 0 && phases[8] > 0 && phases[7] > 0 && phases[4] > 0,
        "{phases:?}"
    );
}

/// The peaks between the ends of the phases do not exceed the limits either.
#[test]
fn peaks_are_within_the_limits() {
    let mut random = Random(2);
    for number in 0..samples::of(500) {
        let (_, limits, law) = case(&mut random, number % 2 == 0);
        for (peak, limit) in peaks(&law).into_iter().zip(limits) {
            assert!(peak <= limit * (1.0 + EXCESS), "{law:?}");
        }
    }
}

/// Unlimited snap is the limit of a large one, and the velocity's integral is the distance.
#[test]
fn seven_phases_are_the_limit_of_fifteen() {
    let limits = Limits {
        velocity: 2.0,
        acceleration: 10.0,
        jerk: 200.0,
        snap: None,
    };
    let seven = SCurve::new(0.0, 1.0, limits).expect("it is one");
    assert_eq!(pieces(&seven).len(), 7);
    let fifteen = SCurve::new(
        0.0,
        1.0,
        Limits {
            snap: Some(2e9),
            ..limits
        },
    )
    .expect("it is one");
    assert_eq!(pieces(&fifteen).len(), 15);
    assert!((seven.duration() - fifteen.duration()).abs() < 2e-7);
}

/// With one limit in effect, the duration has a closed form.
#[test]
fn durations_of_pure_motions() {
    let far = 1e6;
    let (distance, limit) = (3.0_f64, 7.0);
    let limits = |velocity, acceleration, jerk, snap| Limits {
        velocity,
        acceleration,
        jerk,
        snap,
    };
    // D = J T³ / 32
    let law = SCurve::new(0.0, distance, limits(far, far, limit, None)).expect("it is one");
    assert!((law.duration() - (32.0 * distance / limit).cbrt()).abs() < 1e-15 * 4.0);
    assert_eq!(pieces(&law).len(), 4);
    // D = S T⁴ / 512
    let law = SCurve::new(0.0, distance, limits(far, far, far, Some(limit))).expect("it is one");
    assert!((law.duration() - (512.0 * distance / limit).sqrt().sqrt()).abs() < 1e-15 * 8.0);
    assert_eq!(pieces(&law).len(), 8);
}

#[test]
fn extreme_units_are_no_problem_or_an_error() {
    for power in [-40, -20, 20, 40] {
        let unit = 10_f64.powi(power);
        let limits = Limits {
            velocity: 2.0 * unit,
            acceleration: 10.0 * unit,
            jerk: 200.0 * unit,
            snap: Some(1e4 * unit),
        };
        let law = SCurve::new(0.0, unit, limits).expect("it is one");
        assert!(law.at::<5>(0.3 * law.duration()).is_finite());
    }
    let limits = Limits {
        velocity: 1e-300,
        acceleration: 1e-300,
        jerk: 1e-300,
        snap: Some(1e-300),
    };
    assert!(SCurve::new(0.0, 1e300, limits).is_err());
}
