//! The growth of rounding errors through relations that replace unknowns.

use std::collections::BTreeSet;

use crate::algebra::{Graph, Node, Symbol};

/// The growth up to which relations are taken out of equations that Newton's method solves. Four bits of the residuals
/// are lost at most.
pub(super) const COUPLED: f64 = 16.0;
/// The growth up to which relations are taken out of equations that closed forms solve: that of one coefficient whose
/// value is not known, beside numbers that Newton's method would accept. Without them the equations would need a guess.
pub(super) const CLOSED: f64 = COUPLED * UNKNOWN_COEFFICIENT;
/// The growth that a coefficient counts for whose value is not known: more than Newton's method accepts.
const UNKNOWN_COEFFICIENT: f64 = 32.0;

/// The quantities whose magnitudes say something about coefficients.
pub(crate) struct Magnitudes {
    /// The unknowns that are lengths.
    pub(crate) lengths: BTreeSet<usize>,
    /// The parameters, inputs and unknowns that are plain numbers. These may have any magnitude.
    pub(crate) numbers: BTreeSet<Symbol>,
}

/// The factor by which rounding errors of the remaining unknowns may grow on their way through relations.
#[derive(Clone, Copy)]
pub(super) struct Growth(f64);

impl Growth {
    /// Nothing is replaced.
    pub(super) const NONE: Self = Self(1.0);

    pub(super) const fn get(self) -> f64 {
        self.0
    }

    /// The growth if an equation gives an unknown from others: the sum of the magnitudes of their coefficients, if that is
    /// more than one.
    ///
    /// The coefficient of an angle in a length is itself a length, and not larger than a link. Any other coefficient that is
    /// no number may have any value.
    pub(super) fn through(
        self,
        graph: &mut Graph,
        magnitudes: &Magnitudes,
        equation: Node,
        (unknown, coefficient): (usize, Node),
        others: impl Iterator<Item = usize>,
    ) -> Self {
        let is_length = magnitudes.lengths.contains(&unknown);
        let (mut sum, mut longest) = (0.0, 0.0_f64);
        for other in others {
            let partial = graph.partial(equation, Symbol::Unknown(other));
            let ratio = graph.divide(partial, coefficient);
            if let Some(number) = graph.as_number(ratio) {
                sum += number.abs();
            } else if is_length && !magnitudes.lengths.contains(&other) && magnitudes.is_length(graph, ratio) {
                longest = 1.0;
            } else {
                longest = UNKNOWN_COEFFICIENT;
            }
        }
        Self(self.0 * (sum + longest).max(1.0))
    }
}

impl Magnitudes {
    /// Whether an expression for a length is made up of lengths and functions of angles, without plain numbers that would
    /// enlarge it.
    fn is_length(&self, graph: &Graph, node: Node) -> bool {
        graph.reachable(&[node]).into_iter().all(|part| {
            let is_number = graph
                .as_symbol(part)
                .is_some_and(|symbol| self.numbers.contains(&symbol));
            !is_number && graph.extremity(part) <= COUPLED.ln()
        })
    }
}
