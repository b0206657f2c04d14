//! Programs beside the motion: the assembly of a guess, all positions, the transmission angles.

use super::Task;
use crate::algebra::{Graph, Node, Symbol};
use crate::assemble;
use crate::passes::Passes;
use crate::program::{Choice, Expression, Mode, Names, Program, Step, TransmissionAngles};
use crate::schedule::{Style, schedule};
use crate::structure::{Block, dyads};

/// The programs beside the motion.
pub(super) struct Extras {
    pub(super) orientations: Program<Expression>,
    pub(super) orientation_symbols: Vec<Symbol>,
    pub(super) every: Option<Program<Expression>>,
    pub(super) transmission: Option<TransmissionAngles>,
}

/// Plans all of them: those that are requested and those that every mechanism has.
pub(super) fn extras(task: &Task<'_>, graph: &mut Graph, names: &Names, choices: &[Choice]) -> Extras {
    let (orientations, orientation_symbols) = orientations(graph, names, choices);
    Extras {
        orientations,
        orientation_symbols,
        every: every(task),
        transmission: task
            .has_transmission_angles
            .then(|| transmission_angles(graph.clone(), names, task.residuals, task.blocks)),
    }
}

/// The program that finds the assembly of given values of the unknowns, with a definition for each choice of the
/// caller.
fn orientations(graph: &mut Graph, names: &Names, choices: &[Choice]) -> (Program<Expression>, Vec<Symbol>) {
    let mut names = names.clone();
    let (mut steps, mut symbols) = (Vec::new(), Vec::new());
    for choice in choices {
        if let (Mode::Assembly(index), Some(value)) = (choice.mode, choice.orientation) {
            let (symbol, _) = graph.new_step();
            names.name(symbol, &format!("orientation_{}", index + 1));
            steps.push(Step::Define { symbol, value });
            symbols.push(symbol);
        }
    }
    (scheduled(graph, steps, names), symbols)
}

/// The program that goes through all positions.
fn every(task: &Task<'_>) -> Option<Program<Expression>> {
    if !task.blocks.iter().any(Block::is_coupled) {
        return None;
    }
    let (mut graph, mut names) = (task.graph.clone(), task.names.clone());
    let stage = assemble::assemble_every(&mut graph, &mut names, task.blocks, &task.ranges, task.passes)?;
    let program = Program::single(stage.steps, names);
    let style = Style::checked(task.passes);
    Some(schedule(&graph, &program, &[], style))
}

/// All dyads, and the program of their angles.
fn transmission_angles(mut graph: Graph, names: &Names, residuals: &[Node], blocks: &[Block]) -> TransmissionAngles {
    let mut names = names.clone();
    let mut steps = Vec::new();
    let dyads = dyads(&mut graph, residuals, blocks)
        .into_iter()
        .zip(1..)
        .map(|(dyad, number)| {
            let symbols = [("across", dyad.across), ("along", dyad.along)].map(|(wish, value)| {
                let (symbol, _) = graph.new_step();
                names.name(symbol, &format!("{wish}_{number}"));
                steps.push(Step::Define { symbol, value });
                symbol
            });
            (dyad, symbols)
        })
        .collect();
    let program = scheduled(&graph, steps, names);
    TransmissionAngles { dyads, program }
}

fn scheduled(graph: &Graph, steps: Vec<Step<Node>>, names: Names) -> Program<Expression> {
    schedule(graph, &Program::single(steps, names), &[], Style::plain(Passes::ALL))
}
