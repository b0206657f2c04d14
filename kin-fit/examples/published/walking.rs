//! A foot that walks: straight and even for half a revolution of the crank, and lifted for the other half.

use kin_core::library::{JansenLeg, KlannLeg};
use kin_core::prelude::*;
use kin_core::{Plane, TransmissionAngle};
use kin_fit::{Effort, TracedFourBar, penalised, smallest};

use super::straight_line::{StraightLine, best};
use super::stroke::{Sample, Stroke, samples};

/// A leg with its step.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Leg {
    /// The number of its moving links.
    pub(crate) links: usize,
    /// Its straightest half revolution, on which it stands.
    pub(crate) step: Stroke,
}

/// The limits that the leg of a search has to keep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Limits {
    /// The largest unevenness of the speed on the ground.
    pub(crate) unevenness: f64,
    /// The smallest lift, in shares of the step.
    pub(crate) lift: f64,
    /// The smallest transmission angle over the whole revolution.
    pub(crate) transmission: f64,
}

/// The steps of a revolution in a search, and of a result.
const COARSE: usize = 144;
const FINE: usize = 3600;

/// The smallest of some transmission angles, at most a right angle.
fn least_of(angles: impl AsRef<[TransmissionAngle]>) -> f64 {
    angles
        .as_ref()
        .iter()
        .map(TransmissionAngle::folded)
        .fold(f64::INFINITY, f64::min)
}

impl Limits {
    /// By how much a step breaks the limits. A foot that falls below its ground breaks them too.
    fn broken(&self, step: &Stroke) -> f64 {
        let over = |value: f64, limit: f64| (value - limit).max(0.0);
        over(step.unevenness, self.unevenness)
            + over(self.lift, step.lift)
            + over(self.transmission, step.worst_transmission)
            + step.fall
    }
}

/// A mechanism with a foot.
trait Walker: Mechanism<Scalar = f64> + Sync {
    const LINKS: usize;

    fn sample(&self, angle: f64) -> Option<Sample>;
}

impl Walker for JansenLeg {
    const LINKS: usize = 7;

    fn sample(&self, angle: f64) -> Option<Sample> {
        let pose = self.position(angle, Self::WALKING).ok()?.velocity(1.0);
        Some(Sample {
            position: pose.foot.value(),
            rate: pose.foot.velocity(),
            transmission: least_of(self.transmission_angles(&pose)),
        })
    }
}

impl Walker for KlannLeg {
    const LINKS: usize = 5;

    fn sample(&self, angle: f64) -> Option<Sample> {
        let pose = self.position(angle, Self::WALKING).ok()?.velocity(1.0);
        Some(Sample {
            position: pose.foot.value(),
            rate: pose.foot.velocity(),
            transmission: least_of(self.transmission_angles(&pose)),
        })
    }
}

fn walking<M: Walker>(leg: &M) -> Option<Leg> {
    let samples = samples(FINE, 0.0, |angle| leg.sample(angle))?;
    let step = Stroke::straightest_half(&samples, 0.0)?;
    Some(Leg { links: M::LINKS, step })
}

/// Jansen's leg with his dimensions.
#[must_use]
pub(crate) fn jansen() -> Option<Leg> {
    walking(&JansenLeg::HOLY_NUMBERS)
}

/// Klann's leg with the dimensions of his patent.
#[must_use]
pub(crate) fn klann() -> Option<Leg> {
    walking(&KlannLeg::PATENT)
}

/// Jansen's leg with the flattest step among dimensions within a share of his, and no worse in any other measure.
#[must_use]
pub(crate) fn better_jansen(within: f64, effort: Effort) -> Option<(JansenLeg, Leg)> {
    better(&JansenLeg::HOLY_NUMBERS, within, effort)
}

/// Klann's leg with the flattest step among dimensions within a share of those of his patent, and no worse in any other
/// measure.
#[must_use]
pub(crate) fn better_klann(within: f64, effort: Effort) -> Option<(KlannLeg, Leg)> {
    better(&KlannLeg::PATENT, within, effort)
}

fn better<M: Walker>(given: &M, within: f64, effort: Effort) -> Option<(M, Leg)> {
    let old = walking(given)?.step;
    let limits = Limits {
        unevenness: old.unevenness,
        lift: old.lift,
        transmission: old.worst_transmission,
    };
    let parameters = given.parameters();
    let numbers = parameters.as_ref();
    let mut ranges: Vec<[f64; 2]> = numbers
        .iter()
        .map(|number| [number - within * number.abs(), number + within * number.abs()])
        .collect();
    ranges.push([old.start - 0.5, old.start + 0.5]);
    let of = |numbers: &[f64]| M::from_parameters(Row::from_fn(|index| numbers[index]));
    let found = smallest(&ranges, effort, |point| {
        let start = point[numbers.len()];
        let leg = of(point);
        let samples = samples(COARSE, start, |angle| leg.sample(angle));
        let step = samples.and_then(|samples| Stroke::of(&samples, start, COARSE / 2));
        let cost = step.map(|step| step.deviation + PRICE * limits.broken(&step));
        penalised(cost.ok_or(0.0), 1.0)
    });
    let leg = of(&found.point);
    let start = found.point[numbers.len()];
    let samples = samples(FINE, start, |angle| leg.sample(angle))?;
    let step = Stroke::of(&samples, start, FINE / 2)?;
    Some((leg, Leg { links: M::LINKS, step }))
}

/// The four-bar linkage whose tracer stands flattest within some limits, with links up to [`LONGEST`] steps.
#[must_use]
pub(crate) fn four_bar(limits: &Limits, effort: Effort) -> Option<(StraightLine, Leg)> {
    let line = best([0.5, 10.0], FINE, effort, |linkage, step| worth(linkage, step, limits))?;
    let step = line.stroke;
    Some((line, Leg { links: 3, step }))
}

/// The longest link of [`four_bar`], in steps.
pub(crate) const LONGEST: f64 = 3.0;
/// The cost of a broken limit, for each unit by which it is broken.
const PRICE: f64 = 100.0;

fn worth(linkage: &TracedFourBar, step: &Stroke, limits: &Limits) -> f64 {
    let tip = linkage.point.norm();
    let arm = (linkage.point - Plane::new(linkage.r3, 0.0)).norm();
    let links = [linkage.r1, linkage.r2, linkage.r3, linkage.r4, tip, arm];
    let longest = links
        .iter()
        .fold(0.0_f64, |longest, link| longest.max(link / step.chord));
    step.deviation + PRICE * (limits.broken(step) + (longest - LONGEST).max(0.0))
}
