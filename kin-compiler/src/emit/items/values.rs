//! The methods by which a pose of any order returns its position.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use crate::algebra::Symbol;
use crate::emit::compiled::Compiled;
use crate::emit::text::ProgramText;

/// `impl PoseOf`, `impl Guess` and `impl Display`, for the pose of each order.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let name = &model.name;
    let unknowns: Vec<TokenStream> = (0..model.unknowns.len())
        .map(|index| mechanism.unknown_value(index, &quote!(self)))
        .collect();
    let inputs: Vec<_> = model.inputs.iter().map(|input| &input.name).collect();
    let arguments = inputs.len() + usize::from(mechanism.is_coupled() || !mechanism.assembly_argument().is_empty());
    let [input_count, arguments, unknown_count] =
        [inputs.len(), arguments, model.unknowns.len()].map(Literal::usize_unsuffixed);
    let outputs = model.outputs.iter().map(|output| &output.name);
    let unknown_fields = model.unknowns.iter().map(|unknown| &unknown.name);
    let fields: Vec<_> = inputs.iter().copied().chain(unknown_fields).chain(outputs).collect();
    let poses: Vec<_> = (0..=mechanism.order()).map(|order| mechanism.pose(order)).collect();
    let implementations = poses.iter().map(|pose| {
        quote! {
            impl<T: #runtime::Scalar> #runtime::PoseOf<#name<T>> for #pose<T> {
                fn values(&self) -> ([T; #input_count], [T; #unknown_count]) {
                    ([#(self.#inputs.value()),*], [#(#unknowns),*])
                }
            }
        }
    });
    quote! {
        #(#implementations)*
        #runtime::poses! { #name, #arguments, #unknown_count, [#(#fields)*], #(#poses)* }
    }
}

/// The argument for a pose of any order, and its name.
pub(in crate::emit) fn argument(mechanism: &Compiled<'_>) -> (Ident, TokenStream) {
    let runtime = mechanism.runtime;
    let pose = mechanism.fresh("pose");
    let argument = quote!(#pose: &impl #runtime::PoseOf<Self>);
    (pose, argument)
}

/// `let` for the used values of a row, by their names.
pub(in crate::emit) fn bound(
    text: &ProgramText<'_>,
    used: &BTreeSet<Symbol>,
    symbols: &[Symbol],
    row: &TokenStream,
) -> TokenStream {
    if !symbols.iter().any(|symbol| used.contains(symbol)) {
        return TokenStream::new();
    }
    let names = symbols.iter().map(|symbol| {
        if used.contains(symbol) {
            text.name(*symbol).into_token_stream()
        } else {
            quote!(_)
        }
    });
    quote!(let [#(#names),*] = #row;)
}
