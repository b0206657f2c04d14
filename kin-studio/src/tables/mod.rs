//! Tables of sweeps as CSV and JSON, for spreadsheets and other programs.
//!
//! ```
//! use std::f64::consts::TAU;
//! use kin_core::library::FourBar;
//! use kin_core::prelude::*;
//! use kin_studio::tables::Export;
//!
//! let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
//! let table = linkage.sweep(Assembly::Open).over(0.0..=3.0, 301).table()?.in_degrees().units("mm", "s");
//! let csv = table.to_csv();
//! assert!(csv.starts_with("theta2 [deg],theta2_velocity [deg/s],"));
//! // a row for the names, 301 for the poses, and one for the limit that lies between two of them
//! assert_eq!(csv.lines().count(), 1 + 301 + 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod csv;
mod exact;
mod json;
#[cfg(test)]
mod tests;

#[cfg(feature = "program")]
pub(crate) use csv::quoted;
pub use exact::{ExactJson, JsonError};

use std::io;
use std::path::Path;

use kin_core::batch::Outcome;
use kin_core::sweep::{ColumnOf, NoSuchColumn, Table};

/// Tables as text for other programs. Angles, lengths and times have the units of the table, which its `in_degrees` and
/// `units` choose.
pub trait Export {
    /// Comma-separated values (RFC 4180, with line feeds): the names of the columns with their units, then a line for
    /// each row.
    ///
    /// Two columns follow those of the table. `outcome` is `closes`, `does not close`, `singular` or `failed`. `margin`
    /// is the missing length of a row that does not close, as a negative number. Numbers that are not there are left
    /// empty.
    ///
    /// A limit that lies between two rows has a line between theirs. The line holds the inputs and the unknowns there,
    /// and the kind of the limit as the outcome: `limit position`, `change point`, `pole` or `end of a domain or
    /// range`. Its rates and outputs are empty.
    fn to_csv(&self) -> String;

    /// One object: `variable`, the name of the column over which the sweep runs; `columns`, each with `name`, `unit`,
    /// `order` and `values`; `outcome` and `margin` with an entry for each row; and `limits`, each with `at`, `kind`,
    /// `block`, the `row` before it, `closes` (`before` or `behind`) and the `values` by the names of their columns.
    /// Numbers that are not there are `null`.
    fn to_json(&self) -> String;

    /// Writes [`to_csv`](Self::to_csv) to a file.
    ///
    /// # Errors
    /// The error of the file system, with the path.
    fn write_csv(&self, path: impl AsRef<Path>) -> io::Result<()> {
        write(path.as_ref(), &self.to_csv())
    }

    /// Writes [`to_json`](Self::to_json) to a file.
    ///
    /// # Errors
    /// The error of the file system, with the path.
    fn write_json(&self, path: impl AsRef<Path>) -> io::Result<()> {
        write(path.as_ref(), &self.to_json())
    }
}

impl Export for Table {
    fn to_csv(&self) -> String {
        csv::text(&Columns::all(self))
    }

    fn to_json(&self) -> String {
        json::text(&Columns::all(self))
    }
}

/// Some columns of a table, in a chosen order.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
/// use kin_studio::tables::{Columns, Export};
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
/// let table = linkage.sweep(Assembly::Open).over(0.0..=3.0, 31).table()?;
/// let csv = Columns::named(&table, ["theta4_jerk", "theta4"])?.to_csv();
/// assert!(csv.starts_with("theta2 [rad],theta4_jerk [rad/T³],theta4 [rad],outcome,margin\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Columns<'t> {
    table: &'t Table,
    indices: Vec<usize>,
}

impl<'t> Columns<'t> {
    fn all(table: &'t Table) -> Self {
        Self {
            table,
            indices: (0..table.columns().len()).collect(),
        }
    }

    /// The column of the variable, and those of these names.
    ///
    /// # Errors
    /// [`NoSuchColumn`] for the first name that no column has.
    pub fn named<'n>(table: &'t Table, names: impl IntoIterator<Item = &'n str>) -> Result<Self, NoSuchColumn> {
        let variable = table.variable().label;
        let is_variable = |column: &ColumnOf<'_>| column.label == variable;
        let mut indices: Vec<usize> = table
            .columns()
            .position(|column| is_variable(&column))
            .into_iter()
            .collect();
        for name in names {
            table.column(name)?;
            let index = table.columns().position(|column| column.label.is(name));
            indices.extend(index.filter(|index| !indices.contains(index)));
        }
        Ok(Self { table, indices })
    }

    /// The entries of these columns, from a list with an entry for each column of the table.
    fn of<T: Clone>(&self, all: impl Iterator<Item = T>) -> Vec<T> {
        let all: Vec<T> = all.collect();
        self.indices.iter().map(|index| all[*index].clone()).collect()
    }
}

impl Export for Columns<'_> {
    fn to_csv(&self) -> String {
        csv::text(self)
    }

    fn to_json(&self) -> String {
        json::text(self)
    }
}

fn write(path: &Path, text: &str) -> io::Result<()> {
    std::fs::write(path, text)
        .map_err(|error| io::Error::new(error.kind(), format!("{} cannot be written: {error}", path.display())))
}

/// The outcome of a row in a few words.
fn outcome(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Solved => "closes",
        Outcome::OutOfReach { .. } => "does not close",
        Outcome::Singular => "singular",
        Outcome::Failed | Outcome::Unsolved => "failed",
    }
}
