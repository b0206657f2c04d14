//! All programs of a mechanism, ready to be written.

use std::collections::BTreeSet;

use super::{Choice, Directions, Expression, Names, Program, Stage, Trials};
use crate::algebra::{Graph, Symbol};
use crate::structure::{BlockKind, ClosureMonomial, Dyad};

/// The programs that a mechanism needs, and the decisions behind them.
pub(crate) struct Solvers {
    /// The position and every order after it, then the sensitivities if they are requested.
    pub(crate) motion: Program<Expression>,
    /// The choice between the solutions of each part.
    pub(crate) choices: Vec<Choice>,
    /// The graph of the expressions in the choices.
    pub(crate) graph: Graph,
    /// The rates to be tested, by unknown and order. If they are finite, all rates are.
    pub(crate) telltales: BTreeSet<(usize, usize)>,
    /// The assembly of a guess: one definition for each choice, positive in the open assembly.
    pub(crate) orientations: Program<Expression>,
    /// The symbols of these definitions.
    pub(crate) orientation_symbols: Vec<Symbol>,
    /// The program that goes through all positions, if Newton's method solves a part and the equations are algebraic.
    pub(crate) every: Option<Program<Expression>>,
    pub(crate) transmission: TransmissionAngles,
    pub(crate) lengths: Lengths,
    /// The closure as polynomials, if Newton's method solves a part and the closure is algebraic.
    pub(crate) closure: Option<ClosureTerms>,
    /// Whether equations or outputs were too large to be multiplied out.
    pub(crate) is_form_given_up: bool,
    pub(crate) trials: Trials,
}

/// The dyads, each with the symbols of its angle's sine and cosine, and the program that computes these.
pub(crate) struct TransmissionAngles {
    pub(crate) dyads: Vec<(Dyad, [Symbol; 2])>,
    pub(crate) program: Program<Expression>,
}

/// The form of each block with its lengths, and the program that computes those that are no parameters.
pub(crate) struct Lengths {
    pub(crate) forms: Vec<FormLengths>,
    pub(crate) program: Program<Expression>,
}

/// The terms of the closure with their coefficients, and the program that computes those that are no parameters.
pub(crate) struct ClosureTerms {
    pub(crate) terms: Vec<ClosureMonomial>,
    pub(crate) coefficients: Vec<Component>,
    pub(crate) program: Program<Expression>,
}

/// The form of a block. A length is given by its two components; a length that changes is `None`.
pub(crate) struct FormLengths {
    pub(crate) kind: BlockKind,
    pub(crate) driver: Option<Symbol>,
    pub(crate) lengths: Vec<Option<[Component; 2]>>,
}

/// A component of a length, up to its sign, or a coefficient.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Component {
    /// A number.
    Number(f64),
    /// A scalar parameter.
    Parameter(usize),
    /// A value of the program.
    Value(Symbol),
}

impl Solvers {
    /// The highest time derivative.
    pub(crate) fn order(&self) -> usize {
        self.orders().len() - 1
    }

    /// The stages of the orders: position, velocity, ….
    pub(crate) fn orders(&self) -> &[Stage<Expression>] {
        let stages = &self.motion.stages;
        &stages[..stages.len() - usize::from(self.motion.has_sensitivities)]
    }

    /// The stage of the partial derivatives by the parameters, if they are requested.
    pub(crate) fn sensitivities(&self) -> Option<&Stage<Expression>> {
        self.motion.stages.last().filter(|_| self.motion.has_sensitivities)
    }

    /// The names of the motion's symbols.
    pub(crate) fn names(&self) -> &Names {
        &self.motion.names
    }

    /// The unknowns that are returned as unit vectors.
    pub(crate) fn directions(&self) -> &Directions {
        &self.motion.directions
    }
}
