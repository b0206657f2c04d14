//! The lowest order that needs each step of a tape, for printers that write a function for each order.

use std::vec;
use std::vec::Vec;

use crate::tape::structure::Tape;
use crate::tape::{Condition, TapeNode, TapeStep, Value};

/// The lowest order that needs each node, search, system and solution; `usize::MAX` for a node that only a margin
/// needs.
pub(super) struct Stages {
    nodes: Vec<usize>,
    searches: Vec<usize>,
    systems: Vec<usize>,
    solutions: Vec<usize>,
    /// Whether all orders are one.
    is_one: bool,
}

impl Stages {
    /// All orders as one, for a function that finds all of them.
    pub(super) fn one(tape: &Tape<'_>) -> Self {
        Self {
            nodes: vec![0; tape.nodes.len()],
            searches: vec![0; tape.searches.len()],
            systems: vec![0; tape.systems.len()],
            solutions: vec![0; tape.solutions.len()],
            is_one: true,
        }
    }

    /// The stage of an order.
    pub(super) fn of_order(&self, order: usize) -> usize {
        if self.is_one { 0 } else { order }
    }

    pub(super) fn new(tape: &Tape<'_>) -> Self {
        let never = usize::MAX;
        let mut stages = Self {
            nodes: vec![never; tape.nodes.len()],
            searches: vec![never; tape.searches.len()],
            systems: vec![never; tape.systems.len()],
            solutions: vec![never; tape.solutions.len()],
            is_one: false,
        };
        for result in &tape.results {
            stages.need(result.value, result.order);
        }
        for check in &tape.checks {
            match check.condition {
                Condition::Holds(truth) => stages.need(truth, check.order),
                Condition::Found(search) => stages.search(tape, search, check.order),
                Condition::Regular(system) => stages.system(tape, system, check.order),
            }
            // A margin takes what is there already.
            let mut taken = Vec::new();
            for value in &check.cold {
                tape.nodes[value.index()].operands(|operand| taken.push(operand));
            }
            taken.extend(check.margin);
            for value in taken.into_iter().filter(|value| !check.cold.contains(value)) {
                stages.need(value, check.order);
            }
        }
        for index in (0..tape.nodes.len()).rev() {
            let order = stages.nodes[index];
            if order == never {
                continue;
            }
            let node = tape.nodes[index];
            node.operands(|operand| stages.need(operand, order));
            match node {
                TapeNode::Root { search, .. } => stages.search(tape, search, order),
                TapeNode::Solution { solution, .. } => {
                    stages.solutions[solution] = stages.solutions[solution].min(order);
                    for value in &tape.solutions[solution].right {
                        stages.need(*value, order);
                    }
                    stages.system(tape, tape.solutions[solution].system, order);
                }
                _ => {}
            }
        }
        stages
    }

    fn need(&mut self, value: Value, order: usize) {
        let known_order = &mut self.nodes[value.index()];
        *known_order = order.min(*known_order);
    }

    fn search(&mut self, tape: &Tape<'_>, search: usize, order: usize) {
        self.searches[search] = self.searches[search].min(order);
        let sought = &tape.searches[search];
        let values = sought.guess.iter().chain(&sought.sizes).chain(&sought.residuals);
        for value in values.chain(sought.jacobian.iter().flatten()) {
            self.need(*value, order);
        }
    }

    fn system(&mut self, tape: &Tape<'_>, system: usize, order: usize) {
        self.systems[system] = self.systems[system].min(order);
        for value in tape.systems[system].rows.iter().flatten() {
            self.need(*value, order);
        }
    }

    /// The order of a node.
    pub(super) fn of(&self, value: Value) -> usize {
        self.nodes[value.index()]
    }

    /// The order of a system.
    pub(super) fn of_system(&self, system: usize) -> usize {
        self.systems[system]
    }

    /// The order of a step.
    pub(super) fn of_step(&self, tape: &Tape<'_>, step: TapeStep) -> usize {
        match step {
            TapeStep::Compute(value) => self.of(value),
            TapeStep::Check(check) => self.of_order(tape.checks[check].order),
            TapeStep::Search(search) => self.searches[search],
            TapeStep::Factor(system) => self.systems[system],
            TapeStep::Solve(solution) => self.solutions[solution],
        }
    }
}
