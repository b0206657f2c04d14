//! The reasons why loads cannot be balanced.

use core::error::Error;
use core::fmt;

use crate::failure::SolveError;
use crate::quantity::Digits;

/// The reason why loads give no result in a pose.
///
/// A load is named by its place, in the order in which the loads were added, from 1 on.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum LoadError {
    /// The mechanism has no pose there.
    Solve(SolveError),
    /// The two ends of a spring or damper coincide, so that its force has no direction. Or the first two joints of a
    /// body do, so that its frame has none.
    NoDirection {
        /// The place of the spring, damper or body.
        load: usize,
    },
    /// The three points of a body lie on a line, so that they do not determine its orientation.
    Collinear {
        /// The place of the body.
        load: usize,
    },
    /// The points do not belong to one rigid body: distances between them change as the mechanism moves.
    NotRigid {
        /// The place of the body.
        load: usize,
        /// The rate of the scalar product of two lines between the points, per unit of an input.
        rate: f64,
    },
    /// The mass properties resist no motion of some inputs, so that accelerations are not determined.
    NoInertia {
        /// The place of the first input that is concerned, from 0 on.
        input: usize,
    },
    /// The drive has no effort: there is no such input, or the mechanism is declared to the first order, without
    /// accelerations.
    NoEffort {
        /// The place of the input, from 0 on.
        input: usize,
    },
    /// A mass or a moment of inertia is negative.
    Negative {
        /// The place of the load.
        load: usize,
        /// The quantity, in a few words.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// The load is the mass of a body of space whose centre does not lie on the line of its first joints.
    BodyInSpace {
        /// The place of the body.
        load: usize,
    },
    /// The load is the tensor of inertia of a body of the plane.
    SolidInPlane {
        /// The place of the body.
        load: usize,
    },
    /// A result is not finite: a mass, a force, the effort of a drive or another number of a load is not, or is too
    /// large.
    NotFinite,
}

impl From<SolveError> for LoadError {
    fn from(error: SolveError) -> Self {
        Self::Solve(error)
    }
}

impl fmt::Display for LoadError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Solve(error) => error.fmt(formatter),
            Self::NoDirection { load } => write!(
                formatter,
                "load {load}: its two points coincide, so that the line between them has no direction"
            ),
            Self::Collinear { load } => write!(
                formatter,
                "load {load}: the three points of the body lie on a line; give three that form a triangle"
            ),
            Self::NotRigid { load, rate } => write!(
                formatter,
                "load {load}: the points do not belong to one rigid body: the scalar product of two lines between \
                 them changes by {rate} per unit of an input"
            ),
            Self::NoInertia { input } => write!(
                formatter,
                "no mass or inertia resists a motion of input {input}, counted from 0, so that its acceleration is \
                 not determined"
            ),
            Self::NoEffort { input } => write!(
                formatter,
                "the drive of input {input}, counted from 0, has no effort: there is no such input, or the mechanism \
                 is declared without accelerations"
            ),
            Self::Negative { load, quantity, value } => write!(
                formatter,
                "load {load}: the {quantity} is {}: give one that is not negative; a hole is part of its link, whose \
                 mass and centre are those of the whole",
                Digits(*value)
            ),
            Self::BodyInSpace { load } => write!(
                formatter,
                "load {load}: the centre does not lie on the line of the first two joints, and the body is one of \
                 space: give its mass with all moments of inertia by `solid_of`"
            ),
            Self::SolidInPlane { load } => write!(
                formatter,
                "load {load}: the mechanism is one of the plane, whose bodies have one moment of inertia: give it by \
                 `mass_of`"
            ),
            Self::NotFinite => write!(
                formatter,
                "the result is not finite: a mass, force, effort or other number of a load is not finite or too large"
            ),
        }
    }
}

crate::__debug_by_display!(LoadError);

impl Error for LoadError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Solve(error) => Some(error),
            _ => None,
        }
    }
}
