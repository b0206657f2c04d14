//! The width of the sources: lines have 120 characters at most.

use std::fs;
use std::path::{Path, PathBuf};

use crate::root;

const WIDTH: usize = 120;

/// The files below a folder with the numbers of their lines that are too long.
fn long_lines(path: &Path) -> Vec<(PathBuf, usize)> {
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
    long.map(|(index, _)| (path.to_path_buf(), index + 1)).collect()
}

/// A row of a table, also in a comment, and a figure of the book stand on one line, however long that is.
fn is_too_long(line: &str) -> bool {
    let text = line.trim_start();
    let comment = ["/// ", "//! "].iter().find_map(|mark| text.strip_prefix(mark));
    line.chars().count() > WIDTH && !comment.unwrap_or(line).starts_with("| ") && !line.starts_with("![")
}

#[test]
fn lines_are_not_too_long() {
    let long = long_lines(&root());
    let faults: Vec<String> = long
        .iter()
        .map(|(path, line)| format!("{}:{line}", path.display()))
        .collect();
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
    assert!(!is_too_long(&format!("    /// | {} |", "x".repeat(WIDTH))));
    assert!(is_too_long(&format!("    // | {} |", "x".repeat(WIDTH))));
}
