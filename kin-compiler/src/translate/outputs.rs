//! The outputs for any values of inputs and unknowns.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote_spanned};

use super::formula::Translation;
use super::names::{bindings, names, rows, used_names};
use crate::model::Model;
use crate::syntax::{Declaration, OutputStatement, Statement};

/// The method `outputs_at` of the trait of all mechanisms.
pub(crate) fn tokens(declaration: &Declaration, model: &Model, runtime: &TokenStream) -> TokenStream {
    let outputs: Vec<&OutputStatement> = declaration
        .statements
        .iter()
        .filter_map(|statement| match statement {
            Statement::Output(output) => Some(output),
            _ => None,
        })
        .collect();
    let used = used_names(declaration, outputs.iter().map(|output| &output.value));
    let mut names = names(model);
    let mut body = rows(model, &used);
    body.extend(bindings(declaration, runtime, &used, &mut names));
    let translation = Translation { names: &names, runtime };
    let site = Span::mixed_site();
    let mut values: Vec<TokenStream> = Vec::new();
    for (number, output) in outputs.iter().enumerate() {
        let value = translation.formula(&output.value);
        let shape = output.dimension.shape();
        let tokens = translation.lifted(value, shape).tokens;
        let axes = shape.axes();
        if axes.is_empty() {
            values.push(tokens);
            continue;
        }
        let local = format_ident!("output_{number}", span = site);
        body.extend(quote_spanned!(site=> let #local = #tokens;));
        for axis in axes {
            let part = Ident::new(&axis.to_string(), site);
            values.push(quote_spanned!(site=> #local.#part));
        }
    }
    let [inputs, unknowns, count] =
        [model.inputs.len(), model.unknowns.len(), values.len()].map(Literal::usize_unsuffixed);
    quote_spanned! {site=>
        fn outputs_at(&self, inputs: [T; #inputs], unknowns: [T; #unknowns]) -> [T; #count] {
            #body
            [#(#values),*]
        }
    }
}
