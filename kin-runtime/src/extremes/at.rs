//! A pose of a sweep with derivatives in the variable of the sweep.

use alloc::vec;
use core::ops::Deref;

use super::margin::Margins;
use super::station::{ResultIndex, SweepStation};
use crate::any::{Of, description, motions, row, write};
use crate::failure::SolveError;
use crate::law::Side;
use crate::load::{Balance, LoadError, Loaded, LoadsOf};
use crate::mechanism::{Jacobian, JacobianError, Mechanism, Pose, rows_of};
use crate::motion::Motion;
use crate::number::{Number, NumberRow, Row};
use crate::picture::TransmissionAngle;
use crate::quantity::{Dimension, RATES};
use crate::solve::unwrap_near;
use crate::sweep::{Local, READ};

/// The pose at one point of a sweep, in numbers that carry their derivatives with respect to the variable of the sweep.
/// Any expression of them carries its derivatives.
///
/// It has the fields of the pose: `at.theta4.jerk()`. Plain numbers are constants among them: `2.0 * at.theta4.jerk()`.
///
/// ```
/// use std::f64::consts::TAU;
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
/// let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 100).speed(10.0);
/// // power per unit of inertia, whose peak is neither that of the velocity nor that of the acceleration
/// let power = sweep.of_expression(|at| at.theta4.velocity() * at.theta4.acceleration()).peak()?;
/// println!("{} at {} rad", power.value, power.at);
/// # Ok::<(), kin_core::extremes::ExtremesError>(())
/// ```
#[derive(Clone, Copy)]
pub struct At<M: Mechanism> {
    mechanism: M::With<Local>,
    pose: <M::With<Local> as Mechanism>::Pose,
    inputs: <M::With<Local> as Mechanism>::Inputs<<M::With<Local> as Mechanism>::Motion<Local>>,
    /// The unknowns, with angles unwrapped along the sweep.
    near: <M::With<Local> as Mechanism>::Unknowns<Local>,
    /// The outputs, with unwrapped angles.
    outputs: <M::Pose as Pose>::Outputs<f64>,
    /// What derivatives above the order of the mechanism are found from.
    source: Option<SourceOf<M>>,
}

/// The inputs with all derivatives that are read, and the variable: the rest of a [`SweepStation`].
#[derive(Clone, Copy)]
struct SourceOf<M: Mechanism> {
    inputs: M::Inputs<Motion<f64, READ>>,
    rate: f64,
    variable: Local,
}

/// A row for each result, with a number for each input.
type RowsOf<M> =
    <<M as Mechanism>::With<Local> as Mechanism>::Results<<<M as Mechanism>::With<Local> as Mechanism>::Inputs<Local>>;

/// The highest order of a derivative.
pub(super) const HIGHEST: usize = RATES.len();

impl<M: Mechanism> Deref for At<M> {
    type Target = <M::With<Local> as Mechanism>::Pose;

    fn deref(&self) -> &Self::Target {
        &self.pose
    }
}

impl<M: Mechanism<Scalar = f64>> At<M> {
    /// The typed pose at a point of a sweep, as the solvers of a mechanism find it: with the dimensions of the sweep,
    /// or with others that change with the variable.
    pub(super) fn of(station: &SweepStation<'_>, changed: Option<&[Local]>) -> Result<Self, SolveError> {
        let mechanism = M::With::<Local>::from_parameters(match changed {
            Some(changed) => row(changed),
            None => Row::from_fn(|parameter| Local::constant(station.parameters[parameter])),
        });
        let near = Row::from_fn(|unknown| Local::constant(station.unknowns[unknown]));
        let inputs = Row::from_fn(|input| Row::from_fn(|order| station.input(input, order)));
        let source = SourceOf {
            inputs: motions(&station.inputs),
            rate: station.rate,
            variable: station.variable,
        };
        Ok(At {
            mechanism,
            pose: mechanism.solve_near(inputs, near)?,
            inputs,
            near,
            outputs: row(&station.outputs),
            source: changed.is_none().then_some(source),
        })
    }

    /// The station of which this is the pose, if its dimensions are those of the sweep.
    fn station(&self) -> Option<SweepStation<'_>> {
        let source = self.source?;
        let mut inputs = vec![0.0; M::DESCRIPTION.inputs.len() * READ];
        write(source.inputs.as_ref(), &mut inputs);
        let real = |values: &[Local]| NumberRow::from_fn(values.len(), |index| values[index].real());
        Some(SweepStation {
            description: description::<M>(),
            parameters: real(self.mechanism.parameters().as_ref()),
            inputs,
            unknowns: real(self.near.as_ref()),
            outputs: self.outputs.as_ref().into(),
            rate: source.rate,
            side: Side::Right,
            variable: source.variable,
        })
    }

    /// The derivative of an input, by its index and its order, up to the twelfth.
    #[must_use]
    pub fn input(&self, index: usize, order: usize) -> Option<Local> {
        let motion = self.inputs.as_ref().get(index)?;
        if let Some(value) = motion.as_ref().get(order) {
            return Some(*value);
        }
        let source = self.station()?;
        (order <= HIGHEST).then(|| source.input(index, order))
    }

    /// The derivative of an unknown, by its index and its order, up to the twelfth. Those above the order of the
    /// mechanism come from its position, solved in longer series.
    #[must_use]
    pub fn unknown(&self, index: usize, order: usize) -> Option<Local> {
        if order > M::DESCRIPTION.order && order <= HIGHEST {
            return (index < M::DESCRIPTION.unknowns.len()).then(|| {
                self.station()?
                    .result(Of::<M>::FUNCTIONS, ResultIndex::Unknown(index), order)
                    .ok()
            })?;
        }
        let motions = self
            .pose
            .unknown_motions_near(Row::from_fn(|unknown| self.near[unknown]));
        let value = *motions.as_ref().get(index)?.as_ref().get(order)?;
        let is_angle = M::DESCRIPTION.unknowns[index].dimension == Dimension::Angle;
        Some(if is_angle && order == 0 {
            unwrap_near(value, self.near[index])
        } else {
            value
        })
    }

    /// The derivative of a scalar output, by its index and its order, up to the twelfth.
    #[must_use]
    pub fn output(&self, index: usize, order: usize) -> Option<Local> {
        if order > M::DESCRIPTION.order && order <= HIGHEST {
            return (index < M::DESCRIPTION.outputs.len()).then(|| {
                self.station()?
                    .result(Of::<M>::FUNCTIONS, ResultIndex::Output(index), order)
                    .ok()
            })?;
        }
        let motions = self.pose.output_motions();
        let value = *motions.as_ref().get(index)?.as_ref().get(order)?;
        let is_angle = M::DESCRIPTION.outputs[index].dimension == Dimension::Angle;
        Some(if is_angle && order == 0 {
            unwrap_near(value, Local::constant(self.outputs[index]))
        } else {
            value
        })
    }

    /// The transmission angle of a dyad, by its index in the order in which the dyads are solved.
    #[must_use]
    pub fn transmission_angle(&self, dyad: usize) -> Option<TransmissionAngle<Local>> {
        self.margins().transmission_angle(dyad)
    }

    /// The Jacobian of unknowns or outputs of these names, whose singular values have their derivatives along the
    /// sweep. It has the rows that [`Mechanism::jacobian_of`](crate::Mechanism::jacobian_of) has at one pose. For one
    /// of its measures alone, [`of_jacobian`](crate::sweep::Sweep::of_jacobian) is shorter.
    ///
    /// ```
    /// use kin_core::JacobianMeasure;
    /// use kin_core::library::FiveBar;
    /// use kin_core::prelude::*;
    ///
    /// let robot = FiveBar { ground: 2.0, left: 1.5, left_rod: 2.0, right_rod: 2.0, right: 1.5 };
    /// let way = robot.sweep(Assembly::Open).between([2.1, 1.0], [1.8, 1.2], 50);
    /// let spread = way.of_expression(|at| {
    ///     let hand = at.jacobian_of(&["hand"])?;
    ///     let values = hand.singular_values();
    ///     Ok::<_, kin_core::JacobianError>(values[0] - values[1])
    /// });
    /// println!("{}", spread.lowest()?);
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    ///
    /// # Errors
    /// As there.
    pub fn jacobian_of(&self, results: &[&str]) -> Result<Jacobian<Local>, JacobianError> {
        let rows = rows_of(&M::DESCRIPTION, results)?;
        let jacobian = self.jacobian()?;
        let entry = |row: usize, column: usize| jacobian[rows[row]][column];
        Ok(Jacobian::from_fn(rows.len(), M::DESCRIPTION.inputs.len(), entry))
    }

    /// The Jacobian of the pose, with a row for each unknown and then for each scalar output, and a number for each
    /// input: see [`Mechanism::jacobian`](crate::Mechanism::jacobian).
    ///
    /// # Errors
    /// As there.
    pub fn jacobian(&self) -> Result<RowsOf<M>, SolveError> {
        let inputs = Row::from_fn(|input| self.inputs[input][0]);
        let near = Row::from_fn(|unknown| self.near[unknown]);
        self.mechanism.jacobian_near(inputs, near)
    }

    /// The balance of loads and drives, with its change along the sweep. The loads are those of the mechanism over
    /// `Local`.
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
    /// let sweep = press.sweep(Assembly::Open).over(0.0..=TAU, 100).speed(rpm(120.0));
    /// let peak = sweep.of_expression(|at| at.effort(&loads, 0)).peak()?;
    /// let rms = sweep.of_expression(|at| at.effort(&loads, 0)).rms(Over::Time)?;
    /// println!("{} N m at {}°, in the mean {} N m", peak.value, peak.at.to_degrees(), rms.value);
    /// assert!(rms.value < peak.value.abs());
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`balance`](Loaded::balance), and [`LoadError::NoEffort`] if there is no such input, or if the mechanism
    /// is declared to a lower order than 2.
    pub fn effort<L: LoadsOf<M::With<Local>>>(&self, loads: &L, input: usize) -> Result<Local, LoadError> {
        let efforts = self.balance(loads)?.efforts();
        let effort = efforts.as_ref().get(input).and_then(|effort| effort.derivative(0));
        effort.ok_or(LoadError::NoEffort { input })
    }

    /// The margin of a dyad, by its index in the order in which the dyads are solved: by how much its links could be
    /// longer or shorter until it ceases to close. It is the number of
    /// [`Failure::OutOfReach`](crate::Failure::OutOfReach), positive where the dyad closes, and zero at a turning
    /// point.
    ///
    /// For two links a and b whose ends are d apart it is min(a + b - d, d - |a - b|), for a link and a slider the link
    /// less the distance of its end from the slider's line. The length of a link may change with the position, as that
    /// of a cylinder does.
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
    /// let begin = lift.of("margin").lowest()?;
    /// assert_eq!(begin.at, 1.0);
    /// assert!((begin.value - 0.5).abs() < 1e-14);
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    #[must_use]
    pub fn margin(&self, dyad: usize) -> Option<Local> {
        self.margins().of(dyad)
    }

    /// The smallest margin of all dyads, or `None` if there is a dyad whose margin is not known, or none at all.
    #[must_use]
    pub fn smallest_margin(&self) -> Option<Local> {
        self.margins().smallest()
    }

    fn margins(&self) -> Margins<'static> {
        Margins {
            functions: Of::<M>::FUNCTIONS,
            description: description::<M>(),
            parameters: self.mechanism.parameters().as_ref().to_vec(),
            inputs: self.inputs.as_ref().iter().map(|input| input[0]).collect(),
            unknowns: self.near_series().as_ref().to_vec(),
        }
    }

    /// The unknowns as series.
    fn near_series(&self) -> <M::With<Local> as Mechanism>::Unknowns<Local> {
        Row::from_fn(|unknown| self.unknown(unknown, 0).unwrap_or(Local::constant(f64::NAN)))
    }
}
