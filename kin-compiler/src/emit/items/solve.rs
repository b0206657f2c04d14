//! The solution in one call.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::compiled::{Compiled, local};
use crate::emit::items::internal::Internal;
use crate::program::order_name;

/// `solve` and `solve_near`.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let runtime = mechanism.runtime;
    let model = mechanism.model;
    let order = mechanism.order();
    let pose = mechanism.pose(order);
    let inputs = mechanism.input_names();
    let ((assembly, _), value) = (mechanism.given_assembly(), mechanism.assembly_value());
    let length = Literal::usize_unsuffixed(order + 1);
    let count = Literal::usize_unsuffixed(model.unknowns.len());
    let [position, near] = ["position", "near"].map(|name| mechanism.fresh(name));
    let guess = quote!(#near: impl #runtime::Guess<T, #count, Self>);
    let (assembly, value) = if mechanism.is_coupled() {
        (guess.clone(), quote!(#near))
    } else {
        (assembly, value)
    };
    let positions: Vec<TokenStream> = inputs.iter().map(|input| quote!(#input.position())).collect();
    let motions = quote!(#(let #inputs = #inputs.into_motion();)*);
    let summary = format!(
        " Position and all time derivatives to {} in one call.",
        order_name(order)
    );
    let near_line = format!(
        " Like `solve`, but in the assembly and on the turns nearest to given values of the unknowns, `[{}]`.",
        mechanism.unknown_order()
    );
    quote! {
            #[doc = #summary]
            ///
            /// An input is one argument with its rates: an array, or `Motion::at_constant_speed(1.0, 10.0)`. A number
            /// alone is at rest.
            ///
            /// Equivalent to `position` followed by the solvers of the derivatives, with a test that all results are
            /// finite.
            ///
            /// # Errors
            /// As for `position`. Also if a rate is not finite.
            #[inline]
            pub fn solve(&self, #(#inputs: impl #runtime::IntoMotion<T, #length>,)* #assembly)
                -> ::core::result::Result<#pose<T>, #runtime::SolveError>
            {
                #motions
                let #position = self.position(#(#positions,)* #value)?;
                self.__complete(#position, #(#inputs),*)
            }

            #[doc = #near_line]
            ///
            /// # Errors
            /// As for `solve`.
            #[inline]
            pub fn solve_near(&self, #(#inputs: impl #runtime::IntoMotion<T, #length>,)* #guess)
                -> ::core::result::Result<#pose<T>, #runtime::SolveError>
            {
                #motions
                let #position = self.position_near(#(#positions,)* #near)?;
                self.__complete(#position, #(#inputs),*)
            }
    }
}

/// The code that `solve` and the position solvers share: the derivatives of a position, and the construction of errors.
pub(in crate::emit) fn internal(mechanism: &Compiled<'_>) -> [Internal; 2] {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let order = mechanism.order();
    let (pose, first_pose) = (mechanism.pose(order), mechanism.pose(0));
    let inputs = mechanism.input_names();
    let length = Literal::usize_unsuffixed(order + 1);
    let [position, result, failure, block] =
        ["position", "result", "failure", "block"].map(|name| mechanism.fresh(name));
    let steps: TokenStream = (1..=order)
        .map(|order| {
            let method = local(&order_name(order));
            quote!(.#method(#(#inputs.#method()),*))
        })
        .collect();
    // in the order in which they are found
    let mut telltales: Vec<(usize, usize)> = mechanism.solvers.telltales.iter().copied().collect();
    telltales.sort_by_key(|&(unknown, order)| (order, unknown));
    let rates = telltales.iter().map(|&(unknown, order)| {
        let (field, rate) = (&model.unknowns[unknown].name, local(&order_name(order)));
        quote!(#result.#field.#rate())
    });
    let mut tests: Vec<TokenStream> = model
        .outputs
        .iter()
        .map(|output| {
            let field = &output.name;
            quote!(#result.#field.is_finite())
        })
        .collect();
    if !telltales.is_empty() {
        tests.insert(0, quote!(T::are_finite(&[#(#rates),*])));
    }
    let unknowns = model.unknowns.iter().map(|unknown| &unknown.name);
    let fields: Vec<_> = unknowns
        .chain(model.outputs.iter().map(|output| &output.name))
        .collect();
    let field_labels = fields.iter().map(ToString::to_string);
    let labels: Vec<String> = inputs.iter().map(ToString::to_string).collect();
    let complete = Internal {
        attributes: quote! {
            /// Adds all derivatives to a position.
            #[inline(always)]
        },
        signature: quote! {
            fn __complete(&self, #position: #first_pose<T>, #(#inputs: #runtime::Motion<T, #length>),*)
                -> ::core::result::Result<#pose<T>, #runtime::SolveError>
        },
        body: quote! {
            let #result = #position #steps;
            // if another rate were not finite, one of these would not be finite either
            if !(#(#tests)&&*) {
                // pass flags and not references: references would force the results into memory
                return ::core::result::Result::Err(#runtime::culprit(
                    [#((#field_labels, #result.#fields.is_finite())),*],
                    [#((#labels, #inputs.is_finite())),*],
                    |#failure, #block| self.__failed(#failure, #block, #(#inputs.position()),*),
                ));
            }
            ::core::result::Result::Ok(#result)
        },
    };
    let failed = Internal {
        attributes: quote! {
            /// An error with the block and the inputs. If a parameter or an input is not finite, the error names it.
            #[cold]
        },
        signature: quote! {
            fn __failed(
                &self,
                #failure: #runtime::Failure,
                #block: &'static ::core::primitive::str,
                #(#inputs: T),*
            ) -> #runtime::SolveError
        },
        body: quote!(#runtime::failed(self, #failure, #block, [#(#inputs),*])),
    };
    [complete, failed]
}
