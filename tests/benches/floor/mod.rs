//! Linkages through snap as one would write them by hand who has a day for it: what generated code is measured by.
//!
//! One sine-cosine, the closed form of the position, the Bell polynomials P and Q of each link's rates shared by both
//! coordinates, one reciprocal of the determinant, one arctangent for each angle: the functions that kin has. No NaN
//! comes out of a position that is out of reach; beyond that nothing is asked and nothing is explained.
//!
//! `BESIDE` are the same kernels after a look at the generated code: a root is inverted beside it and not after it, and
//! two arctangents are found at once.

use kin_core::Number;

/// Of coupler and rocker.
pub(crate) type Pair<T> = [T; 2];

/// The vectors of coupler and rocker, and the rates of their angles from the velocity to the snap.
pub(crate) type Vectors = (Pair<[f64; 2]>, Pair<[f64; 4]>);

/// The linkage: ground, crank, coupler, rocker.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FourBar {
    pub(crate) r1: f64,
    pub(crate) r2: f64,
    pub(crate) r3: f64,
    pub(crate) r4: f64,
}

impl FourBar {
    /// The angles of coupler and rocker in the open assembly, through snap.
    #[inline]
    pub(crate) fn solve<const BESIDE: bool>(&self, theta2: [f64; 5]) -> Option<Pair<[f64; 5]>> {
        let ([[x3, y3], [x4, y4]], [rates3, rates4]) = self.solve_to_vectors::<BESIDE>(theta2)?;
        let [w3, a3, j3, s3] = rates3;
        let [w4, a4, j4, s4] = rates4;
        let [theta3, theta4] = if BESIDE {
            Number::atan2_of_two([y3, y4], [x3, x4])
        } else {
            [Number::atan2(y3, x3), Number::atan2(y4, x4)]
        };
        Some([[theta3, w3, a3, j3, s3], [theta4, w4, a4, j4, s4]])
    }

    /// The vectors of coupler and rocker and the angles' rates: the same without the two arctangents.
    #[inline]
    pub(crate) fn solve_to_vectors<const BESIDE: bool>(&self, theta2: [f64; 5]) -> Option<Vectors> {
        let Self { r1, r2, r3, r4 } = *self;
        let [theta2, w2, a2, j2, s2] = theta2;

        let (sine, cosine) = Number::sin_cos(theta2);
        let (x2, y2) = (r2 * cosine, r2 * sine);
        let (dx, dy) = (r1 - x2, -y2);
        let d2 = dx * dx + dy * dy;
        let (sum, difference) = (r3 + r4, r3 - r4);
        let four_q2 = (sum * sum - d2) * (d2 - difference * difference);
        if four_q2.is_nan() || four_q2 <= 0.0 {
            return None;
        }
        let half = 0.5 / d2;
        let p = (d2 + sum * difference) * half;
        let root = four_q2.sqrt();
        let q = root * half;
        let (x3, y3) = (dx * p - dy * q, dy * p + dx * q);
        let (x4, y4) = (x3 - dx, y3 - dy);
        let inverse = if BESIDE {
            -root * (2.0 / four_q2)
        } else {
            1.0 / (y3 * x4 - x3 * y4)
        };

        // z₂ (P₂ + i Q₂) + z₃ (P₃ + i Q₃) = z₄ (P₄ + i Q₄), where only Q₃ and Q₄ hold the rates that are sought:
        // multiplied by z₄ and by z₃
        let (x, y) = (x2 * inverse, y2 * inverse);
        let (along3, across3) = (x3 * x + y3 * y, x3 * y - y3 * x);
        let (along4, across4) = (x4 * x + y4 * y, x4 * y - y4 * x);
        let between = (x3 * x4 + y3 * y4) * inverse;
        let (own3, own4) = (r3 * r3 * inverse, r4 * r4 * inverse);

        let w3 = -across4 * w2;
        let w4 = -across3 * w2;

        let (w2_2, w3_2, w4_2) = (w2 * w2, w3 * w3, w4 * w4);
        let a3 = own4 * w4_2 - between * w3_2 - along4 * w2_2 - across4 * a2;
        let a4 = between * w4_2 - own3 * w3_2 - along3 * w2_2 - across3 * a2;

        let (p2, p3, p4) = (w2 * a2, w3 * a3, w4 * a4);
        let q2 = j2 - w2 * w2_2;
        let j3 = 3.0 * (own4 * p4 - between * p3 - along4 * p2) - across4 * q2 + w3 * w3_2;
        let j4 = 3.0 * (between * p4 - own3 * p3 - along3 * p2) - across3 * q2 + w4 * w4_2;

        let (p2, q2) = bell(w2, w2_2, a2, j2);
        let (p3, q3) = bell(w3, w3_2, a3, j3);
        let (p4, q4) = bell(w4, w4_2, a4, j4);
        let q2 = s2 - q2;
        let s3 = along4 * p2 + between * p3 - own4 * p4 - across4 * q2 + q3;
        let s4 = along3 * p2 + own3 * p3 - between * p4 - across3 * q2 + q4;

        Some(([[x3, y3], [x4, y4]], [[w3, a3, j3, s3], [w4, a4, j4, s4]]))
    }
}

/// P₄ and Q₄ without the snap, from the rates and the square of the first.
#[inline]
fn bell(w: f64, w_2: f64, a: f64, j: f64) -> (f64, f64) {
    (w_2 * w_2 - 4.0 * w * j - 3.0 * a * a, 6.0 * w_2 * a)
}

/// The centric slider-crank: crank, connecting rod.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SliderCrank {
    pub(crate) r: f64,
    pub(crate) l: f64,
}

impl SliderCrank {
    /// The rod's angle and the slider's place, the slider beyond the pin, through snap.
    #[inline]
    pub(crate) fn solve<const BESIDE: bool>(&self, theta: [f64; 5]) -> Option<Pair<[f64; 5]>> {
        let [theta, w, a, j, s] = theta;
        let (sine, cosine) = Number::sin_cos(theta);
        let (x, y) = (self.r * cosine, self.r * sine);
        // the rod's vector is (u, -y), with phi clockwise
        let u2 = (self.l - y) * (self.l + y);
        if u2.is_nan() || u2 <= 0.0 {
            return None;
        }
        let u = u2.sqrt();
        let inverse = if BESIDE { u * (1.0 / u2) } else { 1.0 / u };
        let phi = Number::atan2(y, u);

        // x Q - y (-P) = u Qφ + y Pφ across the line; along it lies what remains
        let w_2 = w * w;
        let phi_1 = x * w * inverse;
        let phi_1_2 = phi_1 * phi_1;
        let phi_2 = (x * a - y * (w_2 - phi_1_2)) * inverse;
        let (p, q) = (3.0 * w * a, j - w * w_2);
        let (p_phi, q_phi) = (3.0 * phi_1 * phi_2, phi_1 * phi_1_2);
        let phi_3 = (x * q - y * (p - p_phi)) * inverse + q_phi;
        let (p4, q4) = bell(w, w_2, a, j);
        let (p4_phi, q4_phi) = bell(phi_1, phi_1_2, phi_2, phi_3);
        let q4 = s - q4;
        let phi_4 = (x * q4 + y * (p4 - p4_phi)) * inverse + q4_phi;
        Some([
            [phi, phi_1, phi_2, phi_3, phi_4],
            [
                x + u,
                -y * (w + phi_1),
                -y * (a + phi_2) - x * w_2 - u * phi_1_2,
                -y * (q + phi_3 - q_phi) - x * p - u * p_phi,
                -y * (q4 + phi_4 - q4_phi) + x * p4 + u * p4_phi,
            ],
        ])
    }
}

/// The inverted slider-crank: ground, crank.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InvertedSliderCrank {
    pub(crate) r1: f64,
    pub(crate) r2: f64,
}

impl InvertedSliderCrank {
    /// The length along the lever and the lever's angle, through snap.
    #[inline]
    pub(crate) fn solve<const BESIDE: bool>(&self, theta2: [f64; 5]) -> Option<Pair<[f64; 5]>> {
        let [theta2, w, a, j, s] = theta2;
        let (sine, cosine) = Number::sin_cos(theta2);
        let (x2, y2) = (self.r2 * cosine, self.r2 * sine);
        let x = self.r1 + x2;
        let r_2 = x * x + y2 * y2;
        if r_2.is_nan() || r_2 <= 0.0 {
            return None;
        }
        let r = r_2.sqrt();
        let inverse = if BESIDE { r * (1.0 / r_2) } else { 1.0 / r };
        let theta4 = Number::atan2(y2, x);
        // the crank as seen from the lever
        let (c, d) = (x * inverse, y2 * inverse);
        let (along, across) = (c * x2 + d * y2, c * y2 - d * x2);

        // in the lever's directions z₂⁽ⁿ⁾ = (along + i across) (P + i Q), and z₄⁽ⁿ⁾ by Leibniz's rule
        let w_2 = w * w;
        let r_1 = -across * w;
        let v = along * w * inverse;
        let v_2 = v * v;
        let r_2 = r * v_2 - along * w_2 - across * a;
        let b = (along * a - across * w_2 - 2.0 * r_1 * v) * inverse;
        let (p, q) = (3.0 * w * a, j - w * w_2);
        let (vb, v_3) = (3.0 * v * b, v * v_2);
        let r_3 = r * vb + 3.0 * r_1 * v_2 - along * p - across * q;
        let k = (along * q - across * p - 3.0 * (r_2 * v + r_1 * b)) * inverse + v_3;
        let (p4, q4) = bell(w, w_2, a, j);
        let (p4_v, q4_v) = bell(v, v_2, b, k);
        let q4 = s - q4;
        let r_4 = along * p4 - across * q4 - r * p4_v + 4.0 * r_1 * vb + 6.0 * r_2 * v_2;
        let m = (along * q4 + across * p4 - 4.0 * (r_3 * v + r_1 * (k - v_3)) - 6.0 * r_2 * b) * inverse + q4_v;
        Some([[r, r_1, r_2, r_3, r_4], [theta4, v, b, k, m]])
    }
}
