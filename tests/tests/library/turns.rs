//! Mechanisms that turn fully, and those that are driven back.

use core::f64::consts::{PI, TAU};

use kin_core::library::*;
use kin_core::prelude::*;
use kin_core::{Dimension, TrackError, track};
use kin_tests::compare::turned_back;
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};
use kin_tests::oracles::{ALLOWED, Gauge};
use kin_tests::random::Random;

use super::cranks;

/// How often a linkage, driven at another link by the motion that the crank gives to that link, gives the crank's
/// motion back, in well-conditioned poses.
#[derive(Default)]
struct DrivenBack(usize);

impl DrivenBack {
    /// `own` is the gauge of the pose that the drive is from: the drive is known to its condition squared, and what the
    /// drive is wrong by, the driven linkage makes larger in its own units.
    fn check<M: ThroughSnap>(&mut self, own: &Gauge, driven: &M, drive: Motion, expected: &[Motion]) {
        let inputs = M::Inputs::from_fn(|_| drive);
        let exact = M::Unknowns::from_fn(|index| expected[index]);
        let gauge = Gauge::new(driven, &inputs, &exact);
        if gauge.condition > 100.0 {
            return;
        }
        let name = M::DESCRIPTION.name;
        let near = M::Unknowns::from_fn(|index| expected[index].value() + 1e-3);
        let found = match driven.solve_near(inputs, near) {
            Ok(pose) => pose.unknown_motions(),
            Err(error) => panic!("{name}: {error}"),
        };
        for (index, (found, expected)) in found.as_ref().iter().zip(expected).enumerate() {
            for (order, allowed) in ALLOWED.into_iter().enumerate() {
                let difference = found.derivatives()[order] - expected.derivatives()[order];
                let difference = if order == 0 {
                    turned_back(difference)
                } else {
                    difference
                };
                let unit = gauge.unknown(index, order) * (1.0 + own.condition * own.condition);
                let unknown = M::DESCRIPTION.unknowns[index].name;
                assert!(
                    difference.abs() <= allowed * unit,
                    "{unknown} of {name}, order {order}: {difference} beside {unit}"
                );
            }
        }
        self.0 += 1;
    }
}

/// Tracks the first input through a full turn from the middle of its range, from every position there is.
#[derive(Default)]
struct FullTurn {
    turned: Vec<&'static str>,
    limited: Vec<&'static str>,
    crossed: Vec<&'static str>,
    wrong: Vec<String>,
}

impl FullTurn {
    fn go<M: ThroughSnap>(&mut self, mechanism: &M, from: M::Inputs<f64>, start: M::Unknowns<f64>) {
        let name = M::DESCRIPTION.name;
        let mut to = from;
        to[0] += TAU;
        let assembly = mechanism.assembly_at(from, start);
        match track(mechanism, from, start, to) {
            Ok(end) => {
                self.turned.push(name);
                // the way back ends where it began, for coupled blocks too, whose assemblies may change places in a
                // turn
                match track(mechanism, to, end, from) {
                    Ok(back) => self.compare::<M>("on the way back", start, back),
                    Err(error) => self.wrong.push(format!("{name}: back {error}")),
                }
                if M::ASSEMBLY_COUNT > 0 {
                    if mechanism.assembly_at(to, end) != assembly {
                        self.wrong.push(format!("{name}: {assembly:?} is left"));
                    }
                    self.compare::<M>("after a turn", start, end);
                }
            }
            Err(TrackError::TurningPoint(limit)) => {
                self.limited.push(name);
                let (low, high) = (from[0], to[0]);
                if !(low..=high).contains(&limit.inputs[0]) {
                    self.wrong.push(format!("{name}: {limit:?}"));
                }
            }
            Err(TrackError::ChangePoint(_)) => self.crossed.push(name),
            Err(error) => self.wrong.push(format!("{name}, {assembly:?}: {error}")),
        }
    }

    /// Compares two positions at inputs that are a full turn apart or equal.
    fn compare<M: ThroughSnap>(&mut self, place: &str, start: M::Unknowns<f64>, end: M::Unknowns<f64>) {
        let pairs = start.as_ref().iter().zip(end.as_ref()).zip(M::DESCRIPTION.unknowns);
        for ((start, end), quantity) in pairs {
            let is_angle = quantity.dimension == Dimension::Angle;
            let difference = if is_angle {
                turned_back(end - start)
            } else {
                end - start
            };
            if difference.abs() > 1e-9 * (1.0 + start.abs()) {
                let name = M::DESCRIPTION.name;
                self.wrong
                    .push(format!("{name}, {place}: {} is off by {difference}", quantity.name));
            }
        }
    }
}

impl Visitor for FullTurn {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        // a length does not turn
        if const { !matches!(M::DESCRIPTION.inputs[0].dimension, Dimension::Angle) } {
            return;
        }
        let mechanism: M = case.mechanism();
        let at = |fraction: f64| {
            M::Inputs::from_fn(|index| {
                let (low, high) = case.inputs[index];
                low + fraction * (high - low)
            })
        };
        let from = at(0.6);
        if M::ASSEMBLY_COUNT > 0 {
            for assembly in M::assemblies() {
                if let Ok(start) = mechanism.position(from, assembly) {
                    self.go(&mechanism, from, start);
                }
            }
            return;
        }
        let mut random = Random::new(54);
        for step in 0..40 {
            let from = at(f64::from(step % 8) / 8.0);
            let guess = M::Unknowns::from_fn(|_| random.between(-PI, PI));
            if let Ok(start) = mechanism.position_near(from, guess) {
                self.go(&mechanism, from, start);
            }
        }
    }
}

/// Every mechanism whose crank turns fully keeps its assembly for the whole turn, with the input at every degree.
#[test]
fn full_turns() {
    fn turn<M: ThroughSnap>(mechanism: M, assembly: M::Assembly) {
        let mut last: Option<Vec<f64>> = None;
        for degrees in 0..=360 {
            let crank = f64::from(degrees).to_radians();
            let inputs = M::Inputs::from_fn(|_| Motion::at_constant_speed(crank, 1.0));
            let pose = mechanism.solve(inputs, assembly).expect("it turns");
            let unknowns: Vec<f64> = pose.unknown_motions().as_ref().iter().map(Motion::value).collect();
            assert_eq!(
                mechanism.assembly_at(M::Inputs::from_fn(|_| crank), M::Unknowns::from_fn(|i| unknowns[i])),
                assembly,
                "{} at {degrees}°",
                M::DESCRIPTION.name
            );
            // no jump: a degree changes no angle and no length by more than its own rate allows
            if let Some(last) = last {
                for ((own, before), motion) in unknowns.iter().zip(last).zip(pose.unknown_motions().as_ref()) {
                    let step = 1_f64.to_radians();
                    let allowed = step * (motion.velocity().abs() + step * motion.acceleration().abs() + 0.1);
                    let change = turned_back(own - before);
                    assert!(change.abs() <= allowed, "{} at {degrees}°", M::DESCRIPTION.name);
                }
            }
            last = Some(unknowns);
        }
    }
    turn(HoekenLinkage::PUBLISHED, Assembly::Open);
    turn(KlannLeg::PATENT, KlannLeg::WALKING);
    turn(JansenLeg::HOLY_NUMBERS, JansenLeg::WALKING);
    turn(AndrewsSqueezer::PUBLISHED, AndrewsSqueezer::PUBLISHED_ASSEMBLY);
    turn(ScotchYoke { crank: 1.0, gamma: 1.0 }, ());
    for assembly in WattII::ASSEMBLIES {
        let linkage = WattII {
            r1: 4.0,
            r2: 1.0,
            r3: 3.0,
            r4: 2.5,
            arm: Plane::new(1.5, 0.8),
            pivot: Plane::new(7.0, 0.5),
            r5: 3.0,
            r6: 2.5,
        };
        turn(linkage, assembly);
    }
}

/// Watt's and Stephenson's linkages, driven at the crank, then at a link for which nothing closes by itself.
#[test]
fn six_bars_are_driven_back() {
    let dimensions = [4.0, 1.0, 3.0, 2.5];
    let mut counts = [(); 4].map(|()| DrivenBack::default());
    let [watt1, watt2, stephenson1, stephenson3] = &mut counts;
    for crank in cranks(-PI, PI, 50) {
        let first = [&dimensions[..], &[1.5, 0.8, 2.0, 1.5, 2.5, 2.0]].concat();
        let by_crank = WattI::from_parameters(core::array::from_fn(|index| first[index]));
        let driven = WattIByDyad::from_parameters(by_crank.parameters());
        for pose in WattI::ASSEMBLIES
            .into_iter()
            .filter_map(|a| by_crank.solve(crank, a).ok())
        {
            let own = Gauge::new(&by_crank, &[crank], &pose.unknown_motions());
            watt1.check(
                &own,
                &driven,
                pose.theta5,
                &[crank, pose.theta3, pose.theta4, pose.theta6],
            );
        }

        let second = [&dimensions[..], &[2.0, 1.0, 7.0, 0.5, 3.0, 2.5]].concat();
        let by_crank = WattII::from_parameters(core::array::from_fn(|index| second[index]));
        let driven = WattIIByCouplers::from_parameters(by_crank.parameters());
        for pose in WattII::ASSEMBLIES
            .into_iter()
            .filter_map(|a| by_crank.solve(crank, a).ok())
        {
            let own = Gauge::new(&by_crank, &[crank], &pose.unknown_motions());
            let drive = pose.theta5 - pose.theta3;
            watt2.check(&own, &driven, drive, &[crank, pose.theta3, pose.theta4, pose.theta6]);
        }

        let first = [&dimensions[..], &[0.5, 1.0, 1.5, 1.0, 2.5, 2.0]].concat();
        let by_crank = StephensonI::from_parameters(core::array::from_fn(|index| first[index]));
        let driven = StephensonIByDyad::from_parameters(by_crank.parameters());
        for pose in StephensonI::ASSEMBLIES
            .into_iter()
            .filter_map(|a| by_crank.solve(crank, a).ok())
        {
            let own = Gauge::new(&by_crank, &[crank], &pose.unknown_motions());
            stephenson1.check(
                &own,
                &driven,
                pose.theta5,
                &[crank, pose.theta3, pose.theta4, pose.theta6],
            );
        }

        let third = [&dimensions[..], &[1.5, 1.0, 3.0, 5.0, 3.0, 2.5]].concat();
        let by_crank = StephensonIII::from_parameters(core::array::from_fn(|index| third[index]));
        let driven = StephensonIIIByDyad::from_parameters(by_crank.parameters());
        for pose in StephensonIII::ASSEMBLIES
            .into_iter()
            .filter_map(|a| by_crank.solve(crank, a).ok())
        {
            let own = Gauge::new(&by_crank, &[crank], &pose.unknown_motions());
            stephenson3.check(
                &own,
                &driven,
                pose.theta6,
                &[crank, pose.theta3, pose.theta4, pose.theta5],
            );
        }
    }
    for (count, name) in counts
        .iter()
        .zip(["Watt I", "Watt II", "Stephenson I", "Stephenson III"])
    {
        println!("{name}: {} poses", count.0);
        assert!(count.0 > 100, "{name}: {}", count.0);
    }
}

/// Stephenson's linkage of the second kind, driven at the elbow in relative angles, then at the crank in absolute ones.
#[test]
fn stephenson_second_kind_is_driven_back() {
    let by_elbow = StephensonIIByElbow::from_parameters([4.0, 2.0, 1.5, 1.2, 3.0, 0.3, 1.0, 0.5, 1.6, 3.0]);
    let driven = StephensonII::from_parameters(by_elbow.parameters());
    let mut count = DrivenBack::default();
    for elbow in cranks(-PI, PI, 51) {
        for assembly in StephensonIIByElbow::ASSEMBLIES {
            let Ok(pose) = by_elbow.solve(elbow, assembly) else {
                continue;
            };
            let own = Gauge::new(&by_elbow, &[elbow], &pose.unknown_motions());
            let [link3, link4, link5] = [elbow, pose.alpha, pose.beta].map(|relative| pose.theta2 + relative);
            count.check(&own, &driven, pose.theta2, &[link3, link4, link5, pose.theta6]);
        }
    }
    assert!(count.0 > 50, "{}", count.0);
}

/// A crank is tracked through a full turn without leaving its assembly, or to a limit position on the way.
#[test]
fn every_input_is_tracked_through_a_turn() {
    let mut turn = FullTurn::default();
    cases::library(&mut turn);
    cases::coupled_library(&mut turn);
    println!(
        "turned: {:?}\n\nlimited: {:?}\n\nchange points: {:?}",
        turn.turned, turn.limited, turn.crossed
    );
    assert!(turn.wrong.is_empty(), "{:#?}", turn.wrong);
    for name in [
        "HoekenLinkage",
        "KlannLeg",
        "JansenLeg",
        "WhitworthQuickReturn",
        "AndrewsSqueezer",
        "Rssr",
    ] {
        assert!(turn.turned.contains(&name), "{name}");
    }
}

/// With a short crank Stephenson's linkage of the second kind turns fully, its class III triad solved by Newton's
/// method all the way round.
#[test]
fn a_coupled_six_bar_turns_fully() {
    let linkage = StephensonII {
        r1: 4.0,
        r2: 0.5,
        r3: 3.0,
        r4: 1.5,
        p: Plane::new(0.3, 0.4),
        q: Plane::new(0.8, 0.6),
        r5: 2.6,
        r6: 2.5,
    };
    let all = linkage.assemblies_at(0.3).expect("finite");
    assert!(all.is_complete() && !all.is_empty(), "{all:?}");
    for &Near(start) in &all {
        let mut near = start;
        let end = track(&linkage, [0.3], start, [0.3 + TAU]).expect("no limit is on the way");
        // the same position again, and small steps lead there as well
        for step in 1..=360 {
            let crank = 0.3 + f64::from(step).to_radians();
            near = linkage.position_near(crank, near).expect("it turns").unknowns();
        }
        for index in 0..4 {
            assert!((near[index] - end[index]).abs() < 1e-11, "{near:?} {end:?}");
            assert!(
                turned_back(end[index] - start[index]).abs() < 1e-11,
                "{end:?} {start:?}"
            );
        }
    }
}
