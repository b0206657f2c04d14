//! The assemblies of a mechanism, and the assembly of a guess.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::values;
use crate::algebra::Symbol;
use crate::emit::compiled::{Compiled, attributes};
use crate::emit::items::internal::Internal;
use crate::emit::text::ProgramText;
use crate::program::Step;

/// The largest number of blocks with a choice for which a constant lists all assemblies.
const LISTED: usize = 6;

/// `solve_all` and `assembly_at`.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let (finder, all) = (finder(mechanism), all(mechanism));
    quote!(#all #finder)
}

/// `solve_all`: the motion in every assembly.
fn all(mechanism: &Compiled<'_>) -> TokenStream {
    let count = mechanism.choices().len();
    if count == 0 || count > LISTED || mechanism.is_coupled() {
        return TokenStream::new();
    }
    let runtime = mechanism.runtime;
    let pose = mechanism.pose(mechanism.order());
    let inputs = mechanism.input_names();
    let length = Literal::usize_unsuffixed(mechanism.order() + 1);
    let size = Literal::usize_unsuffixed(1 << count);
    let index = mechanism.fresh("index");
    let by_number = by_number(mechanism, &quote!(#index));
    quote! {
            /// `solve` in every assembly, in the order of `ASSEMBLIES`.
            #[must_use]
            pub fn solve_all(&self, #(#inputs: impl #runtime::IntoMotion<T, #length>),*)
                -> [::core::result::Result<#pose<T>, #runtime::SolveError>; #size]
            {
                #(let #inputs = #inputs.into_motion();)*
                ::core::array::from_fn(|#index| self.solve(#(#inputs,)* #by_number))
            }

    }
}

/// The structure of several choices.
pub(in crate::emit) fn structure(mechanism: &Compiled<'_>) -> TokenStream {
    if mechanism.choices().len() < 2 {
        return TokenStream::new();
    }
    let runtime = mechanism.runtime;
    let visibility = &mechanism.model.visibility;
    let attributes = attributes();
    let (name, fields) = (mechanism.assembly_structure(), mechanism.assembly_fields());
    let summary = format!(
        " An assembly of [`{}`]: one choice for each block that can be assembled in two ways.",
        mechanism.model.name
    );
    let documentation = mechanism
        .choices()
        .into_iter()
        .map(|part| mechanism.choice_documentation(part));
    let fields = fields.iter().zip(documentation).map(|(field, lines)| {
        quote! {
            #(#[doc = #lines])*
            pub #field: #runtime::Assembly
        }
    });
    quote! {
        #[doc = #summary]
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
        #[derive(::core::cmp::PartialEq, ::core::cmp::Eq, ::core::hash::Hash)]
        #attributes
        #visibility struct #name {
            #(#fields,)*
        }
    }
}

/// The methods of that structure, or those of a mechanism with a single position: one call, which kin-core answers.
pub(in crate::emit) fn methods(mechanism: &Compiled<'_>) -> TokenStream {
    let choices = mechanism.choices();
    let runtime = mechanism.runtime;
    if choices.is_empty() && !mechanism.is_coupled() {
        let (name, order) = (&mechanism.model.name, Literal::usize_unsuffixed(mechanism.order()));
        return quote!(#runtime::single_position! { #name #order });
    }
    if choices.len() < 2 {
        return TokenStream::new();
    }
    let name = mechanism.assembly_structure();
    let fields = mechanism.assembly_fields();
    let setters = fields
        .iter()
        .map(|field| format_ident!("with_{field}", span = field.span()));
    let unknowns = choices.into_iter().map(|part| mechanism.part_name(part));
    quote! {
        #runtime::choices! { #name { #(#fields #setters #unknowns)* } }
    }
}

/// An assembly from the choice of each block.
fn assembly(mechanism: &Compiled<'_>, choice: impl Fn(usize) -> TokenStream) -> TokenStream {
    let count = mechanism.choices().len();
    match count {
        0 => quote!(()),
        1 => choice(0),
        _ => {
            let (name, fields) = (mechanism.assembly_structure(), mechanism.assembly_fields());
            let choices = (0..count).map(choice);
            quote!(#name { #(#fields: #choices),* })
        }
    }
}

/// The assembly with an index, bit by bit. The choice of the first block changes slowest.
pub(in crate::emit) fn by_number(mechanism: &Compiled<'_>, index: &TokenStream) -> TokenStream {
    let runtime = mechanism.runtime;
    let count = mechanism.choices().len();
    assembly(mechanism, |position| {
        let shift = Literal::usize_unsuffixed(count - 1 - position);
        if count == 1 {
            quote!(#runtime::Assembly::BOTH[#index & 1])
        } else {
            quote!(#runtime::Assembly::BOTH[(#index >> #shift) & 1])
        }
    })
}

/// `ASSEMBLIES`.
pub(in crate::emit) fn list(mechanism: &Compiled<'_>) -> TokenStream {
    let count = mechanism.choices().len();
    if count > LISTED || mechanism.is_coupled() {
        return TokenStream::new();
    }
    let (runtime, kind) = (mechanism.runtime, mechanism.assembly_type());
    let size = Literal::usize_unsuffixed(1 << count);
    let all = (0..1_usize << count).map(|index| {
        assembly(mechanism, |position| {
            if (index >> (count - 1 - position)) & 1 == 0 {
                quote!(#runtime::Assembly::Open)
            } else {
                quote!(#runtime::Assembly::Crossed)
            }
        })
    });
    let all = if count == 1 {
        quote!(#runtime::Assembly::BOTH)
    } else {
        quote!([#(#all),*])
    };
    let summary = match count {
        0 => " The only assembly.".to_owned(),
        1 => " All assemblies.".to_owned(),
        _ => " All assemblies: every combination of the two assemblies of each block.".to_owned(),
    };
    quote! {
            #[doc = #summary]
            pub const ASSEMBLIES: [#kind; #size] = #all;

    }
}

/// `assembly_at`: the orientation of each block for given values of the unknowns.
fn finder(mechanism: &Compiled<'_>) -> TokenStream {
    if mechanism.choices().is_empty() {
        return TokenStream::new();
    }
    let kind = mechanism.assembly_type();
    let inputs = mechanism.input_names();
    let unknown_count = Literal::usize_unsuffixed(mechanism.model.unknowns.len());
    let near = mechanism.fresh("near");
    let summary = format!(
        " The assembly of a pose with unknowns near `[{}]`: the side of the singular positions on which they lie.",
        mechanism.unknown_order()
    );
    let body = if mechanism.is_coupled() {
        quote!(self.__side(#(#inputs,)* #near).0)
    } else {
        let BlockOrientations { way, result, .. } = BlockOrientations::new(mechanism);
        quote!(#way #result)
    };
    quote! {
            #[doc = #summary]
            #[must_use]
            pub fn assembly_at(&self, #(#inputs: T,)* #near: [T; #unknown_count]) -> #kind {
                #body
            }

    }
}

/// `__side`: the assembly and the guess of a mechanism with coupled blocks.
pub(in crate::emit) fn internal(mechanism: &Compiled<'_>) -> Option<Internal> {
    if mechanism.choices().is_empty() || !mechanism.is_coupled() {
        return None;
    }
    let runtime = mechanism.runtime;
    let kind = mechanism.assembly_type();
    let inputs = mechanism.input_names();
    let unknown_count = Literal::usize_unsuffixed(mechanism.model.unknowns.len());
    let near = mechanism.fresh("near");
    let BlockOrientations {
        way,
        orientations,
        result,
    } = BlockOrientations::new(mechanism);
    Some(Internal {
        attributes: quote! {
            /// The assembly and the guess. If several poses are solved at once, the guess becomes NaN for poses in
            /// another assembly than the first one.
            #[inline(always)]
        },
        signature: quote! {
            fn __side(&self, #(#inputs: T,)* #near: [T; #unknown_count]) -> (#kind, [T; #unknown_count])
        },
        body: quote! {
            #way
            (#result, #runtime::solve::agreeing(#near, [#(#orientations),*]))
        },
    })
}

/// The orientations of the blocks, from values of the unknowns.
struct BlockOrientations {
    /// The steps that find them.
    way: TokenStream,
    orientations: Vec<Ident>,
    /// The assembly.
    result: TokenStream,
}

impl BlockOrientations {
    fn new(mechanism: &Compiled<'_>) -> Self {
        let inputs = mechanism.input_names();
        let program = &mechanism.solvers.orientations;
        let (text, stage) = (ProgramText::of(mechanism, program), &program.stages[0]);
        let near = mechanism.fresh("near");
        let used: BTreeSet<Symbol> = stage.steps.iter().flat_map(Step::uses).collect();
        let symbols: Vec<Symbol> = (0..mechanism.model.unknowns.len()).map(Symbol::Unknown).collect();
        let unknowns = values::bound(&text, &used, &symbols, &quote!(#near));
        let given: Vec<Symbol> = (0..mechanism.model.inputs.len()).map(Symbol::Input).collect();
        let readings = text.readings(stage, &given);
        let unused_inputs = inputs
            .iter()
            .zip(&given)
            .filter(|(_, symbol)| !used.contains(symbol))
            .map(|(input, _)| input);
        let body = text.plain_steps(stage);
        // abbreviations may come between the definitions of the orientations
        let orientations: Vec<Ident> = mechanism
            .solvers
            .orientation_symbols
            .iter()
            .map(|&symbol| text.name(symbol))
            .collect();
        let signs: Vec<TokenStream> = orientations.iter().map(|name| quote!(T::side(#name))).collect();
        let result = if let [sign] = signs.as_slice() {
            sign.clone()
        } else {
            let (name, fields) = (mechanism.assembly_structure(), mechanism.assembly_fields());
            quote!(#name { #(#fields: #signs),* })
        };
        let way = quote! {
            #(let _ = #unused_inputs;)*
            #readings
            #unknowns
            #body
        };
        Self {
            way,
            orientations,
            result,
        }
    }
}
