//! The transmission angles of a batch, which are calculated where they are wanted.

use core::cell::Cell;

use num_traits::Float;

use super::destination::{Entries, Stored};
use super::lanes::{Element, Lanes};
use super::view::View;
use crate::mechanism::{Mechanism, Pose};
use crate::number::{Number, Row};
use crate::picture::TransmissionAngle;

/// The columns of the transmission angles, each folded to at most a right angle. `R` is a row with a column for each
/// dyad.
pub(super) struct TransmissionColumns<C, R> {
    pub(super) of_dyads: R,
    /// The column of the smallest of all.
    pub(super) smallest: C,
}

impl<C: Copy, R: AsRef<[C]>> TransmissionColumns<C, R> {
    /// Stores the angles of one pose or several, starting at a given pose. Returns a number that is finite if all of
    /// them are.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn store<T: Angles + Stored<C>>(&self, start: usize, angles: &[TransmissionAngle<T>]) -> T {
        // Adding negative zero changes nothing, which the compiler knows.
        let mut sum = T::constant(-0.0);
        let mut smallest = T::constant(core::f64::consts::FRAC_PI_2);
        for (transmission, column) in angles.iter().zip(self.of_dyads.as_ref()) {
            let folded = transmission.angle.folded();
            sum = sum + folded;
            smallest = folded.or_smaller(smallest);
            folded.store(*column, start);
        }
        smallest.store(self.smallest, start);
        sum
    }
}

impl<'t, E: Element, R: AsRef<[Entries<'t, E>]>> TransmissionColumns<Entries<'t, E>, R> {
    /// The columns of a batch in which no transmission angle is wanted. Those of the dyads are empty.
    pub(super) fn nowhere(of_dyads: R) -> Self {
        Self {
            of_dyads,
            smallest: &[],
        }
    }

    pub(super) fn are_wanted(&self) -> bool {
        !self.smallest.is_empty() || self.of_dyads.as_ref().iter().any(|entries| !entries.is_empty())
    }

    /// Stores NaN for a pose that fails.
    pub(super) fn leave_out(&self, index: usize) {
        for entries in self.of_dyads.as_ref() {
            E::nan().store(*entries, index);
        }
        E::nan().store(self.smallest, index);
    }
}

impl<'t, E: Element, const W: usize, R: AsRef<[View<'t, Cell<E>, W>]>> TransmissionColumns<View<'t, Cell<E>, W>, R> {
    /// Stores NaN for several poses, starting at a given pose: where `gone` is NaN. It is a negative zero for the
    /// others.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn clear<const BITS: usize>(&self, start: usize, gone: Lanes<W, BITS, E>) {
        for view in self.of_dyads.as_ref() {
            view.clear(start, gone);
        }
        self.smallest.clear(start, gone);
    }
}

/// The transmission angles of a declared mechanism in one pose or several.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn angles_at<M: Mechanism>(
    mechanism: &M,
    inputs: &M::Inputs<M::Motion<M::Scalar>>,
    pose: &M::Pose,
) -> M::Dyads<TransmissionAngle<M::Scalar>> {
    let (inputs, unknowns) = (inputs.as_ref(), pose.unknown_motions());
    let unknowns = unknowns.as_ref();
    mechanism.transmission_angles_at(
        Row::from_fn(|input| inputs[input].as_ref()[0]),
        Row::from_fn(|unknown| unknowns[unknown].as_ref()[0]),
    )
}

/// Angles of one pose or several.
pub(super) trait Angles: Number {
    /// An angle in 0 ..= π or its negative, as the smaller of the angle and its supplement. A transmission angle takes
    /// its sign from the first lane, so it may be negative in others.
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

impl<const W: usize, const BITS: usize, E: Element> Angles for Lanes<W, BITS, E> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn folded(self) -> Self {
        Self::from_fn(|lane| self.0[lane].folded())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn or_smaller(self, other: Self) -> Self {
        Self::from_fn(|lane| self.0[lane].or_smaller(other.0[lane]))
    }
}
