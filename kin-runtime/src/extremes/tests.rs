//! Extremes against scans, and against what is known in closed form.

use core::cell::Cell;
use core::f64::consts::{PI, TAU};
use std::string::ToString;
use std::vec::Vec;

use super::{At, ExtremeKind, ExtremesError, Mean, Over};
use crate::assembly::{Assembly, Near};
use crate::law::{ConstantSpeed, Dwell, Law, Piecewise, Rise, Sequence, Shape};
use crate::library::{ClassThreeTriad, FiveBar, FourBar, JansenLeg, PeaucellierLinkage, ScotchYoke, SliderCrank};
use crate::mechanism::Mechanism;
use crate::motion::Motion;
use crate::number::{Number, samples, series::Series};
use crate::sweep::samples::{CRANK_ROCKER, Inverse, LIMITED, triad};
use crate::sweep::{Instant, Local, StraightLine, Sweep, Swept};

const ORDERS: [&str; 5] = ["", "_velocity", "_acceleration", "_jerk", "_snap"];

fn swept(linkage: FourBar, assembly: Assembly) -> Sweep<FourBar, StraightLine> {
    linkage.sweep(assembly).over(0.0..=TAU, 100).speed(10.0)
}

/// The derivative of the rocker's angle, with the next one.
fn rocker(linkage: FourBar, assembly: Assembly, at: f64, order: usize) -> [f64; 2] {
    let linkage = linkage.convert(|parameter: f64| crate::number::series::Series::<6>::constant(parameter));
    let input = crate::number::series::Series::<6>::from_derivatives([at, 10.0, 0.0, 0.0, 0.0, 0.0]);
    let derivatives = linkage
        .position(input, assembly)
        .unwrap()
        .theta4
        .position()
        .derivatives();
    [derivatives[order], derivatives[order + 1]]
}

/// Closures calculate with plain numbers, and compare, as with numbers of any kind.
#[test]
fn closures_calculate_with_plain_numbers() {
    let sweep = swept(CRANK_ROCKER, Assembly::Open);
    let [high, low] = [
        sweep.of("theta4").highest().unwrap(),
        sweep.of("theta4").lowest().unwrap(),
    ];
    let near = |one: f64, other: f64| assert!((one - other).abs() < 1e-14 * (1.0 + other.abs()), "{one} {other}");
    // motions, which answer by their values, and the series that they give
    let found = sweep.of_expression(|at| 2.0 * at.theta4 + 1.0).highest().unwrap();
    near(found.value, 2.0 * high.value + 1.0);
    near(found.at, high.at);
    near(
        sweep.of_expression(|at| at.theta4 * 2.0).highest().unwrap().value,
        2.0 * high.value,
    );
    let found = sweep
        .of_expression(|at| 1.0 - at.theta4.position() / 4.0)
        .highest()
        .unwrap();
    near(found.value, 1.0 - low.value / 4.0);
    near(found.at, low.at);
    near(
        sweep.of_expression(|at| at.theta4.sqrt()).highest().unwrap().value,
        high.value.sqrt(),
    );
    // the rocker stays in the half-plane in which the cosine falls
    assert!(low.value > 0.0 && high.value < PI);
    near(
        sweep.of_expression(|at| at.theta4.cos()).lowest().unwrap().value,
        high.value.cos(),
    );
    near(
        sweep
            .of_expression(|at| at.theta4.position().cos())
            .lowest()
            .unwrap()
            .value,
        high.value.cos(),
    );
    // as the function itself is, derivatives and all
    let sine = sweep
        .of_expression(|at| 90.0 * at.theta4.sin().velocity())
        .peak()
        .unwrap();
    let chain = sweep
        .of_expression(|at| 90.0 * at.theta4.velocity() * at.theta4.position().cos())
        .peak()
        .unwrap();
    near(sine.value, chain.value);
    // comparisons: the part of the travel above a level
    let level = 0.5 * (low.value + high.value);
    let above = sweep
        .of_expression(|at| (at.theta4 - level).max(0.0 * at.theta4))
        .highest()
        .unwrap();
    near(above.value, high.value - level);
    let above = sweep
        .of_expression(|at| {
            if at.theta4.position() < level {
                Local::constant(level)
            } else {
                at.theta4.position()
            }
        })
        .lowest()
        .unwrap();
    near(above.value, level);
    near(
        sweep
            .of_expression(|at| (at.theta4.position() - level).abs())
            .highest()
            .unwrap()
            .value,
        high.value - level,
    );
}

/// Every extreme of a revolution is found once: as many as a dense scan sees, each where the next derivative vanishes.
#[test]
fn a_turn_has_the_extremes_of_a_dense_scan() {
    for assembly in Assembly::BOTH {
        for (order, suffix) in ORDERS.iter().enumerate() {
            let name = std::format!("theta4{suffix}");
            let found = swept(CRANK_ROCKER, assembly).of(&name).extremes().unwrap();
            let count = samples::of(7200);
            let at = |index: u32| (f64::from(index) + 0.3) * TAU / f64::from(count);
            let slopes: Vec<f64> = (0..=count)
                .map(|index| rocker(CRANK_ROCKER, assembly, at(index), order)[1])
                .collect();
            let seen = slopes
                .windows(2)
                .filter(|pair| (pair[0] < 0.0) != (pair[1] < 0.0))
                .count();
            assert_eq!(found.len(), seen, "{name}");
            let values = (0..count).map(|index| rocker(CRANK_ROCKER, assembly, at(index), order)[0]);
            let size = values.clone().fold(0.0, |size: f64, value| size.max(value.abs()));
            for extreme in &found {
                assert_eq!(extreme.kind, ExtremeKind::Inner);
                let [value, slope] = rocker(CRANK_ROCKER, assembly, extreme.at, order);
                assert!(
                    (extreme.value.unwrap() - value).abs() < 1e-12 * size,
                    "{name} {extreme}"
                );
                assert!(slope.abs() < 1e-11 * size * 10.0, "{name} {extreme}: {slope}");
            }
            let peak = swept(CRANK_ROCKER, assembly).of(&name).peak().unwrap();
            let largest = values.fold(0.0, |size: f64, value| size.max(value.abs()));
            // between two points of the scan, a peak is higher by the square of their distance
            let step = TAU / f64::from(count);
            assert!(
                peak.value.abs() >= largest * (1.0 - 1e-15) && peak.value.abs() < largest * (1.0 + 10.0 * step * step)
            );
        }
    }
}

/// The dead points of a crank-rocker's rocker, by the law of cosines.
#[test]
fn dead_points_are_exact() {
    let found = swept(CRANK_ROCKER, Assembly::Open).of("theta4").extremes().unwrap();
    let FourBar { r1, r2, r3, r4 } = CRANK_ROCKER;
    let mut expected = [r3 + r2, r3 - r2].map(|side| PI - ((r1 * r1 + r4 * r4 - side * side) / (2.0 * r1 * r4)).acos());
    expected.sort_by(f64::total_cmp);
    let mut values: Vec<f64> = found.iter().map(|extreme| extreme.value.unwrap()).collect();
    values.sort_by(f64::total_cmp);
    assert_eq!(values.len(), 2);
    for (value, expected) in values.iter().zip(expected) {
        assert!((value - expected).abs() < 4.0 * f64::EPSILON, "{value} {expected}");
    }
}

/// A scotch yoke is a cosine: extremes, also at the seam of the revolution, crossings, mean and root mean square are
/// known.
#[test]
fn a_yoke_is_a_cosine() {
    let yoke = ScotchYoke {
        crank: 2.0,
        gamma: PI / 2.0,
    };
    for start in [0.0, 1.0, -7.0] {
        let sweep = yoke.sweep().over(start..=start + TAU, 50).speed(3.0);
        let name = "x";
        for (order, suffix) in ORDERS.iter().enumerate() {
            let name = std::format!("{name}{suffix}");
            let extremes = sweep.of(&name).extremes().unwrap();
            assert_eq!(extremes.len(), 2, "{name} from {start}");
            let size = 2.0 * 3_f64.powi(i32::try_from(order).unwrap());
            for extreme in extremes {
                assert!((extreme.value.unwrap().abs() - size).abs() < 1e-14 * size);
                let quarter = if order % 2 == 0 {
                    extreme.at
                } else {
                    extreme.at - PI / 2.0
                };
                assert!(quarter.sin().abs() < 1e-14);
            }
            let mean = sweep.of(&name).mean(Over::Time).unwrap();
            assert!(mean.value.abs() < 1e-14 * size && mean.error < 1e-12 * size);
            let rms = sweep.of(&name).rms(Over::Input).unwrap();
            assert!((rms.value - size / 2_f64.sqrt()).abs() < 1e-14 * size);
        }
        assert_eq!(sweep.of(name).crossings(1.0).unwrap().len(), 2);
        let dwells = sweep.of(name).dwells(2.0, 1.0).unwrap();
        assert_eq!(dwells.len(), 1);
        assert!((dwells[0].to - dwells[0].from - TAU / 3.0).abs() < 1e-13);
        assert!((dwells[0].duration - TAU / 9.0).abs() < 1e-13);
    }
}

/// At a turning point a position has an extreme, and its rates have no bound. The mean velocity is the way over the
/// time, and the mean square has no value.
#[test]
fn turning_points_bound_positions_and_not_rates() {
    let sweep = LIMITED.sweep(Assembly::Open).over(-3.0..=3.0, 100).speed(10.0);
    let range = LIMITED.crank_range().unwrap();
    let positions = sweep.of("theta4").extremes().unwrap();
    let (first, last) = (positions.first().unwrap(), positions.last().unwrap());
    assert_eq!((first.kind, last.kind), (ExtremeKind::Limit, ExtremeKind::Limit));
    assert!((first.at + range.high).abs() < 1e-14 && (last.at - range.high).abs() < 1e-14);
    // coupler and rocker are in line
    let FourBar { r1, r2, r3, r4 } = LIMITED;
    let side = r3 + r4;
    let inner = ((r1 * r1 + side * side - r2 * r2) / (2.0 * r1 * side)).acos();
    for extreme in [first, last] {
        let value = extreme.value.unwrap();
        assert!((value.cos().abs() - inner.cos()).abs() < 1e-11, "{value} {inner}");
    }
    for suffix in &ORDERS[1..] {
        let rates = sweep.of(&std::format!("theta4{suffix}")).extremes().unwrap();
        for rate in [rates.first().unwrap(), rates.last().unwrap()] {
            assert_eq!((rate.kind, rate.value), (ExtremeKind::Unbounded, None));
        }
        let name = std::format!("theta4{suffix}");
        assert!(matches!(sweep.of(&name).peak(), Err(ExtremesError::Unbounded { .. })));
        // without a bound on one side, there may be one on the other
        let sides = rates.iter().filter(|rate| rate.kind == ExtremeKind::Unbounded);
        let signs: Vec<bool> = sides.map(|rate| rate.is_maximum).collect();
        assert_eq!(sweep.of(&name).highest().is_err(), signs.contains(&true));
        assert_eq!(sweep.of(&name).lowest().is_err(), signs.contains(&false));
    }
    let mean = sweep.of("theta4_velocity").mean(Over::Time).unwrap();
    let way = last.value.unwrap() - first.value.unwrap();
    let time = 2.0 * range.high / 10.0;
    assert!((mean.value - way / time).abs() < 1e-10, "{} {}", mean.value, way / time);
    let square = sweep.of("theta4_velocity").rms(Over::Time).unwrap_err();
    assert!(matches!(square, ExtremesError::Diverges { power: 1.0, .. }), "{square}");
    assert!(matches!(
        sweep.of("theta4_acceleration").mean(Over::Time).unwrap_err(),
        ExtremesError::Diverges { power: 1.5, .. }
    ));
}

/// Downwards, everything is found in the other order, and derivatives of odd order have the other sign.
#[test]
fn a_sweep_may_run_downwards() {
    let up = CRANK_ROCKER
        .sweep(Assembly::Open)
        .over(0.3..=4.0, 40)
        .of("theta3_jerk")
        .extremes()
        .unwrap();
    let mut down = CRANK_ROCKER
        .sweep(Assembly::Open)
        .over(4.0..=0.3, 40)
        .of("theta3_jerk")
        .extremes()
        .unwrap();
    down.reverse();
    assert_eq!(up.len(), down.len());
    for (one, other) in up.iter().zip(down) {
        assert_eq!((one.kind, one.is_maximum), (other.kind, !other.is_maximum));
        assert!((one.at - other.at).abs() < 1e-13 && (one.value.unwrap() + other.value.unwrap()).abs() < 1e-12);
    }
}

/// Under a law of pieces, extremes at joints have both sides. Over time and over the input, means differ.
#[test]
fn laws_have_joints() {
    let crank = SliderCrank { r: 0.1, l: 0.3 };
    let rise = Rise::new(Shape::Polynomial345, 0.0, 1.0, 0.4).unwrap();
    let rest = Dwell::new(1.0, 0.1).unwrap();
    let servo = Sequence::new([&rise, &rest]).unwrap();
    let sweep = crank.sweep(Assembly::Open).under_laws([&servo], 0.0..=0.5, 40);
    let extremes = sweep.of("theta_jerk").extremes().unwrap();
    // the law ends with its largest jerk, and rests at once
    let joint = extremes
        .iter()
        .find(|extreme| extreme.kind == ExtremeKind::Kink)
        .unwrap();
    assert_eq!((joint.at, joint.is_maximum), (0.4, true));
    let expected = 60.0 / 0.4_f64.powi(3);
    assert!((joint.value.unwrap() - expected).abs() < 1e-12 * expected, "{joint}");
    assert!((sweep.of("theta_jerk").peak().unwrap().value - expected).abs() < 1e-12 * expected);
    let dwells = sweep.of("theta").dwells(1.0, 1e-9).unwrap();
    assert_eq!(dwells.len(), 1);
    assert!(dwells[0].to == 0.5 && dwells[0].duration > 0.1 && dwells[0].duration < 0.102);
    let over_time = sweep.of("theta").mean(Over::Time).unwrap();
    let over_input = sweep.of("theta").mean(Over::Input).unwrap();
    assert!((over_time.value - (0.5 * 0.4 + 0.1) / 0.5).abs() < 1e-13);
    assert!((over_input.value - 0.5).abs() < 1e-12, "{over_input:?}");
    // a position in three orders at once: the mean of the jerk is the change of the acceleration
    let mean = crank
        .sweep(Assembly::Open)
        .under_laws([&rise], 0.0..=0.4, 40)
        .of("s_jerk")
        .mean(Over::Time)
        .unwrap();
    let [start, end] = [0.0, 0.4].map(|time| crank.solve(rise.at(time), Assembly::Open).unwrap().s.acceleration());
    assert!((mean.value - (end - start) / 0.4).abs() < 1e-11);
}

/// Where a rate jumps, the one above it is an impulse in the direction of the jump, and those above that have no bound
/// on either side.
#[test]
fn rates_above_a_jump_have_no_bound() {
    let crank = SliderCrank { r: 0.1, l: 0.3 };
    let unbounded = |servo: &Sequence<[&dyn Piecewise<f64>; 3]>, name: &str| -> Vec<(f64, bool)> {
        let end = servo.duration();
        let sweep = crank.sweep(Assembly::Open).under_laws([servo], 0.0..=end, 20);
        let extremes = sweep.of(name).extremes().unwrap();
        let unbounded = extremes.iter().filter(|extreme| extreme.value.is_none());
        let found: Vec<(f64, bool)> = unbounded.map(|extreme| (extreme.at, extreme.is_maximum)).collect();
        let rms = sweep.of(name).rms(Over::Time);
        assert_eq!(found.is_empty(), rms.is_ok(), "{name}: {rms:?}");
        found
    };
    let start = Dwell::new(0.3, 0.2).unwrap();
    let even = Rise::new(Shape::ConstantSpeed, 0.3, 1.0, 0.25).unwrap();
    let end = Dwell::new(1.0, 0.25).unwrap();
    let servo = Sequence::new([&start as &dyn Piecewise<f64>, &even, &end]).unwrap();
    for name in ["theta", "s", "theta_velocity", "s_velocity"] {
        assert_eq!(unbounded(&servo, name), [], "{name}");
    }
    let [begin, stop] = [0.2, 0.45];
    assert_eq!(unbounded(&servo, "theta_acceleration"), [(begin, true), (stop, false)]);
    // the slide moves back as the crank rotates on
    assert_eq!(unbounded(&servo, "s_acceleration"), [(begin, false), (stop, true)]);
    let both = [(begin, true), (begin, false), (stop, true), (stop, false)];
    assert_eq!(unbounded(&servo, "theta_jerk"), both);
    assert_eq!(unbounded(&servo, "s_snap"), both);
    let sweep = crank.sweep(Assembly::Open).under_laws([&servo], 0.0..=0.7, 20);
    let error = sweep.of("s_acceleration").peak().unwrap_err();
    assert!(
        error.to_string().contains("a joint of laws where a lower rate jumps"),
        "{error}"
    );
    // the jerk of a cycloid jumps at its ends, and its acceleration does not
    let cycloid = Rise::new(Shape::Cycloidal, 0.3, 1.0, 0.25).unwrap();
    let servo = Sequence::new([&start as &dyn Piecewise<f64>, &cycloid, &end]).unwrap();
    assert_eq!(unbounded(&servo, "s_jerk"), []);
    assert_eq!(unbounded(&servo, "theta_snap"), [(begin, true), (stop, false)]);
}

/// A jump of one input is none of a quantity that does not follow it, and a crank that begins a new revolution does not
/// jump.
#[test]
fn jumps_are_those_of_the_quantity() {
    let robot = FiveBar {
        ground: 2.0,
        left: 0.5,
        left_rod: 2.0,
        right_rod: 2.0,
        right: 1.5,
    };
    let left = Rise::new(Shape::Cycloidal, 0.0, 2.0, 0.5).unwrap();
    let right = Rise::new(Shape::ConstantSpeed, 1.0, 1.6, 0.25).unwrap();
    let sweep = robot.sweep(Assembly::Open).under_laws([&left, &right], 0.0..=0.6, 20);
    for (name, jumps) in [
        ("beta_acceleration", std::vec![0.25]),
        ("phi_acceleration", std::vec![0.25]),
        ("phi_jerk", std::vec![0.25, 0.25]),
        ("alpha_jerk", std::vec![]),
        ("alpha_snap", std::vec![0.5]),
    ] {
        let extremes = sweep.of(name).extremes().unwrap();
        let unbounded = extremes.iter().filter(|extreme| extreme.value.is_none());
        assert_eq!(unbounded.map(|extreme| extreme.at).collect::<Vec<_>>(), jumps, "{name}");
    }
    let revolutions = ConstantSpeed::new(0.0, TAU / 0.5, 0.5).unwrap().repeated();
    let sweep = CRANK_ROCKER
        .sweep(Assembly::Open)
        .under_laws([&revolutions], 0.0..=1.5, 40);
    for name in [
        "theta2_velocity",
        "theta4_velocity",
        "theta4_acceleration",
        "theta4_snap",
    ] {
        let extremes = sweep.of(name).extremes().unwrap();
        assert!(extremes.iter().all(|extreme| extreme.value.is_some()), "{name}");
        assert!(sweep.of(name).rms(Over::Time).is_ok(), "{name}");
    }
}

/// A kink of the quantity itself is found to rounding: the folded transmission angle has one at a right angle.
#[test]
fn kinks_and_transmission_angles() {
    let sweep = swept(CRANK_ROCKER, Assembly::Open);
    let angle = |at: &At<FourBar>| at.transmission_angle(0).unwrap();
    let plain = sweep.of_expression(|at| angle(at).angle).extremes().unwrap();
    // the classic extremes, where the crank is in line with the ground
    let FourBar { r1, r2, r3, r4 } = CRANK_ROCKER;
    for extreme in &plain {
        assert!(extreme.at.sin().abs() < 1e-13);
        let diagonal = r1 - r2 * extreme.at.cos();
        let expected = ((r3 * r3 + r4 * r4 - diagonal * diagonal) / (2.0 * r3 * r4)).acos();
        assert!((extreme.value.unwrap() - expected).abs() < 1e-14);
    }
    assert_eq!(plain.len(), 2);
    let folded = sweep.of_expression(|at| angle(at).folded()).extremes().unwrap();
    let kinks: Vec<_> = folded
        .iter()
        .filter(|extreme| extreme.kind == ExtremeKind::Kink)
        .collect();
    assert_eq!(kinks.len(), 2);
    for kink in kinks {
        assert!((kink.value.unwrap() - PI / 2.0).abs() < 1e-13);
    }
}

/// A coupled block is followed: equal legs rotate the platform, l² = R² + ρ² - 2 R ρ cos phi.
#[test]
fn coupled_blocks_have_extremes() {
    let triad = triad();
    let (low, high) = (1.2, 2.8);
    let start = [5.0_f64.sqrt(); 3];
    let guess = track_to(&triad, start, [low; 3]);
    let sweep = triad.sweep(Near(guess)).between([low; 3], [high; 3], 30).speed(0.5);
    let name = "phi_velocity";
    let extremes = sweep.of(name).extremes().unwrap();
    let velocity = |leg: f64| {
        let cosine = (5.0 - leg * leg) / 4.0;
        leg * 0.5 / (2.0 * (1.0 - cosine * cosine).sqrt())
    };
    // it is the smallest where l² = 3: d/dl (l² / (16 - (5 - l²)²)) = 0
    let inner: Vec<_> = extremes
        .iter()
        .filter(|extreme| extreme.kind == ExtremeKind::Inner)
        .collect();
    assert_eq!((inner.len(), extremes.len()), (1, 3));
    let leg = inner[0].at;
    assert!((leg * leg - 3.0).abs() < 1e-12, "{leg}");
    for extreme in &extremes {
        assert!((extreme.value.unwrap() - velocity(extreme.at)).abs() < 1e-13);
    }
}

fn track_to(triad: &ClassThreeTriad, from: [f64; 3], to: [f64; 3]) -> [f64; 4] {
    crate::track(triad, from, [0.1, 2.2, -2.0, 1.6], to).unwrap()
}

/// Above the declared order, extremes are the zeros of the next derivative as well, of unknowns and of outputs.
#[test]
fn derivatives_above_the_order_have_names() {
    let sweep = swept(CRANK_ROCKER, Assembly::Open);
    let long = CRANK_ROCKER.convert(|parameter: f64| Series::<13>::constant(parameter));
    let derivatives = |at: f64| {
        let mut input = [0.0; 13];
        (input[0], input[1]) = (at, 10.0);
        let position = long.position(Series::from_derivatives(input), Assembly::Open).unwrap();
        position.theta4.position().derivatives()
    };
    for (order, name) in [(5, "theta4_crackle"), (6, "theta4_pop"), (8, "theta4_derivative_8")] {
        let found = sweep.of(name).extremes().unwrap();
        let count = samples::of(7200);
        let at = |index: u32| (f64::from(index) + 0.3) * TAU / f64::from(count);
        let slopes: Vec<f64> = (0..=count).map(|index| derivatives(at(index))[order + 1]).collect();
        let seen = slopes
            .windows(2)
            .filter(|pair| (pair[0] < 0.0) != (pair[1] < 0.0))
            .count();
        assert_eq!(found.len(), seen, "{name}");
        let size = sweep.of(name).peak().unwrap().value.abs();
        for extreme in &found {
            let exact = derivatives(extreme.at);
            assert!(
                (extreme.value.unwrap() - exact[order]).abs() < 1e-11 * size,
                "{name} {extreme}"
            );
            assert!(exact[order + 1].abs() < 1e-9 * size * 10.0, "{name} {extreme}");
        }
    }
    // at the declared orders both ways agree
    let at = 1.3;
    let snap = CRANK_ROCKER
        .solve(Motion::at_constant_speed(at, 10.0), Assembly::Open)
        .unwrap()
        .theta4
        .snap();
    assert!((derivatives(at)[4] - snap).abs() < 1e-11 * snap.abs());
    // an output, and an input under a law
    let leg = JansenLeg::HOLY_NUMBERS;
    let walk = leg.sweep(JansenLeg::WALKING).over(0.0..=TAU, 100).speed(2.0);
    let [snap, crackle] = ["foot.x_snap", "foot.x_crackle"].map(|name| walk.of(name).extremes().unwrap());
    // the crackle vanishes where the snap is extreme
    let crossings = walk.of("foot.x_crackle").crossings(0.0).unwrap();
    assert_eq!(snap.len(), crossings.len());
    for (extreme, crossing) in snap.iter().zip(&crossings) {
        assert!((extreme.at - crossing.at).abs() < 1e-10, "{extreme} {crossing:?}");
    }
    assert!(!crackle.is_empty());
    let rise = Rise::new(Shape::Polynomial345, 0.0, 1.0, 0.5).unwrap();
    let servo = CRANK_ROCKER.sweep(Assembly::Open).under_laws([&rise], 0.0..=0.5, 10);
    // the fifth derivative of 6 u⁵ - 15 u⁴ + 10 u³
    let crackle = servo.of("theta2_crackle").peak().unwrap();
    assert!((crackle.value - 720.0 * 32.0).abs() < 1e-9, "{crackle}");
    let error = sweep.of("theta4_derivative_13").peak().unwrap_err();
    assert!(error.to_string().contains("theta4_derivative_1"), "{error}");
}

/// The margin is the length that is left, and nothing is left at a limit.
#[test]
fn margins_are_quantities() {
    let FourBar { r1, r2, r3, r4 } = CRANK_ROCKER;
    let margins = swept(CRANK_ROCKER, Assembly::Open).of("margin").extremes().unwrap();
    let smallest = swept(CRANK_ROCKER, Assembly::Open).of("margin").lowest().unwrap().value;
    // stretched: crank and ground in line
    assert!((smallest - (r3 + r4 - r1 - r2)).abs() < 1e-12, "{smallest}");
    let kinks: Vec<_> = margins
        .iter()
        .filter(|extreme| extreme.kind == ExtremeKind::Kink)
        .collect();
    // where both kinds of margin are the same: d = max(r3, r4)
    assert_eq!(kinks.len(), 2);
    for kink in kinks {
        let distance = (r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * kink.at.cos()).sqrt();
        assert!(
            (distance - r3).abs() < 1e-10 && (kink.value.unwrap() - r4).abs() < 1e-10,
            "{kink}"
        );
    }
    let limited = LIMITED
        .sweep(Assembly::Open)
        .over(-3.0..=3.0, 50)
        .of("margin")
        .extremes()
        .unwrap();
    for end in [limited.first().unwrap(), limited.last().unwrap()] {
        assert_eq!(end.kind, ExtremeKind::Limit);
        assert!(end.value.unwrap().abs() < 1e-9, "{end}");
    }
    let press = SliderCrank { r: 0.1, l: 0.3 };
    let press = press.sweep(Assembly::Open).over(0.0..=TAU, 50);
    let smallest = press.of("margin").lowest().unwrap().value;
    assert!((press.of("margin").highest().unwrap().value - 0.3).abs() < 1e-14);
    assert!((smallest - 0.2).abs() < 1e-14);
    let yoke = ScotchYoke {
        crank: 2.0,
        gamma: PI / 2.0,
    };
    let error = yoke.sweep().over(0.0..=TAU, 50).of("margin").extremes().unwrap_err();
    assert!(matches!(error, ExtremesError::NoSuchColumn(_)));
}

crate::mechanism! {
    /// A cylinder lifts a boom. The angle of the boom is measured against the cylinder.
    struct RelativeBoom { pub base: Length, pub boom: Length }
    input cylinder: Length;
    unknown alpha: Angle, beta: Angle;
    cylinder * cis(alpha) == base + boom * cis(alpha + beta);
}

crate::mechanism! {
    /// A slider on an axis, with a link whose length is an input.
    struct StretchedLink { pub offset: Length }
    input link: Length;
    unknown phi: Angle, slide: Length;
    link * cis(phi) == vec2(slide, offset);
}

crate::mechanism! {
    /// A slider on an inclined line, with a link whose length is an input.
    struct StretchedLinkOnSlope { pub offset: Length, pub slope: Angle }
    input link: Length;
    unknown phi: Angle, slide: Length;
    link * cis(phi) == vec2(slide, offset) * cis(slope);
}

crate::mechanism! {
    /// A cylinder that a crank carries, with a boom of constant length.
    struct CarriedCylinder { pub base: Length, pub crank: Length, pub rest: Length, pub boom: Length }
    input theta: Angle;
    unknown travel: Length, alpha: Angle, beta: Angle;
    travel == rest + crank * sin(theta);
    crank * cis(theta) + travel * cis(alpha) == base + boom * cis(beta);
}

/// The margin as a series at a point of a sweep, by differences of the extremes' numbers.
fn margins<M>(sweep: &Sweep<M, StraightLine>, expected: impl Fn(f64) -> f64)
where
    M: Mechanism<Scalar = f64, Inputs<f64> = [f64; 1]>,
{
    let slope = |at: f64| (expected(at + 1e-4) - expected(at - 1e-4)) / 2e-4;
    let tested = core::cell::Cell::new(0);
    let asked = sweep
        .of_expression(|at: &At<M>| {
            let margin = at.smallest_margin().unwrap();
            let [angle, rate] = [0, 1].map(|order| at.input(0, 0).unwrap().derivatives()[order]);
            assert!(
                (margin.real() - expected(angle)).abs() < 1e-14 * 8.0,
                "{angle}: {margin:?}"
            );
            // the difference has an error of its step squared times the third derivative, if there is no kink within
            // the step
            let predicted = slope(angle) * rate;
            if (slope(angle - 2e-4) - slope(angle + 2e-4)).abs() < 1e-2 {
                assert!(
                    (margin.derivatives()[1] - predicted).abs() < 1e-6,
                    "{angle}: {margin:?} {predicted}"
                );
                tested.set(tested.get() + 1);
            }
            margin
        })
        .extremes();
    assert!(asked.is_ok() && tested.get() > 20, "{asked:?} {}", tested.get());
}

/// A margin is known where the length of a link changes as well.
#[test]
fn margins_of_links_that_change() {
    let triangle = |base: f64, boom: f64, link: f64| (base + boom - link).min(link - (base - boom).abs());
    let boom: RelativeBoom = RelativeBoom { base: 2.0, boom: 1.5 };
    let lift = boom.sweep(Assembly::Open).over(0.6..=3.4, 21);
    margins(&lift, |cylinder| triangle(2.0, 1.5, cylinder));
    // up to its limit, where nothing is left
    let ends = boom
        .sweep(Assembly::Open)
        .over(1.0..=4.0, 21)
        .of("margin")
        .extremes()
        .unwrap();
    let last = ends.last().unwrap();
    assert_eq!(last.kind, ExtremeKind::Limit);
    assert!(
        (last.at - 3.5).abs() < 1e-14 && last.value.unwrap().abs() < 1e-9,
        "{last}"
    );
    let stretched: StretchedLink = StretchedLink { offset: 0.5 };
    margins(&stretched.sweep(Assembly::Open).over(0.6..=3.4, 21), |link| link - 0.5);
    let sloping: StretchedLinkOnSlope = StretchedLinkOnSlope {
        offset: 0.5,
        slope: 0.3,
    };
    margins(&sloping.sweep(Assembly::Open).over(0.6..=3.4, 21), |link| link - 0.5);
    let carried: CarriedCylinder = CarriedCylinder {
        base: 2.0,
        crank: 0.3,
        rest: 1.6,
        boom: 1.5,
    };
    margins(&carried.sweep(Assembly::Open).over(0.0..=TAU, 21), |theta| {
        let distance = (2.0_f64 * 2.0 + 0.09 - 2.0 * 2.0 * 0.3 * theta.cos()).sqrt();
        let link = 1.6 + 0.3 * theta.sin();
        (distance + 1.5 - link)
            .min(distance + link - 1.5)
            .min(link + 1.5 - distance)
    });
}

/// The progress of a question grows to 1, and the answer is the same.
#[test]
fn progress_is_reported() {
    let sweeps = [
        swept(CRANK_ROCKER, Assembly::Open),
        LIMITED.sweep(Assembly::Open).over(-3.0..=3.0, 50),
    ];
    for sweep in sweeps {
        let mut parts = Vec::new();
        let extremes = sweep
            .of("theta4")
            .on_progress(|part| parts.push(part))
            .extremes()
            .unwrap();
        assert_eq!(extremes, sweep.of("theta4").extremes().unwrap());
        assert!(
            parts.len() > 10 && parts.windows(2).all(|pair| pair[0] < pair[1]),
            "{parts:?}"
        );
        assert!(parts[0] > 0.0 && parts.last() == Some(&1.0), "{parts:?}");
        let mut calls = 0;
        let peak = sweep.of("theta4").on_progress(|_| calls += 1).peak().unwrap();
        assert_eq!((peak, calls), (sweep.of("theta4").peak().unwrap(), parts.len()));
    }
    // a gap between two rows, at which the question is asked again
    let gap = FourBar {
        r4: 50.0 - 1e-4,
        ..CRANK_ROCKER
    };
    let mut parts = Vec::new();
    let found = swept(gap, Assembly::Open)
        .of("theta4")
        .on_progress(|part| parts.push(part))
        .extremes();
    assert!(
        found.is_ok() && parts.windows(2).all(|pair| pair[0] < pair[1]),
        "{parts:?}"
    );
    let error = swept(CRANK_ROCKER, Assembly::Open)
        .of("theta9")
        .on_progress(|_| panic!("nothing is solved"))
        .peak();
    assert!(matches!(error, Err(ExtremesError::NoSuchColumn(_))));
}

/// A gap between two rows divides the sweep, whatever is asked.
#[test]
fn gaps_divide_a_sweep() {
    for rest in [1e-2, 1e-4] {
        let linkage = FourBar {
            r4: 50.0 - rest,
            ..CRANK_ROCKER
        };
        let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 36).speed(10.0);
        let table = sweep.table().unwrap();
        let limits: Vec<f64> = table.limits().iter().map(|limit| limit.at).collect();
        let extremes = sweep.of("theta4").extremes().unwrap();
        let found: Vec<f64> = extremes
            .iter()
            .filter(|extreme| extreme.kind == ExtremeKind::Limit)
            .map(|extreme| extreme.at)
            .collect();
        assert_eq!(found, limits);
        let velocity = sweep.of("theta4_velocity").extremes().unwrap();
        assert_eq!(
            velocity
                .iter()
                .filter(|extreme| extreme.kind == ExtremeKind::Unbounded)
                .count(),
            2
        );
        let mean = sweep.of("theta4_velocity").mean(Over::Time).unwrap();
        // what it rises on both sides of the gap, over the time
        let values: Vec<f64> = extremes.iter().filter_map(|extreme| extreme.value).collect();
        let at = |angle: f64| linkage.position(angle, Assembly::Open).unwrap().theta4.value();
        let limit_values: Vec<f64> = extremes
            .iter()
            .filter(|extreme| extreme.kind == ExtremeKind::Limit)
            .filter_map(|extreme| extreme.value)
            .collect();
        let way = limit_values[0] - at(0.0) + at(TAU) - limit_values[1];
        let time = (TAU - (limits[1] - limits[0])) / 10.0;
        assert!(
            (mean.value - way / time).abs() < 1e-9,
            "{mean:?} {} {values:?}",
            way / time
        );
    }
}

/// A quantity that only touches the border of its tolerance does not leave it.
#[test]
fn a_dwell_may_touch_its_border() {
    let leg = JansenLeg::HOLY_NUMBERS;
    for start in [-3.0, -1.0, 0.0, 1.0, PI] {
        let sweep = leg.sweep(JansenLeg::WALKING).over(start..=start + TAU, 25);
        let values = sweep.of("foot.y").extremes().unwrap();
        let low = values
            .iter()
            .filter_map(|extreme| extreme.value)
            .fold(f64::INFINITY, f64::min);
        let ground = sweep.of("foot.y").dwells(low + 0.5, 0.5).unwrap();
        assert_eq!(ground.len(), 1, "{ground:?} from {start}");
        assert!((ground[0].duration.to_degrees() - 155.175).abs() < 1e-3, "{ground:?}");
    }
}

/// Under a formula everything is known, as under a law: a yoke whose crank swings.
#[test]
fn formulas_have_extremes() {
    let yoke = ScotchYoke {
        crank: 2.0,
        gamma: PI / 2.0,
    };
    let swing = yoke.sweep().by_formula(0.0..=TAU, 30, |time| {
        let (sine, _) = time.sin_cos();
        [Instant::constant(0.25) + Instant::constant(0.5) * sine]
    });
    // 2 cos(1/4 + sin(t)/2): the crank's ends, and its passage through zero
    let extremes = swing.of("x").extremes().unwrap();
    let mut expected = std::vec![PI / 2.0, PI + PI / 6.0, 1.5 * PI, TAU - PI / 6.0];
    for extreme in extremes.iter().filter(|extreme| extreme.kind == ExtremeKind::Inner) {
        let index = expected.iter().position(|at| (at - extreme.at).abs() < 1e-13);
        expected.remove(index.unwrap_or_else(|| panic!("{extreme}")));
        let value = 2.0 * (0.25 + 0.5 * extreme.at.sin()).cos();
        assert!((extreme.value.unwrap() - value).abs() < 1e-14);
    }
    assert!(expected.is_empty(), "{expected:?}");
    let rms = swing.of("theta_velocity").rms(Over::Time).unwrap();
    assert!((rms.value - 0.5 / 2_f64.sqrt()).abs() < 1e-13, "{rms:?}");
}

/// Any expression of a pose carries its derivatives.
#[test]
fn expressions_of_a_pose() {
    let sweep = swept(CRANK_ROCKER, Assembly::Open);
    let power = sweep
        .of_expression(|at| at.theta4.velocity() * at.theta4.acceleration())
        .peak()
        .unwrap();
    let of = |crank: f64| {
        let pose = CRANK_ROCKER
            .solve(Motion::at_constant_speed(crank, 10.0), Assembly::Open)
            .unwrap();
        pose.theta4.velocity() * pose.theta4.acceleration()
    };
    assert!((power.value - of(power.at)).abs() < 1e-12 * power.value.abs());
    for index in 0..3600 {
        assert!(of(f64::from(index) * TAU / 3600.0).abs() <= power.value.abs() * (1.0 + 1e-15));
    }
    let shifted = sweep
        .of_expression(|at| at.theta4.position() + Local::constant(1.0))
        .extremes()
        .unwrap();
    assert_eq!(shifted.len(), 2);
}

#[test]
fn mistakes_are_reported() {
    let sweep = swept(CRANK_ROCKER, Assembly::Open);
    let error = sweep.of("theta4_jrk").peak().unwrap_err();
    assert!(error.to_string().contains("did you mean `theta4_jerk`"), "{error}");
    let short = FourBar { r4: 1.0, ..LIMITED };
    let nothing = short
        .sweep(Assembly::Open)
        .over(2.0..=3.0, 10)
        .of("theta4")
        .peak()
        .unwrap_err();
    assert!(matches!(nothing, ExtremesError::NothingCloses(error) if error.margin().is_some()));
}

/// At the end of a declared range, which is no turning point, rates have values.
#[test]
fn the_end_of_a_range_bounds_everything() {
    let inverse: Inverse = Inverse { factor: 1.0 };
    let sweep = inverse.sweep().over(0.0..=1.5, 10).speed(2.0);
    let end = 1_f64.sin();
    for (name, value) in [("x", 1.0), ("x_velocity", 2.0 / 1_f64.cos())] {
        let extremes = sweep.of(name).extremes().unwrap();
        let last = extremes.last().unwrap();
        assert_eq!(
            (last.kind, last.is_maximum, extremes.len()),
            (ExtremeKind::Limit, true, 2),
            "{extremes:?}"
        );
        assert!((last.at - end).abs() < 1e-14, "{last}");
        assert!((last.value.unwrap() - value).abs() < 1e-10, "{last}");
    }
    let mean = sweep.of("x").mean(Over::Time).unwrap();
    // the integral of the inverse sine
    let expected = (end + 1_f64.cos() - 1.0) / end;
    assert!((mean.value - expected).abs() < 1e-12, "{mean:?} {expected}");
}

/// Rounding errors have no extremes: the tracer of Peaucellier's linkage stays on a straight line.
#[test]
fn rounding_errors_have_no_extremes() {
    let linkage = PeaucellierLinkage {
        ground: 1.0,
        crank: 1.0,
        arm: 3.5,
        side: 1.8,
    };
    let sweep = linkage.sweep(PeaucellierLinkage::STRAIGHT).over(-1.0..=1.0, 61);
    for suffix in ORDERS {
        let across = sweep.of(&std::format!("tracer.x{suffix}")).extremes().unwrap();
        assert!(
            across.iter().all(|extreme| extreme.kind == ExtremeKind::End),
            "{suffix}: {}",
            across.len()
        );
        // along the line the way is a tangent of half the angle, whose derivatives have an extreme in the middle or
        // none
        let along = sweep.of(&std::format!("tracer.y{suffix}")).extremes().unwrap();
        assert!(along.len() <= 3, "{suffix}: {}", along.len());
    }
}

/// A sweep of one row runs to its end all the same, and one without a length has no curve.
#[test]
fn a_peak_needs_a_way_and_no_rows() {
    let name = "theta4_acceleration";
    let start = CRANK_ROCKER.sweep(Assembly::Open);
    let expected = start.over(0.0..=TAU, 361).of(name).peak().unwrap();
    let found = start.over(0.0..=TAU, 1).of(name).peak().unwrap();
    assert!((found.at - expected.at).abs() < 1e-9, "{found} {expected}");
    assert!(
        (found.value - expected.value).abs() < 1e-12 * expected.value.abs(),
        "{found} {expected}"
    );
    for rows in [1, 2] {
        let nothing = start.over(1.0..=1.0, rows);
        let no_length = ExtremesError::NoLength { at: 1.0 };
        assert_eq!(nothing.of(name).peak(), Err(no_length.clone()));
        assert_eq!(nothing.of(name).lowest(), Err(no_length.clone()));
        assert_eq!(nothing.of(name).extremes(), Err(no_length.clone()));
        assert_eq!(nothing.of(name).mean(Over::Time), Err(no_length));
    }
}

/// A constant is largest where the mechanism begins to close, and not where the sweep begins.
#[test]
fn a_constant_is_largest_where_it_closes() {
    let limit = LIMITED.crank_range().unwrap().high;
    let sweep = LIMITED.sweep(Assembly::Open).over(-3.0..=3.0, 100).speed(2.0);
    for peak in [sweep.of("theta2_velocity").peak(), sweep.of("theta2_velocity").lowest()] {
        let peak = peak.unwrap();
        assert_eq!(peak.kind, ExtremeKind::Limit);
        assert!(
            (peak.at.abs() - limit).abs() < 1e-14 && (peak.value - 2.0).abs() < 1e-13,
            "{peak}"
        );
    }
    let speed = swept(CRANK_ROCKER, Assembly::Open)
        .of("theta2_velocity")
        .peak()
        .unwrap();
    assert_eq!((speed.at, speed.value, speed.kind), (0.0, 10.0, ExtremeKind::End));
}

/// At a joint of a law a quantity may jump across a level, upwards as well as downwards, and in both directions of the
/// sweep.
#[test]
fn jumps_at_joints_cross_levels() {
    let crank = SliderCrank { r: 0.1, l: 0.3 };
    let up = Rise::new(Shape::ConstantSpeed, 0.0, 1.0, 0.5).unwrap();
    let down = Rise::new(Shape::ConstantSpeed, 1.0, 0.0, 0.25).unwrap();
    let there_and_back = Sequence::new([&up, &down, &up]).unwrap();
    let start = crank.sweep(Assembly::Open);
    let crossings = |range, level| {
        let sweep = start.under_laws([&there_and_back], range, 40);
        let found = sweep.of("theta_velocity").crossings(level).unwrap();
        found
            .iter()
            .map(|crossing| (crossing.at, crossing.is_rising))
            .collect::<Vec<_>>()
    };
    assert_eq!(crossings(0.0..=1.25, 0.0), [(0.5, false), (0.75, true)]);
    assert_eq!(crossings(1.25..=0.0, 0.0), [(0.75, false), (0.5, true)]);
    assert_eq!(crossings(0.0..=1.25, 2.5), []);
    // a position that is on the level at a joint crosses it once
    let further = Rise::new(Shape::ConstantSpeed, 1.0, 2.0, 0.5).unwrap();
    let on = Sequence::new([&up, &further]).unwrap();
    let sweep = start.under_laws([&on], 0.0..=1.0, 40);
    let found = sweep.of("theta").crossings(1.0).unwrap();
    assert_eq!(found.len(), 1, "{found:?}");
    assert!((found[0].at - 0.5).abs() < 1e-14 && found[0].is_rising);
}

#[test]
fn levels_and_tolerances_are_finite() {
    let sweep = swept(CRANK_ROCKER, Assembly::Open);
    let name = "theta4";
    for wrong in [f64::NAN, f64::INFINITY] {
        let is = |error: ExtremesError, expected: &str| {
            matches!(
                error,
                ExtremesError::Argument { argument, value } if argument == expected && !value.is_finite()
            )
        };
        assert!(is(sweep.of(name).crossings(wrong).unwrap_err(), "level"));
        assert!(is(sweep.of(name).dwells(wrong, 0.1).unwrap_err(), "level"));
        assert!(is(sweep.of(name).dwells(1.0, wrong).unwrap_err(), "tolerance"));
    }
}

/// Waves that are too short for the divisions are no extremes of anything.
#[test]
#[ignore = "takes ten seconds"]
fn a_rough_quantity_is_refused() {
    let sweep = swept(CRANK_ROCKER, Assembly::Open);
    let waves = |count: f64| {
        sweep
            .of_expression(|at| (at.theta2.position() * Local::constant(count)).sin_cos().0)
            .crossings(0.5)
    };
    assert_eq!(waves(50.0).unwrap().len(), 100);
    let error = waves(1e6).unwrap_err();
    assert!(
        matches!(error, ExtremesError::Unresolved { difference, .. } if difference > 1e-9),
        "{error}"
    );
}

/// More poses make a mean of rounding errors no more precise. Across the straight line of Peaucellier's cell, its
/// tracer does not move, and the squares of sine and cosine are 1 over the whole revolution of a crank.
#[test]
fn a_mean_of_rounding_errors_ends_soon() {
    let poses = Cell::new(0);
    let seen = |value: Local| {
        poses.set(poses.get() + 1);
        value
    };
    let is_rounding = |mean: Result<Mean, ExtremesError>| {
        let (value, error) = match mean {
            Ok(mean) => (mean.value, mean.error),
            Err(ExtremesError::Imprecise { value, error }) => (value, error),
            Err(error) => panic!("{error}"),
        };
        assert!(value.abs() < 1e-12 && error < 1e-10, "{value} {error}");
        let count = poses.take();
        assert!(count < 10_000, "{count}");
    };
    let cell = PeaucellierLinkage {
        ground: 1.0,
        crank: 1.0,
        arm: 3.5,
        side: 1.8,
    };
    let sweep = cell
        .sweep(PeaucellierLinkage::<f64>::STRAIGHT)
        .over(-0.8..=0.9, 25)
        .speed(3.0);
    let across = sweep.of_expression(|at| seen(at.tracer.x().velocity()));
    is_rounding(across.rms(Over::Time));
    is_rounding(across.mean(Over::Time));
    let turn = CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, 25);
    let none = turn.of_expression(|at| {
        let (sine, cosine) = at.theta4.position().sin_cos();
        seen(sine * sine + cosine * cosine - Local::constant(1.0))
    });
    is_rounding(none.rms(Over::Input));
}
