//! Reports as JSON.

use serde::Deserialize;

use super::{FORMAT, Report, ReportError};

impl Report {
    /// The report as JSON, which [`from_json`](Self::from_json) reads.
    #[must_use]
    pub fn to_json(&self) -> String {
        // Texts and finite numbers under fixed names can always be written.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// A report from JSON.
    ///
    /// # Errors
    /// [`ReportError::NewerFormat`] and [`ReportError::OlderFormat`] if another version has written it in another
    /// format, and [`ReportError::Json`] if it is no report.
    pub fn from_json(text: &str) -> Result<Self, ReportError> {
        /// The version alone, so that a later format is reported as such.
        #[derive(Deserialize)]
        struct Version {
            format: u32,
        }
        let Version { format } = serde_json::from_str(text)?;
        if format > FORMAT {
            return Err(ReportError::NewerFormat {
                found: format,
                known: FORMAT,
            });
        }
        if format < FORMAT {
            return Err(ReportError::OlderFormat {
                found: format,
                known: FORMAT,
            });
        }
        Ok(serde_json::from_str(text)?)
    }
}
