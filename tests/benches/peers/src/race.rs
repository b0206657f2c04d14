//! Contenders that take turns, in this process and in others.

use std::fs;
use std::hint::black_box;
use std::io::{BufRead as _, BufReader, Write as _};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::Instant;

/// How often a contender solves all rows in a turn. The shortest pass counts, as the first ones find cold caches.
const PASSES: usize = 10;

/// The turn of a contender: the nanoseconds for all rows.
type Turn<'a> = Box<dyn FnMut() -> f64 + 'a>;

/// Contenders that solve the same rows.
pub(crate) struct Race<'a> {
    rows: usize,
    turns: usize,
    contenders: Vec<(String, Turn<'a>)>,
}

impl<'a> Race<'a> {
    /// A race over so many rows, in which each contender has so many turns.
    pub(crate) fn new(rows: usize, turns: usize) -> Self {
        Self {
            rows,
            turns,
            contenders: Vec::new(),
        }
    }

    /// Enters a function of this program that solves all rows.
    pub(crate) fn enter(&mut self, name: &str, mut solve_all: impl FnMut() + 'a) {
        self.contenders
            .push((name.to_owned(), Box::new(move || turn(&mut solve_all))));
    }

    /// Enters a function of this program that solves one row.
    pub(crate) fn enter_each<I: 'a, R>(&mut self, name: &str, rows: Vec<I>, solve: impl Fn(&I) -> R + 'a) {
        assert_eq!(rows.len(), self.rows);
        self.enter(name, move || solve_each(&rows, &solve));
    }

    /// Enters another program, and returns the numbers that it has found. It writes them to the file that its last
    /// argument names.
    pub(crate) fn enter_program(&mut self, name: &str, folder: &Path, command: &mut Command) -> Vec<f64> {
        let file = format!("{name}.out");
        let child = command
            .current_dir(folder)
            .arg(&file)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap_or_else(|error| panic!("{command:?} cannot be run: {error}"));
        let mut program = Program::new(child);
        assert_eq!(program.line(), "ready", "{name}");
        let bytes = fs::read(folder.join(file)).expect("it has written what it found");
        let turn = move || {
            program.ask();
            program.line().parse().expect("it answers with a number")
        };
        self.contenders.push((name.to_owned(), Box::new(turn)));
        let numbers = bytes.as_chunks::<8>().0.iter();
        numbers.map(|bytes| f64::from_le_bytes(*bytes)).collect()
    }

    /// Runs it: the nanoseconds per row of each contender.
    pub(crate) fn run(mut self) -> Vec<(String, f64)> {
        let mut shortest = vec![f64::INFINITY; self.contenders.len()];
        for _ in 0..self.turns {
            for ((_, turn), shortest) in self.contenders.iter_mut().zip(&mut shortest) {
                *shortest = shortest.min(turn());
            }
        }
        #[allow(clippy::cast_precision_loss, reason = "there are thousands")]
        let rows = self.rows as f64;
        let names = self.contenders.into_iter().map(|(name, _)| name);
        names.zip(shortest).map(|(name, time)| (name, time / rows)).collect()
    }
}

/// The nanoseconds of a turn: the shortest of its passes.
pub(crate) fn turn(solve_all: impl FnMut()) -> f64 {
    shortest(PASSES, solve_all)
}

/// The nanoseconds of the shortest of several passes.
pub(crate) fn shortest(passes: usize, mut pass: impl FnMut()) -> f64 {
    let times = (0..passes).map(|_| {
        let start = Instant::now();
        pass();
        start.elapsed().as_secs_f64() * 1e9
    });
    times.fold(f64::INFINITY, f64::min)
}

/// Solves one row after the other.
pub(crate) fn solve_each<I, R>(rows: &[I], solve: impl Fn(&I) -> R) {
    for row in black_box(rows) {
        // by reference, as kernels in C take their rows: rows and results would be copied otherwise
        black_box(&solve(row));
    }
}

/// Another program, which is ended with this value.
struct Program {
    child: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
}

impl Program {
    fn new(mut child: Child) -> Self {
        let input = child.stdin.take();
        let output = BufReader::new(child.stdout.take().expect("it is piped"));
        Self { child, input, output }
    }

    fn ask(&mut self) {
        let input = self.input.as_mut().expect("it is piped");
        input.write_all(b"\n").and_then(|()| input.flush()).expect("it listens");
    }

    fn line(&mut self) -> String {
        let mut line = String::new();
        self.output.read_line(&mut line).expect("it answers");
        line.trim_end().to_owned()
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        // The end of its input ends it.
        drop(self.input.take());
        let _ = self.child.wait();
    }
}
