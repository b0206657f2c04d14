//! Tests of batches with every kind of vectors, small enough for an interpreter: whole chunks, a last chunk that
//! overlaps the one before, fewer poses than lanes, poses that fail, and numbers that are not wanted.

use std::vec;
use std::vec::Vec;

#[cfg(not(miri))]
use super::Element;
#[cfg(all(feature = "alloc", not(miri)))]
use super::{AnyBatch as _, ColumnChoice, GivenColumns, Slot, WantedColumns};
use super::{Batch, Column, Outcome, Vectors};
#[cfg(all(feature = "alloc", not(miri)))]
use crate::any::Of;
use crate::library::{ClassThreeTriad, ClassThreeTriadBatch, FourBar, FourBarBatch};
use crate::prelude::*;

/// Two chunks of the most lanes, and some more.
const POSES: usize = 37;

fn vectors() -> impl Iterator<Item = Vectors> {
    [Vectors::Compiled, Vectors::Avx2, Vectors::Avx512]
        .into_iter()
        .filter(|vectors| vectors.are_there())
}

/// Columns of `count` poses. Some poses are out of reach, far away, or NaN.
fn inputs(count: usize) -> [Vec<f64>; 2] {
    let fraction = |index: usize| f64::from(u32::try_from(index).unwrap()) / 37.0;
    let angles = (0..count).map(|index| match index % 7 {
        3 => 2.5,
        5 => 1e6 + fraction(index),
        6 if index > 20 => f64::NAN,
        _ => 1.8 * fraction(index),
    });
    [
        angles.collect(),
        (0..count).map(|index| 50.0 + 20.0 * fraction(index)).collect(),
    ]
}

/// The parameters and the input of four-bar linkages, by their [columns](inputs).
fn given([angles, couplers]: &[Vec<f64>; 2]) -> ([Column<'_>; 4], Motion<Column<'_>, 5>) {
    let parameters = [
        Column::Same(90.0),
        Column::Same(30.0),
        Column::Each(couplers),
        Column::Same(45.0),
    ];
    let theta2 = [
        Column::Each(angles),
        Column::Same(-1.0),
        Column::Same(0.5),
        Column::Same(0.0),
        Column::Same(0.2),
    ];
    (parameters, Motion::new(theta2))
}

/// The tolerance is ε times the condition of the poses above, with some room.
fn agree(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= 1e-11 * expected.abs().max(1.0) || (found.is_nan() && expected.is_nan())
}

/// The bits of numbers. The sign of a NaN says nothing, and an optimiser may choose it.
fn bits<T: Copy + Into<f64>>(column: &[T]) -> Vec<u64> {
    let number = |number: &T| (*number).into();
    let bits = |number: f64| if number.is_nan() { f64::NAN } else { number }.to_bits();
    column.iter().map(number).map(bits).collect()
}

#[test]
fn four_bars_of_as_many_poses_as_you_like() {
    for vectors in vectors() {
        for count in [0, 1, 3, 4, 8, 16, 17, POSES] {
            let columns = inputs(count);
            let (parameters, theta2) = given(&columns);
            let [angles, couplers] = &columns;
            let mut poses = FourBarBatch::filled(|| Some(vec![0.0; count]));
            // A number that is not wanted is left out.
            poses.theta3[2] = None;
            let mut outcomes = vec![Outcome::Unsolved; count];
            let assembly = Assembly::Open;
            let summary = Batch::<FourBar, _>::new(parameters, [theta2], assembly)
                .vectors(vectors)
                .solve(&mut poses, &mut outcomes);
            let summary = summary.unwrap();
            let mut failures = Vec::new();
            for index in 0..count {
                let linkage = FourBar {
                    r1: 90.0,
                    r2: 30.0,
                    r3: couplers[index],
                    r4: 45.0,
                };
                let alone = linkage.solve(Motion::new([angles[index], -1.0, 0.5, 0.0, 0.2]), assembly);
                failures.extend(alone.err().map(|error| (index, error)));
                let expected = alone.map_or([f64::NAN; 5], |pose| pose.theta4.derivatives());
                let outcome = alone.as_ref().map_or_else(Outcome::from, |_| Outcome::Solved);
                assert_eq!(outcomes[index], outcome, "{vectors:?}, pose {index} of {count}");
                for (order, expected) in expected.into_iter().enumerate() {
                    let found = poses.theta4[order].as_ref().unwrap()[index];
                    assert!(
                        agree(found, expected),
                        "{vectors:?}, pose {index} of {count}: {found} {expected}"
                    );
                }
            }
            assert_eq!(
                (summary.solved, summary.failed),
                (count - failures.len(), failures.len())
            );
            assert_eq!(summary.first_failure, failures.first().copied());
        }
    }
}

/// The number of failures of a long batch: lanes count them in pieces. (It takes an interpreter too long.)
#[cfg(not(miri))]
#[test]
fn failures_of_a_long_batch() {
    let count = 200_000;
    let mut cranks = vec![0.5_f32; count];
    // out of reach: half of the poses
    for crank in cranks.iter_mut().step_by(2) {
        *crank = 3.0;
    }
    let linkage = [90.0, 30.0, 60.0, 45.0].map(Column::Same);
    let mut theta2 = Motion::new([0.0; 5]).map(Column::Same);
    theta2[0] = Column::Each(&cranks);
    for vectors in vectors() {
        let mut poses = FourBarBatch::filled(|| None::<Vec<f32>>);
        let mut outcomes = vec![Outcome::Unsolved; count];
        let summary = Batch::<FourBar<f32>, _>::new(linkage, [theta2], Assembly::Open)
            .vectors(vectors)
            .solve(&mut poses, &mut outcomes);
        let summary = summary.unwrap();
        assert_eq!([summary.solved, summary.failed], [count / 2; 2], "{vectors:?}");
        // poses that fail in lanes are not solved alone
        assert!(summary.alone < 5, "{summary:?}");
    }
}

/// Chunks of long columns start at cache lines, so they depend on where the columns start. The numbers do not.
#[test]
fn it_does_not_matter_where_columns_start() {
    const LONG: usize = 32 * 16 + POSES;
    let columns = inputs(LONG);
    let (parameters, theta2) = given(&columns);
    let stride = LONG.next_multiple_of(8) + 16;
    let mut memory = vec![0.0; 20 * stride];
    let line = memory.as_ptr().align_offset(64);
    for vectors in vectors() {
        let mut expected = None;
        for shift in 0..8 {
            let mut columns = memory
                .chunks_exact_mut(stride)
                .map(|column| &mut column[line + shift..][..LONG]);
            let mut poses = FourBarBatch::filled(|| columns.next().unwrap());
            let mut outcomes = vec![Outcome::Unsolved; LONG];
            let summary = Batch::<FourBar, _>::new(parameters, [theta2], Assembly::Open)
                .vectors(vectors)
                .solve(&mut poses, &mut outcomes)
                .unwrap();
            let unknowns = poses.theta3.as_ref().iter().chain(poses.theta4.as_ref());
            let bits: Vec<u64> = unknowns
                .flat_map(|column| column.iter().map(|value| value.to_bits()))
                .collect();
            assert_eq!(
                summary.solved,
                outcomes.iter().filter(|outcome| outcome.is_solved()).count()
            );
            assert_eq!(summary.failed, LONG - summary.solved);
            let found = (summary.solved, outcomes, bits);
            assert!(
                expected.get_or_insert_with(|| found.clone()) == &found,
                "{vectors:?}, {shift}"
            );
        }
    }
}

/// The numbers of so long columns are those of short ones, wherever each column starts in its cache line, and nothing
/// beside the columns changes. (It takes an interpreter too long.)
#[cfg(not(miri))]
#[test]
fn long_columns_hold_what_short_ones_do() {
    check_long_columns::<f64>(8);
    check_long_columns::<f32>(16);
}

#[cfg(not(miri))]
fn check_long_columns<T: Element + Into<f64>>(line: usize) {
    const LONG: usize = 4001;
    const SHORT: usize = 401;
    let of = |number: f64| T::constant(number);
    let beside = of(7.0);
    for (failures, assembly) in [
        ([].as_slice(), Assembly::Open),
        (&[3, 700, 2200, 2201, 4000], Assembly::Crossed),
        (&[701, 702, 1726, 3999], Assembly::Open),
    ] {
        let angles: Vec<T> = (0..LONG)
            .map(|index| {
                let angle = 1.8 * f64::from(u32::try_from(index).unwrap()) / 4001.0;
                of(if failures.contains(&index) { 2.5 } else { angle })
            })
            .collect();
        let linkage = [90.0, 30.0, 60.0, 45.0].map(|length| Column::Same(of(length)));
        let batch = |range: core::ops::Range<usize>| {
            let mut theta2 = [-1.0, 0.5, 0.0, 0.2, 0.1].map(|rate| Column::Same(of(rate)));
            theta2[0] = Column::Each(&angles[range]);
            Batch::<FourBar<T>, _>::new(linkage, [Motion::new(theta2)], assembly)
        };
        for vectors in vectors() {
            let mut expected = vec![Vec::new(); 10];
            for start in (0..LONG).step_by(SHORT) {
                let range = start..LONG.min(start + SHORT);
                let mut outcomes = vec![Outcome::Unsolved; range.len()];
                let mut poses = FourBarBatch::filled(|| vec![beside; range.len()]);
                batch(range).vectors(vectors).solve(&mut poses, &mut outcomes).unwrap();
                let columns = poses.theta3.as_ref().iter().chain(poses.theta4.as_ref());
                for (expected, column) in expected.iter_mut().zip(columns) {
                    expected.extend(bits(column));
                }
            }
            // all columns start at the same place of a line, or the third at another one than the first two, and so on
            for (shift, apart) in (0..line).flat_map(|shift| [(shift, 0), (shift, 3)]) {
                let mut memory = vec![vec![beside; LONG + 3 * line]; 15];
                let place = |column: usize| (shift + column / 2 * apart) % line + 1;
                let columns = memory.iter().enumerate();
                let starts = columns.map(|(column, memory)| memory.as_ptr().align_offset(64) + place(column));
                let starts: Vec<usize> = starts.collect();
                let columns = memory.iter_mut().zip(&starts);
                let mut columns = columns.map(|(column, start)| &mut column[*start..][..LONG]);
                let mut poses = FourBarBatch::filled(|| columns.next().unwrap());
                let mut outcomes = vec![Outcome::Unsolved; LONG];
                let summary = batch(0..LONG).vectors(vectors).solve(&mut poses, &mut outcomes);
                assert_eq!(summary.unwrap().failed, failures.len());
                let columns = poses.theta3.as_ref().iter().chain(poses.theta4.as_ref());
                let is_same = columns
                    .zip(&expected)
                    .all(|(column, expected)| bits(column) == *expected);
                let mut others = memory.iter().zip(starts);
                let are_kept = others.all(|(column, start)| {
                    let others = column[..start].iter().chain(&column[start + LONG..]);
                    others.into_iter().all(|number| *number == beside)
                });
                assert!(is_same && are_kept, "{vectors:?}, {shift}, {apart}, {failures:?}");
            }
        }
    }
}

/// The sine of an unknown that is no direction is not found, however long its column is.
#[cfg(all(feature = "alloc", not(miri)))]
#[test]
fn a_sine_that_is_not_found_is_left_out() {
    const LONG: usize = 4001;
    let [angles, _] = inputs(1);
    let linkage = [90.0, 30.0, 60.0, 45.0].map(Column::Same);
    let theta2 = [angles[0], -1.0, 0.5, 0.0, 0.2].map(Column::Same);
    let mut columns = vec![vec![7.0; LONG]; 5];
    let slots = [Slot::Sine(0)]
        .into_iter()
        .chain((0..4).map(|order| Slot::Unknown(1, order)));
    let mut wanted = WantedColumns::new(slots.zip(columns.iter_mut().map(|column| &mut column[..])).collect());
    let given = GivenColumns {
        parameters: &linkage,
        inputs: &[&theta2],
        choice: ColumnChoice::Assembly(0),
    };
    let mut outcomes = vec![Outcome::Unsolved; LONG];
    let functions = Of::<FourBar>::FUNCTIONS;
    let summary = functions.solve_batch(given, &mut wanted, &mut outcomes, Vectors::widest());
    assert_eq!(summary.unwrap().solved, LONG);
    assert!(columns[0].iter().all(|sine| *sine == 7.0));
    assert!(columns[1].iter().all(|angle| *angle != 7.0));
}

/// More poses than one core gets at once. After the full pieces, fewer poses are left than there are lanes.
#[cfg(feature = "rayon")]
#[test]
fn all_cores_write_what_one_writes() {
    let count = 3 * 512 + 5;
    let columns = inputs(count);
    let (parameters, theta2) = given(&columns);
    let assembly = Assembly::Crossed;
    let results = || {
        (
            FourBarBatch::filled(|| vec![0.0; count]),
            vec![Outcome::Unsolved; count],
        )
    };
    for vectors in vectors() {
        let [(mut poses, mut outcomes), (mut other_poses, mut other_outcomes)] = [results(), results()];
        let summary = Batch::<FourBar, _>::new(parameters, [theta2], assembly)
            .vectors(vectors)
            .solve(&mut poses, &mut outcomes);
        let (other, others) = (&mut other_poses, &mut other_outcomes);
        let parallel = Batch::<FourBar, _>::new(parameters, [theta2], assembly)
            .vectors(vectors)
            .on_all_cores()
            .solve(other, others);
        assert_eq!(summary.unwrap().solved, parallel.unwrap().solved);
        assert_eq!(outcomes, other_outcomes);
        for order in 0..5 {
            assert_eq!(bits(&poses.theta4[order]), bits(&other_poses.theta4[order]));
        }
    }
}

#[test]
fn triads_by_iteration() {
    let triad = ClassThreeTriad {
        base_b: Plane::new(3.4, 0.2),
        base_c: Plane::new(1.7, 3.1),
        platform_b: Plane::new(1.6, 0.1),
        platform_c: Plane::new(0.8, 1.4),
    };
    let fraction = |index: usize| f64::from(u32::try_from(index).unwrap()) / 19.0;
    let count = 19;
    let legs: Vec<f64> = (0..count).map(|index| 1.9 + 0.3 * fraction(index)).collect();
    // From some of these guesses no iteration converges.
    let start = [0.9, 2.1, -1.9, 0.2];
    let guesses: Vec<f64> = (0..count)
        .map(|index| if index == 11 { f64::NAN } else { start[0] })
        .collect();
    let motion = |leg: f64| Motion::new([leg, 0.3, 0.0, 0.1, 0.0]);
    for vectors in vectors() {
        let mut poses = ClassThreeTriadBatch::filled(|| vec![0.0; count]);
        let mut outcomes = vec![Outcome::Unsolved; count];
        let parameters = triad.parameters().map(Column::Same);
        let still = Motion::constant(2.1).map(Column::Same);
        let mut leg = motion(0.0).map(Column::Same);
        leg[0] = Column::Each(&legs);
        let mut near = start.map(Column::Same);
        near[0] = Column::Each(&guesses);
        Batch::<ClassThreeTriad, _>::near(parameters, [leg, still, still], near)
            .vectors(vectors)
            .solve(&mut poses, &mut outcomes)
            .unwrap();
        assert!(
            outcomes.iter().filter(|outcome| outcome.is_solved()).count() > 10,
            "{outcomes:?}"
        );
        for index in 0..count {
            let mut near = start;
            near[0] = guesses[index];
            let still = Motion::constant(2.1);
            let alone = triad.solve_near(motion(legs[index]), still, still, near);
            let expected = alone.map_or([f64::NAN; 5], |pose| pose.phi.derivatives());
            for (order, expected) in expected.into_iter().enumerate() {
                let found = poses.phi[order][index];
                assert!(agree(found, expected), "{vectors:?}, pose {index}: {found} {expected}");
            }
        }
    }
}
