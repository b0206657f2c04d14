//! Loads on a linkage, and the forces that they cause.

use std::collections::BTreeMap;

use kin_core::any::AssemblyChoice;
use kin_core::linkage::AnyLinkage;
use kin_core::load::{LoadPoint, NamedLoads, NoSuchName};
use kin_core::reaction::{Friction, NamedReactions, Reaction, ReactionError, ReactionPart};
use kin_core::{Motion, Plane, Space};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};

use crate::answers::answer;
use crate::fault;
use crate::linkage::Linkage;
use crate::made::{Argument, Call};

/// Loads on the points, angles and bodies of a linkage. `kin.Linkage.loads` makes an empty list, and each method
/// returns the list with one more load.
///
/// Masses, lengths and times are in units that belong together, as kilograms, metres and seconds: then forces are in
/// newtons. A place is the name of a point, or the coordinates of a point of the ground.
///
/// >>> import kin
/// >>> press = kin.library.slider_crank(r=0.1, l=0.3)
/// >>> loads = press.loads().torque(-200.0, "s")    # a force against the slide, in newtons
/// >>> turn = press.sweep(theta=(0, 6.283185307179586), speed=10.0, assembly="open")
/// >>> turn.of_power(loads).highest().value > 0
/// True
#[pyclass(frozen, module = "kin")]
#[derive(Clone, Debug)]
pub(crate) struct Loads {
    pub(crate) named: NamedLoads,
    /// The friction of joints, by their names.
    frictions: Vec<(String, Friction)>,
    /// The rates of the inputs of the motion that is about to begin where they rest.
    about_to_move: Vec<f64>,
    linkage: Linkage,
    /// The methods that added the loads.
    calls: Vec<Call>,
}

fn refused(error: &NoSuchName) -> PyErr {
    PyValueError::new_err(error.to_string())
}

fn vector(value: &Bound<'_, PyAny>, name: &str) -> PyResult<Space<f64>> {
    let wrong = || PyTypeError::new_err(format!("`{name}` is a vector: give two or three numbers"));
    let numbers: Vec<f64> = value.extract().map_err(|_| wrong())?;
    match numbers.as_slice() {
        [x, y] => Ok(Space::new(*x, *y, 0.0)),
        [x, y, z] => Ok(Space::new(*x, *y, *z)),
        _ => Err(wrong()),
    }
}

fn with_place<T>(place: &Bound<'_, PyAny>, use_it: impl FnOnce(LoadPoint<'_>) -> T) -> PyResult<T> {
    match place.extract::<String>() {
        Ok(name) => Ok(use_it(LoadPoint::Named(&name))),
        Err(_) => Ok(use_it(LoadPoint::Fixed(vector(place, "place")?))),
    }
}

impl From<Space<f64>> for Argument {
    fn from(vector: Space<f64>) -> Self {
        Self::Triple((vector.x, vector.y, vector.z))
    }
}

impl From<LoadPoint<'_>> for Argument {
    fn from(place: LoadPoint<'_>) -> Self {
        match place {
            LoadPoint::Named(name) => name.into(),
            LoadPoint::Fixed(place) => place.into(),
        }
    }
}

impl Loads {
    pub(crate) fn new(linkage: &Linkage) -> Self {
        Self {
            named: linkage.any().loads(),
            frictions: Vec::new(),
            about_to_move: Vec::new(),
            linkage: linkage.clone(),
            calls: Vec::new(),
        }
    }

    /// Refuses the loads of another mechanism.
    pub(crate) fn check(&self, linkage: &Linkage) -> PyResult<()> {
        if self.linkage.declared.text == linkage.declared.text {
            return Ok(());
        }
        let name = linkage.declared.description().name;
        Err(PyValueError::new_err(format!(
            "these loads are not those of {name}: make them by its `loads`"
        )))
    }

    fn with(&self, call: Call, add: impl FnOnce(NamedLoads) -> Result<NamedLoads, NoSuchName>) -> PyResult<Self> {
        let named = add(self.named.clone()).map_err(|error| refused(&error))?;
        Ok(Self {
            named,
            ..self.called(call)
        })
    }

    fn with_friction(&self, call: Call, joint: &str, friction: Friction) -> Self {
        let mut loads = self.called(call);
        loads.frictions.push((joint.to_owned(), friction));
        loads
    }

    /// The same loads, after a call.
    fn called(&self, call: Call) -> Self {
        let mut loads = self.clone();
        loads.calls.push(call);
        loads
    }

    pub(crate) fn has_friction(&self) -> bool {
        !self.frictions.is_empty()
    }

    /// What the loads cause in the joints.
    pub(crate) fn reactions<'m>(&self, linkage: &AnyLinkage<'m>) -> Result<NamedReactions<'m>, Box<ReactionError>> {
        let frictions = self.frictions.iter().map(|(joint, friction)| (joint, *friction));
        let reactions = linkage.reactions(&self.named).map_err(Box::new)?;
        let reactions = reactions.frictions(frictions).map_err(Box::new)?;
        Ok(if self.about_to_move.is_empty() {
            reactions
        } else {
            reactions.about_to_move(&self.about_to_move)
        })
    }
}

#[pymethods]
impl Loads {
    /// The names of points on which loads can act.
    #[getter]
    fn points(&self) -> Vec<&str> {
        self.named.points()
    }

    /// The names of angles and distances on which loads can act.
    #[getter]
    fn angles(&self) -> Vec<&str> {
        self.named.angles()
    }

    /// The names of bodies that can have a mass.
    #[getter]
    fn bodies(&self) -> Vec<&str> {
        self.named.bodies()
    }

    /// The acceleration of gravity: a vector, for all masses.
    fn gravity(&self, acceleration: &Bound<'_, PyAny>) -> PyResult<Self> {
        let acceleration = vector(acceleration, "acceleration")?;
        self.with(Call::new("gravity", [acceleration.into()]), |loads| {
            Ok(loads.gravity(acceleration))
        })
    }

    /// A mass at a point.
    fn mass(&self, mass: f64, point: &str) -> PyResult<Self> {
        self.with(Call::new("mass", [mass.into(), point.into()]), |loads| {
            loads.mass(mass, point)
        })
    }

    /// The mass of a body, its centre, and its moment of inertia about the centre. The centre is the name of a point,
    /// or a vector in the frame of the body, from its first joint along the line to its second one.
    fn mass_of(&self, body: &str, mass: f64, centre: &Bound<'_, PyAny>, inertia: f64) -> PyResult<Self> {
        let add = |centre: LoadPoint<'_>| {
            let call = Call::new("mass_of", [body.into(), mass.into(), centre.into(), inertia.into()]);
            let centre = match centre {
                LoadPoint::Fixed(centre) => Plane::new(centre.x, centre.y).into(),
                named @ LoadPoint::Named(_) => named,
            };
            self.with(call, |loads| loads.mass_of(body, mass, centre, inertia))
        };
        with_place(centre, add)?
    }

    /// The moment of inertia of a link about its centre of mass, by its angle.
    fn inertia(&self, inertia: f64, angle: &str) -> PyResult<Self> {
        let call = Call::new("inertia", [inertia.into(), angle.into()]);
        self.with(call, |loads| loads.inertia(inertia, angle))
    }

    /// A constant force at a point: a vector.
    fn force(&self, force: &Bound<'_, PyAny>, point: &str) -> PyResult<Self> {
        let force = vector(force, "force")?;
        let call = Call::new("force", [force.into(), point.into()]);
        self.with(call, |loads| loads.force(force, point))
    }

    /// A constant torque on an angle, or a constant force along a distance.
    fn torque(&self, torque: f64, angle: &str) -> PyResult<Self> {
        let call = Call::new("torque", [torque.into(), angle.into()]);
        self.with(call, |loads| loads.torque(torque, angle))
    }

    /// A spring between two places, with its stiffness and its length at rest.
    fn spring(&self, stiffness: f64, rest: f64, start: &Bound<'_, PyAny>, end: &Bound<'_, PyAny>) -> PyResult<Self> {
        let add = |from: LoadPoint<'_>, to: LoadPoint<'_>| {
            let call = Call::new("spring", [stiffness.into(), rest.into(), from.into(), to.into()]);
            self.with(call, |loads| loads.spring(stiffness, rest, from, to))
        };
        with_place(start, |from| with_place(end, |to| add(from, to)))??
    }

    /// A damper between two places.
    fn damper(&self, damping: f64, start: &Bound<'_, PyAny>, end: &Bound<'_, PyAny>) -> PyResult<Self> {
        let add = |from: LoadPoint<'_>, to: LoadPoint<'_>| {
            let call = Call::new("damper", [damping.into(), from.into(), to.into()]);
            self.with(call, |loads| loads.damper(damping, from, to))
        };
        with_place(start, |from| with_place(end, |to| add(from, to)))??
    }

    /// Coulomb friction in a pin, with its coefficient and the radius of the pin.
    fn pin_friction(&self, joint: &str, coefficient: f64, radius: f64) -> Self {
        let call = Call::new("pin_friction", [joint.into(), coefficient.into(), radius.into()]);
        self.with_friction(call, joint, Friction::Pin { coefficient, radius })
    }

    /// Coulomb friction on a slide, with its coefficient, and the length of the bushing if its moment shall count.
    #[pyo3(signature = (joint, coefficient, length=None))]
    fn slide_friction(&self, joint: &str, coefficient: f64, length: Option<f64>) -> Self {
        let call = Call::new("slide_friction", [joint.into(), coefficient.into()]);
        let call = call.with_keywords(length.map(|length| ("length".to_owned(), length)));
        self.with_friction(call, joint, Friction::Slide { coefficient, length })
    }

    /// Where all inputs rest, friction opposes a motion with these rates of the inputs: efforts are those at which it
    /// is about to begin. Inputs that are left out have the rate zero.
    #[pyo3(signature = (**rates))]
    fn about_to_move(&self, rates: Option<BTreeMap<String, f64>>) -> PyResult<Self> {
        let mut rates = rates.unwrap_or_default();
        let call = Call::new("about_to_move", []).with_keywords(rates.clone());
        let inputs = || {
            self.linkage
                .declared
                .description()
                .inputs
                .iter()
                .map(|input| input.name)
        };
        let about_to_move = inputs().map(|input| rates.remove(input).unwrap_or(0.0));
        let loads = Self {
            about_to_move: about_to_move.collect(),
            ..self.called(call)
        };
        match rates.keys().next() {
            None => Ok(loads),
            Some(name) => Err(PyTypeError::new_err(format!(
                "no input is called `{name}`: inputs are {}",
                inputs().collect::<Vec<_>>().join(", ")
            ))),
        }
    }

    fn __repr__(&self) -> String {
        let (points, angles) = (self.named.points().join(", "), self.named.angles().join(", "));
        format!("<kin.Loads on points {points}; angles and distances {angles}>")
    }

    #[expect(clippy::type_complexity, reason = "as pickle wants it")]
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Linkage, Bound<'py, PyList>))> {
        let calls = PyList::empty(py);
        for call in &self.calls {
            let (arguments, keywords) = call.arguments(py)?;
            calls.append((call.function, arguments, keywords))?;
        }
        let restore = py.import("kin._kin")?.getattr("restored_loads")?;
        Ok((restore, (self.linkage.clone(), calls)))
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}

/// Loads that were pickled: those of the methods of `kin.Loads` with these arguments.
#[pyfunction]
pub(crate) fn restored_loads<'py>(
    linkage: &Bound<'py, Linkage>,
    calls: Vec<(String, Bound<'py, PyTuple>, Bound<'py, PyDict>)>,
) -> PyResult<Bound<'py, PyAny>> {
    let mut loads = Bound::new(linkage.py(), Loads::new(linkage.get()))?.into_any();
    for (method, arguments, keywords) in calls {
        loads = loads.call_method(method.as_str(), arguments, Some(&keywords))?;
    }
    Ok(loads)
}

const PARTS: [(&str, ReactionPart); 8] = [
    ("force", ReactionPart::Force),
    ("x", ReactionPart::X),
    ("y", ReactionPart::Y),
    ("z", ReactionPart::Z),
    ("moment", ReactionPart::Moment),
    ("moment_x", ReactionPart::MomentX),
    ("moment_y", ReactionPart::MomentY),
    ("moment_z", ReactionPart::MomentZ),
];

/// The part of a force in a joint that a word names.
pub(crate) fn part(word: &str) -> PyResult<ReactionPart> {
    let found = PARTS.iter().find(|(name, _)| *name == word);
    found.map(|(_, part)| *part).ok_or_else(|| {
        let names = PARTS.map(|(name, _)| format!("\"{name}\"")).join(", ");
        PyValueError::new_err(format!("no part of a force is called \"{word}\": there are {names}"))
    })
}

/// The word for a part of a force in a joint.
pub(crate) fn part_name(part: ReactionPart) -> &'static str {
    let found = PARTS.iter().find(|(_, own)| *own == part);
    found.map_or("force", |(name, _)| name)
}

/// The exception for forces that are not found.
pub(crate) fn refused_reaction(py: Python<'_>, linkage: &Linkage, error: &ReactionError) -> PyErr {
    match error {
        ReactionError::Solve(error) => fault::of_solver(py, &linkage.declared.mechanism, error),
        error => fault::of_answer(py, &linkage.declared.mechanism, error, None),
    }
}

/// The forces in all joints, and the efforts of the drives, at inputs with all orders.
pub(crate) fn forces<'py>(
    py: Python<'py>,
    linkage: &Linkage,
    loads: &Loads,
    inputs: &[f64],
    choice: &AssemblyChoice,
) -> PyResult<Bound<'py, PyAny>> {
    loads.check(linkage)?;
    let motion = |orders: &[f64]| Motion::new(std::array::from_fn(|order| orders.get(order).copied().unwrap_or(0.0)));
    let inputs: Vec<Motion> = inputs.chunks_exact(linkage.declared.orders()).map(motion).collect();
    let found = py.detach(|| {
        let any = linkage.any();
        let reactions = loads.reactions(&any)?;
        let found = reactions.at(&inputs, choice.position()).map_err(Box::new)?;
        let bodies = reactions
            .names()
            .map(|name| reactions.bodies_of(name).map_err(Box::new));
        Ok((found, bodies.collect::<Result<Vec<_>, _>>()?))
    });
    let (found, bodies) = found.map_err(|error: Box<ReactionError>| refused_reaction(py, linkage, &error))?;
    let joints = PyDict::new(py);
    for ((name, reaction), [on, by]) in found.all().zip(bodies) {
        match reaction {
            Ok(reaction) => {
                let Reaction { x, y, z, moment, .. } = reaction;
                let fields = (x[0], y[0], z[0], moment[0], reaction.magnitude()[0], on, by);
                joints.set_item(name, answer(py, "Force", fields)?)?;
            }
            Err(ReactionError::Undetermined { .. }) => joints.set_item(name, py.None())?,
            Err(error) => return Err(refused_reaction(py, linkage, &error)),
        }
    }
    let efforts = PyDict::new(py);
    for (index, input) in linkage.declared.description().inputs.iter().enumerate() {
        efforts.set_item(input.name, found.effort(index).map(|effort| effort[0]))?;
    }
    let efficiency = found
        .efficiency()
        .map(|found| answer(py, "Efficiency", (found.input, found.heat)));
    answer(py, "Forces", (joints, efforts, efficiency.transpose()?))
}
