//! Tables of sweeps.

use std::fmt::Write as _;

use kin_core::batch::Outcome;
use kin_core::sweep::{ColumnOf, Table as CoreTable};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyDict, PyList, PyTuple};

use crate::answers::answer;
use crate::arguments::column_name;
use crate::arrays::array;
use crate::arrow;
use crate::fault::{self, named};
use crate::sweep::{Sweep, ask};

/// A table of a sweep: a column for the position and each derivative of every quantity, NaN where the mechanism does
/// not close.
///
/// `table["theta4_jerk"]` is a column as an array, which is read-only: copy it to change it. pandas and polars take the
/// table by `to_pandas` and `to_polars`.
///
/// >>> import kin
/// >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
/// >>> table = linkage.sweep(theta2=(0.0, 6.0), rows=7, speed=10.0, assembly="open").table()
/// >>> len(table), table.names[:3]
/// (7, ('theta2', 'theta2_velocity', 'theta2_acceleration'))
/// >>> table["theta2"].tolist()
/// [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
#[pyclass(frozen, module = "kin")]
pub(crate) struct Table {
    sweep: Sweep,
    rows: CoreTable,
    columns: Vec<(String, Py<PyAny>)>,
    /// The names of blocks at the limits.
    blocks: Vec<String>,
    /// The methods that changed its units.
    changes: Vec<Change>,
}

/// A change of the units of a table.
#[derive(Clone)]
enum Change {
    Degrees,
    Units { length: String, time: String },
}

/// The rows at the beginning and at the end that are shown.
const SHOWN: usize = 5;

impl Table {
    /// The table of a sweep.
    pub(crate) fn of(py: Python<'_>, sweep: &Sweep) -> PyResult<Self> {
        let declared = &sweep.linkage.declared;
        let rows = py.detach(|| ask!(sweep, |sweep| sweep.table(&declared.mechanism)));
        let rows = rows.map_err(|error| fault::of_answer(py, &declared.mechanism, error, None))?;
        let limits = rows.limits().iter();
        let blocks = limits.map(|limit| named(limit.block, declared.description()));
        Ok(Self {
            columns: columns(py, &rows)?,
            blocks: blocks.collect(),
            rows,
            sweep: sweep.clone(),
            changes: Vec::new(),
        })
    }

    fn changed(&self, py: Python<'_>, change: Change) -> PyResult<Self> {
        let rows = self.rows.clone();
        let rows = match &change {
            Change::Degrees => rows.in_degrees(),
            Change::Units { length, time } => rows.units(length.as_str(), time.as_str()),
        };
        Ok(Self {
            columns: columns(py, &rows)?,
            blocks: self.blocks.clone(),
            rows,
            sweep: self.sweep.clone(),
            changes: self.changes.iter().cloned().chain([change]).collect(),
        })
    }

    fn mask(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        let outcomes = (0..self.rows.count()).map(|row| self.rows.outcome(row).is_some_and(|row| row.is_solved()));
        Ok(array(py, outcomes.collect::<Vec<bool>>(), &[self.rows.count()])?.unbind())
    }

    /// The indices of the rows that are shown, with `None` for those between.
    fn shown(&self) -> Vec<Option<usize>> {
        let count = self.rows.count();
        if count <= 2 * SHOWN + 1 {
            return (0..count).map(Some).collect();
        }
        let before = (0..SHOWN).map(Some);
        before.chain([None]).chain((count - SHOWN..count).map(Some)).collect()
    }
}

/// The columns as arrays. They are read-only, because every other view of the table has the same numbers.
fn columns(py: Python<'_>, rows: &CoreTable) -> PyResult<Vec<(String, Py<PyAny>)>> {
    let column = |column: ColumnOf<'_>| {
        let values = array(py, column.values.to_vec(), &[rows.count()])?;
        values.getattr("flags")?.setattr("writeable", false)?;
        Ok((column.label.to_string(), values.unbind()))
    };
    rows.columns().map(column).collect()
}

#[pymethods]
impl Table {
    /// The names of the columns.
    #[getter]
    fn names<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.columns.iter().map(|(name, _)| name))
    }

    /// The units of the columns, by their names: `L` is the mechanism's unit of length, `T` that of time.
    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let units = PyDict::new(py);
        for column in self.rows.columns() {
            units.set_item(column.label.to_string(), column.unit.to_string())?;
        }
        Ok(units)
    }

    /// The rows in which the mechanism closes: an array of bools.
    #[getter]
    fn solved(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.mask(py)
    }

    /// The missing length in rows that do not close, as a negative number; NaN elsewhere.
    #[getter]
    fn margin<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let count = self.rows.count();
        let margins = (0..count).map(|row| self.rows.outcome(row).as_ref().and_then(Outcome::margin));
        array(py, margins.map(|margin| margin.unwrap_or(f64::NAN)).collect(), &[count])
    }

    /// The points between rows where the mechanism begins or ceases to close.
    #[getter]
    fn limits<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let limits = PyList::empty(py);
        for (limit, block) in self.rows.limits().iter().zip(&self.blocks) {
            let kind = limit.kind.to_string();
            let fields = (limit.at, kind, limit.row, limit.closes_before, block.as_str());
            limits.append(answer(py, "Limit", fields)?)?;
        }
        Ok(limits)
    }

    /// The table with degrees instead of radians, in all columns of angles and of their derivatives.
    fn in_degrees(&self, py: Python<'_>) -> PyResult<Self> {
        self.changed(py, Change::Degrees)
    }

    /// The table with names for the units of length and time. The numbers stay the same.
    fn in_units(&self, py: Python<'_>, length: String, time: String) -> PyResult<Self> {
        self.changed(py, Change::Units { length, time })
    }

    /// All columns by their names, as arrays.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for (name, values) in &self.columns {
            all.set_item(name, values)?;
        }
        Ok(all)
    }

    /// The table as a DataFrame of pandas.
    fn to_pandas<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        py.import("pandas")?.getattr("DataFrame")?.call1((self.to_dict(py)?,))
    }

    /// The table as a DataFrame of polars.
    fn to_polars<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        py.import("polars")?.getattr("DataFrame")?.call1((self.to_dict(py)?,))
    }

    /// The table as a stream of Arrow, which `pyarrow.table(table)` and `polars.DataFrame(table)` read.
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // a schema is a wish, and there is one kind of numbers
        let _ = requested_schema;
        let columns = self.rows.columns();
        arrow::stream(
            py,
            columns.map(|column| (column.label.to_string(), column.values.to_vec())),
        )
    }

    fn __getitem__(&self, py: Python<'_>, name: &str) -> PyResult<Py<PyAny>> {
        let name = &*column_name(name);
        match self.columns.iter().find(|(column, _)| column == name) {
            Some((_, values)) => Ok(values.clone_ref(py)),
            None => Err(match self.rows.column(name) {
                Err(error) => PyKeyError::new_err(error.to_string()),
                Ok(_) => PyKeyError::new_err(format!("name the column without its unit: `{name}`")),
            }),
        }
    }

    fn __contains__(&self, name: &str) -> bool {
        self.columns.iter().any(|(column, _)| *column == column_name(name))
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        Ok(self.names(py)?.try_iter()?.into_any())
    }

    fn __len__(&self) -> usize {
        self.rows.count()
    }

    fn __repr__(&self) -> String {
        format!(
            "<kin.Table of {} rows and {} columns>",
            self.rows.count(),
            self.columns.len()
        )
    }

    /// The rows are solved again where a table is unpickled.
    #[expect(clippy::type_complexity, reason = "as pickle wants it")]
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Sweep, Bound<'py, PyList>))> {
        let changes = PyList::empty(py);
        for change in &self.changes {
            match change {
                Change::Degrees => changes.append(("in_degrees", PyTuple::empty(py)))?,
                Change::Units { length, time } => changes.append(("in_units", (length, time)))?,
            }
        }
        let restore = py.import("kin._kin")?.getattr("restored_table")?;
        Ok((restore, (self.sweep.clone(), changes)))
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }

    fn _repr_html_(&self) -> String {
        let mut html = String::from("<table><thead><tr>");
        for column in self.rows.columns() {
            let _ = write!(html, "<th>{}</th>", escaped(&column.to_string()));
        }
        html += "</tr></thead><tbody>";
        for row in self.shown() {
            html += "<tr>";
            for column in self.rows.columns() {
                match row {
                    Some(row) => {
                        let _ = write!(html, "<td>{:.6}</td>", column.values[row]);
                    }
                    None => html += "<td>…</td>",
                }
            }
            html += "</tr>";
        }
        let _ = write!(html, "</tbody></table><p>{} rows</p>", self.rows.count());
        html
    }
}

/// A table that was pickled: that of a sweep, after methods of `kin.Table` with these arguments.
#[pyfunction]
pub(crate) fn restored_table<'py>(
    sweep: &Bound<'py, Sweep>,
    changes: Vec<(String, Bound<'py, PyTuple>)>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = sweep.py();
    let mut table = Bound::new(py, Table::of(py, sweep.get())?)?.into_any();
    for (method, arguments) in changes {
        table = table.call_method1(method.as_str(), arguments)?;
    }
    Ok(table)
}

/// A text as HTML, also between quotation marks.
pub(crate) fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    text.replace('"', "&quot;")
}
