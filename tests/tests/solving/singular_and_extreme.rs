//! The places where solvers go wrong: 180 degrees, aligned links, limits, standstill, huge and tiny numbers, nonsense.

use core::f64::consts::{FRAC_PI_2, PI};

use kin_core::library::{FourBar, FreudensteinFourBar, GeometricFourBar, InvertedSliderCrank, SliderCrank};
use kin_core::prelude::*;
use kin_tests::oracles::{ALLOWED, Gauge, Reported, Worst};
use kin_tests::random::Random;

const SAMPLE: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};
const RATES: [f64; 5] = [0.0, -10.0, 2.0, -0.5, 0.3];

fn crank(angle: f64) -> Motion<f64, 5> {
    let mut motion = RATES;
    motion[0] = angle;
    Motion::new(motion)
}

fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} against {b}");
}

/// An angle that passes 180 degrees: half-angle tangents run to infinity there. The notes' own solution by them fails.
#[test]
fn an_angle_of_180_degrees() {
    // a 3-4-5 triangle: the crank straight up at (0, 3), the rocker straight back from (8, 0)
    let mut worst = Worst::default();
    let rocker_back = FourBar {
        r1: 8.0,
        r2: 3.0,
        r3: 5.0,
        r4: 4.0,
    };
    let coupler_back = FourBar {
        r1: 4.0,
        r2: 5.0,
        r3: 3.0,
        r4: 5.0,
    };
    let pose = rocker_back
        .solve(crank(FRAC_PI_2), Assembly::Crossed)
        .expect("it closes");
    close(pose.theta4.position().abs(), PI, 1e-15);
    worst.check(&rocker_back, [crank(FRAC_PI_2)], Assembly::Crossed);
    // both sides of the passage, and Freudenstein's equations as well
    let freudenstein = FreudensteinFourBar {
        r1: 8.0,
        r2: 3.0,
        r3: 5.0,
        r4: 4.0,
    };
    for step in -30..=30 {
        let angle = FRAC_PI_2 + f64::from(step) * 1e-3;
        worst.check(&rocker_back, [crank(angle)], Assembly::Crossed);
        worst.check(&freudenstein, [crank(angle)], FreudensteinFourBar::CROSSED);
        for assembly in Assembly::BOTH {
            worst.check(&coupler_back, [crank(angle)], assembly);
        }
    }
    worst.report("about 180 degrees");
}

#[test]
fn the_crank_on_the_ground_line() {
    let mut worst = Worst::default();
    for (r1, r2, r3, r4) in [(90.0, 30.0, 60.0, 45.0), (5.0, 2.0, 4.0, 3.5), (4.0, 1.0, 3.0, 2.5)] {
        let linkage = FourBar { r1, r2, r3, r4 };
        for angle in [0.0, -0.0, PI, -PI, 2.0 * PI, 1e-300, 1e-9, PI - 1e-9, 20.0 * PI] {
            for assembly in Assembly::BOTH {
                worst.check(&linkage, [crank(angle)], assembly);
            }
        }
        for angle in [0.0, PI] {
            for assembly in Assembly::BOTH {
                worst.check(&SliderCrank { r: r2, l: r1 }, [crank(angle)], assembly);
            }
            worst.check(&InvertedSliderCrank { r1, r2 }, [crank(angle)], ());
        }
    }
    worst.report("crank on the ground line");
}

/// Coupler and rocker on one line: a limit position, where rates are not defined.
#[test]
fn aligned_links_are_singular() {
    // outer: 1 + 2 and 2 + 1 stretched; folded: 3 - 2 = 1
    for (linkage, angle) in [
        (
            FourBar {
                r1: 4.0,
                r2: 1.0,
                r3: 2.0,
                r4: 1.0,
            },
            0.0,
        ),
        (
            FourBar {
                r1: 2.0,
                r2: 1.0,
                r3: 3.0,
                r4: 2.0,
            },
            0.0,
        ),
        (
            FourBar {
                r1: 4.0,
                r2: 3.0,
                r3: 2.0,
                r4: 3.0,
            },
            FRAC_PI_2,
        ),
    ] {
        for assembly in Assembly::BOTH {
            let error = linkage.position(angle, assembly).expect_err("the links are aligned");
            assert!(matches!(error.failure, Failure::Singular { .. }), "{error}");
            assert_eq!(error.block, "theta3, theta4");
            assert_eq!(error.inputs.iter().next(), Some(("theta2".into(), angle)));
        }
    }
}

/// A parallelogram's change point lies where all links are on one line. Beside it both assemblies exist: the
/// parallelogram, with theta4 = theta2, and the antiparallelogram.
#[test]
fn change_points() {
    let linkage = FourBar {
        r1: 3.0,
        r2: 1.0,
        r3: 3.0,
        r4: 1.0,
    };
    for angle in [0.0, PI] {
        for assembly in Assembly::BOTH {
            let error = linkage.position(angle, assembly).expect_err("a change point");
            assert!(matches!(error.failure, Failure::Singular { .. }), "{error}");
        }
    }
    for step in 1..180 {
        let angle = f64::from(step).to_radians();
        let [open, crossed] = Assembly::BOTH.map(|assembly| linkage.solve(crank(angle), assembly).expect("it closes"));
        let gauge = Gauge::new(&linkage, &[crank(angle)], &open.unknown_motions());
        // the parallelogram: the rocker moves as the crank, the coupler does not turn
        for (order, rate) in crank(angle).derivatives().into_iter().enumerate() {
            let allowed = ALLOWED[order] * gauge.unknown(1, order);
            close(open.theta4.derivatives()[order], rate, allowed);
            close(open.theta3.derivatives()[order], 0.0, allowed);
        }
        assert!((crossed.theta4.position() - angle).abs() > 1e-3);
    }
    // other linkages with r1 + r2 = r3 + r4, which fold flat at theta2 = 180 degrees
    for (r1, r2, r3, r4) in [(4.0, 2.0, 3.0, 3.0), (5.0, 1.0, 4.0, 2.0)] {
        let linkage = FourBar { r1, r2, r3, r4 };
        let error = linkage.position(PI, Assembly::Open).expect_err("a change point");
        assert!(matches!(error.failure, Failure::Singular { .. }), "{error}");
        let mut worst = Worst::default();
        for step in 1..=60 {
            for assembly in Assembly::BOTH {
                worst.check(&linkage, [crank(PI - 1e-6 * 1.2_f64.powi(step))], assembly);
            }
        }
        worst.report("beside a change point");
    }
}

/// The sample linkage closes only for |theta2| <= 112.024 degrees.
#[test]
fn the_limit_of_the_range() {
    let limit = SAMPLE.crank_range().expect("it can be assembled").high;
    close(limit.to_degrees(), 112.024, 5e-4);
    let mut worst = Worst::default();
    for exponent in 1..=14 {
        let step = 10_f64.powi(-exponent);
        for side in [1.0, -1.0] {
            let inside = side * (limit - step);
            for assembly in Assembly::BOTH {
                worst.check(&SAMPLE, [crank(inside)], assembly);
            }
            // outside: by how much, to first order, is the change of the diagonal: de = r1 r2 sin theta2 / e
            let error = SAMPLE
                .position(side * (limit + step), Assembly::Open)
                .expect_err("out of reach");
            let missing = 90.0 * 30.0 * limit.sin() / 105.0 * step;
            match error.failure {
                Failure::OutOfReach { margin } => {
                    assert!(margin < 0.0);
                    close(-margin, missing, missing * step + 1e-13);
                }
                // within rounding of the limit
                Failure::Singular { .. } => assert!(step < 1e-13, "{step}"),
                other => panic!("{other}"),
            }
            assert!(error.margin().is_some_and(|margin| margin <= 0.0));
        }
    }
    assert!(worst.poses >= 50, "{}", worst.poses);
    // what is left of the closure stays at rounding, however near the limit: the condition tells the rest
    for &error in &worst.closure {
        assert!(error <= 64.0, "{worst:?}");
    }
}

/// Accuracy near the limit, against a solution in closed form that does not cancel: with coupler and rocker alike the
/// angle between them follows from the half diagonal.
#[test]
fn accuracy_near_the_limit() {
    // r3 = r4 = 1, ground along x with the crank beside it at right angles: e from the crank's own triangle
    let linkage = FourBar {
        r1: 1.2,
        r2: 1.6,
        r3: 1.0,
        r4: 1.0,
    };
    for exponent in 1..=12 {
        let delta = 10_f64.powi(-exponent);
        // at theta2 = 90 degrees e = 2 exactly: the limit; cos(90 - d) = sin d
        let angle = FRAC_PI_2 - delta;
        let Ok(position) = linkage.position(angle, Assembly::Open) else {
            panic!("inside of the limit at {delta}");
        };
        // e² = 4 - 2 r1 r2 sin d, and the angle between the links is 2 acos(√(1 - e²/4)) = 2 asin(e/2)
        let short = (1.2 * 1.6 * delta.sin() / 2.0).sqrt();
        let bend = 2.0 * short.asin();
        let own = position.theta4.position() - position.theta3.position();
        // both directions are nearly opposite: rocker back towards the coupler's end
        let between = (PI - own.abs()).abs();
        let condition = 1.0 / short;
        close(between, bend, 64.0 * f64::EPSILON * condition);
    }
}

#[test]
fn a_crank_at_rest() {
    let pose = SAMPLE.solve(Motion::constant(1.0), Assembly::Open).expect("it closes");
    for motion in pose.unknown_motions() {
        assert_eq!(&motion.derivatives()[1..], [0.0; 4]);
    }
    // at rest, but about to move: the acceleration is J⁻¹ times the crank's, without a term of velocity
    let pose = SAMPLE
        .solve(Motion::new([1.0, 0.0, 3.0, 0.0, 0.0]), Assembly::Open)
        .expect("it closes");
    let unit = SAMPLE
        .solve(Motion::new([1.0, 1.0, 0.0, 0.0, 0.0]), Assembly::Open)
        .expect("it closes");
    close(pose.theta3.acceleration(), 3.0 * unit.theta3.velocity(), 1e-15);
    assert_eq!(pose.theta3.velocity(), 0.0);
    assert_eq!(pose.theta3.jerk(), 0.0);
}

/// A crank that has turned many times: the sine of a large angle is the one of the very number.
#[test]
fn a_million_radians() {
    let turns = (1e6 / (2.0 * PI)).floor();
    for near in [1e6, -1e6, turns * 2.0 * PI + 1.0] {
        let pose = SAMPLE.solve(crank(near), Assembly::Open);
        let (sine, cosine) = near.sin_cos();
        let same = SAMPLE.solve(crank(sine.atan2(cosine)), Assembly::Open);
        match (pose, same) {
            (Ok(pose), Ok(same)) => {
                for (a, b) in pose.unknown_motions().iter().zip(same.unknown_motions()) {
                    for (a, b) in a.derivatives().into_iter().zip(b.derivatives()) {
                        close(a, b, 1e-11 * b.abs().max(1.0));
                    }
                }
            }
            (Err(a), Err(b)) => assert_eq!(a.failure, b.failure),
            _ => panic!("{near}"),
        }
    }
}

/// Angles and their rates do not depend on the unit of length.
#[test]
fn lengths_from_micro_to_mega() {
    for exponent in -6..=6 {
        let scale = 10_f64.powi(exponent);
        let scaled = FourBar {
            r1: SAMPLE.r1 * scale,
            r2: SAMPLE.r2 * scale,
            r3: SAMPLE.r3 * scale,
            r4: SAMPLE.r4 * scale,
        };
        let (own, other) = (
            scaled.solve(crank(1.0), Assembly::Crossed).expect("it closes"),
            SAMPLE.solve(crank(1.0), Assembly::Crossed).expect("it closes"),
        );
        let gauge = Gauge::new(&SAMPLE, &[crank(1.0)], &other.unknown_motions());
        for (index, (own, other)) in own.unknown_motions().iter().zip(other.unknown_motions()).enumerate() {
            for (order, (a, b)) in own.derivatives().into_iter().zip(other.derivatives()).enumerate() {
                close(a, b, ALLOWED[order] * gauge.unknown(index, order));
            }
        }
        // a limit is a limit in any unit
        let error = scaled.position(2.0, Assembly::Open).expect_err("out of reach");
        let margin = SAMPLE.position(2.0, Assembly::Open).expect_err("out of reach").margin();
        close(error.margin().unwrap_or(0.0) / scale, margin.unwrap_or(0.0), 1e-12);
    }
    // links of very different lengths in one linkage
    let mut worst = Worst::default();
    let mut random = Random::new(9);
    for _ in 0..60 {
        let tiny = 10_f64.powf(random.between(-6.0, 0.0));
        let linkage = FourBar {
            r1: 1e3,
            r2: tiny,
            r3: 700.0,
            r4: 800.0,
        };
        worst.check(&linkage, [crank(random.between(-3.0, 3.0))], Assembly::Open);
    }
    worst.report("a tiny crank in a large linkage");
}

/// A number that is not one is told by name, wherever it comes from.
#[test]
fn nonsense_is_named() {
    let culprit = |error: SolveError| match error.failure {
        Failure::NotFinite { quantity } => quantity,
        other => panic!("{other}"),
    };
    for nonsense in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let wrong = [
            (FourBar { r1: nonsense, ..SAMPLE }, "r1"),
            (FourBar { r2: nonsense, ..SAMPLE }, "r2"),
            (FourBar { r3: nonsense, ..SAMPLE }, "r3"),
            (FourBar { r4: nonsense, ..SAMPLE }, "r4"),
        ];
        for (linkage, name) in wrong {
            assert_eq!(
                culprit(linkage.position(1.0, Assembly::Open).expect_err("nonsense")),
                name
            );
        }
        assert_eq!(
            culprit(SAMPLE.position(nonsense, Assembly::Open).expect_err("nonsense")),
            "theta2"
        );
        for order in 1..5 {
            let mut motion = RATES;
            motion[order] = nonsense;
            let error = SAMPLE.solve(Motion::new(motion), Assembly::Open).expect_err("nonsense");
            assert_eq!(culprit(error), "theta2");
        }
        let slider = SliderCrank { r: 1.0, l: nonsense };
        assert_eq!(
            culprit(slider.position(1.0, Assembly::Open).expect_err("nonsense")),
            "l"
        );
        let lever = InvertedSliderCrank { r1: nonsense, r2: 1.0 };
        assert_eq!(culprit(lever.position(1.0).expect_err("nonsense")), "r1");
    }
    // rates that overflow although all is finite
    let error = SAMPLE
        .solve(Motion::new([1.0, 1e200, 0.0, 0.0, 0.0]), Assembly::Open)
        .expect_err("too fast");
    assert!(matches!(error.failure, Failure::NotFinite { .. }), "{error}");
}

mod roots {
    use kin_core::prelude::*;

    mechanism! {
        /// A strut whose height follows from its length and its foot.
        pub struct Strut {
            pub length: Length,
        }
        input foot: Length;
        unknown height: Length;

        height == sqrt(length.powi(2) - foot.powi(2));
    }
}

#[test]
fn roots_of_negative_numbers() {
    let strut = roots::Strut { length: 5.0 };
    let pose = strut
        .solve(Motion::at_constant_speed(3.0, 1.0))
        .expect("the strut reaches");
    close(pose.height.position(), 4.0, 1e-15);
    close(pose.height.velocity(), -0.75, 1e-15);
    let error = strut.position(6.0).expect_err("the strut is too short");
    assert_eq!(
        error.failure,
        Failure::OutsideDomain {
            function: "sqrt",
            argument: -11.0
        }
    );
    // lying flat it has a height, but no rate of it
    let error = strut
        .solve(Motion::at_constant_speed(5.0, 1.0))
        .expect_err("the root has no slope at zero");
    assert!(
        matches!(error.failure, Failure::Singular { .. } | Failure::NotFinite { .. }),
        "{error}"
    );
}

/// A negative length is a link that points the other way.
#[test]
fn negative_lengths() {
    let own = FourBar { r4: -45.0, ..SAMPLE }
        .solve(crank(1.0), Assembly::Open)
        .expect("it closes");
    let other = SAMPLE.solve(crank(1.0), Assembly::Open).expect("it closes");
    close((own.theta4.position() - other.theta4.position()).abs(), PI, 1e-14);
    close(own.theta4.snap(), other.theta4.snap(), 1e-6);
    close(own.theta3.snap(), other.theta3.snap(), 1e-6);
    let left = FourBar { r4: -45.0, ..SAMPLE }.closure(1.0, own.unknowns());
    assert!(left.iter().all(|left| left.abs() < 1e-13), "{left:?}");
}

#[test]
fn single_precision() {
    let linkage = FourBar {
        r1: 90.0_f32,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let motion = Motion::new([1.0_f32, -10.0, 2.0, -0.5, 0.3]);
    let own = linkage.solve(motion, Assembly::Open).expect("it closes");
    let other = SAMPLE.solve(crank(1.0), Assembly::Open).expect("it closes");
    let gauge = Gauge::new(&SAMPLE, &[crank(1.0)], &other.unknown_motions());
    let coarser = f64::from(f32::EPSILON) / f64::EPSILON;
    for (index, (own, other)) in own.unknown_motions().iter().zip(other.unknown_motions()).enumerate() {
        for (order, (a, b)) in own.derivatives().into_iter().zip(other.derivatives()).enumerate() {
            close(f64::from(a), b, coarser * ALLOWED[order] * gauge.unknown(index, order));
        }
    }
    assert!(linkage.position(2.0, Assembly::Open).is_err());
}

/// Followed from pose to pose, an angle does not jump by a turn, and a crank that turns for ever is followed for ever.
#[test]
fn several_turns() {
    // a double crank: all links turn fully
    let linkage = FourBar {
        r1: 1.0,
        r2: 3.0,
        r3: 2.5,
        r4: 3.0,
    };
    for assembly in Assembly::BOTH {
        let mut near = linkage.position(0.0, assembly).expect("it closes").unknowns();
        for step in 1..=1440 {
            let angle = f64::from(step).to_radians();
            let next = linkage.position_near(angle, near).expect("it closes").unknowns();
            for (before, after) in near.into_iter().zip(next) {
                assert!((after - before).abs() < 0.2, "{before} to {after} at step {step}");
            }
            near = next;
        }
        assert!(near[1] > 7.0 * PI, "{near:?}");
        assert_eq!(linkage.assembly_at(8.0 * PI, near), assembly);
    }
}

/// The geometric method where its right angles are: alpha and beta change from acute to obtuse only through a singular
/// position of the sine rule, and the assembly is told anew on the other side.
#[test]
fn obtuse_angles_of_the_geometric_method() {
    let geometric = GeometricFourBar {
        r1: 2.0,
        r2: 3.0,
        r3: 4.0,
        r4: 3.0,
    };
    let linkage = FourBar {
        r1: 2.0,
        r2: 3.0,
        r3: 4.0,
        r4: 3.0,
    };
    for step in 0..72 {
        let angle = (f64::from(5 * step) + 0.7).to_radians();
        for assembly in Assembly::BOTH {
            let (Ok(own), Ok(other)) = (
                geometric.position(angle, geometric.assembly(angle, assembly)),
                linkage.position(angle, assembly),
            ) else {
                continue;
            };
            let difference = own.theta4.position() - other.theta4.position();
            close((difference / 2.0).sin(), 0.0, 1e-12);
        }
    }
}
