//! Forces in the joints of space: bodies cut free by hand, virtual work, equilibrium, differences and messages.

use std::string::ToString;
use std::vec;
use std::vec::Vec;

use super::mistakes::{message, still};
use crate::any::{AssemblyChoice, Of, PositionChoice, SkeletonOver};
use crate::assembly::Assembly;
use crate::geometry::{Plane, Space};
use crate::law::{Law as _, Piecewise, Rise, Shape};
use crate::library;
use crate::linkage::AnyLinkage;
use crate::load::{NamedLoads, Solid};
use crate::mechanism::Mechanism;
use crate::motion::Motion;
use crate::reaction::{Friction, NamedReactions, ReactionError, ReactionPart, Reactions};
use crate::verify::Random;

crate::mechanism! {
    /// The linkage RSSR, with a second point on each of its two axes.
    struct Shafts { crank: Length, pivot: Point3, axis: Vector3, arm: Vector3, rod: Length }
    input theta: Angle;
    unknown phi: Angle;
    let rocker = pivot + rot(axis, phi) * arm;
    let pin = rot_z(theta) * vec3(crank, 0, 0);
    dot(rocker - pin, rocker - pin) == rod.powi(2);
    output ball: Point3 = rocker;
    output crankpin: Point3 = pin;
    output tip: Point3 = pivot + rot(axis, phi) * (2 * arm);
    let up = vec3(0, 0, crank);
    let along = pivot + axis;
    ground 0, up, pivot, along;
    body crank: 0, pin, up;
    body rod: pin, ball;
    body rocker: pivot, ball, along, tip;
}

const SHAFTS: Shafts = Shafts {
    crank: 0.4,
    pivot: Space::new(1.2, 0.2, 0.3),
    axis: Space::new(0.08, 0.9, 0.12),
    arm: Space::new(0.16, -0.12, 0.76),
    rod: 1.3,
};

crate::mechanism! {
    /// The linkage RSSP, with a slider that is a body.
    struct Rail { crank: Length, start: Point3, rail: Vector3, rod: Length }
    input theta: Angle;
    unknown s: Length;
    let slider = start + s * (rail / norm(rail));
    let pin = rot_z(theta) * vec3(crank, 0, 0);
    dot(slider - pin, slider - pin) == rod.powi(2);
    output ball: Point3 = slider;
    output beside: Point3 = slider + vec3(0, crank, 0);
    let up = vec3(0, 0, crank);
    ground 0, up;
    body crank: 0, up, pin;
    body rod: pin, ball;
    body block: ball, beside;
    slide ball along rail;
}

const RAIL: Rail = Rail {
    crank: 0.3,
    start: Space::new(0.4, 0.5, 0.2),
    rail: Space::new(1.0, 0.2, -0.3),
    rod: 1.4,
};

crate::mechanism! {
    /// The spherical four-bar linkage, of which the ground holds the centre.
    struct Spherical { ground: Angle, crank: Angle, coupler: Angle, rocker: Angle }
    input theta2: Angle;
    unknown theta4: Angle;
    let axis = vec3(0, 0, 1);
    let crank_hinge = rot_z(theta2) * rot_y(crank) * axis;
    let rocker_hinge = rot_y(ground) * rot_z(theta4) * rot_y(rocker) * axis;
    dot(crank_hinge, rocker_hinge) == cos(coupler);
    let rocker_pivot = rot_y(ground) * axis;
    ground 0, axis, rocker_pivot;
    body crank: 0, axis, crank_hinge;
    body coupler: 0, crank_hinge, rocker_hinge;
    body rocker: 0, rocker_pivot, rocker_hinge;
}

crate::mechanism! {
    /// Bennett's linkage, with the directions of its hinges.
    struct Bennett { a: Length, alpha: Angle, beta: Angle }
    input theta1: Angle;
    unknown theta2: Angle, theta3: Angle, theta4: Angle, reach: Length where reach > 0;
    let b = a * sin(beta) / sin(alpha);
    let over = vec3(b, 0, 0) + rot_x(beta) * rot_z(theta3) * vec3(a, 0, 0);
    let back = rot_x(-alpha) * (vec3(-a, 0, 0) - rot_z(-theta1) * vec3(b, 0, 0));
    let from = vec2(over.x, over.y);
    let to = vec2(back.x, back.y);
    theta3 == -theta1;
    reach * cis(theta2) == vec2(dot(from, to), cross(from, to)) / norm(from);
    theta4 == -theta2;
    output second: Point3 = rot_z(theta1) * vec3(a, 0, 0);
    output third: Point3 = rot_z(theta1) * (vec3(a, 0, 0) + rot_x(alpha) * rot_z(theta2) * vec3(b, 0, 0));
    output axis2: Point3 = rot_z(theta1) * rot_x(alpha) * vec3(0, 0, a);
    output axis3: Point3 = rot_z(theta1) * rot_x(alpha) * rot_z(theta2) * rot_x(beta) * vec3(0, 0, a);
    output axis4: Point3 = rot_x(-beta) * vec3(0, 0, a);
    let fourth = vec3(-b, 0, 0);
    ground 0, fourth;
    body link1: 0, second;
    body link2: second, third;
    body link3: third, fourth;
}

crate::mechanism! {
    /// A slider-crank of space with a guide that turns: a barrel on a ball, in which a piston slides that a crank
    /// moves.
    struct Cylinder { crank: Length, base: Point3 }
    input theta: Angle;
    unknown length: Length where length > 0;
    let pin = rot_z(theta) * vec3(crank, 0, 0);
    norm(pin - base) == length;
    output head: Point3 = pin;
    let up = vec3(0, 0, crank);
    ground 0, up, base;
    body crank: 0, up, pin;
    body barrel: base;
    body piston: head;
    slide head along pin - base on barrel;
}

/// Every body of a linkage with a mass and a tensor that no other one has.
fn heavy(linkage: &AnyLinkage<'_>) -> NamedLoads {
    let loads = linkage.loads().gravity(Space::new(0.3, 1.1, -9.81));
    let bodies = linkage.outline().bodies.iter().enumerate();
    bodies.fold(loads, |loads, (index, body)| {
        let part = f64::from(u8::try_from(index).expect("a few bodies")) + 1.0;
        let mass = 0.8 + 0.3 * part;
        let loads = if body.joints.len() > 2 {
            let inertia = [
                [0.02 * part, 0.003, -0.002],
                [0.003, 0.03, 0.001 * part],
                [-0.002, 0.001 * part, 0.04],
            ];
            let centre = Space::new(0.07 * part, 0.11 - 0.03 * part, 0.05);
            loads.solid_of(body.name, Solid { mass, centre, inertia })
        } else {
            loads.mass_of(body.name, mass, Plane::new(0.05 * part, 0.0), 0.02 * part)
        };
        loads.expect("the body is there")
    })
}

fn vector([x, y, z]: [f64; 3]) -> Space<f64> {
    Space::new(x, y, z)
}

/// Whether all forces on each body add up to nothing, and their moments; of a rod, those across it.
fn in_equilibrium<M: Mechanism<Scalar = f64>>(
    linkage: &AnyLinkage<'_>,
    reactions: &NamedReactions<'_>,
    found: &Reactions,
    theta: f64,
) {
    let unknowns = linkage
        .position(&[theta], AssemblyChoice::Index(0).position())
        .expect("it closes");
    let mut places = Vec::new();
    let mut add = |place: &[f64]| places.push(Space::new(place[0], place[1], place[2]));
    let functions = Of::<M>::FUNCTIONS;
    SkeletonOver::<f64>::skeleton_points(functions, linkage.parameters(), &[theta], &unknowns, &mut add);
    for (index, body) in linkage.outline().bodies.iter().enumerate() {
        let mut all: Vec<[Space<f64>; 2]> = Vec::new();
        for connection in &reactions.connections {
            let own = found.of(&connection.name).expect("it is determined");
            let (force, at) = (Space::new(own.x[0], own.y[0], own.z[0]), places[connection.joint]);
            let mut couple = vector(own.moments.map(|moment| moment[0]));
            if connection.slide.is_some() {
                // its guide acts as a load of the body
                couple = Space::zero();
            }
            for (member, sign) in [(connection.on, 1.0), (connection.by, -1.0)] {
                if member == Some(index) {
                    all.push([force, at.cross(force) + couple].map(|part| part.scale(sign)));
                }
            }
        }
        for load in found.body_loads().iter().filter(|load| load.body == body.name) {
            let [at, force, moment] = [load.at, load.force, load.moment].map(vector);
            all.push([force, at.cross(force) + moment]);
        }
        let size = |part: usize| all.iter().map(|own| own[part].norm()).fold(0.0, f64::max);
        let mut sums = [0, 1].map(|part| all.iter().fold(Space::zero(), |sum, own| sum + own[part]));
        if let [from, to] = body.joints {
            let line = places[*to] - places[*from];
            sums[1] = sums[1].cross(line.scale(1.0 / line.norm()));
            if body.name == "block" {
                sums[1] = Space::zero();
            }
        }
        for (part, sum) in sums.into_iter().enumerate() {
            assert!(sum.norm() <= 1e-10 * size(part), "{}: {sum:?} {all:?}", body.name);
        }
    }
}

/// Efforts by equilibrium and by virtual work, with both rates, and the equilibrium of each body.
fn compare<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    range: [f64; 2],
    hinges: impl Fn(NamedReactions<'_>) -> NamedReactions<'_>,
    is_determined: bool,
) {
    let assembly = AssemblyChoice::Index(0);
    let law = Rise::new(Shape::Polynomial56789, range[0], range[1], 0.7).expect("a law");
    let laws: [&dyn Piecewise<f64>; 1] = [&law];
    let linkage = AnyLinkage::of(mechanism);
    let loads = heavy(&linkage);
    let reactions = hinges(linkage.reactions(&loads).expect("its bodies are declared"));
    let sweep = linkage.sweep(assembly.clone()).under_laws(&laws, 0.05..=0.65, 5);
    let rows: Vec<_> = (0..5)
        .map(|row| {
            let motion = law.at(sweep.at(row));
            reactions.at(&[motion], assembly.position()).expect("it is determined")
        })
        .collect();
    for order in 0..3 {
        let column = sweep.of_effort(&loads, 0, order).column().expect("it closes");
        let by_joints = sweep.of_effort_with_friction(&reactions, 0, order).column();
        let by_joints = by_joints.expect("it is determined");
        let size = column.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
        for ((row, effort), along) in rows.iter().zip(&column).zip(by_joints) {
            let own = row.effort(0).expect("it is determined")[order];
            assert!(size > 0.0 && (own - effort).abs() <= 1e-10 * size, "{order}: {own} {effort}");
            assert!((along - effort).abs() <= 1e-10 * size, "{order}: {along} {effort}");
        }
    }
    for (row, found) in rows.iter().enumerate().filter(|_| is_determined) {
        let motion: Motion = law.at(sweep.at(row));
        in_equilibrium::<M>(&linkage, &reactions, found, motion.value());
    }
}

fn itself(reactions: NamedReactions<'_>) -> NamedReactions<'_> {
    reactions
}

fn bennett(reactions: NamedReactions<'_>) -> NamedReactions<'_> {
    reactions
        .hinge("ground_link1", Space::new(0.0, 0.0, 1.0))
        .and_then(|reactions| reactions.hinge("second", "axis2"))
        .and_then(|reactions| reactions.hinge("third", "axis3"))
        .and_then(|reactions| reactions.hinge("ground_link3", "axis4"))
        .expect("they are balls")
}

#[test]
fn virtual_work_gives_the_same_efforts() {
    compare(&SHAFTS, [0.4, 2.9], itself, true);
    compare(&RAIL, [0.4, 2.9], itself, true);
    let mut random = Random::new(11);
    for _ in 0..6 {
        let mut near = |value: f64| value + random.between(-0.1, 0.1);
        let shafts = Shafts {
            crank: near(0.4),
            pivot: Space::new(near(1.2), near(0.2), near(0.3)),
            axis: Space::new(near(0.1), near(0.9), near(0.1)),
            arm: Space::new(near(0.1), near(-0.1), near(0.8)),
            rod: near(1.3),
        };
        let rail = Rail {
            crank: near(0.3),
            start: Space::new(near(0.4), near(0.5), near(0.2)),
            rail: Space::new(near(1.0), near(0.2), near(-0.3)),
            rod: near(1.4),
        };
        let spherical = Spherical {
            ground: near(1.4),
            crank: near(0.5),
            coupler: near(1.2),
            rocker: near(0.9),
        };
        let start = near(0.3);
        compare(&shafts, [start, start + 2.0], itself, true);
        compare(&rail, [start, start + 2.0], itself, true);
        compare(&spherical, [start, start + 2.0], itself, false);
    }
    let cylinder = Cylinder {
        crank: 0.3,
        base: Space::new(1.0, 0.2, -0.4),
    };
    compare(&cylinder, [0.3, 2.4], itself, true);
    let linkage = Bennett {
        a: 0.5,
        alpha: 0.6,
        beta: 1.3,
    };
    compare(&linkage, [0.4, 2.2], bennett, false);
    let joint: library::UniversalJoint = library::UniversalJoint { beta: 0.5 };
    compare(&joint, [0.4, 2.2], itself, false);
}
