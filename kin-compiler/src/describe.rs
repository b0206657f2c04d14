//! The description of a mechanism as data: names, dimensions, equations, blocks and costs.

use syn::{Attribute, Expr, Lit, Meta};

use crate::algebra::Graph;
use crate::model::{Dimension, Model};
use crate::program::{Cost, Mode, Names, Solvers};
use crate::structure::{Block, Method, Part};

/// The description of a mechanism, as `kin_core::any::Description` has it.
#[derive(Clone, PartialEq, Debug)]
pub struct Description {
    /// The name of the mechanism.
    pub name: String,
    /// The scalar parameters.
    pub parameters: Vec<DescribedQuantity>,
    /// The inputs.
    pub inputs: Vec<DescribedQuantity>,
    /// The unknowns.
    pub unknowns: Vec<DescribedQuantity>,
    /// The scalar outputs.
    pub outputs: Vec<DescribedQuantity>,
    /// The equations, as typed.
    pub equations: Vec<String>,
    /// The blocks, in the order in which they are solved.
    pub blocks: Vec<DescribedBlock>,
    /// The highest time derivative.
    pub order: usize,
    /// The cost of each order: additions, multiplications, divisions, negations, square roots, pairs of sine and
    /// cosine, arctangents, other functions.
    pub operations: Vec<[usize; 8]>,
}

/// A scalar quantity.
#[derive(Clone, PartialEq, Debug)]
pub struct DescribedQuantity {
    /// Its name, `p.x` for a part of a point.
    pub name: String,
    /// A length, an angle or a plain number.
    pub dimension: Dimension,
    /// The first paragraph of its documentation, on one line.
    pub text: String,
    /// Whether a range was declared for it.
    pub has_range: bool,
    /// Whether it is returned as a unit vector.
    pub is_direction: bool,
}

/// A block.
#[derive(Clone, PartialEq, Debug)]
pub struct DescribedBlock {
    /// The names of its unknowns, separated by commas.
    pub unknowns: String,
    /// Its solution, in words.
    pub solution: String,
    /// The indices of its unknowns.
    pub members: Vec<usize>,
    /// The indices of its scalar equations.
    pub equations: Vec<usize>,
}

/// The description of a mechanism.
pub(crate) fn description(model: &Model, blocks: &[Block], solvers: &Solvers) -> Description {
    let parameters = model.parameters.iter().flat_map(|parameter| {
        let names = parameter.dimension.shape().part_names(&parameter.name.to_string(), ".");
        scalars(names, parameter.dimension, &parameter.attributes)
    });
    let inputs = model
        .inputs
        .iter()
        .map(|input| quantity(input.name.to_string(), input.dimension, &input.documentation));
    let unknowns = model.unknowns.iter().map(|unknown| DescribedQuantity {
        has_range: unknown.range.is_some(),
        ..quantity(unknown.name.to_string(), unknown.dimension, &unknown.documentation)
    });
    let outputs = model.outputs.iter().flat_map(|output| {
        let names = output.value.shape().part_names(&output.name.to_string(), ".");
        scalars(names, output.dimension, &output.documentation)
    });
    Description {
        name: model.name.to_string(),
        parameters: parameters.collect(),
        inputs: inputs.collect(),
        unknowns: unknowns.collect(),
        outputs: outputs.collect(),
        equations: model.equations.iter().map(|equation| equation.text.clone()).collect(),
        blocks: blocks
            .iter()
            .map(|block| DescribedBlock {
                unknowns: names(model, &block.unknowns),
                solution: solution(model, &solvers.graph, block),
                members: block.unknowns.clone(),
                equations: block.equations.clone(),
            })
            .collect(),
        order: solvers.order(),
        operations: solvers.orders().iter().map(|stage| counts(stage.cost)).collect(),
    }
}

/// The names of unknowns, separated by commas.
pub(crate) fn names(model: &Model, unknowns: &[usize]) -> String {
    let names = unknowns.iter().map(|&unknown| model.unknowns[unknown].name.to_string());
    names.collect::<Vec<_>>().join(", ")
}

/// The indices of the parts that leave a choice to the caller, in order.
pub(crate) fn choices(solvers: &Solvers) -> Vec<usize> {
    (0..solvers.choices.len())
        .filter(|&part| matches!(solvers.choices[part].mode, Mode::Assembly(_)))
        .collect()
}

/// The names of these choices: the unknowns of each part, joined.
pub(crate) fn choice_names(model: &Model, blocks: &[Block], solvers: &Solvers) -> Vec<String> {
    let parts: Vec<&Part> = blocks.iter().flat_map(|block| &block.parts).collect();
    let mut names = Names::default();
    let mut name = |part: usize| {
        let unknowns = parts[part].unknowns.iter();
        let unknowns: Vec<String> = unknowns
            .map(|&unknown| model.unknowns[unknown].name.to_string())
            .collect();
        // `a_b` and `c` give the same name as `a` and `b_c`
        names.unique(&unknowns.join("_"))
    };
    choices(solvers).into_iter().map(&mut name).collect()
}

/// The solution of a block, part by part.
pub(crate) fn solution(model: &Model, graph: &Graph, block: &Block) -> String {
    if let [only] = block.parts.as_slice() {
        return solution_of_part(graph, only);
    }
    let parts = block
        .parts
        .iter()
        .map(|part| format!("{} for {}", solution_of_part(graph, part), names(model, &part.unknowns)));
    parts.collect::<Vec<_>>().join(", then ")
}

/// The solution of a part.
pub(crate) fn solution_of_part(graph: &Graph, part: &Part) -> String {
    match &part.method {
        Method::Closed(form) => form.description(graph),
        Method::Newton { is_given_up: false, .. } => "Newton's method".to_owned(),
        Method::Newton { is_given_up: true, .. } => {
            "Newton's method (the equations are too large to look for a closed form)".to_owned()
        }
    }
}

/// The counts of a cost, in the order of [`Description::operations`].
pub(crate) fn counts(cost: Cost) -> [usize; 8] {
    [
        cost.additions,
        cost.multiplications,
        cost.divisions,
        cost.negations,
        cost.square_roots,
        cost.sine_cosines,
        cost.arc_tangents,
        cost.others,
    ]
}

/// The scalar parts of a quantity.
fn scalars(names: Vec<String>, dimension: Dimension, attributes: &[Attribute]) -> Vec<DescribedQuantity> {
    let each = |name| quantity(name, dimension, attributes);
    names.into_iter().map(each).collect()
}

fn quantity(name: String, dimension: Dimension, attributes: &[Attribute]) -> DescribedQuantity {
    DescribedQuantity {
        name,
        dimension: match dimension {
            Dimension::Length | Dimension::Point | Dimension::Vector | Dimension::Point3 | Dimension::Vector3 => {
                Dimension::Length
            }
            Dimension::Angle | Dimension::Direction => Dimension::Angle,
            Dimension::Scalar => Dimension::Scalar,
        },
        text: first_paragraph(attributes),
        has_range: false,
        is_direction: dimension == Dimension::Direction,
    }
}

/// The first paragraph of a documentation comment, on one line.
fn first_paragraph(attributes: &[Attribute]) -> String {
    attributes
        .iter()
        .filter_map(|attribute| match &attribute.meta {
            Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
                Expr::Lit(literal) => match &literal.lit {
                    Lit::Str(text) => Some(text.value().trim().to_owned()),
                    _ => None,
                },
                _ => None,
            },
            _ => None,
        })
        .take_while(|line| !line.is_empty())
        .collect::<Vec<_>>()
        .join(" ")
}
