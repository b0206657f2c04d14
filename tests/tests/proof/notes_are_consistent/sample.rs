//! Section 6: the notes' sample values, a four-bar linkage in centimetres.

use kin_tests::notes::Assembly;
use kin_tests::notes::four_bar_geometric::solve;
use kin_tests::notes::sample::{DIMENSIONS, Printed, THETA2_LIMIT};

#[test]
fn a_printed_number_stands_for_what_rounds_to_it() {
    let printed = Printed::new(-0.3588, 4);
    assert!(printed.agrees(-0.358_84) && printed.agrees(-0.358_76));
    assert!(!printed.agrees(-0.358_86) && !printed.agrees(-0.358_74));
    assert!(!printed.agrees(f64::NAN));
}

#[test]
fn closes_as_far_as_the_notes_say() {
    let closes = |degrees: f64| {
        let motion = [degrees.to_radians(), 0.0, 0.0, 0.0, 0.0];
        !solve(DIMENSIONS, motion, Assembly::Open).theta4[0].is_nan()
    };
    for way in [1.0, -1.0] {
        assert!(closes(way * (THETA2_LIMIT.value - THETA2_LIMIT.tolerance())));
        assert!(!closes(way * (THETA2_LIMIT.value + THETA2_LIMIT.tolerance())));
    }
}
