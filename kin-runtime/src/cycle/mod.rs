//! The full cycle of a mechanism: all circuits and branches, with their limits.
//!
//! Over an input, the positions of a mechanism form curves. A *circuit* is such a curve: all positions that are reached
//! without taking the mechanism apart. Where an input reverses, two *branches* of a circuit meet (T. R. Chase and J. A.
//! Mirth, *Circuits and branches of single-degree-of-freedom planar linkages*, Journal of Mechanical Design 115 (1993),
//! 223-230). [`FullCycle::cycle`] finds all of them.
//!
//! ```
//! use kin_core::LimitKind;
//! use kin_core::cycle::FullCycle;
//! use kin_core::library::FourBar;
//!
//! let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
//! let cycle = linkage.cycle()?;
//! assert!(cycle.is_complete());
//! // one circuit with two branches: the crank swings, and at both ends the two assemblies meet
//! assert_eq!((cycle.circuits().len(), cycle.branches().len()), (1, 2));
//! let [low, high] = cycle.branches()[0].ends();
//! assert_eq!([low.limit(), high.limit()], [Some(LimitKind::TurningPoint); 2]);
//! assert!((high.input.to_degrees() - 112.0243).abs() < 5e-5 && (low.input + high.input).abs() < 1e-14);
//! # Ok::<(), kin_core::SolveError>(())
//! ```
//!
//! # What is proved
//!
//! If every block has a closed form, the range of the input is divided into intervals. The solver runs on bounds of all
//! values and derivatives over an interval, in interval arithmetic that includes rounding. The bounds prove that an
//! assembly closes everywhere in the interval, or nowhere, or that the condition on which it depends is monotonic
//! there, so that its values at the ends decide whether there is one limit or none. Other intervals are halved until
//! rounding decides, where every length counts as known to one unit in its last place. An assembly that closes on both
//! sides of such an input has a change point there. [`is_complete`](CycleData::is_complete) is then true. One thing is
//! tested and not proved: the choice by a declared range of an unknown is made at the ends and in the middle of each
//! interval.
//!
//! The search has a unit of length for itself, so that a multiple of all lengths has the same cycle.
//!
//! If a block is coupled, all its limits come first: the real solutions of the closure and det J = 0, with the input
//! unknown, by continuation. The macro states the closure as [polynomials](crate::Mechanism::closure_terms) in cosines,
//! sines and lengths. A circuit that does not pass an end of the range has a smallest input, which is a limit. So
//! [`track`](crate::track()) follows all positions at the [ends](CycleData::seeds), and both branches of every limit
//! that was not reached. [`is_complete`](CycleData::is_complete) is true if no path of the continuation was lost, and
//! if tracks and continuation have found the same limits. It holds with the reservation of
//! [`Assemblies`](crate::Assemblies): paths are followed in double precision.
//!
//! This needs polynomials of at most 1024 paths, lengths that cannot become infinite, and unknowns without declared
//! ranges. For any other mechanism all positions are sought at stated inputs, and `is_complete` is false.
//! [`incomplete`](CycleData::incomplete) says why.

mod along;
mod class;
mod closed;
mod closure;
mod coupled;
mod curved;
mod data;
mod free;
mod incomplete;
mod interpolation;
mod joined;
mod limits;
mod line;
mod measure;
mod pieces;
mod polynomial;
mod position;
#[cfg(test)]
mod scale_tests;
mod search;
mod searched;
mod singular;
mod sought;
mod station;
#[cfg(test)]
mod tests;
mod unit;

pub use along::{CircuitAlong, QuantityOnCircuit};
pub use class::{BarkerClass, BlockClass, GrashofType, InvertedSliderCrankType, SliderCrankType};
pub use data::{Branch, Circuit, CycleData, End, EndKind};
pub use incomplete::Incomplete;
pub use measure::{CircuitExtreme, CircuitPeak, MeasureError, Stroke, WorstTransmission};

use alloc::vec::Vec;
use core::ops::Deref;

use crate::any::Of;
use crate::failure::SolveError;
use crate::mechanism::{Mechanism, OneInput};
use crate::number::{ClosedRange, Row};
#[doc(hidden)]
pub use measure::MeasuredFunctions;
#[doc(hidden)]
pub use search::SearchMethod;
pub(crate) use searched::SearchedCycle;
#[doc(hidden)]
pub use sought::SearchedFunctions;
pub(crate) use station::MeasuredCycle;

/// The full cycle of every mechanism.
pub trait FullCycle: Mechanism<Scalar = f64> {
    /// All circuits and branches over the only input: over a revolution of an angle, or as many revolutions as it takes
    /// until the closure repeats itself; and over all lengths that the sum of the links may reach, twice as far as they
    /// reach.
    ///
    /// A plain number, and an angle with which the closure does not repeat itself within twelve revolutions, is taken
    /// from -π to π: [`cycle_over`](Self::cycle_over) takes another range.
    ///
    /// # Errors
    /// An error if a parameter is not finite, and that of the solver if it refuses the lengths, because they are too
    /// large or too small.
    fn cycle(&self) -> Result<Cycle<Self>, SolveError>
    where
        Self::Inputs<f64>: OneInput,
    {
        Cycle::new(self, Row::splat(0.0), Row::splat(1.0), None)
    }

    /// All circuits and branches over a range of the only input. Branches that leave the range end there.
    ///
    /// # Errors
    /// As for `cycle`, and an error if the range is not finite or has no length.
    fn cycle_over(&self, range: impl ClosedRange) -> Result<Cycle<Self>, SolveError>
    where
        Self::Inputs<f64>: OneInput,
    {
        Cycle::new(self, Row::splat(0.0), Row::splat(1.0), Some(range.ends()))
    }

    /// All circuits and branches along a line in the space of the inputs: the inputs are `from + s direction`, and s
    /// replaces the only input of [`cycle`](Self::cycle).
    ///
    /// # Errors
    /// As for `cycle`, and an error if an input is not finite, or if the direction is zero.
    ///
    /// ```
    /// use kin_core::cycle::FullCycle;
    /// use kin_core::library::FiveBar;
    ///
    /// // the left crank rotates, the right one stands still
    /// let robot = FiveBar { ground: 2.0, left: 0.5, left_rod: 2.0, right_rod: 2.0, right: 1.5 };
    /// let cycle = robot.cycle_along([0.0, 1.0], [1.0, 0.0])?;
    /// assert!(cycle.is_complete() && cycle.branches().iter().all(|branch| branch.is_full_revolution()));
    /// # Ok::<(), kin_core::SolveError>(())
    /// ```
    fn cycle_along(&self, from: Self::Inputs<f64>, direction: Self::Inputs<f64>) -> Result<Cycle<Self>, SolveError> {
        Cycle::new(self, from, direction, None)
    }

    /// All circuits and branches on the straight line between two points in the space of the inputs. The first input
    /// that moves replaces the only input of [`cycle_over`](Self::cycle_over), and the others move in proportion, as in
    /// a sweep [`between`](crate::sweep::Assembled::between) these points.
    ///
    /// # Errors
    /// As for `cycle_over`.
    fn cycle_between(&self, from: Self::Inputs<f64>, to: Self::Inputs<f64>) -> Result<Cycle<Self>, SolveError> {
        let (parameters, ends) = (self.parameters(), [from.as_ref(), to.as_ref()]);
        Ok(Cycle {
            mechanism: *self,
            searched: SearchedCycle::between(Of::<Self>::FUNCTIONS, parameters.as_ref(), ends)?,
        })
    }
}

impl<M: Mechanism<Scalar = f64>> FullCycle for M {}

/// All circuits and branches of a mechanism. [`FullCycle`] makes it.
///
/// It has all methods of [`CycleData`], which knows nothing of the mechanism's type.
#[derive(Clone, Debug)]
pub struct Cycle<M: Mechanism<Scalar = f64>> {
    mechanism: M,
    searched: SearchedCycle<'static>,
}

impl<M: Mechanism<Scalar = f64>> Deref for Cycle<M> {
    type Target = CycleData;

    fn deref(&self) -> &CycleData {
        &self.searched.data
    }
}

impl<M: Mechanism<Scalar = f64>> Cycle<M> {
    fn new(
        mechanism: &M,
        from: M::Inputs<f64>,
        direction: M::Inputs<f64>,
        range: Option<[f64; 2]>,
    ) -> Result<Self, SolveError> {
        let parameters = mechanism.parameters();
        let line = [from.as_ref(), direction.as_ref()];
        Ok(Self {
            mechanism: *mechanism,
            searched: SearchedCycle::new(Of::<M>::FUNCTIONS, parameters.as_ref(), line, range)?,
        })
    }

    /// The assemblies of closed forms about which the bounds decided nothing, each with a range of the input. There,
    /// only the ends and the middles of intervals were tried.
    ///
    /// A block that can move while its input stands still leads here, such as two equal links whose ends coincide at
    /// every input. In four of the eight assemblies of Peaucellier's cell, the rhombus is folded, and two of its links
    /// rotate freely:
    ///
    /// ```
    /// use kin_core::cycle::FullCycle;
    /// use kin_core::library::PeaucellierLinkage;
    ///
    /// let cycle = PeaucellierLinkage { ground: 2.0, crank: 1.9, arm: 6.0, side: 4.0 }.cycle()?;
    /// assert!(!cycle.is_complete());
    /// // the two dyads on the arms are both open or both crossed
    /// assert!(cycle.undecided().iter().all(|(assembly, _)| assembly.alpha_gamma == assembly.beta_delta));
    /// # Ok::<(), kin_core::SolveError>(())
    /// ```
    #[must_use]
    pub fn undecided(&self) -> Vec<(M::Assembly, [f64; 2])> {
        let undecided = self.undecided.iter();
        let typed = undecided.filter_map(|(index, range)| Some((M::assembly(*index)?, *range)));
        typed.collect()
    }

    /// The branches of an assembly, with the index of each; none if a block is coupled.
    ///
    /// ```
    /// use kin_core::library::JansenLeg;
    /// use kin_core::prelude::*;
    ///
    /// let cycle = JansenLeg::HOLY_NUMBERS.cycle()?;
    /// let (_, walking) = cycle.branches_of(JansenLeg::WALKING).next().expect("the leg walks");
    /// assert!(walking.is_full_revolution());
    /// # Ok::<(), SolveError>(())
    /// ```
    pub fn branches_of(&self, assembly: M::Assembly) -> impl Iterator<Item = (usize, &Branch)> {
        let index = M::assemblies().position(|other| other == assembly);
        let branches = self.branches().iter().enumerate();
        branches.filter(move |(_, branch)| index.is_some() && branch.assembly == index)
    }

    /// The assembly of a branch, if there is such a branch and every block has a closed form.
    #[must_use]
    pub fn assembly_of(&self, branch: usize) -> Option<M::Assembly> {
        M::assembly(self.branches().get(branch)?.assembly()?)
    }

    /// The mechanism.
    #[must_use]
    pub fn mechanism(&self) -> &M {
        &self.mechanism
    }

    /// The inputs at a coordinate of the line: the only input itself, or `from + s direction`.
    #[must_use]
    pub fn inputs(&self, input: f64) -> M::Inputs<f64> {
        let inputs = self.searched.line.inputs(input);
        Row::from_fn(|index| inputs[index])
    }
}
