//! Forces in the joints of space: bodies cut free by hand, virtual work, equilibrium, differences and messages.

use std::string::ToString;
use std::vec::Vec;

use super::mistakes::{message, still};
use super::prepared;
use crate::any::{AssemblyChoice, Of, PositionChoice, SkeletonOver};
use crate::assembly::Assembly;
use crate::geometry::{Plane, Space};
use crate::law::{Law as _, Piecewise, Rise, Shape};
use crate::library;
use crate::linkage::AnyLinkage;
use crate::load::{NamedLoads, Solid};
use crate::mechanism::Mechanism;
use crate::motion::Motion;
use crate::number::samples;
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
    struct Guided { crank: Length, start: Point3, rail: Vector3, rod: Length }
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
    body block: ball, beside;
    body rod: pin, ball;
    slide ball along rail;
}

const RAIL: Guided = Guided {
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
            let (force, at) = (
                Space::new(own.x[0], own.y[0], own.z[0]),
                places[connection.joint.expect("a joint")],
            );
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
    let motions: Vec<_> = (0..5).map(|row| law.at(sweep.at(row))).collect();
    prepared::compare(&reactions, &motions);
    for order in 0..3 {
        let column = sweep.of_effort(&loads, 0, order).column().expect("it closes");
        let by_joints = sweep.of_effort_with_friction(&reactions, 0, order).column();
        let by_joints = by_joints.expect("it is determined");
        let size = column.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
        for ((row, effort), along) in rows.iter().zip(&column).zip(by_joints) {
            let own = row.effort(0).expect("it is determined")[order];
            assert!(
                size > 0.0 && (own - effort).abs() <= 1e-10 * size,
                "{order}: {own} {effort}"
            );
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
    for _ in 0..samples::of(10) {
        let mut near = |value: f64| value + random.between(-0.1, 0.1);
        let shafts = Shafts {
            crank: near(0.4),
            pivot: Space::new(near(1.2), near(0.2), near(0.3)),
            axis: Space::new(near(0.1), near(0.9), near(0.1)),
            arm: Space::new(near(0.1), near(-0.1), near(0.8)),
            rod: near(1.3),
        };
        let rail = Guided {
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

/// The solution of linear equations, by elimination with pivots in columns.
fn eliminated(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let count = rows.len();
    for step in 0..count {
        let size = |row: &usize| rows[*row][step].abs();
        let pivot = (step..count).max_by(|one, other| size(one).total_cmp(&size(other)));
        rows.swap(step, pivot.expect("a row"));
        let pivot = rows[step].clone();
        for row in rows
            .iter_mut()
            .enumerate()
            .filter(|(row, _)| *row != step)
            .map(|(_, row)| row)
        {
            let factor = row[step] / pivot[step];
            for (own, entry) in row.iter_mut().zip(&pivot) {
                *own -= factor * entry;
            }
        }
    }
    (0..count).map(|row| rows[row][count] / rows[row][row]).collect()
}

/// The unit vector along an axis of coordinates.
fn axis(index: usize) -> Space<f64> {
    let part = |own: usize| f64::from(u8::from(own == index));
    Space::new(part(0), part(1), part(2))
}

/// A body cut free by hand: its centre with its acceleration, and the rate of its angular momentum about it.
struct Free {
    mass: f64,
    centre: Space<f64>,
    acceleration: Space<f64>,
    momentum_rate: Space<f64>,
}

/// The acceleration of a place of a body.
fn acceleration([turn, change]: [Space<f64>; 2], arm: Space<f64>) -> Space<f64> {
    change.cross(arm) + turn.cross(turn.cross(arm))
}

/// The rate of the angular momentum of a body about its centre, by Euler's equations in its own axes.
fn momentum_rate(axes: [Space<f64>; 3], inertia: [[f64; 3]; 3], [turn, change]: [Space<f64>; 2]) -> Space<f64> {
    let tensor = |vector: Space<f64>| {
        let mut sum = Space::zero();
        for row in 0..3 {
            for column in 0..3 {
                sum = sum + axes[row].scale(inertia[row][column] * axes[column].dot(vector));
            }
        }
        sum
    };
    tensor(change) + turn.cross(tensor(turn))
}

/// Newton's and Euler's equations of the linkage RSSR as seventeen equations in numbers: six of the crank, six of the
/// rocker and five of the rod, of which angles and lengths come from the position alone.
#[test]
fn bodies_of_rssr_cut_free() {
    const GRAVITY: Space<f64> = Space::new(0.4, -0.7, -9.81);
    const INERTIA: [[f64; 3]; 3] = [[0.02, 0.003, -0.002], [0.003, 0.03, 0.001], [-0.002, 0.001, 0.04]];
    let solid = |mass, centre| Solid {
        mass,
        centre,
        inertia: INERTIA,
    };
    let crank_centre = Space::new(0.11, 0.05, -0.02);
    let rocker_centre = Space::new(0.3, -0.06, 0.08);
    let force = Space::new(3.0, -20.0, 11.0);
    let linkage = AnyLinkage::of(&SHAFTS);
    let loads = linkage
        .loads()
        .gravity(GRAVITY)
        .solid_of("crank", solid(2.0, crank_centre))
        .and_then(|loads| loads.mass_of("rod", 1.1, Plane::new(0.6, 0.0), 0.15))
        .and_then(|loads| loads.solid_of("rocker", solid(3.0, rocker_centre)))
        .and_then(|loads| loads.force(force, "tip"))
        .expect("all names are there");
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    let names: Vec<_> = reactions.names().collect();
    assert_eq!(names, ["ground_crank", "ground_rocker", "crankpin", "ball"]);
    for (theta, speed, change) in [(0.3, 7.0, -11.0), (1.9, -4.0, 30.0), (4.4, 0.0, 9.0), (5.5, 0.0, 0.0)] {
        let motion = Motion::from((theta, speed, change, 50.0, -70.0));
        let found = reactions
            .at(&[motion], PositionChoice::Assembly(0))
            .expect("it is determined");
        let pose = SHAFTS.solve(motion, Assembly::Open).expect("it closes");
        let [phi, phi_speed, phi_change] = [pose.phi.value(), pose.phi.velocity(), pose.phi.acceleration()];

        let (up, along) = (axis(2), SHAFTS.axis.scale(1.0 / SHAFTS.axis.norm()));
        let radial = Space::new(theta.cos(), theta.sin(), 0.0);
        let pin = radial.scale(SHAFTS.crank);
        // Rodrigues' formula
        let arm = SHAFTS.arm.scale(phi.cos())
            + along.cross(SHAFTS.arm).scale(phi.sin())
            + along.scale(along.dot(SHAFTS.arm) * (1.0 - phi.cos()));
        let ball = SHAFTS.pivot + arm;
        let crank_turn = [up.scale(speed), up.scale(change)];
        let rocker_turn = [along.scale(phi_speed), along.scale(phi_change)];
        let frame = |first: Space<f64>, beside: Space<f64>| {
            let first = first.scale(1.0 / first.norm());
            let third = first.cross(beside);
            let third = third.scale(1.0 / third.norm());
            [first, third.cross(first), third]
        };
        let of = |axes: [Space<f64>; 3], Space { x, y, z }: Space<f64>| {
            axes[0].scale(x) + axes[1].scale(y) + axes[2].scale(z)
        };
        let crank_axes = frame(radial, up);
        let rocker_axes = frame(arm, SHAFTS.axis);
        let [crank_arm, rocker_arm] = [of(crank_axes, crank_centre), of(rocker_axes, rocker_centre)];
        let crank = Free {
            mass: 2.0,
            centre: crank_arm,
            acceleration: acceleration(crank_turn, crank_arm),
            momentum_rate: momentum_rate(crank_axes, INERTIA, crank_turn),
        };
        let rocker = Free {
            mass: 3.0,
            centre: SHAFTS.pivot + rocker_arm,
            acceleration: acceleration(rocker_turn, rocker_arm),
            momentum_rate: momentum_rate(rocker_axes, INERTIA, rocker_turn),
        };
        let ends = [acceleration(crank_turn, pin), acceleration(rocker_turn, arm)];
        let line = (ball - pin).scale(1.0 / SHAFTS.rod);
        let part = 0.6 / SHAFTS.rod;
        let rod = Free {
            mass: 1.1,
            centre: pin + line.scale(0.6),
            acceleration: ends[0] + (ends[1] - ends[0]).scale(part),
            momentum_rate: line.cross(ends[1] - ends[0]).scale(0.15 / SHAFTS.rod),
        };

        // forces on the crank by the ground, on the rocker by the ground, on the rod by the crank, on the rocker by the
        // rod; moments on the crank about x and y, on the rocker across its axis; the torque on the crank
        let across = axis(0).cross(along);
        let rocker_moments = [across, along.cross(across)];
        let mut columns: Vec<[Space<f64>; 6]> = Vec::new();
        let zero: Space<f64> = Space::zero();
        for [at, signs] in [
            [zero, Space::new(1.0, 0.0, 0.0)],
            [SHAFTS.pivot, Space::new(0.0, 0.0, 1.0)],
            [pin, Space::new(-1.0, 1.0, 0.0)],
            [ball, Space::new(0.0, -1.0, 1.0)],
        ] {
            for direction in [0, 1, 2].map(axis) {
                let own = |sign: f64, free: &Free| {
                    let force = direction.scale(sign);
                    [force, (at - free.centre).cross(force)]
                };
                let [[a, b], [c, d], [e, f]] = [own(signs.x, &crank), own(signs.y, &rod), own(signs.z, &rocker)];
                columns.push([a, b, c, d, e, f]);
            }
        }
        for moment in [axis(0), axis(1)] {
            columns.push([zero, moment, zero, zero, zero, zero]);
        }
        for moment in rocker_moments {
            columns.push([zero, zero, zero, zero, zero, moment]);
        }
        columns.push([zero, up, zero, zero, zero, zero]);
        let lacking = |free: &Free| (free.acceleration - GRAVITY).scale(free.mass);
        let tip = SHAFTS.pivot + arm.scale(2.0);
        columns.push([
            lacking(&crank),
            crank.momentum_rate,
            lacking(&rod),
            rod.momentum_rate,
            lacking(&rocker) - force,
            rocker.momentum_rate - (tip - rocker.centre).cross(force),
        ]);
        let beside = line.cross(axis(0));
        let rod_turns = [beside, line.cross(beside)];
        let mut rows: Vec<Vec<f64>> = Vec::new();
        for place in 0..6 {
            let directions = if place == 3 {
                rod_turns.to_vec()
            } else {
                [0, 1, 2].map(axis).to_vec()
            };
            for direction in directions {
                rows.push(columns.iter().map(|column| column[place].dot(direction)).collect());
            }
        }
        assert_eq!(rows.len(), 17);
        let values = eliminated(rows);
        let size = values.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
        let close = |own: f64, expected: f64| assert!((own - expected).abs() <= 1e-12 * size, "{own} {expected}");
        for (name, place) in [("ground_crank", 0), ("ground_rocker", 3), ("crankpin", 6), ("ball", 9)] {
            let own = found.of(name).expect("it is determined");
            for (own, expected) in [own.x[0], own.y[0], own.z[0]].into_iter().zip(&values[place..]) {
                close(own, *expected);
            }
        }
        let moments = |name: &str| {
            vector(
                found
                    .of(name)
                    .expect("it is determined")
                    .moments
                    .map(|moment| moment[0]),
            )
        };
        let shaft = moments("ground_crank");
        close(shaft.x, values[12]);
        close(shaft.y, values[13]);
        close(shaft.z, 0.0);
        let moment = rocker_moments[0].scale(values[14]) + rocker_moments[1].scale(values[15]);
        close((moments("ground_rocker") - moment).norm(), 0.0);
        close(found.effort(0).expect("it is determined")[0], values[16]);
        assert_eq!(reactions.bodies_of("crankpin").expect("a joint"), ["rod", "crank"]);
    }
}

/// The rates of forces and moments are their differences along the motion.
#[test]
fn rates_are_differences() {
    const STEP: f64 = 1e-5;
    let linkage = AnyLinkage::of(&RAIL);
    let loads = heavy(&linkage)
        .spring(300.0, 0.1, "beside", Space::new(0.5, 0.2, 0.9))
        .and_then(|loads| loads.damper(20.0, "beside", Space::new(0.1, 0.9, -0.3)))
        .and_then(|loads| loads.torsion_spring(40.0, 0.3, "s"))
        .and_then(|loads| loads.torsion_damper(3.0, "theta"))
        .and_then(|loads| loads.inertia(0.4, "theta"))
        .expect("all names are there");
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    let law = Rise::new(Shape::Polynomial56789, 0.4, 2.0, 0.7).expect("a law");
    let at = |time: f64| {
        let found = reactions.at(&[law.at(time)], PositionChoice::Assembly(0));
        found.expect("it is determined")
    };
    let parts = [
        ReactionPart::X,
        ReactionPart::Y,
        ReactionPart::Z,
        ReactionPart::Force,
        ReactionPart::Moment,
        ReactionPart::MomentX,
        ReactionPart::MomentY,
        ReactionPart::MomentZ,
    ];
    for time in [0.2, 0.45] {
        let all = [time - STEP, time, time + STEP].map(at);
        for name in reactions.names() {
            for part in parts {
                // a ball has no moment
                let of = |found: &Reactions| found.of(name).expect("it is determined").part(part);
                let [before, own, behind] = [&all[0], &all[1], &all[2]].map(of);
                for order in 0..2 {
                    let difference = (behind[order] - before[order]) / (2.0 * STEP);
                    let size = own[order].abs() + own[order + 1].abs() + difference.abs();
                    let rounding = 1e-6 * size + 1e-7;
                    assert!(
                        (own[order + 1] - difference).abs() <= rounding,
                        "{name} {part:?} {order}: {own:?} {difference}"
                    );
                }
            }
        }
    }
    let sweep = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.4], &[2.0], 5)
        .speed(3.0);
    let along = |part| {
        let quantity = sweep.of_reaction(&reactions, "ball_slide", part, 0);
        quantity.column().expect("it is determined")
    };
    let [x, y, z] = [ReactionPart::MomentX, ReactionPart::MomentY, ReactionPart::MomentZ].map(along);
    for (row, size) in along(ReactionPart::Moment).into_iter().enumerate() {
        let expected = Space::new(x[row], y[row], z[row]).norm();
        assert!(
            size > 0.0 && (size - expected).abs() <= 1e-14 * size,
            "{size} {expected}"
        );
    }
}

/// A guide holds a block against a force beside it in all three moments.
#[test]
fn a_guide_holds_all_moments() {
    let linkage = AnyLinkage::of(&RAIL);
    let force = Space::new(2.0, -3.0, 7.0);
    let loads = linkage.loads().force(force, "beside").expect("a point");
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    let found = still(&reactions, &[0.8]).expect("it is determined");
    let slide = found.of("ball_slide").expect("it is determined");
    let expected = Space::new(0.0, 0.3, 0.0).cross(force);
    for (own, expected) in slide.moments.iter().zip([expected.x, expected.y, expected.z]) {
        assert!((own[0] + expected).abs() < 1e-14, "{own:?} {expected}");
    }
    // the rod has the part along the rail, and the slide bears nothing along it
    let rail = RAIL.rail.scale(1.0 / RAIL.rail.norm());
    let on_slide = Space::new(slide.x[0], slide.y[0], slide.z[0]);
    assert!(on_slide.dot(rail).abs() < 1e-13);
    let ball = found.of("ball").expect("it is determined");
    let rod = Space::new(ball.x[0], ball.y[0], ball.z[0]);
    assert_eq!(reactions.bodies_of("ball").expect("a joint"), ["rod", "block"]);
    assert!((on_slide + force - rod).norm() < 1e-13, "{rod:?} {on_slide:?}");
}

/// What is determined is told, and what is not is named.
#[test]
fn linkages_that_hold_themselves() {
    let linkage = AnyLinkage::of(&Spherical {
        ground: 1.4,
        crank: 0.5,
        coupler: 1.2,
        rocker: 0.9,
    });
    let loads = heavy(&linkage);
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    let found = still(&reactions, &[0.6]).expect("it has a solution");
    assert!(found.effort(0).is_some());
    let error = found.of("crank_coupler").expect_err("it is not determined").to_string();
    assert_eq!(
        error,
        "the force `crank_coupler` is not determined: the joints hold the bodies in more than one way, and equilibrium \
         leaves open `ground_crank`, `ground_rocker`, `crank_coupler`, `coupler_rocker`"
    );
    // about the centre, the moments are determined though the forces through it are not
    let sweep = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.4], &[2.0], 3)
        .speed(3.0);
    let of = |part| sweep.of_reaction(&reactions, "ground_crank", part, 0).column();
    assert!(of(ReactionPart::MomentX).is_ok() && of(ReactionPart::Moment).is_ok());
    assert!(of(ReactionPart::X).is_err());
}

#[test]
fn what_to_declare() {
    let linkage = library::Rssr {
        crank: 0.4,
        pivot: Space::new(1.2, 0.2, 0.3),
        axis: Space::new(0.08, 0.9, 0.12),
        arm: Space::new(0.16, -0.12, 0.76),
        rod: 1.3,
    };
    let linkage = AnyLinkage::of(&linkage);
    let reactions = linkage.reactions(&linkage.loads()).expect("its bodies are declared");
    let names: Vec<_> = reactions.names().map(ToString::to_string).collect();
    assert_eq!(names, ["ground_crank", "ground_arm", "crank_rod", "ball"]);
    assert_eq!(
        message(still(&reactions, &[0.4])),
        "no hinge and no slide moves like the drive of `theta`: bodies that share one point have a ball \
         joint there, as `ground_crank`, `ground_arm`, `crank_rod`, `ball`: for a hinge, list a second point \
         of its axis in both bodies, or give the axis by `hinge`, in a file by `hinge of .. = ..;`"
    );
    let up = Space::new(0.0, 0.0, 1.0);
    let crank = reactions.clone().hinge("ground_crank", up).expect("a ball");
    assert_eq!(
        message(still(&crank, &[0.4])),
        "the joints leave `rod`, `arm` 1 freedom while the inputs stand: declare the joint that is missing; \
         bodies that share one point have a ball joint there, as `ground_arm`, `crank_rod`, `ball`: for a \
         hinge, list a second point of its axis in both bodies, or give the axis by `hinge`, in a file by `hinge of .. \
         = ..;`"
    );
    let loads = linkage.loads().torque(-4.0, "phi").expect("an angle");
    let hinged = linkage.reactions(&loads).expect("its bodies are declared");
    let hinged = hinged.hinge("ground_crank", up).expect("a ball");
    let hinged = hinged.hinge("ground_arm", "axis").expect("a ball");
    let found = still(&hinged, &[0.4]).expect("it is determined");
    let own = found.effort(0).expect("it is determined")[0];
    let sweep = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.4], &[0.5], 2)
        .speed(1.0);
    let effort = sweep.of_effort(&loads, 0, 0).column().expect("it closes")[0];
    assert!((own - effort).abs() < 1e-13, "{own} {effort}");
    assert_eq!(
        message(hinged.clone().hinge("ground_arm", up)),
        "`ground_arm` cannot have an axis: that of a pin in the plane, of a slide, and of a hinge is known"
    );
    assert_eq!(
        message(hinged.clone().hinge("ankle", up)),
        "there is no reaction `ankle`; there is `ground_crank`, `ground_arm`, `crank_rod`, `ball`"
    );
    assert_eq!(
        message(crank.clone().hinge("ground_arm", "axs")),
        "there is no point `axs`; there is `pivot`, `axis`, `arm`, `ball`"
    );
    let turned = reactions.clone().hinge("ground_crank", "ball").expect("a ball");
    assert_eq!(
        message(still(&turned, &[0.4])),
        "the axis of `ground_crank` turns against the body `crank` by 0.5929047 per unit of an input: give a \
         direction that is fixed to both bodies of the joint"
    );
    let friction = Friction::Pin {
        coefficient: 0.1,
        radius: 0.01,
    };
    assert_eq!(
        message(hinged.friction("ball", friction)),
        "the friction of `ball`: friction is found in the plane, and the mechanism is one of space"
    );

    let shafts = AnyLinkage::of(&SHAFTS);
    let load = |loads: NamedLoads| message(still(&shafts.reactions(&loads).expect("bodies"), &[0.4]));
    let beside = shafts.loads().mass_of("rod", 1.0, Plane::new(0.5, 0.1), 0.1);
    assert_eq!(
        load(beside.expect("a body")),
        "load 1: the centre does not lie on the line of the first two joints, and the body is one of space: \
         give its mass with all moments of inertia by `solid_of`"
    );
    let plane = AnyLinkage::of(&super::FOUR_BAR);
    let solid = Solid {
        mass: 1.0,
        centre: Space::zero(),
        inertia: [[0.0; 3]; 3],
    };
    let loads = plane.loads().solid_of("crank", solid).expect("a body");
    let reactions = plane.reactions(&loads).expect("its bodies are declared");
    assert_eq!(
        message(still(&reactions, &[0.4])),
        "load 1: the mechanism is one of the plane, whose bodies have one moment of inertia: give it by \
         `mass_of`"
    );
    assert_eq!(
        message(reactions.hinge("knee", up)),
        "`knee` cannot have an axis: that of a pin in the plane, of a slide, and of a hinge is known"
    );
    assert!(matches!(
        crank.hinge("crank_rod", up).and_then(|wrong| still(&wrong, &[0.4])),
        Err(ReactionError::HingeTurns { .. } | ReactionError::Free { .. })
    ));
}
