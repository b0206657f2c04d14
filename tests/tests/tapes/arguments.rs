//! What solvers in JavaScript and Python say of wrong arguments.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use kin_core::library::{FourBar, StephensonII, WattI};
use kin_core::tape::{self, Options, Tape};

/// A call, and a part of the message; none if it is right. The four-bar is `f`, its dimensions are `L`; `W` has two
/// choices with the arguments `w`, `S` has values nearby with the arguments `s`, and `C` has its dimensions folded in.
type Cases = [(&'static str, Option<&'static str>)];

const JAVA_SCRIPT: &Cases = &[
    ("f(L, { theta2: [1, 1] }, OPEN)", None),
    ("f(L, { theta2: [1] }, CROSSED)", None),
    ("f(L, { theta2: new Float64Array([1, 1, 0, 0, 0]) }, OPEN)", None),
    (
        "f(L, { theta2: [1, 1] })",
        Some("assembly is undefined: give OPEN or CROSSED"),
    ),
    (
        "f(L, { theta2: [1, 1] }, 'open')",
        Some("assembly is \"open\": give OPEN or CROSSED"),
    ),
    (
        "f(L, { theta2: [1, 1] }, 0)",
        Some("assembly is 0: give OPEN or CROSSED"),
    ),
    ("f(L, { theta2: [1, 1] }, NaN)", Some("give OPEN or CROSSED")),
    (
        "f({ r1: 90, r2: 30, r3: 80 }, { theta2: [1, 1] }, OPEN)",
        Some("parameters.r4 is undefined: give a number"),
    ),
    (
        "f({ ...L, r4: '60' }, { theta2: [1, 1] }, OPEN)",
        Some("parameters.r4 is \"60\": give a number"),
    ),
    (
        "f({ ...L, r33: 1 }, { theta2: [1, 1] }, OPEN)",
        Some("parameters has no r33: its names are r1, r2, r3, r4"),
    ),
    (
        "f({ r1: 90, r2: 30, r33: 80, r4: 70 }, { theta2: [1, 1] }, OPEN)",
        Some("parameters has no r33"),
    ),
    (
        "f(undefined, { theta2: [1, 1] }, OPEN)",
        Some("parameters.r1 is undefined"),
    ),
    (
        "f(L, { theta2: 1 }, OPEN)",
        Some("inputs.theta2 is 1: give its motion as an array, as in [position, velocity]"),
    ),
    ("f(L, { theta2: [] }, OPEN)", Some("inputs.theta2 is []")),
    ("f(L, { theta2: [1, '1'] }, OPEN)", Some("inputs.theta2 is [1,\"1\"]")),
    ("f(L, { theta2: [1, 1, 1, 1, 1, 1] }, OPEN)", Some("give its motion")),
    ("f(L, { theta2: [1], theta3: [1] }, OPEN)", Some("inputs has no theta3")),
    ("f(L, undefined, OPEN)", Some("inputs.theta2 is undefined")),
    ("W(...w, { theta3_theta4: OPEN, theta5_theta6: CROSSED })", None),
    (
        "W(...w, { theta3_theta4: OPEN })",
        Some("assembly.theta5_theta6 is undefined: give OPEN or CROSSED"),
    ),
    (
        "W(...w, { theta3_theta4: OPEN, theta5_theta6: OPEN, phi: OPEN })",
        Some("assembly has no phi"),
    ),
    ("W(...w, OPEN)", Some("assembly.theta3_theta4 is undefined")),
    ("S(...s, { theta3: 0, theta4: 1, theta5: 1, theta6: 2 })", None),
    (
        "S(...s, { theta3: 0, theta4: 1, theta5: 1 })",
        Some("assembly.theta6 is undefined: give a value near this unknown"),
    ),
    ("S(...s, OPEN)", Some("assembly.theta3 is undefined")),
    ("C({}, { theta2: [1, 1] }, OPEN)", None),
    (
        "C({ r1: 45 }, { theta2: [1, 1] }, OPEN)",
        Some("parameters has no r1: it is an object without names"),
    ),
];

const PYTHON: &Cases = &[
    ("f(L, {'theta2': [1, 1]}, OPEN)", None),
    (
        "f(L, {'theta2': [np.linspace(0, 1, 7), 1]}, np.where(np.arange(7) > 3, OPEN, CROSSED))",
        None,
    ),
    (
        "f(L, {'theta2': [1, 1]}, 'open')",
        Some("assembly is 'open': give OPEN or CROSSED"),
    ),
    (
        "f(L, {'theta2': [1, 1]}, 0)",
        Some("assembly is 0: give OPEN or CROSSED"),
    ),
    ("f(L, {'theta2': [1, 1]}, None)", Some("give OPEN or CROSSED")),
    (
        "f({'r1': 90, 'r2': 30, 'r3': 80}, {'theta2': [1, 1]}, OPEN)",
        Some("parameters has no value for 'r4'"),
    ),
    (
        "f({**L, 'r33': 80}, {'theta2': [1, 1]}, OPEN)",
        Some("parameters has no 'r33': its names are r1, r2, r3, r4"),
    ),
    (
        "f(L, {'theta2': 1.0}, OPEN)",
        Some("inputs['theta2'] is 1.0: give its motion as a list, as in [position, velocity]"),
    ),
    (
        "f(L, {'theta2': np.linspace(0, 6, 360)}, OPEN)",
        Some("inputs['theta2'] has 360 entries"),
    ),
    ("f(L, {'theta2': []}, OPEN)", Some("inputs['theta2'] is []")),
    ("f(L, {}, OPEN)", Some("inputs has no value for 'theta2'")),
    ("W(*w, {'theta3_theta4': OPEN, 'theta5_theta6': CROSSED})", None),
    (
        "W(*w, {'theta3_theta4': OPEN, 'theta5_theta6': 2})",
        Some("assembly[\"theta5_theta6\"] is 2"),
    ),
    (
        "W(*w, {'theta3_theta4': OPEN})",
        Some("assembly has no value for 'theta5_theta6'"),
    ),
    ("S(*s, {'theta3': 0, 'theta4': 1, 'theta5': 1, 'theta6': 2})", None),
    (
        "S(*s, {'theta3': 0, 'theta4': 1, 'theta5': 1})",
        Some("assembly has no value for 'theta6'"),
    ),
    ("C({}, {'theta2': [1, 1]}, OPEN)", None),
    (
        "C({'r1': 45}, {'theta2': [1, 1]}, OPEN)",
        Some("parameters has no 'r1': its names are none"),
    ),
];

fn tapes() -> [(&'static str, Tape); 4] {
    let record = "every mechanism of the library is recorded";
    let folded = Options::new().with_dimensions(&[90.0, 30.0, 80.0, 70.0]);
    [
        ("f", tape::record::<FourBar>(&Options::new()).expect(record)),
        ("W", tape::record::<WattI>(&Options::new()).expect(record)),
        ("S", tape::record::<StephensonII>(&Options::new()).expect(record)),
        ("C", tape::record::<FourBar>(&folded).expect(record)),
    ]
}

/// The dimensions and the inputs of a tape, all of them 1.
fn ones(tape: &Tape) -> String {
    let names = tape.java_script_names();
    let pairs = |names: &[String], value: &str| -> String {
        names
            .iter()
            .fold(String::new(), |text, name| text + &format!("\"{name}\": {value}, "))
    };
    format!(
        "[{{{}}}, {{{}}}]",
        pairs(&names.parameters, "1"),
        pairs(&names.inputs, "[1, 1]")
    )
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("arguments").join(name);
    fs::create_dir_all(&folder).expect("the folder of temporary files can be written");
    folder
}

/// Runs the calls, and compares what is said of each.
fn compare(cases: &Cases, command: &mut Command) {
    let output = command
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .output()
        .expect("the tool is installed");
    let (out, told) = (
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr),
    );
    assert!(output.status.success() && told.is_empty(), "{told}");
    assert_eq!(out.lines().count(), cases.len(), "{out}");
    for ((call, wanted), found) in cases.iter().zip(out.lines()) {
        match wanted {
            None => assert_eq!(found, "right", "{call}"),
            Some(message) => assert!(
                found.starts_with("TypeError: ") && found.contains(message),
                "{call}: {found}"
            ),
        }
    }
}

/// A missing or misspelt assembly, a missing dimension and an unknown name throw, and never lead to another pose.
#[test]
#[ignore = "node"]
fn wrong_arguments_throw_in_java_script() {
    let folder = folder("java_script");
    let mut driver = String::from("import { OPEN, CROSSED } from \"./f.mjs\";\n");
    for (name, tape) in tapes() {
        fs::write(folder.join(format!("{name}.mjs")), tape.java_script()).expect("the folder can be written");
        writeln!(driver, "import {{ solve as {name} }} from \"./{name}.mjs\";").unwrap();
        writeln!(
            driver,
            "const {} = {};",
            if name == "f" {
                "ones".to_owned()
            } else {
                name.to_lowercase()
            },
            ones(&tape)
        )
        .unwrap();
    }
    driver.push_str(
        "const L = { r1: 90, r2: 30, r3: 80, r4: 70 };\nconst check = (call) => { try { call(); \
         console.log(\"right\"); } catch (error) { console.log(String(error)); } };\n",
    );
    for (call, _) in JAVA_SCRIPT {
        writeln!(driver, "check(() => {call});").unwrap();
    }
    fs::write(folder.join("main.mjs"), driver).expect("the folder can be written");
    compare(JAVA_SCRIPT, Command::new("node").current_dir(&folder).arg("main.mjs"));
}

/// So do they in Python.
#[test]
#[ignore = "numpy"]
fn wrong_arguments_raise_in_python() {
    let folder = folder("python");
    let mut driver = String::from("import numpy as np\nfrom f import OPEN, CROSSED\n");
    for (name, tape) in tapes() {
        fs::write(folder.join(format!("{name}.py")), tape.python()).expect("the folder can be written");
        writeln!(driver, "from {name} import solve as {name}").unwrap();
        writeln!(
            driver,
            "{} = {}",
            if name == "f" {
                "ones".to_owned()
            } else {
                name.to_lowercase()
            },
            ones(&tape)
        )
        .unwrap();
    }
    driver.push_str(
        "L = {'r1': 90, 'r2': 30, 'r3': 80, 'r4': 70}\ndef check(call):\n    try:\n        call()\n        \
         print('right')\n    except Exception as error:\n        print(f'{type(error).__name__}: {error}')\n",
    );
    for (call, _) in PYTHON {
        writeln!(driver, "check(lambda: {call})").unwrap();
    }
    fs::write(folder.join("main.py"), driver).expect("the folder can be written");
    compare(PYTHON, Command::new("python3").current_dir(&folder).arg("main.py"));
}
