//! exp x: the derivative is exp x itself.

use super::elementary::{Calculation, Domain, Elementary, Gives, Inverse, InverseFunction, Takes, Work};
use super::ln::LOGARITHM;

pub(super) const EXP: Elementary = Elementary {
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
    cost: &[Work::Other],
    has_zeros: false,
    value: |x| x[0].exp(),
    partials: |_, _, value| vec![value],
};
