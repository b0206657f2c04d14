//! The search where every block has a closed form: each assembly alone, by bounds over intervals of the input.

use alloc::vec;
use alloc::vec::Vec;

use core::ops::Range;

use num_traits::Float;

use super::curved::Curved;
use super::free::{self, Jump};
use super::interpolation::{CROSSING, around, crosses, interpolated};
use super::line::{InputLine, MEETING, count};
use super::pieces::{BranchNode, BranchPiece, FoundPieces, Tip};
use super::sought::{ClosedForms, SoughtMechanism};
use super::{EndKind, Incomplete};
use crate::any::PositionChoice;
use crate::bounds::{Bounds, Doubt, UNBOUNDED, UNDECIDED};
use crate::curve::LimitKind;
use crate::failure::{Failure, SolveError};
use crate::number::NumberRow;
use crate::picture::TransmissionAngle;
use crate::quantity::Name;
use crate::quantity::{Dimension, Quantity};
use crate::track::TrackError;

/// The number of intervals of the first division.
const FIRST_INTERVALS: u32 = 8;
/// The shortest interval, as a part of the range: a few units in the last place of its ends.
const SHORTEST_INTERVAL: f64 = 1.0 / 1_125_899_906_842_624.0;
/// The distance of points that may be the same, as a part of the range.
pub(super) const RESOLUTION: f64 = 1.0 / 16_777_216.0;
/// The largest number of intervals of an assembly, besides those with which its search begins.
const MOST_INTERVALS: usize = 4096;
/// The number of intervals of an assembly from which on second derivatives are worth their time.
const BENDING: usize = 512;
/// The largest number of intervals with which the search of an assembly begins.
const MOST_SHARED: usize = 256;
/// The largest distance from a change point at which values lead to it, as a part of the range.
const FARTHEST_SAMPLE: f64 = 2e-2;
/// The part of that distance at which the nearest of these values lie.
const NEAREST: f64 = 0.15;
/// The largest difference of two locations of a change point that agree, as a part of the range.
const SETTLED: f64 = 1e-13;
/// Two distances from a limit at which differences of assemblies show where these meet, as parts of the range.
const ROOTS: [f64; 2] = [1.0 / 268_435_456.0, 1.0 / 67_108_864.0];
/// The largest distance of limits at the same point, as a part of the range: that of some units in the last place of
/// the lengths.
const TOGETHER: f64 = 1.0 / 8_796_093_022_208.0;
/// The largest distance of two ranges in which rounding decides about one point, as a multiple of their widths.
const BRIDGE: f64 = 8.0;
/// The growth of a length from the distance [`RESOLUTION`] to the neighbourhood of a pole.
const POLE: f64 = 1e3;
/// The largest distance by which an angle may move from the middle of an interval.
const SWING: f64 = 1.5;

/// What is known about an interval.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Known {
    Closes,
    Fails,
    /// At most one limit, which the ends determine.
    OneLimit,
    /// Rounding decides.
    Rounding,
    /// The shortest interval.
    Short,
    /// There were too many intervals.
    Undecided,
}

struct Interval {
    low: f64,
    high: f64,
    known: Known,
    middle: Option<NumberRow>,
}

/// The input at which two assemblies cross, the unknowns there, and the index of the other assembly.
type BranchCrossing = (f64, NumberRow, usize);

/// The end of a piece at a node. A part that rotates freely there may have another direction than in the node.
#[derive(Clone)]
struct PieceEnd {
    node: usize,
    unknowns: NumberRow,
}

pub(super) struct ClosedSearch<'a> {
    pub(super) mechanism: &'a SoughtMechanism<'a>,
    functions: &'a dyn ClosedForms,
    bounded: Vec<Bounds>,
    curved: Vec<Curved>,
    pub(super) line: &'a InputLine,
    pub(super) size: f64,
    /// The ends of the intervals with which the search of an assembly begins: those of the assembly before it, which
    /// has most of its blocks in common with it.
    division: Vec<f64>,
    found: FoundPieces,
}

impl Known {
    /// Whether the assembly closes at the ends of such an interval, if that is known.
    const fn closes(self) -> Option<bool> {
        match self {
            Self::Closes => Some(true),
            Self::Fails => Some(false),
            _ => None,
        }
    }

    /// Whether nothing is known at the ends of such an interval either.
    const fn is_unknown(self) -> bool {
        matches!(self, Self::Rounding | Self::Short)
    }

    const fn may_close(self) -> bool {
        matches!(self, Self::Closes | Self::OneLimit)
    }
}

/// All pieces of branches of a mechanism whose blocks all have closed forms.
pub(super) fn search(mechanism: &SoughtMechanism<'_>, functions: &dyn ClosedForms, line: &InputLine) -> FoundPieces {
    let border = |part: u32| line.low + (line.high - line.low) * (f64::from(part) / f64::from(FIRST_INTERVALS));
    let mut search = ClosedSearch {
        mechanism,
        functions,
        bounded: mechanism.rounded(),
        curved: mechanism.parameters.iter().copied().map(Curved::rounded).collect(),
        line,
        size: mechanism.reach(),
        division: (0..=FIRST_INTERVALS).map(border).collect(),
        found: FoundPieces {
            nodes: Vec::new(),
            pieces: Vec::new(),
            incomplete: Vec::new(),
            undecided: Vec::new(),
            seeds: Vec::new(),
        },
    };
    for assembly in mechanism.assemblies() {
        search.assembly(assembly);
    }
    search.unite();
    search.note_undecided();
    search.found
}

impl ClosedSearch<'_> {
    pub(super) fn solved(&self, s: f64, assembly: usize) -> Option<NumberRow> {
        let choice = PositionChoice::Assembly(assembly);
        self.mechanism.position(&self.line.inputs(s), choice).ok()
    }

    /// The other assemblies.
    fn others(&self, assembly: usize) -> impl Iterator<Item = usize> {
        self.mechanism.assemblies().filter(move |other| *other != assembly)
    }

    pub(super) fn distance(&self, one: &[f64], other: &[f64]) -> f64 {
        self.mechanism.distance(self.size, one, other)
    }

    pub(super) fn transmission_angles(&self, s: f64, unknowns: &[f64]) -> Vec<TransmissionAngle> {
        let mut angles = vec![TransmissionAngle::of("", 0.0, 1.0); self.functions.dyad_count()];
        let (parameters, inputs) = (&self.mechanism.parameters, self.line.inputs(s));
        self.functions
            .angles_of_dyads(parameters, &inputs, unknowns, &mut angles);
        angles
    }

    /// The unknowns over an interval, within bounds.
    fn bounds(&self, low: f64, high: f64, assembly: usize) -> Result<Vec<Bounds>, SolveError> {
        let mut unknowns = vec![Bounds::rounded(0.0); self.mechanism.unknowns().len()];
        let inputs = self.line.inputs_at(Bounds::variable(low, high));
        self.functions
            .position_of_assembly(&self.bounded, &inputs, assembly, &mut unknowns)?;
        Ok(unknowns)
    }

    /// [`bounds`](Self::bounds) that know of second derivatives.
    fn bounds_by_curvature(&self, low: f64, high: f64, assembly: usize) -> Result<Vec<Bounds>, SolveError> {
        let mut unknowns = vec![Curved::rounded(0.0); self.mechanism.unknowns().len()];
        let inputs = self.line.inputs_at(Curved::variable(low, high));
        self.functions
            .position_of_assembly(&self.curved, &inputs, assembly, &mut unknowns)?;
        Ok(unknowns.iter().map(|unknown| unknown.bounds).collect())
    }

    /// What the bounds say about an interval, and the position in its middle.
    fn known(&self, low: f64, high: f64, assembly: usize, is_curved: bool) -> (Option<Known>, Option<NumberRow>) {
        let solved = if is_curved {
            self.bounds_by_curvature(low, high, assembly)
        } else {
            self.bounds(low, high, assembly)
        };
        let unknowns = match solved {
            Ok(unknowns) => unknowns,
            Err(error) => {
                let is_decided = !matches!(error.failure, Failure::NotFinite { quantity } if quantity == UNDECIDED);
                return (is_decided.then_some(Known::Fails), None);
            }
        };
        let doubts = unknowns.iter().map(|unknown| unknown.doubt);
        let doubt = doubts.fold(Doubt::NONE, Doubt::and);
        if doubt.is_rounding() {
            return (Some(Known::Rounding), None);
        }
        // towards a pole
        if unknowns.iter().any(|unknown| unknown.high - unknown.low > UNBOUNDED) {
            return (None, None);
        }
        let swings = |(quantity, unknown): (&Quantity<'_>, &Bounds)| {
            let swing = (unknown.high - unknown.middle()).max(unknown.middle() - unknown.low);
            quantity.dimension == Dimension::Angle && swing > SWING
        };
        if self.mechanism.unknowns().iter().zip(&unknowns).any(swings) {
            return (None, None);
        }
        let middle = NumberRow::from_fn(unknowns.len(), |index| unknowns[index].middle());
        if doubt == Doubt::NONE {
            (Some(Known::Closes), Some(middle))
        } else {
            (doubt.is_one_sided().then_some(Known::OneLimit), None)
        }
    }

    /// The unknowns of the first block about which the bounds are in doubt over an interval.
    fn doubtful_block(&self, low: f64, high: f64, assembly: usize) -> Name {
        match self.bounds(low, high, assembly) {
            Ok(unknowns) => {
                let is_doubtful = |member: &usize| unknowns[*member].doubt != Doubt::NONE;
                let mut blocks = self.mechanism.blocks().iter();
                let block = blocks.position(|block| block.members.iter().any(is_doubtful));
                block.map_or(Name::NONE, |block| self.mechanism.block_name(block))
            }
            Err(error) => error.block,
        }
    }

    /// Notes an interval in which the bounds do not decide whether an assembly closes.
    fn undecided(&mut self, index: usize, low: f64, high: f64) {
        match self.found.undecided.last_mut() {
            Some((known, range)) if *known == index && range[1] == low => range[1] = high,
            _ => self.found.undecided.push((index, [low, high])),
        }
    }

    /// Reports all assemblies about which nothing is known in a part of the range.
    fn note_undecided(&mut self) {
        let undecided = &self.found.undecided;
        let mut indices: Vec<usize> = undecided.iter().map(|(index, _)| *index).collect();
        indices.dedup();
        let range = undecided.iter().map(|(_, range)| *range);
        if let Some(range) = range.reduce(|one, other| [one[0].min(other[0]), one[1].max(other[1])]) {
            self.found.incomplete.push(Incomplete::Undecided {
                assemblies: indices.len(),
                range,
                is_angle: self.line.is_angle,
            });
        }
    }

    /// Reports that rounding decides about a block in a range.
    fn note_rounding(&mut self, block: Name, range: [f64; 2]) {
        let reason = Incomplete::Rounding {
            block,
            range,
            is_angle: self.line.is_angle,
        };
        let is_known = |known: &Incomplete| match *known {
            Incomplete::Rounding {
                block: recorded,
                range: [low, high],
                ..
            } => recorded == block && low <= range[1] && high >= range[0],
            _ => false,
        };
        if !self.found.incomplete.iter().any(is_known) {
            self.found.incomplete.push(reason);
        }
    }

    fn intervals(&mut self, assembly: usize) -> Vec<Interval> {
        let shortest = SHORTEST_INTERVAL * (self.line.high - self.line.low);
        let given = self.division.windows(2).rev();
        let mut waiting: Vec<(f64, f64)> = given.map(|ends| (ends[0], ends[1])).collect();
        let mut done: Vec<Interval> = Vec::with_capacity(32);
        let mut division = Vec::with_capacity(self.division.len());
        division.push(self.line.low);
        let mut count = 0;
        while let Some((low, high)) = waiting.pop() {
            let (known, middle) = self.known(low, high, assembly, count >= BENDING);
            let known = match known {
                Some(known) => known,
                None if high - low > shortest && count < MOST_INTERVALS => {
                    count += 2;
                    let middle = 0.5 * (low + high);
                    waiting.push((middle, high));
                    waiting.push((low, middle));
                    continue;
                }
                None if high - low > shortest => {
                    self.undecided(assembly, low, high);
                    Known::Undecided
                }
                None => Known::Short,
            };
            division.push(high);
            match done.last_mut() {
                Some(last) if last.known == known && !known.may_close() => last.high = high,
                _ => done.push(Interval {
                    low,
                    high,
                    known,
                    middle,
                }),
            }
        }
        if division.len() <= MOST_SHARED {
            self.division = division;
        }
        bridged(done)
    }

    /// Adds the pieces of one assembly.
    fn assembly(&mut self, assembly: usize) {
        let intervals = self.intervals(assembly);
        let mut unfinished: Option<BranchPiece> = None;
        // Whether the assembly closes at the border before an interval, or at the end of the range; nothing if rounding
        // may decide about it.
        let closes_at = |search: &Self, border: usize| {
            // At the border of an interval that closes everywhere, and at that of one that closes nowhere, nothing
            // needs to be solved.
            let [before, after] = [border.checked_sub(1), Some(border)]
                .map(|border| intervals.get(border?).map(|interval| interval.known));
            let known = [before, after].into_iter().flatten().find_map(Known::closes);
            known.or_else(|| {
                let is_inside = before.is_some() && after.is_some();
                let is_unknown = [before, after].into_iter().flatten().any(Known::is_unknown);
                let s = intervals.get(border).map_or(search.line.high, |interval| interval.low);
                (!(is_inside && is_unknown)).then(|| search.solved(s, assembly).is_some())
            })
        };
        let mut closes = closes_at(self, 0).unwrap_or(false);
        if closes {
            unfinished = Some(BranchPiece {
                assembly: Some(assembly),
                low: Tip::Seam,
                high: Tip::Seam,
                samples: Vec::with_capacity(16),
            });
            let s = self.line.low;
            if let (Some(piece), Some(unknowns)) = (unfinished.as_mut(), self.solved(s, assembly)) {
                piece.samples.push((s, unknowns));
            }
        }
        let mut next = 0;
        while let Some(interval) = intervals.get(next) {
            let first = next;
            next += 1;
            if interval.known == Known::Closes {
                if !closes {
                    let node = self.limit(assembly, 0.5 * (interval.low + interval.high), interval.low);
                    unfinished = Some(self.begun(assembly, self.at_node(node)));
                }
                if let (Some(piece), Some(middle)) = (unfinished.as_mut(), &interval.middle) {
                    add(
                        self.mechanism,
                        piece,
                        0.5 * (interval.low + interval.high),
                        middle.clone(),
                    );
                }
                closes = true;
                continue;
            }
            // Intervals whose borders rounding decides are one.
            let after = loop {
                if let Some(after) = closes_at(self, next) {
                    break after;
                }
                next += 1;
            };
            let (low, high) = (interval.low, intervals[next - 1].high);
            if closes != after {
                let (good, bad) = if closes { (low, high) } else { (high, low) };
                let node = self.limit(assembly, good, bad);
                let end = self.at_node(node);
                if closes {
                    self.finish(unfinished.take(), end);
                } else {
                    unfinished = Some(self.begun(assembly, end));
                }
            } else if closes
                && let Some([before, behind]) = self
                    .pole(assembly, [low, high])
                    .or_else(|| self.change_point(assembly, &intervals, first..next))
            {
                self.finish(unfinished.take(), before);
                unfinished = Some(self.begun(assembly, behind));
            }
            closes = after;
        }
        if let Some(mut piece) = unfinished {
            let s = self.line.high;
            if let Some(unknowns) = self.solved(s, assembly) {
                add(self.mechanism, &mut piece, s, unknowns);
            }
            self.found.pieces.push(piece);
        }
    }

    /// The end of a piece that has the unknowns of its node.
    fn at_node(&self, node: usize) -> PieceEnd {
        PieceEnd {
            node,
            unknowns: self.found.nodes[node].unknowns.clone(),
        }
    }

    fn begun(&self, assembly: usize, end: PieceEnd) -> BranchPiece {
        BranchPiece {
            assembly: Some(assembly),
            low: Tip::Node(end.node),
            high: Tip::Seam,
            samples: vec![(self.found.nodes[end.node].s, end.unknowns)],
        }
    }

    fn finish(&mut self, piece: Option<BranchPiece>, end: PieceEnd) {
        let Some(mut piece) = piece else {
            return;
        };
        add(self.mechanism, &mut piece, self.found.nodes[end.node].s, end.unknowns);
        piece.high = Tip::Node(end.node);
        self.found.pieces.push(piece);
    }

    /// The limit between an input at which the assembly closes and one that does not.
    fn limit(&mut self, assembly: usize, mut good: f64, mut bad: f64) -> usize {
        let (low, high) = (good.min(bad), good.max(bad));
        let known = self.found.nodes.iter().position(|node| {
            node.kind == EndKind::Limit(LimitKind::TurningPoint)
                && node.s >= low
                && node.s <= high
                && node.assemblies[1] == assembly
        });
        if let Some(known) = known {
            return known;
        }
        self.narrow(assembly, &mut good, &mut bad);
        let choice = PositionChoice::Assembly(assembly);
        let error = self.mechanism.position(&self.line.inputs(bad), choice).err();
        let block = error.as_ref().map_or(Name::NONE, |error| error.block);
        let is_domain =
            error.is_some_and(|error| !matches!(error.failure, Failure::OutOfReach { .. } | Failure::Singular { .. }));
        let mut node: BranchNode = BranchNode {
            kind: EndKind::Limit(if is_domain {
                LimitKind::End
            } else {
                LimitKind::TurningPoint
            }),
            s: good,
            unknowns: self
                .solved(good, assembly)
                .unwrap_or_else(|| NumberRow::splat(self.mechanism.unknowns().len(), f64::NAN)),
            block,
            assemblies: [assembly, assembly],
        };
        let mut closest = MEETING;
        for other in self.others(assembly) {
            let Some(unknowns) = self.solved(good, other) else {
                continue;
            };
            let distance = self.distance(&node.unknowns, &unknowns);
            if distance < closest {
                closest = distance;
                node.kind = EndKind::Limit(LimitKind::TurningPoint);
                node.assemblies[1] = other;
            }
        }
        let together = self.together(assembly, good, good > bad);
        if let [_, _, ..] = together[..] {
            // Several blocks have their limits here, and all their assemblies meet.
            let unknowns = node.unknowns;
            let others = together.iter().filter_map(|(other, _)| self.solved(good, *other));
            let all: Vec<NumberRow> = others.map(|other| self.mechanism.nearest(&other, &unknowns)).collect();
            node.unknowns = NumberRow::from_fn(unknowns.len(), |unknown| {
                let sum = all.iter().fold(unknowns[unknown], |sum, other| sum + other[unknown]);
                sum / count(all.len() + 1)
            });
            let moves = |member: &usize| together.iter().any(|(_, apart)| apart[*member] != 0.0);
            let mut blocks = self.mechanism.blocks().iter();
            if let Some(first) = blocks.position(|block| block.members.iter().any(moves)) {
                node.block = self.mechanism.block_name(first);
            }
            (node.kind, node.assemblies) = (EndKind::Limit(LimitKind::ChangePoint), [assembly, assembly]);
            return self.noted(node);
        }
        if node.assemblies[1] != assembly
            && let Some(other) = self.solved(good, node.assemblies[1])
        {
            // What the two assemblies differ by is the root of the distance to the limit, with opposite signs.
            let unknowns = node.unknowns;
            let other = self.mechanism.nearest(&other, &unknowns);
            node.unknowns = NumberRow::from_fn(unknowns.len(), |unknown| {
                unknowns[unknown] + 0.5 * (other[unknown] - unknowns[unknown])
            });
        }
        self.found.nodes.push(node);
        self.found.nodes.len() - 1
    }

    /// The other assemblies that meet an assembly at its limit, and how far they are apart from it next to the limit.
    ///
    /// The square of the difference of two assemblies that meet grows with the distance from the input at which it is
    /// zero. Two differences show that input, which is the limit of the block that the assemblies solve differently.
    fn together(&self, assembly: usize, limit: f64, is_above: bool) -> Vec<(usize, NumberRow)> {
        let range = (self.line.high - self.line.low) * if is_above { 1.0 } else { -1.0 };
        let [near, far] = ROOTS.map(|part| limit + part * range);
        let (Some(first), Some(second)) = (self.solved(near, assembly), self.solved(far, assembly)) else {
            return Vec::new();
        };
        let meets = self.others(assembly).filter_map(|other| {
            let unknowns = self.mechanism.nearest(&self.solved(near, other)?, &first);
            let one = self.distance(&first, &unknowns);
            let two = self.distance(&second, &self.solved(far, other)?);
            let (one, two) = (one * one, two * two);
            // From the limit outwards, in parts of the range.
            let remaining = (ROOTS[1] * one - ROOTS[0] * two) / (two - one);
            let apart = NumberRow::from_fn(first.len(), |unknown| unknowns[unknown] - first[unknown]);
            (two > one && remaining.abs() <= TOGETHER).then_some((other, apart))
        });
        meets.collect()
    }

    /// Moves an input that closes and one that does not together until no number lies between them.
    ///
    /// The square of the difference of the two assemblies that meet is zero at the limit, and smooth on the side that
    /// closes. Its secants lead close to the limit, and bisection does the rest.
    fn narrow(&self, assembly: usize, good: &mut f64, bad: &mut f64) {
        let mut secant: Option<(f64, f64)> = None;
        let mut partner = None;
        for step in 0.. {
            let middle = 0.5 * (*good + *bad);
            if middle == *good || middle == *bad {
                return;
            }
            let mut next = middle;
            if (4..24).contains(&step)
                && let Some(here) = self.solved(*good, assembly)
            {
                let separation = |other: usize| Some(self.distance(&here, &self.solved(*good, other)?));
                if partner.is_none() {
                    let all = self
                        .others(assembly)
                        .filter_map(|other| Some((other, separation(other)?)));
                    partner = all
                        .min_by(|one, other| one.1.total_cmp(&other.1))
                        .map(|(other, _)| other);
                }
                if let Some(square) = partner.and_then(separation).map(|root| root * root) {
                    if let Some((previous, before)) = secant
                        && previous != *good
                        && before != square
                    {
                        let root = *good + (*good - previous) * square / (before - square);
                        // A little beyond or before the limit, so that the interval shrinks from both sides.
                        let aside = 1e-2 * (root - *good).abs() + 4.0 * f64::EPSILON * root.abs();
                        let beyond = aside.copysign(*bad - *good);
                        let trial = if step % 2 == 0 { root + beyond } else { root - beyond };
                        if (trial - *good) * (trial - *bad) < 0.0 {
                            next = trial;
                        }
                    }
                    secant = Some((*good, square));
                }
            }
            if self.solved(next, assembly).is_some() {
                *good = next;
            } else {
                *bad = next;
            }
        }
    }

    /// The pole between two inputs at which an assembly closes, if there is one: a length grows towards both of them.
    fn pole(&mut self, assembly: usize, [low, high]: [f64; 2]) -> Option<[PieceEnd; 2]> {
        let away = RESOLUTION * (self.line.high - self.line.low);
        let solved = |s: f64| self.solved(s, assembly);
        let [before, behind] = [(low, -away), (high, away)].map(|(s, away)| Some([solved(s)?, solved(s + away)?]));
        let (before, behind) = (before?, behind?);
        let grows = |[near, far]: &[NumberRow; 2], unknown: usize| near[unknown].abs() > POLE * far[unknown].abs();
        let is_pole = |unknown: &usize| {
            let is_angle = self.mechanism.unknowns()[*unknown].dimension == Dimension::Angle;
            !is_angle && grows(&before, *unknown) && grows(&behind, *unknown)
        };
        let unknown = (0..self.mechanism.unknowns().len()).find(is_pole)?;
        let block = self.mechanism.block_of(unknown);
        // the zero of the reciprocal
        let [left, right] = [before[0][unknown], behind[0][unknown]].map(f64::abs);
        let s = low + (high - low) * (right / (left + right));
        let ([before, _], [behind, _]) = (before, behind);
        Some([before, behind].map(|unknowns| {
            self.found.nodes.push(BranchNode {
                kind: EndKind::Limit(LimitKind::Pole),
                s,
                unknowns: unknowns.clone(),
                block,
                assemblies: [assembly, assembly],
            });
            PieceEnd {
                node: self.found.nodes.len() - 1,
                unknowns,
            }
        }))
    }

    /// The change point in some intervals at both ends of which an assembly closes, if there is one: where the assembly
    /// ends before it, and where it begins behind it. Both are the same unless a part rotates freely there.
    fn change_point(
        &mut self,
        assembly: usize,
        intervals: &[Interval],
        doubtful: Range<usize>,
    ) -> Option<[PieceEnd; 2]> {
        let is_doubtful = |index: &usize| !intervals[*index].known.may_close();
        let (first, last) = (doubtful.clone().find(is_doubtful)?, doubtful.rev().find(is_doubtful)?);
        let (low, high) = (intervals[first].low, intervals[last].high);
        let range = self.line.high - self.line.low;
        let slack = RESOLUTION * range;
        let is_inside = |s: f64| s >= low - slack && s <= high + slack;
        let known = self.found.nodes.iter().position(|node| {
            node.kind == EndKind::Limit(LimitKind::ChangePoint) && is_inside(node.s) && node.assemblies[1] == assembly
        });
        if let Some(known) = known {
            return Some([known; 2].map(|node| self.at_node(node)));
        }
        // As far as it certainly closes on both sides, but not farther than the curvature allows.
        let far = FARTHEST_SAMPLE * range;
        let may_close = |interval: &&Interval| interval.known.may_close();
        let before = intervals[..first].iter().rev().take_while(may_close).last();
        let after = intervals[last + 1..].iter().take_while(may_close).last();
        let start = before.map_or(low, |interval| self.closing(interval.low.max(low - far), low, assembly));
        let end = after.map_or(high, |interval| {
            self.closing(interval.high.min(high + far), high, assembly)
        });
        let middle = 0.5 * (low + high);
        let reach = (middle - start).min(end - middle).min(0.5 * far);
        let is_rounding = intervals[first..=last]
            .iter()
            .any(|interval| interval.known == Known::Rounding);
        if is_rounding && NEAREST * reach < high - low {
            // The nearest values have no digits.
            let block = self.doubtful_block(low, high, assembly);
            self.note_rounding(block, [low, high]);
            return None;
        }
        let samples = around(middle, reach);
        if let Some(Jump { s, unknowns, block }) = free::jump(self, assembly, &samples)
            && is_inside(s)
        {
            let mut end = |unknowns: NumberRow| {
                let node = self.noted(BranchNode {
                    kind: EndKind::Limit(LimitKind::ChangePoint),
                    s,
                    unknowns: unknowns.clone(),
                    block,
                    assemblies: [assembly, assembly],
                });
                PieceEnd { node, unknowns }
            };
            let [before, behind] = unknowns;
            return Some([end(before), end(behind)]);
        }
        let block = self.doubtful_block(low - slack, high + slack, assembly);
        let crossing = self.crossing(assembly, middle, reach);
        let (s, unknowns, block, other) = if let Some((s, unknowns, other)) = crossing.filter(|(s, ..)| is_inside(*s)) {
            (s, unknowns, block, other)
        } else {
            let unknowns = self.solved(start, assembly)?;
            let (from, to) = (self.line.inputs(start), self.line.inputs(end));
            match self.mechanism.track(&from, &unknowns, &to) {
                Ok(_) => {
                    if is_rounding {
                        self.note_rounding(block, [low, high]);
                    }
                    return None;
                }
                Err(TrackError::ChangePoint(obstacle) | TrackError::TurningPoint(obstacle)) => (
                    self.line.coordinate(&obstacle.inputs),
                    NumberRow::from(&*obstacle.unknowns),
                    obstacle.block,
                    assembly,
                ),
                Err(_) => {
                    self.undecided(assembly, low, high);
                    (middle, unknowns, Name::NONE, assembly)
                }
            }
        };
        let node = self.noted(BranchNode {
            kind: EndKind::Limit(LimitKind::ChangePoint),
            s,
            unknowns,
            block,
            assemblies: [assembly, other],
        });
        let sides = (other == assembly)
            .then(|| free::sides(self, assembly, s, reach))
            .flatten();
        Some(sides.map_or_else(
            || [node; 2].map(|node| self.at_node(node)),
            |sides| sides.map(|unknowns| PieceEnd { node, unknowns }),
        ))
    }

    /// The input at which an assembly closes, as close to a wanted one as halving the way to another input finds it.
    fn closing(&self, wanted: f64, near: f64, assembly: usize) -> f64 {
        let halvings = core::iter::successors(Some(wanted), |s| Some(0.5 * (s + near)));
        let mut closing = halvings.take(8).filter(|s| self.solved(*s, assembly).is_some());
        closing.next().unwrap_or(near)
    }

    /// Whether two nodes are change points at the same input.
    fn is_same_change_point(&self, one: &BranchNode, other: &BranchNode) -> bool {
        let tolerance = 8.0 * RESOLUTION * (self.line.high - self.line.low);
        [one, other]
            .iter()
            .all(|node| node.kind == EndKind::Limit(LimitKind::ChangePoint))
            && (one.s - other.s).abs() <= tolerance
    }

    /// The index of a change point, which is added unless it is known.
    fn noted(&mut self, node: BranchNode) -> usize {
        let known = self.found.nodes.iter().position(|known| {
            self.is_same_change_point(known, &node) && self.distance(&known.unknowns, &node.unknowns) < MEETING
        });
        known.unwrap_or_else(|| {
            self.found.nodes.push(node);
            self.found.nodes.len() - 1
        })
    }

    /// Makes one node of change points between which a part rotates freely.
    fn unite(&mut self) {
        let mut united: Vec<usize> = (0..self.found.nodes.len()).collect();
        for other in 1..self.found.nodes.len() {
            let node = &self.found.nodes[other];
            let mut before = self.found.nodes[..other].iter();
            let same = before.position(|earlier| {
                let positions: [&[f64]; 2] = [&earlier.unknowns, &node.unknowns];
                self.is_same_change_point(earlier, node) && free::is_connected(self, node.s, positions)
            });
            if let Some(same) = same {
                united[other] = united[same];
            }
        }
        for piece in &mut self.found.pieces {
            for tip in [&mut piece.low, &mut piece.high] {
                if let Tip::Node(node) = tip {
                    *node = united[*node];
                }
            }
        }
    }

    /// The input near another one at which two assemblies cross, the unknowns there, and the index of the other
    /// assembly.
    ///
    /// It is found from inputs as far away as another limit allows, and from closer ones as long as these differ: next
    /// to another limit, the assemblies are no smooth functions of the input.
    fn crossing(&self, assembly: usize, s: f64, reach: f64) -> Option<BranchCrossing> {
        let tolerance = SETTLED * (self.line.high - self.line.low);
        let mut best: Option<(f64, BranchCrossing)> = None;
        let mut before: Option<BranchCrossing> = None;
        for halving in 0..8 {
            let found = self.crossing_within(assembly, s, reach * Float::powi(0.5, halving));
            if let (Some(before), Some(found)) = (before, &found) {
                let change = (found.0 - before.0).abs();
                if change <= tolerance {
                    // Values that are farther away have more digits.
                    return Some(before);
                }
                if best.as_ref().is_none_or(|(least, _)| change < *least) {
                    best = Some((change, found.clone()));
                }
            }
            before = found;
        }
        best.map(|(_, found)| found)
    }

    /// The input at which two assemblies cross, from others within a distance from it.
    ///
    /// Both are smooth if they change roles at the crossing. So their difference, with its sign changed behind the
    /// crossing, is a smooth function with a simple zero, which inverse interpolation finds from inputs where the
    /// difference has all its digits.
    fn crossing_within(&self, assembly: usize, s: f64, reach: f64) -> Option<BranchCrossing> {
        let samples = around(s, reach);
        let first_assembly = samples.map(|s| self.solved(s, assembly));
        let first = first_assembly[CROSSING / 2].clone()?;
        let candidates = self.others(assembly).filter_map(|other| {
            let position = self.solved(samples[CROSSING / 2], other)?;
            Some((other, self.distance(&first, &position)))
        });
        let (partner, _) = candidates.min_by(|one, other| one.1.total_cmp(&other.1))?;
        let count = first.len();
        let mut means: [_; CROSSING] = core::array::from_fn(|_| first.clone());
        let mut halves = means.clone();
        for (sample, one) in first_assembly.into_iter().enumerate() {
            let one = self.mechanism.nearest(&one?, &first);
            let other = self.mechanism.nearest(&self.solved(samples[sample], partner)?, &one);
            let side = if samples[sample] < s { 0.5 } else { -0.5 };
            means[sample] = NumberRow::from_fn(count, |unknown| 0.5 * (one[unknown] + other[unknown]));
            halves[sample] = NumberRow::from_fn(count, |unknown| side * (one[unknown] - other[unknown]));
        }
        let lead = (0..count).max_by(|one, other| {
            let size = |unknown: usize| halves[0][unknown].abs();
            size(*one).total_cmp(&size(*other))
        })?;
        let differences: [f64; CROSSING] = core::array::from_fn(|sample| halves[sample][lead]);
        let found = interpolated(&differences, &samples, 0.0);
        let unknowns = NumberRow::from_fn(count, |unknown| {
            interpolated(&samples, &core::array::from_fn(|sample| means[sample][unknown]), found)
        });
        let is_finite = unknowns.iter().all(|value| value.is_finite());
        (is_finite && crosses(&differences)).then_some((found, unknowns, partner))
    }
}

/// The intervals, where those that rounding decides are one with others close by, if the assembly closes in between.
/// How far rounding reaches is not known better than that.
fn bridged(intervals: Vec<Interval>) -> Vec<Interval> {
    let mut all: Vec<Interval> = Vec::with_capacity(intervals.len());
    for interval in intervals {
        let before = all.iter().rposition(|earlier| !earlier.known.may_close());
        if interval.known == Known::Rounding
            && let Some(before) = before
            && all[before].known == Known::Rounding
            && interval.low - all[before].high
                <= BRIDGE * ((interval.high - interval.low) + (all[before].high - all[before].low))
        {
            all.truncate(before + 1);
            all[before].high = interval.high;
        } else {
            all.push(interval);
        }
    }
    all
}

/// Adds a sample at the end of a piece, with angles unwrapped to the samples before.
fn add(mechanism: &SoughtMechanism<'_>, piece: &mut BranchPiece, s: f64, unknowns: NumberRow) {
    let unknowns = match piece.samples.last() {
        Some((_, last)) => mechanism.nearest(&unknowns, last),
        None => unknowns,
    };
    if Float::is_finite(s) {
        piece.samples.push((s, unknowns));
    }
}
