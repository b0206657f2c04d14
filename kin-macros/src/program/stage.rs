//! Programs and their stages.

use super::{Cost, Directions, Expression, Names, Step};
use crate::algebra::{Node, Symbol};

/// The steps of one order: 0 is position, 1 velocity, and so on. What else a stage holds is known when it is scheduled.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Stage<E> {
    pub(crate) steps: Vec<Step<E>>,
    /// Values of earlier stages that it uses, besides positions and rates.
    pub(crate) uses: Vec<Carried>,
    /// Symbols whose values or rates it uses.
    pub(crate) reads: Vec<Symbol>,
    /// Values that it hands to later stages.
    pub(crate) carries: Vec<Carried>,
    pub(crate) cost: Cost,
}

/// A value that a stage hands on.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Carried {
    pub(crate) symbol: Symbol,
    /// Set if it is the factors of a matrix of so many rows.
    pub(crate) factors: Option<usize>,
}

impl Carried {
    /// The place of the parameter that it is, which the first stage takes from the structure itself.
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
    /// The expressions that its steps need.
    pub(crate) fn needs(&self) -> impl Iterator<Item = Node> + '_ {
        self.steps.iter().flat_map(Step::needs)
    }
}

/// Position and every order after it.
#[derive(Clone)]
pub(crate) struct Program<E> {
    pub(crate) stages: Vec<Stage<E>>,
    pub(crate) names: Names,
    /// The unknowns that are handed out as unit vectors.
    pub(crate) directions: Directions,
    /// Whether the last stage is that of the sensitivities, a method of the mechanism, as the position is.
    pub(crate) has_sensitivities: bool,
}

impl<E> Program<E> {
    /// A program of one stage and nothing else.
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

    /// What the first stage takes from the structure is a parameter itself.
    #[test]
    fn parameters_are_carried_by_their_place() {
        let place = |symbol: Symbol| Carried { symbol, factors: None }.parameter();
        assert_eq!(place(Symbol::Parameter(3)), Some(3));
        assert_eq!(place(Symbol::Parameter(0)), Some(0));
        assert_eq!(place(Symbol::Unknown(3)), None);
    }
}
