//! The unknown angles that are handed out as unit vectors.

use std::collections::BTreeMap;

use crate::algebra::Symbol;

/// The symbols of the unit vectors, by the unknowns' places.
#[derive(Clone, Default)]
pub(crate) struct Directions(pub(crate) BTreeMap<usize, DirectionSymbols>);

/// The values that stand for an unknown.
#[derive(Clone, Copy)]
pub(crate) struct DirectionSymbols {
    pub(crate) cosine: Symbol,
    pub(crate) sine: Symbol,
    /// The angle itself as later stages know it.
    pub(crate) angle: Symbol,
    /// Whether nothing asks for the angle, so that it is not found at all.
    pub(crate) is_free: bool,
}

/// A part of a unit vector that is handed out.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum UnitPart {
    Cosine,
    Sine,
}

impl Directions {
    /// The symbol of an angle that is found all the same, `None` if cosine and sine are all there is.
    pub(crate) fn angle(&self, unknown: usize) -> Option<Symbol> {
        let direction = self.0.get(&unknown)?;
        (!direction.is_free).then_some(direction.angle)
    }

    /// All of them.
    pub(crate) fn angles(&self) -> impl Iterator<Item = Symbol> + '_ {
        self.0.keys().filter_map(|&unknown| self.angle(unknown))
    }

    /// The symbol of a part of an unknown's unit vector, `None` if it is no direction.
    pub(crate) fn part(&self, unknown: usize, part: UnitPart) -> Option<Symbol> {
        let direction = self.0.get(&unknown)?;
        Some(match part {
            UnitPart::Cosine => direction.cosine,
            UnitPart::Sine => direction.sine,
        })
    }

    /// Which unknown's unit vector a value is a part of, and which part.
    pub(crate) fn meaning(&self, symbol: Symbol) -> Option<(usize, UnitPart)> {
        self.0.iter().find_map(|(&unknown, direction)| {
            [(direction.cosine, UnitPart::Cosine), (direction.sine, UnitPart::Sine)]
                .into_iter()
                .find(|&(own, _)| own == symbol)
                .map(|(_, part)| (unknown, part))
        })
    }
}
