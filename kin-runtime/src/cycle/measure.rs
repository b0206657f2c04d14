//! What a designer reads off a circuit: strokes, ratios of times and the worst transmission angle.

use core::error::Error;
use core::fmt;

use crate::any::{OutputsOver, TransmissionOver};
use crate::extremes::{Extreme, ExtremesError, NamedFunctions};
use crate::quantity::{Digits, Name};
use crate::sweep::SweptMechanism;

/// A value of a quantity along a circuit, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircuitPeak {
    /// The value.
    pub value: f64,
    /// The input there.
    pub input: f64,
    /// The index of the branch.
    pub branch: usize,
}

/// An extreme of a quantity along a circuit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircuitExtreme {
    /// The index of the branch.
    pub branch: usize,
    /// The extreme in the sweep over that branch.
    pub extreme: Extreme,
}

/// The range of a quantity along a circuit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// The smallest value.
    pub low: CircuitPeak,
    /// The largest value.
    pub high: CircuitPeak,
}

impl Stroke {
    /// The difference of the largest and the smallest value.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.high.value - self.low.value
    }
}

/// The smallest transmission angle along a circuit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstTransmission {
    /// The unknowns of the dyad, separated by commas.
    pub block: Name,
    /// The smaller of the transmission angle and its supplement, 0 at a limit.
    pub angle: f64,
    /// The input there.
    pub input: f64,
    /// The index of the branch.
    pub branch: usize,
}

/// The reason why there is no such figure of a circuit.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum MeasureError {
    /// There is no circuit with this index.
    NoSuchCircuit,
    /// The input makes no full revolution along the circuit.
    NoFullRevolution,
    /// The quantity does not go to and fro: it makes full revolutions with the input, or stays where it is.
    NoReturn {
        /// The smallest value.
        low: f64,
        /// The largest value.
        high: f64,
    },
    /// The mechanism has no dyad.
    NoDyad,
    /// The search for extremes along a branch has no answer.
    Extremes(ExtremesError),
}

impl fmt::Display for MeasureError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchCircuit => formatter.write_str("there is no circuit with this index"),
            Self::NoFullRevolution => formatter.write_str(
                "the input does not turn fully along this circuit, so there is no advance and return of one turn",
            ),
            Self::NoReturn { low, high } => write!(
                formatter,
                "the quantity does not go to and fro: it turns fully or stays where it is, from {} to {}, so there is \
                 no advance and return",
                Digits(*low),
                Digits(*high)
            ),
            Self::NoDyad => formatter.write_str("the mechanism has no dyad, and so no transmission angle"),
            Self::Extremes(error) => error.fmt(formatter),
        }
    }
}

crate::__debug_by_display!(MeasureError);

impl Error for MeasureError {}

impl From<ExtremesError> for MeasureError {
    fn from(error: ExtremesError) -> Self {
        Self::Extremes(error)
    }
}

/// What quantities along branches need of a mechanism.
pub trait MeasuredFunctions: SweptMechanism + NamedFunctions + OutputsOver<f64> + TransmissionOver<f64> {}

impl<F: SweptMechanism + NamedFunctions + OutputsOver<f64> + TransmissionOver<f64>> MeasuredFunctions for F {}
