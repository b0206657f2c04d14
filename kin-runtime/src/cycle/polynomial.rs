//! Polynomials in the cosines and sines of angles, and in lengths.

use alloc::collections::BTreeMap;
use alloc::vec;
use alloc::vec::Vec;

use num_traits::Float;

/// What a coefficient may be, relative to the largest of its polynomial, and still be rounding.
const ROUNDING: f64 = 1e-13;

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
                let first = count;
                count += if *kind == ClosureQuantity::Angle { 2 } else { 1 };
                first
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
}

/// Powers of variables, in ascending order of the variables.
type Powers = Vec<(u16, u8)>;

/// A polynomial: the coefficients of products of powers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct ClosurePolynomial {
    terms: BTreeMap<Powers, f64>,
}

impl ClosurePolynomial {
    pub(super) fn number(number: f64) -> Self {
        let mut polynomial = Self::default();
        polynomial.add(Vec::new(), number);
        polynomial
    }

    /// A variable by itself.
    pub(super) fn variable(variable: u16) -> Self {
        let mut polynomial = Self::default();
        polynomial.add(vec![(variable, 1)], 1.0);
        polynomial
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

    pub(super) fn times(&self, other: &Self) -> Self {
        let mut product = Self::default();
        product.add_product(self, other, 1.0);
        product
    }

    /// Adds another polynomial times a number.
    pub(super) fn add_multiple(&mut self, other: &Self, factor: f64) {
        for (powers, coefficient) in &other.terms {
            self.add(powers.clone(), factor * coefficient);
        }
    }

    /// Adds the product of two polynomials and a number.
    fn add_product(&mut self, one: &Self, other: &Self, factor: f64) {
        for (powers, coefficient) in &one.terms {
            for (others, other_coefficient) in &other.terms {
                self.add(product(powers, others), factor * coefficient * other_coefficient);
            }
        }
    }

    /// This polynomial plus another one times a number.
    pub(super) fn plus(&self, other: &Self, factor: f64) -> Self {
        let mut sum = self.clone();
        sum.add_multiple(other, factor);
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
                let Some(index) = powers.iter().position(|(factor, _)| *factor == variable) else {
                    continue;
                };
                let mut less = powers.clone();
                let power = less[index].1;
                if power == 1 {
                    less.remove(index);
                } else {
                    less[index].1 -= 1;
                }
                let factor: Powers = other.map(|other| (other, 1)).into_iter().collect();
                sum.add(product(&less, &factor), sign * f64::from(power) * coefficient);
            }
        }
        sum.tidy();
        sum
    }

    /// The same function of the angles without squares of sines: sin² is 1 - cos².
    pub(super) fn reduced(&self, quantities: &Quantities) -> Self {
        let mut reduced = Self::default();
        let mut waiting: Vec<(Powers, f64)> = self.terms.clone().into_iter().collect();
        while let Some((powers, coefficient)) = waiting.pop() {
            let is_sine = |variable: u16| {
                let quantity = quantities.quantity(variable);
                quantities.kind(quantity) == ClosureQuantity::Angle && variable > quantities.first(quantity)
            };
            let Some(index) = powers.iter().position(|&(factor, power)| power > 1 && is_sine(factor)) else {
                reduced.add(powers, coefficient);
                continue;
            };
            let cosine = powers[index].0 - 1;
            let mut less = powers;
            less[index].1 -= 2;
            less.retain(|(_, power)| *power > 0);
            waiting.push((product(&less, &vec![(cosine, 2)]), -coefficient));
            waiting.push((less, coefficient));
        }
        reduced.tidy();
        reduced
    }

    /// Removes terms that are rounding.
    pub(super) fn tidy(&mut self) {
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
        match product.binary_search_by_key(&variable, |(factor, _)| *factor) {
            Ok(index) => product[index].1 += power,
            Err(index) => product.insert(index, (variable, power)),
        }
    }
    product
}

/// The determinant of a square matrix, by rows: the minors of its first rows with each choice of columns.
pub(super) fn determinant(matrix: &[Vec<ClosurePolynomial>]) -> ClosurePolynomial {
    let mut minors = BTreeMap::from([(0_u32, ClosurePolynomial::number(1.0))]);
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

#[cfg(test)]
mod tests {
    use std::vec;
    use std::vec::Vec;

    use super::{ClosurePolynomial, ClosureQuantity, Quantities, determinant};

    fn quantities() -> Quantities {
        Quantities::new(vec![
            ClosureQuantity::Angle,
            ClosureQuantity::Plain,
            ClosureQuantity::Angle,
        ])
    }

    fn polynomial(terms: &[(&[(u16, u8)], f64)]) -> ClosurePolynomial {
        let mut polynomial = ClosurePolynomial::default();
        for (powers, coefficient) in terms {
            polynomial.add(powers.to_vec(), *coefficient);
        }
        polynomial
    }

    /// Derivatives and determinants have the values that a formula gives.
    #[test]
    fn derivatives_and_determinants_are_right() {
        let quantities = quantities();
        let equations = [
            // 2 cos angle + length sin other
            polynomial(&[(&[(0, 1)], 2.0), (&[(2, 1), (4, 1)], 1.0)]),
            // sin angle - length cos other
            polynomial(&[(&[(1, 1)], 1.0), (&[(2, 1), (3, 1)], -1.0)]),
            // length² + sin(angle - other)
            polynomial(&[(&[(2, 2)], 1.0), (&[(1, 1), (3, 1)], 1.0), (&[(0, 1), (4, 1)], -1.0)]),
        ];
        let matrix: Vec<Vec<ClosurePolynomial>> = equations
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

    /// Squares of sines are replaced, so that a sum of squares of a sine and its cosine is a number.
    #[test]
    fn a_sum_of_squares_is_a_number() {
        let quantities = quantities();
        // the cosine and the sine of angle + other, times 3
        let cosine = polynomial(&[(&[(0, 1), (3, 1)], 3.0), (&[(1, 1), (4, 1)], -3.0)]);
        let sine = polynomial(&[(&[(1, 1), (3, 1)], 3.0), (&[(0, 1), (4, 1)], 3.0)]);
        let mut squares = cosine.times(&cosine);
        squares.add_multiple(&sine.times(&sine), 1.0);
        assert_eq!(squares.reduced(&quantities), ClosurePolynomial::number(9.0));
        let fourth = polynomial(&[(&[(1, 4), (2, 3)], 1.0)]);
        let expected = polynomial(&[(&[(2, 3)], 1.0), (&[(0, 2), (2, 3)], -2.0), (&[(0, 4), (2, 3)], 1.0)]);
        assert_eq!(fourth.reduced(&quantities), expected);
    }
}
