//! How an object was made: by a call that makes it again, where it is unpickled.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

/// What `__reduce__` returns: something to call, and its arguments.
pub(crate) type Reduced<'py> = (Bound<'py, PyAny>, Bound<'py, PyTuple>);

/// Makes an object by a call with keywords, which pickle does not know by itself.
pub(crate) fn reduced<'py>(
    function: Bound<'py, PyAny>,
    arguments: impl IntoIterator<Item = Bound<'py, PyAny>>,
    keywords: &Bound<'py, PyDict>,
) -> PyResult<Reduced<'py>> {
    let py = function.py();
    let arguments: Vec<_> = std::iter::once(function).chain(arguments).collect();
    let partial = py.import("functools")?.getattr("partial")?;
    let made = partial.call(PyTuple::new(py, arguments)?, Some(keywords))?;
    Ok((made, PyTuple::empty(py)))
}

/// A call with values that nobody can change later.
#[derive(Clone, Debug)]
pub(crate) struct Call {
    /// The name of the function or the method.
    pub(crate) function: &'static str,
    pub(crate) arguments: Vec<Argument>,
    pub(crate) keywords: Vec<(String, f64)>,
}

/// A value in a call.
#[derive(Clone, Debug, IntoPyObject)]
pub(crate) enum Argument {
    Number(f64),
    Text(String),
    Numbers(Vec<f64>),
    Pairs(Vec<(f64, f64)>),
    Triple((f64, f64, f64)),
}

impl From<f64> for Argument {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<&str> for Argument {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl Call {
    pub(crate) fn new<const N: usize>(function: &'static str, arguments: [Argument; N]) -> Self {
        Self {
            function,
            arguments: arguments.into(),
            keywords: Vec::new(),
        }
    }

    pub(crate) fn with_keywords(self, keywords: impl IntoIterator<Item = (String, f64)>) -> Self {
        Self {
            keywords: keywords.into_iter().collect(),
            ..self
        }
    }

    /// The arguments of the call, and its keywords.
    pub(crate) fn arguments<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        let keywords = PyDict::new(py);
        for (name, value) in &self.keywords {
            keywords.set_item(name, value)?;
        }
        Ok((PyTuple::new(py, self.arguments.iter().cloned())?, keywords))
    }
}
