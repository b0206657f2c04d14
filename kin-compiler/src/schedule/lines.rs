//! Expressions as numbered lines: sums and products of any number of terms. Equal lines have one number.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use super::style::Style;
use crate::algebra::{FiniteNumber, Function, Graph, HashMap, Index, IndexTable, Node, NodeKind, Symbol};
use crate::passes::Pass;
use crate::work;

/// The largest number of terms of a line. Longer sums and products become sums and products of shorter ones. The search
/// for repeated pairs in a line takes the square of its length.
const WIDEST: usize = 64;

/// The index of a line.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct LineId(pub(super) usize);

impl Index for LineId {
    fn index(self) -> usize {
        self.0
    }
}

#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) enum Line {
    Number(FiniteNumber),
    Pi,
    Leaf(Symbol),
    /// Σ ± term; true means minus.
    Sum(Vec<(bool, LineId)>),
    /// Π factor, ascending, with repetitions for powers.
    Product(Vec<LineId>),
    Quotient(LineId, LineId),
    Call(Function, Vec<LineId>),
}

/// All lines of a program.
pub(super) struct Lines {
    pub(super) list: Vec<Line>,
    known: HashMap<Line, LineId>,
    by_node: IndexTable<Node, LineId>,
    /// The divisors of more than one product. Their reciprocals are computed once.
    shared_divisors: BTreeSet<Node>,
    shared_reciprocals: BTreeSet<LineId>,
    pub(super) style: Style,
}

impl Lines {
    /// An empty list. Divisors that occur more than once among the given expressions will be inverted once.
    pub(super) fn new(graph: &Graph, reachable: &[Node], style: Style) -> Self {
        let mut divisions: BTreeMap<Node, usize> = BTreeMap::new();
        for &node in reachable {
            if let NodeKind::Product(factors) = graph.kind(node) {
                for &(base, _) in factors.iter().filter(|&&(_, exponent)| exponent < 0) {
                    *divisions.entry(base).or_insert(0) += 1;
                }
            }
        }
        let shared_divisors = divisions
            .into_iter()
            .filter(|&(_, count)| count > 1 && style.passes.include(Pass::SharedReciprocals))
            .map(|(base, _)| base)
            .collect();
        Self {
            list: Vec::new(),
            known: HashMap::default(),
            by_node: IndexTable::default(),
            shared_divisors,
            shared_reciprocals: BTreeSet::new(),
            style,
        }
    }

    /// Adds the lines of expressions, each after its parts.
    pub(super) fn extend(&mut self, graph: &Graph, reachable: &[Node]) {
        for &node in reachable {
            if self.by_node.get(node).is_none() {
                let line = self.lower(graph, node);
                self.by_node.insert(node, line);
            }
        }
    }

    pub(super) fn line(&self, id: LineId) -> &Line {
        &self.list[id.0]
    }

    /// The line of an expression that is a root or a part of one.
    pub(super) fn of_node(&self, node: Node) -> LineId {
        self.by_node.get(node).expect("its line is written")
    }

    pub(super) fn intern(&mut self, line: Line) -> LineId {
        if let Some(&id) = self.known.get(&line) {
            return id;
        }
        let id = LineId(self.list.len());
        self.list.push(line.clone());
        self.known.insert(line, id);
        id
    }

    fn number(&mut self, value: f64) -> LineId {
        self.intern(Line::Number(FiniteNumber::new(value)))
    }

    fn product(&mut self, mut factors: Vec<LineId>) -> LineId {
        match factors.len() {
            0 => self.number(1.0),
            1 => factors[0],
            _ => {
                factors.sort_unstable();
                while factors.len() > WIDEST {
                    factors = factors
                        .chunks(WIDEST)
                        .map(|part| match part {
                            &[only] => only,
                            part => self.intern(Line::Product(part.to_vec())),
                        })
                        .collect();
                }
                self.intern(Line::Product(factors))
            }
        }
    }

    fn sum(&mut self, mut terms: Vec<(bool, LineId)>) -> LineId {
        while terms.len() > WIDEST {
            terms = terms
                .chunks(WIDEST)
                .map(|part| match part {
                    &[only] => only,
                    part => (false, self.intern(Line::Sum(part.to_vec()))),
                })
                .collect();
        }
        match terms[..] {
            [(false, only)] => only,
            _ => self.intern(Line::Sum(terms)),
        }
    }

    fn lower(&mut self, graph: &Graph, node: Node) -> LineId {
        work::iteration();
        match graph.kind(node) {
            NodeKind::Number(value) => self.intern(Line::Number(*value)),
            NodeKind::Pi => self.intern(Line::Pi),
            NodeKind::Symbol(symbol) => self.intern(Line::Leaf(*symbol)),
            NodeKind::Call(function, arguments) => {
                let arguments = arguments.iter().map(|argument| self.of_node(*argument)).collect();
                self.intern(Line::Call(*function, arguments))
            }
            NodeKind::Product(factors) => {
                let (mut above, mut still, mut below) = (Vec::new(), Vec::new(), Vec::new());
                for &(base, exponent) in factors {
                    let line = self.of_node(base);
                    let (list, factor) = if exponent > 0 {
                        (&mut above, line)
                    } else if self.shared_divisors.contains(&base) {
                        let one = self.number(1.0);
                        let reciprocal = self.intern(Line::Quotient(one, line));
                        self.shared_reciprocals.insert(reciprocal);
                        (&mut above, reciprocal)
                    } else {
                        (&mut below, line)
                    };
                    // keep together what is computed once for all orders, even if some terms share a factor of it
                    let is_above = exponent > 0 || factor != line;
                    let is_still = is_above && self.is_still(graph, base);
                    let list = if is_still { &mut still } else { list };
                    list.extend((0..exponent.abs()).map(|_| factor));
                }
                if !still.is_empty() {
                    above.push(self.product(still));
                }
                let above = self.product(above);
                if below.is_empty() {
                    return above;
                }
                let below = self.product(below);
                self.intern(Line::Quotient(above, below))
            }
            NodeKind::Sum(constant, terms) => {
                // terms with the same number in front share one multiplication
                let mut groups: Vec<(f64, Vec<(bool, LineId)>)> = Vec::new();
                for &(part, coefficient) in terms {
                    let (value, line) = (coefficient.get(), self.of_node(part));
                    let size = value.abs();
                    let shares = size == 1.0 || self.style.passes.include(Pass::SharedNumbers);
                    match groups.iter_mut().find(|(known, _)| shares && *known == size) {
                        Some((_, group)) => group.push((value < 0.0, line)),
                        None => groups.push((size, vec![(value < 0.0, line)])),
                    }
                }
                let mut result = Vec::new();
                if constant.get() != 0.0 {
                    result.push((constant.get() < 0.0, self.number(constant.get().abs())));
                }
                for (size, mut group) in groups {
                    if size == 1.0 {
                        result.extend(group);
                        continue;
                    }
                    let is_negative = group.iter().all(|&(negative, _)| negative);
                    if is_negative {
                        for (negative, _) in &mut group {
                            *negative = false;
                        }
                    }
                    let inner = self.factored_sum(group);
                    let number = self.number(size);
                    // a number times a reciprocal is one division
                    let multiple = match *self.line(inner) {
                        Line::Quotient(above, below)
                            if *self.line(above) == Line::Number(FiniteNumber::new(1.0))
                                && !self.shared_reciprocals.contains(&inner) =>
                        {
                            self.intern(Line::Quotient(number, below))
                        }
                        _ => self.product(vec![number, inner]),
                    };
                    result.push((is_negative, multiple));
                }
                self.factored_sum(result)
            }
        }
    }

    /// Whether a factor is first multiplied by others that depend on the position alone, and then by a rate.
    fn is_still(&self, graph: &Graph, factor: Node) -> bool {
        self.style.takes_out_factors && graph.depends_on_position_alone(factor)
    }

    /// A sum whose shared factors are taken out, if the style asks for it: first the most frequent one, then the most
    /// frequent one of the new sum, and so on.
    fn factored_sum(&mut self, terms: Vec<(bool, LineId)>) -> LineId {
        if !self.style.takes_out_factors || terms.len() < 2 {
            return self.sum(terms);
        }
        let mut sum = FactoredSum::default();
        for (negative, term) in terms {
            sum.push_back(self, negative, term);
        }
        while let Some(factor) = sum.most_frequent() {
            let mut inside = Vec::new();
            for (negative, term) in sum.take(self, factor) {
                let mut factors = self.factors_of(term);
                let position = factors.iter().position(|&known| known == factor);
                factors.remove(position.expect("these are the terms with the factor"));
                inside.push((negative, self.product(factors)));
            }
            let is_negative = inside.iter().all(|&(negative, _)| negative);
            if is_negative {
                for (negative, _) in &mut inside {
                    *negative = false;
                }
            }
            let inner = self.factored_sum(inside);
            let mut factors = self.factors_of(inner);
            factors.push(factor);
            let whole = self.product(factors);
            sum.push_front(self, is_negative, whole);
        }
        self.sum(sum.terms.into_values().collect())
    }

    fn factors_of(&self, id: LineId) -> Vec<LineId> {
        match self.line(id) {
            Line::Product(factors) => factors.clone(),
            _ => vec![id],
        }
    }
}

/// The terms of a sum whose factors are taken out, and the terms in which each factor occurs.
#[derive(Default)]
struct FactoredSum {
    /// The terms by position. A new term is placed before all others.
    terms: BTreeMap<isize, (bool, LineId)>,
    positions: BTreeMap<LineId, BTreeSet<isize>>,
    /// The factors of several terms, by the number of these terms.
    shared: BTreeSet<(usize, Reverse<LineId>)>,
}

impl FactoredSum {
    fn push_back(&mut self, lines: &Lines, negative: bool, term: LineId) {
        let position = self.terms.last_key_value().map_or(0, |(&position, _)| position + 1);
        self.insert(lines, position, negative, term);
    }

    fn push_front(&mut self, lines: &Lines, negative: bool, term: LineId) {
        let position = self.terms.first_key_value().map_or(0, |(&position, _)| position - 1);
        self.insert(lines, position, negative, term);
    }

    fn insert(&mut self, lines: &Lines, position: isize, negative: bool, term: LineId) {
        self.terms.insert(position, (negative, term));
        for factor in lines.factors_of(term).into_iter().collect::<BTreeSet<_>>() {
            work::iteration();
            if !matches!(lines.line(factor), Line::Number(_)) {
                self.change(factor, |positions| {
                    positions.insert(position);
                });
            }
        }
    }

    fn change(&mut self, factor: LineId, change: impl FnOnce(&mut BTreeSet<isize>)) {
        let positions = self.positions.entry(factor).or_default();
        self.shared.remove(&(positions.len(), Reverse(factor)));
        change(positions);
        if positions.len() > 1 {
            self.shared.insert((positions.len(), Reverse(factor)));
        }
    }

    /// The factor of the most terms, the first one if several are equal.
    fn most_frequent(&self) -> Option<LineId> {
        self.shared.last().map(|&(_, Reverse(factor))| factor)
    }

    /// Removes the terms that contain a factor.
    fn take(&mut self, lines: &Lines, factor: LineId) -> Vec<(bool, LineId)> {
        let positions = self.positions.get(&factor).cloned().unwrap_or_default();
        let mut taken = Vec::new();
        for position in positions {
            let Some((negative, term)) = self.terms.remove(&position) else {
                continue;
            };
            for factor_of_term in lines.factors_of(term).into_iter().collect::<BTreeSet<_>>() {
                if self.positions.contains_key(&factor_of_term) {
                    self.change(factor_of_term, |positions| {
                        positions.remove(&position);
                    });
                }
            }
            taken.push((negative, term));
        }
        taken
    }
}
