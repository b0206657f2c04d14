//! Rows as binary operations.

use std::collections::BTreeMap;

use super::rows::{Row, RowId, Rows};
use crate::algebra::{Function, HashMap, Number, Symbol};
use crate::program::Cost;

/// An operation's number; operands have lower ones.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct Value(pub(super) usize);

#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) enum Operation {
    Number(Number),
    Pi,
    Leaf(Symbol),
    Add(Value, Value),
    Subtract(Value, Value),
    Multiply(Value, Value),
    Divide(Value, Value),
    Negate(Value),
    Call(Function, Vec<Value>),
}

impl Operation {
    pub(super) fn operands(&self) -> Vec<Value> {
        match self {
            Self::Number(_) | Self::Pi | Self::Leaf(_) => Vec::new(),
            Self::Add(a, b) | Self::Subtract(a, b) | Self::Multiply(a, b) | Self::Divide(a, b) => vec![*a, *b],
            Self::Negate(a) => vec![*a],
            Self::Call(_, arguments) => arguments.clone(),
        }
    }

    /// Its cost; a sine and a cosine of one angle are counted where they are paired.
    pub(super) fn cost(&self) -> Cost {
        let mut cost = Cost::default();
        match self {
            Self::Number(_) | Self::Pi | Self::Leaf(_) => {}
            Self::Add(..) | Self::Subtract(..) => cost.additions = 1,
            Self::Multiply(..) => cost.multiplications = 1,
            Self::Divide(..) => cost.divisions = 1,
            Self::Negate(_) => cost.negations = 1,
            Self::Call(Function::Sin | Function::Cos, _) => {}
            Self::Call(Function::Sqrt, _) => cost.square_roots = 1,
            Self::Call(Function::Atan | Function::Atan2, _) => cost.arc_tangents = 1,
            Self::Call(..) => cost.others = 1,
        }
        cost
    }
}

/// All operations of a program.
#[derive(Default)]
pub(super) struct Operations {
    pub(super) list: Vec<Operation>,
    known: HashMap<Operation, Value>,
    by_row: BTreeMap<RowId, Value>,
}

impl Operations {
    pub(super) fn operation(&self, value: Value) -> &Operation {
        &self.list[value.0]
    }

    fn intern(&mut self, operation: Operation) -> Value {
        if let Some(&value) = self.known.get(&operation) {
            return value;
        }
        let value = Value(self.list.len());
        self.list.push(operation.clone());
        self.known.insert(operation, value);
        value
    }

    /// The number of an operation, if the program has it.
    pub(super) fn find(&self, operation: &Operation) -> Option<Value> {
        self.known.get(operation).copied()
    }

    pub(super) fn leaf(&mut self, symbol: Symbol) -> Value {
        self.intern(Operation::Leaf(symbol))
    }

    /// The operations of a row.
    pub(super) fn lower(&mut self, rows: &Rows, row: RowId) -> Value {
        if let Some(&value) = self.by_row.get(&row) {
            return value;
        }
        let value = match rows.row(row).clone() {
            Row::Number(number) => self.intern(Operation::Number(number)),
            Row::Pi => self.intern(Operation::Pi),
            Row::Leaf(symbol) => self.intern(Operation::Leaf(symbol)),
            Row::Quotient(above, below) => {
                let (above, below) = (self.lower(rows, above), self.lower(rows, below));
                self.intern(Operation::Divide(above, below))
            }
            Row::Call(function, arguments) => {
                let arguments = arguments
                    .into_iter()
                    .map(|argument| self.lower(rows, argument))
                    .collect();
                self.intern(Operation::Call(function, arguments))
            }
            Row::Product(factors) => {
                let mut product = None;
                for factor in factors {
                    let factor = self.lower(rows, factor);
                    product = Some(match product {
                        None => factor,
                        Some(before) => self.intern(Operation::Multiply(before, factor)),
                    });
                }
                product.expect("products have factors")
            }
            Row::Sum(terms) => {
                let (positive, negative): (Vec<_>, Vec<_>) = terms.into_iter().partition(|&(negative, _)| !negative);
                let mut sum = None;
                for (_, term) in positive {
                    let term = self.lower(rows, term);
                    sum = Some(match sum {
                        None => term,
                        Some(before) => self.intern(Operation::Add(before, term)),
                    });
                }
                let mut opposite = None;
                for (_, term) in negative {
                    let term = self.lower(rows, term);
                    match sum {
                        Some(before) => sum = Some(self.intern(Operation::Subtract(before, term))),
                        None => {
                            opposite = Some(match opposite {
                                None => term,
                                Some(before) => self.intern(Operation::Add(before, term)),
                            });
                        }
                    }
                }
                match (sum, opposite) {
                    (Some(sum), _) => sum,
                    (None, Some(opposite)) => self.intern(Operation::Negate(opposite)),
                    (None, None) => unreachable!("sums have terms"),
                }
            }
        };
        self.by_row.insert(row, value);
        value
    }
}
