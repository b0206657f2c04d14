//! Batches of any mechanism, with dimensions and inputs of its own for each pose.

use kin_core::batch::{self, Column, Columns, Outcome, Place, Summary, Vectors, Visitor};
use kin_core::prelude::*;

use crate::mechanisms::cases::{Inputs, ThroughSnap};

/// Columns for the motions of any mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Motions of the inputs, order by order.
    pub inputs: Vec<Vec<Vec<f64>>>,
    /// With the cosine in the place of the angle where one is a direction.
    pub unknowns: Vec<Vec<Vec<f64>>>,
    /// Of every unknown, for whatever is a direction.
    pub sines: Vec<Vec<f64>>,
    /// Motions of the scalar outputs, order by order.
    pub outputs: Vec<Vec<Vec<f64>>>,
}

impl Table {
    fn new<M: ThroughSnap>(poses: usize) -> Self {
        let columns = |count: usize| vec![vec![vec![-1.0; poses]; 5]; count];
        Self {
            inputs: columns(M::DESCRIPTION.inputs.len()),
            unknowns: columns(M::DESCRIPTION.unknowns.len()),
            sines: vec![vec![-1.0; poses]; M::DESCRIPTION.unknowns.len()],
            outputs: columns(M::DESCRIPTION.outputs.len()),
        }
    }

    /// The numbers of a pose, bit by bit.
    #[must_use]
    pub fn bits(&self, index: usize) -> Vec<u64> {
        [&self.inputs, &self.unknowns, &self.outputs]
            .into_iter()
            .flatten()
            .flatten()
            .chain(&self.sines)
            .map(|column| column[index].to_bits())
            .collect()
    }
}

fn visit<'a>(
    motions: &'a mut [Vec<Vec<f64>>],
    place: impl Fn(usize, usize) -> Place,
    visitor: &mut impl Visitor<'a, Vec<f64>>,
) {
    for (index, motion) in motions.iter_mut().enumerate() {
        for (order, column) in motion.iter_mut().enumerate() {
            visitor.visit(place(index, order), column);
        }
    }
}

impl Columns<Vec<f64>> for Table {
    fn each<'a>(&'a mut self, visitor: &mut impl Visitor<'a, Vec<f64>>) {
        visit(&mut self.inputs, Place::Input, visitor);
        visit(&mut self.unknowns, Place::Unknown, visitor);
        for (index, column) in self.sines.iter_mut().enumerate() {
            visitor.visit(Place::Sine(index), column);
        }
        visit(&mut self.outputs, Place::Output, visitor);
    }
}

/// Poses of a mechanism, each with dimensions and inputs of its own.
pub struct Poses<M: ThroughSnap> {
    /// The dimensions of each.
    pub mechanisms: Vec<M>,
    /// The inputs of each.
    pub inputs: Vec<Inputs<M>>,
    /// Values of the unknowns near by, where there are no assemblies.
    pub near: Vec<M::Unknowns<f64>>,
}

/// The numbers of poses, column by column.
struct Numbers {
    parameters: Vec<Vec<f64>>,
    inputs: Vec<Vec<Vec<f64>>>,
    near: Vec<Vec<f64>>,
}

impl Numbers {
    fn parameters<M: Mechanism>(&self) -> M::Parameters<Column<'_>> {
        Row::from_fn(|place| Column::Each(&self.parameters[place]))
    }

    fn inputs<'a, M: Mechanism>(&'a self) -> M::Inputs<M::Motion<Column<'a>>> {
        M::Inputs::from_fn(|input| {
            <M::Motion<Column<'a>> as Row<Column<'a>>>::from_fn(|order| Column::Each(&self.inputs[input][order]))
        })
    }

    fn near<M: Mechanism>(&self) -> M::Unknowns<Column<'_>> {
        Row::from_fn(|place| Column::Each(&self.near[place]))
    }
}

impl<M: ThroughSnap> Poses<M> {
    /// Solves them as one batch: in an assembly, or near the values where assemblies have no names.
    ///
    /// # Panics
    /// If there are assemblies, and none is given.
    #[must_use]
    pub fn solve(&self, assembly: Option<M::Assembly>, vectors: Vectors) -> (Table, Vec<Outcome>, Summary) {
        let numbers = self.numbers();
        let (parameters, inputs) = (numbers.parameters::<M>(), numbers.inputs::<M>());
        let (mut table, mut outcomes) = self.places();
        // A constant condition, so that only one of the two is compiled.
        let summary = if const { M::ASSEMBLY_COUNT > 0 } {
            let assembly = assembly.expect("there are assemblies");
            batch::solve::<M, _, _>(parameters, inputs, assembly, &mut table, &mut outcomes, vectors)
        } else {
            let near = numbers.near::<M>();
            batch::solve_near::<M, _, _>(parameters, inputs, near, &mut table, &mut outcomes, vectors)
        };
        (table, outcomes, summary.expect("all columns are of one length"))
    }

    /// The same on all cores.
    ///
    /// # Panics
    /// As [`solve`](Self::solve).
    #[must_use]
    pub fn solve_in_parallel(&self, assembly: Option<M::Assembly>, vectors: Vectors) -> (Table, Vec<Outcome>, Summary)
    where
        M::Assembly: Sync,
        for<'a> M::Parameters<Column<'a>>: Sync,
        for<'a> M::Inputs<M::Motion<Column<'a>>>: Sync,
        for<'a> M::Unknowns<Column<'a>>: Sync,
    {
        let numbers = self.numbers();
        let (parameters, inputs) = (numbers.parameters::<M>(), numbers.inputs::<M>());
        let (mut table, mut outcomes) = self.places();
        let summary = if const { M::ASSEMBLY_COUNT > 0 } {
            let assembly = assembly.expect("there are assemblies");
            batch::solve_in_parallel::<M, _, _>(parameters, inputs, assembly, &mut table, &mut outcomes, vectors)
        } else {
            let near = numbers.near::<M>();
            batch::solve_near_in_parallel::<M, _, _>(parameters, inputs, near, &mut table, &mut outcomes, vectors)
        };
        (table, outcomes, summary.expect("all columns are of one length"))
    }

    /// One of them by itself.
    ///
    /// # Errors
    /// As `solve` of the mechanism.
    pub fn solve_one(&self, index: usize, assembly: Option<M::Assembly>) -> Result<M::Pose, SolveError> {
        match assembly {
            Some(assembly) => self.mechanisms[index].solve_motion(self.inputs[index], assembly),
            None => self.mechanisms[index].solve_motion_near(self.inputs[index], self.near[index]),
        }
    }

    fn places(&self) -> (Table, Vec<Outcome>) {
        let count = self.mechanisms.len();
        (Table::new::<M>(count), vec![Outcome::Unsolved; count])
    }

    fn numbers(&self) -> Numbers {
        let count = self.mechanisms.len();
        let column = |number: &dyn Fn(usize) -> f64| -> Vec<f64> { (0..count).map(number).collect() };
        Numbers {
            parameters: (0..M::DESCRIPTION.parameters.len())
                .map(|place| column(&|pose| self.mechanisms[pose].parameters().as_ref()[place]))
                .collect(),
            inputs: (0..M::DESCRIPTION.inputs.len())
                .map(|input| {
                    (0..5)
                        .map(|order| column(&|pose| self.inputs[pose].as_ref()[input].as_ref()[order]))
                        .collect()
                })
                .collect(),
            near: (0..M::DESCRIPTION.unknowns.len())
                .map(|place| column(&|pose| self.near.get(pose).map_or(0.0, |near| near.as_ref()[place])))
                .collect(),
        }
    }
}

/// All kinds of vectors that the machine has.
pub fn vectors() -> impl Iterator<Item = Vectors> {
    [Vectors::Compiled, Vectors::Avx2, Vectors::Avx512]
        .into_iter()
        .filter(|vectors| vectors.are_there())
}
