//! The summary of one number over many poses.

/// The summary of one number over the poses in which it exists.
///
/// A pose that fails has no number, and is left out. The least and the greatest value carry the index of their pose,
/// the first such pose if there are several.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[non_exhaustive]
pub struct Folded {
    /// The number of poses that count.
    pub count: usize,
    /// The first pose with the least value, and the value.
    pub least: Option<(usize, f64)>,
    /// The first pose with the greatest value, and the value.
    pub greatest: Option<(usize, f64)>,
    /// The sum of all values, 0 if there are none.
    pub sum: f64,
    /// The sum of the squares of all values, 0 if there are none. It is infinite if a square is larger than the largest
    /// number.
    pub sum_of_squares: f64,
}

impl Folded {
    /// The mean of all values.
    #[must_use]
    pub fn mean(&self) -> Option<f64> {
        (self.count > 0).then(|| self.sum / count(self.count))
    }

    /// The root mean square of all values.
    #[must_use]
    pub fn root_mean_square(&self) -> Option<f64> {
        let squares = self.sum_of_squares / count(self.count);
        (self.count > 0).then(|| num_traits::Float::sqrt(squares))
    }

    /// The greatest value minus the least value: the swing of a rocker, the stroke of a slider.
    #[must_use]
    pub fn range(&self) -> Option<f64> {
        let ((_, least), (_, greatest)) = (self.least?, self.greatest?);
        Some(greatest - least)
    }

    /// The value farthest from zero, with its sign, and the first pose that has it.
    #[must_use]
    pub fn peak(&self) -> Option<(usize, f64)> {
        let (least, greatest) = (self.least?, self.greatest?);
        let (down, up) = (-least.1, greatest.1);
        Some(if up > down || (up == down && greatest.0 <= least.0) {
            greatest
        } else {
            least
        })
    }

    /// The summary of these poses and of others that follow them. The others count from zero; `before` is added to
    /// their indices.
    ///
    /// The sums of the two are added. A sum therefore depends, in its last digits, on where poses are divided.
    #[must_use]
    pub fn followed_by(self, others: Self, before: usize) -> Self {
        let moved = |found: (usize, f64)| (found.0 + before, found.1);
        let better = |one: Option<(usize, f64)>, other: Option<(usize, f64)>, is_better: fn(f64, f64) -> bool| match (
            one,
            other.map(moved),
        ) {
            (Some(one), Some(other)) if is_better(other.1, one.1) => Some(other),
            (one, other) => one.or(other),
        };
        Self {
            count: self.count + others.count,
            least: better(self.least, others.least, |other, one| other < one),
            greatest: better(self.greatest, others.greatest, |other, one| other > one),
            sum: self.sum + others.sum,
            sum_of_squares: self.sum_of_squares + others.sum_of_squares,
        }
    }
}

/// A number of poses as a divisor. It is exact up to 2⁵³ poses.
#[expect(clippy::cast_precision_loss, reason = "nobody solves 2⁵³ poses")]
pub(super) const fn count(poses: usize) -> f64 {
    poses as f64
}
