//! Inputs at which a part rotates freely, such as the link of an inverted slider-crank whose slide stands on the link's
//! pivot.
//!
//! There the assemblies do not cross, since the free part stands in different directions. But the mechanism moves on
//! smoothly from one assembly into another one, and at the input itself the free part leads from every direction to
//! every other.

use alloc::vec::Vec;

use super::closed::ClosedSearch;
use super::interpolation::{CROSSING, around, crosses, interpolated};
use super::line::MEETING;
use crate::number::NumberRow;
use crate::quantity::{Dimension, Name};

/// The largest error of the closure on a way of positions, as a part of the size. The straight line between two other
/// positions that are [`MEETING`] or more apart leaves the closure by the square of their distance over eight, which is
/// a hundred times as much.
const FREE: f64 = MEETING * MEETING / 1024.0;
/// The number of parts of a straight line at whose ends the closure is tested.
const TESTED_PARTS: u32 = 8;

/// The largest number of angles half a revolution apart for which both ways are tried.
const MOST_HALVES: usize = 6;

/// An input at which an assembly jumps, because a part rotates freely there.
pub(super) struct Jump {
    pub(super) s: f64,
    /// The unknowns before the input and behind it.
    pub(super) unknowns: [NumberRow; 2],
    /// The unknowns of the block with the free part, separated by commas.
    pub(super) block: Name,
}

/// The input at which an assembly jumps, between samples on both sides of it.
///
/// Another assembly goes on smoothly where this one ends, and this one goes on where the other one ends. So there are
/// two smooth curves. Their difference has a simple zero in the unknown that frees the part, the length of the slide,
/// and inverse interpolation finds it. If two links rotate freely, one on the other, it is the angle between them that
/// has a simple zero along a curve.
pub(super) fn jump(search: &ClosedSearch<'_>, assembly: usize, samples: &[f64; CROSSING]) -> Option<Jump> {
    const BEFORE: usize = CROSSING / 2 - 1;
    const BEHIND: usize = CROSSING / 2;
    let start = search.solved(samples[BEFORE], assembly)?;
    let end = search.solved(samples[BEHIND], assembly)?;
    let mechanism = search.mechanism;
    let others = mechanism.assemblies().filter(|other| *other != assembly);
    let candidates = others.filter_map(|other| {
        let behind = search.solved(samples[BEHIND], other)?;
        Some((other, search.distance(&start, &behind)))
    });
    let (partner, way) = candidates.min_by(|one, other| one.1.total_cmp(&other.1))?;
    if way > 0.5 * search.distance(&start, &end) {
        return None;
    }
    let [mut onward, mut back] =
        [&start, &end].map(|unknowns| core::array::from_fn::<NumberRow, CROSSING, _>(|_| unknowns.clone()));
    for (index, s) in samples.iter().enumerate() {
        let (found, other) = (search.solved(*s, assembly)?, search.solved(*s, partner)?);
        let [one, two] = if index < BEHIND { [found, other] } else { [other, found] };
        (onward[index], back[index]) = (mechanism.nearest(&one, &start), mechanism.nearest(&two, &end));
    }
    let half = |index: usize, unknown: usize| 0.5 * (onward[index][unknown] - back[index][unknown]);
    let values = |unknown: usize| core::array::from_fn(|index| half(index, unknown));
    let unknowns = 0..start.len();
    let lead = unknowns
        .filter(|unknown| crosses(&values(*unknown)))
        .max_by(|one, other| half(0, *one).abs().total_cmp(&half(0, *other).abs()));
    let (zero, block) = if let Some(lead) = lead {
        (values(lead), mechanism.block_of(lead))
    } else {
        let dyads: [_; CROSSING] =
            core::array::from_fn(|index| search.transmission_angles(samples[index], &onward[index]));
        let folded = |dyad: usize| {
            core::array::from_fn(|index| {
                let angle = dyads[index][dyad].folded();
                if index < BEHIND { angle } else { -angle }
            })
        };
        let dyad = (0..dyads[0].len()).find(|dyad| crosses(&folded(*dyad)))?;
        (folded(dyad), dyads[0][dyad].block)
    };
    let s = interpolated(&zero, samples, 0.0);
    let at = |curve: &[NumberRow; CROSSING]| {
        NumberRow::from_fn(start.len(), |unknown| {
            interpolated(samples, &core::array::from_fn(|sample| curve[sample][unknown]), s)
        })
    };
    let unknowns = [at(&onward), at(&back)];
    let is_finite = unknowns.iter().all(|row| row.iter().all(|value| value.is_finite()));
    let is_jump = is_finite && s.is_finite() && search.distance(&unknowns[0], &unknowns[1]) >= MEETING;
    is_jump.then_some(Jump { s, unknowns, block })
}

/// The unknowns of an assembly before and behind an input, if they are different positions there: a part rotates
/// freely, and no other assembly goes on where this one ends, since the declared range of an unknown leaves it out.
pub(super) fn sides(search: &ClosedSearch<'_>, assembly: usize, s: f64, reach: f64) -> Option<[NumberRow; 2]> {
    // from samples that keep away from it, where the direction of the free part has lost its digits
    let side = |direction: f64| {
        let samples = around(s + 0.55 * direction * reach, 0.45 * reach);
        let first = search.solved(samples[0], assembly)?;
        let mut values: [_; CROSSING] = core::array::from_fn(|_| first.clone());
        for (value, sample) in values.iter_mut().zip(samples) {
            *value = search.mechanism.nearest(&search.solved(sample, assembly)?, &first);
        }
        let unknowns = NumberRow::from_fn(first.len(), |unknown| {
            interpolated(&samples, &core::array::from_fn(|index| values[index][unknown]), s)
        });
        is_position(search, s, &unknowns).then_some(unknowns)
    };
    let (before, behind) = (side(-1.0)?, side(1.0)?);
    (search.distance(&before, &behind) >= MEETING).then_some([before, behind])
}

/// Whether the closure holds, up to the error of an interpolation.
fn is_position(search: &ClosedSearch<'_>, s: f64, unknowns: &[f64]) -> bool {
    let residuals = search.mechanism.residuals(&search.line.inputs(s), unknowns);
    residuals.iter().all(|residual| residual.abs() <= FREE * search.size)
}

/// Whether a straight line between two positions at the same input consists of positions. An angle that is half a
/// revolution apart may rotate either way.
pub(super) fn is_connected(search: &ClosedSearch<'_>, s: f64, [from, to]: [&[f64]; 2]) -> bool {
    let unknowns = search.mechanism.unknowns();
    let to = search.mechanism.nearest(to, from);
    let halves = |unknown: usize| {
        let is_angle = unknowns[unknown].dimension == Dimension::Angle;
        is_angle && (to[unknown] - from[unknown]).abs() > core::f64::consts::PI - MEETING
    };
    let free: Vec<usize> = (0..to.len()).filter(|unknown| halves(*unknown)).collect();
    (0..1_usize << free.len().min(MOST_HALVES)).any(|ways| {
        let mut way = NumberRow::from_fn(to.len(), |unknown| to[unknown] - from[unknown]);
        for (bit, unknown) in free.iter().take(MOST_HALVES).enumerate() {
            if ways & (1 << bit) != 0 {
                way[*unknown] -= core::f64::consts::TAU.copysign(way[*unknown]);
            }
        }
        (0..=TESTED_PARTS).all(|step| {
            let part = f64::from(step) / f64::from(TESTED_PARTS);
            let unknowns = NumberRow::from_fn(to.len(), |unknown| from[unknown] + part * way[unknown]);
            is_position(search, s, &unknowns)
        })
    })
}
