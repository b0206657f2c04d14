//! The solution of a batch, chunk by chunk.

use super::Column;
use super::destination::Destination;
use super::dispatch::{Kernel, Vectors};
use super::outcome::{LengthMismatch, Outcome, Summary};
use super::target::{Columns, Target};
use super::view::{View, gather, look, repeat};
use crate::batch::lanes::Lanes;
use crate::failure::SolveError;
use crate::mechanism::{Mechanism, Pose};
use crate::number::{Number, Row};

/// Solves a batch, as the method `solve_batch` of a mechanism does. Columns are given by the indices of parameters,
/// inputs, unknowns and outputs.
///
/// # Errors
/// [`LengthMismatch`] if the length of a column or a target differs from the number of outcomes. Nothing is solved
/// then.
pub fn solve<'a, M, P, C>(
    parameters: M::Parameters<Column<'a>>,
    inputs: M::Inputs<M::Motion<Column<'a>>>,
    assembly: M::Assembly,
    poses: &mut P,
    outcomes: &mut [Outcome],
    vectors: Vectors,
) -> Result<Summary, LengthMismatch>
where
    M: Mechanism<Scalar = f64>,
    P: Columns<C>,
    C: Target,
{
    let problem = Problem::<M, _> {
        parameters,
        inputs,
        guide: InAssembly(assembly),
    };
    problem.solve(poses, outcomes, vectors)
}

/// [`solve`] with values of the unknowns near each position, instead of an assembly.
///
/// # Errors
/// As for [`solve`].
pub fn solve_near<'a, M, P, C>(
    parameters: M::Parameters<Column<'a>>,
    inputs: M::Inputs<M::Motion<Column<'a>>>,
    near: M::Unknowns<Column<'a>>,
    poses: &mut P,
    outcomes: &mut [Outcome],
    vectors: Vectors,
) -> Result<Summary, LengthMismatch>
where
    M: Mechanism<Scalar = f64>,
    P: Columns<C>,
    C: Target,
{
    let problem = Problem::<M, _> {
        parameters,
        inputs,
        guide: Nearest(near),
    };
    problem.solve(poses, outcomes, vectors)
}

/// The columns of a batch, in rows.
pub(super) struct Problem<'a, M: Mechanism, G> {
    pub(super) parameters: M::Parameters<Column<'a>>,
    pub(super) inputs: M::Inputs<M::Motion<Column<'a>>>,
    pub(super) guide: G,
}

/// The choice among several positions, for each pose.
pub(super) trait Guide<'a, M: Mechanism>: Copy {
    /// Whether values near each pose make the choice.
    const IS_NEAR: bool;

    /// The values near each pose, if they make the choice.
    fn near(self) -> M::Unknowns<Column<'a>>;

    /// The guide restricted to a range of poses.
    #[cfg(feature = "rayon")]
    fn part(self, range: core::ops::Range<usize>) -> Self;

    /// Solves one pose, or several.
    fn solve<T: Mechanism<Assembly = M::Assembly>>(
        self,
        mechanism: &T,
        inputs: T::Inputs<T::Motion<T::Scalar>>,
        near: T::Unknowns<T::Scalar>,
    ) -> Result<T::Pose, SolveError>;
}

/// A guide that chooses positions by assembly.
#[derive(Clone, Copy)]
pub(super) struct InAssembly<A>(pub(super) A);

/// A guide that chooses the positions closest to values of the unknowns.
#[derive(Clone, Copy)]
pub(super) struct Nearest<C>(pub(super) C);

impl<'a, M: Mechanism> Guide<'a, M> for InAssembly<M::Assembly> {
    const IS_NEAR: bool = false;

    fn near(self) -> M::Unknowns<Column<'a>> {
        Row::from_fn(|_| Column::Same(f64::NAN))
    }

    #[cfg(feature = "rayon")]
    fn part(self, _: core::ops::Range<usize>) -> Self {
        self
    }

    #[inline(always)]
    fn solve<T: Mechanism<Assembly = M::Assembly>>(
        self,
        mechanism: &T,
        inputs: T::Inputs<T::Motion<T::Scalar>>,
        _: T::Unknowns<T::Scalar>,
    ) -> Result<T::Pose, SolveError> {
        mechanism.solve_motion(inputs, self.0)
    }
}

impl<'a, M: Mechanism, C: Row<Column<'a>>> Guide<'a, M> for Nearest<C> {
    const IS_NEAR: bool = true;

    fn near(self) -> M::Unknowns<Column<'a>> {
        Row::from_fn(|unknown| self.0[unknown])
    }

    #[cfg(feature = "rayon")]
    fn part(self, range: core::ops::Range<usize>) -> Self {
        Self(Row::from_fn(|unknown| self.0[unknown].part(range.clone())))
    }

    #[inline(always)]
    fn solve<T: Mechanism<Assembly = M::Assembly>>(
        self,
        mechanism: &T,
        inputs: T::Inputs<T::Motion<T::Scalar>>,
        near: T::Unknowns<T::Scalar>,
    ) -> Result<T::Pose, SolveError> {
        mechanism.solve_motion_near(inputs, near)
    }
}

impl<'a, M: Mechanism<Scalar = f64>, G: Guide<'a, M>> Problem<'a, M, G> {
    pub(super) fn solve<P: Columns<C>, C: Target>(
        &self,
        poses: &mut P,
        outcomes: &mut [Outcome],
        vectors: Vectors,
    ) -> Result<Summary, LengthMismatch> {
        self.check_lengths(outcomes.len())?;
        self.sweep(poses, outcomes, vectors)
    }

    /// [`solve`](Self::solve) with input columns whose lengths have been checked.
    pub(super) fn sweep<P: Columns<C>, C: Target>(
        &self,
        poses: &mut P,
        outcomes: &mut [Outcome],
        vectors: Vectors,
    ) -> Result<Summary, LengthMismatch> {
        let mut destination = Destination::nowhere();
        destination.find(poses, outcomes.len())?;
        Ok(vectors.run(Sweep {
            problem: self,
            near: &self.guide.near(),
            destination: &destination,
            outcomes,
        }))
    }

    pub(super) fn check_lengths(&self, count: usize) -> Result<(), LengthMismatch> {
        let description = M::DESCRIPTION;
        let check = |quantity: &'static str, length: Option<usize>| match length {
            Some(length) if length != count => Err(LengthMismatch {
                quantity,
                poses: count,
                length,
            }),
            _ => Ok(()),
        };
        for (column, quantity) in self.parameters.as_ref().iter().zip(description.parameters) {
            check(quantity.name, column.length())?;
        }
        for (motion, quantity) in self.inputs.as_ref().iter().zip(description.inputs) {
            for column in motion.as_ref() {
                check(quantity.name, column.length())?;
            }
        }
        for (column, quantity) in self.guide.near().as_ref().iter().zip(description.unknowns) {
            check(quantity.name, column.length())?;
        }
        Ok(())
    }
}

/// A problem with the places for its results.
struct Sweep<'p, 'a, M: Mechanism<Scalar = f64>, G> {
    problem: &'p Problem<'a, M, G>,
    near: &'p M::Unknowns<Column<'a>>,
    destination: &'p Destination<'p, M>,
    outcomes: &'p mut [Outcome],
}

impl<'a, M: Mechanism<Scalar = f64>, G: Guide<'a, M>> Sweep<'_, 'a, M, G> {
    /// Solves a pose alone and stores it.
    #[cold]
    #[inline(never)]
    fn settle(&self, index: usize) -> Result<(), SolveError> {
        let (parameters, inputs) = (self.problem.parameters.as_ref(), self.problem.inputs.as_ref());
        let mechanism = M::from_parameters(Row::from_fn(|parameter| parameters[parameter].at(index)));
        let inputs = M::Inputs::from_fn(|input| M::Motion::from_fn(|order| inputs[input][order].at(index)));
        let near = M::Unknowns::from_fn(|unknown| self.near[unknown].at(index));
        let nothing = |_| M::Motion::from_fn(|_| f64::NAN);
        let (unknowns, sines, outputs, result) = match self.problem.guide.solve(&mechanism, inputs, near) {
            Ok(pose) => (
                pose.unknown_columns(),
                pose.unknown_sines(),
                pose.output_motions(),
                Ok(()),
            ),
            Err(error) => (
                Row::from_fn(nothing),
                Row::from_fn(|_| Some(f64::NAN)),
                Row::from_fn(nothing),
                Err(error),
            ),
        };
        self.destination.store(
            index,
            inputs.as_ref(),
            unknowns.as_ref(),
            sines.as_ref(),
            outputs.as_ref(),
        );
        result
    }
}

impl<'a, M: Mechanism<Scalar = f64>, G: Guide<'a, M>> Kernel for Sweep<'_, 'a, M, G> {
    type Result = Summary;

    #[inline(always)]
    fn run<const W: usize, const FUSED: bool>(self) -> Summary {
        let problem = self.problem;
        let count = self.outcomes.len();
        let mut summary = Summary {
            solved: count,
            ..Summary::default()
        };
        // Assume every pose is solved; failures overwrite this below. Copy in chunks, because single stores would use
        // the narrowest instructions.
        let (chunks, rest) = self.outcomes.as_chunks_mut::<W>();
        for chunk in chunks {
            chunk.copy_from_slice(const { &[Outcome::Solved; W] });
        }
        rest.fill(Outcome::Solved);
        let zero = Lanes::<W, FUSED>::constant(0.0);
        let (columns, mut same) = (problem.parameters.as_ref(), M::Parameters::from_fn(|_| zero));
        repeat(same.as_mut(), columns);
        let mut parameters = M::Parameters::from_fn(|_| View::default());
        look(parameters.as_mut(), columns, same.as_ref());
        let (columns, mut same) = (
            problem.inputs.as_ref(),
            M::Inputs::from_fn(|_| M::Motion::from_fn(|_| zero)),
        );
        for (same, columns) in same.as_mut().iter_mut().zip(columns) {
            repeat(same.as_mut(), columns.as_ref());
        }
        let mut inputs = M::Inputs::from_fn(|_| M::Motion::from_fn(|_| View::default()));
        for ((views, columns), same) in inputs.as_mut().iter_mut().zip(columns).zip(same.as_ref()) {
            look(views.as_mut(), columns.as_ref(), same.as_ref());
        }
        let (columns, mut same) = (self.near.as_ref(), M::Unknowns::from_fn(|_| zero));
        let mut near = M::Unknowns::from_fn(|_| View::default());
        if G::IS_NEAR {
            repeat(same.as_mut(), columns);
            look(near.as_mut(), columns, same.as_ref());
        }
        let mut dimensions = Row::from_fn(|_| zero);
        let mut guess = Row::from_fn(|_| zero);
        let mut motions: <M::With<Lanes<W, FUSED>> as Mechanism>::Inputs<M::Motion<Lanes<W, FUSED>>> =
            Row::from_fn(|_| Row::from_fn(|_| zero));
        let mut next = 0;
        // If there are fewer poses than lanes, they are solved one by one.
        while next < count && count >= W {
            // The last chunk overlaps the one before it. The overlapped poses are solved twice, with the same result.
            let start = next.min(count - W);
            gather(&mut dimensions, parameters.as_ref(), start);
            if G::IS_NEAR {
                gather(&mut guess, near.as_ref(), start);
            }
            for (motion, views) in motions.as_mut().iter_mut().zip(inputs.as_ref()) {
                gather(motion, views.as_ref(), start);
            }
            let mechanism = M::With::from_parameters(dimensions);
            let mut sum = Lanes([f64::NAN; W]);
            if let Ok(pose) = problem.guide.solve(&mechanism, motions, guess) {
                let (unknowns, outputs) = (pose.unknown_columns(), pose.output_motions());
                let sines = pose.unknown_sines();
                // The sum is finite if and only if all numbers are, unless the sum itself overflows. Start with a
                // negative zero: the compiler knows that adding it changes nothing.
                sum = Lanes::constant(-0.0);
                for motion in unknowns.as_ref() {
                    for entry in motion.as_ref() {
                        sum = sum + *entry;
                    }
                }
                for sine in sines.as_ref().iter().flatten() {
                    sum = sum + *sine;
                }
                for motion in outputs.as_ref() {
                    for entry in motion.as_ref() {
                        sum = sum + *entry;
                    }
                }
                self.destination.store(
                    start,
                    motions.as_ref(),
                    unknowns.as_ref(),
                    sines.as_ref(),
                    outputs.as_ref(),
                );
            }
            if !sum.sum().is_finite() {
                for (lane, index) in (start..start + W).enumerate() {
                    if !sum.0[lane].is_finite() {
                        let result = self.settle(index);
                        if index >= next {
                            self.outcomes[index] = summary.note(index, result);
                        }
                    }
                }
            }
            next = start + W;
        }
        for index in next..count {
            self.outcomes[index] = summary.note(index, self.settle(index));
        }
        summary
    }
}
