//! Unknown angles that are handed out as unit vectors.

use std::collections::{BTreeMap, BTreeSet};

use super::program::{Limits, Names, Stage, Step};
use super::units::Units;
use crate::expr::{Graph, Node, Symbol};

/// What the parts of unit vectors are called in a program, by the unknowns' places.
#[derive(Clone, Default)]
pub(crate) struct Directions(BTreeMap<usize, Direction>);

/// The values that stand for an unknown.
#[derive(Clone, Copy)]
struct Direction {
    cosine: Symbol,
    sine: Symbol,
    /// The angle itself as later stages know it.
    angle: Symbol,
    /// Whether nothing asks for the angle, so that it is not found at all.
    is_free: bool,
}

/// A part of a unit vector that is handed out.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum UnitPart {
    Cosine,
    Sine,
}

impl Directions {
    /// The steps that find cosine and sine where everything that the closed forms find is known.
    pub(crate) fn define(
        graph: &mut Graph,
        names: &mut Names,
        units: &mut Units,
        unknowns: &BTreeSet<usize>,
        position: &mut Stage,
    ) -> Self {
        let mut directions = BTreeMap::new();
        for &unknown in unknowns {
            let own = graph.symbol(Symbol::Unknown(unknown));
            let unit = units.direction(graph, own);
            let name = names.of(Symbol::Unknown(unknown)).to_owned();
            let mut part = |wish: String| {
                let (symbol, _) = graph.new_step();
                names.name(symbol, &wish);
                symbol
            };
            let direction = Direction {
                cosine: part(format!("cos_{name}")),
                sine: part(format!("sin_{name}")),
                angle: part(format!("{name}_angle")),
                is_free: false,
            };
            for (symbol, node) in [(direction.cosine, unit.re), (direction.sine, unit.im)] {
                position.steps.push(Step::Define { symbol, node });
            }
            directions.insert(unknown, direction);
        }
        Self(directions)
    }

    /// Where the position is complete: the steps by which it leaves the angles to later stages.
    pub(crate) fn leave_angles(&self, graph: &mut Graph, units: &mut Units, position: &mut Stage) {
        for (&unknown, direction) in &self.0 {
            let (own, node) = (graph.symbol(Symbol::Unknown(unknown)), graph.symbol(direction.angle));
            position.steps.push(Step::Define {
                symbol: direction.angle,
                node: own,
            });
            units.rename(own, node);
        }
    }

    /// Leaves out the steps that find an angle which nothing asks for: no range, and no other step. An angle that was not found as
    /// a direction, but as a number, stays, for it stands as that number in its equation.
    pub(crate) fn drop_idle(&mut self, graph: &mut Graph, stages: &mut [Stage], ranges: &BTreeMap<usize, Limits>) {
        for (&unknown, direction) in &mut self.0 {
            let own = Symbol::Unknown(unknown);
            let is_own = |step: &Step| matches!(step, Step::Angle { symbol, .. } if *symbol == own);
            let turns = stages.iter().flat_map(|stage| &stage.steps).any(is_own);
            let of_angle = graph.symbol(direction.angle);
            let of_own = graph.symbol(own);
            let is_name = |step: &Step| matches!(step, Step::Define { symbol, .. } if *symbol == direction.angle);
            let needs: Vec<Node> = stages
                .iter()
                .flat_map(|stage| &stage.steps)
                .filter(|step| !is_name(step))
                .flat_map(Step::needs)
                .collect();
            let used = graph.reachable(&needs);
            direction.is_free =
                turns && !ranges.contains_key(&unknown) && !used.contains(&of_own) && !used.contains(&of_angle);
            if let (true, Some(position)) = (direction.is_free, stages.first_mut()) {
                position.steps.retain(|step| {
                    let is_bound = matches!(step, Step::Bound { unknown: bound, .. } if *bound == unknown);
                    !(is_own(step) || is_name(step) || is_bound)
                });
            }
        }
    }

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
