//! The way from one pose to another within an assembly.

use proc_macro2::TokenStream;
use quote::quote;

use super::values;
use crate::emit::compiled::Compiled;

/// The method `track`.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let runtime = mechanism.runtime;
    let position = mechanism.pose(0);
    let inputs = mechanism.input_names();
    let (pose, argument) = values::argument(mechanism);
    let unknowns = mechanism.fresh("unknowns");
    quote! {
            /// The position at other inputs that the mechanism reaches from a pose of any order without leaving its
            /// assembly. Angles count whole revolutions on the way.
            ///
            /// # Errors
            /// Returns an error if there is no position, or if a limit position or a change point is on the way. The
            /// error reports its position.
            pub fn track(&self, #argument, #(#inputs: T),*)
                -> ::core::result::Result<#position<T>, #runtime::TrackErrorOf<Self>>
            {
                #runtime::track_to(self, #pose, [#(#inputs),*], |#unknowns| self.position_near(#(#inputs,)* #unknowns))
            }

    }
}
