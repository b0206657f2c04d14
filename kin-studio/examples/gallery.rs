//! Writes a page for every mechanism of the library, or for those with the given names, and an index with drawings.
//!
//! ```sh
//! cargo run --release -p kin-studio --features gallery --example gallery -- pages
//! cargo run --release -p kin-studio --features gallery --example gallery -- pages FourBar JansenLeg
//! ```
//!
//! It prints the time and the size of each page.

use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

use kin_core::Mechanism;
use kin_studio::figures::{self, Entry};
use kin_studio::library::{self, Visitor};
use kin_studio::report::{ReportError, file_name};

/// The chapter that describes each mechanism.
const CHAPTER: &str = include_str!("../../docs/library.md");

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args();
    let folder = PathBuf::from(arguments.nth(1).unwrap_or_else(|| "target/pages".to_owned()));
    std::fs::create_dir_all(&folder).map_err(|error| format!("{} cannot be made: {error}", folder.display()))?;
    let mut pages = Pages {
        folder,
        wanted: arguments.collect(),
        written: Vec::new(),
        mistake: None,
    };
    library::visit(&mut pages);
    if let Some(name) = pages.wanted.iter().find(|name| !pages.written.contains(&name.as_str()))
        && pages.mistake.is_none()
    {
        return Err(format!("no mechanism of the library is called `{name}`").into());
    }
    if let Some(error) = pages.mistake {
        return Err(error.into());
    }
    let index = pages.folder.join("index.html");
    std::fs::write(&index, listed(&figures::gallery()?, &pages.written))?;
    println!(
        "\n{} pages: open {}",
        pages.written.len(),
        std::path::absolute(index)?.display()
    );
    Ok(())
}

/// Writes the pages.
struct Pages {
    folder: PathBuf,
    /// The names of the mechanisms; all if there are none.
    wanted: Vec<String>,
    written: Vec<&'static str>,
    mistake: Option<ReportError>,
}

impl Visitor for Pages {
    fn visit<M: Mechanism<Scalar = f64>>(&mut self, mechanism: &M, inputs: M::Inputs<f64>, assembly: M::Assembly) {
        let name = M::DESCRIPTION.name;
        if !self.wanted.is_empty() && !self.wanted.iter().any(|wanted| wanted == name) {
            return;
        }
        let file = self.folder.join(format!("{}.html", file_name(name)));
        match write(mechanism, inputs, assembly, &file) {
            Ok(()) => self.written.push(name),
            Err(error) => self.mistake = self.mistake.take().or(Some(error)),
        }
    }
}

/// Writes the page of a mechanism, and prints its time and size.
fn write<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    inputs: M::Inputs<f64>,
    assembly: M::Assembly,
    file: &Path,
) -> Result<(), ReportError> {
    let name = M::DESCRIPTION.name;
    let start = Instant::now();
    let report = kin_studio::report(mechanism)
        .at(inputs)
        .assembly(assembly)
        .documentation(described(name))
        .report()?;
    let time = start.elapsed();
    report.write(file)?;
    println!(
        "{name:32}{:8.1} ms{:6} KB",
        1e3 * time.as_secs_f64(),
        report.html().len() / 1000
    );
    Ok(())
}

/// The description of a mechanism in the book, without emphasis.
fn described(name: &str) -> String {
    let heading = format!("### {name}\n");
    let part = CHAPTER.split(&heading).nth(1).and_then(|rest| rest.split("\n#").next());
    let paragraphs = part.unwrap_or_default().split("\n\n").map(str::trim);
    let texts = paragraphs.filter(|paragraph| !paragraph.starts_with("![") && !paragraph.is_empty());
    texts.collect::<Vec<_>>().join(" ").replace('\n', " ").replace('`', "")
}

/// The index: a drawing of each mechanism, which leads to its page.
fn listed(entries: &[Entry], written: &[&str]) -> String {
    let mut list = String::new();
    for entry in entries.iter().filter(|entry| written.contains(&entry.name)) {
        // a String never refuses what is written to it
        let _ = writeln!(
            list,
            "<li><a href=\"{}.html\">{}<span>{}</span></a></li>",
            file_name(entry.name),
            entry.figure().svg,
            entry.name
        );
    }
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>The mechanisms of kin</title>\n<style>{STYLE}</style>\n</head>\n<body>\n\
         <h1>The mechanisms of kin</h1>\n<p>Each drawing leads to a page on which the mechanism moves.</p>\n\
         <ul>\n{list}</ul>\n</body>\n</html>\n"
    )
}

/// The style of the index. The drawings are ink on paper, so that the page is paper in the dark, too.
const STYLE: &str = "body{margin:2rem auto;max-width:80rem;padding:0 1rem;font:1rem/1.5 system-ui,sans-serif;\
color:#222;background:#fff}\
ul{list-style:none;margin:0;padding:0;display:grid;grid-template-columns:repeat(auto-fill,minmax(16rem,1fr));\
gap:1.5rem}\
a{display:block;color:inherit;text-decoration:none}a:hover span,a:focus span{text-decoration:underline}\
svg{display:block;width:100%;height:auto}span{display:block;text-align:center}";
