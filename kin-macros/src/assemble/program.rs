//! The program that the passes build: stages of steps, every expression in terms of what earlier steps computed.

use std::collections::{BTreeMap, BTreeSet};

use super::directions::Directions;
use super::solver::{Argument, Solver};
use crate::expr::{Node, Symbol};

/// How one of two solutions is chosen.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Mode {
    /// There is but one.
    Only,
    /// By the block's assembly: the index of the caller's choice.
    Assembly(usize),
    /// By the range declared for an unknown, known when the declaration is compiled.
    Fixed { is_open: bool },
    /// By the ranges declared for unknowns, looked up when the candidates are there.
    Ranged,
}

/// A range declared for an unknown, as far as choosing needs it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// The choice that a block leaves.
pub(crate) struct Choice {
    pub(crate) mode: Mode,
    /// Positive in the open assembly, as an expression of unknowns, inputs and parameters.
    pub(crate) orientation: Option<Node>,
}

/// One step.
#[derive(Clone, Debug)]
pub(crate) enum Step {
    /// A value under a name.
    Define { symbol: Symbol, node: Node },
    /// A closed form; `results` are the parts of what it returns, in order.
    Solve {
        solver: Solver,
        arguments: Vec<Argument>,
        results: Vec<Symbol>,
    },
    /// The direction of a vector whose length may be negative.
    Angle {
        symbol: Symbol,
        x: Node,
        y: Node,
        length: Node,
    },
    /// The unknown, just computed, is compared with the range declared for it. One that `turns` came from a direction, and
    /// is as good on any other turn; any other is not, for it stands in its equation as a number. One that `wraps` may have
    /// to be moved by a turn to lie in its range.
    Bound { unknown: usize, turns: bool, wraps: bool },
    /// A part of a block begins.
    Open { part: usize, mode: Mode },
    /// Newton's method from the guess that the caller gave: values of the unknowns at which the residuals vanish. `outside` are the
    /// values of earlier steps that the residuals refer to.
    Newton {
        part: usize,
        unknowns: Vec<usize>,
        residuals: Vec<Node>,
        jacobian: Vec<Vec<Node>>,
        outside: Vec<Node>,
    },
    /// One after the other of all solutions of a block's equations, as values of its variables.
    Every {
        block: usize,
        coefficients: Vec<Node>,
        results: Vec<Symbol>,
    },
    /// The factors of a matrix by which later stages solve.
    Factor { symbol: Symbol, matrix: Vec<Vec<Node>> },
    /// matrix · results = right, by its factors.
    Substitute {
        factors: Node,
        right: Vec<Node>,
        results: Vec<Symbol>,
    },
    /// What must not vanish, because something is divided by it later.
    Regular { node: Node },
    /// It ends.
    Close { part: usize },
}

impl Step {
    /// The expressions that it needs.
    pub(crate) fn needs(&self) -> Vec<Node> {
        match self {
            Self::Define { node, .. } => vec![*node],
            Self::Solve { arguments, .. } => arguments.iter().flat_map(Argument::nodes).collect(),
            Self::Angle { x, y, length, .. } => vec![*y, *x, *length],
            Self::Regular { node } => vec![*node],
            Self::Newton { outside, .. } => outside.clone(),
            Self::Every { coefficients, .. } => coefficients.clone(),
            Self::Factor { matrix, .. } => matrix.concat(),
            Self::Substitute { factors, right, .. } => [*factors].into_iter().chain(right.iter().copied()).collect(),
            Self::Bound { .. } | Self::Open { .. } | Self::Close { .. } => Vec::new(),
        }
    }
}

/// The steps of one order: 0 is position, 1 velocity, and so on.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stage {
    pub(crate) steps: Vec<Step>,
}

/// Position and every order after it.
pub(crate) struct Program {
    pub(crate) stages: Vec<Stage>,
    pub(crate) names: Names,
    /// The unknowns that are handed out as unit vectors.
    pub(crate) directions: Directions,
    /// Whether the last stage is that of the sensitivities, a method of the mechanism, as the position is.
    pub(crate) has_sensitivities: bool,
}

/// The names of symbols in generated code, no two alike.
#[derive(Clone, Default)]
pub(crate) struct Names {
    by_symbol: BTreeMap<Symbol, String>,
    by_name: BTreeMap<String, Symbol>,
    taken: BTreeSet<String>,
    /// The number that was last put behind a wish.
    last: BTreeMap<String, usize>,
}

impl Names {
    /// A name that is not taken yet, as close to the wish as possible.
    pub(crate) fn unique(&mut self, wish: &str) -> String {
        if self.taken.insert(wish.to_owned()) {
            return wish.to_owned();
        }
        let last = self.last.entry(wish.to_owned()).or_insert(1);
        loop {
            *last += 1;
            let name = format!("{wish}_{last}");
            if self.taken.insert(name.clone()) {
                return name;
            }
        }
    }

    /// Makes a name unavailable.
    pub(crate) fn reserve(&mut self, name: &str) {
        self.taken.insert(name.to_owned());
    }

    /// Names a symbol.
    pub(crate) fn name(&mut self, symbol: Symbol, wish: &str) {
        let name = self.unique(wish);
        self.by_name.insert(name.clone(), symbol);
        self.by_symbol.insert(symbol, name);
    }

    /// Gives a symbol the very name that it was declared with.
    pub(crate) fn name_exactly(&mut self, symbol: Symbol, name: &str) {
        self.reserve(name);
        self.by_name.insert(name.to_owned(), symbol);
        self.by_symbol.insert(symbol, name.to_owned());
    }

    /// The symbol with a name.
    pub(crate) fn symbol(&self, name: &str) -> Option<Symbol> {
        self.by_name.get(name).copied()
    }

    /// The name of a symbol that has been named.
    pub(crate) fn of(&self, symbol: Symbol) -> &str {
        self.by_symbol.get(&symbol).map_or("unnamed", String::as_str)
    }
}
