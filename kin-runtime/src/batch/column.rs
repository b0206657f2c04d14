//! The columns of parameters and inputs of a batch.

use crate::batch::lanes::Element;

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
pub enum Column<'a, T = f64> {
    /// The same number for all poses.
    Same(T),
    /// One number for each pose, as many as there are poses.
    Each(&'a [T]),
}

/// The value of a parameter in a batch: a number, the same for all poses, or a column.
pub trait Parameter: Copy {
    /// The precision.
    type Element: Element;

    /// The value as a column.
    fn column(&self) -> Column<'_, Self::Element>;
}

impl<T: Element> Parameter for T {
    type Element = T;

    #[inline]
    fn column(&self) -> Column<'_, T> {
        Column::Same(*self)
    }
}

impl<T: Element> Parameter for Column<'_, T> {
    type Element = T;

    #[inline]
    fn column(&self) -> Column<'_, T> {
        *self
    }
}

impl<T: Element> Column<'_, T> {
    /// The number of the pose with this index, NaN if there is none.
    #[inline]
    #[must_use]
    pub fn at(&self, index: usize) -> T {
        match self {
            Self::Same(value) => *value,
            Self::Each(values) => values.get(index).copied().unwrap_or(T::nan()),
        }
    }

    /// The length of the column, if it is fixed.
    pub(crate) fn length(&self) -> Option<usize> {
        match self {
            Self::Same(_) => None,
            Self::Each(values) => Some(values.len()),
        }
    }

    /// The part of a column for a range of poses; without numbers if the column ends before.
    #[must_use]
    pub fn part(self, range: core::ops::Range<usize>) -> Self {
        match self {
            Self::Same(value) => Self::Same(value),
            Self::Each(values) => Self::Each(values.get(range).unwrap_or(&[])),
        }
    }
}

impl<T: Element> From<T> for Column<'_, T> {
    fn from(value: T) -> Self {
        Self::Same(value)
    }
}

impl<'a, T> From<&'a [T]> for Column<'a, T> {
    fn from(values: &'a [T]) -> Self {
        Self::Each(values)
    }
}

impl<'a, T, const N: usize> From<&'a [T; N]> for Column<'a, T> {
    fn from(values: &'a [T; N]) -> Self {
        Self::Each(values)
    }
}

#[cfg(feature = "std")]
impl<'a, T> From<&'a std::vec::Vec<T>> for Column<'a, T> {
    fn from(values: &'a std::vec::Vec<T>) -> Self {
        Self::Each(values)
    }
}
