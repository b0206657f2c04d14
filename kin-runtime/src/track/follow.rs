//! The continuation: steps of the inputs, and of the fastest unknown where they are too fast.

use num_traits::Float;

use super::cause::{blocked, crossed_near, obstacle, stop};
use super::limit::{self, Passage};
use super::line::{TrackLine, TrackPosition};
use super::obstacle::TrackError;
use super::steps::Steps;
use crate::curve::{
    CurveFunctions, LentRows, Sides, Way, WayPoint, blur, fastest, is_crossed, largest, largest_difference,
};
use crate::failure::{Failure, InputValues, SolveError};
use crate::mechanism::Lent;

/// The longest step of the inputs, in units of their sizes.
pub(super) const LONGEST_INPUT_STEP: f64 = 0.5;
/// The largest size of the last terms of the Taylor series at the end of a step.
pub(super) const LAST_TERM: f64 = 0.02;
/// The largest difference between corrected and predicted unknowns. For their rates it is relative to the largest rate.
pub(super) const CORRECTION: f64 = 0.02;
/// The length of a step whose station is far enough from a change point for its series to be accurate there.
pub(super) const ANCHOR: f64 = 1e-3;
/// Within this distance of a change point, rounding can mix up the branches that cross there.
pub(super) const BLUR: f64 = 1e-5;
/// The length below which steps, by halving or doubling, lead towards or away from a special point. It is also relative
/// to the way, which would otherwise take too many such steps.
pub(super) const CREEPING: f64 = 1e-6;
/// The largest number of such short steps in a row. Halving a step down to the shortest, or doubling it from there,
/// takes about 25 steps, and each length may be tried several times.
pub(super) const MOST_CREEPING: u32 = 256;
/// The factor of growth from which an unknown may be going to infinity.
pub(super) const GROWTH_TO_POLE: f64 = 1e6;
/// The number of iterations on a smooth function near its zero.
pub(super) const SECANTS: usize = 30;
/// The rate of an unknown above which it replaces the inputs as parameter.
pub(super) const FAST: f64 = 32.0;

/// The error of a track whose position is reported beside it.
pub(super) type Ended = TrackError<(), ()>;

/// A point of the track and everything known there.
#[derive(Clone, Copy)]
pub(super) struct TrackPoint<'s> {
    pub(super) point: WayPoint<'s>,
    /// The unknowns in all orders, one after the other, with angles unwrapped along the track.
    pub(super) motions: &'s [f64],
    /// The sizes of the unknowns at this station.
    sizes: &'s [f64],
    pub(super) sides: Sides<'s>,
}

impl<'s> TrackPoint<'s> {
    /// Memory for a station.
    fn memory(way: &Way<'_>, scratch: &mut LentRows<'s>) -> &'s mut [f64] {
        scratch.lend(1 + way.count() * (way.orders() + 2) + 2 * way.description.blocks.len())
    }

    fn write(&self, memory: &mut [f64]) {
        memory[0] = self.point.travel;
        let mut rest = &mut memory[1..];
        for row in [self.point.unknowns, self.sizes, self.motions] {
            let (first, behind) = rest.split_at_mut(row.len());
            first.copy_from_slice(row);
            rest = behind;
        }
        self.sides.write(rest);
    }

    fn read(way: &Way<'_>, memory: &'s [f64]) -> Self {
        let (travel, rest) = memory.split_at(1);
        let (unknowns, rest) = rest.split_at(way.count());
        let (sizes, rest) = rest.split_at(way.count());
        let (motions, sides) = rest.split_at(way.count() * way.orders());
        Self {
            point: WayPoint {
                unknowns,
                travel: travel[0],
            },
            motions,
            sizes,
            sides: Sides::read(sides),
        }
    }

    /// The derivatives of an unknown with respect to the travel, its value first.
    fn motion(&self, index: usize) -> &'s [f64] {
        let orders = self.motions.len() / self.sizes.len();
        &self.motions[index * orders..(index + 1) * orders]
    }

    /// The first derivative of an unknown with respect to the travel.
    pub(super) fn rate(&self, index: usize) -> f64 {
        self.motion(index).get(1).copied().unwrap_or(0.0)
    }

    /// The first derivatives with respect to the travel, in units of the given sizes.
    pub(super) fn rates<'t>(&self, sizes: &[f64], scratch: &mut LentRows<'t>) -> &'t [f64] {
        scratch.row(sizes.len(), |index| self.rate(index) / sizes[index])
    }

    /// An unknown after a step by Taylor's series, or its derivative of the order `lowest`.
    fn series(&self, index: usize, lowest: usize, step: f64) -> f64 {
        // Horner's scheme for the sum of derivative · stepⁿ / n!.
        let derivatives = &self.motion(index)[lowest..];
        let mut order = f64::from(u32::try_from(derivatives.len()).unwrap_or(u32::MAX));
        derivatives.iter().rev().fold(0.0, |sum, derivative| {
            let value = derivative + sum * step / order;
            order -= 1.0;
            value
        })
    }

    /// The unknowns after a step by Taylor's series.
    pub(super) fn predicted<'t>(&self, step: f64, scratch: &mut LentRows<'t>) -> &'t [f64] {
        scratch.row(self.sizes.len(), |index| self.series(index, 0, step))
    }

    /// Their rates in the sizes before the step.
    fn predicted_rates<'t>(&self, step: f64, scratch: &mut LentRows<'t>) -> &'t [f64] {
        scratch.row(self.sizes.len(), |index| {
            self.series(index, 1, step) / self.sizes[index]
        })
    }

    /// The step after which the last two terms of the series are small. The first order is straight and does not count.
    /// For a series without other orders, only the comparison with the solution limits the step.
    fn trusted(&self) -> f64 {
        let mut step = f64::INFINITY;
        for (index, size) in self.sizes.iter().enumerate() {
            let derivatives = self.motion(index);
            let last = derivatives.len().saturating_sub(1);
            let mut factorial = 1.0;
            let mut exponent = 0.0;
            for (order, derivative) in derivatives.iter().enumerate().skip(1) {
                exponent += 1.0;
                factorial *= exponent;
                if order > 1 && order + 1 >= last {
                    let coefficient = (derivative / factorial / size).abs();
                    step = step.min(Float::powf(LAST_TERM / coefficient, 1.0 / exponent));
                }
            }
        }
        step
    }
}

/// The reason why there is no station.
pub(super) enum Missing {
    Unsolved(SolveError),
    /// The closure is not finite, or the solution belongs to another branch.
    Elsewhere,
}

/// Moves the mechanism of a position, whose unknowns are close to a position, along a line of inputs.
pub(super) fn follow(
    mechanism: &dyn CurveFunctions,
    parameters: &[f64],
    [from, to]: [&[f64]; 2],
    position: TrackPosition<'_>,
    lent: Lent<'_>,
) -> Result<(), Ended> {
    let solved = |inputs: &[f64], near: &[f64], unknowns: &mut [f64]| {
        mechanism.position_near(parameters, inputs, near, unknowns)
    };
    let Lent { numbers, first, second } = lent;
    let (start, numbers) = numbers.split_at_mut(position.unknowns.len());
    solved(from, position.unknowns, start)?;
    let start = &*start;
    position.unknowns.copy_from_slice(start);
    let (way, mut scratch) = TrackLine::new(
        mechanism,
        parameters,
        [from, to],
        start,
        Lent { numbers, first, second },
        position,
    );
    if !way.length.is_finite() {
        // The solver reports best which input is wrong.
        solved(to, start, scratch.lend(start.len()))?;
        let quantity = "way of the inputs";
        return Err(TrackError::Failed(lost(&way, 0, Failure::not_finite(quantity))));
    }
    if way.length == 0.0 {
        return Ok(());
    }
    let [mut here_memory, mut there_memory, anchor_memory] = [(); 3].map(|()| TrackPoint::memory(&way, &mut scratch));
    let start = station(&way, 0.0, start, &mut scratch).map_err(|missing| match missing {
        Missing::Unsolved(error) => error,
        Missing::Elsewhere => {
            let quantity = "closure at the beginning";
            lost(&way, 0, Failure::not_finite(quantity))
        }
    })?;
    let beginning = start.sides;
    start.write(here_memory);
    start.write(anchor_memory);
    let assembly = way.assembly_at(start.point, &mut scratch);
    let mut longest = LONGEST_INPUT_STEP;
    let mut steps = Steps::NONE;
    // Whether following an unknown as parameter has led nowhere since the unknowns became fast.
    let mut is_lost = false;
    let mut creeping = 0;
    loop {
        let mut scratch = scratch.scope();
        let here = TrackPoint::read(&way, here_memory);
        let anchor = TrackPoint::read(&way, anchor_memory);
        let trusted = here.trusted().min(longest);
        let rate = largest((0..way.count()).map(|index| here.rate(index) / here.sizes[index]));
        if rate <= FAST {
            is_lost = false;
        }
        // A fast and straight motion, for example behind a gear, is not near a limit.
        if rate > FAST && rate * trusted < LONGEST_INPUT_STEP && !is_lost {
            let mut scratch = scratch.scope();
            match past_the_limit(&way, &here, &anchor, &beginning, &mut steps, &mut scratch)? {
                Arrival::Station(there) if there.point.travel > here.point.travel => {
                    there.write(here_memory);
                    there.write(anchor_memory);
                    (longest, creeping) = (LONGEST_INPUT_STEP, 0);
                    continue;
                }
                Arrival::End => return Ok(()),
                // The solvers may find a way, or a reason why there is none.
                _ => is_lost = true,
            }
        }
        let rest = way.length - here.point.travel;
        let mut step = trusted;
        let mut error = None;
        let there = loop {
            if step < way.shortest() || creeping > MOST_CREEPING {
                break None;
            }
            if !steps.take() {
                return Err(TrackError::TooManySteps(stop(&way, here.point, &steps, &mut scratch)));
            }
            let is_last = step >= rest;
            let travel = if is_last { way.length } else { here.point.travel + step };
            let mut scratch = scratch.scope();
            match attempted(&way, &here, travel, &mut scratch) {
                Ok(there) if has(&way, &there, assembly, &mut scratch) => {
                    if is_last {
                        way.arrive(there.point.unknowns);
                        return Ok(());
                    }
                    there.write(there_memory);
                    break Some(TrackPoint::read(&way, there_memory));
                }
                Ok(_) | Err(Missing::Elsewhere) => {}
                Err(Missing::Unsolved(reason)) => error = Some(reason),
            }
            step = 0.5 * step.min(rest);
        };
        let Some(there) = there else {
            match past_the_limit(&way, &here, &anchor, &beginning, &mut steps, &mut scratch)? {
                // Do not continue if it only creeps through the neighbourhood of a change point.
                Arrival::Station(there) if there.point.travel > here.point.travel + BLUR => {
                    there.write(here_memory);
                    there.write(anchor_memory);
                    (longest, creeping) = (LONGEST_INPUT_STEP, 0);
                    continue;
                }
                Arrival::End => return Ok(()),
                _ => return Err(blocked(&way, &here, &anchor, &beginning, error, &steps, &mut scratch)),
            }
        };
        // Rounding errors separate the branches that cross here, so there seems to be a way around the crossing.
        if step < BLUR && {
            let parameter = fastest(there.rates(way.sizes, &mut scratch));
            is_crossed(&way, there.point, parameter, &mut scratch)
        } {
            return Err(crossed_near(
                &way,
                there.point,
                there.sides,
                &anchor,
                &beginning,
                &mut scratch,
            ));
        }
        creeping = if step < CREEPING * way.length.min(1.0) {
            creeping + 1
        } else {
            0
        };
        longest = LONGEST_INPUT_STEP.min(2.0 * step);
        if step > ANCHOR {
            there.write(anchor_memory);
        }
        core::mem::swap(&mut here_memory, &mut there_memory);
    }
}

/// The mechanism at a given travel, close to given unknowns.
pub(super) fn station<'s>(
    way: &Way<'_>,
    travel: f64,
    near: &[f64],
    scratch: &mut LentRows<'s>,
) -> Result<TrackPoint<'s>, Missing> {
    let motions = way.motions_near(travel, near, scratch).map_err(Missing::Unsolved)?;
    let orders = way.orders();
    let unknowns = scratch.row(way.count(), |index| motions[index * orders]);
    let point = WayPoint { unknowns, travel };
    let sizes = scratch.row(way.count(), |index| way.size_at(unknowns, index));
    let linear = way.linearise(point, scratch).ok_or(Missing::Elsewhere)?;
    Ok(TrackPoint {
        point,
        motions,
        sizes,
        sides: Sides::of(way, &linear, scratch),
    })
}

/// The station at the end of a step, if it certainly lies on the same branch and nothing happens in between.
pub(super) fn attempted<'s>(
    way: &Way<'_>,
    here: &TrackPoint<'_>,
    travel: f64,
    scratch: &mut LentRows<'s>,
) -> Result<TrackPoint<'s>, Missing> {
    let step = travel - here.point.travel;
    for part in [0.25, 0.5, 0.75, 1.0] {
        let mut scope = scratch.scope();
        let point = WayPoint {
            unknowns: here.predicted(part * step, &mut scope),
            travel: here.point.travel + part * step,
        };
        let linear = way.linearise(point, &mut scope).ok_or(Missing::Elsewhere)?;
        if !Sides::of(way, &linear, &mut scope).are_near(&here.sides) {
            return Err(Missing::Elsewhere);
        }
    }
    let near = here.predicted(step, scratch);
    let foreseen = here.predicted_rates(step, scratch);
    let there = station(way, travel, near, scratch)?;
    let distance = largest_difference(there.point.unknowns, near, here.sizes);
    let rates = there.rates(here.sizes, scratch);
    let pairs = rates.iter().zip(foreseen);
    let change = largest(pairs.map(|(one, other)| one - other));
    let scale = largest(rates.iter().copied()).max(1.0);
    // A correction must also be small compared with the step, or it could lead to a neighbouring branch.
    let far = there.point.unknowns.iter().zip(here.sizes);
    let ulps = 64.0 * f64::EPSILON * largest(far.map(|(value, size)| value / size)).max(1.0);
    let allowed = CORRECTION * (step * scale).min(1.0) + ulps;
    let is_same = change <= 5.0 * CORRECTION * scale
        && there.sides.are_near(&here.sides)
        && (distance <= allowed || {
            // Rounding beyond the limit of a correction would excuse any difference.
            let blur = blur(way, there.point, scratch);
            blur <= CORRECTION && distance <= allowed + blur
        });
    if is_same { Ok(there) } else { Err(Missing::Elsewhere) }
}

/// Whether a station belongs to the given assembly. Assemblies that depend on the dimensions have no names to compare;
/// the determinants distinguish them.
fn has(way: &Way<'_>, there: &TrackPoint<'_>, assembly: Option<usize>, scratch: &mut LentRows<'_>) -> bool {
    way.mechanism.assembly_count() == 0 || way.assembly_at(there.point, scratch) == assembly
}

/// The result of following the curve of solutions with an unknown as its parameter.
enum Arrival<'s> {
    /// A station from which steps of the inputs continue.
    Station(TrackPoint<'s>),
    /// The end of the track.
    End,
    /// No result.
    None,
}

fn past_the_limit<'s>(
    way: &TrackLine<'_>,
    here: &TrackPoint<'_>,
    anchor: &TrackPoint<'_>,
    beginning: &Sides<'_>,
    steps: &mut Steps,
    scratch: &mut LentRows<'s>,
) -> Result<Arrival<'s>, Ended> {
    let rates = here.rates(way.sizes, scratch);
    match limit::pass(way, here.point, rates, steps, scratch) {
        Passage::Onwards(point) => {
            let there = station(way, point.travel, point.unknowns, scratch);
            Ok(there.map_or(Arrival::None, Arrival::Station))
        }
        Passage::Target(unknowns) => {
            way.arrive(unknowns);
            Ok(Arrival::End)
        }
        Passage::Limit(point, sides) => Err(TrackError::TurningPoint(obstacle(way, point, &sides, beginning))),
        Passage::ChangePoint(point, sides) => Err(crossed_near(way, point, sides, anchor, beginning, scratch)),
        Passage::Lost => Ok(Arrival::None),
        Passage::Spent(point) => Err(TrackError::TooManySteps(stop(way, point, steps, scratch))),
    }
}

/// A failure of a block that no solver has reported.
fn lost(way: &Way<'_>, block: usize, failure: Failure) -> SolveError {
    failure.at(way.block(block), InputValues::new(&[], &[]))
}
