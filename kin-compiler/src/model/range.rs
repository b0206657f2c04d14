//! The ranges that pick the branch of an unknown.

use proc_macro2::Ident;

use crate::algebra::Graph;
use crate::mistakes::Mistakes;
use crate::model::angles::is_range_in_radians;
use crate::model::lower::Lowering;
use crate::model::scope::Scope;
use crate::model::{Dimension, Range};
use crate::syntax::{Declaration, RangeClause, RangeKind, Relation, TypedFormula};

/// The ends of a range, `None` after a mistake.
pub(super) fn range(
    clause: &RangeClause,
    unknown: &Ident,
    dimension: Dimension,
    declaration: &Declaration,
    scope: &mut Scope<'_>,
    mistakes: &mut Mistakes,
) -> Option<Range> {
    let (low, high) = match &clause.kind {
        RangeKind::Comparison {
            name,
            comparison,
            bound,
        } => {
            bound.visit_names(&mut |name| scope.mean(&name.to_string()));
            if name != unknown {
                scope.mean(&name.to_string());
                mistakes.error(
                    name,
                    format!("the range of `{unknown}` can only compare `{unknown}`: write `where {unknown} > …`"),
                );
                return None;
            }
            let bound = constant(bound, declaration, scope, mistakes)?;
            match comparison {
                Relation::Less | Relation::LessOrEqual => (f64::NEG_INFINITY, bound),
                Relation::Greater | Relation::GreaterOrEqual => (bound, f64::INFINITY),
            }
        }
        RangeKind::Between { low, high, .. } => {
            let low = constant(low, declaration, scope, mistakes);
            let high = constant(high, declaration, scope, mistakes);
            (low?, high?)
        }
    };
    if low >= high {
        mistakes.error(clause.extent, "this range is empty: write its smaller end first");
        return None;
    }
    let range = Range {
        low,
        high,
        text: clause.text(&unknown.to_string()),
    };
    (dimension != Dimension::Angle || is_range_in_radians(clause, &range, mistakes)).then_some(range)
}

/// The end of a range, which consists of literals and PI.
fn constant(
    bound: &TypedFormula,
    declaration: &Declaration,
    scope: &mut Scope<'_>,
    mistakes: &mut Mistakes,
) -> Option<f64> {
    bound.visit_names(&mut |name| scope.mean(&name.to_string()));
    if let Some(name) = first_name(bound) {
        mistakes.error(
            name,
            format!("the end of a range contains only numbers and `PI`, not `{name}`: write its value"),
        );
        return None;
    }
    let mut graph = Graph::new();
    let mut lowering = Lowering {
        graph: &mut graph,
        scope: &mut Scope::new(declaration),
        mistakes,
        extreme: &mut None,
    };
    let typed = lowering.formula(bound)?;
    let Some(node) = typed.value.as_scalar() else {
        mistakes.error(
            bound.extent,
            format!("the end of a range is a number, but this is {}", typed.measure()),
        );
        return None;
    };
    graph.constant_value(node)
}

fn first_name(formula: &TypedFormula) -> Option<&Ident> {
    let mut first = None;
    formula.visit_names(&mut |name| first = first.or(Some(name)));
    first
}
