//! Sequences, their sides, and the report of their joints.

use super::{Random, Scca, shapes};
use crate::law::{
    ConstantSpeed, Dwell, Fourier, Law as _, LawJoint, Limits, Piecewise as _, Rise, SCurve, Sequence, Shape,
};
use crate::motion::Motion;
use std::string::ToString;

/// The first derivative that jumps beside a dwell, as the books state it.
#[test]
fn shapes_beside_dwells() {
    for (shape, order) in [
        (Shape::ConstantSpeed, Some(1)),
        (Shape::SimpleHarmonic, Some(2)),
        (Shape::Cycloidal, Some(3)),
        (Shape::Polynomial345, Some(3)),
        (Shape::ModifiedSine, Some(3)),
        (Shape::ModifiedTrapezoid, Some(3)),
        (Shape::Polynomial4567, Some(4)),
        (Shape::Polynomial56789, Some(5)),
    ] {
        let low = Dwell::new(0.0, 0.3).expect("it is one");
        let rise = Rise::new(shape, 0.0, 0.03, 0.7).expect("it is one");
        let high = Dwell::new(0.03, 11.0).expect("it is one");
        let law = Sequence::new([&low, &rise, &high]).expect("it is one");
        for time in [0.3, 1.0_f64] {
            let joint = law.joints::<6>().find(|joint| (joint.time - time).abs() < 1e-12);
            assert_eq!(
                joint.expect("there is a joint").first_jump(),
                order,
                "{shape:?} at {time}"
            );
        }
        let first = law.joints::<6>().next().expect("there is a start");
        assert_eq!((first.first_jump(), first.continuity()), (None, Some(5)));
    }
}

#[test]
fn inner_joints_are_reported() {
    let rise = Rise::new(Shape::ModifiedTrapezoid, 0.0, 1.0, 1.0).expect("it is one");
    let joints: std::vec::Vec<_> = rise.joints::<5>().collect();
    let times: std::vec::Vec<f64> = joints.iter().map(|joint| joint.time).collect();
    assert_eq!(times, [0.0, 0.125, 0.375, 0.5, 0.625, 0.875, 1.0]);
    let first: std::vec::Vec<_> = joints.iter().map(LawJoint::first_jump).collect();
    // at the middle two cosines meet that continue each other
    assert_eq!(first, [Some(3), Some(4), Some(4), None, Some(4), Some(4), Some(3)]);
}

/// Sine and cosine meet with continuous jerk; constant speed begins and ends with a jump of it.
#[test]
fn constant_speed_joins_sine_and_cosine() {
    let shape = Shape::Scca(Scca::new(0.2, 0.0, 0.6).expect("they fit"));
    let rise = Rise::new(shape, 0.0, 1.0, 1.0).expect("it is one");
    let joints: std::vec::Vec<_> = rise.joints::<5>().collect();
    for (joint, time) in joints.iter().zip([0.0, 0.1, 0.4, 0.6, 0.9, 1.0_f64]) {
        assert!((joint.time - time).abs() <= f64::EPSILON);
    }
    let first: std::vec::Vec<_> = joints.iter().map(LawJoint::first_jump).collect();
    assert_eq!(first, [Some(3), Some(4), Some(3), Some(3), Some(4), Some(3)]);
    // a sum of four terms
    assert!((rise.at::<1>(0.5).value() - 0.5).abs() <= 2.0 * f64::EPSILON);
}

#[test]
fn the_report_names_every_jump() {
    let dwell = Dwell::new(1.0, 1.0).expect("it is one");
    let run = ConstantSpeed::new(3.0, -2.0, 1.0).expect("it is one");
    let law = Sequence::new([&dwell, &run]).expect("it is one");
    let report: std::vec::Vec<_> = law.joints::<3>().map(|joint| joint.to_string()).collect();
    assert_eq!(
        report,
        [
            "C2 at 0",
            "not continuous at 1: value jumps by 2, velocity jumps by -2",
            "C0 at 2: velocity jumps by 2",
        ]
    );
    // the value there is that of the right side
    assert_eq!(law.at::<2>(1.0).derivatives(), [3.0, -2.0]);
}

#[test]
fn a_law_that_repeats_meets_itself() {
    let up = Rise::new(Shape::Polynomial4567, 0.0, 1.0, 0.4).expect("it is one");
    let down = Rise::new(Shape::Polynomial4567, 1.0, 0.0, 0.6).expect("it is one");
    let cam = Sequence::new([&up, &down]).expect("it is one").repeated();
    assert_eq!(cam.joints::<4>().count(), 2);
    assert!(cam.joints::<4>().all(|joint| joint.first_jump().is_none()));
    let [first, second] = [0, 1].map(|index| cam.joints::<5>().nth(index).expect("there are two"));
    assert_eq!((first.first_jump(), second.first_jump()), (Some(4), Some(4)));
    for periods in [-3.0, 1.0, 7.0] {
        let (here, there): (Motion, Motion) = (cam.at(0.3), cam.at(0.3 + periods));
        for order in 0..5 {
            assert!((here[order] - there[order]).abs() <= 1e-10 * (1.0 + here[order].abs()));
        }
    }
    let wave = Fourier::new(1.0, [[0.0, 1.0]], 2.0).expect("it is one");
    assert!(wave.joints::<8>().all(|joint| joint.first_jump().is_none()));
    assert!(wave.repeated().repeats());
}

/// A driving angle that reverses moves into the earlier piece.
#[test]
fn the_direction_of_the_drive_selects_the_side() {
    let dwell = Dwell::new(1.0, 1.0).expect("it is one");
    let run = ConstantSpeed::new(1.0, 2.0, 1.0).expect("it is one");
    let law = Sequence::new([&dwell, &run]).expect("it is one");
    let velocity = |drive: [f64; 3]| law.driven(Motion::from(drive)).velocity();
    assert_eq!(velocity([1.0, 3.0, 0.0]), 6.0);
    assert_eq!(velocity([1.0, -3.0, 0.0]), 0.0);
    let acceleration = |drive: [f64; 3]| law.driven(Motion::from(drive)).acceleration();
    assert_eq!(acceleration([1.0, 0.0, 3.0]), 6.0);
    assert_eq!(acceleration([1.0, 0.0, -3.0]), 0.0);
    let around = law.repeated();
    assert_eq!(around.driven(Motion::from([2.0, -3.0])).velocity(), -6.0);
    assert_eq!(around.driven(Motion::from([2.0, 3.0])).velocity(), 0.0);
}

/// Sequences of sequences, at random times, are the law that owns the time.
#[test]
fn nested_sequences_find_the_right_piece() {
    let mut random = Random(4);
    let limits = Limits {
        velocity: 2.0,
        acceleration: 20.0,
        jerk: 500.0,
        snap: Some(3e4),
    };
    let servo = SCurve::new(0.0, 1.0, limits).expect("it is one");
    for shape in shapes() {
        let rise = Rise::new(shape, 1.0, 2.0, 0.5).expect("it is one");
        let dwell = Dwell::new(2.0, 0.25).expect("it is one");
        let inner = Sequence::new([&rise, &dwell]).expect("it is one");
        let law = Sequence::new([&servo, &inner, &rise]).expect("it is one");
        let start = servo.duration();
        assert_eq!(law.duration(), start + 0.75 + 0.5);
        for _ in 0..100 {
            let time = random.part() * law.duration();
            let expected = if time < start {
                servo.at::<5>(time)
            } else if time < start + 0.5 {
                rise.at::<5>(time - start)
            } else if time < start + 0.75 {
                dwell.at::<5>(0.1)
            } else {
                rise.at::<5>(time - (start + 0.75))
            };
            let found = law.at::<5>(time);
            for order in 0..5 {
                let difference = (found[order] - expected[order]).abs();
                // the time since the start of the piece differs by a rounding
                assert!(
                    difference <= 1e-9 * (1.0 + expected[order].abs()),
                    "{shape:?} {order} at {time}"
                );
            }
        }
    }
}
