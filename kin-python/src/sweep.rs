//! Sweeps, and questions to them.

use kin_core::any::{AssemblyChoice, Description};
use kin_core::reaction::ReactionError;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::answers::{answer, shown};
use crate::arguments;
use crate::arrays::array;
use crate::exact::{ExactTable, precision};
use crate::fault;
use crate::law::{Law, dwell};
use crate::linkage::Linkage;
use crate::loads::{self, Loads};
use crate::proof::ForceProof;
use crate::quantity::{Asked, OfLoads, Quantity};
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
    pub(crate) linkage: Linkage,
    pub(crate) choice: AssemblyChoice,
    pub(crate) way: Way,
    pub(crate) rows: usize,
}

/// How the inputs move.
#[derive(Clone, Debug)]
pub(crate) enum Way {
    Line { ends: [Vec<f64>; 2], speed: f64 },
    Laws { laws: Vec<Law>, range: [f64; 2] },
}

impl Sweep {
    /// The sweep that the arguments of `kin.Linkage.sweep` describe.
    pub(crate) fn new(
        linkage: Linkage,
        choice: AssemblyChoice,
        rows: usize,
        speed: Option<&Bound<'_, PyAny>>,
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

    fn asked_of(&self, loads: &Bound<'_, Loads>, asked: OfLoads) -> PyResult<Quantity> {
        let loads = loads.get();
        loads.check(&self.linkage)?;
        Ok(self.asked(Asked::OfLoads(Box::new(loads.clone()), asked)))
    }

    /// The index of an input by its name, which may be left out if there is one.
    fn input(&self, name: Option<&str>) -> PyResult<usize> {
        input_index(self.linkage.declared.description(), name)
    }
}

/// The index of the first input that moves.
fn lead(ends: &[Vec<f64>; 2]) -> Option<usize> {
    let [from, to] = ends;
    from.iter().zip(to).position(|(from, to)| from != to)
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

fn way(
    description: &Description<'_>,
    speed: Option<&Bound<'_, PyAny>>,
    inputs: Option<&Bound<'_, PyDict>>,
) -> PyResult<Way> {
    let quantities = description.inputs;
    let values = arguments::inputs(inputs, description)?;
    let laws: Vec<_> = values.iter().filter_map(|value| value.cast::<Law>().ok()).collect();
    if laws.is_empty() {
        let mut ends = [Vec::new(), Vec::new()];
        for (value, quantity) in values.iter().zip(quantities) {
            let name = quantity.name;
            let [from, to] = match value.len() {
                Err(_) => [arguments::number(value, quantity)?; 2],
                Ok(2) => [
                    arguments::number(&value.get_item(0)?, quantity)?,
                    arguments::number(&value.get_item(1)?, quantity)?,
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
        let lead = lead(&ends).unwrap_or(0);
        let speed = match (speed, quantities.get(lead)) {
            (Some(speed), Some(quantity)) => arguments::rate(speed, quantity, 1)?,
            _ => 1.0,
        };
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
        Err(_) => dwell(arguments::number(value, quantity)?, end),
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
        let sweep: &$crate::sweep::Sweep = $sweep;
        let linkage = sweep.linkage.any();
        let assembled = linkage.sweep(sweep.choice.clone());
        match &sweep.way {
            $crate::sweep::Way::Line {
                ends: [from, to],
                speed,
            } => {
                let $of_core = assembled.between(from, to, sweep.rows).speed(*speed);
                $answer
            }
            $crate::sweep::Way::Laws { laws, range } => {
                let laws = laws
                    .iter()
                    .map($crate::law::Law::piecewise)
                    .collect::<pyo3::PyResult<Vec<_>>>();
                let laws = laws.expect("a law was put together before");
                let laws: Vec<&dyn kin_core::law::Piecewise<f64>> = laws.iter().map(|law| &**law).collect();
                let $of_core = assembled.under_laws(&laws, range[0]..=range[1], sweep.rows);
                $answer
            }
        }
    }};
}

pub(crate) use ask;

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
        self.asked(Asked::Name(arguments::column_name(name).into_owned()))
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
        self.asked_of(loads, OfLoads::Effort(self.input(input)?, order))
    }

    /// The power of the drive of an input under loads. The input may be left out if there is one.
    #[pyo3(signature = (loads, input=None))]
    fn of_power(&self, loads: &Bound<'_, Loads>, input: Option<&str>) -> PyResult<Quantity> {
        self.asked_of(loads, OfLoads::Power(self.input(input)?))
    }

    /// The force in a joint under loads, or a part of it: "force" is its size, others are "x", "y", "z", "moment",
    /// "moment_x", "moment_y" and "moment_z". The declaration must state its bodies. Order 1 is the rate by time.
    #[pyo3(signature = (loads, joint, part="force", order=0))]
    fn of_reaction(&self, loads: &Bound<'_, Loads>, joint: &str, part: &str, order: usize) -> PyResult<Quantity> {
        let part = loads::part(part)?;
        self.asked_of(loads, OfLoads::Reaction(joint.to_owned(), part, order))
    }

    /// The power that the friction of the loads turns into heat.
    fn of_heat(&self, loads: &Bound<'_, Loads>) -> PyResult<Quantity> {
        self.asked_of(loads, OfLoads::Heat)
    }

    /// The mean power of all drives, and what friction takes of it: a `kin.Efficiency`.
    fn efficiency<'py>(&self, py: Python<'py>, loads: &Bound<'_, Loads>) -> PyResult<Bound<'py, PyAny>> {
        let loads = loads.get();
        loads.check(&self.linkage)?;
        let linkage = self.linkage.any();
        let found = py.detach(|| {
            let reactions = loads.reactions(&linkage)?;
            Ok(ask!(self, |sweep| sweep.efficiency(&reactions)))
        });
        let found = found.map_err(|error: Box<ReactionError>| loads::refused_reaction(py, &self.linkage, &error))?;
        let found = found.map_err(|error| fault::of_extremes(py, &self.linkage.declared.mechanism, &error))?;
        answer(py, "Efficiency", (found.input, found.heat))
    }

    /// Proofs about a force under loads, for all inputs of the way and all dimensions within tolerances: a
    /// `kin.ForceProof`.
    ///
    /// The force is that in a joint, or a part of it as for `of_reaction`, or without a joint the effort of the drive
    /// of an input. `tolerances` has the deviations up and down of scalar dimensions by their names, `speeds` and
    /// `accelerations` the ranges of those of the first input that moves.
    #[expect(clippy::too_many_arguments, reason = "each is a keyword")]
    #[pyo3(signature = (
        loads, joint=None, *, part="force", input=None, tolerances=None, speeds=None, accelerations=None, budget=None
    ))]
    fn proof(
        &self,
        loads: &Bound<'_, Loads>,
        joint: Option<String>,
        part: &str,
        input: Option<&str>,
        tolerances: Option<std::collections::BTreeMap<String, f64>>,
        speeds: Option<(f64, f64)>,
        accelerations: Option<(f64, f64)>,
        budget: Option<usize>,
    ) -> PyResult<ForceProof> {
        let loads = loads.get();
        loads.check(&self.linkage)?;
        let Way::Line { ends, speed } = &self.way else {
            return Err(PyTypeError::new_err("laws have no proofs: sweep between two ends"));
        };
        Ok(ForceProof {
            linkage: self.linkage.clone(),
            choice: self.choice.clone(),
            ends: ends.clone(),
            speed: *speed,
            loads: loads.clone(),
            wanted: match joint {
                Some(joint) => OfLoads::Reaction(joint, loads::part(part)?, 0),
                None => OfLoads::Effort(self.input(input)?, 0),
            },
            tolerances: tolerances.unwrap_or_default(),
            speeds,
            accelerations,
            budget,
        })
    }

    /// The name of the variable: the first input that moves, or "time" under laws.
    #[getter]
    fn variable(&self) -> &str {
        match &self.way {
            Way::Line { ends, .. } => self.linkage.declared.description().inputs[lead(ends).unwrap_or(0)].name,
            Way::Laws { .. } => "time",
        }
    }

    /// The variable in all rows.
    #[getter]
    fn at<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let values = ask!(self, |sweep| (0..self.rows).map(|row| sweep.at(row)).collect());
        array(py, values, &[self.rows])
    }

    /// Plots of quantities over the sweep by matplotlib, one below the other: names as for `of`, or quantities such as
    /// `sweep.of_reaction(loads, "pin")`; without any, the unknowns. Angles are in degrees.
    ///
    /// `length`, `time` and `force` name the units; forces are in newtons by themselves where lengths are in "m". The
    /// result is the `Axes`, or an array of them; `ax` gives others, one for all quantities or one for each.
    #[pyo3(signature = (*quantities, **options))]
    fn plot<'py>(
        slf: &Bound<'py, Self>,
        quantities: &Bound<'py, PyTuple>,
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        shown(slf.py(), "plot", (slf, quantities), options)
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        shown(slf.py(), "sweep_as_html", (slf,), None)
    }

    fn __len__(&self) -> usize {
        self.rows
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let linkage = Bound::new(py, self.linkage.clone())?.repr()?;
        Ok(format!("<kin.Sweep of {linkage} in {} rows>", self.rows))
    }
}
