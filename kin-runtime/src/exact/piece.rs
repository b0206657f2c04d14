//! One piece between two rows.

/// The largest number of numbers of a column in a row: the value and four derivatives.
pub(super) const MOST_NUMBERS: usize = 5;

/// The value and the derivatives of a column between two rows that are `length` apart, at the part `part` of the way.
///
/// `left` and `right` hold the value and the derivatives at the two rows. The result is the polynomial of the lowest
/// degree that agrees with both: the Taylor polynomial of the left row, and a correction, which is a power of `part`
/// times the rest of the right row as a polynomial about it. (C. Hermite, *Sur la formule d'interpolation de Lagrange*,
/// Journal für die reine und angewandte Mathematik 84, 1878, 70-79.) The correction is small, so its powers of `part`
/// may cancel each other without harm.
///
/// The programs in other languages do the same operations in the same order.
pub(super) fn piece(left: &[f64], right: &[f64], length: f64, part: f64, result: &mut [f64]) {
    let count = left.len().min(right.len()).min(result.len()).min(MOST_NUMBERS);
    let mut powers = [0.0; 2 * MOST_NUMBERS];
    let mut rest = [0.0; MOST_NUMBERS];
    let mut factor = 1.0;
    for order in 0..count {
        powers[order] = left[order] * factor;
        rest[order] = right[order] * factor;
        factor *= length / number(order + 1);
    }
    // the left row's polynomial about the right row; the difference of the values comes first, for it is exact
    let mut moved = [0.0; MOST_NUMBERS];
    moved[..count].copy_from_slice(&powers[..count]);
    moved[0] -= rest[0];
    rest[0] = 0.0;
    shift(&mut moved[..count], 1.0, count);
    for order in 0..count {
        rest[order] -= moved[order];
    }
    // divided by a power of the part, which is 1 at the right row
    for _ in 0..count {
        for order in 1..count {
            rest[order] -= rest[order - 1];
        }
    }
    shift(&mut rest[..count], -1.0, count);
    powers[count..2 * count].copy_from_slice(&rest[..count]);
    shift(&mut powers[..2 * count], part, count);
    factor = 1.0;
    for order in 0..count {
        result[order] = powers[order] * factor;
        factor *= number(order + 1) / length;
    }
}

/// The first coefficients of a polynomial about another point, by Horner's scheme.
fn shift(coefficients: &mut [f64], way: f64, count: usize) {
    for first in 0..count {
        for index in (first..coefficients.len() - 1).rev() {
            coefficients[index] += way * coefficients[index + 1];
        }
    }
}

#[expect(clippy::cast_precision_loss, reason = "it is the order of a derivative")]
fn number(order: usize) -> f64 {
    order as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The derivatives of a polynomial with the given coefficients.
    fn polynomial(coefficients: &[f64], at: f64, count: usize) -> std::vec::Vec<f64> {
        let mut shifted = coefficients.to_vec();
        shift(&mut shifted, at, count);
        let mut factorial = 1.0;
        for (order, value) in shifted.iter_mut().enumerate().take(count) {
            *value *= factorial;
            factorial *= number(order + 1);
        }
        shifted.truncate(count);
        shifted
    }

    /// With values and n derivatives at both ends, polynomials of degree 2n + 1 are equal to their pieces, and none of
    /// a higher degree.
    #[test]
    fn a_piece_of_a_polynomial_is_the_polynomial() {
        let coefficients = [0.3, -1.0, 2.0, 0.5, -0.7, 1.1, 0.2, -0.4, 0.9, -0.6, 0.8];
        let (start, length) = (-0.5, 1.75);
        for count in 1..=MOST_NUMBERS {
            for degree in [2 * count - 1, 2 * count] {
                let coefficients = &coefficients[..=degree];
                let ends = [start, start + length].map(|at| polynomial(coefficients, at, count));
                let mut worst: f64 = 0.0;
                for part in [0.0, 0.1, 0.5, 0.83, 1.0] {
                    let mut found = [0.0; MOST_NUMBERS];
                    piece(&ends[0], &ends[1], length, part, &mut found[..count]);
                    let expected = polynomial(coefficients, start + part * length, count);
                    for (order, expected) in expected.into_iter().enumerate() {
                        let size = 20_f64.powi(i32::try_from(order).unwrap());
                        worst = worst.max((found[order] - expected).abs() / size);
                    }
                }
                assert_eq!(
                    worst < 1e-12,
                    degree < 2 * count,
                    "{count} numbers, degree {degree}: {worst}"
                );
            }
        }
    }

    /// A piece ends in the numbers of its rows, but for rounding.
    #[test]
    fn a_piece_ends_in_its_rows() {
        let length = 0.25;
        let rows = [0.3_f64, 0.3 + length].map(|at| {
            let (sine, cosine) = at.sin_cos();
            [6.0 + sine, cosine, -sine, -cosine, sine]
        });
        for (part, row) in [(0.0, rows[0]), (1.0, rows[1])] {
            let mut found = [0.0; MOST_NUMBERS];
            piece(&rows[0], &rows[1], length, part, &mut found);
            for (order, (found, expected)) in found.into_iter().zip(row).enumerate() {
                // Values below 7 are rounded by 4 ε. A derivative divides that by a power of the length, and the fourth
                // one of the correction has coefficients up to 840.
                let allowed = 4.0 * f64::EPSILON * (1.0 + 840.0 * length.powi(-i32::try_from(order).unwrap()));
                assert!(
                    (found - expected).abs() <= allowed,
                    "{order} at {part}: {found} {expected}"
                );
            }
        }
    }
}
