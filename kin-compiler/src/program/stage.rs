//! Programs and their stages.

use super::{Cost, Directions, Expression, Names, Step};
use crate::algebra::{Node, Symbol};

/// The steps of one order: 0 is position, 1 velocity, and so on. The other fields are filled when the stage is
/// scheduled.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Stage<E> {
    pub(crate) steps: Vec<Step<E>>,
    /// Values of earlier stages that the stage uses, besides positions and rates.
    pub(crate) uses: Vec<Carried>,
    /// Symbols whose values or rates the stage uses.
    pub(crate) reads: Vec<Symbol>,
    /// Values that the stage hands to later stages.
    pub(crate) carries: Vec<Carried>,
    pub(crate) cost: Cost,
}

/// A value that a stage hands on.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Carried {
    pub(crate) symbol: Symbol,
    /// The number of rows, if the value is the factors of a matrix.
    pub(crate) factors: Option<usize>,
}

impl Carried {
    /// The index of the parameter, if the value is one. The first stage reads parameters from the structure.
    pub(crate) fn parameter(self) -> Option<usize> {
        match self.symbol {
            Symbol::Parameter(index) => Some(index),
            _ => None,
        }
    }
}

impl<E> Stage<E> {
    /// A stage that is not scheduled yet.
    pub(crate) const fn new(steps: Vec<Step<E>>) -> Self {
        Self {
            steps,
            uses: Vec::new(),
            reads: Vec::new(),
            carries: Vec::new(),
            cost: Cost::NONE,
        }
    }
}

impl Stage<Node> {
    /// The expressions that the steps need.
    pub(crate) fn needs(&self) -> impl Iterator<Item = Node> + '_ {
        self.steps.iter().flat_map(Step::needs)
    }
}

/// The position and every order after it.
#[derive(Clone)]
pub(crate) struct Program<E> {
    pub(crate) stages: Vec<Stage<E>>,
    pub(crate) names: Names,
    /// The unknowns that are returned as unit vectors.
    pub(crate) directions: Directions,
    /// Whether the last stage holds the sensitivities. Like the position, they are a method of the mechanism.
    pub(crate) has_sensitivities: bool,
}

impl<E> Program<E> {
    /// A program of a single stage.
    pub(crate) fn single(steps: Vec<Step<E>>, names: Names) -> Self {
        Self {
            stages: vec![Stage::new(steps)],
            names,
            directions: Directions::default(),
            has_sensitivities: false,
        }
    }
}

impl Program<Expression> {
    /// The cost of all stages together.
    pub(crate) fn cost(&self) -> Cost {
        self.stages.iter().fold(Cost::NONE, |sum, stage| sum + stage.cost)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A carried parameter is known by its index.
    #[test]
    fn parameters_are_carried_by_their_index() {
        let index = |symbol: Symbol| Carried { symbol, factors: None }.parameter();
        assert_eq!(index(Symbol::Parameter(3)), Some(3));
        assert_eq!(index(Symbol::Parameter(0)), Some(0));
        assert_eq!(index(Symbol::Unknown(3)), None);
    }
}
