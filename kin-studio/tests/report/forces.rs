//! The forces of a page are those of kin-core, in newtons.

use kin_core::any::{AssemblyChoice, PositionChoice};
use kin_core::extremes::Over;
use kin_core::library::ClassThreeTriad;
use kin_core::linkage::AnyLinkage;
use kin_core::prelude::*;
use kin_core::reaction::ReactionPart;
use kin_studio::report::{ActingLoad, CurveKind, Report};

use super::{CRANK_ROCKER, triad};

mechanism! {
    /// A press in millimetres, whose ram carries its weight beside its guide.
    struct Press { crank: Length, rod: Length }
    input theta: Angle;
    unknown phi: Angle, s: Length;
    crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
    output pin: Point = crank * cis(theta);
    output ram: Point = vec2(s, 0);
    ground 0;
    body shaft: 0, pin;
    body conrod: pin, ram;
    body slider: ram;
    slide ram along vec2(1, 0);
}

const PRESS: Press = Press {
    crank: 20.0,
    rod: 160.0,
};
const SPEED: f64 = 50.0;
const MILLIMETRE: f64 = 0.001;

fn close(one: f64, other: f64, size: f64) {
    assert!((one - other).abs() <= 1e-5 * size, "{one} {other}");
}

#[test]
fn samples_are_solutions() {
    let linkage = AnyLinkage::of(&PRESS);
    let loads = linkage.loads().gravity(Plane::new(0.0, -9810.0));
    let loads = loads.mass_of("conrod", 9.0, Plane::new(50.0, 0.0), 45_000.0).unwrap();
    let loads = loads.mass_of("slider", 85.0, Plane::new(60.0, 8.0), 1.1e6).unwrap();
    let page = kin_studio::report(&PRESS)
        .speed(SPEED)
        .units("mm", "s")
        .loads(&loads, MILLIMETRE);
    let report = page.report().unwrap();
    assert_eq!(Report::from_json(&report.to_json()).unwrap(), report);
    let forces = report.forces.unwrap();
    assert_eq!(forces.unknown, None);
    let names: Vec<_> = forces.joints.iter().map(|joint| joint.name.as_str()).collect();
    assert_eq!(names, ["ground_shaft", "pin", "ram", "ram_slide"]);
    let members: Vec<_> = forces.joints.iter().map(|joint| (joint.on, joint.by)).collect();
    assert_eq!(
        members,
        [(Some(0), None), (Some(1), Some(0)), (Some(1), Some(2)), (Some(2), None)]
    );
    let curves: Vec<_> = forces
        .curves
        .iter()
        .map(|curve| (curve.name.as_str(), curve.kind))
        .collect();
    assert_eq!(
        curves,
        [
            ("theta_effort", CurveKind::Moment),
            ("ram_slide_moment", CurveKind::Moment)
        ]
    );

    let reactions = linkage.reactions(&loads).unwrap();
    let turn = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.0], &[std::f64::consts::TAU], 181)
        .speed(SPEED);
    for (index, joint) in forces.joints.iter().enumerate() {
        let force = |order| turn.of_reaction(&reactions, &joint.name, ReactionPart::Force, order);
        let peak = joint.peak.unwrap();
        let own = force(0).peak().unwrap();
        let size = own.value * MILLIMETRE;
        close(peak.value.unwrap(), size, 1e-6 * size);
        close(
            peak.rms.unwrap(),
            force(0).rms(Over::Time).unwrap().value * MILLIMETRE,
            1e-6 * size,
        );
        close(
            peak.rate.unwrap(),
            force(1).peak().unwrap().value * MILLIMETRE,
            1e-6 * SPEED * size,
        );
        for sample in forces.samples.iter().step_by(13) {
            let crank = Motion::at_constant_speed(sample.input, SPEED);
            let found = reactions.at(&[crank], PositionChoice::Assembly(0)).unwrap();
            let force = found.of(&joint.name).unwrap();
            let told = sample.forces[index].unwrap();
            let own = [force.x[0], force.y[0], force.x[1], force.y[1]];
            for (part, (told, own)) in told.into_iter().zip(own).enumerate() {
                let size = if part > 1 { 100.0 * SPEED * size } else { size };
                close(told, own * MILLIMETRE, size);
            }
            let moment = found.of("ram_slide").unwrap().moment[0];
            close(sample.curves[1].unwrap()[0], moment * MILLIMETRE * MILLIMETRE, 50.0);
            let effort = found.effort(0).unwrap()[0];
            close(sample.curves[0].unwrap()[0], effort * MILLIMETRE * MILLIMETRE, 50.0);
        }
    }
    // the weight and inertia of the ram, at its centre
    let ram = forces
        .body_loads
        .iter()
        .position(|load| load.body == 2 && load.kind == ActingLoad::Mass);
    let [x, y, right, up] = forces.samples[0].loads[ram.unwrap()][..] else {
        panic!("it is a force")
    };
    let acceleration = PRESS
        .solve(Motion::at_constant_speed(0.0, SPEED), Assembly::Open)
        .unwrap()
        .s
        .acceleration();
    close(x, -85.0 * acceleration * MILLIMETRE, 1e3);
    close(y, -85.0 * 9.81, 1e3);
    assert_eq!([right, up], [240.0, 8.0]);
}

/// Without declared bodies there are efforts alone, and the page says why.
#[test]
fn guessed_bodies_have_no_forces() {
    let loads = AnyLinkage::of(&CRANK_ROCKER).loads().torque(-3.0, "theta4").unwrap();
    let forces = kin_studio::report(&CRANK_ROCKER)
        .loads(&loads, 1.0)
        .report()
        .unwrap()
        .forces
        .unwrap();
    assert!(forces.joints.is_empty() && forces.body_loads.is_empty());
    assert!(forces.unknown.unwrap().contains("add\nground "));
    assert!(forces.samples.iter().all(|sample| sample.curves[0].is_some()));
}

/// A coupled block is swept from inside of the range to both ends, and the samples ascend.
#[test]
#[cfg_attr(not(feature = "gallery"), ignore = "a minute, for the feature gallery")]
fn samples_of_coupled_blocks_ascend() {
    let triad = triad();
    let loads = AnyLinkage::of::<ClassThreeTriad>(&triad)
        .loads()
        .torque(2.0, "phi")
        .unwrap();
    let draft = kin_studio::report(&triad)
        .at([3.4, 3.4, 3.6])
        .moving("a")
        .range(3.0..=6.5);
    let forces = draft.loads(&loads, 1.0).report().unwrap().forces.unwrap();
    assert!(forces.samples.windows(2).all(|pair| pair[0].input < pair[1].input));
}
