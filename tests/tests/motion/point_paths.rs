//! Paths and instant centres of solved mechanisms: properties of the curves, which do not depend on how the crank is
//! driven.

use std::f64::consts::TAU;

use kin_core::LinkMotion;
use kin_core::prelude::*;

mechanism! {
    struct FourBar { ground: Length, crank: Length, coupler: Length, rocker: Length, tracer: Vector }
    input theta: Angle;
    unknown phi: Angle, psi: Angle;
    crank * cis(theta) + coupler * cis(phi) == ground + rocker * cis(psi);
    output pin: Point = crank * cis(theta);
    output joint: Point = ground + rocker * cis(psi);
    output tip: Point = crank * cis(theta) + tracer * cis(phi);
}

const LINKAGE: FourBar = FourBar {
    ground: 90.0,
    crank: 30.0,
    coupler: 80.0,
    rocker: 60.0,
    tracer: Plane::new(50.0, 30.0),
};
const EPSILON: f64 = f64::EPSILON;

fn size(vector: Plane) -> f64 {
    vector.norm_squared().sqrt()
}

/// The effect of roundings of a point's derivatives on the curvature of its path and its rate.
fn sensitivities(point: Motion<Plane>) -> [f64; 2] {
    let [speed, acceleration, jerk] = [point.velocity(), point.acceleration(), point.jerk()].map(size);
    [
        acceleration / speed.powi(2),
        jerk / speed.powi(3) + 3.0 * (acceleration / speed.powi(2)).powi(2),
    ]
}

/// Poses over a turn, each by several laws of the crank's motion: at constant speed, backwards, and anyhow. With it,
/// how many times the rates are uncertain by rounding: coupler and rocker determine them the worse, the nearer they
/// come to one line.
fn poses() -> impl Iterator<Item = ([FourBarSnap; 3], f64)> {
    (0..24).map(|step| {
        let theta = TAU * f64::from(step) / 24.0;
        let laws = [
            [theta, 1.0, 0.0, 0.0, 0.0],
            [theta, -3.0, 0.0, 0.0, 0.0],
            [theta, 2.0, 5.0, -7.0, 3.0],
        ];
        let poses = laws.map(|law| LINKAGE.solve(Motion::from(law), Assembly::Open).unwrap());
        let closeness = (poses[0].phi.position() - poses[0].psi.position()).sin().abs();
        (poses, 1.0 / closeness)
    })
}

#[test]
fn curvature_belongs_to_the_curve() {
    for (poses, condition) in poses() {
        let [reference, back, any] = poses.map(|pose| pose.tip);
        let (curvature, rate) = (reference.curvature().unwrap(), reference.curvature_rate().unwrap());
        // run through backwards, the path bends to the other side, and so does its rate, twice
        for (tip, sense) in [(back, -1.0), (any, 1.0)] {
            let allowed = [0, 1].map(|index| {
                // each order multiplies the uncertainty of the one below by that of the Jacobian
                let sensitivity = sensitivities(reference)[index] + sensitivities(tip)[index];
                16.0 * EPSILON * condition.powi(if index == 0 { 2 } else { 3 }) * sensitivity
            });
            let error = (tip.curvature().unwrap() - sense * curvature).abs();
            assert!(error <= allowed[0], "{error} {}", allowed[0]);
            let error = (tip.curvature_rate().unwrap() - rate).abs();
            assert!(error <= allowed[1], "{error} {}", allowed[1]);
        }
    }
}

#[test]
fn points_of_crank_and_rocker_go_round_their_pivots() {
    for (poses, condition) in poses() {
        let pose = poses[2];
        let error = (pose.pin.radius_of_curvature().unwrap() - LINKAGE.crank).abs();
        assert!(error <= 16.0 * EPSILON * sensitivities(pose.pin)[0] * LINKAGE.crank.powi(2));
        // the rocker may be about to reverse
        let pivot = Plane::new(LINKAGE.ground, 0.0);
        let error = size(pose.joint.centre_of_curvature().unwrap() - pivot);
        let allowed = 16.0 * EPSILON * condition.powi(2) * sensitivities(pose.joint)[0] * LINKAGE.rocker.powi(2);
        assert!(error <= allowed + 16.0 * EPSILON * LINKAGE.ground, "{error} {allowed}");
    }
}

#[test]
fn the_couplers_instant_centre_is_where_crank_and_rocker_cross() {
    for (poses, condition) in poses() {
        let pose = poses[2];
        let coupler = LinkMotion::new(pose.pin, pose.phi);
        let centre = coupler.instant_centre().unwrap();
        let pivot = Plane::new(LINKAGE.ground, 0.0);
        let (crank, rocker) = (pose.pin.position(), pose.joint.position() - pivot);
        // the two lines, by Cramer's rule
        let expected = crank.scale(pivot.cross(rocker) / crank.cross(rocker));
        let nearly_parallel = size(crank) * size(rocker) / crank.cross(rocker).abs();
        let error = size(centre - expected);
        let allowed = 16.0 * EPSILON * condition * nearly_parallel * (size(expected) + LINKAGE.ground);
        assert!(error <= allowed, "{error} {allowed}");
        // from another of its points, the same
        let other = LinkMotion::new(pose.tip, pose.phi).instant_centre().unwrap();
        assert!(size(other - centre) <= allowed);
    }
}

#[test]
fn outputs_move_as_the_link_carries_them() {
    for (poses, condition) in poses() {
        let pose = poses[2];
        let carried = LinkMotion::new(pose.pin, pose.phi).carried(pose.tip.position());
        for order in 0..=4 {
            let (found, expected) = (carried.as_slice()[order], pose.tip.as_slice()[order]);
            let rates: f64 = 1.0 + pose.phi.as_slice().iter().map(|rate| rate.abs()).sum::<f64>();
            let allowed = 16.0 * EPSILON * condition * rates.powi(4) * size(LINKAGE.tracer);
            assert!(size(found - expected) <= allowed, "order {order}");
        }
    }
}

#[test]
fn the_inflection_circle_bends_paths_as_euler_and_savary_say() {
    for (poses, condition) in poses() {
        let pose = poses[0];
        let coupler = LinkMotion::new(pose.pin, pose.phi);
        let (Some(centre), Some(pole)) = (coupler.instant_centre(), coupler.inflection_pole()) else {
            panic!("the coupler turns at every angle of the crank that is looked at");
        };
        let arm = pose.tip.position() - centre;
        let distance = size(arm);
        let inflection = (pole - centre).dot(arm) / distance;
        let curvature = (distance - inflection).abs() / distance.powi(2);
        let found = pose.tip.curvature().unwrap().abs();
        // the slower the coupler turns, the farther off are both poles
        let turning = pose.phi.velocity().abs().min(1.0);
        let allowed = 16.0 * EPSILON * condition.powi(2) * sensitivities(pose.tip)[0] / turning.powi(2);
        assert!((found - curvature).abs() <= allowed, "{found} {curvature} {allowed}");
    }
}
