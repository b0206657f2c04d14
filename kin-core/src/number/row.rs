//! Rows of values.

/// An array of one value for each of some quantities.
pub trait Row<V>: Copy + AsRef<[V]> + AsMut<[V]> {
    /// How many there are.
    const LENGTH: usize;

    /// The values of a function of the index.
    fn from_fn(function: impl FnMut(usize) -> V) -> Self;
}

impl<V: Copy, const N: usize> Row<V> for [V; N] {
    const LENGTH: usize = N;

    #[inline]
    fn from_fn(function: impl FnMut(usize) -> V) -> Self {
        core::array::from_fn(function)
    }
}
