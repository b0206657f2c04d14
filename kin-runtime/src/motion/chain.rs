//! The chain rule.

use super::{Motion, leibniz};
use crate::number::Number;

impl<T: Number, const N: usize> Motion<T, N> {
    /// The motion in time of a quantity whose derivatives with respect to a driving quantity are given, from the motion
    /// of the latter.
    ///
    /// If `self` holds f(θ), f'(θ), f''(θ), … and `drive` holds θ and its derivatives by time, the result holds f and
    /// its derivatives by time. The n-th derivative by θ is again such a quantity, and its rate is the next derivative
    /// times the rate of θ: Leibniz's rule differentiates this product.
    ///
    /// ```
    /// use kin_core::Motion;
    ///
    /// // θ³ at θ = 2, which moves at the speed 3
    /// let cube = Motion::from([8.0, 12.0, 12.0, 6.0]);
    /// let angle = Motion::from([2.0, 3.0, 0.0, 0.0]);
    /// assert_eq!(cube.driven_by(angle).derivatives(), [8.0, 36.0, 108.0, 162.0]);
    /// ```
    #[must_use]
    pub fn driven_by(self, drive: Self) -> Self {
        let rates = drive.derivatives.get(1..).unwrap_or(&[]);
        // from the highest derivative by θ down, each in its motion as far as it is needed
        let mut above = [T::constant(0.0); N];
        for (order, derivative) in self.derivatives.into_iter().enumerate().rev() {
            let mut series = [derivative; N];
            for rate in 1..N - order {
                series[rate] = leibniz(&above[..rate], &rates[..rate]);
            }
            above = series;
        }
        Self::new(above)
    }
}
