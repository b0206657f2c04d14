//! A sweep and a quantity of its poses, without the type of the mechanism.
//!
//! The search for extremes, crossings, dwells and means is compiled once, in this crate. For each mechanism only its
//! functions and the quantity are compiled.

use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::TAU;

use super::branch::KnownStretch;
use super::curve::{Curve, CurveNode, StretchEnd};
use super::quantity::Named;
use super::search::FoundExtremes;
use super::station::{NamedFunctions, SweepStation};
use super::{Crossing, DwellRange, ExtremesError, Mean, Over, Peak};
use crate::failure::{Failure, SolveError};
use crate::law::Side;
use crate::number::{Number, NumberRow};
use crate::quantity::{Dimension, Name};
use crate::sweep::{
    Limit, Local, READ, SmoothDrive, SweepError, UntypedSweep, Variable, Walk, by_time, joints, limit_between,
};

/// A difference between the values on both sides of a joint, relative to them, above which it is a jump.
pub(super) const JUMP: f64 = 1e-9;

/// A quantity of a pose.
pub(crate) type PoseQuantity<'q> = dyn Fn(&SweepStation<'_>) -> Result<Local, ExtremesError> + 'q;

/// Places of a sweep.
pub(super) type JumpParameters<'q> = dyn Fn() -> Result<Vec<f64>, ExtremesError> + 'q;

/// What a search knows of a sweep.
#[derive(Clone, Copy)]
pub(super) struct SweepExtent {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) rows: usize,
    /// Whether the variable is an angle.
    pub(super) is_angle: bool,
    /// Whether the sweep is one full revolution of the only input that moves.
    pub(super) is_full_revolution: bool,
    /// Whether every block has a closed form, so that rows behind a gap close again.
    pub(super) has_assemblies: bool,
    /// The time for each unit of the variable.
    pub(super) time: f64,
}

/// The length by which the links of a block do not reach, infinite if the block fails for another reason.
#[derive(Clone, Copy)]
pub(super) struct MissingLength {
    pub(super) block: Name,
    pub(super) length: f64,
}

/// A pose of the walk along a sweep.
#[derive(Clone)]
pub(super) struct Mark<'c> {
    /// The variable of the sweep at the last pose, if there is one.
    pub(super) at: Option<f64>,
    walk: Rc<Walk<'c>>,
}

impl<'c> Mark<'c> {
    pub(super) fn new(walk: Walk<'c>) -> Self {
        Self {
            at: walk.last.as_ref().map(|last| last.at),
            walk: Rc::new(walk),
        }
    }
}

/// A quantity that is a derivative with respect to time, from which those of lower orders are found.
pub(super) struct RateOfQuantity<'c> {
    pub(super) named: Named,
    pub(super) functions: &'c dyn NamedFunctions,
}

/// A quantity along a sweep.
pub(super) struct QuantityOfSweep<'c> {
    pub(super) sweep: UntypedSweep<'c>,
    pub(super) drive: &'c dyn SmoothDrive,
    pub(super) quantity: &'c PoseQuantity<'c>,
    pub(super) rate: Option<RateOfQuantity<'c>>,
    pub(super) known: Option<KnownStretch<'c>>,
    /// Finds the parameters at which the quantity jumps, as far as its motion decides them.
    pub(super) jumps: Option<&'c JumpParameters<'c>>,
    /// Receives the part of the sweep that has been searched.
    pub(super) progress: Option<&'c dyn Fn(f64)>,
}

/// The questions.
impl QuantityOfSweep<'_> {
    pub(super) fn ask<T>(&self, question: impl Fn(&Curve<'_>) -> Result<T, ExtremesError>) -> Result<T, ExtremesError> {
        Curve::new(self).across_gaps(question)
    }

    /// The point where a measure of the value is largest.
    pub(super) fn best(&self, measure: fn(f64) -> f64) -> Result<Peak, ExtremesError> {
        self.ask(|curve| curve.best(measure))
    }

    pub(super) fn extremes(&self) -> Result<FoundExtremes, ExtremesError> {
        Curve::new(self).across_gaps(Curve::extremes)
    }

    pub(super) fn crossings(&self, level: f64) -> Result<Vec<Crossing>, ExtremesError> {
        self.ask(|curve| curve.crossings(level))
    }

    pub(super) fn dwells(&self, level: f64, tolerance: f64) -> Result<Vec<DwellRange>, ExtremesError> {
        self.ask(|curve| curve.dwells(level, tolerance))
    }

    /// The values in the rows, which are not numbers where the mechanism does not close.
    pub(super) fn column(&self) -> Result<Vec<f64>, ExtremesError> {
        let rows = self.rows(|station| (self.quantity)(station))?;
        let values = rows.into_iter().map(|row| match row {
            Ok(value) => Ok(value.real()),
            // at a limit, too, whose rates have no series
            Err(ExtremesError::Gap { .. }) => Ok(f64::NAN),
            Err(error) => Err(error),
        });
        values.collect()
    }

    /// The answer in each row; a [gap](ExtremesError::Gap) where the mechanism does not close.
    pub(super) fn rows<T>(
        &self,
        answer: impl Fn(&SweepStation<'_>) -> Result<T, ExtremesError>,
    ) -> Result<Vec<Result<T, ExtremesError>>, ExtremesError> {
        self.check()?;
        let mut mark = Mark::new(Walk::BEGINNING);
        let row = |row: usize| {
            let at = self.row(row);
            let result;
            (mark, result) = self.step(&mark, at);
            if result.is_err() {
                return Err(ExtremesError::Gap { at });
            }
            let side = if at == self.sweep.to.max(self.sweep.from) {
                Side::Left
            } else {
                Side::Right
            };
            let variable = Local::from_coefficients([at, 1.0, 0.0, 0.0, 0.0]);
            let (station, _) = self.station(&mark, variable, side)?;
            answer(&station)
        };
        Ok((0..self.sweep.count).map(row).collect())
    }

    /// The mean of a power of the quantity.
    pub(super) fn mean(&self, over: Over, power: i32) -> Result<Mean, ExtremesError> {
        self.ask(|curve| curve.mean(over, power))
    }
}

/// What a search asks.
impl<'c> QuantityOfSweep<'c> {
    /// The pose where the variable has a series, found from a pose nearby.
    pub(super) fn station(
        &self,
        near: &Mark<'c>,
        variable: Local,
        side: Side,
    ) -> Result<(SweepStation<'c>, Mark<'c>), ExtremesError> {
        let (sweep, at, rate) = (&self.sweep, variable.real(), self.sweep.drive.rate());
        let mut inputs = vec![0.0; sweep.description.inputs.len() * READ];
        self.drive.derivatives(at, side, &mut inputs);
        let orders = sweep.orders();
        let motions = NumberRow::from_fn(sweep.description.inputs.len() * orders, |index| {
            let (input, order) = (index / orders, index % orders);
            by_time(&inputs[input * READ..(input + 1) * READ], order, rate).real()
        });
        let (walk, stepped) = near.walk.stepped(sweep, at, &motions);
        let reached = stepped.ok().and(walk.last.as_ref()).ok_or(ExtremesError::Gap { at })?;
        let station = SweepStation {
            description: sweep.description,
            parameters: sweep.parameters.clone(),
            inputs,
            unknowns: reached.unknowns(),
            outputs: reached.outputs(),
            rate,
            side,
            variable,
        };
        Ok((station, Mark::new(walk)))
    }

    fn is_full_revolution(&self) -> bool {
        if let Some(known) = &self.known {
            return known.is_full_revolution;
        }
        let sweep = &self.sweep;
        let way = (sweep.to - sweep.from).abs();
        let is_revolution = (way - TAU).abs() <= 8.0 * f64::EPSILON * sweep.to.abs().max(sweep.from.abs());
        let Variable::Input(lead) = sweep.drive.variable() else {
            return false;
        };
        let mut inputs = 0..sweep.description.inputs.len();
        let is_alone = inputs.all(|input| input == lead || sweep.drive.same(input, 0).is_some());
        is_revolution && is_alone && sweep.description.inputs[lead].dimension == Dimension::Angle
    }

    pub(super) fn extent(&self) -> SweepExtent {
        let sweep = &self.sweep;
        SweepExtent {
            from: sweep.from,
            to: sweep.to,
            rows: sweep.count,
            is_angle: sweep.variable().dimension == Dimension::Angle,
            is_full_revolution: self.is_full_revolution(),
            has_assemblies: sweep.has_assemblies(),
            time: 1.0 / self.drive.rate().abs(),
        }
    }

    /// Whether the inputs can move so.
    pub(super) fn check(&self) -> Result<(), SweepError> {
        self.sweep.check()
    }

    /// The value of the variable in a row.
    pub(super) fn row(&self, row: usize) -> f64 {
        self.sweep.at(row)
    }

    /// The largest change of an angle among the inputs between two points.
    pub(super) fn rotation(&self, ends: [f64; 2]) -> f64 {
        let [start, end] = ends.map(|at| self.sweep.inputs(at));
        let inputs = self.sweep.description.inputs.iter().enumerate();
        inputs
            .filter(|(_, input)| input.dimension == Dimension::Angle)
            .fold(0.0, |most: f64, (input, _)| most.max((end[input] - start[input]).abs()))
    }

    /// The way of the first input for each unit of the variable.
    pub(super) fn way(&self, at: f64) -> f64 {
        if let Variable::Input(_) = self.drive.variable() {
            return 1.0;
        }
        let mut inputs = vec![0.0; self.sweep.description.inputs.len() * READ];
        self.drive.derivatives(at, Side::Right, &mut inputs);
        inputs.get(1).map_or(1.0, |rate| rate.abs())
    }

    /// The joints of laws between two points, in the order from the first to the second.
    pub(super) fn joints(&self, ends: [f64; 2]) -> Vec<f64> {
        joints(self.drive, ends)
    }

    /// The directions in which the quantity has no bound at a joint, upwards and downwards: a rate below it jumps
    /// there. One above a jump has the direction of the jump, and those above that have both. Another input's jump need
    /// not be one of the quantity.
    pub(super) fn impulse(&self, joint: &CurveNode<'_>) -> Result<[bool; 2], ExtremesError> {
        let (Some(rate), Some(jump)) = (&self.rate, self.drive.jump(joint.at)) else {
            return Ok([false; 2]);
        };
        let order = rate.named.order;
        let variable = Local::from_coefficients([joint.at, 1.0, 0.0, 0.0, 0.0]);
        for jumping in jump..order {
            let below = rate.named.of_order(jumping);
            let beside = |side: Side| {
                let (station, _) = self.station(&joint.mark, variable, side)?;
                Ok::<_, ExtremesError>(station.finite(below.at(rate.functions, &station)?)?.real())
            };
            let (left, right) = (beside(Side::Left)?, beside(Side::Right)?);
            // rounding errors of a quantity that does not jump with the inputs are no impulse
            if (right - left).abs() > JUMP * left.abs().max(right.abs()) {
                let rises = (right > left) == (self.sweep.to >= self.sweep.from);
                let is_higher = order > jumping + 1;
                return Ok([rises || is_higher, !rises || is_higher]);
            }
        }
        Ok([false; 2])
    }

    /// The ends of the sweep and a pose inside of it, if it is known that the mechanism closes throughout.
    pub(super) fn known(&self) -> Option<([StretchEnd; 2], Mark<'c>)> {
        self.known.as_ref().map(KnownStretch::ends)
    }

    /// The walk on to another point, and whether the mechanism closes there.
    pub(super) fn step(&self, near: &Mark<'c>, at: f64) -> (Mark<'c>, Result<(), SolveError>) {
        let (walk, result) = near.walk.stepped(&self.sweep, at, &self.sweep.motions(at));
        (Mark::new(walk), result)
    }

    /// The quantity where the variable has a series, found from a pose nearby.
    pub(super) fn value(
        &self,
        near: &Mark<'c>,
        variable: Local,
        side: Side,
    ) -> Result<(Local, Mark<'c>), ExtremesError> {
        let (station, mark) = self.station(near, variable, side)?;
        Ok((station.finite((self.quantity)(&station)?)?, mark))
    }

    /// The length that is missing for the assembly to close at a point, if it does not for this reason.
    pub(super) fn missing(&self, at: f64) -> Option<MissingLength> {
        let error = self.sweep.position(at).err()?;
        let length = match error.failure {
            Failure::OutOfReach { margin } => -margin,
            _ => f64::INFINITY,
        };
        Some(MissingLength {
            block: error.block,
            length,
        })
    }

    /// The limit on the way from a pose to another point.
    pub(super) fn limit(&self, closed: f64, near: &Mark<'_>, other: f64) -> Option<Limit> {
        limit_between(&self.sweep, closed, &near.walk.last.as_ref()?.unknowns(), other)
    }

    /// The point closest to one that does not close at which the mechanism closes.
    pub(super) fn edge(&self, closed: f64, unclosed: f64) -> f64 {
        self.sweep.edge(closed, unclosed)
    }
}
