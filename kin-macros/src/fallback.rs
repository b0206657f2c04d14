//! What stands in for a mechanism whose declaration holds mistakes.
//!
//! The struct remains, so that an editor goes on completing its fields. It dereferences to a type with a mistake inside, the first
//! of the declaration: the compiler knows that it has told of it, and stays silent about every method that is sought there, whatever
//! its arguments, and about all that is done with what it returns. (A macro that fails in the place of a type would leave `()` there;
//! in the length of an array it leaves an error, and so does an associated type of that array.)

use std::collections::BTreeSet;

use proc_macro2::{Span, TokenStream};
use quote::quote_spanned;

use crate::emit;
use crate::mistakes::Mistakes;
use crate::syntax::{Declaration, ParameterField};

/// The mistakes, and the stand-in for as much as could be read.
pub(crate) fn tokens(declaration: Option<&Declaration>, mistakes: Mistakes, runtime: &TokenStream) -> TokenStream {
    let Some(declaration) = declaration else {
        return mistakes.into_compile_errors();
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
    let errors = mistakes.into_each_compile_error();
    let Some((first, others)) = errors.split_first() else {
        return structure;
    };
    let site = Span::mixed_site();
    let name = &declaration.name;
    quote_spanned! {site=>
        const _: () = {
            type Unexpanded = <[(); #first] as ::core::ops::Deref>::Target;

            impl<T> #name<T> {
                #[doc(hidden)]
                pub const ASSEMBLIES: Unexpanded = ::core::unreachable!();
                #[doc(hidden)]
                pub const OPERATIONS: Unexpanded = ::core::unreachable!();
            }

            impl<T> ::core::ops::Deref for #name<T> {
                type Target = Unexpanded;

                fn deref(&self) -> &Unexpanded {
                    ::core::unreachable!()
                }
            }
        };
        #(#others)*
        #structure
    }
}
