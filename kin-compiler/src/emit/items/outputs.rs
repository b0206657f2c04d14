//! The outputs for any values of inputs and unknowns.

use proc_macro2::{Literal, Span, TokenStream};
use quote::quote_spanned;

use crate::emit::sheet::SheetText;
use crate::translate::tree::Sheet;

/// The method `outputs_at` of the trait of all mechanisms.
pub(in crate::emit) fn tokens(text: &SheetText<'_>, sheet: &Sheet) -> TokenStream {
    let (rows, bindings, outputs) = (text.rows(sheet), text.bindings(sheet), text.results(sheet));
    let counts = [text.model.inputs.len(), text.model.unknowns.len(), sheet.results.len()];
    let [inputs, unknowns, count] = counts.map(Literal::usize_unsuffixed);
    quote_spanned! {Span::mixed_site()=>
        fn outputs_at(&self, inputs: [T; #inputs], unknowns: [T; #unknowns]) -> [T; #count] {
            #rows
            #bindings
            [#(#outputs),*]
        }
    }
}
