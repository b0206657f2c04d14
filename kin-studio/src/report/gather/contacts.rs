//! The pitch curves of gears and racks, for their picture.

use kin_core::any::Outline;
use kin_core::linkage::AnyLinkage;

use crate::forces::{Stated, StatedContact, StatedPitch, StatedPlace, StatedRadius};
use crate::report::model::{Contact, PitchCircle, PitchLine, Place};

/// The pitch curves of all contacts of the plane whose centres the picture has.
pub(super) fn of(stated: &Stated, linkage: &AnyLinkage<'_>, outline: &Outline<'_>) -> Vec<Contact> {
    let contacts = stated.contacts.iter();
    let found = contacts.filter_map(|contact| contact.curves(linkage, outline, stated.metres));
    found.collect()
}

impl StatedContact {
    fn curves(&self, linkage: &AnyLinkage<'_>, outline: &Outline<'_>, metres: f64) -> Option<Contact> {
        let body = |name: &str| outline.bodies.iter().position(|body| body.name == name);
        let circle = |name: &str, (centre, radius): &(StatedPlace, StatedRadius)| {
            Some(PitchCircle {
                body: body(name),
                centre: match centre {
                    StatedPlace::Named(name) => Place::Joint(outline.points.iter().find(|(own, _)| own == name)?.1),
                    StatedPlace::Fixed(at) => Place::Fixed([at.x / metres, at.y / metres]),
                },
                radius: radius.own(linkage, metres),
                dimension: match radius {
                    StatedRadius::Dimension(name) => Some(name.clone()),
                    StatedRadius::Metres(_) => None,
                },
            })
        };
        let [one, other] = &self.bodies;
        match &self.pitch {
            StatedPitch::Gears([first, second]) => Some(Contact {
                circles: vec![circle(one, first)?, circle(other, second)?],
                rack: None,
            }),
            // a rack may be stated first or second, and the gear is the body that holds its centre
            StatedPitch::Rack(gear, along) => {
                let [gear_body, rack_body] = if holds(outline, other, &gear.0) {
                    [other, one]
                } else {
                    [one, other]
                };
                Some(Contact {
                    circles: vec![circle(gear_body, gear)?],
                    rack: match along {
                        StatedPlace::Fixed(along) => Some(PitchLine {
                            body: body(rack_body),
                            along: [along.x, along.y],
                        }),
                        StatedPlace::Named(_) => None,
                    },
                })
            }
        }
    }
}

/// Whether a named centre is a joint of a body.
fn holds(outline: &Outline<'_>, body: &str, centre: &StatedPlace) -> bool {
    let StatedPlace::Named(name) = centre else { return false };
    let joint = outline.points.iter().find(|(own, _)| own == name);
    let body = outline.bodies.iter().find(|own| own.name == body);
    joint
        .zip(body)
        .is_some_and(|((_, joint), body)| body.joints.contains(joint))
}
