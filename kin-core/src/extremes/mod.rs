//! Peaks, extremes, zeros, dwells and means of a sweep, exact to rounding.
//!
//! ```
//! use std::f64::consts::TAU;
//! use kin_core::library::FourBar;
//! use kin_core::prelude::*;
//!
//! let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
//! let turn = linkage.sweep(Assembly::Open).over(0.0..=TAU, 361).speed(10.0);
//! let peak = turn.peak("theta4_acceleration")?;
//! println!("{} rad/s² at {}°", peak.value, peak.at.to_degrees());
//!
//! // there the jerk vanishes
//! let pose = linkage.solve(Motion::at_constant_speed(peak.at, 10.0), Assembly::Open)?;
//! assert!(pose.theta4.jerk().abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A question is asked to the sweep itself, and the answer does not depend on its rows: extremes are found between them. The quantity is
//! called by the name of its column, or is any expression of the pose by a closure: see [`At`]. Names go on above the order of the
//! mechanism, up to the twelfth derivative: `theta4_crackle`, `theta4_pop`, `theta4_derivative_7`. `margin` is the length that is left
//! until the first dyad ceases to close.
//!
//! # Method
//! The positions are solved in numbers that carry their Taylor series in the variable of the sweep; rates are read from them. A closure
//! gets a typed pose, whose rates are solved in such numbers. A piece of the curve between
//! two poses is the Hermite polynomial of degree 9 that agrees with both series. Pieces are halved until they agree with the
//! poses at a third, the middle and two thirds. Descartes' rule isolates the zeros of the slope of each piece, and Newton's
//! method refines them on the poses themselves.
//!
//! Towards a turning point the curve is a root of the variable. There the parameter is the root of the distance, in which the
//! curve is smooth. A rate that grows beyond all bounds is `Unbounded`, never a number. Within 10⁻⁵ of the way to a turning point, values
//! come from the series next to it. At a change point, where the rates jump, each side has a stretch of its own, whose values next to the
//! change point come from its series as well.
//!
//! Two extremes are told from rounding errors if the quantity differs between them by more than 10⁻⁸ of the range of their piece, and by
//! more than 10⁻¹² of its size.

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

pub use answer::Answer;
pub use at::At;
pub(crate) use branch::KnownStretch;
pub use error::ExtremesError;
pub use mean::{Mean, Over};
pub use sensitivity::{PeakSensitivities, PeakSensitivity};

use alloc::vec::Vec;
use core::fmt;

use curve::Curve;
use progress::Progress;
use quantity::Named;
use station::SweepStation;
use swept::{PoseQuantity, QuantityOfSweep};

use crate::mechanism::Mechanism;
use crate::quantity::Digits;
use crate::sweep::{Course, SmoothDrive};

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
    /// The quantity grows beyond all bounds towards a turning point.
    Unbounded,
}

/// A place where a quantity is larger or smaller than on both sides.
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

/// A place where a quantity crosses a level.
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
    /// Its end. A dwell through the seam of a full turn ends beyond the end of the sweep.
    pub to: f64,
    /// Its time, in the unit of time of the rates.
    pub duration: f64,
}

/// Extremes and means. A quantity is called by the name of its column, as in `"theta4_jerk"`; the methods that end on `_by` take a
/// closure, as in `|at| at.theta4.jerk()`, for any expression of a pose, or `|at| at.effort(&loads, 0)` for the effort of a drive.
///
/// # Errors
/// [`ExtremesError`] for all of them.
impl<M: Mechanism<Scalar = f64>, D: SmoothDrive<M>> Course<M, D> {
    /// The value that is largest in size, and where.
    ///
    /// # Errors
    /// [`ExtremesError::Unbounded`] if the quantity has none, and the errors of [`extremes_by`](Self::extremes_by).
    pub fn peak(&self, name: &str) -> Result<Peak, ExtremesError> {
        let named = Named::find::<M>(name)?;
        self.best(&|station| named.at(station), f64::abs)
    }

    /// [`peak`](Self::peak) of an expression.
    ///
    /// # Errors
    /// As for [`peak`](Self::peak).
    pub fn peak_by<A: Answer>(&self, quantity: impl Fn(&At<M>) -> A) -> Result<Peak, ExtremesError> {
        self.best(&|station| station.answer(None, &quantity), f64::abs)
    }

    /// [`peak`](Self::peak), which tells how far it has come, as [`extremes_with_progress`](Self::extremes_with_progress) does.
    ///
    /// # Errors
    /// As for [`peak`](Self::peak).
    pub fn peak_with_progress(&self, name: &str, progress: impl FnMut(f64)) -> Result<Peak, ExtremesError> {
        let named = Named::find::<M>(name)?;
        let progress = Progress::new(progress);
        let (answer, tell) = (
            |station: &SweepStation<M>| named.at(station),
            |part: f64| progress.reach(part),
        );
        let asked = self.asked(&answer);
        let curve = Curve::new(&asked).telling(&tell);
        let peak = curve.across_gaps(|curve| curve.best(f64::abs))?;
        progress.end();
        Ok(peak)
    }

    /// The highest value, and where.
    ///
    /// # Errors
    /// [`ExtremesError::Unbounded`] if there is none, and the errors of [`extremes_by`](Self::extremes_by).
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::SliderCrank;
    /// use kin_core::prelude::*;
    ///
    /// let press = SliderCrank { r: 0.1, l: 0.3 };
    /// let turn = press.sweep(Assembly::Open).over(0.0..=TAU, 100);
    /// assert!((turn.highest("s")?.value - 0.4).abs() < 1e-15 && (turn.lowest("s")?.value - 0.2).abs() < 1e-15);
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    pub fn highest(&self, name: &str) -> Result<Peak, ExtremesError> {
        let named = Named::find::<M>(name)?;
        self.best(&|station| named.at(station), |value| value)
    }

    /// [`highest`](Self::highest) of an expression.
    ///
    /// # Errors
    /// As for [`highest`](Self::highest).
    pub fn highest_by<A: Answer>(&self, quantity: impl Fn(&At<M>) -> A) -> Result<Peak, ExtremesError> {
        self.best(&|station| station.answer(None, &quantity), |value| value)
    }

    /// The lowest value, and where.
    ///
    /// # Errors
    /// As for [`highest`](Self::highest).
    pub fn lowest(&self, name: &str) -> Result<Peak, ExtremesError> {
        let named = Named::find::<M>(name)?;
        self.best(&|station| named.at(station), |value| -value)
    }

    /// [`lowest`](Self::lowest) of an expression.
    ///
    /// # Errors
    /// As for [`highest`](Self::highest).
    pub fn lowest_by<A: Answer>(&self, quantity: impl Fn(&At<M>) -> A) -> Result<Peak, ExtremesError> {
        self.best(&|station| station.answer(None, &quantity), |value| -value)
    }

    fn asked<'q>(&'q self, quantity: &'q PoseQuantity<'q, M>) -> QuantityOfSweep<'q, M, D> {
        QuantityOfSweep {
            course: self,
            quantity,
            known: None,
        }
    }

    fn best(&self, quantity: &PoseQuantity<'_, M>, rank: fn(f64) -> f64) -> Result<Peak, ExtremesError> {
        Curve::new(&self.asked(quantity)).across_gaps(|curve| curve.best(rank))
    }

    /// The [`peak`](Self::peak), and how its value and its place depend on every dimension of the mechanism.
    ///
    /// A peak between the ends of the sweep is taken where it is. One at an end of the sweep stays there. At a limit or a kink there is
    /// none: it moves with the limit, and its value need not have a derivative.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let turn = linkage.sweep(Assembly::Open).over(0.0..=TAU, 361).speed(10.0);
    /// let found = turn.peak_sensitivities("theta4_acceleration")?;
    /// for (name, by) in ["r1", "r2", "r3", "r4"].iter().zip(found.by) {
    ///     println!("{name}: {} rad/s² for each unit of length, and {} rad", by.value, by.at);
    /// }
    /// // a longer crank makes the rocker faster
    /// assert!(found.by[1].value * found.peak.value > 0.0);
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    ///
    /// # Errors
    /// [`ExtremesError::NoSensitivity`] if the peak is at a limit or a kink, and the errors of [`peak`](Self::peak).
    pub fn peak_sensitivities(&self, name: &str) -> Result<PeakSensitivities<M>, ExtremesError> {
        let named = Named::find_up_to::<M>(name, M::DESCRIPTION.order)?;
        let quantity = |station: &SweepStation<M>| named.at(station);
        let asked = self.asked(&quantity);
        Curve::new(&asked).across_gaps(|curve| asked.sensitivities(curve, curve.best(f64::abs)?, |at| named.of(at)))
    }

    /// [`peak_sensitivities`](Self::peak_sensitivities) of an expression: of the effort of a drive, for example.
    ///
    /// # Errors
    /// As for [`peak_sensitivities`](Self::peak_sensitivities).
    pub fn peak_sensitivities_by<A: Answer>(
        &self,
        quantity: impl Fn(&At<M>) -> A,
    ) -> Result<PeakSensitivities<M>, ExtremesError> {
        let answer = |station: &SweepStation<M>| station.answer(None, &quantity);
        let asked = self.asked(&answer);
        Curve::new(&asked).across_gaps(|curve| asked.sensitivities(curve, curve.best(f64::abs)?, &quantity))
    }

    /// All extremes, in the order of the sweep: those inside, those at limits and kinks, and those at its ends. A full turn has no ends.
    ///
    /// ```
    /// use kin_core::extremes::ExtremeKind;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
    /// let sweep = linkage.sweep(Assembly::Open).over(-3.0..=3.0, 100);
    /// for extreme in sweep.extremes("theta4")? {
    ///     println!("{extreme}");
    /// }
    /// // at its limits the rocker has no finite velocity
    /// let velocity = sweep.extremes("theta4_velocity")?;
    /// assert_eq!((velocity[0].kind, velocity[0].value), (ExtremeKind::Unbounded, None));
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    ///
    /// # Errors
    /// [`ExtremesError`] if there is no such name, if nothing closes, if the sweep has no length, or if the curve of the quantity is too
    /// rough to be searched.
    pub fn extremes(&self, name: &str) -> Result<Vec<Extreme>, ExtremesError> {
        let named = Named::find::<M>(name)?;
        Ok(Curve::new(&self.asked(&|station| named.at(station)))
            .across_gaps(Curve::extremes)?
            .extremes)
    }

    /// [`extremes`](Self::extremes) of quantities that take long: `progress` is called with the part of the sweep that has been searched,
    /// which grows. It is 1 in the last call, unless the answer is an error.
    ///
    /// The calls come after each of the pieces with which a search begins: 24 for a turn of an input, or for all of another sweep, and at
    /// least 4 between two joints of a law.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let turn = linkage.sweep(Assembly::Open).over(0.0..=TAU, 361);
    /// let mut parts = vec![];
    /// let extremes = turn.extremes_with_progress("theta4_derivative_9", |part| parts.push(part))?;
    /// println!("{} extremes", extremes.len());
    /// assert_eq!((parts.len(), parts[23]), (24, 1.0));
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`extremes`](Self::extremes).
    pub fn extremes_with_progress(&self, name: &str, progress: impl FnMut(f64)) -> Result<Vec<Extreme>, ExtremesError> {
        let named = Named::find::<M>(name)?;
        let progress = Progress::new(progress);
        let (answer, tell) = (
            |station: &SweepStation<M>| named.at(station),
            |part: f64| progress.reach(part),
        );
        let asked = self.asked(&answer);
        let curve = Curve::new(&asked).telling(&tell);
        let found = curve.across_gaps(Curve::extremes)?;
        progress.end();
        Ok(found.extremes)
    }

    /// [`extremes`](Self::extremes) of an expression.
    ///
    /// # Errors
    /// As for [`extremes`](Self::extremes).
    pub fn extremes_by<A: Answer>(&self, quantity: impl Fn(&At<M>) -> A) -> Result<Vec<Extreme>, ExtremesError> {
        let answer = |station: &SweepStation<M>| station.answer(None, &quantity);
        Ok(Curve::new(&self.asked(&answer)).across_gaps(Curve::extremes)?.extremes)
    }

    /// The places where a quantity crosses a level, in the order of the sweep: zero for its changes of sign. A jump across the level, where
    /// two pieces of a law meet, counts as well.
    ///
    /// # Errors
    /// [`ExtremesError::Argument`] if the level is not finite, and the errors of [`extremes`](Self::extremes).
    pub fn crossings(&self, name: &str, level: f64) -> Result<Vec<Crossing>, ExtremesError> {
        let named = Named::find::<M>(name)?;
        Curve::new(&self.asked(&|station| named.at(station))).across_gaps(|curve| curve.crossings(level))
    }

    /// [`crossings`](Self::crossings) of an expression.
    ///
    /// # Errors
    /// As for [`crossings`](Self::crossings).
    pub fn crossings_by<A: Answer>(
        &self,
        quantity: impl Fn(&At<M>) -> A,
        level: f64,
    ) -> Result<Vec<Crossing>, ExtremesError> {
        let answer = |station: &SweepStation<M>| station.answer(None, &quantity);
        Curve::new(&self.asked(&answer)).across_gaps(|curve| curve.crossings(level))
    }

    /// The parts of the sweep on which a quantity stays within a tolerance of a level.
    ///
    /// # Errors
    /// [`ExtremesError::Argument`] if the level or the tolerance is not finite, and the errors of [`extremes`](Self::extremes).
    pub fn dwells(&self, name: &str, level: f64, tolerance: f64) -> Result<Vec<DwellRange>, ExtremesError> {
        let named = Named::find::<M>(name)?;
        Curve::new(&self.asked(&|station| named.at(station))).across_gaps(|curve| curve.dwells(level, tolerance))
    }

    /// [`dwells`](Self::dwells) of an expression.
    ///
    /// # Errors
    /// As for [`dwells`](Self::dwells).
    pub fn dwells_by<A: Answer>(
        &self,
        quantity: impl Fn(&At<M>) -> A,
        level: f64,
        tolerance: f64,
    ) -> Result<Vec<DwellRange>, ExtremesError> {
        let answer = |station: &SweepStation<M>| station.answer(None, &quantity);
        Curve::new(&self.asked(&answer)).across_gaps(|curve| curve.dwells(level, tolerance))
    }

    /// The mean, over the time or over the way of the input. Both are the same at constant speed.
    ///
    /// # Errors
    /// [`ExtremesError::Diverges`] if the integral has no value because of a turning point,
    /// [`ExtremesError::Imprecise`] if the estimate of the error stays above 10⁻¹² of the mean size, and the errors of
    /// [`extremes`](Self::extremes).
    pub fn mean(&self, name: &str, over: Over) -> Result<Mean, ExtremesError> {
        let named = Named::find::<M>(name)?;
        Curve::new(&self.asked(&|station| named.at(station))).across_gaps(|curve| curve.mean(over, 1))
    }

    /// [`mean`](Self::mean) of an expression.
    ///
    /// # Errors
    /// As for [`mean`](Self::mean).
    pub fn mean_by<A: Answer>(&self, quantity: impl Fn(&At<M>) -> A, over: Over) -> Result<Mean, ExtremesError> {
        let answer = |station: &SweepStation<M>| station.answer(None, &quantity);
        Curve::new(&self.asked(&answer)).across_gaps(|curve| curve.mean(over, 1))
    }

    /// The root of the mean square.
    ///
    /// # Errors
    /// As for [`mean`](Self::mean).
    pub fn rms(&self, name: &str, over: Over) -> Result<Mean, ExtremesError> {
        let named = Named::find::<M>(name)?;
        rooted(Curve::new(&self.asked(&|station| named.at(station))).across_gaps(|curve| curve.mean(over, 2)))
    }

    /// [`rms`](Self::rms) of an expression.
    ///
    /// # Errors
    /// As for [`mean`](Self::mean).
    pub fn rms_by<A: Answer>(&self, quantity: impl Fn(&At<M>) -> A, over: Over) -> Result<Mean, ExtremesError> {
        let answer = |station: &SweepStation<M>| station.answer(None, &quantity);
        rooted(Curve::new(&self.asked(&answer)).across_gaps(|curve| curve.mean(over, 2)))
    }
}

/// The root of a mean square.
fn rooted(square: Result<Mean, ExtremesError>) -> Result<Mean, ExtremesError> {
    let root = |value: f64, error: f64| {
        let root = num_traits::Float::sqrt(value);
        (root, if root > 0.0 { 0.5 * error / root } else { 0.0 })
    };
    match square {
        Ok(square) => {
            let (value, error) = root(square.value, square.error);
            Ok(Mean {
                value,
                error,
                covered: square.covered,
            })
        }
        Err(ExtremesError::Imprecise { value, error }) => {
            let (value, error) = root(value, error);
            Err(ExtremesError::Imprecise { value, error })
        }
        Err(error) => Err(error),
    }
}
