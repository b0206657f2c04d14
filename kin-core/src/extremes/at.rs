//! A pose of a sweep with derivatives in the variable of the sweep.

use core::f64::consts::{FRAC_PI_2, PI};
use core::ops::Deref;

use crate::load::{Balance, LoadError, Loaded, LoadsOf};
use crate::mechanism::{Block, BlockForm, Mechanism, Pose, PoseOf};
use crate::motion::Motion;
use crate::number::{Number, Row};
use crate::picture::TransmissionAngle;
use crate::quantity::{Dimension, RATES};
use crate::solve::nearest_turn;
use crate::sweep::{Instant, Local, OutputsOf, READ, by_time, composed};

/// The pose at one place of a sweep, in numbers that carry their derivatives with respect to the variable of the sweep. Any expression of
/// them carries its own.
///
/// It has the fields of the pose: `at.theta4.jerk()`. Plain numbers are constants among them: `2.0 * at.theta4.jerk()`.
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
    /// The outputs, with unwrapped angles.
    pub(super) outputs: OutputsOf<M, f64>,
    /// What derivatives above the order of the mechanism are found from.
    pub(super) source: Option<SweepPlace<M>>,
}

/// A place of a sweep, as far as derivatives above the order of the mechanism need it.
#[derive(Clone, Copy)]
pub(super) struct SweepPlace<M: Mechanism> {
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

impl<M: Mechanism> SweepPlace<M> {
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
        let value = *motions.as_ref().get(index)?.as_ref().get(order)?;
        let is_angle = M::DESCRIPTION.unknowns[index].dimension == Dimension::Angle;
        Some(if is_angle && order == 0 {
            nearest_turn(value, self.near[index])
        } else {
            value
        })
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
        let value = *motions.as_ref().get(index)?.as_ref().get(order)?;
        let is_angle = M::DESCRIPTION.outputs[index].dimension == Dimension::Angle;
        Some(if is_angle && order == 0 {
            nearest_turn(value, Local::constant(self.outputs[index]))
        } else {
            value
        })
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
    /// As for [`balance`](Loaded::balance).
    pub fn balance<L: LoadsOf<M::With<Local>>>(&self, loads: &L) -> Result<Balance<M::With<Local>>, LoadError> {
        self.mechanism.balance_near(loads, self.inputs, self.near_series())
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
    /// As for [`balance`](Loaded::balance), and [`LoadError::NoEffort`] if there is no such input, or if the mechanism is declared to a lower order than 2.
    pub fn effort<L: LoadsOf<M::With<Local>>>(&self, loads: &L, input: usize) -> Result<Local, LoadError> {
        let efforts = self.balance(loads)?.efforts();
        let effort = efforts.as_ref().get(input).and_then(|effort| effort.derivative(0));
        effort.ok_or(LoadError::NoEffort { input })
    }

    /// The margin of a dyad, by its index in the order in which the dyads are solved: by how much its links could be longer or shorter
    /// until it ceases to close. It is the number of [`Failure::OutOfReach`](crate::Failure::OutOfReach), positive where the dyad closes, and
    /// zero at a turning point.
    ///
    /// For two links a and b whose ends are d apart it is min(a + b - d, d - |a - b|), for a link and a slider the link less the distance of
    /// its end from the slider's line. The length of a link may change with the position, as that of a cylinder does.
    ///
    /// ```
    /// use kin_core::prelude::*;
    ///
    /// mechanism! {
    ///     /// A cylinder between two pivots lifts a boom.
    ///     struct Boom { base: Length, boom: Length }
    ///     input cylinder: Length;
    ///     unknown alpha: Angle, beta: Angle;
    ///     cylinder * cis(alpha) == base + boom * cis(beta);
    /// }
    ///
    /// let lift = Boom { base: 2.0, boom: 1.5 }.sweep(Assembly::Open).over(1.0..=2.5, 21);
    /// // as the cylinder begins to move out, half a metre is left until boom and cylinder lie on the base
    /// let begin = lift.lowest("margin")?;
    /// assert_eq!(begin.at, 1.0);
    /// assert!((begin.value - 0.5).abs() < 1e-14);
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
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
        own.find_map(|(block, form)| match form {
            BlockForm::TwoLinks { lengths } if lengths.iter().any(Option::is_none) => self.slack(block),
            BlockForm::LinkAndSlider { length: None } => margin_of(
                &BlockForm::LinkAndSlider {
                    length: self.link(block),
                },
                cosine,
            ),
            _ => margin_of(form, cosine),
        })
    }

    /// What the equations of a block have left if some of its angles are turned.
    fn turned(&self, block: &Block, angles: &[(usize, f64)]) -> [Local; 2] {
        let inputs = Row::from_fn(|input| self.inputs[input][0]);
        let mut unknowns = self.near_series();
        for (unknown, angle) in angles {
            unknowns[*unknown] = unknowns[*unknown] + Local::constant(*angle);
        }
        let residuals = self.mechanism.residuals(inputs, unknowns);
        let mut equations = block.equations.iter();
        [(); 2].map(|()| {
            equations
                .next()
                .map_or(Local::constant(0.0), |equation| residuals[*equation])
        })
    }

    /// The margin of two links by the sides of their triangle: what two sides are longer than the third one, at least.
    ///
    /// A link that is turned by half a turn changes the closure by twice its vector. One angle, the other one and both turn the links one by one
    /// or together, which side ever belongs to which: an angle may be that of a link against the other link.
    fn slack(&self, block: &Block) -> Option<Local> {
        let &[one, other] = block.members else { return None };
        let [one, other] = [one, other].map(|unknown| (unknown, PI));
        let here = self.turned(block, &[]);
        let side = |angles: &[(usize, f64)]| {
            let [x, y] = self.turned(block, angles);
            length(half(x - here[0]), half(y - here[1]))
        };
        let [a, b, c] = [side(&[one])?, side(&[other])?, side(&[one, other])?];
        let slacks = [a + b - c, b + c - a, c + a - b];
        slacks
            .into_iter()
            .min_by(|one, other| one.real().total_cmp(&other.real()))
    }

    /// The length of the link of a slider.
    ///
    /// One equation of the slider on an axis tells the component of the link along the other axis. The other component is that of the link
    /// turned by a right angle.
    fn link(&self, block: &Block) -> Option<Local> {
        let is_angle = |unknown: &usize| M::DESCRIPTION.unknowns[*unknown].dimension == Dimension::Angle;
        let angle = block.members.iter().copied().find(is_angle)?;
        let [here, opposite, left, right] =
            [0.0, PI, FRAC_PI_2, -FRAC_PI_2].map(|turn| self.turned(block, &[(angle, turn)]));
        if let [_] = block.equations {
            return length(half(here[0] - opposite[0]), half(left[0] - right[0]));
        }
        length(half(here[0] - opposite[0]), half(here[1] - opposite[1]))
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

fn half(value: Local) -> Local {
    Local::constant(0.5) * value
}

/// The length of a vector, if it has a direction.
fn length(x: Local, y: Local) -> Option<Local> {
    let square = x * x + y * y;
    (square.real() > 0.0).then(|| square.sqrt())
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
