//! The result of a batch.

use pyo3::exceptions::{PyAttributeError, PyKeyError};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::motion::Motion;

/// Many poses: unknowns and outputs as attributes, each a `kin.Motion` of arrays. `kin.Mechanism.solve_batch` makes it.
#[pyclass(frozen, module = "kin")]
pub(crate) struct Batch {
    pub(super) motions: Vec<(String, Py<Motion>)>,
    pub(super) shape: Vec<usize>,
    pub(super) solved: Py<PyAny>,
    pub(super) margin: Py<PyAny>,
    pub(super) singular: Py<PyAny>,
    pub(super) first_failure: Option<(usize, Py<PyAny>)>,
}

impl Batch {
    fn find(&self, py: Python<'_>, name: &str) -> PyResult<Option<Py<PyAny>>> {
        for (motion, value) in &self.motions {
            if motion == name {
                return Ok(Some(value.clone_ref(py).into_any()));
            }
        }
        let Some((point, coordinate)) = name.rsplit_once('.') else {
            return Ok(None);
        };
        match self.motions.iter().find(|(motion, _)| motion == point) {
            Some((_, value)) => Ok(Some(value.bind(py).getattr(coordinate)?.unbind())),
            None => Ok(None),
        }
    }

    fn none_called(&self, name: &str) -> String {
        let all: Vec<&str> = self.motions.iter().map(|(name, _)| name.as_str()).collect();
        format!(
            "no unknown and no output is called `{name}`: there are {}",
            all.join(", ")
        )
    }
}

#[pymethods]
impl Batch {
    /// The shape to which dimensions and inputs were broadcast.
    #[getter]
    fn shape<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.shape)
    }

    /// Where the mechanism closes: an array of bools. Elsewhere all numbers are NaN.
    #[getter]
    fn solved(&self, py: Python<'_>) -> Py<PyAny> {
        self.solved.clone_ref(py)
    }

    /// Where the position is singular, for example a limit position: an array of bools.
    #[getter]
    fn singular(&self, py: Python<'_>) -> Py<PyAny> {
        self.singular.clone_ref(py)
    }

    /// The missing length where the mechanism is out of reach, as a negative number; NaN elsewhere.
    #[getter]
    fn margin(&self, py: Python<'_>) -> Py<PyAny> {
        self.margin.clone_ref(py)
    }

    /// The flat index of the first pose that was not found, with its `kin.SolveError`, or `None`.
    #[getter]
    fn first_failure(&self, py: Python<'_>) -> Option<(usize, Py<PyAny>)> {
        let (index, error) = self.first_failure.as_ref()?;
        Some((*index, error.clone_ref(py)))
    }

    fn __len__(&self) -> usize {
        self.shape.first().copied().unwrap_or(1)
    }

    fn __getattr__(&self, py: Python<'_>, name: &str) -> PyResult<Py<PyAny>> {
        self.find(py, name)?
            .ok_or_else(|| PyAttributeError::new_err(self.none_called(name)))
    }

    fn __getitem__(&self, py: Python<'_>, name: &str) -> PyResult<Py<PyAny>> {
        self.find(py, name)?
            .ok_or_else(|| PyKeyError::new_err(self.none_called(name)))
    }

    fn __dir__<'py>(slf: &Bound<'py, Self>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let mut names: Vec<Bound<'py, PyAny>> = slf.get_type().dir()?.iter().collect();
        for (name, _) in &slf.get().motions {
            names.push(name.into_pyobject(slf.py())?.into_any());
        }
        Ok(names)
    }

    fn __repr__(&self) -> String {
        let names: Vec<&str> = self.motions.iter().map(|(name, _)| name.as_str()).collect();
        let count: usize = self.shape.iter().product();
        format!("<kin.Batch of {count} poses: {}>", names.join(", "))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let motions = PyTuple::new(py, self.motions.iter().map(|(_, motion)| motion))?;
        let restore = py.import("kin._kin")?.getattr("restored_batch")?;
        let fields = (
            motions,
            &self.solved,
            &self.singular,
            &self.margin,
            self.first_failure(py),
        );
        Ok((restore, fields.into_pyobject(py)?))
    }
}

/// A batch that was pickled.
#[pyfunction]
pub(crate) fn restored_batch(
    motions: Vec<Bound<'_, Motion>>,
    solved: Bound<'_, PyAny>,
    singular: Py<PyAny>,
    margin: Py<PyAny>,
    first_failure: Option<(usize, Py<PyAny>)>,
) -> PyResult<Batch> {
    let named = motions.into_iter();
    let motions = named.map(|motion| (motion.get().name().to_owned(), motion.unbind()));
    Ok(Batch {
        motions: motions.collect(),
        shape: solved.getattr("shape")?.extract()?,
        solved: solved.unbind(),
        singular,
        margin,
        first_failure,
    })
}
