//! Lines as binary operations.
//!
//! The terms of a sum are combined in the order in which they are known: first those that depend on the parameters
//! alone, last the one that waits for the longest chain of operations. A processor then works on the first ones while
//! it waits. The factors of a product that depend on the parameters alone are multiplied first, so that a batch does it
//! once. The other factors keep their order: more of them in the order of time would take more registers.

use super::lines::{Line, LineId, Lines};
use crate::algebra::{FiniteNumber, Function, HashMap, Index, IndexTable, Node, Symbol};
use crate::program::{Cost, Step};

/// The index of an operation; operands have lower indices.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct OperationId(pub(super) usize);

impl Index for OperationId {
    fn index(self) -> usize {
        self.0
    }
}

#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) enum Operation {
    Number(FiniteNumber),
    Pi,
    Leaf(Symbol),
    Add([OperationId; 2]),
    Subtract([OperationId; 2]),
    Multiply([OperationId; 2]),
    Divide([OperationId; 2]),
    Negate([OperationId; 1]),
    Call(Function, Vec<OperationId>),
}

impl Operation {
    pub(super) fn operands(&self) -> &[OperationId] {
        match self {
            Self::Number(_) | Self::Pi | Self::Leaf(_) => &[],
            Self::Add(operands) | Self::Subtract(operands) | Self::Multiply(operands) | Self::Divide(operands) => {
                operands
            }
            Self::Negate(operand) => operand,
            Self::Call(_, arguments) => arguments,
        }
    }

    /// The cost of the operation. A sine and a cosine of one angle are counted where they are paired.
    pub(super) fn cost(&self) -> Cost {
        let mut cost = Cost::default();
        match self {
            Self::Number(_) | Self::Pi | Self::Leaf(_) => {}
            Self::Add(..) | Self::Subtract(..) => cost.additions = 1,
            Self::Multiply(..) => cost.multiplications = 1,
            Self::Divide(..) => cost.divisions = 1,
            Self::Negate(_) => cost.negations = 1,
            Self::Call(function, _) if function.partner().is_some() => {}
            Self::Call(function, _) => cost = Cost::of(function.cost()),
        }
        cost
    }
}

/// When a value is known, in typical cycles of a processor (A. Fog, "Instruction tables", Technical University of
/// Denmark). Numbers and parameters are known first.
type Time = u32;

/// The time at which inputs, their rates and guesses of unknowns are known.
const START: Time = 1 << 20;

/// The time of a step from its last argument on: a closed form, an arctangent or a linear system.
const STEP: Time = 60;

/// All operations of a program.
#[derive(Default)]
pub(super) struct OperationList {
    pub(super) list: Vec<Operation>,
    /// When the value of each operation is known.
    times: Vec<Time>,
    /// Whether a division, a function or a step takes part in the value of each operation.
    take_long: Vec<bool>,
    /// When the results of steps are known.
    symbols: HashMap<Symbol, Time>,
    known: HashMap<Operation, OperationId>,
    by_line: IndexTable<LineId, OperationId>,
}

impl OperationList {
    pub(super) fn operation(&self, value: OperationId) -> &Operation {
        &self.list[value.0]
    }

    fn intern(&mut self, operation: Operation) -> OperationId {
        if let Some(&value) = self.known.get(&operation) {
            return value;
        }
        let value = OperationId(self.list.len());
        self.times.push(self.time_of(&operation));
        let takes_long = match &operation {
            Operation::Divide(_) | Operation::Call(..) => true,
            Operation::Leaf(_) => self.times[value.0] > 0,
            _ => operation.operands().iter().any(|operand| self.take_long[operand.0]),
        };
        self.take_long.push(takes_long);
        self.list.push(operation.clone());
        self.known.insert(operation, value);
        value
    }

    /// When the value of an operation with known operands is known.
    fn time_of(&self, operation: &Operation) -> Time {
        let operands = operation.operands().iter().map(|operand| self.times[operand.0]);
        let last = operands.max().unwrap_or_default();
        last + match operation {
            Operation::Number(_) | Operation::Pi | Operation::Leaf(Symbol::Parameter(_)) => 0,
            Operation::Leaf(symbol) => self.symbols.get(symbol).copied().unwrap_or(START),
            Operation::Negate(_) => 1,
            Operation::Add(_) | Operation::Subtract(_) | Operation::Multiply(_) => 4,
            Operation::Divide(_) => 13,
            Operation::Call(..) => 40,
        }
    }

    /// Whether a division, a function or the result of a step takes part in a value.
    pub(super) fn takes_long(&self, value: OperationId) -> bool {
        self.take_long[value.0]
    }

    /// Whether a value depends on more than the parameters.
    pub(super) fn is_changing(&self, value: OperationId) -> bool {
        self.times[value.0] >= START
    }

    /// Lowers the expressions of a step, and notes when its results are known.
    pub(super) fn lower_step(&mut self, lines: &Lines, step: &Step<Node>) {
        let mut last = 0;
        for node in step.needs() {
            let value = self.lower(lines, lines.of_node(node));
            last = last.max(self.times[value.0]);
        }
        let takes = if matches!(step, Step::Define { .. }) { 0 } else { STEP };
        for symbol in step.defines() {
            self.symbols.insert(symbol, last + takes);
        }
    }

    /// The index of an operation, if the program contains it.
    pub(super) fn find(&self, operation: &Operation) -> Option<OperationId> {
        self.known.get(operation).copied()
    }

    pub(super) fn leaf(&mut self, symbol: Symbol) -> OperationId {
        self.intern(Operation::Leaf(symbol))
    }

    /// The operations of a line.
    pub(super) fn lower(&mut self, lines: &Lines, line: LineId) -> OperationId {
        if let Some(value) = self.by_line.get(line) {
            return value;
        }
        let value = match lines.line(line).clone() {
            Line::Number(number) => self.intern(Operation::Number(number)),
            Line::Pi => self.intern(Operation::Pi),
            Line::Leaf(symbol) => self.intern(Operation::Leaf(symbol)),
            Line::Quotient(above, below) => {
                let (above, below) = (self.lower(lines, above), self.lower(lines, below));
                self.intern(Operation::Divide([above, below]))
            }
            Line::Call(function, arguments) => {
                let arguments = arguments
                    .into_iter()
                    .map(|argument| self.lower(lines, argument))
                    .collect();
                self.intern(Operation::Call(function, arguments))
            }
            Line::Product(factors) => {
                let mut factors: Vec<_> = factors.into_iter().map(|factor| self.lower(lines, factor)).collect();
                factors.sort_by_key(|factor| self.is_changing(*factor));
                let mut product = None;
                for factor in factors {
                    product = Some(match product {
                        None => factor,
                        Some(before) => self.intern(Operation::Multiply([before, factor])),
                    });
                }
                product.expect("products have factors")
            }
            Line::Sum(terms) => {
                let mut terms: Vec<_> = terms
                    .into_iter()
                    .map(|(is_negative, term)| (is_negative, self.lower(lines, term)))
                    .collect();
                terms.sort_by_key(|(_, term)| self.times[term.0]);
                // a positive term is first, if there is one: a sum of negative terms takes a change of sign
                let first = terms.iter().position(|(is_negative, _)| !is_negative);
                terms[..=first.unwrap_or_default()].rotate_right(1);
                let is_opposite = first.is_none();
                let mut sum = None;
                for (is_negative, term) in terms {
                    sum = Some(match sum {
                        None => term,
                        Some(before) if is_negative == is_opposite => self.intern(Operation::Add([before, term])),
                        Some(before) => self.intern(Operation::Subtract([before, term])),
                    });
                }
                let sum = sum.expect("sums have terms");
                if is_opposite {
                    self.intern(Operation::Negate([sum]))
                } else {
                    sum
                }
            }
        };
        self.by_line.insert(line, value);
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::Graph;
    use crate::passes::Passes;
    use crate::schedule::style::Style;

    /// The terms of a sum from the first to the last, and whether they are subtracted.
    fn terms(operations: &OperationList, sum: OperationId) -> Vec<(bool, OperationId)> {
        let (rest, is_negative, last) = match *operations.operation(sum) {
            Operation::Add([rest, last]) => (rest, false, last),
            Operation::Subtract([rest, last]) => (rest, true, last),
            _ => return vec![(false, sum)],
        };
        let mut all = terms(operations, rest);
        all.push((is_negative, last));
        all
    }

    #[test]
    fn in_the_order_in_which_they_are_known() {
        let mut lines = Lines::new(&Graph::default(), &[], Style::plain(Passes::ALL));
        let symbols = [
            Symbol::UnknownRate(0, 1),
            Symbol::InputRate(0, 1),
            Symbol::Unknown(0),
            Symbol::Parameter(0),
        ];
        let [rate, input, unknown, parameter] = symbols.map(|symbol| lines.intern(Line::Leaf(symbol)));
        let product = lines.intern(Line::Product(vec![rate, unknown, parameter]));
        let all = [
            (false, product),
            (true, parameter),
            (false, rate),
            (true, input),
            (false, unknown),
        ];
        let sum = lines.intern(Line::Sum(all.to_vec()));
        let negative = lines.intern(Line::Sum(vec![(true, rate), (true, input)]));

        let mut operations = OperationList::default();
        operations
            .symbols
            .extend([(symbols[2], START + 60), (symbols[0], START + 100)]);
        let sum = operations.lower(&lines, sum);
        let lowered = |operations: &mut OperationList, line| operations.lower(&lines, line);
        let [product, rate, input, unknown, parameter] =
            [product, rate, input, unknown, parameter].map(|line| lowered(&mut operations, line));
        // a positive term is the first one
        let expected = [
            (false, unknown),
            (true, parameter),
            (true, input),
            (false, rate),
            (false, product),
        ];
        assert_eq!(terms(&operations, sum), expected);
        let Operation::Multiply([before, last]) = *operations.operation(product) else {
            panic!("it is a product");
        };
        assert_eq!(last, unknown);
        assert_eq!(*operations.operation(before), Operation::Multiply([parameter, rate]));
        let negative = operations.lower(&lines, negative);
        let Operation::Negate([opposite]) = *operations.operation(negative) else {
            panic!("both are subtracted");
        };
        assert_eq!(*operations.operation(opposite), Operation::Add([input, rate]));
    }
}
