//! Peaks, extremes, zeros, dwells and means of a sweep, exact to rounding.
//!
//! ```
//! use std::f64::consts::TAU;
//! use kin_core::library::FourBar;
//! use kin_core::prelude::*;
//!
//! let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
//! let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 361).speed(10.0);
//! let peak = sweep.of("theta4_acceleration").peak()?;
//! println!("{} rad/s² at {}°", peak.value, peak.at.to_degrees());
//!
//! // there the jerk vanishes
//! let pose = linkage.solve(Motion::at_constant_speed(peak.at, 10.0), Assembly::Open)?;
//! assert!(pose.theta4.jerk().abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A question is asked to the sweep itself, and the answer does not depend on its rows: extremes are found between
//! them. The quantity is called [`of`](crate::sweep::Sweep::of) the sweep by the name of its column, or is any
//! expression of the pose by a closure: see [`At`]. Names go on above the order of the mechanism, up to the twelfth
//! derivative: `theta4_crackle`, `theta4_pop`, `theta4_derivative_7`. `margin` is the length that is left until the
//! first dyad ceases to close.
//!
//! # Method
//! The positions are solved in numbers that carry their Taylor series in the variable of the sweep; rates are read from
//! them. A closure gets a typed pose, whose rates are solved in such numbers. A piece of the curve between two poses is
//! the Hermite polynomial of degree 9 that agrees with both series. Pieces are halved until they agree with the poses
//! at a third, the middle and two thirds. Descartes' rule isolates the zeros of the slope of each piece, and Newton's
//! method refines them on the poses themselves.
//!
//! Towards a turning point the curve is a root of the variable. There the parameter is the root of the distance, in
//! which the curve is smooth. A rate that grows beyond all bounds is `Unbounded`, never a number. Within 10⁻⁵ of the
//! way to a turning point, values come from the series next to it. At a change point, where the rates jump, each side
//! has a separate stretch, whose values next to the change point come from its series as well.
//!
//! Two extremes are distinguished from rounding errors if the quantity differs between them by more than 10⁻⁸ of the
//! range of their piece, and by more than 10⁻¹² of its size.

mod along;
mod answer;
mod at;
mod branch;
#[cfg(test)]
mod consistency_tests;
mod curve;
#[cfg(test)]
mod edge_tests;
mod error;
mod guessed;
mod islands;
#[cfg(test)]
mod jacobian_tests;
mod margin;
mod mean;
mod parts;
mod progress;
mod quantity;
mod search;
mod sensitivity;
#[cfg(test)]
mod sensitivity_tests;
mod station;
mod swept;
#[cfg(test)]
mod tests;

pub use along::QuantityAlong;
#[doc(hidden)]
pub use along::{
    AskedQuantity, ByDyad, ByEffort, ByExpression, ByJacobian, ByName, ByPower, ByReaction, QuantitySource,
    SensitiveQuantity,
};
pub(crate) use along::{pose_quantity, reactions_in_rows};
pub use answer::Answer;
pub use at::At;
pub(crate) use branch::{KnownStretch, KnownSweep, StationQuantity, named_quantity};
pub use error::ExtremesError;
pub use mean::{Mean, Over};
pub use sensitivity::{PeakSensitivities, PeakSensitivity};
#[doc(hidden)]
pub use station::{ChangedFunctions, NamedFunctions, PositionFunctions};

use core::fmt;

use crate::quantity::Digits;

/// The kind of an extreme.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExtremeKind {
    /// The slope vanishes.
    Inner,
    /// The mechanism closes no further.
    Limit,
    /// Two pieces of a law meet, or the quantity itself has a kink.
    Kink,
    /// The sweep ends.
    End,
    /// The quantity grows beyond all bounds: towards a turning point or a pole, or at a joint of laws where a lower
    /// rate jumps.
    Unbounded,
}

/// A point where a quantity is larger or smaller than on both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The value of the variable of the sweep: radians or the mechanism's unit of length for an input, or the time.
    pub at: f64,
    /// The value of the quantity, or `None` if it is unbounded.
    pub value: Option<f64>,
    /// The kind.
    pub kind: ExtremeKind,
    /// Whether it is a maximum; otherwise it is a minimum.
    pub is_maximum: bool,
}

/// `maximum 74.3 at 2.1`
impl fmt::Display for Extreme {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let word = if self.is_maximum { "maximum" } else { "minimum" };
        match self.value {
            Some(value) => write!(formatter, "{word} {} at {}", Digits(value), Digits(self.at))?,
            None => write!(formatter, "unbounded at {}", Digits(self.at))?,
        }
        formatter.write_str(match self.kind {
            ExtremeKind::Inner | ExtremeKind::Unbounded => "",
            ExtremeKind::Limit => ", at a limit",
            ExtremeKind::Kink => ", at a kink",
            ExtremeKind::End => ", at the end of the sweep",
        })
    }
}

/// The value of a quantity that is largest in size, or the highest, or the lowest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// The value of the variable of the sweep.
    pub at: f64,
    /// The value of the quantity, with its sign.
    pub value: f64,
    /// The kind of the extreme.
    pub kind: ExtremeKind,
}

/// `-74.3 at 2.1`
impl fmt::Display for Peak {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} at {}", Digits(self.value), Digits(self.at))
    }
}

/// A point where a quantity crosses a level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The value of the variable of the sweep.
    pub at: f64,
    /// Whether the quantity rises in the direction of the sweep.
    pub is_rising: bool,
}

/// A part of the sweep on which a quantity keeps to a level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DwellRange {
    /// Its start.
    pub from: f64,
    /// Its end. A dwell through the seam of a full revolution ends beyond the end of the sweep.
    pub to: f64,
    /// Its time, in the unit of time of the rates.
    pub duration: f64,
}
