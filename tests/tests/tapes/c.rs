//! Solvers in C, compiled and run.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use kin_core::tape::structure::{Condition, ResultOf, Role};
use kin_core::tape::{self, C, Options, Tape};
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};
use kin_tests::reference::{Errors, Given};

use crate::poses::{INPUTS, Wanted, poses};

/// What every file must pass.
const STRICT: [&str; 9] = [
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

/// The levels of optimisation besides that of [`STRICT`].
const LEVELS: [&str; 2] = ["-O3", "-Os"];

/// Builds the example with more warnings, and returns the program.
fn built(c: &C, folder: &str, more: &[&str]) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("c").join(folder);
    fs::create_dir_all(&folder).expect("the folder of temporary files can be written");
    let (header, source) = (format!("{}.h", c.name), format!("{}.c", c.name));
    for (file, text) in [
        (&header, &c.header),
        (&source, &c.source),
        (&"main.c".to_owned(), &c.example),
    ] {
        fs::write(folder.join(file), text).expect("the folder of temporary files can be written");
    }
    let program = folder.join(&c.name);
    let output = Command::new("gcc")
        .current_dir(&folder)
        .args(STRICT)
        .args(more)
        .args(["main.c", &source, "-lm", "-o"])
        .arg(&program)
        .output()
        .expect("gcc is installed");
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {told}", c.name);
    program
}

/// The lines that the program writes for these arguments.
fn answers(program: &Path, arguments: &[Vec<f64>]) -> Vec<String> {
    let mut child = Command::new(program)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program was built");
    let lines: String = arguments
        .iter()
        .map(|row| row.iter().map(|own| format!("{own:?}")).collect::<Vec<_>>().join(" ") + "\n")
        .collect();
    let mut input = child.stdin.take().expect("it is piped");
    let writer = std::thread::spawn(move || input.write_all(lines.as_bytes()));
    let output = child.wait_with_output().expect("the program ends");
    writer.join().expect("the writer ends").expect("the program reads all");
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).expect("it writes numbers");
    text.lines().map(str::to_owned).collect()
}

/// The numbers of a line, or the code and the margin.
fn read(line: &str) -> Result<Vec<f64>, (usize, f64)> {
    let number = |word: &str| word.parse::<f64>().expect("it is a number");
    if let Some((code, rest)) = line.split_once(": ") {
        let (_, margin) = rest.rsplit_once(' ').expect("the margin is the last word");
        return Err((code.parse().expect("it is a code"), number(margin)));
    }
    Ok(line.split(' ').skip(1).step_by(2).map(number).collect())
}

/// Whether the C code finds what the tape finds, to the last bit.
fn agrees(tape: &Tape, arguments: &[f64], line: &str) -> bool {
    let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
    match (tape.run(arguments), read(line)) {
        (Ok(found), Ok(own)) => bits(&found) == bits(&own),
        (Err(stop), Err((code, margin))) => {
            let is_told = matches!(tape.checks[stop.check].condition, Condition::Holds(_));
            let is_same = margin == stop.margin || (margin.is_nan() && stop.margin.is_nan());
            code == stop.check + 1 && (is_same || !is_told)
        }
        _ => false,
    }
}

/// The programs that differ, and how many poses were compared.
#[derive(Default)]
pub(crate) struct Compared {
    poses: usize,
    found: usize,
    bytes: usize,
    wrong: Vec<String>,
}

impl Visitor for Compared {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let tape = tape::record::<M>(&Options::new().with_skeleton()).expect("it is recorded");
        let arguments: Vec<Vec<f64>> = poses::<M>(case, INPUTS).iter().map(Wanted::arguments).collect();
        self.compare(&tape, &arguments);
    }
}

impl Compared {
    /// Compares the C code of a tape with the tape itself.
    pub(crate) fn compare(&mut self, tape: &Tape, arguments: &[Vec<f64>]) {
        let c = tape.c();
        self.bytes += c.source.len();
        let program = built(&c, "double", &[]);
        // other levels see other bounds of loops, of which straight-line code has none
        if !tape.systems.is_empty() || !tape.searches.is_empty() {
            for level in LEVELS {
                built(&c, level, &[level]);
            }
        }
        let lines = answers(&program, arguments);
        assert_eq!(lines.len(), arguments.len(), "{}", c.name);
        for (own, line) in arguments.iter().zip(&lines) {
            self.poses += 1;
            self.found += usize::from(read(line).is_ok());
            if !agrees(tape, own, line) {
                self.wrong
                    .push(format!("{}: {own:?} {:?} {line}", c.name, tape.run(own)));
            }
        }
    }
}

impl Compared {
    /// Tells what was compared, and asserts that nothing was wrong with more than so many poses that are found.
    pub(crate) fn finish(self, least: usize) {
        let Self {
            poses,
            found,
            bytes,
            wrong,
        } = self;
        println!("{poses} poses, {found} found, {bytes} bytes");
        assert!(
            wrong.is_empty(),
            "{} wrong: {:#?}",
            wrong.len(),
            &wrong[..wrong.len().min(9)]
        );
        assert!(found > least && poses - found > least / 4);
    }
}

/// The C code of every mechanism passes strict compilation, without a warning at the usual levels of optimisation, and
/// finds what `solve` finds to the last bit, in every assembly, with codes and margins where there is nothing to be
/// found.
#[test]
#[ignore = "gcc"]
fn c_by_gcc_is_the_solver() {
    let mut compared = Compared::default();
    cases::some_of_the_library(&mut compared);
    cases::ranges(&mut compared);
    compared.finish(if cfg!(feature = "every-case") { 20_000 } else { 1000 });
}

/// The C code in single precision, and its errors.
#[derive(Default)]
struct Single {
    found: usize,
    worst: f64,
    wrong: Vec<String>,
}

/// By how much a result in single precision may be wrong, in units of rounding times the condition.
const UNITS: f64 = 4.0;

impl Visitor for Single {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "the nearest number in single precision is meant"
    )]
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let tape = tape::record::<M::With<f32>>(&Options::new()).expect("it is recorded");
        let (c, floats) = (tape.c(), "-Wunsuffixed-float-constants");
        let program = built(&c, "single", &[floats]);
        if !tape.systems.is_empty() || !tape.searches.is_empty() {
            for level in LEVELS {
                built(&c, level, &[floats, level]);
            }
        }
        let rounded = |number: &f64| f64::from(*number as f32);
        let mut arguments: Vec<Vec<f64>> = poses::<M>(case, INPUTS.div_ceil(17))
            .iter()
            .map(Wanted::arguments)
            .collect();
        arguments.iter_mut().flatten().for_each(|own| *own = rounded(own));
        let mut errors = Errors::new::<M>();
        for (own, line) in arguments.iter().zip(answers(&program, &arguments)) {
            let Ok(results) = read(&line) else {
                continue;
            };
            let mut motions = vec![vec![f64::NAN; tape.order + 1]; M::DESCRIPTION.unknowns.len()];
            for (outcome, result) in tape.results.iter().zip(&results) {
                if let ResultOf::Unknown(unknown) = outcome.quantity {
                    motions[unknown][outcome.order] = *result;
                }
            }
            let mut given = Given {
                parameters: Vec::new(),
                inputs: vec![Vec::new(); M::DESCRIPTION.inputs.len()],
            };
            for (argument, number) in tape.arguments.iter().zip(own) {
                match argument.role {
                    Role::Parameter(_) => given.parameters.push(*number),
                    Role::Input { input, .. } => given.inputs[input].push(*number),
                    _ => {}
                }
            }
            // Where the reference strays, a singular position is near.
            if errors
                .hold::<M>(&given, &motions, f32::EPSILON.into(), "a random pose")
                .is_ok()
            {
                self.found += 1;
            }
        }
        self.worst = errors.worst.iter().copied().fold(self.worst, f64::max);
        if !errors.worst.iter().all(|worst| *worst <= UNITS) {
            self.wrong.push(errors.to_string());
        }
    }
}

/// The C code in single precision passes strict compilation, which refuses every number that becomes a `double`. What
/// it finds is as near to 50 digits as rounding allows.
#[test]
#[ignore = "gcc"]
fn c_by_gcc_in_single_precision() {
    let mut single = Single::default();
    cases::some_of_the_library(&mut single);
    cases::ranges(&mut single);
    println!(
        "{} poses, the worst error is {:.2} units of rounding times the condition",
        single.found, single.worst
    );
    assert!(
        single.wrong.is_empty(),
        "{} wrong: {}",
        single.wrong.len(),
        single.wrong.join("\n")
    );
    assert!(
        single.found > if cfg!(feature = "every-case") { 1000 } else { 50 },
        "{}",
        single.found
    );
}
