//! Motion laws of inputs.

use kin_core::law::{Dwell, LawError, Piecewise, Rise, Sequence, Shape};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// A motion law: an input over the time. `kin.rise` and `kin.dwell` make laws, and `+` puts one behind another.
///
/// >>> import kin
/// >>> law = kin.rise("modified sine", 0.0, 1.5, 0.2) + kin.dwell(1.5, 0.1)
/// >>> law.duration
/// 0.30000000000000004
#[pyclass(frozen, module = "kin")]
#[derive(Clone, Debug)]
pub(crate) struct Law {
    parts: Vec<Part>,
}

#[derive(Clone, Copy, Debug)]
enum Part {
    Rise(Rise),
    Dwell(Dwell),
}

fn refused(error: LawError) -> PyErr {
    PyValueError::new_err(error.to_string())
}

impl Law {
    /// The law as a sweep takes it.
    pub(crate) fn piecewise(&self) -> PyResult<Box<dyn Piecewise<f64>>> {
        let parts = self.parts.iter().map(|part| -> Box<dyn Piecewise<f64>> {
            match *part {
                Part::Rise(rise) => Box::new(rise),
                Part::Dwell(dwell) => Box::new(dwell),
            }
        });
        let mut parts: Vec<_> = parts.collect();
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

    fn __add__(&self, next: &Self) -> PyResult<Self> {
        let law = Self {
            parts: self.parts.iter().chain(&next.parts).copied().collect(),
        };
        law.piecewise()?;
        Ok(law)
    }

    fn __repr__(&self) -> PyResult<String> {
        Ok(format!("<kin.Law of the duration {}>", self.duration()?))
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

/// The law of a rise from one value to another in a time.
///
/// Shapes are "constant speed", "simple harmonic", "cycloidal", "3-4-5", "4-5-6-7", "5-6-7-8-9", "modified sine" and
/// "modified trapezoid".
#[pyfunction]
#[pyo3(signature = (shape, start, end, duration))]
pub(crate) fn rise(shape: &str, start: f64, end: f64, duration: f64) -> PyResult<Law> {
    let found = SHAPES.iter().find(|(name, _)| *name == shape);
    let (_, shape) = found.ok_or_else(|| {
        let names = SHAPES.map(|(name, _)| format!("\"{name}\"")).join(", ");
        PyValueError::new_err(format!("no shape of a rise is called \"{shape}\": there are {names}"))
    })?;
    let rise = Rise::new(*shape, start, end, duration).map_err(refused)?;
    Ok(Law {
        parts: vec![Part::Rise(rise)],
    })
}

/// The law of an input that stands still for a time.
#[pyfunction]
pub(crate) fn dwell(value: f64, duration: f64) -> PyResult<Law> {
    let dwell = Dwell::new(value, duration).map_err(refused)?;
    Ok(Law {
        parts: vec![Part::Dwell(dwell)],
    })
}
