//! A pose of a sweep with derivatives in the variable of the sweep.

use core::ops::Deref;

use crate::mechanism::{Mechanism, Pose, PoseOf};
use crate::number::{Number, Row};
use crate::picture::TransmissionAngle;
use crate::sweep::Local;

/// The pose at one place of a sweep, in numbers that carry their derivatives with respect to the variable of the sweep. Any expression of
/// them carries its own.
///
/// It has the fields of the pose: `at.theta4.jerk()`. Constants are `Local::constant(2.0)`.
///
/// ```
/// use std::f64::consts::TAU;
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
/// let turn = linkage.sweep(Assembly::Open).over(0.0..=TAU, 100).speed(10.0);
/// // power per unit of inertia, whose peak is neither that of the velocity nor that of the acceleration
/// let power = turn.peak_by(|at| at.theta4.velocity() * at.theta4.acceleration())?;
/// println!("{} at {} rad", power.value, power.at);
/// # Ok::<(), kin_core::extremes::ExtremesError>(())
/// ```
#[derive(Clone, Copy)]
pub struct At<M: Mechanism> {
    pub(super) mechanism: M::With<Local>,
    pub(super) pose: <M::With<Local> as Mechanism>::Pose,
    pub(super) inputs: <M::With<Local> as Mechanism>::Inputs<<M::With<Local> as Mechanism>::Motion<Local>>,
    /// The unknowns, with angles on the turns they have reached.
    pub(super) near: <M::With<Local> as Mechanism>::Unknowns<Local>,
}

impl<M: Mechanism> Deref for At<M> {
    type Target = <M::With<Local> as Mechanism>::Pose;

    fn deref(&self) -> &Self::Target {
        &self.pose
    }
}

impl<M: Mechanism> At<M> {
    /// The derivative of an input, by its index and its order.
    #[must_use]
    pub fn input(&self, index: usize, order: usize) -> Option<Local> {
        let motion = self.inputs.as_ref().get(index)?;
        motion.as_ref().get(order).copied()
    }

    /// The derivative of an unknown, by its index and its order.
    #[must_use]
    pub fn unknown(&self, index: usize, order: usize) -> Option<Local> {
        let motions = self
            .pose
            .unknown_motions_near(Row::from_fn(|unknown| self.near[unknown]));
        let motion = motions.as_ref().get(index)?;
        motion.as_ref().get(order).copied()
    }

    /// The derivative of a scalar output, by its index and its order.
    #[must_use]
    pub fn output(&self, index: usize, order: usize) -> Option<Local> {
        let motions = self.pose.output_motions();
        let motion = motions.as_ref().get(index)?;
        motion.as_ref().get(order).copied()
    }

    /// The transmission angle of a dyad, by its index in the order in which the dyads are solved.
    #[must_use]
    pub fn transmission_angle(&self, dyad: usize) -> Option<TransmissionAngle<Local>> {
        let values = Values::<M::With<Local>> {
            inputs: Row::from_fn(|input| self.inputs[input][0]),
            unknowns: self.near_series(),
        };
        let angles = self.mechanism.transmission_angles(&values);
        angles.as_ref().get(dyad).copied()
    }

    /// The unknowns as series.
    fn near_series(&self) -> <M::With<Local> as Mechanism>::Unknowns<Local> {
        Row::from_fn(|unknown| self.unknown(unknown, 0).unwrap_or(Local::constant(f64::NAN)))
    }
}

/// The inputs and unknowns of a pose, without the pose.
#[derive(Clone, Copy)]
struct Values<M: Mechanism> {
    inputs: M::Inputs<M::Scalar>,
    unknowns: M::Unknowns<M::Scalar>,
}

impl<M: Mechanism> core::fmt::Debug for Values<M> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let (inputs, unknowns) = (self.inputs.as_ref(), self.unknowns.as_ref());
        formatter.debug_list().entries(inputs).entries(unknowns).finish()
    }
}

impl<M: Mechanism> PoseOf<M> for Values<M> {
    fn values(&self) -> (M::Inputs<M::Scalar>, M::Unknowns<M::Scalar>) {
        (self.inputs, self.unknowns)
    }
}
