//! The partial derivatives by the parameters: the structures that hold them, and the method that finds them.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::description;
use super::documentation::{cost_line, unit};
use crate::algebra::Symbol;
use crate::emit::compiled::{Compiled, attributes, local};
use crate::emit::equality::Equality;
use crate::emit::text::ProgramText;
use crate::emit::vector_type;
use crate::model::ValueShape;
use crate::program::order_name;

/// `FourBarSensitivities` and `FourBarPartials`.
pub(in crate::emit) fn structures(mechanism: &Compiled<'_>) -> TokenStream {
    if mechanism.solvers.sensitivities().is_none() {
        return TokenStream::new();
    }
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let (visibility, attributes) = (&model.visibility, attributes());
    let (name, whole, partials) = (&model.name, whole(mechanism), partials(mechanism));
    let length = Literal::usize_unsuffixed(mechanism.order() + 1);
    let derives = |equality: &Equality| {
        let derived = equality.derived.iter();
        quote! {
            #[derive(::core::clone::Clone, ::core::marker::Copy)]
            #[derive(::core::fmt::Debug #(, #derived)*)]
        }
    };
    let all: Vec<&Ident> = model.parameters.iter().map(|parameter| &parameter.name).collect();
    let of_whole = Equality::of(&whole, &format_ident!("T"), &all);
    let unknown_names = model.unknowns.iter().map(|unknown| &unknown.name);
    let all: Vec<&Ident> = unknown_names
        .chain(model.outputs.iter().map(|output| &output.name))
        .collect();
    let of_partials = Equality::of(&partials, &format_ident!("T"), &all);
    let (whole_derives, partials_derives) = (derives(&of_whole), derives(&of_partials));
    let (whole_equality, partials_equality) = (of_whole.implemented, of_partials.implemented);
    let parameters = model.parameters.iter().map(|parameter| {
        let field = &parameter.name;
        let line = format!(" By `{field}` ({}).", unit(parameter.dimension));
        let kind = if let Some(vector) = vector_type(parameter.dimension.shape()) {
            quote!(#runtime::#vector<#partials<T>>)
        } else {
            quote!(#partials<T>)
        };
        quote! {
            #[doc = #line]
            pub #field: #kind
        }
    });
    let unknowns = model.unknowns.iter().map(|unknown| {
        let field = &unknown.name;
        let line = format!(" Of the unknown `{field}`, in its unit per unit of the parameter.");
        quote! {
            #[doc = #line]
            pub #field: #runtime::Motion<T, #length>
        }
    });
    let outputs = model.outputs.iter().map(|output| {
        let field = &output.name;
        let kind = mechanism.output_type(output.value.shape(), &quote!(T));
        let line = format!(" Of the output `{field}`, in its unit per unit of the parameter.");
        quote! {
            #[doc = #line]
            pub #field: #runtime::Motion<#kind, #length>
        }
    });
    let highest = order_name(mechanism.order());
    let whole_line = format!(
        " The partial derivatives of the motion of [`{name}`], position to {highest}, by each of its parameters."
    );
    let partials_line = format!(" The partial derivatives of the motion of [`{name}`] by one of its parameters.");
    quote! {
        #[doc = #whole_line]
        #whole_derives
        #attributes
        #visibility struct #whole<T = ::core::primitive::f64> {
            #(#parameters,)*
        }

        #whole_equality

        #[doc = #partials_line]
        #partials_derives
        #attributes
        #visibility struct #partials<T = ::core::primitive::f64> {
            #(#unknowns,)*
            #(#outputs,)*
        }

        #partials_equality
    }
}

/// `SENSITIVITY_OPERATIONS`.
pub(in crate::emit) fn cost(mechanism: &Compiled<'_>) -> TokenStream {
    let Some(stage) = mechanism.solvers.sensitivities() else {
        return TokenStream::new();
    };
    let runtime = mechanism.runtime;
    let operations = description::operations_of(runtime, stage.cost);
    quote! {
        /// The cost of the partial derivatives by all parameters, in addition to the solvers.
        pub const SENSITIVITY_OPERATIONS: #runtime::Operations = #operations;
    }
}

fn whole(mechanism: &Compiled<'_>) -> Ident {
    format_ident!(
        "{}Sensitivities",
        mechanism.model.name,
        span = mechanism.model.name.span()
    )
}

fn partials(mechanism: &Compiled<'_>) -> Ident {
    format_ident!("{}Partials", mechanism.model.name, span = mechanism.model.name.span())
}

/// `sensitivities`.
pub(in crate::emit) fn method(mechanism: &Compiled<'_>) -> TokenStream {
    let Some(stage) = mechanism.solvers.sensitivities() else {
        return TokenStream::new();
    };
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let whole = whole(mechanism);
    let (argument, pose) = (mechanism.fresh("pose"), mechanism.pose(mechanism.order()));
    let text = ProgramText::of(mechanism, &mechanism.solvers.motion);
    let readings = text.readings_from(stage, &quote!(#argument));
    let body = text.plain_steps(stage);
    let mut next = 0;
    let fields: Vec<TokenStream> = model
        .parameters
        .iter()
        .map(|parameter| {
            let field = &parameter.name;
            let shape = parameter.dimension.shape();
            let mut scalar = || {
                next += 1;
                by_parameter(mechanism, next - 1)
            };
            if let Some(vector) = vector_type(shape) {
                let fields = parts(shape).into_iter().map(|axis| {
                    let value = scalar();
                    quote!(#axis: #value)
                });
                quote!(#field: #runtime::#vector { #(#fields),* })
            } else {
                let value = scalar();
                quote!(#field: #value)
            }
        })
        .collect();
    let cost = cost_line(stage.cost);
    quote! {
            /// The partial derivatives of unknowns and outputs, and of all their time derivatives, by each parameter,
            /// for constant inputs and assembly. The pose must be a pose of this mechanism.
            ///
            /// This cannot fail: the derivatives exist where the Jacobian is regular, and elsewhere there is no pose.
            ///
            #[doc = #cost]
            #[must_use]
            pub fn sensitivities(&self, #argument: &#pose<T>) -> #whole<T> {
                #readings
                #body
                #whole { #(#fields),* }
            }
    }
}

/// The derivatives by one scalar parameter, combined into a structure.
fn by_parameter(mechanism: &Compiled<'_>, parameter: usize) -> TokenStream {
    let (runtime, model, partials) = (mechanism.runtime, mechanism.model, partials(mechanism));
    let orders = 0..=mechanism.order();
    let unknowns = model.unknowns.iter().enumerate().map(|(index, unknown)| {
        let field = &unknown.name;
        let values = orders
            .clone()
            .map(|order| mechanism.name_of(Symbol::Sensitivity(index, parameter, order)));
        quote!(#field: #runtime::Motion::new([#(#values),*]))
    });
    let outputs = model
        .outputs
        .iter()
        .zip(mechanism.output_parts())
        .map(|(output, parts)| {
            let field = &output.name;
            let values = orders.clone().map(|order| {
                let parts = parts
                    .iter()
                    .map(|&part| mechanism.name_of(Symbol::OutputSensitivity(part, parameter, order)));
                if let Some(vector) = vector_type(output.value.shape()) {
                    quote!(#runtime::#vector::new(#(#parts),*))
                } else {
                    quote!(#(#parts)*)
                }
            });
            quote!(#field: #runtime::Motion::new([#(#values),*]))
        });
    quote!(#partials { #(#unknowns,)* #(#outputs,)* })
}

/// The names of a vector's parts, none for a scalar.
fn parts(shape: ValueShape) -> Vec<Ident> {
    shape.axes().iter().map(|axis| local(&axis.to_string())).collect()
}

/// `impl Sensitive` and `impl Partials`.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    if mechanism.solvers.sensitivities().is_none() {
        return TokenStream::new();
    }
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let (name, partials) = (&model.name, partials(mechanism));
    let pose = mechanism.pose(mechanism.order());
    let [length, parameter_count, unknown_count, output_count] = [
        mechanism.order() + 1,
        mechanism.scalar_parameters().len(),
        model.unknowns.len(),
        mechanism.output_parts().iter().map(Vec::len).sum(),
    ]
    .map(Literal::usize_unsuffixed);
    let (argument, found) = (local("pose"), local("found"));
    let rows = model.parameters.iter().map(|parameter| {
        let field = &parameter.name;
        let parts = parts(parameter.dimension.shape());
        if parts.is_empty() {
            quote!(#found.#field)
        } else {
            quote!(#(#found.#field.#parts),*)
        }
    });
    let unknowns = model.unknowns.iter().map(|unknown| &unknown.name);
    let outputs = model.outputs.iter().map(|output| {
        let field = &output.name;
        let parts = parts(output.value.shape());
        if parts.is_empty() {
            quote!(self.#field)
        } else {
            quote!(#(self.#field.#parts()),*)
        }
    });
    quote! {
        impl<T: #runtime::Scalar> #runtime::Sensitive for #name<T> {
            type Partials = #partials<T>;

            const SENSITIVITY_OPERATIONS: #runtime::Operations =
                #name::<::core::primitive::f64>::SENSITIVITY_OPERATIONS;

            fn sensitivities_of(&self, #argument: &#pose<T>) -> [#partials<T>; #parameter_count] {
                let #found = self.sensitivities(#argument);
                [#(#rows),*]
            }
        }

        impl<T: #runtime::Scalar> #runtime::Partials for #partials<T> {
            type Motion = #runtime::Motion<T, #length>;
            type Unknowns<Element: ::core::marker::Copy> = [Element; #unknown_count];
            type Outputs<Element: ::core::marker::Copy> = [Element; #output_count];

            fn unknown_partials(&self) -> [#runtime::Motion<T, #length>; #unknown_count] {
                [#(self.#unknowns),*]
            }

            fn output_partials(&self) -> [#runtime::Motion<T, #length>; #output_count] {
                [#(#outputs),*]
            }
        }
    }
}
