//! Several loops, block after block, are several mechanisms, one after the other: what the first gives drives the
//! second.

use core::f64::consts::PI;

use kin_core::library::{FourBar, InvertedSliderCrank, OffsetSliderCrank};
use kin_core::prelude::*;
use kin_tests::compare::assert_agree;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::multi_loop::*;
use kin_tests::oracles::Gauge;
use kin_tests::random::Random;

type Angle = Motion<f64, 5>;

const FIRST: FourBar = FourBar {
    r1: 4.0,
    r2: 1.0,
    r3: 3.0,
    r4: 2.5,
};

fn constant(value: f64) -> Angle {
    Motion::constant(value)
}

/// Crank motions all around.
fn cranks(seed: u64) -> Vec<Angle> {
    let mut random = Random::new(seed);
    (0..72)
        .map(|step| Motion::new(random.motion((f64::from(5 * step) + 0.4).to_radians())))
        .collect()
}

/// Compares the unknowns of a chain with those of its parts. Errors of the parts feed the whole, whose gauge holds all
/// of it.
fn assert_all_agree<M: ThroughSnap>(mechanism: &M, crank: Angle, own: &M::Unknowns<Angle>, expected: &[(Angle, bool)]) {
    let gauge = Gauge::new(mechanism, &M::Inputs::from_fn(|_| crank), own);
    let gauges: Vec<(&Gauge, usize)> = (0..expected.len()).map(|index| (&gauge, index)).collect();
    for (index, (own, (expected, is_angle))) in own.as_ref().iter().zip(expected).enumerate() {
        let name = M::DESCRIPTION.unknowns[index].name;
        assert_agree(name, *own, *expected, *is_angle, &gauges);
    }
}

#[test]
fn four_bars_in_series() {
    let parameters = [4.0, 1.0, 3.0, 2.5, 4.0, 4.5, 3.0];
    let chain = FourBarsInSeries::<f64>::from_parameters(parameters);
    let shuffled = FourBarsInSeriesShuffled::<f64>::from_parameters(parameters);
    let second = FourBar {
        r1: 4.0,
        r2: 2.5,
        r3: 4.5,
        r4: 3.0,
    };
    let mut count = 0;
    for crank in cranks(31) {
        for assembly in FourBarsInSeries::ASSEMBLIES {
            let rocker = FIRST.solve(crank, assembly.theta3_theta4).expect("it closes");
            let Ok(driven) = second.solve(rocker.theta4, assembly.phi3_phi4) else {
                continue;
            };
            let own = chain.solve(crank, assembly).expect("both parts close");
            let [a, b, c, d] = [rocker.theta3, rocker.theta4, driven.theta3, driven.theta4].map(|angle| (angle, true));
            assert_all_agree(&chain, crank, &own.unknown_motions(), &[a, b, c, d]);
            let assembly = FourBarsInSeriesShuffledAssembly {
                theta3_theta4: assembly.theta3_theta4,
                phi3_phi4: assembly.phi3_phi4,
            };
            let own = shuffled.solve(crank, assembly).expect("both parts close");
            assert_all_agree(&shuffled, crank, &own.unknown_motions(), &[c, a, d, b]);
            count += 1;
        }
    }
    assert!(count > 100, "{count}");
    // the order in which they are solved is found, not typed
    for blocks in [
        <FourBarsInSeries>::DESCRIPTION.blocks,
        <FourBarsInSeriesShuffled>::DESCRIPTION.blocks,
    ] {
        let unknowns: Vec<&str> = blocks.iter().map(|block| block.unknowns).collect();
        assert_eq!(unknowns, ["theta3, theta4", "phi3, phi4"]);
    }
}

/// The second loop is a four-bar linkage between the rocker's pivot and the last one, its crank the rocker's other arm.
#[test]
fn watt_six_bar() {
    let chain = WattSixBar::<f64>::from_parameters([4.0, 1.0, 3.0, 2.5, 2.0, 1.0, 7.0, 0.5, 3.0, 2.5]);
    let arm = f64::hypot(2.0, 1.0);
    let arm_angle = constant(f64::atan2(1.0, 2.0));
    let frame = constant(f64::atan2(0.5, 3.0));
    let second = FourBar {
        r1: f64::hypot(3.0, 0.5),
        r2: arm,
        r3: 3.0,
        r4: 2.5,
    };
    let mut count = 0;
    for crank in cranks(32) {
        for assembly in WattSixBar::ASSEMBLIES {
            let first = FIRST.solve(crank, assembly.theta3_theta4).expect("it closes");
            let Ok(driven) = second.solve(first.theta4 + arm_angle - frame, assembly.theta5_theta6) else {
                continue;
            };
            let own = chain.solve(crank, assembly).expect("both parts close");
            let expected = [first.theta3, first.theta4, driven.theta3 + frame, driven.theta4 + frame];
            assert_all_agree(
                &chain,
                crank,
                &own.unknown_motions(),
                &expected.map(|angle| (angle, true)),
            );
            count += 1;
        }
    }
    assert!(count > 100, "{count}");
}

/// The ram's lever goes all the way round with the crank's pin, then drives a slider-crank.
#[test]
fn quick_return() {
    let mechanism = Whitworth::<f64>::from_parameters([0.5, 1.2, 1.5, 5.0, 0.3]);
    let lever = InvertedSliderCrank { r1: 0.5, r2: 1.2 };
    let press = OffsetSliderCrank { r: 1.5, l: 5.0, h: 0.3 };
    let quarter = constant(PI / 2.0);
    for crank in cranks(33) {
        for assembly in Assembly::BOTH {
            let turning = lever.solve(crank - quarter).expect("the lever reaches the pin");
            let phi = turning.theta4 + quarter;
            let ram = press.solve(phi, assembly).expect("the rod is long enough");
            let own = mechanism.solve(crank, assembly).expect("both parts close");
            let expected = [(turning.r4, false), (phi, true), (-ram.phi, true), (ram.s, false)];
            assert_all_agree(&mechanism, crank, &own.unknown_motions(), &expected);
        }
    }
    // the lever turns fully, and returns faster than it goes
    let speed = |angle: f64| {
        let pose = mechanism
            .solve(Motion::at_constant_speed(angle, 1.0), Assembly::Open)
            .expect("it closes");
        pose.phi.velocity()
    };
    assert!(speed(-PI / 2.0) > 1.5 && speed(PI / 2.0) < 0.8);
}

/// Scalar relations after a loop: a gear train and a scotch yoke, by the rules of sums and products of motions.
#[test]
fn relations_after_a_loop() {
    let mechanism = GearedYoke::<f64>::from_parameters([4.0, 1.0, 3.0, 2.5, 2.5, 0.7]);
    for crank in cranks(34) {
        for assembly in Assembly::BOTH {
            let first = FIRST.solve(crank, assembly).expect("it closes");
            let own = mechanism.solve(crank, assembly).expect("it closes");
            // on the turn on which the rocker was found
            let shaft = (first.theta4 - crank).scale(2.5);
            let yoke = shaft.sin_cos().0.scale(0.7);
            let expected = [
                (first.theta3, true),
                (first.theta4, true),
                (shaft, false),
                (yoke, false),
                (yoke.scale(0.25), false),
            ];
            assert_all_agree(&mechanism, crank, &own.unknown_motions(), &expected);
        }
    }
    let unknowns: Vec<&str> = <GearedYoke>::DESCRIPTION
        .blocks
        .iter()
        .map(|block| block.unknowns)
        .collect();
    assert_eq!(unknowns, ["theta3, theta4", "shaft", "yoke", "area"]);
}

/// Each block's failure is told with the block's own unknowns.
#[test]
fn the_block_that_fails_is_named() {
    let far = FourBarsInSeries::<f64>::from_parameters([4.0, 1.0, 3.0, 2.5, 40.0, 4.5, 3.0]);
    let error = far
        .position(1.0, FourBarsInSeries::ASSEMBLIES[0])
        .expect_err("the second loop is too long");
    assert_eq!(error.block, "phi3, phi4");
    let Failure::OutOfReach { margin } = error.failure else {
        panic!("{error}");
    };
    // the gap is the distance from the rocker's pin to the last pivot, less what the two links span
    let rocker = FIRST.position(1.0, Assembly::Open).expect("it closes").theta4.value();
    let distance = f64::hypot(40.0 - 2.5 * rocker.cos(), 2.5 * rocker.sin());
    assert!((margin - (7.5 - distance)).abs() < 1e-13, "{margin}");

    let wide = FourBarsInSeries::<f64>::from_parameters([40.0, 1.0, 3.0, 2.5, 4.0, 4.5, 3.0]);
    let error = wide
        .position(1.0, FourBarsInSeries::ASSEMBLIES[0])
        .expect_err("the first loop is too long");
    assert_eq!(error.block, "theta3, theta4");
}
