//! A coupled block as a system of polynomials, all of whose solutions can be found.
//!
//! Each unknown angle becomes two variables, its cosine c and its sine s, with the equation c² + s² = 1. Each unknown
//! length becomes one variable. A block is not algebraic if an unknown occurs both inside and outside a sine.

use std::collections::{BTreeMap, BTreeSet};

use super::tear::Whole;
use super::{ClosedForm, body};
use crate::algebra::{
    Angle, Expansion, Function, Graph, Harmonic, Monomial, Node, NodeKind, Symbol, TrigonometricPolynomial, Variables,
};

/// The largest number of paths that are followed.
const LARGEST: usize = 1024;
/// The moduli of coefficients by which other equations are reduced.
const PIVOTS: [f64; 5] = [1.0, 2.0, 0.5, 4.0, 0.25];

/// The largest number of solutions of the equations of a [body](body::MovingBody): 40 poses, each by two triples of
/// angles.
const OF_BODY: usize = 80;

/// Polynomial equations for the unknowns of a block.
pub(crate) struct PolynomialSystem {
    /// The meaning of the variables.
    pub(crate) variables: Vec<PolynomialVariable>,
    pub(crate) form: SystemForm,
    /// The coefficients of the terms, free of the block's unknowns.
    pub(crate) coefficients: Vec<Node>,
    /// The relations that give the other unknowns of the block linearly.
    pub(crate) relations: Vec<ClosedForm>,
    /// The largest number of solutions.
    pub(crate) paths: usize,
}

/// The form of a system.
#[derive(Clone, PartialEq, Debug)]
pub enum SystemForm {
    /// The terms, equation by equation. There are at most as many solutions as the product of the degrees.
    Terms(Vec<PolynomialTerm>),
    /// The equations of a body, and the axes of its rotations.
    Body {
        /// An axis is 0, 1 or 2 for x, y or z.
        axes: [usize; 3],
    },
}

/// The meaning of one variable, or of two.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum PolynomialVariable {
    /// Cosine and sine of an unknown angle: two variables.
    Turning(usize),
    /// An unknown itself.
    Plain(usize),
}

/// A term of an equation.
#[derive(Clone, PartialEq, Debug)]
pub struct PolynomialTerm {
    /// The index of the equation.
    pub equation: usize,
    /// The index of the coefficient.
    pub coefficient: usize,
    /// Powers of variables, by index.
    pub powers: Vec<(usize, u32)>,
}

/// Powers of variables, by index.
type Powers = BTreeMap<usize, u32>;

/// The system of a block, if the block is algebraic and not too large.
pub(super) fn system(graph: &mut Graph, whole: Whole) -> Option<PolynomialSystem> {
    let unknowns = whole.unknowns.clone();
    let mut polynomials: Vec<TrigonometricPolynomial> = whole
        .equations
        .iter()
        .map(|&equation| {
            let polynomial = Expansion::new(graph, Variables::Unknowns(&unknowns)).equation(equation);
            squared(graph, &polynomial)
                .map(|square| Expansion::new(graph, Variables::Unknowns(&unknowns)).equation(square))
                .unwrap_or(polynomial)
        })
        .collect();
    let (mut turning, mut plain) = (BTreeSet::new(), BTreeSet::new());
    for monomial in polynomials.iter().flat_map(|polynomial| polynomial.0.keys()) {
        for (&atom, &power) in &monomial.powers {
            let Some(Symbol::Unknown(unknown)) = graph.as_symbol(atom) else {
                return None;
            };
            if power < 0 {
                return None;
            }
            plain.insert(unknown);
        }
        if let Harmonic::Cosine(angle) | Harmonic::Sine(angle) = &monomial.harmonic {
            turning.extend(angle.0.iter().filter_map(|&(symbol, _)| match symbol {
                Symbol::Unknown(unknown) => Some(unknown),
                _ => None,
            }));
        }
    }
    if !turning.is_disjoint(&plain) {
        return None;
    }
    if let Some(system) = of_body(graph, &polynomials, &turning, &plain) {
        return Some(PolynomialSystem {
            relations: whole.relations,
            ..system
        });
    }
    let mut indices = BTreeMap::new();
    let mut variables = Vec::new();
    let mut count = 0;
    for &unknown in &unknowns {
        indices.insert(unknown, count);
        if turning.contains(&unknown) {
            variables.push(PolynomialVariable::Turning(unknown));
            count += 2;
        } else {
            variables.push(PolynomialVariable::Plain(unknown));
            count += 1;
        }
    }
    lower(graph, &mut polynomials);
    // each unknown angle adds an equation of the second degree
    let circles = turning.iter().map(|_| 2);
    let paths = polynomials
        .iter()
        .map(degree)
        .chain(circles)
        .fold(1, usize::saturating_mul);
    if !(1..=LARGEST).contains(&paths) {
        return None;
    }
    let mut table = TermTable::default();
    let mut equations = 0;
    for polynomial in &polynomials {
        table.equation(graph, equations, polynomial, &indices);
        equations += 1;
    }
    let one = graph.one();
    let minus_one = graph.number(-1.0);
    for unknown in turning {
        let index = indices[&unknown];
        for square in [index, index + 1] {
            table.term(equations, one, Powers::from([(square, 2)]));
        }
        table.term(equations, minus_one, Powers::new());
        equations += 1;
    }
    Some(PolynomialSystem {
        variables,
        form: SystemForm::Terms(table.terms),
        coefficients: table.coefficients,
        relations: whole.relations,
        paths,
    })
}

/// The system of a block that is the pose of a body.
fn of_body(
    graph: &mut Graph,
    polynomials: &[TrigonometricPolynomial],
    turning: &BTreeSet<usize>,
    plain: &BTreeSet<usize>,
) -> Option<PolynomialSystem> {
    let three = |unknowns: &BTreeSet<usize>| unknowns.iter().copied().collect::<Vec<_>>().try_into().ok();
    if polynomials.len() != 6 {
        return None;
    }
    let body = body::body(graph, polynomials, three(plain)?, three(turning)?)?;
    let coordinates = body.coordinates.map(PolynomialVariable::Plain);
    let angles = body.angles.map(PolynomialVariable::Turning);
    Some(PolynomialSystem {
        variables: coordinates.into_iter().chain(angles).collect(),
        form: SystemForm::Body { axes: body.axes },
        coefficients: body.coefficients,
        relations: Vec::new(),
        paths: OF_BODY,
    })
}

/// The equation s - g |g| == 0 for √s == g, where g is known, such as the length of a leg. Where g is negative, it has
/// no real solution with a positive s either.
fn squared(graph: &mut Graph, polynomial: &TrigonometricPolynomial) -> Option<Node> {
    let mut others = polynomial
        .0
        .iter()
        .filter(|(monomial, _)| **monomial != Monomial::one());
    let (Some((monomial, &coefficient)), None) = (others.next(), others.next()) else {
        return None;
    };
    let powers: Vec<(&Node, &i32)> = monomial.powers.iter().collect();
    let (Harmonic::One, &[(&root, 1)]) = (&monomial.harmonic, powers.as_slice()) else {
        return None;
    };
    let NodeKind::Call(Function::Sqrt, arguments) = graph.kind(root).clone() else {
        return None;
    };
    let free = polynomial.free_term(graph);
    let quotient = graph.divide(free, coefficient);
    let known = graph.negate(quotient);
    let square = graph.multiply(known, known);
    let modulus = graph.call(Function::Sqrt, &[square]);
    let product = graph.multiply(known, modulus);
    Some(graph.subtract(arguments[0], product))
}

/// Replaces equations by their differences with multiples of others where this lowers their degree: the difference of
/// two spheres is a plane.
///
/// In each round, an equation of the degree in question whose coefficient of some monomial of this degree is one of the
/// `PIVOTS` clears this monomial out of the others. Multiples of these are exact, so what cancels leaves no rounding.
fn lower(graph: &mut Graph, polynomials: &mut [TrigonometricPolynomial]) {
    let highest = polynomials.iter().map(degree).max().unwrap_or(0);
    for level in (2..=highest).rev() {
        let mut left: Vec<(usize, TrigonometricPolynomial)> = polynomials
            .iter()
            .cloned()
            .enumerate()
            .filter(|(_, polynomial)| degree(polynomial) == level)
            .collect();
        let pivot = |graph: &Graph, polynomial: &TrigonometricPolynomial| {
            let mut terms = polynomial.0.iter().filter(|(monomial, _)| monomial.degree() == level);
            terms.find_map(|(monomial, &coefficient)| {
                let number = graph.as_number(coefficient)?;
                PIVOTS.contains(&number.abs()).then(|| (monomial.clone(), number))
            })
        };
        while let Some((index, (monomial, number))) = left
            .iter()
            .enumerate()
            .find_map(|(index, (_, polynomial))| Some((index, pivot(graph, polynomial)?)))
        {
            let (_, cleared) = left.remove(index);
            for (equation, polynomial) in &mut left {
                let coefficient = polynomial.coefficient(graph, &monomial);
                let factor = graph.scale(-1.0 / number, coefficient);
                if !graph.is_zero(factor) {
                    polynomial.add(graph, &cleared, factor);
                    if degree(polynomial) < level {
                        polynomials[*equation] = polynomial.clone();
                    }
                }
            }
            left.retain(|(_, polynomial)| degree(polynomial) == level);
        }
    }
}

/// The degree of an equation in the variables. Terms with different harmonics are independent, so no term of the
/// highest degree cancels.
fn degree(polynomial: &TrigonometricPolynomial) -> usize {
    polynomial.0.keys().map(Monomial::degree).max().unwrap_or(0)
}

impl PolynomialSystem {
    /// The number of values in as many solutions as there are paths.
    pub(crate) fn room(&self) -> usize {
        let of_variable = |variable: &PolynomialVariable| match variable {
            PolynomialVariable::Turning(_) => 2,
            PolynomialVariable::Plain(_) => 1,
        };
        self.paths * self.variables.iter().map(of_variable).sum::<usize>()
    }
}

/// The terms of a system, and their coefficients.
#[derive(Default)]
struct TermTable {
    terms: Vec<PolynomialTerm>,
    coefficients: Vec<Node>,
}

impl TermTable {
    /// Adds the terms of an equation.
    fn equation(
        &mut self,
        graph: &mut Graph,
        equation: usize,
        polynomial: &TrigonometricPolynomial,
        indices: &BTreeMap<usize, usize>,
    ) {
        // collect like terms from different harmonics, such as those of a double angle
        let mut collected: BTreeMap<Powers, Node> = BTreeMap::new();
        for (monomial, &coefficient) in &polynomial.0 {
            for (powers, factor) in expanded(graph, monomial, indices) {
                let scaled = graph.scale(factor, coefficient);
                let before = collected.get(&powers).copied().unwrap_or_else(|| graph.zero());
                collected.insert(powers, graph.add(before, scaled));
            }
        }
        for (powers, coefficient) in collected {
            if !graph.is_zero(coefficient) {
                self.term(equation, coefficient, powers);
            }
        }
    }

    fn term(&mut self, equation: usize, coefficient: Node, powers: Powers) {
        let index = self
            .coefficients
            .iter()
            .position(|&known| known == coefficient)
            .unwrap_or_else(|| {
                self.coefficients.push(coefficient);
                self.coefficients.len() - 1
            });
        self.terms.push(PolynomialTerm {
            equation,
            coefficient: index,
            powers: powers.into_iter().collect(),
        });
    }
}

/// A monomial in the variables.
fn expanded(graph: &Graph, monomial: &Monomial, indices: &BTreeMap<usize, usize>) -> Vec<(Powers, f64)> {
    let mut plain = Powers::new();
    for (&atom, &power) in &monomial.powers {
        if let Some(Symbol::Unknown(unknown)) = graph.as_symbol(atom) {
            plain.insert(indices[&unknown], power.unsigned_abs());
        }
    }
    let parts = match &monomial.harmonic {
        Harmonic::One => return vec![(plain, 1.0)],
        Harmonic::Cosine(angle) => cosine_sine(angle, indices).0,
        Harmonic::Sine(angle) => cosine_sine(angle, indices).1,
    };
    parts
        .into_iter()
        .map(|(mut powers, factor)| {
            for (&index, &power) in &plain {
                *powers.entry(index).or_insert(0) += power;
            }
            (powers, factor)
        })
        .collect()
}

/// A polynomial with numeric coefficients.
type NumericPolynomial = BTreeMap<Powers, f64>;

/// cos and sin of an integer combination of angles, as polynomials in the cosines and sines of these angles: the parts
/// of Π (c + i s)ⁿ, with the conjugate for negative n.
fn cosine_sine(angle: &Angle, indices: &BTreeMap<usize, usize>) -> (NumericPolynomial, NumericPolynomial) {
    let mut cosine = NumericPolynomial::from([(Powers::new(), 1.0)]);
    let mut sine = NumericPolynomial::new();
    for &(symbol, multiple) in &angle.0 {
        let Symbol::Unknown(unknown) = symbol else {
            continue;
        };
        let index = indices[&unknown];
        let sign = f64::from(multiple.signum());
        for _ in 0..multiple.abs() {
            // (cosine + i sine) (c ± i s)
            let next = (
                sum(&times(&cosine, index, 1.0), &times(&sine, index + 1, -sign)),
                sum(&times(&sine, index, 1.0), &times(&cosine, index + 1, sign)),
            );
            (cosine, sine) = next;
        }
    }
    (cosine, sine)
}

/// A polynomial times a variable and a number.
fn times(polynomial: &NumericPolynomial, index: usize, factor: f64) -> NumericPolynomial {
    polynomial
        .iter()
        .map(|(powers, value)| {
            let mut powers = powers.clone();
            *powers.entry(index).or_insert(0) += 1;
            (powers, factor * value)
        })
        .collect()
}

fn sum(left: &NumericPolynomial, right: &NumericPolynomial) -> NumericPolynomial {
    let mut sum = left.clone();
    for (powers, value) in right {
        *sum.entry(powers.clone()).or_insert(0.0) += value;
    }
    sum.retain(|_, value| *value != 0.0);
    sum
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::{NumericPolynomial, PolynomialVariable, SystemForm, cosine_sine, system};
    use crate::algebra::{Angle, Function, Graph, Symbol};
    use crate::structure::tear::Whole;

    /// The polynomials of cosine and sine of a sum of multiples of angles have the right values at any angles.
    #[test]
    fn multiples_of_angles_are_polynomials_in_cosines_and_sines() {
        let angles = [0.7_f64, -2.1];
        let indices = BTreeMap::from([(4, 0), (6, 2)]);
        let variables = [angles[0].cos(), angles[0].sin(), angles[1].cos(), angles[1].sin()];
        let value = |polynomial: &NumericPolynomial| -> f64 {
            let term = |powers: &BTreeMap<usize, u32>| -> f64 {
                powers
                    .iter()
                    .map(|(&index, &power)| variables[index].powi(power.cast_signed()))
                    .product()
            };
            polynomial.iter().map(|(powers, factor)| factor * term(powers)).sum()
        };
        for multiples in [[1, 0], [-1, 0], [1, 1], [2, -1], [-3, 2], [0, 3]] {
            let symbols = [4, 6].map(Symbol::Unknown);
            let angle = Angle(
                symbols
                    .into_iter()
                    .zip(multiples)
                    .filter(|&(_, multiple)| multiple != 0)
                    .collect(),
            );
            let (cosine, sine) = cosine_sine(&angle, &indices);
            let whole = f64::from(multiples[0]) * angles[0] + f64::from(multiples[1]) * angles[1];
            // the absolute coefficients add up to less than 40
            assert!(
                (value(&cosine) - whole.cos()).abs() < 40.0 * f64::EPSILON,
                "{multiples:?}"
            );
            assert!(
                (value(&sine) - whole.sin()).abs() < 40.0 * f64::EPSILON,
                "{multiples:?}"
            );
        }
    }

    /// The polynomials of a block have the values of its equations for any values of the unknowns, and each angle adds
    /// its circle.
    #[test]
    fn a_system_is_its_equations() {
        let mut graph = Graph::new();
        let (parameter, values) = (1.7, [0.3_f64, 0.7, -1.1]);
        let [y, angle, z] = [0, 1, 2].map(|unknown| graph.symbol(Symbol::Unknown(unknown)));
        let p = graph.symbol(Symbol::Parameter(0));
        let (cosine, double) = (graph.cosine(angle), graph.scale(2.0, angle));
        let sine = graph.sine(double);
        // y z + p cos x = 1, z² + p y sin 2x = p, y + z cos x = p
        let (yz, pc) = (graph.multiply(y, z), graph.multiply(p, cosine));
        let first = graph.linear(-1.0, &[(yz, 1.0), (pc, 1.0)]);
        let (zz, pys) = (graph.power(z, 2), graph.product(&[(p, 1), (y, 1), (sine, 1)]));
        let second = graph.linear(0.0, &[(zz, 1.0), (pys, 1.0), (p, -1.0)]);
        let zc = graph.multiply(z, cosine);
        let third = graph.linear(0.0, &[(y, 1.0), (zc, 1.0), (p, -1.0)]);
        let equations = vec![first, second, third];
        let system = system(
            &mut graph,
            Whole {
                equations: equations.clone(),
                unknowns: vec![0, 1, 2],
                relations: Vec::new(),
            },
        )
        .expect("it is algebraic");
        assert_eq!(
            system.variables,
            [
                PolynomialVariable::Plain(0),
                PolynomialVariable::Turning(1),
                PolynomialVariable::Plain(2)
            ]
        );
        // of degrees 2, 3, 2, and a circle of degree 2
        assert_eq!(system.paths, 24);
        let symbols = |symbol: Symbol| match symbol {
            Symbol::Unknown(unknown) => values[unknown],
            _ => parameter,
        };
        let variables = [values[0], values[1].cos(), values[1].sin(), values[2]];
        let mut sums = [0.0; 4];
        let SystemForm::Terms(terms) = &system.form else {
            panic!("it is no body");
        };
        for term in terms {
            let powers = term
                .powers
                .iter()
                .map(|&(index, power)| variables[index].powi(power.cast_signed()));
            let coefficient = graph.evaluate(system.coefficients[term.coefficient], &symbols);
            sums[term.equation] += coefficient * powers.product::<f64>();
        }
        for (sum, equation) in sums.into_iter().zip(equations) {
            let expected = graph.evaluate(equation, &symbols);
            // the value has a few terms below two
            assert!((sum - expected).abs() < 20.0 * f64::EPSILON, "{sum} and not {expected}");
        }
        assert!(sums[3].abs() < 4.0 * f64::EPSILON, "cos² + sin² - 1 = {}", sums[3]);
    }

    /// Two circles are one circle and a line, also where the radius of one is a square root, and where a coefficient is
    /// not a number. What a circle has in common with a curve of the same degree but other terms stays.
    #[test]
    fn differences_lower_the_degree() {
        let mut graph = Graph::new();
        let [x, y] = [0, 1].map(|unknown| graph.symbol(Symbol::Unknown(unknown)));
        let [p, q] = [0, 1].map(|number| graph.symbol(Symbol::Parameter(number)));
        let squares = [x, y].map(|coordinate| graph.power(coordinate, 2));
        let [about_origin, moved] = [0.0, 1.0].map(|centre| {
            let along = graph.linear(-centre, &[(x, 1.0)]);
            let square = graph.power(along, 2);
            graph.add(square, squares[1])
        });
        let circle = graph.subtract(about_origin, p);
        let root = graph.call(Function::Sqrt, &[moved]);
        let by_root = graph.subtract(root, q);
        let multiple = graph.multiply(p, moved);
        let multiple = graph.subtract(multiple, q);
        let hyperbola = graph.linear(-1.0, &[(squares[0], 1.0), (squares[1], -1.0)]);
        for (second, paths) in [(by_root, 2), (multiple, 2), (hyperbola, 4)] {
            let whole = Whole {
                equations: vec![circle, second],
                unknowns: vec![0, 1],
                relations: Vec::new(),
            };
            let system = system(&mut graph, whole).expect("it is algebraic");
            assert_eq!(system.paths, paths);
            assert_eq!(system.room(), 2 * paths);
        }
    }
}
