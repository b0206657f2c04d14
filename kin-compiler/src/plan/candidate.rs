//! One way to derive the program: a list of passes, from derivatives to the schedule.

use super::Task;
use super::extras::extras;
use super::forms::Derived;
use super::guards::unguarded_divisors;
use super::naming::{name_rates, name_sensitivities};
use super::telltales::telltales;
use crate::algebra::{Graph, Node, Symbol};
use crate::assemble::{self, KnownRoot, PositionSteps, Reciprocals, Units};
use crate::derive::{Definition, Hint, Influences, Mover, Rate};
use crate::passes::{Pass, Passes};
use crate::program::{
    Approach, Choice, Directions, Expression, Names, Program, Solvers, Stage, Step, Trial, Trials, order_name,
};
use crate::schedule::{Style, hand_on, schedule_on_trial};
use crate::work;

/// A program that was derived in one way, and its schedule.
pub(super) struct Candidate {
    pub(super) way: Approach,
    graph: Graph,
    program: Program<Node>,
    hints: Vec<(Node, String)>,
    choices: Vec<Choice>,
    scheduled: Program<Expression>,
}

impl Candidate {
    /// Runs all passes, one after the other.
    pub(super) fn new(task: &Task<'_>, derived: &Derived, sensitivities: &[Definition]) -> Self {
        let mut draft = Draft::of_position(task, derived);
        draft.learn_reciprocals();
        draft.define_unit_vectors();
        draft.define_outputs();
        draft.leave_angles();
        draft.add_rates();
        draft.add_sensitivities(sensitivities);
        draft.hint_names();
        draft.check_divisors();
        draft.drop_idle_angles();
        draft.place_reciprocals();
        draft.schedule()
    }

    /// The operations of all orders.
    pub(super) fn cost(&self) -> usize {
        self.scheduled.cost().total()
    }

    /// The record of this way and its cost.
    pub(super) fn trial(&self) -> Trial {
        Trial {
            way: self.way,
            cost: self.scheduled.cost(),
        }
    }

    /// Leaves shared factors in their terms, if that is cheaper. Returns whether it is.
    pub(super) fn leave_factors(&mut self, passes: Passes) -> bool {
        if !passes.include(Pass::FactorsLeft) || work::is_spent() {
            return false;
        }
        let style = Style::checked(passes);
        let other = schedule_on_trial(&self.graph, &self.program, &self.hints, style);
        let is_cheaper = other.cost().arithmetic() < self.scheduled.cost().arithmetic();
        if is_cheaper {
            self.scheduled = other;
            self.way.takes_out_factors = false;
        }
        is_cheaper
    }

    /// The solvers, with the programs beside them.
    pub(super) fn finish(mut self, task: &Task<'_>, trials: Vec<Trial>, is_form_given_up: bool) -> Solvers {
        hand_on(&mut self.scheduled);
        let extras = extras(task, &mut self.graph, &self.program.names, &self.choices);
        let telltales = telltales(&mut self.graph, &self.program.stages);
        Solvers {
            motion: self.scheduled,
            choices: self.choices,
            graph: self.graph,
            telltales,
            orientations: extras.orientations,
            orientation_symbols: extras.orientation_symbols,
            every: extras.every,
            transmission: extras.transmission,
            lengths: extras.lengths,
            closure: extras.closure,
            is_form_given_up,
            trials: Trials {
                all: trials,
                kept: self.way,
            },
        }
    }
}

/// A program in the making.
struct Draft<'a> {
    task: &'a Task<'a>,
    derived: &'a Derived,
    graph: Graph,
    names: Names,
    stages: Vec<Stage<Node>>,
    /// The directions of links, by which every expression is rewritten.
    units: Units,
    roots: Vec<KnownRoot>,
    reciprocals: Reciprocals,
    directions: Directions,
    choices: Vec<Choice>,
    /// The values that the position finds to be nonzero.
    nonzero: Vec<Node>,
    hints: Vec<(Node, String)>,
    has_sensitivities: bool,
}

impl<'a> Draft<'a> {
    /// Derives the position, block by block.
    fn of_position(task: &'a Task<'a>, derived: &'a Derived) -> Self {
        let (mut graph, mut names) = (derived.graph.clone(), task.names.clone());
        let unknowns: Vec<usize> = task.blocks.iter().flat_map(|block| &block.unknowns).copied().collect();
        name_rates(
            &mut names,
            &derived.derivatives,
            task.inputs,
            &unknowns,
            task.outputs.len(),
        );
        let PositionSteps {
            stage,
            units,
            nonzero,
            roots,
            choices,
        } = assemble::assemble(
            &mut graph,
            &mut names,
            task.blocks,
            &task.ranges,
            &derived.derivatives.regularity,
            task.passes,
        );
        Self {
            task,
            derived,
            graph,
            names,
            stages: vec![stage],
            units,
            roots,
            reciprocals: Reciprocals::default(),
            directions: Directions::default(),
            choices,
            nonzero,
            hints: Vec::new(),
            has_sensitivities: false,
        }
    }

    /// Lets rates use the reciprocals of the roots that closed forms take.
    fn learn_reciprocals(&mut self) {
        let is_included = self.task.passes.include(Pass::InvertedRoots);
        let roots: &[KnownRoot] = if is_included { &self.roots } else { &[] };
        self.reciprocals = Reciprocals::learn(&mut self.graph, &mut self.names, &mut self.units, roots);
    }

    /// Defines cosine and sine of the unknowns that are returned as unit vectors.
    fn define_unit_vectors(&mut self) {
        self.directions = assemble::define(
            &mut self.graph,
            &mut self.names,
            &mut self.units,
            &self.task.directions,
            &mut self.stages[0],
        );
    }

    /// Defines the values of the outputs.
    fn define_outputs(&mut self) {
        for (index, &output) in self.derived.form.formulas.values.iter().enumerate() {
            let step = self.definition(Symbol::OutputRate(index, 0), output);
            self.stages[0].steps.push(step);
        }
    }

    /// Gives the angles beside unit vectors further names for later stages.
    fn leave_angles(&mut self) {
        assemble::leave_angles(&self.directions, &mut self.graph, &mut self.units, &mut self.stages[0]);
    }

    /// Adds a stage for each order, with the rates of the unknowns and of the outputs.
    fn add_rates(&mut self) {
        let derivatives = &self.derived.derivatives;
        for (order, (rates, outputs)) in derivatives.orders.iter().zip(&derivatives.outputs).enumerate() {
            let mut steps = Vec::new();
            for rate in rates {
                steps.push(match rate {
                    Rate::Value { symbol, value } => self.definition(*symbol, *value),
                    Rate::System {
                        factors,
                        symbols,
                        right,
                    } => self
                        .units
                        .substitution(&mut self.graph, *factors, right, symbols.clone()),
                });
            }
            for (index, &output) in outputs.iter().enumerate() {
                steps.push(self.definition(Symbol::OutputRate(index, order + 1), output));
            }
            self.stages.push(Stage::new(steps));
        }
    }

    /// Adds a stage after the highest order, with the partial derivatives by the parameters.
    fn add_sensitivities(&mut self, definitions: &[Definition]) {
        if definitions.is_empty() {
            return;
        }
        self.has_sensitivities = true;
        name_sensitivities(definitions, &mut self.names);
        let mut steps = Vec::new();
        for definition in definitions {
            steps.push(match definition {
                Definition::Value { symbol, node } | Definition::Entry { symbol, node, .. } => {
                    self.definition(*symbol, *node)
                }
                // the factors come from the position: if it cannot factor the matrix, there is no pose
                Definition::System {
                    factors,
                    right,
                    results,
                } => self
                    .units
                    .substitution(&mut self.graph, *factors, right, results.clone()),
            });
        }
        self.stages.push(Stage::new(steps));
    }

    /// Names the parts of the formulas that have a meaning.
    fn hint_names(&mut self) {
        let derivatives = &self.derived.derivatives;
        for &determinant in derivatives.determinants() {
            let node = self.units.rewrite(&mut self.graph, determinant);
            self.hints.push((node, "determinant".to_owned()));
        }
        for (node, hint) in derivatives.hints(&self.derived.graph) {
            let (name, is_opposite) = self.hint(hint);
            let node = self.units.rewrite(&mut self.graph, node);
            let opposite = self.graph.negate(node);
            let minus = format!("minus_{name}");
            let [name, minus] = if is_opposite { [minus, name] } else { [name, minus] };
            self.hints.extend([(node, name), (opposite, minus)]);
        }
    }

    /// The name of a part of the formulas, and whether the part is the opposite of the named quantity.
    fn hint(&self, hint: Hint) -> (String, bool) {
        let name = match hint {
            Hint::Right { equation, order } => format!("right_{}_{}", equation + 1, order_name(order)),
            Hint::P { angle, order } => format!("{}_p{order}", self.names.of(angle)),
            Hint::Q { angle, order } => format!("{}_q{order}", self.names.of(angle)),
            Hint::Influence {
                unknown,
                by,
                is_opposite,
            } => {
                let unknown = self.names.of(unknown);
                let name = by.map_or_else(
                    || format!("{unknown}_influence"),
                    |Mover { quantity, is_along }| {
                        let part = if is_along { "_p" } else { "" };
                        format!("{unknown}_per_{}{part}", self.names.of(quantity))
                    },
                );
                return (name, is_opposite);
            }
        };
        (name, false)
    }

    /// Lets the position check the divisors of later stages.
    fn check_divisors(&mut self) {
        let derivatives = &self.derived.derivatives;
        let guaranteed: Vec<Node> = derivatives
            .guaranteed
            .iter()
            .chain(derivatives.determinants())
            .chain(&self.nonzero)
            .map(|&node| self.units.rewrite(&mut self.graph, node))
            .collect();
        let divisors = unguarded_divisors(&self.graph, &self.stages, &guaranteed);
        let checks = divisors.into_iter().map(|value| Step::Regular { value });
        self.stages[0].steps.extend(checks);
    }

    /// Removes angles that nothing uses and whose unit vectors are found.
    fn drop_idle_angles(&mut self) {
        assemble::drop_idle(
            &mut self.directions,
            &mut self.graph,
            &mut self.stages,
            &self.task.ranges,
        );
    }

    /// Places reciprocals before the first step that needs them.
    fn place_reciprocals(&mut self) {
        std::mem::take(&mut self.reciprocals).insert_into(&self.graph, &mut self.stages);
    }

    fn schedule(self) -> Candidate {
        let program = Program {
            stages: self.stages,
            names: self.names,
            directions: self.directions,
            has_sensitivities: self.has_sensitivities,
        };
        let takes_out_factors = self.task.passes.include(Pass::SharedFactors);
        let style = Style {
            takes_out_factors,
            ..Style::checked(self.task.passes)
        };
        let scheduled = schedule_on_trial(&self.graph, &program, &self.hints, style);
        Candidate {
            way: Approach {
                is_multiplied_out: self.derived.form.is_multiplied_out,
                has_influences: self.derived.influences == Influences::Collected,
                takes_out_factors,
            },
            graph: self.graph,
            program,
            hints: self.hints,
            choices: self.choices,
            scheduled,
        }
    }

    /// A definition, rewritten by the directions known at its stage.
    fn definition(&mut self, symbol: Symbol, node: Node) -> Step<Node> {
        let value = self.units.rewrite(&mut self.graph, node);
        Step::Define { symbol, value }
    }
}
