//! The value and the derivatives of a motion one after the other, and their text.

use core::{array, fmt, slice};

use super::Motion;

impl<T, const N: usize> Motion<T, N> {
    /// An iterator over the value and the derivatives in ascending order.
    ///
    /// ```
    /// use kin_core::Motion;
    ///
    /// let crank = Motion::from([0.5, -10.0, 2.0]);
    /// assert_eq!(crank.iter().copied().fold(0.0, f64::max), 2.0);
    /// for (order, derivative) in crank.into_iter().enumerate() {
    ///     assert_eq!(crank[order], derivative);
    /// }
    /// ```
    pub fn iter(&self) -> slice::Iter<'_, T> {
        self.derivatives.iter()
    }
}

/// The value and its derivatives in ascending order.
impl<T, const N: usize> IntoIterator for Motion<T, N> {
    type Item = T;
    type IntoIter = array::IntoIter<T, N>;

    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.derivatives.into_iter()
    }
}

/// The value and its derivatives in ascending order.
impl<'a, T, const N: usize> IntoIterator for &'a Motion<T, N> {
    type Item = &'a T;
    type IntoIter = slice::Iter<'a, T>;

    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// The value, and in brackets its derivatives in ascending order. Precision, width and sign apply to each of them.
///
/// ```
/// use kin_core::Motion;
///
/// let crank = Motion::from([0.5, -10.0, 2.25]);
/// assert_eq!(crank.to_string(), "0.5 [-10, 2.25]");
/// assert_eq!(format!("{crank:.1}"), "0.5 [-10.0, 2.2]");
/// assert_eq!(Motion::from([0.5]).to_string(), "0.5");
/// ```
impl<T: fmt::Display, const N: usize> fmt::Display for Motion<T, N> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (order, entry) in self.iter().enumerate() {
            formatter.write_str(match order {
                0 => "",
                1 => " [",
                _ => ", ",
            })?;
            entry.fmt(formatter)?;
        }
        formatter.write_str(if N > 1 { "]" } else { "" })
    }
}
