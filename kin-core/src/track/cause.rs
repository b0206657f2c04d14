//! The causes that stop a track.

use super::obstacle::FIRM;
use super::rounding::{blur, is_indistinct};
use super::sides::Sides;
use super::steps::Steps;
use super::way::{Way, WayPoint, largest};
use super::{
    ANCHOR, BLUR, FAR, Halt, Obstacle, ObstacleOf, SECANTS, TrackError, TrackErrorOf, TrackPoint, predicted, rates,
};
use crate::failure::{Failure, SolveError};
use crate::mechanism::Mechanism;
use crate::number::Row;
use crate::quantity::Dimension;

/// The largest difference of the unknowns between the last station and the change point behind it.
const BESIDE: f64 = 0.05;
/// The number of bisections that locates a point to the last digit.
const BISECTIONS: usize = 64;

/// A change point. It is a limit instead if several blocks reach their limits at once, so that nothing continues
/// beyond.
fn crossed_or_ended<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    point: &WayPoint<M>,
    sides: &Sides<M>,
    beginning: &Sides<M>,
) -> TrackErrorOf<M> {
    let obstacle = obstacle(way, point, sides, beginning);
    if is_out_of_reach(way, point) {
        TrackError::Limit(obstacle)
    } else {
        TrackError::ChangePoint(obstacle)
    }
}

/// The change point to which ever shorter steps lead. It is located from an earlier station if that is more exact.
pub(super) fn crossed_near<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    near: &WayPoint<M>,
    sides: &Sides<M>,
    anchor: &TrackPoint<M>,
    beginning: &Sides<M>,
) -> TrackErrorOf<M> {
    let (point, sides) = crossing(way, near, anchor).unwrap_or((*near, *sides));
    crossed_or_ended(way, &point, &sides, beginning)
}

/// Whether the links are out of reach beyond a point.
fn is_out_of_reach<M: Mechanism<Scalar = f64>>(way: &Way<M>, point: &WayPoint<M>) -> bool {
    [ANCHOR, 0.1 * ANCHOR].into_iter().all(|beyond| {
        let inputs = way.inputs(point.travel + beyond);
        let failure = way.mechanism.solve_position_near(inputs, point.unknowns).err();
        matches!(failure, Some(error) if matches!(error.failure, Failure::OutOfReach { .. }))
    })
}

/// The cause where no step succeeds, however short. `error` is the last error of the solvers.
pub(super) fn blocked<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    here: &TrackPoint<M>,
    anchor: &TrackPoint<M>,
    beginning: &Sides<M>,
    error: Option<SolveError>,
    steps: &Steps,
) -> TrackErrorOf<M> {
    if let Some(obstacle) = pole(way, here) {
        return TrackError::Unbounded(obstacle);
    }
    if let Some(error) = end_of_domain(way, here) {
        return TrackError::Failed(error);
    }
    if let Some((point, sides)) = crossing(way, &here.point, anchor) {
        return crossed_or_ended(way, &point, &sides, beginning);
    }
    let is_range = |failure: &Failure| matches!(failure, Failure::OutOfRange { .. } | Failure::Ambiguous { .. });
    if let Some((_, error)) = first_failure(way, here, |error| is_range(&error.failure)) {
        return TrackError::Failed(error);
    }
    if let Some(error) = end_of_closure(way, here) {
        return TrackError::Failed(error);
    }
    let is_firm = blur(way, &here.point) < FIRM;
    if is_firm && is_indistinct(way, &here.point) {
        return crossed_or_ended(way, &here.point, &here.sides, beginning);
    }
    match error {
        Some(error) if is_firm => TrackError::Failed(error),
        _ => TrackError::Lost(halt(way, &here.point, steps)),
    }
}

/// The place at which an unknown goes to infinity, if it is close.
fn pole<M: Mechanism<Scalar = f64>>(way: &Way<M>, here: &TrackPoint<M>) -> Option<ObstacleOf<M>> {
    let values = here.point.unknowns;
    let grown = |index: &usize| values[*index].abs() / way.sizes[*index];
    let index = (0..Way::<M>::COUNT).max_by(|one, other| grown(one).total_cmp(&grown(other)))?;
    let is_angle = M::DESCRIPTION.unknowns[index].dimension == Dimension::Angle;
    // The zero of the reciprocal.
    let distance = values[index] / here.motions[index].as_ref().get(1)?;
    if is_angle || grown(&index) < FAR || !(0.0..=BLUR).contains(&distance) {
        return None;
    }
    // Halfway to a pole an unknown grows to more than 1.6 times its value. At a fold of the same rate, the path has
    // ended there.
    let inputs = way.inputs(here.point.travel + 0.5 * distance);
    let halfway = way.mechanism.solve_position_near(inputs, values).ok()?;
    if halfway[index].abs() < 1.5 * values[index].abs() {
        return None;
    }
    let block = M::DESCRIPTION
        .blocks
        .iter()
        .position(|block| block.members.contains(&index))?;
    let travel = here.point.travel + distance;
    Some(Obstacle {
        block: super::name::<M>(block),
        fraction: (travel / way.length).min(1.0),
        inputs: way.inputs(travel),
        unknowns: values,
        names: M::DESCRIPTION.inputs,
    })
}

/// The error of the first place close ahead that lies outside the domain of a function.
fn end_of_domain<M: Mechanism<Scalar = f64>>(way: &Way<M>, here: &TrackPoint<M>) -> Option<SolveError> {
    let is_outside = |error: &SolveError| matches!(error.failure, Failure::OutsideDomain { .. });
    let is_of_a_block = |error: &SolveError| M::DESCRIPTION.blocks.iter().any(|block| block.unknowns == error.block);
    let (travel, error) = first_failure(way, here, is_outside)?;
    if is_of_a_block(&error) {
        return Some(error);
    }
    // The rates may compute a root again by another formula, whose domain ends slightly earlier because of rounding.
    // The block itself is the cause.
    match first_failure(way, here, |error| is_outside(error) && is_of_a_block(error)) {
        Some((block_travel, cause)) if block_travel - travel <= 8.0 * way.shortest() => Some(cause),
        _ => Some(error),
    }
}

/// The first place close ahead at which the solvers fail in a given way, to the last digit of the inputs, and its
/// error.
fn first_failure<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    here: &TrackPoint<M>,
    is_wanted: impl Fn(&SolveError) -> bool,
) -> Option<(f64, SolveError)> {
    let error_at = |travel: f64| {
        let solved = way
            .mechanism
            .solve_motion_near(way.motions(travel), here.point.unknowns);
        solved.err().filter(&is_wanted)
    };
    let mut low = here.point.travel;
    let (mut high, mut error) = ahead(way, here).find_map(|travel| {
        let error = error_at(travel);
        if error.is_none() {
            low = travel;
        }
        error.map(|error| (travel, error))
    })?;
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        if way.are_same(low, middle) || way.are_same(middle, high) {
            break;
        }
        match error_at(middle) {
            Some(nearer) => (high, error) = (middle, nearer),
            None => low = middle,
        }
    }
    Some((high, error))
}

/// Places ahead at growing distances, all of them close.
fn ahead<M: Mechanism<Scalar = f64>>(way: &Way<M>, here: &TrackPoint<M>) -> impl Iterator<Item = f64> {
    let (start, end, shortest) = (here.point.travel, way.length, way.shortest());
    let steps = core::iter::successors(Some(shortest), |step| Some(4.0 * step));
    let steps = steps.take_while(move |step| *step <= BLUR.max(256.0 * shortest));
    steps.map(move |step| end.min(start + step))
}

/// The error of a block solved by Newton's method at the end of the domain of a function of its unknowns: ahead of it
/// the closure is not finite, and the solvers find nothing.
fn end_of_closure<M: Mechanism<Scalar = f64>>(way: &Way<M>, here: &TrackPoint<M>) -> Option<SolveError> {
    let rates = rates(here, &M::Unknowns::splat(1.0));
    ahead(way, here).find_map(|travel| {
        // Near such an end the higher terms of a series are useless.
        let along = |index: usize| rates[index] * (travel - here.point.travel);
        let unknowns = M::Unknowns::from_fn(|index| here.point.unknowns[index] + along(index));
        if way.linearise(&WayPoint { unknowns, travel }).is_some() {
            return None;
        }
        let error = way.mechanism.solve_motion_near(way.motions(travel), unknowns).err()?;
        let failure = Failure::NotFinite {
            quantity: "closure ahead, where the domain of a function of the unknowns ends",
        };
        Some(failure.at(error.block, error.inputs))
    })
}

/// The change point near a point, if there is one.
///
/// Where two branches cross, both are smooth, and a determinant passes through zero at a finite rate. Close to the
/// crossing, rounding mixes up the branches, so the determinant is followed along the Taylor series of an earlier
/// station.
fn crossing<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    near: &WayPoint<M>,
    anchor: &TrackPoint<M>,
) -> Option<(WayPoint<M>, Sides<M>)> {
    let travel = near.travel;
    let at = |step: f64| {
        let (unknowns, _) = predicted(anchor, step);
        let travel = anchor.point.travel + step;
        let point = WayPoint { unknowns, travel };
        let linear = way.linearise(&point)?;
        Some((point, Sides::of(&linear)))
    };
    let mut step = travel - anchor.point.travel;
    if step == 0.0 {
        step = way.shortest();
    }
    let (_, sides) = at(step)?;
    let (block, _) = sides.most_shrunk(&anchor.sides);
    let (mut previous, mut value_before) = (0.0, 1.0);
    for _ in 0..SECANTS {
        let (point, sides) = at(step)?;
        let value = sides.relative(&anchor.sides, block);
        let change = value * (step - previous) / (value_before - value);
        if value == 0.0 || change.abs() <= f64::EPSILON * way.length.max(1.0) {
            return is_beside(way, &point, near).then_some((point, sides));
        }
        (previous, value_before) = (step, value);
        step += change;
        if !step.is_finite() {
            break;
        }
    }
    None
}

/// Whether an extrapolated point is so close to another point that it is what blocks the path there.
fn is_beside<M: Mechanism<Scalar = f64>>(way: &Way<M>, point: &WayPoint<M>, here: &WayPoint<M>) -> bool {
    let pairs = point.unknowns.as_ref().iter().zip(here.unknowns.as_ref());
    let sizes = way.sizes_at(here);
    let distances = pairs
        .zip(sizes.as_ref())
        .map(|((one, other), size)| (one - other) / size);
    (point.travel - here.travel).abs() <= BLUR && largest(distances) <= BESIDE
}

pub(super) fn obstacle<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    point: &WayPoint<M>,
    sides: &Sides<M>,
    beginning: &Sides<M>,
) -> ObstacleOf<M> {
    let (block, _) = sides.most_shrunk(beginning);
    Obstacle {
        block: super::name::<M>(block),
        fraction: (point.travel / way.length).clamp(0.0, 1.0),
        inputs: way.inputs(point.travel),
        unknowns: point.unknowns,
        names: M::DESCRIPTION.inputs,
    }
}

/// The place where the track stopped.
pub(super) fn halt<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    point: &WayPoint<M>,
    steps: &Steps,
) -> Halt<M::Inputs<f64>, M::Unknowns<f64>> {
    Halt {
        steps: steps.taken(),
        fraction: (point.travel / way.length).clamp(0.0, 1.0),
        inputs: way.inputs(point.travel),
        unknowns: point.unknowns,
        rounding: blur(way, point),
        names: M::DESCRIPTION.inputs,
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::super::station;
    use super::*;
    use crate::assembly::Assembly;
    use crate::failure::InputValues;
    use crate::library::FourBar;

    /// Tested places lie ahead at growing distances, close, and not beyond the end.
    #[test]
    fn places_ahead_are_near_by() {
        let linkage = FourBar {
            r1: 90.0,
            r2: 30.0,
            r3: 70.0,
            r4: 60.0,
        };
        let start = linkage.solve_position([0.5], Assembly::Open).unwrap();
        let way = Way::new(linkage, [0.5], &start, [1.5]);
        let from = |travel: f64| -> Vec<f64> {
            let unknowns = linkage.solve_position(way.inputs(travel), Assembly::Open).unwrap();
            let here = station(&way, travel, unknowns).ok().expect("the linkage closes there");
            ahead(&way, &here).collect()
        };
        let places = from(0.25);
        assert_eq!(places[0], 0.25 + way.shortest());
        assert!(places.windows(2).all(|pair| pair[0] < pair[1]), "{places:?}");
        let last = places[places.len() - 1] - 0.25;
        assert!(last > 0.2 * BLUR && last < 1.01 * BLUR, "{places:?}");

        let places = from(way.length - 1e-9);
        assert!(places.iter().all(|place| *place <= way.length), "{places:?}");
        assert_eq!(places[places.len() - 1], way.length);
    }

    /// If rounding moves nothing and no obstacle exists, the track returns the solver's own error.
    #[test]
    fn an_error_that_nothing_explains_is_told_as_it_is() {
        let linkage = FourBar {
            r1: 90.0,
            r2: 30.0,
            r3: 70.0,
            r4: 60.0,
        };
        let start = linkage.solve_position([0.5], Assembly::Open).unwrap();
        let way = Way::new(linkage, [0.5], &start, [1.5]);
        let here = station(&way, 0.0, start).ok().expect("the linkage closes there");
        let failure = Failure::NotFinite { quantity: "something" };
        let error = failure.at(
            "theta3, theta4",
            InputValues::new(FourBar::<f64>::DESCRIPTION.inputs, &[0.5]),
        );
        let blocked = |error| blocked(&way, &here, &here, &here.sides, error, &Steps::NONE);
        assert_eq!(blocked(Some(error)), TrackError::Failed(error));
        let none = blocked(None);
        assert!(
            matches!(&none, TrackError::Lost(halt) if halt.inputs == [0.5] && halt.rounding < FIRM),
            "{none:?}"
        );
    }
}
