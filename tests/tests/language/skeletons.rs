//! The picture of a mechanism: its joints, bodies, slides and points, in poses of every order.

use std::f64::consts::TAU;

use kin_core::library::{FourBar, WhitworthQuickReturn};
use kin_core::prelude::*;
use kin_core::{Outline, PlaneOrSpace, Skeleton};

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

/// The distances of a body's joints from its first one.
fn lengths<const PLACES: usize>(skeleton: &Skeleton<[Plane; PLACES]>, name: &str) -> Vec<f64> {
    let (_, joints) = skeleton
        .bodies()
        .find(|(own, _)| *own == name)
        .expect("there is such a body");
    let joints: Vec<Plane> = joints.collect();
    joints.iter().skip(1).map(|&joint| (joint - joints[0]).norm()).collect()
}

#[test]
fn bodies_keep_their_lengths() {
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
            // coupler and rocker are at an angle μ, and the diagonal's rounding counts 1 / sin μ times
            let closeness = (pose.theta3.value() - pose.theta4.value()).sin().abs();
            let rounding = 4.0 * f64::EPSILON * 260.0 / closeness;
            for (name, length) in [("r2", 30.0), ("r3", 80.0), ("r4", 60.0)] {
                let gap = (lengths(&skeleton, name)[0] - length).abs();
                assert!(gap <= rounding, "{theta2} {assembly}, {name}: {gap}");
            }
        }
    }
}

#[test]
fn bodies_have_the_lengths_of_their_terms() {
    let pose = SIX_BAR.position(1.1, SixBar::<f64>::ASSEMBLIES[0]).unwrap();
    let skeleton = SIX_BAR.skeleton(&pose);
    let tracer = 35_f64.hypot(25.0);
    for (name, expected) in [
        ("crank", &[30.0][..]),
        ("coupler", &[80.0, tracer]),
        ("rocker", &[60.0]),
        ("rod", &[110.0]),
        ("arm", &[60.0]),
    ] {
        let own = lengths(&skeleton, name);
        assert_eq!(own.len(), expected.len(), "{name}");
        for (own, expected) in own.iter().zip(expected) {
            // joints are sums of at most four terms of this size
            assert!((own - expected).abs() <= 8.0 * f64::EPSILON * 300.0, "{name}: {own}");
        }
    }
    assert_eq!(skeleton.bodies().count(), 5);
    let fixed: Vec<Plane> = skeleton.ground().collect();
    assert_eq!(
        fixed,
        [Plane::new(0.0, 0.0), Plane::new(90.0, 0.0), Plane::new(150.0, 20.0)]
    );
}

#[test]
fn points_are_joints() {
    let pose = SIX_BAR.position(1.1, SixBar::<f64>::ASSEMBLIES[0]).unwrap();
    let skeleton = SIX_BAR.skeleton(&pose);
    // seven joints; one of them is the coupler point, another the corner
    assert_eq!(skeleton.joints().len(), 7);
    let points: Vec<(&str, Plane)> = skeleton.points().collect();
    assert_eq!(points.len(), 2);
    assert_eq!(points[0].0, "tip");
    assert!((points[0].1 - pose.tip.value()).norm() <= 8.0 * f64::EPSILON * 110.0);
    assert_eq!(points[1], ("corner", Plane::new(90.0, 0.0)));
}

#[test]
fn slides_are_on_their_lines() {
    let press: WhitworthQuickReturn = WhitworthQuickReturn {
        ground: 0.05,
        crank: 0.1,
        arm: 0.15,
        rod: 0.5,
    };
    let pose = press.position(1.0, Assembly::Open).unwrap();
    let skeleton = press.skeleton(&pose);
    let slides: Vec<_> = skeleton.slides().collect();
    let [(pin, [pin_at, along_lever]), (ram, [ram_at, along_guide])] = slides[..] else {
        panic!("{slides:?}");
    };
    let lever = pin.guide.map(|body| skeleton.outline().bodies[body].name);
    assert_eq!((lever, ram.guide), (Some("arm"), None));
    // the lever turns about the origin
    assert!(pin_at.cross(along_lever).abs() <= 4.0 * f64::EPSILON * 0.15);
    assert_eq!(along_guide, Plane::new(1.0, 0.0));
    assert!((ram_at - Plane::new(pose.ram.value(), 0.0)).norm() <= 4.0 * f64::EPSILON * 0.65);
}

/// Code that works with any mechanism sees the same.
#[test]
fn the_trait_gives_the_same_skeleton() {
    fn joints<M: Mechanism<Scalar = f64>>(mechanism: &M, pose: &impl PoseOf<M>) -> Vec<Space> {
        let skeleton = Mechanism::skeleton(mechanism, pose);
        skeleton.joints().iter().map(|joint| joint.in_space()).collect()
    }
    let pose = SIX_BAR.position(1.1, SixBar::<f64>::ASSEMBLIES[0]).unwrap();
    let own: Vec<Space> = SIX_BAR
        .skeleton(&pose)
        .joints()
        .iter()
        .map(|joint| joint.in_space())
        .collect();
    assert_eq!(joints(&SIX_BAR, &pose), own);
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
    let skeleton: Skeleton<[Plane<f32>; 4]> = linkage.skeleton(&pose);
    assert_eq!(skeleton.joints()[3], Plane::new(90.0, 0.0));
}

/// Where nothing tells of vectors, there is nothing to be seen.
#[test]
fn scalar_equations_have_an_empty_skeleton() {
    mechanism! {
        pub struct Gear { pub ratio: Scalar }
        input theta: Angle;
        unknown phi: Angle;
        phi == ratio * theta;
    }
    let gear: Gear = Gear { ratio: 2.0 };
    let pose = gear.position(1.0).unwrap();
    let skeleton = Mechanism::skeleton(&gear, &pose);
    let outline = *skeleton.outline();
    let (scalar_equations, guess) = (outline.scalar_equations, outline.guess);
    assert_eq!(scalar_equations, ["phi == ratio * theta"]);
    let nothing = Outline {
        scalar_equations,
        guess,
        ..Outline::NONE
    };
    assert_eq!(outline, nothing);
    assert!(skeleton.joints().is_empty());
}

/// In space the joints are points of space, and a chain of the plane lies in that of x and y.
#[test]
fn loops_of_space() {
    mechanism! {
        pub struct SpaceLoop { pub crank: Length, pub rod: Length, pub rocker: Length, pub pivot: Point3,
            pub post: Length }
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
    let bodies: Vec<(&str, Vec<Space>)> = skeleton
        .bodies()
        .map(|(name, joints)| (name, joints.collect()))
        .collect();
    let lengths: Vec<(&str, f64)> = bodies
        .iter()
        .map(|(name, joints)| (*name, (joints[1] - joints[0]).norm()))
        .collect();
    for ((name, length), expected) in lengths.iter().zip([1.0, 3.0, 2.0, 0.5]) {
        assert!(
            (length - expected).abs() <= 16.0 * f64::EPSILON * 6.0,
            "{name}: {length}"
        );
    }
    assert_eq!(lengths.len(), 4);
    let (_, post) = &bodies[3];
    assert_eq!(post[1].z, 0.0);
    let points: Vec<_> = skeleton.points().collect();
    assert_eq!(points.len(), 1);
}
