//! All circuits and branches of a linkage.

use std::sync::Arc;

use kin_core::any::{AssemblyChoice, Described};
use kin_core::cycle::{CircuitPeak, MeasureError};
use kin_core::linkage::{AnyCycle, AnyLinkage};
use pyo3::exceptions::{PyIndexError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use self_cell::self_cell;

use crate::answers::{answer, shown};
use crate::arguments::{column_name, input_index, number};
use crate::declared::Declared;
use crate::fault;
use crate::linkage::Linkage;
use crate::made::{Reduced, reduced};
use crate::pose::Pose;

self_cell! {
    /// A cycle with the mechanism that it borrows from.
    struct Searched {
        owner: Arc<Declared>,
        #[covariant]
        dependent: AnyCycle,
    }
}

/// All circuits and branches of a linkage over one input: where it closes, in which assemblies, and where these meet.
/// `kin.Linkage.cycle` makes it.
///
/// >>> import kin
/// >>> cycle = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60).cycle()
/// >>> cycle.is_complete, len(cycle.circuits), cycle.branches[0].is_full_revolution
/// (True, 2, True)
/// >>> round(cycle.stroke("theta4").length, 6)
/// 1.050717
#[pyclass(frozen, module = "kin")]
pub(crate) struct Cycle {
    linkage: Linkage,
    /// The inputs where the line begins, and the one that moves.
    start: Vec<f64>,
    moving: usize,
    searched: Searched,
}

impl Cycle {
    pub(crate) fn new(
        py: Python<'_>,
        linkage: Linkage,
        moving: Option<&str>,
        inputs: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let quantities = linkage.declared.description().inputs;
        let names = || quantities.iter().map(|input| input.name).collect::<Vec<_>>().join(", ");
        let moving = input_index(linkage.declared.description(), moving)?;
        let mut start = Vec::new();
        for (index, quantity) in quantities.iter().enumerate() {
            let name = quantity.name;
            match inputs.map(|inputs| inputs.get_item(name)).transpose()?.flatten() {
                Some(_) if index == moving => {
                    return Err(PyTypeError::new_err(format!("`{name}` moves: leave out its value")));
                }
                Some(value) => start.push(number(&value, quantity)?),
                None if index == moving => start.push(0.0),
                None => return Err(PyTypeError::new_err(format!("missing: input `{name}`"))),
            }
        }
        if inputs.map_or(0, PyDictMethods::len) + 1 > quantities.len() {
            return Err(PyTypeError::new_err(format!("inputs are {}", names())));
        }
        let searched = py.detach(|| {
            Searched::try_new(Arc::clone(&linkage.declared), |declared| {
                let direction: Vec<f64> = (0..start.len())
                    .map(|input| f64::from(u8::from(input == moving)))
                    .collect();
                AnyLinkage::new(&declared.mechanism, &linkage.parameters).cycle_along(&start, &direction)
            })
        });
        let searched = searched.map_err(|error| fault::of_solver(py, &linkage.declared.mechanism, &error))?;
        Ok(Self {
            linkage,
            start,
            moving,
            searched,
        })
    }

    fn found(&self) -> &AnyCycle<'_> {
        self.searched.borrow_dependent()
    }

    fn ask<T: Send>(
        &self,
        py: Python<'_>,
        question: impl FnOnce(&AnyCycle<'_>) -> Result<T, MeasureError> + Send,
    ) -> PyResult<T> {
        let found = self.found();
        py.detach(|| question(found)).map_err(|error| self.refused(py, &error))
    }

    fn refused(&self, py: Python<'_>, error: &MeasureError) -> PyErr {
        let mechanism = &self.linkage.declared.mechanism;
        match error {
            MeasureError::NoSuchCircuit => PyIndexError::new_err(error.to_string()),
            MeasureError::Extremes(error) => fault::of_extremes(py, mechanism, error),
            error => fault::of_answer(py, mechanism, error, None),
        }
    }
}

fn peak<'py>(py: Python<'py>, peak: &CircuitPeak) -> PyResult<Bound<'py, PyAny>> {
    answer(py, "CircuitPeak", (peak.value, peak.input, peak.branch))
}

#[pymethods]
impl Cycle {
    /// The linkage.
    #[getter]
    fn linkage(&self) -> Linkage {
        self.linkage.clone()
    }

    /// The name of the input that moves.
    #[getter]
    fn moving(&self) -> &str {
        self.linkage.declared.description().inputs[self.moving].name
    }

    /// The circuits: a tuple of `kin.Circuit`.
    #[getter]
    fn circuits<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let all = self.found().circuits().iter().map(|circuit| {
            let branches = PyTuple::new(py, circuit.branches())?;
            answer(
                py,
                "Circuit",
                (branches, circuit.is_closed(), circuit.input_revolutions()),
            )
        });
        PyTuple::new(py, all.collect::<PyResult<Vec<_>>>()?)
    }

    /// The branches: a tuple of `kin.Branch`.
    #[getter]
    fn branches<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let name = |index| self.linkage.declared.mechanism.assembly_name(index);
        let all = self.found().branches().iter().map(|branch| {
            let range = branch.range();
            let range = (*range.start(), *range.end());
            let assembly = branch.assembly().and_then(name);
            answer(
                py,
                "Branch",
                (range, assembly, branch.circuit(), branch.is_full_revolution()),
            )
        });
        PyTuple::new(py, all.collect::<PyResult<Vec<_>>>()?)
    }

    /// Whether it is proved that there is no other branch.
    #[getter]
    fn is_complete(&self) -> bool {
        self.found().is_complete()
    }

    /// The largest and the smallest value of a quantity along a circuit: a `kin.Stroke`.
    #[pyo3(signature = (name, circuit=0))]
    fn stroke<'py>(&self, py: Python<'py>, name: &str, circuit: usize) -> PyResult<Bound<'py, PyAny>> {
        let stroke = self.ask(py, |cycle| cycle.along(circuit).of(&column_name(name)).stroke())?;
        answer(py, "Stroke", (peak(py, &stroke.low)?, peak(py, &stroke.high)?))
    }

    /// The value of the largest size of a quantity along a circuit, with its sign: a `kin.CircuitPeak`.
    #[pyo3(signature = (name, circuit=0))]
    fn peak<'py>(&self, py: Python<'py>, name: &str, circuit: usize) -> PyResult<Bound<'py, PyAny>> {
        peak(
            py,
            &self.ask(py, |cycle| cycle.along(circuit).of(&column_name(name)).peak())?,
        )
    }

    /// The time of the advance of a quantity by that of its return, over a full revolution of the input.
    #[pyo3(signature = (name, circuit=0))]
    fn time_ratio(&self, py: Python<'_>, name: &str, circuit: usize) -> PyResult<f64> {
        self.ask(py, |cycle| cycle.along(circuit).of(&column_name(name)).time_ratio())
    }

    /// The smallest transmission angle along a circuit: a `kin.WorstTransmission`.
    #[pyo3(signature = (circuit=0))]
    fn worst_transmission<'py>(&self, py: Python<'py>, circuit: usize) -> PyResult<Bound<'py, PyAny>> {
        let worst = self.ask(py, |cycle| cycle.along(circuit).worst_transmission())?;
        let block = fault::named(worst.block, self.linkage.declared.description());
        answer(py, "WorstTransmission", (block, worst.angle, worst.input, worst.branch))
    }

    /// The pose of a branch at an input of its range, with an input that moves at a speed.
    #[pyo3(signature = (branch, input, speed=0.0))]
    fn pose(&self, py: Python<'_>, branch: usize, input: f64, speed: f64) -> PyResult<Pose> {
        let count = self.found().branches().len();
        if branch >= count {
            return Err(PyIndexError::new_err(format!("there are {count} branches")));
        }
        let found = self.found();
        let found = py.detach(|| found.position_on(branch, input));
        let unknowns = found.map_err(|error| fault::of_solver(py, &self.linkage.declared.mechanism, &error))?;
        let orders = self.linkage.declared.orders();
        let mut inputs = vec![0.0; self.start.len() * orders];
        for (motion, start) in inputs.chunks_exact_mut(orders).zip(&self.start) {
            motion[0] = *start;
        }
        inputs[self.moving * orders] = input;
        if let Some(velocity) = inputs[self.moving * orders..].get_mut(1).filter(|_| orders > 1) {
            *velocity = speed;
        }
        Pose::at(py, &self.linkage, inputs, &AssemblyChoice::Near(unknowns))
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        shown(slf.py(), "cycle_as_html", (slf,), None)
    }

    fn __repr__(&self) -> String {
        let cycle = self.found();
        format!(
            "<kin.Cycle of {} over {}: {} circuits, {} branches>",
            self.linkage.declared.description().name,
            self.moving(),
            cycle.circuits().len(),
            cycle.branches().len()
        )
    }

    /// A cycle is searched again where it is unpickled.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        let keywords = PyDict::new(py);
        let quantities = self.linkage.declared.description().inputs;
        for (index, (quantity, start)) in quantities.iter().zip(&self.start).enumerate() {
            if index != self.moving {
                keywords.set_item(quantity.name, start)?;
            }
        }
        keywords.set_item("moving", self.moving())?;
        let linkage = Bound::new(py, self.linkage.clone())?;
        reduced(linkage.getattr("cycle")?, [], &keywords)
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}
