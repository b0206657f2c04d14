//! Batches of any mechanism, with dimensions and inputs of its own for each pose.

use kin_core::Description;
use kin_core::batch::{Batch, Column, Columns, Element, Outcome, Slot, Summary, Vectors, Visitor, WantedColumns};
use kin_core::prelude::*;

use crate::mechanisms::cases::ThroughSnap;

/// By how much margins may differ, in units of what rounding of the given numbers changes.
const MARGIN_UNITS: f64 = 4.0;

/// Columns for the motions of any mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct Table<E = f64> {
    /// Motions of the inputs, order by order.
    pub inputs: Vec<Vec<Vec<E>>>,
    /// With the cosine in the place of the angle where one is a direction.
    pub unknowns: Vec<Vec<Vec<E>>>,
    /// Of every unknown, for whatever is a direction.
    pub sines: Vec<Vec<E>>,
    /// Motions of the scalar outputs, order by order.
    pub outputs: Vec<Vec<Vec<E>>>,
}

/// What places hold before a batch.
const UNTOUCHED: f64 = -1.0;

impl<E: Element> Table<E> {
    /// Whether a pose has no numbers except its inputs, as one that failed. Places for the sines of what is no
    /// direction may be left untouched.
    #[must_use]
    pub fn is_cleared(&self, index: usize) -> bool {
        let mut columns = self.unknowns.iter().chain(&self.outputs).flatten();
        let mut sines = self.sines.iter().map(|column| column[index]);
        columns.all(|column| column[index].real().is_nan())
            && sines.all(|sine| sine.real().is_nan() || sine.real() == UNTOUCHED)
    }

    /// Columns that no batch has touched.
    #[must_use]
    pub fn new(description: &Description, poses: usize) -> Self {
        let untouched = || vec![E::constant(UNTOUCHED); poses];
        let columns = |count: usize| vec![vec![untouched(); description.order + 1]; count];
        Self {
            inputs: columns(description.inputs.len()),
            unknowns: columns(description.unknowns.len()),
            sines: vec![untouched(); description.unknowns.len()],
            outputs: columns(description.outputs.len()),
        }
    }

    /// Whether an unknown is a direction, of which a batch has found the sines.
    #[must_use]
    pub fn is_direction(&self, unknown: usize) -> bool {
        let mut sines = self.sines[unknown].iter().map(|sine| sine.real());
        sines.any(|sine| sine != UNTOUCHED && !sine.is_nan())
    }

    /// The numbers of a pose, bit by bit.
    #[must_use]
    pub fn bits(&self, index: usize) -> Vec<u64> {
        [&self.inputs, &self.unknowns, &self.outputs]
            .into_iter()
            .flatten()
            .flatten()
            .chain(&self.sines)
            .map(|column| column[index].real())
            // The sign of NaN says nothing.
            .map(|number| if number.is_nan() { f64::NAN } else { number }.to_bits())
            .collect()
    }
}

impl Table {
    /// All columns, for a batch of a mechanism without its type.
    pub fn wanted(&mut self) -> WantedColumns<'_> {
        struct All<'w>(Vec<(Slot, &'w mut [f64])>);

        impl<'w> Visitor<'w, Vec<f64>> for All<'w> {
            fn visit(&mut self, place: Slot, column: &'w mut Vec<f64>) {
                self.0.push((place, column));
            }
        }

        let mut all = All(Vec::new());
        self.each(&mut all);
        WantedColumns::new(all.0)
    }
}

fn visit<'a, E>(
    motions: &'a mut [Vec<Vec<E>>],
    place: impl Fn(usize, usize) -> Slot,
    visitor: &mut impl Visitor<'a, Vec<E>>,
) {
    for (index, motion) in motions.iter_mut().enumerate() {
        for (order, column) in motion.iter_mut().enumerate() {
            visitor.visit(place(index, order), column);
        }
    }
}

impl<E> Columns<Vec<E>> for Table<E> {
    fn each<'a>(&'a mut self, visitor: &mut impl Visitor<'a, Vec<E>>)
    where
        E: 'a,
    {
        visit(&mut self.inputs, Slot::Input, visitor);
        visit(&mut self.unknowns, Slot::Unknown, visitor);
        for (index, column) in self.sines.iter_mut().enumerate() {
            visitor.visit(Slot::Sine(index), column);
        }
        visit(&mut self.outputs, Slot::Output, visitor);
    }
}

/// Poses of a mechanism, each with dimensions and inputs of its own.
pub struct Poses<M: Mechanism> {
    /// The dimensions of each.
    pub mechanisms: Vec<M>,
    /// The inputs of each.
    pub inputs: Vec<M::Inputs<M::Motion<M::Scalar>>>,
    /// Values of the unknowns near by, where there are no assemblies.
    pub near: Vec<M::Unknowns<M::Scalar>>,
}

/// The numbers of poses, column by column.
struct Numbers<E> {
    parameters: Vec<Vec<E>>,
    inputs: Vec<Vec<Vec<E>>>,
    near: Vec<Vec<E>>,
}

impl<E: Element> Numbers<E> {
    fn parameters<M: Mechanism>(&self) -> M::Parameters<Column<'_, E>> {
        Row::from_fn(|place| Column::Each(&self.parameters[place]))
    }

    fn inputs<'a, M: Mechanism>(&'a self) -> M::Inputs<M::Motion<Column<'a, E>>> {
        M::Inputs::from_fn(|input| {
            <M::Motion<Column<'a, E>> as Row<Column<'a, E>>>::from_fn(|order| Column::Each(&self.inputs[input][order]))
        })
    }

    fn near<M: Mechanism>(&self) -> M::Unknowns<Column<'_, E>> {
        Row::from_fn(|place| Column::Each(&self.near[place]))
    }
}

impl<M: Mechanism<Scalar: Element>> Poses<M> {
    /// Solves them as one batch: in an assembly, or near the values where assemblies have no names.
    ///
    /// # Panics
    /// If there are assemblies, and none is given.
    #[must_use]
    pub fn solve(&self, assembly: Option<M::Assembly>, vectors: Vectors) -> (Table<M::Scalar>, Vec<Outcome>, Summary) {
        let numbers = self.numbers();
        self.solve_columns(numbers.parameters::<M>(), &numbers, assembly, vectors)
    }

    /// Solves them as poses of the first mechanism.
    ///
    /// # Panics
    /// If there is none.
    #[must_use]
    pub fn solve_as_one_mechanism(
        &self,
        assembly: M::Assembly,
        vectors: Vectors,
    ) -> (Table<M::Scalar>, Vec<Outcome>, Summary) {
        let parameters = self.mechanisms[0].parameters();
        let same = Row::from_fn(|place| Column::Same(parameters[place]));
        self.solve_columns(same, &self.numbers(), Some(assembly), vectors)
    }

    fn solve_columns<'a>(
        &self,
        parameters: M::Parameters<Column<'a, M::Scalar>>,
        numbers: &'a Numbers<M::Scalar>,
        assembly: Option<M::Assembly>,
        vectors: Vectors,
    ) -> (Table<M::Scalar>, Vec<Outcome>, Summary) {
        let inputs = numbers.inputs::<M>();
        let (mut table, mut outcomes) = self.places();
        // A constant condition, so that only one of the two is compiled.
        let summary = if const { M::ASSEMBLY_COUNT > 0 } {
            let assembly = assembly.expect("there are assemblies");
            Batch::<M, _>::new(parameters, inputs, assembly)
                .vectors(vectors)
                .solve(&mut table, &mut outcomes)
        } else {
            let near = numbers.near::<M>();
            Batch::<M, _>::near(parameters, inputs, near)
                .vectors(vectors)
                .solve(&mut table, &mut outcomes)
        };
        (table, outcomes, summary.expect("all columns are of one length"))
    }

    /// The same on all cores.
    ///
    /// # Panics
    /// As [`solve`](Self::solve).
    #[must_use]
    pub fn solve_in_parallel(
        &self,
        assembly: Option<M::Assembly>,
        vectors: Vectors,
    ) -> (Table<M::Scalar>, Vec<Outcome>, Summary)
    where
        M::Assembly: Sync,
        for<'a> M::Parameters<Column<'a, M::Scalar>>: Sync,
        for<'a> M::Inputs<M::Motion<Column<'a, M::Scalar>>>: Sync,
        for<'a> M::Unknowns<Column<'a, M::Scalar>>: Sync,
    {
        let numbers = self.numbers();
        let (parameters, inputs) = (numbers.parameters::<M>(), numbers.inputs::<M>());
        let (mut table, mut outcomes) = self.places();
        let summary = if const { M::ASSEMBLY_COUNT > 0 } {
            let assembly = assembly.expect("there are assemblies");
            Batch::<M, _>::new(parameters, inputs, assembly)
                .vectors(vectors)
                .on_all_cores()
                .solve(&mut table, &mut outcomes)
        } else {
            let near = numbers.near::<M>();
            Batch::<M, _>::near(parameters, inputs, near)
                .vectors(vectors)
                .on_all_cores()
                .solve(&mut table, &mut outcomes)
        };
        (table, outcomes, summary.expect("all columns are of one length"))
    }

    /// One of them by itself.
    ///
    /// # Errors
    /// As `solve` of the mechanism.
    pub fn solve_one(&self, index: usize, assembly: Option<M::Assembly>) -> Result<M::Pose, SolveError> {
        match assembly {
            Some(assembly) => self.mechanisms[index].solve(self.inputs[index], assembly),
            None => self.mechanisms[index].solve_near(self.inputs[index], self.near[index]),
        }
    }

    fn places(&self) -> (Table<M::Scalar>, Vec<Outcome>) {
        let count = self.mechanisms.len();
        (Table::new(&M::DESCRIPTION, count), vec![Outcome::Unsolved; count])
    }

    fn numbers(&self) -> Numbers<M::Scalar> {
        let count = self.mechanisms.len();
        let column = |number: &dyn Fn(usize) -> M::Scalar| -> Vec<M::Scalar> { (0..count).map(number).collect() };
        Numbers {
            parameters: (0..M::DESCRIPTION.parameters.len())
                .map(|place| column(&|pose| self.mechanisms[pose].parameters().as_ref()[place]))
                .collect(),
            inputs: (0..M::DESCRIPTION.inputs.len())
                .map(|input| {
                    (0..=M::DESCRIPTION.order)
                        .map(|order| column(&|pose| self.inputs[pose].as_ref()[input].as_ref()[order]))
                        .collect()
                })
                .collect(),
            near: (0..M::DESCRIPTION.unknowns.len())
                .map(|place| {
                    column(&|pose| {
                        self.near
                            .get(pose)
                            .map_or(M::Scalar::constant(0.0), |near| near.as_ref()[place])
                    })
                })
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

impl<M: ThroughSnap> Poses<M> {
    /// Asserts that the outcome of a pose is that of the error of `solve`: the same kind, and the same margin up to
    /// rounding. Returns the difference of the margins, in units of rounding.
    ///
    /// # Panics
    /// If it is not.
    pub fn check_failure(
        &self,
        index: usize,
        assembly: Option<M::Assembly>,
        found: Outcome,
        error: &SolveError,
    ) -> f64 {
        let (name, expected) = (M::DESCRIPTION.name, Outcome::from(error));
        match (found.margin(), expected.margin()) {
            (Some(found), Some(margin)) if found == margin => 0.0,
            (Some(found), Some(margin)) => {
                let units = (found - margin).abs() / self.margin_unit(index, assembly, margin);
                assert!(
                    units <= MARGIN_UNITS,
                    "{name}, pose {index}: {found:e} for {margin:e}, {units} units: {error}"
                );
                units
            }
            _ => {
                assert_eq!(found, expected, "{name}, pose {index}: {error}");
                0.0
            }
        }
    }

    /// The size of rounding in a margin: the sum of its changes as each dimension and each input changes by ε of its
    /// size.
    #[must_use]
    pub fn margin_unit(&self, index: usize, assembly: Option<M::Assembly>, margin: f64) -> f64 {
        let parameters = self.mechanisms[index].parameters();
        let count = parameters.as_ref().len();
        let total = (0..count + self.inputs[index].as_ref().len()).map(|changed| {
            let slope = [1e-6, -1e-6, 1e-9, -1e-9].into_iter().find_map(|part| {
                let change = |place: usize, number: f64| {
                    if place == changed {
                        number * (1.0 + part)
                    } else {
                        number
                    }
                };
                let one = Self {
                    mechanisms: vec![M::from_parameters(Row::from_fn(|place| {
                        change(place, parameters[place])
                    }))],
                    inputs: vec![M::Inputs::from_fn(|input| {
                        let motion = self.inputs[index][input];
                        let own = |order: usize| {
                            if order == 0 {
                                change(count + input, motion[0])
                            } else {
                                motion[order]
                            }
                        };
                        Motion::new(core::array::from_fn(own))
                    })],
                    near: self.near.get(index).copied().into_iter().collect(),
                };
                let changed = Outcome::from(&one.solve_one(0, assembly).err()?).margin()?;
                Some((changed - margin) / part)
            });
            slope.map_or(0.0, f64::abs)
        });
        f64::EPSILON * (total.sum::<f64>() + margin.abs())
    }
}
