//! Total time derivatives of any order of any expression.
//!
//! Every rule gives the n-th derivative from lower ones, which are remembered. So the work grows with the square of the
//! order. Differentiating the first derivative again and again would make it grow exponentially.

use std::collections::BTreeMap;

use super::Hint;
use crate::algebra::{Function, Graph, Node, NodeKind, Symbol};
use crate::passes::{Pass, Passes};

/// The derivatives found so far.
pub(super) struct KnownRates {
    passes: Passes,
    known: BTreeMap<(Node, usize), Node>,
    envelopes: BTreeMap<(Node, Node, usize), (Node, Node)>,
    /// The unknowns whose rates are being solved for, and the order of these rates.
    sought: (Vec<usize>, usize),
    /// The contributions of lower rates to the Q of an unknown angle that is solved for, by unknown and order.
    lower: BTreeMap<(usize, usize), Node>,
}

/// The binomial coefficient, n over k.
pub(super) fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, step| {
        #[expect(clippy::cast_precision_loss, reason = "orders are small")]
        let (above, below) = ((n - step) as f64, (step + 1) as f64);
        product * above / below
    })
}

impl KnownRates {
    pub(super) const fn new(passes: Passes) -> Self {
        Self {
            passes,
            known: BTreeMap::new(),
            envelopes: BTreeMap::new(),
            sought: (Vec::new(), 0),
            lower: BTreeMap::new(),
        }
    }

    /// Sets the unknowns whose rates are solved for, and the order. If such an unknown rotates a vector, its whole Q is
    /// solved for.
    ///
    /// Q is the rate itself plus contributions of lower rates. The vector is multiplied by the whole Q only, so these
    /// contributions need not be multiplied by the vector and moved to the right-hand side.
    pub(super) fn seek(&mut self, unknowns: &[usize], order: usize) {
        if self.passes.include(Pass::WholeTurnings) {
            self.sought = (unknowns.to_vec(), order);
        }
    }

    /// The contributions of lower rates to the Q of an unknown angle, if it was solved for.
    pub(super) fn lower(&self, unknown: usize, order: usize) -> Option<Node> {
        self.lower.get(&(unknown, order)).copied()
    }

    /// The named parts of rotating vectors, which are shared: P and Q by angle and order.
    pub(super) fn hints(&self, graph: &Graph) -> Vec<(Node, Hint)> {
        let mut hints = Vec::new();
        for (&(amplitude, angle, order), &(along, across)) in &self.envelopes {
            if let Some(angle) = graph.as_symbol(angle)
                && graph.is_one(amplitude)
                && order > 1
            {
                hints.extend([(along, Hint::P { angle, order }), (across, Hint::Q { angle, order })]);
            }
        }
        hints
    }

    /// The total time derivative of a given order.
    pub(super) fn total(&mut self, graph: &mut Graph, node: Node, order: usize) -> Node {
        if order == 0 {
            return node;
        }
        if graph.is_constant_in_time(node) {
            return graph.zero();
        }
        if let Some(&derivative) = self.known.get(&(node, order)) {
            return derivative;
        }
        let derivative = match graph.kind(node).clone() {
            NodeKind::Number(_) | NodeKind::Pi => graph.zero(),
            NodeKind::Symbol(Symbol::Input(index)) => graph.symbol(Symbol::InputRate(index, order)),
            NodeKind::Symbol(Symbol::Unknown(index)) => graph.symbol(Symbol::UnknownRate(index, order)),
            NodeKind::Symbol(Symbol::InputRate(index, lower)) => graph.symbol(Symbol::InputRate(index, lower + order)),
            NodeKind::Symbol(Symbol::UnknownRate(index, lower)) => {
                graph.symbol(Symbol::UnknownRate(index, lower + order))
            }
            NodeKind::Symbol(Symbol::Sensitivity(index, parameter, lower)) => {
                graph.symbol(Symbol::Sensitivity(index, parameter, lower + order))
            }
            NodeKind::Symbol(Symbol::Turning(..)) => {
                unreachable!("only what depends on positions alone is differentiated")
            }
            NodeKind::Symbol(
                Symbol::Parameter(_)
                | Symbol::OutputRate(..)
                | Symbol::OutputSensitivity(..)
                | Symbol::Step(_)
                | Symbol::Value(_),
            ) => graph.zero(),
            NodeKind::Sum(_, terms) => {
                let terms: Vec<(Node, f64)> = terms
                    .into_iter()
                    .map(|(part, coefficient)| (self.total(graph, part, order), coefficient.get()))
                    .collect();
                graph.linear(0.0, &terms)
            }
            NodeKind::Product(factors) => self.product(graph, &factors, order),
            NodeKind::Call(Function::Sin | Function::Cos, _) if self.passes.include(Pass::LinkVectors) => {
                self.product(graph, &[(node, 1)], order)
            }
            NodeKind::Call(function, arguments) => self.composite(graph, function, &arguments, node, order),
        };
        self.known.insert((node, order), derivative);
        derivative
    }

    /// The derivative of a product, split into constant factors, a rotating factor, and the rest.
    fn product(&mut self, graph: &mut Graph, factors: &[(Node, i32)], order: usize) -> Node {
        let (constant, varying): (Vec<_>, Vec<_>) = factors
            .iter()
            .copied()
            .partition(|&(factor, _)| graph.is_constant_in_time(factor));
        let circular = varying.iter().position(|&(factor, exponent)| {
            exponent == 1 && matches!(graph.kind(factor), NodeKind::Call(Function::Sin | Function::Cos, _))
        });
        if let Some(position) = circular.filter(|_| self.passes.include(Pass::LinkVectors)) {
            let mut amplitude = varying;
            let (turning, _) = amplitude.remove(position);
            return self.turning(graph, &constant, &amplitude, turning, order);
        }
        let derivative = match varying[..] {
            [] => graph.zero(),
            [(base, exponent)] => self.power(graph, base, exponent, order),
            [first, ref rest @ ..] => {
                let (left, right) = (graph.product(&[first]), graph.product(rest));
                self.leibniz(graph, left, right, order)
            }
        };
        let constant = graph.product(&constant);
        graph.multiply(constant, derivative)
    }

    /// (a b)⁽ⁿ⁾ = Σ C(n, k) a⁽ᵏ⁾ b⁽ⁿ⁻ᵏ⁾.
    fn leibniz(&mut self, graph: &mut Graph, a: Node, b: Node, order: usize) -> Node {
        let terms: Vec<(Node, f64)> = (0..=order)
            .map(|k| {
                let (left, right) = (self.total(graph, a, k), self.total(graph, b, order - k));
                (graph.multiply(left, right), binomial(order, k))
            })
            .collect();
        graph.linear(0.0, &terms)
    }

    fn power(&mut self, graph: &mut Graph, base: Node, exponent: i32, order: usize) -> Node {
        match exponent {
            1 => self.total(graph, base, order),
            -1 => {
                // y b = 1, so y⁽ⁿ⁾ = -y Σ C(n, k) b⁽ᵏ⁾ y⁽ⁿ⁻ᵏ⁾ over k from 1
                let reciprocal = graph.power(base, -1);
                let terms: Vec<(Node, f64)> = (1..=order)
                    .map(|k| {
                        let (left, right) = (self.total(graph, base, k), self.total(graph, reciprocal, order - k));
                        (graph.multiply(left, right), -binomial(order, k))
                    })
                    .collect();
                let sum = graph.linear(0.0, &terms);
                graph.multiply(reciprocal, sum)
            }
            _ => {
                // halving the exponent keeps the number of products of a high power small
                let half = exponent / 2;
                let (left, right) = (graph.power(base, half), graph.power(base, exponent - half));
                self.leibniz(graph, left, right, order)
            }
        }
    }

    /// y = f(x₁, …): y′ = Σ (∂f/∂xᵢ) xᵢ′, and the rest by Leibniz's rule.
    fn composite(
        &mut self,
        graph: &mut Graph,
        function: Function,
        arguments: &[Node],
        value: Node,
        order: usize,
    ) -> Node {
        let partials = function.partials(graph, arguments, value);
        let mut terms = Vec::new();
        for (&argument, partial) in arguments.iter().zip(partials) {
            if graph.is_constant_in_time(argument) {
                continue;
            }
            for k in 0..order {
                let (outer, inner) = (self.total(graph, partial, k), self.total(graph, argument, order - k));
                terms.push((graph.multiply(outer, inner), binomial(order - 1, k)));
            }
        }
        graph.linear(0.0, &terms)
    }

    /// The angle of a sine or cosine, and the pair (cos, sin) that rotates it by a right angle.
    fn pair(graph: &mut Graph, turning: Node) -> (Node, Node, bool) {
        let NodeKind::Call(function, arguments) = graph.kind(turning).clone() else {
            unreachable!("only sines and cosines rotate");
        };
        let partner = function.partner().expect("only sines and cosines rotate");
        let other = graph.call(partner, &arguments);
        (arguments[0], other, function == Function::Cos)
    }

    /// The derivative of a component of a link vector: z⁽ⁿ⁾ = (Aₙ + i Bₙ) cis(φ) for z = m cis(φ). All vectors that
    /// rotate with φ share A and B.
    fn turning(
        &mut self,
        graph: &mut Graph,
        constant: &[(Node, i32)],
        amplitude: &[(Node, i32)],
        turning: Node,
        order: usize,
    ) -> Node {
        let (angle, other, is_cosine) = Self::pair(graph, turning);
        let amplitude = graph.product(amplitude);
        let (along, across) = self.envelope(graph, amplitude, angle, order);
        // cosine: A cos - B sin; sine: A sin + B cos
        let mut term = |envelope: Node, circular: Node| {
            let mut factors = constant.to_vec();
            factors.extend([(envelope, 1), (circular, 1)]);
            graph.product(&factors)
        };
        let (first, second) = (term(along, turning), term(across, other));
        if is_cosine {
            graph.subtract(first, second)
        } else {
            graph.add(first, second)
        }
    }

    /// Aₙ and Bₙ in (m cis φ)⁽ⁿ⁾ = (Aₙ + i Bₙ) cis φ.
    ///
    /// For m = 1 they are P and Q: the real and imaginary parts of the complete Bell polynomials in i φ′, i φ″, …, with
    /// (P + i Q)ₙ₊₁ = Σ C(n, k) i φ⁽ᵏ⁺¹⁾ (P + i Q)ₙ₋ₖ.
    fn envelope(&mut self, graph: &mut Graph, amplitude: Node, angle: Node, order: usize) -> (Node, Node) {
        if let Some(&known) = self.envelopes.get(&(amplitude, angle, order)) {
            return known;
        }
        let (mut along, mut across) = (Vec::new(), Vec::new());
        let one = graph.one();
        let result = if order == 0 {
            (amplitude, graph.zero())
        } else if amplitude == one {
            for k in 0..order {
                let rate = self.total(graph, angle, k + 1);
                let (p, q) = self.envelope(graph, one, angle, order - 1 - k);
                along.push((graph.multiply(rate, q), -binomial(order - 1, k)));
                across.push((graph.multiply(rate, p), binomial(order - 1, k)));
            }
            (graph.linear(0.0, &along), self.across(graph, angle, &across))
        } else {
            for k in 0..=order {
                let rate = self.total(graph, amplitude, k);
                let (p, q) = self.envelope(graph, one, angle, order - k);
                along.push((graph.multiply(rate, p), binomial(order, k)));
                across.push((graph.multiply(rate, q), binomial(order, k)));
            }
            (graph.linear(0.0, &along), graph.linear(0.0, &across))
        };
        self.envelopes.insert((amplitude, angle, order), result);
        result
    }

    /// Q as a sum whose last term is the highest rate, or as a symbol if this rate is being solved for.
    fn across(&mut self, graph: &mut Graph, angle: Node, terms: &[(Node, f64)]) -> Node {
        let order = terms.len();
        let (_, rest) = terms.split_last().expect("orders start at one");
        if let Some(Symbol::Unknown(unknown)) = graph.as_symbol(angle)
            && self.sought.1 == order
            && self.sought.0.contains(&unknown)
        {
            let lower = graph.linear(0.0, rest);
            if !graph.is_zero(lower) {
                self.lower.insert((unknown, order), lower);
                return graph.symbol(Symbol::Turning(unknown, order));
            }
        }
        graph.linear(0.0, terms)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The derivatives with link vectors and by Leibniz's rule alone agree with a difference quotient of the next lower
    /// order.
    #[test]
    fn each_order_is_the_derivative_of_the_one_below() {
        let mut graph = Graph::new();
        let (x, y) = (graph.symbol(Symbol::Input(0)), graph.symbol(Symbol::Unknown(0)));
        let radius = graph.symbol(Symbol::Parameter(0));
        let cosine = graph.cosine(x);
        let sum = graph.add(x, y);
        let sine = graph.sine(sum);
        let square = graph.power(y, 2);
        let link = graph.product(&[(radius, 1), (cosine, 1), (y, 1)]);
        let quotient = graph.divide(sine, square);
        let exponential = graph.call(Function::Exp, &[cosine]);
        let two = graph.number(2.0);
        let shifted = graph.add(two, sine);
        let root = graph.call(Function::Sqrt, &[shifted]);
        let arc = graph.call(Function::Atan2, &[x, y]);
        let at = |time: f64| {
            move |symbol: Symbol| {
                let (value, order) = match symbol {
                    Symbol::Parameter(_) => (0.7, 0),
                    Symbol::Input(_) => (0.4, 0),
                    Symbol::InputRate(_, order) => (0.4, order),
                    Symbol::Unknown(_) => (1.1, 0),
                    Symbol::UnknownRate(_, order) => (1.1, order),
                    Symbol::OutputRate(..)
                    | Symbol::Sensitivity(..)
                    | Symbol::OutputSensitivity(..)
                    | Symbol::Turning(..)
                    | Symbol::Step(_)
                    | Symbol::Value(_) => (f64::NAN, 0),
                };
                if matches!(symbol, Symbol::Parameter(_)) {
                    return value;
                }
                // x(t) = value · exp(t), whose derivatives are all known
                let _ = order;
                value * time.exp()
            }
        };
        for passes in [Passes::ALL, Passes::without(Pass::LinkVectors)] {
            let mut rates = KnownRates::new(passes);
            for node in [cosine, sine, link, quotient, exponential, root, arc] {
                for order in 1..=6 {
                    let derivative = rates.total(&mut graph, node, order);
                    let below = rates.total(&mut graph, node, order - 1);
                    let step = 1e-5;
                    let exact = graph.evaluate(derivative, &at(0.0));
                    let difference =
                        (graph.evaluate(below, &at(step)) - graph.evaluate(below, &at(-step))) / (2.0 * step);
                    assert!(
                        (exact - difference).abs() < 1e-6 * (1.0 + exact.abs()),
                        "{passes:?}, order {order}: {exact} against {difference}"
                    );
                }
            }
        }
    }

    /// The rate of a rate is the rate of the sum of both orders.
    #[test]
    fn orders_add_up() {
        let mut graph = Graph::new();
        let mut rates = KnownRates::new(Passes::ALL);
        let with_order: [fn(usize) -> Symbol; 3] = [
            |order| Symbol::InputRate(2, order),
            |order| Symbol::UnknownRate(1, order),
            |order| Symbol::Sensitivity(1, 3, order),
        ];
        for symbol in with_order {
            for (lower, order) in [(1, 1), (2, 1), (1, 3), (3, 2)] {
                let node = graph.symbol(symbol(lower));
                assert_eq!(
                    rates.total(&mut graph, node, order),
                    graph.symbol(symbol(lower + order)),
                    "{lower} {order}"
                );
            }
        }
    }
}
