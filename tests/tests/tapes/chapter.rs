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

/// A package whose build script is that of the chapter, with the line for the crate `cc`, links the solver in C to a
/// program in Rust.
#[test]
#[ignore = "gcc"]
fn the_build_script_with_gcc() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/languages.md");
    let chapter = fs::read_to_string(path).expect("the chapter is there");
    let (_, rest) = chapter.split_once("// build.rs\n").expect("there is a build script");
    let (script, _) = rest.split_once("```").expect("the block ends");
    let with_cc = script
        .replace("    // cc::Build", "    cc::Build")
        .replace("JansenLeg", "FourBar");
    assert_ne!(with_cc, script);
    let core = Path::new(env!("CARGO_MANIFEST_DIR")).join("../kin-core");
    let manifest = format!(
        "[package]
name = \"firmware\"
version = \"0.0.0\"
edition = \"2024\"

[build-dependencies]
cc = \"1\"
kin-core = {{ path = {core:?}, features = [\"library\", \"tape\"] }}

[workspace]
"
    );
    let main = "#[repr(C)]
struct Outcome {
    code: i32,
    margin: f64,
}

unsafe extern \"C\" {
    fn four_bar_solve(
        linkage: *const [f64; 4], crank: *const [f64; 5], assembly: *const f64, pose: *mut [f64; 10],
    ) -> Outcome;
}

fn main() {
    let mut pose = [f64::NAN; 10];
    // SAFETY: the structures of the header hold so many doubles and nothing else.
    let outcome = unsafe { four_bar_solve(&[90.0, 30.0, 60.0, 45.0], &[1.0, -10.0, 2.0, -0.5, 0.3], &1.0, &mut pose) };
    println!(\"{} {} {pose:?}\", outcome.code, outcome.margin);
}
";
    let files = [("Cargo.toml", &*manifest), ("build.rs", &with_cc)];
    let folder = folder("script", &files);
    fs::create_dir_all(folder.join("src")).expect("the folder of temporary files can be written");
    fs::write(folder.join("src/main.rs"), main).expect("the folder of temporary files can be written");
    let told =
        output(
            Command::new(env!("CARGO"))
                .current_dir(&folder)
                .args(["run", "--quiet", "--target-dir", "target"]),
        );
    let wanted = four_bar().run(&[90.0, 30.0, 60.0, 45.0, 1.0, -10.0, 2.0, -0.5, 0.3, 1.0]);
    assert_eq!(told, format!("0 0 {:?}\n", wanted.expect("it closes")));
}
