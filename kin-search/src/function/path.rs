//! The function of a mechanism that measures for each row how far the path of a point is from wanted points.

use datafusion::arrow::array::StructArray;
use datafusion::arrow::datatypes::{DataType, Fields};
use datafusion::common::{Result, exec_err};

use super::arguments::Argument;
use super::numbers;
use super::points::Points;
use super::search::{Call, Search, function_of_a_search};
use super::solver::SearchedMechanism;
use super::trace::{Trace, point_of, share};

/// A function such as `hoeken_linkage_path_error('points', ground, crank, coupler, …)`.
#[derive(Debug)]
pub(crate) struct PathFunction {
    search: Search,
    point: usize,
    fields: Fields,
}

/// The ending of the names of these functions.
pub(crate) const ENDING: &str = "path_error";

const FIELDS: [&str; 3] = ["closed", "rms", "largest"];

const TEXT: &str = "How far the path of a point is from wanted points. rms is the root mean square of their distances \
from the path, and largest the largest distance; closed is the share of the poses that close. The path is the line \
through the poses that close. With timing, a distance is that of the wanted point from the point at its own value of \
the input. The point is the first output in the plane.";

const POINTS: &str = "The wanted points: the name of a table with the columns x and y, or input, x and y for \
prescribed timing; or the points themselves, as in '0 1; 0.5 1.2'";

impl PathFunction {
    /// The function, if the mechanism has a point in the plane.
    pub(crate) fn new(mechanism: &SearchedMechanism) -> Option<Self> {
        let point = point_of(mechanism.description())?;
        Some(Self {
            search: Search::new(mechanism, ENDING, vec![Argument::text("points", POINTS)], TEXT),
            point,
            fields: numbers::fields(FIELDS),
        })
    }

    fn evaluate(&self, call: &Call<'_>) -> Result<StructArray> {
        let mut trace = Trace::default();
        let mut known: Option<(String, Points)> = None;
        numbers::rows(&self.fields, call, |row| {
            let (Some(candidate), Some(text)) = (call.candidate(row)?, call.texts[0].at(row)) else {
                return Ok([None; 3]);
            };
            if known.as_ref().is_none_or(|(known_text, _)| known_text != text) {
                known = Some((text.to_owned(), Points::parse(text)?));
            }
            let Some((_, points)) = &known else {
                return exec_err!("{} has no points", self.search.name);
            };
            let (grid, solver) = (candidate.grid, &*self.search.mechanism);
            let squares = match points {
                Points::Free(free) => {
                    let inputs = (0..grid.poses).map(|pose| grid.value(pose));
                    trace.solve(solver, &candidate, inputs, self.point, call.vectors)?;
                    distances(&trace, free, candidate.is_whole)
                }
                Points::Timed(timed) => {
                    let inputs = timed.iter().map(|[input, _, _]| *input);
                    trace.solve(solver, &candidate, inputs, self.point, call.vectors)?;
                    timed_distances(&trace, timed)
                }
            };
            let (sum, largest) = squares.unzip();
            let mean = sum.map(|sum| sum / share(points.len(), 1));
            let closed = share(trace.closed(), trace.poses());
            Ok([Some(closed), mean.map(f64::sqrt), largest.map(f64::sqrt)])
        })
    }
}

function_of_a_search!(PathFunction);

/// The sum and the largest of the squared distances of points from a path; `None` if no pose closes.
fn distances(trace: &Trace, points: &[[f64; 2]], is_round: bool) -> Option<(f64, f64)> {
    let poses = trace.poses();
    let (mut sum, mut largest) = (0.0, 0.0_f64);
    for point in points {
        let mut nearest = f64::INFINITY;
        for pose in (0..poses).filter(|pose| trace.is_closed(*pose)) {
            let next = if pose + 1 < poses { pose + 1 } else { 0 };
            let goes_on = (next > pose || is_round) && trace.is_closed(next);
            let end = if goes_on { trace.point(next) } else { trace.point(pose) };
            nearest = nearest.min(from_segment(*point, trace.point(pose), end));
        }
        if nearest == f64::INFINITY {
            return None;
        }
        sum += nearest;
        largest = largest.max(nearest);
    }
    Some((sum, largest))
}

/// The sum and the largest of the squared distances of points from those of the same poses; `None` if a pose does not
/// close.
fn timed_distances(trace: &Trace, points: &[[f64; 3]]) -> Option<(f64, f64)> {
    let (mut sum, mut largest) = (0.0, 0.0_f64);
    for (pose, [_, x, y]) in points.iter().enumerate() {
        if !trace.is_closed(pose) {
            return None;
        }
        let [point_x, point_y] = trace.point(pose);
        let square = (point_x - x).powi(2) + (point_y - y).powi(2);
        sum += square;
        largest = largest.max(square);
    }
    Some((sum, largest))
}

/// The squared distance of a point from a segment.
fn from_segment([x, y]: [f64; 2], [from_x, from_y]: [f64; 2], [to_x, to_y]: [f64; 2]) -> f64 {
    let (way_x, way_y) = (to_x - from_x, to_y - from_y);
    let (offset_x, offset_y) = (x - from_x, y - from_y);
    let square = way_x * way_x + way_y * way_y;
    let part = if square > 0.0 {
        ((offset_x * way_x + offset_y * way_y) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (offset_x - part * way_x).powi(2) + (offset_y - part * way_y).powi(2)
}

#[cfg(test)]
mod tests {
    use super::from_segment;

    #[test]
    fn the_nearest_point_of_a_segment_is_inside_or_an_end() {
        let from = |point| from_segment(point, [0.0, 0.0], [2.0, 0.0]);
        assert_eq!(from([1.0, 3.0]), 9.0);
        assert_eq!(from([-3.0, 4.0]), 25.0);
        assert_eq!(from([5.0, 4.0]), 25.0);
        assert_eq!(from_segment([3.0, 4.0], [0.0, 0.0], [0.0, 0.0]), 25.0);
    }
}
