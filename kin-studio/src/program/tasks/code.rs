//! `kin code`: the solver in other languages.

use std::fmt::Write as _;
use std::path::Path;

use kin_core::tape::Options;

use super::super::command::Code;
use super::super::progress::watched;
use super::print;
use crate::case::Typed;
use crate::case::fault::Fault;
use crate::case::file::Settings;
use crate::case::language::{self, EXAMPLE, Language};
use crate::case::subject::Subject;

pub(super) fn run(subject: &Subject, code: &Code, settings: &Settings) -> Result<(), Fault> {
    let mut options = Options::new();
    if let Some(order) = code.order {
        options = options.up_to(order);
    }
    if code.skeleton {
        options = options.with_skeleton();
    }
    if code.constants || !code.set.is_empty() {
        let typed = Typed {
            set: settings.set.iter().chain(&code.set).cloned().collect(),
            ..Typed::default()
        };
        options = options.with_dimensions(&typed.dimensions(subject)?);
    }
    let tape = watched("recording", 1, |_| subject.tape(&options)).map_err(Fault::wrong)?;
    let c = tape.c();
    if code.language == Language::C {
        spare(&code.output.join(EXAMPLE), &c.example, subject.description().name)?;
    }
    let files = language::files(&tape, code.language);
    let refused = |error: std::io::Error| Fault::wrong(format!("{} cannot be written: {error}", code.output.display()));
    std::fs::create_dir_all(&code.output).map_err(refused)?;
    let mut out = String::new();
    for (file, text) in files {
        let path = code.output.join(&file);
        std::fs::write(&path, &text).map_err(refused)?;
        let _ = writeln!(out, "{}: {} bytes", path.display(), text.len());
    }
    if code.language == Language::C {
        let (folder, name) = (code.output.display(), c.name);
        let _ = writeln!(
            out,
            "build it by: cc -O2 -std=c99 -ffp-contract=off {folder}/{EXAMPLE} {folder}/{name}.c -lm -o {folder}/{name}"
        );
    }
    print(&out)
}

/// Refuses to replace a file that is no example. All examples begin alike, up to the name of the mechanism.
fn spare(path: &Path, example: &str, mechanism: &str) -> Result<(), Fault> {
    let head = example.split(mechanism).next().unwrap_or(example).trim_end();
    match std::fs::read(path) {
        Ok(content) if !content.starts_with(head.as_bytes()) => Err(Fault::wrong(format!(
            "{} is there already and was not written by kin: give another folder by `--output FOLDER`",
            path.display()
        ))),
        // a file that cannot be read for another reason cannot be written either, which then is the error
        _ => Ok(()),
    }
}
