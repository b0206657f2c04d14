//! Tests of tapes of a few mechanisms. Those of the whole library stand in `tests`.

use std::vec::Vec;

use super::{Options, record};
use crate::assembly::Assembly;
use crate::library::FourBar;
use crate::motion::Motion;

/// One tape serves both assemblies, and finds what `solve` finds to the last bit.
#[test]
fn a_tape_of_a_four_bar_is_its_solver() {
    let tape = record::<FourBar>(&Options::new()).unwrap();
    let [r1, r2, r3, r4] = [90.0, 30.0, 60.0, 45.0];
    let linkage = FourBar { r1, r2, r3, r4 };
    let rates = [-10.0, 2.0, -0.5, 0.3];
    for step in -10..=10 {
        let crank = 0.31 * f64::from(step);
        for (assembly, sign) in [(Assembly::Open, 1.0), (Assembly::Crossed, -1.0)] {
            let [velocity, acceleration, jerk, snap] = rates;
            let motion = Motion::from((crank, velocity, acceleration, jerk, snap));
            let arguments = [r1, r2, r3, r4, crank, velocity, acceleration, jerk, snap, sign];
            match (linkage.solve(motion, assembly), tape.run(&arguments)) {
                (Ok(pose), Ok(found)) => {
                    let own = [pose.theta3, pose.theta4].map(|motion| motion.derivatives()).concat();
                    let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
                    assert_eq!(bits(&found), bits(&own), "{crank} {assembly}");
                }
                (Err(error), Err(stop)) => {
                    assert_eq!(stop.block, error.block);
                    let margin = error.margin().unwrap();
                    assert!(
                        (stop.margin - margin).abs() <= 8.0 * f64::EPSILON * 200.0,
                        "{stop} {margin}"
                    );
                }
                (own, found) => panic!("{crank} {assembly}: {own:?} {found:?}"),
            }
        }
    }
}
