//! Frames of bodies, and from which body the angle of a body counts.

use crate::sketch::{Body, PointId, Sketch, SlideId};

/// Where a body is drawn: its origin, and the direction of its x axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    /// A point of the body; for a ground without points the origin of the drawing.
    pub(crate) origin: Option<PointId>,
    /// In radians from the x axis of the drawing.
    pub(crate) axis: f64,
}

/// A quantity of the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Variable {
    /// The angle of a drive.
    Turned(Body),
    /// The angle of a link that is not driven.
    Angle(Body),
    Slide(SlideId),
}

/// A vector, rotated by an angle.
pub(crate) fn rotated([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    [x * cosine - y * sine, x * sine + y * cosine]
}

impl Sketch {
    /// The body that a body turns with: itself, or the last of those that guide it.
    pub(crate) fn root(&self, body: Body) -> Body {
        std::iter::successors(Some(body), |body| self.guide(*body))
            .last()
            .unwrap_or(body)
    }

    /// The variables on which the angle of a body depends.
    pub(crate) fn angles_of(&self, body: Body) -> Vec<Variable> {
        let root = self.root(body);
        match (root, self.driven_from(root)) {
            (Body::Ground, _) => Vec::new(),
            (_, Some(base)) => {
                let mut variables = self.angles_of(base);
                variables.push(Variable::Turned(root));
                variables
            }
            (_, None) => vec![Variable::Angle(root)],
        }
    }

    /// The body whose angle is unknown and from which the angle of a body counts, if there is one.
    pub(crate) fn unknown_angle(&self, body: Body) -> Option<Body> {
        self.angles_of(body).into_iter().find_map(|variable| match variable {
            Variable::Angle(root) => Some(root),
            Variable::Turned(_) | Variable::Slide(_) => None,
        })
    }

    /// From the origin of a frame to a point, in the drawing.
    pub(crate) fn offset(&self, frame: Frame, point: PointId) -> [f64; 2] {
        let [x, y] = self.at(point);
        let [from_x, from_y] = frame.origin.map_or([0.0; 2], |origin| self.at(origin));
        [x - from_x, y - from_y]
    }

    /// The direction of a slide, in the frame of its body.
    pub(crate) fn relative_direction(&self, frame: Frame, slide: SlideId) -> f64 {
        self.slides[slide].direction - frame.axis
    }
}
