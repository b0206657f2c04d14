//! A quantity with its derivatives with respect to time.

use kin_core::RATES;
use pyo3::exceptions::{PyAttributeError, PyIndexError, PyTypeError, PyValueError};
use pyo3::prelude::*;

use crate::arguments::Group;

/// A quantity of a pose, or of all poses of a batch, with its derivatives with respect to time: `position`, `velocity`,
/// `acceleration`, `jerk`, `snap`, as far as the declaration asks for them.
///
/// In a pose each of them is a float, or the array of the coordinates of a point. In a batch each is an array of the
/// shape of the batch, with the coordinates of a point as its first axis. Angles are in radians, lengths in the
/// mechanism's unit of length, and time in that of the speeds of the inputs.
///
/// >>> import kin
/// >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
/// >>> theta4 = linkage.solve(theta2=[1.0, 10.0], assembly="open").theta4
/// >>> theta4
/// theta4: 1.77753 rad
/// >>> theta4.velocity == theta4.derivative(1)
/// True
/// >>> float(theta4) == theta4.position
/// True
#[pyclass(frozen, module = "kin")]
pub(crate) struct Motion {
    name: String,
    unit: String,
    /// For each order a float, or an array.
    orders: Vec<Py<PyAny>>,
    is_point: bool,
}

impl Motion {
    pub(crate) fn new(group: &Group<'_>, unit: &str, orders: Vec<Py<PyAny>>) -> Self {
        Self {
            name: group.name.to_owned(),
            unit: unit.to_owned(),
            orders,
            is_point: group.is_point,
        }
    }

    fn order(&self, py: Python<'_>, order: usize) -> PyResult<Py<PyAny>> {
        match self.orders.get(order) {
            Some(value) => Ok(value.clone_ref(py)),
            None => Err(PyAttributeError::new_err(format!(
                "`{}` has no {}: it has {} derivatives here",
                self.name,
                order
                    .checked_sub(1)
                    .map_or("position", |rate| RATES.get(rate).unwrap_or(&"derivative")),
                self.orders.len() - 1
            ))),
        }
    }

    fn coordinate(&self, py: Python<'_>, index: usize, name: &str) -> PyResult<Self> {
        if !self.is_point {
            return Err(PyAttributeError::new_err(format!(
                "`{}` is no point, and has no `{name}`",
                self.name
            )));
        }
        let part = |value: &Py<PyAny>| -> PyResult<Py<PyAny>> {
            let entry = value.bind(py).get_item(index)?;
            // a number of NumPy becomes a float, as in all other motions
            let number = entry.extract::<f64>();
            match number {
                Ok(number) if entry.len().is_err() => Ok(number.into_pyobject(py)?.into_any().unbind()),
                _ => Ok(entry.unbind()),
            }
        };
        Ok(Self {
            name: format!("{}.{name}", self.name),
            unit: self.unit.clone(),
            orders: self.orders.iter().map(part).collect::<PyResult<_>>()?,
            is_point: false,
        })
    }
}

#[pymethods]
impl Motion {
    /// The name of the quantity.
    #[getter]
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// The value itself.
    #[getter]
    fn position(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.order(py, 0)
    }

    /// The first derivative with respect to time.
    #[getter]
    fn velocity(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.order(py, 1)
    }

    /// The second derivative with respect to time.
    #[getter]
    fn acceleration(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.order(py, 2)
    }

    /// The third derivative with respect to time.
    #[getter]
    fn jerk(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.order(py, 3)
    }

    /// The fourth derivative with respect to time.
    #[getter]
    fn snap(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.order(py, 4)
    }

    /// The derivative of an order; that of order 0 is the position.
    fn derivative(&self, py: Python<'_>, order: usize) -> PyResult<Py<PyAny>> {
        if order < self.orders.len() {
            return self.order(py, order);
        }
        Err(PyIndexError::new_err(format!(
            "`{}` has derivatives up to order {} here",
            self.name,
            self.orders.len() - 1
        )))
    }

    /// All orders, the position first.
    #[getter]
    pub(crate) fn derivatives<'py>(&self, py: Python<'py>) -> Vec<Bound<'py, PyAny>> {
        self.orders.iter().map(|value| value.bind(py).clone()).collect()
    }

    /// The first coordinate of a point.
    #[getter]
    fn x(&self, py: Python<'_>) -> PyResult<Self> {
        self.coordinate(py, 0, "x")
    }

    /// The second coordinate of a point.
    #[getter]
    fn y(&self, py: Python<'_>) -> PyResult<Self> {
        self.coordinate(py, 1, "y")
    }

    /// The third coordinate of a point in space.
    #[getter]
    fn z(&self, py: Python<'_>) -> PyResult<Self> {
        match self.orders[0].bind(py).len() {
            Ok(3) => self.coordinate(py, 2, "z"),
            _ => Err(PyAttributeError::new_err(format!(
                "`{}` is no point in space, and has no `z`",
                self.name
            ))),
        }
    }

    fn __float__(&self, py: Python<'_>) -> PyResult<f64> {
        self.orders[0]
            .extract(py)
            .map_err(|_| PyTypeError::new_err(format!("`{}` is more than one number: take its `position`", self.name)))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let value = self.orders[0].bind(py);
        let shown = if let Ok(number) = value.extract::<f64>() {
            let shown = value.call_method1("__format__", (".6g",));
            shown.map_or(number.to_string(), |text| text.to_string())
        } else if self.is_point && value.getattr("ndim")?.extract::<usize>()? == 1 {
            value.str()?.to_string()
        } else {
            format!("array of the shape {}", value.getattr("shape")?)
        };
        let space = if self.unit.is_empty() { "" } else { " " };
        Ok(format!("{}: {shown}{space}{}", self.name, self.unit))
    }

    #[expect(clippy::type_complexity, reason = "as pickle wants it")]
    fn __reduce__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyAny>, (&str, &str, Vec<Bound<'py, PyAny>>, bool))> {
        let restore = py.import("kin._kin")?.getattr("restored_motion")?;
        Ok((restore, (&self.name, &self.unit, self.derivatives(py), self.is_point)))
    }
}

/// A motion that was pickled.
#[pyfunction]
pub(crate) fn restored_motion(name: String, unit: String, orders: Vec<Py<PyAny>>, is_point: bool) -> PyResult<Motion> {
    if orders.is_empty() {
        return Err(PyValueError::new_err("a motion has a position"));
    }
    Ok(Motion {
        name,
        unit,
        orders,
        is_point,
    })
}
