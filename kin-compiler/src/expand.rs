//! The whole expansion of a declaration, on one page.

use proc_macro2::TokenStream;
use quote::quote;

use crate::formulas::formulas;
use crate::mistakes::Mistakes;
use crate::model::Model;
use crate::passes::Passes;
use crate::plan::{Task, plan};
use crate::program::Solvers;
use crate::room::with_room;
use crate::structure::{CoefficientMagnitudes, Structure};
use crate::syntax::Declaration;
use crate::work;
use crate::{editor, emit, fallback, model, refuse, structure, syntax};

/// Expands `(path::to::kin) declaration`. Each pass reports the mistakes that it finds. After the last check no pass
/// can fail.
pub(crate) fn expand(tokens: TokenStream) -> TokenStream {
    let (runtime, tokens) = syntax::runtime(tokens);
    let mut mistakes = Mistakes::new();
    let (declaration, solved) = solved(tokens, &mut mistakes);
    let Some(declaration) = declaration else {
        return fallback::tokens(None, mistakes, &runtime);
    };
    let editor = editor::tokens(&declaration, &runtime);
    let Some((model, structure, solvers)) = solved else {
        let fallback = fallback::tokens(Some(&declaration), mistakes, &runtime);
        return quote!(#editor #fallback);
    };
    #[cfg(test)]
    crate::testing::definitions::assert_defined(&solvers);
    let Structure {
        graph,
        residuals,
        blocks,
    } = structure;
    let formulas = formulas(&declaration, &model, graph, &residuals, &blocks);
    let mechanism = emit::tokens(&declaration, &model, &blocks, &solvers, &formulas, &runtime);
    quote!(#editor #mechanism)
}

/// A declaration with what its solvers are made of, and these.
type Solved = (Model, Structure, Solvers);

/// The passes before text: the declaration, if its structure can be read, and its solvers, if it has no mistakes.
pub(crate) fn solved(tokens: TokenStream, mistakes: &mut Mistakes) -> (Option<Declaration>, Option<Solved>) {
    let declaration = syntax::parse(tokens, mistakes);
    let readable = declaration.as_ref().filter(|declaration| !declaration.holds_prose);
    let solved = readable.and_then(|declaration| solvers(declaration, mistakes));
    (declaration, solved)
}

/// The passes between syntax and text; `None` if the declaration has mistakes, or its budget is spent.
fn solvers(declaration: &Declaration, mistakes: &mut Mistakes) -> Option<Solved> {
    let model = model::build(declaration, mistakes).filter(|_| !work::is_spent())?;
    let structure = structure(declaration, &model, mistakes).filter(|_| !work::is_spent())?;
    let task = Task::new(&model, &structure, Passes::ALL);
    match with_room(|| plan(&task)) {
        Err(too_large) => refuse::size(declaration, too_large.order, mistakes),
        Ok(solvers) => match solvers.graph.misfit() {
            Some(misfit) => refuse::constants(declaration, &model, misfit, mistakes),
            None => return Some((model, structure, solvers)),
        },
    }
    None
}

/// The blocks of the equations, if they can be solved and every requested item exists, and the budget is not spent.
pub(crate) fn structure(declaration: &Declaration, model: &Model, mistakes: &mut Mistakes) -> Option<Structure> {
    let (residuals, origins) = model.scalar_equations();
    let (graph, unknowns) = (model.graph.clone(), model.unknowns.len());
    let (lengths, numbers) = model.lengths_and_numbers();
    let magnitudes = CoefficientMagnitudes { lengths, numbers };
    let analysed = with_room(|| structure::analyse(graph, &residuals, unknowns, &magnitudes));
    let structure = match analysed {
        _ if work::is_spent() => return None,
        Err(structure::Refusal::Constants(misfit)) => {
            refuse::constants(declaration, model, misfit, mistakes);
            return None;
        }
        Err(structure::Refusal::Faults(faults)) => {
            refuse::faults(model, &origins, &faults, mistakes);
            return None;
        }
        Ok(structure) => structure,
    };
    refuse::ranges(model, &structure.blocks, mistakes);
    refuse::requests(model, &structure, mistakes);
    mistakes.is_empty().then_some(structure)
}
