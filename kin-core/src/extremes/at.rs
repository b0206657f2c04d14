//! A pose of a sweep with derivatives in the variable of the sweep.

use core::ops::Deref;

use super::curve::composed;
use crate::load::{Balance, Load, LoadError, Loads};
use crate::mechanism::{BlockForm, Mechanism, Pose, PoseOf};
use crate::motion::Motion;
use crate::number::{Number, Row};
use crate::picture::TransmissionAngle;
use crate::quantity::RATES;
use crate::sweep::{Instant, Local, READ, by_time};

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
    /// What derivatives above the order of the mechanism are found from.
    pub(super) source: Option<Source<M>>,
}

/// A place of a sweep, as far as derivatives above the order of the mechanism need it.
#[derive(Clone, Copy)]
pub(super) struct Source<M: Mechanism> {
    /// The mechanism over long series.
    pub(super) mechanism: M::With<Instant>,
    /// The inputs, with their derivatives with respect to the variable.
    pub(super) inputs: M::Inputs<Motion<f64, READ>>,
    pub(super) unknowns: M::Unknowns<f64>,
    /// The change of the variable for each unit of time.
    pub(super) rate: f64,
    /// The variable as a series in the parameter.
    pub(super) variable: Local,
}

impl<M: Mechanism> Source<M> {
    /// The position solved in long series.
    fn pose(&self) -> Option<<M::With<Instant> as Mechanism>::Pose> {
        let inputs = Row::from_fn(|input| {
            let value = Instant::from_derivatives(self.inputs[input].derivatives());
            // the rates of the pose are not read
            Row::from_fn(|order| if order == 0 { value } else { Instant::constant(0.0) })
        });
        let near = Row::from_fn(|unknown| Instant::constant(self.unknowns[unknown]));
        self.mechanism.solve_motion_near(inputs, near).ok()
    }

    /// A derivative with respect to time, in the parameter of the sweep.
    fn by_time(&self, series: Instant, order: usize) -> Local {
        composed(
            by_time(&Motion::new(series.derivatives()), order, self.rate),
            self.variable,
        )
    }
}

/// The highest order of a derivative.
pub(super) const HIGHEST: usize = RATES.len();

impl<M: Mechanism> Deref for At<M> {
    type Target = <M::With<Local> as Mechanism>::Pose;

    fn deref(&self) -> &Self::Target {
        &self.pose
    }
}

impl<M: Mechanism> At<M> {
    /// The derivative of an input, by its index and its order, up to the twelfth.
    #[must_use]
    pub fn input(&self, index: usize, order: usize) -> Option<Local> {
        let motion = self.inputs.as_ref().get(index)?;
        if let Some(value) = motion.as_ref().get(order) {
            return Some(*value);
        }
        let source = self.source.as_ref()?;
        let derivatives = source.inputs.as_ref().get(index)?;
        (order <= HIGHEST).then(|| composed(by_time(derivatives, order, source.rate), source.variable))
    }

    /// The derivative of an unknown, by its index and its order, up to the twelfth. Those above the order of the mechanism come from its
    /// position, solved in longer series.
    #[must_use]
    pub fn unknown(&self, index: usize, order: usize) -> Option<Local> {
        if order > M::DESCRIPTION.order && order <= HIGHEST {
            let source = self.source.as_ref()?;
            let pose = source.pose()?;
            let near = Row::from_fn(|unknown| Instant::constant(source.unknowns[unknown]));
            let motions = pose.unknown_motions_near(near);
            let motion = motions.as_ref().get(index)?;
            return Some(source.by_time(motion[0], order));
        }
        let motions = self
            .pose
            .unknown_motions_near(Row::from_fn(|unknown| self.near[unknown]));
        let motion = motions.as_ref().get(index)?;
        motion.as_ref().get(order).copied()
    }

    /// The derivative of a scalar output, by its index and its order, up to the twelfth.
    #[must_use]
    pub fn output(&self, index: usize, order: usize) -> Option<Local> {
        if order > M::DESCRIPTION.order && order <= HIGHEST {
            let source = self.source.as_ref()?;
            let motions = source.pose()?.output_motions();
            let motion = motions.as_ref().get(index)?;
            return Some(source.by_time(motion[0], order));
        }
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

    /// The margin of a dyad, by its index in the order in which the dyads are solved: by how much its links could be longer or shorter
    /// until it ceases to close. It is the number of [`Failure::OutOfReach`](crate::Failure::OutOfReach), positive where the dyad closes, and
    /// zero at a turning point.
    ///
    /// For two links a and b whose ends are d apart it is min(a + b - d, d - |a - b|), for a link and a slider the link less the distance of
    /// its end from the slider's line. `None` if a length changes with the position, as that of a cylinder does.
    #[must_use]
    pub fn margin(&self, dyad: usize) -> Option<Local> {
        let transmission = self.transmission_angle(dyad)?;
        let (_, cosine) = transmission.angle.sin_cos();
        let forms = self.mechanism.block_forms();
        // a slider along an axis is a block of its own behind that of its link
        let mut own = M::DESCRIPTION.blocks.iter().zip(forms.as_ref()).filter(|(block, _)| {
            let mut unknowns = transmission.block.split(", ");
            transmission.block == block.unknowns || unknowns.any(|unknown| unknown == block.unknowns)
        });
        own.find_map(|(_, form)| margin_of(form, cosine))
    }

    /// The smallest margin of all dyads, or `None` if there is a dyad whose margin is not known, or none at all.
    #[must_use]
    pub fn smallest_margin(&self) -> Option<Local> {
        let count = <<M::With<Local> as Mechanism>::Dyads<Local> as Row<Local>>::LENGTH;
        let mut least = self.margin(0)?;
        for dyad in 1..count {
            let margin = self.margin(dyad)?;
            if margin.real() < least.real() {
                least = margin;
            }
        }
        Some(least)
    }

    /// The unknowns as series.
    fn near_series(&self) -> <M::With<Local> as Mechanism>::Unknowns<Local> {
        Row::from_fn(|unknown| self.unknown(unknown, 0).unwrap_or(Local::constant(f64::NAN)))
    }
}

/// The margin of a dyad with the cosine of its transmission angle.
fn margin_of(form: &BlockForm<Local>, cosine: Local) -> Option<Local> {
    let size = |value: Local| if value.real() < 0.0 { -value } else { value };
    match *form {
        BlockForm::FourBar {
            coupler: a, rocker: b, ..
        }
        | BlockForm::TwoLinks {
            lengths: [Some(a), Some(b)],
        } => {
            // the law of cosines
            let distance = (a * a + b * b - Local::constant(2.0) * a * b * cosine).sqrt();
            let [far, near] = [a + b - distance, distance - size(a - b)];
            Some(if near.real() < far.real() { near } else { far })
        }
        BlockForm::SliderCrank { coupler: link, .. } | BlockForm::LinkAndSlider { length: Some(link) } => {
            Some(link - size(link * cosine))
        }
        _ => None,
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
