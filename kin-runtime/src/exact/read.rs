//! Tables in bytes, read in place.

use core::ops::RangeInclusive;

use num_traits::Float;

use super::error::{LookupError, ReadError};
use super::piece::{MOST_NUMBERS, piece};
use crate::motion::Motion;
use crate::quantity::Dimension;

/// The version of the format.
pub(super) const VERSION: u32 = 1;
/// The first bytes.
pub(super) const MAGIC: [u8; 8] = *b"kinExact";
/// The number of bytes of the head.
pub(super) const HEAD: usize = 32;
/// The most periods between the first row of a closed table and a parameter. With more of them, the parameters that can
/// be distinguished are further apart than 1/512 of a period.
pub(super) const MOST_PERIODS: f64 = 8_796_093_022_208.0;
/// The number of bytes of a number.
pub(super) const WORD: usize = 8;

/// An exact table that is read where it lies, without the standard library and without allocating: in a file, in flash
/// memory, in a constant by `include_bytes!`.
///
/// ```
/// use std::f64::consts::TAU;
/// use kin_core::exact::ExactTableRef;
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
/// let table = linkage.sweep(Assembly::Open).over(0.0..=TAU, 13).exact_table(1e-7)?;
/// let bytes: &[u8] = table.as_bytes();
///
/// // on another machine
/// let table = ExactTableRef::new(bytes)?;
/// let rocker = table.column("theta4").expect("the four-bar has this angle");
/// // the crank stands at 1 and rotates at 10 rad/s
/// let [angle, velocity, acceleration] = rocker.at_speed(1.0, 10.0)?;
/// # let pose = linkage.solve([1.0, 10.0, 0.0, 0.0, 0.0], Assembly::Open)?;
/// # assert!((angle - pose.theta4.position()).abs() < 1e-8);
/// # assert!((acceleration - pose.theta4.acceleration()).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExactTableRef<'b> {
    bytes: &'b [u8],
    layout: Layout,
    text: &'b str,
}

/// What the head of a table says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Layout {
    order: usize,
    columns: usize,
    rows: usize,
    is_closed: bool,
    /// The length of the names.
    text: usize,
}

/// A column of an exact table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExactColumn<'b> {
    table: ExactTableRef<'b>,
    index: usize,
}

/// The sum of bytes that is stored behind them, by the method of Fowler, Noll and Vo (FNV-1a, 64 bits).
pub(super) fn checksum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |sum, byte| {
        (sum ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

const fn contradiction<T>(what: &'static str) -> Result<T, ReadError> {
    Err(ReadError::Contradiction { what })
}

fn word(bytes: &[u8], start: usize) -> Option<u32> {
    let found = bytes.get(start..start + 4)?;
    Some(u32::from_le_bytes(found.try_into().ok()?))
}

/// A dimension and a name from a line of the text.
fn named(line: &str) -> Option<(Dimension, &str)> {
    let (letter, name) = line.split_once(' ')?;
    let dimension = match letter {
        "A" => Dimension::Angle,
        "L" => Dimension::Length,
        "S" => Dimension::Scalar,
        _ => return None,
    };
    Some((dimension, name)).filter(|_| !name.is_empty())
}

impl<'b> ExactTableRef<'b> {
    /// The table in these bytes. Everything is checked once, so no later call can fail for the sake of the bytes.
    ///
    /// # Errors
    /// [`ReadError`], for bytes that are no table, are damaged or were written by a newer version.
    pub fn new(bytes: &'b [u8]) -> Result<Self, ReadError> {
        if bytes.get(..MAGIC.len()) != Some(&MAGIC) {
            return Err(ReadError::NotATable);
        }
        let too_short = |expected: u64| ReadError::Length {
            expected,
            found: bytes.len() as u64,
        };
        let word = |start| word(bytes, start).ok_or(too_short(HEAD as u64));
        let version = word(8)?;
        if version > VERSION {
            return Err(ReadError::Newer {
                found: version,
                known: VERSION,
            });
        }
        let [order, columns, rows, flags, length] = [word(12)?, word(16)?, word(20)?, word(24)?, word(28)?];
        if version == 0 || flags > 1 || !(1..MOST_NUMBERS).contains(&(order as usize)) || columns == 0 || rows < 2 {
            return contradiction("its head is not one that kin writes");
        }
        let [order_count, column_count, row_count] = [order + 1, columns, rows].map(u64::from);
        let numbers = column_count
            .checked_mul(order_count)
            .and_then(|per_row| Some((per_row, per_row.checked_add(1)?.checked_mul(row_count)?)))
            .and_then(|(per_row, all)| {
                all.checked_add(per_row)?
                    .checked_add(column_count)?
                    .checked_mul(WORD as u64)
            });
        let padded = u64::from(length).next_multiple_of(WORD as u64);
        let expected = numbers.and_then(|numbers| numbers.checked_add(HEAD as u64 + padded + WORD as u64));
        if expected != Some(bytes.len() as u64) {
            return Err(too_short(expected.unwrap_or(u64::MAX)));
        }
        let (all, sum) = bytes.split_at(bytes.len() - WORD);
        let stored = sum.iter().rev().fold(0, |sum, byte| sum << 8 | u64::from(*byte));
        let found = checksum(all);
        if stored != found {
            return Err(ReadError::Checksum { stored, found });
        }
        if bytes[HEAD..][length as usize..(length as usize).next_multiple_of(WORD)]
            .iter()
            .any(|byte| *byte != 0)
        {
            return contradiction("the bytes behind its names are not zero");
        }
        let Ok(text) = core::str::from_utf8(&bytes[HEAD..HEAD + length as usize]) else {
            return contradiction("its names are no text");
        };
        let table = Self {
            bytes,
            layout: Layout {
                order: order as usize,
                columns: columns as usize,
                rows: rows as usize,
                is_closed: flags == 1,
                text: text.len(),
            },
            text,
        };
        table.check().map(|()| table)
    }

    /// Whether the text names everything, and the numbers are in order.
    fn check(&self) -> Result<(), ReadError> {
        let mut lines = self.text.split('\n');
        let is_named = lines.next().is_some_and(|name| !name.is_empty())
            && lines.clone().count() == self.layout.columns + 1
            && lines.all(|line| named(line).is_some());
        if !is_named {
            return contradiction("its names are not those of its columns");
        }
        let numbers = (self.bytes.len() - WORD - self.numbers()) / WORD;
        if (0..numbers).any(|index| !self.number(index).is_finite()) {
            return contradiction("a number is not finite");
        }
        if (0..self.layout.columns * self.count()).any(|index| self.number(self.layout.columns + index) < 0.0) {
            return contradiction("an error is negative");
        }
        let rises = |row: usize| self.parameter_of(row) < self.parameter_of(row + 1);
        let last = self.layout.rows - 2;
        // two rows may share a parameter, where the motion of the inputs has an edge
        let is_in_order = (0..=last).all(|row| self.parameter_of(row) <= self.parameter_of(row + 1))
            && (1..=last).all(|row| rises(row - 1) || rises(row));
        if !is_in_order || !rises(0) || !rises(last) {
            return contradiction("its rows are not in order");
        }
        if !(self.parameter_of(self.layout.rows - 1) - self.parameter_of(0)).is_finite() {
            return contradiction("its range is not finite");
        }
        Ok(())
    }

    /// The index of the first number among the bytes.
    fn numbers(&self) -> usize {
        HEAD + self.text.len().next_multiple_of(WORD)
    }

    fn number(&self, index: usize) -> f64 {
        let start = self.numbers() + WORD * index;
        let mut word = [0; WORD];
        if let Some(found) = self.bytes.get(start..start + WORD) {
            word.copy_from_slice(found);
        }
        f64::from_le_bytes(word)
    }

    /// The number of numbers of a column in a row: the value and its derivatives.
    pub(super) fn count(&self) -> usize {
        self.layout.order + 1
    }

    /// A table that was checked before.
    #[cfg(feature = "alloc")]
    pub(super) fn checked(bytes: &'b [u8], layout: Layout) -> Self {
        let text = bytes.get(HEAD..HEAD + layout.text).unwrap_or_default();
        Self {
            bytes,
            layout,
            text: core::str::from_utf8(text).unwrap_or_default(),
        }
    }

    #[cfg(feature = "alloc")]
    pub(super) fn layout(&self) -> Layout {
        self.layout
    }

    fn row(&self, row: usize) -> usize {
        self.layout.columns * (1 + self.count()) + row * (1 + self.layout.columns * self.count())
    }

    /// The parameter of a row.
    fn parameter_of(&self, row: usize) -> f64 {
        self.number(self.row(row))
    }

    /// The numbers of a row: the parameter, and for each column the value and its derivatives.
    #[must_use]
    pub fn row_at(&self, row: usize) -> Option<impl ExactSizeIterator<Item = f64> + use<'b>> {
        // only the index of a row that exists is sure not to overflow
        (row < self.layout.rows).then(|| {
            let (table, first, width) = (*self, self.row(row), self.row(1) - self.row(0));
            (0..width).map(move |index| table.number(first + index))
        })
    }

    /// The bytes.
    #[must_use]
    pub fn as_bytes(&self) -> &'b [u8] {
        self.bytes
    }

    /// The name of the table, which is that of its mechanism unless another one was given.
    #[must_use]
    pub fn name(&self) -> &'b str {
        self.text.split('\n').next().unwrap_or("")
    }

    /// The order of the highest derivative. The pieces are polynomials of twice this degree and one more.
    #[must_use]
    pub fn order(&self) -> usize {
        self.layout.order
    }

    /// The number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.layout.rows
    }

    /// The name and the dimension of the parameter.
    #[must_use]
    pub fn parameter(&self) -> (&'b str, Dimension) {
        self.line(1)
    }

    fn line(&self, line: usize) -> (&'b str, Dimension) {
        let found = self.text.split('\n').nth(line).and_then(named);
        found.map_or(("", Dimension::Scalar), |(dimension, name)| (name, dimension))
    }

    /// The first and the last parameter.
    #[must_use]
    pub fn range(&self) -> RangeInclusive<f64> {
        self.parameter_of(0)..=self.parameter_of(self.layout.rows - 1)
    }

    /// The way after which the table repeats itself, if it does. It has numbers everywhere then, and angles are
    /// unwrapped.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        self.layout
            .is_closed
            .then(|| self.parameter_of(self.layout.rows - 1) - self.parameter_of(0))
    }

    /// The columns.
    #[must_use]
    pub fn columns(&self) -> impl ExactSizeIterator<Item = ExactColumn<'b>> + use<'b> {
        let table = *self;
        (0..self.layout.columns).map(move |index| ExactColumn { table, index })
    }

    /// The column with this name.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<ExactColumn<'b>> {
        self.columns().find(|column| column.name() == name)
    }

    /// Writes all columns at a parameter into `result`: the value and the derivatives by the parameter, column after
    /// column.
    ///
    /// # Errors
    /// [`LookupError`], for a parameter that is not in the table, or a result of another length.
    pub fn fill(&self, at: f64, result: &mut [f64]) -> Result<(), LookupError> {
        self.fill_at_speed(at, 1.0, result)
    }

    /// Writes all columns at a parameter into `result`: the value and the derivatives by time while the parameter
    /// changes at this speed, column after column.
    ///
    /// # Errors
    /// [`LookupError`], for a parameter that is not in the table, a speed that is not finite, or a result of another
    /// length.
    pub fn fill_at_speed(&self, at: f64, speed: f64, result: &mut [f64]) -> Result<(), LookupError> {
        let needed = self.layout.columns * self.count();
        if result.len() != needed {
            let given = result.len();
            return Err(LookupError::Room { needed, given });
        }
        let spot = self.spot(at)?;
        for (column, numbers) in result.chunks_mut(self.count()).enumerate() {
            self.read(&spot, column, numbers);
            faster(numbers, speed)?;
        }
        Ok(())
    }

    /// The piece in which a parameter lies.
    fn spot(&self, at: f64) -> Result<Spot, LookupError> {
        let [low, high] = [self.parameter_of(0), self.parameter_of(self.layout.rows - 1)];
        let beyond = LookupError::Beyond { at, range: [low, high] };
        if !at.is_finite() {
            return Err(beyond);
        }
        let (mut at, mut periods) = (at, 0.0);
        if self.layout.is_closed {
            periods = Float::floor((at - low) / (high - low));
            if Float::abs(periods) > MOST_PERIODS {
                let period = high - low;
                return Err(LookupError::TooManyPeriods { at, period });
            }
            at = (at - periods * (high - low)).max(low).min(high);
        }
        if !(low..=high).contains(&at) {
            return Err(beyond);
        }
        let (mut left, mut right) = (0, self.layout.rows - 1);
        while right - left > 1 {
            let middle = left.midpoint(right);
            if self.parameter_of(middle) <= at {
                left = middle;
            } else {
                right = middle;
            }
        }
        let start = self.parameter_of(left);
        let length = self.parameter_of(right) - start;
        let part = (at - start) / length;
        Ok(Spot {
            left,
            length,
            part,
            periods,
        })
    }

    fn read(&self, spot: &Spot, column: usize, result: &mut [f64]) {
        let mut ends = [[0.0; MOST_NUMBERS]; 2];
        let count = self.count();
        for (row, end) in ends.iter_mut().enumerate() {
            let first = self.row(spot.left + row) + 1 + column * count;
            for (order, number) in end[..count].iter_mut().enumerate() {
                *number = self.number(first + order);
            }
        }
        let mut derivatives = [0.0; MOST_NUMBERS];
        let [left, right] = &ends;
        piece(
            &left[..count],
            &right[..count],
            spot.length,
            spot.part,
            &mut derivatives[..count],
        );
        derivatives[0] += spot.periods * self.number(column);
        let asked = result.len().min(count);
        result[..asked].copy_from_slice(&derivatives[..asked]);
    }
}

/// A parameter in a piece.
struct Spot {
    left: usize,
    length: f64,
    part: f64,
    /// The number of periods before.
    periods: f64,
}

/// Derivatives by time from those by the parameter, at a speed of the parameter.
fn faster(derivatives: &mut [f64], speed: f64) -> Result<(), LookupError> {
    if !speed.is_finite() {
        return Err(LookupError::Speed { speed });
    }
    let mut factor = 1.0;
    for derivative in derivatives {
        *derivative *= factor;
        factor *= speed;
    }
    Ok(())
}

impl<'b> ExactColumn<'b> {
    /// The name.
    #[must_use]
    pub fn name(&self) -> &'b str {
        self.table.line(self.index + 2).0
    }

    /// The dimension.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        self.table.line(self.index + 2).1
    }

    /// The difference between one period and the next: whole revolutions of an angle, or zero.
    #[must_use]
    pub fn increment(&self) -> f64 {
        self.table.number(self.index)
    }

    /// The measured errors of the value and of each derivative by the parameter, in the column's units: twice the
    /// largest difference from the poses that was seen at a third, the middle and two thirds of all pieces, and four
    /// units in the last place of the largest magnitude.
    #[must_use]
    pub fn errors(&self) -> impl ExactSizeIterator<Item = f64> + use<'b> {
        let (table, first) = (self.table, self.table.layout.columns + self.index * self.table.count());
        (0..table.count()).map(move |order| table.number(first + order))
    }

    /// The value and its first derivatives by the parameter.
    ///
    /// # Errors
    /// [`LookupError`], for a parameter that is not in the table, or more derivatives than it has.
    pub fn at<const N: usize>(&self, at: f64) -> Result<[f64; N], LookupError> {
        self.at_speed(at, 1.0)
    }

    /// The value and its first derivatives by time, while the parameter changes at this speed.
    ///
    /// # Errors
    /// [`LookupError`], for a parameter that is not in the table, a speed that is not finite, or more derivatives than
    /// the table has.
    pub fn at_speed<const N: usize>(&self, at: f64, speed: f64) -> Result<[f64; N], LookupError> {
        let (asked, order) = (N.saturating_sub(1), self.table.layout.order);
        if asked > order {
            return Err(LookupError::Orders { asked, order });
        }
        let mut result = [0.0; N];
        self.table.read(&self.table.spot(at)?, self.index, &mut result);
        faster(&mut result, speed)?;
        Ok(result)
    }

    /// The motion of the column while the parameter moves, by the chain rule.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let table = linkage.sweep(Assembly::Open).over(0.0..=TAU, 13).exact_table(1e-7)?;
    /// // the crank brakes
    /// let crank = Motion::from([1.0, 10.0, -3.0, 0.5]);
    /// let rocker = table.column("theta4")?.under(crank)?;
    /// let pose = linkage.solve([1.0, 10.0, -3.0, 0.5, 0.0], Assembly::Open)?;
    /// assert!((rocker.jerk() - pose.theta4.jerk()).abs() < 1e-5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`LookupError`], for a parameter that is not in the table, or more derivatives than it has.
    pub fn under<const N: usize>(&self, parameter: Motion<f64, N>) -> Result<Motion<f64, N>, LookupError> {
        let rates = parameter.derivatives();
        if let Some(speed) = rates.iter().skip(1).copied().find(|rate| !rate.is_finite()) {
            return Err(LookupError::Speed { speed });
        }
        let at = rates.first().copied().unwrap_or(f64::NAN);
        Ok(Motion::new(self.at::<N>(at)?).driven_by(parameter))
    }
}
