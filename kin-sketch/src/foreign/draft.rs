//! A drawing that a reader is making, with the names that the file uses.

use std::collections::BTreeMap;

use super::error::ForeignError;
use super::found::{Foreign, ForeignFormat};
use crate::kin_file::DriveMotion;
use crate::sketch::{Body, Drive, LinkId, PointId, Sketch};

/// More points or links than any drawing has.
const MOST_PARTS: usize = 400;

/// A drawing that grows.
pub(super) struct Draft {
    pub(super) sketch: Sketch,
    pub(super) notes: Vec<String>,
    motions: Vec<DriveMotion>,
    points: BTreeMap<String, PointId>,
    names: Vec<String>,
}

impl Draft {
    /// A drawing with a name like the one wanted.
    pub(super) fn new(wanted: &str) -> Self {
        let words = wanted.split(|letter: char| !letter.is_ascii_alphanumeric());
        let name: String = words.map(capitalised).collect();
        let is_name = name.starts_with(|letter: char| letter.is_ascii_alphabetic());
        let name = if is_name && kin_compiler::name_mistake(&name).is_none() {
            name
        } else {
            "Imported".to_owned()
        };
        Self {
            sketch: Sketch::new(&name),
            notes: Vec::new(),
            motions: Vec::new(),
            points: BTreeMap::new(),
            names: Vec::new(),
        }
    }

    /// Adds the point that the file knows by an identifier, and calls it as much as possible like the name wanted.
    pub(super) fn point(&mut self, id: &str, wanted: &str, [x, y]: [f64; 2]) -> Result<PointId, ForeignError> {
        let part = joint(id);
        for number in [x, y] {
            if !number.is_finite() {
                return Err(ForeignError::Number {
                    part,
                    number: number.to_string(),
                });
            }
        }
        if self.sketch.points.len() == MOST_PARTS {
            return Err(ForeignError::TooLarge(format!(
                "the file has more than {MOST_PARTS} joints"
            )));
        }
        let name = self.name(wanted, "p");
        let point = self.sketch.point(&name, x, y);
        match self.points.insert(id.to_owned(), point) {
            None => Ok(point),
            Some(_) => Err(ForeignError::Twice(part)),
        }
    }

    /// The point that the file knows by an identifier.
    pub(super) fn find(&self, id: &str, part: &str) -> Result<PointId, ForeignError> {
        self.points.get(id).copied().ok_or_else(|| ForeignError::Missing {
            part: part.to_owned(),
            missing: joint(id),
        })
    }

    /// Adds a link, unless it stands still, or is a point alone that nothing needs.
    pub(super) fn link(&mut self, wanted: &str, points: &[PointId]) -> Result<Body, ForeignError> {
        if self.sketch.links.len() == MOST_PARTS {
            return Err(ForeignError::TooLarge(format!(
                "the file has more than {MOST_PARTS} links"
            )));
        }
        let mut points = points.to_vec();
        let mut seen = Vec::new();
        points.retain(|point| {
            !seen.contains(point) && {
                seen.push(*point);
                true
            }
        });
        if points.iter().filter(|point| self.sketch.ground.contains(point)).count() > 1 {
            for point in points {
                self.sketch.fix(point);
            }
            return Ok(Body::Ground);
        }
        let name = if wanted.is_empty() {
            String::new()
        } else {
            self.name(wanted, "link")
        };
        Ok(Body::Link(self.sketch.link(&name, &points)))
    }

    /// Adds a drive.
    pub(super) fn drive(&mut self, drive: Drive, motion: DriveMotion) {
        if !self.sketch.drives.contains(&drive) {
            self.sketch.drives.push(drive);
            self.motions.push(motion);
        }
    }

    /// The links that have a point.
    pub(super) fn links_at(&self, point: PointId) -> Vec<LinkId> {
        let links = 0..self.sketch.links.len();
        links
            .filter(|link| self.sketch.links[*link].points.contains(&point))
            .collect()
    }

    /// The direction from one point to another.
    pub(super) fn direction(&self, from: PointId, to: PointId) -> f64 {
        let ([x, y], [to_x, to_y]) = (self.sketch.at(from), self.sketch.at(to));
        (to_y - y).atan2(to_x - x)
    }

    /// What the drawing has become.
    pub(super) fn done(mut self, format: ForeignFormat, unit: Option<&'static str>) -> Foreign {
        if self.sketch.drives.is_empty() {
            let note = "the file drives nothing: write an input for the link that a motor turns";
            self.notes.push(note.to_owned());
        }
        Foreign {
            format,
            sketch: self.sketch,
            motions: self.motions,
            unit,
            notes: self.notes,
        }
    }

    /// A name like the one wanted that a declaration may have and no other part has.
    fn name(&mut self, wanted: &str, prefix: &str) -> String {
        let mut plain = String::new();
        for letter in wanted.chars().take(40) {
            match letter {
                _ if letter.is_ascii_alphanumeric() => plain.push(letter.to_ascii_lowercase()),
                _ if plain.is_empty() || plain.ends_with('_') => {}
                _ => plain.push('_'),
            }
        }
        let plain = plain.trim_end_matches('_');
        let candidates = [
            plain.to_owned(),
            format!("{prefix}{plain}"),
            format!("{prefix}_{plain}"),
        ];
        let numbered = (2..).map(|number| format!("{prefix}{plain}_{number}"));
        let is_free = |name: &String| !self.names.contains(name) && kin_compiler::name_mistake(name).is_none();
        let name = candidates
            .into_iter()
            .chain(numbered.take(2 * MOST_PARTS))
            .find(is_free);
        // a drawing complains of a name that is taken
        let name = name.unwrap_or_else(|| plain.to_owned());
        self.names.push(name.clone());
        name
    }
}

/// How messages name a joint.
pub(super) fn joint(id: &str) -> String {
    format!("the joint `{}`", shortened(id))
}

/// A text of the file in a message.
pub(super) fn shortened(text: &str) -> String {
    let mut short: String = text.chars().take(40).collect();
    if short.len() < text.len() {
        short.push('…');
    }
    short
}

fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    let first = letters.next().map(|letter| letter.to_ascii_uppercase());
    first.into_iter().chain(letters).collect()
}
