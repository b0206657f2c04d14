//! The whole way from a declaration to a solver, on one page.

use std::collections::BTreeMap;

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::quote;

use crate::assemble::{Limits, Names};
use crate::expr::{Node, Symbol};
use crate::model::{Model, Request, Requested, Shape};
use crate::refuse::{Origin, refuse, refuse_ranges, refuse_requests};
use crate::report::Report;
use crate::{emit, fallback, model, plan, structure, syntax};

/// Expands `(path::to::kin) declaration`. Mistakes are told after the pass that finds them; after the last check nothing can fail.
pub(crate) fn expand(tokens: TokenStream) -> TokenStream {
    let (runtime, tokens) = runtime(tokens);
    let mut report = Report::new();

    let Some(declaration) = syntax::parse(tokens, &mut report) else {
        return fallback::tokens(None, report, &runtime);
    };
    let Some(model) = model::build(&declaration, &mut report) else {
        return fallback::tokens(Some(&declaration), report, &runtime);
    };
    let mut graph = model.graph.clone();
    let (residuals, origins) = scalar_equations(&model);
    let blocks = match structure::analyse(&mut graph, &residuals, model.unknowns.len()) {
        Ok(blocks) => blocks,
        Err(faults) => {
            refuse(&model, &origins, &faults, &mut report);
            return fallback::tokens(Some(&declaration), report, &runtime);
        }
    };
    refuse_ranges(&model, &blocks, &mut report);
    refuse_requests(&model, &graph, &residuals, &blocks, &mut report);
    if !report.is_empty() {
        return fallback::tokens(Some(&declaration), report, &runtime);
    }
    let ranges = ranges(&model);
    let outputs: Vec<Node> = model.outputs.iter().flat_map(|output| output.value.nodes()).collect();
    let plan = plan::plan(&plan::Task {
        graph: &graph,
        residuals: &residuals,
        blocks: &blocks,
        ranges: &ranges,
        outputs: &outputs,
        inputs: model.inputs.len(),
        order: model.order,
        parameters: sensitive_parameters(&model),
        names: &names(&model),
    });
    emit::tokens(&emit::Mechanism {
        declaration: &declaration,
        model: &model,
        graph: &plan.graph,
        blocks: &blocks,
        ranges: &ranges,
        plan: &plan,
        runtime: &runtime,
        goes_through_all: false,
    })
}

/// The path to what generated code calls, and the declaration behind it. `mechanism!` passes its own crate, under whatever name
/// it is known to the user.
fn runtime(tokens: TokenStream) -> (TokenStream, TokenStream) {
    let mut tokens = tokens.into_iter().peekable();
    let path =
        tokens.next_if(|token| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis));
    let runtime = if let Some(TokenTree::Group(path)) = path {
        let path = path.stream();
        quote!(#path::__private)
    } else {
        quote!(::kin_core::__private)
    };
    (runtime, tokens.collect())
}

/// How many numbers the motion is to be differentiated by: all that the structure of parameters holds, or none.
fn sensitive_parameters(model: &Model) -> usize {
    let is_sensitivities = |requested: &Requested| requested.request == Request::Sensitivities;
    if !model.requests.iter().any(is_sensitivities) {
        return 0;
    }
    model
        .parameters
        .iter()
        .map(|parameter| parameter.dimension.shape().axes().len().max(1))
        .sum()
}

/// The parts of the equations, and where each comes from.
pub(crate) fn scalar_equations(model: &Model) -> (Vec<Node>, Vec<Origin>) {
    let (mut residuals, mut origins) = (Vec::new(), Vec::new());
    for (equation, declared) in model.equations.iter().enumerate() {
        let axes = declared.residual.shape().axes();
        for (part, node) in declared.residual.nodes().into_iter().enumerate() {
            residuals.push(node);
            origins.push(Origin {
                equation,
                part: axes.get(part).map_or("equation", |axis| axis.part_of_equation()),
            });
        }
    }
    (residuals, origins)
}

fn ranges(model: &Model) -> BTreeMap<usize, Limits> {
    model
        .unknowns
        .iter()
        .enumerate()
        .filter_map(|(index, unknown)| {
            let range = unknown.range.as_ref()?;
            Some((
                index,
                Limits {
                    low: range.low,
                    high: range.high,
                },
            ))
        })
        .collect()
}

/// The names that the declaration gives, and those that generated code needs for itself.
pub(crate) fn names(model: &Model) -> Names {
    let mut names = Names::default();
    for reserved in [
        "assembly",
        "near",
        "failure",
        "pose",
        "position",
        "result",
        "candidate",
        "size",
        "first",
        "second",
    ] {
        names.reserve(reserved);
    }
    let mut scalar = 0;
    let mut parameter = |names: &mut Names, wish: &str| {
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
        // the field of a pose bears the output's own name
        names.reserve(&output.name.to_string());
    }
    for own in &model.parameters {
        for part in own.dimension.shape().part_names(&own.name.to_string(), "_") {
            parameter(&mut names, &part);
        }
    }
    for output in &model.outputs {
        let name = output.name.to_string();
        let parts = match output.value.shape() {
            Shape::Scalar => vec![format!("{name}_value")],
            shape => shape.part_names(&name, "_"),
        };
        for part in parts {
            names.name(Symbol::OutputRate(output_part, 0), &part);
            output_part += 1;
        }
    }
    names
}
