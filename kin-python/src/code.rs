//! Solvers in other languages.

use kin_core::tape::{Options, record_any};
use pyo3::prelude::*;

use crate::answers::answer;
use crate::declared::Declared;
use crate::fault;

/// The languages.
#[derive(Clone, Copy)]
pub(crate) enum Language {
    C,
    JavaScript,
    Python,
}

/// The solver in a language, of an order, with the dimensions as arguments or as these constants.
pub(crate) fn code<'py>(
    py: Python<'py>,
    declared: &Declared,
    language: Language,
    order: Option<usize>,
    dimensions: Option<&[f64]>,
) -> PyResult<Bound<'py, PyAny>> {
    let mut options = Options::new();
    if let Some(order) = order {
        options = options.up_to(order);
    }
    if let Some(dimensions) = dimensions {
        options = options.with_dimensions(dimensions);
    }
    let recorded = py.detach(|| record_any::<f64>(&declared.mechanism, &options));
    let tape = recorded.map_err(|error| fault::of_answer(py, &declared.mechanism, error, None))?;
    match language {
        Language::C => {
            let c = tape.c();
            answer(py, "C", (c.name, c.header, c.source, c.example))
        }
        Language::JavaScript => Ok(tape.java_script().into_pyobject(py)?.into_any()),
        Language::Python => Ok(tape.python().into_pyobject(py)?.into_any()),
    }
}
