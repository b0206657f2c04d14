//! A shaper cuts slowly and returns fast: how long is its stroke, and how much faster is the way back?
//!
//! ```sh
//! cargo run --example quick_return
//! ```
//!
//! ```text
//! theta      ram     ram'     ram''
//!    0°   0.6351  -0.3950    -4.170
//!   30°   0.5910  -0.6304    -1.698
//!   60°   0.5345  -0.7020    -0.123
//!   90°   0.4770  -0.6653     0.928
//!  120°   0.4256  -0.5590     1.566
//!  150°   0.3850  -0.4107     1.982
//!  180°   0.3582  -0.2228     2.629
//!  210°   0.3505   0.0662     4.745
//!  240°   0.3783   0.6881    10.917
//!  270°   0.4770   1.6157     5.473
//!  300°   0.6014   1.0939   -13.377
//!  330°   0.6491   0.1226    -8.741
//!  360°   0.6351  -0.3950    -4.170
//! stroke 0.3000 m
//! the cut takes 1.7533 times as long as the way back
//! largest velocity of the ram: 1.663009 at 4.819067
//! largest jerk of the ram: -334.1956 at 4.816177
//! ```

use std::f64::consts::TAU;

use kin_core::prelude::*;

mechanism! {
    /// Whitworth's quick return, as two loops: the crank's pin slides in a lever, whose other arm moves a ram.
    struct QuickReturn { ground: Length, crank: Length, arm: Length, rod: Length }
    input theta: Angle;
    unknown slide: Length where slide > 0, phi: Angle, psi: Angle, ram: Length;

    vec2(0, ground) + crank * cis(theta) == slide * cis(phi);
    arm * cis(phi) + rod * cis(psi) == vec2(ram, 0);
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let shaper = QuickReturn {
        ground: 0.05,
        crank: 0.12,
        arm: 0.15,
        rod: 0.50,
    };
    let turn = shaper.sweep(Assembly::Open).over(0.0..=TAU, 13).speed(rpm(60.0));

    println!("theta      ram     ram'     ram''");
    for pose in turn.rows() {
        let QuickReturnSnap { theta, ram, .. } = pose?;
        println!(
            "{:4.0}° {:8.4} {:8.4} {:9.3}",
            theta.position().to_degrees(),
            ram.position(),
            ram.velocity(),
            ram.acceleration()
        );
    }

    // exact, not read off the rows
    let ends: Vec<f64> = turn
        .of("ram")
        .extremes()?
        .iter()
        .filter_map(|extreme| extreme.value)
        .collect();
    println!("stroke {:.4} m", ends[1] - ends[0]);
    let reversals = turn.of("ram_velocity").crossings(0.0)?;
    let back = reversals[1].at - reversals[0].at;
    println!("the cut takes {:.4} times as long as the way back", (TAU - back) / back);
    println!("largest velocity of the ram: {}", turn.of("ram_velocity").peak()?);
    println!("largest jerk of the ram: {}", turn.of("ram_jerk").peak()?);
    Ok(())
}
