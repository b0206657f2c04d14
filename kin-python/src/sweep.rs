//! Sweeps, and questions to them.

use kin_core::any::{AssemblyChoice, Description};
use kin_core::extremes::{ExtremesError, Over};
use kin_core::law::Piecewise;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};

use crate::answers::{self, answer};
use crate::arguments::{self, Wanted};
use crate::arrays::array;
use crate::fault;
use crate::law::{Law, dwell};
use crate::linkage::Linkage;
use crate::table::Table;

/// A sweep: a linkage whose inputs move. `kin.Linkage.sweep` makes it.
///
/// >>> import kin
/// >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
/// >>> turn = linkage.sweep(theta2=(0, 2 * 3.141592653589793), rows=361, speed=10.0, assembly="open")
/// >>> peak = turn.of("theta4_jerk").peak()
/// >>> round(peak.at, 4), round(peak.value, 1), peak.kind
/// (6.1529, 1638.3, 'inner')
#[pyclass(frozen, module = "kin")]
#[derive(Clone, Debug)]
pub(crate) struct Sweep {
    linkage: Linkage,
    choice: AssemblyChoice,
    way: Way,
    rows: usize,
}

#[derive(Clone, Debug)]
enum Way {
    Line { ends: [Vec<f64>; 2], speed: f64 },
    Laws { laws: Vec<Law>, range: [f64; 2] },
}

impl Sweep {
    /// The sweep that the arguments of `kin.Linkage.sweep` describe.
    pub(crate) fn new(
        linkage: Linkage,
        choice: AssemblyChoice,
        rows: usize,
        speed: Option<f64>,
        inputs: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let way = way(linkage.declared.description(), speed, inputs)?;
        Ok(Self {
            linkage,
            choice,
            way,
            rows,
        })
    }
}

fn way(description: &Description<'_>, speed: Option<f64>, inputs: Option<&Bound<'_, PyDict>>) -> PyResult<Way> {
    let quantities = description.inputs;
    let wanted = [Wanted {
        kind: "input",
        quantities,
    }];
    let values = arguments::values(inputs, &wanted)?.pop().unwrap_or_default();
    let laws: Vec<_> = values.iter().filter_map(|value| value.cast::<Law>().ok()).collect();
    if laws.is_empty() {
        let mut ends = [Vec::new(), Vec::new()];
        for (value, quantity) in values.iter().zip(quantities) {
            let name = quantity.name;
            let [from, to] = match value.len() {
                Err(_) => [arguments::number(value, name)?; 2],
                Ok(2) => [
                    arguments::number(&value.get_item(0)?, name)?,
                    arguments::number(&value.get_item(1)?, name)?,
                ],
                Ok(count) => {
                    return Err(PyValueError::new_err(format!(
                        "`{name}` has {count} numbers: give the two ends of its way, one number if it stands still, \
                         or a law"
                    )));
                }
            };
            ends[0].push(from);
            ends[1].push(to);
        }
        let speed = speed.unwrap_or(1.0);
        return Ok(Way::Line { ends, speed });
    }
    if speed.is_some() {
        return Err(PyTypeError::new_err("laws have their own speed: leave out `speed`"));
    }
    let durations = laws
        .iter()
        .map(|law| law.get().duration())
        .collect::<PyResult<Vec<f64>>>()?;
    let end = durations.into_iter().fold(0.0, f64::max);
    let law = |(value, quantity): (&Bound<'_, PyAny>, &kin_core::any::Quantity<'_>)| match value.cast::<Law>() {
        Ok(law) => Ok(law.get().clone()),
        Err(_) if value.len().is_ok() => Err(PyValueError::new_err(format!(
            "`{}` has two ends beside the law of another input: give it a law, or one number if it stands still",
            quantity.name
        ))),
        Err(_) => dwell(arguments::number(value, quantity.name)?, end),
    };
    let laws = values.iter().zip(quantities).map(law).collect::<PyResult<_>>()?;
    Ok(Way::Laws {
        laws,
        range: [0.0, end],
    })
}

/// Asks a sweep of kin-core, whose type depends on how the inputs move.
macro_rules! ask {
    ($sweep:expr, |$of_core:ident| $answer:expr) => {{
        let sweep: &Sweep = $sweep;
        let linkage = sweep.linkage.any();
        let assembled = linkage.sweep(sweep.choice.clone());
        match &sweep.way {
            Way::Line {
                ends: [from, to],
                speed,
            } => {
                let $of_core = assembled.between(from, to, sweep.rows).speed(*speed);
                $answer
            }
            Way::Laws { laws, range } => {
                let laws = laws.iter().map(Law::piecewise).collect::<PyResult<Vec<_>>>();
                let laws = laws.expect("a law was put together before");
                let laws: Vec<&dyn Piecewise<f64>> = laws.iter().map(|law| &**law).collect();
                let $of_core = assembled.under_laws(&laws, range[0]..=range[1], sweep.rows);
                $answer
            }
        }
    }};
}

#[pymethods]
impl Sweep {
    /// The linkage.
    #[getter]
    fn linkage(&self) -> Linkage {
        self.linkage.clone()
    }

    /// All rows as a table. Angles are unwrapped, and the mechanism is followed where it does not close in all rows.
    fn table(&self, py: Python<'_>) -> PyResult<Table> {
        let declared = &self.linkage.declared;
        let table = py.detach(|| ask!(self, |sweep| sweep.table(&declared.mechanism)));
        let table = table.map_err(|error| fault::of_answer(py, &declared.mechanism, error, None))?;
        Table::new(py, declared, table)
    }

    /// A quantity by the name of its column, as in `of("theta4_jerk")`, to ask for its peak, extremes, mean and more.
    /// They are found between the rows, exact to rounding.
    fn of(&self, name: &str) -> Quantity {
        Quantity {
            sweep: self.clone(),
            asked: Asked::Name(name.to_owned()),
        }
    }

    /// The transmission angle of a dyad, or its supplement if this is smaller; dyads count in the order in which they
    /// are solved.
    #[pyo3(signature = (dyad=0))]
    fn of_transmission_angle(&self, dyad: usize) -> PyResult<Quantity> {
        let count = self.linkage.any().dyad_count();
        if dyad >= count {
            return Err(PyValueError::new_err(format!(
                "{} has {count} dyads",
                self.linkage.declared.description().name
            )));
        }
        Ok(Quantity {
            sweep: self.clone(),
            asked: Asked::TransmissionAngle(dyad),
        })
    }

    fn __len__(&self) -> usize {
        self.rows
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let linkage = Bound::new(py, self.linkage.clone())?.repr()?;
        Ok(format!("<kin.Sweep of {linkage} in {} rows>", self.rows))
    }
}

#[derive(Clone, Debug)]
enum Asked {
    Name(String),
    TransmissionAngle(usize),
}

/// A quantity along a sweep. `kin.Sweep.of` makes it.
#[pyclass(frozen, module = "kin")]
#[derive(Debug)]
pub(crate) struct Quantity {
    sweep: Sweep,
    asked: Asked,
}

/// Asks for a quantity along a sweep.
macro_rules! along {
    ($quantity:expr, $py:expr, |$along:ident| $answer:expr) => {{
        let quantity: &Quantity = $quantity;
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
            })
        });
        found.map_err(|error| fault::of_extremes($py, &quantity.sweep.linkage.declared.mechanism, &error))
    }};
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

#[pymethods]
impl Quantity {
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
        let found = along!(self, py, |along| along.peak_sensitivities())?;
        let by = PyDict::new(py);
        let dimensions = self.sweep.linkage.declared.description().parameters;
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
        match &self.asked {
            Asked::Name(name) => format!("<kin.Quantity {name}>"),
            Asked::TransmissionAngle(dyad) => format!("<kin.Quantity transmission angle {dyad}>"),
        }
    }
}
