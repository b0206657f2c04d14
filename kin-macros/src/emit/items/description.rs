//! What a mechanism costs, as constants.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::mechanism::{Mechanism, attributes, local};
use crate::program::Cost;

/// `OPERATIONS`: position, velocity, ….
pub(in crate::emit) fn tokens(mechanism: &Mechanism<'_>) -> TokenStream {
    let runtime = mechanism.runtime;
    let name = &mechanism.model.name;
    let attributes = attributes();
    let list = operations(mechanism);
    let size = Literal::usize_unsuffixed(mechanism.order() + 1);
    quote! {
        #attributes
        impl #name<::core::primitive::f64> {
            /// What the solver of each order costs, position first, in the assembly that costs most.
            pub const OPERATIONS: [#runtime::Operations; #size] = #list;
        }
    }
}

/// The costs as an array.
pub(in crate::emit) fn operations(mechanism: &Mechanism<'_>) -> TokenStream {
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
    ]
    .map(|(name, count)| {
        let (name, count) = (local(name), Literal::usize_unsuffixed(count));
        quote!(#name: #count)
    });
    quote!(#runtime::Operations { #(#fields),* })
}
