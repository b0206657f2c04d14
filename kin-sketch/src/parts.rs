//! The parts of a drawing, looked at one by one.

use crate::fault::SketchFault;
use crate::sketch::{Body, Drive, PointId, Sketch, SketchPoint, SketchSlide, SlideId};

impl Sketch {
    /// What a person calls a body.
    pub(crate) fn name_of(&self, body: Body) -> String {
        match body {
            Body::Ground => "the ground".to_owned(),
            Body::Link(link) if self.links[link].name.is_empty() => format!("link {}", link + 2),
            Body::Link(link) => format!("`{}`", self.links[link].name),
        }
    }

    /// What can be seen of the drawing part by part. If it is empty, every index of the drawing is one of a part.
    pub(crate) fn faults(&self) -> Vec<SketchFault> {
        let mut faults = self.missing();
        if !faults.is_empty() {
            return faults;
        }
        self.unfinite(&mut faults);
        self.links_without_sense(&mut faults);
        for slide in 0..self.slides.len() {
            self.slide_without_sense(slide, &mut faults);
        }
        self.drives_without_sense(&mut faults);
        if faults.is_empty() {
            self.loose(&mut faults);
        }
        faults
    }

    /// Indices that name no part.
    fn missing(&self) -> Vec<SketchFault> {
        let mut uses: Vec<(String, &str, usize)> = Vec::new();
        let of_body = |uses: &mut Vec<_>, of: &str, body: Body| {
            if let Body::Link(link) = body {
                uses.push((of.to_owned(), "link", link));
            }
        };
        for body in self.bodies() {
            uses.extend(
                self.points_of(body)
                    .iter()
                    .map(|point| (self.name_of(body), "point", *point)),
            );
        }
        for slide in &self.slides {
            uses.push(("a slide".to_owned(), "point", slide.point));
            of_body(&mut uses, "a slide", slide.on);
            uses.extend(slide.guided.map(|link| ("a slide".to_owned(), "link", link)));
        }
        for drive in &self.drives {
            match *drive {
                Drive::Angle { of, to } => {
                    uses.push(("a drive".to_owned(), "link", of));
                    of_body(&mut uses, "a drive", to);
                }
                Drive::Slide(slide) => uses.push(("a drive".to_owned(), "slide", slide)),
            }
        }
        let is_missing = |(_, kind, index): &(_, &str, usize)| {
            let count = match *kind {
                "point" => self.points.len(),
                "link" => self.links.len(),
                _ => self.slides.len(),
            };
            *index >= count
        };
        uses.retain(is_missing);
        let message = |(of, kind, index)| format!("{of} has the {kind} {index}, which is not drawn");
        uses.into_iter().map(|one| SketchFault::Missing(message(one))).collect()
    }

    fn unfinite(&self, faults: &mut Vec<SketchFault>) {
        for point in &self.points {
            if !(point.x.is_finite() && point.y.is_finite()) {
                let SketchPoint { name, x, y } = point;
                faults.push(SketchFault::NotFinite(format!("`{name}` stands at ({x}, {y})")));
            }
        }
        for slide in &self.slides {
            if !slide.direction.is_finite() {
                let name = &self.points[slide.point].name;
                faults.push(SketchFault::NotFinite(format!(
                    "`{name}` slides in the direction {}",
                    slide.direction
                )));
            }
        }
    }

    fn links_without_sense(&self, faults: &mut Vec<SketchFault>) {
        let mut meaningless = |message: String| faults.push(SketchFault::Meaningless(message));
        for link in 0..self.links.len() {
            let points = &self.links[link].points;
            let name = self.name_of(Body::Link(link));
            if points.is_empty() {
                meaningless(format!("{name} has no point: draw it through a joint"));
            }
            for (index, &p) in points.iter().enumerate() {
                for &q in &points[..index] {
                    let ([px, py], [qx, qy]) = (self.at(p), self.at(q));
                    let is_same = p == q;
                    let (p, q) = (&self.points[p].name, &self.points[q].name);
                    if is_same {
                        meaningless(format!("{name} has the point `{p}` twice: remove one of them"));
                    } else if (px - qx).hypot(py - qy) <= self.negligible() {
                        meaningless(format!("`{q}` and `{p}` of {name} lie on each other: move one of them"));
                    }
                }
            }
        }
    }

    fn slide_without_sense(&self, slide: SlideId, faults: &mut Vec<SketchFault>) {
        let SketchSlide { point, on, guided, .. } = self.slides[slide];
        let name = &self.points[point].name;
        let mut meaningless = |message: String| faults.push(SketchFault::Meaningless(message));
        if self.points_of(on).contains(&point) {
            meaningless(format!(
                "`{name}` slides along {}, of which it is a point: take it from there",
                self.name_of(on)
            ));
        }
        if let Body::Link(_) = on
            && self.points_of(on).is_empty()
        {
            meaningless(format!(
                "{} carries a slide and has no point: give it one",
                self.name_of(on)
            ));
        }
        let Some(link) = guided else { return };
        let guided = Body::Link(link);
        if !self.points_of(guided).contains(&point) {
            meaningless(format!(
                "{} is guided at `{name}`, which is no point of it: give it the point",
                self.name_of(guided)
            ));
        }
        if self.slides[..slide].iter().any(|other| other.guided == Some(link)) {
            meaningless(format!(
                "{} is guided twice: one of its slides holds its angle already",
                self.name_of(guided)
            ));
        }
    }

    fn drives_without_sense(&self, faults: &mut Vec<SketchFault>) {
        let mut meaningless = |message: String| faults.push(SketchFault::Meaningless(message));
        for (index, drive) in self.drives.iter().enumerate() {
            match *drive {
                Drive::Angle { of, .. } => {
                    let link = Body::Link(of);
                    let name = self.name_of(link);
                    if self.guide(link).is_some() {
                        meaningless(format!("{name} is guided and cannot be turned: remove its drive"));
                    }
                    let is_second = self.drives[..index]
                        .iter()
                        .any(|other| matches!(other, Drive::Angle { of: other, .. } if *other == of));
                    if is_second {
                        meaningless(format!("{name} is turned by two drives: remove one of them"));
                    }
                }
                Drive::Slide(slide) => {
                    if self.drives[..index].contains(drive) {
                        let name = &self.points[self.slides[slide].point].name;
                        meaningless(format!("`{name}` is moved by two drives: remove one of them"));
                    }
                }
            }
        }
        for body in self.bodies() {
            let mut base = body;
            for _ in 0..=self.links.len() {
                let Some(next) = self.guide(base).or_else(|| self.driven_from(base)) else {
                    break;
                };
                base = next;
                if base == body {
                    meaningless(format!(
                        "the angle of {} counts from itself: guide or drive it from another body",
                        self.name_of(body)
                    ));
                    break;
                }
            }
        }
    }

    /// Links that no joint connects with the ground.
    fn loose(&self, faults: &mut Vec<SketchFault>) {
        let mut is_held = vec![false; self.links.len()];
        let mut points: Vec<PointId> = self.ground.clone();
        let on_ground = |slide: &&SketchSlide| slide.on == Body::Ground;
        points.extend(self.slides.iter().filter(on_ground).map(|slide| slide.point));
        let mut next = 0;
        while next < points.len() {
            let point = points[next];
            next += 1;
            let of_point = (0..self.links.len()).filter(|link| self.links[*link].points.contains(&point));
            let of_rails = self.slides.iter().filter(|slide| slide.point == point);
            let rails = of_rails.filter_map(|slide| match slide.on {
                Body::Link(link) => Some(link),
                Body::Ground => None,
            });
            for link in of_point.chain(rails).collect::<Vec<_>>() {
                if !std::mem::replace(&mut is_held[link], true) {
                    points.extend(&self.links[link].points);
                    let slides = self.slides.iter().filter(|slide| slide.on == Body::Link(link));
                    points.extend(slides.map(|slide| slide.point));
                }
            }
        }
        let names = (0..self.links.len()).filter(|link| !is_held[*link]);
        let names: Vec<String> = names.map(|link| self.name_of(Body::Link(link))).collect();
        if !names.is_empty() {
            faults.push(SketchFault::Loose(names));
        }
    }

    /// The length below which coordinates are the same.
    pub(crate) fn negligible(&self) -> f64 {
        1e-9 * self.size()
    }

    /// The largest extent of the drawing.
    pub(crate) fn size(&self) -> f64 {
        let extent = |axis: fn(&SketchPoint) -> f64| {
            let values = self.points.iter().map(axis);
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                (low.min(value), high.max(value))
            });
            (high - low).max(0.0)
        };
        extent(|point| point.x).max(extent(|point| point.y))
    }
}
