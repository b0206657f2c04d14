//! PMKS: text with a line for each joint, which names its links: `ground, crank, R, 0, 0`.
//!
//! The type is `R` for a pin, `P` for a slide that keeps the angle of its links, `RP` for a pin in a slot of the
//! first link. Two coordinates follow, and for slides a direction in degrees. The first joint is the drive. The format
//! is that of the examples of DesignEngrLab/PMKS.

use super::draft::{Draft, shortened};
use super::error::ForeignError;
use super::found::{Foreign, ForeignFormat};
use crate::kin_file::DriveMotion;
use crate::sketch::{Body, Drive, LinkId, PointId};

const TYPES: [&str; 5] = ["R", "P", "RP", "PR", "G"];

/// A line.
struct Row<'t> {
    links: Vec<&'t str>,
    kind: String,
    numbers: Vec<f64>,
    line: usize,
}

/// Whether the text has a line for a joint.
pub(super) fn is_table(text: &str) -> bool {
    text.lines().any(|line| split(line).is_some())
}

pub(super) fn read(text: &str) -> Result<Foreign, ForeignError> {
    let mut rows = Vec::new();
    for (number, line) in text.lines().enumerate() {
        if !line.trim().is_empty() {
            rows.push(row(line, number + 1)?);
        }
    }
    let mut draft = Draft::new("");
    let mut links: Vec<(&str, Vec<PointId>)> = Vec::new();
    let mut points = Vec::new();
    for (number, row) in rows.iter().enumerate() {
        // a joint of a link that lies on another one of the link is the same point
        let same = rows[..number].iter().position(|other| other.is_at(row));
        let point = match same {
            Some(other) => points[other],
            None => draft.point(
                &format!("of line {}", row.line),
                &letters(number),
                [row.numbers[0], row.numbers[1]],
            )?,
        };
        points.push(point);
        // the line of a slide belongs to its first link, and to the ground if that is one of them
        let on_line = usize::from(row.kind != "R");
        for name in row.ordered().into_iter().skip(on_line) {
            if is_ground(name) {
                draft.sketch.fix(point);
                continue;
            }
            match links.iter_mut().find(|(other, _)| other.eq_ignore_ascii_case(name)) {
                Some((_, points)) if points.contains(&point) => {}
                Some((_, points)) => points.push(point),
                None => links.push((name, vec![point])),
            }
        }
        if let (1, Some(carrier)) = (on_line, row.ordered().first().filter(|name| !is_ground(name)))
            && !links.iter().any(|(other, _)| other.eq_ignore_ascii_case(carrier))
        {
            links.push((carrier, Vec::new()));
        }
    }
    let mut bodies = Vec::new();
    for (name, points) in &links {
        bodies.push((*name, draft.link(name, points)?));
    }
    let body = |name: &str| {
        let found = bodies.iter().find(|(other, _)| other.eq_ignore_ascii_case(name));
        found.map_or(Body::Ground, |(_, body)| *body)
    };
    for (number, row) in rows.iter().enumerate() {
        let [first, second, ..] = row.ordered()[..] else {
            continue;
        };
        let (first, second) = (body(first), body(second));
        if row.kind == "R" {
            if number == 0 {
                let drive = driven(first, second, row)?;
                draft.drive(drive, DriveMotion::default());
            }
            continue;
        }
        let direction = row.numbers.get(2).copied().unwrap_or_else(|| {
            draft.notes.push(format!(
                "line {}: the slide has no direction, so it is horizontal",
                row.line
            ));
            0.0
        });
        let slide = draft.sketch.slide(points[number], first, direction.to_radians());
        if row.kind == "P"
            && let Body::Link(link) = second
        {
            draft.sketch.slides[slide].guided = Some(link);
        }
        if number == 0 {
            draft.drive(Drive::Slide(slide), DriveMotion::default());
            let note = "the slide has no stroke in the file: it moves by a tenth of its distance to both sides";
            draft.notes.push(format!("line {}: {note}", row.line));
        }
    }
    if !rows.is_empty() {
        draft
            .notes
            .push(format!("line {}: the first joint is driven, as in PMKS", rows[0].line));
    }
    Ok(draft.done(ForeignFormat::Pmks, None))
}

impl<'t> Row<'t> {
    /// Whether both joints lie on each other, and have a link in common that moves.
    fn is_at(&self, other: &Row<'_>) -> bool {
        let has = |name: &&&str| other.links.iter().any(|link| link.eq_ignore_ascii_case(name));
        let mut shared = self.links.iter().filter(has);
        self.numbers[..2] == other.numbers[..2] && shared.any(|name| !is_ground(name))
    }

    /// The links, that which carries the line of a slide first.
    fn ordered(&self) -> Vec<&'t str> {
        let mut links = self.links.clone();
        if self.kind != "R"
            && let Some(place) = links.iter().position(|name| is_ground(name))
        {
            links.swap(0, place);
        }
        links
    }
}

fn driven(first: Body, second: Body, row: &Row<'_>) -> Result<Drive, ForeignError> {
    let angle = |of: LinkId, to: Body| Ok(Drive::Angle { of, to });
    match (first, second) {
        (Body::Ground, Body::Link(of)) => angle(of, Body::Ground),
        (Body::Link(of), to) => angle(of, to),
        (Body::Ground, Body::Ground) => Err(ForeignError::Entry {
            part: format!("line {}", row.line),
            message: "drives the ground: begin with a joint of a link that moves".to_owned(),
        }),
    }
}

fn row(line: &str, number: usize) -> Result<Row<'_>, ForeignError> {
    let part = format!("line {number}");
    let Some((links, kind, rest)) = split(line) else {
        return Err(ForeignError::Entry {
            part,
            message: "is no joint: write its links, `R`, `P` or `RP`, and two coordinates".to_owned(),
        });
    };
    let numbers: Result<Vec<f64>, _> = rest.iter().take(3).map(|word| finite(word, &part)).collect();
    let numbers = numbers?;
    if numbers.len() < 2 || links.is_empty() {
        return Err(ForeignError::Entry {
            part,
            message: "has too few entries: write links, a type and two coordinates".to_owned(),
        });
    }
    if kind == "G" {
        return Err(ForeignError::Unsupported {
            part: format!("the gear of line {number}"),
            advice: "take it out, and drive one of its links instead".to_owned(),
        });
    }
    if kind != "R" && links.len() != 2 {
        return Err(ForeignError::Entry {
            part,
            message: "is a slide, which joins two links: name both".to_owned(),
        });
    }
    let mut seen = Vec::new();
    for link in &links {
        if seen.iter().any(|other: &&str| other.eq_ignore_ascii_case(link)) {
            return Err(ForeignError::Twice(format!(
                "the link `{}` of line {number}",
                shortened(link)
            )));
        }
        seen.push(*link);
    }
    let kind = if kind == "PR" { "RP".to_owned() } else { kind };
    Ok(Row {
        links,
        kind,
        numbers,
        line: number,
    })
}

/// The links, the type and the rest of a line.
fn split(line: &str) -> Option<(Vec<&str>, String, Vec<&str>)> {
    let words = line
        .split([',', ' ', '\t', ';', '|'])
        .map(str::trim)
        .filter(|word| !word.is_empty());
    let words: Vec<&str> = words.collect();
    // a link may be called like a type, but a number follows the type
    let is_number = |word: Option<&&str>| word.is_some_and(|word| word.parse::<f64>().is_ok());
    let place = (1..words.len()).find(|&place| {
        TYPES.iter().any(|kind| kind.eq_ignore_ascii_case(words[place])) && is_number(words.get(place + 1))
    })?;
    Some((
        words[..place].to_vec(),
        words[place].to_ascii_uppercase(),
        words[place + 1..].to_vec(),
    ))
}

fn is_ground(name: &str) -> bool {
    ["ground", "gnd"].iter().any(|word| word.eq_ignore_ascii_case(name))
}

fn finite(word: &str, part: &str) -> Result<f64, ForeignError> {
    let number = word.parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| ForeignError::Number {
        part: part.to_owned(),
        number: shortened(word),
    })
}

/// `a` to `z`, then `a2` …
fn letters(number: usize) -> String {
    let letter = char::from(b'a' + u8::try_from(number % 26).unwrap_or_default());
    match number / 26 {
        0 => letter.to_string(),
        round => format!("{letter}{}", round + 1),
    }
}
