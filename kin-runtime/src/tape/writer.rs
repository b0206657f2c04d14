//! The nodes of a tape as expressions of a language, shared by JavaScript and Python.

use std::string::String;
use std::vec;
use std::vec::Vec;

use crate::tape::expression::Code;
use crate::tape::spelling::Target;
use crate::tape::structure::Tape;
use crate::tape::{Function, TapeNode, TapeStep, Value};

/// The ways in which a language writes operands.
pub(super) trait Dialect {
    /// The language.
    const TARGET: Target;

    /// A number that is read as itself.
    fn number(&self, value: f64) -> Code;

    /// A truth.
    fn truth(&self, holds: bool) -> Code;
}

impl TapeStep {
    /// The node that the step computes.
    pub(super) fn computed(&self) -> Option<Value> {
        match *self {
            Self::Compute(value) => Some(value),
            _ => None,
        }
    }
}

/// The nodes of a tape as expressions: names where a node has one, otherwise the operation.
pub(super) struct Writer<'a, D> {
    tape: &'a Tape<'a>,
    dialect: D,
    names: Vec<Option<String>>,
    uses: Vec<usize>,
}

/// The longest expression that replaces a name, in letters.
const LONGEST_EXPRESSION: usize = 60;

impl<'a, D: Dialect> Writer<'a, D> {
    pub(super) fn new(tape: &'a Tape<'a>, dialect: D) -> Self {
        let mut uses = vec![0_usize; tape.nodes.len()];
        for node in &tape.nodes {
            node.operands(|operand| uses[operand.index()] += 1);
        }
        // Whatever else needs a node needs it by its name.
        let mut named = |value: &Value| uses[value.index()] += 2;
        tape.results.iter().for_each(|result| named(&result.value));
        tape.checks
            .iter()
            .filter_map(|check| check.margin.as_ref())
            .for_each(&mut named);
        for search in &tape.searches {
            search
                .guess
                .iter()
                .chain(&search.sizes)
                .chain(&search.residuals)
                .for_each(&mut named);
            search.jacobian.iter().flatten().for_each(&mut named);
        }
        tape.systems
            .iter()
            .flat_map(|system| system.rows.iter().flatten())
            .for_each(&mut named);
        tape.solutions
            .iter()
            .flat_map(|solution| &solution.right)
            .for_each(&mut named);
        Self {
            tape,
            dialect,
            names: vec![None; tape.nodes.len()],
            uses,
        }
    }

    /// Gives a node a name, or an expression that stands for it.
    pub(super) fn name(&mut self, value: Value, name: impl Into<String>) {
        self.names[value.index()] = Some(name.into());
    }

    /// The names of nodes, to be given back by [`rename`](Self::rename).
    pub(super) fn names_of(&self, values: &[Value]) -> Vec<Option<String>> {
        values.iter().map(|value| self.names[value.index()].clone()).collect()
    }

    /// Gives a node a name that it had, or takes its name.
    pub(super) fn rename(&mut self, value: Value, name: Option<String>) {
        self.names[value.index()] = name;
    }

    /// The names of a group of nodes that are computed one after the other, each with the expression that it stands
    /// for. A node that is needed once, by a node of the group, becomes a part of that node, unless it is long. Sines
    /// and cosines are left to the caller.
    pub(super) fn named(&self, group: &[Value], limit: Option<usize>) -> Vec<Value> {
        let limit = limit.unwrap_or(LONGEST_EXPRESSION);
        let mut within = vec![0_usize; self.uses.len()];
        for value in group {
            self.tape.nodes[value.index()].operands(|operand| within[operand.index()] += 1);
        }
        let mut length = vec![0_usize; self.uses.len()];
        let mut named = Vec::new();
        for value in group {
            let node = self.tape.nodes[value.index()];
            let mut own_length = 4;
            node.operands(|operand| own_length += length[operand.index()].max(5));
            let index = value.index();
            let is_pair = matches!(node, TapeNode::Call(Function::Sine | Function::Cosine, _));
            if self.uses[index] == 1 && within[index] == 1 && own_length <= limit && !is_pair {
                length[index] = own_length;
            } else {
                named.push(*value);
            }
        }
        named
    }

    /// A node by its name, or its operation if it has none.
    pub(super) fn value(&self, value: Value) -> Code {
        match &self.names[value.index()] {
            Some(name) => Code::whole(name.clone()),
            None => self.operation(value),
        }
    }

    /// The operation of a node.
    pub(super) fn operation(&self, value: Value) -> Code {
        match &self.tape.nodes[value.index()] {
            TapeNode::Constant(constant) => self.dialect.number(constant.value()),
            TapeNode::Certain(holds) => self.dialect.truth(*holds),
            node => node.written(D::TARGET, |operand| self.value(operand)),
        }
    }
}
