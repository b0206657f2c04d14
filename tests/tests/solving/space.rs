//! Mechanisms of space against what is known of them otherwise: formulas by hand, published relations, limits in the
//! plane.
//!
//! That the derivatives are right is the oracles' matter; some of them are compared with formulas here all the same.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use kin_core::Rotation;
use kin_core::library::{FourBar, OffsetSliderCrank};
use kin_core::prelude::*;
use kin_core::series::Series;
use kin_tests::compare::{assert_agree, turned_back};
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::cases::{Case, Visitor, in_space};
use kin_tests::mechanisms::space::*;
use kin_tests::oracles::{ALLOWED, Gauge};
use kin_tests::random::Random;

/// The blocks' closed forms, joined.
fn forms<M: Mechanism>() -> String {
    let forms: Vec<&str> = M::DESCRIPTION.blocks.iter().map(|block| block.solution).collect();
    forms.join("; ")
}

#[test]
fn the_closed_forms_are_found_from_the_vectors() {
    let circular = "a cos x + b sin x = c";
    assert_eq!(forms::<Rssr>(), circular);
    assert_eq!(forms::<RssrByLength>(), format!("inverse of sqrt, then {circular}"));
    assert_eq!(
        forms::<RssrWithBall>(),
        format!("{circular}; linear equation; linear equation; linear equation")
    );
    assert_eq!(forms::<RssrDrivenAtRocker>(), circular);
    assert_eq!(forms::<Rssp>(), "quadratic equation");
    assert_eq!(forms::<RsspByLength>(), "inverse of sqrt, then quadratic equation");
    assert_eq!(forms::<UniversalJoint>(), circular);
    assert_eq!(forms::<UniversalJointByNormal>(), circular);
    assert_eq!(forms::<SphericalFourBar>(), circular);
    assert_eq!(forms::<SphericalFourBarAboutAxis>(), circular);
    assert_eq!(forms::<StewartGoughLeg>(), "square root");
    assert_eq!(forms::<StewartGoughLegByLength>(), "linear equation");
    assert_eq!(
        forms::<Bennett>(),
        "linear equation; polar form (RPR dyad); linear equation"
    );
    assert_eq!(
        forms::<BennettByTripleProduct>(),
        format!("linear equation; {circular}; linear equation")
    );
}

/// The parts of points of space are scalars with names of their own.
#[test]
fn points_are_described_part_by_part() {
    let names = |quantities: &[kin_core::Quantity]| -> Vec<&str> { quantities.iter().map(|own| own.name).collect() };
    assert_eq!(
        names(Rssr::<f64>::DESCRIPTION.parameters),
        [
            "crank", "pivot.x", "pivot.y", "pivot.z", "axis.x", "axis.y", "axis.z", "arm.x", "arm.y", "arm.z", "rod"
        ]
    );
    assert_eq!(names(Rssr::<f64>::DESCRIPTION.outputs), ["ball.x", "ball.y", "ball.z"]);
    let linkage = Rssr::from_parameters([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0]);
    assert_eq!(linkage.pivot, Space::new(2.0, 3.0, 4.0));
    assert_eq!(linkage.convert(|value| 2.0 * value).arm, Space::new(16.0, 18.0, 20.0));
    assert_eq!(linkage.parameters()[4..7], [5.0, 6.0, 7.0]);
}

/// Solves a linkage and another that should move alike, and compares one unknown of each at every order.
fn alike<A, B>(
    own: &A,
    inputs: A::Inputs<Motion<f64, 5>>,
    assembly: A::Assembly,
    other: &B,
    others: B::Assembly,
    index: usize,
) where
    A: ThroughSnap,
    B: ThroughSnap,
{
    let Ok(first) = own.solve(inputs, assembly) else {
        panic!("{} does not close", A::DESCRIPTION.name);
    };
    let input = inputs[0];
    let others_inputs = B::Inputs::from_fn(|_| input);
    let Ok(second) = other.solve(others_inputs, others) else {
        panic!("{} does not close", B::DESCRIPTION.name);
    };
    let (first, second) = (first.unknown_motions(), second.unknown_motions());
    assert_agree(
        A::DESCRIPTION.name,
        first[0],
        second[index],
        A::DESCRIPTION.unknowns[0].dimension == kin_core::Dimension::Angle,
        &[
            (&Gauge::new(own, &inputs, &first), 0),
            (&Gauge::new(other, &others_inputs, &second), index),
        ],
    );
}

/// With both axes along z and everything in one plane, it is the plane four-bar linkage.
#[test]
fn rssr_in_the_plane_is_the_four_bar() {
    let mut random = Random::new(1);
    let plane = FourBar {
        r1: 4.0,
        r2: 1.0,
        r3: 3.0,
        r4: 2.5,
    };
    let space = Rssr {
        crank: 1.0,
        pivot: Space::new(4.0, 0.0, 0.0),
        axis: Space::new(0.0, 0.0, 5.0),
        arm: Space::new(2.5, 0.0, 0.0),
        rod: 3.0,
    };
    for step in 0..24 {
        let input = Motion::new(random.motion(f64::from(step) * TAU / 24.0));
        // one solution of each is that of the other; which one is a matter of signs, and the same everywhere
        let rocker = |assembly| {
            plane
                .position(input.value(), assembly)
                .expect("it closes")
                .theta4
                .value()
        };
        let own = space
            .position(input.value(), Assembly::Open)
            .expect("it closes")
            .phi
            .value();
        let near = |assembly| turned_back(own - rocker(assembly)).abs() < 1e-9;
        assert!(near(Assembly::Open) != near(Assembly::Crossed));
        let (open, crossed) = if near(Assembly::Open) {
            (Assembly::Open, Assembly::Crossed)
        } else {
            (Assembly::Crossed, Assembly::Open)
        };
        alike(&space, [input], Assembly::Open, &plane, open, 1);
        alike(&space, [input], Assembly::Crossed, &plane, crossed, 1);
    }
}

/// Two skew shafts by hand: the ball runs on a circle, of which the rod's sphere cuts out two points.
#[test]
fn rssr_by_hand() {
    let linkage = Rssr {
        crank: 1.0,
        pivot: Space::new(3.0, 0.5, 0.8),
        axis: Space::new(0.2, 0.9, 0.3),
        arm: Space::new(0.4, -0.3, 1.9),
        rod: 3.3,
    };
    let unit = linkage.axis.scale(1.0 / linkage.axis.norm());
    let along = unit.scale(unit.dot(linkage.arm));
    let start = linkage.arm - along;
    let across = unit.cross(start);
    for step in 0..24 {
        let theta = f64::from(step) * TAU / 24.0;
        let from = linkage.pivot + along - Space::new(theta.cos(), theta.sin(), 0.0);
        // |from + start cos + across sin|² = rod²
        let (a, b) = (2.0 * from.dot(start), 2.0 * from.dot(across));
        let c = linkage.rod * linkage.rod - from.norm_squared() - start.norm_squared();
        let (middle, half) = (b.atan2(a), (c / a.hypot(b)).acos());
        for assembly in Assembly::BOTH {
            let pose = linkage.position(theta, assembly).expect("it closes");
            let phi = pose.phi.value();
            let near = turned_back(phi - middle).abs();
            // the arc cosine loses what its argument lacks of 1
            let bound = 16.0 * f64::EPSILON / half.sin();
            assert!((near - half).abs() <= bound, "{near} instead of {half}");
            let ball = linkage.pivot + along + start.scale(phi.cos()) + across.scale(phi.sin());
            assert!((pose.ball.value() - ball).norm() <= 8.0 * f64::EPSILON * ball.norm());
        }
    }
}

/// The ball as an unknown and as an output is one point, and a rocker that drives undoes what the crank has done.
#[test]
fn rssr_in_other_typings() {
    struct Points;
    impl Visitor for Points {
        fn visit<M: Mechanism<Scalar = f64>>(&mut self, case: Case) {
            if M::DESCRIPTION.name != "Rssr" {
                return;
            }
            let linkage: Rssr = case.mechanism();
            let with_ball: RssrWithBall = case.mechanism();
            let by_length: RssrByLength = case.mechanism();
            let driven: RssrDrivenAtRocker = case.mechanism();
            let mut random = Random::new(3);
            for step in 0..16 {
                let input = Motion::new(random.motion(f64::from(step) * TAU / 16.0));
                for assembly in Assembly::BOTH {
                    let own = linkage.solve(input, assembly).expect("it closes");
                    let other = with_ball.solve(input, assembly).expect("it closes");
                    let gauge = Gauge::new(&with_ball, &[input], &other.unknown_motions());
                    let ball = [own.ball.x(), own.ball.y(), own.ball.z()];
                    for (index, part) in ball.into_iter().enumerate() {
                        let unknown = other.unknown_motions()[index + 1];
                        assert_agree(
                            "ball",
                            part,
                            unknown,
                            false,
                            &[(&gauge, index + 1), (&gauge, index + 1)],
                        );
                    }
                    alike(&linkage, [input], assembly, &by_length, assembly, 0);
                    // the crank's two angles for this rocker, one of which is the one it came from
                    let back = Assembly::BOTH.map(|assembly| driven.solve(own.phi, assembly).expect("it closes").theta);
                    let nearest = if turned_back(back[0].value() - input.value()).abs()
                        < turned_back(back[1].value() - input.value()).abs()
                    {
                        back[0]
                    } else {
                        back[1]
                    };
                    let gauge = Gauge::new(&linkage, &[input], &own.unknown_motions());
                    let back_gauge = Gauge::new(&driven, &[own.phi], &[nearest]);
                    assert_agree("crank", nearest, input, true, &[(&gauge, 0), (&back_gauge, 0)]);
                }
            }
        }
    }
    in_space(&mut Points);
}

/// With the rail in the crank's plane, it is the plane slider-crank with offset.
#[test]
fn rssp_in_the_plane_is_the_slider_crank() {
    let mut random = Random::new(2);
    let plane = OffsetSliderCrank { r: 1.0, l: 3.0, h: 0.4 };
    let space = Rssp {
        crank: 1.0,
        start: Space::new(0.0, 0.4, 0.0),
        rail: Space::new(0.25, 0.0, 0.0),
        rod: 3.0,
    };
    for step in 0..24 {
        let input = Motion::new(random.motion(f64::from(step) * TAU / 24.0));
        for assembly in Assembly::BOTH {
            alike(&space, [input], assembly, &plane, assembly, 1);
        }
    }
}

#[test]
fn rssp_out_of_reach() {
    // the rail runs 3 beside the crank's axis, and the rod is shorter than what lies between at the far side
    let linkage = Rssp {
        crank: 1.0,
        start: Space::new(3.0, 0.0, 0.0),
        rail: Space::new(0.0, 0.0, 2.0),
        rod: 3.0,
    };
    let error = linkage.position(PI, Assembly::Open).expect_err("the rod is too short");
    assert!(error.margin().is_some_and(|margin| margin < 0.0), "{error}");
    assert!(linkage.position(0.0, Assembly::Open).is_ok());
    // a rail without a direction
    let error = Rssp {
        rail: Space::new(0.0, 0.0, 0.0),
        ..linkage
    }
    .position(0.0, Assembly::Open)
    .expect_err("there is no line");
    assert!(
        matches!(error.failure, Failure::NotFinite { .. } | Failure::Singular { .. }),
        "{error}"
    );
}

/// tan(out) = tan(in) / cos(beta), with the speed cos(beta) / (1 - sin²(beta) cos²(in)) and its derivative.
#[test]
fn universal_joint_by_formula() {
    for beta in [-1.2, -0.3, 0.0, 0.5, 1.0, 1.4_f64] {
        let joint = UniversalJoint { beta };
        for step in 0..48 {
            let driving = f64::from(step - 24) * TAU / 48.0;
            let (speed, acceleration) = (2.0, -0.7);
            let input = Motion::from([driving, speed, acceleration, 0.0, 0.0]);
            let pose = joint.solve(input, Assembly::Open).expect("it closes");
            let gauge = Gauge::new(&joint, &[input], &pose.unknown_motions());
            let driven = pose.driven;
            let angle = (driving.sin()).atan2(beta.cos() * driving.cos());
            let ratio = beta.cos() / (1.0 - (beta.sin() * driving.cos()).powi(2));
            let change = -ratio * ratio / beta.cos() * beta.sin().powi(2) * (2.0 * driving).sin();
            for (order, (own, expected)) in [
                (turned_back(driven.position() - angle), 0.0),
                (driven.velocity(), ratio * speed),
                (driven.acceleration(), ratio * acceleration + change * speed * speed),
            ]
            .into_iter()
            .enumerate()
            {
                let bound = ALLOWED[order] * gauge.unknown(0, order);
                assert!((own - expected).abs() <= bound, "beta {beta}, {driving}, order {order}");
            }
            // the other assembly is half a turn round
            let other = joint.position(driving, Assembly::Crossed).expect("it closes").driven;
            let half = turned_back(other.position() - driven.position()).abs();
            assert!((half - PI).abs() <= ALLOWED[0] * gauge.unknown(0, 0));
        }
    }
}

/// A rocker without an arm is not turned by anything, and one without an axis is none.
#[test]
fn rssr_without_arm_or_axis() {
    let linkage = Rssr {
        crank: 1.0,
        pivot: Space::new(3.0, 0.0, 0.0),
        axis: Space::new(0.0, 1.0, 0.0),
        arm: Space::new(0.0, 0.0, 0.0),
        rod: 2.0,
    };
    // the rod fits at the first angle, not at the second
    for theta in [0.0, 1.0] {
        let error = linkage
            .position(theta, Assembly::Open)
            .expect_err("nothing determines phi");
        assert!(matches!(error.failure, Failure::Singular { .. }), "{error}");
    }
    let error = Rssr {
        axis: Space::new(0.0, 0.0, 0.0),
        arm: Space::new(0.0, 0.0, 1.0),
        ..linkage
    }
    .position(0.0, Assembly::Open)
    .expect_err("there is no axis");
    assert!(matches!(error.failure, Failure::NotFinite { .. }), "{error}");
}

/// Arcs of 90 degrees are the arms of a cross: it is the universal joint, its driven angle a quarter turn behind.
#[test]
fn spherical_four_bar_of_right_angles_is_the_universal_joint() {
    for beta in [0.4, 1.1] {
        let linkage = SphericalFourBar {
            ground: beta,
            crank: FRAC_PI_2,
            coupler: FRAC_PI_2,
            rocker: FRAC_PI_2,
        };
        let joint = UniversalJoint { beta };
        for step in 0..24 {
            let driving = f64::from(step) * TAU / 24.0;
            let shaft = joint
                .position(driving, Assembly::Open)
                .expect("it closes")
                .driven
                .value();
            // the arcs' angles count from the line of the axes, the joint's arms from across it
            let rockers = Assembly::BOTH.map(|own| linkage.position(driving, own).expect("it closes").theta4.value());
            let behind = rockers.map(|rocker| turned_back(shaft - rocker).abs());
            for quarter in behind {
                assert!((quarter - FRAC_PI_2).abs() <= 32.0 * f64::EPSILON, "{quarter}");
            }
        }
    }
}

/// On a large sphere a small linkage is plane; the difference goes with the square of its size.
#[test]
fn small_spherical_four_bar_is_plane() {
    let plane = FourBar {
        r1: 4.0,
        r2: 1.0,
        r3: 3.0,
        r4: 2.5,
    };
    let spherical = |size: f64| SphericalFourBar {
        ground: 4.0 * size,
        crank: size,
        coupler: 3.0 * size,
        rocker: 2.5 * size,
    };
    for step in 0..12 {
        let theta2 = 0.2 + f64::from(step) * TAU / 12.0;
        for assembly in Assembly::BOTH {
            let expected = plane.position(theta2, assembly).expect("it closes").theta4.value();
            let error = |size: f64| {
                Assembly::BOTH
                    .map(|own| {
                        let found = spherical(size).position(theta2, own).expect("it closes").theta4.value();
                        turned_back(found - expected).abs()
                    })
                    .into_iter()
                    .fold(f64::INFINITY, f64::min)
            };
            let ratio = error(1e-2) / error(1e-3);
            assert!((ratio - 100.0).abs() < 2.0, "{theta2}: {ratio}");
        }
    }
}

#[test]
fn spherical_four_bar_in_another_typing() {
    let linkage = SphericalFourBar::from_parameters([1.4, 0.5, 1.2, 0.9]);
    let other = SphericalFourBarAboutAxis::from_parameters([1.4, 0.5, 1.2, 0.9]);
    let mut random = Random::new(5);
    for step in 0..24 {
        let input = Motion::new(random.motion(f64::from(step) * TAU / 24.0));
        for assembly in Assembly::BOTH {
            let own = linkage
                .position(input.value(), assembly)
                .expect("it closes")
                .theta4
                .value();
            let same = Assembly::BOTH.into_iter().find(|&others| {
                let theirs = other.position(input.value(), others).expect("it closes").theta4.value();
                turned_back(own - theirs).abs() < 1e-9
            });
            alike(&linkage, [input], assembly, &other, same.expect("one is the same"), 0);
        }
    }
}

/// A platform of six legs that moves by a screw about z: each leg is a chord of a helix.
#[test]
fn stewart_gough_leg_by_hand() {
    let mut random = Random::new(4);
    let still = Motion::constant(0.0);
    for number in 0..6 {
        let angle = f64::from(number) * TAU / 6.0;
        let leg = StewartGoughLeg {
            base: Space::new(2.0 * angle.cos(), 2.0 * angle.sin(), 0.0),
            joint: Space::new((angle + 0.3).cos(), (angle + 0.3).sin(), 0.2),
        };
        let (height, yaw) = (Motion::new(random.motion(2.0)), Motion::new(random.motion(0.4)));
        let pose = leg.solve(still, still, height, still, still, yaw).expect("it closes");
        let gauge = Gauge::new(
            &leg,
            &[still, still, height, still, still, yaw],
            &pose.unknown_motions(),
        );
        // leg² = 2² + 1² - 2 · 2 · 1 cos(yaw + 0.3) + (height + 0.2)²
        let series = |motion: Motion<f64, 5>| Series::<5>::from_derivatives(motion.derivatives());
        let number = <Series<5> as Number>::constant;
        let (_, cosine) = (series(yaw) + number(0.3)).sin_cos();
        let rise = series(height) + number(0.2);
        let expected = (number(5.0) - number(4.0) * cosine + rise * rise).sqrt().derivatives();
        for (order, (own, expected)) in pose.leg.derivatives().into_iter().zip(expected).enumerate() {
            let bound = ALLOWED[order] * gauge.unknown(0, order);
            assert!(
                (own - expected).abs() <= bound,
                "order {order}: {own} instead of {expected}"
            );
        }
    }
}

/// All six inputs have their place, and a turn about one axis after another is that of the platform.
#[test]
fn stewart_gough_leg_turns_by_roll_first() {
    let leg = StewartGoughLeg {
        base: Space::new(1.0, 0.2, -0.3),
        joint: Space::new(0.6, -0.5, 0.2),
    };
    let by_length = StewartGoughLegByLength::from_parameters(leg.parameters());
    let (roll, pitch, yaw) = (0.3_f64, -0.5_f64, 1.1_f64);
    let pose = leg.position(0.1, -0.2, 2.0, roll, pitch, yaw).expect("it closes");
    let about = |v: [f64; 3], from: usize, to: usize, angle: f64| {
        let mut turned = v;
        turned[from] = v[from] * angle.cos() - v[to] * angle.sin();
        turned[to] = v[from] * angle.sin() + v[to] * angle.cos();
        turned
    };
    let head = about(about(about([0.6, -0.5, 0.2], 1, 2, roll), 2, 0, pitch), 0, 1, yaw);
    let head = Space::from(head) + Space::new(0.1, -0.2, 2.0);
    let few = 8.0 * f64::EPSILON * head.norm();
    assert!((pose.head.value() - head).norm() <= few);
    assert!((pose.leg.value() - (head - leg.base).norm()).abs() <= few);
    let other = by_length.position(0.1, -0.2, 2.0, roll, pitch, yaw).expect("it closes");
    assert!((pose.leg.value() - other.leg.value()).abs() <= few);
    // an error tells the first inputs
    let error = leg
        .position(f64::NAN, -0.2, 2.0, roll, pitch, yaw)
        .expect_err("x is not a number");
    assert!(
        matches!(error.failure, Failure::NotFinite { quantity } if quantity == "x"),
        "{error}"
    );
    assert_eq!(error.inputs.iter().last().map(|(name, _)| name), Some("pitch".into()));
}

/// The parts that the declaration leaves out: all three coordinates of the loop, and that its links lead back to where
/// they began in direction, too. At every order.
#[test]
fn bennett_closes_in_space() {
    let mut random = Random::new(6);
    for (alpha, beta) in [(0.5, 1.2), (1.3, 0.4), (-0.6, 1.0), (2.0, 0.9)] {
        let linkage = Bennett { a: 2.0, alpha, beta };
        for step in 0..24 {
            let input = Motion::new(random.motion(f64::from(step) * TAU / 24.0));
            let pose = linkage.solve(input).expect("it closes");
            let gauge = Gauge::new(&linkage, &[input], &pose.unknown_motions());
            let b = 2.0 * beta.sin() / alpha.sin();
            let number = <Series<5> as Number>::constant;
            let zero = number(0.0);
            let mut turned = Rotation::about_z(zero);
            let mut reached = Space::new(zero, zero, zero);
            for (angle, length, twist) in [
                (pose.theta1, 2.0, alpha),
                (pose.theta2, b, beta),
                (pose.theta3, 2.0, alpha),
                (pose.theta4, b, beta),
            ] {
                let angle = Series::<5>::from_derivatives(angle.derivatives());
                turned = turned.times(Rotation::about_z(angle));
                reached = reached + turned.rotate(Space::new(number(length), zero, zero));
                turned = turned.times(Rotation::about_x(number(twist)));
            }
            let size = b.abs().max(2.0);
            let left_out = [reached.x, reached.y, reached.z].map(|part| part.derivatives().map(|own| own / size));
            let identity = Rotation::about_z(zero).rows();
            let directions = turned.rows().into_iter().zip(identity).flat_map(|(row, axis)| {
                let difference = row - axis;
                [difference.x, difference.y, difference.z].map(Series::derivatives)
            });
            for derivatives in left_out.into_iter().chain(directions) {
                for (order, left) in derivatives.into_iter().enumerate() {
                    // an angle turns the whole of the loop behind it
                    let bound: f64 = (0..3).map(|index| ALLOWED[order] * gauge.unknown(index, order)).sum();
                    assert!(
                        left.abs() <= bound,
                        "alpha {alpha}, beta {beta}, order {order}: {left}, {bound}"
                    );
                }
            }
            // the outputs are the loop's own points
            let second = pose.second.value();
            assert!((second.norm() - 2.0).abs() <= 8.0 * f64::EPSILON);
            let third = pose.third.value();
            assert!(((third - second).norm() - b.abs()).abs() <= 16.0 * f64::EPSILON * size);
            assert!(((third + Space::new(b, 0.0, 0.0)).norm() - 2.0).abs() <= 64.0 * f64::EPSILON * size);
        }
    }
}

/// tan(theta1 / 2) tan(theta2 / 2) = sin((beta + alpha) / 2) / sin((beta - alpha) / 2).
#[test]
fn bennett_by_his_relation() {
    for (alpha, beta) in [(0.5_f64, 1.2_f64), (1.3, 0.4), (-0.6, 1.0), (2.0, 0.9)] {
        let ratio = f64::midpoint(beta, alpha).sin() / ((beta - alpha) / 2.0).sin();
        let linkage = Bennett { a: 2.0, alpha, beta };
        let other = BennettByTripleProduct::from_parameters([2.0, alpha, beta]);
        for step in 1..24 {
            let theta1 = f64::from(step) * TAU / 24.0 - PI;
            let input = [Motion::from([theta1, 1.0, 0.0, 0.0, 0.0])];
            let pose = linkage.solve(input[0]).expect("it closes");
            let gauge = Gauge::new(&linkage, &input, &pose.unknown_motions());
            let expected = 2.0 * ratio.atan2((theta1 / 2.0).tan());
            let bound = ALLOWED[0] * gauge.unknown(0, 0);
            let theta2 = pose.theta2.value();
            assert!(
                turned_back(theta2 - expected).abs() <= bound,
                "{theta2} instead of {expected}"
            );
            // the equation with two solutions: this one, and one half a turn away
            let found = Assembly::BOTH.map(|own| other.position(theta1, own).expect("it closes").theta2.value());
            let mut away = found.map(|own| turned_back(own - theta2).abs());
            away.sort_by(f64::total_cmp);
            let bound = 4.0 * bound;
            assert!(away[0] <= bound && (away[1] - PI).abs() <= bound, "{away:?}");
        }
    }
}

/// The products of two plane vectors are those of the triangle that they span.
#[test]
fn products_of_plane_vectors() {
    let linkage = PlaneProducts::from_parameters([1.0, 3.0]);
    for step in 0..12 {
        let theta = f64::from(step) * TAU / 12.0;
        let pose = linkage.position(theta).expect("it closes");
        let x = theta.cos() + (9.0 - theta.sin().powi(2)).sqrt();
        assert!((pose.x.value() - x).abs() <= 8.0 * f64::EPSILON * x);
        let both = x * (theta.cos() - theta.sin());
        assert!((3.0 * pose.area.value() - both).abs() <= 16.0 * f64::EPSILON * x);
    }
}
