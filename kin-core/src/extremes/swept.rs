//! A sweep and a quantity of its poses, without the type of the mechanism.
//!
//! The search for extremes, crossings, dwells and means is compiled once, in this crate. For each mechanism only what stands here is
//! compiled: the walk from pose to pose, and the quantity.

use alloc::rc::Rc;
use alloc::vec::Vec;
use core::any::Any;
use core::f64::consts::TAU;

use super::ExtremesError;
use super::branch::KnownStretch;
use super::curve::StretchEnd;
use super::station::SweepStation;
use crate::failure::SolveError;
use crate::law::Side;
use crate::mechanism::Mechanism;
use crate::number::{Number, Row};
use crate::quantity::Dimension;
use crate::sweep::{Course, Limit, Local, SmoothDrive, SweepError, Variable, Walk, by_time, limit_between};

/// A quantity of a pose.
pub(super) type PoseQuantity<'q, M> = dyn Fn(&SweepStation<M>) -> Result<Local, ExtremesError> + 'q;

/// What a search knows of a sweep.
#[derive(Clone, Copy)]
pub(super) struct SweepExtent {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) rows: usize,
    /// Whether the variable is an angle.
    pub(super) is_angle: bool,
    /// Whether the sweep is one full turn of the only input that moves.
    pub(super) is_full_turn: bool,
    /// Whether every block has a closed form, so that rows behind a gap close again.
    pub(super) has_assemblies: bool,
    /// The time for each unit of the variable.
    pub(super) time: f64,
}

/// A pose of the walk along a sweep.
#[derive(Clone)]
pub(super) struct Mark {
    /// The variable of the sweep at the last pose, if there is one.
    pub(super) at: Option<f64>,
    walk: Rc<dyn Any>,
}

impl Mark {
    pub(super) fn new<M: Mechanism<Scalar = f64>>(walk: Walk<M>) -> Self {
        Self {
            at: walk.last.map(|last| last.at),
            walk: Rc::new(walk),
        }
    }

    /// The walk of a mechanism. Marks of a sweep have one type only.
    pub(super) fn walk<M: Mechanism<Scalar = f64>>(&self) -> Walk<M> {
        self.walk.downcast_ref().copied().unwrap_or(Walk::BEGINNING)
    }
}

/// A quantity along a sweep.
pub(super) trait SweptQuantity {
    fn extent(&self) -> SweepExtent;

    /// Whether the inputs can move so.
    fn check(&self) -> Result<(), SweepError>;

    /// The value of the variable in a row.
    fn row(&self, row: usize) -> f64;

    /// The largest change of an angle among the inputs between two places.
    fn turn(&self, ends: [f64; 2]) -> f64;

    /// The way of the first input for each unit of the variable.
    fn way(&self, at: f64) -> f64;

    /// The joints of laws between two places, in the order from the first to the second.
    fn joints(&self, ends: [f64; 2]) -> Vec<f64>;

    /// The ends of the sweep and a pose inside of it, if it is known that the mechanism closes throughout.
    fn known(&self) -> Option<([StretchEnd; 2], Mark)>;

    /// Where a walk begins.
    fn beginning(&self) -> Mark;

    /// The walk on to another place, and whether the mechanism closes there.
    fn step(&self, near: &Mark, at: f64) -> (Mark, Result<(), SolveError>);

    /// The quantity where the variable has a series, found from a pose nearby.
    fn value(&self, near: &Mark, variable: Local, side: Side) -> Result<(Local, Mark), ExtremesError>;

    /// The limit on the way from a pose to another place.
    fn limit(&self, closed: f64, near: &Mark, other: f64) -> Option<Limit>;

    /// The place closest to one that does not close at which the mechanism closes.
    fn edge(&self, closed: f64, open: f64) -> f64;
}

/// A sweep of a mechanism, with a quantity.
pub(super) struct QuantityOfSweep<'c, M: Mechanism<Scalar = f64>, D> {
    pub(super) course: &'c Course<M, D>,
    pub(super) quantity: &'c PoseQuantity<'c, M>,
    pub(super) known: Option<KnownStretch<M>>,
}

impl<M: Mechanism<Scalar = f64>, D: SmoothDrive<M>> QuantityOfSweep<'_, M, D> {
    /// The pose where the variable has a series, found from a pose nearby.
    pub(super) fn station(
        &self,
        mut near: Walk<M>,
        variable: Local,
        side: Side,
    ) -> Result<(SweepStation<M>, Walk<M>), ExtremesError> {
        let (at, drive) = (variable.real(), &self.course.drive);
        let (inputs, rate) = (drive.derivatives(at, side), drive.rate());
        let motions = Row::from_fn(|input| Row::from_fn(|order| by_time(inputs[input].as_ref(), order, rate).real()));
        let reached = near.step(self.course, at, motions);
        let reached = reached.map_err(|_| ExtremesError::Gap { at })?.footing;
        let station = SweepStation {
            mechanism: self.course.mechanism,
            inputs,
            unknowns: reached.unknowns,
            outputs: reached.outputs,
            rate,
            variable,
        };
        Ok((station, near))
    }

    fn is_full_turn(&self) -> bool {
        if let Some(known) = &self.known {
            return known.is_full_turn;
        }
        let course = self.course;
        let way = (course.to - course.from).abs();
        let is_turn = (way - TAU).abs() <= 8.0 * f64::EPSILON * course.to.abs().max(course.from.abs());
        let Variable::Input(lead) = course.drive.variable() else {
            return false;
        };
        let mut inputs = 0..M::DESCRIPTION.inputs.len();
        let is_alone = inputs.all(|input| input == lead || course.drive.same(input, 0).is_some());
        is_turn && is_alone && M::DESCRIPTION.inputs[lead].dimension == Dimension::Angle
    }
}

impl<M: Mechanism<Scalar = f64>, D: SmoothDrive<M>> SweptQuantity for QuantityOfSweep<'_, M, D> {
    fn extent(&self) -> SweepExtent {
        let course = self.course;
        SweepExtent {
            from: course.from,
            to: course.to,
            rows: course.count,
            is_angle: match course.drive.variable() {
                Variable::Input(input) => M::DESCRIPTION.inputs[input].dimension == Dimension::Angle,
                _ => false,
            },
            is_full_turn: self.is_full_turn(),
            has_assemblies: M::ASSEMBLY_COUNT > 0,
            time: course.drive.time_per_variable(),
        }
    }

    fn check(&self) -> Result<(), SweepError> {
        self.course.check()
    }

    fn row(&self, row: usize) -> f64 {
        self.course.at(row)
    }

    fn turn(&self, ends: [f64; 2]) -> f64 {
        let [start, end] = ends.map(|at| self.course.drive.motions(at));
        let inputs = M::DESCRIPTION.inputs.iter().enumerate();
        inputs
            .filter(|(_, input)| input.dimension == Dimension::Angle)
            .fold(0.0, |most: f64, (input, _)| {
                most.max((end[input][0] - start[input][0]).abs())
            })
    }

    fn way(&self, at: f64) -> f64 {
        self.course.drive.way_per_variable(at)
    }

    fn joints(&self, ends: [f64; 2]) -> Vec<f64> {
        self.course.joints(ends)
    }

    fn known(&self) -> Option<([StretchEnd; 2], Mark)> {
        self.known.as_ref().map(KnownStretch::ends)
    }

    fn beginning(&self) -> Mark {
        Mark::new(Walk::<M>::BEGINNING)
    }

    fn step(&self, near: &Mark, at: f64) -> (Mark, Result<(), SolveError>) {
        let mut walk = near.walk::<M>();
        let result = walk.step(self.course, at, self.course.drive.motions(at));
        (Mark::new(walk), result.map(|_| ()))
    }

    fn value(&self, near: &Mark, variable: Local, side: Side) -> Result<(Local, Mark), ExtremesError> {
        let (station, walk) = self.station(near.walk(), variable, side)?;
        Ok((station.finite((self.quantity)(&station)?)?, Mark::new(walk)))
    }

    fn limit(&self, closed: f64, near: &Mark, other: f64) -> Option<Limit> {
        limit_between(self.course, closed, near.walk::<M>().last?.unknowns, other)
    }

    fn edge(&self, closed: f64, open: f64) -> f64 {
        self.course.edge(closed, open)
    }
}
