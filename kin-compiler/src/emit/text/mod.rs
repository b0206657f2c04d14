//! A program as text. Symbols become names only here.

mod expression;
mod iterations;
mod statements;

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::compiled::{Compiled, local};
use crate::algebra::Symbol;
use crate::lower::{Extent, Lowering};
use crate::program::{Component, Expression, Names, Program, Stage, UnitPart, order_name};

/// Writes a program of a mechanism.
#[derive(Clone, Copy)]
pub(super) struct ProgramText<'a> {
    pub(super) mechanism: &'a Compiled<'a>,
    names: &'a Names,
    /// Whether the steps go through all positions, and not to a single one.
    goes_through_all: bool,
    /// The steps of the position that are written.
    extent: Extent<'a>,
}

impl<'a> ProgramText<'a> {
    /// The text of a program that leads to one position, or on from it.
    pub(super) fn of(mechanism: &'a Compiled<'a>, program: &'a Program<Expression>) -> Self {
        Self {
            mechanism,
            names: &program.names,
            goes_through_all: false,
            extent: Extent::All,
        }
    }

    /// The text of the program that goes through all positions.
    pub(super) fn of_every(mechanism: &'a Compiled<'a>, program: &'a Program<Expression>) -> Self {
        Self {
            goes_through_all: true,
            ..Self::of(mechanism, program)
        }
    }

    /// The text of a part of the position.
    pub(super) fn part(self, extent: Extent<'a>) -> Self {
        Self { extent, ..self }
    }

    /// The values of a position that need the parameters alone.
    pub(super) fn prepared(&self, position: &Stage<Expression>) -> BTreeSet<Symbol> {
        self.lowering().prepared(position)
    }

    fn lowering(&self) -> Lowering<'a> {
        let Compiled {
            model, blocks, solvers, ..
        } = *self.mechanism;
        Lowering {
            model,
            blocks,
            solvers,
            goes_through_all: self.goes_through_all,
            extent: self.extent,
        }
    }

    /// The name of a symbol.
    pub(super) fn name(&self, symbol: Symbol) -> Ident {
        local(self.names.of(symbol))
    }

    /// A value from the parameters.
    pub(super) fn component(&self, component: Component) -> TokenStream {
        match component {
            Component::Number(number) => {
                let number = Literal::f64_unsuffixed(number);
                quote!(T::constant(#number))
            }
            Component::Parameter(index) => self.mechanism.scalar_parameters()[index].1.clone(),
            Component::Value(symbol) => {
                let name = self.name(symbol);
                quote!(#name)
            }
        }
    }

    /// `let` for the values that a stage reads: values of earlier stages, positions and rates. `given` are arguments
    /// already.
    pub(super) fn readings(&self, stage: &Stage<Expression>, given: &[Symbol]) -> TokenStream {
        let is_scalar = |index: usize| self.mechanism.scalar_field(index).is_some();
        let carried = stage.uses.iter().map(|carried| {
            let name = self.name(carried.symbol);
            quote!(#name)
        });
        let parameters = stage.reads.iter().filter_map(|&symbol| match symbol {
            Symbol::Parameter(index) if !given.contains(&symbol) => {
                let (field, name) = (self.mechanism.scalar_field(index)?, self.name(symbol));
                Some(if *field == name {
                    quote!(#name)
                } else {
                    quote!(#field: #name)
                })
            }
            _ => None,
        });
        let fields: Vec<TokenStream> = carried.chain(parameters).collect();
        let others: Vec<Symbol> = stage
            .reads
            .iter()
            .filter(|symbol| !given.contains(symbol))
            .filter(|symbol| !matches!(symbol, Symbol::Parameter(index) if is_scalar(*index)))
            .copied()
            .collect();
        let others = self.values_read(&others, &quote!(self));
        if fields.is_empty() {
            return others;
        }
        quote! {
            let Self { #(#fields,)* .. } = *self;
            #others
        }
    }

    /// The same values, read from a pose that is not `self`. Parameters are read from `self`.
    pub(super) fn readings_from(&self, stage: &Stage<Expression>, pose: &TokenStream) -> TokenStream {
        let carried = stage.uses.iter().map(|carried| {
            let name = self.name(carried.symbol);
            quote!(let #name = #pose.#name;)
        });
        let values = self.values_read(&stage.reads, pose);
        quote!(#(#carried)* #values)
    }

    /// `let` for parameters, positions and rates.
    fn values_read(&self, symbols: &[Symbol], pose: &TokenStream) -> TokenStream {
        let parameters = self.mechanism.scalar_parameters();
        let values = symbols.iter().map(|&symbol| {
            let name = self.name(symbol);
            let value = match symbol {
                Symbol::Parameter(index) => parameters[index].1.clone(),
                _ => self.reading(symbol, pose),
            };
            quote!(let #name = #value;)
        });
        quote!(#(#values)*)
    }

    fn reading(&self, symbol: Symbol, pose: &TokenStream) -> TokenStream {
        let model = self.mechanism.model;
        let (name, order) = match symbol {
            Symbol::Input(index) => (&model.inputs[index].name, 0),
            Symbol::InputRate(index, order) => (&model.inputs[index].name, order),
            Symbol::Unknown(index) => return self.mechanism.unknown_value(index, pose),
            Symbol::UnknownRate(index, order) => (&model.unknowns[index].name, order),
            Symbol::Step(_) => {
                let meaning = self.mechanism.solvers.directions().meaning(symbol);
                let (unknown, part) = meaning.expect("a step that is read from a pose is a part of a unit vector");
                let name = &model.unknowns[unknown].name;
                let part = local(match part {
                    UnitPart::Cosine => "cosine",
                    UnitPart::Sine => "sine",
                });
                return quote!(#pose.#name.#part());
            }
            Symbol::Parameter(_)
            | Symbol::Turning(..)
            | Symbol::OutputRate(..)
            | Symbol::Sensitivity(..)
            | Symbol::OutputSensitivity(..)
            | Symbol::Value(_) => {
                unreachable!("parameters are read from the structure, the others are carried under their names")
            }
        };
        let accessor = local(&order_name(order));
        quote!(#pose.#name.#accessor())
    }
}
