//! Answers as tuples with names, whose classes are declared in Python, in `kin._answers`.

use kin_core::extremes::{Extreme, ExtremeKind, Peak};
use pyo3::call::PyCallArgs;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// A tuple of a class.
pub(crate) fn answer<'py>(py: Python<'py>, class: &str, fields: impl PyCallArgs<'py>) -> PyResult<Bound<'py, PyAny>> {
    py.import("kin._answers")?.getattr(class)?.call1(fields)
}

pub(crate) fn peak<'py>(py: Python<'py>, peak: &Peak) -> PyResult<Bound<'py, PyAny>> {
    answer(py, "Peak", (peak.at, peak.value, kind(peak.kind)))
}

pub(crate) fn extreme<'py>(py: Python<'py>, found: &Extreme) -> PyResult<Bound<'py, PyAny>> {
    answer(
        py,
        "Extreme",
        (found.at, found.value, kind(found.kind), found.is_maximum),
    )
}

fn kind(kind: ExtremeKind) -> &'static str {
    match kind {
        ExtremeKind::Inner => "inner",
        ExtremeKind::Limit => "limit",
        ExtremeKind::Kink => "kink",
        ExtremeKind::End => "end",
        ExtremeKind::Unbounded => "unbounded",
    }
}

/// What a function of `kin._show` makes of arguments: how a notebook shows them.
pub(crate) fn shown<'py>(
    py: Python<'py>,
    function: &str,
    arguments: impl PyCallArgs<'py>,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    py.import("kin._show")?.getattr(function)?.call(arguments, options)
}
