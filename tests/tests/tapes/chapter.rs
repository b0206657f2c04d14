//! The programs of the chapter on other languages, run beside the code that kin writes.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use kin_core::library::FourBar;
use kin_core::tape::{self, Options, Tape};

/// The first block of a language in the chapter, and the output that the chapter shows behind it.
fn program(language: &str) -> (String, String) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/languages.md");
    let chapter = fs::read_to_string(path).expect("the chapter is there");
    let (_, rest) = chapter
        .split_once(&format!("```{language}\n"))
        .expect("there is a program in this language");
    let (program, rest) = rest.split_once("```\n").expect("the block ends");
    let output = rest
        .strip_prefix("\n```text\n")
        .and_then(|rest| rest.split_once("```\n"))
        .map_or("", |(output, _)| output);
    (program.to_owned(), output.to_owned())
}

fn four_bar() -> Tape {
    tape::record::<FourBar>(&Options::new()).expect("it is recorded")
}

fn folder(name: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("chapter").join(name);
    fs::create_dir_all(&folder).expect("the folder of temporary files can be written");
    for (file, text) in files {
        fs::write(folder.join(file), text).expect("the folder of temporary files can be written");
    }
    folder
}

/// The output of a program that must succeed without a word of complaint.
fn output(command: &mut Command) -> String {
    let output = command
        .output()
        .unwrap_or_else(|error| panic!("{command:?} cannot be run: {error}"));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && errors.is_empty(), "{command:?}: {errors}");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
#[ignore = "gcc"]
fn the_control_loop_by_gcc() {
    let (program, shown) = program("c");
    let c = four_bar().c();
    let files = [
        ("four_bar.h", &*c.header),
        ("four_bar.c", &c.source),
        ("main.c", &program),
    ];
    let folder = folder("c", &files);
    let strict = [
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Wpedantic",
        "-Werror",
        "-O2",
        "-ffp-contract=off",
    ];
    output(Command::new("gcc").current_dir(&folder).args(strict).args([
        "main.c",
        "four_bar.c",
        "-lm",
        "-o",
        "four_bar",
    ]));
    assert_eq!(output(&mut Command::new(folder.join("four_bar"))), shown);
}

/// The script of the page draws through a stand-in for the document, which prints the number of points.
#[test]
#[ignore = "node"]
fn the_page_by_node() {
    let (page, _) = program("html");
    let (_, script) = page.split_once("<script type=\"module\">").expect("there is a script");
    let (script, _) = script.split_once("</script>").expect("the script ends");
    let document = "globalThis.document = { querySelector: () => ({ setAttribute: (_, points) => \
                    console.log(points.split(\" \").length) }) };\n";
    let module = four_bar().java_script();
    let folder = folder(
        "javascript",
        &[("four_bar.mjs", &*module), ("page.mjs", &format!("{document}{script}"))],
    );
    let told = output(Command::new("node").current_dir(&folder).arg("page.mjs"));
    // the crank turns fully
    assert_eq!(told, "361\n");
}

#[test]
#[ignore = "numpy"]
fn the_notebook_by_python() {
    let (program, shown) = program("python");
    let module = four_bar().python();
    let folder = folder("python", &[("four_bar.py", &*module), ("cell.py", &program)]);
    let told = output(
        Command::new("python3")
            .current_dir(&folder)
            .env("PYTHONDONTWRITEBYTECODE", "1")
            .arg("cell.py"),
    );
    assert_eq!(told, shown);
}
