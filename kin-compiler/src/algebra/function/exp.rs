//! exp x: the derivative is exp x itself.

use super::facts::{Calculation, Domain, FunctionFacts, Gives, Inverse, InverseFunction, Takes, WorkUnit};
use super::ln::LOGARITHM;

pub(super) const EXP: FunctionFacts = FunctionFacts {
    name: "exp",
    form: "exp(x)",
    notation: "exp",
    undone_by: Some("ln"),
    arity: 1,
    takes: Takes::number("a plain number"),
    gives: Gives::Number,
    domain: Domain::Everywhere,
    guard: None,
    inverse: Inverse::One(InverseFunction::Checked(&LOGARITHM)),
    calculation: Calculation::Method,
    cost: &[WorkUnit::Other],
    has_zeros: false,
    value: |x| x[0].exp(),
    partials: |_, _, value| vec![value],
};
