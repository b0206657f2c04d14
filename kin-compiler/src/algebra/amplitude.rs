//! The largest magnitude of an expression that is made of numbers, sines and cosines alone.

use super::{Function, Graph, Node, NodeKind};

impl Graph {
    /// A bound of the magnitude of an expression whose terms are products of numbers, sines and cosines. Where the
    /// expression is a small part of it, what is left is rounding. There is none if anything else occurs, such as a
    /// length, whose size is not known.
    pub(crate) fn amplitude(&self, node: Node) -> Option<f64> {
        match self.kind(node) {
            NodeKind::Number(number) => Some(number.get().abs()),
            NodeKind::Call(Function::Sin | Function::Cos, _) => Some(1.0),
            NodeKind::Sum(constant, terms) => {
                terms.iter().try_fold(constant.get().abs(), |sum, (term, coefficient)| {
                    Some(sum + coefficient.get().abs() * self.amplitude(*term)?)
                })
            }
            NodeKind::Product(factors) => factors.iter().try_fold(1.0, |product, &(factor, exponent)| {
                (exponent > 0).then_some(())?;
                Some(product * self.amplitude(factor)?.powi(exponent))
            }),
            NodeKind::Pi | NodeKind::Symbol(_) | NodeKind::Call(..) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Symbol;
    use super::*;

    #[test]
    fn lengths_have_no_amplitude() {
        let mut graph = Graph::new();
        let [x, length] = [Symbol::Input(0), Symbol::Parameter(0)].map(|symbol| graph.symbol(symbol));
        let (cosine, sine) = (graph.cosine(x), graph.sine(x));
        let product = graph.product(&[(cosine, 2), (sine, 1)]);
        let sum = graph.linear(0.5, &[(product, -3.0), (cosine, 2.0)]);
        assert_eq!(graph.amplitude(sum), Some(5.5));
        let quotient = graph.product(&[(cosine, -1)]);
        let long = graph.product(&[(cosine, 1), (length, 1)]);
        for other in [quotient, long, length, x] {
            assert_eq!(graph.amplitude(other), None);
        }
    }
}
