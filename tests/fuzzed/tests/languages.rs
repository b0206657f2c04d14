//! The sample in C, JavaScript and NumPy: `KIN_COUNT=1000 cargo test -p kin-fuzzed --features languages --test
//! languages`.
#![allow(dead_code, missing_docs, reason = "nobody has written them")]

#[allow(unreachable_pub, reason = "the file is public in kin-tests")]
#[path = "../../src/calls.rs"]
mod calls;

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use kin_core::Row;
use kin_core::prelude::*;
use kin_core::tape::structure::{Condition, Function, TapeNode};
use kin_core::tape::{self, Options, RecordError, Tape};
use kin_core::verify::Random;
use kin_declarations::Sample;

use calls::{Call, kernel};

/// Poses of each mechanism.
const POSES: usize = 40;

/// Whether this build rounds a product and a sum once, which no other language does.
const FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));

/// The largest difference where functions of the platform take part: a few units of the last place, magnified by the
/// conditions of poses that nobody has chosen, as a part of the largest number of the pose.
const OF_THE_PLATFORM: f64 = 1e-6;

/// A mechanism of the sample.
struct Solved {
    tape: Tape,
    /// The arguments of each pose.
    rows: Vec<Vec<f64>>,
    /// What `solve` finds.
    found: Vec<Option<Vec<f64>>>,
}

/// Random poses of a mechanism, in reach and out of reach.
fn solved<M: Mechanism<Scalar = f64>>() -> Result<Solved, RecordError> {
    let tape = tape::record::<M>(&Options::new())?;
    let mut random = Random::new(6);
    let (mut rows, mut found) = (Vec::new(), Vec::new());
    for pose in 0..POSES {
        let mechanism = M::from_parameters(M::Parameters::from_fn(|_| random.between(0.3, 3.0)));
        let inputs = M::Inputs::from_fn(|_| M::Motion::from_fn(|_| random.between(-3.0, 3.0)));
        let mut row: Vec<f64> = mechanism.parameters().as_ref().to_vec();
        for motion in inputs.as_ref() {
            row.extend(motion.as_ref());
        }
        let own = if M::ASSEMBLY_COUNT == 0 {
            let near = M::Unknowns::from_fn(|_| random.between(-3.0, 3.0));
            row.extend(near.as_ref());
            let pose = mechanism.solve_near(inputs, near);
            // directions are angles near those of the guess
            let guess = |unknown: usize| near.as_ref()[unknown];
            pose.map(|pose| (pose.unknown_motions_near(Row::from_fn(guess)), pose.output_motions()))
        } else {
            let (number, choices) = (pose % M::ASSEMBLY_COUNT, M::ASSEMBLY_COUNT.trailing_zeros());
            let is_crossed = |choice: u32| number >> (choices - 1 - choice) & 1 == 1;
            row.extend((0..choices).map(|choice| if is_crossed(choice) { -1.0 } else { 1.0 }));
            let pose = mechanism.solve(inputs, M::assembly(number).expect("it is one of them"));
            pose.map(|pose| (pose.unknown_motions(), pose.output_motions()))
        };
        rows.push(row);
        found.push(own.ok().map(|(unknowns, outputs)| {
            let motions = unknowns.as_ref().iter().chain(outputs.as_ref());
            motions.flat_map(|motion| motion.as_ref().to_vec()).collect()
        }));
    }
    Ok(Solved { tape, rows, found })
}

macro_rules! of {
    ($mechanism:ident) => {
        super::solved::<$mechanism>()
    };
}

type Found = Result<Solved, RecordError>;
/// How it is found.
type Find = fn() -> Found;

include!(concat!(env!("OUT_DIR"), "/sample.rs"));

/// The mechanisms of the sample. Each of them has a tape.
fn mechanisms() -> Vec<Solved> {
    let recorded =
        |(solved, seed): &(Find, u64)| solved().unwrap_or_else(|error| panic!("{error}\n{}", Sample::new(*seed)));
    let all: Vec<Solved> = SAMPLE.iter().map(recorded).collect();
    println!("{} mechanisms", all.len());
    all
}

/// Whether a function of the platform finds the node.
fn is_of_the_platform(node: &TapeNode) -> bool {
    use Function::{Cosine, Magnitude, Negate, Raise, Round, Sine, SquareRoot};
    let is_own = |function: &Function| {
        matches!(
            function,
            Cosine | Magnitude | Negate | Raise | Round | Sine | SquareRoot
        )
    };
    matches!(node, TapeNode::Call(function, _) if !is_own(function))
}

/// A folder with the arguments of all mechanisms as doubles, one file for each.
struct Folder(PathBuf);

impl Folder {
    fn new(language: &str, mechanisms: &[Solved]) -> Self {
        let own = Self(PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(language));
        fs::create_dir_all(&own.0).expect("the folder of temporary files can be written");
        for (place, mechanism) in mechanisms.iter().enumerate() {
            let numbers: Vec<u8> = mechanism
                .rows
                .iter()
                .flatten()
                .flat_map(|own| own.to_le_bytes())
                .collect();
            own.write(&format!("in{place}"), numbers);
        }
        own
    }

    fn write(&self, file: &str, text: impl AsRef<[u8]>) {
        fs::write(self.0.join(file), text).expect("the folder of temporary files can be written");
    }

    /// Runs a command, which must succeed without a word of complaint.
    fn run(&self, program: &str, words: &[&str]) {
        let output = Command::new(program)
            .args(words)
            .current_dir(&self.0)
            .output()
            .unwrap_or_else(|error| panic!("{program} cannot be run: {error}"));
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(
            output.status.success() && errors.is_empty(),
            "{program}: {}",
            errors.chars().take(3000).collect::<String>()
        );
    }

    /// Compares what a program has written for each mechanism: for each pose 0, or the number of the check that failed
    /// from 1 on, then the results.
    fn compare(&self, mechanisms: &[Solved]) {
        let (mut found, mut refused) = (0, 0);
        for (place, mechanism) in mechanisms.iter().enumerate() {
            let Solved { tape, rows, .. } = mechanism;
            let name = tape.description.name;
            let bytes = fs::read(self.0.join(format!("out{place}"))).expect("the program has written it");
            let numbers: Vec<f64> = bytes
                .as_chunks::<8>()
                .0
                .iter()
                .map(|own| f64::from_le_bytes(*own))
                .collect();
            let width = 1 + tape.results.len();
            assert_eq!(numbers.len(), POSES * width, "{name}");
            let is_exact = !tape.nodes.iter().any(is_of_the_platform);
            for ((row, numbers), own) in rows.iter().zip(numbers.chunks(width)).zip(&mechanism.found) {
                match (tape.run(row), own) {
                    (Ok(of_tape), Some(own)) => {
                        found += 1;
                        assert_eq!(numbers[0], 0.0, "{name} at {row:?}");
                        let largest = own.iter().fold(1.0, |largest: f64, number| largest.max(number.abs()));
                        for ((one, other), third) in own.iter().zip(&of_tape).zip(&numbers[1..]) {
                            assert_eq!(one.to_bits(), other.to_bits(), "{name} at {row:?}");
                            let is_close = (one - third).abs() <= OF_THE_PLATFORM * largest;
                            assert!(
                                one.to_bits() == third.to_bits() || !is_exact && is_close,
                                "{name} at {row:?}: {one} is not {third}"
                            );
                        }
                    }
                    (Err(stop), None) => {
                        refused += 1;
                        let is_search = matches!(tape.checks[stop.check].condition, Condition::Found(_));
                        let code = u32::try_from(stop.check).map_or(-1.0, |check| f64::from(check + 1));
                        assert!(
                            numbers[0] == code || is_search && numbers[0] > 0.0,
                            "{name} at {row:?}: {stop}"
                        );
                    }
                    (of_tape, own) => panic!("{name} at {row:?}: {of_tape:?} {own:?}"),
                }
            }
        }
        println!("{found} poses, {refused} out of reach");
        assert!(found > mechanisms.len() && refused > mechanisms.len());
    }
}

#[test]
fn mechanisms_in_c() {
    if FUSED {
        return;
    }
    let mechanisms = mechanisms();
    let folder = Folder::new("c", &mechanisms);
    let (mut table, mut files) = (String::new(), vec!["main.c".to_owned()]);
    for (place, mechanism) in mechanisms.iter().enumerate() {
        let c = mechanism.tape.c();
        let kernel = kernel(&mechanism.tape).replace("kernel", &format!("kernel{place}"));
        folder.write(&format!("{}.h", c.name), &c.header);
        folder.write(&format!("{}.c", c.name), &c.source);
        folder.write(&format!("kernel{place}.c"), kernel);
        files.extend([format!("{}.c", c.name), format!("kernel{place}.c")]);
        let (arguments, results) = (mechanism.tape.arguments.len(), mechanism.tape.results.len());
        writeln!(table, "CASE({place}, {arguments}, {results})").expect("a string can be written");
    }
    folder.write(
        "main.c",
        format!(
            "#include <stdio.h>
#define CASE(place, arguments, results) int kernel##place(const double *in, double *out);
{table}#undef CASE
static int solve(const char *from, const char *to, size_t arguments, size_t results,
    int (*kernel)(const double *, double *))
{{
    static double in[1000], out[1000];
    FILE *const given = fopen(from, \"rb\"), *const found = fopen(to, \"wb\");
    if (!given || !found) {{ return 1; }}
    for (int pose = 0; pose < {POSES}; pose++) {{
        if (fread(in, sizeof(double), arguments, given) != arguments) {{ return 1; }}
        const double code = kernel(in, out);
        fwrite(&code, sizeof code, 1, found);
        fwrite(out, sizeof(double), results, found);
    }}
    return fclose(found) | fclose(given);
}}
int main(void)
{{
    int code = 0;
#define CASE(place, arguments, results) code |= solve(\"in\" #place, \"out\" #place, arguments, results, kernel##place);
{table}    return code;
}}
"
        ),
    );
    let flags = "-std=c99 -O1 -ffp-contract=off -Wall -Wextra -Wconversion -Wpedantic -Werror".split(' ');
    let mut words: Vec<&str> = flags.collect();
    words.extend(files.iter().map(String::as_str));
    words.extend(["-lm", "-o", "main"]);
    folder.run("gcc", &words);
    folder.run("./main", &[]);
    folder.compare(&mechanisms);
}

#[test]
fn mechanisms_in_java_script() {
    if FUSED {
        return;
    }
    let mechanisms = mechanisms();
    let folder = Folder::new("javascript", &mechanisms);
    let mut main = String::from("import { readFileSync, writeFileSync } from \"node:fs\";\n");
    for (place, mechanism) in mechanisms.iter().enumerate() {
        let tape = &mechanism.tape;
        folder.write(&format!("mechanism{place}.mjs"), tape.java_script());
        let Call {
            parameters,
            inputs,
            assembly,
        } = Call::new(tape, |place| format!("a[{place}]"));
        let (width, results) = (tape.arguments.len(), tape.results.len());
        write!(
            main,
            "{{
  const {{ CHECKS, solve }} = await import(\"./mechanism{place}.mjs\");
  const bytes = readFileSync(\"in{place}\");
  const found = [];
  for (let start = 0; start < bytes.length; start += 8 * {width}) {{
    const a = Array.from({{ length: {width} }}, (_, index) => bytes.readDoubleLE(start + 8 * index));
    const {{ ok, pose, check, block }} = solve({parameters}, {inputs}, {assembly});
    if (ok) {{
      found.push(0, ...Object.values(pose).flat());
    }} else {{
      const code = 1 + CHECKS.findIndex((own) => own.check === check && own.block === block);
      found.push(code, ...new Array({results}).fill(NaN));
    }}
  }}
  const out = Buffer.alloc(8 * found.length);
  found.forEach((number, index) => out.writeDoubleLE(number, 8 * index));
  writeFileSync(\"out{place}\", out);
}}
"
        )
        .expect("a string can be written");
    }
    folder.write("main.mjs", main);
    folder.run("node", &["main.mjs"]);
    folder.compare(&mechanisms);
}

#[test]
fn mechanisms_in_numpy() {
    if FUSED {
        return;
    }
    let mechanisms = mechanisms();
    let folder = Folder::new("numpy", &mechanisms);
    let mut main = String::from("import dataclasses\nimport importlib\n\nimport numpy as np\n\n");
    for (place, mechanism) in mechanisms.iter().enumerate() {
        let tape = &mechanism.tape;
        folder.write(&format!("mechanism{place}.py"), tape.python());
        let Call {
            parameters,
            inputs,
            assembly,
        } = Call::new(tape, |place| format!("a[{place}]"));
        let width = tape.arguments.len();
        write!(
            main,
            "module = importlib.import_module(\"mechanism{place}\")
a = np.fromfile(\"in{place}\", dtype=\"<f8\").reshape(-1, {width}).T
pose = module.solve({parameters}, {inputs}, {assembly})
rows = [[pose.check + 1.0]] + [getattr(pose, field.name) for field in dataclasses.fields(pose)[3:]]
np.concatenate(rows).T.astype(\"<f8\").tofile(\"out{place}\")
"
        )
        .expect("a string can be written");
    }
    folder.write("main.py", main);
    folder.run("python3", &["-B", "main.py"]);
    folder.compare(&mechanisms);
}
