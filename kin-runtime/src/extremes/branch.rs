//! Extremes along a branch of a cycle: a sweep whose ends are known.

use alloc::boxed::Box;
use alloc::vec::Vec;

use super::at::HIGHEST;
use super::curve::StretchEnd;
use super::margin::transmission_angle;
use super::quantity::Named;
use super::station::{NamedFunctions, SweepStation};
use super::swept::{Mark, PoseQuantity, QuantityOfSweep};
use super::{Extreme, ExtremesError};
use crate::curve::LimitKind;
use crate::sweep::{SmoothDrive, UntypedSweep, Walk};

/// The ends of a sweep on which the mechanism closes throughout, and a pose inside of it.
pub(crate) struct KnownStretch<'c> {
    /// The limits at both ends, `None` where the curve would go on.
    pub(crate) limits: [Option<LimitKind>; 2],
    /// Whether the end is the pose of the beginning.
    pub(crate) is_full_revolution: bool,
    pub(crate) inside: Walk<'c>,
}

impl<'c> KnownStretch<'c> {
    pub(super) fn ends(&self) -> ([StretchEnd; 2], Mark<'c>) {
        let end = |limit: Option<LimitKind>| limit.map_or(StretchEnd::Sweep, StretchEnd::Limit);
        (self.limits.map(end), Mark::new(self.inside.clone()))
    }
}

/// A quantity of each pose of a sweep.
pub(crate) type StationQuantity<'q> = Box<PoseQuantity<'q>>;

/// A quantity that is called by its name.
pub(crate) fn named_quantity<'q>(
    functions: &'q dyn NamedFunctions,
    name: &str,
) -> Result<StationQuantity<'q>, ExtremesError> {
    let named = Named::find(functions, name, HIGHEST)?;
    Ok(Box::new(move |station| named.at(functions, station)))
}

/// A sweep on which the mechanism closes throughout.
pub(crate) struct KnownSweep<'c> {
    pub(crate) sweep: UntypedSweep<'c>,
    pub(crate) drive: &'c dyn SmoothDrive,
    pub(crate) stretch: KnownStretch<'c>,
}

impl KnownSweep<'_> {
    /// The extremes of the angle between the links of a dyad.
    pub(crate) fn transmission_extremes(
        self,
        functions: &dyn NamedFunctions,
        dyad: usize,
    ) -> Result<Vec<Extreme>, ExtremesError> {
        self.extremes_of(&|station: &SweepStation<'_>| {
            transmission_angle(station.margins(functions), station, dyad).map(|transmission| transmission.angle)
        })
    }

    /// The extremes of a quantity of each pose.
    pub(crate) fn extremes_of(self, quantity: &PoseQuantity<'_>) -> Result<Vec<Extreme>, ExtremesError> {
        let asked = QuantityOfSweep {
            sweep: self.sweep,
            drive: self.drive,
            quantity,
            rate: None,
            known: Some(self.stretch),
            jumps: None,
            progress: None,
        };
        let found = asked.extremes()?;
        Ok(match found.first {
            // a quantity that stays where it is over a full revolution
            Some(first) if found.extremes.is_empty() => alloc::vec![first],
            _ => found.extremes,
        })
    }
}
