//! The names of a declaration in a translated method.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Span, TokenStream};
use quote::{quote, quote_spanned};

use super::formula::{Translated, Translation};
use crate::model::Model;
use crate::syntax::{Declaration, Statement, TypedFormula};

/// Binds the used abbreviations to local names, and adds them to the names.
pub(super) fn bindings(
    declaration: &Declaration,
    runtime: &TokenStream,
    used: &BTreeSet<String>,
    names: &mut BTreeMap<String, Translated>,
) -> TokenStream {
    let site = Span::mixed_site();
    let mut body = TokenStream::new();
    for statement in &declaration.statements {
        if let Statement::Let(statement) = statement
            && used.contains(&statement.name.to_string())
        {
            let value = Translation { names, runtime }.formula(&statement.value);
            let (name, tokens) = (&statement.name, &value.tokens);
            body.extend(quote_spanned!(site=> let #name = #tokens;));
            names.insert(statement.name.to_string(), Translated::new(value.shape, quote!(#name)));
        }
    }
    body
}

/// A pattern of names, without the unused ones.
pub(super) fn pattern<'a>(names: impl Iterator<Item = &'a Ident>, used: &BTreeSet<String>) -> TokenStream {
    let names = names.map(|name| {
        if used.contains(&name.to_string()) {
            quote!(#name)
        } else {
            quote!(_)
        }
    });
    quote_spanned!(Span::mixed_site()=> [#(#names),*])
}

/// The translations of the declared names. Abbreviations are added when they are bound.
pub(super) fn names(model: &Model) -> BTreeMap<String, Translated> {
    let site = Span::mixed_site();
    let mut names = BTreeMap::new();
    for parameter in &model.parameters {
        let name = &parameter.name;
        let tokens = quote_spanned!(site=> self.#name);
        names.insert(name.to_string(), Translated::new(parameter.dimension.shape(), tokens));
    }
    for input in &model.inputs {
        let name = &input.name;
        names.insert(name.to_string(), Translated::scalar(quote!(#name)));
    }
    for unknown in &model.unknowns {
        let name = &unknown.name;
        names.insert(unknown.name.to_string(), Translated::scalar(quote!(#name)));
    }
    names
}

/// The names that formulas use, directly or through abbreviations.
pub(super) fn used_names<'a>(
    declaration: &'a Declaration,
    formulas: impl Iterator<Item = &'a TypedFormula>,
) -> BTreeSet<String> {
    let mut used = BTreeSet::new();
    for formula in formulas {
        formula.visit_names(&mut |name| {
            used.insert(name.to_string());
        });
    }
    behind_abbreviations(declaration, used)
}

/// Some names, and those that are used by way of abbreviations among them.
pub(super) fn behind_abbreviations(declaration: &Declaration, mut used: BTreeSet<String>) -> BTreeSet<String> {
    // an abbreviation comes after those that it uses
    for statement in declaration.statements.iter().rev() {
        if let Statement::Let(statement) = statement
            && used.contains(&statement.name.to_string())
        {
            statement.value.visit_names(&mut |name| {
                used.insert(name.to_string());
            });
        }
    }
    used
}

/// `let` for the inputs and unknowns that are used.
pub(super) fn rows(model: &Model, used: &BTreeSet<String>) -> TokenStream {
    let inputs: Vec<&Ident> = model.inputs.iter().map(|input| &input.name).collect();
    let unknowns: Vec<&Ident> = model.unknowns.iter().map(|unknown| &unknown.name).collect();
    let mut body = TokenStream::new();
    for (names, row) in [(inputs, "inputs"), (unknowns, "unknowns")] {
        let row = Ident::new(row, Span::mixed_site());
        if names.iter().any(|name| used.contains(&name.to_string())) {
            let pattern = pattern(names.into_iter(), used);
            body.extend(quote!(let #pattern = #row;));
        } else {
            body.extend(quote!(let _ = #row;));
        }
    }
    body
}
