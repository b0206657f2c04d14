//! A robot with both motors on the ground: how must they move so that its tip goes along a straight line, from rest to
//! rest?
//!
//! ```sh
//! cargo run --example five_bar_robot
//! ```
//!
//! ```text
//! time    left                right               tip again         d left/dx
//! 0.05 s 153.47°  -0.16 rad/s  80.27°  -0.21 rad/s  (-39.51, 220.08)  -0.00352 rad/mm
//! 0.15 s 147.47°  -2.31 rad/s  73.03°  -2.59 rad/s  (-17.31, 223.78)  -0.00406 rad/mm
//! 0.25 s 126.42°  -4.62 rad/s  53.58°  -3.50 rad/s  (50.00, 235.00)  -0.00516 rad/mm
//! 0.35 s 102.51°  -3.09 rad/s  39.53°  -1.27 rad/s  (117.31, 246.22)  -0.00595 rad/mm
//! 0.45 s  93.82°  -0.26 rad/s  36.49°  -0.07 rad/s  (139.51, 249.92)  -0.00640 rad/mm
//! ```

use kin_core::law::{Law, Rise, Shape};
use kin_core::prelude::*;

mechanism! {
    /// The inverse: both motors from the tip. Each arm is a loop of its own.
    struct Inverse { ground: Length, upper: Length, lower: Length }
    input x: Length, y: Length;
    unknown left: Angle, left_rod: Angle, right: Angle, right_rod: Angle;
    upper * cis(left) + lower * cis(left_rod) == vec2(x, y);
    ground + upper * cis(right) + lower * cis(right_rod) == vec2(x, y);
}

mechanism! {
    /// The same linkage forward: the tip from both motors.
    struct Forward { ground: Length, upper: Length, lower: Length }
    input left: Angle, right: Angle;
    unknown left_rod: Angle, right_rod: Angle;
    upper * cis(left) + lower * cis(left_rod) == ground + upper * cis(right) + lower * cis(right_rod);
    output tip: Point = upper * cis(left) + lower * cis(left_rod);
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (ground, upper, lower) = (100.0, 150.0, 180.0);
    let inverse = Inverse { ground, upper, lower };
    let forward = Forward { ground, upper, lower };
    // the left elbow is on the left, the right one on the right
    let elbows = InverseAssembly::all(Assembly::Open).with_right_right_rod(Assembly::Crossed);

    // 180 mm in half a second, with continuous jerk
    let law = Rise::new(Shape::Polynomial4567, 0.0, 180.0, 0.5)?;
    println!("time    left                right               tip again         d left/dx");
    for step in 0..5 {
        let time = 0.05 + 0.1 * f64::from(step);
        let way: Motion = law.at(time);
        let motors = inverse.solve(-40.0 + way, 220.0 + way / 6.0, elbows)?;
        let [[by_x, _], ..] = inverse.jacobian(&motors)?;

        let rods = [motors.left_rod.position(), motors.right_rod.position()];
        let tip = forward.solve_near(motors.left, motors.right, rods)?.tip;
        println!(
            "{time:.2} s {:6.2}° {:6.2} rad/s {:6.2}° {:6.2} rad/s  {:.2}  {by_x:.5} rad/mm",
            motors.left.position().to_degrees(),
            motors.left.velocity(),
            motors.right.position().to_degrees(),
            motors.right.velocity(),
            tip.position(),
        );
        // the tip moves as the law asks, to the fourth derivative
        assert!((tip.snap().x - way.snap()).abs() < 1e-12 * 840.0 * 180.0 / 0.5_f64.powi(4));
    }
    Ok(())
}
