//! A page for each result, and for each row of a query.

use std::error::Error;
use std::fmt::{self, Write as _};
use std::fs;
use std::path::{Path, PathBuf};

use kin_fit::{Candidate, FitFunctions, JobError, Misfit, Objective, Refined, Refinement, read_candidates};
use kin_studio::report::{self, Draft, ReportError, ReportFunctions, Untyped, file_name};

/// The functions of a mechanism that is refined and has pages: `Of::<M>::FUNCTIONS` has them for every mechanism that
/// rustc compiled, and so has `kin_live::Mechanism`.
pub trait RefinedFunctions: FitFunctions + ReportFunctions {}

impl<F: FitFunctions + ReportFunctions> RefinedFunctions for F {}

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

/// The documentation of a result on its page.
fn summary(result: &Refined, objective: &Objective) -> String {
    let error = |misfit: Option<Misfit>| {
        misfit.map_or_else(
            || "open".to_owned(),
            |misfit| format!("{:.6e}", misfit.root_mean_square),
        )
    };
    let mut text = format!(
        "Candidate {}, refined to {} targets. Error (root of the mean square): {} at the start, {} after the evolution \
         strategy, {} after the least squares; {:.6e} at most, at target {}.",
        result.id,
        objective.target_count(),
        error(result.start),
        error(result.evolved),
        error(Some(result.polished)),
        result.polished.largest,
        result.polished.target,
    );
    let [x, y, rotation] = result.design.placement();
    if [x, y, rotation] != [0.0; 3] {
        let _ = write!(
            text,
            " Its frame stands at ({x:.6}, {y:.6}) in the plane of the targets, turned by {:.4} degrees.",
            rotation.to_degrees()
        );
    }
    text += if result.figures.is_full_revolution {
        " The input makes full revolutions."
    } else {
        " The input swings."
    };
    if let Some(least) = result.figures.transmission {
        let _ = write!(
            text,
            " The transmission angle is {:.2} degrees or more.",
            least.value.to_degrees()
        );
    }
    text
}

/// The report of kin-studio about a mechanism in an assembly, which is chosen by its index.
fn draft<'f>(
    functions: &'f dyn RefinedFunctions,
    parameters: &[f64],
    assembly: Option<usize>,
    id: u64,
    said: String,
) -> Draft<'f, Untyped> {
    let draft = report::of(functions, parameters)
        .title(format!("{}, candidate {id}", functions.description().name))
        .documentation(said);
    match assembly {
        Some(assembly) => draft.assembly(assembly),
        None => draft,
    }
}

/// The report about a result, in its assembly, over its travel or the full revolution.
fn drafted<'f>(functions: &'f dyn RefinedFunctions, result: &Refined, objective: &Objective) -> Draft<'f, Untyped> {
    let inputs = objective.inputs_at(result.inputs[0]);
    let (design, said) = (&result.design, summary(result, objective));
    let draft = draft(functions, design.parameters(), design.choice().index(), result.id, said)
        .at(&inputs)
        .moving(objective.moving_input())
        .plots(objective.quantities());
    let [from, to] = result.figures.travel;
    if result.figures.is_full_revolution || from == to {
        draft
    } else {
        draft.range(from.min(to)..=from.max(to))
    }
}

/// Writes a page for each result into a folder, which is made if need be, and returns their paths. The functions are
/// those of the objective. The files are called after the mechanism, the rank of the result and the number of its
/// candidate.
///
/// # Errors
/// [`PageError`].
pub fn write_pages(
    functions: &dyn RefinedFunctions,
    refinement: &Refinement,
    objective: &Objective,
    folder: impl AsRef<Path>,
) -> Result<Vec<PathBuf>, PageError> {
    let reports = refinement.results.iter();
    let reports = reports.map(|result| (result.id, drafted(functions, result, objective)));
    write(functions, reports, folder.as_ref())
}

/// Writes a page for each row of a table into a folder, which is made if need be, and returns their paths.
///
/// The table has the form that a query writes, as for [`Job::candidates`](kin_fit::Job::candidates). The page shows the
/// values of its other columns. The input moves as far as the mechanism closes.
///
/// # Errors
/// [`PageError`].
///
/// ```
/// use kin_core::any::Of;
/// use kin_core::library::FourBar;
/// use kin_search::pages::write_pages_of;
///
/// let folder = std::env::temp_dir().join(format!("kin-pages-{}", std::process::id()));
/// let rows = "id,r1,r2,r3,r4,assembly,swing\n7,90,30,80,60,open,61.2\n";
/// let pages = write_pages_of(Of::<FourBar>::FUNCTIONS, rows, &folder)?;
/// assert!(pages[0].ends_with("four-bar-1-7.html"));
/// assert!(std::fs::read_to_string(&pages[0])?.contains("swing: 61.2"));
/// # std::fs::remove_dir_all(folder)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_pages_of(
    functions: &'static dyn RefinedFunctions,
    table: &str,
    folder: impl AsRef<Path>,
) -> Result<Vec<PathBuf>, PageError> {
    let rows = read_candidates(functions, table, usize::MAX).map_err(PageError::Table)?;
    let reports = rows.into_iter().map(|(candidate, said)| {
        let Candidate {
            id, parameters, choice, ..
        } = candidate;
        (id, draft(functions, &parameters, choice.index(), id, said))
    });
    write(functions, reports, folder.as_ref())
}

/// Writes reports, each with the number of its candidate. The files are called after the mechanism, the rank of the
/// report and this number.
fn write<'f>(
    functions: &dyn RefinedFunctions,
    reports: impl Iterator<Item = (u64, Draft<'f, Untyped>)>,
    folder: &Path,
) -> Result<Vec<PathBuf>, PageError> {
    fs::create_dir_all(folder).map_err(|error| PageError::Folder {
        path: folder.to_owned(),
        error,
    })?;
    let name = file_name(functions.description().name);
    let pages = reports.enumerate().map(|(index, (id, draft))| {
        let path = folder.join(format!("{name}-{}-{id}.html", index + 1));
        let written = draft.write(&path);
        written.map_err(|error| PageError::Report {
            id,
            error: error.into(),
        })?;
        Ok(path)
    });
    pages.collect()
}
