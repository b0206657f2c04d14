//! The Jacobian: the velocities of unknowns and outputs for a unit velocity of each input.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::compiled::{Compiled, local};

/// The row of the results and the method `jacobian_near` of the trait.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let [inputs, columns, column] = ["inputs", "columns", "column"].map(local);
    let [near, position] = ["near", "position"].map(|name| mechanism.fresh(name));
    let input_count = model.inputs.len();
    let inputs_in_order: Vec<TokenStream> = (0..input_count)
        .map(|index| {
            let index = Literal::usize_unsuffixed(index);
            quote!(#inputs[#index])
        })
        .collect();
    let velocities = (0..input_count).map(|unit| {
        let rates = (0..input_count).map(|input| if input == unit { quote!(1.0) } else { quote!(0.0) });
        quote!(#position.velocity(#(T::constant(#rates)),*))
    });
    let unknowns = model.unknowns.iter().map(|unknown| {
        let field = &unknown.name;
        quote!(#field.velocity())
    });
    let outputs = model.outputs.iter().flat_map(|output| {
        let field = &output.name;
        let axes = output.value.shape().axes();
        if axes.is_empty() {
            return vec![quote!(#field.velocity())];
        }
        axes.iter()
            .map(|axis| {
                let axis = local(&axis.to_string());
                quote!(#field.velocity().#axis)
            })
            .collect()
    });
    let rows: Vec<TokenStream> = unknowns.chain(outputs).collect();
    let [input_count, unknown_count, row_count] =
        [input_count, model.unknowns.len(), rows.len()].map(Literal::usize_unsuffixed);
    quote! {
        type Results<Element: ::core::marker::Copy> = [Element; #row_count];

        fn jacobian_near(&self, #inputs: [T; #input_count], #near: [T; #unknown_count])
            -> ::core::result::Result<[[T; #input_count]; #row_count], #runtime::SolveError>
        {
            let #position = self.position_near(#(#inputs_in_order,)* #near)?;
            let #columns = [#(#velocities),*];
            ::core::result::Result::Ok([#(#columns.map(|#column| #column.#rows)),*])
        }
    }
}
