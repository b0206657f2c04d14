//! More loops, and unknown lengths.

use std::vec::Vec;

use super::super::sequence::FixedSequence;
use super::super::{PathCounts, Unsuitable, real_solutions};
use super::table::Table;
use crate::number::samples;

/// Three general loops of six angles, where every angle rotates a vector in every loop.
///
/// With z = cis(θ) and its conjugate as variables, there are two groups of six variables, and three of each are free.
/// By Bézout's theorem for two groups, the equations z w = 1 have at most 6! / (3! 3!) = 20 solutions.
#[test]
fn three_loops_have_twenty_solutions() {
    let mut random = FixedSequence::new(3);
    for _ in 0..5 {
        let mut table = Table::default();
        let mut vector = || [2.0 * random.fraction() - 1.0, 2.0 * random.fraction() - 1.0];
        for equation in [0, 2, 4] {
            for angle in 0..6 {
                table.add_vector(equation, angle, vector());
            }
            let [x, y] = vector();
            table.add(equation, x, &[]);
            table.add(equation + 1, y, &[]);
        }
        for angle in 0..6 {
            table.add_angle(6 + usize::from(angle), angle);
        }
        let system = table.system::<12>();
        assert_eq!(system.paths(), 64);
        let mut found = Vec::new();
        let outcome = real_solutions::<12, 64>(&system, &table.coefficients, |solution| found.push(solution)).unwrap();
        let expected = PathCounts {
            paths: 20,
            regular: 20,
            real: found.len(),
            ..PathCounts::default()
        };
        assert_eq!(outcome, expected);
        assert_eq!(found.len() % 2, 0);
    }
}

/// The equation r cis(θ) = (x, y) has a solution for each sign of the length.
#[test]
fn a_length_and_its_direction() {
    for unit in [1e-6, 1.0, 1e6] {
        let mut table = Table::default();
        table.add(0, 1.0, &[(0, 1), (1, 1)]);
        table.add(0, -3.0 * unit, &[]);
        table.add(1, 1.0, &[(0, 1), (2, 1)]);
        table.add(1, -4.0 * unit, &[]);
        table.add(2, 1.0, &[(1, 2)]);
        table.add(2, 1.0, &[(2, 2)]);
        table.add(2, -1.0, &[]);
        let mut found = Vec::new();
        let outcome =
            real_solutions::<3, 8>(&table.system(), &table.coefficients, |solution| found.push(solution)).unwrap();
        assert_eq!((outcome.regular, outcome.real, outcome.lost), (2, 2, 0), "{outcome:?}");
        found.sort_by(|one, other| one.values[0].total_cmp(&other.values[0]));
        for (solution, sign) in found.iter().zip([-1.0, 1.0]) {
            let [r, c, s] = solution.values;
            let tolerance = 16.0 * f64::EPSILON * solution.condition;
            assert!((r / unit - sign * 5.0).abs() < 5.0 * tolerance);
            assert!((c - sign * 0.6).abs() < tolerance && (s - sign * 0.8).abs() < tolerance);
        }
    }
}

#[test]
fn linear_equations_need_one_path() {
    let mut table = Table::default();
    table.add(0, 2.0, &[(0, 1)]);
    table.add(0, 1.0, &[(1, 1)]);
    table.add(0, -4.0, &[]);
    table.add(1, 1.0, &[(0, 1)]);
    table.add(1, -1.0, &[(1, 1)]);
    table.add(1, 1.0, &[]);
    let mut found = Vec::new();
    let outcome = real_solutions::<2, 1>(&table.system(), &table.coefficients, |solution| {
        found.push(solution.values);
    });
    assert_eq!(outcome.unwrap().real, 1);
    let [[x, y]] = found[..] else { panic!("{found:?}") };
    assert!((x - 1.0).abs() < 1e-15 && (y - 2.0).abs() < 2e-15);
}

#[test]
fn what_cannot_be_solved_is_refused() {
    let mut table = Table::default();
    table.add(0, 1.0, &[(0, 2)]);
    table.add(0, -1.0, &[]);
    table.add(1, 1.0, &[(0, 1), (1, 1)]);
    table.add(1, -1.0, &[]);
    let system = table.system::<2>();
    let ask = |coefficients: &[f64]| real_solutions::<2, 4>(&system, coefficients, |_| {});
    assert_eq!(ask(&[1.0, -1.0, 1.0, -1.0]).unwrap().real, 2);
    assert_eq!(ask(&[1.0, -1.0, 1.0]), Err(Unsuitable::Table));
    assert_eq!(
        ask(&[1.0, f64::NAN, 1.0, 1.0]),
        Err(Unsuitable::NotFinite { coefficient: 1 })
    );
    assert_eq!(
        ask(&[1.0, -1.0, 0.0, -1.0]),
        Err(Unsuitable::NoVariable { equation: 1 })
    );
    assert_eq!(
        real_solutions::<2, 1>(&system, &[1.0, -1.0, 1.0, -1.0], |_| {}),
        Err(Unsuitable::TooManyPaths { paths: 2 })
    );
    let mut table = Table::default();
    for equation in 0..2 {
        table.add(equation, 1.0, &[(0, 1)]);
        table.add(equation, 3.0, &[(1, 1)]);
        table.add(equation, -1.0, &[]);
    }
    assert!(matches!(
        real_solutions::<2, 1>(&table.system(), &table.coefficients, |_| {}),
        Err(Unsuitable::Dependent { .. })
    ));
}

/// A slide on a rotating link, coupled to another loop: most paths lead to infinity, in several ways.
#[test]
fn a_length_in_coupled_loops() {
    let mut random = FixedSequence::new(11);
    for _ in 0..samples::of(40) {
        let mut table = Table::default();
        let mut vector = || [2.0 * random.fraction() - 1.0, 2.0 * random.fraction() - 1.0];
        // The length is the variable after those of the three angles.
        table.add(0, 1.0, &[(6, 1), (0, 1)]);
        table.add(1, 1.0, &[(6, 1), (1, 1)]);
        table.add_vector(0, 1, vector());
        for angle in 0..3 {
            table.add_vector(2, angle, vector());
        }
        for equation in [0, 2] {
            let [x, y] = vector();
            table.add(equation, x, &[]);
            table.add(equation + 1, y, &[]);
        }
        for angle in 0..3 {
            table.add_angle(4 + usize::from(angle), angle);
        }
        let outcome = real_solutions::<7, 32>(&table.system(), &table.coefficients, |_| {}).unwrap();
        let expected = PathCounts {
            paths: 16,
            regular: 6,
            real: outcome.real,
            singular: 0,
            at_infinity: 10,
            lost: 0,
        };
        assert_eq!(outcome, expected);
    }
}
