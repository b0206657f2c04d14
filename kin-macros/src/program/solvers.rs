//! All programs of a mechanism, ready to be written.

use std::collections::BTreeSet;

use super::{Choice, Directions, Expression, Names, Program, Stage, Trials};
use crate::algebra::{Graph, Symbol};
use crate::structure::Dyad;

/// The programs that a mechanism needs, and what has been decided about them.
pub(crate) struct Solvers {
    /// Position and every order after it, and the sensitivities if they were requested.
    pub(crate) motion: Program<Expression>,
    /// How each part of the blocks chooses between its solutions.
    pub(crate) choices: Vec<Choice>,
    /// Holds the expressions of the choices.
    pub(crate) graph: Graph,
    /// The rates to be tested, by unknown and order. If they are finite, all are.
    pub(crate) telltales: BTreeSet<(usize, usize)>,
    /// The assembly of a guess: definitions in the order of the choices, each positive in the open assembly.
    pub(crate) orientations: Program<Expression>,
    /// Their symbols.
    pub(crate) orientation_symbols: Vec<Symbol>,
    /// The way through all positions where a block is left to Newton's method, if its equations are algebraic.
    pub(crate) every: Option<Program<Expression>>,
    /// The transmission angles, if they were requested.
    pub(crate) transmission: Option<TransmissionAngles>,
    /// Whether equations or outputs were too large to be multiplied out.
    pub(crate) is_form_given_up: bool,
    pub(crate) trials: Trials,
}

/// The dyads, each with the symbols of its angle's sine and cosine, and the program that computes them.
pub(crate) struct TransmissionAngles {
    pub(crate) dyads: Vec<(Dyad, [Symbol; 2])>,
    pub(crate) program: Program<Expression>,
}

impl Solvers {
    /// The highest time derivative.
    pub(crate) fn order(&self) -> usize {
        self.orders().len() - 1
    }

    /// Position, velocity, …: a stage for each order.
    pub(crate) fn orders(&self) -> &[Stage<Expression>] {
        let stages = &self.motion.stages;
        &stages[..stages.len() - usize::from(self.motion.has_sensitivities)]
    }

    /// The stage of the partial derivatives by the parameters, if they were requested.
    pub(crate) fn sensitivities(&self) -> Option<&Stage<Expression>> {
        self.motion.stages.last().filter(|_| self.motion.has_sensitivities)
    }

    /// The names of the motion's symbols.
    pub(crate) fn names(&self) -> &Names {
        &self.motion.names
    }

    /// The unknowns that are handed out as unit vectors.
    pub(crate) fn directions(&self) -> &Directions {
        &self.motion.directions
    }
}
