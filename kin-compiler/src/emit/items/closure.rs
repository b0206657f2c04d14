//! The closure as trigonometric polynomials, with its coefficients, for mechanisms with coupled blocks.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::algebra::{Angle, Harmonic, Symbol};
use crate::emit::compiled::{Compiled, local};
use crate::emit::text::ProgramText;
use crate::program::ClosureTerms;
use crate::structure::ClosureMonomial;

/// The method `closure_terms` of the trait.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let Some(ClosureTerms {
        terms,
        coefficients,
        program,
    }) = &mechanism.solvers.closure
    else {
        return TokenStream::new();
    };
    let runtime = mechanism.runtime;
    let (text, stage) = (ProgramText::of(mechanism, program), &program.stages[0]);
    let (readings, body) = (text.readings(stage, &[]), text.plain_steps(stage));
    let [table, found] = ["TERMS", "found"].map(local);
    let terms = terms.iter().map(|term| written(mechanism, term));
    let coefficients = coefficients.iter().map(|&coefficient| text.component(coefficient));
    quote! {
        fn closure_terms(&self, #found: impl ::core::ops::FnOnce(&'static [#runtime::ClosureTerm], &[T])) {
            const #table: &[#runtime::ClosureTerm] = &[#(#terms),*];
            #readings
            #body
            #found(#table, &[#(#coefficients),*]);
        }
    }
}

fn written(mechanism: &Compiled<'_>, term: &ClosureMonomial) -> TokenStream {
    let runtime = mechanism.runtime;
    let argument = |symbol: Symbol| {
        Literal::usize_unsuffixed(match symbol {
            Symbol::Input(index) => index,
            Symbol::Unknown(index) => mechanism.model.inputs.len() + index,
            _ => unreachable!("only inputs and unknowns move"),
        })
    };
    let [equation, coefficient] = [term.equation, term.coefficient].map(Literal::u16_unsuffixed);
    let factor = Literal::f64_unsuffixed(term.factor.abs());
    let sign = (term.factor < 0.0).then(|| quote!(-));
    let powers = term.powers.iter().map(|&(symbol, power)| {
        let (argument, power) = (argument(symbol), Literal::u8_unsuffixed(power));
        quote!((#argument, #power))
    });
    let angle = |angle: &Angle| {
        let multiples = angle.0.iter().map(|&(symbol, multiple)| {
            let (argument, size) = (argument(symbol), Literal::i32_unsuffixed(multiple.abs()));
            let sign = (multiple < 0).then(|| quote!(-));
            quote!((#argument, #sign #size))
        });
        quote!(, &[#(#multiples),*])
    };
    let (kind, angle) = match &term.harmonic {
        Harmonic::One => ("__one", None),
        Harmonic::Cosine(combination) => ("__cosine", Some(angle(combination))),
        Harmonic::Sine(combination) => ("__sine", Some(angle(combination))),
    };
    let kind = local(kind);
    quote! {
        #runtime::ClosureTerm::#kind(#equation, #sign #factor, #coefficient, &[#(#powers),*] #angle)
    }
}
