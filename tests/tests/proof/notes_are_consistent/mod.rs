//! The transcribed formulas of the notes close the loops, and each of their derivatives is that of the one before, by
//! differences.

mod four_bar_geometric;
mod freudenstein;
mod inverted_slider_crank;
mod sample;
mod slider_crank;
mod slider_crank_approximate;

fn sin(x: f64) -> f64 {
    x.sin()
}

fn cos(x: f64) -> f64 {
    x.cos()
}

/// Angles of the crank at which to look: all the way round, clear of the
/// round values at which divisors vanish.
fn around() -> impl Iterator<Item = f64> {
    (0..48).map(|step| f64::from(step).mul_add(0.131, 0.017))
}

/// The motion whose derivatives at time 0 are `initial`, at time `t`.
fn polynomial([q, q_1, q_2, q_3, q_4]: [f64; 5], t: f64) -> [f64; 5] {
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
fn assert_consistent<const N: usize>(name: &str, scale: f64, quantity: impl Fn(f64) -> [f64; N]) {
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
