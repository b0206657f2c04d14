//! The notes' geometric method for the four-bar linkage, written with care.
//!
//! The equations are the notes', the diagonal's length, and the sines of the angles beside it, and they are
//! differentiated as there. But each function is evaluated once, sine and cosine of an angle that is found by one of
//! them are not evaluated again, powers are products that are shared, and what is divided by repeatedly is inverted
//! once. The functions are the library's.

use kin_tests::notes::Assembly;
use kin_tests::notes::four_bar_geometric::{Branch, Dimensions};

/// The rates of an angle, and the products of them that the formulas share.
struct Angle {
    sine: f64,
    cosine: f64,
    rates: [f64; 4],
}

impl Angle {
    /// The parts of the derivatives of the sine of an order, as factors of the cosine and of the sine, without the
    /// highest rate.
    #[inline]
    fn parts(&self, order: usize) -> (f64, f64) {
        let [w, a, j, _] = self.rates;
        match order {
            1 => (0.0, 0.0),
            2 => (0.0, -(w * w)),
            3 => (-(w * w * w), -3.0 * w * a),
            _ => {
                let square = w * w;
                (-6.0 * square * a, square * square - 4.0 * w * j - 3.0 * a * a)
            }
        }
    }

    /// The derivative of the sine, without the highest rate.
    #[inline]
    fn sine_without(&self, order: usize) -> f64 {
        let (cosine, sine) = self.parts(order);
        cosine * self.cosine + sine * self.sine
    }

    /// The derivative of the cosine, without the highest rate.
    #[inline]
    fn cosine_without(&self, order: usize) -> f64 {
        let (cosine, sine) = self.parts(order);
        sine * self.cosine - cosine * self.sine
    }

    /// The derivative of the sine.
    #[inline]
    fn sine_rate(&self, order: usize) -> f64 {
        self.sine_without(order) + self.rates[order - 1] * self.cosine
    }

    /// The derivative of the cosine.
    #[inline]
    fn cosine_rate(&self, order: usize) -> f64 {
        self.cosine_without(order) - self.rates[order - 1] * self.sine
    }
}

/// Binomial coefficients by which a product is differentiated.
const BINOMIAL: [[f64; 5]; 5] = [
    [1.0, 0.0, 0.0, 0.0, 0.0],
    [1.0, 1.0, 0.0, 0.0, 0.0],
    [1.0, 2.0, 1.0, 0.0, 0.0],
    [1.0, 3.0, 3.0, 1.0, 0.0],
    [1.0, 4.0, 6.0, 4.0, 1.0],
];

/// The angles of coupler and rocker through snap.
#[inline]
pub(crate) fn solve(dimensions: Dimensions, theta2: [f64; 5], branch: Branch) -> [[f64; 5]; 2] {
    use core::f64::consts::PI;
    let Dimensions { r1, r2, r3, r4 } = dimensions;
    let (sine, cosine) = theta2[0].sin_cos();
    let crank = Angle {
        sine,
        cosine,
        rates: [theta2[1], theta2[2], theta2[3], theta2[4]],
    };

    let e = (r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * cosine).sqrt();
    let by_e = 1.0 / e;
    let s_alpha = r2 * sine * by_e;
    let obtuse = |is_obtuse: bool, sine: f64| {
        if is_obtuse {
            PI.copysign(sine) - sine.asin()
        } else {
            sine.asin()
        }
    };
    let c_gamma = (r3 * r3 + r4 * r4 - e * e) / (2.0 * r3 * r4);
    let sign = if branch.assembly == Assembly::Open { 1.0 } else { -1.0 };
    let mut gamma = Angle {
        sine: sign * (1.0 - c_gamma * c_gamma).sqrt(),
        cosine: c_gamma,
        rates: [0.0; 4],
    };
    let s_beta = r3 * gamma.sine * by_e;
    let mut alpha = Angle {
        sine: s_alpha,
        cosine: (r1 - r2 * cosine) * by_e,
        rates: [0.0; 4],
    };
    let mut beta = Angle {
        sine: s_beta,
        cosine: (r4 - r3 * c_gamma) * by_e,
        rates: [0.0; 4],
    };
    let mut theta4 = [PI - obtuse(branch.alpha_obtuse, s_alpha) - obtuse(branch.beta_obtuse, s_beta); 5];
    let mut theta3 = [theta4[0] - sign * c_gamma.acos(); 5];

    // e² = r1² + r2² - 2 r1 r2 cos θ2 = r3² + r4² - 2 r3 r4 cos γ; e sin α = r2 sin θ2; e sin β = r3 sin γ
    let (r1_r2, r3_r4) = (r1 * r2, r3 * r4);
    let by_gamma = 1.0 / (r3_r4 * gamma.sine);
    let by_alpha = by_e / alpha.cosine;
    let by_beta = by_e / beta.cosine;
    let mut lengths = [e, 0.0, 0.0, 0.0, 0.0];
    let (mut s_alphas, mut s_betas) = ([alpha.sine, 0.0, 0.0, 0.0, 0.0], [beta.sine, 0.0, 0.0, 0.0, 0.0]);
    for order in 1..5 {
        // half of the derivative of e²
        let half = -r1_r2 * crank.cosine_rate(order);
        let mut products = 0.0;
        for k in 1..order {
            products += 0.5 * BINOMIAL[order][k] * lengths[k] * lengths[order - k];
        }
        lengths[order] = (half - products) * by_e;
        gamma.rates[order - 1] = (half + r3_r4 * gamma.cosine_without(order)) * by_gamma;
        let (mut of_alpha, mut of_beta) = (r2 * crank.sine_rate(order), r3 * gamma.sine_rate(order));
        for k in 1..=order {
            of_alpha -= BINOMIAL[order][k] * lengths[k] * s_alphas[order - k];
            of_beta -= BINOMIAL[order][k] * lengths[k] * s_betas[order - k];
        }
        alpha.rates[order - 1] = (of_alpha - e * alpha.sine_without(order)) * by_alpha;
        beta.rates[order - 1] = (of_beta - e * beta.sine_without(order)) * by_beta;
        s_alphas[order] = of_alpha * by_e;
        s_betas[order] = of_beta * by_e;
        theta4[order] = -alpha.rates[order - 1] - beta.rates[order - 1];
        theta3[order] = theta4[order] - gamma.rates[order - 1];
    }
    [theta3, theta4]
}
