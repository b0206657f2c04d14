//! Newton's method, and the steps through all solutions of a block.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::ProgramText;
use crate::algebra::Symbol;
use crate::emit::compiled::local;
use crate::lower::Statement;
use crate::structure::{PolynomialTerm, SystemForm};

impl ProgramText<'_> {
    /// Newton's method, started from the guess.
    pub(super) fn newton(&self, statement: &Statement) -> TokenStream {
        let Statement::Newton {
            unknowns,
            are_lengths,
            lengths,
            body,
            residuals,
            jacobian,
            label,
        } = statement
        else {
            return TokenStream::new();
        };
        let runtime = self.mechanism.runtime;
        let near = self.mechanism.fresh("near");
        let names: Vec<_> = unknowns
            .iter()
            .map(|&unknown| self.name(Symbol::Unknown(unknown)))
            .collect();
        let guesses = unknowns.iter().map(|&unknown| {
            let index = Literal::usize_unsuffixed(unknown);
            quote!(#near[#index])
        });
        let size = self.mechanism.fresh("size");
        let sizes = are_lengths.iter().map(|is_length| {
            if *is_length {
                quote!(#size)
            } else {
                quote!(T::constant(1.0))
            }
        });
        let largest = are_lengths.contains(&true).then(|| {
            let lengths = self.lengths(lengths);
            quote!(let #size = #runtime::solve::largest([#(#lengths),*]);)
        });
        let count = Literal::usize_unsuffixed(unknowns.len());
        let body = body.iter().map(|statement| self.statement(statement));
        let residuals = self.values(residuals);
        let jacobian = jacobian.iter().map(|row| {
            let row = self.values(row);
            quote!([#(#row),*])
        });
        let failed = self.failed(label);
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

    /// Parameters and inputs, as they were given.
    fn lengths(&self, lengths: &[Symbol]) -> Vec<TokenStream> {
        let parameters = self.mechanism.scalar_parameters();
        let length = |symbol: &Symbol| match *symbol {
            Symbol::Parameter(index) => parameters[index].1.clone(),
            Symbol::Input(index) => {
                let name = local(&self.mechanism.model.inputs[index].name.to_string());
                quote!(#name)
            }
            _ => unreachable!("lengths of a mechanism are parameters and inputs"),
        };
        lengths.iter().map(length).collect()
    }

    /// The next solution of a block's equations.
    pub(super) fn every_solution(&self, statement: &Statement) -> TokenStream {
        let Statement::Every {
            block,
            form,
            paths,
            coefficients,
            results,
            label,
        } = statement
        else {
            return TokenStream::new();
        };
        let runtime = self.mechanism.runtime;
        let way = self.mechanism.fresh("choices");
        let system = local(&format!("SYSTEM_{}", block + 1));
        let (size, paths) = (
            Literal::usize_unsuffixed(results.len()),
            Literal::usize_unsuffixed(*paths),
        );
        let (kind, value) = match form {
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
        let coefficients = self.values(coefficients);
        let failed = self.failed(label);
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
