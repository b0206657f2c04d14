//! Circuits and branches, without the type of the mechanism.

use alloc::vec::Vec;
use core::ops::RangeInclusive;

use num_traits::Float;

use super::Incomplete;
use crate::curve::LimitKind;
use crate::quantity::Name;

/// The reason why a branch ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum EndKind {
    /// A limit. At a limit position the input reverses, and the branch meets another one of its circuit; at a change
    /// point branches cross.
    Limit(LimitKind),
    /// The end of the range of the input that was looked at.
    Range,
    /// The search could not go on, for a reason that it does not know.
    Lost,
    /// No end: after a full revolution of the input the branch is back at its start.
    #[cfg_attr(feature = "serde", serde(rename = "FullTurn"))]
    FullRevolution,
}

/// An end of a branch.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct End {
    /// The reason why the branch ends here.
    pub kind: EndKind,
    /// The input, or the distance along the line of inputs.
    pub input: f64,
    /// The unknowns at this end, with the angles unwrapped along the branch.
    pub unknowns: Vec<f64>,
    /// The unknowns of the block that is singular here, separated by commas; empty if there is none.
    pub block: Name,
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(super) node: Option<usize>,
}

impl End {
    /// The kind of the limit, if the branch ends at one.
    #[must_use]
    pub fn limit(&self) -> Option<LimitKind> {
        self.kind.limit()
    }
}

impl EndKind {
    pub(super) fn limit(self) -> Option<LimitKind> {
        match self {
            Self::Limit(kind) => Some(kind),
            Self::Range | Self::Lost | Self::FullRevolution => None,
        }
    }
}

/// A branch: a part of a circuit over which the input moves in one direction.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Branch {
    pub(super) ends: [End; 2],
    pub(super) samples: Vec<(f64, Vec<f64>)>,
    pub(super) assembly: Option<usize>,
    pub(super) circuit: usize,
    pub(super) joins: [Vec<usize>; 2],
}

impl Branch {
    /// The ends with the smallest and the largest input.
    #[must_use]
    pub fn ends(&self) -> [&End; 2] {
        self.ends.each_ref()
    }

    /// The smallest and the largest input. A branch of a closed range may reach beyond half a revolution, and a full
    /// revolution may begin anywhere.
    #[must_use]
    pub fn range(&self) -> RangeInclusive<f64> {
        self.ends[0].input..=self.ends[1].input
    }

    /// Whether the input makes full revolutions without an end.
    #[must_use]
    pub fn is_full_revolution(&self) -> bool {
        self.ends[0].kind == EndKind::FullRevolution
    }

    /// The index of the assembly, if every block has a closed form. [`Cycle::assembly_of`](super::Cycle::assembly_of)
    /// gives the assembly.
    #[must_use]
    pub fn assembly(&self) -> Option<usize> {
        self.assembly
    }

    /// The index of its circuit.
    #[must_use]
    pub fn circuit(&self) -> usize {
        self.circuit
    }

    /// The other branches that meet this one at its two ends, by their indices.
    #[must_use]
    pub fn joins(&self) -> [&[usize]; 2] {
        [&self.joins[0], &self.joins[1]]
    }

    /// Some inputs in ascending order with the unknowns there. Angles are unwrapped.
    #[must_use]
    pub fn samples(&self) -> &[(f64, Vec<f64>)] {
        &self.samples
    }
}

/// A circuit: branches that are connected by limits and change points.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Circuit {
    pub(super) branches: Vec<usize>,
    #[cfg_attr(feature = "serde", serde(rename = "input_turns"))]
    pub(super) input_revolutions: Option<i32>,
    #[cfg_attr(feature = "serde", serde(rename = "turns"))]
    pub(super) revolutions: Option<Vec<i32>>,
}

impl Circuit {
    /// The indices of its branches, in the order in which the circuit passes them if it is closed.
    #[must_use]
    pub fn branches(&self) -> &[usize] {
        &self.branches
    }

    /// Whether the mechanism comes back to its start along the circuit. It is false if the circuit ends, or has a
    /// change point, at which it may go different ways.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.revolutions.is_some()
    }

    /// The number of revolutions of the input along a closed circuit, once around: 0 if it swings.
    #[must_use]
    pub fn input_revolutions(&self) -> Option<i32> {
        self.input_revolutions
    }

    /// The number of revolutions of each unknown along a closed circuit, counted as the first branch runs with a
    /// growing input; 0 for lengths.
    #[must_use]
    pub fn revolutions(&self) -> Option<&[i32]> {
        self.revolutions.as_deref()
    }
}

/// All circuits and branches of a mechanism, without its type. A [`Cycle`](super::Cycle) has all methods of this data.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CycleData {
    pub(super) branches: Vec<Branch>,
    pub(super) circuits: Vec<Circuit>,
    pub(super) incomplete: Vec<Incomplete>,
    pub(super) undecided: Vec<(usize, [f64; 2])>,
    pub(super) seeds: Vec<f64>,
    pub(super) period: Option<f64>,
}

impl CycleData {
    /// The circuits.
    #[must_use]
    pub fn circuits(&self) -> &[Circuit] {
        &self.circuits
    }

    /// The branches of all circuits.
    #[must_use]
    pub fn branches(&self) -> &[Branch] {
        &self.branches
    }

    /// Whether it is proved that there is no other branch. The [module](super#what-is-proved) says what that means.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.incomplete.is_empty()
    }

    /// The reasons why there may be other branches; none if the cycle [is complete](Self::is_complete). Each prints as
    /// a clause.
    #[must_use]
    pub fn incomplete(&self) -> &[Incomplete] {
        &self.incomplete
    }

    /// Where it is not decided whether an assembly closes: its index, and a range of the input.
    /// [`Cycle::undecided`](super::Cycle::undecided) has the assemblies themselves.
    #[must_use]
    pub fn undecided_assemblies(&self) -> &[(usize, [f64; 2])] {
        &self.undecided
    }

    /// The inputs at which all positions were sought, in ascending order: the ends of the range, and others if limits
    /// are not enough. It is empty if every block has a closed form.
    #[must_use]
    pub fn seeds(&self) -> &[f64] {
        &self.seeds
    }

    /// The way after which the positions repeat themselves: a revolution of the input, or several. `None` if the range
    /// has ends.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        self.period
    }

    /// The branches that have a position at an input, with the index of each. A branch that passes the input several
    /// times comes several times.
    pub fn at(&self, input: f64) -> impl Iterator<Item = (usize, &Branch)> {
        let period = self.period;
        self.branches.iter().enumerate().flat_map(move |(index, branch)| {
            let [low, high] = branch.ends.each_ref().map(|end| end.input);
            let count = match period {
                Some(period) if branch.is_full_revolution() => Float::round((high - low) / period),
                // The inputs input + k period from the smallest to the largest input.
                Some(period) => Float::floor((high - input) / period) - Float::ceil((low - input) / period) + 1.0,
                None => f64::from(u8::from(input >= low && input <= high)),
            };
            core::iter::successors(Some(1.0), |passed| Some(passed + 1.0))
                .take_while(move |passed| *passed <= count)
                .map(move |_| (index, branch))
        })
    }
}
