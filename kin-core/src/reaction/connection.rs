//! What joins the bodies: pins and slides.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::Write as _;

use crate::picture::{Outline, Slide};

/// A body by its index, `None` for the ground.
pub(super) type Member = Option<usize>;

/// A joint at which two bodies act on each other.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Connection {
    /// The name of its reaction.
    pub(super) name: String,
    /// The body on which the reaction acts.
    pub(super) on: Member,
    /// The body that exerts it.
    pub(super) by: Member,
    /// The joint of the picture.
    pub(super) joint: usize,
    /// The slide, none for a pin.
    pub(super) slide: Option<usize>,
}

/// The name of a body.
pub(super) fn member_name(outline: &Outline<'_>, member: Member) -> String {
    member.map_or("ground", |body| outline.bodies[body].name).to_string()
}

/// The bodies that hold a joint, the ground among them. A body that carries the line on which the joint slides is none
/// of them.
pub(super) fn holders(outline: &Outline<'_>, joint: usize) -> Vec<Member> {
    let carries = |body: usize| {
        let mut slides = outline.slides.iter();
        slides.any(|slide| slide.joint == joint && slide.guide == Some(body))
    };
    let ground = outline.ground.contains(&joint).then_some(None);
    let bodies =
        (0..outline.bodies.len()).filter(|&body| outline.bodies[body].joints.contains(&joint) && !carries(body));
    ground.into_iter().chain(bodies.map(Some)).collect()
}

/// The body that holds a joint for certain: the ground, or the slider itself, which is a body with no other joint.
fn certain(outline: &Outline<'_>, joint: usize, holders: &[Member]) -> Option<Member> {
    let slides = outline.slides.iter().any(|slide| slide.joint == joint);
    let is_slider = |member: &&Member| slides && member.is_some_and(|body| outline.bodies[body].joints.len() == 1);
    let ground = holders.first().filter(|first| first.is_none());
    ground.or_else(|| holders.iter().find(is_slider)).copied()
}

/// The body to which all others of a joint are pinned, and on which a slide acts: the one that holds it for certain, or
/// the first.
pub(super) fn hub(outline: &Outline<'_>, joint: usize) -> Option<Member> {
    let holders = holders(outline, joint);
    certain(outline, joint, &holders).or_else(|| holders.first().copied())
}

/// The bodies on which a load at a joint may act.
pub(super) fn loaded(outline: &Outline<'_>, joint: usize) -> Vec<Member> {
    let holders = holders(outline, joint);
    match certain(outline, joint, &holders) {
        Some(member) => [member].into(),
        None => holders,
    }
}

/// All pins and slides of an outline.
pub(super) fn connections(outline: &Outline<'_>) -> Vec<Connection> {
    let held = outline.bodies.iter().flat_map(|body| body.joints);
    let mut joints: Vec<usize> = held
        .copied()
        .chain(outline.slides.iter().map(|slide| slide.joint))
        .collect();
    joints.sort_unstable();
    joints.dedup();
    let mut all: Vec<Connection> = Vec::new();
    for joint in joints {
        let Some(hub) = hub(outline, joint) else { continue };
        let point = outline
            .points
            .iter()
            .find(|(_, own)| *own == joint)
            .map(|(name, _)| *name);
        let pinned: Vec<Member> = holders(outline, joint)
            .into_iter()
            .filter(|member| *member != hub)
            .collect();
        for &on in &pinned {
            let name = match point {
                Some(point) if pinned.len() == 1 => point.to_string(),
                point => {
                    let mut name = point.map_or_else(|| member_name(outline, hub), ToString::to_string);
                    // a String never refuses what is written to it
                    let _ = write!(name, "_{}", member_name(outline, on));
                    name
                }
            };
            let slide = None;
            add(
                &mut all,
                Connection {
                    name,
                    on,
                    by: hub,
                    joint,
                    slide,
                },
            );
        }
        let slides = outline
            .slides
            .iter()
            .enumerate()
            .filter(|(_, slide)| slide.joint == joint);
        for (index, &Slide { guide, .. }) in slides {
            if hub == guide {
                continue;
            }
            // the ground has no equations, so that the reaction is that on the guide
            let (on, by) = if hub.is_none() { (guide, hub) } else { (hub, guide) };
            let mut name = match point {
                Some(point) => point.to_string(),
                None => member_name(outline, by) + "_" + &member_name(outline, on),
            };
            if !pinned.is_empty() {
                name.push_str("_slide");
            }
            let slide = Some(index);
            add(
                &mut all,
                Connection {
                    name,
                    on,
                    by,
                    joint,
                    slide,
                },
            );
        }
    }
    all
}

/// Adds a connection under a name that no other one has.
fn add(all: &mut Vec<Connection>, mut connection: Connection) {
    let base = connection.name.clone();
    let mut number = 1;
    while all.iter().any(|other| other.name == connection.name) {
        number += 1;
        connection.name.clone_from(&base);
        let _ = write!(connection.name, "_{number}");
    }
    all.push(connection);
}
