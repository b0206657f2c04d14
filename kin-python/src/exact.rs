//! Tables that replace a solver.

use kin_core::exact::{ExactTable as CoreTable, LookupError, Precision};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyTuple};

use crate::arrays::array;

/// A table that replaces a solver: between its rows, values and derivatives are within the tolerance.
/// `kin.Sweep.exact_table` makes it.
///
/// >>> import kin
/// >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
/// >>> turn = linkage.sweep(theta2=(0, 6.283185307179586), assembly="open")
/// >>> table = turn.exact_table([1e-10, 1e-8, 1e-6, 1e-4])
/// >>> table.names, table.order
/// (('theta3', 'theta4'), 3)
/// >>> found = table.at(1.0, speed=10.0)    # a row for each name, a column for each derivative
/// >>> bool(abs(found[1, 3] - linkage.solve(theta2=(1.0, 10.0), assembly="open").theta4.jerk) < 0.1)
/// True
/// >>> kin.ExactTable(bytes(table)).rows == table.rows
/// True
#[pyclass(frozen, module = "kin")]
pub(crate) struct ExactTable {
    pub(crate) table: CoreTable,
}

/// The tolerances of a table: one for all orders, or one for each, of which there are then no more.
pub(crate) fn precision(tolerance: &Bound<'_, PyAny>) -> PyResult<Precision> {
    if let Ok(tolerance) = tolerance.extract::<f64>() {
        return Ok(tolerance.into());
    }
    let tolerances: Vec<f64> = tolerance.extract()?;
    match *tolerances.as_slice() {
        [value, first] => Ok([value, first].into()),
        [value, first, second] => Ok([value, first, second].into()),
        [value, first, second, third] => Ok([value, first, second, third].into()),
        [value, first, second, third, fourth] => Ok([value, first, second, third, fourth].into()),
        _ => Err(PyValueError::new_err(
            "give one tolerance, or a list of those of the value and 1 to 4 derivatives",
        )),
    }
}

fn refused(error: &LookupError) -> PyErr {
    PyValueError::new_err(error.to_string())
}

#[pymethods]
impl ExactTable {
    /// The table of bytes that `bytes(table)` gave, or that kin wrote elsewhere.
    #[new]
    fn new(data: Vec<u8>) -> PyResult<Self> {
        match CoreTable::from_bytes(data) {
            Ok(table) => Ok(Self { table }),
            Err(error) => Err(PyValueError::new_err(error.to_string())),
        }
    }

    /// The names of the columns.
    #[getter]
    fn names<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let names = self.table.columns().map(|column| column.name());
        PyTuple::new(py, names)
    }

    /// The highest derivative.
    #[getter]
    fn order(&self) -> usize {
        self.table.order()
    }

    /// The number of rows.
    #[getter]
    fn rows(&self) -> usize {
        self.table.rows()
    }

    /// The smallest and the largest value of the input, or of the time.
    #[getter]
    fn range(&self) -> (f64, f64) {
        let range = self.table.range();
        (*range.start(), *range.end())
    }

    /// The values of all columns with their derivatives: an array with a row for each name and a column for each order.
    /// Derivatives are those by the input, or by time at a speed of the input.
    #[pyo3(signature = (at, speed=None))]
    fn at<'py>(&self, py: Python<'py>, at: f64, speed: Option<f64>) -> PyResult<Bound<'py, PyAny>> {
        let shape = [self.table.columns().len(), self.table.order() + 1];
        let mut found = vec![0.0; shape[0] * shape[1]];
        let result = match speed {
            None => self.table.fill(at, &mut found),
            Some(speed) => self.table.fill_at_speed(at, speed, &mut found),
        };
        result.map_err(|error| refused(&error))?;
        array(py, found, &shape)
    }

    fn __bytes__<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, self.table.as_bytes())
    }

    fn __len__(&self) -> usize {
        self.table.rows()
    }

    fn __repr__(&self) -> String {
        format!(
            "<kin.ExactTable of {} in {} rows>",
            self.table.name(),
            self.table.rows()
        )
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyAny>, (Bound<'py, PyBytes>,)) {
        (slf.get_type().into_any(), (slf.get().__bytes__(slf.py()),))
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}
