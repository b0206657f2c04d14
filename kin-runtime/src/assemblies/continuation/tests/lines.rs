//! Products of lines, which meet in known points.

use std::vec::Vec;

use proptest::prelude::*;

use super::super::{Solution, real_solutions};
use super::table::Table;

/// A line n · x = distance, given by its direction.
#[derive(Clone, Copy, Debug)]
struct Line {
    normal: [f64; 2],
    distance: f64,
}

fn line() -> impl Strategy<Value = Line> {
    (-3.0_f64..3.0, -1.0_f64..1.0).prop_map(|(angle, distance)| Line {
        normal: [angle.cos(), angle.sin()],
        distance,
    })
}

/// The terms of a product of lines.
fn add_product(table: &mut Table, equation: usize, lines: &[Line]) {
    // The coefficients, by the powers of x and y.
    let mut product = Vec::from([((0_u8, 0_u8), 1.0)]);
    for line in lines {
        let mut next: Vec<((u8, u8), f64)> = Vec::new();
        for &((i, j), coefficient) in &product {
            for (powers, factor) in [
                ((i + 1, j), line.normal[0]),
                ((i, j + 1), line.normal[1]),
                ((i, j), -line.distance),
            ] {
                match next.iter_mut().find(|(known, _)| *known == powers) {
                    Some((_, sum)) => *sum += coefficient * factor,
                    None => next.push((powers, coefficient * factor)),
                }
            }
        }
        product = next;
    }
    for ((i, j), coefficient) in product {
        let mut powers = Vec::new();
        if i > 0 {
            powers.push((0, i));
        }
        if j > 0 {
            powers.push((1, j));
        }
        table.add(equation, coefficient, &powers);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn three_lines_meet_two(
        three in proptest::array::uniform3(line()), two in proptest::array::uniform2(line()), exponent in -6_i32..=6
    ) {
        let unit = 10.0_f64.powi(exponent);
        let mut points = Vec::new();
        for a in three {
            for b in two {
                let determinant = a.normal[0] * b.normal[1] - a.normal[1] * b.normal[0];
                points.push([
                    (a.distance * b.normal[1] - b.distance * a.normal[1]) / determinant,
                    (a.normal[0] * b.distance - b.normal[0] * a.distance) / determinant,
                ]);
            }
        }
        let apart = points
            .iter()
            .enumerate()
            .flat_map(|(k, p)| points[..k].iter().map(move |q| (p[0] - q[0]).hypot(p[1] - q[1])))
            .fold(f64::INFINITY, f64::min);
        prop_assume!(apart > 1e-2 && points.iter().all(|[x, y]| x.hypot(*y) < 1e2));
        let scaled = |line: Line| Line { normal: line.normal, distance: line.distance * unit };
        let mut table = Table::default();
        add_product(&mut table, 0, &three.map(scaled));
        add_product(&mut table, 1, &two.map(scaled));
        let mut found: Vec<Solution<2>> = Vec::new();
        let outcome =
            real_solutions::<2, 6>(&table.system(), &table.coefficients, |solution| found.push(solution)).unwrap();
        prop_assert_eq!((outcome.paths, outcome.regular, outcome.real), (6, 6, 6));
        for [x, y] in points {
            let near = found.iter().any(|solution| {
                let distance = (solution.values[0] / unit - x).hypot(solution.values[1] / unit - y);
                distance <= 64.0 * f64::EPSILON * solution.condition * (1.0 + x.hypot(y)).powi(2)
            });
            prop_assert!(near, "{} {} {:?}", x, y, found);
        }
    }
}
