//! PMKS+: the address that it shares, or what stands behind the `?` of it.
//!
//! Settings, joints, links and forces stand between points, their entries between commas, and the last letter counts
//! the others. Numbers have 64 digits, and coordinates three decimals. The format is that of
//! `src/app/services/transcoding/string-transcoder.ts` of PMKS-Web/PMKSWeb.

use super::draft::{Draft, joint, shortened};
use super::error::ForeignError;
use super::found::{Foreign, ForeignFormat};
use crate::kin_file::DriveMotion;
use crate::sketch::{Body, Drive, LinkId, PointId};

/// The digits of numbers, and the first 62 those of the count at the end.
const DIGITS: &str = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
/// The units of length by their numbers.
const UNITS: [&str; 3] = ["in", "cm", "m"];
/// Flags of a joint.
const SLIDES: u32 = 1;
const IS_INPUT: u32 = 2;
const IS_GROUND: u32 = 4;
const IS_WELDED: u32 = 8;

/// A joint as the address has it.
struct Joint<'t> {
    id: &'t str,
    flags: u32,
    point: PointId,
    angle: f64,
    /// The link that carries the slot, and the joints through which the slot goes.
    slot: Option<[&'t str; 3]>,
}

/// Whether the text is an address, or the part of it behind the `?`.
pub(super) fn is_address(text: &str) -> bool {
    let body = content(text);
    let has_sections = body.contains("..") && body.split('.').count() > 7;
    !text.contains('\n') && (text.contains("://") || has_sections)
}

/// What stands behind the `?`.
fn content(text: &str) -> &str {
    text.split_once('?').map_or(text, |(_, content)| content)
}

pub(super) fn read(text: &str) -> Result<Foreign, ForeignError> {
    let whole = decoded(content(text));
    if whole.contains('=') || whole.contains('&') {
        let message = "an old PMKS+ wrote this address: open it there, and copy the address that it shares now";
        return Err(ForeignError::Version(message.to_owned()));
    }
    let Some(count) = whole
        .chars()
        .next_back()
        .filter(|_| whole.is_ascii() && whole.contains('.'))
    else {
        return Err(cut_off());
    };
    let length = whole.len() - 1;
    if DIGITS.as_bytes()[length % 62] != count as u8 {
        return Err(cut_off());
    }
    let mut parts = whole[..length].split('.');
    let mut setting = || parts.next().ok_or_else(cut_off);
    let [flags, decimals, integers, choices] = [setting()?, setting()?, setting()?, setting()?];
    let [joints, links, forces] =
        [(); 3].map(|()| -> Vec<&str> { parts.by_ref().take_while(|part| !part.is_empty()).collect() });
    let (settings, mut draft) = ("the settings", Draft::new(""));
    let unit = choices.get(..1).map(|choice| digits(choice, settings)).transpose()?;
    let unit = unit.and_then(|unit| UNITS.get(usize::try_from(unit).ok()?).copied());
    // the first flag turns the drive clockwise
    let sense = if digits(flags, settings)? & 1 == 1 { -1.0 } else { 1.0 };
    let turning = integers
        .split(',')
        .next()
        .map(|speed| integer(speed, settings))
        .transpose()?
        .unwrap_or(0.0);
    let sliding = decimals
        .split(',')
        .nth(1)
        .map(|speed| decimal(speed, settings))
        .transpose()?;

    let joints = joints
        .into_iter()
        .map(|text| self::joint_of(&mut draft, text))
        .collect::<Result<Vec<_>, _>>()?;
    let mut bodies: Vec<(&str, Body)> = Vec::new();
    // each block of a slide: its pin, its slot
    let mut blocks: Vec<(&Joint<'_>, &Joint<'_>)> = Vec::new();
    for text in links {
        link(&mut draft, text, &joints, &mut bodies, &mut blocks)?;
    }
    let rotation = DriveMotion {
        range: None,
        speed: Some(sense * turning * std::f64::consts::TAU / 60.0),
    };
    let translation = DriveMotion {
        range: None,
        speed: sliding.map(|speed| sense * speed),
    };
    for (pin, slot) in blocks {
        let (on, direction) = rail(&draft, slot, &joints, &bodies)?;
        let slide = draft.sketch.slide(pin.point, on, direction);
        if pin.flags & IS_WELDED != 0 {
            let links = draft.links_at(pin.point);
            if links.len() > 1 {
                draft.notes.push(format!(
                    "{} welds a block to several links; kin welds it to the first",
                    joint(pin.id)
                ));
            }
            draft.sketch.slides[slide].guided = links.first().copied();
        }
        if slot.flags & IS_INPUT != 0 {
            draft.drive(Drive::Slide(slide), translation);
            draft.notes.push(format!(
                "{} has no stroke in the file: it moves by a tenth of its distance to both sides",
                joint(slot.id)
            ));
        }
    }
    for input in joints
        .iter()
        .filter(|joint| joint.flags & (IS_INPUT | SLIDES) == IS_INPUT)
    {
        let links: Vec<LinkId> = draft.links_at(input.point);
        let is_ground = input.flags & IS_GROUND != 0;
        let drive = match links[..] {
            [of, ..] if is_ground => Drive::Angle { of, to: Body::Ground },
            [to, of, ..] => Drive::Angle { of, to: Body::Link(to) },
            _ => {
                draft.notes.push(format!("{} drives no link", joint(input.id)));
                continue;
            }
        };
        draft.drive(drive, rotation);
    }
    if !forces.is_empty() {
        draft
            .notes
            .push("the forces were left out: write them as `loads { .. }`".to_owned());
    }
    draft.notes.push("masses and colours were left out".to_owned());
    Ok(draft.done(ForeignFormat::PmksPlus, unit))
}

fn joint_of<'t>(draft: &mut Draft, text: &'t str) -> Result<Joint<'t>, ForeignError> {
    let fields: Vec<&str> = text.split(',').collect();
    let first = fields[0]
        .char_indices()
        .nth(1)
        .map(|(start, _)| fields[0].split_at(start));
    let (Some((flags, id)), [_, name, x, y, angle, slot @ ..]) = (first, &fields[..]) else {
        return Err(ForeignError::Entry {
            part: format!("the joint `{}`", shortened(text)),
            message: "lacks entries: copy the whole address".to_owned(),
        });
    };
    let part = joint(id);
    let flags = digits(flags, &part)?;
    let point = draft.point(
        id,
        if name.is_empty() { id } else { name },
        [decimal(x, &part)?, decimal(y, &part)?],
    )?;
    if flags & u64::from(IS_GROUND | SLIDES) == u64::from(IS_GROUND) {
        draft.sketch.fix(point);
    }
    Ok(Joint {
        id,
        flags: u32::try_from(flags).unwrap_or_default(),
        point,
        angle: angle_of(decimal(angle, &part)?),
        slot: match slot {
            [carrier, from, to] if !carrier.is_empty() => Some([carrier, from, to]),
            _ => None,
        },
    })
}

/// A link, or the block of a slide.
fn link<'j, 't>(
    draft: &mut Draft,
    text: &'t str,
    joints: &'j [Joint<'t>],
    bodies: &mut Vec<(&'t str, Body)>,
    blocks: &mut Vec<(&'j Joint<'t>, &'j Joint<'t>)>,
) -> Result<(), ForeignError> {
    let fields: Vec<&str> = text.split(',').collect();
    let (Some(id), [_, name, _, _, _, _, _, rest @ ..]) = (fields[0].get(2..), &fields[..]) else {
        return Err(ForeignError::Entry {
            part: format!("the link `{}`", shortened(text)),
            message: "lacks entries: copy the whole address".to_owned(),
        });
    };
    // links that were welded into another one
    if fields[0].starts_with('N') {
        return Ok(());
    }
    let part = format!("the link `{}`", shortened(id));
    let ids = rest.iter().take_while(|id| !id.is_empty());
    let of_link = ids.map(|id| find(joints, id, &part)).collect::<Result<Vec<_>, _>>()?;
    if bodies.iter().any(|(other, _)| *other == id) {
        return Err(ForeignError::Twice(part));
    }
    if fields[0][1..].starts_with('P') {
        let slides = |joint: &&&Joint<'_>| joint.flags & SLIDES != 0;
        let (slot, pin) = (of_link.iter().find(slides), of_link.iter().find(|joint| !slides(joint)));
        let [Some(slot), Some(pin)] = [slot, pin] else {
            let message = "is a block without a pin or a slot: draw it again".to_owned();
            return Err(ForeignError::Entry { part, message });
        };
        blocks.push((pin, slot));
        return Ok(());
    }
    let points: Vec<PointId> = of_link.iter().map(|joint| joint.point).collect();
    if points.is_empty() {
        draft.notes.push(format!("{part} has no joints and was left out"));
        return Ok(());
    }
    // a name that only lists the joints says less than a number
    let name = if *name == id { "" } else { name };
    bodies.push((id, draft.link(name, &points)?));
    Ok(())
}

/// The body that carries a slot, and the direction of the slot.
fn rail(
    draft: &Draft,
    slot: &Joint<'_>,
    joints: &[Joint<'_>],
    bodies: &[(&str, Body)],
) -> Result<(Body, f64), ForeignError> {
    let Some([carrier, from, to]) = slot.slot else {
        return Ok((Body::Ground, slot.angle));
    };
    let part = joint(slot.id);
    let body = bodies
        .iter()
        .find(|(id, _)| *id == carrier)
        .ok_or_else(|| ForeignError::Missing {
            part: part.clone(),
            missing: format!("the link `{}`", shortened(carrier)),
        })?;
    let [from, to] = [find(joints, from, &part)?, find(joints, to, &part)?];
    Ok((body.1, draft.direction(from.point, to.point)))
}

fn find<'j, 't>(joints: &'j [Joint<'t>], id: &str, part: &str) -> Result<&'j Joint<'t>, ForeignError> {
    joints
        .iter()
        .find(|joint| joint.id == id)
        .ok_or_else(|| ForeignError::Missing {
            part: part.to_owned(),
            missing: joint(id),
        })
}

fn cut_off() -> ForeignError {
    ForeignError::Syntax {
        line: 1,
        column: 1,
        message: "the count at the end of the address is wrong".to_owned(),
    }
}

/// `%2C` as `,`. Whatever else stands behind a `%` stays.
fn decoded(text: &str) -> String {
    let mut pieces = text.split('%');
    let mut decoded = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let code = piece
            .get(..2)
            .and_then(|digits| u8::from_str_radix(digits, 16).ok())
            .filter(u8::is_ascii);
        if let Some(code) = code {
            decoded.push(char::from(code));
            decoded.push_str(&piece[2..]);
        } else {
            decoded.push('%');
            decoded.push_str(piece);
        }
    }
    decoded
}

/// An angle of three decimals. If it is that of a whole degree, the degree was meant.
fn angle_of(rounded: f64) -> f64 {
    let degree = rounded.to_degrees().round().to_radians();
    if (degree - rounded).abs() <= 0.000_5 {
        degree
    } else {
        rounded
    }
}

/// A whole number without a sign.
fn digits(text: &str, part: &str) -> Result<u64, ForeignError> {
    let value = text.chars().try_fold(0_u64, |value, digit| {
        value.checked_mul(64)?.checked_add(DIGITS.find(digit)? as u64)
    });
    value.ok_or_else(|| ForeignError::Number {
        part: part.to_owned(),
        number: shortened(text),
    })
}

/// A whole number, negative behind a `0`.
#[expect(clippy::cast_precision_loss, reason = "numbers of a drawing are small")]
fn integer(text: &str, part: &str) -> Result<f64, ForeignError> {
    Ok(match text.strip_prefix('0') {
        Some("") => 0.0,
        Some(rest) => -(digits(rest, part)? as f64),
        None => digits(text, part)? as f64,
    })
}

fn decimal(text: &str, part: &str) -> Result<f64, ForeignError> {
    Ok(integer(text, part)? / 1000.0)
}
