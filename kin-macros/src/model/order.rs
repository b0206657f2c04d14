//! Through which time derivative the mechanism is solved.

use crate::mistakes::Mistakes;
use crate::syntax::{Declaration, Statement};

/// Where nothing is said: through snap.
const USUAL: usize = 4;

/// The order that is declared; it can be said once.
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
