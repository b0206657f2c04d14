//! Exact tables as JSON.

use std::error::Error;
use std::fmt;

use kin_core::Dimension;
use kin_core::exact::{ExactColumnParts, ExactParts, ExactTable, ReadError};
use serde_json::{Map, Value, json};

/// The name of the format.
const FORMAT: &str = "kin exact table";
/// Its version.
const VERSION: u64 = 1;

/// Exact tables as text for other programs.
///
/// ```
/// use std::f64::consts::TAU;
/// use kin_core::exact::ExactTable;
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
/// use kin_studio::tables::ExactJson;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
/// let table = linkage.sweep(Assembly::Open).over(0.0..=TAU, 13).exact_table(1e-6)?;
/// let json = table.to_json();
/// assert!(json.contains("\"version\":1"));
/// assert_eq!(ExactTable::from_json(&json)?, table);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait ExactJson: Sized {
    /// One object: `format` and `version`; `name`; the `parameter` and the `columns` with `name` and `dimension`, which
    /// is `angle`, `length` or `number`; for each column its `turn`, the change over a period, and its measured
    /// `errors`; `order`; `closed`, whether the table repeats itself; and `rows`, each a list of the parameter and,
    /// column after column, the value and its derivatives.
    fn to_json(&self) -> String;

    /// The table of such an object.
    ///
    /// # Errors
    /// [`JsonError`], for a text that is no such object, is damaged or was written by a newer version.
    fn from_json(text: &str) -> Result<Self, JsonError>;
}

/// The reason why a text is no exact table.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum JsonError {
    /// The text is no JSON.
    Syntax {
        /// The mistake, with the line and the column.
        what: String,
    },
    /// The text is another object than an exact table.
    NotATable,
    /// The table was written by a newer version, in a format that this version does not know.
    Newer {
        /// The version of the format.
        found: u64,
        /// The newest version that is known here.
        known: u64,
    },
    /// An entry is missing or of another kind.
    Entry {
        /// The name of the entry.
        name: &'static str,
    },
    /// The entries contradict each other.
    Table(ReadError),
}

impl fmt::Display for JsonError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Syntax { what } => write!(formatter, "the text is no JSON: {what}"),
            Self::NotATable => write!(formatter, "the text is no exact table: it has no format `{FORMAT}`"),
            Self::Newer { found, known } => write!(
                formatter,
                "the exact table has version {found} of its format, and this version of kin reads versions up to \
                 {known}: read it with a newer version, or write it again"
            ),
            Self::Entry { name } => write!(
                formatter,
                "the exact table is damaged: its entry `{name}` is missing or of another kind"
            ),
            Self::Table(error) => write!(formatter, "{error}"),
        }
    }
}

kin_core::__debug_by_display!(JsonError);

impl Error for JsonError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Table(error) => Some(error),
            _ => None,
        }
    }
}

impl ExactJson for ExactTable {
    fn to_json(&self) -> String {
        let parts = self.parts();
        let columns: Vec<Value> = parts
            .columns
            .iter()
            .map(|column| {
                json!({
                    "name": column.name,
                    "dimension": word(column.dimension),
                    "turn": column.increment,
                    "errors": column.errors,
                })
            })
            .collect();
        json!({
            "format": FORMAT,
            "version": VERSION,
            "name": parts.name,
            "parameter": { "name": parts.parameter.0, "dimension": word(parts.parameter.1) },
            "order": parts.order,
            "closed": parts.is_closed,
            "columns": columns,
            "rows": parts.rows,
        })
        .to_string()
    }

    fn from_json(text: &str) -> Result<Self, JsonError> {
        let value: Value = serde_json::from_str(text).map_err(|error| JsonError::Syntax {
            what: error.to_string(),
        })?;
        let object = value
            .as_object()
            .filter(|object| object.get("format").and_then(Value::as_str) == Some(FORMAT))
            .ok_or(JsonError::NotATable)?;
        let version = entry(object, "version", Value::as_u64)?;
        if version > VERSION {
            return Err(JsonError::Newer {
                found: version,
                known: VERSION,
            });
        }
        if version == 0 {
            return Err(JsonError::Entry { name: "version" });
        }
        let parameter = entry(object, "parameter", Value::as_object)?;
        let columns = entry(object, "columns", Value::as_array)?.iter();
        let rows = entry(object, "rows", Value::as_array)?.iter();
        let order = entry(object, "order", Value::as_u64)?;
        let parts = ExactParts {
            name: entry(object, "name", Value::as_str)?.to_owned(),
            parameter: named(parameter)?,
            // an order that is no number of derivatives is refused with the rest
            order: usize::from(u8::try_from(order).map_err(|_| JsonError::Entry { name: "order" })?),
            is_closed: entry(object, "closed", Value::as_bool)?,
            columns: columns
                .map(|column| {
                    let column = column.as_object().ok_or(JsonError::Entry { name: "columns" })?;
                    let (name, dimension) = named(column)?;
                    Ok(ExactColumnParts {
                        name,
                        dimension,
                        increment: entry(column, "turn", Value::as_f64)?,
                        errors: entry(column, "errors", numbers)?,
                    })
                })
                .collect::<Result<_, _>>()?,
            rows: rows
                .map(|row| numbers(row).ok_or(JsonError::Entry { name: "rows" }))
                .collect::<Result<_, _>>()?,
        };
        parts.table().map_err(JsonError::Table)
    }
}

fn word(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::Angle => "angle",
        Dimension::Length => "length",
        Dimension::Scalar => "number",
    }
}

/// An entry of an object, as `read` takes it.
fn entry<'v, T>(
    object: &'v Map<String, Value>,
    name: &'static str,
    read: impl FnOnce(&'v Value) -> Option<T>,
) -> Result<T, JsonError> {
    object.get(name).and_then(read).ok_or(JsonError::Entry { name })
}

fn named(object: &Map<String, Value>) -> Result<(String, Dimension), JsonError> {
    let dimension = match entry(object, "dimension", Value::as_str)? {
        "angle" => Dimension::Angle,
        "length" => Dimension::Length,
        "number" => Dimension::Scalar,
        _ => return Err(JsonError::Entry { name: "dimension" }),
    };
    Ok((entry(object, "name", Value::as_str)?.to_owned(), dimension))
}

fn numbers(value: &Value) -> Option<Vec<f64>> {
    value.as_array()?.iter().map(Value::as_f64).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use kin_core::library::FourBar;
    use kin_core::prelude::*;

    fn table() -> ExactTable {
        let linkage = FourBar {
            r1: 90.0,
            r2: 30.0,
            r3: 70.0,
            r4: 60.0,
        };
        let sweep = linkage.sweep(Assembly::Open).over(0.0..=std::f64::consts::TAU, 9);
        sweep.exact_table(1e-5).unwrap()
    }

    #[test]
    fn tables_come_back_to_the_last_bit() {
        let table = table();
        assert_eq!(ExactTable::from_json(&table.to_json()), Ok(table));
    }

    #[test]
    fn other_texts_are_refused_with_reasons() {
        let text = table().to_json();
        let newer = text.replace("\"version\":1", "\"version\":3");
        assert_eq!(
            ExactTable::from_json(&newer),
            Err(JsonError::Newer {
                found: 3,
                known: VERSION
            })
        );
        assert_eq!(ExactTable::from_json("{}"), Err(JsonError::NotATable));
        assert!(matches!(ExactTable::from_json("{"), Err(JsonError::Syntax { .. })));
        for name in ["name", "parameter", "order", "closed", "columns", "rows", "version"] {
            let mut value: Value = serde_json::from_str(&text).unwrap();
            value[name] = Value::Null;
            assert_eq!(
                ExactTable::from_json(&value.to_string()),
                Err(JsonError::Entry { name })
            );
        }
        for order in [0, 3, 200] {
            let mut value: Value = serde_json::from_str(&text).unwrap();
            value["order"] = order.into();
            assert!(matches!(
                ExactTable::from_json(&value.to_string()),
                Err(JsonError::Table(ReadError::Contradiction { .. }))
            ));
        }
        let mut value: Value = serde_json::from_str(&text).unwrap();
        value["rows"][2][1] = "far".into();
        assert_eq!(
            ExactTable::from_json(&value.to_string()),
            Err(JsonError::Entry { name: "rows" })
        );
    }

    /// Every text is a table or an error.
    #[test]
    fn damaged_texts_are_errors() {
        let text = table().to_json();
        let mut random = kin_core::verify::Random::new(5);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            clippy::cast_precision_loss,
            reason = "it is below the number of letters"
        )]
        let mut below = |end: usize| random.between(0.0, end as f64) as usize;
        let letters = b"0123456789.-eE,:[]{}\"ntf ";
        let mut refused = 0;
        for _ in 0..2000 {
            let mut bytes = text.clone().into_bytes();
            for _ in 0..=below(3) {
                // the head has most of the decisions
                let end = if below(2) == 0 { 600 } else { bytes.len() };
                let index = below(end.min(bytes.len()));
                match below(4) {
                    0 => {
                        bytes.remove(index);
                    }
                    1 => bytes.insert(index, letters[below(letters.len())]),
                    _ => bytes[index] = letters[below(letters.len())],
                }
            }
            let text = String::from_utf8(bytes).unwrap();
            refused += usize::from(ExactTable::from_json(&text).is_err());
        }
        assert!(refused > 200, "{refused}");
    }
}
