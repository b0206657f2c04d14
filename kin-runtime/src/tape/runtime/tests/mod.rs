//! The run time beside the functions of this crate, to the last bit.
//!
//! Each language reads cases from a file as doubles and writes its results to another one.

mod cases;
mod compared;
mod single;

use std::fs;
use std::path::PathBuf;
use std::process::{self, Command};
use std::string::String;
use std::vec::Vec;

use super::RuntimeParts;

/// All parts, for blocks of up to four unknowns.
const ALL: RuntimeParts = RuntimeParts {
    sine_cosine: true,
    arc_tangent: true,
    factors: true,
    newton: true,
    unknowns: 4,
};

/// A folder for one test, which is removed in the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(std::format!("kin-runtime-{name}-{}", process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        fs::write(self.0.join(name), bytes).unwrap();
    }

    /// Runs a program in the folder, which must succeed without a word on the error output.
    fn run(&self, program: &str, arguments: &[&str]) -> String {
        let output = Command::new(program)
            .args(arguments)
            .current_dir(&self.0)
            .output()
            .unwrap_or_else(|error| panic!("{program} cannot be run: {error}"));
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(
            output.status.success() && errors.is_empty(),
            "{program} {arguments:?}: {errors}"
        );
        String::from_utf8_lossy(&output.stdout).into_owned()
    }

    fn write_numbers(&self, name: &str, numbers: &[f64]) {
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        self.write(name, bytes);
    }

    fn numbers(&self, name: &str) -> Vec<f64> {
        let bytes = fs::read(self.0.join(name)).unwrap();
        let (numbers, rest) = bytes.as_chunks::<8>();
        assert!(rest.is_empty());
        numbers.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The warnings that the C code must not cause.
const WARNINGS: [&str; 9] = [
    "-std=c99",
    "-O2",
    "-ffp-contract=off",
    "-Wall",
    "-Wextra",
    "-Wconversion",
    "-Wpedantic",
    "-Wdouble-promotion",
    "-Werror",
];
