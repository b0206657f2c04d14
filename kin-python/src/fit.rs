//! Dimensions that meet measured numbers.

use std::f64::consts::TAU;
use std::ops::RangeInclusive;

use kin_core::Dimension;
use kin_core::any::{AssemblyChoice, Description};
use kin_fit::{Candidate, Choice, Fit, FitError, Measured, Objective, usual_bounds};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

use crate::answers::answer;
use crate::arguments::{input_index, number};
use crate::fault;
use crate::linkage::Linkage;

/// How the inputs of the rows are found that no column gives.
pub(crate) struct FitWay<'a, 'py> {
    /// The name of the input that moves.
    pub(crate) moving: Option<&'a str>,
    pub(crate) range: Option<(f64, f64)>,
    /// Values of the other inputs.
    pub(crate) standing: Option<&'a Bound<'py, PyDict>>,
}

/// Fits dimensions to rows.
pub(crate) fn fit<'py>(
    py: Python<'py>,
    linkage: &Linkage,
    data: &Bound<'py, PyAny>,
    vary: Option<&Bound<'py, PyAny>>,
    choice: AssemblyChoice,
    way: &FitWay<'_, '_>,
) -> PyResult<Bound<'py, PyAny>> {
    let description = linkage.declared.description();
    let moving = input_index(description, way.moving)?;
    let (measured, names) = rows(description, data)?;
    let mut standing = vec![0.0; description.inputs.len()];
    for (index, quantity) in description.inputs.iter().enumerate() {
        let given = way
            .standing
            .map(|standing| standing.get_item(quantity.name))
            .transpose()?;
        if let Some(value) = given.flatten() {
            standing[index] = number(&value, quantity)?;
        } else if index != moving && measured.inputs.iter().any(|row| row[index].is_none()) {
            return Err(PyTypeError::new_err(format!("missing: input `{}`", quantity.name)));
        }
    }
    let bounds = bounds(linkage, vary)?;
    let range = match (way.range, description.inputs[moving].dimension) {
        (Some((from, to)), _) => [from, to],
        (None, Dimension::Angle) => [0.0, TAU],
        (None, _) if measured.inputs.iter().all(|row| row[moving].is_some()) => [0.0, 1.0],
        (None, _) => {
            let name = description.inputs[moving].name;
            return Err(PyTypeError::new_err(format!(
                "`{name}` is not known in all rows: give the `range` in which it is sought"
            )));
        }
    };
    let choice = match choice {
        AssemblyChoice::Index(index) => Choice::Assembly(index),
        AssemblyChoice::Near(near) => {
            let first = measured.inputs.first().into_iter().flatten().zip(&standing);
            let inputs = first.map(|(input, standing)| input.unwrap_or(*standing)).collect();
            Choice::From { inputs, near }
        }
    };
    let functions = linkage.declared.for_fits();
    let found = py.detach(|| {
        let mut objective = Objective::measured(functions, &measured, moving, &standing, range)?;
        for (name, bounds) in bounds {
            objective = objective.bounds(&name, bounds)?;
        }
        let start = Candidate::with_parameters(linkage.parameters.to_vec(), choice);
        let fit = Fit::new(objective, &start)?;
        let fitted = fit.least();
        let deviations = [&fitted.design, fit.start()].map(|design| fit.deviations(design));
        Ok((fit.unclosed_rows(&fitted.design), deviations, fitted))
    });
    let (unclosed, deviations, fitted) =
        found.map_err(|error: FitError| fault::of_answer(py, &linkage.declared.mechanism, error, None))?;
    let [deviations, at_start] = deviations.map(|deviations| {
        let all = PyDict::new(py);
        for (name, deviation) in names.iter().zip(deviations) {
            all.set_item(name, deviation.map(|deviation| deviation.root_mean_square))?;
        }
        Ok::<_, PyErr>(all)
    });
    let linkage = Linkage {
        parameters: fitted.design.parameters().into(),
        ..linkage.clone()
    };
    let is_minimum = fitted.lowering.is_none();
    answer(py, "Fitted", (linkage, deviations?, at_start?, is_minimum, unclosed))
}

/// The rows of columns by their names, and the names of those that are to be met.
fn rows(description: &Description<'_>, data: &Bound<'_, PyAny>) -> PyResult<(Measured, Vec<String>)> {
    let py = data.py();
    let quantities = || description.unknowns.iter().chain(description.outputs);
    let mut measured = Measured::default();
    let mut columns: Vec<(Option<usize>, Vec<f64>)> = Vec::new();
    let mut names = Vec::new();
    for name in data.try_iter()? {
        let name: String = name?.extract()?;
        let input = description.inputs.iter().position(|input| input.name == name);
        let column = quantities().position(|quantity| quantity.name == name);
        if input.is_none() {
            let Some(column) = column else {
                let all = description
                    .inputs
                    .iter()
                    .chain(quantities())
                    .map(|quantity| quantity.name);
                let all = all.collect::<Vec<_>>().join(", ");
                return Err(PyValueError::new_err(format!(
                    "no quantity is called `{name}`: there are {all}"
                )));
            };
            measured.columns.push(column);
            names.push(name.clone());
        }
        let keywords = PyDict::new(py);
        keywords.set_item("dtype", "float64")?;
        let numpy = py.import("numpy")?;
        let values = numpy.call_method("ravel", (data.get_item(&name)?,), None)?;
        let values = numpy.call_method("ascontiguousarray", (values,), Some(&keywords))?;
        let values = values.cast_into::<PyArray1<f64>>().map_err(PyErr::from)?.to_vec()?;
        if let Some((_, first)) = columns.first()
            && first.len() != values.len()
        {
            return Err(PyValueError::new_err(format!(
                "`{name}` has {} numbers, and the column before it {}",
                values.len(),
                first.len()
            )));
        }
        columns.push((input, values));
    }
    let known = |value: f64| (!value.is_nan()).then_some(value);
    for row in 0..columns.first().map_or(0, |(_, values)| values.len()) {
        let mut inputs = vec![None; description.inputs.len()];
        let mut values = Vec::new();
        for (input, column) in &columns {
            match input {
                Some(index) => inputs[*index] = known(column[row]),
                None => values.push(known(column[row])),
            }
        }
        measured.inputs.push(inputs);
        measured.values.push(values);
    }
    Ok((measured, names))
}

/// The dimensions that are sought, with their bounds.
fn bounds(linkage: &Linkage, vary: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<(String, RangeInclusive<f64>)>> {
    let description = linkage.declared.description();
    let mut found = Vec::new();
    let mut add = |name: &str, bounds: Option<(f64, f64)>| {
        let is_meant = |own: &str| own == name || own.strip_prefix(name).is_some_and(|rest| rest.starts_with('.'));
        let before = found.len();
        for (index, quantity) in description.parameters.iter().enumerate() {
            if is_meant(quantity.name) {
                let usual = || usual_bounds(description, &linkage.parameters, index);
                let bounds = bounds.map_or_else(usual, |(low, high)| low..=high);
                found.push((quantity.name.to_owned(), bounds));
            }
        }
        if found.len() == before {
            let all = description.parameters.iter().map(|quantity| quantity.name);
            let all = all.collect::<Vec<_>>().join(", ");
            return Err(PyValueError::new_err(format!(
                "no dimension is called `{name}`: dimensions are {all}"
            )));
        }
        Ok(())
    };
    match vary {
        None => {
            for quantity in description.parameters {
                add(quantity.name, None)?;
            }
        }
        Some(vary) if vary.is_instance_of::<PyString>() => add(&vary.extract::<String>()?, None)?,
        Some(vary) => {
            let bounds = vary.cast::<PyDict>().ok();
            for name in vary.try_iter()? {
                let name: String = name?.extract()?;
                let own = bounds.map(|bounds| bounds.get_item(&name)).transpose()?.flatten();
                add(&name, own.map(|own| own.extract()).transpose()?.flatten())?;
            }
        }
    }
    Ok(found)
}
