//! The choice among several positions.

use kin_core::any::{AssemblyChoice, Described};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arguments::{self, Wanted};
use crate::declared::Declared;
use crate::fault::named;
use crate::pose::Pose;

/// The choice that the arguments `assembly` and `near` make.
pub(crate) fn choice(
    declared: &Declared,
    assembly: Option<&Bound<'_, PyAny>>,
    near: Option<&Bound<'_, PyAny>>,
) -> PyResult<AssemblyChoice> {
    let names = declared.mechanism.assembly_names();
    match (assembly, near) {
        (Some(_), Some(_)) => Err(PyTypeError::new_err("give `assembly` or `near`, and not both")),
        (None, Some(near)) => Ok(AssemblyChoice::Near(values_near(declared, near)?)),
        (Some(assembly), None) => {
            let name = assembly.extract::<String>();
            let name = name.map_err(|_| PyTypeError::new_err(format!("`assembly` is a name: {}", advice(declared))))?;
            let wanted = without_spaces(&name);
            let index = names.iter().position(|name| *name == wanted);
            let index = index.ok_or_else(|| {
                PyValueError::new_err(format!("no assembly is called \"{name}\": {}", advice(declared)))
            })?;
            Ok(AssemblyChoice::Index(index))
        }
        (None, None) if names.len() == 1 => Ok(AssemblyChoice::Index(0)),
        (None, None) => Err(PyTypeError::new_err(format!(
            "which position is meant? {}",
            advice(declared)
        ))),
    }
}

fn without_spaces(name: &str) -> String {
    name.chars().filter(|letter| !letter.is_whitespace()).collect()
}

/// What to write for a choice.
fn advice(declared: &Declared) -> String {
    let name = declared.description().name;
    let quoted = |name: &String| format!("assembly=\"{name}\"");
    match declared.mechanism.assembly_names().as_slice() {
        [] => format!(
            "positions of {name} are chosen by values of the unknowns, as in `near={{\"{}\": 0.5, …}}`, or by a pose \
             nearby; `positions` finds them",
            declared
                .description()
                .unknowns
                .first()
                .map_or("", |unknown| unknown.name)
        ),
        [_] => format!("{name} has one assembly, and needs no name for it"),
        names => {
            let names: Vec<String> = names.iter().map(quoted).collect();
            format!("write {}", names.join(" or "))
        }
    }
}

/// Values of the unknowns: those of a pose, by names, or in the order of the declaration.
fn values_near(declared: &Declared, near: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    let unknowns = declared.description().unknowns;
    if let Ok(pose) = near.cast::<Pose>() {
        let pose = pose.get();
        if pose.linkage.declared.text != declared.text {
            return Err(PyValueError::new_err(format!(
                "`near` is a pose of {}, and not of {}",
                pose.linkage.declared.description().name,
                declared.description().name
            )));
        }
        return Ok(pose.positions(1));
    }
    let values: Vec<Bound<'_, PyAny>> = if let Ok(named) = near.cast::<PyDict>() {
        let wanted = [Wanted {
            kind: "unknown",
            quantities: unknowns,
        }];
        arguments::values(Some(named), &wanted)?.pop().unwrap_or_default()
    } else {
        let count = near.len().map_err(|_| {
            PyTypeError::new_err("`near` is a pose, a dictionary of unknowns, or a sequence of their values")
        })?;
        if count != unknowns.len() {
            let names: Vec<String> = unknowns
                .iter()
                .map(|unknown| named(unknown.name, declared.description()))
                .collect();
            return Err(PyValueError::new_err(format!(
                "`near` has {count} numbers: give one for each of {}",
                names.join(", ")
            )));
        }
        (0..count).map(|index| near.get_item(index)).collect::<PyResult<_>>()?
    };
    let values = values.iter().zip(unknowns);
    values
        .map(|(value, unknown)| arguments::number(value, unknown))
        .collect()
}
