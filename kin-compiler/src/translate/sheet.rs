//! Methods from their local values and results.

use std::collections::BTreeSet;

use super::names::Names;
use super::tree::{Binding, Local, Sheet, Tree, TreeKind};
use crate::model::ValueShape;

impl Names {
    /// A method, with the abbreviations that it uses in front.
    pub(super) fn sheet(&self, locals: Vec<Binding>, results: Vec<Tree>) -> Sheet {
        let mut sheet = Sheet {
            bindings: locals,
            results,
        };
        let mut used = BTreeSet::new();
        sheet.visit(&mut |tree| used.extend(abbreviation(tree)));
        // an abbreviation comes after those that it uses
        for (index, value) in self.abbreviations().iter().enumerate().rev() {
            if used.contains(&index) {
                value.visit(&mut |tree| used.extend(abbreviation(tree)));
            }
        }
        let abbreviations = self.abbreviations().iter().enumerate();
        let used = abbreviations.filter(|(index, _)| used.contains(index));
        let bindings = used.map(|(index, value)| Binding {
            local: Local::Abbreviation(index),
            value: value.clone(),
        });
        sheet.bindings.splice(0..0, bindings);
        sheet
    }

    /// A method whose results are values as scalars. A vector is a local value first.
    pub(super) fn sheet_of_parts(&self, values: impl Iterator<Item = Tree>, local: fn(usize) -> Local) -> Sheet {
        let (mut locals, mut results) = (Vec::new(), Vec::new());
        for (number, value) in values.enumerate() {
            if value.shape == ValueShape::Scalar {
                results.push(value);
            } else {
                let local = local(number);
                results.extend(Tree::local(value.shape, local).parts());
                locals.push(Binding { local, value });
            }
        }
        self.sheet(locals, results)
    }
}

fn abbreviation(tree: &Tree) -> Option<usize> {
    match tree.kind {
        TreeKind::Local(Local::Abbreviation(index)) => Some(index),
        _ => None,
    }
}
