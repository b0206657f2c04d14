//! Refinement: known linkages are found again, defects are named, threads do not matter, derivatives are exact.

mod defects;
mod derivatives;
mod jobs;
mod recovery;

use kin_core::any::Of;
use kin_core::prelude::*;
use kin_fit::{Candidate, FitFunctions};

mechanism! {
    /// A four-bar linkage with a point of its coupler; the crank stands at `theta2 + mark`.
    pub(crate) struct Coupler {
        pub(crate) r1: Length,
        pub(crate) r2: Length,
        pub(crate) r3: Length,
        pub(crate) r4: Length,
        pub(crate) along: Length,
        pub(crate) beside: Length,
        pub(crate) mark: Angle,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2 + mark) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    output point: Point = r2 * cis(theta2 + mark) + vec2(along, beside) * cis(theta3);
}

/// The functions of the mechanism.
pub(crate) const COUPLER: &dyn FitFunctions = Of::<Coupler>::FUNCTIONS;

pub(crate) const KNOWN: Coupler = Coupler {
    r1: 2.0,
    r2: 0.6,
    r3: 1.8,
    r4: 1.5,
    along: 0.9,
    beside: 0.7,
    mark: 0.0,
};

/// The point of a linkage at an input, turned and moved.
pub(crate) fn placed(linkage: &Coupler, input: f64, [x, y, angle]: [f64; 3]) -> [f64; 3] {
    let pose = linkage.position(input, Assembly::Open).expect("it closes");
    let point = pose.point.value();
    let (sine, cosine) = angle.sin_cos();
    let [along, across] = [cosine * point.x - sine * point.y, sine * point.x + cosine * point.y];
    [x + along, y + across, angle + pose.theta3.position()]
}

/// A candidate with all lengths off by a part, alternately longer and shorter.
pub(crate) fn off(part: f64) -> Candidate {
    let more = |length: f64| length * (1.0 + part);
    let less = |length: f64| length * (1.0 - part);
    let linkage = Coupler {
        r1: more(KNOWN.r1),
        r2: less(KNOWN.r2),
        r3: less(KNOWN.r3),
        r4: more(KNOWN.r4),
        along: more(KNOWN.along),
        beside: less(KNOWN.beside),
        mark: 0.0,
    };
    Candidate::new(&linkage, Assembly::Open)
}
