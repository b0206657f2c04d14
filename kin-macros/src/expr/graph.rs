//! The graph itself: nodes, what they hold, and how equal ones are found.

use std::collections::BTreeSet;

use super::HashMap;
use crate::function::Function;

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
    /// A value that the program computes in a step of its own: what a closed form returns, or an abbreviation.
    Step(usize),
}

/// A number that can be compared and hashed: never NaN, never the negative zero.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) struct Number(u64);

impl Number {
    pub(crate) fn new(value: f64) -> Self {
        // adding zero turns the negative zero into the positive one
        Self((value + 0.0).to_bits())
    }

    pub(crate) const fn get(self) -> f64 {
        f64::from_bits(self.0)
    }
}

/// What a node holds, in normal form.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(crate) enum Term {
    Number(Number),
    /// π, kept apart from numbers so that quarter turns are found exactly.
    Pi,
    Symbol(Symbol),
    /// constant + Σ coefficient · node, the nodes in ascending order, none of them a number or a sum, no coefficient zero.
    Sum(Number, Vec<(Node, Number)>),
    /// Π node^exponent, the nodes in ascending order, none of them a number or a product, no exponent zero.
    Product(Vec<(Node, i32)>),
    Call(Function, Vec<Node>),
}

/// The expressions of one declaration.
#[derive(Clone, Default)]
pub(crate) struct Graph {
    terms: Vec<Term>,
    known: HashMap<Term, Node>,
    steps: usize,
    /// Whether numbers stay as they are, as terms and factors like others.
    pub(super) keeps_numbers: bool,
}

#[cfg(test)]
thread_local! {
    /// How often an expression has been looked up in any graph of this thread: a measure of the work of an expansion that is the
    /// same in every run.
    pub(crate) static LOOKUPS: std::cell::Cell<usize> = const { std::cell::Cell::new(0) };
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

    /// A symbol for a value that the program computes in a step of its own.
    pub(crate) fn new_step(&mut self) -> (Symbol, Node) {
        let symbol = Symbol::Step(self.steps);
        self.steps += 1;
        (symbol, self.symbol(symbol))
    }

    /// What a node holds.
    pub(crate) fn term(&self, node: Node) -> &Term {
        &self.terms[node.index()]
    }

    /// The node that holds a term, which must be in normal form.
    pub(super) fn intern(&mut self, term: Term) -> Node {
        #[cfg(test)]
        LOOKUPS.set(LOOKUPS.get() + 1);
        if let Some(&node) = self.known.get(&term) {
            return node;
        }
        let node = Node(u32::try_from(self.terms.len()).expect("fewer than 2^32 nodes"));
        self.terms.push(term.clone());
        self.known.insert(term, node);
        node
    }

    /// The nodes that a node is made of, directly.
    pub(crate) fn operands(&self, node: Node) -> Vec<Node> {
        match self.term(node) {
            Term::Number(_) | Term::Pi | Term::Symbol(_) => Vec::new(),
            Term::Sum(_, terms) => terms.iter().map(|&(operand, _)| operand).collect(),
            Term::Product(factors) => factors.iter().map(|&(operand, _)| operand).collect(),
            Term::Call(_, arguments) => arguments.clone(),
        }
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

    /// The symbols that an expression contains.
    pub(crate) fn symbols(&self, node: Node) -> BTreeSet<Symbol> {
        self.reachable(&[node])
            .into_iter()
            .filter_map(|part| self.as_symbol(part))
            .collect()
    }

    /// Whether there is nothing in an expression but parameters, inputs and unknowns: no time derivative, and nothing that the
    /// program computes in a step of its own.
    pub(crate) fn depends_on_position_alone(&self, node: Node) -> bool {
        self.symbols(node)
            .into_iter()
            .all(|symbol| matches!(symbol, Symbol::Parameter(_) | Symbol::Input(_) | Symbol::Unknown(_)))
    }

    /// Whether an expression contains a symbol.
    pub(crate) fn contains(&self, node: Node, symbol: Symbol) -> bool {
        self.symbols(node).contains(&symbol)
    }

    /// The symbol that a node is, if it is one.
    pub(crate) fn as_symbol(&self, node: Node) -> Option<Symbol> {
        match self.term(node) {
            Term::Symbol(symbol) => Some(*symbol),
            _ => None,
        }
    }

    /// The number that a node is, if it is one (π is none).
    pub(crate) fn as_number(&self, node: Node) -> Option<f64> {
        match self.term(node) {
            Term::Number(value) => Some(value.get()),
            _ => None,
        }
    }

    /// The value of an expression without symbols.
    pub(crate) fn constant_value(&self, node: Node) -> Option<f64> {
        if self.symbols(node).is_empty() {
            Some(self.evaluate(node, &|_| f64::NAN))
        } else {
            None
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
        match self.term(node) {
            Term::Number(value) => {
                let value = value.get();
                (value, self.number(1.0))
            }
            Term::Sum(constant, terms) if constant.get() == 0.0 && terms.len() == 1 => (terms[0].1.get(), terms[0].0),
            _ => (1.0, node),
        }
    }
}
