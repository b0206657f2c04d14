//! The traits of serde: one call, which kin-core answers by nothing without its feature.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::compiled::{Compiled, local};

/// The poses with their quantities, and the structure of assemblies.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let (name, pose) = (&model.name, local("__pose"));
    let poses = (0..=mechanism.order()).map(|order| {
        let (pose, length) = (mechanism.pose(order), Literal::usize_unsuffixed(order + 1));
        quote!(#pose #length)
    });
    let inputs = model.inputs.iter().map(|input| &input.name);
    let unknowns = model.unknowns.iter().enumerate().map(|(index, unknown)| {
        let (name, index) = (&unknown.name, Literal::usize_unsuffixed(index));
        quote!(#name #index)
    });
    let outputs = model.outputs.iter().map(|output| {
        let field = &output.name;
        let axes = output.value.shape().axes();
        if axes.is_empty() {
            return quote!(#pose.#field);
        }
        let axes = axes.iter().map(|axis| local(&axis.to_string()));
        quote!(#(#pose.#field.#axes()),*)
    });
    let assembly = (mechanism.choices().len() > 1).then(|| {
        let name = mechanism.assembly_structure();
        let choices = mechanism
            .assembly_fields()
            .into_iter()
            .enumerate()
            .map(|(index, field)| {
                let index = Literal::usize_unsuffixed(index);
                quote!(#field #index)
            });
        quote!(; #name { #(#choices),* })
    });
    quote! {
        #runtime::stored! {
            #name: #(#poses),*; { #pose => [#(#inputs),*] [#(#unknowns),*] [#(#outputs),*] } #assembly
        }
    }
}
