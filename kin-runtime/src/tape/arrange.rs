//! From a record to a tape: what nobody needs goes, and what is left is put in order.

use std::vec;
use std::vec::Vec;

use crate::quantity::Name;
use crate::tape::recorder::{Event, Noted, Recorder};
use crate::tape::structure::Tape;
use crate::tape::{
    Argument, Condition, LinearSolution, NewtonSearch, Role, System, TapeCheck, TapeNode, TapeStep, Value,
};

/// Which nodes are needed, and where.
struct Needs<'a> {
    recorder: &'a Recorder,
    /// Whether a step needs the node.
    is_needed: Vec<bool>,
    searches: Vec<bool>,
    systems: Vec<bool>,
    solutions: Vec<bool>,
}

impl<'a> Needs<'a> {
    fn new(recorder: &'a Recorder) -> Self {
        Self {
            recorder,
            is_needed: vec![false; recorder.nodes.len()],
            searches: vec![false; recorder.searches.len()],
            systems: vec![false; recorder.systems.len()],
            solutions: vec![false; recorder.solutions.len()],
        }
    }

    fn add(&mut self, value: Value) {
        let mut pending = vec![value];
        while let Some(value) = pending.pop() {
            if core::mem::replace(&mut self.is_needed[value.index()], true) {
                continue;
            }
            let node = self.recorder.nodes[value.index()];
            node.operands(|operand| pending.push(operand));
            match node {
                TapeNode::Root { search, .. } => self.search(search, &mut pending),
                TapeNode::Solution { solution, .. } if !self.solutions[solution] => {
                    self.solutions[solution] = true;
                    let (system, right) = &self.recorder.solutions[solution];
                    pending.extend(right);
                    self.system(*system, &mut pending);
                }
                _ => {}
            }
        }
    }

    fn condition(&mut self, condition: Condition) {
        let mut pending = Vec::new();
        match condition {
            Condition::Holds(truth) => pending.push(truth),
            Condition::Found(search) => self.search(search, &mut pending),
            Condition::Regular(system) => self.system(system, &mut pending),
        }
        for value in pending {
            self.add(value);
        }
    }

    fn search(&mut self, search: usize, pending: &mut Vec<Value>) {
        if !core::mem::replace(&mut self.searches[search], true) {
            let sought = &self.recorder.searches[search];
            pending.extend(sought.guess.iter().chain(&sought.sizes).chain(&sought.residuals));
            pending.extend(sought.jacobian.iter().flatten());
        }
    }

    fn system(&mut self, system: usize, pending: &mut Vec<Value>) {
        if !core::mem::replace(&mut self.systems[system], true) {
            pending.extend(self.recorder.systems[system].iter().flatten());
        }
    }
}

/// The highest order of an input on which each node depends, and the search on whose unknowns it depends.
fn dependences(recorder: &Recorder, arguments: &[Argument<'_>]) -> (Vec<usize>, Vec<Option<usize>>) {
    let (mut orders, mut searches) = (Vec::new(), Vec::new());
    for node in &recorder.nodes {
        let (mut order, mut search) = (0, None);
        let mut join = |value: Value| {
            order = order.max(orders[value.index()]);
            search = search.or(searches[value.index()]);
        };
        node.operands(&mut join);
        match *node {
            TapeNode::Argument(argument) => {
                if let Role::Input { order: input_order, .. } = arguments[argument].role {
                    order = input_order;
                }
            }
            TapeNode::Unknown { search: found, .. } => search = Some(found),
            TapeNode::Solution { solution, .. } => {
                let (_, right) = &recorder.solutions[solution];
                right.iter().copied().for_each(join);
            }
            _ => {}
        }
        orders.push(order);
        searches.push(search);
    }
    (orders, searches)
}

/// Whether a node is computed by a separate step.
fn is_step(node: TapeNode) -> bool {
    !matches!(
        node,
        TapeNode::Argument(_)
            | TapeNode::Constant(_)
            | TapeNode::Certain(_)
            | TapeNode::Unknown { .. }
            | TapeNode::Root { .. }
            | TapeNode::Solution { .. }
    )
}

/// Fills the tape from the record. `block` is the block of a check.
pub(super) fn arrange(recorder: &Recorder, tape: &mut Tape<'_>, block: impl Fn(&Noted) -> Name) {
    let (orders, searches) = dependences(recorder, &tape.arguments);
    let order_of = |check: &Noted| match check.condition {
        _ if check.is_of_position => 0,
        Condition::Holds(truth) => orders[truth.index()].max(1),
        Condition::Found(_) | Condition::Regular(_) => 1,
    };
    let mut needs = Needs::new(recorder);
    for result in &tape.results {
        needs.add(result.value);
    }
    let is_wanted = |check: &Noted| order_of(check) <= tape.order;
    for check in recorder.checks.iter().filter(|check| is_wanted(check)) {
        needs.condition(check.condition);
    }
    // The margins come last: they are computed where a check has failed.
    let is_step_of_its_own = needs.is_needed.clone();
    let mut cold: Vec<Vec<Value>> = vec![Vec::new(); recorder.checks.len()];
    for (check, steps) in recorder.checks.iter().zip(&mut cold) {
        let Some(margin) = check.margin.filter(|_| is_wanted(check)) else {
            continue;
        };
        let is_there = |value: Value| is_step_of_its_own[value.index()] && value.index() < check.before;
        let mut pending = vec![margin];
        while let Some(value) = pending.pop() {
            let node = recorder.nodes[value.index()];
            if is_there(value) || steps.contains(&value) {
                continue;
            }
            if is_step(node) {
                steps.push(value);
            }
            node.operands(|operand| pending.push(operand));
        }
        steps.sort_unstable();
        needs.add(margin);
    }

    let moved = numbers(&needs.is_needed);
    let (new_searches, new_systems) = (numbers(&needs.searches), numbers(&needs.systems));
    let new_solutions = numbers(&needs.solutions);
    let value = |old: Value| Value(u32::try_from(moved[old.index()]).unwrap_or(u32::MAX));
    let all = |old: &[Value]| -> Vec<Value> { old.iter().map(|moved_value| value(*moved_value)).collect() };
    let rows = |old: &[Vec<Value>]| -> Vec<Vec<Value>> { old.iter().map(|row| all(row)).collect() };
    let is_kept = |(index, _): &(usize, &TapeNode)| needs.is_needed[*index];
    let nodes = recorder.nodes.iter().enumerate().filter(is_kept);
    tape.nodes = nodes
        .map(|(_, node)| match node.with_operands(value) {
            TapeNode::Unknown { search, index } => TapeNode::Unknown {
                search: new_searches[search],
                index,
            },
            TapeNode::Root { search, index } => TapeNode::Root {
                search: new_searches[search],
                index,
            },
            TapeNode::Solution { solution, index } => TapeNode::Solution {
                solution: new_solutions[solution],
                index,
            },
            node => node,
        })
        .collect();
    for result in &mut tape.results {
        result.value = value(result.value);
    }
    let wanted: Vec<bool> = recorder.checks.iter().map(is_wanted).collect();
    let new_checks = numbers(&wanted);
    for (check, steps) in recorder.checks.iter().zip(&cold) {
        if is_wanted(check) {
            tape.checks.push(TapeCheck {
                name: check.name,
                block: block(check),
                order: order_of(check),
                condition: match check.condition {
                    Condition::Holds(truth) => Condition::Holds(value(truth)),
                    Condition::Found(search) => Condition::Found(new_searches[search]),
                    Condition::Regular(system) => Condition::Regular(new_systems[system]),
                },
                cold: all(steps),
                margin: check.margin.map(value),
            });
        }
    }
    for (index, sought) in recorder
        .searches
        .iter()
        .enumerate()
        .filter(|(index, _)| needs.searches[*index])
    {
        let body = (0..recorder.nodes.len()).filter(|node| {
            searches[*node] == Some(index) && is_step_of_its_own[*node] && is_step(recorder.nodes[*node])
        });
        tape.searches.push(NewtonSearch {
            guess: all(&sought.guess),
            sizes: all(&sought.sizes),
            body: body
                .map(|node| Value(u32::try_from(moved[node]).unwrap_or(u32::MAX)))
                .collect(),
            residuals: all(&sought.residuals),
            jacobian: rows(&sought.jacobian),
        });
    }
    for (_, system) in recorder
        .systems
        .iter()
        .enumerate()
        .filter(|(index, _)| needs.systems[*index])
    {
        tape.systems.push(System { rows: rows(system) });
    }
    let solutions = recorder.solutions.iter().enumerate();
    for (_, (system, right)) in solutions.filter(|(index, _)| needs.solutions[*index]) {
        tape.solutions.push(LinearSolution {
            system: new_systems[*system],
            right: all(right),
        });
    }

    let mut events = recorder.events.iter().peekable();
    for index in 0..=recorder.nodes.len() {
        while let Some((_, event)) = events.next_if(|(before, _)| *before <= index) {
            match *event {
                Event::Check(check) if wanted[check] => tape.steps.push(TapeStep::Check(new_checks[check])),
                Event::Search(search) if needs.searches[search] => {
                    tape.steps.push(TapeStep::Search(new_searches[search]));
                }
                Event::Factor(system) if needs.systems[system] => {
                    tape.steps.push(TapeStep::Factor(new_systems[system]));
                }
                Event::Solve(solution) if needs.solutions[solution] => {
                    tape.steps.push(TapeStep::Solve(new_solutions[solution]));
                }
                _ => {}
            }
        }
        let is_computed = |node: &TapeNode| is_step(*node) && is_step_of_its_own[index] && searches[index].is_none();
        if recorder.nodes.get(index).is_some_and(is_computed) {
            tape.steps.push(TapeStep::Compute(Value(
                u32::try_from(moved[index]).unwrap_or(u32::MAX),
            )));
        }
    }
}

/// The new number of each kept node.
fn numbers(kept: &[bool]) -> Vec<usize> {
    let mut next = 0;
    let number = |is_kept: &bool| {
        let number_of_node = next;
        next += usize::from(*is_kept);
        number_of_node
    };
    kept.iter().map(number).collect()
}
