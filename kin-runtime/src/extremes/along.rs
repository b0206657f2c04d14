//! A quantity along a sweep, and the questions to it.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::cell::RefCell;
use core::fmt;

use super::answer::Answer;
use super::at::{At, HIGHEST};
use super::margin::transmission_angle;
use super::mean::rooted;
use super::progress::Progress;
use super::quantity::Named;
use super::sensitivity::ByDimension;
use super::station::{ChangedFunctions, NamedFunctions, SweepStation};
use super::swept::{QuantityOfSweep, RateOfQuantity};
use super::{Crossing, DwellRange, Extreme, ExtremeKind, ExtremesError, Mean, Over, Peak, PeakSensitivities};
use crate::any::Of;
use crate::load::{EFFORT_ENTRIES, LoadError, NamedLoads};
use crate::mechanism::{JacobianError, JacobianMeasure, Mechanism, rows_of};
use crate::number::{Changing, Number};
use crate::reaction::{NamedReactions, Plan, ReactionError, ReactionQuantity, Reactions};
use crate::sweep::{Local, SmoothDrive, Sweep, UntypedSweep};

/// A sweep whose quantities can be asked for. A new version may add items.
pub trait QuantitySource {
    /// The sweep without types.
    #[doc(hidden)]
    fn untyped(&self) -> UntypedSweep<'_>;

    /// Its drive.
    #[doc(hidden)]
    fn drive(&self) -> &dyn SmoothDrive;

    /// The functions of its mechanism for quantities called by their names.
    #[doc(hidden)]
    fn named(&self) -> &dyn NamedFunctions;

    /// Those for the dependence on the dimensions.
    #[doc(hidden)]
    fn changed(&self) -> &dyn ChangedFunctions;
}

impl<M: Mechanism<Scalar = f64>, D: SmoothDrive> QuantitySource for Sweep<M, D> {
    fn untyped(&self) -> UntypedSweep<'_> {
        self.any()
    }

    fn drive(&self) -> &dyn SmoothDrive {
        &self.drive
    }

    fn named(&self) -> &dyn NamedFunctions {
        Of::<M>::FUNCTIONS
    }

    fn changed(&self) -> &dyn ChangedFunctions {
        Of::<M>::FUNCTIONS
    }
}

/// A quantity along a sweep. [`Sweep::of`] and [`Sweep::of_expression`] make it, and each of its methods answers a
/// question.
///
/// # Errors
/// [`ExtremesError`] for all questions: if no column has the name, if the mechanism closes nowhere, if the sweep has no
/// length, or if the curve of the quantity is too rough to be searched.
#[must_use = "ask for its `peak`, its `extremes` or its `mean`"]
pub struct QuantityAlong<'c, S, Q> {
    sweep: &'c S,
    quantity: Q,
    progress: Option<Progress<'c>>,
}

impl<S, Q: fmt::Debug> fmt::Debug for QuantityAlong<'_, S, Q> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("QuantityAlong")
            .field("quantity", &self.quantity)
            .finish_non_exhaustive()
    }
}

/// A quantity that is called by the name of its column.
#[derive(Clone, Debug)]
pub struct ByName<'q> {
    name: &'q str,
    found: Result<Named, ExtremesError>,
}

impl ByName<'_> {
    fn named(&self) -> Result<Named, ExtremesError> {
        self.found.clone()
    }
}

/// A measure of the Jacobian of results.
#[derive(Clone, Debug)]
pub struct ByJacobian {
    rows: Result<Vec<usize>, JacobianError>,
    measure: JacobianMeasure,
}

impl ByJacobian {
    /// The rows of the results. Names and dimensions are the same everywhere.
    fn rows(&self) -> Result<&[usize], ExtremesError> {
        let rows = self.rows.as_deref();
        rows.map_err(|error| ExtremesError::of_jacobian(f64::NAN, error.clone()))
    }

    fn value(
        &self,
        functions: &dyn ChangedFunctions,
        station: &SweepStation<'_>,
        parameters: &[Local],
    ) -> Result<Local, ExtremesError> {
        let at = station.variable.real();
        let jacobian = station.jacobian(functions, self.rows()?, parameters);
        jacobian
            .map(|jacobian| jacobian.measure(self.measure))
            .map_err(|_| ExtremesError::Gap { at })
    }
}

impl<S: QuantitySource> AskedQuantity<S> for ByJacobian {
    fn check(&self, _: &S, _: usize) -> Result<(), ExtremesError> {
        self.rows().map(|_| ())
    }

    fn at(&self, sweep: &S, station: &SweepStation<'_>) -> Result<Local, ExtremesError> {
        let parameters: Vec<Local> = station.parameters.iter().copied().map(Local::constant).collect();
        self.value(sweep.changed(), station, &parameters)
    }
}

impl<S: QuantitySource> SensitiveQuantity<S> for ByJacobian {
    fn by_dimension(
        &self,
        sweep: &S,
        station: &SweepStation<'_>,
        dimension: usize,
    ) -> Result<ByDimension, ExtremesError> {
        ByDimension::of_expression(station, dimension, |station, changed| {
            self.value(sweep.changed(), station, changed)
        })
    }
}

/// A quantity that a closure calculates from a pose.
#[derive(Clone, Copy)]
pub struct ByExpression<F>(F);

impl<F> fmt::Debug for ByExpression<F> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("ByExpression")
    }
}

/// A quantity of which questions can be asked. A new version may add items.
pub trait AskedQuantity<S> {
    /// Whether there is such a quantity, up to an order.
    #[doc(hidden)]
    fn check(&self, sweep: &S, highest: usize) -> Result<(), ExtremesError>;

    /// Its value at a point of a sweep.
    #[doc(hidden)]
    fn at(&self, sweep: &S, station: &SweepStation<'_>) -> Result<Local, ExtremesError>;

    /// The parameters at which it jumps, as far as its motion decides them.
    #[doc(hidden)]
    fn jumps(&self, _: &S) -> Result<Vec<f64>, ExtremesError> {
        Ok(Vec::new())
    }

    /// The derivative that it is, if it is one.
    #[doc(hidden)]
    fn derivative(&self) -> Option<Named> {
        None
    }
}

/// A quantity whose dependence on the dimensions is known. A new version may add items.
pub trait SensitiveQuantity<S>: AskedQuantity<S> {
    /// How its value and its slope at a point of a sweep change with a dimension.
    #[doc(hidden)]
    fn by_dimension(
        &self,
        sweep: &S,
        station: &SweepStation<'_>,
        dimension: usize,
    ) -> Result<ByDimension, ExtremesError>;
}

impl<S: QuantitySource> AskedQuantity<S> for ByName<'_> {
    fn check(&self, sweep: &S, highest: usize) -> Result<(), ExtremesError> {
        if self.named()?.order > highest {
            Named::find(sweep.named(), self.name, highest)?;
        }
        Ok(())
    }

    fn at(&self, sweep: &S, station: &SweepStation<'_>) -> Result<Local, ExtremesError> {
        self.named()?.at(sweep.named(), station)
    }

    fn derivative(&self) -> Option<Named> {
        self.named().ok()
    }
}

impl<S: QuantitySource> SensitiveQuantity<S> for ByName<'_> {
    fn by_dimension(
        &self,
        sweep: &S,
        station: &SweepStation<'_>,
        dimension: usize,
    ) -> Result<ByDimension, ExtremesError> {
        self.named()?.by_dimension(sweep.changed(), station, dimension)
    }
}

/// The transmission angle of a dyad, or its supplement if this is smaller.
#[derive(Clone, Copy, Debug)]
pub struct ByDyad(pub(crate) usize);

impl<S: QuantitySource> AskedQuantity<S> for ByDyad {
    fn check(&self, _: &S, _: usize) -> Result<(), ExtremesError> {
        Ok(())
    }

    fn at(&self, sweep: &S, station: &SweepStation<'_>) -> Result<Local, ExtremesError> {
        transmission_angle(station.margins(sweep.named()), station, self.0).map(|angle| angle.folded())
    }
}

impl<S: QuantitySource> SensitiveQuantity<S> for ByDyad {
    fn by_dimension(
        &self,
        sweep: &S,
        station: &SweepStation<'_>,
        dimension: usize,
    ) -> Result<ByDimension, ExtremesError> {
        ByDimension::of_expression(station, dimension, |station, changed| {
            let margins = station.changed_margins(sweep.named(), changed);
            transmission_angle(margins, station, self.0).map(|angle| angle.folded())
        })
    }
}

/// The effort of the drive of an input, or one of its rates.
#[derive(Clone, Copy, Debug)]
pub struct ByEffort<'q> {
    loads: &'q NamedLoads,
    input: usize,
    order: usize,
}

impl ByEffort<'_> {
    fn missing(&self) -> ExtremesError {
        ExtremesError::of_loads(f64::NAN, LoadError::NoEffort { input: self.input })
    }
}

impl<S: QuantitySource> AskedQuantity<S> for ByEffort<'_> {
    fn check(&self, sweep: &S, _: usize) -> Result<(), ExtremesError> {
        let is_input = self.input < sweep.untyped().description.inputs.len();
        if is_input && self.order < EFFORT_ENTRIES {
            Ok(())
        } else {
            Err(self.missing())
        }
    }

    fn at(&self, sweep: &S, station: &SweepStation<'_>) -> Result<Local, ExtremesError> {
        let effort = station.effort(sweep.changed(), self.loads, self.input)?;
        effort.get(self.order).copied().ok_or_else(|| self.missing())
    }
}

/// The power of the drive of an input.
#[derive(Clone, Copy, Debug)]
pub struct ByPower<'q>(ByEffort<'q>);

impl<S: QuantitySource> AskedQuantity<S> for ByPower<'_> {
    fn check(&self, sweep: &S, highest: usize) -> Result<(), ExtremesError> {
        self.0.check(sweep, highest)
    }

    fn at(&self, sweep: &S, station: &SweepStation<'_>) -> Result<Local, ExtremesError> {
        Ok(self.0.at(sweep, station)? * station.input(self.0.input, 1))
    }
}

/// A force in a joint, an effort or a power, or one of its rates.
#[derive(Clone, Debug)]
pub struct ByReaction<'q> {
    reactions: &'q NamedReactions<'q>,
    quantity: Result<ReactionQuantity, ExtremesError>,
    order: usize,
    /// A sweep stays in one assembly.
    plan: RefCell<Option<Plan>>,
    /// The same for numbers that change with a dimension.
    changing: RefCell<Option<Plan<Changing<f64>>>>,
}

impl<S: QuantitySource> AskedQuantity<S> for ByReaction<'_> {
    fn check(&self, _: &S, _: usize) -> Result<(), ExtremesError> {
        self.quantity.clone().map(|_| ())
    }

    fn at(&self, sweep: &S, station: &SweepStation<'_>) -> Result<Local, ExtremesError> {
        let quantity = self.quantity.clone()?;
        let plan = &mut self.plan.borrow_mut();
        station.reaction(sweep.changed(), self.reactions, plan, quantity, self.order)
    }

    /// Friction jumps where the motion in a joint turns back.
    fn jumps(&self, sweep: &S) -> Result<Vec<f64>, ExtremesError> {
        let mut jumps = Vec::new();
        for joint in 0..self.reactions.joints_with_friction() {
            let reactions = self.reactions;
            let speed = QuantityAlong::new(sweep, ByJointSpeed { reactions, joint });
            jumps.extend(speed.crossings(0.0)?.into_iter().map(|crossing| crossing.at));
        }
        Ok(jumps)
    }
}

impl<S: QuantitySource> SensitiveQuantity<S> for ByReaction<'_> {
    fn by_dimension(
        &self,
        sweep: &S,
        station: &SweepStation<'_>,
        dimension: usize,
    ) -> Result<ByDimension, ExtremesError> {
        let quantity = (self.quantity.clone()?, self.order);
        let plan = &mut self.changing.borrow_mut();
        let change = station.change_of_reaction(sweep.changed(), self.reactions, plan, quantity, dimension)?;
        let (at, kind) = (station.variable.real(), ExtremeKind::Kink);
        // the size of a force that is zero here, but not with other values of the dimension
        ByDimension::of_change(station, change).map_err(|_| ExtremesError::NoSensitivity { at, kind })
    }
}

/// The speed of the motion in a joint with friction.
struct ByJointSpeed<'q> {
    reactions: &'q NamedReactions<'q>,
    joint: usize,
}

impl<S: QuantitySource> AskedQuantity<S> for ByJointSpeed<'_> {
    fn check(&self, _: &S, _: usize) -> Result<(), ExtremesError> {
        Ok(())
    }

    fn at(&self, sweep: &S, station: &SweepStation<'_>) -> Result<Local, ExtremesError> {
        station.joint_speed(sweep.changed(), self.reactions, self.joint)
    }
}

impl<M, D, A, F> AskedQuantity<Sweep<M, D>> for ByExpression<F>
where
    M: Mechanism<Scalar = f64>,
    A: Answer,
    F: Fn(&At<M>) -> A,
{
    fn check(&self, _: &Sweep<M, D>, _: usize) -> Result<(), ExtremesError> {
        Ok(())
    }

    fn at(&self, _: &Sweep<M, D>, station: &SweepStation<'_>) -> Result<Local, ExtremesError> {
        pose_quantity(station, None, &self.0)
    }
}

impl<M, D, A, F> SensitiveQuantity<Sweep<M, D>> for ByExpression<F>
where
    M: Mechanism<Scalar = f64>,
    A: Answer,
    F: Fn(&At<M>) -> A,
{
    fn by_dimension(
        &self,
        _: &Sweep<M, D>,
        station: &SweepStation<'_>,
        dimension: usize,
    ) -> Result<ByDimension, ExtremesError> {
        ByDimension::of_expression(station, dimension, |station, changed| {
            pose_quantity(station, Some(changed), &self.0)
        })
    }
}

impl<M: Mechanism<Scalar = f64>, D: SmoothDrive> Sweep<M, D> {
    /// A quantity by the name of its column, as in `"theta4_jerk"`, to ask for its peak, its extremes or its mean.
    ///
    /// Names go on above the order of the mechanism, up to the twelfth derivative, and `"margin"` is the length that is
    /// left until the first dyad ceases to close. A name that no column has is an error of the question. An expression
    /// of a pose goes to [`of_expression`](Self::of_expression).
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 100).speed(10.0);
    /// let jerk = sweep.of("theta4_jerk");
    /// println!("from {} to {}", jerk.lowest()?, jerk.highest()?);
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    pub fn of<'q>(&self, name: &'q str) -> QuantityAlong<'_, Self, ByName<'q>> {
        QuantityAlong::by_name(self, name)
    }

    /// A quantity by a closure: any expression of a pose, as in `|at| at.theta4.jerk()`, or the effort of a drive,
    /// `|at| at.effort(&loads, 0)`. See [`At`].
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 100).speed(10.0);
    /// let height = sweep.of_expression(|at| 60.0 * at.theta4.sin()).highest()?;
    /// println!("{} at {} rad", height.value, height.at);
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    pub fn of_expression<A: Answer, F: Fn(&At<M>) -> A>(
        &self,
        expression: F,
    ) -> QuantityAlong<'_, Self, ByExpression<F>> {
        QuantityAlong::new(self, ByExpression(expression))
    }

    /// A measure of the Jacobian of results, as its smallest singular value or its condition number: where is a robot
    /// close to a singular pose? The results are unknowns or outputs, which are called by their names. A point has a
    /// row for each of its coordinates. See [`Jacobian`](crate::Jacobian), which explains the values.
    ///
    /// Where two singular values are equal, and where one is zero, they have kinks, which are found as such. Where the
    /// mechanism ceases to close because its inputs cannot hold it, the largest singular value and the condition number
    /// grow beyond all bounds. A closure has the matrix itself: see [`At::jacobian_of`].
    ///
    /// ```
    /// use kin_core::JacobianMeasure;
    /// use kin_core::library::FiveBar;
    /// use kin_core::prelude::*;
    ///
    /// let robot = FiveBar { ground: 2.0, left: 1.5, left_rod: 2.0, right_rod: 2.0, right: 1.5 };
    /// let way = robot.sweep(Assembly::Open).between([2.1, 1.0], [1.8, 1.2], 50);
    /// let slowest = way.of_jacobian(&["hand"], JacobianMeasure::SmallestSingularValue).lowest()?;
    /// let worst = way.of_jacobian(&["hand"], JacobianMeasure::ConditionNumber).highest()?;
    /// println!("{} of length for each radian at {}; κ = {}", slowest.value, slowest.at, worst.value);
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    ///
    /// Names that no result has, and results or inputs of several dimensions, are errors of the question.
    pub fn of_jacobian(&self, results: &[&str], measure: JacobianMeasure) -> QuantityAlong<'_, Self, ByJacobian> {
        QuantityAlong::by_jacobian(self, results, measure)
    }
}

impl<'c, S: QuantitySource> QuantityAlong<'c, S, ByJacobian> {
    pub(crate) fn by_jacobian(sweep: &'c S, results: &[&str], measure: JacobianMeasure) -> Self {
        let rows = rows_of(sweep.untyped().description, results);
        Self::new(sweep, ByJacobian { rows, measure })
    }
}

impl<'c, 'q, S: QuantitySource> QuantityAlong<'c, S, ByEffort<'q>> {
    pub(crate) fn by_effort(sweep: &'c S, loads: &'q NamedLoads, input: usize, order: usize) -> Self {
        Self::new(sweep, ByEffort { loads, input, order })
    }
}

impl<'c, 'q, S: QuantitySource> QuantityAlong<'c, S, ByPower<'q>> {
    pub(crate) fn by_power(sweep: &'c S, loads: &'q NamedLoads, input: usize) -> Self {
        let order = 0;
        Self::new(sweep, ByPower(ByEffort { loads, input, order }))
    }
}

/// The forces in all joints in each row of a sweep; a [gap](ExtremesError::Gap) where the mechanism does not close.
pub(crate) fn reactions_in_rows<S: QuantitySource>(
    sweep: &S,
    reactions: &NamedReactions<'_>,
) -> Result<Vec<Result<Reactions, ExtremesError>>, ExtremesError> {
    let nothing = |_: &SweepStation<'_>| Ok(Local::constant(0.0));
    let swept = QuantityOfSweep {
        sweep: sweep.untyped(),
        drive: sweep.drive(),
        quantity: &nothing,
        rate: None,
        known: None,
        jumps: None,
        progress: None,
    };
    let plan = RefCell::default();
    swept.rows(|station| station.reactions(sweep.changed(), reactions, &mut plan.borrow_mut()))
}

impl<'c, 'q, S: QuantitySource> QuantityAlong<'c, S, ByReaction<'q>> {
    pub(crate) fn by_reaction(
        sweep: &'c S,
        reactions: &'q NamedReactions<'q>,
        quantity: Result<ReactionQuantity, ReactionError>,
        order: usize,
    ) -> Self {
        let is_known = order < EFFORT_ENTRIES;
        let quantity =
            quantity.and_then(|quantity| is_known.then_some(quantity).ok_or(ReactionError::NoSuchRate { order }));
        let quantity = quantity.map_err(|error| ExtremesError::of_reaction(f64::NAN, error));
        Self::new(
            sweep,
            ByReaction {
                reactions,
                quantity,
                order,
                plan: RefCell::default(),
                changing: RefCell::default(),
            },
        )
    }
}

impl<'c, 'q, S: QuantitySource> QuantityAlong<'c, S, ByName<'q>> {
    pub(crate) fn by_name(sweep: &'c S, name: &'q str) -> Self {
        let found = Named::find(sweep.named(), name, HIGHEST);
        Self::new(sweep, ByName { name, found })
    }
}

impl<'c, S: QuantitySource, Q: AskedQuantity<S>> QuantityAlong<'c, S, Q> {
    pub(crate) fn new(sweep: &'c S, quantity: Q) -> Self {
        Self {
            sweep,
            quantity,
            progress: None,
        }
    }

    /// The same quantity, whose questions report their progress: `progress` is called with the part of the sweep that
    /// has been searched, which grows. It is 1 in the last call, unless the answer is an error.
    ///
    /// The calls come after each of the pieces with which a search for extremes begins: 24 for a revolution of an
    /// input, or for all of another sweep, and at least 4 between two joints of a law.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 361);
    /// let mut parts = vec![];
    /// let extremes = sweep.of("theta4_derivative_9").on_progress(|part| parts.push(part)).extremes()?;
    /// println!("{} extremes", extremes.len());
    /// assert_eq!((parts.len(), parts[23]), (24, 1.0));
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    pub fn on_progress(mut self, progress: impl FnMut(f64) + 'c) -> Self {
        self.progress = Some(Progress::new(Box::new(progress)));
        self
    }

    /// The value that is largest in size, and where.
    ///
    /// # Errors
    /// [`ExtremesError::Unbounded`] if the quantity has none.
    pub fn peak(&self) -> Result<Peak, ExtremesError> {
        self.ask(|asked| asked.best(f64::abs))
    }

    /// The highest value, and where.
    ///
    /// # Errors
    /// [`ExtremesError::Unbounded`] if there is none.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::SliderCrank;
    /// use kin_core::prelude::*;
    ///
    /// let press = SliderCrank { r: 0.1, l: 0.3 };
    /// let sweep = press.sweep(Assembly::Open).over(0.0..=TAU, 100);
    /// let ram = sweep.of("s");
    /// assert!((ram.highest()?.value - 0.4).abs() < 1e-15 && (ram.lowest()?.value - 0.2).abs() < 1e-15);
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    pub fn highest(&self) -> Result<Peak, ExtremesError> {
        self.ask(|asked| asked.best(|value| value))
    }

    /// The lowest value, and where.
    ///
    /// # Errors
    /// As for [`highest`](Self::highest).
    pub fn lowest(&self) -> Result<Peak, ExtremesError> {
        self.ask(|asked| asked.best(|value| -value))
    }

    /// All extremes, in the order of the sweep: those inside, those at limits and kinks, and those at its ends. A full
    /// revolution has no ends.
    ///
    /// ```
    /// use kin_core::extremes::ExtremeKind;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
    /// let sweep = linkage.sweep(Assembly::Open).over(-3.0..=3.0, 100);
    /// for extreme in sweep.of("theta4").extremes()? {
    ///     println!("{extreme}");
    /// }
    /// // at its limits the rocker has no finite velocity
    /// let velocity = sweep.of("theta4_velocity").extremes()?;
    /// assert_eq!((velocity[0].kind, velocity[0].value), (ExtremeKind::Unbounded, None));
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    ///
    /// # Errors
    /// Those of the type.
    pub fn extremes(&self) -> Result<Vec<Extreme>, ExtremesError> {
        self.ask(|asked| Ok(asked.extremes()?.extremes))
    }

    /// The points where the quantity crosses a level, in the order of the sweep: zero for its changes of sign. A jump
    /// across the level, where two pieces of a law meet, counts as well.
    ///
    /// # Errors
    /// [`ExtremesError::Argument`] if the level is not finite.
    pub fn crossings(&self, level: f64) -> Result<Vec<Crossing>, ExtremesError> {
        self.ask(|asked| asked.crossings(level))
    }

    /// The parts of the sweep on which the quantity stays within a tolerance of a level.
    ///
    /// # Errors
    /// [`ExtremesError::Argument`] if the level or the tolerance is not finite.
    pub fn dwells(&self, level: f64, tolerance: f64) -> Result<Vec<DwellRange>, ExtremesError> {
        self.ask(|asked| asked.dwells(level, tolerance))
    }

    /// The mean, over the time or over the way of the input. Both are the same at constant speed.
    ///
    /// # Errors
    /// [`ExtremesError::Diverges`] if the integral has no value because of a turning point,
    /// [`ExtremesError::Imprecise`] if the estimate of the error stays above 10⁻¹² of the mean size.
    pub fn mean(&self, over: Over) -> Result<Mean, ExtremesError> {
        self.ask(|asked| asked.mean(over, 1))
    }

    /// The root of the mean square.
    ///
    /// # Errors
    /// As for [`mean`](Self::mean).
    pub fn rms(&self, over: Over) -> Result<Mean, ExtremesError> {
        rooted(self.ask(|asked| asked.mean(over, 2)))
    }

    /// The values in the rows of the sweep, as a column beside those of its [table](Sweep::table): NaN in rows that do
    /// not close, and infinite where the quantity is.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 361).speed(10.0);
    /// let power = sweep.of_expression(|at| at.theta4.velocity() * at.theta4.acceleration()).column()?;
    /// assert_eq!(power.len(), sweep.table()?.count());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Those of the type, except that a sweep which closes nowhere has a column.
    #[expect(
        clippy::redundant_closure_for_method_calls,
        reason = "the method by its path has another lifetime"
    )]
    pub fn column(&self) -> Result<Vec<f64>, ExtremesError> {
        self.ask(|asked| asked.column())
    }

    fn ask<T>(
        &self,
        question: impl FnOnce(&QuantityOfSweep<'_>) -> Result<T, ExtremesError>,
    ) -> Result<T, ExtremesError> {
        self.quantity.check(self.sweep, HIGHEST)?;
        let answer = |station: &SweepStation<'_>| self.quantity.at(self.sweep, station);
        let report = |part: f64| {
            if let Some(progress) = &self.progress {
                progress.reach(part);
            }
        };
        let jumps = || self.quantity.jumps(self.sweep);
        let found = question(&QuantityOfSweep {
            sweep: self.sweep.untyped(),
            drive: self.sweep.drive(),
            quantity: &answer,
            rate: self.quantity.derivative().map(|named| RateOfQuantity {
                named,
                functions: self.sweep.named(),
            }),
            known: None,
            jumps: Some(&jumps),
            progress: Some(&report),
        })?;
        if let Some(progress) = &self.progress {
            progress.end();
        }
        Ok(found)
    }
}

impl<S: QuantitySource, Q: SensitiveQuantity<S>> QuantityAlong<'_, S, Q> {
    /// The [`peak`](Self::peak), and how its value and its position depend on every dimension of the mechanism.
    ///
    /// A peak between the ends of the sweep is taken where it is. One at an end of the sweep stays there. At a limit or
    /// a kink there is none: it moves with the limit, and its value need not have a derivative.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 361).speed(10.0);
    /// let found = sweep.of("theta4_acceleration").peak_sensitivities()?;
    /// for (name, by) in ["r1", "r2", "r3", "r4"].iter().zip(&found.by) {
    ///     println!("{name}: {} rad/s² for each unit of length, and {} rad", by.value, by.at);
    /// }
    /// // a longer crank makes the rocker faster
    /// assert!(found.by[1].value * found.peak.value > 0.0);
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    ///
    /// # Errors
    /// [`ExtremesError::NoSensitivity`] if the peak is at a limit or a kink. For forces in joints also
    /// [`ReactionError::ThisDesignOnly`], if bodies are rigid and contacts roll in this design alone.
    pub fn peak_sensitivities(&self) -> Result<PeakSensitivities, ExtremesError> {
        let order = self.sweep.untyped().description.order;
        self.quantity.check(self.sweep, order)?;
        let by_dimension =
            |station: &SweepStation<'_>, dimension: usize| self.quantity.by_dimension(self.sweep, station, dimension);
        self.ask(|asked| asked.sensitivities(&by_dimension))
    }
}

/// The value of an expression of the typed pose.
pub(crate) fn pose_quantity<M: Mechanism<Scalar = f64>, A: Answer>(
    station: &SweepStation<'_>,
    changed: Option<&[Local]>,
    quantity: impl Fn(&At<M>) -> A,
) -> Result<Local, ExtremesError> {
    let at = station.variable.real();
    let pose = At::of(station, changed).map_err(|_| ExtremesError::Gap { at })?;
    quantity(&pose).answer(at)
}
