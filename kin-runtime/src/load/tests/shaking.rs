//! Shaking force and moment are the rates of the momentum and of the angular momentum, with their own rates.

use super::{Case, FOUR_BAR, FourBar, Numbers, OfFourBar, OfSpatial, PARTICLES, SPATIAL, Spatial};
use crate::assembly::Assembly;
use crate::geometry::Space;
use crate::load::{Balance, Loaded, Loads};
use crate::mechanism::Mechanism;
use crate::motion::Motion;

/// A mass with its place in space and four derivatives.
type Particle = (f64, [Motion<f64, 5>; 3]);

/// The sums of -m a and of -r × m a, with their first and second rates by the product rule.
fn expected(particles: &[Particle]) -> [[Space<f64>; 3]; 2] {
    let mut force = [Space::zero(); 3];
    let mut moment = [Space::zero(); 3];
    let binomials = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 2.0, 1.0]];
    for (mass, place) in particles {
        let entry = |order: usize| Space::new(place[0][order], place[1][order], place[2][order]);
        for order in 0..3 {
            force[order] = force[order] - entry(order + 2).scale(*mass);
            for (below, binomial) in binomials[order].iter().enumerate().take(order + 1) {
                let term = entry(below).cross(entry(order - below + 2));
                moment[order] = moment[order] - term.scale(mass * binomial);
            }
        }
    }
    [force, moment]
}

fn check<M: Mechanism<Scalar = f64>>(balance: &Balance<M>, particles: &[Particle]) {
    let found = [balance.shaking_force(), balance.shaking_moment()];
    for (found, expected) in found.iter().zip(expected(particles)) {
        assert_eq!(found.as_slice().len(), 3);
        for (order, (found, expected)) in found.as_slice().iter().zip(expected).enumerate() {
            // each derivative of a place is as large as all terms of the sum together, at most
            let size: f64 = particles
                .iter()
                .map(|(mass, place)| {
                    let norm = |order: usize| place.iter().map(|part| part[order].abs()).sum::<f64>();
                    let terms = (0..=order).map(|below| norm(below) * norm(order - below + 2));
                    mass * (norm(order + 2) + 2.0 * terms.sum::<f64>())
                })
                .sum();
            let difference = (*found - expected).norm();
            assert!(
                difference <= 32.0 * f64::EPSILON * size,
                "{order}: {found:?} {expected:?}"
            );
        }
    }
}

#[test]
fn in_the_plane() {
    let loads = Loads::<FourBar>::new()
        .mass(2.5, |pose| pose.coupler)
        .mass(1.5, |pose| pose.rocker);
    let mut numbers = Numbers::new();
    for _ in 0..50 {
        let inputs = OfFourBar::inputs(&mut numbers);
        let pose = FOUR_BAR.solve(inputs[0], Assembly::Open).expect("it closes");
        let flat = |point: Motion<crate::geometry::Plane, 5>| [point.x(), point.y(), Motion::constant(0.0)];
        let balance = FOUR_BAR.balance(&loads, inputs, Assembly::Open).expect("it closes");
        check(&balance, &[(2.5, flat(pose.coupler)), (1.5, flat(pose.rocker))]);
    }
}

/// The body of four particles shakes as these do: their places follow from its three points.
#[test]
fn in_space() {
    let loads = Loads::<Spatial>::new()
        .mass(0.3, |pose| pose.pin)
        .body(super::solid(), |pose| [pose.root, pose.ball, pose.lug]);
    let mut numbers = Numbers::new();
    for _ in 0..50 {
        let inputs = OfSpatial::inputs(&mut numbers);
        let pose = SPATIAL.solve(inputs[0], Assembly::Open).expect("it closes");
        let parts =
            |point: Motion<Space<f64>, 5>| [0, 1, 2].map(|axis| point.map(|entry| [entry.x, entry.y, entry.z][axis]));
        let [root, ball, lug] = [pose.root, pose.ball, pose.lug].map(parts);
        // a fixed combination of the points and of their vector product
        let (along, across) = (SPATIAL.arm, SPATIAL.ear);
        let first = along.scale(1.0 / along.norm());
        let normal = along.cross(across);
        let third = normal.scale(1.0 / normal.norm());
        let second = third.cross(first);
        let [one, other] = [ball, lug].map(|point| [0, 1, 2].map(|axis| point[axis] - root[axis]));
        let product = [0, 1, 2].map(|axis| {
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            one[next] * other[last] - one[last] * other[next]
        });
        let mut particles: std::vec::Vec<Particle> = std::vec![(0.3, parts(pose.pin))];
        for (mass, [x, y, z]) in PARTICLES {
            let arm = first.scale(x) + second.scale(y) + third.scale(z);
            // coordinates of the arm along the two sides and the normal
            let height = arm.dot(normal) / normal.dot(normal);
            let flat = arm - normal.scale(height);
            let by_along = flat.cross(across).dot(normal) / normal.dot(normal);
            let by_across = along.cross(flat).dot(normal) / normal.dot(normal);
            let place = [0, 1, 2]
                .map(|axis| root[axis] + one[axis] * by_along + other[axis] * by_across + product[axis] * height);
            particles.push((mass, place));
        }
        let balance = SPATIAL.balance(&loads, inputs, Assembly::Open).expect("it closes");
        check(&balance, &particles);
    }
}
