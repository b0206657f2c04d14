//! A declared mechanism.

use std::sync::{Arc, OnceLock};

use kin_core::any::{Described, Description, Pictured, Quantity};
use kin_core::{Dimension, RATES};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::answers::shown;
use crate::arguments::{self, Wanted, groups};
use crate::batch::{self, Batch, Wishes};
use crate::code::{Language, code};
use crate::fault;
use crate::linkage::Linkage;

/// A mechanism and the text that declares it.
#[derive(Debug)]
pub(crate) struct Declared {
    pub(crate) mechanism: kin_live::Mechanism,
    pub(crate) text: String,
    fitted: OnceLock<&'static kin_live::Mechanism>,
}

impl Declared {
    pub(crate) fn description(&self) -> &Description<'_> {
        self.mechanism.description()
    }

    /// The mechanism for fits, which ask for one that stays. Once asked for, it stays in memory.
    pub(crate) fn for_fits(self: &Arc<Self>) -> &'static kin_live::Mechanism {
        self.fitted.get_or_init(|| {
            let kept: &'static Arc<Self> = Box::leak(Box::new(Arc::clone(self)));
            &kept.mechanism
        })
    }

    /// The quantity of a column of tables, and the order of its derivative.
    pub(crate) fn column(&self, name: &str) -> Option<(&Quantity<'_>, usize)> {
        let description = self.description();
        let kinds = [description.inputs, description.unknowns, description.outputs];
        kinds.into_iter().flatten().find_map(|quantity| {
            let order = match name.strip_prefix(quantity.name)? {
                "" => 0,
                rest => 1 + RATES.iter().position(|rate| rest.strip_prefix('_') == Some(*rate))?,
            };
            Some((quantity, order))
        })
    }

    /// The number of derivatives, and one for the position.
    pub(crate) fn orders(&self) -> usize {
        self.description().order + 1
    }
}

/// A mechanism: loop closure equations, from which positions and all derivatives are solved.
///
/// The text is the one between the braces of `mechanism! { … }` in Rust. With dimensions a mechanism becomes a linkage.
/// Mistakes of the text are a `kin.DeclarationError`.
///
/// >>> import kin
/// >>> slider_crank = kin.Mechanism("""
/// ...     struct SliderCrank { r: Length, l: Length }
/// ...     input theta: Angle;
/// ...     unknown phi: Angle, s: Length;
/// ...     r * cis(theta) + l * cis(phi) == vec2(s, 0);
/// ... """)
/// >>> slider_crank.dimensions, slider_crank.inputs, slider_crank.unknowns
/// (('r', 'l'), ('theta',), ('phi', 's'))
/// >>> press = slider_crank(r=0.1, l=0.3)
/// >>> round(press.solve(theta=0.0, assembly="open").s.position, 12)
/// 0.4
#[pyclass(frozen, module = "kin")]
pub(crate) struct Mechanism {
    pub(crate) declared: Arc<Declared>,
}

/// The word for what a quantity measures.
pub(crate) fn measure(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::Angle => "angle",
        Dimension::Length => "length",
        Dimension::Scalar => "number",
    }
}

fn names<'py>(py: Python<'py>, quantities: &[Quantity<'_>]) -> PyResult<Bound<'py, PyTuple>> {
    PyTuple::new(py, groups(quantities).iter().map(|group| group.name))
}

#[pymethods]
impl Mechanism {
    #[new]
    fn new(py: Python<'_>, text: String) -> PyResult<Self> {
        match py.detach(|| kin_live::Mechanism::declare(&text)) {
            Ok(mechanism) => Ok(Self {
                declared: Arc::new(Declared {
                    mechanism,
                    text,
                    fitted: OnceLock::new(),
                }),
            }),
            Err(error) => Err(fault::of_declaration(py, &error, &text)),
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
    /// >>> import kin, numpy as np
    /// >>> cranks = np.linspace(20, 50, 5)[:, None]
    /// >>> angles = np.linspace(0, 2 * np.pi, 100)
    /// >>> batch = kin.library.four_bar.solve_batch(
    /// ...     r1=90, r2=cranks, r3=70, r4=60, theta2=(angles, 10.0), assembly="open")
    /// >>> batch.theta4.jerk.shape
    /// (5, 100)
    /// >>> batch.solved.all(axis=1).tolist()
    /// [True, True, True, False, False]
    #[pyo3(signature = (*, assembly=None, near=None, order=None, threads=None, **given))]
    fn solve_batch(
        &self,
        py: Python<'_>,
        assembly: Option<&Bound<'_, PyAny>>,
        near: Option<&Bound<'_, PyAny>>,
        order: Option<usize>,
        threads: Option<usize>,
        given: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Batch> {
        let wishes = Wishes {
            assembly,
            near,
            order,
            threads,
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
