//! Section 4: the slider-crank, by series in `R/L`.
//!
//! The mechanism is that of [`slider_crank`](super::slider_crank), without an
//! offset and with its rod forward. The derivatives hold for constant speed only
//! (`d''` and above are zero), so only `theta` and its rate are taken.

use super::{cos, sin};

pub use super::slider_crank::Dimensions;

/// The constants of the higher-order approximation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constants {
    /// `L - R^2/(4L) - 3 R^4/(64 L^3) - 5 R^6/(256 L^5)`
    pub c0: f64,
    /// `R^2/(4L) + R^4/(16 L^3) + 15 R^6/(512 L^5)`
    pub c2: f64,
    /// `R^4/(64 L^3) + 3 R^6/(256 L^5)`
    pub c4: f64,
    /// `R^6/(512 L^5)`
    pub c6: f64,
}

/// C0, C2, C4, C6.
#[must_use]
pub fn constants(dimensions: Dimensions) -> Constants {
    let Dimensions { r, l } = dimensions;
    let c0 = l - r.powi(2) / (4.0 * l) - 3.0 * r.powi(4) / (64.0 * l.powi(3)) - 5.0 * r.powi(6) / (256.0 * l.powi(5));
    let c2 = r.powi(2) / (4.0 * l) + r.powi(4) / (16.0 * l.powi(3)) + 15.0 * r.powi(6) / (512.0 * l.powi(5));
    let c4 = r.powi(4) / (64.0 * l.powi(3)) + 3.0 * r.powi(6) / (256.0 * l.powi(5));
    let c6 = r.powi(6) / (512.0 * l.powi(5));
    Constants { c0, c2, c4, c6 }
}

/// The slider's place `s`, position through snap, at constant speed:
/// first approximation, `c(phi) ~ 1 - R^2 s(d)^2 / (2 L^2)`.
#[must_use]
pub fn first(dimensions: Dimensions, theta: f64, theta_1: f64) -> [f64; 5] {
    let Dimensions { r, l } = dimensions;
    let (d, d_1) = (theta, theta_1);

    let s = r * cos(d) + l - r.powi(2) / (4.0 * l) * (1.0 - cos(2.0 * d));
    let s_1 = -r * d_1 * (sin(d) + r / (2.0 * l) * sin(2.0 * d));
    let s_2 = -r * d_1.powi(2) * (cos(d) + (r / l) * cos(2.0 * d));
    let s_3 = r * d_1.powi(3) * (sin(d) + (2.0 * r / l) * sin(2.0 * d));
    let s_4 = r * d_1.powi(4) * (cos(d) + (4.0 * r / l) * cos(2.0 * d));

    [s, s_1, s_2, s_3, s_4]
}

/// The slider's place `s`, position through snap, at constant speed:
/// higher-order approximation, through `(R/L)^5`.
#[must_use]
pub fn higher_order(dimensions: Dimensions, theta: f64, theta_1: f64) -> [f64; 5] {
    let Dimensions { r, .. } = dimensions;
    let Constants { c0, c2, c4, c6 } = constants(dimensions);
    let (d, d_1) = (theta, theta_1);

    let s = r * cos(d) + c0 + c2 * cos(2.0 * d) - c4 * cos(4.0 * d) + c6 * cos(6.0 * d);
    let s_1 = -d_1 * (r * sin(d) + 2.0 * c2 * sin(2.0 * d) - 4.0 * c4 * sin(4.0 * d) + 6.0 * c6 * sin(6.0 * d));
    let s_2 =
        -d_1.powi(2) * (r * cos(d) + 4.0 * c2 * cos(2.0 * d) - 16.0 * c4 * cos(4.0 * d) + 36.0 * c6 * cos(6.0 * d));
    let s_3 =
        d_1.powi(3) * (r * sin(d) + 8.0 * c2 * sin(2.0 * d) - 64.0 * c4 * sin(4.0 * d) + 216.0 * c6 * sin(6.0 * d));
    let s_4 =
        d_1.powi(4) * (r * cos(d) + 16.0 * c2 * cos(2.0 * d) - 256.0 * c4 * cos(4.0 * d) + 1296.0 * c6 * cos(6.0 * d));

    [s, s_1, s_2, s_3, s_4]
}
