//! Operations as statements: what gets a name, and in which stage it is computed.

use std::collections::{BTreeMap, BTreeSet};

use super::carry;
use super::operation::{Operation, Operations, Value};
use super::rows::Rows;
use super::share;
use super::statement::{Expression, Scheduled, ScheduledStage, Statement};
use crate::assemble::{Argument, Cost, Directions, Mode, Names, Program, Solver, Stage, Step};
use crate::expr::{Graph, Node, Symbol};
use crate::function::Function;
use crate::passes::{Pass, Passes};

/// Expressions with more operations than this are broken up.
const READABLE: usize = 10;

/// Where and how often a value is used.
#[derive(Clone, Copy, Default)]
struct Usage {
    count: usize,
    last_stage: usize,
}

/// The state of scheduling.
pub(super) struct Scheduler<'a> {
    pub(super) operations: Operations,
    pub(super) names: Names,
    pub(super) hints: BTreeMap<Value, String>,
    /// By value; none for what is not used.
    usage: Vec<Usage>,
    /// Values that have a name, and it.
    pub(super) bound: BTreeMap<Value, String>,
    program: &'a Program,
    style: Style,
    stage: usize,
    statements: Vec<Statement>,
    cost: Cost,
    /// How the block that is being written chooses between its solutions.
    mode: Mode,
    /// How the blocks that have been written did, by unknown.
    modes: BTreeMap<usize, Mode>,
    /// What an iteration of Newton's method does, by part.
    iterations: BTreeMap<usize, Iteration>,
}

/// One iteration of Newton's method.
#[derive(Clone)]
struct Iteration {
    statement: Statement,
    cost: Cost,
}

/// Schedules the iterations of Newton's method, each a program of its own.
fn iterations(graph: &Graph, program: &Program, passes: Passes) -> BTreeMap<usize, Iteration> {
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
        // the same rows, in one piece, as an argument of no solver at all
        let inner = Program {
            stages: vec![Stage {
                steps: vec![Step::Factor {
                    symbol: RESIDUALS,
                    matrix: [residuals.clone()]
                        .into_iter()
                        .chain(jacobian.iter().cloned())
                        .collect(),
                }],
            }],
            names: program.names.clone(),
            directions: Directions::default(),
            has_sensitivities: false,
        };
        let mut scheduled = schedule(
            graph,
            &inner,
            &[],
            Style {
                factors: Factors::Left,
                check_domains: false,
                passes,
            },
        );
        let ScheduledStage {
            mut statements, cost, ..
        } = scheduled.stages.swap_remove(0);
        let Some(Statement::Factor { matrix, .. }) = statements.pop() else {
            unreachable!("it is the last statement");
        };
        let mut matrix = matrix.into_iter();
        let residuals = matrix.next().unwrap_or_default();
        let cost = cost + Cost::of_factors(unknowns.len()) + Cost::of_substitution(unknowns.len());
        iterations.insert(
            *part,
            Iteration {
                statement: Statement::Newton {
                    unknowns: unknowns.clone(),
                    body: statements,
                    residuals,
                    jacobian: matrix.collect(),
                },
                cost,
            },
        );
    }
    iterations
}

/// Stands for the residuals and the Jacobian of an iteration while it is scheduled.
const RESIDUALS: Symbol = Symbol::Step(usize::MAX);

/// What becomes of factors that terms of a sum share.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Factors {
    /// They stay where they are.
    Left,
    /// They are taken out. Those of the position alone are multiplied by each other first, and not torn apart.
    TakenOut,
    /// The same, and what the position has computed in steps of its own is of the position.
    TakenOutOfRates,
}

/// What may be decided about a schedule.
#[derive(Clone, Copy)]
pub(crate) struct Style {
    pub(crate) factors: Factors,
    /// Whether functions that are not defined everywhere are checked, in the first stage.
    pub(crate) check_domains: bool,
    pub(crate) passes: Passes,
}

/// Schedules a program. `hints` are names for expressions that get one.
pub(crate) fn schedule(graph: &Graph, program: &Program, hints: &[(Node, String)], style: Style) -> Scheduled {
    let roots_of = |stages: &[Stage]| -> Vec<Node> {
        stages
            .iter()
            .flat_map(|stage| &stage.steps)
            .flat_map(Step::needs)
            .collect()
    };
    let roots = roots_of(&program.stages);
    let mut rows = Rows::new(graph, &roots, style);
    let reachable: BTreeSet<Node> = graph.reachable(&roots);
    if let (true, Some((_, motion))) = (program.has_sensitivities, program.stages.split_last()) {
        // the motion comes first: what it shares is not to be torn apart for what comes after it
        rows.extend(graph, &roots_of(motion));
        share::share(&mut rows);
    }
    rows.extend(graph, &roots);
    share::share(&mut rows);
    let mut operations = Operations::default();
    for &root in &roots {
        let row = rows.of_node(root);
        operations.lower(&rows, row);
    }
    let hints = hints
        .iter()
        .filter(|(node, _)| reachable.contains(node))
        .map(|(node, name)| (operations.lower(&rows, rows.of_node(*node)), name.clone()))
        .collect();
    let mut scheduler = Scheduler {
        operations,
        names: program.names.clone(),
        hints,
        usage: Vec::new(),
        bound: BTreeMap::new(),
        program,
        style,
        stage: 0,
        statements: Vec::new(),
        cost: Cost::default(),
        mode: Mode::Only,
        modes: BTreeMap::new(),
        iterations: iterations(graph, program, style.passes),
    };
    scheduler.survey(&rows);
    scheduler.write(&rows)
}

impl Scheduler<'_> {
    fn value(&mut self, rows: &Rows, node: Node) -> Value {
        self.operations.lower(rows, rows.of_node(node))
    }

    /// First pass: where each value is used.
    fn survey(&mut self, rows: &Rows) {
        let program = self.program;
        for (stage, steps) in program.stages.iter().enumerate() {
            for node in steps.steps.iter().flat_map(Step::needs) {
                let value = self.value(rows, node);
                self.touch(value, stage);
            }
        }
    }

    fn usage(&self, value: Value) -> Usage {
        self.usage.get(value.0).copied().unwrap_or_default()
    }

    fn touch(&mut self, value: Value, stage: usize) {
        if self.usage.len() <= value.0 {
            self.usage.resize(self.operations.list.len(), Usage::default());
        }
        let usage = &mut self.usage[value.0];
        usage.count += 1;
        usage.last_stage = usage.last_stage.max(stage);
        if usage.count > 1 {
            return;
        }
        for operand in self.operations.operation(value).operands() {
            self.touch(operand, stage);
        }
    }

    fn includes(&self, pass: Pass) -> bool {
        self.style.passes.include(pass)
    }

    /// The name of a value that has been computed.
    fn known(&self, value: Value) -> Option<&str> {
        let name = self.bound.get(&value).map(String::as_str);
        name.filter(|_| self.includes(Pass::CommonSubexpressions))
    }

    fn is_circular(&self, value: Value) -> bool {
        matches!(
            self.operations.operation(value),
            Operation::Call(Function::Sin | Function::Cos, _)
        )
    }

    /// The cosine to a sine and the sine to a cosine, if the program has it.
    fn partner(&self, value: Value) -> Option<Value> {
        let Operation::Call(function, arguments) = self.operations.operation(value) else {
            return None;
        };
        let other = if *function == Function::Sin {
            Function::Cos
        } else {
            Function::Sin
        };
        let partner = self.operations.find(&Operation::Call(other, arguments.clone()))?;
        (self.usage(partner).count > 0 && self.includes(Pass::SineCosinePairs)).then_some(partner)
    }

    /// Second pass: the statements.
    fn write(mut self, rows: &Rows) -> Scheduled {
        let program = self.program;
        let mut scheduled = Scheduled::default();
        for (stage, steps) in program.stages.iter().enumerate() {
            self.stage = stage;
            if !self.includes(Pass::Carrying) {
                self.bound.clear();
            }
            for step in &steps.steps {
                self.step(rows, step);
            }
            scheduled.stages.push(ScheduledStage {
                statements: std::mem::take(&mut self.statements),
                cost: std::mem::take(&mut self.cost),
                ..ScheduledStage::default()
            });
        }
        carry::hand_on(&mut scheduled, program);
        scheduled
    }

    fn step(&mut self, rows: &Rows, step: &Step) {
        match step {
            Step::Define { symbol, node } => {
                let value = self.value(rows, *node);
                let name = self.names.of(*symbol).to_owned();
                let expression = self.root(value);
                if !matches!(expression, Expression::Name(_) | Expression::Number(_) | Expression::Pi) {
                    self.bound.insert(value, name.clone());
                }
                self.statements.push(Statement::Let {
                    name,
                    value: expression,
                });
            }
            Step::Solve {
                solver,
                arguments,
                results,
            } => {
                let arguments = arguments
                    .iter()
                    .map(|argument: &Argument| {
                        let parts = self.arguments(rows, &argument.nodes());
                        (argument.shape(), parts)
                    })
                    .collect();
                for &symbol in results {
                    if let Symbol::Unknown(unknown) = symbol {
                        self.modes.insert(unknown, self.mode);
                    }
                }
                let results = results.iter().map(|&symbol| self.result_name(symbol)).collect();
                self.charge_solver(*solver);
                self.statements.push(Statement::Solve {
                    solver: *solver,
                    arguments,
                    results,
                });
            }
            Step::Angle { symbol, x, y, length } => {
                let [y, x, length] = [*y, *x, *length].map(|node| self.value(rows, node));
                let (y, x) = (self.argument(y), self.argument(x));
                let is_positive = matches!(
                    self.operations.operation(length),
                    Operation::Number(number) if number.get() > 0.0
                );
                // an unknown length is negative in one of its two assemblies, and the vector is turned round there
                if let Operation::Leaf(Symbol::Unknown(unknown)) = self.operations.operation(length)
                    && self.modes.get(unknown) != Some(&(Mode::Fixed { is_open: true }))
                {
                    self.cost.negations += 2;
                }
                let length = (!is_positive).then(|| self.argument(length));
                self.charge(Cost {
                    arc_tangents: 1,
                    ..Cost::default()
                });
                let name = self.names.of(*symbol).to_owned();
                self.statements.push(Statement::Angle { name, y, x, length });
            }
            Step::Bound { unknown, turns, wraps } => {
                if *wraps {
                    self.cost.additions += 1;
                }
                self.statements.push(Statement::Bound {
                    unknown: *unknown,
                    turns: *turns,
                });
            }
            Step::Open { part, mode } => {
                self.mode = *mode;
                self.statements.push(Statement::Open { part: *part });
            }
            Step::Newton { part, .. } => {
                let iteration = self.iterations[part].clone();
                self.charge(iteration.cost);
                self.statements.push(iteration.statement);
            }
            Step::Every {
                block,
                coefficients,
                results,
            } => {
                let coefficients = self.arguments(rows, coefficients);
                self.statements.push(Statement::Every {
                    block: *block,
                    coefficients,
                    results: results.iter().map(|&symbol| self.names.of(symbol).to_owned()).collect(),
                });
            }
            Step::Factor { symbol, matrix } => {
                let matrix: Vec<Vec<Expression>> = matrix.iter().map(|row| self.arguments(rows, row)).collect();
                if *symbol != RESIDUALS {
                    self.charge(Cost::of_factors(matrix.len()));
                }
                self.statements.push(Statement::Factor {
                    name: self.names.of(*symbol).to_owned(),
                    matrix,
                });
            }
            Step::Substitute {
                factors,
                right,
                results,
            } => {
                let right = self.arguments(rows, right);
                let factors = self.value(rows, *factors);
                let Operation::Leaf(symbol) = *self.operations.operation(factors) else {
                    unreachable!("factors are known by a symbol");
                };
                self.charge(Cost::of_substitution(right.len()));
                self.statements.push(Statement::Substitute {
                    factors: self.names.of(symbol).to_owned(),
                    right,
                    results: results.iter().map(|&symbol| self.names.of(symbol).to_owned()).collect(),
                });
            }
            Step::Regular { node } => {
                let value = self.value(rows, *node);
                let value = self.argument(value);
                self.statements.push(Statement::Regular { value });
            }
            Step::Close { part } => {
                self.mode = Mode::Only;
                self.statements.push(Statement::Close { part: *part });
            }
        }
    }

    /// Adds to the cost; a block whose range is looked up solves for both candidates.
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

    fn result_name(&mut self, symbol: Symbol) -> Option<String> {
        let leaf = self.operations.leaf(symbol);
        let is_used = matches!(symbol, Symbol::Unknown(_)) || self.usage(leaf).count > 0;
        is_used.then(|| self.names.of(symbol).to_owned())
    }

    /// The expression for a value that a `let` is about to name.
    fn root(&mut self, value: Value) -> Expression {
        if self.must_be_separate(value) {
            self.expression(value)
        } else {
            self.unfold(value)
        }
    }

    /// The expression for a value handed to a function.
    fn argument(&mut self, value: Value) -> Expression {
        self.expression(value)
    }

    /// The same for several.
    fn arguments(&mut self, rows: &Rows, nodes: &[Node]) -> Vec<Expression> {
        nodes
            .iter()
            .map(|&node| {
                let value = self.value(rows, node);
                self.argument(value)
            })
            .collect()
    }

    /// A function with a partner or a check cannot stand within an expression.
    fn must_be_separate(&self, value: Value) -> bool {
        self.known(value).is_some() || self.is_circular(value) || self.is_checked(value)
    }

    fn is_checked(&self, value: Value) -> bool {
        self.style.check_domains
            && self.stage == 0
            && matches!(
                self.operations.operation(value),
                Operation::Call(Function::Sqrt | Function::Asin | Function::Acos | Function::Ln, _)
            )
    }

    /// A value by its name if it has or deserves one, else written out.
    fn expression(&mut self, value: Value) -> Expression {
        if let Some(name) = self.known(value) {
            return Expression::Name(name.to_owned());
        }
        if self.is_circular(value) {
            return Expression::Name(self.bind_circular(value));
        }
        if self.is_checked(value) {
            let Operation::Call(function, arguments) = self.operations.operation(value).clone() else {
                unreachable!("only calls are checked");
            };
            let argument = self.expression(arguments[0]);
            let name = self.bind(value);
            self.charge(self.operations.operation(value).cost());
            self.statements.push(Statement::Checked {
                name: name.clone(),
                function,
                argument,
            });
            return Expression::Name(name);
        }
        match self.operations.operation(value) {
            Operation::Number(_) | Operation::Pi | Operation::Leaf(_) => return self.unfold(value),
            _ => {}
        }
        let usage = self.usage(value);
        let is_shared = usage.count > 1 && self.includes(Pass::CommonSubexpressions);
        if is_shared || usage.last_stage > self.stage || self.is_long(value) {
            let expression = self.unfold(value);
            let name = self.bind(value);
            self.statements.push(Statement::Let {
                name: name.clone(),
                value: expression,
            });
            return Expression::Name(name);
        }
        self.unfold(value)
    }

    /// Whether a value takes more operations than are readable, written out.
    fn is_long(&self, value: Value) -> bool {
        let mut operations = 0;
        let mut open = vec![value];
        while let Some(value) = open.pop() {
            if self.bound.contains_key(&value) {
                continue;
            }
            match self.operations.operation(value) {
                Operation::Number(_) | Operation::Pi | Operation::Leaf(_) => {}
                operation => {
                    operations += 1;
                    if operations > READABLE {
                        return true;
                    }
                    open.extend(
                        operation
                            .operands()
                            .into_iter()
                            .filter(|&operand| self.usage(operand).count <= 1),
                    );
                }
            }
        }
        false
    }

    fn unfold(&mut self, value: Value) -> Expression {
        let operation = self.operations.operation(value).clone();
        self.charge(operation.cost());
        let mut part = |operand: Value| Box::new(self.expression(operand));
        match operation {
            Operation::Number(number) => Expression::Number(number.get()),
            Operation::Pi => Expression::Pi,
            Operation::Leaf(symbol) => Expression::Name(self.names.of(symbol).to_owned()),
            Operation::Add(a, b) => Expression::Add(part(a), part(b)),
            Operation::Subtract(a, b) => Expression::Subtract(part(a), part(b)),
            Operation::Multiply(a, b) => Expression::Multiply(part(a), part(b)),
            Operation::Divide(a, b) => Expression::Divide(part(a), part(b)),
            Operation::Negate(a) => Expression::Negate(part(a)),
            Operation::Call(function, arguments) => Expression::Call(
                function,
                arguments
                    .into_iter()
                    .map(|argument| self.expression(argument))
                    .collect(),
            ),
        }
    }

    /// Names a sine or cosine, and its partner with it.
    fn bind_circular(&mut self, value: Value) -> String {
        let Operation::Call(_, arguments) = self.operations.operation(value).clone() else {
            unreachable!("sines and cosines are calls");
        };
        let argument = self.expression(arguments[0]);
        let partner = self.partner(value);
        let name = self.bind(value);
        let other = partner.map(|partner| self.bind(partner));
        let is_sine = matches!(self.operations.operation(value), Operation::Call(Function::Sin, _));
        let (sine, cosine) = if is_sine {
            (Some(name.clone()), other)
        } else {
            (other, Some(name.clone()))
        };
        self.charge(Cost {
            sine_cosines: 1,
            ..Cost::default()
        });
        self.statements.push(Statement::SinCos { sine, cosine, argument });
        name
    }
}
