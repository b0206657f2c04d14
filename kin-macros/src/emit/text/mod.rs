//! A program as text: the only place where symbols become names.

mod doubt;
mod failures;
mod formula;
mod iterations;
mod steps;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::mechanism::{Mechanism, local};
use crate::algebra::Symbol;
use crate::program::{Expression, Names, Program, Stage, UnitPart, order_name};

/// Writes a program of a mechanism.
#[derive(Clone, Copy)]
pub(super) struct Text<'a> {
    pub(super) mechanism: &'a Mechanism<'a>,
    names: &'a Names,
    /// Whether the steps go through all positions, and not to one of them.
    goes_through_all: bool,
}

impl<'a> Text<'a> {
    /// Writes a program that goes to one position, or on from it.
    pub(super) fn of(mechanism: &'a Mechanism<'a>, program: &'a Program<Expression>) -> Self {
        Self {
            mechanism,
            names: &program.names,
            goes_through_all: false,
        }
    }

    /// Writes the program that goes through all positions.
    pub(super) fn of_every(mechanism: &'a Mechanism<'a>, program: &'a Program<Expression>) -> Self {
        Self {
            goes_through_all: true,
            ..Self::of(mechanism, program)
        }
    }

    /// The name of a symbol.
    pub(super) fn name(&self, symbol: Symbol) -> Ident {
        local(self.names.of(symbol))
    }

    /// `let` for the values of earlier stages, positions and rates that a stage reads; `given` are arguments already.
    pub(super) fn readings(&self, stage: &Stage<Expression>, given: &[Symbol]) -> TokenStream {
        self.readings_from(stage, given, &quote!(self))
    }

    /// The same from a pose that is not `self`.
    pub(super) fn readings_from(&self, stage: &Stage<Expression>, given: &[Symbol], pose: &TokenStream) -> TokenStream {
        let carried = stage.uses.iter().map(|carried| {
            let name = self.name(carried.symbol);
            quote!(let #name = #pose.#name;)
        });
        let parameters = self.mechanism.scalar_parameters();
        let symbols = stage
            .reads
            .iter()
            .filter(|symbol| !given.contains(symbol))
            .map(|&symbol| {
                let name = self.name(symbol);
                let value = match symbol {
                    Symbol::Parameter(index) => parameters[index].1.clone(),
                    _ => self.reading(symbol, pose),
                };
                quote!(let #name = #value;)
            });
        quote!(#(#carried)* #(#symbols)*)
    }

    fn reading(&self, symbol: Symbol, pose: &TokenStream) -> TokenStream {
        let model = self.mechanism.model;
        let (name, order) = match symbol {
            Symbol::Input(index) => (&model.inputs[index].name, 0),
            Symbol::InputRate(index, order) => (&model.inputs[index].name, order),
            Symbol::Unknown(index) => (&model.unknowns[index].name, 0),
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
