//! How the peaks of forces depend on the dimensions.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::{FOUR_BAR, FourBar, heavy, pin, rubbed};
use crate::any::{AssemblyChoice, PositionChoice};
use crate::assembly::Assembly;
use crate::extremes::{ByReaction, ExtremeKind, PeakSensitivities, QuantityAlong};
use crate::geometry::{Plane, Space};
use crate::library;
use crate::linkage::{AnyLinkage, AnySweep};
use crate::load::{Load, Loads, NamedLoads};
use crate::mechanism::Mechanism;
use crate::motion::Motion;
use crate::number::{Row, samples};
use crate::reaction::{NamedReactions, ReactionPart};
use crate::solve::Scalar;
use crate::sweep::{Local, StraightLine, Swept as _};
use crate::verify::Random;

/// So much dimensions differ.
const STEP: f64 = 1e-5;

fn loads(linkage: &AnyLinkage<'_>) -> NamedLoads {
    let loads = linkage.loads().mass_of("coupler", 1.4, "coupler_centre", 0.05);
    let loads = loads.and_then(|loads| loads.mass_of("rocker", 1.1, "rocker_centre", 0.03));
    loads
        .and_then(|loads| loads.torque(-12.0, "theta4"))
        .expect("all names are there")
}

fn typed<T: Scalar>() -> Loads<FourBar<T>, impl Load<FourBar<T>>> {
    Loads::<FourBar<T>>::new()
        .mass(1.4, |pose| pose.coupler_centre)
        .inertia(0.05, |pose| pose.theta3)
        .mass(1.1, |pose| pose.rocker_centre)
        .inertia(0.03, |pose| pose.theta4)
        .torque(-12.0, |pose| pose.theta4)
}

/// Virtual work knows the same of the torque of the drive, from dual numbers.
#[test]
fn virtual_work_gives_the_same_sensitivities() {
    let linkage = AnyLinkage::of(&FOUR_BAR);
    let reactions = linkage.reactions(&loads(&linkage)).expect("its bodies are declared");
    let turn = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.0], &[TAU], 25)
        .speed(9.0);
    let found = turn
        .of_effort_with_friction(&reactions, 0, 0)
        .peak_sensitivities()
        .expect("it is smooth");
    let masses = typed::<Local>();
    let own = FOUR_BAR.sweep(Assembly::Open).over(0.0..=TAU, 25).speed(9.0);
    let own = own
        .of_expression(|at| at.effort(&masses, 0))
        .peak_sensitivities()
        .expect("it is smooth");
    assert!((found.peak.at - own.peak.at).abs() < 1e-9);
    for (found, own) in found.by.iter().zip(&own.by) {
        assert!(
            (found.value - own.value).abs() < 1e-9 * (1.0 + own.value.abs()),
            "{found:?} {own:?}"
        );
        assert!((found.at - own.at).abs() < 1e-8, "{found:?} {own:?}");
    }
}

crate::mechanism! {
    /// Slider-crank whose guide may pass beside the pivot of the crank.
    struct OffsetCrank { crank: Length, rod: Length, offset: Length }
    input theta: Angle;
    unknown phi: Angle, s: Length;
    crank * cis(theta) + rod * cis(phi) == vec2(s, offset);
    output pin: Point = crank * cis(theta);
    output piston: Point = vec2(s, offset);
    ground 0;
    body shaft: 0, pin;
    body conrod: pin, piston;
    body block: piston;
    slide piston along vec2(1, 0);
}

crate::mechanism! {
    /// Bell crank with two arms at right angles.
    struct BellCrank { long: Length, short: Length }
    input theta: Angle;
    unknown psi: Angle;
    psi == theta;
    output tip: Point = polar(long, psi);
    output heel: Point = vec2(-short * sin(psi), short * cos(psi));
    ground 0;
    body lever: 0, tip, heel;
}

/// The speed of the crank.
const SPEED: f64 = 9.0;

/// How forces in a pose change with a dimension: the value and the rates at a place that stays, by differences of six
/// steps, whose error is of the sixth power of a step.
fn differences<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    dimension: usize,
    forces: impl Fn(&M) -> [f64; 3],
) -> [f64; 3] {
    let parameters = mechanism.parameters();
    let value: f64 = parameters[dimension];
    let step = 3e-4 * if value == 0.0 { 1.0 } else { value.abs() };
    let changed = |change: f64| {
        forces(&M::from_parameters(Row::from_fn(|index| {
            parameters[index] + if index == dimension { change } else { 0.0 }
        })))
    };
    let [one, two, three] = [1.0, 2.0, 3.0].map(|steps| {
        let [above, below] = [steps, -steps].map(|steps| changed(steps * step));
        core::array::from_fn::<f64, 3, _>(|order| above[order] - below[order])
    });
    core::array::from_fn(|order| (45.0 * one[order] - 9.0 * two[order] + three[order]) / (60.0 * step))
}

/// Compares with differences where the peak is. There, a force F of the angle θ changes with a dimension d by ∂F/∂d,
/// and its place moves by -(∂²F/∂θ∂d) / (∂²F/∂θ²).
fn agree<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    order: usize,
    found: &PeakSensitivities,
    forces: impl Fn(&M) -> [f64; 3],
) {
    let own = forces(mechanism);
    assert!(
        (own[order] - found.peak.value).abs() < 1e-9 * own[order].abs(),
        "{own:?}"
    );
    let parameters = mechanism.parameters();
    for (dimension, by) in found.by.iter().enumerate() {
        let differences = differences(mechanism, dimension, &forces);
        let value: f64 = parameters[dimension];
        let unit = if value == 0.0 { 1.0 } else { value.abs() };
        let size = own[order].abs() / unit;
        assert!(
            (by.value - differences[order]).abs() < 1e-8 * (size + by.value.abs()),
            "{dimension}: {by:?} {differences:?} of {own:?}"
        );
        if order == 0 && found.peak.kind == ExtremeKind::Inner {
            let at = -SPEED * differences[1] / own[2];
            assert!(
                (by.at - at).abs() < 1e-7 * (1.0 / unit + at.abs()),
                "{dimension}: {by:?} {at}"
            );
        }
    }
}

/// The size of one of the forces, and the torque of the drive, along a range of the crank.
fn compare<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    joint: &str,
    range: [f64; 2],
    near: Option<&[f64]>,
    stated: impl for<'l> Fn(&'l AnyLinkage<'_>) -> NamedReactions<'l>,
) {
    let linkage = AnyLinkage::of(mechanism);
    let reactions = stated(&linkage);
    let assembly = near.map_or(AssemblyChoice::Index(0), |near| AssemblyChoice::Near(near.to_vec()));
    let turn = linkage.sweep(assembly).between(&[range[0]], &[range[1]], 25);
    let turn = turn.speed(SPEED);
    let in_pose = |mechanism: &M, at: f64| {
        let linkage = AnyLinkage::of(mechanism);
        let choice = near.map_or(PositionChoice::Assembly(0), PositionChoice::Near);
        let found = stated(&linkage).at(&[Motion::at_constant_speed(at, SPEED)], choice);
        found.expect("it closes")
    };
    for order in 0..2 {
        let force = turn.of_reaction(&reactions, joint, ReactionPart::Force, order);
        let found = force.peak_sensitivities().expect("it is smooth");
        agree(mechanism, order, &found, |own| {
            let found = in_pose(own, found.peak.at).of(joint);
            found.expect("it is determined").magnitude()
        });
    }
    let effort = turn.of_effort_with_friction(&reactions, 0, 0);
    let found = effort.peak_sensitivities().expect("it is smooth");
    agree(mechanism, 0, &found, |own| {
        let effort = in_pose(own, found.peak.at).effort(0);
        effort.expect("it is determined")
    });
}

/// The reactions under masses of all bodies.
fn of_masses<'l>(linkage: &'l AnyLinkage<'_>) -> NamedReactions<'l> {
    linkage.reactions(&heavy(linkage)).expect("its bodies are declared")
}

/// The same with the bodies that the equations tell.
fn guessed<'l>(linkage: &'l AnyLinkage<'_>) -> NamedReactions<'l> {
    linkage.reactions_as_guessed(&heavy(linkage)).expect("it has bodies")
}

#[test]
fn four_bars_of_random_dimensions() {
    let mut random = Random::new(3);
    for _ in 0..samples::some_of(2, 12) {
        let crank = random.between(0.2, 0.35);
        let [r1, r3] = [0; 2].map(|_| random.between(0.75, 0.95));
        let four_bar = FourBar {
            r1,
            r2: crank,
            r3,
            r4: r1 + r3 - crank - random.between(0.65, 0.9),
        };
        compare(&four_bar, "knee", [0.0, TAU], None, of_masses);
    }
}

/// With an offset of nothing, some entries of the equations are zero in all poses, but change with it.
#[test]
fn slider_cranks_of_random_dimensions() {
    let mut random = Random::new(4);
    for sample in 0..samples::some_of(2, 12) {
        let crank = random.between(0.03, 0.06);
        let slider = OffsetCrank {
            crank,
            rod: random.between(2.5, 4.0) * crank,
            offset: if sample == 0 {
                0.0
            } else {
                random.between(-0.5, 0.5) * crank
            },
        };
        compare(&slider, "piston", [0.2, 2.8], None, of_masses);
        compare(&slider, "pin", [0.2, 2.8], None, |linkage| {
            rubbed(of_masses(linkage), &[("pin", pin(0.05, 0.01))])
        });
    }
}

/// A block without a closed form, with the coordinates of points among its dimensions.
#[test]
fn coupled_blocks() {
    let triad = library::StephensonII {
        r1: 4.0,
        r2: 2.0,
        p: Plane::new(1.5, 1.2),
        r3: 3.0,
        q: Plane::new(0.3, 1.0),
        r4: 0.5,
        r5: 1.6,
        r6: 3.0,
    };
    let linkage = AnyLinkage::of(&triad);
    let (all, _) = linkage.positions_at(&[-0.2]).expect("it closes");
    let reactions = guessed(&linkage);
    let joint = reactions.names().nth(1).expect("it has joints");
    compare(&triad, joint, [-0.2, 0.0], Some(&all[0]), guessed);
}

#[test]
fn hinges_in_space() {
    let shafts = library::Rssr {
        crank: 1.0,
        pivot: Space::new(3.0, 0.1, 0.0),
        axis: Space::new(0.0, 1.0, 0.1),
        arm: Space::new(0.0, 0.0, 2.0),
        rod: 3.6,
    };
    compare(&shafts, "ball", [0.0, TAU], None, |linkage| {
        let loads = linkage.loads().torque(-5.0, "phi");
        let loads = loads.and_then(|loads| loads.mass_of("rod", 0.8, Plane::new(1.5, 0.0), 0.02));
        let reactions = linkage.reactions(&loads.expect("names")).expect("bodies");
        let reactions = reactions.hinge("ground_crank", Space::new(0.0, 0.0, 1.0));
        reactions
            .and_then(|own| own.hinge("ground_arm", "axis"))
            .expect("balls")
    });
}

/// The weights P at the tip and Q at the heel need the torque P a cos θ - Q b sin θ. Its peak is √(A² + B²) with A = P
/// a and B = Q b, at -arctan(B/A).
#[test]
fn a_bell_crank_by_hand() {
    let bell = BellCrank { long: 0.3, short: 0.2 };
    let linkage = AnyLinkage::of(&bell);
    let loads = linkage.loads().force(Plane::new(0.0, -50.0), "tip");
    let loads = loads.and_then(|loads| loads.force(Plane::new(0.0, -20.0), "heel"));
    let reactions = linkage
        .reactions(&loads.expect("points"))
        .expect("its body is declared");
    let turn = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[-FRAC_PI_2], &[FRAC_PI_2], 25)
        .speed(SPEED);
    let effort = turn.of_effort_with_friction(&reactions, 0, 0);
    let found = effort.peak_sensitivities().expect("it is smooth");
    let (long, short) = (50.0 * bell.long, 20.0 * bell.short);
    let square = long * long + short * short;
    let peak = f64::sqrt(square);
    assert!((found.peak.value - peak).abs() < 1e-13 * peak, "{found:?}");
    let expected = [
        [50.0 * long / peak, 50.0 * short / square],
        [20.0 * short / peak, -20.0 * long / square],
    ];
    for (by, [value, at]) in found.by.iter().zip(expected) {
        assert!((by.value - value).abs() < 1e-13 * peak, "{by:?} {value}");
        assert!((by.at - at).abs() < 1e-12, "{by:?} {at}");
    }
    // the end of a sweep stays where it is
    let short_turn = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.25], &[1.0], 25)
        .speed(SPEED);
    let effort = short_turn.of_effort_with_friction(&reactions, 0, 0);
    let found = effort.peak_sensitivities().expect("it is smooth");
    assert_eq!((found.peak.kind, found.peak.at), (ExtremeKind::End, 0.25));
    let expected = [50.0 * 0.25_f64.cos(), -20.0 * 0.25_f64.sin()];
    for (by, value) in found.by.iter().zip(expected) {
        assert!(
            (by.value - value).abs() < 1e-13 * peak && by.at == 0.0,
            "{by:?} {value}"
        );
    }
}

/// The force in a joint with friction in all of them, of a linkage with these dimensions.
fn with_force<R>(
    dimensions: [f64; 4],
    name: &str,
    ask: impl Fn(QuantityAlong<'_, AnySweep<'_, StraightLine>, ByReaction<'_>>) -> R,
) -> R {
    let linkage = FourBar::from_parameters(dimensions);
    let linkage = AnyLinkage::of(&linkage);
    let reactions = linkage.reactions(&loads(&linkage)).expect("its bodies are declared");
    let all = ["base", "pin", "knee", "pivot"].map(|name| (name, pin(0.1, 0.01)));
    let reactions = rubbed(reactions, &all);
    let turn = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.0], &[TAU], 25)
        .speed(9.0);
    ask(turn.of_reaction(&reactions, name, ReactionPart::Force, 0))
}

/// The peaks of other designs differ by as much, with friction too. The rocker, on which a torque acts, turns back.
#[test]
fn peaks_of_other_designs_differ_by_their_sensitivities() {
    let dimensions = FOUR_BAR.parameters();
    let joints = if samples::are_all() {
        &["knee", "base"][..]
    } else {
        &["base"]
    };
    for name in joints {
        let found = with_force(dimensions, name, |force| {
            force.peak_sensitivities().expect("it is smooth")
        });
        for (index, by) in found.by.into_iter().enumerate() {
            let peak = |step: f64| {
                let mut changed = dimensions;
                changed[index] += step;
                with_force(changed, name, |force| force.peak().expect("it moves"))
            };
            let (more, less) = (peak(STEP), peak(-STEP));
            let [value, at] = [more.value - less.value, more.at - less.at].map(|change| change / (2.0 * STEP));
            assert!((by.value - value).abs() < 1e-6 * (1.0 + value.abs()), "{by:?} {value}");
            assert!((by.at - at).abs() < 1e-5 * (1.0 + at.abs()), "{by:?} {at}");
        }
    }
}
