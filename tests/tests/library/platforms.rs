//! Triads and platforms, whose equations are coupled.

use core::f64::consts::PI;

use kin_core::library::*;
use kin_core::prelude::*;
use kin_tests::compare::{assert_agree, turned_back};
use kin_tests::oracles::{ALLOWED, Gauge};
use kin_tests::random::Random;

use super::cranks;

/// With equal legs an equilateral platform turns about the centre, l² = R² + ρ² - 2 R ρ cos phi; at l² = R² + ρ² both
/// sides agree at every order with the cosine's own expansion.
#[test]
fn triad_turns_about_its_centre() {
    let (outer, inner) = (2.0, 1.0);
    let root = 3.0_f64.sqrt();
    let triad = ClassThreeTriad {
        base_b: Plane::new(outer * root, 0.0),
        base_c: Plane::new(outer * root / 2.0, outer * 1.5),
        platform_b: Plane::new(inner * root, 0.0),
        platform_c: Plane::new(inner * root / 2.0, inner * 1.5),
    };
    let mut random = Random::new(52);
    for _ in 0..60 {
        let angle = random.between(0.4, 2.6);
        let phi = Motion::new(random.motion(angle));
        // the motion of the legs that belongs to it, as a series in time
        let square: Motion =
            Motion::constant(outer * outer + inner * inner) - phi.sin_cos().1.scale(2.0 * outer * inner);
        let leg = root_of(square);
        let corner = Plane::new(-inner * root / 2.0, -inner / 2.0);
        let ends = [Plane::new(0.0, 0.0), triad.platform_b, triad.platform_c];
        let bases = [Plane::new(0.0, 0.0), triad.base_b, triad.base_c];
        let centre = Plane::new(outer * root / 2.0, outer / 2.0);
        let turned = Plane::new(phi.value().cos(), phi.value().sin());
        let angles: Vec<f64> = ends
            .iter()
            .zip(bases)
            .map(|(end, base)| centre + (corner + *end).times(turned) - base)
            .map(|along| along.y.atan2(along.x) + 1e-3)
            .collect();
        let near = Near([angles[0], angles[1], angles[2], phi.value() - 1e-3]);
        let pose = triad.solve(leg, leg, leg, near).expect("it is near");
        let gauge = Gauge::new(&triad, &[leg, leg, leg], &pose.unknown_motions());
        assert_agree("phi", pose.phi, phi, true, &[(&gauge, 3), (&gauge, 3)]);
        for (coordinate, value) in [(pose.centre.x(), centre.x), (pose.centre.y(), centre.y)] {
            for (order, own) in coordinate.derivatives().into_iter().enumerate() {
                let deviation = if order == 0 { own - value } else { own };
                let unit = leg.value() * gauge.unknown(0, order) + inner * gauge.unknown(3, order);
                assert!(
                    deviation.abs() <= ALLOWED[order] * unit,
                    "order {order}: {deviation} beside {unit}"
                );
            }
        }
    }
}

/// The square root of a motion: r r = s, differentiated by Leibniz's rule.
fn root_of(square: Motion) -> Motion {
    let [s, s1, s2, s3, s4] = square.derivatives();
    let r = s.sqrt();
    let r1 = s1 / (2.0 * r);
    let r2 = (s2 - 2.0 * r1 * r1) / (2.0 * r);
    let r3 = (s3 - 6.0 * r1 * r2) / (2.0 * r);
    let r4 = (s4 - 8.0 * r1 * r3 - 6.0 * r2 * r2) / (2.0 * r);
    Motion::from((r, r1, r2, r3, r4))
}

/// Whether one of the positions is that of given motions.
fn holds(positions: &[Near<4>], expected: [Motion; 4]) -> bool {
    positions.iter().any(|Near(position)| {
        position
            .iter()
            .zip(expected)
            .all(|(own, expected)| turned_back(own - expected.value()).abs() < 1e-6)
    })
}

/// Driven at a link for which nothing closes by itself, a linkage has the crank's position among all of its own.
#[test]
fn all_assemblies_hold_the_driven_one() {
    let dimensions = [4.0, 1.0, 3.0, 2.5];
    let with = |extra: [f64; 6]| core::array::from_fn(|index| [&dimensions[..], &extra].concat()[index]);
    let watt1 = WattI::from_parameters(with([1.5, 0.8, 2.0, 1.5, 2.5, 2.0]));
    let watt2 = WattII::from_parameters(with([2.0, 1.0, 7.0, 0.5, 3.0, 2.5]));
    let stephenson1 = StephensonI::from_parameters(with([0.5, 1.0, 1.5, 1.0, 2.5, 2.0]));
    let stephenson2 = StephensonIIByElbow::from_parameters([4.0, 2.0, 1.5, 1.2, 3.0, 0.3, 1.0, 0.5, 1.6, 3.0]);
    let stephenson3 = StephensonIII::from_parameters(with([1.5, 1.0, 3.0, 5.0, 3.0, 2.5]));
    let mut count = 0;
    for crank in cranks(-PI, PI, 53).into_iter().step_by(5) {
        if let Ok(pose) = watt1.solve(crank, WattI::ASSEMBLIES[0]) {
            let driven = WattIByDyad::from_parameters(watt1.parameters());
            let all = driven.assemblies_at(pose.theta5.value()).expect("finite");
            assert!(holds(&all, [crank, pose.theta3, pose.theta4, pose.theta6]), "{all:?}");
            count += usize::from(all.is_complete());
        }
        if let Ok(pose) = watt2.solve(crank, WattII::ASSEMBLIES[0]) {
            let driven = WattIIByCouplers::from_parameters(watt2.parameters());
            let drive = pose.theta5.value() - pose.theta3.value();
            let all = driven.assemblies_at(drive).expect("finite");
            assert!(holds(&all, [crank, pose.theta3, pose.theta4, pose.theta6]), "{all:?}");
            count += usize::from(all.is_complete());
        }
        if let Ok(pose) = stephenson1.solve(crank, StephensonI::ASSEMBLIES[0]) {
            let driven = StephensonIByDyad::from_parameters(stephenson1.parameters());
            let all = driven.assemblies_at(pose.theta5.value()).expect("finite");
            assert!(holds(&all, [crank, pose.theta3, pose.theta4, pose.theta6]), "{all:?}");
            count += usize::from(all.is_complete());
        }
        if let Ok(pose) = stephenson2.solve(crank, StephensonIIByElbow::ASSEMBLIES[0]) {
            let driven = StephensonII::from_parameters(stephenson2.parameters());
            let all = driven.assemblies_at(pose.theta2.value()).expect("finite");
            let [link3, link4, link5] = [crank, pose.alpha, pose.beta].map(|relative| pose.theta2 + relative);
            assert!(holds(&all, [link3, link4, link5, pose.theta6]), "{all:?}");
            // what the crank leaves is a class III triad
            assert!(all.len() <= 6);
            count += usize::from(all.is_complete());
        }
        if let Ok(pose) = stephenson3.solve(crank, StephensonIII::ASSEMBLIES[0]) {
            let driven = StephensonIIIByDyad::from_parameters(stephenson3.parameters());
            let all = driven.assemblies_at(pose.theta6.value()).expect("finite");
            assert!(holds(&all, [crank, pose.theta3, pose.theta4, pose.theta5]), "{all:?}");
            assert!(all.len() <= 6);
            count += usize::from(all.is_complete());
        }
    }
    assert!(count > 40, "{count} complete");
}

/// Equal legs under an equilateral platform: both turns about the centre are among no more than six positions.
#[test]
fn all_positions_of_a_symmetric_platform() {
    let root = 3.0_f64.sqrt();
    let triad = ClassThreeTriad {
        base_b: Plane::new(2.0 * root, 0.0),
        base_c: Plane::new(root, 3.0),
        platform_b: Plane::new(root, 0.0),
        platform_c: Plane::new(root / 2.0, 1.5),
    };
    for phi in [0.7_f64, 1.3, 2.2] {
        let leg = (5.0 - 4.0 * phi.cos()).sqrt();
        let all = triad.assemblies_at(leg, leg, leg).expect("finite");
        assert!(all.is_complete(), "{all:?}");
        println!("{phi}: {} positions, {} singular", all.len(), all.singular());
        for turn in [phi, -phi] {
            assert!(
                all.iter()
                    .any(|Near(position)| turned_back(position[3] - turn).abs() < 1e-9),
                "{turn}: {all:?}"
            );
        }
        assert!(all.len() <= 6);
    }
}
