//! The reasons why a cycle may lack branches.

use core::fmt;

use crate::quantity::{Name, WithUnit};

/// A reason why it is not proved that a cycle has all branches.
///
/// ```
/// use kin_core::cycle::{FullCycle, Incomplete};
/// use kin_core::library::FourBar;
///
/// // Links of 10¹⁵ and 1 close to a parallelogram everywhere, as far as a number has digits.
/// let cycle = FourBar { r1: 1e15, r2: 1.0, r3: 1e15, r4: 1.0 }.cycle()?;
/// assert!(!cycle.is_complete());
/// assert!(matches!(cycle.incomplete()[0], Incomplete::Rounding { block, .. } if block == "theta3, theta4"));
/// # Ok::<(), kin_core::SolveError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum Incomplete {
    /// Rounding decides whether a block closes in a range of the input, in which the mechanism is too close to a change
    /// point everywhere.
    Rounding {
        /// The unknowns of the block, separated by commas.
        block: Name,
        /// The range of the input.
        range: [f64; 2],
        /// Whether the input is an angle.
        is_angle: bool,
    },
    /// The bounds do not decide whether assemblies close: [`Cycle::undecided`](super::Cycle::undecided) has each with
    /// its ranges.
    Undecided {
        /// The number of assemblies.
        assemblies: usize,
        /// A range of the input that contains all of these ranges.
        range: [f64; 2],
        /// Whether the input is an angle.
        is_angle: bool,
    },
    /// A branch could not be followed to its end.
    Lost {
        /// The input at which it was left.
        input: f64,
        /// Whether the input is an angle.
        is_angle: bool,
    },
    /// The closure of a mechanism with a coupled block is no polynomial in lengths and in cosines and sines of angles,
    /// so its limits are not all known.
    NotAlgebraic,
    /// An unknown of a mechanism with a coupled block has a declared range.
    DeclaredRange {
        /// The unknown.
        unknown: Name,
    },
    /// An unknown length of a mechanism with a coupled block may grow beyond all bounds.
    Unbounded,
    /// A coupled block is singular in every position.
    AlwaysSingular {
        /// The unknowns of the block, separated by commas.
        block: Name,
    },
    /// The limits of a coupled block are solutions of a system with more paths than are followed.
    TooManyPaths {
        /// The unknowns of the block, separated by commas.
        block: Name,
        /// The number of paths, or a smaller one that is above the largest too.
        paths: usize,
        /// The largest number that is followed.
        most: usize,
    },
    /// Continuation lost a path to a limit of a coupled block.
    PathLost {
        /// The unknowns of the block, separated by commas.
        block: Name,
    },
    /// The ends of the branches are not the limits that continuation found.
    Disagreement {
        /// The number of limits that continuation found, those of multiplicity one.
        limits: usize,
        /// How many of them are an end of a branch.
        reached: usize,
    },
    /// The search for all positions at an input was not complete.
    Positions {
        /// The input.
        input: f64,
        /// Whether the input is an angle.
        is_angle: bool,
    },
}

impl fmt::Display for Incomplete {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let between = |[low, high]: [f64; 2], is_angle: bool| {
            let shown = |value: f64| WithUnit { value, is_angle };
            (shown(low), shown(high))
        };
        match *self {
            Self::Rounding { block, range, is_angle } => {
                let (low, high) = between(range, is_angle);
                write!(
                    formatter,
                    "rounding decides whether {block} can be found between the inputs {low} and {high}"
                )
            }
            Self::Undecided {
                assemblies,
                range,
                is_angle,
            } => {
                let (low, high) = between(range, is_angle);
                let (number, verb) = if assemblies == 1 {
                    ("assembly", "closes")
                } else {
                    ("assemblies", "close")
                };
                write!(
                    formatter,
                    "bounds do not decide whether {assemblies} {number} {verb} between the inputs {low} and {high}"
                )
            }
            Self::Lost { input, is_angle } => write!(
                formatter,
                "a branch could not be followed beyond the input {}",
                WithUnit { value: input, is_angle }
            ),
            Self::NotAlgebraic => formatter.write_str("the closure is not algebraic, so limits may be missing"),
            Self::DeclaredRange { unknown } => write!(
                formatter,
                "`{unknown}` has a declared range, which the search for the limits of coupled equations does not know"
            ),
            Self::Unbounded => {
                formatter.write_str("an unknown length may grow beyond all bounds, so limits may be missing")
            }
            Self::AlwaysSingular { block } => write!(formatter, "{block} cannot be found in any position"),
            Self::TooManyPaths { block, paths, most } => write!(
                formatter,
                "the limits of {block} take {paths} paths, and at most {most} are followed"
            ),
            Self::PathLost { block } => write!(formatter, "a path to the limits of {block} was lost"),
            Self::Disagreement { limits, reached } => write!(
                formatter,
                "branches end at {reached} of {limits} limits, or where continuation found no limit"
            ),
            Self::Positions { input, is_angle } => write!(
                formatter,
                "not all positions were found at the input {}",
                WithUnit { value: input, is_angle }
            ),
        }
    }
}
