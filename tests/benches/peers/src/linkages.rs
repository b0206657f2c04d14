//! Two linkages through kin in every language and through the packages of others: random poses, and a sweep.

use core::f64::consts::TAU;
use core::hint::black_box;
use std::fs;
use std::path::Path;
use std::process::Command;

use kin_core::Row as _;
use kin_core::batch::{Column, Outcome};
use kin_core::library::{FourBar, FourBarBatch, SliderCrank, SliderCrankBatch};
use kin_core::prelude::*;
use kin_core::tape::{self, Options};
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::random::Random;

use crate::environment::{Environment, build, run};
use crate::kin::{Written, assert_equal};
use crate::race::Race;
use crate::solved::Wanted;

const POSES: usize = 512;
const SWEEP: usize = 3600;
const TURNS: usize = 100;

/// The columns of results through snap: those of two unknowns.
const RESULTS: usize = 10;

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

/// A batch of kin: the motions of the crank as columns, to the motions of both unknowns, column by column.
type Batch<'a> = &'a mut dyn FnMut(&[Vec<f64>; 5]);

/// Random poses, and a sweep of one turn, of both linkages.
pub(crate) fn race_all(environment: &Environment) {
    let mut random = Random::new(8);
    let mut scattered = |reach: f64| -> Vec<[f64; 5]> {
        (0..POSES)
            .map(|_| {
                let angle = random.between(-reach, reach);
                random.motion(angle)
            })
            .collect()
    };
    let sweep: Vec<[f64; 5]> = (0..SWEEP)
        .map(|row| {
            #[allow(clippy::cast_precision_loss, reason = "there are thousands")]
            let fraction = row as f64 / SWEEP as f64;
            [TAU * fraction, 10.0, 0.0, 0.0, 0.0]
        })
        .collect();
    // The first one has limits at 1.96 rad; the second one turns.
    let rocker = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let turning = FourBar {
        r3: 70.0,
        r4: 60.0,
        ..rocker
    };
    let piston = SliderCrank { r: 0.4, l: 1.1 };
    for (kind, linkage, motions) in [("poses", rocker, scattered(1.8)), ("sweep", turning, sweep.clone())] {
        let mut poses = FourBarBatch::filled(|| vec![0.0; motions.len()]);
        let mut outcomes = vec![Outcome::Unsolved; motions.len()];
        let mut batch = |columns: &[Vec<f64>; 5]| {
            let crank = Motion::new(core::array::from_fn(|order| Column::Each(columns[order].as_slice())));
            let summary = black_box(linkage)
                .batch(crank, Assembly::Open)
                .solve(&mut poses, &mut outcomes);
            assert_eq!(summary.expect("the columns are of one length").solved, columns[0].len());
            black_box((&mut poses, &mut outcomes));
        };
        race(environment, "four_bar", kind, linkage, &motions, &mut batch);
    }
    for (kind, motions) in [("poses", scattered(3.1)), ("sweep", sweep)] {
        let mut poses = SliderCrankBatch::filled(|| vec![0.0; motions.len()]);
        let mut outcomes = vec![Outcome::Unsolved; motions.len()];
        let mut batch = |columns: &[Vec<f64>; 5]| {
            let crank = Motion::new(core::array::from_fn(|order| Column::Each(columns[order].as_slice())));
            let summary = black_box(piston)
                .batch(crank, Assembly::Open)
                .solve(&mut poses, &mut outcomes);
            assert_eq!(summary.expect("the columns are of one length").solved, columns[0].len());
            black_box((&mut poses, &mut outcomes));
        };
        race(environment, "slider_crank", kind, piston, &motions, &mut batch);
    }
}

fn race<M: ThroughSnap>(
    environment: &Environment,
    linkage: &str,
    kind: &str,
    mechanism: M,
    motions: &[[f64; 5]],
    batch: Batch<'_>,
) {
    let wanted: Vec<Wanted<M>> = motions
        .iter()
        .map(|motion| Wanted::at(M::Inputs::from_fn(|_| Motion::new(*motion))))
        .collect();
    let rows: Vec<Vec<f64>> = wanted.iter().map(|own| own.arguments(mechanism)).collect();
    let solved: Vec<f64> = wanted.iter().flat_map(|own| own.results(mechanism)).collect();
    let folder = environment.folder.join(format!("{linkage}_{kind}"));
    let tape = tape::record::<M>(&Options::new()).expect("both are recorded");
    let written = Written::new(&tape, &folder, &rows);

    let columns: [Vec<f64>; 5] = core::array::from_fn(|order| motions.iter().map(|motion| motion[order]).collect());
    let mut race = Race::new(rows.len(), TURNS);
    race.enter_each("kin.solve", wanted, |own| own.solve(black_box(mechanism)));
    race.enter("kin.batch", || batch(black_box(&columns)));
    for (word, flags) in FLAGS {
        let name = format!("kin.c.{word}");
        let found = written.enter_c(&mut race, &name, &folder, rows.len(), flags);
        assert_equal(&name, &found, &solved);
    }
    let found = written.enter_java_script(&mut race, "kin.javascript", &folder);
    assert_equal("kin.javascript", &found, &solved);
    let found = written.enter_python(&mut race, "kin.numpy", &folder, environment);
    assert_equal("kin.numpy", &found, &solved);

    let width = rows[0].len();
    for (package, writer) in [("casadi", "by_casadi.py"), ("sympy", "by_sympy.py")] {
        if !environment.has(package) {
            continue;
        }
        let file = format!("{package}.c");
        run(environment
            .python()
            .current_dir(&folder)
            .arg(Environment::program(writer))
            .args([linkage, file.as_str()]));
        for (word, flags) in FREE_FLAGS {
            let name = format!("{package}.c.{word}");
            build(&folder, &[&file], flags, [rows.len(), width, RESULTS], &name);
            let found = race.enter_program(&name, &folder, &mut Command::new(folder.join(&name)));
            assert_close(&name, &found, &solved);
        }
    }
    for (package, name, module) in [
        ("sympy", "sympy.numpy", "by_sympy"),
        ("heyoka", "heyoka.batch", "by_heyoka"),
        ("pylinkage", "pylinkage.positions", "by_pylinkage"),
    ] {
        // This package sweeps, and finds positions.
        let has_positions_alone = package == "pylinkage";
        if !environment.has(package) || has_positions_alone && kind != "sweep" {
            continue;
        }
        let mut command = environment.python();
        command.arg(Environment::program("turns.py")).args([module, linkage]);
        let found = race.enter_program(name, &folder, command.arg(width.to_string()));
        if has_positions_alone {
            let positions: Vec<f64> = solved.chunks(RESULTS / 2).map(|motion| motion[0]).collect();
            assert_close(name, &found, &positions);
        } else {
            assert_close(name, &found, &solved);
        }
    }

    let times = race.run();
    let (_, of_solve) = times[0];
    for (name, time) in &times {
        println!("time {linkage}.{kind}.{name} {time:.1} ns");
    }
    for (name, time) in &times[1..] {
        println!("ratio {linkage}.{kind}.{name}/kin.solve {:.3}", time / of_solve);
    }
    tidy(&folder);
}

/// Asserts that a contender with formulas of its own has found the same numbers. Between the limits of motion rounding
/// stays far below the tolerance, which is a part of the largest number of the same order.
fn assert_close(name: &str, own: &[f64], solved: &[f64]) {
    const TOLERANCE: f64 = 1e-9;
    assert_eq!(own.len(), solved.len(), "{name}");
    let width = if solved.len().is_multiple_of(RESULTS) {
        RESULTS
    } else {
        2
    };
    let mut largest = vec![0.0_f64; width];
    for row in solved.chunks(width) {
        for (largest, number) in largest.iter_mut().zip(row) {
            *largest = largest.max(number.abs());
        }
    }
    for (place, (one, other)) in own.iter().zip(solved).enumerate() {
        let difference = (one - other).abs();
        assert!(
            difference <= TOLERANCE * largest[place % width],
            "{name}: {one} is not {other}, at {place}"
        );
    }
}

/// What contenders have found is not needed again.
fn tidy(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if entry.path().extension().is_some_and(|extension| extension == "out") {
            let _ = fs::remove_file(entry.path());
        }
    }
}
