//! The whole program, by the cheapest of several ways to derive it.
//!
//! The equations are differentiated as typed and multiplied out, and the better of the two with influence coefficients. Each way is
//! carried through to the scheduled program and its operations are counted; the cheapest one is kept.

use std::collections::{BTreeMap, BTreeSet};

use crate::assemble::{self, Choice, Directions, Limits, Mode, Names, Program, Reciprocals, Stage, Step};
use crate::derive::{self, Definition, Derivatives, Formulas, Hint, Rate, Row, TooLarge, Way};
use crate::expr::{Graph, Node, Symbol, Term};
use crate::finite;
use crate::passes::{Pass, Passes};
use crate::schedule::{Factors, Scheduled, ScheduledStage, Style, schedule};
use crate::structure::Block;

/// Position, velocity, acceleration, jerk, snap, ….
const ORDER_NAMES: [&str; 7] = ["position", "velocity", "acceleration", "jerk", "snap", "crackle", "pop"];

/// What the n-th time derivative is called.
pub(crate) fn order_name(order: usize) -> String {
    ORDER_NAMES
        .get(order)
        .map_or_else(|| format!("derivative_{order}"), |name| (*name).to_owned())
}

/// What is to be solved.
pub(crate) struct Task<'a> {
    pub(crate) graph: &'a Graph,
    pub(crate) residuals: &'a [Node],
    pub(crate) blocks: &'a [Block],
    pub(crate) ranges: &'a BTreeMap<usize, Limits>,
    /// The unknown angles that are handed out as unit vectors.
    pub(crate) directions: &'a BTreeSet<usize>,
    /// The scalar parts of the outputs.
    pub(crate) outputs: &'a [Node],
    pub(crate) inputs: usize,
    pub(crate) order: usize,
    /// How many scalar parameters the motion is to be differentiated by: all of them, or none.
    pub(crate) parameters: usize,
    /// Names of parameters, inputs, unknowns and outputs.
    pub(crate) names: &'a Names,
    /// What is done to make it cheaper.
    pub(crate) passes: Passes,
    /// More expressions than these are not handled.
    pub(crate) most_expressions: usize,
}

/// As many expressions as the largest declarations that compile in minutes have: some hundred thousand operations.
pub(crate) const MOST_EXPRESSIONS: usize = 1_000_000;

/// The program that was kept.
pub(crate) struct Plan {
    pub(crate) graph: Graph,
    pub(crate) choices: Vec<Choice>,
    pub(crate) names: Names,
    /// The unknowns that are handed out as unit vectors.
    pub(crate) directions: Directions,
    pub(crate) scheduled: Scheduled,
    /// The rates that are to be tested, by unknown and order, that all be known to be finite.
    pub(crate) telltales: BTreeSet<(usize, usize)>,
    /// The partial derivatives by the parameters, if they were asked for: what follows the highest order.
    pub(crate) sensitivities: Option<ScheduledStage>,
    /// What tells the assembly of a guess: definitions in the order of the choices, each positive in the open assembly.
    pub(crate) orientations: ScheduledStage,
    /// What goes through all positions where a block is left to Newton's method, if its equations are algebraic.
    pub(crate) every: Option<ScheduledStage>,
    /// Whether equations or outputs were too large to be multiplied out.
    pub(crate) is_form_given_up: bool,
}

/// Equations and outputs in one form, and the graph that has it.
#[derive(Clone)]
struct Form {
    graph: Graph,
    formulas: Formulas,
}

/// Tries both forms, and the cheaper one with influence coefficients, and keeps the cheapest.
///
/// # Errors
/// If the derivatives take too many expressions.
pub(crate) fn plan(task: &Task<'_>) -> Result<Plan, TooLarge> {
    let attempt = |form: Form, way: Way| {
        let derived = Derived::new(task, form, way)?;
        let mut own = candidate(task, &derived, &[]);
        own.take_out_factors(Factors::TakenOut, task.passes);
        Ok((own, derived))
    };
    let forms = forms(task);
    let is_form_given_up = forms.iter().any(|form| form.formulas.is_given_up);
    let mut best = forms
        .into_iter()
        .map(|form| attempt(form, Way::Whole))
        .collect::<Result<Vec<_>, TooLarge>>()?
        .into_iter()
        .min_by_key(|(own, _)| own.cost())
        .expect("there is at least one form");
    if task.passes.include(Pass::Influences) {
        let other = attempt(best.1.form.clone(), Way::Collected)?;
        if other.0.cost() < best.0.cost() {
            best = other;
        }
    }
    let (mut best, derived) = best;
    if task.parameters > 0 {
        best = sensitive(task, derived)?;
    }
    best.take_out_factors(Factors::TakenOutOfRates, task.passes);
    Ok(Plan {
        is_form_given_up,
        ..best.finish(every(task))
    })
}

/// Equations and outputs in one form, with their derivatives.
struct Derived {
    form: Form,
    way: Way,
    graph: Graph,
    derivatives: Derivatives,
}

impl Derived {
    fn new(task: &Task<'_>, form: Form, way: Way) -> Result<Self, TooLarge> {
        let mut graph = form.graph.clone();
        if !task.passes.include(Pass::ConstantFolding) {
            graph.keep_numbers();
        }
        let derivatives = Derivatives::new(&mut graph, form.task(task, way), task.order)?;
        Ok(Self {
            form,
            way,
            graph,
            derivatives,
        })
    }
}

impl Form {
    fn task<'a>(&'a self, task: &Task<'a>, way: Way) -> derive::Task<'a> {
        derive::Task {
            residuals: &self.formulas.residuals,
            blocks: task.blocks,
            outputs: &self.formulas.outputs,
            way,
            passes: task.passes,
            most_expressions: task.most_expressions,
        }
    }
}

/// The program for what is derived, with the sensitivities after it.
fn sensitive(task: &Task<'_>, mut derived: Derived) -> Result<Candidate, TooLarge> {
    let own = derived.form.task(task, derived.way);
    let definitions = derived
        .derivatives
        .sensitivities(&mut derived.graph, own, task.parameters)?;
    let mut candidate = candidate(task, &derived, &definitions);
    candidate.take_out_factors(Factors::TakenOut, task.passes);
    Ok(candidate)
}

/// The program that goes through all positions.
fn every(task: &Task<'_>) -> Option<ScheduledStage> {
    if !task.blocks.iter().any(Block::is_coupled) {
        return None;
    }
    let (mut graph, mut names) = (task.graph.clone(), task.names.clone());
    let stage = assemble::assemble_every(&mut graph, &mut names, task.blocks, task.ranges, task.passes)?;
    let program = Program {
        stages: vec![stage],
        names,
        directions: Directions::default(),
        has_sensitivities: false,
    };
    let style = Style {
        factors: Factors::Left,
        check_domains: true,
        passes: task.passes,
    };
    Some(schedule(&graph, &program, &[], style).stages.swap_remove(0))
}

/// The equations multiplied out, and as typed if that is something else.
fn forms(task: &Task<'_>) -> Vec<Form> {
    let mut graph = task.graph.clone();
    let mut form = |expand| {
        let formulas = derive::formulas(&mut graph, task.residuals, task.outputs, expand);
        Form {
            graph: graph.clone(),
            formulas,
        }
    };
    let (expanded, typed) = (form(true), form(false));
    let nodes = |form: &Form| [form.formulas.residuals.clone(), form.formulas.outputs.clone()];
    if nodes(&expanded) == nodes(&typed) || !task.passes.include(Pass::AsTyped) {
        return vec![expanded];
    }
    if !task.passes.include(Pass::MultipliedOut) {
        return vec![typed];
    }
    vec![expanded, typed]
}

/// The program for what is derived.
struct Candidate {
    graph: Graph,
    program: Program,
    hints: Vec<(Node, String)>,
    choices: Vec<Choice>,
    scheduled: Scheduled,
}

impl Candidate {
    fn cost(&self) -> usize {
        self.scheduled.cost().total()
    }

    /// Takes out factors that terms share, if that is cheaper.
    fn take_out_factors(&mut self, factors: Factors, passes: Passes) {
        if !passes.include(Pass::SharedFactors) {
            return;
        }
        let style = Style {
            factors,
            check_domains: true,
            passes,
        };
        let other = schedule(&self.graph, &self.program, &self.hints, style);
        if other.cost().arithmetic() < self.scheduled.cost().arithmetic() {
            self.scheduled = other;
        }
    }

    fn finish(mut self, every: Option<ScheduledStage>) -> Plan {
        let Program {
            names,
            directions,
            has_sensitivities,
            stages,
        } = self.program;
        let sensitivities = if has_sensitivities {
            self.scheduled.stages.pop()
        } else {
            None
        };
        let orientations = orientations(&mut self.graph, &names, &self.choices);
        let telltales = finite::telltales(&mut self.graph, &stages);
        Plan {
            graph: self.graph,
            choices: self.choices,
            names,
            directions,
            scheduled: self.scheduled,
            telltales,
            sensitivities,
            orientations,
            every,
            is_form_given_up: false,
        }
    }
}

/// Assembles and schedules it, with the sensitivities given after it.
fn candidate(task: &Task<'_>, derived: &Derived, sensitivities: &[Definition]) -> Candidate {
    let mut graph = derived.graph.clone();
    let derivatives = &derived.derivatives;
    let order = derivatives.orders.len();
    let mut names = task.names.clone();
    for order in 1..=order {
        let suffix = order_name(order);
        let symbols = (0..task.inputs)
            .map(|index| (Symbol::Input(index), Symbol::InputRate(index, order)))
            .chain(
                task.blocks
                    .iter()
                    .flat_map(|block| &block.unknowns)
                    .map(|&index| (Symbol::Unknown(index), Symbol::UnknownRate(index, order))),
            )
            .chain(
                (0..task.outputs.len()).map(|index| (Symbol::OutputRate(index, 0), Symbol::OutputRate(index, order))),
            )
            .collect::<Vec<_>>();
        for (base, rate) in symbols {
            let wish = format!("{}_{suffix}", names.of(base));
            names.name(rate, &wish);
        }
    }
    for symbol in derivatives.orders.iter().flatten().flat_map(Rate::symbols) {
        if let Symbol::Turning(unknown, order) = *symbol {
            let wish = format!("{}_q{order}", names.of(Symbol::Unknown(unknown)));
            names.name(*symbol, &wish);
        }
    }
    for (symbol, _) in derivatives.regularity.iter().filter_map(|block| block.system.as_ref()) {
        names.name(*symbol, "factors");
    }
    let assembled = assemble::assemble(
        &mut graph,
        &mut names,
        task.blocks,
        task.ranges,
        &derivatives.regularity,
        task.passes,
    );
    let mut units = assembled.units;
    let roots = if task.passes.include(Pass::InvertedRoots) {
        assembled.roots.as_slice()
    } else {
        &[]
    };
    let reciprocals = Reciprocals::learn(&mut graph, &mut names, &mut units, roots);
    let mut stages = vec![assembled.stage];
    let mut directions = Directions::define(&mut graph, &mut names, &mut units, task.directions, &mut stages[0]);
    for (index, &output) in task.outputs.iter().enumerate() {
        let node = units.rewrite(&mut graph, output);
        stages[0].steps.push(Step::Define {
            symbol: Symbol::OutputRate(index, 0),
            node,
        });
    }
    directions.leave_angles(&mut graph, &mut units, &mut stages[0]);
    for order in 1..=order {
        let mut steps = Vec::new();
        for rate in &derivatives.orders[order - 1] {
            steps.push(match rate {
                Rate::Value { symbol, value } => Step::Define {
                    symbol: *symbol,
                    node: units.rewrite(&mut graph, *value),
                },
                Rate::System {
                    factors,
                    symbols,
                    right,
                } => units.substitution(&mut graph, *factors, right, symbols.clone()),
            });
        }
        for (index, &output) in derivatives.outputs[order - 1].iter().enumerate() {
            let node = units.rewrite(&mut graph, output);
            steps.push(Step::Define {
                symbol: Symbol::OutputRate(index, order),
                node,
            });
        }
        stages.push(Stage { steps });
    }
    if !sensitivities.is_empty() {
        name_sensitivities(sensitivities, &mut names);
        let steps = sensitivities
            .iter()
            .map(|definition| match definition {
                Definition::Value { symbol, node } | Definition::Entry { symbol, node, .. } => Step::Define {
                    symbol: *symbol,
                    node: units.rewrite(&mut graph, *node),
                },
                // the factors are the position's own: where it could not factor there is no pose
                Definition::System {
                    factors,
                    right,
                    results,
                } => units.substitution(&mut graph, *factors, right, results.clone()),
            })
            .collect();
        stages.push(Stage { steps });
    }
    let mut hints: Vec<(Node, String)> = Vec::new();
    for &determinant in derivatives.regular() {
        hints.push((units.rewrite(&mut graph, determinant), "determinant".to_owned()));
    }
    for (node, hint) in derivatives.hints(&derived.graph) {
        let name = match hint {
            Hint::Right { equation, order } => format!("right_{}_{}", equation + 1, order_name(order)),
            Hint::Influence => "influence".to_owned(),
            Hint::P { angle, order } => format!("{}_p{order}", names.of(angle)),
            Hint::Q { angle, order } => format!("{}_q{order}", names.of(angle)),
        };
        let node = units.rewrite(&mut graph, node);
        let opposite = graph.negate(node);
        hints.extend([(node, name.clone()), (opposite, name)]);
    }
    let guaranteed: Vec<Node> = derivatives
        .guaranteed
        .iter()
        .chain(derivatives.regular())
        .chain(&assembled.nonzero)
        .map(|&node| units.rewrite(&mut graph, node))
        .collect();
    let checks = unguarded_divisors(&graph, &stages, &guaranteed);
    stages[0]
        .steps
        .extend(checks.into_iter().map(|node| Step::Regular { node }));
    directions.drop_idle(&mut graph, &mut stages, task.ranges);
    reciprocals.place(&graph, &mut stages);
    let program = Program {
        stages,
        names,
        directions,
        has_sensitivities: !sensitivities.is_empty(),
    };
    let style = Style {
        factors: Factors::Left,
        check_domains: true,
        passes: task.passes,
    };
    let scheduled = schedule(&graph, &program, &hints, style);
    Candidate {
        graph,
        program,
        hints,
        choices: assembled.choices,
        scheduled,
    }
}

/// Names for the partial derivatives: `theta4_velocity_by_r3`.
fn name_sensitivities(definitions: &[Definition], names: &mut Names) {
    for definition in definitions {
        let symbols = match definition {
            Definition::Value { symbol, .. } => std::slice::from_ref(symbol),
            Definition::System { results, .. } => results,
            Definition::Entry {
                symbol,
                row,
                unknown,
                order,
                ..
            } => {
                let row = match *row {
                    Row::Equation(equation) => (equation + 1).to_string(),
                    Row::Output(output) => names.of(Symbol::OutputRate(output, 0)).to_owned(),
                };
                let unknown = names.of(Symbol::Unknown(*unknown));
                let wish = format!("entry_{row}_{unknown}_{}", order_name(*order));
                names.name(*symbol, &wish);
                continue;
            }
        };
        for &symbol in symbols {
            let (base, parameter, order) = match symbol {
                Symbol::Sensitivity(unknown, parameter, order) => (Symbol::Unknown(unknown), parameter, order),
                Symbol::OutputSensitivity(output, parameter, order) => {
                    (Symbol::OutputRate(output, 0), parameter, order)
                }
                _ => unreachable!("sensitivities are of unknowns and outputs"),
            };
            let parameter = names.of(Symbol::Parameter(parameter));
            let wish = format!("{}_{}_by_{parameter}", names.of(base), order_name(order));
            names.name(symbol, &wish);
        }
    }
}

/// A program that tells the assembly of given values of the unknowns, a definition for each choice of the caller's.
fn orientations(graph: &mut Graph, names: &Names, choices: &[Choice]) -> ScheduledStage {
    let mut names = names.clone();
    let mut steps = Vec::new();
    for choice in choices {
        if let (Mode::Assembly(index), Some(node)) = (choice.mode, choice.orientation) {
            let (symbol, _) = graph.new_step();
            names.name(symbol, &format!("orientation_{}", index + 1));
            steps.push(Step::Define { symbol, node });
        }
    }
    let program = Program {
        stages: vec![Stage { steps }],
        names,
        directions: Directions::default(),
        has_sensitivities: false,
    };
    let mut scheduled = schedule(
        graph,
        &program,
        &[],
        Style {
            factors: Factors::Left,
            check_domains: false,
            passes: Passes::ALL,
        },
    );
    scheduled.stages.swap_remove(0)
}

/// What only later stages divide by, and nothing before them has found to be regular.
fn unguarded_divisors(graph: &Graph, stages: &[Stage], guaranteed: &[Node]) -> Vec<Node> {
    let divisors = |stages: &[Stage]| -> BTreeSet<Node> {
        let needs: Vec<Node> = stages
            .iter()
            .flat_map(|stage| &stage.steps)
            .flat_map(Step::needs)
            .collect();
        graph
            .reachable(&needs)
            .into_iter()
            .filter_map(|node| match graph.term(node) {
                Term::Product(factors) => Some(factors),
                _ => None,
            })
            .flatten()
            .filter(|&&(_, exponent)| exponent < 0)
            .map(|&(base, _)| base)
            .collect()
    };
    let Some((first, later)) = stages.split_first() else {
        return Vec::new();
    };
    let mut known = divisors(std::slice::from_ref(first));
    for &node in guaranteed {
        known.insert(node);
        match graph.term(node) {
            // a product that does not vanish has no factor that does
            Term::Product(factors) => known.extend(factors.iter().map(|&(base, _)| base)),
            Term::Sum(constant, terms) if constant.get() == 0.0 && terms.len() == 1 => {
                known.insert(terms[0].0);
                if let Term::Product(factors) = graph.term(terms[0].0) {
                    known.extend(factors.iter().map(|&(base, _)| base));
                }
            }
            _ => {}
        }
    }
    divisors(later)
        .into_iter()
        .filter(|divisor| !known.contains(divisor))
        // a length that a closed form has turned into a direction is not zero
        .filter(|&divisor| {
            !matches!(
                graph.as_symbol(divisor),
                Some(Symbol::Unknown(_) | Symbol::Parameter(_))
            )
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use proc_macro2::TokenStream;
    use quote::quote;

    use super::plan;
    use crate::declarations;
    use crate::expand::sound;
    use crate::passes::{Pass, Passes};

    fn four_bar(order: usize) -> TokenStream {
        let order = proc_macro2::Literal::usize_unsuffixed(order);
        let declaration = declarations::four_bar();
        quote! {
            #declaration
            order = #order;
        }
    }

    /// The architecture shows what link vectors save for the four-bar linkage, from the position through each order.
    #[test]
    fn the_table_of_link_vectors_is_up_to_date() {
        let book = include_str!("../../docs/architecture.md");
        for (name, passes) in [
            ("link vectors", Passes::ALL),
            ("Leibniz's rule", Passes::without(Pass::LinkVectors)),
        ] {
            let cells: Vec<String> = (1..=4)
                .map(|order| {
                    plan(&sound(four_bar(order)).task(passes))
                        .expect("it is small")
                        .scheduled
                        .cost()
                        .arithmetic()
                        .to_string()
                })
                .collect();
            let row = format!("| {name} | {} |", cells.join(" | "));
            assert!(
                book.lines().any(|line| line == row),
                "docs/architecture.md should say\n{row}"
            );
        }
    }
}
