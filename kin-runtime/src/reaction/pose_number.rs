//! Numbers without their derivatives by time: of one pose, or of one that stands for others.

use alloc::vec::Vec;

use crate::number::series::{Series, SeriesOf};
use crate::number::{Changing, Number, singular_values};
use crate::solve::Scalar;

/// A number of a pose. One that stands for others notes what it decides, so that others in which it would be decided
/// otherwise are found alone.
pub(crate) trait PoseNumber: Number {
    /// Whether the number is larger than a part of another one, both without their signs.
    fn exceeds(self, part: f64, other: Self) -> bool;

    /// Whether the number is below zero.
    fn is_negative(self) -> bool;

    /// The number without its sign.
    fn size(self) -> Self;

    /// The larger of two numbers.
    fn or_larger(self, other: Self) -> Self;

    /// Whether the number changes with a dimension, as far as it is known.
    fn changes(self) -> bool {
        false
    }
}

/// A number of one pose alone, which decides by its value.
pub(crate) trait SinglePose: PoseNumber + Scalar {
    /// The length of a vector. Where it passes through zero, it is that behind the zero.
    fn length<const N: usize>(vector: &[SeriesOf<Self, N>]) -> SeriesOf<Self, N>;
}

impl PoseNumber for f64 {
    #[inline]
    fn exceeds(self, part: f64, other: Self) -> bool {
        self.abs() > part * other.abs()
    }

    #[inline]
    fn is_negative(self) -> bool {
        self < 0.0
    }

    #[inline]
    fn size(self) -> Self {
        self.abs()
    }

    #[inline]
    fn or_larger(self, other: Self) -> Self {
        self.max(other)
    }
}

impl SinglePose for f64 {
    fn length<const N: usize>(vector: &[Series<N>]) -> Series<N> {
        let length = singular_values(vector, 1);
        length.first().copied().unwrap_or(Series::ZERO)
    }
}

/// The change is the derivative by a dimension.
impl PoseNumber for Changing<f64> {
    fn exceeds(self, part: f64, other: Self) -> bool {
        self.value.exceeds(part, other.value)
    }

    fn is_negative(self) -> bool {
        self.value < 0.0
    }

    fn size(self) -> Self {
        if self.is_negative() { -self } else { self }
    }

    fn or_larger(self, other: Self) -> Self {
        if other.value > self.value { other } else { self }
    }

    fn changes(self) -> bool {
        self.change != 0.0
    }
}

impl SinglePose for Changing<f64> {
    /// A vector that is zero has no direction, along which its length would change: that change is not finite, unless
    /// the vector does not change either.
    fn length<const N: usize>(vector: &[SeriesOf<Self, N>]) -> SeriesOf<Self, N> {
        let values: Vec<Series<N>> = vector.iter().copied().map(values).collect();
        let length = f64::length(&values);
        let parts = values.into_iter().zip(vector);
        let along = parts.fold(Series::ZERO, |sum, (value, part)| sum + value * changes(*part));
        let change = if along.coefficients() == [0.0; N] && !vector.iter().any(|part| varies(*part)) {
            along
        } else {
            along / length
        };
        with_change(Changing::new(length, change))
    }
}

/// The series of the values.
pub(super) fn values<S: PoseNumber, const N: usize>(series: SeriesOf<S, N>) -> Series<N> {
    Series::from_coefficients(series.coefficients().map(Number::real))
}

/// A series in other numbers, which does not change with a dimension.
pub(super) fn unchanging<S: PoseNumber, const N: usize>(series: Series<N>) -> SeriesOf<S, N> {
    SeriesOf::from_coefficients(series.coefficients().map(S::constant))
}

/// The series of the changes.
pub(super) fn changes<const N: usize>(series: SeriesOf<Changing<f64>, N>) -> Series<N> {
    Series::from_coefficients(series.coefficients().map(|term| term.change))
}

/// A series of numbers that change, from a series and its change.
pub(super) fn with_change<const N: usize>(series: Changing<Series<N>>) -> SeriesOf<Changing<f64>, N> {
    let (value, change) = (series.value.coefficients(), series.change.coefficients());
    SeriesOf::from_coefficients(core::array::from_fn(|term| Changing::new(value[term], change[term])))
}

/// Whether any term changes with a dimension.
fn varies<S: PoseNumber, const N: usize>(series: SeriesOf<S, N>) -> bool {
    series.coefficients().into_iter().any(PoseNumber::changes)
}

/// Whether all terms are zero, and stay so where dimensions change.
pub(super) fn is_nothing<S: PoseNumber, const N: usize>(series: SeriesOf<S, N>) -> bool {
    let mut terms = series.coefficients().into_iter();
    terms.all(|term| term.real() == 0.0 && !term.changes())
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::{Changing, Series, SinglePose as _, changes, values, with_change};
    use crate::number::Number as _;

    type Fourth = Series<4>;

    /// The length of a vector, and its change.
    fn length(vector: [[[f64; 4]; 2]; 2]) -> Changing<Fourth> {
        let parts = vector.map(|part| {
            let [value, change] = part.map(Series::from_coefficients);
            with_change(Changing::new(value, change))
        });
        let length = Changing::<f64>::length(&parts);
        Changing::new(values(length), changes(length))
    }

    /// Where the vector is not zero, the root of the sum of its squares changes alike.
    #[test]
    fn lengths_change_along_their_vectors() {
        let vector = [
            [[3.0, 1.0, -0.5, 0.2], [0.7, 0.0, 0.3, -1.0]],
            [[4.0, -2.0, 0.1, 0.0], [-0.2, 1.5, 0.0, 0.4]],
        ];
        let found = length(vector);
        let square = vector
            .into_iter()
            .fold(Changing::constant(0.0), |sum, [value, change]| {
                let part = Changing::new(Series::from_coefficients(value), Series::from_coefficients(change));
                sum + part * part
            });
        let expected: Changing<Fourth> = square.sqrt();
        for (found, expected) in [(found.value, expected.value), (found.change, expected.change)] {
            let terms: Vec<_> = found.coefficients().into_iter().zip(expected.coefficients()).collect();
            assert!(
                terms.iter().all(|(found, expected)| (found - expected).abs() < 1e-14),
                "{terms:?}"
            );
        }
    }

    #[test]
    fn zeros_change_along_no_vector() {
        let nothing = [0.0; 4];
        let still = length([[nothing; 2]; 2]);
        assert_eq!(
            (still.value.coefficients(), still.change.coefficients()),
            (nothing, nothing)
        );
        let moved = length([[nothing, [1.0, 0.0, 0.0, 0.0]], [nothing; 2]]);
        assert!(moved.value.coefficients() == nothing && !moved.change.is_finite());
    }
}
