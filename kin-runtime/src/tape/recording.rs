//! What a number writes to the recorder of its thread.
//!
//! These functions know nothing of the number type, so that they are compiled once: a recorded solver has thousands of
//! calls of them.

use std::vec::Vec;

use super::recorder::{Event, Sought, with};
use super::{Condition, Function, Operator, TapeNode, Value};
use crate::assembly::Assembly;

/// Writes a node.
#[inline(never)]
pub(super) fn node(node: TapeNode) -> Value {
    with(|recorder| recorder.put(node))
}

#[inline(never)]
pub(super) fn call(function: Function, argument: Value) -> Value {
    node(TapeNode::Call(function, argument))
}

#[inline(never)]
pub(super) fn binary(operator: Operator, one: Value, other: Value) -> Value {
    node(TapeNode::Binary(operator, one, other))
}

#[inline(never)]
pub(super) fn constant(value: f64) -> Value {
    with(|recorder| recorder.constant(value))
}

/// The value of a node, where the solver asks for it.
#[inline(never)]
pub(super) fn read(node: Value) -> f64 {
    with(|recorder| recorder.read(node))
}

/// The number of nodes.
#[inline(never)]
pub(super) fn count() -> usize {
    with(|recorder| recorder.nodes.len())
}

/// Whether a check holds, whose nodes begin at one of them.
#[inline(never)]
pub(super) fn holds(name: &'static str, condition: Value, margin: Value, before: usize) -> bool {
    with(|recorder| recorder.check(name, Condition::Holds(condition), Some(margin), before))
}

#[inline(never)]
pub(super) fn is_open(assembly: Assembly) -> Result<(Value, bool), Assembly> {
    with(|recorder| recorder.is_open(assembly))
}

#[inline(never)]
pub(super) fn side(is_open: Value) -> Assembly {
    with(|recorder| recorder.side(is_open))
}

#[inline(never)]
pub(super) fn are_finite(numbers: &[Value]) -> bool {
    with(|recorder| {
        if recorder.fails.is_some() && !recorder.failed.is_empty() {
            // The solver looks for the number that made the check fail.
            return !numbers.iter().any(|number| recorder.failed.contains(number));
        }
        let mut all = recorder.put(TapeNode::Certain(true));
        for number in numbers {
            let finite = recorder.put(TapeNode::IsFinite(*number));
            all = recorder.put(TapeNode::Both(all, finite));
        }
        let before = recorder.nodes.len();
        // The margin of a number that is not finite is not finite: the sum of all, times zero, and infinity.
        let zero = recorder.constant(0.0);
        let mut sum = zero;
        for number in numbers {
            let nothing = recorder.put(TapeNode::Binary(Operator::Multiply, *number, zero));
            sum = recorder.put(TapeNode::Binary(Operator::Add, sum, nothing));
        }
        let infinite = recorder.constant(f64::INFINITY);
        let margin = recorder.put(TapeNode::Binary(Operator::Add, infinite, sum));
        let holds = recorder.check("finite numbers", Condition::Holds(all), Some(margin), before);
        if !holds {
            recorder.failed = numbers.to_vec();
        }
        holds
    })
}

/// The search for a root. The same search may have been recorded before: then its equations are the same nodes of its
/// unknowns.
pub(super) fn searched(sought_with: &mut dyn FnMut(usize) -> Sought) -> usize {
    let count = with(|recorder| recorder.searches.len());
    let is_known = |search: &usize| {
        let sought = sought_with(*search);
        with(|recorder| recorder.searches[*search] == sought)
    };
    let known = (0..count).find(is_known);
    known.unwrap_or_else(|| {
        let sought = sought_with(count);
        with(|recorder| {
            recorder.searches.push(sought);
            recorder.events.push((recorder.nodes.len(), Event::Search(count)));
        });
        count
    })
}

/// Whether a search finds a root.
pub(super) fn is_found(search: usize) -> bool {
    with(|recorder| {
        let before = recorder.nodes.len();
        recorder.check("root of coupled equations", Condition::Found(search), None, before)
    })
}

/// The system of a matrix, and whether it is regular.
pub(super) fn factored(rows: Vec<Vec<Value>>) -> (usize, bool) {
    with(|recorder| {
        let before = recorder.nodes.len();
        let known = recorder.systems.iter().position(|system| *system == rows);
        let system = known.unwrap_or_else(|| {
            recorder.systems.push(rows);
            recorder
                .events
                .push((before, Event::Factor(recorder.systems.len() - 1)));
            recorder.systems.len() - 1
        });
        let holds = recorder.check("regular matrix", Condition::Regular(system), None, before);
        (system, holds)
    })
}

/// The solution of a system for a right-hand side.
pub(super) fn solved(system: usize, right: Vec<Value>) -> usize {
    with(|recorder| {
        let wanted = (system, right);
        let known = recorder.solutions.iter().position(|solution| *solution == wanted);
        known.unwrap_or_else(|| {
            let solution = recorder.solutions.len();
            recorder.solutions.push(wanted);
            recorder.events.push((recorder.nodes.len(), Event::Solve(solution)));
            solution
        })
    })
}
