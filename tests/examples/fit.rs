//! Fits the dimensions of a four-bar linkage to a D-shaped path that a point of its coupler is to follow, as the foot of a walking
//! machine does.
//!
//! The path is given at 24 angles of the crank: a straight stride at constant speed, and a half circle back. The partial derivatives of
//! the point by the dimensions are generated with the linkage. The minimiser is basin's bounded Levenberg-Marquardt method. Every dimension
//! has bounds, points of the stride weigh more than those of the return, and length counts a little. The result is a linkage that can be
//! built: 2.3 mm from the stride and 5.4 mm from the return, on average, with a ground link of 93 mm. Without bounds and without the count
//! of lengths, the ground link grows to 339 mm and the coupler's point moves 549 mm away, to trace the path only a little better: 2.2 mm
//! and 4.3 mm.
//!
//! ```sh
//! cargo run --release -p kin-tests --features other-crates --example fit
//! ```
//!
//! ```text
//! A four-bar linkage is fitted to 24 points of a D-shaped path (mm)
//!
//! RelativeCostTolerance after 58 steps
//!
//! dimension     lowest     start     found   highest
//! pivot.x       -150.0      20.0  -137.092     150.0
//! pivot.y        -20.0      90.0    -2.293     150.0
//! tilt            -4.0       0.0    -0.295       4.0
//! phase           -4.0       1.6     0.433       4.0
//! r1              40.0      60.0    92.508     150.0
//! r2              10.0      25.0    24.660      50.0
//! r3              40.0      75.0    88.716     150.0
//! r4              40.0      75.0    43.168     150.0
//! trace.x       -150.0      75.0   140.284     150.0
//! trace.y       -150.0     -90.0    -8.253     150.0
//!
//! start: 156.43 mm from the stride, 181.08 mm from the return
//!
//! found: 2.26 mm from the stride, 5.35 mm from the return
//!
//! acceleration in the middle of the stride: (6.01, -7.17)
//!   by r3:      (-0.085, -0.140) for each mm
//!   by trace.x: (0.011, 0.124) for each mm
//! ```

use std::convert::Infallible;
use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::io::Write;

use basin::{
    BoundedLevenbergMarquardt, BoxBounds, ConstraintDescription, ConstraintSet, Constraints, DenseMatrix, Executor,
    Jacobian, PointState, Residual,
};
use kin_core::prelude::*;

mechanism! {
    /// A four-bar linkage with a point of its coupler.
    struct PathGenerator {
        /// The crank's pivot.
        pivot: Point,
        /// The direction from the crank's pivot to the rocker's.
        tilt: Angle,
        /// The crank's angle from there when the path begins.
        phase: Angle,
        /// Ground link, from the crank's pivot to the rocker's.
        r1: Length,
        /// Crank.
        r2: Length,
        /// Coupler.
        r3: Length,
        /// Rocker.
        r4: Length,
        /// The point in the frame of the coupler, from the crank's pin.
        trace: Vector,
    }
    input turned: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(turned + phase) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    output point: Point = pivot + cis(tilt) * (r2 * cis(turned + phase) + trace * cis(theta3));
    with sensitivities;
}

type Linkage = PathGenerator<f64>;

/// The dimensions that are to be small: `r1`, `r3`, `r4` and both coordinates of `trace`.
const SIZED: [usize; 5] = [4, 6, 7, 8, 9];

/// Points of the path; the first half of them on the stride.
const POINTS: usize = 24;
/// How much a millimetre beside the stride counts, against one beside the return.
const STRIDE: f64 = 3.0;
/// How much a millimetre of a link counts, so that of two linkages that trace the path alike the small one is found.
const SIZE: f64 = 0.08;
/// The residual of a point that the linkage does not reach: longer than any distance within the bounds, so that the step is refused.
const UNREACHED: f64 = 1e4;

const RESIDUALS: usize = 2 * POINTS + SIZED.len();

fn pose(linkage: &Linkage, index: usize) -> Result<PathGeneratorSnap, SolveError> {
    #[expect(clippy::cast_precision_loss, reason = "there are few points")]
    let turned = TAU * index as f64 / POINTS as f64;
    linkage.solve(Motion::at_constant_speed(turned, 1.0), Assembly::Open)
}

/// Half of the points along the x axis, half of them on a half circle above it.
fn path() -> [Plane; POINTS] {
    const LENGTH: f64 = 60.0;
    let half = POINTS / 2;
    std::array::from_fn(|index| {
        #[expect(clippy::cast_precision_loss, reason = "there are few points")]
        let part = (index % half) as f64 / half as f64;
        if index < half {
            Plane::new(LENGTH * (0.5 - part), 0.0)
        } else {
            Plane::polar(LENGTH / 2.0, PI * (1.0 - part))
        }
    })
}

fn weight(index: usize) -> f64 {
    if index < POINTS / 2 { STRIDE } else { 1.0 }
}

struct Fit {
    path: [Plane; POINTS],
    lower: Vec<f64>,
    upper: Vec<f64>,
}

fn linkage(dimensions: &[f64]) -> Linkage {
    Linkage::from_parameters(Row::from_fn(|index| dimensions[index]))
}

impl Constraints for Fit {
    type Set = ConstraintSet<BoxBounds<Vec<f64>>>;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new().with_bounds(BoxBounds::new(Some(&self.lower), Some(&self.upper)))
    }
}

impl Residual for Fit {
    type Param = Vec<f64>;
    type Output = Vec<f64>;
    type Error = Infallible;

    /// The weighted distances from the path, along x and along y.
    fn residual(&self, dimensions: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        let linkage = linkage(dimensions);
        let distances = self.path.iter().enumerate().flat_map(|(index, &wanted)| {
            let Plane { x, y } = match pose(&linkage, index) {
                Ok(pose) => pose.point.value() - wanted,
                Err(_) => Plane::new(UNREACHED, UNREACHED),
            };
            [weight(index) * x, weight(index) * y]
        });
        Ok(distances.chain(SIZED.map(|place| SIZE * dimensions[place])).collect())
    }
}

impl Jacobian for Fit {
    type Jacobian = DenseMatrix<f64>;

    fn jacobian(&self, dimensions: &Vec<f64>) -> Result<DenseMatrix<f64>, Infallible> {
        let linkage = linkage(dimensions);
        let columns = dimensions.len();
        let mut jacobian = vec![0.0; RESIDUALS * columns];
        for index in 0..POINTS {
            // A point that is not reached has a constant residual.
            let Ok(pose) = pose(&linkage, index) else { continue };
            for (column, by) in linkage.sensitivities_of(&pose).iter().enumerate() {
                let Plane { x, y } = by.point.position();
                jacobian[2 * index * columns + column] = weight(index) * x;
                jacobian[(2 * index + 1) * columns + column] = weight(index) * y;
            }
        }
        for (row, place) in SIZED.into_iter().enumerate() {
            jacobian[(2 * POINTS + row) * columns + place] = SIZE;
        }
        Ok(DenseMatrix::from_row_slice(RESIDUALS, columns, &jacobian))
    }
}

/// The mean distances (root of the mean square) from the stride and from the return.
fn distances(path: &[Plane; POINTS], linkage: &Linkage) -> Result<[f64; 2], SolveError> {
    let mut sums = [0.0; 2];
    for (index, &wanted) in path.iter().enumerate() {
        sums[index / (POINTS / 2)] += (pose(linkage, index)?.point.value() - wanted).norm_squared();
    }
    #[expect(clippy::cast_precision_loss, reason = "there are few points")]
    Ok(sums.map(|sum| (sum / (POINTS / 2) as f64).sqrt()))
}

/// Fits, and writes what it found.
pub(crate) fn report(out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    let path = path();
    //             pivot        tilt  phase    r1    r2    r3    r4   trace
    let lower = [-150.0, -20.0, -4.0, -4.0, 40.0, 10.0, 40.0, 40.0, -150.0, -150.0];
    let start = [20.0, 90.0, 0.0, 1.6, 60.0, 25.0, 75.0, 75.0, 75.0, -90.0];
    let upper = [150.0, 150.0, 4.0, 4.0, 150.0, 50.0, 150.0, 150.0, 150.0, 150.0];

    let problem = Fit {
        path,
        lower: lower.to_vec(),
        upper: upper.to_vec(),
    };
    let minimiser = BoundedLevenbergMarquardt::new().with_relative_cost_change_tolerance(1e-12);
    let result = Executor::new(problem, minimiser, PointState::new(start.to_vec()))
        .max_iter(500)
        .run()?;
    writeln!(
        out,
        "A four-bar linkage is fitted to {POINTS} points of a D-shaped path (mm)\n"
    )?;
    writeln!(out, "{:?} after {} steps\n", result.report.code(), result.iter())?;

    writeln!(
        out,
        "{:10}{:>10}{:>10}{:>10}{:>10}",
        "dimension", "lowest", "start", "found", "highest"
    )?;
    let found = linkage(result.best_param());
    for (index, (quantity, value)) in Linkage::DESCRIPTION
        .parameters
        .iter()
        .zip(found.parameters())
        .enumerate()
    {
        let (low, high) = (lower[index], upper[index]);
        let at_bound = (value - low).min(high - value) < 1e-3 * (high - low);
        let remark = if at_bound { "  at its bound" } else { "" };
        writeln!(
            out,
            "{:10}{low:>10.1}{:>10.1}{value:>10.3}{high:>10.1}{remark}",
            quantity.name, start[index]
        )?;
    }
    for (name, linkage) in [("start", linkage(&start)), ("found", found)] {
        let [stride, back] = distances(&path, &linkage)?;
        writeln!(
            out,
            "\n{name}: {stride:.2} mm from the stride, {back:.2} mm from the return"
        )?;
    }

    // not the position only: how the acceleration of the point depends on the dimensions, in the middle of the stride
    let pose = pose(&found, POINTS / 4)?;
    let by = found.sensitivities(&pose);
    writeln!(
        out,
        "\nacceleration in the middle of the stride: {:.2}",
        pose.point.acceleration()
    )?;
    writeln!(out, "  by r3:      {:.3} for each mm", by.r3.point.acceleration())?;
    writeln!(out, "  by trace.x: {:.3} for each mm", by.trace.x.point.acceleration())?;
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    report(&mut std::io::stdout().lock())
}
