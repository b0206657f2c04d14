//! Bounds of forces that hold for all inputs of a way, and for all dimensions within tolerances.

use std::collections::BTreeMap;

use kin_core::any::{AssemblyChoice, Described};
use kin_core::reaction::{ForcePlace, ForceVerdict, ProofError, ProvenForce, ReactionError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::answers::answer;
use crate::fault;
use crate::linkage::Linkage;
use crate::loads::{Loads, part_name, refused_reaction};
use crate::made::{Reduced, reduced};
use crate::quantity::OfLoads;
use crate::sweep::{Sweep, Way};

/// The rows of the sweep, of which proofs take the ends alone.
const ROWS: usize = 2;

/// A force of which something is proved, for all inputs of a way and all dimensions within tolerances.
/// `kin.Sweep.proof` makes it.
///
/// Poses and forces are enclosed in intervals with all rounding. There are no proofs for friction and in space.
///
/// >>> import kin
/// >>> crank = kin.Mechanism("""
/// ...     struct Crank { r: Length }
/// ...     input theta: Angle;
/// ...     unknown x: Length;
/// ...     x == r * cos(theta);
/// ...     output pin: Point = r * cis(theta);
/// ...     ground 0;
/// ...     body arm: 0, pin;
/// ... """)(r=0.1)
/// >>> turn = crank.sweep(theta=(0, 6.283185307179586), speed=10.0)
/// >>> loads = crank.loads().mass(2.0, "pin")
/// >>> force = turn.proof(loads, "ground_arm", tolerances={"r": 0.001})
/// >>> force.below(20.3).answer, force.below(20.1).answer    # 2 · 0.101 · 10²
/// ('holds', 'fails')
/// >>> bounds = force.peak()
/// >>> bounds.lower.force <= 20.2 <= bounds.upper < 20.3
/// True
#[pyclass(frozen, module = "kin")]
#[derive(Debug)]
pub(crate) struct ForceProof {
    pub(crate) linkage: Linkage,
    pub(crate) choice: AssemblyChoice,
    pub(crate) ends: [Vec<f64>; 2],
    pub(crate) speed: f64,
    pub(crate) loads: Loads,
    pub(crate) wanted: OfLoads,
    pub(crate) tolerances: BTreeMap<String, f64>,
    pub(crate) speeds: Option<(f64, f64)>,
    pub(crate) accelerations: Option<(f64, f64)>,
    pub(crate) budget: Option<usize>,
}

impl ForceProof {
    fn prove<T: Send>(
        &self,
        py: Python<'_>,
        question: impl FnOnce(&ProvenForce<'_>) -> Result<T, ProofError> + Send,
    ) -> PyResult<T> {
        let found = py.detach(|| {
            let linkage = self.linkage.any();
            let reactions = self.loads.reactions(&linkage).map_err(ProofError::Reaction)?;
            let [from, to] = &self.ends;
            let sweep = linkage
                .sweep(self.choice.clone())
                .between(from, to, ROWS)
                .speed(self.speed);
            let mut proof = sweep.proof(&reactions);
            for (name, tolerance) in &self.tolerances {
                proof = proof.tolerance(name, *tolerance)?;
            }
            if let Some((low, high)) = self.speeds {
                proof = proof.speed_within(low..=high);
            }
            if let Some((low, high)) = self.accelerations {
                proof = proof.acceleration_within(low..=high);
            }
            if let Some(budget) = self.budget {
                proof = proof.budget(budget);
            }
            question(&match &self.wanted {
                OfLoads::Reaction(joint, part, _) => proof.of(joint, *part)?,
                OfLoads::Effort(input, _) => proof.of_effort(*input)?,
                OfLoads::Power(_) | OfLoads::Heat => unreachable!("proofs are made for forces and efforts"),
            })
        });
        found.map_err(|error| match error {
            ProofError::Reaction(error) if matches!(*error, ReactionError::Solve(_)) => {
                refused_reaction(py, &self.linkage, &error)
            }
            error => fault::of_answer(py, &self.linkage.declared.mechanism, error, None),
        })
    }

    fn place<'py>(&self, py: Python<'py>, place: &ForcePlace) -> PyResult<Bound<'py, PyAny>> {
        let dimensions = PyDict::new(py);
        let names = self.linkage.declared.description().parameters;
        for (quantity, value) in names.iter().zip(&place.dimensions) {
            dimensions.set_item(quantity.name, value)?;
        }
        let fields = (place.force, place.at, place.velocity, place.acceleration, dimensions);
        answer(py, "ForcePlace", fields)
    }
}

#[pymethods]
impl ForceProof {
    /// Whether the size of the force stays below a limit everywhere: a `kin.ForceVerdict`.
    fn below<'py>(&self, py: Python<'py>, limit: f64) -> PyResult<Bound<'py, PyAny>> {
        let verdict = self.prove(py, |force| force.below(limit))?;
        match verdict {
            ForceVerdict::Holds { upper, .. } => answer(py, "ForceVerdict", ("holds", upper, py.None(), "")),
            ForceVerdict::Fails(place) => answer(py, "ForceVerdict", ("fails", py.None(), self.place(py, &place)?, "")),
            ForceVerdict::Undecided(found) => {
                let reason = fault::named(&found, self.linkage.declared.mechanism.description());
                answer(py, "ForceVerdict", ("undecided", py.None(), py.None(), reason))
            }
        }
    }

    /// Bounds of the largest size of the force, which differ by a part of the lower one at most: a `kin.PeakBounds`.
    #[pyo3(signature = (part=1e-3))]
    fn peak<'py>(&self, py: Python<'py>, part: f64) -> PyResult<Bound<'py, PyAny>> {
        let found = self.prove(py, |force| force.peak(part))?;
        answer(py, "PeakBounds", (self.place(py, &found.lower)?, found.upper))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        let sweep = Sweep {
            linkage: self.linkage.clone(),
            choice: self.choice.clone(),
            way: Way::Line {
                ends: self.ends.clone(),
                speed: self.speed,
            },
            rows: ROWS,
        };
        let keywords = PyDict::new(py);
        match &self.wanted {
            OfLoads::Reaction(joint, part, _) => {
                keywords.set_item("joint", joint)?;
                keywords.set_item("part", part_name(*part))?;
            }
            OfLoads::Effort(input, _) => {
                let inputs = self.linkage.declared.description().inputs;
                keywords.set_item("input", inputs[*input].name)?;
            }
            OfLoads::Power(_) | OfLoads::Heat => unreachable!("proofs are made for forces and efforts"),
        }
        keywords.set_item("tolerances", &self.tolerances)?;
        keywords.set_item("speeds", self.speeds)?;
        keywords.set_item("accelerations", self.accelerations)?;
        keywords.set_item("budget", self.budget)?;
        let loads = Bound::new(py, self.loads.clone())?.into_any();
        reduced(Bound::new(py, sweep)?.getattr("proof")?, [loads], &keywords)
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}
