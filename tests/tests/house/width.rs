//! The width of the sources: lines have 120 characters at most.

use std::fs;
use std::path::Path;

use crate::root;

const WIDTH: usize = 120;

/// What has longer lines still. A part that has none any more leaves the list.
const EXEMPT: [&str; 5] = ["README.md", "kin-compiler", "kin-core", "kin-macros", "tests"];

/// The places of lines that are too long, below a folder or in a file.
fn long_lines(path: &Path) -> Vec<String> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    if path.is_dir() {
        if name.starts_with('.') || matches!(&*name, "target" | "node_modules") {
            return Vec::new();
        }
        let entries = fs::read_dir(path).expect("the folder is there");
        return entries
            .flat_map(|entry| long_lines(&entry.expect("it can be listed").path()))
            .collect();
    }
    let is_source = path
        .extension()
        .is_some_and(|kind| kind == "rs" || kind == "mjs" || kind == "md");
    if !is_source {
        return Vec::new();
    }
    let text = fs::read_to_string(path).expect("a file of text");
    let long = text.lines().enumerate().filter(|(_, line)| is_too_long(line));
    long.map(|(index, _)| format!("{}:{}", path.display(), index + 1))
        .collect()
}

/// A row of a table and a figure of the book stand on one line, however long that is.
fn is_too_long(line: &str) -> bool {
    line.chars().count() > WIDTH && !line.starts_with("| ") && !line.starts_with("![")
}

#[test]
fn lines_are_not_too_long() {
    let mut faults = Vec::new();
    for entry in fs::read_dir(root()).expect("the project is there") {
        let path = entry.expect("it can be listed").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let long = long_lines(&path);
        if !EXEMPT.contains(&&*name) {
            faults.extend(long);
        } else if long.is_empty() {
            faults.push(format!("{name} has no long lines: take it off the list"));
        }
    }
    assert!(
        faults.is_empty(),
        "more than {WIDTH} characters:\n{}",
        faults.join("\n")
    );
}

#[test]
fn characters_are_counted_and_not_bytes() {
    assert!(!is_too_long(&"θ".repeat(WIDTH)));
    assert!(is_too_long(&"θ".repeat(WIDTH + 1)));
    assert!(!is_too_long(&format!("| {} |", "x".repeat(WIDTH))));
}
