//! The family of laws whose acceleration is sine, constant and cosine.

use core::f64::consts::PI;

use super::LawError;
use super::constant::line;
use super::fourier::add_harmonic;
use crate::number::Number;

/// The number of formulas in the first half of such a law: sine, constant and cosine acceleration, and constant speed.
const FORMULAS: usize = 4;

/// The number of pieces of the whole law: constant speed is its middle.
pub(super) const PIECES: usize = 2 * FORMULAS - 1;

/// A law whose acceleration rises as a quarter of a sine, stays constant, and falls as a quarter of a cosine; then it
/// moves at constant speed, and brakes in the same way.
///
/// The shares of sine, constant and cosine are those of the whole duration, counting acceleration and braking. What
/// they leave is the share of constant speed. Known laws are members of this family:
///
/// | law | sine | constant | cosine |
/// |---|---|---|---|
/// | constant acceleration | 0 | 1 | 0 |
/// | modified trapezoid | 1/4 | 1/2 | 1/4 |
/// | simple harmonic | 0 | 0 | 1 |
/// | modified sine | 1/4 | 0 | 3/4 |
/// | cycloidal | 1/2 | 0 | 1/2 |
/// | trapezoid of the velocity, with a half at constant speed | 0 | 1/2 | 0 |
///
/// Source: R. L. Norton, *Cam Design and Manufacturing Handbook*, Industrial Press, the SCCA family of curves.
///
/// ```
/// use kin_core::law::{Law, Rise, Scca, Shape};
///
/// // a modified sine with a fifth of the time at constant speed
/// let shape = Shape::Scca(Scca::new(0.2, 0.0, 0.6)?);
/// let rise = Rise::new(shape, 0.0, 1.0, 1.0)?;
/// assert_eq!(rise.at::<3>(0.45).acceleration(), 0.0);
/// assert!(Scca::new(0.5, 0.5, 0.5).is_err());
/// # Ok::<(), kin_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scca {
    /// The shares of sine, constant and cosine.
    shares: [f64; 3],
    /// The part of the duration at which each formula ends.
    ends: [f64; FORMULAS],
    /// Displacement and velocity at the start of each formula, for a rise of 1 within the time 1.
    starts: [[f64; 2]; FORMULAS],
    /// The largest acceleration of that rise.
    acceleration: f64,
}

impl Scca {
    /// The modified sine. (C. N. Neklutin, *Mechanisms and Cams for Automatic Machines*, Elsevier 1969.)
    pub const MODIFIED_SINE: Self = Self::of([0.25, 0.0, 0.75]);

    /// The modified trapezoid. (C. N. Neklutin, *Mechanisms and Cams for Automatic Machines*, Elsevier 1969.)
    pub const MODIFIED_TRAPEZOID: Self = Self::of([0.25, 0.5, 0.25]);

    /// The law with the given shares of the duration; the rest is at constant speed.
    ///
    /// # Errors
    /// [`LawError::NotFinite`], or [`LawError::Shares`] if a share is negative or if the sum exceeds 1.
    pub fn new(sine: f64, constant: f64, cosine: f64) -> Result<Self, LawError> {
        let shares = [sine, constant, cosine];
        for share in shares {
            super::error::finite("share of the duration", share)?;
        }
        let least = shares.into_iter().fold(f64::INFINITY, f64::min);
        let sum = sine + constant + cosine;
        // three roundings of shares that are meant to fill the whole
        if least < 0.0 || sum > 1.0 + 3.0 * f64::EPSILON {
            return Err(LawError::Shares { least, sum });
        }
        Ok(Self::of(shares))
    }

    const fn of(shares: [f64; 3]) -> Self {
        let [b, c, d] = shares;
        let sum = b + c + d;
        let is_whole = sum > 1.0 - 3.0 * f64::EPSILON;
        let ends = [0.5 * b, 0.5 * (b + c), if is_whole { 0.5 } else { 0.5 * sum }, 0.5];
        // for the acceleration 1: velocity and displacement at the ends of the formulas
        let v1 = b / PI;
        let s1 = v1 * (0.5 * b - b / PI);
        let v2 = v1 + 0.5 * c;
        let s2 = s1 + 0.5 * c * (v1 + 0.25 * c);
        let v3 = v2 + d / PI;
        let s3 = s2 + 0.5 * d * v2 + (d / PI) * (d / PI);
        let half = s3 + v3 * (0.5 - ends[2]);
        // with constant speed alone, no acceleration reaches it
        let (a, v3) = if sum > 0.0 {
            (0.5 / half, 0.5 * v3 / half)
        } else {
            (0.0, 1.0)
        };
        Self {
            shares,
            ends,
            starts: [[0.0, 0.0], [a * s1, a * v1], [a * s2, a * v2], [a * s3, v3]],
            acceleration: a,
        }
    }

    /// The part of the duration at which a piece ends.
    pub(super) const fn end(&self, piece: usize) -> f64 {
        if piece < FORMULAS - 1 {
            self.ends[piece]
        } else if piece + 1 < PIECES {
            1.0 - self.ends[PIECES - 2 - piece]
        } else {
            1.0
        }
    }

    /// Writes the displacement of a rise by 1 in the time 1, and its derivatives, in the first half.
    pub(super) fn write<T: Number>(&self, piece: usize, part: T, derivatives: &mut [T]) {
        let formula = piece.min(FORMULAS - 1);
        let start = if formula == 0 { 0.0 } else { self.ends[formula - 1] };
        let since = part - T::constant(start);
        let [displacement, velocity] = self.starts[formula].map(T::constant);
        line(displacement.plus_product(velocity, since), velocity, derivatives);
        let acceleration = T::constant(self.acceleration);
        match formula {
            // v = a b/π (1 - cos(π x / b))
            0 => {
                let speed = T::constant(PI / self.shares[0]);
                let amplitude = acceleration / (speed * speed);
                let (sine, cosine) = (speed * since).sin_cos();
                add_line(amplitude * speed, since, derivatives);
                add_harmonic([-(amplitude * sine), -(amplitude * cosine)], speed, derivatives);
            }
            1 => {
                let gain = acceleration * since;
                let terms = [T::constant(0.5) * gain * since, gain, acceleration];
                for (entry, term) in derivatives.iter_mut().zip(terms) {
                    *entry = *entry + term;
                }
            }
            // v = a d/π sin(π x / d)
            2 => {
                let speed = T::constant(PI / self.shares[2]);
                let amplitude = acceleration / (speed * speed);
                let (sine, cosine) = (speed * since).sin_cos();
                if let Some(value) = derivatives.first_mut() {
                    *value = *value + amplitude;
                }
                add_harmonic([-(amplitude * cosine), amplitude * sine], speed, derivatives);
            }
            _ => {}
        }
    }
}

fn add_line<T: Number>(speed: T, since: T, derivatives: &mut [T]) {
    for (entry, term) in derivatives.iter_mut().zip([speed * since, speed]) {
        *entry = *entry + term;
    }
}
