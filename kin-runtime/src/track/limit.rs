//! The curve of solutions near limit positions, where an unknown is faster than the inputs.
//!
//! There the fastest unknown is the parameter, and the travel of the inputs is unknown instead.

use super::follow::{BLUR, CREEPING, GROWTH_TO_POLE, MOST_CREEPING};
use super::steps::Steps;
use crate::curve::{
    LentRows, Sides, Way, WayPoint, bordered, corrected, expanded, fastest, is_crossed, largest, largest_difference,
    local_blur,
};
use crate::solve::Orientation;

/// The longest step, in sizes of the parameter.
const LONGEST_STEP: f64 = 0.05;
/// The shortest step.
pub(super) const SHORTEST_STEP: f64 = 1e-13;
/// The rate below which unknowns are left to steps of the inputs.
const SLOW: f64 = 16.0;
/// The largest number of iterations that converge quadratically or halve an interval. It exceeds the number of digits.
const ITERATIONS: usize = 64;
/// The number of steps without a change of the inputs after which the curve is given up.
const STANDSTILL: u32 = 32;
/// The result of following the curve.
pub(super) enum Passage<'s> {
    /// The unknowns have become slow again.
    Onwards(WayPoint<'s>),
    /// The inputs have reached their target, the unknowns nearly.
    Target(&'s [f64]),
    /// The curve reverses before the target.
    Limit(WayPoint<'s>, Sides<'s>),
    /// Ever shorter steps lead to this point, where the curve has no single direction.
    ChangePoint(WayPoint<'s>, Sides<'s>),
    /// The curve cannot be followed further, for another reason.
    Lost,
    /// No steps are left.
    Spent(WayPoint<'s>),
}

/// The curve to second order near one of its points.
#[derive(Clone, Copy)]
struct LocalCurve<'s> {
    point: WayPoint<'s>,
    /// The derivatives with respect to the parameter, in sizes.
    rates: &'s [f64],
    travel_rate: f64,
    /// Half the second derivatives.
    bends: &'s [f64],
    travel_bend: f64,
    /// The orientation of the closure with the travel as unknown instead of the parameter.
    orientation: Orientation,
    sides: Sides<'s>,
}

impl<'s> LocalCurve<'s> {
    /// The numbers that are kept of a curve besides rows.
    const SINGLE: usize = 5;

    /// The curve at a point, or `None` if the closure is not finite there or another parameter is needed.
    fn new(way: &Way<'_>, point: WayPoint<'_>, parameter: usize, scratch: &mut LentRows<'s>) -> Option<Self> {
        let memory = Self::memory(way, scratch);
        let mut scope = scratch.scope();
        let linear = way.linearise(point, &mut scope)?;
        let system = bordered(&linear, parameter, &mut scope);
        let mut second = way.second();
        let travel = expanded::<3>(
            way,
            (way.mechanism, &mut second[..]),
            point,
            (&linear, parameter, &system),
            &mut scope,
        );
        let series = way.unknowns(&mut second[..]);
        let coefficient = |order: usize, index: usize| series[index].coefficients()[order] / way.sizes[index];
        let rates = scope.row(way.count(), |index| coefficient(1, index));
        let bends = scope.row(way.count(), |index| coefficient(2, index));
        let [_, travel_rate, travel_bend] = travel.coefficients();
        let all = rates.iter().chain(bends);
        let mut all = all.chain([&travel_rate, &travel_bend]);
        if !all.all(|value| value.is_finite()) {
            return None;
        }
        let curve = LocalCurve {
            point,
            rates,
            travel_rate,
            bends,
            travel_bend,
            orientation: system.orientation(),
            sides: Sides::of(way, &linear, &mut scope),
        };
        curve.write(memory);
        Some(Self::read(way, memory))
    }

    /// Memory for a curve.
    fn memory(way: &Way<'_>, scratch: &mut LentRows<'s>) -> &'s mut [f64] {
        scratch.lend(Self::SINGLE + 3 * way.count() + 2 * way.description.blocks.len())
    }

    fn write(&self, memory: &mut [f64]) {
        let Orientation { sign, logarithm } = self.orientation;
        let single = [self.point.travel, self.travel_rate, self.travel_bend, sign, logarithm];
        let (first, mut rest) = memory.split_at_mut(Self::SINGLE);
        first.copy_from_slice(&single);
        for row in [self.point.unknowns, self.rates, self.bends] {
            let (first, behind) = rest.split_at_mut(row.len());
            first.copy_from_slice(row);
            rest = behind;
        }
        self.sides.write(rest);
    }

    fn read(way: &Way<'_>, memory: &'s [f64]) -> Self {
        let (single, rest) = memory.split_at(Self::SINGLE);
        let (unknowns, rest) = rest.split_at(way.count());
        let (rates, rest) = rest.split_at(way.count());
        let (bends, sides) = rest.split_at(way.count());
        Self {
            point: WayPoint {
                unknowns,
                travel: single[0],
            },
            rates,
            travel_rate: single[1],
            bends,
            travel_bend: single[2],
            orientation: Orientation {
                sign: single[3],
                logarithm: single[4],
            },
            sides: Sides::read(sides),
        }
    }

    /// The point after a step of the parameter, to second order.
    fn predicted<'t>(&self, way: &Way<'_>, step: f64, scratch: &mut LentRows<'t>) -> WayPoint<'t> {
        let along = |index: usize| (self.rates[index] + self.bends[index] * step) * step;
        WayPoint {
            unknowns: scratch.row(way.count(), |index| {
                self.point.unknowns[index] + along(index) * way.sizes[index]
            }),
            travel: self.point.travel + (self.travel_rate + self.travel_bend * step) * step,
        }
    }

    /// The curve after a step of the parameter.
    fn moved<'t>(
        &self,
        way: &Way<'_>,
        parameter: usize,
        step: f64,
        scratch: &mut LentRows<'t>,
    ) -> Option<LocalCurve<'t>> {
        let predicted = self.predicted(way, step, scratch);
        let point = corrected(way, predicted, parameter, scratch)?;
        LocalCurve::new(way, point, parameter, scratch)
    }

    fn fastest(&self) -> usize {
        fastest(self.rates)
    }
}

/// Follows the curve until the unknowns are slow again, the inputs reach their target, or there is a limit.
///
/// `rates` are the rates of the unknowns with respect to the travel, in sizes.
pub(super) fn pass<'s>(
    way: &Way<'_>,
    start: WayPoint<'_>,
    rates: &[f64],
    steps: &mut Steps,
    scratch: &mut LentRows<'s>,
) -> Passage<'s> {
    let [here, mut there] = [(); 2].map(|()| LocalCurve::memory(way, scratch));
    let outcome = scratch.lend(way.count() + 2 * way.description.blocks.len());
    let mut here = here;
    let mut parameter = fastest(rates);
    match LocalCurve::new(way, start, parameter, &mut scratch.scope()) {
        Some(first) => first.write(here),
        None => return Passage::Lost,
    }
    let entry = LocalCurve::read(way, here).orientation.logarithm;
    let mut longest = LONGEST_STEP;
    let (mut still, mut creeping) = (0, 0);
    // what is found is kept where it outlives the steps
    let (unknowns, sides) = outcome.split_at_mut(way.count());
    let (travel, kind) = loop {
        let mut scope = scratch.scope();
        let start = LocalCurve::read(way, here);
        let best = start.fastest();
        let start = if best == parameter {
            start
        } else {
            let Some(again) = LocalCurve::new(way, start.point, best, &mut scope) else {
                return Passage::Lost;
            };
            parameter = best;
            again
        };
        let mut found = |point: WayPoint<'_>, from: &Sides<'_>, kind: Kind| {
            unknowns.copy_from_slice(point.unknowns);
            from.write(sides);
            (point.travel, kind)
        };
        // The rates may change by a third of the largest.
        let bend = largest(start.bends.iter().copied().chain([start.travel_bend]));
        let mut size = longest.min(0.15 / bend);
        let next = loop {
            if size < SHORTEST_STEP || creeping > MOST_CREEPING {
                let has_vanished = start.orientation.logarithm < entry - 10.0;
                if has_vanished {
                    break None;
                }
                return Passage::Lost;
            }
            if !steps.take() {
                break None;
            }
            let mut scope = scope.scope();
            if let Some(next) = attempted(way, &start, parameter, size, &mut scope) {
                next.write(there);
                break Some(LocalCurve::read(way, there));
            }
            size *= 0.5;
        };
        let Some(next) = next else {
            let kind = if size < SHORTEST_STEP || creeping > MOST_CREEPING {
                Kind::ChangePoint
            } else {
                Kind::Spent
            };
            break found(start.point, &start.sides, kind);
        };
        creeping = if size < CREEPING { creeping + 1 } else { 0 };
        let growth = way.size_at(next.point.unknowns, parameter) / way.sizes[parameter];
        if growth > GROWTH_TO_POLE {
            return Passage::Lost;
        }
        longest = (LONGEST_STEP * growth).min(2.0 * size);
        let step = size.copysign(start.travel_rate);
        // Rounding errors separate the branches that cross here, so there seems to be a way around the crossing.
        if size < BLUR && is_crossed(way, next.point, parameter, &mut scope) {
            break found(next.point, &next.sides, Kind::ChangePoint);
        }
        if next.travel_rate * start.travel_rate <= 0.0 {
            let Some((limit, reach)) = limit_within(way, &start, parameter, step, &mut scope) else {
                return Passage::Lost;
            };
            let rounding = 16.0 * f64::EPSILON * way.length.max(1.0);
            break if limit.point.travel > way.length + rounding {
                let unknowns = arrived(way, &start, parameter, reach, &mut scope);
                let travel = way.length;
                found(WayPoint { unknowns, travel }, &start.sides, Kind::Target)
            } else if is_crossed(way, limit.point, parameter, &mut scope) {
                // Rounding errors divide a change point into limits, as errors of the dimensions do.
                found(limit.point, &limit.sides, Kind::ChangePoint)
            } else {
                found(limit.point, &limit.sides, Kind::Limit)
            };
        }
        if next.point.travel >= way.length {
            let unknowns = arrived(way, &start, parameter, step, &mut scope);
            let travel = way.length;
            break found(WayPoint { unknowns, travel }, &start.sides, Kind::Target);
        }
        still = if way.are_same(start.point.travel, next.point.travel) {
            still + 1
        } else {
            0
        };
        if still > STANDSTILL {
            return Passage::Lost;
        }
        let rate = largest(next.rates.iter().copied());
        if rate < SLOW * next.travel_rate.abs() {
            break found(next.point, &next.sides, Kind::Onwards);
        }
        core::mem::swap(&mut here, &mut there);
    };
    let (unknowns, sides) = (&*unknowns, Sides::read(sides));
    let point = WayPoint { unknowns, travel };
    match kind {
        Kind::Onwards => Passage::Onwards(point),
        Kind::Target => Passage::Target(unknowns),
        Kind::Limit => Passage::Limit(point, sides),
        Kind::ChangePoint => Passage::ChangePoint(point, sides),
        Kind::Spent => Passage::Spent(point),
    }
}

/// The kinds of a [`Passage`] with a position.
#[derive(Clone, Copy)]
enum Kind {
    Onwards,
    Target,
    Limit,
    ChangePoint,
    Spent,
}

/// The end of a step in the direction of growing travel, if it certainly lies on the same curve and at most one limit
/// position lies within the step.
fn attempted<'s>(
    way: &Way<'_>,
    here: &LocalCurve<'_>,
    parameter: usize,
    size: f64,
    scratch: &mut LentRows<'s>,
) -> Option<LocalCurve<'s>> {
    let step = size.copysign(here.travel_rate);
    let halfway = here.predicted(way, 0.5 * step, scratch);
    let middle = LocalCurve::new(way, halfway, parameter, scratch)?;
    let there = here.moved(way, parameter, step, scratch)?;
    let predicted = here.predicted(way, step, scratch);
    let differences = [
        largest_difference(there.point.unknowns, predicted.unknowns, way.sizes),
        there.point.travel - predicted.travel,
    ];
    let distance = largest(differences.into_iter());
    if distance > 0.05 * size {
        let mut scope = scratch.scope();
        let linear = way.linearise(there.point, &mut scope)?;
        let system = bordered(&linear, parameter, &mut scope);
        if distance > 0.05 * size + local_blur(way, there.point, &system, &mut scope) {
            return None;
        }
    }
    for (local, part) in [(&middle, 0.5), (&there, 1.0)] {
        let foreseen = |rate: f64, bend: f64| rate + 2.0 * bend * part * step;
        let changes = (0..way.count()).map(|index| local.rates[index] - foreseen(here.rates[index], here.bends[index]));
        let rotation = local.travel_rate - foreseen(here.travel_rate, here.travel_bend);
        if largest(changes.chain([rotation])) > 0.15 || !local.orientation.is_near(here.orientation) {
            return None;
        }
        // As long as the inputs advance, every block stays on its side.
        let goes_on = local.travel_rate * here.travel_rate > 0.0;
        if goes_on != local.sides.are_same(&here.sides) {
            return None;
        }
    }
    let advances = [here.travel_rate, middle.travel_rate, there.travel_rate].map(|rate| rate > 0.0);
    // After the curve has reversed once, it may not reverse again.
    (advances[1] == advances[0] || advances[1] == advances[2]).then_some(there)
}

/// The limit position within a step, and the step to it. It is the zero of the travel's rate.
fn limit_within<'s>(
    way: &Way<'_>,
    here: &LocalCurve<'_>,
    parameter: usize,
    step: f64,
    scratch: &mut LentRows<'s>,
) -> Option<(LocalCurve<'s>, f64)> {
    let (mut low, mut high) = (0.0, step);
    let mut reach = -here.travel_rate / (2.0 * here.travel_bend);
    let memory = LocalCurve::memory(way, scratch);
    // the smallest rate of the travel, and the step to it
    let mut best: Option<(f64, f64)> = None;
    for _ in 0..ITERATIONS {
        if !(reach - low).is_finite() || (reach - low) * (reach - high) > 0.0 {
            reach = 0.5 * (low + high);
        }
        let mut scope = scratch.scope();
        let Some(local) = here.moved(way, parameter, reach, &mut scope) else {
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
        let rate = local.travel_rate.abs();
        if best.is_none_or(|(least, _)| rate < least) {
            best = Some((rate, reach));
            local.write(memory);
        }
        if done {
            break;
        }
        reach = next;
    }
    let (_, reach) = best?;
    Some((LocalCurve::read(way, memory), reach))
}

/// The unknowns where the inputs reach their target, within a step along which the inputs only advance.
fn arrived<'s>(
    way: &Way<'_>,
    here: &LocalCurve<'_>,
    parameter: usize,
    step: f64,
    scratch: &mut LentRows<'s>,
) -> &'s [f64] {
    let (mut low, mut high) = (0.0, step);
    let mut reach = (way.length - here.point.travel) / here.travel_rate;
    let unknowns = scratch.filled(way.count(), |index| here.point.unknowns[index]);
    for _ in 0..ITERATIONS {
        if !(reach - low).is_finite() || (reach - low) * (reach - high) > 0.0 {
            reach = 0.5 * (low + high);
        }
        let mut scope = scratch.scope();
        let Some(local) = here.moved(way, parameter, reach, &mut scope) else {
            break;
        };
        unknowns.copy_from_slice(local.point.unknowns);
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
    use super::super::tests::on_the_way;
    use super::*;
    use crate::assembly::Assembly;
    use crate::library::FourBar;
    use crate::mechanism::Mechanism;

    const LINKAGE: FourBar = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };

    /// The unknowns between two crank angles, both before a limit: those that `arrived` finds after a step, which a
    /// function gives from the step that is needed.
    fn found(assembly: Assembly, [from, to]: [f64; 2], expected: [f64; 2], step: impl Fn(f64) -> f64) -> [f64; 2] {
        let unknowns = Mechanism::position(&LINKAGE, [from], assembly).unwrap();
        on_the_way(&LINKAGE, unknowns, [from, to], |way, point, scratch| {
            let parameter = LocalCurve::new(way, point, 0, scratch).unwrap().fastest();
            let here = LocalCurve::new(way, point, parameter, scratch).unwrap();
            let reach = (expected[parameter] - here.point.unknowns[parameter]) / way.sizes[parameter];
            let found = arrived(way, &here, parameter, step(reach), scratch);
            [found[0], found[1]]
        })
    }

    /// Towards a limit and away from it, the unknowns belong to the target inputs, whatever the length of the step.
    #[test]
    fn within_a_step_the_inputs_arrive_where_they_are_wanted() {
        let end = LINKAGE.crank_range().unwrap().high;
        for assembly in Assembly::BOTH {
            for (far, near) in [(1e-4, 1e-6), (1e-3, 5e-4), (1e-6, 1e-10), (1e-3, 1e-10)] {
                for (from, to) in [(end - far, end - near), (end - near, end - far)] {
                    let expected = Mechanism::position(&LINKAGE, [to], assembly).unwrap();
                    for part in [1.0, 1.1, 1.5] {
                        // The target is not beyond the limit, where the inputs reverse.
                        let is_towards = to > from;
                        let part = if is_towards { 1.0 } else { part };
                        let found = found(assembly, [from, to], expected, |reach| reach * part * (1.0 + 1e-9));
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
