//! A batch on all cores.

use std::vec::Vec;

use rayon::prelude::*;

use super::Column;
use super::destination::Destination;
use super::dispatch::{MOST_SINGLES, Vectors};
use super::lanes::Element;
use super::outcome::{LengthMismatch, Outcome, Summary};
use super::sweep::{Guide, InAssembly, Nearest, Problem};
use super::target::{Columns, Place, Target, Visitor};
use crate::mechanism::Mechanism;

/// The number of poses solved in one go: enough to be worth handing over, and few enough for the first-level cache.
const PIECE: usize = 512;

/// [`solve`](super::solve) on all cores, in the thread pool of rayon.
///
/// # Errors
/// As for [`solve`](super::solve).
pub fn solve_in_parallel<'a, M, P, C>(
    parameters: M::Parameters<Column<'a, M::Scalar>>,
    inputs: M::Inputs<M::Motion<Column<'a, M::Scalar>>>,
    assembly: M::Assembly,
    poses: &mut P,
    outcomes: &mut [Outcome],
    vectors: Vectors,
) -> Result<Summary, LengthMismatch>
where
    M: Mechanism<Scalar: Element, Assembly: Sync>,
    M::Parameters<Column<'a, M::Scalar>>: Sync,
    M::Inputs<M::Motion<Column<'a, M::Scalar>>>: Sync,
    P: Columns<C>,
    C: Target<M::Scalar>,
{
    let problem = Problem::<M, _> {
        parameters,
        inputs,
        guide: InAssembly(assembly),
    };
    solve_pieces(&problem, poses, outcomes, vectors)
}

/// [`solve_near`](super::solve_near) on all cores, in the thread pool of rayon.
///
/// # Errors
/// As for [`solve`](super::solve).
pub fn solve_near_in_parallel<'a, M, P, C>(
    parameters: M::Parameters<Column<'a, M::Scalar>>,
    inputs: M::Inputs<M::Motion<Column<'a, M::Scalar>>>,
    near: M::Unknowns<Column<'a, M::Scalar>>,
    poses: &mut P,
    outcomes: &mut [Outcome],
    vectors: Vectors,
) -> Result<Summary, LengthMismatch>
where
    M: Mechanism<Scalar: Element>,
    M::Parameters<Column<'a, M::Scalar>>: Sync,
    M::Inputs<M::Motion<Column<'a, M::Scalar>>>: Sync,
    M::Unknowns<Column<'a, M::Scalar>>: Sync,
    P: Columns<C>,
    C: Target<M::Scalar>,
{
    let problem = Problem::<M, _> {
        parameters,
        inputs,
        guide: Nearest(near),
    };
    solve_pieces(&problem, poses, outcomes, vectors)
}

fn solve_pieces<'a, M, G, P, C>(
    problem: &Problem<'a, M, G>,
    poses: &mut P,
    outcomes: &mut [Outcome],
    vectors: Vectors,
) -> Result<Summary, LengthMismatch>
where
    M: Mechanism<Scalar: Element>,
    G: Guide<'a, M>,
    Problem<'a, M, G>: Sync,
    P: Columns<C>,
    C: Target<M::Scalar>,
{
    problem.check_lengths(outcomes.len())?;
    Destination::<M>::nowhere().find(poses, outcomes.len())?;
    let mut targets = Targets(Vec::new());
    poses.each(&mut targets);
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
            let mut summary = problem.part(range).sweep(&mut targets, outcomes, vectors)?;
            if let Some((index, _)) = &mut summary.first_failure {
                *index += first;
            }
            Ok(summary)
        })
        .try_reduce(Summary::default, |one, other| Ok(one.and(other)))
}

/// The wanted targets, one after the other.
struct Targets<'a, E>(Vec<(Place, &'a mut [E])>);

impl<'a, E, C: Target<E>> Visitor<'a, C> for Targets<'a, E> {
    fn visit(&mut self, place: Place, there: &'a mut C) {
        if let Some(slice) = there.slice() {
            self.0.push((place, slice));
        }
    }
}

impl<'a, E> Targets<'a, E> {
    /// Splits off the places for the next poses.
    fn split_off(&mut self, count: usize) -> Self {
        let split = |(place, slice): &mut (Place, &'a mut [E])| {
            let (next, rest) = core::mem::take(slice).split_at_mut(count);
            *slice = rest;
            (*place, next)
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
        for (place, slice) in &mut self.0 {
            visitor.visit(*place, slice);
        }
    }
}
