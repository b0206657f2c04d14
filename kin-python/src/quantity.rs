//! Quantities along a sweep, and questions to them.

use kin_core::Dimension;
use kin_core::any::Description;
use kin_core::extremes::{ExtremesError, Over};
use kin_core::reaction::{ReactionError, ReactionPart};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};

use crate::answers::{self, answer, shown};
use crate::arrays::array;
use crate::declared::measure;
use crate::fault;
use crate::loads::{Loads, part_name};
use crate::made::Reduced;
use crate::sweep::{Sweep, ask};

/// What is asked of a sweep.
#[derive(Clone, Debug)]
pub(crate) enum Asked {
    Name(String),
    TransmissionAngle(usize),
    OfLoads(Box<Loads>, OfLoads),
}

/// What loads cause.
#[derive(Clone, Debug)]
pub(crate) enum OfLoads {
    /// The effort of the drive of an input, in an order.
    Effort(usize, usize),
    /// The power of the drive of an input.
    Power(usize),
    /// A part of the force in a joint, in an order.
    Reaction(String, ReactionPart, usize),
    /// The power that friction turns into heat.
    Heat,
}

/// A quantity along a sweep. `kin.Sweep.of` makes it.
#[pyclass(frozen, module = "kin")]
#[derive(Debug)]
pub(crate) struct Quantity {
    pub(crate) sweep: Sweep,
    pub(crate) asked: Asked,
}

/// Asks for a quantity along a sweep. Efforts and powers without friction may have an answer of their own.
macro_rules! along {
    ($quantity:expr, $py:expr, |$along:ident| $answer:expr) => {
        along!($quantity, $py, |$along| $answer, |$along| $answer)
    };
    ($quantity:expr, $py:expr, |$along:ident| $answer:expr, |$effort:ident| $of_effort:expr) => {{
        let quantity: &Quantity = $quantity;
        let linkage = quantity.sweep.linkage.any();
        let found: Result<_, ExtremesError> = $py.detach(|| {
            ask!(&quantity.sweep, |sweep| match &quantity.asked {
                Asked::Name(name) => {
                    let $along = sweep.of(name);
                    $answer
                }
                Asked::TransmissionAngle(dyad) => {
                    let $along = sweep.of_transmission_angle(*dyad);
                    $answer
                }
                Asked::OfLoads(loads, OfLoads::Effort(input, order)) if !loads.has_friction() => {
                    let $effort = sweep.of_effort(&loads.named, *input, *order);
                    $of_effort
                }
                Asked::OfLoads(loads, OfLoads::Power(input)) if !loads.has_friction() => {
                    let $effort = sweep.of_power(&loads.named, *input);
                    $of_effort
                }
                Asked::OfLoads(loads, asked) => {
                    let reactions = loads.reactions(&linkage).map_err(at_once)?;
                    let $along = match asked {
                        OfLoads::Effort(input, order) => sweep.of_effort_with_friction(&reactions, *input, *order),
                        OfLoads::Power(input) => sweep.of_power_with_friction(&reactions, *input),
                        OfLoads::Reaction(joint, part, order) => sweep.of_reaction(&reactions, joint, *part, *order),
                        OfLoads::Heat => sweep.of_heat(&reactions, 0),
                    };
                    $answer
                }
            })
        });
        found.map_err(|error| fault::of_extremes($py, &quantity.sweep.linkage.declared.mechanism, &error))
    }};
}

/// The error of a question that no point of the sweep is to blame for.
fn at_once(error: Box<ReactionError>) -> ExtremesError {
    ExtremesError::Reaction { at: f64::NAN, error }
}

fn over(word: &str) -> PyResult<Over> {
    match word {
        "time" => Ok(Over::Time),
        "input" => Ok(Over::Input),
        _ => Err(PyValueError::new_err("a mean is taken over=\"time\" or over=\"input\"")),
    }
}

fn list<'py, T>(
    py: Python<'py>,
    found: &[T],
    of: impl Fn(&T) -> PyResult<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyList>> {
    PyList::new(py, found.iter().map(of).collect::<PyResult<Vec<_>>>()?)
}

impl Quantity {
    fn description(&self) -> &Description<'_> {
        self.sweep.linkage.declared.description()
    }
}

#[pymethods]
impl Quantity {
    /// The name of the quantity.
    #[getter]
    fn name(&self) -> String {
        let input = |index: usize| self.description().inputs[index].name;
        match &self.asked {
            Asked::Name(name) => name.clone(),
            Asked::TransmissionAngle(0) if self.sweep.linkage.any().dyad_count() == 1 => {
                "transmission angle".to_owned()
            }
            Asked::TransmissionAngle(dyad) => format!("transmission angle {dyad}"),
            Asked::OfLoads(_, OfLoads::Effort(index, _)) => format!("effort of {}", input(*index)),
            Asked::OfLoads(_, OfLoads::Power(index)) => format!("power of {}", input(*index)),
            Asked::OfLoads(_, OfLoads::Reaction(joint, part, _)) => format!("{} in {joint}", part_name(*part)),
            Asked::OfLoads(_, OfLoads::Heat) => "heat".to_owned(),
        }
    }

    /// What it measures, before it is derived: "angle", "length", "number", "force", "torque" or "power"; `None` if no
    /// quantity has this name.
    #[getter]
    fn measure(&self) -> Option<&'static str> {
        let is_angle = |index: usize| self.description().inputs[index].dimension == Dimension::Angle;
        Some(match &self.asked {
            Asked::Name(name) => measure(self.sweep.linkage.declared.column(name)?.0.dimension),
            Asked::TransmissionAngle(_) => "angle",
            Asked::OfLoads(_, OfLoads::Effort(index, _)) if is_angle(*index) => "torque",
            Asked::OfLoads(_, OfLoads::Effort(..)) => "force",
            Asked::OfLoads(_, OfLoads::Power(_) | OfLoads::Heat) => "power",
            Asked::OfLoads(_, OfLoads::Reaction(_, part, _)) => match part {
                ReactionPart::Force | ReactionPart::X | ReactionPart::Y | ReactionPart::Z => "force",
                _ => "torque",
            },
        })
    }

    /// The order of its derivative by time.
    #[getter]
    fn order(&self) -> usize {
        match &self.asked {
            Asked::Name(name) => self.sweep.linkage.declared.column(name).map_or(0, |(_, order)| order),
            Asked::OfLoads(_, OfLoads::Effort(_, order) | OfLoads::Reaction(_, _, order)) => *order,
            _ => 0,
        }
    }

    /// The sweep.
    #[getter]
    fn sweep(&self) -> Sweep {
        self.sweep.clone()
    }

    /// A plot over the sweep: see `kin.Sweep.plot`.
    #[pyo3(signature = (**options))]
    fn plot<'py>(slf: &Bound<'py, Self>, options: Option<&Bound<'py, PyDict>>) -> PyResult<Bound<'py, PyAny>> {
        shown(slf.py(), "plot", (slf.get().sweep(), (slf,)), options)
    }
    /// The value of the largest size, with its sign: a `kin.Peak`.
    fn peak<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        answers::peak(py, &along!(self, py, |along| along.peak())?)
    }

    /// The largest value: a `kin.Peak`.
    fn highest<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        answers::peak(py, &along!(self, py, |along| along.highest())?)
    }

    /// The smallest value: a `kin.Peak`.
    fn lowest<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        answers::peak(py, &along!(self, py, |along| along.lowest())?)
    }

    /// All extremes along the sweep: a list of `kin.Extreme`.
    fn extremes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let found = along!(self, py, |along| along.extremes())?;
        list(py, &found, |extreme| answers::extreme(py, extreme))
    }

    /// The points where the quantity crosses a level: a list of `kin.Crossing`.
    fn crossings<'py>(&self, py: Python<'py>, level: f64) -> PyResult<Bound<'py, PyList>> {
        let found = along!(self, py, |along| along.crossings(level))?;
        list(py, &found, |crossing| {
            answer(py, "Crossing", (crossing.at, crossing.is_rising))
        })
    }

    /// The parts of the sweep on which the quantity stays within a tolerance of a level: a list of `kin.Dwell`.
    fn dwells<'py>(&self, py: Python<'py>, level: f64, tolerance: f64) -> PyResult<Bound<'py, PyList>> {
        let found = along!(self, py, |along| along.dwells(level, tolerance))?;
        list(py, &found, |dwell| {
            answer(py, "Dwell", (dwell.from, dwell.to, dwell.duration))
        })
    }

    /// The mean over the time, or over the way of the first input: a `kin.Mean`.
    #[pyo3(signature = (over="time"))]
    fn mean<'py>(&self, py: Python<'py>, over: &str) -> PyResult<Bound<'py, PyAny>> {
        let over = self::over(over)?;
        let mean = along!(self, py, |along| along.mean(over))?;
        answer(py, "Mean", (mean.value, mean.error, mean.covered))
    }

    /// The root of the mean square over the time, or over the way of the first input: a `kin.Mean`.
    #[pyo3(signature = (over="time"))]
    fn rms<'py>(&self, py: Python<'py>, over: &str) -> PyResult<Bound<'py, PyAny>> {
        let over = self::over(over)?;
        let mean = along!(self, py, |along| along.rms(over))?;
        answer(py, "Mean", (mean.value, mean.error, mean.covered))
    }

    /// The values in all rows as an array, NaN where the mechanism does not close.
    fn column<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let values = along!(self, py, |along| along.column())?;
        let count = values.len();
        array(py, values, &[count])
    }

    /// The peak, and its derivatives with respect to every dimension: `kin.PeakSensitivities`.
    fn peak_sensitivities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let without = || PyTypeError::new_err("efforts and powers have no sensitivities");
        let found = along!(self, py, |along| along.peak_sensitivities().map(Some), |effort| {
            drop(effort);
            Ok(None)
        })?;
        let found = found.ok_or_else(without)?;
        let by = PyDict::new(py);
        let dimensions = self.description().parameters;
        for (dimension, sensitivity) in dimensions.iter().zip(&found.by) {
            by.set_item(
                dimension.name,
                answer(py, "Sensitivity", (sensitivity.value, sensitivity.at))?,
            )?;
        }
        let peak = answers::peak(py, &found.peak)?;
        answer(py, "PeakSensitivities", PyTuple::new(py, [peak, by.into_any()])?)
    }

    fn __repr__(&self) -> String {
        format!("<kin.Quantity {}>", self.name())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        let sweep = Bound::new(py, self.sweep.clone())?;
        let input = |index: usize| self.description().inputs[index].name;
        let (method, arguments) = match &self.asked {
            Asked::Name(name) => ("of", (name,).into_pyobject(py)?),
            Asked::TransmissionAngle(dyad) => ("of_transmission_angle", (dyad,).into_pyobject(py)?),
            Asked::OfLoads(loads, asked) => {
                let loads = loads.as_ref().clone();
                match asked {
                    OfLoads::Effort(index, order) => ("of_effort", (loads, input(*index), order).into_pyobject(py)?),
                    OfLoads::Power(index) => ("of_power", (loads, input(*index)).into_pyobject(py)?),
                    OfLoads::Reaction(joint, part, order) => {
                        let arguments = (loads, joint, part_name(*part), order);
                        ("of_reaction", arguments.into_pyobject(py)?)
                    }
                    OfLoads::Heat => ("of_heat", (loads,).into_pyobject(py)?),
                }
            }
        };
        Ok((sweep.getattr(method)?, arguments))
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}
