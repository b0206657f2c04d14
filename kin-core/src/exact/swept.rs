//! Tables over an input or over time, in one assembly.

use alloc::boxed::Box;
use alloc::string::ToString as _;
use alloc::vec::Vec;
use core::f64::consts::TAU;

use num_traits::Float;

use super::ExactTableError;
use super::owned::ExactTable;
use super::precision::Precision;
use super::refine::{Frame, Source, Station, refined};
use crate::law::Side;
use crate::mechanism::{Mechanism, Pose};
use crate::number::Row;
use crate::quantity::{Dimension, Quantity};
use crate::sweep::{Course, Reached, SmoothDrive, Variable, Walk};

/// The largest number of turns of an input after which a motion is looked upon as closed.
const MOST_TURNS: u32 = 12;

/// The distance of two places that differ by rounding errors alone, as a part of the range's largest number.
const CLOSE: f64 = 16.0 * f64::EPSILON;

/// A sweep as a motion over its variable.
struct Swept<'c, M: Mechanism<Scalar = f64>, D> {
    course: &'c Course<M, D>,
    count: usize,
}

impl<M: Mechanism<Scalar = f64>, D: SmoothDrive<M>> Swept<'_, M, D> {
    /// The inputs that move and are not the parameter themselves.
    fn inputs(&self) -> impl Iterator<Item = usize> {
        let variable = self.course.drive.variable();
        let is_own = move |input: usize| variable == Variable::Input(input);
        (0..M::DESCRIPTION.inputs.len())
            .filter(move |input| !is_own(*input) && self.course.drive.same(*input, 0).is_none())
    }

    fn found(&self, at: f64, side: Side, from: Option<&Station<Walk<M>>>) -> Result<Station<Walk<M>>, ExactTableError> {
        let inputs = self.course.drive.derivatives(at, side);
        let motions = Row::from_fn(|input| Row::from_fn(|order| inputs[input][order]));
        let mut walk = from.map_or(Walk::BEGINNING, |station| station.near);
        let reached = walk
            .step(self.course, at, motions)
            .map_err(|error| ExactTableError::NotClosed {
                at,
                error: Box::new(error),
            })?;
        let mut numbers = Vec::new();
        for input in self.inputs() {
            numbers.extend((0..self.count).map(|order| inputs[input][order]));
        }
        let Reached { pose, footing, .. } = reached;
        for (unknown, motion) in pose.unknown_motions().as_ref().iter().enumerate() {
            numbers.push(footing.unknowns[unknown]);
            numbers.extend(&motion.as_ref()[1..self.count]);
        }
        for (output, motion) in pose.output_motions().as_ref().iter().enumerate() {
            numbers.push(footing.outputs[output]);
            numbers.extend(&motion.as_ref()[1..self.count]);
        }
        Ok(Station {
            at,
            numbers,
            near: walk,
        })
    }
}

impl<M: Mechanism<Scalar = f64>, D: SmoothDrive<M>> Source for Swept<'_, M, D> {
    type Near = Walk<M>;

    fn columns(&self) -> Vec<Quantity> {
        let description = M::DESCRIPTION;
        let inputs = self.inputs().map(|input| description.inputs[input]);
        inputs
            .chain(description.unknowns.iter().copied())
            .chain(description.outputs.iter().copied())
            .collect()
    }

    fn station(&self, at: f64, side: Side, from: &Station<Walk<M>>) -> Result<Station<Walk<M>>, ExactTableError> {
        self.found(at, side, Some(from))
    }
}

impl<M: Mechanism<Scalar = f64>, D: SmoothDrive<M>> Course<M, D> {
    /// The motion as an [`ExactTable`]: a table from which every place of the range can be read, in all orders, to a tolerance.
    ///
    /// The parameter of the table is the variable of the sweep, whatever its speed. The columns are the inputs that move with it, the
    /// unknowns and the outputs. The rows of the sweep are there, and as many between them as it takes until all pieces agree with `solve`
    /// in every order, at a third, the middle and two thirds. A sweep with few rows makes the smallest table. If the input makes full turns
    /// and the motion repeats itself, so does the table.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let turn = linkage.sweep(Assembly::Open).over(0.0..=TAU, 13);
    /// // one tolerance for all orders
    /// let table = turn.exact_table(1e-7)?;
    /// let [angle, velocity, acceleration, jerk, snap] = table.column("theta4")?.at(1.0)?;
    /// # let pose = linkage.solve([1.0, 1.0, 0.0, 0.0, 0.0], Assembly::Open)?;
    /// # assert!((snap - pose.theta4.snap()).abs() < 1e-6 && (angle - pose.theta4.position()).abs() < 1e-8);
    ///
    /// // one for each order, up to the acceleration
    /// let table = turn.exact_table([1e-13, 1e-11, 1e-9])?;
    /// for column in table.columns() {
    ///     println!("{}: {:.0e} rad", column.name(), column.errors().next().unwrap());
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ExactTableError::NotClosed`] if the mechanism does not close at a place of the range, [`ExactTableError::Unreached`] if a
    /// tolerance cannot be reached, and the errors of the sweep and of the tolerances themselves.
    pub fn exact_table(&self, precision: impl Into<Precision>) -> Result<ExactTable, ExactTableError> {
        let precision = precision.into();
        self.check()?;
        if self.from == self.to {
            return Err(ExactTableError::NoRange { at: self.from });
        }
        let order = precision.order_of::<M>()?;
        let source = Swept {
            course: self,
            count: order + 1,
        };
        let runs_up = self.from < self.to;
        let [start, end] = if runs_up {
            [Side::Right, Side::Left]
        } else {
            [Side::Left, Side::Right]
        };
        let (low, high) = (self.from.min(self.to), self.from.max(self.to));
        let close = CLOSE * low.abs().max(high.abs());
        let is_end = |place: f64| (place - low).abs() <= close || (high - place).abs() <= close;
        let (beside_ends, joints): (Vec<f64>, Vec<f64>) =
            self.joints([low, high]).into_iter().partition(|joint| is_end(*joint));
        // A row that rounding puts beside a joint stands for it. The ends of the range stay, with the piece of the law that the joint ends.
        let near = |place: f64, joints: &[f64]| joints.iter().copied().find(|joint| (joint - place).abs() <= close);
        let rows = (0..self.count.max(2)).map(|row| self.at(row));
        let mut places: Vec<f64> = rows.filter(|row| near(*row, &joints).is_none()).collect();
        places.extend(&joints);
        places.sort_by(f64::total_cmp);
        places.dedup();
        if !runs_up {
            places.reverse();
        }
        let seen_at = |place: f64, side: Side, from: Option<&Station<Walk<M>>>| {
            let found = source.found(near(place, &beside_ends).unwrap_or(place), side, from);
            found.map(|station| Station { at: place, ..station })
        };
        let mut first = Vec::with_capacity(places.len());
        let mut left = seen_at(places[0], start, None)?;
        for place in places.into_iter().skip(1) {
            let right = seen_at(place, end, Some(&left))?;
            let next = if joints.contains(&place) {
                source.found(place, start, Some(&right))?
            } else {
                right.clone()
            };
            first.push([left, right]);
            left = next;
        }
        let variable = self.drive.variable();
        let quantity = variable.quantity::<M>();
        let frame = Frame {
            name: M::DESCRIPTION.name,
            parameter: (quantity.name.to_string(), quantity.dimension),
            order,
            may_close: quantity.dimension == Dimension::Angle && is_turn(high - low),
        };
        refined(&source, frame, first, precision)
    }
}

/// Whether a range is a number of full turns.
fn is_turn(range: f64) -> bool {
    let turns = Float::round(range / TAU);
    let is_whole = (range - turns * TAU).abs() <= 16.0 * f64::EPSILON * range;
    is_whole && turns >= 1.0 && turns <= f64::from(MOST_TURNS)
}
