//! Proofs about forces, of a declared text and of the mechanism that rustc compiled.

use std::f64::consts::TAU;

use kin_agreement::declaration;
use kin_core::Plane;
use kin_core::any::{AssemblyChoice, Of};
use kin_core::library::{FourBar, StephensonII};
use kin_core::linkage::{AnyLinkage, LinkageFunctions};
use kin_core::reaction::{PeakBounds, ReactionPart};
use kin_live::Mechanism;

fn peak(
    functions: &dyn LinkageFunctions,
    parameters: &[f64],
    [from, to]: [f64; 2],
    assembly: Option<AssemblyChoice>,
) -> PeakBounds {
    let linkage = AnyLinkage::new(functions, parameters);
    let assembly = assembly.unwrap_or_else(|| {
        let (all, _) = linkage.positions_at(&[from]).expect("it closes");
        AssemblyChoice::Near(all[0].clone())
    });
    let loads = linkage.loads().gravity(Plane::new(0.0, -9.81));
    let loads = loads.mass_of("r3", 2.0, Plane::new(0.1, 0.05), 0.03).expect("a body");
    let reactions = linkage.reactions_as_guessed(&loads).expect("bodies of the plane");
    let sweep = linkage.sweep(assembly).between(&[from], &[to], 2).speed(9.0);
    let proof = sweep.proof(&reactions).tolerance("r3", 1e-4).expect("a dimension");
    let force = proof.of("r2_r3", ReactionPart::Force).expect("a joint");
    force.peak(0.02).expect("it is proved")
}

/// The same bounds to the last bit, for a closed form and for a coupled block.
#[test]
fn proofs() {
    let four_bar = declaration(include_str!("../../../kin-core/src/library/four_bar.rs"), "FourBar");
    let four_bar = Mechanism::declare(four_bar).expect("it is declared");
    let (parameters, range) = ([0.9, 0.3, 0.8, 0.6], [0.0, TAU]);
    let open = || Some(AssemblyChoice::Index(0));
    assert_eq!(
        peak(&four_bar, &parameters, range, open()),
        peak(Of::<FourBar>::FUNCTIONS, &parameters, range, open())
    );
    let file = include_str!("../../../kin-core/src/library/stephenson_six_bars.rs");
    let stephenson = Mechanism::declare(declaration(file, "StephensonII")).expect("it is declared");
    let (parameters, range) = ([4.0, 2.0, 1.5, 1.2, 3.0, 0.3, 1.0, 0.5, 1.6, 3.0], [-0.2, -0.1]);
    assert_eq!(
        peak(&stephenson, &parameters, range, None),
        peak(Of::<StephensonII>::FUNCTIONS, &parameters, range, None)
    );
}
