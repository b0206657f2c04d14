//! A drawing: points, links, slides, drives.

/// The index of a point in [`Sketch::points`].
pub type PointId = usize;
/// The index of a link in [`Sketch::links`].
pub type LinkId = usize;
/// The index of a slide in [`Sketch::slides`].
pub type SlideId = usize;

/// A rigid body of the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(from = "crate::json::BodyJson", into = "crate::json::BodyJson")
)]
pub enum Body {
    /// The body that stands still.
    Ground,
    /// A link, by its index.
    Link(LinkId),
}

/// A point of the drawing: a joint, if several bodies share it.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct SketchPoint {
    /// Its name: an identifier.
    pub name: String,
    /// Its coordinates in the drawing, in any unit of length.
    pub x: f64,
    /// Its coordinates in the drawing, in any unit of length.
    pub y: f64,
}

/// A rigid body that moves.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct SketchLink {
    /// Its name: an identifier, or empty for a link that has a number alone.
    pub name: String,
    /// Its points: pins where another body has the same point.
    pub points: Vec<PointId>,
}

/// A point that slides along a straight line of a body.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct SketchSlide {
    /// The point that slides. It is no point of the body that carries the line.
    pub point: PointId,
    /// The body that carries the line. The line goes through the point as it is drawn.
    pub on: Body,
    /// The direction of the line as it is drawn, in radians from the x axis.
    pub direction: f64,
    /// A link that has the point and keeps its angle to the line: a ram in its guide. Without one, the links turn about
    /// the point: a pin in a slot.
    pub guided: Option<LinkId>,
}

/// A quantity that is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase", deny_unknown_fields))]
pub enum Drive {
    /// The angle of a link, from the x axis or from another link.
    Angle {
        /// The link that is turned.
        of: LinkId,
        /// The body from which the angle counts.
        to: Body,
    },
    /// The distance of a point along its slide.
    Slide(SlideId),
}

/// A drawing of a plane linkage.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Sketch {
    /// The name of the mechanism: an identifier.
    pub name: String,
    /// The points of all bodies.
    pub points: Vec<SketchPoint>,
    /// The points that stand still.
    pub ground: Vec<PointId>,
    /// The bodies that move.
    pub links: Vec<SketchLink>,
    /// The points that slide.
    pub slides: Vec<SketchSlide>,
    /// What is given.
    pub drives: Vec<Drive>,
}

impl Sketch {
    /// An empty drawing.
    #[must_use]
    pub fn new(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            ..Self::default()
        }
    }

    /// Adds a point.
    pub fn point(&mut self, name: &str, x: f64, y: f64) -> PointId {
        self.points.push(SketchPoint {
            name: name.to_owned(),
            x,
            y,
        });
        self.points.len() - 1
    }

    /// Adds a link through points.
    pub fn link(&mut self, name: &str, points: &[PointId]) -> LinkId {
        self.links.push(SketchLink {
            name: name.to_owned(),
            points: points.to_vec(),
        });
        self.links.len() - 1
    }

    /// Makes a point one of the ground.
    pub fn fix(&mut self, point: PointId) {
        if !self.ground.contains(&point) {
            self.ground.push(point);
        }
    }

    /// Lets a point slide along a line of a body, in a direction in radians.
    pub fn slide(&mut self, point: PointId, on: Body, direction: f64) -> SlideId {
        self.slides.push(SketchSlide {
            point,
            on,
            direction,
            guided: None,
        });
        self.slides.len() - 1
    }

    /// All bodies, the ground first.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = Body> + use<> {
        std::iter::once(Body::Ground).chain((0..self.links.len()).map(Body::Link))
    }

    /// The points that are fixed to a body.
    pub(crate) fn points_of(&self, body: Body) -> &[PointId] {
        match body {
            Body::Ground => &self.ground,
            Body::Link(link) => &self.links[link].points,
        }
    }

    /// The coordinates of a point in the drawing.
    pub(crate) fn at(&self, point: PointId) -> [f64; 2] {
        [self.points[point].x, self.points[point].y]
    }

    /// The body from which the angle of a body counts, if it is not its own: another one that guides it, or that its
    /// drive turns it from.
    pub(crate) fn guide(&self, body: Body) -> Option<Body> {
        let Body::Link(link) = body else { return None };
        let slide = self.slides.iter().find(|slide| slide.guided == Some(link))?;
        Some(slide.on)
    }

    /// The drive that turns a link, and the body from which it counts.
    pub(crate) fn driven_from(&self, body: Body) -> Option<Body> {
        self.drives.iter().find_map(|drive| match *drive {
            Drive::Angle { of, to } if Body::Link(of) == body => Some(to),
            _ => None,
        })
    }

    /// Whether the distance of a slide is given.
    pub(crate) fn is_driven(&self, slide: SlideId) -> bool {
        self.drives.contains(&Drive::Slide(slide))
    }

    /// Whether a link carries the line of a slide, or is guided by one.
    pub(crate) fn is_of_slide(&self, link: LinkId) -> bool {
        let mut slides = self.slides.iter();
        slides.any(|slide| slide.on == Body::Link(link) || slide.guided == Some(link))
    }

    /// The word that a link and its quantities share: its name, or the number that the notes give it.
    pub(crate) fn stem(&self, link: LinkId, prefix: &str) -> String {
        match &*self.links[link].name {
            "" => format!("{prefix}{}", link + 2),
            name => name.to_owned(),
        }
    }

    /// The drawing without a link that is of no slide and no drive.
    pub(crate) fn without(&self, link: LinkId) -> Self {
        let moved_up = |other: LinkId| other - usize::from(other > link);
        let body = |body: Body| match body {
            Body::Ground => Body::Ground,
            Body::Link(other) => Body::Link(moved_up(other)),
        };
        let mut rest = self.clone();
        rest.links.remove(link);
        for slide in &mut rest.slides {
            slide.on = body(slide.on);
            slide.guided = slide.guided.map(moved_up);
        }
        for drive in &mut rest.drives {
            if let Drive::Angle { of, to } = drive {
                (*of, *to) = (moved_up(*of), body(*to));
            }
        }
        rest
    }
}
