//! A batch finds the same poses as one call per pose. The package of tests solves many mechanisms in batches.

use std::string::ToString;
use std::vec;
use std::vec::Vec;

use super::{Batch, Column, LengthMismatch, MotionColumns, Outcome, Slot, Target, Vectors, Visitor};
use crate::assembly::Assembly;
use crate::geometry::Space;
use crate::library::{FourBar, FourBarBatch};
use crate::mechanism::PoseOf;
use crate::motion::Motion;

const LINKAGE: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 40.0,
    r4: 45.0,
};

type Parameters<'a> = [Column<'a>; 4];
type Poses = FourBarBatch<Vec<f64>>;

fn parameters<'a>() -> Parameters<'a> {
    [LINKAGE.r1, LINKAGE.r2, LINKAGE.r3, LINKAGE.r4].map(Column::Same)
}

fn crank_columns(angles: &[f64]) -> [Motion<Column<'_>, 5>; 1] {
    [Motion::from([
        Column::Each(angles),
        2.0.into(),
        0.5.into(),
        Column::Same(-1.0),
        0.25.into(),
    ])]
}

/// Crank angles over more than the range of the linkage.
fn angles(count: u32) -> Vec<f64> {
    (0..count)
        .map(|index| 4.0 * f64::from(index) / f64::from(count.max(1)) - 2.0)
        .collect()
}

fn targets(count: usize) -> (Poses, Vec<Outcome>) {
    (
        FourBarBatch::filled(|| vec![0.0; count]),
        vec![Outcome::Unsolved; count],
    )
}

fn vectors() -> impl Iterator<Item = Vectors> {
    [Vectors::Compiled, Vectors::Avx2, Vectors::Avx512]
        .into_iter()
        .filter(|vectors| vectors.are_there())
}

/// Values near each position select the assembly to which they belong.
#[test]
fn values_near_by_tell_the_assembly() {
    let angles = angles(50);
    for assembly in Assembly::BOTH {
        let expected: Vec<Option<[f64; 2]>> = angles
            .iter()
            .map(|angle| LINKAGE.position(*angle, assembly).ok().map(|pose| pose.unknowns()))
            .collect();
        // Poses out of reach get values of this assembly too.
        let reachable = expected[25].unwrap();
        let beside = |unknown: usize, shift: f64| -> Vec<f64> {
            let poses = expected.iter().map(|pose| pose.unwrap_or(reachable));
            poses.map(|unknowns| unknowns[unknown] + shift).collect()
        };
        let near = [beside(0, 0.01), beside(1, -0.01)];
        for vectors in vectors() {
            let (mut poses, mut outcomes) = targets(50);
            let summary = Batch::<FourBar, _>::near(
                parameters(),
                crank_columns(&angles),
                [Column::Each(&near[0]), Column::Each(&near[1])],
            )
            .vectors(vectors)
            .solve(&mut poses, &mut outcomes)
            .unwrap();
            let mut solved = 0;
            for (index, pose) in expected.iter().enumerate() {
                assert_eq!(outcomes[index].is_solved(), pose.is_some(), "{index}");
                let Some([theta3, theta4]) = *pose else { continue };
                solved += 1;
                for (found, expected) in [(&poses.theta3, theta3), (&poses.theta4, theta4)] {
                    let error = (found[0][index] - expected).abs();
                    // Near its limits the linkage magnifies rounding.
                    assert!(error * (theta3 - theta4).sin().abs() <= 1e-13, "{index}: {error}");
                }
            }
            assert_eq!((summary.solved, summary.failed), (solved, 50 - solved));
            assert!(solved > 20);
        }
    }
}

/// The first failure lies behind the first piece.
#[cfg(feature = "rayon")]
#[test]
fn all_cores_find_the_first_failure() {
    let angles: Vec<f64> = (0..2000).map(|index| 0.001 * f64::from(index)).collect();
    let (mut poses, mut outcomes) = targets(2000);
    let [crank] = crank_columns(&angles);
    let FourBar { r1, r2, r3, r4 } = LINKAGE;
    let linkage = FourBar {
        r1: Column::Same(r1),
        r2: Column::Same(r2),
        r3: Column::Same(r3),
        r4: Column::Same(r4),
    };
    let summary = linkage
        .batch(crank, Assembly::Open)
        .on_all_cores()
        .solve(&mut poses, &mut outcomes);
    let alone = |angle: &f64| {
        LINKAGE
            .solve(Motion::new([*angle, 2.0, 0.5, -1.0, 0.25]), Assembly::Open)
            .err()
    };
    let mut errors = (0..)
        .zip(&angles)
        .filter_map(|(index, angle)| Some((index, alone(angle)?)));
    let first = errors.next();
    assert_eq!(summary.unwrap().first_failure, first);
    assert!(first.is_some_and(|(index, _)| index > 512), "{first:?}");
    let error = linkage
        .batch(crank, Assembly::Open)
        .on_all_cores()
        .solve(&mut poses, &mut outcomes[1..]);
    let error = error.unwrap_err();
    assert_eq!(
        (error.quantity, error.poses, error.length),
        ("theta2".into(), 1999, 2000)
    );
}

#[test]
fn a_pose_out_of_reach_has_a_margin() {
    let angles = [0.1, 0.2, 0.3];
    let mut poses = FourBarBatch::filled(|| vec![0.0_f64; 3]);
    let mut outcomes = [Outcome::Unsolved; 3];
    let rocker = [45.0, 10.0, 45.0];
    let linkage = FourBar {
        r1: Column::Same(90.0),
        r2: Column::Same(30.0),
        r3: Column::Same(40.0),
        r4: Column::Each(&rocker),
    };
    let theta2 = Motion::new([
        Column::Each(&angles),
        Column::Same(1.0),
        Column::Same(0.0),
        Column::Same(0.0),
        Column::Same(0.0),
    ]);
    let summary = linkage
        .batch(theta2, Assembly::Open)
        .solve(&mut poses, &mut outcomes)
        .unwrap();
    assert_eq!((summary.solved, summary.failed), (2, 1));
    let error = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 40.0,
        r4: 10.0,
    }
    .position(0.2, Assembly::Open)
    .expect_err("too short");
    assert_eq!(
        outcomes[1].margin(),
        error.margin(),
        "three poses are solved one by one"
    );
    assert!(error.margin().is_some_and(|margin| margin < -10.0));
    assert_eq!(
        summary.first_failure.map(|(index, error)| (index, error.failure)),
        Some((1, error.failure))
    );
    assert!(poses.theta4[0][1].is_nan() && poses.theta4[4][2].is_finite());
    assert_eq!(poses.theta2[0], angles);
}

#[test]
fn columns_of_other_lengths_are_named() {
    let (four, five) = (&[0.1; 4], &[0.1; 5]);
    let mismatch = |quantity, length| {
        Err(LengthMismatch {
            quantity,
            poses: 5,
            length,
        })
    };
    let solved = |parameters: Parameters<'_>, crank: &[f64], near: [Column<'_>; 2], rocker: usize| {
        let (mut poses, mut outcomes) = targets(5);
        poses.theta4[3] = vec![0.0; rocker];
        let result = Batch::<FourBar, _>::near(parameters, crank_columns(crank), near).solve(&mut poses, &mut outcomes);
        assert_eq!(outcomes.iter().all(Outcome::is_solved), result.is_ok());
        assert_eq!(
            outcomes.iter().all(|outcome| *outcome == Outcome::Unsolved),
            result.is_err()
        );
        result.map(|summary| summary.solved)
    };
    let near = LINKAGE
        .position(0.1, Assembly::Open)
        .unwrap()
        .unknowns()
        .map(Column::Same);
    let mut with_column = parameters();
    with_column[2] = Column::Each(&[LINKAGE.r3; 5]);
    assert_eq!(solved(parameters(), five, near, 5), Ok(5));
    assert_eq!(solved(with_column, five, near, 5), Ok(5));
    with_column[2] = Column::Each(&[LINKAGE.r3; 6]);
    assert_eq!(solved(with_column, five, near, 5), mismatch("r3".into(), 6));
    assert_eq!(solved(parameters(), four, near, 5), mismatch("theta2".into(), 4));
    assert_eq!(
        solved(parameters(), five, [near[0], Column::Each(four)], 5),
        mismatch("theta4".into(), 4)
    );
    assert_eq!(solved(parameters(), five, near, 6), mismatch("theta4".into(), 6));
    assert_eq!(
        solved(parameters(), four, near, 5).unwrap_err().to_string(),
        "a column of `theta2` has 4 entries, but there are 5 outcomes: give one entry and one outcome for each pose"
    );
}

#[test]
fn what_is_not_wanted_is_left_out() {
    let angles = [0.1, 0.2, 0.3, 0.4, 0.5];
    let mut wanted = [0.0; 5];
    let mut poses = FourBarBatch::filled(|| None);
    poses.theta4[2] = Some(wanted.as_mut_slice());
    let mut outcomes = [Outcome::Unsolved; 5];
    let vectors = Vectors::Compiled;
    let crank = crank_columns(&angles);
    Batch::<FourBar, _>::new(parameters(), crank, Assembly::Open)
        .vectors(vectors)
        .solve(&mut poses, &mut outcomes)
        .unwrap();
    for (angle, found) in angles.into_iter().zip(wanted) {
        let crank = Motion::new([angle, 2.0, 0.5, -1.0, 0.25]);
        let expected = LINKAGE.solve(crank, Assembly::Open).unwrap().theta4[2];
        assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{angle}");
    }
}

#[test]
fn columns_are_read_by_index() {
    let numbers = vec![1.0_f64, 2.0];
    for column in [
        Column::Each(&numbers),
        Column::from(&numbers),
        Column::from(&[1.0, 2.0]),
    ] {
        assert_eq!((column.at(0), column.at(1)), (1.0, 2.0));
        assert!(column.at(2).is_nan());
        assert_eq!(column.length(), Some(2));
    }
    let same = Column::from(3.0);
    assert_eq!((same.at(0), same.at(7), same.length()), (3.0, 3.0, None));
}

#[test]
fn targets_are_what_they_hold() {
    let mut vector = vec![1.0, 2.0];
    let mut array = [1.0, 2.0];
    let expected = Some([1.0, 2.0].as_mut_slice().to_vec());
    let read = |slice: Option<&mut [f64]>| slice.map(|slice| slice.to_vec());
    assert_eq!(read(array.slice()), expected);
    assert_eq!(read(vector.slice()), expected);
    assert_eq!(read((&mut array[..]).slice()), expected);
    assert_eq!(read(Some(vector).slice()), expected);
    assert_eq!(read(None::<Vec<f64>>.slice()), None);
}

/// The visited slots, and their contents.
struct Seen(Vec<(Slot, f64)>);

impl<'a> Visitor<'a, f64> for Seen {
    fn visit(&mut self, slot: Slot, there: &'a mut f64) {
        self.0.push((slot, *there));
    }
}

/// The coordinates of a point in space count one after the other, each with all its orders.
#[test]
fn coordinates_have_places_of_their_own() {
    let mut number = 0.0;
    let mut next = || {
        number += 1.0;
        number
    };
    let mut motion: Motion<Space<f64>, 2> = MotionColumns::filled(&mut next);
    let mut seen = Seen(Vec::new());
    motion.each(4, Slot::Output, &mut seen);
    let mut expected = Vec::new();
    for order in 0..2 {
        let Space { x, y, z } = motion[order];
        expected.extend([(4, x), (5, y), (6, z)].map(|(index, value)| (Slot::Output(index, order), value)));
    }
    assert_eq!(seen.0, expected);
}
