//! The reasons why a solver found no position.

use core::fmt::Display;

use serde::ser::{Serialize, SerializeMap, Serializer};

use super::lenient::{self, Lenient};
use crate::failure::{Failure, InputValues, SolveError};
use crate::quantity::Name;

/// A [`Failure`] that owns its names: the text `S` is `String` when it is read, and [`Name`] when it is made of a
/// failure.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
#[allow(missing_docs, reason = "the fields are those of the failure")]
pub enum FailureRecord<S> {
    /// [`Failure::OutOfReach`]
    OutOfReach {
        #[serde(with = "lenient")]
        margin: f64,
    },
    /// [`Failure::Singular`]
    Singular {
        #[serde(with = "lenient")]
        determinant: f64,
    },
    /// [`Failure::OutOfRange`]
    OutOfRange {
        unknown: S,
        #[serde(with = "lenient")]
        value: f64,
        #[serde(with = "lenient")]
        low: f64,
        #[serde(with = "lenient")]
        high: f64,
        is_angle: bool,
    },
    /// [`Failure::Ambiguous`]
    Ambiguous {
        unknown: S,
        #[serde(with = "lenient")]
        first: f64,
        #[serde(with = "lenient")]
        second: f64,
        is_angle: bool,
    },
    /// [`Failure::OutsideDomain`]
    OutsideDomain {
        function: S,
        #[serde(with = "lenient")]
        argument: f64,
    },
    /// [`Failure::NotConverged`]
    NotConverged {
        #[serde(with = "lenient")]
        residual: f64,
        iterations: u32,
        #[serde(with = "lenient")]
        condition: f64,
    },
    /// [`Failure::TooManyRevolutions`]
    #[serde(rename = "TooManyTurns")]
    TooManyRevolutions {
        unknown: S,
        #[serde(with = "lenient")]
        guess: f64,
        #[serde(with = "lenient")]
        spacing: f64,
    },
    /// [`Failure::NotFinite`]
    NotFinite { quantity: S },
}

impl<S: From<Name>> From<Failure> for FailureRecord<S> {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::OutOfReach { margin } => Self::OutOfReach { margin },
            Failure::Singular { determinant } => Self::Singular { determinant },
            Failure::OutOfRange {
                unknown,
                value,
                low,
                high,
                is_angle,
            } => Self::OutOfRange {
                unknown: unknown.into(),
                value,
                low,
                high,
                is_angle,
            },
            Failure::Ambiguous {
                unknown,
                first,
                second,
                is_angle,
            } => Self::Ambiguous {
                unknown: unknown.into(),
                first,
                second,
                is_angle,
            },
            Failure::OutsideDomain { function, argument } => Self::OutsideDomain {
                function: Name::new(function).into(),
                argument,
            },
            Failure::NotConverged {
                residual,
                iterations,
                condition,
            } => Self::NotConverged {
                residual,
                iterations,
                condition,
            },
            Failure::TooManyRevolutions {
                unknown,
                guess,
                spacing,
            } => Self::TooManyRevolutions {
                unknown: unknown.into(),
                guess,
                spacing,
            },
            Failure::NotFinite { quantity } => Self::NotFinite {
                quantity: quantity.into(),
            },
        }
    }
}

impl Serialize for Failure {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        FailureRecord::<Name>::from(*self).serialize(serializer)
    }
}

/// The inputs by name.
impl Serialize for InputValues {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.iter().count()))?;
        for (name, value) in self.iter() {
            map.serialize_entry(&name, &Lenient(value))?;
        }
        map.end()
    }
}

/// A message, written as it is displayed.
pub(super) struct Message<M>(pub(super) M);

impl<M: Display> Serialize for Message<M> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&self.0)
    }
}

/// The failure, the block, the inputs by name, and the message.
impl Serialize for SolveError {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        #[serde(rename = "SolveError")]
        struct Form<'a> {
            failure: Failure,
            block: Name,
            inputs: &'a InputValues,
            message: Message<&'a SolveError>,
        }
        Form {
            failure: self.failure,
            block: self.block,
            inputs: &self.inputs,
            message: Message(self),
        }
        .serialize(serializer)
    }
}

#[cfg(feature = "std")]
mod owned {
    use std::collections::BTreeMap;
    use std::string::String;

    use serde::de::{Deserialize, Deserializer};
    use serde::ser::Serializer;

    use super::{FailureRecord, Lenient};
    use crate::failure::SolveError;

    /// A [`SolveError`] that owns its texts, so that a program can read it. It is written like the error.
    #[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
    #[serde(rename = "SolveError")]
    #[non_exhaustive]
    pub struct SolveErrorRecord {
        /// The reason.
        pub failure: FailureRecord<String>,
        /// The unknowns of the block, separated by commas.
        pub block: String,
        /// The inputs of the solver, by name.
        #[serde(serialize_with = "write_inputs", deserialize_with = "read_inputs")]
        pub inputs: BTreeMap<String, f64>,
        /// The message of the error.
        pub message: String,
    }

    impl From<SolveError> for SolveErrorRecord {
        fn from(error: SolveError) -> Self {
            use std::string::ToString;

            Self {
                failure: error.failure.into(),
                block: error.block.into(),
                inputs: error.inputs.iter().map(|(name, value)| (name.into(), value)).collect(),
                message: error.to_string(),
            }
        }
    }

    fn write_inputs<S: Serializer>(inputs: &BTreeMap<String, f64>, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(inputs.iter().map(|(name, value)| (name, Lenient(*value))))
    }

    fn read_inputs<'de, D: Deserializer<'de>>(deserializer: D) -> Result<BTreeMap<String, f64>, D::Error> {
        let inputs = BTreeMap::<String, Lenient>::deserialize(deserializer)?;
        Ok(inputs.into_iter().map(|(name, value)| (name, value.0)).collect())
    }
}

#[cfg(feature = "std")]
pub use owned::SolveErrorRecord;
