//! The messages about mistakes, each under the tokens at which the macro reports it.
//!
//! Each file beside this one holds the cases of one kind of mistake, between blank lines: a title, and below it a
//! declaration, indented by four. Lines of `//  ^^^^ message` from the first column belong to the line above them.
//! Their marks go from the first to the last token at fault. A message without marks, below the title, is reported at
//! the whole macro call.
//!
//! `KIN_RECORD=1 cargo test -p kin-compiler --lib mistakes` writes the messages. Read them before you keep them.

use std::fs;
use std::iter::once;
use std::path::Path;

use crate::text::{Declaration, Mistake};

#[test]
fn mistakes_are_reported_where_they_are_made() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/testing/mistakes");
    let entries = fs::read_dir(folder).expect("the folder is there");
    let files = entries.map(|entry| entry.expect("the folder can be read").path());
    let mut differences = Vec::new();
    for path in files.filter(|path| !path.ends_with("mod.rs")) {
        let recorded = fs::read_to_string(&path).expect("the cases are text");
        let recorded: Vec<&str> = recorded.trim_end().split("\n\n").collect();
        let found: Vec<String> = recorded.iter().copied().map(annotated).collect();
        if std::env::var_os("KIN_RECORD").is_some() {
            fs::write(&path, found.join("\n\n") + "\n").expect("the cases can be written");
            continue;
        }
        let differing = recorded
            .iter()
            .zip(&found)
            .filter(|(recorded, found)| recorded != found);
        differences.extend(differing.map(|(_, found)| format!("{}: {found}", path.display())));
    }
    assert!(
        differences.is_empty(),
        "these messages or their places are not as recorded:\n{}",
        differences.join("\n\n")
    );
}

/// A case with the messages that its declaration gives, whatever messages it is annotated with.
fn annotated(case: &str) -> String {
    let lines: Vec<&str> = case.lines().filter(|line| !line.starts_with("//")).collect();
    let (title, declaration) = lines.split_first().expect("a case has a title");
    assert!(!title.starts_with(' '), "{title}: a case begins here, without a title");
    let parsed = Declaration::parse(&declaration.join("\n"));
    let mistakes = parsed.expect_err("the declaration has no mistake");
    let annotations: Vec<(usize, String)> = mistakes.iter().map(|mistake| annotation(title, mistake)).collect();
    let annotated = lines.into_iter().enumerate().flat_map(|(number, line)| {
        let below = annotations.iter().filter(move |(above, _)| *above == number);
        once(line).chain(below.map(|(_, annotation)| annotation.as_str()))
    });
    annotated.collect::<Vec<_>>().join("\n")
}

/// The number of the line at fault, from the title on, and the line below it.
fn annotation(title: &str, mistake: &Mistake) -> (usize, String) {
    let (start, end, message) = (mistake.start, mistake.end, &mistake.message);
    if mistake.bytes.is_empty() {
        return (0, format!("// {message}"));
    }
    assert_eq!(
        start.line, end.line,
        "{title}: what is at fault stands on several lines, which cannot be marked"
    );
    let (before, marks) = (
        " ".repeat(start.column - 1 - "//".len()),
        "^".repeat(end.column - start.column),
    );
    (start.line, format!("//{before}{marks} {message}"))
}
