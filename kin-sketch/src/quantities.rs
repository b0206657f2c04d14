//! The quantities of a declaration, named and measured where a formula needs them first.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{FRAC_PI_2, TAU};

use crate::local::{Frame, rotated};
use crate::names::Names;
use crate::placement::{Placement, index};
use crate::sketch::{Body, LinkId, PointId, Sketch, SlideId};

/// The quantities that have been written.
pub(crate) struct Quantities<'s> {
    pub(crate) sketch: &'s Sketch,
    placement: &'s Placement,
    pub(crate) names: Names,
    /// The size below which a coordinate is zero.
    pub(crate) zero: f64,
    pub(crate) fields: Vec<String>,
    pub(crate) dimensions: Vec<(String, f64)>,
    /// Inputs and unknowns, and their declarations.
    pub(crate) inputs: Vec<(String, f64)>,
    pub(crate) unknowns: Vec<(String, f64)>,
    declared: [Vec<String>; 2],
    /// The links that have a length.
    measured: BTreeSet<LinkId>,
    /// The angle of a body that others turn with.
    angles: BTreeMap<Body, String>,
    /// The distance of a slide, and the angle of its line.
    distances: BTreeMap<SlideId, String>,
    lines: BTreeMap<SlideId, String>,
}

impl<'s> Quantities<'s> {
    pub(crate) fn new(sketch: &'s Sketch, placement: &'s Placement, names: Names) -> Self {
        Self {
            sketch,
            placement,
            names,
            zero: sketch.negligible(),
            fields: Vec::new(),
            dimensions: Vec::new(),
            inputs: Vec::new(),
            unknowns: Vec::new(),
            declared: [const { Vec::new() }; 2],
            measured: BTreeSet::new(),
            angles: BTreeMap::new(),
            distances: BTreeMap::new(),
            lines: BTreeMap::new(),
        }
    }

    pub(crate) fn frame(&self, body: Body) -> Frame {
        self.placement.frames[index(body)]
    }

    /// The angle of a slide's line, if it is not that of the ground.
    pub(crate) fn line(&mut self, body: Body, slide: SlideId) -> Option<String> {
        let angle = self.angle(body);
        let direction = self.sketch.relative_direction(self.frame(body), slide);
        if is_zero_angle(direction) {
            return angle;
        }
        let inclination = if let Some(name) = self.lines.get(&slide) {
            name.clone()
        } else {
            let point = self.sketch.slides[slide].point;
            let name = self.names.take(&format!("alpha_{}", self.sketch.points[point].name));
            self.field(&name, "Angle", direction);
            self.lines.insert(slide, name.clone());
            name
        };
        Some(match angle {
            Some(angle) => format!("{angle} + {inclination}"),
            None => inclination,
        })
    }

    /// The distance of a point along its slide, from the foot of the body's origin.
    pub(crate) fn distance(&mut self, slide: SlideId) -> String {
        if let Some(name) = self.distances.get(&slide) {
            return name.clone();
        }
        let drawn = &self.sketch.slides[slide];
        let name = match self.sketch.slides.len() {
            1 => self.names.take("s"),
            _ => self.names.take(&format!("s_{}", self.sketch.points[drawn.point].name)),
        };
        let offset = self.sketch.offset(self.frame(drawn.on), drawn.point);
        let value = rotated(offset, -drawn.direction)[0];
        self.declare(&name, "Length", value, self.sketch.is_driven(slide));
        self.distances.insert(slide, name.clone());
        name
    }

    /// The angle of a body; `None` if it does not turn.
    pub(crate) fn angle(&mut self, body: Body) -> Option<String> {
        let root = self.sketch.root(body);
        let Body::Link(link) = root else { return None };
        if let Some(angle) = self.angles.get(&root) {
            return Some(angle.clone());
        }
        let name = match &*self.sketch.links[link].name {
            "" => format!("theta{}", link + 2),
            name => format!("{name}_angle"),
        };
        let name = self.names.take(&name);
        let axis = self.frame(root).axis;
        let angle = match self.sketch.driven_from(root) {
            None => {
                self.declare(&name, "Angle", axis, false);
                name
            }
            Some(base) => {
                let axis_of_base = self.frame(self.sketch.root(base)).axis;
                self.declare(&name, "Angle", axis - axis_of_base, true);
                match self.angle(base) {
                    Some(base) => format!("{base} + {name}"),
                    None => name,
                }
            }
        };
        self.angles.insert(root, angle.clone());
        Some(angle)
    }

    /// The formula of a point of the ground, beside the origin; none if the point is a dimension itself.
    pub(crate) fn fixed_point(&mut self, point: PointId) -> Option<String> {
        let offset = self.sketch.offset(self.frame(Body::Ground), point);
        if offset[1].abs() > self.zero {
            self.vector_field(&self.sketch.points[point].name, "Point", offset);
            return None;
        }
        let length = self.names.take("r1");
        self.field(&length, "Length", offset[0]);
        Some(format!("vec2({length}, 0)"))
    }

    fn declare(&mut self, name: &str, dimension: &str, value: f64, is_input: bool) {
        let [inputs, unknowns] = &mut self.declared;
        let (quantities, declared) = if is_input {
            (&mut self.inputs, inputs)
        } else {
            (&mut self.unknowns, unknowns)
        };
        quantities.push((name.to_owned(), value));
        declared.push(format!("{name}: {dimension}"));
    }

    /// The statements of inputs and unknowns.
    pub(crate) fn declared(&self) -> String {
        let [inputs, unknowns] = &self.declared;
        let inputs = format!("input {};\n", inputs.join(", "));
        match &*unknowns.join(", ") {
            "" => inputs,
            unknowns => format!("{inputs}unknown {unknowns};\n"),
        }
    }

    /// The name of a point's distance along the x axis of its link, the first of which is the length of the link.
    pub(crate) fn length(&mut self, link: LinkId, of_point: &str) -> String {
        if self.measured.insert(link) {
            self.names.take(&self.sketch.stem(link, "r"))
        } else {
            self.names.take(of_point)
        }
    }

    pub(crate) fn field(&mut self, name: &str, kind: &str, value: f64) {
        self.fields.push(format!("{name}: {kind}"));
        self.dimensions.push((name.to_owned(), value));
    }

    pub(crate) fn vector_field(&mut self, name: &str, kind: &str, [x, y]: [f64; 2]) {
        self.fields.push(format!("{name}: {kind}"));
        self.dimensions.push((format!("{name}.x"), x));
        self.dimensions.push((format!("{name}.y"), y));
    }

    /// Whether a slide's line is upright in the frame of its body.
    pub(crate) fn is_upright(&self, body: Body, slide: SlideId) -> bool {
        is_zero_angle(self.sketch.relative_direction(self.frame(body), slide) - FRAC_PI_2)
    }
}

fn is_zero_angle(angle: f64) -> bool {
    (angle / TAU - (angle / TAU).round()).abs() * TAU <= 1e-9
}
