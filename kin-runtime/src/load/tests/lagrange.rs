//! The efforts and their rates agree with Lagrange's equations, which dual numbers derive from positions alone.
//!
//! The equations are d/dt(∂T/∂q') - ∂T/∂q + ∂V/∂q = Q. The coordinates of the masses come from position solutions over
//! numbers with second derivatives by the inputs, whose parts carry two derivatives by time. Nothing is shared with the
//! loads but the position solvers: no rates of the mechanism, no outputs, no `Series`.

use std::vec;
use std::vec::Vec;

use num_dual::{Dual2, HyperDual};

use super::{
    Arm, Case, Engine, FourBar, Numbers, OfArm, OfEngine, OfFourBar, OfSpatial, OfTriad, PARTICLES, PULL, Spatial,
    TWIST,
};
use crate::geometry::{Plane, Space};
use crate::library::ClassThreeTriad;
use crate::load::Loaded;
use crate::mechanism::Mechanism;
use crate::motion::Motion;
use crate::number::{Number, Row};

/// A value with two derivatives by time.
type Timed = Dual2<f64>;
/// A value with its partial derivatives by two inputs.
type Twice = HyperDual<Timed>;

/// The errors of positions and of both derivations, in multiples of ε times the sum of the sizes of the terms. The
/// largest that occurs is 35, in space, where the rod and the rocker are least at right angles.
const BOUND: f64 = 64.0;

/// The coordinates on which the loads act, and the potential energy.
struct Model<T> {
    /// Masses and moments of inertia, with their coordinates.
    inertia: Vec<(f64, T)>,
    potential: T,
    /// Forces and torques, with their coordinates.
    forces: Vec<(Motion<f64, 5>, T)>,
    /// Constants of dampers, with their coordinates.
    dampers: Vec<(f64, T)>,
}

impl<T: Number> Model<T> {
    fn new() -> Self {
        Self {
            inertia: Vec::new(),
            potential: T::constant(0.0),
            forces: Vec::new(),
            dampers: Vec::new(),
        }
    }

    fn mass(&mut self, mass: f64, point: Space<T>, gravity: [f64; 3]) {
        for (part, gravity) in [point.x, point.y, point.z].into_iter().zip(gravity) {
            self.inertia.push((mass, part));
            self.potential = self.potential - T::constant(mass * gravity) * part;
        }
    }

    fn force(&mut self, force: Motion<Plane, 5>, point: Space<T>) {
        self.forces.push((force.x(), point.x));
        self.forces.push((force.y(), point.y));
    }

    fn spring(&mut self, stiffness: f64, rest: f64, length: T) {
        let stretch = length - T::constant(rest);
        self.potential = self.potential + T::constant(0.5 * stiffness) * stretch * stretch;
    }
}

fn flat<T: Number>(point: Plane<T>) -> Space<T> {
    Space::new(point.x, point.y, T::constant(0.0))
}

fn fixed<T: Number>(x: f64, y: f64, z: f64) -> Space<T> {
    Space::new(T::constant(x), T::constant(y), T::constant(z))
}

fn part(value: f64) -> Twice {
    Twice::constant(value)
}

/// The loads of a case, typed once more from the positions of the unknowns.
trait Dense: Case {
    fn model(
        mechanism: &<Self::Mechanism as Mechanism>::With<Twice>,
        inputs: &[Twice],
        unknowns: &[Twice],
    ) -> Model<Twice>;
}

impl Dense for OfFourBar {
    fn model(linkage: &FourBar<Twice>, inputs: &[Twice], unknowns: &[Twice]) -> Model<Twice> {
        let (theta2, theta3, theta4) = (inputs[0], unknowns[0], unknowns[1]);
        let gravity = [1.0, -9.81, 0.0];
        let ground = Plane::new(linkage.r1, part(0.0));
        let coupler =
            flat(Plane::polar(linkage.r2, theta2) + Plane::polar(linkage.r3 * part(0.5), theta3 + part(0.25)));
        let rocker = flat(ground + Plane::polar(linkage.r4 / part(3.0), theta4));
        let pin = flat(ground + Plane::polar(linkage.r4, theta4));
        let mut model = Model::new();
        model.mass(2.5, coupler, gravity);
        model.mass(1.5, rocker, gravity);
        model.inertia.extend([(0.08, theta3), (0.04, theta4), (0.02, theta2)]);
        model.force(PULL, pin);
        model.forces.push((TWIST, theta4));
        model.spring(800.0, 0.35, (coupler - fixed(0.4, 0.9, 0.0)).norm());
        model.spring(200.0, 0.0, (pin - rocker).norm());
        model.spring(5.0, 0.3, theta3);
        model.dampers = vec![(30.0, (pin - fixed(0.1, 0.8, 0.0)).norm()), (0.6, theta4)];
        model
    }
}

impl Dense for OfEngine {
    fn model(engine: &Engine<Twice>, inputs: &[Twice], unknowns: &[Twice]) -> Model<Twice> {
        let (theta, phi, s) = (inputs[0], unknowns[0], unknowns[1]);
        let gravity = [0.0, -9.81, 0.0];
        let centre = Plane::polar(engine.crank, theta) + Plane::polar(engine.rod / part(3.0), phi);
        let mut model = Model::new();
        model.mass(0.6, flat(centre), gravity);
        model.mass(0.8, Space::new(s, part(0.0), part(0.0)), gravity);
        model.inertia.extend([(0.01, theta), (0.002, phi)]);
        model.forces.push((Motion::constant(-900.0), s));
        model.dampers.push((15.0, s));
        model
    }
}

impl Dense for OfArm {
    fn model(arm: &Arm<Twice>, inputs: &[Twice], unknowns: &[Twice]) -> Model<Twice> {
        let gravity = [0.0, -9.81, 0.0];
        let elbow = flat(Plane::polar(arm.left, inputs[0]));
        let hand = elbow + flat(Plane::polar(arm.left_rod, unknowns[0]));
        let ground = Plane::new(arm.ground, part(0.0));
        let rod = Plane::polar(arm.right_rod * part(0.5), unknowns[1]);
        let middle = flat(ground + Plane::polar(arm.right, inputs[1]) + rod);
        let mut model = Model::new();
        model.mass(3.0, hand, gravity);
        model.mass(1.2, middle, gravity);
        model.mass(0.9, elbow, gravity);
        model.inertia.extend([(0.4, unknowns[1]), (0.3, inputs[1])]);
        model.force(PULL, hand);
        model.spring(90.0, 0.8, (elbow - middle).norm());
        model.dampers.push((12.0, (elbow - middle).norm()));
        model
    }
}

impl Dense for OfSpatial {
    fn model(linkage: &Spatial<Twice>, inputs: &[Twice], unknowns: &[Twice]) -> Model<Twice> {
        let gravity = [0.5, 0.0, -9.81];
        let (sine, cosine) = inputs[0].sin_cos();
        let pin = Space::new(linkage.crank * cosine, linkage.crank * sine, part(0.0));
        let turned = |vector: Space<Twice>| {
            let axis = linkage.axis.scale(part(1.0) / linkage.axis.norm());
            let (sine, cosine) = unknowns[0].sin_cos();
            let along = axis.scale(axis.dot(vector));
            along + (vector - along).scale(cosine) + axis.cross(vector).scale(sine)
        };
        let (ball, lug) = (linkage.pivot + turned(linkage.arm), linkage.pivot + turned(linkage.ear));
        let mut model = Model::new();
        // the particles of the body, in the frame of pivot, ball and lug
        let first = linkage.arm.scale(part(1.0) / linkage.arm.norm());
        let normal = linkage.arm.cross(linkage.ear);
        let third = normal.scale(part(1.0) / normal.norm());
        let second = third.cross(first);
        for (mass, [x, y, z]) in PARTICLES {
            let place = first.scale(part(x)) + second.scale(part(y)) + third.scale(part(z));
            model.mass(mass, linkage.pivot + turned(place), gravity);
        }
        model.mass(0.3, pin, gravity);
        model.mass(1.2, (pin + ball).scale(part(0.5)), gravity);
        model.mass(0.3, ball, gravity);
        model.inertia.push((0.5, inputs[0]));
        for (force, along) in [(10.0, lug.x), (-20.0, lug.y), (5.0, lug.z)] {
            model.forces.push((Motion::constant(force), along));
        }
        model.spring(70.0, 1.0, (lug - fixed(0.0, 3.0, 1.0)).norm());
        model.dampers.push((2.0, unknowns[0]));
        model
    }
}

impl Dense for OfTriad {
    fn model(triad: &ClassThreeTriad<Twice>, inputs: &[Twice], unknowns: &[Twice]) -> Model<Twice> {
        let (alpha, phi) = (unknowns[0], unknowns[3]);
        let third = (triad.platform_b + triad.platform_c).scale(part(1.0 / 3.0));
        let centre = flat(Plane::polar(inputs[0], alpha) + Plane::cis(phi).times(third));
        let mut model = Model::new();
        model.mass(6.0, centre, [0.0, -9.81, 0.0]);
        model.inertia.push((2.0, phi));
        model.forces.push((TWIST, phi));
        model.spring(60.0, 0.5, (centre - fixed(5.0, 4.0, 0.0)).norm());
        model.dampers.push((8.0, inputs[0]));
        model
    }
}

/// The motion from the derivative of an order on, with two derivatives by time.
fn timed(motion: &[f64], order: usize) -> Timed {
    Timed::new(motion[order], motion[order + 1], motion[order + 2])
}

/// A row of the mechanism over `Twice`.
type Row2<C> = <<<C as Case>::Mechanism as Mechanism>::With<Twice> as Mechanism>::Inputs<Twice>;

/// The model with the changes along two inputs.
fn model<C: Dense>(motions: &[&[f64]], along: [usize; 2]) -> Model<Twice> {
    let changing = C::mechanism().convert(Twice::constant);
    let inputs: Row2<C> = Row::from_fn(|input| {
        let seed = |direction: usize| Timed::constant(if along[direction] == input { 1.0 } else { 0.0 });
        Twice::new(timed(motions[input], 0), seed(0), seed(1), Timed::constant(0.0))
    });
    let unknowns = changing.position(inputs, C::assembly()).expect("it closes");
    C::model(&changing, inputs.as_ref(), unknowns.as_ref())
}

/// The effort of each input with its rates, and the sum of the sizes of the terms of each.
fn efforts<C: Dense>(motions: &[&[f64]]) -> Vec<[(f64, f64); 3]> {
    let count = motions.len();
    let zero = Timed::constant(0.0);
    let velocity: Vec<Timed> = motions.iter().map(|motion| timed(motion, 1)).collect();
    let acceleration: Vec<Timed> = motions.iter().map(|motion| timed(motion, 2)).collect();
    let models: Vec<Vec<Model<Twice>>> = (0..count)
        .map(|one| (0..count).map(|two| model::<C>(motions, [one, two])).collect())
        .collect();
    // J[i][j], and its derivative by input k
    let slope = |i: usize, j: usize, k: usize| {
        (models[i][k].inertia.iter().zip(&models[j][k].inertia)).fold(zero, |sum, ((weight, a), (_, b))| {
            sum + (a.eps1eps2 * b.eps1 + a.eps1 * b.eps1eps2) * *weight
        })
    };
    let inertia = |i: usize, j: usize| {
        let terms = &models[i][j].inertia;
        terms
            .iter()
            .fold(zero, |sum, (weight, a)| sum + a.eps1 * a.eps2 * *weight)
    };
    (0..count)
        .map(|i| {
            let mut terms = Vec::new();
            for j in 0..count {
                terms.push(inertia(i, j) * acceleration[j]);
                for k in 0..count {
                    // d/dt(∂T/∂q') and ∂T/∂q
                    terms.push(slope(i, j, k) * velocity[j] * velocity[k]);
                    terms.push(-slope(j, k, i) * velocity[j] * velocity[k] * 0.5);
                }
            }
            let own = &models[i][i];
            terms.push(own.potential.eps1);
            terms.extend(
                own.forces
                    .iter()
                    .map(|(force, along)| -along.eps1 * timed(force.as_slice(), 0)),
            );
            for (place, (damping, along)) in own.dampers.iter().enumerate() {
                let rate = (0..count).fold(zero, |sum, j| sum + models[j][j].dampers[place].1.eps1 * velocity[j]);
                terms.push(along.eps1 * rate * *damping);
            }
            let entry = |part: fn(&Timed) -> f64| {
                let (sum, size) = (
                    terms.iter().map(part).sum(),
                    terms.iter().map(|term| part(term).abs()).sum(),
                );
                (sum, size)
            };
            [entry(|term| term.re), entry(|term| term.v1), entry(|term| term.v2)]
        })
        .collect()
}

/// The largest difference of efforts and their rates, as a multiple of ε times the sum of the sizes of the terms.
fn worst<C: Dense>(poses: usize, change: impl Fn(usize, usize, &mut [f64])) -> f64 {
    let (mechanism, loads, mut numbers) = (C::mechanism(), C::loads(), Numbers::new());
    let mut worst: f64 = 0.0;
    for pose in 0..poses {
        let mut inputs = C::inputs(&mut numbers);
        for (input, motion) in inputs.as_mut().iter_mut().enumerate() {
            change(pose, input, motion.as_mut());
        }
        let motions: Vec<&[f64]> = inputs.as_ref().iter().map(AsRef::as_ref).collect();
        let expected = efforts::<C>(&motions);
        let found = mechanism
            .balance(&loads, inputs, C::assembly())
            .expect("it closes")
            .efforts();
        for (found, expected) in found.as_ref().iter().zip(expected) {
            for (found, (expected, size)) in found.as_slice().iter().zip(expected) {
                worst = worst.max((found - expected).abs() / (f64::EPSILON * size));
            }
        }
    }
    worst
}

fn all(change: impl Fn(usize, usize, &mut [f64]) + Copy) -> [f64; 5] {
    [
        worst::<OfFourBar>(100, change),
        worst::<OfEngine>(100, change),
        worst::<OfArm>(100, change),
        worst::<OfSpatial>(100, change),
        worst::<OfTriad>(50, change),
    ]
}

#[test]
fn in_motion() {
    assert!(all(|_, _, _| {}).into_iter().all(|worst| worst < BOUND));
}

/// A start from rest, at any acceleration and jerk.
#[test]
fn at_the_start_from_rest() {
    assert!(
        all(|_, _, motion| motion[1] = 0.0)
            .into_iter()
            .all(|worst| worst < BOUND)
    );
}

/// All inputs dwell, or each of several in turn.
#[test]
fn in_dwells() {
    let dwell = |motion: &mut [f64]| motion[1..].fill(0.0);
    assert!(all(|_, _, motion| dwell(motion)).into_iter().all(|worst| worst < BOUND));
    let in_turn = |pose: usize, input: usize, motion: &mut [f64]| {
        if pose % 2 == input {
            dwell(motion);
        }
    };
    assert!(worst::<OfArm>(100, in_turn) < BOUND);
    assert!(worst::<OfTriad>(50, in_turn) < BOUND);
}
