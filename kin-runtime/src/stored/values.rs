//! Vectors, rotations, motions and directions.

use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

use super::{finite, rows};
use crate::geometry::{Plane, Rotation, Space};
use crate::motion::{Direction, Motion};

#[derive(serde::Serialize)]
struct PlaneForm<'a, T> {
    x: &'a T,
    y: &'a T,
}

#[derive(serde::Serialize)]
struct SpaceForm<'a, T> {
    x: &'a T,
    y: &'a T,
    z: &'a T,
}

#[derive(serde::Serialize)]
struct DirectionForm<'a, T> {
    unit: PlaneForm<'a, T>,
    rates: rows::RowValues<'a, T>,
}

impl<T: Serialize> Serialize for Plane<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { x, y } = self;
        finite::write(&PlaneForm { x, y }, serializer)
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Plane<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        #[serde(rename = "Plane")]
        struct Form<T> {
            x: T,
            y: T,
        }
        Form::deserialize(deserializer).map(|Form { x, y }| Self { x, y })
    }
}

impl<T: Serialize> Serialize for Space<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { x, y, z } = self;
        finite::write(&SpaceForm { x, y, z }, serializer)
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Space<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        #[serde(rename = "Space")]
        struct Form<T> {
            x: T,
            y: T,
            z: T,
        }
        Form::deserialize(deserializer).map(|Form { x, y, z }| Self { x, y, z })
    }
}

/// The rows of the matrix.
impl<T: Serialize> Serialize for Rotation<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        finite::write(&rows::RowValues(self.as_rows()), serializer)
    }
}

/// The rows of the matrix. Whether it is a rotation, up to the digits that were written, is not examined.
impl<'de, T: Deserialize<'de>> Deserialize<'de> for Rotation<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        rows::read(deserializer).map(Self::from_rows)
    }
}

/// The value and its derivatives, in ascending order.
impl<T: Serialize, const N: usize> Serialize for Motion<T, N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        finite::write(&rows::RowValues(self.as_slice()), serializer)
    }
}

/// The value and its derivatives, exactly as many as the motion has.
impl<'de, T: Deserialize<'de>, const N: usize> Deserialize<'de> for Motion<T, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        rows::read(deserializer).map(Self::new)
    }
}

impl<T: Serialize, const N: usize> Serialize for Direction<T, N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (Plane { x, y }, rates) = self.parts();
        let form = DirectionForm {
            unit: PlaneForm { x, y },
            rates: rows::RowValues(rates),
        };
        finite::write(&form, serializer)
    }
}

impl<'de, T: Deserialize<'de>, const N: usize> Deserialize<'de> for Direction<T, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        #[serde(rename = "Direction", bound = "T: serde::Deserialize<'de>")]
        struct Form<T, const N: usize> {
            unit: Plane<T>,
            #[serde(deserialize_with = "rows::read")]
            rates: [T; N],
        }
        Form::deserialize(deserializer).map(|Form { unit, rates }| Self::new(unit, rates))
    }
}
