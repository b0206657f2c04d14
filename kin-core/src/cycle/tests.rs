//! Cycles against textbook cases and dense scans.

use core::f64::consts::PI;
use std::println;
use std::vec::Vec;

use super::{BarkerClass, Cycle, EndKind, FullCycle, GrashofType};
use crate::library::*;
use crate::mechanism::Mechanism;

const SAMPLE: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};

fn four_bar(r1: f64, r2: f64, r3: f64, r4: f64) -> Cycle<FourBar> {
    FourBar { r1, r2, r3, r4 }.cycle().unwrap()
}

/// At places all over the range, as many positions exist as branches, and each lies between the ends of its own.
fn agrees_with_a_scan<M: Mechanism<Scalar = f64>>(name: &str, cycle: &Cycle<M>, places: u32) {
    let (low, high) = match cycle.period() {
        Some(period) => (-0.5 * period, 0.5 * period),
        None => (cycle.line.low, cycle.line.high),
    };
    let mut wrong = 0;
    for place in 0..places {
        let input = low + (high - low) * (f64::from(place) + 0.317) / f64::from(places);
        let mut found = 0;
        cycle
            .mechanism()
            .positions_at(cycle.inputs(input), |_, _| found += 1)
            .unwrap();
        let count = cycle.at(input).count();
        if found != count {
            wrong += 1;
            if wrong < 4 {
                println!("{name}: at {input} {found} positions, {count} branches");
            }
        }
    }
    assert_eq!(wrong, 0, "{name}: {:?} {:?}", cycle.circuits(), cycle.branches());
}

#[test]
fn the_sample_linkage_swings() {
    let cycle = SAMPLE.cycle().unwrap();
    assert!(cycle.is_complete());
    assert_eq!((cycle.circuits().len(), cycle.branches().len()), (1, 2));
    let expected = SAMPLE.crank_range().unwrap().high;
    for branch in cycle.branches() {
        let [low, high] = branch.ends();
        assert_eq!([low.kind, high.kind], [EndKind::Limit; 2]);
        assert!((high.input - expected).abs() < 4e-15 && (low.input + expected).abs() < 4e-15);
        // coupler and rocker are in line
        let [theta3, theta4] = high.unknowns;
        assert!((theta3 - theta4 + PI).sin().abs() < 1e-13, "{theta3} {theta4}");
    }
    let circuit = &cycle.circuits()[0];
    // No link turns fully.
    assert_eq!((circuit.input_turns(), circuit.turns()), (Some(0), Some([0, 0])));
    agrees_with_a_scan("sample", &cycle, 500);
}

#[test]
fn every_type_of_four_bar() {
    // crank-rocker: two circuits, each with one branch over a full turn
    let cycle = four_bar(90.0, 30.0, 70.0, 60.0);
    assert!(cycle.is_complete());
    assert_eq!((cycle.circuits().len(), cycle.branches().len()), (2, 2));
    for circuit in cycle.circuits() {
        assert_eq!((circuit.input_turns(), circuit.turns()), (Some(1), Some([0, 0])));
    }
    // double-crank
    let cycle = four_bar(30.0, 70.0, 60.0, 90.0);
    assert_eq!((cycle.circuits().len(), cycle.branches().len()), (2, 2));
    for circuit in cycle.circuits() {
        assert_eq!((circuit.input_turns(), circuit.turns()), (Some(1), Some([1, 1])));
    }
    // double-rocker, the coupler turns: two circuits of two branches
    let cycle = four_bar(90.0, 60.0, 30.0, 70.0);
    assert_eq!((cycle.circuits().len(), cycle.branches().len()), (2, 4));
    for circuit in cycle.circuits() {
        assert_eq!(circuit.input_turns(), Some(0));
        assert_eq!(
            circuit.turns().map(|[coupler, rocker]| (coupler.abs(), rocker)),
            Some((1, 0))
        );
    }
    // change point: a parallelogram
    let cycle = four_bar(90.0, 40.0, 90.0, 40.0);
    for branch in cycle.branches() {
        for end in branch.ends() {
            assert!((2.0 * end.input).sin().abs() < 1e-13, "{end:?}");
        }
    }
    assert_eq!(cycle.circuits().len(), 1);
    let kinds: Vec<EndKind> = cycle
        .branches()
        .iter()
        .flat_map(|branch| branch.ends().map(|end| end.kind))
        .collect();
    assert!(kinds.iter().all(|kind| *kind == EndKind::ChangePoint));
    assert_eq!(cycle.branches().len(), 4);
}

#[test]
fn the_library_has_no_other_branch() {
    macro_rules! scan {
        ($($mechanism:expr),* $(,)?) => {
            $({
                let mechanism = $mechanism;
                let start = std::time::Instant::now();
                let cycle = mechanism.cycle().unwrap();
                println!(
                    "{}: {} circuits, {} branches, complete {}, {:?}",
                    stringify!($mechanism), cycle.circuits().len(), cycle.branches().len(), cycle.is_complete(), start.elapsed(),
                );
                agrees_with_a_scan(stringify!($mechanism), &cycle, 211);
            })*
        };
    }
    scan![
        SliderCrank { r: 1.0, l: 3.0 },
        SliderCrank { r: 3.0, l: 1.0 },
        JansenLeg::HOLY_NUMBERS,
        SAMPLE,
    ];
}

/// Small numbers that depend on a step, the same in every run.
fn mixed(step: u32, place: u32) -> f64 {
    let mut state = step
        .wrapping_mul(2_654_435_761)
        .wrapping_add(place.wrapping_mul(40_503))
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
    for step in 0..10_000 {
        let [r1, r2, r3, r4] = [0, 1, 2, 3].map(|place| mixed(step, place));
        let class = BarkerClass::of(r1, r2, r3, r4);
        let name = std::format!("{r1} {r2} {r3} {r4} {class:?}");
        counts[class.map_or(0, |class| usize::from(class.number()))] += 1;
        let cycle = four_bar(r1, r2, r3, r4);
        assert!(cycle.is_complete(), "{name}");
        let Some(class) = class else {
            assert_eq!(cycle.branches().len(), 0, "{name}");
            continue;
        };
        let turns = |cycle: &Cycle<FourBar>| -> Vec<(Option<i32>, Option<[i32; 2]>)> {
            let turns = cycle.circuits().iter();
            turns
                .map(|circuit| (circuit.input_turns(), circuit.turns().map(|turns| turns.map(i32::abs))))
                .collect()
        };
        let has_change_point = cycle
            .branches()
            .iter()
            .any(|branch| branch.ends().iter().any(|end| end.kind == EndKind::ChangePoint));
        let expected = match class {
            BarkerClass::DoubleCrank => std::vec![(Some(1), Some([1, 1])); 2],
            BarkerClass::CrankRocker => std::vec![(Some(1), Some([0, 0])); 2],
            BarkerClass::DoubleRocker => std::vec![(Some(0), Some([1, 0])); 2],
            BarkerClass::RockerCrank => std::vec![(Some(0), Some([0, 1])); 2],
            _ if class.grashof() == GrashofType::NonGrashof => std::vec![(Some(0), Some([0, 0]))],
            BarkerClass::TwoPairs | BarkerClass::AllEqual => continue,
            _ => {
                assert!(has_change_point, "{name} {cycle:?}");
                assert_eq!(cycle.circuits().len(), 1, "{name} {cycle:?}");
                continue;
            }
        };
        assert!(!has_change_point, "{name}");
        assert_eq!(turns(&cycle), expected, "{name} {cycle:?}");
    }
    println!("{counts:?}");
    assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
}
