//! A page for each row of a query.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use datafusion::arrow::array::{AsArray, RecordBatch};
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::DataType;
use kin_search::pages::write_pages_of;

use super::declared::DeclaredArguments;
use super::fault::Fault;
use super::mechanisms::mechanism;
use super::print::separated;
use kin_search::say;

/// The options of `query` for pages.
#[derive(Debug, clap::Args)]
pub(crate) struct PagesArguments {
    /// Write a page for each row of the last statement into this folder. Its column `mechanism` names the mechanism,
    /// and each dimension has a column
    #[arg(long, value_name = "FOLDER")]
    pages: Option<PathBuf>,
    /// Open the first page in a browser
    #[arg(long, requires = "pages")]
    open: bool,
}

impl PagesArguments {
    /// Whether pages are wanted.
    pub(crate) fn are_wanted(&self) -> bool {
        self.pages.is_some()
    }

    /// Writes the pages that are wanted, and prints their paths.
    pub(crate) fn write(&self, rows: &[RecordBatch], declared: &DeclaredArguments) -> Result<(), Fault> {
        let Some(folder) = &self.pages else {
            return Ok(());
        };
        let functions = mechanism(&name(rows)?, declared)?;
        let pages = write_pages_of(functions, &separated(rows)?, folder).map_err(wrong)?;
        for page in &pages {
            say(format_args!("{}", page.display()));
        }
        match pages.first() {
            Some(page) if self.open => open(page),
            _ => Ok(()),
        }
    }
}

/// The name in the column `mechanism`, which is the same in all rows.
fn name(rows: &[RecordBatch]) -> Result<String, Fault> {
    let mut mechanism: Option<String> = None;
    for rows in rows.iter().filter(|rows| rows.num_rows() > 0) {
        let column = rows.column_by_name("mechanism").ok_or_else(|| {
            wrong("pages need a column `mechanism` with the name of the mechanism: select 'four_bar' as mechanism, …")
        })?;
        let names = cast(column, &DataType::Utf8).map_err(wrong)?;
        for name in names.as_string::<i32>() {
            let name = name.unwrap_or_default();
            let first = mechanism.get_or_insert_with(|| name.to_owned());
            if first != name {
                return Err(wrong(format!(
                    "pages are written for one mechanism, and the rows have `{first}` and `{name}`"
                )));
            }
        }
    }
    mechanism.ok_or_else(|| wrong("there is no row, and so no page"))
}

/// Opens a page with the program that the system has for it.
fn open(page: &Path) -> Result<(), Fault> {
    let program = if cfg!(target_os = "macos") {
        "open"
    } else if cfg!(windows) {
        "explorer"
    } else {
        "xdg-open"
    };
    let started = Command::new(program)
        .arg(page)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    started.map(drop).map_err(|error| {
        wrong(format!(
            "`{program}` cannot be started: {error}; open {} yourself",
            page.display()
        ))
    })
}

fn wrong(error: impl std::fmt::Display) -> Fault {
    Fault::Wrong(error.to_string())
}
