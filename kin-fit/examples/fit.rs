//! Fits the dimensions of a four-bar linkage to a D-shaped path that a point of its coupler is to follow, as the foot
//! of a walking machine does.
//!
//! The path is given at 24 angles of the crank: a straight stride at constant speed, and a half circle back. Every
//! dimension has bounds, points of the stride weigh more than those of the return, and length counts a little, by a
//! custom term. The result is a linkage that can be built: 2.3 mm from the stride and 5.4 mm from the return, on
//! average, with a ground link of 93 mm. Without bounds and without the count of lengths, the ground link grows to 339
//! mm and the coupler's point moves 549 mm away, to trace the path only a little better: 2.2 mm and 4.3 mm.
//!
//! ```sh
//! cargo run --release -p kin-fit --example fit
//! ```
//!
//! ```text
//! A four-bar linkage is fitted to 24 points of a D-shaped path (mm)
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

use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::io::Write;

use kin_core::any::Of;
use kin_core::prelude::*;
use kin_fit::{Candidate, Change, Objective};

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
const POINTS: u32 = 24;
/// The weight of a millimetre beside the stride, relative to a millimetre beside the return.
const STRIDE: f64 = 3.0;
/// The weight of a millimetre of a link: of two linkages that trace the path alike, the smaller linkage is found.
const SIZE: f64 = 0.08;

/// The lowest, the first and the highest value of each dimension.
const BOUNDS: [[f64; 3]; 10] = [
    [-150.0, 20.0, 150.0],
    [-20.0, 90.0, 150.0],
    [-4.0, 0.0, 4.0],
    [-4.0, 1.6, 4.0],
    [40.0, 60.0, 150.0],
    [10.0, 25.0, 50.0],
    [40.0, 75.0, 150.0],
    [40.0, 75.0, 150.0],
    [-150.0, 75.0, 150.0],
    [-150.0, -90.0, 150.0],
];

fn turned(index: u32) -> f64 {
    TAU * f64::from(index) / f64::from(POINTS)
}

/// Half of the points along the x axis, half of them on a half circle above it.
fn wanted(index: u32) -> Plane {
    const LENGTH: f64 = 60.0;
    let half = POINTS / 2;
    let part = f64::from(index % half) / f64::from(half);
    if index < half {
        Plane::new(LENGTH * (0.5 - part), 0.0)
    } else {
        Plane::polar(LENGTH / 2.0, PI * (1.0 - part))
    }
}

/// The mean distances (root of the mean square) from the stride and from the return.
fn distances(linkage: &Linkage) -> Result<[f64; 2], SolveError> {
    let half = POINTS / 2;
    let mean = |points: std::ops::Range<u32>| {
        let squares = points.map(|index| {
            let point = linkage.position(turned(index), Assembly::Open)?.point.value();
            Ok((point - wanted(index)).norm_squared())
        });
        let sum: f64 = squares.sum::<Result<f64, SolveError>>()?;
        Ok((sum / f64::from(half)).sqrt())
    };
    Ok([mean(0..half)?, mean(half..POINTS)?])
}

/// Fits, and writes the result.
pub(crate) fn report(out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    let path = (0..POINTS).map(wanted).map(|point| [point.x, point.y]);
    let weights = (0..POINTS).map(|index| if index < POINTS / 2 { STRIDE } else { 1.0 });
    let mut objective = Objective::path(Of::<Linkage>::FUNCTIONS, "point", path)?
        .prescribed((0..POINTS).map(turned))?
        .weights(weights)?
        .custom_term(|at| Some(SIZED.map(|index| Change::new(SIZE, 0.0) * at.parameters()[index])));
    let parameters = Linkage::DESCRIPTION.parameters;
    for (quantity, [low, _, high]) in parameters.iter().zip(BOUNDS) {
        objective = objective.bounds(quantity.name, low..=high)?;
    }
    let start = Linkage::from_parameters(BOUNDS.map(|[_, start, _]| start));
    let design = objective.design(&Candidate::new(&start, Assembly::Open))?;
    let found: Linkage = objective.nearest_minimum(&design, [500, 50]).mechanism();

    writeln!(
        out,
        "A four-bar linkage is fitted to {POINTS} points of a D-shaped path (mm)\n"
    )?;
    writeln!(
        out,
        "{:10}{:>10}{:>10}{:>10}{:>10}",
        "dimension", "lowest", "start", "found", "highest"
    )?;
    for ((quantity, value), [low, start, high]) in parameters.iter().zip(found.parameters()).zip(BOUNDS) {
        let name = quantity.name;
        writeln!(out, "{name:10}{low:>10.1}{start:>10.1}{value:>10.3}{high:>10.1}")?;
    }
    for (name, linkage) in [("start", start), ("found", found)] {
        let [stride, back] = distances(&linkage)?;
        writeln!(
            out,
            "\n{name}: {stride:.2} mm from the stride, {back:.2} mm from the return"
        )?;
    }

    // the fit differentiates rates as well: the acceleration of the point in the middle of the stride, by dimensions
    let pose = found.solve(Motion::at_constant_speed(turned(POINTS / 4), 1.0), Assembly::Open)?;
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
