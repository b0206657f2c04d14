//! Whitworth's quick-return mechanism, declared here as two vector loops and swept over a turn of its crank.
//!
//! ```sh
//! cargo run --release --example quick_return
//! ```

use std::f64::consts::{PI, TAU};

use kin_core::prelude::*;

mechanism! {
    /// Whitworth quick-return: the crank's pin slides in a lever that makes full turns and drives a ram.
    ///
    /// The lever turns about the origin, the crank about (0, `ground`), and the ram moves along the x axis. Loop 1
    /// consists of the crank and the slotted lever; loop 2 consists of the lever's other arm, the connecting rod and
    /// the ram.
    struct QuickReturn {
        /// Distance between the two pivots; the lever makes full turns if it is less than `crank`.
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

/// The length of the plot's bar at full speed, to either side.
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
        println!("  {:<12} {}", block.unknowns, block.solution);
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

    let strokes = strokes(&press)?;
    let time_ratio = strokes.slow / strokes.fast;
    println!("\nstroke {:.4} m", strokes.length);
    println!("time ratio of the slow stroke to the fast one {time_ratio:.3}");

    // The extremes over the turn, at every degree of the crank.
    let (mut forward, mut backward, mut snap): (f64, f64, f64) = (0.0, 0.0, 0.0);
    for degrees in 0..360 {
        let crank = Motion::at_constant_speed(f64::from(degrees).to_radians(), speed);
        let ram = press.solve(crank, Assembly::Open)?.ram;
        forward = forward.max(ram.velocity());
        backward = backward.max(-ram.velocity());
        snap = snap.max(ram.snap().abs());
    }
    println!(
        "velocity ratio of the fast stroke to the slow one, peak by peak {:.3}",
        forward / backward
    );
    println!("largest snap {snap:.0} m/s^4");
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

/// The two strokes of the ram: their length, and the crank angles that they take.
struct Strokes {
    length: f64,
    slow: f64,
    fast: f64,
}

/// The ram reverses where arm and rod lie on one line, at phi = 0 (farthest) and phi = 180 degrees. There the crank's
/// pin is level with the lever's pivot, sin(theta) = -ground / crank.
fn strokes(press: &QuickReturn) -> Result<Strokes, SolveError> {
    let dip = (press.ground / press.crank).asin();
    let (right, left) = (-dip, PI + dip);
    let ram = |theta| {
        press
            .position(theta, Assembly::Open)
            .map(|position| position.ram.value())
    };
    Ok(Strokes {
        length: ram(right)? - ram(left)?,
        slow: left - right,
        fast: TAU - (left - right),
    })
}
