//! Numeric evaluation, for constants and for probing identities.

use super::{Graph, Node, Symbol, Term};

impl Graph {
    /// The value of an expression where every symbol has the value given; NaN outside of a function's domain.
    pub(crate) fn evaluate(&self, node: Node, symbols: &dyn Fn(Symbol) -> f64) -> f64 {
        let parts = self.reachable(&[node]);
        let mut values = std::collections::BTreeMap::new();
        for part in parts {
            let value = match self.term(part) {
                Term::Number(number) => number.get(),
                Term::Pi => std::f64::consts::PI,
                Term::Symbol(symbol) => symbols(*symbol),
                Term::Sum(constant, terms) => terms.iter().fold(constant.get(), |sum, (operand, coefficient)| {
                    sum + coefficient.get() * values[operand]
                }),
                Term::Product(factors) => factors.iter().fold(1.0, |product, (operand, exponent)| {
                    let base: f64 = values[operand];
                    product * base.powi(*exponent)
                }),
                Term::Call(function, arguments) => {
                    let arguments: Vec<f64> = arguments.iter().map(|argument| values[argument]).collect();
                    function.value(&arguments)
                }
            };
            values.insert(part, value);
        }
        values[&node]
    }
}
