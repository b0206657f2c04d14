//! The whole way from a declaration to a solver, on one page.

use std::collections::{BTreeMap, BTreeSet};
use std::panic::{AssertUnwindSafe, catch_unwind};

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use quote::quote;

use crate::assemble::{Limits, Names};
use crate::expr::{Graph, Node, Symbol};
use crate::model::{Dimension, Model, Request, Requested, Shape};
use crate::passes::Passes;
use crate::refuse::{Origin, refuse, refuse_constants, refuse_ranges, refuse_requests, refuse_size};
use crate::report::Report;
use crate::room::with_room;
use crate::structure::Block;
use crate::syntax::Declaration;
use crate::{emit, fallback, model, plan, structure, syntax};

/// The expansion, whatever happens: what panics becomes a mistake of ours, told where the declaration stands.
pub(crate) fn expand_or_tell(tokens: TokenStream) -> TokenStream {
    or_tell(tokens, expand)
}

/// Calls `expand`, and tells of its panic.
fn or_tell(tokens: TokenStream, expand: impl FnOnce(TokenStream) -> TokenStream) -> TokenStream {
    let copy = tokens.clone();
    // nothing that a panic may have left half done outlives it
    catch_unwind(AssertUnwindSafe(|| expand(copy))).unwrap_or_else(|panic| {
        let words = panic.downcast_ref::<&str>().copied();
        let words = words.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
        let bug = format!(
            "this is a bug in kin: please report it with this declaration{}",
            words.map(|words| format!(" ({words})")).unwrap_or_default()
        );
        let read = catch_unwind(AssertUnwindSafe(|| {
            let (runtime, tokens) = runtime(tokens);
            let mut report = Report::new();
            let declaration = syntax::parse(tokens, &mut report);
            match &declaration {
                Some(declaration) => report.error(&declaration.name, &bug),
                None => report.error_at(Span::call_site(), &bug),
            }
            fallback::tokens(declaration.as_ref(), report, &runtime)
        }));
        read.unwrap_or_else(|_| syn::Error::new(Span::call_site(), bug).to_compile_error())
    })
}

/// Expands `(path::to::kin) declaration`. Mistakes are told after the pass that finds them; after the last check nothing can fail.
pub(crate) fn expand(tokens: TokenStream) -> TokenStream {
    let (runtime, tokens) = runtime(tokens);
    let mut report = Report::new();

    let Some(declaration) = syntax::parse(tokens, &mut report) else {
        return fallback::tokens(None, report, &runtime);
    };
    let Some(solvable) = solvable(&declaration, &mut report) else {
        return fallback::tokens(Some(&declaration), report, &runtime);
    };
    let task = solvable.task(Passes::ALL);
    let plan = match with_room(|| plan::plan(&task)) {
        Ok(plan) => plan,
        Err(too_large) => {
            refuse_size(&declaration, too_large, &mut report);
            return fallback::tokens(Some(&declaration), report, &runtime);
        }
    };
    if let Some(misfit) = plan.graph.misfit() {
        refuse_constants(&declaration, &solvable.model, misfit, &mut report);
        return fallback::tokens(Some(&declaration), report, &runtime);
    }
    emit::tokens(&emit::Mechanism {
        declaration: &declaration,
        model: &solvable.model,
        graph: &plan.graph,
        blocks: &solvable.blocks,
        ranges: &solvable.ranges,
        plan: &plan,
        runtime: &runtime,
        goes_through_all: false,
    })
}

/// A declaration without mistakes, and how its equations can be solved.
pub(crate) struct Solvable {
    model: Model,
    graph: Graph,
    residuals: Vec<Node>,
    blocks: Vec<Block>,
    ranges: BTreeMap<usize, Limits>,
    directions: BTreeSet<usize>,
    outputs: Vec<Node>,
    names: Names,
}

/// What a declaration comes to, or nothing if there are mistakes in it.
fn solvable(declaration: &Declaration, report: &mut Report) -> Option<Solvable> {
    let model = model::build(declaration, report)?;
    let mut graph = model.graph.clone();
    let (residuals, origins) = scalar_equations(&model);
    let unknowns = model.unknowns.len();
    let blocks = with_room(|| structure::analyse(&mut graph, &residuals, unknowns));
    if let Some(misfit) = graph.misfit() {
        refuse_constants(declaration, &model, misfit, report);
        return None;
    }
    let blocks = match blocks {
        Ok(blocks) => blocks,
        Err(faults) => {
            refuse(&model, &origins, &faults, report);
            return None;
        }
    };
    refuse_ranges(&model, &blocks, report);
    refuse_requests(&model, &graph, &residuals, &blocks, report);
    if !report.is_empty() {
        return None;
    }
    Some(Solvable {
        ranges: ranges(&model),
        directions: directions(&model),
        outputs: model.outputs.iter().flat_map(|output| output.value.nodes()).collect(),
        names: names(&model),
        model,
        graph,
        residuals,
        blocks,
    })
}

impl Solvable {
    /// What is to be planned, and what is done to make it cheaper.
    pub(crate) fn task(&self, passes: Passes) -> plan::Task<'_> {
        plan::Task {
            graph: &self.graph,
            residuals: &self.residuals,
            blocks: &self.blocks,
            ranges: &self.ranges,
            directions: &self.directions,
            outputs: &self.outputs,
            inputs: self.model.inputs.len(),
            order: self.model.order,
            parameters: sensitive_parameters(&self.model),
            names: &self.names,
            passes,
            most_expressions: plan::MOST_EXPRESSIONS,
        }
    }
}

/// The same of a declaration that is known to have no mistakes.
#[cfg(test)]
pub(crate) fn sound(declaration: TokenStream) -> Solvable {
    let mut report = Report::new();
    let solvable = syntax::parse(declaration, &mut report).and_then(|declaration| solvable(&declaration, &mut report));
    assert!(report.is_empty(), "the declaration has mistakes");
    solvable.expect("there are no mistakes")
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
fn scalar_equations(model: &Model) -> (Vec<Node>, Vec<Origin>) {
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

/// The unknowns that are found as unit vectors.
fn directions(model: &Model) -> BTreeSet<usize> {
    (0..model.unknowns.len())
        .filter(|&unknown| model.unknowns[unknown].dimension == Dimension::Direction)
        .collect()
}

/// The names that the declaration gives, beside those that generated code needs for itself.
fn names(model: &Model) -> Names {
    let mut names = Names::default();
    for own in emit::OWN_NAMES {
        names.reserve(own);
        names.reserve(&emit::own_name(model, own));
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

#[cfg(test)]
mod tests {
    use super::*;

    /// What panics is told as a mistake of ours, and the structure stays.
    #[test]
    fn a_panic_is_told_and_leaves_the_structure() {
        let declaration = quote! {
            ($crate)
            pub struct Lever { pub arm: Length }
            input theta: Angle;
            unknown height: Length;
            height == arm * sin(theta);
        };
        let at_once: fn(TokenStream) -> TokenStream = |_| panic!("at {} steps", 3);
        let elsewhere: fn(TokenStream) -> TokenStream = |tokens| {
            with_room::<()>(|| panic!("at {} steps", 3));
            tokens
        };
        for panic in [at_once, elsewhere] {
            let expansion = or_tell(declaration.clone(), panic).to_string();
            assert!(
                expansion.contains("this is a bug in kin: please report it with this declaration (at 3 steps)"),
                "{expansion}"
            );
            assert!(expansion.contains("pub struct Lever"), "{expansion}");
        }
        // mistakes that are there as well are told beside it, and so is what leaves no structure
        let expansion = or_tell(
            quote!(
                struct Lever {
                    arm: Lenght,
                }
            ),
            |_| panic!("here"),
        )
        .to_string();
        assert_eq!(expansion.matches("compile_error").count(), 2, "{expansion}");
        let expansion = or_tell(quote!(height == arm;), |_| std::panic::panic_any(3)).to_string();
        assert!(expansion.contains("with this declaration\""), "{expansion}");
    }

    #[test]
    fn without_a_panic_nothing_is_told() {
        let declaration = quote!(height == arm;);
        let mut expected = TokenStream::new();
        expected.extend(declaration.clone());
        assert_eq!(or_tell(declaration, |tokens| tokens).to_string(), expected.to_string());
    }
}
