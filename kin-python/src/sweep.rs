//! The class of sweeps.

use kin_core::any::{AssemblyChoice, Described, Description};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arguments;
use crate::law::{Law, dwell};
use crate::linkage::Linkage;
use crate::made::{Reduced, reduced};

/// A sweep: a linkage whose inputs move. `kin.Linkage.sweep` makes it.
///
/// >>> import kin
/// >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
/// >>> turn = linkage.sweep(theta2=(0, 2 * 3.141592653589793), rows=361, speed=10.0, assembly="open")
/// >>> peak = turn.of("theta4_jerk").peak()
/// >>> round(peak.at, 4), round(peak.value, 1), peak.kind
/// (6.1529, 1638.3, 'inner')
#[pyclass(frozen, module = "kin")]
#[derive(Clone, Debug)]
pub(crate) struct Sweep {
    pub(crate) linkage: Linkage,
    pub(crate) choice: AssemblyChoice,
    pub(crate) way: Way,
    pub(crate) rows: usize,
}

/// How the inputs move.
#[derive(Clone, Debug)]
pub(crate) enum Way {
    Line { ends: [Vec<f64>; 2], speed: f64 },
    Laws { laws: Vec<Law>, range: [f64; 2] },
}

impl Sweep {
    /// The sweep that the arguments of `kin.Linkage.sweep` describe.
    pub(crate) fn new(
        linkage: Linkage,
        choice: AssemblyChoice,
        rows: usize,
        speed: Option<&Bound<'_, PyAny>>,
        inputs: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let way = way(linkage.declared.description(), speed, inputs)?;
        Ok(Self {
            linkage,
            choice,
            way,
            rows,
        })
    }

    /// The call of `kin.Linkage.sweep` that makes it.
    pub(crate) fn reduced<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        let keywords = PyDict::new(py);
        let declared = &self.linkage.declared;
        for (index, quantity) in declared.description().inputs.iter().enumerate() {
            match &self.way {
                Way::Line { ends: [from, to], .. } => keywords.set_item(quantity.name, (from[index], to[index]))?,
                Way::Laws { laws, .. } => keywords.set_item(quantity.name, laws[index].clone())?,
            }
        }
        if let Way::Line { speed, .. } = &self.way {
            keywords.set_item("speed", speed)?;
        }
        match &self.choice {
            AssemblyChoice::Index(index) => keywords.set_item("assembly", declared.mechanism.assembly_name(*index))?,
            AssemblyChoice::Near(near) => keywords.set_item("near", near)?,
        }
        keywords.set_item("rows", self.rows)?;
        let linkage = Bound::new(py, self.linkage.clone())?;
        reduced(linkage.getattr("sweep")?, [], &keywords)
    }
}

/// The index of the first input that moves.
pub(crate) fn lead(ends: &[Vec<f64>; 2]) -> Option<usize> {
    let [from, to] = ends;
    from.iter().zip(to).position(|(from, to)| from != to)
}

fn way(
    description: &Description<'_>,
    speed: Option<&Bound<'_, PyAny>>,
    inputs: Option<&Bound<'_, PyDict>>,
) -> PyResult<Way> {
    let quantities = description.inputs;
    let values = arguments::inputs(inputs, description)?;
    let laws: Vec<_> = values.iter().filter_map(|value| value.cast::<Law>().ok()).collect();
    if laws.is_empty() {
        let mut ends = [Vec::new(), Vec::new()];
        for (value, quantity) in values.iter().zip(quantities) {
            let name = quantity.name;
            let [from, to] = match value.len() {
                Err(_) => [arguments::number(value, quantity)?; 2],
                Ok(2) => [
                    arguments::number(&value.get_item(0)?, quantity)?,
                    arguments::number(&value.get_item(1)?, quantity)?,
                ],
                Ok(count) => {
                    return Err(PyValueError::new_err(format!(
                        "`{name}` has {count} numbers: give the two ends of its way, one number if it stands still, \
                         or a law"
                    )));
                }
            };
            ends[0].push(from);
            ends[1].push(to);
        }
        let lead = lead(&ends).unwrap_or(0);
        let speed = match (speed, quantities.get(lead)) {
            (Some(speed), Some(quantity)) => arguments::rate(speed, quantity, 1)?,
            _ => 1.0,
        };
        return Ok(Way::Line { ends, speed });
    }
    if speed.is_some() {
        return Err(PyTypeError::new_err("laws have their own speed: leave out `speed`"));
    }
    let durations = laws
        .iter()
        .map(|law| law.get().duration())
        .collect::<PyResult<Vec<f64>>>()?;
    let end = durations.into_iter().fold(0.0, f64::max);
    let law = |(value, quantity): (&Bound<'_, PyAny>, &kin_core::any::Quantity<'_>)| match value.cast::<Law>() {
        Ok(law) => Ok(law.get().clone()),
        Err(_) if value.len().is_ok() => Err(PyValueError::new_err(format!(
            "`{}` has two ends beside the law of another input: give it a law, or one number if it stands still",
            quantity.name
        ))),
        Err(_) => dwell(arguments::number(value, quantity)?, end),
    };
    let laws = values.iter().zip(quantities).map(law).collect::<PyResult<_>>()?;
    Ok(Way::Laws {
        laws,
        range: [0.0, end],
    })
}

/// Asks a sweep of kin-core, whose type depends on how the inputs move.
macro_rules! ask {
    ($sweep:expr, |$of_core:ident| $answer:expr) => {{
        let sweep: &$crate::sweep::Sweep = $sweep;
        let linkage = sweep.linkage.any();
        let assembled = linkage.sweep(sweep.choice.clone());
        match &sweep.way {
            $crate::sweep::Way::Line {
                ends: [from, to],
                speed,
            } => {
                let $of_core = assembled.between(from, to, sweep.rows).speed(*speed);
                $answer
            }
            $crate::sweep::Way::Laws { laws, range } => {
                let laws = laws
                    .iter()
                    .map($crate::law::Law::piecewise)
                    .collect::<pyo3::PyResult<Vec<_>>>();
                let laws = laws.expect("a law was put together before");
                let laws: Vec<&dyn kin_core::law::Piecewise<f64>> = laws.iter().map(|law| &**law).collect();
                let $of_core = assembled.under_laws(&laws, range[0]..=range[1], sweep.rows);
                $answer
            }
        }
    }};
}

pub(crate) use ask;
