//! The solver in JavaScript, or the poses themselves if it cannot be recorded.

use kin_core::tape::{self, Options};
use kin_core::{Mechanism, PlaneOrSpace as _, PointArray as _, Pose as _};

use super::way::{At, Way};
use crate::report::model::Frame;

/// The recorded solver and the names in it.
pub(super) struct Solver {
    pub(super) text: Option<String>,
    /// The reason why there is none.
    pub(super) unrecorded: Option<String>,
    pub(super) parameters: Vec<String>,
    pub(super) inputs: Vec<String>,
    pub(super) unknowns: Vec<String>,
    pub(super) outputs: Vec<String>,
    pub(super) near: Vec<String>,
    pub(super) assemblies: Vec<String>,
}

impl Solver {
    pub(super) fn record<M: Mechanism<Scalar = f64>>() -> Self {
        match tape::record::<M>(&Options::new().with_skeleton()) {
            Ok(tape) => {
                let names = tape.java_script_names();
                let (unknowns, outputs) = names.results.split_at(M::DESCRIPTION.unknowns.len());
                Self {
                    text: Some(tape.java_script()),
                    unrecorded: None,
                    parameters: names.parameters,
                    inputs: names.inputs,
                    unknowns: unknowns.to_vec(),
                    outputs: outputs.to_vec(),
                    near: names.near,
                    assemblies: names.assemblies,
                }
            }
            Err(error) => Self {
                text: None,
                unrecorded: Some(error.to_string()),
                parameters: Vec::new(),
                inputs: Vec::new(),
                unknowns: Vec::new(),
                outputs: Vec::new(),
                near: Vec::new(),
                assemblies: Vec::new(),
            },
        }
    }
}

/// The poses as the solver would find them.
pub(super) fn frames<M: Mechanism<Scalar = f64>>(way: &Way<M>, poses: &[At<M>]) -> Vec<Frame> {
    let frame = |(input, pose): &At<M>| {
        let Ok(pose) = pose else {
            return Frame {
                input: *input,
                values: Vec::new(),
                joints: Vec::new(),
                slides: Vec::new(),
            };
        };
        let (inputs, unknowns) = way.values(*input, pose);
        let places = way.mechanism.places(inputs, unknowns);
        let points: Vec<Vec<f64>> = places
            .as_slice()
            .iter()
            .map(|place| {
                let point = (*place).in_space();
                [point.x, point.y, point.z].map(super::short).to_vec()
            })
            .collect();
        let count = points.len().saturating_sub(M::OUTLINE.slides.len());
        let (joints, slides) = points.split_at(count);
        let (unknowns, outputs) = (pose.unknown_motions(), pose.output_motions());
        let motions = unknowns.as_ref().iter().chain(outputs.as_ref());
        Frame {
            input: *input,
            values: motions
                .map(|motion| motion.as_ref().iter().copied().map(super::short).collect())
                .collect(),
            joints: joints.to_vec(),
            slides: slides.to_vec(),
        }
    };
    poses.iter().map(frame).collect()
}
