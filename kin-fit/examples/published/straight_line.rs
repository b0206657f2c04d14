//! A straight line at an even speed, over half a revolution of the crank.

use std::f64::consts::{FRAC_PI_2, PI};

use kin_core::Plane;
use kin_core::library::HoekenLinkage;
use kin_core::prelude::*;
use kin_fit::{Effort, TracedFourBar, penalised, smallest};

use super::smallest_of;
use super::stroke::{Sample, Stroke, samples};

/// A row of a table of Hoeken's linkages, for a crank of length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct HoekenRow {
    /// The crank's angle over which the tracer is to move straight, symmetric about 180°, in degrees.
    pub(crate) range: u16,
    /// The ground link.
    pub(crate) ground: f64,
    /// The coupler, as long as the rocker.
    pub(crate) coupler: f64,
    /// The printed largest deviation, in per cent of the line.
    pub(crate) deviation: f64,
    /// The printed unevenness of the speed, in per cent of the mean.
    pub(crate) unevenness: f64,
    /// The printed length of the line, in cranks.
    pub(crate) line: f64,
}

const fn row(range: u16, ground: f64, coupler: f64, deviation: f64, unevenness: f64, line: f64) -> HoekenRow {
    HoekenRow {
        range,
        ground,
        coupler,
        deviation,
        unevenness,
        line,
    }
}

/// The rows of R. L. Norton, Design of Machinery, McGraw-Hill, table 3-1, that are the straightest.
///
/// They are quoted without the page, and confirmed: all three printed results follow from the proportions.
pub(crate) const STRAIGHTEST: [HoekenRow; 4] = [
    row(100, 2.725, 3.588, 0.004, 9.90, 2.790),
    row(140, 2.500, 3.250, 0.023, 20.48, 3.623),
    row(160, 2.350, 3.025, 0.047, 27.15, 3.933),
    row(180, 2.200, 2.800, 0.096, 35.31, 4.181),
];
/// The rows of the same table that have the most even speed.
pub(crate) const MOST_EVEN: [HoekenRow; 4] = [
    row(20, 2.075, 2.613, 0.137, 0.006, 0.480),
    row(100, 1.900, 2.350, 0.640, 0.910, 2.237),
    row(140, 1.750, 2.125, 0.888, 3.327, 2.932),
    row(180, 1.575, 1.863, 1.446, 9.299, 3.456),
];

/// The smallest transmission angle that is allowed during the stroke.
pub(crate) const TRANSMISSION: f64 = 40.0 * PI / 180.0;
/// The shortest and the longest link that are allowed, as shares of the line.
pub(crate) const LINKS: [f64; 2] = [0.1, 10.0];

/// A linkage of the literature or of the search with its stroke of half a revolution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StraightLine {
    /// The linkage. Its crank has the length 1.
    pub(crate) linkage: TracedFourBar,
    /// The assembly of coupler and rocker.
    pub(crate) assembly: Assembly,
    /// The stroke.
    pub(crate) stroke: Stroke,
}

impl HoekenRow {
    /// The linkage with these proportions.
    #[must_use]
    pub(crate) fn linkage(&self) -> HoekenLinkage {
        HoekenLinkage {
            ground: self.ground,
            crank: 1.0,
            coupler: self.coupler,
        }
    }

    /// The stroke over the range of the row, measured at some steps for each degree.
    #[must_use]
    pub(crate) fn stroke(&self, steps_per_degree: usize) -> Option<Stroke> {
        let linkage = self.linkage();
        let start = PI - 0.5 * f64::from(self.range).to_radians();
        let samples = samples(360 * steps_per_degree, start, |angle| {
            let pose = linkage.position(angle, Assembly::Open).ok()?.velocity(1.0);
            Some(Sample {
                position: pose.tracer.value(),
                rate: pose.tracer.velocity(),
                transmission: folded(linkage.coupler, linkage.coupler, linkage.ground, 1.0, angle),
            })
        })?;
        Stroke::of(&samples, start, usize::from(self.range) * steps_per_degree)
    }
}

/// The transmission angle of a four-bar linkage, at most a right angle.
fn folded(coupler: f64, rocker: f64, ground: f64, crank: f64, angle: f64) -> f64 {
    let diagonal = ground * ground + crank * crank - 2.0 * ground * crank * angle.cos();
    let cosine = (coupler * coupler + rocker * rocker - diagonal) / (2.0 * coupler * rocker);
    cosine.abs().min(1.0).acos()
}

/// The samples of a tracer over a revolution from an angle of the crank.
#[must_use]
pub(crate) fn samples_of(linkage: &TracedFourBar, assembly: Assembly, start: f64, steps: usize) -> Option<Vec<Sample>> {
    samples(steps, start, |angle| {
        let pose = linkage.position(angle, assembly).ok()?.velocity(1.0);
        Some(Sample {
            position: pose.tracer.value(),
            rate: pose.tracer.velocity(),
            transmission: folded(linkage.r3, linkage.r4, linkage.r1, linkage.r2, angle),
        })
    })
}

/// A linkage with a crank of length 1, and the start of its half revolution, from the numbers that are searched.
pub(crate) fn linkage(numbers: &[f64]) -> (TracedFourBar, f64) {
    let length = |exponent: f64| exponent.exp();
    let linkage = TracedFourBar {
        r1: length(numbers[0]),
        r2: 1.0,
        r3: length(numbers[1]),
        r4: length(numbers[2]),
        point: Plane::polar(length(numbers[3]), numbers[4]),
        turn: 0.0,
        pivot: Plane::new(0.0, 0.0),
    };
    (linkage, numbers[5])
}

/// The cost of a broken limit, for each unit by which it is broken.
const PRICE: f64 = 1e3;

/// The straightest half revolution of any four-bar linkage whose crank makes full revolutions, with a speed that is at
/// least as even as wanted, in both assemblies.
///
/// Each link, and the tracer's distance from both joints of the coupler, lie within [`LINKS`]; the transmission angle
/// stays above [`TRANSMISSION`] during the stroke.
#[must_use]
pub(crate) fn straightest(unevenness: f64, effort: Effort) -> Option<StraightLine> {
    best([0.1, 30.0], FINE, effort, |linkage, stroke| {
        worth(linkage, stroke, unevenness)
    })
}

/// The four-bar linkage, in either assembly, with the smallest worth of its stroke. Its links have lengths in a range,
/// and its stroke is found in `fine` steps of a revolution.
pub(crate) fn best(
    links: [f64; 2],
    fine: usize,
    effort: Effort,
    worth: impl Fn(&TracedFourBar, &Stroke) -> f64 + Sync,
) -> Option<StraightLine> {
    let size = links.map(f64::ln);
    let bounds = [size, size, size, size, [-PI, PI], [-PI, PI]];
    let (found, assembly) = smallest_of(
        [Assembly::Open, Assembly::Crossed],
        &bounds,
        effort,
        |numbers, assembly| {
            let (linkage, start) = linkage(numbers);
            cost(&linkage, assembly, start, &worth)
        },
    )?;
    let (linkage, start) = linkage(&found.point);
    let stroke = stroke_of(&linkage, assembly, start, fine).ok()?;
    Some(StraightLine {
        linkage,
        assembly,
        stroke,
    })
}

/// The steps of a revolution in a search, and of a result.
const COARSE: usize = 144;
const FINE: usize = 7200;

fn cost(
    linkage: &TracedFourBar,
    assembly: Assembly,
    start: f64,
    worth: impl Fn(&TracedFourBar, &Stroke) -> f64,
) -> f64 {
    let stroke = stroke_of(linkage, assembly, start, COARSE);
    penalised(stroke.map(|stroke| worth(linkage, &stroke)), 1.0)
}

/// The stroke of a linkage whose crank makes full revolutions; otherwise by how much the crank fails to.
pub(crate) fn stroke_of(linkage: &TracedFourBar, assembly: Assembly, start: f64, steps: usize) -> Result<Stroke, f64> {
    let shortfall = linkage.shortfall();
    if shortfall > 0.0 {
        return Err(shortfall);
    }
    let samples = samples_of(linkage, assembly, start, steps);
    samples
        .and_then(|samples| Stroke::of(&samples, start, steps / 2))
        .ok_or(1.0)
}

fn worth(linkage: &TracedFourBar, stroke: &Stroke, unevenness: f64) -> f64 {
    let over = |value: f64, limit: f64| (value - limit).max(0.0);
    let tip = linkage.point.norm();
    let arm = (linkage.point - Plane::new(linkage.r3, 0.0)).norm();
    let links = [linkage.r1, linkage.r2, linkage.r3, linkage.r4, tip, arm];
    let wrong: f64 = links
        .iter()
        .map(|link| link / stroke.chord)
        .map(|link| over(link, LINKS[1]) + over(LINKS[0], link))
        .sum();
    let uneven = over(stroke.unevenness, unevenness);
    stroke.deviation + PRICE * (wrong + over(TRANSMISSION, stroke.transmission)) + 10.0 * uneven
}

/// The straightest of Hoeken's linkages over the half revolution about 180°, with a speed that is at least as even as
/// wanted.
///
/// Hoeken's linkages have two free proportions, ground to crank and coupler to crank.
#[must_use]
pub(crate) fn best_hoeken(unevenness: f64, effort: Effort) -> Option<StraightLine> {
    let as_traced = |numbers: &[f64]| TracedFourBar {
        r1: numbers[0],
        r2: 1.0,
        r3: numbers[1],
        r4: numbers[1],
        point: Plane::new(2.0 * numbers[1], 0.0),
        turn: 0.0,
        pivot: Plane::new(0.0, 0.0),
    };
    let bounds = [[1.05, 5.0], [0.5, 10.0]];
    let found = smallest(&bounds, effort, |numbers| {
        let worth = |linkage: &TracedFourBar, stroke: &Stroke| worth(linkage, stroke, unevenness);
        cost(&as_traced(numbers), Assembly::Open, FRAC_PI_2, worth)
    });
    let linkage = as_traced(&found.point);
    let stroke = stroke_of(&linkage, Assembly::Open, FRAC_PI_2, FINE).ok()?;
    Some(StraightLine {
        linkage,
        assembly: Assembly::Open,
        stroke,
    })
}
