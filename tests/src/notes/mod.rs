//! The lecture notes' hand-derived formulas, transcribed line by line.
//!
//! This is an oracle: every function here is what the notes print and nothing
//! else, in plain `f64`, sharing no code with the crates it is used to check.
//! Nothing is simplified, factored out or made robust. Where a printed formula
//! divides by zero (each file says where), so does its transcription, and
//! outside the reach of a linkage `asin`, `acos` or a square root gives NaN.
//!
//! Conventions, the same in every file:
//!
//! - `theta2_1`, `theta2_2`, `theta2_3`, `theta2_4` are the first to fourth time
//!   derivatives of `theta2` (the notes write primes), and likewise for any
//!   other quantity.
//! - `[f64; 5]` is a quantity with its derivatives: position, velocity,
//!   acceleration, jerk, snap.
//! - Angles are in radians, counter-clockwise positive, measured from the ground
//!   line.
//! - Names are the notes' own, in lower case where the notes use a capital
//!   (`R`, `L`, `K1`, `C0`).
//! - `position` chooses a branch; `derivatives` holds on any branch, for it takes
//!   the position as given; `solve` is the one after the other.

pub mod four_bar_geometric;
pub mod freudenstein;
pub mod inverted_slider_crank;
pub mod sample;
pub mod slider_crank;
pub mod slider_crank_approximate;

/// The two ways in which a four-bar linkage can be put together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Assembly {
    /// As drawn in the notes: the angle `gamma` at the joint of coupler and
    /// rocker lies between 0 and 180 degrees.
    Open,
    /// Coupler and rocker mirrored about the diagonal: `gamma` is negative.
    Crossed,
}

/// The notes' s(x).
fn sin(x: f64) -> f64 {
    x.sin()
}

/// The notes' c(x).
fn cos(x: f64) -> f64 {
    x.cos()
}

#[cfg(test)]
mod test_support {
    //! A smooth input motion and a finite-difference check.

    /// Angles of the crank at which to look: all the way round, clear of the
    /// round values at which divisors vanish.
    pub(super) fn around() -> impl Iterator<Item = f64> {
        (0..48).map(|step| f64::from(step).mul_add(0.131, 0.017))
    }

    /// The motion whose derivatives at time 0 are `initial`, at time `t`.
    pub(super) fn polynomial([q, q_1, q_2, q_3, q_4]: [f64; 5], t: f64) -> [f64; 5] {
        [
            q + t * (q_1 + t / 2.0 * (q_2 + t / 3.0 * (q_3 + t / 4.0 * q_4))),
            q_1 + t * (q_2 + t / 2.0 * (q_3 + t / 3.0 * q_4)),
            q_2 + t * (q_3 + t / 2.0 * q_4),
            q_3 + t * q_4,
            q_4,
        ]
    }

    /// Every entry but the first is the time derivative, at time 0, of the one
    /// before it: by central differences, extrapolated once (Richardson).
    /// `scale` is the size against which the difference counts as small.
    #[track_caller]
    pub(super) fn assert_consistent<const N: usize>(name: &str, scale: f64, quantity: impl Fn(f64) -> [f64; N]) {
        const STEP: f64 = 1e-3;
        let exact = quantity(0.0);
        let central = |k: usize, h: f64| (quantity(h)[k] - quantity(-h)[k]) / (2.0 * h);
        for k in 0..N - 1 {
            let coarse = central(k, 2.0 * STEP);
            let fine = central(k, STEP);
            let difference = fine + (fine - coarse) / 3.0;
            let error = (difference - exact[k + 1]).abs();
            assert!(
                error <= 1e-6 * (scale + exact[k + 1].abs()),
                "{name}, derivative {}: formula {}, difference {difference}",
                k + 1,
                exact[k + 1],
            );
        }
    }
}
