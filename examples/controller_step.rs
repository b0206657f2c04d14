//! A control loop of 10 kHz without the standard library: what does the output shaft do, and on which turn is it?
//!
//! ```sh
//! cargo run --example controller_step
//! ```
//!
//! ```text
//! 0.0 s: motor    0.0°, shaft  -54.8°, 43.63 rad/s,   -28.2 rad/s²
//! 0.2 s: motor  300.0°, shaft  223.8°, 24.75 rad/s,   434.8 rad/s²
//! 0.4 s: motor  600.0°, shaft  539.4°, 16.64 rad/s,    35.2 rad/s²
//! 0.6 s: motor  900.0°, shaft  860.0°, 18.70 rad/s,  -110.3 rad/s²
//! 0.8 s: motor 1200.0°, shaft 1171.6°, 23.64 rad/s,  -128.7 rad/s²
//! 1.0 s: motor 1500.0°, shaft 1470.6°, 30.37 rad/s,  -255.7 rad/s²
//! ```
#![no_std]

use kin_core::prelude::*;

mechanism! {
    /// A drag link: crank and follower make full turns, as the ground is the shortest link.
    struct DragLink { ground: Length, crank: Length, coupler: Length, follower: Length }
    input motor: Angle;
    unknown phi: Angle, shaft: Angle;
    crank * cis(motor) + coupler * cis(phi) == ground + follower * cis(shaft);
}

/// What the controller remembers from step to step: the last pose tells the assembly and the turn.
struct Controller {
    linkage: DragLink<f32>,
    last: DragLinkPosition<f32>,
}

impl Controller {
    /// One step: the motor's angle, speed and acceleration give those of the shaft, for the feed-forward. Allocates
    /// nothing.
    fn step(&mut self, motor: f32, speed: f32, acceleration: f32) -> Result<Motion<f32, 3>, SolveError> {
        self.last = self.linkage.position_near(motor, self.last)?;
        Ok(self.last.velocity(speed).acceleration(acceleration).shaft)
    }
}

fn main() -> Result<(), SolveError> {
    // only to print
    extern crate std;

    let linkage = DragLink {
        ground: 20.0,
        crank: 50.0,
        coupler: 45.0,
        follower: 55.0,
    };
    let last = linkage.position(0.0, Assembly::Open)?;
    let mut controller = Controller { linkage, last };

    let speed = rpm(250.0);
    for tick in 0..=10_000_u16 {
        let time = f32::from(tick) / 10_000.0;
        let shaft = controller.step(speed * time, speed, 0.0)?;
        if tick % 2_000 == 0 {
            std::println!(
                "{time:.1} s: motor {:6.1}°, shaft {:6.1}°, {:5.2} rad/s, {:7.1} rad/s²",
                (speed * time).to_degrees(),
                shaft.position().to_degrees(),
                shaft.velocity(),
                shaft.acceleration()
            );
        }
    }
    Ok(())
}
