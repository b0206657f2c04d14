//! `Debug` of the poses: inputs, unknowns and outputs, without the values that later orders need.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::compiled::Compiled;

/// One call, which kin-core answers by an implementation for each pose.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let poses = (0..=mechanism.order()).map(|order| mechanism.pose(order));
    let inputs = model.inputs.iter().map(|input| &input.name);
    let unknowns = model.unknowns.iter().map(|unknown| &unknown.name);
    let outputs = model.outputs.iter().map(|output| &output.name);
    let fields = inputs.chain(unknowns).chain(outputs);
    quote! {
        #runtime::readable! { [#(#poses)*] { #(#fields)* } }
    }
}
