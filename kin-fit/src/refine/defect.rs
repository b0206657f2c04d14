//! The reasons for which a result is dropped.

use std::error::Error;
use std::fmt;

/// The reason for which a result is dropped, with its numbers. Targets are counted from zero, inputs are in radians or
/// lengths.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum Defect {
    /// Two targets lie in different circuits: the mechanism must be taken apart between them.
    Circuit {
        /// The targets.
        targets: [usize; 2],
        /// Their circuits, as the cycle counts them.
        circuits: [usize; 2],
    },
    /// Two targets lie in one circuit, but in different branches: the input cannot lead from one to the other.
    Branch {
        /// The targets.
        targets: [usize; 2],
        /// Their branches, as the cycle counts them.
        branches: [usize; 2],
    },
    /// A target is not passed after the target before it.
    Order {
        /// The target.
        target: usize,
        /// The inputs of the target before and of this target.
        inputs: [f64; 2],
    },
    /// The mechanism does not close somewhere on its travel.
    Closure {
        /// The input at which it ceases to close, or at which it is wanted and does not close.
        input: f64,
    },
    /// Grashof's margin, or the margin by which the driver turns, is not positive.
    Margin {
        /// The term: `Grashof` or `driver`.
        term: &'static str,
        /// The margin.
        margin: f64,
    },
    /// The transmission angle falls below its floor.
    Transmission {
        /// The smallest angle, rad.
        angle: f64,
        /// The input there.
        input: f64,
        /// The floor, rad.
        floor: f64,
    },
    /// The full cycle could not be found with certainty, or a figure of the cycle could not be computed.
    Undecided {
        /// The question that was not decided.
        reason: String,
    },
}

/// The kind of a [`Defect`], by which defects are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum DefectKind {
    /// Targets in different circuits.
    Circuit,
    /// Targets in different branches.
    Branch,
    /// Targets that are not passed in order.
    Order,
    /// A travel on which the mechanism does not close.
    Closure,
    /// A margin that is not positive.
    Margin,
    /// A transmission angle below its floor.
    Transmission,
    /// A cycle that could not be decided.
    Undecided,
}

impl Defect {
    /// The kind.
    #[must_use]
    pub fn kind(&self) -> DefectKind {
        match self {
            Self::Circuit { .. } => DefectKind::Circuit,
            Self::Branch { .. } => DefectKind::Branch,
            Self::Order { .. } => DefectKind::Order,
            Self::Closure { .. } => DefectKind::Closure,
            Self::Margin { .. } => DefectKind::Margin,
            Self::Transmission { .. } => DefectKind::Transmission,
            Self::Undecided { .. } => DefectKind::Undecided,
        }
    }
}

impl fmt::Display for DefectKind {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::Circuit => "circuit",
            Self::Branch => "branch",
            Self::Order => "order",
            Self::Closure => "closure",
            Self::Margin => "margin",
            Self::Transmission => "transmission",
            Self::Undecided => "undecided",
        })
    }
}

impl fmt::Display for Defect {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Circuit {
                targets: [one, other],
                circuits: [first, second],
            } => write!(
                formatter,
                "target {one} lies in circuit {first}, target {other} in circuit {second}"
            ),
            Self::Branch {
                targets: [one, other],
                branches: [first, second],
            } => write!(
                formatter,
                "target {one} lies in branch {first}, target {other} in branch {second}"
            ),
            Self::Order {
                target,
                inputs: [before, input],
            } => write!(
                formatter,
                "target {target} is not passed in order: it is met at the input {input:.6}, the one before at \
                 {before:.6}"
            ),
            Self::Closure { input } => write!(formatter, "the mechanism does not close at the input {input:.6}"),
            Self::Margin { term, margin } => write!(formatter, "the margin of {term} is {margin:.6}"),
            Self::Transmission { angle, input, floor } => write!(
                formatter,
                "the transmission angle falls to {:.3} degrees at the input {input:.6}, below {:.3} degrees",
                angle.to_degrees(),
                floor.to_degrees()
            ),
            Self::Undecided { reason } => write!(formatter, "the cycle is not decided: {reason}"),
        }
    }
}

kin_core::__debug_by_display!(Defect);

impl Error for Defect {}
