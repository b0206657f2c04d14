//! Every answer along a curve is that of the same curve: tables of any number of rows, extremes, crossings and means.
#![cfg(feature = "alloc")]

use core::f64::consts::TAU;
use std::format;
use std::vec::Vec;

use super::{ExtremesError, Over};
use crate::assembly::Assembly;
use crate::cycle::{Cycle, FullCycle};
use crate::library::{
    ClassThreeTriad, FiveBar, GearedFiveBar, InvertedSliderCrank, OffsetSliderCrank, Rssr, SphericalFourBar,
    StephensonIII, UniversalJoint, WattII, WhitworthQuickReturn,
};
use crate::mechanism::{JacobianMeasure, Mechanism, PoseOf};
use crate::number::{Row, samples};
use crate::quantity::{Dimension, Quantity};
use crate::sweep::{SmoothDrive, StraightLine, Sweep, Swept, Table};
use crate::verify::Random;

crate::mechanism! {
    /// A four-bar linkage with all that can depend on an angle: a rack on a pinion, a gear of half the speed,
    /// directions and differences.
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
const FINE: u32 = 4000;

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

/// The rows of a fine table in which the mechanism closes, as variables and values; rows that do not close divide it.
struct Fine {
    parts: Vec<Vec<[f64; 2]>>,
    size: f64,
    /// The largest change from row to row.
    step: f64,
}

impl Fine {
    fn of(table: &Table, name: &str) -> Self {
        let variables = table.variable().values;
        let mut parts = std::vec![std::vec![]];
        for (row, value) in table.column(name).unwrap().iter().enumerate() {
            let limits = table.limits().iter();
            if value.is_nan() || limits.clone().any(|limit| limit.row + 1 == row) {
                parts.push(std::vec![]);
            }
            if !value.is_nan() {
                parts.last_mut().unwrap().push([variables[row], *value]);
            }
        }
        parts.retain(|part: &Vec<[f64; 2]>| !part.is_empty());
        let values = parts.iter().flatten().map(|[_, value]| value.abs());
        let size = values.fold(0.0, f64::max);
        let pairs = parts.iter().flat_map(|part| part.windows(2));
        let step = pairs.map(|pair| (pair[1][1] - pair[0][1]).abs()).fold(0.0, f64::max);
        Self { parts, size, step }
    }

    fn extreme(&self, sign: f64) -> f64 {
        let values = self.parts.iter().flatten().map(|[_, value]| sign * value);
        sign * values.fold(f64::NEG_INFINITY, f64::max)
    }

    fn crossings(&self, level: f64) -> usize {
        let pairs = self.parts.iter().flat_map(|part| part.windows(2));
        pairs
            .filter(|pair| (pair[0][1] < level) != (pair[1][1] < level))
            .count()
    }

    /// The mean of a power by the trapezoid rule.
    fn mean(&self, power: i32) -> f64 {
        let pairs = self.parts.iter().flat_map(|part| part.windows(2));
        let (sum, length) = pairs.fold((0.0, 0.0), |(sum, length), pair| {
            let way = (pair[1][0] - pair[0][0]).abs();
            let value = 0.5 * (pair[0][1].powi(power) + pair[1][1].powi(power));
            (sum + way * value, length + way)
        });
        sum / length
    }

    /// The values on both sides of a variable, if the mechanism closes there.
    fn around(&self, at: f64) -> Option<[f64; 2]> {
        let pairs = self.parts.iter().flat_map(|part| part.windows(2));
        let is_between = |pair: &&[[f64; 2]]| {
            let (low, high) = (pair[0][0].min(pair[1][0]), pair[0][0].max(pair[1][0]));
            low <= at && at <= high
        };
        pairs.clone().find(is_between).map(|pair| [pair[0][1], pair[1][1]])
    }
}

/// Compares the answers to every question about a quantity with a fine table.
fn hold<M: Mechanism<Scalar = f64>, D: SmoothDrive>(name: &str, fine_table: &Table, rows: usize, sweep: &Sweep<M, D>) {
    let fine = Fine::of(fine_table, name);
    let context = || {
        let (mechanism, assembly, from, to) = (sweep.mechanism, sweep.assembly, sweep.from, sweep.to);
        format!("{mechanism:?}, {assembly:?} from {from} to {to}, {name}, {rows} rows")
    };
    // towards a limit a quantity is a root, whose steps grow from row to row
    let steps = if fine_table.limits().is_empty() { 1.0 } else { 4.0 };
    let slack = steps * fine.step + 1e-9 * fine.size;
    let table = sweep.table().unwrap();
    let mut compared = 0;
    for (row, value) in table.column(name).unwrap().iter().enumerate() {
        let Some([before, after]) = fine.around(sweep.at(row)).filter(|_| !value.is_nan()) else {
            continue;
        };
        compared += 1;
        let (low, high) = (before.min(after) - slack, before.max(after) + slack);
        assert!(
            (low..=high).contains(value),
            "{}, row {row}: {value} between {before} and {after}",
            context()
        );
    }
    assert!(compared > 0 || rows < 10, "{}", context());
    let column = sweep.of(name).column().unwrap();
    for (row, (value, expected)) in column.iter().zip(table.column(name).unwrap()).enumerate() {
        let is_same = (value - expected).abs() <= 1e-9 * fine.size.max(expected.abs());
        assert!(
            is_same || value.is_nan() && expected.is_nan(),
            "{}, row {row}: {value} in the column, {expected} in the table",
            context()
        );
    }
    let (lowest, highest) = match (sweep.of(name).lowest(), sweep.of(name).highest()) {
        (Ok(lowest), Ok(highest)) => (lowest.value, highest.value),
        // a rate at a limit
        (Err(ExtremesError::Unbounded { .. }), _) | (_, Err(ExtremesError::Unbounded { .. })) => return,
        other => panic!("{}: {other:?}", context()),
    };
    let (low, high) = (fine.extreme(-1.0), fine.extreme(1.0));
    let rounding = 1e-9 * fine.size;
    assert!(
        lowest <= low + rounding && low - slack <= lowest,
        "{}: lowest {lowest}, in the table {low}",
        context()
    );
    assert!(
        highest >= high - rounding && high + slack >= highest,
        "{}: highest {highest}, in the table {high}",
        context()
    );
    let extremes = sweep.of(name).extremes().unwrap();
    assert!(
        extremes
            .iter()
            .all(|extreme| (lowest..=highest).contains(&extreme.value.unwrap())),
        "{}",
        context()
    );
    let level = low + 0.37 * (high - low);
    if high - low > 1e-6 * fine.size {
        let mut crossings = sweep.of(name).crossings(level).unwrap();
        // between a limit and the row next to it, the table does not know
        crossings.retain(|crossing| fine.around(crossing.at).is_some());
        assert_eq!(crossings.len(), fine.crossings(level), "{}: {crossings:?}", context());
        if fine.parts.len() == 1 {
            assert!(
                crossings.windows(2).all(|pair| pair[0].is_rising != pair[1].is_rising),
                "{}",
                context()
            );
        }
    }
    let mean = sweep
        .of(name)
        .mean(Over::Time)
        .unwrap_or_else(|error| panic!("{}: {error}", context()));
    let square = sweep
        .of(name)
        .rms(Over::Time)
        .unwrap_or_else(|error| panic!("{}: {error}", context()));
    // what lies between the last rows and the limits
    let parts = u32::try_from(fine.parts.len()).unwrap();
    let missing = 4.0 * f64::from(parts) / f64::from(FINE) * fine.size;
    for (value, expected) in [(mean.value, fine.mean(1)), (square.value, fine.mean(2).sqrt())] {
        assert!(
            (value - expected).abs() <= slack + missing,
            "{}: mean {value} instead of {expected}",
            context()
        );
    }
}

/// Whether the mechanism closes along the sweep, so that there is something to compare.
fn hold_all<M: Mechanism<Scalar = f64>, D: SmoothDrive>(rows: &[usize], sweep: impl Fn(usize) -> Sweep<M, D>) -> bool {
    let description = M::DESCRIPTION;
    let fine = sweep(FINE as usize + 1).table().unwrap();
    if fine
        .column(description.unknowns[0].name)
        .unwrap()
        .iter()
        .filter(|value| !value.is_nan())
        .count()
        < 10
    {
        return false;
    }
    for rows in rows {
        let sweep = sweep(*rows);
        for quantity in description.unknowns.iter().chain(description.outputs) {
            let suffixes: &[&str] = if samples::are_all() { &["", "_velocity"] } else { &[""] };
            for suffix in suffixes {
                hold(&format!("{}{suffix}", quantity.name), &fine, *rows, &sweep);
            }
        }
    }
    true
}

/// In a double crank the rocker makes full revolutions, in one revolution of the crank or two, whatever hangs on it.
#[test]
fn all_answers_about_a_double_crank_agree() {
    let rows: &[usize] = if samples::are_all() { &[2, 361] } else { &[361] };
    hold_all(rows, |rows| DOUBLE_CRANK.sweep(Assembly::Open).over(0.0..=TAU, rows));
    let rows: &[usize] = if samples::are_all() { &[3, 37] } else { &[3] };
    hold_all(rows, |rows| {
        DOUBLE_CRANK.sweep(Assembly::Crossed).over(-1.0..=2.0 * TAU, rows)
    });
}

#[test]
fn all_answers_about_a_crank_rocker_agree() {
    hold_all(&[7], |rows| {
        CRANK_ROCKER.sweep(Assembly::Crossed).over(0.3..=0.3 + TAU, rows)
    });
}

#[test]
fn all_answers_about_a_quick_return_agree() {
    let linkage = WhitworthQuickReturn {
        ground: 0.05,
        crank: 0.12,
        arm: 0.15,
        rod: 0.5,
    };
    hold_all(&[7], |rows| linkage.sweep(Assembly::Open).over(0.0..=TAU, rows));
}

/// Random links with random ranges: cranks, rockers, gaps, several revolutions and whole-numbered change points.
#[test]
fn all_answers_about_random_linkages_agree() {
    let mut random = Random::new(7);
    for sample in 0..samples::some_of(2, 30) {
        let mut length = || {
            let length = random.between(1.0, 10.0);
            if sample % 3 == 0 { length.round() } else { length }
        };
        let linkage = Geared {
            r1: length(),
            r2: length(),
            r3: length(),
            r4: length(),
            pinion: length(),
        };
        let from = random.between(-4.0, 4.0);
        let to = from + random.between(0.5, 14.0);
        let assembly = Assembly::BOTH[(sample % 2) as usize];
        hold_all(&[2, 3, 7, 37, 361][(sample % 5) as usize..][..1], |rows| {
            linkage.sweep(assembly).over(from..=to, rows)
        });
    }
}

/// A mechanism of random dimensions along a random line of its inputs, in one of its positions.
fn hold_random<M: Mechanism<Scalar = f64, Pose: PoseOf<M>>>(random: &mut Random, rows: usize) -> bool {
    let mut value = |quantity: &Quantity<'_>| match quantity.dimension {
        Dimension::Length => random.between(1.0, 10.0),
        Dimension::Angle => random.between(0.2, 1.4),
        Dimension::Scalar => random.between(0.5, 2.0),
    };
    let mechanism = M::from_parameters(Row::from_fn(|index| value(&M::DESCRIPTION.parameters[index])));
    let from = M::Inputs::from_fn(|index| value(&M::DESCRIPTION.inputs[index]));
    let to = M::Inputs::from_fn(|index| {
        let way = match M::DESCRIPTION.inputs[index].dimension {
            Dimension::Angle => random.between(-3.0, 9.0),
            _ => random.between(-2.0, 2.0),
        };
        from[index] + way
    });
    let mut assembly = None;
    // the solver refuses no finite inputs
    let _ = mechanism.positions_at(from, |found, unknowns| {
        // of a position without a name, the unknowns
        let found = if M::ASSEMBLY_COUNT > 0 {
            found
        } else {
            mechanism.assembly_at(from, unknowns)
        };
        assembly = Some(found);
    });
    assembly.is_some_and(|assembly| {
        hold_jacobian(&mechanism, &mechanism.sweep(assembly).between(from, to, rows));
        hold_all(&[rows], |rows| mechanism.sweep(assembly).between(from, to, rows))
    })
}

/// The singular value of one result along a sweep is that of the poses in its rows.
fn hold_jacobian<M: Mechanism<Scalar = f64, Pose: PoseOf<M>>>(mechanism: &M, sweep: &Sweep<M, StraightLine>) {
    let result = [M::DESCRIPTION.unknowns[0].name];
    let column = match sweep
        .of_jacobian(&result, JacobianMeasure::LargestSingularValue)
        .column()
    {
        Err(ExtremesError::Jacobian(_)) => return,
        column => column.unwrap(),
    };
    for (row, (pose, value)) in sweep.rows().zip(column).enumerate() {
        let Ok(expected) = pose.map(|pose| mechanism.jacobian_of(&pose, &result)) else {
            assert!(value.is_nan(), "{mechanism:?}, row {row}: {value}");
            continue;
        };
        let Ok(expected) = expected.map(|jacobian| jacobian.singular_values()[0]) else {
            continue;
        };
        assert!(
            (value - expected).abs() <= 1e-9 * expected.abs().max(1e-6),
            "{mechanism:?}, row {row}: {value} along the sweep, {expected} of the pose"
        );
    }
}

/// Closed and coupled, in the plane and in space, with gears, sliders and change points. `KIN_CONSISTENCY=500` draws
/// 500 of them.
#[test]
fn all_answers_about_random_mechanisms_agree() {
    let mut random = Random::new(11);
    let given = std::env::var("KIN_CONSISTENCY").ok();
    let count = given.map_or(samples::of(40), |count| count.parse().unwrap());
    let mut compared = 0;
    for sample in 0..count {
        let rows = [2, 3, 7, 37, 361][(sample % 5) as usize];
        let closes = match sample % 10 {
            0 => hold_random::<GearedFiveBar>(&mut random, rows),
            1 => hold_random::<InvertedSliderCrank>(&mut random, rows),
            2 => hold_random::<OffsetSliderCrank>(&mut random, rows),
            3 => hold_random::<SphericalFourBar>(&mut random, rows),
            4 => hold_random::<Rssr>(&mut random, rows),
            5 => hold_random::<WattII>(&mut random, rows),
            6 => hold_random::<ClassThreeTriad>(&mut random, rows),
            7 => hold_random::<UniversalJoint>(&mut random, rows),
            8 => hold_random::<FiveBar>(&mut random, rows),
            _ => hold_random::<StephensonIII>(&mut random, rows),
        };
        compared += u32::from(closes);
    }
    std::println!("{compared} of {count} close");
    assert!(compared > count / 4, "{compared}");
}

fn quantities() -> impl Iterator<Item = &'static str> {
    let unknowns = Geared::<f64>::DESCRIPTION.unknowns.iter();
    unknowns
        .chain(Geared::<f64>::DESCRIPTION.outputs)
        .map(|quantity| quantity.name)
}

/// The worst transmission angle of a circuit is the lowest one of the sweeps over its branches.
fn hold_transmission(linkage: &Geared, cycle: &Cycle<Geared>, circuit: usize) {
    let worst = cycle.along(circuit).worst_transmission().unwrap();
    let mut least = f64::INFINITY;
    for branch in cycle.circuits()[circuit].branches() {
        let branch = &cycle.branches()[*branch];
        let [low, high] = branch.ends().each_ref().map(|end| end.input);
        let sweep = linkage
            .sweep(Assembly::BOTH[branch.assembly().unwrap()])
            .over(low..=high, 37);
        let lowest = sweep
            .of_expression(|at| at.transmission_angle(0).unwrap().folded())
            .lowest();
        match lowest {
            // a range that ends beyond a limit by rounding
            Err(ExtremesError::Gap { .. }) => return,
            lowest => least = least.min(lowest.unwrap().value),
        }
    }
    // at a limit the angle is a root of the variable, whose rounding is a part of ε
    let tolerance = if worst.angle == 0.0 {
        8.0 * f64::EPSILON.sqrt()
    } else {
        1e-9
    };
    assert!(
        (worst.angle - least).abs() <= tolerance,
        "{linkage:?}, {circuit}: {worst:?}, in the sweeps {least}"
    );
}

/// The stroke of a cycle is the range of a revolution, or of both branches between two limits. Rotated by half a
/// revolution, a linkage has the same strokes, although the angles jump elsewhere.
#[test]
fn strokes_are_those_of_sweeps() {
    let mut random = Random::new(8);
    let mut seen = [0; 2];
    for sample in 0..samples::of(30) {
        let mut length = || random.between(1.0, 10.0);
        let linkage = match sample {
            0 => DOUBLE_CRANK,
            1 => CRANK_ROCKER,
            _ => Geared {
                r1: length(),
                r2: length(),
                r3: length(),
                r4: length(),
                pinion: length(),
            },
        };
        let rotated = Geared::from_parameters([-linkage.r1, -linkage.r2, -linkage.r3, -linkage.r4, linkage.pinion]);
        let [cycle, rotated] = [linkage, rotated].map(|linkage| linkage.cycle().unwrap());
        assert_eq!(cycle.circuits().len(), rotated.circuits().len(), "{linkage:?}");
        for index in 0..cycle.circuits().len() {
            hold_transmission(&linkage, &cycle, index);
        }
        // each quantity in every third linkage
        for (_, name) in (sample..).zip(quantities()).filter(|(index, _)| index % 3 == 0) {
            let mut lengths = [std::vec![], std::vec![]];
            for (index, circuit) in cycle.circuits().iter().enumerate() {
                let stroke = cycle.along(index).of(name).stroke().unwrap();
                // a sweep whose range ends beyond a limit by rounding may refuse an answer, and says so
                let ranges = circuit.branches().iter().filter_map(|branch| {
                    let branch = &cycle.branches()[*branch];
                    let [low, high] = branch.ends().each_ref().map(|end| end.input);
                    let sweep = linkage
                        .sweep(Assembly::BOTH[branch.assembly().unwrap()])
                        .over(low..=high, 37);
                    let extremes = match sweep.of(name).extremes() {
                        Err(ExtremesError::Gap { .. }) => return None,
                        extremes => extremes.unwrap(),
                    };
                    let values = extremes.into_iter().filter_map(|extreme| extreme.value);
                    Some(values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
                        [low.min(value), high.max(value)]
                    }))
                });
                let ranges: Vec<[f64; 2]> = ranges.collect();
                let is_whole = ranges.len() == circuit.branches().len();
                seen[circuit.branches().len() - 1] += u32::from(is_whole);
                let tolerance = 1e-6 * stroke.length().max(1.0);
                let longest = ranges
                    .iter()
                    .fold(0.0, |longest: f64, [low, high]| longest.max(high - low));
                let whole: f64 = ranges.iter().map(|[low, high]| high - low).sum();
                assert!(
                    longest - tolerance <= stroke.length() && (!is_whole || stroke.length() <= whole + tolerance),
                    "{linkage:?}, {name}: {stroke:?}, {ranges:?}"
                );
                lengths[0].push(stroke.length());
                lengths[1].push(rotated.along(index).of(name).stroke().unwrap().length());
            }
            // half an angle, rotated by half a revolution, has another sine
            if name == "tooth" {
                continue;
            }
            for lengths in &mut lengths {
                lengths.sort_by(f64::total_cmp);
            }
            for (one, other) in lengths[0].iter().zip(&lengths[1]) {
                assert!(
                    (one - other).abs() <= 1e-6 * one.max(1.0),
                    "{linkage:?}, {name}: {lengths:?}"
                );
            }
        }
    }
    assert!(seen.iter().all(|count| *count > 2), "{seen:?}");
}
