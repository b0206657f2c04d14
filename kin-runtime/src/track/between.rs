//! Tracks without the type of the mechanism, in memory of the heap.

use alloc::vec::Vec;

use super::follow::follow;
use super::line::TrackPosition;
use super::obstacle::TrackError;
use crate::curve::CurveFunctions;
use crate::mechanism::HeapMemory;

/// [`track`](crate::track()) between two points.
///
/// # Errors
/// As for `track`.
#[doc(hidden)]
pub fn track_between(
    mechanism: &dyn CurveFunctions,
    parameters: &[f64],
    from: &[f64],
    unknowns: &[f64],
    to: &[f64],
) -> Result<Vec<f64>, TrackError<Vec<f64>, Vec<f64>>> {
    let mut memory = HeapMemory::new(mechanism.description(), parameters.len());
    let (mut inputs, mut near) = (from.to_vec(), unknowns.to_vec());
    let followed = follow(
        mechanism,
        parameters,
        [from, to],
        TrackPosition {
            inputs: &mut inputs,
            unknowns: &mut near,
        },
        memory.lend(),
    );
    match followed {
        Ok(()) => {
            let mut unknowns = near.clone();
            mechanism.position_near(parameters, to, &near, &mut unknowns)?;
            Ok(unknowns)
        }
        Err(error) => Err(error.with_position(inputs, near)),
    }
}
