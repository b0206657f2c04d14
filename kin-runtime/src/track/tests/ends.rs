//! Other ends: the domain of a function, the range of an unknown, a pole, a dead point beside which it starts. Each is
//! named for what it is, at its position.

use core::f64::consts::{FRAC_PI_2, PI};
use std::string::ToString;

use super::{TrackError, TrackErrorOf, track};
use crate::failure::SolveError;
use crate::library::FourBar;
use crate::number::samples;
use crate::prelude::*;
use crate::verify::Random;

crate::mechanism! {
    struct Root { l: Length, m: Length }
    input q: Angle;
    unknown y: Length;
    y == sqrt(l * l - powi(m * sin(q), 2));
}

crate::mechanism! {
    /// A lever on a crank before the root, and one that is moved by it.
    struct RootBetween { l: Length, m: Length, crank: Length, pivot: Length, lever: Length }
    input q: Angle;
    unknown s: Length where s > 0, p: Angle, y: Length, t: Length where t > 0, r: Angle;
    s * cis(p) == vec2(pivot + crank * cos(q), crank * sin(q));
    y == sqrt(l * l - powi(m * sin(p), 2));
    t * cis(r) == vec2(lever, y);
}

crate::mechanism! {
    struct ArcSine { l: Scalar, m: Scalar }
    input q: Angle;
    unknown y: Angle;
    y == asin(m * sin(q) + l);
}

crate::mechanism! {
    struct ArcCosine { l: Scalar, m: Scalar }
    input q: Angle;
    unknown y: Angle;
    y == acos(m * sin(q) + l);
}

crate::mechanism! {
    struct Logarithm { l: Scalar, m: Scalar }
    input q: Angle;
    unknown y: Scalar;
    y == ln(l - m * sin(q));
}

/// The error of a track that is neither a limit nor a change point.
fn failure_of<M: Mechanism<Scalar = f64>>(mechanism: &M, from: f64, to: f64) -> SolveError {
    let inputs = |value: f64| M::Inputs::from_fn(|_| value);
    let start = M::assemblies().find_map(|assembly| mechanism.position(inputs(from), assembly).ok());
    let start = start.unwrap_or_else(|| panic!("{mechanism:?} is not defined at {from}"));
    match track(mechanism, inputs(from), start, inputs(to)) {
        Err(TrackError::Failed(error)) => error,
        Err(error) => panic!("{mechanism:?} from {from} to {to}: {error:?}"),
        Ok(_) => panic!("{mechanism:?} goes on from {from} to {to}"),
    }
}

/// Holds an error to the domain of a function: which one, in which block, and where.
fn is_end_of(error: &SolveError, function: &str, block: &str, expected: f64, tolerance: f64) {
    let Failure::OutsideDomain {
        function: actual,
        argument,
    } = error.failure
    else {
        panic!("{error:?}");
    };
    assert_eq!(actual, function);
    assert_eq!(error.block, block);
    let (_, expected_input) = error.inputs.iter().next().unwrap();
    assert!(
        (expected_input - expected).abs() <= tolerance,
        "{error:?} {expected} {tolerance}"
    );
    // The argument is what it is at that input.
    match function {
        "sqrt" | "ln" => assert!(argument <= 0.0, "{error:?}"),
        _ => assert!(argument.abs() > 1.0, "{error:?}"),
    }
}

#[test]
fn domain_of_a_root() {
    let root: Root = Root { l: 1.0, m: 1.5 };
    let end = (1.0_f64 / 1.5).asin();
    is_end_of(&failure_of(&root, 0.1, 2.0), "sqrt", "y", end, 4.0 * f64::EPSILON);

    let mut random = Random::new(41);
    for round in 0..samples::of(200) as usize {
        let unit = [1.0, 1e-6, 1e6][round % 3];
        let m = unit * random.between(0.5, 3.0);
        let part = random.between(0.05, 0.999);
        let end = part.asin();
        let root: Root = Root { l: part * m, m };
        let from = end * random.between(-0.99, 0.99);
        // Rounding of the sine by ε shifts the angle by the tangent of it.
        let tolerance = 8.0 * f64::EPSILON * (1.0 + end.tan());
        for (to, end) in [(FRAC_PI_2, end), (-FRAC_PI_2, -end), (30.0, end)] {
            is_end_of(&failure_of(&root, from, to), "sqrt", "y", end, tolerance);
        }
    }
}

#[test]
fn domain_between_blocks() {
    let mut random = Random::new(42);
    let mut found = 0;
    let mechanisms = samples::of(40);
    for _ in 0..mechanisms {
        let (crank, pivot) = (random.between(0.2, 0.9), random.between(1.0, 2.0));
        let mechanism: RootBetween = RootBetween {
            l: random.between(0.1, 0.9) * crank / pivot,
            m: 1.0,
            crank,
            pivot,
            lever: random.between(0.1, 2.0),
        };
        // The lever's angle is asin(l), and the crank is at this angle plus that of the triangle.
        let angle = mechanism.l.asin();
        let offset = (pivot * mechanism.l / crank).asin();
        // The crank's pin is first on the side away from the pivot.
        let end = angle + offset;
        let tolerance = 32.0 * f64::EPSILON * (1.0 + angle.tan() + pivot / crank * (angle.tan() + offset.tan()));
        for sign in [1.0, -1.0] {
            let error = failure_of(&mechanism, 0.01 * sign * end, sign * 3.0);
            is_end_of(&error, "sqrt", "y", sign * end, tolerance);
            found += 1;
        }
    }
    assert_eq!(found, 2 * mechanisms);
}

#[test]
fn domains_of_arcs_and_logarithms() {
    let mut random = Random::new(43);
    for _ in 0..samples::of(100) {
        let m = random.between(0.5, 3.0);
        let part = random.between(-0.8, 0.99);
        let end = part.asin();
        let tolerance = 16.0 * f64::EPSILON * (1.0 / m + 1.0) / end.cos();
        // The sine is as large again at -π - end.
        let from = end - random.between(0.05, 0.9) * (PI + 2.0 * end);
        // The other end of the domain is farther away than the sine goes.
        let l = 1.0 - part * m;
        if l - m > -1.0 {
            let arc: ArcSine = ArcSine { l, m };
            is_end_of(&failure_of(&arc, from, 2.0), "asin", "y", end, tolerance);
            let arc: ArcCosine = ArcCosine { l, m };
            is_end_of(&failure_of(&arc, from, 2.0), "acos", "y", end, tolerance);
            // mirrored, at the other end of the domain
            let arc: ArcCosine = ArcCosine { l: -l, m };
            is_end_of(&failure_of(&arc, -from, -2.0), "acos", "y", -end, tolerance);
        }
        let logarithm: Logarithm = Logarithm { l: part * m, m };
        is_end_of(&failure_of(&logarithm, from, 2.0), "ln", "y", end, tolerance);
    }
}

#[test]
fn message_of_a_domain() {
    let root: Root = Root { l: 1.0, m: 1.5 };
    let message = failure_of(&root, 0.1, 2.0).to_string();
    assert!(
        message.starts_with("y cannot be found at q = 0.7297277 rad (41.8°): sqrt is not defined for -"),
        "{message}"
    );
}

crate::mechanism! {
    /// A function of the unknown in a block that no closed form fits.
    struct ArcOfUnknown { slope: Scalar }
    input q: Angle;
    unknown y: Angle;
    y + sin(y) / 10 == asin(q - slope * y);
}

/// There the solvers cannot distinguish which function it is, nor the input to the last digit; but they do not name
/// another cause.
#[test]
fn domain_in_a_coupled_block() {
    let mut random = Random::new(44);
    // y + sin(y) / 10 is a right angle there.
    let last = (0..60).fold(FRAC_PI_2, |y: f64, _| FRAC_PI_2 - y.sin() / 10.0);
    let mut worst: f64 = 0.0;
    for _ in 0..samples::of(50) {
        let slope = random.between(0.1, 0.9);
        let mechanism: ArcOfUnknown = ArcOfUnknown { slope };
        let Err(TrackError::Failed(error)) = track(&mechanism, [0.0], [0.0], [4.0]) else {
            panic!("{mechanism:?}");
        };
        assert!(
            matches!(error.failure, Failure::NotFinite { quantity } if quantity.to_string().contains("domain")),
            "{error:?}"
        );
        let (_, expected_input) = error.inputs.iter().next().unwrap();
        worst = worst.max((expected_input - (1.0 + slope * last)).abs());
    }
    std::println!("{worst:e}");
    assert!(worst < 1e-7, "{worst:e}");
}

crate::mechanism! {
    struct Ranged { l: Length }
    input q: Angle;
    unknown x: Length where x < 1;
    x == l * sin(q);
}

#[test]
fn range_of_an_unknown() {
    for l in [1.25, 2.0, 1e3] {
        let error = failure_of(&Ranged { l }, 0.0, 2.0);
        assert!(
            matches!(error.failure, Failure::OutOfRange { unknown, .. } if unknown == "x"),
            "{error:?}"
        );
        let (_, expected_input) = error.inputs.iter().next().unwrap();
        let expected = (1.0_f64 / l).asin();
        // A range has an allowance of eight units of rounding.
        assert!(
            (expected_input - expected).abs() <= 32.0 * f64::EPSILON / expected.cos(),
            "{error:?} {expected}"
        );
    }
}

crate::mechanism! {
    /// A slide on a line that rotates, against a line that does not.
    struct Guide { pivot: Point, other: Point, inclination: Angle }
    input q: Angle;
    unknown s: Length, t: Length;
    pivot + s * cis(q) == other + t * cis(inclination);
}

crate::mechanism! {
    struct Tangent { l: Length }
    input q: Angle;
    unknown y: Length;
    y == l * tan(q);
}

#[test]
fn poles() {
    let mut random = Random::new(45);
    for _ in 0..samples::of(100) {
        let unit = 10.0_f64.powf(random.between(-8.0, 8.0));
        let mut point = || Plane::new(unit * random.between(-1.0, 1.0), unit * random.between(-1.0, 1.0));
        let (pivot, other) = (point(), point());
        let inclination = random.between(0.2, 1.2);
        let guide = Guide {
            pivot,
            other,
            inclination,
        };
        let from = inclination + random.between(0.2, 2.9);
        let start = guide.position(from).unwrap().unknowns();
        // Parallel lines; at once in the other direction it would be the same line rotated by half a revolution.
        for (to, expected_input) in [(inclination - 1.0, inclination), (from + PI, inclination + PI)] {
            let Err(TrackError::Pole(pole)) = track(&guide, [from], start, [to]) else {
                panic!("{guide:?}");
            };
            assert_eq!(pole.block, "s, t");
            assert!(
                (pole.inputs[0] - expected_input).abs() <= 1e-12,
                "{pole:?} {expected_input}"
            );
        }
        let tangent = Tangent { l: unit };
        for (to, expected_input) in [(2.0, FRAC_PI_2), (-4.0, -FRAC_PI_2)] {
            let Err(TrackError::Pole(pole)) = track(&tangent, [0.3], [unit * 0.3_f64.tan()], [to]) else {
                panic!("{tangent:?}");
            };
            assert!((pole.inputs[0] - expected_input).abs() <= 1e-12, "{pole:?}");
            assert!(pole.unknowns[0] * expected_input.signum() > 1e6 * unit);
        }
    }
    let error = track(&Tangent { l: 1.0 }, [0.0], [0.0], [2.0]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "an unknown of y runs to infinity at q = 1.570796 rad (90.0°), after 0.7853982 of the way; stop short of it, \
         or drive the mechanism by another input"
    );
}

/// From the position at one crank angle to another, in one assembly; nothing if there is no position to start from.
fn from_beside(
    linkage: &FourBar,
    assembly: Assembly,
    from: f64,
    to: f64,
) -> Option<Result<[f64; 2], TrackErrorOf<FourBar>>> {
    let start = linkage.position(from, assembly).ok()?.unknowns();
    Some(track(linkage, [from], start, [to]))
}

#[test]
fn start_beside_a_limit() {
    let mut random = Random::new(46);
    let mut nearest: f64 = 1.0;
    for _ in 0..samples::of(100) {
        let [r1, r2, r3, r4] = [(); 4].map(|()| random.between(0.3, 1.0));
        let linkage = FourBar { r1, r2, r3, r4 };
        let Some(range) = linkage.crank_range() else { continue };
        let (low, high) = (range.low, range.high);
        // Not where a change point is near.
        if PI - high < 1e-2 || high - low < 1e-2 {
            continue;
        }
        let back = 0.5 * (low + high);
        for exponent in 4..17 {
            for assembly in Assembly::BOTH {
                let from = high - 10.0_f64.powi(-exponent);
                let Some(result) = from_beside(&linkage, assembly, from, high + 1.0) else {
                    continue;
                };
                let Err(TrackError::TurningPoint(limit)) = result else {
                    panic!("{linkage:?} {assembly:?} {from}: {result:?}");
                };
                let tolerance = 16.0 * f64::EPSILON * (1.0 + 1.0 / (r1 * r2 * high.sin()));
                assert!(
                    (limit.inputs[0] - high).abs() <= tolerance,
                    "{linkage:?} {limit:?} {high}"
                );
                let result = from_beside(&linkage, assembly, from, back).unwrap();
                assert!(result.is_ok(), "{linkage:?} {assembly:?} {from}: {result:?}");
                let [u, v] = linkage.position(from, assembly).unwrap().unknowns();
                nearest = nearest.min((u - v).sin().abs());
            }
        }
    }
    assert!(nearest < 1e-7, "{nearest}");
}

/// At a change point a determinant of δ means that the crank is away from it by about δ; rounding of the unknowns grows
/// with 1 / δ. Where it reaches δ, nothing distinguishes the assemblies, on the way back neither.
#[test]
fn start_beside_a_change_point() {
    let mut random = Random::new(47);
    let mut nearest: f64 = 1.0;
    for round in 0..samples::of(40) {
        let (long, short) = (random.between(0.6, 1.0), random.between(0.3, 0.55));
        // parallelograms and kites: both are folded at 0, the first ones also stretched at π
        let is_kite = round % 2 == 0;
        let linkage = if is_kite {
            FourBar {
                r1: long,
                r2: long,
                r3: short,
                r4: short,
            }
        } else {
            FourBar {
                r1: long,
                r2: short,
                r3: long,
                r4: short,
            }
        };
        for exponent in 2..16 {
            let gap = 10.0_f64.powi(-exponent);
            for (expected_input, side) in [(0.0, 1.0), (0.0, -1.0), (PI, -1.0)] {
                if is_kite && expected_input == PI {
                    continue;
                }
                for assembly in Assembly::BOTH {
                    let from = expected_input + side * gap;
                    let Some(result) = from_beside(&linkage, assembly, from, expected_input - side) else {
                        continue;
                    };
                    let Err(TrackError::ChangePoint(point)) = result else {
                        panic!("{linkage:?} {assembly:?} {from}: {result:?}");
                    };
                    assert_eq!(point.block, "theta3, theta4");
                    assert!(
                        (point.inputs[0] - expected_input).abs() <= 1e-7,
                        "{linkage:?} {from} {point:?}"
                    );
                    match from_beside(&linkage, assembly, from, expected_input + 0.3 * side).unwrap() {
                        Ok(_) => {}
                        Err(TrackError::ChangePoint(_)) if gap < 2e-7 => {}
                        result => panic!("{linkage:?} {assembly:?} {from}: {result:?}"),
                    }
                    let [u, v] = linkage.position(from, assembly).unwrap().unknowns();
                    nearest = nearest.min((u - v).sin().abs());
                }
            }
        }
    }
    assert!(nearest < 1e-8, "{nearest}");
}
