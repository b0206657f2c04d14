//! Interpolation between samples on both sides of a change point, at which values have all their digits.

use num_traits::Float;

use super::line::count;

/// The number of samples that locate a change point.
pub(super) const CROSSING: usize = 10;

/// Samples on both sides of an input, with which a polynomial is interpolated.
pub(super) fn around(s: f64, reach: f64) -> [f64; CROSSING] {
    core::array::from_fn(|index| {
        let part = (count(index) + 0.5) / count(CROSSING);
        s - reach * Float::cos(core::f64::consts::PI * part)
    })
}

/// The value of the polynomial at an input through some points, by Neville's scheme.
pub(super) fn interpolated(samples: &[f64; CROSSING], values: &[f64; CROSSING], at: f64) -> f64 {
    let mut values = *values;
    for distance in 1..CROSSING {
        for low in 0..CROSSING - distance {
            let high = low + distance;
            values[low] = ((at - samples[high]) * values[low] - (at - samples[low]) * values[low + 1])
                / (samples[low] - samples[high]);
        }
    }
    values[0]
}

/// Whether a function that is given at these samples changes its sign between the middle ones, and is small there. A
/// function that jumps is not.
pub(super) fn crosses(values: &[f64; CROSSING]) -> bool {
    const BEFORE: usize = CROSSING / 2 - 1;
    let [before, behind] = [values[BEFORE], values[BEFORE + 1]];
    let least = values[0].abs().min(values[CROSSING - 1].abs());
    before * behind < 0.0 && before.abs().max(behind.abs()) < 0.5 * least
}
