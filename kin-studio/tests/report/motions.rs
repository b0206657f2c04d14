//! Pages of several inputs and of motion laws agree with tables and extremes of sweeps.

use std::f64::consts::TAU;

use kin_core::extremes::Over;
use kin_core::law::{
    ConstantSpeed, Dwell, Fourier, Law, Limits, Piecewise, Polynomial, Rise, SCurve, Scca, Sequence, Shape,
};
use kin_core::library::{FiveBar, FourBar, SliderCrank};
use kin_core::prelude::*;
use kin_core::sweep::{SweepError, Table};
use kin_studio::report::{Drive, FORMAT, Report, ReportError, Side, Variable};

use super::{CRANK_ROCKER, triad};

const ROBOT: FiveBar = FiveBar {
    ground: 2.0,
    left: 0.5,
    left_rod: 2.0,
    right_rod: 2.0,
    right: 1.5,
};
const PRESS: SliderCrank = SliderCrank { r: 0.1, l: 0.3 };
const RATES: [&str; 5] = ["", "_velocity", "_acceleration", "_jerk", "_snap"];

/// An input with its rates, as the page reads it.
fn motion(report: &Report, input: usize, at: f64) -> [f64; 5] {
    let Drive { pieces, .. } = &report.drive;
    let piece = pieces.iter().rev().find(|piece| piece.from <= at).unwrap_or(&pieces[0]);
    let terms = &piece.inputs[input];
    std::array::from_fn(|order| {
        let powers = terms.iter().enumerate().skip(order).rev();
        let sum = powers.fold(0.0, |sum, (power, term)| {
            let factor: f64 = (0..order)
                .map(|below| f64::from(u32::try_from(power - below).unwrap()))
                .product();
            sum * (at - piece.at) + factor * term
        });
        sum * report.speed.powi(i32::try_from(order).unwrap())
    })
}

/// The inputs of the page are those of a table, and its extremes and means those of a sweep.
fn agrees(report: &Report, table: &Table, inputs: &[&str], extremes: &dyn Fn(&str) -> [f64; 3]) {
    let times = table.variable().values;
    for (input, name) in inputs.iter().enumerate() {
        for (order, rate) in RATES.iter().enumerate() {
            let column = table.column(&format!("{name}{rate}")).unwrap();
            let size = column.iter().fold(1e-300, |size: f64, value| size.max(value.abs()));
            // at a joint a table has one of the two values, which need not be that of the later piece
            let is_joint = |at: f64| report.drive.joints.iter().any(|joint| (joint.at - at).abs() < 1e-12);
            for (at, value) in times.iter().zip(column).filter(|(at, _)| !is_joint(**at)) {
                let found = motion(report, input, *at)[order];
                assert!(
                    (found - value).abs() <= 1e-11 * size,
                    "{name}{rate} at {at}: {found} {value}"
                );
            }
        }
    }
    for extreme in &report.extremes {
        let name = format!("{}{}", extreme.quantity, RATES[extreme.order]);
        let [lowest, highest, _] = extremes(&name);
        let wanted = if extreme.kind == Side::Highest { highest } else { lowest };
        let size = lowest.abs().max(highest.abs());
        match extreme.value {
            Some(value) => assert!((value - wanted).abs() <= 1e-10 * size, "{name}: {value} {wanted}"),
            None => assert!(wanted.is_infinite(), "{name}: {wanted}"),
        }
    }
    for mean in &report.rms {
        let name = format!("{}{}", mean.quantity, RATES[mean.order]);
        let [.., wanted] = extremes(&name);
        let value = mean.value.unwrap_or(f64::INFINITY);
        assert!(
            value == wanted || (value - wanted).abs() <= 1e-10 * wanted,
            "{name}: {value} {wanted}"
        );
    }
    assert!(report.unanswered.is_empty(), "{:?}", report.unanswered);
}

/// The lowest and the highest value and the root mean square of a quantity; infinite without bound.
macro_rules! answers {
    ($sweep:expr) => {
        |name: &str| {
            let quantity = $sweep.of(name);
            let unbounded = |is_maximum: bool| {
                let all = quantity.extremes().unwrap();
                all.iter()
                    .any(|one| one.value.is_none() && one.is_maximum == is_maximum)
            };
            let lowest = if unbounded(false) {
                f64::NEG_INFINITY
            } else {
                quantity.lowest().unwrap().value
            };
            let highest = if unbounded(true) {
                f64::INFINITY
            } else {
                quantity.highest().unwrap().value
            };
            let rms = quantity.rms(Over::Time).map_or(f64::INFINITY, |mean| mean.value);
            [lowest, highest, rms]
        }
    };
}

#[test]
fn laws_are_those_of_sweeps() {
    let quarter = 90_f64.to_radians();
    let rise = Rise::new(Shape::ModifiedSine, 0.0, quarter, 0.4).unwrap();
    let dwell = Dwell::new(quarter, 0.1).unwrap();
    let back = Rise::new(Shape::Polynomial345, quarter, 0.0, 0.3).unwrap();
    let servo = Sequence::new([&rise, &dwell, &back]).unwrap();
    let draft = kin_studio::report(&CRANK_ROCKER).under_laws([&servo], 0.0..=0.8);
    let report = draft.report().unwrap();
    assert_eq!(
        (report.drive.variable, report.range, report.speed),
        (Variable::Time, [0.0, 0.8], 1.0)
    );
    assert_eq!(
        (report.period, report.cycle.is_none(), report.inputs[0].value),
        (None, true, None)
    );
    // the input is plotted with what it moves
    assert_eq!(report.plots, ["theta3", "theta4", "theta2"]);
    assert_eq!(report.assemblies.len(), 2);
    let sweep = CRANK_ROCKER.sweep(Assembly::Open).under_laws([&servo], 0.0..=0.8, 65);
    agrees(&report, &sweep.table().unwrap(), &["theta2"], &answers!(sweep));
    // the pieces of the modified sine jump in their snap, and the polynomial begins with a jerk
    let orders: Vec<usize> = report.drive.joints.iter().map(|joint| joint.order).collect();
    assert_eq!(orders, [4, 4, 3, 3]);
    assert!((report.drive.joints[2].at - 0.4).abs() < 1e-15);
    // it is data
    assert_eq!(Report::from_json(&report.to_json()).unwrap(), report);
}

#[test]
fn laws_of_several_inputs() {
    let left = Rise::new(Shape::Cycloidal, 0.0, 2.0, 0.5).unwrap();
    let right = Rise::new(Shape::ConstantSpeed, 1.0, 1.6, 0.25).unwrap();
    let draft = kin_studio::report(&ROBOT).under_laws([&left, &right], 0.0..=0.6);
    let report = draft.report().unwrap();
    let joints: Vec<(f64, usize)> = report
        .drive
        .joints
        .iter()
        .map(|joint| (joint.at, joint.order))
        .collect();
    assert_eq!(joints, [(0.25, 1), (0.5, 3)]);
    let sweep = ROBOT.sweep(Assembly::Open).under_laws([&left, &right], 0.0..=0.6, 49);
    agrees(&report, &sweep.table().unwrap(), &["alpha", "beta"], &answers!(sweep));
    // an input that stands has its value, and a reader may change it
    let dwell = Dwell::new(1.25, 0.5).unwrap();
    let draft = kin_studio::report(&ROBOT).under_laws([&left, &dwell], 0.0..=0.5);
    let report = draft.report().unwrap();
    assert_eq!(
        report.inputs.iter().map(|input| input.value).collect::<Vec<_>>(),
        [None, Some(1.25)]
    );
    assert_eq!(report.moving, 0);
}

#[test]
fn lines_are_those_of_sweeps() {
    for (from, to, speed) in [
        ([0.0, 1.0], [2.0, 1.6], 3.0),
        ([2.0, 1.6], [0.0, 1.0], 3.0),
        ([0.3, 1.6], [0.3, 1.0], 0.5),
    ] {
        let draft = kin_studio::report(&ROBOT).between(from, to).speed(speed);
        let report = draft.report().unwrap();
        let lead = usize::from(from[0] == to[0]);
        let [low, high] = [from[lead].min(to[lead]), from[lead].max(to[lead])];
        assert_eq!(
            (report.drive.variable, report.range, report.moving),
            (Variable::Input, [low, high], lead)
        );
        assert_eq!(report.speed, speed * (to[lead] - from[lead]).signum());
        assert_eq!(report.drive.pieces.len(), 1);
        let sweep = ROBOT.sweep(Assembly::Open).between(from, to, 41).speed(speed);
        agrees(&report, &sweep.table().unwrap(), &["alpha", "beta"], &answers!(sweep));
        assert!(report.cycle.is_some());
    }
    // a line of one input is that of the wishes for one input
    let one = kin_studio::report(&ROBOT).between([0.0, 1.0], [2.0, 1.0]).speed(3.0);
    let other = kin_studio::report(&ROBOT).at([0.0, 1.0]).range(0.0..=2.0).speed(3.0);
    assert_eq!(one.report().unwrap(), other.report().unwrap());
}

/// Series stand for every formula of a law, through snap.
#[test]
fn series_are_exact_through_snap() {
    let shapes = [
        Shape::ConstantSpeed,
        Shape::SimpleHarmonic,
        Shape::Cycloidal,
        Shape::Polynomial345,
        Shape::Polynomial4567,
        Shape::Polynomial56789,
        Shape::ModifiedSine,
        Shape::ModifiedTrapezoid,
        Shape::Scca(Scca::new(0.2, 0.3, 0.5).unwrap()),
    ];
    let mut laws: Vec<Box<dyn Piecewise<f64>>> = Vec::new();
    for (shape, time) in shapes.into_iter().zip([1e-3, 0.4, 50.0].into_iter().cycle()) {
        laws.push(Box::new(Rise::new(shape, 0.2, 1.3, time).unwrap()));
    }
    laws.push(Box::new(
        SCurve::new(
            0.0,
            1.0,
            Limits {
                velocity: 2.0,
                acceleration: 8.0,
                jerk: 60.0,
                snap: Some(2e3),
            },
        )
        .unwrap(),
    ));
    laws.push(Box::new(Fourier::new(1.0, [[0.2, 0.1], [0.05, -0.1]], 0.7).unwrap()));
    laws.push(Box::new(
        Polynomial::<f64, 6>::between(Motion::new([0.1, 0.0, 0.0]), Motion::new([1.2, -0.3, 0.5]), 0.6).unwrap(),
    ));
    for law in &laws {
        let end = law.duration();
        let report = kin_studio::report(&PRESS)
            .under_laws([&**law], 0.0..=1.2 * end)
            .report()
            .unwrap();
        assert!(report.drive.pieces.len() <= 64, "{}", report.drive.pieces.len());
        let times: Vec<f64> = (0..997)
            .map(|part| 1.2 * end * (f64::from(part) + 0.5) / 997.0)
            .collect();
        for order in 0..5 {
            let values = || times.iter().map(|at| (*at, law.at::<5>(*at).derivatives()[order]));
            let size = values().fold(0.0, |size: f64, (_, value)| size.max(value.abs()));
            for (at, value) in values() {
                let found = motion(&report, 0, at)[order];
                assert!(
                    (found - value).abs() <= 4e-12 * size,
                    "{at} of {end}, order {order}: {found} {value}"
                );
            }
        }
    }
}

/// A cam that goes on and on has a period if the range is one.
#[test]
fn repeated_laws_have_a_period() {
    let rise = Rise::new(Shape::Cycloidal, 0.0, 1.0, 0.3).unwrap();
    let fall = Rise::new(Shape::Cycloidal, 1.0, 0.0, 0.2).unwrap();
    let cycle = Sequence::new([&rise, &fall]).unwrap();
    let cam = cycle.repeated();
    let period = |law: &dyn Piecewise<f64>, to: f64| {
        let report = kin_studio::report(&PRESS).under_laws([law], 0.0..=to).report();
        report.unwrap().period
    };
    assert_eq!(period(&cam, 0.5), Some(0.5));
    assert_eq!(period(&cam, 1.0), Some(1.0));
    assert_eq!(period(&cam, 0.8), None);
    assert_eq!(period(&cycle, 0.5), None);
    // a crank begins a new revolution at zero, which is no jump
    let revolutions = ConstantSpeed::new(0.0, TAU, 1.0).unwrap().repeated();
    let report = kin_studio::report(&CRANK_ROCKER)
        .under_laws([&revolutions], 0.0..=2.0)
        .report()
        .unwrap();
    assert_eq!((report.period, report.drive.joints.len()), (Some(2.0), 0));
    assert!(report.extremes.iter().all(|extreme| extreme.value.is_some()));
}

/// Coupled blocks are followed from where the laws begin.
#[test]
#[cfg_attr(not(feature = "gallery"), ignore = "a minute, for the feature gallery")]
fn coupled_blocks_move_under_laws() {
    let triad = triad();
    let leg = Rise::new(Shape::Cycloidal, 3.4, 3.45, 0.4).unwrap();
    let [b, c] = [3.4, 3.6].map(|length| Dwell::new(length, 0.4).unwrap());
    let near = Near([0.5, 2.6, -1.5, 0.2]);
    let draft = kin_studio::report(&triad)
        .assembly(near)
        .under_laws([&leg, &b, &c], 0.0..=0.4);
    let report = draft.report().unwrap();
    assert!(report.coupled && report.not_closed.is_none());
    assert_eq!(report.assemblies[report.assembly].at, Some(0.0));
    let sweep = triad.sweep(near).under_laws([&leg, &b, &c], 0.0..=0.4, 21);
    let highest = sweep.of("phi").highest().unwrap();
    let reported = report
        .extremes
        .iter()
        .find(|one| (one.quantity.as_str(), one.order, one.kind) == ("phi", 0, Side::Highest));
    assert!((reported.unwrap().value.unwrap() - highest.value).abs() < 1e-10);
}

/// Where a law leads beyond a limit, the page reports where, and the missing length.
#[test]
fn laws_may_lead_beyond_a_limit() {
    let rocker = FourBar {
        r1: 90.0,
        r2: 60.0,
        r3: 40.0,
        r4: 50.0,
    };
    let swing = Rise::new(Shape::Cycloidal, 0.5, 2.0, 1.0).unwrap();
    let report = kin_studio::report(&rocker)
        .under_laws([&swing], 0.0..=1.0)
        .report()
        .unwrap();
    let missing = report.not_closed.unwrap();
    assert!(missing.at == 1.0 && missing.margin.is_some_and(|margin| (margin + 37.257).abs() < 1e-3));
    let far = Dwell::new(2.0, 1.0).unwrap();
    let error = kin_studio::report(&rocker)
        .under_laws([&far], 0.0..=1.0)
        .report()
        .unwrap_err();
    assert!(matches!(error, ReportError::ClosesNowhere { .. }), "{error}");
}

/// A law whose derivatives are not those of its value.
struct Wrong;

impl Piecewise<f64> for Wrong {
    fn end(&self, _: usize) -> f64 {
        1.0
    }

    fn write(&self, _: usize, time: f64, derivatives: &mut [f64]) {
        derivatives.fill(0.0);
        derivatives[0] = time;
    }
}

/// A law that is no number.
struct Nowhere;

impl Piecewise<f64> for Nowhere {
    fn end(&self, _: usize) -> f64 {
        1.0
    }

    fn write(&self, _: usize, _: f64, derivatives: &mut [f64]) {
        derivatives.fill(f64::NAN);
    }
}

#[test]
fn mistakes_say_what_to_do() {
    let rise = Rise::new(Shape::Cycloidal, 0.0, 1.0, 0.4).unwrap();
    let press = || kin_studio::report(&PRESS);
    let laws = || press().under_laws([&rise], 0.0..=0.4);
    for (draft, wish) in [
        (laws().speed(1.0), "speed"),
        (laws().moving("theta"), "moving"),
        (laws().at([0.0]), "at"),
        (laws().range(0.0..=0.2), "range"),
    ] {
        let message = draft.report().unwrap_err().to_string();
        let wanted = format!(
            "`{wish}` has no effect beside `under_laws`, which determines how all inputs move: leave one of them out"
        );
        assert_eq!(message, wanted);
    }
    let error = press().between([0.0], [1.0]).at([0.5]).report().unwrap_err();
    assert!(matches!(
        error,
        ReportError::SaidTwice {
            wish: "at",
            beside: "between"
        }
    ));
    let error = press().between([0.5], [0.5]).report().unwrap_err();
    assert!(
        error.to_string().contains("give `between` two different ones"),
        "{error}"
    );
    let error = press().between([0.0], [f64::NAN]).report().unwrap_err();
    assert_eq!(error.to_string(), "theta is not finite: give a number");
    for range in [0.4..=0.0, 0.0..=0.0, 0.0..=f64::INFINITY] {
        let error = press().under_laws([&rise], range).report().unwrap_err();
        assert!(matches!(error, ReportError::NoRange { .. }), "{error}");
    }
    let other = Dwell::new(2.0, 0.1).unwrap();
    let jumping = Sequence::new([&rise as &dyn Piecewise<f64>, &other]).unwrap();
    let error = press().under_laws([&jumping], 0.0..=0.5).report().unwrap_err();
    assert!(
        matches!(
            error,
            ReportError::Motion(SweepError::Jump { input, .. }) if input == "theta"
        ),
        "{error}"
    );
    let error = press().under_laws([&Wrong], 0.0..=1.0).report().unwrap_err();
    assert!(
        matches!(&error, ReportError::NotSmooth { input, .. } if input == "theta"),
        "{error}"
    );
    let error = press().under_laws([&Nowhere], 0.0..=1.0).report().unwrap_err();
    assert!(matches!(error, ReportError::NotFinite { .. }), "{error}");
    let short = Rise::new(Shape::Cycloidal, 0.0, 0.0, 1e-6).unwrap().repeated();
    let error = press().under_laws([&short], 0.0..=1.0).report().unwrap_err();
    assert!(matches!(error, ReportError::TooManyPieces { .. }), "{error}");
    let older = r#"{"format":1}"#;
    let error = Report::from_json(older).unwrap_err();
    assert!(
        matches!(error, ReportError::OlderFormat { found: 1, known } if known == FORMAT),
        "{error}"
    );
}
