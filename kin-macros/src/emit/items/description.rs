//! The cost of a mechanism, as constants.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::compiled::{Compiled, local};
use crate::program::Cost;

/// `OPERATIONS`: position, velocity, ….
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let runtime = mechanism.runtime;
    let list = operations(mechanism);
    let size = Literal::usize_unsuffixed(mechanism.order() + 1);
    quote! {
            /// The cost of the solver of each order, position first, in the assembly that costs most.
            pub const OPERATIONS: [#runtime::Operations; #size] = #list;

    }
}

/// The costs as an array.
fn operations(mechanism: &Compiled<'_>) -> TokenStream {
    let runtime = mechanism.runtime;
    let costs = mechanism
        .solvers
        .orders()
        .iter()
        .map(|stage| operations_of(runtime, stage.cost));
    quote!([#(#costs),*])
}

/// One cost.
pub(in crate::emit) fn operations_of(runtime: &TokenStream, cost: Cost) -> TokenStream {
    let fields = [
        ("additions", cost.additions),
        ("multiplications", cost.multiplications),
        ("divisions", cost.divisions),
        ("negations", cost.negations),
        ("square_roots", cost.square_roots),
        ("sine_cosines", cost.sine_cosines),
        ("arc_tangents", cost.arc_tangents),
        ("others", cost.others),
    ];
    let all = fields.len();
    let fields: Vec<TokenStream> = fields
        .into_iter()
        .filter(|&(_, count)| count > 0)
        .map(|(name, count)| {
            let (name, count) = (local(name), Literal::usize_unsuffixed(count));
            quote!(#name: #count)
        })
        .collect();
    match fields.len() {
        0 => quote!(#runtime::Operations::NONE),
        count if count == all => quote!(#runtime::Operations { #(#fields),* }),
        _ => quote!(#runtime::Operations { #(#fields,)* ..#runtime::Operations::NONE }),
    }
}
