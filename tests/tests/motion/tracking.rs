//! Tracks of mechanisms of several loops, and of functions of all kinds.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use kin_core::prelude::*;
use kin_core::{TrackError, TrackErrorOf, track};
use kin_tests::mechanisms::dyads::FourBarOnGround;
use kin_tests::mechanisms::multi_loop::{GearedYoke, WattSixBar, Whitworth};
use kin_tests::mechanisms::scalar_forms::ExplicitFunctions;

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

/// A link of 10⁻⁷ between links of 10⁷: rounding of the long ones is as long as the short one.
#[test]
fn what_rounding_hides_is_said_to_be_hidden() {
    let loose = FourBarOnGround {
        a: 9.105_967_560_851_677e-6,
        b: 4.003_901_031_903_985_6e-7,
        c: 65_419_004.600_320_585,
        ground: Plane::new(-60_425_480.430_807_11, -25_068_056.917_164_74),
    };
    let q = -0.594_140_271_763_608_8;
    let start = loose
        .position_near(q, [-0.163_994_480_268_146_78, 0.393_249_907_166_953_07])
        .unwrap();
    let error = track(&loose, [q], start.unknowns(), [q + 6.0]).unwrap_err();
    let message = error.to_string();
    let TrackError::Lost(halt) = error else {
        panic!("{error:?}");
    };
    // The rounding of 6.5·10⁷ over a length of 4·10⁻⁷
    let expected = f64::EPSILON * loose.c / loose.b;
    assert!(
        halt.rounding > expected && halt.rounding < 100.0 * expected,
        "{halt:?} {expected}"
    );
    assert!(halt.steps > 0 && halt.steps < 1000 && halt.fraction < 1.0);
    assert!(
        message.starts_with(
            "no step, however short, is certain to stay in the assembly at q = -0.5941403 rad (-34.0°), after 0 of \
                the way"
        ),
        "{message}"
    );
}

fn explicit_from(parameters: [f64; 2], from: f64, to: f64) -> TrackErrorOf<ExplicitFunctions> {
    let linkage: ExplicitFunctions = Mechanism::from_parameters(parameters);
    let start = linkage.position(from).unwrap().unknowns();
    track(&linkage, [from], start, [to]).unwrap_err()
}

/// A number, tan(t / 3) with more added, beside lengths from 1 to 10⁻³¹⁰.
#[test]
fn pole_of_a_tangent_at_all_sizes() {
    for ([a, b], from, to) in [
        (
            [1.165_632_304_887_356, 1.761_090_836_288_054_4],
            2.959_397_580_977_685_6,
            4.785_726_533_080_55,
        ),
        ([4.0, 4.0], -FRAC_PI_2, -5.428_284_961_713_889),
        (
            [0.001_365_941_038_360_580_6, 1e-310],
            -0.300_534_231_232_456_15,
            -5.963_836_579_991_033,
        ),
    ] {
        let error = explicit_from([a, b], from, to);
        let TrackError::Pole(pole) = error else {
            panic!("{a} {b}: {error:?}");
        };
        assert_eq!(pole.block, "w");
        assert!((pole.inputs[0].abs() - 1.5 * PI).abs() <= 1e-12, "{pole:?}");
    }
}

/// Where its second argument is negative, `atan2` jumps by a turn as the first one changes its sign.
#[test]
fn a_jump_is_told_from_rounding() {
    let parameters = [0.017_291_332_113_243_525, 12.019_536_010_118_113];
    let error = explicit_from(parameters, -0.349_601_349_875_141_6, 3.613_210_954_182_769_3);
    assert!(error.to_string().contains("an unknown jumps there"), "{error}");
    let TrackError::Lost(halt) = error else {
        panic!("{error:?}");
    };
    assert!(halt.inputs[0].abs() <= 1e-12 && halt.rounding <= 1e-12, "{halt:?}");
}
