//! The statements of the book that are not run: its chapters, its tables of operations, and its excerpts of generated
//! code.

use std::fs;
use std::path::{Path, PathBuf};

use kin_core::Operations;
use kin_core::library::FourBar;
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The files of the chapters, in alphabetical order.
fn chapters() -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(root().join("docs"))
        .expect("the book is there")
        .map(|entry| {
            entry
                .expect("it can be listed")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .filter(|name| Path::new(name).extension().is_some_and(|extension| extension == "md"))
        .filter(|name| name != "SUMMARY.md")
        .collect();
    names.sort_unstable();
    names
}

/// Each fenced block's language and lines.
fn blocks(text: &str) -> Vec<(String, Vec<String>)> {
    let mut blocks: Vec<(String, Vec<String>)> = Vec::new();
    let mut is_inside = false;
    for line in text.lines() {
        match line.strip_prefix("```") {
            Some(_) if is_inside => is_inside = false,
            Some(language) => {
                is_inside = true;
                blocks.push((language.to_owned(), Vec::new()));
            }
            None if is_inside => blocks.last_mut().expect("a block is open").1.push(line.to_owned()),
            None => {}
        }
    }
    assert!(!is_inside, "a block is not closed");
    blocks
}

/// The summary links every chapter by its own title, and nothing else.
#[test]
fn the_summary_lists_the_chapters() {
    let mut links: Vec<(String, String)> = read("docs/SUMMARY.md")
        .lines()
        .filter_map(|line| {
            let (title, target) = line.trim_start_matches("- ").strip_prefix('[')?.split_once("](")?;
            Some((target.trim_end_matches(')').to_owned(), title.to_owned()))
        })
        .collect();
    links.sort_unstable();
    let found: Vec<(String, String)> = chapters()
        .into_iter()
        .map(|name| {
            let text = read(&format!("docs/{name}"));
            let title = text.lines().next().and_then(|line| line.strip_prefix("# "));
            let title = title.unwrap_or_else(|| panic!("{name} has no title")).to_owned();
            (name, title)
        })
        .collect();
    assert_eq!(links, found);
}

/// The anchor that pages give to a heading: its letters, digits, hyphens and underscores in lower case, with hyphens
/// for spaces.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter_map(|character| match character {
        ' ' => Some('-'),
        '-' | '_' => Some(character),
        _ => character.is_alphanumeric().then_some(character),
    });
    kept.flat_map(char::to_lowercase).collect()
}

/// The text outside of fenced blocks.
fn prose(text: &str) -> String {
    let parts = text.split("\n```").step_by(2);
    parts.collect::<Vec<_>>().join("\n")
}

/// Every link within the repository leads to a file that is there, and to one of its headings. A link may be broken
/// between two lines.
#[test]
fn links_lead_somewhere() {
    let mut dead = Vec::new();
    let pages = chapters().into_iter().map(|name| format!("docs/{name}"));
    let others = ["README.md", "CONTRIBUTING.md", "SECURITY.md", "docs/SUMMARY.md"];
    for page in pages.chain(others.map(str::to_owned)) {
        let text = prose(&read(&page));
        let folder = Path::new(&page).parent().expect("a page lies in a folder");
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            if link.starts_with("http") || link.contains(char::is_whitespace) {
                continue;
            }
            let (target, wanted) = link.split_once('#').unwrap_or((link, ""));
            let target = if target.is_empty() {
                PathBuf::from(&page)
            } else {
                folder.join(target)
            };
            let is_there = root().join(&target).exists();
            let has_heading = || {
                let text = prose(&read(&target.to_string_lossy()));
                let lines = text.lines().filter(|line| line.starts_with('#'));
                let mut headings = lines.filter_map(|line| line.trim_start_matches('#').strip_prefix(' '));
                wanted.is_empty() || headings.any(|heading| anchor(heading) == wanted)
            };
            if !is_there || !has_heading() {
                dead.push(format!("{page}: {link}"));
            }
        }
    }
    assert!(dead.is_empty(), "links that lead nowhere:\n{}", dead.join("\n"));
}

/// Code runs as a documentation test if its chapter is listed there, and if its block says that it is Rust. The
/// programs in other languages are run by the tests of tapes.
#[test]
fn all_code_is_run() {
    let listed = read("tests/src/book.rs");
    for name in chapters() {
        assert!(listed.contains(&format!("docs/{name}\"")), "{name} is not run");
    }
    let pages = chapters().into_iter().map(|name| format!("docs/{name}"));
    for page in pages.chain(["README.md".to_owned(), "CHANGELOG.md".to_owned()]) {
        for (language, _) in blocks(&read(&page)) {
            let is_known = ["rust", "rust,compile_fail", "rust,no_run", "text", "sh", "toml"]
                .contains(&language.as_str())
                || (page == "docs/languages.md" && ["c", "html", "python"].contains(&language.as_str()))
                // these files are moved by kin-studio's tests, and in the book of kin-web by its readers
                || language == "kin"
                // the queries of the chapter are run by kin-search's own tests
                || (page == "docs/search.md" && language == "sql")
                // as are the examples in Python by those of kin-python
                || (page == "docs/python.md" && language == "pycon")
                || (page == "README.md" && language == "python");
            assert!(is_known, "{page} has a block of `{language}`");
        }
    }
}

/// The documentation of the macro has the statements of the chapter's grammar.
#[test]
fn the_macro_has_the_grammar_of_the_chapter() {
    let (macro_documentation, chapter) = (read("kin-core/src/declaration.rs"), read("docs/grammar.md"));
    let documented: Vec<&str> = macro_documentation
        .lines()
        .skip_while(|line| !line.starts_with("/// declaration "))
        .take_while(|line| *line != "/// ```")
        .map(|line| line.trim_start_matches("///").strip_prefix(' ').unwrap_or_default())
        .collect();
    let written = blocks(&chapter)
        .into_iter()
        .find(|(_, lines)| lines[0].starts_with("declaration "));
    let (_, written) = written.expect("the chapter has a grammar");
    assert!(documented.len() > 20, "{documented:?}");
    assert_eq!(documented, written[..documented.len()]);
    assert!(
        written[documented.len() + 1].starts_with("expression "),
        "all but the expressions"
    );
}

/// Every picture is there, and every one is shown.
#[test]
fn figures_are_shown() {
    let mut text: String = chapters().iter().map(|name| read(&format!("docs/{name}"))).collect();
    text += &read("README.md").replace("](docs/figures/", "](figures/");
    let mut shown: Vec<&str> = text
        .split("](figures/")
        .skip(1)
        .filter_map(|rest| rest.split(')').next())
        .collect();
    let mut there: Vec<String> = fs::read_dir(root().join("docs/figures"))
        .expect("there are figures")
        .map(|entry| {
            entry
                .expect("it can be listed")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    shown.sort_unstable();
    shown.dedup();
    there.sort_unstable();
    assert_eq!(shown, there);
}

/// Without white space, and without the commas that formatting sets at the ends of lines.
fn bare(code: &str) -> String {
    let dense: String = code.chars().filter(|character| !character.is_whitespace()).collect();
    dense.replace(",)", ")")
}

/// Compares the generated code that a chapter shows with the snapshot of the expansion.
fn assert_excerpts(chapter: &str, expansion: &str) {
    let snapshot = bare(&read(&format!(
        "kin-compiler/src/testing/snapshots/kin_compiler__testing__expansion__{expansion}_expansion.snap"
    )));
    let mut count = 0;
    for (language, lines) in blocks(&read(chapter)) {
        let is_generated = lines.first().is_some_and(|line| line.starts_with("let "));
        if language == "text" && is_generated {
            let code = lines.join("\n");
            assert!(snapshot.contains(&bare(&code)), "not generated any more:\n{code}");
            count += 1;
        }
    }
    assert!(count > 0, "{chapter} has no excerpts");
}

#[test]
fn excerpts_are_what_is_generated() {
    assert_excerpts("docs/macro.md", "four_bar");
    assert_excerpts("docs/coupled.md", "triad");
}

/// Asserts that the table of the library has a row for each mechanism: its unknowns, and the sum of its operations from
/// an order on.
struct Rows {
    chapter: String,
    from: usize,
}

impl Visitor for Rows {
    fn visit<M: ThroughSnap>(&mut self, _: Case) {
        let description = M::DESCRIPTION;
        let unknowns: Vec<&str> = description.unknowns.iter().map(|unknown| unknown.name).collect();
        let start = format!("| `{}` | {} | ", description.name, unknowns.join(", "));
        let orders = &description.operations[self.from..];
        let sum: usize = orders.iter().map(Operations::arithmetic).sum();
        let end = format!(" | {sum} |");
        assert!(
            self.chapter
                .lines()
                .any(|line| line.starts_with(&start) && line.ends_with(&end)),
            "docs/library.md should have a line\n{start}…{end}"
        );
    }
}

/// The tables are what the mechanisms say of themselves. A position by Newton's method has no fixed cost.
#[test]
fn tables_of_operations_are_up_to_date() {
    let chapter = read("docs/library.md");
    cases::library(&mut Rows {
        chapter: chapter.clone(),
        from: 0,
    });
    cases::coupled_library(&mut Rows { chapter, from: 1 });
    let orders: Vec<String> = FourBar::OPERATIONS
        .iter()
        .map(|order| order.arithmetic().to_string())
        .collect();
    let row = format!("| operations | {} |", orders.join(" | "));
    assert!(
        read("README.md").lines().any(|line| line == row),
        "README.md should say\n{row}"
    );
}
