//! Links, joints, ground and sliders, drawn over each other.

use std::fmt::Write as _;

use kin_core::{Plane, Space};

use super::canvas::unit;
use super::frame::Frame;
use super::labels::Labels;
use super::{Canvas, DRIVE, Drive, GREY, INK, Note, PATH, Scene};

/// The style of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    /// Width of the picture, in pixels.
    pub width: f64,
    /// Its height.
    pub height: f64,
    /// The caption below the drawing; empty for none.
    pub title: String,
    /// Whether bodies bear their names.
    pub names: bool,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            width: 480.0,
            height: 360.0,
            title: String::new(),
            names: true,
        }
    }
}

/// Room for symbols between the drawing and the edge.
const MARGIN: f64 = 34.0;
/// Width of a bar.
const BAR: f64 = 7.0;
/// Radius of a pin.
const PIN: f64 = 3.4;
/// Half the length and half the width of a slider.
const BLOCK: [f64; 2] = [11.0, 6.5];
/// Fills: of what an input drives, and of the other bodies.
const DRIVEN: &str = "#f9dcc4";
const PLAIN: &str = "#eceff1";

/// Draws a scene as an SVG file.
#[must_use]
pub fn draw(scene: &Scene, style: &Style) -> String {
    canvas(scene, style).finish(style.width, style.height, &style.title)
}

/// Draws a scene onto a canvas, which may be placed in a larger one.
#[must_use]
pub fn canvas(scene: &Scene, style: &Style) -> Canvas {
    let mut pen = Pen::new(scene, style, &[]);
    pen.ground();
    pen.paths();
    for number in 0..scene.outline.bodies.len() {
        pen.body(number);
    }
    pen.sliders();
    for joint in pen.marked() {
        pen.mark(joint);
    }
    pen.drives();
    pen.notes();
    pen.labels();
    if !style.title.is_empty() {
        let at = Plane::new(0.5 * style.width, style.height - 10.0);
        pen.canvas.text(at, 12.0, "middle", "", &style.title);
    }
    pen.canvas
}

pub(super) struct Pen<'a> {
    scene: &'a Scene,
    style: &'a Style,
    pub(super) frame: Frame,
    joints: Vec<Plane>,
    /// The joints between two bodies, or of a body on a slide.
    pins: Vec<usize>,
    pub(super) canvas: Canvas,
    labels: Labels,
}

impl<'a> Pen<'a> {
    /// A pen whose picture has room for the scene and for further points.
    pub(super) fn new(scene: &'a Scene, style: &'a Style, further: &[Space]) -> Self {
        let mut seen = [&scene.joints, further].concat();
        for joint in scene.traced() {
            seen.extend(scene.path(joint));
        }
        for (number, slide) in scene.outline.slides.iter().enumerate() {
            seen.extend(guide(scene, number));
            seen.push(scene.joints[slide.joint]);
        }
        let foot = if style.title.is_empty() { 0.0 } else { 16.0 };
        let low = Plane::new(MARGIN, MARGIN - 6.0);
        let high = Plane::new(style.width - MARGIN, style.height - MARGIN - foot);
        let frame = Frame::around(&seen, scene.is_plane, low, high);
        let joints: Vec<Plane> = scene.joints.iter().map(|&joint| frame.point(joint)).collect();
        let mut pen = Self {
            scene,
            style,
            frame,
            joints,
            pins: Vec::new(),
            canvas: Canvas::default(),
            labels: Labels::within(Plane::new(style.width, style.height - foot)),
        };
        pen.pins = (0..scene.joints.len()).filter(|&joint| pen.is_pin(joint)).collect();
        pen
    }

    /// Whether a body rotates about a joint.
    fn is_pin(&self, joint: usize) -> bool {
        let outline = &self.scene.outline;
        let bodies = outline.bodies.iter().enumerate();
        let turning = bodies.filter(|(number, body)| {
            let mut slides = outline.slides.iter().enumerate();
            let glides = body.joints.len() == 1
                && slides.any(|(slide, slide_of)| slide_of.guide == Some(*number) && self.scene.keeps_direction(slide));
            body.joints.contains(&joint) && !glides
        });
        let slides = outline.slides.iter().any(|slide| slide.joint == joint);
        let fixed = outline.ground.contains(&joint);
        let count = turning.count();
        count > 1 || count == 1 && (slides || fixed)
    }

    fn is_fixed(&self, joint: usize) -> bool {
        self.scene.outline.ground.contains(&joint)
    }

    /// Triangles and hatching below fixed pivots, and guides that stand still.
    pub(super) fn ground(&mut self) {
        for number in 0..self.scene.outline.slides.len() {
            if self.scene.outline.slides[number].guide.is_some() {
                continue;
            }
            let [from, to] = guide(self.scene, number).map(|end| self.frame.point(end));
            let along = unit(to - from);
            let mut below = Plane::new(-along.y, along.x);
            if below.y < -1e-9 || below.y.abs() <= 1e-9 && below.x < 0.0 {
                below = -below;
            }
            let shift = below.scale(BLOCK[1] + 1.0);
            let [from, to] = [from - along.scale(16.0) + shift, to + along.scale(16.0) + shift];
            self.canvas.line(from, to, GREY, 1.0);
            hatch(&mut self.canvas, from, to, below);
            self.labels.keep_line(from + below.scale(3.0), to + below.scale(3.0));
        }
        for joint in self.pins.clone() {
            if !self.is_fixed(joint) {
                continue;
            }
            let at = self.joints[joint];
            let corners = [at, at + Plane::new(-8.0, 13.0), at + Plane::new(8.0, 13.0)];
            let style = format!(r##"fill="#ffffff" stroke="{INK}" stroke-width="1" stroke-linejoin="round""##);
            self.canvas.path(&corners, true, &style);
            let [from, to] = [at + Plane::new(-12.0, 13.0), at + Plane::new(12.0, 13.0)];
            self.canvas.line(from, to, INK, 1.0);
            hatch(&mut self.canvas, from, to, Plane::new(0.0, 1.0));
            self.labels.keep(at + Plane::new(0.0, 10.0), 10.0);
        }
    }

    pub(super) fn paths(&mut self) {
        for joint in self.scene.traced() {
            let path: Vec<Plane> = self
                .scene
                .path(joint)
                .iter()
                .map(|&point| self.frame.point(point))
                .collect();
            if path.len() < 2 {
                continue;
            }
            let style = format!(r#"fill="none" stroke="{PATH}" stroke-width="1.3""#);
            self.canvas.path(&path, false, &style);
            for pair in path.windows(2) {
                self.labels.keep_line(pair[0], pair[1]);
            }
        }
    }

    /// The corners of a body on the page: its joints, and how far its slides lead.
    fn corners(&self, number: usize) -> Vec<Plane> {
        let body = &self.scene.outline.bodies[number];
        let mut corners: Vec<Plane> = body.joints.iter().map(|&joint| self.joints[joint]).collect();
        for (slide, slide_of) in self.scene.outline.slides.iter().enumerate() {
            if slide_of.guide == Some(number) && !self.is_cylinder(slide) {
                let [from, to] = guide(self.scene, slide).map(|end| self.frame.point(end));
                let along = unit(to - from);
                corners.extend([from - along.scale(BLOCK[0]), to + along.scale(BLOCK[0])]);
            } else if slide_of.guide == Some(number) {
                corners.push(self.joints[slide_of.joint]);
            }
        }
        corners
    }

    /// Whether a slide is the stroke of a cylinder: it is driven, or seen in space.
    fn is_cylinder(&self, slide: usize) -> bool {
        let slide_of = &self.scene.outline.slides[slide];
        let driven = |drive: &Drive| matches!(drive, Drive::Shift { joint, .. } if *joint == slide_of.joint);
        slide_of.guide.is_some() && (!self.scene.is_plane || self.scene.drives.iter().any(driven))
    }

    pub(super) fn body(&mut self, number: usize) {
        let corners = self.corners(number);
        let fill = if self.is_driven(number) { DRIVEN } else { PLAIN };
        let mut slides = self.scene.outline.slides.iter().enumerate();
        let is_cylinder = slides.any(|(slide, slide_of)| slide_of.guide == Some(number) && self.is_cylinder(slide));
        let outer = hull(&corners);
        for index in 0..outer.len() {
            self.labels.keep_bar(outer[index], outer[(index + 1) % outer.len()]);
        }
        if is_cylinder && outer.len() == 2 {
            let [from, to] = [corners[0], corners[1]];
            let middle = from + (to - from).scale(0.6);
            bar(&mut self.canvas, &[from, to], 1.6, PLAIN);
            bar(&mut self.canvas, &[from, middle], 6.0, fill);
        } else if outer.len() > 2 && !self.scene.is_plane {
            pane(&mut self.canvas, &outer, fill);
        } else {
            let width = if self.style.width < 320.0 { 5.5 } else { BAR };
            bar(&mut self.canvas, &outer, width, fill);
        }
    }

    fn is_driven(&self, number: usize) -> bool {
        let body = &self.scene.outline.bodies[number];
        self.scene.drives.iter().any(|drive| match drive {
            Drive::Rotation { arm, centre, .. } => {
                let has = |wanted: Space| body.joints.iter().any(|&joint| self.scene.joints[joint] == wanted);
                let fixed = body.joints.iter().any(|&joint| self.is_fixed(joint));
                has(*arm) && (fixed || has(*centre))
            }
            Drive::Between { .. } => false,
            Drive::Shift { joint, .. } => {
                let mut slides = self.scene.outline.slides.iter();
                slides.any(|slide| slide.joint == *joint && slide.guide == Some(number))
            }
        })
    }

    fn sliders(&mut self) {
        for (number, slide) in self.scene.outline.slides.iter().enumerate() {
            if self.is_cylinder(number) {
                continue;
            }
            let at = self.joints[slide.joint];
            let along = unit(self.frame.direction(self.scene.directions[number]));
            let across = Plane::new(-along.y, along.x);
            let [long, wide] = [along.scale(BLOCK[0]), across.scale(BLOCK[1])];
            let corners = [at - long - wide, at + long - wide, at + long + wide, at - long + wide];
            let style = format!(r##"fill="#ffffff" stroke="{INK}" stroke-width="1.2" stroke-linejoin="round""##);
            self.canvas.path(&corners, true, &style);
            self.labels.keep(at, 11.0);
        }
    }

    /// The pins, and the points that are none.
    pub(super) fn marked(&self) -> Vec<usize> {
        let points = self.scene.outline.points.iter().map(|&(_, joint)| joint);
        let points = points.filter(|joint| !self.pins.contains(joint));
        self.pins.iter().copied().chain(points).collect()
    }

    pub(super) fn mark(&mut self, joint: usize) {
        let at = self.joints[joint];
        if self.pins.contains(&joint) {
            let radius = if self.is_fixed(joint) { PIN + 0.8 } else { PIN };
            let open = format!(r##"fill="#ffffff" stroke="{INK}" stroke-width="1.2""##);
            self.canvas.circle(at, radius, &open);
            self.labels.keep(at, 5.0);
        } else {
            self.canvas.circle(at, 2.6, &format!(r#"fill="{PATH}" stroke="none""#));
            self.labels.keep(at, 4.0);
        }
    }

    pub(super) fn drives(&mut self) {
        for drive in &self.scene.drives {
            match drive {
                Drive::Rotation { centre, arm, forward } => {
                    let radius = (*arm - *centre).norm();
                    let u = (*arm - *centre).scale(1.0 / radius);
                    let v = forward.scale(1.0 / forward.norm());
                    // as large on the page as is wanted
                    let pixels = (self.frame.point(*centre + u.scale(radius)) - self.frame.point(*centre)).norm();
                    let pixels =
                        pixels.max((self.frame.point(*centre + v.scale(radius)) - self.frame.point(*centre)).norm());
                    let reach = radius * (15.0 / pixels);
                    let arc: Vec<Plane> = (0..=16)
                        .map(|step| {
                            let angle = 0.35 + 1.4 * f64::from(step) / 16.0;
                            let (sine, cosine) = angle.sin_cos();
                            self.frame
                                .point(*centre + u.scale(reach * cosine) + v.scale(reach * sine))
                        })
                        .collect();
                    arc_with_arrow(&mut self.canvas, &mut self.labels, &arc, true);
                }
                Drive::Between { centre, arms } => {
                    let middle = self.frame.point(*centre);
                    let [from, to] = arms.map(|arm| {
                        let leg = self.frame.point(arm) - middle;
                        leg.y.atan2(leg.x)
                    });
                    let angle = (to - from).rem_euclid(std::f64::consts::TAU);
                    let angle = if angle > std::f64::consts::PI {
                        angle - std::f64::consts::TAU
                    } else {
                        angle
                    };
                    let arc: Vec<Plane> = (0..=16)
                        .map(|step| middle + Plane::polar(17.0, from + angle * (0.15 + 0.7 * f64::from(step) / 16.0)))
                        .collect();
                    arc_with_arrow(&mut self.canvas, &mut self.labels, &arc, true);
                }
                Drive::Shift { joint, forward } => {
                    let forward = unit(self.frame.direction(*forward));
                    let across = Plane::new(-forward.y, forward.x);
                    let from = self.joints[*joint] + across.scale(13.0) - forward.scale(10.0);
                    arc_with_arrow(
                        &mut self.canvas,
                        &mut self.labels,
                        &[from, from + forward.scale(24.0)],
                        true,
                    );
                }
            }
        }
    }

    fn notes(&mut self) {
        for note in &self.scene.notes {
            match note {
                Note::Text { at, text } => {
                    let at = self.frame.point(*at);
                    self.labels
                        .write(&mut self.canvas, &[at], text, 13.0, r#"font-style="italic""#);
                }
                Note::Angle { at, angle, text } => {
                    let vertex = self.frame.point(*at);
                    let radius = 26.0;
                    let end = Plane::new(vertex.x + 1.5 * radius, vertex.y);
                    self.canvas.path(
                        &[vertex, end],
                        false,
                        &format!(r#"fill="none" stroke="{GREY}" stroke-width="0.8" stroke-dasharray="3 2""#),
                    );
                    let arc: Vec<Plane> = (0..=24)
                        .map(|step| {
                            let (sine, cosine) = (angle * f64::from(step) / 24.0).sin_cos();
                            vertex + Plane::new(radius * cosine, -radius * sine)
                        })
                        .collect();
                    arc_with_arrow(&mut self.canvas, &mut self.labels, &arc, false);
                    let (sine, cosine) = (0.5 * angle).sin_cos();
                    let foot = vertex + Plane::new(1.3 * radius * cosine, -1.3 * radius * sine);
                    self.labels
                        .write(&mut self.canvas, &[foot], text, 13.0, r#"font-style="italic""#);
                }
                Note::Dashes { from, to } => {
                    let points = [*from, *to].map(|end| self.frame.point(end));
                    self.canvas.path(
                        &points,
                        false,
                        &format!(r#"fill="none" stroke="{GREY}" stroke-width="1" stroke-dasharray="4 3""#),
                    );
                    self.labels.keep_line(points[0], points[1]);
                }
            }
        }
    }

    fn labels(&mut self) {
        if !self.frame.is_plane() {
            self.axes();
        }
        let size = if self.style.width < 320.0 { 10.0 } else { 12.0 };
        for &(name, joint) in self.scene.outline.points {
            let style = format!(r#"fill="{PATH}""#);
            self.labels
                .write(&mut self.canvas, &[self.joints[joint]], name, size, &style);
        }
        if !self.style.names {
            return;
        }
        for (number, body) in self.scene.outline.bodies.iter().enumerate() {
            let outer = hull(&self.corners(number));
            let mut around = Vec::new();
            for index in 0..outer.len() {
                let (from, to) = (outer[index], outer[(index + 1) % outer.len()]);
                for part in [0.5, 0.35, 0.65, 0.2, 0.8] {
                    around.push(from + (to - from).scale(part));
                }
            }
            self.labels
                .write(&mut self.canvas, &around, body.name, size, r#"font-style="italic""#);
        }
    }

    /// The cross of the axes in a corner.
    fn axes(&mut self) {
        let foot = if self.style.title.is_empty() { 0.0 } else { 16.0 };
        let corner = Plane::new(30.0, self.style.height - foot - 26.0);
        for (axis, name) in [
            (Space::new(1.0, 0.0, 0.0), "x"),
            (Space::new(0.0, 1.0, 0.0), "y"),
            (Space::new(0.0, 0.0, 1.0), "z"),
        ] {
            let direction = self.frame.direction(axis);
            self.canvas.line(corner, corner + direction.scale(14.0), GREY, 0.9);
            let style = format!(r#"fill="{GREY}""#);
            self.canvas.text(
                corner + direction.scale(20.0) + Plane::new(0.0, 3.0),
                9.0,
                "middle",
                &style,
                name,
            );
        }
        self.labels.keep(corner, 20.0);
    }
}

/// The ends of a slide's line: how far its joint comes in the sweep, and the body that guides it.
fn guide(scene: &Scene, number: usize) -> [Space; 2] {
    let slide = &scene.outline.slides[number];
    let direction = scene.directions[number];
    let along = direction.scale(1.0 / direction.norm());
    let joint = scene.joints[slide.joint];
    let origin = match slide
        .guide
        .and_then(|body| scene.outline.bodies.get(body)?.joints.first())
    {
        Some(&first) => scene.joints[first],
        None => joint,
    };
    let here = (joint - origin).dot(along);
    // the line goes through the joint, which need not be the body's first joint
    scene.travel(number).map(|travel| joint + along.scale(travel - here))
}

/// Short lines on one side of a line.
fn hatch(canvas: &mut Canvas, from: Plane, to: Plane, below: Plane) {
    let length = (to - from).norm();
    let along = unit(to - from);
    let count = (length / 5.0).floor().max(1.0);
    let mut step = 0.5;
    while step < count + 0.1 {
        let start = from + along.scale(length * step / count);
        if step < count {
            canvas.line(start, start + below.scale(4.5) - along.scale(4.0), GREY, 0.8);
        }
        step += 1.0;
    }
}

/// A plate of space, through which other bodies are seen.
fn pane(canvas: &mut Canvas, corners: &[Plane], fill: &str) {
    let style =
        format!(r#"fill="{fill}" fill-opacity="0.6" stroke="{INK}" stroke-width="1.4" stroke-linejoin="round""#);
    canvas.path(corners, true, &style);
}

/// A bar between two points, or a plate around several.
fn bar(canvas: &mut Canvas, corners: &[Plane], width: f64, fill: &str) {
    let mut style = String::new();
    let closed = corners.len() > 2;
    for (colour, width) in [(INK, width + 2.4), (fill, width)] {
        style.clear();
        let inside = if closed { colour } else { "none" };
        // a String never refuses what is written to it
        let _ = write!(
            style,
            "fill=\"{inside}\" stroke=\"{colour}\" stroke-width=\"{width:.1}\" \
             stroke-linecap=\"round\" stroke-linejoin=\"round\""
        );
        canvas.path(corners, closed, &style);
    }
}

fn arc_with_arrow(canvas: &mut Canvas, labels: &mut Labels, arc: &[Plane], is_drive: bool) {
    let colour = if is_drive { DRIVE } else { GREY };
    let width = if is_drive { 1.4 } else { 0.9 };
    let style = format!(r#"fill="none" stroke="{colour}" stroke-width="{width}" stroke-linecap="round""#);
    canvas.path(arc, false, &style);
    if let [.., before, tip] = arc {
        let overshoot = *tip + unit(*tip - *before).scale(3.0);
        canvas.arrow_head(overshoot, *before, colour);
        labels.keep(*tip, 4.0);
    }
    for pair in arc.windows(2) {
        labels.keep_line(pair[0], pair[1]);
    }
}

/// The corners of the smallest convex polygon around some points; two if all lie on one line.
fn hull(points: &[Plane]) -> Vec<Plane> {
    let mut sorted: Vec<Plane> = points.to_vec();
    sorted.sort_by(|one, other| one.x.total_cmp(&other.x).then(one.y.total_cmp(&other.y)));
    let chain = |points: &mut dyn Iterator<Item = Plane>| {
        let mut chain: Vec<Plane> = Vec::new();
        for point in points {
            while let [.., before, last] = chain.as_slice() {
                // less than a pixel beside the line is on it
                if (*last - *before).cross(point - *last) > 0.5 * (point - *before).norm() {
                    break;
                }
                chain.pop();
            }
            if chain.last().is_none_or(|last| (point - *last).norm() > 0.5) {
                chain.push(point);
            }
        }
        chain
    };
    let mut lower = chain(&mut sorted.iter().copied());
    let mut upper = chain(&mut sorted.iter().rev().copied());
    lower.pop();
    upper.pop();
    lower.extend(upper);
    lower
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hulls_are_convex() {
        let point = |x: f64, y: f64| Plane::new(x, y);
        let square = [
            point(0.0, 0.0),
            point(9.0, 9.0),
            point(9.0, 0.0),
            point(4.0, 5.0),
            point(0.0, 9.0),
        ];
        assert_eq!(hull(&square).len(), 4);
        let line = [point(0.0, 0.0), point(9.0, 9.0), point(4.0, 4.0)];
        assert_eq!(hull(&line), [point(0.0, 0.0), point(9.0, 9.0)]);
    }
}
