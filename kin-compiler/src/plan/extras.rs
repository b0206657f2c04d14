//! Programs beside the motion: the assembly of a guess, all positions, the transmission angles, the lengths of links,
//! the coefficients of the closure.

use std::collections::BTreeMap;

use super::Task;
use crate::algebra::{Graph, Node, Symbol};
use crate::assemble;
use crate::passes::Passes;
use crate::program::{
    Choice, ClosureTerms, Component, Expression, FormLengths, Lengths, Mode, Names, Program, Step, TransmissionAngles,
};
use crate::schedule::{Style, schedule};
use crate::structure::{Block, block_forms, closure_polynomials, dyads};

/// The programs beside the motion.
pub(super) struct Extras {
    pub(super) orientations: Program<Expression>,
    pub(super) orientation_symbols: Vec<Symbol>,
    pub(super) every: Option<Program<Expression>>,
    pub(super) transmission: TransmissionAngles,
    pub(super) lengths: Lengths,
    pub(super) closure: Option<ClosureTerms>,
}

/// Plans all of them.
pub(super) fn extras(task: &Task<'_>, graph: &mut Graph, names: &Names, choices: &[Choice]) -> Extras {
    let (orientations, orientation_symbols) = orientations(graph, names, choices);
    Extras {
        orientations,
        orientation_symbols,
        every: every(task),
        transmission: transmission_angles(task.graph.clone(), task),
        lengths: lengths(task.graph.clone(), task),
        closure: closure(task),
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
fn transmission_angles(mut graph: Graph, task: &Task<'_>) -> TransmissionAngles {
    let mut names = task.names.clone();
    let mut steps = Vec::new();
    let dyads = dyads(&mut graph, task.residuals, task.blocks)
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

/// The form of each block. Lengths that are parameters or numbers need no program.
fn lengths(mut graph: Graph, task: &Task<'_>) -> Lengths {
    let mut components = Components::new(task, "length");
    let forms = block_forms(&mut graph, task.residuals, task.blocks)
        .into_iter()
        .map(|form| FormLengths {
            kind: form.kind,
            driver: form.driver,
            lengths: form
                .lengths
                .into_iter()
                .map(|length| {
                    length.map(|vector| [vector.re, vector.im].map(|part| components.positive(&mut graph, part)))
                })
                .collect(),
        })
        .collect();
    Lengths {
        forms,
        program: components.program(&graph),
    }
}

/// The closure as polynomials, for a mechanism with a coupled block.
fn closure(task: &Task<'_>) -> Option<ClosureTerms> {
    if !task.blocks.iter().any(Block::is_coupled) {
        return None;
    }
    let mut graph = task.graph.clone();
    let polynomials = closure_polynomials(&mut graph, task.residuals)?;
    let mut components = Components::new(task, "coefficient");
    let coefficients = polynomials.coefficients.into_iter();
    let coefficients = coefficients.map(|node| components.of(&mut graph, node)).collect();
    Some(ClosureTerms {
        terms: polynomials.terms,
        coefficients,
        program: components.program(&graph),
    })
}

/// Values from the parameters, and the steps that compute those that are no parameters or numbers.
struct Components {
    names: Names,
    /// The name that is wished for the computed ones.
    wish: &'static str,
    steps: Vec<Step<Node>>,
    known: BTreeMap<Node, Symbol>,
}

impl Components {
    fn new(task: &Task<'_>, wish: &'static str) -> Self {
        Self {
            names: task.names.clone(),
            wish,
            steps: Vec::new(),
            known: BTreeMap::new(),
        }
    }

    fn of(&mut self, graph: &mut Graph, node: Node) -> Component {
        if let Some(number) = graph.as_number(node) {
            return Component::Number(number);
        }
        if let Some(Symbol::Parameter(index)) = graph.as_symbol(node) {
            return Component::Parameter(index);
        }
        let symbol = *self.known.entry(node).or_insert_with(|| {
            let (symbol, _) = graph.new_step();
            self.names.name(symbol, self.wish);
            self.steps.push(Step::Define { symbol, value: node });
            symbol
        });
        Component::Value(symbol)
    }

    /// A value up to its sign.
    fn positive(&mut self, graph: &mut Graph, node: Node) -> Component {
        if let Some(number) = graph.as_number(node) {
            return Component::Number(number.abs());
        }
        let (coefficient, positive) = graph.split_coefficient(node);
        if coefficient.abs() == 1.0 && matches!(graph.as_symbol(positive), Some(Symbol::Parameter(_))) {
            self.of(graph, positive)
        } else {
            self.of(graph, node)
        }
    }

    fn program(self, graph: &Graph) -> Program<Expression> {
        scheduled(graph, self.steps, self.names)
    }
}

fn scheduled(graph: &Graph, steps: Vec<Step<Node>>, names: Names) -> Program<Expression> {
    schedule(graph, &Program::single(steps, names), &[], Style::plain(Passes::ALL))
}
