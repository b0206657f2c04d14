//! The sums over all loads.

use crate::geometry::Space;
use crate::load::coordinate::{Coordinate, entries};
use crate::load::{Change, Moving};
use crate::mechanism::Mechanism;
use crate::motion::leibniz;
use crate::number::Row;

/// The sums over all loads, to which each load adds its own part.
///
/// With a coordinate s of the weight w, and its influence coefficient g of an input, the virtual work of inertia gives the input the
/// effort w s'' g. Each rate of the effort follows by Leibniz's rule from the derivatives of s and g.
pub struct Totals<M: Mechanism> {
    /// The pose, with the change along one input each.
    pub(super) poses: M::Inputs<Moving<M>>,
    pub(super) gravity: Space<f64>,
    /// The place of the load that is being added, from 1 on.
    pub(super) load: usize,
    pub(super) effort: M::Inputs<M::Motion<f64>>,
    pub(super) inertia: M::Inputs<M::Inputs<M::Motion<f64>>>,
    pub(super) kinetic: M::Motion<f64>,
    pub(super) potential: M::Motion<f64>,
    pub(super) applied: M::Motion<f64>,
    pub(super) damped: M::Motion<f64>,
    pub(super) shaking_force: [M::Motion<f64>; 3],
    pub(super) shaking_moment: [M::Motion<f64>; 3],
}

impl<M: Mechanism> Totals<M> {
    pub(super) fn new(poses: M::Inputs<Moving<M>>, gravity: Space<f64>) -> Self {
        let zero = M::Motion::from_fn(|_| 0.0);
        let zeros = M::Inputs::from_fn(|_| zero);
        Self {
            poses,
            gravity,
            load: 0,
            effort: zeros,
            inertia: M::Inputs::from_fn(|_| zeros),
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
        let half = 0.5 * weight;
        let inputs = <M::Inputs<f64> as Row<f64>>::LENGTH;
        for input in 0..inputs {
            let (by_a, by_b) = (a.influence[input].as_ref(), b.influence[input].as_ref());
            for order in 0..Self::effort_entries() {
                let one = leibniz(&a.motion.as_ref()[2..=order + 2], &by_b[..=order]);
                let two = leibniz(&b.motion.as_ref()[2..=order + 2], &by_a[..=order]);
                self.effort[input][order] += half * (one + two);
            }
            for other in 0..inputs {
                for order in 0..entries::<M>() {
                    let one = leibniz(&by_a[..=order], &b.influence[other].as_ref()[..=order]);
                    let two = leibniz(&by_b[..=order], &a.influence[other].as_ref()[..=order]);
                    self.inertia[input][other][order] += half * (one + two);
                }
            }
        }
        for order in 0..Self::power_entries() {
            self.kinetic[order] += half * leibniz(&a.motion.as_ref()[1..=order + 1], &b.motion.as_ref()[1..=order + 1]);
        }
    }

    /// The inertia force of a moving mass on the ground, and its moment about the origin.
    pub(super) fn shaking(&mut self, mass: f64, point: &[Coordinate<M>; 3]) {
        for (force, coordinate) in self.shaking_force.iter_mut().zip(point) {
            for order in 0..Self::effort_entries() {
                force[order] -= mass * coordinate.motion[order + 2];
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
                self.shaking_moment[axis][order] -= weight * (moment(next, last) - moment(last, next));
            }
        }
    }

    /// A load with the given potential energy.
    pub(super) fn potential(&mut self, energy: &Coordinate<M>) {
        for order in 0..entries::<M>() {
            self.potential[order] += energy.motion[order];
        }
        for input in 0..<M::Inputs<f64> as Row<f64>>::LENGTH {
            for order in 0..Self::effort_entries() {
                self.effort[input][order] += energy.influence[input][order];
            }
        }
    }

    /// A force along a coordinate, positive in its direction.
    pub(super) fn force(&mut self, force: impl Fn(usize) -> f64, along: &Coordinate<M>) {
        let force = M::Motion::from_fn(|order| {
            if order < Self::effort_entries() {
                force(order)
            } else {
                0.0
            }
        });
        for order in 0..Self::effort_entries() {
            for input in 0..<M::Inputs<f64> as Row<f64>>::LENGTH {
                self.effort[input][order] -=
                    leibniz(&force.as_ref()[..=order], &along.influence[input].as_ref()[..=order]);
            }
            self.applied[order] += leibniz(&force.as_ref()[..=order], &along.motion.as_ref()[1..=order + 1]);
        }
    }

    /// A damper, whose force is proportional to the rate of a coordinate.
    pub(super) fn damper(&mut self, damping: f64, along: &Coordinate<M>) {
        let rates = |order: usize| &along.motion.as_ref()[1..=order + 1];
        for order in 0..Self::effort_entries() {
            for input in 0..<M::Inputs<f64> as Row<f64>>::LENGTH {
                self.effort[input][order] +=
                    damping * leibniz(rates(order), &along.influence[input].as_ref()[..=order]);
            }
            self.damped[order] += damping * leibniz(rates(order), rates(order));
        }
    }

    /// Whether all sums are finite.
    pub(super) fn are_finite(&self) -> bool {
        let finite = |motion: &M::Motion<f64>| motion.as_ref().iter().all(|entry| entry.is_finite());
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

/// The poses of a mechanism in motion: one for each input, with the change along that input.
pub(super) fn poses<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    inputs: M::Inputs<M::Motion<f64>>,
    assembly: M::Assembly,
) -> Result<M::Inputs<Moving<M>>, crate::failure::SolveError> {
    let changing = mechanism.convert(|value| Change::from_coefficients([value, 0.0]));
    let solve = |direction: usize| {
        let moved =
            <<M::With<Change> as Mechanism>::Inputs<M::Motion<Change>> as Row<M::Motion<Change>>>::from_fn(|input| {
                let motion: M::Motion<f64> = inputs[input];
                Row::from_fn(|order| {
                    let change = if order == 0 && input == direction { 1.0 } else { 0.0 };
                    Change::from_coefficients([motion[order], change])
                })
            });
        changing.solve_motion(moved, assembly)
    };
    let first = solve(0)?;
    let mut poses = M::Inputs::from_fn(|_| first);
    for (input, pose) in poses.as_mut().iter_mut().enumerate().skip(1) {
        *pose = solve(input)?;
    }
    Ok(poses)
}
