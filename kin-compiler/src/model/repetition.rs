//! Whether the elements of a list are of one kind, so that all copies of a `for` are right or wrong alike.

use std::collections::BTreeSet;

use super::dimension::{FormulaType, common};
use super::lower::Lowering;
use crate::syntax::TypedFormula;

impl Lowering<'_, '_> {
    /// Whether all that a name of a `for` stands for is of one kind. Elements with a mistake are reported. What only
    /// the picture uses has no value here.
    pub(super) fn are_alike(&mut self, elements: &[TypedFormula], drawn: &BTreeSet<String>) -> bool {
        let is_drawn = |element: &TypedFormula| {
            let mut found = false;
            element.visit_names(&mut |name| found |= drawn.contains(&name.to_string()));
            found
        };
        if elements.iter().any(is_drawn) {
            return true;
        }
        let mut first: Option<(&TypedFormula, FormulaType)> = None;
        let mut alike = true;
        for element in elements {
            let Some(measure) = self.formula(element).map(|typed| typed.measure()) else {
                alike = false;
                continue;
            };
            if measure.is_zero() {
                continue;
            }
            let (before, wanted) = *first.get_or_insert((element, measure));
            if wanted.shape != measure.shape || common(wanted, measure).is_none() {
                self.mistakes.error(
                    element.extent,
                    format!(
                        "this is {measure}, but `{before}` before it is {wanted}: a name of a `for` stands for \
                        values of one kind"
                    ),
                );
                alike = false;
            }
        }
        alike
    }
}
