//! The tables of peak factors are what the motion laws do.

use std::fs;
use std::path::Path;

use kin_core::law::{Dwell, Law as _, Piecewise as _, Rise, Sequence, Shape};

/// Steps in each piece. Between them a peak is missed by the square of a step, far below the digits of the table.
const STEPS: u32 = 20_000;

/// The peaks of velocity, acceleration, jerk and snap of a rise by 1 in the time 1.
fn peaks(rise: &Rise) -> [f64; 4] {
    let mut most = [0.0_f64; 4];
    let mut start = 0.0;
    for piece in 0..rise.pieces() {
        let end = rise.end(piece);
        for step in 0..=STEPS {
            let mut derivatives = [0.0; 5];
            rise.write(
                piece,
                start + (end - start) * f64::from(step) / f64::from(STEPS),
                &mut derivatives,
            );
            for (most, derivative) in most.iter_mut().zip(&derivatives[1..]) {
                *most = most.max(derivative.abs());
            }
            if end == start {
                break;
            }
        }
        start = end;
    }
    most
}

/// Five significant digits.
fn shown(value: f64) -> String {
    let above = if value < 1.0 { 1 } else { format!("{value:.0}").len() };
    if value == 0.0 {
        "0".to_owned()
    } else {
        format!("{value:.*}", 5_usize.saturating_sub(above))
    }
}

#[test]
fn peak_factors_are_up_to_date() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let read = |path: &str| fs::read_to_string(root.join(path)).expect("it is there");
    let tables = [read("docs/laws.md"), read("kin-runtime/src/law/rise.rs")];
    let orders = ["value", "velocity", "acceleration", "jerk", "snap", "fifth derivative"];
    for (name, plain, shape) in [
        ("`ConstantSpeed`", "constant speed", Shape::ConstantSpeed),
        ("`SimpleHarmonic`", "simple harmonic", Shape::SimpleHarmonic),
        ("`Polynomial345`", "3-4-5", Shape::Polynomial345),
        ("`Cycloidal`", "cycloidal", Shape::Cycloidal),
        ("`ModifiedSine`", "modified sine", Shape::ModifiedSine),
        ("`ModifiedTrapezoid`", "modified trapezoid", Shape::ModifiedTrapezoid),
        ("`Polynomial4567`", "4-5-6-7", Shape::Polynomial4567),
        ("`Polynomial56789`", "5-6-7-8-9", Shape::Polynomial56789),
    ] {
        let rise = Rise::new(shape, 0.0, 1.0, 1.0).expect("it is a rise");
        let dwell = Dwell::new(1.0, 1.0).expect("it is a dwell");
        let law = Sequence::new([&rise, &dwell]).expect("it is a sequence");
        let mut joints = law.joints::<6>();
        let joint = joints.find(|joint| joint.time == 1.0).expect("they meet");
        let jump = joint.first_jump().expect("a derivative jumps");
        let factors = peaks(&rise).map(shown).join(" | ");
        for (table, row) in tables.iter().zip([
            format!("| {name} | {factors} | {} |", orders[jump - 1]),
            format!("/// | {plain} | {factors} | {} |", orders[jump]),
        ]) {
            assert!(table.lines().any(|line| line == row), "there should be a line\n{row}");
        }
    }
}
