//! Branches made of pieces, and circuits made of branches.

use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::TAU;

use num_traits::Float;

use super::data::{Branch, Circuit, End, EndKind};
use super::line::InputLine;
use super::pieces::{BranchPiece, FoundPieces, Tip};
use super::sought::SoughtMechanism;
use crate::curve::LimitKind;
use crate::number::NumberRow;
use crate::quantity::Dimension;
use crate::quantity::Name;

/// The largest distance from half a period that may be rounding, as a part of it.
const HALFWAY: f64 = 1e-6;

/// The branches, made of pieces that go on at the seam of a closed range.
pub(super) fn joined_at_the_seam(
    mechanism: &SoughtMechanism<'_>,
    line: &InputLine,
    found: &FoundPieces,
) -> Vec<Branch> {
    let size = mechanism.reach();
    let period = line.period();
    let pieces = &found.pieces;
    let mut used = vec![false; pieces.len()];
    // The piece that goes on after another one beyond the seam.
    let after = |piece: &BranchPiece, used: &[bool]| {
        let (_, last) = piece.samples.last()?;
        let candidates = pieces
            .iter()
            .enumerate()
            .filter(|(index, other)| !used[*index] && other.low == Tip::Seam && period.is_some());
        let nearest = candidates.filter_map(|(index, other)| {
            let (_, first) = other.samples.first()?;
            Some((index, mechanism.distance(size, last, first)))
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
        let mut revolutions = 0.0;
        let begins_at_seam = pieces[start].low == Tip::Seam;
        let mut is_endless = false;
        while let (Tip::Seam, Some(period)) = (pieces[last].high, period) {
            if begins_at_seam {
                used[start] = false;
            }
            let next = after(&pieces[last], &used);
            used[start] = true;
            let Some(next) = next else { break };
            if next == start {
                is_endless = true;
                break;
            }
            revolutions += 1.0;
            used[next] = true;
            for (s, unknowns) in pieces[next].samples.iter().skip(1) {
                let near = samples
                    .last()
                    .map_or_else(|| unknowns.clone(), |(_, near)| near.clone());
                samples.push((s + revolutions * period, mechanism.nearest(unknowns, &near)));
            }
            last = next;
        }
        let (Some(first_sample), Some(last_sample)) = (samples.first().cloned(), samples.last().cloned()) else {
            continue;
        };
        let end = |tip: Tip, (s, unknowns): (f64, NumberRow)| {
            let (kind, block, node) = match tip {
                _ if is_endless => (EndKind::FullRevolution, Name::NONE, None),
                Tip::Node(node) => (found.nodes[node].kind, found.nodes[node].block, Some(node)),
                Tip::Seam if period.is_some() => (EndKind::Lost, Name::NONE, None),
                Tip::Seam => (EndKind::Range, Name::NONE, None),
            };
            End {
                kind,
                input: s,
                unknowns: unknowns.to_vec(),
                block,
                node,
            }
        };
        let mut branch = Branch {
            ends: [
                end(pieces[start].low, first_sample),
                end(pieces[last].high, last_sample),
            ],
            samples: samples
                .into_iter()
                .map(|(s, unknowns)| (s, unknowns.to_vec()))
                .collect(),
            assembly: pieces[start].assembly,
            circuit: 0,
            joins: [Vec::new(), Vec::new()],
        };
        if let Some(period) = period {
            let middle = 0.5 * (branch.ends[0].input + branch.ends[1].input);
            let shift = if is_endless {
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
pub(super) fn circuits(mechanism: &SoughtMechanism<'_>, line: &InputLine, branches: &mut [Branch]) -> Vec<Circuit> {
    let at_node = |branches: &[Branch], node: usize| -> Vec<EnteredBranch> {
        let all = branches.iter().enumerate();
        all.flat_map(|(index, branch)| [0, 1].map(|side| (index, side, branch.ends[side].node)))
            .filter(|(.., other)| *other == Some(node))
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
        let circuit = around(mechanism, line, branches, start, &at_node).unwrap_or_else(|| {
            let mut connected = vec![start];
            let mut index = 0;
            while let Some(branch) = connected.get(index).copied() {
                for other in branches[branch].joins.iter().flatten() {
                    if !connected.contains(other) {
                        connected.push(*other);
                    }
                }
                index += 1;
            }
            Circuit {
                branches: connected,
                input_revolutions: None,
                revolutions: None,
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
fn around(
    mechanism: &SoughtMechanism<'_>,
    line: &InputLine,
    branches: &[Branch],
    start: usize,
    at_node: &impl Fn(&[Branch], usize) -> Vec<EnteredBranch>,
) -> Option<Circuit> {
    let mut passed = Vec::new();
    let mut way = 0.0;
    let quantities = mechanism.unknowns();
    let mut angles = vec![0.0; quantities.len()];
    let (mut branch, mut entered) = (start, 0);
    loop {
        passed.push(branch);
        let ends = &branches[branch].ends;
        let (from, to) = (&ends[entered], &ends[1 - entered]);
        way += to.input - from.input;
        for (sum, (to, from)) in angles.iter_mut().zip(to.unknowns.iter().zip(&from.unknowns)) {
            *sum += to - from;
        }
        if branches[branch].is_full_revolution() {
            break;
        }
        let node = to.node?;
        let meeting = at_node(branches, node);
        let [one, other] = meeting[..] else { return None };
        let next = if one == (branch, 1 - entered) { other } else { one };
        if to.kind != EndKind::Limit(LimitKind::TurningPoint) {
            return None;
        }
        (branch, entered) = next;
        if branch == start {
            break;
        }
        if passed.contains(&branch) {
            return None;
        }
    }
    #[expect(clippy::cast_possible_truncation, reason = "a circuit has far fewer revolutions")]
    let revolutions = |sum: f64| Float::round(sum / TAU) as i32;
    Some(Circuit {
        branches: passed,
        input_revolutions: Some(if line.is_angle { revolutions(way) } else { 0 }),
        revolutions: Some(
            quantities
                .iter()
                .zip(angles)
                .map(|(quantity, angle)| match quantity.dimension {
                    Dimension::Angle => revolutions(angle),
                    _ => 0,
                })
                .collect(),
        ),
    })
}
