//! The formulas of whole mechanisms.

use proc_macro2::TokenStream;

use super::{Formula, Formulas, formulas};
use crate::mistakes::Mistakes;
use crate::testing::library::library;
use crate::{expand, model, syntax};

/// The formulas of a declaration without mistakes.
fn formulas_of(declaration: TokenStream) -> Formulas {
    let mut mistakes = Mistakes::new();
    let declaration = syntax::parse(declaration, &mut mistakes).expect("there is a structure");
    let model = model::build(&declaration, &mut mistakes).expect("there are no mistakes");
    let structure = expand::structure(&declaration, &model, &mut mistakes).expect("it can be solved");
    formulas(
        &declaration,
        &model,
        structure.graph,
        &structure.residuals,
        &structure.blocks,
    )
}

/// All formulas with the names of their parts.
fn parts(formulas: &Formulas) -> Vec<(&'static str, &Formula)> {
    let mut parts = vec![("closure", &formulas.closure), ("outputs", &formulas.outputs)];
    parts.extend(formulas.position.iter().map(|formula| ("position", formula)));
    parts.extend(formulas.velocity.iter().map(|formula| ("velocity", formula)));
    parts.push(("rates", &formulas.rates));
    parts.extend(formulas.higher.iter().map(|formula| ("higher", formula)));
    parts
}

/// Prints the formulas of the library: `cargo test -p kin-macros formulas_of_the_library -- --ignored --nocapture`.
#[test]
#[ignore = "prints formulas"]
fn formulas_of_the_library() {
    for declared in library() {
        println!("\n{}", declared.name);
        for (name, formula) in parts(&formulas_of(declared.declaration)) {
            println!("  {name}\n{}", formula.text);
        }
    }
}
