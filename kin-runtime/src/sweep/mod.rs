//! Sweeps: many poses of one mechanism, over an input, over time or along columns.
//!
//! ```
//! use std::f64::consts::TAU;
//! use kin_core::library::FourBar;
//! use kin_core::prelude::*;
//!
//! let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
//! // a revolution of the crank at 10 rad/s, in 361 rows
//! let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 361).speed(10.0);
//!
//! // as poses, one after the other
//! for pose in sweep.rows() {
//!     println!("{}", pose?.theta4.acceleration());
//! }
//!
//! // as a table
//! let table = sweep.table()?;
//! let jerk = table.column("theta4_jerk")?;
//! assert_eq!(jerk.len(), 361);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | the inputs move | by |
//! |---|---|
//! | over a range, at constant speed | [`over`](Assembled::over), [`between`](Assembled::between) for several inputs |
//! | over time, by a formula | [`by_formula`](Assembled::by_formula) |
//! | over time, by any function | [`over_time`](Assembled::over_time) |
//! | over time, by motion laws | [`under_laws`](Assembled::under_laws) |
//! | along columns | [`along`](Assembled::along) |
//!
//! # The assembly
//! A sweep stays in its assembly. Blocks with a closed form find it in every row. Blocks of coupled equations start
//! near the given values, and are [tracked](crate::track()) from row to row. They stay in their circuit: where it ends
//! the sweep ends too, and rows beyond the gap do not close again.
//!
//! Angles are unwrapped, whatever the number of rows: a crank stands at 4π after two revolutions. The rates predict
//! each angle from row to row, and steps that are too long for it are halved. Angles of outputs continue in the same
//! way, and what is calculated from an angle, as the position of a rack, follows it.

mod adaptive;
mod columns;
mod display;
mod drive;
mod error;
mod fill;
mod footing;
mod gaps;
#[doc(hidden)]
pub mod guessed;
mod limits;
mod names;
mod rows;
#[cfg(test)]
pub(crate) mod samples;
mod smooth;
mod table;
#[cfg(test)]
mod tests;
mod untyped;
mod unwrap;
mod walk;

pub use columns::{ColumnOf, Label, Unit};
#[doc(hidden)]
pub use drive::READ;
pub use drive::{
    Along, ByFormula, Drive, InputMotions, Instant, Laws, Local, OverTime, SmoothDrive, StraightLine, Variable,
};
pub(crate) use drive::{TERMS, by_time, write_steady};
pub use error::SweepError;
#[doc(hidden)]
pub use fill::TabledMechanism;
pub(crate) use footing::Footing;
pub use limits::Limit;
pub(crate) use limits::between as limit_between;
pub use names::NoSuchColumn;
pub use rows::Rows;
pub(crate) use smooth::composed;
pub use table::{RowOf, Table};
#[doc(hidden)]
pub use untyped::SweptMechanism;
pub(crate) use untyped::{UntypedSweep, joints};
pub(crate) use walk::Walk;

use crate::batch::Column;
use crate::failure::InputNames;
use crate::law::Piecewise;
use crate::mechanism::{Mechanism, OneInput};
use crate::number::{ClosedRange, Row};

/// The first word of a sweep, for every mechanism.
pub trait Swept: Mechanism<Scalar = f64> {
    /// A sweep of this mechanism in an assembly. The next word says how its inputs move.
    ///
    /// For a mechanism with coupled blocks, the assembly is [`Near`](crate::Near) values of the unknowns at the first
    /// row. A mechanism with a single position has a method of the same name without this argument: `lift.sweep()`.
    fn sweep(&self, assembly: Self::Assembly) -> Assembled<Self> {
        Assembled {
            mechanism: *self,
            assembly,
        }
    }
}

impl<M: Mechanism<Scalar = f64>> Swept for M {}

/// A mechanism in an assembly, of which a sweep is wanted.
#[derive(Clone, Copy, Debug)]
#[must_use = "say how the inputs move, as in `over`"]
pub struct Assembled<M: Mechanism<Scalar = f64>> {
    mechanism: M,
    assembly: M::Assembly,
}

/// A sweep: a mechanism in an assembly, whose inputs move.
#[derive(Clone, Debug)]
#[must_use = "read its `rows` or its `table`"]
pub struct Sweep<M: Mechanism<Scalar = f64>, D> {
    pub(crate) mechanism: M,
    pub(crate) assembly: M::Assembly,
    pub(crate) drive: D,
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) count: usize,
}

impl<M: Mechanism<Scalar = f64>> Assembled<M> {
    fn sweep<D>(self, drive: D, range: impl ClosedRange, count: usize) -> Sweep<M, D> {
        let [from, to] = range.ends();
        Sweep {
            mechanism: self.mechanism,
            assembly: self.assembly,
            drive,
            from,
            to,
            count,
        }
    }

    /// Over a range of the only input, in a number of rows at equal distances; the first and the last stand at the ends
    /// of the range. The range may run downwards, and the input then moves downwards in time.
    ///
    /// The speed is 1 unless [`speed`](Sweep::speed) gives another one, so that rates are per unit of the way. A
    /// mechanism of several inputs takes [`between`](Self::between).
    pub fn over(self, range: impl ClosedRange, rows: usize) -> Sweep<M, StraightLine>
    where
        M::Inputs<f64>: OneInput,
    {
        let [from, to] = range.ends().map(Row::splat);
        self.between(from, to, rows)
    }

    /// Over the straight line between two points in the space of the inputs. The variable of the sweep is the first
    /// input that moves, and the others move in proportion.
    ///
    /// ```
    /// use kin_core::library::FiveBar;
    /// use kin_core::prelude::*;
    ///
    /// let robot = FiveBar { ground: 2.0, left: 1.5, left_rod: 2.0, right_rod: 2.0, right: 1.5 };
    /// // the left crank at 3 rad/s, the right one rotates the other way
    /// let move_up = robot.sweep(Assembly::Open).between([1.0, 2.0], [2.0, 1.0], 100).speed(3.0);
    /// let table = move_up.table()?;
    /// assert_eq!(table.column("beta_velocity")?[0], -3.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn between(self, from: M::Inputs<f64>, to: M::Inputs<f64>, rows: usize) -> Sweep<M, StraightLine> {
        let line = StraightLine::new(from.as_ref(), to.as_ref());
        let range = line.range();
        self.sweep(line, range[0]..=range[1], rows)
    }

    /// Over a range of the time, with a function that gives the motion of every input: an array of what `solve` takes.
    ///
    /// Only the poses of the rows are read. [Extremes](crate::extremes) between them need
    /// [`by_formula`](Self::by_formula) or [`under_laws`](Self::under_laws), which know derivatives above the order of
    /// the mechanism.
    ///
    /// ```
    /// use kin_core::library::SliderCrank;
    /// use kin_core::prelude::*;
    ///
    /// let press = SliderCrank { r: 0.1, l: 0.3 };
    /// // the crank speeds up from rest by 2 rad/s²
    /// let crank = |t| [Motion::polynomial(&[0.0, 0.0, 1.0], t)];
    /// let start = press.sweep(Assembly::Open).over_time(0.0..=1.0, 101, crank);
    /// assert_eq!(start.table()?.column("theta_velocity")?[100], 2.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn over_time<'f>(
        self,
        range: impl ClosedRange,
        rows: usize,
        motions: impl Fn(f64) -> InputMotions<M, f64> + 'f,
    ) -> Sweep<M, OverTime<'f>> {
        self.sweep(OverTime::new::<M>(motions), range, rows)
    }

    /// Over a range of the time, with a formula that gives the value of every input. It is calculated in numbers that
    /// carry their derivatives, so the formula says nothing of rates.
    ///
    /// ```
    /// use kin_core::library::SliderCrank;
    /// use kin_core::prelude::*;
    ///
    /// let press = SliderCrank { r: 0.1, l: 0.3 };
    /// // the crank swings by half a radian about one, twice a second
    /// let frequency = 2.0 * std::f64::consts::TAU;
    /// let swing = press
    ///     .sweep(Assembly::Open)
    ///     .by_formula(0.0..=0.5, 101, |time| [1.0 + 0.5 * (frequency * time).sin()]);
    /// println!("{} m/s³", swing.of("s_jerk").peak()?);
    /// # Ok::<(), kin_core::extremes::ExtremesError>(())
    /// ```
    pub fn by_formula<'f>(
        self,
        range: impl ClosedRange,
        rows: usize,
        formula: impl Fn(Instant) -> M::Inputs<Instant> + 'f,
    ) -> Sweep<M, ByFormula<'f>> {
        self.sweep(ByFormula::new::<M>(formula), range, rows)
    }

    /// Over a range of the time, with a [motion law](crate::law) for each input, in brackets. A law whose value jumps
    /// inside of the range is an error of every question to the sweep, unless an angle jumps by whole revolutions.
    ///
    /// ```
    /// use kin_core::law::{Rise, Shape};
    /// use kin_core::library::SliderCrank;
    /// use kin_core::prelude::*;
    ///
    /// let press = SliderCrank { r: 0.1, l: 0.3 };
    /// let servo = Rise::new(Shape::ModifiedSine, 0.0, 90_f64.to_radians(), 0.4)?;
    /// let move_down = press.sweep(Assembly::Open).under_laws([&servo], 0.0..=0.4, 200);
    /// let peak = move_down.of("s_jerk").peak()?;
    /// println!("{} m/s³ at {} s", peak.value, peak.at);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn under_laws(
        self,
        laws: M::Inputs<&dyn Piecewise<f64>>,
        range: impl ClosedRange,
        rows: usize,
    ) -> Sweep<M, Laws<'_>> {
        self.sweep(
            Laws::new(laws.as_ref(), InputNames::Declared(M::DESCRIPTION.inputs)),
            range,
            rows,
        )
    }

    /// Along columns: one for each order of each input, as a [batch](crate::batch) takes them. The number of rows is
    /// the length of the first column that has one.
    ///
    /// Limits between two rows are those on the straight line between their inputs, and their positions are parts of
    /// the way from one row to the next.
    #[expect(clippy::cast_precision_loss, reason = "a table has far fewer rows than 2⁵³")]
    pub fn along(self, columns: InputMotions<M, Column<'_>>) -> Sweep<M, Along<'_>> {
        let along = Along::new::<M>(&columns);
        let count = along.count();
        self.sweep(along, 0.0..=count.saturating_sub(1) as f64, count)
    }
}

impl<M: Mechanism<Scalar = f64>> Sweep<M, StraightLine> {
    /// The speed of the input, or of the first input that moves, in the direction of the range: over a range that runs
    /// downwards, its velocity is negative. A negative speed moves against the range, so that the last row is the first
    /// one in time.
    ///
    /// ```
    /// use kin_core::library::SliderCrank;
    /// use kin_core::prelude::*;
    ///
    /// let press = SliderCrank { r: 0.1, l: 0.3 };
    /// let back = press.sweep(Assembly::Open).over(2.0..=1.0, 11).speed(5.0);
    /// assert_eq!(back.table()?.column("theta_velocity")?[0], -5.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn speed(mut self, speed: f64) -> Self {
        self.drive = self.drive.at_speed(speed);
        self
    }
}

impl<M: Mechanism<Scalar = f64>, D: Drive> Sweep<M, D> {
    /// The number of rows.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// The value of the variable in a row.
    #[must_use]
    pub fn at(&self, row: usize) -> f64 {
        row_at([self.from, self.to], self.count, row)
    }

    /// The poses, one after the other.
    ///
    /// A row that does not close is an error with its margin. Where a coupled block does not close, the margin is the
    /// distance of the inputs to the end of their circuit. Where the way to a row was too long to be tracked, the error
    /// is [`NotConverged`](crate::Failure::NotConverged), which has no margin, and whose condition is NaN.
    #[must_use]
    pub fn rows(&self) -> Rows<'_, M, D> {
        Rows::new(self)
    }
}

/// The value of the variable in a row of a sweep.
#[expect(clippy::cast_precision_loss, reason = "a table has far fewer rows than 2⁵³")]
fn row_at([from, to]: [f64; 2], count: usize, row: usize) -> f64 {
    if row == 0 {
        from
    } else if row + 1 >= count {
        to
    } else {
        from + (to - from) * (row as f64 / (count - 1) as f64)
    }
}
