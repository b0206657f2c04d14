//! The reasons why there is no extreme, no peak or no mean.

use alloc::boxed::Box;
use core::error::Error;
use core::fmt;

use super::Kind;
use crate::failure::SolveError;
use crate::load::LoadError;
use crate::quantity::Digits;
use crate::sweep::{NoSuchColumn, SweepError};

/// The reason why a question to a sweep has no answer.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ExtremesError {
    /// No quantity has this name.
    NoSuchColumn(NoSuchColumn),
    /// The sweep itself is at fault.
    Sweep(SweepError),
    /// The mechanism closes nowhere on the sweep. The error is that of the first row.
    NothingCloses(SolveError),
    /// The mechanism closes in two neighbouring rows and not between them.
    Gap {
        /// A place where it does not close.
        at: f64,
    },
    /// The quantity is not finite at a place where the mechanism closes.
    NotFinite {
        /// The place.
        at: f64,
    },
    /// The loads have no balance at a place where the mechanism closes.
    Load {
        /// The place.
        at: f64,
        /// The reason.
        error: Box<LoadError>,
    },
    /// The peak moves with the end of the circuit or stands at a kink, so that it has no sensitivity of its own.
    NoSensitivity {
        /// The place of the peak.
        at: f64,
        /// Its kind.
        kind: Kind,
    },
    /// The quantity grows beyond all bounds towards a turning point, so it has no peak.
    Unbounded {
        /// The turning point.
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
            Self::Gap { at } => write!(
                formatter,
                "the mechanism closes in two neighbouring rows but not at {} between them: give the sweep more rows",
                Digits(*at)
            ),
            Self::NotFinite { at } => write!(formatter, "the quantity is not finite at {}", Digits(*at)),
            Self::Load { at, error } => write!(formatter, "at {}: {error}", Digits(*at)),
            Self::NoSensitivity { at, kind } => write!(
                formatter,
                "the peak at {} stands at {}, where it has no sensitivity: end the sweep short of it",
                Digits(*at),
                if *kind == Kind::Limit { "a limit" } else { "a kink" }
            ),
            Self::Unbounded { at } => write!(
                formatter,
                "the quantity grows beyond all bounds towards the turning point at {}: end the sweep short of it",
                Digits(*at)
            ),
            Self::Diverges { at, power } => write!(
                formatter,
                "the integral diverges at the turning point {}: the integrand grows with the power {} of one over the distance, \
                 and a power of 1 is too much; end the sweep short of it",
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

impl Error for ExtremesError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::NoSuchColumn(error) => Some(error),
            Self::Sweep(error) => Some(error),
            Self::NothingCloses(error) => Some(error),
            Self::Load { error, .. } => Some(&**error),
            _ => None,
        }
    }
}
