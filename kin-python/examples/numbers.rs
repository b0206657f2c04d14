//! The numbers of `solve` for every mechanism of the library, without Python: a line for each, with its name and the
//! bits of all motions of unknowns and outputs. The tests in Python compare theirs with these.

use kin_core::any::{AssemblyChoice, Described, MotionOver};
use kin_core::in_small_letters;
use kin_live::Mechanism;
use kin_studio::library::{DESIGNS, DesignAssembly};

/// The rates of every input, from the velocity on.
const RATES: [f64; 4] = [3.0, 0.5, -0.25, 0.125];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for design in DESIGNS {
        let mechanism = Mechanism::declare(design.declaration())?;
        let choice = match design.assembly {
            DesignAssembly::Named(name) => {
                let index = mechanism.assembly_names().iter().position(|assembly| assembly == name);
                AssemblyChoice::Index(index.ok_or("no such assembly")?)
            }
            DesignAssembly::Near(near) => AssemblyChoice::Near(near.to_vec()),
        };
        let description = mechanism.description();
        let orders = description.order + 1;
        let motion = |position: &f64| std::iter::once(*position).chain(RATES).take(orders).collect::<Vec<_>>();
        let inputs: Vec<f64> = design.inputs.iter().flat_map(motion).collect();
        let mut unknowns = vec![0.0; description.unknowns.len() * orders];
        let mut outputs = vec![0.0; description.outputs.len() * orders];
        mechanism.motion(
            design.parameters,
            &inputs,
            choice.position(),
            &mut unknowns,
            &mut outputs,
        )?;
        let bits = unknowns
            .iter()
            .chain(&outputs)
            .map(|number| format!(" {:016x}", number.to_bits()));
        println!("{}{}", in_small_letters(design.name, '_'), bits.collect::<String>());
    }
    Ok(())
}
