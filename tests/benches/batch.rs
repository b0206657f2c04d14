//! Many poses in one call.
#![allow(missing_docs, reason = "a program")]

mod measure;

use core::hint::black_box;

use kin_core::batch::{self, Column, Outcome, Vectors};
use kin_core::library::{FourBar, FourBarBatch};
use kin_core::prelude::*;
use kin_tests::notes::{self, four_bar_geometric, sample};
use kin_tests::random::Random;
use measure::Race;

/// Poses in each turn.
const POSES: usize = 1024;

fn main() {
    let r = sample::DIMENSIONS;
    let linkage = FourBar {
        r1: r.r1,
        r2: r.r2,
        r3: r.r3,
        r4: r.r4,
    };
    let mut random = Random::new(1);
    let motions: Vec<[f64; 5]> = (0..POSES)
        .map(|index| random.motion(-1.8 + 3.6 * (index as f64 + 0.5) / POSES as f64))
        .collect();
    let with_branches: Vec<_> = motions
        .iter()
        .map(|motion| {
            let branch = four_bar_geometric::Branch::closing(r, motion[0], notes::Assembly::Open);
            (*motion, branch)
        })
        .collect();
    let columns: Vec<Vec<f64>> = (0..5)
        .map(|order| motions.iter().map(|motion| motion[order]).collect())
        .collect();
    let mut race = Race::new(POSES);
    race.enter("four_bar.notes", with_branches, |(motion, branch)| {
        let r = black_box(r);
        four_bar_geometric::derivatives(r, motion, four_bar_geometric::position(r, motion[0], branch))
    });
    let typed = motions.iter().map(|motion| Motion::new(*motion)).collect::<Vec<_>>();
    race.enter("four_bar.generated", typed, |motion| {
        black_box(linkage).solve(motion, Assembly::Open)
    });
    for vectors in [Vectors::Compiled, Vectors::Avx2, Vectors::Avx512] {
        if !vectors.are_there() {
            continue;
        }
        let mut poses = FourBarBatch::filled(|| vec![0.0; POSES]);
        // the inputs are there already
        let mut poses = FourBarBatch::filled(|| Some(vec![0.0; POSES]));
        poses.theta2.as_mut().fill(None);
        let mut outcomes = vec![Outcome::Unsolved; POSES];
        let columns = &columns;
        race.enter_batch(format!("four_bar.batch.{vectors:?}"), move || {
            let inputs = Motion::new([0, 1, 2, 3, 4].map(|order| Column::Each(black_box(&columns[order]))));
            let summary = batch::solve::<FourBar, _, _>(
                linkage.parameters().map(Column::Same),
                [inputs],
                Assembly::Open,
                &mut poses,
                &mut outcomes,
                vectors,
            )
            .expect("lengths");
            assert_eq!(summary.solved, POSES);
            black_box(&mut poses);
        });
    }
    let times = race.run();
    times.ratio("four_bar.generated", "four_bar.notes");
    times.ratio("four_bar.batch.Compiled", "four_bar.notes");
    times.ratio("four_bar.batch.Avx2", "four_bar.notes");
    times.ratio("four_bar.batch.Avx512", "four_bar.notes");
}
