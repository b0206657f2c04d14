//! The arguments of a function, in the form of a query and in the form of a batch.

use std::sync::Arc;

use datafusion::arrow::array::{Array, ArrayRef, AsArray, Float64Array};
use datafusion::arrow::buffer::NullBuffer;
use datafusion::arrow::datatypes::{DataType, Float64Type};
use datafusion::common::{Result, ScalarValue, exec_err, plan_err};
use datafusion::logical_expr::{ColumnarValue, Signature, TypeSignature, Volatility};
use kin_core::batch::Column;

/// The fewest rows that are solved in vectors of any width. Fewer would be solved one by one, and round differently.
pub(crate) const FEWEST_ROWS: usize = 16;

/// An argument of a function.
#[derive(Clone, Debug)]
pub(crate) struct Argument {
    /// The name of the argument.
    pub(crate) name: String,
    /// The meaning of the argument, with its unit.
    pub(crate) meaning: String,
    /// Whether the argument is a text instead of a number.
    pub(crate) is_text: bool,
}

impl Argument {
    pub(crate) fn number(name: impl Into<String>, meaning: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            meaning: meaning.into(),
            is_text: false,
        }
    }

    pub(crate) fn text(name: impl Into<String>, meaning: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            meaning: meaning.into(),
            is_text: true,
        }
    }
}

/// The signature of a function with these arguments, of which the last can be left out.
///
/// The arguments are listed because the information schema shows them. The types of a call are those of [`accepted`],
/// which come first and always fit: the engine would convert numbers to texts if it tried another list. A call without
/// arguments is accepted as well.
pub(crate) fn signature(arguments: &[Argument], volatility: Volatility) -> Signature {
    let all = arguments.iter().map(|argument| data_type(argument.is_text)).collect();
    let types = TypeSignature::OneOf(vec![
        TypeSignature::UserDefined,
        TypeSignature::Exact(all),
        TypeSignature::Nullary,
    ]);
    let mut signature = Signature::new(types, volatility);
    signature.parameter_names = Some(arguments.iter().map(|argument| argument.name.clone()).collect());
    signature
}

fn data_type(is_text: bool) -> DataType {
    if is_text { DataType::Utf8 } else { DataType::Float64 }
}

/// The types to which the arguments of a call are converted: numbers to doubles, and texts to one kind of text.
///
/// The first `required` arguments are numbers. After them texts and numbers may come in any order, so that a text can
/// be left out by a call that does not name its arguments.
pub(crate) fn coerced(
    function: &str,
    arguments: &[Argument],
    required: usize,
    types: &[DataType],
) -> Result<Vec<DataType>> {
    if types.len() < required || types.len() > arguments.len() {
        return plan_err!(
            "{function} takes {required} to {} arguments, and {} are given: {function}({})",
            arguments.len(),
            types.len(),
            names(arguments)
        );
    }
    let one = |(index, given): (usize, &DataType)| {
        let is_text = match given {
            DataType::Null => arguments[index].is_text,
            DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View => true,
            DataType::Dictionary(_, value) => {
                matches!(**value, DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View)
            }
            number if number.is_numeric() => false,
            other => {
                return plan_err!(
                    "argument {} of {function}, {}, is no number but {other}",
                    index + 1,
                    arguments[index].name
                );
            }
        };
        if is_text && index < required && !arguments[index].is_text {
            return plan_err!(
                "argument {} of {function}, {}, is a text instead of a number",
                index + 1,
                arguments[index].name
            );
        }
        Ok(data_type(is_text))
    };
    types.iter().enumerate().map(one).collect()
}

/// The types to which the arguments of a call are converted; those that are given, if the call is wrong.
///
/// The engine replaces an error of a conversion by another error, which names types and no arguments. So the function
/// itself reports the mistake, when it is asked for the type of its result.
pub(crate) fn accepted(coerced: Result<Vec<DataType>>, given: &[DataType]) -> Vec<DataType> {
    coerced.unwrap_or_else(|_| given.to_vec())
}

/// The names of arguments, separated by commas.
pub(crate) fn names(arguments: &[Argument]) -> String {
    let names: Vec<&str> = arguments.iter().map(|argument| argument.name.as_str()).collect();
    names.join(", ")
}

/// The numbers of an argument: one for all rows, or one for each row.
#[derive(Clone, Debug)]
pub(crate) enum Numbers {
    /// The same for all rows, or null.
    Same(Option<f64>),
    /// One for each row. There are at least [`FEWEST_ROWS`].
    Each(Float64Array),
}

impl Numbers {
    pub(crate) fn new(value: &ColumnarValue) -> Result<Self> {
        match value {
            ColumnarValue::Scalar(ScalarValue::Float64(number)) => Ok(Self::Same(*number)),
            ColumnarValue::Array(array) => {
                if let Some(numbers) = array.as_primitive_opt::<Float64Type>() {
                    return Ok(Self::Each(padded(numbers)));
                }
                exec_err!("expected a column of numbers, found {}", array.data_type())
            }
            ColumnarValue::Scalar(other) => exec_err!("expected a number, found {}", other.data_type()),
        }
    }

    /// The numbers as a column. A null is NaN, and its row is masked later.
    pub(crate) fn column(&self) -> Column<'_> {
        match self {
            Self::Same(number) => Column::Same(number.unwrap_or(f64::NAN)),
            Self::Each(numbers) => Column::Each(numbers.values()),
        }
    }

    /// The number of a row, NaN if it is null.
    pub(crate) fn at(&self, row: usize) -> f64 {
        match self {
            Self::Same(number) => number.unwrap_or(f64::NAN),
            Self::Each(numbers) if numbers.is_null(row) => f64::NAN,
            Self::Each(numbers) => numbers.value(row),
        }
    }
}

/// The same numbers, with the last one repeated up to [`FEWEST_ROWS`].
fn padded(numbers: &Float64Array) -> Float64Array {
    if numbers.len() >= FEWEST_ROWS || numbers.is_empty() {
        return numbers.clone();
    }
    let last = numbers.value(numbers.len() - 1);
    let mut values = numbers.values().to_vec();
    values.resize(FEWEST_ROWS, last);
    Float64Array::from(values)
}

/// The texts of an argument.
#[derive(Clone, Debug)]
pub(crate) enum Texts {
    /// The same for all rows, or null.
    Same(Option<String>),
    /// One for each row.
    Each(ArrayRef),
}

impl Texts {
    pub(crate) fn new(value: &ColumnarValue) -> Result<Self> {
        match value {
            ColumnarValue::Scalar(ScalarValue::Utf8(text)) => Ok(Self::Same(text.clone())),
            ColumnarValue::Array(array) if array.data_type() == &DataType::Utf8 => Ok(Self::Each(Arc::clone(array))),
            ColumnarValue::Array(array) => exec_err!("expected a column of texts, found {}", array.data_type()),
            ColumnarValue::Scalar(other) => exec_err!("expected a text, found {}", other.data_type()),
        }
    }

    /// The text of a row, `None` if it is null.
    pub(crate) fn at(&self, row: usize) -> Option<&str> {
        match self {
            Self::Same(text) => text.as_deref(),
            Self::Each(array) => array.is_valid(row).then(|| array.as_string::<i32>().value(row)),
        }
    }

    /// The different texts, each with its rows; `None` for the rows if these are all.
    pub(crate) fn groups(&self, rows: usize) -> Vec<(Option<&str>, Option<Vec<usize>>)> {
        if matches!(self, Self::Same(_)) {
            return vec![(self.at(0), None)];
        }
        let mut groups: Vec<(Option<&str>, Vec<usize>)> = Vec::new();
        for row in 0..rows {
            let text = self.at(row);
            match groups.iter_mut().find(|group| group.0 == text) {
                Some(group) => group.1.push(row),
                None => groups.push((text, vec![row])),
            }
        }
        groups.into_iter().map(|(text, rows)| (text, Some(rows))).collect()
    }
}

/// The rows in which no argument is null; `None` if these are all rows.
pub(crate) fn valid_rows(arguments: &[ColumnarValue], rows: usize) -> Option<NullBuffer> {
    let mut valid: Option<NullBuffer> = None;
    for argument in arguments {
        match argument {
            ColumnarValue::Scalar(value) if value.is_null() => return Some(NullBuffer::new_null(rows)),
            ColumnarValue::Scalar(_) => {}
            ColumnarValue::Array(array) => valid = NullBuffer::union(valid.as_ref(), array.logical_nulls().as_ref()),
        }
    }
    valid.filter(|valid| valid.null_count() > 0)
}
