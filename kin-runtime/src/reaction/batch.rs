//! Reactions in many poses, in lanes of vectors.

use alloc::borrow::Cow;
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

use super::pose::{PosePlan, PoseReactions, TERMS};
use super::prepared::PreparedReactions;
use super::program::{ProgramRun, stride};
use super::traced_plan::{Given, TracedColumns, TracedPlan, slot};
use super::{MovingPose, NamedReactions, ReactionError};
use crate::any::PositionChoice;
use crate::batch::{
    Column, ColumnChoice, GivenColumns, LengthMismatch, Outcome, Slot, Vectors, WantedColumns, check_length,
};
use crate::motion::Motion;
use crate::number::Number;
use crate::number::series::Series;
use crate::quantity::NameKind;

/// What takes the reactions in a pose, by its row.
type Read<'r> = &'r mut dyn FnMut(usize, Result<PoseReactions<'_>, ReactionError>);

/// The poses whose motions are found in one call: their columns stay in the cache.
const BLOCK: usize = 256;

/// In so many poses at most a plan is looked for.
const ATTEMPTS: usize = 8;

/// The reactions in many poses of a mechanism, or of mechanisms that differ in their dimensions:
/// [`NamedReactions::batch`].
#[must_use = "`solve` it"]
#[derive(Clone, Copy, Debug)]
pub struct ReactionBatch<'b> {
    reactions: &'b NamedReactions<'b>,
    /// None, unless they are given.
    dimensions: &'b [Column<'b>],
    inputs: &'b [&'b [Column<'b>]],
    choice: ColumnChoice<'b>,
    vectors: Vectors,
}

impl NamedReactions<'_> {
    /// The reactions in many poses, several at once, in the widest vectors of the machine. For each input there is a
    /// column for each order of its motion, position first; missing orders are zero.
    ///
    /// Each pose differs from that of [`prepared`](Self::prepared) by rounding, since a [batch](crate::batch) finds
    /// motions up to rounding. Poses that do not close, those in which the order of the equations does not fit, and
    /// all with friction, are found one by one.
    ///
    /// ```
    /// use kin_core::batch::{Column, ColumnChoice};
    /// use kin_core::library::FourBar;
    /// use kin_core::linkage::AnyLinkage;
    ///
    /// let linkage = AnyLinkage::of(&FourBar { r1: 0.9, r2: 0.3, r3: 0.8, r4: 0.6 });
    /// let loads = linkage.loads().torque(-30.0, "theta4")?;
    /// let reactions = linkage.reactions_as_guessed(&loads)?;
    /// let crank: Vec<f64> = (0_u16..360).map(|degrees| f64::from(degrees).to_radians()).collect();
    /// let mut torques = vec![0.0; crank.len()];
    /// // at 12 rad/s
    /// let crank = [Column::Each(&crank), Column::Same(12.0)];
    /// reactions.batch(&[&crank], ColumnChoice::Assembly(0)).solve(
    ///     |pose| pose.ok().and_then(|pose| pose.effort(0)).map_or(f64::NAN, |[torque, ..]| torque),
    ///     &mut torques,
    /// )?;
    ///
    /// // cranks of several lengths, of which the last does not turn
    /// let cranks = [0.2, 0.3, 0.4, 2.4];
    /// let dimensions = [Column::Same(0.9), Column::Each(&cranks), Column::Same(0.8), Column::Same(0.6)];
    /// let crank = [Column::Same(1.0), Column::Same(12.0)];
    /// let inputs = [&crank[..]];
    /// let batch = reactions.batch(&inputs, ColumnChoice::Assembly(0)).dimensions(&dimensions);
    /// let mut errors = vec![String::new(); 4];
    /// batch.solve(|pose| pose.err().map_or_else(String::new, |error| error.to_string()), &mut errors)?;
    /// assert!(errors[2].is_empty() && errors[3].contains("cannot be found"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn batch<'b>(&'b self, inputs: &'b [&'b [Column<'b>]], choice: ColumnChoice<'b>) -> ReactionBatch<'b> {
        ReactionBatch {
            reactions: self,
            dimensions: &[],
            inputs,
            choice,
            vectors: Vectors::widest(),
        }
    }

    /// The same for other dimensions.
    fn with_parameters(&self, parameters: &[f64]) -> Self {
        let mut other = self.clone();
        other.parameters = parameters.into();
        other.solutions.forget();
        other
    }
}

impl<'b> ReactionBatch<'b> {
    /// The same with other dimensions: a column for each parameter of the mechanism. Where loads and drives act is
    /// found once, so that the bodies must be joined in the same way.
    pub fn dimensions(mut self, dimensions: &'b [Column<'b>]) -> Self {
        self.dimensions = dimensions;
        self
    }

    /// The same in other vectors than the widest of the machine. The numbers differ between them by rounding.
    pub fn vectors(mut self, vectors: Vectors) -> Self {
        self.vectors = vectors;
        self
    }

    /// Solves all poses. `read` takes from each what is wanted, or handles its error, which is that of
    /// [`NamedReactions::at`]. The results are stored in the order of the columns.
    ///
    /// # Errors
    /// [`LengthMismatch`] if the length of a column differs from the number of results. Nothing is solved then.
    pub fn solve<R>(
        &self,
        read: impl Fn(Result<PoseReactions<'_>, ReactionError>) -> R,
        results: &mut [R],
    ) -> Result<(), LengthMismatch> {
        self.check_lengths(results.len())?;
        self.solve_part(0..results.len(), &mut |row, found| results[row] = read(found));
        Ok(())
    }

    /// [`solve`](Self::solve) on all cores.
    ///
    /// # Errors
    /// As there.
    #[cfg(feature = "rayon")]
    #[cfg_attr(docsrs, doc(cfg(feature = "rayon")))]
    pub fn solve_on_all_cores<R: Send>(
        &self,
        read: impl Fn(Result<PoseReactions<'_>, ReactionError>) -> R + Sync,
        results: &mut [R],
    ) -> Result<(), LengthMismatch> {
        use rayon::prelude::*;

        const PART: usize = 8 * BLOCK;
        self.check_lengths(results.len())?;
        results.par_chunks_mut(PART).enumerate().for_each(|(part, results)| {
            let start = part * PART;
            self.solve_part(start..start + results.len(), &mut |row, found| {
                results[row - start] = read(found);
            });
        });
        Ok(())
    }

    fn check_lengths(&self, count: usize) -> Result<(), LengthMismatch> {
        let near = match self.choice {
            ColumnChoice::Near(near) => near,
            ColumnChoice::Assembly(_) => &[],
        };
        let inputs = self.inputs.iter().enumerate();
        let inputs = inputs.flat_map(|(index, orders)| orders.iter().map(move |column| (index, column)));
        let all = [(NameKind::Parameter, self.dimensions), (NameKind::Unknown, near)];
        let all = all
            .into_iter()
            .flat_map(|(kind, columns)| {
                columns
                    .iter()
                    .enumerate()
                    .map(move |(index, column)| (kind, index, column))
            })
            .chain(inputs.map(|(index, column)| (NameKind::Input, index, column)));
        for (kind, index, column) in all {
            check_length(self.reactions.functions, kind, index, column.length(), count)?;
        }
        Ok(())
    }

    /// Solves the poses of a range.
    fn solve_part(&self, range: Range<usize>, read: Read<'_>) {
        let varies = self.dimensions.iter().any(|column| column.length().is_some());
        let is_own = || self.parameters(range.start)[..] == self.reactions.parameters[..];
        let reactions = if varies || range.is_empty() || is_own() {
            Cow::Borrowed(self.reactions)
        } else {
            Cow::Owned(self.reactions.with_parameters(&self.parameters(range.start)))
        };
        let plan = self.first_plan(&reactions, range.clone(), varies);
        let mut alone = Alone {
            batch: self,
            prepared: reactions.prepared(),
            varies,
        };
        if let Some(traced) = plan {
            return self.solve_traced(&traced, range, &mut alone, read);
        }
        for row in range {
            alone.read(row, read);
        }
    }

    /// Solves the poses of a range by a program.
    fn solve_traced(&self, traced: &TracedPlan, range: Range<usize>, alone: &mut Alone<'_, '_>, read: Read<'_>) {
        let stride = stride(BLOCK.min(range.len()));
        let mut given = vec![0.0; traced.given.len() * stride];
        let mut results = vec![0.0; traced.program.results() * stride];
        let (mut kept, mut outcomes) = (vec![0.0; stride], vec![Outcome::Unsolved; stride]);
        for block in range.clone().step_by(BLOCK) {
            let rows = block..range.end.min(block + BLOCK);
            let outcomes = &mut outcomes[..rows.len()];
            self.give(traced, rows.clone(), stride, &mut given, outcomes);
            self.vectors.run(ProgramRun {
                program: &traced.program,
                count: rows.len(),
                stride,
                given: &given,
                results: &mut results,
                kept: &mut kept,
            });
            let solution = TracedColumns {
                traced,
                results: &results,
                stride,
            };
            for (pose, row) in rows.enumerate() {
                if outcomes[pose].is_solved() && kept[pose].is_finite() {
                    read(row, Ok(PoseReactions::of(&solution, pose)));
                } else {
                    alone.read(row, read);
                }
            }
        }
    }

    /// Writes the numbers on which the program depends.
    fn give(
        &self,
        traced: &TracedPlan,
        rows: Range<usize>,
        stride: usize,
        given: &mut [f64],
        outcomes: &mut [Outcome],
    ) {
        let mut wanted = Vec::new();
        for (own, column) in traced.given.iter().zip(given.chunks_exact_mut(stride)) {
            let column = &mut column[..rows.len()];
            match *own {
                Given::Dimension(index) => {
                    for (number, row) in column.iter_mut().zip(rows.clone()) {
                        *number = self.dimensions[index].at(row);
                    }
                }
                Given::Motion(slot) => wanted.push((slot, column)),
                Given::Drawn(..) => {}
            }
        }
        let mut wanted = WantedColumns::new(wanted);
        if self.motions_of(rows.clone(), &mut wanted, outcomes).is_err() {
            // the lengths have been checked
            outcomes.fill(Outcome::Failed);
        }
        drop(wanted);
        if traced.plan.is_drawn() {
            self.draw(traced, rows, stride, given);
        }
    }

    /// Writes where the joints stand that no output tells, pose by pose.
    fn draw(&self, traced: &TracedPlan, rows: Range<usize>, stride: usize, given: &mut [f64]) {
        let reactions = self.reactions;
        let mut quantities: Vec<MovingPose> = reactions.parameters.iter().copied().map(Series::constant).collect();
        quantities.resize(traced.quantities, Series::ZERO);
        for (pose, row) in rows.enumerate() {
            for (own, column) in quantities.iter_mut().zip(self.dimensions) {
                *own = Series::constant(column.at(row));
            }
            let mut columns = traced.given.iter().zip(given.chunks_exact(stride));
            for quantity in &traced.moving {
                let mut derivatives = [0.0; TERMS];
                let own = columns.by_ref().filter(|(own, _)| matches!(own, Given::Motion(_)));
                for (derivative, (_, column)) in derivatives.iter_mut().zip(own) {
                    *derivative = column[pose];
                }
                quantities[*quantity] = Series::from_derivatives(derivatives);
            }
            traced.plan.draw(reactions, &quantities, &mut |index, place| {
                let own = traced.given.iter().zip(given.chunks_exact_mut(stride));
                for (own, column) in own {
                    if let Given::Drawn(joint, axis, order) = *own
                        && joint == index
                    {
                        let coordinate = [place.x, place.y, place.z][axis];
                        column[pose] = coordinate.coefficients()[order];
                    }
                }
            });
        }
    }

    /// The plan by the first pose that has one.
    fn first_plan(&self, reactions: &NamedReactions<'_>, rows: Range<usize>, varies: bool) -> Option<TracedPlan> {
        let mut attempts = 0;
        for row in rows {
            match self.plan(reactions, row, varies) {
                Ok(plan) => return plan,
                // it does not close there
                Err(ReactionError::Solve(_)) => {}
                Err(_) => attempts += 1,
            }
            if attempts == ATTEMPTS {
                break;
            }
        }
        None
    }

    /// The plan by a pose; none if poses are solved one by one.
    fn plan(
        &self,
        reactions: &NamedReactions<'_>,
        row: usize,
        varies: bool,
    ) -> Result<Option<TracedPlan>, ReactionError> {
        if reactions.has_friction() {
            return Ok(None);
        }
        let own;
        let reactions = if varies {
            own = reactions.with_parameters(&self.parameters(row));
            &own
        } else {
            reactions
        };
        let motions = self.motions(row);
        let near = self.near(row);
        let unknowns = reactions.unknowns_at(&motions, self.position(&near))?;
        let place = reactions.place(&motions, &unknowns);
        let plan = PosePlan::new(reactions, &place, varies)?;
        let plan = plan.filter(|plan| !self.asks_for_direction(plan));
        plan.map_or(Ok(None), |plan| TracedPlan::of(reactions, plan, &place, varies))
    }

    /// Whether a plan asks for the angle of a direction, of which a batch gives cosine and sine.
    fn asks_for_direction(&self, plan: &PosePlan) -> bool {
        let unknowns = self.reactions.functions.description().unknowns;
        let mut slots = plan.needed.iter().map(|quantity| slot(self.reactions, *quantity, 0));
        slots.any(|slot| matches!(slot, Some(Slot::Unknown(index, _)) if unknowns[index].is_direction))
    }

    /// Finds the motions of a range of poses.
    fn motions_of(
        &self,
        range: Range<usize>,
        wanted: &mut WantedColumns<'_>,
        outcomes: &mut [Outcome],
    ) -> Result<(), LengthMismatch> {
        let part = |columns: &[Column<'b>]| -> Vec<Column<'b>> {
            columns.iter().map(|column| column.part(range.clone())).collect()
        };
        let parameters = if self.dimensions.is_empty() {
            self.reactions.parameters.iter().copied().map(Column::Same).collect()
        } else {
            part(self.dimensions)
        };
        let inputs: Vec<Vec<Column<'_>>> = self.inputs.iter().map(|orders| part(orders)).collect();
        let inputs: Vec<&[Column<'_>]> = inputs.iter().map(Vec::as_slice).collect();
        let near;
        let given = GivenColumns {
            parameters: &parameters,
            inputs: &inputs,
            choice: match self.choice {
                ColumnChoice::Near(columns) => {
                    near = part(columns);
                    ColumnChoice::Near(&near)
                }
                ColumnChoice::Assembly(index) => ColumnChoice::Assembly(index),
            },
        };
        let functions = self.reactions.functions;
        functions.solve_batch(given, wanted, outcomes, self.vectors).map(|_| ())
    }

    fn parameters(&self, row: usize) -> Vec<f64> {
        if self.dimensions.is_empty() {
            return self.reactions.parameters.to_vec();
        }
        self.dimensions.iter().map(|column| column.at(row)).collect()
    }

    fn motions(&self, row: usize) -> Vec<Motion> {
        let motion = |orders: &&[Column<'_>]| {
            let order = |order: usize| orders.get(order).map_or(0.0, |column| column.at(row));
            Motion::new(core::array::from_fn(order))
        };
        self.inputs.iter().map(motion).collect()
    }

    fn near(&self, row: usize) -> Vec<f64> {
        match self.choice {
            ColumnChoice::Near(columns) => columns.iter().map(|column| column.at(row)).collect(),
            ColumnChoice::Assembly(_) => Vec::new(),
        }
    }

    fn position<'n>(&self, near: &'n [f64]) -> PositionChoice<'n, f64> {
        match self.choice {
            ColumnChoice::Near(_) => PositionChoice::Near(near),
            ColumnChoice::Assembly(index) => PositionChoice::Assembly(index),
        }
    }
}

/// Poses that are solved one by one.
struct Alone<'a, 'b> {
    batch: &'a ReactionBatch<'b>,
    prepared: PreparedReactions<'a>,
    /// Whether dimensions differ from pose to pose.
    varies: bool,
}

impl Alone<'_, '_> {
    #[cold]
    #[inline(never)]
    fn read(&mut self, row: usize, read: Read<'_>) {
        let (motions, near) = (self.batch.motions(row), self.batch.near(row));
        let position = self.batch.position(&near);
        if self.varies {
            let reactions = self.batch.reactions.with_parameters(&self.batch.parameters(row));
            return read(row, reactions.prepared().alone(&motions, position));
        }
        read(row, self.prepared.at(&motions, position));
    }
}
