//! The equations of equilibrium, and their solution in series.

use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

use super::action::{Action, Exertion, Influence, Influences, Wrench};
use super::connection::{Connection, Member, balls, holders};
use super::frames::{MovedFrame, MovedMechanism, MovingNumber, across, between, real, times};
use super::friction::ActingFriction;
use super::ordered::OrderedSystem;
use super::pose_number::{PoseNumber, SinglePose};
use super::rank::{Rank, largest, rank};
use super::rolling::{Flank, Mesh, PitchPoint};
use super::{ReactionError, ReactionPart, size};
use crate::geometry::Space;
use crate::number::Number;
use crate::number::series::{Series, SeriesOf};
use crate::picture::Outline;

/// What is unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Unknown {
    /// The force of a pin along an axis of coordinates.
    Pin { connection: usize, axis: usize },
    /// A force of a slide at right angles to it, by its number.
    Normal { connection: usize, axis: usize },
    /// A moment of a slide, or of a hinge of space, about one of the axes about which it may hold.
    Moment { connection: usize, on: Member, axis: usize },
    /// The tangential force of a contact.
    Contact { connection: usize },
    /// The effort of the drive of an input.
    Effort { input: usize },
}

impl Unknown {
    /// The connection of which it is a force or a moment.
    pub(super) fn connection(self) -> Option<usize> {
        match self {
            Self::Pin { connection, .. }
            | Self::Normal { connection, .. }
            | Self::Moment { connection, .. }
            | Self::Contact { connection } => Some(connection),
            Self::Effort { .. } => None,
        }
    }
}

/// A result, unless equilibrium does not determine it.
pub(super) type Determined<const N: usize, S = f64> = Option<SeriesOf<S, N>>;

/// The coordinates of a vector, without those that equilibrium does not determine.
#[derive(Clone, Copy, Debug)]
pub(super) struct DeterminedVector<const N: usize, S = f64>(pub(super) [Determined<N, S>; 3]);

impl<S: PoseNumber, const N: usize> DeterminedVector<N, S> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn zero() -> Self {
        Self([Some(SeriesOf::constant(0.0)); 3])
    }

    /// The vector, if all of it is determined.
    pub(super) fn whole(self) -> Option<Space<SeriesOf<S, N>>> {
        let [x, y, z] = self.0;
        Some(Space::new(x?, y?, z?))
    }

    /// Adds a vector along a direction, of a size that may not be determined.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn add(&mut self, direction: Space<SeriesOf<S, N>>, size: Determined<N, S>) {
        let parts = [direction.x, direction.y, direction.z];
        for (own, part) in self.0.iter_mut().zip(parts) {
            match (size, &own) {
                (Some(size), Some(before)) => *own = Some(*before + part * size),
                (None, Some(_)) if takes_part(part) => *own = None,
                _ => {}
            }
        }
    }
}

impl<const N: usize> DeterminedVector<N> {
    fn map(self, change: impl Fn(Series<N>) -> Series<N>) -> Self {
        Self(self.0.map(|part| part.map(&change)))
    }
}

/// Whether a part of a direction is more than rounding.
fn takes_part<S: PoseNumber, const N: usize>(part: SeriesOf<S, N>) -> bool {
    let mut terms = part.coefficients().into_iter().take(TERMS);
    terms.any(|term| term.real().abs() > NO_PART)
}

/// The forces of all connections, and the efforts.
#[derive(Clone, Debug)]
pub(super) struct Solution<const N: usize, S = f64> {
    pub(super) is_space: bool,
    /// The force of each connection.
    pub(super) forces: Vec<DeterminedVector<N, S>>,
    /// The moment of each connection about its joint.
    pub(super) moments: Vec<DeterminedVector<N, S>>,
    /// The effort of each drive.
    pub(super) efforts: Vec<Determined<N, S>>,
    /// The friction on the body of each connection, which its force or moment contains.
    pub(super) frictions: Vec<SeriesOf<S, N>>,
    /// The power that friction turns into heat, by the variable.
    pub(super) heat: SeriesOf<S, N>,
    /// The same in the motion that gives friction its sense, by time.
    pub(super) begun_heat: f64,
    /// The factor by which forces and friction contract.
    pub(super) contraction: f64,
    /// The couples with which guides keep bodies from turning, which need not be those on which the forces of the
    /// slides act.
    pub(super) turned: Vec<(usize, Wrench<SeriesOf<S, N>>)>,
}

impl<S: PoseNumber, const N: usize> Solution<N, S> {
    /// No forces.
    pub(super) fn empty(is_space: bool, connections: usize, drives: usize) -> Self {
        Self {
            is_space,
            forces: vec![DeterminedVector::zero(); connections],
            moments: vec![DeterminedVector::zero(); connections],
            efforts: vec![Some(SeriesOf::constant(0.0)); drives],
            frictions: vec![SeriesOf::constant(0.0); connections],
            heat: SeriesOf::constant(0.0),
            begun_heat: 0.0,
            contraction: 0.0,
            turned: Vec::new(),
        }
    }
}

impl<S: SinglePose, const N: usize> Solution<N, S> {
    /// One part of the force of a connection.
    pub(super) fn part(&self, index: usize, part: ReactionPart) -> Determined<N, S> {
        let (force, moment) = (self.forces[index], self.moments[index]);
        match part {
            ReactionPart::X => force.0[0],
            ReactionPart::Y => force.0[1],
            ReactionPart::Z => force.0[2],
            ReactionPart::Force => force.whole().map(size),
            ReactionPart::Moment if self.is_space => moment.whole().map(size),
            ReactionPart::MomentX => moment.0[0],
            ReactionPart::MomentY => moment.0[1],
            ReactionPart::Moment | ReactionPart::MomentZ => moment.0[2],
        }
    }
}

impl<const N: usize> Solution<N> {
    /// The first terms of all forces, moments and efforts.
    pub(super) fn resized<const M: usize>(&self) -> Solution<M> {
        let determined = |own: &Determined<N>| own.map(|series| series.resized());
        let vector = |own: &DeterminedVector<N>| DeterminedVector(own.0.map(|own| determined(&own)));
        Solution {
            forces: self.forces.iter().map(vector).collect(),
            moments: self.moments.iter().map(vector).collect(),
            efforts: self.efforts.iter().map(determined).collect(),
            ..Solution::empty(self.is_space, self.forces.len(), 0)
        }
    }

    /// The same, where each series becomes another one.
    pub(super) fn map(self, change: impl Fn(Series<N>) -> Series<N>) -> Self {
        let all = |series: Vec<Determined<N>>| series.into_iter().map(|own| own.map(&change)).collect();
        let vectors = |vectors: Vec<DeterminedVector<N>>| vectors.into_iter().map(|own| own.map(&change)).collect();
        Self {
            forces: vectors(self.forces),
            moments: vectors(self.moments),
            efforts: all(self.efforts),
            frictions: self.frictions.into_iter().map(&change).collect(),
            heat: change(self.heat),
            turned: self.turned,
            ..self
        }
    }
}

/// The places of the equations of each body: those of forces, and then those of moments.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    /// The first equation of each body, and the number of all.
    starts: Vec<usize>,
    /// The reciprocal of the largest distance between joints, by which moments are multiplied.
    scale: f64,
}

impl Rows {
    pub(super) fn of<T: MovingNumber>(moved: &MovedMechanism<T>, frames: &[MovedFrame<T>]) -> Self {
        let mut starts = vec![0];
        for frame in frames {
            starts.push(starts[starts.len() - 1] + moved.dimensions() + frame.turns().len());
        }
        let joints: Vec<Space<f64>> = moved.places[..moved.joints].iter().copied().map(real).collect();
        let pairs = joints
            .iter()
            .flat_map(|one| joints.iter().map(|other| (*other - *one).norm_squared()));
        let square = pairs.fold(0.0, f64::max);
        let scale = if square > 0.0 { 1.0 / Number::sqrt(square) } else { 1.0 };
        Self { starts, scale }
    }

    /// Whether the bodies have the same equations in another pose.
    pub(super) fn fit<T: MovingNumber>(&self, moved: &MovedMechanism<T>, frames: &[MovedFrame<T>]) -> bool {
        let mut starts = self.starts.windows(2).zip(frames);
        starts.all(|(starts, frame)| starts[1] - starts[0] == moved.dimensions() + frame.turns().len())
    }

    /// The number of all equations.
    pub(super) fn count(&self) -> usize {
        self.starts[self.starts.len() - 1]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_body(&self, body: usize) -> Range<usize> {
        self.starts[body]..self.starts[body + 1]
    }
}

/// The arm of a pin of the plane on a body, by which its forces have moments there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arm {
    body: usize,
    joint: usize,
    /// The equation of moments, and the unknown along x, behind which that along y stands.
    row: usize,
    column: usize,
    factor: f64,
}

/// What takes the entries of a column.
pub(super) trait TakesEntries<T> {
    // a method, because a closure cannot be marked for inlining
    fn take(&mut self, row: usize, entry: T);
}

/// A column, to which entries are added.
struct Added<'c, T>(&'c mut [T]);

impl<T: MovingNumber> TakesEntries<T> for Added<'_, T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn take(&mut self, row: usize, entry: T) {
        self.0[row] = self.0[row] + entry;
    }
}

/// A column, from which entries are taken away.
pub(super) struct TakenAway<'c, T>(pub(super) &'c mut [T]);

impl<T: MovingNumber> TakesEntries<T> for TakenAway<'_, T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn take(&mut self, row: usize, entry: T) {
        self.0[row] = self.0[row] - entry;
    }
}

/// A column of a planned order.
struct Planned<'s, S, const N: usize> {
    system: &'s mut OrderedSystem<N, S>,
    column: usize,
    /// Whether all entries have places.
    fits: bool,
}

impl<S: PoseNumber, const N: usize> TakesEntries<SeriesOf<S, N>> for Planned<'_, S, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn take(&mut self, row: usize, entry: SeriesOf<S, N>) {
        self.fits &= self.system.set(row, self.column, entry);
    }
}

pub(super) struct Equations<'e, T> {
    pub(super) outline: &'e Outline<'e>,
    pub(super) connections: &'e [Connection],
    pub(super) rows: &'e Rows,
    pub(super) moved: &'e MovedMechanism<T>,
    pub(super) frames: &'e [MovedFrame<T>],
    pub(super) drives: &'e [Action],
    pub(super) frictions: &'e [ActingFriction<T>],
    /// How each contact bears.
    pub(super) flanks: &'e [Flank],
    /// -1 on the left side of a place.
    pub(super) parity: f64,
}

impl<S: SinglePose, const N: usize> Equations<'_, SeriesOf<S, N>> {
    /// The forces with which the bodies move as they do, from what each lacks without them.
    pub(super) fn solve(
        &self,
        unknowns: &[Unknown],
        columns: &[Vec<SeriesOf<S, N>>],
        right: &[SeriesOf<S, N>],
    ) -> Result<Solution<N, S>, ReactionError> {
        let basis = self.basis(unknowns, columns)?;
        let chosen: Vec<_> = basis.iter().map(|column| columns[*column].clone()).collect();
        let mut system = OrderedSystem::of(&chosen).ok_or(ReactionError::NotFinite)?;
        let mut values = vec![SeriesOf::constant(0.0); unknowns.len()];
        for (column, value) in basis.iter().zip(system.solve(right)) {
            values[*column] = *value;
        }
        let mut is_undetermined = vec![false; unknowns.len()];
        for free in (0..unknowns.len()).filter(|column| !basis.contains(column)) {
            is_undetermined[free] = true;
            let parts = system.solve(&columns[free]);
            let taking_part = taking_part(parts, &basis, columns, &columns[free]);
            for (column, takes_part) in basis.iter().zip(taking_part) {
                is_undetermined[*column] |= takes_part;
            }
        }
        self.completed(unknowns, values, &is_undetermined, |own| {
            let mut response = vec![SeriesOf::constant(0.0); unknowns.len()];
            for (column, value) in basis.iter().zip(system.solve(own)) {
                response[*column] = *value;
            }
            response
        })
    }

    /// The same in a planned order; none if it does not fit.
    pub(super) fn solve_in(
        &self,
        system: &mut OrderedSystem<N, S>,
        unknowns: &[Unknown],
        right: &[SeriesOf<S, N>],
    ) -> Result<Option<Solution<N, S>>, ReactionError> {
        let mut columns = unknowns.iter().enumerate();
        if !columns.all(|(column, unknown)| self.fill(system, column, *unknown)) || !system.factor() {
            return Ok(None);
        }
        let values = system.solve(right).to_vec();
        let is_undetermined = vec![false; unknowns.len()];
        let found = self.completed(unknowns, values, &is_undetermined, |own| system.solve(own).to_vec());
        found.map(Some)
    }

    /// The forces from their values without friction, and what they answer to another right side.
    pub(super) fn completed(
        &self,
        unknowns: &[Unknown],
        values: Vec<SeriesOf<S, N>>,
        is_undetermined: &[bool],
        mut response: impl FnMut(&[SeriesOf<S, N>]) -> Vec<SeriesOf<S, N>>,
    ) -> Result<Solution<N, S>, ReactionError> {
        if !values.iter().all(|value| value.is_finite()) {
            return Err(ReactionError::NotFinite);
        }
        if self.frictions.is_empty() {
            return Ok(self.solution(unknowns, &values, is_undetermined));
        }
        let responses = self.frictions.iter().map(|acting| response(&self.resisting(acting)));
        let responses: Vec<_> = responses.collect();
        self.with_friction(unknowns, values, is_undetermined, &responses)
    }

    /// The unknowns that hold the bodies, by their indices.
    pub(super) fn basis(
        &self,
        unknowns: &[Unknown],
        columns: &[Vec<SeriesOf<S, N>>],
    ) -> Result<Vec<usize>, ReactionError> {
        let reals: Vec<Vec<f64>> = columns.iter().map(|column| reals(column)).collect();
        let Rank { basis, null, pivot } = rank(&reals);
        if unknowns.len() < self.rows.count() {
            return Err(self.free(columns));
        }
        if basis.len() < self.rows.count() {
            let grows = self.taking_part(unknowns, &null);
            return Err(ReactionError::Singular { pivot, grows });
        }
        Ok(basis)
    }

    /// The forces of a unit of each unknown.
    pub(super) fn columns(&self, unknowns: &[Unknown]) -> Vec<Vec<SeriesOf<S, N>>> {
        unknowns.iter().map(|unknown| self.column(*unknown)).collect()
    }

    /// All unknowns. Slides have moments where nothing else keeps the slider from turning.
    pub(super) fn unknowns<const M: usize>(&self, influences: &Influences<'_, '_, M>) -> Vec<Unknown> {
        let mut unknowns: Vec<Unknown> = Vec::new();
        let dimensions = self.moved.dimensions();
        for (connection, own) in self.connections.iter().enumerate() {
            if own.mesh.is_some() {
                unknowns.push(Unknown::Contact { connection });
            } else if own.slide.is_some() {
                unknowns.extend((0..dimensions - 1).map(|axis| Unknown::Normal { connection, axis }));
            } else {
                unknowns.extend((0..dimensions).map(|axis| Unknown::Pin { connection, axis }));
            }
            if own.hinge.is_some() {
                let on = own.on;
                unknowns.extend([0, 1].map(|axis| Unknown::Moment { connection, on, axis }));
            }
        }
        unknowns.extend((0..self.drives.len()).map(|input| Unknown::Effort { input }));
        if self.outline.slides.is_empty() {
            return unknowns;
        }
        let mut columns = self.columns(&unknowns);
        for (connection, own) in self.connections.iter().enumerate() {
            let (Some(slide), Some(joint)) = (own.slide, own.joint) else {
                continue;
            };
            let guide = self.outline.slides[slide].guide;
            for on in holders(self.outline, joint) {
                for (axis, about) in turning(self.moved, self.frames, own, on)
                    .into_iter()
                    .flatten()
                    .enumerate()
                {
                    let about = real(about);
                    let turns = |motion: &Vec<f64>| {
                        let [on, by] = [on, guide].map(|member| self.turn(member, motion));
                        (on - by).dot(about).abs() > NO_PART * largest(motion)
                    };
                    let alone = |one: &Influence<M>| turning(&one.moved, &one.frames, own, on)[axis];
                    if influences.keeps_angle([on, guide], alone) && self.freedoms(&columns).iter().any(turns) {
                        let unknown = Unknown::Moment { connection, on, axis };
                        columns.push(self.column(unknown));
                        unknowns.push(unknown);
                    }
                }
            }
        }
        unknowns
    }

    /// The rate at which a body turns in a motion of all.
    fn turn(&self, member: Member, motion: &[f64]) -> Space<f64> {
        let Some(body) = member else { return Space::zero() };
        let frame = &self.frames[body];
        let rates = &motion[self.rows.of_body(body)][self.moved.dimensions()..];
        let parts = frame.turns().iter().zip(rates);
        parts.fold(Space::zero(), |sum, (axis, rate)| sum + real(*axis).scale(*rate))
    }

    /// Which bodies can move though the inputs stand.
    fn free(&self, columns: &[Vec<SeriesOf<S, N>>]) -> ReactionError {
        let freedoms = self.freedoms(columns);
        let moves =
            |motion: &Vec<f64>, body: usize| largest(&motion[self.rows.of_body(body)]) > NO_PART * largest(motion);
        let bodies = self.outline.bodies.iter().enumerate();
        let bodies = bodies.filter(|(body, _)| freedoms.iter().any(|motion| moves(motion, *body)));
        ReactionError::Free {
            freedoms: freedoms.len(),
            bodies: bodies.map(|(_, body)| body.name.to_string()).collect(),
            equations: self.outline.scalar_equations.iter().map(ToString::to_string).collect(),
            balls: if self.moved.is_space {
                balls(self.connections)
            } else {
                Vec::new()
            },
        }
    }

    /// The connections with a part in combinations that are zero.
    fn taking_part(&self, unknowns: &[Unknown], combinations: &[Vec<f64>]) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for (column, unknown) in unknowns.iter().enumerate() {
            let takes_part = |combination: &Vec<f64>| combination[column].abs() > NO_PART * largest(combination);
            let Some(connection) = unknown.connection() else {
                continue;
            };
            let name = &self.connections[connection].name;
            if combinations.iter().any(takes_part) && !names.contains(name) {
                names.push(name.clone());
            }
        }
        names
    }

    /// The motions of the bodies that no column resists: a velocity and a rate of turning for each.
    fn freedoms(&self, columns: &[Vec<SeriesOf<S, N>>]) -> Vec<Vec<f64>> {
        let rows: Vec<Vec<f64>> = (0..self.rows.count())
            .map(|row| columns.iter().map(|column| column[row].real()).collect())
            .collect();
        rank(&rows).null
    }

    pub(super) fn solution(
        &self,
        unknowns: &[Unknown],
        values: &[SeriesOf<S, N>],
        is_undetermined: &[bool],
    ) -> Solution<N, S> {
        let mut solution = Solution::empty(self.moved.is_space, self.connections.len(), self.drives.len());
        self.write(unknowns, values, |unknown| is_undetermined[unknown], &mut solution);
        solution
    }
}

impl<S: PoseNumber, const N: usize> Equations<'_, SeriesOf<S, N>> {
    /// How the contacts bear under these forces.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn bears(&self, solution: &Solution<N, S>, flanks: &mut [Flank]) {
        for (connection, flank) in flanks.iter_mut().enumerate() {
            let Some((mesh, pitch)) = self.pitch_point(connection) else {
                continue;
            };
            let force = solution.forces[connection].whole();
            let tangential = force.and_then(|force| pitch.tangential(mesh, force));
            match tangential.map(MovingNumber::now) {
                Some(tangential) if tangential.exceeds(0.0, tangential) => {
                    flank.sign = if tangential.is_negative() { -1.0 } else { 1.0 };
                }
                _ => {}
            }
        }
    }

    /// Writes the entries of an unknown into a planned order. False if they do not fit.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn fill(&self, system: &mut OrderedSystem<N, S>, column: usize, unknown: Unknown) -> bool {
        let fits = true;
        let mut planned = Planned { system, column, fits };
        self.entries(unknown, &mut planned);
        planned.fits
    }

    /// Writes what moves of the entries of the pins of the plane.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn fill_arms(&self, system: &mut OrderedSystem<N, S>, arms: &[Arm]) -> bool {
        let mut fits = true;
        for arm in arms {
            let (at, origin) = (self.moved.places[arm.joint], self.frames[arm.body].origin);
            fits &= system.set(arm.row, arm.column, (-(at.y - origin.y)).times(arm.factor));
            fits &= system.set(arm.row, arm.column + 1, (at.x - origin.x).times(arm.factor));
        }
        fits
    }

    /// Writes the forces of these values into a solution of other values or of none.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn write(
        &self,
        unknowns: &[Unknown],
        values: &[SeriesOf<S, N>],
        is_undetermined: impl Fn(usize) -> bool,
        solution: &mut Solution<N, S>,
    ) {
        // those of pins are written one by one, and others add up
        for (index, own) in self.connections.iter().enumerate() {
            if !own.is_pin() {
                solution.forces[index] = DeterminedVector::zero();
                solution.moments[index] = DeterminedVector::zero();
            }
        }
        solution.turned.clear();
        for (index, (unknown, value)) in unknowns.iter().zip(values).enumerate() {
            let known = (!is_undetermined(index)).then_some(*value);
            match *unknown {
                Unknown::Pin { connection, axis } => solution.forces[connection].0[axis] = known,
                Unknown::Normal { connection, axis } => {
                    let normal = self.normal(&self.connections[connection], axis);
                    solution.forces[connection].add(normal, known);
                }
                Unknown::Moment { connection, on, axis } => {
                    let own = &self.connections[connection];
                    let about = self.about(own, on, axis);
                    let by = self.holding(own);
                    // the reaction acts on the guide where the slider is the ground
                    let is_turned = own.on == by && on != by;
                    let sign = if is_turned { -1.0 } else { 1.0 };
                    solution.moments[connection].add(times(about, sign), known);
                    if own.slide.is_some() {
                        let moment = about.scale(known.unwrap_or(SeriesOf::constant(0.0)));
                        let couple = Exertion::of_couple([on, by], moment);
                        for end in 0..2 {
                            solution.turned.extend(couple.wrench(end, self.frames));
                        }
                    }
                }
                Unknown::Contact { connection } => {
                    solution.forces[connection].add(self.bearing(connection), known);
                }
                Unknown::Effort { input } => solution.efforts[input] = known,
            }
        }
    }
}

impl<T: MovingNumber> Equations<'_, T> {
    /// The arms of all pins of the plane, and the unknowns of which other entries move.
    pub(super) fn arms(&self, unknowns: &[Unknown]) -> (Vec<Arm>, Vec<(usize, Unknown)>) {
        let (mut arms, mut others) = (Vec::new(), Vec::new());
        for (column, unknown) in unknowns.iter().enumerate() {
            match *unknown {
                Unknown::Pin { axis: 1, .. } if !self.moved.is_space => {}
                Unknown::Pin { connection, axis: 0 } if !self.moved.is_space => {
                    let own = &self.connections[connection];
                    for (member, sign) in [(own.on, 1.0), (own.by, -1.0)] {
                        let (Some(body), Some(joint)) = (member, own.joint) else {
                            continue;
                        };
                        // the force at the origin of a body has no moment about it
                        if self.outline.bodies[body].joints.first() != Some(&joint) {
                            arms.push(Arm {
                                body,
                                joint,
                                row: self.rows.of_body(body).start + 2,
                                column,
                                factor: sign * self.rows.scale,
                            });
                        }
                    }
                }
                Unknown::Effort { input } if self.drives[input].is_still() => {}
                _ => others.push((column, *unknown)),
            }
        }
        (arms, others)
    }

    /// Passes on the forces of a unit of an unknown on all bodies, each with the number of its equation.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn entries(&self, unknown: Unknown, entries: &mut impl TakesEntries<T>) {
        let exertion = match unknown {
            Unknown::Pin { connection, axis } => return self.entries_of_pin(connection, axis, entries),
            Unknown::Normal { connection, axis } => {
                self.of_force(connection, self.normal(&self.connections[connection], axis))
            }
            Unknown::Contact { connection } => self.of_force(connection, self.bearing(connection)),
            Unknown::Moment { connection, on, axis } => {
                let own = &self.connections[connection];
                Exertion::of_couple([on, self.holding(own)], self.about(own, on, axis))
            }
            Unknown::Effort { input } => self.drives[input].exertion(self.moved, T::constant(1.0)),
        };
        self.entries_of(&exertion, entries);
    }

    /// An axis about which a slide or a hinge of space holds a body by a moment.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn about(&self, own: &Connection, on: Member, axis: usize) -> Space<T> {
        turning(self.moved, self.frames, own, on)[axis].unwrap_or_else(Space::zero)
    }

    /// The same for a force or a couple.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn entries_of(&self, exertion: &Exertion<T>, entries: &mut impl TakesEntries<T>) {
        for end in 0..2 {
            if let Some((body, wrench)) = exertion.wrench(end, self.frames) {
                self.entries_of_wrench(body, &wrench, entries);
            }
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn entries_of_pin(&self, connection: usize, axis: usize, entries: &mut impl TakesEntries<T>) {
        let own = &self.connections[connection];
        let Some(joint) = own.joint else { return };
        for (member, sign) in [(own.on, 1.0), (own.by, -1.0)] {
            let Some(body) = member else { continue };
            let start = self.rows.of_body(body).start;
            entries.take(start + axis, T::constant(sign));
            let moment = self.frames[body].moment_along(axis, self.moved.places[joint]);
            self.entries_of_moment(body, moment, sign, entries);
        }
    }

    /// The same for a force on a body.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn entries_of_wrench(&self, body: usize, wrench: &Wrench<T>, entries: &mut impl TakesEntries<T>) {
        let start = self.rows.of_body(body).start;
        let Space { x, y, z } = wrench.force;
        entries.take(start, x);
        entries.take(start + 1, y);
        if self.moved.is_space {
            entries.take(start + 2, z);
        }
        self.entries_of_moment(body, wrench.moment, 1.0, entries);
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn entries_of_moment(&self, body: usize, moment: Space<T>, sign: f64, entries: &mut impl TakesEntries<T>) {
        let start = self.rows.of_body(body).start + self.moved.dimensions();
        let (frame, factor) = (&self.frames[body], sign * self.rows.scale);
        if frame.is_plane() {
            return entries.take(start, moment.z.times(factor));
        }
        for (turn, axis) in frame.turns().iter().enumerate() {
            entries.take(start + turn, axis.dot(moment).times(factor));
        }
    }

    /// The forces of a unit of an unknown on all bodies.
    pub(super) fn column(&self, unknown: Unknown) -> Vec<T> {
        let mut column = vec![T::constant(0.0); self.rows.count()];
        self.entries(unknown, &mut Added(&mut column));
        column
    }

    /// What bodies lack on which this acts, as a column.
    pub(super) fn lacking<'w>(&self, acting: impl Iterator<Item = (usize, &'w Wrench<T>)>) -> Vec<T> {
        let mut column = vec![T::constant(0.0); self.rows.count()];
        for (body, wrench) in acting {
            self.entries_of_wrench(body, wrench, &mut TakenAway(&mut column));
        }
        column
    }

    /// A force in a connection.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn of_force(&self, connection: usize, force: Space<T>) -> Exertion<T> {
        let own = &self.connections[connection];
        let joint = own.joint.map(|joint| self.moved.places[joint]);
        let pitch = self.pitch_point(connection).map(|(_, pitch)| pitch.at);
        match joint.or(pitch) {
            Some(at) => Exertion::of_force([own.on, own.by], force, [at; 2]),
            None => Exertion::of_force([None; 2], force, [Space::zero(); 2]),
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn pitch_point(&self, connection: usize) -> Option<(&Mesh, PitchPoint<T>)> {
        let mesh = self.connections[connection].mesh.as_ref()?;
        Some((mesh, mesh.pitch_point(self.moved, self.flanks[connection].side)))
    }

    /// The force of a contact for a unit of its tangential force.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn bearing(&self, connection: usize) -> Space<T> {
        let sign = self.flanks[connection].sign;
        let pitch = self.pitch_point(connection);
        pitch.map_or_else(Space::zero, |(mesh, pitch)| pitch.force(mesh, sign))
    }

    /// The body that exerts the moment of a connection.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holding(&self, own: &Connection) -> Member {
        own.slide.map_or(own.by, |slide| self.outline.slides[slide].guide)
    }

    /// Forces on all bodies as a column.
    pub(super) fn flat_column(&self, exertion: &Exertion<T>) -> Vec<T> {
        let mut column = vec![T::constant(0.0); self.rows.count()];
        self.entries_of(exertion, &mut Added(&mut column));
        column
    }

    /// A direction at right angles to the slide of a connection.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn normal(&self, own: &Connection, axis: usize) -> Space<T> {
        let normal = |slide| across(self.moved.along(slide), self.moved.is_space)[axis];
        own.slide.map_or_else(Space::zero, normal)
    }
}

/// The axes about which a slide or a hinge of space may hold a body by a moment.
#[cfg_attr(not(debug_assertions), inline(always))]
fn turning<T: MovingNumber>(
    moved: &MovedMechanism<T>,
    frames: &[MovedFrame<T>],
    own: &Connection,
    on: Member,
) -> [Option<Space<T>>; 3] {
    let Some(axis) = own.axis().map(|axis| moved.axis(axis)) else {
        return [None; 3];
    };
    let [first, second] = across(axis, moved.is_space);
    if own.slide.is_none() {
        return [Some(first), Some(second), None];
    }
    if !moved.is_space {
        return [Some(second), None, None];
    }
    match on.and_then(|body| frames[body].line()) {
        None => [axis, first, second].map(Some),
        // nothing acts about the line of a rod
        Some(line) => match between(line, axis) {
            None => [Some(first), Some(second), None],
            Some(normal) => [Some(normal.cross(line)), Some(normal), None],
        },
    }
}

/// What is at most this part of the largest is rounding.
const NO_PART: f64 = 1e-9;

fn reals<S: SinglePose, const N: usize>(column: &[SeriesOf<S, N>]) -> Vec<f64> {
    column.iter().map(|entry| entry.real()).collect()
}

/// So many terms of a combination tell whether an unknown takes part in it: the value and both rates.
const TERMS: usize = 3;

/// Which unknowns of the basis take part in a combination that is zero, by the sizes of their forces beside that of the
/// column itself.
fn taking_part<S: SinglePose, const N: usize>(
    parts: &[SeriesOf<S, N>],
    basis: &[usize],
    columns: &[Vec<SeriesOf<S, N>>],
    own: &[SeriesOf<S, N>],
) -> Vec<bool> {
    let size = |column: &[SeriesOf<S, N>]| {
        column
            .iter()
            .fold(0.0, |largest: f64, entry| largest.max(entry.real().abs()))
    };
    let sizes: Vec<f64> = basis.iter().map(|column| size(&columns[*column])).collect();
    let terms = |index: usize| {
        parts[index]
            .coefficients()
            .map(|term| (term.real() * sizes[index]).abs())
    };
    let all = (0..parts.len()).flat_map(|index| terms(index).into_iter().take(TERMS));
    let largest = all.fold(size(own), f64::max);
    let takes_part = |index: usize| {
        terms(index)
            .into_iter()
            .take(TERMS)
            .any(|term| term > NO_PART * largest)
    };
    (0..parts.len()).map(takes_part).collect()
}
