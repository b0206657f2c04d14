//! Kin's solvers in other languages, as contenders.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use kin_core::tape::Tape;
use kin_tests::calls::{Call, kernel};

use crate::environment::{Environment, build};
use crate::race::Race;

/// Whether this build rounds a product and a sum once, which no other language does.
pub(crate) const FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));

/// A solver in every language, in a folder.
pub(crate) struct Written {
    /// The bytes of header and source in C, of the module in JavaScript, and of that in Python.
    pub(crate) bytes: [usize; 3],
    arguments: usize,
    results: usize,
    name: String,
}

impl Written {
    /// Writes a tape into a folder, with the rows of arguments.
    pub(crate) fn new(tape: &Tape, folder: &Path, rows: &[Vec<f64>]) -> Self {
        let (c, java_script, python) = (tape.c(), tape.java_script(), tape.python());
        let call = Call::new(tape, |place| format!("a[{place}]"));
        let Call {
            parameters,
            inputs,
            assembly,
        } = &call;
        let call_in_java_script = format!(
            "export {{ solve }} from \"./mechanism.mjs\";\nexport const given = (a) => [{parameters}, {inputs}, \
                {assembly}];\n"
        );
        let mut call_in_python =
            String::from("import dataclasses\n\nimport numpy as np\n\nfrom mechanism import solve\n\n\n");
        write!(
            call_in_python,
            "def solver(_, a):\n    def rows(a):\n        pose = solve({parameters}, {inputs}, {assembly})\n        \
             return np.concatenate([getattr(pose, field.name) for field in dataclasses.fields(pose)[3:]])\n\n    \
             return rows\n"
        )
        .expect("a string can be written");
        fs::create_dir_all(folder).expect("cargo's folder can be written");
        let numbers: Vec<u8> = rows.iter().flatten().flat_map(|number| number.to_le_bytes()).collect();
        fs::write(folder.join("in"), numbers).expect("cargo's folder can be written");
        let (header, source) = (format!("{}.h", c.name), format!("{}.c", c.name));
        for (file, text) in [
            (header.as_str(), &c.header),
            (&source, &c.source),
            ("kernel.c", &kernel(tape)),
            ("mechanism.mjs", &java_script),
            ("call.mjs", &call_in_java_script),
            ("mechanism.py", &python),
            ("call.py", &call_in_python),
        ] {
            fs::write(folder.join(file), text).expect("cargo's folder can be written");
        }
        Self {
            bytes: [c.header.len() + c.source.len(), java_script.len(), python.len()],
            arguments: tape.arguments.len(),
            results: tape.results.len(),
            name: c.name,
        }
    }

    /// Enters the code of C, built with these flags, and returns what it finds.
    pub(crate) fn enter_c(
        &self,
        race: &mut Race<'_>,
        name: &str,
        folder: &Path,
        rows: usize,
        flags: &[&str],
    ) -> Vec<f64> {
        let source = format!("{}.c", self.name);
        let shape = [rows, self.arguments, self.results];
        build(folder, &["kernel.c", &source], flags, shape, name);
        race.enter_program(name, folder, &mut Command::new(folder.join(name)))
    }

    /// Enters the module of JavaScript.
    pub(crate) fn enter_java_script(&self, race: &mut Race<'_>, name: &str, folder: &Path) -> Vec<f64> {
        let program = folder.join("turns.mjs");
        fs::copy(Environment::program("turns.mjs"), &program).expect("cargo's folder can be written");
        let mut command = Command::new("node");
        command.arg(program).arg(self.arguments.to_string());
        race.enter_program(name, folder, &mut command)
    }

    /// Enters the module of Python.
    pub(crate) fn enter_python(
        &self,
        race: &mut Race<'_>,
        name: &str,
        folder: &Path,
        environment: &Environment,
    ) -> Vec<f64> {
        let mut command = environment.python();
        command.arg(Environment::program("turns.py")).args(["call", &self.name]);
        race.enter_program(name, folder, command.arg(self.arguments.to_string()))
    }
}

/// Asserts that a contender has found the numbers of `solve` to the last bit.
pub(crate) fn assert_equal(name: &str, own: &[f64], solved: &[f64]) {
    assert_eq!(own.len(), solved.len(), "{name}");
    for (place, (one, other)) in own.iter().zip(solved).enumerate() {
        assert!(
            FUSED || one.to_bits() == other.to_bits(),
            "{name}: {one} is not {other}, at {place}"
        );
    }
}
