//! Forces in joints beside other ways to the same numbers.

use std::string::ToString;
use std::vec::Vec;

use super::{FOUR_BAR, FourBar, heavy, pin, prepared, rubbed, slide};
use crate::any::{AssemblyChoice, Of, SkeletonOver};
use crate::assembly::Assembly;
use crate::geometry::Plane;
use crate::law::{Law as _, Piecewise, Rise, Shape};
use crate::library;
use crate::linkage::AnyLinkage;
use crate::load::{Loaded, Loads};
use crate::mechanism::Mechanism;
use crate::number::samples;
use crate::reaction::{NamedReactions, Reaction, ReactionPart, Reactions};
use crate::verify::Random;

/// Whether all forces on each body add up to nothing, and their moments.
fn in_equilibrium(reactions: &NamedReactions<'_>, found: &Reactions, places: &[Plane]) {
    for (index, body) in reactions.functions.outline().bodies.iter().enumerate() {
        let mut all: Vec<[f64; 3]> = Vec::new();
        for connection in &reactions.connections {
            let Reaction { x, y, .. } = found.of(&connection.name).expect("it is determined");
            let (force, at) = (Plane::new(x[0], y[0]), places[connection.joint.expect("a joint")]);
            for (member, sign) in [(connection.on, 1.0), (connection.by, -1.0)] {
                if member == Some(index) {
                    all.push([force.x, force.y, at.cross(force)].map(|part| sign * part));
                }
            }
        }
        for load in found.body_loads().iter().filter(|load| load.body == body.name) {
            let [at, force] = [load.at, load.force].map(|[x, y, _]| Plane::new(x, y));
            all.push([force.x, force.y, at.cross(force) + load.moment[2]]);
        }
        for part in 0..3 {
            let size = all.iter().fold(0.0, |size: f64, own| size.max(own[part].abs()));
            let sum: f64 = all.iter().map(|own| own[part]).sum();
            assert!(size > 0.0 && sum.abs() <= 1e-10 * size, "{}: {all:?}", body.name);
        }
    }
}

/// The same with friction in all joints.
fn rubbed_everywhere(reactions: NamedReactions<'_>) -> NamedReactions<'_> {
    let names: Vec<_> = reactions.names().map(ToString::to_string).collect();
    let friction = |name: &str| match reactions.is_slide(name) {
        Ok(true) => slide(0.05),
        _ => pin(0.05, 0.01),
    };
    let all: Vec<_> = names.iter().map(|name| (name.as_str(), friction(name))).collect();
    rubbed(reactions, &all)
}

/// Efforts by equilibrium and by virtual work, with both rates, the forces along a sweep beside those of single poses,
/// and the equilibrium of each body.
fn compare<M: Mechanism<Scalar = f64>>(mechanism: &M, range: [f64; 2]) {
    let assembly = AssemblyChoice::Index(0);
    let law = Rise::new(Shape::Polynomial56789, range[0], range[1], 0.7).expect("a law");
    let laws: [&dyn Piecewise<f64>; 1] = [&law];
    let linkage = AnyLinkage::of(mechanism);
    let loads = heavy(&linkage);
    let reactions = linkage.reactions_as_guessed(&loads).expect("bodies of the plane");
    let sweep = linkage.sweep(assembly.clone()).under_laws(&laws, 0.05..=0.65, 7);
    let efforts: Vec<Vec<f64>> = (0..3)
        .map(|order| sweep.of_effort(&loads, 0, order).column().expect("it closes"))
        .collect();
    let rows: Vec<_> = (0..7)
        .map(|row| {
            let motion = law.at(sweep.at(row));
            reactions.at(&[motion], assembly.position()).expect("it is determined")
        })
        .collect();
    let motions: Vec<_> = (0..7).map(|row| law.at(sweep.at(row))).collect();
    prepared::compare(&reactions, &motions);
    let solved = sweep.reactions(&reactions).expect("it moves");
    let name = reactions.names().next().expect("a joint").to_string();
    let force_along = |reactions: &NamedReactions<'_>| {
        let force = sweep.of_reaction(reactions, &name, ReactionPart::Force, 0);
        force.column().expect("it is determined")
    };
    let bare = force_along(&reactions);
    // what is remembered without friction does not answer for it
    let rubbed = rubbed_everywhere(reactions.clone());
    prepared::compare(&rubbed, &motions);
    let with_friction = sweep.reactions(&rubbed).expect("it moves");
    for (((along, bare), found), at) in force_along(&rubbed).iter().zip(bare).zip(&with_friction).zip(0..) {
        let found = found.as_ref().expect("it is determined");
        let [force, ..] = found.of(&name).expect("it is determined").magnitude();
        assert!((along - force).abs() <= 1e-10 * force, "{at}: {along} {force}");
        assert!((along - bare).abs() > 1e-6 * force, "{at}: friction changes nothing");
    }
    for (((row, found), with_friction), at) in rows.iter().zip(&solved).zip(&with_friction).zip(0..) {
        let inputs = [law.at::<1>(sweep.at(at)).value()];
        let unknowns = linkage.position(&inputs, assembly.position()).expect("it closes");
        let mut places = Vec::new();
        let functions = Of::<M>::FUNCTIONS;
        let mut add = |place: &[f64]| places.push(Plane::new(place[0], place[1]));
        SkeletonOver::<f64>::skeleton_points(functions, linkage.parameters(), &inputs, &unknowns, &mut add);
        in_equilibrium(&reactions, row, &places);
        in_equilibrium(&reactions, found.as_ref().expect("it is determined"), &places);
        in_equilibrium(&rubbed, with_friction.as_ref().expect("it is determined"), &places);
    }
    let close = |one: f64, other: f64, size: f64| assert!((one - other).abs() <= 1e-10 * size, "{one} {other} {size}");
    let power = sweep.of_power(&loads, 0).column().expect("it closes");
    let by_joints = sweep.of_power_with_friction(&reactions, 0).column();
    let size = power.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
    for (one, other) in by_joints.expect("it is determined").iter().zip(&power) {
        close(*one, *other, size);
    }
    for (order, column) in efforts.iter().enumerate() {
        let by_joints = sweep.of_effort_with_friction(&reactions, 0, order).column();
        let by_joints = by_joints.expect("it is determined");
        let size = column.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
        assert!(size > 0.0);
        for ((row, effort), along) in rows.iter().zip(column).zip(by_joints) {
            close(row.effort(0).expect("it is determined")[order], *effort, size);
            close(along, *effort, size);
        }
    }
    for name in reactions.names() {
        for order in 0..3 {
            let column = sweep.of_reaction(&reactions, name, ReactionPart::Force, order).column();
            let column = column.expect("it is determined");
            let size = column.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
            for ((row, found), force) in rows.iter().zip(&solved).zip(column) {
                close(row.of(name).expect("it is determined").magnitude()[order], force, size);
                let found = found.as_ref().expect("it is determined").of(name);
                close(found.expect("it is determined").magnitude()[order], force, size);
            }
        }
    }
}

#[test]
fn virtual_work_gives_the_same_efforts() {
    compare(&FOUR_BAR, [0.4, 2.9]);
    let mut random = Random::new(3);
    for _ in 0..samples::of(20) {
        // by Grashof's condition, each is a crank-rocker
        let [r1, r2, r3, r4] =
            [(0.8, 1.0), (0.2, 0.3), (0.7, 0.9), (0.65, 0.7)].map(|(low, high)| random.between(low, high));
        let start = random.between(0.0, 6.0);
        compare(&FourBar { r1, r2, r3, r4 }, [start, start + 2.0]);
    }
    let engine: library::SliderCrank = library::SliderCrank { r: 0.1, l: 0.3 };
    compare(&engine, [0.4, 3.9]);
    let offset: library::OffsetSliderCrank = library::OffsetSliderCrank {
        r: 0.1,
        l: 0.3,
        h: 0.04,
    };
    compare(&offset, [0.4, 3.9]);
    let inverted: library::InvertedSliderCrank = library::InvertedSliderCrank { r1: 0.5, r2: 0.2 };
    compare(&inverted, [0.4, 3.9]);
    let quick: library::WhitworthQuickReturn = library::WhitworthQuickReturn {
        ground: 0.05,
        crank: 0.1,
        arm: 0.15,
        rod: 0.5,
    };
    compare(&quick, [0.4, 3.9]);
    let watt = library::WattI {
        r1: 0.9,
        r2: 0.3,
        r3: 0.8,
        r4: 0.6,
        p: Plane::new(0.35, 0.1),
        q: Plane::new(0.4, 0.3),
        r5: 0.5,
        r6: 0.45,
    };
    compare(&watt, [0.6, 1.4]);
    let yoke: library::ScotchYoke = library::ScotchYoke { crank: 0.2, gamma: 1.4 };
    compare(&yoke, [0.3, 2.1]);
}

/// The forces of the ground, with the moment of the drive, change the momentum of the links.
#[test]
fn the_ground_feels_the_shaking_force() {
    let linkage = AnyLinkage::of(&FOUR_BAR);
    let loads = linkage
        .loads()
        .mass_of("crank", 0.7, "crank_centre", 0.01)
        .and_then(|loads| loads.mass_of("coupler", 1.4, "coupler_centre", 0.05))
        .and_then(|loads| loads.mass_of("rocker", 1.1, "rocker_centre", 0.03))
        .expect("all names are there");
    let typed = Loads::<FourBar>::new()
        .mass(0.7, |pose| pose.crank_centre)
        .mass(1.4, |pose| pose.coupler_centre)
        .mass(1.1, |pose| pose.rocker_centre)
        .inertia(0.01, |pose| pose.theta2)
        .inertia(0.05, |pose| pose.theta3)
        .inertia(0.03, |pose| pose.theta4);
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    assert_eq!(reactions.names().collect::<Vec<_>>(), ["base", "pivot", "pin", "knee"]);
    for start in [0.3, 1.7, 4.0] {
        let crank = crate::motion::Motion::from((start, 7.0, -3.0, 20.0, 80.0));
        let balance = FOUR_BAR.balance(&typed, [crank], Assembly::Open).expect("it closes");
        let found = reactions
            .at(&[crank], crate::any::PositionChoice::Assembly(0))
            .expect("it is determined");
        let [base, pivot] = ["base", "pivot"].map(|name| found.of(name).expect("it is determined"));
        let [effort] = balance.efforts();
        for order in 0..3 {
            let shaking = balance.shaking_force().as_slice()[order];
            let moment = balance.shaking_moment().as_slice()[order].z;
            let own = found.effort(0).expect("it is determined")[order];
            for (found, expected) in [
                (base.x[order] + pivot.x[order], -shaking.x),
                (base.y[order] + pivot.y[order], -shaking.y),
                (own + 0.9 * pivot.y[order], -moment),
                (own, effort.as_slice()[order]),
            ] {
                assert!(
                    (found - expected).abs() <= 1e-11 * expected.abs(),
                    "{order}: {found} {expected}"
                );
            }
        }
    }
}

#[test]
fn names_tell_the_bodies() {
    let linkage = AnyLinkage::of(&FOUR_BAR);
    let reactions = linkage.reactions(&linkage.loads()).expect("its bodies are declared");
    assert_eq!(reactions.bodies_of("knee").expect("a joint"), ["rocker", "coupler"]);
    assert_eq!(reactions.bodies_of("base").expect("a joint"), ["crank", "ground"]);
    let error = reactions.bodies_of("ankle").expect_err("no joint");
    assert_eq!(
        error.to_string(),
        "there is no reaction `ankle`; there is `base`, `pivot`, `pin`, `knee`"
    );
}

crate::mechanism! {
    /// A table that a crank lifts between two walls, and a dyad on its edge: three bodies share a joint, and the table
    /// cannot turn.
    pub(super) struct Lift { crank: Length, rod: Length, width: Length, link: Length, arm: Length }
    input theta: Angle;
    unknown phi: Angle, height: Length, psi: Angle, chi: Angle;
    crank * cis(theta) + rod * cis(phi) == vec2(0, height);
    vec2(width, height) + link * cis(psi) == vec2(3 * width, 0) + arm * cis(chi);
    output pin: Point = crank * cis(theta);
    output foot: Point = vec2(0, height);
    output edge: Point = vec2(width, height);
    output elbow: Point = vec2(3 * width, 0) + arm * cis(chi);
    output load: Point = vec2(width / 2, height + width / 3);
    ground 0, vec2(3 * width, 0);
    body lever: 0, pin;
    body strut: pin, foot;
    body table: foot, edge, load;
    body link: edge, elbow;
    body arm: vec2(3 * width, 0), elbow;
    slide foot along vec2(0, 1);
}

pub(super) const LIFT: Lift = Lift {
    crank: 0.1,
    rod: 0.3,
    width: 0.2,
    link: 0.35,
    arm: 0.3,
};

/// A guide holds a table that nothing else keeps from turning: by its moment.
#[test]
fn a_guide_has_a_moment() {
    compare(&LIFT, [0.4, 2.2]);
    let linkage = AnyLinkage::of(&LIFT);
    let loads = linkage.loads().force(Plane::new(0.0, -50.0), "load").expect("a point");
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    let crank = crate::motion::Motion::at_constant_speed(0.8, 0.0);
    let choice = crate::any::PositionChoice::Assembly(0);
    let found = reactions.at(&[crank], choice).expect("it is determined");
    let of = |name: &str| found.of(name).expect("it is determined");
    // link and arm carry nothing, and the force has an arm of half the width
    assert!(of("elbow").magnitude()[0] < 1e-12 && of("edge").magnitude()[0] < 1e-12);
    let slide = of("foot_slide");
    assert!((slide.moment[0] - 50.0 * 0.1).abs() < 1e-12, "{:?}", slide.moment);
    assert_eq!(reactions.bodies_of("foot_slide").expect("a slide"), ["strut", "ground"]);
}

/// The rates of a force are its differences along the motion.
#[test]
fn rates_are_differences() {
    const STEP: f64 = 1e-5;
    let linkage = AnyLinkage::of(&LIFT);
    let loads = heavy(&linkage)
        .spring(300.0, 0.1, "load", Plane::new(0.5, 0.2))
        .and_then(|loads| loads.damper(20.0, "load", Plane::new(0.1, 0.9)))
        .and_then(|loads| loads.torsion_spring(4.0, 0.3, "chi"))
        .and_then(|loads| loads.torsion_damper(3.0, "height"))
        .and_then(|loads| loads.inertia(0.04, "psi"))
        .expect("all names are there");
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    let law = Rise::new(Shape::Polynomial56789, 0.4, 2.0, 0.7).expect("a law");
    let at = |time: f64| {
        let found = reactions.at(&[law.at(time)], crate::any::PositionChoice::Assembly(0));
        found.expect("it is determined")
    };
    for time in [0.2, 0.45] {
        let [before, own, behind] = [time - STEP, time, time + STEP].map(at);
        for name in reactions.names() {
            let [before, own, behind] = [&before, &own, &behind].map(|found| found.of(name).expect("it is determined"));
            for (before, own, behind) in [
                (before.x, own.x, behind.x),
                (before.y, own.y, behind.y),
                (before.moment, own.moment, behind.moment),
                (before.magnitude(), own.magnitude(), behind.magnitude()),
            ] {
                for order in 0..2 {
                    let difference = (behind[order] - before[order]) / (2.0 * STEP);
                    // the error is the square of the step times a rate two orders higher, which is up to 1e4 times as
                    // large
                    let size = own[order].abs() + own[order + 1].abs() + difference.abs();
                    let rounding = 1e-6 * size + 1e-8;
                    assert!(
                        (own[order + 1] - difference).abs() <= rounding,
                        "{name} {order}: {own:?} {difference}"
                    );
                }
            }
        }
    }
}
