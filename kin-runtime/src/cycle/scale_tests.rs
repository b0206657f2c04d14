//! Lengths of any size, and linkages next to a change point.

use std::string::String;
use std::vec::Vec;
use std::{format, vec};

use super::{Cycle, EndKind, FullCycle, Incomplete};
use crate::assembly::Assembly;
use crate::curve::LimitKind;
use crate::failure::Failure;
use crate::geometry::Plane;
use crate::library::*;
use crate::mechanism::Mechanism;

crate::mechanism! {
    /// A crank with a pin in a slide beside its line.
    struct CrankInOffsetSlide { pub ground: Length, pub crank: Length, pub offset: Length }
    input theta: Angle;
    unknown phi: Angle, slide: Length;
    ground + crank * cis(theta) == vec2(slide, offset) * cis(phi);
}

/// The kinds of the ends, the circuit and the neighbours of each branch, and the revolutions of each circuit.
fn outline<M: Mechanism<Scalar = f64>>(cycle: &Cycle<M>) -> String {
    let branches = cycle.branches().iter();
    let branches: Vec<String> = branches
        .map(|branch| {
            format!(
                "{:?} of {} to {:?}",
                branch.ends().map(|end| end.kind),
                branch.circuit(),
                branch.joins()
            )
        })
        .collect();
    let circuits = cycle.circuits().iter();
    let circuits: Vec<String> = circuits
        .map(|circuit| format!("{:?} {:?}", circuit.input_revolutions(), circuit.revolutions()))
        .collect();
    let revolutions = cycle.period().map(|period| period / core::f64::consts::TAU);
    format!("{:?} {revolutions:?} {branches:?} {circuits:?}", cycle.is_complete())
}

/// All links of a parallelogram, of a kite or of another linkage with a change point can lie on one line, however short
/// the crank is.
#[test]
fn short_cranks_have_change_points() {
    let mut links = vec![
        [72.0, 1.0, 72.0, 1.0],
        [610.0, 10.0, 610.0, 10.0],
        [93.0, 1.0, 81.0, 173.0],
        [1.0, 72.0, 1.0, 72.0],
    ];
    for power in 1..=6 {
        let long = 10.0_f64.powi(power);
        links.push([long, 1.0, long, 1.0]);
        links.push([long, 1.0, long + 2.0, 3.0]);
        links.push([long + 3.0, 1.0, 7.0, long + 9.0]);
    }
    for [r1, r2, r3, r4] in links {
        let cycle = FourBar { r1, r2, r3, r4 }.cycle().unwrap();
        let name = format!("{r1} {r2} {r3} {r4}: {cycle:?}");
        assert!(cycle.is_complete(), "{name}");
        assert_eq!(cycle.circuits().len(), 1, "{name}");
        for end in cycle.branches().iter().flat_map(super::Branch::ends) {
            assert_eq!(
                (end.kind, end.block),
                (EndKind::Limit(LimitKind::ChangePoint), "theta3, theta4".into()),
                "{name}"
            );
            assert!(end.input.sin().abs() < 1e-7, "{name}");
        }
    }
}

/// What is almost a change point is none.
#[test]
fn a_near_miss_is_no_change_point() {
    for excess in [1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11] {
        let cycle = CrankInOffsetSlide {
            ground: 1.0,
            crank: 1.0 + excess,
            offset: 0.01 * excess,
        }
        .cycle()
        .unwrap();
        assert!(cycle.is_complete(), "{excess} {cycle:?}");
        assert_eq!(
            (cycle.circuits().len(), cycle.branches().len()),
            (2, 2),
            "{excess} {cycle:?}"
        );
        assert!(
            cycle.branches().iter().all(super::Branch::is_full_revolution),
            "{excess} {cycle:?}"
        );
    }
    for short in [1.0, 1e-2, 1e-4] {
        for excess in [1e-3, 1e-6, 1e-9, 1e-11] {
            // the ground and the crank together are a little shorter than the other two links, or a little longer
            for sign in [1.0, -1.0] {
                let linkage = FourBar {
                    r1: 5.0,
                    r2: short,
                    r3: 3.0 + short,
                    r4: 2.0 + sign * excess,
                };
                let cycle = linkage.cycle().unwrap();
                assert!(cycle.is_complete(), "{cycle:?}");
                let (circuits, kind) = match sign {
                    1.0 => (2, EndKind::FullRevolution),
                    _ if excess > 2.0 * short => (0, EndKind::Limit(LimitKind::TurningPoint)),
                    _ => (1, EndKind::Limit(LimitKind::TurningPoint)),
                };
                let mut ends = cycle.branches().iter().flat_map(super::Branch::ends);
                assert!(ends.all(|end| end.kind == kind), "{cycle:?}");
                assert_eq!(cycle.circuits().len(), circuits, "{cycle:?}");
            }
        }
    }
}

/// The number of revolutions after which a gear repeats its position is that of any size.
#[test]
fn a_period_does_not_depend_on_the_unit() {
    let linkage = |unit: f64| GearedFiveBar {
        r1: 1.136_348_517_070_371_7 * unit,
        r2: 1.203_258_123_730_650_7 * unit,
        r3: 0.908_370_111_603_998_2 * unit,
        r4: 0.960_621_344_067_604_3 * unit,
        r5: 1.179_005_201_861_755_5 * unit,
        ratio: -1.5,
        phase: 1.933_821_730_184_769_5,
    };
    let expected = outline(&linkage(1.0).cycle().unwrap());
    assert!(expected.starts_with("true Some(2.0)"), "{expected}");
    for power in -60..=60 {
        assert_eq!(
            outline(&linkage(10.0_f64.powi(power)).cycle().unwrap()),
            expected,
            "{power}"
        );
    }
}

crate::mechanism! {
    /// A four-bar and a small gear within the loop, which rotates half as fast as the crank.
    struct GearInLoop { pub a: Length, pub b: Length, pub c: Length, pub d: Length, pub gear: Length }
    input t: Angle;
    unknown phi: Angle, psi: Angle;
    a * cis(t) + gear * cis(t / 2) + b * cis(phi) == d + c * cis(psi);
}

/// A gear that is much smaller than the links has its say in the period.
#[test]
fn a_small_gear_doubles_the_period() {
    for (gear, revolutions) in [(1e-3, 2.0), (1e-9, 2.0), (1e-12, 2.0), (0.0, 1.0)] {
        for unit in [1.0, 1e-20, 1e20] {
            let linkage: GearInLoop = GearInLoop {
                a: 30.0 * unit,
                b: 70.0 * unit,
                c: 60.0 * unit,
                d: 90.0 * unit,
                gear: gear * unit,
            };
            let cycle = linkage.cycle().unwrap();
            let period = cycle.period().map(|period| period / core::f64::consts::TAU);
            assert_eq!(period, Some(revolutions), "{gear} {unit}");
            assert!(cycle.is_complete());
        }
    }
}

/// Two blocks that have their limits at the same inputs have change points there, and all four assemblies meet.
#[test]
fn limits_of_two_blocks_at_once_are_a_change_point() {
    let dividers = Pantograph {
        upper: 2.0,
        lower: 1.5,
        factor: 2.5,
    };
    for unit in [1.0, 1e-37, 1e41] {
        let scaled = Pantograph {
            upper: 2.0 * unit,
            lower: 1.5 * unit,
            ..dividers
        };
        let cycle = scaled.cycle_along([1.35 * unit, 0.0], [unit, 0.0]).unwrap();
        assert!(cycle.is_complete(), "{cycle:?}");
        assert_eq!((cycle.circuits().len(), cycle.branches().len()), (2, 8), "{cycle:?}");
        for branch in cycle.branches() {
            for (end, joins) in branch.ends().iter().zip(branch.joins()) {
                assert_eq!(
                    (end.kind, end.block),
                    (EndKind::Limit(LimitKind::ChangePoint), "alpha, gamma".into())
                );
                assert_eq!(joins.len(), 3, "{branch:?}");
            }
        }
    }
    // a second dyad that reaches a little farther than the first one lets it
    for excess in [1e-3, 1e-6, 1e-9] {
        let pair: TwoDyads = TwoDyads {
            a: 2.0,
            b: 1.5,
            c: 2.0,
            d: 1.5 + excess,
        };
        let cycle = pair.cycle_over(0.0..=10.0).unwrap();
        assert!(cycle.is_complete(), "{cycle:?}");
        assert_eq!(
            (cycle.circuits().len(), cycle.branches().len()),
            (2, 4),
            "{excess} {cycle:?}"
        );
        for branch in cycle.branches() {
            let kinds = branch.ends().map(|end| end.kind);
            assert_eq!(
                kinds,
                [EndKind::Limit(LimitKind::TurningPoint); 2],
                "{excess} {branch:?}"
            );
        }
    }
}

crate::mechanism! {
    /// Two dyads that span the same distance.
    struct TwoDyads { pub a: Length, pub b: Length, pub c: Length, pub d: Length }
    input x: Length;
    unknown alpha: Angle, beta: Angle, gamma: Angle, delta: Angle;
    a * cis(alpha) + b * cis(beta) == vec2(x, 0);
    c * cis(gamma) + d * cis(delta) == vec2(x, 0);
}

/// Lengths with which no position is solved have no cycle, and the error is that of the solver.
#[test]
fn lengths_that_the_solver_refuses_are_an_error() {
    for power in [-300, -100, -80, 80, 100, 300] {
        let unit = 10.0_f64.powi(power);
        let linkage = FourBar {
            r1: 90.0 * unit,
            r2: 30.0 * unit,
            r3: 70.0 * unit,
            r4: 60.0 * unit,
        };
        let error = linkage.cycle().map(|_| ()).unwrap_err();
        assert!(matches!(error.failure, Failure::NotFinite { .. }), "{power} {error}");
        let apart = FourBar {
            r1: 900.0 * unit,
            ..linkage
        };
        let solved = apart.position(1.0, Assembly::Open).unwrap_err();
        let cycle = apart.cycle();
        if matches!(solved.failure, Failure::NotFinite { .. }) {
            assert_eq!(cycle.map(|_| ()).unwrap_err().failure, solved.failure, "{power}");
        } else {
            // the solver knows that it is out of reach
            let cycle = cycle.unwrap();
            assert!(
                cycle.is_complete() && cycle.branches().is_empty(),
                "{power} {solved} {cycle:?}"
            );
        }
    }
}

/// Where nothing can be decided, the cycle says so and why.
#[test]
fn rounding_is_a_reason() {
    let cycle = FourBar {
        r1: 1e15,
        r2: 1.0,
        r3: 1e15,
        r4: 1.0,
    }
    .cycle()
    .unwrap();
    assert!(!cycle.is_complete());
    let [reason @ Incomplete::Rounding { block, .. }] = cycle.incomplete() else {
        panic!("{cycle:?}")
    };
    assert_eq!(*block, "theta3, theta4");
    let expected = "rounding decides whether theta3, theta4 can be found between the inputs -3.529912 rad (-202.2°) \
                    and 2.753273 rad (157.8°)";
    assert_eq!(format!("{reason}"), expected);
}

crate::mechanism! {
    /// A lever that a rod of a given length drives, and a four-bar behind it.
    struct DrivenLever { pub lever: Length, pub p: Point, pub g: Length, pub link: Length, pub horn: Length }
    input c: Length;
    unknown lean: Angle, psi: Angle, phi: Angle, hang: Angle;
    c * cis(lean) == p + lever * cis(psi);
    lever * cis(psi) + link * cis(phi) == g + horn * cis(hang);
}

/// A change point of the second block lies where it does although a limit of the first one is close.
#[test]
fn a_change_point_beside_a_limit_has_all_its_digits() {
    let p = Plane::new(130.0, -18.0);
    let lever = DrivenLever {
        lever: 42.0,
        p,
        g: 32.0,
        link: 40.0,
        horn: 30.0,
    };
    let cycle = lever.cycle_over(50.0..=250.0).unwrap();
    assert!(cycle.is_complete(), "{cycle:?}");
    let expected = 172.0_f64.hypot(18.0);
    let mut count = 0;
    for end in cycle.branches().iter().flat_map(super::Branch::ends) {
        let residuals = lever.closure(end.input, core::array::from_fn(|unknown| end.unknowns[unknown]));
        let tolerance = 1e-7 * expected;
        assert!(
            residuals.iter().all(|residual| residual.abs() < tolerance),
            "{end:?} {residuals:?}"
        );
        if end.kind == EndKind::Limit(LimitKind::ChangePoint) {
            count += 1;
            assert!((end.input - expected).abs() < 1e-9 * expected, "{end:?} {expected}");
        }
    }
    assert!(count > 0);
}

crate::mechanism! {
    /// A four-bar whose ground is an input.
    struct SlidingPivot { pub a: Length, pub b: Length, pub d: Length }
    input theta: Angle, x: Length;
    unknown phi: Angle, psi: Angle;
    a * cis(theta) + b * cis(phi) == vec2(x, 0) + d * cis(psi);
}

/// An input that stands still has no say in how many revolutions the others make.
#[test]
fn an_angle_turns_while_a_length_stands_still() {
    let linkage = SlidingPivot {
        a: 30.0,
        b: 70.0,
        d: 60.0,
    };
    let cycle = linkage.cycle_along([0.0, 90.0], [1.0, 0.0]).unwrap();
    assert_eq!(cycle.circuits().len(), 2);
    assert!(
        cycle
            .circuits()
            .iter()
            .all(|circuit| circuit.input_revolutions() == Some(1)),
        "{cycle:?}"
    );
    let beside = cycle.position_on(0, 100.0);
    assert!(beside.is_ok());
}
