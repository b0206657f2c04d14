//! Singular values of a small matrix of series.
//!
//! The method is that of M. R. Hestenes, *Inversion of matrices by biorthogonalization and related results*, Journal of
//! the Society for Industrial and Applied Mathematics 6 (1958), 51-90: columns are rotated in pairs until all are at
//! right angles, and their lengths are the singular values. In series the rotations are series, too, and each pass at
//! least doubles the number of terms that are right.
//!
//! Where two columns of equal length are at right angles, the first terms in which they differ determine the rotation.
//! So values that cross, or that pass through zero, have the series of an analytic decomposition. (A. Bunse-Gerstner,
//! R. Byers, V. Mehrmann & N. K. Nichols, *Numerical computation of an analytic singular value decomposition of a
//! matrix valued function*, Numerische Mathematik 60 (1991), 1-39.)

use alloc::vec::Vec;

use super::Number;
use super::series::{Series, SeriesOf};

/// The most passes over all pairs. Six are enough for numbers.
const PASSES: usize = 24;
/// The rounding error of a coefficient, as a part of the sum of its terms' sizes.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Whether columns are rotated by constant angles or by series.
#[derive(Clone, Copy, PartialEq)]
enum Rotations {
    Constant,
    Changing,
}

/// A column, and the rounding error of its constant terms.
struct RotatedColumn<const N: usize> {
    entries: Vec<Series<N>>,
    error: f64,
}

/// The singular values of a matrix, the largest first. The matrix is given in rows of so many columns, and has as many
/// values as its smaller side has entries. All of them are at least zero.
///
/// Where two values are equal, or where one is zero, they have kinks, and the series are those on the right side of it:
/// behind the kink if the variable of the series grows.
pub(crate) fn singular_values<const N: usize>(rows: &[Series<N>], width: usize) -> Vec<Series<N>> {
    let height = rows.len().checked_div(width).unwrap_or(0);
    let column = |index: usize| -> RotatedColumn<N> {
        // the transposed matrix has the same values
        let entries: Vec<Series<N>> = if height >= width {
            (0..height).map(|row| rows[row * width + index]).collect()
        } else {
            rows[index * width..(index + 1) * width].to_vec()
        };
        let error = f64::EPSILON * size_of_constants(&entries);
        RotatedColumn { entries, error }
    };
    let mut columns: Vec<RotatedColumn<N>> = (0..width.min(height)).map(column).collect();
    // The constant terms first: columns on their way to right angles may be nearly alike, and series of their rotations
    // would grow.
    for rotations in [Rotations::Constant, Rotations::Changing] {
        for _ in 0..PASSES {
            let mut is_rotated = false;
            for second in 1..columns.len() {
                let (before, behind) = columns.split_at_mut(second);
                for first in before {
                    is_rotated |= rotate(first, &mut behind[0], rotations);
                }
            }
            if !is_rotated {
                break;
            }
        }
    }
    let mut values: Vec<Series<N>> = columns.iter().map(length).collect();
    if width == height
        && let Some((shortest, value)) = shortest_length(&columns)
    {
        values[shortest] = value;
    }
    // equal values are in the order that they have behind the kink
    values.sort_by(|one, other| {
        let mut terms = other.coefficients().into_iter().zip(one.coefficients());
        terms
            .find_map(|(one, other)| Some(one.total_cmp(&other)).filter(|order| order.is_ne()))
            .unwrap_or(core::cmp::Ordering::Equal)
    });
    values
}

/// Rotates two columns until they are at right angles, unless they are.
fn rotate<const N: usize>(first: &mut RotatedColumn<N>, second: &mut RotatedColumn<N>, rotations: Rotations) -> bool {
    let mut across = Series::ZERO;
    let mut longer = Series::ZERO;
    let mut terms = [Series::<N>::ZERO; 2];
    for (a, b) in first.entries.iter().zip(&second.entries) {
        across = across + *a * *b;
        longer = longer + (*a - *b) * (*a + *b);
        let [a, b] = [sizes(*a), sizes(*b)];
        terms = [terms[0] + a * b, terms[1] + (a + b) * (a + b)];
    }
    let mut across = without_rounding(across, terms[0]);
    let mut longer = without_rounding(longer, terms[1]);
    if rotations == Rotations::Constant {
        [across, longer] = [across, longer].map(|series| Series::constant(series.real()));
    }
    if across.coefficients() == [0.0; N] {
        return false;
    }
    // The columns of equal length are rotated as their first difference says. It is lost in the last terms of the
    // rotation, which multiply it.
    let order = first_order([across, longer]);
    let [across, longer] = [shifted(across + across, order), shifted(longer, order)];
    // by no more than an eighth of a revolution, without which the passes need not end
    let (sine, cosine) = if longer.real() < 0.0 {
        halved((-across).atan2(-longer))
    } else {
        halved(across.atan2(longer))
    };
    let [length, other] = [size_of_constants(&first.entries), size_of_constants(&second.entries)];
    for (a, b) in first.entries.iter_mut().zip(&mut second.entries) {
        (*a, *b) = (cosine * *a + sine * *b, cosine * *b - sine * *a);
    }
    let [sine, cosine] = [sine.real().abs(), cosine.real()];
    let errors = [first.error, second.error];
    first.error = cosine * errors[0] + sine * errors[1] + f64::EPSILON * (cosine * length + sine * other);
    second.error = cosine * errors[1] + sine * errors[0] + f64::EPSILON * (cosine * other + sine * length);
    true
}

/// The sine and the cosine of half an angle.
fn halved<const N: usize>(angle: Series<N>) -> (Series<N>, Series<N>) {
    (angle * Series::constant(0.5)).sin_cos()
}

/// The length of the shortest column of a square matrix, along the only direction at right angles to all others. Its
/// direction, which is that of small numbers with large rounding errors, is not needed. `None` if the others are too
/// short to have directions.
fn shortest_length<const N: usize>(columns: &[RotatedColumn<N>]) -> Option<(usize, Series<N>)> {
    let sizes = columns.iter().map(|column| size_of_constants(&column.entries));
    let (shortest, _) = sizes.enumerate().min_by(|one, other| one.1.total_cmp(&other.1))?;
    let others = columns.iter().enumerate().filter(|(index, _)| *index != shortest);
    let mut triangle: Vec<Vec<Series<N>>> = others.map(|(_, column)| column.entries.clone()).collect();
    triangle.push(columns[shortest].entries.clone());
    // Givens rotations of rows, with the largest entry of a column as its pivot
    let last = columns.len() - 1;
    for step in 0..last {
        let size = |row: &usize| triangle[step][*row].real().abs();
        let pivot = (step..=last).max_by(|one, other| size(one).total_cmp(&size(other)))?;
        for column in &mut triangle {
            column.swap(step, pivot);
        }
        for row in step + 1..=last {
            let [x, y] = [triangle[step][step], triangle[step][row]];
            let radius = (x * x + y * y).sqrt();
            let [cosine, sine] = [x / radius, y / radius];
            for column in &mut triangle[step..] {
                let [one, other] = [column[step], column[row]];
                column[step] = cosine * one + sine * other;
                column[row] = cosine * other - sine * one;
            }
        }
    }
    let mut height = triangle[last][last].coefficients();
    if height[0].abs() <= 2.0 * columns[shortest].error {
        height[0] = 0.0;
    }
    // on the right side of a zero
    let sign = height
        .iter()
        .find(|term| **term != 0.0)
        .map_or(1.0, |term| term.signum());
    let length = Series::from_coefficients(height.map(|term| if term == 0.0 { 0.0 } else { sign * term }));
    Number::is_finite(length).then_some((shortest, length))
}

/// The length of a column: t to some power times that of the column without this power, so that a root is never that of
/// zero.
fn length<const N: usize>(column: &RotatedColumn<N>) -> Series<N> {
    let mut entries = column.entries.clone();
    let clear = |entries: &mut [Series<N>]| {
        for entry in entries {
            let mut coefficients = entry.coefficients();
            coefficients[0] = 0.0;
            *entry = Series::from_coefficients(coefficients);
        }
    };
    if size_of_constants(&entries) <= 2.0 * column.error {
        clear(&mut entries);
    }
    let found = regular_length(&entries);
    if Number::is_finite(found) {
        return found;
    }
    // a length whose powers are smaller than any number
    clear(&mut entries);
    regular_length(&entries)
}

fn regular_length<const N: usize>(entries: &[Series<N>]) -> Series<N> {
    let order = entries.iter().map(|entry| first_order([*entry])).min().unwrap_or(N);
    let entries = || entries.iter().map(|entry| shifted(*entry, order));
    let size = size_of_constants(&entries().collect::<Vec<_>>());
    if size == 0.0 {
        return Series::ZERO;
    }
    // Along the direction of the constant terms the column is long. What is across begins with the first power, and its
    // root needs no differences.
    let along = entries().fold(Series::ZERO, |sum, entry| {
        sum + entry * Series::constant(entry.real() / size)
    });
    let slope = entries().fold(Series::ZERO, |sum, entry| {
        let mut coefficients = (entry - along * Series::constant(entry.real() / size)).coefficients();
        coefficients[0] = 0.0;
        let slope = Series::from_coefficients(coefficients) / along;
        sum + slope * slope
    });
    let length = (along * (Series::constant(1.0) + slope).sqrt()).coefficients();
    Series::from_coefficients(core::array::from_fn(|power| {
        power.checked_sub(order).map_or(0.0, |power| length[power])
    }))
}

/// The length of the constant terms, whose squares need not be in the range of numbers.
fn size_of_constants<const N: usize>(entries: &[Series<N>]) -> f64 {
    let largest = entries
        .iter()
        .fold(0.0, |largest: f64, entry| largest.max(entry.real().abs()));
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    let squares = entries
        .iter()
        .map(|entry| (entry.real() / largest) * (entry.real() / largest));
    largest * Number::sqrt(squares.sum::<f64>())
}

fn sizes<const N: usize>(series: Series<N>) -> Series<N> {
    Series::from_coefficients(series.coefficients().map(f64::abs))
}

/// The series without coefficients that rounding makes, from the sizes of their terms.
fn without_rounding<const N: usize>(series: Series<N>, terms: Series<N>) -> Series<N> {
    let (mut coefficients, terms) = (series.coefficients(), terms.coefficients());
    for (coefficient, terms) in coefficients.iter_mut().zip(terms) {
        if coefficient.abs() <= ROUNDING * terms {
            *coefficient = 0.0;
        }
    }
    Series::from_coefficients(coefficients)
}

/// The lowest power whose coefficient is not zero.
fn first_order<const N: usize, const C: usize>(series: [Series<N>; C]) -> usize {
    let series = series.map(|series| series.coefficients());
    (0..N)
        .find(|power| series.iter().any(|series| series[*power] != 0.0))
        .unwrap_or(N)
}

/// The series over a power of its variable. The last terms are not known, and are zero.
pub(crate) fn shifted<T: Number, const N: usize>(series: SeriesOf<T, N>, order: usize) -> SeriesOf<T, N> {
    let coefficients = series.coefficients();
    SeriesOf::from_coefficients(core::array::from_fn(|power| {
        coefficients.get(power + order).copied().unwrap_or(T::constant(0.0))
    }))
}

#[cfg(test)]
mod tests {
    use super::singular_values;
    use crate::number::Number;
    use crate::number::series::Series;
    use std::vec;
    use std::vec::Vec;

    type Fifth = Series<5>;

    fn close(found: &[Fifth], expected: &[[f64; 5]]) {
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(expected) {
            for (found, expected) in found.coefficients().into_iter().zip(expected) {
                assert!(
                    (found - expected).abs() <= 1e-13 * (1.0 + expected.abs()),
                    "{found} {expected}"
                );
            }
        }
    }

    /// The matrix U S Vᵀ of two rows and columns with angles that change.
    fn composed(angles: [Fifth; 2], values: [Fifth; 2]) -> Vec<Fifth> {
        let [(su, cu), (sv, cv)] = angles.map(Number::sin_cos);
        let [s, t] = values;
        vec![
            cu * s * cv + su * t * sv,
            cu * s * sv - su * t * cv,
            su * s * cv - cu * t * sv,
            su * s * sv + cu * t * cv,
        ]
    }

    fn angles() -> [Fifth; 2] {
        [
            Series::from_coefficients([0.4, 0.7, -0.3, 0.2, 0.1]),
            Series::from_coefficients([-1.1, 0.5, 0.6, -0.4, 0.3]),
        ]
    }

    #[test]
    fn are_those_of_which_a_matrix_is_made() {
        let values = [[2.0, 0.3, -0.2, 0.4, 0.1], [0.5, -0.6, 0.1, 0.2, -0.3]];
        let rows = composed(angles(), values.map(Series::from_coefficients));
        close(&singular_values(&rows, 2), &values);
        // small beside large ones, to the rounding of the large ones
        let values = [[2.0, 0.3, -0.2, 0.4, 0.1], [1e-7, 3e-8, 1e-8, 0.0, -2e-8]];
        let rows = composed(angles(), values.map(Series::from_coefficients));
        close(&singular_values(&rows, 2), &values);
    }

    #[test]
    fn of_rectangles_and_of_nothing() {
        let one = Fifth::from_derivatives([3.0, 1.0, 0.5, 0.0, 0.0]);
        let other = Fifth::from_derivatives([4.0, -1.0, 0.0, 2.0, 0.0]);
        let length = (one * one + other * other).sqrt().coefficients();
        close(&singular_values(&[one, other], 1), &[length]);
        close(&singular_values(&[one, other], 2), &[length]);
        let wide = singular_values(&[one, other, Series::ZERO, -other, one, Series::ZERO], 3);
        close(&wide, &[length, length]);
        assert!(singular_values::<5>(&[], 0).is_empty());
        close(&singular_values(&[Fifth::ZERO; 6], 3), &[[0.0; 5]; 2]);
        let tiny = Fifth::from_coefficients([1e-200, 1.0, 0.0, 0.0, 0.0]);
        close(&singular_values(&[tiny, Series::ZERO], 1), &[tiny.coefficients()]);
    }

    /// At a crossing, the series are those behind it.
    #[test]
    fn at_crossings_and_zeros() {
        let values = [[2.0, -0.5, 0.3, 0.1, -0.2], [2.0, 0.4, 0.2, -0.1, 0.3]];
        let rows = composed(angles(), values.map(Series::from_coefficients));
        close(&singular_values(&rows, 2), &[values[1], values[0]]);
        // that touch
        let values = [[2.0, 0.4, 0.3, 0.1, -0.2], [2.0, 0.4, 0.2, -0.1, 0.3]];
        let rows = composed(angles(), values.map(Series::from_coefficients));
        close(&singular_values(&rows, 2), &values);
        // through zero
        let values = [[2.0, -0.5, 0.3, 0.1, -0.2], [0.0, -0.4, 0.2, -0.1, 0.3]];
        let rows = composed(angles(), values.map(Series::from_coefficients));
        close(&singular_values(&rows, 2), &[values[0], [0.0, 0.4, -0.2, 0.1, -0.3]]);
        // a double zero
        let values = [[0.0, -0.5, 0.3, 0.1, -0.2], [0.0, 0.4, 0.2, -0.1, 0.3]];
        let rows = composed(angles(), values.map(Series::from_coefficients));
        close(
            &singular_values(&rows, 2),
            &[values[0].map(|term: f64| -term), values[1]],
        );
    }

    /// The values of nalgebra, with their first derivatives uᵀ A' v, of matrices up to six by six.
    #[test]
    fn are_those_of_nalgebra() {
        let mut random = crate::verify::Random::new(11);
        for (height, width) in [(1, 1), (2, 2), (3, 2), (2, 4), (3, 3), (6, 6), (6, 4)] {
            for _ in 0..40 {
                let rows: Vec<Fifth> = (0..height * width)
                    .map(|_| Series::from_coefficients(core::array::from_fn(|_| random.between(-1.0, 1.0))))
                    .collect();
                let found = singular_values(&rows, width);
                let matrix = |power: usize| {
                    nalgebra::DMatrix::from_row_iterator(
                        height,
                        width,
                        rows.iter().map(|entry| entry.coefficients()[power]),
                    )
                };
                let expected = matrix(0).svd(true, true);
                let (left, right) = (expected.u.unwrap(), expected.v_t.unwrap());
                let mut expected: Vec<(f64, f64)> = (0..height.min(width))
                    .map(|index| {
                        let slope = left.column(index).transpose() * matrix(1) * right.row(index).transpose();
                        (expected.singular_values[index], slope[(0, 0)])
                    })
                    .collect();
                expected.sort_by(|one, other| other.0.total_cmp(&one.0));
                for (found, (value, slope)) in found.iter().zip(expected) {
                    let [one, other, ..] = found.coefficients();
                    assert!(
                        (one - value).abs() < 1e-13 && (other - slope).abs() < 1e-11,
                        "{found:?} {value} {slope}"
                    );
                }
                // the sum of their squares is that of all entries, at all orders: as far as the largest of its terms
                let square = |sum: Fifth, entry: Fifth| sum + entry * entry;
                let sum = |all: &[Fifth]| all.iter().copied().fold(Fifth::ZERO, square).coefficients();
                let terms = found
                    .iter()
                    .copied()
                    .map(super::sizes)
                    .fold(Fifth::ZERO, square)
                    .coefficients();
                for (power, (one, other)) in sum(&found).into_iter().zip(sum(&rows)).enumerate() {
                    assert!(
                        (one - other).abs() < 1e-11 * terms[power],
                        "{height} by {width}, power {power}: {one} {other}, {found:?}"
                    );
                }
            }
        }
    }
}
