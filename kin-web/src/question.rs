//! The questions of the page, and their answers.

use kin_sketch::foreign;
use kin_sketch::{Sketch, SketchDeclaration, SketchFault};
use kin_studio::case::{self, Document, Language};
use kin_studio::report::Report;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

use crate::examples::{Example, examples};

/// The name under which the text of the page is known in messages.
const NAME: &str = "mechanism.kin";

/// A question of the page.
#[derive(Clone, Debug, Deserialize)]
#[serde(tag = "ask", rename_all = "lowercase")]
pub enum Question {
    /// The mechanisms of the library as files.
    Examples,
    /// The words of the language that names do not tell.
    Words,
    /// The mistakes of a text; without any, its outline and the content of the moving page without peaks.
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
        /// The unit of its lengths, or empty.
        #[serde(default)]
        unit: String,
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

/// A text that was checked, and its motion.
#[derive(Clone, Debug, Serialize)]
pub struct Moving {
    /// The object that `kin check --json` prints.
    pub check: Box<RawValue>,
    /// The content of the moving page without peaks, with the solver in JavaScript.
    pub report: Option<Report>,
    /// The reason why there is no page of a text without mistakes, in words.
    pub refused: Option<String>,
}

/// Words that can be completed.
#[derive(Clone, Debug, Serialize)]
pub struct Words {
    /// The names that an expression can call.
    pub functions: Vec<&'static str>,
    /// The units that a number can have.
    pub units: Vec<&'static str>,
}

/// An answer to the page.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Answer {
    /// The mechanisms of the library.
    Examples(Vec<Example>),
    /// The words of the language.
    Words(Words),
    /// The mistakes, or the outline with the content of the moving page.
    Motion(Box<Moving>),
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
        Question::Words => Answer::Words(Words {
            functions: kin_compiler::function_names().collect(),
            units: case::unit_names().collect(),
        }),
        Question::Motion { text } => {
            let (check, document) = Document::checked(text, NAME);
            let check = RawValue::from_string(check).map_err(|error| error.to_string())?;
            let report = document.map(|document| document.motion());
            let (report, refused) = match report.transpose() {
                Ok(report) => (report, None),
                Err(refused) => (None, Some(refused)),
            };
            Answer::Motion(Box::new(Moving { check, report, refused }))
        }
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
        Question::Draw { sketch, unit } => {
            Answer::Drawn(Box::new(drawn(sketch, |declared| declared.kin_file("", unit, &[]))))
        }
        Question::Import { text } => {
            let found = foreign::read(text).map_err(|error| error.to_string())?;
            Answer::Imported(Box::new(Imported {
                drawn: drawn(&found.sketch, |declared| found.kin_file(declared)),
                sketch: found.sketch,
                notes: found.notes,
            }))
        }
    })
}

/// Declares a drawing, and formats the file that is written of the declaration.
fn drawn(sketch: &Sketch, write: impl FnOnce(&SketchDeclaration) -> String) -> Drawn {
    match sketch.declaration() {
        Ok(declaration) => {
            let file = write(&declaration);
            let file = case::formatted(&file, NAME).unwrap_or(file);
            Drawn::Declared { declaration, file }
        }
        Err(faults) => Drawn::Faults { faults },
    }
}
