//! The transmission angles of a batch, which are calculated where they are wanted.

use num_traits::Float;

use super::destination::{Entries, Stored};
use super::lanes::{Element, Lanes};
use crate::mechanism::{Mechanism, Pose};
use crate::number::{Number, Row};

/// The places of the transmission angles, each folded to at most a right angle.
pub(super) struct TransmissionEntries<'t, M: Mechanism> {
    pub(super) of_dyads: M::Dyads<Entries<'t, M::Scalar>>,
    /// The place of the smallest of all.
    pub(super) smallest: Entries<'t, M::Scalar>,
}

impl<'t, M: Mechanism<Scalar: Element>> TransmissionEntries<'t, M> {
    /// The places of a batch in which no transmission angle is wanted.
    pub(super) fn nowhere() -> Self {
        let nowhere: Entries<'t, M::Scalar> = &[];
        Self {
            of_dyads: Row::splat(nowhere),
            smallest: nowhere,
        }
    }

    fn are_wanted(&self) -> bool {
        !self.smallest.is_empty() || self.of_dyads.as_ref().iter().any(|entries| !entries.is_empty())
    }

    /// Calculates and stores the angles of one pose or several, starting at a given pose, where they are wanted. Returns a number
    /// that is finite if all of them are.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn store<T: Mechanism<Scalar: Angles<Element = M::Scalar>>>(
        &self,
        start: usize,
        mechanism: &T,
        inputs: &T::Inputs<T::Motion<T::Scalar>>,
        pose: &T::Pose,
    ) -> T::Scalar {
        // Adding negative zero changes nothing, which the compiler knows.
        let mut sum = T::Scalar::constant(-0.0);
        if !self.are_wanted() {
            return sum;
        }
        let (inputs, unknowns) = (inputs.as_ref(), pose.unknown_motions());
        let unknowns = unknowns.as_ref();
        let angles = mechanism.transmission_angles_at(
            Row::from_fn(|input| inputs[input].as_ref()[0]),
            Row::from_fn(|unknown| unknowns[unknown].as_ref()[0]),
        );
        let mut smallest = T::Scalar::constant(core::f64::consts::FRAC_PI_2);
        for (transmission, entries) in angles.as_ref().iter().zip(self.of_dyads.as_ref()) {
            let folded = transmission.angle.folded();
            sum = sum + folded;
            smallest = folded.or_smaller(smallest);
            folded.store(entries, start);
        }
        smallest.store(self.smallest, start);
        sum
    }

    /// Stores NaN for a pose that fails.
    pub(super) fn leave_out(&self, index: usize) {
        for entries in self.of_dyads.as_ref() {
            M::Scalar::nan().store(entries, index);
        }
        M::Scalar::nan().store(self.smallest, index);
    }

    /// Stores NaN for several poses, starting at a given pose: where `gone` is NaN. It is zero for the others.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn clear<const W: usize, const FUSED: bool>(&self, start: usize, gone: Lanes<W, FUSED, M::Scalar>) {
        for entries in self.of_dyads.as_ref() {
            take_away(gone, entries, start);
        }
        take_away(gone, self.smallest, start);
    }
}

/// Takes numbers away from what is stored, starting at a given pose.
#[cfg_attr(not(debug_assertions), inline(always))]
fn take_away<const W: usize, const FUSED: bool, E: Element>(
    gone: Lanes<W, FUSED, E>,
    entries: Entries<'_, E>,
    start: usize,
) {
    if let Some(places) = entries.get(start..start + W) {
        let numbers = Lanes::<W, FUSED, E>::from_fn(|lane| places[lane].get());
        (numbers - gone).store(entries, start);
    }
}

/// Angles of one pose or several.
pub(super) trait Angles: Number + Stored {
    /// An angle in 0 ..= π or its negative, as the smaller of the angle and its supplement. A transmission angle takes its
    /// sign from the first lane, so it may be negative in others.
    fn folded(self) -> Self;

    /// The smaller of this number and another.
    fn or_smaller(self, other: Self) -> Self;
}

impl<E: Element> Angles for E {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn folded(self) -> Self {
        let angle = Float::abs(self);
        angle.or_smaller(E::of(core::f64::consts::PI) - angle)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn or_smaller(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
}

impl<const W: usize, const FUSED: bool, E: Element> Angles for Lanes<W, FUSED, E> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn folded(self) -> Self {
        Self::from_fn(|lane| self.0[lane].folded())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn or_smaller(self, other: Self) -> Self {
        Self::from_fn(|lane| self.0[lane].or_smaller(other.0[lane]))
    }
}
