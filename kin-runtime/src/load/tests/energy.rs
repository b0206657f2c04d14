//! The rates of the energies are the powers, and the efforts of conservative loads are the slopes of the potential
//! energy.

use std::vec::Vec;

use super::{
    ARM, Arm, Case, FOUR_BAR, FourBar, Numbers, OfArm, OfEngine, OfFourBar, OfSpatial, OfTriad, SPATIAL, Spatial,
    solid_of,
};
use crate::assembly::Assembly;
use crate::geometry::{Plane, Space};
use crate::load::{Balance, Loaded, Loads};
use crate::motion::Motion;

/// In multiples of ε times the sum of the sizes of the terms. The largest that occurs is 20, in space.
const BOUND: f64 = 64.0;

/// The largest error of the balance of powers over random motions, as a multiple of ε times the sum of the sizes of its
/// terms.
fn worst<C: Case>() -> f64 {
    let (mechanism, loads, mut numbers) = (C::mechanism(), C::loads(), Numbers::new());
    let mut worst: f64 = 0.0;
    for _ in 0..200 {
        let inputs = C::inputs(&mut numbers);
        let balance = mechanism.balance(&loads, inputs, C::assembly()).expect("it closes");
        let (kinetic, potential) = (balance.kinetic_energy(), balance.potential_energy());
        let (applied, damped) = (balance.applied_power(), balance.damped_power());
        let powers = balance.powers();
        assert_eq!(applied.as_slice().len(), 3);
        for order in 0..3 {
            let terms = [
                kinetic.as_slice()[order + 1],
                potential.as_slice()[order + 1],
                damped.as_slice()[order],
                -applied.as_slice()[order],
            ];
            let driven = powers.as_ref().iter().map(|power| -power.as_slice()[order]);
            let all = driven.chain(terms);
            let size: f64 = all.clone().map(f64::abs).sum();
            let error = all.sum::<f64>().abs();
            worst = worst.max(error / (f64::EPSILON * size));
        }
    }
    worst
}

#[test]
fn drives_loads_and_dampers_pay_for_the_change_of_energy() {
    assert!(worst::<OfFourBar>() < BOUND);
    assert!(worst::<OfEngine>() < BOUND);
    assert!(worst::<OfArm>() < BOUND);
    assert!(worst::<OfSpatial>() < BOUND);
    assert!(worst::<OfTriad>() < BOUND);
}

/// Five points of the potential energy give its slope with an error of the order h⁴, which is below 1e-9 for these
/// steps.
fn slope(energy: impl Fn(f64) -> f64) -> f64 {
    let step = 1e-3;
    let difference = |steps: f64| energy(steps * step) - energy(-steps * step);
    (8.0 * difference(1.0) - difference(2.0)) / (12.0 * step)
}

#[test]
fn a_conservative_load_at_rest_gives_the_slope_of_its_potential() {
    let loads = Loads::<FourBar>::new()
        .gravity(Plane::new(0.0, -9.81))
        .mass(2.5, |pose| pose.coupler)
        .spring(80.0, 0.35, |pose| pose.pin, |_| Plane::new(0.4, 0.9))
        .torsion_spring(5.0, 0.3, |pose| pose.theta3);
    let at = |theta2: f64| {
        FOUR_BAR
            .balance(&loads, [Motion::constant(theta2)], Assembly::Open)
            .expect("it closes")
    };
    for theta2 in [-1.0, 0.3, 1.2] {
        let expected = slope(|step| at(theta2 + step).potential_energy().value());
        let [torque] = at(theta2).efforts();
        assert!(
            (torque.value() - expected).abs() < 1e-8 * expected.abs(),
            "{torque:?} {expected}"
        );
        assert_eq!([torque.rate(), torque.second_rate()], [0.0, 0.0]);
    }

    let loads = Loads::<Arm>::new()
        .gravity(Plane::new(0.0, -9.81))
        .mass(3.0, |pose| pose.hand)
        .spring(90.0, 0.8, |pose| pose.elbow, |pose| pose.middle);
    let at = |alpha: f64, beta: f64| {
        let inputs = [Motion::constant(alpha), Motion::constant(beta)];
        ARM.balance(&loads, inputs, Assembly::Open).expect("it closes")
    };
    let [left, right] = at(2.0, 1.1).efforts();
    let by_alpha = slope(|step| at(2.0 + step, 1.1).potential_energy().value());
    let by_beta = slope(|step| at(2.0, 1.1 + step).potential_energy().value());
    assert!((left.value() - by_alpha).abs() < 1e-8 * by_alpha.abs());
    assert!((right.value() - by_beta).abs() < 1e-8 * by_beta.abs());
}

/// The equivalent inertia of two inputs is that of the kinetic energy, and its slopes are its differences.
#[test]
fn the_equivalent_inertia_is_that_of_the_kinetic_energy() {
    let loads = OfArm::loads();
    let at = |alpha: f64, beta: f64| {
        ARM.equivalent_inertia(&loads, [alpha, beta], Assembly::Open)
            .expect("it closes")
    };
    let felt = at(2.0, 1.1);
    let speeds = [1.3, -0.7];
    let inputs = [
        Motion::at_constant_speed(2.0, speeds[0]),
        Motion::at_constant_speed(1.1, speeds[1]),
    ];
    let balance = ARM.balance(&loads, inputs, Assembly::Open).expect("it closes");
    let mut energy = 0.0;
    for (row, one) in felt.matrix.iter().zip(speeds) {
        for (entry, two) in row.iter().zip(speeds) {
            energy += 0.5 * entry * one * two;
        }
    }
    assert!((energy - balance.kinetic_energy().value()).abs() < 1e-14 * energy);
    for row in 0..2 {
        for column in 0..2 {
            assert_eq!(felt.matrix[row][column], felt.matrix[column][row]);
            let expected = [
                slope(|step| at(2.0 + step, 1.1).matrix[row][column]),
                slope(|step| at(2.0, 1.1 + step).matrix[row][column]),
            ];
            for (input, expected) in expected.into_iter().enumerate() {
                let found = felt.slopes[input][row][column];
                assert!(
                    (found - expected).abs() < 1e-8 * felt.matrix[row][row],
                    "{found} {expected}"
                );
            }
        }
    }
}

/// What the accelerations from given efforts need as efforts are these efforts.
#[test]
fn accelerations_and_efforts_are_inverse() {
    let loads = OfArm::loads();
    let [first, second] = ARM
        .accelerations(&loads, [2.0, 1.1], [1.3, -0.7], [4.0, -9.0], Assembly::Open)
        .expect("it closes");
    let inputs = [
        Motion::from([2.0, 1.3, first, 0.0, 0.0]),
        Motion::from([1.1, -0.7, second, 0.0, 0.0]),
    ];
    let [left, right] = ARM
        .balance(&loads, inputs, Assembly::Open)
        .expect("it closes")
        .efforts();
    assert!((left.value() - 4.0).abs() < 1e-11 && (right.value() + 9.0).abs() < 1e-11);
}

/// A rotor whose centre of mass circles: the shaking force is centrifugal, and its moment about the hub is -I α.
#[test]
fn a_rotor_shakes_by_its_centrifugal_force() {
    let loads = Loads::<FourBar>::new()
        .inertia(0.05, |pose| pose.theta4)
        .mass(2.0, |pose| pose.rocker);
    let crank = Motion::from([0.5, 6.0, -20.0, 90.0, 300.0]);
    let pose = FOUR_BAR.solve(crank, Assembly::Open).expect("it closes");
    let balance = FOUR_BAR.balance(&loads, [crank], Assembly::Open).expect("it closes");
    let (speed, acceleration) = (pose.theta4.velocity(), pose.theta4.acceleration());
    let arm = pose.rocker.value() - Plane::new(FOUR_BAR.r1, 0.0);
    // -m a, with a = i α r - ω² r
    let expected = Plane::new(2.0 * speed * speed, -2.0 * acceleration).times(arm);
    let force = balance.shaking_force().value();
    let size = expected.norm();
    assert!((force.x - expected.x).abs() < 1e-14 * size && (force.y - expected.y).abs() < 1e-14 * size);
    assert_eq!(force.z, 0.0);
    // moved from the origin to the pivot of the rocker
    let moment = balance.shaking_moment().value().z - FOUR_BAR.r1 * force.y;
    let inertia = 0.05 + 2.0 * arm.norm_squared();
    assert!((moment + inertia * acceleration).abs() < 1e-13 * (inertia * acceleration).abs() + 1e-14 * size);
}

/// A body that consists of three particles is as heavy, and shakes as much, as these.
#[test]
fn a_body_in_space_is_the_sum_of_its_particles() {
    let masses = [1.3, 0.8, 2.1];
    let along = SPATIAL.arm.norm();
    let foot = SPATIAL.arm.dot(SPATIAL.ear) / along;
    let height = SPATIAL.arm.cross(SPATIAL.ear).norm() / along;
    let places = [[0.0; 3], [along, 0.0, 0.0], [foot, height, 0.0]];
    let solid = solid_of(&[0, 1, 2].map(|particle| (masses[particle], places[particle])));
    let empty = Loads::<Spatial>::new().gravity(Space::new(0.5, 2.0, -9.81));
    let body = empty.body(solid, |pose| [pose.root, pose.ball, pose.lug]);
    let particles = empty
        .mass(masses[0], |pose| pose.root)
        .mass(masses[1], |pose| pose.ball)
        .mass(masses[2], |pose| pose.lug);
    let crank = [Motion::from([0.5, 2.0, -3.0, 9.0, 30.0])];
    let one = SPATIAL.balance(&body, crank, Assembly::Open).expect("it closes");
    let other = SPATIAL.balance(&particles, crank, Assembly::Open).expect("it closes");
    let numbers = |balance: &Balance<Spatial>| {
        let [effort] = balance.efforts();
        let [[inertia]] = balance.inertias();
        let mut numbers: Vec<f64> = effort.as_slice().to_vec();
        numbers.extend(inertia.as_slice());
        numbers.extend(balance.kinetic_energy().as_slice());
        numbers.extend(balance.potential_energy().as_slice());
        for vector in [balance.shaking_force(), balance.shaking_moment()] {
            numbers.extend(vector.as_slice().iter().flat_map(|entry| [entry.x, entry.y, entry.z]));
        }
        numbers
    };
    let (one, other) = (numbers(&one), numbers(&other));
    // the terms of every sum are of the size of the largest number at most
    let size = other.iter().map(|number| number.abs()).fold(0.0, f64::max);
    for (place, (one, other)) in one.iter().zip(&other).enumerate() {
        assert!(
            (one - other).abs() < 16.0 * f64::EPSILON * size,
            "{place}: {one} {other}"
        );
    }
}

crate::mechanism! {
    /// A pendulum with a follower, to the sixth derivative.
    struct Long { arm: Length }
    input turn: Angle;
    unknown follower: Angle;
    follower == turn;
    output bob: Point = arm * cis(turn);
    order = 6;
}

crate::mechanism! {
    /// The same through the velocity only.
    struct Short { arm: Length }
    input turn: Angle;
    unknown follower: Angle;
    follower == turn;
    output bob: Point = arm * cis(turn);
    order = 1;
}

#[test]
fn a_higher_order_gives_more_rates_and_a_lower_one_fewer() {
    let long: Long = Long { arm: 0.5 };
    let turn = Motion::from([0.7, 3.0, -4.0, 20.0, 7.0, -9.0, 100.0]);
    let loads = Loads::<Long>::new()
        .gravity(Plane::new(0.0, -9.81))
        .mass(2.0, |pose| pose.bob);
    let [torque] = long.balance(&loads, [turn]).expect("it closes").efforts();
    // m l² θ'' + m g l cos θ, and its derivatives
    let (_, cosine) = turn.sin_cos();
    let weight = cosine * (2.0 * 9.81 * 0.5);
    let expected = |order: usize| 2.0 * 0.25 * turn[order + 2] + weight[order];
    assert_eq!(torque.as_slice().len(), 5);
    for (order, found) in torque.as_slice().iter().enumerate() {
        // in the sixth derivative of the point, terms as large as 20 θ'³ θ''' cancel
        let bound = 16.0 * f64::EPSILON * 20.0 * 27.0 * 20.0;
        assert!(
            (found - expected(order)).abs() < bound,
            "{order}: {found} {}",
            expected(order)
        );
    }

    let short: Short = Short { arm: 0.5 };
    let loads = Loads::<Short>::new()
        .gravity(Plane::new(0.0, -9.81))
        .mass(2.0, |pose| pose.bob);
    let balance = short.balance(&loads, [Motion::from([0.7, 3.0])]).expect("it closes");
    assert!(balance.efforts()[0].as_slice().is_empty());
    assert!((balance.kinetic_energy().as_slice()[0] - 0.5 * 2.0 * 2.25).abs() < 1e-15);
    let felt = short.equivalent_inertia(&loads, [0.7]).expect("it closes");
    assert!((felt.matrix[0][0] - 0.5).abs() < 1e-15);
}
