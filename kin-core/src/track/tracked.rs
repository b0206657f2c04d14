//! What a track needs of a mechanism.

#[cfg(feature = "alloc")]
use alloc::vec;
#[cfg(feature = "alloc")]
use alloc::vec::Vec;

#[cfg(feature = "alloc")]
use super::follow::{TrackPlace, follow};
#[cfg(feature = "alloc")]
use super::obstacle::TrackError;
use crate::any::{AnyMechanism, ClosureOver, MotionNearOver};
use crate::mechanism::{First, Second};
#[cfg(feature = "alloc")]
use crate::mechanism::{Lent, Memory};

/// What a track needs of a mechanism without its type.
pub trait Tracked: AnyMechanism + MotionNearOver<f64> + ClosureOver<First> + ClosureOver<Second> {}

impl<F: AnyMechanism + MotionNearOver<f64> + ClosureOver<First> + ClosureOver<Second>> Tracked for F {}

#[cfg(feature = "alloc")]
/// [`track`](crate::track()) between two places.
pub(crate) fn track_between(
    mechanism: &dyn Tracked,
    parameters: &[f64],
    from: &[f64],
    unknowns: &[f64],
    to: &[f64],
) -> Result<Vec<f64>, TrackError<Vec<f64>, Vec<f64>>> {
    let description = mechanism.description();
    let memory = Memory {
        parameters: parameters.len(),
        inputs: from.len(),
        unknowns: unknowns.len(),
        blocks: description.blocks.len(),
        orders: description.order + 1,
    };
    let mut numbers = vec![0.0; memory.numbers()];
    let (mut first, mut second) = (vec![First::ZERO; memory.series()], vec![Second::ZERO; memory.series()]);
    let (mut inputs, mut near) = (from.to_vec(), unknowns.to_vec());
    let followed = follow(
        mechanism,
        parameters,
        [from, to],
        TrackPlace {
            inputs: &mut inputs,
            unknowns: &mut near,
        },
        Lent {
            numbers: &mut numbers,
            first: &mut first,
            second: &mut second,
        },
    );
    match followed {
        Ok(()) => {
            let mut unknowns = near.clone();
            mechanism.position_near(parameters, to, &near, &mut unknowns)?;
            Ok(unknowns)
        }
        Err(error) => Err(error.placed(inputs, near)),
    }
}
