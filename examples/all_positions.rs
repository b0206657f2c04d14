//! A platform on three legs of given length, the class III triad: in how many positions can it be assembled, and how
//! well is each of them determined?
//!
//! ```sh
//! cargo run --example all_positions
//! ```
//!
//! ```text
//! 6 positions; every path was followed to its end: true
//!    alpha     beta    gamma     tilt   condition
//!   83.77°   61.90°  108.31°  133.81°       33.1
//!   64.18°    8.82°   89.66°  161.10°       22.9
//!  160.80° -146.71°  136.16°  158.93°      124.2
//! -167.31° -153.66°  162.57°  121.95°       49.5
//! -111.63°  -29.00°  175.46°   60.85°       10.0
//!  164.85° -158.21°  142.63°  146.82°      127.3
//! ```

use kin_core::prelude::*;

mechanism! {
    /// The legs stand on the origin and on two pivots, and carry a platform with three joints.
    struct Platform { pivot_b: Point, pivot_c: Point, joint_b: Vector, joint_c: Vector }
    input a: Length, b: Length, c: Length;
    unknown alpha: Angle, beta: Angle, gamma: Angle, tilt: Angle;

    a * cis(alpha) + joint_b * cis(tilt) == pivot_b + b * cis(beta);
    a * cis(alpha) + joint_c * cis(tilt) == pivot_c + c * cis(gamma);
}

fn main() -> Result<(), SolveError> {
    let platform = Platform {
        pivot_b: Plane::new(-1.547, 0.514),
        pivot_c: Plane::new(1.202, -1.902),
        joint_b: Plane::new(0.936, 0.811),
        joint_c: Plane::new(-0.838, 0.372),
    };
    let (a, b, c) = (1.249, 0.954, 2.403);

    let all = platform.assemblies_at(a, b, c)?;
    println!(
        "{} positions; every path was followed to its end: {}",
        all.len(),
        all.is_complete()
    );
    println!("   alpha     beta    gamma     tilt   condition");
    for &near in &all {
        let pose = platform.position(a, b, c, near)?;
        for angle in pose.unknowns() {
            print!("{:7.2}° ", angle.to_degrees());
        }
        println!("{:10.1}", platform.condition(&pose));
    }
    Ok(())
}
