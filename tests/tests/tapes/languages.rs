//! The solvers of the library in JavaScript and in Python against the tapes from which they are printed.
//!
//! Each mechanism is a module in a folder, with a driver that reads arguments and writes results as doubles.

use std::fs;
use std::path::PathBuf;
use std::process::{self, Command};
use std::sync::atomic::{AtomicUsize, Ordering};

use kin_core::tape::structure::{Function, TapeNode};
use kin_core::tape::{self, Options, Tape};
use kin_tests::calls::Call;
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};

use crate::poses::{INPUTS, Wanted, poses};

/// Whether this build rounds a product and a sum once, which no other language does.
const FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));

/// A language with its tool.
#[derive(Clone, Copy)]
pub(crate) enum Language {
    JavaScript,
    Python,
}

/// The comparison of every mechanism in one language.
pub(crate) struct Compared {
    language: Language,
    folder: PathBuf,
    mechanisms: usize,
    found: usize,
    refused: usize,
    /// The largest difference where functions of the platform take part, in parts of the largest number of the pose.
    platform: f64,
    wrong: Vec<String>,
}

impl Compared {
    pub(crate) fn new(language: Language) -> Self {
        // Tests of one process run at the same time.
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let folder = std::env::temp_dir().join(format!("kin-languages-{}-{}-{count}", language as u8, process::id()));
        fs::create_dir_all(&folder).expect("there is room for a folder");
        Self {
            language,
            folder,
            mechanisms: 0,
            found: 0,
            refused: 0,
            platform: 0.0,
            wrong: Vec::new(),
        }
    }

    /// The rows that the module finds: the index of the check that failed, or -1, its margin, and the results.
    fn rows(&self, tape: &Tape, rows: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let bytes: Vec<u8> = rows.iter().flatten().flat_map(|number| number.to_le_bytes()).collect();
        fs::write(self.folder.join("in"), bytes).unwrap();
        let (tool, module, driver) = match self.language {
            Language::JavaScript => (
                "node",
                ("mechanism.mjs", tape.java_script()),
                ("main.mjs", java_script(tape)),
            ),
            Language::Python => ("python3", ("mechanism.py", tape.python()), ("main.py", python(tape))),
        };
        fs::write(self.folder.join(module.0), module.1).unwrap();
        fs::write(self.folder.join(driver.0), driver.1).unwrap();
        let output = Command::new(tool)
            .args([driver.0])
            .env("PYTHONDONTWRITEBYTECODE", "1")
            .current_dir(&self.folder)
            .output()
            .unwrap_or_else(|error| panic!("{tool} cannot be run: {error}"));
        let errors = String::from_utf8_lossy(&output.stderr);
        let name = tape.description.name;
        assert!(output.status.success() && errors.is_empty(), "{name}: {errors}");
        let bytes = fs::read(self.folder.join("out")).unwrap();
        let numbers: Vec<f64> = bytes
            .as_chunks::<8>()
            .0
            .iter()
            .map(|bytes| f64::from_le_bytes(*bytes))
            .collect();
        numbers.chunks(2 + tape.results.len()).map(Vec::from).collect()
    }

    pub(crate) fn compare(&mut self, tape: &Tape, given: &[Vec<f64>]) {
        let name = tape.description.name;
        let found = self.rows(tape, given);
        assert_eq!(found.len(), given.len(), "{name}");
        let is_exact = !tape.nodes.iter().any(is_of_the_platform);
        self.mechanisms += 1;
        for (given, found) in given.iter().zip(&found) {
            match tape.run(given) {
                Ok(expected) => {
                    self.found += 1;
                    let same = expected
                        .iter()
                        .zip(&found[2..])
                        .all(|(one, other)| one.to_bits() == other.to_bits());
                    let largest = expected
                        .iter()
                        .fold(1.0, |largest: f64, number| largest.max(number.abs()));
                    let differences: Vec<f64> = expected
                        .iter()
                        .zip(&found[2..])
                        .map(|(one, other)| (one - other).abs() / largest)
                        .collect();
                    let is_close = differences.iter().all(|difference| *difference <= 1e-9);
                    if found[0] != -1.0 || is_exact && !same || !is_close {
                        self.wrong.push(format!("{name} {given:?}: {expected:?} {found:?}"));
                    }
                    if !is_exact {
                        self.platform = differences.into_iter().fold(self.platform, f64::max);
                    }
                }
                Err(stop) => {
                    self.refused += 1;
                    let check = tape
                        .checks
                        .iter()
                        .position(|check| (check.name, check.block) == (stop.name, stop.block));
                    if check.and_then(|check| u32::try_from(check).ok()).map(f64::from) != Some(found[0]) {
                        self.wrong.push(format!("{name} {given:?}: {stop} {found:?}"));
                    }
                    let is_margin = tape.checks[stop.check].margin.is_some();
                    if is_exact && is_margin && stop.margin.to_bits() != found[1].to_bits() && !stop.margin.is_nan() {
                        self.wrong.push(format!("{name} {given:?}: {stop} {found:?}"));
                    }
                }
            }
        }
    }

    /// Tells what was compared, and asserts that nothing was wrong with at least so many mechanisms.
    pub(crate) fn finish(self, mechanisms: usize) {
        let _ = fs::remove_dir_all(&self.folder);
        println!(
            "{} mechanisms, {} poses, {} refused, platform {:e}",
            self.mechanisms, self.found, self.refused, self.platform
        );
        let wrong = &self.wrong;
        assert!(
            wrong.is_empty(),
            "{} wrong: {:#?}",
            wrong.len(),
            &wrong[..wrong.len().min(6)]
        );
        assert!(self.mechanisms >= mechanisms && self.found > 27 * mechanisms && self.refused > 10 * mechanisms);
    }
}

/// Whether a function of the platform finds the node.
fn is_of_the_platform(node: &TapeNode) -> bool {
    use Function::{Cosine, Magnitude, Negate, Raise, Round, Sine, SquareRoot};
    match node {
        TapeNode::Call(function, _) => !matches!(
            function,
            Cosine | Magnitude | Negate | Raise | Round | Sine | SquareRoot
        ),
        _ => false,
    }
}

/// The call of `solve`.
fn call(tape: &Tape) -> String {
    let Call {
        parameters,
        inputs,
        assembly,
    } = Call::new(tape, |place| format!("a[{place}]"));
    format!("solve({parameters}, {inputs}, {assembly})")
}

fn java_script(tape: &Tape) -> String {
    let (width, results) = (tape.arguments.len(), tape.results.len());
    let call = call(tape);
    format!(
        "import {{ readFileSync, writeFileSync }} from \"node:fs\";
import {{ CHECKS, solve }} from \"./mechanism.mjs\";

const bytes = readFileSync(\"in\");
const found = [];
for (let start = 0; start < bytes.length; start += 8 * {width}) {{
  const a = Array.from({{ length: {width} }}, (_, index) => bytes.readDoubleLE(start + 8 * index));
  const {{ ok, pose, check, block, margin }} = {call};
  if (ok) {{
    found.push(-1, NaN, ...Object.values(pose).flat(2));
  }} else {{
    const index = CHECKS.findIndex((own) => own.check === check && own.block === block);
    found.push(index, margin, ...new Array({results}).fill(NaN));
  }}
}}
const out = Buffer.alloc(8 * found.length);
found.forEach((number, index) => out.writeDoubleLE(number, 8 * index));
writeFileSync(\"out\", out);
"
    )
}

fn python(tape: &Tape) -> String {
    let width = tape.arguments.len();
    let call = call(tape);
    format!(
        "import dataclasses

import numpy as np
from mechanism import CHECKS, solve

a = np.fromfile(\"in\", dtype=\"<f8\").reshape(-1, {width}).T
# A plane of poses, to see that shapes are kept.
a = a.reshape({width}, 2, -1)
pose = {call}
first = np.array([CHECKS.index(CHECKS[check]) if check >= 0 else -1 for check in pose.check.ravel()])
rows = [first.reshape(pose.check.shape), pose.margin]
for field in dataclasses.fields(pose)[3:]:
    values = np.asarray(getattr(pose, field.name))
    # the joints of the skeleton have a row for each coordinate
    rows.extend(values.reshape(-1, *pose.check.shape) if values.size else [])
assert np.array_equal(pose.reached, pose.check < 0)
np.array(rows).reshape(len(rows), -1).T.astype(\"<f8\").tofile(\"out\")
"
    )
}

impl Visitor for Compared {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let tape =
            tape::record::<M>(&Options::new().with_skeleton()).expect("every mechanism of the library is recorded");
        let given: Vec<Vec<f64>> = poses::<M>(case, INPUTS).iter().map(Wanted::arguments).collect();
        self.compare(&tape, &given);
    }
}

fn compare(language: Language) {
    if FUSED {
        println!("this build rounds products and sums once, and no other language does");
        return;
    }
    let mut compared = Compared::new(language);
    cases::some_of_the_library(&mut compared);
    cases::ranges(&mut compared);
    compared.finish(if cfg!(feature = "every-case") { 37 + 10 } else { 14 + 10 });
}

/// JavaScript finds the numbers of the tape to the last bit, in and out of reach.
#[test]
#[ignore = "node"]
fn java_script_is_the_tape() {
    compare(Language::JavaScript);
}

/// So does NumPy, on whole arrays.
#[test]
#[ignore = "numpy"]
fn numpy_is_the_tape() {
    compare(Language::Python);
}
