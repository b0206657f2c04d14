//! Section 3: the slider-crank, exactly.
//!
//! Crank `R` at `theta` (input), connecting rod `L` at `phi`, slider at `s` on the
//! line through the crank pivot; `d` = `theta`. `phi` is the rod's angle to
//! the slider's line, clockwise positive: the pin is `L s(phi)` above the line.
//!
//! The notes have no offset and only the rod that points from the pin towards
//! positive `s`. [`position_offset`] and [`Rod::Backward`] add what is needed for
//! the rest; the derivatives are the same, for an offset is constant and the
//! derivatives do not ask which value of `phi` was taken.
//!
//! The derivatives divide by `L c(phi)`, which vanishes at the singularity only.

use std::f64::consts::PI;

use super::{cos, sin};

/// The lengths of the links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dimensions {
    /// Crank, the notes' `R`.
    pub r: f64,
    /// Connecting rod, the notes' `L`.
    pub l: f64,
}

/// On which side of the crank pin the slider is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rod {
    /// Towards positive `s`, as in the notes: `c(phi) > 0`.
    Forward,
    /// Towards negative `s`: `c(phi) < 0`.
    Backward,
}

/// The notes' quantities at one position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position {
    /// The rod's angle.
    pub phi: f64,
    /// The slider's place.
    pub s: f64,
}

/// The notes' quantities, position through snap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliderCrank {
    /// The rod's angle.
    pub phi: [f64; 5],
    /// The slider's place.
    pub s: [f64; 5],
}

/// Position, with the slider's line through the crank pivot. NaN out of reach.
#[must_use]
pub fn position(dimensions: Dimensions, theta: f64, rod: Rod) -> Position {
    let Dimensions { r, l } = dimensions;

    let s_phi = r * sin(theta) / l;
    let phi = match rod {
        Rod::Forward => s_phi.asin(),
        Rod::Backward => PI - s_phi.asin(),
    };

    let s = r * cos(theta) + l * cos(phi);

    Position { phi, s }
}

/// Position, with the slider's line at the height `h` above the crank pivot:
/// `R s(theta) = h + L s(phi)`. NaN out of reach.
#[must_use]
pub fn position_offset(dimensions: Dimensions, h: f64, theta: f64, rod: Rod) -> Position {
    let Dimensions { r, l } = dimensions;

    let s_phi = (r * sin(theta) - h) / l;
    let phi = match rod {
        Rod::Forward => s_phi.asin(),
        Rod::Backward => PI - s_phi.asin(),
    };

    let s = r * cos(theta) + l * cos(phi);

    Position { phi, s }
}

/// Velocity, acceleration, jerk and snap at any position, offset or not.
#[must_use]
pub fn derivatives(dimensions: Dimensions, theta: [f64; 5], position: Position) -> SliderCrank {
    let Dimensions { r, l } = dimensions;
    let [d, d_1, d_2, d_3, d_4] = theta;
    let Position { phi, s } = position;

    // Velocity
    let phi_1 = (r * d_1 * cos(d)) / (l * cos(phi));
    let s_1 = -r * d_1 * sin(d) - l * phi_1 * sin(phi);

    // Acceleration
    let phi_2 = (r * d_2 * cos(d) - r * d_1.powi(2) * sin(d) + l * phi_1.powi(2) * sin(phi)) / (l * cos(phi));
    let s_2 = -r * d_2 * sin(d) - r * d_1.powi(2) * cos(d) - l * phi_2 * sin(phi) - l * phi_1.powi(2) * cos(phi);

    // Jerk
    let phi_3 = (r * d_3 * cos(d) - 3.0 * r * d_1 * d_2 * sin(d) - r * d_1.powi(3) * cos(d)
        + 3.0 * l * phi_1 * phi_2 * sin(phi)
        + l * phi_1.powi(3) * cos(phi))
        / (l * cos(phi));
    let s_3 = -r * d_3 * sin(d) - 3.0 * r * d_1 * d_2 * cos(d) + r * d_1.powi(3) * sin(d)
        - l * phi_3 * sin(phi)
        - 3.0 * l * phi_1 * phi_2 * cos(phi)
        + l * phi_1.powi(3) * sin(phi);

    // Snap
    let phi_4 = (r * d_4 * cos(d)
        - 4.0 * r * d_1 * d_3 * sin(d)
        - 3.0 * r * d_2.powi(2) * sin(d)
        - 6.0 * r * d_1.powi(2) * d_2 * cos(d)
        + r * d_1.powi(4) * sin(d)
        + 4.0 * l * phi_1 * phi_3 * sin(phi)
        + 3.0 * l * phi_2.powi(2) * sin(phi)
        + 6.0 * l * phi_1.powi(2) * phi_2 * cos(phi)
        - l * phi_1.powi(4) * sin(phi))
        / (l * cos(phi));
    let s_4 = -r * d_4 * sin(d) - 4.0 * r * d_1 * d_3 * cos(d) - 3.0 * r * d_2.powi(2) * cos(d)
        + 6.0 * r * d_1.powi(2) * d_2 * sin(d)
        + r * d_1.powi(4) * cos(d)
        - l * phi_4 * sin(phi)
        - 4.0 * l * phi_1 * phi_3 * cos(phi)
        - 3.0 * l * phi_2.powi(2) * cos(phi)
        + 6.0 * l * phi_1.powi(2) * phi_2 * sin(phi)
        + l * phi_1.powi(4) * cos(phi);

    SliderCrank {
        phi: [phi, phi_1, phi_2, phi_3, phi_4],
        s: [s, s_1, s_2, s_3, s_4],
    }
}

/// Position through snap, with the slider's line through the crank pivot.
#[must_use]
pub fn solve(dimensions: Dimensions, theta: [f64; 5], rod: Rod) -> SliderCrank {
    derivatives(dimensions, theta, position(dimensions, theta[0], rod))
}

/// Position through snap, with the slider's line at the height `h` above the
/// crank pivot.
#[must_use]
pub fn solve_offset(dimensions: Dimensions, h: f64, theta: [f64; 5], rod: Rod) -> SliderCrank {
    derivatives(dimensions, theta, position_offset(dimensions, h, theta[0], rod))
}
