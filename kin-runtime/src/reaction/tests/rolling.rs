//! Gears, racks and wheels: closed forms, virtual work, and what does not roll.

use std::string::ToString as _;

use super::mistakes::{message, still};
use super::{heavy, pin, prepared};
use crate::any::{AssemblyChoice, Of};
use crate::extremes::ExtremesError;
use crate::geometry::{Plane, Space};
use crate::law::{Law as _, Piecewise, Rise, Shape};
use crate::library;
use crate::linkage::AnyLinkage;
use crate::load::{LoadPoint, NamedLoads};
use crate::mechanism::Mechanism;
use crate::number::samples;
use crate::reaction::{NamedReactions, ProofError, ReactionError, ReactionPart, Rolling};
use crate::verify::Random;

crate::mechanism! {
    /// Two gears in mesh, on the outside for a positive ratio of minus one, on the inside for one.
    struct Pair { pinion: Length, wheel: Length, sense: Scalar }
    input theta: Angle;
    unknown phi: Angle;
    wheel * phi == sense * pinion * theta;
    output pivot: Point = vec2(wheel - sense * pinion, 0);
    output tooth: Point = polar(pinion, theta);
    output rim: Point = vec2(wheel - sense * pinion, 0) + polar(wheel, phi);
    ground 0, pivot;
    body pinion: 0, tooth;
    body wheel: pivot, rim;
}

crate::mechanism! {
    /// A five-bar linkage whose cranks are geared to each other.
    struct GearedFiveBar {
        first: Length, second: Length, left: Length, left_rod: Length, right_rod: Length, right: Length, phase: Angle,
    }
    input alpha: Angle;
    unknown beta: Angle, phi: Angle, psi: Angle;
    second * (beta - phase) == -first * alpha;
    left * cis(alpha) + left_rod * cis(phi) == first + second + right * cis(beta) + right_rod * cis(psi);
    output hand: Point = left * cis(alpha) + left_rod * cis(phi);
    output elbow: Point = left * cis(alpha);
    output knee: Point = first + second + right * cis(beta);
    output pivot: Point = vec2(first + second, 0);
    ground 0, pivot;
    body crank: 0, elbow;
    body rod: elbow, hand;
    body link: knee, hand;
    body follower: pivot, knee;
}

crate::mechanism! {
    /// A pinion moves a rack.
    struct Rack { radius: Length }
    input theta: Angle;
    unknown s: Length;
    s == -radius * theta;
    output tooth: Point = polar(radius, theta);
    output tip: Point = vec2(s, radius);
    ground 0;
    body pinion: 0, tooth;
    body rack: tip;
    slide tip along vec2(1, 0);
}

crate::mechanism! {
    /// A crank rolls a wheel on a straight track, by a rod to its hub.
    struct Wheel { crank: Length, rod: Length, radius: Length }
    input theta: Angle;
    unknown phi: Angle, s: Length, roll: Angle;
    crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
    roll * radius == -s;
    output hub: Point = vec2(s, 0);
    output spoke: Point = vec2(s, 0) + polar(radius, roll);
    ground 0;
    body crank: 0, crank * cis(theta);
    body rod: crank * cis(theta), hub;
    body wheel: hub, spoke;
    slide hub along vec2(1, 0);
}

crate::mechanism! {
    /// A planet gear on a carrier between a sun that stands still and a ring.
    struct Planet { sun: Length, planet: Length }
    input carrier: Angle;
    unknown roll: Angle, ring: Angle;
    planet * roll == (sun + planet) * carrier;
    (sun + 2 * planet) * ring == 2 * (sun + planet) * carrier;
    output axle: Point = polar(sun + planet, carrier);
    output tooth: Point = polar(sun + planet, carrier) + polar(planet, roll);
    output rim: Point = polar(sun + 2 * planet, ring);
    ground 0;
    body carrier: 0, axle;
    body planet: axle, tooth;
    body ring: 0, rim;
}

const GEARED: GearedFiveBar = GearedFiveBar {
    first: 0.4,
    second: 0.5,
    left: 0.2,
    left_rod: 0.7,
    right_rod: 0.6,
    right: 0.25,
    phase: 0.4,
};

/// Efforts with both rates by equilibrium and by virtual work.
fn compare<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    loads: impl Fn(&AnyLinkage<'_>) -> NamedLoads,
    gears: impl Fn(NamedReactions<'_>) -> NamedReactions<'_>,
) {
    let assembly = AssemblyChoice::Index(0);
    let law = Rise::new(Shape::Polynomial56789, 0.3, 2.3, 0.7).expect("a law");
    let laws: [&dyn Piecewise<f64>; 1] = [&law];
    let linkage = AnyLinkage::of(mechanism);
    let loads = loads(&linkage);
    let reactions = gears(linkage.reactions(&loads).expect("its bodies are declared"));
    let sweep = linkage.sweep(assembly.clone()).under_laws(&laws, 0.05..=0.65, 5);
    let motions = [0, 1, 2, 3, 4].map(|row| law.at(sweep.at(row)));
    prepared::compare(&reactions, &motions);
    for order in 0..3 {
        let column = sweep.of_effort(&loads, 0, order).column().expect("it closes");
        let by_joints = sweep.of_effort_with_friction(&reactions, 0, order).column();
        let size = column.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
        for (own, effort) in by_joints.expect("it is determined").iter().zip(&column) {
            assert!(
                size > 0.0 && (own - effort).abs() <= 1e-10 * size,
                "{order}: {own} {effort}"
            );
        }
    }
}

#[test]
fn two_gears_pass_on_a_torque() {
    let slope = 20_f64.to_radians().tan();
    for (sense, torque) in [(-1.0, -30.0), (-1.0, 30.0), (1.0, -30.0), (1.0, 30.0)] {
        let (pinion, wheel) = (0.02, 0.06);
        let linkage = AnyLinkage::new(Of::<Pair>::FUNCTIONS, &[pinion, wheel, sense]);
        let loads = linkage.loads().torque(torque, "phi").expect("an angle");
        let bare = linkage.reactions(&loads).expect("its bodies are declared");
        for (bodies, centres, radii) in [
            (
                ["pinion", "wheel"],
                [Plane::zero().into(), "pivot".into()],
                [pinion, wheel],
            ),
            (
                ["wheel", "pinion"],
                ["pivot".into(), Plane::zero().into()],
                [wheel, pinion],
            ),
        ] {
            let [one, other]: [LoadPoint<'_>; 2] = centres;
            let gears = Rolling::gears(one, other, radii).at_pressure_angle(20_f64.to_radians());
            let reactions = bare.clone().rolling("mesh", bodies, gears).expect("they roll");
            assert_eq!(reactions.bodies_of("mesh").expect("a contact"), [bodies[1], bodies[0]]);
            let found = still(&reactions, &[0.3]).expect("it is determined");
            let at = found.pitch_point("mesh").expect("a contact");
            assert!((at.x + sense * pinion).abs() < 1e-15 && at.y == 0.0, "{at:?}");
            // the power of the drive is that of the load
            let [effort, ..] = found.effort(0).expect("it is determined");
            assert!((effort + sense * torque * pinion / wheel).abs() < 1e-13);
            let on_wheel = if bodies[1] == "wheel" { 1.0 } else { -1.0 };
            let mesh = found.of("mesh").expect("it is determined");
            // the pitch point lies to the left of the wheel's centre
            let tangential = torque / wheel * on_wheel;
            assert!((mesh.y[0] - tangential).abs() < 1e-11, "{mesh:?} {tangential}");
            // teeth push the pinion towards its own centre
            let radial = torque.abs() / wheel * slope * on_wheel * -sense;
            assert!((mesh.x[0] - radial).abs() < 1e-11, "{mesh:?} {radial}");
            let ground = found.of("ground_pinion").expect("it is determined");
            assert!((ground.x[0] - mesh.x[0] * on_wheel).abs() < 1e-11);
            assert!((ground.y[0] - mesh.y[0] * on_wheel).abs() < 1e-11);
        }
    }
}

#[test]
fn virtual_work_gives_the_same_efforts() {
    let angle = 20_f64.to_radians();
    let geared = |linkage: GearedFiveBar| {
        let gears = Rolling::gears(Plane::zero(), "pivot", [linkage.first, linkage.second]);
        compare(&linkage, heavy, |reactions| {
            let meshed = reactions.rolling("mesh", ["crank", "follower"], gears.at_pressure_angle(angle));
            meshed.expect("they roll")
        });
    };
    geared(GEARED);
    let mut random = Random::new(5);
    for _ in 0..samples::of(20) {
        let mut near = |value: f64| value + random.between(-0.04, 0.04);
        geared(GearedFiveBar {
            first: near(0.4),
            second: near(0.5),
            left: near(0.2),
            left_rod: near(0.7),
            right_rod: near(0.6),
            right: near(0.25),
            phase: near(0.4),
        });
    }
    let wheel = Wheel {
        crank: 0.1,
        rod: 0.35,
        radius: 0.12,
    };
    compare(&wheel, heavy, |reactions| {
        let track = Rolling::rack("hub", 0.12, Plane::new(1.0, 0.0));
        let driven = reactions.driving("theta", "crank").expect("a body");
        driven.rolling("track", ["wheel", "ground"], track).expect("it rolls")
    });
    let planet = Planet { sun: 0.3, planet: 0.1 };
    compare(&planet, heavy, |reactions| {
        let sun = Rolling::gears(Plane::zero(), "axle", [0.3, 0.1]).at_pressure_angle(angle);
        let ring = Rolling::gears("axle", Plane::zero(), [0.1, 0.5]).at_pressure_angle(angle);
        let meshed = reactions.rolling("sun", ["ground", "planet"], sun).expect("they roll");
        meshed
            .rolling("ring_mesh", ["planet", "ring"], ring)
            .expect("they roll")
    });
}

/// A rack is pushed by the torque over the radius, and its guide bears the moment.
#[test]
fn a_pinion_and_a_rack() {
    let linkage = AnyLinkage::of(&Rack { radius: 0.05 });
    let loads = linkage.loads().force(Plane::new(-400.0, 0.0), "tip").expect("a point");
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    let rack = Rolling::rack(Plane::zero(), 0.05, Plane::new(3.0, 0.0)).at_pressure_angle(0.35);
    let reactions = reactions.rolling("mesh", ["pinion", "rack"], rack).expect("they roll");
    let found = still(&reactions, &[-0.6]).expect("it is determined");
    let at = found.pitch_point("mesh").expect("a contact");
    assert!(at.x.abs() < 1e-15 && (at.y - 0.05).abs() < 1e-15 && found.pitch_point("tip").is_none());
    let mesh = found.of("mesh").expect("it is determined");
    assert!((mesh.x[0] - 400.0).abs() < 1e-11 && (mesh.y[0] - 400.0 * 0.35_f64.tan()).abs() < 1e-11);
    assert!((found.effort(0).expect("it is determined")[0] + 400.0 * 0.05).abs() < 1e-12);
    let guide = found.of("tip").expect("it is determined");
    // the tip stands at 0.03, and the teeth at 0
    let moment = 0.03 * mesh.y[0];
    assert!(
        (guide.y[0] + mesh.y[0]).abs() < 1e-11 && (guide.moment[0] - moment).abs() < 1e-11,
        "{guide:?}"
    );
}

#[test]
fn what_does_not_roll() {
    let linkage = AnyLinkage::of(&GEARED);
    let reactions = linkage.reactions(&linkage.loads()).expect("its bodies are declared");
    let stated = |bodies: [&str; 2], rolling: Rolling<'_>| reactions.clone().rolling("mesh", bodies, rolling);
    let gears = |radii| Rolling::gears(Plane::zero(), "pivot", radii);
    let pair = ["crank", "follower"];
    let fails = |rolling| message(stated(pair, rolling).and_then(|meshed| still(&meshed, &[0.4])));
    assert_eq!(
        message(still(&reactions, &[0.4])),
        "the joints leave `rod`, `link`, `follower` 1 freedom while the inputs stand: declare the joint that \
         is missing; if gears or racks stand for `second * (beta - phase) == -first * alpha`, say by \
         `rolling`, in a file by `gears` or `rack`, which bodies they are"
    );
    assert_eq!(
        fails(gears([0.4, 0.6])),
        "the contact `mesh`: the distance of the centres is 0.9, which is neither the sum of the radii nor \
         their difference"
    );
    assert_eq!(
        fails(gears([0.5, 0.4])),
        "the contact `mesh`: its bodies slip on each other by 0.18 per unit of an input: the radii, the \
         centres or the direction do not agree with the equation by which they move"
    );
    assert_eq!(
        fails(gears([0.4, -0.5])),
        "the contact `mesh`: the radius is -0.5: give one above zero"
    );
    assert_eq!(
        fails(gears([0.4, 0.5]).at_pressure_angle(1.6)),
        "the contact `mesh`: the pressure angle is 1.6: give one from zero on, below a right angle"
    );
    assert_eq!(
        fails(Rolling::gears(Plane::zero(), "pivt", [0.4, 0.5])),
        "there is no point `pivt`; there is `hand`, `elbow`, `knee`, `pivot`"
    );
    assert_eq!(
        message(stated(["crank", "folower"], gears([0.4, 0.5]))),
        "there is no body `folower`; there is `crank`, `rod`, `link`, `follower`"
    );
    let meshed = stated(pair, gears([0.4, 0.5])).expect("they roll");
    assert_eq!(
        message(meshed.clone().rolling("hand", pair, gears([0.4, 0.5]))),
        "the contact `hand`: a reaction has this name already: give another one"
    );
    assert_eq!(
        message(meshed.clone().friction("mesh", pin(0.1, 0.01))),
        "the friction of `mesh`: it rolls, and friction is that of a pin or a slide"
    );
    assert_eq!(
        message(meshed.joint_of("mesh")),
        "the contact `mesh`: it is a contact, which is no joint of the picture"
    );
    let spatial = AnyLinkage::of(&library::UniversalJoint { beta: 0.4 });
    let reactions = spatial.reactions(&spatial.loads()).expect("its bodies are declared");
    assert_eq!(
        message(reactions.rolling(
            "mesh",
            ["driving", "driven"],
            Rolling::rack(Space::zero(), 1.0, Plane::new(1.0, 0.0))
        )),
        "the contact `mesh`: gears and racks are those of the plane, and the mechanism is one of space"
    );
}

/// The force between gears is the torque by the radius, whatever the input is; a pressure angle has no proof.
#[test]
fn proofs_of_gears() {
    let linkage = AnyLinkage::of(&Pair {
        pinion: 0.02,
        wheel: 0.06,
        sense: -1.0,
    });
    let loads = linkage.loads().torque(-30.0, "phi").expect("an angle");
    let turn = linkage.sweep(AssemblyChoice::Index(0)).between(&[0.0], &[1.0], 2);
    let turn = turn.speed(5.0);
    let reactions = |pressure_angle: f64| {
        let gears = Rolling::gears(Plane::zero(), "pivot", [0.02, 0.06]).at_pressure_angle(pressure_angle);
        let reactions = linkage.reactions(&loads).expect("bodies");
        reactions.rolling("mesh", ["pinion", "wheel"], gears).expect("gears")
    };
    let bare = reactions(0.0);
    let force = turn.proof(&bare).of("mesh", ReactionPart::Force).expect("a force");
    let peak = force.peak(1e-6).expect("it is proved");
    assert!(peak.lower.force <= 500.0 && peak.upper >= 500.0, "{peak:?}");
    assert!(peak.upper - peak.lower.force < 1e-3, "{peak:?}");
    let inclined = reactions(0.3);
    let error = turn.proof(&inclined).of("mesh", ReactionPart::Force).err();
    assert!(matches!(error, Some(ProofError::PressureAngle { .. })), "{error:?}");
}

/// Gears of given radii roll in designs of these radii alone, so that their force has no derivative by the others.
#[test]
fn forces_of_one_design() {
    let linkage = AnyLinkage::of(&Pair {
        pinion: 0.02,
        wheel: 0.06,
        sense: -1.0,
    });
    let loads = linkage.loads().torque(-30.0, "phi").expect("an angle");
    let gears = Rolling::gears(Plane::zero(), "pivot", [0.02, 0.06]);
    let reactions = linkage.reactions(&loads).expect("bodies");
    let reactions = reactions.rolling("mesh", ["pinion", "wheel"], gears).expect("gears");
    let turn = linkage.sweep(AssemblyChoice::Index(0)).between(&[0.0], &[1.0], 2);
    let turn = turn.speed(5.0);
    let force = turn.of_reaction(&reactions, "mesh", ReactionPart::Force, 0);
    let error = force.peak_sensitivities().expect_err("the radii differ");
    let ExtremesError::Reaction { error: reason, .. } = &error else {
        panic!("{error}")
    };
    assert!(
        matches!(&**reason, ReactionError::ThisDesignOnly { dimension, .. } if dimension == "pinion"),
        "{error}"
    );
    let message = error.to_string();
    assert!(
        message.contains("the forces have no derivative with respect to `pinion`"),
        "{message}"
    );
}
