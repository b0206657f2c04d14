//! Random tapes in other languages, beside the tapes run by themselves.
//!
//! The tapes are made of every kind of node, of checks, searches and linear systems. Operands have no names, so
//! that every operator becomes an operand of every other one.

use std::boxed::Box;
use std::format;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::string::{String, ToString as _};
use std::vec;
use std::vec::Vec;

use crate::mechanism::Description;
use crate::number::elementary::FUSED;
use crate::picture::Outline;
use crate::quantity::Dimension;
use crate::tape::runtime::{self, RuntimeParts};
use crate::tape::structure::Tape;
use crate::tape::structure::TapeResult;
use crate::tape::{
    Argument, Comparison, Condition, Constant, Function, LinearSolution, NewtonSearch, NumberType, Operator, ResultOf,
    Role, System, TapeCheck, TapeNode, TapeStep, Value,
};
use crate::verify::Random;

const TAPES: u64 = 1000;
const ARGUMENTS: usize = 4;
const POSES: usize = 5;

/// The operations of a tape besides its blocks.
const OPERATIONS: usize = 60;

/// Names that need care: keywords, letters of other alphabets, and names that would be equal.
const NAMES: [&str; ARGUMENTS] = ["lambda", "θ", "theta", "this"];

/// A description that would end comments and strings.
const TEXT: &str = "ends */ here \"\"\" and \\\u{2028}there ??/\nwith a last \\";

const CONSTANTS: [f64; 8] = [0.0, -0.0, 0.1, -2.5, 5e-324, 1e300, f64::INFINITY, f64::NAN];

const EXACT: [Function; 5] = [
    Function::Negate,
    Function::Magnitude,
    Function::SquareRoot,
    Function::Round,
    Function::Raise,
];

/// The functions of each platform, which differ in the last bits.
const OF_THE_PLATFORM: [Function; 11] = [
    Function::ArcSine,
    Function::ArcCosine,
    Function::ArcTangent,
    Function::HyperbolicSine,
    Function::HyperbolicCosine,
    Function::HyperbolicTangent,
    Function::AreaHyperbolicSine,
    Function::AreaHyperbolicCosine,
    Function::AreaHyperbolicTangent,
    Function::Exponential,
    Function::Logarithm,
];

/// The largest difference of a function of the platform, in units of the last place.
const PLATFORM_UNITS: f64 = 4.0;

/// A tape while it is made.
struct Maker {
    random: Random,
    nodes: Vec<TapeNode>,
    steps: Vec<TapeStep>,
    /// The numbers that may be needed again: arguments, constants, roots and solutions.
    lasting: Vec<Value>,
    /// Numbers and truths that no operation needs yet; they are taken first.
    numbers: Vec<Value>,
    truths: Vec<Value>,
    checks: Vec<TapeCheck>,
    searches: Vec<NewtonSearch>,
    systems: Vec<System>,
    solutions: Vec<LinearSolution>,
}

impl Maker {
    fn new(seed: u64) -> Self {
        let mut maker = Self {
            random: Random::new(seed),
            nodes: Vec::new(),
            steps: Vec::new(),
            lasting: Vec::new(),
            numbers: Vec::new(),
            truths: Vec::new(),
            checks: Vec::new(),
            searches: Vec::new(),
            systems: Vec::new(),
            solutions: Vec::new(),
        };
        for index in 0..ARGUMENTS {
            maker.last(TapeNode::Argument(index));
        }
        for constant in CONSTANTS {
            maker.last(TapeNode::Constant(Constant::new(constant)));
        }
        for holds in [true, false] {
            maker.put(TapeNode::Certain(holds));
        }
        maker
    }

    fn pick(&mut self, count: usize) -> usize {
        let count = u32::try_from(count).unwrap();
        let drawn = self.random.between(0.0, f64::from(count));
        let found = (0..count).find(|index| drawn < f64::from(index + 1));
        found.unwrap_or(count.saturating_sub(1)) as usize
    }

    fn chance(&mut self, share: f64) -> bool {
        self.random.between(0.0, 1.0) < share
    }

    fn put(&mut self, node: TapeNode) -> Value {
        let value = Value(u32::try_from(self.nodes.len()).unwrap());
        self.nodes.push(node);
        value
    }

    fn last(&mut self, node: TapeNode) {
        let value = self.put(node);
        self.lasting.push(value);
    }

    fn constant(&mut self, value: f64) -> Value {
        self.put(TapeNode::Constant(Constant::new(value)))
    }

    /// A number that is finite unless an argument is not.
    fn plain(&mut self) -> Value {
        let index = self.pick(ARGUMENTS);
        self.lasting[index]
    }

    fn number(&mut self) -> Value {
        if self.numbers.is_empty() || self.chance(0.3) {
            let index = self.pick(self.lasting.len());
            self.lasting[index]
        } else {
            let index = self.pick(self.numbers.len());
            self.numbers.swap_remove(index)
        }
    }

    fn truth(&mut self) -> Option<Value> {
        if self.chance(0.05) {
            // one of the truths that are known beforehand
            let index = ARGUMENTS + CONSTANTS.len() + self.pick(2);
            return Some(Value(u32::try_from(index).unwrap()));
        }
        if self.chance(0.8) { self.truths.pop() } else { None }
    }

    fn compute(&mut self, node: TapeNode) -> Value {
        let value = self.put(node);
        self.steps.push(TapeStep::Compute(value));
        value
    }

    fn operation(&mut self) -> TapeNode {
        let operators = [Operator::Add, Operator::Subtract, Operator::Multiply, Operator::Divide];
        let comparisons = [Comparison::AtLeast, Comparison::Exceeds, Comparison::Equals];
        let (a, b) = (self.number(), self.number());
        match self.pick(14) {
            0..=4 => TapeNode::Binary(operators[self.pick(4)], a, b),
            5 => TapeNode::Binary(Operator::ArcTangent, a, b),
            6 => TapeNode::PlusProduct(a, b, self.number()),
            7 => TapeNode::MinusProduct(a, b, self.number()),
            8 | 9 => TapeNode::Call(EXACT[self.pick(EXACT.len())], a),
            10 => match self.truth() {
                Some(truth) => TapeNode::Select(truth, a, b),
                None => TapeNode::Call(Function::Sine, self.plain()),
            },
            11 => TapeNode::Compare(comparisons[self.pick(3)], a, b),
            12 => TapeNode::IsFinite(a),
            _ => match (self.truth(), self.truth()) {
                (Some(one), Some(other)) if self.chance(0.5) => TapeNode::Both(one, other),
                (Some(one), Some(other)) => TapeNode::Either(one, other),
                (Some(one), None) | (None, Some(one)) => TapeNode::Not(one),
                (None, None) => TapeNode::Call(Function::Cosine, self.plain()),
            },
        }
    }

    fn operations(&mut self, count: usize) {
        for _ in 0..count {
            let node = self.operation();
            let value = self.compute(node);
            if node.is_truth() {
                self.truths.push(value);
            } else {
                self.numbers.push(value);
            }
        }
    }

    fn check(&mut self, name: &'static str, condition: Condition) {
        let mut cold = Vec::new();
        let mut margin = None;
        if let Condition::Holds(_) = condition {
            // Its margin is a difference within a sine, which only it needs.
            let (one, other) = (self.plain(), self.plain());
            let difference = self.put(TapeNode::Binary(Operator::Subtract, one, other));
            let sine = self.put(TapeNode::Call(Function::Sine, difference));
            let whole = self.put(TapeNode::Binary(Operator::Multiply, sine, one));
            cold = vec![difference, sine, whole];
            margin = Some(whole);
        }
        self.steps.push(TapeStep::Check(self.checks.len()));
        self.checks.push(TapeCheck {
            name,
            block: ["x, y", "z"][self.checks.len() % 2].into(),
            order: 0,
            condition,
            cold,
            margin,
        });
    }

    /// A check that holds for most arguments.
    fn decision(&mut self) {
        let (one, limit) = (self.plain(), self.constant(-2.5));
        let truth = self.compute(TapeNode::Compare(Comparison::AtLeast, one, limit));
        self.check("a decision", Condition::Holds(truth));
    }

    /// u + k u³ + the next unknown over 10 = a, for each unknown u, where a and the choice of k come from outside.
    fn search(&mut self) {
        let count = 1 + self.pick(3);
        let search = self.searches.len();
        let (three, tenth, one) = (self.constant(3.0), self.constant(0.1), self.constant(1.0));
        let zero = self.constant(0.0);
        let truth = self.truth();
        let first = self.nodes.len();
        let unknowns: Vec<Value> = (0..count)
            .map(|index| self.put(TapeNode::Unknown { search, index }))
            .collect();
        let (mut body, mut residuals, mut jacobian) = (Vec::new(), Vec::new(), Vec::new());
        for row in 0..count {
            let (unknown, next) = (unknowns[row], unknowns[(row + 1) % count]);
            let wanted = self.plain();
            let mut computed = |maker: &mut Self, node: TapeNode| {
                let value = maker.put(node);
                body.push(value);
                value
            };
            let factor = match truth {
                Some(truth) => computed(self, TapeNode::Select(truth, one, tenth)),
                None => tenth,
            };
            let square = computed(self, TapeNode::Binary(Operator::Multiply, unknown, unknown));
            let cube = computed(self, TapeNode::Binary(Operator::Multiply, square, unknown));
            let sum = computed(self, TapeNode::PlusProduct(unknown, factor, cube));
            let sum = computed(self, TapeNode::PlusProduct(sum, tenth, next));
            residuals.push(computed(self, TapeNode::Binary(Operator::Subtract, sum, wanted)));
            let slope = computed(self, TapeNode::Binary(Operator::Multiply, three, factor));
            let slope = computed(self, TapeNode::PlusProduct(one, slope, square));
            let mut entries = vec![zero; count];
            entries[(row + 1) % count] = tenth;
            entries[row] = if count == 1 {
                computed(self, TapeNode::Binary(Operator::Add, slope, tenth))
            } else {
                slope
            };
            jacobian.push(entries);
        }
        assert!(first < self.nodes.len());
        let guess = (0..count).map(|_| self.entry()).collect();
        self.searches.push(NewtonSearch {
            guess,
            sizes: vec![one; count],
            body,
            residuals,
            jacobian,
        });
        self.steps.push(TapeStep::Search(search));
        self.check("convergence", Condition::Found(search));
        for index in 0..count {
            self.last(TapeNode::Root { search, index });
        }
    }

    /// An entry of a block: mostly a plain one, seldom any number.
    fn entry(&mut self) -> Value {
        if self.chance(0.02) {
            return self.number();
        }
        let (one, other) = (self.plain(), self.plain());
        let operators = [Operator::Add, Operator::Subtract, Operator::Multiply];
        let operator = operators[self.pick(3)];
        self.compute(TapeNode::Binary(operator, one, other))
    }

    fn system(&mut self) {
        let count = 1 + self.pick(4);
        let system = self.systems.len();
        let rows = (0..count).map(|_| (0..count).map(|_| self.entry()).collect()).collect();
        self.systems.push(System { rows });
        self.steps.push(TapeStep::Factor(system));
        self.check("determinant", Condition::Regular(system));
        for _ in 0..=self.pick(2) {
            let solution = self.solutions.len();
            let right = (0..count).map(|_| self.entry()).collect();
            self.solutions.push(LinearSolution { system, right });
            self.steps.push(TapeStep::Solve(solution));
            for index in 0..count {
                self.last(TapeNode::Solution { solution, index });
            }
        }
    }

    /// The nodes that are computed and that nothing needs.
    fn unused(&self) -> Vec<Value> {
        let mut used = vec![false; self.nodes.len()];
        let mut mark = |value: Value| used[value.index()] = true;
        self.nodes.iter().for_each(|node| node.operands(&mut mark));
        for check in &self.checks {
            if let Condition::Holds(truth) = check.condition {
                mark(truth);
            }
        }
        let blocks = self.searches.iter().flat_map(|search| &search.guess);
        blocks.copied().for_each(&mut mark);
        let rows = self.systems.iter().flat_map(|system| system.rows.iter().flatten());
        rows.copied().for_each(&mut mark);
        let rights = self.solutions.iter().flat_map(|solution| &solution.right);
        rights.copied().for_each(&mut mark);
        let computed = self.steps.iter().filter_map(TapeStep::computed);
        computed.filter(|value| !used[value.index()]).collect()
    }

    fn tape(mut self, seed: u64) -> Tape<'static> {
        self.operations(OPERATIONS / 3);
        if self.chance(0.3) {
            self.decision();
        }
        if self.chance(0.3) {
            self.search();
        }
        self.operations(OPERATIONS / 3);
        if self.chance(0.3) {
            self.system();
        }
        self.operations(OPERATIONS / 3);
        // Nothing is left unused, as in every tape.
        let (one, other) = (self.lasting[ARGUMENTS + 2], self.lasting[ARGUMENTS + 3]);
        self.numbers.clear();
        for value in self.unused() {
            let number = if self.nodes[value.index()].is_truth() {
                self.compute(TapeNode::Select(value, one, other))
            } else {
                value
            };
            self.numbers.push(number);
        }
        // Functions of the platform stand last, where their differences do not grow.
        for _ in 0..2 {
            let (function, argument) = (OF_THE_PLATFORM[self.pick(OF_THE_PLATFORM.len())], self.plain());
            let value = self.compute(TapeNode::Call(function, argument));
            self.numbers.push(value);
        }
        let mut values = self.numbers.clone();
        let roots = self.nodes.iter().enumerate();
        values.extend(
            roots
                .filter(|(_, node)| matches!(node, TapeNode::Root { .. } | TapeNode::Solution { .. }))
                .map(|(index, _)| Value(u32::try_from(index).unwrap())),
        );
        let outcome = |(index, value): (usize, &Value)| TapeResult {
            quantity: ResultOf::Output(index),
            order: 0,
            name: format!("result{index}"),
            dimension: Dimension::Scalar,
            description: TEXT,
            value: *value,
        };
        let argument = |index: usize| Argument {
            role: Role::Parameter(index),
            name: NAMES[index].to_string(),
            dimension: Dimension::Scalar,
            description: TEXT,
        };
        let name = Box::leak(format!("Random{seed}").into_boxed_str());
        Tape {
            description: Description::__new(name, &[], &[], &[], &[], &[TEXT], &[], 0, &[]),
            outline: Outline::NONE,
            precision: NumberType::Double,
            order: 0,
            folded: Vec::new(),
            arguments: (0..ARGUMENTS).map(argument).collect(),
            results: values.iter().enumerate().map(outcome).collect(),
            steps: self.steps,
            nodes: self.nodes,
            checks: self.checks,
            searches: self.searches,
            systems: self.systems,
            solutions: self.solutions,
        }
    }
}

fn random_tapes() -> Vec<Tape<'static>> {
    (1..=TAPES).map(|seed| Maker::new(seed).tape(seed)).collect()
}

fn arguments(tape: u64) -> Vec<f64> {
    let mut random = Random::new(tape + 1000);
    (0..ARGUMENTS * POSES).map(|_| random.between(-3.0, 3.0)).collect()
}

/// A kind of node has a number.
fn kind(node: &TapeNode) -> usize {
    match node {
        TapeNode::Argument(_) => 0,
        TapeNode::Constant(_) => 1,
        TapeNode::Certain(_) => 2,
        TapeNode::Call(function, _) => 3 + *function as usize,
        TapeNode::Binary(operator, ..) => 21 + *operator as usize,
        TapeNode::PlusProduct(..) => 26,
        TapeNode::MinusProduct(..) => 27,
        TapeNode::Select(..) => 28,
        TapeNode::Compare(comparison, ..) => 29 + *comparison as usize,
        TapeNode::IsFinite(_) => 32,
        TapeNode::Both(..) => 33,
        TapeNode::Either(..) => 34,
        TapeNode::Not(_) => 35,
        TapeNode::Unknown { .. } => 36,
        TapeNode::Root { .. } => 37,
        TapeNode::Solution { .. } => 38,
    }
}

/// The tapes have every kind of node, most of their poses are found, and each kind of check fails somewhere.
#[test]
fn random_tapes_have_every_kind_of_node() {
    let (mut kinds, mut found, mut failed) = (vec![0; 39], 0, [0; 3]);
    for (tape, seed) in random_tapes().iter().zip(1..) {
        tape.nodes.iter().for_each(|node| kinds[kind(node)] += 1);
        for given in arguments(seed).chunks(ARGUMENTS) {
            match tape.run(given) {
                Ok(_) => found += 1,
                Err(stop) => match tape.checks[stop.check].condition {
                    Condition::Holds(_) => failed[0] += 1,
                    Condition::Found(_) => failed[1] += 1,
                    Condition::Regular(_) => failed[2] += 1,
                },
            }
        }
    }
    assert!(kinds.iter().all(|count| *count > 20), "{kinds:?}");
    assert!(
        found > 3500 && failed.iter().all(|count| *count > 0),
        "{found} {failed:?}"
    );
}

/// A folder with the arguments of all tapes as doubles, which is removed in the end.
struct Folder(PathBuf);

impl Folder {
    fn new(language: &str) -> Self {
        let path = std::env::temp_dir().join(format!("kin-printing-{language}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        let numbers = (1..=TAPES).flat_map(arguments).flat_map(f64::to_le_bytes);
        fs::write(path.join("in"), numbers.collect::<Vec<u8>>()).unwrap();
        Self(path)
    }

    fn write(&self, file: &str, text: impl AsRef<[u8]>) {
        fs::write(self.0.join(file), text).unwrap();
    }

    /// Runs a command, which must succeed without a word of complaint.
    fn run(&self, program: impl AsRef<Path>, words: &[String]) {
        let program = program.as_ref();
        let output = Command::new(program)
            .args(words)
            .current_dir(&self.0)
            .output()
            .unwrap_or_else(|error| panic!("{} cannot be run: {error}", program.display()));
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(
            output.status.success() && errors.is_empty(),
            "{}",
            errors.chars().take(3000).collect::<String>()
        );
    }

    /// Compares what a program has written: for each tape and pose a code, which is 0 for a pose, otherwise the number
    /// of the check from 1 on, then the margin, then the results.
    fn compare(&self, tapes: &[Tape<'_>]) {
        let bytes = fs::read(self.0.join("out")).unwrap();
        let mut numbers = bytes.as_chunks::<8>().0.iter().map(|bytes| f64::from_le_bytes(*bytes));
        for (tape, seed) in tapes.iter().zip(1..) {
            for given in arguments(seed).chunks(ARGUMENTS) {
                let [code, margin] = [(); 2].map(|()| numbers.next().unwrap());
                let others: Vec<f64> = numbers.by_ref().take(tape.results.len()).collect();
                let is_same = |one: f64, other: f64| one.to_bits() == other.to_bits() || one.is_nan() && other.is_nan();
                match tape.run(given) {
                    Ok(found) => {
                        assert_eq!(code, 0.0, "tape {seed} at {given:?}");
                        for ((result, one), other) in tape.results.iter().zip(found).zip(others) {
                            let node = tape.nodes[result.value.index()];
                            let is_of_the_platform =
                                matches!(node, TapeNode::Call(function, _) if OF_THE_PLATFORM.contains(&function));
                            let is_close =
                                is_of_the_platform && (one - other).abs() <= PLATFORM_UNITS * f64::EPSILON * one.abs();
                            assert!(
                                is_same(one, other) || is_close,
                                "tape {seed} at {given:?}: {} is {one}, not {other}",
                                result.name
                            );
                        }
                    }
                    Err(stop) => {
                        assert_eq!(code - 1.0, f64::from(u32::try_from(stop.check).unwrap()), "tape {seed}");
                        if tape.checks[stop.check].margin.is_some() {
                            assert!(is_same(margin, stop.margin), "tape {seed}: {margin} {stop}");
                        }
                    }
                }
            }
        }
        assert!(numbers.next().is_none());
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
#[ignore = "gcc"]
fn c_computes_random_tapes() {
    if FUSED {
        return;
    }
    let (folder, tapes) = (Folder::new("c"), random_tapes());
    let (mut table, mut sources) = (String::new(), Vec::new());
    for tape in &tapes {
        let c = tape.c_without_sharing();
        let name = &c.name;
        let kernel = format!(
            "\nvoid {name}_kernel(const double *in, double *out);\nvoid {name}_kernel(const double *in, double \
             *out)\n{{\n    \
             const {name}_outcome outcome = {name}_solve((const {name}_dimensions *)in, ({name}_pose *)(out + \
             2));\n    \
             out[0] = outcome.code;\n    out[1] = outcome.margin;\n}}\n"
        );
        folder.write(&format!("{name}.h"), &c.header);
        // What all sources carry along stands once, or the compiler would take minutes for it.
        let carried = runtime::c(RuntimeParts::of(tape), NumberType::Double);
        sources.push(c.source.replace(&carried, "") + &kernel);
        table.extend([format!("CASE({name}, {})\n", tape.results.len())]);
    }
    folder.write(
        "main.c",
        format!(
            "#include <stdio.h>
#define CASE(name, count) void name##_kernel(const double *in, double *out);
{table}#undef CASE
int main(void)
{{
    static double in[{ARGUMENTS}], out[1000];
    FILE *const given = fopen(\"in\", \"rb\"), *const found = fopen(\"out\", \"wb\");
#define CASE(name, count) \\
    for (int pose = 0; pose < {POSES}; pose++) {{ \\
        if (fread(in, sizeof in, 1, given) != 1) {{ return 1; }} \\
        name##_kernel(in, out); \\
        fwrite(out, sizeof(double), 2 + count, found); \\
    }}
{table}    return fclose(found);
}}
"
        ),
    );
    let flags = "-std=c99 -O0 -ffp-contract=off -Wall -Wextra -Wconversion -Wpedantic -Werror -c";
    let words: Vec<String> = flags.split(' ').map(str::to_string).collect();
    let all = RuntimeParts {
        sine_cosine: true,
        arc_tangent: true,
        factors: true,
        newton: true,
        unknowns: 4,
    };
    let carried = runtime::c(all, NumberType::Double);
    let parts: Vec<String> = (0..4).map(|part| format!("part{part}")).collect();
    for (part, sources) in parts.iter().zip(sources.chunks(sources.len().div_ceil(parts.len()))) {
        folder.write(&format!("{part}.c"), carried.clone() + &sources.concat());
    }
    std::thread::scope(|scope| {
        let folder = &folder;
        for part in &parts {
            let command = [words.as_slice(), &[format!("{part}.c")]].concat();
            scope.spawn(move || folder.run("gcc", &command));
        }
    });
    let objects = parts.iter().map(|part| format!("{part}.o"));
    let link = ["main.c", "-lm", "-o", "main"].map(str::to_string);
    folder.run("gcc", &objects.chain(link).collect::<Vec<_>>());
    folder.run(folder.0.join("main"), &[]);
    folder.compare(&tapes);
}

#[test]
#[ignore = "node"]
fn java_script_computes_random_tapes() {
    if FUSED {
        return;
    }
    let (folder, tapes) = (Folder::new("javascript"), random_tapes());
    for (tape, seed) in tapes.iter().zip(1..) {
        let text = super::java_script::JavaScriptModule::new(tape, Some(usize::MAX)).text();
        folder.write(&format!("tape{seed}.mjs"), text);
    }
    let counts: Vec<String> = tapes.iter().map(|tape| tape.results.len().to_string()).collect();
    folder.write(
        "main.mjs",
        format!(
            "import {{ readFileSync, writeFileSync }} from \"node:fs\";

const bytes = readFileSync(\"in\");
const found = [];
let start = 0;
for (const [index, count] of [{}].entries()) {{
  const {{ CHECKS, solve }} = await import(`./tape${{index + 1}}.mjs`);
  for (let pose = 0; pose < {POSES}; pose++) {{
    const [lambda, theta, theta_2, this_] = [0, 1, 2, 3].map((index) => bytes.readDoubleLE(start + 8 * index));
    start += 32;
    const outcome = solve({{ lambda, theta, theta_2, this_ }}, {{}}, 1);
    if (outcome.ok) {{
      found.push(0, 0, ...Object.values(outcome.pose).flat());
    }} else {{
      const code = 1 + CHECKS.findIndex((check) => check.check === outcome.check && check.block === outcome.block);
      found.push(code, outcome.margin, ...new Array(count).fill(NaN));
    }}
  }}
}}
const out = Buffer.alloc(8 * found.length);
found.forEach((number, index) => out.writeDoubleLE(number, 8 * index));
writeFileSync(\"out\", out);
",
            counts.join(", ")
        ),
    );
    folder.run("node", &["main.mjs".to_string()]);
    folder.compare(&tapes);
}

#[test]
#[ignore = "numpy"]
fn numpy_computes_random_tapes() {
    if FUSED {
        return;
    }
    let (folder, tapes) = (Folder::new("numpy"), random_tapes());
    for (tape, seed) in tapes.iter().zip(1..) {
        let text = super::python::PythonModule::new(tape, Some(usize::MAX)).text();
        folder.write(&format!("tape{seed}.py"), text);
    }
    folder.write(
        "main.py",
        format!(
            "import dataclasses
import importlib

import numpy as np

given = np.fromfile(\"in\", dtype=\"<f8\").reshape(-1, {POSES}, {ARGUMENTS})
with open(\"out\", \"wb\") as out:
    for index, rows in enumerate(given):
        module = importlib.import_module(f\"tape{{index + 1}}\")
        names = [\"lambda_\", \"theta\", \"theta_2\", \"this\"]
        pose = module.solve(dict(zip(names, rows.T)), {{}}, 1.0)
        columns = [pose.check + 1.0, pose.margin]
        columns += [getattr(pose, field.name)[0] for field in dataclasses.fields(pose)[3:]]
        np.array([np.broadcast_to(column, {POSES}) for column in columns]).T.astype(\"<f8\").tofile(out)
"
        ),
    );
    folder.run("python3", &["-B".to_string(), "main.py".to_string()]);
    folder.compare(&tapes);
}
