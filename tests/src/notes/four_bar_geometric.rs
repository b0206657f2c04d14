//! Section 1: the four-bar linkage by the geometric method.
//!
//! Ground `r1` = AD along `theta1` = 0, crank `r2` = AB at `theta2` (input),
//! coupler `r3` = BC at `theta3`, rocker `r4` = DC at `theta4`; `e` = BD is the
//! diagonal, `alpha` the angle at D between AD and DB, `beta` the angle at D
//! between DB and DC, `gamma` the angle at C.
//!
//! The derivatives divide by `e c(alpha)`, `e c(beta)` and `s(gamma)`: they
//! cannot be evaluated where `alpha` or `beta` is a right angle, although the
//! linkage itself is regular there. The last, `gamma` = 0 or 180 degrees, is the
//! true singularity.

use std::f64::consts::PI;

use super::{Assembly, cos, sin};

/// The lengths of the links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dimensions {
    /// Ground, AD.
    pub r1: f64,
    /// Crank, AB.
    pub r2: f64,
    /// Coupler, BC.
    pub r3: f64,
    /// Rocker, DC.
    pub r4: f64,
}

/// Which of their values the inverse sines and the inverse cosine take.
///
/// The notes' drawing is open, with `alpha` and `beta` acute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Branch {
    /// The sign of `gamma`.
    pub assembly: Assembly,
    /// `alpha` is more than a right angle, either way.
    pub alpha_obtuse: bool,
    /// `beta` is more than a right angle, either way.
    pub beta_obtuse: bool,
}

impl Branch {
    /// The branch on which the linkage closes: `alpha` is obtuse when
    /// `r1 < r2 c(theta2)`, `beta` when `r4^2 + e^2 < r3^2`.
    #[must_use]
    pub fn closing(dimensions: Dimensions, theta2: f64, assembly: Assembly) -> Self {
        let Dimensions { r1, r2, r3, r4 } = dimensions;
        let e_squared = r1.powi(2) + r2.powi(2) - 2.0 * r1 * r2 * cos(theta2);
        Self {
            assembly,
            alpha_obtuse: r1 < r2 * cos(theta2),
            beta_obtuse: r4.powi(2) + e_squared < r3.powi(2),
        }
    }
}

/// The notes' quantities at one position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position {
    /// The diagonal, BD.
    pub e: f64,
    /// The angle at D between AD and DB.
    pub alpha: f64,
    /// The angle at C.
    pub gamma: f64,
    /// The angle at D between DB and DC.
    pub beta: f64,
    /// The rocker's angle.
    pub theta4: f64,
    /// The coupler's angle.
    pub theta3: f64,
}

/// The notes' quantities, position through snap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourBarGeometric {
    /// The diagonal, BD.
    pub e: [f64; 5],
    /// The angle at D between AD and DB.
    pub alpha: [f64; 5],
    /// The angle at C.
    pub gamma: [f64; 5],
    /// The angle at D between DB and DC.
    pub beta: [f64; 5],
    /// The rocker's angle.
    pub theta4: [f64; 5],
    /// The coupler's angle.
    pub theta3: [f64; 5],
}

/// Position, on any branch. NaN where the linkage cannot close.
#[must_use]
pub fn position(dimensions: Dimensions, theta2: f64, branch: Branch) -> Position {
    let Dimensions { r1, r2, r3, r4 } = dimensions;

    let e = (r1.powi(2) + r2.powi(2) - 2.0 * r1 * r2 * cos(theta2)).sqrt();

    let s_alpha = r2 * sin(theta2) / e;
    let alpha = if branch.alpha_obtuse {
        PI.copysign(s_alpha) - s_alpha.asin()
    } else {
        s_alpha.asin()
    };

    let c_gamma = (r3.powi(2) + r4.powi(2) - e.powi(2)) / (2.0 * r3 * r4);
    let gamma = match branch.assembly {
        Assembly::Open => c_gamma.acos(),
        Assembly::Crossed => -c_gamma.acos(),
    };

    let s_beta = r3 * sin(gamma) / e;
    let beta = if branch.beta_obtuse {
        PI.copysign(s_beta) - s_beta.asin()
    } else {
        s_beta.asin()
    };

    let theta4 = PI - alpha - beta;
    let theta3 = theta4 - gamma;

    Position {
        e,
        alpha,
        gamma,
        beta,
        theta4,
        theta3,
    }
}

/// Velocity, acceleration, jerk and snap at a position of any branch.
#[must_use]
pub fn derivatives(dimensions: Dimensions, theta2: [f64; 5], position: Position) -> FourBarGeometric {
    let Dimensions { r1, r2, r3, r4 } = dimensions;
    let [theta2, theta2_1, theta2_2, theta2_3, theta2_4] = theta2;
    let Position {
        e,
        alpha,
        gamma,
        beta,
        theta4,
        theta3,
    } = position;

    // Velocity
    let e_1 = r1 * r2 * theta2_1 * sin(theta2) / e;
    let alpha_1 = (r2 * theta2_1 * cos(theta2) - e_1 * sin(alpha)) / (e * cos(alpha));
    let gamma_1 = e * e_1 / (r3 * r4 * sin(gamma));
    let beta_1 = (r3 * gamma_1 * cos(gamma) - e_1 * sin(beta)) / (e * cos(beta));
    let theta4_1 = -alpha_1 - beta_1;
    let theta3_1 = theta4_1 - gamma_1;

    // Acceleration
    let e_2 = (r1 * r2 * theta2_2 * sin(theta2) + r1 * r2 * theta2_1.powi(2) * cos(theta2) - e_1.powi(2)) / e;
    let alpha_2 = (r2 * theta2_2 * cos(theta2)
        - r2 * theta2_1.powi(2) * sin(theta2)
        - e_2 * sin(alpha)
        - 2.0 * e_1 * alpha_1 * cos(alpha)
        + e * alpha_1.powi(2) * sin(alpha))
        / (e * cos(alpha));
    let gamma_2 = (e_1.powi(2) + e * e_2 - r3 * r4 * gamma_1.powi(2) * cos(gamma)) / (r3 * r4 * sin(gamma));
    let beta_2 = (r3 * gamma_2 * cos(gamma)
        - r3 * gamma_1.powi(2) * sin(gamma)
        - e_2 * sin(beta)
        - 2.0 * e_1 * beta_1 * cos(beta)
        + e * beta_1.powi(2) * sin(beta))
        / (e * cos(beta));
    let theta4_2 = -alpha_2 - beta_2;
    let theta3_2 = theta4_2 - gamma_2;

    // Jerk
    let e_3 = (r1 * r2 * theta2_3 * sin(theta2) + 3.0 * r1 * r2 * theta2_1 * theta2_2 * cos(theta2)
        - r1 * r2 * theta2_1.powi(3) * sin(theta2)
        - 3.0 * e_1 * e_2)
        / e;
    let alpha_3 = (r2 * theta2_3 * cos(theta2)
        - 3.0 * r2 * theta2_1 * theta2_2 * sin(theta2)
        - r2 * theta2_1.powi(3) * cos(theta2)
        + 3.0 * e * alpha_1 * alpha_2 * sin(alpha)
        + e * alpha_1.powi(3) * cos(alpha)
        - 3.0 * e_2 * alpha_1 * cos(alpha)
        - 3.0 * e_1 * alpha_2 * cos(alpha)
        + 3.0 * e_1 * alpha_1.powi(2) * sin(alpha)
        - e_3 * sin(alpha))
        / (e * cos(alpha));
    let gamma_3 = (3.0 * e_1 * e_2 + e * e_3 - 3.0 * r3 * r4 * gamma_1 * gamma_2 * cos(gamma)
        + r3 * r4 * gamma_1.powi(3) * sin(gamma))
        / (r3 * r4 * sin(gamma));
    let beta_3 = (r3 * gamma_3 * cos(gamma)
        - 3.0 * r3 * gamma_1 * gamma_2 * sin(gamma)
        - r3 * gamma_1.powi(3) * cos(gamma)
        - e_3 * sin(beta)
        - 3.0 * e_2 * beta_1 * cos(beta)
        - 3.0 * e_1 * beta_2 * cos(beta)
        + 3.0 * e_1 * beta_1.powi(2) * sin(beta)
        + 3.0 * e * beta_1 * beta_2 * sin(beta)
        + e * beta_1.powi(3) * cos(beta))
        / (e * cos(beta));
    let theta4_3 = -alpha_3 - beta_3;
    let theta3_3 = theta4_3 - gamma_3;

    // Snap
    let e_4 = (r1 * r2 * theta2_4 * sin(theta2)
        + 4.0 * r1 * r2 * theta2_1 * theta2_3 * cos(theta2)
        + 3.0 * r1 * r2 * theta2_2.powi(2) * cos(theta2)
        - 6.0 * r1 * r2 * theta2_1.powi(2) * theta2_2 * sin(theta2)
        - r1 * r2 * theta2_1.powi(4) * cos(theta2)
        - 3.0 * e_2.powi(2)
        - 4.0 * e_1 * e_3)
        / e;
    let alpha_4 = (r2 * theta2_4 * cos(theta2)
        - 4.0 * r2 * theta2_1 * theta2_3 * sin(theta2)
        - 3.0 * r2 * theta2_2.powi(2) * sin(theta2)
        - 6.0 * r2 * theta2_1.powi(2) * theta2_2 * cos(theta2)
        + r2 * theta2_1.powi(4) * sin(theta2)
        + 4.0 * e * alpha_1 * alpha_3 * sin(alpha)
        + 3.0 * e * alpha_2.powi(2) * sin(alpha)
        + 6.0 * e * alpha_1.powi(2) * alpha_2 * cos(alpha)
        - e * alpha_1.powi(4) * sin(alpha)
        - e_4 * sin(alpha)
        - 4.0 * e_3 * alpha_1 * cos(alpha)
        - 6.0 * e_2 * alpha_2 * cos(alpha)
        + 6.0 * e_2 * alpha_1.powi(2) * sin(alpha)
        - 4.0 * e_1 * alpha_3 * cos(alpha)
        + 12.0 * e_1 * alpha_1 * alpha_2 * sin(alpha)
        + 4.0 * e_1 * alpha_1.powi(3) * cos(alpha))
        / (e * cos(alpha));
    let gamma_4 = (3.0 * e_2.powi(2) + 4.0 * e_1 * e_3 + e * e_4
        - 4.0 * r3 * r4 * gamma_1 * gamma_3 * cos(gamma)
        - 3.0 * r3 * r4 * gamma_2.powi(2) * cos(gamma)
        + 6.0 * r3 * r4 * gamma_1.powi(2) * gamma_2 * sin(gamma)
        + r3 * r4 * gamma_1.powi(4) * cos(gamma))
        / (r3 * r4 * sin(gamma));
    let beta_4 = (r3 * gamma_4 * cos(gamma)
        - 4.0 * r3 * gamma_1 * gamma_3 * sin(gamma)
        - 3.0 * r3 * gamma_2.powi(2) * sin(gamma)
        - 6.0 * r3 * gamma_1.powi(2) * gamma_2 * cos(gamma)
        + r3 * gamma_1.powi(4) * sin(gamma)
        + 4.0 * e * beta_1 * beta_3 * sin(beta)
        + 3.0 * e * beta_2.powi(2) * sin(beta)
        + 6.0 * e * beta_1.powi(2) * beta_2 * cos(beta)
        - e * beta_1.powi(4) * sin(beta)
        - e_4 * sin(beta)
        - 4.0 * e_3 * beta_1 * cos(beta)
        - 6.0 * e_2 * beta_2 * cos(beta)
        + 6.0 * e_2 * beta_1.powi(2) * sin(beta)
        - 4.0 * e_1 * beta_3 * cos(beta)
        + 12.0 * e_1 * beta_1 * beta_2 * sin(beta)
        + 4.0 * e_1 * beta_1.powi(3) * cos(beta))
        / (e * cos(beta));
    let theta4_4 = -alpha_4 - beta_4;
    let theta3_4 = theta4_4 - gamma_4;

    FourBarGeometric {
        e: [e, e_1, e_2, e_3, e_4],
        alpha: [alpha, alpha_1, alpha_2, alpha_3, alpha_4],
        gamma: [gamma, gamma_1, gamma_2, gamma_3, gamma_4],
        beta: [beta, beta_1, beta_2, beta_3, beta_4],
        theta4: [theta4, theta4_1, theta4_2, theta4_3, theta4_4],
        theta3: [theta3, theta3_1, theta3_2, theta3_3, theta3_4],
    }
}

/// Position through snap, on the branch on which the linkage closes.
#[must_use]
pub fn solve(dimensions: Dimensions, theta2: [f64; 5], assembly: Assembly) -> FourBarGeometric {
    let branch = Branch::closing(dimensions, theta2[0], assembly);
    derivatives(dimensions, theta2, position(dimensions, theta2[0], branch))
}
