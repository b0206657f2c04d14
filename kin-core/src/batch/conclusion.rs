//! The outcomes of a chunk of poses that were solved at once.

use num_traits::Float;

use super::lanes::{Element, Lanes};
use super::outcome::{Outcome, Summary};
use crate::failure::SolveError;
use crate::number::Number;

/// A chunk in which poses have failed.
#[derive(Clone, Copy)]
pub(super) struct Chunk<const W: usize, const FUSED: bool, E> {
    /// The first pose.
    pub(super) start: usize,
    /// The first pose without an outcome.
    pub(super) next: usize,
    /// The sum of all numbers of each pose, which is not finite where the pose has failed.
    pub(super) sum: Lanes<W, FUSED, E>,
    /// The margins of the poses that have failed, as far as they are known.
    pub(super) margins: Lanes<W, FUSED, E>,
}

impl<const W: usize, const FUSED: bool, E: Element> Chunk<W, FUSED, E> {
    /// Writes the outcomes by the margins, and returns which poses have failed by them. A failed pose without a margin is
    /// solved alone, and so is the first failed pose of the batch, whose whole error is kept.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn conclude(
        self,
        outcomes: &mut [Outcome],
        summary: &mut Summary,
        alone: impl FnMut(usize) -> Result<(), SolveError>,
    ) -> Lanes<W, FUSED, E> {
        let Self {
            start,
            next,
            sum,
            margins,
        } = self;
        let mut is_told = start == next && summary.first_failure.is_some();
        for lane in 0..W {
            is_told &= Float::is_finite(sum.0[lane]) | (margins.0[lane] < E::zero());
        }
        if !is_told {
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
        let is_told = margin < 0.0 && summary.first_failure.is_some();
        if index < next {
            // Its outcome is known, but its numbers have been overwritten.
            if outcomes[index].is_solved() {
                let _ = alone(index);
            }
        } else if is_told {
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
