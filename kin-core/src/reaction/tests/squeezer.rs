//! Andrews' squeezing mechanism: the multipliers of its constraints are the forces of the rods' joint.
//!
//! E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, 2nd edition, Springer 1996, section VII.7. The
//! reference is the index-3 form in 40 digits, from the crank's angle and speed of the published solution at 0.03 s.

use crate::any::PositionChoice;
use crate::geometry::Plane;
use crate::linkage::AnyLinkage;
use crate::load::NamedLoads;
use crate::motion::Motion;

crate::mechanism! {
    struct Squeezer {
        rr: Length, d: Length, ss: Length, e: Length, zt: Length, zf: Length, u: Length, sc: Length, sd: Length,
        a: Point, b: Point,
    }
    input theta: Angle;
    unknown beta: Angle, gamma: Angle, phi: Angle, delta: Angle, omega: Angle, epsilon: Angle;
    let pin = rr * cis(beta);
    let joint = pin - d * cis(beta + theta);
    joint + vec2(0, ss) * cis(gamma) == b;
    joint + vec2(0, e) * cis(phi + delta) - zt * cis(delta) == a;
    joint - zf * cis(omega + epsilon) + vec2(0, u) * cis(epsilon) == a;
    output knee: Point = joint;
    output hook: Point = b + vec2(sd, -sc) * cis(gamma);
    let heel = joint + vec2(0, e) * cis(phi + delta);
    let toe = joint - zf * cis(omega + epsilon);
    ground 0, a, b;
    body k1: 0, pin;
    body k2: pin, knee;
    body k3: b, knee, hook;
    body k4: knee, heel;
    body k5: a, heel;
    body k6: knee, toe;
    body k7: a, toe;
}

const SQUEEZER: Squeezer = Squeezer {
    rr: 7e-3,
    d: 28e-3,
    ss: 35e-3,
    e: 2e-2,
    zt: 4e-2,
    zf: 2e-2,
    u: 4e-2,
    sc: 18e-3,
    sd: 2e-2,
    a: Plane::new(-0.069_34, -0.002_27),
    b: Plane::new(-0.036_35, 0.032_73),
};

/// Mass, moment of inertia, and centre in the frame of each body.
const BODIES: [(&str, f64, f64, [f64; 2]); 7] = [
    ("k1", 0.043_25, 2.194e-6, [92e-5, 0.0]),
    ("k2", 0.003_65, 4.410e-7, [115e-4, 0.0]),
    ("k3", 0.023_73, 5.255e-6, [1874e-5, 1043e-5]),
    ("k4", 0.007_06, 5.667e-7, [1421e-5, 0.0]),
    ("k5", 0.070_50, 1.169e-5, [2308e-5, 916e-5]),
    ("k6", 0.007_06, 5.667e-7, [1421e-5, 0.0]),
    ("k7", 0.054_98, 1.912e-5, [1228e-5, 449e-5]),
];

fn loads(linkage: &AnyLinkage<'_>) -> NamedLoads {
    let loads = linkage.loads().torque(0.033, "beta").expect("an angle");
    let loads = loads
        .spring(4530.0, 0.077_85, "hook", Plane::new(0.014, 0.072))
        .expect("points");
    BODIES.iter().fold(loads, |loads, (name, mass, inertia, [x, y])| {
        loads
            .mass_of(name, *mass, Plane::new(*x, *y), *inertia)
            .expect("a body")
    })
}

#[test]
fn the_multipliers_are_forces() {
    let linkage = AnyLinkage::of(&SQUEEZER);
    let reactions = linkage.reactions(&loads(&linkage)).expect("its bodies are declared");
    for (beta, speed, acceleration, multipliers) in [
        (
            15.810_771_196_299_04,
            1_139.920_302_151_208,
            51_850.321_377_763_43,
            [
                199.175_348_059_431_3,
                -29.755_310_060_354_73,
                23.066_543_603_094_976,
                31.452_725_248_499_867,
                22.642_494_778_641_265,
                11.617_392_380_709_046,
            ],
        ),
        (
            -0.061_713_890_014_276_45,
            0.0,
            -10_666.832_939_965_585,
            [98.566_870_396_241_09, -6.122_688_344_255_663, 0.0, 0.0, 0.0, 0.0],
        ),
    ] {
        // the input for which the crank stands at this angle
        let is_moving = speed != 0.0;
        let near = if is_moving {
            [15.810_771, 0.040_822, -0.534_730, 0.524_410, 0.534_730, 1.048_081]
        } else {
            [-0.0617, 0.4553, 0.2227, 0.4874, -0.2227, 1.2305]
        };
        let mut theta = if is_moving { -15.756_371 } else { 0.0 };
        let mut rate = 1.0;
        for _ in 0..4 {
            let pose = SQUEEZER
                .solve_near(Motion::at_constant_speed(theta, 1.0), near)
                .expect("it closes");
            rate = pose.beta.velocity();
            theta -= (pose.beta.value() - beta) / rate;
        }
        let motion = Motion::from((theta, speed / rate, acceleration, 0.0, 0.0));
        let found = reactions
            .at(&[motion], PositionChoice::Near(&near))
            .expect("it is determined");
        for (name, multipliers) in ["knee_k3", "knee_k4", "knee_k6"]
            .iter()
            .zip(multipliers.chunks_exact(2))
        {
            let force = found.of(name).expect("it is determined");
            for (own, multiplier) in [force.x[0], force.y[0]].iter().zip(multipliers) {
                assert!((own - multiplier).abs() < 1e-11 * 200.0, "{name}: {own} {multiplier}");
            }
        }
        // nothing drives the angle between crank and rod
        let [effort, ..] = found.effort(0).expect("it is determined");
        assert!(effort.abs() < 1e-11, "{effort}");
    }
}
