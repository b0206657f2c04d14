//! The joints where the pieces of a law meet.

use core::fmt;
use core::marker::PhantomData;

use super::piecewise::{Piecewise, of_piece};
use crate::motion::Motion;
use crate::number::Number;
use crate::quantity::{Digits, RATES};

/// Jumps of this many roundings of the size of a piece are none. The formulas of the pieces take some tens of roundings
/// each.
const ROUNDINGS: f64 = 256.0;

/// Times are rounded as often, relative to the duration of the law.
const TIME_ROUNDINGS: f64 = 4.0;

/// The number of samples in a piece at which its derivatives are looked at to know their size.
const SAMPLES: u8 = 8;

/// A joint where two pieces of a law meet, with the motions on both sides.
///
/// A jump counts if it exceeds rounding: 256 roundings of the largest value that the derivative has in either piece,
/// and what it changes within 4 roundings of the law's duration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawJoint<T, const N: usize> {
    /// The time from the start of the law.
    pub time: T,
    /// The motion before it.
    pub left: Motion<T, N>,
    /// The motion after it, which is that of the law at this time.
    pub right: Motion<T, N>,
    /// The rounding of each derivative.
    rounding: [f64; N],
}

impl<T: Number, const N: usize> LawJoint<T, N> {
    /// The jump of the value and of every derivative, from left to right, rounding included.
    #[must_use]
    pub fn jump(&self) -> Motion<T, N> {
        self.right - self.left
    }

    /// The lowest order that jumps, if one below `N` does: 0 for the value, 1 for the velocity, and so on.
    #[must_use]
    pub fn first_jump(&self) -> Option<usize> {
        self.first_jump_from(0)
    }

    /// The lowest order from a given one on that jumps, if one below `N` does.
    pub(crate) fn first_jump_from(&self, lowest: usize) -> Option<usize> {
        let jump = self.jump();
        let mut sizes = jump.as_slice().iter().zip(self.rounding).enumerate().skip(lowest);
        sizes.find_map(|(order, (size, rounding))| (size.real().abs() > rounding).then_some(order))
    }

    /// The highest order up to which the law is continuous here, at most `N - 1`; `None` if the value itself jumps.
    #[must_use]
    pub fn continuity(&self) -> Option<usize> {
        self.first_jump().unwrap_or(N).checked_sub(1)
    }
}

/// For instance `C2 at 2.094395: jerk jumps by 40, snap jumps by -120`.
impl<T: Number, const N: usize> fmt::Display for LawJoint<T, N> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.continuity() {
            Some(order) => write!(formatter, "C{order}")?,
            None => formatter.write_str("not continuous")?,
        }
        write!(formatter, " at {}", Digits(self.time.real()))?;
        let jump = self.jump();
        let jumps = jump.as_slice().iter().zip(self.rounding).enumerate();
        let mut separator = ": ";
        for (order, (size, rounding)) in jumps {
            let size = size.real();
            if size.abs() > rounding {
                formatter.write_str(separator)?;
                match order {
                    0 => formatter.write_str("value")?,
                    // those that have names
                    1..=6 => formatter.write_str(RATES[order - 1])?,
                    _ => write!(formatter, "derivative {order}")?,
                }
                write!(formatter, " jumps by {}", Digits(size))?;
                separator = ", ";
            }
        }
        Ok(())
    }
}

/// The joints of a law in the order of their times: [`Law::joints`](super::Law::joints).
#[derive(Debug)]
pub struct LawJoints<'a, T, L: ?Sized, const N: usize> {
    law: &'a L,
    /// The next piece to look at.
    next: usize,
    /// The piece before the next joint, and whether its end has been reported.
    before: Option<usize>,
    is_over: bool,
    number: PhantomData<T>,
}

impl<'a, T: Number, L: Piecewise<T> + ?Sized, const N: usize> LawJoints<'a, T, L, N> {
    pub(super) const fn new(law: &'a L) -> Self {
        Self {
            law,
            next: 0,
            before: None,
            is_over: false,
            number: PhantomData,
        }
    }

    fn start(&self, piece: usize) -> T {
        match piece.checked_sub(1) {
            Some(before) => self.law.end(before),
            None => T::constant(0.0),
        }
    }

    fn is_empty(&self, piece: usize) -> bool {
        self.law.end(piece).real() <= self.start(piece).real()
    }

    /// The joint between two pieces; no piece is the rest outside of the law.
    fn joint(&self, before: Option<usize>, after: Option<usize>) -> LawJoint<T, N> {
        let time = match (after, before) {
            (Some(piece), _) => self.start(piece),
            (None, Some(piece)) => self.law.end(piece),
            (None, None) => T::constant(0.0),
        };
        let left = before.map(|piece| of_piece::<T, L, N>(self.law, piece, self.law.end(piece)));
        let right = after.map(|piece| of_piece::<T, L, N>(self.law, piece, time));
        let rest = |side: Option<Motion<T, N>>| Motion::constant(side.map_or(T::constant(0.0), |side| side.value()));
        let mut rounding = [0.0; N];
        for piece in before.into_iter().chain(after) {
            self.measure(piece, &mut rounding);
        }
        LawJoint {
            time,
            left: left.unwrap_or_else(|| rest(right)),
            right: right.unwrap_or_else(|| rest(left)),
            rounding: rounding.map(|size| T::EPSILON * size),
        }
    }

    /// Raises the numbers of roundings to those of a piece.
    fn measure(&self, piece: usize, roundings: &mut [f64; N]) {
        let start = self.start(piece);
        let length = self.law.end(piece) - start;
        let mut largest = [0.0_f64; N];
        let mut extremes = [[f64::INFINITY, f64::NEG_INFINITY]; N];
        for sample in 0..=SAMPLES {
            let part = T::constant(f64::from(sample) / f64::from(SAMPLES));
            let motion: Motion<T, N> = of_piece(self.law, piece, start + length * part);
            for (order, entry) in motion.as_slice().iter().enumerate() {
                let value = entry.real();
                largest[order] = largest[order].max(value.abs());
                extremes[order] = [extremes[order][0].min(value), extremes[order][1].max(value)];
            }
        }
        let times = TIME_ROUNDINGS * self.law.duration().real() / length.real();
        for order in 0..N {
            let [low, high] = extremes[order];
            roundings[order] = roundings[order].max(ROUNDINGS * largest[order] + times * (high - low));
        }
    }
}

impl<T: Number, L: Piecewise<T> + ?Sized, const N: usize> Iterator for LawJoints<'_, T, L, N> {
    type Item = LawJoint<T, N>;

    fn next(&mut self) -> Option<LawJoint<T, N>> {
        let count = self.law.pieces();
        while self.next < count && self.is_empty(self.next) {
            self.next += 1;
        }
        if self.next < count {
            let piece = self.next;
            self.next += 1;
            let before = self.before.replace(piece);
            // a law that repeats comes from its last piece
            let before = before.or_else(|| {
                let last = (0..count).rev().find(|&other| !self.is_empty(other));
                last.filter(|_| self.law.repeats())
            });
            return Some(self.joint(before, Some(piece)));
        }
        if self.is_over || self.law.repeats() {
            return None;
        }
        self.is_over = true;
        Some(self.joint(self.before, None))
    }
}
