//! Cases of space: two skew shafts, and a crank with a block on a rail.

use kin_tests::reference::{Inertia, Joint, JointKind, Solid, SpaceCut, SpaceShape};

use super::record::{Case, Given};

const RSSR: &str = "\
struct Rssr { crank: Length, pivot: Point3, axis: Vector3, arm: Vector3, rod: Length }
input theta: Angle;
unknown phi: Angle;
let rocker = pivot + rot(axis, phi) * arm;
let knob = rot_z(theta) * vec3(crank, 0, 0);
dot(rocker - knob, rocker - knob) == rod.powi(2);
output pin: Point3 = knob;
output ball: Point3 = rocker;
output tip: Point3 = pivot + rot(axis, phi) * vec3(crank, 0, 0);
let up = vec3(0, 0, crank);
ground 0, up, pivot;
body crank: 0, pin, up;
body rod: pin, ball;
body rocker: pivot, ball, tip;
";

const RSSP: &str = "\
struct Rssp { crank: Length, start: Point3, rail: Vector3, rod: Length }
input theta: Angle;
unknown s: Length;
let slider = start + s * (rail / norm(rail));
let knob = rot_z(theta) * vec3(crank, 0, 0);
dot(slider - knob, slider - knob) == rod.powi(2);
output pin: Point3 = knob;
output ball: Point3 = slider;
output beside: Point3 = slider + vec3(0, crank, 0);
let up = vec3(0, 0, crank);
let above = slider + vec3(0, 0, crank);
ground 0, up;
body crank: 0, pin, up;
body block: ball, beside, above;
body rod: pin, ball;
slide ball along rail;
";

const CRANK: Solid = Solid {
    name: "crank",
    joints: [0, 2, 1],
    mass: 2.0,
    centre: [0.11, 0.05, -0.02],
    inertia: Inertia::Tensor([0.02, 0.03, 0.04, 0.003, -0.002, 0.001]),
};

const fn rod(ball: usize) -> Solid {
    Solid {
        name: "rod",
        joints: [2, ball, ball],
        mass: 1.1,
        centre: [0.6, 0.0, 0.0],
        inertia: Inertia::Rod(0.15),
    }
}

const ROCKER: Solid = Solid {
    name: "rocker",
    joints: [3, 4, 5],
    mass: 3.0,
    centre: [0.3, -0.06, 0.08],
    inertia: Inertia::Tensor([0.05, 0.16, 0.18, 0.01, -0.004, 0.006]),
};

const BLOCK: Solid = Solid {
    name: "block",
    joints: [3, 4, 5],
    mass: 1.7,
    centre: [0.04, 0.02, -0.03],
    inertia: Inertia::Tensor([0.02, 0.01, 0.03, 0.001, 0.002, -0.003]),
};

const fn joint(name: &'static str, joint: usize, (on, by): (usize, Option<usize>), kind: JointKind) -> Joint {
    Joint {
        name,
        joint,
        on,
        by,
        kind,
    }
}

const SHAFTS: SpaceCut = SpaceCut {
    shape: SpaceShape::Rssr,
    dimensions: &[0.4, 1.2, 0.2, 0.3, 0.08, 0.9, 0.12, 0.16, -0.12, 0.76, 1.3],
    bodies: &[CRANK, rod(4), ROCKER],
    joints: &[
        joint("ground_crank", 0, (0, None), JointKind::Hinge(0)),
        joint("ground_rocker", 3, (2, None), JointKind::Hinge(1)),
        joint("pin", 2, (1, Some(0)), JointKind::Ball),
        joint("ball", 4, (2, Some(1)), JointKind::Ball),
    ],
    gravity: [0.4, -0.7, -9.81],
    force: (2, 5, [3.0, -20.0, 11.0]),
    motion: [0.0, 7.0, -11.0, 50.0, -70.0],
};

const RAIL: SpaceCut = SpaceCut {
    shape: SpaceShape::Rssp,
    dimensions: &[0.3, 0.4, 0.5, 0.2, 1.0, 0.2, -0.3, 1.4],
    bodies: &[CRANK, BLOCK, rod(3)],
    joints: &[
        joint("ground_crank", 0, (0, None), JointKind::Hinge(0)),
        joint("pin", 2, (2, Some(0)), JointKind::Ball),
        joint("ball", 3, (2, Some(1)), JointKind::Ball),
        joint("ball_slide", 3, (1, None), JointKind::Guide(1)),
    ],
    gravity: [0.0, 0.0, -9.81],
    force: (1, 4, [-120.0, 30.0, 45.0]),
    motion: [0.0, 18.0, 40.0, -300.0, 2000.0],
};

pub(super) const CASES: [Case; 2] = [
    Case {
        name: "linkage RSSR of two skew shafts",
        declaration: RSSR,
        given: Given::Space(SHAFTS, &[("ground_rocker", "axis")]),
        starts: [0.3, 1.9, 4.4],
    },
    Case {
        name: "linkage RSSP with a block on a rail",
        declaration: RSSP,
        given: Given::Space(RAIL, &[]),
        starts: [0.5, 2.5, 5.0],
    },
];
