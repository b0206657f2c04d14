//! Arrays of NumPy, from memory that Rust has allocated.

use numpy::{Element, PyArray1, PyArrayMethods};
use pyo3::prelude::*;

/// An array of a shape, which takes over the numbers without a copy. There are as many as the shape has entries.
pub(crate) fn array<'py, T: Element>(py: Python<'py>, values: Vec<T>, shape: &[usize]) -> PyResult<Bound<'py, PyAny>> {
    let flat = PyArray1::from_vec(py, values);
    Ok(flat.reshape(shape.to_vec())?.into_any())
}
