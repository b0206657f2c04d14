//! Tables against the solvers that they were made of.

use core::f64::consts::TAU;
use std::{println, vec, vec::Vec};

use super::read::{HEAD, VERSION, WORD, checksum};
use super::{ExactTable, ExactTableError, ExactTableRef, LookupError, Precision, ReadError};
use crate::assembly::{Assembly, Near};
use crate::geometry::{Plane, Space};
use crate::law::{Dwell, Rise, Sequence, Shape, Side};
use crate::library::{
    FiveBar, FourBar, JansenLeg, Rssr, SliderCrank, SphericalFourBar, StephensonI, StephensonIByDyad,
    WhitworthQuickReturn,
};
use crate::mechanism::{Mechanism, Pose};
use crate::motion::Motion;
use crate::number::{Number, Row, samples};
use crate::quantity::Dimension;
use crate::sweep::samples::{CRANK_ROCKER, LIMITED, triad};
use crate::sweep::{Instant, READ, SmoothDrive, Sweep, Swept};
use crate::verify::Random;

/// The number of random parameters of each table.
const TESTED: u32 = 1000;
/// Each derivative may lose two digits.
const GRADED: [f64; 5] = [1e-13, 1e-11, 1e-9, 1e-7, 1e-6];
/// Tolerances that rounding allows for harder motions.
const COARSE: [f64; 5] = [1e-11, 1e-9, 1e-7, 1e-6, 1e-5];

/// The difference of two angles, or of two other quantities.
fn difference(dimension: Dimension, one: f64, other: f64) -> f64 {
    let difference = one - other;
    if dimension == Dimension::Angle {
        difference - TAU * (difference / TAU).round()
    } else {
        difference
    }
}

/// Compares a table with the solver at random parameters, and returns it. No error may be larger than the one that the
/// table states.
fn compared<M: Mechanism<Scalar = f64>, D: SmoothDrive>(
    name: &str,
    sweep: &Sweep<M, D>,
    precision: impl Into<Precision>,
) -> ExactTable {
    let table = sweep
        .exact_table(precision)
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let mut random = Random::new(7);
    let (low, high) = (*table.range().start(), *table.range().end());
    let columns: Vec<_> = table.columns().collect();
    let mut worst: f64 = 0.0;
    let mut numbers = vec![0.0; columns.len() * 5];
    for _ in 0..samples::of(TESTED) {
        let at = random.between(low, high);
        let mut inputs = vec![0.0; M::DESCRIPTION.inputs.len() * READ];
        sweep.drive.derivatives(at, Side::Right, &mut inputs);
        let motions = Row::from_fn(|input| Row::from_fn(|order| inputs[input * READ + order]));
        table.fill(at, &mut numbers).unwrap();
        let unknowns = M::DESCRIPTION.unknowns;
        let value = |name: &str| numbers[5 * columns.iter().position(|column| column.name() == name).unwrap()];
        let pose = if M::ASSEMBLY_COUNT > 0 {
            sweep.mechanism.solve(motions, sweep.assembly)
        } else {
            let near = Row::from_fn(|unknown| value(unknowns[unknown].name));
            sweep.mechanism.solve_near(motions, near)
        };
        let pose = pose.unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut expected: Vec<(&str, Vec<f64>)> = Vec::new();
        for (input, motion) in M::DESCRIPTION.inputs.iter().zip(inputs.chunks_exact(READ)) {
            expected.push((input.name, (0..5).map(|order| motion[order]).collect()));
        }
        for (unknown, motion) in unknowns.iter().zip(pose.unknown_motions().as_ref()) {
            expected.push((unknown.name, motion.as_ref().to_vec()));
        }
        for (output, motion) in M::DESCRIPTION.outputs.iter().zip(pose.output_motions().as_ref()) {
            expected.push((output.name, motion.as_ref().to_vec()));
        }
        for (column, found) in columns.iter().zip(numbers.chunks(5)) {
            let known = expected.iter().find(|(name, _)| *name == column.name()).unwrap();
            for (order, stated) in column.errors().enumerate() {
                let dimension = if order == 0 {
                    column.dimension()
                } else {
                    Dimension::Scalar
                };
                let error = difference(dimension, found[order], known.1[order]).abs();
                assert!(
                    error <= stated,
                    "{name}: {} of order {order} at {at} is wrong by {error:e}, and {stated:e} is stated",
                    column.name()
                );
                worst = worst.max(error / stated);
            }
        }
    }
    println!(
        "{name}: {} rows, {} bytes, {:.0} % of the stated errors",
        table.rows(),
        table.as_bytes().len(),
        100.0 * worst
    );
    assert!(
        worst > 0.05,
        "{name}: the stated errors are far too large, or nothing was compared"
    );
    table
}

/// The larger of the stated errors of all columns.
fn stated(table: &ExactTable, order: usize) -> f64 {
    let errors = table.columns().filter_map(|column| column.errors().nth(order));
    errors.fold(0.0, f64::max)
}

/// Both angles of a revolution of a four-bar take few kilobytes.
#[test]
fn a_turn_of_a_four_bar_is_small() {
    let sweep = CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, 9);
    let table = compared("crank-rocker", &sweep, GRADED);
    assert!(stated(&table, 0) <= 1e-13, "{}", stated(&table, 0));
    assert!(table.as_bytes().len() < 7_000, "{}", table.as_bytes().len());
    assert_eq!(table.period(), Some(TAU));
    // it repeats itself; the coupler and the rocker make no revolutions
    let rocker = table.column("theta4").unwrap();
    for revolutions in [-3.0, 5.0] {
        let [one, other] = [1.0, 1.0 + revolutions * TAU].map(|at| rocker.at::<5>(at).unwrap());
        for (one, other) in one.into_iter().zip(other) {
            assert!((one - other).abs() < 1e-12, "{one} {other}");
        }
    }
    // the other assembly, downwards, from a parameter that is no zero
    let back = CRANK_ROCKER.sweep(Assembly::Crossed).over(1.0..=1.0 - TAU, 2);
    let table = compared("crossed crank-rocker", &back, GRADED);
    assert_eq!(*table.range().end(), 1.0);
    assert!(table.period().is_some());
    // its derivatives are those by the crank, whatever the speed
    assert_eq!(back.speed(7.0).exact_table(GRADED).unwrap(), table);
}

/// Links that make full revolutions are one further after each period.
#[test]
fn turns_go_on() {
    let drag_link = FourBar {
        r1: 30.0,
        r2: 80.0,
        r3: 70.0,
        r4: 90.0,
    };
    let sweep = drag_link.sweep(Assembly::Open).over(0.0..=TAU, 9);
    let table = compared("drag link", &sweep, GRADED);
    let rocker = table.column("theta4").unwrap();
    assert_eq!(rocker.increment(), TAU);
    let [[first], [third]] = [0.5, 0.5 + 2.0 * TAU].map(|at| rocker.at(at).unwrap());
    assert!((third - first - 2.0 * TAU).abs() < 1e-13);
    // and on: the table is closed
    let coupler = table.column("theta3").unwrap();
    assert!(coupler.at::<5>(1e6).is_ok() && coupler.at::<5>(-1e12).is_ok());
    // as long as numbers of this size distinguish one part of a period from another
    for at in [1e14, 1e300, f64::MAX] {
        for at in [at, -at] {
            let error = LookupError::TooManyPeriods { at, period: TAU };
            assert_eq!(coupler.at::<5>(at), Err(error));
            let near = drag_link.position_near(at, [at, at]);
            assert!(near.is_err() || at.abs() < 1e15, "{at}");
        }
    }
    let error = LookupError::TooManyPeriods { at: 1e300, period: TAU };
    let error = std::format!("{error}");
    assert!(error.contains("1e300") && error.contains("6.28"), "{error}");
}

/// Two tables with the same content have the same bytes.
#[test]
fn bytes_behind_names_are_zero() {
    let table = table().named("a name of an odd length").unwrap();
    let whole = table.as_bytes();
    let length = table.name().len() + table.parameter().0.len() + 3;
    let length = length + table.columns().map(|column| column.name().len() + 3).sum::<usize>();
    let padding = HEAD + length..(HEAD + length).next_multiple_of(WORD);
    assert!(!padding.is_empty());
    for index in padding {
        let mut bytes = whole.to_vec();
        assert_eq!(bytes[index], 0);
        bytes[index] = 1;
        resum(&mut bytes);
        assert!(matches!(
            ExactTable::from_bytes(bytes),
            Err(ReadError::Contradiction { .. })
        ));
    }
}

/// Stores the sum of the bytes before.
fn resum(bytes: &mut [u8]) {
    if let Some(end) = bytes.len().checked_sub(WORD) {
        let sum = checksum(&bytes[..end]);
        bytes[end..].copy_from_slice(&sum.to_le_bytes());
    }
}

/// Near a change point the rocker jerks, and the rows are close to each other there alone.
#[test]
fn rows_are_where_they_are_needed() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 100.0,
        r4: 40.5,
    };
    let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 9);
    let table = compared("near a change point", &sweep, COARSE);
    let parameters: Vec<f64> = table.parts().rows.iter().map(|row| row[0]).collect();
    let ways = parameters.windows(2).map(|pair| pair[1] - pair[0]);
    let (shortest, longest) = ways.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), way| {
        (low.min(way), high.max(way))
    });
    assert!(longest > 7.0 * shortest, "{longest} {shortest}");
}

/// Closed forms and Newton blocks, plane and space, lengths and angles, one input and several, with outputs.
#[test]
fn tables_of_all_kinds_of_mechanisms_are_as_exact_as_they_state() {
    let press = SliderCrank { r: 0.1, l: 0.3 };
    let sweep = press.sweep(Assembly::Open).over(0.0..=TAU, 9);
    let table = compared("slider-crank", &sweep, GRADED);
    assert_eq!(table.column("s").unwrap().dimension(), Dimension::Length);

    let walk = JansenLeg::HOLY_NUMBERS.sweep(JansenLeg::WALKING).over(0.0..=TAU, 13);
    let table = compared("Jansen's leg", &walk, COARSE);
    assert!(table.period().is_some());

    let whitworth = WhitworthQuickReturn {
        ground: 0.05,
        crank: 0.1,
        arm: 0.15,
        rod: 0.5,
    };
    compared(
        "quick return",
        &whitworth.sweep(Assembly::Open).over(0.0..=TAU, 9),
        COARSE,
    );

    // a Newton block with three inputs
    let start = [5.0_f64.sqrt(); 3];
    let platform = triad()
        .sweep(Near([0.1, 2.2, -2.0, 1.6]))
        .between(start, [2.6, 2.4, 2.3], 5);
    let table = compared("class III triad", &platform, COARSE);
    assert_eq!(table.period(), None);
    // the two other cylinders are columns
    assert_eq!(table.columns().len(), 2 + 4 + 2);

    let steering = Rssr {
        crank: 1.0,
        pivot: Space::new(3.0, 0.0, 0.0),
        axis: Space::new(0.0, 1.0, 0.0),
        arm: Space::new(0.0, 0.0, 2.0),
        rod: 13_f64.sqrt(),
    };
    compared("RSSR", &steering.sweep(Assembly::Open).over(0.0..=TAU, 9), COARSE);

    let globe = SphericalFourBar {
        ground: 1.4,
        crank: 0.5,
        coupler: 1.3,
        rocker: 1.2,
    };
    compared(
        "spherical four-bar",
        &globe.sweep(Assembly::Open).over(0.0..=TAU, 9),
        COARSE,
    );

    let robot = FiveBar {
        ground: 2.0,
        left: 1.5,
        left_rod: 2.0,
        right_rod: 2.0,
        right: 1.5,
    };
    compared(
        "five-bar",
        &robot.sweep(Assembly::Open).between([1.0, 2.0], [2.0, 1.0], 3),
        COARSE,
    );
}

/// Over time the inputs are columns, and where two pieces of a law meet there are two rows.
#[test]
fn motions_over_time_are_tables_as_well() {
    let rise = Rise::new(Shape::Cycloidal, 0.5, 2.0, 0.5).unwrap();
    let fall = Rise::new(Shape::Polynomial345, 2.0, 0.5, 0.25).unwrap();
    let laws = Sequence::new([&rise, &fall]).unwrap();
    let cam = CRANK_ROCKER.sweep(Assembly::Open).under_laws([&laws], 0.0..=0.75, 4);
    let table = compared("laws", &cam, COARSE);
    assert_eq!(table.parameter().0, "time");
    let parameters: Vec<f64> = table.parts().rows.iter().map(|row| row[0]).collect();
    assert_eq!(parameters.iter().filter(|at| **at == 0.5).count(), 2);
    let [_, _, _, before] = table.column("theta2").unwrap().at(0.5 - 1e-9).unwrap();
    let [_, _, _, behind] = table.column("theta2").unwrap().at(0.5).unwrap();
    assert!((before - behind).abs() > 1000.0, "{before} {behind}");

    let frequency = Instant::constant(2.0 * TAU);
    let swing = CRANK_ROCKER.sweep(Assembly::Open).by_formula(0.0..=0.5, 5, |time| {
        let (sine, _) = (frequency * time).sin_cos();
        [Instant::constant(1.0) + Instant::constant(0.5) * sine]
    });
    compared("swing", &swing, COARSE);
}

/// A table that ends with a lower order has pieces of a lower degree.
#[test]
fn lower_orders_make_smaller_rows() {
    let sweep = CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, 9);
    for order in 1..=4 {
        let table = sweep.exact_table(Precision::from(1e-5).up_to(order)).unwrap();
        assert_eq!(table.order(), order);
        let [rocker] = table.column("theta4").unwrap().at(2.0).unwrap();
        let pose = CRANK_ROCKER.solve([2.0, 1.0, 0.0, 0.0, 0.0], Assembly::Open).unwrap();
        assert!((rocker - pose.theta4.position()).abs() < 1e-5);
        let asked = table.column("theta4").unwrap().at::<6>(2.0);
        assert_eq!(asked, Err(LookupError::Orders { asked: 5, order }));
    }
}

/// The chain rule by a speed, and by a whole motion.
#[test]
fn tables_tell_motions_in_time() {
    let table = CRANK_ROCKER
        .sweep(Assembly::Open)
        .over(0.0..=TAU, 9)
        .exact_table(GRADED)
        .unwrap();
    let rocker = table.column("theta4").unwrap();
    let crank = Motion::from([2.0, -7.0, 11.0, -3.0, 5.0]);
    let pose = CRANK_ROCKER.solve(crank, Assembly::Open).unwrap();
    let derivatives = rocker.under(crank).unwrap().derivatives();
    let even = CRANK_ROCKER.solve([2.0, -7.0, 0.0, 0.0, 0.0], Assembly::Open).unwrap();
    let faster = rocker.at_speed::<5>(2.0, -7.0).unwrap();
    for order in 0..5 {
        // the errors of all orders up to this one, each with its power of the speed
        let allowed = 50.0 * stated(&table, order) * 7_f64.powi(i32::try_from(order).unwrap());
        assert!((derivatives[order] - pose.theta4.derivatives()[order]).abs() <= allowed);
        assert!((faster[order] - even.theta4.derivatives()[order]).abs() <= allowed);
    }
    assert_eq!(
        rocker.at_speed::<1>(2.0, f64::INFINITY),
        Err(LookupError::Speed { speed: f64::INFINITY })
    );
    assert!(matches!(rocker.at::<1>(f64::NAN), Err(LookupError::Beyond { .. })));
    let mut short = [0.0; 9];
    assert_eq!(
        table.fill(1.0, &mut short),
        Err(LookupError::Room { needed: 10, given: 9 })
    );
}

/// Wherever the circuit is entered, there is a table.
#[test]
fn a_circuit_may_be_entered_anywhere() {
    let count = samples::of(20);
    for sample in 0..count {
        let part = (f64::from(sample) + 0.5) / f64::from(count);
        let start = 3.91 * part - 1.955;
        let sweep = LIMITED.sweep(Assembly::Open).over(start..=start + 0.01, 2);
        let table = sweep
            .exact_circuit(1e-6)
            .unwrap_or_else(|error| panic!("{start}: {error}"));
        assert!(
            table.period().is_some() && table.rows() < 120,
            "{start}: {} rows",
            table.rows()
        );
    }
}

/// A circuit against four-bars that are driven by the angle that moves fastest, which the table does not do: with the
/// motion of that angle they find those of the others.
fn compared_circuit(name: &str, linkage: FourBar, start: f64) -> ExactTable {
    let FourBar { r1, r2, r3, r4 } = linkage;
    let circuit = linkage.sweep(Assembly::Open).over(start..=start + 0.1, 2);
    let table = circuit
        .exact_circuit(COARSE)
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let period = table.period().expect("it is closed");
    // r2 cis(theta2) + r3 cis(theta3) == r1 + r4 cis(theta4), driven by each of the angles, and the order of the angles
    // then
    let driven = [
        (linkage, [0, 1, 2]),
        (FourBar { r1, r2: r3, r3: r2, r4 }, [1, 0, 2]),
        (
            FourBar {
                r1: -r1,
                r2: r4,
                r3: -r3,
                r4: r2,
            },
            [2, 1, 0],
        ),
    ];
    let mut random = Random::new(11);
    let mut worst: f64 = 0.0;
    for _ in 0..samples::of(TESTED) {
        let at = random.between(0.0, period);
        let mut numbers = [[0.0; 5]; 3];
        for (column, numbers) in table.columns().zip(&mut numbers) {
            *numbers = column.at(at).unwrap();
        }
        let pace: f64 = numbers.iter().map(|motion| motion[1] * motion[1]).sum();
        assert!(
            (pace - 1.0).abs() <= 4.0 * stated(&table, 1),
            "{name}: the pace is {pace}"
        );
        let fastest = (0..3).max_by(|one, other| numbers[*one][1].abs().total_cmp(&numbers[*other][1].abs()));
        let (linkage, [drive, one, other]) = driven[fastest.unwrap()];
        let near = [numbers[one][0], numbers[other][0]];
        let pose = linkage.solve_near(Motion::from(numbers[drive]), near).unwrap();
        for (angle, found) in [(one, pose.theta3), (other, pose.theta4)] {
            for (order, (expected, found)) in numbers[angle].into_iter().zip(found.derivatives()).enumerate() {
                let dimension = if order == 0 {
                    Dimension::Angle
                } else {
                    Dimension::Scalar
                };
                let error = difference(dimension, expected, found).abs();
                worst = worst.max(error / stated(&table, order));
            }
        }
    }
    println!(
        "{name}: {} rows, {} bytes, arc {period}, {:.0} % of the stated errors",
        table.rows(),
        table.as_bytes().len(),
        100.0 * worst
    );
    assert!(worst <= 1.0, "{name}: {worst}");
    table
}

/// One closed table leads through both limits and both assemblies.
#[test]
fn circuits_lead_through_limits() {
    compared_circuit("double rocker from its middle", LIMITED, 0.0);
    let table = compared_circuit("double rocker", LIMITED, 0.9);
    let crank = table.column("theta2").unwrap();
    let limit = LIMITED.crank_range().unwrap().high;
    let period = table.period().unwrap();
    // the crank reverses where its rate vanishes
    let (mut limits, mut assemblies) = (0, [0, 0]);
    let mut before = crank.at::<2>(0.0).unwrap();
    for step in 1..=2000 {
        let at = period * f64::from(step) / 2000.0;
        let here = crank.at::<2>(at).unwrap();
        if here[1] * before[1] < 0.0 {
            // a secant's step to the limit
            let reversal = at - period / 2000.0 * here[1] / (here[1] - before[1]);
            let [highest, rate, bend] = crank.at(reversal).unwrap();
            let highest: f64 = highest - 0.5 * rate * rate / bend;
            assert!((highest.abs() - limit).abs() < 1e-10, "{highest} {limit}");
            limits += 1;
        }
        before = here;
        let unknowns = ["theta3", "theta4"].map(|name| table.column(name).unwrap().at::<1>(at).unwrap()[0]);
        let assembly = LIMITED.assembly_at(here[0], unknowns);
        assemblies[usize::from(assembly == Assembly::Open)] += 1;
    }
    assert_eq!(limits, 2);
    assert!(assemblies[0] > 500 && assemblies[1] > 500, "{assemblies:?}");

    // the coupler makes full revolutions, and its circuit has both assemblies as well
    let grashof = FourBar {
        r1: 90.0,
        r2: 80.0,
        r3: 30.0,
        r4: 60.0,
    };
    let table = compared_circuit("Grashof's double rocker", grashof, 0.9);
    assert_eq!(table.column("theta3").unwrap().increment().abs(), TAU);
    // without any limit
    let table = compared_circuit("crank-rocker as a circuit", CRANK_ROCKER, 0.0);
    assert_eq!(table.column("theta2").unwrap().increment(), TAU);
}

crate::mechanism! {
    /// A crank that a slider drives.
    struct Pump {
        crank: Length,
        rod: Length,
    }
    input s: Length;
    unknown theta: Angle, phi: Angle;

    crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
}

/// A slider leads a crank through both dead points, once around.
#[test]
fn a_slider_leads_a_crank_around() {
    let pump = Pump { crank: 0.3, rod: 0.8 };
    let table = pump
        .sweep(Assembly::Open)
        .over(0.9..=1.0, 2)
        .exact_circuit(COARSE)
        .unwrap();
    let crank = table.column("theta").unwrap();
    assert_eq!(crank.increment().abs(), TAU);
    let driven = SliderCrank { r: 0.3, l: 0.8 };
    let mut random = Random::new(17);
    for _ in 0..samples::of(TESTED) {
        let at = random.between(0.0, table.period().unwrap());
        let motion: [f64; 5] = crank.at(at).unwrap();
        // the solver of the crank knows the slider everywhere, and its input never reverses
        let pose = driven.solve(Motion::from(motion), Assembly::Open).unwrap();
        let slider = table.column("s").unwrap();
        let found: [f64; 5] = slider.at(at).unwrap();
        for (order, stated) in slider.errors().enumerate() {
            let error = (found[order].abs() - pose.s.derivatives()[order].abs()).abs();
            // that of the slider, and that of the crank, whose radius is less than half
            let allowed = stated + crank.errors().nth(order).unwrap();
            assert!(error <= allowed, "{order} at {at}: {error:e} {allowed:e}");
        }
    }
}

/// A circuit of a coupled block, against the same linkage driven by its crank, which has a closed form.
#[test]
fn coupled_blocks_are_led_through_limits() {
    let (p, q) = (Plane::new(0.5, 1.0), Plane::new(1.5, 1.0));
    let [r1, r2, r3, r4, r5, r6] = [4.0, 1.0, 3.0, 2.5, 2.5, 2.0];
    #[rustfmt::skip]
    let by_crank = StephensonI { r1, r2, r3, r4, p, q, r5, r6 };
    #[rustfmt::skip]
    let by_dyad = StephensonIByDyad { r1, r2, r3, r4, p, q, r5, r6 };
    let pose = by_crank
        .solve([1.0, 1.0, 0.0, 0.0, 0.0], StephensonI::ASSEMBLIES[0])
        .unwrap();
    let near = [pose.theta2, pose.theta3, pose.theta4, pose.theta6].map(|angle| angle.position());
    let start = pose.theta5.position();
    let drive = by_dyad.sweep(Near(near));
    compared("six-bar by its dyad", &drive.over(start..=start + 0.05, 2), COARSE);

    let table = drive.over(start..=start + 1.0, 2).exact_circuit(COARSE).unwrap();
    let period = table.period().unwrap();
    let columns = ["theta2", "theta3", "theta4", "theta5", "theta6"].map(|name| table.column(name).unwrap());
    // link 5 swings
    assert_eq!(columns[3].increment(), 0.0);
    let mut random = Random::new(19);
    let (mut worst, mut compared_count): (f64, u32) = (0.0, 0);
    for _ in 0..samples::of(TESTED) {
        let at = random.between(0.0, period);
        let found: [[f64; 5]; 5] = columns.map(|column| column.at(at).unwrap());
        let fastest = found
            .iter()
            .fold(0.0, |fastest: f64, motion| fastest.max(motion[1].abs()));
        if found[0][1].abs() < 0.5 * fastest {
            continue;
        }
        compared_count += 1;
        let near = [1, 2, 3, 4].map(|angle| found[angle][0]);
        let pose = by_crank.solve_near(Motion::from(found[0]), near).unwrap();
        let expected = [pose.theta3, pose.theta4, pose.theta5, pose.theta6];
        for (found, expected) in found[1..].iter().zip(expected) {
            for (order, (number, expected)) in found.iter().zip(expected.derivatives()).enumerate() {
                let dimension = if order == 0 {
                    Dimension::Angle
                } else {
                    Dimension::Scalar
                };
                let error = difference(dimension, *number, expected).abs();
                worst = worst.max(error / stated(&table, order));
            }
        }
    }
    println!(
        "six-bar as a circuit: {} rows, {} bytes, arc {period}, {compared_count} parameters, {:.0} % of the stated \
         errors",
        table.rows(),
        table.as_bytes().len(),
        100.0 * worst
    );
    // the error of an angle, and twice that of the crank
    assert!(
        5 * compared_count > samples::of(TESTED) && worst <= 3.0,
        "{compared_count}: {worst}"
    );
}

/// There is no table of a motion that ends, or of one that rounding spoils, and the error says why.
#[test]
fn refusals_say_why() {
    let beyond = LIMITED.sweep(Assembly::Open).over(0.0..=3.0, 9).exact_table(1e-5);
    let Err(error @ ExactTableError::NotClosed { .. }) = beyond else {
        panic!("{beyond:?}");
    };
    assert!(
        std::string::ToString::to_string(&error).contains("exact_circuit"),
        "{error}"
    );
    let sweep = CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, 9);
    let exact = sweep.exact_table(1e-12);
    let Err(ExactTableError::Unreached {
        order: 4, is_rounding, ..
    }) = exact
    else {
        panic!("{exact:?}");
    };
    assert!(is_rounding);
    let few = sweep.exact_table(Precision::from(1e-6).most_rows(20));
    let Err(ExactTableError::Unreached { is_rounding, rows, .. }) = few else {
        panic!("{few:?}");
    };
    assert!(!is_rounding && rows <= 21);
    assert!(matches!(
        sweep.exact_table(0.0),
        Err(ExactTableError::Tolerance { order: 0, .. })
    ));
    assert!(matches!(
        sweep.exact_table([1e-9, f64::NAN]),
        Err(ExactTableError::Tolerance { order: 1, .. })
    ));
    let nothing = CRANK_ROCKER.sweep(Assembly::Open).over(1.0..=1.0, 9).exact_table(1e-6);
    assert!(matches!(nothing, Err(ExactTableError::NoRange { .. })));
    // a parallelogram has change points where all links are in line
    let parallelogram = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 90.0,
        r4: 30.0,
    };
    let circuit = parallelogram
        .sweep(Assembly::Open)
        .over(0.5..=1.0, 2)
        .exact_circuit(1e-6);
    assert!(
        matches!(circuit, Err(ExactTableError::ChangePoint { .. })),
        "{circuit:?}"
    );
}

fn table() -> ExactTable {
    let sweep = CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, 9);
    sweep.exact_table(1e-4).unwrap()
}

#[test]
fn bytes_and_parts_come_back() {
    let table = table();
    assert_eq!(ExactTable::from_bytes(table.as_bytes()), Ok(table.clone()));
    assert_eq!(table.parts().table(), Ok(table.clone()));
    let named = table.named("a press of ours").unwrap();
    assert_eq!((named.name(), table.name()), ("a press of ours", "FourBar"));
    assert_eq!(named.parts().rows, table.parts().rows);
    for name in ["", "two\nlines"] {
        assert!(matches!(table.named(name), Err(ReadError::Contradiction { .. })));
    }
    let mut parts = table.parts();
    parts.rows[3][2] = f64::NAN;
    assert!(matches!(parts.table(), Err(ReadError::Contradiction { .. })));
    let mut parts = table.parts();
    parts.rows.swap(3, 4);
    assert!(matches!(parts.table(), Err(ReadError::Contradiction { .. })));
    let mut parts = table.parts();
    parts.rows[3].pop();
    assert!(matches!(parts.table(), Err(ReadError::Contradiction { .. })));
}

#[test]
fn newer_versions_are_refused() {
    let table = table();
    let mut bytes = table.as_bytes().to_vec();
    bytes[8] = 7;
    let found = 7;
    assert_eq!(
        ExactTable::from_bytes(bytes.clone()),
        Err(ReadError::Newer { found, known: VERSION })
    );
    let message = std::string::ToString::to_string(&ReadError::Newer { found, known: VERSION });
    assert!(
        message.contains("version 7") && message.contains("up to 1"),
        "{message}"
    );
    // also if the rest of it has another form
    bytes.truncate(12);
    assert_eq!(
        ExactTable::from_bytes(bytes),
        Err(ReadError::Newer { found, known: VERSION })
    );
    assert_eq!(ExactTableRef::new(b"{\"rows\": 3}"), Err(ReadError::NotATable));
}

/// Whatever bytes are read, there is an error or a table that can be read everywhere.
#[test]
fn damaged_bytes_are_errors() {
    let whole = table().as_bytes().to_vec();
    let mut random = Random::new(3);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "it is below the number of bytes"
    )]
    let mut below = |end: usize| random.between(0.0, end as f64) as usize;
    let (mut kinds, mut accepted) = ([0; 5], 0);
    for case in 0..20_000 {
        let mut bytes = whole.clone();
        for _ in 0..=below(3) {
            // the head has most of the decisions
            let end = if below(2) == 0 { 120 } else { bytes.len() };
            match below(6) {
                0 => bytes.truncate(below(end)),
                1 => bytes.insert(below(end.min(bytes.len() + 1)), u8::try_from(below(256)).unwrap()),
                2 if !bytes.is_empty() => {
                    bytes.remove(below(end.min(bytes.len())));
                }
                _ if !bytes.is_empty() => {
                    let index = below(end.min(bytes.len()));
                    bytes[index] = u8::try_from(below(256)).unwrap();
                }
                _ => {}
            }
        }
        // half of them with a sum that fits
        if case % 2 == 0 {
            resum(&mut bytes);
        }
        match ExactTableRef::new(&bytes) {
            Ok(table) => {
                let (low, high) = (*table.range().start(), *table.range().end());
                for at in [low, high, low + 0.3 * (high - low), 1e300] {
                    for column in table.columns() {
                        let _ = (column.at::<2>(at), column.name(), column.errors().count());
                    }
                }
                // bytes that still have their sum are those of the table
                assert!(case % 2 == 0 || bytes == whole);
                // and all that is read is in the parts
                let owned = ExactTable::from_bytes(bytes.clone()).unwrap();
                assert_eq!(owned.parts().table().unwrap().as_bytes(), bytes, "case {case}");
                accepted += usize::from(bytes != whole);
            }
            Err(error) => {
                let kind = match error {
                    ReadError::NotATable => 0,
                    ReadError::Newer { .. } => 1,
                    ReadError::Length { .. } => 2,
                    ReadError::Checksum { .. } => 3,
                    ReadError::Contradiction { .. } => 4,
                };
                kinds[kind] += 1;
            }
        }
    }
    assert!(kinds.iter().all(|count| *count > 20), "{kinds:?}");
    assert!(accepted > 500, "{accepted}");
}

/// Rounding may put a row, or an end of the range, beside a joint of a law.
#[test]
fn rows_beside_joints_stand_for_them() {
    let up = Rise::new(Shape::Cycloidal, 0.0, 1.0, 0.1).unwrap();
    let high = Dwell::new(1.0, 0.2).unwrap();
    let down = Rise::new(Shape::Cycloidal, 1.0, 0.0, 0.3).unwrap();
    let cam = Sequence::new([&up, &high, &down]).unwrap();
    let joint: f64 = 0.1 + 0.2;
    assert_ne!(joint, 0.3, "the row has another parameter than the joint");
    let start = SliderCrank { r: 0.1, l: 0.3 }.sweep(Assembly::Open);
    // to the last and from the next parameter beside a joint as well
    for range in [
        0.0..=0.6,
        0.6..=0.0,
        0.0..=joint.next_up(),
        joint.next_down()..=0.6,
        0.6..=joint.next_down(),
    ] {
        let sweep = start.under_laws([&cam], range.clone(), 7);
        let table = sweep
            .exact_table(1e-6)
            .unwrap_or_else(|error| panic!("{range:?}: {error}"));
        assert_eq!(*table.range().start(), range.start().min(*range.end()));
        assert_eq!(*table.range().end(), range.start().max(*range.end()));
        let rows: Vec<f64> = (0..table.rows())
            .filter_map(|row| table.reader().row_at(row)?.next())
            .collect();
        let is_near = |pair: &[f64]| pair[0] != pair[1] && (pair[1] - pair[0]).abs() < 1e-12;
        assert!(!rows.windows(2).any(is_near), "{rows:?}");
    }
}

#[test]
fn what_no_table_can_hold_is_refused_before_the_work() {
    let sweep = CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, 361);
    let values = Precision::from(1e-3).up_to(0);
    assert_eq!(sweep.exact_table(values), Err(ExactTableError::Order { asked: 0 }));
    assert_eq!(sweep.exact_circuit(values), Err(ExactTableError::Order { asked: 0 }));
    let few = sweep.exact_table(Precision::from(1e-3).most_rows(10));
    assert_eq!(few, Err(ExactTableError::MoreRows { most: 10, rows: 361 }));
    // as many rows as it takes, and one less
    let start = CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, 5);
    let rows = start.exact_table(1e-6).unwrap().rows();
    let table = start.exact_table(Precision::from(1e-6).most_rows(rows)).unwrap();
    assert_eq!(table.rows(), rows);
    assert!(start.exact_table(Precision::from(1e-6).most_rows(rows - 1)).is_err());
    let table = table.reader();
    assert!(table.row_at(rows).is_none() && table.row_at(usize::MAX).is_none());
}
