//! From the programs of a mechanism to the mechanism as data.

use super::{
    Closure, ClosureTerm, EveryPosition, Extent, Form, Lowering, Mechanism, Routine, UnitVector, most_positions,
};
use crate::algebra::{Angle, Harmonic, Symbol};
use crate::describe;
use crate::model::{Dimension, Model};
use crate::program::{Solvers, UnitPart};
use crate::structure::{Block, ClosureMonomial, PolynomialSystem};

/// The mechanism as data.
pub(crate) fn mechanism(model: &Model, blocks: &[Block], solvers: &Solvers) -> Mechanism {
    let lowering = Lowering {
        model,
        blocks,
        solvers,
        goes_through_all: false,
        extent: Extent::All,
    };
    let unknowns = model.unknowns.iter().enumerate();
    let is_angle = |dimension| matches!(dimension, Dimension::Angle | Dimension::Direction);
    let mut telltales: Vec<(usize, usize)> = solvers.telltales.iter().copied().collect();
    telltales.sort_by_key(|&(unknown, order)| (order, unknown));
    let (position, rates) = (&solvers.orders()[0], &solvers.orders()[1..]);
    let prepared = lowering.prepared(position);
    Mechanism {
        description: describe::description(model, blocks, solvers),
        outputs: model
            .outputs
            .iter()
            .map(|output| (output.name.to_string(), output.value.nodes().len()))
            .collect(),
        directions: (0..model.unknowns.len())
            .map(|unknown| unit_vector(solvers, unknown))
            .collect(),
        angles: unknowns
            .filter(|(_, unknown)| is_angle(unknown.dimension))
            .map(|(index, _)| index)
            .collect(),
        choices: describe::choice_names(model, blocks, solvers),
        is_coupled: blocks.iter().any(Block::is_coupled),
        position: [Extent::Prepared(&prepared), Extent::Further(&prepared)]
            .into_iter()
            .flat_map(|extent| Lowering { extent, ..lowering }.position(position))
            .collect(),
        rates: rates.iter().map(|stage| lowering.plain(stage)).collect(),
        telltales,
        sensitivities: solvers.sensitivities().map(|stage| lowering.plain(stage)),
        orientations: Routine {
            statements: lowering.plain(&solvers.orientations.stages[0]),
            results: solvers.orientation_symbols.clone(),
        },
        every: most_positions(blocks, solvers)
            .zip(solvers.every.as_ref())
            .map(|(paths, program)| {
                let lowering = Lowering {
                    goes_through_all: true,
                    ..lowering
                };
                let systems = blocks.iter().filter_map(|block| block.all.as_ref());
                EveryPosition {
                    statements: lowering.position(&program.stages[0]),
                    paths,
                    room: systems.map(PolynomialSystem::room).sum(),
                }
            }),
        transmission: Routine {
            statements: lowering.plain(&solvers.transmission.program.stages[0]),
            results: solvers
                .transmission
                .dyads
                .iter()
                .flat_map(|(_, parts)| *parts)
                .collect(),
        },
        dyads: solvers
            .transmission
            .dyads
            .iter()
            .map(|(dyad, _)| dyad.unknowns.clone())
            .collect(),
        lengths: lowering.plain(&solvers.lengths.program.stages[0]),
        forms: solvers
            .lengths
            .forms
            .iter()
            .map(|form| Form {
                kind: form.kind,
                driver: form.driver,
                lengths: form.lengths.clone(),
            })
            .collect(),
        closure: solvers.closure.as_ref().map(|closure| Closure {
            terms: closure.terms.iter().map(|term| closure_term(model, term)).collect(),
            statements: lowering.plain(&closure.program.stages[0]),
            coefficients: closure.coefficients.clone(),
        }),
    }
}

fn unit_vector(solvers: &Solvers, unknown: usize) -> Option<UnitVector> {
    let directions = solvers.directions();
    Some(UnitVector {
        cosine: directions.part(unknown, UnitPart::Cosine)?,
        sine: directions.part(unknown, UnitPart::Sine)?,
        angle: directions.angle(unknown),
    })
}

fn closure_term(model: &Model, term: &ClosureMonomial) -> ClosureTerm {
    let argument = |symbol: Symbol| {
        let index = match symbol {
            Symbol::Input(index) => index,
            Symbol::Unknown(index) => model.inputs.len() + index,
            _ => unreachable!("only inputs and unknowns move"),
        };
        u16::try_from(index).expect("a declaration with so many quantities is refused as too large")
    };
    let angle = |angle: &Angle| {
        let multiples = angle.0.iter().map(|&(symbol, multiple)| {
            let multiple = i8::try_from(multiple).expect("larger multiples are no terms of a closure");
            (argument(symbol), multiple)
        });
        multiples.collect()
    };
    ClosureTerm {
        equation: term.equation,
        factor: term.factor,
        coefficient: term.coefficient,
        powers: term
            .powers
            .iter()
            .map(|&(symbol, power)| (argument(symbol), power))
            .collect(),
        harmonic: match &term.harmonic {
            Harmonic::One => None,
            Harmonic::Cosine(combination) => Some((false, angle(combination))),
            Harmonic::Sine(combination) => Some((true, angle(combination))),
        },
    }
}
