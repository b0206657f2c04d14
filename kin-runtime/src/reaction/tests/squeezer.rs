//! Andrews' squeezing mechanism: its accelerations, and the multipliers of its constraints, which are the forces of the
//! rods' joint.
//!
//! E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, 2nd edition, Springer 1996, section VII.7. The
//! reference is the index-3 form in 40 digits, from the crank's angle and speed alone.

use crate::any::PositionChoice;
use crate::geometry::Plane;
use crate::linkage::AnyLinkage;
use crate::mechanism::{Mechanism as _, Pose as _};
use crate::motion::Motion;

crate::mechanism! {
    struct Squeezer {
        rr: Length, d: Length, ss: Length, e: Length, zt: Length, zf: Length, u: Length, sc: Length, sd: Length,
        a: Point, b: Point,
    }
    input beta: Angle;
    unknown theta: Angle, gamma: Angle, phi: Angle, delta: Angle, omega: Angle, epsilon: Angle;
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

/// The torque of the drive.
const TORQUE: f64 = 0.033;

/// The accelerations of the crank and of all unknowns, and the forces of the rods' joint.
type Results = [f64; 13];

/// The state of the crank, with angles near those of the position, and its results.
const STATES: [([f64; 2], [f64; 6], Results); 2] = [
    (
        [15.810_771_196_299_04, 1_139.920_302_151_208],
        [-15.756_371, 0.040_822, -0.534_730, 0.524_410, 0.534_730, 1.048_081],
        [
            -24_631.764_252_260_194,
            51_850.321_377_763_43,
            324_102.600_599_200_5,
            566_749.421_810_386_8,
            16_743.635_403_385_047,
            -566_749.421_810_386_8,
            9_826.507_827_777_823,
            199.175_348_059_431_3,
            -29.755_310_060_354_73,
            23.066_543_603_094_976,
            31.452_725_248_499_867,
            22.642_494_778_641_265,
            11.617_392_380_709_046,
        ],
    ),
    (
        [-0.061_713_890_014_276_45, 0.0],
        [0.0, 0.4553, 0.2227, 0.4874, -0.2227, 1.2305],
        [
            14_222.443_919_954_114,
            -10_666.832_939_965_585,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            98.566_870_396_241_09,
            -6.122_688_344_255_663,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
    ),
];

/// The results, where each given number is changed by a factor.
fn results([angle, speed]: [f64; 2], near: [f64; 6], factor: impl Fn(usize) -> f64) -> Results {
    let mut count = 0;
    let mut given = |value: f64| {
        count += 1;
        value * factor(count - 1)
    };
    let squeezer = Squeezer::from_parameters(SQUEEZER.parameters().map(&mut given));
    let [angle, speed] = [angle, speed].map(&mut given);
    let linkage = AnyLinkage::of(&squeezer);
    let hook = Plane::new(given(0.014), given(0.072));
    let loads = linkage.loads().spring(given(4530.0), given(0.077_85), "hook", hook);
    let loads = BODIES.iter().try_fold(loads.expect("points"), |loads, own| {
        let (name, mass, inertia, [x, y]) = *own;
        loads.mass_of(name, given(mass), Plane::new(given(x), given(y)), given(inertia))
    });
    let reactions = linkage.reactions(&loads.expect("bodies")).expect("they are declared");
    let at = |acceleration: f64| {
        let motion = Motion::from((angle, speed, acceleration, 0.0, 0.0));
        let found = reactions.at(&[motion], PositionChoice::Near(&near));
        (motion, found.expect("it is determined"))
    };
    let torque = |acceleration: f64| at(acceleration).1.effort(0).expect("it is determined")[0];
    // the torque is linear in the acceleration, with the inertia that the crank feels
    let (unit, still) = (1e4, torque(0.0));
    let inertia = (torque(unit) - still) / unit;
    let acceleration = (given(TORQUE) - still) / inertia;
    let (motion, found) = at(acceleration);
    let pose = squeezer.solve_near(motion, near).expect("it closes");
    let angles = pose.unknown_motions().map(|angle| angle.acceleration());
    let forces = ["knee_k3", "knee_k4", "knee_k6"].map(|name| {
        let force = found.of(name).expect("it is determined");
        [force.x[0], force.y[0]]
    });
    let mut all = [acceleration]
        .into_iter()
        .chain(angles)
        .chain(forces.into_iter().flatten());
    core::array::from_fn(|_| all.next().expect("a result"))
}

/// The given numbers: dimensions, the crank's state, the spring, masses, and the torque.
const GIVEN: usize = 13 + 2 + 4 + 4 * 7 + 1;

/// Numbers of the reference have errors of a few roundings times the condition: the sum of the changes with each given
/// number.
#[test]
fn accelerations_and_multipliers() {
    const CHANGE: f64 = 1e-6;
    for (crank, near, expected) in STATES {
        let found = results(crank, near, |_| 1.0);
        let mut condition = expected.map(f64::abs);
        for changed in 0..GIVEN {
            let factor = |index: usize| if index == changed { 1.0 + CHANGE } else { 1.0 };
            let more = results(crank, near, factor);
            for (condition, (more, found)) in condition.iter_mut().zip(more.into_iter().zip(found)) {
                *condition += (more - found).abs() / CHANGE;
            }
        }
        for ((found, expected), condition) in found.into_iter().zip(expected).zip(condition) {
            let roundings = (found - expected).abs() / (f64::EPSILON * condition);
            assert!(roundings < 4.0, "{found} {expected}: {roundings}");
        }
    }
}
