//! The result: efforts, powers, energies, and what the ground feels.

use core::fmt;

use crate::geometry::Space;
use crate::load::coordinate::entries;
use crate::load::totals::Totals;
use crate::mechanism::Mechanism;
use crate::motion::{Contains, leibniz};
use crate::number::{Number, Row};

/// A quantity of dynamics with its derivatives by time.
///
/// It has at least two derivatives fewer than the motions of its mechanism, because forces follow from accelerations: a
/// mechanism through snap gives the value, the rate and the second rate. One that is declared to a higher order gives
/// more by [`derivative`](Rates::derivative).
#[derive(Clone, Copy)]
pub struct Rates<M: Mechanism, V: Copy> {
    row: M::Motion<V>,
    known: usize,
}

impl<M: Mechanism, V: Copy> Rates<M, V> {
    fn new(row: M::Motion<V>, known: usize) -> Self {
        Self { row, known }
    }

    /// The value, and its derivatives in ascending order.
    #[must_use]
    pub fn as_slice(&self) -> &[V] {
        &self.row.as_ref()[..self.known]
    }

    /// The derivative of the given order, if it is known.
    #[must_use]
    pub fn derivative(&self, order: usize) -> Option<V> {
        self.as_slice().get(order).copied()
    }

    /// The value.
    #[must_use]
    pub fn value(&self) -> V
    where
        M::Motion<V>: Contains<2>,
    {
        self.row[0]
    }

    /// The first derivative by time.
    #[must_use]
    pub fn rate(&self) -> V
    where
        M::Motion<V>: Contains<3>,
    {
        self.row[1]
    }

    /// The second derivative by time.
    #[must_use]
    pub fn second_rate(&self) -> V
    where
        M::Motion<V>: Contains<4>,
    {
        self.row[2]
    }
}

impl<M: Mechanism, V: Copy + fmt::Debug> fmt::Debug for Rates<M, V> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.as_slice().fmt(formatter)
    }
}

/// The balance of loads and drives in one pose, as [`Loaded::balance`](crate::load::Loaded::balance) returns it.
///
/// Units follow from those of the loads: with metres, kilograms and seconds, efforts are newtons at inputs that are
/// lengths and newton metres at inputs that are angles, energies are joules, powers watts.
#[derive(Clone, Copy)]
pub struct Balance<M: Mechanism> {
    inputs: M::Inputs<M::Motion<M::Scalar>>,
    effort: M::Inputs<M::Motion<M::Scalar>>,
    inertia: M::Inputs<M::Inputs<M::Motion<M::Scalar>>>,
    kinetic: M::Motion<M::Scalar>,
    potential: M::Motion<M::Scalar>,
    applied: M::Motion<M::Scalar>,
    damped: M::Motion<M::Scalar>,
    shaking_force: [M::Motion<M::Scalar>; 3],
    shaking_moment: [M::Motion<M::Scalar>; 3],
}

impl<M: Mechanism> Balance<M> {
    pub(super) fn new(inputs: M::Inputs<M::Motion<M::Scalar>>, totals: &Totals<M>) -> Self {
        Self {
            inputs,
            effort: totals.effort,
            inertia: totals.inertia,
            kinetic: totals.kinetic,
            potential: totals.potential,
            applied: totals.applied,
            damped: totals.damped,
            shaking_force: totals.shaking_force,
            shaking_moment: totals.shaking_moment,
        }
    }

    /// The effort of the drive of each input, with its rates: the torque on an input that is an angle, the force on one
    /// that is a length. It is positive where it drives the input in its positive direction.
    #[must_use]
    pub fn efforts(&self) -> M::Inputs<Rates<M, M::Scalar>> {
        M::Inputs::from_fn(|input| Rates::new(self.effort[input], Totals::<M>::effort_entries()))
    }

    /// The power of the drive of each input: its effort times its velocity.
    #[must_use]
    pub fn powers(&self) -> M::Inputs<Rates<M, M::Scalar>> {
        let known = Totals::<M>::effort_entries();
        M::Inputs::from_fn(|input| {
            let (effort, motion): (M::Motion<M::Scalar>, M::Motion<M::Scalar>) =
                (self.effort[input], self.inputs[input]);
            let power = |order: usize| leibniz(&effort.as_ref()[..=order], &motion.as_ref()[1..=order + 1]);
            Rates::new(
                M::Motion::from_fn(|order| {
                    if order < known {
                        power(order)
                    } else {
                        M::Scalar::constant(0.0)
                    }
                }),
                known,
            )
        })
    }

    /// The matrix of equivalent inertias: the kinetic energy is half the sum of its entries times the velocities of
    /// both inputs. For one input, it is the inertia that this input feels. Rates are those along the motion; for the
    /// derivatives by the inputs, see [`Loaded::equivalent_inertia`](crate::load::Loaded::equivalent_inertia).
    #[must_use]
    pub fn inertias(&self) -> M::Inputs<M::Inputs<Rates<M, M::Scalar>>> {
        M::Inputs::from_fn(|row| {
            let entries_of_row: M::Inputs<M::Motion<M::Scalar>> = self.inertia[row];
            M::Inputs::from_fn(|column| Rates::new(entries_of_row[column], entries::<M>()))
        })
    }

    /// The kinetic energy.
    #[must_use]
    pub fn kinetic_energy(&self) -> Rates<M, M::Scalar> {
        Rates::new(self.kinetic, Totals::<M>::power_entries())
    }

    /// The potential energy of gravity and springs. That of gravity is zero at the origin.
    #[must_use]
    pub fn potential_energy(&self) -> Rates<M, M::Scalar> {
        Rates::new(self.potential, entries::<M>())
    }

    /// The power that the forces and torques among the loads put into the mechanism.
    #[must_use]
    pub fn applied_power(&self) -> Rates<M, M::Scalar> {
        Rates::new(self.applied, Totals::<M>::effort_entries())
    }

    /// The power that the dampers take.
    #[must_use]
    pub fn damped_power(&self) -> Rates<M, M::Scalar> {
        Rates::new(self.damped, Totals::<M>::effort_entries())
    }

    /// The shaking force: the sum of the inertia forces -m a of the moving masses, which the mechanism exerts on its
    /// ground. Weights and other loads are not in it.
    #[must_use]
    pub fn shaking_force(&self) -> Rates<M, Space<M::Scalar>> {
        Self::vector(&self.shaking_force)
    }

    /// The shaking moment about the origin: the sum of -r × m a and of the inertia moments of the links. In the plane
    /// it is about z. About another point c it is greater by -c × the shaking force.
    #[must_use]
    pub fn shaking_moment(&self) -> Rates<M, Space<M::Scalar>> {
        Self::vector(&self.shaking_moment)
    }

    fn vector([x, y, z]: &[M::Motion<M::Scalar>; 3]) -> Rates<M, Space<M::Scalar>> {
        Rates::new(
            M::Motion::from_fn(|order| Space::new(x[order], y[order], z[order])),
            Totals::<M>::effort_entries(),
        )
    }
}

impl<M: Mechanism> fmt::Debug for Balance<M> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Balance")
            .field("efforts", &self.efforts().as_ref())
            .field("powers", &self.powers().as_ref())
            .field("kinetic_energy", &self.kinetic_energy())
            .field("potential_energy", &self.potential_energy())
            .field("applied_power", &self.applied_power())
            .field("damped_power", &self.damped_power())
            .field("shaking_force", &self.shaking_force())
            .field("shaking_moment", &self.shaking_moment())
            .finish_non_exhaustive()
    }
}
