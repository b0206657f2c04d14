//! The fields of a call that a query uses, as a last argument which the optimizer writes.

use datafusion::arrow::array::AsArray;
use datafusion::arrow::datatypes::DataType;
use datafusion::common::ScalarValue;
use datafusion::logical_expr::{ColumnarValue, Expr};

/// The argument that names some fields.
pub(crate) fn argument<'f>(fields: impl IntoIterator<Item = &'f str>) -> Expr {
    let fields: Vec<ScalarValue> = fields.into_iter().map(ScalarValue::from).collect();
    Expr::Literal(
        ScalarValue::List(ScalarValue::new_list_nullable(&fields, &DataType::Utf8)),
        None,
    )
}

/// The types of the other arguments, and that of this one if it is there.
pub(crate) fn split_types(types: &[DataType]) -> (&[DataType], Option<&DataType>) {
    match types.split_last() {
        Some((last @ DataType::List(_), others)) => (others, Some(last)),
        _ => (types, None),
    }
}

/// The other arguments, and the names of the fields. All fields are wanted if there are no names.
pub(crate) fn split(arguments: &[ColumnarValue]) -> (&[ColumnarValue], Option<Vec<String>>) {
    match arguments.split_last() {
        Some((ColumnarValue::Scalar(ScalarValue::List(list)), others)) => {
            let names = list.value(0);
            let names = names.as_string::<i32>().iter().flatten().map(str::to_owned).collect();
            (others, Some(names))
        }
        _ => (arguments, None),
    }
}
