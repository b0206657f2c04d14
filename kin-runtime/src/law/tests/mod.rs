//! Tests of the laws.

mod joints;
mod mistakes;
mod polynomials;
mod s_curves;
mod series;
mod shapes;

use super::{Piecewise, Scca, Shape};
use crate::number::scatter::{INCREMENT, fraction};
use std::vec::Vec;

/// Scattered numbers, the same in every run.
struct Random(u64);

impl Random {
    /// A number in 0..1.
    fn part(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(INCREMENT);
        fraction(self.0)
    }

    /// A number whose logarithm is evenly spread.
    fn size(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.part())
    }

    fn signed(&mut self, most: f64) -> f64 {
        most * (2.0 * self.part() - 1.0)
    }
}

/// Every shape, with some members of the family.
fn shapes() -> Vec<Shape> {
    let mut shapes = std::vec![
        Shape::ConstantSpeed,
        Shape::SimpleHarmonic,
        Shape::Cycloidal,
        Shape::Polynomial345,
        Shape::Polynomial4567,
        Shape::Polynomial56789,
        Shape::ModifiedSine,
        Shape::ModifiedTrapezoid,
    ];
    for [sine, constant, cosine] in [
        [0.0, 0.0, 0.0],
        [0.0, 0.5, 0.0],
        [0.2, 0.0, 0.6],
        [0.1, 0.2, 0.3],
        [0.3, 0.3, 0.4],
        [0.0, 0.4, 0.2],
        [0.7, 0.0, 0.0],
    ] {
        shapes.push(Shape::Scca(Scca::new(sine, constant, cosine).expect("they fit")));
    }
    shapes
}

/// The pieces that have a length, with their starts and ends.
fn pieces(law: &dyn Piecewise<f64>) -> Vec<(usize, f64, f64)> {
    let start = |piece: usize| if piece == 0 { 0.0 } else { law.end(piece - 1) };
    (0..law.pieces())
        .map(|piece| (piece, start(piece), law.end(piece)))
        .filter(|(_, start, end)| end > start)
        .collect()
}

fn of_piece<const N: usize>(law: &dyn Piecewise<f64>, piece: usize, time: f64) -> [f64; N] {
    let mut derivatives = [0.0; N];
    law.write(piece, time, &mut derivatives);
    derivatives
}

/// The largest absolute value of a derivative, among the ends of the pieces and the points where the next derivative
/// vanishes.
fn peak<const ORDER: usize, const N: usize>(law: &dyn Piecewise<f64>) -> f64 {
    assert_eq!(N, ORDER + 2);
    let mut most = 0.0_f64;
    for (piece, start, end) in pieces(law) {
        let there = |time: f64| of_piece::<N>(law, piece, time);
        let steps = 60;
        let time = |step: i32| start + (end - start) * f64::from(step) / f64::from(steps);
        for step in 0..steps {
            let (mut low, mut high) = (time(step), time(step + 1));
            most = most.max(there(low)[ORDER].abs()).max(there(high)[ORDER].abs());
            let rises = there(low)[ORDER + 1] > 0.0;
            if rises == (there(high)[ORDER + 1] > 0.0) {
                continue;
            }
            for _ in 0..60 {
                let middle = f64::midpoint(low, high);
                if (there(middle)[ORDER + 1] > 0.0) == rises {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            most = most.max(there(low)[ORDER].abs());
        }
    }
    most
}

/// The peaks of velocity, acceleration, jerk and snap.
fn peaks(law: &dyn Piecewise<f64>) -> [f64; 4] {
    [
        peak::<1, 3>(law),
        peak::<2, 4>(law),
        peak::<3, 5>(law),
        peak::<4, 6>(law),
    ]
}
