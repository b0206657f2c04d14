//! All positions of a platform on six legs, the Stewart-Gough platform, by the angles and by the joints of its body.

use core::f64::consts::{FRAC_PI_2, PI};
use std::time::Instant;

use kin_core::mechanism;
use kin_core::prelude::*;
use kin_tests::random::Random;

mechanism! {
    /// The lengths of the legs, from joints on the ground to joints of the platform.
    struct Platform {
        a1: Point3, a2: Point3, a3: Point3, a4: Point3, a5: Point3, a6: Point3,
        b1: Vector3, b2: Vector3, b3: Vector3, b4: Vector3, b5: Vector3, b6: Vector3,
    }
    input l1: Length, l2: Length, l3: Length, l4: Length, l5: Length, l6: Length;
    unknown x: Length, y: Length, z: Length, roll: Angle, pitch: Angle, yaw: Angle;
    let position = vec3(x, y, z);
    let rotation = rot_z(yaw) * rot_y(pitch) * rot_x(roll);
    norm(position + rotation * b1 - a1) == l1;
    norm(position + rotation * b2 - a2) == l2;
    norm(position + rotation * b3 - a3) == l3;
    norm(position + rotation * b4 - a4) == l4;
    norm(position + rotation * b5 - a5) == l5;
    norm(position + rotation * b6 - a6) == l6;
}

mechanism! {
    /// The same with the angles of Euler, and with squares of lengths.
    struct EulerPlatform {
        a1: Point3, a2: Point3, a3: Point3, a4: Point3, a5: Point3, a6: Point3,
        b1: Vector3, b2: Vector3, b3: Vector3, b4: Vector3, b5: Vector3, b6: Vector3,
    }
    input l1: Length, l2: Length, l3: Length, l4: Length, l5: Length, l6: Length;
    unknown precession: Angle, nutation: Angle, spin: Angle, z: Length, y: Length, x: Length;
    let leg1 = a1 - rot_z(precession) * rot_x(nutation) * rot_z(spin) * b1 - vec3(x, y, z);
    let leg2 = a2 - rot_z(precession) * rot_x(nutation) * rot_z(spin) * b2 - vec3(x, y, z);
    let leg3 = a3 - rot_z(precession) * rot_x(nutation) * rot_z(spin) * b3 - vec3(x, y, z);
    let leg4 = a4 - rot_z(precession) * rot_x(nutation) * rot_z(spin) * b4 - vec3(x, y, z);
    let leg5 = a5 - rot_z(precession) * rot_x(nutation) * rot_z(spin) * b5 - vec3(x, y, z);
    let leg6 = a6 - rot_z(precession) * rot_x(nutation) * rot_z(spin) * b6 - vec3(x, y, z);
    dot(leg1, leg1) == l1 * l1;
    dot(leg2, leg2) == l2 * l2;
    dot(leg3, leg3) == l3 * l3;
    dot(leg4, leg4) == l4 * l4;
    dot(leg5, leg5) == l5 * l5;
    dot(leg6, leg6) == l6 * l6;
}

mechanism! {
    /// A platform with three joints, each on two legs, by the coordinates of the joints.
    struct PlatformByJoints {
        a1: Point3, a2: Point3, a3: Point3, a4: Point3, a5: Point3, a6: Point3,
        d12: Length, d23: Length, d31: Length,
    }
    input l1: Length, l2: Length, l3: Length, l4: Length, l5: Length, l6: Length;
    unknown x1: Length, y1: Length, z1: Length;
    unknown x2: Length, y2: Length, z2: Length;
    unknown x3: Length, y3: Length, z3: Length;
    norm(vec3(x1, y1, z1) - a1) == l1;
    norm(vec3(x1, y1, z1) - a2) == l2;
    norm(vec3(x2, y2, z2) - a3) == l3;
    norm(vec3(x2, y2, z2) - a4) == l4;
    norm(vec3(x3, y3, z3) - a5) == l5;
    norm(vec3(x3, y3, z3) - a6) == l6;
    norm(vec3(x1 - x2, y1 - y2, z1 - z2)) == d12;
    norm(vec3(x2 - x3, y2 - y3, z2 - z3)) == d23;
    norm(vec3(x3 - x1, y3 - y1, z3 - z1)) == d31;
}

type Pose = [f64; 6];

/// The joints of a platform: three coordinates each, first those on the ground.
type Joints = [[[f64; 3]; 6]; 2];

fn platform(joints: &Joints) -> Platform {
    let coordinates = joints.as_flattened().as_flattened();
    Platform::from_parameters(coordinates.try_into().expect("there are 36"))
}

/// The lengths of the legs.
fn lengths([ground, body]: &Joints, &[x, y, z, roll, pitch, yaw]: &Pose) -> [f64; 6] {
    let turn = |[u, v]: [f64; 2], angle: f64| {
        let (sine, cosine) = angle.sin_cos();
        [cosine * u - sine * v, sine * u + cosine * v]
    };
    core::array::from_fn(|leg| {
        let ([ax, ay, az], [bx, by, bz]) = (ground[leg], body[leg]);
        let [by, bz] = turn([by, bz], roll);
        let [bz, bx] = turn([bz, bx], pitch);
        let [bx, by] = turn([bx, by], yaw);
        Space::new(x + bx - ax, y + by - ay, z + bz - az).norm()
    })
}

/// All positions at inputs, and how many singular ones there are besides.
fn all<M: Mechanism<Scalar = f64, Inputs<f64> = [f64; 6]>>(
    mechanism: &M,
    lengths: [f64; 6],
) -> (Vec<M::Unknowns<f64>>, usize) {
    let (start, mut all) = (Instant::now(), Vec::new());
    let search = mechanism
        .positions_at(lengths, |_, position| all.push(position))
        .expect("the lengths are finite");
    println!("{}: {} in {:?}", M::DESCRIPTION.name, all.len(), start.elapsed());
    assert!(search.is_complete);
    (all, search.singular)
}

/// All positions by roll, pitch and yaw, each of which has the given lengths.
fn all_by_angles(joints: &Joints, legs: [f64; 6]) -> Vec<Pose> {
    let (all, singular) = all(&platform(joints), legs);
    assert_eq!(singular, 0);
    for &[x, y, z, roll, pitch, yaw] in &all {
        let pose = [x, y, z, roll, pitch, yaw];
        for (own, expected) in lengths(joints, &pose).into_iter().zip(legs) {
            // a few operations with lengths below 4
            assert!(
                (own - expected).abs() < 1e-13,
                "{own} instead of {expected} at {pose:?}"
            );
        }
        let other = [x, y, z, roll + PI, PI - pitch, yaw + PI];
        assert!(contains(&all, &other), "{other:?} gives the same rotation");
    }
    all
}

/// Whether the coordinates of a known position agree, and the angles up to whole turns.
fn contains(all: &[Pose], pose: &Pose) -> bool {
    all.iter().any(|known| {
        let differences = known.iter().zip(pose).map(|(known, own)| known - own).enumerate();
        let difference = differences.map(|(place, own)| if place < 3 { own } else { (0.5 * own).sin() });
        difference.map(f64::abs).fold(0.0, f64::max) < 1e-9
    })
}

fn joints(random: &mut Random) -> Joints {
    [(); 2].map(|()| [(); 6].map(|()| [(); 3].map(|()| random.between(-1.0, 1.0))))
}

fn pose(random: &mut Random) -> Pose {
    [1.0, 1.0, 1.0, 3.0, 1.5, 3.0].map(|most| random.between(-most, most))
}

/// P. Dietmaier, "The Stewart-Gough platform of general geometry can have 40 real postures", Advances in Robot
/// Kinematics: Analysis and Control (1998) 7-16.
#[test]
fn a_platform_with_forty_postures() {
    let ground = [
        [0.0, 0.0, 0.0],
        [1.107_915, 0.0, 0.0],
        [0.549_094, 0.756_063, 0.0],
        [0.735_077, -0.223_935, 0.525_991],
        [0.514_188, -0.526_063, -0.368_418],
        [0.590_473, 0.094_733, -0.205_018],
    ];
    let body = [
        [0.0, 0.0, 0.0],
        [0.542_805, 0.0, 0.0],
        [0.956_919, -0.528_915, 0.0],
        [0.665_885, -0.353_482, 1.402_538],
        [0.478_359, 1.158_742, 0.107_672],
        [-0.137_087, -0.235_121, 0.353_913],
    ];
    let legs = [1.0, 0.645_275, 1.086_284, 1.503_439, 1.281_933, 0.771_071];
    // each by two triples of angles
    assert_eq!(all_by_angles(&[ground, body], legs).len(), 80);
}

/// A drawn position is among those that are found, and there are as many by other angles.
#[test]
fn a_drawn_position_is_found() {
    let mut random = Random::new(11);
    for number in 0..if cfg!(feature = "every-case") { 4 } else { 2 } {
        let mut joints = joints(&mut random);
        if number % 2 == 1 {
            // all in one plane, as most platforms have them
            joints.as_flattened_mut().iter_mut().for_each(|joint| joint[2] = 0.0);
        }
        let drawn = pose(&mut random);
        let legs = lengths(&joints, &drawn);
        let by_angles = all_by_angles(&joints, legs);
        assert!(contains(&by_angles, &drawn), "{drawn:?} is missing");
        let euler = EulerPlatform::from_parameters(platform(&joints).parameters());
        let (others, singular) = all(&euler, legs);
        assert_eq!((others.len(), singular), (by_angles.len(), 0));
    }
}

/// As many positions are found by the coordinates of three joints, and each there only once.
#[test]
fn as_many_by_joints() {
    let mut random = Random::new(12);
    for _ in 0..if cfg!(feature = "every-case") { 4 } else { 1 } {
        let [ground, [b1, b2, b3, ..]] = joints(&mut random);
        let joints = [ground, [b1, b1, b2, b2, b3, b3]];
        let legs = lengths(&joints, &pose(&mut random));
        let Platform {
            a1,
            a2,
            a3,
            a4,
            a5,
            a6,
            b1,
            b3,
            b5,
            ..
        } = platform(&joints);
        let [d12, d23, d31] = [b1 - b3, b3 - b5, b5 - b1].map(Space::norm);
        let (by_joints, _) = all(
            &PlatformByJoints {
                a1,
                a2,
                a3,
                a4,
                a5,
                a6,
                d12,
                d23,
                d31,
            },
            legs,
        );
        assert_eq!(2 * by_joints.len(), all_by_angles(&joints, legs).len());
    }
}

/// Where the middle angle is a quarter of a turn, the other two are not determined: the position is singular in these
/// angles, and regular in others.
#[test]
fn locked_angles_are_singular() {
    let mut random = Random::new(13);
    let (joints, mut drawn) = (joints(&mut random), pose(&mut random));
    drawn[4] = FRAC_PI_2;
    let (platform, legs) = (platform(&joints), lengths(&joints, &drawn));
    let (regular, singular) = all(&platform, legs);
    let (others, no_other) = all(&EulerPlatform::from_parameters(platform.parameters()), legs);
    assert_eq!((singular, no_other), (2, 0));
    assert_eq!(regular.len() + 2, others.len());
}

/// A leg cannot be shorter than nothing.
#[test]
fn a_negative_length_has_no_position() {
    let mut random = Random::new(14);
    let (joints, drawn) = (joints(&mut random), pose(&mut random));
    let mut legs = lengths(&joints, &drawn);
    legs[0] = -legs[0];
    let (regular, singular) = all(&platform(&joints), legs);
    assert_eq!((regular.len(), singular), (0, 0));
}
