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

    /// The row in which each value is `value`.
    fn splat(value: V) -> Self;
}

impl<V: Copy, const N: usize> Row<V> for [V; N] {
    const LENGTH: usize = N;

    /// `core::array::from_fn` calls five functions that the compiler generates anew for each closure, and there are
    /// thousands of closures. This loop is one.
    #[inline]
    fn from_fn(mut function: impl FnMut(usize) -> V) -> Self {
        if N == 0 {
            return core::array::from_fn(no_value);
        }
        let mut row = [function(0); N];
        let mut index = 1;
        while index < N {
            row[index] = function(index);
            index += 1;
        }
        row
    }

    #[inline]
    fn splat(value: V) -> Self {
        [value; N]
    }
}

/// A value that changes at a constant rate, with its derivatives.
pub(crate) fn at_constant_rate<R: Row<f64>>(value: f64, rate: f64) -> R {
    R::from_fn(|order| match order {
        0 => value,
        1 => rate,
        _ => 0.0,
    })
}

/// The values of an empty row.
fn no_value<V>(_: usize) -> V {
    unreachable!("an empty row has no values")
}
