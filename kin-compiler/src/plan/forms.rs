//! The forms in which equations and outputs are differentiated.

use super::Task;
use crate::algebra::Graph;
use crate::derive::{self, Derivatives, Differentiable, Influences, TooLarge};
use crate::passes::Pass;

/// Equations and outputs in one form, and the graph of that form.
#[derive(Clone)]
pub(super) struct EquationForm {
    pub(super) graph: Graph,
    pub(super) formulas: Differentiable,
    pub(super) is_multiplied_out: bool,
}

impl EquationForm {
    /// The equations in this form, to be differentiated.
    pub(super) fn task<'a>(&'a self, task: &Task<'a>, influences: Influences) -> derive::Subject<'a> {
        derive::Subject {
            residuals: &self.formulas.residuals,
            blocks: task.blocks,
            outputs: &self.formulas.outputs,
            influences,
            passes: task.passes,
            most_expressions: task.most_expressions,
        }
    }
}

/// The multiplied-out form of the equations, and the form with their products left if it differs.
pub(super) fn forms(task: &Task<'_>) -> Vec<EquationForm> {
    let mut graph = task.graph.clone();
    let mut form = |is_multiplied_out| {
        let formulas = derive::formulas(
            &mut graph,
            task.residuals,
            task.blocks,
            &task.outputs,
            is_multiplied_out,
        );
        EquationForm {
            graph: graph.clone(),
            formulas,
            is_multiplied_out,
        }
    };
    let (multiplied_out, products_left) = (form(true), form(false));
    let nodes = |form: &EquationForm| [form.formulas.residuals.clone(), form.formulas.outputs.clone()];
    if nodes(&multiplied_out) == nodes(&products_left) || !task.passes.include(Pass::ProductsLeft) {
        return vec![multiplied_out];
    }
    if !task.passes.include(Pass::MultipliedOut) {
        return vec![products_left];
    }
    vec![multiplied_out, products_left]
}

/// Equations and outputs in one form, with their derivatives.
pub(super) struct Derived {
    pub(super) form: EquationForm,
    pub(super) influences: Influences,
    pub(super) graph: Graph,
    pub(super) derivatives: Derivatives,
}

impl Derived {
    pub(super) fn new(task: &Task<'_>, form: EquationForm, influences: Influences) -> Result<Self, TooLarge> {
        let mut graph = form.graph.clone();
        if !task.passes.include(Pass::ConstantFolding) {
            graph.keep_numbers();
        }
        let derivatives = Derivatives::new(&mut graph, form.task(task, influences), task.order)?;
        Ok(Self {
            form,
            influences,
            graph,
            derivatives,
        })
    }
}
