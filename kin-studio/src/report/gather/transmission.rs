//! Transmission angles over the range.

use kin_core::sweep::Local;
use kin_core::{Mechanism, Number as _, Row};

use super::way::{At, Way};
use crate::report::model::{Angles, Transmission, WorstAngle};

/// The transmission angles of all dyads, if there are any and if they are found everywhere.
pub(super) fn of<M: Mechanism<Scalar = f64>>(way: &Way<M>, poses: &[At<M>]) -> Option<Transmission> {
    let count = <M::Dyads<f64> as Row<f64>>::LENGTH;
    let mut dyads = Vec::new();
    let mut samples = Vec::new();
    for (input, pose) in poses {
        let Ok(pose) = pose else { continue };
        let angles = {
            let (inputs, unknowns) = way.values(*input, pose);
            way.mechanism.transmission_angles_at(inputs, unknowns)
        };
        if dyads.is_empty() {
            dyads = angles.as_ref().iter().map(|angle| angle.block.to_owned()).collect();
        }
        samples.push(Angles {
            input: super::short(*input),
            angles: angles
                .as_ref()
                .iter()
                .map(|angle| super::short(angle.folded()))
                .collect(),
        });
    }
    let mut worst = Vec::new();
    for dyad in 0..count {
        let mut least: Option<WorstAngle> = None;
        for course in &way.courses {
            let lowest = course
                .of_expression(|at| {
                    at.transmission_angle(dyad)
                        .map_or(Local::constant(f64::NAN), |angle| angle.folded())
                })
                .lowest();
            let Ok(own) = lowest else { continue };
            if least.is_none_or(|least| own.value < least.angle) {
                least = Some(WorstAngle {
                    angle: own.value,
                    at: own.at,
                });
            }
        }
        worst.push(least?);
    }
    (count > 0).then_some(Transmission { dyads, worst, samples })
}
