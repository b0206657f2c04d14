//! The highest time derivative for which the mechanism is solved.

use crate::mistakes::Mistakes;
use crate::syntax::{Declaration, Statement};

/// The default order: snap.
const USUAL: usize = 4;

/// The declared order. A second declaration of it is a mistake.
pub(super) fn order(declaration: &Declaration, mistakes: &mut Mistakes) -> usize {
    let mut declared = None;
    for statement in &declaration.statements {
        let Statement::Order(statement) = statement else {
            continue;
        };
        match declared {
            None => declared = Some(statement.order),
            Some(first) if first == statement.order => {
                mistakes.error(statement.extent, "the order is already given: remove this statement");
            }
            Some(first) => mistakes.error(
                statement.extent,
                format!("the order is already given as {first}: remove one of the two statements"),
            ),
        }
    }
    declared.unwrap_or(USUAL)
}
