//! The search for numbers that cannot be stored.

use core::error::Error;
use core::fmt::{self, Display, Write as _};

use serde::ser::{self, Serialize, Serializer};

const REASON: &str = ", and only finite numbers can be stored";

/// The number that is not finite, by its position in the value that was to be stored.
///
/// ```
/// use kin_core::{Motion, Plane, stored};
///
/// let path = Motion::from([Plane::new(1.0, 2.0), Plane::new(f64::NAN, 0.0)]);
/// let error = stored::check(&path).unwrap_err();
/// assert_eq!(error.to_string(), "[1].x is NaN, and only finite numbers can be stored");
/// ```
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct NotFinite {
    /// The position and the number: `unknowns.theta4[3] is NaN`.
    text: Text<SHORT>,
}

impl NotFinite {
    fn number(value: f64) -> Self {
        Self {
            text: Text::of(format_args!(" is {value}")),
        }
    }

    fn inside(self, position: impl Display) -> Self {
        let inner = self.text.as_str();
        let separator = if inner.starts_with([' ', '[']) { "" } else { "." };
        Self {
            text: Text::of(format_args!("{position}{separator}{inner}")),
        }
    }
}

impl Display for NotFinite {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = self.text.as_str();
        let number = if text.starts_with(' ') { "a number" } else { "" };
        write!(formatter, "{number}{text}{REASON}")
    }
}

crate::__debug_by_display!(NotFinite);

impl Error for NotFinite {}

/// Whether every number of a value is finite, so that it can be stored in formats without NaN and infinities, such as
/// JSON.
///
/// # Errors
/// The position of the first number that is not finite.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::stored;
///
/// let linkage = FourBar { r1: 90.0, r2: f64::INFINITY, r3: 60.0, r4: 45.0 };
/// let error = stored::check(&linkage).unwrap_err();
/// assert_eq!(error.to_string(), "r2 is inf, and only finite numbers can be stored");
/// ```
pub fn check<V: Serialize + ?Sized>(value: &V) -> Result<(), NotFinite> {
    match value.serialize(Search) {
        Err(Found::Number(number)) => Err(number),
        // The format reports all other errors.
        Ok(()) | Err(Found::Other) => Ok(()),
    }
}

/// Writes a value, unless it has a number that is not finite.
pub(super) fn write<V: Serialize, S: Serializer>(value: &V, serializer: S) -> Result<S::Ok, S::Error> {
    check(value).map_err(ser::Error::custom)?;
    value.serialize(serializer)
}

/// The length of a position, so that results of the search stay small.
const SHORT: usize = 104;

/// The length of a position with the reason.
const LONG: usize = SHORT + REASON.len();

/// A text without allocation. The rest of a longer one is cut off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Text<const CAPACITY: usize> {
    bytes: [u8; CAPACITY],
    length: usize,
}

impl<const CAPACITY: usize> Text<CAPACITY> {
    fn of(content: impl Display) -> Self {
        let mut text = Self {
            bytes: [0; CAPACITY],
            length: 0,
        };
        // It fails only if the content does, and then the text ends there.
        let _ = write!(text, "{content}");
        text
    }

    fn as_str(&self) -> &str {
        let bytes = self.bytes.get(..self.length).unwrap_or_default();
        core::str::from_utf8(bytes).unwrap_or_default()
    }
}

impl<const CAPACITY: usize> fmt::Write for Text<CAPACITY> {
    fn write_str(&mut self, part: &str) -> fmt::Result {
        for letter in part.chars() {
            let end = self.length + letter.len_utf8();
            let Some(room) = self.bytes.get_mut(self.length..end) else {
                break;
            };
            letter.encode_utf8(room);
            self.length = end;
        }
        Ok(())
    }
}

/// The end of a search.
#[derive(Debug)]
enum Found {
    Number(NotFinite),
    /// The value cannot be written for another reason.
    Other,
}

impl Found {
    fn inside(self, position: impl Display) -> Self {
        match self {
            Self::Number(number) => Self::Number(number.inside(position)),
            Self::Other => Self::Other,
        }
    }
}

impl Display for Found {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => number.fmt(formatter),
            Self::Other => formatter.write_str("the value cannot be written"),
        }
    }
}

impl Error for Found {}

impl ser::Error for Found {
    /// The types of this crate that are parts of the value search their numbers, and report them by this message.
    fn custom<M: Display>(message: M) -> Self {
        let text = Text::<LONG>::of(message);
        text.as_str()
            .strip_suffix(REASON)
            .map_or(Self::Other, |found| Self::Number(NotFinite { text: Text::of(found) }))
    }
}

/// A format that writes nothing and looks at the numbers.
struct Search;

macro_rules! nothing {
    ($($method:ident($($type:ty),*);)+) => {
        $(
            fn $method(self, $(_: $type),*) -> Result<(), Found> {
                Ok(())
            }
        )+
    };
}

impl Serializer for Search {
    type Ok = ();
    type Error = Found;
    type SerializeSeq = Members;
    type SerializeTuple = Members;
    type SerializeTupleStruct = Members;
    type SerializeTupleVariant = Members;
    type SerializeMap = Members;
    type SerializeStruct = Members;
    type SerializeStructVariant = Members;

    fn serialize_f32(self, value: f32) -> Result<(), Found> {
        self.serialize_f64(f64::from(value))
    }

    fn serialize_f64(self, value: f64) -> Result<(), Found> {
        if value.is_finite() {
            Ok(())
        } else {
            Err(Found::Number(NotFinite::number(value)))
        }
    }

    nothing! {
        serialize_bool(bool);
        serialize_i8(i8);
        serialize_i16(i16);
        serialize_i32(i32);
        serialize_i64(i64);
        serialize_i128(i128);
        serialize_u8(u8);
        serialize_u16(u16);
        serialize_u32(u32);
        serialize_u64(u64);
        serialize_u128(u128);
        serialize_char(char);
        serialize_str(&str);
        serialize_bytes(&[u8]);
        serialize_none();
        serialize_unit();
        serialize_unit_struct(&'static str);
        serialize_unit_variant(&'static str, u32, &'static str);
    }

    fn serialize_some<V: Serialize + ?Sized>(self, value: &V) -> Result<(), Found> {
        value.serialize(self)
    }

    fn serialize_newtype_struct<V: Serialize + ?Sized>(self, _: &'static str, value: &V) -> Result<(), Found> {
        value.serialize(self)
    }

    fn serialize_newtype_variant<V: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &V,
    ) -> Result<(), Found> {
        value.serialize(self).map_err(|found| found.inside(variant))
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Members, Found> {
        Ok(Members::default())
    }

    fn serialize_tuple(self, _: usize) -> Result<Members, Found> {
        Ok(Members::default())
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Members, Found> {
        Ok(Members::default())
    }

    fn serialize_tuple_variant(self, _: &'static str, _: u32, _: &'static str, _: usize) -> Result<Members, Found> {
        Ok(Members::default())
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Members, Found> {
        Ok(Members::default())
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Members, Found> {
        Ok(Members::default())
    }

    fn serialize_struct_variant(self, _: &'static str, _: u32, _: &'static str, _: usize) -> Result<Members, Found> {
        Ok(Members::default())
    }

    fn collect_str<V: Display + ?Sized>(self, _: &V) -> Result<(), Found> {
        Ok(())
    }
}

/// The parts of a value, one after the other.
#[derive(Default)]
struct Members {
    /// The number of the next part of a sequence.
    index: usize,
    /// The key of the next value of a map.
    key: Option<Text<SHORT>>,
}

impl Members {
    fn next<V: Serialize + ?Sized>(&mut self, value: &V) -> Result<(), Found> {
        let index = self.index;
        self.index += 1;
        value
            .serialize(Search)
            .map_err(|found| found.inside(format_args!("[{index}]")))
    }
}

macro_rules! sequences {
    ($($trait:ident $method:ident;)+) => {
        $(
            impl ser::$trait for Members {
                type Ok = ();
                type Error = Found;

                fn $method<V: Serialize + ?Sized>(&mut self, value: &V) -> Result<(), Found> {
                    self.next(value)
                }

                fn end(self) -> Result<(), Found> {
                    Ok(())
                }
            }
        )+
    };
}

sequences! {
    SerializeSeq serialize_element;
    SerializeTuple serialize_element;
    SerializeTupleStruct serialize_field;
    SerializeTupleVariant serialize_field;
}

macro_rules! structures {
    ($($trait:ident)+) => {
        $(
            impl ser::$trait for Members {
                type Ok = ();
                type Error = Found;

                fn serialize_field<V: Serialize + ?Sized>(
                    &mut self,
                    name: &'static str,
                    value: &V,
                ) -> Result<(), Found> {
                    value.serialize(Search).map_err(|found| found.inside(name))
                }

                fn end(self) -> Result<(), Found> {
                    Ok(())
                }
            }
        )+
    };
}

structures!(SerializeStruct SerializeStructVariant);

impl ser::SerializeMap for Members {
    type Ok = ();
    type Error = Found;

    fn serialize_key<K: Serialize + ?Sized>(&mut self, key: &K) -> Result<(), Found> {
        self.key = Some(Text::of(Key(key)));
        Ok(())
    }

    fn serialize_value<V: Serialize + ?Sized>(&mut self, value: &V) -> Result<(), Found> {
        let key = self.key.take();
        let key = key.as_ref().map_or("", |key| key.as_str());
        value.serialize(Search).map_err(|found| found.inside(key))
    }

    fn end(self) -> Result<(), Found> {
        Ok(())
    }
}

/// The key of a map as text.
struct Key<'a, K: ?Sized>(&'a K);

impl<K: Serialize + ?Sized> Display for Key<'_, K> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.serialize(formatter)
    }
}
