//! Everything in one call, the equations themselves, and how failures are told.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::mechanism::{Mechanism, attributes, local};
use crate::emit::source::closure;
use crate::program::order_name;

/// `solve`, `solve_near`, `closure`, and the maker of errors.
pub(in crate::emit) fn tokens(mechanism: &Mechanism<'_>) -> TokenStream {
    let runtime = mechanism.runtime;
    let model = mechanism.model;
    let order = mechanism.order();
    let (name, pose, attributes) = (&model.name, mechanism.pose(order), attributes());
    let inputs = mechanism.input_names();
    let (assembly, value) = (mechanism.assembly_argument(), mechanism.assembly_value());
    let length = Literal::usize_unsuffixed(order + 1);
    let count = Literal::usize_unsuffixed(model.unknowns.len());
    let [position, result, near] = ["position", "result", "near"].map(|name| mechanism.own(name));
    let (assembly, value) = if mechanism.is_coupled() {
        (quote!(#near: impl #runtime::Guess<T, #count>), quote!(#near))
    } else {
        (assembly, value)
    };
    let steps: TokenStream = (1..=order)
        .map(|order| {
            let method = local(&order_name(order));
            quote!(.#method(#(#inputs.#method()),*))
        })
        .collect();
    // one after the other, as they are found
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
        tests.insert(0, quote!(T::are_finite([#(#rates),*])));
    }
    let fields: Vec<_> = model
        .unknowns
        .iter()
        .map(|unknown| &unknown.name)
        .chain(model.outputs.iter().map(|output| &output.name))
        .collect();
    let field_labels: Vec<String> = fields.iter().map(ToString::to_string).collect();
    let field_count = Literal::usize_unsuffixed(fields.len());
    let input_count = Literal::usize_unsuffixed(inputs.len());
    let positions: Vec<TokenStream> = inputs.iter().map(|input| quote!(#input.position())).collect();
    let parameter_pairs: Vec<TokenStream> = mechanism
        .scalar_parameters()
        .into_iter()
        .map(|(label, value, ..)| quote!((#label, #runtime::Number::real(#value))))
        .collect();
    let labels: Vec<String> = inputs.iter().map(ToString::to_string).collect();
    let closure = closure::tokens(mechanism.declaration, model, runtime);
    let [failure, block, quantity, results, given] =
        ["failure", "block", "quantity", "results", "given"].map(|name| mechanism.own(name));
    let summary = format!(
        " Position and all time derivatives to {} in one call.",
        order_name(order)
    );
    let near_line = format!(
        " As `solve`, in the assembly and on the turns nearest to given values of the unknowns, `[{}]`.",
        mechanism.unknown_order()
    );
    quote! {
        #attributes
        impl<T: #runtime::Scalar> #name<T> {
            #[doc = #summary]
            ///
            /// The same as `position` and the solvers of the derivatives after it, and a test that everything is finite.
            ///
            /// # Errors
            /// As for `position`, and if a rate is not finite.
            #[inline]
            pub fn solve(&self, #(#inputs: #runtime::Motion<T, #length>,)* #assembly)
                -> ::core::result::Result<#pose<T>, #runtime::SolveError>
            {
                let #position = self.position(#(#positions,)* #value)?;
                self.__complete(#position, #(#inputs),*)
            }

            #[doc = #near_line]
            ///
            /// # Errors
            /// As for `solve`.
            #[inline]
            pub fn solve_near(&self, #(#inputs: #runtime::Motion<T, #length>,)* #near: [T; #count])
                -> ::core::result::Result<#pose<T>, #runtime::SolveError>
            {
                let #position = self.position_near(#(#positions,)* #near)?;
                self.__complete(#position, #(#inputs),*)
            }

            #closure
        }
    }
    .into_iter()
    .chain({
        let first_pose = mechanism.pose(0);
        quote! {
            #attributes
            impl<T: #runtime::Scalar> #name<T> {
                /// All derivatives on top of a position.
                #[inline(always)]
                fn __complete(&self, #position: #first_pose<T>, #(#inputs: #runtime::Motion<T, #length>),*)
                    -> ::core::result::Result<#pose<T>, #runtime::SolveError>
                {
                    let #result = #position #steps;
                    // the other rates show in these: what is not finite makes no finite sum or product
                    if !(#(#tests)&&*) {
                        // by what is finite, and not by reference: the results need no place in memory but where they are returned
                        return ::core::result::Result::Err(self.__culprit(
                            [#(#result.#fields.is_finite()),*],
                            [#(#inputs.is_finite()),*],
                            #(#positions),*
                        ));
                    }
                    ::core::result::Result::Ok(#result)
                }

                /// The error that names the first of the results that is not finite, or of the inputs that made it so.
                #[cold]
                #[inline(never)]
                fn __culprit(
                    &self,
                    #results: [::core::primitive::bool; #field_count],
                    #given: [::core::primitive::bool; #input_count],
                    #(#inputs: T),*
                ) -> #runtime::SolveError {
                    let #block = #runtime::solve::culprit([#(#field_labels),*], #results).unwrap_or_default();
                    let #quantity = #runtime::solve::culprit([#(#labels),*], #given).unwrap_or(#block);
                    self.__failed(#runtime::Failure::NotFinite { quantity: #quantity }, #block, #(#inputs),*)
                }

                /// An error with the place where it occurred, traced to the number that is to blame if one is not finite.
                #[cold]
                fn __failed(
                    &self,
                    #failure: #runtime::Failure,
                    #block: &'static ::core::primitive::str,
                    #(#inputs: T),*
                ) -> #runtime::SolveError {
                    #failure
                        .traced(&[#(#parameter_pairs,)* #((#labels, #runtime::Number::real(#inputs)),)*])
                        .at(#block, #runtime::InputValues::new(
                            &[#(#labels),*],
                            &[#(#runtime::Number::real(#inputs)),*],
                        ))
                }
            }
        }
    })
    .collect()
}
