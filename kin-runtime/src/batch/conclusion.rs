//! The outcomes of a batch, whose poses are solved in chunks.

use num_traits::Float;

use super::lanes::{Element, Lanes, verdicts};
use super::outcome::{Outcome, Summary};
use crate::failure::SolveError;
use crate::number::Number;

/// A chunk in which poses have failed.
#[derive(Clone, Copy)]
pub(super) struct Chunk<const W: usize, const BITS: usize, E> {
    /// The first pose.
    pub(super) start: usize,
    /// The first pose without an outcome.
    pub(super) next: usize,
    /// The sum of all numbers of each pose, which is not finite where the pose has failed.
    pub(super) sum: Lanes<W, BITS, E>,
    /// The sum of the squares of parameters and inputs. The margin of a pose counts only if none of them can be the
    /// cause of its failure.
    pub(super) squares: Lanes<W, BITS, E>,
}

/// The summary of a batch while it is solved.
pub(super) struct Conclusion<const W: usize, const BITS: usize, E> {
    summary: Summary,
    /// The poses of each lane that have failed by their margins since the count was emptied. Lanes of single precision
    /// count to 2²⁴. The count is emptied long before.
    failed: Lanes<W, BITS, E>,
    /// The pose at which the count was emptied.
    emptied: usize,
}

impl<const W: usize, const BITS: usize, E: Element> Conclusion<W, BITS, E> {
    /// The summary of so many poses, all of which are solved until they fail.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn of(count: usize) -> Self {
        Self {
            summary: Summary {
                solved: count,
                ..Summary::default()
            },
            failed: Lanes::constant(0.0),
            emptied: 0,
        }
    }

    /// Adds a chunk in which poses have failed, and counts those that have failed by their margins.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn add(
        &mut self,
        chunk: Chunk<W, BITS, E>,
        outcomes: &mut [Outcome],
        alone: impl FnMut(usize) -> Result<(), SolveError>,
    ) {
        self.failed = self.failed + chunk.conclude(outcomes, &mut self.summary, alone);
        if chunk.start - self.emptied >= 1 << 16 {
            self.summary.fail(self.failed.count());
            (self.failed, self.emptied) = (Lanes::constant(0.0), chunk.start);
        }
    }

    /// The whole summary. The poses from `next` on are solved alone.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn end(
        mut self,
        next: usize,
        outcomes: &mut [Outcome],
        mut alone: impl FnMut(usize) -> Result<(), SolveError>,
    ) -> Summary {
        self.summary.fail(self.failed.count());
        for (index, outcome) in outcomes.iter_mut().enumerate().skip(next) {
            *outcome = self.summary.note(index, alone(index));
        }
        self.summary
    }
}

impl<const W: usize, const BITS: usize, E: Element> Chunk<W, BITS, E> {
    /// Writes the outcomes by the margins, and returns which poses have failed by them. A failed pose without a margin
    /// is solved alone, and so is the first failed pose of the batch, whose whole error is kept.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn conclude(
        self,
        outcomes: &mut [Outcome],
        summary: &mut Summary,
        alone: impl FnMut(usize) -> Result<(), SolveError>,
    ) -> Lanes<W, BITS, E> {
        let Self {
            start,
            next,
            sum,
            squares,
        } = self;
        let margins = verdicts::read().within(squares);
        let mut is_conclusive = start == next && summary.first_failure.is_some();
        for lane in 0..W {
            is_conclusive &= Float::is_finite(sum.0[lane]) | (margins.0[lane] < E::zero());
        }
        if !is_conclusive {
            settle_all([start, next], &sum.0, &margins.0, outcomes, summary, alone);
            return Lanes::constant(0.0);
        }
        if let Some(outcomes) = outcomes.get_mut(start..start + W) {
            for (lane, outcome) in outcomes.iter_mut().enumerate() {
                let margin = margins.0[lane].real();
                *outcome = if Float::is_finite(sum.0[lane]) {
                    Outcome::Solved
                } else {
                    Outcome::OutOfReach { margin }
                };
            }
        }
        sum.gone()
    }
}

#[cold]
#[inline(never)]
fn settle_all<E: Element>(
    [start, next]: [usize; 2],
    sums: &[E],
    margins: &[E],
    outcomes: &mut [Outcome],
    summary: &mut Summary,
    mut alone: impl FnMut(usize) -> Result<(), SolveError>,
) {
    for (index, (sum, margin)) in (start..).zip(sums.iter().zip(margins)) {
        if Float::is_finite(*sum) {
            continue;
        }
        let margin = margin.real();
        let is_conclusive = margin < 0.0 && summary.first_failure.is_some();
        if index < next {
            // Its outcome is known, but its numbers have been overwritten.
            if outcomes[index].is_solved() {
                let _ = alone(index);
            }
        } else if is_conclusive {
            summary.fail(1);
            outcomes[index] = Outcome::OutOfReach { margin };
        } else {
            outcomes[index] = match summary.note(index, alone(index)) {
                // The margin of a pose does not depend on whether the pose is the first to fail.
                Outcome::OutOfReach { .. } if margin < 0.0 => Outcome::OutOfReach { margin },
                outcome => outcome,
            };
        }
    }
}
