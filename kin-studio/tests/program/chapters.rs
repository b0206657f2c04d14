//! The `.kin` files of the book, which move in its pages of kin-web.

use std::fs;
use std::path::Path;

use kin_studio::case::Document;

/// The texts of the blocks that begin with a line, each with its chapter.
fn blocks(begin: &str) -> Vec<(String, String)> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let mut found = Vec::new();
    for entry in fs::read_dir(docs).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "md") {
            continue;
        }
        let chapter = path.file_stem().unwrap().to_string_lossy().into_owned();
        let text = fs::read_to_string(&path).unwrap();
        let begin = format!("\n{begin}\n");
        let behind = text.split(&begin).skip(1);
        found.extend(behind.map(|rest| (chapter.clone(), rest.split("```").next().unwrap().to_owned())));
    }
    found.sort();
    found
}

#[test]
fn every_file_of_the_book_moves() {
    let files = blocks("```kin");
    for (chapter, text) in &files {
        let (check, document) = Document::checked(text, &format!("{chapter}.kin"));
        let document = document.unwrap_or_else(|| panic!("{check}"));
        let report = document.motion().unwrap_or_else(|error| panic!("{chapter}: {error}"));
        assert!(report.solver.is_some() || report.frames.is_some(), "{chapter}");
    }
    for chapter in ["assemblies", "cycle", "first-mechanism", "forces", "program"] {
        assert!(files.iter().any(|(own, _)| own == chapter), "{chapter} has no file");
    }
}

#[test]
fn every_file_of_the_book_is_marked() {
    for (chapter, text) in blocks("```text") {
        assert!(
            !text.starts_with("kin 1\n"),
            "{chapter} has a file in a block of text:\n{text}"
        );
    }
}
