//! Formulas of textbooks for slider-cranks and four-bar linkages.
//!
//! Those for engines leave out powers of the ratio n = r/l of crank and rod. The bounds of their errors follow from the
//! binomial series of √(1 - n² sin²θ), whose terms all have one sign. The error of the acceleration is largest at 90
//! degrees, where it has the value of the bound.

use std::vec::Vec;

use super::{ENGINE, Engine, FOUR_BAR, FourBar};
use crate::assembly::Assembly;
use crate::load::Loaded;
use crate::load::Loads;
use crate::motion::Motion;

const MASS: f64 = 0.8;
const GAS: f64 = 4000.0;

fn turn() -> impl Iterator<Item = f64> {
    (0..360).map(|degrees| f64::from(degrees).to_radians())
}

/// Engines with rods from twice to ten times as long as their cranks.
fn engines() -> Vec<Engine> {
    let crank = ENGINE.crank;
    let engine = |ratio: f64| Engine {
        crank,
        rod: ratio * crank,
    };
    [2.0, 3.0, 4.0, 6.0, 10.0].map(engine).to_vec()
}

/// What rounding may add to a sum of terms of this size.
fn rounding(size: f64) -> f64 {
    16.0 * f64::EPSILON * size
}

/// The inertia force of the piston is m r ω² (cos θ + n cos 2θ), and the error is at most m l ω² n² (1/√(1 - n²) - 1),
/// which it reaches. (R. L. Norton, *Design of Machinery*, McGraw-Hill, chapter 13; J. J. Uicker, G. R. Pennock & J. E.
/// Shigley, *Theory of Machines and Mechanisms*, Oxford University Press, on the dynamics of reciprocating engines.)
#[test]
fn the_inertia_force_of_a_piston() {
    let loads = Loads::<Engine>::new().mass(MASS, |pose| pose.piston);
    let speed = 300.0;
    for engine in engines() {
        let (r, l) = (engine.crank, engine.rod);
        let n = r / l;
        let bound = MASS * l * speed * speed * n * n * (1.0 / f64::sqrt(1.0 - n * n) - 1.0);
        let size = MASS * r * speed * speed;
        let mut worst: f64 = 0.0;
        for angle in turn() {
            let crank = [Motion::at_constant_speed(angle, speed)];
            let balance = engine.balance(&loads, crank, Assembly::Open).expect("it closes");
            let force = balance.shaking_force().value();
            let expected = size * (f64::cos(angle) + n * f64::cos(2.0 * angle));
            worst = worst.max((force.x - expected).abs());
            assert_eq!([force.y, force.z], [0.0; 2]);
        }
        assert!(worst <= bound + rounding(size), "{n}: {worst} {bound}");
        assert!(worst >= bound - rounding(size), "{n}: {worst} {bound}");
    }
}

/// The gas force F gives the crank the torque F r sin θ (1 + n cos θ), with an error of at most F r n (1/√(1 - n²) - 1)
/// / 2. (Norton, chapter 13.)
#[test]
fn the_gas_torque() {
    // towards the crank
    let loads = Loads::<Engine>::new().torque(-GAS, |pose| pose.s);
    for engine in engines() {
        let n = engine.crank / engine.rod;
        let size = GAS * engine.crank;
        let bound = 0.5 * size * n * (1.0 / f64::sqrt(1.0 - n * n) - 1.0);
        for angle in turn() {
            let balance = engine
                .balance(&loads, [Motion::constant(angle)], Assembly::Open)
                .expect("it closes");
            let [drive] = balance.efforts();
            // the drive holds what the gas gives
            let gas = -drive.value();
            let expected = size * f64::sin(angle) * (1.0 + n * f64::cos(angle));
            assert!(
                (gas - expected).abs() <= bound + rounding(size),
                "{n} {angle}: {gas} {expected}"
            );
        }
    }
}

/// The inertia torque of the piston on the crank is m r² ω² (n/2 sin θ - sin 2θ - 3n/2 sin 3θ) / 2. It leaves out the
/// product of both second harmonics, at most n²/4, besides the errors of velocity and acceleration. (Norton, chapter
/// 13; Uicker, Pennock & Shigley.)
#[test]
fn the_inertia_torque_of_a_piston() {
    let loads = Loads::<Engine>::new().mass(MASS, |pose| pose.piston);
    let speed = 300.0;
    for engine in engines() {
        let (r, l) = (engine.crank, engine.rod);
        let n = r / l;
        let size = MASS * r * r * speed * speed;
        // in units of r and ω
        let excess = 1.0 / f64::sqrt(1.0 - n * n) - 1.0;
        let (velocity, acceleration) = (0.5 * n * excess, n * excess);
        let bound = size * (acceleration * (1.0 + 0.5 * n + velocity) + (1.0 + n) * velocity + 0.25 * n * n);
        let mut worst: f64 = 0.0;
        for angle in turn() {
            let crank = [Motion::at_constant_speed(angle, speed)];
            let balance = engine.balance(&loads, crank, Assembly::Open).expect("it closes");
            let [drive] = balance.efforts();
            let harmonic = |order: f64| f64::sin(order * angle);
            let expected = 0.5 * size * (0.5 * n * harmonic(1.0) - harmonic(2.0) - 1.5 * n * harmonic(3.0));
            worst = worst.max((-drive.value() - expected).abs());
        }
        assert!(worst <= bound + rounding(size), "{n}: {worst} {bound}");
        // the bound is no empty one
        assert!(worst > 0.1 * bound, "{n}: {worst} {bound}");
    }
}

/// At rest the torques of crank and rocker are as their velocities the other way round: T2 / T4 = -ω4/ω2, with
/// ω4/ω2 = r2 sin(θ2 - θ3) / (r4 sin(θ4 - θ3)). (Norton, chapter 6, on mechanical advantage.)
#[test]
fn the_mechanical_advantage_of_a_four_bar() {
    let torque = -35.0;
    let loads = Loads::<FourBar>::new().torque(torque, |pose| pose.theta4);
    let FourBar { r2, r4, .. } = FOUR_BAR;
    for degrees in -100..=100 {
        let crank = Motion::constant(f64::from(degrees).to_radians());
        let pose = FOUR_BAR.solve(crank, Assembly::Open).expect("it closes");
        let [theta2, theta3, theta4] = [crank.value(), pose.theta3.value(), pose.theta4.angle()];
        let [drive] = FOUR_BAR
            .balance(&loads, [crank], Assembly::Open)
            .expect("it closes")
            .efforts();
        let ratio = r2 * f64::sin(theta2 - theta3) / (r4 * f64::sin(theta4 - theta3));
        // the angle of the dyad has a few roundings, divided by its sine
        let size = torque.abs() * (ratio.abs() + r2 / r4) / f64::sin(theta4 - theta3).abs();
        assert!(
            (drive.value() + torque * ratio).abs() <= rounding(size),
            "{degrees}: {drive:?}"
        );
    }
}
