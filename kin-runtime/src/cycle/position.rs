//! Positions and poses on the branches of a cycle.

use alloc::vec::Vec;
use core::f64::consts::PI;

use num_traits::Float;

use super::{Branch, Cycle, EndKind, SearchedCycle};
use crate::any::{PositionChoice, motions, row};
use crate::failure::{Failure, InputValues, SolveError};
use crate::mechanism::Mechanism;
use crate::number::NumberRow;
use crate::sweep::Drive;
use crate::track::TrackError;

/// The distance by which an input may lie outside of its branch because of rounding, as a part of the largest input.
const BESIDE: f64 = 64.0 * f64::EPSILON;

impl<M: Mechanism<Scalar = f64>> Cycle<M> {
    /// The unknowns of a branch at an input of its range, with the angles unwrapped along the branch. An input may be
    /// whole [periods](super::CycleData::period) beside the range.
    ///
    /// # Errors
    /// [`Failure::OutOfRange`] if the input lies outside the branch, with the range of the branch, and the errors of
    /// the solver: the input lies at an end of the branch.
    pub fn position_on(&self, branch: usize, input: f64) -> Result<M::Unknowns<f64>, SolveError> {
        self.searched.position_on(branch, input).map(|found| row(&found))
    }

    /// The pose of a branch at an input, with all derivatives with respect to the input.
    ///
    /// # Errors
    /// The errors of [`position_on`](Self::position_on).
    pub fn pose_on(&self, branch: usize, input: f64) -> Result<M::Pose, SolveError> {
        let near = self.position_on(branch, input)?;
        let values = self.inputs(input);
        let orders = M::DESCRIPTION.order + 1;
        let mut given = NumberRow::splat(M::DESCRIPTION.inputs.len() * orders, 0.0);
        self.searched.line.motions(input, orders, &mut given);
        let motions = motions(&given);
        match self.assembly_of(branch) {
            Some(assembly) if self.mechanism.assembly_at(values, near) != assembly => {
                self.mechanism.solve(motions, assembly)
            }
            _ => self.mechanism.solve_near(motions, near),
        }
    }
}

impl SearchedCycle<'_> {
    pub(crate) fn position_on(&self, branch: usize, input: f64) -> Result<NumberRow, SolveError> {
        let failed = |failure: Failure| {
            let names = InputValues::of(self.mechanism.functions.input_names(), &self.line.inputs(input));
            let block = self.mechanism.block_name(0);
            failure.at(block, names)
        };
        let none = || failed(Failure::not_finite("branch"));
        let branch_data = self.data.branches.get(branch).ok_or_else(none)?;
        let input = self.coordinate_on(branch_data, input).map_err(failed)?;
        let inputs = self.line.inputs(input);
        let inner = branch_data.samples.iter().filter(|(s, _)| {
            let is_end = [0, 1]
                .map(|end| branch_data.ends[end].kind != EndKind::FullRevolution && branch_data.ends[end].input == *s);
            is_end == [false, false]
        });
        let closest = |one: &&(f64, Vec<f64>), other: &&(f64, Vec<f64>)| {
            (one.0 - input).abs().total_cmp(&(other.0 - input).abs())
        };
        let sample = inner.min_by(closest).or(branch_data.samples.iter().min_by(closest));
        let (s, near) = sample.ok_or_else(none)?;
        let sought = &self.mechanism;
        let found = match branch_data.assembly {
            Some(assembly) => {
                let solved = sought.position(&inputs, PositionChoice::Assembly(assembly))?;
                let unknowns = sought.nearest(&solved, near);
                let mut pairs = unknowns.iter().zip(solved.iter());
                if pairs.any(|(unwrapped, solved)| (unwrapped - solved).abs() > PI) {
                    // what depends on an angle itself, as the position of a rack does, depends on its revolution
                    let unwrapped = sought.position(&inputs, PositionChoice::Near(&unknowns)).ok();
                    let unwrapped =
                        unwrapped.filter(|unwrapped| sought.assembly_at(&inputs, unwrapped) == Some(assembly));
                    unwrapped.map_or_else(|| unknowns.clone(), |unwrapped| sought.nearest(&unwrapped, &unknowns))
                } else {
                    unknowns
                }
            }
            None => sought
                .track(&self.line.inputs(*s), near, &inputs)
                .map_err(|error| match error {
                    TrackError::Failed(error) => error,
                    _ => none(),
                })?,
        };
        Ok(found)
    }

    /// The coordinate of an input in the range of a branch, which may be whole periods away from it.
    fn coordinate_on(&self, branch: &Branch, input: f64) -> Result<f64, Failure> {
        let [low, high] = branch.ends.each_ref().map(|end| end.input);
        let slack = BESIDE * low.abs().max(high.abs());
        let contains = |s: &f64| *s >= low - slack && *s <= high + slack;
        if branch.is_full_revolution() || contains(&input) {
            return Ok(input);
        }
        let shifted = self.line.period().map(|period| {
            let periods = Float::ceil((low - slack - input) / period);
            input + periods * period
        });
        shifted.filter(contains).ok_or(Failure::OutOfRange {
            unknown: "the input of the branch".into(),
            value: input,
            low,
            high,
            is_angle: self.line.is_angle,
        })
    }
}
