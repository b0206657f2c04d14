//! A tape as text, to be read.

use core::fmt::{self, Display, Formatter};

use crate::tape::structure::Tape;
use crate::tape::{Comparison, Condition, Function, Operator, ResultOf, Role, TapeNode, TapeStep, Value};

/// Writes the arguments, the steps and the results, one on each line.
impl Display for Tape<'_> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        writeln!(formatter, "{} in {:?} precision", self.description.name, self.precision)?;
        for (index, node) in self.nodes.iter().enumerate() {
            let value = Value(u32::try_from(index).unwrap_or(u32::MAX));
            match node {
                TapeNode::Argument(argument) => {
                    let named = &self.arguments[*argument];
                    let order = match named.role {
                        Role::Input { order, .. } => order,
                        _ => 0,
                    };
                    writeln!(formatter, "{value} = argument {}{}", named.name, "'".repeat(order))?;
                }
                TapeNode::Constant(constant) => writeln!(formatter, "{value} = {constant:?}")?,
                TapeNode::Unknown { search, index } => {
                    writeln!(formatter, "{value} = unknown {index} of search {search}")?;
                }
                TapeNode::Root { search, index } => writeln!(formatter, "{value} = root {index} of search {search}")?,
                TapeNode::Solution { solution, index } => {
                    writeln!(formatter, "{value} = entry {index} of solution {solution}")?;
                }
                _ => {}
            }
        }
        for step in &self.steps {
            match *step {
                TapeStep::Compute(value) => self.line(formatter, "", value)?,
                TapeStep::Check(index) => {
                    let check = &self.checks[index];
                    write!(formatter, "check {} ({}): ", check.name, self.block_of(check))?;
                    match check.condition {
                        Condition::Holds(truth) => writeln!(formatter, "{truth}")?,
                        Condition::Found(search) => writeln!(formatter, "search {search} found a root")?,
                        Condition::Regular(system) => writeln!(formatter, "system {system} is regular")?,
                    }
                    for value in &check.cold {
                        self.line(formatter, "    ", *value)?;
                    }
                    if let Some(margin) = check.margin {
                        writeln!(formatter, "    margin {margin}")?;
                    }
                }
                TapeStep::Search(index) => {
                    let search = &self.searches[index];
                    writeln!(formatter, "search {index} from {}", List(&search.guess))?;
                    for value in &search.body {
                        self.line(formatter, "    ", *value)?;
                    }
                    writeln!(formatter, "    residuals {}", List(&search.residuals))?;
                    for row in &search.jacobian {
                        writeln!(formatter, "    jacobian {}", List(row))?;
                    }
                }
                TapeStep::Factor(index) => {
                    writeln!(formatter, "factor system {index}")?;
                    for row in &self.systems[index].rows {
                        writeln!(formatter, "    {}", List(row))?;
                    }
                }
                TapeStep::Solve(index) => {
                    let solution = &self.solutions[index];
                    let right = List(&solution.right);
                    writeln!(formatter, "solution {index} of system {} for {right}", solution.system)?;
                }
            }
        }
        for result in &self.results {
            let kind = match result.quantity {
                ResultOf::UnknownPartial { .. } | ResultOf::OutputPartial { .. } => "partial ",
                _ => "",
            };
            writeln!(
                formatter,
                "{kind}{}{} = {}",
                result.name,
                "'".repeat(result.order),
                result.value
            )?;
        }
        Ok(())
    }
}

impl Tape<'_> {
    fn line(&self, formatter: &mut Formatter<'_>, indent: &str, value: Value) -> fmt::Result {
        write!(formatter, "{indent}{value} = ")?;
        match self.nodes[value.index()] {
            TapeNode::Call(Function::Negate, one) => writeln!(formatter, "-{one}"),
            TapeNode::Call(function, one) => writeln!(formatter, "{function:?}({one})"),
            TapeNode::Binary(Operator::ArcTangent, y, x) => writeln!(formatter, "ArcTangent({y}, {x})"),
            TapeNode::Binary(operator, one, other) => {
                let sign = match operator {
                    Operator::Add => "+",
                    Operator::Subtract => "-",
                    Operator::Multiply => "*",
                    _ => "/",
                };
                writeln!(formatter, "{one} {sign} {other}")
            }
            TapeNode::PlusProduct(sum, one, other) => writeln!(formatter, "{sum} + {one} * {other}"),
            TapeNode::MinusProduct(sum, one, other) => writeln!(formatter, "{sum} - {one} * {other}"),
            TapeNode::Select(truth, one, other) => writeln!(formatter, "{truth} ? {one} : {other}"),
            TapeNode::Compare(comparison, one, other) => {
                let sign = match comparison {
                    Comparison::AtLeast => ">=",
                    Comparison::Exceeds => ">",
                    Comparison::Equals => "==",
                };
                writeln!(formatter, "{one} {sign} {other}")
            }
            TapeNode::IsFinite(one) => writeln!(formatter, "finite({one})"),
            TapeNode::Both(one, other) => writeln!(formatter, "{one} and {other}"),
            TapeNode::Either(one, other) => writeln!(formatter, "{one} or {other}"),
            TapeNode::Not(one) => writeln!(formatter, "not {one}"),
            node => writeln!(formatter, "{node:?}"),
        }
    }
}

/// Values separated by commas.
struct List<'a>(&'a [Value]);

impl Display for List<'_> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        for (index, value) in self.0.iter().enumerate() {
            write!(formatter, "{}{value}", if index == 0 { "" } else { ", " })?;
        }
        Ok(())
    }
}
