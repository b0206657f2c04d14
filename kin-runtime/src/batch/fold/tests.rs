//! Folds find what a plain loop over a stored batch finds.

use std::vec;
use std::vec::Vec;

use super::{Fold, FoldError, Folded, FoldedNumber, InputGrid};
use crate::batch::{Batch, Column, LengthMismatch, Outcome, Slot, Vectors};
use crate::library::{FourBar, FourBarBatch};
use crate::prelude::*;

/// It does not close over the whole revolution.
const LINKAGE: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 40.0,
    r4: 45.0,
};

/// It closes over the whole revolution.
const CRANK_ROCKER: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 80.0,
    r4: 60.0,
};

const SNAP: Slot = Slot::Unknown(1, 4);
const POSITION: Slot = Slot::Unknown(1, 0);

fn vectors() -> impl Iterator<Item = Vectors> {
    [Vectors::Compiled, Vectors::Avx2, Vectors::Avx512]
        .into_iter()
        .filter(|vectors| vectors.are_there())
}

fn same(linkage: FourBar) -> [Column<'static>; 4] {
    linkage.parameters().map(Column::Same)
}

fn crank(positions: Column<'_>) -> [Motion<Column<'_>, 5>; 1] {
    [Motion::new([
        positions,
        2.0.into(),
        0.5.into(),
        Column::Same(-1.0),
        0.25.into(),
    ])]
}

/// The summary by a plain loop, with the sums one value after the other.
fn plain(values: impl Iterator<Item = f64>) -> Folded {
    let mut folded = Folded::default();
    for (pose, value) in values.enumerate().filter(|(_, value)| !value.is_nan()) {
        folded.count += 1;
        if folded.least.is_none_or(|(_, least)| value < least) {
            folded.least = Some((pose, value));
        }
        if folded.greatest.is_none_or(|(_, greatest)| value > greatest) {
            folded.greatest = Some((pose, value));
        }
        folded.sum += value;
        folded.sum_of_squares += value * value;
    }
    folded
}

/// Extremes agree to the last bit. Sums have their terms in another order.
fn agree(found: &Folded, values: &[f64], context: &str) {
    let expected = plain(values.iter().copied());
    assert_eq!(found.count, expected.count, "{context}");
    assert_eq!(found.least, expected.least, "{context}");
    assert_eq!(found.greatest, expected.greatest, "{context}");
    let size = |power: i32| -> f64 {
        let sizes = values.iter().filter(|value| !value.is_nan());
        sizes.map(|value| value.abs().powi(power)).sum()
    };
    // Each addition of either order rounds by ε/2 of at most the sum of the sizes.
    let tolerance = f64::EPSILON * f64::from(u32::try_from(values.len()).unwrap());
    assert!((found.sum - expected.sum).abs() <= tolerance * size(1), "{context}");
    assert!(
        (found.sum_of_squares - expected.sum_of_squares).abs() <= tolerance * size(2),
        "{context}"
    );
}

#[test]
fn folds_find_what_a_loop_over_a_batch_finds() {
    for vectors in vectors() {
        for count in [0, 1, 3, 16, 17, 511, 512, 527, 528, 529, 1100] {
            let angles: Vec<f64> = (0..count).map(|index| 4.0 * f64::from(index) / 1100.0 - 2.0).collect();
            let couplers: Vec<f64> = (0..count).map(|index| 40.0 + f64::from(index % 7)).collect();
            let count = angles.len();
            let mut parameters = same(LINKAGE);
            parameters[2] = Column::Each(&couplers);
            let inputs = crank(Column::Each(&angles));
            let mut poses = FourBarBatch::filled(|| vec![0.0; count]);
            let mut outcomes = vec![Outcome::Unsolved; count];
            let assembly = Assembly::Open;
            let expected = Batch::<FourBar, _>::new(parameters, inputs, assembly)
                .vectors(vectors)
                .solve(&mut poses, &mut outcomes)
                .unwrap();
            let numbers = [Slot::Input(0, 0), POSITION, Slot::Unknown(0, 2), SNAP, POSITION];
            let mut folds = numbers.map(Fold::of);
            let summary = Batch::<FourBar, _>::new(parameters, inputs, assembly)
                .vectors(vectors)
                .fold(count, &mut folds)
                .unwrap();
            assert_eq!((summary.solved, summary.failed), (expected.solved, expected.failed));
            assert_eq!(summary.first_failure, expected.first_failure);
            // An input is not summarised where the pose fails, though the batch stores it there.
            let solved = |column: &[f64]| -> Vec<f64> {
                let outcomes = outcomes.iter();
                let value = |(value, outcome): (&f64, &Outcome)| if outcome.is_solved() { *value } else { f64::NAN };
                column.iter().zip(outcomes).map(value).collect()
            };
            let columns = [
                &poses.theta2[0],
                &poses.theta4[0],
                &poses.theta3[2],
                &poses.theta4[4],
                &poses.theta4[0],
            ];
            for (fold, column) in folds.iter().zip(columns) {
                agree(
                    fold.folded(),
                    &solved(column),
                    &std::format!("{vectors:?} {count} {:?}", fold.number()),
                );
            }
            assert!(count < 1100 || (expected.failed > 100 && expected.solved > 300));
        }
    }
}

/// The angles of a revolution are made on the way. The transmission angle is that of single poses.
#[test]
fn a_grid_needs_no_column() {
    let grid = InputGrid::revolution(0, 720);
    let angles: Vec<f64> = (0..720).map(|index| grid.value(index)).collect();
    for (vectors, linkage) in vectors().flat_map(|vectors| [(vectors, LINKAGE), (vectors, CRANK_ROCKER)]) {
        for assembly in Assembly::BOTH {
            let numbers = [
                FoldedNumber::At(SNAP),
                FoldedNumber::TransmissionAngle(0),
                FoldedNumber::SmallestTransmissionAngle,
            ];
            let mut folds = numbers.map(Fold::of);
            let mut by_column = folds;
            let inputs = crank(Column::Same(f64::NAN));
            let summary = Batch::<FourBar, _>::new(same(linkage), inputs, assembly)
                .vectors(vectors)
                .fold(grid, &mut folds)
                .unwrap();
            let inputs = crank(Column::Each(&angles));
            let expected = Batch::<FourBar, _>::new(same(linkage), inputs, assembly)
                .vectors(vectors)
                .fold(720, &mut by_column)
                .unwrap();
            assert_eq!(summary, expected);
            for (fold, by_column) in folds.iter().zip(&by_column) {
                assert_eq!(fold.folded(), by_column.folded());
            }
            assert_eq!(folds[1].folded(), folds[2].folded());
            let transmission = angles.iter().map(|angle| {
                let pose = linkage.position(*angle, assembly);
                pose.map_or(f64::NAN, |pose| {
                    Mechanism::transmission_angles(&linkage, &pose)[0].folded()
                })
            });
            let (expected, found) = (plain(transmission), folds[1].folded());
            assert_eq!(found.count, expected.count);
            let error = found.least.unwrap().1 - expected.least.unwrap().1;
            // The angles of the links are not close to a limit at these poses, by more than a degree.
            assert!(error.abs() <= 1e-13, "{vectors:?} {error:e}");
            let error = found.mean().unwrap() - expected.mean().unwrap();
            assert!(error.abs() <= 1e-13, "{vectors:?} {error:e}");
        }
    }
}

/// Poses in lanes and poses alone have the same transmission angles on both sides of zero.
#[test]
fn transmission_angles_need_no_common_sign() {
    let angles: Vec<f64> = (0..64).map(|index| 0.1 * f64::from(index)).collect();
    let assembly: Vec<f64> = (0..64).map(|index| if index % 3 == 0 { 1.0 } else { -1.0 }).collect();
    let near: Vec<[f64; 2]> = angles
        .iter()
        .zip(&assembly)
        .map(|(angle, sign)| {
            let assembly = if *sign > 0.0 { Assembly::Open } else { Assembly::Crossed };
            CRANK_ROCKER.position(*angle, assembly).unwrap().unknowns()
        })
        .collect();
    let near: [Vec<f64>; 2] = [0, 1].map(|unknown| near.iter().map(|near| near[unknown]).collect());
    let near_columns = [Column::Each(&near[0]), Column::Each(&near[1])];
    for vectors in vectors() {
        let mut folds = [Fold::of(FoldedNumber::SmallestTransmissionAngle)];
        let inputs = crank(Column::Each(&angles));
        let summary = Batch::<FourBar, _>::near(same(CRANK_ROCKER), inputs, near_columns)
            .vectors(vectors)
            .fold(64, &mut folds)
            .unwrap();
        assert_eq!(summary.solved, 64);
        let expected = plain((0..64).map(|pose| {
            let difference: f64 = near[0][pose] - near[1][pose];
            let angle = difference.cos().clamp(-1.0, 1.0).acos();
            angle.min(core::f64::consts::PI - angle)
        }));
        let found = folds[0].folded();
        assert_eq!(found.least.unwrap().0, expected.least.unwrap().0);
        assert!((found.mean().unwrap() - expected.mean().unwrap()).abs() <= 1e-13);
    }
}

/// The first of equal values counts, and zeros are equal whatever their sign.
#[test]
fn ties_go_to_the_first_pose() {
    let mut angles = vec![0.5; 600];
    angles[0] = 0.7;
    (angles[30], angles[40], angles[590]) = (-0.0, 0.0, 0.0);
    for index in [20, 21, 580] {
        angles[index] = 0.9;
    }
    for vectors in vectors() {
        let mut folds = [Fold::of(Slot::Input(0, 0)), Fold::of(Slot::Input(0, 1))];
        let inputs = crank(Column::Each(&angles));
        Batch::<FourBar, _>::new(same(LINKAGE), inputs, Assembly::Open)
            .vectors(vectors)
            .fold(600, &mut folds)
            .unwrap();
        let [angle, speed] = folds.map(|fold| *fold.folded());
        assert_eq!((angle.least, angle.greatest), (Some((30, 0.0)), Some((20, 0.9))));
        assert!(angle.least.is_some_and(|(_, value)| value.is_sign_negative()));
        assert_eq!((speed.least, speed.greatest), (Some((0, 2.0)), Some((0, 2.0))));
        assert_eq!((speed.sum, speed.sum_of_squares), (1200.0, 2400.0));
    }
}

#[test]
fn nothing_is_the_summary_of_no_pose() {
    for (poses, vectors) in vectors().flat_map(|vectors| [(0, vectors), (40, vectors)]) {
        // None of them closes.
        let inputs = crank(Column::Same(3.0));
        let mut folds = [Fold::of(SNAP), Fold::of(FoldedNumber::SmallestTransmissionAngle)];
        // What was there before is forgotten.
        let grid = InputGrid::revolution(0, 20);
        Batch::<FourBar, _>::new(same(CRANK_ROCKER), inputs, Assembly::Open)
            .vectors(vectors)
            .fold(grid, &mut folds)
            .unwrap();
        assert!(folds[0].folded().count == 20);
        let summary = Batch::<FourBar, _>::new(same(LINKAGE), inputs, Assembly::Open)
            .vectors(vectors)
            .fold(poses, &mut folds)
            .unwrap();
        assert_eq!((summary.solved, summary.failed), (0, poses));
        assert_eq!(summary.share_solved(), (poses > 0).then_some(0.0));
        for fold in &folds {
            let folded = fold.folded();
            assert_eq!(*folded, Folded::default());
            assert_eq!((folded.mean(), folded.root_mean_square()), (None, None));
            assert_eq!((folded.range(), folded.peak()), (None, None));
        }
    }
}

#[test]
fn a_number_that_is_not_there_is_named() {
    let vectors = Vectors::Compiled;
    let inputs = crank(Column::Same(0.1));
    for number in [
        FoldedNumber::At(Slot::Unknown(2, 0)),
        FoldedNumber::At(Slot::Unknown(1, 5)),
        FoldedNumber::At(Slot::Output(0, 0)),
        FoldedNumber::TransmissionAngle(1),
    ] {
        let mut folds = [Fold::of(SNAP), Fold::of(number)];
        let result = Batch::<FourBar, _>::new(same(LINKAGE), inputs, Assembly::Open)
            .vectors(vectors)
            .fold(5, &mut folds);
        assert_eq!(result, Err(FoldError::NoSuchNumber { number }));
    }
    let grid = InputGrid::revolution(1, 5);
    let result = Batch::<FourBar, _>::new(same(LINKAGE), inputs, Assembly::Open)
        .vectors(vectors)
        .fold(grid, &mut []);
    assert_eq!(result, Err(FoldError::NoSuchInput { input: 1 }));
    let inputs = crank(Column::Each(&[0.1; 4]));
    let result = Batch::<FourBar, _>::new(same(LINKAGE), inputs, Assembly::Open)
        .vectors(vectors)
        .fold(5, &mut []);
    let mismatch = LengthMismatch {
        quantity: "theta2".into(),
        poses: 5,
        length: 4,
    };
    assert_eq!(result, Err(FoldError::Length(mismatch)));
    // The column of the input of the grid is not read.
    let grid = InputGrid::between(0, 0.1, 0.5, 5);
    let result = Batch::<FourBar, _>::new(same(LINKAGE), inputs, Assembly::Open)
        .vectors(vectors)
        .fold(grid, &mut []);
    assert_eq!(result.map(|summary| summary.solved), Ok(5));
    // An unknown that is an angle has no sine, in short batches or long ones.
    for poses in [5, 1000] {
        let mut folds = [Fold::of(Slot::Sine(0))];
        let grid = InputGrid::revolution(0, poses);
        Batch::<FourBar, _>::new(same(LINKAGE), inputs, Assembly::Open)
            .vectors(vectors)
            .fold(grid, &mut folds)
            .unwrap();
        assert_eq!(*folds[0].folded(), Folded::default());
    }
}

/// The value farthest from zero counts, the earlier one of two that are equally far.
#[test]
fn a_peak_has_a_sign() {
    let folded = |values: &[f64]| plain(values.iter().copied());
    assert_eq!(folded(&[1.0, -3.0, 2.0]).peak(), Some((1, -3.0)));
    assert_eq!(folded(&[1.0, -3.0, 4.0]).peak(), Some((2, 4.0)));
    assert_eq!(folded(&[1.0, -3.0, 3.0]).peak(), Some((1, -3.0)));
    assert_eq!(folded(&[3.0, -3.0, 1.0]).peak(), Some((0, 3.0)));
    assert_eq!(folded(&[3.0, -1.0]).range(), Some(4.0));
    assert_eq!(folded(&[3.0, -1.0]).mean(), Some(1.0));
    assert_eq!(folded(&[3.0, -4.0]).root_mean_square(), Some(12.5_f64.sqrt()));
}
