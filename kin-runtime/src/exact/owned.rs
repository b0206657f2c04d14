//! Tables that own their bytes.

use alloc::string::{String, ToString as _};
use alloc::vec::Vec;
use core::ops::RangeInclusive;

use super::error::{LookupError, ReadError};
use super::read::{ExactColumn, ExactTableRef, HEAD, Layout, MAGIC, VERSION, WORD, checksum};
use crate::quantity::Dimension;
use crate::sweep::NoSuchColumn;

/// A motion as a table that is exact between its rows: see the [module](super).
///
/// Its bytes are its binary form, which is the same on all machines. [`ExactTableRef`] reads them without allocating.
#[derive(Clone, Debug, PartialEq)]
pub struct ExactTable {
    bytes: Vec<u8>,
    layout: Layout,
}

/// The parts of an exact table, to be written in another form and to be put together again.
#[derive(Clone, Debug, PartialEq)]
pub struct ExactParts {
    /// The name of the table.
    pub name: String,
    /// The name and the dimension of the parameter.
    pub parameter: (String, Dimension),
    /// The order of the highest derivative, from 1 to 4.
    pub order: usize,
    /// Whether the table repeats itself.
    pub is_closed: bool,
    /// What is known of each column.
    pub columns: Vec<ExactColumnParts>,
    /// The rows: the parameter, and for each column the value and its derivatives by the parameter.
    pub rows: Vec<Vec<f64>>,
}

/// The parts of an exact table that belong to a column.
#[derive(Clone, Debug, PartialEq)]
pub struct ExactColumnParts {
    /// The name.
    pub name: String,
    /// The dimension.
    pub dimension: Dimension,
    /// The difference between one period and the next.
    pub increment: f64,
    /// The measured errors of the value and of each derivative.
    pub errors: Vec<f64>,
}

fn letter(dimension: Dimension) -> char {
    match dimension {
        Dimension::Angle => 'A',
        Dimension::Length => 'L',
        Dimension::Scalar => 'S',
    }
}

impl ExactParts {
    /// The table of these parts.
    ///
    /// # Errors
    /// [`ReadError::Contradiction`] if they do not fit together.
    pub fn table(&self) -> Result<ExactTable, ReadError> {
        let contradiction = |what| Err(ReadError::Contradiction { what });
        let count = self.order + 1;
        let width = 1 + self.columns.len() * count;
        if self.rows.iter().any(|row| row.len() != width)
            || self.columns.iter().any(|column| column.errors.len() != count)
        {
            return contradiction("a row or a column has another length than the others");
        }
        let names = self.columns.iter().map(|column| &column.name);
        if names
            .chain([&self.name, &self.parameter.0])
            .any(|name| name.contains('\n'))
        {
            return contradiction("a name has a line break");
        }
        let mut text = self.name.clone();
        let columns = self.columns.iter().map(|column| (&column.name, column.dimension));
        for (name, dimension) in [(&self.parameter.0, self.parameter.1)].into_iter().chain(columns) {
            text.push('\n');
            text.push(letter(dimension));
            text.push(' ');
            text.push_str(name);
        }
        let mut bytes = MAGIC.to_vec();
        let sizes = [
            self.order,
            self.columns.len(),
            self.rows.len(),
            usize::from(self.is_closed),
            text.len(),
        ];
        bytes.extend(VERSION.to_le_bytes());
        for size in sizes {
            let Ok(size) = u32::try_from(size) else {
                return contradiction("it has more than 2³² rows or columns");
            };
            bytes.extend(size.to_le_bytes());
        }
        bytes.extend(text.as_bytes());
        bytes.resize(HEAD + text.len().next_multiple_of(WORD), 0);
        let increments = self.columns.iter().map(|column| column.increment);
        let errors = self.columns.iter().flat_map(|column| column.errors.iter().copied());
        let rows = self.rows.iter().flatten().copied();
        for number in increments.chain(errors).chain(rows) {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend(checksum(&bytes).to_le_bytes());
        ExactTable::from_bytes(bytes)
    }
}

impl ExactTable {
    /// The table in these bytes.
    ///
    /// # Errors
    /// [`ReadError`], for bytes that are no table, are damaged or were written by a newer version.
    pub fn from_bytes(bytes: impl Into<Vec<u8>>) -> Result<Self, ReadError> {
        let bytes = bytes.into();
        let layout = ExactTableRef::new(&bytes)?.layout();
        Ok(Self { bytes, layout })
    }

    /// The binary form: a little-endian file of the same bytes on all machines.
    ///
    /// | bytes | what |
    /// |---|---|
    /// | 8 | `kinExact` |
    /// | 4 each | version 1, order n, columns c, rows r, 1 if the table repeats itself and 0 if not, length of the names |
    /// | length of the names, with zeros to a multiple of 8 | the names in UTF-8, a line each: of the table, of the parameter, of the columns. Before the last two stand `A ` for angles, `L ` for lengths or `S ` for numbers |
    /// | 8 c | the change of each column over a period |
    /// | 8 c (n + 1) | the measured errors of each column: of the value and of each derivative |
    /// | 8 r (1 + c (n + 1)) | the rows: the parameter, then for each column the value and its derivatives |
    /// | 8 | the sum of all bytes before, FNV-1a of 64 bits |
    #[must_use]
    pub fn as_bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The table, to be read in place.
    #[must_use]
    pub fn reader(&self) -> ExactTableRef<'_> {
        ExactTableRef::checked(&self.bytes, self.layout)
    }

    /// The parts, to be written in another form.
    #[must_use]
    pub fn parts(&self) -> ExactParts {
        let reader = self.reader();
        let (parameter, dimension) = reader.parameter();
        ExactParts {
            name: reader.name().to_string(),
            parameter: (parameter.to_string(), dimension),
            order: reader.order(),
            is_closed: reader.period().is_some(),
            columns: reader
                .columns()
                .map(|column| ExactColumnParts {
                    name: column.name().to_string(),
                    dimension: column.dimension(),
                    increment: column.increment(),
                    errors: column.errors().collect(),
                })
                .collect(),
            rows: (0..reader.rows())
                .filter_map(|row| reader.row_at(row))
                .map(Iterator::collect)
                .collect(),
        }
    }

    /// The same table with another name, which programs in other languages and messages use.
    ///
    /// # Errors
    /// [`ReadError::Contradiction`] if the name is empty or has a line break.
    pub fn named(&self, name: &str) -> Result<Self, ReadError> {
        let mut parts = self.parts();
        parts.name = name.to_string();
        parts.table()
    }

    /// The name of the table, which is that of its mechanism unless another one was given.
    #[must_use]
    pub fn name(&self) -> &str {
        self.reader().name()
    }

    /// The order of the highest derivative.
    #[must_use]
    pub fn order(&self) -> usize {
        self.reader().order()
    }

    /// The number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.reader().rows()
    }

    /// The name and the dimension of the parameter.
    #[must_use]
    pub fn parameter(&self) -> (&str, Dimension) {
        self.reader().parameter()
    }

    /// The first and the last parameter.
    #[must_use]
    pub fn range(&self) -> RangeInclusive<f64> {
        self.reader().range()
    }

    /// The way after which the table repeats itself, if it does. It has numbers everywhere then, and angles are
    /// unwrapped.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        self.reader().period()
    }

    /// The columns.
    #[must_use]
    pub fn columns(&self) -> impl ExactSizeIterator<Item = ExactColumn<'_>> {
        self.reader().columns()
    }

    /// The column with this name.
    ///
    /// # Errors
    /// [`NoSuchColumn`], with names that may have been meant.
    pub fn column(&self, name: &str) -> Result<ExactColumn<'_>, NoSuchColumn> {
        let reader = self.reader();
        let found = reader.column(name);
        found.ok_or_else(|| NoSuchColumn::new(name, reader.columns().map(|column| column.name())))
    }

    /// Writes all columns at a parameter into `result`: the value and the derivatives by the parameter, column after
    /// column.
    ///
    /// # Errors
    /// [`LookupError`], for a parameter that is not in the table, or a result of another length.
    pub fn fill(&self, at: f64, result: &mut [f64]) -> Result<(), LookupError> {
        self.reader().fill(at, result)
    }

    /// Writes all columns at a parameter into `result`: the value and the derivatives by time while the parameter
    /// changes at this speed, column after column.
    ///
    /// # Errors
    /// [`LookupError`], for a parameter that is not in the table, a speed that is not finite, or a result of another
    /// length.
    pub fn fill_at_speed(&self, at: f64, speed: f64, result: &mut [f64]) -> Result<(), LookupError> {
        self.reader().fill_at_speed(at, speed, result)
    }
}
