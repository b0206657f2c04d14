//! The low-discrepancy sequence `R_d`.

/// The largest number of dimensions of a [`Sequence`].
pub const MOST_DIMENSIONS: usize = 64;

/// The sequence `R_d` in some number of dimensions, calculated in integers: the same in every process, and exact to
/// 10⁻⁶ for ids up to 10¹².
///
/// ```
/// use kin_search::candidates::Sequence;
///
/// let sequence = Sequence::new(2).expect("at most 64 dimensions");
/// assert!((sequence.coordinate(1, 0) - 0.254_877_666_246_693).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sequence {
    dimensions: usize,
    /// α as a multiple of 2⁻⁶⁴.
    alpha: u64,
}

/// The product of two numbers below 1, as multiples of 2⁻⁶⁴.
const fn product(one: u64, other: u64) -> u64 {
    #[allow(clippy::cast_possible_truncation, reason = "the product is below 2⁶⁴")]
    {
        ((one as u128 * other as u128) >> 64) as u64
    }
}

const fn power(base: u64, exponent: usize) -> u64 {
    let (mut result, mut count) = (base, 1);
    while count < exponent {
        result = product(result, base);
        count += 1;
    }
    result
}

impl Sequence {
    /// The sequence in 1 to [`MOST_DIMENSIONS`] dimensions.
    #[must_use]
    pub const fn new(dimensions: usize) -> Option<Self> {
        if dimensions == 0 || dimensions > MOST_DIMENSIONS {
            return None;
        }
        // α^d (1 + α) = 1 has one root in 1/2 .. 1, since the left side rises: it is found bit by bit.
        let mut alpha: u64 = 0;
        let mut bit = 1 << 63;
        while bit > 0 {
            let trial = alpha | bit;
            let power = power(trial, dimensions);
            if power.checked_add(product(power, trial)).is_some() {
                alpha = trial;
            }
            bit >>= 1;
        }
        Some(Self { dimensions, alpha })
    }

    /// The number of dimensions.
    #[must_use]
    pub const fn dimensions(&self) -> usize {
        self.dimensions
    }

    /// By how much a coordinate grows from point to point, as a multiple of 2⁻⁶⁴. Coordinates count from 0.
    #[must_use]
    pub(crate) const fn step(&self, coordinate: usize) -> u64 {
        power(self.alpha, coordinate + 1)
    }

    /// A coordinate of a point, above 0 and below 1. Coordinates count from 0.
    #[must_use]
    pub const fn coordinate(&self, id: u64, coordinate: usize) -> f64 {
        at(id, self.step(coordinate))
    }
}

/// The coordinate of a point, by the step from point to point.
pub(crate) const fn at(id: u64, step: u64) -> f64 {
    let bits = (id.wrapping_mul(step)).wrapping_add(1 << 63) >> 11;
    #[expect(clippy::cast_precision_loss, reason = "53 bits are exact")]
    let whole = bits as f64;
    // Half a unit keeps the coordinate above 0, but would raise the largest number to 1.
    let value = (whole + 0.5) * (1.0 / 9_007_199_254_740_992.0);
    if value < 1.0 { value } else { 1.0 - f64::EPSILON / 2.0 }
}

#[cfg(test)]
mod tests {
    use super::{MOST_DIMENSIONS, Sequence};

    #[test]
    fn first_steps_are_powers_of_golden_ratios() {
        // the golden ratio, the plastic number, and the root of x⁴ = x + 1
        for (dimensions, root) in [
            (1, 1.618_033_988_749_895_f64),
            (2, 1.324_717_957_244_746),
            (3, 1.220_744_084_605_759_5),
        ] {
            let sequence = Sequence::new(dimensions).unwrap();
            for coordinate in 0..dimensions {
                let step = root.powi(-i32::try_from(coordinate + 1).unwrap());
                let found = sequence.coordinate(1, coordinate);
                // the first point is one half and one step from zero
                assert!(
                    (found - (0.5 + step).fract()).abs() < 4.0 * f64::EPSILON,
                    "{dimensions} {coordinate}"
                );
            }
        }
    }

    #[test]
    fn every_coordinate_lies_inside_for_the_largest_ids() {
        let sequence = Sequence::new(MOST_DIMENSIONS).unwrap();
        for id in [0, 1, u64::MAX / 2, u64::MAX] {
            for coordinate in 0..MOST_DIMENSIONS {
                let found = sequence.coordinate(id, coordinate);
                assert!(0.0 < found && found < 1.0);
            }
        }
        assert_eq!(Sequence::new(0), None);
        assert_eq!(Sequence::new(MOST_DIMENSIONS + 1), None);
    }

    /// The star discrepancy of a sequence on a line, by its formula over the sorted points (H. Niederreiter, Random
    /// Number Generation and Quasi-Monte Carlo Methods, theorem 2.6).
    #[test]
    fn points_on_a_line_are_more_even_than_random_ones() {
        // a quarter of the mean of random points, 0.869/√N, that of Kolmogorov's distribution
        const LIMIT: f64 = 0.25 * 0.869;
        for dimensions in 1..=6 {
            let sequence = Sequence::new(dimensions).unwrap();
            for coordinate in 0..dimensions {
                for first in [0, 1_000_000_000_000] {
                    let count = 10_000_u32;
                    let mut points: Vec<f64> = (0..u64::from(count))
                        .map(|id| sequence.coordinate(first + id, coordinate))
                        .collect();
                    points.sort_by(f64::total_cmp);
                    let n = f64::from(count);
                    let discrepancy = points.iter().zip(0_u32..).fold(0.5 / n, |worst: f64, (point, index)| {
                        worst.max(0.5 / n + (point - (f64::from(index) + 0.5) / n).abs())
                    });
                    assert!(
                        discrepancy < LIMIT / n.sqrt(),
                        "{dimensions} {coordinate} {first}: {discrepancy}"
                    );
                }
            }
        }
    }

    /// The largest error of the share of points in a box with a corner at the origin, over a grid of such boxes.
    #[test]
    fn points_in_a_box_are_more_even_than_random_ones() {
        let grid = 12_u32;
        for dimensions in 2..=4 {
            let sequence = Sequence::new(dimensions).unwrap();
            let count = 4096_u32;
            let points: Vec<Vec<f64>> = (0..u64::from(count))
                .map(|id| {
                    (0..dimensions)
                        .map(|coordinate| sequence.coordinate(id, coordinate))
                        .collect()
                })
                .collect();
            let mut worst: f64 = 0.0;
            for corner in 0..grid.pow(u32::try_from(dimensions).unwrap()) {
                let mut rest = corner;
                let ends: Vec<f64> = (0..dimensions)
                    .map(|_| {
                        let end = f64::from(rest % grid + 1) / f64::from(grid);
                        rest /= grid;
                        end
                    })
                    .collect();
                let inside = points
                    .iter()
                    .filter(|point| point.iter().zip(&ends).all(|(value, end)| value < end))
                    .count();
                let share = f64::from(u32::try_from(inside).unwrap()) / f64::from(count);
                worst = worst.max((share - ends.iter().product::<f64>()).abs());
            }
            // Random points have 0.67/√N to 1.6/√N in these dimensions, by trial.
            assert!(worst < 0.55 / f64::from(count).sqrt(), "{dimensions}: {worst}");
        }
    }
}
