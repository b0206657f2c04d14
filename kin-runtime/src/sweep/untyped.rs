//! A sweep without the type of its mechanism.
//!
//! The walk from pose to pose, and all that stands on it, is compiled once, in this crate.

use alloc::vec::Vec;

use super::columns::{Heading, labels};
use super::drive::{Drive, SmoothDrive, Variable};
use super::table::Table;
use super::{Sweep, SweepError, row_at};
use crate::any::{AssemblyChoice, MotionOver, Of, PositionChoice, description};
use crate::curve::CurveFunctions;
use crate::failure::SolveError;
use crate::mechanism::{Description, Mechanism};
use crate::number::NumberRow;
use crate::quantity::{Dimension, Name, NameKind, Quantity};

/// The halvings that find the edge of a gap. Angles there differ from those at the limit by some 10⁻⁵.
const EDGE: usize = 32;

/// What a sweep needs of its mechanism.
pub trait SweptMechanism: CurveFunctions + MotionOver<f64> {}

impl<M: Mechanism<Scalar = f64>> SweptMechanism for Of<M> {}

/// The joints of laws between two points, in the order from the first to the second.
pub(crate) fn joints(drive: &dyn SmoothDrive, ends: [f64; 2]) -> Vec<f64> {
    let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
    let next = |after: f64| drive.next_joint(after).filter(|joint| *joint < high);
    let mut joints: Vec<f64> = core::iter::successors(next(low), |joint| next(*joint)).collect();
    if ends[0] > ends[1] {
        joints.reverse();
    }
    joints
}

/// A sweep without types.
#[derive(Clone)]
pub struct UntypedSweep<'c> {
    pub(crate) mechanism: &'c dyn SweptMechanism,
    pub(crate) description: &'c Description<'c>,
    pub(crate) parameters: NumberRow,
    pub(crate) assembly: AssemblyChoice,
    pub(crate) drive: &'c dyn Drive,
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) count: usize,
}

impl<M: Mechanism<Scalar = f64>, D: Drive> Sweep<M, D> {
    /// This sweep without types.
    pub(crate) fn any(&self) -> UntypedSweep<'_> {
        UntypedSweep {
            mechanism: Of::<M>::FUNCTIONS,
            description: description::<M>(),
            parameters: self.mechanism.parameters().as_ref().into(),
            assembly: AssemblyChoice::of::<M>(self.assembly),
            drive: &self.drive,
            from: self.from,
            to: self.to,
            count: self.count,
        }
    }
}

impl<'c> UntypedSweep<'c> {
    /// The number of orders of a motion, that of the value included.
    pub(crate) fn orders(&self) -> usize {
        self.description.order + 1
    }

    /// The value of the variable in a row.
    pub(crate) fn at(&self, row: usize) -> f64 {
        row_at([self.from, self.to], self.count, row)
    }

    /// The motions of the inputs, one after the other.
    pub(crate) fn motions(&self, at: f64) -> NumberRow {
        let mut motions = NumberRow::splat(self.description.inputs.len() * self.orders(), 0.0);
        self.drive.motions(at, self.orders(), &mut motions);
        motions
    }

    /// The values of the inputs.
    pub(crate) fn inputs(&self, at: f64) -> NumberRow {
        let mut inputs = NumberRow::splat(self.description.inputs.len(), 0.0);
        self.drive.motions(at, 1, &mut inputs);
        inputs
    }

    /// The values in the motions of the inputs.
    pub(super) fn values(&self, motions: &[f64]) -> NumberRow {
        let orders = self.orders();
        NumberRow::from_fn(self.description.inputs.len(), |input| motions[input * orders])
    }

    /// Whether every block has a closed form, so that each row finds the assembly by itself.
    pub(crate) fn has_assemblies(&self) -> bool {
        self.assembly.index().is_some()
    }

    /// The motions of inputs, unknowns and outputs at given motions of the inputs, in the assembly of the sweep.
    /// `numbers` is memory to use again.
    pub(super) fn solved(&self, motions: &[f64], numbers: Vec<f64>) -> Result<Vec<f64>, SolveError> {
        self.solve(motions, self.assembly.position(), numbers)
    }

    /// [`solved`](Self::solved), in the position that is closest to values of the unknowns.
    pub(super) fn solved_near(&self, motions: &[f64], near: &[f64], numbers: Vec<f64>) -> Result<Vec<f64>, SolveError> {
        self.solve(motions, PositionChoice::Near(near), numbers)
    }

    fn solve(
        &self,
        motions: &[f64],
        choice: PositionChoice<'_, f64>,
        mut numbers: Vec<f64>,
    ) -> Result<Vec<f64>, SolveError> {
        let Description { unknowns, outputs, .. } = self.description;
        let results = (unknowns.len() + outputs.len()) * self.orders();
        numbers.resize(motions.len() + results, 0.0);
        let (inputs, results) = numbers.split_at_mut(motions.len());
        inputs.copy_from_slice(motions);
        let (unknowns, outputs) = results.split_at_mut(unknowns.len() * self.orders());
        self.mechanism
            .motion(&self.parameters, motions, choice, unknowns, outputs)?;
        Ok(numbers)
    }

    /// The unknowns of the assembly at a point.
    pub(crate) fn position(&self, at: f64) -> Result<NumberRow, SolveError> {
        let mut unknowns = NumberRow::splat(self.description.unknowns.len(), 0.0);
        let (inputs, choice) = (self.inputs(at), self.assembly.position());
        self.mechanism
            .position(&self.parameters, &inputs, choice, &mut unknowns)?;
        Ok(unknowns)
    }

    /// Whether the mechanism closes at a point.
    pub(super) fn closes(&self, at: f64) -> bool {
        self.position(at).is_ok()
    }

    /// The last point at which the mechanism closes, from one that closes to one that does not.
    pub(crate) fn edge(&self, mut closed: f64, mut unclosed: f64) -> f64 {
        for _ in 0..EDGE {
            let middle = f64::midpoint(closed, unclosed);
            if self.closes(middle) {
                closed = middle;
            } else {
                unclosed = middle;
            }
        }
        closed
    }

    /// Whether the inputs can move so.
    pub(crate) fn check(&self) -> Result<(), SweepError> {
        if self.count == 0 {
            return Err(SweepError::NoRows);
        }
        for (quantity, value) in [("start", self.from), ("end", self.to)] {
            if !value.is_finite() {
                return Err(SweepError::NotFinite { quantity, value });
            }
        }
        self.drive
            .check([self.from.min(self.to), self.from.max(self.to)], self.count)
    }

    /// A table of zeros.
    pub(super) fn empty(&self, count: usize) -> Table {
        let variable = self.drive.variable();
        let column = match variable {
            Variable::Input(input) => input * self.orders(),
            _ => 0,
        };
        let labels = labels(self.description, variable).map(Heading::from);
        Table::new(labels.collect(), count, column)
    }

    /// The name and the dimension of the variable.
    pub(crate) fn variable(&self) -> Quantity<'c> {
        self.drive.variable().of(self.description)
    }

    /// The name of the variable in errors.
    pub(crate) fn variable_name(&self) -> Name {
        match self.drive.variable() {
            Variable::Input(input) => self.mechanism.name(NameKind::Input, input),
            Variable::Time => "time".into(),
            Variable::Row => "row".into(),
        }
    }

    /// The name in errors of the quantity to which a column belongs, counted from the first input.
    pub(super) fn name_of(&self, column: usize) -> Name {
        let Description { inputs, unknowns, .. } = self.description;
        let (of, index) = match column / self.orders() {
            input if input < inputs.len() => (NameKind::Input, input),
            index if index - inputs.len() < unknowns.len() => (NameKind::Unknown, index - inputs.len()),
            index => (NameKind::Output, index - inputs.len() - unknowns.len()),
        };
        self.mechanism.name(of, index)
    }
}

/// The indices of the quantities that are angles.
pub(super) fn angles(quantities: &[Quantity<'_>]) -> impl Iterator<Item = usize> {
    let is_angle =
        |(index, quantity): (usize, &Quantity<'_>)| (quantity.dimension == Dimension::Angle).then_some(index);
    quantities.iter().enumerate().filter_map(is_angle)
}
