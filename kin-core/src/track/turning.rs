//! The curve of solutions near limit positions, where an unknown is faster than the inputs.
//!
//! There the fastest unknown is the parameter, and the travel of the inputs is unknown instead. With this parameter the
//! curve is as smooth as anywhere, and a limit position is a simple zero of the travel's rate. (Local parametrisation:
//! W. C. Rheinboldt and J. V. Burkardt, A locally parameterized continuation process, ACM Transactions on Mathematical
//! Software 9, 1983, 215-235.)

use super::rounding::{is_crossed, rounding};
use super::sides::{Sides, bordered};
use super::steps::Steps;
use super::way::{Linear, Way, WayPoint, largest};
use super::{BLUR, CREEPING, FAR, MOST_CREEPING};
use crate::mechanism::Mechanism;
use crate::mechanism::factored_matrix::{FactoredMatrix, Orientation};
use crate::number::Row;

/// The longest step, in sizes of the parameter.
const LONGEST: f64 = 0.05;
/// The shortest step.
pub(super) const SHORTEST: f64 = 1e-13;
/// The rate below which unknowns are left to steps of the inputs.
const SLOW: f64 = 16.0;
/// The largest number of iterations that converge quadratically or halve an interval. It exceeds the number of digits.
const ITERATIONS: usize = 64;
/// The number of steps without a change of the inputs after which the curve is given up.
const STANDSTILL: u32 = 32;
/// The size below which a correction that does not fall is rounding.
const NOISE: f64 = 1e-7;

/// The result of following the curve.
pub(super) enum Passage<M: Mechanism> {
    /// The unknowns have become slow again.
    Onwards(WayPoint<M>),
    /// The inputs have reached their target, the unknowns nearly.
    Target(M::Unknowns<f64>),
    /// The curve turns back before the target.
    Limit(WayPoint<M>, Sides<M>),
    /// Ever shorter steps lead to this place, where the curve has no single direction.
    ChangePoint(WayPoint<M>, Sides<M>),
    /// The curve cannot be followed further, for another reason.
    Lost,
    /// No steps are left.
    Spent(WayPoint<M>),
}

/// The curve to second order near one of its points.
struct LocalCurve<M: Mechanism> {
    point: WayPoint<M>,
    /// The derivatives with respect to the parameter, in sizes.
    rates: M::Unknowns<f64>,
    travel_rate: f64,
    /// Half the second derivatives.
    bends: M::Unknowns<f64>,
    travel_bend: f64,
    /// The orientation of the closure with the travel as unknown instead of the parameter.
    orientation: Orientation,
    sides: Sides<M>,
}

impl<M: Mechanism<Scalar = f64>> LocalCurve<M> {
    /// The curve at a point, or `None` if the closure is not finite there or another parameter is needed.
    fn new(way: &Way<M>, point: WayPoint<M>, parameter: usize) -> Option<Self> {
        let linear = way.linearise(&point)?;
        let system = bordered(&linear, parameter);
        let column = M::Unknowns::from_fn(|row| -linear.jacobian[row][parameter]);
        let mut rates = system.solve(&column);
        let travel_rate = core::mem::replace(&mut rates[parameter], 1.0);
        let right = way.bend(&point, &rates, travel_rate);
        let mut bends = system.solve(&M::Unknowns::from_fn(|row| -right[row]));
        let travel_bend = core::mem::replace(&mut bends[parameter], 0.0);
        let all = rates.as_ref().iter().chain(bends.as_ref());
        let mut all = all.chain([&travel_rate, &travel_bend]);
        all.all(|value| value.is_finite()).then_some(Self {
            point,
            rates,
            travel_rate,
            bends,
            travel_bend,
            orientation: system.orientation(),
            sides: Sides::of(&linear),
        })
    }

    /// The point after a step of the parameter, to second order.
    fn predicted(&self, way: &Way<M>, step: f64) -> WayPoint<M> {
        let along = |index: usize| (self.rates[index] + self.bends[index] * step) * step;
        WayPoint {
            unknowns: M::Unknowns::from_fn(|index| self.point.unknowns[index] + along(index) * way.sizes[index]),
            travel: self.point.travel + (self.travel_rate + self.travel_bend * step) * step,
        }
    }

    /// The curve after a step of the parameter.
    fn moved(&self, way: &Way<M>, parameter: usize, step: f64) -> Option<Self> {
        let point = corrected(way, self.predicted(way, step), parameter)?;
        Self::new(way, point, parameter)
    }

    fn fastest(&self) -> usize {
        fastest(&self.rates)
    }
}

/// The index of the largest rate, the first of several.
pub(super) fn fastest<R: Row<f64>>(rates: &R) -> usize {
    let rates = rates.as_ref().iter().enumerate();
    let best = rates.fold(
        (0, 0.0),
        |best: (usize, f64), (index, rate)| {
            if rate.abs() > best.1 { (index, rate.abs()) } else { best }
        },
    );
    best.0
}

/// The point of the curve with the same value of the parameter, by Newton's method.
fn corrected<M: Mechanism<Scalar = f64>>(way: &Way<M>, start: WayPoint<M>, parameter: usize) -> Option<WayPoint<M>> {
    let mut point = start;
    let mut previous = f64::INFINITY;
    for _ in 0..ITERATIONS {
        let linear: Linear<M> = way.linearise(&point)?;
        let system = bordered(&linear, parameter);
        let correction = system.solve(&linear.residuals);
        let length = largest(correction.as_ref().iter().copied());
        let stalls = length >= 0.5 * previous;
        if !length.is_finite() || (stalls && length > NOISE && length > blur(way, &point, &system)) {
            return None;
        }
        for (index, change) in correction.as_ref().iter().enumerate() {
            if index == parameter {
                point.travel -= change;
            } else {
                point.unknowns[index] -= change * way.sizes[index];
            }
        }
        if length <= f64::EPSILON || stalls {
            return Some(point);
        }
        previous = length;
    }
    None
}

/// The distance from the curve that rounding errors may cause. It is zero if it exceeds a fifth of the longest step,
/// because it would then excuse any deviation.
fn blur<M: Mechanism<Scalar = f64>>(way: &Way<M>, point: &WayPoint<M>, system: &FactoredMatrix<M>) -> f64 {
    let size = largest(rounding(way, point, system).as_ref().iter().copied());
    if size <= 0.2 * LONGEST { size } else { 0.0 }
}

/// Follows the curve until the unknowns are slow again, the inputs reach their target, or there is a limit.
///
/// `rates` are the rates of the unknowns with respect to the travel, in sizes.
pub(super) fn pass<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    start: WayPoint<M>,
    rates: &M::Unknowns<f64>,
    steps: &mut Steps,
) -> Passage<M> {
    let mut parameter = fastest(rates);
    let Some(mut here) = LocalCurve::new(way, start, parameter) else {
        return Passage::Lost;
    };
    let entry = here.orientation.logarithm;
    let mut longest = LONGEST;
    let (mut still, mut creeping) = (0, 0);
    loop {
        let best = here.fastest();
        if best != parameter {
            let Some(again) = LocalCurve::new(way, here.point, best) else {
                return Passage::Lost;
            };
            (parameter, here) = (best, again);
        }
        // The rates may change by a third of the largest.
        let bend = largest(here.bends.as_ref().iter().copied().chain([here.travel_bend]));
        let mut size = longest.min(0.15 / bend);
        let there = loop {
            if size < SHORTEST || creeping > MOST_CREEPING {
                let has_vanished = here.orientation.logarithm < entry - 10.0;
                return if has_vanished {
                    Passage::ChangePoint(here.point, here.sides)
                } else {
                    Passage::Lost
                };
            }
            if !steps.take() {
                return Passage::Spent(here.point);
            }
            if let Some(there) = attempted(way, &here, parameter, size) {
                break there;
            }
            size *= 0.5;
        };
        creeping = if size < CREEPING { creeping + 1 } else { 0 };
        let growth = way.sizes_at(&there.point)[parameter] / way.sizes[parameter];
        if growth > FAR {
            return Passage::Lost;
        }
        longest = (LONGEST * growth).min(2.0 * size);
        let step = size.copysign(here.travel_rate);
        // Rounding errors separate the branches that cross here, so there seems to be a way around the crossing.
        if size < BLUR && is_crossed(way, &there.point, parameter) {
            return Passage::ChangePoint(there.point, there.sides);
        }
        if there.travel_rate * here.travel_rate <= 0.0 {
            let Some((turn, reach)) = turned(way, &here, parameter, step) else {
                return Passage::Lost;
            };
            let rounding = 16.0 * f64::EPSILON * way.length.max(1.0);
            return if turn.point.travel > way.length + rounding {
                Passage::Target(arrived(way, &here, parameter, reach))
            } else if is_crossed(way, &turn.point, parameter) {
                // Rounding errors turn a change point into limits, as errors of the dimensions do.
                Passage::ChangePoint(turn.point, turn.sides)
            } else {
                Passage::Limit(turn.point, turn.sides)
            };
        }
        if there.point.travel >= way.length {
            return Passage::Target(arrived(way, &here, parameter, step));
        }
        still = if way.are_same(here.point.travel, there.point.travel) {
            still + 1
        } else {
            0
        };
        if still > STANDSTILL {
            return Passage::Lost;
        }
        here = there;
        let rate = largest(here.rates.as_ref().iter().copied());
        if rate < SLOW * here.travel_rate.abs() {
            return Passage::Onwards(here.point);
        }
    }
}

/// The end of a step in the direction of growing travel, if it certainly lies on the same curve and at most one limit
/// position lies within the step.
fn attempted<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    here: &LocalCurve<M>,
    parameter: usize,
    size: f64,
) -> Option<LocalCurve<M>> {
    let step = size.copysign(here.travel_rate);
    let middle = LocalCurve::new(way, here.predicted(way, 0.5 * step), parameter)?;
    let there = here.moved(way, parameter, step)?;
    let predicted = here.predicted(way, step);
    let pairs = there.point.unknowns.as_ref().iter().zip(predicted.unknowns.as_ref());
    let differences = pairs
        .zip(way.sizes.as_ref())
        .map(|((one, other), size)| (one - other) / size);
    let distance = largest(differences.chain([there.point.travel - predicted.travel]));
    if distance > 0.05 * size {
        let system = bordered(&way.linearise(&there.point)?, parameter);
        if distance > 0.05 * size + blur(way, &there.point, &system) {
            return None;
        }
    }
    for (local, part) in [(&middle, 0.5), (&there, 1.0)] {
        let foreseen = |rate: f64, bend: f64| rate + 2.0 * bend * part * step;
        let changes =
            (0..Way::<M>::COUNT).map(|index| local.rates[index] - foreseen(here.rates[index], here.bends[index]));
        let turn = local.travel_rate - foreseen(here.travel_rate, here.travel_bend);
        if largest(changes.chain([turn])) > 0.15 || !local.orientation.is_near(here.orientation) {
            return None;
        }
        // As long as the inputs advance, every block stays on its side.
        let goes_on = local.travel_rate * here.travel_rate > 0.0;
        if goes_on != local.sides.are_same(&here.sides) {
            return None;
        }
    }
    let turns = [here.travel_rate, middle.travel_rate, there.travel_rate].map(|rate| rate > 0.0);
    // After the curve has turned once, it may not turn again.
    (turns[1] == turns[0] || turns[1] == turns[2]).then_some(there)
}

/// The limit position within a step, and the step to it. It is the zero of the travel's rate.
fn turned<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    here: &LocalCurve<M>,
    parameter: usize,
    step: f64,
) -> Option<(LocalCurve<M>, f64)> {
    let (mut low, mut high) = (0.0, step);
    let mut reach = -here.travel_rate / (2.0 * here.travel_bend);
    let mut best: Option<(LocalCurve<M>, f64)> = None;
    for _ in 0..ITERATIONS {
        if !(reach - low).is_finite() || (reach - low) * (reach - high) > 0.0 {
            reach = 0.5 * (low + high);
        }
        let Some(local) = here.moved(way, parameter, reach) else {
            break;
        };
        if local.travel_rate * here.travel_rate > 0.0 {
            low = reach;
        } else {
            high = reach;
        }
        let next = reach - local.travel_rate / (2.0 * local.travel_bend);
        let size = (here.point.unknowns[parameter] / way.sizes[parameter]).abs();
        let done = (next - reach).abs() <= 2.0 * f64::EPSILON * size.max(1.0) || low == high;
        let is_better = best
            .as_ref()
            .is_none_or(|(best, _)| local.travel_rate.abs() < best.travel_rate.abs());
        if is_better {
            best = Some((local, reach));
        }
        if done {
            break;
        }
        reach = next;
    }
    best
}

/// The unknowns where the inputs reach their target, within a step along which the inputs only advance.
fn arrived<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    here: &LocalCurve<M>,
    parameter: usize,
    step: f64,
) -> M::Unknowns<f64> {
    let (mut low, mut high) = (0.0, step);
    let mut reach = (way.length - here.point.travel) / here.travel_rate;
    let mut unknowns = here.point.unknowns;
    for _ in 0..ITERATIONS {
        if !(reach - low).is_finite() || (reach - low) * (reach - high) > 0.0 {
            reach = 0.5 * (low + high);
        }
        let Some(local) = here.moved(way, parameter, reach) else {
            break;
        };
        unknowns = local.point.unknowns;
        let missing = way.length - local.point.travel;
        if missing > 0.0 {
            low = reach;
        } else {
            high = reach;
        }
        let next = reach + missing / local.travel_rate;
        if (next - reach).abs() <= 1e-12 {
            break;
        }
        reach = next;
    }
    unknowns
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::Assembly;
    use crate::library::FourBar;

    const LINKAGE: FourBar = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };

    /// The track between two crank angles, both before a limit, and the curve at its start.
    fn begin(assembly: Assembly, from: f64, to: f64) -> (Way<FourBar>, LocalCurve<FourBar>, usize) {
        let unknowns = LINKAGE.solve_position([from], assembly).unwrap();
        let way = Way::new(LINKAGE, [from], &unknowns, [to]);
        let point = WayPoint { unknowns, travel: 0.0 };
        let first = LocalCurve::new(&way, point, 0).unwrap();
        let parameter = first.fastest();
        let here = LocalCurve::new(&way, point, parameter).unwrap();
        (way, here, parameter)
    }

    /// Towards a limit and away from it, the unknowns belong to the target inputs, whatever the length of the step.
    #[test]
    fn within_a_step_the_inputs_arrive_where_they_are_wanted() {
        let end = LINKAGE.crank_range().unwrap().high;
        for assembly in Assembly::BOTH {
            for (far, near) in [(1e-4, 1e-6), (1e-3, 5e-4), (1e-6, 1e-10), (1e-3, 1e-10)] {
                for (from, to) in [(end - far, end - near), (end - near, end - far)] {
                    let (way, here, parameter) = begin(assembly, from, to);
                    let expected = LINKAGE.solve_position([to], assembly).unwrap();
                    let reach = (expected[parameter] - here.point.unknowns[parameter]) / way.sizes[parameter];
                    for part in [1.0, 1.1, 1.5] {
                        // The target is not beyond the limit, where the inputs turn back.
                        let is_towards = to > from;
                        let step = if is_towards { reach } else { reach * part };
                        let found = arrived(&way, &here, parameter, step * (1.0 + 1e-9));
                        for (one, other) in found.into_iter().zip(expected) {
                            // The angles become more sensitive close to the limit.
                            assert!(
                                (one - other).abs() <= 1e-10 + 64.0 * f64::EPSILON / near.sqrt(),
                                "{from} to {to}, {part}: {one} {other}"
                            );
                        }
                    }
                }
            }
        }
    }
}
