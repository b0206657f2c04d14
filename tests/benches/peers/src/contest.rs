//! A race of kin's solvers and of the packages of others along a course.

use core::hint::black_box;
use std::fs;
use std::path::Path;
use std::process::Command;

use kin_core::Prepared;
use kin_core::any::{Described as _, Of};
use kin_core::batch::{AnyBatch as _, Column, ColumnChoice, GivenColumns, Outcome, Slot, Vectors, WantedColumns};
use kin_core::tape::{self, Options};
use kin_tests::mechanisms::cases::ThroughSnap;

use crate::environment::{Environment, build, run};
use crate::floor::Units;
use crate::kin::{Written, assert_equal};
use crate::linkages::{Course, Visitor};
use crate::race::Race;
use crate::solved::Wanted;

/// How often each contender has its turn, on a short and on a long course.
const TURNS: [usize; 2] = [100, 20];

/// The orders of a motion through snap.
const ORDERS: usize = 5;

/// The flags for kin's C: the usual ones, and all that the machine has. Products and sums are not fused, so that the
/// numbers are those of `solve`.
const FLAGS: [(&str, &[&str]); 2] = [
    ("O2", &["-O2", "-ffp-contract=off"]),
    ("native", &["-O3", "-march=native", "-ffp-contract=off"]),
];

/// Those for the C of others, which promises no bits.
const FREE_FLAGS: [(&str, &[&str]); 3] = [
    ("O2", &["-O2"]),
    ("native", &["-O3", "-march=native"]),
    ("fast", &["-O3", "-march=native", "-ffast-math"]),
];

/// Linkages of whose closed form `SymPy` makes C within seconds.
const SMALL: [&str; 3] = ["four_bar", "slider_crank", "inverted_slider_crank"];

/// Races along all courses, or along those whose name has a part.
pub(crate) struct Contests<'a> {
    pub(crate) environment: &'a Environment,
    pub(crate) part: String,
    /// The times of which floors consist.
    pub(crate) units: Option<Units>,
    /// The lines of the end: for each course and each class the time of kin, that of the best other, and their ratio.
    pub(crate) standings: Vec<String>,
}

impl Visitor for Contests<'_> {
    fn visit<M: ThroughSnap>(&mut self, course: Course<M>) {
        if course.name().contains(&self.part) {
            let times = contest(self.environment, &course);
            self.standings.extend(standings(&course.name(), &times));
            let of_batch = times.iter().find(|(name, _)| name == "kin.batch");
            if let (Some(units), Some((_, time)), true) = (&self.units, of_batch, M::ASSEMBLY_COUNT > 0) {
                let floor = units.floor::<M>(course.is_long());
                let ratio = time / floor;
                self.standings.push(format!(
                    "ratio {}.batch/floor {ratio:.2} ({time:.1} ns, {floor:.1} ns)",
                    course.name()
                ));
            }
        }
    }
}

/// The times of all contenders.
fn contest<M: ThroughSnap>(environment: &Environment, course: &Course<M>) -> Vec<(String, f64)> {
    let Course {
        linkage,
        mechanism,
        wanted,
        ..
    } = course;
    let (mechanism, is_long) = (*mechanism, course.is_long());
    let rows: Vec<Vec<f64>> = wanted.iter().map(|own| own.arguments(mechanism)).collect();
    let solved: Vec<f64> = wanted.iter().flat_map(|own| own.results(mechanism)).collect();
    let width = solved.len() / rows.len();
    let folder = environment.folder.join(course.name());
    let tape = tape::record::<M>(&Options::new()).expect("all are recorded");
    let written = Written::new(&tape, &folder, &rows);
    let mut race = Race::new(rows.len(), TURNS[usize::from(is_long)]);

    for (name, vectors) in [("kin.batch", Vectors::Avx512), ("kin.batch.avx2", Vectors::Avx2)] {
        if vectors.are_there() {
            race.enter(name, batch(mechanism, wanted, vectors));
        }
    }
    if !is_long {
        let prepared = Prepared::of(mechanism);
        race.enter_each("kin.solve", wanted.clone(), |own| own.solve(black_box(&mechanism)));
        race.enter_each("kin.prepared", wanted.clone(), move |own| {
            own.solve_prepared(black_box(&prepared))
        });
        if let Some(native) = &environment.native {
            for way in ["solve", "prepared"] {
                let (name, command) = (format!("kin.{way}.native"), &mut Command::new(native));
                let found = race.enter_program(&name, &folder, command.args(["--turns", &course.name(), way]));
                assert_close(&name, &found, &solved, width);
            }
        }
        for (word, flags) in FLAGS {
            let name = format!("kin.c.{word}");
            let found = written.enter_c(&mut race, &name, &folder, rows.len(), flags);
            assert_equal(&name, &found, &solved);
        }
        for (package, writer, way) in [
            ("casadi", "by_casadi.py", None),
            ("casadi", "by_casadi.py", Some("constant")),
            ("sympy", "by_sympy.py", None),
        ] {
            if !environment.has(package) || package == "sympy" && !SMALL.contains(linkage) {
                continue;
            }
            let contender = [Some(package), way].into_iter().flatten().collect::<Vec<_>>().join(".");
            // CasADi makes a name of C of it
            let file = format!("{}.c", contender.replace('.', "_"));
            run(environment
                .python()
                .current_dir(&folder)
                .arg(Environment::program(writer))
                .args([linkage, file.as_str()])
                .args(way));
            for (word, flags) in FREE_FLAGS {
                let name = format!("{contender}.c.{word}");
                build(&folder, &[&file], flags, [rows.len(), rows[0].len(), width], &name);
                let found = race.enter_program(&name, &folder, &mut Command::new(folder.join(&name)));
                assert_close(&name, &found, &solved, width);
            }
        }
    }
    let mut enter_python = |name: &str, module: &str, ways: &[&str]| {
        let mut command = environment.python();
        command.arg(Environment::program("turns.py")).args([module, linkage]);
        command.arg(rows[0].len().to_string()).args(ways);
        race.enter_program(name, &folder, &mut command)
    };
    if environment.has("heyoka") {
        for way in ["batch", "batch.fast", "batch.avx2", "batch.avx2.fast"] {
            let name = format!("heyoka.{way}");
            let found = enter_python(&name, "by_heyoka", &[way]);
            assert_close(&name, &found, &solved, width);
        }
    }
    // This package sweeps, and finds positions.
    if course.kind == "sweep" && ["four_bar", "slider_crank"].contains(linkage) && environment.has("pylinkage") {
        let name = "pylinkage.positions";
        let found = enter_python(name, "by_pylinkage", &[]);
        let positions: Vec<f64> = solved.chunks(ORDERS).map(|motion| motion[0]).collect();
        assert_close(name, &found, &positions, width / ORDERS);
    }

    let times = race.run();
    for (name, time) in &times {
        println!("time {}.{name} {time:.1} ns", course.name());
    }
    tidy(&folder);
    times
}

/// A batch of all poses. The columns are made beforehand, and are rows of an array as those of the other packages are.
fn batch<M: ThroughSnap>(mechanism: M, wanted: &[Wanted<M>], vectors: Vectors) -> impl FnMut() {
    let functions = Of::<M>::FUNCTIONS;
    let description = functions.description();
    let count = wanted.len();
    let inputs = (0..description.inputs.len())
        .flat_map(|input| (0..ORDERS).flat_map(move |order| wanted.iter().map(move |own| own.inputs[input][order])));
    let near = (0..description.unknowns.len())
        .flat_map(|unknown| wanted.iter().filter_map(move |own| own.near.map(|near| near[unknown])));
    let given: Vec<f64> = inputs.chain(near).collect();
    let assembly = wanted[0].assembly;
    let unknowns =
        (0..description.unknowns.len()).flat_map(|index| (0..ORDERS).map(move |order| Slot::Unknown(index, order)));
    let outputs =
        (0..description.outputs.len()).flat_map(|index| (0..ORDERS).map(move |order| Slot::Output(index, order)));
    let slots: Vec<Slot> = unknowns.chain(outputs).collect();
    let mut found = vec![0.0; slots.len() * count];
    let mut outcomes = vec![Outcome::Unsolved; count];
    move || {
        let parameters: Vec<Column<'_>> = black_box(mechanism)
            .parameters()
            .as_ref()
            .iter()
            .map(|value| Column::Same(*value))
            .collect();
        let columns: Vec<Column<'_>> = black_box(&given).chunks(count).map(Column::Each).collect();
        let (inputs, near) = columns.split_at(ORDERS * description.inputs.len());
        let inputs: Vec<&[Column<'_>]> = inputs.chunks(ORDERS).collect();
        let given = GivenColumns {
            parameters: &parameters,
            inputs: &inputs,
            choice: if M::ASSEMBLY_COUNT == 0 {
                ColumnChoice::Near(near)
            } else {
                ColumnChoice::Assembly(assembly)
            },
        };
        let mut found = WantedColumns::new(slots.iter().copied().zip(found.chunks_mut(count)).collect());
        let summary = functions.solve_batch(given, &mut found, &mut outcomes, vectors);
        assert_eq!(summary.expect("the columns are of one length").solved, count);
        black_box((&mut found, &mut outcomes));
    }
}

/// The best of kin beside the best of others, in each class of contenders.
fn standings(course: &str, times: &[(String, f64)]) -> Vec<String> {
    type Class = (&'static str, fn(&str) -> bool);
    const CLASSES: [Class; 4] = [
        ("scalar", |name| {
            name.contains(".solve") || name.contains(".c.") && !name.contains(".constant")
        }),
        ("prepared", |name| {
            name.contains(".prepared") || name.contains(".constant")
        }),
        ("batch", |name| name.contains(".batch") && !name.contains(".avx2")),
        ("batch.avx2", |name| name.contains(".batch.avx2")),
    ];
    let best = |is_kin: bool, is_member: fn(&str) -> bool| {
        let members = times
            .iter()
            .filter(|(name, _)| is_member(name) && name.starts_with("kin.") == is_kin);
        members.min_by(|(_, one), (_, other)| one.total_cmp(other))
    };
    let lines = CLASSES.into_iter().filter_map(|(class, is_member)| {
        let (own, time) = best(true, is_member)?;
        let (other, other_time) = best(false, is_member)?;
        let ratio = time / other_time;
        Some(format!(
            "ratio {course}.{class} {ratio:.3} ({own} {time:.1} ns, {other} {other_time:.1} ns)"
        ))
    });
    lines.collect()
}

/// Asserts that a contender with formulas of its own has found the same numbers. Between the limits of motion rounding
/// stays far below the tolerance, which is a part of the largest number of the same column.
fn assert_close(name: &str, own: &[f64], solved: &[f64], width: usize) {
    const TOLERANCE: f64 = 1e-9;
    assert_eq!(own.len(), solved.len(), "{name}");
    let mut largest = vec![0.0_f64; width];
    for row in solved.chunks(width) {
        for (largest, number) in largest.iter_mut().zip(row) {
            *largest = largest.max(number.abs());
        }
    }
    for (index, (one, other)) in own.iter().zip(solved).enumerate() {
        let difference = (one - other).abs();
        assert!(
            difference <= TOLERANCE * largest[index % width],
            "{name}: {one} is not {other}, at {index}"
        );
    }
}

/// Nobody reads again what contenders have found.
fn tidy(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if entry.path().extension().is_some_and(|extension| extension == "out") {
            let _ = fs::remove_file(entry.path());
        }
    }
}
