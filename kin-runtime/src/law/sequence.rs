//! Laws one after the other.

#[cfg(feature = "alloc")]
use alloc::boxed::Box;
#[cfg(feature = "alloc")]
use alloc::vec::Vec;

use super::LawError;
use super::error::positive;
use super::piecewise::{Piecewise, Side};
use crate::number::Number;

/// Laws one after the other, over time or over a driving angle.
///
/// A law that repeats takes part with one cycle. Each law states its values; [`Law::joints`](super::Law::joints) says
/// where they do not fit together.
///
/// ```
/// use kin_core::law::{Dwell, Law, Rise, Sequence, Shape};
///
/// // a cam: 30 mm up within 120 degrees, 60 degrees of dwell, down within 180 degrees
/// let [first, dwell, last] = [120.0_f64, 60.0, 180.0].map(f64::to_radians);
/// let up = Rise::new(Shape::ModifiedTrapezoid, 0.0, 30.0, first)?;
/// let high = Dwell::new(30.0, dwell)?;
/// let down = Rise::new(Shape::Cycloidal, 30.0, 0.0, last)?;
/// let cam = Sequence::new([&up, &high, &down])?.repeated();
/// assert_eq!(cam.at::<1>(-0.5 * last).value(), 15.0);
/// # Ok::<(), kin_core::law::LawError>(())
/// ```
#[derive(Clone, Copy)]
pub struct Sequence<L> {
    laws: L,
}

/// Laws in a row. Do not implement it: a new version may add items.
pub trait LawRow<T: Number> {
    /// The laws in the order of their times.
    fn laws(&self) -> impl Iterator<Item = &dyn Piecewise<T>>;
}

impl<T: Number, const K: usize> LawRow<T> for [&dyn Piecewise<T>; K] {
    fn laws(&self) -> impl Iterator<Item = &dyn Piecewise<T>> {
        self.iter().copied()
    }
}

#[cfg(feature = "alloc")]
impl<T: Number> LawRow<T> for Vec<Box<dyn Piecewise<T>>> {
    fn laws(&self) -> impl Iterator<Item = &dyn Piecewise<T>> {
        self.iter().map(|law| &**law)
    }
}

impl<'a, T: Number, const K: usize> Sequence<[&'a dyn Piecewise<T>; K]> {
    /// The laws in the order of their times.
    ///
    /// # Errors
    /// [`LawError::Empty`] without laws, [`LawError::NotPositive`] if the duration of one is not positive.
    pub fn new(laws: [&'a dyn Piecewise<T>; K]) -> Result<Self, LawError> {
        Self::checked(laws)
    }
}

#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
impl<T: Number> Sequence<Vec<Box<dyn Piecewise<T>>>> {
    /// As many laws as a program has read.
    ///
    /// # Errors
    /// As for [`new`](Sequence::new).
    pub fn of_boxes(laws: Vec<Box<dyn Piecewise<T>>>) -> Result<Self, LawError> {
        Self::checked(laws)
    }
}

impl<L> Sequence<L> {
    fn checked<T: Number>(laws: L) -> Result<Self, LawError>
    where
        L: LawRow<T>,
    {
        if laws.laws().next().is_none() {
            return Err(LawError::Empty);
        }
        for law in laws.laws() {
            positive("duration of a law in a sequence", law.duration())?;
        }
        Ok(Self { laws })
    }

    /// The law to which a piece belongs, its number there, and the time at which that law starts.
    fn owner<T: Number>(&self, piece: usize) -> Option<(&dyn Piecewise<T>, usize, T)>
    where
        L: LawRow<T>,
    {
        let mut start = T::constant(0.0);
        let (mut piece_of_law, mut owner) = (piece, None);
        for law in self.laws.laws() {
            owner = Some((law, piece_of_law, start));
            let count = law.pieces();
            if piece_of_law < count {
                break;
            }
            piece_of_law -= count;
            start = start + law.duration();
        }
        owner
    }
}

impl<T: Number, L: LawRow<T>> Piecewise<T> for Sequence<L> {
    fn pieces(&self) -> usize {
        self.laws.laws().map(Piecewise::pieces).sum()
    }

    fn end(&self, piece: usize) -> T {
        let owner = self.owner(piece);
        owner.map_or(T::constant(0.0), |(law, piece_of_law, start)| {
            start + law.end(piece_of_law)
        })
    }

    fn write(&self, piece: usize, time: T, derivatives: &mut [T]) {
        if let Some((law, piece_of_law, start)) = self.owner(piece) {
            law.write(piece_of_law, time - start, derivatives);
        }
    }

    fn duration(&self) -> T {
        let laws = self.laws.laws();
        laws.fold(T::constant(0.0), |sum, law| sum + law.duration())
    }

    fn piece(&self, time: f64, side: Side) -> usize {
        let (mut before, mut start) = (0, T::constant(0.0));
        let mut found = 0;
        for (index, law) in self.laws.laws().enumerate() {
            let begin = start.real();
            if index > 0 && !(begin < time || (begin == time && side == Side::Right)) {
                break;
            }
            found = before + law.piece(time - begin, side);
            before += law.pieces();
            start = start + law.duration();
        }
        found
    }
}
