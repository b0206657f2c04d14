//! The search where a block has no closed form: from all positions at some inputs, along the curve of solutions in both
//! directions.
//!
//! If all limits are known, the ends of the range and the gaps beside those limits that no branch has reached are
//! enough.

use alloc::vec;
use alloc::vec::Vec;

use super::limits::{SingularPoint, limits};
use super::line::InputLine;
use super::pieces::{BranchNode, BranchPiece, FoundPieces, Tip};
use super::sought::{CoupledBlocks, SoughtMechanism};
use super::{EndKind, Incomplete};
use crate::any::PositionChoice;
use crate::curve::LimitKind;
use crate::failure::SolveError;
use crate::number::NumberRow;
use crate::quantity::Name;
use crate::track::TrackError;

/// The number of intervals of the first division.
const SEEDS: u32 = 8;
/// The largest number of searches, each with more seeds than the last.
const ROUNDS: usize = 3;
/// The largest distance of positions that are the same.
const SAME_POSITION: f64 = 1e-6;
/// The distance from a limit at which its other side begins, as a part of the range.
const BESIDE: f64 = 1e-7;
/// The largest distance of inputs that are the same node, as a part of the range.
const SAME_NODE: f64 = 1e-9;
/// The largest distance of a node from a limit that continuation found, as a part of the range, and of the unknowns
/// there. A multiple solution is known to a part of the digits only.
const LOCATED: [f64; 2] = [1e-6, 1e-3];
/// The largest number of pieces.
const MOST_PIECES: usize = 4096;

/// The distance from a limit at which its two branches are sought, in the fastest unknown: about the root of
/// [`BESIDE`].
const ASIDE: f64 = 1e-3;

/// Whether a limit is a position of the whole mechanism.
fn is_whole(mechanism: &SoughtMechanism<'_>, limit: &SingularPoint) -> bool {
    limit.unknowns.len() == mechanism.unknowns().len()
}

/// An input and all positions that are known there.
struct Seed {
    s: f64,
    positions: Vec<NumberRow>,
    visited: Vec<bool>,
    /// Whether all positions were sought here; otherwise they are those of the branches that pass.
    is_sought: bool,
    /// Whether the search was complete.
    is_complete: bool,
}

struct Search<'a> {
    mechanism: &'a SoughtMechanism<'a>,
    functions: &'a dyn CoupledBlocks,
    line: &'a InputLine,
    size: f64,
    seeds: Vec<Seed>,
    found: FoundPieces,
    /// Starts on the other side of limits, and the direction in which to go.
    waiting: Vec<(usize, f64, NumberRow, f64)>,
}

/// All pieces of branches, or those that pass one of the seeds if the limits cannot be found by themselves.
///
/// # Errors
/// Returns the error of the search for positions, if a parameter is not finite.
pub(super) fn search(
    mechanism: &SoughtMechanism<'_>,
    functions: &dyn CoupledBlocks,
    line: &InputLine,
) -> Result<FoundPieces, SolveError> {
    match limits(mechanism, functions, line) {
        Ok(limits) => from_limits(mechanism, functions, line, &limits),
        Err(reason) => {
            let mut found = from_seeds(mechanism, functions, line)?;
            found.incomplete.push(reason);
            Ok(found)
        }
    }
}

/// The inputs that divide the range, and whether each is an end of it.
fn division(line: &InputLine) -> impl Iterator<Item = (f64, bool)> {
    let (low, high) = (line.low, line.high);
    (0..=SEEDS).map(move |part| {
        let s = low + (high - low) * (f64::from(part) / f64::from(SEEDS));
        (s, part == 0 || part == SEEDS)
    })
}

/// All pieces, from all limits.
///
/// A circuit that does not pass the ends of the range has a smallest input, which is a limit. So it is found from
/// there, or all positions beside this limit are sought.
fn from_limits(
    mechanism: &SoughtMechanism<'_>,
    functions: &dyn CoupledBlocks,
    line: &InputLine,
    limits: &[SingularPoint],
) -> Result<FoundPieces, SolveError> {
    let mut seeds: Vec<Seed> = Vec::new();
    for (s, is_end) in division(line) {
        seeds.push(if is_end && line.is_closed && !seeds.is_empty() {
            seeds[0].again(s)
        } else if is_end {
            seed(mechanism, functions, line, s)?
        } else {
            Seed::unknown(s)
        });
    }
    let mut search = Search::new(mechanism, functions, line, seeds);
    search.all();
    let range = line.high - line.low;
    let mut limits_and_ends: Vec<f64> = limits.iter().map(|limit| limit.s).collect();
    limits_and_ends.extend([line.low, line.high]);
    limits_and_ends.sort_by(f64::total_cmp);
    let mut beside: Vec<f64> = Vec::new();
    let mut look_beside = |s: f64, clearance: f64| {
        let after = limits_and_ends.iter().find(|other| **other > s + clearance * range);
        let before = limits_and_ends
            .iter()
            .rev()
            .find(|other| **other < s - clearance * range);
        for other in [before, after].into_iter().flatten() {
            let middle = 0.5 * (s + other);
            if !beside.contains(&middle) {
                beside.push(middle);
            }
        }
    };
    for limit in limits {
        if limit.is_multiple {
            look_beside(limit.s, 1e-5);
            continue;
        }
        if search.nodes_at(limit).next().is_none() {
            search.start_at(limit);
        }
        if search.nodes_at(limit).next().is_none() {
            look_beside(limit.s, SAME_NODE);
        }
    }
    for (index, end) in search.found.nodes.iter().enumerate() {
        if end.kind == EndKind::Limit(LimitKind::TurningPoint) && search.branches_at(index) != 2 {
            look_beside(end.s, SAME_NODE);
        }
    }
    for s in beside {
        search.look(s)?;
    }
    search.compare(limits);
    Ok(search.finished())
}

/// All pieces that pass one of the seeds.
fn from_seeds(
    mechanism: &SoughtMechanism<'_>,
    functions: &dyn CoupledBlocks,
    line: &InputLine,
) -> Result<FoundPieces, SolveError> {
    let mut seeds: Vec<Seed> = Vec::new();
    for (s, is_end) in division(line) {
        seeds.push(if is_end && line.is_closed && !seeds.is_empty() {
            seeds[0].again(s)
        } else {
            seed(mechanism, functions, line, s)?
        });
    }
    let mut round = 1;
    loop {
        let mut search = Search::new(mechanism, functions, line, seeds);
        search.all();
        let more = if round < ROUNDS { search.missing()? } else { Vec::new() };
        if more.is_empty() {
            return Ok(search.finished());
        }
        round += 1;
        seeds = search.seeds;
        seeds.extend(more);
        seeds.sort_by(|one, other| one.s.total_cmp(&other.s));
        for seed in &mut seeds {
            seed.visited = vec![false; seed.positions.len()];
        }
    }
}

fn seed(
    mechanism: &SoughtMechanism<'_>,
    functions: &dyn CoupledBlocks,
    line: &InputLine,
    s: f64,
) -> Result<Seed, SolveError> {
    let mut positions = Vec::new();
    let mut found = |unknowns: &[f64]| positions.push(NumberRow::from(unknowns));
    let search = functions.every_position(&mechanism.parameters, &line.inputs(s), &mut found)?;
    Ok(Seed {
        s,
        visited: vec![false; positions.len()],
        positions,
        is_sought: true,
        is_complete: search.is_complete && search.singular == 0,
    })
}

impl Seed {
    /// An input at which nothing is known yet.
    fn unknown(s: f64) -> Self {
        Self {
            s,
            positions: Vec::new(),
            visited: Vec::new(),
            is_sought: false,
            is_complete: true,
        }
    }

    /// Notes that a branch passes a position.
    fn visit(&mut self, mechanism: &SoughtMechanism<'_>, size: f64, unknowns: &[f64]) {
        let mut known = self.positions.iter();
        if let Some(known) = known.position(|known| mechanism.distance(size, known, unknowns) < SAME_POSITION) {
            self.visited[known] = true;
        } else {
            self.positions.push(NumberRow::from(unknowns));
            self.visited.push(true);
        }
    }

    /// The same positions at another input.
    fn again(&self, s: f64) -> Self {
        Self {
            s,
            positions: self.positions.clone(),
            visited: vec![false; self.positions.len()],
            ..*self
        }
    }
}

/// The end of a way in one direction.
struct WayEnd {
    tip: Tip,
    samples: Vec<(f64, NumberRow)>,
}

impl<'a> Search<'a> {
    fn new(
        mechanism: &'a SoughtMechanism<'a>,
        functions: &'a dyn CoupledBlocks,
        line: &'a InputLine,
        seeds: Vec<Seed>,
    ) -> Self {
        Self {
            mechanism,
            functions,
            line,
            size: mechanism.reach(),
            seeds,
            found: FoundPieces {
                nodes: Vec::new(),
                pieces: Vec::new(),
                incomplete: Vec::new(),
                undecided: Vec::new(),
                seeds: Vec::new(),
            },
            waiting: Vec::new(),
        }
    }

    fn distance(&self, one: &[f64], other: &[f64]) -> f64 {
        self.mechanism.distance(self.size, one, other)
    }

    fn near(&self, s: f64, near: &[f64]) -> Result<NumberRow, SolveError> {
        self.mechanism
            .position(&self.line.inputs(s), PositionChoice::Near(near))
    }

    fn track(&self, from: f64, unknowns: &[f64], to: f64) -> Result<NumberRow, TrackError<Vec<f64>, Vec<f64>>> {
        let [from, to] = [from, to].map(|s| self.line.inputs(s));
        self.mechanism.track(&from, unknowns, &to)
    }

    /// The outcome, with the inputs at which all positions were sought.
    fn finished(self) -> FoundPieces {
        let mut found = self.found;
        let sought = self.seeds.iter().filter(|seed| seed.is_sought);
        found.seeds = sought.map(|seed| seed.s).collect();
        found
    }

    /// Follows the two branches that meet at a limit.
    fn start_at(&mut self, limit: &SingularPoint) {
        if !is_whole(self.mechanism, limit) {
            return;
        }
        let mut position = NumberRow::splat(self.mechanism.unknowns().len(), 0.0);
        let mut rates = position.clone();
        for unknown in &limit.unknowns {
            (position[unknown.index], rates[unknown.index]) = (unknown.value, unknown.rate);
        }
        for side in [BESIDE, -BESIDE] {
            let s = limit.s + side * (self.line.high - self.line.low);
            if s <= self.line.low || s >= self.line.high {
                continue;
            }
            let mut seed = Seed::unknown(s);
            for step in [ASIDE, -ASIDE] {
                let guess = NumberRow::from_fn(position.len(), |index| position[index] + step * rates[index]);
                let solved = self.near(s, &guess);
                if let Ok(unknowns) = solved
                    && self.distance(&unknowns, &position) < 100.0 * ASIDE
                    && seed
                        .positions
                        .iter()
                        .all(|known| self.distance(known, &unknowns) >= SAME_POSITION)
                {
                    seed.positions.push(unknowns);
                    seed.visited.push(false);
                }
            }
            if seed.positions.len() == 2 {
                let index = self.seeds.partition_point(|other| other.s < s);
                self.seeds.insert(index, seed);
                self.all();
                // Later branches need no stop here.
                self.seeds.remove(index);
                return;
            }
        }
    }

    /// Seeks all positions at an input, and follows those that are on no piece yet.
    fn look(&mut self, s: f64) -> Result<(), SolveError> {
        let mut seed = seed(self.mechanism, self.functions, self.line, s)?;
        for piece in &self.found.pieces {
            let inside = piece.samples.iter().enumerate().filter(|(index, _)| {
                let is_low = *index == 0 && matches!(piece.low, Tip::Node(_));
                let is_high = index + 1 == piece.samples.len() && matches!(piece.high, Tip::Node(_));
                !is_low && !is_high
            });
            let [first, last] =
                [piece.samples.first(), piece.samples.last()].map(|end| end.map_or(f64::NAN, |end| end.0));
            if !(s > first && s < last) {
                continue;
            }
            let nearest = inside.min_by(|(_, one), (_, other)| (one.0 - s).abs().total_cmp(&(other.0 - s).abs()));
            let reached = nearest.and_then(|(_, (from, unknowns))| self.track(*from, unknowns, s).ok());
            if let Some(reached) = reached {
                seed.visit(self.mechanism, self.size, &reached);
            } else {
                seed.is_complete = false;
            }
        }
        let index = self.seeds.partition_point(|other| other.s < s);
        self.seeds.insert(index, seed);
        self.all();
        Ok(())
    }

    /// The nodes at a limit that continuation found.
    fn nodes_at(&self, limit: &SingularPoint) -> impl Iterator<Item = usize> {
        let nodes = self.found.nodes.iter().enumerate();
        nodes
            .filter(|(_, node)| self.is_at(node, limit))
            .map(|(index, _)| index)
    }

    fn is_at(&self, node: &BranchNode, limit: &SingularPoint) -> bool {
        let tolerance = LOCATED[usize::from(limit.is_multiple)];
        let mut unknowns = node.unknowns.clone();
        for unknown in &limit.unknowns {
            unknowns[unknown.index] = unknown.value;
        }
        let is_singular = matches!(
            node.kind,
            EndKind::Limit(LimitKind::TurningPoint | LimitKind::ChangePoint)
        );
        is_singular
            && (node.s - limit.s).abs() <= tolerance * (self.line.high - self.line.low)
            && self.distance(&unknowns, &node.unknowns) <= LOCATED[1]
    }

    /// The number of ends of pieces at a node.
    fn branches_at(&self, node: usize) -> usize {
        let tips = self.found.pieces.iter().flat_map(|piece| [piece.low, piece.high]);
        tips.filter(|tip| *tip == Tip::Node(node)).count()
    }

    /// Notes why there may be other pieces: nodes that are not the limits that continuation found, limits without a
    /// node, or positions that were not found.
    fn compare(&mut self, limits: &[SingularPoint]) {
        let nodes = || self.found.nodes.iter().enumerate();
        let is_limit = |node: &BranchNode| limits.iter().any(|limit| self.is_at(node, limit));
        let joins = |(index, node): (usize, &BranchNode)| match node.kind {
            EndKind::Limit(LimitKind::TurningPoint) => self.branches_at(index) == 2,
            EndKind::Limit(LimitKind::ChangePoint) => true,
            _ => false,
        };
        // If a block that is solved later does not close, its mechanism is not at a limit of an earlier one.
        let is_whole = |limit: &&SingularPoint| is_whole(self.mechanism, limit) && !limit.is_multiple;
        let whole = limits.iter().filter(is_whole);
        let reached = whole.clone().filter(|limit| self.nodes_at(limit).next().is_some());
        let (count, reached) = (whole.count(), reached.count());
        let agrees = nodes().all(|(_, node)| is_limit(node))
            && nodes().all(joins)
            && count == reached
            && self.found.pieces.len() < MOST_PIECES;
        let is_angle = self.line.is_angle;
        let mut reasons = Vec::new();
        if !agrees {
            reasons.push(Incomplete::Disagreement { limits: count, reached });
        }
        if let Some(seed) = self.seeds.iter().find(|seed| !seed.is_complete) {
            reasons.push(Incomplete::Positions {
                input: seed.s,
                is_angle,
            });
        }
        self.found.incomplete = reasons;
    }

    fn all(&mut self) {
        for index in 0..self.seeds.len() {
            for which in 0..self.seeds[index].positions.len() {
                if self.seeds[index].visited[which] || self.found.pieces.len() >= MOST_PIECES {
                    continue;
                }
                self.seeds[index].visited[which] = true;
                let (s, unknowns) = (self.seeds[index].s, self.seeds[index].positions[which].clone());
                let left = self.follow(s, unknowns.clone(), -1.0);
                let right = self.follow(s, unknowns.clone(), 1.0);
                let mut samples = left.samples;
                samples.reverse();
                samples.push((s, unknowns));
                samples.extend(right.samples);
                self.found.pieces.push(BranchPiece {
                    assembly: None,
                    low: left.tip,
                    high: right.tip,
                    samples,
                });
                self.other_sides();
            }
        }
    }

    /// Follows the branches that begin on the other sides of limits, as far as no seed has shown them.
    fn other_sides(&mut self) {
        while let Some((node, s, unknowns, direction)) = self.waiting.pop() {
            let is_known = self.found.pieces.iter().any(|piece| {
                let (tip, sample) = if direction > 0.0 {
                    (piece.low, piece.samples.get(1))
                } else {
                    (piece.high, piece.samples.iter().rev().nth(1))
                };
                // The branch that led to this node comes from the other assembly.
                tip == Tip::Node(node)
                    && sample.is_some_and(|(to, known)| {
                        let reached = self.track(s, &unknowns, *to);
                        reached.is_ok_and(|reached| self.distance(&reached, known) < SAME_POSITION)
                    })
            });
            if is_known || self.found.pieces.len() >= MOST_PIECES {
                continue;
            }
            let way = self.follow(s, unknowns.clone(), direction);
            let from = &self.found.nodes[node];
            let start = self.mechanism.nearest(&from.unknowns, &unknowns);
            let mut samples = vec![(from.s, start), (s, unknowns)];
            samples.extend(way.samples);
            let piece = if direction > 0.0 {
                BranchPiece {
                    assembly: None,
                    low: Tip::Node(node),
                    high: way.tip,
                    samples,
                }
            } else {
                samples.reverse();
                BranchPiece {
                    assembly: None,
                    low: way.tip,
                    high: Tip::Node(node),
                    samples,
                }
            };
            self.found.pieces.push(piece);
        }
    }

    /// Goes on from seed to seed until the branch ends.
    fn follow(&mut self, s: f64, unknowns: NumberRow, direction: f64) -> WayEnd {
        let (mut s, mut unknowns) = (s, unknowns);
        let mut samples = Vec::new();
        loop {
            let next = if direction > 0.0 {
                self.seeds.iter().position(|seed| seed.s > s)
            } else {
                self.seeds.iter().rposition(|seed| seed.s < s)
            };
            let Some(next) = next else {
                return WayEnd {
                    tip: Tip::Seam,
                    samples,
                };
            };
            let to = self.seeds[next].s;
            match self.track(s, &unknowns, to) {
                Ok(reached) => {
                    (s, unknowns) = (to, reached);
                    samples.push((s, unknowns.clone()));
                    self.seeds[next].visit(self.mechanism, self.size, &unknowns);
                }
                Err(error) => {
                    let node = self.ended(s, &unknowns, direction, &error);
                    let to = &self.found.nodes[node];
                    samples.push((to.s, self.mechanism.nearest(&to.unknowns, &unknowns)));
                    return WayEnd {
                        tip: Tip::Node(node),
                        samples,
                    };
                }
            }
        }
    }

    /// The node at which a track ended. A limit's other side is noted.
    fn ended(&mut self, s: f64, unknowns: &[f64], direction: f64, error: &TrackError<Vec<f64>, Vec<f64>>) -> usize {
        let range = self.line.high - self.line.low;
        let node = match error {
            TrackError::TooManySteps(halt) | TrackError::Lost(halt) => {
                self.node(EndKind::Lost, &halt.inputs, &halt.unknowns, Name::NONE)
            }
            TrackError::Failed(error) => {
                let mut inputs = self.line.inputs(s);
                for (input, (_, value)) in inputs.iter_mut().zip(error.inputs.iter()) {
                    *input = value;
                }
                self.node(EndKind::Limit(LimitKind::End), &inputs, unknowns, error.block)
            }
            TrackError::TurningPoint(limit) | TrackError::ChangePoint(limit) | TrackError::Pole(limit) => {
                let kind = error.limit().map_or(EndKind::Lost, |(kind, _)| EndKind::Limit(kind));
                self.node(kind, &limit.inputs, &limit.unknowns, limit.block)
            }
        };
        let end = &self.found.nodes[node];
        let inside = end.s - direction * BESIDE * range;
        if end.kind == EndKind::Limit(LimitKind::TurningPoint)
            && (inside - s) * direction > 0.0
            && let Ok(near) = self.track(s, unknowns, inside)
        {
            let limit = self.mechanism.nearest(&end.unknowns, &near);
            let guess = NumberRow::from_fn(near.len(), |index| 2.0 * limit[index] - near[index]);
            if let Ok(other) = self.near(inside, &guess)
                && self.distance(&other, &near) > 0.1 * self.distance(&guess, &near)
            {
                self.waiting.push((node, inside, other, -direction));
            }
        }
        node
    }

    fn node(&mut self, kind: EndKind, inputs: &[f64], unknowns: &[f64], block: Name) -> usize {
        let s = self.line.coordinate(inputs);
        let range = self.line.high - self.line.low;
        let known = self.found.nodes.iter().position(|node| {
            node.kind == kind
                && (node.s - s).abs() <= SAME_NODE * range
                && self.distance(&node.unknowns, unknowns) < SAME_POSITION
        });
        known.unwrap_or_else(|| {
            self.found.nodes.push(BranchNode {
                kind,
                s,
                unknowns: NumberRow::from(unknowns),
                block,
                assemblies: [0, 0],
            });
            self.found.nodes.len() - 1
        })
    }

    /// Seeds between neighbouring limits at which there are more positions than pieces.
    fn missing(&self) -> Result<Vec<Seed>, SolveError> {
        let range = self.line.high - self.line.low;
        let mut borders: Vec<f64> = self.found.nodes.iter().map(|node| node.s).collect();
        borders.extend([self.line.low, self.line.high]);
        borders.sort_by(f64::total_cmp);
        let mut more = Vec::new();
        for pair in borders.windows(2) {
            let [low, high] = [pair[0], pair[1]];
            let has_seed = self.seeds.iter().any(|seed| seed.s > low && seed.s < high);
            if has_seed || high - low <= 10.0 * BESIDE * range {
                continue;
            }
            let seed = seed(self.mechanism, self.functions, self.line, 0.5 * (low + high))?;
            let pieces = self.found.pieces.iter().filter(|piece| {
                let ends = [piece.samples.first(), piece.samples.last()].map(|end| end.map_or(f64::NAN, |end| end.0));
                ends[0] < seed.s && ends[1] > seed.s
            });
            if pieces.count() < seed.positions.len() {
                more.push(seed);
            }
        }
        Ok(more)
    }
}
