//! Rows of numbers whose length is known when the program runs.

use alloc::vec::Vec;
use core::ops::{Deref, DerefMut};

/// The numbers that are kept without memory on the heap.
const INLINE: usize = 8;

/// A number for each of some quantities of a mechanism without its type. Most mechanisms have few, for which nothing is
/// allocated.
#[derive(Clone, Debug)]
pub(crate) enum NumberRow {
    /// The first `count` of these numbers.
    Inline {
        count: usize,
        values: [f64; INLINE],
    },
    Allocated(Vec<f64>),
}

impl NumberRow {
    /// As many values of `function(index)`.
    pub(crate) fn from_fn(count: usize, mut function: impl FnMut(usize) -> f64) -> Self {
        if count > INLINE {
            return Self::Allocated((0..count).map(function).collect());
        }
        let mut values = [0.0; INLINE];
        for (index, value) in values.iter_mut().enumerate().take(count) {
            *value = function(index);
        }
        Self::Inline { count, values }
    }

    /// As many times the same value.
    pub(crate) fn splat(count: usize, value: f64) -> Self {
        Self::from_fn(count, |_| value)
    }
}

impl From<&[f64]> for NumberRow {
    fn from(values: &[f64]) -> Self {
        Self::from_fn(values.len(), |index| values[index])
    }
}

impl Deref for NumberRow {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        match self {
            Self::Inline { count, values } => &values[..*count],
            Self::Allocated(values) => values,
        }
    }
}

impl DerefMut for NumberRow {
    fn deref_mut(&mut self) -> &mut [f64] {
        match self {
            Self::Inline { count, values } => &mut values[..*count],
            Self::Allocated(values) => values,
        }
    }
}
