//! Reactions in many poses beside those of prepared single poses.

use std::string::ToString;
use std::vec;
use std::vec::Vec;

use super::{ENGINE, FOUR_BAR, heavy};
use crate::any::PositionChoice;
use crate::batch::{Column, ColumnChoice, Vectors};
use crate::linkage::AnyLinkage;
use crate::motion::Motion;
use crate::reaction::{NamedReactions, PoseReactions, ReactionError};
use crate::verify::Random;

/// All forces, moments and efforts with their rates, or the message.
fn all(reactions: &NamedReactions<'_>, found: Result<PoseReactions<'_>, ReactionError>) -> Result<Vec<f64>, String> {
    let found = found.map_err(|error| error.to_string())?;
    let mut numbers = Vec::new();
    for index in 0..reactions.names().count() {
        for vector in [found.force(index), found.moment(index)] {
            numbers.extend(vector.unwrap_or([[f64::NAN; 3]; 3]).into_iter().flatten());
        }
    }
    numbers.extend(found.effort(0).unwrap_or([f64::NAN; 3]));
    Ok(numbers)
}

type String = std::string::String;

/// Compares numbers, each order by the largest of its order, and errors.
fn agree(found: &Result<Vec<f64>, String>, expected: &Result<Vec<f64>, String>, part: f64) {
    let (Ok(found), Ok(expected)) = (found, expected) else {
        assert_eq!(found.as_ref().err(), expected.as_ref().err());
        assert!(found.is_err());
        return;
    };
    assert_eq!(found.len(), expected.len());
    for order in 0..3 {
        let own = || expected.iter().skip(order).step_by(3);
        let size = own()
            .filter(|own| !own.is_nan())
            .fold(0.0, |size: f64, own| size.max(own.abs()));
        for (found, expected) in found.iter().skip(order).step_by(3).zip(own()) {
            let is_same = found.is_nan() && expected.is_nan() || (found - expected).abs() <= part * size;
            assert!(is_same, "order {order}: {found} {expected}");
        }
    }
}

/// Motions of the only input around a turn, with rates of their own, more of them than fill vectors.
fn motions(count: usize, seed: u64) -> [Vec<f64>; 5] {
    let mut random = Random::new(seed);
    let mut motions = [0; 5].map(|_| Vec::new());
    for _ in 0..count {
        for (order, column) in motions.iter_mut().enumerate() {
            let reach = if order == 0 { core::f64::consts::PI } else { 9.0 };
            column.push(random.between(-reach, reach));
        }
    }
    motions
}

/// Compares all rows of a batch with prepared poses, in all vectors, and returns how many of them fail.
pub(super) fn compare(reactions: &NamedReactions<'_>, motions: &[Vec<f64>; 5], part: f64) -> usize {
    let columns = [0, 1, 2, 3, 4].map(|order| Column::Each(&motions[order]));
    let count = motions[0].len();
    let mut prepared = reactions.prepared();
    let expected: Vec<_> = (0..count)
        .map(|row| {
            let motion = Motion::new(core::array::from_fn(|order| motions[order][row]));
            all(reactions, prepared.at(&[motion], PositionChoice::Assembly(0)))
        })
        .collect();
    for vectors in [Vectors::Compiled, Vectors::Avx2, Vectors::Avx512] {
        let mut found = vec![Ok(Vec::new()); count];
        let given: &[&[Column<'_>]] = &[&columns];
        let batch = reactions.batch(given, ColumnChoice::Assembly(0)).vectors(vectors);
        batch
            .solve(|pose| all(reactions, pose), &mut found)
            .expect("the columns fit");
        for (found, expected) in found.iter().zip(&expected) {
            agree(found, expected, part);
        }
        #[cfg(feature = "rayon")]
        {
            let mut again = vec![Ok(Vec::new()); count];
            batch
                .solve_on_all_cores(|pose| all(reactions, pose), &mut again)
                .expect("the columns fit");
            // what is not determined is not a number
            let bits =
                |own: &Result<Vec<f64>, String>| own.clone().map(|own| own.into_iter().map(f64::to_bits).collect());
            let bits =
                |all: &[Result<Vec<f64>, String>]| all.iter().map(bits).collect::<Vec<Result<Vec<u64>, String>>>();
            assert_eq!(bits(&again), bits(&found));
        }
    }
    expected.iter().filter(|row| row.is_err()).count()
}

/// Some rows do not close: their errors are those of single poses.
#[test]
fn a_batch_is_its_single_poses() {
    let linkage = AnyLinkage::of(&FOUR_BAR);
    let reactions = linkage.reactions(&heavy(&linkage)).expect("its bodies are declared");
    assert_eq!(compare(&reactions, &motions(523, 1), 1e-12), 0);
    // fewer than fill a vector
    assert_eq!(compare(&reactions, &motions(3, 2), 1e-12), 0);
    assert_eq!(compare(&reactions, &motions(0, 2), 1e-12), 0);

    let rocker = super::FourBar { r2: 1.1, ..FOUR_BAR };
    let linkage = AnyLinkage::of(&rocker);
    let reactions = linkage.reactions(&heavy(&linkage)).expect("its bodies are declared");
    let failures = compare(&reactions, &motions(300, 3), 1e-9);
    assert!(failures > 20 && failures < 280, "{failures}");

    let linkage = AnyLinkage::of(&ENGINE);
    let reactions = linkage.reactions(&heavy(&linkage)).expect("its bodies are declared");
    assert_eq!(compare(&reactions, &motions(200, 4), 1e-11), 0);
    let rubbed = super::rubbed(reactions, &[("pin", super::pin(0.1, 0.01))]);
    assert_eq!(compare(&rubbed, &motions(20, 5), 1e-11), 0);
}

/// Without fused operations all steps are those of one pose, and are rounded alike.
#[test]
fn vectors_without_fusion_give_the_same_digits() {
    let linkage = AnyLinkage::of(&FOUR_BAR);
    let reactions = linkage.reactions(&heavy(&linkage)).expect("its bodies are declared");
    let angles: Vec<f64> = (0..100_u8).map(|row| 0.06 * f64::from(row)).collect();
    let crank = [Column::Each(&angles), Column::Same(7.0)];
    let mut found = vec![Ok(Vec::new()); angles.len()];
    reactions
        .batch(&[&crank], ColumnChoice::Assembly(0))
        .vectors(Vectors::Compiled)
        .solve(|pose| all(&reactions, pose), &mut found)
        .expect("the columns fit");
    let mut prepared = reactions.prepared();
    // the first pose makes the plan, from longer series
    let first = prepared.at(&[Motion::at_constant_speed(0.0, 7.0)], PositionChoice::Assembly(0));
    assert!(first.is_ok());
    for (angle, found) in angles.iter().zip(found) {
        let motion = Motion::at_constant_speed(*angle, 7.0);
        let expected = all(&reactions, prepared.at(&[motion], PositionChoice::Assembly(0)));
        assert_eq!(found, expected, "{angle}");
    }
}

/// Rows of other dimensions are what the reactions of linkages with these dimensions are, where the ground's pivot
/// moves with them too, and where they do not close.
#[test]
fn dimensions_may_differ() {
    let count = 100_u8;
    let (mut random, linkage) = (Random::new(7), AnyLinkage::of(&FOUR_BAR));
    let loads = heavy(&linkage);
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    let own = [FOUR_BAR.r1, FOUR_BAR.r2, FOUR_BAR.r3, FOUR_BAR.r4];
    let columns = own.map(|own| (0..count).map(|_| own * random.between(0.6, 1.4)).collect::<Vec<f64>>());
    let dimensions = [0, 1, 2, 3].map(|index| Column::Each(&columns[index]));
    let crank = [Column::Same(0.7), Column::Same(5.0)];
    let mut found = vec![Ok(Vec::new()); usize::from(count)];
    reactions
        .batch(&[&crank], ColumnChoice::Assembly(0))
        .dimensions(&dimensions)
        .solve(|pose| all(&reactions, pose), &mut found)
        .expect("the columns fit");
    let mut failures = 0;
    for (row, found) in found.iter().enumerate() {
        let [r1, r2, r3, r4] = [0, 1, 2, 3].map(|index| columns[index][row]);
        let linkage = super::FourBar { r1, r2, r3, r4 };
        let linkage = AnyLinkage::of(&linkage);
        let reactions = linkage.reactions(&loads).expect("its bodies are declared");
        let mut prepared = reactions.prepared();
        let expected = prepared.at(&[Motion::at_constant_speed(0.7, 5.0)], PositionChoice::Assembly(0));
        let expected = all(&reactions, expected);
        failures += usize::from(expected.is_err());
        agree(found, &expected, 1e-10);
    }
    assert!(failures > 0 && failures < 50, "{failures}");

    // one other set of dimensions for all rows
    let dimensions = [1.0, 0.25, 0.8, 0.7].map(Column::Same);
    let (r1, r2, r3, r4) = (1.0, 0.25, 0.8, 0.7);
    let other = super::FourBar { r1, r2, r3, r4 };
    let other = AnyLinkage::of(&other);
    let own = other.reactions(&loads).expect("its bodies are declared");
    let expected = all(
        &own,
        own.prepared()
            .at(&[Motion::at_constant_speed(0.7, 5.0)], PositionChoice::Assembly(0)),
    );
    let mut found = vec![Ok(Vec::new()); 2];
    reactions
        .batch(&[&crank], ColumnChoice::Assembly(0))
        .dimensions(&dimensions)
        .solve(|pose| all(&reactions, pose), &mut found)
        .expect("the columns fit");
    agree(&found[0], &expected, 1e-12);
    agree(&found[1], &expected, 1e-12);
}

/// Values nearby choose each row's position, and a column of another length is told.
#[test]
fn columns_choose_and_fit() {
    let linkage = AnyLinkage::of(&FOUR_BAR);
    let loads = heavy(&linkage);
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    let angles = [0.1, 0.2, 0.3, 0.4];
    let crank = [Column::Each(&angles), Column::Same(5.0)];
    let mut few = vec![0.0; 3];
    let mismatch = reactions
        .batch(&[&crank], ColumnChoice::Assembly(0))
        .solve(|_| 0.0, &mut few)
        .expect_err("a column is longer");
    assert!(mismatch.to_string().contains("`theta2` has 4 entries"), "{mismatch}");
    // a change point is told as such
    let kite = super::FourBar {
        r1: 0.6,
        r2: 0.3,
        r3: 0.3,
        r4: 0.6,
    };
    let linkage = AnyLinkage::of(&kite);
    let reactions = linkage.reactions(&heavy(&linkage)).expect("its bodies are declared");
    let angles = [0.5, 0.0, 0.6];
    let crank = [Column::Each(&angles), Column::Same(5.0)];
    let mut found = vec![Ok(Vec::new()); 3];
    reactions
        .batch(&[&crank], ColumnChoice::Assembly(0))
        .solve(|pose| all(&reactions, pose), &mut found)
        .expect("the columns fit");
    let mut prepared = reactions.prepared();
    for (angle, found) in angles.iter().zip(&found) {
        let motion = Motion::at_constant_speed(*angle, 5.0);
        agree(
            found,
            &all(&reactions, prepared.at(&[motion], PositionChoice::Assembly(0))),
            1e-11,
        );
    }
    assert!(found[1].is_err() && found[0].is_ok());
}
