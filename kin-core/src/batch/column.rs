//! The columns of parameters and inputs of a batch.

/// One number for each pose of a batch.
///
/// ```
/// use kin_core::batch::Column;
///
/// let angles = [0.1, 0.2, 0.3];
/// assert_eq!(Column::from(&angles).at(1), 0.2);
/// assert_eq!(Column::from(90.0).at(1), 90.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Column<'a> {
    /// The same number for all poses.
    Same(f64),
    /// One number for each pose, as many as there are poses.
    Each(&'a [f64]),
}

/// The value of a parameter in a batch: a number, the same for all poses, or a column.
pub trait Parameter: Copy {
    /// The value as a column.
    fn column(&self) -> Column<'_>;
}

impl Parameter for f64 {
    #[inline]
    fn column(&self) -> Column<'_> {
        Column::Same(*self)
    }
}

impl Parameter for Column<'_> {
    #[inline]
    fn column(&self) -> Column<'_> {
        *self
    }
}

impl Column<'_> {
    /// The number of the pose with this index, NaN if there is none.
    #[inline]
    #[must_use]
    pub fn at(&self, index: usize) -> f64 {
        match self {
            Self::Same(value) => *value,
            Self::Each(values) => values.get(index).copied().unwrap_or(f64::NAN),
        }
    }

    /// The length of the column, if it is fixed.
    pub(super) fn length(&self) -> Option<usize> {
        match self {
            Self::Same(_) => None,
            Self::Each(values) => Some(values.len()),
        }
    }

    /// The part of a column for a range of poses.
    #[cfg(feature = "rayon")]
    pub(super) fn part(self, range: core::ops::Range<usize>) -> Self {
        match self {
            Self::Same(value) => Self::Same(value),
            Self::Each(values) => Self::Each(values.get(range).unwrap_or(&[])),
        }
    }
}

impl From<f64> for Column<'_> {
    fn from(value: f64) -> Self {
        Self::Same(value)
    }
}

impl<'a> From<&'a [f64]> for Column<'a> {
    fn from(values: &'a [f64]) -> Self {
        Self::Each(values)
    }
}

impl<'a, const N: usize> From<&'a [f64; N]> for Column<'a> {
    fn from(values: &'a [f64; N]) -> Self {
        Self::Each(values)
    }
}

#[cfg(feature = "std")]
impl<'a> From<&'a std::vec::Vec<f64>> for Column<'a> {
    fn from(values: &'a std::vec::Vec<f64>) -> Self {
        Self::Each(values)
    }
}
