//! Names for values, so that readers of the generated code recognise them.

use super::operation::{Operation, OperationId};
use super::scheduler::Scheduler;
use crate::algebra::Symbol;

/// The length of the longest name.
const NAME_LENGTH: usize = 36;

impl Scheduler<'_> {
    /// Gives a value a name.
    pub(super) fn bind(&mut self, value: OperationId) -> Symbol {
        let wish = self.hints.get(&value).cloned().unwrap_or_else(|| self.describe(value));
        let symbol = self.names.value(&wish);
        self.bound.insert(value, symbol);
        symbol
    }

    /// A name that describes the value if that is short, otherwise its kind.
    fn describe(&self, value: OperationId) -> String {
        self.phrase(value).unwrap_or_else(|| {
            let kind = match self.operations.operation(value) {
                Operation::Add(..) => "sum",
                Operation::Subtract(..) => "difference",
                Operation::Multiply(..) => "product",
                Operation::Divide(..) => "quotient",
                Operation::Negate(_) => "opposite",
                _ => "value",
            };
            kind.to_owned()
        })
    }

    /// A description of a value by the names of its operands.
    fn phrase(&self, value: OperationId) -> Option<String> {
        let phrase = match *self.operations.operation(value) {
            Operation::Leaf(symbol) => return Some(self.names.of(symbol).to_owned()),
            Operation::Number(number) => {
                let number = number.get();
                return (number.fract() == 0.0 && (0.0..100.0).contains(&number)).then(|| format!("{number}"));
            }
            Operation::Pi => "pi".to_owned(),
            Operation::Call(function, ref arguments) => {
                let argument = self.part(arguments[0]).unwrap_or_else(|| "angle".to_owned());
                format!("{}_{argument}", function.name())
            }
            Operation::Multiply([a, b]) if a == b => format!("{}_squared", self.part(a)?),
            Operation::Multiply([a, b]) => {
                let (a, b) = (self.part(a)?, self.part(b)?);
                if b == format!("{a}_squared") {
                    format!("{a}_cubed")
                } else {
                    format!("{a}_{b}")
                }
            }
            Operation::Divide([a, b]) => {
                let divisor = self.hints.get(&b).cloned().or_else(|| self.part(b))?;
                match self.part(a)? {
                    one if one == "1" => format!("inverse_{divisor}"),
                    dividend => format!("{dividend}_per_{divisor}"),
                }
            }
            Operation::Add([a, b]) => format!("{}_plus_{}", self.part(a)?, self.part(b)?),
            Operation::Subtract([a, b]) => format!("{}_minus_{}", self.part(a)?, self.part(b)?),
            Operation::Negate([a]) => format!("minus_{}", self.part(a)?),
        };
        // a name must not begin with a digit
        let is_name = !phrase.starts_with(|first: char| first.is_ascii_digit());
        (is_name && phrase.len() <= NAME_LENGTH).then_some(phrase)
    }

    /// The name of a value, or its description if it has no name.
    fn part(&self, value: OperationId) -> Option<String> {
        match self.bound.get(value) {
            Some(symbol) => Some(self.names.of(symbol).to_owned()),
            None => self.phrase(value),
        }
    }
}
