//! The function of a mechanism that measures for each row how straight a point moves.

use datafusion::arrow::array::StructArray;
use datafusion::arrow::datatypes::{DataType, Fields};
use datafusion::common::{Result, exec_err};

use super::numbers;
use super::search::{Call, Search, function_of_a_search};
use super::solver::SearchedMechanism;
use super::trace::{Trace, point_of, share};

/// A function such as `hoeken_linkage_line(ground, crank, coupler, …)`.
#[derive(Debug)]
pub(crate) struct LineFunction {
    search: Search,
    point: usize,
    fields: Fields,
}

const FIELDS: [&str; 4] = ["closed", "length", "deviation", "unevenness"];

const TEXT: &str = "How straight and how evenly a point moves over a part of a revolution, measured along and across \
the chord between its ends. closed is the share of the poses that close; length is the length of the chord; deviation \
is the width of the path across the chord, as a share of the chord; unevenness is the largest less the smallest speed \
along the chord, as a share of the mean speed (R. L. Norton, Design of Machinery, table of Hoeken's linkages). The \
point is the first output in the plane.";

impl LineFunction {
    /// The function, if the mechanism has a point in the plane.
    pub(crate) fn new(mechanism: &SearchedMechanism) -> Option<Self> {
        let point = point_of(mechanism.description())?;
        Some(Self {
            search: Search::new(mechanism, "line", Vec::new(), TEXT),
            point,
            fields: numbers::fields(FIELDS),
        })
    }

    fn evaluate(&self, call: &Call<'_>) -> Result<StructArray> {
        let mut trace = Trace::default();
        numbers::rows(&self.fields, call, |row| {
            let Some(candidate) = call.candidate(row)? else {
                return Ok([None; 4]);
            };
            if candidate.is_whole {
                return exec_err!(
                    "{} measures a part of a revolution: give `from` and `to`, in radians",
                    self.search.name
                );
            }
            let grid = candidate.grid;
            let inputs = (0..grid.poses).map(|pose| grid.value(pose));
            trace.solve(&*self.search.mechanism, &candidate, inputs, self.point, call.vectors)?;
            let closed = share(trace.closed(), trace.poses());
            let [length, deviation, unevenness] = stroke(&trace).map_or([None; 3], |stroke| stroke.map(Some));
            Ok([Some(closed), length, deviation, unevenness])
        })
    }
}

function_of_a_search!(LineFunction);

/// The length of the chord, the deviation and the unevenness; `None` if a pose does not close or the ends coincide.
fn stroke(trace: &Trace) -> Option<[f64; 3]> {
    let poses = trace.poses();
    if poses < 2 || trace.closed() < poses {
        return None;
    }
    let ([x, y], [end_x, end_y]) = (trace.point(0), trace.point(poses - 1));
    let length = (end_x - x).hypot(end_y - y);
    if length == 0.0 {
        return None;
    }
    let (along_x, along_y) = ((end_x - x) / length, (end_y - y) / length);
    let (mut low, mut high) = (0.0_f64, 0.0_f64);
    let (mut slowest, mut fastest) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut sum = 0.0;
    for pose in 0..poses {
        let ([point_x, point_y], [x_velocity, y_velocity]) = (trace.point(pose), trace.velocity(pose));
        let across = (point_y - y) * along_x - (point_x - x) * along_y;
        (low, high) = (low.min(across), high.max(across));
        let speed = x_velocity * along_x + y_velocity * along_y;
        (slowest, fastest) = (slowest.min(speed), fastest.max(speed));
        // the trapezoidal rule: half of the first and of the last
        sum += if pose == 0 || pose == poses - 1 {
            0.5 * speed
        } else {
            speed
        };
    }
    let mean = sum / share(poses - 1, 1);
    // A point that goes back and forth has no speed on average, and is as uneven as can be.
    let unevenness = (fastest - slowest) / mean.abs();
    Some([
        length,
        (high - low) / length,
        if unevenness.is_finite() { unevenness } else { f64::MAX },
    ])
}
