//! Friction beside closed forms, bodies cut free, and the balance of power.

use std::f64::consts::{FRAC_PI_4, PI, TAU};
use std::string::ToString;
use std::vec::Vec;

use super::{ENGINE, FOUR_BAR, FourBar, LIFT, bushing, heavy, pin, rubbed, slide};
use crate::any::{AssemblyChoice, PositionChoice};
use crate::assembly::Assembly;
use crate::extremes::{ExtremeKind, Over};
use crate::geometry::Plane;
use crate::law::{Piecewise, Rise, Shape};
use crate::library;
use crate::linkage::AnyLinkage;
use crate::load::NamedLoads;
use crate::motion::Motion;
use crate::number::samples;
use crate::reaction::{Friction, NamedReactions, ReactionError, ReactionPart, Reactions};
use crate::verify::Random;

fn at(reactions: &NamedReactions<'_>, inputs: &[Motion]) -> Reactions {
    reactions
        .at(inputs, PositionChoice::Assembly(0))
        .expect("it is determined")
}

fn effort(found: &Reactions) -> [f64; 3] {
    found.effort(0).expect("it is determined")
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} {expected}");
}

crate::mechanism! {
    /// A bob on an arm.
    struct Pendulum { length: Length }
    input theta: Angle;
    unknown x: Length;
    x == length * cos(theta);
    output bob: Point = polar(length, theta);
    ground 0;
    body arm: 0, bob;
}

/// The moment μ r |F| of a force whose square is m² (g² + L² ω⁴ - 2 g L ω² sin θ), with both rates.
#[test]
fn a_pendulum_in_its_pin() {
    let (length, mass, gravity, arm) = (0.4, 1.5, 9.81, 0.2 * 0.01);
    let linkage = AnyLinkage::of(&Pendulum { length });
    let loads = linkage.loads().gravity(Plane::new(0.0, -gravity)).mass(mass, "bob");
    let bare = linkage
        .reactions(&loads.expect("a point"))
        .expect("its bodies are declared");
    let reactions = rubbed(bare.clone(), &[("ground_arm", pin(0.2, 0.01))]);
    for speed in [-4.0, 6.0_f64] {
        let theta = 0.7_f64;
        let motion = [Motion::at_constant_speed(theta, speed)];
        let (sine, cosine) = theta.sin_cos();
        let square = speed * speed;
        let size =
            (gravity * gravity + length * length * square * square - 2.0 * gravity * length * square * sine).sqrt();
        let [first, second] = [-2.0 * cosine * speed, 2.0 * sine * square].map(|term| gravity * length * square * term);
        let rate = first / (2.0 * size);
        let rates = [size, rate, (0.5 * second - rate * rate) / size];
        let found = at(&reactions, &motion);
        let force = found.of("ground_arm").expect("it is determined");
        for (order, expected) in rates.into_iter().enumerate() {
            let expected = mass * arm * expected * speed.signum();
            let tolerance = 1e-13 * (1.0 + expected.abs());
            close(force.moment[order], -expected, tolerance);
            close(force.friction[order], -expected, tolerance);
            close(found.heat()[order], expected * speed, 10.0 * tolerance);
            close(
                effort(&found)[order] - effort(&at(&bare, &motion))[order],
                expected,
                1e-11 * (1.0 + expected.abs()),
            );
        }
        // its own moment changes no force in the pin
        assert!(found.contraction() < 1e-12, "{}", found.contraction());
    }
}

const ENGINE_FRICTION: [(&str, Friction); 4] = [
    ("ground_arm", pin(0.15, 0.02)),
    ("pin", pin(0.1, 0.02)),
    ("piston", pin(0.2, 0.012)),
    ("piston_slide", slide(0.12)),
];

fn engine(linkage: &AnyLinkage<'static>) -> NamedReactions<'static> {
    let loads = linkage
        .loads()
        .force(Plane::new(-900.0, 0.0), "piston")
        .expect("a point");
    linkage.reactions(&loads).expect("its bodies are declared")
}

/// The force of the rod is tangent to the friction circles in both pins. (K. J. Waldron, G. L. Kinzel & S. K. Agrawal,
/// *Kinematics, Dynamics, and Design of Machinery*, 3rd edition, Wiley 2016, section 14.6.)
#[test]
fn friction_circles_of_a_slider_crank() {
    let linkage = AnyLinkage::of(&ENGINE);
    let reactions = rubbed(engine(&linkage), &ENGINE_FRICTION);
    for (start, speed) in [(0.4, 90.0), (2.0, 90.0), (2.0, -90.0), (3.5, 90.0), (5.9, -90.0)] {
        let theta = Motion::at_constant_speed(start, speed);
        let pose = ENGINE.solve(theta, Assembly::Open).expect("it closes");
        let (phi, turn) = (pose.phi.value(), pose.phi.velocity());
        let found = at(&reactions, &[theta]);
        let of = |name: &str| found.of(name).expect("it is determined");
        // the rod is pushed: its force leans from its axis until it touches both circles
        let arms = (turn - speed).signum() * 0.1 * 0.02 + turn.signum() * 0.2 * 0.012;
        let lean = phi - (arms / 0.16).asin();
        let tangent = lean.tan();
        // N = -(900 ± μ |N|) tan, where the sign is that against the piston
        let sliding = pose.s.velocity().signum();
        let side = -900.0 * tangent / (1.0 + sliding * 0.12 * (-tangent).signum() * tangent);
        let slide = of("piston_slide");
        close(slide.y[0], side, 1e-11 * 900.0);
        close(slide.x[0], -sliding * 0.12 * side.abs(), 1e-11 * 900.0);
        let push = (900.0 + sliding * 0.12 * side.abs()) / lean.cos();
        for name in ["pin", "piston", "ground_arm"] {
            close(of(name).magnitude()[0], push, 1e-11 * push);
        }
        let [direction, ..] = of("pin").direction().expect("there is a force");
        close((direction - lean).sin(), 0.0, 1e-12);
        // of every pin, the line of the force passes at the radius of its circle
        for (name, friction) in &ENGINE_FRICTION[..3] {
            let Friction::Pin { coefficient, radius } = *friction else {
                panic!("{name}")
            };
            close(
                of(name).moment[0].abs(),
                coefficient * radius * of(name).magnitude()[0],
                1e-13 * push,
            );
        }
        // the crank: the force of the rod at its pin, and both moments
        let [pin, ground] = ["pin", "ground_arm"].map(of);
        let place = pose.pin.value();
        let of_rod = place.x * pin.y[0] - place.y * pin.x[0] + pin.moment[0];
        close(effort(&found)[0], of_rod - ground.moment[0], 1e-12 * push);
        assert!(found.contraction() < 0.1, "{}", found.contraction());
    }
}

crate::mechanism! {
    /// A load on an incline.
    struct Incline { angle: Angle }
    input s: Length;
    unknown x: Length;
    x == s * cos(angle);
    output block: Point = polar(s, angle);
    ground vec2(0, 0);
    body load: block;
    slide block along cis(angle);
}

/// A load holds itself on an incline up to the angle arctan μ.
#[test]
fn an_incline_locks_at_the_angle_of_friction() {
    let coefficient = 0.35_f64;
    for (beyond, locks) in [(-1e-9, true), (1e-9, false)] {
        let angle = coefficient.atan() + beyond;
        let linkage = AnyLinkage::of(&Incline { angle });
        let loads = linkage.loads().force(Plane::new(0.0, -70.0), "block").expect("a point");
        let reactions = linkage.reactions(&loads).expect("its bodies are declared");
        let reactions = rubbed(reactions, &[("block", slide(coefficient))]);
        let (sine, cosine) = angle.sin_cos();
        for sense in [1.0, -1.0] {
            let about_to_move = reactions.clone().about_to_move(&[sense]);
            let moving = at(&reactions, &[Motion::at_constant_speed(0.2, 3.0 * sense)]);
            let found = at(&about_to_move, &[Motion::at_constant_speed(0.2, 0.0)]);
            let expected = 70.0 * (sine + sense * coefficient * cosine);
            for found in [&moving, &found] {
                close(effort(found)[0], expected, 1e-13 * 70.0);
                let efficiency = found.efficiency().expect("it is determined");
                assert_eq!(efficiency.is_locked(), locks && sense < 0.0, "{efficiency:?}");
            }
            if sense > 0.0 {
                let ratio = moving.efficiency().and_then(|efficiency| efficiency.ratio());
                close(ratio.expect("it moves"), sine / (sine + coefficient * cosine), 1e-13);
            }
        }
    }
}

crate::mechanism! {
    /// A wedge on the floor lifts a block in a guide.
    struct Wedge { angle: Angle }
    input x: Length;
    unknown s: Length, h: Length;
    vec2(x, 0) + polar(s, angle) == vec2(0, h);
    output foot: Point = vec2(x, 0);
    output tip: Point = vec2(0, h);
    body wedge: foot;
    body block: tip;
    slide foot along vec2(1, 0);
    slide tip along vec2(0, 1);
    slide tip along cis(angle) on wedge;
}

/// With one angle of friction φ at all three faces of a wedge α, the force is W tan(α + 2φ). (J. L. Meriam & L. G.
/// Kraige,
/// *Engineering Mechanics: Statics*, 7th edition, Wiley 2012, section 6/4.)
#[test]
fn a_wedge_lifts_and_locks() {
    let (angle, weight) = (0.3_f64, 40.0);
    let linkage = AnyLinkage::of(&Wedge { angle });
    let loads = linkage.loads().force(Plane::new(0.0, -weight), "tip").expect("a point");
    let bare = linkage.reactions(&loads).expect("its bodies are declared");
    assert_eq!(bare.names().collect::<Vec<_>>(), ["foot", "tip", "tip_2"]);
    let at_rest = |coefficient: f64, sense: f64| {
        let all = ["foot", "tip", "tip_2"].map(|name| (name, slide(coefficient)));
        let reactions = rubbed(bare.clone(), &all).about_to_move(&[sense]);
        reactions.at(&[Motion::at_constant_speed(-0.5, 0.0)], PositionChoice::Assembly(0))
    };
    // beyond φ = α the block leans on the other wall of its guide
    let pulled_out = |friction: f64| {
        if friction < angle {
            -weight * (angle - 2.0 * friction).tan()
        } else {
            weight * (2.0 * friction - angle).sin() / angle.cos()
        }
    };
    for coefficient in [0.05_f64, 0.2, 0.4, 0.6] {
        let friction = coefficient.atan();
        // the wedge goes under the block to the left
        let lifted = at_rest(coefficient, -1.0).expect("it moves");
        close(
            effort(&lifted)[0],
            -weight * (angle + 2.0 * friction).tan(),
            1e-12 * weight / (angle + 2.0 * friction).cos(),
        );
        let lowered = at_rest(coefficient, 1.0).expect("it moves");
        close(effort(&lowered)[0], pulled_out(friction), 1e-13 * weight);
        let locks = lowered.efficiency().expect("it is determined").is_locked();
        assert_eq!(locks, 2.0 * friction > angle, "{coefficient}");
        // the sizes of all terms tell of the harder sense
        assert_eq!(
            lifted.contraction() < 1.0,
            angle + 2.0 * friction < 2.0 * FRAC_PI_4,
            "{coefficient}"
        );
    }
    // from α + 2φ = 90° on, no force lifts it
    let most = (FRAC_PI_4 - 0.5 * angle).tan();
    for coefficient in [1.01 * most, 3.0 * most] {
        let error = at_rest(coefficient, -1.0).expect_err("it locks");
        let ReactionError::Locked { share, reactions } = &error else {
            panic!("{error}")
        };
        close(share * coefficient, most, 1e-8);
        assert_eq!(reactions.len(), 3, "{reactions:?}");
        // and it can be pulled out all the same
        let lowered = at_rest(coefficient, 1.0).expect("it moves");
        assert!(lowered.contraction() > 1.0);
        close(effort(&lowered)[0], pulled_out(coefficient.atan()), 1e-12 * weight);
    }
}

crate::mechanism! {
    /// A table on a column, with its load beside it.
    struct Table { width: Length }
    input y: Length;
    unknown tip_y: Length;
    tip_y == y;
    output foot: Point = vec2(0, y);
    output edge: Point = vec2(width, tip_y);
    ground vec2(0, 0);
    body table: foot, edge;
    slide foot along vec2(0, 1);
}

/// A bushing of length L whose load hangs at the distance e holds it from 2 μ e = L on.
#[test]
fn a_bushing_locks() {
    let linkage = AnyLinkage::of(&Table { width: 0.3 });
    let loads = linkage.loads().force(Plane::new(0.0, -100.0), "edge").expect("a point");
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    for (length, locks) in [(0.2, false), (0.05, true)] {
        let down = [Motion::at_constant_speed(1.0, -2.0)];
        let found = at(&rubbed(reactions.clone(), &[("foot", bushing(0.2, length))]), &down);
        close(
            found.of("foot").expect("it is determined").friction[0],
            100.0 * 2.0 * 0.2 * 0.3 / length,
            1e-11,
        );
        close(effort(&found)[0], 100.0 * (1.0 - 2.0 * 0.2 * 0.3 / length), 1e-11);
        assert_eq!(found.efficiency().expect("it is determined").is_locked(), locks);
        // a slide without a length has no contact forces beside its normal force
        let found = at(&rubbed(reactions.clone(), &[("foot", slide(0.2))]), &down);
        close(effort(&found)[0], 100.0, 1e-12);
    }
}

/// Bodies cut free: the forces of joints and drives move each body as its mass and inertia want, and friction is what
/// the law says.
#[test]
fn bodies_cut_free() {
    let mut random = Random::new(5);
    for _ in 0..20 {
        let linkage = AnyLinkage::of(&FOUR_BAR);
        let gravity = Plane::new(random.between(-3.0, 3.0), -9.81);
        let masses = [0.7, 1.4, 1.1].map(|mass| mass * random.between(0.5, 2.0));
        let inertias = [0.01, 0.05, 0.03];
        let bodies = ["crank", "coupler", "rocker"];
        let mut loads = linkage.loads().gravity(gravity);
        for ((body, mass), inertia) in bodies.iter().zip(masses).zip(inertias) {
            loads = loads
                .mass_of(body, mass, [body, "_centre"].concat().as_str(), inertia)
                .expect("a body");
        }
        let names = ["base", "pin", "knee", "pivot"];
        let coefficients: [f64; 4] = core::array::from_fn(|_| random.between(0.0, 0.8));
        let all: Vec<_> = names
            .iter()
            .zip(coefficients)
            .map(|(name, own)| (*name, pin(own, 0.03)))
            .collect();
        let reactions = rubbed(linkage.reactions(&loads).expect("its bodies are declared"), &all);
        let crank = Motion::from((
            random.between(0.0, TAU),
            random.between(-9.0, 9.0),
            random.between(-30.0, 30.0),
            0.0,
            0.0,
        ));
        let pose = FOUR_BAR.solve(crank, Assembly::Open).expect("it closes");
        let found = at(&reactions, &[crank]);
        let angles = [pose.theta2, pose.theta3, pose.theta4];
        let centres = [pose.crank_centre, pose.coupler_centre, pose.rocker_centre];
        let places = [pose.base, pose.pin, pose.knee, pose.pivot];
        let turn = |name: &str| {
            bodies
                .iter()
                .position(|body| *body == name)
                .map_or(0.0, |body| angles[body].velocity())
        };
        for (body, name) in bodies.iter().enumerate() {
            let (centre, acceleration) = (centres[body].value(), centres[body].acceleration());
            let mut left = (gravity - acceleration).scale(masses[body]);
            let mut moment = -inertias[body] * angles[body].acceleration();
            if body == 0 {
                moment += effort(&found)[0];
            }
            let mut size = 1.0;
            for ((joint, place), coefficient) in names.iter().zip(&places).zip(coefficients) {
                let force = found.of(joint).expect("it is determined");
                let pair = reactions.bodies_of(joint).expect("a joint");
                let law = coefficient * 0.03 * force.magnitude()[0];
                close(
                    force.moment[0],
                    -law * (turn(&pair[0]) - turn(&pair[1])).signum(),
                    1e-12 * (1.0 + law),
                );
                let Some(side) = pair.iter().position(|own| own == name) else {
                    continue;
                };
                let sign = [1.0, -1.0][side];
                let own = Plane::new(force.x[0], force.y[0]).scale(sign);
                left = left + own;
                moment += (place.value() - centre).cross(own) + sign * force.moment[0];
                size += force.magnitude()[0];
            }
            for rest in [left.x, left.y, moment] {
                close(rest, 0.0, 1e-12 * size);
            }
        }
    }
}

/// What drives give beyond virtual work without friction is heat, with its rates.
fn balances(linkage: &AnyLinkage<'_>, loads: &NamedLoads, frictions: &[(&str, Friction)], range: [f64; 2]) {
    let bare = linkage.reactions_as_guessed(loads).expect("bodies of the plane");
    let reactions = rubbed(bare, frictions);
    let law = Rise::new(Shape::Polynomial56789, range[0], range[1], 0.7).expect("a law");
    let laws: [&dyn Piecewise<f64>; 1] = [&law];
    let sweep = linkage
        .sweep(AssemblyChoice::Index(0))
        .under_laws(&laws, 0.03..=0.67, 9);
    let column = |order: usize| sweep.of_effort(loads, 0, order).column().expect("it closes");
    let free = [0, 1, 2].map(column);
    let with = [0, 1, 2].map(|order| {
        sweep
            .of_effort_with_friction(&reactions, 0, order)
            .column()
            .expect("it is determined")
    });
    let heat = [0, 1, 2].map(|order| sweep.of_heat(&reactions, order).column().expect("it is determined"));
    for row in 0..9 {
        let [.., motion] = [sweep.inputs(sweep.at(row), crate::law::Side::Right)[0].clone()];
        let [free, with, heat] = [&free, &with, &heat].map(|all| [all[0][row], all[1][row], all[2][row]]);
        let taken: [f64; 3] = core::array::from_fn(|order| with[order] - free[order]);
        let powers = [
            taken[0] * motion[1],
            taken[1] * motion[1] + taken[0] * motion[2],
            taken[2] * motion[1] + 2.0 * taken[1] * motion[2] + taken[0] * motion[3],
        ];
        assert!(heat[0] > 0.0, "{heat:?}");
        for order in 0..3 {
            // the efforts are compared with those of another method, which agree to 1e-10 of the largest
            let size: f64 = (0..=order)
                .map(|low| (with[low].abs() + free[low].abs()) * motion[1 + order - low].abs())
                .sum();
            close(powers[order], heat[order], 1e-10 * size);
            if order == 0 {
                close(powers[0], heat[0], 4e3 * f64::EPSILON * size);
            }
        }
    }
}

const LIFT_FRICTION: [(&str, Friction); 7] = [
    ("ground_lever", pin(0.2, 0.01)),
    ("ground_arm", pin(0.3, 0.01)),
    ("pin", pin(0.1, 0.02)),
    ("foot_slide", bushing(0.15, 0.12)),
    ("edge", pin(0.2, 0.01)),
    ("elbow", pin(0.4, 0.01)),
    ("foot", pin(0.2, 0.015)),
];

#[test]
fn power_is_balanced() {
    let mut random = Random::new(8);
    for _ in 0..samples::of(20) {
        let [r1, r2, r3, r4] =
            [(0.8, 1.0), (0.2, 0.3), (0.7, 0.9), (0.65, 0.7)].map(|(low, high)| random.between(low, high));
        let mechanism = FourBar { r1, r2, r3, r4 };
        let linkage = AnyLinkage::of(&mechanism);
        let all = ["base", "pin", "knee", "pivot"]
            .map(|name| (name, pin(random.between(0.05, 0.6), random.between(0.005, 0.03))));
        let start = random.between(0.0, TAU);
        balances(
            &linkage,
            &heavy(&linkage),
            &all,
            [start, start + random.between(-2.0, 2.0)],
        );
    }
    for _ in 0..samples::of(10) {
        let linkage = AnyLinkage::of(&ENGINE);
        let loads = heavy(&linkage)
            .force(Plane::new(random.between(-900.0, 900.0), 0.0), "piston")
            .expect("a point");
        let start = random.between(0.0, TAU);
        balances(&linkage, &loads, &ENGINE_FRICTION, [start, start + 1.0]);
    }
    let linkage = AnyLinkage::of(&LIFT);
    balances(&linkage, &heavy(&linkage), &LIFT_FRICTION, [0.4, 1.3]);
    let inverted: library::InvertedSliderCrank = library::InvertedSliderCrank { r1: 0.5, r2: 0.2 };
    let quick: library::WhitworthQuickReturn = library::WhitworthQuickReturn {
        ground: 0.05,
        crank: 0.1,
        arm: 0.15,
        rod: 0.5,
    };
    let yoke: library::ScotchYoke = library::ScotchYoke { crank: 0.2, gamma: 1.4 };
    for linkage in [AnyLinkage::of(&inverted), AnyLinkage::of(&quick), AnyLinkage::of(&yoke)] {
        let loads = heavy(&linkage);
        let bare = linkage.reactions_as_guessed(&loads).expect("bodies of the plane");
        let all = bare.names().map(|name| match bare.is_slide(name) {
            Ok(true) => (name, bushing(0.1, 0.1)),
            _ => (name, pin(0.2, 0.01)),
        });
        // of those that move
        let moves = |(name, friction): &(&str, Friction)| {
            let own = rubbed(bare.clone(), &[(*name, *friction)]);
            let found = own.at(&[Motion::at_constant_speed(0.7, 1.0)], PositionChoice::Assembly(0));
            !matches!(found, Err(ReactionError::NoSense { .. }))
        };
        let all: Vec<_> = all.filter(moves).collect();
        assert!(all.len() > 2, "{all:?}");
        balances(&linkage, &loads, &all, [0.4, 1.1]);
    }
}

/// The rates of forces with friction are their differences along the motion.
#[test]
fn rates_are_differences() {
    const STEP: f64 = 1e-5;
    let linkage = AnyLinkage::of(&LIFT);
    let reactions = rubbed(
        linkage.reactions(&heavy(&linkage)).expect("its bodies are declared"),
        &LIFT_FRICTION,
    );
    let crank = |time: f64| Motion::from((0.5 + 1.2 * time + 0.4 * time * time, 1.2 + 0.8 * time, 0.8, 0.0, 0.0));
    for time in [0.0, 0.2, 0.4] {
        let [before, own, behind] = [time - STEP, time, time + STEP].map(|time| at(&reactions, &[crank(time)]));
        for name in reactions.names() {
            let [before, own, behind] = [&before, &own, &behind].map(|found| found.of(name).expect("it is determined"));
            for (before, own, behind) in [
                (before.x, own.x, behind.x),
                (before.y, own.y, behind.y),
                (before.moment, own.moment, behind.moment),
                (before.friction, own.friction, behind.friction),
            ] {
                for order in 0..2 {
                    let difference = (behind[order] - before[order]) / (2.0 * STEP);
                    let size = own[order].abs() + own[order + 1].abs() + difference.abs();
                    close(own[order + 1], difference, 1e-7 * size + 1e-9);
                }
            }
        }
    }
}

/// Where a motion turns back, friction jumps: each side has its own value.
#[test]
fn a_motion_that_turns_back() {
    let linkage = AnyLinkage::of(&ENGINE);
    let reactions = rubbed(
        engine(&linkage),
        &[("piston_slide", slide(0.2)), ("piston", pin(0.3, 0.02))],
    );
    let friction = |theta: f64| {
        let found = at(&reactions, &[Motion::at_constant_speed(theta, 10.0)]);
        found.of("piston_slide").expect("it is determined").friction[0]
    };
    let [before, own, behind] = [-1e-9, 0.0, 1e-9].map(friction);
    close(own, behind, 1e-5);
    assert!(before < -1.0 && behind > 1.0, "{before} {behind}");
    // at the end of a sweep, the side from which it comes counts
    let sweep = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[-1.0], &[0.0], 3)
        .speed(10.0);
    let column = sweep
        .of_reaction(&reactions, "piston_slide", ReactionPart::X, 0)
        .column()
        .expect("it closes");
    close(column[2], before, 1e-5);
    // and inside of one, the jump is found as it is
    let sweep = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[-1.0], &[1.0], 4)
        .speed(10.0);
    let across = sweep.of_reaction(&reactions, "piston_slide", ReactionPart::X, 0);
    let crossings = across.crossings(0.0).expect("it closes");
    assert!(crossings.len() == 1 && crossings[0].at.abs() < 1e-11, "{crossings:?}");
}

/// Where a law begins and ends, the motion beside it gives friction its sense, in a dead centre too.
#[test]
fn laws_begin_and_end() {
    let linkage = AnyLinkage::of(&ENGINE);
    let loads = linkage
        .loads()
        .force(Plane::new(-900.0, 2000.0), "piston")
        .expect("a point");
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    let reactions = rubbed(
        reactions,
        &[("piston_slide", slide(0.2)), ("ground_arm", pin(0.3, 0.02))],
    );
    for shape in [Shape::Cycloidal, Shape::Polynomial56789, Shape::SimpleHarmonic] {
        for [from, to] in [[0.0, 1.0], [1.0, 0.0], [0.4, 1.0], [1.0, 3.0]] {
            let law = Rise::new(shape, from, to, 0.1).expect("a law");
            let laws: [&dyn Piecewise<f64>; 1] = [&law];
            let sweep = linkage.sweep(AssemblyChoice::Index(0)).under_laws(&laws, 0.0..=0.1, 5);
            let along = |name: &str, part| {
                sweep
                    .of_reaction(&reactions, name, part, 0)
                    .column()
                    .expect("it closes")
            };
            let [slide, pin] = [("piston_slide", ReactionPart::X), ("ground_arm", ReactionPart::Moment)]
                .map(|(name, part)| along(name, part));
            // the piston goes in as the crank goes forwards, up to half a turn
            let forwards = if to > from { 1.0 } else { -1.0 };
            for (slide, pin) in slide.iter().zip(&pin) {
                assert!(
                    slide * forwards > 0.1 && pin * forwards < -0.1,
                    "{shape:?} {from} {to}: {slide} {pin}"
                );
            }
        }
    }
}

/// Over a cycle, a constant force does no work, and all that the drive gives is heat. From a dead centre on, the first
/// pieces of the curve end where the piston turns back, shortly behind a kink.
#[test]
fn a_cycle_heats() {
    let linkage = AnyLinkage::of(&ENGINE);
    let loads = linkage.loads().force(Plane::new(-900.0, 0.0), "piston");
    let loads = loads.and_then(|loads| loads.mass_of("conrod", 0.6, Plane::new(0.06, 0.0), 0.002));
    let reactions = linkage.reactions(&loads.expect("a point and a body"));
    let reactions = rubbed(reactions.expect("its bodies are declared"), &ENGINE_FRICTION);
    let turn = |start: f64| {
        let sweep = linkage
            .sweep(AssemblyChoice::Index(0))
            .between(&[start], &[start + TAU], 25);
        sweep.speed(90.0)
    };
    let [mean, other] = [0.0, 0.3].map(|start| turn(start).efficiency(&reactions).expect("it closes"));
    assert!(mean.heat > 100.0, "{mean:?}");
    close(mean.input, mean.heat, 1e-11 * mean.heat);
    close(other.input, other.heat, 1e-11 * mean.heat);
    close(other.heat, mean.heat, 1e-11 * mean.heat);
    assert!(!mean.is_locked());
    let turn = turn(0.0);
    let side = turn.of_reaction(&reactions, "piston_slide", ReactionPart::X, 0);
    let kinks = side.extremes().expect("it closes").into_iter();
    let kinks: Vec<f64> = kinks
        .filter(|one| one.kind == ExtremeKind::Kink)
        .map(|one| one.at)
        .collect();
    assert!(kinks.iter().any(|at| (at - PI).abs() < 1e-12), "{kinks:?}");
    // a sum over many rows, whose error at the kinks is their distance squared
    let rows = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.3], &[0.3 + TAU], 2001)
        .speed(90.0);
    let column = rows.of_heat(&reactions, 0).column().expect("it closes");
    let sum: f64 = column[..2000].iter().sum();
    close(sum / 2000.0, mean.heat, 1e-5 * mean.heat);
    let rms = turn
        .of_effort_with_friction(&reactions, 0, 0)
        .rms(Over::Time)
        .expect("it jumps, and has a mean");
    assert!(rms.error < 1e-11 * rms.value);
}

/// Every bit of what friction does not touch stays.
#[test]
fn no_coefficient_is_no_friction() {
    let linkage = AnyLinkage::of(&LIFT);
    let bare = linkage.reactions(&heavy(&linkage)).expect("its bodies are declared");
    let none = LIFT_FRICTION.iter().map(|(name, friction)| match *friction {
        Friction::Pin { radius, .. } => (*name, pin(0.0, radius)),
        Friction::Slide { length, .. } => (
            *name,
            Friction::Slide {
                coefficient: 0.0,
                length,
            },
        ),
    });
    let none = rubbed(bare.clone(), &none.collect::<Vec<_>>());
    let crank = [Motion::from((0.8, 0.0, 0.0, 3.0, 0.0))];
    let [one, other] = [at(&bare, &crank), at(&none, &crank)];
    assert_eq!(effort(&one), effort(&other));
    for ((_, one), (_, other)) in one.all().zip(other.all()) {
        assert_eq!(one, other);
    }
}

crate::mechanism! {
    /// A cart that is pinned to what slides, and does not turn on it.
    struct Cart { angle: Angle, width: Length }
    input s: Length;
    unknown x: Length;
    x == s * cos(angle);
    output block: Point = polar(s, angle);
    ground vec2(0, 0);
    body load: block;
    body cart: block, vec2((s + width) * cos(angle), (s + width) * sin(angle));
    slide block along cis(angle);
}

#[test]
fn mistakes_and_senses() {
    let linkage = AnyLinkage::of(&ENGINE);
    let reactions = engine(&linkage);
    let message = |name: &str, friction: Friction| {
        let twice = rubbed(reactions.clone(), &[("pin", pin(0.1, 0.01))]);
        twice.friction(name, friction).expect_err("a mistake").to_string()
    };
    for (name, friction, expected) in [
        (
            "pn",
            pin(0.1, 0.01),
            "there is no reaction `pn`; there is `ground_arm`, `pin`, `piston`, `piston_slide`",
        ),
        (
            "pin",
            pin(0.1, 0.01),
            "the friction of `pin`: it has friction already: state it once",
        ),
        (
            "piston",
            pin(-0.1, 0.01),
            "the friction of `piston`: the coefficient is -0.1: give one from zero on",
        ),
        (
            "piston",
            pin(f64::NAN, 0.01),
            "the friction of `piston`: the coefficient is NaN: give one from zero on",
        ),
        (
            "piston",
            pin(0.1, 0.0),
            "the friction of `piston`: the radius is 0: give one above zero",
        ),
        (
            "piston",
            slide(0.1),
            "the friction of `piston`: it is a pin, whose friction needs its radius: give the friction of a pin",
        ),
        (
            "piston_slide",
            pin(0.1, 0.01),
            "the friction of `piston_slide`: it is a slide, which has no radius: give the friction of a slide",
        ),
        (
            "piston_slide",
            bushing(0.1, -1.0),
            "the friction of `piston_slide`: the length is -1: give one above zero",
        ),
    ] {
        assert_eq!(message(name, friction), expected);
    }
    let rest = [Motion::at_constant_speed(0.4, 0.0)];
    let rubbed_pin = rubbed(reactions, &[("pin", pin(0.1, 0.01))]);
    let error = rubbed_pin.at(&rest, PositionChoice::Assembly(0)).expect_err("it rests");
    assert_eq!(error, ReactionError::AtRest);
    let error = rubbed_pin
        .about_to_move(&[0.0])
        .at(&rest, PositionChoice::Assembly(0))
        .expect_err("nothing is about to move");
    assert!(
        matches!(&error, ReactionError::NoSense { reaction } if reaction == "pin"),
        "{error}"
    );
    let linkage = AnyLinkage::of(&Cart { angle: 0.4, width: 0.2 });
    let reactions = linkage.reactions(&linkage.loads()).expect("its bodies are declared");
    let rubbed = rubbed(reactions, &[("block", pin(0.1, 0.01))]);
    let error = rubbed.at(&[Motion::at_constant_speed(0.4, 1.0)], PositionChoice::Assembly(0));
    assert_eq!(
        error.expect_err("it does not turn").to_string(),
        "the bodies of `block` do not move against each other, so that its friction has no sense: leave it out"
    );
}
