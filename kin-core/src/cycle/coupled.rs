//! The search where a block has no closed form: from all positions at some inputs, along the curve of solutions in both directions.

use alloc::vec;
use alloc::vec::Vec;

use super::EndKind;
use super::line::{Line, distance, nearest, reach};
use super::pieces::{Found, Node, Piece, Tip};
use crate::failure::SolveError;
use crate::mechanism::Mechanism;
use crate::number::Row;
use crate::track::{TrackError, track};

/// The number of inputs at which all positions are sought first.
const SEEDS: u32 = 8;
/// The largest number of searches, each with more seeds than the last.
const ROUNDS: usize = 3;
/// The largest distance of positions that are the same.
const SAME: f64 = 1e-6;
/// The distance from a limit at which its other side begins, as a part of the range.
const BESIDE: f64 = 1e-7;
/// The largest distance of places that are the same node, as a part of the range.
const SAME_PLACE: f64 = 1e-9;
/// The largest number of pieces.
const MOST_PIECES: usize = 4096;

/// An input and all positions that are known there.
struct Seed<M: Mechanism<Scalar = f64>> {
    s: f64,
    positions: Vec<M::Unknowns<f64>>,
    visited: Vec<bool>,
}

struct Search<'a, M: Mechanism<Scalar = f64>> {
    mechanism: &'a M,
    line: &'a Line<M>,
    size: f64,
    seeds: Vec<Seed<M>>,
    found: Found<M>,
    /// Starts on the other side of limits, and the direction in which to go.
    waiting: Vec<(usize, f64, M::Unknowns<f64>, f64)>,
}

/// All pieces of branches that pass one of the seeds.
///
/// # Errors
/// Returns the error of the search for positions, if a parameter is not finite.
pub(super) fn search<M: Mechanism<Scalar = f64>>(mechanism: &M, line: &Line<M>) -> Result<Found<M>, SolveError> {
    let place = |part: u32| line.low + (line.high - line.low) * (f64::from(part) / f64::from(SEEDS));
    let mut seeds = Vec::new();
    for part in 0..=SEEDS {
        if part < SEEDS || !line.is_closed {
            seeds.push(seed(mechanism, line, place(part))?);
        }
    }
    if line.is_closed {
        let first = seeds[0].positions.clone();
        seeds.push(Seed {
            s: line.high,
            visited: vec![false; first.len()],
            positions: first,
        });
    }
    let mut round = 1;
    loop {
        let mut search = Search {
            mechanism,
            line,
            size: reach(mechanism),
            seeds,
            found: Found {
                nodes: Vec::new(),
                pieces: Vec::new(),
                is_complete: false,
                seeds: Vec::new(),
            },
            waiting: Vec::new(),
        };
        search.all();
        let more = if round < ROUNDS { search.missing()? } else { Vec::new() };
        if more.is_empty() {
            search.found.seeds = search.seeds.iter().map(|seed| seed.s).collect();
            return Ok(search.found);
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

fn seed<M: Mechanism<Scalar = f64>>(mechanism: &M, line: &Line<M>, s: f64) -> Result<Seed<M>, SolveError> {
    let mut positions = Vec::new();
    mechanism.positions_at(line.inputs(s), |_, unknowns| positions.push(unknowns))?;
    Ok(Seed {
        s,
        visited: vec![false; positions.len()],
        positions,
    })
}

/// The end of a way in one direction.
struct Way<M: Mechanism<Scalar = f64>> {
    tip: Tip,
    samples: Vec<(f64, M::Unknowns<f64>)>,
}

impl<M: Mechanism<Scalar = f64>> Search<'_, M> {
    fn all(&mut self) {
        for index in 0..self.seeds.len() {
            for which in 0..self.seeds[index].positions.len() {
                if self.seeds[index].visited[which] || self.found.pieces.len() >= MOST_PIECES {
                    continue;
                }
                self.seeds[index].visited[which] = true;
                let (s, unknowns) = (self.seeds[index].s, self.seeds[index].positions[which]);
                let left = self.follow(s, unknowns, -1.0);
                let right = self.follow(s, unknowns, 1.0);
                let mut samples = left.samples;
                samples.reverse();
                samples.push((s, unknowns));
                samples.extend(right.samples);
                self.found.pieces.push(Piece {
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
                        let reached = track(self.mechanism, self.line.inputs(s), unknowns, self.line.inputs(*to));
                        reached.is_ok_and(|reached| distance::<M>(self.size, &reached, known) < SAME)
                    })
            });
            if is_known || self.found.pieces.len() >= MOST_PIECES {
                continue;
            }
            let way = self.follow(s, unknowns, direction);
            let place = self.found.nodes[node];
            let start = nearest::<M>(place.unknowns, &unknowns);
            let mut samples = vec![(place.s, start), (s, unknowns)];
            samples.extend(way.samples);
            let piece = if direction > 0.0 {
                Piece {
                    assembly: None,
                    low: Tip::Node(node),
                    high: way.tip,
                    samples,
                }
            } else {
                samples.reverse();
                Piece {
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
    fn follow(&mut self, s: f64, unknowns: M::Unknowns<f64>, direction: f64) -> Way<M> {
        let (mut s, mut unknowns) = (s, unknowns);
        let mut samples = Vec::new();
        loop {
            let next = if direction > 0.0 {
                self.seeds.iter().position(|seed| seed.s > s)
            } else {
                self.seeds.iter().rposition(|seed| seed.s < s)
            };
            let Some(next) = next else {
                return Way {
                    tip: Tip::Seam,
                    samples,
                };
            };
            let to = self.seeds[next].s;
            match track(self.mechanism, self.line.inputs(s), unknowns, self.line.inputs(to)) {
                Ok(reached) => {
                    (s, unknowns) = (to, reached);
                    samples.push((s, unknowns));
                    self.visit(next, &unknowns);
                }
                Err(error) => {
                    let node = self.ended(s, unknowns, direction, error);
                    let place = self.found.nodes[node];
                    samples.push((place.s, nearest::<M>(place.unknowns, &unknowns)));
                    return Way {
                        tip: Tip::Node(node),
                        samples,
                    };
                }
            }
        }
    }

    fn visit(&mut self, index: usize, unknowns: &M::Unknowns<f64>) {
        let size = self.size;
        let seed = &mut self.seeds[index];
        let known = seed
            .positions
            .iter()
            .position(|known| distance::<M>(size, known, unknowns) < SAME);
        if let Some(known) = known {
            seed.visited[known] = true;
        } else {
            seed.positions.push(*unknowns);
            seed.visited.push(true);
        }
    }

    /// The node at which a track ended. A limit's other side is noted.
    fn ended(
        &mut self,
        s: f64,
        unknowns: M::Unknowns<f64>,
        direction: f64,
        error: TrackError<M::Inputs<f64>, M::Unknowns<f64>>,
    ) -> usize {
        let range = self.line.high - self.line.low;
        let node = match error {
            TrackError::Limit(obstacle) => {
                self.node(EndKind::Limit, obstacle.inputs, obstacle.unknowns, obstacle.block)
            }
            TrackError::ChangePoint(obstacle) => {
                self.node(EndKind::ChangePoint, obstacle.inputs, obstacle.unknowns, obstacle.block)
            }
            TrackError::Unbounded(obstacle) => {
                self.node(EndKind::Domain, obstacle.inputs, obstacle.unknowns, obstacle.block)
            }
            TrackError::TooManySteps(halt) | TrackError::Lost(halt) => {
                self.node(EndKind::Lost, halt.inputs, halt.unknowns, "")
            }
            TrackError::Failed(error) => {
                let inputs: Vec<f64> = error.inputs.iter().map(|(_, value)| value).collect();
                let inputs = M::Inputs::from_fn(|index| {
                    inputs.get(index).copied().unwrap_or_else(|| self.line.inputs(s)[index])
                });
                self.node(EndKind::Domain, inputs, unknowns, error.block)
            }
        };
        let place = self.found.nodes[node];
        let inside = place.s - direction * BESIDE * range;
        if place.kind == EndKind::Limit && (inside - s) * direction > 0.0 {
            let inputs = self.line.inputs(inside);
            if let Ok(near) = track(self.mechanism, self.line.inputs(s), unknowns, inputs) {
                let limit = nearest::<M>(place.unknowns, &near);
                let guess = Row::from_fn(|index| 2.0 * limit[index] - near[index]);
                if let Ok(other) = self.mechanism.solve_position_near(inputs, guess)
                    && distance::<M>(self.size, &other, &near) > 0.1 * distance::<M>(self.size, &guess, &near)
                {
                    self.waiting.push((node, inside, other, -direction));
                }
            }
        }
        node
    }

    fn node(
        &mut self,
        kind: EndKind,
        inputs: M::Inputs<f64>,
        unknowns: M::Unknowns<f64>,
        block: &'static str,
    ) -> usize {
        let s = self.line.place(inputs);
        let range = self.line.high - self.line.low;
        let known = self.found.nodes.iter().position(|node| {
            node.kind == kind
                && (node.s - s).abs() <= SAME_PLACE * range
                && distance::<M>(self.size, &node.unknowns, &unknowns) < SAME
        });
        known.unwrap_or_else(|| {
            self.found.nodes.push(Node {
                kind,
                s,
                unknowns,
                block,
                assemblies: [0, 0],
            });
            self.found.nodes.len() - 1
        })
    }

    /// Seeds between neighbouring limits at which there are more positions than pieces.
    fn missing(&self) -> Result<Vec<Seed<M>>, SolveError> {
        let range = self.line.high - self.line.low;
        let mut places: Vec<f64> = self.found.nodes.iter().map(|node| node.s).collect();
        places.extend([self.line.low, self.line.high]);
        places.sort_by(f64::total_cmp);
        let mut more = Vec::new();
        for pair in places.windows(2) {
            let [low, high] = [pair[0], pair[1]];
            let has_seed = self.seeds.iter().any(|seed| seed.s > low && seed.s < high);
            if has_seed || high - low <= 10.0 * BESIDE * range {
                continue;
            }
            let own = seed(self.mechanism, self.line, 0.5 * (low + high))?;
            let pieces = self.found.pieces.iter().filter(|piece| {
                let ends = [piece.samples.first(), piece.samples.last()].map(|end| end.map_or(f64::NAN, |end| end.0));
                ends[0] < own.s && ends[1] > own.s
            });
            if pieces.count() < own.positions.len() {
                more.push(own);
            }
        }
        Ok(more)
    }
}
