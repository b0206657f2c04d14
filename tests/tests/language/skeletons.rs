//! The picture of a mechanism: its joints, links and points, in poses of every order.

use std::f64::consts::TAU;

use kin_core::library::{FourBar, GeometricFourBar};
use kin_core::prelude::*;
use kin_core::{PoseOf, Skeleton};

mechanism! {
    /// A four-bar linkage with a ternary coupler, and a dyad on its coupler point: two loops, with abbreviations.
    struct SixBar {
        ground: Length, crank: Length, coupler: Length, rocker: Length,
        tracer: Vector, pivot: Point, arm: Length, rod: Length,
    }
    input theta: Angle;
    unknown coupler_angle: Angle, rocker_angle: Angle, rod_angle: Angle, arm_angle: Angle;

    let pin = crank * cis(theta);
    let point = pin + tracer * cis(coupler_angle);

    pin + coupler * cis(coupler_angle) - (ground + rocker * cis(rocker_angle)) == 0;
    point - -rod * cis(rod_angle) == pivot + arm * cis(arm_angle);

    /// The coupler point.
    output tip: Point = point;
    output corner: Point = vec2(ground, 0);
    output bar: Vector = arm * cis(arm_angle);
}

const SIX_BAR: SixBar = SixBar {
    ground: 90.0,
    crank: 30.0,
    coupler: 80.0,
    rocker: 60.0,
    tracer: Plane::new(35.0, 25.0),
    pivot: Plane::new(150.0, 20.0),
    arm: 60.0,
    rod: 110.0,
};

/// Of all links of a skeleton, the sum of their lengths: what a joint's coordinates may be rounded by, times epsilon.
fn size<const JOINTS: usize, const POINTS: usize>(skeleton: &Skeleton<Plane, JOINTS, POINTS>) -> f64 {
    skeleton
        .polylines()
        .flat_map(|polyline| polyline.segments())
        .map(|(_, [from, to])| (to - from).norm_squared().sqrt())
        .sum()
}

#[test]
fn both_sides_of_every_loop_meet() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 80.0,
        r4: 60.0,
    };
    for step in 0..24 {
        let theta2 = TAU * f64::from(step) / 24.0;
        for assembly in Assembly::BOTH {
            let pose = linkage.position(theta2, assembly).unwrap();
            let skeleton = linkage.skeleton(&pose);
            let ends: Vec<Plane> = skeleton
                .polylines()
                .filter_map(|polyline| polyline.joints.last().copied())
                .collect();
            let gap = (ends[0] - ends[1]).norm_squared().sqrt();
            // coupler and rocker are at an angle μ, and the diagonal's rounding counts 1 / sin μ times
            let closeness = (pose.theta3.value() - pose.theta4.value()).sin().abs();
            assert!(
                gap <= 4.0 * f64::EPSILON * size(&skeleton) / closeness,
                "{theta2} {assembly}: {gap}"
            );
        }
    }
}

#[test]
fn every_link_has_its_length() {
    let pose = SIX_BAR.position(1.1, SixBar::<f64>::ASSEMBLIES[0]).unwrap();
    let skeleton = SIX_BAR.skeleton(&pose);
    let rounding = 8.0 * f64::EPSILON * size(&skeleton);
    let expected = [
        30.0,
        80.0,
        90.0,
        60.0,
        30.0,
        35_f64.hypot(25.0),
        110.0,
        150_f64.hypot(20.0),
        60.0,
    ];
    let lengths: Vec<f64> = skeleton
        .polylines()
        .flat_map(|polyline| polyline.segments())
        .map(|(_, [from, to])| (to - from).norm_squared().sqrt())
        .collect();
    assert_eq!(lengths.len(), expected.len());
    for (length, expected) in lengths.iter().zip(expected) {
        assert!((length - expected).abs() <= rounding, "{lengths:?}");
    }
}

#[test]
fn sides_and_links_are_named_as_they_are_written() {
    let pose = SIX_BAR.position(1.1, SixBar::<f64>::ASSEMBLIES[0]).unwrap();
    let skeleton = SIX_BAR.skeleton(&pose);
    let names: Vec<(usize, &str, &[&str])> = skeleton
        .polylines()
        .map(|polyline| (polyline.equation, polyline.name, polyline.links))
        .collect();
    // the second side of the first equation is zero
    assert_eq!(
        names,
        [
            (
                0,
                "pin + coupler * cis(coupler_angle) - (ground + rocker * cis(rocker_angle))",
                &[
                    "pin",
                    "coupler * cis(coupler_angle)",
                    "-ground",
                    "-rocker * cis(rocker_angle)"
                ][..]
            ),
            (
                1,
                "point - -rod * cis(rod_angle)",
                &["pin", "tracer * cis(coupler_angle)", "-(-rod * cis(rod_angle))"]
            ),
            (1, "pivot + arm * cis(arm_angle)", &["pivot", "arm * cis(arm_angle)"]),
        ]
    );
    for polyline in skeleton.polylines() {
        assert_eq!(polyline.joints.len(), polyline.links.len() + 1);
        assert_eq!(polyline.joints[0], Plane::new(0.0, 0.0));
        assert!(SixBar::<f64>::DESCRIPTION.equations[polyline.equation].contains(polyline.name));
    }
}

#[test]
fn loops_of_a_chain_share_their_joints() {
    let pose = SIX_BAR.position(1.1, SixBar::<f64>::ASSEMBLIES[0]).unwrap();
    let skeleton = SIX_BAR.skeleton(&pose);
    let [first, second, third] = [0, 1, 2].map(|place| skeleton.polylines().nth(place).unwrap());
    assert_eq!(first.joints[1], second.joints[1]);
    let rounding = 8.0 * f64::EPSILON * size(&skeleton);
    // the first loop is closed, and the second loop's sides meet
    assert!(first.joints.last().unwrap().norm_squared().sqrt() <= rounding);
    let gap = *second.joints.last().unwrap() - *third.joints.last().unwrap();
    assert!(gap.norm_squared().sqrt() <= rounding);
    // the coupler point is a joint of the second loop
    let points: Vec<(&str, Plane)> = skeleton.points().collect();
    assert_eq!(points.len(), 2);
    assert_eq!(points[0].0, "tip");
    assert!((points[0].1 - second.joints[2]).norm_squared().sqrt() <= rounding);
    assert!((points[0].1 - pose.tip.value()).norm_squared().sqrt() <= rounding);
    assert_eq!(points[1], ("corner", Plane::new(90.0, 0.0)));
}

#[test]
fn poses_of_every_order_show_the_same() {
    let assembly = SixBar::<f64>::ASSEMBLIES[1];
    let position = SIX_BAR.position(0.4, assembly).unwrap();
    let velocity = position.velocity(2.0);
    let acceleration = velocity.acceleration(0.5);
    let jerk = acceleration.jerk(0.0);
    let snap = jerk.snap(0.0);
    let picture = SIX_BAR.skeleton(&position);
    assert_eq!(picture, SIX_BAR.skeleton(&velocity));
    assert_eq!(picture, SIX_BAR.skeleton(&acceleration));
    assert_eq!(picture, SIX_BAR.skeleton(&jerk));
    assert_eq!(picture, SIX_BAR.skeleton(&snap));
    assert_eq!(PoseOf::<SixBar>::input_values(&snap), [0.4]);
    assert_eq!(PoseOf::<SixBar>::unknowns(&snap), position.unknowns());
}

#[test]
fn skeletons_are_made_of_any_number_type() {
    let linkage: FourBar<f32> = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let pose = linkage.position(1.0, Assembly::Open).unwrap();
    let skeleton: Skeleton<Plane<f32>, 6, 0> = linkage.skeleton(&pose);
    assert_eq!(skeleton.joints()[4], Plane::new(90.0, 0.0));
}

mod scalar {
    use kin_core::prelude::*;

    pub(super) trait Bare {
        fn skeleton(&self) -> &'static str {
            "none"
        }
    }

    impl Bare for super::GeometricFourBar {}

    #[test]
    fn scalar_equations_have_no_skeleton() {
        // if there were one, it would be found before that of a trait
        let linkage: super::GeometricFourBar = super::GeometricFourBar::from_parameters([90.0, 30.0, 60.0, 45.0]);
        assert_eq!(linkage.skeleton(), "none");
    }
}

/// In space the joints are points of space, and a chain of the plane lies in that of x and y.
#[test]
fn loops_of_space() {
    mechanism! {
        pub struct SpaceLoop { pub crank: Length, pub rod: Length, pub rocker: Length, pub pivot: Point3, pub post: Length }
        input theta: Angle;
        unknown phi: Angle, azimuth: Angle, elevation: Angle, x: Length, y: Length;
        rot_z(theta) * vec3(crank, 0, 0) + rot_z(azimuth) * rot_y(-elevation) * vec3(rod, 0, 0)
            == pivot + rot_x(phi) * vec3(0, rocker, 0);
        post * cis(theta) == vec2(x, y);
        output ball: Point3 = rot_z(theta) * vec3(crank, 0, 0);
    }
    let (theta, phi, azimuth, elevation) = (0.4_f64, 0.9_f64, 0.3_f64, 0.2_f64);
    let crank = Space::new(theta.cos(), theta.sin(), 0.0);
    let rod = Space::new(
        3.0 * elevation.cos() * azimuth.cos(),
        3.0 * elevation.cos() * azimuth.sin(),
        3.0 * elevation.sin(),
    );
    let rocker = Space::new(0.0, 2.0 * phi.cos(), 2.0 * phi.sin());
    let linkage = SpaceLoop {
        crank: 1.0,
        rod: 3.0,
        rocker: 2.0,
        pivot: crank + rod - rocker,
        post: 0.5,
    };
    let pose = linkage
        .position_near(theta, [phi + 0.01, azimuth - 0.01, elevation + 0.01, 0.5, 0.2])
        .expect("it is built around this position");
    let skeleton = linkage.skeleton(&pose);
    let ends: Vec<(usize, Space)> = skeleton
        .polylines()
        .map(|line| (line.joints.len(), line.joints[line.joints.len() - 1]))
        .collect();
    assert_eq!(ends.iter().map(|end| end.0).collect::<Vec<_>>(), [3, 3, 2, 2]);
    for pair in ends.chunks(2) {
        let gap = (pair[0].1 - pair[1].1).norm();
        assert!(gap <= 16.0 * f64::EPSILON * 3.0, "{gap}");
    }
    assert_eq!(ends[2].1.z, 0.0);
    let points: Vec<_> = skeleton.points().collect();
    assert_eq!(points.len(), 1);
}
