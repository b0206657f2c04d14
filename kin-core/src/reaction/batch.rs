//! Reactions in many poses, in lanes of vectors.

use alloc::borrow::Cow;
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

use super::pose::{PosePlan, PoseReactions, PoseRoom, TERMS};
use super::pose_number::PoseNumber;
use super::prepared::PreparedReactions;
use super::{MovingPose, NamedReactions, ReactionError};
use crate::any::PositionChoice;
use crate::batch::lanes::Lanes;
use crate::batch::{
    Column, ColumnChoice, GivenColumns, Kernel, LengthMismatch, Outcome, Slot, Vectors, WantedColumns, check_length,
};
use crate::geometry::Space;
use crate::motion::Motion;
use crate::number::Number;
use crate::number::series::{Series, SeriesOf};
use crate::picture::Outline;
use crate::quantity::NameKind;

/// The poses whose motions are found in one call: their columns stay in the cache.
const BLOCK: usize = 256;

/// In so many poses at most a plan is looked for.
const ATTEMPTS: usize = 8;

impl<const W: usize, const FUSED: bool> PoseNumber for Lanes<W, FUSED> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn provided<const K: usize>(mut self, operands: [Self; K], holds: impl Fn([f64; K]) -> bool) -> Option<Self> {
        for lane in 0..W {
            let mut values = [0.0; K];
            for (value, operand) in values.iter_mut().zip(&operands) {
                *value = operand.0[lane];
            }
            self.0[lane] = if holds(values) { self.0[lane] } else { f64::NAN };
        }
        Some(self)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn size(self) -> Self {
        Self::from_fn(|lane| self.0[lane].abs())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn or_larger(self, other: Self) -> Self {
        Self::from_fn(|lane| self.0[lane].max(other.0[lane]))
    }

    fn of_pose(self, pose: usize) -> f64 {
        self.0[pose]
    }
}

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
    /// let batch = reactions.batch(&[&crank], ColumnChoice::Assembly(0)).dimensions(&dimensions);
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
        self.solve_part(0..results.len(), &read, results);
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
            self.solve_part(start..start + results.len(), &read, results);
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
    fn solve_part<R>(
        &self,
        range: Range<usize>,
        read: &impl Fn(Result<PoseReactions<'_>, ReactionError>) -> R,
        results: &mut [R],
    ) {
        let varies = self.dimensions.iter().any(|column| column.length().is_some());
        let is_own = || self.parameters(range.start)[..] == self.reactions.parameters[..];
        let reactions = if varies || range.is_empty() || is_own() {
            Cow::Borrowed(self.reactions)
        } else {
            Cow::Owned(self.reactions.with_parameters(&self.parameters(range.start)))
        };
        let plan = range
            .clone()
            .try_fold(0, |attempts, row| match self.plan(&reactions, row, varies) {
                // it breaks off with a plan, and where there is none
                Ok(plan) => Err(plan),
                Err(ReactionError::Solve(_)) => Ok(attempts),
                Err(_) if attempts + 1 < ATTEMPTS => Ok(attempts + 1),
                Err(_) => Err(None),
            });
        let mut alone = Alone {
            batch: self,
            prepared: reactions.prepared(),
            varies,
        };
        match plan.err().flatten() {
            Some(plan) => self.vectors.run(ReactionRun {
                alone,
                plan: &plan,
                range,
                read,
                results,
            }),
            None => {
                for (result, row) in results.iter_mut().zip(range) {
                    *result = alone.read(row, read);
                }
            }
        }
    }

    /// The plan by a pose; none if poses are solved one by one.
    fn plan(
        &self,
        reactions: &NamedReactions<'_>,
        row: usize,
        varies: bool,
    ) -> Result<Option<PosePlan>, ReactionError> {
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
        let plan = PosePlan::new(reactions, &reactions.place(&motions, &unknowns), varies)?;
        Ok(plan.filter(|plan| !self.asks_for_direction(plan, row)))
    }

    /// Whether a plan asks for the angle of a direction, of which a batch gives cosine and sine.
    fn asks_for_direction(&self, plan: &PosePlan, row: usize) -> bool {
        let mut sines = Vec::new();
        for quantity in &plan.needed {
            if let Some(Slot::Unknown(index, _)) = self.slot(*quantity, 0) {
                sines.push((Slot::Sine(index), f64::NAN));
            }
        }
        let wanted = sines
            .iter_mut()
            .map(|(slot, sine)| (*slot, core::slice::from_mut(sine)));
        let mut wanted = WantedColumns::new(wanted.collect());
        let solved = self.motions_of(row..row + 1, &mut wanted, &mut [Outcome::Unsolved]);
        drop(wanted);
        solved.is_err() || sines.iter().any(|(_, sine)| !sine.is_nan())
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

    /// Where a batch writes a derivative of a quantity; none of a parameter.
    fn slot(&self, quantity: usize, order: usize) -> Option<Slot> {
        let description = self.reactions.functions.description();
        let [inputs, unknowns] = [description.inputs.len(), description.unknowns.len()];
        let index = quantity.checked_sub(description.parameters.len())?;
        Some(if index < inputs {
            Slot::Input(index, order)
        } else if index < inputs + unknowns {
            Slot::Unknown(index - inputs, order)
        } else {
            Slot::Output(index - inputs - unknowns, order)
        })
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
    fn read<R>(&mut self, row: usize, read: &impl Fn(Result<PoseReactions<'_>, ReactionError>) -> R) -> R {
        let (motions, near) = (self.batch.motions(row), self.batch.near(row));
        let position = self.batch.position(&near);
        if self.varies {
            let reactions = self.batch.reactions.with_parameters(&self.batch.parameters(row));
            return read(reactions.prepared().alone(&motions, position));
        }
        read(self.prepared.at(&motions, position))
    }
}

/// A range of poses with their results.
struct ReactionRun<'r, 'b, R, F> {
    alone: Alone<'r, 'b>,
    plan: &'r PosePlan,
    range: Range<usize>,
    read: &'r F,
    results: &'r mut [R],
}

impl<R, F: Fn(Result<PoseReactions<'_>, ReactionError>) -> R> Kernel for ReactionRun<'_, '_, R, F> {
    type Result = ();
    type Element = f64;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<const W: usize, const FUSED: bool>(self) {
        let Self {
            mut alone,
            plan,
            range,
            read,
            results,
        } = self;
        let (batch, reactions) = (alone.batch, alone.prepared.reactions());
        let outline = reactions.functions.outline();
        let mut room = plan.room::<Lanes<W, FUSED>>(reactions);
        let moving = plan
            .needed
            .iter()
            .copied()
            .filter(|quantity| batch.slot(*quantity, 0).is_some());
        let mut columns = Columns {
            moving: moving.collect(),
            numbers: Vec::new(),
        };
        columns.numbers.resize(columns.moving.len() * TERMS * BLOCK, 0.0);
        let mut outcomes = [Outcome::Unsolved; BLOCK];
        for block in range.clone().step_by(BLOCK) {
            let rows = block..range.end.min(block + BLOCK);
            let outcomes = &mut outcomes[..rows.len()];
            columns.find(batch, rows.clone(), outcomes);
            for start in (0..rows.len()).step_by(W) {
                let first = block + start;
                columns.gather(start, &mut room.moved.quantities);
                for (quantity, column) in plan.needed.iter().zip(dimensions(batch, plan)) {
                    if column.length().is_some() {
                        room.moved.quantities[*quantity] =
                            SeriesOf::from_coefficients(with_value(Lanes::from_fn(|lane| column.at(first + lane))));
                    }
                }
                if plan.is_drawn() {
                    draw(plan, reactions, rows.len() - start, &mut room);
                }
                let found = lanes(&mut room, plan, reactions, &outline);
                for lane in 0..W.min(rows.len() - start) {
                    let is_solved = found.is_some_and(|sum| sum.0[lane].is_finite());
                    results[first + lane - range.start] = if is_solved && outcomes[start + lane].is_solved() {
                        read(Ok(PoseReactions::of(&room.solution, lane)))
                    } else {
                        alone.read(first + lane, read)
                    };
                }
            }
        }
    }
}

/// The poses of a chunk; none if none of them is solved.
#[cfg_attr(not(debug_assertions), inline(always))]
fn lanes<const W: usize, const FUSED: bool>(
    room: &mut PoseRoom<Lanes<W, FUSED>>,
    plan: &PosePlan,
    reactions: &NamedReactions<'_>,
    outline: &Outline<'_>,
) -> Option<Lanes<W, FUSED>> {
    room.solve(plan, reactions, outline).ok().flatten()
}

/// The columns of the dimensions that a plan asks for, which stand first among what it asks for.
fn dimensions<'b>(batch: &ReactionBatch<'b>, plan: &PosePlan) -> impl Iterator<Item = Column<'b>> {
    let columns = batch.dimensions;
    plan.needed
        .iter()
        .map_while(move |quantity| columns.get(*quantity).copied())
}

/// The coefficients of a number that does not move.
#[cfg_attr(not(debug_assertions), inline(always))]
fn with_value<S: Number, const N: usize>(value: S) -> [S; N] {
    let mut terms = [S::constant(0.0); N];
    terms[0] = value;
    terms
}

/// The motions of the quantities that a plan asks for, in a block of poses.
struct Columns {
    moving: Vec<usize>,
    numbers: Vec<f64>,
}

impl Columns {
    fn find(&mut self, batch: &ReactionBatch<'_>, rows: Range<usize>, outcomes: &mut [Outcome]) {
        let slots = self
            .moving
            .iter()
            .flat_map(|quantity| (0..TERMS).map(|order| (*quantity, order)));
        let columns = self.numbers.chunks_exact_mut(BLOCK);
        let wanted = slots.zip(columns).filter_map(|((quantity, order), column)| {
            let slot = batch.slot(quantity, order)?;
            Some((slot, &mut column[..rows.len()]))
        });
        let mut wanted = WantedColumns::new(wanted.collect());
        if batch.motions_of(rows, &mut wanted, outcomes).is_err() {
            // the lengths have been checked
            outcomes.fill(Outcome::Failed);
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn gather<const W: usize, const FUSED: bool>(
        &self,
        start: usize,
        quantities: &mut [SeriesOf<Lanes<W, FUSED>, TERMS>],
    ) {
        for (quantity, columns) in self.moving.iter().zip(self.numbers.chunks_exact(TERMS * BLOCK)) {
            let mut derivatives = [Lanes([0.0; W]); TERMS];
            for (order, lanes) in derivatives.iter_mut().enumerate() {
                lanes.0.copy_from_slice(&columns[order * BLOCK + start..][..W]);
            }
            quantities[*quantity] = SeriesOf::from_derivatives(derivatives);
        }
    }
}

/// Finds where the joints stand that no output tells, pose by pose.
fn draw<const W: usize, const FUSED: bool>(
    plan: &PosePlan,
    reactions: &NamedReactions<'_>,
    count: usize,
    room: &mut PoseRoom<Lanes<W, FUSED>>,
) {
    let mut quantities: Vec<MovingPose> = vec![Series::ZERO; room.moved.quantities.len()];
    for lane in 0..W.min(count) {
        for quantity in &plan.needed {
            let own = room.moved.quantities[*quantity].coefficients();
            quantities[*quantity] = Series::from_coefficients(own.map(|term| term.0[lane]));
        }
        plan.draw(reactions, &quantities, &mut |index, place| {
            let own = &mut room.moved.places[index];
            *own = Space::new(
                with_lane(own.x, lane, place.x),
                with_lane(own.y, lane, place.y),
                with_lane(own.z, lane, place.z),
            );
        });
    }
}

/// A series with that of another pose in a lane.
fn with_lane<const W: usize, const FUSED: bool>(
    series: SeriesOf<Lanes<W, FUSED>, TERMS>,
    lane: usize,
    own: MovingPose,
) -> SeriesOf<Lanes<W, FUSED>, TERMS> {
    let mut terms = series.coefficients();
    for (term, own) in terms.iter_mut().zip(own.coefficients()) {
        term.0[lane] = own;
    }
    SeriesOf::from_coefficients(terms)
}
