//! Cycles against textbook cases and dense scans.

use core::f64::consts::PI;
use std::string::String;
use std::vec;
use std::vec::Vec;
use std::{format, println};

use super::{BarkerClass, Branch, Cycle, EndKind, FullCycle, GrashofType, MeasureError};
use crate::assembly::Assembly;
use crate::curve::LimitKind;
use crate::extremes::ExtremesError;
use crate::failure::{Failure, SolveError};
use crate::geometry::Plane;
use crate::library::*;
use crate::mechanism::Mechanism;
use crate::number::samples;
use crate::quantity::Dimension;
use crate::sweep::Swept as _;

const SAMPLE: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};

fn four_bar(r1: f64, r2: f64, r3: f64, r4: f64) -> Cycle<FourBar> {
    FourBar { r1, r2, r3, r4 }.cycle().unwrap()
}

/// At inputs all over the range, as many positions exist as branches, and each lies near its branch.
fn disagreements<M: Mechanism<Scalar = f64>>(name: &str, cycle: &Cycle<M>, count: u32) -> Vec<String> {
    let (low, high) = match cycle.period() {
        Some(period) => (-0.5 * period, 0.5 * period),
        None => (cycle.searched.line.low, cycle.searched.line.high),
    };
    let mut wrong = Vec::new();
    let count = samples::of(count);
    for index in 0..count {
        let input = low + (high - low) * (f64::from(index) + 0.317) / f64::from(count);
        let mut found = Vec::new();
        let search = cycle
            .mechanism()
            .positions_at(cycle.inputs(input), |_, unknowns| found.push(unknowns));
        assert!(search.is_ok());
        let branches: Vec<usize> = cycle.at(input).map(|(index, _)| index).collect();
        if found.len() != branches.len() {
            wrong.push(format!(
                "{name}: {} positions and branches {branches:?} at {input}",
                found.len()
            ));
        }
    }
    wrong
}

#[test]
fn the_sample_linkage_swings() {
    let cycle = SAMPLE.cycle().unwrap();
    assert!(cycle.is_complete());
    assert_eq!((cycle.circuits().len(), cycle.branches().len()), (1, 2));
    let expected = SAMPLE.crank_range().unwrap().high;
    for branch in cycle.branches() {
        let [low, high] = branch.ends();
        assert_eq!([low.kind, high.kind], [EndKind::Limit(LimitKind::TurningPoint); 2]);
        assert!((high.input - expected).abs() < 4e-15 && (low.input + expected).abs() < 4e-15);
        // coupler and rocker are in line
        let [theta3, theta4] = high.unknowns[..] else { panic!() };
        assert!((theta3 - theta4 + PI).sin().abs() < 1e-13, "{theta3} {theta4}");
    }
    let circuit = &cycle.circuits()[0];
    // No link makes full revolutions.
    assert_eq!(
        (circuit.input_revolutions(), circuit.revolutions()),
        (Some(0), Some(&[0, 0][..]))
    );
    assert_eq!(disagreements("sample", &cycle, 500), Vec::<String>::new());
}

#[test]
fn every_type_of_four_bar() {
    // crank-rocker: two circuits, each with one branch over a full revolution
    let cycle = four_bar(90.0, 30.0, 70.0, 60.0);
    assert!(cycle.is_complete());
    assert_eq!((cycle.circuits().len(), cycle.branches().len()), (2, 2));
    for circuit in cycle.circuits() {
        assert_eq!(
            (circuit.input_revolutions(), circuit.revolutions()),
            (Some(1), Some(&[0, 0][..]))
        );
    }
    // double-crank
    let cycle = four_bar(30.0, 70.0, 60.0, 90.0);
    assert_eq!((cycle.circuits().len(), cycle.branches().len()), (2, 2));
    for circuit in cycle.circuits() {
        assert_eq!(
            (circuit.input_revolutions(), circuit.revolutions()),
            (Some(1), Some(&[1, 1][..]))
        );
    }
    // double-rocker, the coupler makes full revolutions: two circuits of two branches
    let cycle = four_bar(90.0, 60.0, 30.0, 70.0);
    assert_eq!((cycle.circuits().len(), cycle.branches().len()), (2, 4));
    for circuit in cycle.circuits() {
        assert_eq!(circuit.input_revolutions(), Some(0));
        assert_eq!(
            circuit
                .revolutions()
                .map(|revolutions| (revolutions[0].abs(), revolutions[1])),
            Some((1, 0))
        );
    }
    // change point: a parallelogram
    let cycle = four_bar(90.0, 40.0, 90.0, 40.0);
    for branch in cycle.branches() {
        for end in branch.ends() {
            // Next to a crossing, rounding changes the difference of the assemblies by ε divided by the distance, which
            // is 0.01 there.
            assert!((2.0 * end.input).sin().abs() < 16.0 * f64::EPSILON / 0.01, "{end:?}");
        }
    }
    assert_eq!(cycle.circuits().len(), 1);
    let kinds: Vec<EndKind> = cycle
        .branches()
        .iter()
        .flat_map(|branch| branch.ends().map(|end| end.kind))
        .collect();
    assert!(kinds.iter().all(|kind| *kind == EndKind::Limit(LimitKind::ChangePoint)));
    assert_eq!(cycle.branches().len(), 4);
}

/// A dense scan finds as many positions as there are branches everywhere.
#[test]
fn the_library_has_no_other_branch() {
    let mut wrong = Vec::new();
    macro_rules! scan {
        ($count:literal: $($mechanism:expr),* $(,)?) => {
            $({
                let cycle = $mechanism.cycle().unwrap();
                println!(
                    "{}: {} circuits, {} branches, complete {}, revolutions {:?}",
                    stringify!($mechanism),
                    cycle.circuits().len(),
                    cycle.branches().len(),
                    cycle.is_complete(),
                    cycle.circuits().iter().map(|circuit| circuit.input_revolutions()).collect::<Vec<_>>(),
                );
                let name = stringify!($mechanism);
                // In four assemblies of Peaucellier's cell, two links rotate freely.
                if cycle.is_complete() == name.starts_with("Peaucellier") {
                    wrong.push(format!("{}: is_complete", stringify!($mechanism)));
                }
                wrong.extend(disagreements(stringify!($mechanism), &cycle, $count));
            })*
        };
    }
    let at = |x: f64, y: f64| Plane::new(x, y);
    let (p, q) = (at(1.5, 0.8), at(1.2, -0.6));
    scan![701:
        SliderCrank { r: 1.0, l: 3.0 },
        SliderCrank { r: 3.0, l: 1.0 },
        InvertedSliderCrank { r1: 2.0, r2: 1.0 },
        InvertedSliderCrank { r1: 1.0, r2: 2.0 },
        WhitworthQuickReturn { ground: 0.05, crank: 0.1, arm: 0.15, rod: 0.5 },
        GearedFiveBar { r1: 2.0, r2: 0.5, r3: 2.5, r4: 2.5, r5: 0.5, ratio: -0.5, phase: PI },
        GearedFiveBar { r1: 3.0, r2: 1.5, r3: 1.6, r4: 1.7, r5: 1.2, ratio: 2.0, phase: 0.3 },
        PeaucellierLinkage { ground: 2.0, crank: 1.9, arm: 6.0, side: 4.0 },
        RobertsLinkage { base: 1.0, arm: 2.0 },
        WattI { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, q, r5: 2.5, r6: 2.0 },
        WattI { r1: 3.0, r2: 2.4, r3: 2.0, r4: 2.2, p, q, r5: 1.5, r6: 1.6 },
        WattII { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, arm: p, pivot: at(7.0, 0.0), r5: 3.0, r6: 2.5 },
        StephensonI { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, q, r5: 2.5, r6: 2.0 },
        StephensonIII { r1: 4.0, r2: 1.5, r3: 4.0, r4: 1.6, p: at(2.0, 1.0), r5: 1.5, pivot: at(5.0, 5.0), r6: 5.0 },
        JansenLeg::HOLY_NUMBERS,
        KlannLeg::PATENT,
        HoekenLinkage::PUBLISHED,
        ChebyshevLinkage::PUBLISHED,
    ];
    // coupled blocks
    scan![23:
        StephensonIByDyad { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, q, r5: 2.5, r6: 2.0 },
        StephensonII { r1: 4.0, r2: 2.0, r3: 1.5, r4: 1.2, p, q, r5: 1.6, r6: 3.0 },
        WattIByDyad { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, q, r5: 2.5, r6: 2.0 },
        WattIIByCouplers { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, arm: p, pivot: at(7.0, 0.0), r5: 3.0, r6: 2.5 },
        StephensonIIIByDyad { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, r5: 3.0, pivot: at(5.0, 3.0), r6: 2.5 },
    ];
    assert_eq!(wrong, Vec::<String>::new());
}

crate::mechanism! {
    /// A crank with a pin in a slide, whose line passes through the pivot of its link, on either side of that pivot.
    struct CrankInSlide { pub ground: Length, pub crank: Length }
    input theta: Angle;
    unknown phi: Angle, slide: Length;
    ground + crank * cis(theta) == slide * cis(phi);
}

crate::mechanism! {
    /// The same with a ram that the link drives.
    struct CrankInSlideWithRam {
        pub ground: Length, pub crank: Length, pub arm: Length, pub rod: Length, pub height: Length,
    }
    input theta: Angle;
    unknown phi: Angle, slide: Length, psi: Angle, ram: Length;
    ground + crank * cis(theta) == slide * cis(phi);
    arm * cis(phi) + rod * cis(psi) == vec2(ram, height);
}

/// A crank as long as the ground leads the slide to the pivot of its link, where the link rotates freely. All branches
/// meet there.
#[test]
fn a_link_turns_freely() {
    for length in [1.0, 3.7, 0.1, 250.0] {
        let linkage: CrankInSlide = CrankInSlide {
            ground: length,
            crank: length,
        };
        let cycle = linkage.cycle().unwrap();
        assert!(cycle.is_complete());
        assert_eq!((cycle.circuits().len(), cycle.branches().len()), (1, 2), "{cycle:?}");
        for branch in cycle.branches() {
            let inside = branch.samples()[branch.samples().len() / 2].1[1];
            for (end, joins) in branch.ends().iter().zip(branch.joins()) {
                // Next to that input, the direction of the link has lost its digits: those 0.01 away have an error of ε
                // divided by that.
                let tolerance = 16.0 * f64::EPSILON / 0.01;
                assert_eq!(
                    (end.kind, end.block),
                    (EndKind::Limit(LimitKind::ChangePoint), "phi, slide".into())
                );
                assert!((end.input.abs() - PI).abs() < tolerance, "{end:?}");
                let [phi, slide] = end.unknowns[..] else { panic!() };
                assert!(slide.abs() < tolerance * length, "{end:?}");
                // the angle at the circumference is half of that at the centre
                assert!((phi - 0.5 * end.input).sin().abs() < tolerance, "{end:?}");
                assert!((phi - 0.5 * end.input).cos() * inside > 0.0, "{end:?} {inside}");
                assert_eq!(joins.len(), 3, "{branch:?}");
            }
        }
        assert_eq!(disagreements("slide", &cycle, 501), Vec::<String>::new());
        // four branches in a range with ends, of which only the free link connects two with the other two
        let part = linkage.cycle_over(-1.0..=5.0).unwrap();
        assert_eq!((part.circuits().len(), part.branches().len()), (1, 4), "{part:?}");
        let part = linkage.cycle_over(0.5..=2.5).unwrap();
        assert_eq!((part.circuits().len(), part.branches().len()), (2, 2), "{part:?}");
        let other: CrankInSlide = CrankInSlide {
            crank: 0.999 * length,
            ..linkage
        };
        let cycle = other.cycle().unwrap();
        assert_eq!((cycle.circuits().len(), cycle.branches().len()), (2, 2), "{cycle:?}");
        // the slide stays on one side of the pivot
        let one_sided = InvertedSliderCrank { r1: length, r2: length }.cycle().unwrap();
        assert_eq!(
            (one_sided.circuits().len(), one_sided.branches().len()),
            (1, 1),
            "{one_sided:?}"
        );
        for end in one_sided.branches()[0].ends() {
            assert_eq!(end.kind, EndKind::Limit(LimitKind::ChangePoint));
            assert!((end.unknowns[1] - 0.5 * end.input).sin().abs() < 1e-9, "{end:?}");
            assert!((end.unknowns[1] - 0.5 * end.input).cos() > 0.0, "{end:?}");
        }
    }
}

/// If crank and ground are equal, and coupler and rocker as well, both of the latter rotate freely with the crank on
/// the ground.
#[test]
fn coupler_and_rocker_turn_freely() {
    let kite = four_bar(2.0, 2.0, 3.0, 3.0);
    assert!(kite.is_complete());
    assert_eq!((kite.circuits().len(), kite.branches().len()), (1, 2), "{kite:?}");
    assert_eq!(disagreements("kite", &kite, 501), Vec::<String>::new());
    let rhombus = four_bar(2.0, 2.0, 2.0, 2.0);
    assert!(rhombus.is_complete());
    assert_eq!(
        (rhombus.circuits().len(), rhombus.branches().len()),
        (1, 4),
        "{rhombus:?}"
    );
    assert_eq!(disagreements("rhombus", &rhombus, 501), Vec::<String>::new());
    for cycle in [kite, rhombus] {
        for end in cycle.branches().iter().flat_map(Branch::ends) {
            assert_eq!(end.kind, EndKind::Limit(LimitKind::ChangePoint));
            assert!((end.input).sin().abs() < 16.0 * f64::EPSILON / 0.01, "{end:?}");
            let residuals = cycle.mechanism().closure(end.input, [end.unknowns[0], end.unknowns[1]]);
            assert!(
                residuals.iter().all(|residual| residual.abs() < 1e-9),
                "{end:?} {residuals:?}"
            );
        }
    }
}

/// Blocks that are solved after a free link move with it, and each branch goes on smoothly in another one.
#[test]
fn a_link_that_turns_freely_drives_a_ram() {
    let press: CrankInSlideWithRam = CrankInSlideWithRam {
        ground: 0.1,
        crank: 0.1,
        arm: 0.15,
        rod: 0.5,
        height: 0.05,
    };
    let cycle = press.cycle().unwrap();
    assert!(cycle.is_complete());
    assert_eq!((cycle.circuits().len(), cycle.branches().len()), (2, 4), "{cycle:?}");
    for branch in cycle.branches() {
        for (side, (end, joins)) in branch.ends().iter().zip(branch.joins()).enumerate() {
            assert_eq!(end.kind, EndKind::Limit(LimitKind::ChangePoint));
            let [next] = joins else { panic!("{branch:?}") };
            let next = cycle.branches()[*next].ends()[1 - side];
            for (unknown, (one, other)) in end.unknowns.iter().zip(&next.unknowns).enumerate() {
                let is_angle = CrankInSlideWithRam::<f64>::DESCRIPTION.unknowns[unknown].dimension == Dimension::Angle;
                let apart = if is_angle {
                    (0.5 * (one - other)).sin()
                } else {
                    one - other
                };
                assert!(apart.abs() < 16.0 * f64::EPSILON / 0.01, "{end:?} {next:?}");
            }
        }
    }
    assert_eq!(disagreements("press", &cycle, 501), Vec::<String>::new());
}

/// The triad moves by one leg while the others stand still, and the cycle closes.
#[test]
fn several_inputs_move_along_a_line() {
    let triad = ClassThreeTriad {
        base_b: Plane::new(3.4, 0.0),
        base_c: Plane::new(1.7, 3.0),
        platform_b: Plane::new(1.7, 0.0),
        platform_c: Plane::new(0.8, 1.5),
    };
    let cycle = triad.cycle_between([0.3, 2.2, 2.3], [6.0, 2.2, 2.3]).unwrap();
    assert!(cycle.is_complete());
    assert_eq!(cycle.seeds(), [0.3, 6.0]);
    assert_eq!(disagreements("triad", &cycle, 23), Vec::<String>::new());
    // at every limit, two branches meet
    for branch in cycle.branches() {
        for (end, joins) in branch.ends().iter().zip(branch.joins()) {
            assert!(
                end.kind != EndKind::Limit(LimitKind::TurningPoint) || joins.len() == 1,
                "{branch:?}"
            );
        }
    }
    let robot = FiveBar {
        ground: 2.0,
        left: 1.5,
        left_rod: 2.0,
        right_rod: 1.9,
        right: 1.5,
    };
    let cycle = robot.cycle_along([0.1, 0.7], [1.0, -1.0]).unwrap();
    assert!(cycle.is_complete());
    assert_eq!(disagreements("five-bar", &cycle, 701), Vec::<String>::new());
    // between two points, the variable is the first input that moves
    let part = robot.cycle_between([0.1, 0.7], [0.6, 0.2]).unwrap();
    let line = &part.searched.line;
    assert_eq!([line.low, line.high], [0.1, 0.6]);
    assert_eq!(disagreements("part of the five-bar", &part, 301), Vec::<String>::new());
    let ends = |input| part.inputs(input).map(|value| (1e12 * value).round());
    assert_eq!([ends(0.1), ends(0.6)], [[1e11, 7e11], [6e11, 2e11]]);
}

/// Small numbers that depend on a step, the same in every run.
fn mixed(step: u32, index: u32) -> f64 {
    let mut state = step
        .wrapping_mul(2_654_435_761)
        .wrapping_add(index.wrapping_mul(40_503))
        .wrapping_add(12_345);
    for _ in 0..3 {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
    }
    f64::from(state % 12 + 1)
}

/// The labels say what the cycle finds, for linkages of whole lengths, of which many have change points.
#[test]
fn labels_agree_with_the_cycle() {
    let mut counts = [0; 15];
    for step in 0..samples::of(2_500) {
        let [r1, r2, r3, r4] = [0, 1, 2, 3].map(|index| mixed(step, index));
        let class = BarkerClass::of(r1, r2, r3, r4);
        let name = std::format!("{r1} {r2} {r3} {r4} {class:?}");
        counts[class.map_or(0, |class| usize::from(class.number()))] += 1;
        let cycle = four_bar(r1, r2, r3, r4);
        assert!(cycle.is_complete(), "{name}");
        let Some(class) = class else {
            assert_eq!(cycle.branches().len(), 0, "{name}");
            continue;
        };
        let revolutions = |cycle: &Cycle<FourBar>| -> Vec<(Option<i32>, Option<Vec<i32>>)> {
            let revolutions = cycle.circuits().iter();
            revolutions
                .map(|circuit| {
                    (
                        circuit.input_revolutions(),
                        circuit
                            .revolutions()
                            .map(|revolutions| revolutions.iter().map(|revolutions| revolutions.abs()).collect()),
                    )
                })
                .collect()
        };
        let has_change_point = cycle.branches().iter().any(|branch| {
            branch
                .ends()
                .iter()
                .any(|end| end.kind == EndKind::Limit(LimitKind::ChangePoint))
        });
        let expected = match class {
            BarkerClass::DoubleCrank => vec![(Some(1), Some(vec![1, 1])); 2],
            BarkerClass::CrankRocker => vec![(Some(1), Some(vec![0, 0])); 2],
            BarkerClass::DoubleRocker => vec![(Some(0), Some(vec![1, 0])); 2],
            BarkerClass::RockerCrank => vec![(Some(0), Some(vec![0, 1])); 2],
            _ if class.grashof() == GrashofType::NonGrashof => vec![(Some(0), Some(vec![0, 0]))],
            BarkerClass::TwoPairs | BarkerClass::AllEqual => continue,
            _ => {
                assert!(has_change_point, "{name} {cycle:?}");
                assert_eq!(cycle.circuits().len(), 1, "{name} {cycle:?}");
                continue;
            }
        };
        assert!(!has_change_point, "{name}");
        assert_eq!(revolutions(&cycle), expected, "{name} {cycle:?}");
    }
    let seen = counts.iter().filter(|count| **count > 0).count();
    let least = if samples::are_all() { counts.len() } else { 12 };
    assert!(seen >= least, "{counts:?}");
}

/// An input outside of a branch has no position on it, even if the assembly closes there on another branch.
#[test]
fn a_position_on_a_branch_is_inside_of_it() {
    let cycle = four_bar(60.0, 50.0, 20.0, 45.0);
    let degrees = f64::to_radians;
    let mut seen = 0;
    for (index, branch) in cycle.branches().iter().enumerate() {
        let [low, high] = branch.ends().map(|end| end.input);
        let middle = f64::midpoint(low, high);
        let there = cycle.position_on(index, middle).unwrap();
        for revolutions in [-1.0, 1.0] {
            let shifted = cycle.position_on(index, middle + revolutions * 2.0 * PI).unwrap();
            assert!(
                (0..2).all(|unknown| (shifted[unknown] - there[unknown]).abs() < 1e-12),
                "{shifted:?}"
            );
        }
        if branch.range().contains(&degrees(45.0)) {
            seen += 1;
            let beyond = cycle.position_on(index, degrees(-45.0)).unwrap_err();
            let Failure::OutOfRange {
                value,
                low: from,
                high: to,
                is_angle: true,
                ..
            } = beyond.failure
            else {
                panic!("{beyond}")
            };
            assert_eq!([value, from, to], [degrees(-45.0), low, high]);
            assert!(cycle.pose_on(index, degrees(-45.0)).is_err());
        }
    }
    assert!(seen > 0, "{cycle:?}");
    // over a part of the angles, a revolution leads to no other position
    let part = SAMPLE.cycle_over(-1.0..=1.0).unwrap();
    assert!(part.position_on(0, 0.5).is_ok() && part.position_on(0, 0.5 + 2.0 * PI).is_err());
}

/// A quantity that makes full revolutions with the input, or stays, has no advance and return.
#[test]
fn a_time_ratio_needs_a_return() {
    let no_return = |cycle: Cycle<FourBar>, name: &str| {
        let ratio = cycle.along(0).of(name).time_ratio();
        assert!(matches!(ratio, Err(MeasureError::NoReturn { .. })), "{name}: {ratio:?}");
    };
    // a double crank: coupler and rocker make full revolutions
    no_return(four_bar(30.0, 60.0, 70.0, 80.0), "theta4");
    no_return(four_bar(30.0, 60.0, 70.0, 80.0), "theta3");
    assert!(
        four_bar(90.0, 30.0, 70.0, 60.0)
            .along(0)
            .of("theta4")
            .time_ratio()
            .unwrap()
            > 1.0
    );
}

/// A name and an expression of the same quantity have the same extremes, which are those of sweeps over the branches.
#[test]
fn questions_along_a_circuit_are_those_along_a_sweep() {
    for cycle in [four_bar(90.0, 30.0, 70.0, 60.0), four_bar(90.0, 30.0, 60.0, 45.0)] {
        let along = cycle.along(0);
        let (named, expressed) = (along.of("theta4"), along.of_expression(|at| at.theta4));
        let extremes = named.extremes().unwrap();
        assert_eq!(extremes, expressed.extremes().unwrap());
        let values = || extremes.iter().filter_map(|found| found.extreme.value);
        let [low, high] = [
            values().fold(f64::INFINITY, f64::min),
            values().fold(f64::NEG_INFINITY, f64::max),
        ];
        assert_eq!(
            [named.lowest(), named.highest()].map(|peak| peak.unwrap().value),
            [low, high]
        );
        assert_eq!(named.peak().unwrap().value.abs(), low.abs().max(high.abs()));
        let velocity = along.of("theta4_velocity").peak();
        if cycle.branches()[0].is_full_revolution() {
            let measures = cycle
                .mechanism()
                .sweep(Assembly::BOTH[cycle.branches()[0].assembly().unwrap()]);
            let measures = measures.over(0.0..=2.0 * PI, 3).of("theta4_velocity").peak().unwrap();
            assert!((velocity.unwrap().value - measures.value).abs() < 1e-12);
        } else {
            let unbounded = matches!(&velocity, Err(MeasureError::Extremes(ExtremesError::Unbounded { .. })));
            assert!(unbounded, "{velocity:?}");
        }
    }
    let none = four_bar(90.0, 30.0, 70.0, 60.0).along(7).of("theta4").peak();
    assert_eq!(none, Err(MeasureError::NoSuchCircuit));
}

#[test]
fn an_unknown_name_is_reported_with_those_that_exist() {
    let error = four_bar(90.0, 30.0, 70.0, 60.0)
        .along(0)
        .of("theta5")
        .stroke()
        .unwrap_err();
    let sentence = "none of the 40 columns is called `theta5`: did you mean `theta2`, `theta3` or `theta4`";
    assert_eq!(format!("{error:?}"), sentence);
}

#[test]
fn a_range_without_a_length_is_reported() {
    let refused = |found: Result<Cycle<FourBar>, SolveError>, what: &str| {
        let Err(error) = found else {
            panic!("there is no {what}")
        };
        let what = format!("{what}, which is zero");
        assert!(std::string::ToString::to_string(&error).contains(&what), "{error}");
    };
    refused(SAMPLE.cycle_over(1.0..=1.0), "length of the range");
    refused(SAMPLE.cycle_along([1.0], [0.0]), "direction of the inputs");
    refused(SAMPLE.cycle_between([1.0], [1.0]), "length of the range");
}

/// On the second circuit of a pantograph the pen stands at the origin, up to rounding errors, which grow towards both
/// limits.
#[test]
fn a_point_that_stands_has_a_stroke() {
    let dividers = Pantograph {
        upper: 3.0,
        lower: 3.0,
        factor: 2.0,
    };
    let cycle = dividers.cycle_along([0.0, -1.5], [1.0, 0.0]).unwrap();
    for name in ["pen.x", "pen.y"] {
        let stroke = cycle.along(1).of(name).stroke().unwrap();
        assert!(stroke.length() < 1e-12, "{name}: {stroke:?}");
        let moved = cycle.along(0).of(name).stroke().unwrap();
        assert!(moved.high.value.abs() > 1.0, "{name}: {moved:?}");
    }
}
