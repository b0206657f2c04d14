//! Sweeps, and questions to them.

use kin_core::any::{AssemblyChoice, Description};
use kin_core::extremes::{ExtremesError, Over};
use kin_core::law::Piecewise;
use kin_core::reaction::{ReactionError, ReactionPart};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};

use crate::answers::{self, answer};
use crate::arguments::{self, Wanted};
use crate::arrays::array;
use crate::exact::{ExactTable, precision};
use crate::fault;
use crate::law::{Law, dwell};
use crate::linkage::Linkage;
use crate::loads::{self, Loads};
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

impl Sweep {
    fn asked(&self, asked: Asked) -> Quantity {
        let sweep = self.clone();
        Quantity { sweep, asked }
    }

    /// The loads, and the index of an input.
    fn drive(&self, loads: &Bound<'_, Loads>, input: Option<&str>) -> PyResult<(Loads, usize)> {
        let loads = loads.get();
        loads.check(&self.linkage)?;
        let index = input_index(self.linkage.declared.description(), input)?;
        Ok((loads.clone(), index))
    }
}

/// The index of an input by its name, which may be left out if there is one.
pub(crate) fn input_index(description: &Description<'_>, name: Option<&str>) -> PyResult<usize> {
    let names = || {
        description
            .inputs
            .iter()
            .map(|input| input.name)
            .collect::<Vec<_>>()
            .join(", ")
    };
    let Some(name) = name else {
        if description.inputs.len() == 1 {
            return Ok(0);
        }
        return Err(PyTypeError::new_err(format!(
            "which input is meant? there are {}",
            names()
        )));
    };
    let index = description.inputs.iter().position(|input| input.name == name);
    index.ok_or_else(|| PyTypeError::new_err(format!("no input is called `{name}`: inputs are {}", names())))
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

    /// A table that replaces the solver: values and derivatives by the input are within the tolerance, also between its
    /// rows. A list has a tolerance for each order, and the table ends with the last of them. Each derivative loses
    /// about two digits, so `[1e-10, 1e-8, 1e-6]` takes the fewest rows.
    fn exact_table(&self, py: Python<'_>, tolerance: &Bound<'_, PyAny>) -> PyResult<ExactTable> {
        let tolerance = precision(tolerance)?;
        let found = py.detach(|| ask!(self, |sweep| sweep.exact_table(tolerance).map_err(Box::new)));
        let mechanism = &self.linkage.declared.mechanism;
        let table = found.map_err(|error| fault::of_answer(py, mechanism, error, None))?;
        Ok(ExactTable { table })
    }

    /// A quantity by the name of its column, as in `of("theta4_jerk")`, to ask for its peak, extremes, mean and more.
    /// They are found between the rows, exact to rounding.
    fn of(&self, name: &str) -> Quantity {
        self.asked(Asked::Name(name.to_owned()))
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
        Ok(self.asked(Asked::TransmissionAngle(dyad)))
    }

    /// The effort of the drive of an input under loads: a torque, or a force along a distance. The input may be left
    /// out if there is one. Order 1 is its rate by time.
    #[pyo3(signature = (loads, input=None, order=0))]
    fn of_effort(&self, loads: &Bound<'_, Loads>, input: Option<&str>, order: usize) -> PyResult<Quantity> {
        let (loads, input) = self.drive(loads, input)?;
        let asked = Asked::Effort(loads, input, order);
        Ok(self.asked(asked))
    }

    /// The power of the drive of an input under loads. The input may be left out if there is one.
    #[pyo3(signature = (loads, input=None))]
    fn of_power(&self, loads: &Bound<'_, Loads>, input: Option<&str>) -> PyResult<Quantity> {
        let (loads, input) = self.drive(loads, input)?;
        Ok(self.asked(Asked::Power(loads, input)))
    }

    /// The force in a joint under loads, or a part of it: "force" is its size, others are "x", "y", "z", "moment",
    /// "moment_x", "moment_y" and "moment_z". The declaration must state its bodies. Order 1 is the rate by time.
    #[pyo3(signature = (loads, joint, part="force", order=0))]
    fn of_reaction(&self, loads: &Bound<'_, Loads>, joint: &str, part: &str, order: usize) -> PyResult<Quantity> {
        let loads = loads.get();
        loads.check(&self.linkage)?;
        let part = loads::part(part)?;
        Ok(self.asked(Asked::Reaction(loads.clone(), joint.to_owned(), part, order)))
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
    Effort(Loads, usize, usize),
    Power(Loads, usize),
    Reaction(Loads, String, ReactionPart, usize),
}

/// A quantity along a sweep. `kin.Sweep.of` makes it.
#[pyclass(frozen, module = "kin")]
#[derive(Debug)]
pub(crate) struct Quantity {
    sweep: Sweep,
    asked: Asked,
}

/// Asks for a quantity along a sweep. Efforts and powers may have an answer of their own.
macro_rules! along {
    ($quantity:expr, $py:expr, |$along:ident| $answer:expr) => {
        along!($quantity, $py, |$along| $answer, |$along| $answer)
    };
    ($quantity:expr, $py:expr, |$along:ident| $answer:expr, |$effort:ident| $of_effort:expr) => {{
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
                Asked::Effort(loads, input, order) => {
                    let $effort = sweep.of_effort(&loads.named, *input, *order);
                    $of_effort
                }
                Asked::Power(loads, input) => {
                    let $effort = sweep.of_power(&loads.named, *input);
                    $of_effort
                }
                Asked::Reaction(loads, joint, part, order) => {
                    let linkage = quantity.sweep.linkage.any();
                    let reactions = linkage.reactions(&loads.named).map_err(at_once)?;
                    let $along = sweep.of_reaction(&reactions, joint, *part, *order);
                    $answer
                }
            })
        });
        found.map_err(|error| fault::of_extremes($py, &quantity.sweep.linkage.declared.mechanism, &error))
    }};
}

/// The error of a question that no point of the sweep is to blame for.
fn at_once(error: ReactionError) -> ExtremesError {
    ExtremesError::Reaction {
        at: f64::NAN,
        error: Box::new(error),
    }
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
    fn input(&self, index: usize) -> &str {
        self.sweep.linkage.declared.description().inputs[index].name
    }
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
        if matches!(self.asked, Asked::Effort(..) | Asked::Power(..)) {
            return Err(PyTypeError::new_err("efforts and powers have no sensitivities"));
        }
        let found = along!(self, py, |along| along.peak_sensitivities(), |effort| {
            drop(effort);
            unreachable!("efforts were refused")
        })?;
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
            Asked::Effort(_, input, _) => format!("<kin.Quantity effort of {}>", self.input(*input)),
            Asked::Power(_, input) => format!("<kin.Quantity power of {}>", self.input(*input)),
            Asked::Reaction(_, joint, ..) => format!("<kin.Quantity force in {joint}>"),
        }
    }
}
