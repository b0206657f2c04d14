//! Unknown angles that are returned as unit vectors.

use std::collections::{BTreeMap, BTreeSet};

use super::units::Units;
use crate::algebra::{Graph, Node, Symbol};
use crate::program::{DeclaredRange, DirectionSymbols, Directions, Names, Stage, Step};

/// The steps that find cosine and sine after the closed forms.
pub(crate) fn define(
    graph: &mut Graph,
    names: &mut Names,
    units: &mut Units,
    unknowns: &BTreeSet<usize>,
    position: &mut Stage<Node>,
) -> Directions {
    let mut directions = BTreeMap::new();
    for &unknown in unknowns {
        let angle = graph.symbol(Symbol::Unknown(unknown));
        let unit = units.direction(graph, angle);
        let name = names.of(Symbol::Unknown(unknown)).to_owned();
        let mut part = |wish: String| {
            let (symbol, _) = graph.new_step();
            names.name(symbol, &wish);
            symbol
        };
        let direction = DirectionSymbols {
            cosine: part(format!("cos_{name}")),
            sine: part(format!("sin_{name}")),
            angle: part(format!("{name}_angle")),
            is_free: false,
        };
        for (symbol, node) in [(direction.cosine, unit.re), (direction.sine, unit.im)] {
            position.steps.push(Step::Define { symbol, value: node });
        }
        directions.insert(unknown, direction);
    }
    Directions(directions)
}

/// The steps at the end of the position by which it hands the angles to later stages.
pub(crate) fn leave_angles(directions: &Directions, graph: &mut Graph, units: &mut Units, position: &mut Stage<Node>) {
    for (&unknown, direction) in &directions.0 {
        let (angle, node) = (graph.symbol(Symbol::Unknown(unknown)), graph.symbol(direction.angle));
        position.steps.push(Step::Define {
            symbol: direction.angle,
            value: angle,
        });
        units.rename(angle, node);
    }
}

/// Removes the steps that find an angle used neither by a range nor by another step. An angle found as a number, not as
/// a direction, stays, because its equation contains it as that number.
pub(crate) fn drop_idle(
    directions: &mut Directions,
    graph: &mut Graph,
    stages: &mut [Stage<Node>],
    ranges: &BTreeMap<usize, DeclaredRange>,
) {
    for (&unknown, direction) in &mut directions.0 {
        let angle = Symbol::Unknown(unknown);
        let is_of_angle = |step: &Step<Node>| matches!(step, Step::Angle { symbol, .. } if *symbol == angle);
        let is_angle_found = stages.iter().flat_map(|stage| &stage.steps).any(is_of_angle);
        let of_angle = graph.symbol(direction.angle);
        let of_unknown = graph.symbol(angle);
        let is_name = |step: &Step<Node>| matches!(step, Step::Define { symbol, .. } if *symbol == direction.angle);
        let needs: Vec<Node> = stages
            .iter()
            .flat_map(|stage| &stage.steps)
            .filter(|step| !is_name(step))
            .flat_map(Step::needs)
            .collect();
        let used = graph.reachable(&needs);
        direction.is_free = is_angle_found
            && !ranges.contains_key(&unknown)
            && !used.contains(&of_unknown)
            && !used.contains(&of_angle);
        if let (true, Some(position)) = (direction.is_free, stages.first_mut()) {
            position.steps.retain(|step| {
                let is_bound = matches!(step, Step::Bound { unknown: bound, .. } if *bound == unknown);
                !(is_of_angle(step) || is_name(step) || is_bound)
            });
        }
    }
}
