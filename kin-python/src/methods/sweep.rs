//! What Python calls on a sweep.

use kin_core::reaction::ReactionError;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::answers::{answer, shown};
use crate::arguments;
use crate::arrays::array;
use crate::exact::{ExactTable, precision};
use crate::fault;
use crate::linkage::Linkage;
use crate::loads::{self, Loads};
use crate::made::Reduced;
use crate::proof::ForceProof;
use crate::quantity::{Asked, OfLoads, Quantity};
use crate::sweep::{Sweep, Way, ask, lead};
use crate::table::Table;

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
        arguments::input_index(self.linkage.declared.description(), name)
    }
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
        Table::of(py, self)
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

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        self.reduced(py)
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}
