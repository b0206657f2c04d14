//! Names for values, so that a reader of the generated code recognises them.

use super::operation::{Operation, Value};
use super::scheduler::Scheduler;
use crate::algebra::Symbol;

/// Longer names are not made.
const NAME_LENGTH: usize = 36;

impl Scheduler<'_> {
    /// Gives a value a name.
    pub(super) fn bind(&mut self, value: Value) -> Symbol {
        let wish = self.hints.get(&value).cloned().unwrap_or_else(|| self.describe(value));
        let symbol = self.names.value(&wish);
        self.bound.insert(value, symbol);
        symbol
    }

    /// The name of a leaf or of a value that has one.
    fn short_name(&self, value: Value) -> Option<String> {
        match self.operations.operation(value) {
            Operation::Leaf(symbol) => Some(self.names.of(*symbol).to_owned()),
            _ => self.bound.get(&value).map(|&symbol| self.names.of(symbol).to_owned()),
        }
    }

    /// A name that says what a value is, or at least that it is one.
    fn describe(&self, value: Value) -> String {
        let described = match self.operations.operation(value) {
            Operation::Call(function, arguments) => {
                let argument = self.short_name(arguments[0]).unwrap_or_else(|| "angle".to_owned());
                Some(format!("{}_{argument}", function.name()))
            }
            Operation::Multiply(a, b) if a == b => self.short_name(*a).map(|name| format!("{name}_squared")),
            Operation::Multiply(a, b) => match (self.short_name(*a), self.short_name(*b)) {
                (Some(a), Some(b)) if b == format!("{a}_squared") => Some(format!("{a}_cubed")),
                (Some(a), Some(b)) => Some(format!("{a}_{b}")),
                _ => None,
            },
            Operation::Divide(one, divisor) if matches!(self.operations.operation(*one), Operation::Number(number) if number.get() == 1.0) =>
            {
                let divisor = self.hints.get(divisor).cloned().or_else(|| self.short_name(*divisor));
                divisor.map(|name| format!("inverse_{name}"))
            }
            _ => None,
        };
        described
            .filter(|name| name.len() <= NAME_LENGTH)
            .unwrap_or_else(|| "t".to_owned())
    }
}
