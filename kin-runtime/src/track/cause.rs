//! The causes that stop a track.

use super::follow::{ANCHOR, BLUR, Ended, GROWTH_TO_POLE, SECANTS, TrackPoint};
use super::line::TrackLine;
use super::obstacle::{FIRM, TrackError, TrackLimit, TrackStop};
use super::steps::Steps;
use crate::curve::{LentRows, Sides, Way, WayPoint, blur, is_indistinct, largest};
use crate::failure::{Failure, SolveError};
use crate::quantity::Dimension;

/// The largest difference of the unknowns between the last station and the change point behind it.
const BESIDE: f64 = 0.05;
/// The number of bisections that locates a point to the last digit.
const BISECTIONS: usize = 64;

/// A change point. It is a limit instead if several blocks reach their limits at once, so that nothing continues
/// beyond.
fn crossed_or_ended(
    way: &TrackLine<'_>,
    point: WayPoint<'_>,
    sides: &Sides<'_>,
    beginning: &Sides<'_>,
    scratch: &mut LentRows<'_>,
) -> Ended {
    let obstacle = obstacle(way, point, sides, beginning);
    if is_out_of_reach(way, point, scratch) {
        TrackError::TurningPoint(obstacle)
    } else {
        TrackError::ChangePoint(obstacle)
    }
}

/// The change point to which ever shorter steps lead. It is located from an earlier station if that is more exact.
pub(super) fn crossed_near(
    way: &TrackLine<'_>,
    near: WayPoint<'_>,
    sides: Sides<'_>,
    anchor: &TrackPoint<'_>,
    beginning: &Sides<'_>,
    scratch: &mut LentRows<'_>,
) -> Ended {
    let mut scope = scratch.scope();
    match crossing(way, near, anchor, &mut scope) {
        Some((point, sides)) => crossed_or_ended(way, point, &sides, beginning, &mut scope),
        None => crossed_or_ended(way, near, &sides, beginning, &mut scope),
    }
}

/// Whether the links are out of reach beyond a point.
fn is_out_of_reach(way: &Way<'_>, point: WayPoint<'_>, scratch: &mut LentRows<'_>) -> bool {
    [ANCHOR, 0.1 * ANCHOR].into_iter().all(|beyond| {
        let mut scope = scratch.scope();
        let found = way.position_near(point.travel + beyond, point.unknowns, &mut scope);
        matches!(found.err(), Some(error) if matches!(error.failure, Failure::OutOfReach { .. }))
    })
}

/// The cause where no step succeeds, however short. `error` is the last error of the solvers.
pub(super) fn blocked(
    way: &TrackLine<'_>,
    here: &TrackPoint<'_>,
    anchor: &TrackPoint<'_>,
    beginning: &Sides<'_>,
    error: Option<SolveError>,
    steps: &Steps,
    scratch: &mut LentRows<'_>,
) -> Ended {
    if let Some(obstacle) = pole(way, here, scratch) {
        return TrackError::Pole(obstacle);
    }
    if let Some(error) = end_of_domain(way, here, scratch) {
        return TrackError::Failed(error);
    }
    let mut scope = scratch.scope();
    if let Some((point, sides)) = crossing(way, here.point, anchor, &mut scope) {
        return crossed_or_ended(way, point, &sides, beginning, &mut scope);
    }
    let is_range = |failure: &Failure| matches!(failure, Failure::OutOfRange { .. } | Failure::Ambiguous { .. });
    if let Some((_, error)) = first_failure(way, here, &mut scope, |error| is_range(&error.failure)) {
        return TrackError::Failed(error);
    }
    if let Some(error) = end_of_closure(way, here, &mut scope) {
        return TrackError::Failed(error);
    }
    let is_firm = blur(way, here.point, &mut scope) < FIRM;
    if is_firm && is_indistinct(way, here.point, &mut scope) {
        return crossed_or_ended(way, here.point, &here.sides, beginning, &mut scope);
    }
    match error {
        Some(error) if is_firm => TrackError::Failed(error),
        _ => TrackError::Lost(stop(way, here.point, steps, &mut scope)),
    }
}

/// The point at which an unknown goes to infinity, if it is close.
fn pole(way: &TrackLine<'_>, here: &TrackPoint<'_>, scratch: &mut LentRows<'_>) -> Option<TrackLimit<(), ()>> {
    let values = here.point.unknowns;
    let grown = |index: &usize| values[*index].abs() / way.sizes[*index];
    let index = (0..way.count()).max_by(|one, other| grown(one).total_cmp(&grown(other)))?;
    let is_angle = way.description.unknowns[index].dimension == Dimension::Angle;
    if way.description.order == 0 {
        return None;
    }
    // The zero of the reciprocal.
    let distance = values[index] / here.rate(index);
    if is_angle || grown(&index) < GROWTH_TO_POLE || !(0.0..=BLUR).contains(&distance) {
        return None;
    }
    // Halfway to a pole an unknown grows to more than 1.6 times its value. At a fold of the same rate, the path has
    // ended there.
    let mut scope = scratch.scope();
    let halfway = way.position_near(here.point.travel + 0.5 * distance, values, &mut scope);
    if halfway.ok()?[index].abs() < 1.5 * values[index].abs() {
        return None;
    }
    let blocks = &way.description.blocks;
    let block = blocks.iter().position(|block| block.members.contains(&index))?;
    let travel = here.point.travel + distance;
    let point = WayPoint {
        unknowns: values,
        travel,
    };
    way.end_at(point);
    Some(TrackLimit {
        block: way.block(block),
        fraction: (travel / way.length).min(1.0),
        inputs: (),
        unknowns: (),
        names: way.mechanism.input_names(),
    })
}

/// The error of the first point close ahead that lies outside the domain of a function.
fn end_of_domain(way: &Way<'_>, here: &TrackPoint<'_>, scratch: &mut LentRows<'_>) -> Option<SolveError> {
    let is_outside = |error: &SolveError| matches!(error.failure, Failure::OutsideDomain { .. });
    let blocks = 0..way.description.blocks.len();
    let is_of_a_block = |error: &SolveError| blocks.clone().any(|block| error.block == way.block(block));
    let (travel, error) = first_failure(way, here, scratch, is_outside)?;
    if is_of_a_block(&error) {
        return Some(error);
    }
    // The rates may compute a root again by another formula, whose domain ends slightly earlier because of rounding.
    // The block itself is the cause.
    match first_failure(way, here, scratch, |error| is_outside(error) && is_of_a_block(error)) {
        Some((block_travel, cause)) if block_travel - travel <= 8.0 * way.shortest() => Some(cause),
        _ => Some(error),
    }
}

/// The first point close ahead at which the solvers fail in a given way, to the last digit of the inputs, and its
/// error.
fn first_failure(
    way: &Way<'_>,
    here: &TrackPoint<'_>,
    scratch: &mut LentRows<'_>,
    is_wanted: impl Fn(&SolveError) -> bool,
) -> Option<(f64, SolveError)> {
    let mut error_at = |travel: f64| {
        let mut scope = scratch.scope();
        let solved = way.motions_near(travel, here.point.unknowns, &mut scope);
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

/// Points ahead at growing distances, all of them close.
fn ahead(way: &Way<'_>, here: &TrackPoint<'_>) -> impl Iterator<Item = f64> + use<> {
    let (start, end, shortest) = (here.point.travel, way.length, way.shortest());
    let steps = core::iter::successors(Some(shortest), |step| Some(4.0 * step));
    let steps = steps.take_while(move |step| *step <= BLUR.max(256.0 * shortest));
    steps.map(move |step| end.min(start + step))
}

/// The error of a block solved by Newton's method at the end of the domain of a function of its unknowns: ahead of it
/// the closure is not finite, and the solvers find nothing.
fn end_of_closure(way: &Way<'_>, here: &TrackPoint<'_>, scratch: &mut LentRows<'_>) -> Option<SolveError> {
    ahead(way, here).find_map(|travel| {
        let mut scope = scratch.scope();
        // Near such an end the higher terms of a series are useless.
        let along = |index: usize| here.rate(index) * (travel - here.point.travel);
        let unknowns = scope.row(way.count(), |index| here.point.unknowns[index] + along(index));
        if way.linearise(WayPoint { unknowns, travel }, &mut scope).is_some() {
            return None;
        }
        let error = way.motions_near(travel, unknowns, &mut scope).err()?;
        let failure = Failure::NotFinite {
            quantity: "closure ahead, where the domain of a function of the unknowns ends".into(),
        };
        Some(failure.at(error.block, error.inputs))
    })
}

/// The change point near a point, if there is one.
///
/// Where two branches cross, both are smooth, and a determinant passes through zero at a finite rate. Close to the
/// crossing, rounding mixes up the branches, so the determinant is followed along the Taylor series of an earlier
/// station.
fn crossing<'s>(
    way: &Way<'_>,
    near: WayPoint<'_>,
    anchor: &TrackPoint<'_>,
    scratch: &mut LentRows<'s>,
) -> Option<(WayPoint<'s>, Sides<'s>)> {
    let mut step = near.travel - anchor.point.travel;
    if step == 0.0 {
        step = way.shortest();
    }
    let (block, _) = determinants(way, anchor, step, &mut scratch.scope())?
        .1
        .most_shrunk(&anchor.sides);
    let (mut previous, mut value_before) = (0.0, 1.0);
    for _ in 0..SECANTS {
        let (_, sides) = determinants(way, anchor, step, &mut scratch.scope())?;
        let value = sides.relative(&anchor.sides, block);
        let change = value * (step - previous) / (value_before - value);
        if value == 0.0 || change.abs() <= f64::EPSILON * way.length.max(1.0) {
            let (point, sides) = determinants(way, anchor, step, scratch)?;
            return is_beside(way, point, near).then_some((point, sides));
        }
        (previous, value_before) = (step, value);
        step += change;
        if !step.is_finite() {
            break;
        }
    }
    None
}

/// The determinants after a step along the Taylor series of a station, and the point there.
fn determinants<'s>(
    way: &Way<'_>,
    from: &TrackPoint<'_>,
    step: f64,
    scratch: &mut LentRows<'s>,
) -> Option<(WayPoint<'s>, Sides<'s>)> {
    let unknowns = from.predicted(step, scratch);
    let travel = from.point.travel + step;
    let point = WayPoint { unknowns, travel };
    let linear = way.linearise(point, scratch)?;
    Some((point, Sides::of(way, &linear, scratch)))
}

/// Whether an extrapolated point is so close to another point that it is what blocks the path there.
fn is_beside(way: &Way<'_>, point: WayPoint<'_>, here: WayPoint<'_>) -> bool {
    let differences = (0..way.count()).map(|index| {
        let size = way.size_at(here.unknowns, index);
        (point.unknowns[index] - here.unknowns[index]) / size
    });
    (point.travel - here.travel).abs() <= BLUR && largest(differences) <= BESIDE
}

pub(super) fn obstacle(
    way: &TrackLine<'_>,
    point: WayPoint<'_>,
    sides: &Sides<'_>,
    beginning: &Sides<'_>,
) -> TrackLimit<(), ()> {
    let (block, _) = sides.most_shrunk(beginning);
    way.end_at(point);
    TrackLimit {
        block: way.block(block),
        fraction: (point.travel / way.length).clamp(0.0, 1.0),
        inputs: (),
        unknowns: (),
        names: way.mechanism.input_names(),
    }
}

/// The point where the track stopped.
pub(super) fn stop(
    way: &TrackLine<'_>,
    point: WayPoint<'_>,
    steps: &Steps,
    scratch: &mut LentRows<'_>,
) -> TrackStop<(), ()> {
    way.end_at(point);
    TrackStop {
        steps: steps.taken(),
        fraction: (point.travel / way.length).clamp(0.0, 1.0),
        inputs: (),
        unknowns: (),
        rounding: blur(way, point, scratch),
        names: way.mechanism.input_names(),
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::super::follow::station;
    use super::super::tests::on_the_way;
    use super::*;
    use crate::assembly::Assembly;
    use crate::failure::InputValues;
    use crate::library::FourBar;
    use crate::mechanism::Mechanism;

    const LINKAGE: FourBar = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 70.0,
        r4: 60.0,
    };

    /// Tested points lie ahead at growing distances, close, and not beyond the end.
    #[test]
    fn points_ahead_are_near_by() {
        let start = Mechanism::position(&LINKAGE, [0.5], Assembly::Open).unwrap();
        on_the_way(&LINKAGE, start, [0.5, 1.5], |way, _, scratch| {
            let mut from = |travel: f64| -> Vec<f64> {
                let mut scope = scratch.scope();
                let unknowns = Mechanism::position(&LINKAGE, [0.5 + travel], Assembly::Open).unwrap();
                let here = station(way, travel, &unknowns, &mut scope);
                ahead(way, &here.ok().expect("the linkage closes there")).collect()
            };
            let points = from(0.25);
            assert_eq!(points[0], 0.25 + way.shortest());
            assert!(points.windows(2).all(|pair| pair[0] < pair[1]), "{points:?}");
            let last = points[points.len() - 1] - 0.25;
            assert!(last > 0.2 * BLUR && last < 1.01 * BLUR, "{points:?}");

            let points = from(way.length - 1e-9);
            assert!(points.iter().all(|point| *point <= way.length), "{points:?}");
            assert_eq!(points[points.len() - 1], way.length);
        });
    }

    /// If rounding moves nothing and no obstacle exists, the track returns the error of the solver.
    #[test]
    fn an_error_that_nothing_explains_is_returned_as_it_is() {
        let start = Mechanism::position(&LINKAGE, [0.5], Assembly::Open).unwrap();
        let failure = Failure::not_finite("something");
        let error = failure.at(
            "theta3, theta4",
            InputValues::new(FourBar::<f64>::DESCRIPTION.inputs, &[0.5]),
        );
        let [some, none] = [Some(error), None].map(|error| {
            on_the_way(&LINKAGE, start, [0.5, 1.5], |way, point, scratch| {
                let here = station(way, 0.0, point.unknowns, scratch);
                let here = here.ok().expect("the linkage closes there");
                let ended = blocked(way, &here, &here, &here.sides, error, &Steps::NONE, scratch);
                ended.with_position([way.ended_at(0)], start)
            })
        });
        assert_eq!(some, TrackError::Failed(error));
        assert!(
            matches!(&none, TrackError::Lost(stop) if stop.inputs == [0.5] && stop.rounding < FIRM),
            "{none:?}"
        );
    }
}
