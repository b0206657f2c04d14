//! Change points, poles and islands between the rows of a sweep.
#![cfg(feature = "alloc")]

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use std::vec::Vec;

use super::{ExtremeKind, ExtremesError, Over};
use crate::assembly::Assembly;
use crate::curve::LimitKind;
use crate::cycle::{Cycle, EndKind, FullCycle, MeasureError};
use crate::geometry::Plane;
use crate::library::{FourBar, InvertedSliderCrank, SliderCrank, WattII};
use crate::mechanism::Mechanism;
use crate::number::{Number as _, samples};
use crate::sweep::{Local, Swept};
use crate::verify::Random;

/// 3 + 7 = 4 + 6: all links lie on a line at 0 degrees.
const CHANGE_POINT: FourBar = FourBar {
    r1: 3.0,
    r2: 4.0,
    r3: 7.0,
    r4: 6.0,
};
/// The velocities of the rocker on both sides of that position, by mpmath.
const JUMP: [f64; 2] = [0.258_342_613_226_058_6, 7.741_657_386_773_941];

/// The velocity jumps at the change point, and both sides count, whatever the rows are.
#[test]
fn a_rate_has_two_values_at_a_change_point() {
    for rows in [2, 3, 10, 41, 360] {
        let sweep = CHANGE_POINT.sweep(Assembly::Open).over(6.0..=6.5, rows).speed(1.0);
        let highest = sweep.of("theta4_velocity").highest().unwrap();
        assert!(
            (highest.value - JUMP[1]).abs() < 1e-8 && (highest.at - TAU).abs() < 1e-12,
            "{rows} rows: {highest:?}"
        );
        assert_eq!(highest.kind, ExtremeKind::Kink);
        let crossings = sweep.of("theta4_velocity").crossings(1.0).unwrap();
        assert_eq!(crossings.len(), 1, "{rows} rows");
        assert!(
            (crossings[0].at - TAU).abs() < 1e-12 && crossings[0].is_rising,
            "{rows} rows: {crossings:?}"
        );
        // over a revolution from beside it
        let sweep = CHANGE_POINT
            .sweep(Assembly::Open)
            .over(0.1..=0.1 + TAU, rows)
            .speed(1.0);
        let [lowest, highest] = [
            sweep.of("theta4_velocity").lowest(),
            sweep.of("theta4_velocity").highest(),
        ]
        .map(Result::unwrap);
        assert!(
            (lowest.value - JUMP[0]).abs() < 1e-8 && (highest.value - JUMP[1]).abs() < 1e-8,
            "{rows} rows: {lowest:?} {highest:?}"
        );
        assert!(sweep.of("theta4_velocity").extremes().unwrap().len() >= 2);
        let sweep = CHANGE_POINT.sweep(Assembly::Open).over(6.2..=6.4, rows).speed(1.0);
        assert!(
            (sweep.of("theta4_velocity").highest().unwrap().value - JUMP[1]).abs() < 1e-8,
            "{rows} rows"
        );
    }
}

#[test]
fn a_rate_is_finite_on_both_sides_of_a_change_point() {
    let linkage = FourBar {
        r1: 7.0,
        r2: 1.0,
        r3: -2.0,
        r4: 6.0,
    };
    let sweep = linkage.sweep(Assembly::Crossed).over(0.1..=0.1 + TAU, 41).speed(1.0);
    let peak = sweep.of("theta4_velocity").peak().unwrap();
    assert!(peak.value.abs() < 10.0, "{peak}");
    let extremes = SliderCrank { r: 1.0, l: 1.0 }
        .sweep(Assembly::Open)
        .over(1.0..=2.0, 7)
        .of("s")
        .extremes()
        .unwrap();
    assert!(extremes.iter().all(|extreme| extreme.value.is_some()), "{extremes:?}");
}

/// With a crank as long as the ground, the slot rotates by half a revolution at 180 degrees.
#[test]
fn an_angle_jumps_where_a_vector_vanishes() {
    for length in [1.0, 0.3] {
        for rows in [2, 11, 90] {
            let sweep = InvertedSliderCrank { r1: length, r2: length }
                .sweep()
                .over(2.0..=4.0, rows)
                .speed(1.0);
            let extremes = sweep.of("theta4").extremes().unwrap();
            assert!(extremes.len() <= 4, "{rows} rows: {extremes:?}");
            assert!(
                (sweep.of("theta4").highest().unwrap().value - FRAC_PI_2).abs() < 1e-9,
                "{rows} rows"
            );
            assert!(
                (sweep.of("theta4").lowest().unwrap().value + FRAC_PI_2).abs() < 1e-9,
                "{rows} rows"
            );
        }
        let table = InvertedSliderCrank { r1: length, r2: length }
            .sweep()
            .over(2.0..=4.0, 11)
            .table()
            .unwrap();
        let [limit] = table.limits() else {
            panic!("{:?}", table.limits())
        };
        assert!((limit.at - PI).abs() < 1e-12, "{limit:?}");
    }
}

crate::mechanism! {
    /// A lever on a wall: y has poles.
    struct Lever { h: Length }
    input t: Angle;
    unknown y: Length;
    y == h * tan(t);
    output travel: Length = h * tan(t);
    output ratio: Length = h * sin(t) / cos(t);
}

crate::mechanism! {
    /// The same as a linear equation.
    struct LinearLever { h: Length }
    input t: Angle;
    unknown y: Length;
    y * cos(t) == h * sin(t);
}

crate::mechanism! {
    /// The distance of the wall along the lever.
    struct Ray { h: Length }
    input t: Angle;
    unknown y: Length;
    y == h / cos(t);
}

#[test]
fn a_pole_is_unbounded() {
    for rows in [2, 5, 37, 100] {
        let sweep = Lever { h: 1.0 }.sweep().over(0.0..=PI, rows).speed(1.0);
        for name in ["y", "travel", "ratio"] {
            assert!(
                matches!(
                    sweep.of(name).highest(),
                    Err(ExtremesError::Unbounded { at }) if (at - FRAC_PI_2).abs() < 1e-9
                ),
                "{name}, {rows} rows: {:?}",
                sweep.of(name).highest()
            );
            assert!(
                matches!(sweep.of(name).mean(Over::Time), Err(ExtremesError::Diverges { .. })),
                "{name}, {rows} rows: {:?}",
                sweep.of(name).mean(Over::Time)
            );
            let crossings = sweep.of(name).crossings(0.5).unwrap();
            assert_eq!(crossings.len(), 1, "{name}, {rows} rows: {crossings:?}");
            assert!((crossings[0].at - 0.5_f64.atan()).abs() < 1e-12);
        }
    }
    for name in ["y", "travel", "ratio", "y_velocity"] {
        let stroke = Lever { h: 1.0 }.cycle().unwrap().along(0).of(name).stroke();
        assert!(
            matches!(
                stroke,
                Err(MeasureError::Extremes(ExtremesError::Unbounded { at }))
                    if (at.abs() - FRAC_PI_2).abs() < 1e-9
            ),
            "{name}: {stroke:?}"
        );
    }
}

#[test]
fn a_branch_ends_at_a_pole() {
    fn hold<M: Mechanism<Scalar = f64>>(cycle: &Cycle<M>) {
        assert!(cycle.is_complete());
        let [one, other] = cycle.branches() else {
            panic!("{:?}", cycle.branches())
        };
        for (branch, range) in [(one, [-1.0, 1.0]), (other, [1.0, 3.0])] {
            for (end, quarter) in branch.ends().iter().zip(range) {
                assert_eq!((end.kind, end.block), (EndKind::Limit(LimitKind::Pole), "y".into()));
                assert!(
                    (end.input - quarter * FRAC_PI_2).abs() <= 4.0 * f64::EPSILON,
                    "{branch:?}"
                );
            }
        }
    }
    for h in [1.0, -3e9, 1e-40] {
        hold(&Lever { h }.cycle().unwrap());
        hold(&LinearLever { h }.cycle().unwrap());
        hold(&Ray { h }.cycle().unwrap());
    }
}

/// Gaps between few rows are found.
#[test]
fn islands_between_rows_are_found() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    for rows in [2, 3, 4, 5, 11, 41] {
        let sweep = linkage.sweep(Assembly::Open).over(0.0..=2.0 * TAU, rows);
        assert_eq!(sweep.of("theta4").crossings(2.5).unwrap().len(), 4, "{rows} rows");
        let press = SliderCrank { r: 1.0, l: 0.8 }
            .sweep(Assembly::Open)
            .over(0.0..=TAU, rows);
        assert!(
            (press.of("s").lowest().unwrap().value + 0.6).abs() < 1e-9,
            "{rows} rows: {:?}",
            press.of("s").lowest()
        );
    }
}

/// A mean says which part of the range it covers, and limits are in degrees where the table is.
#[test]
fn islands_that_no_row_meets_are_found() {
    // two short links at the end of a long way: they reach in two ranges of less than two degrees
    let linkage = WattII {
        r1: 9.921_816_707_874_704,
        r2: 9.031_328_919_922_51,
        r3: 7.178_178_032_424_118,
        r4: 7.336_662_509_328_392,
        arm: Plane::new(6.579_029_608_608_295, 5.744_573_470_603_521),
        pivot: Plane::new(7.823_593_573_717_425, 8.346_502_864_261_836),
        r5: 1.155_631_708_194_362_3,
        r6: 2.876_824_491_808_959,
    };
    for assembly in <WattII as Mechanism>::assemblies() {
        let sweep = |rows: usize| linkage.sweep(assembly).over(-PI..=PI, rows);
        let table = sweep(4001).table().unwrap();
        let values = table.column("theta3").unwrap().iter().filter(|value| !value.is_nan());
        let scanned = values.clone().fold(f64::NEG_INFINITY, |most, value| most.max(*value));
        for rows in [2, 5, 37] {
            let highest = sweep(rows).of("theta3").highest().map(|peak| peak.value);
            match highest {
                Ok(highest) => assert!(
                    highest >= scanned && highest < scanned + 0.02,
                    "{rows}: {highest} {scanned}"
                ),
                Err(error) => assert!(values.clone().next().is_none(), "{rows}: {error}"),
            }
        }
    }
}

/// A sweep may end where the input reverses, or as close to it as numbers can, on either side.
#[test]
fn sweeps_end_at_limits() {
    let mut random = Random::new(7);
    let mut tested = 0;
    for _ in 0..samples::some_of(4, 80) {
        let [r1, r2, r3, r4] = [(); 4].map(|()| random.between(0.3, 2.0));
        let linkage = FourBar { r1, r2, r3, r4 };
        let cycle = linkage.cycle().unwrap();
        for branch in cycle.branches().iter().filter(|branch| !branch.is_full_revolution()) {
            let [low, high] = branch.ends().map(|end| end.input);
            let assembly = Assembly::BOTH[branch.assembly().unwrap()];
            let expected = branch.ends().map(|end| end.unknowns[1]);
            for slack in [0.0, 1e-16, 4e-15, -4e-15, -1e-12, -1e-9] {
                let range = low - slack..=high + slack;
                let sweep = linkage.sweep(assembly).over(range, 11);
                let extremes = sweep.of("theta4").extremes().unwrap();
                let (first, last) = (extremes.first().unwrap(), extremes.last().unwrap());
                let whole = first.value.unwrap() - expected[0];
                let whole = TAU * (whole / TAU).round();
                // the angle is a root of the distance from the limit
                let near = 1e-6 + 10.0 * slack.abs().sqrt() * (1.0 + (r1 + r2 + r3 + r4) / r1.min(r2).min(r3).min(r4));
                for (extreme, expected) in [first, last].into_iter().zip(expected) {
                    let difference = extreme.value.unwrap() - whole - expected;
                    assert!(difference.abs() < near, "{linkage:?} {slack}: {extreme} {expected}");
                }
                let velocity = sweep.of("theta4_velocity").extremes().unwrap();
                let ends = [velocity.first().unwrap(), velocity.last().unwrap()];
                let is_at_limit = slack.abs() < 1e-14;
                assert!(
                    !is_at_limit || ends.iter().all(|end| end.value.is_none()),
                    "{linkage:?} {slack}: {ends:?}"
                );
                let mean = sweep.of("theta4").mean(Over::Time).unwrap();
                let (lowest, highest) = (
                    sweep.of("theta4").lowest().unwrap(),
                    sweep.of("theta4").highest().unwrap(),
                );
                assert!(lowest.value < mean.value && mean.value < highest.value);
                tested += 1;
            }
        }
    }
    assert!(tested > 6 * samples::some_of(1, 20), "{tested}");
}

#[test]
fn a_mean_covers_what_closes() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 361);
    let table = sweep.table().unwrap();
    let [first, last] = [0, 1].map(|limit| table.limits()[limit].at);
    let mean = sweep.of("theta4").mean(Over::Time).unwrap();
    assert!((mean.covered - (1.0 - (last - first) / TAU)).abs() < 1e-12, "{mean:?}");
    let whole = sweep.of("theta2").mean(Over::Time).unwrap();
    assert_eq!(whole.covered, mean.covered);
    let degrees = table.clone().in_degrees();
    for (degrees, radians) in degrees.limits().iter().zip(table.limits()) {
        assert_eq!(degrees.inputs[0], radians.inputs[0].to_degrees());
        assert_eq!(degrees.unknowns[1], radians.unknowns[1].to_degrees());
        assert_eq!(degrees.at, radians.at.to_degrees());
    }
}

crate::mechanism! {
    /// A plate that is rotated about its middle: the nearer edge changes at zero.
    struct Plate { h: Length }
    input x: Length;
    unknown y: Length;
    y == h + x;
    output size: Length = sqrt(x * x);
    output bend: Length = sqrt(x * x) + x * x / h;
}

/// A mean is divided at kinks and jumps, wherever they are: that of a speed's size is the way over the time.
#[test]
fn a_mean_across_kinks_and_jumps() {
    let linkage = FourBar {
        r1: 9.0,
        r2: 3.0,
        r3: 7.0,
        r4: 6.0,
    };
    for start in [0.0, 0.4, 2.7] {
        let sweep = linkage.sweep(Assembly::Open).over(start..=start + TAU, 30).speed(2.0);
        let [low, high] = [sweep.of("theta4").lowest(), sweep.of("theta4").highest()].map(|peak| peak.unwrap().value);
        let speed = sweep.of_expression(|at| at.theta4.velocity().abs());
        let mean = speed.mean(Over::Time).unwrap();
        assert!((mean.value - 2.0 * (high - low) * 2.0 / TAU).abs() < 1e-12, "{mean:?}");
        let rises = sweep.of_expression(|at| Local::constant(if at.theta4.velocity() > 0.0 { 3.0 } else { 1.0 }));
        let turns = sweep.of("theta4_velocity").crossings(0.0).unwrap();
        let way = (turns[1].at - turns[0].at).rem_euclid(TAU);
        let up = if turns[0].is_rising { way } else { TAU - way };
        let mean = rises.mean(Over::Time).unwrap();
        assert!(
            (mean.value - (1.0 + 2.0 * up / TAU)).abs() < 1e-12,
            "{mean:?} {turns:?}"
        );
    }
}

/// A kink of an output is found between rows as well as in a row.
#[test]
fn a_kink_between_rows_is_an_extreme() {
    for rows in [2, 3, 4, 10, 22, 37] {
        for range in [-1.0..=1.1, -0.3..=0.9] {
            let sweep = Plate { h: 2.0 }.sweep().over(range, rows);
            for name in ["size", "bend"] {
                let extremes = sweep.of(name).extremes().unwrap();
                let kinds: Vec<ExtremeKind> = extremes.iter().map(|extreme| extreme.kind).collect();
                assert_eq!(
                    kinds,
                    [ExtremeKind::End, ExtremeKind::Kink, ExtremeKind::End],
                    "{name}, {rows} rows"
                );
                assert!(
                    extremes[1].at.abs() < 1e-9 && extremes[1].value.unwrap().abs() < 1e-9,
                    "{extremes:?}"
                );
                assert!(
                    sweep.of(name).lowest().unwrap().value.abs() < 1e-9,
                    "{name}, {rows} rows"
                );
                let crossings = sweep.of(name).crossings(0.1).unwrap();
                assert_eq!(crossings.len(), 2, "{name}, {rows} rows");
            }
        }
    }
}

/// A range that runs downwards runs so in time: odd derivatives change their sign, and the means stay.
#[test]
fn a_range_gives_the_direction() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 70.0,
        r4: 60.0,
    };
    let [up, down] = [0.3..=2.9, 2.9..=0.3].map(|range| linkage.sweep(Assembly::Open).over(range, 27).speed(3.0));
    let against = linkage.sweep(Assembly::Open).over(0.3..=2.9, 27).speed(-3.0);
    let tables = [&up, &down, &against].map(|sweep| sweep.table().unwrap());
    for (order, name) in [
        "theta4",
        "theta4_velocity",
        "theta4_acceleration",
        "theta4_jerk",
        "theta4_snap",
    ]
    .into_iter()
    .enumerate()
    {
        let [one, two, three] = tables.each_ref().map(|table| table.column(name).unwrap());
        let sign = if order % 2 == 0 { 1.0 } else { -1.0 };
        for (row, value) in one.iter().enumerate() {
            let close = |other: f64| (value - sign * other).abs() <= 1e-11 * value.abs().max(1.0);
            assert!(close(two[26 - row]) && close(three[row]), "{name} in row {row}");
        }
        let [one, two] = [&up, &down].map(|sweep| sweep.of(name).mean(Over::Time).unwrap().value);
        assert!((one - sign * two).abs() <= 1e-11 * one.abs().max(1.0), "{name}");
        let highest = up.of(name).highest().unwrap().value;
        let same = if order % 2 == 0 {
            down.of(name).highest()
        } else {
            down.of(name).lowest()
        }
        .unwrap()
        .value;
        assert!(
            (highest - sign * same).abs() <= 1e-10 * highest.abs().max(1.0),
            "{name}"
        );
    }
    // the velocity is the change of the angle from row to row
    let (angle, velocity) = (
        tables[1].column("theta4").unwrap(),
        tables[1].column("theta4_velocity").unwrap(),
    );
    let time = (2.9 - 0.3) / 26.0 / 3.0;
    for row in 1..26 {
        let slope = (angle[row + 1] - angle[row - 1]) / (2.0 * time);
        assert!((slope - velocity[row]).abs() < 0.02, "{slope}, {}", velocity[row]);
    }
}
