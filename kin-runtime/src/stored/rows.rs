//! Arrays of any length, which serde itself stores only up to a length of 32.

use core::array;
use core::fmt;
use core::marker::PhantomData;

use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeTuple, Serializer};

use crate::number::Row;

/// The values of a row, to be written.
pub(super) struct RowValues<'a, T>(pub(super) &'a [T]);

impl<T: Serialize> Serialize for RowValues<'_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut row = serializer.serialize_tuple(self.0.len())?;
        for value in self.0 {
            row.serialize_element(value)?;
        }
        row.end()
    }
}

/// Reads a row. Fewer or more values are an error.
pub(super) fn read<'de, T: Deserialize<'de>, const N: usize, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<[T; N], D::Error> {
    deserializer.deserialize_tuple(N, RowVisitor(PhantomData))
}

struct RowVisitor<T, const N: usize>(PhantomData<T>);

impl<'de, T: Deserialize<'de>, const N: usize> Visitor<'de> for RowVisitor<T, N> {
    type Value = [T; N];

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "a row of {N}")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut row: A) -> Result<[T; N], A::Error> {
        let mut values = array::from_fn(|_| None);
        for (index, slot) in values.iter_mut().enumerate() {
            let value = row
                .next_element()
                .map_err(|error| A::Error::custom(format_args!("[{index}]: {error}")))?;
            *slot = Some(value.ok_or_else(|| A::Error::invalid_length(index, &self))?);
        }
        // A format that reports the length has already refused a longer row, or does so afterwards.
        Ok(values.map(|value| value.expect("every slot has been filled")))
    }
}

/// A row of which every value has been found.
pub(super) fn whole<V: Copy, R: Row<V>>(found: &impl Row<Option<V>>) -> R {
    R::from_fn(|index| found[index].expect("every value has been found"))
}
