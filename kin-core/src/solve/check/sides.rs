//! The check that values of the unknowns lie on the same sides of the singular positions.

use crate::solve::Scalar;
use crate::solve::check::{Check, Real};
use crate::solve::doubt;

/// Whether the orientations of a pose are certain and equal those of the leading pose.
#[derive(Clone, Copy)]
pub(in crate::solve) struct SameSides<T, const K: usize> {
    pub(in crate::solve) orientations: [T; K],
    /// Whether each orientation of the leading pose is positive or zero.
    pub(in crate::solve) leading: [bool; K],
}

impl<T: Scalar, const K: usize> Check<T, K, 2> for SameSides<T, K> {
    fn name(&self) -> &'static str {
        "assembly of the values nearby"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; K] {
        self.orientations
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, orientations: [R; K]) -> [R::Truth; 2] {
        let (mut is_told, mut agrees) = (R::certainly(true), R::certainly(true));
        for (orientation, is_positive) in orientations.into_iter().zip(self.leading) {
            // NaN does not equal itself.
            is_told = R::both(is_told, || orientation.equals(orientation));
            let own = orientation.is_at_least(R::of(0.0));
            agrees = R::both(agrees, || if is_positive { own } else { R::not(own) });
        }
        [is_told, agrees]
    }

    /// The smallest orientation.
    fn margin(&self) -> T {
        let own = self.orientations.into_iter().zip(self.leading);
        let own = own.map(|(orientation, is_positive)| if is_positive { orientation } else { -orientation });
        own.reduce(doubt::smaller).unwrap_or_else(|| T::constant(f64::INFINITY))
    }
}
