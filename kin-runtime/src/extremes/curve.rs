//! A quantity as a curve over the variable of a sweep, in stretches without an edge.

use alloc::vec::Vec;
use core::cell::{Cell, RefCell};
use core::f64::consts::TAU;

use super::ExtremesError;
use super::swept::{Mark, QuantityOfSweep, SweepExtent};
use crate::curve::LimitKind;
use crate::failure::SolveError;
use crate::law::Side;
use crate::number::Number;
use crate::sweep::{Limit, Local, Walk};

/// The smallest parameter next to a turning point. Closer to it, a Taylor series goes on: the numbers for the variable
/// there are too few for the poses to be exact.
const NEAREST: f64 = 1.0 / 256.0;
/// The smallest distance of an angle from a change point. A velocity there has an error of ε over the square of this
/// distance, and a series of five terms one of its fifth power.
const NEAREST_ANGLE: f64 = 2.5e-3;

/// The distance from a turning point that rounding makes, as a part of the sweep or of the variable.
const AT_LIMIT: f64 = 1e-13;

/// The part of the sweep beyond its ends at which turning points are sought.
const BEYOND: f64 = 1.0 / 1024.0;

/// The largest number of gaps and edges between rows.
const MOST_DIVISIONS: usize = 64;

/// The distance between two points of the curve at which it is sought for gaps, as a change of an angle that is an
/// input. A sweep has at least as many such points as a revolution.
const PROBE: f64 = TAU / 24.0;
const MOST_PROBES: f64 = 1e6;

/// The end of a stretch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum StretchEnd {
    /// The end of the sweep, with the variable at the other end if both are the same pose.
    Sweep,
    /// The end of the sweep, so short of a turning point that the curve is a root of the distance from it.
    ShortOf {
        /// The turning point beyond it.
        limit: f64,
    },
    /// Where two pieces of a law meet.
    Joint,
    /// Where the mechanism begins or ceases to close.
    Limit(LimitKind),
    /// A point inside of a smooth curve, where a stretch has been divided.
    Inside,
}

impl StretchEnd {
    /// Whether the next stretch begins here.
    pub(super) fn goes_on(self) -> bool {
        matches!(self, Self::Joint | Self::Inside | Self::Limit(LimitKind::ChangePoint))
    }
}

/// A part of the sweep on which the mechanism closes and the curve has no edge, with a separate parameter.
///
/// Towards a turning point the curve is a root of the variable. The parameter s makes it smooth again: the variable is
/// the limit plus `scale` s². At a change point, where branches cross, it is smooth in the variable itself, and its
/// rates jump. The closer to either of them, the more rounding errors of a pose are magnified, so a stretch ends short
/// of it, and its series goes on.
#[derive(Clone)]
pub(super) struct Stretch<'a> {
    /// The parameters at both ends, in the order of the sweep.
    pub(super) parameters: [f64; 2],
    pub(super) ends: [StretchEnd; 2],
    /// The limit at which the stretch begins or ends.
    pub(super) edge: Option<Edge>,
    /// A pose close to its start.
    pub(super) mark: Mark<'a>,
    /// Whether the sweep runs upwards.
    pub(super) runs_up: bool,
}

/// A limit, at the parameter zero.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    pub(super) at: f64,
    /// The end of the curve: the limit itself, or the end of a sweep short of it, with its parameter.
    pub(super) end: (f64, f64),
    /// The variable at the parameter one, as a distance from the limit.
    scale: f64,
    pub(super) kind: LimitKind,
    /// The smallest parameter.
    pub(super) nearest: f64,
}

impl Stretch<'_> {
    /// The variable as a series in the parameter.
    pub(super) fn variable(&self, parameter: f64) -> Local {
        let coefficients = match self.edge {
            None => [parameter, 1.0, 0.0, 0.0, 0.0],
            Some(Edge {
                at,
                scale,
                kind: LimitKind::ChangePoint,
                ..
            }) => [at + scale * parameter, scale, 0.0, 0.0, 0.0],
            Some(Edge { at, scale, .. }) => [
                at + scale * parameter * parameter,
                2.0 * scale * parameter,
                scale,
                0.0,
                0.0,
            ],
        };
        Local::from_coefficients(coefficients)
    }

    /// The value of the variable. The smallest parameter next to a limit stands for the limit itself.
    pub(super) fn value_of_variable(&self, parameter: f64) -> f64 {
        match self.edge {
            Some(edge) if parameter == edge.nearest => edge.end.0,
            _ => self.variable(parameter).real(),
        }
    }

    /// The distance of parameters that are neighbours. Next to zero, numbers are closer than any pose can distinguish.
    pub(super) fn resolution(&self) -> f64 {
        resolution(self.parameters)
    }

    /// Whether rates may grow beyond all bounds towards its limit.
    pub(super) fn may_grow(&self) -> bool {
        self.edge.is_some_and(|edge| edge.kind != LimitKind::ChangePoint)
    }
}

/// The distance of neighbours between two ends.
fn resolution(ends: [f64; 2]) -> f64 {
    16.0 * f64::EPSILON * ends[0].abs().max(ends[1].abs())
}

/// A point on the curve.
#[derive(Clone)]
pub(super) struct CurveNode<'a> {
    pub(super) parameter: f64,
    /// The variable of the sweep.
    pub(super) at: f64,
    /// The quantity as a series in the parameter.
    pub(super) value: Local,
    pub(super) mark: Mark<'a>,
}

/// A part of the sweep on which the mechanism closes: its ends with their kinds, and a pose.
type ClosedPart<'a> = ([f64; 2], [StretchEnd; 2], Mark<'a>);

/// A quantity over a sweep.
pub(super) struct Curve<'c> {
    pub(super) quantity: &'c QuantityOfSweep<'c>,
    pub(super) extent: SweepExtent,
    /// Points where the mechanism does not close, although it does in the rows on both sides.
    gaps: Vec<f64>,
    /// Change points and poles between rows that close.
    edges: Vec<(f64, LimitKind)>,
    /// The edge that a question has met.
    met: Cell<Option<(f64, LimitKind)>>,
    /// The walk to the node before, from which the next one is often closest.
    cursor: RefCell<Option<Mark<'c>>>,
    /// The size of the quantity in all stretches, as far as it has been seen.
    pub(super) size: Cell<f64>,
    /// The rounding errors of the poses for which pieces of a first piece have been accepted, without their growth
    /// towards a limit.
    pub(super) noise: Cell<f64>,
}

impl<'c> Curve<'c> {
    pub(super) fn new(quantity: &'c QuantityOfSweep<'c>) -> Self {
        Self {
            quantity,
            extent: quantity.extent(),
            gaps: Vec::new(),
            edges: Vec::new(),
            met: Cell::new(None),
            cursor: RefCell::new(None),
            size: Cell::new(0.0),
            noise: Cell::new(0.0),
        }
    }

    /// Reports that the sweep has been searched up to a point.
    pub(super) fn report(&self, at: f64) {
        if let Some(progress) = self.quantity.progress {
            progress((at - self.extent.from) / (self.extent.to - self.extent.from));
        }
    }

    /// The way of the first input for each unit of the variable.
    pub(super) fn way(&self, at: f64) -> f64 {
        self.quantity.way(at)
    }

    /// The answer to a question. A gap or an edge that it meets between two rows divides the sweep, and the question is
    /// asked again.
    ///
    /// Towards the ends of a gap the curve is a root, which no piece agrees with. So pieces are halved there until a
    /// point in the gap is met. The same holds for a change point, where rates jump, and for a pole.
    pub(super) fn across_gaps<T>(
        mut self,
        question: impl Fn(&Self) -> Result<T, ExtremesError>,
    ) -> Result<T, ExtremesError> {
        loop {
            let answer = question(&self);
            let is_full = self.gaps.len() + self.edges.len() >= MOST_DIVISIONS;
            match (&answer, self.met.take()) {
                (Err(ExtremesError::Gap { .. }), Some(edge)) if !is_full && !self.edges.contains(&edge) => {
                    self.edges.push(edge);
                }
                (Err(ExtremesError::Gap { at }), None)
                    if self.extent.has_assemblies && !is_full && !self.gaps.contains(at) =>
                {
                    self.gaps.push(*at);
                }
                _ => return answer,
            }
            self.cursor.replace(None);
        }
    }

    /// Ends the question, which is asked again with the sweep divided at an edge.
    pub(super) fn meet(&self, at: f64, kind: LimitKind) -> ExtremesError {
        self.met.set(Some((at, kind)));
        ExtremesError::Gap { at }
    }

    /// The change point or the pole between two nodes, if there is one.
    pub(super) fn edge_between(&self, left: &CurveNode<'c>, right: &CurveNode<'c>) -> Option<(f64, LimitKind)> {
        if !self.extent.has_assemblies {
            // a track from row to row has ended there
            return None;
        }
        let limit = self.quantity.limit(left.at, &left.mark, right.at)?;
        let is_between = (left.at.min(right.at) < limit.at) && (limit.at < left.at.max(right.at));
        let is_edge = matches!(limit.kind, LimitKind::ChangePoint | LimitKind::Pole);
        (is_edge && is_between).then_some((limit.at, limit.kind))
    }

    /// The rows, points between rows that are far apart, the end of the sweep if there is only one row, and the gaps,
    /// in the order of the sweep.
    fn points_to_visit(&self) -> Vec<f64> {
        let SweepExtent { to, rows, .. } = self.extent;
        let end = (rows == 1).then_some(to);
        let given: Vec<f64> = (0..rows).map(|row| self.quantity.row(row)).chain(end).collect();
        let mut points = given.clone();
        for pair in given.windows(2) {
            let count = self.probes([pair[0], pair[1]]);
            points
                .extend((1..count).map(|probe| pair[0] + (pair[1] - pair[0]) * (f64::from(probe) / f64::from(count))));
        }
        points.extend(&self.gaps);
        self.put_in_order(&mut points);
        points
    }

    /// Sorts points in the order of the sweep.
    fn put_in_order(&self, points: &mut Vec<f64>) {
        points.sort_by(f64::total_cmp);
        points.dedup();
        if self.extent.to < self.extent.from {
            points.reverse();
        }
    }

    /// The number of equal steps between two rows, so that none is longer than a probe.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a ratio from zero to the limit"
    )]
    fn probes(&self, [from, to]: [f64; 2]) -> u32 {
        let part = (to - from) / (self.extent.to - self.extent.from) * (TAU / PROBE);
        num_traits::Float::ceil(part.max(self.quantity.rotation([from, to]) / PROBE)).clamp(1.0, MOST_PROBES) as u32
    }

    /// The point with a parameter, found from a pose nearby.
    pub(super) fn node(
        &self,
        stretch: &Stretch<'c>,
        parameter: f64,
        near: &Mark<'c>,
    ) -> Result<CurveNode<'c>, ExtremesError> {
        let variable = stretch.variable(parameter);
        let at = variable.real();
        // At the end of a stretch the piece of the law before it counts.
        let is_last = parameter == stretch.parameters[1];
        let side = if is_last == stretch.runs_up {
            Side::Left
        } else {
            Side::Right
        };
        let (value, mark) = self.quantity.value(&self.closest(stretch, at, near), variable, side)?;
        self.cursor.replace(Some(mark.clone()));
        Ok(CurveNode {
            parameter,
            at,
            value,
            mark,
        })
    }

    /// The closer of two walks to a point of a stretch: the given one, or that to the node before if it is in the same
    /// stretch.
    fn closest(&self, stretch: &Stretch<'c>, at: f64, given: &Mark<'c>) -> Mark<'c> {
        let [one, other] = stretch.parameters.map(|parameter| stretch.variable(parameter).real());
        let is_inside = |point: f64| one.min(other) <= point && point <= one.max(other);
        let distance = |mark: &Mark<'c>| mark.at.map_or(f64::INFINITY, |last| (last - at).abs());
        match &*self.cursor.borrow() {
            Some(cursor) if cursor.at.is_some_and(is_inside) && distance(cursor) < distance(given) => cursor.clone(),
            _ => given.clone(),
        }
    }

    /// The stretches, in the order of the sweep.
    pub(super) fn stretches(&self) -> Result<Vec<Stretch<'c>>, ExtremesError> {
        self.quantity.check()?;
        let jumps = self.quantity.jumps.map_or_else(|| Ok(Vec::new()), |find| find())?;
        let circuits = match self.quantity.known() {
            Some((ends, mark)) => alloc::vec![([self.extent.from, self.extent.to], ends, mark)],
            None => self.circuits()?,
        };
        let first = circuits.first().map_or(self.extent.from, |([from, _], ..)| *from);
        let mut stretches = Vec::new();
        for (ends, kinds, mark) in circuits {
            let mut start = (ends[0], kinds[0]);
            for cut in self.cuts(ends, &jumps) {
                self.add(&mut stretches, [start, cut], &mark);
                start = cut;
            }
            self.add(&mut stretches, [start, (ends[1], kinds[1])], &mark);
        }
        if stretches.is_empty() {
            return Err(ExtremesError::NoLength { at: first });
        }
        self.see_size(&stretches)?;
        Ok(stretches)
    }

    /// The parts of the sweep on which the mechanism closes, each with a pose.
    fn circuits(&self) -> Result<Vec<ClosedPart<'c>>, ExtremesError> {
        let mut points = self.points_to_visit();
        let mut seen = self.circuits_at(&points);
        if !matches!(seen, Ok((_, None))) {
            let islands = self.islands(&points);
            if !islands.is_empty() {
                points.extend(islands);
                self.put_in_order(&mut points);
                seen = self.circuits_at(&points);
            }
        }
        let (mut circuits, first_error) = seen?;
        self.shorten(&mut circuits);
        if circuits.is_empty() {
            return Err(first_error.map_or(
                ExtremesError::Gap { at: self.extent.from },
                ExtremesError::NothingCloses,
            ));
        }
        self.join(&mut circuits);
        Ok(circuits)
    }

    /// The parts on which the mechanism closes, as some points show, and the error at the first point at which it does
    /// not.
    fn circuits_at(&self, points: &[f64]) -> Result<(Vec<ClosedPart<'c>>, Option<SolveError>), ExtremesError> {
        let mut circuits: Vec<ClosedPart<'c>> = Vec::new();
        let mut mark = Mark::new(Walk::BEGINNING);
        let mut first_error = None;
        // the row before: its point, its mark, and whether it closed
        let mut before: Option<(f64, Mark<'c>, bool)> = None;
        for at in points.iter().copied() {
            let result;
            (mark, result) = self.quantity.step(&mark, at);
            let is_closed = result.is_ok();
            if let Err(error) = result {
                first_error.get_or_insert(error);
            }
            match (&before, is_closed) {
                (None, true) => circuits.push(([at, at], [StretchEnd::Sweep, StretchEnd::Sweep], mark.clone())),
                (Some((previous, _, false)), true) => {
                    let (limit, kind) = self.limit(at, &mark, *previous)?;
                    circuits.push(([limit, at], [StretchEnd::Limit(kind), StretchEnd::Sweep], mark.clone()));
                }
                (Some((previous, there, true)), false) => {
                    let (limit, kind) = self.limit(*previous, there, at)?;
                    if let Some((ends, kinds, _)) = circuits.last_mut() {
                        (ends[1], kinds[1]) = (limit, StretchEnd::Limit(kind));
                    }
                }
                (Some((_, _, true)), true) => {
                    if let Some((ends, ..)) = circuits.last_mut() {
                        ends[1] = at;
                    }
                }
                _ => {}
            }
            before = Some((at, mark.clone(), is_closed));
        }
        Ok((circuits, first_error))
    }

    /// Looks for turning points close beyond the ends of the sweep, where no polynomial follows the curve.
    fn shorten(&self, circuits: &mut [ClosedPart<'c>]) {
        let SweepExtent { from, to, .. } = self.extent;
        if let Some((ends, kinds, mark)) = circuits.first_mut()
            && (ends[0], kinds[0]) == (from, StretchEnd::Sweep)
        {
            kinds[0] = self.turning_point_beyond([from, ends[1]], mark).unwrap_or(kinds[0]);
        }
        if let Some((ends, kinds, mark)) = circuits.last_mut()
            && (ends[1], kinds[1]) == (to, StretchEnd::Sweep)
        {
            kinds[1] = self.turning_point_beyond([to, ends[0]], mark).unwrap_or(kinds[1]);
        }
    }

    /// The turning point at which the curve ends close beyond the first of two points.
    fn turning_point_beyond(&self, [end, other]: [f64; 2], mark: &Mark<'c>) -> Option<StretchEnd> {
        let way = end - other;
        let beyond = end + BEYOND * way;
        if way == 0.0 || self.quantity.step(mark, beyond).1.is_ok() {
            return None;
        }
        // from a point that is as far on this side: a pose at the turning point itself leads nowhere
        let inside = end - BEYOND * way;
        let (mark, result) = self.quantity.step(mark, inside);
        result.ok()?;
        let limit = self.quantity.limit(inside, &mark, beyond)?;
        if limit.kind != LimitKind::TurningPoint {
            return None;
        }
        let rounding = AT_LIMIT * way.abs().max(end.abs());
        if (limit.at - end).abs() <= rounding {
            return Some(StretchEnd::Limit(limit.kind));
        }
        let is_beyond = (limit.at > end) == (beyond > end);
        is_beyond.then_some(StretchEnd::ShortOf { limit: limit.at })
    }

    /// Where the mechanism does not close at a single point only, the curve has a kink there and goes on.
    fn join(&self, circuits: &mut [ClosedPart<'c>]) {
        let nearest = resolution([self.extent.from, self.extent.to]);
        let end = StretchEnd::Limit(LimitKind::End);
        for index in 1..circuits.len() {
            let (before, behind) = circuits.split_at_mut(index);
            let (Some((from, kinds, _)), Some((to, next_kinds, _))) = (before.last_mut(), behind.first_mut()) else {
                continue;
            };
            if kinds[1] == end && next_kinds[0] == end && (to[0] - from[1]).abs() <= nearest {
                (kinds[1], next_kinds[0]) = (
                    StretchEnd::Limit(LimitKind::ChangePoint),
                    StretchEnd::Limit(LimitKind::ChangePoint),
                );
            }
        }
    }

    /// The joints of laws and the edges between two points, in the order from the first to the second.
    fn cuts(&self, ends: [f64; 2], jumps: &[f64]) -> Vec<(f64, StretchEnd)> {
        let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let inside = |(at, _): &&(f64, LimitKind)| low < *at && *at < high;
        let edges = self.edges.iter().filter(inside);
        let mut cuts: Vec<(f64, StretchEnd)> = edges.map(|(at, kind)| (*at, StretchEnd::Limit(*kind))).collect();
        let joints = self.quantity.joints(ends).into_iter();
        cuts.extend(joints.map(|joint| (joint, StretchEnd::Joint)));
        for &jump in jumps.iter().filter(|jump| low < **jump && **jump < high) {
            let near = |at: f64| (at - jump).abs() <= resolution(ends);
            if !near(low) && !near(high) && !cuts.iter().any(|(at, _)| near(*at)) {
                cuts.push((jump, StretchEnd::Joint));
            }
        }
        cuts.sort_by(|one, other| one.0.total_cmp(&other.0));
        cuts.dedup_by(|one, other| one.0 == other.0);
        if ends[0] > ends[1] {
            cuts.reverse();
        }
        cuts
    }

    /// The limit between a point that closes and one that does not, with its kind.
    fn limit(&self, closed: f64, mark: &Mark<'c>, unclosed: f64) -> Result<(f64, LimitKind), ExtremesError> {
        let found = |limit: Limit| (limit.at, limit.kind);
        if let Some(limit) = self.quantity.limit(closed, mark, unclosed) {
            return Ok(found(limit));
        }
        // an angle that an equation gives in -π ..= π may have jumped on the way, which stops a track
        let gap = || ExtremesError::Gap { at: unclosed };
        let near = self.quantity.edge(closed, unclosed);
        let (mark, result) = self.quantity.step(mark, near);
        result.map_err(|_| gap())?;
        if let Some(limit) = self.quantity.limit(near, &mark, unclosed) {
            return Ok(found(limit));
        }
        // a sweep that ends at a limit, up to rounding, ends on either side of it
        let rounding = AT_LIMIT * unclosed.abs().max((self.extent.to - self.extent.from).abs());
        if (unclosed - near).abs() <= rounding {
            return Ok((near, LimitKind::TurningPoint));
        }
        Err(gap())
    }

    /// Adds the stretches between two ends: two if it is bounded by limits on both sides. The end of a range or domain
    /// is taken for a turning point, as the mechanism may be one there, and a curve that is none is smooth in the root
    /// of the distance as well.
    fn add(&self, stretches: &mut Vec<Stretch<'c>>, [start, end]: [(f64, StretchEnd); 2], mark: &Mark<'c>) {
        if start.0 == end.0 {
            return;
        }
        let edges = [self.edge(start, end.0), self.edge(end, start.0)];
        if let [Some(_), Some(_)] = edges {
            let middle = (f64::midpoint(start.0, end.0), StretchEnd::Inside);
            self.add(stretches, [start, middle], mark);
            self.add(stretches, [middle, end], mark);
            return;
        }
        let parameters = match edges {
            [Some(edge), _] => [edge.nearest, 1.0],
            [None, Some(edge)] => [1.0, edge.nearest],
            [None, None] => [start.0, end.0],
        };
        stretches.push(Stretch {
            parameters,
            ends: [start.1, end.1],
            edge: edges[0].or(edges[1]),
            mark: mark.clone(),
            runs_up: self.extent.to >= self.extent.from,
        });
    }

    /// The limit at an end of a stretch, if there is one.
    fn edge(&self, (at, end): (f64, StretchEnd), other: f64) -> Option<Edge> {
        let (limit, kind) = match end {
            StretchEnd::Limit(kind) => (at, kind),
            StretchEnd::ShortOf { limit } => (limit, LimitKind::TurningPoint),
            StretchEnd::Sweep | StretchEnd::Joint | StretchEnd::Inside => return None,
        };
        let scale = other - limit;
        let nearest = match kind {
            LimitKind::ChangePoint if self.extent.is_angle => NEAREST.min(NEAREST_ANGLE / scale.abs()),
            _ => NEAREST,
        };
        let parameter = num_traits::Float::sqrt((at - limit) / scale);
        Some(Edge {
            at: limit,
            end: (at, parameter),
            scale,
            kind,
            nearest: nearest.max(parameter),
        })
    }
}
