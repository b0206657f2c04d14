//! A page for each result, and for each row of a query.

use std::error::Error;
use std::fmt::{self, Write as _};
use std::fs;
use std::path::{Path, PathBuf};

use kin_core::Mechanism;
use kin_studio::report::{Draft, ReportError, file_name};

use super::job::JobError;
use super::table;
use super::{Refined, Refinement};
use crate::objective::Objective;

/// The reason why pages were not written.
#[derive(Debug)]
#[non_exhaustive]
pub enum PageError {
    /// The folder could not be made.
    Folder {
        /// The folder.
        path: PathBuf,
        /// The error of the system.
        error: std::io::Error,
    },
    /// The report of a result could not be made or written.
    Report {
        /// The number of the result's candidate.
        id: u64,
        /// The error of the report.
        error: Box<ReportError>,
    },
    /// The table of rows cannot be read.
    Table(JobError),
}

impl fmt::Display for PageError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Folder { path, error } => write!(formatter, "the folder {} cannot be made: {error}", path.display()),
            Self::Report { id, error } => write!(formatter, "no page of the candidate {id}: {error}"),
            Self::Table(error) => error.fmt(formatter),
        }
    }
}

impl Error for PageError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Folder { error, .. } => Some(error),
            Self::Report { error, .. } => Some(error.as_ref()),
            Self::Table(error) => Some(error),
        }
    }
}

impl<M: Mechanism<Scalar = f64>> Refined<M> {
    /// What the page says about the result.
    #[must_use]
    pub fn summary(&self, objective: &Objective<M>) -> String {
        let error = |misfit: Option<crate::objective::Misfit>| {
            misfit.map_or_else(
                || "open".to_owned(),
                |misfit| format!("{:.6e}", misfit.root_mean_square),
            )
        };
        let mut text = format!(
            "Candidate {}, refined to {} targets. Error (root of the mean square): {} at the start, {} after the \
             evolution strategy, {} after the least squares; {:.6e} at most, at target {}.",
            self.id,
            objective.target_count(),
            error(self.start),
            error(self.evolved),
            error(Some(self.polished)),
            self.polished.largest,
            self.polished.target,
        );
        let [x, y, turn] = self.design.placement();
        if [x, y, turn] != [0.0; 3] {
            let _ = write!(
                text,
                " Its frame stands at ({x:.6}, {y:.6}) in the plane of the targets, turned by {:.4} degrees.",
                turn.to_degrees()
            );
        }
        text += if self.figures.is_full_turn {
            " The input turns fully."
        } else {
            " The input swings."
        };
        if let Some(least) = self.figures.transmission {
            let _ = write!(
                text,
                " The transmission angle is {:.2} degrees or more.",
                least.value.to_degrees()
            );
        }
        text
    }

    /// The report of kin-studio about the result, in its assembly, over its travel or the full turn. The caller may add
    /// units, a title and a declaration.
    pub fn report(&self, objective: &Objective<M>) -> Draft<'static, M> {
        let description = M::DESCRIPTION;
        let mechanism = self.design.mechanism();
        let draft = kin_studio::report(&mechanism)
            .assembly(self.design.assembly())
            .at(objective.inputs::<M>(self.inputs[0]))
            .moving(description.inputs[objective.moving].name)
            .plots(objective.quantities())
            .title(format!("{}, candidate {}", description.name, self.id))
            .documentation(self.summary(objective));
        let [from, to] = self.figures.travel;
        if self.figures.is_full_turn || from == to {
            draft
        } else {
            draft.range(from.min(to)..=from.max(to))
        }
    }
}

impl<M: Mechanism<Scalar = f64>> Refinement<M> {
    /// Writes a page for each result into a folder, which is made if need be, and returns their paths. The files are
    /// called after the mechanism, the place of the result and the number of its candidate.
    ///
    /// # Errors
    /// [`PageError`].
    pub fn write_pages(&self, objective: &Objective<M>, folder: impl AsRef<Path>) -> Result<Vec<PathBuf>, PageError> {
        let reports = self.results.iter().map(|result| (result.id, result.report(objective)));
        write(reports, folder.as_ref())
    }
}

/// Writes a page for each row of a table into a folder, which is made if need be, and returns their paths.
///
/// The table is one that a query writes, as for [`Job::candidates`](super::Job::candidates). What its other columns say
/// stands on the page. The input moves as far as the mechanism closes.
///
/// # Errors
/// [`PageError`].
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_search::refine::write_pages_of;
///
/// let folder = std::env::temp_dir().join(format!("kin-pages-{}", std::process::id()));
/// let pages = write_pages_of::<FourBar>("id,r1,r2,r3,r4,assembly,swing\n7,90,30,80,60,open,61.2\n", &folder)?;
/// assert!(pages[0].ends_with("four-bar-1-7.html"));
/// assert!(std::fs::read_to_string(&pages[0])?.contains("swing: 61.2"));
/// # std::fs::remove_dir_all(folder)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_pages_of<M: Mechanism<Scalar = f64>>(
    table: &str,
    folder: impl AsRef<Path>,
) -> Result<Vec<PathBuf>, PageError> {
    let rows = table::read::<M>(table, usize::MAX).map_err(PageError::Table)?;
    let reports = rows.into_iter().map(|(candidate, said)| {
        let draft = kin_studio::report(&candidate.mechanism)
            .assembly(candidate.assembly)
            .title(format!("{}, candidate {}", M::DESCRIPTION.name, candidate.id))
            .documentation(said);
        (candidate.id, draft)
    });
    write(reports, folder.as_ref())
}

/// Writes reports, each with the number of its candidate. The files are called after the mechanism, the place of the
/// report and this number.
fn write<M: Mechanism<Scalar = f64>>(
    reports: impl Iterator<Item = (u64, Draft<'static, M>)>,
    folder: &Path,
) -> Result<Vec<PathBuf>, PageError> {
    fs::create_dir_all(folder).map_err(|error| PageError::Folder {
        path: folder.to_owned(),
        error,
    })?;
    let name = file_name(M::DESCRIPTION.name);
    let pages = reports.enumerate().map(|(place, (id, draft))| {
        let path = folder.join(format!("{name}-{}-{id}.html", place + 1));
        let written = draft.write(&path);
        written.map_err(|error| PageError::Report {
            id,
            error: error.into(),
        })?;
        Ok(path)
    });
    pages.collect()
}
