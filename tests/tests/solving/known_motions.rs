//! Single loops of other kinds, held against motions that are known beforehand.
//!
//! The unknowns move as given, the inputs follow by the rules of sums and products, and the solver has to find the
//! unknowns again, through snap.

use core::f64::consts::PI;

use kin_core::library::FourBar;
use kin_core::prelude::*;
use kin_tests::compare::assert_agree;
use kin_tests::mechanisms::dyads::*;
use kin_tests::oracles::Gauge;
use kin_tests::random::Random;

/// A length along an angle: its coordinates in motion.
fn polar(length: f64, angle: Motion<f64, 5>) -> [Motion<f64, 5>; 2] {
    let (sine, cosine) = angle.sin_cos();
    [cosine.scale(length), sine.scale(length)]
}

#[test]
fn the_arm_finds_its_joints() {
    let mut random = Random::new(21);
    let arm = TwoLinkArm::<f64>::from_parameters([1.2, 0.9]);
    let by_polar = TwoLinkArmPolar::<f64>::from_parameters([1.2, 0.9]);
    for _ in 0..300 {
        let q1 = Motion::new({
            let angle = random.between(-PI, PI);
            random.motion(angle)
        });
        let q2 = Motion::new({
            let angle = random.between(0.1, PI - 0.1);
            random.motion(angle)
        });
        for (q2, assembly) in [(q2, Assembly::Crossed), (-q2, Assembly::Open)] {
            let ([x1, y1], [x2, y2]) = (polar(1.2, q1), polar(0.9, q1 + q2));
            let (x, y) = (x1 + x2, y1 + y2);
            let own = arm.solve(x, y, assembly).expect("the arm reaches its own hand");
            let gauge = Gauge::new(&arm, &[x, y], &own.unknown_motions());
            assert_agree("shoulder", own.q1, q1, true, &[(&gauge, 0), (&gauge, 1)]);
            assert_agree("elbow", own.q2, q2, true, &[(&gauge, 1), (&gauge, 0)]);
            assert_eq!(
                arm.assembly_at(x.value(), y.value(), [q1.value(), q2.value()]),
                assembly
            );

            // the same arm with the hand at a fixed azimuth: there the wrist's circle is the input
            let radius = Motion::constant(x.value().hypot(y.value()));
            let azimuth = Motion::constant(y.value().atan2(x.value()));
            let own = by_polar.solve(radius, azimuth, assembly).expect("it is the same hand");
            let gauge = Gauge::new(&by_polar, &[radius, azimuth], &own.unknown_motions());
            let still = |angle: Motion<f64, 5>| Motion::constant(angle.value());
            assert_agree("shoulder", own.q1, still(q1), true, &[(&gauge, 0), (&gauge, 1)]);
            assert_agree("elbow", own.q2, still(q2), true, &[(&gauge, 1), (&gauge, 0)]);
        }
    }
    assert_eq!(<TwoLinkArm>::DESCRIPTION.blocks, <TwoLinkArmPolar>::DESCRIPTION.blocks);
}

/// The slides' travels, by the law of sines in their triangle.
#[test]
fn two_lengths() {
    let mut random = Random::new(22);
    let (r, alpha, beta) = (1.3, 0.4, 2.2);
    let slides = TwoSlides::<f64>::from_parameters([r, alpha, beta]);
    for step in 0..72 {
        let theta = Motion::new(random.motion((f64::from(5 * step) + 0.4).to_radians()));
        let own = slides.solve(theta).expect("the slides cross");
        let gauge = Gauge::new(&slides, &[theta], &own.unknown_motions());
        let between = f64::sin(beta - alpha);
        let a = (Motion::constant(beta) - theta).sin_cos().0.scale(r / between);
        let b = (theta - Motion::constant(alpha)).sin_cos().0.scale(r / between);
        assert_agree("a", own.a, a, false, &[(&gauge, 0)]);
        assert_agree("b", own.b, b, false, &[(&gauge, 1)]);
    }
    // parallel slides cannot carry the pin
    let parallel = TwoSlides::<f64>::from_parameters([r, alpha, alpha]);
    let error = parallel.position(0.3).expect_err("the slides are parallel");
    assert!(matches!(error.failure, Failure::Singular { .. }), "{error}");

    // the pivots' distance is seen from the pin under a fixed angle
    let swinging = SwingingSlides::<f64>::from_parameters([2.0, 1.2]);
    for step in 0..72 {
        let theta = Motion::new(random.motion((f64::from(5 * step) + 0.4).to_radians()));
        let own = swinging.solve(theta).expect("the slides cross");
        let gauge = Gauge::new(&swinging, &[theta], &own.unknown_motions());
        let a = (theta + Motion::constant(1.2)).sin_cos().0.scale(2.0 / f64::sin(1.2));
        let b = theta.sin_cos().0.scale(2.0 / f64::sin(1.2));
        assert_agree("a", own.a, a, false, &[(&gauge, 0)]);
        assert_agree("b", own.b, b, false, &[(&gauge, 1)]);
    }
    assert_eq!(<TwoSlides>::DESCRIPTION.blocks[0].solution, "two linear equations");
    assert_eq!(<SwingingSlides>::DESCRIPTION.blocks[0].solution, "two linear equations");
}

/// A ternary link is an ordinary one with its angle shifted.
#[test]
fn ternary_links() {
    let mut random = Random::new(23);
    let (gamma, delta) = (0.3, 0.5);
    let linkage = FourBar {
        r1: 4.0,
        r2: 1.0,
        r3: 3.0,
        r4: 2.5,
    };
    let shifted = OffsetAngles::<f64>::from_parameters([4.0, 1.0, 3.0, 2.5, gamma, delta]);
    let (p, q) = (3.0 * f64::cos(gamma), 3.0 * f64::sin(gamma));
    let (x, y) = (2.5 * f64::cos(-delta), 2.5 * f64::sin(-delta));
    let complex = ComplexLinks::<f64>::from_parameters([4.0, 0.0, 1.0, p, q, x, y]);
    for step in 0..72 {
        let theta2 = Motion::new(random.motion((f64::from(5 * step) + 0.4).to_radians()));
        for assembly in Assembly::BOTH {
            let plain = linkage.solve(theta2, assembly).expect("it closes");
            let by_angles = shifted.solve(theta2, assembly).expect("it closes");
            let by_vectors = complex.solve(theta2, assembly).expect("it closes");
            let gauge = Gauge::new(&linkage, &[theta2], &plain.unknown_motions());
            let theta3 = plain.theta3 - Motion::constant(gamma);
            let theta4 = plain.theta4 + Motion::constant(delta);
            for (name, own) in [
                ("by angles", by_angles.unknown_motions()),
                ("by vectors", by_vectors.unknown_motions()),
            ] {
                assert_agree(name, own[0], theta3, true, &[(&gauge, 0), (&gauge, 1)]);
                assert_agree(name, own[1], theta4, true, &[(&gauge, 1), (&gauge, 0)]);
            }
        }
    }
    let plain = <FourBar>::DESCRIPTION.blocks;
    assert_eq!(<OffsetAngles>::DESCRIPTION.blocks, plain);
    assert_eq!(<ComplexLinks>::DESCRIPTION.blocks, plain);
}

/// With its right crank at rest, the five-bar linkage is a four-bar linkage, in a frame of its own.
#[test]
fn two_inputs() {
    let mut random = Random::new(24);
    let linkage = FiveBar::<f64>::from_parameters([2.0, 1.0, 2.0, 1.8, 1.1]);
    for step in 0..36 {
        let alpha = Motion::new(random.motion((f64::from(10 * step) + 0.4).to_radians()));
        let beta = Motion::constant(1.2);
        let (sine, cosine) = f64::sin_cos(1.2);
        let (x, y) = (2.0 + 1.1 * cosine, 1.1 * sine);
        let frame = Motion::constant(y.atan2(x));
        let four_bar = FourBar {
            r1: x.hypot(y),
            r2: 1.0,
            r3: 2.0,
            r4: 1.8,
        };
        for assembly in Assembly::BOTH {
            let (Ok(own), Ok(other)) = (
                linkage.solve(alpha, beta, assembly),
                four_bar.solve(alpha - frame, assembly),
            ) else {
                continue;
            };
            let gauge = Gauge::new(&linkage, &[alpha, beta], &own.unknown_motions());
            assert_agree("phi", own.phi, other.theta3 + frame, true, &[(&gauge, 0), (&gauge, 1)]);
            assert_agree("psi", own.psi, other.theta4 + frame, true, &[(&gauge, 1), (&gauge, 0)]);
            // where both drive, the velocities add up
            let both = linkage.position(alpha.value(), 1.2, assembly).expect("it closes");
            let [first, second, sum] = [(3.0, 0.0), (0.0, -2.0), (3.0, -2.0)].map(|(a, b)| both.velocity(a, b));
            let error = first.phi.velocity() + second.phi.velocity() - sum.phi.velocity();
            assert!(error.abs() <= 64.0 * gauge.unknown(0, 1), "{error}");
        }
    }
}
