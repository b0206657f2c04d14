//! What a batch is given: numbers and arrays of Python, which broadcast against each other.

use kin_core::any::Quantity;
use kin_core::batch::Column;
use numpy::{PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::arguments;

/// One number for all poses, or an array with one for each that nobody else has.
pub(super) enum Values<'py> {
    Same(f64),
    Each(PyReadonlyArrayDyn<'py, f64>),
}

impl Values<'_> {
    pub(super) fn column(&self) -> PyResult<Column<'_>> {
        Ok(match self {
            Self::Same(value) => Column::Same(*value),
            Self::Each(values) => Column::Each(values.as_slice()?),
        })
    }
}

/// Numbers of Python as an array of NumPy, of any shape.
fn as_array<'py>(numpy: &Bound<'py, PyAny>, value: &Bound<'py, PyAny>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    let array = numpy.call_method1("asarray", (value,)).map_err(|error| {
        let py = value.py();
        PyValueError::new_err(format!("`{name}`: {}", error.value(py)))
    })?;
    let dtype = array.getattr("dtype")?;
    let kind: String = dtype.getattr("kind")?.extract()?;
    if !["f", "i", "u"].contains(&kind.as_str()) {
        return Err(PyTypeError::new_err(format!(
            "`{name}` is an array of {dtype}: give real numbers"
        )));
    }
    Ok(array)
}

/// The values of all arguments, broadcast against each other, and their shape.
pub(super) fn broadcast<'py>(
    py: Python<'py>,
    given: &[(Bound<'py, PyAny>, String)],
) -> PyResult<(Vec<Values<'py>>, Vec<usize>)> {
    let numpy = py.import("numpy")?.into_any();
    let arrays = given.iter().map(|(value, name)| as_array(&numpy, value, name));
    let arrays = arrays.collect::<PyResult<Vec<_>>>()?;
    let shapes = arrays
        .iter()
        .map(|array| array.getattr("shape"))
        .collect::<PyResult<Vec<_>>>()?;
    let shape = numpy
        .call_method1("broadcast_shapes", PyTuple::new(py, &shapes)?)
        .map_err(|_| {
            let shapes = given
                .iter()
                .zip(&shapes)
                .filter(|(_, shape)| shape.len().unwrap_or(0) > 0);
            let shapes: Vec<String> = shapes.map(|((_, name), shape)| format!("{name} {shape}")).collect();
            PyValueError::new_err(format!(
                "these shapes do not broadcast against each other: {}",
                shapes.join(", ")
            ))
        })?;
    let float = numpy.getattr("float64")?;
    let mut values = Vec::with_capacity(arrays.len());
    for array in &arrays {
        if array.getattr("ndim")?.extract::<usize>()? == 0 {
            values.push(Values::Same(array.call_method0("item")?.extract()?));
            continue;
        }
        let whole = numpy.call_method1("broadcast_to", (array, &shape))?;
        let keywords = PyDict::new(py);
        keywords.set_item("dtype", &float)?;
        keywords.set_item("order", "C")?;
        // a copy, because other threads of Python may write to the array while this one solves
        let own = numpy.call_method("array", (whole,), Some(&keywords))?;
        let own = own.cast_into::<PyArrayDyn<f64>>().map_err(PyErr::from)?;
        values.push(Values::Each(own.readonly()));
    }
    Ok((values, shape.extract()?))
}

/// The numbers of an input: one for each order, each of which may be an array.
pub(super) fn motion<'py>(
    value: &Bound<'py, PyAny>,
    quantity: &Quantity<'_>,
    orders: usize,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let name = quantity.name;
    let Ok(tuple) = value.cast::<PyTuple>() else {
        if value.is_instance_of::<pyo3::types::PyList>() {
            return Err(PyTypeError::new_err(format!(
                "`{name}` is a list, which could mean two things: write a tuple for position and derivatives, as in \
                 `{name}=(angles, 10.0)`, and `numpy.array([…])` for many positions"
            )));
        }
        return Ok(vec![arguments::without_unit(value, quantity, 0)?]);
    };
    let count = tuple.len();
    if count == 0 || count > orders {
        return Err(PyValueError::new_err(format!(
            "`{name}` has {count} entries: give its position, and behind it up to {} derivatives with respect to time",
            orders - 1
        )));
    }
    let rates = tuple.iter().enumerate();
    rates
        .map(|(order, value)| arguments::without_unit(&value, quantity, order))
        .collect()
}
