//! The line of a track, and the position at which the track ends.

use core::cell::RefCell;
use core::ops::Deref;

use crate::curve::{CurveFunctions, LentRows, Way, WayPoint};
use crate::mechanism::Lent;

/// The position at which a track begins, and then the one at which it has ended.
pub(super) struct TrackPosition<'p> {
    pub(super) inputs: &'p mut [f64],
    pub(super) unknowns: &'p mut [f64],
}

/// The line of a track.
pub(super) struct TrackLine<'t> {
    way: Way<'t>,
    /// Where the end of the track is reported.
    position: RefCell<TrackPosition<'t>>,
}

impl<'t> Deref for TrackLine<'t> {
    type Target = Way<'t>;

    fn deref(&self) -> &Way<'t> {
        &self.way
    }
}

impl<'t> TrackLine<'t> {
    /// The line between two points, for unknowns `near` the first one. What the line keeps is taken of the scratch.
    pub(super) fn new(
        mechanism: &'t dyn CurveFunctions,
        parameters: &'t [f64],
        ends: [&'t [f64]; 2],
        near: &[f64],
        lent: Lent<'t>,
        position: TrackPosition<'t>,
    ) -> (Self, LentRows<'t>) {
        let (way, scratch) = Way::new(mechanism, parameters, ends, near, lent);
        let position = RefCell::new(position);
        (Self { way, position }, scratch)
    }

    /// Reports the position where the track has ended.
    pub(super) fn end_at(&self, point: WayPoint<'_>) {
        for (index, input) in self.position.borrow_mut().inputs.iter_mut().enumerate() {
            *input = self.input(point.travel, index);
        }
        self.arrive(point.unknowns);
    }

    /// An input of the position that was reported.
    #[cfg(test)]
    pub(super) fn ended_at(&self, input: usize) -> f64 {
        self.position.borrow().inputs[input]
    }

    /// Reports the unknowns at the end of the track.
    pub(super) fn arrive(&self, unknowns: &[f64]) {
        self.position.borrow_mut().unknowns.copy_from_slice(unknowns);
    }
}
