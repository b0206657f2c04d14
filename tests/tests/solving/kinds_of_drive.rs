//! The things that inputs can drive: an angle between links, a slider, a point's coordinate, two cranks; and gears,
//! belts and wheels that roll.
#![allow(missing_docs, unreachable_pub, reason = "declarations as a person writes them")]

use core::f64::consts::TAU;

use kin_core::prelude::*;
use kin_core::verify::{self, Gauge};

mechanism! {
    /// A four-bar whose coupler point is pulled along a line.
    pub struct PointDriven { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length, pub offset: Vector }
    input height: Length;
    unknown theta2: Angle, theta3: Angle, theta4: Angle;
    let joint = r2 * cis(theta2);
    joint + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    (joint + offset * cis(theta3)).y == height;
}

mechanism! {
    /// A hydraulic cylinder between ground and coupler.
    pub struct CylinderDriven { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length, pub pivot: Point }
    input stroke: Length;
    unknown theta2: Angle, theta3: Angle, theta4: Angle, psi: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    r2 * cis(theta2) + r3 / 2 * cis(theta3) == pivot + stroke * cis(psi);
}

mechanism! {
    /// A slider-crank driven by a motor between crank and rod.
    pub struct MotorAtPin { pub crank: Length, pub rod: Length }
    input elbow: Angle;
    unknown theta: Angle, phi: Angle, s: Length;
    crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
    phi - theta == elbow;
}

mechanism! {
    /// A wheel rolls on a rail, and a rod from a pin on it moves a slide above.
    pub struct RollingWheel { pub radius: Length, pub pin: Length, pub rod: Length, pub height: Length }
    input x: Length;
    unknown phi: Angle, psi: Angle, s: Length;
    x == radius * phi;
    vec2(x, radius) + pin * cis(-phi) + rod * cis(psi) == vec2(s, height);
}

mechanism! {
    /// A geared five-bar, driven at a coupler link: the gear relation stands in the loop.
    pub struct GearedDyad { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length, pub r5: Length,
        pub ratio: Scalar, pub phase: Angle }
    input theta3: Angle;
    unknown theta2: Angle, theta4: Angle, theta5: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r5 * cis(theta5) + r4 * cis(theta4);
    theta5 == ratio * theta2 + phase;
}

mechanism! {
    /// Five links, two cranks, each with its own motion.
    pub struct TwoCranks { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length, pub r5: Length }
    input left: Angle, right: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(left) + r3 * cis(theta3) == r1 + r5 * cis(right) + r4 * cis(theta4);
    with test;
}

/// Whatever is driven, both oracles agree over random dimensions.
#[test]
fn whatever_is_driven() {
    verify::mechanism::<PointDriven>().assert();
    verify::mechanism::<CylinderDriven>().assert();
    verify::mechanism::<MotorAtPin>().assert();
    verify::mechanism::<RollingWheel>().assert();
    verify::mechanism::<GearedDyad>().assert();
}

/// Driven at its pin, the slider-crank has a closed form: a relation of angles is put into the loop.
#[test]
fn relations_are_put_into_loops() {
    println!("{:?}", MotorAtPin::<f64>::DESCRIPTION.blocks);
    println!("{:?}", PointDriven::<f64>::DESCRIPTION.blocks);
    println!("{:?}", CylinderDriven::<f64>::DESCRIPTION.blocks);
    println!("{:?}", GearedDyad::<f64>::DESCRIPTION.blocks);
    println!("{:?}", RollingWheel::<f64>::DESCRIPTION.blocks);
}

/// Solved backwards: what the four-bar does when its crank turns is what turns its crank.
#[test]
fn driving_and_driven_change_places() {
    mechanism! {
        pub struct Forward { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length, pub offset: Vector,
            pub pivot: Point }
        input theta2: Angle;
        unknown theta3: Angle, theta4: Angle, stroke: Length where stroke > 0, psi: Angle;
        let joint = r2 * cis(theta2);
        joint + r3 * cis(theta3) == r1 + r4 * cis(theta4);
        joint + r3 / 2 * cis(theta3) == pivot + stroke * cis(psi);
        output height: Length = (joint + offset * cis(theta3)).y;
    }
    let offset = Plane::new(0.6, 0.4);
    let pivot = Plane::new(0.5, -2.0);
    let forward = Forward {
        r1: 4.0,
        r2: 1.0,
        r3: 3.0,
        r4: 2.5,
        offset,
        pivot,
    };
    let by_point = PointDriven {
        r1: 4.0,
        r2: 1.0,
        r3: 3.0,
        r4: 2.5,
        offset,
    };
    let by_cylinder = CylinderDriven {
        r1: 4.0,
        r2: 1.0,
        r3: 3.0,
        r4: 2.5,
        pivot,
    };
    let mut compared = 0;
    for step in 0..48 {
        let theta2 = Motion::from([f64::from(step) * TAU / 48.0, 1.3, -0.4, 0.7, -1.1]);
        for assembly in Assembly::BOTH {
            let Ok(own) = forward.solve(theta2, assembly) else {
                continue;
            };
            let near = [
                theta2.value() + 1e-3,
                own.theta3.value() - 1e-3,
                own.theta4.value() + 1e-3,
            ];
            let expected = [theta2, own.theta3, own.theta4];
            let first = Gauge::new(&forward, &[theta2], &own.unknown_motions());
            if let Ok(back) = by_point.solve_near(own.height, near) {
                let gauge = Gauge::new(&by_point, &[own.height], &back.unknown_motions());
                compared += same(&[back.theta2, back.theta3, back.theta4], &expected, &gauge, &first);
            }
            if let Ok(back) = by_cylinder.solve_near(own.stroke, [near[0], near[1], near[2], own.psi.value()]) {
                let gauge = Gauge::new(&by_cylinder, &[own.stroke], &back.unknown_motions());
                compared += same(&[back.theta2, back.theta3, back.theta4], &expected, &gauge, &first);
            }
        }
    }
    assert!(compared > 100, "{compared}");
}

/// Compares motions that were found in two ways; none if a dead point has another position as near as the one wanted.
fn same(back: &[Motion], expected: &[Motion], gauge: &Gauge, first: &Gauge) -> usize {
    if (back[0].value() - expected[0].value()).abs() > 1e-3 {
        return 0;
    }
    for (index, (back, expected)) in back.iter().zip(expected).enumerate() {
        for (order, (a, b)) in back.derivatives().into_iter().zip(expected.derivatives()).enumerate() {
            let unit = gauge.unknown(index, order) * (1.0 + first.condition * first.condition);
            assert!(
                (a - b).abs() <= verify::allowed(order) * unit,
                "order {order}: {a} {b}, {unit}"
            );
        }
    }
    1
}
