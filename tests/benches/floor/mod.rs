//! The four-bar linkage through snap as one would write it by hand who has a day for it: what generated code is measured by.
//!
//! One sine-cosine, the intersection of two circles, the Bell polynomials P and Q of each link's rates shared by both
//! coordinates, one reciprocal of the determinant, one arctangent for each angle. No NaN comes out of a position that is out of
//! reach; beyond that nothing is asked and nothing is explained.

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
    pub(crate) fn solve(&self, theta2: [f64; 5]) -> Option<Pair<[f64; 5]>> {
        let ([[x3, y3], [x4, y4]], [rates3, rates4]) = self.solve_to_vectors(theta2)?;
        let [w3, a3, j3, s3] = rates3;
        let [w4, a4, j4, s4] = rates4;
        let theta3 = y3.atan2(x3);
        let theta4 = y4.atan2(x4);
        Some([[theta3, w3, a3, j3, s3], [theta4, w4, a4, j4, s4]])
    }

    /// The vectors of coupler and rocker and the angles' rates: the same without the two arctangents.
    #[inline]
    pub(crate) fn solve_to_vectors(&self, theta2: [f64; 5]) -> Option<Vectors> {
        let Self { r1, r2, r3, r4 } = *self;
        let [theta2, w2, a2, j2, s2] = theta2;

        let (sine, cosine) = theta2.sin_cos();
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
        let q = four_q2.sqrt() * half;
        let (x3, y3) = (dx * p - dy * q, dy * p + dx * q);
        let (x4, y4) = (x3 - dx, y3 - dy);
        let inverse = 1.0 / (y3 * x4 - x3 * y4);

        // z₂ (P₂ + i Q₂) + z₃ (P₃ + i Q₃) = z₄ (P₄ + i Q₄), where only Q₃ and Q₄ hold the rates that are sought
        let w3 = inverse * (y2 * -w2 * x4 + x2 * w2 * y4);
        let w4 = inverse * (y2 * -w2 * x3 + x2 * w2 * y3);

        let (w2_2, w3_2, w4_2) = (w2 * w2, w3 * w3, w4 * w4);
        let kx = x4 * w4_2 - x3 * w3_2 - x2 * w2_2 - y2 * a2;
        let ky = y4 * w4_2 - y3 * w3_2 - y2 * w2_2 + x2 * a2;
        let a3 = inverse * (kx * x4 + ky * y4);
        let a4 = inverse * (kx * x3 + ky * y3);

        let (p2, p3, p4) = (w2 * a2, w3 * a3, w4 * a4);
        let (q2, q3, q4) = (j2 - w2 * w2_2, w3 * w3_2, w4 * w4_2);
        let kx = 3.0 * (x4 * p4 - x3 * p3 - x2 * p2) - y2 * q2 + y3 * q3 - y4 * q4;
        let ky = 3.0 * (y4 * p4 - y3 * p3 - y2 * p2) + x2 * q2 - x3 * q3 + x4 * q4;
        let j3 = inverse * (kx * x4 + ky * y4);
        let j4 = inverse * (kx * x3 + ky * y3);

        let bell = |w: f64, w_2: f64, a: f64, j: f64| (w_2 * w_2 - 4.0 * w * j - 3.0 * a * a, 6.0 * w_2 * a);
        let (p2, q2) = bell(w2, w2_2, a2, j2);
        let (p3, q3) = bell(w3, w3_2, a3, j3);
        let (p4, q4) = bell(w4, w4_2, a4, j4);
        let q2 = s2 - q2;
        let kx = x2 * p2 + x3 * p3 - x4 * p4 - y2 * q2 + y3 * q3 - y4 * q4;
        let ky = y2 * p2 + y3 * p3 - y4 * p4 + x2 * q2 - x3 * q3 + x4 * q4;
        let s3 = inverse * (kx * x4 + ky * y4);
        let s4 = inverse * (kx * x3 + ky * y3);

        Some(([[x3, y3], [x4, y4]], [[w3, a3, j3, s3], [w4, a4, j4, s4]]))
    }
}
