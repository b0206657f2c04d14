//! What keeps a drawing from being a mechanism.

use std::error::Error;
use std::fmt;

use crate::sketch::{LinkId, PointId, SlideId};

/// What keeps a drawing from being a mechanism, what to change, and the parts that it is about. `Display` writes the
/// message and the advice.
///
/// ```
/// use kin_sketch::{Body, Drive, Sketch};
///
/// let mut sketch = Sketch::new("Crank");
/// let o = sketch.point("o", 0.0, 0.0);
/// sketch.fix(o);
/// let crank = sketch.link("crank", &[o, o]);
/// sketch.drives.push(Drive::Angle { of: crank, to: Body::Ground });
///
/// let faults = sketch.declaration().unwrap_err();
/// assert_eq!(faults[0].message, "`crank` has the point `o` twice");
/// assert_eq!(faults[0].advice, "remove one of them");
/// assert_eq!((&*faults[0].parts.links, &*faults[0].parts.points), (&[crank][..], &[o][..]));
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct SketchFault {
    /// The kind of the fault, with its numbers.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub kind: SketchFaultKind,
    /// What is wrong.
    pub message: String,
    /// What to change; empty if the message says it.
    pub advice: String,
    /// The parts that are at fault, by their indices.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub parts: SketchParts,
}

/// Parts of a drawing by their indices, each of which is one of the drawing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SketchParts {
    /// Indices of [`Sketch::points`](crate::Sketch::points).
    pub points: Vec<PointId>,
    /// Indices of [`Sketch::links`](crate::Sketch::links).
    pub links: Vec<LinkId>,
    /// Indices of [`Sketch::slides`](crate::Sketch::slides).
    pub slides: Vec<SlideId>,
}

/// The kind of a fault.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SketchFaultKind {
    /// A link, a slide, a drive or the ground names a part that does not exist.
    Missing,
    /// A part cannot have its name.
    Name,
    /// A coordinate or a direction is not finite, or too large to compute with.
    NotFinite,
    /// A part is drawn in a way that means nothing.
    Meaningless,
    /// No joint connects the links with the ground.
    Loose,
    /// The drawing moves in more ways than it has drives. The parts move although all drives stand still.
    NeedsDrives {
        /// The number of ways in which the drawing moves.
        freedom: usize,
        /// The number of drives.
        drives: usize,
    },
    /// The drawing moves in fewer ways than it has drives.
    TooManyDrives {
        /// The number of ways in which the drawing moves.
        freedom: usize,
        /// The number of drives.
        drives: usize,
    },
    /// Some equations repeat others: the drawing moves only because its lengths happen to fit. Each of the links can be
    /// removed without another motion.
    Overconstrained {
        /// The number of equations that follow from the others.
        redundant: usize,
    },
    /// The drives do not determine the motion in the pose that is drawn, a limit position or a change point. The parts
    /// move although all drives stand still.
    DeadPoint,
}

impl SketchFault {
    pub(crate) fn new(kind: SketchFaultKind, message: impl Into<String>, advice: impl Into<String>) -> Self {
        Self {
            kind,
            message: message.into(),
            advice: advice.into(),
            parts: SketchParts::default(),
        }
    }

    pub(crate) fn meaningless(message: impl Into<String>, advice: impl Into<String>) -> Self {
        Self::new(SketchFaultKind::Meaningless, message, advice)
    }

    pub(crate) fn at(self, parts: SketchParts) -> Self {
        Self { parts, ..self }
    }

    pub(crate) fn at_points(mut self, points: &[PointId]) -> Self {
        self.parts.points.extend(points);
        self
    }

    pub(crate) fn at_links(mut self, links: &[LinkId]) -> Self {
        self.parts.links.extend(links);
        self
    }

    pub(crate) fn at_slide(mut self, slide: SlideId) -> Self {
        self.parts.slides.push(slide);
        self
    }
}

impl fmt::Display for SketchFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)?;
        if self.advice.is_empty() {
            return Ok(());
        }
        write!(f, ": {}", self.advice)
    }
}

impl Error for SketchFault {}

/// A number of things in words.
pub(crate) fn counted(count: usize, word: &str) -> String {
    match count {
        0 => format!("no {word}"),
        1 => format!("one {word}"),
        _ => format!("{count} {word}s"),
    }
}

/// Names in a sentence.
pub(crate) fn listed(names: &[String]) -> String {
    match names {
        [] => "the links".to_owned(),
        [one] => one.clone(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}
