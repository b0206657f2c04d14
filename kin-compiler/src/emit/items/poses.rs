//! The poses: one structure for each order. It holds all motions through that order, and the values that later orders
//! need.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use syn::Attribute;

use super::documentation::unit;
use super::rates;
use crate::emit::compiled::{Compiled, attributes, local};
use crate::emit::equality::Equality;
use crate::program::order_name;

/// The structures.
pub(in crate::emit) fn structures(mechanism: &Compiled<'_>) -> TokenStream {
    (0..=mechanism.order())
        .map(|order| structure(mechanism, order))
        .collect()
}

/// The methods of each pose. One is the solver of the next order.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let runtime = mechanism.runtime;
    (0..=mechanism.order())
        .map(|order| {
            let (pose, near) = (mechanism.pose(order), values_near(mechanism));
            let next = (order < mechanism.order()).then(|| rates::method(mechanism, order + 1));
            if near.is_empty() && next.is_none() {
                return TokenStream::new();
            }
            quote! {
                impl<T: #runtime::Scalar> #pose<T> {
                    #near
                    #next
                }
            }
        })
        .collect()
}

/// A field's documentation: that of the user, then a generated line.
fn documented(users: &[Attribute], line: &str) -> TokenStream {
    let separator = if users.is_empty() {
        TokenStream::new()
    } else {
        quote!(#[doc = ""])
    };
    quote!(#(#users)* #separator #[doc = #line])
}

fn structure(mechanism: &Compiled<'_>, order: usize) -> TokenStream {
    let runtime = mechanism.runtime;
    let model = mechanism.model;
    let visibility = &model.visibility;
    let attributes = attributes();
    let name = mechanism.pose(order);
    let length = Literal::usize_unsuffixed(order + 1);
    let summary = match order {
        0 => format!(" The position of [`{}`].", model.name),
        1 => format!(" Position and velocity of [`{}`].", model.name),
        _ => format!(" The motion of [`{}`] through {}.", model.name, order_name(order)),
    };
    let inputs = model.inputs.iter().map(|input| {
        let name = &input.name;
        let documentation = documented(&input.documentation, &format!(" Input {}.", unit(input.dimension)));
        quote! {
            #documentation
            pub #name: #runtime::Motion<T, #length>
        }
    });
    let unknowns = model.unknowns.iter().enumerate().map(|(index, unknown)| {
        let name = &unknown.name;
        let documentation = documented(&unknown.documentation, &mechanism.unknown_line(index));
        let kind = mechanism.unknown_type(index, order, &quote!(T));
        quote! {
            #documentation
            pub #name: #kind
        }
    });
    let outputs = model.outputs.iter().map(|output| {
        let name = &output.name;
        let kind = mechanism.output_type(output.value.shape(), &quote!(T));
        let line = format!(" Output {}: `{}`.", unit(output.dimension), output.text);
        let documentation = documented(&output.documentation, &line);
        quote! {
            #documentation
            pub #name: #runtime::Motion<#kind, #length>
        }
    });
    let quantities = (model.inputs.iter().map(|input| &input.name))
        .chain(model.unknowns.iter().map(|unknown| &unknown.name))
        .chain(model.outputs.iter().map(|output| &output.name));
    let carries = &mechanism.solvers.orders()[order].carries;
    let names: Vec<Ident> = quantities
        .cloned()
        .chain(carries.iter().map(|carried| mechanism.name_of(carried.symbol)))
        .collect();
    let Equality { derived, implemented } = Equality::of(&name, &format_ident!("T"), &names);
    let derived = derived.into_iter();
    let carried = carries.iter().map(|carried| {
        let name = mechanism.name_of(carried.symbol);
        match carried.factors {
            None => quote!(#name: T),
            Some(size) => {
                let size = Literal::usize_unsuffixed(size);
                quote!(#name: #runtime::solve::Factors<T, #size>)
            }
        }
    });
    quote! {
        #[doc = #summary]
        #[derive(::core::clone::Clone, ::core::marker::Copy #(, #derived)*)]
        #attributes
        #visibility struct #name<T = ::core::primitive::f64> {
            #(#inputs,)*
            #(#unknowns,)*
            #(#outputs,)*
            #(#carried,)*
        }

        #implemented
    }
}

/// `unknowns_near`: the angles of directions unwrapped to given values.
fn values_near(mechanism: &Compiled<'_>) -> TokenStream {
    if !mechanism.has_directions() {
        return TokenStream::new();
    }
    let model = mechanism.model;
    let count = Literal::usize_unsuffixed(model.unknowns.len());
    let near = local("near");
    let values = (0..model.unknowns.len()).map(|index| {
        let literal = Literal::usize_unsuffixed(index);
        mechanism.unknown_value_near(index, &quote!(#near[#literal]))
    });
    quote! {
        /// Like `unknowns`, but angles calculated from unit vectors are unwrapped to given values.
        #[must_use]
        pub fn unknowns_near(&self, #near: [T; #count]) -> [T; #count] {
            [#(#values),*]
        }
    }
}
