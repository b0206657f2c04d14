//! The reasons why nothing is proved about a force.

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;
use core::error::Error;
use core::fmt;

use super::super::ReactionError;
use super::super::error::Listed;
use super::UndecidedForce;

/// The reason why nothing is proved about a force.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum ProofError {
    /// There is no such force, or it is not determined.
    Reaction(Box<ReactionError>),
    /// Joints have friction, for which there is no proof.
    Friction,
    /// The mechanism is one of space, for which there is no proof.
    InSpace,
    /// Gears have a pressure angle, and the flank on which they bear may change.
    PressureAngle {
        /// The contact.
        reaction: String,
    },
    /// A torsion spring acts on an angle that is only an output, whose turns nothing counts.
    OutputAngle {
        /// The output.
        name: String,
    },
    /// No scalar dimension has this name.
    NoSuchDimension {
        /// The name.
        name: String,
        /// The names that there are.
        names: Vec<String>,
    },
    /// A tolerance is negative or not finite.
    Tolerance {
        /// The dimension.
        name: String,
        /// The tolerance.
        tolerance: f64,
    },
    /// The inputs stand, or a dimension or a number of the motion is not finite.
    NoMotion,
    /// A limit is negative or not a number.
    Limit(f64),
    /// The bounds do not tell.
    Undecided(UndecidedForce),
}

impl From<ReactionError> for ProofError {
    fn from(error: ReactionError) -> Self {
        Self::Reaction(Box::new(error))
    }
}

impl fmt::Display for ProofError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reaction(error) => write!(formatter, "{error}"),
            Self::Friction => formatter.write_str(
                "the joints have friction, for which no proof is given: leave it out, or look at the peak along a \
                 sweep",
            ),
            Self::InSpace => formatter.write_str(
                "the mechanism is one of space, and forces are proved in the plane: look at the peak along a sweep",
            ),
            Self::PressureAngle { reaction } => write!(
                formatter,
                "the contact `{reaction}` has a pressure angle, for which no proof is given, because the flank may \
                 change: leave the angle out, or look at the peak along a sweep"
            ),
            Self::OutputAngle { name } => write!(
                formatter,
                "a torsion spring acts on `{name}`, an angle that is only an output, and no proof is given for it: \
                 make the angle an unknown"
            ),
            Self::NoSuchDimension { name, names } => {
                write!(formatter, "there is no dimension `{name}`; there is {}", Listed(names))
            }
            Self::Tolerance { name, tolerance } => write!(
                formatter,
                "the tolerance of `{name}` is {tolerance}: give a finite one from zero on"
            ),
            Self::NoMotion => formatter.write_str(
                "the inputs stand, or a dimension or a number of the motion is not finite: give a range that is finite \
                 and has a length",
            ),
            Self::Limit(limit) => write!(formatter, "the limit is {limit}: give a number from zero on"),
            Self::Undecided(undecided) => write!(formatter, "{undecided}"),
        }
    }
}

crate::__debug_by_display!(ProofError);

impl Error for ProofError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Reaction(error) => Some(&**error),
            _ => None,
        }
    }
}
