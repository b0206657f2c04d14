//! Forces in joints beside closed forms, virtual work, momentum, differences and published values.

mod agreement;
mod batch;
mod friction;
mod mistakes;
mod prepared;
mod proof;
mod published;
mod rolling;
mod sensitive;
mod space;
mod squeezer;

use agreement::LIFT;

use crate::geometry::Plane;
use crate::linkage::AnyLinkage;
use crate::load::NamedLoads;
use crate::reaction::{Friction, NamedReactions};

crate::mechanism! {
    /// Four-bar linkage with declared bodies and centres.
    pub(super) struct FourBar { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    output base: Point = vec2(0 * r2, 0 * r2);
    output pin: Point = r2 * cis(theta2);
    output knee: Point = r1 + r4 * cis(theta4);
    output pivot: Point = vec2(r1, 0);
    output crank_centre: Point = r2 / 3 * cis(theta2);
    output coupler_centre: Point = r2 * cis(theta2) + polar(r3 / 2, theta3 + 0.25);
    output rocker_centre: Point = r1 + polar(r4 / 2, theta4 - 0.4);
    ground base, pivot;
    body crank: base, pin, crank_centre;
    body coupler: pin, knee, coupler_centre;
    body rocker: pivot, knee, rocker_centre;
}

pub(super) const FOUR_BAR: FourBar = FourBar {
    r1: 0.9,
    r2: 0.3,
    r3: 0.8,
    r4: 0.6,
};

crate::mechanism! {
    /// Slider-crank with a piston of its own: the piston is a body, to which the rod is pinned.
    pub(super) struct Engine { crank: Length, rod: Length }
    input theta: Angle;
    unknown phi: Angle, s: Length;
    crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
    output pin: Point = crank * cis(theta);
    output piston: Point = vec2(s, 0);
    ground 0;
    body arm: 0, pin;
    body conrod: pin, piston;
    body block: piston;
    slide piston along vec2(1, 0);
}

pub(super) const ENGINE: Engine = Engine { crank: 0.05, rod: 0.16 };

/// Every body of a linkage with a mass, a centre and an inertia, which no other one has.
pub(super) fn heavy(linkage: &AnyLinkage<'_>) -> NamedLoads {
    let loads = linkage.loads().gravity(Plane::new(0.3, -9.81));
    let bodies = linkage.outline().bodies.iter().enumerate();
    bodies.fold(loads, |loads, (index, body)| {
        let part = f64::from(u8::try_from(index).expect("a few bodies")) + 1.0;
        let centre = Plane::new(0.07 * part, 0.11 - 0.03 * part);
        loads
            .mass_of(body.name, 0.8 + 0.3 * part, centre, 0.02 * part)
            .expect("the body is there")
    })
}

const fn pin(coefficient: f64, radius: f64) -> Friction {
    Friction::Pin { coefficient, radius }
}

const fn slide(coefficient: f64) -> Friction {
    let length = None;
    Friction::Slide { coefficient, length }
}

const fn bushing(coefficient: f64, length: f64) -> Friction {
    let length = Some(length);
    Friction::Slide { coefficient, length }
}

fn rubbed<'m>(reactions: NamedReactions<'m>, frictions: &[(&str, Friction)]) -> NamedReactions<'m> {
    let rubbed = reactions.frictions(frictions.iter().copied());
    rubbed.expect("they can have it")
}
