//! Every answer along a curve is that of the same curve: tables of any number of rows, extremes, crossings and means.
#![cfg(feature = "alloc")]

use core::f64::consts::TAU;
use std::format;
use std::vec::Vec;

use super::Over;
use crate::assembly::Assembly;
use crate::library::WhitworthQuickReturn;
use crate::mechanism::Mechanism;
use crate::sweep::{Course, SmoothDrive, Sweep};

crate::mechanism! {
    /// A four-bar linkage with all that can depend on an angle: a rack on a pinion, a gear of half the speed, directions and differences.
    struct Geared { r1: Length, r2: Length, r3: Length, r4: Length, pinion: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle, rack: Length, gear: Angle, direction: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    rack == pinion * theta4;
    gear == theta4 / 2;
    direction == atan2(r4 * sin(theta4), r4 * cos(theta4));
    output same: Angle = theta4;
    output lag: Angle = theta4 - theta2;
    output reach: Length = r4 * theta4;
    output at: Angle = atan2(r2 * sin(theta2) + r3 * sin(theta3), r2 * cos(theta2) + r3 * cos(theta3));
    output end: Point = r2 * cis(theta2) + r3 * cis(theta3);
    output tooth: Length = r4 * sin(gear);
}

/// The steps of the fine table.
const FINE: usize = 4000;

const DOUBLE_CRANK: Geared = Geared {
    r1: 20.0,
    r2: 50.0,
    r3: 45.0,
    r4: 55.0,
    pinion: 10.0,
};
const CRANK_ROCKER: Geared = Geared {
    r1: 90.0,
    r2: 30.0,
    r3: 70.0,
    r4: 60.0,
    pinion: 10.0,
};

/// Compares the answers to every question about a quantity with a fine table.
fn hold<M: Mechanism<Scalar = f64>, D: SmoothDrive<M>>(name: &str, course: impl Fn(usize) -> Course<M, D>) {
    let fine = course(FINE + 1).table().unwrap();
    let values = fine.column(name).unwrap();
    let places: Vec<f64> = fine.variable().values.to_vec();
    let (low, high) = values
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(*value), high.max(*value))
        });
    let size = low.abs().max(high.abs());
    let level = low + 0.37 * (high - low);
    let crossed = values
        .windows(2)
        .filter(|pair| (pair[0] < level) != (pair[1] < level))
        .count();
    for rows in [2, 7, 361] {
        let sweep = course(rows);
        let table = sweep.table().unwrap();
        // the rows of one table among those of the fine one
        for (row, value) in table.column(name).unwrap().iter().enumerate() {
            let part = row as f64 / (rows - 1) as f64;
            let place = sweep.at(row);
            let index = ((part * FINE as f64) as usize).min(FINE - 1);
            let (start, end) = (places[index], places[index + 1]);
            let expected = values[index] + (values[index + 1] - values[index]) * (place - start) / (end - start);
            assert!(
                (value - expected).abs() <= 1e-3 * size,
                "{name}, {rows} rows, row {row}: {value} instead of {expected}"
            );
        }
        let [lowest, highest] = [sweep.lowest(name).unwrap().value, sweep.highest(name).unwrap().value];
        let slack = 1e-12 * size;
        assert!(
            lowest <= low + slack && low <= lowest + 1e-3 * size,
            "{name}, {rows} rows: lowest {lowest}, in the table {low}"
        );
        assert!(
            highest >= high - slack && high >= highest - 1e-3 * size,
            "{name}, {rows} rows: highest {highest}, in the table {high}"
        );
        let crossings = sweep.crossings(name, level).unwrap();
        assert_eq!(crossings.len(), crossed, "{name}, {rows} rows");
        assert!(
            crossings.windows(2).all(|pair| pair[0].is_rising != pair[1].is_rising),
            "{name}, {rows} rows"
        );
        for (power, mean) in [
            (1, sweep.mean(name, Over::Time).unwrap()),
            (2, sweep.rms(name, Over::Time).unwrap()),
        ] {
            let sum: f64 = values
                .windows(2)
                .map(|pair| 0.5 * (pair[0].powi(power) + pair[1].powi(power)))
                .sum();
            let expected = sum / FINE as f64;
            let expected = if power == 2 { expected.sqrt() } else { expected };
            assert!(
                (mean.value - expected).abs() <= 1e-4 * size,
                "{name}, {rows} rows: mean {} instead of {expected}",
                mean.value
            );
        }
        let adaptive = sweep.adaptive_table(1e-2, 1, 100_000).unwrap();
        let last = adaptive.column(name).unwrap().last().copied().unwrap();
        assert!(
            (last - values[FINE]).abs() <= 1e-9 * size,
            "{name}, {rows} rows: ends at {last} instead of {}",
            values[FINE]
        );
    }
}

fn hold_all<M: Mechanism<Scalar = f64>, D: SmoothDrive<M>>(course: impl Fn(usize) -> Course<M, D>) {
    let description = M::DESCRIPTION;
    for quantity in description.unknowns.iter().chain(description.outputs) {
        for suffix in ["", "_velocity"] {
            hold(&format!("{}{suffix}", quantity.name), &course);
        }
    }
}

/// A double crank turns its rocker fully, in one turn or two, whatever hangs on it.
#[test]
fn all_answers_about_a_double_crank_agree() {
    hold_all(|rows| DOUBLE_CRANK.sweep(Assembly::Open).over(0.0..=TAU, rows));
    hold_all(|rows| DOUBLE_CRANK.sweep(Assembly::Crossed).over(-1.0..=2.0 * TAU, rows));
}

#[test]
fn all_answers_about_a_crank_rocker_agree() {
    hold_all(|rows| CRANK_ROCKER.sweep(Assembly::Crossed).over(0.3..=0.3 + TAU, rows));
}

#[test]
fn all_answers_about_a_quick_return_agree() {
    let linkage = WhitworthQuickReturn {
        ground: 0.05,
        crank: 0.12,
        arm: 0.15,
        rod: 0.5,
    };
    hold_all(|rows| linkage.sweep(Assembly::Open).over(0.0..=TAU, rows));
}
