//! The equations of equilibrium, and their solution in series.

use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;

use super::action::{Action, Influences, Wrench, both, both_turned};
use super::connection::{Connection, Member, holders};
use super::frames::{MovedFrame, MovedMechanism, MovingNumber, left};
use super::friction::ActingFriction;
use super::rank::{Rank, largest, rank};
use super::{REACH, ReactionError, ReactionPart, size};
use crate::geometry::Plane;
use crate::number::Number;
use crate::number::series::Series;
use crate::picture::Outline;
use crate::solve::{FactorRow, factor_in, substitute_in};

/// The equations of a body: two forces and a moment.
const OF_BODY: usize = 3;

/// What is unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Unknown {
    /// A force of a pin along an axis.
    Pin { connection: usize, axis: usize },
    /// The force of a slide at right angles to it.
    Normal { connection: usize },
    /// The moment of a slide.
    Moment { connection: usize, on: Member },
    /// The effort of the drive of an input.
    Effort { input: usize },
}

impl Unknown {
    /// The connection of which it is a force or a moment.
    pub(super) fn connection(self) -> Option<usize> {
        match self {
            Self::Pin { connection, .. } | Self::Normal { connection } | Self::Moment { connection, .. } => {
                Some(connection)
            }
            Self::Effort { .. } => None,
        }
    }
}

/// A result, unless equilibrium does not determine it.
pub(super) type Determined<const N: usize> = Option<Series<N>>;

/// The forces of all connections, and the efforts.
#[derive(Clone, Debug)]
pub(super) struct Solution<const N: usize> {
    /// The force of each connection.
    pub(super) forces: Vec<Option<Plane<Series<N>>>>,
    /// The moment of each connection about its joint.
    pub(super) moments: Vec<Determined<N>>,
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
        let force = self.forces[index];
        match part {
            ReactionPart::X => force.map(|force| force.x),
            ReactionPart::Y => force.map(|force| force.y),
            ReactionPart::Force => force.map(size),
            ReactionPart::Moment => self.moments[index],
        }
    }

    /// The same, where each series becomes another one.
    pub(super) fn map(self, change: impl Fn(Series<N>) -> Series<N>) -> Self {
        let all = |series: Vec<Determined<N>>| series.into_iter().map(|own| own.map(&change)).collect();
        let forces = self.forces.into_iter();
        Self {
            forces: forces
                .map(|force| force.map(|Plane { x, y }| Plane::new(change(x), change(y))))
                .collect(),
            moments: all(self.moments),
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
    /// -1 on the left side of a place.
    pub(super) parity: f64,
}

impl<const N: usize> Equations<'_, Series<N>> {
    /// The forces with which the bodies move as they do, from what each lacks without them.
    pub(super) fn solve(&self, demand: &[Wrench<Series<N>>]) -> Result<Solution<N>, ReactionError> {
        let (System { unknowns, columns }, basis) = self.determined()?;
        let count = basis.len();
        let row = |row: usize| basis.iter().map(move |column| (*column, row));
        let places = (0..count).flat_map(row);
        let mut entries: Vec<Series<N>> = places.map(|(column, row)| columns[column][row]).collect();
        let mut rows = vec![FactorRow::default(); count];
        factor_in(&mut entries, &mut rows).map_err(|_| ReactionError::NotFinite)?;
        let solve = |right: &[Series<N>]| {
            let mut solution = vec![Series::ZERO; count];
            substitute_in(&entries, &rows, right, &mut solution);
            solution
        };
        let length = self.length();
        let right: Vec<Series<N>> = demand.iter().flat_map(|wrench| flat(wrench, length)).collect();
        let mut values = vec![Series::ZERO; unknowns.len()];
        for (column, value) in basis.iter().zip(solve(&right)) {
            values[*column] = value;
        }
        let mut is_open = vec![false; unknowns.len()];
        for free in (0..unknowns.len()).filter(|column| !basis.contains(column)) {
            is_open[free] = true;
            let parts = solve(&columns[free]);
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
            for (column, value) in basis.iter().zip(solve(&self.resisting(acting))) {
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
        let count = self.frames.len() * OF_BODY;
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
        for (connection, own) in self.connections.iter().enumerate() {
            match own.slide {
                None => unknowns.extend([0, 1].map(|axis| Unknown::Pin { connection, axis })),
                Some(_) => unknowns.push(Unknown::Normal { connection }),
            }
        }
        unknowns.extend((0..self.drives.len()).map(|input| Unknown::Effort { input }));
        let mut columns: Vec<Vec<Series<N>>> = unknowns.iter().map(|unknown| self.column(*unknown)).collect();
        for (connection, own) in self.connections.iter().enumerate() {
            let Some(slide) = own.slide else { continue };
            let guide = self.outline.slides[slide].guide;
            for on in holders(self.outline, own.joint) {
                let turns = |motion: &Vec<f64>| {
                    let turn = |member: Member| member.map_or(0.0, |body| motion[body * OF_BODY + 2]);
                    (turn(on) - turn(guide)).abs() > NO_PART * largest(motion)
                };
                if self.influences.keeps_angle([on, guide]) && self.freedoms(&columns).iter().any(turns) {
                    let unknown = Unknown::Moment { connection, on };
                    columns.push(self.column(unknown));
                    unknowns.push(unknown);
                }
            }
        }
        System { unknowns, columns }
    }

    /// Which bodies can move though the inputs stand.
    fn free(&self, columns: &[Vec<Series<N>>]) -> ReactionError {
        let freedoms = self.freedoms(columns);
        let moves = |motion: &Vec<f64>, body: usize| {
            largest(&motion[body * OF_BODY..(body + 1) * OF_BODY]) > NO_PART * largest(motion)
        };
        let bodies = (0..self.frames.len()).filter(|body| freedoms.iter().any(|motion| moves(motion, *body)));
        ReactionError::Free {
            freedoms: freedoms.len(),
            bodies: bodies.map(|body| self.outline.bodies[body].name.to_string()).collect(),
            equations: self.outline.scalar_equations.iter().map(ToString::to_string).collect(),
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
        let count = self.frames.len() * OF_BODY;
        let rows: Vec<Vec<f64>> = (0..count)
            .map(|row| columns.iter().map(|column| column[row].real()).collect())
            .collect();
        rank(&rows).null
    }

    pub(super) fn solution(&self, unknowns: &[Unknown], values: &[Series<N>], is_open: &[bool]) -> Solution<N> {
        let mut solution = Solution {
            forces: vec![Some(Plane::zero()); self.connections.len()],
            moments: vec![Some(Series::ZERO); self.connections.len()],
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
                Unknown::Pin { connection, axis } => {
                    let force = solution.forces[connection].zip(known);
                    solution.forces[connection] = force.map(|(force, known)| {
                        if axis == 0 {
                            Plane::new(known, force.y)
                        } else {
                            Plane::new(force.x, known)
                        }
                    });
                }
                Unknown::Normal { connection } => {
                    let normal = self.normal(self.connections[connection].slide);
                    solution.forces[connection] = known.map(|known| normal.scale(known));
                }
                Unknown::Moment { connection, on } => {
                    let own = &self.connections[connection];
                    let guide = own.slide.and_then(|slide| self.outline.slides[slide].guide);
                    // the reaction acts on the guide where the slider is the ground
                    let is_turned = own.on == guide && on != guide;
                    let sign = Series::constant(if is_turned { -1.0 } else { 1.0 });
                    solution.moments[connection] = known.map(|known| sign * known);
                    solution
                        .turned
                        .extend(both_turned([on, guide], known.unwrap_or(Series::ZERO)));
                }
                Unknown::Effort { input } => solution.efforts[input] = known,
            }
        }
        solution
    }
}

impl<T: MovingNumber> Equations<'_, T> {
    /// The forces of a unit of an unknown on all bodies.
    pub(super) fn column(&self, unknown: Unknown) -> Vec<T> {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let connection = |index: usize| {
            let own: &Connection = &self.connections[index];
            ([own.on, own.by], [self.moved.places[own.joint]; 2], own.slide)
        };
        let wrenches = match unknown {
            Unknown::Pin {
                connection: index,
                axis,
            } => {
                let (pair, at, _) = connection(index);
                let force = if axis == 0 {
                    Plane::new(one, zero)
                } else {
                    Plane::new(zero, one)
                };
                both(pair, self.frames, force, at)
            }
            Unknown::Normal { connection: index } => {
                let (pair, at, slide) = connection(index);
                both(pair, self.frames, self.normal(slide), at)
            }
            Unknown::Moment { connection: index, on } => {
                let guide = connection(index).2.and_then(|slide| self.outline.slides[slide].guide);
                both_turned([on, guide], one)
            }
            Unknown::Effort { input } => self.drives[input].wrenches(self.moved, self.frames, one),
        };
        self.flat_column(wrenches)
    }

    /// Forces on all bodies as a column.
    pub(super) fn flat_column(&self, wrenches: Vec<(usize, Wrench<T>)>) -> Vec<T> {
        let length = self.length();
        let mut column = vec![T::constant(0.0); self.frames.len() * OF_BODY];
        for (body, wrench) in wrenches {
            for (entry, part) in column[body * OF_BODY..].iter_mut().zip(flat(&wrench, length)) {
                *entry = *entry + part;
            }
        }
        column
    }

    pub(super) fn normal(&self, slide: Option<usize>) -> Plane<T> {
        slide.map_or_else(Plane::zero, |slide| left(self.moved.direction(slide)))
    }

    /// The largest distance between joints, by which moments are divided.
    pub(super) fn length(&self) -> f64 {
        let joints = || self.moved.places[..self.moved.joints].iter();
        let distances = joints().flat_map(|one| joints().map(move |other| (*other - *one).norm_squared().real()));
        let square = distances.fold(0.0, f64::max);
        if square > 0.0 { Number::sqrt(square) } else { 1.0 }
    }
}

/// What is at most this part of the largest is rounding.
const NO_PART: f64 = 1e-9;

pub(super) fn flat<T: MovingNumber>(wrench: &Wrench<T>, length: f64) -> [T; OF_BODY] {
    let Wrench { force, moment, .. } = *wrench;
    [force.x, force.y, moment / T::constant(length)]
}

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
