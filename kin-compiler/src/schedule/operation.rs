//! Lines as binary operations.

use super::lines::{Line, LineId, Lines};
use crate::algebra::{FiniteNumber, Function, HashMap, Index, IndexTable, Symbol};
use crate::program::Cost;

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

/// All operations of a program.
#[derive(Default)]
pub(super) struct OperationList {
    pub(super) list: Vec<Operation>,
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
        self.list.push(operation.clone());
        self.known.insert(operation, value);
        value
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
                let mut product = None;
                for factor in factors {
                    let factor = self.lower(lines, factor);
                    product = Some(match product {
                        None => factor,
                        Some(before) => self.intern(Operation::Multiply([before, factor])),
                    });
                }
                product.expect("products have factors")
            }
            Line::Sum(terms) => {
                let (positive, negative): (Vec<_>, Vec<_>) = terms.into_iter().partition(|&(negative, _)| !negative);
                let mut sum = None;
                for (_, term) in positive {
                    let term = self.lower(lines, term);
                    sum = Some(match sum {
                        None => term,
                        Some(before) => self.intern(Operation::Add([before, term])),
                    });
                }
                let mut opposite = None;
                for (_, term) in negative {
                    let term = self.lower(lines, term);
                    match sum {
                        Some(before) => sum = Some(self.intern(Operation::Subtract([before, term]))),
                        None => {
                            opposite = Some(match opposite {
                                None => term,
                                Some(before) => self.intern(Operation::Add([before, term])),
                            });
                        }
                    }
                }
                match (sum, opposite) {
                    (Some(sum), _) => sum,
                    (None, Some(opposite)) => self.intern(Operation::Negate([opposite])),
                    (None, None) => unreachable!("sums have terms"),
                }
            }
        };
        self.by_line.insert(line, value);
        value
    }
}
