//! The assemblies of a mechanism.

use core::fmt;

use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::names::{IndexedName, list};
use super::{finite, rows};
use crate::assembly::{Assembly, Near};

impl<const N: usize> Serialize for Near<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        finite::write(&rows::RowValues(&self.0), serializer)
    }
}

impl<'de, const N: usize> Deserialize<'de> for Near<N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        rows::read(deserializer).map(Self)
    }
}

/// Writes the choices of a generated structure, by the names of its fields.
///
/// # Errors
/// Errors of the format.
pub fn write_choices<S: Serializer>(names: &[&str], choices: &[Assembly], serializer: S) -> Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(Some(names.len()))?;
    for (name, choice) in names.iter().zip(choices) {
        map.serialize_entry(name, choice)?;
    }
    map.end()
}

/// Reads the choices of a generated structure, in any order.
///
/// # Errors
/// Errors of the format; a field that is missing, twice there, or unknown.
pub fn read_choices<'de, const N: usize, D: Deserializer<'de>>(
    names: &'static [&'static str; N],
    deserializer: D,
) -> Result<[Assembly; N], D::Error> {
    deserializer.deserialize_map(ChoiceNames(names))
}

struct ChoiceNames<const N: usize>(&'static [&'static str; N]);

impl<'de, const N: usize> Visitor<'de> for ChoiceNames<N> {
    type Value = [Assembly; N];

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("an assembly for each of ")?;
        list(self.0.iter().copied(), formatter)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<[Assembly; N], A::Error> {
        let mut found = [None; N];
        while let Some(index) = map.next_key_seed(IndexedName(|index| self.0.get(index).copied()))? {
            let choice = map
                .next_value()
                .map_err(|error| A::Error::custom(format_args!("{}: {error}", self.0[index])))?;
            if found[index].replace(choice).is_some() {
                return Err(A::Error::duplicate_field(self.0[index]));
            }
        }
        if let Some(index) = found.iter().position(Option::is_none) {
            return Err(A::Error::missing_field(self.0[index]));
        }
        Ok(found.map(|choice| choice.expect("no choice is missing")))
    }
}
