//! A sweep as an iterator of poses.

use alloc::vec::Vec;
use core::mem::take;

use super::untyped::UntypedSweep;
use super::walk::Walk;
use super::{Drive, InputMotions, Sweep};
use crate::any::{motions, row};
use crate::failure::SolveError;
use crate::mechanism::{Mechanism, Pose};

/// The poses of a sweep, one after the other, as [`Sweep::rows`] returns them.
#[derive(Clone)]
pub struct Rows<'s, M: Mechanism<Scalar = f64>, D> {
    typed: &'s Sweep<M, D>,
    sweep: UntypedSweep<'s>,
    walk: Walk<'s>,
    /// The motions of the inputs in the row, whose memory is used again.
    given: Vec<f64>,
    next: usize,
}

impl<'s, M: Mechanism<Scalar = f64>, D: Drive> Rows<'s, M, D> {
    pub(super) fn new(typed: &'s Sweep<M, D>) -> Self {
        Self {
            typed,
            sweep: typed.any(),
            walk: Walk::BEGINNING,
            given: Vec::new(),
            next: 0,
        }
    }
}

impl<M: Mechanism<Scalar = f64>, D: Drive> Iterator for Rows<'_, M, D> {
    type Item = Result<M::Pose, SolveError>;

    fn next(&mut self) -> Option<Self::Item> {
        let (typed, sweep, walk) = (self.typed, &self.sweep, &mut self.walk);
        if self.next >= typed.count {
            return None;
        }
        let at = typed.at(self.next);
        self.next += 1;
        let orders = sweep.orders();
        self.given.resize(sweep.description.inputs.len() * orders, 0.0);
        sweep.drive.motions(at, orders, &mut self.given);
        let motions: InputMotions<M, f64> = motions(&self.given);
        // The walk decides which position it is. As a rule it is that of the assembly, whose pose the walk then needs
        // not solve again.
        let mut known = None;
        if sweep.has_assemblies() || walk.last.is_none() {
            known = typed.mechanism.solve(motions, typed.assembly).ok();
        }
        walk.known = known.map(|pose| {
            let mut numbers = take(&mut walk.spare);
            numbers.clear();
            numbers.extend_from_slice(&self.given);
            for motion in pose.unknown_motions().as_ref() {
                numbers.extend_from_slice(motion.as_ref());
            }
            for motion in pose.output_motions().as_ref() {
                numbers.extend_from_slice(motion.as_ref());
            }
            (at, numbers)
        });
        let near = match walk.step(sweep, at, &self.given) {
            Ok(footing) => footing.near.as_deref(),
            Err(error) => return Some(Err(error)),
        };
        Some(match (near, known) {
            (None, Some(pose)) => Ok(pose),
            (None, None) => typed.mechanism.solve(motions, typed.assembly),
            (Some(near), _) => typed.mechanism.solve_near(motions, row(near)),
        })
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let rest = self.typed.count - self.next;
        (rest, Some(rest))
    }
}

impl<M: Mechanism<Scalar = f64>, D: Drive> ExactSizeIterator for Rows<'_, M, D> {}
