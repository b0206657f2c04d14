//! Numeric tests of identities that the normal form cannot decide.
//!
//! Two expressions that are equal by an identity unknown to the normal form (cos² + sin² = 1, for example) have equal
//! values everywhere. Two different expressions agree only on a set of measure zero. So an expression counts as zero if
//! it vanishes at several scattered points. The points are fixed, which keeps the expansion deterministic.

use super::{Graph, Index as _, Node, NodeKind, Symbol};
use crate::work;

/// The number of points.
pub(super) const POINTS: usize = 4;
/// The largest value relative to the terms that counts as zero. Rounding leaves about 1e-15 of the terms; a true
/// difference leaves far more.
const TOLERANCE: f64 = 1e-9;

/// A point at which expressions are compared.
#[derive(Clone, Copy)]
pub(crate) struct Probe(u64);

impl Probe {
    /// The first point.
    pub(crate) const FIRST: Self = Self(0);

    /// The points, in a fixed order.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        (0..POINTS as u64).map(Self)
    }

    /// A symbol's value at this point: between 0.5 and 1.5, within the domain of roots and logarithms.
    pub(crate) fn value(self, symbol: Symbol) -> f64 {
        let (kind, index) = match symbol {
            Symbol::Parameter(index) => (1, index),
            Symbol::Input(index) => (2, index),
            Symbol::Unknown(index) => (3, index),
            Symbol::InputRate(index, order) => (4 + 16 * order, index),
            Symbol::UnknownRate(index, order) => (5 + 16 * order, index),
            Symbol::Turning(index, order) => (11 + 16 * order, index),
            Symbol::Step(index) => (6, index),
            Symbol::Value(index) => (10, index),
            Symbol::OutputRate(index, order) => (7 + 16 * order, index),
            Symbol::Sensitivity(index, parameter, order) => (8 + 16 * order, index + (parameter << 12)),
            Symbol::OutputSensitivity(index, parameter, order) => (9 + 16 * order, index + (parameter << 12)),
        };
        let seed = (kind as u64) << 40 | (index as u64) << 8 | self.0;
        0.5 + scattered(seed)
    }
}

/// A number in 0..1 from a seed, by the mixing function of `SplitMix64` (Steele, Lea and Flood, "Fast splittable
/// pseudorandom number generators", OOPSLA 2014, figure 16).
fn scattered(seed: u64) -> f64 {
    let mut z = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    #[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
    let fraction = ((z ^ (z >> 31)) >> 11) as f64;
    fraction / 9_007_199_254_740_992.0
}

impl Graph {
    /// The values of an expression at the points; NaN outside a function's domain.
    pub(crate) fn probe(&mut self, node: Node) -> [f64; POINTS] {
        // operands have lower indices than the expressions that contain them
        for index in self.probed.len()..=node.index() {
            work::iteration();
            #[expect(clippy::cast_possible_truncation, reason = "there are fewer than 2^32 nodes")]
            let node = Node(index as u32);
            let mut values = [0.0; POINTS];
            for (point, (value, probe)) in values.iter_mut().zip(Probe::all()).enumerate() {
                *value = self.value(
                    node,
                    |operand| self.probed[operand.index()][point],
                    |symbol| probe.value(symbol),
                );
            }
            self.probed.push(values);
        }
        self.probed[node.index()]
    }

    /// Whether an expression is zero for all values of its symbols. A product is zero if one of its factors is.
    pub(crate) fn vanishes(&mut self, node: Node) -> bool {
        if let Some(value) = self.as_number(node) {
            return value == 0.0;
        }
        match self.kind(node).clone() {
            NodeKind::Product(factors) => factors
                .iter()
                .any(|&(factor, exponent)| exponent > 0 && self.vanishes(factor)),
            NodeKind::Sum(constant, terms) => {
                let values = self.probe(node);
                let mut seen = false;
                for (point, value) in values.into_iter().enumerate().filter(|(_, value)| value.is_finite()) {
                    let size = terms.iter().fold(constant.get().abs(), |size, &(part, coefficient)| {
                        size + (coefficient.get() * self.probed[part.index()][point]).abs()
                    });
                    if value.abs() > TOLERANCE * size.max(1e-3) {
                        return false;
                    }
                    seen = true;
                }
                seen
            }
            _ => false,
        }
    }

    /// Whether an expression is zero but for rounding because terms of it cancel, at any depth of sums and products.
    /// However small it is otherwise, its magnitude does not matter.
    pub(crate) fn cancels(&mut self, node: Node) -> bool {
        match self.kind(node).clone() {
            NodeKind::Number(value) => value.get() == 0.0,
            NodeKind::Pi | NodeKind::Symbol(_) | NodeKind::Call(..) => false,
            NodeKind::Product(factors) => factors
                .iter()
                .any(|&(factor, exponent)| exponent > 0 && self.cancels(factor)),
            NodeKind::Sum(constant, terms) => {
                let values = self.probe(node);
                let mut seen = false;
                let is_rounding = (0..POINTS).filter(|&point| values[point].is_finite()).all(|point| {
                    seen = true;
                    let size = terms.iter().fold(constant.get().abs(), |size, &(part, coefficient)| {
                        size + (coefficient.get() * self.probed[part.index()][point]).abs()
                    });
                    values[point].abs() <= TOLERANCE * size
                });
                seen && is_rounding || constant.get() == 0.0 && terms.iter().all(|&(term, _)| self.cancels(term))
            }
        }
    }

    /// Whether two expressions are equal for all values of their symbols.
    pub(crate) fn same(&mut self, a: Node, b: Node) -> bool {
        a == b || {
            let difference = self.subtract(a, b);
            self.vanishes(difference)
        }
    }

    /// The number by which `part` is multiplied in `whole`, if that is `part` times a number that single precision
    /// holds: one that somebody wrote, or that a rule of differentiation gives.
    pub(crate) fn multiple(&mut self, whole: Node, part: Node) -> Option<f64> {
        const ROUNDING: f64 = 1e-12;
        let (whole, part) = (self.probe(whole), self.probe(part));
        let quotients = whole.into_iter().zip(part).map(|(whole, part)| whole / part);
        #[expect(
            clippy::cast_possible_truncation,
            reason = "the test that follows is of the rounded number"
        )]
        let number = f64::from(quotients.clone().find(|quotient| quotient.is_finite())? as f32);
        let is_number = quotients
            .filter(|quotient| !quotient.is_nan())
            .all(|quotient| (quotient - number).abs() <= ROUNDING * number.abs());
        (is_number && number != 0.0).then_some(number)
    }

    /// Whether an expression is negative at the first point. This sign does not depend on how the expression was typed.
    pub(crate) fn probes_negative(&mut self, node: Node) -> bool {
        self.probe(node)
            .into_iter()
            .find(|value| value.is_finite())
            .is_some_and(|value| value < 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// cos² + sin² - 1 vanishes, alone and as a factor of a product.
    #[test]
    fn identities_vanish_within_products_too() {
        let mut graph = Graph::new();
        let (x, radius) = (graph.symbol(Symbol::Unknown(0)), graph.symbol(Symbol::Parameter(0)));
        let (cosine, sine) = (graph.cosine(x), graph.sine(x));
        let (c2, s2) = (graph.power(cosine, 2), graph.power(sine, 2));
        let nothing = graph.linear(-1.0, &[(c2, 1.0), (s2, 1.0)]);
        let product = graph.multiply(radius, nothing);
        let quotient = graph.divide(nothing, radius);
        let something = graph.linear(-1.0, &[(c2, 1.0), (s2, 2.0)]);
        let other = graph.multiply(radius, something);
        for (node, vanishes) in [
            (nothing, true),
            (product, true),
            (quotient, true),
            (something, false),
            (other, false),
            (radius, false),
        ] {
            assert_eq!(graph.vanishes(node), vanishes);
        }
    }

    /// What cancels leaves rounding, and a sum of products with such factors leaves rounding too. A small number does
    /// not cancel.
    #[test]
    fn sums_of_what_cancels_cancel() {
        let mut graph = Graph::new();
        let (x, radius) = (graph.symbol(Symbol::Unknown(0)), graph.symbol(Symbol::Parameter(0)));
        let (cosine, sine) = (graph.cosine(x), graph.sine(x));
        let (c2, s2) = (graph.power(cosine, 2), graph.power(sine, 2));
        let nothing = graph.linear(-1.0, &[(c2, 1.0), (s2, 1.0)]);
        let [first, second] = [cosine, sine].map(|factor| graph.product(&[(factor, 1), (nothing, 1), (radius, -1)]));
        let sum = graph.linear(0.0, &[(first, 2.0), (second, 3.0)]);
        assert!(graph.cancels(nothing) && graph.cancels(first) && graph.cancels(sum));
        let small = graph.scale(1e-200, radius);
        let with_small = graph.linear(0.0, &[(first, 2.0), (radius, 1e-200)]);
        assert!(!graph.cancels(small) && !graph.cancels(with_small) && !graph.cancels(cosine));
    }

    /// A number by which an expression is multiplied is found, and no other quotient.
    #[test]
    fn multiples_by_numbers_are_found() {
        let mut graph = Graph::new();
        let (x, length) = (graph.symbol(Symbol::Unknown(0)), graph.symbol(Symbol::Parameter(0)));
        let (cosine, sine) = (graph.cosine(x), graph.sine(x));
        let part = graph.linear(0.0, &[(cosine, 1.0), (sine, -1.0)]);
        for (first, second, expected) in [
            (2.0, -2.0, Some(2.0)),
            (-0.5, 0.5, Some(-0.5)),
            (1.0, 1.0, None),
            // single precision does not hold a third
            (1.0 / 3.0, -1.0 / 3.0, None),
            (1.0, -1.000_000_1, None),
        ] {
            let whole = graph.linear(0.0, &[(cosine, first), (sine, second)]);
            assert_eq!(graph.multiple(whole, part), expected, "{first} {second}");
        }
        let longer = graph.multiply(length, part);
        let zero = graph.zero();
        assert_eq!([longer, zero].map(|whole| graph.multiple(whole, part)), [None, None]);
    }

    /// Whether an expression vanishes does not depend on the unit.
    #[test]
    fn multiples_vanish_with_what_they_are_multiples_of() {
        let mut graph = Graph::new();
        let x = graph.symbol(Symbol::Unknown(0));
        let (cosine, sine) = (graph.cosine(x), graph.sine(x));
        let (c2, s2) = (graph.power(cosine, 2), graph.power(sine, 2));
        for unit in [1e-11, 1e-6, 1.0, 1e6, 1e12] {
            let nothing = graph.linear(-unit, &[(c2, unit), (s2, unit)]);
            assert!(graph.vanishes(nothing), "{unit}");
            let something = graph.linear(-unit, &[(c2, unit), (s2, 2.0 * unit)]);
            assert!(!graph.vanishes(something), "{unit}");
        }
    }

    /// Expressions that differ in form are the same if an identity makes them equal.
    #[test]
    fn what_differs_by_an_identity_is_the_same() {
        let mut graph = Graph::new();
        let x = graph.symbol(Symbol::Unknown(0));
        let (cosine, sine, one) = (graph.cosine(x), graph.sine(x), graph.one());
        let (c2, s2) = (graph.power(cosine, 2), graph.power(sine, 2));
        let rest = graph.subtract(one, s2);
        assert!(graph.same(c2, rest) && graph.same(c2, c2));
        assert!(!graph.same(c2, s2));
    }

    /// No two symbols have the same value at a point. If they had, their difference would vanish.
    #[test]
    fn symbols_are_distinguished() {
        let mut symbols = Vec::new();
        for index in 0..6 {
            symbols.extend([
                Symbol::Parameter(index),
                Symbol::Input(index),
                Symbol::Unknown(index),
                Symbol::Step(index),
                Symbol::Value(index),
            ]);
            for order in 0..8 {
                symbols.extend([
                    Symbol::InputRate(index, order),
                    Symbol::UnknownRate(index, order),
                    Symbol::Turning(index, order),
                    Symbol::OutputRate(index, order),
                ]);
                for parameter in 0..3 {
                    symbols.extend([
                        Symbol::Sensitivity(index, parameter, order),
                        Symbol::OutputSensitivity(index, parameter, order),
                    ]);
                }
            }
        }
        let values: std::collections::BTreeSet<u64> = Probe::all()
            .flat_map(|probe| symbols.iter().map(move |&symbol| probe.value(symbol).to_bits()))
            .collect();
        assert_eq!(values.len(), POINTS * symbols.len());
    }
}
