//! The statements of a declaration.

use std::fmt::Write;

use crate::declaration::SketchDeclaration;
use crate::names::Names;
use crate::placement::{Placement, Step, StepKind};
use crate::quantities::Quantities;
use crate::sketch::{Body, Drive, PointId, Sketch, SlideId};

/// A declaration that is being written.
struct Statements<'s> {
    sketch: &'s Sketch,
    quantities: Quantities<'s>,
    /// The formula of each point: its name, or 0.
    points: Vec<&'s str>,
    /// Joints and loops.
    loops: String,
    outputs: String,
}

/// Writes the declaration of a drawing that has been placed.
pub(crate) fn declaration(sketch: &Sketch, placement: &Placement, names: Names) -> SketchDeclaration {
    let mut statements = Statements {
        sketch,
        quantities: Quantities::new(sketch, placement, names),
        points: sketch.points.iter().map(|point| &*point.name).collect(),
        loops: String::new(),
        outputs: String::new(),
    };
    let origin = placement.frames[0].origin;
    if let Some(origin) = origin {
        statements.points[origin] = "0";
    }
    statements.drives();
    for step in &placement.steps {
        statements.step(step);
    }
    let picture = statements.picture();
    let Statements {
        quantities,
        loops,
        outputs,
        ..
    } = statements;
    SketchDeclaration {
        text: format!(
            "struct {} {{ {} }}\n{}{loops}{outputs}{picture}",
            sketch.name,
            quantities.fields.join(", "),
            quantities.declared()
        ),
        dimensions: quantities.dimensions,
        inputs: quantities.inputs,
        unknowns: quantities.unknowns,
        origin: origin.map_or([0.0; 2], |origin| sketch.at(origin)),
    }
}

impl Statements<'_> {
    /// Names the inputs in the order of the drives.
    fn drives(&mut self) {
        for drive in &self.sketch.drives {
            match *drive {
                Drive::Angle { of, .. } => {
                    self.quantities.angle(Body::Link(of));
                }
                Drive::Slide(slide) => {
                    self.quantities.distance(slide);
                }
            }
        }
    }

    fn step(&mut self, step: &Step) {
        let Step {
            point,
            body,
            slide,
            kind,
        } = *step;
        let name = &*self.sketch.points[point].name;
        if body == Body::Ground && slide.is_none() && kind == StepKind::Point {
            if let Some(formula) = self.quantities.fixed_point(point) {
                let _ = writeln!(self.loops, "let {name} = {formula};");
            }
            return;
        }
        let vector = match slide {
            Some(slide) => self.quantities.sliding(body, slide),
            None => self.quantities.fixed(body, point),
        };
        let origin = self.quantities.frame(body).origin;
        let through = match origin.map_or("0", |origin| self.points[origin]) {
            "0" => vector.clone(),
            from => format!("{from} + {vector}"),
        };
        let _ = match kind {
            StepKind::Point if self.is_joint(point) => writeln!(self.loops, "let {name} = {through};"),
            StepKind::Point => writeln!(self.outputs, "output {name}: Point = {through};"),
            StepKind::Origin => {
                let origin = self.points[origin.expect("a link has points")];
                writeln!(self.loops, "let {origin} = {} - {vector};", self.points[point])
            }
            StepKind::Closure => match self.points[point] {
                "0" => writeln!(self.loops, "{through} == 0;"),
                point => writeln!(self.loops, "{point} == {through};"),
            },
        };
    }

    /// Whether several bodies have a point.
    fn is_joint(&self, point: PointId) -> bool {
        let sketch = self.sketch;
        let bodies = sketch.bodies().filter(|body| sketch.points_of(*body).contains(&point));
        bodies.count() + sketch.slides.iter().filter(|slide| slide.point == point).count() > 1
    }

    /// The statements of the picture: the ground, the bodies, the slides.
    fn picture(&mut self) -> String {
        let sketch = self.sketch;
        let listed = |points: &[PointId]| -> String {
            let points: Vec<&str> = points.iter().map(|point| self.points[*point]).collect();
            points.join(", ")
        };
        let mut text = match &*listed(&sketch.ground) {
            "" => "ground 0;\n".to_owned(),
            ground => format!("ground {ground};\n"),
        };
        for (link, drawn) in sketch.links.iter().enumerate() {
            if drawn.points.len() > 1 || sketch.is_of_slide(link) {
                let _ = writeln!(text, "body {}: {};", sketch.stem(link, "link"), listed(&drawn.points));
            }
        }
        for (number, slide) in sketch.slides.iter().enumerate() {
            let rail = match slide.on {
                Body::Ground => String::new(),
                Body::Link(link) => format!(" on {}", sketch.stem(link, "link")),
            };
            let along = self.direction(slide.on, number);
            let _ = writeln!(text, "slide {} along {along}{rail};", self.points[slide.point]);
        }
        text
    }

    /// The direction of a slide's line.
    fn direction(&mut self, on: Body, slide: SlideId) -> String {
        if self.quantities.is_upright(on, slide) {
            return match self.quantities.angle(on) {
                Some(angle) => format!("vec2(0, 1) * cis({angle})"),
                None => "vec2(0, 1)".to_owned(),
            };
        }
        match self.quantities.line(on, slide) {
            Some(angle) => format!("cis({angle})"),
            None => "vec2(1, 0)".to_owned(),
        }
    }
}
