//! The vectors from the origin of a body to its points.

use crate::local::rotated;
use crate::quantities::Quantities;
use crate::sketch::{Body, PointId, SlideId};

impl Quantities<'_> {
    /// From the origin of a body to a point of it.
    pub(crate) fn fixed(&mut self, body: Body, point: PointId) -> String {
        let frame = self.frame(body);
        let [x, y] = rotated(self.sketch.offset(frame, point), -frame.axis);
        let Body::Link(link) = body else {
            unreachable!("the points of the ground are placed first, and no loop closes through two of them");
        };
        let angle = self.angle(body);
        let of_point = format!("{}_{}", self.sketch.stem(link, "r"), self.sketch.points[point].name);
        if y.abs() <= self.zero {
            let name = self.length(link, &of_point);
            self.field(&name, "Length", x);
            match angle {
                Some(angle) => format!("{name} * cis({angle})"),
                None => format!("vec2({name}, 0)"),
            }
        } else {
            let name = self.names.take(&of_point);
            match angle {
                Some(angle) => {
                    self.vector_field(&name, "Vector", [x, y]);
                    format!("{name} * cis({angle})")
                }
                None if x.abs() <= self.zero => {
                    self.field(&name, "Length", y);
                    format!("vec2(0, {name})")
                }
                None => {
                    self.vector_field(&name, "Vector", [x, y]);
                    name
                }
            }
        }
    }

    /// From the origin of a body to a point that slides on it.
    pub(crate) fn sliding(&mut self, body: Body, slide: SlideId) -> String {
        let frame = self.frame(body);
        let point = self.sketch.slides[slide].point;
        let distance = self.distance(slide);
        let angle = self.angle(body);
        let offset = rotated(self.sketch.offset(frame, point), -self.sketch.slides[slide].direction);
        let is_upright = self.is_upright(body, slide);
        let beside = if is_upright { -offset[1] } else { offset[1] };
        let beside = if beside.abs() <= self.zero {
            None
        } else {
            let name = self.names.take(&format!("offset_{}", self.sketch.points[point].name));
            self.field(&name, "Length", beside);
            Some(name)
        };
        if is_upright {
            let x = beside.unwrap_or_else(|| "0".to_owned());
            return match angle {
                Some(angle) => format!("vec2({x}, {distance}) * cis({angle})"),
                None => format!("vec2({x}, {distance})"),
            };
        }
        let line = self.line(body, slide);
        match (beside, line) {
            (None, Some(line)) => format!("{distance} * cis({line})"),
            (Some(y), Some(line)) => format!("vec2({distance}, {y}) * cis({line})"),
            (None, None) => format!("vec2({distance}, 0)"),
            (Some(y), None) => format!("vec2({distance}, {y})"),
        }
    }
}
