//! The cost of a mechanism, as constants.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::describe;
use crate::emit::compiled::Compiled;
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
    let counts = describe::counts(cost).map(Literal::usize_unsuffixed);
    quote!(#runtime::Operations::__of([#(#counts),*]))
}
