//! Trigonometric polynomials: expressions expanded in chosen variables.
//!
//! In these variables an expression becomes a sum of monomials. A monomial has a coefficient that is free of the
//! variables, powers of variables (or of functions that cannot be expanded), and at most one sine or cosine of an
//! integer combination of variables. Products of sines and cosines become sums of them. So cos² + sin² is 1 here, and a
//! closure has one form however it was typed. Quotients are brought over a common denominator.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::{Graph, Node, NodeKind, Symbol, Variables};
use crate::algebra::Function;
use crate::work;

/// The largest number of monomials of an expansion: no closed form has as many. The largest number in the library is
/// 82.
const LARGEST: usize = 512;
/// The number of multiplications of monomials within which a closed form is searched for. The largest number in the
/// library is 200.
const BUDGET: usize = 2048;
/// The number of multiplications with which an equation is multiplied out in inputs and unknowns: a base, an amount for
/// each node, and an upper bound. Multiplying out only saves operations, so it may stop. The largest number in the
/// library is 1200, for an equation of 48 nodes.
const POSITION_BUDGET: (usize, usize, usize) = (1024, 64, 4096);

/// An integer combination of variables; its first coefficient is positive.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Angle(pub(crate) Vec<(Symbol, i32)>);

impl Angle {
    /// The angle as an expression.
    pub(crate) fn node(&self, graph: &mut Graph) -> Node {
        let terms: Vec<(Node, f64)> = self
            .0
            .iter()
            .map(|&(symbol, multiple)| (graph.symbol(symbol), f64::from(multiple)))
            .collect();
        graph.linear(0.0, &terms)
    }

    /// a + sign · b with a positive first coefficient, and whether this took a change of sign; `None` if the sum is
    /// zero.
    fn combine(&self, other: &Self, sign: i32) -> Option<(Self, bool)> {
        let mut collected: BTreeMap<Symbol, i32> = self.0.iter().copied().collect();
        for &(symbol, multiple) in &other.0 {
            *collected.entry(symbol).or_insert(0) += sign * multiple;
        }
        Self::normal(collected)
    }

    fn normal(mut collected: BTreeMap<Symbol, i32>) -> Option<(Self, bool)> {
        collected.retain(|_, multiple| *multiple != 0);
        let (_, &first) = collected.first_key_value()?;
        let sign = first.signum();
        let combination = collected
            .into_iter()
            .map(|(symbol, multiple)| (symbol, sign * multiple))
            .collect();
        Some((Self(combination), sign < 0))
    }
}

/// The sine or cosine in a monomial.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Harmonic {
    One,
    Cosine(Angle),
    Sine(Angle),
}

impl Harmonic {
    /// The unknowns in the angle.
    fn unknowns(&self) -> impl Iterator<Item = usize> + '_ {
        let angle = match self {
            Self::One => None,
            Self::Cosine(angle) | Self::Sine(angle) => Some(angle),
        };
        let symbols = angle.into_iter().flat_map(|angle| &angle.0);
        symbols.filter_map(|&(symbol, _)| match symbol {
            Symbol::Unknown(unknown) => Some(unknown),
            _ => None,
        })
    }
}

/// A monomial without its coefficient.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Monomial {
    /// Variables, and functions of variables that cannot be expanded, with their powers.
    pub(crate) powers: BTreeMap<Node, i32>,
    pub(crate) harmonic: Harmonic,
}

impl Monomial {
    pub(crate) const fn one() -> Self {
        Self {
            powers: BTreeMap::new(),
            harmonic: Harmonic::One,
        }
    }

    /// The degree in the variables, where those within a sine or cosine count as often as they are in the angle.
    pub(crate) fn degree(&self) -> usize {
        let powers: usize = self.powers.values().map(|power| power.unsigned_abs() as usize).sum();
        let harmonic: usize = match &self.harmonic {
            Harmonic::One => 0,
            Harmonic::Cosine(angle) | Harmonic::Sine(angle) => angle
                .0
                .iter()
                .map(|&(_, multiple)| multiple.unsigned_abs() as usize)
                .sum(),
        };
        powers + harmonic
    }
}

/// Coefficients by monomial. No coefficient is zero.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct TrigonometricPolynomial(pub(crate) BTreeMap<Monomial, Node>);

impl TrigonometricPolynomial {
    fn constant(graph: &Graph, value: Node) -> Self {
        let mut terms = BTreeMap::new();
        if !graph.is_zero(value) {
            terms.insert(Monomial::one(), value);
        }
        Self(terms)
    }

    /// The coefficient of a monomial, zero if the monomial does not occur.
    pub(crate) fn coefficient(&self, graph: &mut Graph, monomial: &Monomial) -> Node {
        self.0.get(monomial).copied().unwrap_or_else(|| graph.zero())
    }

    /// The coefficient of 1.
    pub(crate) fn free_term(&self, graph: &mut Graph) -> Node {
        self.coefficient(graph, &Monomial::one())
    }

    fn is_constant(&self) -> bool {
        self.0.keys().all(|monomial| *monomial == Monomial::one())
    }

    /// Whether each term contains at most one variable, as itself or in the cosine or sine of an angle.
    pub(crate) fn is_linear(&self) -> bool {
        let is_linear =
            |monomial: &Monomial| monomial.degree() <= 1 && monomial.powers.values().all(|&power| power > 0);
        self.0.keys().all(is_linear)
    }

    fn accumulate(&mut self, graph: &mut Graph, monomial: Monomial, coefficient: Node) {
        let before = self.coefficient(graph, &monomial);
        let after = graph.add(before, coefficient);
        if graph.is_zero(after) {
            self.0.remove(&monomial);
        } else {
            self.0.insert(monomial, after);
        }
    }

    /// Adds another polynomial times a factor that is free of the variables.
    pub(crate) fn add(&mut self, graph: &mut Graph, other: &Self, factor: Node) {
        for (monomial, &coefficient) in &other.0 {
            let scaled = graph.multiply(factor, coefficient);
            self.accumulate(graph, monomial.clone(), scaled);
        }
    }

    fn multiply(&self, graph: &mut Graph, other: &Self) -> Self {
        let mut result = Self::default();
        for (left, &left_coefficient) in &self.0 {
            for (right, &right_coefficient) in &other.0 {
                let coefficient = graph.multiply(left_coefficient, right_coefficient);
                let mut powers = left.powers.clone();
                for (&atom, &power) in &right.powers {
                    *powers.entry(atom).or_insert(0) += power;
                }
                for (harmonic, factor) in multiply_harmonics(&left.harmonic, &right.harmonic) {
                    let scaled = graph.scale(factor, coefficient);
                    result.accumulate(
                        graph,
                        Monomial {
                            powers: powers.clone(),
                            harmonic,
                        },
                        scaled,
                    );
                }
            }
        }
        result
    }

    /// The polynomial as an expression.
    pub(crate) fn node(&self, graph: &mut Graph) -> Node {
        let mut terms = Vec::new();
        for (monomial, &coefficient) in &self.0 {
            let mut factors: Vec<(Node, i32)> = monomial.powers.iter().map(|(&atom, &power)| (atom, power)).collect();
            factors.push((coefficient, 1));
            match &monomial.harmonic {
                Harmonic::One => {}
                Harmonic::Cosine(angle) => {
                    let angle = angle.node(graph);
                    factors.push((graph.cosine(angle), 1));
                }
                Harmonic::Sine(angle) => {
                    let angle = angle.node(graph);
                    factors.push((graph.sine(angle), 1));
                }
            }
            terms.push(graph.product(&factors));
        }
        graph.sum(&terms)
    }

    /// Drops the monomials whose coefficients vanish by an identity that the normal form does not recognise.
    ///
    /// The coefficient of a cosine that vanishes is half the difference of two equal coefficients, as in
    /// (a cos x)² + (b sin x)² = (a² + b²)/2 + (a² - b²)/2 cos 2x. Added to their mean or subtracted from it, it leaves
    /// one of them.
    fn cleaned(mut self, graph: &mut Graph) -> Self {
        let mut dropped = Vec::new();
        self.0.retain(|monomial, &mut coefficient| {
            let vanishes = graph.vanishes(coefficient);
            if vanishes && matches!(monomial.harmonic, Harmonic::Cosine(_)) {
                let powers = monomial.powers.clone();
                let harmonic = Harmonic::One;
                dropped.push((Monomial { powers, harmonic }, coefficient));
            }
            !vanishes
        });
        for (monomial, zero) in dropped {
            if let Some(coefficient) = self.0.get_mut(&monomial) {
                let mean = *coefficient;
                let all = [mean, graph.add(mean, zero), graph.subtract(mean, zero)].into_iter();
                *coefficient = all.min_by_key(|&node| size(graph, node)).expect("there are three");
            }
        }
        self
    }
}

/// The number of functions in an expression, and of all its parts.
fn size(graph: &Graph, node: Node) -> (usize, usize) {
    let parts = graph.reachable(&[node]);
    let calls = parts
        .iter()
        .filter(|&&part| matches!(graph.kind(part), NodeKind::Call(..)));
    (calls.count(), parts.len())
}

/// A product of harmonics as a sum of harmonics, each with its factor.
fn multiply_harmonics(left: &Harmonic, right: &Harmonic) -> Vec<(Harmonic, f64)> {
    let cosine = |combination: Option<(Angle, bool)>, factor: f64| match combination {
        None => Some((Harmonic::One, factor)),
        Some((angle, _)) => Some((Harmonic::Cosine(angle), factor)),
    };
    let sine = |combination: Option<(Angle, bool)>, factor: f64| {
        combination.map(|(angle, is_negated)| (Harmonic::Sine(angle), if is_negated { -factor } else { factor }))
    };
    let parts = match (left, right) {
        (Harmonic::One, other) | (other, Harmonic::One) => return vec![(other.clone(), 1.0)],
        (Harmonic::Cosine(a), Harmonic::Cosine(b)) => [cosine(a.combine(b, -1), 0.5), cosine(a.combine(b, 1), 0.5)],
        (Harmonic::Sine(a), Harmonic::Sine(b)) => [cosine(a.combine(b, -1), 0.5), cosine(a.combine(b, 1), -0.5)],
        (Harmonic::Sine(a), Harmonic::Cosine(b)) | (Harmonic::Cosine(b), Harmonic::Sine(a)) => {
            [sine(a.combine(b, 1), 0.5), sine(a.combine(b, -1), 0.5)]
        }
    };
    parts.into_iter().flatten().collect()
}

/// A quotient of two polynomials.
#[derive(Clone)]
pub(super) struct Fraction {
    above: TrigonometricPolynomial,
    below: TrigonometricPolynomial,
}

/// An expansion that has been made, and whether it is complete.
pub(super) struct Expanded {
    fraction: Fraction,
    is_complete: bool,
}

/// The key of an expansion: an expression and the unknowns that are variables, or `None` if all inputs and unknowns are
/// variables.
pub(super) type ExpandedKey = (Node, Option<Vec<usize>>);

impl Fraction {
    /// The number of monomials.
    fn size(&self) -> usize {
        self.above.0.len() + self.below.0.len()
    }
}

/// The expansion of expressions in chosen variables.
///
/// An expression stays unexpanded if it would become too large, like a function that cannot be expanded. This depends
/// on the expression alone.
pub(crate) struct Expansion<'a> {
    graph: &'a mut Graph,
    variables: Variables<'a>,
    known: BTreeMap<Node, Fraction>,
    /// The number of multiplications of monomials that are still allowed.
    budget: usize,
    is_complete: bool,
}

impl<'a> Expansion<'a> {
    pub(crate) fn new(graph: &'a mut Graph, variables: Variables<'a>) -> Self {
        Self {
            graph,
            variables,
            known: BTreeMap::new(),
            budget: 0,
            is_complete: true,
        }
    }

    /// Whether no expression stayed unexpanded because of its size.
    pub(crate) const fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// An equation `node == 0`, multiplied by its denominators.
    pub(crate) fn equation(&mut self, node: Node) -> TrigonometricPolynomial {
        self.expanded(node).above.cleaned(self.graph)
    }

    /// An expression as a polynomial, if no variable stands in a denominator.
    pub(crate) fn polynomial(&mut self, node: Node) -> Option<TrigonometricPolynomial> {
        let fraction = self.expanded(node);
        if !fraction.below.is_constant() {
            return None;
        }
        let below = fraction.below.free_term(self.graph);
        let factor = self.graph.power(below, -1);
        let mut result = TrigonometricPolynomial::default();
        result.add(self.graph, &fraction.above, factor);
        Some(result.cleaned(self.graph))
    }

    /// Whether an expression is free of the variables, but not simple enough to multiply an equation by. An example is
    /// the norm of a vector: the coefficients would carry a high power of it.
    fn is_known_divisor(&self, node: Node) -> bool {
        matches!(self.graph.kind(node), NodeKind::Sum(..) | NodeKind::Call(..)) && !self.varies(node)
    }

    fn varies(&self, node: Node) -> bool {
        self.graph.varies(node, self.variables)
    }

    fn whole(&mut self, above: TrigonometricPolynomial) -> Fraction {
        let one = self.graph.one();
        Fraction {
            above,
            below: TrigonometricPolynomial::constant(self.graph, one),
        }
    }

    fn atom(&mut self, node: Node) -> Fraction {
        let one = self.graph.one();
        let monomial = Monomial {
            powers: BTreeMap::from([(node, 1)]),
            harmonic: Harmonic::One,
        };
        self.whole(TrigonometricPolynomial(BTreeMap::from([(monomial, one)])))
    }

    fn multiplied(&mut self, left: &Fraction, right: &Fraction) -> Fraction {
        Fraction {
            above: left.above.multiply(self.graph, &right.above),
            below: left.below.multiply(self.graph, &right.below),
        }
    }

    /// The expansion of a whole expression, made once for each choice of variables.
    fn expanded(&mut self, node: Node) -> Fraction {
        let variables = self.variables;
        let is_variable = |unknown: &usize| variables.include(Symbol::Unknown(*unknown));
        let unknowns: Option<Vec<usize>> = match variables {
            Variables::Position => None,
            Variables::Unknowns(_) | Variables::AllUnknowns => {
                Some(self.graph.unknowns(node).filter(is_variable).collect())
            }
        };
        let key = (node, unknowns);
        if let Some(known) = self.graph.expanded.get(&key) {
            self.is_complete &= known.is_complete;
            return known.fraction.clone();
        }
        self.budget = match variables {
            Variables::Position => {
                let (least, for_each_node, most) = POSITION_BUDGET;
                most.min(least + for_each_node * self.graph.reachable(&[node]).len())
            }
            Variables::Unknowns(_) | Variables::AllUnknowns => BUDGET,
        };
        let before = std::mem::replace(&mut self.is_complete, true);
        let fraction = self.fraction(node);
        let known = Expanded {
            fraction: fraction.clone(),
            is_complete: self.is_complete,
        };
        self.is_complete &= before;
        self.graph.expanded.insert(key, Arc::new(known));
        fraction
    }

    /// Takes multiplications from the budget if it allows them, and that of the whole compilation too.
    fn afford(&mut self, multiplications: usize) -> bool {
        let rest = self.budget.checked_sub(multiplications).filter(|_| !work::is_spent());
        self.budget = rest.unwrap_or(self.budget);
        rest.is_some()
    }

    /// An expression that is too large, left unexpanded.
    fn given_up(&mut self, node: Node) -> Fraction {
        self.is_complete = false;
        self.atom(node)
    }

    fn fraction(&mut self, node: Node) -> Fraction {
        if let Some(fraction) = self.known.get(&node) {
            return fraction.clone();
        }
        let fraction = self.expand(node);
        self.known.insert(node, fraction.clone());
        fraction
    }

    fn expand(&mut self, node: Node) -> Fraction {
        if !self.varies(node) {
            let above = TrigonometricPolynomial::constant(self.graph, node);
            return self.whole(above);
        }
        match self.graph.kind(node).clone() {
            NodeKind::Number(_) | NodeKind::Pi | NodeKind::Symbol(_) => self.atom(node),
            NodeKind::Sum(constant, terms) => {
                let constant = self.graph.number(constant.get());
                let above = TrigonometricPolynomial::constant(self.graph, constant);
                let mut sum = self.whole(above);
                for (part, coefficient) in terms {
                    let part = self.fraction(part);
                    let factor = self.graph.number(coefficient.get());
                    let multiplications = if sum.below == part.below {
                        part.above.0.len()
                    } else {
                        sum.size() * part.size()
                    };
                    if !self.afford(multiplications) || sum.size() > LARGEST {
                        return self.given_up(node);
                    }
                    if sum.below == part.below {
                        sum.above.add(self.graph, &part.above, factor);
                    } else {
                        let mut above = sum.above.multiply(self.graph, &part.below);
                        let other = part.above.multiply(self.graph, &sum.below);
                        above.add(self.graph, &other, factor);
                        let below = sum.below.multiply(self.graph, &part.below);
                        sum = Fraction { above, below };
                    }
                }
                sum
            }
            NodeKind::Product(factors) => {
                let one = self.graph.one();
                let above = TrigonometricPolynomial::constant(self.graph, one);
                let mut product = self.whole(above);
                for (part, exponent) in factors {
                    if exponent < 0 && self.is_known_divisor(part) {
                        let divisor = self.graph.power(part, exponent);
                        let divisor = TrigonometricPolynomial::constant(self.graph, divisor);
                        product.above = product.above.multiply(self.graph, &divisor);
                        continue;
                    }
                    let mut base = self.fraction(part);
                    if exponent < 0 {
                        base = Fraction {
                            above: base.below,
                            below: base.above,
                        };
                    }
                    for _ in 0..exponent.abs() {
                        if !self.afford(product.size() * base.size()) || product.size() > LARGEST {
                            return self.given_up(node);
                        }
                        product = self.multiplied(&product, &base);
                    }
                }
                product
            }
            NodeKind::Call(function @ (Function::Sin | Function::Cos), arguments) => {
                self.expand_circular(function, node, arguments[0])
            }
            NodeKind::Call(..) => self.atom(node),
        }
    }

    /// Expands sin or cos of a sum: an integer combination of variables plus a rest that is free of them.
    fn expand_circular(&mut self, function: Function, node: Node, angle: Node) -> Fraction {
        let Some((combination, rest)) = self.split_angle(angle) else {
            return self.atom(node);
        };
        let Some((combination, is_negated)) = Angle::normal(combination) else {
            return self.atom(node);
        };
        let (cosine_rest, sine_rest) = (self.graph.cosine(rest), self.graph.sine(rest));
        let sign = if is_negated { -1.0 } else { 1.0 };
        // sin(p + r) = sin p cos r + cos p sin r, cos(p + r) = cos p cos r - sin p sin r, with p = ± combination
        let (by_cosine, by_sine) = match function {
            Function::Sin => (sine_rest, self.graph.scale(sign, cosine_rest)),
            _ => (cosine_rest, self.graph.scale(-sign, sine_rest)),
        };
        let mut above = TrigonometricPolynomial::default();
        let monomial = |harmonic| Monomial {
            powers: BTreeMap::new(),
            harmonic,
        };
        above.accumulate(self.graph, monomial(Harmonic::Cosine(combination.clone())), by_cosine);
        above.accumulate(self.graph, monomial(Harmonic::Sine(combination)), by_sine);
        self.whole(above)
    }

    /// Splits an angle into an integer combination of variables and a rest that is free of them.
    fn split_angle(&mut self, angle: Node) -> Option<(BTreeMap<Symbol, i32>, Node)> {
        let (constant, terms): (f64, Vec<(Node, f64)>) = match self.graph.kind(angle) {
            NodeKind::Sum(constant, terms) => {
                let terms = terms.iter().map(|&(part, coefficient)| (part, coefficient.get()));
                (constant.get(), terms.collect())
            }
            _ => (0.0, vec![(angle, 1.0)]),
        };
        let mut combination = BTreeMap::new();
        let mut rest = Vec::new();
        for (part, coefficient) in terms {
            if !self.varies(part) {
                rest.push((part, coefficient));
                continue;
            }
            let symbol = self.graph.as_symbol(part)?;
            if coefficient.fract() != 0.0 || coefficient.abs() > 1e6 {
                return None;
            }
            #[expect(clippy::cast_possible_truncation, reason = "it is an integer below a million")]
            combination.insert(symbol, coefficient as i32);
        }
        Some((combination, self.graph.linear(constant, &rest)))
    }
}

impl TrigonometricPolynomial {
    /// The unknowns among the variables that occur.
    pub(crate) fn unknowns(&self, graph: &Graph, variables: Variables<'_>) -> BTreeSet<usize> {
        let mut found = BTreeSet::new();
        for monomial in self.0.keys() {
            for &atom in monomial.powers.keys() {
                found.extend(graph.unknowns(atom));
            }
            found.extend(monomial.harmonic.unknowns());
        }
        found.retain(|&unknown| variables.include(Symbol::Unknown(unknown)));
        found
    }

    /// Whether an unknown occurs.
    pub(crate) fn contains(&self, graph: &Graph, unknown: usize) -> bool {
        self.0.keys().any(|monomial| {
            let mut atoms = monomial.powers.keys();
            atoms.any(|&atom| graph.contains(atom, Symbol::Unknown(unknown)))
                || monomial.harmonic.unknowns().any(|other| other == unknown)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// cos² + sin² is 1, and a product of two cosines is a sum of two.
    #[test]
    fn products_become_sums() {
        let mut graph = Graph::new();
        let x = graph.symbol(Symbol::Unknown(0));
        let (cosine, sine) = (graph.cosine(x), graph.sine(x));
        let (c2, s2) = (graph.power(cosine, 2), graph.power(sine, 2));
        let sum = graph.add(c2, s2);
        let polynomial = Expansion::new(&mut graph, Variables::AllUnknowns).equation(sum);
        assert!(polynomial.is_constant());
        let value = polynomial.free_term(&mut graph);
        assert!(graph.is_one(value));
    }

    /// Of two coefficients that are equal by an identity, here (u² + v²)² = (u² - v²)² + (2 u v)², the shorter one is
    /// left.
    #[test]
    fn of_equal_coefficients_one_is_left() {
        let mut graph = Graph::new();
        let x = graph.symbol(Symbol::Unknown(0));
        let [u, v] = [0, 1].map(|index| graph.symbol(Symbol::Parameter(index)));
        let [u2, v2] = [u, v].map(|part| graph.power(part, 2));
        let (sum, difference, product) = (graph.add(u2, v2), graph.subtract(u2, v2), graph.multiply(u2, v2));
        let [short, square] = [sum, difference].map(|part| graph.power(part, 2));
        let long = graph.linear(0.0, &[(square, 1.0), (product, 4.0)]);
        let (cosine, sine) = (graph.cosine(x), graph.sine(x));
        for (of_cosine, of_sine) in [(short, long), (long, short)] {
            let terms =
                [(of_cosine, cosine), (of_sine, sine)].map(|(factor, unit)| graph.product(&[(factor, 1), (unit, 2)]));
            let whole = graph.sum(&terms);
            let polynomial = Expansion::new(&mut graph, Variables::AllUnknowns).equation(whole);
            assert!(polynomial.is_constant());
            assert_eq!(polynomial.free_term(&mut graph), short);
        }
    }

    /// Whether a sum of this number of unknowns, raised to this power, is multiplied out.
    fn is_multiplied_out(unknowns: usize, power: i32) -> bool {
        let mut graph = Graph::new();
        let terms: Vec<Node> = (0..unknowns)
            .map(|unknown| graph.symbol(Symbol::Unknown(unknown)))
            .collect();
        let sum = graph.sum(&terms);
        let whole = graph.power(sum, power);
        let mut expansion = Expansion::new(&mut graph, Variables::AllUnknowns);
        let polynomial = expansion.equation(whole);
        let is_complete = expansion.is_complete();
        // x² and x y for all unknowns
        let count = if power == 1 {
            unknowns
        } else {
            unknowns * (unknowns + 1) / 2
        };
        assert_eq!(polynomial.0.len(), if is_complete { count } else { 1 });
        is_complete
    }

    /// An expression is left unexpanded if it has too many monomials or takes too many multiplications.
    #[test]
    fn what_is_too_large_is_left_as_it_is() {
        assert!(is_multiplied_out(LARGEST, 1));
        assert!(!is_multiplied_out(LARGEST + 1, 1));
        // squaring a sum takes as many multiplications as the square of its length
        assert!(is_multiplied_out(30, 2));
        assert!(!is_multiplied_out(BUDGET.isqrt() + 1, 2));
    }

    /// Expansions of products of sines and cosines keep their values, for any multiples of angles.
    #[test]
    fn expansions_have_the_value_of_what_they_expand() {
        let mut graph = Graph::new();
        let [x, y] = [0, 1].map(|unknown| graph.symbol(Symbol::Unknown(unknown)));
        let angles: Vec<Node> = [(1.0, 0.0), (2.0, 0.0), (0.0, 3.0), (1.0, -2.0), (-3.0, 1.0)]
            .map(|(p, q)| graph.linear(0.0, &[(x, p), (y, q)]))
            .to_vec();
        let circular: Vec<Node> = angles
            .into_iter()
            .flat_map(|angle| [graph.cosine(angle), graph.sine(angle)])
            .collect();
        let value = |symbol: Symbol| if symbol == Symbol::Unknown(0) { 0.7 } else { -1.9 };
        for &one in &circular {
            for &other in &circular {
                let product = graph.product(&[(one, 1), (other, 2)]);
                let polynomial = Expansion::new(&mut graph, Variables::AllUnknowns).equation(product);
                assert!(polynomial.0.keys().all(|monomial| monomial.powers.is_empty()));
                let expanded = polynomial.node(&mut graph);
                let (found, expected) = (graph.evaluate(expanded, &value), graph.evaluate(product, &value));
                // the value has a few terms below one
                assert!(
                    (found - expected).abs() < 16.0 * f64::EPSILON,
                    "{found} and not {expected}"
                );
            }
        }
    }

    /// Quotients are brought over a common denominator as long as this takes few multiplications: two for each monomial
    /// gathered so far.
    #[test]
    fn few_quotients_are_brought_together() {
        for (count, is_small) in [(40, true), (50, false)] {
            let mut graph = Graph::new();
            let quotients: Vec<Node> = (0..count)
                .map(|unknown| {
                    let below = graph.symbol(Symbol::Unknown(unknown));
                    graph.power(below, -1)
                })
                .collect();
            let sum = graph.sum(&quotients);
            let mut expansion = Expansion::new(&mut graph, Variables::AllUnknowns);
            let above = expansion.equation(sum);
            assert_eq!(expansion.is_complete(), is_small, "{count}");
            assert_eq!(above.0.len(), if is_small { count } else { 1 });
        }
    }
}
