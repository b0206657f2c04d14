//! Sensitivities of peaks, against dual numbers at their position and against the peaks of changed mechanisms.

use core::f64::consts::{PI, TAU};
use std::string::ToString;

use super::{At, ExtremeKind, ExtremesError, Peak, PeakSensitivities};
use crate::assembly::{Assembly, Near};
use crate::geometry::{Plane, Space};
use crate::law::{Dwell, Law, Rise, Sequence, Shape};
use crate::library::{ClassThreeTriad, FourBar, SliderCrank};
use crate::load::{Load, LoadError, Loaded, Loads};
use crate::mechanism::{Mechanism, Partials};
use crate::motion::Motion;
use crate::number::{Changing, Number, Row, samples};
use crate::solve::Scalar;
use crate::sweep::{Local, SmoothDrive, Sweep, Swept};

crate::mechanism! {
    /// Four-bar linkage with the middle of its coupler.
    struct Press { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Direction;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    output coupler: Point = r2 * cis(theta2) + r3 / 2 * cis(theta3);
    output tool: Point = r1 + r4 * cis(theta4);
}

crate::mechanism! {
    /// Five-bar linkage driven at both cranks.
    struct Robot { ground: Length, left: Length, left_rod: Length, right_rod: Length, right: Length }
    input alpha: Angle, beta: Angle;
    unknown phi: Angle, psi: Angle;
    left * cis(alpha) + left_rod * cis(phi) == ground + right * cis(beta) + right_rod * cis(psi);
    output hand: Point = left * cis(alpha) + left_rod * cis(phi);
}

crate::mechanism! {
    /// RSSR linkage with three points of its rocker.
    struct Spatial { crank: Length, pivot: Point3, arm: Vector3, rod: Length }
    input theta: Angle;
    unknown phi: Angle;
    let rocker = pivot + rot_y(phi) * arm;
    let pin = rot_z(theta) * vec3(crank, 0, 0);
    dot(rocker - pin, rocker - pin) == rod.powi(2);
    output ball: Point3 = rocker;
    output root: Point3 = pivot + 0 * arm;
    output ear: Point3 = pivot + rot_y(phi) * vec3(crank, crank, 0 * crank);
}

const PRESS: Press = Press {
    r1: 0.4,
    r2: 0.12,
    r3: 0.36,
    r4: 0.28,
};
const ROBOT: Robot = Robot {
    ground: 2.0,
    left: 1.5,
    left_rod: 2.4,
    right_rod: 2.4,
    right: 1.5,
};
const SPATIAL: Spatial = Spatial {
    crank: 1.0,
    pivot: Space::new(3.0, 0.4, -0.2),
    arm: Space::new(0.3, 0.5, 2.0),
    rod: 3.6,
};

fn on_press<T: Scalar>() -> Loads<Press<T>, impl Load<Press<T>>> {
    Loads::<Press<T>>::new()
        .gravity(Plane::new(0.0, -9.81))
        .mass(1.4, |pose| pose.coupler)
        .inertia(0.016, |pose| pose.theta3)
        .inertia(0.03, |pose| pose.theta4)
        .force(Plane::new(-120.0, 0.0), |pose| pose.tool)
        .spring(900.0, 0.2, |pose| pose.tool, |_| Plane::new(0.6, 0.3))
        .torsion_damper(0.4, |pose| pose.theta4)
}

fn on_robot<T: Scalar>() -> Loads<Robot<T>, impl Load<Robot<T>>> {
    Loads::<Robot<T>>::new()
        .gravity(Plane::new(0.0, -9.81))
        .mass(3.0, |pose| pose.hand)
        .inertia(0.4, |pose| pose.psi)
}

fn on_spatial<T: Scalar>() -> Loads<Spatial<T>, impl Load<Spatial<T>>> {
    let solid = crate::load::Solid {
        mass: 4.0,
        centre: Space::new(0.3, 0.2, 0.1),
        inertia: [[0.3, 0.02, 0.0], [0.02, 0.4, 0.05], [0.0, 0.05, 0.25]],
    };
    Loads::<Spatial<T>>::new()
        .gravity(Space::new(0.0, 0.0, -9.81))
        .body(solid, |pose| [pose.root, pose.ball, pose.ear])
}

fn on_triad<T: Scalar>() -> Loads<ClassThreeTriad<T>, impl Load<ClassThreeTriad<T>>> {
    Loads::<ClassThreeTriad<T>>::new()
        .gravity(Plane::new(0.0, -9.81))
        .mass(6.0, |pose| pose.centre)
        .inertia(2.0, |pose| pose.phi)
}

/// The mechanism with one dimension changed.
fn changed<M: Mechanism<Scalar = f64>>(mechanism: &M, dimension: usize, change: f64) -> M {
    let parameters = mechanism.parameters();
    M::from_parameters(Row::from_fn(|index| {
        parameters[index] + if index == dimension { change } else { 0.0 }
    }))
}

/// Compares with the peaks of mechanisms of which one dimension is changed by two steps to either side: these
/// differences have an error of the fourth power of the step, and lose three digits to rounding.
fn check_by_differences<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    found: &PeakSensitivities,
    peak: impl Fn(&M) -> Peak,
) {
    let parameters = mechanism.parameters();
    let count = found.by.len();
    // each takes four searches: of many dimensions, some are enough beside the dual numbers
    let step = match (count > 6, samples::are_all()) {
        (false, true) => 1,
        (true, true) | (false, false) => 3,
        (true, false) => 6,
    };
    let dimensions = (0..count).step_by(step);
    for (dimension, sensitivity) in dimensions.map(|dimension| (dimension, &found.by[dimension])) {
        let value: f64 = parameters[dimension];
        let unit = if value == 0.0 { 1.0 } else { value.abs() };
        let step = 1e-3 * unit;
        let [far, near] = [2.0, 1.0].map(|steps| {
            let [one, other] = [steps, -steps].map(|steps| peak(&changed(mechanism, dimension, steps * step)));
            [one.value - other.value, one.at - other.at]
        });
        let slope = |part: usize| (8.0 * near[part] - far[part]) / (12.0 * step);
        let size = found.peak.value.abs() / unit;
        assert!(
            (sensitivity.value - slope(0)).abs() < 1e-8 * (size + slope(0).abs()),
            "value by {dimension}: {} {}",
            sensitivity.value,
            slope(0)
        );
        assert!(
            (sensitivity.at - slope(1)).abs() < 1e-7 * (1.0 / unit + slope(1).abs()),
            "position by {dimension}: {} {}",
            sensitivity.at,
            slope(1)
        );
    }
}

/// The peaks of all orders of both angles, as differences and the sensitivities of the motion itself show.
#[test]
fn peaks_of_a_revolution() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 70.0,
        r4: 60.0,
    };
    let sweep = |linkage: &FourBar, assembly| linkage.sweep(assembly).over(0.3..=0.3 + TAU, 100).speed(10.0);
    for assembly in Assembly::BOTH {
        for (name, unknown, order) in [
            ("theta4_velocity", 1, 1),
            ("theta3_acceleration", 0, 2),
            ("theta4_snap", 1, 4),
        ] {
            let found = sweep(&linkage, assembly).of(name).peak_sensitivities().unwrap();
            assert_eq!(found.peak, sweep(&linkage, assembly).of(name).peak().unwrap());
            assert_eq!(found.peak.kind, ExtremeKind::Inner);
            check_by_differences(&linkage, &found, |linkage| {
                sweep(linkage, assembly).of(name).peak().unwrap()
            });
            let crank = Motion::at_constant_speed(found.peak.at, 10.0);
            let partials = linkage.sensitivities_at([crank], assembly).unwrap();
            for (sensitivity, partial) in found.by.iter().zip(partials) {
                let expected = partial.unknown_partials()[unknown][order];
                // the terms are as large as the peak over a dimension
                let size = found.peak.value.abs() / 30.0 + expected.abs();
                assert!(
                    (sensitivity.value - expected).abs() < 1e3 * f64::EPSILON * size,
                    "{name}: {} {expected}",
                    sensitivity.value
                );
            }
        }
    }
}

/// The peak of the first drive's effort, as differences and numbers with a change show.
fn check_effort<M, D, L>(
    mechanism: &M,
    sweep: impl Fn(&M) -> Sweep<M, D>,
    loads: &Loads<M::With<Local>, L>,
    at_peak: impl Fn(&M::With<Changing<f64>>, f64) -> Changing<f64>,
) where
    M: Mechanism<Scalar = f64>,
    D: SmoothDrive,
    L: Load<M::With<Local>>,
{
    let effort = |at: &At<M>| at.effort(loads, 0);
    let found = sweep(mechanism).of_expression(effort).peak_sensitivities().unwrap();
    assert_eq!(found.peak.kind, ExtremeKind::Inner);
    check_by_differences(mechanism, &found, |mechanism| {
        sweep(mechanism).of_expression(effort).peak().unwrap()
    });
    for (dimension, sensitivity) in found.by.iter().enumerate() {
        let mut next = 0;
        let changing = mechanism.convert(|value| {
            next += 1;
            Changing::new(value, if next == dimension + 1 { 1.0 } else { 0.0 })
        });
        let Changing { value, change } = at_peak(&changing, found.peak.at);
        let size = found.peak.value.abs() + change.abs();
        assert!((found.peak.value - value).abs() < 1e3 * f64::EPSILON * size);
        assert!(
            (sensitivity.value - change).abs() < 1e3 * f64::EPSILON * size,
            "{dimension}: {} {change}",
            sensitivity.value
        );
    }
}

/// A motion at constant speed, without a change itself.
fn steady(at: f64, speed: f64) -> Motion<Changing<f64>, 5> {
    let number = |value| Changing::new(value, 0.0);
    Motion::at_constant_speed(number(at), number(speed))
}

#[test]
fn peaks_of_efforts() {
    check_effort(
        &PRESS,
        |press| press.sweep(Assembly::Open).over(0.0..=TAU, 100).speed(12.0),
        &on_press(),
        |press, at| {
            let [effort] = press
                .balance(&on_press(), [steady(at, 12.0)], Assembly::Open)
                .unwrap()
                .efforts();
            effort.value()
        },
    );
}

/// A motion under a law, without a change itself.
fn under(law: &Rise, at: f64) -> Motion<Changing<f64>, 5> {
    let motion: Motion<f64, 5> = law.at(at);
    Motion::new(motion.derivatives().map(|entry| Changing::new(entry, 0.0)))
}

/// Two drives that start from rest.
#[test]
fn peaks_of_efforts_of_two_drives() {
    let left = Rise::new(Shape::Polynomial56789, 1.4, 2.4, 0.2).unwrap();
    let right = Rise::new(Shape::Polynomial4567, 1.6, 0.9, 0.2).unwrap();
    check_effort(
        &ROBOT,
        |robot| robot.sweep(Assembly::Open).under_laws([&left, &right], 0.0..=0.2, 40),
        &on_robot(),
        |robot, at| {
            let inputs = [under(&left, at), under(&right, at)];
            let [effort, _] = robot.balance(&on_robot(), inputs, Assembly::Open).unwrap().efforts();
            effort.value()
        },
    );
}

#[test]
fn peaks_of_efforts_in_space() {
    let loads = on_spatial();
    let sweep = SPATIAL.sweep(Assembly::Open).over(0.0..=TAU, 100).speed(6.0);
    let whole = sweep.of_expression(|at| at.effort(&loads, 0)).peak().unwrap();
    check_effort(
        &SPATIAL,
        |linkage| {
            linkage
                .sweep(Assembly::Open)
                .over(whole.at - 0.3..=whole.at + 0.4, 10)
                .speed(6.0)
        },
        &on_spatial(),
        |linkage, at| {
            let [effort] = linkage
                .balance(&on_spatial(), [steady(at, 6.0)], Assembly::Open)
                .unwrap()
                .efforts();
            effort.value()
        },
    );
}

/// A platform on three legs, which Newton's method solves.
#[test]
fn peaks_of_efforts_by_newtons_method() {
    let triad = ClassThreeTriad {
        base_b: Plane::new(3.46, 0.1),
        base_c: Plane::new(1.7, 3.0),
        platform_b: Plane::new(1.7, 0.0),
        platform_c: Plane::new(0.9, 1.5),
    };
    let near = Near([0.1, 2.2, -2.0, 1.6]);
    let legs = [(2.24, 2.0), (2.24, 2.3), (2.24, 2.44)]
        .map(|(from, to)| Rise::new(Shape::Polynomial56789, from, to, 0.1).unwrap());
    check_effort(
        &triad,
        |triad| {
            triad
                .sweep(near)
                .under_laws([&legs[0], &legs[1], &legs[2]], 0.0..=0.1, 20)
        },
        &on_triad(),
        |triad, at| {
            let inputs = [0, 1, 2].map(|leg| under(&legs[leg], at));
            let [effort, ..] = triad.balance(&on_triad(), inputs, near).unwrap().efforts();
            effort.value()
        },
    );
}

/// Along a sweep, an effort is that of the single pose, and its slope and bend are its rates.
#[test]
fn an_effort_on_a_sweep_is_that_of_the_pose() {
    let speed = 12.0;
    let sweep = PRESS.sweep(Assembly::Crossed).over(0.0..=TAU, 100).speed(speed);
    let loads = on_press();
    let crossings = sweep.of_expression(|at| at.effort(&loads, 0)).crossings(1.0).unwrap();
    let rates = sweep.of_expression(|at| at.effort(&loads, 0)).extremes().unwrap();
    assert!(!crossings.is_empty() && rates.len() >= 2);
    let single = |at: f64| {
        let crank = Motion::at_constant_speed(at, speed);
        let [effort] = PRESS
            .balance(&on_press(), [crank], Assembly::Crossed)
            .unwrap()
            .efforts();
        effort
    };
    let size = rates
        .iter()
        .map(|extreme| extreme.value.unwrap().abs())
        .fold(0.0, f64::max);
    for crossing in crossings {
        assert!((single(crossing.at).value() - 1.0).abs() < 1e-12 * size);
        assert_eq!(single(crossing.at).rate() > 0.0, crossing.is_rising);
    }
    for extreme in rates {
        let effort = single(extreme.at);
        assert!((effort.value() - extreme.value.unwrap()).abs() < 1e-13 * size);
        assert!(effort.rate().abs() < 1e-10 * size * speed);
        assert_eq!(effort.second_rate() < 0.0, extreme.is_maximum);
    }
}

/// Under a law with dwells, from rest to rest: the peak of the torque lies within a piece of the law.
#[test]
fn peaks_under_a_law_with_dwells() {
    let up = Rise::new(Shape::Polynomial56789, 0.4, 2.0, 0.3).unwrap();
    let rest = Dwell::new(2.0, 0.2).unwrap();
    let law = Sequence::new([&up, &rest]).unwrap();
    let loads = on_press();
    let sweep = |press: &Press| press.sweep(Assembly::Open).under_laws([&law], 0.0..=0.5, 100);
    let effort = |at: &At<Press>| at.effort(&loads, 0);
    let found = sweep(&PRESS).of_expression(effort).peak_sensitivities().unwrap();
    assert_eq!(found.peak.kind, ExtremeKind::Inner);
    check_by_differences(&PRESS, &found, |press| {
        sweep(press).of_expression(effort).peak().unwrap()
    });
}

/// The position of a peak at the end of a sweep stays, and its value changes as the quantity there.
#[test]
fn a_peak_at_the_end_of_a_sweep_stays_there() {
    let engine = SliderCrank { r: 0.05, l: 0.15 };
    let sweep = |engine: &SliderCrank| engine.sweep(Assembly::Open).over(0.5..=1.0, 20).speed(10.0);
    let found = sweep(&engine).of("s_velocity").peak_sensitivities().unwrap();
    assert_eq!((found.peak.kind, found.peak.at), (ExtremeKind::End, 1.0));
    check_by_differences(&engine, &found, |engine| sweep(engine).of("s_velocity").peak().unwrap());
    assert!(found.by.iter().all(|by| by.at == 0.0 && by.value != 0.0));
}

#[test]
fn a_peak_at_a_limit_has_none() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let sweep = linkage.sweep(Assembly::Open).over(1.0..=PI, 100);
    // the rocker rotates on to the limit
    let raised = |at: &At<FourBar>| at.theta4.value() + Local::constant(10.0);
    let error = sweep.of_expression(raised).peak_sensitivities().unwrap_err();
    let ExtremesError::NoSensitivity {
        at,
        kind: ExtremeKind::Limit,
    } = error
    else {
        panic!("{error}");
    };
    assert!((at.to_degrees() - 112.0243).abs() < 1e-4, "{at}");
    let expected = "stands at a limit, where it has no sensitivity: end the sweep short of it";
    assert!(error.to_string().ends_with(expected), "{error}");
    let error = sweep.of("theta4_velocity").peak_sensitivities().unwrap_err();
    assert!(matches!(error, ExtremesError::Unbounded { .. }), "{error}");
}

#[test]
fn a_peak_at_a_kink_has_none() {
    let engine = SliderCrank { r: 0.05, l: 0.15 };
    let sweep = engine.sweep(Assembly::Open).over(0.2..=1.2, 20);
    // the distance to an obstacle, which the piston passes
    let distance = |at: &At<SliderCrank>| {
        let over = at.s.value() - Local::constant(0.18);
        let distance = if over.real() < 0.0 { -over } else { over };
        Local::constant(1.0) - distance
    };
    let error = sweep.of_expression(distance).peak_sensitivities().unwrap_err();
    assert!(
        matches!(
            error,
            ExtremesError::NoSensitivity {
                kind: ExtremeKind::Kink,
                ..
            }
        ),
        "{error}"
    );
}

/// A load without a result is the answer to the question, with its position.
#[test]
fn loads_without_a_result() {
    let sweep = PRESS.sweep(Assembly::Open).over(0.0..=TAU, 100);
    let loads = on_press();
    let error = sweep.of_expression(|at| at.effort(&loads, 1)).peak().unwrap_err();
    assert_eq!(
        error,
        ExtremesError::Load {
            at: 0.0,
            error: std::boxed::Box::new(LoadError::NoEffort { input: 1 })
        }
    );
    assert!(error.to_string().starts_with("at 0: the drive of input 1"), "{error}");
}
