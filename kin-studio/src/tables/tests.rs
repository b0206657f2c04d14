//! Tables are read back as they were.

use kin_core::library::{FiveBar, FourBar};
use kin_core::prelude::*;
use kin_core::sweep::Table;
use serde_json::Value;

use super::Export;

/// A crank that comes as far as 112 degrees, in degrees.
fn limited() -> Table {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let sweep = linkage.sweep(Assembly::Open).over(-3.0..=3.0, 61).speed(10.0);
    sweep.table().unwrap().in_degrees().units("mm", "s")
}

fn same(one: f64, other: f64) -> bool {
    one == other || one.is_nan() && other.is_nan()
}

#[test]
fn csv_holds_every_number() {
    let table = limited();
    let csv = table.to_csv();
    let mut lines = csv.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!(head.len(), table.columns().len() + 2);
    assert_eq!(head[2], "theta2_acceleration [deg/s²]");
    let (mut row, mut limits) = (0, Vec::new());
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(cells.len(), head.len(), "{line}");
        let [values @ .., outcome, margin] = &cells[..] else {
            panic!("{line}")
        };
        let numbers: Vec<f64> = values.iter().map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
        if *outcome == "limit position" {
            // the row before is counted already
            limits.push((row - 1, numbers));
            continue;
        }
        for (column, number) in table.columns().zip(numbers) {
            assert!(same(column.values[row], number), "{} in row {row}", column.label);
        }
        assert_eq!(*outcome == "closes", table.outcome(row).unwrap().is_solved());
        assert_eq!(margin.parse().ok(), table.margin(row));
        row += 1;
    }
    assert_eq!(row, table.count());
    let [low, high] = &limits[..] else { panic!("{limits:?}") };
    for ((before, numbers), limit) in [low, high].into_iter().zip(table.limits()) {
        assert_eq!((*before, numbers[0]), (limit.row, limit.at));
        // theta2 and its rates, then theta3 and its rates, then theta4
        assert_eq!(numbers[10], limit.unknowns[1]);
        assert!(numbers[1..5].iter().all(|rate| rate.is_nan()));
    }
    assert!((high.1[0] - 112.0243).abs() < 5e-5);
}

#[test]
fn json_holds_every_number() {
    let table = limited();
    let json: Value = serde_json::from_str(&table.to_json()).unwrap();
    assert_eq!(json["variable"], "theta2");
    for (column, read) in table.columns().zip(json["columns"].as_array().unwrap()) {
        assert_eq!(read["name"], column.label.to_string());
        assert_eq!(read["unit"], column.unit.to_string());
        for (value, read) in column.values.iter().zip(read["values"].as_array().unwrap()) {
            assert!(same(read.as_f64().unwrap_or(f64::NAN), *value), "{}", column.label);
        }
    }
    for row in 0..table.count() {
        assert_eq!(json["margin"][row].as_f64(), table.margin(row));
        let closes = table.outcome(row).unwrap().is_solved();
        assert_eq!(json["outcome"][row] == "closes", closes);
    }
    let (limit, read) = (&table.limits()[1], &json["limits"][1]);
    assert_eq!(read["at"].as_f64(), Some(limit.at));
    assert_eq!(
        (&read["kind"], &read["closes"]),
        (&"limit position".into(), &"before".into())
    );
    assert_eq!(read["values"]["theta2"].as_f64(), Some(limit.at));
    assert_eq!(read["values"]["theta3"].as_f64(), Some(limit.unknowns[0]));
    assert_eq!(read["values"].as_object().unwrap().len(), 3);
}

/// Over time there is a column more, and a unit may hold a comma.
#[test]
fn time_is_a_column_and_texts_are_quoted() {
    let robot = FiveBar {
        ground: 2.0,
        left: 1.5,
        left_rod: 2.0,
        right_rod: 2.0,
        right: 1.5,
    };
    let sweep = robot.sweep(Assembly::Open).over_time(0.0..=1.0, 5, |t| {
        [Motion::polynomial(&[1.0, 0.2], t), Motion::polynomial(&[2.0], t)]
    });
    let csv = sweep.table().unwrap().units("m, rough", "s").to_csv();
    assert!(csv.starts_with("time [s],alpha [rad],"), "{csv}");
    assert!(csv.contains(",\"hand.x_velocity [m, rough/s]\","), "{csv}");
    assert!(csv.lines().nth(3).unwrap().starts_with("0.5,1.1,0.2,0.0,"), "{csv}");
}

#[test]
fn a_path_that_cannot_be_written_is_named() {
    let folder = std::env::temp_dir();
    let error = limited().write_csv(&folder).unwrap_err();
    assert!(error.to_string().contains(&*folder.to_string_lossy()), "{error}");
}
