//! Moving a mechanism from a known position to another one.

mod cause;
mod obstacle;
mod rounding;
mod sides;
mod steps;
#[cfg(test)]
mod tests;
#[cfg(feature = "alloc")]
mod tracked;
mod turning;
mod way;

pub use obstacle::{Halt, Obstacle, TrackError};
pub use steps::MOST_TRACK_STEPS;
#[cfg(feature = "alloc")]
pub use tracked::Tracked;

use cause::{blocked, crossed_near, halt, obstacle};
use num_traits::Float;
use rounding::{blur, is_crossed};
use sides::Sides;
use steps::Steps;
use turning::Passage;
use way::{Linear, Way, WayPoint, largest};

use crate::failure::{Failure, InputValues, SolveError};
use crate::mechanism::{Mechanism, Pose, PoseOf};
use crate::number::{Number, Row};

/// The longest step of the inputs, in units of their sizes.
const LONGEST: f64 = 0.5;
/// The largest size of the last terms of the Taylor series at the end of a step.
const LAST_TERM: f64 = 0.02;
/// The largest difference between corrected and predicted unknowns. For their rates it is relative to the largest rate.
const CORRECTION: f64 = 0.02;
/// The shortest step, as a part of the way or of the unit.
const SHORTEST: f64 = 1e-13;
/// The length of a step whose station is far enough from a change point for its series to be accurate there.
const ANCHOR: f64 = 1e-3;
/// Within this distance of a change point, rounding can mix up the branches that cross there.
const BLUR: f64 = 1e-5;
/// The length below which steps, by halving or doubling, lead towards or away from a special place. It is also relative
/// to the way, which would otherwise take too many such steps.
const CREEPING: f64 = 1e-6;
/// The largest number of such short steps in a row. Halving a step down to the shortest, or doubling it from there,
/// takes about 25 steps, and each length may be tried several times.
const MOST_CREEPING: u32 = 256;
/// The factor of growth from which an unknown may be going to infinity.
const FAR: f64 = 1e6;
/// The number of iterations on a smooth function near its zero.
const SECANTS: usize = 30;
/// The rate of an unknown above which it replaces the inputs as parameter.
const FAST: f64 = 32.0;

/// The [`TrackError`] of a mechanism, with its inputs and unknowns in double precision.
pub type TrackErrorOf<M> = TrackError<<M as Mechanism>::Inputs<f64>, <M as Mechanism>::Unknowns<f64>>;
/// The obstacle in this error.
type ObstacleOf<M> = Obstacle<<M as Mechanism>::Inputs<f64>, <M as Mechanism>::Unknowns<f64>>;
/// The halt in this error.
type HaltOf<M> = Halt<<M as Mechanism>::Inputs<f64>, <M as Mechanism>::Unknowns<f64>>;

/// Moves the inputs on a straight line from one place to another, and moves the mechanism with them without leaving its
/// assembly.
///
/// `from_unknowns` are the unknowns at `from_inputs`, or values close enough for
/// [`solve_position_near`](Mechanism::solve_position_near). The result contains the unknowns at `to_inputs`, in radians
/// or the mechanism's own unit. Angles keep their turns, so a crank that has made a full turn ends 2π further.
///
/// This is a continuation method. The Taylor series of the mechanism's own solvers predicts each step, to the order of
/// the mechanism, and [`solve_motion_near`](Mechanism::solve_motion_near) corrects it. A step is accepted if prediction
/// and correction agree in the unknowns and their rates, and if the determinant of each block's Jacobian keeps its
/// sign, and its size within a factor of two, at every quarter of the step. Two changes of sign could hide only if a
/// determinant fell to zero and recovered within a quarter of a step on which the series is accurate. The last terms of
/// the series and these tests determine the length of the steps.
///
/// If an unknown moves more than 32 times as fast as the inputs, it becomes the parameter and the track solves for the
/// inputs instead. A limit position is then a regular point: the zero of the inputs' rate. Newton's method finds it,
/// and the inputs there are exact to rounding.
///
/// # Steps
/// A track takes at most [`MOST_TRACK_STEPS`] steps, including rejected ones. A step is one solution by the mechanism's
/// solvers or, where an unknown is the parameter, one solution by at most 64 corrections. Locating an obstacle takes at
/// most 64 more solutions.
///
/// The effect of rounding errors of the closure on the unknowns does not count as a difference between prediction and
/// correction, so long links in a loop of short ones do not force short steps. Short steps without progress are
/// counted: after 256 in a row that are shorter than 10⁻⁶, or 32 that do not change the inputs, the track looks for the
/// cause.
///
/// The track runs in double precision; a number type that carries derivatives gets them at the end.
///
/// # Errors
/// [`TrackError::Limit`], [`TrackError::ChangePoint`] and [`TrackError::Unbounded`] with the place.
/// [`TrackError::Failed`] if there is no position at the start, or if something else ends the track: at the end of the
/// domain of a function, or of the range of an unknown, its inputs are the first ones beyond, to the last digit.
/// [`TrackError::TooManySteps`] and [`TrackError::Lost`] with the last position and the reason for stopping there.
///
/// ```
/// use core::f64::consts::TAU;
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
/// use kin_core::{TrackError, track};
///
/// // a crank-rocker goes all the way round
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
/// for assembly in Assembly::BOTH {
///     let start = linkage.position(0.5, assembly)?.unknowns();
///     let end = track(&linkage, [0.5], start, [0.5 + TAU])?;
///     assert!((end[0] - start[0]).abs() < 1e-13 && (end[1] - start[1]).abs() < 1e-13);
/// }
///
/// // with a shorter coupler the crank comes as far as cos(theta2) = (r1² + r2² - (r3 + r4)²) / (2 r1 r2)
/// let (r1, r2, r3, r4) = (90.0_f64, 30.0, 60.0, 45.0);
/// let linkage = FourBar { r1, r2, r3, r4 };
/// let start = linkage.position(0.5, Assembly::Open)?.unknowns();
/// let Err(TrackError::Limit(limit)) = track(&linkage, [0.5], start, [3.0]) else {
///     panic!("the links do not reach");
/// };
/// let expected = ((r1 * r1 + r2 * r2 - (r3 + r4) * (r3 + r4)) / (2.0 * r1 * r2)).acos();
/// assert!((limit.inputs[0] - expected).abs() < 1e-14);
/// // where coupler and rocker are in line
/// assert!((limit.unknowns[0] - limit.unknowns[1] + core::f64::consts::PI).abs() < 1e-12);
/// assert_eq!(limit.block, "theta3, theta4");
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias = "simulate")]
#[doc(alias = "continuation")]
pub fn track<M: Mechanism>(
    mechanism: &M,
    from_inputs: M::Inputs<M::Scalar>,
    from_unknowns: M::Unknowns<M::Scalar>,
    to_inputs: M::Inputs<M::Scalar>,
) -> Result<M::Unknowns<M::Scalar>, TrackErrorOf<M>> {
    let end = end(mechanism, (from_inputs, from_unknowns), to_inputs)?;
    Ok(mechanism.solve_position_near(to_inputs, end)?)
}

/// [`track`] from a pose, where the caller solves the last position once, as the type it needs. `arrive` takes unknowns
/// that are close to it.
///
/// # Errors
/// Returns the errors of [`track`], and the error of `arrive`.
pub fn track_to<M: Mechanism, P>(
    mechanism: &M,
    pose: &impl PoseOf<M>,
    to_inputs: M::Inputs<M::Scalar>,
    arrive: impl FnOnce(M::Unknowns<M::Scalar>) -> Result<P, SolveError>,
) -> Result<P, TrackErrorOf<M>> {
    let end = end(mechanism, pose.values(), to_inputs)?;
    Ok(arrive(end)?)
}

/// The unknowns at the end of the track, before the last position is solved.
fn end<M: Mechanism>(
    mechanism: &M,
    (from_inputs, from_unknowns): (M::Inputs<M::Scalar>, M::Unknowns<M::Scalar>),
    to_inputs: M::Inputs<M::Scalar>,
) -> Result<M::Unknowns<M::Scalar>, TrackErrorOf<M>> {
    let end = follow(
        mechanism.convert(Number::real),
        Row::from_fn(|index| from_inputs[index].real()),
        Row::from_fn(|index| from_unknowns[index].real()),
        Row::from_fn(|index| to_inputs[index].real()),
    )
    .map_err(retyped::<M>)?;
    Ok(Row::from_fn(|index| M::Scalar::constant(end[index])))
}

/// The error with rows of the mechanism instead of rows of its double-precision version. Both are the same arrays.
fn retyped<M: Mechanism>(error: TrackErrorOf<M::With<f64>>) -> TrackErrorOf<M> {
    let convert = |obstacle: ObstacleOf<M::With<f64>>| Obstacle {
        block: obstacle.block,
        fraction: obstacle.fraction,
        inputs: Row::from_fn(|index| obstacle.inputs[index]),
        unknowns: Row::from_fn(|index| obstacle.unknowns[index]),
        names: obstacle.names,
    };
    let stopped = |halt: HaltOf<M::With<f64>>| Halt {
        steps: halt.steps,
        fraction: halt.fraction,
        inputs: Row::from_fn(|index| halt.inputs[index]),
        unknowns: Row::from_fn(|index| halt.unknowns[index]),
        rounding: halt.rounding,
        names: halt.names,
    };
    match error {
        TrackError::Limit(obstacle) => TrackError::Limit(convert(obstacle)),
        TrackError::ChangePoint(obstacle) => TrackError::ChangePoint(convert(obstacle)),
        TrackError::Unbounded(obstacle) => TrackError::Unbounded(convert(obstacle)),
        TrackError::TooManySteps(halt) => TrackError::TooManySteps(stopped(halt)),
        TrackError::Lost(halt) => TrackError::Lost(stopped(halt)),
        TrackError::Failed(error) => TrackError::Failed(error),
    }
}

/// A point of the track and everything known there.
#[derive(Clone, Copy)]
struct TrackPoint<M: Mechanism> {
    point: WayPoint<M>,
    /// The unknowns in all orders, with angles on the turns they have reached.
    motions: M::Unknowns<M::Motion<f64>>,
    /// The sizes of the unknowns at this station.
    sizes: M::Unknowns<f64>,
    sides: Sides<M>,
}

/// The reason why there is no station.
enum Missing {
    Unsolved(SolveError),
    /// The closure is not finite, or the solution belongs to another branch.
    Elsewhere,
}

fn follow<M: Mechanism<Scalar = f64>>(
    mechanism: M,
    from: M::Inputs<f64>,
    near: M::Unknowns<f64>,
    to: M::Inputs<f64>,
) -> Result<M::Unknowns<f64>, TrackErrorOf<M>> {
    let start = mechanism.solve_position_near(from, near)?;
    let way = Way::new(mechanism, from, &start, to);
    if !way.length.is_finite() {
        // The solver reports best which input is wrong.
        mechanism.solve_position_near(to, start)?;
        return Err(TrackError::Failed(lost::<M>(
            0,
            Failure::NotFinite {
                quantity: "way of the inputs",
            },
        )));
    }
    if way.length == 0.0 {
        return Ok(start);
    }
    let mut here = station(&way, 0.0, start).map_err(|missing| match missing {
        Missing::Unsolved(error) => error,
        Missing::Elsewhere => lost::<M>(
            0,
            Failure::NotFinite {
                quantity: "closure at the beginning",
            },
        ),
    })?;
    let assembly = mechanism.assembly_near(from, start);
    let beginning = here.sides;
    let mut anchor = here;
    let mut longest = LONGEST;
    let mut steps = Steps::NONE;
    // Whether following an unknown as parameter has led nowhere since the unknowns became fast.
    let mut is_lost = false;
    let mut creeping = 0;
    loop {
        let trusted = trusted(&here).min(longest);
        let rate = largest(rates(&here, &here.sizes).as_ref().iter().copied());
        if rate <= FAST {
            is_lost = false;
        }
        // A fast and straight motion, for example behind a gear, is not near a limit.
        if rate > FAST && rate * trusted < LONGEST && !is_lost {
            match round_the_turn(&way, &here, &anchor, &beginning, &mut steps)? {
                Arrival::Station(there) if there.point.travel > here.point.travel => {
                    (here, anchor, longest, creeping) = (there, there, LONGEST, 0);
                    continue;
                }
                Arrival::End(unknowns) => return Ok(unknowns),
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
                return Err(TrackError::TooManySteps(halt(&way, &here.point, &steps)));
            }
            let is_last = step >= rest;
            let travel = if is_last { way.length } else { here.point.travel + step };
            match attempted(&way, &here, travel) {
                Ok(there) if has(&mechanism, &way, &there, assembly) => {
                    if is_last {
                        return Ok(there.point.unknowns);
                    }
                    break Some(there);
                }
                Ok(_) | Err(Missing::Elsewhere) => {}
                Err(Missing::Unsolved(reason)) => error = Some(reason),
            }
            step = 0.5 * step.min(rest);
        };
        let Some(there) = there else {
            match round_the_turn(&way, &here, &anchor, &beginning, &mut steps)? {
                // Do not continue if it only creeps through the neighbourhood of a change point.
                Arrival::Station(there) if there.point.travel > here.point.travel + BLUR => {
                    (here, anchor, longest, creeping) = (there, there, LONGEST, 0);
                    continue;
                }
                Arrival::End(unknowns) => return Ok(unknowns),
                _ => return Err(blocked(&way, &here, &anchor, &beginning, error, &steps)),
            }
        };
        // Rounding errors separate the branches that cross here, so there seems to be a way around the crossing.
        if step < BLUR && is_crossed(&way, &there.point, turning::fastest(&rates(&there, &way.sizes))) {
            return Err(crossed_near(&way, &there.point, &there.sides, &anchor, &beginning));
        }
        creeping = if step < CREEPING * way.length.min(1.0) {
            creeping + 1
        } else {
            0
        };
        longest = LONGEST.min(2.0 * step);
        if step > ANCHOR {
            anchor = there;
        }
        here = there;
    }
}

/// The mechanism at a given travel, close to given unknowns.
fn station<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    travel: f64,
    near: M::Unknowns<f64>,
) -> Result<TrackPoint<M>, Missing> {
    let pose = way
        .mechanism
        .solve_motion_near(way.motions(travel), near)
        .map_err(Missing::Unsolved)?;
    let turns = Row::from_fn(|index| near[index]);
    let motions = pose.unknown_motions_near(turns);
    let point = WayPoint {
        unknowns: M::Unknowns::from_fn(|index| motions[index][0]),
        travel,
    };
    let linear: Linear<M> = way.linearise(&point).ok_or(Missing::Elsewhere)?;
    Ok(TrackPoint {
        point,
        motions,
        sizes: way.sizes_at(&point),
        sides: Sides::of(&linear),
    })
}

/// The station at the end of a step, if it certainly lies on the same branch and nothing happens in between.
fn attempted<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    here: &TrackPoint<M>,
    travel: f64,
) -> Result<TrackPoint<M>, Missing> {
    let step = travel - here.point.travel;
    for part in [0.25, 0.5, 0.75, 1.0] {
        let (unknowns, _) = predicted(here, part * step);
        let point = WayPoint {
            unknowns,
            travel: here.point.travel + part * step,
        };
        let linear = way.linearise(&point).ok_or(Missing::Elsewhere)?;
        if !Sides::of(&linear).are_near(&here.sides) {
            return Err(Missing::Elsewhere);
        }
    }
    let (near, foreseen) = predicted(here, step);
    let there = station(way, travel, near)?;
    let pairs = there.point.unknowns.as_ref().iter().zip(near.as_ref());
    let distance = largest(
        pairs
            .zip(here.sizes.as_ref())
            .map(|((one, other), size)| (one - other) / size),
    );
    let rates = rates(&there, &here.sizes);
    let pairs = rates.as_ref().iter().zip(foreseen.as_ref());
    let turn = largest(pairs.map(|(one, other)| one - other));
    let scale = largest(rates.as_ref().iter().copied()).max(1.0);
    // A correction must also be small compared with the step, or it could lead to a neighbouring branch.
    let far = there.point.unknowns.as_ref().iter().zip(here.sizes.as_ref());
    let ulps = 64.0 * f64::EPSILON * largest(far.map(|(value, size)| value / size)).max(1.0);
    let allowed = CORRECTION * (step * scale).min(1.0) + ulps;
    let is_same = turn <= 5.0 * CORRECTION * scale
        && there.sides.are_near(&here.sides)
        && (distance <= allowed || {
            // Rounding beyond the limit of a correction would excuse any difference.
            let blur = blur(way, &there.point);
            blur <= CORRECTION && distance <= allowed + blur
        });
    if is_same { Ok(there) } else { Err(Missing::Elsewhere) }
}

/// Whether a station belongs to the given assembly. Assemblies that depend on the dimensions have no names to compare;
/// the determinants distinguish them.
fn has<M: Mechanism<Scalar = f64>>(mechanism: &M, way: &Way<M>, there: &TrackPoint<M>, assembly: M::Assembly) -> bool {
    M::ASSEMBLY_COUNT == 0 || mechanism.assembly_near(way.inputs(there.point.travel), there.point.unknowns) == assembly
}

/// The first derivatives with respect to the travel, in units of the given sizes.
fn rates<M: Mechanism<Scalar = f64>>(here: &TrackPoint<M>, sizes: &M::Unknowns<f64>) -> M::Unknowns<f64> {
    let motions = here.motions;
    M::Unknowns::from_fn(|index| {
        let rate = motions[index].as_ref().get(1).copied().unwrap_or(0.0);
        rate / sizes[index]
    })
}

/// The unknowns after a step by Taylor's series, and their rates in the sizes before the step.
fn predicted<M: Mechanism<Scalar = f64>>(here: &TrackPoint<M>, step: f64) -> (M::Unknowns<f64>, M::Unknowns<f64>) {
    let motions = here.motions;
    let series = |index: usize, lowest: usize| {
        // Horner's scheme for the sum of derivative · stepⁿ / n!.
        let derivatives = &motions[index].as_ref()[lowest..];
        let mut order = f64::from(u32::try_from(derivatives.len()).unwrap_or(u32::MAX));
        derivatives.iter().rev().fold(0.0, |sum, derivative| {
            let value = derivative + sum * step / order;
            order -= 1.0;
            value
        })
    };
    (
        M::Unknowns::from_fn(|index| series(index, 0)),
        M::Unknowns::from_fn(|index| series(index, 1) / here.sizes[index]),
    )
}

/// The step after which the last two terms of the series are small. The first order is straight and does not count. For
/// a series without other orders, only the comparison with the solution limits the step.
fn trusted<M: Mechanism<Scalar = f64>>(here: &TrackPoint<M>) -> f64 {
    let motions = here.motions;
    let mut step = f64::INFINITY;
    for (motion, size) in motions.as_ref().iter().zip(here.sizes.as_ref()) {
        let derivatives = motion.as_ref();
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

/// The result of following the curve of solutions with an unknown as its parameter.
enum Arrival<M: Mechanism> {
    /// A station from which steps of the inputs continue.
    Station(TrackPoint<M>),
    /// The end of the track.
    End(M::Unknowns<f64>),
    /// No result.
    None,
}

fn round_the_turn<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    here: &TrackPoint<M>,
    anchor: &TrackPoint<M>,
    beginning: &Sides<M>,
    steps: &mut Steps,
) -> Result<Arrival<M>, TrackErrorOf<M>> {
    match turning::pass(way, here.point, &rates(here, &way.sizes), steps) {
        Passage::Onwards(point) => {
            Ok(station(way, point.travel, point.unknowns).map_or(Arrival::None, Arrival::Station))
        }
        Passage::Target(unknowns) => Ok(Arrival::End(unknowns)),
        Passage::Limit(point, sides) => Err(TrackError::Limit(obstacle(way, &point, &sides, beginning))),
        Passage::ChangePoint(point, sides) => Err(crossed_near(way, &point, &sides, anchor, beginning)),
        Passage::Lost => Ok(Arrival::None),
        Passage::Spent(point) => Err(TrackError::TooManySteps(halt(way, &point, steps))),
    }
}

/// A failure of a block that no solver has reported.
fn lost<M: Mechanism>(block: usize, failure: Failure) -> SolveError {
    let block = name::<M>(block);
    failure.at(block, InputValues::new(&[], &[]))
}

/// The names of the unknowns of a block.
fn name<M: Mechanism>(block: usize) -> &'static str {
    M::DESCRIPTION.blocks.get(block).map_or("", |block| block.unknowns)
}
