//! Names that no column has, and those that were meant.

use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;
use core::error::Error;
use core::fmt;

/// A name that no column of the table has.
#[derive(Clone, PartialEq, Eq)]
pub struct NoSuchColumn {
    /// The name.
    pub name: String,
    /// Names that are close to it, the closest first, at most three.
    pub near: Vec<String>,
    /// The number of columns.
    pub columns: usize,
}

impl NoSuchColumn {
    pub(crate) fn new(name: &str, columns: impl Iterator<Item = impl ToString>) -> Self {
        Self::among(name, columns.map(|column| column.to_string()).collect())
    }

    fn among(name: &str, columns: Vec<String>) -> Self {
        // without a unit that no column has
        let bare = name.split_once(" [").map_or(name, |(bare, _)| bare);
        let columns = columns.into_iter();
        let mut all: Vec<(usize, String)> = columns.map(|column| (distance(bare, &column), column)).collect();
        let count = all.len();
        // as many changes as a third of the name, or a name that the other begins with
        let is_near = |entry: &(usize, String)| 3 * entry.0 <= bare.len() + 2 || entry.1.starts_with(bare);
        all.sort_by_key(|(distance, name)| (!name.starts_with(bare), *distance));
        let near = all.into_iter().filter(is_near).map(|(_, column)| column).take(3);
        Self {
            name: name.to_string(),
            near: near.collect(),
            columns: count,
        }
    }
}

/// The number of letters to be inserted, left out or replaced. (V. I. Levenshtein, Binary codes capable of correcting
/// deletions, insertions, and reversals, Soviet Physics Doklady 10, 1966, 707-710.)
fn distance(one: &str, other: &str) -> usize {
    let mut row: Vec<usize> = (0..=other.chars().count()).collect();
    for (index_in_one, letter) in one.chars().enumerate() {
        let mut next = vec![index_in_one + 1];
        for (index, candidate) in other.chars().enumerate() {
            let replaced = row[index] + usize::from(letter != candidate);
            next.push(replaced.min(row[index + 1] + 1).min(next[index] + 1));
        }
        row = next;
    }
    row.last().copied().unwrap_or(0)
}

impl fmt::Display for NoSuchColumn {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "none of the {} columns is called `{}`",
            self.columns, self.name
        )?;
        for (index, near) in self.near.iter().enumerate() {
            let before = match index {
                0 => ": did you mean ",
                _ if index + 1 == self.near.len() => " or ",
                _ => ", ",
            };
            write!(formatter, "{before}`{near}`")?;
        }
        if self.near.is_empty() {
            formatter
                .write_str(": a column is called by its quantity and its order, as in `theta4` or `theta4_velocity`")?;
        }
        Ok(())
    }
}

crate::__debug_by_display!(NoSuchColumn);

impl Error for NoSuchColumn {}

#[cfg(test)]
mod tests {
    use super::{NoSuchColumn, distance};
    use std::string::ToString;

    #[test]
    fn distances() {
        for (one, other, expected) in [
            ("", "abc", 3),
            ("abc", "abc", 0),
            ("kitten", "sitting", 3),
            ("ab", "ba", 2),
        ] {
            assert_eq!(distance(one, other), expected);
            assert_eq!(distance(other, one), expected);
        }
    }

    #[test]
    fn near_names_are_listed() {
        let columns = ["theta3", "theta4", "theta4_velocity", "theta4_jerk"];
        let error = NoSuchColumn::new("theta4_velocty", columns.iter());
        assert_eq!(error.near, ["theta4_velocity"]);
        assert_eq!(
            error.to_string(),
            "none of the 4 columns is called `theta4_velocty`: did you mean `theta4_velocity`?".trim_end_matches('?')
        );
        let with_a_unit = NoSuchColumn::new("theta4 [deg]", columns.iter());
        assert_eq!(with_a_unit.near[0], "theta4");
        // a beginning comes before what a few changes lead to
        let columns = ["theta4_jerk", "theta3_snap", "theta4_acceleration", "theta4_snap"];
        let cut = NoSuchColumn::new("theta4_acc", columns.iter());
        assert_eq!(cut.near[0], "theta4_acceleration");
        let far = NoSuchColumn::new("x", columns.iter()).to_string();
        assert!(far.contains("as in `theta4`"), "{far}");
    }
}
