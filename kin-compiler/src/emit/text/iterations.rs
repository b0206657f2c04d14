//! Newton's method, and the steps through all solutions of a block.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::ProgramText;
use crate::algebra::Symbol;
use crate::emit::compiled::local;
use crate::model::Dimension;
use crate::program::{Expression, Step};
use crate::structure::{PolynomialTerm, SystemForm};

impl ProgramText<'_> {
    /// Newton's method, started from the guess.
    pub(super) fn newton(
        &self,
        part: usize,
        unknowns: &[usize],
        body: &[Step<Expression>],
        residuals: &[Expression],
        jacobian: &[Vec<Expression>],
    ) -> TokenStream {
        let (runtime, model) = (self.mechanism.runtime, self.mechanism.model);
        let near = self.mechanism.own("near");
        let names: Vec<_> = unknowns
            .iter()
            .map(|&unknown| self.name(Symbol::Unknown(unknown)))
            .collect();
        let guesses = unknowns.iter().map(|&unknown| {
            let place = Literal::usize_unsuffixed(unknown);
            quote!(#near[#place])
        });
        let is_length = |unknown: &usize| model.unknowns[*unknown].dimension == Dimension::Length;
        let size = self.mechanism.own("size");
        let sizes = unknowns.iter().map(|unknown| {
            if is_length(unknown) {
                quote!(#size)
            } else {
                quote!(T::constant(1.0))
            }
        });
        let largest = unknowns.iter().any(is_length).then(|| {
            let lengths = self.lengths();
            quote!(let #size = #runtime::solve::largest([#(#lengths),*]);)
        });
        let count = Literal::usize_unsuffixed(unknowns.len());
        let body: Vec<&Step<Expression>> = body.iter().collect();
        let body = body.iter().map(|step| self.step(step, Some(part), &body));
        let residuals = self.expressions(residuals);
        let jacobian = jacobian.iter().map(|row| {
            let row = self.expressions(row);
            quote!([#(#row),*])
        });
        let failed = self.mechanism.failed(part);
        quote! {
            #largest
            let [#(#names),*] = #runtime::solve::newton(
                [#(#guesses),*],
                [#(#sizes),*],
                |[#(#names),*]: [T; #count]| {
                    #(#body)*
                    ([#(#residuals),*], [#(#jacobian),*])
                },
            ) #failed;
        }
    }

    /// The parameters and inputs that are lengths.
    fn lengths(&self) -> Vec<TokenStream> {
        let parameters = self
            .mechanism
            .scalar_parameters()
            .into_iter()
            .filter(|(_, _, dimension, _)| *dimension == Dimension::Length)
            .map(|(_, value, ..)| value);
        let inputs = self
            .mechanism
            .model
            .inputs
            .iter()
            .filter(|input| input.dimension == Dimension::Length)
            .map(|input| {
                let name = local(&input.name.to_string());
                quote!(#name)
            });
        parameters.chain(inputs).collect()
    }

    /// The next solution of a block's equations.
    pub(super) fn every_solution(
        &self,
        block: usize,
        part: usize,
        coefficients: &[Expression],
        results: &[Symbol],
    ) -> TokenStream {
        let Some(all) = &self.mechanism.blocks[block].all else {
            return TokenStream::new();
        };
        let runtime = self.mechanism.runtime;
        let way = self.mechanism.own("choices");
        let system = local(&format!("SYSTEM_{}", block + 1));
        let (size, paths) = (
            Literal::usize_unsuffixed(results.len()),
            Literal::usize_unsuffixed(all.paths),
        );
        let (kind, value) = match &all.form {
            SystemForm::Terms(terms) => {
                let terms = table(runtime, terms);
                (
                    quote!(PolynomialSystem<#size>),
                    quote!(PolynomialSystem::new(&[#(#terms),*])),
                )
            }
            SystemForm::Body { axes } => {
                let axes = axes.map(Literal::usize_unsuffixed);
                (quote!(BodySystem), quote!(BodySystem::new([#(#axes),*])))
            }
        };
        let results = results.iter().map(|&symbol| self.name(symbol));
        let coefficients = self.expressions(coefficients);
        let failed = self.mechanism.failed(part);
        quote! {
            const #system: #runtime::continuation::#kind = #runtime::continuation::#value;
            let [#(#results),*] = #way.solution::<#size, #paths>(&#system, &[#(#coefficients),*]) #failed;
        }
    }
}

fn table<'a>(runtime: &'a TokenStream, terms: &'a [PolynomialTerm]) -> impl Iterator<Item = TokenStream> + 'a {
    terms.iter().map(move |term| {
        let (equation, coefficient) = (
            Literal::usize_unsuffixed(term.equation),
            Literal::usize_unsuffixed(term.coefficient),
        );
        let powers = term.powers.iter().map(|&(variable, power)| {
            let (variable, power) = (Literal::usize_unsuffixed(variable), Literal::u32_unsuffixed(power));
            quote!((#variable, #power))
        });
        quote! {
            #runtime::continuation::Term::new(#equation, #coefficient, &[#(#powers),*])
        }
    })
}
