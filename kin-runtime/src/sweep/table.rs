//! Tables with named columns.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::columns::{ColumnOf, Heading, Unit};
use super::limits::Limit;
use super::names::NoSuchColumn;
use crate::batch::Outcome;
use crate::mechanism::Description;
use crate::quantity::Dimension;

/// The poses of a sweep as named columns of numbers.
///
/// The columns are the inputs, the unknowns and the outputs, each in all orders: `theta4`, `theta4_velocity`,
/// `theta4_acceleration`, `theta4_jerk`, `theta4_snap`. A sweep over time has the column `time` before them. A point
/// `p` has the columns `p.x`, `p.y` and so on. Angles are in radians unless [`in_degrees`](Self::in_degrees) converts
/// them.
///
/// Where the mechanism does not close, the columns of unknowns and outputs are NaN, [`outcome`](Self::outcome) says
/// why, and [`margin`](Self::margin) by how much. [`limits`](Self::limits) are the exact points between rows where it
/// ceases to close.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let table = linkage.sweep(Assembly::Open).over(-3.0..=3.0, 601).table()?;
/// // the crank is a rocker: it comes as far as 112 degrees
/// let limits: Vec<f64> = table.limits().iter().map(|limit| limit.at.to_degrees()).collect();
/// assert!((limits[1] - 112.0243).abs() < 5e-5 && limits[0] == -limits[1]);
/// assert!(table.margin(0).unwrap() < 0.0);
///
/// // a file for a spreadsheet
/// let mut csv = table.columns().map(|column| column.label.to_string()).collect::<Vec<_>>().join(",");
/// for row in table.in_degrees().rows() {
///     csv += "\n";
///     csv += &row.values().map(|value| value.to_string()).collect::<Vec<_>>().join(",");
/// }
/// assert_eq!(csv.lines().count(), 602);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    pub(super) labels: Vec<Heading>,
    pub(super) count: usize,
    /// Column after column.
    pub(super) data: Vec<f64>,
    pub(super) outcomes: Vec<Outcome>,
    pub(super) limits: Vec<Limit>,
    /// The column of the variable of the sweep.
    pub(super) variable: usize,
    pub(super) in_degrees: bool,
    pub(super) length: String,
    pub(super) time: String,
}

impl Table {
    pub(super) fn new(labels: Vec<Heading>, count: usize, variable: usize) -> Self {
        Self {
            data: alloc::vec![0.0; labels.len() * count],
            labels,
            count,
            outcomes: alloc::vec![Outcome::Unsolved; count],
            limits: Vec::new(),
            variable,
            in_degrees: false,
            length: "L".to_string(),
            time: "T".to_string(),
        }
    }

    /// The number of rows.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// The values of a column, one for each row. The column is called by its name, or by its heading in a file:
    /// `theta4 [rad]`.
    ///
    /// # Errors
    /// [`NoSuchColumn`], with names that may have been meant.
    pub fn column(&self, name: &str) -> Result<&[f64], NoSuchColumn> {
        self.find(name).map(|index| self.values(index))
    }

    /// All columns, in their order.
    #[must_use]
    pub fn columns(&self) -> impl ExactSizeIterator<Item = ColumnOf<'_>> + DoubleEndedIterator {
        (0..self.labels.len()).map(|index| self.column_at(index))
    }

    /// The column of the variable of the sweep: the input that moves, the time, or the number of the row.
    #[must_use]
    pub fn variable(&self) -> ColumnOf<'_> {
        self.column_at(self.variable)
    }

    /// The rows, in their order.
    #[must_use]
    pub fn rows(&self) -> impl ExactSizeIterator<Item = RowOf<'_>> + DoubleEndedIterator {
        (0..self.count).map(|index| RowOf { table: self, index })
    }

    /// The outcome of a row.
    #[must_use]
    pub fn outcome(&self, row: usize) -> Option<Outcome> {
        self.outcomes.get(row).copied()
    }

    /// The missing length of a row that does not close, as a negative number. For coupled blocks, which have no margin,
    /// it is the distance of the inputs to the end of their circuit, in the unit of the inputs.
    #[must_use]
    pub fn margin(&self, row: usize) -> Option<f64> {
        self.outcomes.get(row).and_then(Outcome::margin)
    }

    /// The points between rows where the mechanism begins or ceases to close, in the order of the rows. A gap that lies
    /// between two rows which both close has two.
    #[must_use]
    pub fn limits(&self) -> &[Limit] {
        &self.limits
    }

    /// The numbers of a limit, in the order and the units of the columns: the inputs and the unknowns. Rates and
    /// outputs, which may have no value there, are NaN.
    pub fn values_at<'t>(&'t self, limit: &'t Limit) -> impl Iterator<Item = f64> + 't {
        let mut values = limit.inputs.iter().chain(&limit.unknowns);
        self.labels.iter().enumerate().map(move |(index, label)| {
            if label.is_variable {
                return limit.at;
            }
            let value = match label.order {
                0 => values.next().copied(),
                _ => None,
            };
            match value {
                // exactly as it stands there, in the unit of the table
                Some(_) if index == self.variable => limit.at,
                Some(value) => value,
                None => f64::NAN,
            }
        })
    }

    /// The table with degrees instead of radians, in every column of an angle or of its derivatives, and in its limits.
    #[must_use]
    pub fn in_degrees(mut self) -> Self {
        if self.in_degrees {
            return self;
        }
        self.in_degrees = true;
        let is_angle = |label: &Heading| label.dimension == Dimension::Angle;
        for (index, label) in self.labels.iter().enumerate() {
            if is_angle(label) {
                for value in &mut self.data[index * self.count..(index + 1) * self.count] {
                    *value = value.to_degrees();
                }
            }
        }
        let is_turning_variable = self.labels.get(self.variable).is_some_and(is_angle);
        // a limit holds the inputs and then the unknowns, as the columns do
        let values = self
            .labels
            .iter()
            .filter(|label| !label.is_variable && label.order == 0);
        let are_angles: Vec<bool> = values.map(is_angle).collect();
        for limit in &mut self.limits {
            if is_turning_variable {
                limit.at = limit.at.to_degrees();
            }
            for (value, is_angle) in limit.inputs.iter_mut().chain(&mut limit.unknowns).zip(&are_angles) {
                if *is_angle {
                    *value = value.to_degrees();
                }
            }
        }
        self
    }

    /// The table with names for the units of length and time, as in `units("mm", "s")`. The numbers stay the same.
    #[must_use]
    pub fn units(mut self, length: &str, time: &str) -> Self {
        self.length = length.to_string();
        self.time = time.to_string();
        self
    }

    /// The table with one more column of numbers, as [`column`](crate::extremes::QuantityAlong::column) gives them,
    /// behind all others. Rows without a number have NaN. Later changes of the units of the table do not concern it.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let sweep = linkage.sweep(Assembly::Open).over(0.0..=3.0, 31).speed(10.0);
    /// let power = sweep.of_expression(|at| at.theta4.velocity() * at.theta4.acceleration()).column()?;
    /// let table = sweep.table()?.with_column("power", "rad²/s³", power);
    /// assert_eq!(table.columns().last().unwrap().to_string(), "power [rad²/s³]");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_column(mut self, name: &str, unit: &str, mut values: Vec<f64>) -> Self {
        values.resize(self.count, f64::NAN);
        self.labels.push(Heading::other(name, unit));
        self.data.extend(values);
        self
    }

    /// The column of the first unknown: columns follow in the order of inputs and unknowns, each in all orders.
    pub(super) fn first_unknown(&self, description: &Description<'_>) -> usize {
        self.first_input() + description.inputs.len() * (description.order + 1)
    }

    /// The column of the first input, behind that of the variable if it is none.
    pub(super) fn first_input(&self) -> usize {
        self.labels.iter().take_while(|label| label.is_variable).count()
    }

    pub(super) fn find(&self, name: &str) -> Result<usize, NoSuchColumn> {
        let found = self.labels.iter().position(|label| label.label().is(name));
        let headed = || self.columns().position(|column| column.to_string() == name);
        found
            .or_else(headed)
            .ok_or_else(|| NoSuchColumn::new(name, self.labels.iter().map(Heading::label)))
    }

    pub(super) fn values(&self, column: usize) -> &[f64] {
        &self.data[column * self.count..(column + 1) * self.count]
    }

    fn column_at(&self, index: usize) -> ColumnOf<'_> {
        let label = self.labels[index].label();
        ColumnOf {
            label,
            unit: Unit {
                given: self.labels[index].unit.as_deref(),
                dimension: label.dimension,
                order: label.order,
                is_time: label.is_variable && label.name == "time",
                in_degrees: self.in_degrees,
                length: &self.length,
                time: &self.time,
            },
            values: self.values(index),
        }
    }
}

/// A row of a table.
#[derive(Clone, Copy, Debug)]
pub struct RowOf<'t> {
    table: &'t Table,
    index: usize,
}

impl<'t> RowOf<'t> {
    /// The number of the row, from zero.
    #[must_use]
    pub fn index(&self) -> usize {
        self.index
    }

    /// The numbers of the row, in the order of the columns.
    #[must_use]
    pub fn values(&self) -> impl ExactSizeIterator<Item = f64> + 't {
        let (table, index) = (self.table, self.index);
        (0..table.labels.len()).map(move |column| table.data[column * table.count + index])
    }

    /// The number in a column.
    ///
    /// # Errors
    /// [`NoSuchColumn`], with names that may have been meant.
    pub fn get(&self, name: &str) -> Result<f64, NoSuchColumn> {
        self.table.column(name).map(|values| values[self.index])
    }

    /// The outcome of the row.
    #[must_use]
    pub fn outcome(&self) -> Outcome {
        self.table.outcomes[self.index]
    }
}
