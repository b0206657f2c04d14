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

pub use exact::{ExactJson, JsonError};

use std::io;
use std::path::Path;

use kin_core::batch::Outcome;
use kin_core::sweep::Table;

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
    /// A limit that lies between two rows has a line of its own between theirs. It holds the inputs and the unknowns
    /// there, and its kind as the outcome: `limit position`, `change point`, `pole` or `end of a domain or range`. Its
    /// rates and outputs are empty.
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
