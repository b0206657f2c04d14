//! Fits the dimensions of a four-bar linkage to a path that a point of its coupler is to follow.
//!
//! The path is given at 24 angles of the crank. The partial derivatives of the point by the dimensions are generated with
//! the linkage; a Levenberg-Marquardt minimiser does the rest. As the path was taken from a linkage, its
//! dimensions must come out.
//!
//! ```sh
//! cargo run --release -p kin-tests --example fit
//! ```

use std::f64::consts::TAU;

use kin_core::prelude::*;
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra_of_minimiser::{Const, Owned, SMatrix, SVector};

mechanism! {
    /// A four-bar linkage with a point of its coupler.
    struct PathGenerator {
        /// The crank's pivot.
        pivot: Point,
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
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    output point: Point = pivot + r2 * cis(theta2) + trace * cis(theta3);
    with sensitivities;
}

/// Points of the path, dimensions to be found, and numbers to be brought to zero: two for each point.
const POINTS: usize = 24;
const DIMENSIONS: usize = 8;
const RESIDUALS: usize = 2 * POINTS;

type Linkage = PathGenerator<f64>;

fn pose(linkage: &Linkage, index: usize) -> Result<PathGeneratorSnap, SolveError> {
    #[expect(clippy::cast_precision_loss, reason = "there are few points")]
    let angle = TAU * index as f64 / POINTS as f64;
    linkage.solve(Motion::at_constant_speed(angle, 1.0), Assembly::Open)
}

struct Fit {
    path: [Plane; POINTS],
    linkage: Linkage,
    evaluations: usize,
}

impl Fit {
    fn poses(&self) -> Option<Vec<PathGeneratorSnap>> {
        (0..POINTS).map(|index| pose(&self.linkage, index).ok()).collect()
    }
}

impl LeastSquaresProblem<f64, Const<RESIDUALS>, Const<DIMENSIONS>> for Fit {
    type ResidualStorage = Owned<f64, Const<RESIDUALS>>;
    type JacobianStorage = Owned<f64, Const<RESIDUALS>, Const<DIMENSIONS>>;
    type ParameterStorage = Owned<f64, Const<DIMENSIONS>>;

    fn set_params(&mut self, dimensions: &SVector<f64, DIMENSIONS>) {
        self.linkage = Linkage::from_parameters((*dimensions).into());
        self.evaluations += 1;
        if let Some(residuals) = self.residuals() {
            println!("{:>5}   {:.3e}", self.evaluations, residuals.norm());
        }
    }

    fn params(&self) -> SVector<f64, DIMENSIONS> {
        self.linkage.parameters().into()
    }

    /// `None`, which ends the search, where a linkage does not close all the way round.
    fn residuals(&self) -> Option<SVector<f64, RESIDUALS>> {
        let poses = self.poses()?;
        let apart = poses
            .iter()
            .zip(&self.path)
            .map(|(pose, &wanted)| pose.point.value() - wanted);
        Some(SVector::from_iterator(
            apart.flat_map(|difference| [difference.x, difference.y]),
        ))
    }

    fn jacobian(&self) -> Option<SMatrix<f64, RESIDUALS, DIMENSIONS>> {
        let mut jacobian = SMatrix::zeros();
        for (index, pose) in self.poses()?.iter().enumerate() {
            for (column, by) in self.linkage.sensitivities_of(pose).iter().enumerate() {
                let Plane { x, y } = by.point.position();
                jacobian[(2 * index, column)] = x;
                jacobian[(2 * index + 1, column)] = y;
            }
        }
        Some(jacobian)
    }
}

fn main() -> Result<(), SolveError> {
    let wanted = Linkage {
        pivot: Plane::new(20.0, -10.0),
        r1: 90.0,
        r2: 30.0,
        r3: 75.0,
        r4: 60.0,
        trace: Plane::new(40.0, 25.0),
    };
    let mut path = [Plane::default(); POINTS];
    for (index, point) in path.iter_mut().enumerate() {
        *point = pose(&wanted, index)?.point.value();
    }
    let start = Linkage {
        pivot: Plane::new(0.0, 0.0),
        r1: 110.0,
        r2: 25.0,
        r3: 85.0,
        r4: 70.0,
        trace: Plane::new(50.0, 15.0),
    };

    println!("A four-bar linkage is fitted to {POINTS} points of a coupler curve (mm)\n");
    println!("trial   distance from the path, root of the sum of squares");
    let problem = Fit {
        path,
        linkage: start,
        evaluations: 0,
    };
    let (fit, report) = LevenbergMarquardt::new().minimize(problem);
    println!("\n{:?}\n", report.termination);

    println!("{:10}{:>10}{:>22}{:>10}", "dimension", "start", "found", "path's");
    let found = fit.linkage.parameters();
    let quantities = Linkage::DESCRIPTION.parameters;
    for (((quantity, start), found), wanted) in quantities
        .iter()
        .zip(start.parameters())
        .zip(found)
        .zip(wanted.parameters())
    {
        println!("{:10}{start:>10.3}{found:>22.14}{wanted:>10.3}", quantity.name);
    }

    // not the position only: how the acceleration of the point depends on the dimensions, at one angle of the crank
    let pose = pose(&fit.linkage, 5)?;
    let by = fit.linkage.sensitivities(&pose);
    println!("\nacceleration of the point at 75°: {:?}", pose.point.acceleration());
    println!("  by r3:      {:?} for each mm", by.r3.point.acceleration());
    println!("  by trace.x: {:?} for each mm", by.trace.x.point.acceleration());
    Ok(())
}
