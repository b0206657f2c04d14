//! Ten thousand linkages are made, each a little different: what share of them swings the rocker as far as it should?
//!
//! ```sh
//! cargo run --example batch
//! ```
//!
//! ```text
//! swing of 60.5° ± 0.1°:  40.8 %
//! swing of 60.5° ± 0.2°:  71.8 %
//! swing of 60.5° ± 0.3°:  91.0 %
//! swing of 60.5° ± 0.4°:  99.0 %
//! swing of 60.5° ± 0.5°: 100.0 %
//! ```

use kin_core::batch::{Column, Outcome};
use kin_core::prelude::*;

mechanism! {
    /// A crank that swings a rocker.
    struct Wiper { ground: Length, crank: Length, rod: Length, rocker: Length }
    input theta: Angle;
    unknown phi: Angle, psi: Angle;
    crank * cis(theta) + rod * cis(phi) == ground + rocker * cis(psi);
}

const MADE: usize = 10_000;

/// A length of every linkage, spread evenly over its tolerance; different shares make the lengths independent of each other.
fn made(length: f64, tolerance: f64, share: f64) -> Vec<f64> {
    let mut place = 0.5;
    let next = || {
        place = (place + share) % 1.0;
        length + tolerance * (2.0 * place - 1.0)
    };
    std::iter::repeat_with(next).take(MADE).collect()
}

fn main() -> Result<(), kin_core::batch::LengthMismatch> {
    let [crank, rod, rocker] = [
        made(30.0, 0.1, 0.819_172_513_396),
        made(80.0, 0.2, 0.671_043_606_704),
        made(60.0, 0.2, 0.549_700_477_902),
    ];
    let wipers = Wiper {
        ground: Column::Same(90.0),
        crank: Column::Each(&crank),
        rod: Column::Each(&rod),
        rocker: Column::Each(&rocker),
    };
    // where crank and rod are in line the rocker turns back, so that small deviations of the crank do not move it
    let mut swing = vec![0.0; MADE];
    for (degrees, sign) in [(218.94_f64, 1.0), (33.03, -1.0)] {
        let mut rocker = vec![0.0; MADE];
        let mut poses = WiperBatch::filled(|| None);
        poses.psi[0] = Some(rocker.as_mut_slice());
        let mut outcomes = vec![Outcome::Unsolved; MADE];
        let theta = Motion::constant(degrees.to_radians()).map(Column::Same);
        let summary = wipers.batch(theta, Assembly::Open).solve(&mut poses, &mut outcomes)?;
        assert_eq!(summary.failed, 0);
        for (swing, rocker) in swing.iter_mut().zip(&rocker) {
            *swing += sign * rocker.to_degrees();
        }
    }
    for off in [0.1, 0.2, 0.3, 0.4, 0.5] {
        let good = swing.iter().filter(|swing| (*swing - 60.5).abs() < off).count();
        #[expect(clippy::cast_precision_loss, reason = "there are few linkages")]
        let share = good as f64 / MADE as f64;
        println!("swing of 60.5° ± {off}°: {:5.1} %", 100.0 * share);
    }
    Ok(())
}
