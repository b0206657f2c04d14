//! Steps to statements.

use super::{Argument, Extent, Label, Range, Selection, Statement, Value, doubt};
use crate::algebra::Symbol;
use crate::model::{Dimension, Model};
use crate::program::{Expression, FormArgument, Mode, Solver, Solvers, Stage, Step};
use crate::structure::{Block, Part};

type Scheduled = Step<Expression>;

/// A mechanism whose programs are lowered.
#[derive(Clone, Copy)]
pub(crate) struct Lowering<'a> {
    pub(crate) model: &'a Model,
    pub(crate) blocks: &'a [Block],
    pub(crate) solvers: &'a Solvers,
    /// Whether the steps go through all positions, and not to a single one.
    pub(crate) goes_through_all: bool,
    /// The steps of the position that are lowered.
    pub(crate) extent: Extent<'a>,
}

impl Lowering<'_> {
    /// A stage outside of blocks. Only its rates can fail.
    pub(crate) fn plain(&self, stage: &Stage<Expression>) -> Vec<Statement> {
        let steps: Vec<&Scheduled> = stage.steps.iter().collect();
        steps.iter().filter_map(|step| self.step(step, None, &steps)).collect()
    }

    /// The stage of the position, block by block.
    pub(crate) fn position(&self, stage: &Stage<Expression>) -> Vec<Statement> {
        let mut statements = Vec::new();
        let mut rest = stage.steps.as_slice();
        let mut outside: Vec<&Scheduled> = Vec::new();
        while let Some((first, after)) = rest.split_first() {
            let Step::Open { part, mode } = *first else {
                outside.push(first);
                if self.extent.includes(first) {
                    statements.extend(self.step(first, None, &outside));
                }
                rest = after;
                continue;
            };
            let end = after
                .iter()
                .position(|step| matches!(step, Step::Close { .. }))
                .unwrap_or(after.len());
            let (inside, after) = (&after[..end], &after[(end + 1).min(after.len())..]);
            if mode == Mode::Ranged && !matches!(self.extent, Extent::Prepared(_)) {
                self.candidates(part, inside, after, stage, &mut statements);
            } else {
                statements.extend(self.sequence(inside, part));
            }
            rest = after;
        }
        statements
    }

    /// The steps of a part, one after the other. Two directions in a row become one call.
    fn sequence<'s>(&self, steps: impl IntoIterator<Item = &'s Scheduled>, part: usize) -> Vec<Statement> {
        let steps: Vec<&Scheduled> = steps.into_iter().collect();
        let mut statements = Vec::new();
        let wanted = steps.iter().copied().filter(|step| self.extent.includes(step));
        let mut rest = wanted.peekable();
        while let Some(step) = rest.next() {
            let both = rest.peek().and_then(|next| directions(step, next));
            if both.is_some() {
                rest.next();
            }
            statements.extend(both.or_else(|| self.step(step, Some(part), &steps)));
        }
        statements
    }

    /// Both solutions of a part, and the choice between them by a declared range.
    fn candidates(
        &self,
        part: usize,
        inside: &[Scheduled],
        after: &[Scheduled],
        stage: &Stage<Expression>,
        statements: &mut Vec<Statement>,
    ) {
        let (bounds, inside): (Vec<&Scheduled>, Vec<&Scheduled>) =
            inside.iter().partition(|step| matches!(step, Step::Bound { .. }));
        let mut needed: Vec<Symbol> = after.iter().flat_map(Step::uses).collect();
        needed.extend(stage.carries.iter().map(|carried| carried.symbol));
        needed.extend((0..self.model.unknowns.len()).map(Symbol::Unknown));
        let mut kept: Vec<Symbol> = inside.iter().flat_map(|step| step.defines()).collect();
        kept.retain(|symbol| needed.contains(symbol));
        let ranges = self.part(part).unknowns.iter().filter_map(|&unknown| {
            let symbol_of_unknown = Symbol::Unknown(unknown);
            let is_periodic = inside
                .iter()
                .any(|step| matches!(step, Step::Angle { symbol, .. } if *symbol == symbol_of_unknown));
            kept.contains(&symbol_of_unknown)
                .then(|| self.range(unknown, is_periodic))
                .flatten()
        });
        statements.push(Statement::Candidates {
            ranges: ranges.collect(),
            body: self.sequence(inside.iter().copied(), part),
            kept,
            label: self.label(part),
        });
        statements.extend(bounds.iter().filter_map(|step| self.step(step, Some(part), &[])));
    }

    /// A step. `among` are the steps that may define the values that it reads.
    fn step(&self, step: &Scheduled, part: Option<usize>, among: &[&Scheduled]) -> Option<Statement> {
        let of_part = || part.expect("the step stands in a part of a block");
        Some(match step {
            Step::Define { symbol, value } => self.define(*symbol, Value::of(value)),
            Step::Check {
                symbol,
                guard,
                argument,
            } => Statement::Check {
                symbol: *symbol,
                function: guard.name,
                argument: if guard.decides_by_sign {
                    doubt::decisive(argument, among)
                } else {
                    Value::of(argument).into()
                },
                label: part.map_or(Label::Outputs, |part| self.label(part)),
            },
            Step::SineCosine { sine, cosine, angle } => Statement::SineCosine {
                sine: *sine,
                cosine: *cosine,
                angle: Value::of(angle),
            },
            Step::Solve {
                solver,
                arguments,
                results,
            } => {
                let arguments = arguments.iter().enumerate();
                Statement::Solve {
                    form: solver.name(),
                    arguments: arguments
                        .map(|(index, of)| argument(*solver, index, of, among))
                        .collect(),
                    selection: solver.takes_assembly().then(|| self.selection(of_part())),
                    returns: solver.returns(),
                    results: results.clone(),
                    label: self.label(of_part()),
                }
            }
            Step::Angle { symbol, y, x, length } => Statement::Angles {
                symbols: vec![*symbol],
                y: vec![Value::of(y)],
                x: vec![Value::of(x)],
                lengths: length.iter().map(Value::of).collect(),
            },
            Step::Bound {
                unknown, is_periodic, ..
            } => {
                if let Some(range) = self.range(*unknown, *is_periodic) {
                    let label = self.label(of_part());
                    return Some(Statement::InRange { range, label });
                }
                return (*is_periodic && !self.goes_through_all).then_some(Statement::Unwrap { unknown: *unknown });
            }
            Step::Regular { value } => Statement::Regular {
                symbol: match value {
                    Expression::Name(symbol) => Some(*symbol),
                    _ => None,
                },
                value: doubt::decisive(value, among),
                label: self.singular(part),
            },
            Step::Newton {
                unknowns,
                body,
                residuals,
                jacobian,
                ..
            } => self.newton(of_part(), unknowns, body, residuals, jacobian),
            Step::Every {
                block,
                coefficients,
                results,
            } => {
                let all = self.blocks[*block].all.as_ref()?;
                Statement::Every {
                    block: *block,
                    form: all.form.clone(),
                    paths: all.paths,
                    coefficients: Value::all(coefficients),
                    results: results.clone(),
                    label: self.label(of_part()),
                }
            }
            Step::Factor { symbol, matrix } => Statement::Factor {
                symbol: *symbol,
                matrix: matrix.iter().map(|row| Value::all(row)).collect(),
                label: self.singular(part),
            },
            Step::Substitute {
                factors,
                right,
                results,
            } => {
                let Expression::Name(factors) = factors else {
                    unreachable!("factors have a name");
                };
                Statement::Substitute {
                    factors: *factors,
                    right: Value::all(right),
                    results: results.clone(),
                }
            }
            Step::Open { .. } | Step::Close { .. } => return None,
        })
    }

    /// An output is tested for being finite, and so is an unknown that was found without a closed form.
    fn define(&self, symbol: Symbol, value: Value) -> Statement {
        let label = match symbol {
            Symbol::Unknown(index) => Some(Label::Unknowns(vec![index])),
            Symbol::OutputRate(part, 0) => {
                let mut end = 0;
                let output = self.model.outputs.iter().position(|output| {
                    end += output.value.nodes().len();
                    part < end
                });
                output.map(Label::Output)
            }
            _ => None,
        };
        match label {
            None => Statement::Assign { symbol, value },
            Some(label) => Statement::Finite { symbol, value, label },
        }
    }

    fn newton(
        &self,
        part: usize,
        unknowns: &[usize],
        body: &[Scheduled],
        residuals: &[Expression],
        jacobian: &[Vec<Expression>],
    ) -> Statement {
        let is_length = |unknown: &usize| self.model.unknowns[*unknown].dimension == Dimension::Length;
        let are_lengths: Vec<bool> = unknowns.iter().map(is_length).collect();
        let body: Vec<&Scheduled> = body.iter().collect();
        Statement::Newton {
            unknowns: unknowns.to_vec(),
            lengths: if are_lengths.contains(&true) {
                self.lengths()
            } else {
                Vec::new()
            },
            are_lengths,
            residuals: Value::all(residuals),
            jacobian: jacobian.iter().map(|row| Value::all(row)).collect(),
            label: self.label(part),
            body: body
                .iter()
                .filter_map(|step| self.step(step, Some(part), &body))
                .collect(),
        }
    }

    /// The parameters and inputs that are lengths. A part of a vector is one.
    fn lengths(&self) -> Vec<Symbol> {
        let parameters = self.model.parameters.iter().flat_map(|parameter| {
            let axes = parameter.dimension.shape().axes().len();
            let is_length = axes > 0 || parameter.dimension == Dimension::Length;
            std::iter::repeat_n(is_length, axes.max(1))
        });
        let parameters = parameters.enumerate().map(|(index, is)| (Symbol::Parameter(index), is));
        let inputs = self.model.inputs.iter().enumerate();
        let inputs = inputs.map(|(index, input)| (Symbol::Input(index), input.dimension == Dimension::Length));
        let all = parameters.chain(inputs);
        all.filter(|(_, is_length)| *is_length)
            .map(|(symbol, _)| symbol)
            .collect()
    }

    /// The choice between a part's solutions.
    fn selection(&self, part: usize) -> Selection {
        match self.solvers.choices[part].mode {
            Mode::Fixed { is_open } => Selection::Fixed { is_open },
            Mode::Assembly(_) if self.goes_through_all => Selection::Next,
            Mode::Assembly(index) => Selection::Choice(index),
            Mode::Ranged | Mode::Only => Selection::Candidate,
        }
    }

    fn range(&self, unknown: usize, is_periodic: bool) -> Option<Range> {
        let range = self.model.unknowns[unknown].range.as_ref()?;
        Some(Range {
            unknown,
            is_periodic,
            low: range.low,
            high: range.high,
        })
    }

    fn part(&self, part: usize) -> &Part {
        let mut parts = self.blocks.iter().flat_map(|block| &block.parts);
        parts.nth(part).expect("parts are counted over all blocks")
    }

    /// The unknowns of a part.
    fn label(&self, part: usize) -> Label {
        Label::Unknowns(self.part(part).unknowns.clone())
    }

    /// A part's block is singular as a whole.
    fn singular(&self, part: Option<usize>) -> Label {
        let Some(part) = part else {
            return Label::Rates;
        };
        let mut before = 0;
        let block = self.blocks.iter().find(|block| {
            before += block.parts.len();
            part < before
        });
        block.map_or_else(|| self.label(part), |block| Label::Unknowns(block.unknowns.clone()))
    }
}

/// Two directions of the same kind, as one call.
fn directions(first: &Scheduled, second: &Scheduled) -> Option<Statement> {
    let (
        Step::Angle { symbol, y, x, length },
        Step::Angle {
            symbol: symbol_2,
            y: y_2,
            x: x_2,
            length: length_2,
        },
    ) = (first, second)
    else {
        return None;
    };
    (length.is_some() == length_2.is_some()).then(|| Statement::Angles {
        symbols: vec![*symbol, *symbol_2],
        y: vec![Value::of(y), Value::of(y_2)],
        x: vec![Value::of(x), Value::of(x_2)],
        lengths: length.iter().chain(length_2).map(Value::of).collect(),
    })
}

fn argument(solver: Solver, index: usize, of: &FormArgument<Expression>, among: &[&Scheduled]) -> Argument {
    match of {
        FormArgument::Scalar(value) if solver.decides_on(index) => Argument::Scalar(doubt::decisive(value, among)),
        FormArgument::Scalar(value) => Argument::Scalar(Value::of(value).into()),
        FormArgument::Plane(vector) => {
            let terms = if solver.decides_on(index) {
                doubt::terms_of_vector(vector, among)
            } else {
                Vec::new()
            };
            Argument::Plane(vector.each_ref().map(Value::of), terms)
        }
        FormArgument::Pair(pair) => Argument::Pair(pair.each_ref().map(Value::of)),
        FormArgument::Matrix(rows) => Argument::Matrix(rows.each_ref().map(|row| row.each_ref().map(Value::of))),
        FormArgument::Known(number) => Argument::Known(*number),
    }
}

impl From<Value> for super::Decisive {
    fn from(value: Value) -> Self {
        Self {
            value,
            terms: Vec::new(),
        }
    }
}
