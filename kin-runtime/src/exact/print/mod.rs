//! Exact tables in other languages, with what reads them.
//!
//! Every program does the operations of [`piece`](super::piece) in the same order, so it finds the same numbers to the
//! last bit, where the compiler does not fuse products and sums.

use std::format;
use std::string::{String, ToString as _};
use std::vec::Vec;

use super::owned::{ExactParts, ExactTable};
use super::read::MOST_PERIODS;
use crate::quantity::Dimension;
use crate::tape::C;
use crate::tape::words::{DistinctNames, identifier, quoted, snake};

impl ExactTable {
    /// The table as C99: a header, a source and an example. The code needs `floor` of `<math.h>` alone, and has no
    /// static state but the constant table.
    ///
    /// `cc -O2 -std=c99 -ffp-contract=off main.c four_bar_table.c -lm -o four_bar_table` builds the example. The code
    /// finds the numbers of [`fill_at_speed`](Self::fill_at_speed) to the last bit.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let table = linkage.sweep(Assembly::Open).over(0.0..=TAU, 13).exact_table(1e-6)?;
    /// let c = table.c();
    /// assert!(c.header.contains("int four_bar_table_at(double parameter, double speed,"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn c(&self) -> C {
        let parts = self.parts();
        let prefix = format!("{}_table", snake(&parts.name));
        let upper = prefix.to_uppercase();
        let mut names = DistinctNames::new(&[]);
        let columns: Vec<String> = parts
            .columns
            .iter()
            .enumerate()
            .map(|(index, column)| {
                let name = names.name(&identifier(&column.name).to_uppercase());
                format!(
                    "    /* {} */\n    {upper}_COLUMN_{name} = {index},\n",
                    description(&parts, index)
                )
            })
            .collect();
        let head = head(&parts).join("\n   ");
        let (columns, count, orders) = (columns.concat(), parts.columns.len(), parts.order + 1);
        let header = format!(
            "/* {head} */\n\n#ifndef {upper}_H\n#define {upper}_H\n\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n\
             /* The numbers of columns, and of the value and the derivatives of each. */\n\
             enum {{ {upper}_COLUMNS = {count}, {upper}_ORDERS = {orders} }};\n\n\
             enum {{\n{columns}}};\n\n\
             /* All columns at a parameter: the value and its derivatives by time, while the parameter changes at a \
             speed. At the speed 1 they are the\n   \
             derivatives by the parameter. Returns 0, or 1 if the parameter is not in the table, from {low:?} to \
             {high:?}{again}. */\n\
             int {prefix}_at(double parameter, double speed, double result[{upper}_COLUMNS][{upper}_ORDERS]);\n\n\
             #ifdef __cplusplus\n}}\n#endif\n\n#endif\n",
            low = self.range().start(),
            high = self.range().end(),
            again = if parts.is_closed {
                ", which repeats itself beyond, is too many periods away, or is not finite"
            } else {
                ", or not finite"
            },
        );
        let code = with_most_periods(include_str!("table.c"))
            .replace("PREFIX", &prefix)
            .replace("UPPER", &upper);
        let source = format!(
            "/* {head} */\n\n#include \"{prefix}.h\"\n\n#include <math.h>\n\n\
             enum {{ COLUMNS = {count}, ORDERS = {orders}, ROWS = {rows}, IS_CLOSED = {closed} }};\n\n\
             /* The change of each column over a period. */\nstatic const double changes[COLUMNS] = {{{changes}}};\n\n\
             /* For each row the parameter, and for each column the value and its derivatives by the parameter. */\n\
             static const double table[ROWS][1 + COLUMNS * ORDERS] = {{\n{table}}};\n\n{code}",
            rows = parts.rows.len(),
            closed = i32::from(parts.is_closed),
            changes = changes(&parts),
            table = rows(&parts, ["    {", "},\n"]),
        );
        let example = include_str!("example.c")
            .replace("PREFIX", &prefix)
            .replace("UPPER", &upper);
        C {
            name: prefix,
            header,
            source,
            example,
        }
    }

    /// The table as an ES module without dependencies: the function `at(parameter, speed)`, the constants `COLUMNS`,
    /// `ERRORS`, `ORDERS`, `RANGE` and `IS_CLOSED`.
    #[must_use]
    pub fn java_script(&self) -> String {
        let parts = self.parts();
        let code = with_most_periods(include_str!("table.js"));
        format!(
            "// {head}\n\n{constants}\n{code}",
            head = head(&parts).join("\n// "),
            constants = constants(
                &parts,
                self,
                ["export const ", ";\n"],
                ["const CHANGES", "const TABLE"],
                ["false", "true"]
            ),
        )
    }

    /// The table as a Python module without dependencies: the function `at(parameter, speed)`, the constants `COLUMNS`,
    /// `ERRORS`, `ORDERS`, `RANGE` and `IS_CLOSED`.
    #[must_use]
    pub fn python(&self) -> String {
        let parts = self.parts();
        let code = with_most_periods(include_str!("table.py"));
        format!(
            "# {head}\n\nimport math\n\n{constants}\n\n{code}",
            head = head(&parts).join("\n# "),
            constants = constants(&parts, self, ["", "\n"], ["_CHANGES", "_TABLE"], ["False", "True"]),
        )
    }
}

/// The code with the largest number of periods between the table and a parameter.
fn with_most_periods(code: &str) -> String {
    code.replace("MOST_PERIODS", &format!("{MOST_PERIODS:?}"))
}

/// The constants of a module in JavaScript or Python, which write lists alike.
fn constants(
    parts: &ExactParts,
    table: &ExactTable,
    [begin, end]: [&str; 2],
    [own_changes, own_rows]: [&str; 2],
    truths: [&str; 2],
) -> String {
    let columns: Vec<String> = parts.columns.iter().map(|column| quoted(&column.name)).collect();
    let errors = parts
        .columns
        .iter()
        .map(|column| format!("[{}]", numbers(&column.errors)));
    let errors: Vec<String> = errors.collect();
    let range = table.range();
    format!(
        "{begin}NAME = {name}{end}{begin}PARAMETER = {parameter}{end}{begin}COLUMNS = [{columns}]{end}\
         {begin}ERRORS = [{errors}]{end}{begin}ORDERS = {orders}{end}{begin}RANGE = [{low:?}, {high:?}]{end}\
         {begin}IS_CLOSED = {closed}{end}{own_changes} = [{changes}]{end}{own_rows} = [\n{rows}]{end}",
        name = quoted(&parts.name),
        parameter = quoted(&parts.parameter.0),
        columns = columns.join(", "),
        errors = errors.join(", "),
        orders = parts.order + 1,
        low = range.start(),
        high = range.end(),
        closed = truths[usize::from(parts.is_closed)],
        changes = changes(parts),
        rows = rows(parts, ["    [", "],\n"]),
    )
}

/// The lines at the head of a file. All names in them are made of letters, digits and underscores.
fn head(parts: &ExactParts) -> Vec<String> {
    let ExactParts {
        name,
        parameter,
        order,
        rows,
        ..
    } = parts;
    [
        format!(
            "The motion of {}, a table of {} rows over {} with derivatives through order {order}, written by kin {}.",
            identifier(name),
            rows.len(),
            identifier(&parameter.0),
            env!("CARGO_PKG_VERSION")
        ),
        format!(
            "Licence, at your option: {}. Do not edit: write it again.",
            env!("CARGO_PKG_LICENSE")
        ),
    ]
    .to_vec()
}

/// What a column is, and how exact.
fn description(parts: &ExactParts, index: usize) -> String {
    let column = &parts.columns[index];
    let unit = match column.dimension {
        Dimension::Angle => "an angle in radians",
        Dimension::Length => "a length",
        Dimension::Scalar => "a number",
    };
    let errors: Vec<String> = column.errors.iter().map(|error| format!("{error:.0e}")).collect();
    format!(
        "{}: {unit}; errors of the value and its derivatives: {}",
        identifier(&column.name),
        errors.join(", ")
    )
}

fn changes(parts: &ExactParts) -> String {
    let changes: Vec<f64> = parts.columns.iter().map(|column| column.increment).collect();
    numbers(&changes)
}

fn rows(parts: &ExactParts, [begin, end]: [&str; 2]) -> String {
    let rows = parts.rows.iter();
    rows.map(|row| [begin, &numbers(row), end].concat()).collect()
}

/// Numbers in the shortest decimals that are read back as the same numbers.
fn numbers(values: &[f64]) -> String {
    let words: Vec<String> = values.iter().map(|value| format!("{value:?}").to_string()).collect();
    words.join(", ")
}
