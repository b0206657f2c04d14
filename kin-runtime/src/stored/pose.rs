//! Poses by name.

use core::fmt::{self, Debug, Display};
use core::marker::PhantomData;

use serde::de::{self, Deserialize, DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::names::IndexedName;
use super::{finite, rows::whole};
use crate::failure::SolveError;
use crate::mechanism::{Description, Mechanism, Pose};
use crate::motion::{Direction, Motion};
use crate::number::Row;
use crate::quantity::Quantity;

type Outputs<M, V> = <<M as Mechanism>::Pose as Pose>::Outputs<V>;

/// A pose as it is stored: the motions of inputs, unknowns and outputs by name, without the private numbers of the
/// pose.
///
/// Every pose of a mechanism converts to a record, and is written as one. `LENGTH` is the number of values of each
/// motion: 5 for a pose through snap, 1 for a position. A direction is stored as its angle with the derivatives; a
/// point is its coordinates.
///
/// A record is read by the names of its mechanism, in any order. Outputs are read as well. A record of another
/// mechanism, a name that is missing or unknown, and a motion of another length are errors. The dimensions are not part
/// of a record.
///
/// [`solve`](Self::solve) makes a pose through all orders of the record. From a record of fewer orders, solve by
/// `position_near` and the methods of the position, as far as the inputs are known.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
/// use kin_core::stored::PoseRecord;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let pose = linkage.solve(Motion::from((1.1, -10.0, 2.0, -0.5, 0.3)), Assembly::Crossed)?;
///
/// // `serde_json::to_string(&pose)`, and `serde_json::from_str` on the other side
/// let record = PoseRecord::from(pose);
/// assert_eq!(record.inputs[0].velocity(), -10.0);
/// assert_eq!(record.unknowns[1], pose.theta4);
///
/// // in the same assembly, because the unknowns are solved for near those of the record
/// assert_eq!(record.solve(&linkage)?, pose);
/// # Ok::<(), SolveError>(())
/// ```
#[derive(Clone, Copy)]
pub struct PoseRecord<M: Mechanism, const LENGTH: usize = 5> {
    /// The motions of the inputs, in the order in which they were declared.
    pub inputs: M::Inputs<Motion<M::Scalar, LENGTH>>,
    /// The motions of the unknowns, in the order in which they were declared.
    pub unknowns: M::Unknowns<Motion<M::Scalar, LENGTH>>,
    /// The motions of the outputs, in the order in which they were declared. A point is its x, its y and, in space, its
    /// z.
    pub outputs: Outputs<M, Motion<M::Scalar, LENGTH>>,
}

impl<M: Mechanism, const LENGTH: usize> PoseRecord<M, LENGTH> {
    /// The values of the unknowns, as `position_near` and `solve_near` take them.
    #[must_use]
    pub fn near(&self) -> M::Unknowns<M::Scalar> {
        Row::from_fn(|unknown| self.unknowns[unknown].value())
    }
}

impl<M, const LENGTH: usize> PoseRecord<M, LENGTH>
where
    M: Mechanism,
    M::Inputs<Motion<M::Scalar, LENGTH>>: Into<M::Inputs<M::Motion<M::Scalar>>>,
{
    /// The pose of a mechanism at the inputs of the record, with unknowns near those of the record.
    ///
    /// With the dimensions that the record was made with, the unknowns agree with those of the record up to rounding:
    /// exactly for blocks with a closed form, and up to the last step of Newton's method for others.
    ///
    /// # Errors
    /// The errors of `solve_near`.
    pub fn solve(&self, mechanism: &M) -> Result<M::Pose, SolveError> {
        mechanism.solve_near(self.inputs.into(), self.near())
    }
}

impl<M: Mechanism, const LENGTH: usize> PartialEq for PoseRecord<M, LENGTH>
where
    M::Scalar: PartialEq,
{
    fn eq(&self, other: &Self) -> bool {
        self.inputs.as_ref() == other.inputs.as_ref()
            && self.unknowns.as_ref() == other.unknowns.as_ref()
            && self.outputs.as_ref() == other.outputs.as_ref()
    }
}

impl<M: Mechanism, const LENGTH: usize> Debug for PoseRecord<M, LENGTH> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("PoseRecord")
            .field("mechanism", &M::DESCRIPTION.name)
            .field("inputs", &self.inputs.as_ref())
            .field("unknowns", &self.unknowns.as_ref())
            .field("outputs", &self.outputs.as_ref())
            .finish()
    }
}

/// A field of a pose, with its value if the field is a direction.
pub trait PoseEntry<T, const LENGTH: usize> {
    /// The motion.
    fn motion_from(&self, value: T) -> Motion<T, LENGTH>;
}

impl<T: Copy, const LENGTH: usize> PoseEntry<T, LENGTH> for Motion<T, LENGTH> {
    fn motion_from(&self, _: T) -> Self {
        *self
    }
}

macro_rules! directions {
    ($($length:literal -> $longer:literal)+) => {
        $(
            impl<T: Copy> PoseEntry<T, $longer> for Direction<T, $length> {
                fn motion_from(&self, value: T) -> Motion<T, $longer> {
                    Direction::<T, $length>::motion_from(self, value)
                }
            }
        )+
    };
}

directions!(0 -> 1 1 -> 2 2 -> 3 3 -> 4 4 -> 5 5 -> 6 6 -> 7 7 -> 8 8 -> 9 9 -> 10 10 -> 11 11 -> 12 12 -> 13);

/// The motion of an unknown as a pose holds it, with the value of the unknown.
pub fn motion<T, const LENGTH: usize>(held: &impl PoseEntry<T, LENGTH>, value: T) -> Motion<T, LENGTH> {
    held.motion_from(value)
}

/// Named motions.
struct Motions<'a, T, const LENGTH: usize> {
    quantities: &'static [Quantity<'static>],
    motions: &'a [Motion<T, LENGTH>],
}

impl<T: Serialize, const LENGTH: usize> Serialize for Motions<'_, T, LENGTH> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.motions.len()))?;
        for (quantity, motion) in self.quantities.iter().zip(self.motions) {
            map.serialize_entry(quantity.name, motion)?;
        }
        map.end()
    }
}

#[derive(serde::Serialize)]
#[serde(rename = "Pose")]
struct Form<'a, T: Serialize, const LENGTH: usize> {
    mechanism: &'static str,
    inputs: Motions<'a, T, LENGTH>,
    unknowns: Motions<'a, T, LENGTH>,
    outputs: Motions<'a, T, LENGTH>,
}

impl<M: Mechanism, const LENGTH: usize> Serialize for PoseRecord<M, LENGTH>
where
    M::Scalar: Serialize,
{
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let form = Form {
            mechanism: M::DESCRIPTION.name,
            inputs: Motions {
                quantities: M::DESCRIPTION.inputs,
                motions: self.inputs.as_ref(),
            },
            unknowns: Motions {
                quantities: M::DESCRIPTION.unknowns,
                motions: self.unknowns.as_ref(),
            },
            outputs: Motions {
                quantities: M::DESCRIPTION.outputs,
                motions: self.outputs.as_ref(),
            },
        };
        finite::write(&form, serializer)
    }
}

impl<'de, M: Mechanism, const LENGTH: usize> Deserialize<'de> for PoseRecord<M, LENGTH>
where
    M::Scalar: Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_struct("Pose", &FIELDS, RecordVisitor(PhantomData))
    }
}

const FIELDS: [&str; 4] = ["mechanism", "inputs", "unknowns", "outputs"];

struct RecordVisitor<M, const LENGTH: usize>(PhantomData<M>);

impl<'de, M: Mechanism, const LENGTH: usize> Visitor<'de> for RecordVisitor<M, LENGTH>
where
    M::Scalar: Deserialize<'de>,
{
    type Value = PoseRecord<M, LENGTH>;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "a pose of {}", M::DESCRIPTION.name)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut fields: A) -> Result<Self::Value, A::Error> {
        let missing = |index| A::Error::invalid_length(index, &self);
        let name = NameOf::<M>(PhantomData);
        fields.next_element_seed(name)?.ok_or_else(|| missing(0))?;
        let inputs = fields.next_element_seed(INPUTS.of::<M, _, _>())?;
        let unknowns = fields.next_element_seed(UNKNOWNS.of::<M, _, _>())?;
        let outputs = fields.next_element_seed(OUTPUTS.of::<M, _, _>())?;
        Ok(record(
            inputs.ok_or_else(|| missing(1))?,
            unknowns.ok_or_else(|| missing(2))?,
            outputs.ok_or_else(|| missing(3))?,
        ))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let (mut named, mut inputs, mut unknowns, mut outputs) = (None, None, None, None);
        while let Some(field) = map.next_key()? {
            match field {
                PoseField::Mechanism => named = Some(map.next_value_seed(NameOf::<M>(PhantomData))?),
                PoseField::Inputs => inputs = Some(map.next_value_seed(INPUTS.of::<M, _, _>())?),
                PoseField::Unknowns => unknowns = Some(map.next_value_seed(UNKNOWNS.of::<M, _, _>())?),
                PoseField::Outputs => outputs = Some(map.next_value_seed(OUTPUTS.of::<M, _, _>())?),
            }
        }
        let missing = A::Error::missing_field;
        named.ok_or_else(|| missing("mechanism"))?;
        Ok(record(
            inputs.ok_or_else(|| missing("inputs"))?,
            unknowns.ok_or_else(|| missing("unknowns"))?,
            outputs.ok_or_else(|| missing("outputs"))?,
        ))
    }
}

#[derive(serde::Deserialize)]
#[serde(field_identifier, rename_all = "snake_case")]
enum PoseField {
    Mechanism,
    Inputs,
    Unknowns,
    Outputs,
}

/// The record of rows that have been read in full.
fn record<M: Mechanism, const LENGTH: usize>(
    inputs: M::Inputs<Option<Motion<M::Scalar, LENGTH>>>,
    unknowns: M::Unknowns<Option<Motion<M::Scalar, LENGTH>>>,
    outputs: Outputs<M, Option<Motion<M::Scalar, LENGTH>>>,
) -> PoseRecord<M, LENGTH> {
    PoseRecord {
        inputs: whole(&inputs),
        unknowns: whole(&unknowns),
        outputs: whole(&outputs),
    }
}

/// The name of the mechanism, which must be the expected one.
struct NameOf<M>(PhantomData<M>);

impl<'de, M: Mechanism> DeserializeSeed<'de> for NameOf<M> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_str(self)
    }
}

impl<M: Mechanism> Visitor<'_> for NameOf<M> {
    type Value = ();

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "a pose of the mechanism `{}`", M::DESCRIPTION.name)
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<(), E> {
        if name == M::DESCRIPTION.name {
            Ok(())
        } else {
            Err(E::invalid_value(de::Unexpected::Str(name), &self))
        }
    }
}

/// One of the groups of motions, and the names in it.
struct GroupName {
    name: &'static str,
    quantities: fn(&Description<'static>) -> &'static [Quantity<'static>],
}

const INPUTS: GroupName = GroupName {
    name: "inputs",
    quantities: |description| description.inputs,
};
const UNKNOWNS: GroupName = GroupName {
    name: "unknowns",
    quantities: |description| description.unknowns,
};
const OUTPUTS: GroupName = GroupName {
    name: "outputs",
    quantities: |description| description.outputs,
};

impl GroupName {
    fn of<M: Mechanism, R, V>(&self) -> Group<R, V> {
        Group {
            name: self.name,
            quantities: (self.quantities)(&M::DESCRIPTION),
            row: PhantomData,
        }
    }
}

/// The motions of inputs, unknowns or outputs, to be read by name in any order.
struct Group<R, V> {
    name: &'static str,
    quantities: &'static [Quantity<'static>],
    row: PhantomData<(R, V)>,
}

impl<'de, V: Deserialize<'de> + Copy, R: Row<Option<V>>> DeserializeSeed<'de> for Group<R, V> {
    type Value = R;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<R, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de, V: Deserialize<'de> + Copy, R: Row<Option<V>>> Visitor<'de> for Group<R, V> {
    type Value = R;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "motions by name, as {}", self.name)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<R, A::Error> {
        let group = self.name;
        let name = |index: usize| self.quantities.get(index).map(|quantity| quantity.name);
        let mut row = R::splat(None);
        while let Some(index) = map
            .next_key_seed(IndexedName(name))
            .map_err(|error| A::Error::custom(format_args!("{group}: {error}")))?
        {
            let fault = |fault: &dyn Display| {
                A::Error::custom(format_args!("{group}.{}: {fault}", self.quantities[index].name))
            };
            let motion = map.next_value().map_err(|error| fault(&error))?;
            if row[index].replace(motion).is_some() {
                return Err(fault(&"stands there twice"));
            }
        }
        match self
            .quantities
            .iter()
            .zip(row.as_ref())
            .find(|(_, motion)| motion.is_none())
        {
            None => Ok(row),
            Some((quantity, _)) => Err(A::Error::custom(format_args!("{group}.{} is missing", quantity.name))),
        }
    }
}
