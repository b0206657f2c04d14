//! A sweep of the first input, from one position to both sides.

use kin_core::prelude::*;
use kin_core::{PlaneOrSpace, PointArray};

/// The number of steps of a revolution.
const STEPS: u32 = 180;

/// The coordinates of a mechanism's joints and directions, position by position.
pub(super) fn sweep<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    inputs: M::Inputs<f64>,
    unknowns: M::Unknowns<f64>,
    range: f64,
) -> Vec<Vec<Space>> {
    let start = points_of(mechanism, inputs, unknowns);
    let size = extent(&start);
    let side = |direction: f64, most: u32| {
        let mut found = Vec::new();
        let (mut near, mut last) = (unknowns, start.clone());
        for step in 1..=most {
            let mut inputs = inputs;
            if let Some(input) = inputs.as_mut().first_mut() {
                *input += direction * range * f64::from(step) / f64::from(STEPS);
            }
            let Ok(next) = mechanism.position_near(inputs, near) else {
                break;
            };
            let here = points_of(mechanism, inputs, next);
            // beyond a limit position lies another branch
            if here
                .iter()
                .zip(&last)
                .any(|(&here, &last)| (here - last).norm() > 0.2 * size)
            {
                break;
            }
            (near, last) = (next, here.clone());
            found.push(here);
        }
        found
    };
    let ahead = side(1.0, STEPS);
    if u32::try_from(ahead.len()) == Ok(STEPS) {
        let mut revolution = vec![start.clone()];
        revolution.extend(ahead);
        return revolution;
    }
    let mut back = side(-1.0, STEPS);
    back.reverse();
    back.push(start.clone());
    back.extend(ahead);
    back
}

/// The joints and directions at one position.
pub(super) fn points_of<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    inputs: M::Inputs<f64>,
    unknowns: M::Unknowns<f64>,
) -> Vec<Space> {
    let points = mechanism.skeleton_points(inputs, unknowns);
    points.as_slice().iter().map(|point| point.in_space()).collect()
}

/// The largest distance from the first point.
pub(super) fn extent(points: &[Space]) -> f64 {
    let Some(&first) = points.first() else { return 0.0 };
    points.iter().map(|&point| (point - first).norm()).fold(0.0, f64::max)
}
