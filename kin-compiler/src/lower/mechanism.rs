//! A whole mechanism as data.

use super::Statement;
use crate::algebra::Symbol;
use crate::describe::{self, Description};
use crate::program::{Component, Solvers};
use crate::structure::{Block, BlockKind};

/// The largest number of assemblies that are all found. A mechanism with more is assembled from a guess.
pub(crate) const MOST_ASSEMBLIES: usize = 4096;

/// A mechanism, as a machine runs it. The symbols of a routine belong to it alone, except those of quantities.
#[derive(Clone, PartialEq, Debug)]
pub struct Mechanism {
    /// The description.
    pub description: Description,
    /// The outputs, each with the number of its scalar parts.
    pub outputs: Vec<(String, usize)>,
    /// For each unknown that is returned as a unit vector its parts.
    pub directions: Vec<Option<UnitVector>>,
    /// The unknowns that are angles.
    pub angles: Vec<usize>,
    /// The names of the choices between two solutions.
    pub choices: Vec<String>,
    /// Whether Newton's method solves a part, so that guessed values choose the position.
    pub is_coupled: bool,
    /// The position.
    pub position: Vec<Statement>,
    /// The rates: velocity, acceleration, …. They go on from the values of the position.
    pub rates: Vec<Vec<Statement>>,
    /// The rates to be tested, by unknown and order, in the order in which they are found. If they are finite, all
    /// rates are.
    pub telltales: Vec<(usize, usize)>,
    /// The partial derivatives by the parameters, if they are requested. They go on from the values of the rates.
    pub sensitivities: Option<Vec<Statement>>,
    /// The sides on which values of the unknowns lie, one for each choice.
    pub orientations: Routine,
    /// All positions, one after the other, if they can be found.
    pub every: Option<EveryPosition>,
    /// For each dyad the sine and the cosine of its transmission angle, times one positive factor.
    pub transmission: Routine,
    /// The unknowns of each dyad.
    pub dyads: Vec<Vec<usize>>,
    /// The lengths of the links.
    pub lengths: Vec<Statement>,
    /// The form of each block.
    pub forms: Vec<Form>,
    /// The closure as polynomials, if a block is coupled and it is algebraic.
    pub closure: Option<Closure>,
}

/// Statements with their results.
#[derive(Clone, PartialEq, Debug)]
pub struct Routine {
    /// The statements.
    pub statements: Vec<Statement>,
    /// The results.
    pub results: Vec<Symbol>,
}

/// The parts of a unit vector.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct UnitVector {
    /// The cosine.
    pub cosine: Symbol,
    /// The sine.
    pub sine: Symbol,
    /// The angle, if something uses it.
    pub angle: Option<Symbol>,
}

/// The search for all positions.
#[derive(Clone, PartialEq, Debug)]
pub struct EveryPosition {
    /// The statements that find one position.
    pub statements: Vec<Statement>,
    /// The largest number of positions.
    pub paths: usize,
    /// The numbers in which the solutions of all coupled blocks are kept.
    pub room: usize,
}

/// The form of a block.
#[derive(Clone, PartialEq, Debug)]
pub struct Form {
    /// The variant of `kin_core::BlockForm`.
    pub kind: BlockKind,
    /// The input or unknown that drives it, if its lengths are known.
    pub driver: Option<Symbol>,
    /// The components of its lengths. A length that changes is `None`.
    pub lengths: Vec<Option<[Component; 2]>>,
}

/// The closure as trigonometric polynomials.
#[derive(Clone, PartialEq, Debug)]
pub struct Closure {
    /// The terms.
    pub terms: Vec<ClosureTerm>,
    /// The statements that find the coefficients which are no parameters.
    pub statements: Vec<Statement>,
    /// The coefficients.
    pub coefficients: Vec<Component>,
}

/// A term of the closure. Inputs and unknowns are counted together, inputs first.
#[derive(Clone, PartialEq, Debug)]
pub struct ClosureTerm {
    /// The index of the scalar equation.
    pub equation: u16,
    /// The number in front.
    pub factor: f64,
    /// The index of the coefficient.
    pub coefficient: u16,
    /// Powers of inputs and unknowns.
    pub powers: Vec<(u16, u8)>,
    /// The angle of a cosine (`false`) or of a sine (`true`), with the multiples in it.
    pub harmonic: Option<(bool, Vec<(u16, i8)>)>,
}

/// The program that goes through all positions, and the number of paths; `None` if the equations are not algebraic, or
/// if there are too many positions.
pub(crate) fn most_positions(blocks: &[Block], solvers: &Solvers) -> Option<usize> {
    solvers.every.as_ref()?;
    let choices = 1_usize << describe::choices(solvers).len().min(20);
    let paths = blocks.iter().fold(choices, |product, block| {
        product.saturating_mul(block.all.as_ref().map_or(1, |system| system.paths))
    });
    (paths <= MOST_ASSEMBLIES).then_some(paths)
}
