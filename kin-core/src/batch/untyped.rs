//! Batches of a mechanism without its type.

use alloc::vec;
use alloc::vec::Vec;

use super::{Batch, Column, Columns, Fold, FoldError, LengthMismatch, Outcome, Place, Summary, Turn, Vectors, Visitor};
use crate::any::{Described, MotionOver, Of, PositionChoice};
use crate::failure::SolveError;
use crate::mechanism::Mechanism;
use crate::number::Row;
use crate::quantity::NameKind;

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
    columns: Vec<(Place, &'w mut [f64])>,
}

impl<'w> WantedColumns<'w> {
    /// These numbers.
    #[must_use]
    pub fn new(columns: Vec<(Place, &'w mut [f64])>) -> Self {
        Self { columns }
    }
}

impl<'w> Columns<&'w mut [f64]> for WantedColumns<'w> {
    fn each<'a>(&'a mut self, visitor: &mut impl Visitor<'a, &'w mut [f64]>)
    where
        &'w mut [f64]: 'a,
    {
        for (place, column) in &mut self.columns {
            visitor.visit(*place, column);
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

/// [`AnyBatch::solve_batch`] pose by pose, for a mechanism without lanes. The columns of sines stay as they are: its directions are angles.
///
/// # Errors
/// As there.
pub fn solve_each(
    mechanism: &(impl Described + MotionOver<f64>),
    given: GivenColumns<'_>,
    wanted: &mut WantedColumns<'_>,
    outcomes: &mut [Outcome],
) -> Result<Summary, LengthMismatch> {
    let description = mechanism.description();
    let (count, orders) = (outcomes.len(), description.order + 1);
    let near = match given.choice {
        ColumnChoice::Assembly(_) => &[],
        ColumnChoice::Near(near) => near,
    };
    let fits = |of: NameKind, index: usize, length: Option<usize>| match length {
        Some(length) if length != count => Err(LengthMismatch {
            quantity: mechanism.name(of, index),
            poses: count,
            length,
        }),
        _ => Ok(()),
    };
    for (index, column) in given.parameters.iter().enumerate() {
        fits(NameKind::Parameter, index, column.length())?;
    }
    for (index, columns) in given.inputs.iter().enumerate() {
        for column in *columns {
            fits(NameKind::Input, index, column.length())?;
        }
    }
    for (index, column) in near.iter().enumerate() {
        fits(NameKind::Unknown, index, column.length())?;
    }
    for (place, column) in &wanted.columns {
        let (of, index) = match place {
            Place::Input(index, _) => (NameKind::Input, *index),
            Place::Unknown(index, _) | Place::Sine(index) => (NameKind::Unknown, *index),
            Place::Output(index, _) => (NameKind::Output, *index),
        };
        fits(of, index, Some(column.len()))?;
    }
    let mut inputs = vec![0.0; description.inputs.len() * orders];
    let [mut unknowns, mut outputs] =
        [description.unknowns, description.outputs].map(|all| vec![0.0; all.len() * orders]);
    let mut summary = Summary {
        solved: count,
        ..Summary::default()
    };
    for (row, outcome) in outcomes.iter_mut().enumerate() {
        let at = |columns: &[Column<'_>]| columns.iter().map(|column| column.at(row)).collect::<Vec<f64>>();
        for (motion, columns) in inputs.chunks_exact_mut(orders).zip(given.inputs) {
            for (order, number) in motion.iter_mut().enumerate() {
                *number = columns.get(order).map_or(0.0, |column| column.at(row));
            }
        }
        let near = at(near);
        let choice = match given.choice {
            ColumnChoice::Assembly(index) => PositionChoice::Assembly(index),
            ColumnChoice::Near(_) => PositionChoice::Near(&near),
        };
        let found: Result<(), SolveError> =
            mechanism.motion(&at(given.parameters), &inputs, choice, &mut unknowns, &mut outputs);
        *outcome = summary.note(row, found);
        for (place, column) in &mut wanted.columns {
            let number = match *place {
                Place::Input(index, order) => inputs[index * orders + order],
                Place::Sine(_) => continue,
                _ if !outcome.is_solved() => f64::NAN,
                Place::Unknown(index, order) => unknowns[index * orders + order],
                Place::Output(index, order) => outputs[index * orders + order],
            };
            column[row] = number;
        }
    }
    Ok(summary)
}

/// Summaries of the poses of a turn, on columns by their indices.
pub trait AnyFold: Described {
    /// Solves the poses of a turn, and summarises some of their numbers. What is given for the position of the input that turns is not read.
    ///
    /// # Errors
    /// As for [`Batch::fold`]. A coupled mechanism has no turn: its position is only known from values nearby.
    fn fold_batch(
        &self,
        turn: Turn,
        given: GivenColumns<'_>,
        folds: &mut [Fold],
        vectors: Vectors,
    ) -> Result<Summary, FoldError>;
}

impl<M: Mechanism<Scalar = f64>> AnyFold for Of<M> {
    fn fold_batch(
        &self,
        turn: Turn,
        given: GivenColumns<'_>,
        folds: &mut [Fold],
        vectors: Vectors,
    ) -> Result<Summary, FoldError> {
        let (parameters, inputs) = given.rows::<M>();
        if const { M::ASSEMBLY_COUNT > 0 }
            && let ColumnChoice::Assembly(index) = given.choice
            && let Some(assembly) = M::assembly(index)
        {
            return Batch::<M, _>::new(parameters, inputs, assembly)
                .vectors(vectors)
                .fold(turn, folds);
        }
        Err(FoldError::NoSuchInput {
            mechanism: M::DESCRIPTION.name,
            input: turn.input,
        })
    }
}
