//! The unknown angles that are returned as unit vectors.

use std::collections::BTreeMap;

use crate::algebra::Symbol;

/// The symbols of the unit vectors, by the indices of the unknowns.
#[derive(Clone, Default)]
pub(crate) struct Directions(pub(crate) BTreeMap<usize, DirectionSymbols>);

/// The symbols of an unknown's unit vector and angle.
#[derive(Clone, Copy)]
pub(crate) struct DirectionSymbols {
    pub(crate) cosine: Symbol,
    pub(crate) sine: Symbol,
    /// The angle, as later stages refer to it.
    pub(crate) angle: Symbol,
    /// Whether nothing uses the angle, so that it is not computed.
    pub(crate) is_free: bool,
}

/// A component of a unit vector that is returned.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum UnitPart {
    Cosine,
    Sine,
}

impl Directions {
    /// The symbol of an angle that is computed besides its unit vector, otherwise `None`.
    pub(crate) fn angle(&self, unknown: usize) -> Option<Symbol> {
        let direction = self.0.get(&unknown)?;
        (!direction.is_free).then_some(direction.angle)
    }

    /// The symbols of all such angles.
    pub(crate) fn angles(&self) -> impl Iterator<Item = Symbol> + '_ {
        self.0.keys().filter_map(|&unknown| self.angle(unknown))
    }

    /// The symbol of a component of an unknown's unit vector, `None` if the unknown is not a direction.
    pub(crate) fn part(&self, unknown: usize, part: UnitPart) -> Option<Symbol> {
        let direction = self.0.get(&unknown)?;
        Some(match part {
            UnitPart::Cosine => direction.cosine,
            UnitPart::Sine => direction.sine,
        })
    }

    /// The unknown and the component of its unit vector that a symbol stands for.
    pub(crate) fn meaning(&self, symbol: Symbol) -> Option<(usize, UnitPart)> {
        self.0.iter().find_map(|(&unknown, direction)| {
            [(direction.cosine, UnitPart::Cosine), (direction.sine, UnitPart::Sine)]
                .into_iter()
                .find(|&(known, _)| known == symbol)
                .map(|(_, part)| (unknown, part))
        })
    }
}
