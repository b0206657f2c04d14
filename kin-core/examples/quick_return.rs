//! Whitworth's quick-return mechanism, declared here as two vector loops and swept over a turn of its crank.
//!
//! ```sh
//! cargo run --release --example quick_return
//! ```

use std::f64::consts::TAU;

use kin_core::prelude::*;

mechanism! {
    /// Whitworth quick-return: the crank's pin slides in a lever that makes full turns and drives a ram.
    ///
    /// The lever turns about the origin, the crank about (0, `ground`), the ram moves along the x axis. Loop 1 is the
    /// crank and the slotted lever, loop 2 the lever's other arm, the connecting rod and the ram.
    struct QuickReturn {
        /// Distance of the two pivots; the lever makes full turns if it is less than `crank`.
        ground: Length,
        /// Crank.
        crank: Length,
        /// The lever's arm on the ram's side.
        arm: Length,
        /// Connecting rod.
        rod: Length,
    }
    input
        /// The crank's angle.
        theta: Angle;
    unknown
        /// The distance of the crank's pin from the lever's pivot.
        slide: Length where slide > 0,
        /// The lever's angle.
        phi: Angle,
        /// The connecting rod's angle.
        psi: Angle,
        /// The ram's position.
        ram: Length;

    vec2(0, ground) + crank * cis(theta) == slide * cis(phi);
    arm * cis(phi) + rod * cis(psi) == vec2(ram, 0);
}

/// How long the bar of the plot is at full speed, to either side.
const BAR: f64 = 18.0;

fn main() -> Result<(), SolveError> {
    let press = QuickReturn {
        ground: 0.05,
        crank: 0.12,
        arm: 0.15,
        rod: 0.50,
    };
    let speed = TAU; // one turn per second
    println!("Whitworth quick-return, two loops, one turn of the crank per second (m, rad, s)\n");
    for block in QuickReturn::<f64>::DESCRIPTION.blocks {
        println!("  {:<12} {}", block.unknowns, block.closed_form);
    }

    let poses = (0..=24)
        .map(|step| {
            let degrees = f64::from(15 * step);
            let crank = Motion::at_constant_speed(degrees.to_radians(), speed);
            press.solve(crank, Assembly::Open).map(|pose| (degrees, pose))
        })
        .collect::<Result<Vec<_>, _>>()?;
    let fastest = poses
        .iter()
        .fold(0.0, |most: f64, (_, pose)| most.max(pose.ram.velocity().abs()));

    println!(
        "\n{:>6}{:>9}{:>9}{:>9}{:>9}{:>10}{:>12}  ram's velocity",
        "theta", "phi", "ram", "ram'", "ram''", "ram'''", "ram''''"
    );
    for (degrees, pose) in &poses {
        println!(
            "{degrees:>6.0}{:>9.2}{:>9.4}{:>9.4}{:>9.3}{:>10.2}{:>12.1}  {}",
            pose.phi.position().to_degrees(),
            pose.ram.position(),
            pose.ram.velocity(),
            pose.ram.acceleration(),
            pose.ram.jerk(),
            pose.ram.snap(),
            bar(pose.ram.velocity() / fastest)
        );
    }

    let [(to_and_fro, low), (_, high)] = dead_points(&press)?;
    println!(
        "\nstroke {:.4} m, time ratio of the two strokes {to_and_fro:.3}",
        high - low
    );
    Ok(())
}

/// A bar from the middle to the left or to the right.
fn bar(part: f64) -> String {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a few characters"
    )]
    let length = (part.abs() * BAR / 2.0).round() as usize;
    let half = 9;
    if part < 0.0 {
        format!("{:>half$}|", "#".repeat(length))
    } else {
        format!("{:half$}|{}", "", "#".repeat(length))
    }
}

/// The time ratio with the lowest position of the ram, and with the highest.
///
/// The ram reverses where arm and rod lie on one line: at phi = 0 (farthest) and phi = 180 degrees. There the crank's
/// pin is level with the lever's pivot, sin(theta) = -ground / crank.
fn dead_points(press: &QuickReturn) -> Result<[(f64, f64); 2], SolveError> {
    let dip = (press.ground / press.crank).asin();
    let (right, left) = (-dip, std::f64::consts::PI + dip);
    let ratio = (left - right) / (TAU - (left - right));
    let ram = |theta| {
        press
            .position(theta, Assembly::Open)
            .map(|position| position.ram.value())
    };
    Ok([(ratio, ram(left)?), (ratio, ram(right)?)])
}
