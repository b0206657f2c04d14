//! What Python calls on a linkage.

use std::sync::Arc;

use kin_core::any::{AssemblyChoice, Described, Quantity};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::answers::shown;
use crate::arguments;
use crate::batch::{self, Batch, Wishes};
use crate::choice::choice;
use crate::code::{Language, code};
use crate::cycle::Cycle;
use crate::fault;
use crate::fit::{self, FitWay};
use crate::linkage::Linkage;
use crate::loads::{self, Loads};
use crate::mechanism::Mechanism;
use crate::pose::Pose;
use crate::report::{Page, PageWishes};
use crate::sweep::Sweep;

#[pymethods]
impl Linkage {
    /// The mechanism.
    #[getter]
    fn mechanism(&self) -> Mechanism {
        Mechanism {
            declared: Arc::clone(&self.declared),
        }
    }

    /// The dimensions by their names, a point by its coordinates.
    #[getter]
    fn dimensions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        let quantities = self.declared.description().parameters;
        for group in arguments::groups(quantities) {
            let values = &self.parameters[group.first..group.first + group.coordinates];
            if group.is_point {
                all.set_item(group.name, PyTuple::new(py, values)?)?;
            } else {
                all.set_item(group.name, values[0])?;
            }
        }
        Ok(all)
    }

    /// The names of the assemblies: see `kin.Mechanism.assemblies`.
    #[getter]
    fn assemblies<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.declared.mechanism.assembly_names())
    }

    /// The pose at inputs, with all derivatives with respect to time.
    ///
    /// An input is its position, or a sequence of its position and derivatives; missing derivatives are zero. Angles
    /// are in radians. `assembly` is a name in `assemblies`; it may be left out if there is no choice. `near` chooses
    /// the position closest to another pose, or to values of the unknowns: then it needs no assembly, and the angles of
    /// the pose are close to those values instead of within ±π.
    ///
    /// Raises `kin.SolveError` where the linkage does not close.
    ///
    /// >>> import kin
    /// >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
    /// >>> pose = linkage.solve(theta2=[1.0, 10.0], assembly="open")
    /// >>> later = linkage.solve(theta2=[1.1, 10.0], near=pose)
    /// >>> later.assembly
    /// 'open'
    #[pyo3(signature = (*, assembly=None, near=None, **inputs))]
    fn solve(
        &self,
        py: Python<'_>,
        assembly: Option<&Bound<'_, PyAny>>,
        near: Option<&Bound<'_, PyAny>>,
        inputs: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Pose> {
        let inputs = self.inputs(inputs)?;
        let choice = choice(&self.declared, assembly, near)?;
        Pose::at(py, self, inputs, &choice)
    }

    /// The poses of every assembly in which the linkage closes at these inputs.
    ///
    /// A mechanism whose position is chosen by values nearby is searched. The search may miss a position, or there may
    /// be none for its equations: then `ValueError` says so, with what was found.
    ///
    /// >>> import kin
    /// >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
    /// >>> [pose.assembly for pose in linkage.positions(theta2=1.0)]
    /// ['open', 'crossed']
    #[pyo3(signature = (**inputs))]
    fn positions(&self, py: Python<'_>, inputs: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<Pose>> {
        let motions = self.inputs(inputs)?;
        let orders = self.declared.orders();
        let at: Vec<f64> = motions.chunks_exact(orders).map(|motion| motion[0]).collect();
        let found = py.detach(|| self.any().positions_at(&at));
        let (positions, search) = found.map_err(|error| fault::of_solver(py, &self.declared.mechanism, &error))?;
        if !search.is_complete {
            return Err(PyValueError::new_err(format!(
                "the search found {} positions, and there may be others: give values of the unknowns to `solve` by \
                 `near`",
                search.found
            )));
        }
        let positions = positions.into_iter();
        let poses = positions.map(|unknowns| Pose::at(py, self, motions.clone(), &AssemblyChoice::Near(unknowns)));
        poses.collect()
    }

    /// Many poses of this linkage at once: see `kin.Mechanism.solve_batch`.
    ///
    /// >>> import kin, numpy as np
    /// >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
    /// >>> turn = linkage.solve_batch(theta2=(np.linspace(0, 6, 1000), 10.0), assembly="open")
    /// >>> turn.theta4.position.shape, bool(turn.solved.all())
    /// ((1000,), True)
    #[expect(clippy::too_many_arguments, reason = "each is a keyword")]
    #[pyo3(signature = (*, assembly=None, near=None, order=None, threads=None, out=None, **inputs))]
    fn solve_batch(
        &self,
        py: Python<'_>,
        assembly: Option<&Bound<'_, PyAny>>,
        near: Option<&Bound<'_, PyAny>>,
        order: Option<usize>,
        threads: Option<usize>,
        out: Option<&Bound<'_, PyAny>>,
        inputs: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Batch> {
        let wishes = Wishes {
            assembly,
            near,
            order,
            threads,
            out,
        };
        batch::solve(py, &self.declared, Some(&self.parameters), inputs, &wishes)
    }

    /// A sweep: inputs move, and questions are asked along the way.
    ///
    /// An input is the two ends of its way, or one number if it stands still. All inputs move along a straight line,
    /// and `speed` is that of the first one that moves. Or an input is a `kin.Law` over the time, and the sweep ends
    /// with the longest of the laws.
    ///
    /// >>> import kin
    /// >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
    /// >>> turn = linkage.sweep(theta2=(0, 6.283185307179586), rows=361, speed=10.0, assembly="open")
    /// >>> [extreme.is_maximum for extreme in turn.of("theta4").extremes()]
    /// [False, True]
    /// >>> indexing = linkage.sweep(theta2=kin.rise("modified sine", 0.0, 1.5, 0.2), assembly="open")
    /// >>> indexing.of("theta4_jerk").peak().at < 0.2
    /// True
    #[pyo3(signature = (*, rows=361, speed=None, assembly=None, near=None, **inputs))]
    fn sweep(
        &self,
        rows: usize,
        speed: Option<&Bound<'_, PyAny>>,
        assembly: Option<&Bound<'_, PyAny>>,
        near: Option<&Bound<'_, PyAny>>,
        inputs: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Sweep> {
        let choice = choice(&self.declared, assembly, near)?;
        Sweep::new(self.clone(), choice, rows, speed, inputs)
    }

    /// All circuits and branches over one input. The others have the values that are given.
    #[pyo3(signature = (*, moving=None, **inputs))]
    fn cycle(&self, py: Python<'_>, moving: Option<&str>, inputs: Option<&Bound<'_, PyDict>>) -> PyResult<Cycle> {
        Cycle::new(py, self.clone(), moving, inputs)
    }

    /// A page on which the linkage moves: a `kin.Page`, which a notebook shows.
    ///
    /// The first input moves, or the one that `moving` names, through `range` or as far as the linkage closes; the
    /// others have the values that are given, or zero. `length` and `time` name the units.
    #[expect(clippy::too_many_arguments, reason = "each is a keyword")]
    #[pyo3(signature = (
        *, assembly=None, moving=None, range=None, speed=None, title=None, length="", time="s", **inputs
    ))]
    fn report(
        &self,
        py: Python<'_>,
        assembly: Option<&Bound<'_, PyAny>>,
        moving: Option<String>,
        range: Option<(f64, f64)>,
        speed: Option<&Bound<'_, PyAny>>,
        title: Option<String>,
        length: &str,
        time: &str,
        inputs: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Page> {
        let assembly = assembly
            .map(|assembly| choice(&self.declared, Some(assembly), None))
            .transpose()?;
        let assembly = assembly.and_then(|choice| choice.index());
        let quantities = self.declared.description().inputs;
        let at = PyDict::new(py);
        for quantity in quantities {
            at.set_item(quantity.name, 0.0)?;
        }
        if let Some(inputs) = inputs {
            at.update(inputs.as_mapping())?;
        }
        let at = arguments::inputs(Some(&at), self.declared.description())?;
        let at = at.iter().zip(quantities);
        let at = at
            .map(|(value, quantity)| arguments::number(value, quantity))
            .collect::<PyResult<_>>()?;
        let moves = |quantity: &&Quantity<'_>| moving.as_deref().is_none_or(|moving| moving == quantity.name);
        let speed = match (speed, quantities.iter().find(moves)) {
            (Some(speed), Some(quantity)) => Some(arguments::rate(speed, quantity, 1)?),
            _ => None,
        };
        let (length, time) = (length.to_owned(), time.to_owned());
        let wishes = PageWishes {
            assembly,
            at,
            moving,
            range,
            speed,
            title,
            length,
            time,
        };
        Page::new(py, self, wishes)
    }

    /// No loads: a `kin.Loads` whose methods add some.
    fn loads(&self) -> Loads {
        Loads::new(self)
    }

    /// The forces in all joints under loads, and the effort of the drive of each input, in the pose that `solve` finds
    /// with the same arguments: a `kin.Forces`. The declaration must state its bodies; otherwise `kin.AnswerError` says
    /// what to add.
    ///
    /// Each force tells the body on which it acts, and the one that exerts it. It is `None` where equilibrium alone
    /// does not determine it.
    #[pyo3(signature = (loads, *, assembly=None, near=None, **inputs))]
    fn forces<'py>(
        &self,
        py: Python<'py>,
        loads: &Bound<'_, Loads>,
        assembly: Option<&Bound<'_, PyAny>>,
        near: Option<&Bound<'_, PyAny>>,
        inputs: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let inputs = self.inputs(inputs)?;
        let choice = choice(&self.declared, assembly, near)?;
        loads::forces(py, self, loads.get(), &inputs, &choice)
    }

    /// The solver of this linkage in C99, with its dimensions as constants: see `kin.Mechanism.to_c`.
    #[pyo3(signature = (order=None))]
    fn to_c<'py>(&self, py: Python<'py>, order: Option<usize>) -> PyResult<Bound<'py, PyAny>> {
        code(py, &self.declared, Language::C, order, Some(&self.parameters))
    }

    /// The solver of this linkage as a module of JavaScript, with its dimensions as constants.
    #[pyo3(signature = (order=None))]
    fn to_javascript<'py>(&self, py: Python<'py>, order: Option<usize>) -> PyResult<Bound<'py, PyAny>> {
        code(py, &self.declared, Language::JavaScript, order, Some(&self.parameters))
    }

    /// The solver of this linkage as a module of Python that needs NumPy alone, with its dimensions as constants.
    #[pyo3(signature = (order=None))]
    fn to_python<'py>(&self, py: Python<'py>, order: Option<usize>) -> PyResult<Bound<'py, PyAny>> {
        code(py, &self.declared, Language::Python, order, Some(&self.parameters))
    }

    /// The dimensions that meet measured numbers best, by least squares with exact derivatives: a `kin.Fitted`.
    ///
    /// `data` has columns by the names of inputs, unknowns and outputs, as arrays or a data frame; a point has two
    /// columns, as `"pin.x"` and `"pin.y"`. NaN is a number that is not known. `vary` names the dimensions that are
    /// sought, with usual bounds about those of this linkage, or is a dictionary of their bounds; without it all are.
    ///
    /// The input that moves may be unknown in some rows, or have no column: then it is sought, too, in `range`. Other
    /// inputs have a column, or one value.
    ///
    /// >>> import kin, numpy as np
    /// >>> angles = np.linspace(0, 6, 25)
    /// >>> measured = kin.library.four_bar(r1=90, r2=30, r3=82, r4=57).solve_batch(theta2=angles, assembly="open")
    /// >>> data = {"theta2": angles, "theta4": measured.theta4.position}
    /// >>> guess = kin.library.four_bar(r1=90, r2=30, r3=80, r4=60)
    /// >>> fitted = guess.fit(data, vary={"r3": (40, 100), "r4": (40, 100)}, assembly="open")
    /// >>> round(fitted.linkage.dimensions["r4"], 6), fitted.is_minimum
    /// (57.0, True)
    #[expect(clippy::too_many_arguments, reason = "each is a keyword")]
    #[pyo3(signature = (data, *, vary=None, assembly=None, near=None, moving=None, range=None, **inputs))]
    fn fit<'py>(
        &self,
        py: Python<'py>,
        data: &Bound<'py, PyAny>,
        vary: Option<&Bound<'py, PyAny>>,
        assembly: Option<&Bound<'_, PyAny>>,
        near: Option<&Bound<'_, PyAny>>,
        moving: Option<&str>,
        range: Option<(f64, f64)>,
        inputs: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let choice = choice(&self.declared, assembly, near)?;
        let way = FitWay {
            moving,
            range,
            standing: inputs,
        };
        fit::fit(py, self, data, vary, choice, &way)
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        shown(slf.py(), "linkage_as_html", (slf,), None)
    }

    fn __eq__(&self, other: &Self) -> bool {
        let is_same = Arc::ptr_eq(&self.declared, &other.declared) || self.declared.text == other.declared.text;
        is_same && self.parameters == other.parameters
    }

    fn __hash__(&self) -> u64 {
        use std::hash::{DefaultHasher, Hash, Hasher};
        let mut hasher = DefaultHasher::new();
        self.declared.text.hash(&mut hasher);
        for value in self.parameters.iter() {
            // zeros of both signs are equal
            (value + 0.0).to_bits().hash(&mut hasher);
        }
        hasher.finish()
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let mut dimensions = Vec::new();
        for (name, value) in self.dimensions(py)?.iter() {
            dimensions.push(format!("{name}={}", value.repr()?));
        }
        let name = self.declared.description().name;
        Ok(format!("{name}({})", dimensions.join(", ")))
    }

    #[expect(clippy::type_complexity, reason = "as pickle wants it")]
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Mechanism, Vec<f64>))> {
        let restore = py.import("kin._kin")?.getattr("restored_linkage")?;
        Ok((restore, (self.mechanism(), self.parameters.to_vec())))
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}
