//! A stretch of a curve in pieces that agree with the poses between them.

use super::ExtremesError;
use super::curve::{Curve, CurveNode, Stretch};
use crate::curve::LimitKind;
use crate::hermite::Piece;
use crate::number::Number;
use crate::sweep::Local;

/// The first pieces of a revolution of an angle, or of the whole sweep.
const FIRST_PIECES: f64 = 24.0;
/// The largest difference between a piece and the poses, as a part of the piece's range.
const AGREEMENT: f64 = 1e-8;
/// The largest difference by rounding, as a part of the size of the quantity: its terms may be this many times larger
/// than itself, in units of ε.
pub(super) const ROUNDING: f64 = 1e4 * f64::EPSILON;
/// The largest number of divisions of one stretch, and those that each of its first pieces adds.
const MOST_DIVISIONS: [usize; 2] = [20_000, 8];
/// The number of halvings after which the rounding errors of the poses are measured.
const MEASURED_DEPTH: usize = 4;
/// The number of halvings after which a change point or a pole is sought between the ends of a piece.
const SUSPECT: usize = 8;
/// Distances from a point that may be a pole, in lengths of the shortest piece, and the growth from each of them to the
/// next smaller one.
const DISTANCES: [f64; 4] = [1e3, 4e3, 16e3, 64e3];
const POLE_GROWTH: f64 = 1.3;
/// The distance between points that differ by rounding errors alone, as a part of the piece.
pub(super) const BESIDE: f64 = 1.0 / 1024.0;
/// The largest difference between a piece and the poses, and the smallest range with an extreme, in measured rounding
/// errors.
const MEASURED: [f64; 2] = [8.0, 64.0];

/// The smallest parameter next to a limit whose value counts for the size of the quantity.
const BESIDE_LIMIT: f64 = 0.1;
/// Points of a stretch at which the size of the quantity is read, as parts of it.
const SIZED: [f64; 4] = [0.2, 0.4, 0.6, 0.8];

/// A part of a curve.
pub(super) enum CurvePart {
    /// A piece that agrees with the poses.
    Piece(Piece),
    /// Two neighbouring points between which the values differ by rounding errors alone.
    Flat,
    /// Two neighbouring points between which the curve has a kink or a jump.
    Kink,
}

/// Called with every part and the nodes at its ends.
type VisitPart<'v, 'c> = dyn FnMut(&CurvePart, [&CurveNode<'c>; 2]) -> Result<(), ExtremesError> + 'v;

impl<'c> Curve<'c> {
    /// Divides a stretch into parts, and passes on each with its ends. It returns the nodes at both ends of the
    /// stretch.
    ///
    /// If the stretch is a full revolution, its end is its beginning, so that an extreme on the seam is found once.
    pub(super) fn parts(
        &self,
        stretch: &Stretch<'c>,
        is_revolution: bool,
        visit: &mut VisitPart<'_, 'c>,
    ) -> Result<[CurveNode<'c>; 2], ExtremesError> {
        let [from, to] = stretch.parameters;
        let way = (stretch.variable(to).real() - stretch.variable(from).real()).abs();
        let unit = if self.extent.is_angle {
            core::f64::consts::TAU
        } else {
            (self.extent.to - self.extent.from).abs()
        };
        let count = num_traits::Float::ceil(FIRST_PIECES * way / unit).max(4.0);
        let first = self.node(stretch, from, &stretch.mark)?;
        let mut left = first.clone();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a count from 4 on, and the conversion ends at the largest number"
        )]
        let mut budget = MOST_DIVISIONS[0].saturating_add(MOST_DIVISIONS[1].saturating_mul(count as usize));
        let mut size = self.size.get();
        let mut index = 0.0;
        while index < count {
            index += 1.0;
            let parameter = if index == count {
                to
            } else {
                from + (to - from) * (index / count)
            };
            let mut right = self.node(stretch, parameter, &left.mark)?;
            if is_revolution && index == count {
                right.value = first.value;
            }
            // next to a turning point rates are far larger than elsewhere
            if stretch.edge.is_none() || left.parameter.min(right.parameter) > BESIDE_LIMIT {
                size = size.max(right.value.real().abs());
            }
            self.noise.set(0.0);
            self.divide(stretch, [&left, &right], 0, size, &mut budget, visit)?;
            self.size.set(self.size.get().max(size));
            left = right;
            self.report(left.at);
        }
        Ok([first, left])
    }

    /// Looks at the size of the quantity in all stretches: where it should be zero on one of them, it is made of
    /// rounding errors, whose size others give.
    pub(super) fn see_size(&self, stretches: &[Stretch<'c>]) -> Result<(), ExtremesError> {
        let mut size: f64 = 0.0;
        // a single stretch gives its size itself
        for stretch in stretches.iter().filter(|_| stretches.len() > 1) {
            let [from, to] = stretch.parameters;
            for part in SIZED {
                let parameter = from + part * (to - from);
                if stretch.edge.is_none() || parameter > BESIDE_LIMIT {
                    let node = self.node(stretch, parameter, &stretch.mark)?;
                    size = size.max(node.value.real().abs());
                }
            }
        }
        self.size.set(size);
        Ok(())
    }

    fn divide(
        &self,
        stretch: &Stretch<'c>,
        [left, right]: [&CurveNode<'c>; 2],
        depth: usize,
        size: f64,
        budget: &mut usize,
        visit: &mut VisitPart<'_, 'c>,
    ) -> Result<(), ExtremesError> {
        let ends = [left.parameter, right.parameter];
        let piece = Piece::new(ends, [left.value, right.value]);
        let at = |part: f64| ends[0] + part * (ends[1] - ends[0]);
        let middle = self.node(stretch, f64::midpoint(ends[0], ends[1]), &left.mark)?;
        if depth == SUSPECT
            && let Some((at, kind)) = self.edge_between(left, right)
        {
            return Err(self.meet(at, kind));
        }
        if (ends[1] - ends[0]).abs() <= stretch.resolution() {
            if self.is_pole(stretch, [left, right])? {
                return Err(self.meet(middle.at, LimitKind::Pole));
            }
            return visit(&CurvePart::Kink, [left, right]);
        }
        let [low, high] = piece.bounds();
        let largest = left
            .value
            .real()
            .abs()
            .max(right.value.real().abs())
            .max(middle.value.real().abs());
        // rounding of the variable counts as its root next to a turning point
        let nearest = ends[0].abs().min(ends[1].abs());
        let growth = match stretch.edge {
            Some(_) => 1.0 + 1.0 / (nearest * nearest),
            None => 1.0,
        };
        let tolerance = AGREEMENT * (high - low) + ROUNDING * (largest * growth).max(size);
        let apart = |node: &CurveNode<'c>| (piece.at(node.parameter).real() - node.value.real()).abs();
        let mut apart_most = apart(&middle);
        // the node that is furthest from the piece
        let mut furthest = None;
        if apart_most <= tolerance || depth >= MEASURED_DEPTH {
            for part in [1.0 / 3.0, 2.0 / 3.0] {
                let node = self.node(stretch, at(part), &left.mark)?;
                if apart(&node) > apart_most {
                    apart_most = apart(&node);
                    furthest = Some(node);
                }
            }
        }
        if apart_most <= tolerance {
            let is_flat = high - low <= ROUNDING * largest.max(size);
            let part = if is_flat {
                CurvePart::Flat
            } else {
                CurvePart::Piece(piece)
            };
            return visit(&part, [left, right]);
        }
        if depth >= MEASURED_DEPTH {
            // Where a quantity should be zero, some poses have a rounding error and others have none: those that
            // differ, the ends, and those of the pieces before.
            let mut rounding = self.noise.get() * growth;
            // The ends are looked at now and then: at a kink, which is none of this, pieces are halved all the way.
            let nodes = [furthest.as_ref().unwrap_or(&middle), left, right];
            for node in nodes
                .into_iter()
                .take(if depth.is_multiple_of(MEASURED_DEPTH) { 3 } else { 1 })
            {
                rounding = rounding.max(self.rounding(stretch, node, BESIDE * (ends[1] - ends[0]))?);
                let [agreement, flat] = MEASURED.map(|times| times * rounding);
                let part = if high - low <= flat && apart_most <= flat {
                    CurvePart::Flat
                } else if apart_most <= agreement {
                    CurvePart::Piece(piece)
                } else {
                    continue;
                };
                self.noise.set(rounding / growth);
                return visit(&part, [left, right]);
            }
        }
        *budget = budget.checked_sub(1).ok_or(ExtremesError::Unresolved {
            at: middle.at,
            difference: apart_most,
        })?;
        self.divide(stretch, [left, &middle], depth + 1, size, budget, visit)?;
        self.divide(stretch, [&middle, right], depth + 1, size, budget, visit)
    }

    /// Whether the quantity grows beyond all bounds between two neighbouring points: on one side it grows from distance
    /// to distance.
    fn is_pole(&self, stretch: &Stretch<'c>, [left, right]: [&CurveNode<'c>; 2]) -> Result<bool, ExtremesError> {
        let [low, high] = [
            stretch.parameters[0].min(stretch.parameters[1]),
            stretch.parameters[0].max(stretch.parameters[1]),
        ];
        let way = right.parameter - left.parameter;
        for (node, away) in [(left, -way), (right, way)] {
            let mut sizes = [0.0; DISTANCES.len()];
            let mut is_inside = true;
            for (size, distance) in sizes.iter_mut().zip(DISTANCES) {
                let parameter = node.parameter + distance * away;
                is_inside &= low <= parameter && parameter <= high;
                if is_inside {
                    *size = self.node(stretch, parameter, &node.mark)?.value.real().abs();
                }
            }
            if is_inside && sizes.windows(2).all(|pair| pair[0] >= POLE_GROWTH * pair[1]) && sizes[0] > 0.0 {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether the quantity at a node is made of rounding errors, as points show that are much closer than a distance.
    pub(super) fn is_rounding(
        &self,
        stretch: &Stretch<'c>,
        node: &CurveNode<'c>,
        distance: f64,
    ) -> Result<bool, ExtremesError> {
        let [_, flat] = MEASURED;
        Ok(node.value.real().abs() <= flat * self.rounding(stretch, node, BESIDE * distance)?)
    }

    /// The rounding error of the quantity, as points that are close together show it: the difference between poses and
    /// the Taylor series of a pose beside them. On one side of a jump the series holds, so the smaller difference of
    /// both sides counts. An end of a stretch has one side, and none is known there.
    pub(super) fn rounding(
        &self,
        stretch: &Stretch<'c>,
        node: &CurveNode<'c>,
        step: f64,
    ) -> Result<f64, ExtremesError> {
        if stretch.parameters.contains(&node.parameter) {
            return Ok(0.0);
        }
        let mut sides = [0.0_f64; 2];
        for (side, sign) in sides.iter_mut().zip([-1.0, 1.0]) {
            for times in [1.0, 2.0] {
                let beside = self.node(stretch, node.parameter + sign * times * step, &node.mark)?;
                let way = beside.parameter - node.parameter;
                let coefficients = node.value.coefficients();
                let expected = coefficients
                    .iter()
                    .rfold(0.0, |sum, coefficient| sum * way + coefficient);
                *side = side.max((beside.value.real() - expected).abs());
            }
        }
        Ok(sides[0].min(sides[1]))
    }

    /// The point where a function of the series vanishes, by Newton's method from a point nearby. The function returns
    /// its value and its slope.
    pub(super) fn refined(
        &self,
        stretch: &Stretch<'c>,
        [left, right]: [&CurveNode<'c>; 2],
        start: f64,
        function: impl Fn(Local) -> (f64, f64),
    ) -> Result<CurveNode<'c>, ExtremesError> {
        let (low, high) = (left.parameter.min(right.parameter), left.parameter.max(right.parameter));
        let mut node = self.node(stretch, start, &left.mark)?;
        let mut last = f64::INFINITY;
        for _ in 0..ITERATIONS {
            let (value, slope) = function(node.value);
            let step = -value / slope;
            let next = (node.parameter + step).clamp(low, high);
            // rounding errors move the point to and fro
            if !step.is_finite() || step.abs() >= 0.5 * last || next == node.parameter {
                break;
            }
            last = step.abs();
            node = self.node(stretch, next, &node.mark)?;
        }
        Ok(node)
    }
}

const ITERATIONS: usize = 12;
