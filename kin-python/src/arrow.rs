//! Tables for Arrow, by its C stream in a capsule: the data frames of others take them without a copy of kin's own.

use std::sync::Arc;

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{ArrayRef, Float64Array, RecordBatch, RecordBatchIterator};
use arrow_schema::{ArrowError, DataType, Field, Schema};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

/// A stream of one batch with these columns.
pub(crate) fn stream(
    py: Python<'_>,
    columns: impl Iterator<Item = (String, Vec<f64>)>,
) -> PyResult<Bound<'_, PyCapsule>> {
    let (fields, arrays): (Vec<Field>, Vec<ArrayRef>) = columns
        .map(|(name, values)| {
            let array: ArrayRef = Arc::new(Float64Array::from(values));
            (Field::new(name, DataType::Float64, false), array)
        })
        .unzip();
    let schema = Arc::new(Schema::new(fields));
    let refused = |error: ArrowError| PyRuntimeError::new_err(error.to_string());
    let batch = RecordBatch::try_new(Arc::clone(&schema), arrays).map_err(refused)?;
    let reader = RecordBatchIterator::new([Ok(batch)], schema);
    let stream = FFI_ArrowArrayStream::new(Box::new(reader));
    PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
}
