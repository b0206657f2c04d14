//! Random tapes in other languages, beside the tapes run by themselves.
//!
//! The tapes are made of every kind of operation, and operands have no names of their own, so that every operator becomes
//! an operand of every other one.

use std::format;
use std::process::Command;
use std::string::{String, ToString as _};
use std::vec::Vec;

use crate::mechanism::Description;
use crate::number::elementary::FUSED;
use crate::picture::Outline;
use crate::quantity::Dimension;
use crate::tape::{
    Argument, Comparison, Constant, Function, Node, Operator, Outcome, Precision, ResultOf, Role, Step, Tape, Value,
};
use crate::verify::Random;

const TAPES: u64 = 300;
const ARGUMENTS: usize = 4;
const POSES: usize = 5;

/// Names that need care: keywords, letters of other alphabets, and names that would be equal.
const NAMES: [&str; ARGUMENTS] = ["lambda", "θ", "theta", "this"];

/// A description that would end comments and strings.
const TEXT: &str = "ends */ here \"\"\" and \\\u{2028}there ??/\nwith a last \\";

const CONSTANTS: [f64; 8] = [0.0, -0.0, 0.1, -2.5, 5e-324, 1e300, f64::INFINITY, f64::NAN];

fn value(place: usize) -> Value {
    Value(u32::try_from(place).unwrap())
}

fn random_tape(seed: u64) -> Tape {
    let mut random = Random::new(seed);
    let mut nodes: Vec<Node> = (0..ARGUMENTS).map(Node::Argument).collect();
    nodes.extend(CONSTANTS.map(|constant| Node::Constant(Constant::new(constant))));
    let first = nodes.len();
    // Numbers and truths that no operation needs yet; they are taken first.
    let (mut numbers, mut truths) = (Vec::new(), Vec::new());
    let pick = |count: usize, random: &mut Random| {
        let drawn = random.between(0.0, f64::from(u32::try_from(count).unwrap()));
        (0..count)
            .rev()
            .find(|index| f64::from(u32::try_from(*index).unwrap()) <= drawn)
            .unwrap_or(0)
    };
    for place in first..first + 60 {
        let mut number = |random: &mut Random| {
            if numbers.is_empty() || random.between(0.0, 1.0) < 0.3 {
                value(pick(first, random))
            } else {
                let index = pick(numbers.len(), random);
                numbers.swap_remove(index)
            }
        };
        let (a, b, c) = (number(&mut random), number(&mut random), number(&mut random));
        let mut truth = |random: &mut Random| match truths.pop() {
            Some(truth) if random.between(0.0, 1.0) < 0.8 => Some(truth),
            _ => None,
        };
        let operators = [Operator::Add, Operator::Subtract, Operator::Multiply, Operator::Divide];
        let functions = [
            Function::Negate,
            Function::Magnitude,
            Function::SquareRoot,
            Function::Round,
            Function::Raise,
        ];
        let comparisons = [Comparison::AtLeast, Comparison::Exceeds, Comparison::Equals];
        let node = match pick(14, &mut random) {
            0..=4 => Node::Binary(operators[pick(4, &mut random)], a, b),
            5 => Node::Binary(Operator::ArcTangent, a, b),
            6 => Node::PlusProduct(a, b, c),
            7 => Node::MinusProduct(a, b, c),
            8 | 9 => Node::Call(functions[pick(5, &mut random)], a),
            10 => match truth(&mut random) {
                Some(truth) => Node::Select(truth, a, b),
                None => Node::Call(Function::Sine, value(pick(ARGUMENTS, &mut random))),
            },
            11 => Node::Compare(comparisons[pick(3, &mut random)], a, b),
            12 => Node::IsFinite(a),
            _ => match (truth(&mut random), truth(&mut random)) {
                (Some(one), Some(other)) if random.between(0.0, 1.0) < 0.5 => Node::Both(one, other),
                (Some(one), Some(other)) => Node::Either(one, other),
                (Some(one), None) | (None, Some(one)) => Node::Not(one),
                (None, None) => Node::Call(Function::Cosine, value(pick(ARGUMENTS, &mut random))),
            },
        };
        if node.is_truth() {
            truths.push(value(place));
        } else {
            numbers.push(value(place));
        }
        nodes.push(node);
    }
    let results = numbers.iter().enumerate().map(|(index, own)| Outcome {
        quantity: ResultOf::Output(index),
        order: 0,
        name: format!("result{index}"),
        dimension: Dimension::Scalar,
        description: TEXT,
        value: *own,
    });
    Tape {
        description: Description::__new("Random", &[], &[], &[], &[], &[TEXT], &[], 0, &[]),
        outline: Outline::NONE,
        precision: Precision::Double,
        order: 0,
        folded: Vec::new(),
        arguments: (0..ARGUMENTS)
            .map(|index| Argument {
                role: Role::Parameter(index),
                name: NAMES[index].to_string(),
                dimension: Dimension::Scalar,
                description: TEXT,
            })
            .collect(),
        results: results.collect(),
        steps: (first..nodes.len()).map(|place| Step::Compute(value(place))).collect(),
        nodes,
        checks: Vec::new(),
        searches: Vec::new(),
        systems: Vec::new(),
        solutions: Vec::new(),
    }
}

fn arguments(seed: u64) -> Vec<f64> {
    let mut random = Random::new(seed + 1000);
    (0..ARGUMENTS * POSES).map(|_| random.between(-3.0, 3.0)).collect()
}

/// A number of the language from its bits, so that the test does not trust the printing of numbers.
fn bits(numbers: &[f64]) -> String {
    let texts: Vec<String> = numbers
        .iter()
        .map(|number| format!("\"{:016x}\"", number.to_bits()))
        .collect();
    texts.join(", ")
}

/// Runs the modules of all tapes by one driver, and compares what it prints: one line of bits for each pose.
fn compare(tool: &str, extension: &str, module: impl Fn(&Tape) -> String, driver: impl Fn(&[u64]) -> String) {
    if FUSED {
        return;
    }
    let folder = std::env::temp_dir().join(format!("kin-printing-{tool}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let seeds: Vec<u64> = (1..=TAPES).collect();
    for seed in &seeds {
        let text = module(&random_tape(*seed));
        std::fs::write(folder.join(format!("tape{seed}.{extension}")), text).unwrap();
    }
    let main = format!("main.{extension}");
    std::fs::write(folder.join(&main), driver(&seeds)).unwrap();
    let output = Command::new(tool).arg(&main).current_dir(&folder).output().unwrap();
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success() && errors.is_empty(), "{errors}");
    let mut lines = Vec::new();
    for seed in seeds {
        let tape = random_tape(seed);
        for given in arguments(seed).chunks(ARGUMENTS) {
            let found = tape.run(given).unwrap();
            let found = found.into_iter().map(|own| {
                if own.is_nan() {
                    "nan".into()
                } else {
                    format!("{:016x}", own.to_bits())
                }
            });
            lines.push(format!("{seed} {}", found.collect::<Vec<_>>().join(" ")));
        }
    }
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(told.lines().count(), lines.len());
    for (told, own) in told.lines().zip(&lines) {
        assert_eq!(told.trim_end(), own.trim_end());
    }
    let _ = std::fs::remove_dir_all(&folder);
}

#[test]
#[ignore = "node"]
fn java_script_computes_random_tapes() {
    compare(
        "node",
        "mjs",
        |tape| super::java_script::Module::new(tape, Some(usize::MAX)).text(),
        |seeds| {
            let mut text = String::from(
                "const view = new DataView(new ArrayBuffer(8));
const read = (hex) => (view.setBigUint64(0, BigInt(`0x${hex}`)), view.getFloat64(0));
const write = (number) => (view.setFloat64(0, number), view.getBigUint64(0).toString(16).padStart(16, \"0\"));
",
            );
            for seed in seeds {
                text.extend([format!(
                    "{{
  const {{ solve }} = await import(\"./tape{seed}.mjs\");
  const numbers = [{}].map(read);
  for (let start = 0; start < numbers.length; start += 4) {{
    const [lambda, theta, theta_2, this_] = numbers.slice(start, start + 4);
    const {{ pose }} = solve({{ lambda, theta, theta_2, this_ }}, {{}}, 1);
    console.log([{seed}, ...Object.values(pose).flat().map((own) => (Number.isNaN(own) ? \"nan\" : write(own)))].join(\" \"));
  }}
}}
",
                    bits(&arguments(*seed))
                )]);
            }
            text
        },
    );
}

#[test]
#[ignore = "numpy"]
fn numpy_computes_random_tapes() {
    compare(
        "python3",
        "py",
        |tape| super::python::Module::new(tape, Some(usize::MAX)).text(),
        |seeds| {
            let mut text = String::from(
                "import dataclasses
import importlib
import struct

import numpy as np

CASES = {
",
            );
            for seed in seeds {
                text.extend([format!("    {seed}: [{}],\n", bits(&arguments(*seed)))]);
            }
            text.push_str(
                "}
for seed, hexes in CASES.items():
    module = importlib.import_module(f\"tape{seed}\")
    numbers = np.array([struct.unpack(\">d\", bytes.fromhex(own))[0] for own in hexes]).reshape(-1, 4).T
    pose = module.solve(dict(zip([\"lambda_\", \"theta\", \"theta_2\", \"this\"], numbers)), {}, 1.0)
    for place in range(numbers.shape[1]):
        row = [getattr(pose, field.name)[0, place] for field in dataclasses.fields(pose)[3:]]
        print(seed, *(\"nan\" if np.isnan(own) else struct.pack(\">d\", own).hex() for own in row))
",
            );
            text
        },
    );
}
