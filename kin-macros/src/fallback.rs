//! The replacement of a mechanism whose declaration contains mistakes.
//!
//! The struct remains, so that an editor can complete its fields. It dereferences to a type that contains the first
//! mistake. The compiler knows that it has reported this mistake. So it reports no further errors about methods that it
//! looks up there, whatever their arguments, nor about uses of their results. (A failing macro in the place of a type
//! would leave `()` there. In the length of an array it leaves an error, and so does an associated type of that array.)

use std::collections::BTreeSet;

use proc_macro2::{Span, TokenStream};
use quote::quote_spanned;

use crate::emit;
use crate::mistakes::Mistakes;
use crate::syntax::{Declaration, ParameterField};

/// The mistakes, and a replacement for the readable part of the declaration.
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
