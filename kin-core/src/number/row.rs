//! Rows of values.

use core::ops::{Index, IndexMut};

/// An array with one value for each of some quantities, read and written by the index of the quantity.
///
/// Arrays and [`Motion`](crate::Motion) implement it. Do not implement it for other types: a new version may add items.
pub trait Row<V>: Copy + AsRef<[V]> + AsMut<[V]> + Index<usize, Output = V> + IndexMut<usize> {
    /// The number of values.
    const LENGTH: usize;

    /// The row of the values `function(index)`.
    fn from_fn(function: impl FnMut(usize) -> V) -> Self;
}

impl<V: Copy, const N: usize> Row<V> for [V; N] {
    const LENGTH: usize = N;

    #[inline]
    fn from_fn(function: impl FnMut(usize) -> V) -> Self {
        core::array::from_fn(function)
    }
}
