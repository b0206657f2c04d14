//! Closed forms and published values.

use std::vec::Vec;

use super::{ENGINE, FOUR_BAR};
use crate::any::PositionChoice;
use crate::assembly::Assembly;
use crate::geometry::Plane;
use crate::linkage::AnyLinkage;
use crate::motion::Motion;
use crate::reaction::{Reaction, Reactions};

fn at(found: &Reactions, name: &str) -> Reaction {
    found.of(name).expect("it is determined")
}

fn close(found: f64, expected: f64, size: f64) {
    assert!((found - expected).abs() <= 1e-12 * size, "{found} {expected}");
}

/// The side force of a piston is N = F tan φ, with the rod at the angle φ; its rates are those of the tangent.
#[test]
fn the_side_force_of_a_piston() {
    let linkage = AnyLinkage::of(&ENGINE);
    let loads = linkage
        .loads()
        .force(Plane::new(-900.0, 0.0), "piston")
        .expect("a point");
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    let names: Vec<&str> = reactions.names().collect();
    assert_eq!(names, ["ground_arm", "pin", "piston", "piston_slide"]);
    for start in [0.4, 2.0, 3.5, 5.9] {
        let theta = Motion::from((start, 90.0, -20.0, 500.0, 0.0));
        let found = reactions
            .at(&[theta], PositionChoice::Assembly(0))
            .expect("it is determined");
        let phi = ENGINE.solve(theta, Assembly::Open).expect("it closes").phi;
        let slope = phi.value().tan();
        let (square, speed) = (1.0 + slope * slope, phi.velocity());
        let tangent = [
            slope,
            square * speed,
            square * (phi.acceleration() + 2.0 * slope * speed * speed),
        ];
        let slide = at(&found, "piston_slide");
        for (order, tangent) in tangent.into_iter().enumerate() {
            let side = -900.0 * tangent;
            close(slide.y[order], side, side.abs());
            close(slide.x[order], 0.0, side.abs());
            close(slide.moment[order], 0.0, side.abs());
            close(at(&found, "piston").y[order], side, side.abs());
        }
        // the rod is pushed along itself
        let [push, ..] = at(&found, "piston").magnitude();
        close(push, 900.0 / phi.value().cos(), push);
        close(at(&found, "ground_arm").magnitude()[0], push, push);
        let [direction, turn, _] = at(&found, "pin").direction().expect("there is a force");
        close((direction - phi.value()).sin(), 0.0, 1.0);
        close(turn, phi.velocity(), phi.velocity().abs());
    }
}

/// Two-force members and the balance of moments, by hand.
#[test]
fn a_four_bar_linkage_at_rest() {
    let linkage = AnyLinkage::of(&FOUR_BAR);
    let loads = linkage.loads().torque(12.0, "theta4").expect("an angle");
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    for start in [0.5, 1.9, 4.4] {
        let found = reactions.at(&[Motion::at_constant_speed(start, 0.0)], PositionChoice::Assembly(0));
        let found = found.expect("it is determined");
        let angles = linkage
            .position(&[start], PositionChoice::Assembly(0))
            .expect("it closes");
        let [coupler, rocker] = [angles[0], angles[1]];
        // the coupler is pulled or pushed along itself, with the arm r4 sin(θ4 - θ3) about the pivot of the rocker
        let along = -12.0 / (0.6 * (coupler - rocker).sin());
        let (sine, cosine) = coupler.sin_cos();
        let size = along.abs();
        for name in ["pin", "knee"] {
            close(at(&found, name).magnitude()[0], size, size);
        }
        close(at(&found, "knee").x[0], along * cosine, size);
        close(at(&found, "knee").y[0], along * sine, size);
        close(at(&found, "pivot").x[0], -along * cosine, size);
        // and acts on the crank with the arm r2 sin(θ3 - θ2)
        close(
            found.effort(0).expect("it is determined")[0],
            along * 0.3 * (coupler - start).sin(),
            size,
        );
    }
}
