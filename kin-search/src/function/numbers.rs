//! Results that consist of numbers: a structure with a column for each.

use std::sync::Arc;

use datafusion::arrow::array::{ArrayRef, Float64Builder, StructArray};
use datafusion::arrow::datatypes::{DataType, Field, Fields};
use datafusion::common::Result;

use super::search::Call;

/// Fields of numbers, any of which may be null.
pub(crate) fn fields<const N: usize>(names: [&str; N]) -> Fields {
    names
        .map(|name| Field::new(name, DataType::Float64, true))
        .to_vec()
        .into()
}

/// The structures of all rows of a call.
pub(crate) fn rows<const N: usize>(
    fields: &Fields,
    call: &Call<'_>,
    mut row: impl FnMut(usize) -> Result<[Option<f64>; N]>,
) -> Result<StructArray> {
    let mut builders = [(); N].map(|()| Float64Builder::with_capacity(call.rows));
    for index in 0..call.rows {
        for (builder, number) in builders.iter_mut().zip(row(index)?) {
            builder.append_option(number);
        }
    }
    let columns = builders
        .iter_mut()
        .map(|builder| Arc::new(builder.finish()) as ArrayRef)
        .collect();
    Ok(StructArray::try_new_with_length(
        fields.clone(),
        columns,
        call.valid.clone(),
        call.rows,
    )?)
}
