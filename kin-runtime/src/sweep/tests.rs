//! Sweeps and their tables.
#![cfg(feature = "alloc")]

use core::f64::consts::{PI, TAU};
use std::string::ToString;
use std::vec::Vec;

use super::samples::{CRANK_ROCKER, Inverse, LIMITED, triad};
use super::{Instant, SweepError, Swept, Table};
use crate::assembly::{Assembly, Near};
use crate::batch::{Column, Outcome};
use crate::curve::LimitKind;
use crate::law::{ConstantSpeed, Law, Rise, Sequence, Shape};
use crate::library::{FiveBar, FourBar, GearedFiveBar, ScotchYoke};
use crate::load::{Balance, LoadError, Loaded, Loads};
use crate::mechanism::{Mechanism, OneInput};
use crate::motion::Motion;
use crate::number::{Number, samples};

/// The table and the iterator hold the same poses, up to the rounding of lanes and whole revolutions.
#[test]
fn table_and_rows_agree() {
    let sweep = CRANK_ROCKER.sweep(Assembly::Open).over(-1.0..=TAU, 100).speed(-10.0);
    let table = sweep.table().unwrap();
    assert_eq!(table.count(), 100);
    for (row, pose) in sweep.rows().enumerate() {
        let pose = pose.unwrap();
        for (name, motion) in [
            ("theta2", pose.theta2),
            ("theta3", pose.theta3),
            ("theta4", pose.theta4),
        ] {
            let orders = ["", "_velocity", "_acceleration", "_jerk", "_snap"];
            for (order, suffix) in orders.iter().enumerate() {
                let value = table.column(&(name.to_string() + suffix)).unwrap()[row];
                let size = 10_f64.powi(i32::try_from(order).unwrap());
                assert!(
                    (value - motion[order]).abs() <= 1e-11 * size,
                    "{name}{suffix} in row {row}"
                );
            }
        }
    }
    assert_eq!(table.variable().values[0], -1.0);
    assert_eq!(table.variable().values[99], TAU);
    assert!(table.limits().is_empty());
}

/// The coupler of a double crank makes full revolutions: it ends one further for each of the crank.
#[test]
fn angles_are_unwrapped() {
    let double_crank = FourBar {
        r1: 30.0,
        r2: 90.0,
        r3: 70.0,
        r4: 60.0,
    };
    let sweep = double_crank.sweep(Assembly::Open).over(0.0..=3.0 * TAU, 301);
    let table = sweep.table().unwrap();
    let rocker = table.column("theta4").unwrap();
    assert!((rocker[300] - rocker[0] - 3.0 * TAU).abs() < 1e-12);
    for pair in rocker.windows(2) {
        assert!((pair[1] - pair[0]).abs() < 0.5);
    }
    let poses: Vec<f64> = sweep.rows().map(|pose| pose.unwrap().theta4.position()).collect();
    for (one, other) in poses.iter().zip(rocker) {
        assert!((one - other).abs() < 1e-12);
    }
}

#[test]
fn limits_are_exact_and_rows_beyond_say_by_how_much() {
    let sweep = LIMITED.sweep(Assembly::Open).over(-3.0..=3.0, 61);
    let table = sweep.table().unwrap();
    let expected = LIMITED.crank_range().unwrap();
    let [low, high] = table.limits() else {
        panic!("two limits")
    };
    assert!((low.at + expected.high).abs() < 1e-14 && (high.at - expected.high).abs() < 1e-14);
    assert_eq!(
        (low.kind, high.kind),
        (LimitKind::TurningPoint, LimitKind::TurningPoint)
    );
    assert!(!low.closes_before && high.closes_before);
    let before = table.rows().nth(high.row).unwrap();
    assert!(before.outcome().is_solved() && before.get("theta2").unwrap() < high.at);
    assert_eq!(table.margin(high.row), None);
    for row in high.row + 1..61 {
        let error = LIMITED.position(sweep.at(row), Assembly::Open).unwrap_err();
        // A batch rounds the margin in another order.
        let lengths: f64 = LIMITED.parameters().iter().sum();
        let difference = table.margin(row).unwrap() - error.margin().unwrap();
        assert!(
            difference.abs() <= 4.0 * f64::EPSILON * lengths,
            "{row}: {difference:e}"
        );
        assert!(table.column("theta4").unwrap()[row].is_nan());
    }
    let degrees = table.in_degrees();
    assert!((degrees.limits()[1].at - 112.0243).abs() < 5e-5);
    assert!(degrees.to_string().contains("closes up to theta2 = 112.024"));
}

/// The time of a limit under a law is where the law brings the input there.
#[test]
fn limits_under_a_law_have_a_time() {
    let rise = Rise::new(Shape::Cycloidal, 0.0, 3.0, 1.0).unwrap();
    let table = LIMITED
        .sweep(Assembly::Open)
        .under_laws([&rise], 0.0..=1.0, 50)
        .table()
        .unwrap();
    let high = LIMITED.crank_range().unwrap().high;
    let [limit] = table.limits() else { panic!("one limit") };
    let [value, velocity] = rise.at::<2>(limit.at).derivatives();
    assert!((value - high).abs() < 4.0 * f64::EPSILON * (high + velocity));
    let same = LIMITED
        .sweep(Assembly::Open)
        .over_time(0.0..=1.0, 50, |time| [rise.at(time)]);
    assert_eq!(same.table().unwrap().limits()[0].at, limit.at);
}

/// A table does not depend on the blocks in which it is solved, and coupled blocks report theirs.
#[test]
fn progress_is_reported() {
    let sweep = CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, 70_000).speed(10.0);
    let mut parts = std::vec![];
    let table = sweep.table_with_progress(|part| parts.push(part)).unwrap();
    assert_eq!(parts, [65_536.0 / 70_000.0, 1.0]);
    for row in [0, 65_535, 65_536, 69_999] {
        let crank = Motion::at_constant_speed(sweep.at(row), 10.0);
        let pose = CRANK_ROCKER.solve(crank, Assembly::Open).unwrap();
        let snap = table.column("theta4_snap").unwrap()[row];
        assert!((snap - pose.theta4.snap()).abs() < 1e-11 * 1e4, "{row}");
    }
    let sweep = triad()
        .sweep(Near([0.1, 2.2, -2.0, 1.6]))
        .between([5.0_f64.sqrt(); 3], [2.0; 3], 600);
    parts.clear();
    sweep.table_with_progress(|part| parts.push(part)).unwrap();
    assert_eq!(parts, [256.0 / 600.0, 512.0 / 600.0, 1.0]);
    parts.clear();
    let sweep = CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, 5);
    sweep
        .adaptive_table_with_progress(1e-2, 2, 1000, |part| parts.push(part))
        .unwrap();
    assert_eq!(parts, [0.25, 0.5, 0.75, 1.0]);
}

/// Beyond the end of its circuit a coupled block stays unclosed, for every kind of sweep: its rows, its table and its
/// adaptive table. Each row gives the distance of the input that is farthest from the end.
#[test]
fn coupled_blocks_do_not_enter_again() {
    let leg = 5.0_f64.sqrt();
    // the legs shrink beyond what the platform allows, and grow again; one of them moves less
    let sweep = triad()
        .sweep(Near([0.1, 2.2, -2.0, 1.6]))
        .by_formula(0.0..=1.0, 31, |time| {
            let change = Instant::constant(6.0) * time * (time - Instant::constant(1.0));
            let legs = Instant::constant(leg) + change;
            [legs, legs, legs]
        });
    let table = sweep.table().unwrap();
    let adaptive = sweep.adaptive_table(1e-2, 0, 1000).unwrap();
    let [limit] = table.limits() else { panic!("one limit") };
    let end = limit.inputs[0];
    assert!((end - 1.0).abs() < 1e-9);
    let mut is_over = false;
    for (row, pose) in sweep.rows().enumerate() {
        let length = table.column("a").unwrap()[row];
        let has_ended = sweep.at(row) > limit.at;
        assert_eq!(pose.is_err(), has_ended, "row {row}");
        is_over |= has_ended;
        if let Err(error) = pose {
            let margin = error.margin().unwrap();
            assert!((margin + (length - end).abs()).abs() < 1e-12, "row {row}: {margin}");
            assert_eq!(table.margin(row), Some(margin));
        }
    }
    // the last rows have legs as long as the first ones
    assert!(is_over && (table.column("a").unwrap()[30] - leg).abs() < 1e-12);
    let variables = adaptive.variable().values;
    for (row, at) in variables.iter().enumerate() {
        assert_eq!(adaptive.outcome(row).unwrap().is_solved(), *at <= limit.at, "{at}");
    }
    assert_eq!(adaptive.limits().len(), 1);
    // extremes and means end there as well
    let extremes = sweep.of("phi").extremes().unwrap();
    let last = extremes.last().unwrap();
    assert!((last.at - limit.at).abs() < 1e-9, "{last}");
}

/// The memory of another table is used again, and nothing else of it.
#[test]
fn tables_are_filled_again() {
    let limited = LIMITED.sweep(Assembly::Open).over(-3.0..=3.0, 100).speed(5.0);
    let sweep = CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, 73);
    let rise = Rise::new(Shape::Cycloidal, 0.0, 3.0, 1.0).unwrap();
    let law = LIMITED.sweep(Assembly::Open).under_laws([&rise], 0.0..=1.0, 100);
    let mut table = limited.table().unwrap().in_degrees().units("mm", "s");
    sweep.fill_table(&mut table).unwrap();
    assert_eq!(table, sweep.table().unwrap());
    law.fill_table(&mut table).unwrap();
    limited.fill_table(&mut table).unwrap();
    // NaN differs from itself
    assert_eq!(
        std::format!("{table:?}"),
        std::format!("{:?}", limited.table().unwrap())
    );
    law.fill_table(&mut table).unwrap();
    assert_eq!(std::format!("{table:?}"), std::format!("{:?}", law.table().unwrap()));
    assert!(
        sweep.count() == 73
            && CRANK_ROCKER
                .sweep(Assembly::Open)
                .over(0.0..=1.0, 0)
                .fill_table(&mut table)
                .is_err()
    );
}

/// A gap about the stretched position, narrower than a step, is found wherever the rows lie, and nothing where there is
/// none.
#[test]
fn gaps_between_rows_are_found() {
    for rest in [1e-2, 1e-4, 1e-6] {
        let linkage = FourBar {
            r4: 50.0 - rest,
            ..CRANK_ROCKER
        };
        let FourBar { r1, r2, r3, r4 } = linkage;
        let cosine = (r1 * r1 + r2 * r2 - (r3 + r4) * (r3 + r4)) / (2.0 * r1 * r2);
        let edge = cosine.acos();
        // the arc cosine has the slope of one over the sine there
        let tolerance = 64.0 * f64::EPSILON / edge.sin();
        for count in (2..40)
            .step_by(if samples::are_all() { 1 } else { 7 })
            .chain([36, 90, 150, 361, 1500])
        {
            for (from, to) in [(0.0, TAU), (0.1, TAU), (6.0, 0.3)] {
                let table = linkage
                    .sweep(Assembly::Open)
                    .over(from..=to, count)
                    .speed(7.0)
                    .table()
                    .unwrap();
                let [first, second] = table.limits() else {
                    panic!("{rest} {count} from {from}: {:?}", table.limits())
                };
                let (low, high) = if from < to { (first, second) } else { (second, first) };
                assert!((low.at - edge).abs() < tolerance, "{rest} {count}: {} {edge}", low.at);
                assert!((high.at - (TAU - edge)).abs() < tolerance, "{rest} {count}");
                assert!(first.closes_before && !second.closes_before);
            }
        }
    }
    for count in (2..40)
        .step_by(if samples::are_all() { 1 } else { 7 })
        .chain([361, 3600])
    {
        for assembly in Assembly::BOTH {
            for linkage in [
                CRANK_ROCKER,
                FourBar {
                    r1: 30.0,
                    r2: 90.0,
                    ..CRANK_ROCKER
                },
            ] {
                let table = linkage
                    .sweep(assembly)
                    .over(0.0..=TAU, count)
                    .speed(10.0)
                    .table()
                    .unwrap();
                assert!(table.limits().is_empty(), "{count} {:?}", table.limits());
            }
        }
    }
}

/// Also along columns, where the inputs move on straight lines from row to row: with rates, at rest, and with several
/// inputs.
#[test]
fn gaps_along_columns_are_found() {
    let linkage = FourBar {
        r4: 49.99,
        ..CRANK_ROCKER
    };
    for count in [3_u32, 12, 361] {
        let exact = linkage
            .sweep(Assembly::Open)
            .over(0.1..=6.2, count as usize)
            .table()
            .unwrap();
        let angles = exact.column("theta2").unwrap().to_vec();
        let back: Vec<f64> = angles.iter().rev().copied().collect();
        for speed in [7.0, 0.0, -1e-3] {
            for column in [&angles, &back] {
                let mut crank = Motion::<Column<'_>>::new([0.0; 5].map(Column::Same));
                (crank[0], crank[1]) = (Column::Each(column), Column::Same(speed));
                let table = linkage.sweep(Assembly::Open).along([crank]).table().unwrap();
                let [first, second] = table.limits() else {
                    panic!("{count} {speed}: {:?}", table.limits())
                };
                assert!(first.closes_before && !second.closes_before && first.at < second.at);
                let mut found = [first.inputs[0], second.inputs[0]];
                found.sort_by(f64::total_cmp);
                for (found, exact) in found.iter().zip(exact.limits()) {
                    assert!(
                        (found - exact.at).abs() < 1e-12,
                        "{count} {speed}: {found} {}",
                        exact.at
                    );
                }
                // the position is a part of the way between two rows
                let row = first.row;
                let part = (first.inputs[0] - column[row]) / (column[row + 1] - column[row]);
                assert!(
                    (first.at - (f64::from(u32::try_from(row).unwrap()) + part)).abs() < 1e-9,
                    "{first}"
                );
            }
        }
    }
    // an angle that jumps by a revolution goes nowhere, and a full revolution has no gap
    for speed in [7.0, 0.0] {
        let angles: Vec<f64> = (0..200).map(|row| (f64::from(row) * 0.1) % TAU).collect();
        let mut crank = Motion::<Column<'_>>::new([0.0; 5].map(Column::Same));
        (crank[0], crank[1]) = (Column::Each(&angles), Column::Same(speed));
        let table = CRANK_ROCKER.sweep(Assembly::Open).along([crank]).table().unwrap();
        assert!(table.limits().is_empty(), "{:?}", table.limits());
        let waiting: Vec<f64> = (0..200).map(|row| if row % 2 == 0 { 2.5 } else { 2.5 + TAU }).collect();
        crank[0] = Column::Each(&waiting);
        let table = linkage.sweep(Assembly::Open).along([crank]).table().unwrap();
        assert!(table.limits().is_empty(), "{:?}", table.limits());
    }
    // both cranks move
    let robot = FiveBar {
        ground: 2.0,
        left: 1.5,
        left_rod: 1.5,
        right_rod: 1.35,
        right: 1.5,
    };
    let line = robot
        .sweep(Assembly::Open)
        .between([-3.07, -2.47], [-0.67, -0.07], 901)
        .table()
        .unwrap();
    let rows = [0, 300, 600, 900];
    let columns = ["alpha", "beta"].map(|name| {
        let column = line.column(name).unwrap();
        rows.map(|row| column[row])
    });
    let motions = columns.each_ref().map(|column| {
        let mut motion = Motion::<Column<'_>>::new([0.0; 5].map(Column::Same));
        motion[0] = Column::Each(column);
        motion
    });
    let along = robot.sweep(Assembly::Open).along(motions).table().unwrap();
    let inputs = |table: &Table| -> Vec<Vec<f64>> { table.limits().iter().map(|limit| limit.inputs.clone()).collect() };
    assert_eq!(
        along.limits().len(),
        line.limits().len(),
        "{:?} {:?}",
        along.limits(),
        line.limits()
    );
    for (one, other) in inputs(&along).iter().zip(&inputs(&line)) {
        assert!(
            one.iter().zip(other).all(|(one, other)| (one - other).abs() < 1e-12),
            "{one:?} {other:?}"
        );
    }
}

/// Also over time, where the gap has times, and adaptively.
#[test]
fn gaps_over_time_are_found() {
    let linkage = FourBar {
        r4: 49.99,
        ..CRANK_ROCKER
    };
    let rise = Rise::new(Shape::Cycloidal, 0.0, 6.0, 1.0).unwrap();
    let sweep = linkage.sweep(Assembly::Open).under_laws([&rise], 0.0..=1.0, 12);
    let exact = linkage.sweep(Assembly::Open).over(0.0..=6.0, 200).table().unwrap();
    let adaptive = sweep.adaptive_table(1e-2, 1, 2000).unwrap();
    for table in [sweep.table().unwrap(), adaptive] {
        assert_eq!(table.limits().len(), 2);
        for (limit, exact) in table.limits().iter().zip(exact.limits()) {
            let input: Motion<f64, 1> = rise.at(limit.at);
            assert!((input[0] - exact.at).abs() < 1e-12);
        }
    }
}

/// A formula says the same as a function that gives every rate.
#[test]
fn formulas_know_their_rates() {
    let start = CRANK_ROCKER.sweep(Assembly::Open);
    let formula = start.by_formula(0.0..=2.0, 41, |time| [Instant::constant(1.5) * time * time + time]);
    let given = start.over_time(0.0..=2.0, 41, |time| [Motion::polynomial(&[0.0, 1.0, 1.5], time)]);
    let (formula, given) = (formula.table().unwrap(), given.table().unwrap());
    for (one, other) in formula.columns().zip(given.columns()) {
        assert_eq!(one.label, other.label);
        let size = other.values.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
        for (one, other) in one.values.iter().zip(other.values) {
            assert!((one - other).abs() <= 1e-12 * size, "{}", one);
        }
    }
}

/// A coupled block is followed up to the end of its circuit, and does not close again behind it.
#[test]
fn a_coupled_block_stays_in_its_circuit() {
    let triad = triad();
    let leg = 5.0_f64.sqrt();
    // the platform stops where the legs are as short as they can be, and the sweep comes back at the end
    let sweep = triad
        .sweep(Near([0.1, 2.2, -2.0, 1.6]))
        .over_time(0.0..=1.0, 41, |time| {
            let legs = Motion::polynomial(&[leg, -6.0, 6.0], time);
            [legs, legs, legs]
        });
    let table = sweep.table().unwrap();
    let last = (0..41).find(|row| !table.outcome(*row).unwrap().is_solved()).unwrap();
    assert!(last > 1 && last < 20);
    assert!((last..41).all(|row| !table.outcome(row).unwrap().is_solved()));
    let [limit] = table.limits() else { panic!("one limit") };
    // the shortest legs are 2 - 1 long, where the platform has not rotated
    assert!((limit.inputs[0] - 1.0).abs() < 1e-9, "{limit:?}");
    for row in last..41 {
        let length = table.column("a").unwrap()[row];
        assert!((table.margin(row).unwrap() + (length - limit.inputs[0]).abs()).abs() < 1e-12);
    }
}

#[test]
fn several_inputs_and_columns() {
    let robot = FiveBar {
        ground: 2.0,
        left: 1.5,
        left_rod: 2.0,
        right_rod: 2.0,
        right: 1.5,
    };
    let line = robot
        .sweep(Assembly::Open)
        .between([1.0, 2.0], [2.0, 1.0], 11)
        .speed(3.0);
    let table = line.table().unwrap();
    let angles: Vec<f64> = table.column("alpha").unwrap().to_vec();
    let others: Vec<f64> = table.column("beta").unwrap().to_vec();
    let rates = |speed| Motion::<Column<'_>>::new([speed; 5].map(Column::Same));
    let (mut alpha, mut beta) = (rates(0.0), rates(0.0));
    (alpha[0], alpha[1]) = (Column::Each(&angles), Column::Same(3.0));
    (beta[0], beta[1]) = (Column::Each(&others), Column::Same(-3.0));
    let along = robot.sweep(Assembly::Open).along([alpha, beta]).table().unwrap();
    assert_eq!(along.variable().label.to_string(), "row");
    for name in ["hand.x", "hand.y_jerk", "phi_snap", "psi"] {
        assert_eq!(along.column(name).unwrap(), table.column(name).unwrap(), "{name}");
    }
    beta[0] = Column::Each(&others[1..]);
    let error = robot.sweep(Assembly::Open).along([alpha, beta]).table().unwrap_err();
    assert!(matches!(error, SweepError::Columns(mismatch) if mismatch.quantity == "beta" && mismatch.length == 10));
}

crate::mechanism! {
    /// A four-bar linkage with a direction.
    struct Directed { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Direction;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

#[test]
fn directions_are_columns_of_angles() {
    let directed: Directed = Directed {
        r1: 30.0,
        r2: 90.0,
        r3: 70.0,
        r4: 60.0,
    };
    let angles = FourBar::from_parameters(directed.parameters());
    let table = directed
        .sweep(Assembly::Open)
        .over(0.0..=TAU, 73)
        .speed(2.0)
        .table()
        .unwrap();
    let expected = angles
        .sweep(Assembly::Open)
        .over(0.0..=TAU, 73)
        .speed(2.0)
        .table()
        .unwrap();
    for name in ["theta3", "theta4", "theta4_velocity", "theta4_snap"] {
        let values = table.column(name).unwrap().iter().zip(expected.column(name).unwrap());
        for (one, other) in values {
            assert!((one - other).abs() < 1e-11, "{name}");
        }
    }
}

#[test]
fn adaptive_rows_are_within_the_tolerance() {
    let sweep = CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, 9).speed(10.0);
    let table = sweep.adaptive_table(1e-3, 4, 5000).unwrap();
    let variables = table.variable().values;
    for name in ["theta3", "theta4_velocity", "theta4_snap"] {
        let values = table.column(name).unwrap();
        let range = |values: &[f64]| {
            values.iter().copied().fold(f64::MIN, f64::max) - values.iter().copied().fold(f64::MAX, f64::min)
        };
        let dense = CRANK_ROCKER
            .sweep(Assembly::Open)
            .over(0.0..=TAU, 7200)
            .speed(10.0)
            .table()
            .unwrap();
        let mut row = 0;
        for (at, exact) in dense.variable().values.iter().zip(dense.column(name).unwrap()) {
            while variables[row + 1] < *at {
                row += 1;
            }
            let part = (at - variables[row]) / (variables[row + 1] - variables[row]);
            let line = values[row] + part * (values[row + 1] - values[row]);
            assert!((line - exact).abs() < 1.3e-3 * range(values), "{name} at {at}");
        }
    }
    let few = sweep.adaptive_table(1e-3, 4, 50).unwrap_err();
    assert!(matches!(few, SweepError::TooManyRows { most: 50, deviation, .. } if deviation > 1e-3));
    let all = sweep.adaptive_table(1e-3, 4, table.count()).unwrap();
    assert_eq!(all.count(), table.count());
    let one_less = sweep.adaptive_table(1e-3, 4, table.count() - 1).unwrap_err();
    assert!(matches!(one_less, SweepError::TooManyRows { .. }));
    let more = sweep.adaptive_table(1e3, 4, 8).unwrap_err();
    assert_eq!(more, SweepError::MoreRows { most: 8, rows: 9 });
    // the sides of a limit come close to it
    let table = LIMITED
        .sweep(Assembly::Open)
        .over(0.0..=3.0, 5)
        .adaptive_table(1e-2, 0, 500)
        .unwrap();
    let limit = &table.limits()[0];
    assert!(limit.at - table.variable().values[limit.row] < 3e-6);
    let few = LIMITED
        .sweep(Assembly::Open)
        .over(0.0..=3.0, 5)
        .adaptive_table(0.5, 0, 8)
        .unwrap_err();
    let SweepError::TooManyRowsAtLimit { most: 8, at } = few else {
        panic!("{few}")
    };
    assert!((at - limit.at).abs() < 0.2, "{few}");
}

/// Two rows of a full revolution hold the same pose, and say nothing of the range of a column.
#[test]
fn a_turn_in_two_rows_becomes_dense() {
    let sweep = |rows| CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, rows).speed(10.0);
    let [few, many] = [2, 25].map(|rows| sweep(rows).adaptive_table(1e-3, 2, 10_000).unwrap());
    assert!(
        few.count() > many.count() / 2 && few.count() < 2 * many.count(),
        "{} {}",
        few.count(),
        many.count()
    );
    // one row is all that one row can become
    assert_eq!(sweep(1).adaptive_table(1e-3, 2, 10_000).unwrap().count(), 1);
}

/// The unknowns of a limit are those at the limit, also where it is the end of a range.
#[test]
fn an_end_of_a_range_has_its_own_unknowns() {
    let inverse: Inverse = Inverse { factor: 1.0 };
    let table = inverse.sweep().over(0.0..=1.5, 4).table().unwrap();
    let [limit] = table.limits() else {
        panic!("{:?}", table.limits())
    };
    assert_eq!(limit.kind, LimitKind::End);
    assert!((limit.at - 1_f64.sin()).abs() < 1e-14, "{limit:?}");
    assert!((limit.unknowns[0] - 1.0).abs() < 1e-10, "{limit:?}");
}

crate::mechanism! {
    /// Kepler's equation, which has no closed form.
    struct Orbit { pub eccentricity: Scalar }
    input mean: Angle;
    unknown eccentric: Angle;
    eccentric - eccentricity * sin(eccentric) == mean;
}

/// The way of an angle is never too long, as a walk goes along it radian by radian.
#[test]
fn an_angle_may_turn_many_times_between_two_rows() {
    let orbit: Orbit = Orbit { eccentricity: 0.5 };
    let angle = 100.0 * TAU;
    let table = orbit.sweep(Near([0.0])).over(0.0..=angle, 2).table().unwrap();
    let eccentric = table.column("eccentric").unwrap()[1];
    assert!((eccentric - angle).abs() < 1e-9, "{eccentric}");
}

/// In one step of 3 radians the links of the other assembly are closer to the prediction, on another revolution.
#[test]
fn a_long_step_stays_in_its_assembly() {
    let linkage = GearedFiveBar {
        r1: 5.5638,
        r2: 1.9061,
        r3: 9.437,
        r4: 6.8059,
        r5: 8.8022,
        ratio: 1.8649,
        phase: 0.8278,
    };
    for k in 0..40 {
        let [from, to] = [9.5 - 0.05 * f64::from(k), 3.0 + 0.1 * f64::from(k)];
        let last = |rows: usize| {
            let table = linkage.sweep(Assembly::Crossed).over(from..=to, rows).table().unwrap();
            table.column("theta3").unwrap()[rows - 1]
        };
        let [coarse, fine] = [last(2), last(400)];
        assert!((coarse - fine).abs() <= 1e-9, "{from}..={to}: {coarse} {fine}");
    }
}

#[test]
fn mistakes_are_reported() {
    let start = CRANK_ROCKER.sweep(Assembly::Open);
    assert_eq!(start.over(0.0..=1.0, 0).table(), Err(SweepError::NoRows));
    let endless = start.over(0.0..=f64::INFINITY, 3).table().unwrap_err();
    assert!(matches!(endless, SweepError::NotFinite { quantity: "end", .. }));
    let tolerance = start.over(0.0..=1.0, 3).adaptive_table(0.0, 1, 10).unwrap_err();
    assert_eq!(tolerance, SweepError::Tolerance { value: 0.0 });
    let table = start.over(0.0..=1.0, 3).table().unwrap();
    let error = table.column("theta4_velocty").unwrap_err();
    assert_eq!(error.near[0], "theta4_velocity");
    let broken = FourBar {
        r1: f64::NAN,
        ..CRANK_ROCKER
    };
    let table = broken.sweep(Assembly::Open).over(0.0..=PI, 3).table().unwrap();
    assert_eq!(table.outcome(1), Some(Outcome::Failed));
}

/// Inputs that do not move, or that nobody knows, are no sweep. Rates of zero would be answers.
#[test]
fn speeds_and_lines_that_are_none_are_refused() {
    let sweep = |speed: f64| CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, 5).speed(speed);
    assert_eq!(sweep(0.0).table(), Err(SweepError::NoSpeed));
    assert_eq!(sweep(-0.0).of("theta4").peak(), Err(SweepError::NoSpeed.into()));
    assert!(SweepError::NoSpeed.to_string().contains("is zero"));
    for speed in [f64::NAN, f64::INFINITY] {
        let error = sweep(speed).table().unwrap_err();
        assert!(
            matches!(error, SweepError::NotFinite { quantity: "speed", .. }),
            "{error}"
        );
        assert!(sweep(speed).of("theta4").mean(crate::extremes::Over::Time).is_err());
        assert!(sweep(speed).adaptive_table(1e-2, 1, 100).is_err());
    }
    assert!(sweep(-3.0).table().is_ok());
    // also the inputs beside the first one that moves
    let robot = FiveBar {
        ground: 2.0,
        left: 1.5,
        left_rod: 2.0,
        right_rod: 2.0,
        right: 1.5,
    };
    for wrong in [f64::NAN, f64::NEG_INFINITY] {
        for ([from, to], quantity) in [
            ([[1.0, wrong], [2.0, 1.0]], "start"),
            ([[1.0, 2.0], [2.0, wrong]], "end"),
        ] {
            let error = robot.sweep(Assembly::Open).between(from, to, 5).table().unwrap_err();
            assert!(
                matches!(error, SweepError::NotFinite { quantity: named, .. } if named == quantity),
                "{error}"
            );
        }
    }
}

/// A mechanism does not jump from one position to another: its velocity would have no value.
#[test]
fn laws_that_jump_are_refused() {
    let rise = |from, to| Rise::new(Shape::Cycloidal, from, to, 1.0).unwrap();
    let [first, second] = [rise(0.0, 1.0), rise(2.0, 3.0)];
    let laws = Sequence::new([&first, &second]).unwrap();
    let under = |from: f64, to: f64| CRANK_ROCKER.sweep(Assembly::Open).under_laws([&laws], from..=to, 21);
    let jump = SweepError::Jump {
        input: "theta2".into(),
        is_angle: true,
        at: 1.0,
        by: 1.0,
    };
    assert_eq!(under(0.0, 2.0).table().unwrap_err(), jump);
    assert_eq!(under(2.0, 0.0).table().unwrap_err(), jump);
    assert_eq!(under(0.0, 2.0).of("theta4_velocity").peak().unwrap_err(), jump.into());
    assert_eq!(
        jump.to_string(),
        "the law of theta2 jumps by 1 rad (57.3°) at the time 1, and no mechanism does: let each law begin where the \
         one before ends"
    );
    // on either side there is no jump
    assert!(under(0.0, 1.0).table().is_ok() && under(1.0, 2.0).table().is_ok());
    // a law that repeats jumps at its end, in each cycle
    let saw = rise(0.0, 1.0).repeated();
    let again = |from: f64, to: f64| {
        CRANK_ROCKER
            .sweep(Assembly::Open)
            .under_laws([&saw], from..=to, 21)
            .table()
    };
    assert!(again(4.0, 5.0).is_ok());
    for (from, to, first) in [(4.5, 9.5, 5.0), (-3.5, 0.5, -3.0), (0.0, 1.5, 1.0)] {
        let error = again(from, to).unwrap_err();
        assert!(
            matches!(error, SweepError::Jump { at, by, .. } if at == first && by == -1.0),
            "{error}"
        );
    }
    // a crank that starts its next revolution at zero goes on
    let revolution = rise(0.0, TAU).repeated();
    assert!(
        CRANK_ROCKER
            .sweep(Assembly::Open)
            .under_laws([&revolution], 0.0..=3.0, 31)
            .table()
            .is_ok()
    );
    // a jump of velocity is none of the value
    let even = ConstantSpeed::new(0.0, 1.0, 1.0).unwrap();
    assert!(
        CRANK_ROCKER
            .sweep(Assembly::Open)
            .under_laws([&even], -1.0..=2.0, 31)
            .table()
            .is_ok()
    );
}

/// Code for any mechanism gives the assembly, whatever it is; a program with a mechanism of a single position gives
/// none.
#[test]
fn a_single_position_takes_no_assembly() {
    fn rows<M: Mechanism<Scalar = f64>>(mechanism: &M, assembly: M::Assembly) -> Table
    where
        M::Inputs<f64>: OneInput,
    {
        mechanism.sweep(assembly).over(0.0..=1.0, 11).table().unwrap()
    }
    let yoke = ScotchYoke { crank: 2.0, gamma: 1.5 };
    assert_eq!(yoke.sweep().over(0.0..=1.0, 11).table().unwrap(), rows(&yoke, ()));
    assert_eq!(rows(&CRANK_ROCKER, Assembly::Crossed).count(), 11);

    let loads = Loads::<ScotchYoke>::new()
        .inertia(0.5, |pose| pose.theta)
        .torque(-3.0, |pose| pose.x);
    let motion = Motion::from((0.7, 3.0, -2.0, 0.0, 0.0));
    let [effort] = yoke.balance(&loads, [motion]).unwrap().efforts();
    let [of_any] = Loaded::balance(&yoke, &loads, [motion], ()).unwrap().efforts();
    assert_eq!(effort.as_slice(), of_any.as_slice());
    let [acceleration] = yoke.accelerations(&loads, [0.7], [3.0], [effort.value()]).unwrap();
    assert!((acceleration + 2.0).abs() < 1e-13);
    assert_eq!(yoke.equivalent_inertia(&loads, [0.7]).unwrap().matrix, [[0.5]]);
    let mut found = [0.0; 2];
    let batch = yoke.batch(motion.map(Column::Same));
    let read = |balance: Result<Balance<ScotchYoke>, LoadError>| balance.unwrap().efforts()[0].value();
    batch.balance(&loads, read, &mut found).unwrap();
    assert_eq!(found, [effort.value(); 2]);
}

/// A column is found by its heading in a file, whose unit must be that of the table.
#[test]
fn columns_are_called_by_their_headings() {
    let table = CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=1.0, 3).table().unwrap();
    assert_eq!(table.column("theta4 [rad]"), table.column("theta4"));
    let error = table.column("theta4 [deg]").unwrap_err();
    assert_eq!(error.near[0], "theta4");
    assert!(
        std::format!("{error:?}").starts_with("none of the 15 columns is called `theta4 [deg]`: did you mean `theta4`")
    );
    let table = table.in_degrees().units("mm", "s");
    for column in table.columns() {
        let found = table.column(&column.to_string()).unwrap();
        assert_eq!(found, column.values, "{column}");
    }
    assert_eq!(table.column("theta4_jerk [deg/s³]"), table.column("theta4_jerk"));
}

#[test]
fn tables_are_text() {
    let table = CRANK_ROCKER
        .sweep(Assembly::Open)
        .over(0.0..=TAU, 361)
        .table()
        .unwrap()
        .in_degrees()
        .units("mm", "s");
    let text = table.to_string();
    let lines: Vec<&str> = text.lines().collect();
    assert!(
        lines[0].contains("theta2_acceleration") && lines[1].contains("deg/s²"),
        "{text}"
    );
    assert_eq!(lines.len(), 2 + 20 + 1 + 1);
    assert!(lines[12].contains('…'));
    assert!(lines[23].contains("361 rows, and 7 more columns"));
    assert_eq!(std::format!("{table:#}").lines().count(), 2 + 361);
    assert!(table.columns().any(|column| column.unit.to_string() == "deg/s⁴"));
}
