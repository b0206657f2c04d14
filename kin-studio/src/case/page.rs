//! The wishes for a page.

use kin_core::any::Quantity;

use super::columns::{columns_of, label};
use super::fault::Fault;
use super::file::Settings;
use super::subject::Subject;

/// What is wanted of a page.
#[derive(Clone, Debug, Default)]
pub(crate) struct PageWishes {
    /// The title.
    pub(crate) title: Option<String>,
    /// The quantities that are plotted at first.
    pub(crate) plots: Vec<String>,
    /// What the mechanism is.
    pub(crate) documentation: String,
    /// The declaration as it was typed.
    pub(crate) declaration: Option<String>,
    /// Whether the range of the input was given.
    pub(crate) has_range: bool,
    /// Whether the peaks are wanted, which take most of the time.
    pub(crate) has_peaks: bool,
}

impl PageWishes {
    /// The wishes that a file states. The quantities that were typed come before those of its columns.
    pub(crate) fn of(subject: &Subject, typed: &[String], settings: &Settings, has_range: bool) -> Result<Self, Fault> {
        Ok(Self {
            title: None,
            plots: plots(subject, typed, settings)?,
            documentation: settings.documentation.clone(),
            declaration: Some(settings.declaration.clone()).filter(|text| !text.is_empty()),
            has_range,
            has_peaks: true,
        })
    }
}

/// The quantities that were typed, or else those of the file's columns.
fn plots(subject: &Subject, typed: &[String], settings: &Settings) -> Result<Vec<String>, Fault> {
    if !typed.is_empty() {
        return Ok(typed.to_vec());
    }
    let columns = columns_of(subject, &[], settings)?;
    let description = subject.description();
    let results = || description.unknowns.iter().chain(description.outputs);
    let forces = subject.forces(&settings.loads.stated(1.0)).all;
    let shown = columns.iter().filter_map(|name| {
        let is_wanted =
            |quantity: &&Quantity<'_>| (0..=description.order).any(|order| label(quantity.name, order) == *name);
        let force = || forces.iter().find(|force| force.name(description) == *name);
        let quantity = results().find(is_wanted).map(|quantity| quantity.name.to_owned());
        quantity.or_else(|| force()?.plot(description))
    });
    let mut plots: Vec<String> = Vec::new();
    for name in shown {
        if !plots.contains(&name) {
            plots.push(name);
        }
    }
    Ok(plots)
}
