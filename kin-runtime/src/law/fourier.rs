//! Sums of harmonics.

use core::f64::consts::TAU;

use super::LawError;
use super::error::{finite, positive};
use super::piecewise::Piecewise;
use crate::number::Number;

/// A Fourier series with `K` harmonics, which repeats with its period.
///
/// ```
/// use kin_core::law::{Fourier, Law};
///
/// // 5 + 2 cos ωt + sin 2ωt with a period of 0.5
/// let law = Fourier::new(5.0, [[2.0, 0.0], [0.0, 1.0]], 0.5)?;
/// assert_eq!(law.at::<1>(0.0).value(), 7.0);
/// assert_eq!(law.at::<1>(0.5).value(), 7.0);
/// # Ok::<(), kin_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fourier<T, const K: usize> {
    mean: T,
    harmonics: [[T; 2]; K],
    period: T,
}

impl<T: Number, const K: usize> Fourier<T, K> {
    /// The sum of the mean and of `a cos kωt + b sin kωt` for each `[a, b]` of the harmonics k = 1, 2, …, with ω = 2π /
    /// period.
    ///
    /// # Errors
    /// [`LawError::NotFinite`] for mean and harmonics, [`LawError::NotPositive`] for the period.
    pub fn new(mean: T, harmonics: [[T; 2]; K], period: T) -> Result<Self, LawError> {
        finite("mean of the Fourier series", mean)?;
        for amplitude in harmonics.as_flattened() {
            finite("amplitude of a harmonic", *amplitude)?;
        }
        positive("period of the Fourier series", period)?;
        Ok(Self {
            mean,
            harmonics,
            period,
        })
    }
}

impl<T: Number, const K: usize> Piecewise<T> for Fourier<T, K> {
    fn end(&self, _: usize) -> T {
        self.period
    }

    fn write(&self, _: usize, time: T, derivatives: &mut [T]) {
        derivatives.fill(T::constant(0.0));
        let speed = T::constant(TAU) / self.period;
        let mut multiple = T::constant(0.0);
        for [cosine, sine] in self.harmonics {
            multiple = multiple + speed;
            let (sine_there, cosine_there) = (multiple * time).sin_cos();
            let value = cosine * cosine_there + sine * sine_there;
            let quarter_later = sine * cosine_there - cosine * sine_there;
            add_harmonic([value, quarter_later], multiple, derivatives);
        }
        if let Some(value) = derivatives.first_mut() {
            *value = *value + self.mean;
        }
    }

    fn repeats(&self) -> bool {
        true
    }
}

/// Adds a harmonic and its derivatives, from its value and its value a quarter of a period later: each derivative is
/// `speed` times the value a quarter of a period later.
pub(super) fn add_harmonic<T: Number>(values: [T; 2], speed: T, derivatives: &mut [T]) {
    let [mut value, mut later] = values;
    let mut factor = T::constant(1.0);
    for entry in derivatives {
        *entry = *entry + value * factor;
        (value, later) = (later, -value);
        factor = factor * speed;
    }
}
