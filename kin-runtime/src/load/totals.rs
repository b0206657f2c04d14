//! The sums over all loads.

use crate::failure::SolveError;
use crate::geometry::Space;
use crate::load::coordinate::{Coordinate, entries};
use crate::load::{Change, LoadedSystem, Moving};
use crate::mechanism::Mechanism;
use crate::motion::leibniz;
use crate::number::{Number, Row};

/// The sums over all loads, to which each load adds its own part.
///
/// With a coordinate s of the weight w, and its influence coefficient g of an input, the virtual work of inertia gives
/// the input the effort w s'' g. Each rate of the effort follows by Leibniz's rule from the derivatives of s and g.
pub struct Totals<M: LoadedSystem> {
    /// The pose, with the change along one input each.
    pub(super) poses: M::Inputs<M::Moving>,
    pub(super) gravity: Space<f64>,
    /// The place of the load that is being added, from 1 on.
    pub(super) load: usize,
    pub(super) effort: M::Inputs<M::Motion<M::Scalar>>,
    pub(super) inertia: M::Inputs<M::Inputs<M::Motion<M::Scalar>>>,
    pub(super) kinetic: M::Motion<M::Scalar>,
    pub(super) potential: M::Motion<M::Scalar>,
    pub(super) applied: M::Motion<M::Scalar>,
    pub(super) damped: M::Motion<M::Scalar>,
    pub(super) shaking_force: [M::Motion<M::Scalar>; 3],
    pub(super) shaking_moment: [M::Motion<M::Scalar>; 3],
}

impl<M: LoadedSystem> Totals<M> {
    pub(super) fn new(poses: M::Inputs<M::Moving>, gravity: Space<f64>) -> Self {
        let zero = M::Motion::splat(M::Scalar::constant(0.0));
        let zeros = M::Inputs::splat(zero);
        Self {
            poses,
            gravity,
            load: 0,
            effort: zeros,
            inertia: M::Inputs::splat(zeros),
            kinetic: zero,
            potential: zero,
            applied: zero,
            damped: zero,
            shaking_force: [zero; 3],
            shaking_moment: [zero; 3],
        }
    }

    /// The number of entries of an effort: it has two derivatives fewer than a motion.
    pub(super) fn effort_entries() -> usize {
        entries::<M>().saturating_sub(2)
    }

    /// The number of entries of a power or of the kinetic energy: it has one derivative fewer than a motion.
    pub(super) fn power_entries() -> usize {
        entries::<M>().saturating_sub(1)
    }

    /// The kinetic energy w a' b' / 2 of two coordinates, which may be the same.
    pub(super) fn inertia(&mut self, weight: f64, a: &Coordinate<M>, b: &Coordinate<M>) {
        let half = M::Scalar::constant(0.5 * weight);
        let inputs = <M::Inputs<f64> as Row<f64>>::LENGTH;
        for input in 0..inputs {
            let (by_a, by_b) = (a.influence[input].as_ref(), b.influence[input].as_ref());
            for order in 0..Self::effort_entries() {
                let one = leibniz(&a.motion.as_ref()[2..=order + 2], &by_b[..=order]);
                let two = leibniz(&b.motion.as_ref()[2..=order + 2], &by_a[..=order]);
                add(&mut self.effort[input][order], half * (one + two));
            }
            for other in 0..inputs {
                for order in 0..entries::<M>() {
                    let one = leibniz(&by_a[..=order], &b.influence[other].as_ref()[..=order]);
                    let two = leibniz(&by_b[..=order], &a.influence[other].as_ref()[..=order]);
                    add(&mut self.inertia[input][other][order], half * (one + two));
                }
            }
        }
        for order in 0..Self::power_entries() {
            let square = leibniz(&a.motion.as_ref()[1..=order + 1], &b.motion.as_ref()[1..=order + 1]);
            add(&mut self.kinetic[order], half * square);
        }
    }

    /// The inertia force of a moving mass on the ground, and its moment about the origin.
    pub(super) fn shaking(&mut self, mass: f64, point: &[Coordinate<M>; 3]) {
        for (force, coordinate) in self.shaking_force.iter_mut().zip(point) {
            for order in 0..Self::effort_entries() {
                force[order] = force[order] - M::Scalar::constant(mass) * coordinate.motion[order + 2];
            }
        }
        self.spin(mass, point, point);
    }

    /// The moment -w a × b'' on the ground.
    pub(super) fn spin(&mut self, weight: f64, a: &[Coordinate<M>; 3], b: &[Coordinate<M>; 3]) {
        for axis in 0..3 {
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            for order in 0..Self::effort_entries() {
                let moment = |arm: usize, along: usize| {
                    leibniz(
                        &a[arm].motion.as_ref()[..=order],
                        &b[along].motion.as_ref()[2..=order + 2],
                    )
                };
                let both = moment(last, next) - moment(next, last);
                add(
                    &mut self.shaking_moment[axis][order],
                    M::Scalar::constant(weight) * both,
                );
            }
        }
    }

    /// A load with the given potential energy.
    pub(super) fn potential(&mut self, energy: &Coordinate<M>) {
        for order in 0..entries::<M>() {
            add(&mut self.potential[order], energy.motion[order]);
        }
        for input in 0..<M::Inputs<f64> as Row<f64>>::LENGTH {
            for order in 0..Self::effort_entries() {
                add(&mut self.effort[input][order], energy.influence[input][order]);
            }
        }
    }

    /// A force along a coordinate, positive in its direction.
    pub(super) fn force(&mut self, force: impl Fn(usize) -> M::Scalar, along: &Coordinate<M>) {
        let force = M::Motion::from_fn(|order| {
            if order < Self::effort_entries() {
                force(order)
            } else {
                M::Scalar::constant(0.0)
            }
        });
        for order in 0..Self::effort_entries() {
            for input in 0..<M::Inputs<f64> as Row<f64>>::LENGTH {
                let work = leibniz(&force.as_ref()[..=order], &along.influence[input].as_ref()[..=order]);
                add(&mut self.effort[input][order], -work);
            }
            let power = leibniz(&force.as_ref()[..=order], &along.motion.as_ref()[1..=order + 1]);
            add(&mut self.applied[order], power);
        }
    }

    /// A damper, whose force is proportional to the rate of a coordinate.
    pub(super) fn damper(&mut self, damping: f64, along: &Coordinate<M>) {
        let damping = M::Scalar::constant(damping);
        let rates = |order: usize| &along.motion.as_ref()[1..=order + 1];
        for order in 0..Self::effort_entries() {
            for input in 0..<M::Inputs<f64> as Row<f64>>::LENGTH {
                let work = leibniz(rates(order), &along.influence[input].as_ref()[..=order]);
                add(&mut self.effort[input][order], damping * work);
            }
            add(&mut self.damped[order], damping * leibniz(rates(order), rates(order)));
        }
    }

    /// Whether all sums are finite.
    pub(super) fn are_finite(&self) -> bool {
        let finite = |motion: &M::Motion<M::Scalar>| motion.as_ref().iter().all(|entry| entry.is_finite());
        let sums = [self.kinetic, self.potential, self.applied, self.damped];
        self.effort.as_ref().iter().all(finite)
            && self.inertia.as_ref().iter().all(|row| row.as_ref().iter().all(finite))
            && sums
                .iter()
                .chain(&self.shaking_force)
                .chain(&self.shaking_moment)
                .all(finite)
    }
}

fn add<T: Number>(sum: &mut T, term: T) {
    *sum = *sum + term;
}

/// The poses of a mechanism in motion: one for each input, with the change along that input. `solve` finds one of them.
pub(super) fn poses<M: Mechanism>(
    mechanism: &M,
    inputs: M::Inputs<M::Motion<M::Scalar>>,
    solve: impl Fn(&ChangingMechanism<M>, ChangingInputs<M>) -> Result<Moving<M>, SolveError>,
) -> Result<M::Inputs<Moving<M>>, SolveError> {
    let zero = M::Scalar::constant(0.0);
    let parameters = mechanism.parameters();
    let changing = ChangingMechanism::<M>::from_parameters(Row::from_fn(|place| Change::new(parameters[place], zero)));
    let solve = |direction: usize| {
        let moved = Row::from_fn(|input| {
            let motion: M::Motion<M::Scalar> = inputs[input];
            Row::from_fn(|order| {
                let change = if order == 0 && input == direction { 1.0 } else { 0.0 };
                Change::new(motion[order], M::Scalar::constant(change))
            })
        });
        solve(&changing, moved)
    };
    let first = solve(0)?;
    let mut poses = M::Inputs::splat(first);
    for (input, pose) in poses.as_mut().iter_mut().enumerate().skip(1) {
        *pose = solve(input)?;
    }
    Ok(poses)
}

/// A mechanism over numbers with their change.
pub(super) type ChangingMechanism<M> = <M as Mechanism>::With<Change<<M as Mechanism>::Scalar>>;

/// The motions of its inputs.
pub(super) type ChangingInputs<M> =
    <ChangingMechanism<M> as Mechanism>::Inputs<<M as Mechanism>::Motion<Change<<M as Mechanism>::Scalar>>>;
