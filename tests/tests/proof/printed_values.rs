//! The notes' sample table, to every digit printed there.

use kin_core::library::{FourBar, FreudensteinFourBar, GeometricFourBar};
use kin_core::prelude::*;
use kin_tests::notes::four_bar_geometric::Dimensions;
use kin_tests::notes::sample;

const CRANK: Motion<f64, 5> = Motion::new(sample::THETA2);

/// The sample linkage as any of the three declarations.
macro_rules! linkage {
    ($mechanism:ident) => {{
        let Dimensions { r1, r2, r3, r4 } = sample::DIMENSIONS;
        $mechanism { r1, r2, r3, r4 }
    }};
}

#[test]
fn vector_loop() {
    let motion = linkage!(FourBar).solve(CRANK, Assembly::Open).expect("it closes");
    sample::THETA3.assert_agrees(motion.theta3.derivatives());
    sample::THETA4.assert_agrees(motion.theta4.derivatives());
}

#[test]
fn geometric_method() {
    let linkage = linkage!(GeometricFourBar);
    let assembly = linkage.assembly(CRANK.position(), Assembly::Open);
    let motion = linkage.solve(CRANK, assembly).expect("it closes");
    sample::E.assert_agrees(motion.e.derivatives());
    sample::ALPHA.assert_agrees(motion.alpha.derivatives());
    sample::GAMMA.assert_agrees(motion.gamma.derivatives());
    sample::BETA.assert_agrees(motion.beta.derivatives());
    sample::THETA4.assert_agrees(motion.theta4.derivatives());
    sample::THETA3.assert_agrees(motion.theta3.derivatives());
}

#[test]
fn freudenstein() {
    let motion = linkage!(FreudensteinFourBar)
        .solve(CRANK, FreudensteinFourBar::OPEN)
        .expect("it closes");
    sample::THETA3.assert_agrees(motion.theta3.derivatives());
    sample::THETA4.assert_agrees(motion.theta4.derivatives());
}
