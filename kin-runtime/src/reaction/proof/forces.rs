//! Forces over a box of variables: the input, its speed and acceleration, and the dimensions with tolerances.

use alloc::vec::Vec;

use super::super::equations::{Equations, Unknown};
use super::super::structure::Structure;
use super::super::{MovedNumber, ReactionError, ReactionPart, ReactionPlace, undetermined};
use super::pose::{Closure, Enclosed, Given, moving, position, still};
use super::{ForceProof, ProofError};
use crate::any::PositionChoice;
use crate::bounds::Bounds;
use crate::bounds::linear::{RegularMatrix, inverse};
use crate::law::Side;
use crate::number::Number;
use crate::number::series::Series;
use crate::picture::Outline;

/// The places of the variables of a box that are no tolerances.
const INPUT: usize = 0;
const VELOCITY: usize = 1;
const ACCELERATION: usize = 2;
const TOLERANCES: usize = 3;

/// The force that is meant.
#[derive(Clone, Copy, Debug)]
pub(super) enum Wanted {
    /// A part of a reaction.
    Part(usize, ReactionPart),
    /// The effort of the drive of an input.
    Effort(usize),
}

/// How a variable of a box is taken.
#[derive(Clone, Copy)]
enum Taken {
    /// As the variable of all functions.
    Varying,
    /// As any of its values.
    Anywhere,
    /// In the middle.
    Middle,
}

/// A part of the variables' ranges, with the poses over it.
#[derive(Clone)]
pub(super) struct Piece {
    pub(super) ranges: Vec<[f64; 2]>,
    pub(super) enclosed: Enclosed,
}

/// What is known of the size of a force.
struct Size {
    low: f64,
    high: f64,
    slopes: [f64; 2],
}

/// What is known of the size of a force over a piece.
pub(super) struct Reach {
    pub(super) upper: f64,
    /// Bounds of its derivative by each variable, of which half the width counts as one.
    pub(super) slopes: Vec<[f64; 2]>,
}

/// What a proof takes from one pose: where drives and torques act, and which unknowns hold the bodies.
pub(super) struct Sample<'p> {
    proof: &'p ForceProof<'p>,
    outline: Outline<'p>,
    wanted: Wanted,
    structure: Structure,
    basis: Vec<Unknown>,
}

impl Size {
    /// The size of a number, or of a vector of two.
    fn of(parts: &[Bounds]) -> Self {
        let steepest = |part: &Bounds| {
            let [least, greatest] = part.slopes();
            least.abs().max(greatest.abs())
        };
        let square = parts
            .iter()
            .fold(0.0, |sum, part| sum + steepest(part) * steepest(part));
        let steepest = Number::sqrt(square) * (1.0 + 8.0 * f64::EPSILON);
        let size = match *parts {
            [one] if one.low >= 0.0 => one,
            [one] if one.high <= 0.0 => -one,
            _ => {
                let zero = Bounds::constant(0.0);
                parts.iter().fold(zero, |sum, part| sum + *part * *part).sqrt()
            }
        };
        let [least, greatest] = size.slopes();
        Self {
            low: size.low.max(0.0),
            high: match *parts {
                [one] => one.size(),
                _ => size.high,
            },
            slopes: [least.max(-steepest), greatest.min(steepest)],
        }
    }
}

impl ForceProof<'_> {
    /// The whole ranges of all variables; that of the input from its beginning to its end.
    pub(super) fn ranges(&self, lead: usize) -> Vec<[f64; 2]> {
        let tolerances = self.tolerances.iter().map(|(index, tolerance)| {
            let value = self.parameters[*index];
            [value - tolerance, value + tolerance]
        });
        let motion = [[self.from[lead], self.to[lead]], self.velocity, self.acceleration];
        motion.into_iter().chain(tolerances).collect()
    }

    /// The parameters at a place of the variables.
    pub(super) fn parameters_at(&self, place: &[f64]) -> Vec<f64> {
        let mut parameters = self.parameters.clone();
        for ((index, _), value) in self.tolerances.iter().zip(&place[TOLERANCES..]) {
            parameters[*index] = *value;
        }
        parameters
    }

    /// The way of an input for each unit of the first one that moves.
    fn ratio(&self, lead: usize, input: usize) -> f64 {
        if input == lead {
            return 1.0;
        }
        (self.to[input] - self.from[input]) / (self.to[lead] - self.from[lead])
    }

    /// The inputs at a place of the variables.
    fn inputs_at(&self, lead: usize, place: &[f64]) -> Vec<f64> {
        let input = |input: usize| {
            let way = place[INPUT] - self.from[lead];
            if input == lead {
                place[INPUT]
            } else {
                self.from[input] + self.ratio(lead, input) * way
            }
        };
        (0..self.from.len()).map(input).collect()
    }

    /// What a pose depends on, for values of all variables.
    fn given(&self, lead: usize, values: &[Bounds]) -> Given {
        let mut parameters: Vec<_> = self.parameters.iter().map(|own| still(Bounds::rounded(*own))).collect();
        for ((index, _), value) in self.tolerances.iter().zip(&values[TOLERANCES..]) {
            parameters[*index] = still(*value);
        }
        let input = |input: usize| {
            if input != lead && self.from[input] == self.to[input] {
                return still(Bounds::constant(self.from[input]));
            }
            let ratio = Bounds::constant(self.ratio(lead, input));
            let from = [input, lead].map(|input| Bounds::constant(self.from[input]));
            let value = if input == lead {
                values[INPUT]
            } else {
                from[0] + (values[INPUT] - from[1]) * ratio
            };
            moving(value, [values[VELOCITY] * ratio, values[ACCELERATION] * ratio])
        };
        Given {
            parameters,
            inputs: (0..self.from.len()).map(input).collect(),
        }
    }
}

/// The middle of each range.
pub(super) fn middle(ranges: &[[f64; 2]]) -> Vec<f64> {
    ranges.iter().map(|[low, high]| 0.5 * (low + high)).collect()
}

/// Single values of all variables, of which dimensions are known to one unit in their last places.
fn at(place: &[f64]) -> Vec<Bounds> {
    let value = |(variable, value): (usize, &f64)| {
        if variable < TOLERANCES {
            Bounds::constant(*value)
        } else {
            Bounds::rounded(*value)
        }
    };
    place.iter().enumerate().map(value).collect()
}

fn taken(ranges: &[[f64; 2]], how: impl Fn(usize) -> Taken) -> Vec<Bounds> {
    let in_middle = at(&middle(ranges));
    let value = |(variable, range): (usize, &[f64; 2])| match how(variable) {
        Taken::Middle => in_middle[variable],
        _ if range[0] == range[1] => in_middle[variable],
        Taken::Anywhere => Bounds::within(*range),
        Taken::Varying => Bounds::variable(range[0], range[1]),
    };
    ranges.iter().enumerate().map(value).collect()
}

impl<'p> Sample<'p> {
    /// The decisions in a pose.
    pub(super) fn new(
        proof: &'p ForceProof<'p>,
        lead: usize,
        wanted: Wanted,
        piece: &Piece,
    ) -> Result<Self, ProofError> {
        let reactions = proof.reactions;
        let outline = reactions.functions.outline();
        let place = middle(&piece.ranges);
        let parameters = proof.parameters_at(&place);
        let inputs: Vec<MovedNumber> = proof
            .inputs_at(lead, &place)
            .into_iter()
            .map(Series::constant)
            .collect();
        let pose = ReactionPlace {
            functions: reactions.functions,
            parameters: &parameters,
            inputs,
            unknowns: &piece.enclosed.centre,
            outputs: &[],
            rate: 1.0,
            side: Side::Right,
        };
        let connections = &reactions.connections;
        let (moved, frames) = pose.moving(&outline, connections)?;
        let (structure, _) = reactions.structure(&pose, &outline, &moved, &frames)?;
        let equations = structure.equations(reactions, &outline, &moved, &frames);
        let basis = equations.basis(&structure.unknowns, &equations.columns(&structure.unknowns))?;
        let solution = reactions.solved_by(&pose, None)?.solution;
        let is_determined = match wanted {
            Wanted::Part(index, part) => solution.part(index, part).is_some(),
            Wanted::Effort(input) => solution.efforts[input].is_some(),
        };
        if !is_determined {
            let names: Vec<_> = reactions.names().map(Into::into).collect();
            let name = match wanted {
                Wanted::Part(index, _) => reactions.connections[index].name.clone(),
                Wanted::Effort(input) => super::super::drive_of(reactions.functions.description().inputs[input].name),
            };
            return Err(undetermined(&solution, &names, name).into());
        }
        Ok(Self {
            proof,
            outline,
            wanted,
            basis: basis.into_iter().map(|column| structure.unknowns[column]).collect(),
            structure,
        })
    }

    /// The parts of the force, while each variable is taken as it is said.
    fn parts(&self, given: &Given, enclosed: &Enclosed) -> Option<Vec<Bounds>> {
        let reactions = self.proof.reactions;
        let moved = enclosed.moved(&Closure::new(reactions.functions, given))?;
        let frames = moved.frames(&self.outline, &reactions.connections).ok()?;
        let mut demand = Vec::new();
        let loads = self.structure.demand(reactions, &moved, &frames, 1.0);
        loads
            .each(&mut |_, exertion| demand.extend(exertion.wrenches(&frames)))
            .ok()?;
        let equations = self.structure.equations(reactions, &self.outline, &moved, &frames);
        let column = |unknown: &Unknown| -> Vec<Bounds> {
            let column = equations.column(*unknown);
            column.iter().map(|entry| entry.value.value).collect()
        };
        let columns: Vec<Vec<Bounds>> = self.basis.iter().map(column).collect();
        let count = columns.len();
        let real = (0..count).flat_map(|row| columns.iter().map(move |column| column[row].real()));
        let inverse = inverse(&real.collect::<Vec<_>>(), count)?;
        let right = equations.lacking(demand.iter().map(|(body, wrench)| (*body, wrench)));
        let right: Vec<Bounds> = right.iter().map(|entry| entry.value.value).collect();
        let values = RegularMatrix::new(&inverse, columns.iter())?.solve(&right);
        let parts = self.wanted_parts(&equations, &values);
        parts.iter().all(|part| part.is_bounded()).then_some(parts)
    }

    /// The parts of the force that is meant, among the values of all unknowns.
    fn wanted_parts(&self, equations: &Equations<'_, super::super::MovingBounds>, values: &[Bounds]) -> Vec<Bounds> {
        let mut parts = Vec::new();
        for (unknown, value) in self.basis.iter().zip(values) {
            match (*unknown, self.wanted) {
                (Unknown::Effort { input }, Wanted::Effort(wanted)) if input == wanted => parts.push(*value),
                (own, Wanted::Part(wanted, part)) if own.connection() == Some(wanted) => match (own, part) {
                    (Unknown::Pin { axis: 0, .. }, ReactionPart::X | ReactionPart::Force)
                    | (Unknown::Pin { axis: 1, .. }, ReactionPart::Y | ReactionPart::Force)
                    | (Unknown::Normal { .. } | Unknown::Contact { .. }, ReactionPart::Force) => parts.push(*value),
                    (Unknown::Moment { .. }, ReactionPart::Moment | ReactionPart::MomentZ) => parts = [*value].into(),
                    (Unknown::Normal { connection, axis }, ReactionPart::X | ReactionPart::Y) => {
                        let normal = equations.normal(&self.proof.reactions.connections[connection], axis);
                        let along = if part == ReactionPart::X { normal.x } else { normal.y };
                        parts.push(*value * along.value.value);
                    }
                    (Unknown::Contact { connection }, ReactionPart::X | ReactionPart::Y) => {
                        let tangent = equations.bearing(connection);
                        let along = if part == ReactionPart::X { tangent.x } else { tangent.y };
                        parts.push(*value * along.value.value);
                    }
                    _ => {}
                },
                _ => {}
            }
        }
        // a joint has no moment where something else keeps its body from turning
        if parts.is_empty() {
            parts.push(Bounds::constant(0.0));
        }
        parts
    }

    /// What is known of the size of the force over a piece.
    ///
    /// By the mean value form, variable by variable: the force at the middle of all others, and for each of them the
    /// bounds of its derivative, where the variables before it are anywhere and those behind it stand in the middle (E.
    /// Hansen and G. W. Walster, *Global Optimization Using Interval Analysis*, 2nd edition, Dekker 2004, section 7.3).
    pub(super) fn reach(&self, lead: usize, piece: &Piece) -> Option<Reach> {
        let ranges = &piece.ranges;
        let mut slopes = alloc::vec![[0.0; 2]; ranges.len()];
        let (mut sum, mut whole) = (0.0, f64::INFINITY);
        for variable in 0..ranges.len() {
            if variable != INPUT && ranges[variable][0] == ranges[variable][1] {
                continue;
            }
            let values = taken(ranges, |other| match other.cmp(&variable) {
                core::cmp::Ordering::Less => Taken::Anywhere,
                core::cmp::Ordering::Equal => Taken::Varying,
                core::cmp::Ordering::Greater => Taken::Middle,
            });
            let size = Size::of(&self.parts(&self.proof.given(lead, &values), &piece.enclosed)?);
            let [least, greatest] = size.slopes;
            let own = if variable == INPUT {
                size.high
            } else {
                least.abs().max(greatest.abs())
            };
            sum = (sum + own) * (1.0 + f64::EPSILON);
            whole = size.high;
            slopes[variable] = size.slopes;
        }
        let upper = sum.min(whole);
        Some(Reach { upper, slopes })
    }

    /// What the size of the force is at least at a place of a piece.
    pub(super) fn least(&self, lead: usize, piece: &Piece, place: &[f64]) -> Option<f64> {
        let functions = self.proof.reactions.functions;
        let given = self.proof.given(lead, &at(place));
        let enclosed = self.proof.pose(lead, place, &piece.enclosed.centre, &given)?;
        let unknowns = enclosed.unknowns(&Closure::new(functions, &given))?;
        if !piece.enclosed.holds(&unknowns) {
            return None;
        }
        Some(Size::of(&self.parts(&given, &enclosed)?).low)
    }
}

impl ForceProof<'_> {
    /// The poses for what is given, around the pose at a place that is near another one.
    fn pose(&self, lead: usize, place: &[f64], near: &[f64], given: &Given) -> Option<Enclosed> {
        let functions = self.reactions.functions;
        let (parameters, inputs) = (self.parameters_at(place), self.inputs_at(lead, place));
        let centre = position(functions, &parameters, &inputs, PositionChoice::Near(near))?;
        Closure::new(functions, given).enclose(&centre)
    }

    /// A piece whose poses are proved.
    pub(super) fn piece(&self, lead: usize, ranges: Vec<[f64; 2]>, near: &[f64]) -> Option<Piece> {
        let given = self.given(lead, &taken(&ranges, |_| Taken::Anywhere));
        let enclosed = self.pose(lead, &middle(&ranges), near, &given)?;
        Some(Piece { ranges, enclosed })
    }

    /// Whether the pose at a place that is near another one is that of all these pieces.
    pub(super) fn belongs(&self, lead: usize, place: &[f64], near: &[f64], pieces: &[&Piece]) -> bool {
        let functions = self.reactions.functions;
        let given = self.given(lead, &at(place));
        let enclosed = self.pose(lead, place, near, &given);
        let unknowns = enclosed.and_then(|enclosed| enclosed.unknowns(&Closure::new(functions, &given)));
        unknowns.is_some_and(|unknowns| pieces.iter().all(|piece| piece.enclosed.holds(&unknowns)))
    }

    /// The unknowns at a place, in plain numbers.
    pub(super) fn start(&self, lead: usize, place: &[f64]) -> Result<Vec<f64>, ProofError> {
        let functions = self.reactions.functions;
        let mut unknowns = alloc::vec![0.0; functions.description().unknowns.len()];
        let (parameters, inputs) = (self.parameters_at(place), self.inputs_at(lead, place));
        let found = functions.position(&parameters, &inputs, self.assembly.position(), &mut unknowns);
        found.map_err(ReactionError::from)?;
        Ok(unknowns)
    }
}
