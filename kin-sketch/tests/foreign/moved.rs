//! All files close where they are drawn, and move.

use std::f64::consts::TAU;

use super::{all_files, declared, followed, linkage, mechanism, values};

/// Their drives come to a limit position before they have gone round.
const TO_AND_FRO: [&str; 2] = ["pedaling_leg", "stephenson_2"];

#[test]
fn every_file_moves_over_a_turn() {
    let mut stopped = Vec::new();
    for file in all_files() {
        let foreign = file.foreign();
        let declaration = declared(&file.name, &foreign);
        let mechanism = mechanism(&declaration);
        let linkage = linkage(&mechanism, &declaration);
        let (start, drawn) = (values(&declaration.inputs), values(&declaration.unknowns));
        let choice = linkage.assembly_at(&start, &drawn);
        let closed = linkage
            .position(&start, choice.position())
            .expect("it closes where it is drawn");
        for (found, drawn) in closed.iter().zip(&drawn) {
            let error = (found - drawn).abs().min(((found - drawn) / 2.0).sin().abs());
            assert!(
                error < 1e-7 * (1.0 + drawn.abs()),
                "{}: {closed:?} is not {drawn:?}",
                file.name
            );
        }
        let (mut inputs, mut unknowns) = (start.clone(), closed);
        followed(&linkage, &mut inputs, &mut unknowns, 0.01, 1).expect("it moves a little");
        let is_angle = declaration.inputs[0].0 != "s" && !declaration.inputs[0].0.starts_with("s_");
        let turn = if is_angle { TAU - 0.01 } else { 0.1 * start[0].abs() };
        if followed(&linkage, &mut inputs, &mut unknowns, turn, 360).is_err() {
            stopped.push(file.name);
        }
    }
    assert_eq!(stopped, TO_AND_FRO);
}
