//! The closure of a mechanism as polynomials in the cosines and sines of its angles, and in its lengths, found from its values.

use alloc::collections::BTreeMap;
use alloc::vec;
use alloc::vec::Vec;

use num_traits::Float;

/// What a coefficient may be, relative to the largest value of its equation, and still be rounding.
const ROUNDING: f64 = 1e-13;
/// The largest difference of the polynomials from the closure, relative to its largest value.
const AGREEMENT: f64 = 1e-11;
/// The number of places at which polynomials and closure are compared.
const PLACES: u32 = 5;

/// A quantity of the closure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ClosureQuantity {
    /// An angle. Its cosine and its sine are two variables.
    Angle,
    /// A length or a number, which is a variable itself.
    Plain,
}

/// The quantities of a closure, each with the index of its first variable.
#[derive(Clone, Debug)]
pub(super) struct Quantities {
    kinds: Vec<ClosureQuantity>,
    first: Vec<u16>,
}

impl Quantities {
    pub(super) fn new(kinds: Vec<ClosureQuantity>) -> Self {
        let mut count = 0;
        let first = kinds
            .iter()
            .map(|kind| {
                let own = count;
                count += if *kind == ClosureQuantity::Angle { 2 } else { 1 };
                own
            })
            .collect();
        Self { kinds, first }
    }

    /// The number of quantities.
    pub(super) fn len(&self) -> usize {
        self.kinds.len()
    }

    pub(super) fn kind(&self, quantity: usize) -> ClosureQuantity {
        self.kinds[quantity]
    }

    /// The index of the first variable of a quantity.
    pub(super) fn first(&self, quantity: usize) -> u16 {
        self.first[quantity]
    }

    /// The quantity to which a variable belongs.
    pub(super) fn quantity(&self, variable: u16) -> usize {
        self.first.partition_point(|first| *first <= variable).saturating_sub(1)
    }

    pub(super) fn variables(&self, values: &[f64]) -> Vec<f64> {
        let quantities = self.kinds.iter().zip(values);
        let variables = quantities.map(|(kind, value)| match kind {
            ClosureQuantity::Angle => vec![Float::cos(*value), Float::sin(*value)],
            ClosureQuantity::Plain => vec![*value],
        });
        variables.flatten().collect()
    }

    /// The function of a quantity, of three, that is not constant and belongs to a power of its variables.
    fn powers(&self, quantity: usize, function: usize) -> (u16, u8) {
        let first = self.first[quantity];
        match (self.kinds[quantity], function) {
            (ClosureQuantity::Angle | ClosureQuantity::Plain, 1) => (first, 1),
            (ClosureQuantity::Angle, _) => (first + 1, 1),
            (ClosureQuantity::Plain, _) => (first, 2),
        }
    }
}

/// Powers of variables, in ascending order of the variables.
type Powers = Vec<(u16, u8)>;

/// A polynomial: the coefficients of products of powers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct ClosurePolynomial {
    terms: BTreeMap<Powers, f64>,
}

impl ClosurePolynomial {
    fn one() -> Self {
        let mut one = Self::default();
        one.add(Vec::new(), 1.0);
        one
    }

    pub(super) fn terms(&self) -> impl Iterator<Item = (&[(u16, u8)], f64)> {
        self.terms
            .iter()
            .map(|(powers, coefficient)| (powers.as_slice(), *coefficient))
    }

    pub(super) fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The largest sum of the powers of a term.
    pub(super) fn degree(&self) -> usize {
        let degrees = self
            .terms
            .keys()
            .map(|powers| powers.iter().map(|(_, power)| usize::from(*power)).sum());
        degrees.max().unwrap_or(0)
    }

    pub(super) fn add(&mut self, powers: Powers, coefficient: f64) {
        *self.terms.entry(powers).or_insert(0.0) += coefficient;
    }

    pub(super) fn value(&self, variables: &[f64]) -> f64 {
        self.terms().fold(0.0, |sum, (powers, coefficient)| {
            let factors = powers
                .iter()
                .map(|&(variable, power)| Float::powi(variables[usize::from(variable)], i32::from(power)));
            sum + factors.fold(coefficient, |product, factor| product * factor)
        })
    }

    /// Adds the product of two polynomials and a number.
    fn add_product(&mut self, one: &Self, other: &Self, factor: f64) {
        for (powers, coefficient) in &one.terms {
            for (others, own) in &other.terms {
                self.add(product(powers, others), factor * coefficient * own);
            }
        }
    }

    /// This polynomial plus another one times a number.
    pub(super) fn plus(&self, other: &Self, factor: f64) -> Self {
        let mut sum = self.clone();
        for (powers, coefficient) in &other.terms {
            sum.add(powers.clone(), factor * coefficient);
        }
        sum.tidy();
        sum
    }

    /// The coefficient of a product of powers.
    pub(super) fn coefficient(&self, powers: &[(u16, u8)]) -> f64 {
        self.terms.get(powers).copied().unwrap_or(0.0)
    }

    /// The derivative with respect to a quantity.
    pub(super) fn derivative(&self, quantities: &Quantities, quantity: usize) -> Self {
        let mut sum = Self::default();
        let first = quantities.first(quantity);
        // The derivatives of cosine and sine are the other one, with a sign.
        let others: &[(u16, Option<u16>, f64)] = match quantities.kind(quantity) {
            ClosureQuantity::Angle => &[(first, Some(first + 1), -1.0), (first + 1, Some(first), 1.0)],
            ClosureQuantity::Plain => &[(first, None, 1.0)],
        };
        for (powers, coefficient) in &self.terms {
            for &(variable, other, sign) in others {
                let Some(place) = powers.iter().position(|(own, _)| *own == variable) else {
                    continue;
                };
                let mut less = powers.clone();
                let power = less[place].1;
                if power == 1 {
                    less.remove(place);
                } else {
                    less[place].1 -= 1;
                }
                let factor: Powers = other.map(|other| (other, 1)).into_iter().collect();
                sum.add(product(&less, &factor), sign * f64::from(power) * coefficient);
            }
        }
        sum.tidy();
        sum
    }

    /// Whether this is another polynomial times a number, up to rounding.
    pub(super) fn is_multiple(&self, other: &Self, number: f64) -> bool {
        self.terms.len() == other.terms.len()
            && self.terms.iter().all(|(powers, value)| {
                let expected = other.terms.get(powers).map(|own| number * own);
                expected.is_some_and(|expected| (value - expected).abs() <= AGREEMENT * value.abs())
            })
    }

    /// Removes terms that are rounding.
    fn tidy(&mut self) {
        let largest = self
            .terms
            .values()
            .fold(0.0_f64, |largest, value| largest.max(value.abs()));
        self.terms.retain(|_, value| value.abs() > ROUNDING * largest);
    }
}

fn product(one: &Powers, other: &Powers) -> Powers {
    let mut product = one.clone();
    for &(variable, power) in other {
        match product.binary_search_by_key(&variable, |(own, _)| *own) {
            Ok(place) => product[place].1 += power,
            Err(place) => product.insert(place, (variable, power)),
        }
    }
    product
}

/// The determinant of a square matrix, by rows: the minors of its first rows with each choice of columns.
pub(super) fn determinant(matrix: &[Vec<ClosurePolynomial>]) -> ClosurePolynomial {
    let mut minors = BTreeMap::from([(0_u32, ClosurePolynomial::one())]);
    for row in matrix {
        let mut next: BTreeMap<u32, ClosurePolynomial> = BTreeMap::new();
        for (columns, minor) in &minors {
            for (column, entry) in row.iter().enumerate() {
                let bit = 1 << column;
                if columns & bit == 0 && !entry.is_zero() {
                    // Each chosen column to the right of the new one is an exchange.
                    let exchanges = (columns >> column).count_ones();
                    let sign = if exchanges % 2 == 0 { 1.0 } else { -1.0 };
                    next.entry(columns | bit).or_default().add_product(minor, entry, sign);
                }
            }
        }
        minors = next;
        for minor in minors.values_mut() {
            minor.tidy();
        }
    }
    minors.into_values().next().unwrap_or_default()
}

/// The equations of a closure as polynomials. An equation that is none, or that has a product of more than two quantities, is `None`.
///
/// `closure` writes the values of the equations for values of the quantities. `size` is the size of lengths.
pub(super) fn polynomials(
    quantities: &Quantities,
    size: f64,
    equations: usize,
    closure: &mut dyn FnMut(&[f64], &mut [f64]),
) -> Vec<Option<ClosurePolynomial>> {
    let count = quantities.kinds.len();
    let place = |place: u32, quantity: usize| {
        let mixed = Float::sin(12.9898 * (super::line::count(quantity) + 1.7) * (f64::from(place) + 0.5));
        match quantities.kinds[quantity] {
            ClosureQuantity::Angle => 3.0 * mixed,
            ClosureQuantity::Plain => size * mixed,
        }
    };
    let anchor: Vec<f64> = (0..count).map(|quantity| place(0, quantity)).collect();
    let node = |quantity: usize, node: usize| match (quantities.kinds[quantity], node) {
        (ClosureQuantity::Angle, 0) => 0.0,
        (ClosureQuantity::Angle, 1) => core::f64::consts::PI,
        (ClosureQuantity::Angle, _) => core::f64::consts::FRAC_PI_2,
        (ClosureQuantity::Plain, 0) => size,
        (ClosureQuantity::Plain, 1) => -size,
        (ClosureQuantity::Plain, _) => 0.0,
    };
    // The coefficients of the three functions of a quantity, from the values at its nodes.
    let coefficients = |quantity: usize, [first, opposite, middle]: [f64; 3]| {
        let (half, mean) = (0.5 * (first - opposite), 0.5 * (first + opposite));
        match quantities.kinds[quantity] {
            ClosureQuantity::Angle => [mean, half, middle - mean],
            ClosureQuantity::Plain => [middle, half / size, (mean - middle) / (size * size)],
        }
    };
    let mut values = vec![0.0; equations];
    let mut largest = vec![0.0_f64; equations];
    let mut found = vec![ClosurePolynomial::default(); equations];
    let scale = |quantity: usize, function: usize| match quantities.kinds[quantity] {
        ClosureQuantity::Angle => 1.0,
        ClosureQuantity::Plain => Float::powi(size, i32::from(function == 1) + 2 * i32::from(function == 2)),
    };

    for one in 0..count {
        for other in one + 1..count {
            let mut grid = vec![[[0.0; 3]; 3]; equations];
            for (row, column) in (0..9).map(|node| (node / 3, node % 3)) {
                let mut at = anchor.clone();
                (at[one], at[other]) = (node(one, row), node(other, column));
                closure(&at, &mut values);
                for equation in 0..equations {
                    grid[equation][row][column] = values[equation];
                    largest[equation] = largest[equation].max(values[equation].abs());
                }
            }
            for (equation, grid) in grid.into_iter().enumerate() {
                let rows = grid.map(|row| coefficients(other, row));
                for second in 1..3 {
                    let along = coefficients(one, rows.map(|row| row[second]));
                    for (first, coefficient) in along.into_iter().enumerate().skip(1) {
                        if (coefficient * scale(one, first) * scale(other, second)).abs() > ROUNDING * largest[equation]
                        {
                            let powers = vec![quantities.powers(one, first), quantities.powers(other, second)];
                            found[equation].add(powers, coefficient);
                        }
                    }
                }
            }
        }
    }
    let rest =
        |at: &[f64], values: &mut [f64], closure: &mut dyn FnMut(&[f64], &mut [f64]), found: &[ClosurePolynomial]| {
            closure(at, values);
            let variables = quantities.variables(at);
            for (value, polynomial) in values.iter_mut().zip(found) {
                *value -= polynomial.value(&variables);
            }
        };
    let mut singles = vec![ClosurePolynomial::default(); equations];
    for quantity in 0..count {
        let mut nodes = vec![[0.0; 3]; equations];
        for which in 0..3 {
            let mut at = anchor.clone();
            at[quantity] = node(quantity, which);
            rest(&at, &mut values, closure, &found);
            for (nodes, value) in nodes.iter_mut().zip(&values) {
                nodes[which] = *value;
            }
        }
        for (equation, nodes) in nodes.into_iter().enumerate() {
            for (function, coefficient) in coefficients(quantity, nodes).into_iter().enumerate().skip(1) {
                if (coefficient * scale(quantity, function)).abs() > ROUNDING * largest[equation] {
                    singles[equation].add(vec![quantities.powers(quantity, function)], coefficient);
                }
            }
        }
    }
    for (polynomial, single) in found.iter_mut().zip(singles) {
        polynomial.terms.extend(single.terms);
    }
    rest(&anchor, &mut values, closure, &found);
    for (equation, value) in values.iter().enumerate() {
        if value.abs() > ROUNDING * largest[equation] {
            found[equation].add(Vec::new(), *value);
        }
    }
    let mut agrees = vec![true; equations];
    for number in 1..=PLACES {
        let at: Vec<f64> = (0..count).map(|quantity| place(number, quantity)).collect();
        rest(&at, &mut values, closure, &found);
        for (equation, value) in values.iter().enumerate() {
            agrees[equation] &= value.abs() <= AGREEMENT * largest[equation];
        }
    }
    let all = found.into_iter().zip(agrees);
    all.map(|(polynomial, agrees)| agrees.then_some(polynomial)).collect()
}

#[cfg(test)]
mod tests {
    use std::vec;
    use std::vec::Vec;

    use super::{ClosurePolynomial, ClosureQuantity, Quantities, determinant, polynomials};

    fn quantities() -> Quantities {
        Quantities::new(vec![
            ClosureQuantity::Angle,
            ClosureQuantity::Plain,
            ClosureQuantity::Angle,
        ])
    }

    /// Equations of sums and products of two quantities are found, and others are not.
    #[test]
    fn closures_are_polynomials() {
        let quantities = quantities();
        let mut closure = |at: &[f64], values: &mut [f64]| {
            let [angle, length, other] = at[..] else { return };
            values[0] = 2.0 * angle.cos() + length * other.sin() - 0.5;
            values[1] = length * length - 3.0 * (angle - other).cos();
            values[2] = length * angle.cos() * other.cos();
            values[3] = other - angle.sin();
        };
        let found = polynomials(&quantities, 4.0, 4, &mut closure);
        let terms = |index: usize| -> Vec<(Vec<(u16, u8)>, f64)> {
            let polynomial = found[index].as_ref().unwrap();
            polynomial
                .terms()
                .map(|(powers, value)| (powers.into(), (1e12 * value).round() / 1e12))
                .collect()
        };
        assert_eq!(
            terms(0),
            [(vec![], -0.5), (vec![(0, 1)], 2.0), (vec![(2, 1), (4, 1)], 1.0)]
        );
        assert_eq!(
            terms(1),
            [
                (vec![(0, 1), (3, 1)], -3.0),
                (vec![(1, 1), (4, 1)], -3.0),
                (vec![(2, 2)], 1.0)
            ]
        );
        assert!(found[2].is_none() && found[3].is_none());
    }

    /// Derivatives and determinants have the values that differences and a formula give.
    #[test]
    fn derivatives_and_determinants_are_right() {
        let quantities = quantities();
        let mut closure = |at: &[f64], values: &mut [f64]| {
            let [angle, length, other] = at[..] else { return };
            values[0] = 2.0 * angle.cos() + length * other.sin();
            values[1] = angle.sin() - length * other.cos();
            values[2] = length * length + (angle - other).sin();
        };
        let found: Vec<ClosurePolynomial> = polynomials(&quantities, 1.0, 3, &mut closure)
            .into_iter()
            .flatten()
            .collect();
        let matrix: Vec<Vec<ClosurePolynomial>> = found
            .iter()
            .map(|equation| {
                (0..3)
                    .map(|quantity| equation.derivative(&quantities, quantity))
                    .collect()
            })
            .collect();
        let (angle, length, other) = (0.7_f64, 1.3, -0.4_f64);
        let difference = angle - other;
        let rows = [
            [-2.0 * angle.sin(), other.sin(), length * other.cos()],
            [angle.cos(), -other.cos(), length * other.sin()],
            [difference.cos(), 2.0 * length, -difference.cos()],
        ];
        let cross = |one: [f64; 3], two: [f64; 3]| {
            [
                one[1] * two[2] - one[2] * two[1],
                one[2] * two[0] - one[0] * two[2],
                one[0] * two[1] - one[1] * two[0],
            ]
        };
        let normal = cross(rows[1], rows[2]);
        let expected: f64 = rows[0].iter().zip(normal).map(|(a, b)| a * b).sum();
        let variables = quantities.variables(&[angle, length, other]);
        let value = determinant(&matrix).value(&variables);
        assert!((value - expected).abs() < 1e-13, "{value} {expected}");
    }
}
