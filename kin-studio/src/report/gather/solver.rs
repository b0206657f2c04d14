//! The solver in JavaScript, or the poses themselves if it cannot be recorded.

use kin_core::tape::{Options, record_any};

use super::way::At;
use crate::report::draft::Wishes;
use crate::report::functions::ReportFunctions;
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
    pub(super) fn record(functions: &dyn ReportFunctions) -> Self {
        match record_any::<f64>(functions, &Options::new().with_skeleton()) {
            Ok(tape) => {
                let names = tape.java_script_names();
                let (unknowns, outputs) = names.results.split_at(functions.description().unknowns.len());
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
pub(super) fn frames(wishes: &Wishes<'_>, poses: &[At]) -> Vec<Frame> {
    let (functions, parameters) = (wishes.functions, wishes.linkage.parameters());
    let slides = functions.outline().slides.len();
    let shortened = |values: &[f64]| values.iter().copied().map(super::short).collect::<Vec<f64>>();
    let frame = |(input, pose): &At| {
        let Ok(pose) = pose else {
            return Frame {
                input: *input,
                values: Vec::new(),
                joints: Vec::new(),
                slides: Vec::new(),
            };
        };
        let mut points: Vec<Vec<f64>> = Vec::new();
        functions.skeleton_points(parameters, pose.inputs(), pose.unknowns(), &mut |point| {
            points.push(shortened(point));
        });
        let (joints, slides) = points.split_at(points.len().saturating_sub(slides));
        Frame {
            input: *input,
            values: pose.results().map(shortened).collect(),
            joints: joints.to_vec(),
            slides: slides.to_vec(),
        }
    };
    poses.iter().map(frame).collect()
}
