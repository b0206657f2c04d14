//! Polynomials between two states.

use super::LawError;
use super::error::{finite, positive};
use super::piecewise::Piecewise;
use crate::motion::Motion;
use crate::number::Number;

/// A polynomial between two states: at either end the value and any number of derivatives are given.
///
/// With `K` conditions at both ends together it has the degree `K - 1`. It is kept by its Bernstein coefficients, which
/// follow from the states by differences, so that value and derivatives at the ends are reproduced to rounding. (G.
/// Farin, *Curves and Surfaces for Computer-Aided Geometric Design*, Academic Press, the chapters on Bézier curves.)
///
/// ```
/// use kin_core::Motion;
/// use kin_core::law::{Law, Polynomial};
///
/// // from rest at 0 to the speed 5 at 10 within 2 s; acceleration and jerk are zero at both ends
/// let start = Motion::from([0.0, 0.0, 0.0, 0.0]);
/// let end = Motion::from([10.0, 5.0, 0.0, 0.0]);
/// let law: Polynomial<f64, 8> = Polynomial::between(start, end, 2.0)?;
/// let last = law.at::<4>(2.0);
/// assert_eq!(last.position(), 10.0);
/// assert!((last.velocity() - 5.0).abs() < 1e-14);
/// # Ok::<(), kin_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polynomial<T, const K: usize> {
    coefficients: [T; K],
    duration: T,
}

impl<T: Number, const K: usize> Polynomial<T, K> {
    /// The polynomial of the least degree that leads from one state to another in a time. `K` must be the number of
    /// conditions `A + B`; another number does not compile.
    ///
    /// # Errors
    /// [`LawError::NotFinite`] for the states, [`LawError::NotPositive`] for the duration, and [`LawError::OutOfRange`]
    /// if a coefficient is not finite.
    pub fn between<const A: usize, const B: usize>(
        start: Motion<T, A>,
        end: Motion<T, B>,
        duration: T,
    ) -> Result<Self, LawError> {
        const {
            assert!(
                A + B == K,
                "a polynomial has as many coefficients as conditions at its ends"
            );
        };
        positive("duration of the polynomial", duration)?;
        for derivative in start.as_slice() {
            finite("state at the start of the polynomial", *derivative)?;
        }
        for derivative in end.as_slice() {
            finite("state at the end of the polynomial", *derivative)?;
        }
        let mut coefficients = [T::constant(0.0); K];
        let (first, last) = coefficients.split_at_mut(A);
        fill(first.iter_mut(), start, duration, K);
        // seen from the end, time runs backwards
        fill(last.iter_mut().rev(), end, -duration, K);
        for coefficient in coefficients {
            if !coefficient.is_finite() {
                return Err(LawError::OutOfRange {
                    quantity: "coefficient of the polynomial",
                    value: coefficient.real(),
                });
            }
        }
        Ok(Self { coefficients, duration })
    }
}

/// Writes the Bernstein coefficients from one end, given the state there: the k-th difference of the coefficients is
/// the k-th derivative times `duration`ᵏ (n - k)! / n!, with the degree n.
fn fill<'a, T: Number, const A: usize>(
    coefficients: impl Iterator<Item = &'a mut T>,
    state: Motion<T, A>,
    duration: T,
    count: usize,
) {
    let mut differences = state.derivatives();
    let mut factor = T::constant(1.0);
    for (order, difference) in differences.iter_mut().enumerate() {
        *difference = *difference * factor;
        factor = factor * duration / T::constant(number(count.saturating_sub(order + 1)));
    }
    for coefficient in coefficients {
        *coefficient = differences[0];
        for order in 1..A {
            differences[order - 1] = differences[order - 1] + differences[order];
        }
    }
}

impl<T: Number, const K: usize> Piecewise<T> for Polynomial<T, K> {
    fn end(&self, _: usize) -> T {
        self.duration
    }

    fn write(&self, _: usize, time: T, derivatives: &mut [T]) {
        let part = time / self.duration;
        let rest = (self.duration - time) / self.duration;
        bernstein(self.coefficients, part, rest, derivatives);
        scale(derivatives, T::constant(1.0), self.duration);
    }
}

/// Writes the value and the derivatives of a polynomial with given Bernstein coefficients, by de Casteljau's scheme on
/// the differences of the coefficients. `rest` is `1 - part`, which the caller knows with less rounding.
pub(super) fn bernstein<T: Number, const K: usize>(mut differences: [T; K], part: T, rest: T, derivatives: &mut [T]) {
    let mut factor = 1.0;
    for (order, entry) in derivatives.iter_mut().enumerate() {
        if order >= K {
            *entry = T::constant(0.0);
            continue;
        }
        let mut points = differences;
        for count in (1..K - order).rev() {
            for index in 0..count {
                points[index] = points[index] * rest + points[index + 1] * part;
            }
        }
        *entry = points[0] * T::constant(factor);
        factor *= number(K - 1 - order);
        for index in 1..K - order {
            differences[index - 1] = differences[index] - differences[index - 1];
        }
    }
}

/// Converts derivatives by the part of the duration into derivatives by time, and multiplies them.
pub(super) fn scale<T: Number>(derivatives: &mut [T], factor: T, duration: T) {
    let mut factor = factor;
    for entry in derivatives {
        *entry = *entry * factor;
        factor = factor / duration;
    }
}

#[expect(clippy::cast_precision_loss, reason = "the degrees of polynomials are small")]
const fn number(count: usize) -> f64 {
    count as f64
}
