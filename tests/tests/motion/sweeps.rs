//! Extremes of sweeps: against scans twenty times as dense, and at their places against the reference of 50 digits.

use core::f64::consts::TAU;

use kin_core::extremes::{Extreme, ExtremeKind};
use kin_core::library::{ClassThreeTriad, FourBar, SphericalFourBar, WhitworthQuickReturn};
use kin_core::prelude::*;
use kin_core::sweep::{StraightLine, Sweep};
use kin_core::track;
use kin_tests::reference::{Given, solution};

/// Rows of a sweep, and how many times as many the scan has.
const ROWS: usize = 60;
const DENSER: usize = if cfg!(feature = "every-case") { 20 } else { 6 };
/// As many units of error are allowed as anywhere: of rounding times condition.
const ALLOWED: f64 = 16.0;
const ORDERS: [&str; 5] = ["", "_velocity", "_acceleration", "_jerk", "_snap"];

/// The inputs of a mechanism whose inputs all move alike.
fn inputs<M: Mechanism>(at: f64, speed: f64) -> Vec<Vec<f64>> {
    M::DESCRIPTION
        .inputs
        .iter()
        .map(|_| vec![at, speed, 0.0, 0.0, 0.0])
        .collect()
}

/// Holds all extremes of every unknown against the scan and the reference. It returns their number.
fn hold<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    sweep: impl Fn(usize) -> Sweep<M, StraightLine>,
    speed: f64,
    is_turn: bool,
) -> usize {
    let dense = sweep((ROWS - 1) * DENSER + 1);
    let places: Vec<f64> = (0..dense.count()).map(|row| dense.at(row)).collect();
    let table = dense.table().expect("the range is finite");
    let mut count = 0;
    for (unknown, quantity) in M::DESCRIPTION.unknowns.iter().enumerate() {
        for (order, suffix) in ORDERS.iter().enumerate() {
            let name = format!("{}{suffix}", quantity.name);
            let values = table.column(&name).expect("it is a column");
            let extremes = sweep(ROWS).of(&name).extremes().expect("it closes");
            let inner: Vec<&Extreme> = extremes
                .iter()
                .filter(|extreme| extreme.kind == ExtremeKind::Inner)
                .collect();
            // each extreme of the scan lies next to one that was found, and there are no more
            let (first, last) = (values[0], values[values.len() - 1]);
            let is_closed = is_turn && (first - last).abs() < 1e-6 * first.abs().max(1.0);
            let turns = turns(values, is_closed);
            assert_eq!(
                inner.len(),
                turns.len(),
                "{} {name}: {inner:?} {turns:?}",
                M::DESCRIPTION.name
            );
            for extreme in &inner {
                let step = (places[1] - places[0]).abs();
                let is_near = |row: &usize| {
                    let distance = (places[*row] - extreme.at).abs();
                    distance < 2.0 * step || (is_turn && TAU - distance < 2.0 * step)
                };
                let row = turns.iter().copied().find(is_near);
                let row = row.unwrap_or_else(|| panic!("{name}: nothing at {}", extreme.at));
                let value = extreme.value.expect("it has a value");
                let size = values.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
                let is_outside = if extreme.is_maximum {
                    value >= values[row]
                } else {
                    value <= values[row]
                };
                assert!(
                    is_outside || (value - values[row]).abs() < 1e-12 * size,
                    "{name}: {value} {}",
                    values[row]
                );

                let given = Given {
                    parameters: mechanism.parameters().as_ref().to_vec(),
                    inputs: inputs::<M>(extreme.at, speed),
                };
                let position: Vec<f64> = (M::DESCRIPTION.unknowns.iter())
                    .map(|unknown| table.column(unknown.name).expect("it is a column")[row])
                    .collect();
                let exact = solution::<M>(&given, &position).expect("it closes");
                let (motions, conditions) = (&exact.motions[unknown], &exact.conditions[unknown]);
                let error = (motions[order].nearest() - value).abs();
                assert!(
                    error <= ALLOWED * f64::EPSILON * conditions[order],
                    "{name} at {}: {value} instead of {:?}, {} units",
                    extreme.at,
                    motions[order],
                    error / f64::EPSILON / conditions[order]
                );
                if let Some(slope) = motions.get(order + 1).map(kin_precise::Number::nearest) {
                    let next = table
                        .column(&format!("{}{}", quantity.name, ORDERS[order + 1]))
                        .expect("it is a column");
                    let beside = if row + 1 < next.len() { row + 1 } else { row - 1 };
                    // by how much the slope changes from one number to the next
                    let bend = (next[beside] - next[row]).abs() / step;
                    let allowed = conditions[order + 1] + bend * extreme.at.abs();
                    assert!(
                        slope.abs() <= ALLOWED * f64::EPSILON * allowed,
                        "{name} at {}: slope {slope}, {} units",
                        extreme.at,
                        slope.abs() / f64::EPSILON / allowed
                    );
                }
                count += 1;
            }
        }
    }
    count
}

/// The rows that stand out from their neighbours. The last row of a turn is the first one again.
fn turns(values: &[f64], is_turn: bool) -> Vec<usize> {
    let count = values.len() - usize::from(is_turn);
    let range = if is_turn { 0..count } else { 1..count - 1 };
    range
        .filter(|row| {
            let (before, own, after) = (
                values[(row + count - 1) % count],
                values[*row],
                values[(row + 1) % count],
            );
            (own > before) == (own > after)
        })
        .collect()
}

#[test]
fn extremes_of_plane_closed_forms() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 70.0,
        r4: 60.0,
    };
    let turn = |rows| linkage.sweep(Assembly::Open).over(0.0..=TAU, rows).speed(10.0);
    assert!(hold(&linkage, turn, 10.0, true) > 30);
    let press = WhitworthQuickReturn {
        ground: 0.05,
        crank: 0.1,
        arm: 0.15,
        rod: 0.5,
    };
    let turn = |rows| press.sweep(Assembly::Open).over(0.5..=0.5 + TAU, rows).speed(-5.0);
    hold(&press, turn, -5.0, true);
}

#[test]
fn extremes_in_space() {
    let linkage = SphericalFourBar {
        ground: 1.2,
        crank: 0.5,
        coupler: 1.1,
        rocker: 0.9,
    };
    let sweep = |rows| linkage.sweep(Assembly::Open).over(0.2..=5.0, rows).speed(2.0);
    assert!(hold(&linkage, sweep, 2.0, false) > 5);
}

#[test]
fn extremes_of_a_newton_block() {
    let root = 3.0_f64.sqrt();
    let triad = ClassThreeTriad {
        base_b: Plane::new(2.2 * root, 0.1),
        base_c: Plane::new(root, 3.0),
        platform_b: Plane::new(root, 0.0),
        platform_c: Plane::new(root / 2.0, 1.5),
    };
    let leg = 5.0_f64.sqrt();
    let begin = Mechanism::position_near(&triad, [leg; 3], [0.1, 2.2, -2.0, 1.6]).expect("it closes");
    let start = track(&triad, [leg; 3], begin, [1.6; 3]).expect("the legs come as far");
    let sweep = |rows| triad.sweep(Near(start)).between([1.6; 3], [2.6; 3], rows).speed(0.5);
    assert!(hold(&triad, sweep, 0.5, false) > 2);
}
