//! A `.kin` file as a document: read once, and asked for its page and for its solver in other languages.

use kin_core::tape::Options;

use super::fault::Fault;
use super::file::{self, Settings};
use super::language::{self, Language};
use super::page::PageWishes;
use super::subject::Subject;
use crate::report::Report;

/// A `.kin` file that was read: its mechanism, and the case that it states.
///
/// ```
/// use kin_studio::case::Document;
///
/// let text = "kin 1
/// struct Crank { r: Length }
/// input theta: Angle;
/// unknown x: Length;
/// x == r * cos(theta);
/// dimensions { r = 30mm; }
/// ";
/// let document = Document::read(text, "crank.kin").expect("it has no mistake");
/// let report = document.report().expect("it closes");
/// assert_eq!((report.name.as_str(), report.units.length.as_str()), ("Crank", "mm"));
///
/// let mistakes = Document::read(&text.replace("r *", "q *"), "crank.kin").unwrap_err();
/// assert!(mistakes.contains("crank.kin:5:6"), "{mistakes}");
/// ```
#[derive(Debug)]
pub struct Document {
    subject: Subject,
    settings: Settings,
}

impl Document {
    /// Reads the text of a file, and compiles its declaration.
    ///
    /// # Errors
    /// Every mistake, each with its line under the name of the file and a mark below it.
    pub fn read(text: &str, name: &str) -> Result<Self, String> {
        let (subject, settings) = file::of_text(text, name)?;
        Ok(Self { subject, settings })
    }

    /// The mistakes of a text, or its outline, as one object of JSON for editors: the output of `kin check --json`. The
    /// document of a text without mistakes comes with it, compiled once for both.
    #[must_use]
    pub fn checked(text: &str, name: &str) -> (String, Option<Self>) {
        let file::Checked { object, asked, .. } = file::checked(text, name);
        let document = asked.map(|(subject, settings)| Self { subject, settings });
        (object, document)
    }

    /// The content of the page that `kin report` writes.
    ///
    /// # Errors
    /// The reason why there is no page, in words: a missing value, or dimensions for which the mechanism does not
    /// close.
    pub fn report(&self) -> Result<Report, String> {
        self.reported(true)
    }

    /// The same without peaks and means, which take most of the time: for pages that move while a person types.
    ///
    /// # Errors
    /// As [`Document::report`].
    pub fn motion(&self) -> Result<Report, String> {
        self.reported(false)
    }

    /// The files that `kin code` writes, each with its name: the solver for all dimensions.
    ///
    /// # Errors
    /// The reason why there is no solver in other languages, in words.
    pub fn code(&self, language: Language) -> Result<Vec<(String, String)>, String> {
        self.found(|| {
            let tape = self.subject.tape(&Options::new()).map_err(Fault::wrong)?;
            Ok(language::files(&tape, language))
        })
    }

    fn reported(&self, has_peaks: bool) -> Result<Report, String> {
        self.found(|| {
            let typed = self.settings.typed().first_assembly(&self.subject);
            let case = typed.case(&self.subject)?;
            let wishes = PageWishes::of(&self.subject, &[], &self.settings, typed.has_range())?;
            self.subject.report(&case, &PageWishes { has_peaks, ..wishes })
        })
    }

    fn found<R>(&self, find: impl FnOnce() -> Result<R, Fault>) -> Result<R, String> {
        find().map_err(|fault| self.subject.named(fault))
    }
}
