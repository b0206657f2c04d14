//! Tables as text for terminals.

use core::fmt;

use super::Table;
use crate::quantity::Digits;

/// The largest number of rows and columns that are shown.
const ROWS: usize = 20;
const COLUMNS: usize = 8;
const WIDTH: usize = 13;

/// The first columns and the first and last rows, aligned. `{:#}` shows all.
impl fmt::Display for Table {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let columns = if formatter.alternate() { usize::MAX } else { COLUMNS };
        let rows = if formatter.alternate() { usize::MAX } else { ROWS };
        let shown = || self.columns().take(columns);
        let width = |name: usize| WIDTH.max(name);
        for column in shown() {
            let name = alloc::format!("{}", column.label);
            write!(formatter, "{name:>width$}  ", width = width(name.len()))?;
        }
        writeln!(formatter)?;
        for column in shown() {
            let (name, unit) = (alloc::format!("{}", column.label), alloc::format!("{}", column.unit));
            write!(formatter, "{unit:>width$}  ", width = width(name.len()))?;
        }
        writeln!(formatter)?;
        for row in 0..self.count() {
            if self.count() > rows && row == rows / 2 {
                writeln!(formatter, "{:>WIDTH$}", "…")?;
            }
            if self.count() > rows && row >= rows / 2 && row < self.count() - rows / 2 {
                continue;
            }
            for column in shown() {
                let name = alloc::format!("{}", column.label);
                let value = column.values[row];
                let text = if value.is_nan() {
                    alloc::string::String::from("-")
                } else {
                    alloc::format!("{}", Digits(value))
                };
                write!(formatter, "{text:>width$}  ", width = width(name.len()))?;
            }
            if let Some(margin) = self.margin(row) {
                write!(formatter, "does not close: {}", Digits(margin))?;
            }
            writeln!(formatter)?;
        }
        let hidden = self.columns().len().saturating_sub(columns);
        if hidden > 0 {
            writeln!(formatter, "{} rows, and {hidden} more columns", self.count())?;
        }
        for limit in self.limits() {
            writeln!(formatter, "{limit}")?;
        }
        Ok(())
    }
}
