//! The values of a position that need the parameters alone, which are calculated once for many poses.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::{format_ident, quote};

use crate::algebra::Symbol;
use crate::emit::compiled::{Compiled, attributes};
use crate::emit::items::internal::Internal;
use crate::emit::text::ProgramText;
use crate::lower::Extent;
use crate::program::{Expression, Stage};

/// The prepared values of a mechanism, and what is left of its position.
pub(in crate::emit) struct PreparedValues<'a> {
    mechanism: &'a Compiled<'a>,
    /// `RssrPrepared`.
    name: Ident,
    symbols: BTreeSet<Symbol>,
    /// Those of the symbols that the rest of the position reads.
    kept: Vec<Ident>,
    /// What the rest of the position reads and hands on.
    pub(in crate::emit) further: Stage<Expression>,
    /// The rest of the position.
    pub(in crate::emit) body: TokenStream,
}

impl<'a> PreparedValues<'a> {
    /// Those of a mechanism, if there are any.
    pub(in crate::emit) fn of(mechanism: &'a Compiled<'a>) -> Option<Self> {
        let stage = &mechanism.solvers.orders()[0];
        let text = ProgramText::of(mechanism, &mechanism.solvers.motion);
        let symbols = text.prepared(stage);
        if symbols.is_empty() {
            return None;
        }
        let body = text.part(Extent::Further(&symbols)).position_steps(stage);
        let words = words(body.clone());
        let further = reading(mechanism, stage, &words);
        let is_carried = |symbol| stage.carries.iter().any(|carried| carried.symbol == symbol);
        let kept = symbols.iter().filter_map(|&symbol| {
            let name = mechanism.name_of(symbol);
            (is_carried(symbol) || words.contains(&name.to_string())).then_some(name)
        });
        Some(Self {
            kept: kept.collect(),
            mechanism,
            name: format_ident!("{}Prepared", mechanism.model.name),
            symbols,
            further,
            body,
        })
    }

    /// The type of the prepared values.
    pub(in crate::emit) fn kind(&self) -> TokenStream {
        let (runtime, name) = (self.mechanism.runtime, &self.name);
        quote!(#runtime::Preparation<#name<T>>)
    }

    /// The structure of the prepared values.
    pub(in crate::emit) fn structure(&self) -> TokenStream {
        let Self { name, kept, .. } = self;
        let attributes = attributes();
        quote! {
            #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
            #attributes
            pub struct #name<T> {
                #(#kept: T,)*
            }
        }
    }

    /// `__prepared`, which finds the values.
    pub(in crate::emit) fn internal(&self) -> Internal {
        let Self { name, kept, .. } = self;
        let mechanism = self.mechanism;
        let stage = &mechanism.solvers.orders()[0];
        let text = ProgramText::of(mechanism, &mechanism.solvers.motion);
        let body = text.part(Extent::Prepared(&self.symbols)).position_steps(stage);
        let readings = text.readings(&reading(mechanism, stage, &words(body.clone())), &[]);
        let kind = self.kind();
        Internal {
            attributes: quote! {
                /// The values of a position that need the parameters alone.
                #[inline(always)]
            },
            signature: quote!(fn __prepared(&self) -> #kind),
            body: quote! {
                #readings
                #body
                ::core::result::Result::Ok(#name { #(#kept),* })
            },
        }
    }

    /// `let` for the values that the rest of the position reads.
    pub(in crate::emit) fn readings(&self) -> TokenStream {
        let Self { name, kept, .. } = self;
        let mechanism = self.mechanism;
        let [prepared, failure, block] = ["prepared", "failure", "block"].map(|name| mechanism.fresh(name));
        let inputs = mechanism.input_names();
        quote! {
            let #name { #(#kept),* } =
                #prepared.map_err(|(#failure, #block)| self.__failed(#failure, #block, #(#inputs),*))?;
        }
    }
}

/// What a part of the position reads and hands on. It reads the symbols whose names are among its words.
fn reading(mechanism: &Compiled<'_>, position: &Stage<Expression>, words: &BTreeSet<String>) -> Stage<Expression> {
    let is_read = |symbol: &&Symbol| words.contains(&mechanism.name_of(**symbol).to_string());
    Stage {
        reads: position.reads.iter().filter(is_read).copied().collect(),
        carries: position.carries.clone(),
        ..Stage::new(Vec::new())
    }
}

/// The words of a text.
fn words(text: TokenStream) -> BTreeSet<String> {
    let mut words = BTreeSet::new();
    for token in text {
        match token {
            TokenTree::Group(group) => words.extend(self::words(group.stream())),
            TokenTree::Ident(word) => {
                words.insert(word.to_string());
            }
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
    words
}
