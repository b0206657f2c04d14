//! Exceptions. Their classes are declared in Python, in `kin._errors`.

use std::fmt::Display;

use kin_core::any::{Described, Description, Named, Quantity};
use kin_core::extremes::ExtremesError;
use kin_core::{Failure, SolveError, TrackError};
use kin_live::{DeclareError, Mechanism};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyList, PyType};

const MODULE: &str = "kin._errors";

/// The exception for a text that declares no mechanism.
pub(crate) fn of_declaration(py: Python<'_>, error: &DeclareError, text: &str) -> PyErr {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    static MISTAKE: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let made = || {
        let class = CLASS.import(py, MODULE, "DeclarationError")?;
        let mistakes = PyList::empty(py);
        let mut shown = Vec::new();
        if let DeclareError::Mistakes(found) = error {
            let mistake_class = MISTAKE.import(py, MODULE, "Mistake")?;
            for mistake in found {
                let [start, end] = [mistake.start, mistake.end];
                mistakes.append(mistake_class.call1((
                    mistake.message.as_str(),
                    mistake.fault(),
                    mistake.advice(),
                    start.line,
                    start.column,
                    end.line,
                    end.column,
                ))?)?;
                shown.push(kin_studio::file::marked(mistake, "declaration", text));
            }
        } else {
            shown.push(error.to_string());
        }
        class.call1((shown.join("\n\n"), mistakes, text))
    };
    made().map_or_else(|error| error, PyErr::from_value)
}

/// The exception for inputs at which a mechanism does not close.
pub(crate) fn of_solver(py: Python<'_>, mechanism: &Mechanism, error: &SolveError) -> PyErr {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let description = mechanism.description();
    let made = || {
        let inputs = PyDict::new(py);
        for (name, value) in error.inputs.iter() {
            inputs.set_item(named(name, description), value)?;
        }
        let block = named(error.block, description);
        CLASS.import(py, MODULE, "SolveError")?.call1((
            named(error, description),
            block,
            kind(&error.failure),
            error.margin(),
            inputs,
        ))
    };
    made().map_or_else(|error| error, PyErr::from_value)
}

/// The exception for a motion that ends before its target.
pub(crate) fn of_track(py: Python<'_>, mechanism: &Mechanism, error: &TrackError<Vec<f64>, Vec<f64>>) -> PyErr {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let description = mechanism.description();
    let (kind, fraction, inputs, unknowns) = match error {
        TrackError::Failed(error) => return of_solver(py, mechanism, error),
        TrackError::TooManySteps(stop) => ("too many steps".to_owned(), stop.fraction, &stop.inputs, &stop.unknowns),
        TrackError::Lost(stop) => ("lost".to_owned(), stop.fraction, &stop.inputs, &stop.unknowns),
        TrackError::TurningPoint(limit) | TrackError::ChangePoint(limit) | TrackError::Pole(limit) => {
            let kind = error.limit().map_or_else(String::new, |(kind, _)| kind.to_string());
            (kind, limit.fraction, &limit.inputs, &limit.unknowns)
        }
        _ => return of_answer(py, mechanism, error, None),
    };
    let made = || {
        let values = |quantities: &[Quantity<'_>], values: &[f64]| {
            let all = PyDict::new(py);
            for (quantity, value) in quantities.iter().zip(values) {
                all.set_item(quantity.name, value)?;
            }
            Ok::<_, PyErr>(all)
        };
        CLASS.import(py, MODULE, "TrackError")?.call1((
            named(error, description),
            kind,
            fraction,
            values(description.inputs, inputs)?,
            values(description.unknowns, unknowns)?,
        ))
    };
    made().map_or_else(|error| error, PyErr::from_value)
}

/// The exception for a question to a sweep that has no answer.
pub(crate) fn of_extremes(py: Python<'_>, mechanism: &Mechanism, error: &ExtremesError) -> PyErr {
    let at = match error {
        ExtremesError::NothingCloses(first) => {
            let answer = of_answer(py, mechanism, error, None);
            answer.set_cause(py, Some(of_solver(py, mechanism, first)));
            return answer;
        }
        ExtremesError::NoLength { at }
        | ExtremesError::Unresolved { at, .. }
        | ExtremesError::Gap { at }
        | ExtremesError::NotFinite { at }
        | ExtremesError::NoSensitivity { at, .. }
        | ExtremesError::Unbounded { at }
        | ExtremesError::Diverges { at, .. } => Some(*at),
        _ => None,
    };
    of_answer(py, mechanism, error, at)
}

/// The exception for a question that has no answer.
pub(crate) fn of_answer(py: Python<'_>, mechanism: &Mechanism, error: impl Display, at: Option<f64>) -> PyErr {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let message = named(error, mechanism.description());
    let made = || CLASS.import(py, MODULE, "AnswerError")?.call1((message, at));
    made().map_or_else(|error| error, PyErr::from_value)
}

/// A text with the names of a mechanism.
pub(crate) fn named(value: impl Display, description: &Description<'_>) -> String {
    Named::new(value, description).to_string()
}

fn kind(failure: &Failure) -> &'static str {
    match failure {
        Failure::OutOfReach { .. } => "out of reach",
        Failure::Singular { .. } => "singular",
        Failure::OutOfRange { .. } => "out of range",
        Failure::Ambiguous { .. } => "ambiguous",
        Failure::OutsideDomain { .. } => "outside domain",
        Failure::NotConverged { .. } => "not converged",
        Failure::TooManyRevolutions { .. } => "too many revolutions",
        Failure::NotFinite { .. } => "not finite",
        _ => "other",
    }
}
