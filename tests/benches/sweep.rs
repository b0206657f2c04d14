//! A sweep of 3600 poses through snap with its table, against the batch that it calls; and the questions to a sweep.
//!
//! `cargo bench -p kin-tests --bench sweep` prints lines `ratio NAME VALUE`, from times taken in one run.
#![allow(missing_docs, reason = "a program")]
#![allow(clippy::cast_precision_loss, reason = "there are thousands of poses")]

mod measure;

use core::f64::consts::TAU;
use core::hint::black_box;

use kin_core::batch::{Column, Outcome};
use kin_core::library::{FourBar, FourBarBatch};
use kin_core::prelude::*;
use measure::Race;

const POSES: usize = 3600;

fn main() {
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
