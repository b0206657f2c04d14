//! Path generation: four-bar linkages through given points.

use std::f64::consts::{PI, TAU};

use kin_core::Plane;
use kin_core::prelude::*;

use super::number;
use super::search::{Bounds, Effort, Found, Rows, least_squares};
use super::traced::TracedFourBar;

/// When the crank is where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Timing {
    /// The crank's angle from the ground link is given at every point.
    Given(&'static [f64]),
    /// The crank turns by the same angle from point to point; where it starts is free.
    Even(f64),
    /// The crank's angle at every point is free.
    Free,
}

/// A linkage from a publication.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Published {
    /// Who found it, and where it stands.
    pub source: &'static str,
    /// The error that is printed there.
    pub error: f64,
    /// The unit of the last digit of that error.
    pub rounding: f64,
    /// r1, r2, r3, r4, the tracer's coordinates, the angle of the ground link and the coordinates of the crank's pivot.
    pub dimensions: [f64; TracedFourBar::DIMENSIONS],
    /// The crank's angles: at every point if they are free, at the first one if the crank turns evenly.
    pub angles: &'static [f64],
    /// How the coupler meets the rocker.
    pub assembly: Assembly,
}

/// A problem of path generation. Its error is the sum of the squares of the distances between points and tracer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathCase {
    /// Its name.
    pub name: &'static str,
    /// What is wanted.
    pub title: &'static str,
    /// Where points and bounds stand.
    pub source: &'static str,
    /// The points.
    pub points: &'static [[f64; 2]],
    /// The timing.
    pub timing: Timing,
    /// The range of the four links.
    pub links: [f64; 2],
    /// The range of the tracer's coordinates in the coupler's frame.
    pub tracer: [f64; 2],
    /// The range of the coordinates of the crank's pivot, or `None` if the pivot is the origin and the ground link lies
    /// along the x-axis.
    pub pivot: Option<[f64; 2]>,
    /// The linkages of the literature whose error this project has computed from their dimensions.
    pub published: &'static [Published],
    /// What else the literature says, and what could not be found.
    pub remark: &'static str,
}

/// Six points on a vertical line.
pub const LINE: PathCase = PathCase {
    name: "line",
    title: "six points on a vertical line, timing free",
    source: "J. A. Cabrera, A. Simon, M. Prado, \"Optimal synthesis of mechanisms with genetic algorithms\", Mechanism \
             and Machine Theory 37 (2002); points and bounds as in J. Mejía's program eca-four-bar-mechanisms \
             (tools.jl, case 1)",
    points: &[
        [20.0, 20.0],
        [20.0, 25.0],
        [20.0, 30.0],
        [20.0, 35.0],
        [20.0, 40.0],
        [20.0, 45.0],
    ],
    timing: Timing::Free,
    links: [0.0, 60.0],
    tracer: [-60.0, 60.0],
    pivot: Some([-60.0, 60.0]),
    published: &[Published {
        source: "J. Mejía, eca-four-bar-mechanisms (tools.jl, bestEver), by the evolutionary centers algorithm",
        error: 1e-20,
        rounding: 1e-20,
        dimensions: [
            39.354_327_339_661_76,
            8.738_597_335_076_454,
            27.910_205_675_790_63,
            38.416_532_066_190_49,
            36.576_759_454_887_835,
            18.058_222_622_003_274,
            3.922_197_401_424_182,
            -9.015_069_651_004_032,
            59.859_456_845_834_5,
        ],
        angles: &[
            1.627_572_437_705_546_5,
            2.421_295_382_386_49,
            2.930_218_950_680_62,
            3.415_830_628_905_154_3,
            3.940_161_234_476_685_4,
            5.428_565_504_554_411,
        ],
        assembly: Assembly::Open,
    }],
    remark: "fifteen numbers against twelve: many linkages meet all points",
};

/// Five points with given angles of the crank.
pub const TIMED: PathCase = PathCase {
    name: "timed",
    title: "five points with given angles of the crank",
    source: "A. Kunjur, S. Krishnamurty, \"Genetic algorithms in mechanism synthesis\", Journal of Applied Mechanisms \
             and Robotics 4 (1997); points, angles and bounds as in J. Mejía's program eca-four-bar-mechanisms \
             (tools.jl, case 2)",
    points: &[
        [3.0, 3.0],
        [2.759, 3.363],
        [2.372, 3.663],
        [1.89, 3.862],
        [1.355, 3.943],
    ],
    timing: Timing::Given(&[PI / 6.0, PI / 4.0, PI / 3.0, 5.0 * PI / 12.0, PI / 2.0]),
    links: [0.0, 50.0],
    tracer: [-50.0, 50.0],
    pivot: None,
    published: &[],
    remark: "no published error whose dimensions could be had",
};

/// Eighteen points of a closed path.
pub const CLOSED: PathCase = PathCase {
    name: "closed",
    title: "eighteen points of a closed path, 20° of the crank apart",
    source: "A. Kunjur, S. Krishnamurty, \"Genetic algorithms in mechanism synthesis\", Journal of Applied Mechanisms \
             and Robotics 4 (1997); points as in J. Mejía's program eca-four-bar-mechanisms (testTrajectories.jl, \
             case 12)",
    points: &[
        [0.5, 1.1],
        [0.4, 1.1],
        [0.3, 1.1],
        [0.2, 1.0],
        [0.1, 0.9],
        [0.05, 0.75],
        [0.02, 0.6],
        [0.0, 0.5],
        [0.0, 0.4],
        [0.03, 0.3],
        [0.1, 0.25],
        [0.15, 0.2],
        [0.2, 0.3],
        [0.3, 0.4],
        [0.4, 0.5],
        [0.5, 0.7],
        [0.6, 0.9],
        [0.6, 1.0],
    ],
    timing: Timing::Even(PI / 9.0),
    links: [0.0, 50.0],
    tracer: [-50.0, 50.0],
    pivot: Some([-50.0, 50.0]),
    published: &[Published {
        source: "Cabrera, Simon, Prado 2002 (dimensions and error quoted without the page, and confirmed by computing \
                 the error from the dimensions)",
        error: 0.0337,
        rounding: 0.0001,
        dimensions: [
            3.057_878, 0.237_803, 4.828_954, 2.056_456, 0.767_038, 1.850_828, 1.002_168, 1.776_808, -0.641_991,
        ],
        angles: &[0.226_186],
        assembly: Assembly::Open,
    }],
    remark: "",
};

/// Six points on a half circle with given angles of the crank.
pub const HALF_CIRCLE: PathCase = PathCase {
    name: "half-circle",
    title: "six points on a half circle with given angles of the crank",
    source: "S. K. Acharyya, M. Mandal, \"Performance of EAs for four-bar linkage synthesis\", Mechanism and Machine \
             Theory 44 (2009)",
    points: &[
        [0.0, 0.0],
        [1.9098, 5.8779],
        [6.9098, 9.5106],
        [13.09, 9.5106],
        [18.09, 5.8779],
        [20.0, 0.0],
    ],
    timing: Timing::Given(&[PI / 6.0, PI / 3.0, PI / 2.0, 2.0 * PI / 3.0, 5.0 * PI / 6.0, PI]),
    links: [5.0, 50.0],
    tracer: [-50.0, 50.0],
    pivot: Some([-50.0, 50.0]),
    published: &[],
    remark: "papers after this one quote an error of 2.58, with the links 50, 5, 7.031 and 48.134; the least squares \
             below have their minimum at these links, with the error 2.5804. No page could be had",
};

/// All cases.
pub const CASES: [PathCase; 4] = [LINE, TIMED, CLOSED, HALF_CIRCLE];

/// A linkage for a case.
#[derive(Clone, Debug, PartialEq)]
pub struct PathFound {
    /// The linkage.
    pub linkage: TracedFourBar,
    /// How the coupler meets the rocker.
    pub assembly: Assembly,
    /// The crank's angles at the points.
    pub angles: Vec<f64>,
    /// The sum of the squares of the distances.
    pub error: f64,
}

impl PathCase {
    /// The sum of the squares of the distances between the points and the tracer at the crank's angles.
    ///
    /// # Errors
    /// The error of the first point for which the linkage does not close.
    pub fn error(&self, linkage: &TracedFourBar, assembly: Assembly, angles: &[f64]) -> Result<f64, SolveError> {
        let mut sum = 0.0;
        for (point, angle) in self.points.iter().zip(angles) {
            let off = linkage.position(*angle, assembly)?.tracer.value() - Plane::new(point[0], point[1]);
            sum += off.x * off.x + off.y * off.y;
        }
        Ok(sum)
    }

    /// The crank's angles at all points from those of a published linkage.
    #[must_use]
    pub fn angles(&self, given: &[f64]) -> Vec<f64> {
        match self.timing {
            Timing::Given(angles) => angles.to_vec(),
            Timing::Even(step) => (0..self.points.len())
                .map(|index| given.first().copied().unwrap_or(0.0) + step * number(index))
                .collect(),
            Timing::Free => given.to_vec(),
        }
    }

    /// The error of a published linkage, from its dimensions.
    ///
    /// # Errors
    /// The error of the first point for which the linkage does not close.
    pub fn recomputed(&self, published: &Published) -> Result<f64, SolveError> {
        let linkage = TracedFourBar::from_numbers(&published.dimensions);
        self.error(&linkage, published.assembly, &self.angles(published.angles))
    }

    /// The dimensions that are searched: all, or those without the place of the linkage.
    fn placed(&self) -> usize {
        if self.pivot.is_some() {
            TracedFourBar::DIMENSIONS
        } else {
            6
        }
    }

    fn free_angles(&self) -> usize {
        match self.timing {
            Timing::Given(_) => 0,
            Timing::Even(_) => 1,
            Timing::Free => self.points.len(),
        }
    }

    /// The ranges of all numbers that are searched. Angles may leave their turn, so that a start near its end is no
    /// disadvantage.
    fn bounds(&self) -> Bounds {
        // a link of no length makes no linkage
        let links = [self.links[0].max(SHORTEST * self.links[1]), self.links[1]];
        let mut ranges = vec![links, links, links, links, self.tracer, self.tracer];
        if let Some(pivot) = self.pivot {
            ranges.extend([[-TAU, 2.0 * TAU], pivot, pivot]);
        }
        ranges.extend(std::iter::repeat_n([-TAU, 2.0 * TAU], self.free_angles()));
        Bounds::new(&ranges)
    }

    fn linkage(&self, numbers: &[f64]) -> TracedFourBar {
        let mut dimensions = [0.0; TracedFourBar::DIMENSIONS];
        dimensions[..self.placed()].copy_from_slice(&numbers[..self.placed()]);
        TracedFourBar::from_numbers(&dimensions)
    }

    /// The distances from the points and their derivatives, which are exact.
    fn rows(&self, numbers: &[f64], assembly: Assembly) -> Rows {
        let linkage = self.linkage(numbers);
        let placed = self.placed();
        let free = &numbers[placed..];
        let (mut residuals, mut rows) = (Vec::new(), Vec::new());
        for (index, (point, angle)) in self.points.iter().zip(self.angles(free)).enumerate() {
            let pose = linkage.solve(Motion::at_constant_speed(angle, 1.0), assembly).ok()?;
            let off = pose.tracer.position() - Plane::new(point[0], point[1]);
            let by_angle = pose.tracer.velocity();
            let by = linkage.sensitivities_of(&pose).map(|by| by.tracer.position());
            let of_angle = match self.timing {
                Timing::Given(_) => None,
                Timing::Even(_) => Some(placed),
                Timing::Free => Some(placed + index),
            };
            let row = |part: fn(Plane) -> f64| {
                let mut row = vec![0.0; numbers.len()];
                for (cell, by) in row.iter_mut().zip(&by[..placed]) {
                    *cell = part(*by);
                }
                if let Some(place) = of_angle {
                    row[place] = part(by_angle);
                }
                row
            };
            residuals.extend([off.x, off.y]);
            rows.extend([row(|plane| plane.x), row(|plane| plane.y)]);
        }
        Some((residuals, rows))
    }

    /// Whether the crank makes full turns and, where its angles are free, passes the points in their order within one
    /// turn.
    #[must_use]
    pub fn accepts(&self, linkage: &TracedFourBar, angles: &[f64]) -> bool {
        let [r1, r2, r3, r4] = [linkage.r1, linkage.r2, linkage.r3, linkage.r4];
        let crank = r2 <= r1 && r2 <= r3 && r2 <= r4 && linkage.shortfall() <= 0.0;
        let ordered = || {
            let steps: Vec<f64> = angles
                .windows(2)
                .map(|pair| (pair[1] - pair[0]).rem_euclid(TAU))
                .collect();
            let forwards: f64 = steps.iter().sum();
            let backwards: f64 = steps.iter().map(|step| TAU - step).sum();
            forwards < TAU || backwards < TAU
        };
        crank && (self.timing != Timing::Free || ordered())
    }

    /// The best linkage by least squares from many starts, in both assemblies.
    #[must_use]
    pub fn search(&self, effort: Effort) -> Option<PathFound> {
        let bounds = self.bounds();
        let [extent, middle] = self.extent();
        let start_of = |unit: &[f64]| self.start(unit, extent, middle);
        let found = [Assembly::Open, Assembly::Crossed].map(|assembly| {
            let accept = |numbers: &[f64]| {
                let angles = self.angles(&numbers[self.placed()..]);
                bounds.contain(numbers) && self.accepts(&self.linkage(numbers), &angles)
            };
            let rows = |numbers: &[f64]| self.rows(numbers, assembly);
            let found: Found = least_squares(&bounds, effort, 2 * self.points.len(), start_of, rows, accept);
            (found, assembly)
        });
        let (found, assembly) = found
            .into_iter()
            .min_by(|one, other| one.0.cost.total_cmp(&other.0.cost))?;
        found.cost.is_finite().then(|| PathFound {
            linkage: self.linkage(&found.point),
            assembly,
            angles: self.angles(&found.point[self.placed()..]),
            error: found.cost,
        })
    }

    /// The width and height of the points, and their middle.
    fn extent(&self) -> [Plane; 2] {
        let range = |axis: usize| {
            let values = self.points.iter().map(|point| point[axis]);
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |range, value| {
                (range.0.min(value), range.1.max(value))
            })
        };
        let ((left, right), (low, high)) = (range(0), range(1));
        [
            Plane::new(right - left, high - low),
            Plane::new(0.5 * (left + right), 0.5 * (low + high)),
        ]
    }

    /// A start for least squares: a crank-rocker of about the size of the points, near them.
    fn start(&self, unit: &[f64], extent: Plane, middle: Plane) -> Vec<f64> {
        let size = extent.norm();
        // the sizes of most linkages lie within a factor of ten, evenly on the logarithmic scale
        let scale = size * 10.0_f64.powf(unit[0]);
        let links = [self.links[0].max(SHORTEST * self.links[1]), self.links[1]];
        let clamp = |value: f64, range: [f64; 2]| value.clamp(range[0], range[1]);
        let mut numbers = vec![
            clamp(scale * (0.3 + unit[0]), links),
            clamp(size * (0.2 + 0.5 * unit[1]), links),
            clamp(scale * (0.3 + unit[2]), links),
            clamp(scale * (0.3 + unit[3]), links),
            clamp(scale * (2.0 * unit[4] - 1.0), self.tracer),
            clamp(scale * (2.0 * unit[5] - 1.0), self.tracer),
        ];
        if let Some(range) = self.pivot {
            numbers.push(TAU * unit[6]);
            numbers.push(clamp(middle.x + scale * (2.0 * unit[7] - 1.0), range));
            numbers.push(clamp(middle.y + scale * (2.0 * unit[8] - 1.0), range));
        }
        match self.timing {
            Timing::Given(_) => {}
            Timing::Even(_) => numbers.push(TAU * unit[9]),
            Timing::Free => {
                let count = self.points.len();
                let first = TAU * unit[9];
                let span = PI * (0.3 + unit[10]);
                numbers.extend((0..count).map(|index| first + span * number(index) / number(count)));
            }
        }
        numbers
    }
}

/// The shortest link, as a share of the longest one that is allowed, where a case allows links of no length.
const SHORTEST: f64 = 1e-3;
