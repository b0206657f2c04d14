//! Section 5: the inverted slider-crank.
//!
//! Ground `r1` from the slotted lever's pivot O4 to the crank pivot O2, crank `r2`
//! at `theta2` (input), the lever's pivot to the crank pin `r4` (it varies) at
//! `theta4`; `alpha` = 180 degrees - `theta2`. The notes' short names: `a` =
//! `alpha`, `t` = `theta2`, `f` = `theta4`.
//!
//! The derivatives divide by `r4` and by `r4 c(f)`: they cannot be evaluated where
//! the lever is square to the ground, although the mechanism is regular there.
//! `r4` = 0 is the true singularity.

use std::f64::consts::PI;

use super::{cos, sin};

/// The lengths of the links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dimensions {
    /// Ground, from the lever's pivot to the crank pivot.
    pub r1: f64,
    /// Crank.
    pub r2: f64,
}

/// Which of their values the square root and the inverse sine take.
///
/// The notes' drawing has `r4` positive and `theta4` acute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Branch {
    /// The lever points away from the crank pin.
    pub r4_negative: bool,
    /// `theta4` is more than a right angle, either way.
    pub theta4_obtuse: bool,
}

impl Branch {
    /// The branch on which the mechanism closes: `theta4` is obtuse when
    /// `r1 + r2 c(theta2)`, which is `r4 c(theta4)`, and `r4` differ in sign.
    #[must_use]
    pub fn closing(dimensions: Dimensions, theta2: f64, r4_negative: bool) -> Self {
        let Dimensions { r1, r2 } = dimensions;
        Self {
            r4_negative,
            theta4_obtuse: (r1 + r2 * cos(theta2) < 0.0) != r4_negative,
        }
    }
}

/// The notes' quantities at one position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position {
    /// From the lever's pivot to the crank pin.
    pub r4: f64,
    /// The lever's angle.
    pub theta4: f64,
}

/// The notes' quantities, position through snap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InvertedSliderCrank {
    /// From the lever's pivot to the crank pin.
    pub r4: [f64; 5],
    /// The lever's angle.
    pub theta4: [f64; 5],
}

/// Position, on any branch.
#[must_use]
pub fn position(dimensions: Dimensions, theta2: f64, branch: Branch) -> Position {
    let Dimensions { r1, r2 } = dimensions;
    let t = theta2;
    let a = PI - t;

    let r4_squared = r1.powi(2) + r2.powi(2) - 2.0 * r1 * r2 * cos(a);
    let r4 = if branch.r4_negative {
        -r4_squared.sqrt()
    } else {
        r4_squared.sqrt()
    };

    let s_f = r2 * sin(t) / r4;
    let f = if branch.theta4_obtuse {
        PI.copysign(s_f) - s_f.asin()
    } else {
        s_f.asin()
    };

    Position { r4, theta4: f }
}

/// Velocity, acceleration, jerk and snap at a position of any branch.
#[must_use]
pub fn derivatives(dimensions: Dimensions, theta2: [f64; 5], position: Position) -> InvertedSliderCrank {
    let Dimensions { r1, r2 } = dimensions;
    let [t, t_1, t_2, t_3, t_4] = theta2;
    let [a, a_1, a_2, a_3, a_4] = [PI - t, -t_1, -t_2, -t_3, -t_4];
    let Position { r4, theta4: f } = position;

    // Velocity
    let r4_1 = r1 * r2 * a_1 * sin(a) / r4;
    let f_1 = (r2 * t_1 * cos(t) - r4_1 * sin(f)) / (r4 * cos(f));

    // Acceleration
    let r4_2 = (r1 * r2 * a_2 * sin(a) + r1 * r2 * a_1.powi(2) * cos(a) - r4_1.powi(2)) / r4;
    let f_2 = (r2 * t_2 * cos(t) - r2 * t_1.powi(2) * sin(t) - r4_2 * sin(f) - 2.0 * r4_1 * f_1 * cos(f)
        + r4 * f_1.powi(2) * sin(f))
        / (r4 * cos(f));

    // Jerk
    let r4_3 = (r1 * r2 * a_3 * sin(a) + 3.0 * r1 * r2 * a_1 * a_2 * cos(a)
        - r1 * r2 * a_1.powi(3) * sin(a)
        - 3.0 * r4_1 * r4_2)
        / r4;
    let f_3 = (r2 * t_3 * cos(t)
        - 3.0 * r2 * t_1 * t_2 * sin(t)
        - r2 * t_1.powi(3) * cos(t)
        - r4_3 * sin(f)
        - 3.0 * r4_2 * f_1 * cos(f)
        - 3.0 * r4_1 * f_2 * cos(f)
        + 3.0 * r4_1 * f_1.powi(2) * sin(f)
        + 3.0 * r4 * f_1 * f_2 * sin(f)
        + r4 * f_1.powi(3) * cos(f))
        / (r4 * cos(f));

    // Snap
    let r4_4 = (r1 * r2 * a_4 * sin(a) + 4.0 * r1 * r2 * a_1 * a_3 * cos(a) + 3.0 * r1 * r2 * a_2.powi(2) * cos(a)
        - 6.0 * r1 * r2 * a_1.powi(2) * a_2 * sin(a)
        - r1 * r2 * a_1.powi(4) * cos(a)
        - 3.0 * r4_2.powi(2)
        - 4.0 * r4_1 * r4_3)
        / r4;
    let f_4 = (r2 * t_4 * cos(t)
        - 4.0 * r2 * t_1 * t_3 * sin(t)
        - 3.0 * r2 * t_2.powi(2) * sin(t)
        - 6.0 * r2 * t_1.powi(2) * t_2 * cos(t)
        + r2 * t_1.powi(4) * sin(t)
        - r4_4 * sin(f)
        - 4.0 * r4_3 * f_1 * cos(f)
        - 6.0 * r4_2 * f_2 * cos(f)
        + 6.0 * r4_2 * f_1.powi(2) * sin(f)
        - 4.0 * r4_1 * f_3 * cos(f)
        + 12.0 * r4_1 * f_1 * f_2 * sin(f)
        + 4.0 * r4_1 * f_1.powi(3) * cos(f)
        + 4.0 * r4 * f_1 * f_3 * sin(f)
        + 3.0 * r4 * f_2.powi(2) * sin(f)
        + 6.0 * r4 * f_1.powi(2) * f_2 * cos(f)
        - r4 * f_1.powi(4) * sin(f))
        / (r4 * cos(f));

    InvertedSliderCrank {
        r4: [r4, r4_1, r4_2, r4_3, r4_4],
        theta4: [f, f_1, f_2, f_3, f_4],
    }
}

/// Position through snap, on the branch on which the mechanism closes.
#[must_use]
pub fn solve(dimensions: Dimensions, theta2: [f64; 5], r4_negative: bool) -> InvertedSliderCrank {
    let branch = Branch::closing(dimensions, theta2[0], r4_negative);
    derivatives(dimensions, theta2, position(dimensions, theta2[0], branch))
}
