//! What joins the bodies: pins and slides; in space, balls, hinges and slides.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::Write as _;

use super::frames::JointAxis;
use super::rolling::Mesh;
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
    /// The joint of the picture, none for a contact.
    pub(super) joint: Option<usize>,
    /// The slide, none for a pin.
    pub(super) slide: Option<usize>,
    /// The axis of a hinge of space, none for a ball.
    pub(super) hinge: Option<JointAxis>,
    /// The contact of two bodies that roll on each other.
    pub(super) mesh: Option<Mesh>,
}

impl Connection {
    /// Whether it holds a body.
    pub(super) fn holds(&self, body: usize) -> bool {
        [self.on, self.by].contains(&Some(body))
    }

    /// Whether it is a pin or a ball, which has no moment.
    pub(super) fn is_pin(&self) -> bool {
        self.slide.is_none() && self.hinge.is_none() && self.mesh.is_none()
    }

    /// The axis of a hinge, or the line of a slide.
    pub(super) fn axis(&self) -> Option<JointAxis> {
        self.hinge.or_else(|| self.slide.map(JointAxis::Slide))
    }
}

/// The joints of space that have no axis.
pub(super) fn balls(connections: &[Connection]) -> Vec<String> {
    let balls = connections.iter().filter(|own| own.axis().is_none());
    balls.map(|own| own.name.clone()).collect()
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

/// Two bodies that are joined at a joint, and the second joint that they share, which only counts in space.
struct Pair {
    on: Member,
    by: Member,
    second: Option<usize>,
}

/// The bodies that a joint of the plane pins to its hub.
fn pinned(outline: &Outline<'_>, joint: usize, hub: Member) -> Vec<Pair> {
    let others = holders(outline, joint).into_iter().filter(|member| *member != hub);
    let pair = |on| Pair {
        on,
        by: hub,
        second: None,
    };
    others.map(pair).collect()
}

/// The bodies that a joint of space joins. Two that share a second joint, too, turn about the line through both: theirs
/// is a hinge at the first of these joints. What no hinge joins at the joint, a ball joins to the hub.
fn joined(outline: &Outline<'_>, joint: usize, hub: Member, joints: &[usize]) -> Vec<Pair> {
    let members = holders(outline, joint);
    // the members that are joined here have one number
    let mut group: Vec<usize> = (0..members.len()).collect();
    let mut pairs = Vec::new();
    for (first, by) in members.iter().enumerate() {
        for (second, on) in members.iter().enumerate().skip(first + 1) {
            let is_shared = |other: &&usize| {
                let holders = holders(outline, **other);
                **other != joint && holders.contains(by) && holders.contains(on)
            };
            let Some(shared) = joints.iter().find(is_shared) else {
                continue;
            };
            let [old, new] = [group[second], group[first]];
            for own in &mut group {
                if *own == old {
                    *own = new;
                }
            }
            if joint < *shared {
                pairs.push(Pair {
                    on: *on,
                    by: *by,
                    second: Some(*shared),
                });
            }
        }
    }
    let hub_place = members.iter().position(|member| *member == hub).unwrap_or(0);
    let mut known = [group[hub_place]].to_vec();
    for (on, group) in members.iter().zip(&group) {
        if !known.contains(group) {
            known.push(*group);
            pairs.push(Pair {
                on: *on,
                by: hub,
                second: None,
            });
        }
    }
    pairs
}

/// All pins and slides of an outline.
pub(super) fn connections(outline: &Outline<'_>, is_space: bool) -> Vec<Connection> {
    let held = outline.bodies.iter().flat_map(|body| body.joints);
    let mut joints: Vec<usize> = held
        .copied()
        .chain(outline.slides.iter().map(|slide| slide.joint))
        .collect();
    joints.sort_unstable();
    joints.dedup();
    let name_of = |joint: usize| {
        let mut points = outline.points.iter();
        points.find(|(_, own)| *own == joint).map(|(name, _)| *name)
    };
    let mut all: Vec<Connection> = Vec::new();
    for &joint in &joints {
        let Some(hub) = hub(outline, joint) else { continue };
        let point = name_of(joint);
        let pairs = if is_space {
            joined(outline, joint, hub, &joints)
        } else {
            pinned(outline, joint, hub)
        };
        for &Pair { on, by, second } in &pairs {
            let name = match (point, second.and_then(name_of)) {
                (Some(point), _) if pairs.len() == 1 => point.to_string(),
                (None, Some(point)) => point.to_string(),
                (point, _) => {
                    let mut name = point.map_or_else(|| member_name(outline, by), ToString::to_string);
                    // a String never refuses what is written to it
                    let _ = write!(name, "_{}", member_name(outline, on));
                    name
                }
            };
            let (slide, mesh) = (None, None);
            let hinge = second.map(|second| JointAxis::Joints([joint, second]));
            add(
                &mut all,
                Connection {
                    name,
                    on,
                    by,
                    joint: Some(joint),
                    slide,
                    hinge,
                    mesh,
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
            if !pairs.is_empty() {
                name.push_str("_slide");
            }
            let slide = Some(index);
            let (hinge, mesh) = (None, None);
            add(
                &mut all,
                Connection {
                    name,
                    on,
                    by,
                    joint: Some(joint),
                    slide,
                    hinge,
                    mesh,
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
