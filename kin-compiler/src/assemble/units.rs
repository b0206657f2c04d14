//! Sines and cosines, read off unit vectors.

use std::collections::BTreeMap;

use crate::algebra::{Function, Graph, Node, NodeKind, Symbol};
use crate::passes::{Pass, Passes};
use crate::program::Step;
use crate::structure::ComplexNode;

/// The known directions of unknown angles.
pub(crate) struct Units {
    passes: Passes,
    /// cos and sin of an angle, by the expression of the angle.
    directions: BTreeMap<Node, ComplexNode>,
    /// Unknown angles that are linear expressions of other angles.
    combinations: BTreeMap<Node, Node>,
    /// The new names of angles.
    renamed: BTreeMap<Node, Node>,
    /// The expressions for the reciprocals of divisors that are to be avoided.
    reciprocals: BTreeMap<Node, Node>,
    rewritten: BTreeMap<Node, Node>,
}

impl Units {
    /// The state in which nothing is known.
    pub(crate) const fn new(passes: Passes) -> Self {
        Self {
            passes,
            directions: BTreeMap::new(),
            combinations: BTreeMap::new(),
            renamed: BTreeMap::new(),
            reciprocals: BTreeMap::new(),
            rewritten: BTreeMap::new(),
        }
    }

    /// Records cos and sin of `angle`.
    pub(crate) fn learn_direction(&mut self, angle: Node, direction: ComplexNode) {
        if self.passes.include(Pass::UnitVectors) {
            self.directions.insert(angle, direction);
            self.rewritten.clear();
        }
    }

    /// Records the expression of an unknown.
    pub(crate) fn learn_combination(&mut self, unknown: Node, value: Node) {
        self.combinations.insert(unknown, value);
        self.rewritten.clear();
    }

    /// Lets `value` replace an angle outside sines and cosines from now on.
    pub(crate) fn rename(&mut self, angle: Node, value: Node) {
        self.renamed.insert(angle, value);
        self.rewritten.clear();
    }

    /// Records other expressions for reciprocals.
    pub(crate) fn learn_reciprocals(&mut self, graph: &mut Graph, reciprocals: BTreeMap<Node, Node>) {
        self.reciprocals = reciprocals;
        self.rewritten.clear();
        let known: Vec<(Node, ComplexNode)> = self.directions.iter().map(|(&angle, &unit)| (angle, unit)).collect();
        for (angle, unit) in known {
            let unit = ComplexNode::new(self.rewrite(graph, unit.re), self.rewrite(graph, unit.im));
            self.directions.insert(angle, unit);
        }
    }

    /// An expression without sines and cosines of unknowns whose directions are known.
    pub(crate) fn rewrite(&mut self, graph: &mut Graph, node: Node) -> Node {
        if let Some(&known) = self.rewritten.get(&node) {
            return known;
        }
        let result = match graph.kind(node).clone() {
            NodeKind::Number(_) | NodeKind::Pi => node,
            NodeKind::Symbol(_) => self.renamed.get(&node).copied().unwrap_or(node),
            NodeKind::Sum(constant, terms) => {
                let terms: Vec<(Node, f64)> = terms
                    .into_iter()
                    .map(|(part, coefficient)| (self.rewrite(graph, part), coefficient.get()))
                    .collect();
                graph.linear(constant.get(), &terms)
            }
            NodeKind::Product(factors) => {
                let factors: Vec<(Node, i32)> = factors
                    .into_iter()
                    .map(|(part, exponent)| (self.rewrite(graph, part), exponent))
                    .collect();
                let product = graph.product(&factors);
                self.inverted(graph, product)
            }
            NodeKind::Call(Function::Cos, arguments) => self.direction(graph, arguments[0]).re,
            NodeKind::Call(Function::Sin, arguments) => self.direction(graph, arguments[0]).im,
            NodeKind::Call(function, arguments) => {
                let arguments: Vec<Node> = arguments
                    .into_iter()
                    .map(|argument| self.rewrite(graph, argument))
                    .collect();
                graph.call(function, &arguments)
            }
        };
        self.rewritten.insert(node, result);
        result
    }

    /// A product in which recorded expressions replace divisions.
    fn inverted(&self, graph: &mut Graph, product: Node) -> Node {
        let (coefficient, bare) = graph.split_coefficient(product);
        let NodeKind::Product(factors) = graph.kind(bare) else {
            return product;
        };
        if factors.iter().all(|&factor| self.reciprocal(factor).is_none()) {
            return product;
        }
        let factors: Vec<(Node, i32)> = factors
            .iter()
            .map(|&factor| self.reciprocal(factor).unwrap_or(factor))
            .collect();
        let inverted = graph.product(&factors);
        graph.scale(coefficient, inverted)
    }

    /// A factor as a power of the recorded expression for its reciprocal.
    fn reciprocal(&self, (base, exponent): (Node, i32)) -> Option<(Node, i32)> {
        let &reciprocal = self.reciprocals.get(&base)?;
        (exponent < 0).then_some((reciprocal, -exponent))
    }

    /// The step that solves for several unknowns by the factors of their Jacobian.
    pub(crate) fn substitution(
        &mut self,
        graph: &mut Graph,
        factors: Symbol,
        right: &[Node],
        results: Vec<Symbol>,
    ) -> Step<Node> {
        Step::Substitute {
            factors: graph.symbol(factors),
            right: right.iter().map(|&node| self.rewrite(graph, node)).collect(),
            results,
        }
    }

    /// cos and sin of an angle: known ones, combinations of known ones by the addition theorems, or evaluated.
    pub(crate) fn direction(&mut self, graph: &mut Graph, angle: Node) -> ComplexNode {
        if let Some(&direction) = self.directions.get(&angle) {
            return direction;
        }
        let direction = if let Some(parts) = self.resolve(graph, angle) {
            let mut product: Option<ComplexNode> = None;
            for (part, multiple) in parts {
                let mut unit = self.direction(graph, part);
                if multiple < 0 {
                    unit = unit.conjugate(graph);
                }
                for _ in 0..multiple.abs() {
                    product = Some(product.map_or(unit, |before| before.times(graph, unit)));
                }
            }
            product.unwrap_or_else(|| ComplexNode::new(graph.one(), graph.zero()))
        } else {
            let argument = self.rewrite(graph, angle);
            ComplexNode::new(graph.cosine(argument), graph.sine(argument))
        };
        self.directions.insert(angle, direction);
        direction
    }

    /// An angle as an integer combination of angles with known directions and one rest; `None` if it has to be
    /// evaluated.
    fn resolve(&mut self, graph: &mut Graph, angle: Node) -> Option<Vec<(Node, i32)>> {
        let (constant, terms): (f64, Vec<(Node, f64)>) = match graph.kind(angle) {
            NodeKind::Sum(constant, terms) => (
                constant.get(),
                terms.iter().map(|&(part, factor)| (part, factor.get())).collect(),
            ),
            _ => (0.0, vec![(angle, 1.0)]),
        };
        if let Some(&(part, _)) = terms
            .iter()
            .find(|&&(part, factor)| self.combinations.contains_key(&part) && factor.fract() == 0.0)
        {
            let value = self.combinations[&part];
            let replaced: Vec<(Node, f64)> = terms
                .iter()
                .map(|&(term, factor)| (if term == part { value } else { term }, factor))
                .collect();
            let whole = graph.linear(constant, &replaced);
            return Some(vec![(whole, 1)]);
        }
        if terms.len() == 1 && terms[0].1 == 1.0 && constant == 0.0 {
            return None;
        }
        let mut parts = Vec::new();
        let mut rest = Vec::new();
        for (part, factor) in terms {
            let has_direction =
                self.directions.contains_key(&part) || matches!(graph.as_symbol(part), Some(Symbol::Input(_)));
            if has_direction && factor.fract() == 0.0 && factor.abs() <= 8.0 {
                #[expect(clippy::cast_possible_truncation, reason = "it is an integer no larger than eight")]
                parts.push((part, factor as i32));
            } else {
                rest.push((part, factor));
            }
        }
        // an angle of inputs and parameters alone is as cheap to evaluate as to combine, and more accurate
        let is_of_unknowns = parts
            .iter()
            .any(|&(part, _)| matches!(graph.as_symbol(part), Some(Symbol::Unknown(_))));
        let is_multiple = parts.len() == 1 && rest.is_empty() && constant == 0.0;
        if parts.is_empty() || !(is_of_unknowns || is_multiple) {
            return None;
        }
        if !rest.is_empty() || constant != 0.0 {
            let rest = graph.linear(constant, &rest);
            parts.push((rest, 1));
        }
        Some(parts)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The parameter, the input and the unknowns of the tests, and the direction of the first unknown as a closed form
    /// finds it.
    struct Known {
        graph: Graph,
        units: Units,
        parameter: Node,
        input: Node,
        unknown: Node,
        other: Node,
    }

    const ANGLES: [f64; 4] = [0.3, 0.7, -1.9, 2.3];

    impl Known {
        fn new() -> Self {
            let mut graph = Graph::new();
            let (parameter, input) = (graph.symbol(Symbol::Parameter(0)), graph.symbol(Symbol::Input(0)));
            let [unknown, other] = [0, 1].map(|unknown| graph.symbol(Symbol::Unknown(unknown)));
            let direction = ComplexNode::new(graph.new_step().1, graph.new_step().1);
            let mut units = Units::new(Passes::ALL);
            units.learn_direction(unknown, direction);
            Self {
                graph,
                units,
                parameter,
                input,
                unknown,
                other,
            }
        }

        /// Whether the direction of an angle is that of its value.
        fn points_along(&mut self, angle: Node) -> bool {
            let direction = self.units.direction(&mut self.graph, angle);
            let value = |symbol: Symbol| match symbol {
                Symbol::Parameter(_) => ANGLES[0],
                Symbol::Input(_) => ANGLES[1],
                Symbol::Unknown(unknown) => ANGLES[2 + unknown],
                Symbol::Step(0) => ANGLES[2].cos(),
                _ => ANGLES[2].sin(),
            };
            let expected = self.graph.evaluate(angle, &value).sin_cos();
            let found = [direction.re, direction.im].map(|part| self.graph.evaluate(part, &value));
            // a product of at most three unit vectors
            (found[0] - expected.1).abs() < 8.0 * f64::EPSILON && (found[1] - expected.0).abs() < 8.0 * f64::EPSILON
        }
    }

    /// The cosine and sine of a combined angle are those of the whole angle.
    #[test]
    fn combined_directions_are_those_of_the_whole_angle() {
        let Known {
            parameter,
            input,
            unknown,
            other,
            ..
        } = Known::new();
        for (constant, terms) in [
            (0.4, vec![(unknown, 1.0)]),
            (0.0, vec![(unknown, -2.0), (input, 1.0)]),
            (0.4, vec![(unknown, 1.0), (other, 1.0), (parameter, -3.0)]),
            (0.0, vec![(unknown, 0.5), (input, 1.0)]),
            (0.0, vec![(unknown, 1.0), (input, 1.5)]),
            (0.0, vec![(unknown, -1.0), (parameter, 0.5)]),
            (0.0, vec![(input, 2.0)]),
        ] {
            let mut known = Known::new();
            let angle = known.graph.linear(constant, &terms);
            assert!(known.points_along(angle), "{constant} {terms:?}");
        }
    }

    /// A multiple of the input is combined from the sine and cosine. A sum of inputs and parameters is
    /// evaluated.
    #[test]
    fn multiples_of_inputs_need_no_further_sine() {
        let mut known = Known::new();
        let graph = &mut known.graph;
        let double = graph.scale(2.0, known.input);
        let (cosine, sine) = (graph.cosine(known.input), graph.sine(known.input));
        let unit = ComplexNode::new(cosine, sine);
        let expected = unit.times(graph, unit);
        let found = known.units.direction(graph, double);
        assert_eq!((found.re, found.im), (expected.re, expected.im));

        let sum = graph.add(known.input, known.parameter);
        let expected = (graph.cosine(sum), graph.sine(sum));
        let found = known.units.direction(graph, sum);
        assert_eq!((found.re, found.im), expected);
    }

    /// A renamed angle is read by its new name beside and inside functions, except for its known direction.
    #[test]
    fn renamed_angles_are_read_by_their_new_name() {
        let mut known = Known::new();
        let (_, name) = known.graph.new_step();
        let graph = &mut known.graph;
        let cosine = graph.cosine(known.unknown);
        let before = graph.product(&[(known.unknown, 1), (cosine, 1)]);
        let learnt = known.units.direction(graph, known.unknown).re;
        let expected = graph.multiply(known.unknown, learnt);
        assert_eq!(known.units.rewrite(graph, before), expected);
        known.units.rename(known.unknown, name);
        let expected = graph.multiply(name, learnt);
        assert_eq!(known.units.rewrite(graph, before), expected);
    }
}
