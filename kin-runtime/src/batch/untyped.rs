//! Batches of a mechanism without its type.

use alloc::vec::Vec;

use super::{
    Batch, Column, Columns, Fold, FoldError, InputGrid, KeptMemory, LengthMismatch, Outcome, Slot, Summary, Vectors,
    Visitor,
};
use crate::any::{Described, Of};
use crate::mechanism::Mechanism;
use crate::number::Row;

/// The choice among several positions, for each row.
#[derive(Clone, Copy, Debug)]
pub enum ColumnChoice<'a> {
    /// The assembly with this index.
    Assembly(usize),
    /// The position closest to these values, one column for each unknown.
    Near(&'a [Column<'a>]),
}

/// The columns of a batch. There are at least as many as the mechanism has quantities.
#[derive(Clone, Copy, Debug)]
pub struct GivenColumns<'a> {
    /// A column for each scalar parameter.
    pub parameters: &'a [Column<'a>],
    /// For each input a column for each order, position first; missing orders are zero.
    pub inputs: &'a [&'a [Column<'a>]],
    /// The choice among several positions.
    pub choice: ColumnChoice<'a>,
}

impl<'a> GivenColumns<'a> {
    /// The columns in the rows of the mechanism.
    fn rows<M: Mechanism>(&self) -> (M::Parameters<Column<'a>>, M::Inputs<M::Motion<Column<'a>>>) {
        let inputs = M::Inputs::from_fn(|input| {
            M::Motion::from_fn(|order| self.inputs[input].get(order).copied().unwrap_or(Column::Same(0.0)))
        });
        (Row::from_fn(|index| self.parameters[index]), inputs)
    }
}

/// The numbers of the poses that are wanted, each with a slice for all rows.
#[derive(Debug, Default)]
pub struct WantedColumns<'w> {
    columns: Vec<(Slot, &'w mut [f64])>,
}

impl<'w> WantedColumns<'w> {
    /// These numbers.
    #[must_use]
    pub fn new(columns: Vec<(Slot, &'w mut [f64])>) -> Self {
        Self { columns }
    }

    pub(super) fn iter_mut(&mut self) -> impl Iterator<Item = &mut (Slot, &'w mut [f64])> {
        self.columns.iter_mut()
    }
}

impl<'w> Columns<&'w mut [f64]> for WantedColumns<'w> {
    fn each<'a>(&'a mut self, visitor: &mut impl Visitor<'a, &'w mut [f64]>)
    where
        &'w mut [f64]: 'a,
    {
        for (slot, column) in &mut self.columns {
            visitor.visit(*slot, column);
        }
    }
}

/// Batches on columns by their indices.
pub trait AnyBatch: Described {
    /// Solves a batch, as [`Batch::solve`] does. Without such an assembly, all poses fail.
    ///
    /// # Errors
    /// [`LengthMismatch`] if the length of a column differs from the number of outcomes.
    fn solve_batch(
        &self,
        given: GivenColumns<'_>,
        wanted: &mut WantedColumns<'_>,
        outcomes: &mut [Outcome],
        vectors: Vectors,
    ) -> Result<Summary, LengthMismatch>;
}

impl<M: Mechanism<Scalar = f64>> AnyBatch for Of<M> {
    fn solve_batch(
        &self,
        given: GivenColumns<'_>,
        wanted: &mut WantedColumns<'_>,
        outcomes: &mut [Outcome],
        vectors: Vectors,
    ) -> Result<Summary, LengthMismatch> {
        let (parameters, inputs) = given.rows::<M>();
        // in constants, so that only one of the two is compiled for a mechanism
        match given.choice {
            ColumnChoice::Near(near) if const { M::ASSEMBLY_COUNT == 0 } => {
                let near = Row::from_fn(|unknown| near[unknown]);
                Batch::<M, _>::near(parameters, inputs, near)
                    .vectors(vectors)
                    .solve(wanted, outcomes)
            }
            ColumnChoice::Assembly(index) if const { M::ASSEMBLY_COUNT > 0 } && index < M::ASSEMBLY_COUNT => {
                let assembly = M::assembly(index).unwrap_or_else(|| unreachable!("the index is one of an assembly"));
                Batch::<M, _>::new(parameters, inputs, assembly)
                    .vectors(vectors)
                    .solve(wanted, outcomes)
            }
            _ => {
                outcomes.fill(Outcome::Failed);
                Ok(Summary {
                    failed: outcomes.len(),
                    ..Summary::default()
                })
            }
        }
    }
}

/// Summaries of poses at evenly spaced values of an input, on columns by their indices.
pub trait AnyFold: Described {
    /// Solves the poses of a grid, and summarises some of their numbers. What is given for the position of the input
    /// with these values is not read. A mechanism that runs without rustc works faster if the memory is kept for the
    /// next call.
    ///
    /// # Errors
    /// As for [`Batch::fold`]. A coupled mechanism refuses every grid: its position is only known from values nearby.
    fn fold_batch(
        &self,
        grid: InputGrid,
        given: GivenColumns<'_>,
        folds: &mut [Fold],
        memory: &mut KeptMemory,
        vectors: Vectors,
    ) -> Result<Summary, FoldError>;
}

impl<M: Mechanism<Scalar = f64>> AnyFold for Of<M> {
    fn fold_batch(
        &self,
        grid: InputGrid,
        given: GivenColumns<'_>,
        folds: &mut [Fold],
        _: &mut KeptMemory,
        vectors: Vectors,
    ) -> Result<Summary, FoldError> {
        let (parameters, inputs) = given.rows::<M>();
        if const { M::ASSEMBLY_COUNT > 0 }
            && let ColumnChoice::Assembly(index) = given.choice
            && let Some(assembly) = M::assembly(index)
        {
            return Batch::<M, _>::new(parameters, inputs, assembly)
                .vectors(vectors)
                .fold(grid, folds);
        }
        Err(FoldError::NoSuchInput { input: grid.input })
    }
}
