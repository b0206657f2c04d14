//! Interpolation between places on both sides of a change point, at which values have all their digits.

use num_traits::Float;

use super::line::count;

/// The number of places that locate a change point.
pub(super) const CROSSING: usize = 10;

/// Places on both sides of another one, with which a polynomial is interpolated.
pub(super) fn around(s: f64, reach: f64) -> [f64; CROSSING] {
    core::array::from_fn(|place| {
        let part = (count(place) + 0.5) / count(CROSSING);
        s - reach * Float::cos(core::f64::consts::PI * part)
    })
}

/// The value at a place of the polynomial through some points, by Neville's scheme.
pub(super) fn interpolated(places: &[f64; CROSSING], values: &[f64; CROSSING], at: f64) -> f64 {
    let mut values = *values;
    for distance in 1..CROSSING {
        for low in 0..CROSSING - distance {
            let high = low + distance;
            values[low] = ((at - places[high]) * values[low] - (at - places[low]) * values[low + 1])
                / (places[low] - places[high]);
        }
    }
    values[0]
}
