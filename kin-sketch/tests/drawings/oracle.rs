//! The motion of a drawing by another formulation: the place of every body, and a condition for every joint. No loop is
//! looked for, and no link is measured.

use kin_sketch::{Body, Drive, Sketch};
use nalgebra::{DMatrix, DVector};

/// How far every body has moved from where it is drawn.
pub(crate) struct Moved<'s> {
    sketch: &'s Sketch,
    /// x, y and the angle for each link.
    places: DVector<f64>,
}

impl Moved<'_> {
    /// The angle through which a body has turned.
    pub(crate) fn turned(&self, body: Body) -> f64 {
        match body {
            Body::Ground => 0.0,
            Body::Link(link) => self.places[3 * link + 2],
        }
    }

    /// Where a point that is fixed to a body has gone.
    pub(crate) fn carried(&self, body: Body, [x, y]: [f64; 2]) -> [f64; 2] {
        let Body::Link(link) = body else { return [x, y] };
        let (sine, cosine) = self.turned(body).sin_cos();
        [
            self.places[3 * link] + x * cosine - y * sine,
            self.places[3 * link + 1] + x * sine + y * cosine,
        ]
    }

    /// How far a point has moved along its slide.
    pub(crate) fn slid(&self, slide: usize) -> f64 {
        let (along, _) = self.on_line(slide);
        along
    }

    fn bodies_of(&self, point: usize) -> Vec<Body> {
        let links = self
            .sketch
            .links
            .iter()
            .enumerate()
            .filter(|(_, link)| link.points.contains(&point));
        let links = links.map(|(link, _)| Body::Link(link));
        let ground = self.sketch.ground.contains(&point).then_some(Body::Ground);
        ground.into_iter().chain(links).collect()
    }

    pub(crate) fn point(&self, point: usize) -> [f64; 2] {
        let drawn = &self.sketch.points[point];
        self.carried(self.bodies_of(point)[0], [drawn.x, drawn.y])
    }

    /// The distance of a sliding point from where it was on its line, along and beside the line.
    fn on_line(&self, slide: usize) -> (f64, f64) {
        let drawn = &self.sketch.slides[slide];
        let start = &self.sketch.points[drawn.point];
        let ([x, y], [from_x, from_y]) = (self.point(drawn.point), self.carried(drawn.on, [start.x, start.y]));
        let (sine, cosine) = (drawn.direction + self.turned(drawn.on)).sin_cos();
        let (x, y) = (x - from_x, y - from_y);
        (x * cosine + y * sine, y * cosine - x * sine)
    }

    fn residuals(&self, drives: &[f64]) -> Vec<f64> {
        let mut residuals = Vec::new();
        for (point, drawn) in self.sketch.points.iter().enumerate() {
            let bodies = self.bodies_of(point);
            let places: Vec<[f64; 2]> = bodies
                .iter()
                .map(|body| self.carried(*body, [drawn.x, drawn.y]))
                .collect();
            for place in places.iter().skip(1) {
                residuals.extend([place[0] - places[0][0], place[1] - places[0][1]]);
            }
        }
        for (number, slide) in self.sketch.slides.iter().enumerate() {
            residuals.push(self.on_line(number).1);
            if let Some(guided) = slide.guided {
                residuals.push(self.turned(Body::Link(guided)) - self.turned(slide.on));
            }
        }
        for (drive, value) in self.sketch.drives.iter().zip(drives) {
            residuals.push(match *drive {
                Drive::Angle { of, to } => self.turned(Body::Link(of)) - self.turned(to) - value,
                Drive::Slide(slide) => self.slid(slide) - value,
            });
        }
        residuals
    }
}

/// The number of steps in which drives are moved.
const STEPS: u32 = 4;

/// Moves every drive by its value from the drawing, in steps; `None` if the drawing does not close there.
pub(crate) fn moved<'s>(sketch: &'s Sketch, drives: &[f64]) -> Option<Moved<'s>> {
    let mut moved = Moved {
        sketch,
        places: DVector::zeros(3 * sketch.links.len()),
    };
    for step in 1..=STEPS {
        let values: Vec<f64> = drives
            .iter()
            .map(|drive| drive * f64::from(step) / f64::from(STEPS))
            .collect();
        for _ in 0..12 {
            let residuals = moved.residuals(&values);
            if residuals.iter().all(|residual| residual.abs() < 1e-12) {
                break;
            }
            let mut jacobian = DMatrix::zeros(residuals.len(), moved.places.len());
            for column in 0..moved.places.len() {
                const H: f64 = 1e-6;
                let middle = moved.places[column];
                let mut at = |value: f64| {
                    moved.places[column] = value;
                    DVector::from_vec(moved.residuals(&values))
                };
                let difference = (at(middle + H) - at(middle - H)) / (2.0 * H);
                moved.places[column] = middle;
                jacobian.set_column(column, &difference);
            }
            let step = jacobian
                .svd(true, true)
                .solve(&DVector::from_vec(residuals), 1e-9)
                .ok()?;
            moved.places -= step;
        }
        if moved
            .residuals(&values)
            .iter()
            .any(|residual| residual.is_nan() || residual.abs() >= 1e-9)
        {
            return None;
        }
    }
    Some(moved)
}
