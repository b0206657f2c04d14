//! Extremes along a branch of a cycle: a sweep whose ends are known.

use alloc::vec::Vec;

use super::curve::StretchEnd;
use super::quantity::Named;
use super::station::SweepStation;
use super::swept::{Mark, PoseQuantity, QuantityOfSweep};
use super::{Extreme, ExtremesError};
use crate::any::Of;
use crate::mechanism::Mechanism;
use crate::number::Number;
use crate::sweep::{Course, LimitKind, SmoothDrive, Walk};

/// The ends of a sweep on which the mechanism closes throughout, and a pose inside of it.
pub(crate) struct KnownStretch {
    /// The limits at both ends, `None` where the curve would go on.
    pub(crate) limits: [Option<LimitKind>; 2],
    /// Whether the end is the pose of the beginning.
    pub(crate) is_full_turn: bool,
    pub(crate) inside: Walk,
}

impl KnownStretch {
    pub(super) fn ends(&self) -> ([StretchEnd; 2], Mark) {
        let end = |limit: Option<LimitKind>| limit.map_or(StretchEnd::Sweep, StretchEnd::Limit);
        (self.limits.map(end), Mark::new(self.inside.clone()))
    }
}

impl<M: Mechanism<Scalar = f64>, D: SmoothDrive> Course<M, D> {
    /// The extremes of a quantity that is called by its name.
    pub(crate) fn extremes_between(&self, known: KnownStretch, name: &str) -> Result<Vec<Extreme>, ExtremesError> {
        let named = Named::find::<M>(name)?;
        self.between(known, &|station| named.at(Of::<M>::FUNCTIONS, station))
    }

    /// The extremes of the angle between the links of a dyad.
    pub(crate) fn transmission_extremes_between(
        &self,
        known: KnownStretch,
        dyad: usize,
    ) -> Result<Vec<Extreme>, ExtremesError> {
        self.between(known, &|station: &SweepStation| {
            let margins = station.margins(Of::<M>::FUNCTIONS).ok();
            let transmission = margins.and_then(|margins| margins.transmission_angle(dyad));
            let gap = ExtremesError::Gap {
                at: station.variable.real(),
            };
            transmission.map(|transmission| transmission.angle).ok_or(gap)
        })
    }

    fn between(&self, known: KnownStretch, quantity: &PoseQuantity<'_>) -> Result<Vec<Extreme>, ExtremesError> {
        let asked = QuantityOfSweep {
            course: self.any(),
            drive: &self.drive,
            quantity,
            known: Some(known),
            progress: None,
        };
        let found = asked.extremes()?;
        Ok(match found.first {
            // a quantity that stays where it is over a full turn
            Some(first) if found.extremes.is_empty() => alloc::vec![first],
            _ => found.extremes,
        })
    }
}
