//! Cranks with a quick return, harmonic motion, gears, and two drives.

use core::f64::consts::PI;

use kin_core::library::*;
use kin_core::prelude::*;
use kin_tests::compare::assert_agree;
use kin_tests::oracles::{ALLOWED, Gauge};

use super::{Path, cranks, point_unit};

/// The strokes take 180° and the angle of the pivots to either side, and the ram reverses between them.
#[test]
fn whitworth_time_ratio() {
    for ground in [0.02, 0.05, 0.08] {
        let press = WhitworthQuickReturn {
            ground,
            crank: 0.1,
            arm: 0.15,
            rod: 0.5,
        };
        let delta = (ground / press.crank).asin();
        let speed = |angle: f64| {
            press
                .solve(Motion::at_constant_speed(angle, 1.0), Assembly::Open)
                .expect("it turns")
                .ram
                .velocity()
        };
        for reversal in [-delta, PI + delta] {
            assert!(speed(reversal).abs() < 1e-15);
        }
        for step in 1..100 {
            let part = f64::from(step) / 100.0;
            assert!(speed(-delta + part * (PI + 2.0 * delta)) < 0.0);
            assert!(speed(PI + delta + part * (PI - 2.0 * delta)) > 0.0);
        }
    }
}

/// The yoke's motion by the rule of sines, for any motion of the crank.
#[test]
fn scotch_yoke_is_harmonic() {
    for gamma in [PI / 2.0, 1.0, 2.2] {
        let yoke = ScotchYoke { crank: 2.0, gamma };
        for crank in cranks(-PI, PI, 45) {
            let own = yoke.solve(crank).expect("it turns");
            let gauge = Gauge::new(&yoke, &[crank], &own.unknown_motions());
            let (sine, cosine) = crank.sin_cos();
            let expected = cosine.scale(2.0) - sine.scale(2.0 / gamma.tan());
            assert_agree("x", own.x, expected, false, &[(&gauge, 0)]);
        }
    }
}

/// Cartwright's line, and rods that do not turn with equal cranks at equal speed.
#[test]
fn geared_five_bars() {
    let mut linkage = GearedFiveBar {
        r1: 2.0,
        r2: 0.5,
        r3: 2.5,
        r4: 2.5,
        r5: 0.5,
        ratio: -1.0,
        phase: PI,
    };
    for crank in cranks(-PI, PI, 46) {
        for assembly in Assembly::BOTH {
            let pose = linkage.solve(crank, assembly).expect("it turns");
            for (order, x) in pose.tool.x().derivatives().into_iter().enumerate() {
                let unit = point_unit(&linkage, [crank], &pose.unknown_motions(), &[(2.5, 0), (0.5, 0)], order);
                let deviation = if order == 0 { x - 1.0 } else { x };
                assert!(deviation.abs() <= unit, "order {order}: {deviation} beside {unit}");
            }
        }
    }
    linkage.ratio = 1.0;
    linkage.phase = 0.0;
    for crank in cranks(-PI, PI, 47) {
        let pose = linkage.solve(crank, Assembly::Open).expect("it turns");
        let gauge = Gauge::new(&linkage, &[crank], &pose.unknown_motions());
        for (order, allowed) in ALLOWED.into_iter().enumerate().skip(1) {
            for (index, rod) in [pose.theta3, pose.theta4].into_iter().enumerate() {
                assert!(rod.derivatives()[order].abs() <= allowed * gauge.unknown(index, order));
            }
        }
    }
}

/// In mirror image the hand of a five-bar linkage moves in mirror image, for any motion of its cranks.
#[test]
fn five_bar_mirrors() {
    let robot = FiveBar {
        ground: 2.0,
        left: 1.5,
        left_rod: 2.0,
        right_rod: 1.8,
        right: 1.3,
    };
    let mirrored = FiveBar {
        ground: 2.0,
        left: 1.3,
        left_rod: 1.8,
        right_rod: 2.0,
        right: 1.5,
    };
    let half = Motion::constant(PI);
    for (alpha, beta) in cranks(1.2, 2.4, 48).into_iter().zip(cranks(0.7, 1.9, 49)) {
        let own = robot.solve(alpha, beta, Assembly::Open).expect("it reaches");
        let other = mirrored
            .solve(half - beta, half - alpha, Assembly::Open)
            .expect("so does its mirror image");
        let links = [(2.0, 0), (1.8, 1)];
        for order in 0..5 {
            let unit = point_unit(&robot, [alpha, beta], &own.unknown_motions(), &links, order);
            let (hand, image): (Path, Path) = (own.hand, other.hand);
            let across = hand.derivatives()[order].x + image.derivatives()[order].x;
            let along = hand.derivatives()[order].y - image.derivatives()[order].y;
            let across = if order == 0 { across - robot.ground } else { across };
            assert!(across.abs() <= 2.0 * unit && along.abs() <= 2.0 * unit, "order {order}");
        }
    }
}
