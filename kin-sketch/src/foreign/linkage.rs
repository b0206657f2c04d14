//! Linkage 3 by David Rector: `.linkage2`, XML with connectors, and links that name them.
//!
//! The format is that of `CLinkageDoc::ReadIn` and `WriteOut`. The y axis goes up, and 96 units are an inch.

use roxmltree::{Document, Node, ParsingOptions};

use super::draft::{Draft, shortened};
use super::error::ForeignError;
use super::found::{Foreign, ForeignFormat};
use crate::kin_file::DriveMotion;
use crate::sketch::{Body, Drive, PointId};

/// More nodes than any file needs.
const MOST_NODES: u32 = 20_000;
const UNITS_IN_AN_INCH: f64 = 96.0;
const MILLIMETRES_IN_AN_INCH: f64 = 25.4;

pub(super) fn read(text: &str) -> Result<Foreign, ForeignError> {
    let options = ParsingOptions {
        nodes_limit: MOST_NODES,
        ..ParsingOptions::default()
    };
    let document = Document::parse_with_options(text, options).map_err(|error| {
        let place = error.pos();
        ForeignError::Syntax {
            line: place.row as usize,
            column: place.col as usize,
            message: shortened(&error.to_string()),
        }
    })?;
    let root = document.root_element();
    if root.tag_name().name() != "linkage2" {
        return Err(ForeignError::Version(
            "this XML is no file of Linkage 3, whose first element is `linkage2`: save it as `.linkage2`".to_owned(),
        ));
    }
    let children = |name: &'static str| root.children().filter(move |node| node.has_tag_name(name));
    let is_inch = children("program")
        .filter_map(|node| node.attribute("units"))
        .any(|unit| unit.eq_ignore_ascii_case("inches"));
    let (unit, scale) = if is_inch {
        ("in", 1.0 / UNITS_IN_AN_INCH)
    } else {
        ("mm", MILLIMETRES_IN_AN_INCH / UNITS_IN_AN_INCH)
    };
    let mut draft = Draft::new("");
    for node in children("program") {
        let factor = number(node, "scalefactor", "the program")?.unwrap_or(1.0);
        if factor != 1.0 {
            draft
                .notes
                .push(format!("the scale {factor} of the picture was left out"));
        }
    }
    if let Some(node) = children("ratios").find(|node| node.children().any(|node| node.is_element())) {
        return Err(ForeignError::Unsupported {
            part: format!("the gear or chain of line {}", line(node)),
            advice: "remove it in Linkage, and give the second wheel an input of its own".to_owned(),
        });
    }
    for node in children("connector") {
        let id = id(node)?;
        let name = node
            .attribute("name")
            .map_or_else(|| format!("p{id}"), ToOwned::to_owned);
        let part = connector(id);
        let place = |axis| match number(node, axis, &part) {
            Ok(value) => Ok(scale * value.unwrap_or(0.0)),
            Err(error) => Err(error),
        };
        let point = draft.point(id, &name, [place("x")?, place("y")?])?;
        if is_set(node, "anchor") {
            draft.sketch.fix(point);
        }
        for attribute in ["fasten", "fastenlink", "fastenconnector"] {
            if node.has_attribute(attribute) {
                return Err(fastened(&part));
            }
        }
    }
    let links = root
        .children()
        .filter(|node| node.has_tag_name("Link") || node.has_tag_name("element"));
    for node in links {
        link(&mut draft, node, scale)?;
    }
    for node in children("connector") {
        slide(&mut draft, node)?;
    }
    for node in children("connector").filter(|node| is_set(*node, "input")) {
        let id = id(node)?;
        let part = connector(id);
        let turns = number(node, "rpm", &part)?.unwrap_or(0.0);
        // a positive speed turns as the hands of a clock
        let motion = DriveMotion {
            range: None,
            speed: Some(-turns * std::f64::consts::TAU / 60.0),
        };
        let point = draft.find(id, &part)?;
        for of in draft.links_at(point) {
            draft.drive(Drive::Angle { of, to: Body::Ground }, motion);
        }
    }
    Ok(draft.done(ForeignFormat::Linkage, Some(unit)))
}

fn link(draft: &mut Draft, node: Node<'_, '_>, scale: f64) -> Result<(), ForeignError> {
    let part = format!("the link of line {}", line(node));
    for attribute in ["fastenlink", "fastenconnector"] {
        if node.has_attribute(attribute) {
            return Err(fastened(&part));
        }
    }
    if is_set(node, "gear") {
        return Err(ForeignError::Unsupported {
            part: format!("the gear of line {}", line(node)),
            advice: "remove it in Linkage, and give the second wheel an input of its own".to_owned(),
        });
    }
    if is_set(node, "measurementelement") {
        return Ok(());
    }
    let mut points: Vec<PointId> = Vec::new();
    for child in node.children().filter(Node::is_element) {
        if child.has_tag_name("fastenconnector") {
            return Err(fastened(&part));
        }
        if child.has_tag_name("connector") {
            points.push(draft.find(id(child)?, &part)?);
        }
    }
    if is_set(node, "actuator") {
        return actuator(draft, node, &points, scale, &part);
    }
    // a point alone is no body: it is drawn, or it is a text
    if points.len() > 1 {
        draft.link(node.attribute("name").unwrap_or_default(), &points)?;
    }
    Ok(())
}

/// A cylinder: a link with a rail through its first point, along which its second point is driven.
fn actuator(
    draft: &mut Draft,
    node: Node<'_, '_>,
    points: &[PointId],
    scale: f64,
    part: &str,
) -> Result<(), ForeignError> {
    let &[from, to] = points else {
        return Err(ForeignError::Entry {
            part: part.to_owned(),
            message: "is an actuator, which joins two connectors: take the others out".to_owned(),
        });
    };
    let stroke = scale * number(node, "throw", part)?.unwrap_or(0.0);
    let cycles = number(node, "cpm", part)?.unwrap_or(0.0);
    let Body::Link(body) = draft.link(node.attribute("name").unwrap_or_default(), &[from])? else {
        return Ok(());
    };
    let slide = draft.sketch.slide(to, Body::Link(body), draft.direction(from, to));
    let motion = DriveMotion {
        range: (stroke != 0.0).then_some([0.0, stroke]),
        // out and back in each cycle
        speed: Some(2.0 * stroke.abs() * cycles.abs() / 60.0),
    };
    draft.drive(Drive::Slide(slide), motion);
    draft.notes.push(format!(
        "{part}: the actuator moves out once, at the mean speed of its stroke"
    ));
    Ok(())
}

/// A connector that slides between two others.
fn slide(draft: &mut Draft, node: Node<'_, '_>) -> Result<(), ForeignError> {
    if !is_set(node, "slider") {
        return Ok(());
    }
    let id = id(node)?;
    let part = connector(id);
    let point = draft.find(id, &part)?;
    let limits = node.children().filter(|child| child.has_tag_name("slidelimit"));
    let limits: Vec<PointId> = limits
        .map(|limit| draft.find(self::id(limit)?, &part))
        .collect::<Result<_, ForeignError>>()?;
    let &[from, to] = &limits[..] else {
        draft
            .notes
            .push(format!("{part} is called a slider, but has no two limits: it is a pin"));
        return Ok(());
    };
    if number(node, "slideradius", &part)?.unwrap_or(0.0) != 0.0 {
        return Err(ForeignError::Unsupported {
            part: format!("{part}, which slides along an arc,"),
            advice: "replace the arc by a link as long as its radius".to_owned(),
        });
    }
    let is_ground = [from, to].iter().all(|limit| draft.sketch.ground.contains(limit));
    let carrier = draft
        .links_at(from)
        .into_iter()
        .find(|link| draft.sketch.links[*link].points.contains(&to));
    let on = match carrier {
        _ if is_ground => Body::Ground,
        Some(link) => Body::Link(link),
        None => {
            return Err(ForeignError::Unsupported {
                part: format!("{part}, which slides between connectors of two links,"),
                advice: "let it slide between two connectors of one link".to_owned(),
            });
        }
    };
    let direction = draft.direction(from, to);
    draft.sketch.slide(point, on, direction);
    Ok(())
}

fn fastened(part: &str) -> ForeignError {
    ForeignError::Unsupported {
        part: format!("{part}, which is fastened to another one,"),
        advice: "join both into one link in Linkage".to_owned(),
    }
}

fn connector(id: &str) -> String {
    format!("the connector `{}`", shortened(id))
}

fn id<'n>(node: Node<'n, '_>) -> Result<&'n str, ForeignError> {
    node.attribute("id")
        .filter(|id| !id.is_empty())
        .ok_or_else(|| ForeignError::Entry {
            part: format!("the element of line {}", line(node)),
            message: "has no `id`: give it one".to_owned(),
        })
}

fn is_set(node: Node<'_, '_>, name: &str) -> bool {
    node.attribute(name) == Some("true")
}

fn number(node: Node<'_, '_>, name: &str, part: &str) -> Result<Option<f64>, ForeignError> {
    let Some(text) = node.attribute(name).filter(|text| !text.is_empty()) else {
        return Ok(None);
    };
    let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    number.map(Some).ok_or_else(|| ForeignError::Number {
        part: part.to_owned(),
        number: shortened(text),
    })
}

fn line(node: Node<'_, '_>) -> u32 {
    node.document().text_pos_at(node.range().start).row
}
