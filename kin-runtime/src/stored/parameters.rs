//! The dimensions of a mechanism by name.

use core::fmt;
use core::marker::PhantomData;

use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::names::IndexedName;
use super::{finite, rows::whole};
use crate::geometry::{Plane, Space};
use crate::mechanism::Mechanism;
use crate::number::Row;
use crate::quantity::Quantity;

/// The parameters of a mechanism as they are stored: by name, points as maps of their coordinates.
///
/// This is how generic code stores any mechanism. Where the mechanism is known, [`storable!`](crate::storable) lets its
/// structure be stored like this.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::stored::{ParameterRecord, check};
///
/// // `serde_json::to_string(&record)` writes {"r1":90.0,"r2":30.0,"r3":60.0,"r4":45.0}
/// let record = ParameterRecord(FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 });
/// assert!(check(&record).is_ok());
/// assert_eq!(record.0.r1, 90.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterRecord<M>(
    /// The mechanism.
    pub M,
);

/// A parameter: a number or a vector, with the index of its first number among the scalar parameters.
struct Member {
    name: &'static str,
    start: usize,
    length: usize,
}

/// The name of a vector whose coordinate has this name.
fn vector(quantity: &Quantity<'static>) -> Option<&'static str> {
    quantity.name.split_once('.').map(|(vector, _)| vector)
}

/// The parameters, in the order in which they were declared.
fn members(quantities: &'static [Quantity<'static>]) -> impl Iterator<Item = Member> + Clone {
    let begins = move |start: &usize| {
        let before = start.checked_sub(1).and_then(|before| vector(&quantities[before]));
        before.is_none() || vector(&quantities[*start]) != before
    };
    (0..quantities.len()).filter(begins).map(move |start| {
        let first = &quantities[start];
        let Some(name) = vector(first) else {
            let (name, length) = (first.name, 1);
            return Member { name, start, length };
        };
        let rest = quantities[start..].iter();
        let length = rest.take_while(|quantity| vector(quantity) == Some(name)).count();
        Member { name, start, length }
    })
}

struct Form<'a, T> {
    quantities: &'static [Quantity<'static>],
    values: &'a [T],
}

impl<T: Serialize + Copy> Serialize for Form<'_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let members = members(self.quantities);
        let mut map = serializer.serialize_map(Some(members.clone().count()))?;
        for Member { name, start, length } in members {
            match self.values.get(start..start + length).unwrap_or_default() {
                &[x, y] => map.serialize_entry(name, &Plane::new(x, y))?,
                &[x, y, z] => map.serialize_entry(name, &Space::new(x, y, z))?,
                others => {
                    for value in others {
                        map.serialize_entry(name, value)?;
                    }
                }
            }
        }
        map.end()
    }
}

impl<M: Mechanism> Serialize for ParameterRecord<M>
where
    M::Scalar: Serialize,
{
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let values = self.0.parameters();
        let form = Form {
            quantities: M::DESCRIPTION.parameters,
            values: values.as_ref(),
        };
        finite::write(&form, serializer)
    }
}

impl<'de, M: Mechanism> Deserialize<'de> for ParameterRecord<M>
where
    M::Scalar: Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(Parameters(PhantomData))
    }
}

struct Parameters<M>(PhantomData<M>);

impl<'de, M: Mechanism> Visitor<'de> for Parameters<M>
where
    M::Scalar: Deserialize<'de>,
{
    type Value = ParameterRecord<M>;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "the parameters of {}", M::DESCRIPTION.name)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let members = members(M::DESCRIPTION.parameters);
        let member = |index| members.clone().nth(index);
        let name = |index| member(index).map(|member| member.name);
        let mut values = M::Parameters::<Option<M::Scalar>>::splat(None);
        while let Some(index) = map.next_key_seed(IndexedName(name))? {
            let Some(Member { name, start, length }) = member(index) else {
                continue;
            };
            let fault = |error: A::Error| A::Error::custom(format_args!("{name}: {error}"));
            if values[start].is_some() {
                return Err(A::Error::duplicate_field(name));
            }
            match length {
                2 => {
                    let Plane { x, y } = map.next_value().map_err(fault)?;
                    (values[start], values[start + 1]) = (Some(x), Some(y));
                }
                3 => {
                    let Space { x, y, z } = map.next_value().map_err(fault)?;
                    (values[start], values[start + 1], values[start + 2]) = (Some(x), Some(y), Some(z));
                }
                _ => values[start] = Some(map.next_value().map_err(fault)?),
            }
        }
        if let Some(Member { name, .. }) = members.clone().find(|member| values[member.start].is_none()) {
            return Err(A::Error::missing_field(name));
        }
        Ok(ParameterRecord(M::from_parameters(whole(&values))))
    }
}
