//! The questions of the page, and their answers.

use kin_sketch::foreign;
use kin_sketch::{DriveMotion, Sketch, SketchDeclaration, SketchFault};
use kin_studio::case::{self, Document, Language};
use kin_studio::report::Report;
use serde::{Deserialize, Serialize};

use crate::examples::{Example, examples};

/// The name under which the text of the page is known in messages.
const NAME: &str = "mechanism.kin";

/// A question of the page.
#[derive(Clone, Debug, Deserialize)]
#[serde(tag = "ask", rename_all = "lowercase")]
pub enum Question {
    /// The mechanisms of the library as files.
    Examples,
    /// The mistakes of a text, or its outline: the object that `kin check --json` prints.
    Check {
        /// The text of a `.kin` file.
        text: String,
    },
    /// The content of the moving page without peaks, with the solver in JavaScript.
    Motion {
        /// The text of a `.kin` file.
        text: String,
    },
    /// The whole content of the moving page.
    Report {
        /// The text of a `.kin` file.
        text: String,
    },
    /// The page as one file, as `kin report` writes it.
    Page {
        /// The text of a `.kin` file.
        text: String,
    },
    /// The text as `kin fmt` writes it.
    Format {
        /// The text of a `.kin` file.
        text: String,
    },
    /// The solver in another language.
    Code {
        /// The text of a `.kin` file.
        text: String,
        /// `c`, `js` or `python`.
        language: CodeLanguage,
    },
    /// The declaration of a drawing.
    Draw {
        /// The drawing.
        sketch: Sketch,
    },
    /// The drawing in a file of another program.
    Import {
        /// The text of the file, or the address that the program shares.
        text: String,
    },
}

/// A drawing that became a declaration, or the reasons why it did not.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Drawn {
    /// The declaration, and the text of a whole `.kin` file.
    Declared {
        /// The declaration with its dimensions.
        #[serde(flatten)]
        declaration: SketchDeclaration,
        /// The text of a `.kin` file.
        file: String,
    },
    /// The faults of the drawing.
    Faults {
        /// Each fault with its advice and the parts that it is about.
        faults: Vec<SketchFault>,
    },
}

/// The drawing of another program.
#[derive(Clone, Debug, Serialize)]
pub struct Imported {
    /// The drawing.
    pub sketch: Sketch,
    /// The parts of the file that the drawing lacks or holds otherwise, each in a sentence.
    pub notes: Vec<String>,
    /// The declared drawing with the motions and units of the file, or its faults.
    pub drawn: Drawn,
}

/// A language of solvers, as the page names it.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum CodeLanguage {
    /// C99.
    C,
    /// JavaScript.
    Js,
    /// Python with NumPy.
    Python,
}

/// An answer to the page.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Answer {
    /// The mechanisms of the library.
    Examples(Vec<Example>),
    /// The mistakes, or the outline.
    Check(Box<serde_json::value::RawValue>),
    /// The content of the moving page.
    Report(Box<Report>),
    /// A text: a page, or a file in one form.
    Text(String),
    /// Files, each with its name.
    Files(Vec<(String, String)>),
    /// A declared drawing, or its faults.
    Drawn(Box<Drawn>),
    /// The drawing of another program.
    Imported(Box<Imported>),
    /// The reason why there is no answer, in words.
    Refused(String),
}

/// The answer to a question, both as JSON.
#[must_use]
pub fn answer(question: &str) -> String {
    let answer = match serde_json::from_str(question) {
        Ok(question) => answer_to(&question).unwrap_or_else(Answer::Refused),
        Err(error) => Answer::Refused(format!("the question cannot be read: {error}")),
    };
    // texts and finite numbers under fixed names can always be written
    serde_json::to_string(&answer).unwrap_or_default()
}

fn answer_to(question: &Question) -> Result<Answer, String> {
    Ok(match question {
        Question::Examples => Answer::Examples(examples()),
        Question::Check { text } => {
            let object = serde_json::value::RawValue::from_string(case::check(text, NAME));
            Answer::Check(object.map_err(|error| error.to_string())?)
        }
        Question::Motion { text } => Answer::Report(Box::new(Document::read(text, NAME)?.motion()?)),
        Question::Report { text } => Answer::Report(Box::new(Document::read(text, NAME)?.report()?)),
        Question::Page { text } => Answer::Text(Document::read(text, NAME)?.report()?.html()),
        Question::Format { text } => Answer::Text(case::formatted(text, NAME)?),
        Question::Code { text, language } => {
            let language = match language {
                CodeLanguage::C => Language::C,
                CodeLanguage::Js => Language::JavaScript,
                CodeLanguage::Python => Language::Python,
            };
            Answer::Files(Document::read(text, NAME)?.code(language)?)
        }
        Question::Draw { sketch } => Answer::Drawn(Box::new(drawn(sketch, "", "", &[]))),
        Question::Import { text } => {
            let found = foreign::read(text).map_err(|error| error.to_string())?;
            let documentation = format!("Imported from {}.", found.format.program());
            let unit = found.unit.unwrap_or_default();
            Answer::Imported(Box::new(Imported {
                drawn: drawn(&found.sketch, &documentation, unit, &found.motions),
                sketch: found.sketch,
                notes: found.notes,
            }))
        }
    })
}

/// Declares a drawing. The file begins with the documentation, and has lengths in the unit.
fn drawn(sketch: &Sketch, documentation: &str, unit: &str, motions: &[DriveMotion]) -> Drawn {
    match sketch.declaration() {
        Ok(declaration) => {
            let file = declaration.kin_file(documentation, unit, motions);
            let file = case::formatted(&file, NAME).unwrap_or(file);
            Drawn::Declared { declaration, file }
        }
        Err(faults) => Drawn::Faults { faults },
    }
}
