//! The graph itself: nodes, what they hold, and how equal ones are found.

use std::collections::BTreeSet;
use std::fmt::{self, Display, Formatter};
use std::num::FpCategory;
use std::sync::Arc;

use super::HashMap;
use super::content::{Content, Contents};
use super::harmonic::{Expanded, ExpandedKey};
use super::probe::POINTS;
use crate::algebra::Function;
use crate::work;

/// An expression: its number in the graph.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(crate) struct Node(pub(super) u32);

impl Node {
    pub(crate) const fn index(self) -> usize {
        self.0 as usize
    }
}

/// A quantity whose value comes from outside of the graph.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(crate) enum Symbol {
    /// A scalar of the structure of parameters; a point takes two, one of space three.
    Parameter(usize),
    /// An input's value.
    Input(usize),
    /// An unknown's value.
    Unknown(usize),
    /// An input's time derivative of the order given second.
    InputRate(usize, usize),
    /// An unknown's time derivative of the order given second.
    UnknownRate(usize, usize),
    /// Q of the order given second, of an unknown angle: its rate of this order and what the lower ones add to it.
    Turning(usize, usize),
    /// A scalar part of an output's time derivative of the order given second.
    OutputRate(usize, usize),
    /// An unknown's partial derivative by the parameter given second, its time derivative of the order given third.
    Sensitivity(usize, usize, usize),
    /// The same of a scalar part of an output.
    OutputSensitivity(usize, usize, usize),
    /// A value that the program computes in a step of its own: the result of a closed form, or an abbreviation.
    Step(usize),
    /// A value that got its name when the program was scheduled.
    Value(usize),
}

/// A number that can be compared and hashed: never NaN, never the negative zero.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) struct Constant(u64);

impl Constant {
    pub(crate) fn new(value: f64) -> Self {
        // adding zero turns the negative zero into the positive one
        Self((value + 0.0).to_bits())
    }

    pub(crate) const fn get(self) -> f64 {
        f64::from_bits(self.0)
    }
}

/// Why a constant is none: an `f64` holds it not at all, or not to its full precision.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Misfit {
    TooLarge,
    TooSmall,
}

impl Misfit {
    /// What is wrong with a constant, of which is known whether it is zero in truth.
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

/// What a node holds, in normal form.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(crate) enum NodeKind {
    Number(Constant),
    /// π, kept apart from numbers so that quarter turns are found exactly.
    Pi,
    Symbol(Symbol),
    /// constant + Σ coefficient · node, the nodes in ascending order, none of them a number or a short sum, no coefficient zero.
    Sum(Constant, Vec<(Node, Constant)>),
    /// Π node^exponent, the nodes in ascending order, none of them a number or a short product, no exponent zero.
    Product(Vec<(Node, i32)>),
    Call(Function, Vec<Node>),
}

/// The symbols that an expression is seen as a function of; all others are constants to it.
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
    /// Whether a symbol is among them.
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
    /// The values of all expressions so far looked at, at the points where identities are probed.
    pub(super) probed: Vec<[f64; POINTS]>,
    /// What has been expanded.
    pub(super) expanded: HashMap<ExpandedKey, Arc<Expanded>>,
    steps: usize,
    /// The first constant that was too large or too small.
    misfit: Option<Misfit>,
    /// Whether numbers stay as they are, as terms and factors like others.
    pub(super) keeps_numbers: bool,
}

impl Graph {
    pub(crate) fn new() -> Self {
        Self::default()
    }

    /// From now on numbers are not folded into the sums and products that they are part of. These still mean the same, but are not
    /// in normal form: zeros and equal expressions are no longer found.
    pub(crate) const fn keep_numbers(&mut self) {
        self.keeps_numbers = true;
    }

    /// Takes note of what is wrong with a constant that has just been folded.
    pub(super) fn note(&mut self, misfit: Option<Misfit>) {
        self.misfit = self.misfit.or(misfit);
    }

    /// Whether a constant has been too large or too small since this was last taken. What was made of it is wrong.
    pub(crate) const fn take_misfit(&mut self) -> Option<Misfit> {
        self.misfit.take()
    }

    /// The same, left where it is.
    pub(crate) const fn misfit(&self) -> Option<Misfit> {
        self.misfit
    }

    /// A symbol for a value that the program computes in a step of its own.
    pub(crate) fn new_step(&mut self) -> (Symbol, Node) {
        let symbol = Symbol::Step(self.steps);
        self.steps += 1;
        (symbol, self.symbol(symbol))
    }

    /// How many expressions there are.
    pub(crate) const fn len(&self) -> usize {
        self.terms.len()
    }

    /// What a node holds.
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

    /// The kinds of symbols that an expression contains, and which parameters, inputs and unknowns.
    pub(super) fn content(&self, node: Node) -> Content {
        self.contents.of(node)
    }

    /// The nodes that a node is made of, directly.
    pub(crate) fn operands(&self, node: Node) -> Vec<Node> {
        match self.kind(node) {
            NodeKind::Number(_) | NodeKind::Pi | NodeKind::Symbol(_) => Vec::new(),
            NodeKind::Sum(_, terms) => terms.iter().map(|&(operand, _)| operand).collect(),
            NodeKind::Product(factors) => factors.iter().map(|&(operand, _)| operand).collect(),
            NodeKind::Call(_, arguments) => arguments.clone(),
        }
    }

    /// The nodes from a number on, in the order in which they were made.
    pub(crate) fn nodes_from(&self, first: usize) -> impl Iterator<Item = Node> + use<> {
        (first..self.terms.len()).filter_map(|index| u32::try_from(index).ok().map(Node))
    }

    /// Every node that the given ones are made of, themselves included, in ascending order.
    pub(crate) fn reachable(&self, roots: &[Node]) -> BTreeSet<Node> {
        let mut seen = BTreeSet::new();
        let mut open = roots.to_vec();
        while let Some(node) = open.pop() {
            if seen.insert(node) {
                open.extend(self.operands(node));
            }
        }
        seen
    }

    /// Whether an expression is of parameters, inputs and unknowns alone: it contains no time derivative, and nothing that the
    /// program computes in a step of its own.
    pub(crate) fn depends_on_position_alone(&self, node: Node) -> bool {
        self.content(node).is_of_position()
    }

    /// Whether an expression has no time derivative: it contains nothing but parameters and the results of steps.
    pub(crate) fn is_constant_in_time(&self, node: Node) -> bool {
        self.content(node).is_constant_in_time()
    }

    /// The numbers of the unknowns whose values an expression contains, ascending.
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

    /// The symbol that a node is, if it is one.
    pub(crate) fn as_symbol(&self, node: Node) -> Option<Symbol> {
        match self.kind(node) {
            NodeKind::Symbol(symbol) => Some(*symbol),
            _ => None,
        }
    }

    /// The number that a node is, if it is one (π is none).
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

    /// The largest exponent of a factor, without its sign.
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

    /// How far the constants that stand in a node itself are from 1, as a logarithm without its sign; zero is not counted.
    pub(crate) fn extremity(&self, node: Node) -> f64 {
        let size = |number: &Constant| {
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

    pub(crate) fn is_zero(&self, node: Node) -> bool {
        self.as_number(node) == Some(0.0)
    }

    pub(crate) fn is_one(&self, node: Node) -> bool {
        self.as_number(node) == Some(1.0)
    }

    /// An expression as a number times one that has none in front: `-3 a b` is `(-3, a b)`.
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

    /// Of a sum it is the largest in its terms; a symbol by itself has none.
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

    /// A number in front is split off, and nothing else is: what comes back multiplies to the same expression.
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
