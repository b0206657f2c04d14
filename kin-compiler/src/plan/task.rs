//! The task: the contents of a declaration, as the planner needs them.

use std::collections::{BTreeMap, BTreeSet};

use super::MOST_EXPRESSIONS;
use crate::algebra::{Graph, Node, Symbol};
use crate::model::{Dimension, Model, Request, ValueShape};
use crate::passes::Passes;
use crate::program::{DeclaredRange, Names, OWN_NAMES};
use crate::structure::{Block, Structure};

/// The equations to solve, and the decisions about their solution.
pub(crate) struct Task<'a> {
    pub(crate) graph: &'a Graph,
    pub(crate) residuals: &'a [Node],
    pub(crate) blocks: &'a [Block],
    pub(crate) ranges: BTreeMap<usize, DeclaredRange>,
    /// The unknown angles that are returned as unit vectors.
    pub(crate) directions: BTreeSet<usize>,
    /// The scalar parts of the outputs.
    pub(crate) outputs: Vec<Node>,
    pub(crate) inputs: usize,
    pub(crate) order: usize,
    /// The number of scalar parameters by which the motion is differentiated: all of them, or none.
    pub(crate) parameters: usize,
    /// Names of parameters, inputs, unknowns and outputs.
    pub(crate) names: Names,
    /// The passes that make the program cheaper.
    pub(crate) passes: Passes,
    /// The number of expressions above which the planner gives up.
    pub(crate) most_expressions: usize,
}

impl<'a> Task<'a> {
    pub(crate) fn new(model: &Model, structure: &'a Structure, passes: Passes) -> Self {
        Self {
            graph: &structure.graph,
            residuals: &structure.residuals,
            blocks: &structure.blocks,
            ranges: ranges(model),
            directions: directions(model),
            outputs: model.outputs.iter().flat_map(|output| output.value.nodes()).collect(),
            inputs: model.inputs.len(),
            order: model.order,
            parameters: sensitive_parameters(model),
            names: names(model),
            passes,
            most_expressions: MOST_EXPRESSIONS,
        }
    }
}

/// The ranges that were declared for unknowns.
fn ranges(model: &Model) -> BTreeMap<usize, DeclaredRange> {
    let unknowns = model.unknowns.iter().enumerate();
    unknowns
        .filter_map(|(index, unknown)| {
            let range = unknown.range.as_ref()?;
            let limits = DeclaredRange {
                low: range.low,
                high: range.high,
            };
            Some((index, limits))
        })
        .collect()
}

/// The unknowns that are returned as unit vectors.
fn directions(model: &Model) -> BTreeSet<usize> {
    (0..model.unknowns.len())
        .filter(|&unknown| model.unknowns[unknown].dimension == Dimension::Direction)
        .collect()
}

/// The number of scalar parameters if sensitivities are requested, otherwise zero.
fn sensitive_parameters(model: &Model) -> usize {
    if !model.is_requested(Request::Sensitivities) {
        return 0;
    }
    let parameters = model.parameters.iter();
    parameters
        .map(|parameter| parameter.dimension.shape().axes().len().max(1))
        .sum()
}

/// The names in the declaration, and those that generated code needs for itself.
fn names(model: &Model) -> Names {
    let mut names = Names::default();
    for name in OWN_NAMES {
        names.reserve(name);
        names.reserve(&model.own_name(name));
    }
    let mut scalar = 0;
    let mut name_parameter = |names: &mut Names, wish: &str| {
        names.name(Symbol::Parameter(scalar), wish);
        scalar += 1;
    };
    for (index, input) in model.inputs.iter().enumerate() {
        names.name_exactly(Symbol::Input(index), &input.name.to_string());
    }
    for (index, unknown) in model.unknowns.iter().enumerate() {
        names.name_exactly(Symbol::Unknown(index), &unknown.name.to_string());
    }
    let mut output_part = 0;
    for output in &model.outputs {
        // the field of a pose has the name of the output
        names.reserve(&output.name.to_string());
    }
    for parameter in &model.parameters {
        for part in parameter.dimension.shape().part_names(&parameter.name.to_string(), "_") {
            name_parameter(&mut names, &part);
        }
    }
    for output in &model.outputs {
        let name = output.name.to_string();
        let parts = match output.value.shape() {
            ValueShape::Scalar => vec![format!("{name}_value")],
            shape => shape.part_names(&name, "_"),
        };
        for part in parts {
            names.name(Symbol::OutputRate(output_part, 0), &part);
            output_part += 1;
        }
    }
    names
}
