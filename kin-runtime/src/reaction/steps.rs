//! The steps of a computation that is noted.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

/// Functions of one number and of two.
pub(super) type Call = fn(f64) -> f64;
pub(super) type CallOfTwo = fn(f64, f64) -> f64;

/// A step, whose operands are the numbers of other steps; in a program, those of registers.
#[derive(Clone, Copy, Debug)]
pub(super) enum Step {
    /// A number of a column.
    Given(u32),
    Constant(f64),
    Sum([u32; 2]),
    Difference([u32; 2]),
    Product([u32; 2]),
    Quotient([u32; 2]),
    Opposite(u32),
    SquareRoot(u32),
    Size(u32),
    Larger([u32; 2]),
    Call(Call, u32),
    CallOfTwo(CallOfTwo, [u32; 2]),
    /// Poses are lost where it is decided otherwise whether a number is larger than a part of another one.
    Exceeds([u32; 2], f64, bool),
    /// Poses are lost where a number has another sign.
    Sign(u32, bool),
}

impl Step {
    /// Its operands, and how many there are.
    pub(super) fn operands(self) -> ([u32; 2], usize) {
        match self {
            Self::Given(_) | Self::Constant(_) => ([0; 2], 0),
            Self::Opposite(one) | Self::SquareRoot(one) | Self::Size(one) | Self::Call(_, one) | Self::Sign(one, _) => {
                ([one; 2], 1)
            }
            Self::Sum(both)
            | Self::Difference(both)
            | Self::Product(both)
            | Self::Quotient(both)
            | Self::Larger(both)
            | Self::CallOfTwo(_, both)
            | Self::Exceeds(both, ..) => (both, 2),
        }
    }

    /// The same with other operands.
    pub(super) fn with(self, [one, other]: [u32; 2]) -> Self {
        let both = [one, other];
        match self {
            Self::Given(_) | Self::Constant(_) => self,
            Self::Opposite(_) => Self::Opposite(one),
            Self::SquareRoot(_) => Self::SquareRoot(one),
            Self::Size(_) => Self::Size(one),
            Self::Call(call, _) => Self::Call(call, one),
            Self::Sign(_, is_negative) => Self::Sign(one, is_negative),
            Self::Sum(_) => Self::Sum(both),
            Self::Difference(_) => Self::Difference(both),
            Self::Product(_) => Self::Product(both),
            Self::Quotient(_) => Self::Quotient(both),
            Self::Larger(_) => Self::Larger(both),
            Self::CallOfTwo(call, _) => Self::CallOfTwo(call, both),
            Self::Exceeds(_, part, exceeds) => Self::Exceeds(both, part, exceeds),
        }
    }

    /// By what it is known that an equal step is there already; none if it is never looked for.
    pub(super) fn key(self) -> Option<(u8, u64, u32)> {
        let both = |kind: u8, [one, other]: [u32; 2]| Some((kind, u64::from(one), other));
        match self {
            Self::Given(column) => both(0, [column, 0]),
            Self::Constant(value) => Some((1, value.to_bits(), 0)),
            Self::Sum(operands) => both(2, operands),
            Self::Difference(operands) => both(3, operands),
            Self::Product(operands) => both(4, operands),
            Self::Quotient(operands) => both(5, operands),
            Self::Opposite(one) => both(6, [one, 0]),
            Self::SquareRoot(one) => both(7, [one, 0]),
            Self::Size(one) => both(8, [one, 0]),
            Self::Larger(operands) => both(9, operands),
            _ => None,
        }
    }

    /// Whether it is done for its own sake.
    pub(super) fn is_guard(self) -> bool {
        matches!(self, Self::Exceeds(..) | Self::Sign(..))
    }
}

/// All steps since the trace began.
#[derive(Default)]
pub(super) struct Trace {
    pub(super) steps: Vec<Step>,
    known: BTreeMap<(u8, u64, u32), u32>,
}

impl Trace {
    pub(super) const EMPTY: Self = Self {
        steps: Vec::new(),
        known: BTreeMap::new(),
    };

    pub(super) fn add(&mut self, step: Step) -> u32 {
        let Some(key) = step.key() else {
            return self.push(step);
        };
        if let Some(known) = self.known.get(&key) {
            return *known;
        }
        let node = self.push(step);
        self.known.insert(key, node);
        node
    }

    pub(super) fn push(&mut self, step: Step) -> u32 {
        self.steps.push(step);
        // a program of 2³² steps would fill the memory long before
        u32::try_from(self.steps.len() - 1).unwrap_or(u32::MAX)
    }
}
