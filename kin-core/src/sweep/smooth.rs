//! What is common to the readers of a sweep between its rows.

use alloc::vec::Vec;

use super::{Course, Local, SmoothDrive};
use crate::mechanism::Mechanism;
use crate::number::Number;

/// A series as a function of another one, by Horner's scheme. The outer series is that at the place where the inner one stands.
pub(crate) fn composed(outer: Local, inner: Local) -> Local {
    let change = inner - Local::constant(inner.real());
    let coefficients = outer.coefficients().into_iter().rev();
    coefficients.fold(Local::constant(0.0), |sum, coefficient| {
        sum * change + Local::constant(coefficient)
    })
}

impl<M: Mechanism<Scalar = f64>, D: SmoothDrive<M>> Course<M, D> {
    /// The joints of laws between two places, in the order from the first to the second.
    pub(crate) fn joints(&self, ends: [f64; 2]) -> Vec<f64> {
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let next = |after: f64| self.drive.next_joint(after).filter(|joint| *joint < high);
        let mut joints: Vec<f64> = core::iter::successors(next(low), |joint| next(*joint)).collect();
        if ends[0] > ends[1] {
            joints.reverse();
        }
        joints
    }
}
