//! The solver of a mechanism of any type, with its columns by index.

use std::fmt;
use std::marker::PhantomData;

use kin_core::batch::{
    self, Column, Columns, Fold, FoldError, LengthMismatch, Outcome, Place, Summary, Turn, Vectors, Visitor,
};
use kin_core::{Description, Mechanism, Row};

/// The choice among several positions, for each row.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Choice<'a> {
    /// The assembly with this index.
    Assembly(usize),
    /// The position closest to these values, one column for each unknown.
    Near(&'a [Column<'a>]),
}

impl<'a> Choice<'a> {
    fn assembly(self) -> usize {
        match self {
            Self::Assembly(index) => index,
            Self::Near(_) => 0,
        }
    }

    fn near(self, unknown: usize) -> Column<'a> {
        match self {
            Self::Near(columns) => columns[unknown],
            Self::Assembly(_) => Column::Same(f64::NAN),
        }
    }
}

/// The columns of a batch. There are at least as many as the mechanism has quantities.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Given<'a> {
    /// A column for each scalar parameter.
    pub(crate) parameters: &'a [Column<'a>],
    /// For each input a column for each order, position first; missing orders are zero.
    pub(crate) inputs: &'a [&'a [Column<'a>]],
    /// The choice among several positions.
    pub(crate) choice: Choice<'a>,
}

/// The numbers of a pose that are wanted, each with a place for all rows.
pub(crate) struct Wanted<'w> {
    places: Vec<(Place, &'w mut [f64])>,
}

impl<'w> Wanted<'w> {
    pub(crate) fn new(places: Vec<(Place, &'w mut [f64])>) -> Self {
        Self { places }
    }
}

impl<'w> Columns<&'w mut [f64]> for Wanted<'w> {
    fn each<'a>(&'a mut self, visitor: &mut impl Visitor<'a, &'w mut [f64]>)
    where
        &'w mut [f64]: 'a,
    {
        for (place, slice) in &mut self.places {
            visitor.visit(*place, slice);
        }
    }
}

/// What the functions of SQL need of a type of mechanism. It is as thin as possible, because it is compiled for each type.
pub(crate) trait Solver: Send + Sync {
    /// The mechanism's quantities.
    fn description(&self) -> &'static Description;

    /// The assemblies as text, such as `open` or `alpha=open,knee=crossed`. There are none if a position is chosen by values
    /// nearby, and one without letters if there is no choice.
    fn assemblies(&self) -> Vec<String>;

    /// Solves a batch.
    fn solve(
        &self,
        given: Given<'_>,
        wanted: &mut Wanted<'_>,
        outcomes: &mut [Outcome],
        vectors: Vectors,
    ) -> Result<(), LengthMismatch>;

    /// The number of dyads that have a transmission angle.
    fn dyads(&self) -> usize;

    /// Solves the poses of a turn, and summarises some of their numbers. What is given for the position of the input that turns
    /// is not read.
    fn fold(&self, turn: Turn, given: Given<'_>, folds: &mut [Fold], vectors: Vectors) -> Result<Summary, FoldError>;
}

/// The solver of the mechanism `M`.
pub(crate) struct Of<M>(PhantomData<fn() -> M>);

impl<M> Of<M> {
    pub(crate) const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<M: Mechanism<Scalar = f64> + 'static> Solver for Of<M> {
    fn description(&self) -> &'static Description {
        const { &M::DESCRIPTION }
    }

    fn assemblies(&self) -> Vec<String> {
        M::assemblies().map(M::assembly_name).collect()
    }

    fn solve(
        &self,
        given: Given<'_>,
        wanted: &mut Wanted<'_>,
        outcomes: &mut [Outcome],
        vectors: Vectors,
    ) -> Result<(), LengthMismatch> {
        let (parameters, inputs) = rows::<M>(given);
        // Only one of the two is compiled for a mechanism.
        if const { M::ASSEMBLY_COUNT == 0 } {
            let near = Row::from_fn(|unknown| given.choice.near(unknown));
            batch::solve_near::<M, _, _>(parameters, inputs, near, wanted, outcomes, vectors)?;
        } else if let Some(assembly) = M::assembly(given.choice.assembly()) {
            batch::solve::<M, _, _>(parameters, inputs, assembly, wanted, outcomes, vectors)?;
        } else {
            outcomes.fill(Outcome::Failed);
        }
        Ok(())
    }

    fn dyads(&self) -> usize {
        M::Dyads::<f64>::LENGTH
    }

    fn fold(&self, turn: Turn, given: Given<'_>, folds: &mut [Fold], vectors: Vectors) -> Result<Summary, FoldError> {
        let (parameters, inputs) = rows::<M>(given);
        // A coupled mechanism has no turn: its position is only known from values nearby. Nothing is compiled for it.
        if const { M::ASSEMBLY_COUNT > 0 }
            && let Some(assembly) = M::assembly(given.choice.assembly())
        {
            return batch::fold::<M>(turn, parameters, inputs, assembly, folds, vectors);
        }
        Err(FoldError::NoSuchInput {
            mechanism: M::DESCRIPTION.name,
            input: turn.input,
        })
    }
}

/// The columns of a batch, in the rows of the mechanism.
fn rows<M: Mechanism>(given: Given<'_>) -> (M::Parameters<Column<'_>>, M::Inputs<M::Motion<Column<'_>>>) {
    let inputs = M::Inputs::from_fn(|input| {
        M::Motion::from_fn(|order| given.inputs[input].get(order).copied().unwrap_or(Column::Same(0.0)))
    });
    (Row::from_fn(|index| given.parameters[index]), inputs)
}

impl fmt::Debug for dyn Solver {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.description().name)
    }
}
