//! All assemblies of a mechanism with coupled blocks, by continuation.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::algebra::Symbol;
use crate::emit::compiled::{Compiled, local};
use crate::emit::items::internal::Internal;
use crate::emit::text::ProgramText;
use crate::lower::most_positions;
use crate::program::{Expression, Program};
use crate::structure::PolynomialSystem;

/// The program that goes through all positions, and the number of paths; `None` if not all positions can be found.
fn search<'a>(mechanism: &Compiled<'a>) -> Option<(&'a Program<Expression>, usize)> {
    let paths = most_positions(mechanism.blocks, mechanism.solvers)?;
    Some((mechanism.solvers.every.as_ref()?, paths))
}

/// Whether the mechanism has the method `assemblies_at`.
pub(super) fn is_found(mechanism: &Compiled<'_>) -> bool {
    search(mechanism).is_some()
}

/// The method `positions_at` of the trait, for a mechanism with coupled blocks.
pub(in crate::emit) fn implementation(mechanism: &Compiled<'_>) -> TokenStream {
    if search(mechanism).is_none() {
        return TokenStream::new();
    }
    let runtime = mechanism.runtime;
    let name = &mechanism.model.name;
    let [inputs, found, plain] = ["inputs", "found", "plain"].map(local);
    let [input_count, unknown_count] =
        [mechanism.model.inputs.len(), mechanism.model.unknowns.len()].map(Literal::usize_unsuffixed);
    let values = (0..mechanism.model.inputs.len()).map(|input| {
        let input = Literal::usize_unsuffixed(input);
        quote!(#runtime::Number::real(#inputs[#input]))
    });
    quote! {
        fn positions_at(
            &self,
            #inputs: [T; #input_count],
            #found: impl ::core::ops::FnMut(Self::Assembly, [T; #unknown_count]),
        ) -> ::core::result::Result<#runtime::PositionSearch, #runtime::SolveError> {
            let #plain: #name<::core::primitive::f64> = self.convert(#runtime::Number::real);
            let #plain = #plain.assemblies_at(#(#values),*)?;
            ::core::result::Result::Ok(#runtime::positions_near(self, #inputs, &#plain, #found))
        }
    }
}

/// The method `assemblies_at`, if all assemblies can be found.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let Some((_, paths)) = search(mechanism) else {
        return TokenStream::new();
    };
    let runtime = mechanism.runtime;
    let inputs = mechanism.input_names();
    let count = Literal::usize_unsuffixed(mechanism.model.unknowns.len());
    let capacity = Literal::usize_unsuffixed(paths);
    let blocks = mechanism.blocks.iter().filter_map(|block| block.all.as_ref());
    let room = Literal::usize_unsuffixed(blocks.map(PolynomialSystem::room).sum());
    let [way, near] = ["choices", "near"].map(|name| mechanism.fresh(name));
    let lines = mechanism
        .blocks
        .iter()
        .filter_map(|block| Some((block, block.all.as_ref()?)))
        .map(|(block, system)| {
            format!(
                " - `{}`: at most {} solutions, real and complex",
                mechanism.names(&block.unknowns),
                system.paths
            )
        });
    let order = format!(
        " Each assembly is given by the values of the unknowns, `[{}]`. Pass it to `position` or `solve`.",
        mechanism.unknown_order()
    );
    quote! {
            /// All assemblies at given inputs: every regular position.
            ///
            #[doc = #order]
            /// The search starts from a system whose solutions are known and follows each of them to a solution of the
            /// coupled equations. `Assemblies` of the library says what this guarantees.
            ///
            #(#[doc = #lines])*
            ///
            /// # Errors
            /// Returns an error if a parameter or an input is not finite.
            pub fn assemblies_at(&self, #(#inputs: ::core::primitive::f64),*)
                -> ::core::result::Result<#runtime::Assemblies<#count, #capacity>, #runtime::SolveError>
            {
                #runtime::every::<#count, #capacity, #room>(
                    |#way| self.__one_of_all(#(#inputs,)* #way),
                    |#near| #runtime::Mechanism::position_near(self, [#(#inputs),*], #near),
                )
            }

    }
}

/// The method of the same name that says why there is none, for a mechanism with coupled blocks.
pub(in crate::emit) fn absence(mechanism: &Compiled<'_>) -> TokenStream {
    if !mechanism.is_coupled() || is_found(mechanism) {
        return TokenStream::new();
    }
    let (runtime, name, inputs) = (mechanism.runtime, &mechanism.model.name, mechanism.input_names());
    quote!(#runtime::not_all_positions! { #name #(#inputs)* })
}

/// `__one_of_all`: the unknowns of one assembly, as the choices on the way say.
pub(in crate::emit) fn internal(mechanism: &Compiled<'_>) -> Option<Internal> {
    let (program, _) = search(mechanism)?;
    let (text, stage) = (ProgramText::of_every(mechanism, program), &program.stages[0]);
    let runtime = mechanism.runtime;
    let inputs = mechanism.input_names();
    let count = Literal::usize_unsuffixed(mechanism.model.unknowns.len());
    let given: Vec<Symbol> = (0..mechanism.model.inputs.len()).map(Symbol::Input).collect();
    let readings = text.readings(stage, &given);
    let body = text.position_steps(stage);
    let unknowns = (0..mechanism.model.unknowns.len()).map(|index| mechanism.name_of(Symbol::Unknown(index)));
    let way = mechanism.fresh("choices");
    Some(Internal {
        attributes: TokenStream::new(),
        signature: quote! {
            fn __one_of_all(
                &self,
                #(#inputs: ::core::primitive::f64,)*
                #way: &mut #runtime::Choices<'_>,
            ) -> ::core::result::Result<[::core::primitive::f64; #count], #runtime::SolveError>
        },
        body: quote! {
            use #runtime::Number as _;
            type T = ::core::primitive::f64;
            #readings
            #body
            ::core::result::Result::Ok([#(#unknowns),*])
        },
    })
}
