//! The class of a mechanism with its dimensions.

use std::sync::Arc;

use kin_core::linkage::AnyLinkage;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arguments;
use crate::declared::Declared;
use crate::mechanism::Mechanism;

/// A mechanism with its dimensions. Calling a `kin.Mechanism` makes it.
///
/// >>> import kin
/// >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
/// >>> linkage
/// FourBar(r1=90.0, r2=30.0, r3=70.0, r4=60.0)
/// >>> linkage.assemblies
/// ('open', 'crossed')
#[pyclass(frozen, module = "kin")]
#[derive(Clone, Debug)]
pub(crate) struct Linkage {
    pub(crate) declared: Arc<Declared>,
    pub(crate) parameters: Arc<[f64]>,
}

impl Linkage {
    pub(crate) fn any(&self) -> AnyLinkage<'_> {
        AnyLinkage::new(&self.declared.mechanism, &self.parameters)
    }

    /// The inputs with all orders, one after the other.
    pub(crate) fn inputs(&self, given: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<f64>> {
        let description = self.declared.description();
        let mut inputs = Vec::new();
        for (value, quantity) in arguments::inputs(given, description)?.iter().zip(description.inputs) {
            inputs.extend(arguments::motion(value, quantity, self.declared.orders())?);
        }
        Ok(inputs)
    }
}

/// A linkage that was pickled.
#[pyfunction]
pub(crate) fn restored_linkage(mechanism: &Bound<'_, Mechanism>, parameters: Vec<f64>) -> PyResult<Linkage> {
    let declared = Arc::clone(&mechanism.get().declared);
    if parameters.len() != declared.description().parameters.len() {
        return Err(PyValueError::new_err("these are not the dimensions of this mechanism"));
    }
    Ok(Linkage {
        declared,
        parameters: parameters.into(),
    })
}
