//! A steering gear in space: how far does the wheel turn for a turn of the pitman arm, and is it the same to both
//! sides?
//!
//! ```sh
//! cargo run --example rssr_steering
//! ```
//!
//! ```text
//! pitman arm     wheel   ratio   its change
//!      -40°    -32.16°  0.7418    0.3157 per rad
//!      -30°    -24.51°  0.7856    0.1949 per rad
//!      -20°    -16.51°  0.8121    0.1148 per rad
//!      -10°     -8.30°  0.8269    0.0567 per rad
//!        0°      0.00°  0.8325    0.0090 per rad
//!       10°      8.32°  0.8302   -0.0364 per rad
//!       20°     16.58°  0.8195   -0.0873 per rad
//!       30°     24.68°  0.7989   -0.1524 per rad
//!       40°     32.51°  0.7648   -0.2440 per rad
//! ```

use kin_core::prelude::*;

mechanism! {
    /// RSSR: a rod with ball joints joins the pitman arm, which turns about z, with the wheel's arm on an inclined
    /// kingpin.
    struct Steering {
        /// Pitman arm.
        pitman: Length,
        /// The rod between the ball joints.
        rod: Length,
        /// The arm on the wheel's carrier.
        arm: Length,
        /// A point of the kingpin's axis, seen from the pitman arm's.
        kingpin: Point3,
        /// The kingpin's inclination.
        lean: Angle,
    }
    input theta: Angle;
    unknown wheel: Angle;

    let front = rot_z(theta) * vec3(0, pitman, 0);
    let back = kingpin + rot_x(lean) * rot_z(wheel) * vec3(0, arm, 0);
    dot(front - back, front - back) == rod * rod;
}

fn main() -> Result<(), SolveError> {
    let steering = Steering {
        pitman: 150.0,
        rod: 600.0,
        arm: 180.0,
        kingpin: Space::new(600.0, -20.0, 60.0),
        lean: 12_f64.to_radians(),
    };
    // straight ahead, both arms are about parallel
    let assembly = steering.assembly_at(0.0, [0.0]);
    let straight = steering.position(0.0, assembly)?.wheel.value();

    println!("pitman arm     wheel   ratio   its change");
    for degrees in (-40..=40).step_by(10) {
        let theta = Motion::at_constant_speed(f64::from(degrees).to_radians(), 1.0);
        let wheel = steering.solve(theta, assembly)?.wheel - straight;
        println!(
            "{degrees:>8}° {:>9.2}° {:>7.4} {:>9.4} per rad",
            wheel.position().to_degrees(),
            wheel.velocity(),
            wheel.acceleration()
        );
    }
    Ok(())
}
