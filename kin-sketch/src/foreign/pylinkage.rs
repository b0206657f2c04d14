//! pylinkage 1.3: a mechanism as JSON, with `joints` and `links` that name them.
//!
//! The format is that of `pylinkage/mechanism/serialization.py` in version 1.3.0. Its solver keeps the distances of all
//! joints of a link as they are drawn, so a link is a rigid body through its joints.

use serde_json::Value;

use super::draft::{Draft, joint, shortened};
use super::error::ForeignError;
use super::found::{Foreign, ForeignFormat};
use crate::kin_file::DriveMotion;
use crate::sketch::{Body, Drive, PointId};

/// The types of joints that versions before 0.9 wrote.
const OLD_TYPES: [&str; 6] = ["Static", "Crank", "Fixed", "Pivot", "Revolute", "Linear"];

pub(super) fn read(text: &str) -> Result<Foreign, ForeignError> {
    let root: Value = serde_json::from_str(text).map_err(|error| ForeignError::Syntax {
        line: error.line(),
        column: error.column(),
        message: "this is no JSON".to_owned(),
    })?;
    let lists = ["joints", "links"].map(|name| root.get(name).and_then(Value::as_array));
    let [Some(joints), Some(links)] = lists else {
        return Err(without_lists(&root));
    };
    let mut draft = Draft::new(root.get("name").and_then(Value::as_str).unwrap_or_default());
    let held = held(links);
    let mut slides = Vec::new();
    let mut trackers = Vec::new();
    for entry in joints {
        let id = id_of(entry, "a joint")?;
        let name = entry.get("name").and_then(Value::as_str).unwrap_or(id);
        let part = joint(id);
        let kind = entry.get("type").and_then(Value::as_str).unwrap_or("revolute");
        if OLD_TYPES.contains(&kind) {
            return Err(old());
        }
        let point = draft.point(id, name, pair(entry, "position", &part)?)?;
        match kind {
            "ground" => draft.sketch.fix(point),
            _ if held.contains(&id) => draft.sketch.fix(point),
            "revolute" => {}
            "prismatic" => {
                let [x, y] = match entry.get("axis") {
                    None => [1.0, 0.0],
                    Some(_) => pair(entry, "axis", &part)?,
                };
                if x == 0.0 && y == 0.0 {
                    let message = "slides along an axis of no length: give its direction".to_owned();
                    return Err(ForeignError::Entry { part, message });
                }
                slides.push((point, y.atan2(x), entry, part));
            }
            "tracker" => trackers.push((point, entry, part)),
            other => {
                let part = format!("{part} of the type `{}`", shortened(other));
                let advice = "use ground, revolute, prismatic and tracker joints".to_owned();
                return Err(ForeignError::Unsupported { part, advice });
            }
        }
    }
    for (point, direction, entry, part) in slides {
        if entry.get("line_point").is_some() {
            // the solver moves the joint onto the line at its first step
            let [x, y] = pair(entry, "line_point", &part)?;
            let (sine, cosine) = direction.sin_cos();
            let drawn = &mut draft.sketch.points[point];
            let beside = (drawn.y - y) * cosine - (drawn.x - x) * sine;
            let far = (drawn.x - x).hypot(drawn.y - y);
            if beside.abs() > 1e-6 * (1.0 + far) {
                draft
                    .notes
                    .push(format!("{part} stood beside its line and was put onto it"));
            }
            if beside != 0.0 && beside.is_finite() {
                drawn.x += beside * sine;
                drawn.y -= beside * cosine;
            }
        }
        draft.sketch.slide(point, Body::Ground, direction);
    }
    for entry in links {
        link(&mut draft, entry)?;
    }
    for (point, entry, part) in trackers {
        tracker(&mut draft, point, entry, &part)?;
    }
    Ok(draft.done(ForeignFormat::Pylinkage, None))
}

/// A link, and its motor if it has one.
fn link(draft: &mut Draft, entry: &Value) -> Result<(), ForeignError> {
    let id = id_of(entry, "a link")?;
    let name = entry.get("name").and_then(Value::as_str).unwrap_or(id);
    let part = format!("the link `{}`", shortened(id));
    let ids = entry
        .get("joints")
        .and_then(Value::as_array)
        .ok_or_else(|| ForeignError::Entry {
            part: part.clone(),
            message: "has no list of joints: write `\"joints\": [..]`".to_owned(),
        })?;
    let mut points: Vec<PointId> = Vec::new();
    for id in ids {
        points.push(draft.find(id.as_str().unwrap_or_default(), &part)?);
    }
    let kind = entry.get("type").and_then(Value::as_str).unwrap_or("link");
    match kind {
        "ground" => {
            for point in points {
                draft.sketch.fix(point);
            }
            return Ok(());
        }
        "link" | "driver" | "arc_driver" => {}
        other => {
            let part = format!("{part} of the type `{}`", shortened(other));
            let advice = "use link, driver, arc_driver and ground".to_owned();
            return Err(ForeignError::Unsupported { part, advice });
        }
    }
    if points.len() < 2 {
        draft
            .notes
            .push(format!("{part} has fewer than two joints and was left out"));
        return Ok(());
    }
    // the motor comes first, so that the angle of the link is that of the crank
    if let Some(motor) = entry.get("motor_joint").and_then(Value::as_str) {
        let motor = draft.find(motor, &part)?;
        if let Some(place) = points.iter().position(|point| *point == motor) {
            points.swap(0, place);
        }
    }
    let body = draft.link(name, &points)?;
    let Body::Link(of) = body else { return Ok(()) };
    if kind == "link" {
        return Ok(());
    }
    let step = number(entry, "angular_velocity", &part)?.unwrap_or(std::f64::consts::TAU / 360.0);
    draft.notes.push(format!(
        "{part} turns by {}° at each step: pylinkage has no seconds, so the motion has no speed",
        (step.to_degrees() * 1e6).round() / 1e6
    ));
    let drawn = draft.direction(points[0], points[1]);
    let range = match (
        kind,
        number(entry, "arc_start", &part)?,
        number(entry, "arc_end", &part)?,
    ) {
        ("arc_driver", Some(from), Some(to)) => Some([from - drawn, to - drawn]),
        _ if step < 0.0 => Some([0.0, -std::f64::consts::TAU]),
        _ => None,
    };
    let to = Body::Ground;
    draft.drive(Drive::Angle { of, to }, DriveMotion { range, speed: None });
    Ok(())
}

/// A point that keeps its distances to two others: one of the body that has both.
fn tracker(draft: &mut Draft, point: PointId, entry: &Value, part: &str) -> Result<(), ForeignError> {
    let ids =
        ["ref_joint1_id", "ref_joint2_id"].map(|name| entry.get(name).and_then(Value::as_str).unwrap_or_default());
    if ids.contains(&"") {
        draft
            .notes
            .push(format!("{part} follows nothing and was left out of all links"));
        draft.sketch.fix(point);
        return Ok(());
    }
    let [from, to] = [draft.find(ids[0], part)?, draft.find(ids[1], part)?];
    let wanted = [number(entry, "distance", part)?, number(entry, "angle", part)?];
    if let [Some(distance), Some(angle)] = wanted {
        let direction = draft.direction(from, to) + angle;
        let [x, y] = draft.sketch.at(from);
        let drawn = &mut draft.sketch.points[point];
        (drawn.x, drawn.y) = (x + distance * direction.cos(), y + distance * direction.sin());
    }
    let both = |points: &[PointId]| points.contains(&from) && points.contains(&to);
    if let Some(link) = draft.sketch.links.iter_mut().find(|link| both(&link.points)) {
        if !link.points.contains(&point) {
            link.points.push(point);
        }
    } else if both(&draft.sketch.ground) {
        draft.sketch.fix(point);
    } else {
        return Err(ForeignError::Unsupported {
            part: format!("{part}, which follows joints of different links,"),
            advice: "let it follow two joints of one link".to_owned(),
        });
    }
    Ok(())
}

/// The joints that a motor or the ground holds, whatever their types say: pylinkage fixes them when it reads the file.
fn held(links: &[Value]) -> Vec<&str> {
    let mut held = Vec::new();
    for link in links {
        match link.get("type").and_then(Value::as_str) {
            Some("driver" | "arc_driver") => held.extend(link.get("motor_joint").and_then(Value::as_str)),
            Some("ground") => {
                let joints = link.get("joints").and_then(Value::as_array).into_iter().flatten();
                held.extend(joints.filter_map(Value::as_str));
            }
            _ => {}
        }
    }
    held
}

fn without_lists(root: &Value) -> ForeignError {
    if root.get("nodes").is_some() {
        return ForeignError::Version(
            "this JSON of pylinkage holds a topology without dimensions: save a mechanism with \
             `pylinkage.mechanism.mechanism_to_json`"
                .to_owned(),
        );
    }
    let is_old = |entry: &Value| {
        entry
            .get("type")
            .and_then(Value::as_str)
            .is_some_and(|kind| OLD_TYPES.contains(&kind))
    };
    if root
        .get("joints")
        .and_then(Value::as_array)
        .is_some_and(|joints| joints.iter().any(is_old))
    {
        return old();
    }
    ForeignError::Entry {
        part: "the file".to_owned(),
        message: "has no lists `joints` and `links`, which JSON of pylinkage has".to_owned(),
    }
}

fn old() -> ForeignError {
    ForeignError::Version(
        "an old pylinkage wrote this file: load it there and save it with `mechanism_to_json` of version 1.3"
            .to_owned(),
    )
}

fn id_of<'v>(entry: &'v Value, part: &str) -> Result<&'v str, ForeignError> {
    let id = entry.get("id").and_then(Value::as_str).filter(|id| !id.is_empty());
    id.ok_or_else(|| ForeignError::Entry {
        part: part.to_owned(),
        message: "has no `id`: give it one".to_owned(),
    })
}

/// A number that may be absent.
fn number(entry: &Value, name: &str, part: &str) -> Result<Option<f64>, ForeignError> {
    match entry.get(name) {
        None | Some(Value::Null) => Ok(None),
        Some(value) => finite(value, part).map(Some),
    }
}

fn pair(entry: &Value, name: &str, part: &str) -> Result<[f64; 2], ForeignError> {
    match entry.get(name).and_then(Value::as_array).map(Vec::as_slice) {
        Some([x, y]) => Ok([finite(x, part)?, finite(y, part)?]),
        _ => Err(ForeignError::Entry {
            part: part.to_owned(),
            message: format!("has no `{name}` of two numbers: write `\"{name}\": [0.0, 0.0]`"),
        }),
    }
}

fn finite(value: &Value, part: &str) -> Result<f64, ForeignError> {
    value
        .as_f64()
        .filter(|number| number.is_finite())
        .ok_or_else(|| ForeignError::Number {
            part: part.to_owned(),
            number: shortened(&value.to_string()),
        })
}
