//! Exact tables in other languages, read at random places.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use kin_core::exact::ExactTable;
use kin_core::library::{FourBar, JansenLeg, SliderCrank};
use kin_core::prelude::*;
use kin_core::verify::Random;

/// The number of random places of each table.
const PLACES: u32 = 1000;

/// A closed table with turns, one of a part of a turn, one through limits, one of a lower order, and one whose name is
/// a trap.
fn tables() -> Vec<ExactTable> {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let drag_link = FourBar {
        r1: 30.0,
        r2: 80.0,
        r3: 70.0,
        r4: 90.0,
    };
    let press = SliderCrank { r: 0.1, l: 0.3 };
    let walk = JansenLeg::HOLY_NUMBERS.sweep(JansenLeg::WALKING).over(0.0..=TAU, 13);
    let turn = drag_link.sweep(Assembly::Open).over(0.0..=TAU, 9);
    vec![
        turn.exact_table(1e-6).unwrap(),
        press
            .sweep(Assembly::Open)
            .over(0.5..=2.0, 3)
            .exact_table(1e-6)
            .unwrap(),
        linkage
            .sweep(Assembly::Open)
            .over(0.9..=1.0, 2)
            .exact_circuit(1e-5)
            .unwrap(),
        walk.exact_table([1e-6, 1e-5, 1e-4]).unwrap().named("Leg").unwrap(),
        turn.exact_table([1e-4, 1e-3])
            .unwrap()
            .named("int */ \"\\ \u{2028} θ `${x}`")
            .unwrap(),
    ]
}

/// Places inside of a table and, with speeds, beyond it.
fn places(table: &ExactTable) -> Vec<[f64; 2]> {
    let (low, high) = (*table.range().start(), *table.range().end());
    let mut random = Random::new(13);
    let mut places: Vec<[f64; 2]> = (0..PLACES)
        .map(|index| {
            let way = high - low;
            let beyond = if index % 10 == 0 { 3.0 * way } else { 0.0 };
            [random.between(low - beyond, high + beyond), random.between(-20.0, 20.0)]
        })
        .collect();
    places.extend([[low, 1.0], [high, 1.0], [low, 0.0]]);
    // as far as a part of a period can be told, and further
    places.extend([1e9, -1e12, 1e14, 1e300, -f64::MAX].map(|at| [at, 1.0]));
    places.extend(table.parts().rows.iter().map(|row| [row[0], 2.0]));
    places
}

/// The numbers at a place, or none beyond the table.
fn expected(table: &ExactTable, [at, speed]: [f64; 2]) -> Option<Vec<f64>> {
    let mut numbers = vec![0.0; table.columns().len() * (table.order() + 1)];
    table.fill_at_speed(at, speed, &mut numbers).ok().map(|()| numbers)
}

/// Compares what a program has written: a line for each place, with numbers or one word.
fn compare(table: &ExactTable, text: &str) {
    let places = places(table);
    assert_eq!(text.lines().count(), places.len(), "{}", table.name());
    let mut found = 0;
    for (place, line) in places.into_iter().zip(text.lines()) {
        let own: Option<Vec<u64>> =
            expected(table, place).map(|own| own.iter().map(|number| number.to_bits()).collect());
        let other: Option<Vec<u64>> = line
            .split_whitespace()
            .map(|word| word.parse::<f64>().map(f64::to_bits).ok())
            .collect();
        assert_eq!(own, other, "{} at {place:?}: {line}", table.name());
        found += usize::from(own.is_some());
    }
    assert!(found > 900, "{found}");
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("exact").join(name);
    fs::create_dir_all(&folder).expect("the folder of temporary files can be written");
    folder
}

/// What a program writes that reads the places.
fn written(table: &ExactTable, program: &mut Command, folder: &Path) -> String {
    let mut lines = String::new();
    for [at, speed] in places(table) {
        writeln!(lines, "{at:?} {speed:?}").expect("a string takes what is written");
    }
    fs::write(folder.join("places"), lines).expect("the folder can be written");
    let output = program
        .current_dir(folder)
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .stdin(Stdio::from(
            fs::File::open(folder.join("places")).expect("it was written"),
        ))
        .output()
        .expect("the program can be run");
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && told.is_empty(), "{}: {told}", table.name());
    String::from_utf8(output.stdout).expect("it writes numbers")
}

/// The C code of every table passes strict compilation and finds the numbers of the table to the last bit.
#[test]
#[ignore = "gcc"]
fn exact_tables_in_c_by_gcc() {
    for (index, table) in tables().iter().enumerate() {
        let folder = folder(&format!("c{index}"));
        let c = table.c();
        fs::write(folder.join(format!("{}.h", c.name)), &c.header).expect("the folder can be written");
        fs::write(folder.join(format!("{}.c", c.name)), &c.source).expect("the folder can be written");
        fs::write(folder.join("main.c"), &c.example).expect("the folder can be written");
        // the last one is run, at the level that the book advises
        for level in ["-O3", "-Os", "-O2"] {
            let output = Command::new("gcc")
                .current_dir(&folder)
                .args([
                    "-std=c99",
                    level,
                    "-ffp-contract=off",
                    "-Wall",
                    "-Wextra",
                    "-Wconversion",
                ])
                .args(["-Wpedantic", "-Wdouble-promotion", "-Werror", "main.c"])
                .args([&format!("{}.c", c.name), "-lm", "-o", "program"])
                .output()
                .expect("gcc is installed");
            let told = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{} {level}: {told}", c.name);
        }
        compare(table, &written(table, &mut Command::new("./program"), &folder));
        println!(
            "{}: {} bytes of C, {} binary",
            c.name,
            c.source.len(),
            table.as_bytes().len()
        );
    }
}

/// The module of every table finds the numbers of the table to the last bit.
#[test]
#[ignore = "node"]
fn exact_tables_in_java_script_by_node() {
    let driver = r#"
import { readFileSync } from "node:fs";
import { COLUMNS, ERRORS, ORDERS, at } from "./table.mjs";
if (COLUMNS.length !== ERRORS.length || ERRORS[0].length !== ORDERS) throw new Error("errors");
for (const line of readFileSync(0, "utf8").trim().split("\n")) {
    const [place, speed] = line.split(" ").map(Number);
    try {
        console.log(at(place, speed).flat().map((own) => (Object.is(own, -0) ? "-0" : String(own))).join(" "));
    } catch (error) {
        if (!(error instanceof RangeError)) throw error;
        console.log("beyond");
    }
}
"#;
    for (index, table) in tables().iter().enumerate() {
        let folder = folder(&format!("java-script{index}"));
        fs::write(folder.join("table.mjs"), table.java_script()).expect("the folder can be written");
        fs::write(folder.join("main.mjs"), driver).expect("the folder can be written");
        compare(table, &written(table, Command::new("node").arg("main.mjs"), &folder));
    }
}

/// The module of every table finds the numbers of the table to the last bit.
#[test]
#[ignore = "python3"]
fn exact_tables_in_python() {
    let driver = "
import sys
from table import COLUMNS, ERRORS, ORDERS, at

assert len(COLUMNS) == len(ERRORS) and len(ERRORS[0]) == ORDERS
for line in sys.stdin:
    place, speed = map(float, line.split())
    try:
        print(*(number for column in at(place, speed) for number in column))
    except ValueError:
        print('beyond')
";
    for (index, table) in tables().iter().enumerate() {
        let folder = folder(&format!("python{index}"));
        fs::write(folder.join("table.py"), table.python()).expect("the folder can be written");
        fs::write(folder.join("main.py"), driver).expect("the folder can be written");
        compare(table, &written(table, Command::new("python3").arg("main.py"), &folder));
    }
}
