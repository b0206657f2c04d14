//! The zeros of a polynomial in Bernstein's form.

use super::COEFFICIENTS;

/// Beyond this many halvings, two zeros are one that touches.
const HALVINGS: usize = 44;

/// The points where a piece changes its sign, in ascending order of their part of the piece.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Zeros {
    points: [f64; COEFFICIENTS],
    count: usize,
    next: usize,
}

impl Zeros {
    fn push(&mut self, point: f64) {
        if let Some(entry) = self.points.get_mut(self.count) {
            *entry = point;
            self.count += 1;
        }
    }
}

impl Iterator for Zeros {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        let point = self.points.get(self.next).filter(|_| self.next < self.count)?;
        self.next += 1;
        Some(*point)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.count - self.next, Some(self.count - self.next))
    }
}

impl ExactSizeIterator for Zeros {}

/// Isolates the changes of sign by Descartes' rule: there are at most as many as the coefficients have, and exactly one
/// if they have one. Halving by de Casteljau's rule never adds any. (J. M. Lane and R. F. Riesenfeld, Bounds on a
/// polynomial, BIT 21, 1981, 112-117.)
///
/// A zero counts as positive, so that neighbouring pieces agree about a zero on their border.
pub(super) fn isolate(ends: [f64; 2], coefficients: &[f64]) -> Zeros {
    let mut zeros = Zeros {
        points: [0.0; COEFFICIENTS],
        count: 0,
        next: 0,
    };
    let mut padded = [0.0; COEFFICIENTS];
    padded[..coefficients.len()].copy_from_slice(coefficients);
    search(ends, &padded, coefficients.len(), HALVINGS, &mut zeros);
    zeros
}

fn search(ends: [f64; 2], coefficients: &[f64; COEFFICIENTS], length: usize, halvings: usize, zeros: &mut Zeros) {
    let signs = coefficients[..length].windows(2);
    let changes = signs.filter(|pair| (pair[0] < 0.0) != (pair[1] < 0.0)).count();
    let middle = f64::midpoint(ends[0], ends[1]);
    if changes == 0 {
        return;
    }
    if halvings == 0 || middle == ends[0] || middle == ends[1] {
        if changes % 2 == 1 {
            zeros.push(middle);
        }
        return;
    }
    let [left, right] = halved(coefficients, length);
    search([ends[0], middle], &left, length, halvings - 1, zeros);
    search([middle, ends[1]], &right, length, halvings - 1, zeros);
}

/// The coefficients of both halves.
fn halved(coefficients: &[f64; COEFFICIENTS], length: usize) -> [[f64; COEFFICIENTS]; 2] {
    let mut right = *coefficients;
    let mut left = [0.0; COEFFICIENTS];
    for (step, corner) in left.iter_mut().enumerate().take(length) {
        *corner = right[0];
        for index in 0..length - 1 - step {
            right[index] = f64::midpoint(right[index], right[index + 1]);
        }
    }
    [left, right]
}
