//! Two circles, and loops with two angles. The closed form gives the expected result.

use std::vec::Vec;

use proptest::prelude::*;

use super::super::{PathCounts, Solution, real_solutions};
use super::table::Table;
use crate::assemblies::Positions;
use crate::assembly::Assembly;
use crate::geometry::Plane;
use crate::solve::circle_circle;

/// The circles x² + y² = a² and (x - d)² + y² = b².
fn circles(a: f64, b: f64, d: f64) -> (PathCounts, Positions<Solution<2>, 4>) {
    let mut table = Table::default();
    table.add(0, 1.0, &[(0, 2)]);
    table.add(0, 1.0, &[(1, 2)]);
    table.add(0, -a * a, &[]);
    table.add(1, 1.0, &[(0, 2)]);
    table.add(1, -2.0 * d, &[(0, 1)]);
    table.add(1, 1.0, &[(1, 2)]);
    table.add(1, d * d - b * b, &[]);
    let mut found = Positions::new();
    let outcome = real_solutions::<2, 4>(&table.system(), &table.coefficients, |solution| {
        assert!(found.push(solution));
    });
    (outcome.unwrap(), found)
}

#[test]
fn two_points_or_none() {
    for unit in [1e-6, 1.0, 1e6] {
        let (outcome, found) = circles(3.0 * unit, 4.0 * unit, 5.0 * unit);
        let expected = PathCounts {
            paths: 2,
            regular: 2,
            real: 2,
            ..PathCounts::default()
        };
        assert_eq!(outcome, expected);
        let mut values: Vec<_> = found.into_iter().map(|solution| solution.values).collect();
        values.sort_by(|one, other| one[1].total_cmp(&other[1]));
        for ([x, y], sign) in values.into_iter().zip([-1.0, 1.0]) {
            assert!((x / unit - 1.8).abs() < 8.0 * f64::EPSILON * found[0].condition);
            assert!((y / unit - sign * 2.4).abs() < 8.0 * f64::EPSILON * found[0].condition);
        }
        let (outcome, found) = circles(3.0 * unit, 4.0 * unit, 8.0 * unit);
        assert_eq!(outcome, PathCounts { real: 0, ..expected });
        assert!(found.is_empty());
    }
}

#[test]
fn circles_that_touch_have_a_double_point() {
    for (a, b, d, x) in [(3.0, 4.0, 7.0, 3.0), (7.0, 4.0, 3.0, 7.0), (0.3, 0.4, 0.7, 0.3)] {
        let (outcome, found) = circles(a, b, d);
        assert_eq!(
            (outcome.paths, outcome.singular, outcome.lost),
            (2, 2, 0),
            "{a} {b} {d}"
        );
        let [solution] = *found else {
            panic!("{found:?}");
        };
        assert_eq!(solution.multiplicity, 2);
        // The solution changes by the square root of the rounding of the coefficients.
        let tolerance = 16.0 * f64::EPSILON.sqrt() * a;
        assert!((solution.values[0] - x).abs() < tolerance && solution.values[1].abs() < tolerance);
    }
}

#[test]
fn one_and_the_same_circle_is_no_isolated_solution() {
    let (outcome, _) = circles(1.0, 1.0, 0.0);
    assert_eq!((outcome.paths, outcome.regular, outcome.lost), (2, 0, 0));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn four_bars_as_in_closed_form(
        ground in 0.1_f64..3.0, crank in 0.1_f64..3.0, coupler in 0.1_f64..3.0, rocker in 0.1_f64..3.0,
        input in -3.0_f64..3.0, exponent in -6_i32..=6,
    ) {
        // The closure is r2 cis(θ2) + r3 cis(θ3) = r1 + r4 cis(θ4).
        let unit = 10.0_f64.powi(exponent);
        let (sine, cosine) = input.sin_cos();
        let mut table = Table::default();
        table.add_vector(0, 0, [coupler * unit, 0.0]);
        table.add_vector(0, 1, [-rocker * unit, 0.0]);
        table.add(0, (crank * cosine - ground) * unit, &[]);
        table.add(1, crank * sine * unit, &[]);
        table.add_angle(2, 0);
        table.add_angle(3, 1);
        let mut found: Vec<Solution<4>> = Vec::new();
        let outcome =
            real_solutions::<4, 4>(&table.system(), &table.coefficients, |solution| found.push(solution)).unwrap();
        prop_assert_eq!((outcome.paths, outcome.lost, outcome.at_infinity), (2, 0, 0));
        let diagonal = Plane::new(ground - crank * cosine, -crank * sine);
        let mut expected = 0;
        for assembly in Assembly::BOTH {
            let Ok((first, _)) = circle_circle(coupler, rocker, diagonal, assembly) else {
                continue;
            };
            expected += 1;
            let direction = first.scale(1.0 / coupler);
            let nearest = found
                .iter()
                .map(|solution| {
                    let [c, s, ..] = solution.values;
                    let condition = solution.condition.min(1.0 / f64::EPSILON.sqrt());
                    (c - direction.x).hypot(s - direction.y) / (64.0 * f64::EPSILON * condition)
                })
                .fold(f64::INFINITY, f64::min);
            prop_assert!(nearest <= 1.0, "{} {:?} {:?}", nearest, found, direction);
        }
        prop_assert_eq!(found.iter().map(|solution| solution.multiplicity).sum::<usize>(), expected);
    }
}
