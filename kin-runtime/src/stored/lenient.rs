//! Numbers of errors, which may be NaN or infinite. Texts of people write these as words, because JSON has no such
//! numbers.

use core::fmt;

use serde::de::{Deserialize, Deserializer, Error, Unexpected, Visitor};
use serde::ser::{Serialize, Serializer};

/// A number that is written even if it is not finite.
#[derive(Clone, Copy)]
pub(super) struct Lenient(pub(super) f64);

impl Serialize for Lenient {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.0.is_finite() || !serializer.is_human_readable() {
            serializer.serialize_f64(self.0)
        } else {
            serializer.collect_str(&self.0)
        }
    }
}

impl<'de> Deserialize<'de> for Lenient {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        if deserializer.is_human_readable() {
            deserializer.deserialize_any(NumberVisitor)
        } else {
            f64::deserialize(deserializer).map(Self)
        }
    }
}

struct NumberVisitor;

impl Visitor<'_> for NumberVisitor {
    type Value = Lenient;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a number, `NaN`, `inf` or `-inf`")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Lenient, E> {
        Ok(Lenient(value))
    }

    #[expect(clippy::cast_precision_loss, reason = "formats write whole numbers without a point")]
    fn visit_i64<E: Error>(self, value: i64) -> Result<Lenient, E> {
        Ok(Lenient(value as f64))
    }

    #[expect(clippy::cast_precision_loss, reason = "formats write whole numbers without a point")]
    fn visit_u64<E: Error>(self, value: u64) -> Result<Lenient, E> {
        Ok(Lenient(value as f64))
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<Lenient, E> {
        match word {
            "NaN" => Ok(Lenient(f64::NAN)),
            "inf" => Ok(Lenient(f64::INFINITY)),
            "-inf" => Ok(Lenient(f64::NEG_INFINITY)),
            _ => Err(E::invalid_value(Unexpected::Str(word), &self)),
        }
    }
}

/// Writes a number of an error.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it so")]
pub(super) fn serialize<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    Lenient(*value).serialize(serializer)
}

/// Reads a number of an error.
pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Lenient::deserialize(deserializer).map(|number| number.0)
}
