//! Newton's method on fewer equations than there are quantities.

/// Steps at most.
const STEPS: usize = 40;

/// Equations at given values.
pub struct Linearised {
    /// The left side of each, less its right side.
    pub left: Vec<f64>,
    /// What of it may be rounding.
    pub rounding: Vec<f64>,
    /// The derivatives of each by the values.
    pub jacobian: Vec<Vec<f64>>,
}

/// Values at which equations hold, as near to given ones as steps of least norm lead; none where they do not lead
/// there.
///
/// Each value changes in proportion to its size, but for an angle, the size of which is a radian.
pub fn closed(
    values: &[f64],
    is_angle: impl Fn(usize) -> bool,
    linearised: impl Fn(&[f64]) -> Linearised,
) -> Option<Vec<f64>> {
    let mut values = values.to_vec();
    for _ in 0..STEPS {
        let Linearised {
            left,
            rounding,
            mut jacobian,
        } = linearised(&values);
        if left.iter().zip(rounding).all(|(left, rounding)| left.abs() <= rounding) {
            return Some(values);
        }
        let size = |place: usize, value: f64| if is_angle(place) { 1.0 } else { value.abs() };
        let sizes: Vec<f64> = (0..).zip(&values).map(|(place, value)| size(place, *value)).collect();
        let mut right: Vec<f64> = left.iter().map(|left| -left).collect();
        for (row, right) in jacobian.iter_mut().zip(&mut right) {
            for (entry, size) in row.iter_mut().zip(&sizes) {
                *entry *= size;
            }
            let largest = row.iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
            for entry in row {
                *entry /= largest;
            }
            *right /= largest;
        }
        let step = least_norm(&jacobian, right);
        let longest = step.iter().fold(0.0_f64, |longest, entry| longest.max(entry.abs()));
        if !longest.is_finite() {
            return None;
        }
        // A length changes by less than half in one step, so that it keeps its sign.
        let shortened = (0.4 / longest).min(1.0);
        for ((value, size), step) in values.iter_mut().zip(sizes).zip(step) {
            *value += shortened * size * step;
        }
    }
    None
}

/// The solution of least norm of fewer equations than there are unknowns.
fn least_norm(matrix: &[Vec<f64>], right: Vec<f64>) -> Vec<f64> {
    let dot = |one: &[f64], other: &[f64]| -> f64 { one.iter().zip(other).map(|(one, other)| one * other).sum() };
    let normal = |row: &Vec<f64>| matrix.iter().map(|other| dot(row, other)).collect();
    let weights = solved(matrix.iter().map(normal).collect(), right);
    let columns = matrix.first().map_or(0, Vec::len);
    (0..columns)
        .map(|column| {
            matrix
                .iter()
                .zip(&weights)
                .map(|(row, weight)| row[column] * weight)
                .sum()
        })
        .collect()
}

/// The solution by Gauss's and Jordan's elimination, rows exchanged for the largest pivot; it is not finite where there
/// is none.
fn solved(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Vec<f64> {
    for step in 0..right.len() {
        let magnitude = |row: &usize| matrix[*row][step].abs();
        let pivot = (step..right.len()).max_by(|one, other| magnitude(one).total_cmp(&magnitude(other)));
        let pivot = pivot.unwrap_or(step);
        matrix.swap(step, pivot);
        right.swap(step, pivot);
        let (own, own_right) = (matrix[step].clone(), right[step]);
        for row in (0..right.len()).filter(|&row| row != step) {
            let factor = matrix[row][step] / own[step];
            for (entry, own) in matrix[row].iter_mut().zip(&own) {
                *entry -= factor * own;
            }
            right[row] -= factor * own_right;
        }
    }
    (0..)
        .zip(right)
        .map(|(step, right)| right / matrix[step][step])
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{Linearised, closed, least_norm};

    #[test]
    fn the_shortest_of_many_solutions() {
        assert_eq!(least_norm(&[vec![3.0, 4.0]], vec![50.0]), [6.0, 8.0]);
    }

    #[test]
    fn a_point_on_a_circle() {
        let circle = |values: &[f64]| Linearised {
            left: vec![values[0] * values[0] + values[1] * values[1] - 25.0],
            rounding: vec![1e-12],
            jacobian: vec![vec![2.0 * values[0], 2.0 * values[1]]],
        };
        let found = closed(&[1.0, -2.0], |_| false, circle).expect("it is reached");
        assert!(found[0] > 0.0 && found[1] < 0.0);
        assert!(circle(&found).left[0].abs() <= 1e-12);
        let nowhere = |values: &[f64]| Linearised {
            left: vec![1.0 + values[0] * values[0]],
            rounding: vec![0.0],
            jacobian: vec![vec![2.0 * values[0]]],
        };
        assert_eq!(closed(&[1.0], |_| false, nowhere), None);
    }
}
