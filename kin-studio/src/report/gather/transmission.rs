//! Transmission angles over the range.

use kin_core::sweep::SmoothDrive;

use super::way::{At, Way};
use crate::report::draft::Wishes;
use crate::report::model::{Angles, Transmission, WorstAngle};

/// The transmission angles of all dyads, if there are any and if they are found everywhere.
pub(super) fn of<D: SmoothDrive>(wishes: &Wishes<'_>, way: &Way<'_, D>, poses: &[At]) -> Option<Transmission> {
    let linkage = &wishes.linkage;
    let mut dyads = Vec::new();
    let mut samples = Vec::new();
    for (input, pose) in poses {
        let Ok(pose) = pose else { continue };
        let angles = linkage.transmission_angles(pose.inputs(), pose.unknowns());
        if dyads.is_empty() {
            dyads = angles.iter().map(|angle| wishes.named(angle.block)).collect();
        }
        samples.push(Angles {
            input: super::short(*input),
            angles: angles.iter().map(|angle| super::short(angle.folded())).collect(),
        });
    }
    let worst = |dyad: usize| {
        let lowest = way
            .sweeps
            .iter()
            .filter_map(|sweep| sweep.of_transmission_angle(dyad).lowest().ok());
        let least = lowest.min_by(|one, other| one.value.total_cmp(&other.value))?;
        Some(WorstAngle {
            angle: least.value,
            at: least.at,
        })
    };
    let count = linkage.dyad_count();
    let worst: Option<Vec<WorstAngle>> = (0..count).map(worst).collect();
    let transmission = Transmission {
        dyads,
        worst: worst?,
        samples,
    };
    (count > 0).then_some(transmission)
}
