//! The mechanisms of the library.

use kin_core::in_small_letters;
use kin_studio::library::{DESIGNS, DesignAssembly};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// All mechanisms of the library by their names, as functions are called: the text that declares each, and dimensions,
/// inputs, and an assembly or values nearby for which it closes.
#[pyfunction]
pub(crate) fn library_designs(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let all = PyDict::new(py);
    for design in DESIGNS {
        let choice = PyDict::new(py);
        match design.assembly {
            DesignAssembly::Named(name) => choice.set_item("assembly", name)?,
            DesignAssembly::Near(near) => choice.set_item("near", PyList::new(py, near)?)?,
        }
        let numbers = [design.parameters, design.inputs].map(<[f64]>::to_vec);
        all.set_item(
            in_small_letters(design.name, '_'),
            (design.declaration(), numbers, choice),
        )?;
    }
    Ok(all)
}
