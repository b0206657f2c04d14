//! The whole way from a declaration to its solvers, on one page.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::quote;

use crate::model::Model;
use crate::passes::Passes;
use crate::plan::{Task, plan};
use crate::program::Solvers;
use crate::report::Report;
use crate::room::with_room;
use crate::structure::Structure;
use crate::syntax::Declaration;
use crate::{emit, fallback, model, refuse, structure, syntax};

/// Expands `(path::to::kin) declaration`. Each pass tells the mistakes that it finds; after the last check nothing can fail.
pub(crate) fn expand(tokens: TokenStream) -> TokenStream {
    let (runtime, tokens) = runtime(tokens);
    let mut report = Report::new();
    let Some(declaration) = syntax::parse(tokens, &mut report) else {
        return fallback::tokens(None, report, &runtime);
    };
    let Some((model, structure, solvers)) = solvers(&declaration, &mut report) else {
        return fallback::tokens(Some(&declaration), report, &runtime);
    };
    #[cfg(test)]
    crate::definition_tests::assert_defined(&solvers);
    emit::tokens(&declaration, &model, &structure.blocks, &solvers, &runtime)
}

/// The passes between syntax and text; nothing if there are mistakes in the declaration.
fn solvers(declaration: &Declaration, report: &mut Report) -> Option<(Model, Structure, Solvers)> {
    let model = model::build(declaration, report)?;
    let structure = structure(declaration, &model, report)?;
    let task = Task::new(&model, &structure, Passes::ALL);
    match with_room(|| plan(&task)) {
        Err(too_large) => refuse::size(declaration, too_large.order, report),
        Ok(solvers) => match solvers.graph.misfit() {
            Some(misfit) => refuse::constants(declaration, &model, misfit, report),
            None => return Some((model, structure, solvers)),
        },
    }
    None
}

/// The blocks of the equations, if they can be solved and everything that is requested exists.
pub(crate) fn structure(declaration: &Declaration, model: &Model, report: &mut Report) -> Option<Structure> {
    let (residuals, origins) = model.scalar_equations();
    let (graph, unknowns) = (model.graph.clone(), model.unknowns.len());
    let analysed = with_room(|| structure::analyse(graph, &residuals, unknowns));
    let structure = match analysed {
        Err(structure::Refusal::Constants(misfit)) => {
            refuse::constants(declaration, model, misfit, report);
            return None;
        }
        Err(structure::Refusal::Faults(faults)) => {
            refuse::faults(model, &origins, &faults, report);
            return None;
        }
        Ok(structure) => structure,
    };
    refuse::ranges(model, &structure.blocks, report);
    refuse::requests(model, &structure, report);
    report.is_empty().then_some(structure)
}

/// The path to the items that generated code calls, and the declaration behind it. `mechanism!` passes its own crate, under the
/// name by which the user knows it.
pub(crate) fn runtime(tokens: TokenStream) -> (TokenStream, TokenStream) {
    let mut tokens = tokens.into_iter().peekable();
    let is_path =
        |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis);
    let runtime = if let Some(TokenTree::Group(path)) = tokens.next_if(is_path) {
        let path = path.stream();
        quote!(#path::__private)
    } else {
        quote!(::kin_core::__private)
    };
    (runtime, tokens.collect())
}
