//! The names of a declaration as trees.

use std::collections::BTreeMap;

use proc_macro2::Ident;

use super::tree::{Local, Tree, TreeKind};
use crate::model::Model;
use crate::syntax::Declaration;

/// What the names of a declaration stand for.
pub(super) struct Names {
    named: BTreeMap<String, Tree>,
    /// The values of the abbreviations, in their order.
    abbreviations: Vec<Tree>,
}

impl Names {
    pub(super) fn new(declaration: &Declaration, model: &Model) -> Self {
        let mut named = BTreeMap::new();
        let mut scalar = 0;
        for parameter in &model.parameters {
            let shape = parameter.dimension.shape();
            named.insert(
                parameter.name.to_string(),
                Tree::new(shape, TreeKind::Parameter(scalar)),
            );
            scalar += shape.axes().len().max(1);
        }
        for (index, input) in model.inputs.iter().enumerate() {
            named.insert(input.name.to_string(), Tree::scalar(TreeKind::Input(index)));
        }
        for (index, unknown) in model.unknowns.iter().enumerate() {
            named.insert(unknown.name.to_string(), Tree::scalar(TreeKind::Unknown(index)));
        }
        let abbreviations = Vec::new();
        let mut names = Self { named, abbreviations };
        for statement in &declaration.statements {
            if let Some((name, value)) = statement.abbreviation() {
                let value = names.formula(value);
                let local = Tree::local(value.shape, Local::Abbreviation(names.abbreviations.len()));
                names.named.insert(name.to_string(), local);
                names.abbreviations.push(value);
            }
        }
        names
    }

    /// What a name stands for.
    pub(super) fn named(&self, name: &Ident) -> Tree {
        let known = self.named.get(&name.to_string()).cloned();
        // the model has reported a name that does not exist
        known.unwrap_or_else(|| Tree::number(0.0))
    }

    /// The values of the abbreviations, in their order.
    pub(super) fn abbreviations(&self) -> &[Tree] {
        &self.abbreviations
    }
}
