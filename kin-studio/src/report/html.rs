//! The page as one file.

use std::fmt::Write as _;
use std::path::Path;

use data_encoding::BASE64;
use hmac_sha256::Hash;

use super::{Report, ReportError};

/// The markup of the body.
const MARKUP: &str = include_str!("../page/page.html");
/// The style.
const STYLE: &str = include_str!("../page/bundle/page.css");
/// The modules of the page as one script, which asks for `kinSolver`.
const SCRIPT: &str = include_str!("../page/bundle/main.js");

impl Report {
    /// The page: one HTML file that needs no other file and no network. The same report gives the same bytes.
    ///
    /// Texts of the report are data in JSON, which the page's script sets as text. A content security policy admits
    /// only the page's script and style, by their hashes.
    #[must_use]
    pub fn html(&self) -> String {
        let script = script(self.solver.as_deref());
        let data = data(self);
        let policy = format!(
            "default-src 'none'; script-src '{}'; style-src '{}'; img-src data: blob:; base-uri 'none'; \
             form-action 'none'",
            source(&script),
            source(STYLE)
        );
        let title = escaped(&self.title);
        let mut page = String::new();
        // a String never refuses what is written to it
        let _ = write!(
            page,
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"generator\" content=\"kin {}\">\n\
             <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n{MARKUP}\n\
             <script type=\"application/json\" id=\"report\">{data}</script>\n\
             <script type=\"module\">{script}</script>\n</body>\n</html>\n",
            escaped(&self.kin),
        );
        page
    }

    /// Writes the page to a file.
    ///
    /// # Errors
    /// [`ReportError::File`] with the path.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), ReportError> {
        let path = path.as_ref();
        std::fs::write(path, self.html()).map_err(|error| ReportError::File {
            path: path.to_owned(),
            error,
        })
    }
}

/// A source of the content security policy: the hash of what stands between the tags.
fn source(content: &str) -> String {
    format!("sha256-{}", BASE64.encode(&Hash::hash(content.as_bytes())))
}

/// The data as JSON that ends no element: `<` and the line separators of Unicode are escaped. The solver is a separate
/// script.
fn data(report: &Report) -> String {
    let mut report = report.clone();
    report.solver = None;
    let mut escaped = String::new();
    for letter in report.to_json().chars() {
        match letter {
            '<' => escaped.push_str("\\u003c"),
            '>' => escaped.push_str("\\u003e"),
            '\u{2028}' => escaped.push_str("\\u2028"),
            '\u{2029}' => escaped.push_str("\\u2029"),
            other => escaped.push(other),
        }
    }
    escaped
}

/// Text between tags or in an attribute.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            other => escaped.push(other),
        }
    }
    escaped
}

/// The script: the solver in a separate scope, and the modules of the page.
fn script(solver: Option<&str>) -> String {
    let solver = solver.map_or_else(
        || "null".to_owned(),
        |module| {
            let solver = closed(&module.replace("\nexport ", "\n"));
            format!("(() => {{\n{solver}return {{ solve }};\n}})()")
        },
    );
    format!("\nconst kinSolver = {solver};\n{SCRIPT}")
}

/// A solver whose texts and comments end no element.
///
/// In a script `<!--`, `<script` and `</script` mean something to HTML. In the solver they occur in texts of the
/// declaration. Within quotes a backslash before the sign changes nothing, and in comments it does no harm.
fn closed(script: &str) -> String {
    let script = script.replace("<!", "<\\!").replace("</", "<\\/");
    script.replace("<script", "<\\script")
}
