//! Path generation: four-bar linkages through given points.

use std::f64::consts::{PI, TAU};

use kin_core::Plane;
use kin_core::any::Of;
use kin_core::prelude::*;
use kin_fit::{Candidate, Design, Effort, Objective, ObjectiveError, TracedFourBar, spread};

use super::number;

/// The timing of the crank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Timing {
    /// The crank's angle from the ground link is given at every point.
    Given(&'static [f64]),
    /// The crank turns by the same angle from point to point; where it starts is free.
    Even(f64),
    /// The crank's angle at every point is free.
    Free,
}

/// A linkage from a publication.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Published {
    /// The author and the source.
    pub(crate) source: &'static str,
    /// The error that is printed there.
    pub(crate) error: f64,
    /// The unit of the last digit of that error.
    pub(crate) rounding: f64,
    /// r1, r2, r3, r4, the tracer's coordinates, the angle of the ground link and the coordinates of the crank's pivot.
    pub(crate) dimensions: [f64; 9],
    /// The crank's angles: at every point if they are free, at the first one if the crank turns evenly.
    pub(crate) angles: &'static [f64],
    /// How the coupler meets the rocker.
    pub(crate) assembly: Assembly,
}

/// A problem of path generation. Its error is the sum of the squares of the distances between points and tracer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PathCase {
    /// Its name.
    pub(crate) name: &'static str,
    /// The task.
    pub(crate) title: &'static str,
    /// The source of points and bounds.
    pub(crate) source: &'static str,
    /// The points.
    pub(crate) points: &'static [[f64; 2]],
    /// The timing.
    pub(crate) timing: Timing,
    /// The range of the four links.
    pub(crate) links: [f64; 2],
    /// The range of the tracer's coordinates in the coupler's frame.
    pub(crate) tracer: [f64; 2],
    /// The range of the coordinates of the crank's pivot, or `None` if the pivot is the origin and the ground link lies
    /// along the x-axis.
    pub(crate) pivot: Option<[f64; 2]>,
    /// The linkages of the literature whose error this project has computed from their dimensions.
    pub(crate) published: &'static [Published],
    /// Remarks on the literature.
    pub(crate) remark: &'static str,
}

/// Six points on a vertical line.
pub(crate) const LINE: PathCase = PathCase {
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
pub(crate) const TIMED: PathCase = PathCase {
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
pub(crate) const CLOSED: PathCase = PathCase {
    name: "closed",
    title: "eighteen points of a closed path, 20° of the crank apart",
    source: "A. Kunjur, S. Krishnamurty, \"Genetic algorithms in mechanism synthesis\", Journal of Applied Mechanisms \
             and Robotics 4 (1997); points as in J. Mejía's program eca-four-bar-mechanisms \
             (testTrajectories.jl, case 12)",
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
pub(crate) const HALF_CIRCLE: PathCase = PathCase {
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
pub(crate) const CASES: [PathCase; 4] = [LINE, TIMED, CLOSED, HALF_CIRCLE];

/// A linkage for a case.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PathFound {
    /// The linkage.
    pub(crate) linkage: TracedFourBar,
    /// How the coupler meets the rocker.
    pub(crate) assembly: Assembly,
    /// The crank's angles at the points.
    pub(crate) angles: Vec<f64>,
    /// The sum of the squares of the distances.
    pub(crate) error: f64,
}

impl PathCase {
    /// The sum of the squares of the distances between the points and the tracer at the crank's angles.
    ///
    /// # Errors
    /// The error of the first point for which the linkage does not close.
    pub(crate) fn error(&self, linkage: &TracedFourBar, assembly: Assembly, angles: &[f64]) -> Result<f64, SolveError> {
        let mut sum = 0.0;
        for (point, angle) in self.points.iter().zip(angles) {
            let off = linkage.position(*angle, assembly)?.tracer.value() - Plane::new(point[0], point[1]);
            sum += off.x * off.x + off.y * off.y;
        }
        Ok(sum)
    }

    /// The crank's angles at all points from those of a published linkage.
    #[must_use]
    pub(crate) fn angles(&self, given: &[f64]) -> Vec<f64> {
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
    pub(crate) fn recomputed(&self, published: &Published) -> Result<f64, SolveError> {
        let linkage = TracedFourBar::from_parameters(published.dimensions);
        self.error(&linkage, published.assembly, &self.angles(published.angles))
    }

    /// The shortest and the longest link.
    fn link_range(&self) -> [f64; 2] {
        // a link of no length makes no linkage
        [self.links[0].max(SHORTEST * self.links[1]), self.links[1]]
    }

    /// The case as a fit. Angles may leave their revolution, so that a start near its end is no disadvantage.
    ///
    /// # Errors
    /// None for the cases above.
    pub(crate) fn objective(&self) -> Result<Objective, ObjectiveError> {
        const TURNS: [f64; 2] = [-TAU, 2.0 * TAU];
        let mut objective = Objective::path(Of::<TracedFourBar>::FUNCTIONS, "tracer", self.points.iter().copied())?;
        let links = ["r1", "r2", "r3", "r4"].map(|name| (name, self.link_range()));
        let tracer = ["point.x", "point.y"].map(|name| (name, self.tracer));
        let pivot = |range| [("turn", TURNS), ("pivot.x", range), ("pivot.y", range)];
        let pivot = self.pivot.map(pivot);
        for (name, [low, high]) in links.into_iter().chain(tracer).chain(pivot.into_iter().flatten()) {
            objective = objective.bounds(name, low..=high)?;
        }
        match self.timing {
            Timing::Given(angles) => objective.prescribed(angles.iter().copied()),
            Timing::Even(_) => objective.prescribed(self.angles(&[0.0]))?.phase(TURNS[0]..=TURNS[1]),
            Timing::Free => Ok(objective),
        }
    }

    /// Whether the crank makes full revolutions and, where its angles are free, passes the points in their order within
    /// one revolution.
    #[must_use]
    pub(crate) fn accepts(&self, linkage: &TracedFourBar, angles: &[f64]) -> bool {
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
    ///
    /// # Errors
    /// None for the cases above.
    pub(crate) fn search(&self, effort: Effort) -> Result<Option<PathFound>, ObjectiveError> {
        let objective = self.objective()?;
        let found = |design: &Design, assembly: Assembly| {
            let (linkage, angles) = (design.mechanism(), objective.inputs_of(design));
            let misfit = objective.misfit(design).filter(|_| self.accepts(&linkage, &angles))?;
            Some(PathFound {
                linkage,
                assembly,
                angles,
                error: misfit.sum_of_squares,
            })
        };
        let mut best: Option<(f64, Design, Assembly)> = None;
        for start in 0..effort.starts {
            let unit = spread(effort.seed.wrapping_add(start), 11);
            for assembly in [Assembly::Open, Assembly::Crossed] {
                let candidate = objective.design(&self.start(&unit, assembly))?;
                let design = objective.nearest_minimum(&candidate, [effort.generations, 0]);
                if let Some(PathFound { error, .. }) = found(&design, assembly)
                    && best.as_ref().is_none_or(|best| error < best.0)
                {
                    best = Some((error, design, assembly));
                }
            }
        }
        let polished = |(_, design, assembly): (f64, Design, Assembly)| {
            let polished = objective.nearest_minimum(&design, [0, LAST_STEPS]);
            found(&polished, assembly).or_else(|| found(&design, assembly))
        };
        Ok(best.and_then(polished))
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
    fn start(&self, unit: &[f64], assembly: Assembly) -> Candidate {
        let [extent, middle] = self.extent();
        let size = extent.norm();
        // the sizes of most linkages lie within a factor of ten, evenly on the logarithmic scale
        let scale = size * 10.0_f64.powf(unit[0]);
        let about = |centre: f64, unit: f64| centre + scale * (2.0 * unit - 1.0);
        let is_placed = self.pivot.is_some();
        let linkage = TracedFourBar {
            r1: scale * (0.3 + unit[0]),
            r2: size * (0.2 + 0.5 * unit[1]),
            r3: scale * (0.3 + unit[2]),
            r4: scale * (0.3 + unit[3]),
            point: Plane::new(about(0.0, unit[4]), about(0.0, unit[5])),
            turn: if is_placed { TAU * unit[6] } else { 0.0 },
            pivot: if is_placed {
                Plane::new(about(middle.x, unit[7]), about(middle.y, unit[8]))
            } else {
                Plane::new(0.0, 0.0)
            },
        };
        let first = TAU * unit[9];
        let (span, count) = (PI * (0.3 + unit[10]), self.points.len());
        Candidate {
            phase: Some(first).filter(|_| matches!(self.timing, Timing::Even(_))),
            inputs: Some(
                (0..count)
                    .map(|index| first + span * number(index) / number(count))
                    .collect(),
            ),
            ..Candidate::new(&linkage, assembly)
        }
    }
}

/// The steps that find the last digits of the best linkage.
const LAST_STEPS: u64 = 100;
/// The shortest link, as a share of the longest one that is allowed, where a case allows links of no length.
const SHORTEST: f64 = 1e-3;
