//! The wishes for a report, one after the other.

use std::ops::RangeInclusive;
use std::path::Path;

use kin_core::Mechanism;

use super::model::Report;
use super::{ReportError, gather};

/// A report that is to be made: a mechanism, and what is wanted beside the defaults. [`report`](super::report) begins it.
#[derive(Clone, Debug)]
#[must_use = "write it, or ask for its `report`"]
pub struct Draft<M: Mechanism<Scalar = f64>> {
    pub(super) mechanism: M,
    pub(super) assembly: Option<M::Assembly>,
    pub(super) inputs: M::Inputs<f64>,
    pub(super) moving: Option<String>,
    pub(super) range: Option<[f64; 2]>,
    pub(super) speed: f64,
    pub(super) plots: Vec<String>,
    pub(super) title: Option<String>,
    pub(super) documentation: String,
    pub(super) declaration: Option<String>,
    pub(super) length: String,
    pub(super) time: String,
    pub(super) degrees: bool,
}

impl<M: Mechanism<Scalar = f64>> Draft<M> {
    pub(super) fn new(mechanism: &M) -> Self {
        use kin_core::Row as _;
        Self {
            mechanism: *mechanism,
            assembly: None,
            inputs: M::Inputs::splat(0.0),
            moving: None,
            range: None,
            speed: 1.0,
            plots: Vec::new(),
            title: None,
            documentation: String::new(),
            declaration: None,
            length: String::new(),
            time: "s".to_owned(),
            degrees: true,
        }
    }

    /// The assembly that is shown first; otherwise the first one that closes. [`Near`](kin_core::Near) values hold where
    /// [`at`](Self::at) says.
    pub fn assembly(mut self, assembly: M::Assembly) -> Self {
        self.assembly = Some(assembly);
        self
    }

    /// Where the inputs stand that do not move, and where values nearby hold; otherwise zero.
    pub fn at(mut self, inputs: M::Inputs<f64>) -> Self {
        self.inputs = inputs;
        self
    }

    /// The input that moves, by its name; otherwise the first one.
    pub fn moving(mut self, input: impl Into<String>) -> Self {
        self.moving = Some(input.into());
        self
    }

    /// The range of the moving input; otherwise as far as the mechanism closes.
    pub fn range(mut self, range: RangeInclusive<f64>) -> Self {
        self.range = Some([*range.start(), *range.end()]);
        self
    }

    /// The speed of the moving input; otherwise 1, so that rates are per unit of the input.
    pub fn speed(mut self, speed: f64) -> Self {
        self.speed = speed;
        self
    }

    /// The unknowns and outputs that are plotted at first, by their names; otherwise all.
    pub fn plots<N: Into<String>>(mut self, names: impl IntoIterator<Item = N>) -> Self {
        self.plots = names.into_iter().map(Into::into).collect();
        self
    }

    /// The title; otherwise the name of the mechanism.
    pub fn title(mut self, title: impl Into<String>) -> Self {
        self.title = Some(title.into());
        self
    }

    /// What the mechanism is, in a few sentences.
    pub fn documentation(mut self, text: impl Into<String>) -> Self {
        self.documentation = text.into();
        self
    }

    /// The declaration as it was typed, to be shown on the page.
    pub fn declaration(mut self, text: impl Into<String>) -> Self {
        self.declaration = Some(text.into());
        self
    }

    /// The names of the units of length and time; otherwise a length without a name, and seconds.
    pub fn units(mut self, length: impl Into<String>, time: impl Into<String>) -> Self {
        (self.length, self.time) = (length.into(), time.into());
        self
    }

    /// Angles in radians at first, instead of degrees.
    pub fn in_radians(mut self) -> Self {
        self.degrees = false;
        self
    }

    /// The report.
    ///
    /// # Errors
    /// [`ReportError`] if the mechanism closes nowhere, or if a number or a name is not one.
    pub fn report(&self) -> Result<Report, ReportError> {
        gather::report(self)
    }

    /// The page.
    ///
    /// # Errors
    /// As for [`report`](Self::report).
    pub fn html(&self) -> Result<String, ReportError> {
        Ok(self.report()?.html())
    }

    /// Writes the page to a file.
    ///
    /// # Errors
    /// As for [`report`](Self::report), and [`ReportError::File`].
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), ReportError> {
        self.report()?.write(path)
    }
}
