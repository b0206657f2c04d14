//! A pose of a sweep with derivatives in the variable of the sweep.

use core::ops::Deref;

use crate::load::{Balance, Load, LoadError, Loads};
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

    /// The balance of loads and drives, with its change along the sweep. The loads are those of the mechanism over `Local`.
    ///
    /// # Errors
    /// As for [`Loads::at`].
    pub fn balance<L: Load<M::With<Local>>>(
        &self,
        loads: &Loads<M::With<Local>, L>,
    ) -> Result<Balance<M::With<Local>>, LoadError> {
        loads.near(&self.mechanism, self.inputs, self.near_series())
    }

    /// The effort of the drive of an input, by its index: a torque or a force.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::extremes::Over;
    /// use kin_core::load::Loads;
    /// use kin_core::prelude::*;
    /// use kin_core::sweep::Local;
    ///
    /// mechanism! {
    ///     /// Four-bar linkage in metres.
    ///     struct Press { r1: Length, r2: Length, r3: Length, r4: Length }
    ///     input theta2: Angle;
    ///     unknown theta3: Angle, theta4: Angle;
    ///     r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    ///     output coupler: Point = r2 * cis(theta2) + r3 / 2 * cis(theta3);
    /// }
    ///
    /// let press = Press { r1: 0.4, r2: 0.12, r3: 0.36, r4: 0.28 };
    /// let loads = Loads::<Press<Local>>::new()
    ///     .gravity(Plane::new(0.0, -9.81))
    ///     .mass(1.4, |pose| pose.coupler)
    ///     .inertia(0.03, |pose| pose.theta4);
    /// let turn = press.sweep(Assembly::Open).over(0.0..=TAU, 100).speed(rpm(120.0));
    /// let peak = turn.peak_by(|at| at.effort(&loads, 0))?;
    /// let rms = turn.rms_by(|at| at.effort(&loads, 0), Over::Time)?;
    /// println!("{} N m at {}°, in the mean {} N m", peak.value, peak.at.to_degrees(), rms.value);
    /// assert!(rms.value < peak.value.abs());
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Loads::at`], and [`LoadError::NoEffort`] if there is no such input, or if the mechanism is declared to a lower order than 2.
    pub fn effort<L: Load<M::With<Local>>>(
        &self,
        loads: &Loads<M::With<Local>, L>,
        input: usize,
    ) -> Result<Local, LoadError> {
        let efforts = self.balance(loads)?.efforts();
        let effort = efforts.as_ref().get(input).and_then(|effort| effort.derivative(0));
        effort.ok_or(LoadError::NoEffort { input })
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
