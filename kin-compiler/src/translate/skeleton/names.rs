//! The meaning of names for the picture.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Ident;

use crate::model::{Dimension, Model, ValueShape};
use crate::syntax::{Declaration, TypedFormula};
use crate::translate::names::Names;
use crate::translate::tree::Tree;

/// The names of a declaration: which of them move, and what abbreviations stand for.
pub(super) struct SkeletonNames<'a> {
    names: &'a Names,
    abbreviations: BTreeMap<String, &'a TypedFormula>,
    /// Inputs and unknowns, and abbreviations that contain them.
    varying: BTreeSet<String>,
    /// The parameters that are lengths or vectors.
    lengths: BTreeSet<String>,
}

impl<'a> SkeletonNames<'a> {
    pub(super) fn new(declaration: &'a Declaration, model: &Model, names: &'a Names) -> Self {
        let mut abbreviations = BTreeMap::new();
        let mut varying: BTreeSet<String> = model.inputs.iter().map(|input| input.name.to_string()).collect();
        varying.extend(model.unknowns.iter().map(|unknown| unknown.name.to_string()));
        for statement in &declaration.statements {
            if let Some((name, value)) = statement.abbreviation() {
                if mentions(value, &varying) {
                    varying.insert(name.to_string());
                }
                abbreviations.insert(name.to_string(), value);
            }
        }
        let lengths = model.parameters.iter().filter(|parameter| {
            !matches!(
                parameter.dimension,
                Dimension::Angle | Dimension::Direction | Dimension::Scalar
            )
        });
        Self {
            names,
            abbreviations,
            varying,
            lengths: lengths.map(|parameter| parameter.name.to_string()).collect(),
        }
    }

    /// The formula of an abbreviation.
    pub(super) fn behind(&self, name: &Ident) -> Option<&'a TypedFormula> {
        self.abbreviations.get(&name.to_string()).copied()
    }

    /// The formula of an abbreviation of a vector.
    pub(super) fn vector_behind(&self, name: &Ident) -> Option<&'a TypedFormula> {
        let is_vector = self.names.named(name).shape != ValueShape::Scalar;
        is_vector.then(|| self.behind(name)).flatten()
    }

    /// Whether a formula contains an input or an unknown.
    pub(super) fn varies(&self, formula: &TypedFormula) -> bool {
        mentions(formula, &self.varying)
    }

    /// A formula as a tree.
    pub(super) fn tree(&self, formula: &TypedFormula) -> Tree {
        self.names.formula(formula)
    }

    pub(super) fn shape(&self, formula: &TypedFormula) -> ValueShape {
        self.tree(formula).shape
    }

    /// The first length or vector among the parameters in a formula.
    pub(super) fn length(&self, formula: &TypedFormula) -> Option<String> {
        first(formula, &self.lengths)
    }

    /// The first input or unknown in a formula.
    pub(super) fn motion(&self, formula: &TypedFormula) -> Option<String> {
        first(formula, &self.varying)
    }
}

/// The first of some names in a formula.
fn first(formula: &TypedFormula, among: &BTreeSet<String>) -> Option<String> {
    let mut found = None;
    formula.visit_names(&mut |name| {
        let word = name.to_string();
        if found.is_none() && among.contains(&word) {
            found = Some(word);
        }
    });
    found
}

fn mentions(formula: &TypedFormula, names: &BTreeSet<String>) -> bool {
    let mut found = false;
    formula.visit_names(&mut |name| found |= names.contains(&name.to_string()));
    found
}
