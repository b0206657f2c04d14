//! The reasons why there is no extreme, no peak or no mean.

use alloc::boxed::Box;
use core::error::Error;
use core::fmt;

use super::ExtremeKind;
use crate::failure::SolveError;
use crate::load::LoadError;
use crate::mechanism::JacobianError;
use crate::quantity::Digits;
use crate::reaction::ReactionError;
use crate::sweep::{NoSuchColumn, SweepError};

/// The reason why a question to a sweep has no answer.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum ExtremesError {
    /// No quantity has this name.
    NoSuchColumn(NoSuchColumn),
    /// The sweep itself is at fault.
    Sweep(SweepError),
    /// The mechanism closes nowhere on the sweep. The error is that of the first row.
    NothingCloses(SolveError),
    /// The sweep begins where it ends, or closes at a single point, so that there is no curve.
    NoLength {
        /// The variable of the sweep.
        at: f64,
    },
    /// A level or a tolerance of the question is not finite.
    Argument {
        /// The number at fault, in a few words.
        argument: &'static str,
        /// Its value.
        value: f64,
    },
    /// The curve is not found within its divisions: it has too many kinks or jumps, or waves that are too short.
    Unresolved {
        /// A point where it is not found.
        at: f64,
        /// The difference there between the curve and the poses, in the unit of the quantity.
        difference: f64,
    },
    /// The mechanism does not close at a point next to those where it does, and no limit was found between them.
    Gap {
        /// A point where it does not close.
        at: f64,
    },
    /// The quantity is not finite at a point where the mechanism closes.
    NotFinite {
        /// The variable of the sweep.
        at: f64,
    },
    /// The loads have no balance at a point where the mechanism closes.
    Load {
        /// The variable of the sweep.
        at: f64,
        /// The reason.
        error: Box<LoadError>,
    },
    /// The force in a joint is not found at a point where the mechanism closes.
    Reaction {
        /// The variable of the sweep; NaN if the question itself is at fault.
        at: f64,
        /// The reason.
        error: Box<ReactionError>,
    },
    /// The results have no Jacobian with singular values, whatever the point.
    Jacobian(Box<JacobianError>),
    /// The peak moves with the end of the circuit or stands at a kink, so that it has no sensitivity.
    NoSensitivity {
        /// The variable of the sweep at the peak.
        at: f64,
        /// Its kind.
        kind: ExtremeKind,
    },
    /// The quantity grows beyond all bounds towards a limit, a turning point or a pole, or at a joint of laws where a
    /// lower rate jumps, so it has no peak.
    Unbounded {
        /// The limit or the joint.
        at: f64,
    },
    /// The integral over the quantity diverges at a turning point.
    Diverges {
        /// The turning point.
        at: f64,
        /// Towards it, the integrand grows with this power of one over the distance of the variable.
        power: f64,
    },
    /// The quadrature has not reached its precision.
    Imprecise {
        /// The value reached.
        value: f64,
        /// The estimate of its error.
        error: f64,
    },
}

impl ExtremesError {
    /// The error of loads at a point of a sweep.
    pub(super) fn of_loads(at: f64, error: LoadError) -> Self {
        let error = Box::new(error);
        Self::Load { at, error }
    }

    /// The error of the force in a joint at a point of a sweep.
    pub(super) fn of_reaction(at: f64, error: ReactionError) -> Self {
        match error {
            ReactionError::Solve(_) => Self::Gap { at },
            ReactionError::NotFinite => Self::NotFinite { at },
            error => {
                let error = Box::new(error);
                Self::Reaction { at, error }
            }
        }
    }

    /// The error of a Jacobian at a point of a sweep.
    pub(super) fn of_jacobian(at: f64, error: JacobianError) -> Self {
        match error {
            JacobianError::Position(_) => Self::Gap { at },
            error => Self::Jacobian(Box::new(error)),
        }
    }
}

impl From<SweepError> for ExtremesError {
    fn from(error: SweepError) -> Self {
        Self::Sweep(error)
    }
}

impl fmt::Display for ExtremesError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchColumn(error) => write!(formatter, "{error}"),
            Self::Sweep(error) => write!(formatter, "{error}"),
            Self::NothingCloses(error) => write!(formatter, "the mechanism closes in no row; in the first: {error}"),
            Self::NoLength { at } => write!(
                formatter,
                "the sweep closes at {} alone, and a curve needs a way: give it a range with a length",
                Digits(*at)
            ),
            Self::Argument { argument, value } => write!(formatter, "the {argument} is {value}: give a finite number"),
            Self::Unresolved { at, difference } => write!(
                formatter,
                "the quantity is too rough to be searched: at {} the pieces of its curve still deviate from the poses \
                 by {}; divide the sweep, or ask for a smoother quantity",
                Digits(*at),
                Digits(*difference)
            ),
            Self::Gap { at } => write!(
                formatter,
                "the mechanism does not close at {}, and the limit next to it was not found: give the sweep more rows",
                Digits(*at)
            ),
            Self::NotFinite { at } => write!(formatter, "the quantity is not finite at {}", Digits(*at)),
            Self::Load { at, error } => write!(formatter, "at {}: {error}", Digits(*at)),
            Self::Reaction { at, error } if at.is_nan() => write!(formatter, "{error}"),
            Self::Reaction { at, error } => write!(formatter, "at {}: {error}", Digits(*at)),
            Self::Jacobian(error) => write!(formatter, "{error}"),
            Self::NoSensitivity { at, kind } => write!(
                formatter,
                "the peak at {} stands at {}, where it has no sensitivity: end the sweep short of it",
                Digits(*at),
                if *kind == ExtremeKind::Limit {
                    "a limit"
                } else {
                    "a kink"
                }
            ),
            Self::Unbounded { at } => write!(
                formatter,
                "the quantity grows beyond all bounds at {}, a limit or a joint of laws where a lower rate jumps: end \
                 the sweep short of it, or take a smoother law",
                Digits(*at)
            ),
            Self::Diverges { at, power } => write!(
                formatter,
                "the integral diverges at the limit {}: the integrand grows with the power {} of one over the \
                 distance, and a power of 1 is too much; end the sweep short of it",
                Digits(*at),
                Digits(*power)
            ),
            Self::Imprecise { value, error } => write!(
                formatter,
                "the mean has only been found as {} within {}: divide the sweep where the quantity has kinks",
                Digits(*value),
                Digits(*error)
            ),
        }
    }
}

crate::__debug_by_display!(ExtremesError);

impl Error for ExtremesError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::NoSuchColumn(error) => Some(error),
            Self::Sweep(error) => Some(error),
            Self::NothingCloses(error) => Some(error),
            Self::Load { error, .. } => Some(&**error),
            Self::Reaction { error, .. } => Some(&**error),
            Self::Jacobian(error) => Some(&**error),
            _ => None,
        }
    }
}
