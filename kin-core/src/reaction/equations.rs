//! The equations of equilibrium, and their solution in series.

use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

use super::action::{Action, Influence, Influences, Wrench, both, both_turned};
use super::connection::{Connection, Member, holders};
use super::frames::{MovedFrame, MovedMechanism, MovingNumber, across, along_axis, between, real};
use super::friction::ActingFriction;
use super::ordered::OrderedSystem;
use super::rank::{Rank, largest, rank};
use super::rolling::{Flank, Mesh, PitchPoint};
use super::{REACH, ReactionError, ReactionPart, size};
use crate::geometry::Space;
use crate::number::Number;
use crate::number::series::Series;
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
pub(super) type Determined<const N: usize> = Option<Series<N>>;

/// The coordinates of a vector, without those that equilibrium does not determine.
#[derive(Clone, Copy, Debug)]
pub(super) struct DeterminedVector<const N: usize>(pub(super) [Determined<N>; 3]);

impl<const N: usize> DeterminedVector<N> {
    const ZERO: Self = Self([Some(Series::ZERO); 3]);

    /// The vector, if all of it is determined.
    pub(super) fn whole(self) -> Option<Space<Series<N>>> {
        let [x, y, z] = self.0;
        Some(Space::new(x?, y?, z?))
    }

    fn map(self, change: impl Fn(Series<N>) -> Series<N>) -> Self {
        Self(self.0.map(|part| part.map(&change)))
    }

    /// Adds a vector along a direction, of a size that may not be determined.
    pub(super) fn add(&mut self, direction: Space<Series<N>>, size: Determined<N>) {
        let parts = [direction.x, direction.y, direction.z];
        for (own, part) in self.0.iter_mut().zip(parts) {
            let takes_part = || {
                part.coefficients()
                    .into_iter()
                    .take(TERMS)
                    .any(|term| term.abs() > NO_PART)
            };
            match size {
                Some(size) => *own = own.map(|own| own + part * size),
                None if takes_part() => *own = None,
                None => {}
            }
        }
    }
}

/// The forces of all connections, and the efforts.
#[derive(Clone, Debug)]
pub(super) struct Solution<const N: usize> {
    pub(super) is_space: bool,
    /// The force of each connection.
    pub(super) forces: Vec<DeterminedVector<N>>,
    /// The moment of each connection about its joint.
    pub(super) moments: Vec<DeterminedVector<N>>,
    /// The effort of each drive.
    pub(super) efforts: Vec<Determined<N>>,
    /// The friction on the body of each connection, which its force or moment contains.
    pub(super) frictions: Vec<Series<N>>,
    /// The power that friction turns into heat, by the variable.
    pub(super) heat: Series<N>,
    /// The same in the motion that gives friction its sense, by time.
    pub(super) begun_heat: f64,
    /// The factor by which forces and friction contract.
    pub(super) contraction: f64,
    /// The couples with which guides keep bodies from turning, which need not be those on which the forces of the
    /// slides act.
    pub(super) turned: Vec<(usize, Wrench<Series<N>>)>,
}

impl<const N: usize> Solution<N> {
    /// One part of the force of a connection.
    pub(super) fn part(&self, index: usize, part: ReactionPart) -> Determined<N> {
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

/// The unknowns, and the forces of a unit of each.
struct System<const N: usize> {
    unknowns: Vec<Unknown>,
    columns: Vec<Vec<Series<N>>>,
}

pub(super) struct Equations<'e, T> {
    pub(super) outline: &'e Outline<'e>,
    pub(super) connections: &'e [Connection],
    pub(super) influences: &'e Influences<'e, 'e, REACH>,
    pub(super) moved: &'e MovedMechanism<T>,
    pub(super) frames: &'e [MovedFrame<T>],
    pub(super) drives: &'e [Action],
    pub(super) frictions: &'e [ActingFriction<T>],
    /// How each contact bears.
    pub(super) flanks: &'e [Flank],
    /// -1 on the left side of a place.
    pub(super) parity: f64,
}

impl<const N: usize> Equations<'_, Series<N>> {
    /// The forces with which the bodies move as they do, from what each lacks without them.
    pub(super) fn solve(&self, demand: &[Wrench<Series<N>>]) -> Result<Solution<N>, ReactionError> {
        let (System { unknowns, columns }, basis) = self.determined()?;
        let chosen = basis.iter().map(|column| &columns[*column]);
        let system = OrderedSystem::new(chosen).map_err(|_| ReactionError::NotFinite)?;
        let lacking = demand.iter().copied().enumerate().collect();
        let right = self.flat_column(lacking);
        let mut values = vec![Series::ZERO; unknowns.len()];
        for (column, value) in basis.iter().zip(system.solve(&right)) {
            values[*column] = value;
        }
        let mut is_open = vec![false; unknowns.len()];
        for free in (0..unknowns.len()).filter(|column| !basis.contains(column)) {
            is_open[free] = true;
            let parts = system.solve(&columns[free]);
            let open = open(&parts, &basis, &columns, &columns[free]);
            for (column, takes_part) in basis.iter().zip(open) {
                is_open[*column] |= takes_part;
            }
        }
        if !values.iter().all(|value| value.is_finite()) {
            return Err(ReactionError::NotFinite);
        }
        if self.frictions.is_empty() {
            return Ok(self.solution(&unknowns, &values, &is_open));
        }
        let response = |acting: &ActingFriction<Series<N>>| {
            let mut response = vec![Series::ZERO; unknowns.len()];
            for (column, value) in basis.iter().zip(system.solve(&self.resisting(acting))) {
                response[*column] = value;
            }
            response
        };
        let responses: Vec<_> = self.frictions.iter().map(response).collect();
        self.with_friction(&unknowns, values, &is_open, &responses)
    }

    /// The unknowns with their columns, and those of them that hold the bodies.
    fn determined(&self) -> Result<(System<N>, Vec<usize>), ReactionError> {
        let System { unknowns, columns } = self.system();
        let reals: Vec<Vec<f64>> = columns.iter().map(|column| reals(column)).collect();
        let Rank { basis, null, pivot } = rank(&reals);
        let count = self.rows().last().map_or(0, |rows| rows.end);
        if unknowns.len() < count {
            return Err(self.free(&columns));
        }
        if basis.len() < count {
            let grows = self.taking_part(&unknowns, &null);
            return Err(ReactionError::Singular { pivot, grows });
        }
        Ok((System { unknowns, columns }, basis))
    }

    /// The unknowns that hold the bodies.
    pub(super) fn basis(&self) -> Result<Vec<Unknown>, ReactionError> {
        let (System { unknowns, .. }, basis) = self.determined()?;
        Ok(basis.into_iter().map(|column| unknowns[column]).collect())
    }

    /// The unknowns with their columns. Slides have moments where nothing else keeps the slider from turning.
    fn system(&self) -> System<N> {
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
        let mut columns: Vec<Vec<Series<N>>> = unknowns.iter().map(|unknown| self.column(*unknown)).collect();
        for (connection, own) in self.connections.iter().enumerate() {
            let (Some(slide), Some(joint)) = (own.slide, own.joint) else {
                continue;
            };
            let guide = self.outline.slides[slide].guide;
            for on in holders(self.outline, joint) {
                for axis in 0..turning(self.moved, self.frames, own, on).len() {
                    let about = real(turning(self.moved, self.frames, own, on)[axis]);
                    let turns = |motion: &Vec<f64>| {
                        let [on, by] = [on, guide].map(|member| self.turn(member, motion));
                        (on - by).dot(about).abs() > NO_PART * largest(motion)
                    };
                    let alone = |one: &Influence<REACH>| turning(&one.moved, &one.frames, own, on).get(axis).copied();
                    if self.influences.keeps_angle([on, guide], alone) && self.freedoms(&columns).iter().any(turns) {
                        let unknown = Unknown::Moment { connection, on, axis };
                        columns.push(self.column(unknown));
                        unknowns.push(unknown);
                    }
                }
            }
        }
        System { unknowns, columns }
    }

    /// The rate at which a body turns in a motion of all.
    fn turn(&self, member: Member, motion: &[f64]) -> Space<f64> {
        let Some(body) = member else { return Space::zero() };
        let frame = &self.frames[body];
        let rates = &motion[self.rows()[body].clone()][self.moved.dimensions()..];
        let parts = frame.turns().iter().zip(rates);
        parts.fold(Space::zero(), |sum, (axis, rate)| sum + real(*axis).scale(*rate))
    }

    /// Which bodies can move though the inputs stand.
    fn free(&self, columns: &[Vec<Series<N>>]) -> ReactionError {
        let freedoms = self.freedoms(columns);
        let moves = |motion: &Vec<f64>, rows: &Range<usize>| largest(&motion[rows.clone()]) > NO_PART * largest(motion);
        let rows = self.rows();
        let bodies = rows.iter().zip(self.outline.bodies);
        let bodies = bodies.filter(|(rows, _)| freedoms.iter().any(|motion| moves(motion, rows)));
        ReactionError::Free {
            freedoms: freedoms.len(),
            bodies: bodies.map(|(_, body)| body.name.to_string()).collect(),
            equations: self.outline.scalar_equations.iter().map(ToString::to_string).collect(),
            balls: self.influences.balls(),
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
    fn freedoms(&self, columns: &[Vec<Series<N>>]) -> Vec<Vec<f64>> {
        let count = self.rows().last().map_or(0, |rows| rows.end);
        let rows: Vec<Vec<f64>> = (0..count)
            .map(|row| columns.iter().map(|column| column[row].real()).collect())
            .collect();
        rank(&rows).null
    }

    /// How the contacts bear under these forces.
    pub(super) fn bears(&self, solution: &Solution<N>) -> Vec<Flank> {
        let flanks = self.flanks.iter().enumerate().map(|(connection, flank)| {
            let force = solution.forces[connection].whole();
            let contact = force.zip(self.pitch_point(connection));
            let sign = contact.and_then(|(force, (mesh, pitch))| pitch.sign(mesh, force));
            let sign = sign.unwrap_or(flank.sign);
            Flank { sign, ..*flank }
        });
        flanks.collect()
    }

    pub(super) fn solution(&self, unknowns: &[Unknown], values: &[Series<N>], is_open: &[bool]) -> Solution<N> {
        let mut solution = Solution {
            is_space: self.moved.is_space,
            forces: vec![DeterminedVector::ZERO; self.connections.len()],
            moments: vec![DeterminedVector::ZERO; self.connections.len()],
            efforts: vec![Some(Series::ZERO); self.drives.len()],
            frictions: vec![Series::ZERO; self.connections.len()],
            heat: Series::ZERO,
            begun_heat: 0.0,
            contraction: 0.0,
            turned: Vec::new(),
        };
        for ((unknown, value), is_open) in unknowns.iter().zip(values).zip(is_open) {
            let known = (!is_open).then_some(*value);
            match *unknown {
                Unknown::Pin { connection, axis } => solution.forces[connection].0[axis] = known,
                Unknown::Normal { connection, axis } => {
                    let normal = self.normal(&self.connections[connection], axis);
                    solution.forces[connection].add(normal, known);
                }
                Unknown::Moment { connection, on, axis } => {
                    let own = &self.connections[connection];
                    let about = turning(self.moved, self.frames, own, on)[axis];
                    let by = self.holding(own);
                    // the reaction acts on the guide where the slider is the ground
                    let is_turned = own.on == by && on != by;
                    let sign = Series::constant(if is_turned { -1.0 } else { 1.0 });
                    solution.moments[connection].add(about.scale(sign), known);
                    if own.slide.is_some() {
                        let moment = about.scale(known.unwrap_or(Series::ZERO));
                        solution.turned.extend(both_turned([on, by], moment));
                    }
                }
                Unknown::Contact { connection } => solution.forces[connection].add(self.bearing(connection), known),
                Unknown::Effort { input } => solution.efforts[input] = known,
            }
        }
        solution
    }
}

impl<T: MovingNumber> Equations<'_, T> {
    /// The equations of each body, by their numbers: those of forces, and then those of moments.
    fn rows(&self) -> Vec<Range<usize>> {
        let mut end = 0;
        let rows = self.frames.iter().map(|frame| {
            let start = end;
            end += self.moved.dimensions() + frame.turns().len();
            start..end
        });
        rows.collect()
    }

    /// The forces of a unit of an unknown on all bodies.
    pub(super) fn column(&self, unknown: Unknown) -> Vec<T> {
        let wrenches = match unknown {
            Unknown::Pin { connection, axis } => self.of_force(connection, along_axis(axis)),
            Unknown::Normal { connection, axis } => {
                self.of_force(connection, self.normal(&self.connections[connection], axis))
            }
            Unknown::Contact { connection } => self.of_force(connection, self.bearing(connection)),
            Unknown::Moment { connection, on, axis } => {
                let own = &self.connections[connection];
                both_turned([on, self.holding(own)], turning(self.moved, self.frames, own, on)[axis])
            }
            Unknown::Effort { input } => self.drives[input].wrenches(self.moved, self.frames, T::constant(1.0)),
        };
        self.flat_column(wrenches)
    }

    /// A force in a connection.
    pub(super) fn of_force(&self, connection: usize, force: Space<T>) -> Vec<(usize, Wrench<T>)> {
        let own = &self.connections[connection];
        let joint = own.joint.map(|joint| self.moved.places[joint]);
        let pitch = self.pitch_point(connection).map(|(_, pitch)| pitch.at);
        match joint.or(pitch) {
            Some(at) => both([own.on, own.by], self.frames, force, [at; 2]),
            None => Vec::new(),
        }
    }

    fn pitch_point(&self, connection: usize) -> Option<(&Mesh, PitchPoint<T>)> {
        let mesh = self.connections[connection].mesh.as_ref()?;
        Some((mesh, mesh.pitch_point(self.moved, self.flanks[connection].side)))
    }

    /// The force of a contact for a unit of its tangential force.
    pub(super) fn bearing(&self, connection: usize) -> Space<T> {
        let sign = self.flanks[connection].sign;
        let pitch = self.pitch_point(connection);
        pitch.map_or_else(Space::zero, |(mesh, pitch)| pitch.force(mesh, sign))
    }

    /// The body that exerts the moment of a connection.
    fn holding(&self, own: &Connection) -> Member {
        own.slide.map_or(own.by, |slide| self.outline.slides[slide].guide)
    }

    /// Forces on all bodies as a column.
    pub(super) fn flat_column(&self, wrenches: Vec<(usize, Wrench<T>)>) -> Vec<T> {
        let length = T::constant(self.length());
        let rows = self.rows();
        let mut column = vec![T::constant(0.0); rows.last().map_or(0, |rows| rows.end)];
        for (body, Wrench { force, moment, .. }) in wrenches {
            let forces = [force.x, force.y, force.z].into_iter().take(self.moved.dimensions());
            let moments = self.frames[body].parts(moment);
            let moments = moments.into_iter().map(|moment| moment / length);
            for (entry, part) in column[rows[body].clone()].iter_mut().zip(forces.chain(moments)) {
                *entry = *entry + part;
            }
        }
        column
    }

    /// A direction at right angles to the slide of a connection.
    pub(super) fn normal(&self, own: &Connection, axis: usize) -> Space<T> {
        let normal = |slide| across(self.moved.along(slide), self.moved.is_space)[axis];
        own.slide.map_or_else(Space::zero, normal)
    }

    /// The largest distance between joints, by which moments are divided.
    fn length(&self) -> f64 {
        let joints: Vec<Space<f64>> = self.moved.places[..self.moved.joints]
            .iter()
            .copied()
            .map(real)
            .collect();
        let others = |one: &Space<f64>| {
            let distances = joints.iter().map(|other| (*other - *one).norm_squared());
            distances.fold(0.0, f64::max)
        };
        let distances = joints.iter().map(others);
        let square = distances.fold(0.0, f64::max);
        if square > 0.0 { Number::sqrt(square) } else { 1.0 }
    }
}

/// The axes about which a slide or a hinge of space may hold a body by a moment.
fn turning<T: MovingNumber>(
    moved: &MovedMechanism<T>,
    frames: &[MovedFrame<T>],
    own: &Connection,
    on: Member,
) -> Vec<Space<T>> {
    let Some(axis) = own.axis().map(|axis| moved.axis(axis)) else {
        return Vec::new();
    };
    let [first, second] = across(axis, moved.is_space);
    if own.slide.is_none() {
        return [first, second].into();
    }
    if !moved.is_space {
        return [second].into();
    }
    match on.and_then(|body| frames[body].line()) {
        None => [axis, first, second].into(),
        // nothing acts about the line of a rod
        Some(line) => match between(line, axis) {
            None => [first, second].into(),
            Some(normal) => [normal.cross(line), normal].into(),
        },
    }
}

/// What is at most this part of the largest is rounding.
const NO_PART: f64 = 1e-9;

fn reals<const N: usize>(column: &[Series<N>]) -> Vec<f64> {
    column.iter().map(|entry| entry.real()).collect()
}

/// So many terms of a combination tell whether an unknown takes part in it: the value and both rates.
const TERMS: usize = 3;

/// Which unknowns of the basis take part in a combination that is zero, by the sizes of their forces beside that of the
/// column itself.
fn open<const N: usize>(
    parts: &[Series<N>],
    basis: &[usize],
    columns: &[Vec<Series<N>>],
    own: &[Series<N>],
) -> Vec<bool> {
    let size = |column: &[Series<N>]| {
        column
            .iter()
            .fold(0.0, |largest: f64, entry| largest.max(entry.real().abs()))
    };
    let sizes: Vec<f64> = basis.iter().map(|column| size(&columns[*column])).collect();
    let terms = |index: usize| parts[index].coefficients().map(|term| (term * sizes[index]).abs());
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
