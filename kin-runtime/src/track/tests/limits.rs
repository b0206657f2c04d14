//! Limits and change points.

use core::f64::consts::{PI, TAU};
use std::format;
use std::string::ToString;

use super::revolutions::go_round;
use super::{DOUBLE_ROCKER, TrackError, from_to, track, turned_alike};
use crate::Name;
use crate::library::{FourBar, OffsetSliderCrank, PeaucellierLinkage, SliderCrank};
use crate::number::samples;
use crate::prelude::*;
use crate::verify::Random;

crate::mechanism! {
    /// Two four-bars in series: the rocker of the first is the crank of the second.
    struct InSeries { ground: Length, crank: Length, coupler: Length, rocker: Length, next: Length }
    input q: Angle;
    unknown a: Angle, b: Angle, c: Angle, d: Angle;
    crank * cis(q) + coupler * cis(a) == ground + rocker * cis(b);
    rocker * cis(b) + coupler * cis(c) == next + rocker * cis(d);
}

/// Where a track ends before its time.
fn limit_of<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    assembly: M::Assembly,
    from: f64,
    to: f64,
) -> (Name, f64, M::Unknowns<f64>) {
    let start = mechanism.position(M::Inputs::from_fn(|_| from), assembly).unwrap();
    match track(
        mechanism,
        M::Inputs::from_fn(|_| from),
        start,
        M::Inputs::from_fn(|_| to),
    ) {
        Err(TrackError::TurningPoint(limit)) => {
            assert!((limit.fraction - (limit.inputs[0] - from) / (to - from)).abs() < 1e-14);
            (limit.block, limit.inputs[0], limit.unknowns)
        }
        Ok(end) => panic!(
            "{mechanism:?} {assembly:?} from {from} to {to} ends at {:?}",
            end.as_ref()
        ),
        Err(error) => panic!("{mechanism:?} {assembly:?} from {from} to {to}: {error:?}"),
    }
}

/// By how much rounding changes the angle of which this is the cosine, itself a quotient of sums of squares; 1 for
/// the inputs being rounded.
fn condition_of_limit(r1: f64, r2: f64, diagonal: f64, angle: f64) -> f64 {
    1.0 + (r1 * r1 + r2 * r2 + diagonal * diagonal) / (2.0 * r1 * r2) / angle.sin().abs()
}

/// The diagonal opposite the crank angle is then as long as coupler and rocker together, or as their difference.
#[test]
fn four_bars_stop_at_their_limits() {
    let mut random = Random::new(7);
    let mut found = [0; 2];
    for round in 0..samples::of(400) as usize {
        let scale = [1e-6, 1e-3, 1.0, 1e6][round % 4];
        let [r1, r2, r3, r4] = [(); 4].map(|()| scale * random.between(0.2, 1.0));
        let linkage = FourBar { r1, r2, r3, r4 };
        let Some(range) = linkage.crank_range() else {
            continue;
        };
        let from = range.low + (range.high - range.low) * random.between(0.1, 0.9);
        for assembly in Assembly::BOTH {
            for (end, diagonal, beyond) in [(range.low, r3 - r4, -PI), (range.high, r3 + r4, 10.0)] {
                if end == 0.0 || end == PI {
                    continue;
                }
                // Both at once: the neighbourhood of a change point has a separate test.
                if end < 1e-3 || PI - end < 1e-3 {
                    continue;
                }
                let (block, limit, unknowns) = limit_of(&linkage, assembly, from, beyond);
                assert_eq!(block, "theta3, theta4");
                let tolerance = 8.0 * f64::EPSILON * condition_of_limit(r1, r2, diagonal, end);
                assert!(
                    (limit - end).abs() <= tolerance,
                    "{linkage:?} {limit} {end} {tolerance}"
                );
                assert!((limit - end).abs() <= 1e-12);
                // The links are in line: an angle at a fold is known to the root of the rounding of the inputs.
                let [coupler, rocker] = unknowns;
                let in_line = (coupler - rocker).sin().abs();
                assert!(in_line <= 1e-11, "{linkage:?} {in_line}");
                found[usize::from(beyond > 0.0)] += 1;
            }
        }
    }
    assert!(found.iter().all(|count| *count > samples::of(100)), "{found:?}");
}

#[test]
fn slider_cranks_stop_at_their_limits() {
    let mut random = Random::new(8);
    for round in 0..samples::of(200) as usize {
        let scale = [1e-6, 1.0, 1e6][round % 3];
        let (l, h) = (random.between(0.2, 0.9), random.between(-0.1, 0.1));
        for assembly in Assembly::BOTH {
            let linkage = OffsetSliderCrank {
                r: scale,
                l: l * scale,
                h: h * scale,
            };
            for (sign, to) in [(1.0, 3.0), (-1.0, -3.0)] {
                let (block, limit, unknowns) = limit_of(&linkage, assembly, 0.05, to);
                let expected = (h + sign * l).asin();
                let tolerance = 8.0 * f64::EPSILON / expected.cos();
                assert!((limit - expected).abs() <= tolerance, "{linkage:?} {limit} {expected}");
                assert_eq!(block, "phi");
                assert!(unknowns[0].cos().abs() <= 1e-11);
            }
            let linkage = SliderCrank { r: scale, l: l * scale };
            let (block, limit, _) = limit_of(&linkage, assembly, 0.05, 3.0);
            assert!((limit - l.asin()).abs() <= 8.0 * f64::EPSILON / l.asin().cos());
            assert_eq!(block, "phi");
        }
    }
}

#[test]
fn as_far_as_the_limit_and_back_again() {
    let end = DOUBLE_ROCKER.crank_range().unwrap().high;
    for assembly in Assembly::BOTH {
        for exponent in 1..15 {
            let gap = 10.0_f64.powi(-exponent);
            let beyond = from_to(&DOUBLE_ROCKER, assembly, 0.5, end + gap);
            assert!(
                matches!(&beyond, Err(TrackError::TurningPoint(limit)) if (limit.inputs[0] - end).abs() <= 1e-14),
                "{gap}: {beyond:?}"
            );
            let there = match from_to(&DOUBLE_ROCKER, assembly, 0.5, end - gap) {
                Err(_) if gap < 1e-13 => continue,
                result => result.unwrap(),
            };
            let direct = DOUBLE_ROCKER.position(end - gap, assembly).unwrap().unknowns();
            for (one, other) in there.into_iter().zip(direct) {
                // The angles become more sensitive close to the limit.
                assert!(turned_alike(one, other) <= 64.0 * f64::EPSILON / gap.sqrt(), "{gap}");
            }
            if gap < 1e-12 {
                continue;
            }
            let back = from_to(&DOUBLE_ROCKER, assembly, end - gap, 0.5).unwrap();
            let direct = DOUBLE_ROCKER.position(0.5, assembly).unwrap().unknowns();
            for (one, other) in back.into_iter().zip(direct) {
                assert!(turned_alike(one, other) <= 64.0 * f64::EPSILON, "{gap}");
            }
        }
    }
}

/// A parallelogram can become an antiparallelogram where all its links are in line, and a kite where it is folded.
#[test]
fn branches_that_cross_are_change_points() {
    for (links, is_kite) in [
        ([1.0, 0.4, 1.0, 0.4], false),
        ([1e-3, 0.4e-3, 1e-3, 0.4e-3], false),
        ([1e3, 0.4e3, 1e3, 0.4e3], false),
        ([0.8, 0.8, 0.5, 0.5], true),
    ] {
        let [r1, r2, r3, r4] = links;
        let linkage = FourBar { r1, r2, r3, r4 };
        for assembly in Assembly::BOTH {
            for (to, input) in [(-2.0, 0.0), (4.0, PI)] {
                let result = from_to(&linkage, assembly, 1.0, to);
                // The kite's coupler and rocker are in line only where the diagonal is as long as both.
                if is_kite && input == PI {
                    assert!(matches!(result, Err(TrackError::TurningPoint(_))), "{result:?}");
                    continue;
                }
                let Err(TrackError::ChangePoint(point)) = result else {
                    panic!("{assembly:?} to {to}: {result:?}");
                };
                assert!((point.inputs[0] - input).abs() < 1e-10, "{point:?}");
                assert_eq!(point.block, "theta3, theta4");
            }
        }
    }
}

/// Three links of a parallelogram as they should be, and the fourth off by a little.
#[test]
fn near_a_change_point() {
    let (mut reversed, mut stopped) = (0, 0);
    for exponent in 1..=9 {
        for sign in [1.0, -1.0] {
            let off = sign * 10.0_f64.powi(-exponent);
            for [r1, r2, r3, r4] in [
                [1.0, 0.4, 1.0 + off, 0.4],
                [1.0 + off, 0.4, 1.0, 0.4],
                [1.0, 0.4, 1.0, 0.4 + 0.4 * off],
                [1.0, 0.4 + 0.3 * off, 1.0, 0.4],
            ] {
                let linkage = FourBar { r1, r2, r3, r4 };
                let range = linkage.crank_range().unwrap();
                for assembly in Assembly::BOTH {
                    if range.is_full_revolution() {
                        // The angles are as sensitive as the gap is small.
                        let tolerance = 64.0 * f64::EPSILON / off.abs();
                        go_round(&linkage, assembly, &[1.0, 1.0 + TAU, 2.0], tolerance);
                        reversed += 1;
                    } else {
                        for (end, diagonal, beyond) in [(range.low, r3 - r4, -PI), (range.high, r3 + r4, PI + 1.0)] {
                            if end == 0.0 || end == PI {
                                continue;
                            }
                            let (_, limit, _) = limit_of(&linkage, assembly, 1.0, beyond);
                            let tolerance = 8.0 * f64::EPSILON * condition_of_limit(r1, r2, diagonal, end);
                            assert!(
                                (limit - end).abs() <= tolerance,
                                "{linkage:?} {limit} {end} {tolerance}"
                            );
                            stopped += 1;
                        }
                    }
                }
            }
        }
    }
    assert!(reversed > 20 && stopped > 20, "{reversed} {stopped}");
}

/// If the links of a parallelogram are nearly equal, rounding separates its branches early. Sometimes a change point is
/// reported as a limit, as for dimensions with errors of this size, but usually it is recognised.
#[test]
fn rounding_hides_few_change_points() {
    let mut limits = 0_u32;
    let count = samples::of(800);
    for index in 0..count {
        let part = (f64::from(index) * 0.618_033_988_749_894_9).fract();
        let short = 1.0 - 0.05 * part;
        let linkage = FourBar {
            r1: 1.0,
            r2: short,
            r3: 1.0,
            r4: short,
        };
        let from = 0.4 + 2.0 * (part * 97.0).fract();
        let assembly = Assembly::BOTH[usize::from(index % 2 == 0)];
        match from_to(&linkage, assembly, from, from - 3.0) {
            Err(TrackError::ChangePoint(point)) => assert!(point.inputs[0].abs() < 1e-7, "{linkage:?} {point:?}"),
            Err(TrackError::TurningPoint(limit)) => {
                assert!(limit.inputs[0].abs() < 1e-7, "{linkage:?} {limit:?}");
                limits += 1;
            }
            other => panic!("{linkage:?} {assembly:?} from {from}: {other:?}"),
        }
    }
    assert!(limits * 40 <= count * 3, "{limits} of {count}");
}

/// The second loop stops before the first one does.
#[test]
fn the_block_that_stops_is_named() {
    let linkage: InSeries = InSeries {
        ground: 90.0,
        crank: 30.0,
        coupler: 70.0,
        rocker: 60.0,
        next: 78.0,
    };
    let mut found = 0;
    for assembly in <InSeries as Mechanism>::assemblies() {
        let Ok(start) = Mechanism::position(&linkage, [1.0], assembly) else {
            continue;
        };
        for to in [10.0, -10.0] {
            let result = track(&linkage, [1.0], start, [to]);
            let Err(TrackError::TurningPoint(limit)) = result else {
                panic!("{assembly:?}: {result:?}");
            };
            assert_eq!(limit.block, "c, d");
            // At this position the second diagonal equals coupler and rocker together.
            let [_, b, ..] = limit.unknowns;
            let cosine = (78.0_f64.powi(2) + 60.0 * 60.0 - 130.0 * 130.0) / (2.0 * 78.0 * 60.0);
            assert!((b.cos() - cosine).abs() <= 1e-13, "{limit:?}");
            found += 1;
        }
    }
    assert!(found >= 4, "{found}");
}

/// Where all loops of Peaucellier's linkage reach their limits at once, that is an end and no crossing.
#[test]
fn several_limits_at_once_are_a_limit() {
    let linkage = PeaucellierLinkage::from_parameters([2.0, 2.0, 6.0, 4.0]);
    let mut ended = 0;
    for assembly in PeaucellierLinkage::<f64>::assemblies() {
        let Ok(start) = Mechanism::position(&linkage, [0.6], assembly) else {
            continue;
        };
        let Err(TrackError::TurningPoint(limit)) = track(&linkage, [0.6], start, [3.0]) else {
            panic!("{assembly:?} goes on");
        };
        assert!((limit.inputs[0] - TAU / 3.0).abs() < 1e-12, "{limit:?}");
        ended += 1;
    }
    assert!(ended > 0);
}

#[test]
fn messages_say_where_it_is() {
    let error = from_to(&DOUBLE_ROCKER, Assembly::Open, 0.5, 3.0).unwrap_err();
    assert_eq!(
        error.to_string(),
        "limit position of theta3, theta4 at theta2 = 1.955193 rad (112.0°), after 0.5820772 of the way: two \
         assemblies meet there and neither continues; stop short of it, or drive the mechanism by another input"
    );
    assert_eq!(
        format!("{error:?}"),
        error.to_string(),
        "what a `main` that fails prints"
    );
    let TrackError::TurningPoint(obstacle) = error else {
        panic!("{error}");
    };
    let debugged = format!("{obstacle:?}");
    assert!(
        debugged.starts_with("TrackLimit { block: \"theta3, theta4\", fraction: 0.58"),
        "{debugged}"
    );
}
