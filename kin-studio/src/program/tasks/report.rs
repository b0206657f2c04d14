//! `kin report`: the page of a mechanism.

use std::path::Path;

use kin_core::in_small_letters;

use super::super::command::Report;
use super::super::progress::watched;
use super::write;
use crate::case::fault::Fault;
use crate::case::file::Settings;
use crate::case::page::PageWishes;
use crate::case::subject::Subject;

pub(super) fn run(subject: &Subject, options: &Report, settings: &Settings) -> Result<(), Fault> {
    if let Some(path) = &options.output {
        is_page(path)?;
    }
    let page = page(subject, options, settings)?;
    let path = options.output.clone().unwrap_or_else(|| {
        let name = in_small_letters(subject.description().name, '_');
        format!("{name}.html").into()
    });
    write(&path, &page)?;
    if path.as_os_str() != "-" {
        eprintln!("open it in a browser");
    }
    // without a range, the page goes as far as the mechanism closes
    let typed = options.setup.typed(settings).first_assembly(subject);
    if typed.has_range() {
        subject.closes(&typed.case(subject)?)
    } else {
        Ok(())
    }
}

/// Refuses a name that promises another kind of file.
fn is_page(path: &Path) -> Result<(), Fault> {
    let Some(ending) = path.extension() else { return Ok(()) };
    if ["html", "htm", "xhtml"]
        .iter()
        .any(|known| ending.eq_ignore_ascii_case(known))
    {
        return Ok(());
    }
    Err(Fault::wrong(format!(
        "a report is a page in HTML: write `-o {}`; in a browser the page is printed as PDF",
        path.with_extension("html").display()
    )))
}

/// The page as one text.
pub(super) fn page(subject: &Subject, options: &Report, settings: &Settings) -> Result<String, Fault> {
    // the page lists all assemblies, and begins with this one
    let typed = options.setup.typed(settings).first_assembly(subject);
    let case = typed.case(subject)?;
    if let Some(error) = case.forces(subject).no_joints() {
        eprintln!("note: the page shows no forces in joints: {error}");
    }
    let wishes = PageWishes {
        title: options.title.clone(),
        ..PageWishes::of(subject, &options.plots, settings, typed.has_range())?
    };
    watched("making the page", 1, |_| subject.report(&case, &wishes)).map(|report| report.html())
}
