//! Tables of text, as wide as the terminal.

use console::Term;

pub(super) use crate::case::text::{Units, aligned, digits};

/// The width of the terminal. In a pipe it is that of the variable `COLUMNS`, or 100.
pub(crate) fn width() -> usize {
    let from_environment = std::env::var("COLUMNS").ok().and_then(|text| text.parse().ok());
    let of_terminal = Term::stdout().size_checked().map(|(_, columns)| usize::from(columns));
    of_terminal.or(from_environment).unwrap_or(100).max(40)
}

/// A column of a table.
pub(crate) struct Column {
    /// The lines of its head.
    pub(crate) head: Vec<String>,
    /// Its cells.
    pub(crate) cells: Vec<String>,
    /// Whether it holds numbers, which end below each other.
    pub(crate) is_number: bool,
}

impl Column {
    /// A column of words.
    pub(crate) fn words(head: &str, cells: Vec<String>) -> Self {
        Self {
            head: vec![head.to_owned()],
            cells,
            is_number: false,
        }
    }

    /// A column of numbers.
    pub(crate) fn numbers(head: &str, cells: Vec<String>) -> Self {
        Self {
            is_number: true,
            ..Self::words(head, cells)
        }
    }

    pub(crate) fn width(&self) -> usize {
        let all = self.head.iter().chain(&self.cells);
        all.map(|text| text.chars().count()).max().unwrap_or(0)
    }
}

/// The number of columns that fit into a width.
pub(crate) fn fitting(columns: &[Column], width: usize) -> usize {
    let mut used = 0;
    for (index, column) in columns.iter().enumerate() {
        used += column.width() + if index == 0 { 0 } else { 2 };
        if used > width {
            return index.max(1);
        }
    }
    columns.len()
}

/// The columns beside each other.
pub(crate) fn table(columns: &[Column]) -> String {
    let heads = columns.iter().map(|column| column.head.len()).max().unwrap_or(0);
    let rows = columns.iter().map(|column| column.cells.len()).max().unwrap_or(0);
    let mut text = String::new();
    for line in 0..heads + rows {
        let mut row = String::new();
        for column in columns {
            let cell = if line < heads {
                column.head.get(line)
            } else {
                column.cells.get(line - heads)
            };
            let (cell, width) = (cell.map_or("", String::as_str), column.width());
            let gap = if row.is_empty() { "" } else { "  " };
            // the width of a format is at most 65 535, and a name may be longer
            let blank = " ".repeat(width - cell.chars().count());
            let [before, behind] = if column.is_number {
                [blank.as_str(), ""]
            } else {
                ["", blank.as_str()]
            };
            row.extend([gap, before, cell, behind]);
        }
        text.push_str(row.trim_end());
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_columns_that_fit_are_counted() {
        let column = || Column::numbers("12345678", vec!["1".to_owned()]);
        assert_eq!(fitting(&[column(), column(), column()], 20), 2);
        assert_eq!(fitting(&[column()], 4), 1);
        let long = "x".repeat(70_000);
        let columns = [
            Column::words(&long, vec!["1".to_owned()]),
            Column::numbers("y", vec!["2".to_owned()]),
        ];
        assert_eq!(table(&columns).lines().last().map(str::len), Some(70_003));
    }
}
