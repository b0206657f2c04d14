//! What a pose of any order says of its position.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::algebra::Symbol;
use crate::emit::mechanism::{Mechanism, attributes};
use crate::emit::text::Text;

/// `impl PoseOf`, for the pose of each order.
pub(in crate::emit) fn tokens(mechanism: &Mechanism<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let (name, attributes) = (&model.name, attributes());
    let inputs: Vec<_> = model.inputs.iter().map(|input| &input.name).collect();
    let [input_count, unknown_count] = [inputs.len(), model.unknowns.len()].map(Literal::usize_unsuffixed);
    (0..=mechanism.order())
        .map(|order| {
            let pose = mechanism.pose(order);
            quote! {
                #attributes
                impl<T: #runtime::Scalar> #runtime::PoseOf<#name<T>> for #pose<T> {
                    fn input_values(&self) -> [T; #input_count] {
                        [#(self.#inputs.value()),*]
                    }

                    fn unknown_values(&self) -> [T; #unknown_count] {
                        self.unknowns()
                    }
                }
            }
        })
        .collect()
}

/// The argument that takes a pose of any order, and its name.
pub(in crate::emit) fn argument(mechanism: &Mechanism<'_>) -> (Ident, TokenStream) {
    let runtime = mechanism.runtime;
    let pose = mechanism.own("pose");
    let argument = quote!(#pose: &impl #runtime::PoseOf<Self>);
    (pose, argument)
}

/// `let` for those of some values in a row that are used, by their own names.
pub(in crate::emit) fn bound(
    text: &Text<'_>,
    used: &BTreeSet<Symbol>,
    symbols: &[Symbol],
    row: &Ident,
) -> Vec<TokenStream> {
    symbols
        .iter()
        .enumerate()
        .filter(|(_, symbol)| used.contains(symbol))
        .map(|(index, &symbol)| {
            let (name, index) = (text.name(symbol), Literal::usize_unsuffixed(index));
            quote!(let #name = #row[#index];)
        })
        .collect()
}
