//! The transmission angles of all dyads.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::values;
use crate::algebra::Symbol;
use crate::emit::compiled::{Compiled, local};
use crate::emit::text::ProgramText;
use crate::model::Request;
use crate::program::{Step, TransmissionAngles};
use crate::structure::Dyad;

/// The inherent method `transmission_angles`, if it is requested.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    if !mechanism.is_requested(Request::TransmissionAngles) {
        return TokenStream::new();
    }
    let runtime = mechanism.runtime;
    let dyads = &mechanism.solvers.transmission.dyads;
    let (pose, argument) = values::argument(mechanism);
    let lines = dyads.iter().enumerate().map(|(index, (dyad, _))| {
        format!(
            " - `[{index}]`: `{}`, {}",
            label(mechanism, dyad),
            dyad.kind.description()
        )
    });
    let count = Literal::usize_unsuffixed(dyads.len());
    quote! {
            /// The transmission angle of every dyad, in a pose of any order.
            ///
            #(#[doc = #lines])*
            #[must_use]
            pub fn transmission_angles(&self, #argument) -> [#runtime::TransmissionAngle<T>; #count] {
                #runtime::Mechanism::transmission_angles(self, #pose)
            }

    }
}

/// The row of the dyads and the method `transmission_angles_at` of the trait.
pub(in crate::emit) fn implementation(mechanism: &Compiled<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let TransmissionAngles { dyads, program } = &mechanism.solvers.transmission;
    let (text, stage) = (ProgramText::of(mechanism, program), &program.stages[0]);
    let used: BTreeSet<Symbol> = stage.steps.iter().flat_map(Step::uses).collect();
    let arguments @ [input_row, unknown_row] = &["inputs", "unknowns"].map(local);
    let inputs: Vec<Symbol> = (0..model.inputs.len()).map(Symbol::Input).collect();
    let unknowns: Vec<Symbol> = (0..model.unknowns.len()).map(Symbol::Unknown).collect();
    let readings = text.readings(stage, &[inputs.as_slice(), unknowns.as_slice()].concat());
    let inputs = values::bound(&text, &used, &inputs, &quote!(#input_row));
    let unknowns = values::bound(&text, &used, &unknowns, &quote!(#unknown_row));
    let body = text.plain_steps(stage);
    let angles = dyads.iter().map(|(dyad, parts)| {
        let [across, along] = parts.map(|symbol| text.name(symbol));
        let label = label(mechanism, dyad);
        quote!(#runtime::TransmissionAngle::of(#label, #across, #along))
    });
    let count = Literal::usize_unsuffixed(dyads.len());
    let [input_count, unknown_count] = [model.inputs.len(), model.unknowns.len()].map(Literal::usize_unsuffixed);
    let unused = arguments
        .iter()
        .zip([&inputs, &unknowns])
        .filter(|(_, bound)| bound.is_empty());
    let unused = unused.map(|(argument, _)| argument);
    quote! {
        type Dyads<Element: ::core::marker::Copy> = [Element; #count];

        #[inline(always)]
        fn transmission_angles_at(&self, #input_row: [T; #input_count], #unknown_row: [T; #unknown_count])
            -> [#runtime::TransmissionAngle<T>; #count]
        {
            #(let _ = #unused;)*
            #inputs
            #unknowns
            #readings
            #body
            [#(#angles),*]
        }
    }
}

/// The unknowns of a dyad, separated by commas.
fn label(mechanism: &Compiled<'_>, dyad: &Dyad) -> String {
    let names: Vec<String> = dyad
        .unknowns
        .iter()
        .map(|&unknown| mechanism.model.unknowns[unknown].name.to_string())
        .collect();
    names.join(", ")
}
