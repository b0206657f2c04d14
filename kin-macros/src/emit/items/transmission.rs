//! The transmission angles of all dyads, if they are requested.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::values;
use crate::algebra::Symbol;
use crate::emit::compiled::Compiled;
use crate::emit::text::Text;
use crate::program::{Step, TransmissionAngles};
use crate::structure::Dyad;

/// The method `transmission_angles`.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let Some(TransmissionAngles { dyads, program }) = &mechanism.solvers.transmission else {
        return TokenStream::new();
    };
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let (text, stage) = (Text::of(mechanism, program), &program.stages[0]);
    let used: BTreeSet<Symbol> = stage.steps.iter().flat_map(Step::uses).collect();
    let (pose, argument) = values::argument(mechanism);
    let inputs: Vec<Symbol> = (0..model.inputs.len()).map(Symbol::Input).collect();
    let unknowns: Vec<Symbol> = (0..model.unknowns.len()).map(Symbol::Unknown).collect();
    let readings = text.readings(stage, &[inputs.as_slice(), unknowns.as_slice()].concat());
    let inputs = values::bound(&text, &used, &inputs, &quote!(#pose.input_values()));
    let unknowns = values::bound(&text, &used, &unknowns, &quote!(#pose.unknowns()));
    let body = text.plain_steps(stage);
    let angles = dyads.iter().map(|(dyad, parts)| {
        let [across, along] = parts.map(|symbol| text.name(symbol));
        let label = label(mechanism, dyad);
        quote!(#runtime::TransmissionAngle::of(#label, #across, #along))
    });
    let lines = dyads.iter().enumerate().map(|(place, (dyad, _))| {
        format!(
            " - `[{place}]`: `{}`, {}",
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
