//! What Python calls on a mechanism.

use std::sync::Arc;

use kin_core::any::{Described, Pictured, Quantity};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::answers::shown;
use crate::arguments::{self, Wanted, groups};
use crate::batch::{self, Batch, Wishes};
use crate::code::{Language, code};
use crate::declared::{Declared, measure};
use crate::fault;
use crate::linkage::Linkage;
use crate::mechanism::Mechanism;

fn names<'py>(py: Python<'py>, quantities: &[Quantity<'_>]) -> PyResult<Bound<'py, PyTuple>> {
    PyTuple::new(py, groups(quantities).iter().map(|group| group.name))
}

#[pymethods]
impl Mechanism {
    #[new]
    fn new(py: Python<'_>, text: String) -> PyResult<Self> {
        match py.detach(|| Declared::of(text)) {
            Ok(declared) => Ok(Self { declared }),
            Err((error, text)) => Err(fault::of_declaration(py, &error, &text)),
        }
    }

    /// The name of the structure in the declaration.
    #[getter]
    fn name(&self) -> &str {
        self.declared.description().name
    }

    /// The declaration.
    #[getter]
    fn text(&self) -> &str {
        &self.declared.text
    }

    /// The names of the dimensions. A point counts once.
    #[getter]
    fn dimensions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        names(py, self.declared.description().parameters)
    }

    /// The names of the inputs.
    #[getter]
    fn inputs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        names(py, self.declared.description().inputs)
    }

    /// The names of the unknowns.
    #[getter]
    fn unknowns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        names(py, self.declared.description().unknowns)
    }

    /// The names of the outputs. A point counts once.
    #[getter]
    fn outputs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        names(py, self.declared.description().outputs)
    }

    /// The names of the assemblies: empty if a position is chosen by values nearby, and one empty name if there is no
    /// choice.
    #[getter]
    fn assemblies<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.declared.mechanism.assembly_names())
    }

    /// The equations, as declared.
    #[getter]
    fn equations<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.declared.description().equations)
    }

    /// The highest derivative with respect to time: 4 is the snap.
    #[getter]
    fn order(&self) -> usize {
        self.declared.description().order
    }

    /// What an input, unknown or output measures, or a coordinate of a point: "angle", "length" or "number".
    fn measure_of(&self, name: &str) -> PyResult<&'static str> {
        match self.declared.column(name) {
            Some((quantity, 0)) => Ok(measure(quantity.dimension)),
            _ => Err(PyKeyError::new_err(format!("no quantity is called `{name}`"))),
        }
    }

    /// The mechanism with dimensions, each by its name. A point is given by its coordinates, as in `b=(3, 4)`.
    #[pyo3(signature = (**dimensions))]
    fn __call__(&self, dimensions: Option<&Bound<'_, PyDict>>) -> PyResult<Linkage> {
        let quantities = self.declared.description().parameters;
        let wanted = [Wanted {
            kind: "dimension",
            quantities,
        }];
        let values = arguments::values(dimensions, &wanted)?;
        let parameters = values[0].iter().zip(quantities);
        let parameters = parameters.map(|(value, quantity)| arguments::number(value, quantity));
        Ok(Linkage {
            declared: Arc::clone(&self.declared),
            parameters: parameters.collect::<PyResult<_>>()?,
        })
    }

    /// Many poses at once, on all cores: dimensions and inputs are numbers or arrays, which broadcast against each
    /// other. An input with derivatives is a tuple, as in `theta2=(angles, 10.0)`.
    ///
    /// The arrays of the result have the shape of the broadcast. Where the mechanism does not close they are NaN, and
    /// `solved` is false. With `order=0` only positions are given out. `threads=1` uses one core. The numbers are the
    /// same on any number of cores; the last bits may differ from those of `solve`.
    ///
    /// `out` has arrays of which the result is made, so that a loop allocates none: an earlier batch of the same shape
    /// and order, whose numbers are overwritten, or a dictionary of arrays by the names of unknowns and outputs. Each
    /// name has one array for each order, as in `out={"theta4": (positions, velocities)}`; `solved`, `singular` and
    /// `margin` have one. What is left out is allocated. Nothing else may use the arrays before the call returns.
    ///
    /// >>> import kin, numpy as np
    /// >>> cranks = np.linspace(20, 50, 5)[:, None]
    /// >>> angles = np.linspace(0, 2 * np.pi, 100)
    /// >>> batch = kin.library.four_bar.solve_batch(
    /// ...     r1=90, r2=cranks, r3=70, r4=60, theta2=(angles, 10.0), assembly="open")
    /// >>> batch.theta4.jerk.shape
    /// (5, 100)
    /// >>> batch.solved.all(axis=1).tolist()
    /// [True, True, True, False, False]
    /// >>> again = kin.library.four_bar.solve_batch(
    /// ...     r1=90, r2=cranks, r3=72, r4=60, theta2=(angles, 10.0), assembly="open", out=batch)
    /// >>> again.theta4.jerk is batch.theta4.jerk
    /// True
    #[expect(clippy::too_many_arguments, reason = "each is a keyword")]
    #[pyo3(signature = (*, assembly=None, near=None, order=None, threads=None, out=None, **given))]
    fn solve_batch(
        &self,
        py: Python<'_>,
        assembly: Option<&Bound<'_, PyAny>>,
        near: Option<&Bound<'_, PyAny>>,
        order: Option<usize>,
        threads: Option<usize>,
        out: Option<&Bound<'_, PyAny>>,
        given: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Batch> {
        let wishes = Wishes {
            assembly,
            near,
            order,
            threads,
            out,
        };
        batch::solve(py, &self.declared, None, given, &wishes)
    }

    /// The solver in C99, with the derivatives up to an order: a `kin.C` with header, source, and an example that calls
    /// it. It allocates nothing. Dimensions are arguments.
    ///
    /// >>> import kin
    /// >>> kin.library.slider_crank.to_c(order=1).name
    /// 'slider_crank'
    #[pyo3(signature = (order=None))]
    fn to_c<'py>(&self, py: Python<'py>, order: Option<usize>) -> PyResult<Bound<'py, PyAny>> {
        code(py, &self.declared, Language::C, order, None)
    }

    /// The solver as a module of JavaScript, with the derivatives up to an order.
    #[pyo3(signature = (order=None))]
    fn to_javascript<'py>(&self, py: Python<'py>, order: Option<usize>) -> PyResult<Bound<'py, PyAny>> {
        code(py, &self.declared, Language::JavaScript, order, None)
    }

    /// The solver as a module of Python that needs NumPy alone, with the derivatives up to an order.
    #[pyo3(signature = (order=None))]
    fn to_python<'py>(&self, py: Python<'py>, order: Option<usize>) -> PyResult<Bound<'py, PyAny>> {
        code(py, &self.declared, Language::Python, order, None)
    }

    /// The closure equations in MathML, as a browser sets them.
    #[getter]
    fn mathml(&self) -> &str {
        Pictured::formulas(&self.declared.mechanism).closure.mathml
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        shown(slf.py(), "mechanism_as_html", (slf,), None)
    }

    fn __repr__(&self) -> String {
        let description = self.declared.description();
        let list = |quantities| {
            groups(quantities)
                .iter()
                .map(|group| group.name)
                .collect::<Vec<_>>()
                .join(", ")
        };
        format!(
            "<kin.Mechanism {}({}): {} -> {}>",
            description.name,
            list(description.parameters),
            list(description.inputs),
            list(description.unknowns)
        )
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyAny>, (String,)) {
        (slf.get_type().into_any(), (slf.get().declared.text.clone(),))
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}
