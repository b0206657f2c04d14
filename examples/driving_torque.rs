//! A crank presses a slider against a load: which torque must the motor supply, inertia included?
//!
//! ```sh
//! cargo run --example driving_torque
//! ```
//!
//! ```text
//! theta   at 30 rpm    at 600 rpm
//!   15°     0.16 Nm      63.01 Nm
//!   45°     0.23 Nm      93.49 Nm
//!   75°    -0.01 Nm      -4.31 Nm
//!  105°    -0.18 Nm     -72.18 Nm
//!  135°    -0.14 Nm     -56.99 Nm
//!  165°    -0.05 Nm     -18.56 Nm
//!  195°    14.06 Nm      32.57 Nm
//!  225°    42.99 Nm      99.84 Nm
//!  255°    70.41 Nm     142.41 Nm
//!  285°    84.33 Nm      88.63 Nm
//!  315°    70.05 Nm     -23.20 Nm
//!  345°    27.24 Nm     -35.61 Nm
//! work of a turn 160.0 J, load times stroke 160.0 J
//! ```

use kin_core::prelude::*;

mechanism! {
    /// A slider-crank whose rod has its centre of mass in the middle.
    struct Press { crank: Length, rod: Length }
    input theta: Angle;
    unknown phi: Angle, slide: Length;
    crank * cis(theta) + rod * cis(phi) == vec2(slide, 0);
    output centre: Point = crank * cis(theta) + rod / 2 * cis(phi);
}

const SLIDER: f64 = 3.0; // kg
const ROD: f64 = 1.2; // kg
const ROD_ABOUT_ITS_CENTRE: f64 = 0.009; // kg m²
const LOAD: f64 = 800.0; // N, against the slider on its way out

/// Virtual power: what the motor gives is what load and inertia take. For a unit speed of the crank, the unknowns and
/// the outputs move at the rates of the Jacobian.
fn torque(press: &Press, theta: f64, speed: f64) -> Result<f64, SolveError> {
    let pose = press.solve(Motion::at_constant_speed(theta, speed), Assembly::Open)?;
    let [[phi], [slide], [x], [y]] = press.jacobian(&pose)?;
    let load = if pose.slide.velocity() > 0.0 { LOAD } else { 0.0 };
    Ok((load + SLIDER * pose.slide.acceleration()) * slide
        + ROD * pose.centre.acceleration().dot(Plane::new(x, y))
        + ROD_ABOUT_ITS_CENTRE * pose.phi.acceleration() * phi)
}

fn main() -> Result<(), SolveError> {
    let press = Press { crank: 0.1, rod: 0.3 };
    println!("theta   at 30 rpm    at 600 rpm");
    for degrees in (15..360).step_by(30) {
        let theta = f64::from(degrees).to_radians();
        let [slow, fast] = [torque(&press, theta, rpm(30.0))?, torque(&press, theta, rpm(600.0))?];
        println!("{degrees:4}° {slow:8.2} Nm {fast:10.2} Nm");
    }
    // inertia takes no work over a whole turn, so that the motor's work is that of the load over the stroke
    let mut work = 0.0;
    for degrees in 0..360 {
        let theta = (f64::from(degrees) + 0.5).to_radians();
        work += torque(&press, theta, rpm(600.0))? * 1_f64.to_radians();
    }
    println!(
        "work of a turn {work:.1} J, load times stroke {:.1} J",
        LOAD * 2.0 * press.crank
    );
    Ok(())
}
