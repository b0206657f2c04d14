//! Laws from one rest to another in a given time.

use core::f64::consts::PI;

use super::LawError;
use super::constant::line;
use super::error::{finite, positive};
use super::fourier::add_harmonic;
use super::piecewise::Piecewise;
use super::polynomial::{bernstein, scale};
use super::scca::{self, Scca};
use crate::number::Number;

/// The shape of a [`Rise`].
///
/// Every shape is symmetrical: the second half is the first one rotated about its middle. The peaks are those of a rise
/// by 1 in the time 1; a rise by h in the time T has Cv h/T, Ca h/T², Cj h/T³ and Cs h/T⁴.
///
/// | shape | Cv | Ca | Cj | Cs | first jump beside a dwell |
/// |---|---|---|---|---|---|
/// | constant speed | 1.0000 | 0 | 0 | 0 | velocity |
/// | simple harmonic | 1.5708 | 4.9348 | 15.503 | 48.705 | acceleration |
/// | 3-4-5 | 1.8750 | 5.7735 | 60.000 | 360.00 | jerk |
/// | cycloidal | 2.0000 | 6.2832 | 39.478 | 248.05 | jerk |
/// | modified sine | 1.7596 | 5.5280 | 69.466 | 872.94 | jerk |
/// | modified trapezoid | 2.0000 | 4.8881 | 61.426 | 771.90 | jerk |
/// | 4-5-6-7 | 2.1875 | 7.5132 | 52.500 | 840.00 | snap |
/// | 5-6-7-8-9 | 2.4609 | 9.3720 | 78.750 | 622.53 | fifth derivative |
///
/// Sources: R. L. Norton, *Cam Design and Manufacturing Handbook*, Industrial Press; VDI 2143 Blatt 1.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Shape {
    /// Constant speed.
    ConstantSpeed,
    /// Half a period of a cosine.
    SimpleHarmonic,
    /// A full period of a sine as acceleration.
    Cycloidal,
    /// The polynomial with the powers 3 to 5.
    Polynomial345,
    /// The polynomial with the powers 4 to 7.
    Polynomial4567,
    /// The polynomial with the powers 5 to 9, whose snap is continuous beside a dwell.
    Polynomial56789,
    /// The modified sine.
    ModifiedSine,
    /// The modified trapezoid.
    ModifiedTrapezoid,
    /// Sine, constant and cosine acceleration and constant speed with given shares.
    Scca(Scca),
}

impl Shape {
    /// The shape as a member of the family with several pieces, if it is one.
    const fn pieces(&self) -> Option<&Scca> {
        match self {
            Self::ModifiedSine => Some(&Scca::MODIFIED_SINE),
            Self::ModifiedTrapezoid => Some(&Scca::MODIFIED_TRAPEZOID),
            Self::Scca(scca) => Some(scca),
            _ => None,
        }
    }

    /// Writes the displacement of a rise by 1 in the time 1, and its derivatives, in the first half.
    fn write<T: Number>(&self, piece: usize, part: T, derivatives: &mut [T]) {
        let rest = T::constant(1.0) - part;
        match self {
            Self::ConstantSpeed => line(part, T::constant(1.0), derivatives),
            // sin²(πu/2) has no cancellation near the start, but its derivatives are those of -cos(πu) / 2
            Self::SimpleHarmonic => {
                let (sine, cosine) = (T::constant(PI) * part).sin_cos();
                derivatives.fill(T::constant(0.0));
                let half = T::constant(0.5);
                add_harmonic([-(half * cosine), half * sine], T::constant(PI), derivatives);
                if let Some(value) = derivatives.first_mut() {
                    let (sine, _) = (T::constant(0.5 * PI) * part).sin_cos();
                    *value = sine * sine;
                }
            }
            Self::Cycloidal => {
                let speed = T::constant(2.0 * PI);
                let (sine, cosine) = (speed * part).sin_cos();
                line(part, T::constant(1.0), derivatives);
                add_harmonic([-(sine / speed), -(cosine / speed)], speed, derivatives);
            }
            Self::Polynomial345 => bernstein(step::<T, 6>(), part, rest, derivatives),
            Self::Polynomial4567 => bernstein(step::<T, 8>(), part, rest, derivatives),
            Self::Polynomial56789 => bernstein(step::<T, 10>(), part, rest, derivatives),
            Self::ModifiedSine => Scca::MODIFIED_SINE.write(piece, part, derivatives),
            Self::ModifiedTrapezoid => Scca::MODIFIED_TRAPEZOID.write(piece, part, derivatives),
            Self::Scca(scca) => scca.write(piece, part, derivatives),
        }
    }
}

/// The Bernstein coefficients of the polynomial whose derivatives vanish at both ends: zeros, and as many ones.
fn step<T: Number, const K: usize>() -> [T; K] {
    core::array::from_fn(|index| T::constant(if 2 * index < K { 0.0 } else { 1.0 }))
}

/// A motion from one value to another in a given time, by a [`Shape`]. A return is a rise to a smaller value.
///
/// ```
/// use kin_core::law::{Law, Rise, Shape};
///
/// let back = Rise::new(Shape::Polynomial56789, 30.0, 0.0, 0.5)?;
/// assert_eq!(back.at::<5>(0.0).derivatives(), [30.0, 0.0, 0.0, 0.0, 0.0]);
/// assert_eq!(back.at::<1>(0.5).value(), 0.0);
/// # Ok::<(), kin_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rise<T = f64> {
    shape: Shape,
    from: T,
    to: T,
    duration: T,
}

impl<T: Number> Rise<T> {
    /// The motion from one value to another.
    ///
    /// # Errors
    /// [`LawError::NotFinite`] for the values, [`LawError::NotPositive`] for the duration.
    pub fn new(shape: Shape, from: T, to: T, duration: T) -> Result<Self, LawError> {
        Ok(Self {
            shape,
            from: finite("value from which the rise starts", from)?,
            to: finite("value at which the rise ends", to)?,
            duration: positive("duration of the rise", duration)?,
        })
    }
}

impl<T: Number> Piecewise<T> for Rise<T> {
    fn pieces(&self) -> usize {
        self.shape.pieces().map_or(1, |_| scca::PIECES)
    }

    fn end(&self, piece: usize) -> T {
        self.shape
            .pieces()
            .map_or(self.duration, |scca| self.duration * T::constant(scca.end(piece)))
    }

    /// The second half is computed from the end, so that rounding leaves no gap there.
    fn write(&self, piece: usize, time: T, derivatives: &mut [T]) {
        let count = self.pieces();
        let half = 0.5 * self.duration.real();
        // the middle piece, which may be the only one, belongs to both halves
        let is_second = if 2 * piece + 1 == count {
            time.real() > half
        } else {
            2 * piece >= count
        };
        let lift = self.to - self.from;
        if is_second {
            let part = (self.duration - time) / self.duration;
            self.shape.write(count - 1 - piece, part, derivatives);
            turn_about(self.to, lift, self.duration, derivatives);
        } else {
            self.shape.write(piece, time / self.duration, derivatives);
            scale(derivatives, lift, self.duration);
            if let Some(value) = derivatives.first_mut() {
                *value = *value + self.from;
            }
        }
    }
}

/// The motion that ends at `to`, from its reverse.
fn turn_about<T: Number>(to: T, lift: T, duration: T, derivatives: &mut [T]) {
    scale(derivatives, -lift, -duration);
    if let Some(value) = derivatives.first_mut() {
        *value = *value + to;
    }
}
