//! The position of a slider-crank's slider as a series in the crank's angle, to any even order of R/L.

use crate::{Motion, Scalar};

/// The number of terms of the tail that are summed before a geometric series bounds the rest.
const TAIL: u32 = 20_000;

/// The slider of a centric slider-crank as an explicit series, truncated after the power 2 `terms` of R/L.
///
/// With λ = R/L the exact position of the slider is s = R cos θ + L √(1 - λ² sin² θ), in the open assembly. The root is
/// the binomial series Σ cₖ (λ sin θ)²ᵏ with c₀ = 1 and cₖ₊₁ = cₖ (2k - 1) / (2k + 2). Here it ends with k = `terms`.
/// One term is the [first approximation](super::SliderCrankFirstApproximation), three terms are the [higher
/// one](super::SliderCrankHigherApproximation).
///
/// # Truncation error
/// The proof of [`remainder_bound`](Self::remainder_bound) is as follows. The remainder is L Σ cₖ (λ sin θ)²ᵏ over k >
/// `terms`. The function sin²ᵏ θ - ½ is a trigonometric polynomial of degree 2k with magnitudes of at most ½, so its
/// m-th derivative with respect to θ is at most (2k)ᵐ / 2 (S. Bernstein's inequality). The m-th derivative of the
/// remainder is therefore at most Mₘ = L/2 Σ |cₖ| λ²ᵏ (2k)ᵐ, and M₀ = L Σ |cₖ| λ²ᵏ. From one term to the next the sums
/// grow at most by the factor λ² (1 + 1/k)ᵐ⁻¹ (1 - 1/2k). It falls below 1 if λ < 1, so the rest is less than a
/// geometric series. For any motion of the crank the time derivatives follow from Faà di Bruno's formula with absolute
/// values.
///
/// ```
/// use kin_core::library::{SliderCrank, SliderCrankSeries};
/// use kin_core::prelude::*;
///
/// let crank = Motion::from((1.0_f64, 100.0, 0.0, 0.0, 0.0));
/// let series = SliderCrankSeries { r: 1.0, l: 3.5, terms: 8 };
/// let exact = SliderCrank { r: 1.0, l: 3.5 }.solve(crank, Assembly::Open)?;
/// let (approximate, bound) = (series.motion(crank), series.remainder_bound(crank));
/// assert!((approximate.snap() - exact.s.snap()).abs() <= bound[4]);
/// assert!(bound[4] < 1e-3 * exact.s.snap().abs());
/// # Ok::<(), SolveError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliderCrankSeries<T = f64> {
    /// Crank, R.
    pub r: T,
    /// Connecting rod, L.
    pub l: T,
    /// The highest power of (λ sin θ)² in the series.
    pub terms: u32,
}

/// The ratio cₖ₊₁ / cₖ of the binomial series of √(1 - x).
fn ratio(k: u32) -> f64 {
    let k = f64::from(k);
    (2.0 * k - 1.0) / (2.0 * k + 2.0)
}

impl<T: Scalar> SliderCrankSeries<T> {
    /// The slider's motion, in the unit of `r` and `l`, for a motion of the crank's angle in radians.
    #[must_use]
    pub fn motion(&self, theta: Motion<T, 5>) -> Motion<T, 5> {
        let lambda = self.r / self.l;
        let (sine, cosine) = theta.sin_cos();
        let square = (sine * sine).scale(lambda * lambda);
        // Horner's scheme in the ratios: 1 + x c₁/c₀ (1 + x c₂/c₁ (1 + …))
        let one = Motion::constant(T::constant(1.0));
        let root = (0..self.terms)
            .rev()
            .fold(one, |inner, k| one + (square * inner).scale(T::constant(ratio(k))));
        cosine.scale(self.r) + root.scale(self.l)
    }

    /// A bound on the truncation errors of position, velocity, acceleration, jerk and snap, for a motion of the crank.
    ///
    /// The bound is tight for the position and generous for the derivatives, by a factor that grows like (2 `terms` +
    /// 2)^(order / 2).
    ///
    /// The bound is infinite if R is not less than L, where the series need not converge. It applies to exact
    /// arithmetic and does not include rounding errors.
    #[must_use]
    pub fn remainder_bound(&self, theta: Motion<T, 5>) -> [f64; 5] {
        let [m0, m1, m2, m3, m4] = [0, 1, 2, 3, 4].map(|order| self.angular_bound(order));
        let [_, a1, a2, a3, a4] = theta.derivatives().map(|rate| rate.real().abs());
        [
            m0,
            m1 * a1,
            m1 * a2 + m2 * a1 * a1,
            m1 * a3 + 3.0 * m2 * a1 * a2 + m3 * a1 * a1 * a1,
            m1 * a4 + m2 * (4.0 * a1 * a3 + 3.0 * a2 * a2) + 6.0 * m3 * a1 * a1 * a2 + m4 * a1 * a1 * a1 * a1,
        ]
        // An infinite bound times a rate of zero is NaN.
        .map(|bound| if bound.is_nan() { f64::INFINITY } else { bound })
    }

    /// The bound Mₘ on the truncation error of the derivative of order `order` with respect to the angle.
    fn angular_bound(&self, order: u32) -> f64 {
        let lambda = (self.r.real() / self.l.real()).abs();
        let square = lambda * lambda;
        if square.is_nan() || square >= 1.0 {
            return f64::INFINITY;
        }
        let amplitude = (0..=self.terms).fold(1.0, |term, k| term * ratio(k).abs() * square);
        let power = |k: f64| (0..order).fold(1.0, |product, _| product * 2.0 * k);
        let scale = self.l.real().abs() * if order == 0 { 1.0 } else { 0.5 };
        let first = self.terms.saturating_add(1);
        let (mut sum, mut term) = (0.0, amplitude);
        for k in (first..).take(TAIL as usize) {
            let value = term * power(f64::from(k));
            let growth = (1..order).fold(square, |product, _| product * (1.0 + 1.0 / f64::from(k)));
            // Sum enough terms of the tail to make the geometric bound on the others tight.
            if growth < 1.0 && value / (1.0 - growth) <= 0.01 * sum {
                return scale * (sum + value / (1.0 - growth));
            }
            sum += value;
            term *= ratio(k) * square;
        }
        f64::INFINITY
    }
}

#[cfg(test)]
mod tests {
    use std::println;

    use super::*;
    use crate::Assembly;
    use crate::library::{SliderCrank, SliderCrankFirstApproximation, SliderCrankHigherApproximation};

    /// The truncation error stays below the bound at every order, and the bound exceeds it only by a small factor.
    #[test]
    fn the_bound_holds_and_is_tight() {
        for lambda in [0.05, 0.2, 0.5, 0.7, 0.9] {
            for terms in [1, 2, 3, 5, 8, 13, 20] {
                let (mut worst, mut bound, mut size) = ([0.0_f64; 5], [0.0_f64; 5], [0.0_f64; 5]);
                for step in 0..720 {
                    let theta = Motion::from((f64::from(step).to_radians() / 2.0, 2.0, 0.0, 0.0, 0.0));
                    let series = SliderCrankSeries {
                        r: lambda,
                        l: 1.0,
                        terms,
                    };
                    let exact = SliderCrank { r: lambda, l: 1.0 }
                        .solve(theta, Assembly::Open)
                        .unwrap()
                        .s
                        .derivatives();
                    let approximate = series.motion(theta).derivatives();
                    bound = series.remainder_bound(theta);
                    for order in 0..5 {
                        worst[order] = worst[order].max((approximate[order] - exact[order]).abs());
                        size[order] = size[order].max(exact[order].abs());
                    }
                }
                for order in 0..5 {
                    // 1/(1 - λ²) is the condition of the exact root, and it enters once more for each order.
                    let rounding = 1e-14 * size[order].max(1.0) / (1.0 - lambda * lambda).powi(5);
                    assert!(
                        worst[order] <= bound[order] + rounding,
                        "λ {lambda}, {terms} terms, order {order}"
                    );
                    if worst[order] > 100.0 * rounding {
                        let slack = bound[order] / worst[order];
                        println!("λ {lambda}, {terms} terms, order {order}: bound {slack:.2} times the error");
                        // The derivatives of sin²ᵏ grow like (2k)^(m/2), but Bernstein's bound grows like (2k)^m. The
                        // largest term of the tail is at most m / (1 - λ²) terms away.
                        let order = i32::try_from(order).unwrap();
                        let largest = f64::from(terms + 1) + f64::from(order) / (1.0 - lambda * lambda);
                        let order_size = (2.0 * largest).sqrt().powi(order);
                        assert!(
                            slack < 2.0 * order_size,
                            "λ {lambda}, {terms} terms, order {order}: {slack}"
                        );
                    }
                }
            }
        }
    }

    /// One term is the first approximation, and three terms are the higher one up to its order.
    #[test]
    fn few_terms_are_the_declared_approximations() {
        let theta = Motion::from((0.8, 3.0, -1.0, 0.5, 2.0));
        let (r, l) = (1.0_f64, 4.0);
        let first = SliderCrankFirstApproximation { r, l }.solve(theta).unwrap().s;
        let higher = SliderCrankHigherApproximation { r, l }.solve(theta).unwrap().s;
        for (terms, declared) in [(1, first), (3, higher)] {
            let series = SliderCrankSeries { r, l, terms }.motion(theta);
            for (value, other) in series.derivatives().into_iter().zip(declared.derivatives()) {
                assert!(
                    (value - other).abs() <= 1e-13 * (1.0 + other.abs()) * 81.0,
                    "{terms}: {value} {other}"
                );
            }
        }
    }

    #[test]
    fn a_crank_as_long_as_the_rod_has_no_bound() {
        let theta = Motion::from((0.8, 0.0, 0.0, 0.0, 0.0));
        let bound = SliderCrankSeries {
            r: 1.0,
            l: 1.0,
            terms: 3,
        }
        .remainder_bound(theta);
        assert!(bound.iter().all(|bound| *bound == f64::INFINITY));
    }
}
