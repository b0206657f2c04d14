//! How straight and how evenly a tracer moves over half a revolution of the crank.

use std::f64::consts::TAU;

use kin_core::Plane;

use super::number;

/// A tracer at one angle of the crank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sample {
    /// Its position.
    pub(crate) position: Plane,
    /// Its derivative by the crank's angle.
    pub(crate) rate: Plane,
    /// The smallest transmission angle of the dyads, 0 ..= π/2.
    pub(crate) transmission: f64,
}

/// The motion of a tracer over a part of the crank's revolution, measured along and across the chord between its ends.
///
/// With Hoeken's linkage and a part that is symmetric about 180°, these are the measures of R. L. Norton, Design of
/// Machinery, McGraw-Hill, table 3-1: "maximum `ΔCy`", "ΔV" and "Δx".
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stroke {
    /// The crank's angle at the start.
    pub(crate) start: f64,
    /// The distance between the ends.
    pub(crate) chord: f64,
    /// The width of the path across the chord, as a share of the chord.
    pub(crate) deviation: f64,
    /// The largest less the smallest speed along the chord, as a share of the mean speed.
    pub(crate) unevenness: f64,
    /// The smallest transmission angle during the stroke.
    pub(crate) transmission: f64,
    /// The smallest transmission angle over the whole revolution.
    pub(crate) worst_transmission: f64,
    /// How far the rest of the revolution rises above the chord, as a share of the chord.
    pub(crate) lift: f64,
    /// How far the rest of the revolution falls below the lowest point of the stroke, as a share of the chord.
    pub(crate) fall: f64,
}

/// The samples of a revolution at equal steps, or `None` where the linkage does not close.
#[must_use]
pub(crate) fn samples(steps: usize, start: f64, sample: impl Fn(f64) -> Option<Sample>) -> Option<Vec<Sample>> {
    (0..steps)
        .map(|step| sample(start + TAU * number(step) / number(steps)))
        .collect()
}

impl Stroke {
    /// The stroke that starts at the first sample of a revolution and ends a number of steps later. The revolution is
    /// closed: the first sample follows the last.
    ///
    /// `None` if the ends coincide.
    #[must_use]
    pub(crate) fn of(samples: &[Sample], start: f64, steps: usize) -> Option<Self> {
        let (from, to) = (samples[0], samples[steps % samples.len()]);
        let way = to.position - from.position;
        let chord = way.norm();
        if !(chord.is_finite() && chord > 0.0) {
            return None;
        }
        let along = way.scale(1.0 / chord);
        let mut up = Plane::new(-along.y, along.x);
        let dot = |one: Plane, other: Plane| one.x * other.x + one.y * other.y;
        let (stroke, rest) = samples.split_at(steps.min(samples.len()));
        let rest_mean: f64 = rest.iter().map(|sample| dot(sample.position - from.position, up)).sum();
        if rest_mean < 0.0 {
            up = Plane::new(-up.x, -up.y);
        }
        // the last sample of the stroke is the first one of the rest
        let stroke = stroke.iter().chain(std::iter::once(&to));
        let mut heights = (0.0_f64, 0.0_f64);
        let mut speeds = (f64::INFINITY, f64::NEG_INFINITY);
        let mut transmission = f64::INFINITY;
        for sample in stroke {
            let height = dot(sample.position - from.position, up);
            heights = (heights.0.min(height), heights.1.max(height));
            let speed = dot(sample.rate, along);
            speeds = (speeds.0.min(speed), speeds.1.max(speed));
            transmission = transmission.min(sample.transmission);
        }
        let mut rise = (f64::INFINITY, f64::NEG_INFINITY);
        let mut worst_transmission = transmission;
        for sample in rest {
            let height = dot(sample.position - from.position, up);
            rise = (rise.0.min(height), rise.1.max(height));
            worst_transmission = worst_transmission.min(sample.transmission);
        }
        let mean = chord / (TAU * number(steps) / number(samples.len()));
        Some(Self {
            start,
            chord,
            deviation: (heights.1 - heights.0) / chord,
            unevenness: (speeds.1 - speeds.0) / mean,
            transmission,
            worst_transmission,
            lift: rise.1 / chord,
            fall: (heights.0 - rise.0).max(0.0) / chord,
        })
    }

    /// The half revolution with the smallest deviation among those that start at a sample of the revolution.
    #[must_use]
    pub(crate) fn straightest_half(samples: &[Sample], start: f64) -> Option<Self> {
        let mut samples = samples.to_vec();
        let mut best: Option<Self> = None;
        for step in 0..samples.len() {
            let angle = start + TAU * number(step) / number(samples.len());
            if let Some(stroke) = Self::of(&samples, angle, samples.len() / 2)
                && best.is_none_or(|best| stroke.deviation < best.deviation)
            {
                best = Some(stroke);
            }
            samples.rotate_left(1);
        }
        best
    }
}
