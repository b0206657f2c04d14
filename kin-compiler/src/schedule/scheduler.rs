//! Operations as steps: the values that get a name, and the stage that computes each value.

use std::collections::BTreeMap;

use super::carry::hand_on;
use super::lines::Lines;
use super::operation::{Operation, OperationId, OperationList};
use super::share;
use super::style::Style;
use crate::algebra::{Checked, Function, Graph, IndexTable, Node, Symbol};
use crate::passes::{Pass, Passes};
use crate::program::{Cost, Expression, Mode, Names, Program, Solver, Stage, Step};
use crate::work;

/// The largest number of operations in an expression. Longer ones are broken up.
const READABLE: usize = 10;

/// The uses of a value.
#[derive(Clone, Copy, Default)]
struct Usage {
    count: usize,
    last_stage: usize,
    /// Whether the value needs the parameters alone and takes long, and is part of one that changes: it is calculated
    /// once for many poses.
    is_prepared: bool,
}

/// The state of scheduling.
pub(super) struct Scheduler<'a> {
    pub(super) operations: OperationList,
    pub(super) names: Names,
    pub(super) hints: BTreeMap<OperationId, String>,
    /// The usage of each value that is used.
    usage: IndexTable<OperationId, Usage>,
    /// The symbols of the values that have a name.
    pub(super) bound: IndexTable<OperationId, Symbol>,
    program: &'a Program<Node>,
    style: Style,
    stage: usize,
    steps: Vec<Step<Expression>>,
    cost: Cost,
    /// The mode in which the current block chooses between its solutions.
    mode: Mode,
    /// The modes of the blocks written so far, by unknown.
    modes: BTreeMap<usize, Mode>,
    /// The iterations of Newton's method, by part.
    iterations: BTreeMap<usize, Iteration>,
}

/// One iteration of Newton's method.
#[derive(Clone)]
struct Iteration {
    step: Step<Expression>,
    cost: Cost,
}

/// Schedules the iterations of Newton's method, each as a separate program. Their names are added to those of the
/// surrounding program.
fn iterations(graph: &Graph, program: &Program<Node>, names: &mut Names, passes: Passes) -> BTreeMap<usize, Iteration> {
    let mut iterations = BTreeMap::new();
    for step in program.stages.iter().flat_map(|stage| &stage.steps) {
        let Step::Newton {
            part,
            unknowns,
            residuals,
            jacobian,
            ..
        } = step
        else {
            continue;
        };
        // a step that stands for all lines of the iteration together, whose results are taken apart below
        let lines = Step::Factor {
            symbol: RESIDUALS,
            matrix: [residuals].into_iter().chain(jacobian).cloned().collect(),
        };
        let inner = Program::single(vec![lines], names.clone());
        let mut scheduled = schedule_on_trial(graph, &inner, &[], Style::plain(passes));
        names.adopt(scheduled.names);
        let Stage {
            steps: mut body, cost, ..
        } = scheduled.stages.swap_remove(0);
        let Some(Step::Factor { matrix, .. }) = body.pop() else {
            unreachable!("it is the last step");
        };
        let mut matrix = matrix.into_iter();
        let residuals = matrix.next().unwrap_or_default();
        let cost = cost + Cost::of_factors(unknowns.len()) + Cost::of_substitution(unknowns.len());
        let step = Step::Newton {
            part: *part,
            unknowns: unknowns.clone(),
            given: Vec::new(),
            body,
            residuals,
            jacobian: matrix.collect(),
        };
        iterations.insert(*part, Iteration { step, cost });
    }
    iterations
}

/// The symbol of the residuals and the Jacobian of an iteration while it is scheduled.
const RESIDUALS: Symbol = Symbol::Step(usize::MAX);

/// Schedules a program. `hints` are names for expressions that need a `let`.
pub(crate) fn schedule(
    graph: &Graph,
    program: &Program<Node>,
    hints: &[(Node, String)],
    style: Style,
) -> Program<Expression> {
    let mut scheduled = schedule_on_trial(graph, program, hints, style);
    hand_on(&mut scheduled);
    scheduled
}

/// A schedule that may be dropped: [`hand_on`] has yet to find what its stages hand to later ones.
pub(crate) fn schedule_on_trial(
    graph: &Graph,
    program: &Program<Node>,
    hints: &[(Node, String)],
    style: Style,
) -> Program<Expression> {
    let roots_of = |stages: &[Stage<Node>]| -> Vec<Node> { stages.iter().flat_map(Stage::needs).collect() };
    let roots = roots_of(&program.stages);
    let reachable = graph.reachable(&roots);
    let mut lines = Lines::new(graph, &reachable, style);
    if let (true, Some((_, motion))) = (program.has_sensitivities, program.stages.split_last()) {
        // the motion comes first, so that later programs do not break up the expressions that it shares
        lines.extend(graph, &graph.reachable(&roots_of(motion)));
        share::share(&mut lines);
    }
    lines.extend(graph, &reachable);
    share::share(&mut lines);
    let mut operations = OperationList::default();
    for step in program.stages.iter().flat_map(|stage| &stage.steps) {
        operations.lower_step(&lines, step);
    }
    let hints = hints
        .iter()
        .filter(|(node, _)| reachable.binary_search(node).is_ok())
        .map(|(node, name)| (operations.lower(&lines, lines.of_node(*node)), name.clone()))
        .collect();
    let mut names = program.names.clone();
    let iterations = iterations(graph, program, &mut names, style.passes);
    let mut scheduler = Scheduler {
        operations,
        names,
        hints,
        usage: IndexTable::default(),
        bound: IndexTable::default(),
        program,
        style,
        stage: 0,
        steps: Vec::new(),
        cost: Cost::NONE,
        mode: Mode::Only,
        modes: BTreeMap::new(),
        iterations,
    };
    scheduler.survey(&lines);
    scheduler.write(&lines)
}

impl Scheduler<'_> {
    fn value(&mut self, lines: &Lines, node: Node) -> OperationId {
        self.operations.lower(lines, lines.of_node(node))
    }

    /// The first pass: counts the uses of each value.
    fn survey(&mut self, lines: &Lines) {
        let program = self.program;
        for (stage, steps) in program.stages.iter().enumerate() {
            for node in steps.needs() {
                let value = self.value(lines, node);
                self.touch(value, stage);
            }
        }
    }

    fn usage(&self, value: OperationId) -> Usage {
        self.usage.get(value).unwrap_or_default()
    }

    fn touch(&mut self, value: OperationId, stage: usize) {
        let mut usage = self.usage(value);
        usage.count += 1;
        usage.last_stage = usage.last_stage.max(stage);
        self.usage.insert(value, usage);
        if usage.count > 1 {
            return;
        }
        let changes = stage == 0 && self.operations.is_changing(value);
        for index in 0..self.operations.operation(value).operands().len() {
            let operand = self.operations.operation(value).operands()[index];
            self.touch(operand, stage);
            let mut usage = self.usage(operand);
            usage.is_prepared |=
                changes && !self.operations.is_changing(operand) && self.operations.takes_long(operand);
            self.usage.insert(operand, usage);
        }
    }

    fn includes(&self, pass: Pass) -> bool {
        self.style.passes.include(pass)
    }

    /// The symbol of a value that has been computed.
    fn known(&self, value: OperationId) -> Option<Symbol> {
        let symbol = self.bound.get(value);
        symbol.filter(|_| self.includes(Pass::CommonSubexpressions))
    }

    fn is_circular(&self, value: OperationId) -> bool {
        matches!(self.operations.operation(value), Operation::Call(function, _) if function.partner().is_some())
    }

    /// The cosine of the angle of a sine, or the sine of the angle of a cosine, if the program contains it.
    fn partner(&self, value: OperationId) -> Option<OperationId> {
        let Operation::Call(function, arguments) = self.operations.operation(value) else {
            return None;
        };
        let other = function.partner()?;
        let partner = self.operations.find(&Operation::Call(other, arguments.clone()))?;
        (self.usage(partner).count > 0 && self.includes(Pass::SineCosinePairs)).then_some(partner)
    }

    /// The second pass: writes the steps.
    fn write(mut self, lines: &Lines) -> Program<Expression> {
        let program = self.program;
        let mut stages = Vec::new();
        for (index, stage) in program.stages.iter().enumerate() {
            self.stage = index;
            if !self.includes(Pass::Carrying) {
                self.bound.clear();
            }
            for step in &stage.steps {
                self.step(lines, step);
            }
            stages.push(Stage {
                cost: std::mem::replace(&mut self.cost, Cost::NONE),
                ..Stage::new(std::mem::take(&mut self.steps))
            });
        }
        Program {
            stages,
            names: self.names,
            directions: program.directions.clone(),
            has_sensitivities: program.has_sensitivities,
        }
    }

    fn step(&mut self, lines: &Lines, step: &Step<Node>) {
        let written = match step {
            Step::Define { symbol, value } => {
                let value = self.value(lines, *value);
                let expression = self.root(value);
                if !matches!(expression, Expression::Name(_) | Expression::Number(_) | Expression::Pi) {
                    self.bound.insert(value, *symbol);
                }
                Step::Define {
                    symbol: *symbol,
                    value: expression,
                }
            }
            Step::Newton { part, .. } => {
                let Iteration { step, cost } = self.iterations[part].clone();
                self.charge(cost);
                step
            }
            _ => {
                let written = step.map(&mut |&node| {
                    let value = self.value(lines, node);
                    self.expression(value)
                });
                self.finished(lines, step, written)
            }
        };
        self.steps.push(written);
    }

    /// Completes a step whose expressions are written: adds its cost and the facts that its parts need.
    fn finished(&mut self, lines: &Lines, step: &Step<Node>, mut written: Step<Expression>) -> Step<Expression> {
        match &mut written {
            Step::Solve { solver, results, .. } => {
                for symbol in results.iter().flatten() {
                    if let Symbol::Unknown(unknown) = *symbol {
                        self.modes.insert(unknown, self.mode);
                    }
                }
                for result in results {
                    *result = result.filter(|&symbol| self.is_used(symbol));
                }
                self.charge_solver(*solver);
            }
            Step::Angle { length, .. } => {
                let Step::Angle {
                    length: Some(known), ..
                } = step
                else {
                    return written;
                };
                let known = self.value(lines, *known);
                let is_positive = matches!(
                    self.operations.operation(known),
                    Operation::Number(number) if number.get() > 0.0
                );
                if is_positive {
                    *length = None;
                }
                // an unknown length is negative in one of its two assemblies, and the vector is reversed there
                if let Operation::Leaf(Symbol::Unknown(unknown)) = self.operations.operation(known)
                    && self.modes.get(unknown) != Some(&(Mode::Fixed { is_open: true }))
                {
                    self.cost.negations += 2;
                }
                self.charge(Cost::ARC_TANGENT);
            }
            Step::Bound { wraps: true, .. } => self.cost.additions += 1,
            Step::Open { mode, .. } => self.mode = *mode,
            Step::Close { .. } => self.mode = Mode::Only,
            Step::Factor { symbol, matrix } if *symbol != RESIDUALS => self.charge(Cost::of_factors(matrix.len())),
            Step::Substitute { right, .. } => self.charge(Cost::of_substitution(right.len())),
            _ => {}
        }
        written
    }

    /// Adds to the cost. A block whose range is checked at run time solves for both candidates.
    fn charge(&mut self, cost: Cost) {
        let times = if matches!(self.mode, Mode::Ranged) { 2 } else { 1 };
        for _ in 0..times {
            self.cost = self.cost + cost;
        }
    }

    fn charge_solver(&mut self, solver: Solver) {
        let cost = match self.mode {
            Mode::Fixed { is_open } => solver.cost(is_open),
            Mode::Ranged => {
                self.cost = self.cost + solver.cost(true) + solver.cost(false);
                return;
            }
            Mode::Assembly(_) | Mode::Only => solver.dearest(),
        };
        self.cost = self.cost + cost;
    }

    /// Whether a result of a closed form is used. A position uses all unknowns.
    fn is_used(&mut self, symbol: Symbol) -> bool {
        let leaf = self.operations.leaf(symbol);
        matches!(symbol, Symbol::Unknown(_)) || self.usage(leaf).count > 0
    }

    /// The expression for a value that a `let` is about to name.
    fn root(&mut self, value: OperationId) -> Expression {
        if self.must_be_separate(value) {
            self.expression(value)
        } else {
            self.unfold(value)
        }
    }

    /// Whether a call cannot be part of an expression, because it has a partner or a check.
    fn must_be_separate(&self, value: OperationId) -> bool {
        self.known(value).is_some() || self.is_circular(value) || self.guard(value).is_some()
    }

    /// The check that a call needs.
    fn guard(&self, value: OperationId) -> Option<&'static Checked> {
        match self.operations.operation(value) {
            Operation::Call(function, _) if self.style.check_domains && self.stage == 0 => function.guard(),
            _ => None,
        }
    }

    /// The name of a value if it has or needs one, otherwise its expression.
    fn expression(&mut self, value: OperationId) -> Expression {
        work::iteration();
        if let Some(symbol) = self.known(value) {
            return Expression::Name(symbol);
        }
        if self.is_circular(value) {
            return Expression::Name(self.bind_circular(value));
        }
        if let Some(guard) = self.guard(value) {
            let argument = self.expression(self.operations.operation(value).operands()[0]);
            let symbol = self.bind(value);
            self.charge(self.operations.operation(value).cost());
            self.steps.push(Step::Check {
                symbol,
                guard,
                argument,
            });
            return Expression::Name(symbol);
        }
        match self.operations.operation(value) {
            Operation::Number(_) | Operation::Pi | Operation::Leaf(_) => return self.unfold(value),
            _ => {}
        }
        let usage = self.usage(value);
        let is_shared = usage.count > 1 && self.includes(Pass::CommonSubexpressions);
        if is_shared || usage.last_stage > self.stage || usage.is_prepared || self.is_long(value) {
            let expression = self.unfold(value);
            let symbol = self.bind(value);
            self.steps.push(Step::Define {
                symbol,
                value: expression,
            });
            return Expression::Name(symbol);
        }
        self.unfold(value)
    }

    /// Whether the expression of a value takes more operations than are readable.
    fn is_long(&self, value: OperationId) -> bool {
        let mut operations = 0;
        let mut pending = vec![value];
        while let Some(value) = pending.pop() {
            if self.bound.get(value).is_some() {
                continue;
            }
            match self.operations.operation(value) {
                Operation::Number(_) | Operation::Pi | Operation::Leaf(_) => {}
                operation => {
                    operations += 1;
                    if operations > READABLE {
                        return true;
                    }
                    pending.extend(
                        operation
                            .operands()
                            .iter()
                            .copied()
                            .filter(|&operand| self.usage(operand).count <= 1),
                    );
                }
            }
        }
        false
    }

    fn unfold(&mut self, value: OperationId) -> Expression {
        let operation = self.operations.operation(value).clone();
        self.charge(operation.cost());
        let mut part = |operand: OperationId| Box::new(self.expression(operand));
        match operation {
            Operation::Number(number) => Expression::Number(number.get()),
            Operation::Pi => Expression::Pi,
            Operation::Leaf(symbol) => Expression::Name(symbol),
            Operation::Add([a, b]) => Expression::Add(part(a), part(b)),
            Operation::Subtract([a, b]) => Expression::Subtract(part(a), part(b)),
            Operation::Multiply([a, b]) => Expression::Multiply(part(a), part(b)),
            Operation::Divide([a, b]) => Expression::Divide(part(a), part(b)),
            Operation::Negate([a]) => Expression::Negate(part(a)),
            Operation::Call(function, arguments) => Expression::Call(
                function,
                arguments
                    .into_iter()
                    .map(|argument| self.expression(argument))
                    .collect(),
            ),
        }
    }

    /// Names a sine or cosine together with its partner.
    fn bind_circular(&mut self, value: OperationId) -> Symbol {
        let Operation::Call(_, arguments) = self.operations.operation(value).clone() else {
            unreachable!("sines and cosines are calls");
        };
        let angle = self.expression(arguments[0]);
        let partner = self.partner(value);
        let symbol = self.bind(value);
        let other = partner.map(|partner| self.bind(partner));
        let is_sine = matches!(self.operations.operation(value), Operation::Call(Function::Sin, _));
        let (sine, cosine) = if is_sine {
            (Some(symbol), other)
        } else {
            (other, Some(symbol))
        };
        self.charge(Cost::SINE_COSINE);
        self.steps.push(Step::SineCosine { sine, cosine, angle });
        symbol
    }
}
