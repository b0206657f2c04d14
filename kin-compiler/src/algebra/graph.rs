//! The graph: its nodes, their contents, and the search for equal nodes.

use std::fmt::{self, Display, Formatter};
use std::num::FpCategory;
use std::sync::Arc;

use super::content::{Content, Contents};
use super::harmonic::{Expanded, ExpandedKey};
use super::probe::POINTS;
use super::{HashMap, Index, IndexTable};
use crate::algebra::Function;
use crate::work;

/// An expression, as its index in the graph.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(crate) struct Node(pub(super) u32);

impl Index for Node {
    fn index(self) -> usize {
        self.0 as usize
    }
}

/// A quantity whose value comes from outside of the graph.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Symbol {
    /// A scalar of the structure of parameters. A point of the plane has two, a point of space three.
    Parameter(usize),
    /// An input's value.
    Input(usize),
    /// An unknown's value.
    Unknown(usize),
    /// An input's time derivative: input, order.
    InputRate(usize, usize),
    /// An unknown's time derivative: unknown, order.
    UnknownRate(usize, usize),
    /// Q of an unknown angle: unknown, order. Q is the rate of this order plus the contribution of the lower rates.
    Turning(usize, usize),
    /// The time derivative of a scalar part of an output: part, order.
    OutputRate(usize, usize),
    /// An unknown's partial derivative by a parameter: unknown, parameter, order of the time derivative.
    Sensitivity(usize, usize, usize),
    /// The partial derivative of a scalar part of an output by a parameter: part, parameter, order of the time
    /// derivative.
    OutputSensitivity(usize, usize, usize),
    /// A value that the program computes in a separate step: the result of a closed form, or an abbreviation.
    Step(usize),
    /// A value that the scheduler named.
    Value(usize),
}

/// A number that can be compared and hashed: never NaN, never negative zero.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) struct FiniteNumber(u64);

impl FiniteNumber {
    pub(crate) fn new(value: f64) -> Self {
        // adding zero changes negative zero into positive zero
        Self((value + 0.0).to_bits())
    }

    pub(crate) const fn get(self) -> f64 {
        f64::from_bits(self.0)
    }
}

/// The reason why a number cannot be a constant: an `f64` cannot hold it, or not to full precision.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Misfit {
    TooLarge,
    TooSmall,
}

impl Misfit {
    /// The fault of a rounded constant; `is_zero` decides whether the exact value is zero.
    pub(crate) fn of(value: f64, is_zero: bool) -> Option<Self> {
        match value.classify() {
            FpCategory::Nan | FpCategory::Infinite => Some(Self::TooLarge),
            FpCategory::Subnormal => Some(Self::TooSmall),
            FpCategory::Zero if !is_zero => Some(Self::TooSmall),
            FpCategory::Zero | FpCategory::Normal => None,
        }
    }
}

impl Display for Misfit {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::TooLarge => "too large for an `f64`",
            Self::TooSmall => "too small for an `f64`",
        })
    }
}

/// The content of a node, in normal form.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(crate) enum NodeKind {
    Number(FiniteNumber),
    /// π, kept apart from numbers so that right angles are found exactly.
    Pi,
    Symbol(Symbol),
    /// constant + Σ coefficient · node. The nodes ascend, none is a number or a short sum, and no coefficient is zero.
    Sum(FiniteNumber, Vec<(Node, FiniteNumber)>),
    /// Π node^exponent. The nodes ascend, none is a number or a short product, and no exponent is zero.
    Product(Vec<(Node, i32)>),
    Call(Function, Vec<Node>),
}

/// The variables of an expression. All other symbols count as constants.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Variables<'a> {
    /// These unknowns.
    Unknowns(&'a [usize]),
    /// All unknowns.
    AllUnknowns,
    /// All inputs and unknowns.
    Position,
}

impl Variables<'_> {
    /// Whether a symbol is one of the variables.
    pub(crate) fn include(self, symbol: Symbol) -> bool {
        match (self, symbol) {
            (Self::Unknowns(unknowns), Symbol::Unknown(unknown)) => unknowns.contains(&unknown),
            (Self::AllUnknowns | Self::Position, Symbol::Unknown(_)) | (Self::Position, Symbol::Input(_)) => true,
            _ => false,
        }
    }
}

/// The expressions of one declaration.
#[derive(Clone, Default)]
pub(crate) struct Graph {
    terms: Vec<NodeKind>,
    known: HashMap<NodeKind, Node>,
    contents: Contents,
    /// The values of the expressions probed so far, at the points where identities are probed.
    pub(super) probed: Vec<[f64; POINTS]>,
    /// The expansions made so far.
    pub(super) expanded: HashMap<ExpandedKey, Arc<Expanded>>,
    steps: usize,
    /// The first constant that was too large or too small.
    misfit: Option<Misfit>,
    /// Whether numbers stay unfolded, as ordinary terms and factors.
    pub(super) keeps_numbers: bool,
}

impl Graph {
    pub(crate) fn new() -> Self {
        Self::default()
    }

    /// From now on, sums and products do not fold their numbers. Their values stay the same, but they are not in normal
    /// form: zeros and equal expressions are no longer recognised.
    pub(crate) const fn keep_numbers(&mut self) {
        self.keeps_numbers = true;
    }

    /// Records the fault of a constant that has just been folded.
    pub(super) fn note(&mut self, misfit: Option<Misfit>) {
        self.misfit = self.misfit.or(misfit);
    }

    /// Takes the fault of a constant recorded since the last call. Expressions made from that constant are wrong.
    pub(crate) const fn take_misfit(&mut self) -> Option<Misfit> {
        self.misfit.take()
    }

    /// The fault of a constant recorded so far, which stays recorded.
    pub(crate) const fn misfit(&self) -> Option<Misfit> {
        self.misfit
    }

    /// A new symbol for a value that the program computes in a separate step.
    pub(crate) fn new_step(&mut self) -> (Symbol, Node) {
        let symbol = Symbol::Step(self.steps);
        self.steps += 1;
        (symbol, self.symbol(symbol))
    }

    /// The number of expressions.
    pub(crate) const fn len(&self) -> usize {
        self.terms.len()
    }

    /// The content of a node.
    pub(crate) fn kind(&self, node: Node) -> &NodeKind {
        &self.terms[node.index()]
    }

    /// The node that holds a term, which must be in normal form.
    pub(super) fn intern(&mut self, term: NodeKind) -> Node {
        work::look_up();
        if let Some(&node) = self.known.get(&term) {
            return node;
        }
        let node = Node(u32::try_from(self.terms.len()).expect("fewer than 2^32 nodes"));
        self.contents.push(&term);
        self.terms.push(term.clone());
        self.known.insert(term, node);
        node
    }

    /// The kinds of symbols in an expression, and its parameters, inputs and unknowns.
    pub(super) fn content(&self, node: Node) -> Content {
        self.contents.of(node)
    }

    /// The direct operands of a node.
    pub(crate) fn operands(&self, node: Node) -> Vec<Node> {
        match self.kind(node) {
            NodeKind::Number(_) | NodeKind::Pi | NodeKind::Symbol(_) => Vec::new(),
            NodeKind::Sum(_, terms) => terms.iter().map(|&(operand, _)| operand).collect(),
            NodeKind::Product(factors) => factors.iter().map(|&(operand, _)| operand).collect(),
            NodeKind::Call(_, arguments) => arguments.clone(),
        }
    }

    /// The nodes from an index on, in the order of creation.
    pub(crate) fn nodes_from(&self, first: usize) -> impl Iterator<Item = Node> + use<> {
        (first..self.terms.len()).filter_map(|index| u32::try_from(index).ok().map(Node))
    }

    /// The given nodes and all nodes below them, in ascending order.
    pub(crate) fn reachable(&self, roots: &[Node]) -> Vec<Node> {
        let mut seen = IndexTable::default();
        let mut pending = roots.to_vec();
        let mut found = Vec::new();
        while let Some(node) = pending.pop() {
            if seen.get(node).is_none() {
                seen.insert(node, ());
                found.push(node);
                pending.extend(self.operands(node));
            }
        }
        found.sort_unstable();
        found
    }

    /// Whether an expression consists of parameters, inputs and unknowns alone: it contains no time derivative and no
    /// result of a step.
    pub(crate) fn depends_on_position_alone(&self, node: Node) -> bool {
        self.content(node).is_of_position()
    }

    /// Whether an expression is constant in time: it contains only parameters and results of steps.
    pub(crate) fn is_constant_in_time(&self, node: Node) -> bool {
        self.content(node).is_constant_in_time()
    }

    /// The indices of the unknowns whose values an expression contains, ascending.
    pub(crate) fn unknowns(&self, node: Node) -> impl Iterator<Item = usize> + '_ {
        self.contents.unknowns(self.content(node))
    }

    /// Whether an expression contains the value of an unknown.
    pub(crate) fn has_unknowns(&self, node: Node) -> bool {
        self.content(node).has_unknowns()
    }

    /// Whether an expression contains the value of one of these unknowns.
    pub(crate) fn has_any_of(&self, node: Node, unknowns: &[usize]) -> bool {
        let content = self.content(node);
        content.has_unknowns()
            && unknowns
                .iter()
                .any(|&unknown| self.contents.has(content, Symbol::Unknown(unknown)))
    }

    /// Whether an expression contains a parameter, an input or an unknown.
    pub(crate) fn contains(&self, node: Node, symbol: Symbol) -> bool {
        self.contents.has(self.content(node), symbol)
    }

    /// Whether an expression varies when these variables do.
    pub(crate) fn varies(&self, node: Node, variables: Variables<'_>) -> bool {
        match variables {
            Variables::Unknowns(unknowns) => self.has_any_of(node, unknowns),
            Variables::AllUnknowns => self.has_unknowns(node),
            Variables::Position => self.content(node).has_inputs_or_unknowns(),
        }
    }

    /// The symbol of a node that is a symbol.
    pub(crate) fn as_symbol(&self, node: Node) -> Option<Symbol> {
        match self.kind(node) {
            NodeKind::Symbol(symbol) => Some(*symbol),
            _ => None,
        }
    }

    /// The number of a node that is a number. π is not a number here.
    pub(crate) fn as_number(&self, node: Node) -> Option<f64> {
        match self.kind(node) {
            NodeKind::Number(value) => Some(value.get()),
            _ => None,
        }
    }

    /// The value of an expression without symbols.
    pub(crate) fn constant_value(&self, node: Node) -> Option<f64> {
        if self.content(node).is_constant() {
            Some(self.evaluate(node, &|_| f64::NAN))
        } else {
            None
        }
    }

    /// The largest absolute exponent of a factor.
    pub(crate) fn largest_exponent(&self, node: Node) -> Option<u32> {
        let of_factors = |node: Node| match self.kind(node) {
            NodeKind::Product(factors) => factors.iter().map(|(_, exponent)| exponent.unsigned_abs()).max(),
            _ => None,
        };
        match self.kind(node) {
            NodeKind::Sum(_, terms) => terms.iter().filter_map(|&(term, _)| of_factors(term)).max(),
            _ => of_factors(node),
        }
    }

    /// The largest distance of the constants of a node from 1, as an absolute logarithm. Zero is ignored.
    pub(crate) fn extremity(&self, node: Node) -> f64 {
        let size = |number: &FiniteNumber| {
            if number.get() == 0.0 {
                0.0
            } else {
                number.get().abs().ln().abs()
            }
        };
        match self.kind(node) {
            NodeKind::Number(value) => size(value),
            NodeKind::Sum(constant, terms) => terms
                .iter()
                .map(|(_, coefficient)| size(coefficient))
                .fold(size(constant), f64::max),
            NodeKind::Pi | NodeKind::Symbol(_) | NodeKind::Product(_) | NodeKind::Call(..) => 0.0,
        }
    }

    /// Whether an expression is a symbol or its opposite.
    pub(crate) fn is_signed_symbol(&self, node: Node, symbol: Symbol) -> bool {
        match self.kind(node) {
            NodeKind::Symbol(known) => *known == symbol,
            NodeKind::Sum(constant, terms) if constant.get() == 0.0 => {
                matches!(
                    terms[..],
                    [(term, factor)] if factor.get().abs() == 1.0 && self.as_symbol(term) == Some(symbol)
                )
            }
            _ => false,
        }
    }

    pub(crate) fn is_zero(&self, node: Node) -> bool {
        self.as_number(node) == Some(0.0)
    }

    pub(crate) fn is_one(&self, node: Node) -> bool {
        self.as_number(node) == Some(1.0)
    }

    /// Splits an expression into a number and a rest without a number in front: `-3 a b` is `(-3, a b)`.
    pub(crate) fn split_coefficient(&mut self, node: Node) -> (f64, Node) {
        match self.kind(node) {
            NodeKind::Number(value) => {
                let value = value.get();
                (value, self.number(1.0))
            }
            NodeKind::Sum(constant, terms) if constant.get() == 0.0 && terms.len() == 1 => {
                (terms[0].1.get(), terms[0].0)
            }
            _ => (1.0, node),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest exponent of a sum is the largest of its terms; a symbol alone has none.
    #[test]
    fn the_largest_exponent_is_that_of_any_factor() {
        let mut graph = Graph::new();
        let [a, b] = [0, 1].map(|parameter| graph.symbol(Symbol::Parameter(parameter)));
        let product = graph.product(&[(a, 3), (b, -4)]);
        assert_eq!(graph.largest_exponent(product), Some(4));
        let square = graph.power(a, 2);
        let sum = graph.linear(1.0, &[(a, 1.0), (square, -2.0), (product, 1.0)]);
        assert_eq!(graph.largest_exponent(sum), Some(4));
        assert_eq!(graph.largest_exponent(a), None);
    }

    /// Only the number in front is split off: the two parts multiply to the same expression.
    #[test]
    fn a_coefficient_is_what_stands_in_front() {
        let mut graph = Graph::new();
        let [a, b] = [0, 1].map(|parameter| graph.symbol(Symbol::Parameter(parameter)));
        let product = graph.multiply(a, b);
        let scaled = graph.scale(-3.0, product);
        assert_eq!(graph.split_coefficient(scaled), (-3.0, product));
        let shifted = graph.linear(1.0, &[(a, 2.0)]);
        assert_eq!(graph.split_coefficient(shifted), (1.0, shifted));
        let sum = graph.linear(0.0, &[(a, 2.0), (b, 2.0)]);
        assert_eq!(graph.split_coefficient(sum), (1.0, sum));
    }
}
