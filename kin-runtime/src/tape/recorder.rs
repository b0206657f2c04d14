//! The recorder: what a recording number writes down.

use core::cell::RefCell;
use std::collections::HashMap;
use std::vec::Vec;

use crate::assembly::Assembly;
use crate::tape::run::{called, combined};
use crate::tape::{Comparison, Condition, Constant, Function, NumberType, Operator, TapeNode, Value};

std::thread_local! {
    static RECORDER: RefCell<Recorder> = RefCell::new(Recorder::new(NumberType::Double, Vec::new(), &[]));
}

/// Calls `work` with the recorder of this thread.
pub(super) fn with<R>(work: impl FnOnce(&mut Recorder) -> R) -> R {
    RECORDER.with_borrow_mut(work)
}

/// Starts a record, and returns the one before.
pub(super) fn begin(recorder: Recorder) -> Recorder {
    RECORDER.replace(recorder)
}

/// Where an assembly comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum AssemblySource {
    /// It is known beforehand.
    Fixed(Assembly),
    /// The choice of the caller with this index, or its opposite.
    Choice { index: usize, is_mirrored: bool },
    /// The side of the singular positions on which values nearby lie, by its number, or the opposite.
    Side { index: usize, is_mirrored: bool },
}

/// An event between two nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Event {
    Check(usize),
    Search(usize),
    Factor(usize),
    Solve(usize),
}

/// A check as recorded.
#[derive(Clone, Copy, Debug)]
pub(super) struct Noted {
    pub(super) name: &'static str,
    pub(super) condition: Condition,
    pub(super) margin: Option<Value>,
    /// The number of nodes in front of those of the margin.
    pub(super) before: usize,
    /// Whether the position alone was being solved.
    pub(super) is_of_position: bool,
    /// How many checks were made before, repeated ones included.
    pub(super) number: usize,
}

/// A search as recorded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Sought {
    pub(super) guess: Vec<Value>,
    pub(super) sizes: Vec<Value>,
    pub(super) residuals: Vec<Value>,
    pub(super) jacobian: Vec<Vec<Value>>,
}

/// Everything that one run of a solver writes down.
pub(super) struct Recorder {
    pub(super) precision: NumberType,
    pub(super) nodes: Vec<TapeNode>,
    known: HashMap<TapeNode, Value>,
    /// What happened, each with the number of nodes in front of it.
    pub(super) events: Vec<(usize, Event)>,
    pub(super) checks: Vec<Noted>,
    pub(super) searches: Vec<Sought>,
    pub(super) systems: Vec<Vec<Vec<Value>>>,
    pub(super) solutions: Vec<(usize, Vec<Value>)>,
    /// Whether the position alone is being solved.
    pub(super) is_of_position: bool,
    /// How many checks were made, repeated ones included.
    made: usize,
    /// The check that is to fail, by its number, and its operands once it has failed.
    pub(super) fails: Option<usize>,
    pub(super) failed: Vec<Value>,
    /// The assemblies that the solver asked for, in order.
    pub(super) asked: Vec<Assembly>,
    /// Where they come from, as far as it is known.
    pub(super) sources: Vec<AssemblySource>,
    /// The node of each choice of the caller.
    pub(super) choices: Vec<Value>,
    /// The truths on which sides depend, in order.
    pub(super) sides: Vec<Value>,
    /// The side that is to be crossed.
    pub(super) crossed_side: Option<usize>,
    /// Whether the solver has read a value, and may have decided by it.
    pub(super) is_read: bool,
    /// The values of the arguments at the position of the record; empty if there is no such position.
    at: Vec<f64>,
    /// The value of each node there. Truths are 1 and 0, and a root is its guess.
    values: Vec<f64>,
}

impl Recorder {
    pub(super) fn new(precision: NumberType, sources: Vec<AssemblySource>, at: &[f64]) -> Self {
        Self {
            precision,
            nodes: Vec::new(),
            known: HashMap::new(),
            events: Vec::new(),
            checks: Vec::new(),
            searches: Vec::new(),
            systems: Vec::new(),
            solutions: Vec::new(),
            is_of_position: false,
            made: 0,
            fails: None,
            failed: Vec::new(),
            asked: Vec::new(),
            sources,
            choices: Vec::new(),
            sides: Vec::new(),
            crossed_side: None,
            is_read: false,
            at: at.to_vec(),
            values: Vec::new(),
        }
    }

    /// The node of an operation: a new one, or the one that does the same already.
    pub(super) fn put(&mut self, node: TapeNode) -> Value {
        let node = self.simplified(node);
        if let TapeNode::Call(Function::Magnitude, value) = node
            && matches!(self.node(value), TapeNode::Call(Function::Magnitude, _))
        {
            return value;
        }
        if let Some(same) = self.same(node) {
            return same;
        }
        if let Some(value) = self.known.get(&node) {
            return *value;
        }
        let value = Value(u32::try_from(self.nodes.len()).unwrap_or(u32::MAX));
        if !self.at.is_empty() {
            let known_value = self.value_of(node);
            self.values.push(known_value);
        }
        self.nodes.push(node);
        self.known.insert(node, value);
        value
    }

    /// The value of a node at the position of the record, and NaN if there is no such position.
    pub(super) fn read(&mut self, value: Value) -> f64 {
        self.is_read = true;
        self.values.get(value.index()).copied().unwrap_or(f64::NAN)
    }

    fn value_of(&self, node: TapeNode) -> f64 {
        let of = |value: Value| self.values.get(value.index()).copied().unwrap_or(f64::NAN);
        let truth = |holds: bool| f64::from(u8::from(holds));
        match node {
            TapeNode::Argument(argument) => self.at.get(argument).copied().unwrap_or(f64::NAN),
            TapeNode::Constant(constant) => constant.value(),
            TapeNode::Certain(holds) => truth(holds),
            TapeNode::Call(function, one) => called(function, of(one)),
            TapeNode::Binary(operator, one, other) => combined(operator, of(one), of(other)),
            TapeNode::PlusProduct(sum, one, other) => of(sum) + of(one) * of(other),
            TapeNode::MinusProduct(sum, one, other) => of(sum) - of(one) * of(other),
            TapeNode::Select(truth, one, other) => of(if of(truth) > 0.0 { one } else { other }),
            TapeNode::Compare(comparison, one, other) => truth(comparison.holds(of(one), of(other))),
            TapeNode::IsFinite(one) => truth(of(one).is_finite()),
            TapeNode::Both(one, other) => of(one) * of(other),
            TapeNode::Either(one, other) => of(one).max(of(other)),
            TapeNode::Not(one) => 1.0 - of(one),
            TapeNode::Root { search, index } => {
                let guess = self.searches.get(search).and_then(|sought| sought.guess.get(index));
                guess.map_or(f64::NAN, |guess| of(*guess))
            }
            TapeNode::Unknown { .. } | TapeNode::Solution { .. } => 1.0,
        }
    }

    pub(super) fn constant(&mut self, value: f64) -> Value {
        let value = self.rounded(value);
        self.put(TapeNode::Constant(Constant::new(value)))
    }

    /// Notes a check, unless the same was made before. The answer is whether it holds: a check holds except for the one
    /// that is to fail.
    pub(super) fn check(
        &mut self,
        name: &'static str,
        condition: Condition,
        margin: Option<Value>,
        before: usize,
    ) -> bool {
        let number = self.made;
        self.made += 1;
        let is_certain = matches!(condition, Condition::Holds(truth) if self.node(truth) == TapeNode::Certain(true));
        let is_repeated = self.checks.iter().any(|check| check.condition == condition);
        if !is_certain && !is_repeated {
            let at = self.checks.len();
            self.checks.push(Noted {
                name,
                condition,
                margin,
                before,
                is_of_position: self.is_of_position,
                number,
            });
            self.events.push((before, Event::Check(at)));
        }
        self.fails != Some(number)
    }

    /// An assembly that depends on a truth.
    pub(super) fn side(&mut self, is_open: Value) -> Assembly {
        let number = self.sides.len();
        self.sides.push(is_open);
        if self.crossed_side == Some(number) {
            Assembly::Crossed
        } else {
            Assembly::Open
        }
    }

    /// The truth that an assembly is open, or the assembly itself if it is known.
    pub(super) fn is_open(&mut self, assembly: Assembly) -> Result<(Value, bool), Assembly> {
        let number = self.asked.len();
        self.asked.push(assembly);
        match self.sources.get(number).copied() {
            Some(AssemblySource::Choice { index, is_mirrored }) => {
                let (sign, is_mirrored) = (self.choices[index], is_mirrored);
                let zero = self.constant(0.0);
                Ok((
                    self.put(TapeNode::Compare(Comparison::AtLeast, sign, zero)),
                    is_mirrored,
                ))
            }
            Some(AssemblySource::Side { index, is_mirrored }) => Ok((self.sides[index], is_mirrored)),
            Some(AssemblySource::Fixed(known)) => Err(known),
            None => Err(assembly),
        }
    }

    pub(super) fn node(&self, value: Value) -> TapeNode {
        self.nodes
            .get(value.index())
            .copied()
            .unwrap_or(TapeNode::Certain(false))
    }

    fn number(&self, value: Value) -> Option<f64> {
        match self.node(value) {
            TapeNode::Constant(constant) => Some(constant.value()),
            _ => None,
        }
    }

    fn truth(&self, value: Value) -> Option<bool> {
        match self.node(value) {
            TapeNode::Certain(truth) => Some(truth),
            _ => None,
        }
    }

    /// A value in the number type of the tape.
    #[expect(clippy::cast_possible_truncation, reason = "this rounds to single precision")]
    fn rounded(&self, value: f64) -> f64 {
        match self.precision {
            NumberType::Single => f64::from(value as f32),
            NumberType::Double => value,
        }
    }

    /// The operand that an operation returns unchanged, bit by bit.
    fn same(&self, node: TapeNode) -> Option<Value> {
        let is = |value: Value, wanted: f64| self.number(value) == Some(wanted);
        match node {
            TapeNode::Binary(Operator::Multiply, one, other) if is(other, 1.0) => Some(one),
            TapeNode::Binary(Operator::Multiply, one, other) if is(one, 1.0) => Some(other),
            TapeNode::Binary(Operator::Divide, one, other) if is(other, 1.0) => Some(one),
            TapeNode::Select(truth, one, other) => match self.truth(truth) {
                Some(true) => Some(one),
                Some(false) => Some(other),
                None => (one == other).then_some(one),
            },
            TapeNode::Both(one, other) => match (self.truth(one), self.truth(other)) {
                (Some(true), _) => Some(other),
                (_, Some(true)) => Some(one),
                _ => (one == other).then_some(one),
            },
            TapeNode::Either(one, other) => match (self.truth(one), self.truth(other)) {
                (Some(false), _) => Some(other),
                (_, Some(false)) => Some(one),
                _ => (one == other).then_some(one),
            },
            TapeNode::Call(Function::Negate, one) => match self.node(one) {
                TapeNode::Call(Function::Negate, operand) => Some(operand),
                _ => None,
            },
            TapeNode::Not(one) => match self.node(one) {
                TapeNode::Not(operand) => Some(operand),
                _ => None,
            },
            _ => None,
        }
    }

    /// The operation on constants carried out, if its result has the same bits everywhere, and operands that may be
    /// exchanged in one order.
    fn simplified(&self, node: TapeNode) -> TapeNode {
        let constant = |value: f64| TapeNode::Constant(Constant::new(self.rounded(value)));
        match node {
            TapeNode::Call(function, one) => {
                let Some(one) = self.number(one) else { return node };
                match function {
                    Function::Negate => constant(-one),
                    Function::Magnitude => constant(one.abs()),
                    // The root of a single-precision number, rounded twice, is the root rounded once.
                    Function::SquareRoot if one >= 0.0 => constant(num_traits::Float::sqrt(one)),
                    _ => node,
                }
            }
            TapeNode::Binary(operator, one, other) => match (self.number(one), self.number(other), operator) {
                (Some(one), Some(other), Operator::Add) => constant(one + other),
                (Some(one), Some(other), Operator::Subtract) => constant(one - other),
                (Some(one), Some(other), Operator::Multiply) => constant(one * other),
                (Some(one), Some(other), Operator::Divide) => constant(one / other),
                (_, _, Operator::Add | Operator::Multiply) if other < one => TapeNode::Binary(operator, other, one),
                _ => node,
            },
            TapeNode::PlusProduct(sum, one, other) if other < one => TapeNode::PlusProduct(sum, other, one),
            TapeNode::MinusProduct(sum, one, other) if other < one => TapeNode::MinusProduct(sum, other, one),
            TapeNode::Compare(comparison, one, other) => match (self.number(one), self.number(other)) {
                (Some(one), Some(other)) => TapeNode::Certain(comparison.holds(one, other)),
                _ => node,
            },
            TapeNode::IsFinite(one) => self
                .number(one)
                .map_or(node, |number| TapeNode::Certain(number.is_finite())),
            TapeNode::Both(one, other) if self.truth(one) == Some(false) || self.truth(other) == Some(false) => {
                TapeNode::Certain(false)
            }
            TapeNode::Either(one, other) if self.truth(one) == Some(true) || self.truth(other) == Some(true) => {
                TapeNode::Certain(true)
            }
            TapeNode::Not(one) => self.truth(one).map_or(node, |truth| TapeNode::Certain(!truth)),
            _ => node,
        }
    }
}

impl Comparison {
    /// Whether it holds between two numbers.
    #[must_use]
    pub fn holds(self, one: f64, other: f64) -> bool {
        match self {
            Self::AtLeast => one >= other,
            Self::Exceeds => one > other,
            Self::Equals => one == other,
        }
    }
}
