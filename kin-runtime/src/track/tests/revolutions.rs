//! Tracks that arrive, in the assembly in which they began.

use core::f64::consts::{PI, TAU};
use std::string::ToString;

use super::{CRANK_ROCKER, DOUBLE_ROCKER, TrackError, track};
use crate::library::{FourBar, GeometricFourBar, InvertedSliderCrank, OffsetSliderCrank, SliderCrank};
use crate::number::samples;
use crate::prelude::*;
use crate::series::Series;

/// Tracks a mechanism of one input from input to input, and compares the result with the direct solution in the same
/// assembly. Back at the first input, no angle has gained a revolution.
pub(super) fn go_round<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    assembly: M::Assembly,
    stops: &[f64],
    tolerance: f64,
) {
    let inputs = |value| M::Inputs::from_fn(|_| value);
    let mut at = stops[0];
    let start = mechanism.position(inputs(at), assembly).unwrap();
    let mut unknowns = start;
    for &next in &stops[1..] {
        let there = track(mechanism, inputs(at), unknowns, inputs(next))
            .unwrap_or_else(|error| panic!("{} {assembly:?} from {at} to {next}: {error:?}", M::DESCRIPTION.name));
        let direct = mechanism.position(inputs(next), assembly).unwrap();
        for (index, (one, other)) in there.as_ref().iter().zip(direct.as_ref()).enumerate() {
            let mut difference = one - other;
            if M::DESCRIPTION.unknowns[index].dimension == crate::Dimension::Angle {
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
    if stops.first() == stops.last() {
        for (one, other) in unknowns.as_ref().iter().zip(start.as_ref()) {
            assert!((one - other).abs() <= tolerance * other.abs().max(1.0), "{one} {other}");
        }
    }
}

#[test]
fn every_crank_goes_round() {
    let revolutions = f64::from(if samples::are_all() { 100_u8 } else { 10 });
    let stops = [0.3, 0.3 + TAU, 2.0, -4.0 * PI + 0.1, revolutions * TAU + 1.0, 0.3];
    for assembly in Assembly::BOTH {
        go_round(&CRANK_ROCKER, assembly, &stops, 1e-12);
        go_round(&SliderCrank { r: 1.0, l: 2.5 }, assembly, &stops, 1e-12);
        go_round(&OffsetSliderCrank { r: 1.0, l: 2.5, h: 0.4 }, assembly, &stops, 1e-12);
        // solved triangle by triangle
        let FourBar { r1, r2, r3, r4 } = CRANK_ROCKER;
        let linkage = GeometricFourBar { r1, r2, r3, r4 };
        go_round(&linkage, linkage.assembly(0.3, assembly), &stops, 1e-12);
    }
    go_round(&InvertedSliderCrank { r1: 2.0, r2: 1.0 }, (), &stops, 1e-12);
    go_round(&InvertedSliderCrank { r1: 1.0, r2: 2.0 }, (), &stops, 1e-12);
}

#[test]
fn levers_turn_with_a_long_crank() {
    for (r1, r2) in [(2.0, 1.0), (1.0, 2.0)] {
        let lever = InvertedSliderCrank { r1, r2 };
        let start = lever.position(0.3).unwrap().unknowns();
        let end = track(&lever, [0.3], start, [0.3 + TAU]).unwrap();
        // The lever makes full revolutions if the crank is longer than the ground link.
        let gained = if r2 > r1 { TAU } else { 0.0 };
        assert!((end[0] - start[0]).abs() <= 1e-12 && (end[1] - start[1] - gained).abs() <= 1e-12);
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
fn nothing_to_do() {
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

crate::mechanism! {
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

crate::mechanism! {
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
            // The wheel rotates a hundred times as far as the coupler, and comes back as well.
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
