//! Islands: parts of a sweep on which the mechanism closes, between rows at which it does not.

use alloc::vec::Vec;

use super::curve::Curve;
use super::swept::MissingLength;
use crate::quantity::Name;

/// The distance at which a missing length is compared with itself, as a part of the sweep.
const BESIDE: f64 = 1e-7;

/// The steps of Newton's method for a missing length, and the part of the way that it may go to where the mechanism
/// closes.
const NEWTON: usize = 24;
const SHORT_STEP: f64 = 0.01;

/// The steps of a search for an island. A narrower one is missed.
const SECTIONS: usize = 40;

impl Curve<'_> {
    /// Points in islands between others, of which some do not close.
    pub(super) fn islands(&self, points: &[f64]) -> Vec<f64> {
        if !self.extent.has_assemblies {
            return Vec::new();
        }
        let beside = BESIDE * (self.extent.to - self.extent.from);
        let unclosed: Vec<Option<[MissingLength; 3]>> =
            points.iter().map(|at| self.missing_around(*at, beside)).collect();
        let mut islands = Vec::new();
        for (pair, at) in unclosed.windows(2).zip(points.windows(2)) {
            let from = |side: usize| self.closing([at[side], at[1 - side]], pair[side]?[0].block);
            let closing = [from(0), from(1)];
            islands.extend(closing.into_iter().flatten());
            if let ([None, None], [Some([one, .., after]), Some([other, before, ..])]) = (closing, pair)
                && [after, other, before].iter().all(|missing| missing.block == one.block)
                && after.length < one.length
                && before.length < other.length
            {
                islands.extend(self.island([at[0], at[1]], one.block));
            }
        }
        islands
    }

    /// The missing lengths at a point, before it and behind it, if the mechanism closes at none of them.
    fn missing_around(&self, at: f64, beside: f64) -> Option<[MissingLength; 3]> {
        let missing = |at: f64| self.quantity.missing(at);
        Some([missing(at)?, missing(at - beside)?, missing(at + beside)?])
    }

    /// The first point on the way from one point to another at which a block closes, by Newton's method for the missing
    /// length. A step that leads to where more is missing again, or that closes after a long way, may have gone too
    /// far, and is halved.
    fn closing(&self, [from, to]: [f64; 2], block: Name) -> Option<f64> {
        let beside = BESIDE * (to - from);
        // a point with its step
        let seen = |at: f64| {
            let missing = self.quantity.missing(at)?;
            let there = self.quantity.missing(at + beside)?;
            Some((
                missing.block == block,
                -missing.length * beside / (there.length - missing.length),
            ))
        };
        let (mut at, mut step) = (from, seen(from)?.1);
        for _ in 0..NEWTON {
            let way = to - at;
            if step * way <= 0.0 {
                return None;
            }
            if step.abs() > 0.5 * way.abs() {
                step = 0.5 * way;
            }
            // a bit beyond, where it may close already
            let next = at + step + beside;
            match seen(next) {
                None if step.abs() <= SHORT_STEP * (to - from).abs() => return Some(next),
                Some((true, next_step)) if next_step * way > 0.0 => (at, step) = (next, next_step),
                _ => step = 0.5 * (next - at),
            }
        }
        None
    }

    /// A point between two others at which the mechanism closes, by a search for the least missing length of a block.
    /// (J. Kiefer, Sequential minimax search for a maximum, Proceedings of the American Mathematical Society 4, 1953,
    /// 502-506: golden sections.)
    fn island(&self, [mut low, mut high]: [f64; 2], block: Name) -> Option<f64> {
        let part = 0.5 * (num_traits::Float::sqrt(5.0_f64) - 1.0);
        let missing = |at: f64| match self.quantity.missing(at) {
            None => Err(at),
            Some(missing) if missing.block == block => Ok(missing.length),
            Some(_) => Ok(f64::INFINITY),
        };
        let mut search = || {
            let mut points = [high - part * (high - low), low + part * (high - low)];
            let mut lengths = [missing(points[0])?, missing(points[1])?];
            for _ in 0..SECTIONS {
                if lengths[0] <= lengths[1] {
                    high = points[1];
                    points = [high - part * (high - low), points[0]];
                    lengths = [missing(points[0])?, lengths[0]];
                } else {
                    low = points[0];
                    points = [points[1], low + part * (high - low)];
                    lengths = [lengths[1], missing(points[1])?];
                }
            }
            Ok(())
        };
        search().err()
    }
}
