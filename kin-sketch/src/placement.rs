//! The order in which points and links are placed, from the ground on, and the equations that close the loops.
//!
//! A drawing is a graph of bodies and points; its edges are the points of bodies, fixed to them or sliding on them. The
//! graph is placed along paths that lead from a placed part to another one, the path with the fewest unknown quantities
//! first. Where such a path meets itself, a loop closes: a point is found from two bodies. Two links between placed
//! points are a dyad, so a linkage of dyads is placed dyad by dyad, and each pair of equations has a pair of unknowns.

use std::collections::BTreeSet;

use crate::local::Frame;
use crate::sketch::{Body, Drive, PointId, Sketch, SlideId};
use crate::ways::{Edge, Graph, Node, Ways};

/// A point that is found from a body, or a loop that is closed there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Step {
    pub(crate) point: PointId,
    pub(crate) body: Body,
    /// The slide, if the point slides on the body.
    pub(crate) slide: Option<SlideId>,
    pub(crate) kind: StepKind,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum StepKind {
    /// The point is placed by its body.
    Point,
    /// The origin of the body is placed by a point that slides on it.
    Origin,
    /// The point has been placed already: an equation.
    Closure,
}

/// The points in their order, and where the bodies are.
pub(crate) struct Placement {
    pub(crate) steps: Vec<Step>,
    /// The frames of the bodies, the ground's first.
    pub(crate) frames: Vec<Frame>,
}

pub(crate) fn index(body: Body) -> usize {
    match body {
        Body::Ground => 0,
        Body::Link(link) => link + 1,
    }
}

struct Placing<'s> {
    sketch: &'s Sketch,
    edges: Vec<Edge>,
    is_placed: Vec<bool>,
    frames: Vec<Option<Frame>>,
    /// The bodies whose angles are unknowns already.
    angles: BTreeSet<Body>,
    steps: Vec<Step>,
}

/// Places a drawing without faults of its parts.
pub(crate) fn place(sketch: &Sketch) -> Placement {
    let fixed = sketch.bodies().flat_map(|body| {
        sketch.points_of(body).iter().map(move |point| Edge {
            body,
            point: *point,
            slide: None,
            unknowns: 0,
            is_used: false,
        })
    });
    let sliding = sketch.slides.iter().enumerate().map(|(slide, on)| Edge {
        body: on.on,
        point: on.point,
        slide: Some(slide),
        unknowns: usize::from(!sketch.is_driven(slide)),
        is_used: false,
    });
    let mut placing = Placing {
        sketch,
        edges: fixed.chain(sliding).collect(),
        is_placed: vec![false; sketch.points.len()],
        frames: vec![None; sketch.links.len() + 1],
        angles: BTreeSet::new(),
        steps: Vec::new(),
    };
    let ground = Frame {
        origin: sketch.origin(),
        axis: 0.0,
    };
    if let Some(origin) = ground.origin {
        placing.is_placed[origin] = true;
    }
    placing.set(Body::Ground, ground);
    while placing.grow() {}
    Placement {
        steps: placing.steps,
        frames: placing
            .frames
            .into_iter()
            .map(|frame| frame.expect("every link is connected with the ground"))
            .collect(),
    }
}

impl Placing<'_> {
    fn is_placed(&self, node: Node) -> bool {
        match node {
            Node::Body(body) => self.frames[index(body)].is_some(),
            Node::Point(point) => self.is_placed[point],
        }
    }

    /// Places a part of the drawing; `false` if there is none left.
    fn grow(&mut self) -> bool {
        let graph = Graph {
            edges: &self.edges,
            is_placed: &|node| self.is_placed(node),
            unknowns: &|body| usize::from(self.unknown_angle(body).is_some()),
        };
        let ways = graph.ways();
        let nearest = ways.iter().min_by_key(|(node, way)| (way.cost, **node));
        let Some((&nearest, way)) = nearest else {
            return false;
        };
        let closing = graph.closing_edge(&ways).filter(|_| way.cost.0 > 0);
        let Some(number) = closing else {
            self.follow(nearest, &ways, None);
            return true;
        };
        let Edge { body, point, slide, .. } = self.edges[number];
        self.follow(Node::Point(point), &ways, None);
        self.follow(Node::Body(body), &ways, slide.is_none().then_some(point));
        true
    }

    /// The angle that becomes unknown with a body.
    fn unknown_angle(&self, body: Body) -> Option<Body> {
        self.sketch
            .unknown_angle(body)
            .filter(|root| !self.angles.contains(root))
    }

    /// Places all that lies on the way to a node, and the node.
    fn follow(&mut self, node: Node, ways: &Ways, toward: Option<PointId>) {
        if self.is_placed(node) {
            return;
        }
        let number = ways[&node].edge;
        let Edge { body, point, slide, .. } = self.edges[number];
        match node {
            Node::Point(_) => {
                self.follow(Node::Body(body), ways, slide.is_none().then_some(point));
                if !self.is_placed[point] {
                    self.edges[number].is_used = true;
                    self.put(Step {
                        point,
                        body,
                        slide,
                        kind: StepKind::Point,
                    });
                }
            }
            Node::Body(_) => {
                self.follow(Node::Point(point), ways, None);
                // what has been placed on the way may have placed this as well
                if self.is_placed(node) {
                    return;
                }
                self.edges[number].is_used = true;
                let origin = match slide {
                    None => point,
                    Some(_) => self.sketch.points_of(body)[0],
                };
                let frame = self.frame(body, origin, toward);
                if slide.is_some() {
                    self.angles.extend(self.unknown_angle(body));
                    if self.is_placed[origin] {
                        // the body is known by both points: the slide closes a loop
                        self.edges[number].is_used = false;
                    } else {
                        self.is_placed[origin] = true;
                        self.steps.push(Step {
                            point,
                            body,
                            slide,
                            kind: StepKind::Origin,
                        });
                    }
                }
                self.set(body, frame);
                // the body has placed its origin, which may slide on another one
                self.close(|edge| edge.point == origin);
            }
        }
    }

    fn frame(&self, body: Body, origin: PointId, toward: Option<PointId>) -> Frame {
        let root = self.sketch.root(body);
        if let Some(frame) = self.frames[index(root)] {
            return Frame {
                origin: Some(origin),
                axis: frame.axis,
            };
        }
        // what is guided comes before its guide
        let rail = self.sketch.slides.iter().find(|slide| slide.on == root);
        let others = || {
            self.sketch
                .points_of(body)
                .iter()
                .copied()
                .filter(|point| *point != origin)
        };
        let is_joint = |point: &PointId| self.edges.iter().filter(|edge| edge.point == *point).count() > 1;
        let toward = toward
            .filter(|point| *point != origin)
            .or_else(|| others().find(is_joint))
            .or_else(|| others().next());
        let axis = match (rail, toward) {
            (Some(slide), _) => slide.direction,
            (None, Some(toward)) => {
                let ([x, y], [to_x, to_y]) = (self.sketch.at(origin), self.sketch.at(toward));
                (to_y - y).atan2(to_x - x)
            }
            (None, None) => 0.0,
        };
        Frame {
            origin: Some(origin),
            axis,
        }
    }

    /// Places a body, and all points that are fixed to it.
    fn set(&mut self, body: Body, frame: Frame) {
        self.frames[index(body)] = Some(frame);
        self.angles.extend(self.unknown_angle(body));
        for number in 0..self.edges.len() {
            let Edge {
                body: of,
                point,
                slide,
                is_used,
                ..
            } = self.edges[number];
            if of != body || slide.is_some() || is_used {
                continue;
            }
            self.edges[number].is_used = true;
            if frame.origin == Some(point) {
                continue;
            }
            let kind = if self.is_placed[point] {
                StepKind::Closure
            } else {
                StepKind::Point
            };
            self.put(Step {
                point,
                body,
                slide: None,
                kind,
            });
        }
        self.close(|edge| edge.body == body);
    }

    /// Adds a step, and closes the loops that end in a point that it places.
    fn put(&mut self, step: Step) {
        self.steps.push(step);
        if step.kind == StepKind::Point {
            self.is_placed[step.point] = true;
            self.close(|edge| edge.point == step.point);
        }
    }

    /// Closes the loops of slides of which both ends are placed.
    fn close(&mut self, is_new: impl Fn(&Edge) -> bool) {
        for number in 0..self.edges.len() {
            let edge = &self.edges[number];
            let (body, point) = (edge.body, edge.point);
            let are_placed = self.is_placed[point] && self.is_placed(Node::Body(body));
            if let Some(slide) = edge.slide
                && !edge.is_used
                && is_new(edge)
                && are_placed
            {
                self.edges[number].is_used = true;
                self.steps.push(Step {
                    point,
                    body,
                    slide: Some(slide),
                    kind: StepKind::Closure,
                });
            }
        }
    }
}

impl Sketch {
    /// The point of the ground that becomes the origin: the pivot of the first link that is driven.
    fn origin(&self) -> Option<PointId> {
        let links = self.drives.iter().filter_map(|drive| match drive {
            Drive::Angle { of, .. } => Some(&self.links[*of].points),
            Drive::Slide(_) => None,
        });
        let pivots = links.flatten().copied().filter(|point| self.ground.contains(point));
        pivots.chain(self.ground.iter().copied()).next()
    }
}
