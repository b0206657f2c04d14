//! A six-bar linkage whose output rests for a third of the crank's revolution.

use std::f64::consts::{PI, TAU};

use kin_core::library::{StephensonIII, StephensonIIIAssembly};
use kin_core::prelude::*;
use kin_core::{Plane, TransmissionAngle};
use kin_fit::{Effort, TracedFourBar, penalised, smallest};

use super::{number, smallest_of};

/// The part of the crank's revolution for which the output is to rest.
pub(crate) const REST: f64 = 2.0 * PI / 3.0;
/// The smallest swing of the output over the revolution.
pub(crate) const SWING: f64 = 30.0 * PI / 180.0;
/// The smallest transmission angle of both dyads over the whole revolution.
pub(crate) const TRANSMISSION: f64 = 40.0 * PI / 180.0;
/// The longest link, in cranks.
pub(crate) const LONGEST: f64 = 8.0;

/// Stephenson's six-bar linkage of the third kind with the rest of its link 6.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Dwell {
    /// The linkage. Its crank has the length 1.
    pub(crate) linkage: StephensonIII,
    /// The assemblies of its dyads.
    pub(crate) assembly: StephensonIIIAssembly,
    /// The crank's angle at the start of the rest.
    pub(crate) start: f64,
    /// The width of the range in which link 6 stays during the rest.
    pub(crate) deviation: f64,
    /// The width of the range of link 6 over the revolution.
    pub(crate) swing: f64,
    /// The smallest transmission angle over the revolution.
    pub(crate) transmission: f64,
}

/// The steps of a revolution in a search, and of a result. A third of them is a whole number.
const COARSE: usize = 144;
const FINE: usize = 3600;

/// The four-bar linkage that carries the coupler point, from the numbers that are searched: r1, r3 and r4 by their
/// logarithms, and the coupler point.
fn four_bar(numbers: &[f64]) -> TracedFourBar {
    TracedFourBar {
        r1: numbers[0].exp(),
        r2: 1.0,
        r3: numbers[1].exp(),
        r4: numbers[2].exp(),
        point: Plane::new(numbers[3], numbers[4]),
        turn: 0.0,
        pivot: Plane::new(0.0, 0.0),
    }
}

/// A six-bar linkage from its four-bar linkage, the point at which the end of link 5 is to rest, and link 6 from there.
fn with_dyad(four_bar: &TracedFourBar, centre: Plane, radius: f64, arm: Plane) -> StephensonIII {
    StephensonIII {
        r1: four_bar.r1,
        r2: four_bar.r2,
        r3: four_bar.r3,
        r4: four_bar.r4,
        p: four_bar.point,
        r5: radius,
        pivot: centre + arm,
        r6: arm.norm(),
    }
}

/// The circle through the positions of the coupler point at the start, in the middle and at the end of the rest.
fn circle(four_bar: &TracedFourBar, assembly: Assembly, start: f64) -> Option<(Plane, f64)> {
    let at = |share: f64| {
        let pose = four_bar.position(start + share * REST, assembly).ok()?;
        Some(pose.tracer.value())
    };
    let (first, middle, last) = (at(0.0)?, at(0.5)?, at(1.0)?);
    let (one, other) = (middle - first, last - first);
    let area = 2.0 * (one.x * other.y - one.y * other.x);
    let squares = [one, other].map(|side| side.x * side.x + side.y * side.y);
    let centre = Plane::new(
        other.y * squares[0] - one.y * squares[1],
        one.x * squares[1] - other.x * squares[0],
    )
    .scale(1.0 / area);
    let radius = centre.norm();
    radius.is_finite().then_some((first + centre, radius))
}

impl Dwell {
    /// The rest of a linkage that starts at an angle of the crank, measured at some steps of the revolution.
    #[must_use]
    pub(crate) fn of(
        linkage: &StephensonIII,
        assembly: StephensonIIIAssembly,
        start: f64,
        steps: usize,
    ) -> Option<Self> {
        let mut rest = (f64::INFINITY, f64::NEG_INFINITY);
        let mut all = rest;
        let mut transmission = f64::INFINITY;
        let mut before: Option<f64> = None;
        for step in 0..=steps {
            let angle = start + TAU * number(step) / number(steps);
            let pose = linkage.position(angle, assembly).ok()?;
            let raw = pose.theta6.value();
            // an angle goes on from the one before it
            let value = before.map_or(raw, |before| raw + TAU * ((before - raw) / TAU).round());
            before = Some(value);
            all = (all.0.min(value), all.1.max(value));
            if 3 * step <= steps {
                rest = (rest.0.min(value), rest.1.max(value));
            }
            let angles = linkage.transmission_angles(&pose);
            let smallest = angles.as_ref().iter().map(TransmissionAngle::folded);
            transmission = smallest.fold(transmission, f64::min);
        }
        Some(Self {
            linkage: *linkage,
            assembly,
            start,
            deviation: rest.1 - rest.0,
            swing: all.1 - all.0,
            transmission,
        })
    }
}

/// The cost of a broken limit, for each unit by which it is broken.
const PRICE: f64 = 100.0;

fn cost(linkage: &StephensonIII, assembly: StephensonIIIAssembly, start: f64) -> Result<f64, f64> {
    // the angle at which the linkage ceases to close is not known
    let dwell = Dwell::of(linkage, assembly, start, COARSE).ok_or(0.0)?;
    let over = |value: f64, limit: f64| (value - limit).max(0.0);
    let tip = linkage.p.norm();
    let arm = (linkage.p - Plane::new(linkage.r3, 0.0)).norm();
    let links = [
        linkage.r1,
        linkage.r3,
        linkage.r4,
        tip,
        arm,
        linkage.r5,
        linkage.r6,
        linkage.pivot.norm(),
    ];
    let longest = links.iter().fold(0.0_f64, |longest, link| longest.max(*link));
    let wrong = over(longest, LONGEST)
        + over(SWING, dwell.swing)
        // a link 6 that goes round does not rest and return
        + over(dwell.swing, PI)
        + over(TRANSMISSION, dwell.transmission);
    Ok(dwell.deviation + PRICE * wrong)
}

const KINDS: [(Assembly, Assembly); 4] = [
    (Assembly::Open, Assembly::Open),
    (Assembly::Open, Assembly::Crossed),
    (Assembly::Crossed, Assembly::Open),
    (Assembly::Crossed, Assembly::Crossed),
];

/// The ranges of the numbers of the four-bar linkage, of the crank's angle at the start, and of link 6.
fn ranges() -> [[f64; 2]; 8] {
    let size = [1.0_f64.ln(), LONGEST.ln()];
    let coordinate = [-LONGEST, LONGEST];
    [
        size,
        size,
        size,
        coordinate,
        coordinate,
        [-PI, PI],
        [0.5_f64.ln(), LONGEST.ln()],
        [-PI, PI],
    ]
}

/// The construction of the textbooks: a symmetrical coupler curve, the circle through three of its points, and a link
/// from its centre. The result is the best over all proportions of the four-bar linkage, coupler points, starts and
/// links 6.
///
/// A coupler curve is symmetrical if coupler, rocker and the distance of the coupler point from their joint are equal
/// (R. L. Norton, Design of Machinery, McGraw-Hill, section 3.6).
#[must_use]
pub(crate) fn constructed(effort: Effort) -> Option<Dwell> {
    let [size, _, _, _, _, angle, link, _] = ranges();
    let bounds = [size, size, angle, angle, link, angle];
    let of = |numbers: &[f64], assembly: (Assembly, Assembly)| {
        let equal = numbers[1].exp();
        let point = Plane::new(equal, 0.0) + Plane::polar(equal, numbers[2]);
        let symmetric = four_bar(&[numbers[0], numbers[1], numbers[1], point.x, point.y]);
        dwell_on_a_circle(&symmetric, assembly, numbers[3], numbers[4], numbers[5])
    };
    best_of(&bounds, effort, of)
}

/// The best linkage whose end of link 5 rests at the centre of the circle through three positions of the coupler point,
/// polished over all of its dimensions.
#[must_use]
pub(crate) fn best(effort: Effort) -> Option<Dwell> {
    let bounds = ranges();
    let of = |numbers: &[f64], assembly: (Assembly, Assembly)| {
        dwell_on_a_circle(&four_bar(numbers), assembly, numbers[5], numbers[6], numbers[7])
    };
    let start = best_of(&bounds, effort, of)?;
    Some(polished(&start, effort))
}

/// The linkage with link 6 at an angle from the centre of the circle.
fn dwell_on_a_circle(
    four_bar: &TracedFourBar,
    assembly: (Assembly, Assembly),
    start: f64,
    link: f64,
    angle: f64,
) -> Option<(StephensonIII, StephensonIIIAssembly, f64)> {
    if four_bar.shortfall() > 0.0 {
        return None;
    }
    let (centre, radius) = circle(four_bar, assembly.0, start)?;
    let linkage = with_dyad(four_bar, centre, radius, Plane::polar(link.exp(), angle));
    let assembly = StephensonIIIAssembly {
        theta3_theta4: assembly.0,
        theta5_theta6: assembly.1,
    };
    Some((linkage, assembly, start))
}

type Made = Option<(StephensonIII, StephensonIIIAssembly, f64)>;

fn best_of(
    bounds: &[[f64; 2]],
    effort: Effort,
    of: impl Fn(&[f64], (Assembly, Assembly)) -> Made + Sync,
) -> Option<Dwell> {
    let (found, assembly) = smallest_of(KINDS, bounds, effort, |numbers, assembly| {
        let made = of(numbers, assembly).ok_or(1.0);
        penalised(
            made.and_then(|(linkage, assembly, start)| cost(&linkage, assembly, start)),
            1.0,
        )
    })?;
    let (linkage, assembly, start) = of(&found.point, assembly)?;
    Dwell::of(&linkage, assembly, start, FINE)
}

/// The best linkage near a given linkage, over all dimensions.
fn polished(dwell: &Dwell, effort: Effort) -> Dwell {
    let numbers = |linkage: &StephensonIII, start: f64| {
        let StephensonIII {
            r1,
            r3,
            r4,
            p,
            r5,
            pivot,
            r6,
            ..
        } = *linkage;
        [r1, r3, r4, p.x, p.y, r5, pivot.x, pivot.y, r6, start]
    };
    let of = |numbers: &[f64]| {
        let linkage = StephensonIII {
            r1: numbers[0],
            r2: 1.0,
            r3: numbers[1],
            r4: numbers[2],
            p: Plane::new(numbers[3], numbers[4]),
            r5: numbers[5],
            pivot: Plane::new(numbers[6], numbers[7]),
            r6: numbers[8],
        };
        (linkage, numbers[9])
    };
    let near = numbers(&dwell.linkage, dwell.start).map(|number| [number - 0.1, number + 0.1]);
    let found = smallest(&near, Effort { starts: 2, ..effort }, |numbers| {
        let (linkage, start) = of(numbers);
        penalised(cost(&linkage, dwell.assembly, start), 1.0)
    });
    let (linkage, start) = of(&found.point);
    match Dwell::of(&linkage, dwell.assembly, start, FINE) {
        Some(better) if better.deviation < dwell.deviation && found.cost < PRICE * 1e-3 => better,
        _ => *dwell,
    }
}
