//! Comparing motions that two solvers gave.

use core::f64::consts::TAU;

use kin_core::prelude::*;

use crate::oracles::{ALLOWED, Gauge};

/// The difference of two angles without whole turns.
#[must_use]
pub fn turned_back(difference: f64) -> f64 {
    difference - TAU * (difference / TAU).round()
}

/// Asserts that two motions agree at every order, within as many units of error as the oracles allow.
///
/// `gauges` are those of the solvers with the number of the unknown in each; the errors of both add up. Angles are
/// compared modulo whole turns.
///
/// # Panics
/// If they do not agree.
#[track_caller]
pub fn assert_agree(
    name: &str,
    own: Motion<f64, 5>,
    other: Motion<f64, 5>,
    is_angle: bool,
    gauges: &[(&Gauge, usize)],
) {
    for (order, (a, b)) in own.derivatives().into_iter().zip(other.derivatives()).enumerate() {
        let mut difference = a - b;
        if is_angle && order == 0 {
            difference = turned_back(difference);
        }
        let unit: f64 = gauges.iter().map(|(gauge, index)| gauge.unknown(*index, order)).sum();
        assert!(
            difference.abs() <= ALLOWED[order] * unit,
            "{name}, order {order}: {a} against {b}, {} units",
            difference.abs() / unit
        );
    }
}
