//! Extremes, zeros and dwells.

use alloc::vec::Vec;

use super::ExtremesError;
use super::curve::{Curve, CurveNode, Edge, Stretch, StretchEnd};
use super::parts::{CurvePart, ROUNDING};
use super::swept::JUMP;
use super::{Crossing, DwellRange, Extreme, ExtremeKind, Peak};
use crate::number::Number;
use crate::sweep::Local;

/// The parameters next to a turning point at which a quantity is compared with itself.
const NEAR_LIMIT: [f64; 2] = [1.0 / 4096.0, 1.0 / 2048.0];
/// The growth between them of a quantity that has no bound.
const GROWTH: f64 = 1.05;

/// A slope, as a part of those at the ends of a piece, above which Newton's method has not found its zero.
const KINK: f64 = 1e-3;

/// All extremes, and the point where the sweep begins to close: a quantity that is constant over a full revolution has
/// no other.
pub(super) struct FoundExtremes {
    pub(super) extremes: Vec<Extreme>,
    pub(super) first: Option<Extreme>,
}

impl<'c> Curve<'c> {
    pub(super) fn extremes(&self) -> Result<FoundExtremes, ExtremesError> {
        let stretches = self.stretches()?;
        let mut extremes: Vec<Extreme> = Vec::new();
        // the end of the stretch before, with its kind
        let mut before: Option<(CurveNode<'c>, bool, StretchEnd)> = None;
        let is_revolution = self.extent.is_full_revolution && self.is_periodic(&stretches)?;
        let mut first = None;
        for stretch in &stretches {
            let mut inner = Vec::new();
            let [begin, end] = self.parts(stretch, is_revolution, &mut |part, nodes| match part {
                CurvePart::Piece(piece) => {
                    for parameter in piece.stationary_points() {
                        inner.push(self.stationary(stretch, nodes, parameter)?);
                    }
                    Ok(())
                }
                CurvePart::Flat => Ok(()),
                CurvePart::Kink => {
                    let rises = nodes.map(|node| rises(stretch, node));
                    inner.extend(joint(nodes, rises, ExtremeKind::Kink).into_iter().flatten());
                    Ok(())
                }
            })?;
            let [rises_first, rises_last] = [&begin, &end].map(|node| rises(stretch, node));
            let beginning = match stretch.ends[0] {
                StretchEnd::Limit(_) => self.at_limit(stretch, &begin)?,
                StretchEnd::ShortOf { .. } => self.short_of_limit(stretch, &begin)?,
                _ => edge(&begin, ExtremeKind::End, !rises_first),
            };
            first.get_or_insert(beginning);
            match before.filter(|(.., end)| end.goes_on()) {
                Some((node, rose, end)) if stretch.ends[0].goes_on() => {
                    let kind = if end == StretchEnd::Inside {
                        ExtremeKind::Inner
                    } else {
                        ExtremeKind::Kink
                    };
                    let begin = reached(stretch, stretch.ends[0], &begin);
                    let found = joint([&node, &begin], [rose, rises_first], kind);
                    extremes.extend(found.into_iter().flatten());
                    if end == StretchEnd::Joint {
                        extremes.extend(self.impulse(&begin)?);
                    }
                }
                before => {
                    // a change point beyond which nothing closes
                    extremes.extend(before.map(|(node, rose, _)| edge(&node, ExtremeKind::Limit, rose)));
                    if !(is_revolution && stretch.ends[0] == StretchEnd::Sweep) {
                        extremes.push(beginning);
                    }
                }
            }
            extremes.append(&mut inner);
            match stretch.ends[1] {
                StretchEnd::Sweep if is_revolution => {}
                StretchEnd::Sweep => extremes.push(edge(&end, ExtremeKind::End, rises_last)),
                StretchEnd::ShortOf { .. } => extremes.push(self.short_of_limit(stretch, &end)?),
                end_kind if end_kind.goes_on() => {}
                _ => extremes.push(self.at_limit(stretch, &end)?),
            }
            before = Some((reached(stretch, stretch.ends[1], &end), rises_last, stretch.ends[1]));
        }
        if let Some((node, rose, end)) = before
            && end.goes_on()
        {
            extremes.push(edge(&node, ExtremeKind::Limit, rose));
        }
        leave_out_rounding(&mut extremes, ROUNDING * self.size.get());
        Ok(FoundExtremes { extremes, first })
    }

    /// The extremes at a joint of laws where a lower rate jumps.
    fn impulse(&self, joint: &CurveNode<'c>) -> Result<impl Iterator<Item = Extreme> + use<>, ExtremesError> {
        let (at, [up, down]) = (joint.at, self.quantity.impulse(joint)?);
        let unbounded = move |is_maximum: bool| Extreme {
            at,
            value: None,
            kind: ExtremeKind::Unbounded,
            is_maximum,
        };
        let both = [up.then(|| unbounded(true)), down.then(|| unbounded(false))];
        Ok(both.into_iter().flatten())
    }

    /// The value of the highest rank. It has none if the quantity has no bound there.
    pub(super) fn best(&self, rank: fn(f64) -> f64) -> Result<Peak, ExtremesError> {
        let found = self.extremes()?;
        let mut best: Option<Peak> = None;
        for extreme in found.first.into_iter().chain(found.extremes) {
            let Some(value) = extreme.value else {
                if rank(if extreme.is_maximum { 1.0 } else { -1.0 }) > 0.0 {
                    return Err(ExtremesError::Unbounded { at: extreme.at });
                }
                continue;
            };
            if best.is_none_or(|best| rank(value) > rank(best.value)) {
                best = Some(Peak {
                    at: extreme.at,
                    value,
                    kind: extreme.kind,
                });
            }
        }
        best.ok_or(ExtremesError::NoLength { at: self.extent.from })
    }

    /// The extreme near a stationary point of a piece. If the slope does not vanish there, the quantity has a kink.
    fn stationary(
        &self,
        stretch: &Stretch<'c>,
        nodes: [&CurveNode<'c>; 2],
        parameter: f64,
    ) -> Result<Extreme, ExtremesError> {
        let slope = |node: &CurveNode<'c>| node.value.coefficients()[1];
        let node = self.refined(stretch, nodes, parameter, |value| {
            let [_, slope, bend, ..] = value.coefficients();
            (slope, 2.0 * bend)
        })?;
        let largest = slope(nodes[0]).abs().max(slope(nodes[1]).abs());
        if slope(&node).abs() <= KINK * largest {
            return Ok(edge(&node, ExtremeKind::Inner, node.value.coefficients()[2] < 0.0));
        }
        let [mut left, mut right] = nodes.map(Clone::clone);
        let is_maximum = rises(stretch, &left);
        loop {
            let middle = f64::midpoint(left.parameter, right.parameter);
            if (right.parameter - left.parameter).abs() <= stretch.resolution() {
                return Ok(edge(&left, ExtremeKind::Kink, is_maximum));
            }
            let node = self.node(stretch, middle, &left.mark)?;
            if rises(stretch, &node) == is_maximum {
                left = node;
            } else {
                right = node;
            }
        }
    }

    /// Whether the quantity is the same at both ends of a full revolution.
    pub(super) fn is_periodic(&self, stretches: &[Stretch<'c>]) -> Result<bool, ExtremesError> {
        let (Some(first), Some(last)) = (stretches.first(), stretches.last()) else {
            return Ok(false);
        };
        if stretches.iter().any(|stretch| stretch.edge.is_some()) {
            return Ok(false);
        }
        let begin = self.node(first, first.parameters[0], &first.mark)?.value.coefficients();
        let end = self.node(last, last.parameters[1], &last.mark)?.value.coefficients();
        let sizes = begin.iter().map(|coefficient| coefficient.abs());
        let size = sizes.fold(0.0, f64::max);
        let pairs = begin.iter().zip(end);
        Ok(pairs.fold(0.0, |worst: f64, (one, other)| worst.max((one - other).abs())) <= 1e-7 * size)
    }

    /// The extreme at a turning point: the curve ends there.
    fn at_limit(&self, stretch: &Stretch<'c>, nearest: &CurveNode<'c>) -> Result<Extreme, ExtremesError> {
        let Some(limit) = stretch.edge else {
            return Ok(edge(nearest, ExtremeKind::End, true));
        };
        let at = limit.at;
        if stretch.may_grow() && self.is_unbounded(stretch, nearest)? {
            return Ok(Extreme {
                at,
                value: None,
                kind: ExtremeKind::Unbounded,
                is_maximum: nearest.value.real() > 0.0,
            });
        }
        // the slope towards the limit is against the parameter
        Ok(Extreme {
            at,
            value: Some(extrapolated(nearest.value, limit)),
            kind: ExtremeKind::Limit,
            is_maximum: nearest.value.coefficients()[1] < 0.0,
        })
    }

    /// The extreme at the end of a sweep short of a turning point.
    fn short_of_limit(&self, stretch: &Stretch<'c>, nearest: &CurveNode<'c>) -> Result<Extreme, ExtremesError> {
        let end = match stretch.edge {
            Some(Edge {
                end: (at, parameter), ..
            }) => CurveNode {
                at,
                ..self.node(stretch, parameter, &nearest.mark)?
            },
            None => nearest.clone(),
        };
        let is_maximum = if end.value.real() == nearest.value.real() {
            // the slope towards the limit is against the parameter
            nearest.value.coefficients()[1] < 0.0
        } else {
            end.value.real() > nearest.value.real()
        };
        Ok(edge(&end, ExtremeKind::End, is_maximum))
    }

    fn is_unbounded(&self, stretch: &Stretch<'c>, nearest: &CurveNode<'c>) -> Result<bool, ExtremesError> {
        Ok(self.growth(stretch, nearest)? > GROWTH)
    }

    /// The growth of a quantity from a point near a turning point to another one twice as near, in the parameter.
    pub(super) fn growth(&self, stretch: &Stretch<'c>, nearest: &CurveNode<'c>) -> Result<f64, ExtremesError> {
        let [near, far] = NEAR_LIMIT.map(|parameter| self.node(stretch, parameter, &nearest.mark));
        let (near, far) = (near?, far?);
        let [value, before] = [&near, &far].map(|node| node.value.real().abs());
        // rounding errors grow as well
        let is_rounding = self.is_rounding(stretch, &near, far.parameter - near.parameter)?;
        Ok(if is_rounding { 0.0 } else { value / before })
    }

    /// The points where the quantity crosses a level.
    pub(super) fn crossings(&self, level: f64) -> Result<Vec<Crossing>, ExtremesError> {
        finite("level", level)?;
        let mut crossings = Vec::new();
        // the end of the stretch before
        let mut before: Option<CurveNode<'c>> = None;
        for stretch in &self.stretches()? {
            let mut inner = Vec::new();
            let [begin, end] = self.crossings_of(stretch, level, &mut |node| {
                inner.push(Crossing {
                    at: node.at,
                    is_rising: rises(stretch, node),
                });
            })?;
            // a quantity that jumps where two stretches meet is on the level in neither
            let begin = reached(stretch, stretch.ends[0], &begin);
            if let Some(left) = before.filter(|_| stretch.ends[0].goes_on()) {
                let [left, right] = [&left, &begin].map(|node| node.value.real() < level);
                if left != right {
                    crossings.push(Crossing {
                        at: begin.at,
                        is_rising: left,
                    });
                }
            }
            crossings.append(&mut inner);
            before = (stretch.ends[1].goes_on()).then(|| reached(stretch, stretch.ends[1], &end));
        }
        Ok(crossings)
    }

    /// Passes on the points inside of a stretch where the quantity crosses a level, and returns the nodes at both ends
    /// of the stretch.
    fn crossings_of(
        &self,
        stretch: &Stretch<'c>,
        level: f64,
        found: &mut dyn FnMut(&CurveNode<'c>),
    ) -> Result<[CurveNode<'c>; 2], ExtremesError> {
        self.parts(stretch, false, &mut |part, nodes| {
            match part {
                CurvePart::Piece(piece) => {
                    for parameter in piece.crossings(level) {
                        let value = |value: Local| {
                            let [value, slope, ..] = value.coefficients();
                            (value - level, slope)
                        };
                        found(&self.refined(stretch, nodes, parameter, value)?);
                    }
                }
                CurvePart::Flat | CurvePart::Kink => {
                    let [left, right] = nodes.map(|node| node.value.real() < level);
                    if left != right {
                        found(nodes[1]);
                    }
                }
            }
            Ok(())
        })
    }

    /// The parts of the sweep on which the quantity keeps to a level.
    pub(super) fn dwells(&self, level: f64, tolerance: f64) -> Result<Vec<DwellRange>, ExtremesError> {
        finite("level", level)?;
        finite("tolerance", tolerance)?;
        let mut dwells: Vec<[f64; 2]> = Vec::new();
        let stretches = self.stretches()?;
        for stretch in &stretches {
            let [from, to] = stretch.parameters;
            let mut cuts = alloc::vec![from, to];
            for border in [level - tolerance, level + tolerance] {
                self.crossings_of(stretch, border, &mut |node| cuts.push(node.parameter))?;
            }
            cuts.sort_by(f64::total_cmp);
            if to < from {
                cuts.reverse();
            }
            for pair in cuts.windows(2) {
                if pair[0] == pair[1] {
                    continue;
                }
                let middle = self.node(stretch, f64::midpoint(pair[0], pair[1]), &stretch.mark)?;
                // where the quantity only touches a border, rounding errors cross it
                let rounding = ROUNDING * (level.abs() + tolerance);
                let is_near = (middle.value.real() - level).abs() <= tolerance + rounding;
                if !is_near {
                    continue;
                }
                // next to a turning point the quantity goes on to the limit
                let [start, end] = [pair[0], pair[1]].map(|parameter| stretch.value_of_variable(parameter));
                match dwells.last_mut() {
                    Some(last) if last[1] == start => last[1] = end,
                    _ => dwells.push([start, end]),
                }
            }
        }
        let (begin, end) = (self.extent.from, self.extent.to);
        if dwells.len() > 1 && self.extent.is_full_revolution && self.is_periodic(&stretches)? {
            let (first, last) = (dwells[0], dwells[dwells.len() - 1]);
            if first[0] == begin && last[1] == end {
                dwells.remove(0);
                if let Some(last) = dwells.last_mut() {
                    last[1] = first[1] + (end - begin);
                }
            }
        }
        let time = self.extent.time;
        Ok(dwells
            .into_iter()
            .map(|[from, to]| DwellRange {
                from,
                to,
                duration: (to - from).abs() * time,
            })
            .collect())
    }
}

/// Takes out the extremes that rounding errors make: those inside of the curve that differ from the next one, or from
/// both neighbours, by less than the errors.
fn leave_out_rounding(extremes: &mut Vec<Extreme>, rounding: f64) {
    let is_inside = |extreme: &Extreme| matches!(extreme.kind, ExtremeKind::Inner | ExtremeKind::Kink);
    let is_same = |one: &Extreme, other: &Extreme| match (one.value, other.value) {
        (Some(one), Some(other)) => (one - other).abs() <= rounding,
        _ => false,
    };
    let mut kept: Vec<Extreme> = Vec::with_capacity(extremes.len());
    for extreme in extremes.drain(..) {
        match kept.last() {
            Some(last) if is_inside(last) && is_inside(&extreme) && is_same(last, &extreme) => {
                // of two maxima one is left, and of a maximum and a minimum none
                if last.is_maximum != extreme.is_maximum {
                    kept.pop();
                }
            }
            _ => kept.push(extreme),
        }
    }
    let mut index = 1;
    while index + 1 < kept.len() {
        let [before, extreme, after] = [&kept[index - 1], &kept[index], &kept[index + 1]];
        if is_inside(extreme) && is_same(before, extreme) && is_same(extreme, after) {
            kept.remove(index);
        } else {
            index += 1;
        }
    }
    *extremes = kept;
}

/// The mistake of a question whose level or tolerance is not a finite number.
fn finite(argument: &'static str, value: f64) -> Result<(), ExtremesError> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(ExtremesError::Argument { argument, value })
    }
}

/// Whether the quantity rises in the direction of the sweep. A slope of zero counts as one that rises with the
/// parameter, as [`Piece::stationary_points`](crate::hermite::Piece::stationary_points) counts it.
fn rises(stretch: &Stretch<'_>, node: &CurveNode<'_>) -> bool {
    let [from, to] = stretch.parameters;
    (node.value.coefficients()[1] >= 0.0) == (to >= from)
}

/// The node at the end of a stretch. Next to a limit the series goes on to the limit itself.
fn reached<'c>(stretch: &Stretch<'_>, end: StretchEnd, nearest: &CurveNode<'c>) -> CurveNode<'c> {
    match (end, stretch.edge) {
        (StretchEnd::Limit(_), Some(edge)) => CurveNode {
            at: edge.at,
            value: Local::constant(extrapolated(nearest.value, edge)),
            ..nearest.clone()
        },
        _ => nearest.clone(),
    }
}

/// The extreme at a point that has only one side, or only one value.
fn edge(node: &CurveNode<'_>, kind: ExtremeKind, is_maximum: bool) -> Extreme {
    Extreme {
        at: node.at,
        value: Some(node.value.real()),
        kind,
        is_maximum,
    }
}

/// The extremes at an edge with two sides, where the quantity rises or falls on each. A jump between them has an
/// extreme on each side from which the quantity does not go on in the same direction.
fn joint(nodes: [&CurveNode<'_>; 2], rises: [bool; 2], kind: ExtremeKind) -> [Option<Extreme>; 2] {
    let [left, right] = nodes.map(|node| node.value.real());
    let jump = right - left;
    if jump.abs() <= JUMP * left.abs().max(right.abs()) {
        return [(rises[0] != rises[1]).then(|| edge(nodes[0], kind, rises[0])), None];
    }
    let goes_up = jump > 0.0;
    [
        (rises[0] != goes_up).then(|| edge(nodes[0], kind, rises[0])),
        (rises[1] != goes_up).then(|| edge(nodes[1], kind, goes_up)),
    ]
}

/// The value at the turning point, where the parameter is zero, from the series at the nearest point.
pub(super) fn extrapolated(nearest: Local, edge: Edge) -> f64 {
    let coefficients = nearest.coefficients();
    coefficients
        .iter()
        .rev()
        .fold(0.0, |sum, coefficient| sum * (edge.end.1 - edge.nearest) + coefficient)
}
