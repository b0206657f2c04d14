//! One piece of a curve.

use super::zeros::{Zeros, isolate};
use super::{COEFFICIENTS, TERMS};
use crate::number::series::Series;

/// A polynomial of degree 9 with given value and derivatives at both ends.
///
/// It is kept by its Bernstein coefficients. Those next to an end follow from the derivatives there by differences: the
/// k-th forward difference of the first coefficients is the k-th derivative, times hᵏ (9 - k)! / 9! for a piece of the
/// length h. (G. Farin, *Curves and Surfaces for CAGD*, 5th edition, Morgan Kaufmann 2002, section 5.3.)
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Piece {
    ends: [f64; 2],
    coefficients: [f64; COEFFICIENTS],
    /// The slopes at both ends, times the length, without the rounding errors of differences: neighbouring pieces share
    /// their signs.
    slopes: [f64; 2],
}

impl Piece {
    /// The piece between two points, from the series at each of them.
    #[must_use]
    pub(crate) fn new(ends: [f64; 2], series: [Series<TERMS>; 2]) -> Self {
        let length = ends[1] - ends[0];
        let mut coefficients = [0.0; COEFFICIENTS];
        for (end, (series, length)) in series.into_iter().zip([length, -length]).enumerate() {
            // The differences at the end; seen from the right end, the piece runs backwards.
            let mut differences = series.coefficients();
            let mut factor = 1.0;
            for (order, difference) in differences.iter_mut().enumerate().skip(1) {
                // times h over the number of the orders left: k! of the series' coefficient stands against (9 - k)! /
                // 9!
                factor *= length * count(order) / count(COEFFICIENTS - order);
                *difference *= factor;
            }
            for step in 0..TERMS {
                let coefficient = differences[0];
                for order in 0..TERMS - 1 - step {
                    differences[order] += differences[order + 1];
                }
                let index = if end == 0 { step } else { COEFFICIENTS - 1 - step };
                coefficients[index] = coefficient;
            }
        }
        Self {
            ends,
            coefficients,
            slopes: series.map(|series| length * series.coefficients()[1]),
        }
    }

    /// The value and four derivatives at a point, as a series.
    #[must_use]
    pub(crate) fn at(&self, at: f64) -> Series<TERMS> {
        let length = self.ends[1] - self.ends[0];
        let part = (at - self.ends[0]) / length;
        let mut coefficients = self.coefficients;
        let mut derivatives = [0.0; TERMS];
        let mut factor = 1.0;
        for (order, derivative) in derivatives.iter_mut().enumerate() {
            *derivative = factor * value(&coefficients[..COEFFICIENTS - order], part);
            differentiate(&mut coefficients[..COEFFICIENTS - order]);
            factor /= length;
        }
        Series::from_derivatives(derivatives)
    }

    /// The largest and the smallest number that the piece may reach: those of its coefficients.
    #[must_use]
    pub(crate) fn bounds(&self) -> [f64; 2] {
        let fold = |start: f64, choose: fn(f64, f64) -> f64| self.coefficients.into_iter().fold(start, choose);
        [fold(f64::INFINITY, f64::min), fold(f64::NEG_INFINITY, f64::max)]
    }

    /// The points where the piece crosses a level. Each is found once, also on the border of two pieces.
    #[must_use]
    pub(crate) fn crossings(&self, level: f64) -> Zeros {
        isolate(self.ends, &self.coefficients.map(|coefficient| coefficient - level))
    }

    /// The points where the slope of the piece changes its sign. Each is found once, also on the border of two pieces.
    #[must_use]
    pub(crate) fn stationary_points(&self) -> Zeros {
        let mut slope = self.coefficients;
        differentiate(&mut slope);
        [slope[0], slope[COEFFICIENTS - 2]] = self.slopes;
        isolate(self.ends, &slope[..COEFFICIENTS - 1])
    }
}

/// Replaces the coefficients by those of the derivative, which are one fewer.
fn differentiate(coefficients: &mut [f64]) {
    let degree = count(coefficients.len() - 1);
    for index in 1..coefficients.len() {
        coefficients[index - 1] = degree * (coefficients[index] - coefficients[index - 1]);
    }
}

/// The value at a part of the piece. (P. de Casteljau, 1959.)
fn value(coefficients: &[f64], part: f64) -> f64 {
    let mut row = [0.0; COEFFICIENTS];
    let row = &mut row[..coefficients.len()];
    row.copy_from_slice(coefficients);
    for last in (1..row.len()).rev() {
        for index in 0..last {
            row[index] += part * (row[index + 1] - row[index]);
        }
    }
    row[0]
}

#[expect(clippy::cast_precision_loss, reason = "it is the degree of a polynomial")]
fn count(number: usize) -> f64 {
    number as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A polynomial of degree 9 is equal to its piece, in all derivatives.
    #[test]
    fn a_piece_of_a_polynomial_is_the_polynomial() {
        let polynomial = |x: f64| {
            let x = Series::<TERMS>::from_coefficients([x, 1.0, 0.0, 0.0, 0.0]);
            let mut sum = Series::from_coefficients([0.0; TERMS]);
            for coefficient in [0.3, -1.0, 2.0, 0.5, -0.7, 1.1, 0.2, -0.4, 0.9, -0.6] {
                sum = sum * x + Series::from_coefficients([coefficient, 0.0, 0.0, 0.0, 0.0]);
            }
            sum
        };
        let piece = Piece::new([-0.5, 1.25], [polynomial(-0.5), polynomial(1.25)]);
        for at in [-0.5, -0.2, 0.0, 0.3, 0.9, 1.25] {
            let (found, expected) = (piece.at(at).derivatives(), polynomial(at).derivatives());
            for (order, (found, expected)) in found.into_iter().zip(expected).enumerate() {
                let tolerance = 1e-12 * 20_f64.powi(i32::try_from(order).unwrap());
                assert!(
                    (found - expected).abs() < tolerance,
                    "{order} at {at}: {found} {expected}"
                );
            }
        }
    }

    /// The error falls with the tenth power of the length.
    #[test]
    fn the_error_has_the_tenth_order() {
        let sine = |x: f64| Series::from_derivatives([x.sin(), x.cos(), -x.sin(), -x.cos(), x.sin()]);
        let error = |length: f64| {
            let ends = [1.0 - 0.5 * length, 1.0 + 0.5 * length];
            let piece = Piece::new(ends, ends.map(sine));
            (piece.at(1.0).coefficients()[0] - 1_f64.sin()).abs()
        };
        let ratio = error(2.0) / error(1.0);
        assert!((950.0..1050.0).contains(&ratio), "{ratio}");
    }

    /// Every extreme of a wave is found once, however the pieces are cut.
    #[test]
    fn each_turn_is_found_once() {
        let wave = |x: f64| {
            let (s, c) = (7.0 * x).sin_cos();
            Series::from_derivatives([s, 7.0 * c, -49.0 * s, -343.0 * c, 2401.0 * s])
        };
        for pieces in [14_u32, 15, 28, 60] {
            let border = |index: u32| core::f64::consts::TAU * f64::from(index) / f64::from(pieces);
            let mut stationary = 0;
            let mut crossings = 0;
            for index in 0..pieces {
                let ends = [border(index), border(index + 1)];
                let piece = Piece::new(ends, ends.map(wave));
                stationary += piece.stationary_points().count();
                crossings += piece.crossings(0.5).count();
                for at in piece.stationary_points() {
                    assert!((7.0 * at).cos().abs() < 2e-3, "{at}");
                }
            }
            assert_eq!((stationary, crossings), (14, 14), "{pieces} pieces");
        }
    }
}
