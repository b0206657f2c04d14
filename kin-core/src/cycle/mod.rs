//! The full cycle of a mechanism: all circuits and branches, with their limits.
//!
//! Over an input, the positions of a mechanism form curves. A *circuit* is such a curve: all positions that are reached without taking the
//! mechanism apart. Where an input turns back, two *branches* of a circuit meet (T. R. Chase and J. A. Mirth, *Circuits and branches of
//! single-degree-of-freedom planar linkages*, Journal of Mechanical Design 115 (1993), 223-230). [`FullCycle::cycle`] finds all of them.
//!
//! ```
//! use kin_core::cycle::{EndKind, FullCycle};
//! use kin_core::library::FourBar;
//!
//! let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
//! let cycle = linkage.cycle()?;
//! assert!(cycle.is_complete());
//! // one circuit with two branches: the crank swings, and at both ends the two assemblies meet
//! assert_eq!((cycle.circuits().len(), cycle.branches().len()), (1, 2));
//! let [low, high] = cycle.branches()[0].ends();
//! assert_eq!((low.kind, high.kind), (EndKind::Limit, EndKind::Limit));
//! assert!((high.input.to_degrees() - 112.0243).abs() < 5e-5 && (low.input + high.input).abs() < 1e-14);
//! # Ok::<(), kin_core::SolveError>(())
//! ```
//!
//! # What is proved
//!
//! If every block has a closed form, the range of the input is divided into intervals. The solver runs on bounds of all
//! values and derivatives over an interval, in interval arithmetic that includes rounding. The bounds prove that an
//! assembly closes everywhere in the interval, or nowhere, or that the condition on which it depends is monotonic
//! there, so that its values at the ends tell whether there is one limit or none. Other intervals are halved until
//! rounding decides, where every length counts as known to one unit in its last place. An assembly that closes on both
//! sides of such a place has a change point there. [`Cycle::is_complete`] is then true. One thing is tested and not
//! proved: the choice by a declared range of an unknown is made at the ends and in the middle of each interval.
//!
//! The search has a unit of length of its own, so that a multiple of all lengths has the same cycle.
//!
//! If a block is coupled, all its limits come first: the real solutions of the closure and det J = 0, with the input unknown, by
//! [`continuation`](crate::continuation). The closure is fitted by polynomials in cosines, sines and lengths, which are compared with its values.
//! A circuit that does not pass an end of the range has a smallest input, which is a limit. So [`track`](crate::track()) follows all positions
//! at the [ends](Cycle::seeds), and both branches of every limit that was not reached. [`Cycle::is_complete`] is true if no path of the
//! continuation was lost, and if tracks and continuation have found the same limits. It holds with the reservation of `continuation`, which
//! computes in double precision.
//!
//! This needs polynomials of at most 1024 paths, which have no product of three quantities, lengths that cannot become infinite, and unknowns
//! without declared ranges. For any other mechanism all positions are sought at stated inputs, and `is_complete` is false.
//! [`Cycle::incomplete`] says why.

mod bounds;
mod class;
mod closed;
mod coupled;
mod curved;
mod free;
mod incomplete;
mod interpolation;
mod limits;
mod line;
mod measure;
mod pieces;
mod polynomial;
mod position;
#[cfg(test)]
mod scale_tests;
mod shown;
mod singular;
mod station;
#[cfg(test)]
mod tests;
mod unit;

pub use class::{BarkerClass, BlockClass, GrashofType, InvertedSliderCrankType, SliderCrankType};
pub use incomplete::Incomplete;
pub use measure::{MeasureError, Stroke, StrokeEnd, WorstTransmission};

use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::TAU;
use core::ops::RangeInclusive;

use num_traits::Float;

use crate::failure::{Failure, InputValues, SolveError};
use crate::mechanism::{Mechanism, OneInput};
use crate::number::{ClosedRange, Row};
use crate::quantity::Dimension;
use line::{InputLine, distance, nearest, reach};
use pieces::{BranchPiece, FoundPieces, Tip};
use unit::LengthUnit;

/// The largest distance from half a period that may be rounding, as a part of it.
const HALFWAY: f64 = 1e-6;

/// The full cycle of every mechanism.
pub trait FullCycle: Mechanism<Scalar = f64> {
    /// All circuits and branches over the only input: over a full turn of an angle, or as many turns as it takes until the closure repeats
    /// itself; and over all lengths that the sum of the links may reach, twice as far as they reach.
    ///
    /// A plain number, and an angle with which the closure does not repeat itself within twelve turns, is taken from -π to π:
    /// [`cycle_over`](Self::cycle_over) takes another range.
    ///
    /// # Errors
    /// An error if a parameter is not finite, and that of the solver if it refuses the lengths, because they are too
    /// large or too small.
    fn cycle(&self) -> Result<Cycle<Self>, SolveError>
    where
        Self::Inputs<f64>: OneInput,
    {
        Cycle::new(self, Row::splat(0.0), Row::splat(1.0), None)
    }

    /// All circuits and branches over a range of the only input. Branches that leave the range end there.
    ///
    /// # Errors
    /// As for `cycle`, and an error if the range is not finite or has no length.
    fn cycle_over(&self, range: impl ClosedRange) -> Result<Cycle<Self>, SolveError>
    where
        Self::Inputs<f64>: OneInput,
    {
        Cycle::new(self, Row::splat(0.0), Row::splat(1.0), Some(range.ends()))
    }

    /// All circuits and branches along a line in the space of the inputs: the inputs are `from + s direction`, and s takes the place of the
    /// only input of [`cycle`](Self::cycle).
    ///
    /// # Errors
    /// As for `cycle`, and an error if an input is not finite, or if the direction is zero.
    ///
    /// ```
    /// use kin_core::cycle::FullCycle;
    /// use kin_core::library::FiveBar;
    ///
    /// // the left crank turns, the right one stands still
    /// let robot = FiveBar { ground: 2.0, left: 0.5, left_rod: 2.0, right_rod: 2.0, right: 1.5 };
    /// let cycle = robot.cycle_along([0.0, 1.0], [1.0, 0.0])?;
    /// assert!(cycle.is_complete() && cycle.branches().iter().all(|branch| branch.is_full_turn()));
    /// # Ok::<(), kin_core::SolveError>(())
    /// ```
    fn cycle_along(&self, from: Self::Inputs<f64>, direction: Self::Inputs<f64>) -> Result<Cycle<Self>, SolveError> {
        Cycle::new(self, from, direction, None)
    }

    /// [`cycle_along`](Self::cycle_along) over a range of s.
    ///
    /// # Errors
    /// As for `cycle_along`.
    fn cycle_along_over(
        &self,
        from: Self::Inputs<f64>,
        direction: Self::Inputs<f64>,
        range: impl ClosedRange,
    ) -> Result<Cycle<Self>, SolveError> {
        Cycle::new(self, from, direction, Some(range.ends()))
    }
}

impl<M: Mechanism<Scalar = f64>> FullCycle for M {}

/// The reason why a branch ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EndKind {
    /// A limit: the input turns back, and the branch meets another one of its circuit.
    Limit,
    /// A change point: branches cross, or meet where a part turns freely or where several blocks have their limits, and
    /// geometry does not determine which one the mechanism follows.
    ChangePoint,
    /// The end of the domain of a function, or of the declared range of an unknown.
    Domain,
    /// A length goes to infinity. The unknowns are those next to the pole.
    Pole,
    /// The end of the range of the input that was looked at.
    Range,
    /// The search could not go on, for a reason that it does not know.
    Lost,
    /// No end: after a full turn the branch is back at its start.
    FullTurn,
}

/// An end of a branch.
#[derive(Clone, Copy)]
pub struct End<M: Mechanism<Scalar = f64>> {
    /// The reason why the branch ends here.
    pub kind: EndKind,
    /// The input, or the distance along the line of inputs.
    pub input: f64,
    /// The unknowns at this end, with angles on the turns they have along the branch.
    pub unknowns: M::Unknowns<f64>,
    /// The unknowns of the block that is singular here, separated by commas; empty if there is none.
    pub block: &'static str,
    node: Option<usize>,
}

/// A branch: a part of a circuit over which the input moves in one direction.
#[derive(Clone)]
pub struct Branch<M: Mechanism<Scalar = f64>> {
    ends: [End<M>; 2],
    samples: Vec<(f64, M::Unknowns<f64>)>,
    assembly: Option<M::Assembly>,
    circuit: usize,
    joins: [Vec<usize>; 2],
}

impl<M: Mechanism<Scalar = f64>> Branch<M> {
    /// The ends with the smallest and the largest input.
    #[must_use]
    pub fn ends(&self) -> [End<M>; 2] {
        self.ends
    }

    /// The smallest and the largest input. A branch of a closed range may reach beyond half a turn, and a full turn may begin anywhere.
    #[must_use]
    pub fn range(&self) -> RangeInclusive<f64> {
        self.ends[0].input..=self.ends[1].input
    }

    /// Whether the input turns without an end.
    #[must_use]
    pub fn is_full_turn(&self) -> bool {
        self.ends[0].kind == EndKind::FullTurn
    }

    /// The assembly, if every block has a closed form.
    #[must_use]
    pub fn assembly(&self) -> Option<M::Assembly> {
        self.assembly
    }

    /// The index of its circuit.
    #[must_use]
    pub fn circuit(&self) -> usize {
        self.circuit
    }

    /// The other branches that meet this one at its two ends, by their indices.
    #[must_use]
    pub fn joins(&self) -> [&[usize]; 2] {
        [&self.joins[0], &self.joins[1]]
    }

    /// Some inputs in ascending order with the unknowns there. Angles go on over turns.
    #[must_use]
    pub fn samples(&self) -> &[(f64, M::Unknowns<f64>)] {
        &self.samples
    }
}

/// A circuit: branches that are connected by limits and change points.
#[derive(Clone)]
pub struct Circuit<M: Mechanism<Scalar = f64>> {
    branches: Vec<usize>,
    input_turns: Option<i32>,
    turns: Option<M::Unknowns<i32>>,
}

impl<M: Mechanism<Scalar = f64>> Circuit<M> {
    /// The indices of its branches, in the order in which the circuit passes them if it is closed.
    #[must_use]
    pub fn branches(&self) -> &[usize] {
        &self.branches
    }

    /// Whether the mechanism comes back to its start along the circuit. It is false if the circuit ends, or has a change point, at which it
    /// may go different ways.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.turns.is_some()
    }

    /// The number of turns of the input along a closed circuit, once around: 0 if it swings.
    #[must_use]
    pub fn input_turns(&self) -> Option<i32> {
        self.input_turns
    }

    /// The number of turns of each unknown along a closed circuit, counted as the first branch runs with a growing input; 0 for lengths.
    #[must_use]
    pub fn turns(&self) -> Option<M::Unknowns<i32>> {
        self.turns
    }
}

/// All circuits and branches of a mechanism. [`FullCycle`] makes it.
#[derive(Clone)]
pub struct Cycle<M: Mechanism<Scalar = f64>> {
    mechanism: M,
    line: InputLine<M>,
    branches: Vec<Branch<M>>,
    circuits: Vec<Circuit<M>>,
    incomplete: Vec<Incomplete>,
    undecided: Vec<(M::Assembly, [f64; 2])>,
    seeds: Vec<f64>,
}

impl<M: Mechanism<Scalar = f64>> Cycle<M> {
    fn new(
        mechanism: &M,
        from: M::Inputs<f64>,
        direction: M::Inputs<f64>,
        range: Option<[f64; 2]>,
    ) -> Result<Self, SolveError> {
        let failed = |quantity: &'static str| {
            let names = InputValues::new(M::DESCRIPTION.inputs, from.as_ref());
            let block = M::DESCRIPTION.blocks.first().map_or("", |block| block.unknowns);
            Failure::NotFinite { quantity }.at(block, names)
        };
        let unit = LengthUnit::of(mechanism, from);
        // The search sees lengths in its unit, and the same places of the line.
        let sought = unit.mechanism(mechanism);
        let line = InputLine::new(&sought, unit.inputs::<M>(from), unit.inputs::<M>(direction), range);
        let is_finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
        let is_known = is_finite(mechanism.parameters().as_ref())
            && is_finite(from.as_ref())
            && is_finite(direction.as_ref())
            && (line.high - line.low).is_finite();
        // what a search along the line or over the range would divide by
        if !is_known {
            return Err(failed("parameters or range of the inputs"));
        } else if direction.as_ref().iter().all(|rate| *rate == 0.0) {
            return Err(failed("reciprocal of the direction of the inputs, which is zero"));
        } else if line.high <= line.low {
            return Err(failed("reciprocal of the length of the range, which is zero"));
        }
        let mut found = if M::ASSEMBLY_COUNT > 0 {
            closed::search(&sought, &line)
        } else {
            coupled::search(&sought, &line)?
        };
        let mut branches = joined_at_the_seam(&line, reach(&sought), &found);
        let lost = branches.iter().flat_map(|branch| &branch.ends);
        found.incomplete.extend(
            lost.filter(|end| end.kind == EndKind::Lost)
                .map(|end| Incomplete::Lost {
                    input: end.input,
                    is_angle: line.is_angle(),
                }),
        );
        let circuits = circuits(&line, &mut branches);
        for branch in &mut branches {
            let ends = branch.ends.iter_mut().map(|end| &mut end.unknowns);
            for unknowns in ends.chain(branch.samples.iter_mut().map(|(_, unknowns)| unknowns)) {
                *unknowns = unit.told::<M>(*unknowns);
            }
        }
        let cycle = Self {
            mechanism: *mechanism,
            line: InputLine {
                from,
                direction,
                ..line
            },
            branches,
            circuits,
            incomplete: found.incomplete,
            undecided: found
                .undecided
                .iter()
                .filter_map(|(index, range)| Some((M::assembly(*index)?, *range)))
                .collect(),
            seeds: found.seeds,
        };
        match cycle.refusal() {
            Some(error) => Err(error),
            None => Ok(cycle),
        }
    }

    /// The error of the solver if lengths are so large or so small that it refuses the positions of the cycle, which
    /// has its own unit.
    fn refusal(&self) -> Option<SolveError> {
        let refused = |error: SolveError| matches!(error.failure, Failure::NotFinite { .. }).then_some(error);
        let mut middles = self.branches.iter().filter_map(|branch| {
            let (s, unknowns) = branch.samples.get(branch.samples.len() / 2)?;
            let inputs = self.line.inputs(*s);
            let solved = match branch.assembly {
                Some(assembly) => self.mechanism.solve_position(inputs, assembly),
                None => self.mechanism.solve_position_near(inputs, *unknowns),
            };
            solved.err()
        });
        if !self.branches.is_empty() {
            return middles.find_map(refused);
        }
        let inputs = self.line.inputs(0.5 * (self.line.low + self.line.high));
        let mut solved = M::assemblies().map(|assembly| self.mechanism.solve_position(inputs, assembly));
        solved.find_map(|solved| refused(solved.err()?))
    }

    /// The circuits.
    #[must_use]
    pub fn circuits(&self) -> &[Circuit<M>] {
        &self.circuits
    }

    /// The branches of all circuits.
    #[must_use]
    pub fn branches(&self) -> &[Branch<M>] {
        &self.branches
    }

    /// Whether it is proved that there is no other branch. The [module](self#what-is-proved) says what that means.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.incomplete.is_empty()
    }

    /// The reasons why there may be other branches; none if the cycle [is complete](Self::is_complete). Each prints as
    /// a clause.
    #[must_use]
    pub fn incomplete(&self) -> &[Incomplete] {
        &self.incomplete
    }

    /// The assemblies of closed forms about which the bounds told nothing, each with a range of the input. There, only the ends and the middles
    /// of intervals were tried.
    ///
    /// A block with a motion of its own leads here, such as two equal links whose ends coincide at every input. In four of the eight
    /// assemblies of Peaucellier's cell, the rhombus is folded, and two of its links turn freely:
    ///
    /// ```
    /// use kin_core::cycle::FullCycle;
    /// use kin_core::library::PeaucellierLinkage;
    ///
    /// let cycle = PeaucellierLinkage { ground: 2.0, crank: 1.9, arm: 6.0, side: 4.0 }.cycle()?;
    /// assert!(!cycle.is_complete());
    /// // the two dyads on the arms are both open or both crossed
    /// assert!(cycle.undecided().iter().all(|(assembly, _)| assembly.alpha_gamma == assembly.beta_delta));
    /// # Ok::<(), kin_core::SolveError>(())
    /// ```
    #[must_use]
    pub fn undecided(&self) -> &[(M::Assembly, [f64; 2])] {
        &self.undecided
    }

    /// The inputs at which all positions were sought, in ascending order: the ends of the range, and others if limits are not enough. It is
    /// empty if every block has a closed form.
    #[must_use]
    pub fn seeds(&self) -> &[f64] {
        &self.seeds
    }

    /// The way after which the positions repeat themselves: a turn of the input, or several. `None` if the range has ends.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        self.line.period()
    }

    /// The branches that have a position at an input, with the index of each. A branch that passes the input several times comes several times.
    pub fn at(&self, input: f64) -> impl Iterator<Item = (usize, &Branch<M>)> {
        let period = self.line.period();
        self.branches.iter().enumerate().flat_map(move |(index, branch)| {
            let [low, high] = branch.ends.each_ref().map(|end| end.input);
            let count = match period {
                Some(period) if branch.is_full_turn() => Float::round((high - low) / period),
                // The places input + k period from the smallest to the largest input.
                Some(period) => Float::floor((high - input) / period) - Float::ceil((low - input) / period) + 1.0,
                None => f64::from(u8::from(input >= low && input <= high)),
            };
            core::iter::successors(Some(1.0), |passed| Some(passed + 1.0))
                .take_while(move |passed| *passed <= count)
                .map(move |_| (index, branch))
        })
    }

    /// The mechanism.
    #[must_use]
    pub fn mechanism(&self) -> &M {
        &self.mechanism
    }

    /// The inputs at a place of the line: the only input itself, or `from + s direction`.
    #[must_use]
    pub fn inputs(&self, input: f64) -> M::Inputs<f64> {
        self.line.inputs(input)
    }
}

/// The branches, made of pieces that go on at the seam of a closed range.
fn joined_at_the_seam<M: Mechanism<Scalar = f64>>(
    line: &InputLine<M>,
    size: f64,
    found: &FoundPieces<M>,
) -> Vec<Branch<M>> {
    let period = line.period();
    let pieces = &found.pieces;
    let mut used = vec![false; pieces.len()];
    // The piece that goes on after another one beyond the seam.
    let after = |piece: &BranchPiece<M>, used: &[bool]| {
        let (_, last) = piece.samples.last()?;
        let candidates = pieces
            .iter()
            .enumerate()
            .filter(|(index, other)| !used[*index] && other.low == Tip::Seam && period.is_some());
        let nearest = candidates.filter_map(|(index, other)| {
            let (_, first) = other.samples.first()?;
            Some((index, distance::<M>(size, last, first)))
        });
        let best = nearest.min_by(|one, other| one.1.total_cmp(&other.1))?;
        (best.1 < 1e-6).then_some(best.0)
    };
    let mut branches = Vec::new();
    // Pieces that begin at a node come first; what is left then begins and ends at the seam.
    let order = |is_first: bool| {
        let all = 0..pieces.len();
        all.filter(move |index| (matches!(pieces[*index].low, Tip::Node(_)) || period.is_none()) == is_first)
    };
    for start in order(true).chain(order(false)) {
        if used[start] {
            continue;
        }
        used[start] = true;
        let mut samples = pieces[start].samples.clone();
        let mut last = start;
        let mut turns = 0.0;
        let begins_at_seam = pieces[start].low == Tip::Seam;
        let mut is_turning = false;
        while let (Tip::Seam, Some(period)) = (pieces[last].high, period) {
            if begins_at_seam {
                used[start] = false;
            }
            let next = after(&pieces[last], &used);
            used[start] = true;
            let Some(next) = next else { break };
            if next == start {
                is_turning = true;
                break;
            }
            turns += 1.0;
            used[next] = true;
            for (s, unknowns) in pieces[next].samples.iter().skip(1) {
                let near = samples.last().map_or(*unknowns, |(_, near)| *near);
                samples.push((s + turns * period, nearest::<M>(*unknowns, &near)));
            }
            last = next;
        }
        let (Some(first_sample), Some(last_sample)) = (samples.first().copied(), samples.last().copied()) else {
            continue;
        };
        let end = |tip: Tip, (s, unknowns): (f64, M::Unknowns<f64>)| {
            let (kind, block, node) = match tip {
                _ if is_turning => (EndKind::FullTurn, "", None),
                Tip::Node(node) => (found.nodes[node].kind, found.nodes[node].block, Some(node)),
                Tip::Seam if period.is_some() => (EndKind::Lost, "", None),
                Tip::Seam => (EndKind::Range, "", None),
            };
            End {
                kind,
                input: s,
                unknowns,
                block,
                node,
            }
        };
        let mut branch = Branch {
            ends: [
                end(pieces[start].low, first_sample),
                end(pieces[last].high, last_sample),
            ],
            samples,
            assembly: pieces[start].assembly,
            circuit: 0,
            joins: [Vec::new(), Vec::new()],
        };
        if let Some(period) = period {
            let middle = 0.5 * (branch.ends[0].input + branch.ends[1].input);
            let shift = if is_turning {
                0.0
            } else {
                // A branch whose middle lies half a period away has it on the positive side, whatever rounding says.
                let aside = HALFWAY * period;
                period * Float::round((line.reduced(middle - aside) + aside - middle) / period)
            };
            if shift != 0.0 {
                for end in &mut branch.ends {
                    end.input += shift;
                }
                for (s, _) in &mut branch.samples {
                    *s += shift;
                }
            }
        }
        branches.push(branch);
    }
    branches
}

/// The branch and the end at which it is entered.
type EnteredBranch = (usize, usize);

/// The circuits of branches that meet at nodes. Each branch learns its circuit and its neighbours.
fn circuits<M: Mechanism<Scalar = f64>>(line: &InputLine<M>, branches: &mut [Branch<M>]) -> Vec<Circuit<M>> {
    let at_node = |branches: &[Branch<M>], node: usize| -> Vec<EnteredBranch> {
        let all = branches.iter().enumerate();
        all.flat_map(|(index, branch)| [0, 1].map(|side| (index, side, branch.ends[side].node)))
            .filter(|(.., own)| *own == Some(node))
            .map(|(index, side, _)| (index, side))
            .collect()
    };
    for index in 0..branches.len() {
        for side in 0..2 {
            if let Some(node) = branches[index].ends[side].node {
                let others = at_node(branches, node);
                branches[index].joins[side] = others
                    .into_iter()
                    .filter(|entry| *entry != (index, side))
                    .map(|(other, _)| other)
                    .collect();
            }
        }
    }
    let mut circuits = Vec::new();
    let mut seen = vec![false; branches.len()];
    for start in 0..branches.len() {
        if seen[start] {
            continue;
        }
        let circuit = around(line, branches, start, &at_node).unwrap_or_else(|| {
            let mut own = vec![start];
            let mut place = 0;
            while let Some(branch) = own.get(place).copied() {
                for other in branches[branch].joins.iter().flatten() {
                    if !own.contains(other) {
                        own.push(*other);
                    }
                }
                place += 1;
            }
            Circuit {
                branches: own,
                input_turns: None,
                turns: None,
            }
        });
        for branch in &circuit.branches {
            seen[*branch] = true;
            branches[*branch].circuit = circuits.len();
        }
        circuits.push(circuit);
    }
    circuits
}

/// The circuit that leads from a branch through its limits back to it, if there is one way only.
fn around<M: Mechanism<Scalar = f64>>(
    line: &InputLine<M>,
    branches: &[Branch<M>],
    start: usize,
    at_node: &impl Fn(&[Branch<M>], usize) -> Vec<EnteredBranch>,
) -> Option<Circuit<M>> {
    let mut own = Vec::new();
    let mut way = 0.0;
    let mut angles: M::Unknowns<f64> = Row::splat(0.0);
    let (mut branch, mut entered) = (start, 0);
    loop {
        own.push(branch);
        let ends = &branches[branch].ends;
        let (from, to) = (&ends[entered], &ends[1 - entered]);
        way += to.input - from.input;
        for (sum, (to, from)) in angles
            .as_mut()
            .iter_mut()
            .zip(to.unknowns.as_ref().iter().zip(from.unknowns.as_ref()))
        {
            *sum += to - from;
        }
        if branches[branch].is_full_turn() {
            break;
        }
        let node = to.node?;
        let meeting = at_node(branches, node);
        let [one, other] = meeting[..] else { return None };
        let next = if one == (branch, 1 - entered) { other } else { one };
        if to.kind != EndKind::Limit {
            return None;
        }
        (branch, entered) = next;
        if branch == start {
            break;
        }
        if own.contains(&branch) {
            return None;
        }
    }
    #[expect(clippy::cast_possible_truncation, reason = "a circuit has far fewer turns")]
    let turns = |sum: f64| Float::round(sum / TAU) as i32;
    Some(Circuit {
        branches: own,
        input_turns: Some(if line.is_angle() { turns(way) } else { 0 }),
        turns: Some(Row::from_fn(|index| match M::DESCRIPTION.unknowns[index].dimension {
            Dimension::Angle => turns(angles[index]),
            _ => 0,
        })),
    })
}
