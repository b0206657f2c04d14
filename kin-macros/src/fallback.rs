//! What stands in for a mechanism whose declaration holds mistakes.
//!
//! The struct remains, so that an editor goes on completing its fields. Its methods remain as well, but what they return is a type
//! with a mistake inside, the first of the declaration: the compiler knows that it has told of it, and stays silent about all that
//! is done with it. (A macro that fails in the place of a type would leave `()` there; in the length of an array it leaves an
//! error, and so does an associated type of that array.)

use std::collections::BTreeSet;

use proc_macro2::{Span, TokenStream};
use quote::{format_ident, quote_spanned};

use crate::emit;
use crate::report::Report;
use crate::syntax::{Declaration, ParameterField, Statement};

/// The mistakes, and the stand-in for as much as could be read.
pub(crate) fn tokens(declaration: Option<&Declaration>, report: Report, runtime: &TokenStream) -> TokenStream {
    let Some(declaration) = declaration else {
        return report.into_compile_errors();
    };
    let mut seen = BTreeSet::new();
    let first_of_its_name = |field: &&ParameterField| seen.insert(field.name.to_string());
    let fields = declaration.parameters.iter().filter(first_of_its_name).map(|field| {
        (
            field.attributes.as_slice(),
            &field.visibility,
            &field.name,
            field.dimension,
        )
    });
    let structure = emit::declaration::structure(
        &declaration.attributes,
        &declaration.visibility,
        &declaration.name,
        fields,
        runtime,
    );
    let errors = report.into_each_compile_error();
    let Some((first, others)) = errors.split_first() else {
        return structure;
    };
    let site = Span::mixed_site();
    let name = &declaration.name;
    let inputs: usize = declaration
        .statements
        .iter()
        .map(|statement| match statement {
            Statement::Inputs(items) => items.len(),
            _ => 0,
        })
        .sum();
    let methods = [
        ("position", 2),
        ("position_near", 2),
        ("solve", 2),
        ("solve_near", 2),
        ("closure", inputs + 1),
    ];
    let methods = methods.iter().map(|&(method, arguments)| {
        let method = format_ident!("{method}", span = site);
        let types: Vec<_> = (0..arguments)
            .map(|index| format_ident!("A{index}", span = site))
            .collect();
        quote_spanned! {site=>
            #[doc(hidden)]
            pub fn #method<#(#types),*>(&self, #(_: #types),*) -> Unexpanded {
                ::core::unreachable!()
            }
        }
    });
    quote_spanned! {site=>
        const _: () = {
            type Unexpanded = <[(); #first] as ::core::ops::Deref>::Target;

            impl<T> #name<T> {
                #[doc(hidden)]
                pub const ASSEMBLIES: Unexpanded = ::core::unreachable!();

                #(#methods)*
            }
        };
        #(#others)*
        #structure
    }
}
