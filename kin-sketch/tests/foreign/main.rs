//! Files of other programs: they are read, declared and moved.
//!
//! `pylinkage/make.py` writes the files of pylinkage. Addresses of `pmks_plus/` are those of the templates of PMKS+,
//! the other files are written as the formats are documented.
#![allow(missing_docs, reason = "tests")]

mod compared;
mod kin_files;
mod mistakes;
mod moved;

use std::fs;
use std::path::PathBuf;

use kin_core::linkage::AnyLinkage;
use kin_live::Mechanism;
use kin_sketch::SketchDeclaration;
use kin_sketch::foreign::{Foreign, ForeignFormat, read};

/// A file with its name.
pub(crate) struct File {
    pub(crate) name: String,
    pub(crate) text: String,
}

impl File {
    pub(crate) fn foreign(&self) -> Foreign {
        read(&self.text).unwrap_or_else(|error| panic!("{}: {error}", self.name))
    }
}

pub(crate) fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/foreign")
}

/// The files of a folder, in order.
pub(crate) fn files(program: &str, ending: &str) -> Vec<File> {
    let entries = fs::read_dir(folder().join(program)).expect("the folder is there");
    let paths = entries.map(|entry| entry.expect("it can be read").path());
    let mut paths: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|found| found == ending))
        .collect();
    paths.sort();
    let file = |path: &PathBuf| File {
        name: path.file_stem().expect("it has a name").to_string_lossy().into_owned(),
        text: fs::read_to_string(path).expect("it can be read"),
    };
    paths.iter().map(file).collect()
}

pub(crate) fn all_files() -> Vec<File> {
    let folders = [
        ("pylinkage", "json"),
        ("pmks_plus", "txt"),
        ("pmks", "txt"),
        ("linkage", "linkage2"),
    ];
    folders
        .iter()
        .flat_map(|(program, ending)| files(program, ending))
        .collect()
}

pub(crate) fn declared(name: &str, foreign: &Foreign) -> SketchDeclaration {
    foreign.sketch.declaration().unwrap_or_else(|faults| {
        let faults: Vec<String> = faults.iter().map(ToString::to_string).collect();
        panic!("{name}: {faults:?}\n{foreign:#?}")
    })
}

pub(crate) fn mechanism(declaration: &SketchDeclaration) -> Mechanism {
    let text = &declaration.text;
    Mechanism::declare(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

pub(crate) fn linkage<'m>(mechanism: &'m Mechanism, declaration: &SketchDeclaration) -> AnyLinkage<'m> {
    let rows: Vec<(&str, f64)> = declaration
        .dimensions
        .iter()
        .map(|(name, value)| (&**name, *value))
        .collect();
    mechanism.linkage(&rows).expect("every dimension is measured")
}

pub(crate) fn values(values: &[(String, f64)]) -> Vec<f64> {
    values.iter().map(|(_, value)| *value).collect()
}

/// The unknowns after moving the first input in small steps; none where the links do not reach.
pub(crate) fn followed(
    linkage: &AnyLinkage<'_>,
    inputs: &mut [f64],
    unknowns: &mut Vec<f64>,
    by: f64,
    steps: usize,
) -> Result<(), String> {
    for _ in 0..steps {
        let choice = linkage.assembly_at(inputs, unknowns);
        #[expect(clippy::cast_precision_loss, reason = "it is small")]
        let step = by / steps as f64;
        inputs[0] += step;
        *unknowns = linkage
            .position(inputs, choice.position())
            .map_err(|error| error.to_string())?;
    }
    Ok(())
}

#[test]
fn there_are_files_of_each_program() {
    use ForeignFormat::{Linkage, Pmks, PmksPlus, Pylinkage};
    let count = |format| {
        all_files()
            .iter()
            .filter(|file| file.foreign().format == format)
            .count()
    };
    assert_eq!([Pylinkage, PmksPlus, Pmks, Linkage].map(count), [13, 12, 5, 7]);
}
