//! The methods that only generated code calls. They are methods of a trait that no one else can name, so that editors
//! do not offer them beside the solvers.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::compiled::Compiled;

/// A method of that trait.
pub(in crate::emit) struct Internal {
    pub(in crate::emit) attributes: TokenStream,
    pub(in crate::emit) signature: TokenStream,
    pub(in crate::emit) body: TokenStream,
}

/// The trait with its implementation for every number type, and one for `f64` alone.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>, generic: &[Internal], of_f64: &[Internal]) -> TokenStream {
    let (runtime, name) = (mechanism.runtime, &mechanism.model.name);
    let number = quote!(::core::primitive::f64);
    let [generic_trait, f64_trait] = ["Internal", "InternalOfF64"].map(|name| mechanism.type_parameter(name));
    let (signatures, definitions) = split(generic);
    let generic = quote! {
        trait #generic_trait<T> {
            #signatures
        }

        impl<T: #runtime::Scalar> #generic_trait<T> for #name<T> {
            #definitions
        }
    };
    if of_f64.is_empty() {
        return generic;
    }
    let (signatures, definitions) = split(of_f64);
    quote! {
        #generic

        trait #f64_trait {
            #signatures
        }

        impl #f64_trait for #name<#number> {
            #definitions
        }
    }
}

/// The declarations of methods, and their definitions.
fn split(methods: &[Internal]) -> (TokenStream, TokenStream) {
    let signatures = methods.iter().map(|method| &method.signature);
    let definitions = methods.iter().map(|method| {
        let Internal {
            attributes,
            signature,
            body,
        } = method;
        quote!(#attributes #signature { #body })
    });
    (quote!(#(#signatures;)*), quote!(#(#definitions)*))
}
