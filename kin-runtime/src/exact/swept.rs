//! Tables over an input or over time, in one assembly.

use alloc::boxed::Box;
use alloc::string::ToString as _;
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::TAU;

use num_traits::Float;

use super::ExactTableError;
use super::owned::ExactTable;
use super::precision::Precision;
use super::refine::{Frame, Source, Station, refined};
use crate::law::Side;
use crate::mechanism::Mechanism;
use crate::number::NumberRow;
use crate::quantity::{Dimension, Quantity};
use crate::sweep::{READ, SmoothDrive, Sweep, UntypedSweep, Variable, Walk, joints};

/// The largest number of revolutions of an input after which a motion is looked upon as closed.
const MOST_REVOLUTIONS: u32 = 12;

/// The distance of two parameters that differ by rounding errors alone, as a part of the range's largest number.
const SAME_PARAMETER: f64 = 16.0 * f64::EPSILON;

/// A sweep as a motion over its variable.
struct Swept<'c> {
    sweep: UntypedSweep<'c>,
    drive: &'c dyn SmoothDrive,
    count: usize,
}

impl<'c> Swept<'c> {
    /// The inputs that move and are not the parameter themselves.
    fn inputs(&self) -> impl Iterator<Item = usize> {
        let variable = self.sweep.drive.variable();
        let is_own = move |input: usize| variable == Variable::Input(input);
        (0..self.sweep.description.inputs.len())
            .filter(move |input| !is_own(*input) && self.sweep.drive.same(*input, 0).is_none())
    }

    fn found(
        &self,
        at: f64,
        side: Side,
        from: Option<&Station<Walk<'c>>>,
    ) -> Result<Station<Walk<'c>>, ExactTableError> {
        let (sweep, orders) = (&self.sweep, self.sweep.orders());
        let inputs = sweep.description.inputs.len();
        let mut derivatives = vec![0.0; inputs * READ];
        self.drive.derivatives(at, side, &mut derivatives);
        let motions = NumberRow::from_fn(inputs * orders, |index| {
            derivatives[index / orders * READ + index % orders]
        });
        let beginning = Walk::BEGINNING;
        let walk = from.map_or(&beginning, |station| &station.near);
        let (walk, result) = walk.stepped(sweep, at, &motions);
        result.map_err(|error| ExactTableError::NotClosed {
            at,
            error: Box::new(error),
        })?;
        let mut numbers = Vec::new();
        if let Some(reached) = &walk.last {
            let inputs = self.inputs().map(|input| reached.motion(input));
            for motion in inputs.chain(reached.results()) {
                numbers.extend_from_slice(&motion[..self.count]);
            }
        }
        Ok(Station {
            at,
            numbers,
            near: walk,
        })
    }
}

impl<'c> Source for Swept<'c> {
    type Near = Walk<'c>;

    fn columns(&self) -> Vec<Quantity<'_>> {
        let description = self.sweep.description;
        let inputs = self.inputs().map(|input| description.inputs[input]);
        inputs
            .chain(description.unknowns.iter().copied())
            .chain(description.outputs.iter().copied())
            .collect()
    }

    fn station(&self, at: f64, side: Side, from: &Station<Walk<'c>>) -> Result<Station<Walk<'c>>, ExactTableError> {
        self.found(at, side, Some(from))
    }
}

impl<M: Mechanism<Scalar = f64>, D: SmoothDrive> Sweep<M, D> {
    /// The motion as an [`ExactTable`]: a table that can be read everywhere in the range, in all orders, to a
    /// tolerance.
    ///
    /// The parameter of the table is the variable of the sweep, whatever its speed. The columns are the inputs that
    /// move with it, the unknowns and the outputs. The rows of the sweep are there, and as many between them as it
    /// takes until all pieces agree with `solve` in every order, at a third, the middle and two thirds. A sweep with
    /// few rows makes the smallest table. If the input makes full revolutions and the motion repeats itself, so does
    /// the table.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 13);
    /// // one tolerance for all orders
    /// let table = sweep.exact_table(1e-7)?;
    /// let [angle, velocity, acceleration, jerk, snap] = table.column("theta4")?.at(1.0)?;
    /// # let pose = linkage.solve([1.0, 1.0, 0.0, 0.0, 0.0], Assembly::Open)?;
    /// # assert!((snap - pose.theta4.snap()).abs() < 1e-6 && (angle - pose.theta4.position()).abs() < 1e-8);
    ///
    /// // one for each order, up to the acceleration
    /// let table = sweep.exact_table([1e-13, 1e-11, 1e-9])?;
    /// for column in table.columns() {
    ///     println!("{}: {:.0e} rad", column.name(), column.errors().next().unwrap());
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ExactTableError::NotClosed`] if the mechanism does not close somewhere in the range,
    /// [`ExactTableError::Unreached`] if a tolerance cannot be reached, and the errors of the sweep and of the
    /// tolerances themselves.
    pub fn exact_table(&self, precision: impl Into<Precision>) -> Result<ExactTable, ExactTableError> {
        exact_table(self.any(), &self.drive, precision.into())
    }
}

/// A sweep as an exact table.
pub(crate) fn exact_table(
    sweep: UntypedSweep<'_>,
    drive: &dyn SmoothDrive,
    precision: Precision,
) -> Result<ExactTable, ExactTableError> {
    let swept = Swept { sweep, drive, count: 0 };
    swept.table(precision)
}

impl<'c> Swept<'c> {
    fn table(mut self, precision: Precision) -> Result<ExactTable, ExactTableError> {
        self.sweep.check()?;
        let [from, to] = [self.sweep.from, self.sweep.to];
        if from == to {
            return Err(ExactTableError::NoRange { at: from });
        }
        let order = precision.order_of(self.sweep.description)?;
        self.count = order + 1;
        let runs_up = from < to;
        let [start, end] = if runs_up {
            [Side::Right, Side::Left]
        } else {
            [Side::Left, Side::Right]
        };
        let (low, high) = (from.min(to), from.max(to));
        let close = SAME_PARAMETER * low.abs().max(high.abs());
        let is_end = |at: f64| (at - low).abs() <= close || (high - at).abs() <= close;
        let (beside_ends, joints): (Vec<f64>, Vec<f64>) = joints(self.drive, [low, high])
            .into_iter()
            .partition(|joint| is_end(*joint));
        // A row that rounding puts beside a joint stands for it. The ends of the range stay, with the piece of the law
        // that the joint ends.
        let near = |at: f64, joints: &[f64]| joints.iter().copied().find(|joint| (joint - at).abs() <= close);
        let rows = (0..self.sweep.count.max(2)).map(|row| self.sweep.at(row));
        let mut parameters: Vec<f64> = rows.filter(|row| near(*row, &joints).is_none()).collect();
        parameters.extend(&joints);
        parameters.sort_by(f64::total_cmp);
        parameters.dedup();
        if !runs_up {
            parameters.reverse();
        }
        let seen_at = |at: f64, side: Side, from: Option<&Station<Walk<'c>>>| {
            let found = self.found(near(at, &beside_ends).unwrap_or(at), side, from);
            found.map(|station| Station { at, ..station })
        };
        let mut first = Vec::with_capacity(parameters.len());
        let mut left = seen_at(parameters[0], start, None)?;
        for at in parameters.into_iter().skip(1) {
            let right = seen_at(at, end, Some(&left))?;
            let next = if joints.contains(&at) {
                self.found(at, start, Some(&right))?
            } else {
                right.clone()
            };
            first.push([left, right]);
            left = next;
        }
        let quantity = self.sweep.variable();
        let frame = Frame {
            name: self.sweep.description.name.to_string(),
            parameter: (quantity.name.to_string(), quantity.dimension),
            order,
            may_close: quantity.dimension == Dimension::Angle && is_revolution(high - low),
        };
        refined(&self, frame, first, precision)
    }
}

/// Whether a range is a number of full revolutions.
fn is_revolution(range: f64) -> bool {
    let revolutions = Float::round(range / TAU);
    let is_whole = (range - revolutions * TAU).abs() <= 16.0 * f64::EPSILON * range;
    is_whole && revolutions >= 1.0 && revolutions <= f64::from(MOST_REVOLUTIONS)
}
