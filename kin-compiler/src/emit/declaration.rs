//! The struct of the parameters: as declared, but generic over the number type.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{quote, quote_spanned};
use syn::punctuated::Punctuated;
use syn::{Attribute, Path, Token, Visibility, parse_quote};

use super::equality::Equality;
use super::vector_type;
use crate::model::{Dimension, Model};

/// A field: attributes, visibility, name and dimension.
pub(crate) type Field<'a> = (&'a [Attribute], &'a Visibility, &'a Ident, Option<Dimension>);

/// The struct of a model. The lines follow the user's documentation.
pub(crate) fn tokens(model: &Model, lines: &[String], runtime: &TokenStream) -> TokenStream {
    let fields = model.parameters.iter().map(|parameter| {
        (
            parameter.attributes.as_slice(),
            &parameter.visibility,
            &parameter.name,
            Some(parameter.dimension),
        )
    });
    let generated = lines.iter().map(|line| parse_quote!(#[doc = #line]));
    let attributes: Vec<Attribute> = model.attributes.iter().cloned().chain(generated).collect();
    let number = quote!(::core::primitive::f64);
    structure(&attributes, &model.visibility, &model.name, fields, &number, runtime)
}

/// The struct of given fields and a default number type, for models and for declarations with mistakes.
pub(crate) fn structure<'a>(
    attributes: &[Attribute],
    visibility: &Visibility,
    name: &Ident,
    fields: impl Iterator<Item = Field<'a>>,
    number: &TokenStream,
    runtime: &TokenStream,
) -> TokenStream {
    let mechanism = name;
    let numeric = Ident::new("T", Span::mixed_site());
    let fields: Vec<Field<'a>> = fields.collect();
    let names: Vec<&Ident> = fields.iter().map(|&(_, _, name, _)| name).collect();
    // a parameter of any dimension makes use of the number type, which otherwise would cause a further error
    let is_any_known = fields.iter().any(|(_, _, _, dimension)| dimension.is_some());
    let mut fields: Vec<TokenStream> = fields
        .into_iter()
        .map(|(attributes, visibility, name, dimension)| {
            let held = if let Some(vector) = dimension.map(Dimension::shape).and_then(vector_type) {
                quote!(#runtime::#vector<#numeric>)
            } else if dimension.is_none() && is_any_known {
                quote!(<#mechanism as #runtime::Numeric>::Number)
            } else {
                quote!(#numeric)
            };
            quote!(#(#attributes)* #visibility #name: #held)
        })
        .collect();
    if fields.is_empty() {
        fields.push(quote!(nothing: ::core::marker::PhantomData<#numeric>));
    }
    let mut missing = missing(attributes);
    let mut implemented = TokenStream::new();
    if let Some(index) = missing.iter().position(|&(trait_name, _)| trait_name == "PartialEq") {
        let equality = Equality::of(name, &numeric, &names);
        if equality.derived.is_none() {
            missing.remove(index);
        }
        implemented = equality.implemented;
    }
    let derives = derives(&missing);
    quote! {
        #(#attributes)*
        #derives
        #[allow(non_snake_case)]
        #visibility struct #name<#numeric = #number> {
            #(#fields,)*
        }
        #implemented
    }
}

/// The traits that parameters should have, by name, without those that the user derived.
fn missing(attributes: &[Attribute]) -> Vec<(&'static str, TokenStream)> {
    let derived: Vec<String> = attributes
        .iter()
        .filter(|attribute| attribute.path().is_ident("derive"))
        .filter_map(|attribute| {
            attribute
                .parse_args_with(Punctuated::<Path, Token![,]>::parse_terminated)
                .ok()
        })
        .flatten()
        .filter_map(|path| Some(path.segments.last()?.ident.to_string()))
        .collect();
    [
        ("Clone", quote!(::core::clone::Clone)),
        ("Copy", quote!(::core::marker::Copy)),
        ("Debug", quote!(::core::fmt::Debug)),
        ("PartialEq", quote!(::core::cmp::PartialEq)),
    ]
    .into_iter()
    .filter(|(name, _)| !derived.iter().any(|other| other == name))
    .collect()
}

fn derives(missing: &[(&str, TokenStream)]) -> TokenStream {
    // two traits per line
    let lines = missing
        .chunks(2)
        .map(|line| line.iter().map(|(_, path)| path).collect::<Vec<_>>());
    let missing: Vec<Vec<&TokenStream>> = lines.collect();
    quote_spanned!(Span::mixed_site()=> #(#[derive(#(#missing),*)])*)
}
