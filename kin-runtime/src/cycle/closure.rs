//! The closure of a mechanism over a line of inputs as polynomials, from the terms that its declaration states.

use alloc::vec;
use alloc::vec::Vec;

use num_traits::{Float, ToPrimitive};

use super::polynomial::{ClosurePolynomial, ClosureQuantity, Quantities};
use crate::mechanism::{ClosureHarmonic, ClosureTerm};

/// The largest sum of the multiples of an angle that is taken apart: the binomial coefficients of a larger one have
/// more digits than a number.
const MOST_MULTIPLES: u32 = 32;

/// The terms of a closure with their coefficients, where the inputs are `from + direction v`.
#[derive(Clone, Copy)]
pub(super) struct ClosureOnLine<'a> {
    pub(super) terms: &'a [ClosureTerm<'a>],
    pub(super) coefficients: &'a [f64],
    pub(super) from: &'a [f64],
    pub(super) direction: &'a [f64],
}

/// The closure as polynomials of an input and the unknowns.
pub(super) struct Closure {
    pub(super) quantities: Quantities,
    pub(super) equations: Vec<ClosurePolynomial>,
    /// The unknown angle, as a quantity, that was added to the input times the sign.
    pub(super) added: Option<(usize, i32)>,
    /// The unknown angle, as a quantity, that is the direction of the input, a length, and whose cosine and sine occur
    /// with it only. Their products with the input replace its variables.
    pub(super) slide_angle: Option<usize>,
}

impl Closure {
    /// The closure whose first quantity is the input, v, or v plus or minus an unknown angle, whichever makes the
    /// lowest degrees. The angle of a motor between two links is a difference of their angles, for example.
    ///
    /// It is `None` if v, where it is an angle, or an unknown angle occurs outside of sines and cosines, or if a sine
    /// does not repeat itself after a revolution of v.
    pub(super) fn new(quantities: &Quantities, on_line: ClosureOnLine<'_>) -> Option<Self> {
        let count = quantities.len();
        let mut best: Option<(usize, Self)> = None;
        let angles = (1..count).filter(|quantity| quantities.kind(*quantity) == ClosureQuantity::Angle);
        let sums = angles.flat_map(|angle| [Some((angle, 1)), Some((angle, -1))]);
        for added in core::iter::once(None).chain(sums) {
            if added.is_some() && quantities.kind(0) != ClosureQuantity::Angle {
                break;
            }
            let Some(equations) = on_line.equations(quantities, added) else {
                continue;
            };
            let degree = equations.iter().map(ClosurePolynomial::degree).sum();
            if best.as_ref().is_none_or(|(known, _)| degree < *known) {
                let closure = Self {
                    quantities: quantities.clone(),
                    equations,
                    added,
                    slide_angle: None,
                };
                best = Some((degree, closure));
            }
            if degree < count {
                break;
            }
        }
        best.map(|(_, closure)| closure.with_the_link_of_the_input())
    }

    /// The closure with the coordinates of the input's link as variables, if the input is the length of a rotating
    /// link.
    fn with_the_link_of_the_input(mut self) -> Self {
        let input = self.quantities.first(0);
        let is_input = |&(variable, _): &(u16, u8)| variable == input;
        let angle = self
            .equations
            .iter()
            .flat_map(ClosurePolynomial::terms)
            .find_map(|(powers, _)| {
                let other = powers.iter().find(|factor| !is_input(factor))?;
                powers.iter().any(is_input).then(|| self.quantities.quantity(other.0))
            });
        let Some(angle) = angle.filter(|_| self.quantities.kind(0) == ClosureQuantity::Plain) else {
            return self;
        };
        let is_angle = |&(variable, _): &(u16, u8)| self.quantities.quantity(variable) == angle;
        let is_product = self
            .equations
            .iter()
            .flat_map(ClosurePolynomial::terms)
            .all(|(powers, _)| {
                let degree = |counts: &dyn Fn(&(u16, u8)) -> bool| -> u32 {
                    let factors = powers.iter().filter(|factor| counts(factor));
                    factors.map(|(_, power)| u32::from(*power)).sum()
                };
                matches!((degree(&is_input), degree(&is_angle)), (0, 0) | (1, 1))
            });
        if is_product && self.quantities.kind(angle) == ClosureQuantity::Angle {
            let without = |equation: &ClosurePolynomial| {
                let mut reduced = ClosurePolynomial::default();
                for (powers, coefficient) in equation.terms() {
                    let others = powers.iter().filter(|factor| !is_input(factor));
                    reduced.add(others.copied().collect(), coefficient);
                }
                reduced
            };
            self.equations = self.equations.iter().map(without).collect();
            self.slide_angle = Some(angle);
        }
        self
    }

    /// The derivative of an equation with respect to an unknown, while the input stands still.
    pub(super) fn derivative(&self, equation: usize, quantity: usize) -> ClosurePolynomial {
        let derivative = self.equations[equation].derivative(&self.quantities, quantity);
        match self.added {
            Some((added, sign)) if added == quantity => derivative.plus(
                &self.equations[equation].derivative(&self.quantities, 0),
                f64::from(sign),
            ),
            _ => derivative,
        }
    }
}

impl ClosureOnLine<'_> {
    /// The equations as polynomials in v plus the added angle times its sign, and in the unknowns.
    fn equations(&self, quantities: &Quantities, added: Option<(usize, i32)>) -> Option<Vec<ClosurePolynomial>> {
        let mut equations = vec![ClosurePolynomial::default(); quantities.len() - 1];
        for term in self.terms {
            let polynomial = self.polynomial(quantities, added, term)?;
            equations
                .get_mut(usize::from(term.equation))?
                .add_multiple(&polynomial, 1.0);
        }
        equations.iter_mut().for_each(ClosurePolynomial::tidy);
        Some(equations)
    }

    fn polynomial(
        &self,
        quantities: &Quantities,
        added: Option<(usize, i32)>,
        term: &ClosureTerm<'_>,
    ) -> Option<ClosurePolynomial> {
        let coefficient = term.factor * self.coefficients.get(usize::from(term.coefficient))?;
        if !coefficient.is_finite() {
            return None;
        }
        let inputs = self.from.len();
        let mut whole = ClosurePolynomial::number(coefficient);
        for &(quantity, power) in term.powers {
            let quantity = usize::from(quantity);
            let factor = match quantity.checked_sub(inputs) {
                Some(unknown) => plain(quantities, unknown + 1)?,
                None if self.direction[quantity] == 0.0 => ClosurePolynomial::number(self.from[quantity]),
                None => {
                    let mut input = ClosurePolynomial::number(self.from[quantity]);
                    input.add_multiple(&plain(quantities, 0)?, self.direction[quantity]);
                    input
                }
            };
            for _ in 0..power {
                whole = whole.times(&factor);
            }
        }
        let (angle, is_cosine) = match term.harmonic {
            ClosureHarmonic::One => return Some(whole),
            ClosureHarmonic::Cosine(angle) => (angle, true),
            ClosureHarmonic::Sine(angle) => (angle, false),
        };
        // The angle is a phase plus multiples of the quantities.
        let (mut phase, mut rate) = (0.0, 0.0);
        let mut multiples = vec![0; quantities.len()];
        for &(quantity, multiple) in angle {
            let quantity = usize::from(quantity);
            if let Some(unknown) = quantity.checked_sub(inputs) {
                multiples[unknown + 1] += i32::from(multiple);
            } else {
                phase += f64::from(multiple) * self.from[quantity];
                rate += f64::from(multiple) * self.direction[quantity];
            }
        }
        multiples[0] = rate.to_i8().map(i32::from).filter(|whole| f64::from(*whole) == rate)?;
        if let Some((added, sign)) = added {
            multiples[added] -= sign * multiples[0];
        }
        let [cosine, sine] = cosine_sine(quantities, phase, &multiples)?;
        Some(whole.times(if is_cosine { &cosine } else { &sine }))
    }
}

/// A quantity that is no angle.
fn plain(quantities: &Quantities, quantity: usize) -> Option<ClosurePolynomial> {
    let is_plain = quantities.kind(quantity) == ClosureQuantity::Plain;
    is_plain.then(|| ClosurePolynomial::variable(quantities.first(quantity)))
}

/// Cosine and sine of a phase plus multiples of angles: the parts of the product of their unit vectors.
fn cosine_sine(quantities: &Quantities, phase: f64, multiples: &[i32]) -> Option<[ClosurePolynomial; 2]> {
    if multiples.iter().map(|multiple| multiple.unsigned_abs()).sum::<u32>() > MOST_MULTIPLES {
        return None;
    }
    let mut unit = [Float::cos(phase), Float::sin(phase)].map(ClosurePolynomial::number);
    for (quantity, multiple) in multiples.iter().enumerate().filter(|(_, multiple)| **multiple != 0) {
        if quantities.kind(quantity) != ClosureQuantity::Angle {
            return None;
        }
        let first = quantities.first(quantity);
        let [cosine, sine] = [first, first + 1].map(ClosurePolynomial::variable);
        let sign = f64::from(multiple.signum());
        for _ in 0..multiple.unsigned_abs() {
            let [x, y] = &unit;
            let (mut along, mut across) = (x.times(&cosine), y.times(&cosine));
            along.add_multiple(&y.times(&sine), -sign);
            across.add_multiple(&x.times(&sine), sign);
            unit = [along, across];
        }
    }
    Some(unit)
}
