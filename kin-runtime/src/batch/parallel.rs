//! A batch on all cores.

use core::fmt;
use std::vec::Vec;

use rayon::prelude::*;

use super::destination::Destination;
use super::dispatch::MOST_SINGLES;
use super::lanes::Element;
use super::outcome::{LengthMismatch, Outcome, Summary};
use super::sweep::{Batch, Guide};
use super::target::{Columns, Slot, Target, Visitor};
use crate::mechanism::Mechanism;

/// The number of poses solved in one go: enough to be worth handing over, and few enough for the first-level cache.
const PIECE: usize = 512;

/// A batch that is solved on all cores, in the thread pool of rayon. [`Batch::on_all_cores`] makes it.
#[must_use = "`solve` it, or ask for its `balance`"]
#[derive(Clone, Copy)]
pub struct ParallelBatch<'a, M: Mechanism, G>(pub(super) Batch<'a, M, G>);

impl<M: Mechanism, G> fmt::Debug for ParallelBatch<'_, M, G> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("ParallelBatch").finish_non_exhaustive()
    }
}

impl<'a, M: Mechanism, G> Batch<'a, M, G> {
    /// The same on all cores, in the thread pool of rayon. The numbers are the same to the last bit.
    #[cfg_attr(docsrs, doc(cfg(feature = "rayon")))]
    pub fn on_all_cores(self) -> ParallelBatch<'a, M, G> {
        ParallelBatch(self)
    }
}

impl<'a, M: Mechanism<Scalar: Element>, G: Guide<'a, M>> ParallelBatch<'a, M, G>
where
    Batch<'a, M, G>: Sync,
{
    /// [`Batch::solve`] on all cores.
    ///
    /// # Errors
    /// As there.
    pub fn solve<P: Columns<C>, C: Target<M::Scalar>>(
        &self,
        poses: &mut P,
        outcomes: &mut [Outcome],
    ) -> Result<Summary, LengthMismatch> {
        solve_pieces(&self.0, poses, outcomes)
    }
}

fn solve_pieces<'a, M, G, P, C>(
    batch: &Batch<'a, M, G>,
    poses: &mut P,
    outcomes: &mut [Outcome],
) -> Result<Summary, LengthMismatch>
where
    M: Mechanism<Scalar: Element>,
    G: Guide<'a, M>,
    Batch<'a, M, G>: Sync,
    P: Columns<C>,
    C: Target<M::Scalar>,
{
    batch.check_lengths(outcomes.len())?;
    Destination::<M, _>::nowhere().find(poses, outcomes.len())?;
    let mut targets = Targets(Vec::new());
    poses.each(&mut targets);
    let whole = outcomes.len();
    let (mut rest, mut pieces) = (outcomes, Vec::new());
    let mut start = 0;
    while !rest.is_empty() {
        // No piece has fewer poses than lanes: they would be solved one by one and rounded differently.
        let count = if rest.len() < PIECE + MOST_SINGLES {
            rest.len()
        } else {
            PIECE
        };
        let (outcomes, next) = rest.split_at_mut(count);
        pieces.push((targets.split_off(count), outcomes, start..start + count));
        (rest, start) = (next, start + count);
    }
    pieces
        .into_par_iter()
        .map(|(mut targets, outcomes, range)| {
            let first = range.start;
            let mut piece = batch.part(range);
            piece.whole = whole;
            let mut summary = piece.sweep(&mut targets, outcomes)?;
            if let Some((index, _)) = &mut summary.first_failure {
                *index += first;
            }
            Ok(summary)
        })
        .try_reduce(Summary::default, |one, other| Ok(one.and(other)))
}

/// The wanted targets, one after the other.
struct Targets<'a, E>(Vec<(Slot, &'a mut [E])>);

impl<'a, E, C: Target<E>> Visitor<'a, C> for Targets<'a, E> {
    fn visit(&mut self, slot: Slot, there: &'a mut C) {
        if let Some(slice) = there.slice() {
            self.0.push((slot, slice));
        }
    }
}

impl<'a, E> Targets<'a, E> {
    /// Splits off the columns for the next poses.
    fn split_off(&mut self, count: usize) -> Self {
        let split = |(slot, slice): &mut (Slot, &'a mut [E])| {
            let (next, rest) = core::mem::take(slice).split_at_mut(count);
            *slice = rest;
            (*slot, next)
        };
        Self(self.0.iter_mut().map(split).collect())
    }
}

impl<'a, E> Columns<&'a mut [E]> for Targets<'a, E> {
    #[inline]
    fn each<'b>(&'b mut self, visitor: &mut impl Visitor<'b, &'a mut [E]>)
    where
        &'a mut [E]: 'b,
    {
        for (slot, slice) in &mut self.0 {
            visitor.visit(*slot, slice);
        }
    }
}
