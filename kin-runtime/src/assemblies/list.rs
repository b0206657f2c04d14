//! A list with a fixed capacity.

use core::iter::{Flatten, Take};
use core::ops::{Deref, DerefMut};
use core::{option, slice};

/// The positions that were found, at most `CAPACITY` of them, without allocation.
///
/// It dereferences to a slice. Positions beyond the capacity are counted but not kept.
///
/// ```
/// use kin_core::Positions;
///
/// let mut positions = Positions::<f64, 2>::new();
/// assert!(positions.push(0.5) && positions.push(1.5));
/// assert!(!positions.push(2.5));
/// assert_eq!(*positions, [0.5, 1.5]);
/// assert_eq!(positions.missed(), 1);
/// assert_eq!(positions.into_iter().sum::<f64>(), 2.0);
/// ```
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Positions<P, const CAPACITY: usize> {
    /// The first `length` values are in the list. It is `None` until the first position is added.
    values: Option<[P; CAPACITY]>,
    length: usize,
    missed: usize,
}

impl<P: Copy, const CAPACITY: usize> Positions<P, CAPACITY> {
    /// The empty list.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            values: None,
            length: 0,
            missed: 0,
        }
    }

    /// Adds a position at the end, and returns whether there was room.
    pub fn push(&mut self, position: P) -> bool {
        let values = self.values.get_or_insert([position; CAPACITY]);
        if let Some(slot) = values.get_mut(self.length) {
            *slot = position;
            self.length += 1;
            true
        } else {
            self.missed += 1;
            false
        }
    }
}

impl<P, const CAPACITY: usize> Positions<P, CAPACITY> {
    /// The number of positions that did not fit.
    #[must_use]
    pub const fn missed(&self) -> usize {
        self.missed
    }

    /// The positions.
    #[must_use]
    pub fn as_slice(&self) -> &[P] {
        self.values.as_ref().map_or(&[], |values| &values[..self.length])
    }
}

impl<P: Copy, const CAPACITY: usize> Default for Positions<P, CAPACITY> {
    fn default() -> Self {
        Self::new()
    }
}

impl<P, const CAPACITY: usize> Deref for Positions<P, CAPACITY> {
    type Target = [P];

    fn deref(&self) -> &[P] {
        self.as_slice()
    }
}

impl<P, const CAPACITY: usize> DerefMut for Positions<P, CAPACITY> {
    fn deref_mut(&mut self) -> &mut [P] {
        self.values
            .as_mut()
            .map_or(&mut [], |values| &mut values[..self.length])
    }
}

/// Two lists are equal if their positions are, and if they missed the same number.
impl<P: PartialEq, const CAPACITY: usize> PartialEq for Positions<P, CAPACITY> {
    fn eq(&self, other: &Self) -> bool {
        self.missed == other.missed && self.as_slice() == other.as_slice()
    }
}

impl<P, const CAPACITY: usize> IntoIterator for Positions<P, CAPACITY> {
    type Item = P;
    type IntoIter = Take<Flatten<option::IntoIter<[P; CAPACITY]>>>;

    fn into_iter(self) -> Self::IntoIter {
        self.values.into_iter().flatten().take(self.length)
    }
}

impl<'a, P, const CAPACITY: usize> IntoIterator for &'a Positions<P, CAPACITY> {
    type Item = &'a P;
    type IntoIter = slice::Iter<'a, P>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

#[cfg(test)]
mod tests {
    use super::Positions;

    #[test]
    fn is_a_slice_of_what_was_added() {
        let mut positions = Positions::<u8, 3>::default();
        assert!(positions.is_empty());
        assert_eq!(positions.into_iter().count(), 0);
        for value in 1..=5 {
            assert_eq!(positions.push(value), value <= 3);
            assert!(positions.into_iter().eq(1..=value.min(3)));
            assert!((&positions).into_iter().copied().eq(1..=value.min(3)));
            assert_eq!(positions.last(), Some(&value.min(3)));
        }
        assert_eq!(positions.missed(), 2);
    }

    #[test]
    fn no_room_at_all() {
        let mut positions = Positions::<u8, 0>::new();
        assert!(!positions.push(1));
        assert!(positions.is_empty());
        assert_eq!(positions.missed(), 1);
    }

    #[test]
    fn what_is_no_longer_in_the_list_does_not_count() {
        let (mut first, mut second) = (Positions::<u8, 3>::new(), Positions::<u8, 3>::new());
        first.push(1);
        second.push(1);
        assert_eq!(first, second);
        second.push(2);
        assert_ne!(first, second);
    }
}
