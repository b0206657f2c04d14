//! A sweep of 3600 poses through snap with its table, against the batch that it calls; and the questions to a sweep.
//!
//! `cargo bench -p kin-tests --bench sweep` prints lines `ratio NAME VALUE`, from times taken in one run.
#![allow(missing_docs, reason = "a program")]
#![allow(clippy::cast_precision_loss, reason = "there are thousands of poses")]

mod measure;

use core::f64::consts::TAU;
use core::hint::black_box;

use kin_core::any::{AssemblyChoice, PositionChoice};
use kin_core::batch::{Column, ColumnChoice, Outcome, Vectors};
use kin_core::library::{FourBar, FourBarBatch};
use kin_core::linkage::AnyLinkage;
use kin_core::prelude::*;
use kin_core::reaction::{NamedReactions, ReactionPart};
use measure::Race;

const POSES: usize = 3600;

mechanism! {
    /// Four-bar linkage with its bodies.
    struct Press { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    output pin: Point = r2 * cis(theta2);
    output knee: Point = r1 + r4 * cis(theta4);
    output pivot: Point = vec2(r1, 0);
    ground 0, pivot;
    body crank: 0, pin;
    body coupler: pin, knee;
    body rocker: pivot, knee;
}

/// The forces of a pose beside its motion through snap, and the peaks of all forces of a turn.
fn forces() {
    const POSES: usize = 64;
    const ROWS: usize = 361;
    // so many that the plan, which each batch makes once, counts for little
    const IN_LANES: usize = 4096;
    let press = Press {
        r1: 0.4,
        r2: 0.12,
        r3: 0.36,
        r4: 0.28,
    };
    let linkage = AnyLinkage::of(&press);
    let loads = linkage.loads().gravity(Plane::new(0.0, -9.81));
    let loads = loads.mass_of("coupler", 1.4, Plane::new(0.18, 0.02), 0.016);
    let loads = loads.and_then(|loads| loads.mass_of("rocker", 0.9, Plane::new(0.14, 0.0), 0.006));
    let loads = loads
        .and_then(|loads| loads.torque(-30.0, "theta4"))
        .expect("all names are there");
    let reactions = || linkage.reactions(&loads).expect("its bodies are declared");
    let all = reactions();
    let cranks: Vec<Motion> = (0..POSES)
        .map(|pose| Motion::at_constant_speed(TAU * pose as f64 / POSES as f64, 12.0))
        .collect();
    let mut race = Race::new(POSES);
    race.enter("forces.solve", cranks.clone(), move |crank| {
        black_box(press).solve(crank, Assembly::Open)
    });
    race.enter("forces.pose", cranks.clone(), |crank| {
        all.at(&[crank], PositionChoice::Assembly(0)).is_ok()
    });
    let mut prepared = all.prepared();
    race.enter_batch("forces.prepared_pose", move || {
        for crank in black_box(cranks.as_slice()) {
            let pose = prepared.at(&[*crank], PositionChoice::Assembly(0));
            black_box(&pose.expect("it closes"));
        }
    });
    let times = race.run();
    times.ratio("forces.pose", "forces.solve");
    times.ratio("forces.prepared_pose", "forces.solve");

    let angles: Vec<f64> = (0..IN_LANES).map(|pose| TAU * pose as f64 / IN_LANES as f64).collect();
    let crank = [Column::Each(&angles), Column::Same(12.0)];
    let given = [&crank[..]];
    let mut race = Race::new(IN_LANES);
    let cranks: Vec<Motion> = angles
        .iter()
        .map(|angle| Motion::at_constant_speed(*angle, 12.0))
        .collect();
    race.enter("forces.solve_alone", cranks, move |crank| {
        black_box(press).solve(crank, Assembly::Open)
    });
    let mut contenders = vec![
        ("forces.in_compiled_vectors", Vectors::Compiled),
        ("forces.in_avx2", Vectors::Avx2),
        ("forces.in_avx512", Vectors::Avx512),
    ];
    contenders.retain(|(_, vectors)| vectors.are_there());
    for &(name, vectors) in &contenders {
        let batch = all.batch(&given, ColumnChoice::Assembly(0)).vectors(vectors);
        let mut torques = vec![[0.0; 3]; IN_LANES];
        race.enter_batch(name, move || {
            let torque = batch.solve(
                |pose| pose.ok().and_then(|pose| pose.effort(0)).unwrap_or([f64::NAN; 3]),
                black_box(&mut torques),
            );
            torque.expect("the columns fit");
        });
    }
    let times = race.run();
    for (name, _) in contenders {
        times.ratio(name, "forces.solve_alone");
    }

    let turn = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.0], &[TAU], ROWS)
        .speed(12.0);
    let peaks = |reactions: &NamedReactions<'_>| {
        let names: Vec<&str> = reactions.names().collect();
        let peaks = names
            .into_iter()
            .map(|name| turn.of_reaction(reactions, name, ReactionPart::Force, 0).peak());
        let peaks: Result<Vec<_>, _> = peaks.collect();
        (peaks, turn.of_effort_with_friction(reactions, 0, 0).peak())
    };
    let mut race = Race::new(ROWS);
    race.enter_batch("forces.peaks_of_a_turn", || {
        // without what is remembered of the turn before
        black_box(&peaks(&reactions()));
    });
    race.enter_batch("forces.rows_of_a_turn", || {
        black_box(&turn.reactions(&all).expect("it moves"));
    });
    let times = race.run();
    times.ratio("forces.peaks_of_a_turn", "forces.rows_of_a_turn");
}

fn main() {
    forces();
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 70.0,
        r4: 60.0,
    };
    let angles: Vec<f64> = (0..POSES).map(|row| TAU * row as f64 / (POSES - 1) as f64).collect();
    let mut race = Race::new(POSES);
    // a table has columns of its own: the batch for the comparison makes them too
    let own = angles.clone();
    race.enter_batch("batch_into_new_columns", move || {
        let mut poses = FourBarBatch::filled(|| vec![0.0; POSES]);
        let mut outcomes = vec![Outcome::Unsolved; POSES];
        let mut crank = Motion::new([0.0; 5].map(Column::Same));
        (crank[0], crank[1]) = (Column::Each(black_box(&own)), Column::Same(10.0));
        let summary = black_box(linkage)
            .batch(crank, Assembly::Open)
            .solve(&mut poses, &mut outcomes)
            .expect("the columns are of one length");
        assert_eq!(summary.solved, POSES);
        black_box((&mut poses, &mut outcomes));
    });
    let (mut poses, mut outcomes) = (
        FourBarBatch::filled(|| vec![0.0; POSES]),
        vec![Outcome::Unsolved; POSES],
    );
    race.enter_batch("batch", move || {
        let mut crank = Motion::new([0.0; 5].map(Column::Same));
        (crank[0], crank[1]) = (Column::Each(black_box(&angles)), Column::Same(10.0));
        let summary = black_box(linkage)
            .batch(crank, Assembly::Open)
            .solve(&mut poses, &mut outcomes)
            .expect("the columns are of one length");
        assert_eq!(summary.solved, POSES);
        black_box((&mut poses, &mut outcomes));
    });
    let turn = move || {
        black_box(linkage)
            .sweep(Assembly::Open)
            .over(0.0..=TAU, POSES)
            .speed(10.0)
    };
    race.enter_batch("sweep", move || {
        black_box(&turn().table().expect("a turn has a table"));
    });
    let mut table = turn().table().expect("a turn has a table");
    race.enter_batch("sweep_into_table", move || {
        turn().fill_table(&mut table).expect("a turn has a table");
        black_box(&table);
    });
    race.enter_batch("peak_jerk", move || {
        black_box(&turn().of("theta4_jerk").peak().expect("a crank-rocker closes"));
    });
    let times = race.run();
    times.ratio("sweep_into_table", "batch");
    times.ratio("sweep", "batch_into_new_columns");
    times.ratio("sweep", "batch");
    times.ratio("peak_jerk", "batch");
}
