//! The solvers of the time derivatives. Each is a method of the pose of the next lower order.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::quote;

use super::position::output_values;
use crate::algebra::Symbol;
use crate::emit::compiled::{Compiled, local};
use crate::emit::text::ProgramText;
use crate::program::Step;
use crate::program::order_name;

/// The method that adds an order: `velocity`, `acceleration`, ….
pub(in crate::emit) fn method(mechanism: &Compiled<'_>, order: usize) -> TokenStream {
    let model = mechanism.model;
    let pose = mechanism.pose(order);
    let stage = &mechanism.solvers.orders()[order];
    let text = ProgramText::of(mechanism, &mechanism.solvers.motion);
    let method = local(&order_name(order));
    let given: Vec<Symbol> = (0..model.inputs.len())
        .map(|index| Symbol::InputRate(index, order))
        .collect();
    let arguments: Vec<_> = given.iter().map(|&symbol| mechanism.name_of(symbol)).collect();
    let readings = text.readings(stage, &given);
    let body = text.plain_steps(stage);

    let known: BTreeSet<Symbol> = stage
        .steps
        .iter()
        .flat_map(Step::defines)
        .chain(stage.uses.iter().map(|carried| carried.symbol))
        .collect();
    let inputs = model.inputs.iter().zip(&arguments).map(|(input, rate)| {
        let name = &input.name;
        quote!(#name: self.#name.and(#rate))
    });
    let unknowns = model.unknowns.iter().enumerate().map(|(index, unknown)| {
        let (name, rate) = (&unknown.name, mechanism.name_of(Symbol::UnknownRate(index, order)));
        quote!(#name: self.#name.and(#rate))
    });
    let outputs = output_values(mechanism, order)
        .into_iter()
        .map(|(name, value)| quote!(#name: self.#name.and(#value)));
    let carried = stage.carries.iter().map(|carried| {
        let name = text.name(carried.symbol);
        if known.contains(&carried.symbol) {
            quote!(#name)
        } else {
            quote!(#name: self.#name)
        }
    });

    let approach = format!(" Derived from {}.", mechanism.solvers.trials.kept);
    let summary = format!(
        " Adds the {} to the pose, from the {} of the input{}.{}{}",
        order_name(order),
        order_name(order),
        if model.inputs.len() == 1 { "" } else { "s" },
        mechanism.cost_line(order),
        if order == 1 { approach.as_str() } else { "" },
    );
    let formulas = mechanism.rate_formulas(order);
    quote! {
            #[doc = #summary]
            #formulas
            #[inline(always)]
            #[must_use]
            pub fn #method(&self, #(#arguments: T),*) -> #pose<T> {
                #readings
                #body
                #pose {
                    #(#inputs,)*
                    #(#unknowns,)*
                    #(#outputs,)*
                    #(#carried,)*
                }
            }

    }
}
