//! A pose.

use kin_core::any::{AssemblyChoice, Described, MotionOver, NearOver, OutputsOver, Quantity};
use kin_core::{Changing, Dimension, Number as _};
use pyo3::exceptions::{PyAttributeError, PyKeyError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::arguments::{Group, groups};
use crate::arrays::array;
use crate::declared::Declared;
use crate::fault;
use crate::linkage::Linkage;
use crate::motion::Motion;

/// A pose of a linkage: its inputs, unknowns and outputs as attributes, each a `kin.Motion` with all derivatives.
///
/// A name that no attribute can have is an item: `pose["lambda"]`.
///
/// >>> import kin
/// >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
/// >>> pose = linkage.solve(theta2=[1.0, 10.0], assembly="open")
/// >>> pose.theta4.jerk == pose["theta4"].jerk
/// True
/// >>> pose.assembly
/// 'open'
/// >>> pose.jacobian().shape    # of theta3 and theta4 by theta2
/// (2, 1)
#[pyclass(frozen, module = "kin")]
pub(crate) struct Pose {
    pub(crate) linkage: Linkage,
    /// The motions of inputs, unknowns and outputs, one after the other, each with all orders.
    numbers: Vec<f64>,
}

/// The unit of a quantity in a text.
pub(crate) fn unit(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::Angle => "rad",
        _ => "",
    }
}

/// The quantities of a pose: first inputs, then unknowns and outputs.
fn kinds(declared: &Declared) -> [&[Quantity<'_>]; 3] {
    let description = declared.description();
    [description.inputs, description.unknowns, description.outputs]
}

/// The quantities of these kinds that have a name, with the number of quantities before those of their kind.
pub(crate) fn find<'d>(kinds: &[&'d [Quantity<'d>]], name: &str) -> Option<(Group<'d>, usize, Dimension)> {
    let mut before = 0;
    for quantities in kinds {
        for group in groups(quantities) {
            if group.name == name {
                let dimension = quantities[group.first].dimension;
                return Some((group, before, dimension));
            }
        }
        if let Some(index) = quantities.iter().position(|quantity| quantity.name == name) {
            let group = Group {
                name: quantities[index].name,
                first: index,
                coordinates: 1,
                is_point: false,
            };
            return Some((group, before, quantities[index].dimension));
        }
        before += quantities.len();
    }
    None
}

impl Pose {
    /// The pose of a linkage at inputs with all orders.
    pub(crate) fn at(
        py: Python<'_>,
        linkage: &Linkage,
        mut inputs: Vec<f64>,
        choice: &AssemblyChoice,
    ) -> PyResult<Self> {
        let description = linkage.declared.description();
        let orders = linkage.declared.orders();
        let mut unknowns = vec![0.0; description.unknowns.len() * orders];
        let mut outputs = vec![0.0; description.outputs.len() * orders];
        let mechanism: &dyn MotionOver<f64> = &linkage.declared.mechanism;
        let found = mechanism.motion(
            &linkage.parameters,
            &inputs,
            choice.position(),
            &mut unknowns,
            &mut outputs,
        );
        found.map_err(|error| fault::of_solver(py, &linkage.declared.mechanism, &error))?;
        inputs.append(&mut unknowns);
        inputs.append(&mut outputs);
        Ok(Self {
            linkage: linkage.clone(),
            numbers: inputs,
        })
    }

    /// The positions of a kind of quantities: 0 is inputs, 1 is unknowns.
    pub(crate) fn positions(&self, kind: usize) -> Vec<f64> {
        let kinds = kinds(&self.linkage.declared);
        let before: usize = kinds[..kind].iter().map(|quantities| quantities.len()).sum();
        let orders = self.linkage.declared.orders();
        let motions = self.numbers.chunks_exact(orders).skip(before);
        motions.take(kinds[kind].len()).map(|motion| motion[0]).collect()
    }

    fn find(&self, py: Python<'_>, name: &str) -> PyResult<Option<Motion>> {
        let Some((group, before, dimension)) = find(&kinds(&self.linkage.declared), name) else {
            return Ok(None);
        };
        let orders = self.linkage.declared.orders();
        let first = (before + group.first) * orders;
        let value = |order: usize| -> PyResult<Py<PyAny>> {
            if !group.is_point {
                return Ok(self.numbers[first + order].into_pyobject(py)?.into_any().unbind());
            }
            let point = (0..group.coordinates).map(|index| self.numbers[first + index * orders + order]);
            Ok(array(py, point.collect(), &[group.coordinates])?.unbind())
        };
        let values = (0..orders).map(value).collect::<PyResult<_>>()?;
        Ok(Some(Motion::new(&group, unit(dimension), values)))
    }

    fn none_called(&self, name: &str) -> String {
        let all = kinds(&self.linkage.declared).into_iter().flat_map(groups);
        let all: Vec<&str> = all.map(|group| group.name).collect();
        format!(
            "no quantity of {} is called `{name}`: there are {}",
            self.linkage.declared.description().name,
            all.join(", ")
        )
    }

    /// The derivatives of unknowns and outputs with respect to parameters or inputs: row after row.
    fn derivatives(&self, py: Python<'_>, by_inputs: bool) -> PyResult<(Vec<f64>, [usize; 2])> {
        let mechanism = &self.linkage.declared.mechanism;
        let description = mechanism.description();
        let given = [self.linkage.parameters.to_vec(), self.positions(0)];
        let near: Vec<_> = self.positions(1).into_iter().map(Changing::constant).collect();
        let width = given[usize::from(by_inputs)].len();
        let mut columns = Vec::with_capacity(width);
        for moved in 0..width {
            let [parameters, inputs] = [0, 1].map(|kind| {
                let values = given[kind].iter().enumerate();
                let moves = |index| kind == usize::from(by_inputs) && index == moved;
                let values = values.map(|(index, value)| Changing::new(*value, f64::from(u8::from(moves(index)))));
                values.collect::<Vec<Changing<f64>>>()
            });
            let mut unknowns = near.clone();
            let found = mechanism.position_near(&parameters, &inputs, &near, &mut unknowns);
            found.map_err(|error| fault::of_solver(py, mechanism, &error))?;
            let mut outputs = vec![Changing::constant(0.0); description.outputs.len()];
            mechanism.outputs(&parameters, &inputs, &unknowns, &mut outputs);
            unknowns.extend(outputs);
            columns.push(unknowns);
        }
        let height = description.unknowns.len() + description.outputs.len();
        let entries = (0..height).flat_map(|row| columns.iter().map(move |column| column[row].change));
        Ok((entries.collect(), [height, width]))
    }
}

#[pymethods]
impl Pose {
    /// The linkage.
    #[getter]
    fn linkage(&self) -> Linkage {
        self.linkage.clone()
    }

    /// The name of the assembly, or `None` if a position is chosen by values nearby.
    #[getter]
    fn assembly(&self) -> Option<String> {
        let linkage = self.linkage.any();
        let choice = linkage.assembly_at(&self.positions(0), &self.positions(1));
        self.linkage.declared.mechanism.assembly_name(choice.index()?)
    }

    /// The unknowns by their names, as `near` takes them.
    #[getter]
    fn unknowns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        let names = self.linkage.declared.description().unknowns;
        for (quantity, value) in names.iter().zip(self.positions(1)) {
            all.set_item(quantity.name, value)?;
        }
        Ok(all)
    }

    /// The names of the rows of `jacobian` and `sensitivities`: unknowns, then outputs, a point with a row for each
    /// coordinate.
    #[getter]
    fn rows<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let [_, unknowns, outputs] = kinds(&self.linkage.declared);
        let names = unknowns.iter().chain(outputs).map(|quantity| quantity.name);
        PyTuple::new(py, names.collect::<Vec<_>>())
    }

    /// The partial derivatives of unknowns and outputs with respect to the inputs: an array with a row for each name in
    /// `rows`, and a column for each input. They do not depend on the velocity of the pose.
    fn jacobian<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (entries, shape) = self.derivatives(py, true)?;
        array(py, entries, &shape)
    }

    /// The partial derivatives of unknowns and outputs with respect to the dimensions: an array with a row for each
    /// name in `rows`, and a column for each scalar dimension.
    fn sensitivities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (entries, shape) = self.derivatives(py, false)?;
        array(py, entries, &shape)
    }

    /// The transmission angle of every dyad in radians, by the unknowns of the dyad.
    fn transmission_angles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        let description = self.linkage.declared.description();
        for angle in self
            .linkage
            .any()
            .transmission_angles(&self.positions(0), &self.positions(1))
        {
            all.set_item(fault::named(angle.block, description), angle.angle)?;
        }
        Ok(all)
    }

    /// How strongly each unknown depends on rounding: by so many ε, in radians or in its unit, it may be wrong if every
    /// number it is found from is rounded. It grows beyond all bounds towards a limit.
    ///
    /// >>> import kin
    /// >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=60, r4=45)
    /// >>> [linkage.solve(theta2=angle, assembly="open").conditions()["theta4"] > 100 for angle in (1.0, 1.955)]
    /// [False, True]
    fn conditions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        let conditions = self.linkage.any().conditions(&self.positions(0), &self.positions(1));
        let unknowns = self.linkage.declared.description().unknowns;
        for (quantity, condition) in unknowns.iter().zip(conditions) {
            all.set_item(quantity.name, condition)?;
        }
        Ok(all)
    }

    /// The pose to which the linkage moves from here, as its inputs go along a straight line to these: it is followed
    /// without a jump, whatever assembly that is. Inputs are given as for `kin.Linkage.solve`.
    ///
    /// Raises `kin.TrackError` at a limit on the way.
    ///
    /// >>> import kin
    /// >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
    /// >>> pose = linkage.solve(theta2=1.0, assembly="open")
    /// >>> later = pose.track_to(theta2=(7.0, 10.0))
    /// >>> later.assembly, round(later.theta4.velocity, 4)
    /// ('open', 0.6446)
    #[pyo3(signature = (**inputs))]
    fn track_to(&self, py: Python<'_>, inputs: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let linkage = &self.linkage;
        let inputs = linkage.inputs(inputs)?;
        let to: Vec<f64> = inputs
            .chunks_exact(linkage.declared.orders())
            .map(|motion| motion[0])
            .collect();
        let (from, unknowns) = (self.positions(0), self.positions(1));
        let found = py.detach(|| linkage.any().track(&from, &unknowns, &to));
        let found = found.map_err(|error| fault::of_track(py, &linkage.declared.mechanism, &error))?;
        Self::at(py, linkage, inputs, &AssemblyChoice::Near(found))
    }

    fn __getattr__(&self, py: Python<'_>, name: &str) -> PyResult<Motion> {
        self.find(py, name)?
            .ok_or_else(|| PyAttributeError::new_err(self.none_called(name)))
    }

    fn __getitem__(&self, py: Python<'_>, name: &str) -> PyResult<Motion> {
        self.find(py, name)?
            .ok_or_else(|| PyKeyError::new_err(self.none_called(name)))
    }

    fn __dir__<'py>(slf: &Bound<'py, Self>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let own = slf.get_type().dir()?;
        let mut names: Vec<Bound<'py, PyAny>> = own.iter().collect();
        for group in kinds(&slf.get().linkage.declared).into_iter().flat_map(groups) {
            names.push(group.name.into_pyobject(slf.py())?.into_any());
        }
        Ok(names)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let mut lines = vec![format!("<kin.Pose of {}", self.linkage.declared.description().name)];
        for group in kinds(&self.linkage.declared).into_iter().flat_map(groups) {
            if let Some(motion) = self.find(py, group.name)? {
                lines.push(Bound::new(py, motion)?.repr()?.to_string());
            }
        }
        Ok(lines.join("\n  ") + ">")
    }

    #[expect(clippy::type_complexity, reason = "as pickle wants it")]
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Linkage, Vec<f64>))> {
        let restore = py.import("kin._kin")?.getattr("restored_pose")?;
        Ok((restore, (self.linkage.clone(), self.numbers.clone())))
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}

/// A pose that was pickled.
#[pyfunction]
pub(crate) fn restored_pose(linkage: &Bound<'_, Linkage>, numbers: Vec<f64>) -> PyResult<Pose> {
    let linkage = linkage.get().clone();
    let count: usize = kinds(&linkage.declared).iter().map(|quantities| quantities.len()).sum();
    if numbers.len() != count * linkage.declared.orders() {
        return Err(pyo3::exceptions::PyValueError::new_err(
            "these are not the numbers of a pose of this linkage",
        ));
    }
    Ok(Pose { linkage, numbers })
}
