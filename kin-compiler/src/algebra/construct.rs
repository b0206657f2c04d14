//! The constructors. Each brings its result into normal form.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

use super::graph::FiniteNumber;
use super::{Graph, Misfit, Node, NodeKind, Symbol};
use crate::algebra::{Calculation, Function};

/// The largest number of terms of a sum that is merged into other sums. A longer sum is one term of them: merging a
/// chain of long sums would take the square of its length. The largest number in the library is 123.
const LONGEST_SUM: usize = 32;
/// The largest number of factors of a product that is merged into other products. A longer product is one factor of
/// them. The largest number in the library is 10.
const LONGEST_PRODUCT: usize = 12;

/// The product of two constants. Sets `misfit` if an `f64` does not hold it.
fn times(a: f64, b: f64, misfit: &mut Option<Misfit>) -> f64 {
    let product = a * b;
    *misfit = misfit.or(Misfit::of(product, a == 0.0 || b == 0.0));
    product
}

impl Graph {
    pub(crate) fn number(&mut self, value: f64) -> Node {
        self.intern(NodeKind::Number(FiniteNumber::new(value)))
    }

    pub(crate) fn zero(&mut self) -> Node {
        self.number(0.0)
    }

    pub(crate) fn one(&mut self) -> Node {
        self.number(1.0)
    }

    pub(crate) fn pi(&mut self) -> Node {
        self.intern(NodeKind::Pi)
    }

    pub(crate) fn symbol(&mut self, symbol: Symbol) -> Node {
        self.intern(NodeKind::Symbol(symbol))
    }

    pub(crate) fn add(&mut self, a: Node, b: Node) -> Node {
        self.linear(0.0, &[(a, 1.0), (b, 1.0)])
    }

    pub(crate) fn subtract(&mut self, a: Node, b: Node) -> Node {
        self.linear(0.0, &[(a, 1.0), (b, -1.0)])
    }

    pub(crate) fn negate(&mut self, a: Node) -> Node {
        self.scale(-1.0, a)
    }

    pub(crate) fn scale(&mut self, factor: f64, a: Node) -> Node {
        self.linear(0.0, &[(a, factor)])
    }

    pub(crate) fn sum(&mut self, terms: &[Node]) -> Node {
        let terms: Vec<(Node, f64)> = terms.iter().map(|&term| (term, 1.0)).collect();
        self.linear(0.0, &terms)
    }

    /// constant + Σ coefficient · node, with like terms collected.
    pub(crate) fn linear(&mut self, constant: f64, terms: &[(Node, f64)]) -> Node {
        let mut constant = constant;
        let mut collected: BTreeMap<Node, f64> = BTreeMap::new();
        let mut misfit = None;
        for &(node, coefficient) in terms {
            let mut times = |factor: FiniteNumber| times(coefficient, factor.get(), &mut misfit);
            match self.kind(node) {
                NodeKind::Number(value) if !self.keeps_numbers => constant += times(*value),
                NodeKind::Sum(inner, inner_terms) if inner_terms.len() <= LONGEST_SUM => {
                    constant += times(*inner);
                    for &(part, factor) in inner_terms {
                        *collected.entry(part).or_insert(0.0) += times(factor);
                    }
                }
                _ => *collected.entry(node).or_insert(0.0) += coefficient,
            }
        }
        for &number in collected.values().chain([&constant]) {
            misfit = misfit.or(Misfit::of(number, true));
        }
        self.note(misfit);
        collected.retain(|_, coefficient| *coefficient != 0.0);
        if collected.is_empty() {
            return self.number(constant);
        }
        if constant == 0.0
            && collected.len() == 1
            && let Some((&node, &1.0)) = collected.first_key_value()
        {
            return node;
        }
        let terms = collected
            .into_iter()
            .map(|(node, coefficient)| (node, FiniteNumber::new(coefficient)))
            .collect();
        self.intern(NodeKind::Sum(FiniteNumber::new(constant), terms))
    }

    pub(crate) fn multiply(&mut self, a: Node, b: Node) -> Node {
        self.product(&[(a, 1), (b, 1)])
    }

    pub(crate) fn divide(&mut self, a: Node, b: Node) -> Node {
        self.product(&[(a, 1), (b, -1)])
    }

    pub(crate) fn power(&mut self, a: Node, exponent: i32) -> Node {
        self.product(&[(a, exponent)])
    }

    /// Π node^exponent, with like factors collected and numbers moved to the front.
    pub(crate) fn product(&mut self, factors: &[(Node, i32)]) -> Node {
        let mut coefficient = 1.0;
        let mut collected: BTreeMap<Node, i32> = BTreeMap::new();
        for &(node, exponent) in factors {
            self.collect_factor(node, exponent, &mut coefficient, &mut collected);
        }
        if coefficient == 0.0 {
            return self.zero();
        }
        // √x · √x is x, which may itself be a product with factors to collect
        let root = collected.iter().find_map(|(&node, &exponent)| match self.kind(node) {
            NodeKind::Call(Function::Sqrt, arguments) if exponent.abs() >= 2 => Some((node, arguments[0], exponent)),
            _ => None,
        });
        if let Some((node, radicand, exponent)) = root {
            let mut rest: Vec<(Node, i32)> = collected.into_iter().filter(|&(factor, _)| factor != node).collect();
            rest.push((radicand, exponent / 2));
            rest.push((node, exponent % 2));
            let simplified = self.product(&rest);
            return self.scale(coefficient, simplified);
        }
        collected.retain(|_, exponent| *exponent != 0);
        let bare = match collected.len() {
            0 => return self.number(coefficient),
            1 if collected.first_key_value().is_some_and(|(_, &exponent)| exponent == 1) => {
                *collected.first_key_value().expect("one factor").0
            }
            _ => self.intern(NodeKind::Product(collected.into_iter().collect())),
        };
        self.scale(coefficient, bare)
    }

    fn collect_factor(
        &mut self,
        node: Node,
        exponent: i32,
        coefficient: &mut f64,
        collected: &mut BTreeMap<Node, i32>,
    ) {
        if exponent == 0 {
            return;
        }
        if self.keeps_numbers && matches!(self.kind(node), NodeKind::Number(_)) {
            *collected.entry(node).or_insert(0) += exponent;
            return;
        }
        let (factor, mut bare) = self.split_coefficient(node);
        let power = factor.powi(exponent);
        let mut misfit = Misfit::of(power, factor == 0.0);
        *coefficient = times(*coefficient, power, &mut misfit);
        self.note(misfit);
        // a - b and b - a become one factor and a sign
        if matches!(self.kind(bare), NodeKind::Sum(..)) && self.leads_negative(bare) {
            bare = self.negate(bare);
            *coefficient *= (-1.0_f64).powi(exponent);
        }
        match self.kind(bare) {
            NodeKind::Number(_) => {}
            NodeKind::Product(parts) if parts.len() <= LONGEST_PRODUCT => {
                for &(part, inner) in parts {
                    *collected.entry(part).or_insert(0) += inner * exponent;
                }
            }
            _ => *collected.entry(bare).or_insert(0) += exponent,
        }
    }

    /// A function of its arguments.
    pub(crate) fn call(&mut self, function: Function, arguments: &[Node]) -> Node {
        match function.calculation() {
            Calculation::Sine => self.sine(arguments[0]),
            Calculation::Cosine => self.cosine(arguments[0]),
            Calculation::Tangent => {
                let sine = self.sine(arguments[0]);
                let cosine = self.cosine(arguments[0]);
                self.divide(sine, cosine)
            }
            Calculation::Method => self.plain_call(function, arguments),
        }
    }

    pub(crate) fn sine(&mut self, angle: Node) -> Node {
        let (quarters, rest) = self.split_right_angles(angle);
        let value = match quarters {
            0 | 2 => self.odd_call(Function::Sin, rest),
            _ => self.even_call(Function::Cos, rest),
        };
        if quarters >= 2 { self.negate(value) } else { value }
    }

    pub(crate) fn cosine(&mut self, angle: Node) -> Node {
        let (quarters, rest) = self.split_right_angles(angle);
        let value = match quarters {
            0 | 2 => self.even_call(Function::Cos, rest),
            _ => self.odd_call(Function::Sin, rest),
        };
        if quarters == 1 || quarters == 2 {
            self.negate(value)
        } else {
            value
        }
    }

    /// Splits an angle into right angles, modulo four, and a remainder.
    fn split_right_angles(&mut self, angle: Node) -> (u8, Node) {
        let pi = self.pi();
        let half_revolutions = match self.kind(angle) {
            NodeKind::Pi => 1.0,
            NodeKind::Sum(_, terms) => terms
                .iter()
                .find(|&&(node, _)| node == pi)
                .map_or(0.0, |&(_, coefficient)| coefficient.get()),
            _ => 0.0,
        };
        let quarters = (2.0 * half_revolutions).round();
        if quarters == 0.0 || (2.0 * half_revolutions - quarters).abs() > 1e-12 {
            return (0, angle);
        }
        let rest = self.linear(0.0, &[(angle, 1.0), (pi, -quarters / 2.0)]);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it lies in 0..4")]
        let quarters = quarters.rem_euclid(4.0) as u8;
        (quarters, rest)
    }

    /// Calls an even function: f(-x) = f(x), so the sign of the angle's leading term is dropped.
    fn even_call(&mut self, function: Function, angle: Node) -> Node {
        let angle = if self.leads_negative(angle) {
            self.negate(angle)
        } else {
            angle
        };
        self.plain_call(function, &[angle])
    }

    /// Calls an odd function: f(-x) = -f(x), so the sign of the angle's leading term is moved outside.
    fn odd_call(&mut self, function: Function, angle: Node) -> Node {
        if self.leads_negative(angle) {
            let opposite = self.negate(angle);
            let value = self.plain_call(function, &[opposite]);
            self.negate(value)
        } else {
            self.plain_call(function, &[angle])
        }
    }

    fn leads_negative(&self, node: Node) -> bool {
        match self.kind(node) {
            NodeKind::Number(value) => value.get() < 0.0,
            NodeKind::Sum(_, terms) => terms.first().is_some_and(|&(_, coefficient)| coefficient.get() < 0.0),
            _ => false,
        }
    }

    fn plain_call(&mut self, function: Function, arguments: &[Node]) -> Node {
        let values: Option<Vec<f64>> = arguments
            .iter()
            .map(|&argument| self.constant_value(argument))
            .collect();
        if let Some(values) = values
            && function.contains(&values)
        {
            let value = function.value(&values);
            self.note(Misfit::of(value, function.has_zeros()));
            return if value == FRAC_PI_2 || value == -FRAC_PI_2 {
                // asin(1) and similar values are multiples of a right angle: keep them exact
                let pi = self.pi();
                self.scale(value.signum() / 2.0, pi)
            } else {
                self.number(value)
            };
        }
        self.intern(NodeKind::Call(function, arguments.to_vec()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parameter(graph: &mut Graph, index: usize) -> Node {
        graph.symbol(Symbol::Parameter(index))
    }

    #[test]
    fn sums_collect_like_terms_in_any_order() {
        let mut graph = Graph::new();
        let (a, b) = (parameter(&mut graph, 0), parameter(&mut graph, 1));
        let left = graph.linear(1.0, &[(a, 2.0), (b, -1.0), (a, 1.0)]);
        let sum = graph.add(b, b);
        let three = graph.scale(3.0, a);
        let right = graph.linear(1.0, &[(b, 1.0), (sum, -1.0), (three, 1.0)]);
        assert_eq!(left, right);
        let nothing = graph.subtract(left, right);
        assert!(graph.is_zero(nothing));
    }

    #[test]
    fn products_collect_like_factors() {
        let mut graph = Graph::new();
        let (a, b) = (parameter(&mut graph, 0), parameter(&mut graph, 1));
        let quotient = graph.divide(a, b);
        assert_eq!(graph.multiply(quotient, b), a);
        let root = graph.call(Function::Sqrt, &[a]);
        assert_eq!(graph.multiply(root, root), a);
    }

    #[test]
    fn quarter_turns_and_signs_are_taken_out() {
        let mut graph = Graph::new();
        let (a, pi) = (parameter(&mut graph, 0), graph.pi());
        let sine = graph.sine(a);
        for (quarters, expected_cosine, expected_sine) in
            [(1.0, -1.0, 0.0), (2.0, 0.0, -1.0), (3.0, 1.0, 0.0), (-1.0, 1.0, 0.0)]
        {
            let rotated = graph.linear(0.0, &[(a, 1.0), (pi, quarters / 2.0)]);
            let (cosine, sine_rotated) = (graph.cosine(rotated), graph.sine(rotated));
            if expected_cosine == 0.0 {
                assert_eq!(sine_rotated, graph.scale(expected_sine, sine));
            } else {
                assert_eq!(cosine, graph.scale(expected_cosine, sine));
            }
        }
        let opposite = graph.negate(a);
        assert_eq!(graph.cosine(opposite), graph.cosine(a));
        let expected = graph.negate(sine);
        assert_eq!(graph.sine(opposite), expected);
    }

    /// A root multiplied by any power of its radicand becomes a power of the radicand.
    #[test]
    fn powers_of_roots_are_powers_of_what_stands_below() {
        let mut graph = Graph::new();
        let (a, b) = (parameter(&mut graph, 0), parameter(&mut graph, 1));
        let radicand = graph.multiply(a, b);
        let root = graph.call(Function::Sqrt, &[radicand]);
        for (exponent, whole, odd) in [(1, 0, 1), (2, 1, 0), (3, 1, 1), (5, 2, 1), (-2, -1, 0), (-3, -1, -1)] {
            let expected = graph.product(&[(a, whole), (b, whole), (root, odd)]);
            assert_eq!(graph.power(root, exponent), expected, "{exponent}");
        }
    }

    /// A product of more factors than are merged is one factor of other products.
    #[test]
    fn long_products_stay_whole() {
        for (count, is_merged) in [(LONGEST_PRODUCT, true), (LONGEST_PRODUCT + 1, false)] {
            let mut graph = Graph::new();
            let factors: Vec<(Node, i32)> = (0..count).map(|index| (parameter(&mut graph, index), 1)).collect();
            let product = graph.product(&factors);
            let other = parameter(&mut graph, count);
            let whole = graph.multiply(product, other);
            let NodeKind::Product(found) = graph.kind(whole) else {
                panic!("it is a product");
            };
            assert_eq!(found.len(), if is_merged { count + 1 } else { 2 });
        }
    }
}
