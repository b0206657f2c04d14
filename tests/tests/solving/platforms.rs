//! All positions of a platform on six legs, the Stewart-Gough platform, by the angles and by the joints of its body.

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

type Vector = Space<f64>;
type Pose = [f64; 6];

impl Platform {
    fn new([a1, a2, a3, a4, a5, a6]: [Vector; 6], [b1, b2, b3, b4, b5, b6]: [Vector; 6]) -> Self {
        Self {
            a1,
            a2,
            a3,
            a4,
            a5,
            a6,
            b1,
            b2,
            b3,
            b4,
            b5,
            b6,
        }
    }

    fn joints(&self) -> [(Vector, Vector); 6] {
        let Self {
            a1,
            a2,
            a3,
            a4,
            a5,
            a6,
            b1,
            b2,
            b3,
            b4,
            b5,
            b6,
        } = *self;
        [(a1, b1), (a2, b2), (a3, b3), (a4, b4), (a5, b5), (a6, b6)]
    }

    /// The lengths of the legs.
    fn lengths(&self, &[x, y, z, roll, pitch, yaw]: &Pose) -> [f64; 6] {
        self.joints().map(|(a, b)| {
            let turn = |[u, v]: [f64; 2], angle: f64| {
                let (sine, cosine) = angle.sin_cos();
                [cosine * u - sine * v, sine * u + cosine * v]
            };
            let [y1, z1] = turn([b.y, b.z], roll);
            let [z2, x2] = turn([z1, b.x], pitch);
            let [x3, y3] = turn([x2, y1], yaw);
            (Space::new(x + x3, y + y3, z + z2) - a).norm()
        })
    }

    /// All positions with legs of these lengths, each of which has them.
    fn all(&self, lengths: [f64; 6]) -> Vec<Pose> {
        let [l1, l2, l3, l4, l5, l6] = lengths;
        let start = Instant::now();
        let all = self
            .assemblies_at(l1, l2, l3, l4, l5, l6)
            .expect("the lengths are finite");
        println!("{} positions by angles in {:?}", all.len(), start.elapsed());
        assert!(all.is_complete());
        assert_eq!(all.singular(), 0);
        for Near(pose) in &all {
            for (own, expected) in self.lengths(pose).into_iter().zip(lengths) {
                // a few operations with lengths below 4
                assert!(
                    (own - expected).abs() < 1e-13,
                    "{own} instead of {expected} at {pose:?}"
                );
            }
            // the same rotation by other angles
            let &[x, y, z, roll, pitch, yaw] = pose;
            let other = [
                x,
                y,
                z,
                roll + core::f64::consts::PI,
                core::f64::consts::PI - pitch,
                yaw + core::f64::consts::PI,
            ];
            assert!(
                all.iter().any(|Near(known)| is_same(known, &other)),
                "{other:?} is missing"
            );
        }
        all.iter().map(|Near(pose)| *pose).collect()
    }
}

/// Whether the coordinates agree, and the angles up to whole turns.
fn is_same(a: &Pose, b: &Pose) -> bool {
    let differences = a.iter().zip(b).enumerate().map(|(place, (a, b))| {
        let difference = a - b;
        if place < 3 {
            difference
        } else {
            (0.5 * difference).sin()
        }
    });
    differences.map(f64::abs).fold(0.0, f64::max) < 1e-9
}

fn vectors(random: &mut Random) -> [Vector; 6] {
    [(); 6].map(|()| {
        Space::new(
            random.between(-1.0, 1.0),
            random.between(-1.0, 1.0),
            random.between(-1.0, 1.0),
        )
    })
}

fn pose(random: &mut Random) -> Pose {
    [1.0, 1.0, 1.0, 3.0, 1.5, 3.0].map(|most| random.between(-most, most))
}

/// P. Dietmaier, "The Stewart-Gough platform of general geometry can have 40 real postures", Advances in Robot Kinematics:
/// Analysis and Control (1998) 7-16.
#[test]
fn a_platform_with_forty_postures() {
    let ground = [
        Space::new(0.0, 0.0, 0.0),
        Space::new(1.107_915, 0.0, 0.0),
        Space::new(0.549_094, 0.756_063, 0.0),
        Space::new(0.735_077, -0.223_935, 0.525_991),
        Space::new(0.514_188, -0.526_063, -0.368_418),
        Space::new(0.590_473, 0.094_733, -0.205_018),
    ];
    let platform = [
        Space::new(0.0, 0.0, 0.0),
        Space::new(0.542_805, 0.0, 0.0),
        Space::new(0.956_919, -0.528_915, 0.0),
        Space::new(0.665_885, -0.353_482, 1.402_538),
        Space::new(0.478_359, 1.158_742, 0.107_672),
        Space::new(-0.137_087, -0.235_121, 0.353_913),
    ];
    let lengths = [1.0, 0.645_275, 1.086_284, 1.503_439, 1.281_933, 0.771_071];
    let all = Platform::new(ground, platform).all(lengths);
    // each by two triples of angles
    assert_eq!(all.len(), 80);
}

/// A drawn position is among those that are found, and there are as many by other angles.
#[test]
fn a_drawn_position_is_found() {
    let mut random = Random::new(11);
    for number in 0..4 {
        let (mut ground, mut body) = (vectors(&mut random), vectors(&mut random));
        if number % 2 == 1 {
            // joints in a plane, as most platforms have them
            ground.iter_mut().for_each(|joint| joint.z = 0.0);
            body.iter_mut().for_each(|joint| joint.z = 0.0);
        }
        let platform = Platform::new(ground, body);
        let drawn = pose(&mut random);
        let lengths = platform.lengths(&drawn);
        let all = platform.all(lengths);
        assert!(all.iter().any(|known| is_same(known, &drawn)), "{drawn:?} is missing");

        let Platform {
            a1,
            a2,
            a3,
            a4,
            a5,
            a6,
            b1,
            b2,
            b3,
            b4,
            b5,
            b6,
        } = platform;
        let euler = EulerPlatform {
            a1,
            a2,
            a3,
            a4,
            a5,
            a6,
            b1,
            b2,
            b3,
            b4,
            b5,
            b6,
        };
        let [l1, l2, l3, l4, l5, l6] = lengths;
        let others = euler
            .assemblies_at(l1, l2, l3, l4, l5, l6)
            .expect("the lengths are finite");
        assert!(others.is_complete());
        assert_eq!(others.len(), all.len());
    }
}

/// As many positions are found by the coordinates of three joints, and each there only once.
#[test]
fn as_many_by_joints() {
    let mut random = Random::new(12);
    for _ in 0..4 {
        let [a1, a2, a3, a4, a5, a6] = vectors(&mut random);
        let [b1, b2, b3, ..] = vectors(&mut random);
        let platform = Platform::new([a1, a2, a3, a4, a5, a6], [b1, b1, b2, b2, b3, b3]);
        let lengths = platform.lengths(&pose(&mut random));
        let by_angles = platform.all(lengths);
        let [d12, d23, d31] = [b1 - b2, b2 - b3, b3 - b1].map(Space::norm);
        let joints = PlatformByJoints {
            a1,
            a2,
            a3,
            a4,
            a5,
            a6,
            d12,
            d23,
            d31,
        };
        let [l1, l2, l3, l4, l5, l6] = lengths;
        let start = Instant::now();
        let by_joints = joints
            .assemblies_at(l1, l2, l3, l4, l5, l6)
            .expect("the lengths are finite");
        println!("{} positions by joints in {:?}", by_joints.len(), start.elapsed());
        assert!(by_joints.is_complete());
        assert_eq!(2 * by_joints.len(), by_angles.len());
    }
}

/// Where the middle angle is a quarter of a turn, the other two are not determined: the position is singular in these
/// angles, and regular in others.
#[test]
fn locked_angles_are_singular() {
    let mut random = Random::new(13);
    let platform = Platform::new(vectors(&mut random), vectors(&mut random));
    let mut drawn = pose(&mut random);
    drawn[4] = core::f64::consts::FRAC_PI_2;
    let [l1, l2, l3, l4, l5, l6] = platform.lengths(&drawn);
    let all = platform
        .assemblies_at(l1, l2, l3, l4, l5, l6)
        .expect("the lengths are finite");
    let Platform {
        a1,
        a2,
        a3,
        a4,
        a5,
        a6,
        b1,
        b2,
        b3,
        b4,
        b5,
        b6,
    } = platform;
    let euler = EulerPlatform {
        a1,
        a2,
        a3,
        a4,
        a5,
        a6,
        b1,
        b2,
        b3,
        b4,
        b5,
        b6,
    };
    let others = euler
        .assemblies_at(l1, l2, l3, l4, l5, l6)
        .expect("the lengths are finite");
    assert!(all.is_complete() && others.is_complete());
    println!(
        "{} {} {} {}",
        all.len(),
        all.singular(),
        others.len(),
        others.singular()
    );
    assert_eq!((all.singular(), others.singular()), (2, 0));
    assert_eq!(all.len() + 2, others.len());
}

/// A leg cannot be shorter than nothing.
#[test]
fn a_negative_length_has_no_position() {
    let mut random = Random::new(14);
    let platform = Platform::new(vectors(&mut random), vectors(&mut random));
    let [l1, l2, l3, l4, l5, l6] = platform.lengths(&pose(&mut random));
    let all = platform
        .assemblies_at(-l1, l2, l3, l4, l5, l6)
        .expect("the lengths are finite");
    assert!(all.is_complete());
    assert_eq!((all.len(), all.singular()), (0, 0));
}
