//! The graph of bodies and points, and the cheapest ways through it from what is placed.

use std::collections::BTreeMap;

use crate::sketch::{Body, PointId, SlideId};

/// A point of a body.
pub(crate) struct Edge {
    pub(crate) body: Body,
    pub(crate) point: PointId,
    /// The slide, if the point slides on the body.
    pub(crate) slide: Option<SlideId>,
    /// The number of unknown distances: of a slide that is not driven one.
    pub(crate) unknowns: usize,
    /// Whether it has placed something or closed a loop.
    pub(crate) is_used: bool,
}

impl Edge {
    fn ends(&self) -> [Node; 2] {
        [Node::Body(self.body), Node::Point(self.point)]
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Node {
    Body(Body),
    Point(PointId),
}

/// The cheapest way from what is placed to a node.
#[derive(Clone, Copy)]
pub(crate) struct Way {
    /// The number of unknown quantities, and the length.
    pub(crate) cost: (usize, usize),
    /// The last edge.
    pub(crate) edge: usize,
    /// The first edge.
    first: usize,
}

pub(crate) type Ways = BTreeMap<Node, Way>;

/// The graph as far as it is placed.
pub(crate) struct Graph<'g> {
    pub(crate) edges: &'g [Edge],
    pub(crate) is_placed: &'g dyn Fn(Node) -> bool,
    /// The number of quantities that become unknown with a body.
    pub(crate) unknowns: &'g dyn Fn(Body) -> usize,
}

impl Graph<'_> {
    fn open_edges(&self) -> impl Iterator<Item = (usize, &Edge)> {
        self.edges.iter().enumerate().filter(|(_, edge)| !edge.is_used)
    }

    /// The cheapest ways to all nodes that are not placed.
    pub(crate) fn ways(&self) -> Ways {
        let mut ways = Ways::new();
        loop {
            let mut is_final = true;
            for (number, edge) in self.open_edges() {
                let [body, point] = edge.ends();
                for (from, to) in [(body, point), (point, body)] {
                    if (self.is_placed)(to) {
                        continue;
                    }
                    let (before, first) = match ways.get(&from) {
                        _ if (self.is_placed)(from) => ((0, 0), number),
                        Some(way) => (way.cost, way.first),
                        None => continue,
                    };
                    let unknowns = match to {
                        Node::Body(body) => (self.unknowns)(body),
                        Node::Point(_) => 0,
                    };
                    // of two ways with as many unknowns the one through links is the one that a person writes
                    let length = if edge.slide.is_some() { 3 } else { 1 };
                    let cost = (before.0 + unknowns + edge.unknowns, before.1 + length);
                    if ways.get(&to).is_none_or(|way| cost < way.cost) {
                        is_final = false;
                        let edge = number;
                        ways.insert(to, Way { cost, edge, first });
                    }
                }
            }
            if is_final {
                return ways;
            }
        }
    }

    /// The edge that closes the cheapest loop between two placed nodes.
    pub(crate) fn closing_edge(&self, ways: &Ways) -> Option<usize> {
        let closing = self.open_edges().filter_map(|(number, edge)| {
            let [body, point] = edge.ends().map(|end| ways.get(&end));
            let is_of_way = |way: Option<&Way>| way.is_some_and(|way| way.edge == number);
            let branches = [body, point].map(|way| way.map(|way| way.first));
            if is_of_way(body) || is_of_way(point) || branches[0].is_some() && branches[0] == branches[1] {
                return None;
            }
            let [(a, b), (c, d)] = [body, point].map(|way| way.map_or((0, 0), |way| way.cost));
            Some(((a + c + edge.unknowns, b + d), number))
        });
        closing.min().map(|(_, number)| number)
    }
}
