//! Loads on mechanisms of the plane and of space, with one input and with several, in closed form and by Newton's
//! method.

mod energy;
#[cfg(feature = "num-dual")]
mod lagrange;
mod mistakes;
mod named;
mod shaking;
mod textbooks;

use crate::geometry::{Plane, Space};
use crate::library::ClassThreeTriad;
use crate::load::{Load, Loads, Solid};
use crate::mechanism::Mechanism;
use crate::motion::Motion;

crate::mechanism! {
    /// Four-bar linkage with the centres of its links.
    pub(super) struct FourBar {
        pub(super) r1: Length,
        pub(super) r2: Length,
        pub(super) r3: Length,
        pub(super) r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Direction;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    output coupler: Point = r2 * cis(theta2) + polar(r3 / 2, theta3 + 0.25);
    output rocker: Point = r1 + r4 / 3 * cis(theta4);
    output pin: Point = r1 + r4 * cis(theta4);
}

crate::mechanism! {
    /// Slider-crank with the centre of its rod.
    pub(super) struct Engine {
        pub(super) crank: Length,
        pub(super) rod: Length,
    }
    input theta: Angle;
    unknown phi: Angle, s: Length;
    crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
    output centre: Point = crank * cis(theta) + rod / 3 * cis(phi);
    output piston: Point = vec2(s, 0);
}

crate::mechanism! {
    /// Five-bar linkage with two drives.
    pub(super) struct Arm {
        pub(super) ground: Length,
        pub(super) left: Length,
        pub(super) left_rod: Length,
        pub(super) right_rod: Length,
        pub(super) right: Length,
    }
    input alpha: Angle, beta: Angle;
    unknown phi: Angle, psi: Angle;
    left * cis(alpha) + left_rod * cis(phi) == ground + right * cis(beta) + right_rod * cis(psi);
    output hand: Point = left * cis(alpha) + left_rod * cis(phi);
    output elbow: Point = left * cis(alpha);
    output middle: Point = ground + right * cis(beta) + right_rod / 2 * cis(psi);
}

crate::mechanism! {
    /// RSSR linkage with three points of its rocker, and the middle of its rod.
    pub(super) struct Spatial {
        pub(super) crank: Length,
        pub(super) pivot: Point3,
        pub(super) axis: Vector3,
        pub(super) arm: Vector3,
        pub(super) ear: Vector3,
        pub(super) rod: Length,
    }
    input theta: Angle;
    unknown phi: Angle;
    let rocker = pivot + rot(axis, phi) * arm;
    let crank_pin = rot_z(theta) * vec3(crank, 0, 0);
    let coupler = rocker - crank_pin;
    dot(coupler, coupler) == rod.powi(2);
    output pin: Point3 = crank_pin;
    output ball: Point3 = rocker;
    output middle: Point3 = (crank_pin + rocker) / 2;
    output lug: Point3 = pivot + rot(axis, phi) * ear;
    output root: Point3 = pivot + 0 * arm;
}

pub(super) const FOUR_BAR: FourBar = FourBar {
    r1: 0.9,
    r2: 0.3,
    r3: 0.6,
    r4: 0.45,
};

pub(super) const ENGINE: Engine = Engine { crank: 0.05, rod: 0.15 };

pub(super) const ARM: Arm = Arm {
    ground: 2.0,
    left: 1.5,
    left_rod: 2.4,
    right_rod: 2.4,
    right: 1.5,
};

pub(super) const SPATIAL: Spatial = Spatial {
    crank: 1.0,
    pivot: Space::new(3.0, 0.4, -0.2),
    axis: Space::new(0.2, 1.0, 0.3),
    arm: Space::new(0.3, 0.5, 2.0),
    ear: Space::new(1.1, -0.2, 0.4),
    rod: 3.6,
};

/// Platform on three legs, which Newton's method solves.
pub(super) const TRIAD: ClassThreeTriad = ClassThreeTriad {
    base_b: Plane::new(3.46, 0.1),
    base_c: Plane::new(1.7, 3.0),
    platform_b: Plane::new(1.7, 0.0),
    platform_c: Plane::new(0.9, 1.5),
};

/// The mass properties of point masses that are fixed to a body.
pub(super) const PARTICLES: [(f64, [f64; 3]); 4] = [
    (1.5, [0.3, 0.2, -0.1]),
    (0.7, [1.4, -0.3, 0.5]),
    (1.1, [0.8, 0.9, 0.2]),
    (0.4, [-0.2, 0.1, 0.7]),
];

pub(super) fn solid() -> Solid {
    solid_of(&PARTICLES)
}

pub(super) fn solid_of(particles: &[(f64, [f64; 3])]) -> Solid {
    let mass = particles.iter().map(|(mass, _)| mass).sum();
    let centre = [0, 1, 2].map(|axis| particles.iter().map(|(mass, place)| mass * place[axis]).sum::<f64>() / mass);
    let mut inertia = [[0.0; 3]; 3];
    for &(mass, place) in particles {
        let arm = [0, 1, 2].map(|axis| place[axis] - centre[axis]);
        let square: f64 = arm.iter().map(|part| part * part).sum();
        for (row, entries) in inertia.iter_mut().enumerate() {
            entries[row] += mass * square;
            for (entry, part) in entries.iter_mut().zip(arm) {
                *entry -= mass * arm[row] * part;
            }
        }
    }
    Solid {
        mass,
        centre: Space::from(centre),
        inertia,
    }
}

/// A force and a torque that change in time.
pub(super) const PULL: Motion<Plane, 5> = Motion::new([
    Plane::new(30.0, -50.0),
    Plane::new(7.0, 11.0),
    Plane::new(-40.0, 3.0),
    Plane::new(0.0, 0.0),
    Plane::new(0.0, 0.0),
]);
pub(super) const TWIST: Motion<f64, 5> = Motion::new([-4.0, 20.0, 9.0, 0.0, 0.0]);

pub(super) fn on_four_bar() -> Loads<FourBar, impl Load<FourBar>> {
    Loads::<FourBar>::new()
        .gravity(Plane::new(1.0, -9.81))
        .mass(2.5, |pose| pose.coupler)
        .inertia(0.08, |pose| pose.theta3)
        .mass(1.5, |pose| pose.rocker)
        .inertia(0.04, |pose| pose.theta4)
        .inertia(0.02, |pose| pose.theta2)
        .force(PULL, |pose| pose.pin)
        .torque(TWIST, |pose| pose.theta4)
        .spring(800.0, 0.35, |pose| pose.coupler, |_| Plane::new(0.4, 0.9))
        .spring(200.0, 0.0, |pose| pose.pin, |pose| pose.rocker)
        .damper(30.0, |pose| pose.pin, |_| Plane::new(0.1, 0.8))
        .torsion_spring(5.0, 0.3, |pose| pose.theta3)
        .torsion_damper(0.6, |pose| pose.theta4)
}

pub(super) fn on_engine() -> Loads<Engine, impl Load<Engine>> {
    Loads::<Engine>::new()
        .gravity(Plane::new(0.0, -9.81))
        .inertia(0.01, |pose| pose.theta)
        .mass(0.6, |pose| pose.centre)
        .inertia(0.002, |pose| pose.phi)
        .mass(0.8, |pose| pose.piston)
        .torque(-900.0, |pose| pose.s)
        .torsion_damper(15.0, |pose| pose.s)
}

pub(super) fn on_arm() -> Loads<Arm, impl Load<Arm>> {
    Loads::<Arm>::new()
        .gravity(Plane::new(0.0, -9.81))
        .mass(3.0, |pose| pose.hand)
        .mass(1.2, |pose| pose.middle)
        .inertia(0.4, |pose| pose.psi)
        .inertia(0.3, |pose| pose.beta)
        .mass(0.9, |pose| pose.elbow)
        .force(PULL, |pose| pose.hand)
        .spring(90.0, 0.8, |pose| pose.elbow, |pose| pose.middle)
        .damper(12.0, |pose| pose.elbow, |pose| pose.middle)
}

pub(super) fn on_spatial() -> Loads<Spatial, impl Load<Spatial>> {
    Loads::<Spatial>::new()
        .gravity(Space::new(0.5, 0.0, -9.81))
        .inertia(0.5, |pose| pose.theta)
        .body(solid(), |pose| [pose.root, pose.ball, pose.lug])
        // a slender rod
        .mass(0.3, |pose| pose.pin)
        .mass(1.2, |pose| pose.middle)
        .mass(0.3, |pose| pose.ball)
        .force(Space::new(10.0, -20.0, 5.0), |pose| pose.lug)
        .spring(70.0, 1.0, |pose| pose.lug, |_| Space::new(0.0, 3.0, 1.0))
        .torsion_damper(2.0, |pose| pose.phi)
}

pub(super) fn on_triad() -> Loads<ClassThreeTriad, impl Load<ClassThreeTriad>> {
    Loads::<ClassThreeTriad>::new()
        .gravity(Plane::new(0.0, -9.81))
        .mass(6.0, |pose| pose.centre)
        .inertia(2.0, |pose| pose.phi)
        .torque(TWIST, |pose| pose.phi)
        .spring(60.0, 0.5, |pose| pose.centre, |_| Plane::new(5.0, 4.0))
        .torsion_damper(8.0, |pose| pose.a)
}

/// Numbers between -1 and 1 without a pattern, the same in every run: multiples of the golden ratio.
pub(super) struct Numbers(f64);

impl Numbers {
    pub(super) fn new() -> Self {
        Self(0.1)
    }

    pub(super) fn next(&mut self) -> f64 {
        self.0 = (self.0 + 0.618_033_988_749_894_9) * 1.37 % 1.0;
        2.0 * self.0 - 1.0
    }

    /// A motion whose value is within `reach` of `middle`.
    pub(super) fn motion(&mut self, middle: f64, reach: f64, speed: f64) -> Motion<f64, 5> {
        let mut size = speed;
        let mut motion = Motion::constant(middle + reach * self.next());
        for order in 1..5 {
            motion[order] = size * self.next();
            size *= speed;
        }
        motion
    }
}

/// The loads with the mechanism, and motions of the inputs that it can follow.
pub(super) trait Case {
    type Mechanism: Mechanism<Scalar = f64>;

    fn mechanism() -> Self::Mechanism;
    fn assembly() -> <Self::Mechanism as Mechanism>::Assembly;
    fn loads() -> Loads<Self::Mechanism, impl Load<Self::Mechanism>>;
    fn inputs(
        numbers: &mut Numbers,
    ) -> <Self::Mechanism as Mechanism>::Inputs<<Self::Mechanism as Mechanism>::Motion<f64>>;
}

macro_rules! cases {
    ($(
        $case:ident: $mechanism:ty = $value:ident in $assembly:expr, $loads:ident,
        [$($middle:literal $reach:literal $speed:literal),+];
    )+) => {
        $(
            pub(super) struct $case;

            impl Case for $case {
                type Mechanism = $mechanism;

                fn mechanism() -> $mechanism {
                    $value
                }

                fn assembly() -> <$mechanism as Mechanism>::Assembly {
                    $assembly
                }

                fn loads() -> Loads<$mechanism, impl Load<$mechanism>> {
                    $loads()
                }

                fn inputs(
                    numbers: &mut Numbers,
                ) -> <$mechanism as Mechanism>::Inputs<<$mechanism as Mechanism>::Motion<f64>> {
                    [$(numbers.motion($middle, $reach, $speed)),+]
                }
            }
        )+
    };
}

cases! {
    OfFourBar: FourBar = FOUR_BAR in crate::Assembly::Open, on_four_bar, [0.6 0.8 6.0];
    OfEngine: Engine = ENGINE in crate::Assembly::Open, on_engine, [0.0 3.1 50.0];
    OfArm: Arm = ARM in crate::Assembly::Open, on_arm, [2.0 0.4 3.0, 1.1 0.4 3.0];
    OfSpatial: Spatial = SPATIAL in crate::Assembly::Open, on_spatial, [0.0 3.1 2.0];
    OfTriad: ClassThreeTriad = TRIAD in crate::Near([0.1, 2.2, -2.0, 1.6]), on_triad,
        [2.24 0.1 0.5, 2.24 0.1 0.5, 2.24 0.1 0.5];
}
