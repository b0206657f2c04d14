//! A quantity as a curve over the variable of a sweep, in stretches without an edge.

use alloc::vec::Vec;
use core::cell::Cell;
use core::f64::consts::TAU;

use super::ExtremesError;
use super::at::{At, SweepPlace};
use crate::failure::SolveError;
use crate::law::Side;
use crate::load::LoadError;
use crate::mechanism::Mechanism;
use crate::number::{Number, Row};
use crate::quantity::Dimension;
use crate::sweep::{Course, Instant, Limit, LimitKind, Local, SmoothDrive, Variable, Walk, composed, limit_between};

/// The smallest parameter next to a turning point. Closer to it, a Taylor series goes on: the places of the variable there are too few for
/// the poses to be exact.
pub(super) const NEAREST: f64 = 1.0 / 256.0;

/// The largest number of gaps between rows.
const MOST_GAPS: usize = 64;

/// The end of a stretch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum StretchEnd {
    /// The end of the sweep, with the place of the other end if both are the same pose.
    Sweep,
    /// Where two pieces of a law meet.
    Joint,
    /// Where the mechanism begins or ceases to close.
    Limit(LimitKind),
    /// A place inside of a smooth curve, where a stretch has been divided.
    Inside,
}

/// A part of the sweep on which the mechanism closes and the curve has no edge, with its own parameter.
///
/// Towards a turning point the curve is a root of the variable. The parameter s makes it smooth again: the variable is the limit plus
/// `scale` s².
#[derive(Clone, Copy)]
pub(super) struct Stretch<M: Mechanism> {
    /// The parameters at both ends, in the order of the sweep.
    pub(super) parameters: [f64; 2],
    pub(super) ends: [StretchEnd; 2],
    /// The turning point and the scale, if the stretch begins or ends at one.
    pub(super) turning: Option<(f64, f64)>,
    /// A pose close to its start.
    pub(super) walk: Walk<M>,
    /// Whether the sweep runs upwards.
    pub(super) runs_up: bool,
}

impl<M: Mechanism> Stretch<M> {
    /// The variable as a series in the parameter.
    pub(super) fn variable(&self, parameter: f64) -> Local {
        match self.turning {
            None => Local::from_coefficients([parameter, 1.0, 0.0, 0.0, 0.0]),
            Some((limit, scale)) => Local::from_coefficients([
                limit + scale * parameter * parameter,
                2.0 * scale * parameter,
                scale,
                0.0,
                0.0,
            ]),
        }
    }

    /// The turning point at the smaller parameter.
    pub(super) fn turning_point(&self) -> Option<f64> {
        self.turning.map(|(limit, _)| limit)
    }
}

/// A place on the curve.
#[derive(Clone, Copy)]
pub(super) struct CurveNode<M: Mechanism> {
    pub(super) parameter: f64,
    /// The variable of the sweep.
    pub(super) at: f64,
    /// The quantity as a series in the parameter.
    pub(super) value: Local,
    pub(super) walk: Walk<M>,
}

/// A quantity of a pose.
pub(super) type PoseQuantity<'q, M> = dyn Fn(&At<M>) -> Result<Local, LoadError> + 'q;

/// A quantity over a sweep.
pub(super) struct Curve<'c, M: Mechanism<Scalar = f64>, D> {
    pub(super) course: &'c Course<M, D>,
    pub(super) series: M::With<Local>,
    long_series: M::With<Instant>,
    quantity: &'c PoseQuantity<'c, M>,
    /// Places where the mechanism does not close, although it does in the rows on both sides.
    gaps: Vec<f64>,
    /// The walk to the node before, from which the next one is often closest.
    cursor: Cell<Option<Walk<M>>>,
    /// Told the part of the sweep that has been searched.
    progress: Option<&'c dyn Fn(f64)>,
}

impl<'c, M: Mechanism<Scalar = f64>, D: SmoothDrive<M>> Curve<'c, M, D> {
    pub(super) fn new(course: &'c Course<M, D>, quantity: &'c PoseQuantity<'c, M>) -> Self {
        let series = course.mechanism.convert(Local::constant);
        Self {
            course,
            series,
            long_series: course.mechanism.convert(Instant::constant),
            quantity,
            gaps: Vec::new(),
            cursor: Cell::new(None),
            progress: None,
        }
    }

    /// The same curve, which tells how far it has been searched.
    pub(super) fn telling(self, progress: &'c dyn Fn(f64)) -> Self {
        Self {
            progress: Some(progress),
            ..self
        }
    }

    /// Tells that the sweep has been searched up to a place.
    pub(super) fn tell(&self, at: f64) {
        if let Some(progress) = self.progress {
            progress((at - self.course.from) / (self.course.to - self.course.from));
        }
    }

    /// The answer to a question. A gap that it meets between two rows divides the sweep, and the question is asked again.
    ///
    /// Towards the ends of a gap the curve is a root, which no piece agrees with. So pieces are halved there until a place in the gap
    /// is met.
    pub(super) fn across_gaps<T>(
        mut self,
        question: impl Fn(&Self) -> Result<T, ExtremesError>,
    ) -> Result<T, ExtremesError> {
        loop {
            match question(&self) {
                Err(ExtremesError::Gap { at })
                    if M::ASSEMBLY_COUNT > 0 && self.gaps.len() < MOST_GAPS && !self.gaps.contains(&at) =>
                {
                    self.gaps.push(at);
                }
                answer => return answer,
            }
        }
    }

    /// The rows, the end of the sweep if there is only one, and between them the gaps, in the order of the sweep.
    fn places(&self) -> Vec<f64> {
        let course = self.course;
        let rows = (0..course.count).map(|row| course.at(row));
        let end = (course.count == 1).then_some(course.to);
        let mut places: Vec<f64> = rows.chain(end).chain(self.gaps.iter().copied()).collect();
        if !self.gaps.is_empty() {
            places.sort_by(f64::total_cmp);
            if course.to < course.from {
                places.reverse();
            }
        }
        places
    }

    /// The place with a parameter, found from a pose nearby.
    pub(super) fn node(
        &self,
        stretch: &Stretch<M>,
        parameter: f64,
        near: Walk<M>,
    ) -> Result<CurveNode<M>, ExtremesError> {
        let variable = stretch.variable(parameter);
        let at = variable.real();
        // At the end of a stretch its own piece of the law counts.
        let is_last = parameter == stretch.parameters[1];
        let side = if is_last == stretch.runs_up {
            Side::Left
        } else {
            Side::Right
        };
        let (value, walk) = self.value(None, variable, side, self.closest(stretch, at, near))?;
        self.cursor.set(Some(walk));
        Ok(CurveNode {
            parameter,
            at,
            value,
            walk,
        })
    }

    /// The closer of two walks to a place of a stretch: the given one, or that to the node before if it is in the same stretch.
    fn closest(&self, stretch: &Stretch<M>, at: f64, given: Walk<M>) -> Walk<M> {
        let [one, other] = stretch.parameters.map(|parameter| stretch.variable(parameter).real());
        let is_inside = |place: f64| one.min(other) <= place && place <= one.max(other);
        let distance = |walk: &Walk<M>| walk.last.map_or(f64::INFINITY, |last| (last.at - at).abs());
        let cursor = self
            .cursor
            .get()
            .filter(|cursor| cursor.last.is_some_and(|last| is_inside(last.at)));
        match cursor {
            Some(cursor) if distance(&cursor) < distance(&given) => cursor,
            _ => given,
        }
    }

    /// The quantity for a mechanism and a variable that change together, found from a pose nearby. Without a mechanism it is that of the
    /// sweep; with one, derivatives above its order are not known.
    pub(super) fn value(
        &self,
        mechanism: Option<&M::With<Local>>,
        variable: Local,
        side: Side,
        near: Walk<M>,
    ) -> Result<(Local, Walk<M>), ExtremesError> {
        let at = variable.real();
        let drive = &self.course.drive;
        let source = SweepPlace {
            mechanism: self.long_series,
            inputs: drive.derivatives(at, side),
            unknowns: Row::splat(0.0),
            rate: drive.rate(),
            variable,
        };
        let own = mechanism.is_none().then_some(source);
        let mechanism = mechanism.unwrap_or(&self.series);
        let inputs = drive.series(at, side);
        let mut walk = near;
        let motions = Row::from_fn(|input| Row::from_fn(|order| inputs[input][order].real()));
        let gap = |_: SolveError| ExtremesError::Gap { at };
        let reached = walk.step(self.course, at, motions).map_err(gap)?.footing;
        let inputs = Row::from_fn(|input| Row::from_fn(|order| composed(inputs[input][order], variable)));
        let pose = mechanism
            .solve_motion_near(
                inputs,
                Row::from_fn(|unknown| Local::constant(reached.unknowns[unknown])),
            )
            .map_err(gap)?;
        let value = (self.quantity)(&At {
            mechanism: *mechanism,
            pose,
            inputs,
            near: Row::from_fn(|unknown| Local::constant(reached.unknowns[unknown])),
            outputs: reached.outputs,
            source: own.map(|source| SweepPlace {
                unknowns: reached.unknowns,
                ..source
            }),
        });
        let value = value.map_err(|error| ExtremesError::Load {
            at,
            error: alloc::boxed::Box::new(error),
        })?;
        if !Number::is_finite(value) {
            return Err(ExtremesError::NotFinite { at });
        }
        Ok((value, walk))
    }

    /// Whether the sweep is one full turn of the only input that moves.
    pub(super) fn is_full_turn(&self) -> bool {
        let way = (self.course.to - self.course.from).abs();
        let is_turn = (way - TAU).abs() <= 8.0 * f64::EPSILON * self.course.to.abs().max(self.course.from.abs());
        let Variable::Input(lead) = self.course.drive.variable() else {
            return false;
        };
        let is_alone =
            (0..M::DESCRIPTION.inputs.len()).all(|input| input == lead || self.course.drive.same(input, 0).is_some());
        is_turn && is_alone && M::DESCRIPTION.inputs[lead].dimension == Dimension::Angle
    }

    /// The stretches, in the order of the sweep.
    pub(super) fn stretches(&self) -> Result<Vec<Stretch<M>>, ExtremesError> {
        self.course.check()?;
        let course = self.course;
        let runs_up = course.to >= course.from;
        let mut circuits: Vec<([f64; 2], [StretchEnd; 2], Walk<M>)> = Vec::new();
        let mut walk = Walk::BEGINNING;
        let mut first_error = None;
        // the row before: its place, its walk, and whether it closed
        let mut before: Option<(f64, Walk<M>, bool)> = None;
        for at in self.places() {
            let result = walk.step(course, at, course.drive.motions(at));
            let is_closed = result.is_ok();
            if let Err(error) = result {
                first_error.get_or_insert(error);
            }
            match (before, is_closed) {
                (None, true) => circuits.push(([at, at], [StretchEnd::Sweep, StretchEnd::Sweep], walk)),
                (Some((place, _, false)), true) => {
                    let limit = self.limit(at, &walk, place)?;
                    circuits.push(([limit.at, at], [StretchEnd::Limit(limit.kind), StretchEnd::Sweep], walk));
                }
                (Some((place, there, true)), false) => {
                    let limit = self.limit(place, &there, at)?;
                    if let Some((ends, kinds, _)) = circuits.last_mut() {
                        (ends[1], kinds[1]) = (limit.at, StretchEnd::Limit(limit.kind));
                    }
                }
                (Some((_, _, true)), true) => {
                    if let Some((ends, ..)) = circuits.last_mut() {
                        ends[1] = at;
                    }
                }
                _ => {}
            }
            before = Some((at, walk, is_closed));
        }
        let Some(&([first, _], ..)) = circuits.first() else {
            return Err(first_error.map_or(ExtremesError::Gap { at: course.from }, ExtremesError::NothingCloses));
        };
        let mut stretches = Vec::new();
        for (ends, kinds, walk) in circuits {
            let mut start = (ends[0], kinds[0]);
            for joint in course.joints(ends) {
                add(&mut stretches, [start, (joint, StretchEnd::Joint)], walk, runs_up);
                start = (joint, StretchEnd::Joint);
            }
            add(&mut stretches, [start, (ends[1], kinds[1])], walk, runs_up);
        }
        if stretches.is_empty() {
            return Err(ExtremesError::NoLength { at: first });
        }
        Ok(stretches)
    }

    fn limit(&self, closed: f64, walk: &Walk<M>, open: f64) -> Result<Limit, ExtremesError> {
        let last = walk.last.ok_or(ExtremesError::Gap { at: open })?;
        limit_between(self.course, closed, last.unknowns, open).ok_or(ExtremesError::Gap { at: open })
    }
}

/// Adds the stretches between two ends: two if it is bounded by limits on both sides. The end of a range or domain is taken for a turning
/// point, as the mechanism may be one there, and a curve that is none is smooth in the root of the distance as well.
fn add<M: Mechanism<Scalar = f64>>(
    stretches: &mut Vec<Stretch<M>>,
    [start, end]: [(f64, StretchEnd); 2],
    walk: Walk<M>,
    runs_up: bool,
) {
    if start.0 == end.0 {
        return;
    }
    let turns = |end: StretchEnd| matches!(end, StretchEnd::Limit(_));
    match (turns(start.1), turns(end.1)) {
        (true, true) => {
            let middle = (f64::midpoint(start.0, end.0), StretchEnd::Inside);
            add(stretches, [start, middle], walk, runs_up);
            add(stretches, [middle, end], walk, runs_up);
        }
        (true, false) => stretches.push(Stretch {
            parameters: [NEAREST, 1.0],
            ends: [start.1, end.1],
            turning: Some((start.0, end.0 - start.0)),
            walk,
            runs_up,
        }),
        (false, true) => stretches.push(Stretch {
            parameters: [1.0, NEAREST],
            ends: [start.1, end.1],
            turning: Some((end.0, start.0 - end.0)),
            walk,
            runs_up,
        }),
        (false, false) => stretches.push(Stretch {
            parameters: [start.0, end.0],
            ends: [start.1, end.1],
            turning: None,
            walk,
            runs_up,
        }),
    }
}
