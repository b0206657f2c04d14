//! Tables of systems that are known only when a test runs.

use std::boxed::Box;
use std::vec::Vec;

use super::super::{PolynomialSystem, Term};

/// Terms, each with a separate coefficient.
#[derive(Default)]
pub(super) struct Table {
    terms: Vec<Term>,
    pub(super) coefficients: Vec<f64>,
}

impl Table {
    pub(super) fn add(&mut self, equation: usize, coefficient: f64, powers: &[(u16, u8)]) {
        self.terms.push(Term::new(
            u16::try_from(equation).unwrap(),
            u16::try_from(self.coefficients.len()).unwrap(),
            Box::leak(powers.into()),
        ));
        self.coefficients.push(coefficient);
    }

    /// Adds c² + s² = 1 for the variables 2k and 2k + 1 of the angle k.
    pub(super) fn add_angle(&mut self, equation: usize, angle: u16) {
        self.add(equation, 1.0, &[(2 * angle, 2)]);
        self.add(equation, 1.0, &[(2 * angle + 1, 2)]);
        self.add(equation, -1.0, &[]);
    }

    /// Adds a vector (x, y), rotated by the angle k, to two equations.
    pub(super) fn add_vector(&mut self, equation: usize, angle: u16, [x, y]: [f64; 2]) {
        self.add(equation, x, &[(2 * angle, 1)]);
        self.add(equation + 1, x, &[(2 * angle + 1, 1)]);
        if y != 0.0 {
            self.add(equation, -y, &[(2 * angle + 1, 1)]);
            self.add(equation + 1, y, &[(2 * angle, 1)]);
        }
    }

    pub(super) fn system<const M: usize>(&self) -> PolynomialSystem<M> {
        let mut terms = self.terms.clone();
        terms.sort_by_key(|term| term.equation);
        PolynomialSystem::new(Box::leak(terms.into_boxed_slice()))
    }
}
