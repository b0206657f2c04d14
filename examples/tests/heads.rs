//! Each example prints what its head says.

use std::fs;
use std::path::Path;
use std::process::Command;

/// The examples whose heads show all that they print.
const SHOWN: [&str; 9] = [
    "all_positions",
    "batch",
    "controller_step",
    "drive_from_the_slider",
    "driving_torque",
    "five_bar_robot",
    "quick_return",
    "rssr_steering",
    "tolerances",
];

/// The lines of the block of text in the head of a source.
fn head(source: &str) -> String {
    source
        .lines()
        .skip_while(|line| *line != "//! ```text")
        .skip(1)
        .take_while(|line| *line != "//! ```")
        .flat_map(|line| [line.strip_prefix("//! ").unwrap_or_default(), "\n"])
        .collect()
}

/// What an example prints. Cargo builds the examples of a package before it runs the tests, unless one test alone is
/// asked for.
fn printed(name: &str, source: &Path) -> String {
    let this = std::env::current_exe().expect("this test has a path");
    let folder = this
        .ancestors()
        .nth(2)
        .expect("it lies in a folder of the target")
        .join("examples");
    let program = folder.join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    let changed = |path: &Path| fs::metadata(path).and_then(|file| file.modified()).ok();
    assert!(
        changed(&program) > changed(source),
        "{name} is not built: run `cargo test -p kin-examples`"
    );
    let output = Command::new(program).output().expect("it runs");
    assert!(
        output.status.success(),
        "{name}: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout).expect("it prints text")
}

#[test]
fn examples_print_what_their_heads_say() {
    for name in SHOWN {
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("{name}.rs"));
        let text = fs::read_to_string(&source).expect("the example is there");
        let head = head(&text);
        assert!(!head.is_empty(), "{name} does not show what it prints");
        assert_eq!(
            printed(name, &source),
            head,
            "{name} prints something else than its head says"
        );
    }
}

#[test]
fn the_chapter_names_every_example() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(folder.join("../docs/programs.md")).expect("it is there");
    for entry in fs::read_dir(folder).expect("the examples are there") {
        let path = entry.expect("it can be listed").path();
        if path.extension().is_some_and(|extension| extension == "rs") {
            let name = path.file_stem().expect("it has a name").to_string_lossy();
            assert!(text.contains(&format!("`{name}`")), "the chapter does not name {name}");
            let end = format!("? | `{name}` |");
            let answers = text.lines().any(|line| line.ends_with(&end));
            assert_eq!(
                answers,
                SHOWN.contains(&&*name),
                "{name}: the chapter's questions are those of the heads"
            );
        }
    }
}
