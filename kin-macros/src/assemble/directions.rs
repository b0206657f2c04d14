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
    /// The angle itself as later stages know it: the position does not hand it out.
    angle: Symbol,
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

    /// Leaves out the steps that find an angle which nothing asks for: no other step, and no range.
    pub(crate) fn drop_idle(&self, graph: &mut Graph, stages: &mut [Stage], ranges: &BTreeMap<usize, Limits>) {
        let mut candidates: BTreeMap<Symbol, Node> = BTreeMap::new();
        for (&unknown, direction) in &self.0 {
            candidates.insert(direction.angle, graph.symbol(direction.angle));
            if !ranges.contains_key(&unknown) {
                let own = Symbol::Unknown(unknown);
                candidates.insert(own, graph.symbol(own));
            }
        }
        // without one of them, what it was found from may be idle too
        while !candidates.is_empty() {
            let needs: Vec<Node> = stages
                .iter()
                .flat_map(|stage| &stage.steps)
                .flat_map(Step::needs)
                .collect();
            let used = graph.reachable(&needs);
            let idle: BTreeSet<Symbol> = candidates
                .iter()
                .filter(|(_, node)| !used.contains(*node))
                .map(|(&symbol, _)| symbol)
                .collect();
            if idle.is_empty() {
                return;
            }
            candidates.retain(|symbol, _| !idle.contains(symbol));
            let Some(position) = stages.first_mut() else {
                return;
            };
            let mut dropped = BTreeSet::new();
            position.steps.retain(|step| match step {
                Step::Define { symbol, .. } | Step::Angle { symbol, .. } if idle.contains(symbol) => {
                    dropped.insert(*symbol);
                    false
                }
                Step::Bound { unknown, .. } => !dropped.contains(&Symbol::Unknown(*unknown)),
                _ => true,
            });
        }
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
