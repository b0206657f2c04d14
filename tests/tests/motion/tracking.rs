//! Moving from one position to another without leaving the assembly.

use core::f64::consts::{PI, TAU};

use kin_core::library::{
    FourBar, GeometricFourBar, InvertedSliderCrank, OffsetSliderCrank, PeaucellierLinkage, SliderCrank,
};
use kin_core::prelude::*;
use kin_core::series::Series;
use kin_core::{Name, TrackError, track};
use kin_tests::mechanisms::multi_loop::{FourBarsInSeries, GearedYoke, WattSixBar, Whitworth};
use kin_tests::random::Random;
use kin_tests::samples;

const CRANK_ROCKER: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 70.0,
    r4: 60.0,
};
const DOUBLE_ROCKER: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};

/// Tracks a mechanism of one input from place to place, and compares the result with the direct solution in the same
/// assembly.
fn go_round<M: Mechanism<Scalar = f64>>(mechanism: &M, assembly: M::Assembly, places: &[f64], tolerance: f64) {
    let inputs = |value| M::Inputs::from_fn(|_| value);
    let mut at = places[0];
    let mut unknowns = mechanism.position(inputs(at), assembly).unwrap();
    for &next in &places[1..] {
        let there = track(mechanism, inputs(at), unknowns, inputs(next))
            .unwrap_or_else(|error| panic!("{} {assembly:?} from {at} to {next}: {error:?}", M::DESCRIPTION.name));
        let direct = mechanism.position(inputs(next), assembly).unwrap();
        for (index, (one, other)) in there.as_ref().iter().zip(direct.as_ref()).enumerate() {
            let mut difference = one - other;
            if M::DESCRIPTION.unknowns[index].dimension == kin_core::Dimension::Angle {
                difference -= (difference / TAU).round() * TAU;
            }
            let size = other.abs().max(1.0);
            assert!(
                difference.abs() <= tolerance * size,
                "{} {assembly:?} from {at} to {next}, unknown {index}: {one} {other}",
                M::DESCRIPTION.name
            );
        }
        (at, unknowns) = (next, there);
    }
}

#[test]
fn every_crank_goes_round() {
    let turns = f64::from(if cfg!(feature = "every-case") { 100_u8 } else { 10 });
    let places = [0.3, 0.3 + TAU, 2.0, -4.0 * PI + 0.1, turns * TAU + 1.0, 0.3];
    for assembly in Assembly::BOTH {
        go_round(&CRANK_ROCKER, assembly, &places, 1e-12);
        go_round(&SliderCrank { r: 1.0, l: 2.5 }, assembly, &places, 1e-12);
        go_round(&OffsetSliderCrank { r: 1.0, l: 2.5, h: 0.4 }, assembly, &places, 1e-12);
        // solved triangle by triangle
        let FourBar { r1, r2, r3, r4 } = CRANK_ROCKER;
        let linkage = GeometricFourBar { r1, r2, r3, r4 };
        go_round(&linkage, linkage.assembly(0.3, assembly), &places, 1e-12);
    }
    go_round(&InvertedSliderCrank { r1: 2.0, r2: 1.0 }, (), &places, 1e-12);
    go_round(&InvertedSliderCrank { r1: 1.0, r2: 2.0 }, (), &places, 1e-12);
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
    for round in 0..samples::of(400) {
        let scale = [1e-6, 1e-3, 1.0, 1e6][round % 4];
        let [r1, r2, r3, r4] = [(); 4].map(|()| scale * random.between(0.2, 1.0));
        let linkage = FourBar { r1, r2, r3, r4 };
        let Some(range) = linkage.crank_range() else {
            continue;
        };
        let from = range.low + (range.high - range.low) * random.between(0.1, 0.9);
        for assembly in Assembly::BOTH {
            for (end, diagonal, beyond) in [(range.low, r3 - r4, -PI), (range.high, r3 + r4, PI + 1.0)] {
                if end == 0.0 || end == PI {
                    continue;
                }
                // Both at once: the neighbourhood of a change point has its own test.
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
fn slider_cranks_stop_where_the_rod_is_at_right_angles() {
    let mut random = Random::new(8);
    for round in 0..samples::of(200) {
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

/// Three links of a parallelogram as they should be, and the fourth off by a little.
#[test]
fn near_a_change_point_the_assembly_is_kept_or_the_limit_found() {
    let (mut turned, mut stopped) = (0, 0);
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
                    if range.is_full_turn() {
                        // The angles are as sensitive as the gap is small.
                        let tolerance = 64.0 * f64::EPSILON / off.abs();
                        go_round(&linkage, assembly, &[1.0, 1.0 + TAU, 2.0], tolerance);
                        turned += 1;
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
    assert!(turned > 20 && stopped > 20, "{turned} {stopped}");
}

#[test]
fn a_parallelogram_has_change_points() {
    for (links, block) in [
        ([1.0, 0.4, 1.0, 0.4], "theta3, theta4"),
        ([0.8, 0.8, 0.5, 0.5], "theta3, theta4"),
    ] {
        let [r1, r2, r3, r4] = links;
        let linkage = FourBar { r1, r2, r3, r4 };
        for assembly in Assembly::BOTH {
            for (to, place) in [(-2.0, 0.0), (4.0, PI)] {
                let start = linkage.position(1.0, assembly).unwrap().unknowns();
                let result = track(&linkage, [1.0], start, [to]);
                // The kite's coupler and rocker are in line at π only where the diagonal is as long as both.
                if links[0] == 0.8 && place == PI {
                    assert!(matches!(result, Err(TrackError::TurningPoint(_))), "{result:?}");
                    continue;
                }
                let Err(TrackError::ChangePoint(point)) = result else {
                    panic!("{linkage:?} {assembly:?} to {to}: {result:?}");
                };
                assert!((point.inputs[0] - place).abs() < 1e-10, "{point:?}");
                assert_eq!(point.block, block);
            }
        }
    }
}

#[test]
fn loops_one_after_the_other() {
    let watt = WattSixBar::<f64>::from_parameters([4.0, 1.0, 3.5, 3.0, 1.0, 1.2, 8.0, 0.5, 4.0, 3.0]);
    let places = [0.3, 0.3 + TAU, -5.0, 12.0 * TAU];
    let mut count = 0;
    for assembly in WattSixBar::<f64>::assemblies() {
        go_round(&watt, assembly, &places, 1e-12);
        count += 1;
    }
    assert_eq!(count, 4);
    let whitworth = Whitworth::<f64>::from_parameters([1.0, 2.0, 1.5, 6.0, 1.0]);
    for assembly in Whitworth::<f64>::assemblies() {
        go_round(&whitworth, assembly, &places, 1e-12);
    }
    let yoke = GearedYoke::<f64>::from_parameters([90.0, 30.0, 70.0, 60.0, 7.5, 3.0]);
    for assembly in GearedYoke::<f64>::assemblies() {
        go_round(&yoke, assembly, &[0.3, 2.0, 0.1], 1e-11);
    }
}

/// The second loop stops first: its crank is the first one's rocker.
#[test]
fn the_block_that_stops_is_named() {
    let linkage = FourBarsInSeries::<f64>::from_parameters([90.0, 30.0, 70.0, 60.0, 100.0, 80.0, 60.0]);
    let first = CRANK_ROCKER;
    let mut found = 0;
    for assembly in FourBarsInSeries::<f64>::assemblies() {
        let Ok(_) = linkage.position(1.0, assembly) else {
            continue;
        };
        for to in [10.0, -10.0] {
            let (block, limit, unknowns) = limit_of(&linkage, assembly, 1.0, to);
            assert_eq!(block, "phi3, phi4");
            // cos of the rocker's angle where the second diagonal is coupler and rocker together
            let expected = (100.0_f64.powi(2) + 60.0_f64.powi(2) - 140.0_f64.powi(2)) / (2.0 * 100.0 * 60.0);
            let near = [unknowns[0], unknowns[1]];
            let crank = Motion::from((limit, 1.0, 0.0, 0.0, 0.0));
            let rocker = first.solve(crank, first.assembly_at(limit, near)).unwrap().theta4;
            // where the rocker moves fast, its angle is known as badly
            let tolerance = 16.0 * f64::EPSILON * (1.0 + rocker.velocity().abs());
            assert!((rocker.value().cos() - expected).abs() <= tolerance, "{rocker:?}");
            found += 1;
        }
    }
    assert!(found >= 4, "{found}");
}

#[test]
fn to_the_limit_and_hardly_further() {
    let end = DOUBLE_ROCKER.crank_range().unwrap().high;
    for assembly in Assembly::BOTH {
        let start = DOUBLE_ROCKER.position(0.5, assembly).unwrap().unknowns();
        for exponent in 1..15 {
            let gap = 10.0_f64.powi(-exponent);
            // short of it
            let result = track(&DOUBLE_ROCKER, [0.5], start, [end - gap]);
            if let Ok(there) = result {
                let direct = DOUBLE_ROCKER.position(end - gap, assembly).unwrap().unknowns();
                // the angles are as sensitive as the limit is near
                let tolerance = 64.0 * f64::EPSILON / gap.sqrt();
                for (one, other) in there.into_iter().zip(direct) {
                    let difference = one - other - ((one - other) / TAU).round() * TAU;
                    assert!(difference.abs() <= tolerance, "{gap}: {difference}");
                }
            } else {
                assert!(gap < 1e-13, "{gap}: {result:?}");
            }
            // beyond it
            let result = track(&DOUBLE_ROCKER, [0.5], start, [end + gap]);
            let Err(TrackError::TurningPoint(limit)) = result else {
                panic!("{gap}: {result:?}");
            };
            assert!((limit.inputs[0] - end).abs() < 1e-14, "{gap}: {limit:?}");
        }
    }
}

#[test]
fn from_near_a_limit_and_back() {
    let end = DOUBLE_ROCKER.crank_range().unwrap().high;
    for assembly in Assembly::BOTH {
        for gap in [1e-2, 1e-6, 1e-10, 1e-12] {
            let start = DOUBLE_ROCKER.position(end - gap, assembly).unwrap().unknowns();
            let back = track(&DOUBLE_ROCKER, [end - gap], start, [0.5]).unwrap();
            let direct = DOUBLE_ROCKER.position(0.5, assembly).unwrap().unknowns();
            for (one, other) in back.into_iter().zip(direct) {
                let difference = one - other - ((one - other) / TAU).round() * TAU;
                assert!(difference.abs() <= 64.0 * f64::EPSILON);
            }
        }
    }
}

#[test]
fn other_number_types() {
    let linkage = CRANK_ROCKER;
    let start = linkage.position(0.5, Assembly::Crossed).unwrap().unknowns();
    let expected = track(&linkage, [0.5], start, [4.0]).unwrap();

    let single = linkage.convert(f32::constant);
    let end = track(&single, [0.5], start.map(f32::constant), [4.0]).unwrap();
    for (one, other) in end.into_iter().zip(expected) {
        assert!((f64::from(one) - other).abs() <= 16.0 * f64::from(f32::EPSILON));
    }

    let series = linkage.convert(|value| Series::from_coefficients([value, 0.0, 0.0]));
    let constant = |value| Series::from_coefficients([value, 0.0, 0.0]);
    let moving = Series::from_derivatives([4.0, 2.0, -1.0]);
    let end = track(&series, [constant(0.5)], start.map(constant), [moving]).unwrap();
    let direct = linkage
        .solve(Motion::from((4.0, 2.0, -1.0, 0.0, 0.0)), Assembly::Crossed)
        .unwrap();
    for (one, other) in end.into_iter().zip(direct.unknown_motions()) {
        let [_, velocity, acceleration] = one.derivatives();
        assert!((velocity - other.velocity()).abs() <= 64.0 * f64::EPSILON * (1.0 + velocity.abs()));
        assert!((acceleration - other.acceleration()).abs() <= 64.0 * f64::EPSILON * (1.0 + acceleration.abs()));
    }
}

#[test]
fn nothing_to_do_and_nothing_to_be_done() {
    let linkage = DOUBLE_ROCKER;
    let start = linkage.position(0.5, Assembly::Open).unwrap().unknowns();
    assert_eq!(track(&linkage, [0.5], start, [0.5]), Ok(start));
    // a position that does not exist at the beginning
    let result = track(&linkage, [2.5], start, [0.5]);
    assert!(
        matches!(result, Err(TrackError::Failed(error)) if error.margin() < Some(0.0)),
        "{result:?}"
    );
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (from, to) in [(value, 0.5), (0.5, value)] {
            let result = track(&linkage, [from], start, [to]);
            assert!(
                matches!(result, Err(TrackError::Failed(error)) if matches!(error.failure, Failure::NotFinite { .. })),
                "{result:?}"
            );
        }
        let result = track(&linkage, [0.5], [value, 0.0], [0.6]);
        if let Ok(end) = result {
            assert!(end.iter().all(|angle| angle.is_finite()), "{end:?}");
        }
    }
}

#[test]
fn messages_say_where_and_what_to_do() {
    let start = DOUBLE_ROCKER.position(0.5, Assembly::Open).unwrap().unknowns();
    let error = track(&DOUBLE_ROCKER, [0.5], start, [3.0]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "limit position of theta3, theta4 at theta2 = 1.955193 rad (112.0°), after 0.5820772 of the way: two assemblies meet there \
         and neither continues; stop short of it, or drive the mechanism by another input"
    );
}

mechanism! {
    /// A five-bar with two cranks and a wheel that is geared up, to the velocity.
    struct FiveBar {
        ground: Length,
        crank: Length,
        link: Length,
        ratio: Scalar,
    }
    order = 1;
    input left: Angle, right: Angle;
    unknown alpha: Angle, beta: Angle, wheel: Angle;
    crank * cis(left) + link * cis(alpha) == ground + crank * cis(right) + link * cis(beta);
    wheel == ratio * beta;
}

mechanism! {
    /// The same to a high order.
    struct FiveBarOfOrderEight {
        ground: Length,
        crank: Length,
        link: Length,
        ratio: Scalar,
    }
    order = 8;
    input left: Angle, right: Angle;
    unknown alpha: Angle, beta: Angle, wheel: Angle;
    crank * cis(left) + link * cis(alpha) == ground + crank * cis(right) + link * cis(beta);
    wheel == ratio * beta;
}

/// Moves both cranks of a five-bar round a triangle and back, and then apart as far as they go.
fn both_cranks<M: Mechanism<Scalar = f64, Assembly = Assembly>>(mechanism: &M) {
    let inputs = |left: f64, right: f64| M::Inputs::from_fn(|index| [left, right][index]);
    for assembly in Assembly::BOTH {
        let start = mechanism.position(inputs(0.5, 1.5), assembly).unwrap();
        let corners = [(0.5, 1.5), (0.5 + TAU, 1.5 - TAU), (0.5 + TAU, 1.5), (0.5, 1.5)];
        let mut unknowns = start;
        for legs in corners.windows(2) {
            let [from, to] = [legs[0], legs[1]];
            unknowns = track(mechanism, inputs(from.0, from.1), unknowns, inputs(to.0, to.1)).unwrap();
            // The wheel turns a hundred times as far as the coupler, and comes back as well.
            for (one, other) in unknowns.as_ref().iter().zip(start.as_ref()) {
                assert!(
                    (one - other).abs() <= 1e-11,
                    "{} {assembly:?}: {one} {other}",
                    M::DESCRIPTION.name
                );
            }
        }
        // Spread too far, the pins are as far apart as both links are long.
        let small = M::from_parameters(M::Parameters::from_fn(|index| [10.0, 3.0, 4.0, 100.0][index]));
        let start = small.position(inputs(0.5, PI - 0.4), assembly).unwrap();
        let result = track(&small, inputs(0.5, PI - 0.4), start, inputs(1.5, 1.0));
        let Err(error) = result else {
            panic!("it does not reach");
        };
        let message = error.to_string();
        let TrackError::TurningPoint(limit) = error else {
            panic!("{error:?}");
        };
        let [left, right] = [0, 1].map(|index| limit.inputs[index]);
        // along the line of inputs
        assert!(
            ((left - 0.5) - (right - PI + 0.4) / (1.0 - PI + 0.4)).abs() <= 1e-15,
            "{message}"
        );
        let span = (10.0 + 3.0 * (right.cos() - left.cos())).hypot(3.0 * (right.sin() - left.sin()));
        assert!((span - 8.0).abs() <= 16.0 * f64::EPSILON * 16.0, "{span}");
        assert!(
            message.starts_with("limit position of alpha, beta at left = "),
            "{message}"
        );
        assert!(message.contains(", right = "), "{message}");
        assert_eq!(limit.block, "alpha, beta");
    }
}

#[test]
fn several_inputs_and_any_order() {
    let parameters = [10.0, 3.0, 10.0, 100.0];
    both_cranks(&FiveBar::<f64>::from_parameters(parameters));
    both_cranks(&FiveBarOfOrderEight::<f64>::from_parameters(parameters));
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
