//! The wishes for a report, one after the other.

use std::marker::PhantomData;
use std::ops::RangeInclusive;
use std::path::Path;

use kin_core::Mechanism;
use kin_core::any::{AssemblyChoice, Of};
use kin_core::linkage::AnyLinkage;

use super::functions::ReportFunctions;
use super::model::Report;
use super::{ReportError, gather};

/// A report that is to be made: a mechanism, and what is wanted beside the defaults. [`report`](super::report) begins it.
#[derive(Clone, Debug)]
#[must_use = "write it, or ask for its `report`"]
pub struct Draft<M: Mechanism<Scalar = f64>> {
    wishes: Wishes,
    mechanism: PhantomData<M>,
}

/// A draft without the type of its mechanism.
#[derive(Clone, Debug)]
pub(crate) struct Wishes {
    pub(crate) functions: &'static dyn ReportFunctions,
    pub(crate) linkage: AnyLinkage,
    pub(crate) assembly: Option<AssemblyChoice>,
    pub(crate) inputs: Vec<f64>,
    pub(crate) moving: Option<String>,
    pub(crate) range: Option<[f64; 2]>,
    pub(crate) speed: f64,
    pub(crate) plots: Vec<String>,
    pub(crate) title: Option<String>,
    pub(crate) documentation: String,
    pub(crate) declaration: Option<String>,
    pub(crate) length: String,
    pub(crate) time: String,
    pub(crate) degrees: bool,
}

impl Wishes {
    /// No wishes beside the mechanism.
    pub(crate) fn new(functions: &'static dyn ReportFunctions, parameters: &[f64]) -> Self {
        Self {
            functions,
            linkage: AnyLinkage::new(functions, parameters),
            assembly: None,
            inputs: vec![0.0; functions.description().inputs.len()],
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

    pub(crate) fn report(&self) -> Result<Report, ReportError> {
        gather::report(self)
    }

    /// The inputs where the moving one is at a place.
    pub(super) fn inputs_at(&self, moving: usize, place: f64) -> Vec<f64> {
        let mut inputs = self.inputs.clone();
        inputs[moving] = place;
        inputs
    }
}

impl<M: Mechanism<Scalar = f64>> Draft<M> {
    pub(super) fn new(mechanism: &M) -> Self {
        Self {
            wishes: Wishes::new(Of::<M>::FUNCTIONS, mechanism.parameters().as_ref()),
            mechanism: PhantomData,
        }
    }

    /// The assembly that is shown first; otherwise the first one that closes. [`Near`](kin_core::Near) values hold where
    /// [`at`](Self::at) says.
    pub fn assembly(mut self, assembly: M::Assembly) -> Self {
        self.wishes.assembly = Some(AssemblyChoice::of::<M>(assembly));
        self
    }

    /// Where the inputs stand that do not move, and where values nearby hold; otherwise zero.
    pub fn at(mut self, inputs: M::Inputs<f64>) -> Self {
        self.wishes.inputs = inputs.as_ref().to_vec();
        self
    }

    /// The input that moves, by its name; otherwise the first one.
    pub fn moving(mut self, input: impl Into<String>) -> Self {
        self.wishes.moving = Some(input.into());
        self
    }

    /// The range of the moving input; otherwise as far as the mechanism closes.
    pub fn range(mut self, range: RangeInclusive<f64>) -> Self {
        self.wishes.range = Some([*range.start(), *range.end()]);
        self
    }

    /// The speed of the moving input; otherwise 1, so that rates are per unit of the input.
    pub fn speed(mut self, speed: f64) -> Self {
        self.wishes.speed = speed;
        self
    }

    /// The unknowns and outputs that are plotted at first, by their names; otherwise all.
    pub fn plots<N: Into<String>>(mut self, names: impl IntoIterator<Item = N>) -> Self {
        self.wishes.plots = names.into_iter().map(Into::into).collect();
        self
    }

    /// The title; otherwise the name of the mechanism.
    pub fn title(mut self, title: impl Into<String>) -> Self {
        self.wishes.title = Some(title.into());
        self
    }

    /// What the mechanism is, in a few sentences.
    pub fn documentation(mut self, text: impl Into<String>) -> Self {
        self.wishes.documentation = text.into();
        self
    }

    /// The declaration as it was typed, to be shown on the page.
    pub fn declaration(mut self, text: impl Into<String>) -> Self {
        self.wishes.declaration = Some(text.into());
        self
    }

    /// The names of the units of length and time; otherwise a length without a name, and seconds.
    pub fn units(mut self, length: impl Into<String>, time: impl Into<String>) -> Self {
        (self.wishes.length, self.wishes.time) = (length.into(), time.into());
        self
    }

    /// Angles in radians at first, instead of degrees.
    pub fn in_radians(mut self) -> Self {
        self.wishes.degrees = false;
        self
    }

    /// The report.
    ///
    /// # Errors
    /// [`ReportError`] if the mechanism closes nowhere, or if a number or a name is not one.
    pub fn report(&self) -> Result<Report, ReportError> {
        self.wishes.report()
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
