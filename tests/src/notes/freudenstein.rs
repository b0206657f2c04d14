//! Section 2: the four-bar linkage by Freudenstein's equations.
//!
//! The links are those of [`four_bar_geometric`](super::four_bar_geometric). The
//! notes stop at acceleration.
//!
//! The half-angle tangents `u` and `v` run to infinity where their angle passes
//! 180 degrees. There `a` or `f` vanishes, and the quadratic formula as printed
//! loses the other assembly's root as well.

use super::{Assembly, cos, sin};

pub use super::four_bar_geometric::Dimensions;

/// The notes' constants K1 to K5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constants {
    /// `r1/r2`
    pub k1: f64,
    /// `r1/r4`
    pub k2: f64,
    /// `(r2^2 - r3^2 + r4^2 + r1^2) / (2 r2 r4)`
    pub k3: f64,
    /// `r1/r3`
    pub k4: f64,
    /// `(r4^2 - r1^2 - r2^2 - r3^2) / (2 r2 r3)`
    pub k5: f64,
}

/// The coupler's and the rocker's angle at one position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position {
    /// The coupler's angle.
    pub theta3: f64,
    /// The rocker's angle.
    pub theta4: f64,
}

/// The coupler's and the rocker's angle: position, velocity, acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Freudenstein {
    /// The coupler's angle.
    pub theta3: [f64; 3],
    /// The rocker's angle.
    pub theta4: [f64; 3],
}

/// K1 to K5.
#[must_use]
pub fn constants(dimensions: Dimensions) -> Constants {
    let Dimensions { r1, r2, r3, r4 } = dimensions;
    let k1 = r1 / r2;
    let k2 = r1 / r4;
    let k3 = (r2.powi(2) - r3.powi(2) + r4.powi(2) + r1.powi(2)) / (2.0 * r2 * r4);
    let k4 = r1 / r3;
    let k5 = (r4.powi(2) - r1.powi(2) - r2.powi(2) - r3.powi(2)) / (2.0 * r2 * r3);
    Constants { k1, k2, k3, k4, k5 }
}

/// The residuals of Freudenstein's two equations, the one in `theta4` and
/// the one in `theta3`: both vanish at a position of the linkage.
#[must_use]
pub fn residuals(dimensions: Dimensions, theta2: f64, position: Position) -> [f64; 2] {
    let Constants { k1, k2, k3, k4, k5 } = constants(dimensions);
    let Position { theta3, theta4 } = position;
    [
        k1 * cos(theta4) - k2 * cos(theta2) + k3 - cos(theta2 - theta4),
        k1 * cos(theta3) + k4 * cos(theta2) + k5 - cos(theta2 - theta3),
    ]
}

/// Position by the half-angle tangents `u = tan(theta4/2)`, `v = tan(theta3/2)`.
///
/// The square root is taken positive in both for the open assembly and negative
/// in both for the crossed one.
#[must_use]
pub fn position(dimensions: Dimensions, theta2: f64, assembly: Assembly) -> Position {
    let Constants { k1, k2, k3, k4, k5 } = constants(dimensions);
    let sign = match assembly {
        Assembly::Open => 1.0,
        Assembly::Crossed => -1.0,
    };

    let a = k1 + (k2 - 1.0) * cos(theta2) - k3;
    let b = 2.0 * sin(theta2);
    let c = -k1 + (k2 + 1.0) * cos(theta2) - k3;
    let u = (-b + sign * (b.powi(2) - 4.0 * a * c).sqrt()) / (2.0 * a);
    let theta4 = 2.0 * u.atan();

    let f = k1 - (k4 + 1.0) * cos(theta2) - k5;
    let g = 2.0 * sin(theta2);
    let h = -k1 - (k4 - 1.0) * cos(theta2) - k5;
    let v = (-g + sign * (g.powi(2) - 4.0 * f * h).sqrt()) / (2.0 * f);
    let theta3 = 2.0 * v.atan();

    Position { theta3, theta4 }
}

/// Velocity and acceleration at a position of either assembly, however found.
///
/// The jerk and snap of `theta2` are not looked at.
#[must_use]
pub fn derivatives(dimensions: Dimensions, theta2: [f64; 5], position: Position) -> Freudenstein {
    let Constants { k1, k2, k4, .. } = constants(dimensions);
    let [theta2, theta2_1, theta2_2, ..] = theta2;
    let Position { theta3, theta4 } = position;

    // Velocity
    let theta3_1 = theta2_1 * (-k4 * sin(theta2) + sin(theta2 - theta3)) / (k1 * sin(theta3) + sin(theta2 - theta3));
    let theta4_1 = theta2_1 * (k2 * sin(theta2) + sin(theta2 - theta4)) / (k1 * sin(theta4) + sin(theta2 - theta4));

    // Acceleration
    let theta3_2 = (-(k4 * sin(theta2) - sin(theta2 - theta3)) * theta2_2
        - k4 * theta2_1.powi(2) * cos(theta2)
        - k1 * theta3_1.powi(2) * cos(theta3)
        + (theta2_1 - theta3_1).powi(2) * cos(theta2 - theta3))
        / (k1 * sin(theta3) + sin(theta2 - theta3));
    let theta4_2 = ((k2 * sin(theta2) + sin(theta2 - theta4)) * theta2_2 + k2 * theta2_1.powi(2) * cos(theta2)
        - k1 * theta4_1.powi(2) * cos(theta4)
        + (theta2_1 - theta4_1).powi(2) * cos(theta2 - theta4))
        / (k1 * sin(theta4) + sin(theta2 - theta4));

    Freudenstein {
        theta3: [theta3, theta3_1, theta3_2],
        theta4: [theta4, theta4_1, theta4_2],
    }
}

/// Position, velocity and acceleration.
#[must_use]
pub fn solve(dimensions: Dimensions, theta2: [f64; 5], assembly: Assembly) -> Freudenstein {
    derivatives(dimensions, theta2, position(dimensions, theta2[0], assembly))
}
