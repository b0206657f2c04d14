//! The position solvers.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::algebra::Symbol;
use crate::emit::compiled::{Compiled, local};
use crate::emit::items::internal::Internal;
use crate::emit::items::prepared::PreparedValues;
use crate::emit::text::ProgramText;
use crate::emit::vector_type;
use crate::model::{Dimension, FormulaValue};
use crate::program::{Expression, Stage, UnitPart};

/// `position`, `position_near`, and the solver that both call.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>, prepared: Option<&PreparedValues<'_>>) -> TokenStream {
    let runtime = mechanism.runtime;
    let given_prepared = prepared.map(|_| quote!(&self.__prepared(),));
    let model = mechanism.model;
    let pose = mechanism.pose(0);
    let inputs = mechanism.input_names();
    let near = mechanism.fresh("near");
    let count = Literal::usize_unsuffixed(model.unknowns.len());
    let (found, near_choice) = if mechanism.assembly_value().is_empty() {
        (TokenStream::new(), TokenStream::new())
    } else if mechanism.is_coupled() {
        let assembly = mechanism.fresh("assembly");
        (
            quote!(let (#assembly, #near) = self.__side(#(#inputs,)* #near);),
            quote!(#assembly,),
        )
    } else {
        (TokenStream::new(), quote!(self.assembly_at(#(#inputs,)* #near),))
    };
    let formulas = mechanism.position_formulas();
    let input_line = format!(" Inputs: {}.", mechanism.input_line());
    let assemblies = mechanism.assembly_lines();
    let (equations, blocks, cost) = (
        mechanism.equation_lines(),
        mechanism.block_lines().into_iter().chain(mechanism.form_lines()),
        mechanism.cost_line(0),
    );
    let near_line = format!(
        " The position nearest to given values of the unknowns, `[{}]`: in the same assembly, with angles unwrapped to \
         them.",
        mechanism.unknown_order()
    );
    let guesses = guesses(mechanism);
    let near_errors = if guesses.is_empty() {
        " As for `position`."
    } else {
        " As for `position`. Also if a given angle has turned so often that it no longer determines a direction."
    };
    let is_coupled = mechanism.is_coupled();
    // the calls of a batch are inlined from end to end
    let inline_near = if is_coupled {
        quote!(#[inline(always)])
    } else {
        quote!(#[inline])
    };
    let guess = quote!(#near: impl #runtime::Guess<T, #count, Self>);
    let (choice, chosen) = if is_coupled {
        let chosen = quote!(self.position_near(#(#inputs,)* #near));
        (guess.clone(), chosen)
    } else {
        let (given, converted) = mechanism.given_assembly();
        let then = if converted.is_empty() {
            converted
        } else {
            quote!(#converted,)
        };
        let chosen = quote!(self.__position(#given_prepared #(#inputs,)* #then ::core::option::Option::None));
        (given, chosen)
    };
    let near_value = if is_coupled {
        quote!(#near)
    } else {
        quote!(::core::option::Option::Some(#near))
    };
    quote! {
            /// The position.
            ///
            #[doc = #input_line]
            ///
            /// Solves
            #(#[doc = #equations])*
            ///
            /// block by block:
            #(#[doc = #blocks])*
            #(#[doc = #assemblies])*
            ///
            #formulas
            ///
            #[doc = #cost]
            ///
            /// # Errors
            /// Returns an error if there is no position, if it is singular, or if a number is not finite. The error
            /// reports where this happened and by how much.
            #[inline]
            pub fn position(&self, #(#inputs: T,)* #choice)
                -> ::core::result::Result<#pose<T>, #runtime::SolveError>
            {
                #chosen
            }

            #[doc = #near_line]
            ///
            /// # Errors
            #[doc = #near_errors]
            #inline_near
            pub fn position_near(&self, #(#inputs: T,)* #guess)
                -> ::core::result::Result<#pose<T>, #runtime::SolveError>
            {
                let #near = #runtime::Guess::values(#near);
                #guesses
                #found
                self.__position(#given_prepared #(#inputs,)* #near_choice #near_value)
            }

    }
}

/// The solver that `position` and `position_near` call.
pub(in crate::emit) fn internal(mechanism: &Compiled<'_>, prepared: Option<&PreparedValues<'_>>) -> Internal {
    let runtime = mechanism.runtime;
    let model = mechanism.model;
    let pose = mechanism.pose(0);
    let inputs = mechanism.input_names();
    let assembly = mechanism.assembly_argument();
    let assembly = (!assembly.is_empty()).then(|| quote!(#assembly,));
    let near = mechanism.fresh("near");
    let count = Literal::usize_unsuffixed(model.unknowns.len());
    let near_type = if mechanism.is_coupled() {
        quote!([T; #count])
    } else {
        quote!(::core::option::Option<[T; #count]>)
    };
    let stage = &mechanism.solvers.orders()[0];
    let text = ProgramText::of(mechanism, &mechanism.solvers.motion);
    let given: Vec<Symbol> = (0..model.inputs.len()).map(Symbol::Input).collect();
    let (stage, body) = prepared.map_or_else(
        || (stage, text.position_steps(stage)),
        |prepared| (&prepared.further, prepared.body.clone()),
    );
    let parameter = prepared.map(|prepared| {
        let (name, kind) = (mechanism.fresh("prepared"), prepared.kind());
        quote!(#name: &#kind,)
    });
    let prepared = prepared.map(PreparedValues::readings);
    let readings = text.readings(stage, &given);
    let result = result(mechanism, stage);
    Internal {
        attributes: quote!(#[inline(always)]),
        signature: quote! {
            fn __position(&self, #parameter #(#inputs: T,)* #assembly #near: #near_type)
                -> ::core::result::Result<#pose<T>, #runtime::SolveError>
        },
        body: quote! {
            #prepared
            #readings
            #body
            ::core::result::Result::Ok(#result)
        },
    }
}

/// The test that guessed angles have not made so many revolutions that they no longer give a direction.
fn guesses(mechanism: &Compiled<'_>) -> TokenStream {
    let runtime = mechanism.runtime;
    let near = mechanism.fresh("near");
    let unknowns = mechanism.model.unknowns.iter().enumerate();
    let angles: Vec<TokenStream> = unknowns
        .filter(|(_, unknown)| matches!(unknown.dimension, Dimension::Angle | Dimension::Direction))
        .map(|(unknown_index, unknown)| {
            let (label, unknown_index) = (unknown.name.to_string(), Literal::usize_unsuffixed(unknown_index));
            quote!((#label, #unknown_index))
        })
        .collect();
    if angles.is_empty() {
        return TokenStream::new();
    }
    let failed = mechanism.failed_at(&mechanism.unknown_order());
    quote!(let #near = #runtime::solve::check_guesses(#near, [#(#angles),*]) #failed;)
}

/// The pose, made of the computed values.
fn result(mechanism: &Compiled<'_>, stage: &Stage<Expression>) -> TokenStream {
    let runtime = mechanism.runtime;
    let model = mechanism.model;
    let pose = mechanism.pose(0);
    let inputs = model.inputs.iter().map(|input| {
        let (name, value) = (&input.name, local(&input.name.to_string()));
        quote!(#name: #runtime::Motion::new([#value]))
    });
    let unknowns = model.unknowns.iter().enumerate().map(|(index, unknown)| {
        let name = &unknown.name;
        let part = |part| mechanism.solvers.directions().part(index, part);
        if let (Some(cosine), Some(sine)) = (part(UnitPart::Cosine), part(UnitPart::Sine)) {
            let [cosine, sine] = [cosine, sine].map(|symbol| mechanism.name_of(symbol));
            return quote!(#name: #runtime::Direction::new(#runtime::Plane::new(#cosine, #sine), []));
        }
        let value = mechanism.name_of(Symbol::Unknown(index));
        quote!(#name: #runtime::Motion::new([#value]))
    });
    let outputs = output_values(mechanism, 0)
        .into_iter()
        .map(|(name, value)| quote!(#name: #runtime::Motion::new([#value])));
    let parameters = mechanism.scalar_parameters();
    let carried = stage.carries.iter().map(|carried| {
        let name = mechanism.name_of(carried.symbol);
        match carried.parameter() {
            Some(index) if !stage.reads.contains(&carried.symbol) => {
                let value = &parameters[index].1;
                quote!(#name: #value)
            }
            _ => quote!(#name),
        }
    });
    quote!(#pose { #(#inputs,)* #(#unknowns,)* #(#outputs,)* #(#carried,)* })
}

/// The outputs' derivatives of an order, each combined from its parts.
pub(super) fn output_values<'a>(mechanism: &Compiled<'a>, order: usize) -> Vec<(&'a Ident, TokenStream)> {
    let outputs = mechanism.model.outputs.iter().zip(mechanism.output_parts());
    outputs
        .map(|(output, parts)| (&output.name, output_value(mechanism, &output.value, &parts, order)))
        .collect()
}

/// An output's derivative of an order, combined from its parts.
fn output_value(mechanism: &Compiled<'_>, value: &FormulaValue, parts: &[usize], order: usize) -> TokenStream {
    let runtime = mechanism.runtime;
    let names: Vec<_> = parts
        .iter()
        .map(|&part| mechanism.name_of(Symbol::OutputRate(part, order)))
        .collect();
    if let Some(vector) = vector_type(value.shape()) {
        quote!(#runtime::#vector::new(#(#names),*))
    } else {
        quote!(#(#names)*)
    }
}
