//! Motion laws of inputs.

use std::fmt;
use std::sync::Arc;

use kin_core::Motion;
use kin_core::law::{
    ConstantSpeed, Dwell, Fourier, Law as _, LawError, Limits, Piecewise, Polynomial, Rise, SCurve, Scca, Sequence,
    Shape,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::made::{Argument, Call, Reduced, reduced};

/// A motion law: an input over the time. `kin.rise`, `kin.dwell` and their like make laws, and `+` puts one behind
/// another.
///
/// >>> import kin
/// >>> law = kin.rise("modified sine", 0.0, 1.5, 0.2) + kin.dwell(1.5, 0.1)
/// >>> law.duration
/// 0.30000000000000004
/// >>> law.at(0.25)    # the value and its derivatives
/// (1.5, 0.0, 0.0, 0.0, 0.0)
#[pyclass(frozen, module = "kin")]
#[derive(Clone)]
pub(crate) struct Law {
    parts: Vec<Arc<Part>>,
}

/// A law of one kind, and the function of this module that made it.
struct Part {
    law: Box<dyn Repeated>,
    made: Call,
}

/// A law that can be put into a sequence as often as it is asked for.
trait Repeated: Send + Sync {
    fn boxed(&self) -> Box<dyn Piecewise<f64>>;
}

impl<L: Piecewise<f64> + Copy + Send + Sync + 'static> Repeated for L {
    fn boxed(&self) -> Box<dyn Piecewise<f64>> {
        Box::new(*self)
    }
}

impl fmt::Debug for Law {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Law").finish_non_exhaustive()
    }
}

fn refused(error: LawError) -> PyErr {
    PyValueError::new_err(error.to_string())
}

impl Law {
    fn of(law: Result<impl Repeated + 'static, LawError>, made: Call) -> PyResult<Self> {
        let law = Box::new(law.map_err(refused)?);
        Ok(Self {
            parts: vec![Arc::new(Part { law, made })],
        })
    }

    /// The law as a sweep takes it.
    pub(crate) fn piecewise(&self) -> PyResult<Box<dyn Piecewise<f64>>> {
        let mut parts: Vec<_> = self.parts.iter().map(|part| part.law.boxed()).collect();
        if let [_] = parts.as_slice() {
            return Ok(parts.remove(0));
        }
        Ok(Box::new(Sequence::of_boxes(parts).map_err(refused)?))
    }
}

#[pymethods]
impl Law {
    /// The time at which it ends.
    #[getter]
    pub(crate) fn duration(&self) -> PyResult<f64> {
        Ok(self.piecewise()?.duration())
    }

    /// The value at a time, and its derivatives up to the snap.
    fn at(&self, time: f64) -> PyResult<(f64, f64, f64, f64, f64)> {
        Ok(self.piecewise()?.at::<5>(time).derivatives().into())
    }

    fn __add__(&self, next: &Self) -> PyResult<Self> {
        let law = Self {
            parts: self.parts.iter().chain(&next.parts).cloned().collect(),
        };
        law.piecewise()?;
        Ok(law)
    }

    fn __repr__(&self) -> PyResult<String> {
        Ok(format!("<kin.Law of the duration {}>", self.duration()?))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        if let [part] = self.parts.as_slice() {
            let (arguments, keywords) = part.made.arguments(py)?;
            return reduced(
                py.import("kin._kin")?.getattr(part.made.function)?,
                arguments,
                &keywords,
            );
        }
        let parts = self.parts.iter().map(|part| Self {
            parts: vec![Arc::clone(part)],
        });
        let parts = PyTuple::new(
            py,
            parts.map(|part| Bound::new(py, part)).collect::<PyResult<Vec<_>>>()?,
        )?;
        let add = py.import("operator")?.getattr("add")?;
        Ok((
            py.import("functools")?.getattr("reduce")?,
            (add, parts).into_pyobject(py)?,
        ))
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}

const SHAPES: [(&str, Shape); 8] = [
    ("constant speed", Shape::ConstantSpeed),
    ("simple harmonic", Shape::SimpleHarmonic),
    ("cycloidal", Shape::Cycloidal),
    ("3-4-5", Shape::Polynomial345),
    ("4-5-6-7", Shape::Polynomial4567),
    ("5-6-7-8-9", Shape::Polynomial56789),
    ("modified sine", Shape::ModifiedSine),
    ("modified trapezoid", Shape::ModifiedTrapezoid),
];

/// The shape of a rise, as Python names it.
#[derive(FromPyObject)]
pub(crate) enum ShapeName {
    Named(String),
    /// The shares of sine, constant and cosine acceleration.
    Shares(f64, f64, f64),
}

/// The law of a rise from one value to another in a time.
///
/// Shapes are "constant speed", "simple harmonic", "cycloidal", "3-4-5", "4-5-6-7", "5-6-7-8-9", "modified sine" and
/// "modified trapezoid", or the shares of the time with sine, constant and cosine acceleration, as in
/// `(0.25, 0.0, 0.75)`; what they leave of it is at constant speed.
#[pyfunction]
#[pyo3(signature = (shape, start, end, duration))]
pub(crate) fn rise(shape: ShapeName, start: f64, end: f64, duration: f64) -> PyResult<Law> {
    let named = match &shape {
        ShapeName::Shares(sine, constant, cosine) => Argument::Triple((*sine, *constant, *cosine)),
        ShapeName::Named(name) => name.as_str().into(),
    };
    let made = Call::new("rise", [named, start.into(), end.into(), duration.into()]);
    let shape = match shape {
        ShapeName::Shares(sine, constant, cosine) => Shape::Scca(Scca::new(sine, constant, cosine).map_err(refused)?),
        ShapeName::Named(name) => {
            let found = SHAPES.iter().find(|(own, _)| *own == name);
            let found = found.ok_or_else(|| {
                let names = SHAPES.map(|(name, _)| format!("\"{name}\"")).join(", ");
                PyValueError::new_err(format!("no shape of a rise is called \"{name}\": there are {names}"))
            })?;
            found.1
        }
    };
    Law::of(Rise::new(shape, start, end, duration), made)
}

/// The law of an input that stands still for a time.
#[pyfunction]
pub(crate) fn dwell(value: f64, duration: f64) -> PyResult<Law> {
    let made = Call::new("dwell", [value.into(), duration.into()]);
    Law::of(Dwell::new(value, duration), made)
}

/// The law of an input that moves at constant speed for a time.
#[pyfunction]
pub(crate) fn constant_speed(start: f64, speed: f64, duration: f64) -> PyResult<Law> {
    let made = Call::new("constant_speed", [start.into(), speed.into(), duration.into()]);
    Law::of(ConstantSpeed::new(start, speed, duration), made)
}

/// The S-curve from rest to rest within limits of velocity, acceleration, jerk, and snap if it is given: the law of a
/// servo drive. It takes as long as the limits ask for.
///
/// >>> import kin
/// >>> kin.s_curve(0.0, 1.0, velocity=2.0, acceleration=10.0, jerk=200.0).duration
/// 0.75
#[pyfunction]
#[pyo3(signature = (start, end, *, velocity, acceleration, jerk, snap=None))]
pub(crate) fn s_curve(
    start: f64,
    end: f64,
    velocity: f64,
    acceleration: f64,
    jerk: f64,
    snap: Option<f64>,
) -> PyResult<Law> {
    let limits = Limits {
        velocity,
        acceleration,
        jerk,
        snap,
    };
    let given = [("velocity", velocity), ("acceleration", acceleration), ("jerk", jerk)];
    let given = given.into_iter().chain(snap.map(|snap| ("snap", snap)));
    let made = Call::new("s_curve", [start.into(), end.into()]);
    let made = made.with_keywords(given.map(|(name, limit)| (name.to_owned(), limit)));
    Law::of(SCurve::new(start, end, limits), made)
}

/// Calls `Polynomial::between` for states of these lengths.
macro_rules! between {
    ($start:expr, $end:expr, $duration:expr, $made:expr; $($count:literal + $other:literal = $all:literal),+) => {
        match ($start.len(), $end.len()) {
            $(($count, $other) => {
                let start: Motion<f64, $count> = Motion::new(std::array::from_fn(|order| $start[order]));
                let end: Motion<f64, $other> = Motion::new(std::array::from_fn(|order| $end[order]));
                Law::of(Polynomial::<f64, $all>::between(start, end, $duration), $made)
            })+
            _ => Err(PyValueError::new_err(
                "a state is the value and behind it up to 4 derivatives, for both ends as many",
            )),
        }
    };
}

/// The polynomial of the least degree from one state to another in a time: a state is the value, and behind it up to
/// four derivatives, for both ends as many.
///
/// >>> import kin
/// >>> kin.polynomial((0.0, 0.0, 0.0), (10.0, 5.0, 0.0), 2.0).at(2.0)[:3]
/// (10.0, 5.0, 0.0)
#[pyfunction]
#[expect(clippy::needless_pass_by_value, reason = "Python gives the numbers away")]
pub(crate) fn polynomial(start: Vec<f64>, end: Vec<f64>, duration: f64) -> PyResult<Law> {
    let states = [&start, &end].map(|state| Argument::Numbers(state.clone()));
    let [from, to] = states;
    let made = Call::new("polynomial", [from, to, duration.into()]);
    between!(start, end, duration, made; 1 + 1 = 2, 2 + 2 = 4, 3 + 3 = 6, 4 + 4 = 8, 5 + 5 = 10)
}

/// The most harmonics of a Fourier series.
const HARMONICS: usize = 16;

/// The Fourier series of a mean and harmonics over a period: `(a, b)` is a cos kωt + b sin kωt, for k = 1, 2, …
#[pyfunction]
pub(crate) fn fourier(mean: f64, harmonics: Vec<(f64, f64)>, period: f64) -> PyResult<Law> {
    if harmonics.len() > HARMONICS {
        return Err(PyValueError::new_err(format!(
            "there are {} harmonics: give {HARMONICS} at most",
            harmonics.len()
        )));
    }
    let harmonic = |index: usize| harmonics.get(index).map_or([0.0; 2], |(cosine, sine)| [*cosine, *sine]);
    let law = Fourier::<f64, HARMONICS>::new(mean, std::array::from_fn(harmonic), period);
    let made = Call::new("fourier", [mean.into(), Argument::Pairs(harmonics), period.into()]);
    Law::of(law, made)
}
