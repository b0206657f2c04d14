//! A shaper cuts slowly and returns fast: how long is its stroke, and how much faster is the way back?
//!
//! ```sh
//! cargo run --example quick_return
//! ```
//!
//! ```text
//! theta      ram     ram'     ram''    ram'''
//!    0°   0.6351  -0.3950    -4.170     38.83
//!   30°   0.5910  -0.6304    -1.698     22.94
//!   60°   0.5345  -0.7020    -0.123     15.47
//!   90°   0.4770  -0.6653     0.928      9.91
//!  120°   0.4256  -0.5590     1.566      5.76
//!  150°   0.3850  -0.4107     1.982      5.06
//!  180°   0.3582  -0.2228     2.629     12.61
//!  210°   0.3505   0.0662     4.745     44.76
//!  240°   0.3783   0.6881    10.917     88.67
//!  270°   0.4770   1.6157     5.473   -298.09
//!  300°   0.6014   1.0939   -13.377    -26.73
//!  330°   0.6491   0.1226    -8.741     72.97
//! stroke 0.3000 m
//! the cut takes 1.75 times as long as the way back
//! fastest cut 0.703 m/s, fastest way back 1.663 m/s
//! ```

use kin_core::prelude::*;

mechanism! {
    /// Whitworth's quick return, as two loops: the crank's pin slides in a lever, whose other arm moves a ram.
    struct QuickReturn { ground: Length, crank: Length, arm: Length, rod: Length }
    input theta: Angle;
    unknown slide: Length where slide > 0, phi: Angle, psi: Angle, ram: Length;

    vec2(0, ground) + crank * cis(theta) == slide * cis(phi);
    arm * cis(phi) + rod * cis(psi) == vec2(ram, 0);
}

fn main() -> Result<(), SolveError> {
    let shaper = QuickReturn {
        ground: 0.05,
        crank: 0.12,
        arm: 0.15,
        rod: 0.50,
    };
    let ram = |degrees: f64| -> Result<Motion, SolveError> {
        let crank = Motion::at_constant_speed(degrees.to_radians(), rpm(60.0));
        Ok(shaper.solve(crank, Assembly::Open)?.ram)
    };

    println!("theta      ram     ram'     ram''    ram'''");
    for degrees in (0..360).step_by(30) {
        let ram = ram(f64::from(degrees))?;
        let [position, velocity, acceleration, jerk, _] = ram.derivatives();
        println!("{degrees:4}° {position:8.4} {velocity:8.4} {acceleration:9.3} {jerk:9.2}");
    }

    let turn = (0..3600)
        .map(|step| ram(f64::from(step) / 10.0))
        .collect::<Result<Vec<_>, _>>()?;
    let most = |value: fn(&Motion) -> f64| turn.iter().map(value).fold(f64::NEG_INFINITY, f64::max);
    let stroke = most(Motion::position) + most(|ram| -ram.position());
    let cutting = turn.iter().filter(|ram| ram.velocity() < 0.0).count();
    #[expect(clippy::cast_precision_loss, reason = "there are few samples")]
    let ratio = cutting as f64 / (turn.len() - cutting) as f64;
    println!("stroke {stroke:.4} m");
    println!("the cut takes {ratio:.2} times as long as the way back");
    println!(
        "fastest cut {:.3} m/s, fastest way back {:.3} m/s",
        most(|ram| -ram.velocity()),
        most(Motion::velocity)
    );
    Ok(())
}
