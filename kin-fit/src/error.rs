//! The mistakes in an objective.

use std::error::Error;
use std::fmt;

/// The reason why an objective or its start cannot be made.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum ObjectiveError {
    /// The mechanism has no quantity of this name and kind.
    NoSuchQuantity {
        /// The name that was given.
        name: String,
        /// The kind of the quantity: `parameter`, `input`, `unknown or output`, or `point`.
        kind: &'static str,
        /// The names of this kind, separated by commas.
        known: String,
    },
    /// The dimension of a quantity does not fit.
    WrongDimension {
        /// The name of the quantity.
        name: String,
        /// The dimension that is wanted: `length` or `angle`.
        wanted: &'static str,
    },
    /// There are no targets.
    NoTargets,
    /// The number of entries of a list is wrong.
    WrongCount {
        /// The list, such as `weights`, `inputs` or `variables`.
        list: &'static str,
        /// The number of its entries.
        given: usize,
        /// The number of entries that are wanted: for weights and inputs, one for each target.
        wanted: usize,
    },
    /// A number is not finite.
    NotFinite {
        /// The name of the number.
        name: String,
        /// The number.
        value: f64,
    },
    /// A number must be positive, and is not.
    NotPositive {
        /// The name of the number.
        name: &'static str,
        /// The number.
        value: f64,
    },
    /// A bound is not finite, or the lower bound is not below the upper bound.
    NotInOrder {
        /// The name of the number that is sought.
        name: String,
        /// Both bounds.
        bounds: [f64; 2],
    },
    /// A part was given that the goal does not have, such as the scale of a path.
    NoSuchPart {
        /// The part.
        part: &'static str,
        /// The goal.
        goal: &'static str,
    },
    /// The mechanism has a block without closed form, whose assembly cannot be held while dimensions change.
    NoClosedForm {
        /// The unknowns of the block.
        block: &'static str,
    },
    /// Nothing may change.
    NothingToSeek,
}

impl fmt::Display for ObjectiveError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchQuantity { name, kind, known } => {
                write!(formatter, "the mechanism has no {kind} `{name}`; it has {known}")
            }
            Self::WrongDimension { name, wanted } => write!(formatter, "`{name}` is no {wanted}"),
            Self::NoTargets => formatter.write_str("the objective has no targets"),
            Self::WrongCount { list, given, wanted } => {
                write!(formatter, "{given} {list} are given, and {wanted} are wanted")
            }
            Self::NotFinite { name, value } => write!(formatter, "`{name}` is {value}; it must be a finite number"),
            Self::NotPositive { name, value } => write!(formatter, "`{name}` is {value}; it must be positive"),
            Self::NotInOrder {
                name,
                bounds: [low, high],
            } => write!(
                formatter,
                "the bounds {low} and {high} of `{name}` must be finite, and the first one below the other"
            ),
            Self::NoSuchPart { part, goal } => write!(formatter, "{goal} has no {part}"),
            Self::NoClosedForm { block } => write!(
                formatter,
                "the block {block} has no closed form: refinement needs an assembly that holds for all dimensions"
            ),
            Self::NothingToSeek => formatter.write_str("nothing may change: give bounds to a dimension"),
        }
    }
}

kin_core::__debug_by_display!(ObjectiveError);

impl Error for ObjectiveError {}
