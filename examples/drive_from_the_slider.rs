//! A cylinder lifts a boom: how fast does the boom turn while the cylinder extends, and how far can it go?
//!
//! ```sh
//! cargo run --example drive_from_the_slider
//! ```
//!
//! ```text
//! cylinder    boom  boom's speed   load's height and speed
//!   0.60 m   -3.0°      7.34°/s        0.045 m   0.385 m/s
//!   0.80 m   11.8°      7.49°/s        0.810 m   0.378 m/s
//!   1.00 m   27.2°      7.97°/s        1.550 m   0.358 m/s
//!   1.20 m   43.9°      8.86°/s        2.226 m   0.312 m/s
//!   1.40 m   63.1°     10.54°/s        2.767 m   0.216 m/s
//!   1.60 m   87.7°     14.79°/s        3.006 m  -0.020 m/s
//! towards 0.1 m: dead point at 0.2190 m
//! towards 3 m: dead point at 1.7810 m
//! ```

use kin_core::TrackError;
use kin_core::prelude::*;

mechanism! {
    /// The cylinder lies between two pivots on the ground and on the boom; its length is the input.
    struct Boom {
        /// The cylinder's pivot, seen from the boom's.
        pivot: Point,
        /// The distance from the boom's pivot to the cylinder's end.
        arm: Length,
        /// The boom's tip, in its own frame.
        tip: Vector,
    }
    input cylinder: Length;
    unknown boom: Angle, lean: Angle;

    pivot + cylinder * cis(lean) == arm * cis(boom);

    output load: Point = tip * cis(boom);
}

fn main() -> Result<(), SolveError> {
    let lift = Boom {
        pivot: Plane::new(0.6, -0.5),
        arm: 1.0,
        tip: Plane::new(3.0, 0.2),
    };
    // in the drawing the boom is level and the cylinder leans by about 50 degrees
    let assembly = lift.assembly_at(0.64, [0.0, 0.9]);

    println!("cylinder    boom  boom's speed   load's height and speed");
    for step in 0..=5 {
        let cylinder = Motion::at_constant_speed(0.6 + 0.2 * f64::from(step), 0.1); // m, m/s
        let pose = lift.solve(cylinder, assembly)?;
        println!(
            "{:6.2} m {:6.1}° {:9.2}°/s {:12.3} m {:7.3} m/s",
            pose.cylinder.position(),
            pose.boom.position().to_degrees(),
            pose.boom.velocity().to_degrees(),
            pose.load.position().y,
            pose.load.velocity().y
        );
    }
    let start = lift.position(1.0, assembly)?;
    for beyond in [0.1, 3.0] {
        if let Err(TrackError::TurningPoint(limit)) = lift.track(&start, beyond) {
            println!("towards {beyond} m: dead point at {:.4} m", limit.inputs[0]);
        }
    }
    Ok(())
}
