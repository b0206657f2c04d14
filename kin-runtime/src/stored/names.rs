//! The names of quantities, as the keys of maps.

use core::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, Unexpected, Visitor};

/// Names, separated by commas.
pub(super) fn list<'a>(names: impl Iterator<Item = &'a str>, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
    for (index, name) in names.enumerate() {
        let before = if index == 0 { "" } else { ", " };
        write!(formatter, "{before}`{name}`")?;
    }
    Ok(())
}

/// The index of a name, where the function gives the name of each index.
pub(super) struct IndexedName<F>(pub(super) F);

impl<'de, F: Fn(usize) -> Option<&'static str>> DeserializeSeed<'de> for IndexedName<F> {
    type Value = usize;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<usize, D::Error> {
        deserializer.deserialize_str(self)
    }
}

impl<F: Fn(usize) -> Option<&'static str>> IndexedName<F> {
    fn all(&self) -> impl Iterator<Item = &'static str> {
        (0..).map_while(&self.0)
    }
}

impl<F: Fn(usize) -> Option<&'static str>> Visitor<'_> for IndexedName<F> {
    type Value = usize;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("one of the names ")?;
        list(self.all(), formatter)
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<usize, E> {
        self.all()
            .position(|name| name == word)
            .ok_or_else(|| E::invalid_value(Unexpected::Str(word), &self))
    }
}
