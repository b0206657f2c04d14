//! What people read: `Debug` of poses, and the structures of assemblies.

use kin_core::prelude::*;
use kin_tests::mechanisms::multi_loop::{FourBarsInSeries, FourBarsInSeriesAssembly};
use kin_tests::mechanisms::outputs::FourBarOutputs;

/// Inputs, unknowns and outputs by name, and nothing else.
#[test]
fn poses_print_their_quantities_alone() {
    let linkage = FourBarOutputs::<f64>::from_parameters([90.0, 30.0, 60.0, 45.0, 25.0, 15.0]);
    let position = linkage.position(0.6, Assembly::Open).expect("it closes");
    let description = FourBarOutputs::<f64>::DESCRIPTION;
    let inputs = description.inputs.iter().chain(description.unknowns);
    // a point is one field
    let outputs = description
        .outputs
        .iter()
        .filter(|output| output.name.strip_suffix(".y").is_none());
    let expected: Vec<&str> = inputs
        .chain(outputs)
        .map(|quantity| quantity.name.trim_end_matches(".x"))
        .collect();
    let printed = format!("{position:#?}");
    // the fields of the structure are indented by one step
    let fields: Vec<&str> = printed
        .lines()
        .filter_map(|line| line.strip_prefix("    "))
        .filter(|line| !line.starts_with([' ', '}', ']']))
        .filter_map(|line| line.split(':').next())
        .collect();
    assert_eq!(fields, expected, "{printed}");
    assert!(printed.starts_with("FourBarOutputsPosition {"), "{printed}");
    let whole = linkage
        .solve(Motion::at_constant_speed(0.6, 3.0), Assembly::Open)
        .expect("it closes");
    assert!(
        format!("{whole:?}").starts_with("FourBarOutputsSnap { theta2: "),
        "{whole:?}"
    );
}

/// One assembly for all blocks, another for one of them, in words.
#[test]
fn assemblies_of_several_blocks() {
    let all = FourBarsInSeriesAssembly::all(Assembly::Open);
    assert_eq!(Some(all), FourBarsInSeries::<f64>::assembly(0));
    let text = all.to_string();
    let blocks: Vec<&str> = text.split(", ").collect();
    assert_eq!(blocks.len(), 2, "{text}");
    assert!(blocks.iter().all(|block| block.ends_with(": open")), "{text}");
    let second = all.with_phi3_phi4(Assembly::Crossed);
    assert_eq!(second.to_string(), "theta3_theta4: open, phi3_phi4: crossed");
    assert_eq!(Some(second), FourBarsInSeries::<f64>::assembly(1));
    for assembly in FourBarsInSeries::<f64>::ASSEMBLIES {
        let crossed = assembly.to_string().matches("crossed").count();
        let open = assembly.to_string().matches("open").count();
        assert_eq!(open + crossed, 2, "{assembly}");
    }
}
