//! The page on which a linkage moves.

use std::path::PathBuf;

use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;

use crate::fault;
use crate::linkage::Linkage;
use crate::table::escaped;

/// A page on which a linkage moves, with plots, peaks and equations: one HTML file that needs no network.
/// `kin.Linkage.report` makes it, and a notebook shows it.
///
/// >>> import kin
/// >>> page = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60).report(speed=10.0)
/// >>> page.html.startswith("<!doctype html>")
/// True
#[pyclass(frozen, module = "kin")]
pub(crate) struct Page {
    html: String,
}

/// What the page shall show.
pub(crate) struct PageWishes {
    /// The index of the assembly.
    pub(crate) assembly: Option<usize>,
    pub(crate) at: Vec<f64>,
    pub(crate) moving: Option<String>,
    pub(crate) range: Option<(f64, f64)>,
    pub(crate) speed: Option<f64>,
    pub(crate) title: Option<String>,
    pub(crate) length: String,
    pub(crate) time: String,
}

impl Page {
    pub(crate) fn new(py: Python<'_>, linkage: &Linkage, wishes: PageWishes) -> PyResult<Self> {
        let mechanism = &linkage.declared.mechanism;
        let html = py.detach(|| {
            let mut draft = kin_studio::report::of(mechanism, &linkage.parameters);
            draft = draft.at(&wishes.at).units(wishes.length, wishes.time);
            draft = draft.declaration(linkage.declared.text.trim());
            if let Some(assembly) = wishes.assembly {
                draft = draft.assembly(assembly);
            }
            if let Some(moving) = wishes.moving {
                draft = draft.moving(moving);
            }
            if let Some((from, to)) = wishes.range {
                draft = draft.range(from..=to);
            }
            if let Some(speed) = wishes.speed {
                draft = draft.speed(speed);
            }
            if let Some(title) = wishes.title {
                draft = draft.title(title);
            }
            draft.html()
        });
        let html = html.map_err(|error| fault::of_answer(py, mechanism, error, None))?;
        Ok(Self { html })
    }
}

#[pymethods]
impl Page {
    /// The whole page.
    #[getter]
    fn html(&self) -> &str {
        &self.html
    }

    /// Writes the page to a file.
    #[expect(clippy::needless_pass_by_value, reason = "Python gives the path away")]
    fn write(&self, path: PathBuf) -> PyResult<()> {
        std::fs::write(&path, &self.html).map_err(|error| PyOSError::new_err(format!("{}: {error}", path.display())))
    }

    fn _repr_html_(&self) -> String {
        let page = escaped(&self.html);
        format!("<iframe srcdoc=\"{page}\" width=\"100%\" height=\"800\" style=\"border: 0\"></iframe>")
    }

    fn __repr__(&self) -> String {
        format!("<kin.Page of {} kB>", self.html.len().div_ceil(1000))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (&str,))> {
        Ok((py.import("kin._kin")?.getattr("restored_page")?, (&self.html,)))
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}

/// A page that was pickled.
#[pyfunction]
pub(crate) fn restored_page(html: String) -> Page {
    Page { html }
}
