//! The quantities of a declaration, named and measured where a formula needs them first.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, TAU};

use crate::local::{Frame, rotated};
use crate::names::Names;
use crate::placement::{Placement, index};
use crate::sketch::{Body, PointId, Sketch, SlideId};

/// The quantities that have been written.
pub(crate) struct Quantities<'s> {
    pub(crate) sketch: &'s Sketch,
    placement: &'s Placement,
    pub(crate) names: Names,
    /// The size below which a coordinate is zero.
    pub(crate) zero: f64,
    pub(crate) fields: Vec<String>,
    pub(crate) dimensions: Vec<(String, f64)>,
    pub(crate) inputs: Vec<(String, f64)>,
    pub(crate) unknowns: Vec<(String, f64)>,
    /// Inputs and unknowns with their dimensions.
    pub(crate) declared: Vec<String>,
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
            zero: 1e-9 * sketch.size(),
            fields: Vec::new(),
            dimensions: Vec::new(),
            inputs: Vec::new(),
            unknowns: Vec::new(),
            declared: Vec::new(),
            angles: BTreeMap::new(),
            distances: BTreeMap::new(),
            lines: BTreeMap::new(),
        }
    }

    pub(crate) fn frame(&self, body: Body) -> Frame {
        self.placement.frames[index(body)]
    }

    /// The word that links and their quantities share: its name, or the number that the notes give it.
    pub(crate) fn stem(&self, link: usize, prefix: &str) -> String {
        match &*self.sketch.links[link].name {
            "" => format!("{prefix}{}", link + 2),
            name => name.to_owned(),
        }
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
        let quantities = if self.sketch.is_driven(slide) {
            &mut self.inputs
        } else {
            &mut self.unknowns
        };
        quantities.push((name.clone(), value));
        self.declared.push(format!("{name}: Length"));
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
                self.unknowns.push((name.clone(), axis));
                self.declared.push(format!("{name}: Angle"));
                name
            }
            Some(base) => {
                self.declared.push(format!("{name}: Angle"));
                let axis_of_base = self.frame(self.sketch.root(base)).axis;
                self.inputs.push((name.clone(), axis - axis_of_base));
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

    /// The statements of inputs and unknowns.
    pub(crate) fn declared(&self) -> String {
        let is_input = |declared: &&String| {
            let names = self.inputs.iter().map(|(name, _)| name);
            names.into_iter().any(|name| declared.starts_with(&format!("{name}:")))
        };
        let (inputs, unknowns): (Vec<&String>, Vec<&String>) = self.declared.iter().partition(is_input);
        let listed = |names: Vec<&String>| names.into_iter().cloned().collect::<Vec<_>>().join(", ");
        let inputs = format!("input {};\n", listed(inputs));
        match &*listed(unknowns) {
            "" => inputs,
            unknowns => format!("{inputs}unknown {unknowns};\n"),
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
