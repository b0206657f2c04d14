//! The inputs at which a mechanism passes its targets in their order, when they are not given.

use std::f64::consts::TAU;

use crate::functions::{Change, Choice};
use crate::objective::Objective;
use crate::rows::share;
use crate::term::{Sense, Travel};

/// The samples of a revolution, or of the range of the input, between which inputs are sought.
const SAMPLES: usize = 144;
/// The number of samples at which the first target of a closed path is tried.
const FIRST: usize = 6;

/// The square of an error, and the distance from the sample to the input at which the error is smallest.
type Near = (f64, f64);

/// Inputs in order, with half of the sum of squares of their errors.
pub(crate) struct Assigned {
    pub(crate) inputs: Vec<f64>,
    pub(crate) cost: f64,
}

impl Objective {
    /// The best inputs in order among samples of the motion, by dynamic programming. Between the samples the motion
    /// counts as straight.
    ///
    /// The share of samples at which the mechanism does not close is returned if it passes no sequence of the targets.
    pub(crate) fn assign(&self, values: &[f64], choice: &Choice) -> Result<Assigned, f64> {
        let ([low, high], is_revolution) = (self.range.ends, self.range.is_revolution);
        // the inputs alone have derivatives
        let posed = self.posed(values, choice);
        let step = (high - low) / share(SAMPLES, 1);
        let count = if is_revolution { SAMPLES } else { SAMPLES + 1 };
        let targets = self.targets.len();
        let mut near: Vec<Vec<Near>> = vec![Vec::with_capacity(count); targets];
        let mut is_closed = Vec::with_capacity(count);
        for sample in 0..count {
            let input = low + step * share(sample, 1);
            let found = self.traced(&posed, 0, Change::new(input, 1.0));
            is_closed.push(found.is_some());
            for (target, near) in near.iter_mut().enumerate() {
                let Some(found) = &found else {
                    near.push((f64::INFINITY, 0.0));
                    continue;
                };
                let (mut square, mut along, mut rates) = (0.0, 0.0, 0.0);
                for (quantity, found) in found.iter().enumerate() {
                    let weight = self.targets[target].weight * self.traced[quantity].unit;
                    let error = self.error(&posed, target, quantity, *found);
                    let (error, rate) = (weight * error.value, weight * error.change);
                    square += error * error;
                    along += error * rate;
                    rates += rate * rate;
                }
                let beside = if rates > 0.0 {
                    (-along / rates).clamp(-0.5 * step, 0.5 * step)
                } else {
                    0.0
                };
                near.push((square + beside * (2.0 * along + beside * rates), beside));
            }
        }
        let unclosed = is_closed.iter().filter(|closed| !**closed).count();
        if unclosed > 0 && self.travel == Travel::Revolution || unclosed == count {
            return Err(share(unclosed, count));
        }
        let mut best: Option<Assigned> = None;
        for (list, is_loop) in sequences(&is_closed, is_revolution, self.sense, &near[0]) {
            let (cost, chosen) = in_order(&near, &list, count, is_loop);
            if best.as_ref().is_none_or(|best| cost < best.cost) {
                let inputs = chosen.iter().enumerate().map(|(target, &sample)| {
                    let (_, beside) = near[target][wrapped(sample, count)];
                    low + step * whole(sample) + beside
                });
                best = Some(Assigned {
                    inputs: inputs.collect(),
                    cost,
                });
            }
        }
        let mut best = best.ok_or_else(|| share(unclosed, count))?;
        if is_revolution {
            // The first input lies in the first revolution, and the others follow it.
            let offset = TAU * ((best.inputs[0] - low) / TAU).floor();
            for input in &mut best.inputs {
                *input -= offset;
            }
        }
        best.cost *= 0.5;
        if best.cost.is_finite() {
            Ok(best)
        } else {
            Err(share(unclosed, count))
        }
    }
}

/// A sample as a number.
#[expect(clippy::cast_precision_loss, reason = "there are few samples")]
fn whole(sample: isize) -> f64 {
    sample as f64
}

/// A sample on the first revolution.
fn wrapped(sample: isize, count: usize) -> usize {
    sample.rem_euclid(count.cast_signed()).cast_unsigned()
}

/// The sequences of closed samples along which the targets may follow each other, and whether a sequence is a full
/// revolution. On a full revolution the first target is met at the first sample.
fn sequences(is_closed: &[bool], is_revolution: bool, sense: Sense, first: &[Near]) -> Vec<(Vec<isize>, bool)> {
    let count = is_closed.len().cast_signed();
    let closed = |sample: isize| is_closed[wrapped(sample, is_closed.len())];
    let mut sequences = Vec::new();
    if is_revolution && is_closed.iter().all(|closed| *closed) {
        for first in first_samples(first) {
            sequences.push(((first..first + count).collect(), true));
            sequences.push(((0..count).map(|step| first - step).collect(), true));
        }
    } else {
        // On a revolution, a run that passes the end goes on at the beginning.
        let gap = if is_revolution {
            (0..count).find(|sample| !closed(*sample))
        } else {
            None
        };
        let start = gap.unwrap_or(0);
        let mut run: Vec<isize> = Vec::new();
        for sample in start..=start + count {
            if sample < start + count && closed(sample) {
                run.push(sample);
            } else if !run.is_empty() {
                sequences.push((run.clone(), false));
                sequences.push((std::mem::take(&mut run).into_iter().rev().collect(), false));
            }
        }
    }
    sequences.retain(|(list, _)| match (list.first() <= list.last(), sense) {
        _ if list.len() == 1 => true,
        (true, Sense::Backward) | (false, Sense::Forward) => false,
        _ => true,
    });
    sequences
}

/// The samples at which the first target is closer than at both neighbouring samples, as far as they are the closest.
fn first_samples(near: &[Near]) -> Vec<isize> {
    let count = near.len();
    let square = |sample: usize| near[sample % count].0;
    let mut samples: Vec<usize> = (0..count)
        .filter(|&sample| square(sample) <= square(sample + 1) && square(sample) <= square(sample + count - 1))
        .collect();
    samples.sort_by(|one, other| square(*one).total_cmp(&square(*other)));
    samples.truncate(FIRST);
    samples.into_iter().map(usize::cast_signed).collect()
}

/// The sum of squares of the best choice of samples in the order of a list, and the choice.
fn in_order(near: &[Vec<Near>], list: &[isize], count: usize, is_first_fixed: bool) -> (f64, Vec<isize>) {
    let square = |target: usize, entry: usize| near[target][wrapped(list[entry], count)].0;
    let mut sums: Vec<f64> = (0..list.len()).map(|entry| square(0, entry)).collect();
    if is_first_fixed {
        sums[1..].fill(f64::INFINITY);
    }
    // for each further target and entry of the list, the entry of the target before
    let mut before: Vec<Vec<usize>> = Vec::with_capacity(near.len());
    for target in 1..near.len() {
        let (mut least, mut at) = (f64::INFINITY, 0);
        let mut entries = Vec::with_capacity(list.len());
        for (entry, sum) in sums.iter_mut().enumerate() {
            if *sum < least {
                (least, at) = (*sum, entry);
            }
            entries.push(at);
            *sum = least + square(target, entry);
        }
        before.push(entries);
    }
    let last = (0..list.len()).min_by(|one, other| sums[*one].total_cmp(&sums[*other]));
    let Some(mut entry) = last else {
        return (f64::INFINITY, Vec::new());
    };
    let cost = sums[entry];
    let mut chosen = vec![list[entry]];
    for entries in before.iter().rev() {
        entry = entries[entry];
        chosen.push(list[entry]);
    }
    chosen.reverse();
    (cost, chosen)
}
