//! The transmission angles of all dyads, on request.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::{Mechanism, attributes, local, values};
use crate::assemble::{Directions, Dyad, Names, Program, Stage, Step, dyads};
use crate::expr::{Graph, Node, Symbol};
use crate::passes::Passes;
use crate::room::with_room;
use crate::schedule::{Factors, ScheduledStage, Statement, Style, schedule};
use crate::structure::Block;

/// The method `transmission_angles`.
pub(super) fn tokens(mechanism: &Mechanism<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let residuals: Vec<Node> = model
        .equations
        .iter()
        .flat_map(|equation| equation.residual.nodes())
        .collect();
    let (graph, names, blocks) = (mechanism.graph, &mechanism.plan.names, mechanism.blocks);
    let (dyads, stage) = with_room(|| program(graph, names, blocks, &residuals));
    let used: BTreeSet<String> = stage.statements.iter().flat_map(Statement::uses).collect();
    let (pose, argument) = values::argument(mechanism);
    let inputs: Vec<Symbol> = (0..model.inputs.len()).map(Symbol::Input).collect();
    let unknowns: Vec<Symbol> = (0..model.unknowns.len()).map(Symbol::Unknown).collect();
    let readings = mechanism.readings(&stage, &[inputs.as_slice(), unknowns.as_slice()].concat());
    let inputs = values(mechanism, &used, &inputs, &quote!(#pose.input_values()));
    let unknowns = values(mechanism, &used, &unknowns, &quote!(#pose.unknown_values()));
    let body = mechanism.plain_statements(&stage);
    let angles = dyads.iter().map(|(dyad, parts)| {
        let [across, along] = parts.each_ref().map(|name| local(name));
        let label = label(mechanism, dyad);
        quote!(#runtime::TransmissionAngle::of(#label, #across, #along))
    });
    let lines = dyads.iter().enumerate().map(|(place, (dyad, _))| {
        format!(
            " - `[{place}]`: `{}`, {}",
            label(mechanism, dyad),
            dyad.kind.description()
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
                #body
                [#(#angles),*]
            }
        }
    }
}

/// All dyads, the straight-line program of their angles, and what their sines and cosines are called in it.
fn program(
    graph: &Graph,
    names: &Names,
    blocks: &[Block],
    residuals: &[Node],
) -> (Vec<(Dyad, [String; 2])>, ScheduledStage) {
    let (mut graph, mut names) = (graph.clone(), names.clone());
    let mut steps = Vec::new();
    let dyads = dyads(&mut graph, residuals, blocks)
        .into_iter()
        .zip(1..)
        .map(|(dyad, number)| {
            let parts = [("across", dyad.across), ("along", dyad.along)].map(|(wish, node)| {
                let (symbol, _) = graph.new_step();
                names.name(symbol, &format!("{wish}_{number}"));
                steps.push(Step::Define { symbol, node });
                names.of(symbol).to_owned()
            });
            (dyad, parts)
        })
        .collect();
    let program = Program {
        stages: vec![Stage { steps }],
        names,
        directions: Directions::default(),
        has_sensitivities: false,
    };
    let style = Style {
        factors: Factors::Left,
        check_domains: false,
        passes: Passes::ALL,
    };
    let stage = schedule(&graph, &program, &[], style).stages.swap_remove(0);
    (dyads, stage)
}

/// The unknowns of a dyad, separated by commas.
fn label(mechanism: &Mechanism<'_>, dyad: &Dyad) -> String {
    let names: Vec<String> = dyad
        .unknowns
        .iter()
        .map(|&unknown| mechanism.model.unknowns[unknown].name.to_string())
        .collect();
    names.join(", ")
}

/// Those of the pose's values that are used, by their own names.
fn values(mechanism: &Mechanism<'_>, used: &BTreeSet<String>, symbols: &[Symbol], all: &TokenStream) -> TokenStream {
    let row = mechanism.own("values");
    let values = values::bound(mechanism, used, symbols, &row);
    if values.is_empty() {
        return TokenStream::new();
    }
    quote!(let #row = #all; #(#values)*)
}
