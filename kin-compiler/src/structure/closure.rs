//! The closure of a mechanism as trigonometric polynomials of its inputs and unknowns.
//!
//! With the inputs unknown as well, they are what a search for limits solves. Their coefficients depend on the
//! parameters alone.

use std::collections::BTreeMap;

use crate::algebra::{Expansion, Graph, Harmonic, Node, Symbol, Variables};

/// A term of a scalar equation: a number times a coefficient, by index, powers of inputs and unknowns, and a sine or a
/// cosine.
#[derive(Clone)]
pub(crate) struct ClosureMonomial {
    pub(crate) equation: u16,
    pub(crate) factor: f64,
    pub(crate) coefficient: u16,
    pub(crate) powers: Vec<(Symbol, u8)>,
    pub(crate) harmonic: Harmonic,
}

/// The terms of all scalar equations, in their order, and the coefficients, free of inputs and unknowns.
pub(crate) struct ClosurePolynomials {
    pub(crate) terms: Vec<ClosureMonomial>,
    pub(crate) coefficients: Vec<Node>,
}

/// The closure as polynomials; `None` if it is not algebraic, if something that moves stands in a denominator, if an
/// equation is too large to be multiplied out, or if a number does not fit the table.
pub(crate) fn closure_polynomials(graph: &mut Graph, residuals: &[Node]) -> Option<ClosurePolynomials> {
    let mut terms = Vec::new();
    let mut coefficients = Vec::new();
    let mut indices = BTreeMap::new();
    for (equation, &residual) in residuals.iter().enumerate() {
        let polynomial = Expansion::new(graph, Variables::Position).polynomial(residual)?;
        for (monomial, &coefficient) in &polynomial.0 {
            let powers = monomial.powers.iter();
            let powers = powers.map(|(&atom, &power)| Some((graph.as_symbol(atom)?, u8::try_from(power).ok()?)));
            let powers = powers.collect::<Option<Vec<_>>>()?;
            if let Harmonic::Cosine(angle) | Harmonic::Sine(angle) = &monomial.harmonic
                && angle.0.iter().any(|&(_, multiple)| i8::try_from(multiple).is_err())
            {
                return None;
            }
            let (factor, coefficient) = graph.split_coefficient(coefficient);
            let index = *indices.entry(coefficient).or_insert_with(|| {
                coefficients.push(coefficient);
                coefficients.len() - 1
            });
            terms.push(ClosureMonomial {
                equation: u16::try_from(equation).ok()?,
                factor,
                coefficient: u16::try_from(index).ok()?,
                powers,
                harmonic: monomial.harmonic.clone(),
            });
        }
    }
    Some(ClosurePolynomials { terms, coefficients })
}

#[cfg(test)]
mod tests {
    use super::closure_polynomials;
    use crate::algebra::{Graph, Harmonic, Symbol};

    /// The polynomials have the values of the equations for any inputs and unknowns.
    #[test]
    fn a_closure_is_its_polynomials() {
        let mut graph = Graph::new();
        let [p, s, x, y] = [
            Symbol::Parameter(0),
            Symbol::Input(0),
            Symbol::Unknown(0),
            Symbol::Unknown(1),
        ]
        .map(|symbol| graph.symbol(symbol));
        let sum = graph.linear(0.0, &[(x, 1.0), (s, -2.0), (p, 1.0)]);
        let (cosine, sine) = (graph.cosine(sum), graph.sine(x));
        // p y cos(x - 2 s + p) - sin x = 3, y² sin x cos(x - 2 s + p) = p²
        let first = graph.product(&[(p, 1), (y, 1), (cosine, 1)]);
        let first = graph.linear(-3.0, &[(first, 1.0), (sine, -1.0)]);
        let second = graph.product(&[(y, 2), (sine, 1), (cosine, 1)]);
        let square = graph.power(p, 2);
        let second = graph.linear(0.0, &[(second, 1.0), (square, -1.0)]);
        let equations = [first, second];
        let closure = closure_polynomials(&mut graph, &equations).expect("it is algebraic");
        let value = |symbol: Symbol| -> f64 {
            match symbol {
                Symbol::Parameter(_) => 1.7,
                Symbol::Input(_) => -0.4,
                Symbol::Unknown(0) => 2.3,
                _ => 0.6,
            }
        };
        let mut sums = [0.0; 2];
        for term in &closure.terms {
            let powers = term
                .powers
                .iter()
                .map(|&(symbol, power)| value(symbol).powi(i32::from(power)));
            let harmonic = match &term.harmonic {
                Harmonic::One => 1.0,
                Harmonic::Cosine(angle) | Harmonic::Sine(angle) => {
                    let whole: f64 = angle
                        .0
                        .iter()
                        .map(|&(symbol, multiple)| f64::from(multiple) * value(symbol))
                        .sum();
                    if matches!(term.harmonic, Harmonic::Cosine(_)) {
                        whole.cos()
                    } else {
                        whole.sin()
                    }
                }
            };
            let coefficient = graph.evaluate(closure.coefficients[usize::from(term.coefficient)], &value);
            sums[usize::from(term.equation)] += term.factor * coefficient * harmonic * powers.product::<f64>();
        }
        for (sum, equation) in sums.into_iter().zip(equations) {
            let expected = graph.evaluate(equation, &value);
            // the value has a few terms below three
            assert!((sum - expected).abs() < 30.0 * f64::EPSILON, "{sum} and not {expected}");
        }
    }

    /// An angle outside of a sine, and an input in a denominator, leave no polynomial.
    #[test]
    fn other_closures_have_no_polynomials() {
        let mut graph = Graph::new();
        let [p, s, x] = [Symbol::Parameter(0), Symbol::Input(0), Symbol::Unknown(0)].map(|symbol| graph.symbol(symbol));
        let angle = graph.multiply(p, x);
        let geared = graph.sine(angle);
        let quotient = graph.product(&[(x, 1), (s, -1)]);
        for equation in [geared, quotient] {
            assert!(closure_polynomials(&mut graph, &[equation]).is_none());
        }
    }
}
