//! The transmission angles of all dyads, on request.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::{Mechanism, attributes, formula, local, values};
use crate::assemble::{Program, Stage, Step, transmission};
use crate::expr::Symbol;
use crate::schedule::{ScheduledStage, Statement, Style, schedule};

/// The method `transmission_angles`.
pub(super) fn tokens(mechanism: &Mechanism<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let (dyads, stage) = program(mechanism);
    let used: BTreeSet<String> = stage.statements.iter().flat_map(Statement::uses).collect();
    let (pose, argument) = values::argument(mechanism);
    let inputs: Vec<Symbol> = (0..model.inputs.len()).map(Symbol::Input).collect();
    let unknowns: Vec<Symbol> = (0..model.unknowns.len()).map(Symbol::Unknown).collect();
    let readings = mechanism.readings(&stage, &[inputs.as_slice(), unknowns.as_slice()].concat());
    let inputs = values(mechanism, &used, &inputs, &quote!(#pose.input_values()));
    let unknowns = values(mechanism, &used, &unknowns, &quote!(#pose.unknown_values()));
    let body = stage.statements.iter().map(|statement| match statement {
        Statement::Let { name, value } => {
            let (name, value) = (local(name), formula::tokens(value));
            quote!(let #name = #value;)
        }
        other => mechanism.plain_statements(&ScheduledStage {
            statements: vec![other.clone()],
            ..Default::default()
        }),
    });
    let angles = dyads.iter().map(|dyad| {
        let [across, along] = dyad.components.each_ref().map(|name| local(name));
        let block = mechanism.part_name(dyad.part);
        quote!(#runtime::TransmissionAngle::of(#block, #across, #along))
    });
    let lines = dyads.iter().enumerate().map(|(place, dyad)| {
        format!(
            " - `[{place}]`: `{}`, {}",
            mechanism.part_name(dyad.part),
            mechanism.solution_of_part(mechanism.parts()[dyad.part])
        )
    });
    let count = Literal::usize_unsuffixed(dyads.len());
    let (name, attributes) = (&model.name, attributes());
    quote! {
        #attributes
        impl<T: #runtime::Scalar> #name<T> {
            /// The transmission angle of every dyad, in a pose of any order.
            ///
            #(#[doc = #lines])*
            #[must_use]
            pub fn transmission_angles(&self, #argument) -> [#runtime::TransmissionAngle<T>; #count] {
                #inputs
                #unknowns
                #readings
                #(#body)*
                [#(#angles),*]
            }
        }
    }
}

/// A dyad, and what the sine and cosine of its angle are called.
struct Dyad {
    part: usize,
    components: [String; 2],
}

/// All dyads, and the straight-line program of their angles.
fn program(mechanism: &Mechanism<'_>) -> (Vec<Dyad>, ScheduledStage) {
    let mut graph = mechanism.graph.clone();
    let mut names = mechanism.plan.names.clone();
    let (mut dyads, mut steps) = (Vec::new(), Vec::new());
    for (part, solved) in mechanism.parts().into_iter().enumerate() {
        let Some(angle) = transmission(&mut graph, solved) else {
            continue;
        };
        let number = dyads.len() + 1;
        let components = [("across", angle.across), ("along", angle.along)].map(|(wish, node)| {
            let (symbol, _) = graph.new_step();
            names.name(symbol, &format!("{wish}_{number}"));
            steps.push(Step::Define { symbol, node });
            names.of(symbol).to_owned()
        });
        dyads.push(Dyad { part, components });
    }
    let program = Program {
        stages: vec![Stage { steps }],
        names,
    };
    let style = Style {
        factor_out: false,
        check_domains: false,
    };
    let stage = schedule(&graph, &program, &[], style).stages.swap_remove(0);
    (dyads, stage)
}

/// Those of the pose's values that are used, by their own names.
fn values(mechanism: &Mechanism<'_>, used: &BTreeSet<String>, symbols: &[Symbol], all: &TokenStream) -> TokenStream {
    let row = local("values");
    let values: Vec<TokenStream> = symbols
        .iter()
        .enumerate()
        .map(|(index, &symbol)| (index, mechanism.plan.names.of(symbol)))
        .filter(|(_, name)| used.contains(*name))
        .map(|(index, name)| {
            let (name, index) = (local(name), Literal::usize_unsuffixed(index));
            quote!(let #name = #row[#index];)
        })
        .collect();
    if values.is_empty() {
        return TokenStream::new();
    }
    quote!(let #row = #all; #(#values)*)
}
