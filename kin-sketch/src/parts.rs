//! The parts of a drawing, looked at one by one.

use crate::fault::{SketchFault, SketchFaultKind, SketchParts, listed};
use crate::sketch::{Body, Drive, LinkId, PointId, Sketch, SketchPoint, SketchSlide, SlideId};

/// Products of coordinates that are not larger are finite.
const FARTHEST: f64 = 1e100;

impl Sketch {
    /// What a person calls a body.
    pub(crate) fn name_of(&self, body: Body) -> String {
        match body {
            Body::Ground => "the ground".to_owned(),
            Body::Link(link) if self.links[link].name.is_empty() => format!("link {}", link + 2),
            Body::Link(link) => format!("`{}`", self.links[link].name),
        }
    }

    /// What a person calls some links and slides, each name once.
    pub(crate) fn names_of(&self, parts: &SketchParts) -> Vec<String> {
        let links = parts.links.iter().map(|link| self.name_of(Body::Link(*link)));
        let slides = parts.slides.iter().map(|slide| self.slides[*slide].point);
        let mut names: Vec<String> = links.collect();
        for name in slides.map(|point| format!("`{}`", self.points[point].name)) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
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
        let mut faults = Vec::new();
        let mut uses = |of: &str, kind: &str, index: usize, parts: SketchParts| {
            let count = match kind {
                "point" => self.points.len(),
                "link" => self.links.len(),
                _ => self.slides.len(),
            };
            if index >= count {
                let message = format!("{of} has the {kind} {index}, which is not drawn");
                faults.push(SketchFault::new(SketchFaultKind::Missing, message, "").at(parts));
            }
        };
        for body in self.bodies() {
            for point in self.points_of(body) {
                let links = match body {
                    Body::Link(link) => vec![link],
                    Body::Ground => Vec::new(),
                };
                let parts = SketchParts {
                    links,
                    ..SketchParts::default()
                };
                uses(&self.name_of(body), "point", *point, parts);
            }
        }
        for (index, slide) in self.slides.iter().enumerate() {
            let parts = SketchParts {
                slides: vec![index],
                ..SketchParts::default()
            };
            uses("a slide", "point", slide.point, parts.clone());
            if let Body::Link(link) = slide.on {
                uses("a slide", "link", link, parts.clone());
            }
            if let Some(link) = slide.guided {
                uses("a slide", "link", link, parts);
            }
        }
        for drive in &self.drives {
            match *drive {
                Drive::Angle { of, to } => {
                    uses("a drive", "link", of, SketchParts::default());
                    if let Body::Link(link) = to {
                        uses("a drive", "link", link, SketchParts::default());
                    }
                }
                Drive::Slide(slide) => uses("a drive", "slide", slide, SketchParts::default()),
            }
        }
        faults
    }

    fn unfinite(&self, faults: &mut Vec<SketchFault>) {
        for (index, point) in self.points.iter().enumerate() {
            let SketchPoint { name, x, y } = point;
            let far = x.abs().max(y.abs());
            if !(x.is_finite() && y.is_finite()) {
                let message = format!("`{name}` stands at ({x}, {y})");
                faults.push(SketchFault::new(SketchFaultKind::NotFinite, message, "").at_points(&[index]));
            } else if far > FARTHEST {
                let message = format!("`{name}` stands {far:e} away from the origin");
                let fault = SketchFault::new(SketchFaultKind::NotFinite, message, "choose another unit of length");
                faults.push(fault.at_points(&[index]));
            }
        }
        for (index, slide) in self.slides.iter().enumerate() {
            if !slide.direction.is_finite() {
                let name = &self.points[slide.point].name;
                let message = format!("`{name}` slides in the direction {}", slide.direction);
                faults.push(SketchFault::new(SketchFaultKind::NotFinite, message, "").at_slide(index));
            }
        }
    }

    fn links_without_sense(&self, faults: &mut Vec<SketchFault>) {
        for link in 0..self.links.len() {
            let points = &self.links[link].points;
            let name = self.name_of(Body::Link(link));
            if points.is_empty() {
                let fault = SketchFault::meaningless(format!("{name} has no point"), "draw it through a joint");
                faults.push(fault.at_links(&[link]));
            }
            for (index, &p) in points.iter().enumerate() {
                for &q in &points[..index] {
                    let ([px, py], [qx, qy]) = (self.at(p), self.at(q));
                    let (of_p, of_q) = (&self.points[p].name, &self.points[q].name);
                    if p == q {
                        let message = format!("{name} has the point `{of_p}` twice");
                        let fault = SketchFault::meaningless(message, "remove one of them");
                        faults.push(fault.at_links(&[link]).at_points(&[p]));
                    } else if (px - qx).hypot(py - qy) <= self.negligible() {
                        let message = format!("`{of_q}` and `{of_p}` of {name} lie on each other");
                        let fault = SketchFault::meaningless(message, "move one of them");
                        faults.push(fault.at_links(&[link]).at_points(&[q, p]));
                    }
                }
            }
        }
    }

    fn slide_without_sense(&self, slide: SlideId, faults: &mut Vec<SketchFault>) {
        let SketchSlide { point, on, guided, .. } = self.slides[slide];
        let name = &self.points[point].name;
        let mut meaningless = |message: String, advice: &str| {
            faults.push(SketchFault::meaningless(message, advice).at_slide(slide));
        };
        if self.points_of(on).contains(&point) {
            let on = self.name_of(on);
            meaningless(
                format!("`{name}` slides along {on}, of which it is a point"),
                "take it from there",
            );
        }
        if let Body::Link(_) = on
            && self.points_of(on).is_empty()
        {
            meaningless(
                format!("{} carries a slide and has no point", self.name_of(on)),
                "give it one",
            );
        }
        let Some(link) = guided else { return };
        let guided = self.name_of(Body::Link(link));
        if !self.links[link].points.contains(&point) {
            let message = format!("{guided} is guided at `{name}`, which is no point of it");
            meaningless(message, "give it the point");
        }
        if self.slides[..slide].iter().any(|other| other.guided == Some(link)) {
            meaningless(
                format!("{guided} is guided twice"),
                "one of its slides holds its angle already",
            );
        }
    }

    fn drives_without_sense(&self, faults: &mut Vec<SketchFault>) {
        for (index, drive) in self.drives.iter().enumerate() {
            let earlier = &self.drives[..index];
            match *drive {
                Drive::Angle { of, .. } => {
                    let link = Body::Link(of);
                    let name = self.name_of(link);
                    if self.guide(link).is_some() {
                        let message = format!("{name} is guided and cannot be turned");
                        faults.push(SketchFault::meaningless(message, "remove its drive").at_links(&[of]));
                    }
                    if self.links[of].points.len() == 1 && !self.is_of_slide(of) {
                        let message = format!("the drive of {name} moves nothing: {name} has one point");
                        faults.push(SketchFault::meaningless(message, "give it a second point").at_links(&[of]));
                    }
                    let turns_it = |other: &Drive| matches!(other, Drive::Angle { of: other, .. } if *other == of);
                    if earlier.iter().any(turns_it) {
                        let message = format!("{name} is turned by two drives");
                        faults.push(SketchFault::meaningless(message, "remove one of them").at_links(&[of]));
                    }
                }
                Drive::Slide(slide) => {
                    if earlier.contains(drive) {
                        let name = &self.points[self.slides[slide].point].name;
                        let message = format!("`{name}` is moved by two drives");
                        faults.push(SketchFault::meaningless(message, "remove one of them").at_slide(slide));
                    }
                }
            }
        }
        for link in 0..self.links.len() {
            let body = Body::Link(link);
            let mut base = body;
            for _ in 0..=self.links.len() {
                let Some(next) = self.guide(base).or_else(|| self.driven_from(base)) else {
                    break;
                };
                base = next;
                if base == body {
                    let message = format!("the angle of {} counts from itself", self.name_of(body));
                    let fault = SketchFault::meaningless(message, "guide or drive it from another body");
                    faults.push(fault.at_links(&[link]));
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
        let loose: Vec<LinkId> = (0..self.links.len()).filter(|link| !is_held[*link]).collect();
        if !loose.is_empty() {
            let names: Vec<String> = loose.iter().map(|link| self.name_of(Body::Link(*link))).collect();
            let message = format!("no joint connects {} with the ground", listed(&names));
            let advice = "give one of its points to another link, or fix it";
            faults.push(SketchFault::new(SketchFaultKind::Loose, message, advice).at_links(&loose));
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
