//! The equality of generated structures.
//!
//! A derived comparison is one chain of `&&` over all fields. The compiler follows it by recursion, and ends without a
//! message where the chain has some thousand fields. So a structure of many fields compares a part of them at a time.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};

/// The largest number of fields in one chain.
const LONGEST: usize = 256;

/// The equality of a structure with a type parameter: derived, or implemented.
pub(super) struct Equality {
    /// The trait in a list of derives, with a comma before it.
    pub(super) derived: Option<TokenStream>,
    pub(super) implemented: TokenStream,
}

impl Equality {
    /// That of a structure with these fields. `parameter` is its type parameter.
    pub(super) fn of(name: &Ident, parameter: &Ident, fields: &[impl ToTokens]) -> Self {
        if fields.len() <= LONGEST {
            return Self {
                derived: Some(quote!(::core::cmp::PartialEq)),
                implemented: TokenStream::new(),
            };
        }
        let site = Span::mixed_site();
        let other = Ident::new("other", site);
        let parts = fields.chunks(LONGEST).map(|part| {
            quote_spanned! {site=>
                if !(#(self.#part == #other.#part)&&*) {
                    return false;
                }
            }
        });
        Self {
            derived: None,
            implemented: quote_spanned! {site=>
                impl<#parameter: ::core::cmp::PartialEq> ::core::cmp::PartialEq for #name<#parameter> {
                    fn eq(&self, #other: &Self) -> ::core::primitive::bool {
                        #(#parts)*
                        true
                    }
                }
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use quote::format_ident;

    use super::*;

    /// A few fields are compared by the derived trait, many in parts, none of them twice.
    #[test]
    fn many_fields_are_compared_in_parts() {
        let (name, parameter) = (format_ident!("Pose"), format_ident!("T"));
        let fields: Vec<Ident> = (0..=2 * LONGEST).map(|index| format_ident!("x{index}")).collect();
        let few = Equality::of(&name, &parameter, &fields[..LONGEST]);
        assert!(few.derived.is_some() && few.implemented.is_empty());
        let many = Equality::of(&name, &parameter, &fields);
        let text = many.implemented.to_string();
        assert!(many.derived.is_none());
        assert_eq!(text.matches("if !").count(), 3);
        let words: Vec<&str> = text.split(|letter: char| !letter.is_alphanumeric()).collect();
        for field in &fields {
            let name = field.to_string();
            assert_eq!(words.iter().filter(|word| **word == name).count(), 2, "{field}");
        }
    }
}
